"""Close-ups show the thing, all of it, as a part of the view's picture."""

import numpy as np
import pytest
from sdgen.cameras.closeup import close_up, in_picture
from sdgen.cameras.pinhole import intrinsics, project
from sdgen.geometry import box_corners, look_at

EYE = (0.0, 0.0, 1.2)


def box(middle, size):
    return np.asarray(box_corners(tuple(np.subtract(middle, size)), tuple(np.add(middle, size))))


@pytest.mark.parametrize("aim", [(2.0, 0.0, 0.5), (2.0, 0.9, 0.8), (1.8, -0.3, 1.1)])
@pytest.mark.parametrize("size", [0.02, 0.1, 0.3])
def test_all_of_the_thing_is_in_it_and_enlarged(aim, size):
    pose = look_at(EYE, (2.0, 0.2, 0.8))
    points = box(aim, size)
    camera = close_up(pose, points, 1, (320, 240))
    pixels, _ = project(camera, points)
    assert (pixels >= -0.5).all()
    assert (pixels <= (319.5, 239.5)).all()
    assert camera.K[0][0] >= intrinsics(320, 240)[0][0] - 1e-9
    assert camera.K[0][0] == pytest.approx(camera.K[1][1])


def test_the_same_ray_meets_the_same_point():
    pose = look_at(EYE, (2.0, 0.0, 0.8))
    points = box((2.0, 0.3, 0.8), 0.1)
    near = close_up(pose, points, 1, (320, 240))
    # Of a thing as large as the picture it is the picture.
    whole = close_up(pose, box((2.0, 0.0, 0.8), 1.0), 1, (640, 480))
    assert np.allclose(whole.K, intrinsics(640, 480))
    (first, second), _ = project(near, points[:2])
    (one, other), _ = project(whole, points[:2])
    zoom = near.K[0][0] / whole.K[0][0]
    assert np.allclose(second - first, (other - one) * zoom)


def test_boxes_beside_and_behind_are_left_out():
    camera = close_up(look_at(EYE, (2.0, 0.0, 1.2)), box((2.0, 0.0, 1.2), 0.1), 1, (320, 240))
    boxes = np.array(
        [
            [(1.9, -0.1, 1.1), (2.1, 0.1, 1.3)],  # in the middle
            [(1.9, 3.0, 1.1), (2.1, 3.2, 1.3)],  # beside
            [(-2.0, -0.1, 1.1), (-1.0, 0.1, 1.3)],  # behind
            [(-5.0, -5.0, -0.1), (5.0, 5.0, 0.0)],  # below, and on both sides of the eye
        ]
    )
    assert in_picture(camera, boxes).tolist() == [True, False, False, True]
