"""Where a robot can stand and go: free floor, connected through doors.

Free space is the rooms' floor minus everything that stands on it, grown by the robot's radius.
Polygons are written without holes (cut along lines), so a ring is all a reader needs.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from shapely.geometry import LineString, MultiPolygon, Polygon
from shapely.geometry import box as shapely_box
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.geometry import Vec2
from sdgen.scene import Home, Opening, Room
from sdgen.vocabulary import HALF_WALL_M

#: Half the width of common home robots (Stretch 0.34 m, TIAGo and Fetch 0.54 to 0.56 m across),
#: and about that of a walking person.
ROBOT_RADIUS_M = 0.25
#: Cells of the path search: finer than the least gap that a robot of that radius could miss.
GRID_M = 0.1
#: How far free space reaches through a doorway beyond the middle of the wall, over the robot's
#: radius: half a wall, and 2 cm so that the two rooms' areas surely meet.
THROUGH_DOOR_M = HALF_WALL_M + 0.02
#: Free space is written in millimetres.
_MM = 1e-3
#: Rings may leave out what is less than this beside them.
_SIMPLER_M = 0.01
#: What has less area, square metres, is a sliver that cutting left.
LEAST_M2 = 1e-4
#: Floor of a room that a robot's middle can get to, square metres, or the room is cut off: a spot
#: of 0.45 m squared, more than the piece of a doorway that free space has in the room.
LEAST_REACHED_M2 = 0.2
#: A point is drawn from a shape's box so often; a shape that fills so little of it has a middle.
POINT_TRIES = 40
#: Nearly always one of so many is in it: the others are looked at only then.
_FEW = 6


def opening_rectangle(opening: Opening, depth_m: float) -> Polygon:
    """The opening seen from above, ``depth_m`` to both sides of the wall's middle line."""
    x, y, _ = opening.center_m
    half = opening.width_m / 2
    if opening.along == "x":
        return shapely_box(x - half, y - depth_m, x + half, y + depth_m)
    return shapely_box(x - depth_m, y - half, x + depth_m, y + half)


def polygons(shape: BaseGeometry) -> list[Polygon]:
    """The polygons of a geometry, largest first, slivers dropped."""
    if isinstance(shape, Polygon):
        found = [shape]
    elif hasattr(shape, "geoms"):
        found = [p for part in shape.geoms for p in polygons(part)]
    else:
        found = []
    return sorted((p for p in found if p.area > LEAST_M2), key=lambda p: (-p.area, p.bounds))


def without_holes(shape: BaseGeometry, grid_m: float | None = None) -> list[Polygon]:
    """Polygons without holes that cover ``shape``: each holed one is cut through its hole.

    With ``grid_m``, cuts are rounded to it, and valid still.
    """
    out: list[Polygon] = []
    for polygon in polygons(shape):
        if not polygon.interiors:
            out.append(polygon)
            continue
        x0, y0, x1, y1 = polygon.bounds
        cut = Polygon(polygon.interiors[0]).centroid.x
        for half in (shapely_box(x0, y0, cut, y1), shapely_box(cut, y0, x1, y1)):
            out += without_holes(shapely.intersection(polygon, half, grid_size=grid_m), grid_m)
    return out


def free_shape(
    home: Home, obstacles: Iterable[BaseGeometry], radius_m: float = ROBOT_RADIUS_M
) -> BaseGeometry:
    """Where the centre of a round robot can be, doorways included."""
    grown = shapely.union_all(shapely.buffer(list(obstacles), radius_m, quad_segs=2))
    areas: list[BaseGeometry] = []
    for room in home.rooms:
        areas.append(Polygon(room.polygon_m).buffer(-radius_m, join_style="mitre"))
    for opening in home.openings:
        if len(opening.room_ids) == 2:
            gap = opening_rectangle(opening, radius_m + THROUGH_DOOR_M)
            x0, y0, x1, y1 = gap.bounds
            inset = min(radius_m, opening.width_m / 2 - 0.02)
            if opening.along == "x":
                areas.append(shapely_box(x0 + inset, y0, x1 - inset, y1))
            else:
                areas.append(shapely_box(x0, y0 + inset, x1, y1 - inset))
    return unary_union(areas).difference(grown)


def unreachable_rooms(
    home: Home, free: BaseGeometry, area_needed_m2: float = LEAST_REACHED_M2
) -> list[Room]:
    """Rooms that cannot be reached from the largest connected piece of free space."""
    pieces = polygons(free)
    if not pieces:
        return list(home.rooms)
    main = pieces[0]
    return [
        room
        for room in home.rooms
        if main.intersection(Polygon(room.polygon_m)).area < area_needed_m2
    ]


def rounded_rings(shape: BaseGeometry) -> tuple[tuple[Vec2, ...], ...]:
    """Hole-free rings in millimetres, in a fixed order; none crosses or touches itself."""
    # Points that are rounded one by one can make a thin neck cross itself.
    whole = shapely.set_precision(shape.simplify(_SIMPLER_M), _MM)
    rings = []
    for polygon in without_holes(whole, _MM):
        points = list(shapely.normalize(polygon).exterior.coords)[:-1]
        rings.append(tuple((round(x, 3) + 0.0, round(y, 3) + 0.0) for x, y in points))
    return tuple(sorted(rings))


