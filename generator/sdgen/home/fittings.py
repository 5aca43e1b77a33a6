"""What belongs to the building: curtains at windows, radiators below, switches by doors, sockets.

Hung when the furniture stands, where it leaves room: a window behind a bookcase has no curtain.
"""

from __future__ import annotations

from collections.abc import Iterator

from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.actions import at_rest
from sdgen.catalog.records import Catalog, Fitting
from sdgen.facts import bodies_of
from sdgen.freespace import ROBOT_RADIUS_M, free_shape, union, unreachable_rooms
from sdgen.geometry import quat_from_yaw, round_position, round_quat
from sdgen.home.anchors import HUNG_GAP_M, PlacedAt, Side, against_walls, sides_of
from sdgen.home.clearances import sight_of
from sdgen.home.context import Models
from sdgen.home.furnish import put_piece
from sdgen.home.layout import IN_WALL_M, Layout, corners_of
from sdgen.library.records import Asset
from sdgen.scene import Home, ObjectInstance, Opening, Pose, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import DOORS, HALF_WALL_M
from sdgen.zones import floor_obstacles

#: A rod hangs so far above the window, what is under it ends so far below the sill.
ABOVE_WINDOW_M = 0.07
BELOW_SILL_M = 0.04
#: Between the hole of a door and what hangs beside it: the frame, and a hand's breadth.
BESIDE_DOOR_M = 0.14
#: A wall is an opening's when its middle is in it.
SAME_WALL_M = HALF_WALL_M + 0.02


def add_fittings(home: Home, layout: Layout, catalog: Catalog, models: Models, rng: Rng) -> Layout:
    """The layout with what belongs to the building, of one model of each category a home; nothing
    that cuts a room off."""
    free = _Free(home, layout)
    for fitting in catalog.fittings:
        found = models(fitting.category)
        if not found:
            continue
        model = found[int(rng.integers(len(found)))]
        for room in home.rooms:
            if not fitting.rooms or room.type in fitting.rooms:
                layout = _in_room(fitting, model, room, home, layout, free, catalog, rng)
    return layout


class _Free:
    """The floor where a robot's middle can be, less what is hung there."""

    def __init__(self, home: Home, layout: Layout) -> None:
        self._home = home
        bodies = bodies_of(list(layout.items.values()), layout.library.infos)
        self._shape = free_shape(home, floor_obstacles(bodies))
        # A home that is cut off as it stands is rejected for that, not for a switch.
        self._cut = {room.id for room in unreachable_rooms(home, self._shape)}

    def take(self, shape: BaseGeometry) -> None:
        """Note what is left when a piece hangs."""
        self._shape = shape

    def left_by(self, item: ObjectInstance, layout: Layout) -> BaseGeometry | None:
        """What one piece more leaves; None where some room could not be got to any more."""
        grown = [
            shape.buffer(ROBOT_RADIUS_M, quad_segs=2)
            for shape in floor_obstacles(bodies_of([item], layout.library.infos))
        ]
        taken = union(grown)
        if not taken.intersects(self._shape):
            return self._shape
        after = self._shape.difference(taken)
        cut = {room.id for room in unreachable_rooms(self._home, after)}
        return after if cut <= self._cut else None


def _in_room(
    fitting: Fitting,
    model: Asset,
    room: Room,
    home: Home,
    layout: Layout,
    free: _Free,
    catalog: Catalog,
    rng: Rng,
) -> Layout:
    inside = Polygon(room.polygon_m).buffer(IN_WALL_M, join_style="mitre")
    sights = [sight_of(o) for o in home.openings if room.id in o.room_ids]
    for poses in _places(fitting, model, room, home, rng):
        if rng.random() >= fitting.chance:
            continue
        for pose in poses:
            x, y, z, yaw = pose
            shape = Polygon(corners_of(model, x, y, yaw))
            if not inside.covers(shape):
                continue
            # A curtain alone hangs before an opening.
            top = z + model.extents_m[2]
            if fitting.where != "window" and any(s.hidden_by(shape, z, top) for s in sights):
                continue
            item = ObjectInstance(
                id=next(layout.ids),
                category=model.category,
                asset=model.id,
                pose=Pose(
                    position_m=round_position((x, y, z)), quat_xyzw=round_quat(quat_from_yaw(yaw))
                ),
                room_id=room.id,
                fixed=True,
            )
            item = at_rest(item, model)
            left = free.left_by(item, layout)
            if left is not None and put_piece(item, model, layout, None, room, catalog):
                free.take(left)
                break
    return layout


def _places(
    fitting: Fitting, model: Asset, room: Room, home: Home, rng: Rng
) -> Iterator[list[PlacedAt]]:
    """For each piece that is asked for the poses it may have, first the best."""
    deep, wide, tall = model.extents_m
    sides = sides_of(room.polygon_m)
    off = deep / 2 + HUNG_GAP_M
    if fitting.where == "wall":
        for _ in range(int(rng.integers(fitting.count[0], fitting.count[1] + 1))):
            yield against_walls(sides, (deep, wide), fitting.z_m, rng, snap=0.0)
        return
    for opening in home.openings:
        if room.id not in opening.room_ids:
            continue
        found = _side_of(opening, sides)
        if found is None or (opening.kind in DOORS) != (fitting.where == "beside_door"):
            continue
        side, along = found
        low, high = opening.center_m[2], opening.center_m[2] + opening.height_m
        if fitting.where == "window":
            yield [(*side.at(along, off), high + ABOVE_WINDOW_M - tall, side.yaw)]
        elif fitting.where == "under_window":
            if fitting.z_m + tall <= low - BELOW_SILL_M:
                yield [(*side.at(along, off), fitting.z_m, side.yaw)]
        else:
            reach = opening.width_m / 2 + BESIDE_DOOR_M + wide / 2
            spots = [along - reach, along + reach]
            if rng.random() < 0.5:
                spots.reverse()
            yield [(*side.at(t, off), fitting.z_m, side.yaw) for t in spots]


def _side_of(opening: Opening, sides: tuple[Side, ...]) -> tuple[Side, float] | None:
    """The wall of a room that an opening is in, and how far along it its middle is."""
    for side in sides:
        along, away = side.measure(opening.center_m[:2])
        if abs(away) < SAME_WALL_M and 0 < along < side.length_m:
            return side, along
    return None
