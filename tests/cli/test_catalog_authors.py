"""Commands of those who write hazards: new, categories, test."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from sdgen.cli.main import run
from sdgen.engines import trials
from sdgen.engines.trials import Trials, Tried
from sdgen.rejection import reject


def told(capsys: pytest.CaptureFixture[str], *args: object) -> tuple[int, str, str]:
    code = run(["catalog", *map(str, args)])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.fixture
def tried(monkeypatch: pytest.MonkeyPatch) -> list[Trials]:
    """Every trial asked for; of each hazard the first anomaly does not fit."""
    asked: list[Trials] = []

    def try_all(some: Trials, *_: Any) -> list[Tried]:
        asked.append(some)
        cause = reject("hazards", "no_place", hazard="x").cause
        missed = Tried(some.unique[0], None, 2, 40, Counter({cause: 40}))
        return [missed, *(Tried(one, "flat", 1, 1) for one in some.unique[1:])]

    monkeypatch.setattr(trials, "try_all", try_all)
    return asked


def test_new_writes_what_it_says_and_nothing_over(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "mine"
    code, text, _ = told(capsys, "new", "glass_left", "-o", out)
    assert code == 0
    assert f"sdgen catalog validate {out}" in text
    assert "--only glass_left" in text
    file = out / "hazards" / "glass_left.yaml"
    file.write_text("mine now")
    code, _, err = told(capsys, "new", "glass_left", "--kind", "set", "-o", out)
    assert code == 1
    assert f"{file}: is there already" in err
    assert file.read_text() == "mine now"
    file.rename(file.with_suffix(".yml"))
    assert told(capsys, "new", "glass_left", "-o", out)[0] == 1
    # A second one goes beside it.
    assert told(capsys, "new", "dish_left", "--kind", "set", "-o", out)[0] == 0
    assert sorted(path.name for path in out.iterdir()) == ["README.md", "hazards"]


@pytest.mark.parametrize("name", ["Glass", "spill", "heat", "tap_on"])
def test_new_refuses_names_and_writes_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    code, _, err = told(capsys, "new", name, "-o", tmp_path / "mine")
    assert (code, err.count("\n")) == (2, 1)
    assert list(tmp_path.iterdir()) == []


def test_categories_by_word(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = told(capsys, "categories", "--name", "stove", "--json")
    assert code == 0
    (stove,) = json.loads(out)
    assert stove["name"] == "stove"
    assert stove["on"]
    assert "oven" in stove["inside"]
    assert "kitchen" in told(capsys, "categories", "--name", "stove")[1]


def test_test_fails_when_too_few_fit_and_names_them(
    tried: list[Trials], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ("test", "--hazard", "fridge_open", "--out", tmp_path / "page", "--no-pictures")
    code, out, _ = told(capsys, *asked)
    assert code == 3
    assert (
        "does not fit: fridge_open: AJAR freezer (kitchen): 40 tries in 2 homes: no place x40"
        in out
    )
    report = json.loads((tmp_path / "page" / "report.json").read_text())
    assert report["tried"] - report["fit"] == 1
    assert report["by_hazard"]["fridge_open"]["tried"] == report["tried"]
    assert "no place x40" in (tmp_path / "page" / "index.html").read_text()
    assert tried[0].choice is None
    assert told(capsys, *asked, "--least", "10")[0] == 0


def test_test_tries_what_paths_add_or_all(
    tried: list[Trials], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    told(capsys, "new", "glass_left", "-o", tmp_path / "mine")
    told(capsys, "test", tmp_path / "mine")
    assert {one.hazard for one in tried[0].unique} == {"glass_left"}
    told(capsys, "test", "--extensions", "water")
    assert {one.hazard for one in tried[1].unique} >= {"tap_on", "full_bath"}
    assert "spill" not in {one.hazard for one in tried[1].unique}
    told(capsys, "test", "--limit", "100")
    assert len(tried[2].unique) == 100
    assert len({one.hazard for one in tried[2].unique}) >= 9
    code, _, err = told(capsys, "test", "--hazard", "spil")
    assert (code, err) == (2, "error: no hazard 'spil' (did you mean 'spill'?)\n")


def test_test_takes_no_folder_that_holds_something_else(
    tried: list[Trials], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "letter.txt").write_text("dear")
    code, _, err = told(capsys, "test", "--hazard", "spill", "--out", tmp_path, "--no-pictures")
    assert code == 1
    assert "is not empty" in err
    assert tried == []
