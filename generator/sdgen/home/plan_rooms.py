"""Where the rooms of a floor plan go: each is set against a wall of the room it opens from.

Every room is drawn as a rectangle of its area and pushed against a free stretch of its parent's
walls, flush with what stands there; of the places that are free, one is drawn that keeps the
outline compact and rooms beside those they wish for. Sampled by tries of about a millisecond,
unlike the grid growth of Lopes et al. (2010) and ProcTHOR (Deitke et al. 2022, appendix): that was
tried first, and fewer than one try in fifty gave every room a wall wide enough for its door.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.catalog.records import RoomType
from sdgen.seeding import Rng

#: Walls lie on a grid this wide.
CELL_M = 0.1
OUTSIDE = -1
#: Shared wall that a door needs: the margins of plan_openings at both ends, and by eye 6 cm more,
#: so that not all stand at the same place.
DOOR_WALL_M = 1.5
#: Outer wall that a front door needs: as for a door, 10 cm more; what stays free before it.
FRONT_DOOR_WALL_M = 1.7
PORCH_M = 1.2
#: Corridors: shorter than this they would hold no two doors, longer is a hotel.
CORRIDOR_LENGTH_M = (2.4, 9.0)
#: Rooms along a corridor take up to so much more of its two sides than it is long: the last ones
#: stand round its ends. By eye.
CORRIDOR_SHARE = (0.33, 0.46)
#: Longer to shorter side of a room as it is drawn; what a gap makes of it may be longer.
RATIO_MOST = 1.5
STRETCH_MOST = 2.1
#: What a room's area may differ by from what its type asks, once it is fitted in: for the walls'
#: grid and for gaps that would be too narrow to stand in.
AREA_SLACK = 0.1
#: A room is drawn as an L so often, if it is so large, square metres, and its wing takes so much
#: of its area and is at least so wide, metres: a desk and its chair. By eye.
WING_CHANCE = 0.4
WING_AREA_M2 = 14.0
WING_SHARE = (0.15, 0.3)
WING_M = 1.8
#: Gaps between rooms up to so wide are closed by one of them, metres.
GAP_M = 1.0
#: How much the draw of a place varies beside what it is worth, metres of wall: by eye, between
#: plans that are all alike and plans that sprawl.
SPREAD_M = 2.0
#: What a place beside a room wished for is worth, and what a metre more of the whole outline
#: costs, in metres of shared wall.
WISH_M = 6.0
OUTLINE_COST = 0.7

Cells = npt.NDArray[np.int64]


class Rect(NamedTuple):
    """An axis-aligned rectangle, in cells."""

    x0: int
    y0: int
    x1: int
    y1: int

    @property
    def area(self) -> int:
        """Its area in cells."""
        return (self.x1 - self.x0) * (self.y1 - self.y0)


def cells(metres: float) -> int:
    """So many cells, to the nearest."""
    return round(metres / CELL_M)


def place_rooms(
    specs: Sequence[RoomType], parents: Sequence[int], rng: Rng
) -> list[list[Rect]] | None:
    """Rectangles of every room, its main one first; None when one found no place.

    ``parents`` says by index which room each opens from: the first, the hub, from outside.
    """
    areas = [float(rng.uniform(*spec.area_m2)) for spec in specs]
    rects: list[list[Rect]] = [[] for _ in specs]
    porch = Rect(0, 0, 0, 0)
    for k in _order(parents, rng):
        room = _Draw(specs[k], areas[k], sum(_width_m(specs[c], areas[c]) for c in _of(k, parents)))
        wing = room.wing_m2(rng)
        sizes = room.sizes(wing, rng)
        if parents[k] == OUTSIDE:
            rects[k] = [Rect(0, 0, *sizes[0])]
            porch = _porch(rects[k][0], rng)
            continue
        spot = _spot(k, parents[k], sizes, specs, rects, porch, rng)
        if spot is None:
            return None
        rects[k] = [spot]
        if wing:
            rects[k] += _wing(wing, k, rects, porch, rng)
    _close_gaps(rects, specs, porch)
    return rects


class _Draw(NamedTuple):
    """A room to be placed, and how much wall the rooms that open from it take."""

    spec: RoomType
    area_m2: float
    along_m: float

    def wing_m2(self, rng: Rng) -> float:
        """The area of its wing; 0 for a plain rectangle."""
        large = self.area_m2 >= WING_AREA_M2 and self.spec.corridor_m is None
        wanted, share = rng.random() < WING_CHANCE, float(rng.uniform(*WING_SHARE))
        return self.area_m2 * share if large and wanted else 0.0

    def sizes(self, wing_m2: float, rng: Rng) -> list[tuple[int, int]]:
        """Sizes in cells of its main rectangle, lying and standing."""
        if self.spec.corridor_m is not None:
            width = float(rng.uniform(*self.spec.corridor_m))
            length = self.along_m * float(rng.uniform(*CORRIDOR_SHARE))
            least, most = (area / width for area in self.spec.area_m2)
            least, most = max(least, CORRIDOR_LENGTH_M[0]), min(most, CORRIDOR_LENGTH_M[1])
            length = min(max(length, least), most)
        else:
            area = self.area_m2 - wing_m2
            widest = area / self.spec.narrowest_m**2
            ratio = float(rng.uniform(1.0, max(1.0, min(RATIO_MOST, widest))))
            length, width = math.sqrt(area * ratio), math.sqrt(area / ratio)
        a, b = cells(length), cells(width)
        return [(a, b)] if a == b else [(a, b), (b, a)]


def _width_m(spec: RoomType, area_m2: float) -> float:
    return float(np.mean(spec.corridor_m)) if spec.corridor_m is not None else math.sqrt(area_m2)


def _of(parent: int, parents: Sequence[int]) -> list[int]:
    return [k for k, p in enumerate(parents) if p == parent]


def _order(parents: Sequence[int], rng: Rng) -> Iterator[int]:
    """Parents before their rooms; those that more rooms open from first, they need most wall."""
    ready = _of(OUTSIDE, parents)
    while ready:
        k = ready.pop(0)
        yield k
        own = _of(k, parents)
        own = [own[i] for i in rng.permutation(len(own)).tolist()]
        ready += sorted(own, key=lambda c: -len(_of(c, parents)))


def _spot(
    k: int,
    parent: int,
    sizes: Sequence[tuple[int, int]],
    specs: Sequence[RoomType],
    rects: Sequence[Sequence[Rect]],
    porch: Rect,
    rng: Rng,
) -> Rect | None:
    """A free place for room ``k`` against its parent, drawn by what each is worth."""
    placed = np.array([r for room in rects for r in room])
    owner = np.array([index for index, room in enumerate(rects) for _ in room])
    least = cells(DOOR_WALL_M)
    found: list[Rect] = []
    for side in rects[parent]:
        found += _against(side, sizes, placed, least, rng)
    spots = np.array([r for r in found if _is_room(r, specs[k])], dtype=np.int64).reshape(-1, 4)
    spots = spots[~_meets(spots, np.array([*placed, porch])).any(axis=1)]
    if not len(spots):
        return None
    contact = _contact(spots, placed)
    low = np.minimum(spots[:, :2], placed[:, :2].min(axis=0))
    high = np.maximum(spots[:, 2:], placed[:, 2:].max(axis=0))
    worth = contact.sum(axis=1) - OUTLINE_COST * (high - low).sum(axis=1)
    for other, room in enumerate(rects):
        wished = specs[other].name in specs[k].beside or specs[k].name in specs[other].beside
        if room and wished:
            touching = contact[:, owner == other].max(axis=1) >= least
            worth = worth + touching * (WISH_M / CELL_M)
    worth = worth + rng.gumbel(0.0, SPREAD_M / CELL_M, len(worth))
    return Rect(*spots[int(np.argmax(worth))].tolist())


def _against(
    side: Rect, sizes: Sequence[tuple[int, int]], placed: Cells, least: int, rng: Rng
) -> list[Rect]:
    """Rectangles against the four sides of one: flush with its ends, with what stands there, or
    anywhere; what is as wide as a gap between two, nearly, fills it."""
    out = []
    for axis, before in ((0, False), (0, True), (1, False), (1, True)):
        # `low` to `high` along the side, `at` across it: the new room lies beyond.
        low, high = (side.x0, side.x1) if axis == 0 else (side.y0, side.y1)
        at = (side.y0 if before else side.y1) if axis == 0 else (side.x0 if before else side.x1)
        across = 1 - axis
        beyond = (placed[:, across] < at) if before else (placed[:, across + 2] > at)
        edges = {low, high}
        for a, b in placed[beyond][:, [axis, axis + 2]].tolist():
            edges |= {a, b}
        ordered = sorted(edges)
        for width, depth in sizes:
            starts = [s for e in ordered for s in (e, e - width)]
            starts.append(int(rng.integers(low - width + least, max(high - least, low) + 1)))
            spans = [(s, s + width) for s in starts]
            spans += [(a, b) for a in ordered for b in ordered if 0.8 <= (b - a) / width <= 1.25]
            for a, b in dict.fromkeys(spans):
                if min(b, high) - max(a, low) < min(least, high - low, b - a):
                    continue
                deep = depth if b - a == width else round(width * depth / (b - a))
                near, far = (at - deep, at) if before else (at, at + deep)
                out.append(Rect(a, near, b, far) if axis == 0 else Rect(near, a, far, b))
    return out


def _is_room(r: Rect, spec: RoomType) -> bool:
    """True when a rectangle is no narrower than its type allows, and no passage."""
    short, long = sorted((r.x1 - r.x0, r.y1 - r.y0))
    narrow = short < cells(spec.narrowest_m)
    return not narrow and (spec.corridor_m is not None or long <= STRETCH_MOST * short)


def _meets(a: Cells, b: Cells) -> npt.NDArray[np.bool_]:
    """Which rectangles of ``a`` (N, 4) share area with which of ``b`` (M, 4)."""
    low = np.maximum(a[:, None, :2], b[None, :, :2])
    high = np.minimum(a[:, None, 2:], b[None, :, 2:])
    return np.asarray((high > low).all(axis=2))


def _contact(a: Cells, b: Cells) -> Cells:
    """How much wall rectangles (N, 4) share with others (M, 4) that they do not meet, cells."""
    low = np.maximum(a[:, None, :2], b[None, :, :2])
    high = np.minimum(a[:, None, 2:], b[None, :, 2:])
    span = high - low
    touch_x = (span[..., 0] == 0) * np.maximum(span[..., 1], 0)
    touch_y = (span[..., 1] == 0) * np.maximum(span[..., 0], 0)
    return np.asarray(touch_x + touch_y)


def _porch(hub: Rect, rng: Rng) -> Rect:
    """What stays free before the front door: at an end of one side of the hub."""
    width, depth = cells(FRONT_DOOR_WALL_M), cells(PORCH_M)
    at_end, beyond = bool(rng.integers(2)), bool(rng.integers(2))
    if rng.random() < 0.5:
        x = hub.x1 - width if at_end else hub.x0
        y = hub.y1 if beyond else hub.y0 - depth
        return Rect(x, y, x + width, y + depth)
    y = hub.y1 - width if at_end else hub.y0
    x = hub.x1 if beyond else hub.x0 - depth
    return Rect(x, y, x + depth, y + width)


def _wing(
    area_m2: float, k: int, rects: Sequence[Sequence[Rect]], porch: Rect, rng: Rng
) -> list[Rect]:
    """A second rectangle that makes a room an L: at a corner of its main one, where it shares most
    wall; none when there is no room for one."""
    main = rects[k][0]
    placed = np.array([r for room in rects for r in room])
    wing = area_m2 / CELL_M**2
    found = []
    for axis in (0, 1):
        length = (main.x1 - main.x0) if axis == 0 else (main.y1 - main.y0)
        low, high = cells(WING_M), length - cells(WING_M) // 2
        if high <= low:
            continue
        width = int(rng.integers(low, high))
        depth = round(wing / width)
        if depth < cells(WING_M) or depth > STRETCH_MOST * width:
            continue
        for at_low in (True, False):
            for before in (True, False):
                if axis == 0:
                    a = main.x0 if at_low else main.x1 - width
                    y = main.y0 - depth if before else main.y1
                    found.append(Rect(a, y, a + width, y + depth))
                else:
                    a = main.y0 if at_low else main.y1 - width
                    x = main.x0 - depth if before else main.x1
                    found.append(Rect(x, a, x + depth, a + width))
    spots = np.array(found, dtype=np.int64).reshape(-1, 4)
    spots = spots[~_meets(spots, np.array([*placed, porch])).any(axis=1)]
    if not len(spots):
        return []
    worth = _contact(spots, placed).sum(axis=1)
    return [Rect(*spots[int(np.argmax(worth))].tolist())]


def _close_gaps(rects: list[list[Rect]], specs: Sequence[RoomType], porch: Rect) -> None:
    """Rooms grow over gaps that are too narrow to stand in, as far as their areas allow."""
    for k, room in enumerate(rects):
        most = specs[k].area_m2[1] * (1 + AREA_SLACK) / CELL_M**2
        wings = sum(r.area for r in room[1:])
        around = [r for j, other in enumerate(rects) for r in other[int(j == k) :]]
        others = np.array([*around, porch])
        for side in range(4):
            grown = _grown(rects[k][0], side, others)
            if grown.area + wings <= most and _is_room(grown, specs[k]):
                rects[k][0] = grown


def _grown(main: Rect, side: int, others: Cells) -> Rect:
    """The rectangle with one side moved out to the first wall across a narrow gap, where that
    stands along most of it; ``side`` is the index of the coordinate that moves."""
    across = 1 - side % 2
    low, high = main[across], main[across + 2]
    span = np.minimum(others[:, across + 2], high) - np.maximum(others[:, across], low)
    gap = main[side] - others[:, side + 2] if side < 2 else others[:, side - 2] - main[side]
    facing = (span > 0) & (gap >= 0)
    if not facing.any():
        return main
    nearest = int(gap[facing].min())
    stands = int(span[facing & (gap == nearest)].sum())
    if nearest > cells(GAP_M) or 2 * stands < high - low:
        return main
    step = -nearest if side < 2 else nearest
    return Rect(*(v + step * (i == side) for i, v in enumerate(main)))
