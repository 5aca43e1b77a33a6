"""What lies outside the windows and an open front door: the world round the home, painted in.

The plugin clears to a fixed lilac, and can draw no pane that one sees through. Pixels of the
background and of clear panes are painted by the directions of their rays instead.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from sdgen.library import Library
from sdgen.render.landing import Landing, seen_on
from sdgen.render.panorama import COLUMNS, HIGHEST, LOWEST, ROWS, panorama
from sdgen.scene import Camera, Daylight, Outdoors, Scene

#: What windows call a pane that one sees through.
CLEAR_PANE = "pane"
#: So much of a pane's own colour stays: what it mirrors of a bright room.
GLASS = 0.06
GLASS_COLOUR = 235.0


def clear_panes(library: Library, scene: Scene) -> tuple[tuple[int, int], ...]:
    """Object and number (from 1) of the drawn parts through which one looks outdoors."""
    return tuple(
        (item.id, number)
        for item in scene.objects
        if item.category == "window"
        for number, name in enumerate(library.info(item.asset).variants[item.variant], start=1)
        if name == CLEAR_PANE
    )


def paint_outdoors(
    rgb: npt.NDArray[np.uint8],
    instance: npt.NDArray[np.uint16],
    part: npt.NDArray[np.uint8],
    panes: Sequence[tuple[int, int]],
    outdoors: Outdoors,
    daylight: Daylight,
    camera: Camera,
    landings: Sequence[Landing] = (),
) -> npt.NDArray[np.uint8]:
    """The picture (H, W, 3) with the world at that time of the day painted where nothing is drawn
    (``instance`` 0) and, a little paler, on the panes; a copy if there is any such pixel. Through a
    doorway with a landing one sees that."""
    glass = np.zeros(instance.shape, dtype=bool)
    for object_id, number in panes:
        glass |= (instance == object_id) & (part == number)
    rows, columns = np.nonzero((instance == 0) | glass)
    if len(rows) == 0:
        return rgb
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    rays = np.stack(
        [(columns - k[0, 2]) / k[0, 0], (rows - k[1, 2]) / k[1, 1], np.ones(len(rows))], axis=1
    )
    rays = rays @ pose[:3, :3].T
    rise = rays[:, 2] / np.linalg.norm(rays, axis=1)
    turn = np.arctan2(rays[:, 1], rays[:, 0]) / (2 * math.pi) % 1.0
    seen = _sampled(panorama(outdoors, daylight), turn, rise)
    for landing in landings:
        there, colours = seen_on(landing, pose[:3, 3], rays)
        seen[there] = colours
    share = np.where(glass[rows, columns], GLASS, 0.0)[:, None]
    out: npt.NDArray[np.uint8] = rgb.copy()
    out[rows, columns] = np.rint(seen * (1 - share) + GLASS_COLOUR * share)
    return out


def _sampled(
    picture: npt.NDArray[np.uint8], turn: npt.NDArray[np.float64], rise: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """Colours (N, 3) of the world in these directions, between its pixels."""
    x = turn * COLUMNS - 0.5
    y = np.clip((HIGHEST - rise) / (HIGHEST - LOWEST) * (ROWS - 1), 0, ROWS - 1)
    left, top = np.floor(x).astype(int), np.minimum(np.floor(y).astype(int), ROWS - 2)
    across, down = (x - left)[:, None], (y - top)[:, None]
    left, right = left % COLUMNS, (left + 1) % COLUMNS
    above = picture[top, left] * (1 - across) + picture[top, right] * across
    below = picture[top + 1, left] * (1 - across) + picture[top + 1, right] * across
    return np.asarray(above * (1 - down) + below * down, dtype=np.float64)
