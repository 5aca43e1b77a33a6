"""Units side by side: kitchens along one wall, round one corner or two, or along two walls that
face each other.

Every unit of a run stands with its back to the wall, without gaps; where a run turns, a corner unit
joins its legs. Runs are drawn, told good from bad by rules of thumb of those who plan kitchens,
and the best that finds a place is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import FurnitureRule
from sdgen.geometry import Vec2
from sdgen.home import anchors
from sdgen.home.anchors import BACK_GAP_M, Side
from sdgen.home.room_try import RoomTry, free_parts, taken_outlines, with_placed
from sdgen.library.records import Asset

#: Units stand without gaps, all but this. Beside a corner unit, which stands out before its
#: neighbours, their leaves and pulls need more; so do all of the middle leg of a U, wedged in.
UNIT_GAP_M, CORNER_GAP_M = 0.006, 0.012
WEDGED_GAP_M = (0.009, 0.012)
#: Bound the search: runs drawn of a shape, some of them as short as may be, for small kitchens; and
#: of these, the best first, tried in the room.
DRAWN, SHORT, TRIED = 30, 8, 8
#: As narrow as the narrowest are models this little wider.
NARROW_M = 0.05
#: A unit taller than others by this (a fridge) stands at an end, and its door needs its own room.
TALL_M = 1.2
#: A worktop's height and depth: what a run needs of a wall to be looked at closer.
WORKTOP_M, DEPTH_M = 0.88, 0.6
#: Between the walls of a galley: two units, and 0.9 to 1.6 m between their fronts.
GALLEY_M = (2.1, 2.85)
#: And between the walls at the two ends of a U.
U_LEAST_M = 2.15
#: How often each shape is tried first, where the room has corners and a corner unit: by eye.
SHAPES = {"corner": 0.5, "wall": 0.2, "galley": 0.15, "u": 0.15}
#: Where none of these finds a place.
APART = ("apart", "apart_corner")
#: How often each extra unit of a rule is asked for.
EXTRA_CHANCE = 0.7
#: A sink this near the middle of a window, along the wall, is at it; a stove nearer than this is
#: before it.
AT_WINDOW_M, BEFORE_WINDOW_M = 0.5, 0.9
#: What a metre more of worktop is worth, up to so many; what else is, or costs, in metres.
WORKTOP_WORTH, WORKTOP_MOST_M = 0.35, 4.5
SINK_AT_WINDOW, STOVE_AT_WINDOW, NO_TOP_BESIDE_STOVE = -1.2, 1.0, 0.8
#: A dishwasher stands in the leg of the sink.
DISHWASHER, SPLIT_FROM_SINK = -0.3, 0.8
#: What chance makes of these (one sigma): not every kitchen is planned alike.
CHANCE = 0.3


class Leg(NamedTuple):
    """Units along one side of the room, the first ``start_m`` along it, ``gap_m`` apart."""

    side: Side
    start_m: float
    units: tuple[Asset, ...]
    gap_m: float = UNIT_GAP_M


class Run(NamedTuple):
    """The legs of a run, and the corner units that join them with where they stand."""

    legs: tuple[Leg, ...]
    corners: tuple[tuple[Asset, anchors.PlacedAt], ...] = ()


@dataclass(frozen=True)
class _Walls:
    """A room as a run sees it. By side: the stretches (first, last) that are free at a worktop's
    height, and where along it the middles of its windows are."""

    tried: RoomTry
    free: list[list[Vec2]] = field(default_factory=list)
    windows: list[list[float]] = field(default_factory=list)

    @classmethod
    def of(cls, tried: RoomTry) -> _Walls:
        """The walls of a room."""
        taken = taken_outlines(tried, 0.0, WORKTOP_M)
        walls = cls(tried)
        for side in tried.sides:
            parts = free_parts(side, taken, DEPTH_M)
            starts = [(side.measure(part.start)[0], part.length_m) for part in parts]
            walls.free.append([(low, low + length) for low, length in starts])
            at = [side.measure(o.center_m[:2]) for o in tried.openings if o.kind == "window"]
            walls.windows.append([t for t, away in at if abs(away) < BACK_GAP_M + 0.1])
        return walls

    def takes(self, k: int, low_m: float, high_m: float) -> bool:
        """Whether nothing is in the way from here to there along a side."""
        return any(low - 1e-6 <= low_m and high_m <= high + 1e-6 for low, high in self.free[k])

    def corners(self) -> Iterator[tuple[int, int]]:
        """Sides that meet in a corner of the room that a unit can stand in."""
        for k, second in enumerate(self.tried.sides):
            before = (k - 1) % len(self.tried.sides)
            first = self.tried.sides[before]
            if first.along[0] * second.along[1] - first.along[1] * second.along[0] > 0.5:
                yield before, k


def with_row(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with units side by side against one wall, either way round."""
    return _best(rule, ("wall",), tried)


