"""Poses proposed for furniture: inside the room, backs to walls, in line with what they go by."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.geometry import Vec2, quat_from_yaw
from sdgen.home import anchors
from sdgen.home.anchors import BACK_GAP_M, HUNG_GAP_M, SIDE_GAP_M, TUCKED_M, PlacedAt, sides_of
from sdgen.library.records import AssetInfo
from sdgen.library.sweep import Reach
from sdgen.scene import ObjectInstance, Pose
from shapely.geometry import Polygon

#: Counter-clockwise: a plain room, and one whose outline turns into the room at (2.5, 2.5).
BOX = ((0.0, 0.0), (4.0, 0.0), (4.0, 3.5), (0.0, 3.5))
ANGLE = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.5), (2.5, 2.5), (2.5, 5.0), (0.0, 5.0))
ROOMS = st.sampled_from((BOX, ANGLE))
#: Depth and width of furniture.
SIZES = st.tuples(st.floats(0.2, 0.9), st.floats(0.2, 2.0))
SEEDS = st.integers(0, 2**32)
YAWS = st.sampled_from((0.0, math.pi / 2, math.pi, -math.pi / 2, 0.3))


def rng(seed: int) -> np.random.Generator:
    return np.random.default_rng(seed)


def footprint(pose: PlacedAt, size: Vec2) -> Polygon:
    """Floor that a piece of this (depth, width) takes."""
    x, y, _, yaw = pose
    depth, width = size
    c, s = math.cos(yaw), math.sin(yaw)
    corners = [(a * depth / 2, b * width / 2) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return Polygon([(x + c * a - s * b, y + s * a + c * b) for a, b in corners])


def point(pose: PlacedAt, ahead_m: float, left_m: float = 0.0) -> Vec2:
    """A point given in a piece's own frame."""
    x, y, _, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return (x + c * ahead_m - s * left_m, y + s * ahead_m + c * left_m)


def stands(pose: PlacedAt, size: Vec2) -> tuple[ObjectInstance, AssetInfo]:
    """A piece of this (depth, width) that stands there."""
    info = AssetInfo(
        id="piece_01",
        category="piece",
        licence="CC0-1.0",
        source="",
        extents_m=(*size, 0.7),
        mass_kg=1.0,
        parts=(),
        variants={"default": ()},
    )
    x, y, z, yaw = pose
    item = ObjectInstance(
        id=1,
        category="piece",
        asset="piece_01",
        pose=Pose(position_m=(x, y, z), quat_xyzw=quat_from_yaw(yaw)),
        room_id=1,
        fixed=True,
    )
    return item, info


def gap_behind(pose: PlacedAt, size: Vec2, room: tuple[Vec2, ...]) -> float:
    """Distance from the middle of a back to the wall whose inward side it turns its face to."""
    back = point(pose, -size[0] / 2)
    gaps = []
    for side in sides_of(room):
        along, away = side.measure(back)
        facing = math.cos(pose[3]) * side.inward[0] + math.sin(pose[3]) * side.inward[1]
        if facing > 0.999 and 0 <= along <= side.length_m and away > -0.01:
            gaps.append(away)
    return min(gaps)


@given(ROOMS, SIZES, SEEDS, st.sampled_from((0.0, 1.4)))
def test_against_walls_is_in_the_room_with_the_back_to_a_wall(room, size, seed, z):
    poses = anchors.against_walls(sides_of(room), size, z, rng(seed))
    fitting = [s for s in sides_of(room) if s.length_m >= size[1] + 2 * SIDE_GAP_M]
    assert len(poses) == len(fitting) * (2 + anchors.DRAWS_A_WALL)
    gap = HUNG_GAP_M if z > 0 else BACK_GAP_M
    for pose in poses:
        assert Polygon(room).covers(footprint(pose, size))
        assert gap_behind(pose, size, room) == pytest.approx(gap)
        assert pose[2] == z


@pytest.mark.parametrize(("snap", "first"), [(1.0, True), (0.0, False)])
def test_walls_are_filled_from_their_ends_or_anywhere(snap, first):
    """With a snap of 1 a wall's ends are proposed before the spots between them."""
    (side, *_) = sides = sides_of(BOX)[:1]
    size = (0.5, 1.0)
    poses = anchors.against_walls(sides, size, 0.0, rng(3), snap)
    along = [side.measure(pose[:2])[0] for pose in poses]
    ends = {0.5 + SIDE_GAP_M, side.length_m - 0.5 - SIDE_GAP_M}
    assert ({round(t, 9) for t in along[:2]} == {round(t, 9) for t in ends}) is first


def test_no_wall_is_long_enough_for_what_is_wider():
    assert anchors.against_walls(sides_of(BOX), (0.5, 4.0), 0.0, rng(1)) == []


