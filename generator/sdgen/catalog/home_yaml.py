"""A file of ``homes/`` as people write it, and the checks a drawing can fail."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from pydantic import model_validator
from pydantic_core import InitErrorDetails

from sdgen.catalog.entry import as_record
from sdgen.catalog.records import HomeSpec, OpeningSpec, RoomSpec
from sdgen.catalog.words import Text, Word, between
from sdgen.scene import Record
from sdgen.strict import problem, refuse

Rect = tuple[float, float, float, float]
#: Far below a millimetre: what two drawn numbers that mean the same may differ by.
_EPS = 1e-6


class HomeYaml(Record):
    """The whole file."""

    id: Word
    title: Text
    # Lower than any code allows to live in; higher than any storey.
    height_m: Annotated[float, between(2.0, 6.0)] = 2.6
    rooms: tuple[RoomSpec, ...]
    openings: tuple[OpeningSpec, ...]
    replaces: bool = False

    @model_validator(mode="after")
    def _check(self) -> HomeYaml:
        found = [*self._room_problems(), *self._opening_problems()]
        if found:
            refuse(*found)
        return self

    def record(self) -> HomeSpec:
        """The record of it."""
        return as_record(self, HomeSpec)

    def _room_problems(self) -> Iterator[InitErrorDetails]:
        """Rooms lie apart, furniture in its room."""
        names = [room.name for room in self.rooms]
        for index, room in enumerate(self.rooms):
            if room.name in names[:index]:
                yield problem(("rooms", index, "name"), f"a second room named {room.name!r}")
            for other in self.rooms[:index]:
                if any(_overlap(a, b) for a in room.rectangles_m for b in other.rectangles_m):
                    text = f"overlaps room {other.name!r}"
                    yield problem(("rooms", index, "rectangles_m"), text)
            for k, item in enumerate(room.furniture):
                path = ("rooms", index, "furniture", k)
                if not any(_holds(rect, item.position_m) for rect in room.rectangles_m):
                    text = f"{item.category} stands outside room {room.name!r}"
                    yield problem((*path, "position_m"), text)
                if item.on is not None and item.on not in [i.category for i in room.furniture[:k]]:
                    text = f"no {item.on} is placed before it in this room"
                    yield problem((*path, "on"), text)

    def _opening_problems(self) -> Iterator[InitErrorDetails]:
        """Openings lie on walls; there is one front door."""
        for index, opening in enumerate(self.openings):
            beside = [room.name for room in self.rooms if _on_edge(room, opening)]
            wanted = {"door": (1, 2), "front_door": (1,), "window": (1,)}[opening.kind]
            if len(beside) not in wanted:
                where = f"has {len(beside)} rooms beside it ({', '.join(beside) or 'none'})"
                hint = "center_m must lie on a wall that runs along the axis 'along'"
                text = f"this {opening.kind} {where}; {hint}"
                yield problem(("openings", index, "center_m"), text)
        if sum(opening.kind == "front_door" for opening in self.openings) != 1:
            yield problem(("openings",), "a home has exactly one front_door")


def _overlap(a: Rect, b: Rect) -> bool:
    return min(a[2], b[2]) - max(a[0], b[0]) > _EPS and min(a[3], b[3]) - max(a[1], b[1]) > _EPS


def _holds(rect: Rect, point: tuple[float, float, float]) -> bool:
    return rect[0] <= point[0] <= rect[2] and rect[1] <= point[1] <= rect[3]


def _on_edge(room: RoomSpec, opening: OpeningSpec) -> bool:
    """True when the opening's centre lies on an edge of the room along its axis."""
    x, y = opening.center_m
    for x0, y0, x1, y1 in room.rectangles_m:
        if opening.along == "x" and x0 < x < x1 and min(abs(y - y0), abs(y - y1)) < _EPS:
            return True
        if opening.along == "y" and y0 < y < y1 and min(abs(x - x0), abs(x - x1)) < _EPS:
            return True
    return False
