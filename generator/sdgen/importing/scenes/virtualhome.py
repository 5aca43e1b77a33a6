"""A VirtualHome graph as a found scene: boxes and classes, no models.

Unity's axes are left-handed, Y up: (x, y, z)_ours = (x, z, y). Boxes are along the world's axes, so
nobody knows which way a piece looks; the wall behind it tells.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import shapely
from pydantic import Field
from shapely.geometry import box
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Catalog
from sdgen.dataset.virtualhome_names import CATEGORIES, ROOMS
from sdgen.geometry import Array
from sdgen.importing.scenes.found import FoundFloor, FoundPiece, FoundScene, box_piece
from sdgen.importing.scenes.json_text import Loose, Three, read_json
from sdgen.importing.scenes.naming import Namer, OpeningWord
from sdgen.importing.scenes.openings import opening_from

#: A door leaf belongs to the frame that is so near, metres.
_SAME_DOOR_M = 0.7
#: Classes that are no things: people, and what homes have of their own.
_NO_THINGS = ("character", "wall", "ceiling", "floor")
_STANDING = ("door", "maindoor")


class _Box(Loose):
    center: Three
    size: Three


class _Node(Loose):
    id: int
    class_name: str
    category: str = ""
    prefab_name: str | None = None
    bounding_box: _Box | None = None


class _Edge(Loose):
    from_id: int
    to_id: int
    relation_type: str


class _Graph(Loose):
    nodes: list[_Node]
    edges: list[_Edge] = Field(default_factory=list)


def read_virtualhome(path: Path, catalog: Catalog, namer: Namer) -> FoundScene:
    """The scene of a graph's JSON.

    Raises InputError, located, with all that is wrong with it.
    """
    graph = read_json(path, _Graph)
    return _Reading(graph, catalog, namer, FoundScene(source=str(path), title=path.stem)).read()


@dataclass
class _Reading:
    graph: _Graph
    catalog: Catalog
    namer: Namer
    scene: FoundScene

    def read(self) -> FoundScene:
        nodes = {node.id: node for node in self.graph.nodes}
        rooms = [node for node in self.graph.nodes if node.category == "Rooms"]
        within: dict[int, int] = {}
        ids = {room.id for room in rooms}
        for edge in self.graph.edges:
            if edge.relation_type == "INSIDE" and edge.to_id in ids:
                within.setdefault(edge.from_id, edge.to_id)
        names = self._floors(rooms, within)
        leaves = [node for node in nodes.values() if node.class_name in _STANDING]
        for node in nodes.values():
            if node.id in ids or node.class_name in _NO_THINGS:
                continue
            piece = self._piece(node, names.get(within.get(node.id, -1)))
            if piece is None:
                continue
            if node.class_name == "doorjamb":
                hung = any(_apart(node, leaf) < _SAME_DOOR_M for leaf in leaves)
                self.scene.openings.append(opening_from(piece, "door" if hung else "passage"))
            elif node.class_name in _STANDING:
                jambs = (n for n in nodes.values() if n.class_name == "doorjamb")
                kind: OpeningWord = "front_door" if node.class_name == "maindoor" else "door"
                if not any(_apart(node, jamb) < _SAME_DOOR_M for jamb in jambs):
                    self.scene.openings.append(opening_from(piece, kind))
            elif node.class_name == "window":
                self.scene.openings.append(opening_from(piece, "window"))
            else:
                self.scene.pieces.append(piece)
        return self.scene

    def _floors(self, rooms: Sequence[_Node], within: dict[int, int]) -> dict[int, str]:
        """A floor for each room, from its tiles: its own box holds what is put outdoors, too. The
        rooms' names by id."""
        names: dict[int, str] = {}
        types = {room.name for room in self.catalog.room_types}
        for room in rooms:
            inside = [node for node in self.graph.nodes if within.get(node.id) == room.id]
            shape: BaseGeometry = shapely.Polygon()
            for kind in ("floor", "ceiling"):
                tiles = [_from_above(n) for n in inside if n.class_name == kind and n.bounding_box]
                if tiles:
                    shape = shapely.union_all(tiles)
                    break
            if shape.is_empty and room.bounding_box is not None:
                shape = _from_above(room)
            if shape.is_empty:
                self.scene.unresolved.append(f"room {room.class_name} {room.id}: has no box")
                continue
            found = ROOMS.get(room.class_name, room.class_name)
            number = sum(name.rstrip("_0123456789") == found for name in names.values()) + 1
            names[room.id] = found if number == 1 else f"{found}_{number}"
            kind_of = found if found in types else None
            # Of one storey: VirtualHome's homes have no other.
            self.scene.floors.append(FoundFloor(names[room.id], shape, kind_of, 0.0))
        tops = [
            node.bounding_box.center[1]
            for node in self.graph.nodes
            if node.class_name == "ceiling" and node.bounding_box is not None
        ]
        if tops:
            self.scene.height_m = float(np.median(tops))
        return names

    def _piece(self, node: _Node, room: str | None) -> FoundPiece | None:
        called = f"{node.class_name} {node.id}"
        if node.bounding_box is None:
            self.scene.unresolved.append(f"{called}: has no box")
            return None
        low, high = _corners(node.bounding_box)
        try:
            found = box_piece(called, np.eye(4), low, high)
        except ValueError as error:
            self.scene.unresolved.append(f"{called}: {error}")
            return None
        known = {category.name for category in self.catalog.categories}
        category = CATEGORIES.get(node.class_name, node.class_name)
        return FoundPiece(
            name=called,
            position_m=found.position_m,
            quat_xyzw=found.quat_xyzw,
            extents_m=found.extents_m,
            names=(node.class_name, *([node.prefab_name] if node.prefab_name else [])),
            room=room,
            category=category if category in known else None,
        )


def _ours(values: Sequence[float]) -> Array:
    return np.array([values[0], values[2], values[1]])


def _corners(given: _Box) -> tuple[Array, Array]:
    middle, half = _ours(given.center), np.abs(_ours(given.size)) / 2
    return middle - half, middle + half


def _from_above(node: _Node) -> BaseGeometry:
    assert node.bounding_box is not None
    low, high = _corners(node.bounding_box)
    return box(low[0], low[1], high[0], high[1])


def _apart(a: _Node, b: _Node) -> float:
    if a.bounding_box is None or b.bounding_box is None:
        return np.inf
    return float(np.linalg.norm((_ours(a.bounding_box.center) - _ours(b.bounding_box.center))[:2]))
