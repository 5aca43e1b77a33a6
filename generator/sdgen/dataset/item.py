"""One scene of a data set: records at once, pictures when asked for. Files may be anybody's."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, islice
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np
import numpy.typing as npt

from sdgen.dataset.disk import sha256_hex
from sdgen.dataset.images import gray_of, rgb_of
from sdgen.dataset.notebook import BLUE, RED, figure, page
from sdgen.dataset.older import physics_as_now
from sdgen.dataset.records import OBSERVABILITY_FILE, VISIBILITY_FILE, ManifestEntry
from sdgen.dataset.scene_folder import panorama_folder, view_folder
from sdgen.dataset.text import read_bytes, to_record
from sdgen.errors import InputError
from sdgen.scene import (
    Anomalies,
    Camera,
    Graph,
    Household,
    Panorama,
    PhysicsReport,
    Record,
    Scene,
    Visibility,
)
from sdgen.truth.observable import Observability

if TYPE_CHECKING:
    import networkx as nx

    from sdgen.dataset.eyes import Eyes
    from sdgen.dataset.graph_views import GraphView
    from sdgen.perception import Perceived

R = TypeVar("R", bound=Record)


@dataclass(frozen=True, repr=False)
class SceneItem:
    """One scene: records read on first use, arrays on every use. Raises InputError, located.

    Files that changed since they were written are refused, unless not ``checked``. ``eyes`` make
    out its ``perceived`` graph: those that its data set hands it.
    """

    root: Path
    entry: ManifestEntry
    graph_view: GraphView = "full"
    twin_entry: ManifestEntry | None = None
    checked: bool = True
    eyes: Eyes | None = None

    @property
    def id(self) -> str:
        """``000041``, ``000041-twin`` or ``000041-undo-a00``."""
        return self.entry.id

    @property
    def twin(self) -> SceneItem | None:
        """Its benign twin, None when the data set has none (or this is one)."""
        if self.twin_entry is None:
            return None
        view, entry = self.graph_view, self.twin_entry
        return SceneItem(self.root, entry, view, checked=self.checked, eyes=self.eyes)

    @property
    def folder(self) -> Path:
        """The scene's folder."""
        return self.root / "scenes" / self.entry.id

    def __repr__(self) -> str:
        entry = self.entry
        return (
            f"<sdgen scene {entry.id!r} ({entry.split}): {entry.objects} objects, "
            f"{entry.anomalies} anomalies, {entry.lookalikes} lookalikes, {entry.views} views>"
        )

    def _repr_html_(self) -> str:
        entry = self.entry
        head = f"{entry.id}: {entry.home}, {entry.split}, {entry.objects} objects"
        wrong = [f"{a.hazard}: {a.message} ({a.notify})" for a in self.anomalies.anomalies]
        views = (self.figure(k, f"view {k}") for k in range(entry.views))
        return page(head, wrong or ["no hazard"], views)

    def figure(self, view: int, words: str) -> str:
        """A view as HTML with its boxes, red of anomalies and blue of lookalikes, and words."""
        if view >= self.entry.views or self.rgb_path(view) is None:
            return figure(None, (), words)
        colours = {near.object_id: BLUE for near in self.anomalies.lookalikes}
        colours |= {anomaly.object_id: RED for anomaly in self.anomalies.anomalies}
        shown = next((v.objects for v in self.visibility.views if v.view == view), ())
        boxes = [(o.bbox, colours[o.object_id]) for o in shown if o.object_id in colours]
        try:
            return figure(self.rgb(view), boxes, words)
        except InputError as error:
            return figure(None, (), f"{words}: {error}")

    def best_view(self) -> int:
        """The view that shows most of an anomaly; of a scene without one, the first of a room."""
        best = max(
            (
                (pixels, -view)
                for seen in self.visibility.anomalies
                for view, pixels in enumerate(seen.evidence_pixels)
            ),
            default=(0, 0),
        )
        if best[0]:
            return -best[1]
        return next((c.index for c in self.cameras if c.kind == "room"), 0)

    def where(self, name: str) -> str:
        """How errors call a file of this scene."""
        return f"scenes/{self.entry.id}/{name}"

    def file(self, name: str) -> bytes:
        """A file of the scene as bytes, those that the manifest has the digest of.

        Raises InputError for one that is missing, changed, no plain file or led to by a link.
        """
        where = self.where(name)
        if self.linked(name):
            raise InputError([f"{where}: a symbolic link leads elsewhere"])
        content = read_bytes(self.folder / name, where)
        if sha256_hex(content) != self.entry.files.get(name):
            raise InputError([f"{where}: changed since it was written (see sdgen validate)"])
        return content

    def linked(self, name: str) -> bool:
        """True when the file, or a folder on the way to it, is a symbolic link: it would lead out
        of the data set."""
        way = accumulate(self.where(name).split("/"), os.path.join, initial=os.fspath(self.root))
        return any(map(os.path.islink, islice(way, 1, None)))

    def read(self, model: type[R], name: str) -> R:
        """A file of the scene as a record."""
        return to_record(model, self._content(name), self.where(name))

    def _content(self, name: str) -> bytes:
        if self.checked:
            return self.file(name)
        return read_bytes(self.folder / name, self.where(name))

    @cached_property
    def scene(self) -> Scene:
        """``scene.json``."""
        return self.read(Scene, "scene.json")

    @cached_property
    def scene_graph(self) -> Graph:
        """``graph.json``."""
        return self.read(Graph, "graph.json")

    @cached_property
    def shown_graph(self) -> Graph:
        """The scene graph in the data set's ``graph_view``: what detectors read.

        ``full``: all that graph.json has. ``neutral``: what things are and where, with
        VirtualHome's five relations; no states, no tags and none of our further relations, which
        all but name some anomalies. ``perceived``: what can be made out from its pictures; see
        :attr:`perceived`. ValueError for another view.
        """
        from sdgen.dataset.graph_views import neutral

        if self.graph_view == "full":
            return self.scene_graph
        if self.graph_view == "neutral":
            return neutral(self.scene_graph)
        if self.graph_view == "perceived":
            return self.perceived.graph
        raise ValueError(f"graph_view {self.graph_view!r}: full, neutral or perceived expected")

    @cached_property
    def perceived(self) -> Perceived:
        """What can be made out of the scene from its pictures, as its data set's ``perception``
        says: a scene of its own, with the same ids, whose graph is built as the true one is.

        Raises InputError for a scene without depth and instance pictures, ValueError for an item
        that no data set has handed eyes.
        """
        if self.eyes is None:
            raise ValueError("only items of a Dataset are perceived: this one has no eyes")
        return self.eyes.perceive(self)

    @property
    def graph(self) -> nx.MultiDiGraph:
        """``shown_graph`` as ``networkx.MultiDiGraph``."""
        from sdgen.dataset.graph_views import to_networkx

        return to_networkx(self.shown_graph, self.graph_view)

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
        name = "physics.json"
        return to_record(PhysicsReport, self._content(name), self.where(name), physics_as_now)

    @cached_property
    def visibility(self) -> Visibility:
        """``visibility.json``."""
        return self.read(Visibility, VISIBILITY_FILE)

    @cached_property
    def observability(self) -> Observability | None:
        """``observability.json``; None where the scene was built without it. InputError, too, where
        it speaks of other anomalies than the scene has."""
        if OBSERVABILITY_FILE not in self.entry.files:
            return None
        found = self.read(Observability, OBSERVABILITY_FILE)
        told = [(one.anomaly_id, one.object_id) for one in found.anomalies]
        if told != [(one.id, one.object_id) for one in self.anomalies.anomalies]:
            where = self.where(OBSERVABILITY_FILE)
            raise InputError([f"{where}: anomalies: not those of anomalies.json"])
        return found

    @cached_property
    def cameras(self) -> tuple[Camera, ...]:
        """``view.json`` of every view."""
        return tuple(
            self.read(Camera, f"{view_folder(k)}/view.json") for k in range(self.entry.views)
        )

    @cached_property
    def panoramas(self) -> tuple[Panorama, ...]:
        """``panorama.json`` of every panorama; none unless the build had ``--equirect``."""
        names = sorted(name for name in self.entry.files if name.endswith("/panorama.json"))
        return tuple(
            self.read(Panorama, f"{panorama_folder(k)}/panorama.json") for k in range(len(names))
        )

    def panorama_rgb(self, index: int) -> npt.NDArray[np.uint8]:
        """Colours of a panorama, (H, W, 3) uint8."""
        for kind in ("png", "jpg"):
            name = f"{panorama_folder(index)}/rgb.{kind}"
            if name in self.entry.files:
                break
        return rgb_of(self._content(name), self._panorama_size(index), self.where(name))

    def panorama_instance(self, index: int) -> npt.NDArray[np.uint16]:
        """Node id of every pixel of a panorama, (H, W) uint16, 0 = nothing."""
        name = f"{panorama_folder(index)}/instance.png"
        size = self._panorama_size(index)
        return gray_of(self._content(name), size, 16, self.where(name))

    def rgb_path(self, view: int) -> Path | None:
        """The colour picture of a view, None when the build wrote none."""
        for kind in ("png", "jpg"):
            if self.has(view, f"rgb.{kind}"):
                return self.folder / view_folder(view) / f"rgb.{kind}"
        return None

    def rgb_digest(self, view: int) -> str | None:
        """What tells a view's colour picture from any other: sha256, None when there is none."""
        path = self.rgb_path(view)
        return None if path is None else self.entry.files[f"{view_folder(view)}/{path.name}"]

    def has(self, view: int, name: str) -> bool:
        """True when the manifest lists this file of a view."""
        return f"{view_folder(view)}/{name}" in self.entry.files

    def rgb(self, view: int) -> npt.NDArray[np.uint8]:
        """Colours of a view, (H, W, 3) uint8."""
        path = self.rgb_path(view)
        name = path.name if path is not None else "rgb.png"
        name = f"{view_folder(view)}/{name}"
        return rgb_of(self._content(name), self._size(view), self.where(name))

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
        name = f"{view_folder(view)}/{name}"
        return gray_of(self._content(name), self._size(view), bits, self.where(name))

    def _panorama_size(self, index: int) -> tuple[int, int]:
        panorama = self.panoramas[index]
        return panorama.width, panorama.height

    def _size(self, view: int) -> tuple[int, int]:
        camera = self.cameras[view]
        return camera.width, camera.height
