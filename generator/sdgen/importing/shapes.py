"""Shapes that wrappers name instead of meshes, as triangles; rotations as wrappers write them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sdgen.geometry import Array, quat_from_axis_angle, rotation_matrix
from sdgen.importing.scan import Paint, Piece

#: Sides of what is round.
_SIDES = 32
#: Rotations closer to quarter turns than this are meant as such (ReplicaCAD writes 1.565 for a
#: right angle, and a fridge of it leans by 11 mm).
_QUARTER_RAD = 0.01


def box(size_m: Sequence[float], paint: Paint) -> Piece:
    """A box around the origin."""
    import trimesh

    return _piece(trimesh.creation.box(extents=_sizes(size_m, 3)), paint)


def cylinder(radius_m: float, length_m: float, paint: Paint) -> Piece:
    """A cylinder along Z around the origin, its picture once round it."""
    import trimesh

    radius, length = _sizes((radius_m, length_m), 2)
    made = trimesh.creation.cylinder(radius=radius, height=length, sections=_SIDES)
    piece = _piece(made, paint)
    if paint.image is None:
        return piece
    corners = piece.triangles.reshape(-1, 3)
    turn = np.arctan2(corners[:, 1], corners[:, 0]).reshape(-1, 3) / (2 * math.pi) + 0.5
    turn += (turn < turn.max(axis=1, keepdims=True) - 0.5) * 1.0  # not backwards over the seam
    uvs = np.column_stack([turn.ravel(), corners[:, 2] / length + 0.5])
    flat = np.abs(np.cross(*_sides(corners))[:, 2]) > 0.9 * np.linalg.norm(
        np.cross(*_sides(corners)), axis=1
    )
    lid = np.repeat(flat, 3)
    uvs[lid] = corners[lid, :2] / (2 * radius) + 0.5
    faces = np.arange(len(corners)).reshape(-1, 3)
    return Piece(corners, faces, uvs, None, paint)


def sphere(radius_m: float, paint: Paint) -> Piece:
    """A ball around the origin."""
    import trimesh

    (radius,) = _sizes((radius_m,), 1)
    return _piece(trimesh.creation.icosphere(subdivisions=3, radius=radius), paint)


def ellipsoid(radii_m: Sequence[float], paint: Paint) -> Piece:
    """An ellipsoid around the origin."""
    return sphere(1.0, paint).moved(np.diag([*_sizes(radii_m, 3), 1.0]))


def capsule(radius_m: float, length_m: float, paint: Paint) -> Piece:
    """A cylinder along Z with round ends beyond ``length_m``, around the origin."""
    import trimesh

    radius, length = _sizes((radius_m, length_m), 2)
    made = trimesh.creation.capsule(height=length, radius=radius, count=(_SIDES, 16))
    made.apply_translation([0, 0, -float(made.bounds.mean(axis=0)[2])])
    return _piece(made, paint)


def from_to(start_m: Sequence[float], end_m: Sequence[float]) -> tuple[Array, float]:
    """Where a shape along Z lies between two points (4x4), and how long it is."""
    start, end = np.asarray(start_m, float), np.asarray(end_m, float)
    along = end - start
    length = float(np.linalg.norm(along))
    if not math.isfinite(length) or length < 1e-9:
        raise ValueError("fromto: the two points are one")
    z = along / length
    x = np.cross([0.0, 1.0, 0.0] if abs(z[1]) < 0.9 else [1.0, 0.0, 0.0], z)
    x /= np.linalg.norm(x)
    out = np.eye(4)
    out[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    out[:3, 3] = (start + end) / 2
    return out, length


def pose(position_m: Sequence[float], rotation: Array) -> Array:
    """4x4 of a position and a 3x3 rotation, quarter turns made exact."""
    out = np.eye(4)
    rounded = np.round(rotation)
    quarter = np.abs(rotation - rounded).max() < _QUARTER_RAD
    out[:3, :3] = rounded if quarter else rotation
    out[:3, 3] = position_m
    return out


def rpy(angles_rad: Sequence[float]) -> Array:
    """3x3 of URDF's and SDF's roll, pitch, yaw: about fixed X, then Y, then Z."""
    return euler(angles_rad, "XYZ")


def euler(angles_rad: Sequence[float], order: str) -> Array:
    """3x3 of three turns; axes in lower case turn along, in upper case stay fixed (MJCF)."""
    out = np.eye(3)
    for axis, angle in zip(order, angles_rad, strict=True):
        c, s = math.cos(angle), math.sin(angle)
        k = "xyz".index(axis.lower())
        turn = np.eye(3)
        i, j = (k + 1) % 3, (k + 2) % 3
        turn[i, i], turn[i, j], turn[j, i], turn[j, j] = c, -s, s, c
        out = out @ turn if axis.islower() else turn @ out
    return out


def least_turn(start: Sequence[float] | Array, end: Sequence[float] | Array) -> Array:
    """3x3 of the least turn that takes one direction to another, about X or Y if to its opposite.
    Neither is zero."""
    a, b = (np.asarray(one, dtype=float) / np.linalg.norm(one) for one in (start, end))
    axis = np.cross(a, b)
    size, along = float(np.linalg.norm(axis)), float(a @ b)
    if size < 1e-9:
        if along > 0:
            return np.eye(3)
        side = np.eye(3)[0 if abs(a[0]) < 0.9 else 1]
        axis = side - a * (a @ side)
    return rotation_matrix(quat_from_axis_angle(axis.tolist(), math.atan2(size, along)))


def _piece(mesh: object, paint: Paint) -> Piece:
    vertices = np.asarray(mesh.vertices, dtype=np.float64)  # type: ignore[attr-defined]
    faces = np.asarray(mesh.faces, dtype=np.int64)  # type: ignore[attr-defined]
    return Piece(vertices, faces, None, None, paint)


def _sides(corners: Array) -> tuple[Array, Array]:
    triangles = corners.reshape(-1, 3, 3)
    return triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]


def _sizes(values: Sequence[float], count: int) -> tuple[float, ...]:
    sizes = tuple(float(v) for v in values)
    if len(sizes) != count or not all(math.isfinite(v) and v > 0 for v in sizes):
        raise ValueError(f"{list(sizes)} are no sizes")
    return sizes
