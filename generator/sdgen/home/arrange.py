"""Furniture of generated homes: each room's rules followed in order, piece by piece.

Floor before doors and in front of pieces is kept clear; a room that misses a needed piece or
that a robot cannot cross is arranged anew, a bounded number of times.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from sdgen.catalog.records import Catalog, FurnitureRule
from sdgen.geometry import yaw_of
from sdgen.home import anchors
from sdgen.home.anchors import PlacedAt, Side
from sdgen.home.context import Models
from sdgen.home.furnish import top_of
from sdgen.home.hoods import underside_of
from sdgen.home.islands import with_island
from sdgen.home.layout import Layout
from sdgen.home.room_try import (
    RoomTry,
    empty_room,
    free_sides,
    taken_floor,
    with_placed,
)
from sdgen.home.rugs import lying
from sdgen.home.runs import with_row, with_run
from sdgen.home.walking import passable, walkable
from sdgen.home.wall_units import with_wall_units
from sdgen.home.wishes import by_wishes
from sdgen.library.records import Asset, AssetInfo
from sdgen.rejection import Rejection, reject
from sdgen.scene import Home, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M

#: Bound the search: a room that fails so often mostly has no arrangement, and homes are drawn anew.
ROOM_TRIES = 8
#: A sofa that no television finds a place opposite to is put elsewhere, so often at most.
GROUP_TRIES = 4
#: One piece each of some pieces, not so many of every one.
ONE_EACH = ("before", "under", "opposite")
#: Where all pieces of a rule are placed at once.
MANY_AT_ONCE: Mapping[str, Callable[[FurnitureRule, RoomTry], RoomTry | None]] = {
    "row": with_row,
    "run": with_run,
    "over": with_wall_units,
    "island": with_island,
}
#: Of 718 pieces that found a place 663 were of the first model tried, nine of the fourth.
MODELS_TRIED = 4
#: Where large models come first, one may come before another of which it has so much of the floor.
NEARLY_AS_LARGE = 0.6
#: Where one model found no place, none does that is as large in each direction but for so much.
SAME_M = 0.02
#: What hangs above a piece may be wider by so much: a hood over a stove of the same nominal width,
#: a mirror over a small basin.
ABOVE_WIDER_M = 0.08
#: At walls furniture keeps so far off the frames of doors where it can.
EASED_M = 0.25
#: What stands so far off the middle line of what it faces still stands across from it, and what
#: stands further from it is far: by eye.
IN_LINE_M, FAR_M, MOST_OFF = 0.15, 3.4, 0.9


def furnish_by_rules(
    home: Home, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with the furniture of every room by its type's rules; first of rooms that need
    what a home has only so many of."""

    def spares(room: Room) -> bool:
        needed = [r.category for r in rules_of(room, catalog) if r.needed and r.category]
        return all(catalog.category(name).at_most.home is None for name in needed)

    for room in sorted(home.rooms, key=spares):
        arranged = _arrange_room(home, room, layout, catalog, models, rng)
        if isinstance(arranged, Rejection):
            return arranged
        layout = arranged
    return layout


