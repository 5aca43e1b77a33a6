"""The guide's examples work, and it names every key that a file may hold."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import get_args

import pytest
import trimesh
from pydantic import BaseModel
from sdgen.catalog.activity import ActivityYaml
from sdgen.catalog.hazard_yaml import Action, HazardYaml
from sdgen.catalog.home_yaml import HomeYaml
from sdgen.catalog.load import load_catalog
from sdgen.catalog.reader import Reader
from sdgen.catalog.records import CategoryKind
from sdgen.catalog.terms import TERMS
from sdgen.catalog.world_yaml import (
    SUPERCLASSES,
    CategoryYaml,
    HouseholdYaml,
    MixYaml,
    ReachYaml,
    RoomTypeYaml,
)
from sdgen.cli.main import run
from sdgen.library import load_library
from sdgen.resources import data_path
from sdgen.strict import records_in
from sdgen.vocabulary import RELATIONS, ZONE_KINDS

from .worlds import Thing, World, on

README = data_path("hazard_catalog", "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```yaml\n# (\S+)\n(.*?)```", README, re.DOTALL)
COMMANDS = [
    line
    for block in re.findall(r"```sh\n(.*?)```", README, re.DOTALL)
    for line in block.splitlines()
    if line.startswith(("sdgen catalog", "sdgen assets"))
]


def _write_examples(folder: Path) -> None:
    for name, text in BLOCKS:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def test_the_examples_load_and_mean_what_they_say(tmp_path: Path) -> None:
    assert len(BLOCKS) == 3
    _write_examples(tmp_path)
    catalog = load_catalog([tmp_path / "my_hazards"])
    assert catalog.category("snow_globe").superclass == "Decor"
    predicate = catalog.hazard("glass_on_floor").predicate
    down = World({1: Thing("drinking_glass", related={"ON": (on(2, "floor"),)})})
    up = World({1: Thing("drinking_glass", related={"ON": (on(2, "coffee_table"),)})})
    assert predicate.evaluate(1, down).value
    assert not predicate.evaluate(1, up).value


def test_the_catalog_commands_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert len(COMMANDS) == 7
    _write_examples(tmp_path)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my_meshes").mkdir()
    globe = trimesh.creation.icosphere(subdivisions=2, radius=0.05)
    globe.export(tmp_path / "my_meshes" / "snow_globe.glb")
    for line in COMMANDS:
        assert run(shlex.split(line)[1:]) == 0, line
    told = capsys.readouterr()
    assert "Glass on the floor" in told.out
    assert "1 imported, 0 there already" in told.out
    models = load_library([tmp_path / "my_models"]).by_category("snow_globe")
    assert [model.id for model in models] == ["folder_snow_globe"]


FILES = (
    ActivityYaml,
    HazardYaml,
    HomeYaml,
    CategoryYaml,
    HouseholdYaml,
    MixYaml,
    ReachYaml,
    RoomTypeYaml,
)


def _keys(model: type[BaseModel]) -> set[str]:
    """Every key of a record and of those within it."""
    inner = [
        found for field in model.model_fields.values() for found in records_in(field.annotation)
    ]
    return set(model.model_fields).union(*map(_keys, inner))


def test_every_key_that_is_read_is_explained(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: set[str] = set()
    done = Reader.done

    def listen(reader: Reader) -> None:
        asked.update(key for key in reader.asked if not key.isspace())
        done(reader)

    monkeypatch.setattr(Reader, "done", listen)
    load_catalog()
    keys = asked.union(*(_keys(model) for model in FILES))
    assert len(keys) > 40
    # A key that is a word of Python has an underscore behind it in our records alone.
    keys = {key.removesuffix("_") for key in keys}
    missing = sorted(key for key in keys if not re.search(rf"\b{re.escape(key)}\b", README))
    assert missing == []


def test_every_word_with_a_fixed_list_is_explained() -> None:
    words = (
        *TERMS,
        *RELATIONS,
        *ZONE_KINDS,
        *get_args(Action),
        *SUPERCLASSES,
        *get_args(CategoryKind),
    )
    missing = sorted(word for word in words if not re.search(rf"\b{re.escape(word)}\b", README))
    assert missing == []
