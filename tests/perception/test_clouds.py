"""Pixels to points: where they are, which look up, which hang in the air."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.cameras.pinhole import intrinsics, matrix4, project
from sdgen.geometry import look_at
from sdgen.perception.clouds import Cloud, View, clouds, unproject
from sdgen.scene import Camera

WIDTH, HEIGHT = 64, 48
THING = 7


def camera(eye, target, width=WIDTH, height=HEIGHT):
    return Camera(
        index=0,
        kind="room",
        room_id=1,
        width=width,
        height=height,
        K=intrinsics(width, height),
        world_from_camera=matrix4(look_at(eye, target)),
        near_m=0.05,
        far_m=20.0,
    )


def one(view: View) -> Cloud:
    return clouds([view], [THING])[THING]


def plane_depth(cam: Camera, height_m: float) -> np.ndarray:
    """Planar depth (H, W), mm, of a level plane below a camera."""
    rows, columns = np.mgrid[0 : cam.height, 0 : cam.width]
    k, pose = np.asarray(cam.K), np.asarray(cam.world_from_camera)
    rays = np.stack(
        [(columns - k[0, 2]) / k[0, 0], (rows - k[1, 2]) / k[1, 1], np.ones(rows.shape)], axis=-1
    )
    down = (rays @ pose[:3, :3].T)[..., 2]
    with np.errstate(divide="ignore"):
        depth = (height_m - pose[2, 3]) / down
    return np.where(depth > 0, np.rint(1000 * depth), 0).clip(0, 65535).astype(np.uint16)


coordinate = st.floats(-5, 5)


@given(
    eye=st.tuples(coordinate, coordinate, st.floats(0.5, 2.5)),
    ahead=st.tuples(st.floats(0.5, 4), st.floats(-3, 3), st.floats(-0.4, 0.4)),
    pixels=st.lists(
        st.tuples(st.integers(0, HEIGHT - 1), st.integers(0, WIDTH - 1), st.floats(0.1, 60)),
        min_size=1,
        max_size=5,
    ),
)
def test_what_is_unprojected_is_seen_where_it_was(eye, ahead, pixels):
    cam = camera(eye, tuple(a + b for a, b in zip(eye, ahead, strict=True)))
    rows, columns, depth = np.array(pixels).T
    seen, again = project(cam, unproject(cam, rows, columns, depth))
    assert seen == pytest.approx(np.stack([columns, rows], axis=1), abs=1e-6)
    assert again == pytest.approx(depth)


def test_a_level_plane_looks_up_and_its_points_are_at_its_height():
    cam = camera((0, 0, 1.5), (1.2, 0, 0.7))
    cloud = one(View(cam, np.full((HEIGHT, WIDTH), THING, np.uint16), plane_depth(cam, 0.7)))
    assert cloud.points[:, 2] == pytest.approx(0.7, abs=0.002)
    assert cloud.upward.mean() > 0.7  # all but the rim of the picture, where nothing tells
    assert cloud.pixels == HEIGHT * WIDTH


def test_a_wall_does_not_look_up():
    cam = camera((0, 0, 1.5), (2, 0, 1.5))
    depth = np.full((HEIGHT, WIDTH), 2000, np.uint16)
    cloud = one(View(cam, np.full((HEIGHT, WIDTH), THING, np.uint16), depth))
    assert not cloud.upward.any()
    assert cloud.points[:, 0] == pytest.approx(2.0, abs=1e-6)


def test_a_ceiling_looks_down_not_up():
    cam = camera((0, 0, 1.0), (1.0, 0, 2.4))
    depth = plane_depth(cam, 2.4)
    cloud = one(View(cam, np.full((HEIGHT, WIDTH), THING, np.uint16), depth))
    assert len(cloud.points) > 100
    assert not cloud.upward.any()


def test_points_between_two_surfaces_are_left_out():
    cam = camera((0, 0, 1.5), (2, 0, 1.5))
    instance = np.zeros((HEIGHT, WIDTH), np.uint16)
    instance[10:30, 10:30] = THING
    depth = np.full((HEIGHT, WIDTH), 4000, np.uint16)
    depth[10:30, 10:30] = 2000
    depth[20, 29] = 3000  # a filtered camera's mixture of the thing and the wall behind
    cloud = one(View(cam, instance, depth))
    assert len(cloud.points) == 20 * 20 - 1
    assert cloud.points[:, 0].max() == pytest.approx(2.0, abs=1e-6)


def test_pixels_without_depth_are_no_points():
    cam = camera((0, 0, 1.5), (2, 0, 1.5))
    instance = np.full((HEIGHT, WIDTH), THING, np.uint16)
    assert clouds([View(cam, instance, np.zeros_like(instance))], [THING]) == {}


def test_an_end_is_seen_unless_something_nearer_hides_it():
    cam = camera((0, 0, 1.5), (2, 0, 1.5))
    instance = np.zeros((HEIGHT, WIDTH), np.uint16)
    instance[10:20, 10:40] = THING
    instance[20:30, 10:20] = 9
    depth = np.full((HEIGHT, WIDTH), 4000, np.uint16)
    depth[10:20, 10:40] = 2000
    depth[20:30, 10:20] = 1000
    cloud = one(View(cam, instance, depth))
    # Of thirty columns ten go on behind something.
    assert cloud.ends.sum() == 20


def test_views_and_parts_come_together():
    cam = camera((0, 0, 1.5), (2, 0, 1.5))
    instance = np.full((HEIGHT, WIDTH), THING, np.uint16)
    depth = np.full((HEIGHT, WIDTH), 2000, np.uint16)
    part = np.ones((HEIGHT, WIDTH), np.uint8)
    part[:5] = 2
    half = instance.copy()
    half[: HEIGHT // 2] = 0
    cloud = clouds([View(cam, instance, depth, part), View(cam, half, depth, part)], [THING])[THING]
    assert len(cloud.points) == HEIGHT * WIDTH + HEIGHT * WIDTH // 2
    assert cloud.pixels == HEIGHT * WIDTH  # the most in one view
    assert cloud.part_pixels == {1: (HEIGHT - 5) * WIDTH, 2: 5 * WIDTH}
