"""Panoramas out of a stream of frames: those of a turn are kept until the last of it is there."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from sdgen.cameras.turn import POLES_FROM, poles_of
from sdgen.render.equirect import stitched_ids, stitched_rgb
from sdgen.render.looks import as_seen
from sdgen.scene import Camera, Frame, Panorama

#: A panorama with its colours (H, W, 3) and node ids (H, W), as far as they are asked for.
Stitched = tuple[Panorama, npt.NDArray[np.uint8] | None, npt.NDArray[np.uint16] | None]


class Stitching:
    """Makes the panoramas of one scene from its frames, before cameras' looks are on them: corners
    that each view darkens would be stripes."""

    def __init__(self, panoramas: Sequence[Panorama], sensors: Collection[str]) -> None:
        self._of_view = {view: panorama for panorama in panoramas for view in panorama.views}
        self._sensors = sensors
        self._kept: list[Frame] = []

    def cameras(self, cameras: Sequence[Camera]) -> list[Camera]:
        """The scene's cameras, and behind each turn those of its panorama's poles."""
        return list(self._with_poles(cameras))

    def _with_poles(self, cameras: Sequence[Camera]) -> Iterator[Camera]:
        for camera in cameras:
            yield camera
            panorama = self._of_view.get(camera.index)
            if panorama is not None and camera.index == panorama.views[-1]:
                yield from poles_of(panorama, camera)

    def wants_only(self, frame: Frame) -> bool:
        """True for a frame that is none of the scene's views."""
        return frame.camera.index >= POLES_FROM

    def add(self, frame: Frame) -> Stitched | None:
        """Take the next frame; the panorama that it makes whole, if it does."""
        if frame.camera.index not in self._of_view and not self.wants_only(frame):
            return None
        self._kept.append(frame)
        first = self._kept[0].camera
        panorama = self._of_view[first.index]
        if len(self._kept) < len(panorama.views) + 2:
            return None
        kept, self._kept = self._kept, []
        rgb = ids = None
        if "rgb" in self._sensors:
            rgb = stitched_rgb(panorama, first, [one.rgb for one in kept])
            rgb = as_seen(rgb, panorama.look, wraps=True)
        if "instance" in self._sensors:
            ids = stitched_ids(panorama, first, [one.instance for one in kept])
        return panorama, rgb, ids
