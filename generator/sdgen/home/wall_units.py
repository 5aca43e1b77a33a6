"""Wall units over base units: in a row without gaps, in line with what stands below."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from sdgen.catalog.records import FurnitureRule
from sdgen.geometry import yaw_of
from sdgen.home.anchors import HUNG_GAP_M, PlacedAt, Side, gap_behind, placed_from
from sdgen.home.room_try import RoomTry, with_placed
from sdgen.home.ways import way_of
from sdgen.library.records import Asset, AssetInfo
from sdgen.scene import ObjectInstance

#: Between two units over one base unit.
UNIT_GAP_M = 0.004
#: Widths are nominal, in tenths of a metre: a unit is a few millimetres off.
STEPS_A_METRE = 10
#: A piece at least this deep and wide is a corner unit: over the end of each of its arms, clear of
#: what hangs at the other wall, a unit so wide hangs.
CORNER_M, ARM_M = 0.8, 0.4


def with_wall_units(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with units over the pieces of ``of``: over each the fewest that are as wide
    together, where neither a window nor a hood is in their place; None when none found one."""
    found = tried.models(rule.category)
    order = [found[k] for k in tried.rng.permutation(len(found)).tolist()]
    by_width = {round(m.extents_m[1] * STEPS_A_METRE): m for m in reversed(order)}
    furnished: RoomTry | None = None
    for target_id in tried.all(rule.of):
        target, info = tried.layout.items[target_id], tried.layout.info(target_id)
        for unit, pose in _over(target, info, by_width, rule.z_m, tried.sides):
            if (furnished or tried).full(rule.category):
                return furnished
            more = with_placed(rule, unit, pose, target_id, furnished or tried)
            if more is not None and not _leaves_meet(more, target_id):
                furnished = more
    return furnished


def _leaves_meet(tried: RoomTry, target_id: int) -> bool:
    """Whether leaves of the unit that was hung last meet those of another as both open, over a
    corner unit: side by side they turn their backs to each other."""
    if min(tried.layout.info(target_id).extents_m[:2]) < CORNER_M:
        return False
    last = list(tried.layout.items.values())[-1]
    way = way_of(last, tried.layout.library)
    return any(True for _ in tried.layout.ways.ways.entered(way))


def _over(
    target: ObjectInstance,
    info: AssetInfo,
    by_width: Mapping[int, Asset],
    z_m: float,
    sides: Sequence[Side],
) -> list[tuple[Asset, PlacedAt]]:
    """The units that hang over a base unit, with their poses."""
    deep, wide, _ = info.extents_m
    yaw = yaw_of(target.pose.quat_xyzw)
    gap = gap_behind(target, info, sides)
    out: list[tuple[Asset, PlacedAt]] = []
    if min(deep, wide) >= CORNER_M:
        arm = by_width.get(round(ARM_M * STEPS_A_METRE))
        if arm is not None:
            # Its walls are behind it and at its right; the run goes on at its left and before it.
            width, off = arm.extents_m[1], arm.extents_m[0] / 2 + HUNG_GAP_M
            beside = gap_behind(target, info, sides, right=True)
            behind = placed_from(target, off - gap - deep / 2, (wide - width) / 2)
            right = placed_from(target, (deep - width) / 2, off - beside - wide / 2)
            out = [(arm, (*behind[:2], z_m, yaw)), (arm, (*right[:2], z_m, yaw + math.pi / 2))]
        return out
    units = fewest(round(wide * STEPS_A_METRE), tuple(sorted(by_width, reverse=True)))
    y = -sum(by_width[w].extents_m[1] for w in units) / 2 - UNIT_GAP_M * (len(units) - 1) / 2
    for w in units:
        unit = by_width[w]
        off = unit.extents_m[0] / 2 + HUNG_GAP_M - gap
        at = placed_from(target, off - deep / 2, y + unit.extents_m[1] / 2)
        out.append((unit, (*at[:2], z_m, yaw)))
        y += unit.extents_m[1] + UNIT_GAP_M
    return out


def fewest(total: int, widths: Sequence[int]) -> tuple[int, ...]:
    """The fewest of these widths, each any number of times, that fill ``total``; where none do,
    the most of it. Widest first."""
    best: dict[int, tuple[int, ...]] = {0: ()}
    for reached in range(1, total + 1):
        ways = [(w, *best[reached - w]) for w in widths if reached - w in best]
        if ways:
            best[reached] = min(ways, key=len)
    return tuple(sorted(best[max(best)], reverse=True))
