"""Kitchens as runs: units without gaps, a corner unit where they turn, wall units in line."""

from __future__ import annotations

import math
from itertools import count

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.anchors import HUNG_GAP_M
from sdgen.home.generate import HEIGHTS_M
from sdgen.home.hoods import CHIMNEY_M, HIGHEST_M, LOWEST_M, underside_of
from sdgen.home.wall_units import fewest
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome, furnished_home, pick_home
from sdgen.seeding import lane

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
SUITES = {m.id: m.suite for m in LIBRARY.by_category("wall_cabinet")}
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


def side_gaps(item, others):
    """Between the sides of a piece and those of others at the same wall, metres; below 0: they
    overlap."""
    return [
        abs(in_frame(item, other)[1]) - (width(item) + width(other)) / 2
        for other in others
        if other is not item and same_yaw(item, other) and abs(in_frame(item, other)[0]) < 0.3
    ]


def test_wall_units_of_a_kitchen_are_of_one_height_depth_and_suite(kitchens):
    for pieces in kitchens:
        cabinets = pieces.get("wall_cabinet", ())
        models = [LIBRARY.info(c.asset) for c in cabinets]
        assert len({round(m.extents_m[0], 2) for m in models}) <= 1
        assert len({m.extents_m[2] for m in models}) <= 1
        assert len({SUITES[c.asset] for c in cabinets}) <= 1
        assert len({c.pose.position_m[2] for c in cabinets}) <= 1


def test_no_wall_unit_hangs_alone(kitchens):
    """Each has another right beside it, or a hood with one at its other side."""
    for pieces in kitchens:
        cabinets, hoods = pieces.get("wall_cabinet", []), pieces.get("range_hood", [])
        for cabinet in cabinets:
            beside = [gap for gap in side_gaps(cabinet, cabinets) if gap < 0.02]
            flanked = [
                hood
                for hood in hoods
                if min(side_gaps(cabinet, [hood]), default=1.0) < 0.03
                and sum(gap < 0.03 for gap in side_gaps(hood, cabinets)) == 2
            ]
            assert beside or flanked


def test_what_hangs_is_over_base_units_and_overlaps_nothing(kitchens):
    hoods = cabinets = 0
    for pieces in kitchens:
        under = ("kitchen_counter", "sink_cabinet", "dishwasher", "corner_counter")
        below = [unit for category in under for unit in pieces.get(category, ())]
        hung = [*pieces.get("wall_cabinet", ()), *pieces.get("range_hood", ())]
        for piece in hung:
            assert min(side_gaps(piece, hung), default=0.0) > -0.001
        for cabinet in pieces.get("wall_cabinet", ()):
            cabinets += 1
            assert any(math.hypot(*in_frame(unit, cabinet)) < 0.85 for unit in below)
        for hood in pieces.get("range_hood", ()):
            hoods += 1
            assert abs(in_frame(pieces["stove"][0], hood)[1]) < 0.01
            # Flush with a row, or clearly apart.
            gaps = side_gaps(hood, pieces.get("wall_cabinet", ()))
            assert all(gap < 0.03 or gap > 0.15 for gap in gaps)
    assert hoods
    assert cabinets > len(kitchens)


def test_chimneys_end_at_the_ceiling(kitchens):
    ends = set()
    for pieces in kitchens:
        for hood in pieces.get("range_hood", ()):
            tall = LIBRARY.info(hood.asset).extents_m[2]
            if tall > CHIMNEY_M:
                ends.add(round(hood.pose.position_m[2] + tall + HUNG_GAP_M, 3))
                assert LOWEST_M <= hood.pose.position_m[2] <= HIGHEST_M
    assert ends
    assert ends <= set(HEIGHTS_M)


@pytest.mark.parametrize("ceiling_m", HEIGHTS_M)
def test_some_hood_with_a_chimney_fits_under_every_ceiling(ceiling_m):
    hoods = LIBRARY.by_category("range_hood")
    tall = [m for m in hoods if m.extents_m[2] > CHIMNEY_M]
    assert any(underside_of(model, 1.6, ceiling_m) for model in tall)
    for model in hoods:
        if model not in tall:
            assert underside_of(model, 1.6, ceiling_m) == 1.6
    assert all(underside_of(model, 1.6, 3.2) is None for model in tall)


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
