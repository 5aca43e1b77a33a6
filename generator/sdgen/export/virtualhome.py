"""Scene graphs as VirtualHome has them: ``graphs/000041.json``, and beside them what is true there.

Unity's axes, left-handed and Y up: (x, y, z) there is (x, z, y) here. Classes, properties, states
and the five relations in VirtualHome's spelling; what it has no word for (BROKEN, SPILLED, UNDER,
tags) is left out of the graph. ``anomalies/000041.json`` and ``households/000041.json`` are the
scene's own files: their ids are the graph's. http://virtual-home.org/documentation/
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.graph_views import VIRTUALHOME_RELATIONS
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.text import pretty
from sdgen.dataset.virtualhome_names import PROPERTIES, STATES, virtualhome_class
from sdgen.export.formats import OnScene
from sdgen.export.shards import groups, scenes_in
from sdgen.geometry import Quat, Vec3
from sdgen.scene import GraphNode

#: Folder -> the scene's file that it holds.
BESIDE = {"anomalies": "anomalies.json", "households": "household.json"}


def export_virtualhome(data: Dataset, output: Path, on_scene: OnScene = None) -> None:
    """Write a graph a scene, twins too, into a new folder; the same bytes for the same data set.

    Raises SdgenError for a bad place, InputError for a file that is missing or changed.
    """
    total, done = scenes_in(data), 0
    with output_folder(output) as folder:
        for name in ("graphs", *BESIDE):
            (folder / name).mkdir()
        for _, _, items in groups(data):
            for item in items:
                with derived_from(data, item):
                    text = pretty(virtualhome_graph(item)) + "\n"
                (folder / "graphs" / f"{item.id}.json").write_text(text, encoding="utf-8")
                for name, file in BESIDE.items():
                    (folder / name / f"{item.id}.json").write_bytes(item.file(file))
                done += 1
                if on_scene is not None:
                    on_scene(done, total)


def virtualhome_graph(item: SceneItem) -> dict[str, Any]:
    """The graph of a scene as VirtualHome writes it."""
    graph = item.scene_graph
    return {
        "nodes": [_node(node) for node in graph.nodes],
        "edges": [
            {
                "from_id": edge.from_id,
                "to_id": edge.to_id,
                "relation_type": edge.relation_type,
            }
            for edge in graph.edges
            if edge.relation_type in VIRTUALHOME_RELATIONS
        ],
    }


def _node(node: GraphNode) -> dict[str, Any]:
    where = node.obj_transform
    return {
        "id": node.id,
        "category": node.category,
        "class_name": virtualhome_class(node.class_name),
        "prefab_name": node.prefab_name,
        "obj_transform": {
            "position": unity(where.position),
            "rotation": unity_rotation(where.rotation),
            "scale": unity(where.scale),
        },
        "bounding_box": {
            "center": unity(node.bounding_box.center),
            "size": unity(node.bounding_box.size),
        },
        "properties": [name for name in node.properties if name in PROPERTIES],
        "states": [state for state in node.states if state in STATES],
    }


def unity(values: Vec3) -> list[float]:
    """A point or an extent in Unity's axes."""
    x, y, z = values
    return [x, z, y]


def unity_rotation(quat_xyzw: Quat) -> list[float]:
    """A rotation in Unity's axes, xyzw: swapping two axes mirrors, which turns an axis about."""
    x, y, z, w = quat_xyzw
    return [-x, -z, -y, w]
