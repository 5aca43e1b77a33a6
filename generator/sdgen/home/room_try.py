"""One try at furnishing a room: what is placed so far, and whether one piece more may stand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
import shapely
from shapely import prepare
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.catalog.records import Catalog, FurnitureRule
from sdgen.freespace import opening_rectangle, union
from sdgen.geometry import Array, quat_from_yaw, round_position, round_quat, yaw_of
from sdgen.home.anchors import PlacedAt, Side, sides_of
from sdgen.home.clearances import Sight, between, front_of, sight_of
from sdgen.home.context import Models
from sdgen.home.crowding import Mouths, mouths_of
from sdgen.home.furnish import put_piece, stand_in
from sdgen.home.layout import IN_WALL_M, Intent, Layout, corners_of
from sdgen.library.records import AssetInfo
from sdgen.scene import Home, ObjectInstance, Opening, Pose, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M, HALF_WALL_M, LEAVES, OVERHEAD_M

#: Floor kept clear before a doorway, from the middle line of its wall: a person with something in
#: their arms gets through. What is taller than so much crowds a frame nearer than this.
DOOR_CLEAR_M = HALF_WALL_M + 0.8
TALL_M, OFF_FRAME_M = 1.2, 0.15
#: A leaf sweeps its width, and its handle so much more; each of two leaves, half the doorway.
HANDLE_M = 0.08
#: A twentieth of the floor before a piece may lie beyond the room's outline (a corner cut off), and
#: shapes that share less than 10 cm² only touch.
FRONT_OUTSIDE = 0.05
TOUCH_M2 = 1e-3
#: What hangs keeps off windows by so much.
CURTAIN_M = 0.32
#: No piece of furniture stands where less than this is left of a wall.
LEAST_STRETCH_M = 0.15
#: A piece in the middle of a room leaves so much to others: one squeezes past sideways.
AROUND_M = 0.3

#: After so many tries that failed a room is furnished modestly.
MODEST_FROM = 2


@dataclass(frozen=True)
class RoomTry:
    """One try at a room as it stands: what is placed, and the floor that is kept clear for whom.

    A value: a piece more makes a new one, so that a row of which one unit finds no place leaves
    nothing behind.

    ``inside`` is the outline with a few millimetres to spare; ``prints`` are the floor's occupants.
    No furniture stands before ``sights`` nor on ``doors`` (``thresholds``: door by door), nothing
    tall at their ``frames``; leaves swing over ``swings``, where no rug lies either; ``mouths``
    are all openings, as pieces crowd them. ``number`` counts the tries before it.
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
    thresholds: tuple[BaseGeometry, ...]
    frames: tuple[BaseGeometry, ...]
    doors: BaseGeometry
    swings: BaseGeometry
    inside: Polygon
    mouths: Mouths
    prints: Mapping[int, Polygon] = field(default_factory=dict)
    placed: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    keep: tuple[tuple[int, Polygon], ...] = ()
    number: int = 0

    @property
    def modest(self) -> bool:
        """True when the room did not come out as one would wish: what it needs comes first then,
        the smallest there is, at the ends of walls."""
        return self.number >= MODEST_FROM

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
    ) -> RoomTry:
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


def empty_room(
    home: Home,
    room: Room,
    layout: Layout,
    catalog: Catalog,
    models: Models,
    rng: Rng,
    number: int = 0,
) -> RoomTry:
    """A room with nothing in it yet, what its doors and windows keep clear noted; the how manieth
    try it is."""
    mine = tuple(o for o in home.openings if room.id in o.room_ids)
    doors: list[BaseGeometry] = []
    frames: list[BaseGeometry] = []
    swings: list[BaseGeometry] = []
    for opening in mine:
        if opening.kind == "window":
            continue
        deep = DOOR_CLEAR_M
        leaves = LEAVES.get(opening.kind, 0)
        if leaves and opening.room_ids[0] == room.id:
            swept_m = opening.width_m / leaves + HANDLE_M
            deep = max(deep, swept_m)
            swings.append(opening_rectangle(opening, swept_m))
        doors.append(opening_rectangle(opening, deep))
        wide_m = opening.width_m + 2 * OFF_FRAME_M
        wider = opening.model_copy(update={"width_m": wide_m})
        frames.append(opening_rectangle(wider, deep))
    outline = Polygon(room.polygon_m)
    inside = outline.buffer(IN_WALL_M, join_style="mitre")
    prepare(inside)
    return RoomTry(
        room=room,
        layout=layout,
        catalog=catalog,
        models=models,
        rng=rng,
        outline=outline,
        sides=sides_of(room.polygon_m),
        openings=mine,
        sights=tuple(map(sight_of, mine)),
        thresholds=tuple(doors),
        frames=tuple(frames),
        doors=union(doors),
        swings=union(swings),
        inside=inside,
        mouths=mouths_of(room, mine, layout),
        number=number,
    )


