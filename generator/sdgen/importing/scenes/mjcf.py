"""A furnished home in MJCF, ours or anybody's, as a found scene.

A body is a thing when our own export's text says so, or when the namer knows its name; else the
bodies in it are looked at. What is called floor, wall, door or window is the building.
"""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from pydantic import ValidationError

from sdgen.catalog.records import Catalog
from sdgen.geometry import Array, lowest_highest
from sdgen.home.notes import KEY, HomeNote, ThingNote
from sdgen.importing.mjcf_document import MjcfDocument
from sdgen.importing.scenes.found import FoundScene, FoundWall, footprint
from sdgen.importing.scenes.mjcf_solids import Solids
from sdgen.importing.scenes.naming import Namer, structure_of
from sdgen.importing.scenes.scene_files import SceneFiles
from sdgen.importing.scenes.taking import Taker
from sdgen.vocabulary import StructureKind

#: Other names of a thing, of its groups and geoms, that are kept.
_HINTS = 6


def read_mjcf(path: Path, catalog: Catalog, namer: Namer) -> FoundScene:
    """The scene of an MJCF file.

    Raises InputError, located, with all that is wrong: no XML, files that are missing or lie
    outside its folder, numbers that are none.
    """
    document = MjcfDocument(path, SceneFiles(path.parent))
    taker = Taker(catalog, namer, FoundScene(source=str(path), title=path.stem))
    reading = _Reading(document, taker)
    reading.notes()
    for world in document.root.findall("worldbody"):
        reading.world(world)
    document.check()
    taker.scene.unresolved += [f"{text} are not read" for text in document.left_out]
    return taker.done()


class _Reading:
    def __init__(self, document: MjcfDocument, taker: Taker) -> None:
        self._document = document
        self._solids = Solids(document)
        self._taker = taker
        self._scene = taker.scene
        self._said: dict[str, ThingNote] = {}

    def notes(self) -> None:
        """What our own export says of the home and its things."""
        for text in self._document.root.findall("custom/text"):
            name, data = text.get("name", ""), text.get("data", "")
            try:
                if name == KEY:
                    self._taker.home(HomeNote.model_validate(json.loads(data)))
                elif data.startswith("{"):
                    self._said[name] = ThingNote.model_validate(json.loads(data))
            except (ValueError, RecursionError, ValidationError):
                told = f"custom text {name[:60]!r}: not as our export writes it; left out"
                self._scene.told.append(told)

    def world(self, world: Element) -> None:
        """Take all that is in a ``worldbody``."""
        for element, here, childclass in self._document.inside(world, np.eye(4), None):
            if element.tag == "body":
                self._body(element, here, childclass, ())
            elif element.tag == "geom":
                self._loose_geom(element, here, childclass)

    def _body(
        self, body: Element, parent: Array, childclass: str | None, above: tuple[str, ...]
    ) -> None:
        name = body.get("name", "")
        childclass = body.get("childclass") or childclass
        here = parent @ self._document.parent_from(body, body.attrib)
        note = self._said.get(name)
        kind = None if note is not None else structure_of(name, self._taker.catalog)
        if kind is not None:
            for solid in self._solids.of_body(body, childclass):
                self._structure(name, kind, solid.corners(here), above)
            return
        if self._thing(body, here, childclass, above, note):
            return
        for element, within, inner in self._document.inside(body, here, childclass):
            if element.tag == "body":
                self._body(element, within, inner, (name, *above) if name else above)

    def _thing(
        self,
        body: Element,
        here: Array,
        childclass: str | None,
        above: tuple[str, ...],
        note: ThingNote | None,
    ) -> bool:
        """Take a body as a thing, if it is one: when a note or its name says so, or when it is the
        last that could be."""
        solids = list(self._solids.of_body(body, childclass))
        shown = [solid for solid in solids if solid.shown] or solids
        seen = [solid for solid in shown if solid.visual] or shown
        if not seen:
            return False
        corners = np.concatenate([solid.corners(np.eye(4)) for solid in seen])
        names = dict.fromkeys(solid.name for solid in seen if solid.name)
        free = any(child.tag == "freejoint" or child.get("type") == "free" for child in body)
        tags = {element.tag for element, _, _ in self._document.inside(body, here, None)}
        return self._taker.thing(
            body.get("name") or "a body",
            here,
            corners,
            above,
            note,
            hints=(*above[:2], *names)[:_HINTS],
            loose=True if free else None,
            group="body" in tags and "geom" not in tags,
        )

    def _loose_geom(self, geom: Element, here: Array, childclass: str | None) -> None:
        """A geom of the world itself: a part of the building, or a thing that never moves."""
        name = geom.get("name", "")
        solid = self._solids.of_geom(geom, here, childclass)
        if solid is None:
            return
        if not name:
            text = "geoms of the world without a name: nobody can tell what they are"
            if text not in self._scene.unresolved:
                self._scene.unresolved.append(text)
            return
        kind = structure_of(name, self._taker.catalog)
        if kind is not None:
            self._structure(name, kind, solid.corners(np.eye(4)), ())
        else:
            at, corners = solid.body_from_geom, np.array([solid.low, solid.high])
            self._taker.thing(name, at, corners, ())

    def _structure(
        self, name: str, kind: StructureKind, corners: Array, above: tuple[str, ...]
    ) -> None:
        if not self._taker.sound(name, corners):
            return
        low, high = (float(end[2]) for end in lowest_highest(corners))
        if kind == "ceiling":
            self._taker.ceiling(low)
        elif kind == "floor":
            self._taker.floor(name, footprint(corners), high, above)
        else:
            self._scene.walls.append(FoundWall(name, footprint(corners), low, high))
