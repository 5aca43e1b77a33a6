"""Units side by side: kitchens along one wall, round a corner, or along two walls that face.

Every unit of a run stands with its back to the wall, without gaps; a corner unit joins the two
legs of an L. Of the runs that a room has space for, those come first whose sink is at a window.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import FurnitureRule
from sdgen.geometry import Vec2
from sdgen.home import anchors
from sdgen.home.anchors import BACK_GAP_M, Side
from sdgen.home.room_try import RoomTry, with_placed
from sdgen.library.records import Asset

#: Units stand without gaps, all but this.
UNIT_GAP_M = 0.012
#: Bounds the search, with other models or the other way round each time.
RUNS_TRIED = 6
#: Walls that have this much more than a row's length come first: it need not be wedged in.
ROW_SLACK_M = 0.05
#: A unit taller than others by this (a fridge) stands at an end, and its door needs its own room.
TALL_M = 1.2
#: Between the walls of a galley: two units, and 0.9 to 1.6 m between their fronts.
GALLEY_M = (2.1, 2.85)
#: How often each shape is tried first, where the room has corners and a corner unit: by eye.
SHAPES = {"corner": 0.5, "wall": 0.3, "galley": 0.2}
#: How often each extra unit of a rule is asked for.
EXTRA_CHANCE = 0.6
#: A sink this near the middle of a window, along the wall, is at it.
AT_WINDOW_M = 0.5


class Leg(NamedTuple):
    """Units along one side of the room, the first ``start_m`` along it."""

    side: Side
    start_m: float
    units: tuple[Asset, ...]


class Run(NamedTuple):
    """The legs of a run and, of an L, the corner unit with where it stands."""

    legs: tuple[Leg, ...]
    corner: Asset | None = None
    corner_at: anchors.PlacedAt | None = None


def with_row(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with units side by side against one wall, either way round."""
    return _with_first(rule, tried, {"wall": 1.0}, rule.row)


