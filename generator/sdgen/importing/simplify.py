"""Makes scans light: welded, thinned to a budget of faces, without holes that one looks into.

Thinning is by quadric errors (Garland and Heckbert, "Surface Simplification Using Quadric Error
Metrics", SIGGRAPH 1997), as the package fast-simplification does it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sdgen.geometry import Array
from sdgen.importing.scan import Ints, Piece
from sdgen.library.shape import see_through

#: Points closer than this share of the diagonal are one: seams of texture split vertices.
_SAME = 1e-5
#: Of a view: more back faces than this are a hole that shows (``validate`` allows 3 %).
_HOLES = 0.02
#: Cells along a side of the grid that what quadrics cannot thin is rounded to: at first, and last.
_CELLS, _FEWEST_CELLS = 256, 8
#: Fewest faces a part keeps.
_FEWEST = 12
#: Edges sharper than this are drawn sharp.
_CREASE_RAD = np.radians(40)


@dataclass(frozen=True)
class Solid:
    """Triangles of one part: ``vertices`` (N, 3), ``faces`` (M, 3); ``doubled`` means that every
    face has one that looks the other way, at the end in the same order."""

    vertices: Array
    faces: Ints
    doubled: bool = False

    @property
    def triangles(self) -> Array:
        """Corners (M, 3, 3)."""
        return np.asarray(self.vertices[self.faces])


def welded(pieces: Sequence[Piece]) -> Solid:
    """All pieces as one mesh, points that lie together made one, faces without area left out."""
    vertices = np.concatenate([piece.vertices for piece in pieces])
    starts = np.cumsum([0, *(len(piece.vertices) for piece in pieces)])
    faces = np.concatenate([p.faces + s for p, s in zip(pieces, starts, strict=False)])
    used = vertices[faces.ravel()]
    step = max(float(np.linalg.norm(np.ptp(used, axis=0))) * _SAME, 1e-9)
    _, first, inverse = np.unique(
        np.round(vertices / step).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    faces = inverse.ravel()[faces]
    points = vertices[first]
    sides = points[faces]
    area = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1)
    return _compact(points, faces[area > step * step * 1e-3])


def light(parts: Mapping[str, Solid], budget: int) -> dict[str, Solid]:
    """The parts with at most ``budget`` faces together, open ones doubled so that no view shows
    through them."""
    parts = {name: outward(solid) for name, solid in parts.items()}
    thinned = _thinned(parts, budget)
    if see_through(_corners(thinned)) <= _HOLES:
        return thinned
    open_ = {name for name, solid in parts.items() if not _closed(solid)}
    half = budget // 2 if open_ else budget
    thinned = _thinned(parts, half)
    return {k: _doubled(v) if k in open_ or not open_ else v for k, v in thinned.items()}


def outward(solid: Solid) -> Solid:
    """The mesh with faces of one shell wound alike, closed ones outwards."""
    import trimesh

    repair: Any = trimesh.repair
    graph: Any = trimesh.graph
    mesh = trimesh.Trimesh(solid.vertices, solid.faces, process=False)
    if not mesh.is_winding_consistent and len(solid.faces) < 60_000:
        repair.fix_winding(mesh)
    faces = np.asarray(mesh.faces, dtype=np.int64)
    if len(faces) < 60_000:
        labels = graph.connected_component_labels(mesh.face_adjacency, len(faces))
        for label in range(int(labels.max(initial=-1)) + 1):
            shell = faces[labels == label]
            if len(shell) > 3 and _signed_volume(solid.vertices[shell]) < 0:
                faces[labels == label] = shell[:, ::-1]
    elif _signed_volume(solid.vertices[faces]) < 0:
        faces = faces[:, ::-1]
    return Solid(solid.vertices, faces)


def corner_normals(solid: Solid) -> Array:
    """Normals (M, 3, 3) of the corners of faces: smooth, but for sharp edges."""
    corners = solid.triangles
    weighted = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(weighted, axis=1, keepdims=True)
    unit = weighted / np.maximum(length, 1e-15)
    out = np.repeat(unit[:, None], 3, axis=1).reshape(-1, 3)
    flat = solid.faces.ravel()
    order = np.argsort(flat, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(flat[order])) + 1)
    for group in groups:
        around = group // 3
        normals = unit[around]
        alike = normals @ normals.T > np.cos(_CREASE_RAD)
        sums = alike @ weighted[around]
        size = np.linalg.norm(sums, axis=1, keepdims=True)
        out[group] = np.where(size > 1e-15, sums / np.maximum(size, 1e-15), normals)
    return out.reshape(-1, 3, 3)


def _thinned(parts: Mapping[str, Solid], budget: int) -> dict[str, Solid]:
    total = sum(len(solid.faces) for solid in parts.values())
    if total <= budget:
        return dict(parts)
    out = {}
    for name, solid in parts.items():
        target = max(_FEWEST, int(budget * len(solid.faces) / total))
        if len(solid.faces) <= target:
            out[name] = solid
            continue
        best = _by_quadrics(solid, target)
        cells = _CELLS
        while len(best.faces) > target and cells >= _FEWEST_CELLS:
            # Needles, fans and loose shells withstand quadrics: rounded to a grid they do not.
            best, cells = _by_quadrics(_rounded(solid, cells), target), cells // 2
        out[name] = best
    return out


def _by_quadrics(solid: Solid, target: int) -> Solid:
    import fast_simplification

    best = solid
    for agg in (5, 7, 9):  # more eager, until the budget is kept
        if len(best.faces) <= target:
            break
        points, faces = fast_simplification.simplify(
            best.vertices.astype(np.float32),
            best.faces.astype(np.int32),
            target_count=target,
            agg=agg,
        )
        made = _compact(np.asarray(points, np.float64), np.asarray(faces, np.int64))
        if len(made.faces) >= _FEWEST // 3:
            best = made
    return best


def _rounded(solid: Solid, cells: int) -> Solid:
    """The mesh with the points of each cell of a grid, ``cells`` along its longest side, made one:
    the middle of theirs (Rossignac and Borrel, "Multi-resolution 3D Approximations", 1993)."""
    step = float(np.ptp(solid.vertices, axis=0).max()) / cells
    keys = np.round(solid.vertices / step).astype(np.int64)
    _, inverse, counts = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    inverse = inverse.ravel()
    sums = np.zeros((len(counts), 3))
    np.add.at(sums, inverse, solid.vertices)
    return _compact(sums / counts[:, None], inverse[solid.faces])


def _compact(vertices: Array, faces: Ints) -> Solid:
    """Without faces that are an edge, faces that are there twice, and points nobody uses."""
    whole = (
        (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    )
    faces = faces[whole]
    turn = np.argmin(faces, axis=1)
    turned = np.stack([faces[np.arange(len(faces)), (turn + k) % 3] for k in range(3)], axis=1)
    _, first = np.unique(turned, axis=0, return_index=True)
    faces = faces[np.sort(first)]
    used, inverse = np.unique(faces, return_inverse=True)
    return Solid(vertices[used], inverse.reshape(-1, 3).astype(np.int64))


def _doubled(solid: Solid) -> Solid:
    faces = np.concatenate([solid.faces, solid.faces[:, ::-1]])
    return Solid(solid.vertices, faces, doubled=True)


def _closed(solid: Solid) -> bool:
    edges = np.sort(solid.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    return bool((counts == 2).all())


def _signed_volume(corners: Array) -> float:
    return float(np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum())


def _corners(parts: Mapping[str, Solid]) -> Array:
    return np.concatenate([solid.triangles for solid in parts.values()])
