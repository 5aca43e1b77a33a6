"""The predicate language as people write it."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.terms import (
    TERMS,
    AllTerm,
    AnyTerm,
    CategoryTerm,
    DistanceTerm,
    HeightTerm,
    NotTerm,
    Predicate,
    RelationTerm,
    RoomTerm,
    StateTerm,
    ZoneTerm,
)
from sdgen.yaml_source import Source, parse_yaml

CATEGORIES = {"knife", "fridge", "floor", "stove", "coffee_table"}
ROOMS = {"kitchen", "hall"}


def read(text: str) -> tuple[Predicate, Source]:
    source = parse_yaml(text.encode(), "p.yaml")
    return read_predicate(source, (), source.value, CATEGORIES, ROOMS), source


KNIFE = CategoryTerm(any_of=("knife",))


@pytest.mark.parametrize(
    ("text", "term"),
    [
        ("category: knife", KNIFE),
        ("category: [knife, stove]", CategoryTerm(any_of=("knife", "stove"))),
        ("state: ON", StateTerm(any_of=("ON",))),
        ("state: [OPEN, BROKEN]", StateTerm(any_of=("OPEN", "BROKEN"))),
        ("room: kitchen", RoomTerm(any_of=("kitchen",))),
        ("relation: ON", RelationTerm(relation="ON")),
        (
            "{relation: INSIDE, target: [fridge], target_state: OPEN}",
            RelationTerm(relation="INSIDE", targets=("fridge",), target_state="OPEN"),
        ),
        (
            "{relation: BETWEEN, target: hall}",
            RelationTerm(relation="BETWEEN", targets=("hall",)),
        ),
        ("height: {max_m: 1.3}", HeightTerm(max_m=1.3)),
        (
            "height: {min_m: 1, max_m: 2, margin_m: 0.1, evidence: reach_height_m}",
            HeightTerm(min_m=1.0, max_m=2.0, margin_m=0.1, evidence="reach_height_m"),
        ),
        (
            "distance: {to: stove, to_state: ON, max_m: 0.5}",
            DistanceTerm(to=("stove",), to_state="ON", max_m=0.5),
        ),
        (
            "distance: {to_zone: [heat, water], from_above: true, same_room: true, max_m: 1}",
            DistanceTerm(to_zone=("heat", "water"), from_above=True, same_room=True, max_m=1.0),
        ),
        ("zone: [doorway, walkway]", ZoneTerm(any_of=("doorway", "walkway"))),
        (
            "zone: {kind: heat, overlap: 0.3, margin: 0.1}",
            ZoneTerm(any_of=("heat",), overlap=0.3, margin=0.1),
        ),
        ("not: {category: knife}", NotTerm(term=KNIFE)),
        (
            "any: [{category: knife}, {state: ON}]",
            AnyTerm(terms=(KNIFE, StateTerm(any_of=("ON",)))),
        ),
        ("[{category: knife}, {state: ON}]", AllTerm(terms=(KNIFE, StateTerm(any_of=("ON",))))),
        ("{category: knife, state: ON}", AllTerm(terms=(KNIFE, StateTerm(any_of=("ON",))))),
        (
            "{category: knife, all: [{state: ON}], not: {room: hall}}",
            AllTerm(
                terms=(
                    KNIFE,
                    AllTerm(terms=(StateTerm(any_of=("ON",)),)),
                    NotTerm(term=RoomTerm(any_of=("hall",))),
                )
            ),
        ),
    ],
)
def test_each_term_is_read(text: str, term: Predicate) -> None:
    found, source = read(text)
    assert source.problems == []
    assert found == term


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (
            "state: on",
            "p.yaml:1: state: 'on' is not a state; states are UPPER CASE words: write ON",
        ),
        ("state: [OPEN, off]", "state[1]: 'off' is not a state"),
        ("state: true", "state: expected a state or a list of them, got true"),
        ("state: 1", "state: expected a state or a list of them, got the number 1"),
        ("category: knive", "category: unknown category 'knive' (did you mean 'knife'?)"),
        ("category: [knife, 3]", "category[1]: expected a category, got the number 3"),
        ("category: [knife, knife]", "category[1]: 'knife' is listed twice"),
        ("category: []", "category: expected at least one category"),
        ("category:", "category: is empty"),
        ("room: kitchn", "room: unknown room type 'kitchn' (did you mean 'kitchen'?)"),
        ("relation: IN", "relation: 'IN' is not one of ON, INSIDE"),
        ("{relation: ON, target: flor}", "target: unknown category 'flor' (did you mean 'floor'?)"),
        ("{relation: ON, target_state: open}", "target_state: 'open' is not a state"),
        ("target: floor", "'target' needs a 'relation' beside it"),
        ("heigth: {max_m: 1}", "heigth: unknown key (did you mean 'height'?)"),
        ("height: {}", "height: needs min_m or max_m"),
        ("height: 1.3", "height: expected a mapping"),
        ("height: {max_m: '1.3'}", "height.max_m: expected a number, got text '1.3'"),
        ("height: {max_m: true}", "height.max_m: expected a number, got true"),
        ("height: {max_m: -1}", "height.max_m: -1 is not between 0 and 100"),
        ("height: {min_m: 2, max_m: 1}", "height.min_m: min_m (2) is above max_m (1)"),
        ("height: {max_cm: 130}", "height.max_cm: unknown key (did you mean 'max_m'?)"),
        ("distance: {max_m: 1}", "distance: missing key 'to'"),
        (
            "distance: {to: stove, to_zone: heat, max_m: 1}",
            "to_zone: give either 'to' or 'to_zone'",
        ),
        (
            "distance: {to_zone: het, max_m: 1}",
            "to_zone: unknown zone 'het' (did you mean 'heat'?)",
        ),
        ("distance: {to: stove, same_room: yes, max_m: 1}", "same_room: expected true or false"),
        ("height: {max_m: 0.02}", "height: nothing is surely within these limits"),
        ("height: {min_m: 0}", "height.min_m: 0 is no lower limit: nothing is less; leave it out"),
        ("distance: {to: stove, min_m: 0.0, max_m: 1}", "distance.min_m: 0 is no lower limit"),
        ("height: {min_m: 1, max_m: 1.05}", "the margin is 0.03 m"),
        ("zone: {kind: heat, overlap: 0.1}", "zone: nothing is surely in or out of it"),
        ("{relation: BETWEEN, target: knife}", "target: unknown room type 'knife'"),
        ("{relation: BETWEEN, target_state: OPEN}", "target_state: rooms have no states"),
        ("zone: corridor", "zone: unknown zone 'corridor'"),
        ("zone: {overlap: 0.5}", "zone: missing key 'kind'"),
        ("any: {category: knife}", "any: expected a list of terms, got a mapping"),
        ("any: []", "any: expected a list of terms, got a list"),
        ("not: knife", "not: expected a mapping (key: value), got text"),
        ("[]", "p.yaml:1: expected at least one term"),
        ("{}", "p.yaml:1: expected one of the terms category, state"),
        (
            "any: [{category: knife}, {stat: ON}]",
            "any[1].stat: unknown key (did you mean 'state'?)",
        ),
    ],
)
def test_each_mistake_is_told(text: str, problem: str) -> None:
    _, source = read(text)
    assert any(problem in found for found in source.problems), source.problems


def test_the_line_is_that_of_the_mistake() -> None:
    _, source = read(
        "all:\n  - category: knife\n  - any:\n      - state: OPEN\n      - state: on\n"
    )
    assert source.problems[0].startswith("p.yaml:5: all[1].any[1].state: ")


_JUNK = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-5, 5)
    | st.floats(allow_nan=False)
    | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from([*TERMS, "target", "max_m", "to", "x"]), inner, max_size=3
        )
    ),
    max_leaves=12,
)


@given(_JUNK)
def test_junk_gives_problems_or_a_predicate_never_a_traceback(value: Any) -> None:
    source = Source("p.yaml", value)
    found = read_predicate(source, (), value, CATEGORIES, ROOMS)
    assert isinstance(found.in_words(), str)
    if not isinstance(value, dict | list):
        assert source.problems


def test_words_for_people() -> None:
    text = "{category: knife, height: {max_m: 1.3}, not: {relation: INSIDE, target_state: CLOSED}}"
    assert read(text)[0].in_words() == (
        "it is a knife, and its lowest point is at most 1.3 m up, "
        "and not (it is INSIDE something that is CLOSED)"
    )
    text = "any: [{zone: doorway}, {distance: {to: stove, to_state: ON, min_m: 0.1, max_m: 0.5}}]"
    assert read(text)[0].in_words() == (
        "at least 50% of it is in a doorway, or it is 0.1 to 0.5 m from stove that is ON"
    )