def with_run(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with a run of units of some shape, with what extra units find a place."""
    names = list(SHAPES)
    weights = np.array([SHAPES[name] for name in names])
    order = tried.rng.choice(len(names), len(names), replace=False, p=weights / weights.sum())
    return _best(rule, [*(names[k] for k in order.tolist()), *APART], tried)


def _best(rule: FurnitureRule, shapes: Sequence[str], tried: RoomTry) -> RoomTry | None:
    walls = _Walls.of(tried)
    for shape in shapes:
        runs = []
        for number in range(DRAWN):
            run = _drawn(rule, shape, walls, number < SHORT)
            if run is not None:
                runs.append((_cost(run, walls) + float(tried.rng.normal(0.0, CHANCE)), run))
        runs.sort(key=lambda pair: pair[0])
        for _, run in runs[:TRIED]:
            made = _with(rule, run, tried)
            if made is not None:
                return made
    return None


def _drawn(rule: FurnitureRule, shape: str, walls: _Walls, short: bool) -> Run | None:
    """A run of a shape, of models and at walls drawn at random (``short``: without extra units,
    of the narrowest models); None where it is too long."""
    rng = walls.tried.rng
    extra = () if short else tuple(c for c in rule.extra if rng.random() < EXTRA_CHANCE)
    units = []
    for category in (*rule.row, *extra):
        found = walls.tried.models(category)
        if not found:
            return None
        if short:
            least = min(m.extents_m[1] for m in found)
            found = tuple(m for m in found if m.extents_m[1] < least + NARROW_M)
        units.append(found[int(rng.integers(len(found)))])
    if rng.random() < 0.5:
        units.reverse()
    if shape in STRAIGHT:
        return STRAIGHT[shape](units, walls)
    corners = walls.tried.models(rule.corner) if rule.corner else ()
    if not corners:
        return None
    return TURNING[shape](units, corners[int(rng.integers(len(corners)))], walls)


def _along_wall(units: Sequence[Asset], walls: _Walls) -> Run | None:
    rng = walls.tried.rng
    length = _length(units, walls.tried)
    left, right = _ends(units, walls.tried)
    fitting = [
        (k, low + left, max(low + left, high - right - length))
        for k, free in enumerate(walls.free)
        for low, high in free
        if high - low >= left + length + right
    ]
    if not fitting:
        return None
    k, first, last = fitting[int(rng.integers(len(fitting)))]
    start = (first, last, float(rng.uniform(first, last)))[int(rng.integers(3))]
    return Run((Leg(walls.tried.sides[k], start, tuple(units)),))


def _galley(units: Sequence[Asset], walls: _Walls) -> Run | None:
    tried = walls.tried
    facing = [
        (j, k)
        for j, one in enumerate(tried.sides)
        for k, other in enumerate(tried.sides)
        if one.inward[0] * other.inward[0] + one.inward[1] * other.inward[1] < -0.99
        and GALLEY_M[0] <= one.measure(other.start)[1] <= GALLEY_M[1]
    ]
    if not facing or len(units) < 4:
        return None
    pair = facing[int(tried.rng.integers(len(facing)))]
    split = int(tried.rng.integers(2, len(units) - 1))
    legs: list[Leg] = []
    for k, some in zip(pair, (units[:split], units[split:]), strict=True):
        # Of all walls this one alone.
        run = _along_wall(some, _Walls(tried, [*([[]] * k), walls.free[k]]))
        if run is None:
            return None
        legs += run.legs
    return Run(tuple(legs))


def _round_corner(units: Sequence[Asset], corner: Asset, walls: _Walls) -> Run | None:
    turns = [(a, b, split) for a, b in walls.corners() for split in range(1, len(units))]
    for k in walls.tried.rng.permutation(len(turns)).tolist():
        a, b, split = turns[k]
        one, two = units[:split], units[split:]
        if not (_joins(one[-1], corner) and _joins(two[0], corner)):
            continue
        first = _up_to(a, one, corner, walls)
        second = None if first is None else _on_from(b, two, corner, walls)
        if first is not None and second is not None:
            return Run((first, second), ((corner, _corner_at(first.side, corner)),))
    return None


def _round_two(units: Sequence[Asset], corner: Asset, walls: _Walls) -> Run | None:
    """A U: its middle leg fills the wall between two corner units."""
    sides = walls.tried.sides
    met = list(walls.corners())
    turns = [(a, b, c) for a, b in met for other, c in met if b == other]
    if not turns or len(units) < 3:
        return None
    a, b, c = turns[int(walls.tried.rng.integers(len(turns)))]
    deep, wide, _ = corner.extents_m
    length = sides[b].length_m
    if length < U_LEAST_M or not walls.takes(b, 0.0, length):
        return None
    for low in range(1, len(units) - 1):
        for high in range(low + 1, len(units)):
            first, middle, last = units[:low], units[low:high], units[high:]
            if not all(_joins(unit, corner) for unit in (first[-1], *middle, last[0])):
                continue
            between = length - 2 * BACK_GAP_M - deep - wide
            gap = (between - sum(u.extents_m[1] for u in middle)) / (len(middle) + 1)
            if not WEDGED_GAP_M[0] <= gap <= WEDGED_GAP_M[1]:
                continue
            ends = _up_to(a, first, corner, walls), _on_from(c, last, corner, walls)
            if ends[0] is None or ends[1] is None:
                continue
            wedged = Leg(sides[b], BACK_GAP_M + deep + gap, tuple(middle), gap)
            at = tuple((corner, _corner_at(sides[k], corner)) for k in (a, b))
            return Run((ends[0], wedged, ends[1]), at)
    return None


def _apart(units: Sequence[Asset], walls: _Walls) -> Run | None:
    """A run along one wall, what is tall of it at others: where no wall takes all."""
    low = [unit for unit in units if unit.extents_m[2] <= TALL_M]
    run = _along_wall(low, walls)
    return None if run is None else _with_tall(run, units, walls)


def _apart_round_corner(units: Sequence[Asset], corner: Asset, walls: _Walls) -> Run | None:
    """A run round a corner, what is tall of it elsewhere."""
    low = [unit for unit in units if unit.extents_m[2] <= TALL_M]
    run = _round_corner(low, corner, walls)
    return None if run is None else _with_tall(run, units, walls)


def _with_tall(run: Run, units: Sequence[Asset], walls: _Walls) -> Run | None:
    legs = run.legs
    for unit in units:
        alone = _along_wall([unit], walls) if unit.extents_m[2] > TALL_M else Run(())
        if alone is None:
            return None
        legs = (*legs, *alone.legs)
    return run._replace(legs=legs)


Shaped = Callable[[Sequence[Asset], _Walls], Run | None]
Turned = Callable[[Sequence[Asset], Asset, _Walls], Run | None]
STRAIGHT: Mapping[str, Shaped] = {"wall": _along_wall, "galley": _galley, "apart": _apart}
TURNING: Mapping[str, Turned] = {
    "corner": _round_corner,
    "u": _round_two,
    "apart_corner": _apart_round_corner,
}


def _corner_at(first: Side, corner: Asset) -> anchors.PlacedAt:
    """A corner unit at a side's end: its back to that side, its right to the next."""
    deep, wide, _ = corner.extents_m
    x, y = first.at(first.length_m - BACK_GAP_M - wide / 2, BACK_GAP_M + deep / 2)
    return (x, y, 0.0, first.yaw)


def _joins(unit: Asset, corner: Asset) -> bool:
    """No tall unit stands beside a corner unit."""
    return unit.extents_m[2] <= max(TALL_M, corner.extents_m[2])


def _up_to(k: int, units: Sequence[Asset], corner: Asset, walls: _Walls) -> Leg | None:
    """A leg whose last unit joins a corner unit at the end of a side."""
    side = walls.tried.sides[k]
    end = side.length_m - BACK_GAP_M - corner.extents_m[1] - CORNER_GAP_M
    start = end - _length(units, walls.tried)
    if walls.tried.layout.library.reach(units[-1].id).right_m > CORNER_GAP_M:
        return None
    if not walls.takes(k, start - _ends(units, walls.tried)[0], side.length_m):
        return None
    return Leg(side, start, tuple(units))


def _on_from(k: int, units: Sequence[Asset], corner: Asset, walls: _Walls) -> Leg | None:
    """A leg whose first unit joins a corner unit at the beginning of a side."""
    start = BACK_GAP_M + corner.extents_m[0] + CORNER_GAP_M
    end = start + _length(units, walls.tried)
    if walls.tried.layout.library.reach(units[0].id).left_m > CORNER_GAP_M:
        return None
    if not walls.takes(k, 0.0, end + _ends(units, walls.tried)[1]):
        return None
    return Leg(walls.tried.sides[k], start, tuple(units))


def _gap(unit: Asset, following: Asset | None, tried: RoomTry, gap_m: float = UNIT_GAP_M) -> float:
    """Between a unit and the next: what the leaf of a tall one needs beside it."""
    reach = tried.layout.library.reach
    gap = reach(unit.id).right_m if unit.extents_m[2] > TALL_M else 0.0
    if following is not None and following.extents_m[2] > TALL_M:
        gap = max(gap, reach(following.id).left_m)
    return max(gap_m, gap)


def _length(units: Sequence[Asset], tried: RoomTry) -> float:
    """From the first unit's end to the last one's, along the wall."""
    gaps = sum(_gap(a, b, tried) for a, b in pairwise(units))
    return sum(unit.extents_m[1] for unit in units) + gaps


def _ends(units: Sequence[Asset], tried: RoomTry) -> Vec2:
    """Between a run and the walls at its ends."""
    reach = tried.layout.library.reach
    return anchors.end_gaps(reach(units[0].id))[0], anchors.end_gaps(reach(units[-1].id))[1]


def _spots(leg: Leg, tried: RoomTry) -> Iterator[tuple[Asset, float]]:
    """The units of a leg with their middles along its side."""
    t = leg.start_m
    for unit, following in zip(leg.units, (*leg.units[1:], None), strict=True):
        yield unit, t + unit.extents_m[1] / 2
        t += unit.extents_m[1] + _gap(unit, following, tried, leg.gap_m)


def _cost(run: Run, walls: _Walls) -> float:
    """What speaks against a run, in metres of worktop; below 0: for it."""
    tried = walls.tried
    total = 0.0
    worktop = sum(2 * corner.extents_m[1] - DEPTH_M for corner, _ in run.corners)
    for number, leg in enumerate(run.legs):
        windows = walls.windows[tried.sides.index(leg.side)]
        # Beside each unit: another, or the corner unit that the leg joins.
        before = 0 < number <= len(run.corners)
        after = number < len(run.corners)
        topped = [before, *(unit.extents_m[2] <= TALL_M for unit in leg.units), after]
        traits = [tried.catalog.category(unit.category).properties for unit in leg.units]
        wet = any("WATER_SOURCE" in its for its in traits)
        for i, (unit, middle) in enumerate(_spots(leg, tried)):
            off = min((abs(t - middle) for t in windows), default=math.inf)
            if "HEAT_SOURCE" in traits[i]:
                total += STOVE_AT_WINDOW if off < BEFORE_WINDOW_M else 0.0
                total += NO_TOP_BESIDE_STOVE * (2 - topped[i] - topped[i + 2])
            elif topped[i + 1]:
                worktop += unit.extents_m[1]
            if "WATER_SOURCE" in traits[i] and off < AT_WINDOW_M:
                total += SINK_AT_WINDOW
            if unit.category == "dishwasher":
                total += DISHWASHER if wet else SPLIT_FROM_SINK
    return total - WORKTOP_WORTH * min(worktop, WORKTOP_MOST_M)


def _with(rule: FurnitureRule, run: Run, tried: RoomTry) -> RoomTry | None:
    """The room with all units of a run; None when one of them finds no place."""
    # Before a corner unit stand its neighbours.
    joint = rule.model_copy(update={"front_m": 0.0})
    spots = [(joint, corner, at) for corner, at in run.corners]
    for leg in run.legs:
        for unit, middle in _spots(leg, tried):
            back = anchors.back_gap(tried.layout.library.reach(unit.id))
            spot = leg.side.at(middle, unit.extents_m[0] / 2 + back)
            spots.append((rule, unit, (*spot, 0.0, leg.side.yaw)))
    # The tallest first: a fridge before a window fails soonest.
    spots.sort(key=lambda spot: -spot[1].extents_m[2])
    for its_rule, unit, at in spots:
        more = with_placed(its_rule, unit, at, None, tried)
        if more is None:
            return None
        tried = more
    return tried
