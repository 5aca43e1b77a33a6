"""Whether a place on the floor is in the room it is said to be in."""

from __future__ import annotations

from shapely.geometry import Point, Polygon

from sdgen.facts import room_at
from sdgen.scene import Home

#: In the middle of a doorway rounding decides which room is nearer.
ROOM_TIE_M = 0.002


def not_in_room(home: Home, room_id: int, x: float, y: float) -> str | None:
    """What is wrong with ``room_id`` for what stands at (x, y), metres; None when nothing is."""
    nearest = room_at(home.rooms, x, y)
    if nearest is None:
        return "stands outdoors"
    apart = {room.id: Polygon(room.polygon_m).distance(Point(x, y)) for room in home.rooms}
    if room_id in apart and apart[room_id] <= apart[nearest.id] + ROOM_TIE_M:
        return None
    return f"room_id: {room_id} stored, {nearest.id} derived"
