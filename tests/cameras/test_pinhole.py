import math

import numpy as np
import pytest
from sdgen.cameras.pinhole import intrinsics, project

from tests.fakes import camera_at


def test_field_of_view_is_between_the_outer_edges_of_the_outer_pixels() -> None:
    k = np.asarray(intrinsics(640, 480, math.radians(70)))
    left = (-0.5 - k[0, 2]) / k[0, 0]
    right = (639.5 - k[0, 2]) / k[0, 0]
    assert math.degrees(math.atan(right) - math.atan(left)) == pytest.approx(70)


def test_the_point_looked_at_is_in_the_middle_and_up_is_up() -> None:
    camera = camera_at((1, 2, 1.5), (4, 2, 0.5))
    pixels, depth = project(camera, np.array([[4, 2, 0.5], [4, 2, 0.8], [4, 1.5, 0.5]]))
    assert pixels[0] == pytest.approx([319.5, 239.5])
    assert depth[0] == pytest.approx(math.hypot(3, 1))
    assert pixels[1, 1] < pixels[0, 1]  # higher in the world is higher in the picture
    assert pixels[2, 0] > pixels[0, 0]  # looking along +x, −y is to the right
