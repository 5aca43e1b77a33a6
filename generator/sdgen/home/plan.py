"""Floor plans of generated homes: the best of some that were drawn.

A mix says which rooms a home has and which room each opens from; `plan_rooms` sets them against
each other. Of the plans that hold what every room needs, that one is taken in which most rooms are
beside those they wish to be beside, and which is most compact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.catalog.records import HomeMix, RoomType
from sdgen.geometry import Vec2
from sdgen.home.plan_rooms import (
    AREA_SLACK,
    CELL_M,
    DOOR_WALL_M,
    FRONT_DOOR_WALL_M,
    OUTSIDE,
    Rect,
    cells,
    place_rooms,
)
from sdgen.home.walls import Owners, Wall, shared_walls
from sdgen.seeding import Rng

#: Draws of one floor plan, and how many good ones the best is taken of.
TRIES = 300
GOOD_ONES = 6
#: Outer wall that a window needs: the margins of plan_openings at both ends, and by eye 35 cm more.
WINDOW_WALL_M = 1.95
#: Shadows are drawn 10 m to each side of the middle.
LARGEST_M = 18.0
#: Rooms are beside each other that share so much wall.
BESIDE_M = 1.0
EPS = 1e-6
#: What a wish that is met is worth beside a share of the outline that is no room. By eye.
WISH = 0.15


@dataclass(frozen=True)
class PlannedRoom:
    """A room of a plan: what it is for, and its rectangles in metres (middle lines of walls)."""

    name: str
    spec: RoomType
    rectangles_m: tuple[tuple[float, float, float, float], ...]

    @property
    def type(self) -> str:
        """The name of its room type."""
        return self.spec.name

    @property
    def area_m2(self) -> float:
        """Its area to the walls' middle lines."""
        return sum((c - a) * (d - b) for a, b, c, d in self.rectangles_m)


@dataclass(frozen=True)
class Plan:
    """Rooms, the hub first, which room each opens from (the hub from outside), and the walls
    between them and outdoors."""

    rooms: tuple[PlannedRoom, ...]
    parents: tuple[int, ...]
    walls: tuple[Wall, ...]

    def between(self, a: int, b: int) -> tuple[Wall, ...]:
        """Walls that rooms ``a`` and ``b`` share."""
        return tuple(w for w in self.walls if {w.first, w.second} == {a, b})

    def outer(self, room: int) -> tuple[Wall, ...]:
        """Walls of a room that face outdoors."""
        return self.between(room, OUTSIDE)

    def free_before(self, wall: Wall, point: Vec2, far_m: float) -> bool:
        """True when no room stands within ``far_m`` before a point of an outer wall."""
        out = far_m if wall.second == OUTSIDE else -far_m
        low, high = sorted((wall.at_m, wall.at_m + out))
        x, y = point
        return not any(
            (y0 < high - EPS and low + EPS < y1 and x0 < x < x1)
            if wall.along == "x"
            else (x0 < high - EPS and low + EPS < x1 and y0 < y < y1)
            for room in self.rooms
            for x0, y0, x1, y1 in room.rectangles_m
        )

    def wishes(self) -> list[tuple[int, str, bool]]:
        """What rooms wish to be beside that is in this home: the room, the type, and whether it
        is."""
        types = [room.type for room in self.rooms]
        return [
            (k, wish, any(self._beside(k, j) for j, t in enumerate(types) if t == wish and j != k))
            for k, room in enumerate(self.rooms)
            for wish in room.spec.beside
            if wish in types[:k] + types[k + 1 :]
        ]

    def _beside(self, a: int, b: int) -> bool:
        return any(w.length_m >= BESIDE_M - 1e-6 for w in self.between(a, b))


