"""Overhang and edge: by hand, by brute force, and what pushing outwards does."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.facts.brinks import STEP_M
from sdgen.geometry import quat_from_axis_angle
from sdgen.scene import Pose

from .scenes import asset, facts, square, thing

PLANK = asset("plank", (0.6, 0.1, 0.02))
TOP = 0.75
#: A rounded coordinate of a pose, metres.
GRID = 1e-5


def measured(*things, of=2, more=()):
    f = facts(*things, more=[PLANK, *more])
    return f.overhang(of), f.edge(of)


def test_a_plank_over_the_edge_of_a_table():
    table = thing(1, "table", 2, 2)
    over, edge = measured(table, thing(2, "plank", 2.3, 2, TOP))
    assert over == (pytest.approx(0.1),) * 3
    assert edge == (0.0, 0.0, 0.0)
    over, edge = measured(table, thing(2, "plank", 2.15, 2.1, TOP))
    assert over == (0.0, 0.0, 0.0)
    assert edge == (pytest.approx(0.05),) * 3
    # Turned about, it is over with a corner.
    over, _ = measured(table, thing(2, "plank", 2.3, 2, TOP, yaw=math.pi / 4))
    assert over.measured_m == pytest.approx(0.35 / math.sqrt(2) - 0.2)


def test_over_the_neighbours_worktop_it_is_over_no_edge():
    table, plank = thing(1, "table", 2, 2), thing(2, "plank", 2.3, 2, TOP)
    beside = thing(3, "table", 3, 2)
    over, edge = measured(table, plank, beside)
    assert over.most_m == 0.0
    assert edge.measured_m == pytest.approx(0.45)
    # A chair below it is too low, and so is the floor.
    low = asset("chair", (0.5, 0.5, 0.9), supports=[{**SEAT, "z_m": 0.45}])
    chair = thing(3, "chair", 2.76, 2).model_copy(update={"fixed": True})
    assert measured(table, plank, chair, more=[low])[0].least_m == pytest.approx(0.1)
    high = asset("chair", (0.5, 0.5, 0.9), supports=[{**SEAT, "z_m": 0.6}])
    assert measured(table, plank, chair, more=[high])[0].most_m == 0.0
    # What hangs over it catches nothing.
    shelf = thing(3, "table", 3, 2, 1.2)
    assert measured(table, plank, shelf)[0].measured_m == pytest.approx(0.1)


SEAT = {"name": "seat", "part": "body", "z_m": 0.45, "polygon_m": square(0.2)}


def test_no_edge_on_the_floor_on_a_rug_or_on_nothing():
    nowhere = ((0.0,) * 3, (math.inf,) * 3)
    table = thing(1, "table", 2, 2)
    assert measured(table, thing(2, "plank", 3, 2)) == nowhere
    assert measured(table, thing(2, "plank", 2, 2, 1.2)) == nowhere
    low = asset("step", (0.4, 0.4, 0.2), supports=[{**SEAT, "z_m": 0.2}])
    assert measured(thing(1, "step", 2, 2), thing(2, "plank", 2.1, 2, 0.2), more=[low]) == nowhere


def test_a_wall_that_is_near_is_no_edge_and_one_further_off_is():
    box = thing(2, "box", 3.69, 2, TOP)
    at_wall, off_wall = thing(1, "table", 3.45, 2), thing(1, "table", 3.35, 2)
    assert measured(at_wall, box)[1].measured_m == pytest.approx(0.35)
    assert measured(off_wall, box)[1].measured_m == pytest.approx(0.01)


def test_a_cup_on_a_plate_is_where_the_plate_and_the_table_end():
    """The plate reaches over, and catches what is on it; a box that is larger than its plate is
    over the table."""
    table, plate = thing(1, "table", 2, 2), thing(3, "plate", 2.45, 2, TOP)
    over, edge = measured(table, plate, thing(2, "apple", 2.45, 2, TOP + 0.01))
    assert over.most_m == 0.0
    assert edge.measured_m == pytest.approx(0.06)  # to where the plate ends, beyond the table
    plate = thing(3, "plate", 2, 2, TOP)
    over, _ = measured(table, plate, thing(2, "box", 2, 2, TOP + 0.01))
    assert over.most_m == 0.0


def test_an_open_leaf_catches_nothing():
    """Shut, the leaf is one outline with what it is on, and below the plank; moved by a hair, it is
    no part of it, and what is left ends 0.06 m from the plank's corner."""
    body, leaf = box_points(-0.3, 0.3, 0.3), box_points(0.0, 0.4, 0.01)
    stove = asset("stove", (0.6, 0.6, TOP), outlines_m={"body": [body], "door": [leaf]})
    table, plank = thing(1, "table", 2, 2), thing(2, "plank", 2.3, 2, TOP)
    shut, opened = (
        thing(3, "stove", 2.55, 2.31, joints={"door": angle}, yaw=-math.pi / 2)
        for angle in (0.0, 0.001)
    )
    assert facts(shut, more=[stove]).bodies[3].outline.still == 1
    reached = [measured(table, plank, piece, more=[stove])[0] for piece in (shut, opened)]
    assert [over.measured_m for over in reached] == [0.0, pytest.approx(0.06)]


