"""Whose home it is: rooms, beds and things follow from who lives there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import cache, partial
from typing import Any

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Near, PlaceRecipe
from sdgen.geometry import Array
from sdgen.home.clutter import add_clutter
from sdgen.home.context import Everything
from sdgen.home.layout import Layout
from sdgen.home.tenants import Homes, Tenants, beds_of, sleepers, words_of
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import SceneSpec, draw_spec
from sdgen.scene import Household, Member
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
OPTIONS = BuildOptions(seed=7)
TEMPLATES = {template.name: template for template in CATALOG.households}


@cache
def _specs() -> list[SceneSpec]:
    return [draw_spec(index, CATALOG, OPTIONS) for index in range(300)]


@cache
def _homes() -> list[tuple[SceneSpec, FurnishedHome]]:
    """The first homes of a build that stand at their first attempt, still empty."""
    made = ((spec, furnish_for(spec, 0, CATALOG, shipped_library())) for spec in _specs()[:24])
    return [(spec, home) for spec, home in made if isinstance(home, FurnishedHome)]


def _children(household: Household) -> bool:
    return any(member.age <= 12 for member in household.members)


def test_the_templates_come_as_often_as_their_weights_say() -> None:
    drawn = Counter(spec.household.template for spec in _specs())
    total = sum(template.weight for template in CATALOG.households)
    for template in CATALOG.households:
        share = template.weight / total
        # Three standard errors of a share among 300.
        assert abs(drawn[template.name] / 300 - share) < 3 * (share * (1 - share) / 300) ** 0.5
    bases = sum(spec.home.base is not None for spec in _specs()) / 300
    assert 0.15 < bases < 0.35


def test_the_draw_of_hazards_knows_nothing_of_who_lives_there() -> None:
    others = CATALOG.model_copy(update={"households": CATALOG.households[:1]})
    for index in range(20):
        assert draw_spec(index, others, OPTIONS).hazards == _specs()[index].hazards


def test_children_have_a_room_and_everybody_a_bed() -> None:
    seen = Counter[str]()
    for spec, home in _homes():
        template = TEMPLATES[spec.household.template]
        rooms = Counter(room.type for room in home.context.home.rooms)
        assert Counter(template.rooms) <= rooms, template.name
        if rooms["child_room"]:
            assert _children(spec.household)
            seen["child_room"] += 1
        there = beds_of(home.layout.items.values(), shipped_library().infos, CATALOG)
        assert there >= template.sleepers, template.name
        seen["homes"] += 1
    assert seen["homes"] >= 18
    assert seen["child_room"] >= 3


def _things() -> Iterator[tuple[SceneSpec, Counter[str]]]:
    for spec, home in _homes():
        layout = home.layout.copy()
        add_clutter(layout, home.context, lane(7, spec.index, "things"))
        yield spec, Counter(item.category for item in layout.items.values())


def test_pets_have_a_bowl_and_toys_are_where_children_are() -> None:
    toys = {c.name for c in CATALOG.categories if "child" in c.belongs_to and c.kind == "small"}
    seen = Counter[str]()
    for spec, things in _things():
        assert (things["pet_bowl"] > 0) == bool(spec.household.pets)
        child = "child" in spec.tenants.words
        assert child or not toys & things.keys()
        seen["pets"] += bool(spec.household.pets)
        seen["toys"] += bool(toys & things.keys())
        seen["none"] += not toys & things.keys()
        if "infant" not in spec.tenants.words:
            assert not things["crib"]
    assert min(seen[k] for k in ("pets", "toys", "none")) >= 3


class _Nothing(Everything):
    """Views that show nothing at all."""

    def thing(self, _corners_m: Array, /) -> bool:
        return False

    def anything_on(self, _target_id: int, /) -> bool:
        return False


def test_a_pet_has_its_bowl_where_no_view_shows_it_too() -> None:
    homes = [home for spec, home in _homes() if spec.household.pets]
    assert len(homes) >= 3
    for home in homes:
        layout = home.layout.copy()
        add_clutter(layout, replace(home.context, shows=_Nothing()), lane(7, 1, "things"))
        assert any(item.category == "pet_bowl" for item in layout.items.values())


def test_a_pet_has_its_bowl_where_one_search_of_the_home_finds_no_room(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    home = next(home for spec, home in _homes() if spec.household.pets)
    bare = CATALOG.model_copy(update={"room_types": ()})
    found, calls = Layout.spot_on_floor, iter(range(1000))
    # Two abodes in every room, seen or not.
    one_search = 2 * 2 * len(home.context.home.rooms)

    def full_at_first(*args: Any, **options: Any) -> Any:
        return None if next(calls) < one_search else found(*args, **options)

    monkeypatch.setattr(Layout, "spot_on_floor", full_at_first)
    layout = home.layout.copy()
    add_clutter(layout, replace(home.context, catalog=bare), lane(7, 1, "things"))
    assert any(item.category == "pet_bowl" for item in layout.items.values())


def test_what_a_drawn_hazard_cannot_do_without_is_there_whoever_lives_there() -> None:
    models = dict.fromkeys(("toy_brick", "doll", "mug"), ("model",)).get
    brick = CATALOG.hazard("choking_hazard")
    (recipe, *_) = brick.anomalies
    only = brick.model_copy(
        update={"anomalies": (recipe.model_copy(update={"categories": ("toy_brick",)}),)}
    )
    for asked, there in (((), False), ((only,), True), ((brick,), False)):
        theirs = Tenants(frozenset(), 1, asked).models(models, CATALOG)  # type: ignore[arg-type]
        assert bool(theirs("toy_brick")) is there
        assert not theirs("doll")
        assert theirs("mug")


def test_what_a_drawn_hazard_brings_along_is_there_whoever_lives_there() -> None:
    """A trap beside a bowl needs the bowl, in homes without pets too."""
    models = dict.fromkeys(("pet_bowl", "pet_toy", "mug"), ("model",)).get
    near = Near(to=("pet_bowl",), max_m=0.5, bring=True)
    recipe = PlaceRecipe(categories=("mug",), relation="ON", targets=("floor",), near=near)
    trap = CATALOG.hazard("spill").model_copy(update={"anomalies": (recipe,)})
    either = trap.model_copy(
        update={"anomalies": (recipe, recipe.model_copy(update={"near": None}))}
    )
    for asked, there in (((), False), ((trap,), True), ((either,), False)):
        theirs = Tenants(frozenset(), 1, asked).models(models, CATALOG)  # type: ignore[arg-type]
        assert bool(theirs("pet_bowl")) is there
        assert theirs("mug")


def test_another_home_is_drawn_for_the_same_hazards_and_household() -> None:
    for index in range(12):
        first, second = (draw_spec(index, CATALOG, OPTIONS, turn) for turn in (0, 1))
        assert first.hazards == second.hazards
        assert first.household == second.household
    ids = [{draw_spec(k, CATALOG, OPTIONS, turn).home.id for turn in range(6)} for k in range(12)]
    assert any(len(found) > 1 for found in ids)


def test_words_are_pets_conditions_and_age_groups() -> None:
    household = Household(
        template="test",
        members=(Member(role="parent", age=30), Member(role="child", age=1)),
        pets=("cat",),
        conditions=("walks with a stick",),
    )
    words = words_of(household, CATALOG.groups, lane(1, 1, "visitors"))
    assert words == {"cat", "walks with a stick", "infant", "toddler", "child"}
    adult = household.model_copy(update={"members": household.members[:1]})
    visited = sum(
        "child" in words_of(adult, CATALOG.groups, lane(1, k, "visitors")) for k in range(400)
    )
    assert 20 <= visited <= 60  # one in ten


def test_a_home_for_nobody_is_open_to_all() -> None:
    one_room = CATALOG.mixes[0].model_copy(update={"hub": "office", "rooms": ("bathroom",)})
    assert all(Homes(CATALOG).fits(template, one_room) for template in CATALOG.households)


@pytest.mark.parametrize(
    ("template", "rooms", "fits"),
    [
        ("family_with_toddler", ("bedroom", "child_room"), True),
        ("family_with_toddler", ("bedroom", "bathroom"), False),
        ("family_with_school_children", ("bedroom", "child_room"), False),
        ("family_with_school_children", ("bedroom", "child_room", "child_room"), True),
        ("couple", ("bedroom", "bathroom"), True),
        ("couple", ("bedroom", "child_room"), False),
        ("flat_share", ("bedroom", "bedroom"), False),
        ("grandparents_with_grandchild", ("bedroom",), True),
    ],
)
def test_households_live_in_homes_with_their_rooms(
    template: str, rooms: tuple[str, ...], fits: bool
) -> None:
    home = CATALOG.mixes[0].model_copy(update={"hub": "kitchen", "rooms": rooms})
    assert partial(Homes(CATALOG).fits, TEMPLATES[template])(home) is fits


def test_a_narrow_bed_is_for_one() -> None:
    bed = CATALOG.category("bed")
    wide = {m.id: sleepers(bed, m) for m in shipped_library().by_category("bed")}
    assert set(wide.values()) == {1, 2}
