"""Stretches of wall between rooms, where openings may be, and the ways through them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import shapely
from shapely.geometry import box
from shapely.geometry.base import BaseGeometry

from sdgen.vocabulary import HALF_WALL_M

#: A way through a wall is so wide, metres.
_HOLE_M = (0.65, 3.0)
#: A wall as it was found is within this of the line that it is drawn on, metres.
_BAND_M = 0.25


@dataclass(frozen=True)
class Wall:
    """A stretch of wall with the same rooms (by index) on its sides: on the line ``at`` across
    ``along``, from ``low`` to ``high``, where an opening may be."""

    along: Literal["x", "y"]
    at: float
    low: float
    high: float
    rooms: tuple[int, ...]

    def center(self, along_m: float) -> tuple[float, float]:
        """The point of its middle line so far along."""
        return (along_m, self.at) if self.along == "x" else (self.at, along_m)


def walls_of(rings: Sequence[Sequence[tuple[float, float]]]) -> Iterator[Wall]:
    """All stretches of wall, each with the rooms on its sides."""
    edges = [
        (k, along, round(at, 4), low, high)
        for k, ring in enumerate(rings)
        for along, at, low, high in _edges(ring)
    ]
    for k, along, at, low, high in edges:
        beside = [
            (other, max(low, a), min(high, b))
            for other, way, place, a, b in edges
            if other != k and way == along and abs(place - at) < 1e-3 and min(high, b) > max(low, a)
        ]
        for other, a, b in beside:
            if k < other:
                yield Wall(along, at, a, b, (k, other))
        # A wall of two rooms shows its corners to both: outdoors begins half a wall beyond.
        cursor = low
        for _, a, b in sorted(beside, key=lambda item: item[1]):
            if a - 2 * HALF_WALL_M > cursor:
                yield Wall(along, at, cursor, a - 2 * HALF_WALL_M, (k,))
            cursor = max(cursor, b + 2 * HALF_WALL_M)
        if high > cursor:
            yield Wall(along, at, cursor, high, (k,))


def holes_in(walls: Iterable[Wall], low: BaseGeometry) -> Iterator[tuple[Wall, float, float]]:
    """Ways through walls, from where to where along them: what is not there at a knee's height."""
    for wall in walls:
        axis = 0 if wall.along == "x" else 1
        ends = ((wall.low, wall.at - _BAND_M), (wall.high, wall.at + _BAND_M))
        band = box(*ends[0], *ends[1]) if axis == 0 else box(*ends[0][::-1], *ends[1][::-1])
        parts = shapely.get_parts(low.intersection(band))
        covered = sorted((p.bounds[axis], p.bounds[axis + 2]) for p in parts)
        if not covered:
            continue  # nobody drew this wall: it says nothing of ways through it
        cursor = wall.low
        for start, end in [*covered, (wall.high, wall.high)]:
            if _HOLE_M[0] < start - cursor < _HOLE_M[1]:
                yield wall, cursor, start
            cursor = max(cursor, end)


def _edges(
    ring: Sequence[tuple[float, float]],
) -> Iterator[tuple[Literal["x", "y"], float, float, float]]:
    """The walls behind the edges of a floor: their axis, middle line, and from where to where."""
    for (ax, ay), (bx, by) in zip(ring, (*ring[1:], ring[0]), strict=True):
        if abs(ay - by) < 1e-6:  # counter-clockwise: the wall is to the right
            out = -HALF_WALL_M if bx > ax else HALF_WALL_M
            yield "x", ay + out, min(ax, bx), max(ax, bx)
        else:
            out = HALF_WALL_M if by > ay else -HALF_WALL_M
            yield "y", ax + out, min(ay, by), max(ay, by)
