"""Regions with a meaning, derived from the home and its furniture alone.

A doorway's zone reaches 0.6 m into each room; walkways are where people walk
(:mod:`sdgen.walkways`); heat and water lie over stoves and around basins.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
import shapely
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.facts import Body, with_footprints
from sdgen.freespace import (
    ROBOT_RADIUS_M,
    free_shape,
    opening_rectangle,
    polygons,
    union,
    without_holes,
)
from sdgen.geometry import Vec2, apply
from sdgen.scene import Home, Opening, Room, Zone
from sdgen.vocabulary import (
    CHILD_REACH_M,
    DOORS,
    FLAT_M,
    HALF_WALL_M,
    LEAVES,
    OPENINGS,
    OVERHEAD_M,
    ZoneKind,
)
from sdgen.walkways import GOT_AT, OPEN_FLOOR_M, USED_FROM_M, front, narrow, used, walked

#: How far a doorway's zone reaches into each room: a stride, and most of a leaf's sweep.
DOORWAY_DEPTH_M = 0.6
#: What lies higher than a knee is no longer in a walker's way on the floor.
FLOOR_ZONE_TOP_M = 0.5
#: How high above a hob its heat is dangerous; hoods hang at 0.65 m for that reason.
HEAT_ABOVE_M = 0.5
#: And so far below its top: handles and rims of pans hang there.
HEAT_BELOW_M = 0.1
#: How high above a basin water splashes, about: what stands on its rim is wet.
WATER_ABOVE_M = 0.3
#: A door's leaf, to just below its frame.
SWING_TOP_M = 2.0
#: Where a walker stands who has just come through a doorway: walkways begin there, clear of the
#: wall (half of it, and a robot's radius, with room to turn).
INSIDE_DOOR_M = 0.45
#: A small child's arm, from the shoulder: how far beyond where it stands it takes things.
CHILD_ARM_M = 0.5
#: Width of a door's frame beside its leaf.
FRAME_M = 0.05
#: Overlap with a doorway or a door's sweep that counts as standing in it, square metres.
TOUCH_M2 = 1e-3


def floor_obstacles(bodies: Iterable[Body]) -> list[BaseGeometry]:
    """Footprints of what stands in a walker's way; doors and windows sit in walls and do not."""
    return [body.footprint for body in _standing(bodies)]


def _standing(bodies: Iterable[Body]) -> Sequence[Body]:
    """What a walker cannot step over or pass under; no doors and windows."""
    solid = (body for body in bodies if body.item.category not in OPENINGS)
    return with_footprints([b for b in solid if b.low[2] < OVERHEAD_M and b.high[2] > FLAT_M])


def swing_sectors(bodies: Iterable[Body]) -> list[BaseGeometry]:
    """The floor each hinged door of the home sweeps, from shut to a right angle."""
    out: list[BaseGeometry] = []
    for body in bodies:
        item, info = body.item, body.info
        if item.category not in DOORS:
            continue
        for joint in info.joints:
            hinge_y = joint.origin_m[1]
            # To the frame across from its hinge; the leaves of a double door meet in the middle.
            across_m = 0.0 if len(info.joints) > 1 else info.extents_m[1] / 2 - FRAME_M
            leaf_m = abs(hinge_y) + across_m
            shut = math.copysign(math.pi / 2, -hinge_y)
            turn = math.copysign(math.pi / 2, joint.axis[2])
            angles = shut + turn * np.linspace(0.0, 1.0, 13)
            x, y = joint.origin_m[0], hinge_y
            points = [(x, y, 0.0)]
            points += [(x + leaf_m * math.cos(a), y + leaf_m * math.sin(a), 0.0) for a in angles]
            world = apply(body.world_from_object, points)
            out.append(Polygon(world[:, :2]).buffer(0))
    return out


def swing_blocked(bodies: Collection[Body]) -> tuple[int, ...]:
    """Ids of things that stand where a door of the home must swing, sorted."""
    return _standing_in(unary_union(swing_sectors(bodies)), bodies)


def doorway_blocked(home: Home, bodies: Iterable[Body]) -> tuple[int, ...]:
    """Ids of things that stand in a doorway or so close to it that they are in its zone, sorted."""
    depth = HALF_WALL_M + DOORWAY_DEPTH_M
    doorways = [opening_rectangle(o, depth) for o in home.openings if o.kind in DOORS]
    return _standing_in(unary_union(doorways), bodies)


def _standing_in(shape: BaseGeometry, bodies: Iterable[Body]) -> tuple[int, ...]:
    shapely.prepare(shape)
    return tuple(
        sorted(
            body.item.id
            for body in _standing(bodies)
            if shape.intersects(body.footprint)
            and shape.intersection(body.footprint).area > TOUCH_M2
        )
    )


