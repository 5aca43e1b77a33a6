"""A data set in the making: opened, resumed or extended, and finished.

While a build runs, the hidden folder ``.build`` holds the lock, what the build was asked for,
scenes half written and the manifest lines of those finished. ``finish`` turns the lines into the
manifest and removes it; a data set that has a ``dataset.json`` and no ``.build`` is complete.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType

from sdgen.catalog.enumeration import catalog_sha256
from sdgen.catalog.records import Catalog
from sdgen.dataset.card import card
from sdgen.dataset.disk import FolderLock, remove_tree, replace_file
from sdgen.dataset.records import SCENE_ID, Build, DatasetInfo, ManifestEntry, count
from sdgen.dataset.scene_folder import BUILD_FOLDER, FinishedScene, SceneWriter, whole
from sdgen.dataset.text import (
    line_bytes,
    parse,
    read_bytes,
    read_lines,
    read_record,
    record_bytes,
)
from sdgen.dataset.versions import package_versions
from sdgen.dataset.vocabularies import vocabularies
from sdgen.errors import InputError, SdgenError
from sdgen.library.records import AssetInfo
from sdgen.options import BuildOptions
from sdgen.rejection import Causes
from sdgen.scene import cause_counts, causes_of

#: Files ``finish`` writes at the top of a data set, ``dataset.json`` last.
TOP_FILES = ("catalogue.json", "assets.jsonl", "README.md", "manifest.jsonl", "dataset.json")


class DatasetWriter:
    """Owns one data set folder for the time of a build. Use as a context manager.

    ``done`` maps the ids of the scenes that are there, whole, to their manifest lines;
    ``repaired`` lists those that were found damaged and taken away to be made again.
    """

    def __init__(
        self, root: Path, build: Build, catalog: Catalog, infos: Mapping[str, AssetInfo]
    ) -> None:
        self.root = root
        self.build = build
        self.catalog = catalog
        self.infos = infos
        self.done: dict[str, ManifestEntry] = {}
        self.repaired: tuple[str, ...] = ()
        self._assets: set[str] = set()
        self._failed: dict[str, Causes] = {}
        self._renderers: set[str] = set()
        self._lock: FolderLock | None = None

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
        says), or a data set that other options, catalogue, assets or package versions made;
        ``overwrite`` takes away the latter.
        Every finished scene is checked against its digests.
        """
        build = Build(
            versions=dict(versions if versions is not None else package_versions()),
            options=options,
            catalogue_sha256=catalog_sha256(catalog),
            assets_sha256=assets_sha256,
            hazards_enabled=tuple(sorted(hazard.id for hazard in catalog.hazards)),
        )
        root = root.absolute()
        _refuse_foreign(root)
        (root / BUILD_FOLDER).mkdir(parents=True, exist_ok=True)
        writer = cls(root, build, catalog, infos)
        writer._lock = FolderLock(root / BUILD_FOLDER / "lock", str(root))
        try:
            if overwrite:
                writer._clear()
            else:
                writer._check_same()
            replace_file(root / BUILD_FOLDER / "build.json", record_bytes(build))
            writer._resume()
        except BaseException:
            writer.close()
            raise
        return writer

    @property
    def scene_writer(self) -> SceneWriter:
        """What workers write scenes with (picklable)."""
        return SceneWriter(self.root, self.build.options)

    def finish(
        self,
        renderers: tuple[str, ...] = (),
        failed: Mapping[str, Causes] | None = None,
    ) -> DatasetInfo:
        """Take in the finished scenes and write the files of the whole, ``dataset.json`` last.

        ``renderers`` drew this run's pictures; ``failed`` maps scenes that could not be made to
        their counted causes. Those of earlier runs (other ranges) stay, until they are made.
        """
        for path in sorted((self.root / BUILD_FOLDER).glob("entries/*.json")):
            scene = read_record(FinishedScene, path, str(path))
            if (self.root / "scenes" / scene.entry.id).is_dir():
                self.done[scene.entry.id] = scene.entry
                self._assets.update(scene.assets)
        entries = tuple(self.done[key] for key in sorted(self.done, key=_order))
        never_made = {**self._failed, **(failed or {})}
        info = self._info(
            entries, renderers, {k: v for k, v in never_made.items() if k not in self.done}
        )
        used = [self.infos[name] for name in sorted(self._assets) if name in self.infos]
        files = {
            "catalogue.json": record_bytes(self.catalog),
            "assets.jsonl": b"".join(line_bytes(asset) for asset in used),
            "README.md": card(info).encode("utf-8"),
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

    def __enter__(self) -> DatasetWriter:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    # --- opening ---------------------------------------------------------------------------------

    def _clear(self) -> None:
        # The lines go first: whatever is left after a kill in between counts as not made.
        remove_tree(self.root / BUILD_FOLDER / "entries")
        replace_file(self.root / BUILD_FOLDER / "build.json", record_bytes(self.build))
        for name in reversed(TOP_FILES):
            (self.root / name).unlink(missing_ok=True)
        remove_tree(self.root / "scenes")

    def _check_same(self) -> None:
        found = _build_of(self.root)
        if found is None:
            return
        differences = _differences(found, self.build)
        if differences:
            raise SdgenError(
                f"{self.root} holds a data set built with {'; '.join(differences)}; "
                "choose another --out, or start anew with --overwrite"
            )
        if found.options.n > self.build.options.n:
            raise SdgenError(
                f"{self.root} holds a data set of --n {found.options.n}; ask for as many or more, "
                "choose another --out, or start anew with --overwrite"
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
        repaired = []
        for folder in sorted((self.root / "scenes").glob("*")):
            if not re.match(SCENE_ID, folder.name):
                continue
            line = known.get(folder.name)
            if line is not None and whole(self.root, line):
                self.done[line.id] = line
                continue
            remove_tree(folder)
            (self.root / BUILD_FOLDER / "entries" / f"{folder.name}.json").unlink(missing_ok=True)
            repaired.append(folder.name)
        self.repaired = tuple(repaired)
        if self.build.options.twins:
            # A scene whose twin is not there is made again with it.
            self.done = {
                key: entry
                for key, entry in self.done.items()
                if entry.twin_of is not None or f"{key}-twin" in self.done
            }

    def _info(
        self,
        entries: tuple[ManifestEntry, ...],
        renderers: tuple[str, ...],
        failed: Mapping[str, Causes],
    ) -> DatasetInfo:
        splits = {name: sorted({e.home for e in entries if e.split == name}) for name in _SPLITS}
        return DatasetInfo(
            format_version=self.build.format_version,
            versions=self.build.versions,
            renderers=tuple(sorted({*self._renderers, *renderers})),
            seed=self.build.options.seed,
            n=self.build.options.n,
            options=self.build.options,
            catalogue_sha256=self.build.catalogue_sha256,
            assets_sha256=self.build.assets_sha256,
            hazards_enabled=self.build.hazards_enabled,
            vocabularies=vocabularies(self.catalog, self.infos),
            splits={name: tuple(homes) for name, homes in splits.items()},
            counts=count(entries),
            failed={key: cause_counts(failed[key]) for key in sorted(failed)},
        )


_SPLITS = ("train", "val", "test")


def _order(scene_id: str) -> tuple[int, str]:
    return int(scene_id.split("-")[0]), scene_id


def _refuse_foreign(root: Path) -> None:
    if not root.exists():
        return
    if not root.is_dir():
        raise SdgenError(f"{root} is a file; choose another --out")
    # The names alone prove nothing: other tools have a dataset.json or a .build folder too.
    unfinished = root / BUILD_FOLDER / "build.json"
    if unfinished.is_file() or _is_ours(root / "dataset.json"):
        return
    if any(path.name != BUILD_FOLDER for path in root.iterdir()):
        raise SdgenError(
            f"{root} is not empty and holds no data set of sdgen; choose another --out"
        )


def _is_ours(path: Path) -> bool:
    """True for a ``dataset.json`` that sdgen wrote, be it of another version."""
    try:
        data = parse(read_bytes(path, str(path)), str(path))
    except InputError:
        return False
    return isinstance(data, dict) and {"format_version", "catalogue_sha256"} <= data.keys()


def _build_of(root: Path) -> Build | None:
    unfinished = root / BUILD_FOLDER / "build.json"
    if unfinished.is_file():
        return read_record(Build, unfinished, str(unfinished))
    if (root / "dataset.json").is_file():
        return read_record(DatasetInfo, root / "dataset.json", str(root / "dataset.json")).build()
    return None


def _differences(found: Build, asked: Build) -> list[str]:
    """What another build was made with, in words; the number of scenes may differ."""
    out = []
    if found.format_version != asked.format_version:
        out.append(f"format {found.format_version} (now {asked.format_version})")
    for name in BuildOptions.model_fields:
        before, now = getattr(found.options, name), getattr(asked.options, name)
        if name != "n" and before != now:
            out.append(f"{name} {_shown(before)} (now {_shown(now)})")
    if found.catalogue_sha256 != asked.catalogue_sha256:
        out.append("another catalogue")
    if found.assets_sha256 != asked.assets_sha256:
        out.append("other assets")
    for name in sorted({*found.versions, *asked.versions}):
        before, now = found.versions.get(name, "none"), asked.versions.get(name, "none")
        if before != now:
            out.append(f"{name} {before} (now {now})")
    return out


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return ",".join(str(item) for item in value) or "none"
    return str(value)
