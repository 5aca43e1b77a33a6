"""Convex pieces seen from above: what placing needs of a model's collision pieces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Point

from sdgen.geometry import Array

#: A piece that is thinner from above, square metres, takes a spot of this radius: neither a line
#: nor a point ever lies in anybody's way.
THIN_M2 = 1e-6
SPOT_M = 0.005


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
