"""Recipes that name other things: near them, before them, over an edge; what they bring along."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from sdgen.actions import in_state
from sdgen.catalog.cases import cases, unique_anomaly
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Before, Near, PlaceRecipe, SetRecipe
from sdgen.facts import Body
from sdgen.facts.body import gaps
from sdgen.hazards.candidates import Candidate, candidates, lacking
from sdgen.hazards.inject import inject
from sdgen.hazards.placing import Injected, inject_candidate
from sdgen.home.layout import Layout
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.pipeline.spec import node_ids
from sdgen.rejection import Rejection
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
TRIES = 12


def categories(layout: Layout, *names: str) -> list[int]:
    return [item.id for item in layout.items.values() if item.category in names]


def place(**changes: Any) -> PlaceRecipe:
    values = {"categories": ("towel",), "relation": "ON", "targets": ("floor",)}
    return PlaceRecipe(**(values | changes))


def put(
    home: FurnishedHome, recipe: PlaceRecipe | SetRecipe, hazard: str = "spill"
) -> tuple[Layout, Injected]:
    """The layout after the first try of a dozen that finds a place."""
    for k in range(TRIES):
        layout = home.layout.copy(node_ids(lane(3, k, "ids"), home.ids))
        for candidate in candidates(hazard, [recipe], layout, home.context):
            before = dict(layout.items), dict(layout.intents)
            made = inject_candidate(candidate, layout, home.context, (), lane(3, k, "near"))
            if made is not None:
                return layout, made
            assert (layout.items, layout.intents) == before, "what does not fit changes nothing"
    raise AssertionError(f"no place in {TRIES} tries")


def gap(layout: Layout, one: int, other: int) -> float:
    a, b = (Body(layout.items[k], layout.info(k)) for k in (one, other))
    return float(gaps(a.low, a.high, b.low[None], b.high[None])[0])


def test_near_what_is_there(home: FurnishedHome) -> None:
    layout, made = put(home, place(near=Near(to=("bed",), max_m=0.3)))
    assert made.brought == ()
    assert min(gap(layout, made.object_id, k) for k in categories(layout, "bed")) <= 0.3


def test_near_what_is_there_and_is_brought_into_a_state(home: FurnishedHome) -> None:
    near = Near(to=("stove",), to_state="ON", max_m=0.05, bring=True)
    layout, made = put(home, place(categories=("mug",), targets=("stove",), near=near))
    (stove,) = made.brought
    assert layout.items[stove].category == "stove"
    assert "ON" in layout.items[stove].states
    assert "ON" not in home.layout.items[stove].states
    assert gap(layout, made.object_id, stove) <= 0.05


def test_without_bring_a_stove_stays_off(home: FurnishedHome) -> None:
    near = Near(to=("stove",), to_state="ON", max_m=0.05)
    with pytest.raises(AssertionError, match="no place"):
        put(home, place(categories=("mug",), targets=("stove",), near=near))


def test_what_is_not_there_is_brought_along(home: FurnishedHome) -> None:
    assert not categories(home.layout, "heater")
    near = Near(to=("heater",), to_state="ON", max_m=0.35, bring=True)
    layout, made = put(home, place(categories=("laundry_basket",), near=near))
    (heater,) = made.brought
    assert "ON" in layout.items[heater].states
    assert layout.items[heater].room_id == layout.items[made.object_id].room_id
    assert gap(layout, made.object_id, heater) <= 0.35
    assert set(layout.items) - set(home.layout.items) == {heater, made.object_id}


def test_furniture_is_never_brought(home: FurnishedHome) -> None:
    near = Near(to=("bathtub",), max_m=0.2, bring=True)
    layout = home.layout.copy(node_ids(lane(3, 0, "ids"), home.ids))
    for key in categories(layout, "bathtub"):
        layout.drop(key)
    recipe = place(near=near)
    candidate = Candidate(unique_anomaly("spill", cases(recipe)[0]), recipe)
    before = dict(layout.items)
    assert inject_candidate(candidate, layout, home.context, (), lane(3, 0, "x")) is None
    assert layout.items == before


def test_before_the_front_door(home: FurnishedHome) -> None:
    before = Before(of=("front_door",), max_m=1.2)
    layout, made = put(home, place(categories=("cardboard_box",), before=before))
    (door,) = categories(layout, "front_door")
    low, high = layout.box_of(layout.items[door])
    world = layout.items[door].pose.matrix()
    x, y, _ = np.linalg.inv(world)[:3] @ (*layout.items[made.object_id].pose.position_m, 1.0)
    assert low[0] - 1.2 <= x <= high[0] + 1.2
    assert low[1] <= y <= high[1]


@pytest.mark.parametrize("reach_m", [(0.04, 0.12), (-0.06, -0.02)])
def test_over_an_edge(home: FurnishedHome, reach_m: tuple[float, float]) -> None:
    """So far beyond the surface, and over nothing that would catch it."""
    recipe = place(
        categories=("frying_pan",),
        targets=("kitchen_table", "desk", "dining_table", "coffee_table"),
        over_edge=reach_m,
    )
    layout, made = put(home, recipe)
    item = layout.items[made.object_id]
    body = Body(item, layout.info(item.id))
    (target,) = {layout.intents[item.id].target_id}
    surface = min(layout.surfaces_of(target), key=lambda s: abs(s.z_m - float(body.low[2]))).edge
    corners = shapely.points(body.corners[:, :2])
    beyond = float(shapely.distance(corners, surface).max())
    if reach_m[0] > 0:
        # Its box reaches so far; the handle's end is rounded and points a little askew.
        assert reach_m[0] - 0.04 <= beyond <= reach_m[1] + 0.01
    else:
        assert beyond <= 0.005
        nearest = float(shapely.distance(corners, surface.exterior).min())
        assert -reach_m[1] - 0.005 <= nearest <= -reach_m[0] + 0.04


def test_near_on_the_floor_plan_is_near_at_any_height(home: FurnishedHome) -> None:
    near = Near(to=("kitchen_counter", "sink_cabinet", "tv_stand", "desk"), max_m=0.1)
    above = place(categories=("mug",), targets=("wall_shelf", "fridge"), min_height_m=1.4)
    with pytest.raises(AssertionError, match="no place"):
        put(home, above.model_copy(update={"near": near}))
    from_above = near.model_copy(update={"from_above": True})
    layout, made = put(home, above.model_copy(update={"near": from_above}))
    mug, *others = (
        Body(layout.items[k], layout.info(k))
        for k in (made.object_id, *categories(layout, *near.to))
    )
    plan = [gaps(mug.low[:2], mug.high[:2], o.low[None, :2], o.high[None, :2])[0] for o in others]
    assert min(plan) <= 0.15  # measured at the box that it fills, turned


def test_near_is_in_the_same_room(home: FurnishedHome) -> None:
    """Two metres from a bed may be beyond a wall; from a door it is near in both of its rooms."""
    found = {"bed": set[int](), "door": set[int]()}
    for name, rooms in found.items():
        for k in range(TRIES):
            layout = home.layout.copy(node_ids(lane(4, k, "ids"), home.ids))
            recipe = place(near=Near(to=(name,), max_m=2.0))
            for candidate in candidates("spill", [recipe], layout, home.context):
                made = inject_candidate(candidate, layout, home.context, (), lane(4, k, "near"))
                if made is not None:
                    rooms.add(layout.items[made.object_id].room_id)
    beds, doors = (
        {home.layout.items[k].room_id for k in categories(home.layout, name)} for name in found
    )
    assert found["bed"]
    assert found["bed"] <= beds
    assert found["door"] - doors


def test_set_only_what_is_near(home: FurnishedHome) -> None:
    near = Near(to=("bed",), max_m=0.8)
    layout, made = put(
        home, SetRecipe(categories=("wardrobe", "nightstand"), state="OPEN", near=near)
    )
    beds = categories(layout, "bed", "child_bed")
    assert min(gap(layout, made.object_id, k) for k in beds) <= 2.0
    far = SetRecipe(categories=("stove",), state="ON", near=Near(to=("bed",), max_m=0.01))
    with pytest.raises(AssertionError, match="no place"):
        put(home, far)


@pytest.mark.parametrize(
    "recipe",
    [
        SetRecipe(categories=("stove",), state="ON", rooms=("kitchen", "living_room")),
        place(targets=("floor",), rooms=("kitchen", "living_room")),
    ],
)
def test_each_room_is_a_way_of_its_own_for_what_is_set_or_on_a_floor(
    home: FurnishedHome, recipe: PlaceRecipe | SetRecipe
) -> None:
    found = [unique_anomaly("stove_on", case) for case in cases(recipe)]
    assert [one.room for one in found] == ["kitchen", "living_room"]
    for candidate in candidates("stove_on", [recipe], home.layout, home.context):
        layout = home.layout.copy(node_ids(lane(3, 1, "ids"), home.ids))
        made = inject_candidate(candidate, layout, home.context, (), lane(3, 1, "room"))
        if made is not None:
            room = home.context.room_type(layout.items[made.object_id].room_id)
            assert room == candidate.unique.room


def test_on_furniture_the_room_says_no_more() -> None:
    recipe = place(targets=("desk",), rooms=("office", "bedroom"))
    assert [unique_anomaly("spill", case).room for case in cases(recipe)] == [None]


def test_a_stove_lit_for_a_pan_is_the_stove_that_is_on(home: FurnishedHome) -> None:
    """Two drawn hazards share the object, as one is brought along by the other."""
    near = Near(to=("stove",), to_state="ON", max_m=0.05, bring=True)
    pan = place(categories=("mug",), targets=("stove",), near=near)
    hot = CATALOG.hazard("spill").model_copy(update={"id": "hot_pan", "anomalies": (pan,)})
    catalog = CATALOG.model_copy(update={"hazards": (*CATALOG.hazards, hot)})
    context = type(home.context)(
        home.context.home, home.context.zones, catalog, home.context.models, home.context.reach
    )
    for k in range(TRIES):
        layout = home.layout.copy(node_ids(lane(3, k, "ids"), home.ids))
        made = inject(["hot_pan", "stove_on"], layout, context, False, lane(3, k, "both"))
        if not isinstance(made, Rejection):
            first, second = made
            assert first.brought == (second.object_id,)
            assert second.hazard == "stove_on"
            assert second.before is not None
            return
    raise AssertionError("never placed")


def test_several_are_brought_along_or_nothing_is_changed(home: FurnishedHome) -> None:
    near = Near(to=("plate", "bowl"), to_state="DIRTY", max_m=0.6, bring=True, count=3)
    table = ("kitchen_table", "kitchen_counter", "dining_table")
    recipe = place(categories=("mug",), state="DIRTY", targets=table, near=near)
    layout, made = put(home, recipe)
    assert len(set(made.brought)) == 3
    for key in made.brought:
        assert "DIRTY" in layout.items[key].states
        assert gap(layout, made.object_id, key) <= 0.6
    with pytest.raises(AssertionError, match="no place"):
        put(home, recipe.model_copy(update={"near": near.model_copy(update={"max_m": 0.0})}))


def test_a_state_is_reached_by_what_is_nothing_further() -> None:
    """A tub that is to be FULL does not run over, and a tap that is ON fills none."""
    tub = next(a for a in LIBRARY.by_category("bathtub") if "OVERFLOWING" in a.state_names)
    thing = Layout(LIBRARY, iter([1])).new_thing(tub)
    for state, others in (("FULL", {"OFF"}), ("ON", set()), ("OVERFLOWING", {"FULL", "ON"})):
        made = [in_state(thing, tub, state, lane(1, k, "tub")) for k in range(12)]
        assert {one.states for one in made if one is not None} == {tuple(sorted({state, *others}))}


def test_what_lies_across_a_way_has_its_ends_beside_it(home: FurnishedHome) -> None:
    """A cord, which is wider than ways are; what is all in one lies away from furniture, too."""
    context = home.context
    cord = place(categories=("power_cable",), zone=("walkway",), across=True)
    shares = []
    for k in range(TRIES):
        layout = home.layout.copy(node_ids(lane(4, k, "ids"), home.ids))
        (candidate, *_) = candidates("spill", [cord], layout, context)
        made = inject_candidate(candidate, layout, context, (), lane(4, k, "across"))
        if made is not None:
            item = layout.items[made.object_id]
            body = Body(item, layout.info(item.id))
            print_ = body.footprint
            ways = context.zone_shape(("walkway",), item.room_id)
            shares.append(print_.intersection(ways).area / print_.area)
    assert len(shares) >= TRIES // 3
    assert min(shares) >= 0.65
    assert any(share < 0.97 for share in shares)


def test_the_only_bath_of_a_home_is_full_and_runs_over(home: FurnishedHome) -> None:
    """Whichever is asked for first: it stays full for the one while it comes to be the other."""
    catalog = load_catalog(extensions=["water"])
    context = replace(home.context, catalog=catalog)
    for order in (("full_bath", "overflowing_bath"), ("overflowing_bath", "full_bath")):
        layout = home.layout.copy(node_ids(lane(5, 1, "ids"), home.ids))
        assert len(categories(layout, "bathtub")) == 1
        made = inject(order, layout, context, False, lane(5, 1, "place"))
        assert not isinstance(made, Rejection)
        assert len({one.object_id for one in made}) == 1
        states = layout.items[made[0].object_id].states
        assert {"FULL", "OVERFLOWING"} <= set(states)


def test_what_is_brought_along_lies_in_nobodys_way(home: FurnishedHome) -> None:
    """Nor where a door swings; only beside what is itself to be in the way may it be."""
    near = Near(to=("bucket",), max_m=0.4, bring=True)
    recipe, found = place(avoid_zones=("doorway", "walkway"), near=near), 0
    for k in range(4 * TRIES):
        layout = home.layout.copy(node_ids(lane(6, k, "ids"), home.ids))
        for candidate in candidates("spill", [recipe], layout, home.context):
            made = inject_candidate(candidate, layout, home.context, (), lane(6, k, "near"))
            if made is None:
                continue
            (bucket,), found = made.brought, found + 1
            body = Body(layout.items[bucket], layout.info(bucket))
            for kind in ("doorway", "swing"):
                shape = home.context.zone_shape((kind,))
                assert shape.intersection(body.footprint).area <= 0.25 * body.footprint.area, kind
            break
    assert found >= 10


def test_a_home_that_lacks_what_a_hazard_needs_says_so(home: FurnishedHome) -> None:
    recipe = place(near=Near(to=("pet_bowl",), max_m=0.4, bring=True))
    layout, context = home.layout.copy(), home.context
    assert lacking([recipe], layout, context) is None
    nobodys = replace(context, models=lambda c: () if c == "pet_bowl" else context.models(c))
    assert lacking([recipe], layout, nobodys) == "pet_bowl"
    assert lacking([recipe, place()], layout, nobodys) is None
    assert lacking([place(targets=("snow_globe",))], layout, context) == "snow_globe"
    assert lacking([SetRecipe(categories=("snow_globe",), state="ON")], layout, context)
