"""The scene graph, with VirtualHome's keys and spelling (Puig et al. 2018), in our Z-up world.

A node's ``prefab_name`` is opaque: it tells models apart and says nothing of their variant. The
edges and tags are :class:`~sdgen.relations.Facts`' alone; this module only gives them VirtualHome's
shape, and adds that structures and objects are INSIDE their room.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.geometry import Vec3, vec3
from sdgen.library.records import AssetInfo
from sdgen.relations import Facts
from sdgen.scene import (
    BoundingBox,
    Graph,
    GraphEdge,
    GraphNode,
    ObjTransform,
    Room,
    Scene,
    Structure,
)

# VirtualHome's superclasses of what a home is made of ("Floor" is its commoner spelling).
ROOM_CATEGORY = "Rooms"
STRUCTURE_CATEGORY = {"floor": "Floor", "wall": "Walls", "ceiling": "Ceiling"}

_UPRIGHT = (0.0, 0.0, 0.0, 1.0)
_SALT = "sdgen prefab 1:"


def opaque_name(model: str) -> str:
    """A name that is equal for equal models and tells nothing else, the same in every data set."""
    return "PRE_" + hashlib.sha256((_SALT + model).encode("utf-8")).hexdigest()[:12].upper()


def build_graph(
    scene: Scene, infos: Mapping[str, AssetInfo], catalog: Catalog, facts: Facts
) -> Graph:
    """The graph of a scene: nodes for rooms, structures, doors and objects, sorted by id.

    ``facts`` are those of the same scene and infos, with the catalogue's category properties
    (FACING needs them). Raises KeyError for a category or asset nobody defined.
    """
    nodes = [_room_node(room) for room in scene.home.rooms]
    nodes += [_structure_node(structure) for structure in scene.home.structures]
    for item in scene.objects:
        category = catalog.category(item.category)
        center, size = facts.bounding_box(item.id)
        nodes.append(
            GraphNode(
                id=item.id,
                class_name=item.category,
                category=category.superclass,
                prefab_name=opaque_name(infos[item.asset].id),
                obj_transform=ObjTransform(
                    position=item.pose.position_m, rotation=item.pose.quat_xyzw
                ),
                bounding_box=BoundingBox(center=_rounded(center), size=_rounded(size)),
                properties=tuple(sorted(category.properties)),
                states=facts.states(item.id),
                tags=facts.tags(item.id),
            )
        )
    triples = {(e.from_id, e.to_id, e.relation) for e in facts.edges()}
    triples |= {(s.id, s.room_id, "INSIDE") for s in scene.home.structures}
    triples |= {(item.id, item.room_id, "INSIDE") for item in scene.objects}
    return Graph(
        nodes=tuple(sorted(nodes, key=lambda node: node.id)),
        edges=tuple(
            GraphEdge(from_id=a, to_id=b, relation_type=name) for a, b, name in sorted(triples)
        ),
    )


def _rounded(values: Vec3) -> Vec3:
    # Boxes are measured through rotations: rounding keeps the last bits of libm out of the files.
    return vec3(round(v, 5) + 0.0 for v in values)


def _room_node(room: Room) -> GraphNode:
    outline = np.asarray(room.polygon_m, dtype=float)
    low, high = outline.min(axis=0), outline.max(axis=0)
    middle = (low + high) / 2
    return GraphNode(
        id=room.id,
        class_name=room.type,
        category=ROOM_CATEGORY,
        prefab_name=opaque_name("room:" + room.type),
        obj_transform=ObjTransform(position=_rounded(vec3((*middle, 0.0))), rotation=_UPRIGHT),
        bounding_box=BoundingBox(
            center=_rounded(vec3((*middle, room.height_m / 2))),
            size=_rounded(vec3((*(high - low), room.height_m))),
        ),
    )


def _structure_node(structure: Structure) -> GraphNode:
    centers = np.array([piece.center_m for piece in structure.pieces], dtype=float)
    halves = np.array([piece.size_m for piece in structure.pieces], dtype=float) / 2
    low, high = (centers - halves).min(axis=0), (centers + halves).max(axis=0)
    center = _rounded(vec3((low + high) / 2))
    return GraphNode(
        id=structure.id,
        class_name=structure.category,
        category=STRUCTURE_CATEGORY[structure.category],
        prefab_name=opaque_name("surface:" + structure.surface),
        obj_transform=ObjTransform(position=center, rotation=_UPRIGHT),
        bounding_box=BoundingBox(center=center, size=_rounded(vec3(high - low))),
    )
