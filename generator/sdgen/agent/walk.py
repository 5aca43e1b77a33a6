"""Where an agent can be in a home, and its ways there: never through walls or furniture."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import shapely
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import nearest_points, unary_union

from sdgen.agent.ways import Ways
from sdgen.freespace import polygons, random_point
from sdgen.geometry import Vec2
from sdgen.scene import Scene
from sdgen.seeding import Rng

#: Rings are rounded to millimetres: a step along an edge is still inside.
_ROUNDED_M = 0.002


@dataclass(frozen=True)
class Place:
    """Where an agent stands, metres, and where it looks: yaw counter-clockwise from x, radians."""

    x_m: float
    y_m: float
    yaw_rad: float

    @property
    def point(self) -> Vec2:
        """Where it stands."""
        return self.x_m, self.y_m


class Floor:
    """The free space of a scene, for a body of the robot's radius."""

    def __init__(self, scene: Scene) -> None:
        rings = [Polygon(ring).buffer(0) for ring in scene.free_space]
        self.shape: BaseGeometry = unary_union(rings) if rings else Polygon()
        self._within = self.shape.buffer(_ROUNDED_M)
        shapely.prepare(self._within)
        self._rooms = [(room.id, Polygon(room.polygon_m)) for room in scene.home.rooms]

    @cached_property
    def _ways(self) -> Ways:
        return Ways(self.shape)

    def holds(self, point: Vec2) -> bool:
        """Whether an agent can stand there."""
        return bool(shapely.contains_xy(self._within, *point))

    def step(self, place: Place, distance_m: float) -> tuple[Place, bool]:
        """Where a straight step ends, and whether something was in the way: then as far as it goes
        without touching it."""
        dx, dy = math.cos(place.yaw_rad), math.sin(place.yaw_rad)
        end = (place.x_m + distance_m * dx, place.y_m + distance_m * dy)
        way = LineString([place.point, end])
        if shapely.covers(self._within, way):
            return Place(*end, place.yaw_rad), False
        inside = shapely.intersection(self.shape, way)
        gone = 0.0
        for piece in getattr(inside, "geoms", [inside]):
            if isinstance(piece, LineString) and piece.distance(Point(place.point)) < _ROUNDED_M:
                gone = max(math.dist(place.point, corner) for corner in piece.coords)
        gone = min(gone, distance_m)
        return Place(place.x_m + gone * dx, place.y_m + gone * dy, place.yaw_rad), True

    def nearest(self, point: Vec2) -> Vec2:
        """The point of the free space that is nearest."""
        here, _ = nearest_points(self.shape, Point(point))
        return float(here.x), float(here.y)

    def room_at(self, point: Vec2) -> int:
        """The room that a point is in, or in a doorway, the nearest one's."""
        spot = Point(point)
        return min(self._rooms, key=lambda room: room[1].distance(spot))[0]

    def of_room(self, room_id: int) -> BaseGeometry:
        """The part of the free space that lies in a room. KeyError for one that is not there."""
        return self.shape.intersection(dict(self._rooms)[room_id])

    def random(self, rng: Rng) -> Place | None:
        """A pose drawn evenly from the largest connected piece; None where there is no floor."""
        pieces = polygons(self.shape)
        point = random_point(pieces[0], rng) if pieces else None
        if point is None:
            return None
        return Place(*point, float(rng.uniform(-math.pi, math.pi)))

    def route(self, start: Vec2, goal: Vec2) -> tuple[Vec2, ...] | None:
        """The corners of the shortest way within the free space, start and goal among them; None
        where there is none."""
        return self._ways.route(start, goal)
