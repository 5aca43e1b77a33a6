"""Opening a data set: what is in it, and one clear error for what is not."""

import json
import pickle
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import networkx as nx
import numpy as np
import pytest
from sdgen.catalog.records import canonical_sha256
from sdgen.dataset import Dataset
from sdgen.errors import InputError
from sdgen.options import MAX_SCENES

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d")


def test_records_come_back_as_they_were_written(path: Path) -> None:
    made = Dataset(path)
    bundle = toy.bundle(3)
    item = made[3]
    assert len(made) == 4
    assert item.id == "000003"
    assert item.scene == bundle.scene
    assert item.anomalies == bundle.anomalies
    assert item.household == bundle.household
    assert item.physics == bundle.physics
    assert item.cameras == bundle.cameras
    assert item.scene_graph == bundle.graph
    assert item.visibility == toy.visibility(bundle, toy.frames(bundle))
    assert made.catalog == toy.catalog()
    assert made.infos == toy.infos()


def test_pictures_come_back_as_they_were_rendered(path: Path) -> None:
    frame = toy.frame(toy.bundle(3), 1)
    item = Dataset(path)[3]
    assert np.array_equal(item.rgb(1), frame.rgb)
    assert np.array_equal(item.depth_mm(1), frame.depth_mm)
    assert np.array_equal(item.instance(1), frame.instance)
    assert np.array_equal(item.part(1), frame.part)
    assert item.depth(1).dtype == np.float32
    assert item.depth(1).max() == pytest.approx(frame.depth_mm.max() / 1000)


def test_it_is_a_sequence_that_can_be_pickled(path: Path) -> None:
    made = pickle.loads(pickle.dumps(Dataset(path)))
    assert [item.id for item in made] == [made[k].id for k in range(len(made))]
    assert made[-1].id == "000003"
    with pytest.raises(IndexError):
        made[4]
    with pytest.raises(TypeError):
        made[0:2]
    assert pickle.loads(pickle.dumps(made[1])).scene.index == 1


def test_its_repr_says_what_it_is(path: Path) -> None:
    told = repr(Dataset(path))
    assert told.startswith(f"<sdgen.Dataset {str(path)!r}: 4 scenes, 2 views, 6 anomalies of 13 ")
    assert "1 scene of val" in repr(Dataset(path, split="val"))
    assert "0 twins" in repr(Dataset(path, twins=True))


def test_splits_part_the_scenes(path: Path) -> None:
    parts = [Dataset(path, split=name) for name in ("train", "val", "test")]
    assert sorted(item.id for part in parts for item in part) == [f"{k:06d}" for k in range(4)]
    with pytest.raises(InputError, match=r"no split 'trian' \(did you mean 'train'"):
        Dataset(path, split="trian")


def test_scenes_are_found_by_id(path: Path) -> None:
    assert Dataset(path).scene("000002").scene.index == 2
    with pytest.raises(InputError, match="no scene '2'"):
        Dataset(path).scene("2")


def test_full_graph_has_everything(path: Path) -> None:
    graph = Dataset(path).graph(3)
    assert isinstance(graph, nx.MultiDiGraph)
    assert graph.nodes[11]["states"] == ("ON",)
    assert graph.has_edge(600, 77, key="ON")
    assert graph.has_edge(600, 77, key="CLOSE")


def test_neutral_graph_gives_no_state_or_tag_away(path: Path) -> None:
    graph = Dataset(path).graph(3, graph_view="neutral")
    assert graph.number_of_nodes() == Dataset(path).graph(3).number_of_nodes()
    for _, data in graph.nodes(data=True):
        assert not {"states", "tags", "prefab_name"} & set(data)
        assert "class_name" in data
        assert "obj_transform" in data
    relations = {key for _, _, key in graph.edges(keys=True)}
    assert relations <= {"ON", "INSIDE", "BETWEEN", "CLOSE", "FACING"}


def test_perceived_graph_has_the_home_and_what_views_show(path: Path) -> None:
    made = Dataset(path)
    graph = made.graph(3, graph_view="perceived")
    needed = 100 * 160 * 120 / (640 * 480)
    shown = (thing for view in made[3].visibility.views for thing in view.objects)
    seen = {thing.object_id for thing in shown if thing.pixels >= needed}
    home = {100, 101, 200, 201, 202, 210, 211, 212}
    assert set(graph.nodes) == seen | home
    assert set(made.graph(3)) - seen - home == {65535}
    assert graph.nodes[11]["states"] == ("ON",)
    assert "prefab_name" not in graph.nodes[11]
    assert graph.has_edge(600, 77, key="ON")


def test_unknown_graph_view_is_an_error(path: Path) -> None:
    with pytest.raises(ValueError, match="full, neutral or perceived"):
        Dataset(path).graph(0, graph_view="fulll")  # type: ignore[arg-type]


def test_what_is_left_of_a_data_set_can_be_opened(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2, sensors=()))
    lines = (path / "manifest.jsonl").read_bytes().splitlines(keepends=True)
    (path / "manifest.jsonl").write_bytes(lines[0])
    with pytest.raises(InputError, match="not listed: 000001"):
        Dataset(path)
    assert [item.id for item in Dataset(path, partial=True)] == ["000000"]


def _no_dataset_json(path: Path) -> None:
    (path / "dataset.json").unlink()


