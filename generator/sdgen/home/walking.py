"""Ways through a furnished room: for people, and for a robot."""

from __future__ import annotations

from collections.abc import Iterator

from shapely.geometry import Point, Polygon

from sdgen.facts import bodies_of
from sdgen.freespace import ROBOT_RADIUS_M, polygons, union
from sdgen.home.room_try import RoomTry
from sdgen.zones import doorway_point, floor_obstacles

#: People walk past each other's furniture where it leaves them so much.
WALK_M = 0.8
#: What a person in a room must be able to get to: this far from every doorway's middle.
NEAR_DOOR_M = 0.2
#: Floor that a robot's middle has in a room: a small bathroom has little more than a spot to turn.
SMALL_ROOM_M2, LEAST_FREE_SMALL_M2, LEAST_FREE_M2 = 8.0, 0.3, 1.0


def walkable(tried: RoomTry) -> bool:
    """True when people can walk from each doorway of the room to every other."""
    return any(_joined(tried, WALK_M / 2))


def passable(tried: RoomTry) -> bool:
    """True when a robot can get from each doorway of the room to every other and to its middle."""
    least = LEAST_FREE_M2 if tried.outline.area >= SMALL_ROOM_M2 else LEAST_FREE_SMALL_M2
    return any(part.area >= least for part in _joined(tried, ROBOT_RADIUS_M))


def _joined(tried: RoomTry, radius_m: float) -> Iterator[Polygon]:
    """The parts of the floor with all doorways of the room by them, where the middle of what is so
    wide may be."""
    ids = [k for found in tried.placed.values() for k in found]
    layout = tried.layout
    obstacles = floor_obstacles(bodies_of([layout.items[k] for k in ids], layout.library.infos))
    grown = union([o.buffer(radius_m, quad_segs=2) for o in obstacles])
    free = tried.outline.buffer(-radius_m, join_style="mitre").difference(grown)
    ends = [
        Point(doorway_point(opening, tried.room))
        for opening in tried.openings
        if opening.kind != "window"
    ]
    for part in polygons(free):
        if all(part.distance(end) <= NEAR_DOOR_M for end in ends):
            yield part
