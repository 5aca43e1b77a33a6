"""What recipes leave to chance is said before a build spends its tries on it."""

from __future__ import annotations

from typing import Any

import pytest
from sdgen.catalog.advice import advice, home_advice
from sdgen.catalog.folder import extension_names
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Before, Near, PlaceRecipe, SetRecipe
from sdgen.catalog.terms import AllTerm, CategoryTerm, DistanceTerm, StateTerm

CATALOG = load_catalog()
TRAP = AllTerm(
    terms=(
        CategoryTerm(any_of=("bucket",)),
        StateTerm(any_of=("FULL",)),
        DistanceTerm(to=("crib", "bed"), max_m=0.8),
    )
)


def lines(*recipes: PlaceRecipe | SetRecipe) -> list[str]:
    hazard = CATALOG.hazard("spill")
    return list(advice(hazard.model_copy(update={"predicate": TRAP, "anomalies": recipes})))


def recipe(**changes: Any) -> PlaceRecipe:
    values: dict[str, Any] = {
        "categories": ("bucket",),
        "state": "FULL",
        "relation": "ON",
        "targets": ("floor",),
        "near": Near(to=("crib",), max_m=0.7),
    }
    return PlaceRecipe(**(values | changes))


def test_nothing_is_said_of_what_a_recipe_sees_to() -> None:
    assert lines(recipe()) == []
    assert lines(recipe(state=None, not_state=("EMPTY",))) == []
    assert lines(recipe(near=None, before=Before(of=("bed",), max_m=0.5))) == []
    assert lines(recipe(near=None, targets=("bed",))) == []
    assert lines(SetRecipe(categories=("bucket",), state="FULL")) == []


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"state": None}, "the predicate asks that it is FULL, and the recipe names no state"),
        (
            {"near": None},
            "the predicate asks for crib or bed at most 0.8 m away: say "
            "'near: {to: crib, max_m: 0.75}'",
        ),
        ({"near": Near(to=("stove",), max_m=0.7)}, "the predicate asks for crib or bed"),
        (
            {"near": Near(to=("crib",), max_m=1.5)},
            "near.max_m is 1.5, and the predicate asks for at most 0.8 m",
        ),
    ],
)
def test_what_is_left_to_chance_is_named(changes: dict[str, Any], said: str) -> None:
    (line,) = lines(recipe(), recipe(**changes))
    assert line.startswith(f"hazard 'spill': anomalies[1]: {said}")


def test_ours_leave_nothing_to_chance() -> None:
    packs = load_catalog(extensions=extension_names())
    assert [line for hazard in packs.hazards for line in advice(hazard)] == []


def test_a_home_with_neither_windows_nor_lamps_is_told_of() -> None:
    home = load_catalog().homes[0].model_copy(update={"as_drawn": True})
    assert any(opening.kind == "window" for opening in home.openings)
    assert list(home_advice(home)) == []
    shut = tuple(one for one in home.openings if one.kind != "window")
    rooms = tuple(room.model_copy(update={"furniture": ()}) for room in home.rooms)
    dark = home.model_copy(update={"openings": shut, "rooms": rooms})
    assert list(home_advice(dark)) == [
        f"home {home.id!r}: it has neither a window nor a lamp: its pictures are dim"
    ]
    # Where not all is drawn, lamps are hung up.
    assert list(home_advice(dark.model_copy(update={"as_drawn": False}))) == []
