"""What a home holds, room by room, in numbers."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from shapely.geometry import Polygon

from sdgen.scene import Scene
from sdgen.vocabulary import OPENINGS


@dataclass(frozen=True)
class RoomSummary:
    """A room: its floor in m2, what is fixed and what is loose in it by category, and its nodes
    of the scene graph: itself, floor, walls and ceiling, and all objects."""

    name: str
    type: str
    area_m2: float
    nodes: int
    furniture: Counter[str]
    things: Counter[str]


def summary_of(scene: Scene) -> tuple[RoomSummary, ...]:
    """The rooms of a scene by name; doors and windows count where they are hung, as nodes only."""
    out = []
    for room in sorted(scene.home.rooms, key=lambda one: one.name):
        inside = [item for item in scene.objects if item.room_id == room.id]
        shell = [one for one in scene.home.structures if one.room_id == room.id]
        there = [item for item in inside if item.category not in OPENINGS]
        out.append(
            RoomSummary(
                name=room.name,
                type=room.type,
                area_m2=float(Polygon(room.polygon_m).area),
                nodes=1 + len(shell) + len(inside),
                furniture=Counter(item.category for item in there if item.fixed),
                things=Counter(item.category for item in there if not item.fixed),
            )
        )
    return tuple(out)
