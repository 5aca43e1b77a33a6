"""What a renderer is: something that loads a scene and draws cameras, and says what it is."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
import numpy.typing as npt

from sdgen.closing import Closing
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.scene import Camera, Scene


@dataclass(frozen=True)
class Probe:
    """Whether a renderer starts on this machine: its string, or why not and what would help."""

    works: bool
    renderer_string: str = ""
    reason: str = ""
    hint: str = ""


@dataclass(frozen=True)
class Picture:
    """What a camera sees: ``rgb`` (H, W, 3), ``depth_m`` (H, W) along the camera's axis (any value
    where nothing is), ``instance`` (H, W) node ids, 0 where nothing is, and ``part`` (H, W),
    1-based into the object's drawn parts, 0 for structures."""

    rgb: npt.NDArray[np.uint8]
    depth_m: Array
    instance: npt.NDArray[np.uint16]
    part: npt.NDArray[np.uint8]


class Renderer(Closing, Protocol):
    """Draws one scene at a time; a context manager. One a process: contexts of OpenGL
    get into each other's way.

    ``name`` is for people; ``renderer_string`` goes into ``dataset.json``: pictures are the same
    bytes wherever it is the same.
    """

    name: ClassVar[str]
    renderer_string: str

    @staticmethod
    def probe() -> Probe:
        """Whether it starts here; nothing is started in this process."""
        ...

    def load(self, library: Library, scene: Scene) -> None:
        """Put ``scene`` in place of what was loaded before."""
        ...

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of the loaded scene these nodes alone, by id; None: all."""
        ...

    def draw(self, camera: Camera, colours: bool = True) -> Picture:
        """What ``camera`` sees of the loaded scene, and of the world outside its windows; without
        ``colours``, ``rgb`` is black."""
        ...

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """Its colours alone, ``factor`` times as many pixels along each side."""
        ...

    def close(self) -> None:
        """Let go of the graphics; a second call does nothing."""
        ...
