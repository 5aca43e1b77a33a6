"""``sdgen catalog``: the shapes INTERFACE promises, and clear errors."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from sdgen.catalog.load import load_catalog
from sdgen.cli.catalog import catalog
from sdgen.cli.main import run
from sdgen.resources import data_path

from tests.engines.worlds import write_hazard

from .worlds import HAZARD, write


def call(*words: str) -> Result:
    return CliRunner().invoke(catalog, list(words), catch_exceptions=False)


def test_list_as_json() -> None:
    rows = json.loads(call("list", "--json").output)
    assert [set(row) for row in rows] == [
        {"id", "title", "group", "label", "unique_anomalies"} for _ in rows
    ]
    assert [row["id"] for row in rows] == [hazard.id for hazard in load_catalog().hazards]
    assert all(row["unique_anomalies"] > 0 for row in rows)


def test_list_for_people() -> None:
    lines = call("list").output.splitlines()
    assert len(lines) == len(load_catalog().hazards) + 1
    assert any("stove_on" in line and "Stove left on" in line for line in lines)


def test_enumerate() -> None:
    rows = json.loads(call("enumerate", "--json").output)
    assert all(
        set(row) == {"hazard", "category", "state", "relation", "target", "room"} for row in rows
    )
    counted = sum(row["unique_anomalies"] for row in json.loads(call("list", "--json").output))
    assert len(rows) == counted
    assert call("enumerate").output.splitlines()[-1] == f"{counted} unique anomalies"


def test_show(capsys: pytest.CaptureFixture[str]) -> None:
    text = call("show", "sharp_object").output
    for word in ("households with a child up to 8", "handsaw ON floor", "at most 1.44 m"):
        assert word in text
    shown = json.loads(call("show", "stove_on", "--json").output)
    assert shown["predicate"]["kind"] == "all"
    assert run(["catalog", "show", "stove_of"]) == 2
    error = capsys.readouterr().err
    assert error == "error: no hazard 'stove_of' (did you mean 'stove_on'?)\n"


def test_show_says_what_a_recipe_is_to_be_near(tmp_path: Path) -> None:
    folder = write(
        tmp_path,
        hazards__wobbly_vase=HAZARD.replace(
            "target: coffee_table",
            "target: floor, zone: walkway, across: true, before: {of: door, max_m: 0.5}, "
            "near: {to: stove, to_state: 'ON', max_m: 0.3, bring: true}",
        ),
    )
    text = call("show", "wobbly_vase", "--catalog", str(folder)).output
    assert (
        "vase ON floor across a walkway within 0.3 m of on stove, which it brings along "
        "at most 0.5 m before a door"
    ) in text


def test_an_extra_folder_is_listed(tmp_path: Path) -> None:
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD)
    rows = json.loads(call("list", "--json", "--catalog", str(folder)).output)
    assert "wobbly_vase" in [row["id"] for row in rows]


def test_validate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("validate", str(data_path("hazard_catalog"))).output.startswith("good: ")
    folder = write(tmp_path, hazards__wobbly_vase=HAZARD)
    assert call("validate", str(folder)).output.startswith("good: ")
    write(folder, hazards__wobbly_vase=HAZARD.replace("category: vase", "state: on"))
    assert run(["catalog", "validate", str(folder)]) == 1
    error = capsys.readouterr().err
    assert f"error: {folder}/hazards/wobbly_vase.yaml:9: predicate.state: 'on' is not a" in error
    assert "Traceback" not in error
    assert run(["catalog", "validate", str(tmp_path / "none")]) == 1
    assert "no such file" in capsys.readouterr().err


def test_validate_asks_the_models_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = HAZARD.replace("{place: vase,", "{place: vase, state: UPSIDE_DOWN,")
    folder = write(tmp_path, hazards__wobbly_vase=text)
    assert run(["catalog", "validate", str(folder)]) == 1
    assert "no model of vase can be UPSIDE_DOWN" in capsys.readouterr().err


#: A hazard of one's own, sound as far as reading goes: but medicine there is poison_medication.
BY_THE_BED = (
    HAZARD.replace("category: vase\n  relation: ON", "category: [medicine_bottle, vase]")
    .replace("predicate:\n", "predicate:\n  relation: ON\n  target: TARGET\n")
    .replace(
        "place: vase, relation: ON, target: coffee_table",
        "place: THING, relation: ON, target: TARGET",
    )
)


@pytest.mark.parametrize(
    ("thing", "target", "code", "told"),
    [
        ("medicine_bottle", "nightstand", 0, "'wobbly_vase' overlaps 'poison_medication': "),
        ("vase", "coaster", 1, "'wobbly_vase' fits nowhere: "),
    ],
    ids=["another hazard too", "no place"],
)
def test_validate_tries_what_it_has_read(
    thing: str,
    target: str,
    code: int,
    told: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """What a build would find out in its first minutes is said when a catalogue is checked."""
    folder = write(
        tmp_path,
        hazards__wobbly_vase=BY_THE_BED.replace("THING", thing).replace("TARGET", target),
    )
    assert run(["catalog", "validate", str(folder)]) == code
    output = capsys.readouterr()
    assert ("good" in output.out) == (code == 0)
    assert [told in line for line in output.err.splitlines()] == [True]


@pytest.mark.parametrize(
    ("predicate", "anomaly", "code", "told"),
    [
        (
            "{category: door, state: OPEN, relation: BETWEEN, target: bathroom}",
            "{set: door, state: OPEN, rooms: bathroom}",
            1,
            "error: hazard 'mine' is true of furniture (door) in ",
        ),
        (
            "{category: floor_lamp, state: ON}",
            "{set: floor_lamp, state: ON}",
            0,
            "warning: hazard 'mine' is true of furniture (floor_lamp) in ",
        ),
    ],
    ids=["most homes", "some homes"],
)
def test_validate_says_what_is_true_of_homes_as_they_stand(
    predicate: str,
    anomaly: str,
    code: int,
    told: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = write_hazard(tmp_path, predicate, anomaly)
    assert run(["catalog", "validate", str(folder)]) == code
    output = capsys.readouterr()
    assert ("good: " in output.out) == (code == 0)
    assert output.err.startswith(told)


def test_every_subcommand_has_help_with_an_example() -> None:
    for name in ("list", "show", "enumerate", "validate", "propose"):
        assert f"Example: sdgen catalog {name}" in " ".join(call(name, "--help").output.split())
