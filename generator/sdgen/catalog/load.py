"""The hazard catalogue, from YAML folders to one resolved :class:`Catalog`.

A folder holds ``hazards/*.yaml``, ``categories/*.yaml``, ``homes/*.yaml``, ``rooms.yaml``,
``plans.yaml`` and ``households.yaml``, each optional except in the shipped one. Later folders add
to earlier ones; to replace an entry they say ``replaces: true``. A single file may stand in for a
folder.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

from sdgen.catalog.enumeration import catalog_sha256, check_against_library, enumerate_anomalies
from sdgen.catalog.read_hazard import read_hazard
from sdgen.catalog.read_home import read_home
from sdgen.catalog.read_world import (
    read_category,
    read_household,
    read_mix,
    read_reach,
    read_room_type,
)
from sdgen.catalog.reader import Reader
from sdgen.catalog.records import Catalog, ReachRow
from sdgen.errors import InputError, did_you_mean
from sdgen.resources import data_path
from sdgen.yaml_source import Source, read_yaml

__all__ = ["catalog_sha256", "check_against_library", "enumerate_anomalies", "load_catalog"]

T = TypeVar("T")


@dataclass
class _Folder:
    """The parsed files of one catalogue folder. ``pack`` names it in its hazards."""

    pack: str
    hazards: list[Source] = field(default_factory=list)
    categories: list[Source] = field(default_factory=list)
    homes: list[Source] = field(default_factory=list)
    rooms: list[Source] = field(default_factory=list)
    plans: list[Source] = field(default_factory=list)
    households: list[Source] = field(default_factory=list)

    def all(self) -> list[Source]:
        """Every file, in reading order."""
        return [
            *self.categories,
            *self.rooms,
            *self.hazards,
            *self.households,
            *self.homes,
            *self.plans,
        ]


def load_catalog(
    extra: Sequence[Path] = (),
    extensions: Sequence[str] = (),
    only: Sequence[str] | None = None,
) -> Catalog:
    """Load the shipped catalogue, shipped extension packs and extra folders or hazard files.

    ``only`` keeps just these hazard ids. Raises InputError with every problem found, each
    ``file:line: key path: problem``.
    """
    folders = [_open_folder(data_path("hazard_catalog"), "core", "hazard_catalog")]
    shipped = extension_names()
    problems: list[str] = []
    for name in extensions:
        if name not in shipped:
            near = did_you_mean(name, shipped) or " (none are shipped)"
            problems.append(f"unknown extension pack {name!r}{near}")
            continue
        path = data_path("hazard_catalog", "extensions", name)
        folders.append(_open_folder(path, name, f"hazard_catalog/extensions/{name}"))
    for path in extra:
        try:
            folders.append(_open_extra(path))
        except InputError as error:
            problems.extend(error.problems)
    catalog = _resolve(folders, problems)
    if only is None:
        return catalog
    known = [hazard.id for hazard in catalog.hazards]
    wrong = [
        f"unknown hazard {name!r}{did_you_mean(name, known)}" for name in only if name not in known
    ]
    if wrong:
        raise InputError(wrong)
    kept = tuple(hazard for hazard in catalog.hazards if hazard.id in only)
    return catalog.model_copy(update={"hazards": kept})


def extension_names() -> tuple[str, ...]:
    """Names of the shipped extension packs."""
    root = data_path("hazard_catalog", "extensions")
    if not root.is_dir():
        return ()
    return tuple(sorted(path.name for path in root.iterdir() if path.is_dir()))


def _open_extra(path: Path) -> _Folder:
    """An extra folder, or one file: its name or its folder's name says what it holds."""
    shipped = data_path("hazard_catalog").resolve()
    if path.resolve() == shipped or shipped in path.resolve().parents:
        return _Folder(pack="core")  # loaded already
    if not path.is_dir():
        single = _Folder(pack=path.stem)
        kinds = {"categories": single.categories, "homes": single.homes}
        alone = {"rooms": single.rooms, "plans": single.plans, "households": single.households}
        kinds |= alone
        name = path.stem if path.stem in alone else path.resolve().parent.name
        kinds.get(name, single.hazards).append(read_yaml(path))
        return single
    folder = _open_folder(path, path.resolve().name, str(path))
    if not folder.all():
        folders = "hazards/*.yaml, categories/*.yaml, homes/*.yaml"
        layout = f"{folders}, rooms.yaml, plans.yaml, households.yaml"
        raise InputError([f"{path}: no catalogue file in it (expected {layout})"])
    return folder


