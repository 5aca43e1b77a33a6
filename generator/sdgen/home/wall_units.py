"""Wall units over base units: in rows without gaps, none alone, flush with the hood."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np
import shapely

from sdgen.catalog.records import FurnitureRule
from sdgen.geometry import Array, Vec2, yaw_of
from sdgen.home.anchors import HUNG_GAP_M, Side, placed_from
from sdgen.home.layout import corners_of
from sdgen.home.room_try import RoomTry, free_parts, with_placed
from sdgen.home.ways import way_of
from sdgen.library.records import Asset
from sdgen.vocabulary import OVERHEAD_M

#: Between two units of a row, and how much more at most where that fills it to its end.
UNIT_GAP_M, WIDEST_GAP_M = 0.004, 0.015
#: Widths are nominal, in tenths of a metre: a unit is a few millimetres off.
STEPS_A_METRE, NOMINAL_M = 10, 0.01
#: A piece at least this deep and wide is a corner unit: over the end of each of its arms, clear of
#: what hangs at the other wall, a unit so wide hangs.
CORNER_M, ARM_M = 0.8, 0.4
#: Base units so near each other along a wall are one run; what hangs so near the end of a row is
#: flush with it; a window's frame is kept clear by so much.
JOINED_M, FLUSH_M, OFF_WINDOW_M = 0.035, 0.05, 0.03
#: A row that is by itself is so long, and has two units at least.
LEAST_ROW_M = 1.0
#: How many ways to fill a row are tried, where leaves or a hood are in the way of the first.
FILLINGS = 8


class _Row(NamedTuple):
    """A stretch of a wall over the base units ``below`` (how far along it their middles are, and
    their ids); ``beside``: what hangs there already, right at an end of it.

    Units hang from its ``low`` end on or, where ``from_high``, from the other.
    """

    side: Side
    low: float
    high: float
    below: tuple[tuple[float, int], ...]
    beside: int | None
    from_high: bool


def with_wall_units(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with rows of units over the pieces of ``of``, where neither a window nor a hood is
    in their place, all of one look, height and depth; None when there is no row.

    A row has two units at least, but at both sides of a hood one will do.
    """
    by_width = _of_one_look(tried.models(rule.category), tried)
    if not by_width:
        return None
    groups: dict[int, list[_Row]] = {}
    for number, row in enumerate(_rows(rule, by_width, tried)):
        groups.setdefault(-1 - number if row.beside is None else row.beside, []).append(row)
    furnished = tried
    for rows in groups.values():
        if len(rows) == 2:
            one = _filled(rule, rows[0], by_width, 1, furnished)
            both = None if one is None else _filled(rule, rows[1], by_width, 1, one)
            if both is not None:
                furnished = both
                continue
        for row in rows:
            furnished = _filled(rule, row, by_width, 2, furnished) or furnished
    return None if furnished is tried else furnished


def _of_one_look(found: Sequence[Asset], tried: RoomTry) -> Mapping[int, Asset]:
    """By width the models of one suite, depth and height: of those of which there are most."""
    looks: dict[tuple[object, ...], dict[int, Asset]] = {}
    for k in tried.rng.permutation(len(found)).tolist():
        deep, wide, tall = found[k].extents_m
        look = looks.setdefault((found[k].suite, round(deep, 2), round(tall, 2)), {})
        look.setdefault(round(wide * STEPS_A_METRE), found[k])
    return max(looks.values(), key=len, default={})


def _rows(rule: FurnitureRule, by_width: Mapping[int, Asset], tried: RoomTry) -> list[_Row]:
    """Where rows may be, wall by wall."""
    deep, _, tall = next(iter(by_width.values())).extents_m
    heights = rule.z_m, rule.z_m + tall
    taken = _taken(*heights, tried)
    hung = _hung(*heights, tried)
    out: list[_Row] = []
    for side in tried.sides:
        free = [
            (start, start + part.length_m)
            for part in free_parts(side, taken, deep)
            for start in (side.measure(part.start)[0],)
        ]
        for low, high, below in _runs(rule, side, tried):
            for a, b in ((max(low, x), min(high, y)) for x, y in free):
                if b - a < min(by_width) / STEPS_A_METRE - NOMINAL_M:
                    continue
                before, behind = (_at(end, side, hung, tried) for end in (a, b))
                beside = behind if before is None else before
                # From the hood or, without, from where no window cuts the run.
                from_high = before is None and (behind is not None or (a > low and b == high))
                out.append(_Row(side, a, b, below, beside, from_high))
    return out


def _runs(
    rule: FurnitureRule, side: Side, tried: RoomTry
) -> Iterator[tuple[float, float, tuple[tuple[float, int], ...]]]:
    """Base units that stand in a row at a wall: from where to where, and their middles and ids."""
    spans = sorted(span for k in tried.all(rule.of) for span in _along(k, side, tried))
    starts = [k for k, (a, b) in enumerate(pairwise(spans), 1) if b[0] - a[1] > JOINED_M]
    for first, last in pairwise([0, *starts, len(spans)]):
        run = spans[first:last]
        if run:
            yield run[0][0], run[-1][1], tuple(((a + b) / 2, k) for a, b, k in run)


