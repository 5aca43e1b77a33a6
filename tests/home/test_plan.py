"""Floor plans: rooms apart, each with a wall that a door fits in to the room it opens from, lit, of
the size asked."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.catalog.home_yaml import HomeYaml
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import HomeMix
from sdgen.home import plan as planning
from sdgen.home.generate import generate_home
from sdgen.home.plan import LARGEST_M, WINDOW_WALL_M, Plan, plans_random
from sdgen.home.plan_openings import openings_random
from sdgen.home.plan_rooms import DOOR_WALL_M, FRONT_DOOR_WALL_M
from sdgen.home.walls import Owners, Wall, shared_walls
from sdgen.rejection import Rejection, reject
from sdgen.seeding import lane
from sdgen.vocabulary import INNER_DOORS
from shapely import LineString, box
from shapely.ops import unary_union

CATALOG = load_catalog()
MIXES = {mix.name: mix for mix in CATALOG.mixes}
TYPES = {t.name: t for t in CATALOG.room_types}


EXACT_M = 1e-6


def plan_random(mix, types, rng) -> Plan:
    """The best plan of a lane."""
    return plans_random(mix, types, rng)[0]


def shape(plan: Plan, room: int):
    return unary_union([box(*r) for r in plan.rooms[room].rectangles_m])


@pytest.mark.parametrize("name", sorted(MIXES))
@settings(max_examples=8, deadline=None)
@given(seed=st.integers(0, 10_000))
def test_a_plan_holds_the_mix(name, seed):
    mix = MIXES[name]
    plan = plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan"))
    assert [room.type for room in plan.rooms] == [mix.hub, *mix.rooms]
    assert 3 <= len(plan.rooms) <= 10
    shapes = [shape(plan, k) for k in range(len(plan.rooms))]
    for a, b in combinations(shapes, 2):
        assert a.intersection(b).area < 1e-9
    for k, room in enumerate(plan.rooms):
        assert shapes[k].geom_type == "Polygon"
        x0, y0, x1, y1 = room.rectangles_m[0]
        assert min(x1 - x0, y1 - y0) >= TYPES[room.type].narrowest_m - EXACT_M
        low, high = TYPES[room.type].area_m2
        assert 0.85 * low <= shapes[k].area <= 1.15 * high
        assert room.area_m2 == pytest.approx(shapes[k].area)
        if k:
            between = plan.between(plan.parents[k], k)
            assert max(w.length_m for w in between) >= DOOR_WALL_M - EXACT_M
        if room.spec.daylight:
            assert max(w.length_m for w in plan.outer(k)) >= WINDOW_WALL_M - EXACT_M
    assert max(w.length_m for w in plan.outer(0)) >= FRONT_DOOR_WALL_M - EXACT_M
    whole = unary_union(shapes)
    assert whole.geom_type == "Polygon"
    assert not whole.interiors
    x0, y0, x1, y1 = whole.bounds
    assert max(x1 - x0, y1 - y0) <= LARGEST_M + EXACT_M
    assert max(abs(v) for v in (x0, y0, x1, y1)) <= LARGEST_M / 2 + 0.2


def test_rooms_open_from_those_that_the_mix_names():
    mix = MIXES["corridor_8"]
    types = (mix.hub, *mix.rooms)
    ways = {types[k]: types[p] for k, p in enumerate(mix.parents()) if k}
    assert ways == {
        "living_room": "hall",
        "kitchen": "living_room",
        "corridor": "hall",
        "bedroom": "corridor",
        "child_room": "corridor",
        "bathroom": "corridor",
        "toilet": "hall",
    }


def test_what_opens_from_a_type_that_comes_twice_is_shared_out():
    mix = HomeMix(
        name="two", weight=1, hub="hall", rooms=("bedroom", "bedroom", "bathroom", "bathroom"),
        off=(("bathroom", "bedroom"),),
    )  # fmt: skip
    assert mix.parents() == (-1, 0, 0, 1, 2)


def test_nobody_goes_through_a_private_room_to_one_that_all_use():
    private = {"bedroom", "child_room", "bathroom", "toilet", "storage"}
    for mix in CATALOG.mixes:
        types = (mix.hub, *mix.rooms)
        passed = {types[p] for p in mix.parents()[1:]}
        assert not passed & private, mix.name


def test_most_rooms_are_beside_those_they_wish_for():
    met = asked = 0
    for seed in range(3):
        for mix in CATALOG.mixes:
            wishes = plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan")).wishes()
            met, asked = met + sum(found for _, _, found in wishes), asked + len(wishes)
    assert met / asked > 0.8


def test_rooms_are_shared_out_between_rectangles_and_others():
    """Living rooms are rectangles, and L-shaped."""
    corners = [
        len(shape(plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan")), 1).exterior.coords)
        for seed in range(12)
        for mix in (MIXES["hall_5"],)
    ]
    assert min(corners) == 5
    assert max(corners) >= 7


def test_the_same_lane_gives_the_same_plan_and_another_a_different_one():
    mix = CATALOG.mixes[0]
    one, two = (plan_random(mix, CATALOG.room_types, lane(3, 1, "plan")) for _ in range(2))
    other = plan_random(mix, CATALOG.room_types, lane(3, 2, "plan"))
    assert one == two
    assert one != other


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10_000), k=st.integers(0, len(CATALOG.mixes) - 1))
def test_openings_sit_in_walls_clear_of_corners_and_of_each_other(seed, k):
    plan = plan_random(CATALOG.mixes[k], CATALOG.room_types, lane(seed, 0, "plan"))
    openings = openings_random(plan, lane(seed, 0, "openings"))
    if isinstance(openings, Rejection):
        return
    doors = [o for o in openings if o.kind in INNER_DOORS]
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
        assert outdoors == (opening.kind not in INNER_DOORS)


def test_every_room_that_needs_daylight_has_a_window():
    asked = 0
    for seed in range(120):
        mix = CATALOG.mixes[seed % len(CATALOG.mixes)]
        plan = plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan"))
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
    assert asked > 200


def test_a_room_whose_only_wall_to_the_outside_is_taken_by_the_door_has_no_daylight():
    outer = Wall(planning.OUTSIDE, 0, "x", 0.0, 0.0, 2.0)
    answers = {}
    for daylight in (True, False):
        spec = TYPES["living_room"].model_copy(update={"daylight": daylight})
        room = planning.PlannedRoom("hub", spec, ((0.0, 0.0, 2.0, 4.0),))
        plan = Plan((room,), (planning.OUTSIDE,), (outer,))
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
        plan = plan_random(MIXES["hall_child_6"], types, lane(seed, 0, "plan"))
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
            o.kind in INNER_DOORS and any(_on(w, o.center_m) for w in between) for o in openings
        )
    assert sills
    assert set(sills) == {(True, 1.2)}
    assert 0 < joined <= shared


def test_types_say_by_what_they_open_to_each_other():
    kinds = set()
    for seed in range(100):
        plan = plan_random(MIXES["hall_open_plan_5"], CATALOG.room_types, lane(seed, 0, "plan"))
        between = plan.between(1, 2)
        openings = openings_random(plan, lane(seed, 0, "openings"))
        if not isinstance(openings, Rejection):
            kinds |= {o.kind for o in openings if any(_on(w, o.center_m) for w in between)}
    assert kinds == set(INNER_DOORS)


def test_windows_look_outdoors_and_not_at_another_wall():
    seen = 0
    for seed in range(30):
        mix = CATALOG.mixes[seed % len(CATALOG.mixes)]
        plan = plan_random(mix, CATALOG.room_types, lane(seed, 0, "plan"))
        openings = openings_random(plan, lane(seed, 0, "openings"))
        if isinstance(openings, Rejection):
            continue
        rooms = unary_union([shape(plan, k) for k in range(len(plan.rooms))])
        for o in openings:
            if o.kind == "window":
                (x, y), (dx, dy) = o.center_m, (0, 1) if o.along == "x" else (1, 0)
                sights = [
                    LineString([(x + s * 0.1 * dx, y + s * 0.1 * dy), (x + s * dx, y + s * dy)])
                    for s in (-1, 1)
                ]
                assert any(not rooms.intersects(sight) for sight in sights)
                seen += 1
    assert seen > 100


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
