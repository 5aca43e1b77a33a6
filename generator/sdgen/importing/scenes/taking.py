"""What readers of named trees share: a tree's things, openings and floors as pieces of a scene."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Catalog
from sdgen.geometry import Array, lowest_highest, quat_from_matrix, vec3
from sdgen.home.notes import HomeNote, ThingNote
from sdgen.importing.scenes.found import FoundFloor, FoundScene, box_piece, check_reach
from sdgen.importing.scenes.naming import Namer, opening_of, room_in, room_type_of
from sdgen.importing.scenes.openings import opening_from
from sdgen.vocabulary import OPENINGS

#: Floors of one name within this of each other, metres, are one: several boxes, tiles.
_SAME_LEVEL_M = 0.05


@dataclass
class Taker:
    """Fills a scene. ``above``, wherever it is asked for, are the names of the groups that a piece
    is in, the nearest first."""

    catalog: Catalog
    namer: Namer
    scene: FoundScene
    _rooms: dict[str, str] = field(default_factory=dict)

    def home(self, note: HomeNote) -> None:
        """What our own export says of the home."""
        self.scene.title, self.scene.style = note.title, note.style
        self.scene.height_m, self.scene.drawn = note.height_m, True
        self._rooms = note.rooms

    def thing(
        self,
        name: str,
        scene_from_thing: Array,
        corners: Array,
        above: Sequence[str],
        note: ThingNote | None = None,
        hints: Sequence[str] = (),
        loose: bool | None = None,
        group: bool = False,
    ) -> bool:
        """Take what has these corners (N, 3), in its own frame, as an opening or a thing.

        ``hints`` are other names for it. False for a ``group`` whose names say nothing: what is in
        it is to be looked at.
        """
        try:
            piece = box_piece(name, scene_from_thing, *lowest_highest(corners))
        except ValueError as error:
            self.scene.unresolved.append(f"{name}: {error}")
            return True
        piece = replace(piece, names=tuple(hints), room=self._room_of(above), loose=loose)
        kind = opening_of(name)
        if note is not None:
            piece = replace(
                piece,
                position_m=vec3(scene_from_thing[:3, 3]),
                quat_xyzw=quat_from_matrix(scene_from_thing[:3, :3]),
                note=note,
                front=True,
                room=note.room,
                loose=not note.fixed,
            )
            kind = next((one for one in OPENINGS if one == note.category), None)
        if kind is not None:
            self.scene.openings.append(opening_from(piece, kind))
        elif note is None and group and self.namer(piece).category is None:
            return False
        else:
            self.scene.pieces.append(piece)
        return True

    def sound(self, name: str, points: Array) -> bool:
        """True for a part of the building that lies where a home may be; else it is told."""
        try:
            check_reach(points)
        except ValueError as error:
            self.scene.unresolved.append(f"{name}: {error}")
            return False
        return True

    def floor(self, name: str, shape: BaseGeometry, level_m: float, above: Sequence[str]) -> None:
        """Take a floor, seen from above; the room's name is its own, or its group's."""
        called = room_in(name)
        if called is None:
            called = name if room_type_of(name, self.catalog) else self._room_of(above)
        room_type = self._rooms.get(called or "") or room_type_of(called or name, self.catalog)
        floor = FoundFloor(called or name, shape, room_type, level_m)
        for k, other in enumerate(self.scene.floors):
            if other.name == floor.name and abs(other.level_m - level_m) < _SAME_LEVEL_M:
                self.scene.floors[k] = replace(other, shape=other.shape.union(shape))
                return
        self.scene.floors.append(floor)

    def ceiling(self, low_m: float) -> None:
        """Take a ceiling, which tells how high rooms are, where nothing did."""
        if self.scene.height_m is None:
            self.scene.height_m = low_m

    def done(self) -> FoundScene:
        """The scene, its floors in the order of the home's note, where there is one."""
        order = {name: k for k, name in enumerate(self._rooms)}
        self.scene.floors.sort(key=lambda floor: order.get(floor.name, len(order)))
        return self.scene

    def _room_of(self, above: Sequence[str]) -> str | None:
        """The room that a group's name means."""
        return next((name for name in above if room_type_of(name, self.catalog)), None)
