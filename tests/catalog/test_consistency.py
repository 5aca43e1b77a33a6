"""Recipes and predicates that contradict one another are told before a build."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.cases import cases
from sdgen.catalog.load import load_catalog
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.records import PlaceRecipe, SetRecipe
from sdgen.catalog.terms import Predicate
from sdgen.catalog.terms.term import Can
from sdgen.yaml_source import parse_yaml

from .worlds import HAZARD, problems, write

CATEGORIES = {"knife", "floor", "desk", "stove"}


def predicate(text: str) -> Predicate:
    source = parse_yaml(text.encode(), "p.yaml")
    found = read_predicate(source, (), source.value, CATEGORIES, {"kitchen", "hall"})
    assert source.problems == []
    return found


def place(target: str = "desk", **fields: object) -> PlaceRecipe:
    values = {"categories": ("knife",), "relation": "ON", "targets": (target,), **fields}
    return PlaceRecipe.model_validate(values)


YES, NO, EITHER = Can(True, False), Can(False, True), Can(True, True)


@pytest.mark.parametrize(
    ("text", "recipe", "wanted"),
    [
        ("category: knife", place(), YES),
        ("category: stove", place(), NO),
        ("not: {category: stove}", place(), YES),
        ("relation: ON", place(), YES),
        ("{relation: ON, target: floor}", place(), NO),
        ("{relation: ON, target: floor}", place("floor"), YES),
        ("{relation: ON, target: desk, target_state: OPEN}", place(), EITHER),
        ("{relation: INSIDE, target: desk}", place(), EITHER),
        ("{category: knife, not: {relation: INSIDE}}", place(), EITHER),
        ("room: hall", place(), EITHER),
        ("room: hall", place(rooms=("kitchen",)), NO),
        ("height: {max_m: 1.3}", place(), EITHER),
        ("height: {max_m: 1.3}", place(min_height_m=1.5), NO),
        ("height: {min_m: 0.5}", place("floor"), NO),
        ("zone: doorway", place("floor", zone=("doorway",)), YES),
        ("zone: doorway", place("floor", zone=("doorway", "walkway")), EITHER),
        ("zone: doorway", place("floor", avoid_zones=("doorway",)), NO),
        # 99 % of a footprint is kept in the zones asked for, 20 % may reach into those avoided.
        (
            "zone: {kind: doorway, overlap: 0.97, margin: 0.03}",
            place("floor", zone=("doorway",)),
            EITHER,
        ),
        (
            "zone: {kind: doorway, overlap: 0.6, margin: 0.1}",
            place("floor", zone=("doorway",)),
            YES,
        ),
        (
            "zone: {kind: doorway, overlap: 0.1, margin: 0.05}",
            place("floor", avoid_zones=("doorway",)),
            EITHER,
        ),
        (
            "zone: {kind: doorway, overlap: 0.3, margin: 0.1}",
            place("floor", avoid_zones=("doorway",)),
            NO,
        ),
        # 35 % in the one and 35 % in the other is 70 % in both together.
        ("zone: [doorway, walkway]", place("floor", zone=("doorway", "walkway")), YES),
        # Nothing looks at zones on furniture.
        ("zone: doorway", place("desk", avoid_zones=("doorway",)), EITHER),
        ("distance: {to: stove, max_m: 1}", place(), EITHER),
        ("any: [{category: stove}, {relation: ON}]", place(), YES),
        ("{category: knife, height: {max_m: 1}}", place(), EITHER),
        ("state: ON", SetRecipe(categories=("knife",), state="ON"), YES),
        ("state: ON", SetRecipe(categories=("knife",), state="OFF"), NO),
        ("state: ON", SetRecipe(categories=("knife",), state="OPEN"), EITHER),
        ("state: BROKEN", place(), EITHER),
    ],
)
def test_what_a_recipe_leaves_open(text: str, recipe: PlaceRecipe | SetRecipe, wanted: Can) -> None:
    (case,) = cases(recipe)
    assert predicate(text).possible(case) == wanted


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        (
            "{place: vase, relation: ON",
            "{place: [vase, mug], relation: ON",
            ":13: anomalies[0]: mug ON coffee_table can never satisfy the predicate",
        ),
        (
            "remedy:",
            "lookalikes:\n  - {place: vase, relation: ON, target: desk}\nremedy:",
            ":15: lookalikes[0]: vase ON desk satisfies the predicate: it would be an anomaly",
        ),
    ],
)
def test_a_contradiction_is_told(tmp_path: Path, old: str, new: str, problem: str) -> None:
    (found,) = problems(write(tmp_path, hazards__wobbly_vase=HAZARD.replace(old, new, 1)))
    assert problem in found


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        (
            "remedy:",
            "lookalikes:\n"
            "  - {place: puddle, state: SPILLED, relation: ON, target: floor}\n"
            "remedy:",
            ":15: lookalikes[0]: puddle ON floor satisfies the hazard 'spill'",
        ),
        (
            "  category: vase\n  relation: ON",
            "  any: [{category: vase}, {not: {category: vase}}]",
            ":8: predicate: always holds, whatever it is asked of",
        ),
        (
            "  category: vase\n  relation: ON",
            "  not: {category: coffee_table}",
            "is true of every ",
        ),
        (
            "  - {place: vase, relation: ON, target: coffee_table}",
            "  - {place: vase, relation: ON, target: coffee_table}\n"
            "  - {place: mug, relation: ON, target: coffee_table}",
            "mug ON coffee_table can never satisfy the predicate",
        ),
    ],
)
def test_what_could_never_be_built_is_told(
    tmp_path: Path, old: str, new: str, problem: str
) -> None:
    assert old in HAZARD
    found = problems(write(tmp_path, hazards__wobbly_vase=HAZARD.replace(old, new, 1)))
    assert any(problem in line for line in found), found


def test_an_object_may_be_two_hazards_but_no_near_miss_is_one(tmp_path: Path) -> None:
    puddle = HAZARD.replace("category: vase", "category: puddle").replace(
        "{place: vase,", "{place: puddle, state: SPILLED,"
    )
    assert load_catalog([write(tmp_path, hazards__wobbly_vase=puddle)]).hazard("wobbly_vase")
    near = "lookalikes:\n  - {place: puddle, state: SPILLED, relation: ON, target: desk}\n"
    (found,) = problems(write(tmp_path / "near", hazards__wobbly_vase=HAZARD + near))
    assert "lookalikes[0]: puddle ON desk satisfies the hazard 'spill': it would be" in found


@pytest.mark.parametrize("key", ["zone", "avoid_zones"])
def test_zones_are_where_people_walk(tmp_path: Path, key: str) -> None:
    rug = HAZARD.replace("target: coffee_table", f"target: rug, {key}: walkway")
    assert load_catalog([write(tmp_path, hazards__wobbly_vase=rug)]).hazard("wobbly_vase")
    high = rug.replace("target: rug", "target: [rug, desk]")
    (found,) = problems(write(tmp_path / "high", hazards__wobbly_vase=high))
    assert "anomalies[0].target: walkway are of floors and of what lies flat there: desk" in found


def test_a_misspelt_folder_and_replacing_nothing_are_told(tmp_path: Path) -> None:
    write(tmp_path, hazard__wobbly_vase=HAZARD)
    (found,) = problems(tmp_path)
    assert found == f"{tmp_path}/hazard: no folder of a catalogue (did you mean 'hazards'?)"
    write(tmp_path / "a", hazards__wobbly_vase=HAZARD, sources__mine="rows: []\n")
    (found,) = problems(tmp_path / "a")
    assert found.startswith(f"{tmp_path}/a/sources: tables of models are given to 'sdgen assets")
    write(
        tmp_path / "b",
        room="attic: {}",
        hazards__stove_of=HAZARD.replace("wobbly_vase", "stove_of") + "replaces: true\n",
    )
    found = "\n".join(problems(tmp_path / "b"))
    assert "room.yaml: no file of a catalogue (did you mean 'rooms.yaml'?)" in found
    assert "replaces: there is no hazard 'stove_of' to replace (did you mean 'stove_on'?)" in found
