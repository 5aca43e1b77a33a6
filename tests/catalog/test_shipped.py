"""The catalogue that ships: it can be made, its lookalikes are benign, everyday life is safe."""

from __future__ import annotations

import json
from functools import cache

import pytest
from sdgen.catalog.enumeration import check_against_library
from sdgen.catalog.load import load_catalog
from sdgen.catalog.predicate import Related, ZoneShare, evaluate
from sdgen.catalog.predicate_text import in_words
from sdgen.catalog.records import Abode, Catalog, Hazard, PlaceRecipe, Recipe
from sdgen.library import Library, load_library
from sdgen.resources import data_path

from .worlds import Thing, World

CATALOG = load_catalog()
HUNG_M = 1.45  # where wall cabinets hang
PAPER_CLASSES = {
    "spill": "Spills",
    "tripping_hazard": "Tripping Hazard",
    "stove_on": "Stove On",
    "refrigerated_food_out": "Refrigerated/Frozen foods out",
    "fridge_open": "Fridge/Freezer Open",
    "sharp_object": "Sharp Objects",
}


@cache
def library() -> Library:
    return load_library()


def _top_m(category: str, at_most: float | None = None) -> float:
    """A likely height of the top of a piece of furniture."""
    record = CATALOG.category(category)
    top = 0.0 if category == "floor" else record.extents_max_m[2]
    return top if at_most is None else min(top, at_most)


def _world(recipe: PlaceRecipe, category: str, target: str) -> World:
    """The scene a recipe asks for, with everything in the middle of what it allows."""
    height = _top_m(target, recipe.max_height_m)
    if recipe.min_height_m is not None:
        height = max(height, recipe.min_height_m)
    related = {recipe.relation: (Related(2, target, True, True, {}),)}
    zones = tuple(ZoneShare(kind, kind, 1.0) for kind in recipe.zone[:1])
    states = (recipe.state,) if recipe.state else ()
    return World({1: Thing(category, states, (), "", height, related, zones), 2: Thing(target)})


def _worlds(recipe: Recipe) -> list[tuple[str, World]]:
    if isinstance(recipe, PlaceRecipe):
        return [
            (f"{c} {recipe.relation} {t}", _world(recipe, c, t))
            for c in recipe.categories
            for t in recipe.targets
        ]
    return [
        (f"{c} {recipe.state}", World({1: Thing(c, (recipe.state,))})) for c in recipe.categories
    ]


HAZARDS = pytest.mark.parametrize("hazard", CATALOG.hazards, ids=lambda hazard: hazard.id)


@HAZARDS
def test_what_a_recipe_makes_satisfies_the_predicate(hazard: Hazard) -> None:
    for recipe in hazard.anomalies:
        for name, world in _worlds(recipe):
            found = evaluate(hazard.predicate, 1, world)
            assert (found.value, found.sure) == (True, True), name
            if hazard.concerns.by_reach:
                assert isinstance(found.evidence["reach_height_m"], float)


@HAZARDS
def test_lookalikes_satisfy_no_predicate(hazard: Hazard) -> None:
    assert hazard.lookalikes
    for recipe in hazard.lookalikes:
        for name, world in _worlds(recipe):
            for other in CATALOG.hazards:
                found = evaluate(other.predicate, 1, world)
                assert (found.value, found.sure) == (False, True), f"{name}: {other.id}"


def _at_home(category: str, abode: Abode, target: str) -> World:
    """A thing where it lives: behind its leaf if every hollow of the target has one."""
    states: tuple[str, ...] | None = None
    height = _top_m(target)
    if abode.relation == "INSIDE":
        height = HUNG_M + 0.02 if target == "wall_cabinet" else 0.1
        hollows = [c for model in library().by_category(target) for c in model.containers]
        states = ("CLOSED",) if all(c.closed_by for c in hollows) else ()
    related = {abode.relation: (Related(2, target, True, True, {}, states),)}
    return World({1: Thing(category, (), (), "", height, related), 2: Thing(target)})


def test_where_things_live_is_no_hazard() -> None:
    """Clutter must never be an anomaly nobody asked for."""
    for category in CATALOG.categories:
        for abode in category.lives:
            for target in abode.targets:
                world = _at_home(category.name, abode, target)
                for hazard in CATALOG.hazards:
                    found = evaluate(hazard.predicate, 1, world)
                    name = f"{category.name} {abode.relation} {target}: {hazard.id}"
                    assert (found.value, found.sure) == (False, True), name


def test_the_six_hazards_of_this_step() -> None:
    core = [hazard for hazard in CATALOG.hazards if hazard.pack == "core"]
    assert {h.id for h in core} >= set(PAPER_CLASSES)
    for hazard in core:
        assert hazard.paper_class == PAPER_CLASSES.get(hazard.id, hazard.paper_class)
        assert len(hazard.source) > 40, "say where the rule comes from"
        assert in_words(hazard.predicate)


def test_hazard_only_things_live_nowhere_and_the_rest_is_used() -> None:
    for category in CATALOG.categories:
        if category.kind == "hazard_only":
            assert category.lives == ()
        if category.kind == "small":
            assert category.lives, f"{category.name} lives nowhere"
    receptacles = {p.receptacle for room in CATALOG.room_types for p in room.clutter} | {"floor"}
    for category in CATALOG.categories:
        for abode in category.lives:
            assert receptacles & set(abode.targets), (
                f"{category.name}: no room fills {abode.targets}"
            )


def test_the_library_fits() -> None:
    states: dict[str, set[str]] = {}
    for asset in library().assets.values():
        states.setdefault(asset.category, set()).update(asset.state_names)
    check_against_library(CATALOG, states)


def test_every_model_has_a_category_and_its_size() -> None:
    known = {category.name: category for category in CATALOG.categories}
    wrong = []
    for asset in library().assets.values():
        category = known.get(asset.category)
        if category is None:
            wrong.append(f"{asset.id}: no category {asset.category}")
            continue
        low, high = category.extents_min_m, category.extents_max_m
        if not all(a <= b <= c for a, b, c in zip(low, asset.extents_m, high, strict=True)):
            wrong.append(f"{asset.id}: {asset.extents_m} is not within {low} to {high}")
        if not category.mass_min_kg <= asset.mass_kg <= category.mass_max_kg:
            wrong.append(f"{asset.id}: {asset.mass_kg} kg")
    assert wrong == []


def test_the_catalogue_survives_its_own_file() -> None:
    text = json.dumps(CATALOG.model_dump(mode="json"))
    assert Catalog.model_validate_json(text) == CATALOG


def test_shipped_files_are_plain_and_short() -> None:
    for path in sorted(data_path("hazard_catalog").rglob("*.yaml")):
        text = path.read_text(encoding="utf-8")
        assert len(text.splitlines()) <= 400, path
        assert not any(line != line.rstrip() for line in text.splitlines()), path
