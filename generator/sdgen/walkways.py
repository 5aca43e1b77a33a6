"""Where people walk in a room: the ways between its doorways and to the furniture they use, and
the open floor.

A way is the shortest that a person can take, 0.9 m wide: ADA 2010, section 403.5.1, asks for 36
inches (0.915 m) of clear width on walking surfaces. Ways that furniture narrows are as wide as it
leaves them. Open floor is what lies further from walls and furniture than things that are put
aside do: people cross it as they please. A person may take another way than the shortest: gaps that
one can pass, but not two, are on none of these ways and yet no place to put something aside.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import combinations

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import nearest_points

from sdgen.facts import Body
from sdgen.freespace import ROBOT_RADIUS_M, Grid
from sdgen.geometry import Vec2, apply
from sdgen.vocabulary import FLAT_M, OPENINGS

#: Half the width of a way: ADA's 0.915 m, less what is within a hand's breadth of nobody's step.
WALKWAY_HALF_M = 0.45
#: Further than this from walls and furniture is open floor. A judgement: what was put aside lies
#: within a forearm of what it was put against.
OPEN_FLOOR_M = 0.4
#: Category properties of furniture that people walk up to: to sit or lie down, to open, switch or
#: fill it, to put something on it. What only stands there (a plant) has none of them.
USED = frozenset(
    {
        "CAN_OPEN",
        "CONTAINERS",
        "HAS_SWITCH",
        "HEAT_SOURCE",
        "LIEABLE",
        "RECIPIENT",
        "SITTABLE",
        "SURFACES",
        "WATER_SOURCE",
    }
)
#: And of those that they sit down at or on, or get out of: feet are set down all about them.
GOT_AT = frozenset({"LIEABLE", "SAT_AT", "SITTABLE"})
#: Who uses a piece stands so far before it: the middle of a body 0.5 m across, an arm bent.
BEFORE_M = ROBOT_RADIUS_M + 0.15
#: A side whose standing place is further from free floor than this is against a wall or a table.
AT_MOST_OFF_M = 0.4
#: Between what is less than this apart, people walk in single file, in the middle: two bodies of
#: 0.5 m. Between what is less than the other apart nobody does: hips are about so broad (a
#: judgement; large adults turn sideways).
SINGLE_FILE_M, SQUEEZED_M = 1.0, 0.35
#: Chairs stand at a table, are drawn back and got at over so much floor about it: their depth and
#: a hand's breadth (by eye, of our models). Feet are set down as far from a seat or a bed:
#: people who saw pictures took what lay beside one for something to trip over.
SEATED_M = 0.6
#: Who opens, switches or fills a piece stands so far before it, somewhere along its width, and who
#: comes home about the front door: a drawer's depth, or a step aside (a judgement).
USED_FROM_M = 0.5
#: Strips narrower than twice this are where two shapes nearly meet: nobody walks along them.
SLIVER_M = 0.05


def used(furniture: Sequence[Body], properties: Mapping[str, Collection[str]]) -> list[Body]:
    """Furniture that people walk up to: it stands on the floor and is good for something."""
    return [
        body
        for body in furniture
        if body.low[2] < FLAT_M < body.high[2]
        and body.item.category not in OPENINGS
        and not USED.isdisjoint(properties.get(body.item.category, ()))
    ]


def walked(
    outline: Polygon,
    ends: Sequence[Vec2],
    furniture: Sequence[Body],
    properties: Mapping[str, Collection[str]],
    free: BaseGeometry,
    standing: BaseGeometry,
    open_floor: BaseGeometry,
) -> BaseGeometry:
    """The floor of a room that people walk on.

    ``ends`` are points just inside its doorways, ``furniture`` what they use in it; ``free`` is
    where the middle of a walker can be, ``standing`` what a walker cannot step over and
    ``open_floor`` the floor far from it, all three of the whole home.
    """
    inside = free.intersection(outline)
    if inside.is_empty or not ends:
        return open_floor.intersection(outline)
    ways = _Ways(inside)
    pairs = list(combinations(ends, 2))
    goals = [goal for body in furniture for goal in _before(body, properties, inside)]
    pairs += [(end, goal) for end in ends for goal in goals]
    paths = [path for a, b in pairs if (path := ways.between(a, b)) is not None]
    strips = shapely.buffer(paths, WALKWAY_HALF_M, quad_segs=2).tolist()
    shape = shapely.union_all([*strips, open_floor]).intersection(outline).difference(standing)
    return shape.buffer(-SLIVER_M, join_style="mitre").buffer(SLIVER_M, join_style="mitre")


def _before(
    body: Body, properties: Mapping[str, Collection[str]], inside: BaseGeometry
) -> Iterator[Vec2]:
    """Where somebody stands who uses a piece: before its front; beside it, too, to lie down.

    A chair at its table is got at from the side: what has no such place is used from the floor
    that is nearest to its middle.
    """
    half_x, half_y = body.info.extents_m[0] / 2 + BEFORE_M, body.info.extents_m[1] / 2 + BEFORE_M
    local = [(half_x, 0.0, 0.0)]
    if "LIEABLE" in properties.get(body.item.category, ()):
        local += [(0.0, half_y, 0.0), (0.0, -half_y, 0.0)]
    middle, *spots = shapely.points(
        apply(body.world_from_object, [(0.0, 0.0, 0.0), *local])[:, :2]
    ).tolist()
    near = [spot for spot in spots if inside.distance(spot) <= AT_MOST_OFF_M]
    if not near and inside.distance(middle) <= max(half_x, half_y):
        near = [middle]
    for spot in near:
        there = nearest_points(inside, spot)[0]
        yield (there.x, there.y)


def narrow(
    outline: Polygon,
    standing: Sequence[BaseGeometry],
    got_at: Sequence[BaseGeometry],
    used_from: Sequence[BaseGeometry] = (),
) -> BaseGeometry:
    """Floor of a room that people use whether or not a way leads there: the middles of gaps that
    they pass in single file, between pieces of furniture (their outlines: ``standing``) or one and
    a wall; where they sit down at tables or on seats and get out of bed (``got_at``); and where
    they stand to use things (``used_from``).
    """
    corners = shapely.get_coordinates(outline)
    walls = shapely.linestrings(np.stack([corners[:-1], corners[1:]], axis=1))
    shapes = np.array([*walls, *standing], dtype=object)
    first, second = shapely.STRtree(shapes).query(shapes, "dwithin", SINGLE_FILE_M)
    once = first < second
    first, second = first[once], second[once]
    passed = shapely.distance(shapes[first], shapes[second]) >= SQUEEZED_M
    near = shapely.buffer(shapes, SINGLE_FILE_M / 2, quad_segs=2)
    middles = shapely.intersection(near[first[passed]], near[second[passed]])
    seats = shapely.buffer(list(got_at), SEATED_M, quad_segs=2)
    return shapely.union_all([*middles, *seats, *used_from]).intersection(outline)


def front(body: Body) -> BaseGeometry:
    """The floor before a piece of furniture from which it is used, as wide as it is."""
    half_x, half_y = body.info.extents_m[0] / 2, body.info.extents_m[1] / 2
    far = half_x + USED_FROM_M
    ring = [(half_x, -half_y, 0.0), (far, -half_y, 0.0), (far, half_y, 0.0), (half_x, half_y, 0.0)]
    return Polygon(apply(body.world_from_object, ring)[:, :2])


class _Ways:
    """Shortest ways through the free floor of a room."""

    def __init__(self, inside: BaseGeometry) -> None:
        self._inside = inside
        # Points on its very edge count as free.
        self._around = inside.buffer(0.02)
        shapely.prepare(self._around)
        self._grid: Grid | None = None

    def between(self, start: Vec2, goal: Vec2) -> LineString | None:
        """Straight ahead where nothing stands between; else through a grid; None: no way."""
        if np.allclose(start, goal):
            return None
        straight = LineString([start, goal])
        if self._around.covers(straight):
            return straight
        if self._grid is None:
            self._grid = Grid(self._inside)
        return self._grid.route(start, goal)
