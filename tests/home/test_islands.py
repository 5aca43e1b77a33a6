"""Kitchens with an island, and round two corners: room to walk, worktops that join."""

from __future__ import annotations

import math
from itertools import count

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import FurnitureRule
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home import runs
from sdgen.home.islands import with_island
from sdgen.home.layout import Layout, corners_of
from sdgen.home.room_try import RoomTry, empty_room
from sdgen.scene import Home, Room
from sdgen.seeding import lane
from shapely.geometry import Polygon

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
RULES = next(t.furniture for t in CATALOG.room_types if t.name == "kitchen")
(RUN,) = (rule for rule in RULES if rule.where == "run")
(ISLAND,) = (rule for rule in RULES if rule.where == "island")


def kitchen(wide_m: float, long_m: float, seed: int) -> RoomTry:
    corners = ((0.0, 0.0), (wide_m, 0.0), (wide_m, long_m), (0.0, long_m))
    room = Room(id=1, name="kitchen", type="kitchen", polygon_m=corners, height_m=2.6)
    home = Home.model_construct(rooms=(room,), openings=())
    layout = Layout(LIBRARY, count(2))
    rng = lane(seed, 0, "kitchen")
    return empty_room(home, room, layout, CATALOG, SplitModels(LIBRARY, "test"), rng)


def shapes(tried: RoomTry, ids) -> list[Polygon]:
    items = [tried.layout.items[k] for k in ids]
    return [
        Polygon(
            corners_of(
                LIBRARY.info(item.asset), *item.pose.position_m[:2], yaw_of(item.pose.quat_xyzw)
            )
        )
        for item in items
    ]


@pytest.fixture
def round_two(monkeypatch):
    monkeypatch.setattr(runs, "SHAPES", {"u": 1.0})
    monkeypatch.setattr(runs, "APART", ())


@pytest.mark.parametrize("wide_m", [2.95, 3.15, 3.3])
def test_a_run_round_two_corners_fills_the_wall_between_them(wide_m, round_two):
    made = runs.with_run(RUN, kitchen(wide_m, 3.6, 1))
    assert made is not None
    first, second = (made.layout.items[k] for k in made.all(["corner_counter"]))
    yaws = {round(yaw_of(item.pose.quat_xyzw), 3) for item in made.layout.items.values()}
    assert len(yaws) == 3
    middle = [
        item
        for item in made.layout.items.values()
        if item.category != "corner_counter"
        and math.isclose(yaw_of(item.pose.quat_xyzw), yaw_of(second.pose.quat_xyzw), abs_tol=0.01)
    ]
    filled = sum(LIBRARY.info(i.asset).extents_m[1] for i in (first, second, *middle))
    # Thin gaps between units, and what the worktops reach behind them at both ends.
    assert wide_m - filled < 0.012 * (len(middle) + 1) + 2 * (0.03 + 0.06) + 0.001
    between = [a.distance(b) for a in shapes(made, made.prints) for b in shapes(made, made.prints)]
    assert max(between) > 1.2


def test_a_run_round_two_corners_takes_a_unit_more_where_the_wall_does(round_two):
    """Of what is drawn alone one in eight fills this wall."""
    assert sum(runs.with_run(RUN, kitchen(3.3, 3.2, seed)) is not None for seed in range(8)) >= 6


def test_a_fridge_apart_from_its_run_stands_in_a_corner(monkeypatch):
    monkeypatch.setattr(runs, "SHAPES", {"apart": 1.0})
    stood = 0
    for seed in range(8):
        made = runs.with_run(RUN, kitchen(3.6, 3.9, seed))
        if made is None:
            continue
        stood += 1
        (x0, y0, x1, y1) = shapes(made, made.all(["fridge"]))[0].bounds
        assert min(x0, 3.6 - x1) < 0.25
        assert min(y0, 3.9 - y1) < 0.25
    assert stood >= 6


def test_a_wall_too_short_for_two_corners_has_none(round_two):
    assert runs.with_run(RUN, kitchen(2.4, 2.5, 1)) is None


def test_an_island_stands_a_metre_from_all_else_and_faces_a_run():
    before = runs.with_row(RUN, kitchen(4.2, 4.5, 3))
    assert before is not None
    made = with_island(ISLAND, before)
    assert made is not None
    new = [k for k in made.layout.items if k not in before.layout.items]
    units = [k for k in new if made.layout.items[k].category == "kitchen_counter"]
    seats = [k for k in new if made.layout.items[k].category == "bar_stool"]
    assert len(units) == 2
    for shape in shapes(made, units):
        assert min(shape.distance(other) for other in shapes(made, before.layout.items)) >= 0.99
        assert made.outline.exterior.distance(shape) >= 0.99
    (ahead,) = {round(yaw_of(made.layout.items[k].pose.quat_xyzw), 3) for k in units}
    runs_yaws = [yaw_of(item.pose.quat_xyzw) for item in before.layout.items.values()]
    assert min(math.cos(ahead - yaw) for yaw in runs_yaws) < -0.99
    assert len(seats) <= 3
    for shape in shapes(made, seats):
        assert min(shape.distance(other) for other in shapes(made, units)) < 0.1


def test_what_comes_after_an_island_keeps_off_it():
    before = runs.with_row(RUN, kitchen(4.2, 4.5, 3))
    made = with_island(ISLAND, before)
    owner, around = made.keep[-1]
    assert made.layout.items[owner].category == "kitchen_counter"
    assert all(around.contains(s) for s in shapes(made, [owner]))


def test_a_small_kitchen_has_no_island():
    before = runs.with_row(RUN, kitchen(2.8, 4.5, 3))
    assert before is not None
    assert with_island(ISLAND, before) is None


def test_an_island_asks_for_a_row_and_turns_no_corner():
    with pytest.raises(ValueError, match="needs it"):
        FurnitureRule(where="island", category="kitchen_counter")
    with pytest.raises(ValueError, match="does not go with"):
        FurnitureRule(where="island", row=("kitchen_counter",), corner="corner_counter")
