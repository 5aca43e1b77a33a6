"""Furniture of generated homes: each room's rules followed in order, piece by piece.

Floor before doors and in front of pieces is kept clear; a room that misses a needed piece or
that a robot cannot cross is arranged anew, a bounded number of times.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from shapely import prepare
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.catalog.records import Catalog, FurnitureRule, RoomType
from sdgen.freespace import ROBOT_RADIUS_M, opening_rectangle, polygons, union
from sdgen.geometry import quat_from_yaw, round_position, round_quat
from sdgen.home import anchors
from sdgen.home.anchors import PlacedAt, Side, sides_of
from sdgen.home.context import Models
from sdgen.home.furnish import put_piece, stand_in, top_of
from sdgen.home.layout import IN_WALL_M, Intent, Layout, footprint
from sdgen.library.records import AssetInfo
from sdgen.rejection import Rejection, reject
from sdgen.scene import Home, ObjectInstance, Opening, Pose, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M, OVERHEAD_M
from sdgen.zones import doorway_point, floor_obstacles

ROOM_TRIES = 8
MODELS_TRIED = 4
DOOR_CLEAR_M = 0.85
#: A row of units stands without gaps, all but this.
ROW_GAP_M = 0.012
ROWS_TRIED = 6
#: What a person in a room must be able to get to: this far from every doorway's middle.
NEAR_DOOR_M = 0.2


@dataclass
class _RoomState:
    """One try at a room: what stands there, and the floor that is kept clear for whom.

    ``inside`` is the outline with a few millimetres to spare; ``prints`` are the floor's occupants.
    No furniture stands on ``doors``; leaves swing over ``swings``, where no rug lies either.
    """

    room: Room
    outline: Polygon
    sides: tuple[Side, ...]
    openings: tuple[Opening, ...]
    doors: BaseGeometry
    swings: BaseGeometry
    inside: Polygon
    prints: dict[int, Polygon] = field(default_factory=dict)
    placed: dict[str, list[int]] = field(default_factory=dict)
    keep: list[tuple[int, Polygon]] = field(default_factory=list)

    def all(self, categories: Sequence[str]) -> list[int]:
        """Ids of the pieces of these categories, in the order they were placed."""
        return [k for c in categories for k in self.placed.get(c, ())]


def furnish_by_rules(
    home: Home, layout: Layout, catalog: Catalog, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with the furniture of every room by its type's rules."""
    types = {t.name: t for t in catalog.room_types}
    for room in home.rooms:
        arranged = _arrange_room(home, room, types[room.type], layout, models, rng)
        if isinstance(arranged, Rejection):
            return arranged
        layout = arranged
    return layout


def _arrange_room(
    home: Home, room: Room, room_type: RoomType, layout: Layout, models: Models, rng: Rng
) -> Layout | Rejection:
    """The layout with this room's furniture, after ROOM_TRIES tries at most."""
    for _ in range(ROOM_TRIES - 1):
        arranged = _try_room(home, room, room_type, layout.copy(), models, rng)
        if isinstance(arranged, Layout):
            return arranged
    return _try_room(home, room, room_type, layout.copy(), models, rng)


def _try_room(
    home: Home, room: Room, room_type: RoomType, layout: Layout, models: Models, rng: Rng
) -> Layout | Rejection:
    state = _start(home, room)
    for rule in room_type.furniture:
        count = int(rng.integers(rule.count[0], rule.count[1] + 1))
        made = _follow(rule, count, state, layout, models, rng)
        if rule.needed and not made:
            return reject("home", "no_place", category=rule.category or rule.row[0])
    if not _passable(state, layout):
        return reject("home", "no_way_through", category=room.type)
    return layout


def _start(home: Home, room: Room) -> _RoomState:
    mine = tuple(o for o in home.openings if room.id in o.room_ids)
    doors: list[BaseGeometry] = []
    swings: list[BaseGeometry] = []
    for opening in mine:
        if opening.kind == "window":
            continue
        deep = DOOR_CLEAR_M
        if opening.room_ids[0] == room.id:
            deep = max(deep, opening.width_m + 0.08)
            swings.append(opening_rectangle(opening, opening.width_m + 0.08))
        doors.append(opening_rectangle(opening, deep))
    outline = Polygon(room.polygon_m)
    inside = outline.buffer(IN_WALL_M, join_style="mitre")
    prepare(inside)
    sides = sides_of(room.polygon_m)
    return _RoomState(room, outline, sides, mine, union(doors), union(swings), inside)


