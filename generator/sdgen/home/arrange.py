"""Furniture of generated homes: each room's rules followed in order, piece by piece.

Floor before doors and in front of pieces is kept clear; a room that misses a needed piece or
that a robot cannot cross is arranged anew, a bounded number of times.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
import shapely
from shapely import prepare
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.catalog.records import Catalog, FurnitureRule
from sdgen.facts import bodies_of
from sdgen.freespace import ROBOT_RADIUS_M, opening_rectangle, polygons, union
from sdgen.geometry import quat_from_yaw, round_position, round_quat
from sdgen.home import anchors
from sdgen.home.anchors import PlacedAt, Side, sides_of
from sdgen.home.clearances import Sight, front_of, sight_of
from sdgen.home.context import Models
from sdgen.home.furnish import put_piece, stand_in, top_of
from sdgen.home.layout import IN_WALL_M, Intent, Layout, corners_of
from sdgen.library.records import AssetInfo
from sdgen.rejection import Rejection, reject
from sdgen.scene import Home, ObjectInstance, Opening, Pose, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M, OVERHEAD_M
from sdgen.zones import doorway_point, floor_obstacles

#: Bound the search: a room that fails so often mostly has no arrangement, and homes are drawn anew.
ROOM_TRIES = 8
#: Of 718 pieces that found a place 663 were of the first model tried, nine of the fourth.
MODELS_TRIED = 4
#: Floor kept clear before a doorway: a person with something in their arms gets through.
DOOR_CLEAR_M = 0.85
#: A leaf sweeps its width, and its handle so much more.
HANDLE_M = 0.08
#: A row of units stands without gaps, all but this.
ROW_GAP_M = 0.012
#: Bounds the search, with other models or the other way round each time.
ROWS_TRIED = 6
#: Walls that have this much more than a row's length come first: it need not be wedged in.
ROW_SLACK_M = 0.05
#: A twentieth of the floor before a piece may lie beyond the room's outline (a corner cut off), and
#: shapes that share less than 10 cm² only touch.
FRONT_OUTSIDE = 0.05
TOUCH_M2 = 1e-3
#: What a person in a room must be able to get to: this far from every doorway's middle.
NEAR_DOOR_M = 0.2
#: Floor that a robot's middle has in a room: a small bathroom has little more than a spot to turn.
SMALL_ROOM_M2, LEAST_FREE_SMALL_M2, LEAST_FREE_M2 = 8.0, 0.3, 1.0
#: A piece in the middle of a room leaves so much to others: one squeezes past sideways.
AROUND_M = 0.3
#: What hangs above a piece may be wider by so much: a hood over a stove of the same nominal width.
ABOVE_WIDER_M = 0.03


@dataclass(frozen=True)
class _RoomTry:
    """One try at a room as it stands: what is placed, and the floor that is kept clear for whom.

    A value: a piece more makes a new one, so that a row of which one unit finds no place leaves
    nothing behind.

    ``inside`` is the outline with a few millimetres to spare; ``prints`` are the floor's occupants.
    No furniture stands before ``sights`` nor on ``doors``; leaves swing over ``swings``, where no
    rug lies either.
    """

    room: Room
    layout: Layout
    catalog: Catalog
    models: Models
    rng: Rng
    outline: Polygon
    sides: tuple[Side, ...]
    openings: tuple[Opening, ...]
    sights: tuple[Sight, ...]
    doors: BaseGeometry
    swings: BaseGeometry
    inside: Polygon
    prints: Mapping[int, Polygon] = field(default_factory=dict)
    placed: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    keep: tuple[tuple[int, Polygon], ...] = ()

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """The room's box from above: x0, y0, x1, y1."""
        x0, y0, x1, y1 = self.inside.bounds
        return x0, y0, x1, y1

    def all(self, categories: Sequence[str]) -> list[int]:
        """Ids of the pieces of these categories, in the order they were placed."""
        return [k for c in categories for k in self.placed.get(c, ())]

    def full(self, category: str) -> bool:
        """True when the room, or the home, has as many of a category as it may."""
        in_home = sum(item.category == category for item in self.layout.items.values())
        bound = self.catalog.category(category).at_most
        return bound.reached(len(self.placed.get(category, ())), in_home)

    def with_piece(
        self,
        item: ObjectInstance,
        layout: Layout,
        shape: Polygon | None,
        front: Polygon | None,
    ) -> _RoomTry:
        """The room with one piece more, put into ``layout``; it takes ``shape`` of the floor and
        keeps ``front`` clear."""
        alike = (*self.placed.get(item.category, ()), item.id)
        return replace(
            self,
            layout=layout,
            placed={**self.placed, item.category: alike},
            prints=self.prints if shape is None else {**self.prints, item.id: shape},
            keep=self.keep if front is None else (*self.keep, (item.id, front)),
        )


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
    furnished = _empty(home, room, layout, catalog, models, rng)
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


