"""A file of ``homes/`` as people write it, and the checks a drawing can fail."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated

from pydantic import model_validator
from pydantic_core import InitErrorDetails

from sdgen import strict
from sdgen.catalog.entry import Entry, as_record
from sdgen.catalog.home_shape import (
    SAME_M,
    OutlineError,
    Ring,
    frame_size,
    inner_ring,
    rooms_beside,
)
from sdgen.catalog.records import HomeSpec, OpeningSpec, RoomSpec
from sdgen.catalog.words import Names, StyleName, Text, Word, between
from sdgen.scene import Record
from sdgen.strict import problem, refuse
from sdgen.vocabulary import DOORS, HALF_WALL_M
from sdgen.yaml_source import Source

Rect = tuple[float, float, float, float]
#: Far below a millimetre: what two drawn numbers that mean the same may differ by.
_EPS = 1e-6


class HomeYaml(Record):
    """The whole file."""

    id: Word
    title: Text
    # Lower than any code allows to live in; higher than any storey.
    height_m: Annotated[float, between(2.0, 6.0)] = 2.6
    style: StyleName | None = None
    rooms: tuple[RoomSpec, ...]
    openings: tuple[OpeningSpec, ...]
    # Nothing is hung or put there but what is drawn: no fittings, everyday things or near misses.
    as_drawn: bool = False
    replaces: bool = False

    @model_validator(mode="after")
    def _check(self) -> HomeYaml:
        found = list(self._room_problems())
        rings = []
        for index, room in enumerate(self.rooms):
            try:
                rings.append(inner_ring(room))
            except OutlineError as error:
                found.append(problem(("rooms", index, "rectangles_m"), str(error)))
        if len(rings) == len(self.rooms):
            found += self._opening_problems(rings)
        if found:
            refuse(*found)
        return self

    def record(self) -> HomeSpec:
        """The record of it."""
        return as_record(self, HomeSpec)

    def _room_problems(self) -> Iterator[InitErrorDetails]:
        """Rooms lie apart, furniture and things in their rooms."""
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
            for k, thing in enumerate(room.things):
                if not any(_holds(rect, thing.position_m) for rect in room.rectangles_m):
                    text = f"{thing.category} lies outside room {room.name!r}"
                    yield problem(("rooms", index, "things", k, "position_m"), text)

    def _opening_problems(self, rings: Sequence[Ring]) -> Iterator[InitErrorDetails]:
        """Openings lie in walls, whole and apart; the front door leads to every room."""
        sound = True
        for index, opening in enumerate(self.openings):
            for step, text in self._problems_of(index, opening, rings):
                sound = False
                yield problem(("openings", index, step), text)
        if sum(opening.kind == "front_door" for opening in self.openings) != 1:
            yield problem(("openings",), "a home has exactly one front_door")
        elif sound:
            reached = self._reached(rings)
            for index, room in enumerate(self.rooms):
                if index not in reached:
                    text = f"no doors lead from the front_door to room {room.name!r}"
                    yield problem(("rooms", index), text)

    def _problems_of(
        self, index: int, opening: OpeningSpec, rings: Sequence[Ring]
    ) -> Iterator[tuple[str, str]]:
        """What is wrong with one opening, and with which of its keys."""
        width, height = frame_size(opening)
        beside = rooms_beside(rings, opening)
        names = ", ".join(self.rooms[k].name for k in beside) or "none"
        wanted = (1,) if opening.kind in ("front_door", "window") else (1, 2)
        if len(beside) not in wanted:
            where = f"has {len(beside)} rooms beside it ({names})"
            hint = "center_m must lie on a wall that runs along the axis 'along'"
            yield "center_m", f"this {opening.kind} {where}; {hint}"
            return
        for k, share in beside.items():
            if share < width - SAME_M:
                where = f"only {share:.2f} m of it lie in the wall of room {self.rooms[k].name!r}"
                yield "center_m", f"this {opening.kind} is {width:g} m wide, and {where}"
        for k, other in enumerate(self.openings[:index]):
            if _overlap(_span(opening), _span(other)):
                yield "center_m", f"this {opening.kind} overlaps openings[{k}], a {other.kind}"
        top = opening.sill_m + height
        if top > self.height_m:
            text = f"this {opening.kind} ends {top:g} m up, and the rooms at {self.height_m:g} m"
            yield "sill_m" if opening.sill_m else "kind", text

    def _reached(self, rings: Sequence[Ring]) -> set[int]:
        """The rooms one gets to from the front door."""
        doors = [o for o in self.openings if o.kind in DOORS]
        joined = [set(rooms_beside(rings, door)) for door in doors]
        reached = {
            k
            for door, rooms in zip(doors, joined, strict=True)
            for k in rooms
            if door.kind == "front_door"
        }
        while more := {k for rooms in joined if rooms & reached for k in rooms} - reached:
            reached |= more
        return reached


def read_home(entry: Entry, names: Names) -> HomeYaml | None:
    """A home as it was written; None when problems were noted.

    What is drawn wrong is told beside unknown names, not only once they are put right.
    """
    home = entry.read(HomeYaml, names)
    if home is None:
        source = entry.source
        nameless = Source(source.file, source.value, source.lines)
        strict.read(nameless, entry.path, entry.value, HomeYaml)
        source.noted += [told for told in nameless.noted if told not in source.noted]
    return home


def _overlap(a: Rect, b: Rect) -> bool:
    return min(a[2], b[2]) - max(a[0], b[0]) > _EPS and min(a[3], b[3]) - max(a[1], b[1]) > _EPS


def _holds(rect: Rect, point: tuple[float, float, float]) -> bool:
    return rect[0] <= point[0] <= rect[2] and rect[1] <= point[1] <= rect[3]


def _span(opening: OpeningSpec) -> Rect:
    """What an opening takes of its wall, seen from above."""
    (x, y), half, thick = opening.center_m, frame_size(opening)[0] / 2, HALF_WALL_M
    if opening.along == "x":
        return x - half, y - thick, x + half, y + thick
    return x - thick, y - half, x + thick, y + half
