"""Free space keeps the robot's radius, has no holes, and knows which rooms are cut off."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.freespace import (
    POINT_TRIES,
    ROBOT_RADIUS_M,
    Grid,
    Pieces,
    free_shape,
    random_point,
    rounded_rings,
    unreachable_rooms,
    without_holes,
)
from sdgen.scene import Home, Opening, Room
from sdgen.seeding import lane
from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

ROOMS = (
    Room(id=1, name="a", type="kitchen", polygon_m=((0, 0), (4, 0), (4, 3), (0, 3)), height_m=2.6),
    Room(
        id=2, name="b", type="hall", polygon_m=((4.12, 0), (7, 0), (7, 3), (4.12, 3)), height_m=2.6
    ),
)
DOOR = Opening(
    object_id=3,
    kind="door",
    room_ids=(1, 2),
    center_m=(4.06, 1.5, 0),
    along="y",
    width_m=0.9,
    height_m=2.1,
)
HOME = Home(id="h", kind="base", rooms=ROOMS, structures=(), openings=(DOOR,))


def test_rooms_are_joined_through_the_doorway():
    assert unreachable_rooms(HOME, free_shape(HOME, [])) == []


def test_a_wardrobe_before_the_door_cuts_a_room_off():
    cut = unreachable_rooms(HOME, free_shape(HOME, [box(3.3, 0.5, 4.0, 2.5)]))
    assert [room.id for room in cut] == [2]


def test_the_robot_keeps_its_radius_from_walls_and_things():
    table = box(1.5, 1.0, 2.5, 2.0)
    free = free_shape(HOME, [table])
    assert free.distance(table) == pytest.approx(ROBOT_RADIUS_M, abs=0.03)
    assert not free.contains(Point(0.2, 1.5))
    assert free.contains(Point(0.3, 1.5))


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(st.floats(0.5, 3.2), st.floats(0.5, 2.2)), max_size=4))
def test_rings_cover_the_same_floor_without_holes(spots):
    free = free_shape(HOME, [box(x, y, x + 0.4, y + 0.4) for x, y in spots])
    pieces = without_holes(free)
    assert all(not p.interiors for p in pieces)
    assert sum(p.area for p in pieces) == pytest.approx(free.area, abs=1e-3)
    rings = [Polygon(r) for r in rounded_rings(free)]
    assert all(ring.is_valid for ring in rings)
    assert unary_union(rings).symmetric_difference(free).area < 0.05


def test_a_neck_of_less_than_a_millimetre_crosses_no_ring():
    """Rounded point by point, both sides of the neck meet."""
    neck = Polygon([(0, 0), (1, 0.4998), (2, 0), (2, 1), (1, 0.5002), (0, 1)])
    rings = [Polygon(r) for r in rounded_rings(neck)]
    assert all(ring.is_valid for ring in rings)
    assert unary_union(rings).area == pytest.approx(neck.area, abs=0.02)


def test_a_route_goes_round_things():
    table = box(1.5, 0.0, 2.5, 2.0)
    free = free_shape(HOME, [table])
    path = Grid(free).route((0.5, 0.5), (3.5, 0.5))
    assert path is not None
    assert path.distance(table) > 0.2
    assert path.length > 4.0


def test_random_points_lie_inside_and_spread():
    shape = unary_union([box(0, 0, 1, 1), box(3, 0, 4, 1)])
    rng = lane(0, 0, "points")
    points = np.array([random_point(shape, rng) for _ in range(200)])
    assert all(shape.contains(Point(p)) for p in points)
    assert 60 < (points[:, 0] < 2).sum() < 140


def test_pieces_are_drawn_by_area_and_points_evenly_as_numpy_draws_them():
    parts = [box(0, 0, 2, 1), box(3, 0, 4, 1)]
    pieces = Pieces(unary_union(parts))
    mine, its = lane(0, 0, "points"), lane(0, 0, "points")
    for _ in range(50):
        low_x, _, high_x, _ = parts[int(its.choice(2, p=[2 / 3, 1 / 3]))].bounds
        points = its.uniform((low_x, 0), (high_x, 1), (POINT_TRIES, 2))
        assert pieces.random_point(mine) == pytest.approx(tuple(points[0]))
    assert Pieces(Polygon()).random_point(mine) is None


def test_there_is_no_route_through_a_wall_of_things():
    free = free_shape(HOME, [box(1.5, -1.0, 2.5, 4.0)])
    assert Grid(free).route((0.5, 0.5), (3.5, 0.5)) is None


def test_a_route_over_free_floor_is_hardly_longer_than_the_straight_line():
    path = Grid(free_shape(HOME, [])).route((0.5, 0.5), (3.5, 2.5))
    assert path is not None
    assert path.length < 1.1 * np.hypot(3.0, 2.0)
