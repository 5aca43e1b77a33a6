"""validate, stats, detect, evaluate, export and view, as a user runs them."""

import json
import tarfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from sdgen.cli.main import run

from tests import toy
from tests.edits import reseal


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d")


Captured = pytest.CaptureFixture[str]


def test_validate_says_so_when_all_is_well(sound: Path, capsys: Captured) -> None:
    assert run(["validate", str(sound)]) == 0
    assert "4 scenes checked, no problem found" in capsys.readouterr().out


def test_validate_exits_1_and_locates(tmp_path: Path, capsys: Captured) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    (path / "scenes/000001/household.json").write_text("{}")
    assert run(["validate", str(path)]) == 1
    told = capsys.readouterr()
    assert "scenes/000001/household.json: changed since it was written" in told.out
    assert "scenes/000001/household.json: missing key 'template': expected text" in told.out
    assert "problems" in told.err


def test_validate_finds_the_same_with_two_workers(tmp_path: Path, capsys: Captured) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=9))
    (path / "scenes/000001/household.json").write_text("{}")
    (path / "scenes/000005/graph.json").unlink()
    said = []
    for workers in ("1", "2"):
        assert run(["validate", str(path), "--workers", workers]) == 1
        said.append(capsys.readouterr())
    assert said[0] == said[1]


def test_validate_will_not_make_again_what_other_models_made(sound: Path, capsys: Captured) -> None:
    assert run(["validate", str(sound), "--rebuild", "1"]) == 1
    assert "assets_sha256: other models" in capsys.readouterr().out