def _arrange_room(
    home: Home, room: Room, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with this room's furniture, after ROOM_TRIES tries at most."""
    last: Rejection = reject("home", "no_place")
    for number in range(ROOM_TRIES):
        arranged = _try_room(empty_room(home, room, layout, catalog, models, rng, number))
        if isinstance(arranged, Layout):
            return arranged
        last = arranged
    return last


def _try_room(furnished: RoomTry) -> Layout | Rejection:
    room_type, rng = furnished.room.type, furnished.rng
    groups = groups_of(rules_of(furnished.room, furnished.catalog))
    for group in _needed_first(groups, rng) if furnished.modest else groups:
        asked = [Asked(rule, _count(rule, furnished)) for rule in group]
        more = _with_group(asked, furnished)
        if more is None and group[0].needed:
            return reject("home", "no_place", category=group[0].category or group[0].row[0])
        if more is not None and not (group[0].needed or _leaves_way(furnished, more)):
            continue
        furnished = more or furnished
    if not passable(furnished) or not (furnished.modest or walkable(furnished)):
        return reject("home", "no_way_through", category=room_type)
    return furnished.layout


def _leaves_way(before: RoomTry, after: RoomTry) -> bool:
    """Whether people walk through a room as well with some pieces more; looked at only where they
    did not with all, before."""
    if before.number == 0 or len(after.prints) == len(before.prints):
        return True
    return walkable(after) or not walkable(before)


def rules_of(room: Room, catalog: Catalog) -> tuple[FurnitureRule, ...]:
    """The rules by which a room is furnished, in order."""
    return next(t.furniture for t in catalog.room_types if t.name == room.type)


class Asked(NamedTuple):
    """A rule, and how many pieces a room is to have by it (for each piece of ``of``)."""

    rule: FurnitureRule
    pieces: int


def groups_of(rules: Sequence[FurnitureRule]) -> list[list[FurnitureRule]]:
    """Rules of which each but the first is about a piece placed by one before it in its group."""
    groups: list[list[FurnitureRule]] = []
    placed: set[str] = set()
    for rule in rules:
        if not groups or placed.isdisjoint(rule.of):
            groups.append([])
            placed = set()
        groups[-1].append(rule)
        placed.update((rule.category, rule.corner, *rule.row, *rule.extra))
    return groups


def _needed_first(groups: Sequence[list[FurnitureRule]], rng: Rng) -> list[list[FurnitureRule]]:
    """The groups that a room is not without, in a drawn order: a wardrobe stands where a bed went
    in vain, before the bed; then the others."""
    needed = [group for group in groups if group[0].needed and not group[0].of]
    order = [needed[k] for k in rng.permutation(len(needed)).tolist()]
    return [*order, *(group for group in groups if group not in needed)]


def _count(rule: FurnitureRule, tried: RoomTry) -> int:
    rng = tried.rng
    if tried.outline.area < rule.from_m2 or rng.random() >= rule.chance:
        return 0
    return int(rng.integers(rule.count[0], rule.count[1] + 1))


def _with_group(group: Sequence[Asked], tried: RoomTry) -> RoomTry | None:
    """The room with the pieces of a group, the best of some tries; None when the first of them, or
    one it is not without, never found a place."""
    best: tuple[float, RoomTry] | None = None
    for _ in range(1 if len(group) == 1 or tried.modest else GROUP_TRIES):
        made = _in_turn(group, tried)
        if made is not None and (best is None or made[0] < best[0]):
            best = made
        if best is not None and best[0] == 0.0:
            break
    return None if best is None else best[1]


def _in_turn(group: Sequence[Asked], tried: RoomTry) -> tuple[float, RoomTry] | None:
    """What is missing of a group (for each rule up to 1), and the room with the rest of it."""
    missing = 0.0
    for number, (rule, count) in enumerate(group):
        targets = _targets(rule, count, tried)
        if count == 0 or not targets:
            if number == 0:  # nobody asked for it, nor for what goes with it
                return 0.0, tried
            continue
        each = 1 if rule.where in ONE_EACH else count
        made, lacking = _follow(rule, each, targets, tried)
        if made is None and (rule.needed or number == 0):
            return None
        missing += lacking
        tried = made or tried
    return missing, tried


def _targets(rule: FurnitureRule, count: int, tried: RoomTry) -> list[int | None]:
    """The pieces that a rule is about, in a drawn order, or the nearest first to those that its
    piece is to be near; one that is none, where it is about the room."""
    if not rule.of:
        return [None]
    items, found = tried.layout.items, tried.all(rule.of)
    order = [found[k] for k in tried.rng.permutation(len(found)).tolist()]
    near = [items[k].pose.position_m for k in tried.all(rule.near)]
    if near:
        order.sort(key=lambda k: min(math.dist(items[k].pose.position_m, at) for at in near))
    return [*order[:count]] if rule.where in ONE_EACH else [*order]


def _follow(
    rule: FurnitureRule, count: int, targets: Sequence[int | None], tried: RoomTry
) -> tuple[RoomTry | None, float]:
    """The room with the pieces of a rule (None when none found a place), and the share missing."""
    if rule.where in MANY_AT_ONCE:
        whole = MANY_AT_ONCE[rule.where](rule, tried)
        return whole, float(whole is None)
    made: list[RoomTry] = []
    for target in targets:
        for _ in range(count):
            more = _with_one(rule, target, made[-1] if made else tried)
            if more is None:
                break
            made.append(more)
    least = _least(rule, targets, tried)
    # Chairs face each other in pairs.
    if rule.where == "around" and not rule.gap_m and len(made) % 2 and len(made) > least:
        made.pop()
    placed = len(made)
    if placed < least:
        return None, 1.0
    furnished = made[-1] if made else None
    if rule.where == "opposite" and furnished is not None:
        return furnished, _off_line(rule, furnished)
    if rule.where in ("beside", "around"):
        return furnished, 1.0 - placed / (count * len(targets))
    return furnished, float(placed == 0)


def _least(rule: FurnitureRule, targets: Sequence[int | None], tried: RoomTry) -> int:
    """How many pieces there must be at least: at tables with no room for two side by side, and
    beside a piece in a room that makes do, half of what the rule says."""
    ids = [k for k in targets if k is not None] if rule.where == "around" else []
    short = all(tried.layout.info(k).extents_m[1] < 2 * anchors.TWO_SEATS_M for k in ids)
    half = (ids and short) or (rule.where == "beside" and tried.modest)
    return (rule.least + 1) // 2 if half else rule.least


def _off_line(rule: FurnitureRule, tried: RoomTry) -> float:
    """How far a piece is from right across what it stands opposite to, and beyond ``FAR_M``,
    metres; nobody sees less than ``IN_LINE_M``. Always less than a piece that is missing."""
    across = tried.layout.items[tried.all([rule.category])[-1]].pose.position_m
    facing = [tried.layout.items[k].pose for k in tried.all(rule.of)]
    offs = []
    for pose in facing:
        yaw = yaw_of(pose.quat_xyzw)
        dx, dy = across[0] - pose.position_m[0], across[1] - pose.position_m[1]
        aside = abs(dy * math.cos(yaw) - dx * math.sin(yaw))
        far = max(0.0, dx * math.cos(yaw) + dy * math.sin(yaw) - FAR_M)
        offs.append((aside if aside > IN_LINE_M else 0.0) + far)
    return min(*offs, MOST_OFF)


def _with_one(rule: FurnitureRule, target: int | None, tried: RoomTry) -> RoomTry | None:
    """The room with one piece of a rule, of the first model and pose that fit; None, too, when
    there are as many as its category is given."""
    if tried.full(rule.category):
        return None
    failed: list[AssetInfo] = []
    for asset in _candidates(rule, target, tried):
        if any(_as_large(asset, other) for other in failed):
            continue
        if len(failed) == MODELS_TRIED and not rule.largest:
            break
        for off_doors_m in _off_doors(rule, tried):
            walls = _walls(rule, asset, tried, off_doors_m)
            poses = _poses(rule, asset, target, walls, tried)
            for pose in by_wishes(rule, asset, poses, walls, tried):
                more = with_placed(rule, asset, pose, target, tried)
                if more is not None:
                    return more
        failed.append(asset)
    return None


def _off_doors(rule: FurnitureRule, tried: RoomTry) -> tuple[float, ...]:
    """How far off the frames of doors a piece is sought at walls, in this order."""
    if rule.where != "wall" or rule.z_m or tried.number or not tried.thresholds:
        return (0.0,)
    return (EASED_M, 0.0)


def _as_large(model: AssetInfo, other: AssetInfo) -> bool:
    """Whether a model takes all the room that another does."""
    return all(a > b - SAME_M for a, b in zip(model.extents_m, other.extents_m, strict=True))


def _candidates(rule: FurnitureRule, target: int | None, tried: RoomTry) -> list[Asset]:
    """The models of a rule in the order they are tried, at random but for these: round and beside
    a piece all are of the first one's model, elsewhere on a floor what stands in the room already
    comes first; above a piece the nearest to its width does, none much wider; large ones mostly,
    where the rule says so."""
    found = tried.models(rule.category)
    order = [found[k] for k in tried.rng.permutation(len(found)).tolist()]
    if rule.where == "above" and target is not None:
        wide, ceiling_m = tried.layout.info(target).extents_m[1], tried.room.height_m
        order = [m for m in order if m.extents_m[1] <= wide + ABOVE_WIDER_M]
        order = [m for m in order if underside_of(m, rule.z_m, ceiling_m) is not None]
        return sorted(order, key=lambda m: round(wide - m.extents_m[1], 1))
    if rule.z_m:
        return order
    there = {tried.layout.items[k].asset for k in tried.all([rule.category])}
    alike = [m for m in order if m.id in there]
    if alike and rule.where in ("around", "beside"):
        return alike
    if tried.modest and rule.needed:
        return sorted(order, key=_floor_m2)
    if rule.largest:
        order.sort(key=lambda m: -_floor_m2(m) * tried.rng.uniform(NEARLY_AS_LARGE, 1.0))
        return order
    return [*alike, *(m for m in order if m.id not in there)]


def _floor_m2(model: AssetInfo) -> float:
    return model.extents_m[0] * model.extents_m[1]


def _walls(
    rule: FurnitureRule, asset: AssetInfo, tried: RoomTry, off_doors_m: float
) -> tuple[Side, ...]:
    """The stretches of wall that a piece may stand or hang at."""
    if rule.where != "wall":
        return ()
    deep, _, tall = asset.extents_m
    sides = free_sides(tried, rule.z_m, rule.z_m + tall, deep, off_doors_m)
    # A room that did not come out so makes do with less.
    apart = max(0.0, rule.gap_m) * (1 - tried.number / ROOM_TRIES)
    return tuple(
        replace(side, start=side.at(apart, 0.0), length_m=side.length_m - 2 * apart)
        for side in sides
        if side.length_m > 2 * apart
    )


def _poses(
    rule: FurnitureRule,
    asset: AssetInfo,
    target_id: int | None,
    walls: Sequence[Side],
    tried: RoomTry,
) -> list[PlacedAt]:
    layout, rng = tried.layout, tried.rng
    size, reach = (asset.extents_m[0], asset.extents_m[1]), layout.library.reach(asset.id)
    if rule.where == "wall":
        centred = rule.centred and not tried.modest
        return anchors.against_walls(walls, size, rule.z_m, rng, reach=reach, centred=centred)
    if rule.where == "corner":
        return anchors.in_corners(tried.sides, size, rng, reach)
    if asset.extents_m[2] <= FLAT_M and rule.where in ("under", "middle"):
        return lying(asset, target_id, rule.gap_m, tried)
    if target_id is None:
        return anchors.in_middle(tried.outline, taken_floor(tried), rng)
    target, info = layout.items[target_id], layout.info(target_id)
    if rule.where == "on":
        top = top_of(layout, target_id)
        return anchors.on_top(target, info, size, top, rng, rule.centred)
    if rule.where == "beside":
        return anchors.beside(target, info, size, rng)
    if rule.where == "before":
        return anchors.before(target, info, size, rule.gap_m)
    if rule.where == "around":
        seated = [layout.items[k].pose.position_m[:2] for k in tried.all([rule.category])]
        return anchors.around(target, info, size, seated, rng, rule.gap_m)
    if rule.where == "above":
        z_m = underside_of(asset, rule.z_m, tried.room.height_m) or rule.z_m
        return anchors.above(target, info, size, z_m, tried.sides)
    return anchors.opposite(target, tried.sides, size, rng, reach)
