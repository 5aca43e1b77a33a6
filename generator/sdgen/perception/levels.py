"""Level surfaces among the points of one object, and outlines of points from above."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.perception.clouds import Points

#: Outlines are hulls of the points furthest out in so many directions, both ways.
DIRECTIONS = 24
#: Half a pixel on a thing 2 m away is 2 mm: so much further an outline goes than its points, and
#: what is seen edge-on has an area, too.
HALF_PIXEL_M = 0.002
#: Heights are counted in bins of so much, metres; a level fills three of them at most, for depth
#: is rounded to a millimetre and ends in the thickness of a pixel.
BIN_M = 0.002
#: Two levels of one object are further apart than this, metres.
APART_M = 0.02
#: A level shows at least so many pixels, and so large a share of what looks up on the object.
LEAST_PIXELS = 25
LEAST_SHARE = 0.04

#: Of more points than these, not all need looking at: those at the rim, and one in so many.
MANY = 1000
EVERY = 7

Flags = npt.NDArray[np.bool_]

_HALF_PIXEL = HALF_PIXEL_M * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
_ANGLES = np.linspace(0.0, np.pi, DIRECTIONS, endpoint=False)
_OUT = np.stack([np.cos(_ANGLES), np.sin(_ANGLES)], axis=1).astype(np.float32)


class Level(NamedTuple):
    """A level surface: how high, and its outline from above."""

    z_m: float
    outline: BaseGeometry


def outline_of(points: Points, rim: Flags) -> BaseGeometry:
    """The convex outline from above of points (N, 3), never empty of area; ``rim`` (N,): where the
    object ends in its picture, which few others go beyond."""
    if len(points) > MANY:
        chosen = rim.copy()
        chosen[::EVERY] = True
        points = points[chosen]
    if len(points) > 2 * DIRECTIONS:
        # Millimetres far from the origin: products of float32 are exact enough about the middle.
        across = np.ascontiguousarray((points[:, :2] - points[0, :2]).T)
        along = _OUT @ across
        points = points[np.concatenate([along.argmin(axis=1), along.argmax(axis=1)])]
    around = points[:, None, :2].astype(np.float64) + _HALF_PIXEL
    # To a millimetre, as depth is: corners nearer to each other than that are one.
    corners = np.round(around.reshape(-1, 2), 3)
    return shapely.convex_hull(shapely.multipoints(corners))


def levels_of(points: Points, upward: Flags, rim: Flags) -> list[Level]:
    """The level surfaces among points (N, 3) of which some look ``upward`` (N,), highest first;
    ``rim`` as :func:`outline_of` has it."""
    up, rim = points[upward], rim[upward]
    if len(up) < LEAST_PIXELS:
        return []
    heights = up[:, 2]
    low = float(heights.min())
    bins = ((heights - low) / BIN_M).astype(np.int64)
    counts = np.bincount(bins)
    wide = np.convolve(counts, np.ones(3, dtype=np.int64), mode="same")
    least = max(LEAST_PIXELS, LEAST_SHARE * len(up))
    found: list[Level] = []
    order = np.argsort(-wide, kind="stable")
    for peak in order[: int((wide >= least).sum())].tolist():
        about = low + (peak + 0.5) * BIN_M
        if any(abs(about - level.z_m) < APART_M for level in found):
            continue
        near = np.abs(bins - peak) <= 1
        there = up[near]
        found.append(Level(float(np.median(there[:, 2])), outline_of(there, rim[near])))
    return sorted(found, key=lambda level: -level.z_m)
