"""Labels against another catalogue: what it would label otherwise is told, pair by pair."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import pytest
from sdgen.catalog.records import Catalog
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.validate.recertify import recertify

from tests import toy


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build_with_twins(tmp_path_factory.mktemp("toy") / "d", 4), partial=True)


def labels(data: Dataset, hazard: str) -> int:
    return sum(entry.hazards.get(hazard, 0) for entry in data.entries)


def without(catalog: Catalog, *names: str) -> Catalog:
    kept = tuple(hazard for hazard in catalog.hazards if hazard.id not in names)
    return catalog.model_copy(update={"hazards": kept})


def test_its_own_catalogue_certifies_it(data: Dataset) -> None:
    found = recertify(data, data.catalog)
    assert found.certifies
    assert found.scenes == len(data.entries)
    assert found.kept == sum((Counter(entry.hazards) for entry in data.entries), Counter())
    assert (found.redefined, found.foreign) == ((), Counter())


def test_labels_of_a_hazard_that_is_gone_are_lost(data: Dataset) -> None:
    found = recertify(data, without(data.catalog, "stove_on"))
    assert len(found.changed) == labels(data, "stove_on") > 0
    assert {(one.hazard, one.change) for one in found.changed} == {("stove_on", "lost")}
    assert found.by_hazard()["stove_on"] == {
        "kept": 0,
        "lost": labels(data, "stove_on"),
        "new": 0,
        "undecided": 0,
    }
    assert "stove_on: is labelled and does not hold" in str(found.changed[0])
    assert not found.certifies


def test_what_holds_unlabelled_is_new(data: Dataset) -> None:
    catalog = data.catalog
    hazard = catalog.hazard("stove_on").model_copy(update={"id": "burning"})
    found = recertify(data, catalog.model_copy(update={"hazards": (*catalog.hazards, hazard)}))
    assert {(one.hazard, one.change) for one in found.changed} == {("burning", "new")}
    assert len(found.changed) == labels(data, "stove_on")


def test_categories_that_it_does_not_define_are_told(data: Dataset) -> None:
    catalog = data.catalog
    kept = tuple(one for one in catalog.categories if one.name != "knife")
    found = recertify(data, catalog.model_copy(update={"categories": kept}))
    assert set(found.foreign) == {"knife"}
    assert not found.certifies
    bare = tuple(
        one.model_copy(update={"properties": ()}) if one.name == "stove" else one
        for one in catalog.categories
    )
    found = recertify(data, catalog.model_copy(update={"categories": bare}))
    assert found.redefined == ("stove",)


def test_a_scene_that_cannot_be_read_is_a_problem(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 2)
    (path / "scenes" / "000001" / "scene.json").write_text("{")
    found = recertify(Dataset(path, partial=True), toy.catalog())
    assert not found.certifies
    (problem, *_) = found.problems
    assert problem.startswith("scenes/000001/scene.json")


def test_the_command_tells_and_counts(
    data: Dataset, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hazard = tmp_path / "mine" / "hazards" / "burning.yaml"
    hazard.parent.mkdir(parents=True)
    hazard.write_text(
        "id: burning\ntitle: A fire\ngroup: safety\nconcerns: {who: everyone}\n"
        "urgency: low\nmessage: A {object} in the {room}.\nsource: a test\n"
        "predicate: {category: stove, state: ON}\n"
        "anomalies: [{set: stove, state: ON}]\nremedy: [{action: switch_off}]\n"
    )
    command = ["validate", str(data.path), "--catalog", str(tmp_path / "mine")]
    assert run(command) == 1
    out = capsys.readouterr().out
    assert "(stove), burning: holds and is not labelled" in out
    assert "hold unlabelled" in out
    assert "not certified" in out
    assert run([*command, "--json"]) == 1
    record = json.loads(capsys.readouterr().out)
    assert record["by_hazard"]["burning"]["new"] > 0
    assert {one["change"] for one in record["changed"] if one["hazard"] == "burning"} == {"new"}
    assert run([*command, "--physics"]) == 2
    assert run(["validate", str(data.path), "--extensions", "het"]) == 1
    assert "did you mean 'heat'" in capsys.readouterr().err
