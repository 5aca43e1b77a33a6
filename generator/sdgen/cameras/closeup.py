"""A small picture of one thing and what is around it, as a view of its home shows it."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.cameras.pinhole import FAR_M, NEAR_M, intrinsics, matrix4, project
from sdgen.cameras.sight import HEIGHT, WIDTH
from sdgen.geometry import Array
from sdgen.scene import Camera

#: A close-up is so many times as wide as the thing, so that what it lies on is plain to see, and
#: never a smaller part of the view, (pixels at the reference size).
_AROUND, _LEAST = 3.2, 120.0


def close_up(
    world_from_camera: Array, points_m: Array, room_id: int, size: tuple[int, int]
) -> Camera:
    """A camera of ``size`` (width, height) where a view stands, that shows the part of the view's
    picture around ``points_m`` (N, 3), all of which are before it, or all of the picture."""
    whole = _camera(
        world_from_camera, np.asarray(intrinsics(WIDTH, HEIGHT)), room_id, WIDTH, HEIGHT
    )
    pixels, depth = project(whole, points_m)
    pixels = np.clip(pixels[depth > NEAR_M], (0.0, 0.0), (WIDTH, HEIGHT))
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    width, height = size
    across = max(
        _LEAST, _AROUND * float(max(high[0] - low[0], (high[1] - low[1]) * width / height))
    )
    across = min(across, float(WIDTH))
    shown = np.array([across, across * height / width])
    # Of the picture itself, as far as there is some on either side.
    corner = np.clip((low + high - shown) / 2, (0.0, 0.0), np.array([WIDTH, HEIGHT]) - shown)
    zoom = width / across
    k = np.asarray(intrinsics(WIDTH, HEIGHT)).copy()
    # Pixel centres are at whole numbers: the corner of the first pixel is at -0.5.
    k[:2, 2] = (k[:2, 2] + 0.5 - corner) * zoom - 0.5
    k[[0, 1], [0, 1]] *= zoom
    return _camera(world_from_camera, k, room_id, width, height)


def in_picture(camera: Camera, boxes_m: Array) -> npt.NDArray[np.bool_]:
    """Which world boxes, low and high corners (N, 2, 3), a camera may show some of, (N,)."""
    ends = np.array([(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    corners = boxes_m[:, ends, [0, 1, 2]].reshape(-1, 3)
    pixels, depth = (values.reshape(len(boxes_m), 8, -1) for values in project(camera, corners))
    ahead = depth[..., 0] > NEAR_M
    out = ahead.any(axis=1)
    # Of a box that reaches behind the camera nobody knows where it ends in the picture.
    for axis, side in ((0, camera.width), (1, camera.height)):
        along = pixels[..., axis]
        beyond = (along < -0.5).all(axis=1) | (along > side - 0.5).all(axis=1)
        out &= ~(beyond & ahead.all(axis=1))
    return np.asarray(out)


def _camera(pose: Array, k: Array, room_id: int, width: int, height: int) -> Camera:
    first, second, third = ((float(r[0]), float(r[1]), float(r[2])) for r in k)
    return Camera(
        index=0,
        kind="near",
        room_id=room_id,
        width=width,
        height=height,
        K=(first, second, third),
        world_from_camera=matrix4(pose),
        near_m=NEAR_M,
        far_m=FAR_M,
    )
