"""Where on a room's floor a thing may be put: in some zone, or aside, at a wall.

What people put aside on a floor stands or lies at a wall, along it: of things further out, and of
things before doors and seats, people who look at pictures say that somebody will fall over them,
whether or not a way leads there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry import LineString, MultiLineString, MultiPoint, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from sdgen.freespace import Pieces
from sdgen.geometry import Array, Vec2, Vec3
from sdgen.home.headings import FRONT_SPREAD_RAD, random_yaw
from sdgen.seeding import Rng
from sdgen.vocabulary import ZONE_AVOID_SHARE

#: What was put aside stands so far from the wall, metres, at least and at most: clear of it, and no
#: further than a hand's breadth (a judgement).
ASIDE_M = (0.02, 0.1)
#: What is so much longer than wide lies along a wall, or square to the room, give or take so many
#: radians (7 degrees): by eye, of umbrellas and brooms.
LONG, LONG_SPREAD_RAD = 1.6, 0.12
#: What stands on the floor to be looked at has so much of it free before it, metres: somebody sits
#: or kneels there.
SEEN_FROM_M = 0.65


@dataclass(frozen=True)
class Ground:
    """Floor of a room that takes things.

    A thing has its middle in ``area``, or, where that is None, stands at one of the ``walls``
    (lines on the outline). It is all within the outline, with at least ``keep_share`` of its
    footprint in ``area``, at most ``ZONE_AVOID_SHARE`` in ``avoid`` and none in ``off``.
    """

    outline: Polygon
    area: BaseGeometry | None
    walls: BaseGeometry | None = None
    keep_share: float = 0.0
    avoid: BaseGeometry | None = None
    off: BaseGeometry | None = None

    def draw(self, size_m: Vec3, looked_at: bool, rng: Rng) -> tuple[Vec2, float] | None:
        """A point for the middle of a box of a size, and its heading; None: there is none.

        What is ``looked_at`` faces the room.
        """
        if self.area is None:
            return self._at_wall(size_m, looked_at, rng)
        point = self._pieces.random_point(rng)
        if point is None:
            return None
        yaw = _square(rng) if _is_long(size_m) and not looked_at else random_yaw(rng)
        if looked_at and self.faces_wall(point, yaw):
            yaw += math.pi
        return point, yaw

    def takes(self, print_: Polygon, point: Vec2, yaw: float, looked_at: bool) -> bool:
        """Whether a thing may lie there with such a footprint."""
        if looked_at and self.faces_wall(point, yaw):
            return False
        if not self.outline.covers(print_):
            return False
        if self.keep_share and _share(self.area, print_) < self.keep_share:
            return False
        if self.off is not None and self.off.intersects(print_):
            return False
        return _share(self.avoid, print_) <= ZONE_AVOID_SHARE

    def near(self, points: Sequence[Vec2], reach_m: float) -> Ground:
        """The same floor, its walls no further than this from one of the points (if any)."""
        if not points or self.walls is None:
            return self
        within = self.walls.intersection(MultiPoint(points).buffer(reach_m))
        parts = shapely.get_parts(within).tolist()
        lines = [part for part in parts if isinstance(part, LineString) and part.length > 0]
        return replace(self, walls=MultiLineString(lines))

    def within(self, shape: BaseGeometry) -> Ground:
        """The same floor where what lies there has its middle in a shape, or stands at a wall that
        is in it."""
        if self.area is not None:
            return replace(self, area=self.area.intersection(shape))
        parts = shapely.get_parts(self.walls.intersection(shape)).tolist() if self.walls else []
        lines = [part for part in parts if isinstance(part, LineString) and part.length > 0]
        return replace(self, walls=MultiLineString(lines))

    def __post_init__(self) -> None:
        for shape in (self.outline, self.area, self.avoid, self.off):
            if shape is not None:
                shapely.prepare(shape)

    def _at_wall(self, size_m: Vec3, looked_at: bool, rng: Rng) -> tuple[Vec2, float] | None:
        ends, sums = self._stretches
        if not len(ends):
            return None
        start, end = ends[int(sums.searchsorted(rng.random(), side="right"))]
        along = (end - start) / np.hypot(*(end - start))
        inward = np.array([-along[1], along[0]])
        heading = math.atan2(inward[1], inward[0])
        if looked_at:
            yaw = heading + float(rng.normal(0.0, FRONT_SPREAD_RAD))
        elif _is_long(size_m):
            turn = 0.0 if size_m[0] < size_m[1] else math.pi / 2
            yaw = heading + turn + math.pi * rng.integers(2) + rng.normal(0.0, LONG_SPREAD_RAD)
        else:
            yaw = random_yaw(rng, heading)
        cos, sin = abs(math.cos(yaw - heading)), abs(math.sin(yaw - heading))
        out = rng.uniform(*ASIDE_M) + (cos * size_m[0] + sin * size_m[1]) / 2
        x, y = (start + rng.random() * (end - start) + out * inward).tolist()
        return (x, y), float(yaw)

    def faces_wall(self, point: Vec2, yaw: float) -> bool:
        """Whether what stands at a point of the room looks at a wall that is near."""
        x, y = point
        ahead = Point(x + SEEN_FROM_M * math.cos(yaw), y + SEEN_FROM_M * math.sin(yaw))
        return not self.outline.covers(LineString([(x, y), ahead]))

    @cached_property
    def _pieces(self) -> Pieces:
        return Pieces(self.area)

    @cached_property
    def _stretches(self) -> tuple[Array, Array]:
        """Both ends of each stretch of wall (K, 2, 2), the room on its left, and what share of
        their length they and those before them have."""
        found = []
        for line in shapely.get_parts(shapely.line_merge(self.walls)):
            corners = shapely.get_coordinates(line)
            found.append(np.stack([corners[:-1], corners[1:]], axis=1))
        ends = np.concatenate(found) if found else np.zeros((0, 2, 2))
        lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
        sums = np.cumsum(lengths / lengths.sum())
        return ends, sums / sums[-1:]


def walls_of(outline: Polygon) -> BaseGeometry:
    """The walls of a room, its floor on their left."""
    return LineString(orient(outline).exterior.coords)


def _share(shape: BaseGeometry | None, print_: Polygon) -> float:
    """How much of a footprint lies in a shape."""
    if shape is None or not shape.intersects(print_):
        return 0.0
    return float(print_.intersection(shape).area / print_.area)


def _is_long(size_m: Vec3) -> bool:
    return max(size_m[:2]) > LONG * min(size_m[:2])


def _square(rng: Rng) -> float:
    return float(rng.integers(4) * math.pi / 2 + rng.normal(0.0, LONG_SPREAD_RAD))
