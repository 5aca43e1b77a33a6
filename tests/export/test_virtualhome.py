"""Graphs as VirtualHome's own: its keys, words, axes; read back by our importer of its files."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.dataset import Dataset
from sdgen.dataset.virtualhome_names import CATEGORIES, PROPERTIES, ROOMS, STATES, virtualhome_class
from sdgen.export import export
from sdgen.export.virtualhome import unity, unity_rotation
from sdgen.geometry import quat_from_axis_angle, rotation_matrix
from sdgen.importing.scenes.naming import exact_namer
from sdgen.importing.scenes.virtualhome import read_virtualhome

ROOT = Path(__file__).resolve().parent.parent.parent
SAMPLE = ROOT / "output" / "sample"
SHARED = ROOT.parent / "shared" / "virtualhome"
KEYS = {
    "id",
    "category",
    "class_name",
    "prefab_name",
    "obj_transform",
    "bounding_box",
    "properties",
    "states",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("vh") / "vh"
    export(Dataset(SAMPLE), "virtualhome", out)
    return out


def graph(folder: Path, scene: str) -> Any:
    return json.loads((folder / "graphs" / f"{scene}.json").read_text(encoding="utf-8"))


def test_nodes_and_edges_are_the_scenes_in_virtualhomes_words(folder: Path) -> None:
    for item in Dataset(SAMPLE):
        made = graph(folder, item.id)
        assert set(made) == {"nodes", "edges"}
        nodes = {node["id"]: node for node in made["nodes"]}
        assert set(nodes) == {node.id for node in item.scene_graph.nodes}
        for node in item.scene_graph.nodes:
            theirs = nodes[node.id]
            assert set(theirs) == KEYS
            assert "_" not in theirs["class_name"] or theirs["class_name"] in (*CATEGORIES, *ROOMS)
            assert set(theirs["states"]) == set(node.states) & set(STATES)
            assert set(theirs["properties"]) <= set(PROPERTIES)
            x, y, z = node.bounding_box.center
            assert theirs["bounding_box"]["center"] == [x, z, y]
        edges = {(e["from_id"], e["to_id"], e["relation_type"]) for e in made["edges"]}
        assert edges == {
            (e.from_id, e.to_id, e.relation_type)
            for e in item.scene_graph.edges
            if e.relation_type in ("ON", "INSIDE", "BETWEEN", "CLOSE", "FACING")
        }
        assert {e["from_id"] for e in made["edges"]} <= set(nodes)


def test_truth_is_beside_it_under_the_same_ids(folder: Path) -> None:
    for item in Dataset(SAMPLE):
        told = json.loads((folder / "anomalies" / f"{item.id}.json").read_text(encoding="utf-8"))
        assert [a["object_id"] for a in told["anomalies"]] == [
            a.object_id for a in item.anomalies.anomalies
        ]
        assert "tags" not in json.dumps(graph(folder, item.id))


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0, 0.8)])
def test_rotations_are_mirrored_with_the_axes(axis: tuple[float, float, float]) -> None:
    """A point turned here and then told there is the point told there and turned there."""
    quat = quat_from_axis_angle(axis, 0.7)
    point = (0.3, -1.2, 2.0)
    there = rotation_matrix(unity_rotation(quat)) @ unity(point)
    turned = rotation_matrix(quat) @ point
    assert np.allclose(there, unity((turned[0], turned[1], turned[2])))


def test_classes_come_back_as_they_were() -> None:
    for category in {*CATEGORIES.values(), *ROOMS.values()}:
        theirs = virtualhome_class(category)
        assert {**CATEGORIES, **ROOMS}.get(theirs, theirs) == category


def test_the_importer_finds_the_same_things_in_the_same_places(folder: Path) -> None:
    data = Dataset(SAMPLE)
    item = data[0]
    path = folder / "graphs" / f"{item.id}.json"
    found = read_virtualhome(path, data.catalog, exact_namer(data.catalog))
    boxes = {node.id: node.bounding_box for node in item.scene_graph.nodes}
    assert len(found.floors) == len(item.scene.home.rooms)
    for piece in found.pieces:
        box = boxes[int(piece.name.split()[-1])]
        middle = np.add(piece.position_m, (0, 0, piece.extents_m[2] / 2))
        assert np.allclose(middle, box.center, atol=1e-3)


@pytest.mark.skipif(not SHARED.is_dir(), reason="the simulator's own files are not at hand")
def test_its_own_files_use_these_words() -> None:
    words = json.loads((SHARED / "properties_data_unity.json").read_text(encoding="utf-8"))
    known = {name for names in words.values() for name in names}
    assert known <= set(PROPERTIES), sorted(known - set(PROPERTIES))
    for path in SHARED.glob("TestScene*.json"):
        made = json.loads(path.read_text(encoding="utf-8"))
        assert {state for node in made["nodes"] for state in node["states"]} <= set(STATES)