def _empty(
    home: Home, room: Room, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> _RoomTry:
    mine = tuple(o for o in home.openings if room.id in o.room_ids)
    doors: list[BaseGeometry] = []
    swings: list[BaseGeometry] = []
    for opening in mine:
        if opening.kind == "window":
            continue
        deep = DOOR_CLEAR_M
        if opening.room_ids[0] == room.id:
            deep = max(deep, opening.width_m + HANDLE_M)
            swings.append(opening_rectangle(opening, opening.width_m + HANDLE_M))
        doors.append(opening_rectangle(opening, deep))
    outline = Polygon(room.polygon_m)
    inside = outline.buffer(IN_WALL_M, join_style="mitre")
    prepare(inside)
    return _RoomTry(
        room=room,
        layout=layout,
        catalog=catalog,
        models=models,
        rng=rng,
        outline=outline,
        sides=sides_of(room.polygon_m),
        openings=mine,
        sights=tuple(map(sight_of, mine)),
        doors=union(doors),
        swings=union(swings),
        inside=inside,
    )


def _follow(rule: FurnitureRule, count: int, tried: _RoomTry) -> _RoomTry | None:
    """The room with the pieces of a rule; None when none found a place (or chance said no)."""
    rng = tried.rng
    if rng.random() >= rule.chance:
        return None
    if rule.where == "row":
        return _row(rule, tried)
    targets: list[int | None] = [None]
    if rule.of:
        found = tried.all(rule.of)
        targets = [found[k] for k in rng.permutation(len(found)).tolist()]
        if rule.where in ("before", "under", "opposite"):
            targets = targets[:count]
            count = 1
    furnished: _RoomTry | None = None
    for target in targets:
        for _ in range(count):
            furnished = _with_one(rule, target, furnished or tried) or furnished
    return furnished


def _with_one(rule: FurnitureRule, target: int | None, tried: _RoomTry) -> _RoomTry | None:
    """The room with one piece of a rule, of the first model and pose that fit; None, too, when
    there are as many as its category is given."""
    if tried.full(rule.category):
        return None
    candidates = tried.models(rule.category)
    for k in tried.rng.permutation(len(candidates)).tolist()[:MODELS_TRIED]:
        asset = candidates[k]
        if rule.where == "above" and target is not None:
            wide = tried.layout.info(target).extents_m[1] + ABOVE_WIDER_M
            if asset.extents_m[1] > wide:
                continue
        for pose in _poses(rule, asset, target, tried):
            more = _placed(rule, asset, pose, target, tried)
            if more is not None:
                return more
    return None


def _poses(
    rule: FurnitureRule, asset: AssetInfo, target_id: int | None, tried: _RoomTry
) -> list[PlacedAt]:
    layout, rng = tried.layout, tried.rng
    size, reach = (asset.extents_m[0], asset.extents_m[1]), layout.library.reach(asset.id)
    if rule.where == "wall":
        return anchors.against_walls(tried.sides, size, rule.z_m, rng, reach=reach)
    if rule.where == "corner":
        return anchors.in_corners(tried.sides, size, rng, reach)
    if target_id is None:
        return anchors.in_middle(tried.outline, _taken(tried), rng)
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


def _taken(tried: _RoomTry) -> BaseGeometry:
    return unary_union([tried.doors, *(s.buffer(AROUND_M) for s in tried.prints.values())])


def _placed(
    rule: FurnitureRule, asset: AssetInfo, pose: PlacedAt, target: int | None, tried: _RoomTry
) -> _RoomTry | None:
    """The room with a piece there, if it is clear of walls, doors, windows and others' fronts."""
    x, y, z, yaw = pose
    corners = corners_of(asset, x, y, yaw)
    low_x, low_y, high_x, high_y = tried.bounds
    # Most poses that are not in the room reach beyond its box: told before anything is drawn.
    if not all(low_x <= u <= high_x and low_y <= v <= high_y for u, v in corners):
        return None
    shape = shapely.polygons(corners)
    flat = asset.extents_m[2] <= FLAT_M
    on_floor = z < OVERHEAD_M and not flat and rule.where != "on"
    # A seat's front is under its table, and a piece before another is that one's business.
    keeps_front = on_floor and rule.where not in ("around", "before")
    if not tried.inside.contains(shape) or z + asset.extents_m[2] > tried.room.height_m:
        return None
    if any(sight.hidden_by(shape, z, z + asset.extents_m[2]) for sight in tried.sights):
        return None
    if flat and shape.intersects(tried.swings):
        return None
    if on_floor:
        if shape.intersects(tried.doors):
            return None
        for owner, kept in tried.keep:
            if owner == target or not kept.intersects(shape):
                continue
            if kept.intersection(shape).area > TOUCH_M2:
                return None
    front = front_of(asset, pose, rule.front_m) if keeps_front else None
    if not _front_free(front, tried):
        return None
    item = stand_in(
        ObjectInstance(
            id=next(tried.layout.ids),
            category=asset.category,
            asset=asset.id,
            pose=Pose(
                position_m=round_position((x, y, z)), quat_xyzw=round_quat(quat_from_yaw(yaw))
            ),
            room_id=tried.room.id,
            fixed=True,
        ),
        asset,
        tried.catalog,
        tried.rng,
    )
    intent = Intent("ON", target) if rule.where == "on" and target is not None else None
    layout = tried.layout.copy()
    if not put_piece(item, asset, layout, intent, tried.room, tried.catalog):
        return None
    return tried.with_piece(item, layout, shape if on_floor else None, front)


def _front_free(front: Polygon | None, tried: _RoomTry) -> bool:
    if front is None:
        return True
    if front.difference(tried.inside).area > FRONT_OUTSIDE * front.area:
        return False
    return all(
        not front.intersects(shape) or front.intersection(shape).area <= TOUCH_M2
        for shape in tried.prints.values()
    )


def _row(rule: FurnitureRule, tried: _RoomTry) -> _RoomTry | None:
    """The room with units side by side against one wall, either way round."""
    rng = tried.rng
    for _ in range(ROWS_TRIED):
        order = rule.row if rng.random() < 0.5 else rule.row[::-1]
        chosen: list[AssetInfo] = []
        for category in order:
            found = tried.models(category)
            if not found:
                return None
            chosen.append(found[int(rng.integers(len(found)))])
        total = sum(a.extents_m[1] + ROW_GAP_M for a in chosen)
        reach = tried.layout.library.reach
        left, _ = anchors.end_gaps(reach(chosen[0].id))
        _, right = anchors.end_gaps(reach(chosen[-1].id))
        lengths = np.array([side.length_m for side in tried.sides])
        turns = rng.permutation(len(tried.sides)).tolist()
        turns.sort(key=lambda k: lengths[k] < total + ROW_SLACK_M)
        for k in turns:
            side = tried.sides[k]
            spare = side.length_m - total - left - right
            if spare < 0:
                break
            for start in (left, left + spare, left + float(rng.uniform(0.0, spare))):
                row = _with_row(rule, chosen, side, start, tried)
                if row is not None:
                    return row
    return None


def _with_row(
    rule: FurnitureRule, chosen: Sequence[AssetInfo], side: Side, start: float, tried: _RoomTry
) -> _RoomTry | None:
    """The room with all units of a row; None when one of them finds no place."""
    t = start
    for asset in chosen:
        depth, width, _ = asset.extents_m
        back = anchors.back_gap(tried.layout.library.reach(asset.id))
        spot = side.at(t + width / 2, depth / 2 + back)
        more = _placed(rule, asset, (*spot, 0.0, side.yaw), None, tried)
        if more is None:
            return None
        tried = more
        t += width + ROW_GAP_M
    return tried


def _passable(tried: _RoomTry) -> bool:
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
