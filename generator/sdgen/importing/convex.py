"""Convex collision pieces of a mesh, made once when it enters a library.

Wei et al., "Approximate Convex Decomposition for 3D Meshes with Collision-Aware Concavity and Tree
Search" (SIGGRAPH 2022), as the package coacd does it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from sdgen.geometry import Array
from sdgen.importing.scan import Ints

#: Corners of one piece.
MAX_VERTICES = 32
#: Pieces of one mesh.
MAX_PIECES = 16
#: Shells shorter than this share of the longest go with others, as do those beyond so many.
_SLIVER, _MOST_SHELLS = 0.08, 40
#: A corner that stands out of the hull of the others by less is not needed, metres.
_STANDS_OUT_M = 0.0003
#: A mesh whose hull has less than this times its volume is taken as convex.
_CONVEX = 1.12
#: What has no thickness is given some, metres.
_THIN_M = 0.002


def convex_pieces(vertices: Array, faces: Ints) -> list[Array]:
    """Corners (N, 3) of at most ``MAX_PIECES`` convex pieces that hold the mesh, hollows left free.

    Shells that do not touch (a chair's legs, each shoe of a pair) are taken one by one: together
    they are no solid, and CoACD would make one of them first, of many thousand faces.
    """
    out: list[Array] = []
    for shell in _shells(vertices, faces):
        points, corners = vertices[np.unique(shell)], vertices[shell]
        if _is_convex(points, corners):
            out.append(_thick(points))
        else:
            used, renumbered = np.unique(shell, return_inverse=True)
            low, high = points.min(axis=0), points.max(axis=0)
            found = decompose(vertices[used], renumbered.reshape(-1, 3))
            # CoACD's first step makes the mesh thicker by a cell: things would float.
            out += [np.clip(piece, low, high) for piece in found]
    return [simplify_hull(points) for points in _few(out)]


def _shells(vertices: Array, faces: Ints) -> list[Ints]:
    """Faces by shell, the large ones first; slivers go with the nearest of these."""
    import trimesh

    graph: Any = trimesh.graph
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    labels = np.asarray(graph.connected_component_labels(mesh.face_adjacency, len(faces)))
    shells = [faces[labels == label] for label in range(int(labels.max(initial=-1)) + 1)]
    sizes = [float(np.linalg.norm(np.ptp(vertices[shell.ravel()], axis=0))) for shell in shells]
    order = sorted(range(len(shells)), key=lambda k: (-sizes[k], k))
    large = [k for k in order if sizes[k] > _SLIVER * sizes[order[0]]][:_MOST_SHELLS]
    middles = np.array([vertices[shells[k].ravel()].mean(axis=0) for k in large])
    with_slivers = {k: [shells[k]] for k in large}
    for k in order:
        if k not in with_slivers:
            off = np.linalg.norm(middles - vertices[shells[k].ravel()].mean(axis=0), axis=1)
            with_slivers[large[int(off.argmin())]].append(shells[k])
    return [np.concatenate(group) for group in with_slivers.values()]


def _is_convex(points: Array, corners: Array) -> bool:
    """True for what its hull describes: flat, or nearly of the volume of its hull."""
    import trimesh

    middle = points - points.mean(axis=0)
    spread = np.linalg.svd(middle, compute_uv=False) / np.sqrt(len(points))
    if spread[-1] < _THIN_M / 2:
        return True
    hull = trimesh.convex.convex_hull(points)
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    return bool(abs(hull.volume) <= _CONVEX * abs(float(volume)))


def _few(pieces: list[Array]) -> list[Array]:
    """At most ``MAX_PIECES`` pieces: those are joined that thereby gain the least volume."""
    pieces = [piece for piece in pieces if len(piece) > 3] or pieces
    while len(pieces) > MAX_PIECES:
        boxes = np.array([(piece.min(axis=0), piece.max(axis=0)) for piece in pieces])
        low = np.minimum(boxes[:, None, 0], boxes[None, :, 0])
        high = np.maximum(boxes[:, None, 1], boxes[None, :, 1])
        own = np.prod(boxes[:, 1] - boxes[:, 0], axis=1)
        gained = np.prod(high - low, axis=2) - own[:, None] - own[None, :]
        np.fill_diagonal(gained, np.inf)
        one, other = sorted(int(k) for k in np.unravel_index(gained.argmin(), gained.shape))
        pieces[one] = np.concatenate([pieces[one], pieces.pop(other)])
    return pieces


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


def _thick(points: Array) -> Array:
    """Points spread to at least ``_THIN_M`` in every direction, upwards where that is one."""
    for axis in np.linalg.svd(points - points.mean(axis=0))[2]:
        lacking = _THIN_M - np.ptp(points @ axis)
        if lacking > 0:
            axis = axis * np.sign(axis[np.abs(axis).argmax()])
            points = np.concatenate([points, points + lacking * axis])
    return points
