"""Models that a data set says it was built with, and those that are there."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.library.records import AssetInfo
from sdgen.truth.graph import opaque_name
from sdgen.validate import rebuild, validate
from sdgen.validate.physics import check_physics

from tests import toy
from tests.edits import edit_json, reseal

Captured = pytest.CaptureFixture[str]


@dataclass(frozen=True)
class AtHand:
    """The library that the toy data sets name."""

    infos: dict[str, AssetInfo]
    sha256: str = toy.ASSETS_SHA256


def _edit_models(path: Path, change: Callable[[dict[str, Any]], None]) -> None:
    models = [json.loads(line) for line in (path / "assets.jsonl").read_text().splitlines()]
    for model in models:
        change(model)
    models.sort(key=lambda model: str(model["id"]))
    lines = [json.dumps(model) for model in models]
    (path / "assets.jsonl").write_text("\n".join(lines) + "\n")


def _renamed(value: Any) -> Any:
    text = json.dumps(value)
    for called in (str, opaque_name):
        text = text.replace(f'"{called("cushion_01")}"', f'"{called("cushion_77")}"')
    return json.loads(text)


def test_a_model_renamed_everywhere_is_none_that_can_be_loaded(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    _edit_models(path, lambda model: model.update(_renamed(model)))
    for file in ("scene.json", "graph.json"):
        edit_json(path / "scenes/000000" / file, lambda data: data.update(_renamed(data)))
    reseal(path)
    assert validate(path) == []  # nothing in the files alone can tell
    data, library = Dataset(path), AtHand(toy.infos())
    text = "assets.jsonl: model cushion_77: not in the library that assets_sha256 names"
    problems, stood = check_physics(data, library)  # type: ignore[arg-type]
    assert ([problem.text for problem in problems], stood) == ([text], 0)
    problems, _, made = rebuild(data, library, 1)  # type: ignore[arg-type]
    assert ([problem.text for problem in problems], made) == ([text], 0)


def test_a_record_that_is_not_the_models_is_named_with_what_differs(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))

    def heavier(model: dict[str, Any]) -> None:
        if model["id"] == "cushion_01":
            model["mass_kg"] = 2.0

    _edit_models(path, heavier)
    assert validate(path) == []
    problems, stood = check_physics(Dataset(path), AtHand(toy.infos()))  # type: ignore[arg-type]
    assert stood == 0
    (text,) = [problem.text for problem in problems]
    assert text == "assets.jsonl: model cushion_01: mass_kg: 2.0 stored, 1.0 derived"


@pytest.mark.parametrize(
    "option", [["--physics"], ["--rebuild", "3"], ["--physics", "--rebuild", "3"]]
)
def test_nothing_is_counted_that_was_not_done(
    tmp_path: Path, capsys: Captured, option: list[str]
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=3, sensors=()))
    assert run(["validate", str(path), *option, "--json"]) == 1
    told = json.loads(capsys.readouterr().out)
    assert (told["let_stand"], told["made_again"]) == (0, 0)
    assert run(["validate", str(path), *option]) == 1
    told = capsys.readouterr().err
    assert ("nothing was let stand" in told) is ("--physics" in option)
    assert ("nothing was made again" in told) is ("--rebuild" in option)


def test_what_is_skipped_for_a_broken_file_is_said(tmp_path: Path, capsys: Captured) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    (path / "scenes/000000/household.json").write_text("{}")
    assert run(["validate", str(path), "--physics"]) == 1
    assert capsys.readouterr().err.endswith("problems; nothing was let stand\n")