def plans_random(mix: HomeMix, types: Sequence[RoomType], rng: Rng) -> list[Plan]:
    """Floor plans with the rooms of ``mix``, the best first; none when no try came out valid."""
    by_name = {t.name: t for t in types}
    specs = [by_name[name] for name in (mix.hub, *mix.rooms)]
    parents = mix.parents()
    good: list[Plan] = []
    for _ in range(TRIES):
        rects = place_rooms(specs, parents, rng)
        if rects is None or not _compact(rects):
            continue
        plan = _to_plan(_turned(rects, rng), specs, parents)
        if _fits(plan):
            good.append(plan)
        if len(good) == GOOD_ONES:
            break
    return sorted(good, key=_worth, reverse=True)


def _worth(plan: Plan) -> float:
    met = sum(met for _, _, met in plan.wishes())
    return WISH * met + sum(room.area_m2 for room in plan.rooms) / float(np.prod(_size_m(plan)))


def _compact(rects: Sequence[Sequence[Rect]]) -> bool:
    """True when a plan is not too large, and goes round no court."""
    outline = shapely.union_all(shapely.box(*np.array([r for room in rects for r in room]).T))
    x0, y0, x1, y1 = outline.bounds
    fits = max(x1 - x0, y1 - y0) <= cells(LARGEST_M)
    return fits and isinstance(outline, Polygon) and not outline.interiors


def _turned(rects: list[list[Rect]], rng: Rng) -> list[list[Rect]]:
    """The plan turned by a right angle or not, and mirrored or not along each axis."""
    swap, flip_x, flip_y = (bool(rng.integers(2)) for _ in range(3))

    def one(r: Rect) -> Rect:
        if swap:
            r = Rect(r.y0, r.x0, r.y1, r.x1)
        if flip_x:
            r = Rect(-r.x1, r.y0, -r.x0, r.y1)
        if flip_y:
            r = Rect(r.x0, -r.y1, r.x1, -r.y0)
        return r

    return [[one(r) for r in room] for room in rects]


def _to_plan(rects: list[list[Rect]], specs: Sequence[RoomType], parents: tuple[int, ...]) -> Plan:
    """Centred, in metres, with the walls found."""
    every = [r for room in rects for r in room]
    x0, y0 = min(r.x0 for r in every) - 1, min(r.y0 for r in every) - 1
    columns, rows = max(r.x1 for r in every) - x0 + 1, max(r.y1 for r in every) - y0 + 1
    grid = np.full((columns, rows), OUTSIDE, dtype=np.int64)
    owners = Owners(grid, CELL_M)
    counts: dict[str, int] = {}
    rooms = []
    for index, (spec, own) in enumerate(zip(specs, rects, strict=True)):
        counts[spec.name] = counts.get(spec.name, 0) + 1
        name = spec.name if counts[spec.name] == 1 else f"{spec.name}_{counts[spec.name]}"
        shown = []
        for r in own:
            grid[r.x0 - x0 : r.x1 - x0, r.y0 - y0 : r.y1 - y0] = index
            low = owners.corner(r.x0 - x0, r.y0 - y0)
            high = owners.corner(r.x1 - x0, r.y1 - y0)
            shown.append((*low, *high))
        rooms.append(PlannedRoom(name, spec, tuple(shown)))
    return Plan(tuple(rooms), parents, shared_walls(owners))


def _fits(plan: Plan) -> bool:
    """True when every room has its door wall and its daylight, and the area its type asks."""
    if not any(w.length_m >= FRONT_DOOR_WALL_M for w in plan.outer(0)):
        return False
    for index, (room, parent) in enumerate(zip(plan.rooms, plan.parents, strict=True)):
        low, high = room.spec.area_m2
        if not (1 - AREA_SLACK) * low <= room.area_m2 <= (1 + AREA_SLACK) * high:
            return False
        if index and not any(w.length_m >= DOOR_WALL_M - 1e-6 for w in plan.between(parent, index)):
            return False
        lit = any(w.length_m >= WINDOW_WALL_M - 1e-6 for w in plan.outer(index))
        if room.spec.daylight and not lit:
            return False
    return True


def _size_m(plan: Plan) -> tuple[float, float]:
    points = np.array([r for room in plan.rooms for r in room.rectangles_m])
    x, y = (points[:, 2:].max(axis=0) - points[:, :2].min(axis=0)).tolist()
    return x, y