def test_what_stands_on_an_open_flap_is_caught_by_it():
    """Not by what else of the piece has moved: a flap drawn out by 0.5 m carries the box."""
    slide = {"name": "door", "type": "prismatic", "origin_m": (0, 0, 0), "axis": (1, 0, 0)}
    flap = {"name": "flap", "part": "door", "z_m": TOP, "polygon_m": square(0.24)}
    desk = asset(
        "desk",
        (0.5, 0.5, TOP),
        joints=[{**slide, "lower": 0, "upper": 1}],
        supports=[flap],
        outlines_m={
            "body": [box_points(-0.25, 0.25, 0.25, TOP - 0.05)],
            "door": [box_points(-0.25, 0.25, 0.25, TOP)],
        },
    )
    drawn = thing(1, "desk", 2, 2, joints={"door": 0.5}).model_copy(update={"fixed": True})
    over, edge = measured(drawn, thing(2, "box", 2.55, 2, TOP), more=[desk])
    assert over.most_m == 0.0
    assert edge.measured_m == pytest.approx(0.05)


def box_points(x0, x1, y, z=TOP):
    return [(a, b, c) for a in (x0, x1) for b in (-y, y) for c in (0.0, z)]


def test_over_the_gap_between_two_tables_it_is_half_way():
    """No corner of it is over the gap."""
    long = asset("plank", (1.0, 0.1, 0.02))
    tables = thing(1, "table", 1.5, 2), thing(3, "table", 2.8, 2)
    over, _ = measured(*tables, thing(2, "plank", 1.85, 2, TOP), more=[long])
    assert over.measured_m == pytest.approx(0.15, abs=STEP_M / 2)


def test_what_may_catch_it_makes_the_least_and_what_surely_does_the_most():
    table, plank = thing(1, "table", 2, 2), thing(2, "plank", 2.3, 2, TOP)
    for below, measured_m in ((0.24, 0.0), (0.26, 0.1)):
        stove = asset("stove", (0.6, 0.6, TOP - below))
        over, edge = measured(table, plank, thing(3, "stove", 2.8, 2), more=[stove])
        assert over == (pytest.approx(measured_m), 0.0, pytest.approx(0.1))
        assert edge.least_m == 0.0 < edge.most_m
    # So with what begins a little above it: it may be in its way.
    hung = thing(3, "table", 3, 2, TOP + 0.015)
    assert measured(table, plank, hung)[0] == (pytest.approx(0.1), 0.0, pytest.approx(0.1))


@given(
    st.floats(0.0, 0.25),
    st.floats(0.0, 0.25),
    st.floats(0, 2 * math.pi),
    st.floats(-math.pi, math.pi),
)
def test_pushing_a_thing_outwards_makes_it_reach_further(first, more, way, yaw):
    """Off a round table, whatever way: never less, and by no more than it was pushed."""
    points = [(0.5 * math.cos(a), 0.5 * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 65)[:-1]]
    outline = [(x, y, z) for x, y in points for z in (0.0, TOP)]
    inner = [(0.98 * x, 0.98 * y) for x, y in points]
    top = {"name": "top", "part": "body", "z_m": TOP, "polygon_m": inner}
    table = asset("table", (1, 1, TOP), supports=[top], outlines_m={"body": [outline]})
    reached = []
    for far in (0.2 + first, 0.2 + first + more):
        spot = 2 + far * math.cos(way), 2 + far * math.sin(way)
        over, edge = measured(
            thing(1, "table", 2, 2), thing(2, "plank", *spot, TOP, yaw=yaw), more=[table]
        )
        assert edge.measured_m == 0.0 or over.measured_m == 0.0
        reached.append(over.measured_m if facts_on(table, spot, yaw) else None)
    if None not in reached:
        assert reached[0] - GRID <= reached[1] <= reached[0] + more + GRID


