"""Everyday things: a small home is lived in as well."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from sdgen.actions import in_state
from sdgen.catalog.load import load_catalog
from sdgen.geometry import Array, apply, inverse, yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.clutter import LEAST_THINGS, add_clutter, living_so
from sdgen.home.layout import Layout
from sdgen.library.states import rest_states
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.scene import ObjectInstance
from sdgen.seeding import lane
from shapely.geometry.base import BaseGeometry

from tests.shipped import shipped_library

CATALOG = load_catalog()
KINDS = {category.name: category for category in CATALOG.categories}


@cache
def _furnished(home: str, seed: int) -> FurnishedHome:
    models = SplitModels(shipped_library(), "test")
    base = next(h for h in CATALOG.homes if h.id == home)
    ids = iter(range(1, 60000))
    rng = lane(seed, 0, "furnish")
    stage = furnished_home(base, CATALOG, shipped_library(), models, ids, rng)
    assert isinstance(stage, FurnishedHome)
    return stage


@cache
def _cluttered(home: str, seed: int) -> Layout:
    """A shipped base home with its clutter."""
    stage = _furnished(home, seed)
    layout = stage.layout.copy()
    add_clutter(layout, stage.context, lane(seed, 0, "place"))
    return layout


def _homes(seeds: int = 5) -> Iterator[Layout]:
    for home in ("three_room_flat_2", "apartment_1", "country_house_3"):
        for seed in range(seeds):
            yield _cluttered(home, seed)


def _loose(layout: Layout) -> list[ObjectInstance]:
    return [item for item in layout.items.values() if not item.fixed]


@pytest.mark.parametrize("home", ["three_room_flat_2", "apartment_1"])
def test_every_home_holds_sixty_things(home: str) -> None:
    for seed in range(3):
        assert len(_loose(_cluttered(home, seed))) >= LEAST_THINGS > 60


def test_some_things_stand_on_or_in_small_ones() -> None:
    """Fruit in a bowl, a cup on its coaster, a book on a book: a home has a few, piles aside."""
    held = [
        sum(
            not target.fixed and target.asset != item.asset
            for item in _loose(layout)
            if (target := layout.items.get(layout.intents[item.id].target_id))
        )
        for layout in _homes()
    ]
    assert 2 <= sum(held) / len(held) <= 8


def test_no_room_and_no_home_has_more_of_a_category_than_the_catalogue_allows() -> None:
    for layout in _homes():
        in_home = Counter(item.category for item in _loose(layout))
        in_rooms = Counter((item.category, item.room_id) for item in _loose(layout))
        for category, found in in_home.items():
            assert found <= (KINDS[category].at_most.home or found), category
        for (category, _), found in in_rooms.items():
            assert found <= (KINDS[category].at_most.room or found), category


def test_two_of_a_model_stand_side_by_side_only_where_they_come_in_several() -> None:
    for layout in _homes():
        there = Counter(
            (layout.intents[item.id].target_id, item.asset, item.category, _board(item))
            for item in _loose(layout)
        )
        twice = {category for (_, _, category, _), count in there.items() if count > 1}
        assert all(KINDS[category].alike for category in twice), twice


def _board(item: ObjectInstance) -> float:
    """How high it stands, near enough to tell one board of a shelf from the next."""
    return round(item.pose.position_m[2], 1)


def test_compartments_hold_what_lives_in_them() -> None:
    seen = Counter[str]()
    for layout in _homes(12):
        for item in _loose(layout):
            intent = layout.intents[item.id]
            target = layout.items.get(intent.target_id)
            if target is None or intent.relation != "INSIDE":
                continue
            if target.category not in ("fridge", "kitchen_counter"):
                continue
            hollow = _hollow(item, target, layout)
            frozen = any("freezer" in abode.targets for abode in KINDS[item.category].lives)
            if target.category == "fridge":
                assert (hollow == "freezer") == frozen, (item.category, hollow)
                seen[hollow] += 1
            if target.category == "kitchen_counter":
                cutlery = any(abode.hollow == "drawer" for abode in KINDS[item.category].lives)
                assert hollow.startswith("drawer") == cutlery, (item.category, hollow)
                seen["drawer"] += cutlery
    assert min(seen[k] for k in ("inside", "freezer", "drawer")) > 0


def _hollow(item: ObjectInstance, target: ObjectInstance, layout: Layout) -> str:
    """The name of the hollow of furniture that is shut, in whose box the middle of a thing is."""
    x, y, z = item.pose.position_m
    middle = (x, y, z + layout.info(item.id).extents_m[2] / 2)
    local = apply(inverse(target.pose.matrix()), [middle])[0]
    for hollow in layout.info(target.id).containers:
        off = np.abs(local - np.array(hollow.center_m)) - np.array(hollow.size_m) / 2
        if off.max() <= 0:
            return hollow.name
    raise AssertionError(f"{item.category} is in no hollow of the {target.category}")


class _Nothing:
    """Views that show nothing at all."""

    def thing(self, _corners_m: Array) -> bool:
        return False

    def set_to(self, _object_id: int, _state: str) -> tuple[()]:
        return ()

    def anything_on(self, _target_id: int) -> bool:
        return False

    def floor(self, shape: BaseGeometry) -> BaseGeometry:
        return shape


def test_a_fridge_is_as_full_open_as_shut() -> None:
    """What is kept in it does not ask whether a view looks in."""
    base = next(h for h in CATALOG.homes if h.id == "apartment_1")
    models = SplitModels(shipped_library(), "test")
    stage = furnished_home(
        base, CATALOG, shipped_library(), models, iter(range(1, 60000)), lane(1, 0, "furnish")
    )
    assert isinstance(stage, FurnishedHome)
    held: dict[str, int] = {}
    for state in ("CLOSED", "OPEN"):
        held[state] = 0
        for k in range(4):
            layout = stage.layout.copy()
            fridge = next(i for i in layout.items.values() if i.category == "fridge")
            as_it_is = in_state(fridge, layout.info(fridge.id), state, lane(1, k, "state"))
            assert as_it_is is not None
            layout.put(as_it_is)
            add_clutter(layout, replace(stage.context, shows=_Nothing()), lane(1, k, "place"))
            held[state] += sum(
                intent.relation == "INSIDE" and intent.target_id == fridge.id
                for intent in layout.intents.values()
            )
    assert held["CLOSED"] > 16
    assert held["OPEN"] > 0.8 * held["CLOSED"]


def test_what_is_cut_opened_or_poured_lives_only_where_the_catalogue_says() -> None:
    """Halves and opened tins in the fridge; nobody left a glass of wine about."""
    library, seen = shipped_library(), Counter[str]()
    for category in CATALOG.categories:
        named = {abode.state for abode in category.lives if abode.state}
        models = library.by_category(category.name)
        for abode in category.lives:
            rests = [set(rest_states(model)) for model in living_so(category, abode, models)]
            if abode.state:
                assert rests, f"no {category.name} comes {abode.state}"
                assert all(abode.state in states for states in rests)
            else:
                assert all(named.isdisjoint(states) for states in rests)
    for layout in _homes():
        for item in _loose(layout):
            states = {"CUT", "OPENED", "CREAMED"} & set(item.states)
            target = layout.items.get(layout.intents[item.id].target_id)
            assert not states or (target and target.category == "fridge"), item.asset
            seen.update(states)
    assert seen["CUT"]


def test_what_is_looked_at_looks_at_no_wall(monkeypatch: pytest.MonkeyPatch) -> None:
    """However far people turn a clock on a nightstand in a corner."""
    monkeypatch.setattr("sdgen.home.layout.FRONT_SPREAD_RAD", 1.5)
    seen = 0
    for seed in range(8):
        stage = _furnished("apartment_1", seed)
        layout = stage.layout.copy(iter(range(60000, 61000)))
        add_clutter(layout, stage.context, lane(seed, 0, "place"))
        for item in _loose(layout):
            if item.category in layout.fronted:
                spot = item.pose.position_m, yaw_of(item.pose.quat_xyzw)
                assert not stage.context.faces_wall(item.room_id, spot), (seed, item.asset)
                seen += 1
    assert seen > 5
