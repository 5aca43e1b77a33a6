"""Imports a download into a library: every model that can be, the others listed with reasons."""

from __future__ import annotations

import hashlib
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sdgen.catalog.records import Catalog, Category
from sdgen.engines.in_order import in_order
from sdgen.errors import (
    AssetError,
    InputError,
    SceneRejected,
    SdgenError,
    did_you_mean,
    os_error_in_words,
)
from sdgen.geometry import Array, vec3
from sdgen.importing.frame import stand
from sdgen.importing.layouts import Candidate, find_models
from sdgen.importing.licences import Terms, nearer, terms_of
from sdgen.importing.model import FURNITURE_OFF, SMALL_OFF, Budget, make_model, slug
from sdgen.importing.opened import Refused, opened_source
from sdgen.importing.packages import check_packages
from sdgen.importing.reading import read_model
from sdgen.importing.shelf import Origin, held, kept_entries, origins, put, write_manifest
from sdgen.importing.sizes import difference, fits
from sdgen.importing.table import Table, load_table
from sdgen.importing.tree import References, inside
from sdgen.library.licences import NON_COMMERCIAL
from sdgen.library.meshes import check_extents, read_glb, read_hulls
from sdgen.rejection import causes_in_words

#: Raised when models come out otherwise: a library's older ones are made anew.
VERSION = 2


@dataclass(frozen=True)
class Import:
    """What is asked for: a source, where its download lies, the library, and how."""

    source: str
    root: Path
    library: Path
    budget: Budget = field(default_factory=Budget)
    tables: tuple[Path, ...] = ()
    licence: str | None = None
    attribution: str | None = None
    non_commercial: bool = False
    overwrite: bool = False


@dataclass(frozen=True)
class Report:
    """How an import went: models made, those that were there already, those refused."""

    made: tuple[Origin, ...]
    kept: tuple[Origin, ...]
    refused: tuple[Refused, ...]


def import_models(
    asked: Import,
    catalog: Catalog,
    on_model: Callable[[int, int], None] | None = None,
    workers: int = 1,
    names: Sequence[str] = (),
) -> Report:
    """Import models into a library; ``names`` are those wanted (none: all).

    What is there already and was made from the same is kept. Raises AssetError where the download,
    the tables or the library cannot be read at all.
    """
    check_packages()
    table = load_table(asked.source, catalog, asked.tables)
    with opened_source(asked.root) as (roots, refused), held(asked.library):
        found = _found(asked, roots, names)
        terms = terms_of(asked.source, roots[0], asked.licence, asked.attribution)
        kept_entries(asked.library)  # a manifest that nobody can read is told of before the work
        before = origins(asked.library)
        work = (asked, found, table, catalog, terms, before)
        made: list[Origin] = []
        kept: list[Origin] = []
        try:
            with closing(in_order(_Importer, work, len(found), workers)) as outcomes:
                for outcome in outcomes:
                    name = found[outcome.job].name
                    if isinstance(outcome.error, SceneRejected):
                        why = causes_in_words(outcome.error.causes)
                        refused.append(Refused(name, f"the process that made it died ({why})"))
                    elif outcome.error is not None:
                        raise outcome.error
                    elif isinstance(outcome.result, Refused):
                        refused.append(outcome.result)
                    else:
                        new, origin = outcome.result
                        (made if new else kept).append(origin)
                    if on_model is not None:
                        on_model(outcome.job + 1, len(found))
        finally:  # what is there when it is stopped builds
            write_manifest(asked.library, list(origins(asked.library).values()))
    return Report(tuple(made), tuple(kept), tuple(refused))


def _found(asked: Import, roots: Sequence[Path], names: Sequence[str]) -> list[Candidate]:
    """The models of all roots. Raises AssetError when there are none, or not those of ``names``."""
    found: list[Candidate] = []
    for root in roots:
        try:
            found += find_models(asked.source, root)
        except AssetError:
            if len(roots) == 1:
                raise
    library = asked.library.resolve()
    if library in roots:
        raise AssetError([f"{asked.library}: is the download itself: name another folder"])
    found = [candidate for candidate in found if not inside(library, candidate.entry)]
    if not found:
        raise AssetError([f"{asked.root}: no model of {asked.source} here, nor in its archives"])
    return _wanted(found, names) if names else found


def _wanted(found: Sequence[Candidate], names: Sequence[str]) -> list[Candidate]:
    known = [candidate.name for candidate in found]
    unknown = [name for name in names if name not in known]
    if unknown:
        raise AssetError([f"no model {name!r}{did_you_mean(name, known)}" for name in unknown])
    return [candidate for candidate in found if candidate.name in names]


