"""A data set in the making: opened, resumed or extended, and finished.

While a build runs, the hidden folder ``.build`` holds the lock, what the build was asked for,
scenes half written and the manifest lines of those finished. ``finish`` turns the lines into the
manifest and removes it; a data set that has a ``dataset.json`` and no ``.build`` is complete.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from sdgen.catalog.records import Catalog
from sdgen.closing import Closing
from sdgen.dataset.card import card
from sdgen.dataset.disk import remove_tree, replace_file
from sdgen.dataset.origin import build_of, differences, refuse_foreign
from sdgen.dataset.output_file import refuse_data_set
from sdgen.dataset.records import (
    LICENCE,
    SCENE_ID,
    SPLITS,
    TOP_FILES,
    Build,
    DatasetInfo,
    ManifestEntry,
    Vocabularies,
    count,
)
from sdgen.dataset.scene_folder import (
    BUILD_FOLDER,
    FinishedScene,
    SceneWriter,
    take_away,
    whole,
)
from sdgen.dataset.text import line_bytes, read_lines, read_record, record_bytes
from sdgen.dataset.versions import package_versions
from sdgen.dataset.vocabularies import vocabularies
from sdgen.errors import InputError, SdgenError
from sdgen.library.licences import narrowest
from sdgen.library.records import AssetInfo
from sdgen.locks import FileLock
from sdgen.options import BuildOptions
from sdgen.rejection import Causes
from sdgen.scene import cause_counts, causes_of


class DatasetWriter(Closing):
    """Owns one data set folder for the time of a build. Use as a context manager.

    ``done`` maps the ids of the scenes that are there, whole, to their manifest lines; ``notes``
    says which were found damaged and taken away to be made again, and where files in them that
    are not sdgen's went.
    """

    def __init__(
        self, root: Path, build: Build, catalog: Catalog, infos: Mapping[str, AssetInfo]
    ) -> None:
        self.root = root
        self.build = build
        self.catalog = catalog
        self.infos = infos
        self.done: dict[str, ManifestEntry] = {}
        self.notes: tuple[str, ...] = ()
        self._assets: set[str] = set()
        self._failed: dict[str, Causes] = {}
        self._renderers: set[str] = set()
        self._lock: FileLock | None = None

    @classmethod
    def open(
        cls,
        root: Path,
        options: BuildOptions,
        catalog: Catalog,
        infos: Mapping[str, AssetInfo],
        assets_sha256: str,
        *,
        overwrite: bool = False,
        versions: Mapping[str, str] | None = None,
    ) -> DatasetWriter:
        """Take the folder: a new one, an unfinished or finished one to go on with.

        ``infos`` are the records of the library, ``assets_sha256`` its digest. Raises SdgenError
        when another build has the folder, when it holds something else (whatever ``overwrite``
        says), lies in another data set, or holds one that other options, catalogue, assets or
        package versions made;
        ``overwrite`` takes away the latter.
        Every finished scene is checked against its digests.
        """
        build = Build(
            versions=dict(versions if versions is not None else package_versions()),
            options=options,
            catalogue_sha256=catalog.sha256,
            assets_sha256=assets_sha256,
            hazards_enabled=tuple(sorted(hazard.id for hazard in catalog.hazards)),
        )
        return cls.take(root, build, catalog, infos, overwrite=overwrite, may_overwrite=True)

    @classmethod
    def take(
        cls,
        root: Path,
        build: Build,
        catalog: Catalog,
        infos: Mapping[str, AssetInfo],
        *,
        overwrite: bool = False,
        may_overwrite: bool = False,
    ) -> DatasetWriter:
        """Like :meth:`open`, for what decides the bytes given whole. Errors advise ``--overwrite``
        where whoever asks has it (``may_overwrite``)."""
        root = root.absolute()
        refuse_data_set(root)
        refuse_foreign(root)
        root.mkdir(parents=True, exist_ok=True)
        try:
            (root / BUILD_FOLDER).mkdir()
            new = True
        except FileExistsError:
            new = False
        writer = cls(root, build, catalog, infos)
        writer._lock = FileLock.take(root / BUILD_FOLDER / "lock")
        if writer._lock is None:
            raise SdgenError(
                f"{root}: another build is writing here; wait for it, or choose another --out "
                "(pieces of --range that are built side by side go into folders of their own, "
                "sdgen merge joins them)"
            )
        try:
            if overwrite:
                writer._clear()
            else:
                writer._check_same(", or start anew with --overwrite" if may_overwrite else "")
            replace_file(root / BUILD_FOLDER / "build.json", record_bytes(build))
            writer._resume()
        except BaseException:
            # A finished data set stays a finished one. Not where it was to be cleared, though:
            # without its dataset.json the folder tells whose the rest is.
            if new and not overwrite:
                remove_tree(root / BUILD_FOLDER)
            writer.close()
            raise
        return writer

    @property
    def scene_writer(self) -> SceneWriter:
        """What workers write scenes with (picklable)."""
        return SceneWriter(self.root, self.build.options)

    def include(self, info: DatasetInfo, assets: Iterable[str]) -> None:
        """Take in what another data set says of its scenes: assets used, renderers, failures."""
        self._assets.update(assets)
        self._renderers.update(info.renderers)
        self._failed.update({key: causes_of(counts) for key, counts in info.failed.items()})

    def finish(
        self,
        failed: Mapping[str, Causes] | None = None,
        words: Vocabularies | None = None,
    ) -> DatasetInfo:
        """Take in the finished scenes and write the files of the whole, ``dataset.json`` last.

        ``failed`` maps scenes that could not be made to their counted causes. Those of earlier
        runs (other ranges) stay, until they are made. ``words`` are the vocabularies where they
        are known; else they come from the catalogue and the library.
        """
        for path in sorted((self.root / BUILD_FOLDER).glob("entries/*.json")):
            scene = read_record(FinishedScene, path, str(path))
            if (self.root / "scenes" / scene.entry.id).is_dir():
                self.done[scene.entry.id] = scene.entry
                self._assets.update(scene.assets)
                if scene.renderer is not None:
                    self._renderers.add(scene.renderer)
        entries = tuple(self.done[key] for key in sorted(self.done, key=_order))
        never_made = {**self._failed, **(failed or {})}
        words = words or vocabularies(self.catalog, self.infos)
        used = [self.infos[name] for name in sorted(self._assets) if name in self.infos]
        info = self._info(
            entries, words, {k: v for k, v in never_made.items() if k not in self.done}
        ).model_copy(update={"licence": narrowest([LICENCE, *(one.licence for one in used)])})
        files = {
            "catalogue.json": record_bytes(self.catalog),
            "assets.jsonl": b"".join(line_bytes(asset) for asset in used),
            "README.md": card(info, entries, used, self.catalog).encode("utf-8"),
            "manifest.jsonl": b"".join(line_bytes(entry) for entry in entries),
            "dataset.json": record_bytes(info),
        }
        for name in TOP_FILES:
            replace_file(self.root / name, files[name])
        remove_tree(self.root / BUILD_FOLDER)
        self.close()
        return info

    def close(self) -> None:
        """Let go of the folder; without ``finish`` the build can be resumed."""
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    # --- opening ---------------------------------------------------------------------------------

    def _clear(self) -> None:
        # The lines go first: whatever is left after a kill in between counts as not made.
        remove_tree(self.root / BUILD_FOLDER / "entries")
        replace_file(self.root / BUILD_FOLDER / "build.json", record_bytes(self.build))
        for name in reversed(TOP_FILES):
            (self.root / name).unlink(missing_ok=True)
        self._take_away(path.name for path in (self.root / "scenes").glob("*"))
        with contextlib.suppress(OSError):
            (self.root / "scenes").rmdir()

    def _check_same(self, anew: str) -> None:
        found = build_of(self.root)
        if found is None:
            return
        others = differences(found, self.build)
        if others:
            raise SdgenError(
                f"{self.root} holds a data set built with {'; '.join(others)}; "
                f"choose another --out{anew}"
            )
        if found.options.n > self.build.options.n:
            raise SdgenError(
                f"{self.root} holds a data set of --n {found.options.n}, more than the "
                f"{self.build.options.n} asked for; choose another --out{anew}"
            )

    def _resume(self) -> None:
        for path in (self.root / BUILD_FOLDER).glob("*.partial"):
            remove_tree(path)
        known: dict[str, ManifestEntry] = {}
        if (self.root / "dataset.json").is_file():
            info = read_record(DatasetInfo, self.root / "dataset.json", "dataset.json")
            self._renderers.update(info.renderers)
            self._failed.update({k: causes_of(v) for k, v in info.failed.items()})
            manifest = read_lines(ManifestEntry, self.root / "manifest.jsonl", "manifest.jsonl")
            known.update({entry.id: entry for entry in manifest})
            assets = read_lines(AssetInfo, self.root / "assets.jsonl", "assets.jsonl")
            self._assets.update(asset.id for asset in assets)
        for path in sorted((self.root / BUILD_FOLDER).glob("entries/*.json")):
            try:
                entry = read_record(FinishedScene, path, path.name).entry
                known[entry.id] = entry
            except InputError:
                path.unlink()  # its scene will be made again
        damaged = []
        for folder in sorted((self.root / "scenes").glob("*")):
            if not re.match(SCENE_ID, folder.name):
                continue
            line = known.get(folder.name)
            if line is not None and whole(self.root, line):
                self.done[line.id] = line
            else:
                damaged.append(folder.name)
        self.notes += tuple(f"scene {name} was damaged and will be made again" for name in damaged)
        self._take_away(damaged)
        # A scene whose twins are not all there is made again with them.
        self.done = {
            key: entry
            for key, entry in self.done.items()
            if entry.twin_of is not None
            or entry.twins_promised(self.build.options) <= self.done.keys()
        }

    def _take_away(self, names: Iterable[str]) -> None:
        """Remove scenes with their lines; what others put into their folders is set aside."""
        for name in sorted(names):
            if not re.match(SCENE_ID, name):
                continue
            (self.root / BUILD_FOLDER / "entries" / f"{name}.json").unlink(missing_ok=True)
            aside = take_away(self.root, name)
            if aside is not None:
                self.notes += (f"files in scene {name} that are not sdgen's are in {aside} now",)

    def _info(
        self,
        entries: tuple[ManifestEntry, ...],
        words: Vocabularies,
        failed: Mapping[str, Causes],
    ) -> DatasetInfo:
        splits = {name: sorted({e.home for e in entries if e.split == name}) for name in SPLITS}
        return DatasetInfo(
            format_version=self.build.format_version,
            versions=self.build.versions,
            renderers=tuple(sorted(self._renderers)),
            seed=self.build.options.seed,
            n=self.build.options.n,
            options=self.build.options,
            catalogue_sha256=self.build.catalogue_sha256,
            assets_sha256=self.build.assets_sha256,
            hazards_enabled=self.build.hazards_enabled,
            vocabularies=words,
            splits={name: tuple(homes) for name, homes in splits.items()},
            counts=count(entries),
            failed={key: cause_counts(failed[key]) for key in sorted(failed)},
        )


def _order(scene_id: str) -> tuple[int, str]:
    return int(scene_id.split("-")[0]), scene_id
