"""Pinhole cameras in OpenCV's convention: x right, y down, z forward; pixel centres at integers."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from sdgen.geometry import Array, apply, inverse
from sdgen.scene import Camera

#: Horizontal field of view, like that of common RGB-D cameras (Kinect v2: 70.6°); 55.4° high
#: at 4:3.
FOV_X_RAD = math.radians(70.0)
#: Nothing is nearer to an eye (it has 0.3 m of free space), nothing in a home further away.
NEAR_M = 0.05
FAR_M = 60.0

K = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
Matrix4 = tuple[
    tuple[float, float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float, float],
    tuple[float, float, float, float],
]


@cache
def intrinsics(width: int, height: int, fov_x_rad: float = FOV_X_RAD) -> K:
    """``K`` of a camera with square pixels whose axis meets the middle of the image.

    Pixel (0, 0) covers the square from −0.5 to 0.5, so the middle is at ((w − 1)/2, (h − 1)/2).
    """
    focal = width / (2.0 * math.tan(fov_x_rad / 2.0))
    return (
        (focal, 0.0, (width - 1) / 2.0),
        (0.0, focal, (height - 1) / 2.0),
        (0.0, 0.0, 1.0),
    )


def matrix4(values: Array) -> Matrix4:
    """A 4x4 array as the tuples a :class:`~sdgen.scene.Camera` holds."""
    a, b, c, d = ((float(r[0]), float(r[1]), float(r[2]), float(r[3])) for r in values)
    return (a, b, c, d)


def project(camera: Camera, points_m: Array) -> tuple[Array, Array]:
    """Pixels (N, 2) and depths (N,), planar Z in metres, of world points (N, 3).

    Points behind the camera have a depth ≤ 0 and meaningless pixels.
    """
    seen = apply(inverse(np.asarray(camera.world_from_camera)), points_m)
    depth = seen[:, 2]
    safe = np.where(np.abs(depth) < 1e-9, 1e-9, depth)
    k = np.asarray(camera.K)
    u = k[0, 0] * seen[:, 0] / safe + k[0, 1] * seen[:, 1] / safe + k[0, 2]
    v = k[1, 1] * seen[:, 1] / safe + k[1, 2]
    return np.stack([u, v], axis=1), depth
