"""What can be measured on a model's meshes and hulls: surface samples, see-through, coverage."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.library.meshes import MeshData

#: Directions (from the model outwards) it is looked at from, as (azimuth, elevation) in degrees.
_VIEWS = tuple((azimuth, elevation) for elevation in (25, 70) for azimuth in range(15, 375, 90))
_GRID = 20


def corners_of(meshes: Sequence[MeshData]) -> Array:
    """Corners of all triangles, (N, 3, 3)."""
    return np.concatenate([mesh.vertices[mesh.faces] for mesh in meshes])


def surface_points(triangles: Array, count: int) -> tuple[Array, npt.NDArray[np.int64]]:
    """``count`` points (N, 3) spread over (M, 3, 3) triangles by area, and whose each one is.

    Always the same ones: drawn from a fixed low-discrepancy sequence (R2; Roberts 2018).
    """
    sides = triangles[:, 1:] - triangles[:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    total = np.cumsum(area)
    face = np.searchsorted(total, (np.arange(count) + 0.5) / count * total[-1])
    face = np.minimum(face, len(triangles) - 1)
    k = np.arange(count)
    u = np.sqrt((0.5 + 0.7548776662466927 * k) % 1.0)
    v = (0.5 + 0.5698402909980532 * k) % 1.0
    weights = np.stack([1 - u, u * (1 - v), u * v], axis=1)
    return np.einsum("nk,nkd->nd", weights, triangles[face]), face


def see_through(triangles: Array) -> float:
    """Share of the model's outline that shows a back face, in the worst view from around or above.

    A renderer that culls back faces (ours does) shows a hole there. 0 for closed
    meshes, and for open ones whose inside nobody can look into.
    """
    sides = triangles[:, 1:] - triangles[:, :1]
    normals = np.cross(sides[:, 0], sides[:, 1])
    length = np.linalg.norm(normals, axis=1)
    triangles, normals = triangles[length > 1e-12], normals[length > 1e-12]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return max(
        _holes(
            triangles, normals, np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
        )
        for a, e in np.radians(_VIEWS)
    )


def _holes(triangles: Array, normals: Array, towards: Array) -> float:
    """See-through share in one view, by parallel rays on a grid."""
    right = np.array([-towards[1], towards[0], 0.0]) / np.hypot(towards[0], towards[1])
    x, y, depth = (triangles @ axis for axis in (right, np.cross(towards, right), towards))
    steps = (np.arange(_GRID) + 0.5) / _GRID
    across = np.repeat(x.min() + np.ptp(x) * steps, _GRID)
    above = np.tile(y.min() + np.ptp(y) * steps, _GRID)
    # Rays (rows) by triangles (columns) that could meet.
    ray, tri = np.nonzero(
        (across[:, None] >= x.min(axis=1))
        & (across[:, None] <= x.max(axis=1))
        & (above[:, None] >= y.min(axis=1))
        & (above[:, None] <= y.max(axis=1))
    )
    ax, ay = x[tri] - across[ray, None], y[tri] - above[ray, None]
    areas = ax[:, [1, 2, 0]] * ay[:, [2, 0, 1]] - ay[:, [1, 2, 0]] * ax[:, [2, 0, 1]]
    total = areas.sum(axis=1)
    met = (np.abs(total) > 1e-15) & ((areas * np.sign(total)[:, None]) >= 0).all(axis=1)
    ray, tri = ray[met], tri[met]
    at = (areas[met] * depth[tri]).sum(axis=1) / total[met]
    nearest, nearest_front = (np.full(_GRID * _GRID, -np.inf) for _ in range(2))
    np.maximum.at(nearest, ray, at)
    front = normals[tri] @ towards > -0.15
    np.maximum.at(nearest_front, ray[front], at[front])
    # The two sides of a thin leaf lie at one depth: neither is a hole.
    slack = 0.02 * max(np.ptp(x), np.ptp(y))
    hit = np.isfinite(nearest)
    return float((nearest_front[hit] < nearest[hit] - slack).sum() / max(hit.sum(), 1))


def outside_share(points: Array, pieces: Sequence[Array], slack_m: float) -> float:
    """Share of (N, 3) points further than ``slack_m`` outside every convex piece."""
    left = points
    for piece in pieces:
        planes = _planes(piece)
        if len(left) == 0:
            return 0.0
        distance = (left @ planes[:, :3].T + planes[:, 3]).max(axis=1)
        left = left[distance > slack_m]
    return len(left) / len(points)


def centre_of_mass(pieces: Sequence[Array]) -> Array:
    """Centre of the pieces' boxes, weighted by volume: near enough to tell whether things tip."""
    centres = np.array([(piece.min(axis=0) + piece.max(axis=0)) / 2 for piece in pieces])
    volumes = np.array([_box_volume(piece) for piece in pieces])
    centre = (volumes[:, None] * centres).sum(axis=0) / volumes.sum()
    return np.asarray(centre, dtype=np.float64)


def _box_volume(piece: Array) -> float:
    """Volume of the smaller of two boxes: along the axes, and along the piece's own.

    The second keeps a leaning thin plate (a laptop's lid) from weighing like a brick.
    """
    upright = np.maximum(np.ptp(piece, axis=0), 1e-3).prod()
    middle = piece - piece.mean(axis=0)
    _, own_axes = np.linalg.eigh(middle.T @ middle)
    leaning = np.maximum(np.ptp(middle @ own_axes, axis=0), 1e-3).prod()
    return float(min(upright, leaning))


def hull_volume(points: Array) -> float:
    """Volume of the convex hull of (N, 3) points, cubic metres."""
    import trimesh

    return float(abs(trimesh.convex.convex_hull(points).volume))


def _planes(piece: Array) -> Array:
    """Outward planes (M, 4) of a piece's hull: inside where n·p + d ≤ 0 for all."""
    import trimesh

    hull = trimesh.convex.convex_hull(piece)
    normals = np.asarray(hull.face_normals, dtype=np.float64)
    offsets = -np.einsum("nk,nk->n", normals, hull.triangles[:, 0])
    return np.column_stack([normals, offsets])
