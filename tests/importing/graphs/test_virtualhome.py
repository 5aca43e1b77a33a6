"""VirtualHome's graphs as scenes that detectors and metrics work on."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.benchmark import detect, evaluate
from sdgen.catalog.load import load_catalog
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.dataset.virtualhome_names import CATEGORIES
from sdgen.errors import InputError, SdgenError, UsageError
from sdgen.export import export
from sdgen.importing.graphs.data_set import import_graphs
from sdgen.validate import validate

ROOT = Path(__file__).resolve().parents[3]
SAMPLE = ROOT / "output" / "sample"
SHARED = ROOT.parent / "shared" / "virtualhome"
CATALOG = load_catalog()

Captured = pytest.CaptureFixture[str]


def node(
    number: int, name: str, kind: str, center: list[float], size: list[float], **more: Any
) -> Any:
    """A node in Unity's axes: y is up."""
    box = {"center": center, "size": size}
    rest = {"properties": [], "states": [], "prefab_name": "PRE", **more}
    return {"id": number, "class_name": name, "category": kind, "bounding_box": box, **rest}


def graph() -> dict[str, Any]:
    """A kitchen of 4 x 3 m with a table 0.7 m high, a knife and milk on it, a stove that is on, a
    shut fridge with milk in it, and something our catalogue does not know."""
    table = {"properties": ["SURFACES"]}
    stove = {"properties": ["HAS_SWITCH", "CAN_OPEN"], "states": ["ON", "CLOSED"]}
    fridge = {"properties": ["CONTAINERS", "CAN_OPEN"], "states": ["CLOSED"]}
    grab = {"properties": ["GRABBABLE"]}
    nodes = [
        node(1, "kitchen", "Rooms", [2, 1.25, 1.5], [4, 2.5, 3]),
        node(2, "floor", "Floor", [2, 0, 1.5], [4, 0.0001, 3]),
        node(3, "ceiling", "Ceiling", [2, 2.5, 1.5], [4, 0.0001, 3]),
        node(4, "kitchentable", "Furniture", [2, 0.35, 1.5], [1.2, 0.7, 0.8], **table),
        node(5, "cutleryknife", "Props", [2, 0.705, 1.5], [0.2, 0.01, 0.03], **grab),
        node(6, "milk", "Food", [2.3, 0.8, 1.6], [0.08, 0.2, 0.08], **grab),
        node(7, "stove", "Appliances", [0.3, 0.45, 0.3], [0.6, 0.9, 0.6], **stove),
        node(8, "fridge", "Appliances", [0.4, 0.9, 2.6], [0.7, 1.8, 0.7], **fridge),
        node(9, "milk", "Food", [0.4, 0.5, 2.6], [0.08, 0.2, 0.08], **grab),
        node(10, "theremin", "Electronics", [3.5, 0.5, 2.5], [0.4, 1.0, 0.4], states=["LYING"]),
        node(11, "character", "Characters", [1, 1, 1], [0.5, 1.7, 0.5]),
        {"id": 12, "class_name": "radio", "category": "Electronics"},
    ]
    edges = [
        {"from_id": k, "to_id": 1, "relation_type": "INSIDE"} for k in (2, 3, 4, 5, 6, 7, 8, 9, 10)
    ]
    return {"nodes": nodes, "edges": [*edges, {"from_id": 5, "to_id": 99, "relation_type": "ON"}]}


