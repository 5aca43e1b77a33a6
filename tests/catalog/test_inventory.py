"""What ``sdgen catalog categories`` says follows from the catalogue and the models."""

from __future__ import annotations

from sdgen.catalog.inventory import inventory
from sdgen.catalog.load import load_catalog

from tests.shipped import shipped_library

LIBRARY = shipped_library()
BY_CATEGORY = {name: LIBRARY.by_category(name) for name in LIBRARY.categories}
FOUND = {one.name: one for one in inventory(load_catalog(), BY_CATEGORY)}


def test_every_category_is_there_with_its_models() -> None:
    assert set(FOUND) == {category.name for category in load_catalog().categories}
    assert all(one.models == len(BY_CATEGORY.get(one.name, ())) for one in FOUND.values())


def test_states_and_parts_are_those_of_models() -> None:
    stove = FOUND["stove"]
    assert (stove.kind, stove.on) == ("furniture", True)
    assert "ON" in stove.states
    assert all(state in FOUND["fridge"].states for state in ("OPEN", "CLOSED"))
    assert FOUND["fridge"].inside
    assert "blade" in FOUND["knife"].parts


def test_rooms_are_those_furnished_with_it_or_with_what_it_lives_on() -> None:
    assert "kitchen" in FOUND["stove"].rooms
    assert "bedroom" not in FOUND["stove"].rooms
    assert "kitchen" in FOUND["mug"].rooms
    assert "toilet" not in FOUND["mug"].rooms


def test_a_category_without_models_says_so() -> None:
    (stove,) = (one for one in inventory(load_catalog(), {}) if one.name == "stove")
    assert (stove.models, stove.states, stove.on, stove.inside) == (0, (), False, ())