def _along(target_id: int, side: Side, tried: RoomTry) -> Iterator[tuple[float, float, int]]:
    """What a base unit takes of a wall that it stands at: of a corner unit the end of an arm."""
    target, info = tried.layout.items[target_id], tried.layout.info(target_id)
    deep, wide, _ = info.extents_m
    corner = min(deep, wide) >= CORNER_M
    # The walls of a corner unit are behind it and at its right; the run goes on at its left and
    # before it.
    for turn, (x, y) in (
        (0.0, (0.0, (wide - ARM_M) / 2 if corner else 0.0)),
        (math.pi / 2, ((deep - ARM_M) / 2, 0.0)),
    ):
        if turn and not corner:
            continue
        along, _ = side.measure(placed_from(target, x, y)[:2])
        _, away = side.measure(target.pose.position_m[:2])
        backed = math.cos(yaw_of(target.pose.quat_xyzw) + turn - side.yaw) > 0.99
        if backed and 0 < along < side.length_m and 0 < away < max(deep, wide):
            half = (ARM_M if corner else wide) / 2
            yield along - half, along + half, target_id


def _taken(low_m: float, high_m: float, tried: RoomTry) -> list[Array]:
    """Corners (N, 2) of what is in the way between two heights: windows, and what is placed."""
    taken = [
        shapely.get_coordinates(sight.before.buffer(OFF_WINDOW_M, join_style="mitre"))
        for sight in tried.sights
        if high_m > sight.low_m and low_m < sight.high_m
    ]
    for k in (k for ids in tried.placed.values() for k in ids):
        z, tall = tried.layout.items[k].pose.position_m[2], tried.layout.info(k).extents_m[2]
        if z < high_m and z + tall > low_m:
            taken.append(_outline(k, tried))
    return taken


def _hung(low_m: float, high_m: float, tried: RoomTry) -> list[int]:
    """What hangs between two heights: a hood."""
    found = (k for ids in tried.placed.values() for k in ids)
    return [k for k in found if OVERHEAD_M < tried.layout.items[k].pose.position_m[2] < high_m]


def _at(end: float, side: Side, hung: Sequence[int], tried: RoomTry) -> int | None:
    """What hangs right at one end of a row."""
    for k in hung:
        spots = [side.measure((x, y)) for x, y in _outline(k, tried).tolist()]
        near = min(away for _, away in spots), min(abs(end - along) for along, _ in spots)
        if max(near) < FLUSH_M:
            return k
    return None


def _outline(item_id: int, tried: RoomTry) -> Array:
    item, info = tried.layout.items[item_id], tried.layout.info(item_id)
    x, y, _ = item.pose.position_m
    return np.array(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))


def _filled(
    rule: FurnitureRule,
    row: _Row,
    by_width: Mapping[int, Asset],
    least: int,
    tried: RoomTry,
) -> RoomTry | None:
    """The room with a row of so many units at least; None where none hang there."""
    for widths in islice(_fillings(row.high - row.low, sorted(by_width)), FILLINGS):
        units = [by_width[w] for w in widths]
        long_m = sum(unit.extents_m[1] for unit in units)
        if len(units) < least or (row.beside is None and long_m < LEAST_ROW_M - NOMINAL_M):
            continue
        more = _hang(rule, row, units, tried)
        if more is not None:
            return more
    return None


def _fillings(length_m: float, widths: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """Nominal widths of units side by side, the longest rows first, of each those of fewest units
    first, either way round, then of more."""
    total = math.floor((length_m + NOMINAL_M) * STEPS_A_METRE)
    for reached in range(total, 0, -1):
        few = fewest(reached, widths)
        if sum(few) == reached:
            narrower = fewest(reached, [w for w in widths if w < few[0]])
            ways = [few, few[::-1], *([narrower] if sum(narrower) == reached else [])]
            yield from dict.fromkeys(ways)


def _hang(rule: FurnitureRule, row: _Row, units: Sequence[Asset], tried: RoomTry) -> RoomTry | None:
    """The room with these units side by side, flush with one end of the row; None where one of
    them has no room, or a leaf meets another's round a corner."""
    long_m = sum(unit.extents_m[1] for unit in units)
    drawn_out = (row.high - row.low - long_m) / max(1, len(units) - 1)
    gap = drawn_out if UNIT_GAP_M <= drawn_out <= WIDEST_GAP_M else UNIT_GAP_M
    t = row.high - long_m - gap * (len(units) - 1) if row.from_high else row.low
    for unit in units:
        deep, wide, _ = unit.extents_m
        middle = t + wide / 2
        _, below = min(row.below, key=lambda one: (abs(one[0] - middle), one[1]))
        spot: Vec2 = row.side.at(middle, deep / 2 + HUNG_GAP_M)
        if tried.full(rule.category):
            return None
        more = with_placed(rule, unit, (*spot, rule.z_m, row.side.yaw), below, tried)
        if more is None or _leaves_meet(more):
            return None
        tried = more
        t += wide + gap
    return tried


def _leaves_meet(tried: RoomTry) -> bool:
    """Whether leaves of the unit that was hung last meet those of one at another wall as both
    open; side by side they turn their backs to each other."""
    items = tried.layout.items
    last = list(items.values())[-1]
    yaw = yaw_of(last.pose.quat_xyzw)
    return any(
        items[k].category == last.category
        and abs(math.cos(yaw_of(items[k].pose.quat_xyzw) - yaw)) < 0.5
        for k in tried.layout.ways.ways.entered(way_of(last, tried.layout.library))
    )


def fewest(total: int, widths: Sequence[int]) -> tuple[int, ...]:
    """The fewest of these widths, each any number of times, that fill ``total``; where none do,
    the most of it. Widest first."""
    best: dict[int, tuple[int, ...]] = {0: ()}
    for reached in range(1, total + 1):
        ways = [(w, *best[reached - w]) for w in widths if reached - w in best]
        if ways:
            best[reached] = min(ways, key=len)
    return tuple(sorted(best[max(best)], reverse=True))