def _cut(path: Path) -> None:
    data = (path / "manifest.jsonl").read_bytes()
    (path / "manifest.jsonl").write_bytes(data[:-40])


def _twice(path: Path) -> None:
    data = (path / "manifest.jsonl").read_bytes()
    (path / "manifest.jsonl").write_bytes(data + data)


def _renamed(name: str) -> Callable[[Path], None]:
    def rename(path: Path) -> None:
        text = (path / "manifest.jsonl").read_text(encoding="utf-8")
        (path / "manifest.jsonl").write_text(
            text.replace('"graph.json"', f'"{name}"', 1), encoding="utf-8"
        )

    return rename


def _says(**keys: object) -> Callable[[Path], None]:
    def say(path: Path) -> None:
        data = json.loads((path / "dataset.json").read_text(encoding="utf-8"))
        (path / "dataset.json").write_text(json.dumps({**data, **keys}), encoding="utf-8")

    return say


def _views(path: Path) -> None:
    text = (path / "manifest.jsonl").read_text(encoding="utf-8")
    (path / "manifest.jsonl").write_text(text.replace('"views": 2', '"views": 100', 1))


def _future(path: Path) -> None:
    data = json.loads((path / "dataset.json").read_text(encoding="utf-8"))
    data["format_version"] = "9.0"
    (path / "dataset.json").write_text(json.dumps(data), encoding="utf-8")


def _key(path: Path) -> None:
    text = (path / "dataset.json").read_text(encoding="utf-8")
    (path / "dataset.json").write_text(text.replace('"licence"', '"license"'), encoding="utf-8")


@pytest.mark.parametrize(
    ("break_it", "words"),
    [
        (_no_dataset_json, "no data set"),
        (_cut, "manifest.jsonl:4"),
        (_twice, "scene 000000 appears twice"),
        (_renamed("../../graph.json"), "files: '../../graph.json' is no file that sdgen writes"),
        (_renamed("notes.txt"), "files: 'notes.txt' is no file that sdgen writes"),
        (_renamed("views/00/" + "a" * 150), "aaa' is no file that sdgen writes"),
        (_views, "manifest.jsonl:1: views: "),
        (_says(n=2 * MAX_SCENES), "dataset.json: n: input should be less than or equal to 1000000"),
        (_says(n=MAX_SCENES), "dataset.json: seed and n are not those of its options"),
        (_says(versions={}), "dataset.json: versions: does not name 'sdgen'"),
        (_says(failed={"9" * 5000: []}), f"dataset.json: failed.{'9' * 80}...: string should"),
        (_says(failed={"000009-twin": []}), "dataset.json: failed.000009-twin"),
        (_future, "format_version: '9.0' cannot be read"),
        (_key, "license: unknown key (did you mean 'licence'?)"),
    ],
)
def test_a_broken_data_set_is_located(
    tmp_path: Path, break_it: Callable[[Path], None], words: str
) -> None:
    path = toy.build(tmp_path / "d")
    break_it(path)
    with pytest.raises(InputError) as caught:
        Dataset(path)
    assert any(words in problem for problem in caught.value.problems), caught.value.problems


def test_scenes_that_are_nowhere_are_found_without_naming_all_there_could_be(
    tmp_path: Path,
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    data = json.loads((path / "dataset.json").read_text(encoding="utf-8"))
    options = {**data["options"], "n": MAX_SCENES}
    _says(n=MAX_SCENES, options=options, counts={**data["counts"], "scenes": 2})(path)
    tracemalloc.start()
    with pytest.raises(InputError, match=r"not listed: 000001, 000002, .*, 000010, \.\.\."):
        Dataset(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 10_000_000


def test_an_unfinished_build_and_no_folder_are_named(tmp_path: Path) -> None:
    with toy.open_writer(tmp_path / "d") as writer:
        toy.add_scene(writer, 0)
    with pytest.raises(InputError, match="unfinished; the same command"):
        Dataset(tmp_path / "d")
    with pytest.raises(InputError, match="no such folder"):
        Dataset(tmp_path / "none")


def test_a_missing_picture_is_located_when_it_is_read(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    (path / "scenes/000000/views/00/depth.png").unlink()
    item = Dataset(path)[0]
    assert item.rgb(0).shape == (120, 160, 3)
    with pytest.raises(InputError, match=r"scenes/000000/views/00/depth.png: no such file"):
        item.depth(0)


def test_the_catalogue_of_an_older_version_lacks_keys_and_is_read(tmp_path: Path) -> None:
    """Its digest is that of the file, not of a record that has more fields by now."""
    folder = toy.build(tmp_path / "d")
    file, info_file = folder / "catalogue.json", folder / "dataset.json"
    written = json.loads(file.read_bytes())
    for hazard in written["hazards"]:
        del hazard["evidence_pixels"]
        del hazard["evidence_outdoors"]
    file.write_text(json.dumps(written), encoding="utf-8")
    with pytest.raises(InputError, match="not the catalogue whose digest"):
        _ = Dataset(folder).catalog
    info = json.loads(info_file.read_bytes())
    info["catalogue_sha256"] = canonical_sha256(written)
    info_file.write_text(json.dumps(info), encoding="utf-8")
    assert Dataset(folder).catalog.hazard("spill").evidence_pixels == 100
    assert Dataset(folder).catalog.hazard("front_door_open").evidence_outdoors == 0
