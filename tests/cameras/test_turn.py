"""Turns go all the way round, level and in place; their post is where most is seen."""

import math

import numpy as np
import pytest
from sdgen.cameras.pinhole import project
from sdgen.cameras.turn import (
    MOST_ROOMS,
    POLES_FROM,
    ROOM_TURN,
    Post,
    panorama_width,
    panoramas_of,
    poles_of,
    posts,
    rings,
    turn_cameras,
)
from sdgen.options import MAX_VIEWS
from sdgen.scene import Room
from shapely.geometry import box

POSTS = [Post(4, np.array([1.0, 2.0, 1.2]), 0.7), Post(9, np.array([-3.0, 0.5, 1.2]), -2.0)]


@pytest.fixture(scope="module")
def cameras():
    return turn_cameras(POSTS, (640, 480))


def test_six_views_of_70_degrees_go_round_and_have_two_digits(cameras):
    assert ROOM_TURN == 6
    assert MOST_ROOMS * ROOM_TURN <= MAX_VIEWS < POLES_FROM
    assert [camera.index for camera in cameras] == list(range(12))
    assert [camera.room_id for camera in cameras] == [4] * 6 + [9] * 6
    assert {camera.kind for camera in cameras} == {"turn"}
    assert [camera.turn.step for camera in cameras] == [*range(6), *range(6)]


def test_they_are_level_in_place_and_turn_left(cameras):
    for camera in cameras:
        pose = np.asarray(camera.world_from_camera)
        post = POSTS[camera.index // ROOM_TURN]
        assert pose[:3, 3] == pytest.approx(post.eye_m)
        assert pose[:3, 1] == pytest.approx([0, 0, -1])
        yaw = post.yaw_rad + camera.turn.step * math.pi / 3
        assert pose[:3, 2] == pytest.approx([math.cos(yaw), math.sin(yaw), 0], abs=1e-9)


def test_every_direction_along_the_horizon_is_in_one_view_and_edges_in_two(cameras):
    yaws = np.linspace(-math.pi, math.pi, 721)
    around = POSTS[0].eye_m + 3 * np.column_stack([np.cos(yaws), np.sin(yaws), 0 * yaws])
    shown = np.zeros(len(yaws), dtype=int)
    for camera in cameras[:6]:
        pixels, depth = project(camera, around)
        shown += (depth > 0) & (pixels[:, 0] >= -0.5) & (pixels[:, 0] <= 639.5)
    assert shown.min() == 1
    assert shown.max() == 2
    assert (shown == 2).mean() == pytest.approx(60 / 360, abs=0.01)


def test_panoramas_are_of_whole_turns(cameras):
    first, second = panoramas_of(cameras)
    assert [len(ring) for ring in rings(cameras)] == [6, 6]
    assert (first.room_id, second.room_id) == (4, 9)
    assert (first.views, second.views) == (tuple(range(6)), tuple(range(6, 12)))
    assert (first.width, first.height) == (2048, 1024)
    assert first.world_from_panorama == cameras[0].world_from_camera
    assert [panorama_width(width) for width in (96, 320, 1280, 4096)] == [308, 1024, 4096, 4096]


@pytest.mark.parametrize("size", [(640, 480), (320, 240), (64, 64), (96, 72), (480, 640)])
def test_poles_see_all_that_the_turn_does_not(size):
    ring = turn_cameras(POSTS[:1], size)
    up, down = poles_of(panoramas_of(ring)[0], ring[0])
    assert {up.index, down.index} == {POLES_FROM, POLES_FROM + 1}
    rng = np.random.default_rng(2)
    around = rng.normal(size=(2000, 3))
    shown = np.zeros(len(around), dtype=bool)
    for camera in (*ring, up, down):
        pixels, depth = project(camera, POSTS[0].eye_m + around)
        inside = (
            np.abs(pixels - np.asarray(camera.K)[:2, 2])
            <= (
                camera.width / 2,
                camera.height / 2,
            )
        ).all(axis=1)
        shown |= (depth > 0) & inside
    assert shown.all()
    for camera, axis in ((up, 1), (down, -1)):
        pose = np.asarray(camera.world_from_camera)
        assert pose[:3, 2] == pytest.approx([0, 0, axis], abs=1e-9)
        assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0)


class Nothing:
    """Rays that meet nothing, or only the wall at x = 0."""

    def __init__(self, wall=False):
        self.wall = wall

    def __call__(self, origins, targets):
        n = len(origins)
        self.object_id = np.zeros(n, dtype=int)
        self.part = np.zeros(n, dtype=int)
        self.distance_m = np.full(n, np.inf)
        if self.wall:
            meets = origins[:, 0] * targets[:, 0] < 0
            share = np.where(meets, origins[:, 0] / (origins[:, 0] - targets[:, 0] + 1e-12), 1.0)
            length = np.linalg.norm(targets - origins, axis=1)
            self.distance_m = np.where(meets, share * length, np.inf)
            self.object_id = meets.astype(int)
        return self


ROOM = Room(
    id=4,
    name="room",
    type="kitchen",
    polygon_m=((-3.0, -2.0), (3.0, -2.0), (3.0, 2.0), (-3.0, 2.0)),
    height_m=2.5,
)


def found(free, points, cast, rooms=(ROOM,)):
    weight = np.full(len(points), 1 / len(points))
    return posts(rooms, free, points, weight, cast, 1.2, np.random.default_rng(3))


def test_a_post_is_where_most_is_seen():
    """All that matters lies on one side of a wall: so does the first choice."""
    points = np.array([[2.0, y, 0.9] for y in (-1.5, -0.5, 0.5, 1.5)])
    (ranked,) = found(box(-2.5, -1.5, 2.5, 1.5), points, Nothing(wall=True))
    assert ranked[0].eye_m[0] > 0
    assert ranked[0].eye_m[2] == 1.2
    assert all(post.room_id == 4 and abs(post.eye_m[0]) > 0.25 for post in ranked)
    assert len({post.yaw_rad for post in ranked}) == 1


def test_rooms_without_a_place_have_no_turn():
    points = np.array([[0.0, 0.0, 0.9]])
    assert found(box(10, 10, 12, 12), points, Nothing()) == []
    # All the free floor is closer to the wall than a robot may stand.
    assert found(box(-0.2, -1.5, 0.2, 1.5), points, Nothing(wall=True)) == []


def test_of_many_rooms_the_largest_have_turns():
    def shifted(k):
        outline = tuple((x + 10 * k, y * (1 + k)) for x, y in ROOM.polygon_m)
        return ROOM.model_copy(update={"id": 100 - k, "polygon_m": outline})

    rooms = [shifted(k) for k in range(20)]
    free = box(-3, -2, 200, 2)
    turned = [ranked[0].room_id for ranked in found(free, np.zeros((1, 3)), Nothing(), rooms)]
    assert turned == [room.id for room in rooms[20 - MOST_ROOMS :]]
