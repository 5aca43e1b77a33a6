"""What lies outside the windows and an open front door: the world round the home, painted in.

Nothing is drawn there: pixels of the background and of clear panes get their colours by the
directions of their rays.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.render.backdrop.canvas import COLUMNS, ROWS, row_of
from sdgen.render.backdrop.world import panorama
from sdgen.render.landing import landings, seen_on
from sdgen.scene import Camera, Scene
from sdgen.vocabulary import DayTime

#: What windows call a pane that one sees through.
CLEAR_PANE = "pane"
#: So much of a pane's own colour stays: what it mirrors of a bright room.
GLASS = 0.06
GLASS_COLOUR = 235.0
#: A camera that exposes for a room sees the day a little too bright; and by lamplight, more of the
#: dusk than the eye outdoors.
_GAIN: dict[DayTime, float] = {"day": 1.28, "evening": 1.3, "night": 1.1}


class SeenOutside(NamedTuple):
    """Pixels through which one looks outdoors, the colours there (N, 3), 0 to 255, and how much of
    these one sees, (N,): panes are a little paler."""

    rows: npt.NDArray[np.int64]
    columns: npt.NDArray[np.int64]
    colours: Array
    share: Array


class Outside:
    """The world outside of one scene's home, at its hour."""

    def __init__(self, library: Library, scene: Scene) -> None:
        self._world = scene.home.outdoors, scene.home.daylight
        self._gain = _GAIN[scene.home.daylight.time]
        self._panes = clear_panes(library, scene)
        self._landings = landings(scene.home)

    def seen(
        self,
        instance: npt.NDArray[np.uint16],
        part: npt.NDArray[np.uint8],
        camera: Camera,
        wider: bool = False,
    ) -> SeenOutside:
        """What a camera sees of it in a picture of any size, by node and part of each pixel: where
        nothing is drawn (``instance`` 0) and on clear panes; ``wider``: and in pixels beside these.
        Through a doorway with a landing one sees that."""
        glass = np.zeros(instance.shape, dtype=bool)
        for object_id, number in self._panes:
            glass |= (instance == object_id) & (part == number)
        outdoors = (instance == 0) | glass
        if wider and outdoors.any():
            glass, outdoors = widened(glass), widened(outdoors)
        rows, columns = np.nonzero(outdoors)
        share = np.where(glass[rows, columns], 1.0 - GLASS, 1.0)
        if len(rows) == 0:
            return SeenOutside(rows, columns, np.zeros((0, 3)), share)
        k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
        factor = instance.shape[1] / camera.width
        u, v = (columns + 0.5) / factor - 0.5, (rows + 0.5) / factor - 0.5
        rays = np.stack(
            [(u - k[0, 2]) / k[0, 0], (v - k[1, 2]) / k[1, 1], np.ones(len(rows))], axis=1
        )
        rays = rays @ pose[:3, :3].T
        rise = rays[:, 2] / np.linalg.norm(rays, axis=1)
        turn = np.arctan2(rays[:, 1], rays[:, 0]) / (2 * math.pi) % 1.0
        colours = _brighter(_sampled(panorama(*self._world), turn, rise), self._gain)
        for landing in self._landings:
            there, on_it = seen_on(landing, pose[:3, 3], rays)
            colours[there] = on_it
        return SeenOutside(rows, columns, colours, share)

    def paint(
        self,
        rgb: npt.NDArray[np.uint8],
        instance: npt.NDArray[np.uint16],
        part: npt.NDArray[np.uint8],
        camera: Camera,
    ) -> npt.NDArray[np.uint8]:
        """A picture (H, W, 3) with what is seen of the world; a copy if there is any such pixel."""
        seen = self.seen(instance, part, camera)
        if len(seen.rows) == 0:
            return rgb
        share = seen.share[:, None]
        out: npt.NDArray[np.uint8] = rgb.copy()
        painted = seen.colours * share + GLASS_COLOUR * (1 - share)
        out[seen.rows, seen.columns] = np.rint(painted)
        return out


def widened(mask: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """A mask and the pixels beside it."""
    out: npt.NDArray[np.bool_] = mask.copy()
    out[1:] |= mask[:-1]
    out[:-1] |= mask[1:]
    across = out.copy()
    out[:, 1:] |= across[:, :-1]
    out[:, :-1] |= across[:, 1:]
    return out


def clear_panes(library: Library, scene: Scene) -> tuple[tuple[int, int], ...]:
    """Object and number (from 1) of the drawn parts through which one looks outdoors."""
    return tuple(
        (item.id, number)
        for item in scene.objects
        if item.category == "window"
        for number, name in enumerate(library.info(item.asset).variants[item.variant], start=1)
        if name == CLEAR_PANE
    )


def _brighter(colours: Array, gain: float) -> Array:
    """Colours (N, 3) times ``gain``: what would be brighter than white turns paler instead, so that
    a sky keeps its hue."""
    brighter = colours * gain
    over = np.maximum(brighter.max(axis=1, keepdims=True) / 255.0, 1.0)
    pale = 1.2 * (1.0 - 1.0 / over)
    return np.asarray(brighter / over * (1.0 - pale) + 255.0 * pale)


def _sampled(
    picture: npt.NDArray[np.uint8], turn: npt.NDArray[np.float64], rise: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """Colours (N, 3) of the world in these directions, between its pixels."""
    # Pixels of the picture hold half of the ones to their right and below.
    x, y = turn * COLUMNS - 1.0, np.clip(row_of(rise) - 0.5, 0, ROWS - 1)
    left, top = np.floor(x).astype(np.intp), np.minimum(y.astype(np.intp), ROWS - 2)
    across, down = (x - left).astype(np.float32), (y - top).astype(np.float32)
    right = (left + 1) % COLUMNS
    left, above = left % COLUMNS, top * COLUMNS
    flat = picture.reshape(-1, 3)
    out = np.zeros((len(x), 3), dtype=np.float32)
    for places, share in (
        (above + left, (1 - across) * (1 - down)),
        (above + right, across * (1 - down)),
        (above + COLUMNS + left, (1 - across) * down),
        (above + COLUMNS + right, across * down),
    ):
        out += flat.take(places, axis=0) * share[:, None]
    return out.astype(np.float64)