def facts_on(table, spot, yaw):
    f = facts(thing(1, "table", 2, 2), thing(2, "plank", *spot, TOP, yaw=yaw), more=[PLANK, table])
    return f.holds(2, "ON") == (1,)


SPOT = st.tuples(st.floats(-0.55, 0.55), st.floats(-0.55, 0.55))


@settings(max_examples=60, deadline=None)
@given(SPOT, st.floats(-math.pi, math.pi), st.floats(-0.3, 0.3), st.sampled_from([0.0, 0.25, 0.5]))
def test_brute_force_finds_the_same(spot, yaw, shift, gap):
    """A table, and another that stands beside it, shifted and further off; a turned plank."""
    tables = thing(1, "table", 1.5, 2), thing(3, "table", 2.5 + gap, 2 + shift)
    plank = thing(2, "plank", 1.5 + spot[0], 2 + spot[1], TOP, yaw=yaw)
    over, edge = measured(*tables, plank)
    f = facts(*tables, plank, more=[PLANK])
    if not any(r.holds and r.sure for r in f.related(2, "ON")):
        return
    room = shapely.box(0, 0, 4, 4)
    firm = shapely.union_all([f.bodies[k].footprint for k in (1, 3)])
    outline = f.bodies[2].footprint
    along, fine = np.linspace(0, outline.length, 4000, retstep=True)
    points = shapely.line_interpolate_point(outline.exterior, along)
    far = shapely.distance(points, firm).max()
    assert far - STEP_M / 2 - GRID <= over.measured_m <= far + fine
    grid = shapely.points(*np.meshgrid(np.linspace(0, 4, 401), np.linspace(0, 4, 401)))
    drop = grid[shapely.intersects(room, grid) & ~shapely.intersects(firm, grid)]
    nearest = shapely.distance(drop, outline).min()
    # Its grid is 1 cm wide.
    assert nearest - 0.0142 <= edge.measured_m <= nearest + GRID


@given(st.floats(0.0, 0.3), st.floats(0.02, 0.5))
def test_the_least_and_the_most_span_what_is_measured(gap, high):
    """Whatever is undecided: a gap that may be closed, a stove that may be too low."""
    stove = asset("stove", (0.6, 0.6, TOP - 0.25 + (high - 0.25) / 5))
    table, below = thing(1, "table", 2, 2), thing(3, "stove", 2.8 + gap, 2)
    for span in measured(table, below, thing(2, "plank", 2.3, 2, TOP), more=[stove]):
        assert span.least_m <= span.measured_m <= span.most_m


def test_what_may_or_may_not_be_on_the_table_may_or_may_not_be_at_its_edge():
    on, off = (measured(thing(1, "table", 2, 2), thing(2, "box", x, 2, TOP)) for x in (2.49, 2.51))
    assert on[0] == (pytest.approx(0.14), 0.0, pytest.approx(0.14))
    assert on[1] == (0.0, 0.0, math.inf)
    assert off[0] == (0.0, 0.0, pytest.approx(0.16))
    assert off[1] == (math.inf, 0.0, math.inf)


def test_a_tilted_thing_reaches_as_far_as_its_outline():
    leaning = quat_from_axis_angle((0, 1, 0), 0.02)
    pose = Pose(position_m=(2.3, 2, TOP + 0.006), quat_xyzw=leaning)
    plank = thing(2, "plank", 2.3, 2).model_copy(update={"pose": pose})
    over, _ = measured(thing(1, "table", 2, 2), plank)
    assert over.measured_m == pytest.approx(0.1 + 0.02 * 0.02, abs=2e-4)
