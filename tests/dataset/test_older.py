"""A data set of the format version before stays readable: one that sdgen 0.1 wrote is kept."""

import json
import tarfile
from pathlib import Path

import numpy as np
import pytest
from sdgen.benchmark import detect, evaluate
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.dataset.older import asset_as_now, catalogue_as_now, info_as_now, physics_as_now
from sdgen.export import export
from sdgen.validate import validate

KEPT = Path(__file__).resolve().parent.parent / "data" / "format-1.0.tar.gz"
SAFE = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("kept")
    with tarfile.open(KEPT) as archive:
        archive.extractall(folder, **SAFE)
    (found,) = folder.iterdir()
    return found


def test_every_record_and_picture_is_read(path: Path) -> None:
    data = Dataset(path)
    assert data.info.format_version == "1.0"
    assert len(data) == len(Dataset(path, twins=True)) == 2
    assert data.catalog.households[0].members[0].age[0] >= 0
    for item in data:
        assert item.anomalies.anomalies
        assert item.physics.settled_drift_m
        assert item.household.members
        assert len(item.cameras) == 2
        for view in range(2):
            seen = {o.object_id for o in item.visibility.views[view].objects}
            assert seen <= set(np.unique(item.instance(view)).tolist())
            assert item.rgb(view).shape == (72, 96, 3)
        assert {thing.asset for thing in item.scene.objects} <= set(data.infos)
        assert item.graph.number_of_nodes() == len(item.scene_graph.nodes)
    assert len(data.anomalies) == data.info.counts.anomalies


def test_the_rules_find_what_is_labelled(path: Path) -> None:
    data = Dataset(path)
    score = evaluate(data, detect(data, "rules"))
    assert (score.AS.mean, score.false_alarms_per_scene.mean) == (1.0, 0.0)


def test_validate_checks_its_files_and_says_what_it_leaves(
    path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["validate", str(path)]) == 0
    said = capsys.readouterr()
    assert "no problem found" in said.out
    assert "format 1.0: its labels were not derived again" in said.err


def test_a_flipped_byte_is_found_there_too(path: Path, tmp_path: Path) -> None:
    import shutil

    copied = Path(shutil.copytree(path, tmp_path / "d"))
    picture = copied / "scenes/000000/views/00/depth.png"
    raw = bytearray(picture.read_bytes())
    raw[60] ^= 1
    picture.write_bytes(raw)
    assert "scenes/000000/views/00/depth.png: changed since it was written" in [
        problem.text for problem in validate(copied)
    ]


@pytest.mark.parametrize("command", [["stats"], ["stats", "--json"], ["view", "-o", "page"]])
def test_commands_work_on_it(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run([command[0], str(path), *command[1:]]) == 0


@pytest.mark.parametrize("name", ["tar", "webdataset"])
def test_it_can_be_exported(path: Path, tmp_path: Path, name: str) -> None:
    export(Dataset(path), name, tmp_path / ("x.tar" if name == "tar" else "x"))


def test_a_build_does_not_go_on_with_it(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["build", "--n", "3", "--seed", "5", "--out", str(path)]) == 1
    assert "built with format 1.0 (now 1.1)" in capsys.readouterr().err


@pytest.mark.parametrize(
    "value",
    [
        None,
        3,
        [],
        {},
        {"households": 3},
        {"households": [3, {}]},
        {"outline_m": 3, "parts": []},
        {"failed": 3},
        {"rejections": []},
    ],
)
def test_odd_values_are_left_to_the_reader_that_names_them(value: object) -> None:
    before = json.dumps(value)
    catalogue_as_now(value, "1.0")
    asset_as_now(value, "1.0")
    info_as_now(value)
    physics_as_now(value)
    assert json.dumps(value) == before
