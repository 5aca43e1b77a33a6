"""Where an agent stands to get at a thing, and what it gets at from where it stands."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import nearest_points

from sdgen.agent.walk import Floor
from sdgen.agent.ways import TOUCH_M, length_m
from sdgen.cameras.lens import Gaze
from sdgen.freespace import ROBOT_RADIUS_M, polygons, union
from sdgen.geometry import Vec2
from sdgen.scene import Scene

#: How far from where its middle is an agent gets at things, metres, on the floor plan: a grown-up's
#: arm, leaning over a worktop or a bed. Of 621 anomalies 614 lay within 1.0 m of floor that can be
#: got to, 619 within 1.25 m, two on coffee tables that no way leads to.
REACH_M = 1.25
#: Walls that begin higher are above a doorway, metres.
_OVERHEAD_M = 1.5
#: Things reach so far into walls, metres.
_IN_WALL_M = 0.02
#: Places that are looked at beside a thing lie so far apart, metres.
_GRID_M = 0.2


class Arms:
    """What can be got at in a home within ``reach_m``, through no wall. Heights do not matter."""

    def __init__(self, scene: Scene, reach_m: float = REACH_M) -> None:
        self.reach_m = reach_m
        self.floor = Floor(scene)
        self._rooms = {room.id: Polygon(room.polygon_m) for room in scene.home.rooms}
        self._openings: Mapping[int, tuple[int, ...]] = {
            one.object_id: one.room_ids for one in scene.home.openings
        }
        walls = [
            shapely.box(*(middle[:2] - half[:2]), *(middle[:2] + half[:2]))
            for structure in scene.home.structures
            if structure.category == "wall"
            for piece in structure.pieces
            for middle, half in [(np.array(piece.center_m), np.array(piece.size_m) / 2)]
            if middle[2] - half[2] < _OVERHEAD_M
        ]
        self._walls = union(walls).buffer(-_IN_WALL_M)
        shapely.prepare(self._walls)

    @cached_property
    def _pieces(self) -> list[Polygon]:
        """Floor that hangs together, as ways do."""
        return polygons(self.floor.open_shape.buffer(TOUCH_M, join_style="mitre"))

    def start(self, scene: Scene) -> Gaze:
        """Where a scene's agent begins; where that is a pocket between furniture that no way leads
        out of, the nearest place of the floor that most ways are on."""
        x, y, _ = scene.agent_start.position_m
        place = Gaze(x, y, scene.agent_start.yaw_rad)
        if not self._pieces or self._pieces[0].distance(Point(x, y)) <= TOUCH_M:
            return place
        near = nearest_points(self._pieces[0].intersection(self.floor.open_shape), Point(x, y))[0]
        return Gaze(float(near.x), float(near.y), place.yaw_rad)

    def reaches(self, point: Vec2, footprint: BaseGeometry, opening: int | None = None) -> bool:
        """Whether what has this footprint is got at from a point; ``opening``: it is the door or
        window of this id, which is got at from the rooms on its sides."""
        here = Point(point)
        near = nearest_points(footprint, here)[0]
        if here.distance(near) > self.reach_m:
            return False
        if opening is not None and opening in self._openings:
            return self.floor.room_at(point) in self._openings[opening]
        return not self._walls.intersects(LineString([point, (near.x, near.y)]))

    def beside(
        self, place: Gaze, footprint: BaseGeometry, room_id: int, opening: int | None = None
    ) -> Gaze | None:
        """The nearest place to a thing that can be got to and from which it is got at, looking at
        it; None where there is none."""
        around = self._reached(place).intersection(footprint.buffer(self.reach_m))
        room = self._rooms.get(room_id)
        inside = around if room is None else around.intersection(room)
        # One stands on nothing that lies on the floor, and in no leaf.
        off = footprint.buffer(ROBOT_RADIUS_M)
        for shape in (inside.difference(off), inside, around.difference(off), around):
            for point in _candidates(shape, footprint):
                if self.reaches(point, footprint, opening):
                    near = nearest_points(footprint, Point(point))[0]
                    return Gaze(*point, math.atan2(near.y - point[1], near.x - point[0]))
        return None

    def into_room(self, place: Gaze, room_id: int) -> Gaze | None:
        """The nearest place in a room, looking ahead; None where there is none."""
        inside = self._reached(place).intersection(self._rooms[room_id].buffer(-_IN_WALL_M))
        if inside.is_empty:
            return None
        near = nearest_points(inside, Point(place.point))[0]
        ahead = math.atan2(near.y - place.y_m, near.x - place.x_m)
        return Gaze(float(near.x), float(near.y), ahead)

    def way_m(self, place: Gaze, other: Gaze) -> float | None:
        """How long the shortest way between two places is; None where there is none."""
        way = self.floor.route(place.point, other.point, doors=True)
        return None if way is None else length_m(way)

    def _reached(self, place: Gaze) -> BaseGeometry:
        here = Point(place.point)
        mine = [piece for piece in self._pieces if piece.distance(here) <= TOUCH_M]
        return union(mine).intersection(self.floor.open_shape)


def _candidates(shape: BaseGeometry, footprint: BaseGeometry) -> Iterator[Vec2]:
    """Points of a shape, those nearest to a footprint first."""
    if shape.is_empty:
        return
    first = nearest_points(shape, footprint)[0]
    yield float(first.x), float(first.y)
    x0, y0, x1, y1 = shape.bounds
    xs, ys = np.meshgrid(np.arange(x0, x1, _GRID_M), np.arange(y0, y1, _GRID_M), indexing="ij")
    points = np.column_stack([xs.ravel(), ys.ravel()])
    points = points[shapely.contains_xy(shape, points[:, 0], points[:, 1])]
    far = shapely.distance(shapely.points(points), footprint)
    ordered = points[np.lexsort((points[:, 1], points[:, 0], far))].tolist()
    yield from ((x, y) for x, y in ordered)
