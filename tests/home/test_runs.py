"""Kitchens as runs: units without gaps, a corner unit where they turn, wall units in line."""

from __future__ import annotations

import math
from itertools import count

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.wall_units import fewest
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome, furnished_home, pick_home
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
BASE_UNITS = ("kitchen_counter", "sink_cabinet", "stove", "fridge", "corner_counter")


@pytest.fixture(scope="module")
def kitchens():
    """The pieces of some generated kitchens by category."""
    models, options = SplitModels(LIBRARY, "test"), BuildOptions(seed=2, homes="procedural")
    out = []
    for index in range(28):
        spec = pick_home(CATALOG, options, index).spec(CATALOG, lane(2, index, "plan"))
        home = furnished_home(spec, CATALOG, LIBRARY, models, count(1), lane(2, index, "furnish"))
        if not isinstance(home, FurnishedHome):
            continue
        rooms = {r.id for r in home.context.home.rooms if r.type == "kitchen"}
        pieces: dict[str, list] = {}
        for item in home.layout.items.values():
            if item.room_id in rooms and item.fixed:
                pieces.setdefault(item.category, []).append(item)
        out.append(pieces)
    assert len(out) > 10
    return out


def width(item):
    return LIBRARY.info(item.asset).extents_m[1]


def in_frame(item, other):
    """Where another piece is, seen from one: (ahead, to the left), metres."""
    yaw = yaw_of(item.pose.quat_xyzw)
    dx = other.pose.position_m[0] - item.pose.position_m[0]
    dy = other.pose.position_m[1] - item.pose.position_m[1]
    return dx * math.cos(yaw) + dy * math.sin(yaw), dy * math.cos(yaw) - dx * math.sin(yaw)


def same_yaw(a, b):
    return math.cos(yaw_of(a.pose.quat_xyzw) - yaw_of(b.pose.quat_xyzw)) > 0.999


def test_every_kitchen_has_one_run_with_what_one_cooks_with(kitchens):
    for pieces in kitchens:
        for category in ("fridge", "stove", "sink_cabinet"):
            assert len(pieces[category]) == 1, category
        assert len(pieces["kitchen_counter"]) >= 2


def test_units_of_a_leg_touch_their_neighbours(kitchens):
    for pieces in kitchens:
        units = [u for c in BASE_UNITS for u in pieces.get(c, ())]
        for unit in units:
            if unit.category in ("corner_counter", "fridge"):
                continue
            gaps = [
                abs(in_frame(unit, other)[1]) - (width(unit) + width(other)) / 2
                for other in [*units, *pieces.get("dishwasher", ())]
                if other is not unit
                and same_yaw(unit, other)
                # One line of backs: depths differ.
                and abs(in_frame(unit, other)[0]) < 0.2
            ]
            beside_corner = any(
                math.dist(unit.pose.position_m, corner.pose.position_m) < 1.2
                for corner in pieces.get("corner_counter", ())
            )
            # One that is left alone on its wall touches nothing.
            assert beside_corner or not gaps or min(gaps) <= 0.013


def test_some_kitchens_turn_a_corner_and_both_legs_join_its_unit(kitchens):
    turning = [pieces for pieces in kitchens if len(pieces.get("corner_counter", ())) == 1]
    assert turning
    for pieces in turning:
        (corner,) = pieces["corner_counter"]
        deep, wide, _ = LIBRARY.info(corner.asset).extents_m
        units = [u for c in (*BASE_UNITS[:3], "dishwasher") for u in pieces.get(c, ())]
        beside = [
            in_frame(corner, unit)[1] - (width(unit) + wide) / 2
            for unit in units
            if same_yaw(unit, corner) and abs(in_frame(corner, unit)[0]) < 0.3
        ]
        ahead = [
            in_frame(corner, unit)[0] - (width(unit) + deep) / 2
            for unit in units
            if not same_yaw(unit, corner) and abs(in_frame(corner, unit)[1]) < 0.3
        ]
        # A leg may be a fridge alone, which a leaf's width keeps off.
        assert min(beside, default=0.0) <= 0.013
        assert min(ahead, default=0.0) <= 0.013
        assert beside or ahead
        assert min(*beside, *ahead, 1.0) >= 0.011


def test_no_fridge_stands_beside_the_stove(kitchens):
    for pieces in kitchens:
        (fridge,), (stove,) = pieces["fridge"], pieces["stove"]
        apart = math.dist(fridge.pose.position_m, stove.pose.position_m)
        assert apart > (width(fridge) + width(stove)) / 2 + 0.3


def over_which(cabinet, units):
    """The base unit whose width a wall unit hangs within, if any."""
    for unit in units:
        ahead, left = in_frame(unit, cabinet)
        deep, wide, _ = LIBRARY.info(unit.asset).extents_m
        # A corner unit has arms along two walls.
        along, half = (left, wide) if same_yaw(unit, cabinet) else (ahead, deep)
        turned = not same_yaw(unit, cabinet)
        if turned and unit.category != "corner_counter":
            continue
        if abs(along) + width(cabinet) / 2 <= half / 2 + 0.008 and abs(ahead) < 0.8:
            return unit
    return None


def test_what_hangs_is_in_line_with_the_unit_it_belongs_to(kitchens):
    hoods = cabinets = 0
    for pieces in kitchens:
        under = ("kitchen_counter", "sink_cabinet", "dishwasher", "corner_counter")
        below = [unit for category in under for unit in pieces.get(category, ())]
        for cabinet in pieces.get("wall_cabinet", ()):
            cabinets += 1
            assert over_which(cabinet, below) is not None
        for hood in pieces.get("range_hood", ()):
            hoods += 1
            assert abs(in_frame(pieces["stove"][0], hood)[1]) < 0.01
    assert hoods
    assert cabinets > len(kitchens)


def test_wall_units_fill_the_width_of_base_units_that_are_not_at_windows(kitchens):
    shares = []
    for pieces in kitchens:
        for category in ("kitchen_counter", "sink_cabinet", "dishwasher"):
            for unit in pieces.get(category, ()):
                over = [c for c in pieces.get("wall_cabinet", ()) if over_which(c, [unit])]
                shares.append(sum(map(width, over)) / width(unit))
    # Half of them in forty homes; where the kitchens of so few homes have their windows, fewer.
    assert sum(share > 0.95 for share in shares) > 0.25 * len(shares)
    assert max(shares) < 1.03


def test_dishwashers_stand_by_the_sink(kitchens):
    found = 0
    for pieces in kitchens:
        (sink,) = pieces["sink_cabinet"]
        for dishwasher in pieces.get("dishwasher", ()):
            apart = math.dist(sink.pose.position_m, dishwasher.pose.position_m)
            found += apart < (width(sink) + width(dishwasher)) / 2 + 0.9
    # Of 90 kitchens 29 of 34 dishwashers.
    assert found >= 0.7 * sum(len(pieces.get("dishwasher", ())) for pieces in kitchens)
    assert found


@pytest.mark.parametrize(
    ("total", "widths", "filled"),
    [
        (6, (8, 6, 4), (6,)),
        (8, (8, 6, 4), (8,)),
        (10, (8, 6, 4), (6, 4)),
        (12, (8, 6, 4), (8, 4)),
        (12, (6,), (6, 6)),
        (10, (6,), (6,)),
        (5, (6,), ()),
        (6, (), ()),
    ],
)
def test_the_fewest_units_fill_a_width(total, widths, filled):
    assert fewest(total, widths) == filled
