"""The catalogue that ships: it can be made, its lookalikes are benign, everyday life is safe."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from functools import cache

import pytest
from sdgen.catalog.enumeration import check_against_library, enumerate_anomalies
from sdgen.catalog.folder import extension_names
from sdgen.catalog.load import load_catalog
from sdgen.catalog.predicate import Related, ZoneShare
from sdgen.catalog.records import Abode, Catalog, Hazard, PlaceRecipe, Recipe
from sdgen.hazards.certify import categories_of
from sdgen.library import Asset, Library
from sdgen.library.records import Support
from sdgen.resources import data_path
from shapely.affinity import rotate, translate
from shapely.geometry import Polygon, box

from tests.shipped import shipped_library

from .worlds import Thing, World

CATALOG = load_catalog()
#: The bottoms of what hangs on walls.
HUNG_M = {"wall_cabinet": 1.45, "bathroom_cabinet": 1.35, "wall_shelf": 1.5}
#: What children must not reach.
KEPT_FROM = {
    name
    for hazard in CATALOG.hazards
    if hazard.concerns.by_reach
    for name in categories_of(hazard.predicate) or ()
}
#: Unique anomalies of the paper's data set: ours has more.
PAPER_UNIQUE = 967
#: id -> the paper's class, group, label (the public contract).
CLASSES = {
    "spill": ("Spills", "safety", "unsafe"),
    "tripping_hazard": ("Tripping Hazard", "safety", "unsafe"),
    "broken_item": ("Broken Items", "safety", "unsafe"),
    "candle_on": ("Candle On", "safety", "unsafe"),
    "front_door_open": ("Front Door Open", "safety", "unsafe"),
    "stove_on": ("Stove On", "safety", "unsafe"),
    "refrigerated_food_out": ("Refrigerated/Frozen foods out", "sanitation", "unsanitary"),
    "expired_produce": ("Expired Produce", "sanitation", "unsanitary"),
    "fridge_open": ("Fridge/Freezer Open", "sanitation", "unsanitary"),
    "choking_hazard": ("Choking Hazard", "child_safety", "unsafe for children"),
    "sharp_object": ("Sharp Objects", "child_safety", "unsafe for children"),
    "poison_cleaning": ("Poison: Cleaning Products", "child_safety", "unsafe for children"),
    "poison_medication": (
        "Poison: Medication & Beauty Products",
        "child_safety",
        "unsafe for children",
    ),
}
#: Nobody can leave a puddle benignly, and a home has its fridge and its doors shut anyway.
NO_TWIN_OF_ITS_KIND = {"spill", "fridge_open", "front_door_open", "stove_on"}


@cache
def library() -> Library:
    return shipped_library()


def _top_m(category: str, at_most: float | None = None) -> float:
    """A likely height of the top of a piece of furniture."""
    record = CATALOG.category(category)
    top = 0.0 if category == "floor" else record.extents_max_m[2] + HUNG_M.get(category, 0.0)
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
            found = hazard.predicate.evaluate(1, world)
            assert (found.value, found.sure) == (True, True), name
            if hazard.concerns.by_reach:
                assert isinstance(found.evidence["reach_height_m"], float)


@HAZARDS
def test_lookalikes_satisfy_no_predicate(hazard: Hazard) -> None:
    assert hazard.lookalikes
    for recipe in hazard.lookalikes:
        for name, world in _worlds(recipe):
            for other in CATALOG.hazards:
                found = other.predicate.evaluate(1, world)
                assert (found.value, found.sure) == (False, True), f"{name}: {other.id}"


def _lives_in(abode: Abode, target: str, hollow: str) -> bool:
    """Whether an abode means a hollow of this name: the one it names, or any not reserved."""
    words = CATALOG.category(target).reserved if abode.hollow is None else (abode.hollow,)
    called = any(hollow == word or hollow.startswith(f"{word}_") for word in words)
    return called == (abode.hollow is not None)


def _at_home(category: str, abode: Abode, target: str) -> World:
    """A thing where it lives: behind its leaf if every hollow it may be in has one. What children
    must not reach only goes where one is."""
    states: tuple[str, ...] | None = None
    height = HUNG_M.get(target, _top_m(target))
    if abode.relation == "INSIDE":
        height = HUNG_M.get(target, 0.1) + 0.02
        hollows = [
            c
            for model in library().by_category(target)
            for c in model.containers
            if _lives_in(abode, target, c.name) and (c.closed_by or category not in KEPT_FROM)
        ]
        assert hollows, f"no {target} can be shut on a {category}"
        states = ("CLOSED",) if all(c.closed_by for c in hollows) else ()
    related = {abode.relation: (Related(2, target, True, True, {}, states),)}
    rests = (abode.state,) if abode.state else ()
    return World({1: Thing(category, rests, (), "", height, related), 2: Thing(target)})


def test_where_things_live_is_no_hazard() -> None:
    """Clutter must never be an anomaly nobody asked for."""
    for category in CATALOG.categories:
        for abode in category.lives:
            for target in abode.targets:
                world = _at_home(category.name, abode, target)
                for hazard in CATALOG.hazards:
                    found = hazard.predicate.evaluate(1, world)
                    name = f"{category.name} {abode.relation} {target}: {hazard.id}"
                    assert (found.value, found.sure) == (False, True), name


def test_the_thirteen_hazards() -> None:
    core = {hazard.id: hazard for hazard in CATALOG.hazards if hazard.pack == "core"}
    assert {k: (h.paper_class, h.group, h.label) for k, h in core.items()} == CLASSES
    for hazard in core.values():
        assert len(hazard.source) > 40, "say where the rule comes from"
        assert hazard.predicate.in_words()


def _made_of() -> list[tuple[str, str, str | None]]:
    """(hazard, category, target) of every unique anomaly whose models there are."""
    have = set(library().categories)
    return [
        (u.hazard, u.category, u.target)
        for u in enumerate_anomalies(CATALOG)
        if u.category in have and (u.target in (None, "floor") or u.target in have)
    ]


def test_more_unique_anomalies_than_the_paper() -> None:
    made = _made_of()
    assert len(made) >= PAPER_UNIQUE
    assert {hazard for hazard, _, _ in made} == set(CLASSES)


def _fits(model: Asset, support: Support) -> bool:
    """The model finds room on the support, square or askew."""
    headroom = support.headroom_m
    if headroom is not None and model.extents_m[2] > headroom - 0.015:
        return False
    surface = Polygon(support.polygon_m)
    middle = surface.centroid
    width, depth = model.extents_m[0] / 2, model.extents_m[1] / 2
    print_ = translate(box(-width, -depth, width, depth), middle.x, middle.y)
    turned = (rotate(print_, angle) for angle in (0, 45, 90))
    return any(one.intersection(surface).area >= 0.97 * one.area for one in turned)


@HAZARDS
def test_there_is_room_for_every_anomaly(hazard: Hazard) -> None:
    """No unique anomaly is there in name only: some models fit one another."""
    for recipe in hazard.anomalies:
        if not isinstance(recipe, PlaceRecipe):
            continue
        for category in recipe.categories:
            models = [
                m
                for m in library().by_category(category)
                if recipe.state is None or recipe.state in m.state_names
            ]
            for target in recipe.targets:
                supports = [
                    s
                    for receptacle in library().by_category(target)
                    for s in receptacle.supports
                    if (s.container is None) == (recipe.relation == "ON")
                ]
                if not models or not supports:
                    assert target == "floor" or not models or not library().by_category(target)
                    continue
                found = any(_fits(model, support) for model in models for support in supports)
                assert found, f"{category} {recipe.relation} {target}"


@HAZARDS
def test_lookalikes_to_be_seen_of_the_same_kind(hazard: Hazard) -> None:
    """A category alone must not tell: most of them also come as a benign thing in the open."""
    seen = [
        recipe
        for recipe in hazard.lookalikes
        if not isinstance(recipe, PlaceRecipe) or recipe.relation == "ON"
    ]
    open_bin = [
        recipe
        for recipe in hazard.lookalikes
        if isinstance(recipe, PlaceRecipe) and recipe.targets == ("trash_bin",)
    ]
    assert len(seen) + len(open_bin) >= 2
    if hazard.id in NO_TWIN_OF_ITS_KIND:
        return
    anomalous = {c for recipe in hazard.anomalies for c in recipe.categories}
    benign = {c for recipe in (*seen, *open_bin) for c in recipe.categories}
    assert len(anomalous & benign) >= 0.3 * len(anomalous), sorted(anomalous - benign)


def test_what_children_must_not_reach_is_measured() -> None:
    for hazard in CATALOG.hazards:
        if hazard.group == "child_safety":
            assert hazard.concerns.who == "children"
            assert hazard.concerns.by_reach
            assert hazard.concerns.max_age is not None


def test_no_category_is_two_hazards_in_one_place() -> None:
    """Whatever a recipe makes is an anomaly of its own hazard alone."""
    for hazard in CATALOG.hazards:
        for recipe in hazard.anomalies:
            for name, world in _worlds(recipe):
                found = [h.id for h in CATALOG.hazards if h.predicate.evaluate(1, world).value]
                assert found == [hazard.id], name


def _named(hazards: Iterable[Hazard]) -> set[str]:
    """What the recipes of hazards place or set."""
    return {name for h in hazards for recipe in h.anomalies for name in recipe.categories}


CORE_NAMES = _named(CATALOG.hazards)
PACKED = _named(load_catalog(extensions=extension_names()).hazards)


def test_hazard_only_things_live_nowhere_and_the_rest_is_used() -> None:
    for category in CATALOG.categories:
        if category.kind == "hazard_only":
            assert category.lives == ()
        if category.kind == "small":
            # Lilies are in no home but for the sake of a pack.
            packed = category.name in PACKED and category.name not in CORE_NAMES
            assert category.lives or packed, f"{category.name} lives nowhere"
    receptacles = {p.receptacle for room in CATALOG.room_types for p in room.clutter} | {"floor"}
    receptacles |= {category.name for category in CATALOG.categories if category.holds}
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
        assert len(text.splitlines()) <= 420, path
        assert not any(line != line.rstrip() for line in text.splitlines()), path


def test_whatever_may_lie_where_people_walk_is_to_trip_over_or_flat() -> None:
    """Recipes put nothing loose and high in a walkway that no label would name."""
    tripping = CATALOG.hazard("tripping_hazard")
    loose = {name for recipe in tripping.anomalies for name in recipe.categories}
    heights = {category.name: category.extents_max_m[2] for category in CATALOG.categories}
    for hazard in CATALOG.hazards:
        for recipe in (*hazard.anomalies, *hazard.lookalikes):
            if recipe.kind != "place" or "floor" not in recipe.targets:
                continue
            if {"doorway", "walkway"} <= set(recipe.avoid_zones):
                continue
            for name in set(recipe.categories) - loose:
                broken = recipe.state == "BROKEN"  # shards are what one steps into
                assert broken or heights[name] <= 0.05, (hazard.id, name)


def test_near_misses_lie_on_floors_that_people_keep_them_on() -> None:
    """A whole cup on a bathroom's floor is no hazard by any definition, and looks like one."""
    on_floors = {
        category.name
        for category in CATALOG.categories
        if category.kind != "small" or any("floor" in abode.targets for abode in category.lives)
    }
    for hazard in CATALOG.hazards:
        for recipe in hazard.lookalikes:
            if isinstance(recipe, PlaceRecipe) and "floor" in recipe.targets:
                assert recipe.rooms, (hazard.id, recipe.categories)
                assert set(recipe.categories) <= on_floors, hazard.id


def _spread(recipes: Iterable[Recipe]) -> dict[str, float]:
    """How often recipes put something on each support, as shares; those for high shelves alone
    are left out."""
    found: Counter[str] = Counter()
    for recipe in recipes:
        if isinstance(recipe, PlaceRecipe) and recipe.relation == "ON" and not recipe.min_height_m:
            for target in recipe.targets:
                share = recipe.weight * len(recipe.categories) / len(recipe.targets)
                found[target] += share
    return {target: share / found.total() for target, share in found.items()}


#: Hazards that things are placed for; puddles, which are no loose things, have none that is near.
PLACED = [h for h in CATALOG.hazards if _spread(h.anomalies) and h.id != "spill"]


@pytest.mark.parametrize("hazard", PLACED, ids=lambda h: h.id)
def test_near_misses_lie_where_anomalies_do_as_often(hazard: Hazard) -> None:
    anomalies, near = _spread(hazard.anomalies), _spread(hazard.lookalikes)
    apart = sum(abs(anomalies.get(k, 0) - near.get(k, 0)) for k in {*anomalies, *near}) / 2
    assert apart < 0.15, f"{apart:.0%} of them lie elsewhere"
