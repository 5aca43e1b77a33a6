"""Floor plans of generated homes: rooms set against the sides of a hub that they all open from.

A hall or a living room is the hub; the other rooms stand along three of its sides, each as wide
and deep as its area asks, so that outlines are rectangles, L-shapes or stepped. Sampled by tries
that cost microseconds, unlike the grid growth of Lopes et al. (2010) and ProcTHOR (Deitke et al.
2022, appendix): that was tried first, and fewer than one try in fifty gave every room a wall to
the hub wide enough for a door.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import HomeMix, RoomType
from sdgen.home.walls import Owners, Wall, shared_walls
from sdgen.seeding import Rng

#: Walls lie on a grid this wide.
CELL_M = 0.1
OUTSIDE = -1
#: Draws of one floor plan; of 170 plans half came at the first, the last at the 17th.
TRIES = 200
#: Shared or outer wall that a door, a front door, a window needs: the margins of plan_openings at
#: both ends, and by eye 6, 10 and 35 cm more, so that not all stand at the same place.
DOOR_WALL_M = 1.5
FRONT_DOOR_WALL_M = 1.7
WINDOW_WALL_M = 1.95
#: Corridors: shorter than this they would hold no two doors, longer is a hotel.
HALL_LENGTH_M = (2.6, 9.0)
#: Width to depth of a room, of a hub that is no hall, and the longer to the shorter side that is
#: still a room and no corridor, once it was fitted in: by eye, on drawn plans.
RATIO = (0.65, 1.5)
HUB_RATIO = (1.0, 1.5)
STRETCH_MOST = 2.1
#: So often a room is flush with an end of the hub where it can be: fewer odd corners. By eye.
FLUSH_CHANCE = 0.7
#: Shadows are drawn 10 m to each side of the middle.
LARGEST_M = 18.0
#: A hub grows into a corner beside a room this often, if the corner is wide enough for a desk and
#: its chair, and so deep, metres. By eye.
ALCOVE_CHANCE = 0.5
ALCOVE_M = 1.6
ALCOVE_DEPTH_M = (ALCOVE_M, 3.0)


class Rect(NamedTuple):
    """An axis-aligned rectangle, in cells."""

    x0: int
    y0: int
    x1: int
    y1: int

    def meets(self, other: Rect) -> bool:
        """True when the two share area."""
        return min(self.x1, other.x1) > max(self.x0, other.x0) and min(self.y1, other.y1) > max(
            self.y0, other.y0
        )


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


@dataclass(frozen=True)
class Plan:
    """Rooms, the hub first, and the walls between them and outdoors."""

    rooms: tuple[PlannedRoom, ...]
    walls: tuple[Wall, ...]

    def between(self, a: int, b: int) -> tuple[Wall, ...]:
        """Walls that rooms ``a`` and ``b`` share."""
        return tuple(w for w in self.walls if {w.first, w.second} == {a, b})

    def outer(self, room: int) -> tuple[Wall, ...]:
        """Walls of a room that face outdoors."""
        return self.between(room, OUTSIDE)


def plan_random(mix: HomeMix, types: Sequence[RoomType], rng: Rng) -> Plan | None:
    """A floor plan with the rooms of ``mix``; None when no try came out valid."""
    by_name = {t.name: t for t in types}
    specs = [by_name[name] for name in (mix.hub, *mix.rooms)]
    for _ in range(TRIES):
        rects = _try(specs, rng)
        if rects is None:
            continue
        plan = _to_plan(_turned(rects, rng), specs)
        if _fits(plan, specs):
            return plan
    return None


def _try(specs: Sequence[RoomType], rng: Rng) -> list[list[Rect]] | None:
    """Rectangles of every room, the hub's lower left corner at (0, 0); None when they clash."""
    areas = [float(rng.uniform(*spec.area_m2)) for spec in specs]
    order = [1 + k for k in rng.permutation(len(specs) - 1).tolist()]
    sides = _deal(order, rng)
    widths = {k: _width(specs[k], areas[k], rng) for k in order}
    corridor = specs[0].corridor_m
    if corridor is not None:
        width = _cells(float(rng.uniform(*corridor)))
        longest = max(sum(widths[k] for k in side) for side in sides[:2])
        length = min(max(longest, _cells(HALL_LENGTH_M[0])), _cells(HALL_LENGTH_M[1]))
    else:
        ratio = float(rng.uniform(*HUB_RATIO))
        length = _cells(math.sqrt(areas[0] * ratio))
        width = _cells(math.sqrt(areas[0] / ratio))
    rects: list[list[Rect]] = [[] for _ in specs]
    rects[0] = [Rect(0, 0, length, width)]
    for number, side in enumerate(sides):
        spans = _along(
            [widths[k] for k in side],
            width if number == 2 else length,
            barred=number < 2 and bool(sides[2]),
            rng=rng,
        )
        if spans is None:
            return None
        for k, (a, b) in zip(side, spans, strict=True):
            depth = _cells(areas[k] / ((b - a) * CELL_M))
            if max(depth, b - a) > STRETCH_MOST * min(depth, b - a):
                return None
            top = Rect(a, width, b, width + depth)
            rects[k] = [(top, Rect(a, -depth, b, 0), Rect(length, a, length + depth, b))[number]]
    if corridor is None:
        _alcove(rects, rng)
    return rects