class _Importer:
    """Makes one model after the other."""

    def __init__(
        self,
        asked: Import,
        found: Sequence[Candidate],
        table: Table,
        catalog: Catalog,
        terms: Terms,
        before: dict[str, Origin],
    ) -> None:
        self._asked = asked
        self._found = found
        self._table = table
        self._catalog = catalog
        self._terms = terms
        self._before = before
        self._ids = _ids(asked, found, before)
        self._called: dict[str, list[Origin]] = {}
        for old in before.values():
            if old.source == asked.source:
                self._called.setdefault(old.name, []).append(old)

    def __call__(self, job: int) -> Refused | tuple[bool, Origin]:
        candidate = self._found[job]
        try:
            # Numbers of strangers overflow: what comes of that is checked, and is nobody's warning.
            with np.errstate(all="ignore"), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return self._import(candidate, self._ids[job])
        except InputError as error:
            return Refused(candidate.name, "; ".join(error.problems[:3]))
        except MemoryError:
            return Refused(candidate.name, "too large for this machine's memory")
        except OSError as error:
            return Refused(candidate.name, os_error_in_words(error, candidate.entry))
        except SdgenError as error:
            return Refused(candidate.name, str(error))
        except Exception as error:  # one model of a download must not stop the others
            if os.environ.get("SDGEN_DEBUG"):
                raise
            reason = " ".join(str(error).split())[:200]
            shown = candidate.entry.name
            return Refused(
                candidate.name,
                f"{shown}: nothing can be made of it ({type(error).__name__}: {reason})",
            )

    def close(self) -> None:
        """Nothing to let go of."""

    def _import(self, candidate: Candidate, asset_id: str) -> Refused | tuple[bool, Origin]:
        references = References(candidate.root, candidate.folder)
        row = self._table.row(candidate.name)
        if row is not None and row.skip:
            return Refused(candidate.name, f"left out: {row.skip}")
        terms = nearer(self._terms, references)
        if terms.licence in NON_COMMERCIAL and not self._asked.non_commercial:
            why = f"{terms.licence} ({terms.where}): such models come in with --non-commercial"
            return Refused(candidate.name, why)
        scan = read_model(self._asked.source, candidate, references)
        digest = self._digest(references, repr((row, terms)))
        known = (self._before.get(asset_id), *self._called.get(candidate.name, ()))
        same = next((old for old in known if old is not None and old.digest == digest), None)
        if same is not None and not self._asked.overwrite:
            return False, same
        notes = references.notes
        scan, choice = stand(scan, candidate.name, self._table, self._catalog, notes)
        notes += choice.doubts
        category = None if choice.category is None else self._catalog.category(choice.category)
        placed = category is not None and _of_a_size(scan.extents_m, category)
        why = choice.why
        if category is not None and not placed:
            why = f"{why}, but {_why_not_placed(scan.extents_m, category)}"
            notes = [note for note in notes if note not in choice.doubts]  # said by that
        made = make_model(
            asset_id,
            f"{self._asked.source}:{candidate.name}",
            candidate.name.replace("_", " "),
            scan,
            choice,
            category if placed else None,
            terms,
            self._asked.budget,
            notes,
        )
        origin = Origin(
            source=self._asked.source,
            name=candidate.name,
            kind=candidate.kind,
            entry=candidate.place,
            root=str(self._asked.root.resolve()),
            digest=digest,
            how=choice.how,
            why=why,
            placed=placed,
            notes=tuple(dict.fromkeys(notes)),
            asset=made.asset,
        )
        put(self._asked.library, origin, made.files)
        self._check(made.asset.id, origin)
        return True, origin

    def _check(self, asset_id: str, origin: Origin) -> None:
        """As every model of a library is read: what a build would refuse is refused here."""
        library, asset = self._asked.library, origin.asset
        try:
            meshes = read_glb(library / asset.mesh, asset)
            check_extents(library / asset.mesh, asset, meshes)
            read_hulls(library / asset.hulls, asset)
        except AssetError:
            (library / "imports" / f"{asset_id}.json").unlink(missing_ok=True)
            raise

    def _digest(self, references: References, more: str) -> str:
        total = hashlib.sha256(f"{VERSION} {self._asked.budget} {more}".encode())
        for path in sorted(references.read):
            total.update(references.shown(path).encode())
            total.update(hashlib.sha256(path.read_bytes()).digest())
        return total.hexdigest()


def _of_a_size(extents_m: Array, category: Category) -> bool:
    off = FURNITURE_OFF if category.kind == "furniture" else SMALL_OFF
    return category.kind != "opening" and fits(vec3(extents_m), category, off)


def _why_not_placed(extents_m: Array, category: Category) -> str:
    if category.kind == "opening":
        return "doors and windows are a home's own"
    return difference(vec3(extents_m), category)


def _ids(asked: Import, found: Sequence[Candidate], before: Mapping[str, Origin]) -> list[str]:
    """An id for each model: the one it had, else one that no other model has, of this download or
    of another that is still there."""

    def another(old: Origin, candidate: Candidate) -> bool:
        root = Path(old.root)
        moved = root.exists() and root.resolve() != asked.root.resolve()
        return old.entry != candidate.place or moved

    out: list[str] = []
    for candidate in found:
        base = f"{asked.source.replace('-', '_')}_{slug(candidate.name)}"
        name, number = base, 2
        while name in out or (name in before and another(before[name], candidate)):
            name, number = f"{base}_{number}", number + 1
        out.append(name)
    return out