@pytest.mark.parametrize(
    "command",
    [
        ["validate"],
        ["stats"],
        ["view"],
        ["detect", "--method", "rules", "-o", "p.jsonl"],
        ["export", "--format", "tar", "-o", "a.tar"],
        ["evaluate", "p.jsonl"],
    ],
)
def test_no_data_set_is_one_clear_error(
    tmp_path: Path, capsys: Captured, command: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("none", "."):
        assert run([command[0], name, *command[1:]]) == 1
        told = capsys.readouterr()
        lines = (told.out + told.err).strip().splitlines()
        assert any("no such folder" in line or "no data set" in line for line in lines)
        assert "Traceback" not in told.out + told.err
    assert list(tmp_path.iterdir()) == []


def test_stats_as_table_and_json(sound: Path, capsys: Captured) -> None:
    assert run(["stats", str(sound)]) == 0
    assert "anomalies, stove_on" in capsys.readouterr().out
    assert run(["stats", str(sound), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["scenes"] == 4
    assert told["anomalies_by_hazard"]["stove_on"] == 3
    assert told["anomalies_by_hazard"]["spill"] == 0
    assert told["scenes_by_split"] == {"test": 1, "train": 2, "val": 1}
    assert told["distributions"]["names"]["anomalies_by_hazard"]["counts"]["stove_on"] == 3


def test_stats_draws_what_it_prints(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    picture = tmp_path / "s.svg"
    assert run(["stats", str(sound), "--plot", str(picture)]) == 0
    assert "height at which an anomaly stands, m" in capsys.readouterr().out
    assert "anomalies by room" in picture.read_text(encoding="utf-8")
    assert run(["stats", str(sound), "--plot", str(sound / "dataset.json")]) == 1
    assert "belongs to the data set" in capsys.readouterr().err


def test_detect_then_evaluate(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "p.jsonl"
    assert run(["detect", str(sound), "--method", "rules", "-o", str(path)]) == 0
    assert len(path.read_text(encoding="utf-8").splitlines()) == 4
    assert run(["evaluate", str(sound), str(path)]) == 0
    assert "1.000 ± 0.000" in capsys.readouterr().out
    assert run(["evaluate", str(sound), str(path), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert set(told) >= {
        "AS",
        "CAS",
        "unwanted_per_scene",
        "false_alarms_per_scene",
        "precision",
        "recall",
        "f1",
        "label_accuracy",
        "recall_by_hazard",
    }
    assert told["AS"] == {"mean": 1.0, "se": 0.0, "n": 3, "low": 1.0, "high": 1.0}
    assert told["CAS"]["mean"] == 1.0


def test_evaluate_tells_all_bad_lines(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "p.jsonl"
    path.write_text('x\n{"scene": "1", "reports": []}\n')
    assert run(["evaluate", str(sound), str(path)]) == 1
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 2
    assert told[0].startswith(f"error: {path}:1: not JSON")


@pytest.mark.parametrize(
    "command",
    [
        ["detect", "--method", "rulez", "-o", "p"],
        ["detect", "--method", "rules"],
        ["export", "--format", "zip", "-o", "a.zip"],
        ["export"],
        ["validate", "--rebuild", "-1"],
        ["view", "--serve", "-o", "x"],
    ],
)
def test_usage_errors_exit_2(sound: Path, command: list[str]) -> None:
    assert run([command[0], str(sound), *command[1:]]) == 2


def _no_models(path: Path) -> None:
    (path / "assets.jsonl").write_bytes(b"")


def _no_rooms(path: Path) -> None:
    _edit(path / "scenes/000001/scene.json", lambda data: data["home"].update(rooms=[]))


def _flat_room(path: Path) -> None:
    def flatten(data: dict[str, Any]) -> None:
        data["home"]["rooms"][0]["polygon_m"] = [[0, 0]]

    _edit(path / "scenes/000001/scene.json", flatten)


def _no_such_hazard(path: Path) -> None:
    _edit(
        path / "scenes/000001/anomalies.json",
        lambda data: data["anomalies"][0].update(hazard="stove_off"),
    )


def _edit(path: Path, change: Callable[[dict[str, Any]], None]) -> None:
    data = json.loads(path.read_text(encoding="utf-8"))
    change(data)
    path.write_text(json.dumps(data), encoding="utf-8")


@pytest.mark.parametrize(
    ("damage", "command", "words"),
    [
        (_no_models, "detect", "object 11: asset: 'stove_01' is not in assets.jsonl"),
        (_no_rooms, "detect", "room_id: scene.json has no room 100"),
        (_flat_room, "detect", "scenes/000001/scene.json: cannot be evaluated"),
        (_no_such_hazard, "evaluate", "no hazard 'stove_off'"),
    ],
)
def test_files_that_disagree_are_located(
    tmp_path: Path, capsys: Captured, damage: Callable[[Path], None], command: str, words: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    damage(path)
    reseal(path)
    (tmp_path / "p.jsonl").write_text("")
    out = tmp_path / "out.jsonl"
    more = (
        ["--method", "rules", "-o", str(out)]
        if command == "detect"
        else [str(tmp_path / "p.jsonl")]
    )
    assert run([command, str(path), *more]) == 1
    told = capsys.readouterr().err
    assert words in told
    assert "bug in sdgen" not in told
    assert not out.exists()


def test_export_writes_a_tar(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    assert run(["export", str(sound), "--format", "tar", "-o", str(tmp_path / "a.tar.gz")]) == 0
    assert "kB" in capsys.readouterr().out
    with tarfile.open(tmp_path / "a.tar.gz") as archive:
        assert "sdgen-n4-s7/dataset.json" in archive.getnames()


def test_view_prints_where_the_page_is(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    assert run(["view", str(sound), "-o", str(tmp_path / "page"), "--limit", "2"]) == 0
    told = capsys.readouterr()
    assert told.out.strip() == str((tmp_path / "page" / "index.html").resolve())
    assert "first 2 of 4" in told.err
    assert (tmp_path / "page/000001/index.html").is_file()


def test_a_split_is_shown_alone(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "p.jsonl"
    assert run(["detect", str(sound), "--method", "never", "-o", str(path), "--split", "val"]) == 0
    assert len(path.read_text(encoding="utf-8").splitlines()) == 1
    assert run(["evaluate", str(sound), str(path), "--split", "vall"]) == 1
    assert "did you mean 'val'" in capsys.readouterr().err


def test_choices_of_the_commands_are_those_of_the_registries() -> None:
    from sdgen.benchmark import DETECTORS
    from sdgen.cli.detect import METHODS
    from sdgen.cli.export import FORMATS as OFFERED
    from sdgen.export import FORMATS

    assert tuple(METHODS) == tuple(DETECTORS)
    assert tuple(OFFERED) == tuple(FORMATS)
