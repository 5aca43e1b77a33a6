"""A furnished home in MJCF, ours or anybody's, as a found scene.

A body is a thing when our own export's text says so, or when the namer knows its name; else the
bodies in it are looked at. What is called floor, wall, door or window is the building.
"""

from __future__ import annotations

import json
import xml.etree.ElementTree as Tree
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from sdgen.catalog.records import Catalog
from sdgen.geometry import Array, apply, box_corners, lowest_highest, quat_from_matrix, vec3
from sdgen.home.notes import KEY, HomeNote, ThingNote
from sdgen.importing.scenes.found import (
    FoundFloor,
    FoundScene,
    FoundWall,
    box_piece,
    footprint,
)
from sdgen.importing.scenes.mjcf_document import MjcfDocument
from sdgen.importing.scenes.naming import (
    Namer,
    opening_of,
    room_in,
    room_type_of,
    structure_of,
)
from sdgen.importing.scenes.openings import opening_from
from sdgen.vocabulary import OPENINGS, StructureKind

#: Bodies within bodies.
_DEEPEST = 100


def read_mjcf(path: Path, catalog: Catalog, namer: Namer) -> FoundScene:
    """The scene of an MJCF file.

    Raises InputError, located, with all that is wrong: no XML, files that are missing or lie
    outside its folder, numbers that are none.
    """
    document = MjcfDocument(path)
    reading = _Reading(document, catalog, namer, FoundScene(source=str(path), title=path.stem))
    reading.notes()
    for world in document.root.findall("worldbody"):
        reading.world(world)
    document.check()
    reading.in_order()
    return reading.scene


@dataclass(frozen=True)
class _Solid:
    """A geom: its box in its own frame, where that is in the body, and what it is called."""

    name: str
    low: Array
    high: Array
    body_from_geom: Array
    visual: bool

    def corners(self, parent: Array) -> Array:
        """The corners (8, 3) of its box in the frame that ``parent`` leads to."""
        return apply(
            parent @ self.body_from_geom, box_corners(self.low.tolist(), self.high.tolist())
        )


