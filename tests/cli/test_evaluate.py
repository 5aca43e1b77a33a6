"""sdgen evaluate with all its options, as a user runs it."""

import json
from pathlib import Path

import pytest
from sdgen.benchmark import detect, write_predictions
from sdgen.cli.main import run
from sdgen.dataset import Dataset

from tests import toy

Captured = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=4)
    data = Dataset(path)
    for name in ("rules", "always"):
        write_predictions(path.parent / f"{name}.jsonl", detect(data, name, twins=True))
    return path


def call(sound: Path, *words: str) -> int:
    files = [str(sound.parent / word) if word.endswith(".jsonl") else word for word in words]
    return run(["evaluate", str(sound), *files])


def test_several_files_are_columns_and_compared(sound: Path, capsys: Captured) -> None:
    assert call(sound, "rules.jsonl", "always.jsonl", "--base-rate", "0.05") == 0
    out = capsys.readouterr().out
    assert "always minus rules" in out
    assert "5 % of homes with a hazard" in out
    assert "twins told apart" in out


def test_json_of_several_has_an_evaluation_by_name(sound: Path, capsys: Captured) -> None:
    words = ["rules.jsonl", "always.jsonl", "--name", "a", "--name", "b"]
    assert call(sound, *words, "--json", "--base-rate", "0.1") == 0
    told = json.loads(capsys.readouterr().out)
    assert list(told) == ["a", "b"]
    assert told["a"]["AS"]["mean"] == 1
    assert told["a"]["base_rates"]["hazard_share"] == 0.1
    assert "compared" not in told["a"]
    assert told["b"]["compared"]["baseline"] == "a"
    assert told["b"]["compared"]["differences"]["AS"]["p"] == 1


def test_all_files_are_written(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    words = ["--items", str(tmp_path / "i.csv"), "--plot", str(tmp_path / "p.svg")]
    words += ["--report", str(tmp_path / "r"), "--worst", "1"]
    assert call(sound, "always.jsonl", *words, "--quiet") == 0
    assert capsys.readouterr().err == ""
    assert {one.name for one in tmp_path.iterdir()} == {"i.csv", "p.svg", "r"}


def test_costs_change_what_mistakes_cost(sound: Path, tmp_path: Path, capsys: Captured) -> None:
    costs = tmp_path / "c.yaml"
    costs.write_text("false_alarm_now: 0\nunwanted_now: 0\nearly: 0\n")
    assert call(sound, "always.jsonl", "--costs", str(costs), "--json") == 0
    told = json.loads(capsys.readouterr().out)["base_rates"]
    assert told["cost_per_home_day"]["detector"]["mean"] == 0
    costs.write_text("false_alarm: 0\n")
    assert call(sound, "always.jsonl", "--costs", str(costs)) == 1
    assert f"error: {costs}:1: false_alarm: unknown key" in capsys.readouterr().err


def test_lenient_counts_what_it_skips(sound: Path, capsys: Captured) -> None:
    path = sound.parent / "llm.jsonl"
    path.write_text(
        'sorry\n{"scene": "000001", "reports": [{"object_id": 9, "label": "unsafe"}]}\n'
    )
    assert call(sound, "llm.jsonl") == 1
    assert "llm.jsonl:1: not JSON" in capsys.readouterr().err
    assert call(sound, "llm.jsonl", "--lenient", "--json") == 0
    told = capsys.readouterr()
    assert json.loads(told.out)["skipped"]["broken_lines"] == 1
    assert json.loads(told.out)["false_alarms_per_scene"]["mean"] == 0.25
    assert told.err.splitlines() == [
        f"{path}: 1 line that is no prediction was skipped",
        f"{path}: 1 report of an object that does not exist counts as false alarm",
        f"{path}: no line for 3 of 4 scenes, which counts as silence",
    ]


def test_a_number_that_is_none_costs_its_report_alone(sound: Path, capsys: Captured) -> None:
    path = sound.parent / "nan.jsonl"
    bad = '{"object_id": 8, "label": "unsafe", "score": NaN}'
    good = '{"object_id": 9, "label": "unsafe"}'
    path.write_text(f'{{"scene": "000001", "reports": [{bad}, {good}]}}\n')
    assert call(sound, "nan.jsonl") == 1
    assert "nan.jsonl:1" in capsys.readouterr().err
    assert call(sound, "nan.jsonl", "--lenient", "--json") == 0
    told = json.loads(capsys.readouterr().out)
    assert told["skipped"]["bad_reports"] == 1
    assert told["skipped"]["broken_lines"] == 0
    assert told["false_alarms_per_scene"]["mean"] == 0.25


@pytest.mark.parametrize(
    "words",
    [
        ["--items", "in.jsonl"],
        ["--plot", "one.svg", "--report", "one.svg"],
        ["--report", "folder", "--items", "folder/items.csv"],
        ["--costs", "costs.csv", "--items", "costs.csv"],
    ],
)
def test_nothing_is_written_over_what_is_read_or_within_another(
    sound: Path, tmp_path: Path, capsys: Captured, words: list[str]
) -> None:
    (tmp_path / "in.jsonl").write_bytes((sound.parent / "rules.jsonl").read_bytes())
    (tmp_path / "costs.csv").write_text("late: 3")
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    told = [word if word.startswith("--") else str(tmp_path / word) for word in words]
    assert run(["evaluate", str(sound), str(tmp_path / "in.jsonl"), *told]) == 1
    assert "choose another place" in capsys.readouterr().err
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["rules.jsonl", "rules.jsonl"], 2, "several files have one name"),
        (["rules.jsonl", "--name", "a", "--name", "b"], 2, "--name was given 2 times for 1 files"),
        (["rules.jsonl", "--base-rate", "5"], 2, "between 0 and 1, not at 5"),
        (["rules.jsonl", "--items", "i.txt"], 2, "items are written as .jsonl or .csv"),
        (["rules.jsonl", "--plot", "p.png"], 2, "the picture is an SVG"),
        (["rules.jsonl", "--base-rate", "0.1", "--inspections", "nan"], 2, "nan inspections a day"),
        (["rules.jsonl", "--inspections", "2"], 2, "--inspections goes with --base-rate"),
        (["rules.jsonl", "--worst", "2"], 2, "--worst goes with --report"),
        (["rules.jsonl", "--report", "r", "--gallery", "nowhere"], 2, "nowhere: no such folder"),
        (["rules.jsonl", "--name", " "], 2, "a name of nothing"),
        ([], 2, "Missing argument"),
    ],
)
def test_what_makes_no_sense_is_one_clear_error(
    sound: Path, capsys: Captured, words: list[str], code: int, told: str
) -> None:
    assert call(sound, *words) == code
    assert told in capsys.readouterr().err


def test_homes_of_one_kind_have_no_base_rate_but_a_plot(tmp_path: Path, capsys: Captured) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    (tmp_path / "p.jsonl").write_text("")
    words = ["evaluate", str(path), str(tmp_path / "p.jsonl")]
    assert run([*words, "--plot", str(tmp_path / "p.svg")]) == 0
    assert run([*words, "--base-rate", "0.05"]) == 2
    assert "none here is with a hazard" in capsys.readouterr().err