def _open_folder(root: Path, pack: str, shown: str) -> _Folder:
    def listed(name: str) -> list[Source]:
        found = sorted(
            path
            for path in (root / name).glob("*.y*ml")
            if path.suffix in (".yaml", ".yml") and not path.name.startswith(".")
        )
        return [read_yaml(path, f"{shown}/{name}/{path.name}") for path in found]

    def single(name: str) -> list[Source]:
        path = root / name
        return [read_yaml(path, f"{shown}/{name}")] if path.is_file() else []

    return _Folder(
        pack=pack,
        hazards=listed("hazards"),
        categories=listed("categories"),
        homes=listed("homes"),
        rooms=single("rooms.yaml"),
        plans=single("plans.yaml"),
        households=single("households.yaml"),
    )


@dataclass
class _Entries:
    """Named entries of one kind over all folders, with where each was first defined."""

    what: str
    found: dict[str, tuple[Reader, str]] = field(default_factory=dict)

    def add(self, name: str, reader: Reader, pack: str) -> None:
        """Take an entry, or note that it exists already."""
        if name in self.found and reader.data.get("replaces") is not True:
            first = self.found[name][0]
            where = f"{first.source.file}:{first.source.line(first.path)}"
            hint = "(to replace it add 'replaces: true')"
            reader.problem(f"{self.what} {name!r} is already defined at {where} {hint}")
            return
        self.found[name] = (reader, pack)

    def read(self, make: Callable[[str, Reader, str], T]) -> tuple[T, ...]:
        """Turn all entries into records, sorted by name."""
        return tuple(make(name, *self.found[name]) for name in sorted(self.found))


def _resolve(folders: Sequence[_Folder], problems: list[str]) -> Catalog:
    categories, room_types = _Entries("category"), _Entries("room type")
    mixes = _Entries("mix of rooms")
    hazards, homes, households = _Entries("hazard"), _Entries("home"), _Entries("household")
    reach_reader: Reader | None = None
    for folder in folders:
        for kind, sources in (
            (categories, folder.categories),
            (room_types, folder.rooms),
            (mixes, folder.plans),
        ):
            for source in sources:
                for name, reader in _top(source).named():
                    kind.add(name, reader, folder.pack)
        for kind, sources in ((hazards, folder.hazards), (homes, folder.homes)):
            for source in sources:
                reader = _top(source)
                kind.add(_id_of(reader, source), reader, folder.pack)
        for source in folder.households:
            top = _top(source)
            for name, reader in top.named("templates") if top.has("templates") else []:
                households.add(name, reader, folder.pack)
            if top.has("reach"):
                reach_reader = top.child("reach")
            top.done()

    names, rooms, ids = set(categories.found), set(room_types.found), set(hazards.found)
    reach: tuple[ReachRow, ...] = read_reach(reach_reader) if reach_reader is not None else ()
    catalog = Catalog(
        hazards=hazards.read(lambda _, r, pack: read_hazard(r, names, rooms, pack)),
        categories=categories.read(lambda name, r, _: read_category(name, r, names, rooms)),
        room_types=room_types.read(lambda name, r, _: read_room_type(name, r, names)),
        households=households.read(lambda name, r, _: read_household(name, r, ids)),
        reach=reach,
        homes=homes.read(lambda _, r, __: read_home(r, names, rooms)),
        mixes=mixes.read(lambda name, r, _: read_mix(name, r, rooms)),
    )
    for folder in folders:
        for source in folder.all():
            problems.extend(source.problems)
    if problems:
        raise InputError(tuple(dict.fromkeys(problems)))
    return catalog


def _top(source: Source) -> Reader:
    """Reader of a whole file; silent when the file could not be parsed (noted already)."""
    if source.value is None and source.problems:
        reader = Reader(source, (), {})
        reader.ok = False
        return reader
    return Reader(source, (), source.value)


def _id_of(reader: Reader, source: Source) -> str:
    """The ``id`` of a hazard or home file, which must be the file's name."""
    stem = Path(source.file).stem
    found = reader.data.get("id")
    if isinstance(found, str) and found != stem:
        reader.problem(f"the id must be the file's name, {stem!r}", "id")
    return stem
