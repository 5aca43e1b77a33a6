"""A scene as a viewer needs it: rooms, things, how they stand to each other, and the shell."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from sdgen.dataset import SceneItem
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part
from sdgen.scene import GraphEdge, ObjectInstance, Scene, Structure

#: The one relation there are thousands of: it is written apart, each pair once.
CLOSE = "CLOSE"


def scene_space(item: SceneItem, infos: Mapping[str, AssetInfo]) -> dict[str, Any]:
    """The scene as JSON: metres, Z up, quaternions xyzw; things in the order of ``scene.json``.

    ``up`` of a thing is what it is on or in (a thing or its room), ``parts`` moves those of its
    drawn parts that a joint has turned (row-major 4x4), ``close`` names later things by place.
    """
    scene = item.scene
    place = {thing.id: k for k, thing in enumerate(scene.objects)}
    parents = _parents(scene, item.scene_graph.edges)
    boxes = {node.id: node.bounding_box for node in item.scene_graph.nodes}
    things = []
    for thing in scene.objects:
        box = boxes[thing.id]
        up, relation = parents[thing.id]
        said: dict[str, Any] = {
            "id": thing.id,
            "category": thing.category,
            "room": thing.room_id,
            "model": thing.asset,
            "at": _rounded(thing.pose.position_m, 4),
            "turn": _rounded(thing.pose.quat_xyzw, 5),
            "box": _rounded((*box.center, *box.size), 3),
            "up": up,
        }
        optional = {
            "relation": relation,
            "states": list(thing.states),
            "variant": thing.variant if thing.variant != "default" else "",
            "parts": _moved(thing, infos[thing.asset]),
        }
        things.append(said | {key: value for key, value in optional.items() if value})
    close: dict[str, list[int]] = {}
    edges = []
    known = {node.id for node in item.scene_graph.nodes}
    for edge in item.scene_graph.edges:
        here, there = place.get(edge.from_id), place.get(edge.to_id)
        if edge.relation_type != CLOSE:
            if {edge.from_id, edge.to_id} <= known:
                edges.append([edge.from_id, edge.to_id, edge.relation_type])
        elif here is not None and there is not None and here < there:
            close.setdefault(str(here), []).append(there)
    return {
        "id": item.id,
        "rooms": [
            {
                "id": room.id,
                "name": room.name,
                "type": room.type,
                "polygon": room.polygon_m,
                "height": room.height_m,
            }
            for room in scene.home.rooms
        ],
        "things": things,
        "structures": {str(one.id): [one.category, one.room_id] for one in scene.home.structures},
        "edges": edges,
        "close": close,
        "shell": [_shell(one) for one in scene.home.structures],
    }


def _parents(scene: Scene, edges: Iterable[GraphEdge]) -> dict[int, tuple[int, str]]:
    """What each thing is on or in, and which of the two: a thing, else its room (``""``)."""
    things = {thing.id: thing for thing in scene.objects}
    held: dict[int, dict[str, int]] = {}
    for edge in edges:
        if edge.relation_type in ("ON", "INSIDE") and {edge.from_id, edge.to_id} <= things.keys():
            held.setdefault(edge.from_id, {}).setdefault(edge.relation_type, edge.to_id)
    out: dict[int, tuple[int, str]] = {}
    for key, thing in things.items():
        # What is on a plate in a cupboard is below the plate.
        relation = next((name for name in ("ON", "INSIDE") if name in held.get(key, {})), "")
        out[key] = (held[key][relation], relation) if relation else (thing.room_id, "")
    for key, thing in things.items():
        way, up = {key}, out[key][0]
        while up in things and up not in way:
            way.add(up)
            up = out[up][0]
        if up in way:  # files of strangers may lead in a circle
            out[key] = (thing.room_id, "")
    return out


def _moved(thing: ObjectInstance, info: AssetInfo) -> dict[str, list[float]]:
    out = {}
    for part in info.variants[thing.variant]:
        matrix = object_from_part(info, part, thing.joints)
        if not np.array_equal(matrix, np.eye(4)):
            out[part] = _rounded(matrix.ravel(), 5)
    return out


def _shell(structure: Structure) -> dict[str, Any]:
    """A floor, wall or ceiling: its boxes (middle, size), and bands of another surface: which way
    their faces look, and their lowest and highest corner along the wall and up."""
    return {
        "id": structure.id,
        "category": structure.category,
        "room": structure.room_id,
        "surface": structure.surface,
        "pieces": [_rounded((*box.center_m, *box.size_m), 4) for box in structure.pieces],
        "bands": [
            [band.surface, band.facing, *_rounded((*band.low_m, *band.high_m), 4)]
            for band in structure.bands
        ],
    }


def _rounded(values: Iterable[float], digits: int) -> list[float]:
    return [round(float(value), digits) + 0.0 for value in values]
