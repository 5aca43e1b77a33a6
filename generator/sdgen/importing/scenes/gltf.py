"""A glTF scene with named nodes, ours or anybody's, as a found scene.

A node is a thing when our own export's extras say so, or when the namer knows its name; else what
is below it is looked at. Nodes called floors, walls, ceilings, doors and windows are the building.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from sdgen.catalog.records import Catalog
from sdgen.geometry import Array, lowest_highest, quat_from_matrix, vec3
from sdgen.home.notes import KEY, HomeNote, ThingNote
from sdgen.importing.scenes.found import (
    KNEE_M,
    FoundFloor,
    FoundScene,
    FoundWall,
    box_piece,
    triangles_at,
    triangles_from_above,
)
from sdgen.importing.scenes.gltf_document import GltfDocument, parent_from
from sdgen.importing.scenes.naming import (
    Namer,
    opening_of,
    room_in,
    room_type_of,
    structure_of,
)
from sdgen.importing.scenes.openings import opening_from
from sdgen.vocabulary import OPENINGS, StructureKind

#: glTF is Y up: (x, y, z)_ours = (x, -z, y)_gltf.
_OURS_FROM_GLTF = np.array(
    [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
)
#: Parts of a wall lower than this, metres, are skirtings: they tell nothing more.
_LEAST_WALL_M = 0.3


def read_gltf(path: Path, catalog: Catalog, namer: Namer) -> FoundScene:
    """The scene of a ``.glb`` or ``.gltf``.

    Raises InputError, located, for what is no glTF, broken, or beyond the bounds.
    """
    document = GltfDocument(path)
    reading = _Reading(document, catalog, namer, FoundScene(source=str(path), title=path.stem))
    for root in document.roots:
        reading.node(root, _OURS_FROM_GLTF, ())
    reading.in_order()
    return reading.scene


class _Reading:
    def __init__(
        self, document: GltfDocument, catalog: Catalog, namer: Namer, scene: FoundScene
    ) -> None:
        self._document = document
        self._catalog = catalog
        self._namer = namer
        self._rooms: dict[str, str] = {}
        self.scene = scene

    def node(self, index: int, ours_from_parent: Array, above: tuple[str, ...]) -> None:
        """Take a node, or what is below it."""
        node = self._document.nodes[index]
        name = self._document.name(index)
        here = ours_from_parent @ parent_from(node)
        note = self._noted(node.extras)
        if isinstance(note, ThingNote):
            self._thing(index, here, above, note)
            return
        kind = structure_of(name, self._catalog)
        if kind is not None and self._has_mesh(index):
            self._structure(index, here, name, kind, above)
            return
        if name and note is None and self._thing(index, here, above, None):
            return
        for child in node.children:
            self.node(child, here, (name, *above) if name else above)

    def in_order(self) -> None:
        """Put the floors in the order of the home's note, where there is one."""
        order = {name: k for k, name in enumerate(self._rooms)}
        self.scene.floors.sort(key=lambda floor: order.get(floor.name, len(order)))

    def _noted(self, extras: Any) -> HomeNote | ThingNote | None:
        """What our own export says of a node; a home's is taken to the scene."""
        said = extras.get(KEY) if isinstance(extras, dict) else None
        if not isinstance(said, dict):
            return None
        try:
            if "rooms" not in said:
                return ThingNote.model_validate(said)
            home = HomeNote.model_validate(said)
        except ValidationError:
            self.scene.told.append(f"extras.{KEY} of a node: not as our export writes it; left out")
            return None
        self.scene.title, self.scene.style = home.title, home.style
        self.scene.height_m, self.scene.drawn = home.height_m, True
        self._rooms = home.rooms
        return home

    def _has_mesh(self, index: int) -> bool:
        return any(True for _ in self._document.meshes(index, np.eye(4)))

    def _thing(
        self, index: int, here: Array, above: tuple[str, ...], note: ThingNote | None
    ) -> bool:
        """Take a node as a thing, if it is one: when a note or its name says so, or when it is the
        last that could be."""
        name = self._document.name(index)
        corners = self._document.corners(self._document.meshes(index, np.eye(4)))
        if not len(corners):
            if note is not None:
                self.scene.unresolved.append(f"{name}: has no mesh")
            return note is not None
        try:
            piece = box_piece(name, here, *lowest_highest(corners))
        except ValueError as error:
            self.scene.unresolved.append(f"{name}: {error}")
            return True
        piece = replace(piece, names=above[:2], room=self._room_of(above))
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
        kind = opening_of(name) if note is None else None
        if note is not None and note.category in OPENINGS:
            kind = note.category
        if kind is not None:
            self.scene.openings.append(opening_from(piece, kind))
            return True
        leaf = not any(self._has_mesh(k) for k in self._document.nodes[index].children)
        if note is None and not leaf and self._namer(piece).category is None:
            return False
        self.scene.pieces.append(piece)
        return True

    def _room_of(self, above: tuple[str, ...]) -> str | None:
        """The room that a group's name means."""
        return next((name for name in above if room_type_of(name, self._catalog)), None)

    def _structure(
        self, index: int, here: Array, name: str, kind: StructureKind, above: tuple[str, ...]
    ) -> None:
        every = self._document.triangles(self._document.meshes(index, here))
        if not len(every):
            return
        low, high = float(every[:, :, 2].min()), float(every[:, :, 2].max())
        if kind == "ceiling":
            if self.scene.height_m is None:
                self.scene.height_m = low
            return
        shape = triangles_from_above(every)
        if kind == "wall":
            if high - low > _LEAST_WALL_M:
                cut = triangles_at(every, low + KNEE_M)
                self.scene.walls.append(FoundWall(name, shape, low, high, cut))
            return
        called = room_in(name)
        if called is None:
            called = name if room_type_of(name, self._catalog) else self._room_of(above)
        room_type = self._rooms.get(called or "") or room_type_of(called or name, self._catalog)
        self.scene.floors.append(FoundFloor(called or name, shape, room_type, high))
