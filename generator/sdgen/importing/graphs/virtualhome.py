"""A VirtualHome graph as a scene of boxes (Puig et al. 2018, http://virtual-home.org).

Its axes are Unity's, left-handed and Y up: (x, y, z) here is (x, z, y) there. Boxes lie along the
axes, so nothing is turned. Classes become our categories where we have them; others keep their own
word, with the superclass and properties that the graph gives. What it says of no box is told.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import shapely
from pydantic import Field
from shapely.geometry import Point, box
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from sdgen.catalog.records import Catalog, Category
from sdgen.dataset.virtualhome_names import CATEGORIES, ROOMS
from sdgen.errors import InputError
from sdgen.geometry import Vec3, round_position
from sdgen.importing.graphs.boxes import OPEN_RAD, box_model
from sdgen.importing.scenes.json_text import Loose, Three, read_json
from sdgen.library.records import AssetInfo
from sdgen.library.states import derive_states
from sdgen.scene import LARGEST_ID, Box, Home, ObjectInstance, Opening, Pose, Room, Structure
from sdgen.vocabulary import OpeningKind, StructureKind

#: Of what a box says nothing of, its least side, metres.
LEAST_M = 0.001
#: A door belongs to rooms that are so near to it, metres.
BESIDE_M = 0.6
#: Superclasses of what makes up the building, and of people.
_BUILDING: Mapping[str, StructureKind] = {"Floor": "floor", "Ceiling": "ceiling", "Walls": "wall"}
_PEOPLE = ("Characters", "Character")
_OPENINGS: Mapping[str, OpeningKind] = {
    "door": "door",
    "front_door": "front_door",
    "window": "window",
}
LICENCE = "MIT"


class _Box(Loose):
    center: Three
    size: Three


class _Node(Loose):
    id: int = Field(ge=1, le=LARGEST_ID)
    class_name: str
    category: str = ""
    bounding_box: _Box | None = None
    properties: list[str] = Field(default_factory=list)
    states: list[str] = Field(default_factory=list)


class _Edge(Loose):
    from_id: int
    to_id: int
    relation_type: str


class _Graph(Loose):
    nodes: list[_Node]
    edges: list[_Edge] = Field(default_factory=list)


@dataclass
class ReadGraph:
    """What a graph holds, in our records. ``told`` is what was left out or assumed, each with why;
    ``categories`` are those that the catalogue does not have."""

    name: str
    rooms: list[Room] = field(default_factory=list)
    structures: list[Structure] = field(default_factory=list)
    openings: list[Opening] = field(default_factory=list)
    objects: list[ObjectInstance] = field(default_factory=list)
    infos: dict[str, AssetInfo] = field(default_factory=dict)
    categories: dict[str, Category] = field(default_factory=dict)
    told: list[str] = field(default_factory=list)

    def home(self) -> Home:
        """The home: rooms, shell and openings."""
        return Home(
            id=self.name,
            kind="base",
            rooms=tuple(self.rooms),
            structures=tuple(sorted(self.structures, key=lambda one: one.id)),
            openings=tuple(sorted(self.openings, key=lambda one: one.object_id)),
        )


def read_graph(path: Path, name: str, catalog: Catalog) -> ReadGraph:
    """The scene of a graph's JSON, called ``name``.

    Raises InputError, located: for what is no such graph, ids that repeat or that a mask could not
    have, and one without a room that has a floor.
    """
    graph = read_json(path, _Graph)
    problems = []
    seen: set[int] = set()
    for node in graph.nodes:
        if node.id in seen:
            problems.append(f"{path}: nodes: id {node.id} appears twice")
        seen.add(node.id)
    if problems:
        raise InputError(problems)
    reading = _Reading(graph, catalog, ReadGraph(name))
    reading.read()
    if not reading.out.rooms:
        raise InputError([f"{path}: no room with a floor: nodes of category 'Rooms' and their box"])
    return reading.out


@dataclass
class _Reading:
    graph: _Graph
    catalog: Catalog
    out: ReadGraph
    outlines: dict[int, BaseGeometry] = field(default_factory=dict)

    def read(self) -> None:
        self._dangling()
        within = dict(self._within())
        for node in self.graph.nodes:
            if node.category == "Rooms":
                self._room(node, within)
        known = {category.name: category for category in self.catalog.categories}
        for node in self.graph.nodes:
            if node.category == "Rooms" or node.category in _PEOPLE or not self.out.rooms:
                continue
            if node.bounding_box is None:
                self.out.told.append(f"{node.class_name} {node.id}: has no box")
                continue
            room = self._room_of(node, within)
            if node.category in _BUILDING:
                self._structure(node, room)
            else:
                self._thing(node, room, known)

    def _dangling(self) -> None:
        ids = {node.id for node in self.graph.nodes}
        lost = sum(e.from_id not in ids or e.to_id not in ids for e in self.graph.edges)
        if lost:
            self.out.told.append(f"{lost} edges from or to nodes that are not there")

    def _within(self) -> Iterator[tuple[int, int]]:
        """The room that each node is said to be in."""
        rooms = {node.id for node in self.graph.nodes if node.category == "Rooms"}
        done: set[int] = set()
        for edge in self.graph.edges:
            if edge.relation_type == "INSIDE" and edge.to_id in rooms and edge.from_id not in done:
                done.add(edge.from_id)
                yield edge.from_id, edge.to_id

    def _room(self, room: _Node, within: Mapping[int, int]) -> None:
        """A room over its floor's tiles: its own box holds what is put outdoors, too."""
        inside = [node for node in self.graph.nodes if within.get(node.id) == room.id]
        shape: BaseGeometry = shapely.Polygon()
        for kind in ("Floor", "Ceiling"):
            tiles = [_seen(n.bounding_box) for n in inside if n.category == kind and n.bounding_box]
            if tiles:
                shape = shapely.union_all(tiles)
                break
        if shape.is_empty and room.bounding_box is not None:
            shape = _seen(room.bounding_box)
        parts = [part for part in getattr(shape, "geoms", [shape]) if part.area > 0]
        if not parts:
            self.out.told.append(f"room {room.class_name} {room.id}: has no floor")
            return
        outline = orient(max(parts, key=lambda part: part.area).simplify(0.01))
        tops = [
            n.bounding_box.center[1]
            for n in inside
            if n.category == "Ceiling" and n.bounding_box is not None
        ]
        kind = ROOMS.get(room.class_name, room.class_name)
        number = sum(one.type == kind for one in self.out.rooms) + 1
        self.outlines[room.id] = outline
        self.out.rooms.append(
            Room(
                id=room.id,
                name=kind if number == 1 else f"{kind}_{number}",
                type=kind,
                polygon_m=tuple(
                    (round(x, 3), round(y, 3)) for x, y in list(outline.exterior.coords)[:-1]
                ),
                height_m=round(max(tops), 3) if tops else 2.5,
            )
        )

    def _room_of(self, node: _Node, within: Mapping[int, int]) -> int:
        """The room it is said to be in, else the one that is nearest."""
        if within.get(node.id) in self.outlines:
            return within[node.id]
        assert node.bounding_box is not None
        x, y, _ = _ours(node.bounding_box.center)
        return min(self.outlines, key=lambda key: self.outlines[key].distance(Point(x, y)))

    def _structure(self, node: _Node, room: int) -> None:
        assert node.bounding_box is not None
        self.out.structures.append(
            Structure(
                id=node.id,
                category=_BUILDING[node.category],
                room_id=room,
                surface="",
                pieces=(
                    Box(
                        center_m=_rounded(_ours(node.bounding_box.center)),
                        size_m=_rounded(_sides(node.bounding_box)),
                    ),
                ),
            )
        )

    def _thing(self, node: _Node, room: int, known: Mapping[str, Category]) -> None:
        assert node.bounding_box is not None
        category = CATEGORIES.get(node.class_name, node.class_name)
        if category not in known:
            category = self._own_category(node)
        record = known.get(category) or self.out.categories[category]
        extents = _rounded(_sides(node.bounding_box))
        x, y, z = _ours(node.bounding_box.center)
        name = f"box_{category}_{node.id}"
        # Both know something: the graph of this thing, the catalogue of what it is.
        properties = {*node.properties, *record.properties}
        info = box_model(name, category, extents, properties, LICENCE)
        joints = {joint.name: OPEN_RAD if "OPEN" in node.states else 0.0 for joint in info.joints}
        variant = "on" if "ON" in node.states and "on" in info.variants else "default"
        states = derive_states(info, variant, joints)
        lost = sorted(set(node.states) - set(states))
        if lost:
            self.out.told.append(f"{node.class_name} {node.id}: state {', '.join(lost)} left out")
        self.out.infos[name] = info
        self.out.objects.append(
            ObjectInstance(
                id=node.id,
                category=category,
                asset=name,
                pose=Pose(
                    position_m=round_position((x, y, z - extents[2] / 2)),
                    quat_xyzw=(0.0, 0.0, 0.0, 1.0),
                ),
                room_id=room,
                joints=joints,
                variant=variant,
                states=states,
                parts=info.variants[variant],
                fixed=record.kind != "small",
            )
        )
        if category in _OPENINGS:
            self._opening(node, _OPENINGS[category])

    def _own_category(self, node: _Node) -> str:
        name = re.sub("[^a-z0-9]+", "_", node.class_name.lower()).strip("_") or "thing"
        if not name[0].isalpha():
            name = f"a_{name}"
        if name not in self.out.categories:
            grabbed = "GRABBABLE" in node.properties
            self.out.categories[name] = Category(
                name=name,
                superclass=node.category or "Props",
                extents_min_m=(LEAST_M, LEAST_M, LEAST_M),
                extents_max_m=(20.0, 20.0, 20.0),
                mass_min_kg=0.001,
                mass_max_kg=1000.0,
                properties=tuple(sorted(set(node.properties))),
                kind="small" if grabbed else "furniture",
            )
        return name

    def _opening(self, node: _Node, kind: OpeningKind) -> None:
        assert node.bounding_box is not None
        x, y, z = _ours(node.bounding_box.center)
        wide, deep, high = _sides(node.bounding_box)
        near = sorted(
            (shape.distance(Point(x, y)), key)
            for key, shape in self.outlines.items()
            if shape.distance(Point(x, y)) <= BESIDE_M
        )
        rooms = tuple(key for _, key in near[: 1 if kind != "door" else 2])
        if not rooms:
            self.out.told.append(f"{node.class_name} {node.id}: in no room's wall")
            return
        self.out.openings.append(
            Opening(
                object_id=node.id,
                kind=kind,
                room_ids=rooms,
                center_m=_rounded((x, y, 0.0 if kind != "window" else z - high / 2)),
                along="x" if wide >= deep else "y",
                width_m=round(max(wide, deep), 4),
                height_m=round(high, 4),
            )
        )


def _ours(values: Sequence[float]) -> Vec3:
    x, y, z = values
    return (x, z, y)


def _sides(given: _Box) -> Vec3:
    x, y, z = (max(abs(side), LEAST_M) for side in _ours(given.size))
    return (x, y, z)


def _rounded(values: Vec3) -> Vec3:
    x, y, z = (round(value, 4) for value in values)
    return (x, y, z)


def _seen(given: _Box) -> BaseGeometry:
    x, y, _ = _ours(given.center)
    wide, deep, _ = _sides(given)
    return box(x - wide / 2, y - deep / 2, x + wide / 2, y + deep / 2)
