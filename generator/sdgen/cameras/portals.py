"""Which rooms can be seen from a point: through doorways, straight ahead.

Portals (Luebke and Georges 1995): what is seen of the next room lies within the angle of the
doorway to it, and so on from there. Walls reach from floor to ceiling, so angles on the plan do.
Leaves that are not shut and furniture are taken for see-through: of what is named some may be
hidden, but nothing that is seen is missing.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

import numpy as np
from shapely.geometry import Point, Polygon

from sdgen.freespace import opening_rectangle
from sdgen.geometry import Vec2
from sdgen.scene import Camera, Home, Opening
from sdgen.vocabulary import HALF_WALL_M

#: An arc of directions: its middle, and half its width, radians.
Arc = tuple[float, float]
_ALL: Arc = (0.0, math.pi)
#: Doorways are taken for so much deeper than the wall: frames stand out of it.
_FRAME_M = 0.05


class Portals:
    """The rooms of one home and the doorways between them, but those that are ``shut``: ids of the
    doors in them."""

    def __init__(self, home: Home, shut: Collection[int] = ()) -> None:
        self._rooms = {room.id: Polygon(room.polygon_m) for room in home.rooms}
        self._doors: dict[int, list[tuple[Polygon, Opening, int]]] = {
            key: [] for key in self._rooms
        }
        for opening in home.openings:
            if len(opening.room_ids) == 2 and opening.object_id not in shut:
                hole = opening_rectangle(opening, HALF_WALL_M + _FRAME_M)
                a, b = opening.room_ids
                self._doors[a].append((hole, opening, b))
                self._doors[b].append((hole, opening, a))

    def rooms_around(self, point: Vec2) -> frozenset[int]:
        """Ids of the rooms of which something may be seen from a point, wherever one looks."""
        return self._within(point, _ALL)

    def rooms(self, camera: Camera) -> frozenset[int]:
        """Ids of the rooms of which a camera, which stands in one of them, may see something."""
        return self._within(eye_of(camera), arc_of(camera))

    def _within(self, point: Vec2, arc: Arc) -> frozenset[int]:
        at = Point(point)
        here = min(self._rooms, key=lambda key: self._rooms[key].distance(at))
        found: set[int] = set()
        self._look(point, here, arc, (here,), found)
        return frozenset(found)

    def _look(
        self, point: Vec2, room: int, arc: Arc, way: tuple[int, ...], found: set[int]
    ) -> None:
        found.add(room)
        for hole, _, other in self._doors[room]:
            if other not in way:
                through = _both(arc, _arc_of(point, hole))
                if through is not None:
                    self._look(point, other, through, (*way, other), found)

    def around(self, low: Vec2, high: Vec2, room_id: int) -> Iterator[int]:
        """The rooms that a thing is in or reaches into, by the corners of its box on the plan."""
        box = Polygon([low, (high[0], low[1]), high, (low[0], high[1])]).buffer(_FRAME_M)
        for key, outline in self._rooms.items():
            if key == room_id or outline.intersects(box):
                yield key


def eye_of(camera: Camera) -> Vec2:
    """Where a camera stands on the plan."""
    return camera.world_from_camera[0][3], camera.world_from_camera[1][3]


def arc_of(camera: Camera) -> Arc:
    """The directions on the plan in which a camera sees; all of them where it looks up or down so
    steeply that it sees what is right above or below."""
    k, turn = np.asarray(camera.K), np.asarray(camera.world_from_camera)[:3, :3]
    across = np.array([-0.5, camera.width - 0.5])
    down = np.array([-0.5, camera.height - 0.5])
    u, v = np.meshgrid((across - k[0, 2]) / k[0, 0], (down - k[1, 2]) / k[1, 1])
    corners = np.stack([u.ravel(), v.ravel(), np.ones(4)], axis=1) @ turn.T
    ahead = turn[:, 2]
    # The plan's part of what is seen is a cone about the axis while no corner lies behind it.
    if (corners[:, :2] @ ahead[:2] <= 0.0).any():
        return _ALL
    middle = math.atan2(ahead[1], ahead[0])
    aside = [abs(_turned(math.atan2(y, x) - middle)) for x, y in corners[:, :2].tolist()]
    return middle, max(aside)


def _arc_of(point: Vec2, hole: Polygon) -> Arc:
    """The directions in which a hole in a wall lies; all of them from within."""
    if hole.distance(Point(point)) < _FRAME_M:
        return _ALL
    x, y = point
    middle = math.atan2(hole.centroid.y - y, hole.centroid.x - x)
    angles = [
        _turned(math.atan2(v - y, u - x) - middle) for u, v in list(hole.exterior.coords)[:-1]
    ]
    low, high = min(angles), max(angles)
    return middle + (low + high) / 2, (high - low) / 2


def _both(one: Arc, other: Arc) -> Arc | None:
    """Where two arcs overlap, the second less than half a circle or all of it; None: nowhere. Of
    two places the one around both."""
    if other[1] >= math.pi:
        return one
    if one[1] >= math.pi:
        return other
    apart = _turned(other[0] - one[0])
    low, high = max(-one[1], apart - other[1]), min(one[1], apart + other[1])
    if low > high:
        return None
    return one[0] + (low + high) / 2, (high - low) / 2


def _turned(angle: float) -> float:
    """An angle between -pi and pi."""
    return math.remainder(angle, 2 * math.pi)
