"""Our cameras as OpenGL takes them, and its depth buffer as metres."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, inverse


def view_matrix(world_from_camera: Array) -> list[float]:
    """OpenGL view matrix, column-major, as Bullet takes it (x right, y up, z backward)."""
    flip = np.diag([1.0, -1.0, -1.0, 1.0])
    gl_from_world = flip @ inverse(world_from_camera)
    return [float(v) for v in gl_from_world.T.ravel()]


def projection_matrix(
    k: Array, x0: int, y0: int, width: int, height: int, near_m: float, far_m: float
) -> list[float]:
    """OpenGL projection, column-major, of the window of ``width`` x ``height`` pixels that
    begins at pixel (x0, y0) of the image ``k`` belongs to."""
    cx, cy = k[0, 2] - x0 + 0.5, k[1, 2] - y0 + 0.5
    out = np.zeros((4, 4))
    out[0, 0] = 2 * k[0, 0] / width
    out[1, 1] = 2 * k[1, 1] / height
    out[0, 2] = 1 - 2 * cx / width
    out[1, 2] = 2 * cy / height - 1
    out[2, 2] = -(far_m + near_m) / (far_m - near_m)
    out[2, 3] = -2 * far_m * near_m / (far_m - near_m)
    out[3, 2] = -1
    return [float(v) for v in out.T.ravel()]


def depth_from_buffer(buffer: npt.NDArray[np.floating], near_m: float, far_m: float) -> Array:
    """Planar Z in metres of OpenGL depth-buffer values in [0, 1]."""
    # In double precision: the buffer's last bits are centimetres at the end of a room.
    values = np.asarray(buffer, dtype=np.float64)
    return np.asarray(far_m * near_m / (far_m - (far_m - near_m) * values), dtype=np.float64)


def to_millimetres(depth_m: Array, seen: npt.NDArray[np.bool_]) -> npt.NDArray[np.uint16]:
    """16-bit millimetres; 0 where nothing was ``seen`` or beyond 65.535 m."""
    millimetres = np.rint(depth_m * 1000.0)
    millimetres[~(seen & (millimetres > 0) & (millimetres <= 65535))] = 0
    return millimetres.astype(np.uint16)


def scaled(k: Array, factor: int) -> Array:
    """``K`` of the same view with ``factor`` times as many pixels along each side."""
    out = np.array(k, dtype=np.float64)
    out[0] *= factor
    out[1] *= factor
    out[0, 2] = factor * (k[0, 2] + 0.5) - 0.5
    out[1, 2] = factor * (k[1, 2] + 0.5) - 0.5
    return out
