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
    assert "always less rules" in out
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
    ]


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (["rules.jsonl", "rules.jsonl"], 2, "several files have one name"),
        (["rules.jsonl", "--name", "a", "--name", "b"], 2, "--name was given 2 times for 1 files"),
        (["rules.jsonl", "--base-rate", "5"], 2, "between 0 and 1, not at 5"),
        (["rules.jsonl", "--items", "i.txt"], 2, "items are written as .jsonl or .csv"),
        (["rules.jsonl", "--plot", "p.png"], 2, "the picture is an SVG"),
        (["rules.jsonl", "--base-rate", "0.1", "--inspections", "nan"], 2, "nan inspections a day"),
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
