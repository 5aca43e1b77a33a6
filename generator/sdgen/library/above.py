"""Convex pieces seen from above: what placing needs of a model's collision pieces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Point

from sdgen.geometry import Array
from sdgen.library.meshes import MeshData
from sdgen.library.reaching import STANDS_OUT_M

#: A piece that is thinner from above, square metres, takes a spot of this radius: neither a line
#: nor a point ever lies in anybody's way.
THIN_M2 = 1e-6
SPOT_M = 0.005
#: What is drawn further than this beside the collision pieces takes space of its own; what stands
#: out by less, cushions and mouldings, is taken into the nearest piece, metres.
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
    """Pieces, drawn out to what is drawn a little beyond them (arms that bulge, mouldings), and
    boxes around what they leave out of it: the arm of a lamp, bars."""
    points = np.concatenate([_along_edges(mesh) for mesh in meshes])
    z, ends = points[:, 2], [*pieces.starts[1:].tolist(), len(pieces.points_m)]
    rings = [pieces.points_m[a:b] for a, b in zip(pieces.starts.tolist(), ends, strict=True)]
    # How far each point is from the nearest piece, and which that is; none is nearer than this.
    beyond, nearest = np.full(len(points), LEFT_OUT_M), np.full(len(points), -1)
    for k, ring in enumerate(rings):
        low, high = pieces.low_m[k], pieces.high_m[k]
        over = np.maximum(low - z, z - high)
        reach = (*(ring.min(axis=0) - LEFT_OUT_M), *(ring.max(axis=0) + LEFT_OUT_M))
        near = np.flatnonzero(
            (over < beyond)
            & (beyond > STANDS_OUT_M)
            & (points[:, 0] > reach[0])
            & (points[:, 1] > reach[1])
            & (points[:, 0] < reach[2])
            & (points[:, 1] < reach[3])
        )
        apart = shapely.distance(shapely.polygons(ring), shapely.points(points[near, :2]))
        far = np.maximum(apart, over[near])
        nearer = far < beyond[near]
        beyond[near[nearer]], nearest[near[nearer]] = far[nearer], k
    left, out = nearest < 0, (nearest >= 0) & (beyond > STANDS_OUT_M)
    drawn_out = {k: points[out & (nearest == k)] for k in np.unique(nearest[out]).tolist()}
    pieces = _drawn_out(pieces, rings, drawn_out)
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


def _drawn_out(pieces: Above, rings: Sequence[Array], added: Mapping[int, Array]) -> Above:
    """The pieces (their outlines are given) with points (N, 3) added to some of them."""
    if not added:
        return pieces
    low, high = pieces.low_m.copy(), pieces.high_m.copy()
    out = list(rings)
    for k, points in added.items():
        both = np.concatenate([rings[k], points[:, :2]])
        out[k] = shapely.get_coordinates(shapely.convex_hull(shapely.multipoints(both)))
        low[k], high[k] = min(low[k], points[:, 2].min()), max(high[k], points[:, 2].max())
    starts = np.cumsum([0, *(len(ring) for ring in out[:-1])])
    return Above(np.concatenate(out), starts, low, high)


def _along_edges(mesh: MeshData) -> Array:
    """Vertices, and points every ``EDGE_STEP_M`` along the edges of triangles (N, 3)."""
    a, b = (mesh.vertices[mesh.faces[:, k].ravel()] for k in ([0, 1, 2], [1, 2, 0]))
    steps = np.ceil(np.linalg.norm(b - a, axis=1) / EDGE_STEP_M).astype(int)
    out = [mesh.vertices]
    for count in np.unique(steps[steps > 1]).tolist():
        start, along = a[steps == count], (b - a)[steps == count]
        out += [start + along * (step / count) for step in range(1, count)]
    return np.concatenate(out)