@given(ROOMS, st.tuples(st.floats(0.2, 0.9), st.floats(0.2, 0.9)), SEEDS)
def test_in_corners_stands_in_every_corner_that_points_outwards_at_either_wall(room, size, seed):
    poses = anchors.in_corners(sides_of(room), size, rng(seed))
    assert len(poses) == 2 * {BOX: 4, ANGLE: 5}[room]
    corners = []
    for pose in poses:
        shape = footprint(pose, size)
        assert Polygon(room).covers(shape)
        assert gap_behind(pose, size, room) < 0.1
        (near,) = [c for c in room if shape.distance(Polygon([c] * 3)) < 0.1]
        corners.append((near, round(pose[3], 6)))
    assert len(set(corners)) == len(poses)
    assert (2.5, 2.5) not in {corner for corner, _ in corners}


@given(SIZES, SIZES, YAWS, SEEDS)
def test_beside_is_left_and_right_with_backs_in_line(target_size, size, yaw, seed):
    at = (2.0, 1.0, 0.0, yaw)
    poses = anchors.beside(*stands(at, target_size), size, rng(seed))
    sides = []
    for pose in poses:
        assert pose[3] == pytest.approx(yaw)
        gap = footprint(at, target_size).distance(footprint(pose, size))
        assert gap == pytest.approx(SIDE_GAP_M, abs=1e-6)
        back, own = point(at, -target_size[0] / 2), point(pose, -size[0] / 2)
        ahead = (own[0] - back[0]) * math.cos(yaw) + (own[1] - back[1]) * math.sin(yaw)
        assert ahead == pytest.approx(0.0, abs=1e-6)
        sides.append(-(own[0] - back[0]) * math.sin(yaw) + (own[1] - back[1]) * math.cos(yaw) > 0)
    assert sorted(sides) == [False, True]


@given(SIZES, st.tuples(st.floats(0.35, 0.6), st.floats(0.35, 0.6)), YAWS, SEEDS)
def test_around_faces_the_table_and_is_tucked_in_less_and_less(table_size, size, yaw, seed):
    at = (2.0, 1.0, 0.0, yaw)
    poses = anchors.around(*stands(at, table_size), size, [], rng(seed))
    assert len(poses) == (6 if table_size[1] / 2 > 0.55 else 4) * len(TUCKED_M)
    for k, pose in enumerate(poses):
        # From the middle of the seat's front edge the table reaches so far back.
        edge = point(pose, size[0] / 2 - TUCKED_M[k % len(TUCKED_M)])
        table = footprint(at, table_size)
        assert table.exterior.distance(Polygon([edge] * 3)) == pytest.approx(0.0, abs=1e-6)
        ahead = point(pose, size[0] / 2 + 1e-3)
        assert math.dist(ahead, at[:2]) < math.dist(pose[:2], at[:2]) + size[0]
    # The long sides first, the table's ends last.
    headings = [pose[3] - yaw for pose in poses[:: len(TUCKED_M)]]
    assert {round(abs(math.cos(h)), 6) for h in headings[:-2]} == {1.0}
    assert {round(abs(math.sin(h)), 6) for h in headings[-2:]} == {1.0}


@given(YAWS, SEEDS)
def test_the_second_seat_is_across_from_the_first(yaw, seed):
    table, info = stands((2.0, 1.0, 0.0, yaw), (0.9, 1.6))
    size = (0.5, 0.45)
    first = anchors.around(table, info, size, [], rng(seed))[0]
    second = anchors.around(table, info, size, [first[:2]], rng(seed + 1))[0]
    assert math.cos(first[3] - second[3]) == pytest.approx(-1.0)
    assert math.dist(first[:2], second[:2]) < 1.0


def test_centred_comes_first_in_the_middle_of_each_side():
    sides = sides_of(BOX)
    poses = anchors.against_walls(sides, (0.5, 1.0), 0.0, rng(2), centred=True)
    each = 3 + anchors.DRAWS_A_WALL
    assert len(poses) == len(sides) * each
    for pose in poses[::each]:
        (offs,) = [
            abs(s.measure(pose[:2])[0] - s.length_m / 2)
            for s in sides
            if math.cos(pose[3] - s.yaw) > 0.9
        ]
        assert offs == pytest.approx(0.0)


@given(st.floats(0.4, 3.0), st.tuples(st.floats(0.2, 0.6), st.floats(0.4, 2.0)), SEEDS)
def test_opposite_is_against_the_wall_a_piece_faces(y, size, seed):
    """A sofa with its back to x = 0 looks at the wall at x = 4."""
    sofa, _ = stands((0.5, y, 0.0, 0.0), (0.9, 1.6))
    poses = anchors.opposite(sofa, sides_of(BOX), size, rng(seed))
    assert len(poses) == len(anchors.OPPOSITE_BESIDE_M)
    low = size[1] / 2 + SIDE_GAP_M
    assert poses[0][1] == pytest.approx(min(max(y, low), 3.5 - low))
    for pose in poses:
        assert Polygon(BOX).covers(footprint(pose, size))
        assert math.cos(pose[3]) == pytest.approx(-1.0)
        assert gap_behind(pose, size, BOX) == pytest.approx(BACK_GAP_M)