def written(path: Path, value: object) -> Path:
    path.write_text(json.dumps(value), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("vh")
    paths = [written(folder / "one.json", graph()), written(folder / "two.json", graph())]
    import_graphs("virtualhome", paths, folder / "out", CATALOG, household="family_with_toddler")
    return folder / "out"


def test_things_are_where_the_graph_has_them_in_our_axes_and_words(made: Path) -> None:
    item = Dataset(made)[0]
    things = {thing.id: thing for thing in item.scene.objects}
    assert set(things) == {4, 5, 6, 7, 8, 9, 10}
    assert things[6].category == "milk_carton"
    assert things[6].pose.position_m == (2.3, 1.6, 0.7)
    assert things[10].category == "theremin"
    assert (things[7].states, things[8].states) == (("CLOSED", "ON"), ("CLOSED",))
    (room,) = item.scene.home.rooms
    assert (room.type, room.height_m) == ("kitchen", 2.5)
    relations = {(a, b, r) for a, b, r in item.graph.edges(keys=True)}
    assert {(6, 4, "ON"), (5, 4, "ON"), (9, 8, "INSIDE")} <= relations


def test_labels_are_what_the_rules_say_of_it(made: Path) -> None:
    item = Dataset(made)[0]
    found = {(a.object_id, a.hazard) for a in item.anomalies.anomalies}
    assert {(6, "refrigerated_food_out"), (5, "sharp_object"), (7, "stove_on")} <= found
    assert not any(number == 9 for number, _ in found)  # in the fridge
    knife = next(a for a in item.anomalies.anomalies if a.object_id == 5)
    assert knife.report  # a toddler lives there


def test_commands_for_data_sets_work_on_it(made: Path, tmp_path: Path) -> None:
    assert validate(made) == []
    data = Dataset(made)
    score = evaluate(data, detect(data, "rules"))
    assert (score.AS.mean, score.false_alarms_per_scene.mean) == (1.0, 0.0)
    assert evaluate(data, detect(data, "never")).AS.mean == 0.0
    assert run(["stats", str(made)]) == 0
    assert run(["view", str(made), "-o", str(tmp_path / "page")]) == 0
    assert len(data.anomalies) == data.info.counts.anomalies
    export(data, "virtualhome", tmp_path / "again")


def test_what_is_left_out_is_told(tmp_path: Path) -> None:
    path = written(tmp_path / "g.json", graph())
    found = import_graphs("virtualhome", [path], tmp_path / "out", CATALOG)
    told = "\n".join(found.told[str(path)])
    assert "radio 12: has no box" in told
    assert "theremin 10: state LYING left out" in told
    assert "1 edges from or to nodes that are not there" in told


def test_the_same_bytes_for_the_same_graphs(made: Path, tmp_path: Path) -> None:
    paths = [written(tmp_path / name, graph()) for name in ("one.json", "two.json")]
    import_graphs("virtualhome", paths, tmp_path / "out", CATALOG, household="family_with_toddler")
    for entry in Dataset(made).entries:
        assert Dataset(tmp_path / "out").scene(entry.id).entry == entry


def _set(**values: Any) -> Callable[[Any], None]:
    def change(value: Any) -> None:
        value["nodes"][4].update(values)

    return change


def _no_rooms(value: Any) -> None:
    value["nodes"] = value["nodes"][3:]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (_set(id=4), r"nodes: id 4 appears twice"),
        (_set(id=0), r"nodes\[4\]\.id"),
        (_set(id=70000), r"nodes\[4\]\.id"),
        (_set(class_name=3), r"nodes\[4\]\.class_name"),
        (_set(bounding_box={"center": [0, 0], "size": [1, 1, 1]}), r"nodes\[4\]\.bounding_box"),
        (_set(bounding_box={"center": [float("nan")] * 3, "size": [1] * 3}), r"bounding_box"),
        (_no_rooms, r"no room with a floor"),
        (lambda value: value.pop("nodes"), r"nodes"),
    ],
)
def test_bad_graphs_are_one_clear_error_and_nothing_is_written(
    tmp_path: Path, change: Callable[[Any], object], words: str
) -> None:
    value = graph()
    change(value)
    path = written(tmp_path / "g.json", value)
    with pytest.raises(InputError, match=words):
        import_graphs("virtualhome", [path], tmp_path / "out", CATALOG)
    assert not (tmp_path / "out").exists()


def test_text_that_is_no_json_and_places_that_are_taken(tmp_path: Path) -> None:
    (tmp_path / "g.json").write_text("{")
    with pytest.raises(InputError, match="no JSON"):
        import_graphs("virtualhome", [tmp_path / "g.json"], tmp_path / "out", CATALOG)
    written(tmp_path / "g.json", graph())
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "mine.txt").write_text("mine")
    with pytest.raises(SdgenError):
        import_graphs("virtualhome", [tmp_path / "g.json"], tmp_path / "out", CATALOG)
    with pytest.raises(InputError, match="no household 'nobody'"):
        import_graphs("virtualhome", [tmp_path / "g.json"], tmp_path / "x", CATALOG, 0, "nobody")


def test_no_build_makes_imported_homes(tmp_path: Path) -> None:
    import sdgen

    options = sdgen.BuildOptions(n=1, homes="imported")
    with pytest.raises(UsageError, match="come from 'sdgen import'"):
        sdgen.build(options, tmp_path / "x", CATALOG, sdgen.load_library())


def test_command(tmp_path: Path, capsys: Captured) -> None:
    path = written(tmp_path / "g.json", graph())
    out = str(tmp_path / "out")
    assert run(["import", "virtualhome", str(path), "-o", out]) == 0
    assert "1 scenes" in capsys.readouterr().out
    more = [str(tmp_path / "json"), "--json"]
    assert run(["import", "virtualhome", str(path), "-o", *more]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["anomalies_by_hazard"]["stove_on"] == 1
    assert run(["import", "virtualhome", str(tmp_path / "none.json"), "-o", out]) == 2


def test_our_own_export_comes_back(tmp_path: Path) -> None:
    """Classes, boxes and what holds what; states and shapes that VirtualHome has no words for are
    lost, and with them some anomalies."""
    data = Dataset(SAMPLE)
    item = data[0]
    export(data, "virtualhome", tmp_path / "vh")
    path = tmp_path / "vh" / "graphs" / f"{item.id}.json"
    import_graphs("virtualhome", [path], tmp_path / "out", data.catalog)
    back = Dataset(tmp_path / "out")[0]
    ours = {node.id: node for node in item.scene_graph.nodes}
    lossy = set(CATEGORIES.values())  # several of theirs are one of ours, never the other way
    for node in back.scene_graph.nodes:
        before = ours[node.id]
        if before.category != "Rooms" and before.class_name not in lossy:
            assert node.class_name.replace("_", "") == before.class_name.replace("_", "")
        if node.category not in ("Rooms", "Floor", "Walls", "Ceiling"):
            assert np.allclose(node.bounding_box.center, before.bounding_box.center, atol=2e-3)


@pytest.mark.skipif(not SHARED.is_dir(), reason="the simulator's own files are not at hand")
def test_the_papers_own_homes_are_full_of_hazards(tmp_path: Path) -> None:
    paths = sorted(SHARED.glob("TestScene*.json"))
    found = import_graphs("virtualhome", paths, tmp_path / "out", CATALOG)
    assert found.scenes == len(paths)
    assert sum(found.anomalies.values()) > 5 * len(paths)
    assert validate(tmp_path / "out") == []
