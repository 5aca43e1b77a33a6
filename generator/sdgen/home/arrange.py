"""Furniture of generated homes: each room's rules followed in order, piece by piece.

Floor before doors and in front of pieces is kept clear; a room that misses a needed piece or
that a robot cannot cross is arranged anew, a bounded number of times.
"""

from __future__ import annotations

from shapely.geometry import Point

from sdgen.catalog.records import Catalog, FurnitureRule
from sdgen.facts import bodies_of
from sdgen.freespace import ROBOT_RADIUS_M, polygons, union
from sdgen.home import anchors
from sdgen.home.anchors import PlacedAt
from sdgen.home.context import Models
from sdgen.home.furnish import top_of
from sdgen.home.layout import Layout
from sdgen.home.room_try import RoomTry, empty_room, taken_floor, with_placed
from sdgen.home.runs import with_row, with_run
from sdgen.home.wishes import by_wishes
from sdgen.library.records import Asset, AssetInfo
from sdgen.rejection import Rejection, reject
from sdgen.scene import Home, Room
from sdgen.seeding import Rng
from sdgen.zones import doorway_point, floor_obstacles

#: Bound the search: a room that fails so often mostly has no arrangement, and homes are drawn anew.
ROOM_TRIES = 8
#: Of 718 pieces that found a place 663 were of the first model tried, nine of the fourth.
MODELS_TRIED = 4
#: What a person in a room must be able to get to: this far from every doorway's middle.
NEAR_DOOR_M = 0.2
#: Floor that a robot's middle has in a room: a small bathroom has little more than a spot to turn.
SMALL_ROOM_M2, LEAST_FREE_SMALL_M2, LEAST_FREE_M2 = 8.0, 0.3, 1.0
#: What hangs above a piece may be wider by so much: a hood over a stove of the same nominal width.
ABOVE_WIDER_M = 0.03


def furnish_by_rules(
    home: Home, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with the furniture of every room by its type's rules."""
    for room in home.rooms:
        arranged = _arrange_room(home, room, layout, catalog, models, rng)
        if isinstance(arranged, Rejection):
            return arranged
        layout = arranged
    return layout


def _arrange_room(
    home: Home, room: Room, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with this room's furniture, after ROOM_TRIES tries at most."""
    for _ in range(ROOM_TRIES - 1):
        arranged = _try_room(home, room, layout, catalog, models, rng)
        if isinstance(arranged, Layout):
            return arranged
    return _try_room(home, room, layout, catalog, models, rng)


def _try_room(
    home: Home, room: Room, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> Layout | Rejection:
    furnished = empty_room(home, room, layout, catalog, models, rng)
    rules = next(t.furniture for t in catalog.room_types if t.name == room.type)
    for rule in rules:
        count = int(rng.integers(rule.count[0], rule.count[1] + 1))
        more = _follow(rule, count, furnished)
        if rule.needed and more is None:
            return reject("home", "no_place", category=rule.category or rule.row[0])
        furnished = more or furnished
    if not _passable(furnished):
        return reject("home", "no_way_through", category=room.type)
    return furnished.layout


def _follow(rule: FurnitureRule, count: int, tried: RoomTry) -> RoomTry | None:
    """The room with the pieces of a rule; None when none found a place (or chance said no)."""
    rng = tried.rng
    if rng.random() >= rule.chance:
        return None
    if rule.where == "row":
        return with_row(rule, tried)
    if rule.where == "run":
        return with_run(rule, tried)
    targets: list[int | None] = [None]
    if rule.of:
        found = tried.all(rule.of)
        targets = [found[k] for k in rng.permutation(len(found)).tolist()]
        if rule.where in ("before", "under", "opposite"):
            targets = targets[:count]
            count = 1
    furnished: RoomTry | None = None
    for target in targets:
        for _ in range(count):
            furnished = _with_one(rule, target, furnished or tried) or furnished
    return furnished


def _with_one(rule: FurnitureRule, target: int | None, tried: RoomTry) -> RoomTry | None:
    """The room with one piece of a rule, of the first model and pose that fit; None, too, when
    there are as many as its category is given."""
    if tried.full(rule.category):
        return None
    for asset in _candidates(rule, target, tried)[:MODELS_TRIED]:
        for pose in by_wishes(rule, _poses(rule, asset, target, tried), tried):
            more = with_placed(rule, asset, pose, target, tried)
            if more is not None:
                return more
    return None


def _candidates(rule: FurnitureRule, target: int | None, tried: RoomTry) -> list[Asset]:
    """The models of a rule in the order they are tried: at random, but on a floor first those that
    stand in the room already (chairs round a table, a pair of bedside tables), and above a piece
    the nearest to its width first (a unit over a unit), none much wider."""
    found = tried.models(rule.category)
    order = [found[k] for k in tried.rng.permutation(len(found)).tolist()]
    if rule.where == "above" and target is not None:
        wide = tried.layout.info(target).extents_m[1]
        order = [m for m in order if m.extents_m[1] <= wide + ABOVE_WIDER_M]
        return sorted(order, key=lambda m: round(wide - m.extents_m[1], 1))
    if not rule.z_m:
        there = {tried.layout.items[k].asset for k in tried.all([rule.category])}
        order.sort(key=lambda m: m.id not in there)
    return order


def _poses(
    rule: FurnitureRule, asset: AssetInfo, target_id: int | None, tried: RoomTry
) -> list[PlacedAt]:
    layout, rng = tried.layout, tried.rng
    size, reach = (asset.extents_m[0], asset.extents_m[1]), layout.library.reach(asset.id)
    if rule.where == "wall":
        return anchors.against_walls(tried.sides, size, rule.z_m, rng, reach=reach)
    if rule.where == "corner":
        return anchors.in_corners(tried.sides, size, rng, reach)
    if target_id is None:
        return anchors.in_middle(tried.outline, taken_floor(tried), rng)
    target, info = layout.items[target_id], layout.info(target_id)
    if rule.where == "on":
        return anchors.on_top(target, info, size, top_of(layout, target_id), rng)
    if rule.where == "beside":
        return anchors.beside(target, info, size, rng)
    if rule.where == "before":
        return anchors.before(target, info, size, rule.gap_m)
    if rule.where == "around":
        return anchors.around(target, info, size, rng)
    if rule.where == "above":
        return anchors.above(target, info, size, rule.z_m)
    if rule.where == "under":
        return anchors.under(target)
    return anchors.opposite(target, tried.sides, size, rng, reach)


def _passable(tried: RoomTry) -> bool:
    """True when a robot can get from each doorway of the room to every other and to its middle."""
    ids = [k for found in tried.placed.values() for k in found]
    layout = tried.layout
    obstacles = floor_obstacles(bodies_of([layout.items[k] for k in ids], layout.library.infos))
    grown = union([o.buffer(ROBOT_RADIUS_M, quad_segs=2) for o in obstacles])
    free = tried.outline.buffer(-ROBOT_RADIUS_M, join_style="mitre").difference(grown)
    parts = polygons(free)
    ends = [
        Point(doorway_point(opening, tried.room))
        for opening in tried.openings
        if opening.kind != "window"
    ]
    least = LEAST_FREE_M2 if tried.outline.area >= SMALL_ROOM_M2 else LEAST_FREE_SMALL_M2
    return any(
        part.area >= least and all(part.distance(end) <= NEAR_DOOR_M for end in ends)
        for part in parts
    )