class Grid:
    """Free space as cells of 0.1 m, to find ways through."""

    def __init__(self, free: BaseGeometry) -> None:
        shape = free.buffer(0.01)
        x0, y0, x1, y1 = shape.bounds
        # A rim of blocked cells around, so that every cell has eight neighbours.
        xs = np.arange(x0 - GRID_M, x1 + 2 * GRID_M, GRID_M)
        ys = np.arange(y0 - GRID_M, y1 + 2 * GRID_M, GRID_M)
        grid_x, grid_y = np.meshgrid(xs, ys, indexing="ij")
        shapely.prepare(shape)
        inside = shapely.contains_xy(shape, grid_x, grid_y)
        inside[[0, -1]] = False
        inside[:, [0, -1]] = False
        self._free: list[bool] = inside.ravel().tolist()
        self._rows = len(ys)
        self._across, self._along = np.divmod(np.arange(inside.size), len(ys))
        self._cells = np.flatnonzero(inside)
        self._points = np.column_stack([grid_x.ravel(), grid_y.ravel()])

    def route(self, start: Vec2, goal: Vec2) -> LineString | None:
        """A short path between two points, by A* (Hart et al. 1968); None if there is none."""
        if len(self._cells) == 0:
            return None
        first, last = self._nearest(start), self._nearest(goal)
        cells = self._path(first, last) if first != last else None
        if cells is None:
            return None
        return LineString([start, *self._points[cells].tolist(), goal]).simplify(0.1)

    def _nearest(self, point: Vec2) -> int:
        apart = ((self._points[self._cells] - point) ** 2).sum(axis=1)
        return int(self._cells[int(np.argmin(apart))])

    def _path(self, first: int, last: int) -> list[int] | None:
        rows = self._rows
        left = self._left(last)
        diagonal = math.sqrt(2.0)
        steps = [(1, 1.0), (-1, 1.0), (rows, 1.0), (-rows, 1.0)]
        steps += [(rows * a + b, diagonal) for a in (1, -1) for b in (1, -1)]
        # What is not free counts as reached already, for less than any way.
        cost = [math.inf if free else -1.0 for free in self._free]
        cost[first] = 0.0
        before: dict[int, int] = {}
        done: set[int] = set()
        queue = [(0.0, first)]
        while queue:
            _, cell = heapq.heappop(queue)
            if cell == last:
                path = [last]
                while path[-1] != first:
                    path.append(before[path[-1]])
                return path[::-1]
            if cell in done:
                continue
            done.add(cell)
            here = cost[cell]
            for move, length in steps:
                other = cell + move
                reached = here + length
                if reached < cost[other]:
                    cost[other], before[other] = reached, cell
                    heapq.heappush(queue, (reached + left[other], other))
        return None

    def _left(self, goal: int) -> list[float]:
        """No way from each cell to a goal is shorter, in cells."""
        across = np.abs(self._across - self._across[goal])
        along = np.abs(self._along - self._along[goal])
        shorter = (math.sqrt(2.0) - 1.0) * np.minimum(across, along)
        left: list[float] = (np.maximum(across, along) + shorter).tolist()
        return left


def lattice_points(shape: BaseGeometry, spacing_m: float) -> list[Vec2]:
    """Points of a square lattice within a shape, by x and then y."""
    if shape.is_empty:
        return []
    x0, y0, x1, y1 = shape.bounds
    xs, ys = (
        np.arange(math.ceil(low / spacing_m), math.floor(high / spacing_m) + 1) * spacing_m
        for low, high in ((x0, x1), (y0, y1))
    )
    x, y = (axis.ravel() for axis in np.meshgrid(xs, ys, indexing="ij"))
    inside = shapely.contains_xy(shape, x, y)
    return list(zip(x[inside].tolist(), y[inside].tolist(), strict=True))


class Pieces:
    """A shape taken apart once, to draw points from it."""

    def __init__(self, shape: BaseGeometry) -> None:
        self._pieces = polygons(shape)
        areas = np.array([piece.area for piece in self._pieces])
        sums = (areas / areas.sum()).cumsum()
        self._sums = sums / sums[-1:]

    def random_point(self, rng: np.random.Generator) -> Vec2 | None:
        """A point drawn evenly from the shape; None when it has no area worth the name."""
        if not self._pieces:
            return None
        piece = self._pieces[0]
        if len(self._pieces) > 1:
            # What rng.choice with weights does, without summing them again for every point.
            piece = self._pieces[int(self._sums.searchsorted(rng.random(), side="right"))]
        x0, y0, x1, y1 = piece.bounds
        points = rng.random((POINT_TRIES, 2)) * (x1 - x0, y1 - y0) + (x0, y0)
        for some in (points[:_FEW], points[_FEW:]):
            inside = shapely.contains_xy(piece, some[:, 0], some[:, 1])
            if inside.any():
                x, y = some[inside.argmax()].tolist()
                return x, y
        point = piece.representative_point()
        return float(point.x), float(point.y)


def random_point(shape: BaseGeometry, rng: np.random.Generator) -> Vec2 | None:
    """A point drawn evenly from a shape; None when it has no area worth the name."""
    return Pieces(shape).random_point(rng)


def union(shapes: Sequence[BaseGeometry]) -> BaseGeometry:
    """Union of shapes; an empty polygon for none."""
    return unary_union(shapes) if shapes else MultiPolygon()