class _Reading:
    def __init__(
        self, document: MjcfDocument, catalog: Catalog, namer: Namer, scene: FoundScene
    ) -> None:
        self._document = document
        self._catalog = catalog
        self._namer = namer
        self._said: dict[str, ThingNote] = {}
        self._rooms: dict[str, str] = {}
        self.scene = scene

    def notes(self) -> None:
        """What our own export says of the home and its things."""
        for name, data in self._document.texts():
            try:
                if name == KEY:
                    home = HomeNote.model_validate(json.loads(data))
                    self.scene.title, self.scene.style = home.title, home.style
                    self.scene.height_m, self.scene.drawn = home.height_m, True
                    self._rooms = home.rooms
                elif data.startswith("{"):
                    self._said[name] = ThingNote.model_validate(json.loads(data))
            except (ValueError, RecursionError, ValidationError):
                told = f"custom text {name[:60]!r}: not as our export writes it; left out"
                self.scene.told.append(told)

    def in_order(self) -> None:
        """Put the floors in the order of the home's note, where there is one."""
        order = {name: k for k, name in enumerate(self._rooms)}
        self.scene.floors.sort(key=lambda floor: order.get(floor.name, len(order)))

    # --- walking ---------------------------------------------------------------------------------

    def world(self, world: Tree.Element) -> None:
        """Take all that is in a ``worldbody``."""
        eye = np.eye(4)
        for element, here, childclass in self._inside(world, eye, None):
            if element.tag == "body":
                self._body(element, here, childclass, (), 0)
            elif element.tag == "geom":
                self._loose_geom(element, here, childclass)

    def _inside(
        self, parent: Tree.Element, here: Array, childclass: str | None
    ) -> Iterator[tuple[Tree.Element, Array, str | None]]:
        """What is in a body, frames opened, each with where it hangs and its class of defaults."""
        for child in parent:
            if child.tag in ("frame", "replicate"):
                if child.tag == "replicate":
                    self.scene.told.append("replicate: only the first of its copies is read")
                within = here @ self._document.parent_from(child, child.attrib)
                yield from self._inside(child, within, child.get("childclass") or childclass)
            elif child.tag == "attach":
                name = child.get("model", "")
                self.scene.unresolved.append(f"attach {name!r}: models within models are not read")
            else:
                yield child, here, childclass

    def _body(
        self,
        body: Tree.Element,
        parent: Array,
        childclass: str | None,
        above: tuple[str, ...],
        depth: int,
    ) -> None:
        if depth > _DEEPEST:
            self._document.problem(body, f"is nested more than {_DEEPEST} deep")
            return
        name = body.get("name", "")
        childclass = body.get("childclass") or childclass
        here = parent @ self._document.parent_from(body, body.attrib)
        note = self._said.get(name)
        if note is None:
            kind = structure_of(name, self._catalog) if name else None
            if kind is not None:
                for solid in self._solids(body, childclass):
                    self._structure(name, kind, solid.corners(here), above)
                return
        if self._thing(body, name, here, childclass, above, note):
            return
        for element, within, inner in self._inside(body, here, childclass):
            if element.tag == "body":
                self._body(element, within, inner, (name, *above) if name else above, depth + 1)

    def _thing(
        self,
        body: Tree.Element,
        name: str,
        here: Array,
        childclass: str | None,
        above: tuple[str, ...],
        note: ThingNote | None,
    ) -> bool:
        """Take a body as a thing, if it is one: when a note or its name says so, or when it is the
        last that could be."""
        solids = list(self._solids(body, childclass))
        seen = [solid for solid in solids if solid.visual] or solids
        if not seen:
            return False
        try:
            corners = np.concatenate([solid.corners(np.eye(4)) for solid in seen])
            piece = box_piece(name or "a body", here, *lowest_highest(corners))
        except ValueError as error:
            self.scene.unresolved.append(f"{name}: {error}")
            return True
        hints = [*above[:2], *dict.fromkeys(solid.name for solid in seen if solid.name)]
        loose = any(child.tag == "freejoint" or child.get("type") == "free" for child in body)
        piece = replace(piece, names=tuple(hints[:6]), room=self._room_of(above))
        piece = replace(piece, loose=True if loose else None)
        kind = opening_of(name) if note is None else None
        if note is not None:
            piece = replace(
                piece,
                position_m=vec3(here[:3, 3]),
                quat_xyzw=quat_from_matrix(here[:3, :3]),
                note=note,
                front=True,
                room=note.room,
                loose=not note.fixed,
            )
            kind = next((one for one in OPENINGS if one == note.category), None)
        if kind is not None:
            self.scene.openings.append(opening_from(piece, kind))
            return True
        below = any(element.tag == "body" for element, _, _ in self._inside(body, here, None))
        own = any(element.tag == "geom" for element, _, _ in self._inside(body, here, None))
        if note is None and below and not own and self._namer(piece).category is None:
            return False
        self.scene.pieces.append(piece)
        return True

    def _room_of(self, above: tuple[str, ...]) -> str | None:
        return next((name for name in above if room_type_of(name, self._catalog)), None)

    def _loose_geom(self, geom: Tree.Element, here: Array, childclass: str | None) -> None:
        """A geom of the world itself: a part of the building, or a thing that never moves."""
        name = geom.get("name", "")
        solid = self._solid(geom, self._document.given(geom, childclass), here)
        if solid is None:
            return
        kind = structure_of(name, self._catalog) if name else None
        if kind is not None:
            self._structure(name, kind, solid.corners(np.eye(4)), ())
        elif name:
            piece = box_piece(name, solid.body_from_geom, solid.low, solid.high)
            word = opening_of(name)
            if word is not None:
                self.scene.openings.append(opening_from(piece, word))
            else:
                self.scene.pieces.append(piece)

    # --- solids ----------------------------------------------------------------------------------

    def _solids(self, body: Tree.Element, childclass: str | None) -> Iterator[_Solid]:
        """The geoms of a body and of all bodies in it, in the body's frame."""
        stack = [(body, np.eye(4), childclass)]
        while stack:
            parent, here, above = stack.pop()
            for element, within, inner in self._inside(parent, here, above):
                if element.tag == "body":
                    below = within @ self._document.parent_from(element, element.attrib)
                    stack.append((element, below, element.get("childclass") or inner))
                elif element.tag == "geom":
                    given = self._document.given(element, inner)
                    solid = self._solid(element, given, within)
                    if solid is not None:
                        yield solid

    def _solid(self, geom: Tree.Element, given: Mapping[str, str], here: Array) -> _Solid | None:
        """A geom's box; None for what has none (a plane), is not seen or is noted as wrong."""
        rgba = self._document.numbers(geom, given, "rgba", None)
        if rgba is not None and len(rgba) == 4 and rgba[3] == 0:
            return None
        place = self._document.parent_from(geom, given)
        size = self._document.numbers(geom, given, "size", None) or []
        ends = self._document.numbers(geom, given, "fromto", 6)
        half = self._half(geom, given, size, ends)
        if half is None:
            return None
        low, high = half
        if ends is not None:
            a, b = np.array(ends[:3]), np.array(ends[3:])
            reach = np.full(3, size[0] if size else 0.0)
            low, high = np.minimum(a, b) - reach, np.maximum(a, b) + reach
            place = np.eye(4)
        visual = given.get("contype") == "0" and given.get("conaffinity") == "0"
        name = given.get("name") or given.get("mesh") or ""
        return _Solid(name, low, high, here @ place, visual)

    def _half(
        self,
        geom: Tree.Element,
        given: Mapping[str, str],
        size: list[float],
        ends: list[float] | None,
    ) -> tuple[Array, Array] | None:
        kind = given.get("type", "sphere")
        if "mesh" in given and kind in ("mesh", "sdf", "box", "sphere", "capsule", "cylinder"):
            return self._document.mesh(given["mesh"])
        needed = {"sphere": 1, "capsule": 1, "cylinder": 1, "box": 3, "ellipsoid": 3}.get(kind)
        if needed is None:
            return None
        if ends is None and kind in ("capsule", "cylinder"):
            needed = 2
        if len(size) < needed:
            self._document.problem(geom, f"size: a {kind} needs {needed} numbers")
            return None
        if kind == "sphere":
            reach = np.full(3, size[0])
        elif kind in ("capsule", "cylinder"):
            long = 0.0 if ends is not None else size[1] + (size[0] if kind == "capsule" else 0.0)
            reach = np.array([size[0], size[0], long])
        else:
            reach = np.array(size[:3])
        return -reach, reach

    # --- the building ----------------------------------------------------------------------------

    def _structure(
        self, name: str, kind: StructureKind, corners: Array, above: tuple[str, ...]
    ) -> None:
        low, high = lowest_highest(corners)
        if kind == "ceiling":
            if self.scene.height_m is None:
                self.scene.height_m = float(low[2])
            return
        shape = footprint(corners)
        if kind == "wall":
            self.scene.walls.append(FoundWall(name, shape, float(low[2]), float(high[2])))
            return
        called = room_in(name)
        if called is None:
            called = name if room_type_of(name, self._catalog) else self._room_of(above)
        room_type = self._rooms.get(called or "") or room_type_of(called or name, self._catalog)
        floor = FoundFloor(called or name, shape, room_type, float(high[2]))
        for k, other in enumerate(self.scene.floors):
            if other.name == floor.name and abs(other.level_m - floor.level_m) < 0.05:
                # A floor of several boxes.
                joined = other.shape.union(shape)
                self.scene.floors[k] = replace(other, shape=joined)
                return
        self.scene.floors.append(floor)
