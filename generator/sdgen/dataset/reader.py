"""Opens a data set: records at once, pictures when asked for. Files may come from anybody."""

from __future__ import annotations

import json
import operator
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import accumulate, islice
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np
import numpy.typing as npt

from sdgen.catalog.records import Catalog, canonical_sha256
from sdgen.dataset.disk import sha256_hex
from sdgen.dataset.images import read_gray, read_rgb
from sdgen.dataset.opening import open_info, read_manifest, refuse_incomplete
from sdgen.dataset.records import VISIBILITY_FILE, Kind, ManifestEntry
from sdgen.dataset.scene_folder import view_folder
from sdgen.dataset.text import read_bytes, read_lines, read_record, to_record
from sdgen.errors import InputError, did_you_mean
from sdgen.library.records import AssetInfo
from sdgen.scene import (
    Anomalies,
    Camera,
    Graph,
    Household,
    PhysicsReport,
    Record,
    Scene,
    Visibility,
)

if TYPE_CHECKING:
    import networkx as nx

    from sdgen.dataset.graph_views import GraphView

R = TypeVar("R", bound=Record)


@dataclass(frozen=True)
class SceneItem:
    """One scene: records read on first use, arrays on every use. Raises InputError, located."""

    root: Path
    entry: ManifestEntry
    graph_view: GraphView = "full"

    @property
    def id(self) -> str:
        """``000041``, ``000041-twin`` or ``000041-undo-a00``."""
        return self.entry.id

    @property
    def folder(self) -> Path:
        """The scene's folder."""
        return self.root / "scenes" / self.entry.id

    def where(self, name: str) -> str:
        """How errors call a file of this scene."""
        return f"scenes/{self.entry.id}/{name}"

    def file(self, name: str) -> bytes:
        """A file of the scene as bytes, those that the manifest has the digest of.

        Raises InputError for one that is missing, changed, no plain file or led to by a link.
        """
        where = self.where(name)
        # A linked folder on the way would lead out of the data set as well as a linked file.
        way = accumulate(where.split("/"), os.path.join, initial=os.fspath(self.root))
        if any(map(os.path.islink, islice(way, 1, None))):
            raise InputError([f"{where}: a symbolic link leads elsewhere"])
        content = read_bytes(self.folder / name, where)
        if sha256_hex(content) != self.entry.files.get(name):
            raise InputError([f"{where}: changed since it was written (sdgen validate)"])
        return content

    def read(self, model: type[R], name: str) -> R:
        """A file of the scene as a record."""
        return read_record(model, self.folder / name, self.where(name))

    @cached_property
    def scene(self) -> Scene:
        """``scene.json``."""
        return self.read(Scene, "scene.json")

    @cached_property
    def scene_graph(self) -> Graph:
        """``graph.json``."""
        return self.read(Graph, "graph.json")

    @property
    def graph(self) -> nx.MultiDiGraph:
        """The scene graph as ``networkx.MultiDiGraph``, in the data set's ``graph_view``."""
        from sdgen.dataset.graph_views import to_networkx

        return to_networkx(self.scene_graph, self.visibility, self.graph_view)

    @cached_property
    def anomalies(self) -> Anomalies:
        """``anomalies.json``."""
        return self.read(Anomalies, "anomalies.json")

    @cached_property
    def household(self) -> Household:
        """``household.json``."""
        return self.read(Household, "household.json")

    @cached_property
    def physics(self) -> PhysicsReport:
        """``physics.json``."""
        return self.read(PhysicsReport, "physics.json")

    @cached_property
    def visibility(self) -> Visibility:
        """``visibility.json``."""
        return self.read(Visibility, VISIBILITY_FILE)

    @cached_property
    def cameras(self) -> tuple[Camera, ...]:
        """``view.json`` of every view."""
        return tuple(
            self.read(Camera, f"{view_folder(k)}/view.json") for k in range(self.entry.views)
        )

    def rgb_path(self, view: int) -> Path | None:
        """The colour picture of a view, None when the build wrote none."""
        for kind in ("png", "jpg"):
            if self.has(view, f"rgb.{kind}"):
                return self.folder / view_folder(view) / f"rgb.{kind}"
        return None

    def has(self, view: int, name: str) -> bool:
        """True when the manifest lists this file of a view."""
        return f"{view_folder(view)}/{name}" in self.entry.files

    def rgb(self, view: int) -> npt.NDArray[np.uint8]:
        """Colours of a view, (H, W, 3) uint8."""
        path = self.rgb_path(view)
        name = path.name if path is not None else "rgb.png"
        where = self.where(f"{view_folder(view)}/{name}")
        return read_rgb(self.folder / view_folder(view) / name, self._size(view), where)

    def depth_mm(self, view: int) -> npt.NDArray[np.uint16]:
        """Planar depth of a view as stored, (H, W) uint16 millimetres, 0 = nothing."""
        return self._gray(view, "depth.png", 16)

    def depth(self, view: int) -> npt.NDArray[np.float32]:
        """Planar depth of a view, (H, W) float32 metres, 0 = nothing."""
        return np.asarray(self.depth_mm(view) / np.float32(1000), dtype=np.float32)

    def instance(self, view: int) -> npt.NDArray[np.uint16]:
        """Node id of every pixel of a view, (H, W) uint16, 0 = nothing."""
        return self._gray(view, "instance.png", 16)

    def part(self, view: int) -> npt.NDArray[np.uint8]:
        """1-based index into the object's drawn parts, (H, W) uint8, 0 for structures."""
        return np.asarray(self._gray(view, "part.png", 8), dtype=np.uint8)

    def _gray(self, view: int, name: str, bits: int) -> npt.NDArray[np.uint16]:
        path = self.folder / view_folder(view) / name
        where = self.where(f"{view_folder(view)}/{name}")
        return read_gray(path, self._size(view), bits, where)

    def _size(self, view: int) -> tuple[int, int]:
        camera = self.cameras[view]
        return camera.width, camera.height