@given(ROOMS, SIZES)
def test_what_lies_flat_lies_wholly_on_the_free_floor_along_it_first(room, size):
    free = Polygon(room)
    poses = anchors.on_free_floor(free, size)
    assert poses
    assert all(free.buffer(1e-9).covers(footprint(pose, size)) for pose in poses)
    # The box is longer in x, and a piece is wider (y of its own) than deep.
    assert room is ANGLE or poses[0][3] == math.pi / 2
    middle = free.centroid.coords[0]
    away = [math.dist(pose[:2], middle) for pose in poses if pose[3] == poses[0][3]]
    assert away == pytest.approx(sorted(away))


def test_nothing_flat_lies_where_the_floor_is_too_narrow():
    strip = Polygon(((0.0, 0.0), (4.0, 0.0), (4.0, 0.7), (0.0, 0.7)))
    assert anchors.on_free_floor(strip, (0.8, 2.5)) == []
    assert anchors.on_free_floor(strip, (0.6, 2.5))


def test_nothing_is_opposite_when_the_wall_is_too_near():
    sofa, _ = stands((2.5, 1.0, 0.0, 0.0), (0.9, 1.6))
    assert anchors.opposite(sofa, sides_of(BOX), (0.4, 1.0), rng(1)) == []


@given(SIZES, st.tuples(st.floats(0.01, 0.4), st.floats(0.2, 1.0)), SEEDS, st.floats(1.2, 1.8))
def test_above_hangs_on_the_wall_that_the_piece_below_stands_against(target_size, size, seed, z):
    for at in anchors.against_walls(sides_of(BOX), target_size, 0.0, rng(seed)):
        (pose,) = anchors.above(*stands(at, target_size), size, z, sides_of(BOX))
        assert gap_behind(pose, size, BOX) == pytest.approx(HUNG_GAP_M, abs=1e-6)
        assert pose[2] == z
        assert pose[3] == pytest.approx(at[3])
        middle = point(at, -target_size[0] / 2), point(pose, -size[0] / 2)
        assert math.dist(*middle) == pytest.approx(BACK_GAP_M - HUNG_GAP_M, abs=1e-6)


def test_what_hangs_above_a_piece_off_the_wall_hangs_on_the_wall_itself():
    """As over the legs of a U, behind which worktops reach."""
    at, size = (0.39, 1.5, 0.0, 0.0), (0.6, 0.8)
    target = stands(at, size)
    assert anchors.gap_behind(*target, sides_of(BOX)) == pytest.approx(0.09)
    (pose,) = anchors.above(*target, (0.35, 0.8), 1.45, sides_of(BOX))
    assert pose[0] == pytest.approx(HUNG_GAP_M + 0.35 / 2)


def test_the_gap_at_the_right_of_a_corner_unit_is_to_the_wall_there():
    # Its back to x = 0, its right, where y falls, to y = 0.
    target = stands((0.49, 0.52, 0.0, 0.0), (0.9, 0.9))
    assert anchors.gap_behind(*target, sides_of(BOX)) == pytest.approx(0.04)
    assert anchors.gap_behind(*target, sides_of(BOX), right=True) == pytest.approx(0.07)


@given(SIZES, SIZES, YAWS, st.floats(-0.3, 0.6))
def test_before_faces_the_piece_a_gap_away(target_size, size, yaw, gap_m):
    at = (2.0, 1.0, 0.0, yaw)
    poses = anchors.before(*stands(at, target_size), size, gap_m)
    front = point(poses[0], size[0] / 2)
    assert front == pytest.approx(point(at, target_size[0] / 2 + gap_m), abs=1e-6)
    assert all(math.cos(p[3] - yaw) == pytest.approx(-1.0) for p in poses)


def test_what_opens_beyond_its_box_gets_room_behind_and_at_its_sides():
    """Its left is where the wall begins: it looks into the room, the wall runs to its right."""
    reach = Reach(back_m=0.1, left_m=0.05)
    size = (0.5, 1.0)
    for side in sides_of(BOX):
        poses = anchors.against_walls((side,), size, 0.0, rng(1), snap=1.0, reach=reach)
        assert [side.measure(p[:2])[1] for p in poses] == pytest.approx([0.25 + 0.1] * len(poses))
        along = sorted(side.measure(p[:2])[0] for p in poses)
        assert along[0] == pytest.approx(0.5 + 0.05)
        assert along[-1] == pytest.approx(side.length_m - 0.5 - SIDE_GAP_M)
        x, y = poses[0][:2]
        left = (x - math.sin(side.yaw), y + math.cos(side.yaw))
        assert side.measure(left)[0] < side.measure((x, y))[0]
    for pose in anchors.in_corners(sides_of(BOX), size, rng(1), reach):
        assert gap_behind(pose, size, BOX) >= 0.1
    sofa, _ = stands((0.5, 1.0, 0.0, 0.0), (0.9, 1.6))
    for pose in anchors.opposite(sofa, sides_of(BOX), size, rng(1), reach):
        assert gap_behind(pose, size, BOX) == pytest.approx(0.1)
