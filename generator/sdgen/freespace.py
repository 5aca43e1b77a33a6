"""Where a robot can stand and go: free floor, connected through doors.

Free space is the rooms' floor minus everything that stands on it, grown by the robot's radius.
Polygons are written without holes (cut along lines), so a ring is all a reader needs.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import networkx as nx
import numpy as np
import shapely
from shapely.geometry import LineString, MultiPolygon, Point, Polygon
from shapely.geometry import box as shapely_box
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.geometry import Vec2
from sdgen.scene import Home, Opening, Room

ROBOT_RADIUS_M = 0.25
GRID_M = 0.1


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
    return sorted((p for p in found if p.area > 1e-4), key=lambda p: (-p.area, p.bounds))


def without_holes(shape: BaseGeometry) -> list[Polygon]:
    """Polygons without holes that cover ``shape``: each holed one is cut through its hole."""
    out: list[Polygon] = []
    for polygon in polygons(shape):
        if not polygon.interiors:
            out.append(polygon)
            continue
        x0, y0, x1, y1 = polygon.bounds
        cut = Polygon(polygon.interiors[0]).centroid.x
        for half in (shapely_box(x0, y0, cut, y1), shapely_box(cut, y0, x1, y1)):
            out += without_holes(polygon.intersection(half))
    return out


def free_shape(
    home: Home, obstacles: Iterable[BaseGeometry], radius_m: float = ROBOT_RADIUS_M
) -> BaseGeometry:
    """Where the centre of a round robot can be, doorways included."""
    grown = unary_union([o.buffer(radius_m, quad_segs=2) for o in obstacles])
    areas: list[BaseGeometry] = []
    for room in home.rooms:
        areas.append(Polygon(room.polygon_m).buffer(-radius_m, join_style="mitre"))
    for opening in home.openings:
        if opening.kind == "door":
            gap = opening_rectangle(opening, radius_m + 0.08)
            x0, y0, x1, y1 = gap.bounds
            inset = min(radius_m, opening.width_m / 2 - 0.02)
            if opening.along == "x":
                areas.append(shapely_box(x0 + inset, y0, x1 - inset, y1))
            else:
                areas.append(shapely_box(x0, y0 + inset, x1, y1 - inset))
    return unary_union(areas).difference(grown)


def reachable(home: Home, free: BaseGeometry, area_needed_m2: float = 0.2) -> list[Room]:
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
    """Hole-free rings in millimetres, in a fixed order."""
    rings = []
    for polygon in without_holes(shape):
        simple = shapely.normalize(polygon.simplify(0.01))
        points = list(simple.exterior.coords)[:-1]
        rings.append(tuple((round(x, 3) + 0.0, round(y, 3) + 0.0) for x, y in points))
    return tuple(sorted(rings))


def route(free: BaseGeometry, start: Vec2, goal: Vec2) -> LineString | None:
    """A short path in free space between two points, on a grid of 0.1 m; None if there is none."""
    shape = free.buffer(0.01)
    x0, y0, x1, y1 = shape.bounds
    xs = np.arange(x0, x1 + GRID_M, GRID_M)
    ys = np.arange(y0, y1 + GRID_M, GRID_M)
    grid_x, grid_y = np.meshgrid(xs, ys, indexing="ij")
    inside = shapely.contains_xy(shape, grid_x, grid_y)
    graph = nx.Graph()
    columns, rows = inside.shape
    for i in range(columns):
        for j in range(rows):
            if not inside[i, j]:
                continue
            for di, dj, cost in ((1, 0, 1.0), (0, 1, 1.0), (1, 1, 1.4142), (1, -1, 1.4142)):
                a, b = i + di, j + dj
                if 0 <= a < columns and 0 <= b < rows and inside[a, b]:
                    graph.add_edge((i, j), (a, b), weight=cost)
    ends = [_nearest(inside, xs, ys, point) for point in (start, goal)]
    if ends[0] is None or ends[1] is None or ends[0] == ends[1]:
        return None
    try:
        path = nx.dijkstra_path(graph, ends[0], ends[1])
    except (nx.NetworkXNoPath, nx.NodeNotFound):
        return None
    return LineString([start, *((float(xs[i]), float(ys[j])) for i, j in path), goal]).simplify(0.1)


def _nearest(
    inside: np.ndarray[tuple[int, ...], np.dtype[np.bool_]],
    xs: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    ys: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    point: Vec2,
) -> tuple[int, int] | None:
    cells = np.argwhere(inside)
    if len(cells) == 0:
        return None
    apart = (xs[cells[:, 0]] - point[0]) ** 2 + (ys[cells[:, 1]] - point[1]) ** 2
    i, j = cells[int(np.argmin(apart))]
    return int(i), int(j)


def random_point(shape: BaseGeometry, rng: np.random.Generator, tries: int = 40) -> Vec2 | None:
    """A point drawn evenly from a shape; None when it has no area worth the name."""
    pieces = polygons(shape)
    if not pieces:
        return None
    areas = np.array([p.area for p in pieces])
    piece = pieces[int(rng.choice(len(pieces), p=areas / areas.sum()))]
    x0, y0, x1, y1 = piece.bounds
    for _ in range(tries):
        x, y = float(rng.uniform(x0, x1)), float(rng.uniform(y0, y1))
        if piece.contains(Point(x, y)):
            return x, y
    point = piece.representative_point()
    return float(point.x), float(point.y)


def union(shapes: Sequence[BaseGeometry]) -> BaseGeometry:
    """Union of shapes; an empty polygon for none."""
    return unary_union(shapes) if shapes else MultiPolygon()
