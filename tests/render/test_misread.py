"""Pixels that the EGL plugin reads as another thing's, on masks made by hand."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from sdgen.geometry import Vec3, quat_from_yaw
from sdgen.render.misread import read_again
from sdgen.render.part_bodies import NOBODY, Part
from sdgen.scene import Camera

from tests.fakes import camera_at

WALL, SHAKER, SHELF, LAMP = range(4)
WIDTH, HEIGHT = 8, 6


def part(node_id: int, middle: Vec3, size: Vec3, deep: bool = True) -> Part:
    half = np.array(size) / 2
    # Turned by a quarter, and so are its sides.
    box = np.array([-half[[1, 0, 2]], half[[1, 0, 2]]])
    return Part(node_id, 1, 0, list(middle), quat_from_yaw(np.pi / 2), box, deep)


#: A wall 3 m ahead, a shelf before its left half, a shaker between them, and a lamp at the eye's
#: height of which no depth is drawn.
PARTS = (
    part(7, (3.05, 0.0, 1.0), (0.1, 6.0, 6.0)),
    part(8, (2.9, 0.0, 1.0), (0.1, 1.0, 1.0)),
    part(9, (2.0, 1.6, 1.0), (0.4, 3.0, 6.0)),
    part(10, (1.0, 0.0, 1.0), (0.5, 4.0, 4.0), deep=False),
)
NODE_OF = np.array([7, 8, 9, 10, 0], dtype=np.uint16)


def eye() -> Camera:
    camera = camera_at((0, 0, 1), (1, 0, 1))
    k = ((4.0, 0.0, 3.5), (0.0, 4.0, 2.5), (0.0, 0.0, 1.0))
    return camera.model_copy(update={"K": k, "width": WIDTH, "height": HEIGHT})


def read(index: np.ndarray, depth_m: np.ndarray) -> np.ndarray:
    camera = eye()
    pose = np.asarray(camera.world_from_camera)
    return read_again(index, NODE_OF[index], depth_m, camera, pose, PARTS)


def all_wall() -> tuple[np.ndarray, np.ndarray]:
    return np.full((HEIGHT, WIDTH), WALL, dtype=np.int32), np.full((HEIGHT, WIDTH), 3.0)


@pytest.mark.parametrize("wrong", [SHAKER, SHELF, NOBODY])
@pytest.mark.parametrize("place", [(0, 0), (0, 7), (5, 0), (5, 7), (2, 5), (0, 4), (3, 7)])
def test_a_lone_pixel_of_what_is_not_there_is_read_again(
    place: tuple[int, int], wrong: int
) -> None:
    """In corners, at edges and within: neither the shaker nor the shelf is there at that depth."""
    index, depth_m = all_wall()
    index[place] = wrong
    assert (read(index, depth_m) == WALL).all()


def test_a_lone_pixel_of_what_is_there_stays() -> None:
    index, depth_m = all_wall()
    index[2, 3], depth_m[2, 3] = SHAKER, 2.86
    assert read(index, depth_m)[2, 3] == SHAKER
    index[2, 3], depth_m[2, 3] = NOBODY, eye().far_m
    assert read(index, depth_m)[2, 3] == NOBODY


def test_of_what_has_no_depth_the_ray_alone_tells() -> None:
    index, depth_m = all_wall()
    index[2, 3] = LAMP
    assert read(index, depth_m)[2, 3] == LAMP
    index[2, 3] = WALL
    index[0, 0] = LAMP
    turned = eye().model_copy(update={"K": ((0.5, 0.0, 3.5), (0.0, 0.5, 2.5), (0.0, 0.0, 1.0))})
    pose = np.asarray(turned.world_from_camera)
    again = read_again(index, NODE_OF[index], depth_m, turned, pose, PARTS)
    assert again[0, 0] == WALL


def test_two_pixels_together_are_no_slip() -> None:
    for other in itertools.product((0, 1), repeat=2):
        if any(other):
            index, depth_m = all_wall()
            index[2, 3] = index[2 + other[0], 3 + other[1]] = SHELF
            assert (read(index, depth_m) == index).all()


def test_at_an_edge_it_is_of_what_is_there() -> None:
    """Most of what is around it is the wall, but its depth is the shelf's."""
    index, depth_m = all_wall()
    index[:3, :3], depth_m[:3, :3] = SHELF, 1.8
    index[2, 2] = SHAKER
    assert read(index, depth_m)[2, 2] == SHELF


def test_nothing_is_written_into_what_is_given() -> None:
    index, depth_m = all_wall()
    index[2, 5] = SHELF
    given = index.copy()
    read(index, depth_m)
    assert (index == given).all()
