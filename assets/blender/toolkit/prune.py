"""Drop faces nobody can see: fewer triangles, and more texture for the rest."""

from __future__ import annotations

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from mathutils.geometry import tessellate_polygon

from .mesh import Mesh, face_normal


def _fan_or_ears(mesh: Mesh, face: tuple[int, ...]) -> list[tuple[int, int, int]]:
    """Triangles of a face; large faces may be concave, where a fan would cover too much."""
    if len(face) > 4:
        return tessellate_polygon([[Vector(mesh.v[i]) for i in face]])
    return [(0, j, j + 1) for j in range(1, len(face) - 1)]


def prune_hidden(meshes: list[Mesh], rays: int = 24, seed: int = 0) -> int:
    """Remove faces from which no ray escapes (buried in other meshes of the list); count them."""
    triangles, owners, shift = [], [], 0
    for k, mesh in enumerate(meshes):
        for i, face in enumerate(mesh.f):
            for corners in _fan_or_ears(mesh, face):
                triangles.append([face[c] + shift for c in corners])
                owners.append((k, i))
        shift += len(mesh.v)
    if not triangles:
        return 0
    points = np.concatenate([m.v for m in meshes])
    tree = BVHTree.FromPolygons(points.tolist(), triangles)
    step = float(np.ptp(points, axis=0).max()) * 2e-4
    coarse = 500 * step
    directions = np.random.default_rng(seed).normal(size=(rays, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]

    def escapes(corners: np.ndarray) -> bool:
        normal = face_normal(corners)
        length = np.linalg.norm(normal)
        if length < 1e-14:
            return False
        normal = normal / length
        centre = corners.mean(0)
        starts = [centre, *(centre + (c - centre) * t for t in (0.92, 0.5) for c in corners)]
        if np.ptp(corners, axis=0).max() > coarse:  # a large face may show in one narrow gap only
            a, b, c = corners[:3]
            grid = [(i, j) for i in range(1, 12) for j in range(1, 12 - i)]
            starts += [a + (b - a) * i / 12 + (c - a) * j / 12 for i, j in grid]
        for start in starts:
            origin = Vector(start + normal * step)
            for d in directions:
                towards = float(d @ normal)
                ray = d if towards > 0.02 else -d if towards < -0.02 else normal
                if tree.ray_cast(origin, Vector(ray))[0] is None:
                    return True
        return False

    seen: set[tuple[int, int]] = set()
    for triangle, owner in zip(triangles, owners, strict=True):
        if owner not in seen and escapes(points[triangle]):
            seen.add(owner)
    removed = 0
    for k, mesh in enumerate(meshes):
        keep = [i for i in range(len(mesh.f)) if (k, i) in seen]
        removed += len(mesh.f) - len(keep)
        mesh.keep_faces(keep)
    return removed
