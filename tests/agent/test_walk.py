"""An agent walks on free floor, never through what stands there, and finds its way."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.agent.walk import Floor
from sdgen.agent.ways import Ways, length_m
from sdgen.cameras.lens import Gaze
from sdgen.seeding import lane
from shapely.geometry import box
from shapely.ops import unary_union

from tests import toy


@pytest.fixture(scope="module")
def floor() -> Floor:
    return Floor(toy.bundle(1, toy.small()).scene)


def test_a_step_ends_where_it_leads_or_before_what_is_in_the_way(floor: Floor) -> None:
    place = floor.random(lane(0, 0, "test"))
    assert place is not None
    for k in range(500):
        place = Gaze(place.x_m, place.y_m, place.yaw_rad + 0.7 * math.sin(k))
        after, stopped = floor.step(place, 0.25)
        assert floor.holds(after.point)
        gone = math.dist(after.point, place.point)
        assert gone <= 0.25 + 1e-9
        assert stopped or gone == pytest.approx(0.25)
        place = after


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 10_000), st.floats(0.01, 3.0))
def test_no_step_leaves_the_free_space(seed: int, distance: float) -> None:
    floor = FLOOR
    place = floor.random(lane(seed, 0, "test"))
    assert place is not None
    after, _ = floor.step(place, distance)
    assert floor.holds(after.point)


def test_a_way_stays_inside_and_is_no_shorter_than_the_straight_line(floor: Floor) -> None:
    rng = lane(3, 0, "test")
    for _ in range(20):
        start, goal = floor.random(rng), floor.random(rng)
        assert start is not None
        assert goal is not None
        way = floor.route(start.point, goal.point)
        assert way is not None
        assert (way[0], way[-1]) == (start.point, goal.point)
        assert length_m(way) >= math.dist(start.point, goal.point) - 1e-9
        assert all(floor.holds(corner) for corner in way)


FLOOR = Floor(toy.bundle(1, toy.small()).scene)


def test_a_way_around_a_block_is_the_shortest_there_is() -> None:
    shape = box(0, 0, 4, 4).difference(box(1, 1, 3, 3))
    way = Ways(shape).route((0.5, 2.0), (3.5, 2.0))
    assert way is not None
    assert length_m(way) == pytest.approx(2 * math.hypot(0.5, 1.0) + 2.0, abs=0.01)
    assert len(way) == 4
    apart = unary_union([box(0, 0, 1, 1), box(2, 0, 3, 1)])
    assert Ways(apart).route((0.5, 0.5), (2.5, 0.5)) is None
    assert Ways(box(0, 0, 1, 1)).route((0.2, 0.2), (0.2, 0.2)) == ((0.2, 0.2),)
