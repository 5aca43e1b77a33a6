"""Shapes of kitchens: units side by side along one wall, two that face, round one corner or two.

Every unit stands with its back to the wall, without gaps; where a run turns, a corner unit joins
its legs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise, product
from typing import NamedTuple

from sdgen.geometry import Vec2
from sdgen.home import anchors
from sdgen.home.anchors import BACK_GAP_M, Side
from sdgen.home.room_try import RoomTry, free_parts, taken_outlines
from sdgen.library.records import Asset

#: Units stand without gaps, all but this. Beside a corner unit, which stands out before its
#: neighbours, their leaves and pulls need more; so do all of the middle leg of a U, wedged in.
UNIT_GAP_M, CORNER_GAP_M = 0.006, 0.012
WEDGED_GAP_M = (0.009, 0.012)
#: A unit taller than this (a fridge; some stoves have a high back) stands at an end or apart, and
#: its door needs its own room.
TALL_M = 1.4
#: A worktop's height and depth: what a run needs of a wall to be looked at closer.
WORKTOP_M, DEPTH_M = 0.88, 0.6
#: Between the walls of a galley: two units, and 0.9 to 1.6 m between their fronts.
GALLEY_M = (2.1, 2.85)
#: And between the walls at the two ends of a U: two units, and 1.2 m or more. Its worktops reach so
#: far behind its units at most, where what there is does not fill the wall between.
U_LEAST_M = 2.6
BEHIND_M = 0.06
#: And units of a U stand so much nearer to the walls at its ends at most, where there is too much.
NEARER_M = 0.01
#: A run that ends so near a corner of the room ends in it; so near a doorway, it crowds it.
IN_CORNER_M, AT_DOOR_M = 0.2, 0.3


class Leg(NamedTuple):
    """Units along one wall of the room, the first ``start_m`` along it, ``gap_m`` apart.

    ``wall`` is its number, ``side`` the line that the units turn their backs to.
    """

    wall: int
    side: Side
    start_m: float
    units: tuple[Asset, ...]
    gap_m: float = UNIT_GAP_M


class Run(NamedTuple):
    """The legs of a run, and the corner units that join them with where they stand."""

    legs: tuple[Leg, ...]
    corners: tuple[tuple[Asset, anchors.PlacedAt], ...] = ()


@dataclass(frozen=True)
class Walls:
    """A room as a run sees it. By side: the stretches (first, last) that are free at a worktop's
    height, and how far along it the middles of its windows are, and half their widths."""

    tried: RoomTry
    free: list[list[Vec2]] = field(default_factory=list)
    windows: list[list[Vec2]] = field(default_factory=list)
    drawn: dict[tuple[str, bool, bool], tuple[Asset, ...]] = field(default_factory=dict)

    @classmethod
    def of(cls, tried: RoomTry) -> Walls:
        """The walls of a room."""
        taken = taken_outlines(tried, 0.0, WORKTOP_M)
        walls = cls(tried)
        for side in tried.sides:
            parts = free_parts(side, taken, DEPTH_M)
            starts = [(side.measure(part.start)[0], part.length_m) for part in parts]
            walls.free.append([(low, low + length) for low, length in starts])
            at = [
                (side.measure(o.center_m[:2]), o.width_m / 2)
                for o in tried.openings
                if o.kind == "window"
            ]
            here = [(t, half) for (t, away), half in at if abs(away) < BACK_GAP_M + 0.1]
            walls.windows.append(here)
        return walls

    def takes(self, k: int, low_m: float, high_m: float) -> bool:
        """Whether nothing is in the way from here to there along a side."""
        return any(low - 1e-6 <= low_m and high_m <= high + 1e-6 for low, high in self.free[k])

    def of_each_width(
        self, category: str, left: bool = False, right: bool = False
    ) -> tuple[Asset, ...]:
        """A model of each width there is of a category, drawn once; of those that may stand with
        their ``left``, and their ``right``, at a corner unit."""
        key = category, left, right
        if key not in self.drawn:
            found = [m for m in self.tried.models(category) if self.joins(m, left, right)]
            shuffled = (found[k] for k in self.tried.rng.permutation(len(found)).tolist())
            by_width = {round(model.extents_m[1], 2): model for model in shuffled}
            self.drawn[key] = tuple(by_width.values())
        return self.drawn[key]

    def joins(self, unit: Asset, left: bool, right: bool) -> bool:
        """Whether no leaf of a unit opens over a corner unit at its ``left``, or its ``right``."""
        reach = self.tried.layout.library.reach(unit.id)
        return not (
            (left and reach.left_m > CORNER_GAP_M) or (right and reach.right_m > CORNER_GAP_M)
        )

    def joining(self, unit: Asset, left: bool = False, right: bool = False) -> Asset:
        """The unit or, where it cannot stand so at a corner unit, one of its category that can."""
        if self.joins(unit, left, right):
            return unit
        found = self.of_each_width(unit.category, left, right)
        return found[int(self.tried.rng.integers(len(found)))] if found else unit

    def in_corner(self, k: int, at_m: float) -> bool:
        """Whether a point of a side is as good as at an end where the room has a corner."""
        if not 0.0 < min(at_m, self.tried.sides[k].length_m - at_m) < IN_CORNER_M:
            return False
        start = at_m < self.tried.sides[k].length_m / 2
        return any(k == (pair[1] if start else pair[0]) for pair in self.corners())

    def at_doorway(self, k: int, at_m: float) -> bool:
        """Whether a free stretch of a side ends right beside a point, and not in a corner."""
        ends = (end for stretch in self.free[k] for end in stretch)
        return any(abs(end - at_m) < AT_DOOR_M for end in ends) and not self.in_corner(k, at_m)

    def corners(self) -> Iterator[tuple[int, int]]:
        """Sides that meet in a corner of the room that a unit can stand in."""
        for k, second in enumerate(self.tried.sides):
            before = (k - 1) % len(self.tried.sides)
            first = self.tried.sides[before]
            if first.along[0] * second.along[1] - first.along[1] * second.along[0] > 0.5:
                yield before, k


def along_wall(units: Sequence[Asset], walls: Walls) -> Run | None:
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
    starts = [first, last, float(rng.uniform(first, last))]
    for sink in range(len(units)):
        if "WATER_SOURCE" in walls.tried.catalog.category(units[sink].category).properties:
            middle = _length(units[: sink + 1], walls.tried) - units[sink].extents_m[1] / 2
            starts += [min(max(t - middle, first), last) for t, _ in walls.windows[k]]
    start = starts[int(rng.integers(len(starts)))]
    return Run((Leg(k, walls.tried.sides[k], start, tuple(units)),))


def galley(units: Sequence[Asset], walls: Walls) -> Run | None:
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
        run = along_wall(some, Walls(tried, [*([[]] * k), walls.free[k]], walls.windows))
        if run is None:
            return None
        legs += run.legs
    return Run(tuple(legs))


def round_corner(units: Sequence[Asset], corner: Asset, walls: Walls) -> Run | None:
    turns = [(a, b, split) for a, b in walls.corners() for split in range(1, len(units))]
    for k in walls.tried.rng.permutation(len(turns)).tolist():
        a, b, split = turns[k]
        one, two = units[:split], units[split:]
        if not (_as_low(one[-1], corner) and _as_low(two[0], corner)):
            continue
        first = _up_to(a, walls.tried.sides[a], one, corner, walls)
        second = _on_from(b, walls.tried.sides[b], two, corner, walls)
        if first is not None and second is not None:
            return Run((first, second), ((corner, _corner_at(first.side, corner)),))
    return None


def round_two(units: Sequence[Asset], corner: Asset, walls: Walls) -> Run | None:
    """A U: its middle leg fills the wall between two corner units, with a unit or two more at its
    ends where that takes it."""
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
    splits = [
        (low, high) for low in range(1, len(units) - 1) for high in range(low + 1, len(units))
    ]
    for number in walls.tried.rng.permutation(len(splits)).tolist():
        low, high = splits[number]
        if all(_as_low(unit, corner) for unit in units[low - 1 : high + 1]):
            first = _up_to(a, sides[a], units[:low], corner, walls)
            last = first and _on_from(c, sides[c], units[high:], corner, walls)
            if first is None or last is None:
                continue
            between = length - 2 * BACK_GAP_M - deep - wide
            fillings = (_filling(some, between, walls) for some in _padded(units, low, high))
            filling = next((found for found in fillings if found is not None), None)
            if filling is None:
                continue
            middle, gap, behind = filling
            # As if the walls at its ends were so much nearer.
            one, other = (replace(sides[k], start=sides[k].at(0.0, behind)) for k in (a, c))
            back = replace(sides[b], start=sides[b].at(behind, 0.0), length_m=length - 2 * behind)
            wedged = Leg(b, back, BACK_GAP_M + deep + gap, middle, gap)
            at = tuple((corner, _corner_at(side, corner)) for side in (one, back))
            return Run((first._replace(side=one), wedged, last._replace(side=other)), at)
    return None


def _padded(units: Sequence[Asset], low: int, high: int) -> Iterator[tuple[Asset, ...]]:
    """Some units of a run, alone and with one more at either end or both: of the category that the
    run has most of."""
    names = [unit.category for unit in units]
    more = max(units, key=lambda unit: names.count(unit.category))
    for before, after in ((0, 0), (1, 0), (0, 1), (1, 1)):
        yield (*(more,) * before, *units[low:high], *(more,) * after)


def _filling(
    units: Sequence[Asset], between_m: float, walls: Walls
) -> tuple[tuple[Asset, ...], float, float] | None:
    """Units like these that fill a wall between two corner units, of models drawn at random, how
    far they stand apart, and how far worktops reach behind the units at both ends (below 0: how
    much nearer to the wall these stand)."""
    ends = [(k == 0, k == len(units) - 1) for k in range(len(units))]
    drawn = [
        walls.of_each_width(unit.category, *end) for unit, end in zip(units, ends, strict=True)
    ]
    if not all(drawn) or sum(min(m.extents_m[1] for m in found) for found in drawn) > between_m:
        return None
    for middle in product(*drawn):
        free_m = between_m - sum(unit.extents_m[1] for unit in middle)
        least, most = (gap * (len(middle) + 1) for gap in WEDGED_GAP_M)
        if least - 2 * NEARER_M <= free_m <= most + 2 * BEHIND_M:
            behind = (free_m - min(max(free_m, least), most)) / 2
            return middle, (free_m - 2 * behind) / (len(middle) + 1), behind
    return None


def apart(units: Sequence[Asset], walls: Walls) -> Run | None:
    """A run along one wall, what is tall of it at others: where no wall takes all."""
    low = [unit for unit in units if unit.extents_m[2] <= TALL_M]
    run = along_wall(low, walls)
    return None if run is None else _with_tall(run, units, walls)


def apart_round_corner(units: Sequence[Asset], corner: Asset, walls: Walls) -> Run | None:
    """A run round a corner, what is tall of it elsewhere."""
    low = [unit for unit in units if unit.extents_m[2] <= TALL_M]
    run = round_corner(low, corner, walls)
    return None if run is None else _with_tall(run, units, walls)


def _with_tall(run: Run, units: Sequence[Asset], walls: Walls) -> Run | None:
    legs = run.legs
    for unit in units:
        if unit.extents_m[2] > TALL_M:
            alone = _alone_in_corner(unit, walls)
            if alone is None and walls.tried.modest:
                alone = along_wall([unit], walls)
            if alone is None:
                return None
            legs = (*legs, *alone.legs)
    return run._replace(legs=legs)


def _alone_in_corner(unit: Asset, walls: Walls) -> Run | None:
    """A unit in a corner of the room: in the middle of a wall, it would look forgotten."""
    left, right = _ends([unit], walls.tried)
    wide = unit.extents_m[1]
    starts = [
        (k, start)
        for k, free in enumerate(walls.free)
        for low, high in free
        if high - low >= left + wide + right
        for start in (low + left, high - right - wide)
        if walls.in_corner(k, start) or walls.in_corner(k, start + wide)
    ]
    if not starts:
        return None
    k, start = starts[int(walls.tried.rng.integers(len(starts)))]
    return Run((Leg(k, walls.tried.sides[k], start, (unit,)),))


Shaped = Callable[[Sequence[Asset], Walls], Run | None]
Turned = Callable[[Sequence[Asset], Asset, Walls], Run | None]
STRAIGHT: Mapping[str, Shaped] = {"wall": along_wall, "galley": galley, "apart": apart}
TURNING: Mapping[str, Turned] = {
    "corner": round_corner,
    "u": round_two,
    "apart_corner": apart_round_corner,
}


def _corner_at(first: Side, corner: Asset) -> anchors.PlacedAt:
    """A corner unit at a side's end: its back to that side, its right to the next."""
    deep, wide, _ = corner.extents_m
    x, y = first.at(first.length_m - BACK_GAP_M - wide / 2, BACK_GAP_M + deep / 2)
    return (x, y, 0.0, first.yaw)


