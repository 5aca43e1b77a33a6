"""Floor plans: rooms apart, joined to the hub by walls a door fits in, lit, of the size asked."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.catalog.home_yaml import HomeYaml
from sdgen.catalog.load import load_catalog
from sdgen.home import plan as planning
from sdgen.home.generate import generate_home
from sdgen.home.plan import DOOR_WALL_M, FRONT_DOOR_WALL_M, LARGEST_M, Plan, plan_random
from sdgen.home.plan_openings import openings_random
from sdgen.home.walls import Owners, Wall, shared_walls
from sdgen.rejection import Rejection, reject
from sdgen.seeding import lane
from shapely import box
from shapely.ops import unary_union

CATALOG = load_catalog()
MIXES = {mix.name: mix for mix in CATALOG.mixes}
TYPES = {t.name: t for t in CATALOG.room_types}


def shape(plan: Plan, room: int):
    return unary_union([box(*r) for r in plan.rooms[room].rectangles_m])


@pytest.mark.parametrize("name", sorted(MIXES))
@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_a_plan_holds_the_mix(name, seed):
    mix = MIXES[name]
    plan = plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan"))
    assert plan is not None
    assert [room.type for room in plan.rooms] == [mix.hub, *mix.rooms]
    assert 3 <= len(plan.rooms) <= 6
    shapes = [shape(plan, k) for k in range(len(plan.rooms))]
    for a, b in combinations(shapes, 2):
        assert a.intersection(b).area < 1e-9
    for k, room in enumerate(plan.rooms):
        assert shapes[k].geom_type == "Polygon"
        x0, y0, x1, y1 = room.rectangles_m[0]
        assert min(x1 - x0, y1 - y0) >= TYPES[room.type].narrowest_m - 1e-6
        if k:
            low, high = TYPES[room.type].area_m2
            assert 0.8 * low <= shapes[k].area <= 1.2 * high
            assert max(w.length_m for w in plan.between(0, k)) >= DOOR_WALL_M
        if room.spec.daylight:
            assert max(w.length_m for w in plan.outer(k)) >= 1.9
    assert max(w.length_m for w in plan.outer(0)) >= FRONT_DOOR_WALL_M
    x0, y0, x1, y1 = unary_union(shapes).bounds
    assert max(x1 - x0, y1 - y0) <= LARGEST_M
    assert max(abs(v) for v in (x0, y0, x1, y1)) <= LARGEST_M / 2 + 0.2


def test_the_same_lane_gives_the_same_plan_and_another_a_different_one():
    mix = CATALOG.mixes[0]
    one, two = (plan_random(mix, CATALOG.room_types, lane(3, 1, "plan")) for _ in range(2))
    other = plan_random(mix, CATALOG.room_types, lane(3, 2, "plan"))
    assert one == two
    assert one != other


def test_plans_are_of_many_shapes():
    corners = set()
    for seed in range(40):
        plan = plan_random(MIXES["living_hub_5"], CATALOG.room_types, lane(seed, 0, "plan"))
        assert plan is not None
        corners.add(len(shape(plan, 0).exterior.coords))
    assert len(corners) > 1  # rectangles and L-shapes


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10_000), k=st.integers(0, len(CATALOG.mixes) - 1))
def test_openings_sit_in_walls_clear_of_corners_and_of_each_other(seed, k):
    plan = plan_random(CATALOG.mixes[k], CATALOG.room_types, lane(seed, 0, "plan"))
    assert plan is not None
    openings = openings_random(plan, lane(seed, 0, "openings"))
    if isinstance(openings, Rejection):
        return
    doors = [o for o in openings if o.kind == "door"]
    assert [o.kind for o in openings].count("front_door") == 1
    assert len(doors) >= len(plan.rooms) - 1
    for opening in openings:
        x, y = opening.center_m
        walls = [
            w
            for w in plan.walls
            if w.along == opening.along
            and abs((y if w.along == "x" else x) - w.at_m) < 1e-6
            and w.low_m + 0.3 < (x if w.along == "x" else y) < w.high_m - 0.3
        ]
        assert len(walls) == 1, opening
        outdoors = planning.OUTSIDE in (walls[0].first, walls[0].second)
        assert outdoors == (opening.kind != "door")


def test_every_room_that_needs_daylight_has_a_window():
    asked = 0
    for seed in range(120):
        mix = CATALOG.mixes[seed % len(CATALOG.mixes)]
        plan = plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan"))
        assert plan is not None
        openings = openings_random(plan, lane(seed, 0, "openings"))
        if isinstance(openings, Rejection):
            continue
        for k, room in enumerate(plan.rooms):
            windows = [
                o
                for o in openings
                if o.kind == "window" and any(_on(wall, o.center_m) for wall in plan.outer(k))
            ]
            assert len(windows) <= (1 if room.spec.windows == "small" else 2)
            if room.spec.daylight and room.spec.windows != "none":
                asked += 1
                assert windows, (seed, room.name)
    assert asked > 300


def test_a_room_whose_only_wall_to_the_outside_is_taken_by_the_door_has_no_daylight():
    outer = Wall(planning.OUTSIDE, 0, "x", 0.0, 0.0, 2.0)
    answers = {}
    for daylight in (True, False):
        spec = TYPES["living_room"].model_copy(update={"daylight": daylight})
        room = planning.PlannedRoom("hub", spec, ((0.0, 0.0, 2.0, 4.0),))
        plan = Plan((room,), (outer,))
        answers[daylight] = openings_random(plan, lane(1, 0, "openings"))
    assert answers[True] == reject("home", "no_daylight", category="living_room")
    assert [o.kind for o in answers[False]] == ["front_door"]


def test_shared_walls_of_a_known_grid():
    import numpy as np

    cells = np.full((5, 4), -1)
    cells[1:3, 1:3] = 0
    cells[3:4, 1:3] = 1
    walls = shared_walls(Owners(cells, 1.0))
    between = [w for w in walls if {w.first, w.second} == {0, 1}]
    assert len(between) == 1
    assert between[0].along == "y"
    assert between[0].length_m == 2.0
    around = sum(w.length_m for w in walls if -1 in (w.first, w.second))
    assert around == pytest.approx(2 * (3 + 2))


def test_windows_and_doors_are_as_the_room_types_ask():
    """What rooms.yaml says of a kitchen decides, not its name."""
    changed = {
        "kitchen": {"windows": "small", "sill_m": 1.2, "joined": (("bedroom", 1.0),)},
        "bedroom": {"windows": "none", "daylight": False},
    }
    types = [t.model_copy(update=changed.get(t.name, {})) for t in CATALOG.room_types]
    sills, joined, shared = [], 0, 0
    for seed in range(30):
        plan = plan_random(MIXES["living_hub_5"], types, lane(seed, 0, "plan"))
        assert plan is not None
        openings = openings_random(plan, lane(seed, 0, "openings"))
        if isinstance(openings, Rejection):
            continue
        names = [room.type for room in plan.rooms]
        kitchen, bedroom = names.index("kitchen"), names.index("bedroom")
        for opening in openings:
            walls = {
                k: any(_on(wall, opening.center_m) for wall in plan.outer(k))
                for k in (kitchen, bedroom)
            }
            if opening.kind == "window":
                assert not walls[bedroom]
                sills += [(opening.small, opening.sill_m)] if walls[kitchen] else []
        between = plan.between(kitchen, bedroom)
        shared += any(wall.length_m >= DOOR_WALL_M for wall in between)
        joined += any(
            o.kind == "door" and any(_on(w, o.center_m) for w in between) for o in openings
        )
    assert sills
    assert set(sills) == {(True, 1.2)}
    assert 0 < joined <= shared


def _on(wall, point):
    near, along = (point[1], point[0]) if wall.along == "x" else (point[0], point[1])
    at = wall.point(wall.low_m)[1 if wall.along == "x" else 0]
    return abs(near - at) < 1e-3 and wall.low_m <= along <= wall.high_m


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_a_generated_home_could_have_been_drawn(seed):
    """Its rooms and openings pass what is asked of base homes: one computation finds the walls."""
    home = generate_home("made", CATALOG.mixes, CATALOG, lane(seed, 0, "plan"))
    assert home is not None
    drawing = HomeYaml.model_validate(home.model_dump(exclude={"kind"}))
    assert drawing.record() == home.model_copy(update={"kind": "base"})
