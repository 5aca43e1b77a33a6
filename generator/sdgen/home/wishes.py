"""Soft relations: of the poses a piece may take, those that people would choose come first."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sdgen.catalog.records import Category, FurnitureRule
from sdgen.geometry import Array, Vec2, yaw_of
from sdgen.home.anchors import PlacedAt, Side
from sdgen.home.crowding import crowding, elbows
from sdgen.home.room_try import RoomTry
from sdgen.library.records import AssetInfo

#: What chance makes of a wish, metres (one sigma): neighbours do not all furnish alike.
CHANCE_M = 0.25
#: Looking quite away from what it should face costs a piece as much as standing so far off.
AWAY_M = 4.0
#: And its back to the wall across from those it should be in line with, as much as this.
OTHER_WALL_M = 3.0
#: In the middle of a long bare wall something is missed more: up to this length, metres, each is
#: worth so much of being off the middle.
LONG_M, LONG_SHARE = 4.0, 0.3

#: Where pieces stand that do not go with another.
ON_THEIR_OWN = ("wall", "corner", "middle")
#: By eye: covering a window and its radiator costs a piece so much, in all; seats are put there.
AT_WINDOW, BED_AT_WINDOW = 0.7, 2.5
#: Nobody puts a piece where it crowds a room by more.
CROWDED_M = 1.0
#: Right across comes first of what is opposite: so far aside of it costs so many times as much.
ACROSS = 2.0
#: What stands by beds takes so much on both sides.
BEDSIDE_M = 0.45


def by_wishes(
    rule: FurnitureRule,
    asset: AssetInfo,
    poses: Sequence[PlacedAt],
    walls: Sequence[Side],
    tried: RoomTry,
) -> Sequence[PlacedAt]:
    """The poses of a rule's piece, best first by its wishes and by what it would crowd; as they are
    where nothing in the room bears on them. ``walls`` are the free stretches whose middle is
    meant."""
    crowded = _crowding(rule, asset, poses, tried)
    near = _middles(rule.near, tried)
    facing = _middles(rule.facing, tried)
    aligned = [yaw_of(tried.layout.items[k].pose.quat_xyzw) for k in tried.all(rule.aligned)]
    centred = rule.centred and not tried.modest
    # What a room can do without would rather not stand at all than crowd it.
    goes_with = rule.needed or rule.where == "opposite"
    most = math.inf if goes_with or tried.number else CROWDED_M
    fair = np.flatnonzero(crowded <= most).tolist()
    poses, crowded = [poses[k] for k in fair], crowded[fair]
    if not (near or facing or aligned or centred):
        return [poses[k] for k in np.argsort(crowded, kind="stable").tolist()]
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

    costs = [cost(pose) + more for pose, more in zip(poses, crowded.tolist(), strict=True)]
    return [poses[k] for k in sorted(range(len(poses)), key=costs.__getitem__)]


def _crowding(
    rule: FurnitureRule, asset: AssetInfo, poses: Sequence[PlacedAt], tried: RoomTry
) -> Array:
    """What a piece would crowd in each pose; nothing where it goes with another piece, hangs, or
    the room is glad of any place."""
    apart = rule.where in (*ON_THEIR_OWN, "opposite") or (rule.where == "around" and rule.gap_m > 0)
    if not apart or rule.z_m or tried.modest:
        return np.zeros(len(poses))
    if rule.where == "opposite" and poses:
        aside = np.array([math.dist(pose[:2], poses[0][:2]) for pose in poses])
        return ACROSS * aside + crowding(poses, _size(asset), tried.mouths, 0.0)
    category = tried.catalog.category(rule.category)
    seat, size = _has_elbows(category), _size(asset)
    if category.sleeps:
        wide = (size[0], size[1] + 2 * BEDSIDE_M)
        found = crowding(poses, wide, tried.mouths, BED_AT_WINDOW)
    else:
        found = crowding(poses, size, tried.mouths, 0.0 if seat else AT_WINDOW)
    about = set(tried.all(rule.of))
    others = [
        shape
        for k, shape in tried.prints.items()
        if k not in about
        and (seat or _has_elbows(tried.catalog.category(tried.layout.items[k].category)))
    ]
    return found + elbows(poses, size, others)


def _size(asset: AssetInfo) -> Vec2:
    return asset.extents_m[0], asset.extents_m[1]


def _has_elbows(category: Category) -> bool:
    """Whether people sit on it and draw it about."""
    return {"SITTABLE", "MOVABLE"} <= set(category.properties)


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