class Dataset(Sequence[SceneItem]):
    """A data set as a sequence of scenes, in the order of their index (twins left out).

    ``split`` keeps one of ``train``, ``val``, ``test``; ``twins`` gives each scene's benign twin
    instead, ``toggles`` those in which one anomaly is undone (with both: all of these);
    ``graph_view`` says what the scenes' ``.graph`` shows. Works as a map-style data set
    of PyTorch; picklable. Raises InputError for a folder that is no data set, or one that lacks
    scenes it was finished with (``partial`` opens what is left of it, and takes its catalogue for
    what it is).
    """

    def __init__(
        self,
        path: str | Path,
        split: str | None = None,
        twins: bool = False,
        graph_view: GraphView = "full",
        partial: bool = False,
        toggles: bool = False,
    ) -> None:
        self.path = Path(path)
        self.split = split
        self.twins = twins
        self.toggles = toggles
        self.graph_view = graph_view
        self.partial = partial
        self.info = open_info(self.path)
        if split is not None and split not in self.info.splits:
            known = list(self.info.splits)
            raise InputError([f"{self.path}: no split {split!r}{did_you_mean(split, known)}"])
        self.entries = read_manifest(self.path)
        if not partial:
            refuse_incomplete(self.path, self.info, self.entries)
        self._shown = tuple(
            entry
            for entry in self.entries
            if entry.kind in self._kinds and split in (None, entry.split)
        )

    def __repr__(self) -> str:
        counts, shown = self.info.counts, len(self)
        part = f" of {self.split}" if self.split is not None else ""
        noun = " and ".join(kind + "s" * (shown != 1) for kind in self._kinds)
        views = f"{self.info.options.views} views" if self.info.options.sensors else "no pictures"
        return (
            f"<sdgen.Dataset {str(self.path)!r}: {shown} {noun}{part}, {views}, "
            f"{counts.anomalies} anomalies of {len(self.info.hazards_enabled)} hazards, "
            f"seed {self.info.seed}>"
        )

    @property
    def _kinds(self) -> tuple[Kind, ...]:
        asked: tuple[tuple[Kind, bool], ...] = (("twin", self.twins), ("toggle", self.toggles))
        return tuple(kind for kind, wanted in asked if wanted) or ("scene",)

    def __len__(self) -> int:
        return len(self._shown)

    def __getitem__(self, index: int) -> SceneItem:  # type: ignore[override]
        return SceneItem(self.path, self._shown[operator.index(index)], self.graph_view)

    def __iter__(self) -> Iterator[SceneItem]:
        return (SceneItem(self.path, entry, self.graph_view) for entry in self._shown)

    def scene(self, scene_id: str) -> SceneItem:
        """The scene of this id, twins too. Raises InputError when there is none."""
        if scene_id in self._by_id:
            return SceneItem(self.path, self._by_id[scene_id], self.graph_view)
        hint = did_you_mean(scene_id, list(self._by_id))
        raise InputError([f"{self.path}: no scene {scene_id!r}{hint}"])

    @cached_property
    def _by_id(self) -> Mapping[str, ManifestEntry]:
        return {entry.id: entry for entry in self.entries}

    def graph(self, index: int, graph_view: GraphView = "full") -> nx.MultiDiGraph:
        """The graph of a scene as ``networkx.MultiDiGraph``; see ``graph_views``."""
        return replace(self[index], graph_view=graph_view).graph

    @cached_property
    def catalog(self) -> Catalog:
        """The catalogue the build used. Raises InputError for another one: labels would not follow
        from it."""
        catalog = to_record(Catalog, self._catalogue, "catalogue.json")
        if not self.partial and self.catalogue_sha256 != self.info.catalogue_sha256:
            raise InputError(["catalogue.json: not the catalogue whose digest dataset.json has"])
        return catalog

    @cached_property
    def catalogue_sha256(self) -> str:
        """Digest of ``catalogue.json`` as it was written: one of an older version lacks keys that
        its record has by now. Raises InputError."""
        try:
            return canonical_sha256(json.loads(self._catalogue))
        except ValueError as error:
            raise InputError([f"catalogue.json: {error}"]) from None

    @cached_property
    def _catalogue(self) -> bytes:
        return read_bytes(self.path / "catalogue.json", "catalogue.json")

    @cached_property
    def infos(self) -> Mapping[str, AssetInfo]:
        """Records of the models the scenes use, by id."""
        assets = read_lines(AssetInfo, self.path / "assets.jsonl", "assets.jsonl")
        return {asset.id: asset for asset in assets}