def with_run(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with a run of units of some shape, with as many extra units as find a place."""
    extra = tuple(c for c in rule.extra if tried.rng.random() < EXTRA_CHANCE)
    for count in range(len(extra), -1, -1):
        found = _with_first(rule, tried, SHAPES, (*rule.row, *extra[:count]))
        if found is not None:
            return found
    return None


def _with_first(
    rule: FurnitureRule, tried: RoomTry, shapes: dict[str, float], categories: Sequence[str]
) -> RoomTry | None:
    rng = tried.rng
    names, weights = list(shapes), np.array(list(shapes.values()))
    for _ in range(RUNS_TRIED):
        order = categories if rng.random() < 0.5 else categories[::-1]
        units = []
        for category in order:
            found = tried.models(category)
            if not found:
                return None
            units.append(found[int(rng.integers(len(found)))])
        corners = tried.models(rule.corner) if rule.corner else ()
        corner = corners[int(rng.integers(len(corners)))] if corners else None
        for k in rng.choice(len(names), len(names), replace=False, p=weights / weights.sum()):
            for run in _of_shape(names[int(k)], units, corner, tried):
                made = _with(rule, run, tried)
                if made is not None:
                    return made
    return None


def _of_shape(
    shape: str, units: Sequence[Asset], corner: Asset | None, tried: RoomTry
) -> list[Run]:
    """Runs of a shape as long as the walls, those with a sink at a window first."""
    if shape == "wall":
        runs = list(_along_walls(units, tried))
    elif shape == "galley":
        runs = list(_galleys(units, tried))
    else:
        runs = [] if corner is None else list(_round_corners(units, corner, tried))
    if shape != "wall":  # those come with the walls that they fill at the end already
        runs = [runs[k] for k in tried.rng.permutation(len(runs)).tolist()]
    return sorted(runs, key=lambda run: not _sink_at_window(run, tried))


def _along_walls(units: Sequence[Asset], tried: RoomTry) -> Iterator[Run]:
    length = _length(units, tried)
    left, right = _ends(units, tried)
    sides = [tried.sides[k] for k in tried.rng.permutation(len(tried.sides)).tolist()]
    sides.sort(key=lambda side: side.length_m < length + ROW_SLACK_M)
    for side in sides:
        spare = side.length_m - length - left - right
        if spare >= 0:
            for start in (left, left + spare, left + float(tried.rng.uniform(0.0, spare))):
                yield Run((Leg(side, start, tuple(units)),))


def _round_corners(units: Sequence[Asset], corner: Asset, tried: RoomTry) -> Iterator[Run]:
    deep, wide, tall = corner.extents_m
    for k, second in enumerate(tried.sides):
        first = tried.sides[k - 1]
        turn = first.along[0] * second.along[1] - first.along[1] * second.along[0]
        if turn < 0.5:
            continue
        # The corner unit has its back to the first wall, its left side to the second.
        x, y = first.at(first.length_m - BACK_GAP_M - wide / 2, BACK_GAP_M + deep / 2)
        taken_1, taken_2 = BACK_GAP_M + wide + UNIT_GAP_M, BACK_GAP_M + deep + UNIT_GAP_M
        for split in range(1, len(units)):
            one, two = units[:split], units[split:]
            if max(one[-1].extents_m[2], two[0].extents_m[2]) > tall + 0.2:
                continue
            start = first.length_m - taken_1 - _length(one, tried)
            rest = second.length_m - taken_2 - _length(two, tried)
            if start < _ends(one, tried)[0] or rest < _ends(two, tried)[1]:
                continue
            legs = Leg(first, start, tuple(one)), Leg(second, taken_2, tuple(two))
            yield Run(legs, corner, (x, y, 0.0, first.yaw))


def _galleys(units: Sequence[Asset], tried: RoomTry) -> Iterator[Run]:
    for k, first in enumerate(tried.sides):
        for second in tried.sides[k + 1 :]:
            facing = first.inward[0] * second.inward[0] + first.inward[1] * second.inward[1]
            apart = first.measure(second.start)[1]
            if facing > -0.99 or not GALLEY_M[0] <= apart <= GALLEY_M[1]:
                continue
            for split in range(2, len(units) - 1):
                legs = []
                for side, leg in ((first, units[:split]), (second, units[split:])):
                    left, right = _ends(leg, tried)
                    spare = side.length_m - _length(leg, tried) - left - right
                    if spare < 0:
                        break
                    start = left + spare * float(tried.rng.choice((0.0, 0.5, 1.0)))
                    legs.append(Leg(side, start, tuple(leg)))
                if len(legs) == 2:
                    yield Run(tuple(legs))


def _gap(unit: Asset, following: Asset | None, tried: RoomTry) -> float:
    """Between a unit and the next: what the leaf of a tall one needs beside it."""
    reach = tried.layout.library.reach
    gap = reach(unit.id).right_m if unit.extents_m[2] > TALL_M else 0.0
    if following is not None and following.extents_m[2] > TALL_M:
        gap = max(gap, reach(following.id).left_m)
    return max(UNIT_GAP_M, gap)


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
        t += unit.extents_m[1] + _gap(unit, following, tried)


def _sink_at_window(run: Run, tried: RoomTry) -> bool:
    windows = [o.center_m for o in tried.openings if o.kind == "window"]
    for leg in run.legs:
        for unit, middle in _spots(leg, tried):
            if "WATER_SOURCE" not in tried.catalog.category(unit.category).properties:
                continue
            for x, y, _ in windows:
                t, away = leg.side.measure((x, y))
                if abs(away) < BACK_GAP_M + 0.1 and abs(t - middle) < AT_WINDOW_M:
                    return True
    return False


def _with(rule: FurnitureRule, run: Run, tried: RoomTry) -> RoomTry | None:
    """The room with all units of a run; None when one of them finds no place."""
    if run.corner is not None and run.corner_at is not None:
        # Before a corner unit stand its neighbours.
        joint = rule.model_copy(update={"front_m": 0.0})
        more = with_placed(joint, run.corner, run.corner_at, None, tried)
        if more is None:
            return None
        tried = more
    for leg in run.legs:
        for unit, middle in _spots(leg, tried):
            back = anchors.back_gap(tried.layout.library.reach(unit.id))
            spot = leg.side.at(middle, unit.extents_m[0] / 2 + back)
            more = with_placed(rule, unit, (*spot, 0.0, leg.side.yaw), None, tried)
            if more is None:
                return None
            tried = more
    return tried