def free_sides(
    tried: RoomTry, low_m: float, high_m: float, deep_m: float, off_doors_m: float = 0.0
) -> tuple[Side, ...]:
    """The stretches of the walls with nothing before them, for a piece so deep that reaches from
    ``low_m`` to ``high_m`` and keeps ``off_doors_m`` off doorways."""
    taken = taken_outlines(tried, low_m, high_m)
    if off_doors_m:
        wider = (d.buffer(off_doors_m, join_style="mitre") for d in tried.thresholds)
        taken += [shapely.get_coordinates(door) for door in wider]
    return tuple(part for side in tried.sides for part in free_parts(side, taken, deep_m))


def taken_outlines(tried: RoomTry, low_m: float, high_m: float) -> list[Array]:
    """Corners (N, 2) of what keeps pieces between two heights away: doorways, windows that they
    would hide, other pieces."""
    doors = tried.frames if high_m > TALL_M else tried.thresholds
    taken = [shapely.get_coordinates(shape) for shape in doors if low_m < OVERHEAD_M]
    # Curtains hang beside windows, where pictures would.
    beside = CURTAIN_M if low_m > FLAT_M else 0.0
    taken += [
        shapely.get_coordinates(sight.before.buffer(beside, join_style="mitre"))
        for sight in tried.sights
        if high_m > sight.low_m and low_m < sight.high_m
    ]
    for ids in tried.placed.values():
        for k in ids:
            item, info = tried.layout.items[k], tried.layout.info(k)
            x, y, z = item.pose.position_m
            if info.extents_m[2] > FLAT_M and z < high_m and z + info.extents_m[2] > low_m:
                taken.append(np.array(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw))))
    return taken


def free_parts(side: Side, taken: Sequence[Array], deep_m: float) -> Iterator[Side]:
    """The stretches of a side that no outline within ``deep_m`` of it takes."""
    spans: list[tuple[float, float]] = []
    if taken:
        # All corners in one go: rooms ask this of every side for every piece.
        x, y = np.concatenate(taken).T
        starts = np.cumsum([0, *map(len, taken[:-1])])
        dx, dy = x - side.start[0], y - side.start[1]
        away = dx * side.inward[0] + dy * side.inward[1]
        along = dx * side.along[0] + dy * side.along[1]
        before = np.minimum.reduceat(away, starts) < deep_m
        before &= np.maximum.reduceat(away, starts) > 0.0
        ends = (end.reduceat(along, starts)[before] for end in (np.minimum, np.maximum))
        spans = list(zip(*(end.tolist() for end in ends), strict=True))
    reached = 0.0
    for low, high in [*sorted(spans), (side.length_m, side.length_m)]:
        free_m = min(low, side.length_m) - reached
        if free_m > LEAST_STRETCH_M:
            yield replace(side, start=side.at(reached, 0.0), length_m=free_m)
        reached = max(reached, high)


def taken_floor(tried: RoomTry) -> BaseGeometry:
    """What a piece in the middle keeps off: doors, the floor before other pieces, and room to pass
    round what stands there."""
    fronts = (front for _, front in tried.keep)
    around = (shape.buffer(AROUND_M) for shape in tried.prints.values())
    return unary_union([tried.doors, *fronts, *around])


def with_placed(
    rule: FurnitureRule, asset: AssetInfo, pose: PlacedAt, target: int | None, tried: RoomTry
) -> RoomTry | None:
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
        if z + asset.extents_m[2] > TALL_M and any(map(shape.intersects, tried.frames)):
            return None
        for owner, kept in tried.keep:
            if owner == target or not kept.intersects(shape):
                continue
            if kept.intersection(shape).area > TOUCH_M2:
                return None
    front = front_of(asset, pose, rule.front_m) if keeps_front else None
    sight = _sight(rule, asset, pose, target, tried)
    if not _front_free(front, tried) or not _front_free(sight, tried):
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
    more = tried.with_piece(item, layout, shape if on_floor else None, front)
    if target is None or sight is None:
        return more
    # A table before the sofa is the sofa's own: all others keep out.
    return replace(more, keep=(*more.keep, (target, sight)))


def _sight(
    rule: FurnitureRule, asset: AssetInfo, pose: PlacedAt, target: int | None, tried: RoomTry
) -> Polygon | None:
    """What lies between a piece and the one it stands opposite to."""
    if rule.where != "opposite" or target is None:
        return None
    other = tried.layout.items[target]
    at = (*other.pose.position_m, yaw_of(other.pose.quat_xyzw))
    return between(asset, pose, tried.layout.info(target), at)


def _front_free(front: Polygon | None, tried: RoomTry) -> bool:
    if front is None:
        return True
    if front.difference(tried.inside).area > FRONT_OUTSIDE * front.area:
        return False
    return all(
        not front.intersects(shape) or front.intersection(shape).area <= TOUCH_M2
        for shape in tried.prints.values()
    )