def _follow(
    rule: FurnitureRule,
    count: int,
    state: _RoomState,
    layout: Layout,
    models: Models,
    rng: Rng,
) -> bool:
    """Place the pieces of a rule; False when none found a place (or chance said no)."""
    if rng.random() >= rule.chance:
        return False
    if rule.where == "row":
        return _row(rule, state, layout, models, rng)
    targets: list[int | None] = [None]
    if rule.of:
        found = state.all(rule.of)
        targets = [found[k] for k in rng.permutation(len(found)).tolist()]
        if rule.where in ("before", "under", "opposite"):
            targets = targets[:count]
            count = 1
    made = False
    for target in targets:
        for _ in range(count):
            made = _one(rule, target, state, layout, models, rng) or made
    return made


def _one(
    rule: FurnitureRule,
    target: int | None,
    state: _RoomState,
    layout: Layout,
    models: Models,
    rng: Rng,
) -> bool:
    candidates = models(rule.category)
    for k in rng.permutation(len(candidates)).tolist()[:MODELS_TRIED]:
        asset = candidates[k]
        if rule.where == "above" and target is not None:
            wide = layout.info(target).extents_m[1] + 0.03
            if asset.extents_m[1] > wide:
                continue
        for pose in _poses(rule, asset, target, state, layout, rng):
            if _place(rule, asset, pose, target, state, layout, rng):
                return True
    return False


def _poses(
    rule: FurnitureRule,
    asset: AssetInfo,
    target_id: int | None,
    state: _RoomState,
    layout: Layout,
    rng: Rng,
) -> list[PlacedAt]:
    size = (asset.extents_m[0], asset.extents_m[1])
    if rule.where == "wall":
        return anchors.against_walls(state.sides, size, rule.z_m, rng)
    if rule.where == "corner":
        return anchors.in_corners(state.sides, size, rng)
    if target_id is None:
        return anchors.in_middle(state.outline, _taken(state), rng)
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
    return anchors.opposite(target, state.sides, size, rng)


def _taken(state: _RoomState) -> BaseGeometry:
    shapes: list[BaseGeometry] = [state.doors]
    shapes += [shape.buffer(0.3) for shape in state.prints.values()]
    return unary_union(shapes)


def _place(
    rule: FurnitureRule,
    asset: AssetInfo,
    pose: PlacedAt,
    target: int | None,
    state: _RoomState,
    layout: Layout,
    rng: Rng,
) -> bool:
    """Put a piece there if it fits: in the room, clear of doors, windows and others' fronts."""
    x, y, z, yaw = pose
    shape = footprint(asset, x, y, yaw)
    flat = asset.extents_m[2] <= FLAT_M
    on_floor = z < OVERHEAD_M and not flat and rule.where != "on"
    if not state.inside.contains(shape) or z + asset.extents_m[2] > state.room.height_m:
        return False
    if _covers_opening(asset, pose, state):
        return False
    front = _front(asset, pose, rule.front_m)
    if flat and shape.intersects(state.swings):
        return False
    if on_floor:
        if shape.intersects(state.doors):
            return False
        for owner, kept in state.keep:
            if owner == target or not kept.intersects(shape):
                continue
            if kept.intersection(shape).area > 1e-3:
                return False
        # A seat's front is under its table, and a piece before another is that one's business.
        if rule.where not in ("around", "before") and not _front_free(front, state):
            return False
    item = stand_in(
        ObjectInstance(
            id=next(layout.ids),
            category=asset.category,
            asset=asset.id,
            pose=Pose(
                position_m=round_position((x, y, z)), quat_xyzw=round_quat(quat_from_yaw(yaw))
            ),
            room_id=state.room.id,
            fixed=True,
        ),
        asset,
        rng,
    )
    intent = Intent("ON", target) if rule.where == "on" and target is not None else None
    if not put_piece(item, asset, layout, intent):
        return False
    state.placed.setdefault(asset.category, []).append(item.id)
    if on_floor:
        state.prints[item.id] = shape
    if on_floor and front is not None and rule.where not in ("around", "before"):
        state.keep.append((item.id, front))
    return True


