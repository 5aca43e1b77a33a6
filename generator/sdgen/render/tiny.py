"""The CPU renderer that is part of Bullet: slow, but starts everywhere."""

from __future__ import annotations

from collections.abc import Collection
from typing import ClassVar

import numpy as np
import numpy.typing as npt

from sdgen.library import Library
from sdgen.physics.bullet import pb
from sdgen.render.bullet import BulletGraphics
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.scene import Camera, Scene


class TinyRenderer(Renderer):
    """Bullet's TinyRenderer."""

    name: ClassVar[str] = "the CPU renderer"
    renderer_string = "TinyRenderer"

    def __init__(self) -> None:
        self._graphics = BulletGraphics(pb.ER_TINY_RENDERER, face_levels=False)

    @staticmethod
    def probe() -> Probe:
        """It starts everywhere."""
        return Probe(True, TinyRenderer.renderer_string)

    def load(self, library: Library, scene: Scene) -> None:
        """Put ``scene`` in place of what was loaded before."""
        self._graphics.load(library, scene)

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of the loaded scene these nodes alone, by id; None: all."""
        self._graphics.show_only(node_ids)

    def draw(self, camera: Camera) -> Picture:
        """What ``camera`` sees of the loaded scene."""
        return self._graphics.draw(camera)

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """Its colours alone, ``factor`` times as many pixels along each side."""
        return self._graphics.draw_colours(camera, factor)

    def close(self) -> None:
        """Disconnect; a second call does nothing."""
        self._graphics.close()
