"""What lies outside an open front door: sky, a hedge on the horizon, a lawn.

The plugin clears to a fixed lilac that looks like a panel, so that an open door reads as a shut
one. Background pixels are painted by the elevation of their rays instead.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.scene import Camera

#: Elevation of a ray (sine) and the colour there, from straight down to straight up.
_ELEVATIONS = (-1.0, -0.35, -0.02, 0.0, 0.07, 0.08, 0.6, 1.0)
_COLOURS = (
    (168, 163, 152),
    (160, 168, 132),
    (122, 156, 84),
    (84, 124, 70),
    (104, 146, 86),
    (214, 230, 242),
    (142, 188, 234),
    (128, 176, 228),
)


def paint_outdoors(
    rgb: npt.NDArray[np.uint8], background: npt.NDArray[np.bool_], camera: Camera
) -> npt.NDArray[np.uint8]:
    """The picture (H, W, 3) with its ``background`` pixels (H, W) painted; a copy if there are
    any."""
    rows, columns = np.nonzero(background)
    if len(rows) == 0:
        return rgb
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    x = (columns - k[0, 2]) / k[0, 0]
    y = (rows - k[1, 2]) / k[1, 1]
    rise = (pose[2, 0] * x + pose[2, 1] * y + pose[2, 2]) / np.sqrt(x * x + y * y + 1.0)
    out: npt.NDArray[np.uint8] = rgb.copy()
    for channel in range(3):
        levels = [colour[channel] for colour in _COLOURS]
        out[rows, columns, channel] = np.rint(np.interp(rise, _ELEVATIONS, levels))
    return out
