"""One scene as a folder: written aside, synced, renamed into place whole."""

from __future__ import annotations

import os
import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
from pydantic import BaseModel

from sdgen.closing import Closing
from sdgen.dataset.disk import (
    file_sha256,
    remove_tree,
    replace_file,
    sha256_hex,
    sync_file,
    sync_folder,
)
from sdgen.dataset.images import gray_bytes, rgb_bytes
from sdgen.dataset.records import (
    CONTENT_FILES,
    OBSERVABILITY_FILE,
    VISIBILITY_FILE,
    ManifestEntry,
)
from sdgen.dataset.text import record_bytes
from sdgen.options import BuildOptions
from sdgen.scene import Frame, Panorama, Record, SceneBundle, Visibility
from sdgen.truth.observable import Observability

BUILD_FOLDER = ".build"
#: Where a user's own files go that lay in a scene's folder which had to be made again.
ASIDE = "set-aside"

_VIEW_FILE = re.compile(
    r"views/[0-9]{2}/(view\.json|rgb\.(png|jpg)|(depth|instance|part)\.png)"
    r"|panoramas/[0-9]{2}/(panorama\.json|rgb\.(png|jpg)|instance\.png)"
)


class FinishedScene(Record):
    """What a worker leaves beside a finished scene until the manifest takes it over.

    ``renderer`` drew its pictures; None when it has none.
    """

    entry: ManifestEntry
    assets: tuple[str, ...]
    renderer: str | None = None


def content_files(bundle: SceneBundle) -> dict[str, bytes]:
    """The bytes of all files that decide a scene's ``content_sha256``."""
    records: dict[str, BaseModel] = {
        "scene.json": bundle.scene,
        "graph.json": bundle.graph,
        "anomalies.json": bundle.anomalies,
        "household.json": bundle.household,
        "physics.json": bundle.physics,
    }
    return {name: record_bytes(record) for name, record in records.items()}


def content_sha256(files: dict[str, bytes]) -> str:
    """Digest of all that a scene says but views and visibility: names, lengths and bytes."""
    framed = bytearray()
    for name in CONTENT_FILES:
        framed += f"{name}\n{len(files[name])}\n".encode() + files[name]
    return sha256_hex(bytes(framed))


def view_folder(index: int) -> str:
    """Folder of a view inside its scene's folder."""
    return f"views/{index:02d}"


def panorama_folder(index: int) -> str:
    """Folder of a panorama inside its scene's folder."""
    return f"panoramas/{index:02d}"


def is_ours(name: str) -> bool:
    """True for the name, relative to its scene's folder, of a file that sdgen may write."""
    ours = (*CONTENT_FILES, VISIBILITY_FILE, OBSERVABILITY_FILE)
    return name in ours or _VIEW_FILE.fullmatch(name) is not None


def take_away(root: Path, scene_id: str) -> Path | None:
    """Remove a scene's folder; files that are not sdgen's go to the folder that is returned."""
    folder = root / "scenes" / scene_id
    if folder.is_symlink() or not folder.is_dir():
        remove_tree(folder)
        return None
    names = [p.relative_to(folder).as_posix() for p in folder.rglob("*") if not p.is_dir()]
    foreign = sorted(name for name in names if not is_ours(name))
    aside = root / ASIDE / scene_id
    number = 1
    while foreign and aside.exists():
        number += 1
        aside = root / ASIDE / f"{scene_id}-{number}"
    for name in foreign:
        (aside / name).parent.mkdir(parents=True, exist_ok=True)
        os.replace(folder / name, aside / name)
    remove_tree(folder)
    return aside if foreign else None


def view_files(options: BuildOptions) -> tuple[str, ...]:
    """Files of every view under these options, ``view.json`` first."""
    names = ["view.json"]
    if "rgb" in options.sensors:
        names.append(f"rgb.{options.rgb}")
    if "depth" in options.sensors:
        names.append("depth.png")
    if "instance" in options.sensors:
        names += ["instance.png", "part.png"]
    return tuple(names)


def panorama_files(options: BuildOptions) -> tuple[str, ...]:
    """Files of every panorama under these options; none where they ask for no panoramas."""
    if not options.stitches:
        return ()
    names = ["panorama.json"]
    if "rgb" in options.sensors:
        names.append(f"rgb.{options.rgb}")
    if "instance" in options.sensors:
        names.append("instance.png")
    return tuple(names)


@dataclass(frozen=True)
class SceneWriter:
    """Writes scenes below ``root``. Small and picklable: every worker has one.

    ``renderer`` names what draws this worker's pictures, for the data set's records.
    """

    root: Path
    options: BuildOptions
    renderer: str | None = None

    def begin(self, bundle: SceneBundle) -> SceneFolder:
        """Start a scene's folder; use as a context manager and ``finish`` it."""
        return SceneFolder(self, bundle)


