"""Where an agent can be in a home, and its ways there: never through walls, doors or furniture."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from itertools import pairwise

import shapely
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import nearest_points, unary_union

from sdgen.agent.ways import Ways
from sdgen.cameras.lens import Gaze
from sdgen.freespace import (
    ROBOT_RADIUS_M,
    THROUGH_DOOR_M,
    opening_rectangle,
    polygons,
    random_point,
    union,
)
from sdgen.geometry import Vec2
from sdgen.scene import Opening, Scene
from sdgen.seeding import Rng
from sdgen.vocabulary import LEAVES

#: Rings are rounded to millimetres: a step along an edge is still inside.
_ROUNDED_M = 0.002
#: Rings are cut from one shape and simplified to a centimetre: seams between them are no gaps.
_SEAM_M = 0.011


class Floor:
    """The floor of a scene on which an agent of the robot's radius can be.

    It is the scene's ``free_space`` without what else is ``standing`` in the way, outlines on the
    plan, and without the doorways whose leaves are shut: to ``open_shape`` these belong, too.
    """

    def __init__(self, scene: Scene, standing: Iterable[BaseGeometry] = ()) -> None:
        rings = [Polygon(ring).buffer(0) for ring in scene.free_space]
        shape: BaseGeometry = unary_union(rings).buffer(_SEAM_M, join_style="mitre")
        shape = shape.buffer(-_SEAM_M, join_style="mitre")
        grown = shapely.buffer(list(standing), ROBOT_RADIUS_M, quad_segs=2).tolist()
        self.open_shape = shape.difference(union(grown)) if grown else shape
        self.shut = shut_doors(scene)
        self.shape = self.open_shape.difference(union(list(self.shut.values())))
        self._within = self.shape.buffer(_ROUNDED_M)
        shapely.prepare(self._within)
        self._rooms = [(room.id, Polygon(room.polygon_m)) for room in scene.home.rooms]

    @cached_property
    def _ways(self) -> Ways:
        return Ways(self.shape)

    @cached_property
    def open_ways(self) -> Ways:
        """The ways that there are when all doors are opened."""
        return Ways(self.open_shape) if self.shut else self._ways

    def holds(self, point: Vec2) -> bool:
        """Whether an agent can stand there."""
        return bool(shapely.contains_xy(self._within, *point))

    def step(self, gaze: Gaze, distance_m: float) -> tuple[Gaze, bool]:
        """Where a straight step ends, and whether something was in the way: then as far as it goes
        without touching it."""
        dx, dy = math.cos(gaze.yaw_rad), math.sin(gaze.yaw_rad)
        end = gaze._replace(x_m=gaze.x_m + distance_m * dx, y_m=gaze.y_m + distance_m * dy)
        way = LineString([gaze.point, end.point])
        if shapely.covers(self._within, way):
            return end, False
        inside = shapely.intersection(self.shape, way)
        gone = 0.0
        for piece in getattr(inside, "geoms", [inside]):
            if isinstance(piece, LineString) and piece.distance(Point(gaze.point)) < _ROUNDED_M:
                gone = max(math.dist(gaze.point, corner) for corner in piece.coords)
        gone = min(gone, distance_m)
        return gaze._replace(x_m=gaze.x_m + gone * dx, y_m=gaze.y_m + gone * dy), True

    @staticmethod
    def nearest_in(shape: BaseGeometry, to: BaseGeometry) -> Vec2:
        """The point of a shape that is nearest to another."""
        here, _ = nearest_points(shape, to)
        return float(here.x), float(here.y)

    def outline_of(self, room_id: int) -> Polygon:
        """A room's inner outline. KeyError for one that is not there."""
        return dict(self._rooms)[room_id]

    def room_at(self, point: Vec2) -> int:
        """The room that a point is in, or in a doorway, the nearest one's."""
        spot = Point(point)
        return min(self._rooms, key=lambda room: room[1].distance(spot))[0]

    def within_reach(self, start: Vec2) -> BaseGeometry:
        """The part of the floor that can be got to from a point, doors being opened on the way."""
        pieces = polygons(self.open_shape)
        return next((p for p in pieces if p.distance(Point(start)) < _ROUNDED_M), Polygon())

    @property
    def main(self) -> BaseGeometry:
        """The largest connected piece of the floor, but for the doorways that are shut in it: from
        there every room can be got to, as far as nothing was put in the way."""
        pieces = polygons(self.open_shape)
        return pieces[0].intersection(self.shape) if pieces else Polygon()

    def random(self, rng: Rng) -> Gaze | None:
        """A pose drawn evenly from the main piece; None where there is no floor."""
        point = random_point(self.main, rng)
        if point is None:
            return None
        return Gaze(*point, float(rng.uniform(-math.pi, math.pi)))

    def route(self, start: Vec2, goal: Vec2, doors: bool = False) -> tuple[Vec2, ...] | None:
        """The corners of the shortest way on the free floor, start and goal among them; None where
        there is none. ``doors``: through those that are shut, too."""
        return (self.open_ways if doors else self._ways).route(start, goal)

    def shut_on(self, way: Sequence[Vec2]) -> tuple[int, ...]:
        """Ids of the shut doors that a way leads through, in their order."""
        found: dict[int, None] = {}
        for leg in map(LineString, pairwise(way)):
            crossed = [
                (leg.project(hole.centroid), key)
                for key, hole in self.shut.items()
                if leg.intersection(hole).length > _ROUNDED_M
            ]
            found |= dict.fromkeys(key for _, key in sorted(crossed))
        return tuple(found)


def shut_doors(scene: Scene) -> Mapping[int, Polygon]:
    """The doorways between rooms whose door is shut, by its id: where no robot can be."""
    states = {item.id: item.states for item in scene.objects if item.category in LEAVES}
    return {
        opening.object_id: _doorway(opening)
        for opening in scene.home.openings
        if len(opening.room_ids) == 2 and "CLOSED" in states.get(opening.object_id, ())
    }


def _doorway(opening: Opening) -> Polygon:
    """A doorway and as much to both sides of it as a robot before a shut door is kept off."""
    return opening_rectangle(opening, ROBOT_RADIUS_M + THROUGH_DOOR_M)
