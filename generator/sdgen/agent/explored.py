"""What an agent saw, as a scene of a data set whose views are its pictures: for any detector."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from sdgen.agent.eyes import Look
from sdgen.dataset import SceneItem
from sdgen.errors import UsageError
from sdgen.scene import Anomalies, Camera, Frame, Graph, Visibility
from sdgen.truth.visibility import visibility_of


@dataclass(frozen=True, repr=False)
class Explored(SceneItem):
    """A scene as one agent saw it: its views are the agent's pictures, its graph is made out of
    them. It has no labels and no true graph; ``scene`` is there for who makes out the graph, and
    detectors keep off it."""

    looks: tuple[Look, ...] = ()

    @cached_property
    def cameras(self) -> tuple[Camera, ...]:
        """The cameras of the pictures, numbered."""
        return tuple(
            look.camera.model_copy(update={"index": k}) for k, look in enumerate(self.looks)
        )

    @cached_property
    def anomalies(self) -> Anomalies:
        """Raises UsageError: what an agent saw has no labels."""
        raise UsageError("what an agent saw has no anomalies.json: they are to be found")

    @cached_property
    def scene_graph(self) -> Graph:
        """Raises UsageError: of what an agent saw there is ``shown_graph``."""
        raise UsageError("what an agent saw has no graph.json: shown_graph is made out of it")

    def has(self, view: int, name: str) -> bool:
        """Whether a picture has what this file would hold."""
        return name in ("rgb.png", "depth.png", "instance.png", "part.png")

    def rgb_path(self, view: int) -> None:
        """There are no files."""
        return

    def rgb_digest(self, view: int) -> str:
        """What tells a picture's colours from any other's: sha256."""
        return hashlib.sha256(self.looks[view].rgb.tobytes()).hexdigest()

    def rgb(self, view: int) -> npt.NDArray[np.uint8]:
        """Colours of a picture, (H, W, 3)."""
        return self.looks[view].rgb

    def depth_mm(self, view: int) -> npt.NDArray[np.uint16]:
        """Planar depth of a picture, (H, W), millimetres."""
        return self.looks[view].depth_mm

    def instance(self, view: int) -> npt.NDArray[np.uint16]:
        """Node ids of a picture, (H, W)."""
        return self.looks[view].instance

    def part(self, view: int) -> npt.NDArray[np.uint8]:
        """Parts of a picture, (H, W)."""
        return self.looks[view].part

    @cached_property
    def visibility(self) -> Visibility:
        """What the pictures show of each object; of anomalies it says nothing."""
        frames = (
            Frame(camera, look.rgb, look.depth_mm, look.instance, look.part, {})
            for camera, look in zip(self.cameras, self.looks, strict=True)
        )
        size = (self.cameras[0].width, self.cameras[0].height) if self.looks else (1, 1)
        return visibility_of(self.scene, (), frames, *size)

    @cached_property
    def shown_graph(self) -> Graph:
        """What can be made out of the home from the pictures."""
        if not self.looks:
            return Graph(nodes=(), edges=())
        return self.perceived.graph


def explored(item: SceneItem, looks: Iterable[Look]) -> Explored:
    """A scene as these pictures show it."""
    seen = tuple(looks)
    told = {"views": len(seen), "anomalies": 0, "hazards": {}, "lookalikes": 0}
    return Explored(
        item.root,
        item.entry.model_copy(update=told),
        "perceived",
        checked=item.checked,
        eyes=item.eyes,
        looks=seen,
    )
