"""What a viewer is told of a scene."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from sdgen.dataset import Dataset
from sdgen.gallery.space import scene_space

from tests import toy
from tests.edits import reseal


def said(path: Path, scene: int = 3) -> dict[str, Any]:
    data = Dataset(path)
    found: dict[str, Any] = json.loads(json.dumps(scene_space(data[scene], data.infos)))
    return found


def test_things_stand_on_what_holds_them(tmp_path: Path) -> None:
    found = said(toy.build(tmp_path / "d"))
    up = {thing["id"]: (thing["up"], thing.get("relation")) for thing in found["things"]}
    assert up[600] == (77, "ON")
    assert up[512] == (30, "ON")
    assert up[77] == (100, None)  # on the floor: in its room
    assert said(tmp_path / "d", 0)["things"]
    inside = {t["id"]: (t["up"], t.get("relation")) for t in said(tmp_path / "d", 0)["things"]}
    assert inside[4000] == (305, "INSIDE")
    assert {room["name"] for room in found["rooms"]} == {"kitchen", "living_room"}
    graph = Dataset(tmp_path / "d")[3].scene_graph
    close = sum(edge.relation_type == "CLOSE" for edge in graph.edges)
    assert len(found["edges"]) == len(graph.edges) - close


def test_a_circle_of_strangers_leads_back_to_the_room(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    file = path / "scenes/000003/graph.json"
    data = json.loads(file.read_text(encoding="utf-8"))
    data["edges"] = [
        {"from_id": a, "to_id": b, "relation_type": "ON"} for a, b in ((600, 4000), (4000, 600))
    ]
    file.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)
    up = {thing["id"]: thing["up"] for thing in said(path)["things"]}
    way, at = set(), 600
    while at not in (100, 101):
        assert at not in way
        way.add(at)
        at = up[at]


def test_open_doors_are_where_their_joints_put_them(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    file = path / "scenes/000003/scene.json"
    data = json.loads(file.read_text(encoding="utf-8"))
    (fridge,) = [thing for thing in data["objects"] if thing["id"] == 305]
    fridge["joints"] = {"door": np.pi / 2}
    file.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)
    things = {thing["id"]: thing for thing in said(path)["things"]}
    assert set(things[305]["parts"]) == {"door"}
    moved = np.array(things[305]["parts"]["door"]).reshape(4, 4) @ (0.3, -0.3, 0.0, 1.0)
    np.testing.assert_allclose(moved[:3], (0.9, 0.3, 0.0), atol=1e-4)  # about the hinge
    assert "parts" not in things[11]
