"""Convex pieces seen from above: what placing needs of a model's collision pieces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Point

from sdgen.geometry import Array
from sdgen.library.meshes import MeshData

#: A piece that is thinner from above, square metres, takes a spot of this radius: neither a line
#: nor a point ever lies in anybody's way.
THIN_M2 = 1e-6
SPOT_M = 0.005
#: What is drawn further than this beside the collision pieces takes space of its own: cushions and
#: mouldings stand out by less, and no more space is taken for them.
LEFT_OUT_M = 0.03
#: In boxes of at most this size, a compromise between their number and the air in them; edges are
#: looked at in steps fine enough to find what fills one.
CELL_M, EDGE_STEP_M = 0.2, 0.05


@dataclass(frozen=True)
class Above:
    """Outlines (closed convex rings, one after another) and heights of pieces.

    ``points_m`` (K, 2); ring k begins at ``starts[k]``; ``low_m`` and ``high_m`` (P,).
    """

    points_m: Array
    starts: npt.NDArray[np.intp]
    low_m: Array
    high_m: Array


def box_from_above(low: Sequence[float], high: Sequence[float]) -> Above:
    """A box along the axes, from its lowest and highest corner, as it is seen from above."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    ring = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])
    return Above(ring, np.zeros(1, dtype=np.intp), np.array([z0]), np.array([z1]))


def seen_from_above(pieces: Sequence[Array]) -> Above:
    """Convex pieces, each given as corners (N, 3), as they are seen from above."""
    sizes = [len(corners) for corners in pieces]
    corners = np.concatenate(pieces)
    # A line has the hull of its points, and needs no geometry of its own for each of them.
    lines = shapely.linestrings(corners[:, :2], indices=np.repeat(np.arange(len(pieces)), sizes))
    shapes = shapely.convex_hull(lines)
    for thin in np.flatnonzero(shapely.area(shapes) < THIN_M2).tolist():
        shapes[thin] = Point(pieces[thin][:, :2].mean(axis=0)).buffer(SPOT_M)
    begins = np.cumsum([0, *sizes[:-1]])
    return Above(
        points_m=shapely.get_coordinates(shapes),
        starts=np.cumsum([0, *shapely.get_num_coordinates(shapes)[:-1]]),
        low_m=np.minimum.reduceat(corners[:, 2], begins),
        high_m=np.maximum.reduceat(corners[:, 2], begins),
    )


def with_left_out(pieces: Above, meshes: Sequence[MeshData]) -> Above:
    """Pieces, and boxes around what they leave out of what is drawn: the arm of a lamp, bars."""
    points = np.concatenate([_along_edges(mesh) for mesh in meshes])
    left = np.ones(len(points), dtype=bool)
    ends = [*pieces.starts[1:].tolist(), len(pieces.points_m)]
    for k, (start, end) in enumerate(zip(pieces.starts.tolist(), ends, strict=True)):
        shape = shapely.polygons(pieces.points_m[start:end]).buffer(LEFT_OUT_M)
        z = points[:, 2]
        level = left & (z > pieces.low_m[k] - LEFT_OUT_M) & (z < pieces.high_m[k] + LEFT_OUT_M)
        near = np.flatnonzero(level)
        left[near[shapely.contains_xy(shape, points[near, :2])]] = False
    rest = points[left]
    _, cell = np.unique(np.floor(rest / CELL_M), axis=0, return_inverse=True)
    every = [pieces]
    # Half a step wider on all sides: boxes of neighbouring cells then meet, and none is a line.
    wider = np.array([EDGE_STEP_M / 2, EDGE_STEP_M / 2, 0.0])
    for k in range(cell.max(initial=-1) + 1):
        box = rest[cell.ravel() == k]
        every.append(box_from_above(box.min(axis=0) - wider, box.max(axis=0) + wider))
    shifts = np.cumsum([0, *(len(piece.points_m) for piece in every[:-1])])
    return Above(
        points_m=np.concatenate([piece.points_m for piece in every]),
        starts=np.concatenate([p.starts + s for p, s in zip(every, shifts, strict=True)]),
        low_m=np.concatenate([piece.low_m for piece in every]),
        high_m=np.concatenate([piece.high_m for piece in every]),
    )


def _along_edges(mesh: MeshData) -> Array:
    """Vertices, and points every ``EDGE_STEP_M`` along the edges of triangles (N, 3)."""
    a, b = (mesh.vertices[mesh.faces[:, k].ravel()] for k in ([0, 1, 2], [1, 2, 0]))
    steps = np.ceil(np.linalg.norm(b - a, axis=1) / EDGE_STEP_M).astype(int)
    out = [mesh.vertices]
    for count in np.unique(steps[steps > 1]).tolist():
        start, along = a[steps == count], (b - a)[steps == count]
        out += [start + along * (step / count) for step in range(1, count)]
    return np.concatenate(out)