def _cells(metres: float) -> int:
    return round(metres / CELL_M)


def _width(spec: RoomType, area_m2: float, rng: Rng) -> int:
    """How much of the hub's side a room takes."""
    return _cells(max(math.sqrt(area_m2 * float(rng.uniform(*RATIO))), spec.narrowest_m))


def _deal(order: Sequence[int], rng: Rng) -> tuple[list[int], list[int], list[int]]:
    """Which rooms stand above, below and at the end of the hub; at most two on a side."""
    while True:
        sides: tuple[list[int], list[int], list[int]] = ([], [], [])
        for k in order:
            sides[int(rng.integers(3))].append(k)
        if max(len(side) for side in sides) <= 2 and sides[0]:
            return sides


def _along(
    widths: Sequence[int], side: int, barred: bool, rng: Rng
) -> list[tuple[int, int]] | None:
    """Spans of rooms side by side along a side of the hub, each with room for a door to it.

    They may reach beyond the side's ends, but not beyond its far end when that is ``barred`` (the
    rooms at the hub's end stand there).
    """
    if not widths:
        return []
    door = _cells(DOOR_WALL_M)
    if len(widths) == 1:
        low, high = door - widths[0], (side - widths[0]) if barred else side - door
        if low > high:
            return None
        flush = [t for t in (0, side - widths[0]) if low <= t <= high]
        start = int(rng.integers(low, high + 1))
        if flush and rng.random() < FLUSH_CHANCE:
            start = flush[int(rng.integers(len(flush)))]
        return [(start, start + widths[0])]
    low, high = door, side - door
    if barred:
        high = min(high, side - widths[1])
    if low > high:
        return None
    start = int(rng.integers(low, high + 1))
    return [(start - widths[0], start), (start, start + widths[1])]


def _alcove(rects: list[list[Rect]], rng: Rng) -> None:
    """The hub may grow into the corner between its upper side and a room there: an L."""
    hub = rects[0][0]
    wanted = rng.random() < ALCOVE_CHANCE
    above = [r[0] for r in rects[1:] if r[0].y0 == hub.y1 and r[0].x0 < hub.x1]
    if len(above) != 1 or not wanted:
        return
    room = above[0]
    depth = min(room.y1 - room.y0, _cells(float(rng.uniform(*ALCOVE_DEPTH_M))))
    left, right = room.x0 - hub.x0, hub.x1 - room.x1
    if max(left, right) < _cells(ALCOVE_M):
        return
    span = (hub.x0, room.x0) if left >= right else (room.x1, hub.x1)
    part = Rect(span[0], hub.y1, span[1], hub.y1 + depth)
    if not any(part.meets(r[0]) for r in rects[1:]):
        rects[0].append(part)


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


def _to_plan(rects: list[list[Rect]], specs: Sequence[RoomType]) -> Plan:
    """Centred, in metres, with the walls found."""
    every = [r for room in rects for r in room]
    x0, y0 = min(r.x0 for r in every) - 1, min(r.y0 for r in every) - 1
    columns, rows = max(r.x1 for r in every) - x0 + 1, max(r.y1 for r in every) - y0 + 1
    cells = np.full((columns, rows), OUTSIDE, dtype=np.int64)
    owners = Owners(cells, CELL_M)
    counts: dict[str, int] = {}
    rooms = []
    for index, (spec, own) in enumerate(zip(specs, rects, strict=True)):
        counts[spec.name] = counts.get(spec.name, 0) + 1
        name = spec.name if counts[spec.name] == 1 else f"{spec.name}_{counts[spec.name]}"
        shown = []
        for r in own:
            cells[r.x0 - x0 : r.x1 - x0, r.y0 - y0 : r.y1 - y0] = index
            low = owners.corner(r.x0 - x0, r.y0 - y0)
            high = owners.corner(r.x1 - x0, r.y1 - y0)
            shown.append((*low, *high))
        rooms.append(PlannedRoom(name, spec, tuple(shown)))
    return Plan(tuple(rooms), shared_walls(owners))


def _fits(plan: Plan, specs: Sequence[RoomType]) -> bool:
    """True when every room has its door wall and its daylight, and none is too narrow."""
    if not any(w.length_m >= FRONT_DOOR_WALL_M for w in plan.outer(0)):
        return False
    for index, (room, spec) in enumerate(zip(plan.rooms, specs, strict=True)):
        x0, y0, x1, y1 = room.rectangles_m[0]
        if min(x1 - x0, y1 - y0) < spec.narrowest_m - 1e-6:
            return False
        if index and not any(w.length_m >= DOOR_WALL_M for w in plan.between(0, index)):
            return False
        lit = any(w.length_m >= WINDOW_WALL_M for w in plan.outer(index))
        if spec.daylight and not lit:
            return False
    points = np.array([r for room in plan.rooms for r in room.rectangles_m])
    size = points[:, 2:].max(axis=0) - points[:, :2].min(axis=0)
    return bool(np.all(size <= LARGEST_M))
