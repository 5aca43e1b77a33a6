"""Convex collision pieces of a mesh, made once when it enters a library.

Wei et al., "Approximate Convex Decomposition for 3D Meshes with Collision-Aware Concavity and Tree
Search" (SIGGRAPH 2022), as the package coacd does it.
"""

from __future__ import annotations

import numpy as np

from sdgen.geometry import Array
from sdgen.importing.scan import Ints

#: Corners of one piece.
MAX_VERTICES = 32
#: A corner that stands out of the hull of the others by less is not needed, metres.
_STANDS_OUT_M = 0.0003
#: A mesh whose hull has less than this times its volume is taken as convex.
_CONVEX = 1.12
#: What has no thickness is given some, metres.
_THIN_M = 0.002


def convex_pieces(vertices: Array, faces: Ints) -> list[Array]:
    """Corners (N, 3) of few convex pieces that hold the mesh, hollows left free."""
    import trimesh

    points = _thick(vertices)
    if len(points) > len(vertices):
        return [simplify_hull(points)]
    hull = trimesh.convex.convex_hull(vertices)
    corners = vertices[faces]
    volume = float(
        np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    )
    if abs(hull.volume) <= _CONVEX * volume:
        return [simplify_hull(vertices)]
    out = [simplify_hull(piece) for piece in decompose(vertices, faces)]
    solid = [p for p in out if np.linalg.matrix_rank(np.round(p - p[0], 4), tol=1e-3) == 3]
    return solid or [simplify_hull(vertices)]


def decompose(vertices: Array, faces: Ints) -> list[Array]:
    """The pieces of CoACD; always the same ones of one mesh.

    Its search is kept short: of a mug it takes 8 s in place of 40 with its defaults, and the pieces
    are as close.
    """
    import coacd

    coacd.set_log_level("error")
    pieces = coacd.run_coacd(
        coacd.Mesh(vertices, faces),
        threshold=0.1,
        max_convex_hull=12,
        seed=1,
        resolution=400,
        mcts_iterations=10,
        mcts_nodes=6,
        mcts_max_depth=2,
        preprocess_resolution=25,
    )
    return [np.asarray(v, dtype=np.float64) for v, _ in pieces]


def simplify_hull(points: Array, steep: float = 1.0) -> Array:
    """The corners of the convex hull, thinned to those that carry its shape; heights count
    ``steep`` times as much."""
    import trimesh
    from scipy.spatial import ConvexHull, QhullError

    full = np.asarray(trimesh.convex.convex_hull(np.asarray(points, float)).vertices)
    if len(full) <= MAX_VERTICES:
        return full
    hull = full * (1.0, 1.0, steep)
    ends = [pick for axis in hull.T for pick in (int(axis.argmin()), int(axis.argmax()))]
    first = np.linalg.norm(hull - hull[ends[0]], axis=1).argsort()[::-1]
    chosen = list(dict.fromkeys([*ends, *first[:2].tolist()]))
    while len(chosen) < MAX_VERTICES:  # the one that stands out most of the hull of those before
        try:
            planes = ConvexHull(hull[chosen]).equations
        except QhullError:  # flat so far
            chosen.append(next(k for k in first.tolist() if k not in chosen))
            continue
        out = (hull @ planes[:, :3].T + planes[:, 3]).max(axis=1)
        if out.max() < _STANDS_OUT_M:
            break
        chosen.append(int(out.argmax()))
    return np.asarray(full[sorted(chosen)])


def _thick(vertices: Array) -> Array:
    """Points spread to at least ``_THIN_M`` along each axis."""
    size = np.ptp(vertices, axis=0)
    if (size >= _THIN_M).all():
        return vertices
    return np.concatenate([vertices, vertices + np.maximum(_THIN_M - size, 0.0)])