class SceneFolder(Closing):
    """A scene folder in the making; nothing of it shows in ``scenes/`` before ``finish``. An
    OSError on the way (a full disk, say) leaves nothing behind."""

    def __init__(self, writer: SceneWriter, bundle: SceneBundle) -> None:
        self.writer = writer
        self.bundle = bundle
        self._hashes: dict[str, str] = {}
        self._partial = writer.root / BUILD_FOLDER / f"{bundle.scene.id}.partial"
        remove_tree(self._partial)
        self._partial.mkdir(parents=True)

    def close(self) -> None:
        """Take away what is not in place."""
        remove_tree(self._partial)

    def add(self, frame: Frame) -> None:
        """Encode and write what the options ask of one view."""
        options = self.writer.options
        folder = view_folder(frame.camera.index)
        if "rgb" in options.sensors:
            self._put(f"{folder}/rgb.{options.rgb}", rgb_bytes(frame.rgb, options.rgb))
        if "depth" in options.sensors:
            self._put(f"{folder}/depth.png", gray_bytes(frame.depth_mm))
        if "instance" in options.sensors:
            self._put(f"{folder}/instance.png", gray_bytes(frame.instance))
            self._put(f"{folder}/part.png", gray_bytes(frame.part))

    def add_panorama(
        self,
        panorama: Panorama,
        rgb: npt.NDArray[np.uint8] | None,
        instance: npt.NDArray[np.uint16] | None,
    ) -> None:
        """Write what there is of one panorama's colours (H, W, 3) and node ids (H, W)."""
        folder = panorama_folder(panorama.index)
        if rgb is not None:
            kind = self.writer.options.rgb
            self._put(f"{folder}/rgb.{kind}", rgb_bytes(rgb, kind))
        if instance is not None:
            self._put(f"{folder}/instance.png", gray_bytes(instance))

    def finish(
        self, visibility: Visibility, observability: Observability | None = None
    ) -> ManifestEntry:
        """Write the records, then show the scene: its manifest line first, the folder last."""
        bundle = self.bundle
        files = content_files(bundle)
        for name, data in files.items():
            self._put(name, data)
        self._put(VISIBILITY_FILE, record_bytes(visibility))
        if observability is not None:
            self._put(OBSERVABILITY_FILE, record_bytes(observability))
        for camera in bundle.cameras:
            self._put(f"{view_folder(camera.index)}/view.json", record_bytes(camera))
        for panorama in bundle.panoramas:
            self._put(f"{panorama_folder(panorama.index)}/panorama.json", record_bytes(panorama))
        hazards = Counter(anomaly.hazard for anomaly in bundle.anomalies.anomalies)
        entry = ManifestEntry(
            id=bundle.scene.id,
            index=bundle.scene.index,
            twin_of=bundle.scene.twin_of,
            home=bundle.scene.home.id,
            split=bundle.split,
            anomalies=len(bundle.anomalies.anomalies),
            hazards=dict(sorted(hazards.items())),
            lookalikes=len(bundle.anomalies.lookalikes),
            objects=len(bundle.scene.objects),
            views=len(bundle.cameras),
            all_visible=visibility.all_visible,
            content_sha256=content_sha256(files),
            files=dict(sorted(self._hashes.items())),
        )
        assets = tuple(sorted({item.asset for item in bundle.scene.objects}))
        drawn = self.writer.renderer if visibility.views else None
        done = FinishedScene(entry=entry, assets=assets, renderer=drawn)
        show(self.writer.root, self._partial, done)
        return entry

    def _put(self, name: str, data: bytes) -> None:
        path = self._partial / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        self._hashes[name] = sha256_hex(data)


def show(root: Path, partial: Path, done: FinishedScene) -> None:
    """Put a scene that is written whole into place: its line first, then its folder."""
    # Synced together, so that the disk writes one file while the next is being encoded. A full
    # disk shows here at the latest.
    for name in sorted(done.entry.files):
        sync_file(partial / name)
    for folder in sorted({p.parent for p in partial.rglob("*")}):
        sync_folder(folder)
    entries = root / BUILD_FOLDER / "entries"
    entries.mkdir(parents=True, exist_ok=True)
    replace_file(entries / f"{done.entry.id}.json", record_bytes(done))
    target = root / "scenes" / done.entry.id
    target.parent.mkdir(exist_ok=True)
    take_away(root, done.entry.id)
    os.replace(partial, target)
    sync_folder(target.parent)


def whole(root: Path, entry: ManifestEntry) -> bool:
    """True when a scene's folder holds the files of its manifest line, byte for byte.

    Files that are not sdgen's (notes, a desktop's ``.DS_Store``) are nobody's business.
    """
    folder = root / "scenes" / entry.id
    if folder.is_symlink() or not folder.is_dir():
        return False
    found = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if not p.is_dir()}
    if {name for name in found if is_ours(name)} != set(entry.files):
        return False
    paths = {folder / name: digest for name, digest in entry.files.items()}
    # A link could lead anywhere, reading a pipe would wait for ever.
    if any(path.is_symlink() or not path.is_file() for path in paths):
        return False
    return all(file_sha256(path) == digest for path, digest in paths.items())
