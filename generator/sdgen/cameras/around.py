"""What a place is judged by: the edges of what it is on, the doorway or the way that it is in."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
import shapely
from shapely.geometry import Point, Polygon
from shapely.ops import nearest_points

from sdgen.facts import Body
from sdgen.geometry import Array
from sdgen.home.layout import Layout
from sdgen.scene import Zone

#: So much of a surface to every side of a place tells what it is on, and how near to the edge.
_REACH_M = 0.45
#: And so much of what it is on, below it, how high it is.
_BELOW_M = 0.35
#: A doorway or a walkway so near is what a thing on the floor would be in the way of.
_WAY_M = 1.5
_WAYS = ("doorway", "walkway")


class Surroundings:
    """The furniture and the ways of a home, for :meth:`of`."""

    def __init__(self, layout: Layout, zones: Sequence[Zone]) -> None:
        self._layout = layout
        self._ways: dict[int, list[Polygon]] = {}
        for zone in zones:
            if zone.kind in _WAYS:
                self._ways.setdefault(zone.room_id, []).append(Polygon(zone.polygon_m))

    def of(self, target: int, place: Array) -> Array:
        """Points around a place on a piece of furniture, or on the floor of a room (by their
        ids), that its picture should show, (N, 3)."""
        item = self._layout.items.get(target)
        low, high = place[:2] - _REACH_M, place[:2] + _REACH_M
        ends, heights = [], [float(place[2])]
        if item is not None:
            body = Body(item, self._layout.library.info(item.asset))
            low, high = np.maximum(low, body.low[:2]), np.minimum(high, body.high[:2])
            heights.append(max(float(place[2]) - _BELOW_M, float(body.low[2])))
        else:
            ends = self._way_points(self._ways.get(target, ()), place)
        corners = [(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])]
        return np.array([(x, y, z) for z in heights for x, y in (*corners, *ends)])

    @staticmethod
    def _way_points(ways: Collection[Polygon], place: Array) -> list[tuple[float, float]]:
        """Where the next way begins, and its middle near there."""
        at = Point(*place[:2])
        near = min(ways, key=at.distance, default=None)
        if near is None or not 0.0 < at.distance(near) < _WAY_M:
            return []
        begin = nearest_points(near, at)[0]
        # A way is some 0.8 m wide: half of it further on.
        inner = shapely.affinity.translate(begin, *(_REACH_M * _unit(begin, at)))
        return [(begin.x, begin.y), (inner.x, inner.y)]


def _unit(end: Point, start: Point) -> Array:
    along = np.array([end.x - start.x, end.y - start.y])
    return np.asarray(along / max(float(np.hypot(*along)), 1e-9))