def narrow_floor(
    home: Home, furniture: Sequence[Body], properties: Mapping[str, Collection[str]]
) -> BaseGeometry:
    """Floor of all rooms that is used, on a way or not: see :func:`~sdgen.walkways.narrow`."""
    found = []
    for room in home.rooms:
        here = [body for body in furniture if body.item.room_id == room.id]
        about = [b for b in here if not GOT_AT.isdisjoint(properties.get(b.item.category, ()))]
        before = [front(body) for body in used(here, properties)]
        outline = Polygon(room.polygon_m)
        found.append(narrow(outline, floor_obstacles(here), floor_obstacles(about), before))
    by_front_door = [
        opening_rectangle(opening, HALF_WALL_M).buffer(USED_FROM_M)
        for opening in home.openings
        if opening.kind == "front_door"
    ]
    return union([*found, *by_front_door])


def derive_zones(
    home: Home,
    furniture: Sequence[Body],
    free: BaseGeometry,
    properties: Mapping[str, Collection[str]],
) -> tuple[Zone, ...]:
    """All zones of a furnished home with the floor that is free in it, sorted by name.

    ``properties`` maps category to catalogue properties: HEAT_SOURCE and WATER_SOURCE make zones.
    """
    zones: list[Zone] = []
    rooms = {room.id: room for room in home.rooms}
    for opening in home.openings:
        if opening.kind == "window":
            continue
        for room_id in opening.room_ids:
            room = rooms[room_id]
            shape = opening_rectangle(opening, HALF_WALL_M + DOORWAY_DEPTH_M).intersection(
                Polygon(room.polygon_m).buffer(HALF_WALL_M, join_style="mitre")
            )
            zones += _zones(
                "doorway", polygons(shape), room, 0.0, FLOOR_ZONE_TOP_M, opening.object_id
            )
        leaves = LEAVES.get(opening.kind, 0)
        if leaves == 0:
            continue
        first = rooms[opening.room_ids[0]]
        leaf_m = opening.width_m / leaves
        swing = opening_rectangle(opening, HALF_WALL_M + leaf_m).intersection(
            Polygon(first.polygon_m)
        )
        zones += _zones("swing", polygons(swing), first, 0.0, SWING_TOP_M, opening.object_id)
    obstacles = floor_obstacles(furniture)
    standing, open_floor = union(obstacles), free_shape(home, obstacles, OPEN_FLOOR_M)
    people_use = used(furniture, properties)
    for room in home.rooms:
        outline = Polygon(room.polygon_m)
        doors = [o for o in home.openings if o.kind != "window" and room.id in o.room_ids]
        ends = [doorway_point(opening, room) for opening in doors]
        here = [body for body in people_use if body.item.room_id == room.id]
        walkways = walked(outline, ends, here, properties, free, standing, open_floor)
        zones += _zones("walkway", without_holes(walkways), room, 0.0, FLOOR_ZONE_TOP_M, None)
        reach = free.intersection(outline).buffer(CHILD_ARM_M + ROBOT_RADIUS_M)
        shape = _filled(reach.intersection(outline))
        zones += _zones("child_reach", polygons(shape), room, 0.0, CHILD_REACH_M, None)
    for body in furniture:
        item = body.item
        traits = properties.get(item.category, ())
        if "HEAT_SOURCE" not in traits and "WATER_SOURCE" not in traits:
            continue
        room = rooms[item.room_id]
        top = round(float(body.high[2]), 3)
        if "HEAT_SOURCE" in traits:
            zones += _zones(
                "heat",
                polygons(body.footprint),
                room,
                top - HEAT_BELOW_M,
                top + HEAT_ABOVE_M,
                item.id,
            )
        if "WATER_SOURCE" in traits:
            zones += _zones(
                "water", polygons(body.footprint), room, 0.0, top + WATER_ABOVE_M, item.id
            )
    return tuple(sorted(zones, key=lambda z: z.name))


def doorway_point(opening: Opening, room: Room, inside_m: float = INSIDE_DOOR_M) -> Vec2:
    """A point on the floor just inside a doorway."""
    x, y, _ = opening.center_m
    middle = Polygon(room.polygon_m).representative_point()
    candidates = (
        [(x, y + inside_m), (x, y - inside_m)]
        if opening.along == "x"
        else [(x + inside_m, y), (x - inside_m, y)]
    )
    outline = Polygon(room.polygon_m)
    return min(
        candidates,
        key=lambda p: (not outline.contains(Point(p)), Point(p).distance(middle)),
    )


def _filled(shape: BaseGeometry) -> BaseGeometry:
    return shapely.union_all([Polygon(p.exterior) for p in polygons(shape)])


def _zones(
    kind: ZoneKind,
    shapes: Sequence[Polygon],
    room: Room,
    low: float,
    high: float,
    source: int | None,
) -> list[Zone]:
    out = []
    for index, polygon in enumerate(shapes):
        simple = shapely.normalize(polygon.simplify(0.01))
        points = np.round(np.array(simple.exterior.coords)[:-1], 3) + 0.0
        name = f"{kind}:{room.name}:{source or 0}:{index}"
        out.append(
            Zone.model_validate(
                {
                    "name": name,
                    "kind": kind,
                    "polygon_m": tuple((float(x), float(y)) for x, y in points),
                    "z_min_m": round(low, 3),
                    "z_max_m": round(high, 3),
                    "room_id": room.id,
                    "source_id": source,
                }
            )
        )
    return out
