"""The prompt names the hazard, all words an answer may use, and what there is already."""

from __future__ import annotations

from sdgen.catalog.load import extension_names, load_catalog
from sdgen.catalog.records import PlaceRecipe
from sdgen.errors import one_line
from sdgen.proposals.prompt import prompt_of
from sdgen.proposals.recipe_text import recipe_line
from sdgen.yaml_source import parse_yaml

from tests.shipped import shipped_library


def test_it_names_the_hazard_and_every_word() -> None:
    catalog, library = load_catalog(), shipped_library()
    text = prompt_of("candle_on", catalog, library)
    hazard = catalog.hazard("candle_on")
    for told in (hazard.title, hazard.predicate.in_words(), hazard.message, hazard.source):
        assert told in text
    lines = text.splitlines()
    for category in catalog.categories:
        states = sorted(library.states_by_category().get(category.name, ()))
        if category.kind in ("small", "hazard_only") and library.by_category(category.name):
            assert f"- {category.name}{': ' if states else ''}{', '.join(states)}" in lines
    rooms = next(line for line in lines if line.startswith("Rooms: "))
    assert rooms == f"Rooms: {', '.join(room.name for room in catalog.room_types)}"
    inside = next(line for line in lines if line.startswith("Targets that things can be put INS"))
    assert "fridge" in inside
    assert "dining_table" not in inside
    assert len(text) < 30_000


def test_every_hazard_has_one() -> None:
    catalog = load_catalog(extensions=extension_names())
    for hazard in catalog.hazards:
        assert hazard.title in prompt_of(hazard.id, catalog, shipped_library())


def test_recipes_are_shown_as_they_are_read() -> None:
    recipe = PlaceRecipe(
        categories=("vase", "mug"),
        state="ON",
        relation="ON",
        targets=("floor",),
        avoid_zones=("doorway",),
        rooms=("hall",),
        max_height_m=1.25,
    )
    source = parse_yaml(recipe_line(recipe).encode(), "x")
    assert source.value == {
        "place": ["vase", "mug"],
        "state": "ON",
        "relation": "ON",
        "target": "floor",
        "avoid_zones": "doorway",
        "rooms": "hall",
        "max_height_m": 1.25,
    }


def test_text_of_strangers_stays_on_its_line() -> None:
    assert one_line("a\n b\x1b[31m\u2028c\x85d\x00") == "a b [31m c d"
    assert len(one_line("x" * 10_000_000)) < 400
