"""Poses, boxes and matrices. The only place where layouts are converted.

Quaternions are xyzw, matrices row-major 4x4 for column vectors, lengths in metres.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Annotated

import numpy as np
import numpy.typing as npt
from pydantic import Field

Array = npt.NDArray[np.float64]

#: No coordinate of a home is further out, metres (or radians): what is computed of such numbers
#: stays exact to a tenth of a nanometre and overflows nowhere.
FARTHEST_M = 1e6
Coordinate = Annotated[float, Field(ge=-FARTHEST_M, le=FARTHEST_M)]
Vec2 = tuple[Coordinate, Coordinate]
Vec3 = tuple[Coordinate, Coordinate, Coordinate]
Quat = tuple[Coordinate, Coordinate, Coordinate, Coordinate]

#: What turns Y up, as glTF and Habitat have it, into Z up: (x, y, z)_ours = (x, -z, y)_theirs, 4x4.
Z_UP_FROM_Y_UP: Array = np.array(
    [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
)

#: The grid of quaternions: a thing 1 m long is turned by 2 µm at its end, below that of positions.
QUATERNION_STEP = 1e-6


def vec3(values: Iterable[float]) -> Vec3:
    """Three floats as a tuple."""
    x, y, z = values
    return (float(x), float(y), float(z))


def round_position(position_m: Iterable[float]) -> Vec3:
    """Position on the grid of 1e-5 m that labels are proved on."""
    return vec3(round(float(v), 5) + 0.0 for v in position_m)


def round_quat(quat_xyzw: Sequence[float]) -> Quat:
    """Unit quaternion rounded to 1e-6, with a sign convention (w ≥ 0) so that equal is equal."""
    q = np.asarray(quat_xyzw, dtype=float)
    q = q / np.linalg.norm(q)
    if q[3] < 0 or (abs(q[3]) < 5e-7 and q[int(np.argmax(np.abs(q)))] < 0):
        q = -q
    x, y, z, w = (round(float(v), 6) + 0.0 for v in q)
    return (x, y, z, w)


def quat_from_yaw(yaw_rad: float) -> Quat:
    """Quaternion of a turn about Z."""
    return (0.0, 0.0, math.sin(yaw_rad / 2), math.cos(yaw_rad / 2))


def yaw_of(quat_xyzw: Sequence[float]) -> float:
    """Heading of the object's +X axis in the XY plane, radians."""
    x, y, z, w = quat_xyzw
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def quat_from_axis_angle(axis: Sequence[float], angle_rad: float) -> Quat:
    """Quaternion of a turn by ``angle_rad`` about ``axis`` (need not be unit)."""
    a = np.asarray(axis, dtype=float)
    a = a / np.linalg.norm(a) * math.sin(angle_rad / 2)
    return (float(a[0]), float(a[1]), float(a[2]), math.cos(angle_rad / 2))


def rotation_matrix(quat_xyzw: Sequence[float]) -> Array:
    """3x3 rotation of a quaternion (normalised first)."""
    x, y, z, w = quat_xyzw
    size = math.sqrt(x * x + y * y + z * z + w * w)
    x, y, z, w = x / size, y / size, z / size, w / size
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def quat_from_matrix(rotation: Array) -> Quat:
    """Quaternion of a 3x3 rotation matrix (Shepperd's method, largest component first)."""
    m = rotation
    diagonal = np.array([m[0, 0], m[1, 1], m[2, 2], m.trace()])
    k = int(np.argmax(diagonal))
    q = np.empty(4)
    if k == 3:
        q[:] = (m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1 + m.trace())
    else:
        i, j = (k + 1) % 3, (k + 2) % 3
        q[k] = 1 + m[k, k] - m[i, i] - m[j, j]
        q[i] = m[i, k] + m[k, i]
        q[j] = m[j, k] + m[k, j]
        q[3] = m[j, i] - m[i, j]
    q /= np.linalg.norm(q)
    return (float(q[0]), float(q[1]), float(q[2]), float(q[3]))


def matrix(position_m: Sequence[float], quat_xyzw: Sequence[float]) -> Array:
    """``parent_from_child`` 4x4 of a pose."""
    out = np.zeros((4, 4))
    out[:3, :3] = rotation_matrix(quat_xyzw)
    out[:3, 3] = position_m
    out[3, 3] = 1.0
    return out


def inverse(transform: Array) -> Array:
    """Inverse of a rigid 4x4."""
    out = np.eye(4)
    out[:3, :3] = transform[:3, :3].T
    out[:3, 3] = -transform[:3, :3].T @ transform[:3, 3]
    return out


def lowest_highest(points_m: Array) -> tuple[Array, Array]:
    """The lowest and the highest corner, (3,), of the box around points (N, 3)."""
    # An axis in a row of its own: numpy is four times as fast along rows as across them.
    rows = np.ascontiguousarray(points_m.T)
    return np.asarray(rows.min(axis=1)), np.asarray(rows.max(axis=1))


def apply(transform: Array, points: Sequence[Sequence[float]] | Array) -> Array:
    """Transform (N, 3) points by a 4x4."""
    p = np.asarray(points, dtype=np.float64).reshape(-1, 3)
    moved: Array = p @ transform[:3, :3].T + transform[:3, 3]
    return moved


def joint_matrix(
    kind: str, origin_m: Sequence[float], axis: Sequence[float], value: float
) -> Array:
    """``object_from_part`` of a part hanging on a joint at ``value`` (radians or metres)."""
    out = np.eye(4)
    if kind == "prismatic":
        unit = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
        out[:3, 3] = unit * value
        return out
    rotation = rotation_matrix(quat_from_axis_angle(axis, value))
    origin = np.asarray(origin_m, dtype=float)
    out[:3, :3] = rotation
    out[:3, 3] = origin - rotation @ origin
    return out


def box_corners(low: Sequence[float], high: Sequence[float]) -> Array:
    """The eight corners of an axis-aligned box, (8, 3)."""
    return np.array(
        [[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    )


def moved_boxes(transforms: Array, boxes: Array) -> Array:
    """The boxes along the axes, lowest and highest corners (N, 2, 3), of boxes (N, 2, 3) that were
    moved by 4x4s (N, 4, 4)."""
    low, high = boxes.transpose(1, 0, 2)
    turns = transforms[:, :3, :3]
    at = np.einsum("nij,nj->ni", turns, (low + high) / 2) + transforms[:, :3, 3]
    reach = np.einsum("nij,nj->ni", np.abs(turns), (high - low) / 2)
    return np.stack([at - reach, at + reach], axis=1)


def look_at(eye_m: Sequence[float], target_m: Sequence[float]) -> Array:
    """``world_from_camera`` of an OpenCV camera (x right, y down, z forward), level horizon."""
    x, y, z = (float(b) - float(a) for a, b in zip(eye_m, target_m, strict=True))
    level = math.hypot(x, y)
    size = math.hypot(level, z)
    x, y, z, level = x / size, y / size, z / size, level / size
    # Right is (y, -x, 0) made unit, down is forward × right.
    return np.array(
        [
            [y / level, x * z / level, x, float(eye_m[0])],
            [-x / level, y * z / level, y, float(eye_m[1])],
            [0.0, -level, z, float(eye_m[2])],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
