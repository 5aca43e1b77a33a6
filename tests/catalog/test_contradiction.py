"""Predicates that hold of nothing, or of everything, are told when they are read."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.contradiction import always, models_object, never
from sdgen.catalog.enumeration import check_against_library
from sdgen.catalog.load import extension_names, load_catalog
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.terms import NotTerm, Predicate
from sdgen.errors import InputError
from sdgen.yaml_source import parse_yaml

from tests.shipped import shipped_library

from .worlds import HAZARD, problems, write

CATEGORIES = {"knife", "floor", "desk", "stove", "door", "front_door", "vase", "mug"}
ROOMS = {"kitchen", "hall"}


def predicate(text: str) -> Predicate:
    source = parse_yaml(text.encode(), "p.yaml")
    found = read_predicate(source, (), source.value, CATEGORIES, ROOMS)
    assert source.problems == []
    return found


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("all: [{category: knife}, {category: vase}]", "knife, and vase"),
        ("all: [{category: [knife, vase]}, {not: {category: [vase, knife]}}]", "of a category"),
        ("{category: knife, not: {category: knife}}", "not both: it is a knife, and not"),
        ("all: [{room: kitchen}, {room: hall}]", "in a room that is kitchen, and hall"),
        ("{room: kitchen, not: {room: [kitchen, hall]}}", "in a room that is kitchen"),
        ("all: [{state: OPEN}, {state: CLOSED}]", "nothing is OPEN and CLOSED"),
        ("all: [{category: stove, state: ON}, {all: [{state: OFF}]}]", "nothing is ON and OFF"),
        ("{relation: ON, not: {relation: ON}}", "not both: it is ON something, and not"),
        ("not: {any: [{relation: ON}, {not: {relation: ON}}]}", "not both"),
        (
            "all: [{height: {min_m: 1.5}}, {height: {max_m: 1.0}}]",
            "nothing is at least 1.5 m and at most 1 m up",
        ),
        ("{category: floor, relation: ON, target: desk}", "floor is no object"),
        ("{category: knife, relation: BETWEEN, target: hall}", "only doors are BETWEEN rooms"),
        ("{category: knife, relation: INSIDE, target: floor}", "nothing is INSIDE a floor"),
        # No branch is any better.
        (
            "{category: knife, any: [{category: vase}, {all: [{state: ON}, {state: OFF}]}]}",
            "nothing is ON and OFF",
        ),
    ],
)
def test_what_can_never_hold(text: str, told: str) -> None:
    found = predicate(text)
    assert told in never(found)
    assert not always(found)
    # The other way round it always holds.
    assert always(NotTerm(term=found))


@pytest.mark.parametrize(
    "text",
    [
        "{category: knife, relation: ON}",
        "all: [{category: [knife, vase]}, {category: [vase, mug]}]",
        "{category: [knife, vase], not: {category: knife}}",
        "all: [{state: [OPEN, AJAR]}, {state: CLOSED}]",  # a thing has several states
        "all: [{state: ON}, {state: BROKEN}]",
        "all: [{state: ON}, {not: {state: OFF}}]",
        "all: [{relation: ON, target: desk}, {relation: ON, target: floor}]",
        "{any: [{category: knife}, {category: vase}], not: {category: knife}}",
        "all: [{height: {min_m: 1.0}}, {height: {max_m: 1.5}}]",
        "all: [{height: {min_m: 1.5}}, {height: {max_m: 1.0, evidence: reach_height_m}}]",
        "{category: [floor, knife]}",
        "{category: [door, knife], relation: BETWEEN, target: hall}",
        "{relation: INSIDE, target: [floor, desk]}",
        "{relation: INSIDE}",
    ],
)
def test_what_may_hold_or_not(text: str) -> None:
    assert never(predicate(text)) == ""
    assert not always(predicate(text))


def test_what_has_too_many_ways_is_left_to_the_builds() -> None:
    branch = "{any: [{state: ON}, {relation: ON}]}"
    found = predicate(f"all: [{', '.join([branch] * 40)}, {{category: knife}}, {{category: vase}}]")
    assert never(found) == ""


STATES = {"knife": {"DIRTY"}, "vase": {"BROKEN"}, "stove": {"ON"}}
HOLDING = {"ON": {"desk"}, "INSIDE": {"stove"}}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("{category: knife, state: BROKEN}", "no model of knife can be BROKEN"),
        ("{category: [knife, vase], state: [ON, OFF]}", "no model of knife or vase can be ON or"),
        ("{category: [knife, vase], state: BROKEN}", ""),
        ("{category: mug, state: BROKEN}", ""),  # no model: nothing is known
        ("{category: vase, relation: INSIDE, target: knife}", "no model of knife has a hollow"),
        ("{category: vase, relation: INSIDE, target: [knife, stove]}", ""),
        ("{any: [{category: knife, state: BROKEN}, {category: vase, state: BROKEN}]}", ""),
        ("{category: vase, not: {relation: INSIDE, target: knife}}", ""),
    ],
)
def test_what_no_model_can_be(text: str, told: str) -> None:
    found = never(predicate(text), models_object(STATES, HOLDING))
    assert (told in found) if told else found == ""


@pytest.mark.parametrize(
    ("terms", "told"),
    [
        ("all: [{category: vase}, {category: mug}]", ":8: predicate: can never hold: nothing is"),
        (
            "any: [{relation: ON}, {not: {relation: ON}}]",
            ":8: predicate: always holds, whatever it is asked of",
        ),
    ],
)
def test_it_is_told_with_its_line(tmp_path: Path, terms: str, told: str) -> None:
    text = HAZARD.replace("category: vase\n  relation: ON", terms)
    found = problems(write(tmp_path, hazards__wobbly_vase=text))
    assert f"{tmp_path}/hazards/wobbly_vase.yaml{told}" in found[0]


def told_by_the_models(tmp_path: Path, old: str, new: str) -> tuple[str, ...]:
    catalog = load_catalog([write(tmp_path, hazards__wobbly_vase=HAZARD.replace(old, new, 1))])
    library = shipped_library()
    with pytest.raises(InputError) as caught:
        check_against_library(catalog, library.states_by_category(), None, library.holding())
    return caught.value.problems


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (
            "relation: ON, target: coffee_table",
            "relation: INSIDE, target: [coffee_table, dining_table]",
            "anomalies[0].target: no model of dining_table has a hollow that things fit into",
        ),
        (
            "target: coffee_table",
            "target: [coffee_table, knife]",
            "anomalies[0].target: no model of knife has a surface that things stand on",
        ),
        (
            # The floor of its hollow takes things INSIDE it.
            "target: coffee_table",
            "target: [coffee_table, laundry_basket]",
            "anomalies[0].target: no model of laundry_basket has a surface that things stand on",
        ),
        (
            "remedy:",
            "lookalikes:\n  - {place: mug, relation: INSIDE, target: dining_table}\nremedy:",
            "lookalikes[0].target: no model of dining_table has a hollow",
        ),
        (
            "category: vase\n",
            "category: vase\n  state: MELTED\n",
            "predicate: can never hold: no model of vase can be MELTED",
        ),
    ],
)
def test_what_no_model_takes_is_told(tmp_path: Path, old: str, new: str, told: str) -> None:
    (found,) = told_by_the_models(tmp_path, old, new)
    assert found.startswith(f"hazard wobbly_vase: {told}")


def test_all_that_is_shipped_is_sound() -> None:
    catalog, library = load_catalog(extensions=extension_names()), shipped_library()
    check_against_library(catalog, library.states_by_category(), None, library.holding())
