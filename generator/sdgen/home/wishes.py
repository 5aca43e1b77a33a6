"""Soft relations: of the poses a piece may take, those that people would choose come first."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sdgen.catalog.records import FurnitureRule
from sdgen.geometry import yaw_of
from sdgen.home.anchors import PlacedAt, Side
from sdgen.home.room_try import RoomTry

#: What chance makes of a wish, metres (one sigma): neighbours do not all furnish alike.
CHANCE_M = 0.25
#: Looking quite away from what it should face costs a piece as much as standing so far off.
AWAY_M = 4.0
#: And its back to the wall across from those it should be in line with, as much as this.
OTHER_WALL_M = 3.0
#: In the middle of a long bare wall something is missed more: up to this length, metres, each is
#: worth so much of being off the middle.
LONG_M, LONG_SHARE = 4.0, 0.3


def by_wishes(
    rule: FurnitureRule, poses: Sequence[PlacedAt], walls: Sequence[Side], tried: RoomTry
) -> Sequence[PlacedAt]:
    """The poses of a rule's piece, best first by its wishes; as they are where it has none that
    anything in the room bears on. ``walls`` are the free stretches whose middle is meant."""
    near = _middles(rule.near, tried)
    facing = _middles(rule.facing, tried)
    aligned = [yaw_of(tried.layout.items[k].pose.quat_xyzw) for k in tried.all(rule.aligned)]
    centred = rule.centred and not tried.modest
    if not (near or facing or aligned or centred):
        return poses
    # A room that did not come out as one would wish leaves more to chance.
    spread = CHANCE_M * (1 + tried.number)

    def cost(pose: PlacedAt) -> float:
        x, y, _, yaw = pose
        total = float(tried.rng.normal(0.0, spread))
        if near:
            total += min(math.dist((x, y), other) for other in near)
        if facing:
            total += AWAY_M * min(_turned_off((x, y), yaw, other) for other in facing)
        if aligned:
            total += OTHER_WALL_M * (1.0 - max(math.cos(yaw - other) for other in aligned)) / 2
        if centred:
            total += _off_middle(pose, walls)
        return total

    costs = [cost(pose) for pose in poses]
    return [poses[k] for k in sorted(range(len(poses)), key=costs.__getitem__)]


def _middles(categories: Sequence[str], tried: RoomTry) -> list[tuple[float, float]]:
    return [tried.layout.items[k].pose.position_m[:2] for k in tried.all(categories)]


def _turned_off(at: tuple[float, float], yaw: float, other: tuple[float, float]) -> float:
    """0 where a piece looks straight at a point, 1 where it looks the other way."""
    angle = math.atan2(other[1] - at[1], other[0] - at[0]) - yaw
    return (1.0 - math.cos(angle)) / 2


def _off_middle(pose: PlacedAt, walls: Sequence[Side]) -> float:
    """How far from the middle of its stretch of wall, metres; less, where the stretch is long."""
    x, y, _, yaw = pose
    offs = []
    for side in walls:
        along, away = side.measure((x, y))
        if math.cos(yaw - side.yaw) > 0.9 and 0 <= along <= side.length_m:
            off = abs(along - side.length_m / 2) - LONG_SHARE * min(side.length_m, LONG_M)
            offs.append((away, off))
    return min(offs)[1] if offs else 0.0