def _front(asset: AssetInfo, pose: PlacedAt, front_m: float) -> Polygon | None:
    """The floor before a piece that stays clear."""
    if front_m <= 0:
        return None
    x, y, _, yaw = pose
    half, wide = asset.extents_m[0] / 2, asset.extents_m[1] / 2 - 0.02
    local = np.array([(half, -wide), (half + front_m, -wide), (half + front_m, wide), (half, wide)])
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    return Polygon(local @ turn.T + (x, y))


def _front_free(front: Polygon | None, state: _RoomState) -> bool:
    if front is None:
        return True
    if front.difference(state.inside).area > 0.05 * front.area:
        return False
    return all(
        not front.intersects(shape) or front.intersection(shape).area <= 1e-3
        for shape in state.prints.values()
    )


def _covers_opening(asset: AssetInfo, pose: PlacedAt, state: _RoomState) -> bool:
    """True when a piece against a wall stands before a window or a door in it."""
    x, y, z, yaw = pose
    low, high = z, z + asset.extents_m[2]
    shape = footprint(asset, x, y, yaw)
    for opening in state.openings:
        sill = opening.center_m[2]
        if high <= sill + 0.02 or low >= sill + opening.height_m:
            continue
        if shape.intersects(opening_rectangle(opening, 0.32 if opening.kind == "window" else 0.52)):
            return True
    return False


def _row(rule: FurnitureRule, state: _RoomState, layout: Layout, models: Models, rng: Rng) -> bool:
    """Units side by side against one wall, either way round."""
    for _ in range(ROWS_TRIED):
        order = rule.row if rng.random() < 0.5 else rule.row[::-1]
        chosen: list[AssetInfo] = []
        for category in order:
            found = models(category)
            if not found:
                return False
            chosen.append(found[int(rng.integers(len(found)))])
        total = sum(a.extents_m[1] + ROW_GAP_M for a in chosen)
        lengths = np.array([side.length_m for side in state.sides])
        turns = rng.permutation(len(state.sides)).tolist()
        turns.sort(key=lambda k: lengths[k] < total + 0.05)
        for k in turns:
            side = state.sides[k]
            spare = side.length_m - total - 2 * anchors.SIDE_GAP_M
            if spare < 0:
                break
            for start in (0.0, spare, float(rng.uniform(0.0, spare))):
                if _stand_row(rule, chosen, side, start, state, layout, rng):
                    return True
    return False


def _stand_row(
    rule: FurnitureRule,
    chosen: Sequence[AssetInfo],
    side: Side,
    start: float,
    state: _RoomState,
    layout: Layout,
    rng: Rng,
) -> bool:
    """All units of a row, or none of them."""
    present = set(layout.items)
    placed = {category: list(ids) for category, ids in state.placed.items()}
    keep, prints = list(state.keep), dict(state.prints)
    t = start + anchors.SIDE_GAP_M
    for asset in chosen:
        width = asset.extents_m[1]
        middle = t + width / 2
        spot = side.at(middle, asset.extents_m[0] / 2 + anchors.BACK_GAP_M)
        if not _place(rule, asset, (*spot, 0.0, side.yaw), None, state, layout, rng):
            for object_id in [k for k in layout.items if k not in present]:
                layout.drop(object_id)
            state.placed.clear()
            state.placed.update(placed)
            state.keep, state.prints = keep, prints
            return False
        t += width + ROW_GAP_M
    return True


def _passable(state: _RoomState, layout: Layout) -> bool:
    """True when a robot can get from each doorway of the room to every other and to its middle."""
    ids = [k for found in state.placed.values() for k in found]
    obstacles = floor_obstacles([layout.items[k] for k in ids], layout.library.infos)
    grown = union([o.buffer(ROBOT_RADIUS_M, quad_segs=2) for o in obstacles])
    free = state.outline.buffer(-ROBOT_RADIUS_M, join_style="mitre").difference(grown)
    parts = polygons(free)
    ends = [
        Point(doorway_point(opening, state.room))
        for opening in state.openings
        if opening.kind != "window"
    ]
    least = 0.3 if state.outline.area < 8.0 else 1.0
    return any(
        part.area >= least and all(part.distance(end) <= NEAR_DOOR_M for end in ends)
        for part in parts
    )
