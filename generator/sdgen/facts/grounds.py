"""The floor plan of what catches things, and where beside it a drop begins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.facts.body import Body
from sdgen.facts.rooms import Rooms


@dataclass(frozen=True)
class Ground:
    """Of a ``room`` the part where a thing would fall deep."""

    room: BaseGeometry
    drop: BaseGeometry

    @cached_property
    def firm(self) -> BaseGeometry:
        """The rest of it."""
        return self.room.difference(self.drop)


#: What catches: an object's id, and which of its surfaces (-1: its outline, open parts left out).
Catcher = tuple[int, int]
OUTLINE = -1


class Grounds:
    """Grounds of a scene, each computed once: things on one worktop share theirs."""

    def __init__(
        self, bodies: Mapping[int, Body], rooms: Rooms, known: Grounds | None = None
    ) -> None:
        """``known`` are those of another scene of the same home."""
        self._bodies = bodies
        self._rooms = rooms
        self._known = known
        self._bare: dict[tuple[int, Sequence[Catcher]], BaseGeometry] = {}
        self._found: dict[tuple[int, Sequence[Catcher], float], Ground] = {}

    def of(self, room_id: int, catchers: tuple[Catcher, ...], gap_m: float) -> Ground:
        """The ground of a room with these catchers. Gaps up to ``gap_m`` wide, between two of them
        or one and a wall, are closed."""
        known = self._known
        if known and all(known._bodies.get(k) is self._bodies[k] for k, _ in catchers):
            return known.of(room_id, catchers, gap_m)
        key = (room_id, catchers, gap_m)
        if key not in self._found:
            self._found[key] = self._ground(room_id, catchers, gap_m)
        return self._found[key]

    def _ground(self, room_id: int, catchers: tuple[Catcher, ...], gap_m: float) -> Ground:
        room, bare = self._rooms.outline(room_id), self._uncovered(room_id, catchers)
        # What is narrower than the gap goes when the rest is drawn in by half of it and let out
        # again; with mitred corners all else stays as it is.
        half = gap_m / 2
        wide = bare.buffer(-half, join_style="mitre").buffer(half, join_style="mitre")
        drop = wide.intersection(bare)
        shapely.prepare(drop)
        return Ground(room, drop)

    def _uncovered(self, room_id: int, catchers: tuple[Catcher, ...]) -> BaseGeometry:
        key = (room_id, catchers)
        if key not in self._bare:
            shapes = [self._shape(*catcher) for catcher in catchers]
            self._bare[key] = self._rooms.outline(room_id).difference(shapely.union_all(shapes))
        return self._bare[key]

    def _shape(self, object_id: int, surface: int) -> BaseGeometry:
        body = self._bodies[object_id]
        return body.trunk if surface == OUTLINE else body.surfaces[surface].outline