def _as_low(unit: Asset, corner: Asset) -> bool:
    """No tall unit stands beside a corner unit."""
    return unit.extents_m[2] <= max(TALL_M, corner.extents_m[2])


def _up_to(k: int, side: Side, units: Sequence[Asset], corner: Asset, walls: Walls) -> Leg | None:
    """A leg whose last unit joins a corner unit at the end of a side."""
    units = (*units[:-1], walls.joining(units[-1], right=True))
    end = side.length_m - BACK_GAP_M - corner.extents_m[1] - CORNER_GAP_M
    start = end - _length(units, walls.tried)
    if not walls.joins(units[-1], left=False, right=True):
        return None
    if not walls.takes(k, start - _ends(units, walls.tried)[0], side.length_m):
        return None
    return Leg(k, side, start, units)


def _on_from(k: int, side: Side, units: Sequence[Asset], corner: Asset, walls: Walls) -> Leg | None:
    """A leg whose first unit joins a corner unit at the beginning of a side."""
    units = (walls.joining(units[0], left=True), *units[1:])
    start = BACK_GAP_M + corner.extents_m[0] + CORNER_GAP_M
    end = start + _length(units, walls.tried)
    if not walls.joins(units[0], left=True, right=False):
        return None
    if not walls.takes(k, 0.0, end + _ends(units, walls.tried)[1]):
        return None
    return Leg(k, side, start, units)


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


def spots(leg: Leg, tried: RoomTry) -> Iterator[tuple[Asset, float]]:
    """The units of a leg with their middles along its side."""
    t = leg.start_m
    for unit, following in zip(leg.units, (*leg.units[1:], None), strict=True):
        yield unit, t + unit.extents_m[1] / 2
        t += unit.extents_m[1] + _gap(unit, following, tried, leg.gap_m)
