"""Unique anomalies, and the fit of a catalogue with a library."""

from __future__ import annotations

from pathlib import Path

import pytest
from sdgen.catalog.cases import cases
from sdgen.catalog.enumeration import check_against_library, enumerate_anomalies
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import UniqueAnomaly
from sdgen.errors import InputError
from sdgen.hazards.certify import categories_of

from .worlds import HAZARD, write


def test_every_combination_of_every_recipe_once() -> None:
    catalog = load_catalog(only=["spill", "stove_on"])
    found = enumerate_anomalies(catalog)
    assert (
        UniqueAnomaly(
            hazard="stove_on",
            category="stove",
            state="ON",
            relation=None,
            target=None,
            room="kitchen",
        )
        in found
    )
    assert (
        UniqueAnomaly(
            hazard="spill",
            category="puddle",
            state="SPILLED",
            relation="ON",
            target="floor",
            room="kitchen",
        )
        in found
    )
    expected = {
        (hazard.id, case.category, case.state, case.target, case.rooms[0] if case.rooms else None)
        for hazard in catalog.hazards
        for recipe in hazard.anomalies
        for case in cases(recipe)
    }
    assert {(u.hazard, u.category, u.state, u.target, u.room) for u in found} == expected
    assert len(found) == len(expected)


def test_the_order_does_not_follow_the_files(tmp_path: Path) -> None:
    turned = HAZARD.replace("category: vase", "category: [bowl, mug, vase]").replace(
        "{place: vase, relation: ON, target: coffee_table}",
        "{place: [vase, mug, bowl], relation: ON, target: [desk, coffee_table]}",
    )
    first = enumerate_anomalies(load_catalog([write(tmp_path / "p", hazards__wobbly_vase=turned)]))
    turned = turned.replace("[vase, mug, bowl]", "[bowl, vase, mug]")
    second = enumerate_anomalies(load_catalog([write(tmp_path / "p", hazards__wobbly_vase=turned)]))
    assert first == second
    assert len(first) == len(set(first))


def _states() -> dict[str, set[str]]:
    """A library that has a model of everything, able to do what the catalogue asks."""
    catalog = load_catalog()
    out: dict[str, set[str]] = {category.name: set() for category in catalog.categories}
    for hazard in catalog.hazards:
        for recipe in hazard.anomalies:
            for category in recipe.categories:
                out[category] |= {recipe.state} if recipe.state else set()
    return out


def test_a_full_library_fits() -> None:
    check_against_library(load_catalog(), _states())


def test_a_missing_model_is_skipped_as_long_as_there_is_another() -> None:
    states = _states()
    del states["scissors"], states["milk_carton"]
    check_against_library(load_catalog(), states)


SPILLS, CANDLES = (
    tuple(categories_of(load_catalog().hazard(name).predicate) or ())
    for name in ("spill", "candle_on")
)


@pytest.mark.parametrize(
    ("gone", "problem"),
    [
        (SPILLS, "hazard spill: no model of any of its objects (coffee_puddle, cola_puddle, "),
        (CANDLES, "hazard candle_on: no model of any of its objects (advent_wreath, "),
        (("fridge", "freezer"), "hazard fridge_open: no model of any of its objects"),
        (
            ("stove", "hot_plate"),
            "hazard stove_on: no model of any of its objects (hot_plate, stove)",
        ),
    ],
)
def test_a_hazard_without_any_model_is_told(gone: tuple[str, ...], problem: str) -> None:
    states = {name: known for name, known in _states().items() if name not in gone}
    with pytest.raises(InputError) as caught:
        check_against_library(load_catalog(), states)
    assert any(problem in line for line in caught.value.problems)


def test_a_state_no_model_knows_and_a_target_without_model_are_told(tmp_path: Path) -> None:
    text = HAZARD.replace("{place: vase,", "{place: vase, state: BROKN,")
    catalog = load_catalog([write(tmp_path, hazards__wobbly_vase=text)])
    states = {**_states(), "vase": {"BROKEN"}, "stove": {"OFF"}, "hot_plate": {"ON", "OFF"}}
    with pytest.raises(InputError) as caught:
        check_against_library(catalog, states)
    assert caught.value.problems == (
        "hazard stove_on: anomalies[0]: no model of stove can be ON (one of: OFF)",
        "hazard stove_on: anomalies[1]: no model of stove can be OVEN_ON (one of: OFF)",
        "hazard wobbly_vase: anomalies[0]: no model of vase can be BROKN (did you mean 'BROKEN'?)",
    )
    states = _states()
    catalog = load_catalog([write(tmp_path, hazards__wobbly_vase=HAZARD)])
    del states["coffee_table"]
    with pytest.raises(InputError, match=r"no model of any target \(coffee_table\)"):
        check_against_library(catalog, states)


def test_a_part_that_no_model_has_is_told(tmp_path: Path) -> None:
    keys = "\nrelation: ON\nevidence_parts: [rim, neck]\nanom"
    text = HAZARD.replace("\nrelation: ON\nanom", keys)
    catalog = load_catalog([write(tmp_path, hazards__wobbly_vase=text)], only=["wobbly_vase"])
    states = _states()
    check_against_library(catalog, states, {"vase": {"body", "neck"}})
    with pytest.raises(InputError) as caught:
        check_against_library(catalog, states, {"vase": {"body", "rims"}, "mug": {"rim"}})
    (told,) = caught.value.problems
    assert told.startswith("hazard wobbly_vase: evidence_parts: no model of its objects has a rim")
    assert "(did you mean 'rims'?)" in told


def test_a_model_nobody_could_use_is_told() -> None:
    with pytest.raises(InputError, match=r"'frigde', which no catalogue .*did you mean 'fridge'"):
        check_against_library(load_catalog(), {**_states(), "frigde": set()})
