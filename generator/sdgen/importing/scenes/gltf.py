"""A glTF scene with named nodes, ours or anybody's, as a found scene.

A node is a thing when our own export's extras say so, or when the namer knows its name; else what
is below it is looked at. Nodes called floors, walls, ceilings, doors and windows are the building.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from sdgen.catalog.records import Catalog
from sdgen.geometry import Z_UP_FROM_Y_UP, Array
from sdgen.home.notes import KEY, HomeNote, ThingNote
from sdgen.importing.scenes.found import (
    KNEE_M,
    FoundScene,
    FoundWall,
    triangles_at,
    triangles_from_above,
)
from sdgen.importing.scenes.gltf_document import GltfDocument, parent_from
from sdgen.importing.scenes.naming import Namer, structure_of
from sdgen.importing.scenes.taking import Taker
from sdgen.vocabulary import StructureKind

#: Parts of a wall lower than this, metres, are skirtings: they tell nothing more.
_LEAST_WALL_M = 0.3


def read_gltf(path: Path, catalog: Catalog, namer: Namer) -> FoundScene:
    """The scene of a ``.glb`` or ``.gltf``.

    Raises InputError, located, for what is no glTF, broken, or beyond the bounds.
    """
    document = GltfDocument(path)
    taker = Taker(catalog, namer, FoundScene(source=str(path), title=path.stem))
    reading = _Reading(document, taker)
    for root in document.roots:
        reading.node(root, Z_UP_FROM_Y_UP, ())
    return taker.done()


class _Reading:
    def __init__(self, document: GltfDocument, taker: Taker) -> None:
        self._document = document
        self._taker = taker
        self._scene = taker.scene

    def node(self, index: int, ours_from_parent: Array, above: tuple[str, ...]) -> None:
        """Take a node, or what is below it."""
        node = self._document.nodes[index]
        name = self._document.name(index)
        here = ours_from_parent @ parent_from(node)
        note = self._noted(node.extras)
        if isinstance(note, ThingNote):
            if not self._thing(index, here, above, note):
                self._scene.unresolved.append(f"{name}: has no mesh")
            return
        kind = structure_of(name, self._taker.catalog)
        if kind is not None and self._has_mesh(index):
            self._structure(index, here, name, kind, above)
            return
        # What has no name at all is no thing before it is the last that could be.
        named = name or (node.mesh is not None and not node.children)
        if named and note is None and self._thing(index, here, above, None):
            return
        if node.mesh is not None and node.children:
            self._scene.unresolved.append(f"{name or 'a node'}: its own mesh is nothing we know")
        for child in node.children:
            self.node(child, here, (name, *above) if name else above)

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
            self._scene.told.append(
                f"extras.{KEY} of a node: not as our export writes it; left out"
            )
            return None
        self._taker.home(home)
        return home

    def _has_mesh(self, index: int) -> bool:
        return any(True for _ in self._document.meshes(index, np.eye(4)))

    def _thing(
        self, index: int, here: Array, above: tuple[str, ...], note: ThingNote | None
    ) -> bool:
        """Take a node as a thing, if it is one: when a note or its name says so, or when it is the
        last that could be."""
        corners = self._document.corners(self._document.meshes(index, np.eye(4)))
        if not len(corners):
            return False
        name = self._document.name(index) or "a node without a name"
        group = any(self._has_mesh(k) for k in self._document.nodes[index].children)
        return self._taker.thing(name, here, corners, above, note, above[:2], group=group)

    def _structure(
        self, index: int, here: Array, name: str, kind: StructureKind, above: tuple[str, ...]
    ) -> None:
        every = self._document.triangles(self._document.meshes(index, here))
        if not len(every) or not self._taker.sound(name, every):
            return
        low, high = float(every[:, :, 2].min()), float(every[:, :, 2].max())
        if kind == "ceiling":
            self._taker.ceiling(low)
        elif kind == "floor":
            self._taker.floor(name, triangles_from_above(every), high, above)
        elif high - low > _LEAST_WALL_M:
            cut = triangles_at(every, low + KNEE_M)
            self._scene.walls.append(FoundWall(name, triangles_from_above(every), low, high, cut))
