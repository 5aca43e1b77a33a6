"""The scene graph, with VirtualHome's keys and spelling (Puig et al. 2018), in our Z-up world.

A node's ``prefab_name`` is opaque: it tells models apart and says nothing of their variant. The
boxes, edges and tags are :class:`~sdgen.facts.Facts`' alone; this module only gives them
VirtualHome's shape.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping

from sdgen.catalog.records import Catalog
from sdgen.facts import Facts
from sdgen.geometry import Vec3, vec3
from sdgen.library.records import AssetInfo
from sdgen.scene import (
    BoundingBox,
    Graph,
    GraphNode,
    ObjTransform,
    Room,
    Scene,
    Structure,
)
from sdgen.vocabulary import ROOM_SUPERCLASS, STRUCTURE_SUPERCLASS

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
    # Thousands of edges: read by pydantic in one call rather than one each.
    return Graph.model_validate(
        {
            "nodes": graph_nodes(scene, infos, catalog, facts),
            "edges": tuple(
                {"from_id": a, "to_id": b, "relation_type": name} for a, b, name in facts.edges()
            ),
        }
    )


def graph_nodes(
    scene: Scene, infos: Mapping[str, AssetInfo], catalog: Catalog, facts: Facts
) -> tuple[GraphNode, ...]:
    """The nodes alone, sorted by id."""
    nodes = [_room_node(room, _box(facts, room.id)) for room in scene.home.rooms]
    nodes += [_structure_node(s, _box(facts, s.id)) for s in scene.home.structures]
    for item in scene.objects:
        category = catalog.category(item.category)
        nodes.append(
            GraphNode(
                id=item.id,
                class_name=item.category,
                category=category.superclass,
                prefab_name=opaque_name(infos[item.asset].id),
                obj_transform=ObjTransform(
                    position=item.pose.position_m, rotation=item.pose.quat_xyzw
                ),
                bounding_box=_box(facts, item.id),
                properties=tuple(sorted(category.properties)),
                states=facts.states(item.id),
                tags=facts.tags(item.id),
            )
        )
    return tuple(sorted(nodes, key=lambda node: node.id))


def _box(facts: Facts, node_id: int) -> BoundingBox:
    # Boxes are measured through rotations: rounding keeps the last bits of libm out of the files.
    center, size = facts.bounding_box(node_id)
    return BoundingBox(center=_rounded(center), size=_rounded(size))


def _rounded(values: Vec3) -> Vec3:
    return vec3(round(v, 5) + 0.0 for v in values)


def _room_node(room: Room, box: BoundingBox) -> GraphNode:
    x, y, _ = box.center
    return GraphNode(
        id=room.id,
        class_name=room.type,
        category=ROOM_SUPERCLASS,
        prefab_name=opaque_name("room:" + room.type),
        obj_transform=ObjTransform(position=(x, y, 0.0), rotation=_UPRIGHT),
        bounding_box=box,
    )


def _structure_node(structure: Structure, box: BoundingBox) -> GraphNode:
    return GraphNode(
        id=structure.id,
        class_name=structure.category,
        category=STRUCTURE_SUPERCLASS[structure.category],
        prefab_name=opaque_name("surface:" + structure.surface),
        obj_transform=ObjTransform(position=box.center, rotation=_UPRIGHT),
        bounding_box=box,
    )
