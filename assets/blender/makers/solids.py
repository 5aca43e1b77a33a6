"""Short words for the simple bodies that toys and electric things are made of."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh
from toolkit.shapes import lathe, tube

from makers.convex import few_corners


def cylinder(
    radius: float,
    height: float,
    at=(0, 0, 0),
    mat: Material | None = None,
    n: int = 12,
    axis: str = "z",
    top: float | None = None,
) -> Mesh:
    """A cylinder or cone that starts at `at` and runs along an axis."""
    end = radius if top is None else top
    mesh = lathe([(0, 0), (radius, 0), (end, height), (0, height)], n, mat=mat)
    return along(mesh, axis).move(*at)


def along(mesh: Mesh, axis: str) -> Mesh:
    """Turn what was made along z to another axis."""
    if axis == "x":
        return mesh.turn(ry=math.pi / 2)
    return mesh.turn(rx=-math.pi / 2) if axis == "y" else mesh


def rod(a, b, radius: float, mat: Material, n: int = 6, end: float | None = None) -> Mesh:
    """A straight round bar between two points."""
    return tube([a, b], [radius, radius if end is None else end], n, mat=mat)


def wheel(
    radius: float, width: float, tyre: Material, hub: Material, side: int, n: int = 12
) -> Mesh:
    """A wheel about the y axis, centred on the origin; its hub shows on one side (+1: +Y)."""
    w = width / 2
    profile = [(0, -w), (radius, -w), (radius, w * 0.7), (radius * 0.62, w), (0, w * 0.7)]
    mesh = lathe(profile, n, mats=[tyre, hub], mat_of_segment=[0, 0, 0, 1])
    return mesh.turn(rx=-side * math.pi / 2)


def solids(*groups: list[Mesh]) -> list[np.ndarray]:
    """Collision: one light convex piece round each group of meshes, its foot kept whole."""
    rays = np.array([(math.cos(a), math.sin(a)) for a in np.arange(8) * math.pi / 4])
    pieces = []
    for group in groups:
        points = np.concatenate([m.v for m in group])
        low = points[points[:, 2] < points[:, 2].min() + 0.0015]
        foot = low[np.unique((low[:, :2] @ rays.T).argmax(0))]
        pieces.append(np.concatenate([foot, few_corners(points, 24)]))
    return pieces


def flattened(meshes: list[Mesh], depth: float) -> list[Mesh]:
    """Press the lowest `depth` of soft things flat, so that they stand; again on z = 0."""
    grounded(meshes)
    for mesh in meshes:
        mesh.v[:, 2] = np.maximum(mesh.v[:, 2], depth) - depth
    return meshes


def grown(meshes: list[Mesh], factor: float) -> list[Mesh]:
    """All meshes scaled about the origin."""
    for mesh in meshes:
        mesh.scale(factor)
    return meshes


def grounded(meshes: list[Mesh]) -> list[Mesh]:
    """All meshes moved so that the lowest point stands on z = 0."""
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for mesh in meshes:
        mesh.move(z=-low)
    return meshes
