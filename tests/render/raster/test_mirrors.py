"""What is seen in mirrors."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.geometry import inverse, quat_from_yaw
from sdgen.library import Library
from sdgen.render import choose_renderer, open_renderer
from sdgen.render.raster.mirrors import Mirror, largest, looked_into

from tests.fakes import box_room, camera_at, thing

#: A pane of 0.8 x 0.6 m in the plane x = 1, facing -x.
PANE = np.array([(1.0, -0.4, 0.9), (1.0, -0.4, 1.5), (1.0, 0.4, 1.5), (1.0, 0.4, 0.9)])
MIRROR = Mirror(7, 2, PANE[[[0, 1, 2], [0, 2, 3]]])
metres = st.floats(-1.5, 0.9)


def pixel_of(camera, point) -> tuple[float, float]:
    own = inverse(np.asarray(camera.world_from_camera)) @ (*point, 1.0)
    u, v, w = np.asarray(camera.K) @ own[:3]
    return u / w, v / w


@given(metres, st.floats(-1, 1), st.floats(0.5, 2.0))
def test_a_thing_and_its_image_lie_on_one_pixel(x: float, y: float, z: float) -> None:
    camera = camera_at((-1.0, 0.3, 1.4), (1.0, 0.0, 1.2), (160, 120))
    seen = np.zeros((120, 160), dtype=bool)
    seen[40:70, 50:90] = True
    looked = looked_into(MIRROR, camera, seen)
    assert looked is not None
    image = (2.0 - x, y, z)
    own = inverse(np.asarray(camera.world_from_camera)) @ (*image, 1.0)
    if own[2] < 0.1:
        return
    u, v = pixel_of(camera, image)
    left, top = looked.at
    there = pixel_of(looked.camera, (x, y, z))
    assert there == pytest.approx((u - left, v - top), abs=1e-6)
    # What is before the mirror is kept, what is behind it is not.
    assert np.dot(looked.keep, (x, y, z, 1.0)) > 0
    assert np.dot(looked.keep, (*image, 1.0)) < 0


def test_nothing_is_seen_in_a_mirror_from_behind() -> None:
    camera = camera_at((-1.0, 0.0, 1.2), (1.0, 0.0, 1.2), (160, 120))
    assert looked_into(MIRROR, camera, np.ones((120, 160), dtype=bool)) is not None
    thick = np.concatenate([MIRROR.corners_m, MIRROR.corners_m[:, ::-1] + (0.02, 0.0, 0.0)])
    point, normal = Mirror(7, 2, thick).plane(np.array([-1.0, 0.0, 1.2]))
    assert point[0] == pytest.approx(1.0)
    assert normal == pytest.approx([-1.0, 0.0, 0.0])


def test_the_largest_are_looked_into() -> None:
    assert largest([5, 900, 300, 4000]) == [3, 1]
    assert largest([5]) == []


@pytest.mark.skipif(choose_renderer("auto").kind != "egl", reason="EGL does not start here")
def test_a_mirror_shows_what_is_behind_the_camera_and_masks_show_the_mirror(
    library: Library,
) -> None:
    hung = thing(70, "mirror_91", (1.98, 0.0, 1.0), quat_from_yaw(math.pi), fixed=True)
    behind = thing(71, "cube_01", (-0.3, 0.0, 1.2), fixed=True)
    lamp = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)
    view = camera_at((0.3, 0.1, 1.3), (1.9, 0.1, 1.3), (160, 120))
    pictures = []
    with open_renderer("egl") as renderer:
        for things in ([lamp, hung], [lamp, hung, behind]):
            renderer.load(library, box_room(things))
            pictures.append(renderer.draw(view))
            large = renderer.draw_colours(view, 2)
            assert large.shape == (240, 320, 3)
    bare, both = pictures
    assert np.array_equal(bare.instance, both.instance)
    mirror = both.instance == 70
    assert mirror.sum() > 1000
    # The cube is red.
    red = both.rgb.astype(int)[..., 0] - both.rgb.astype(int)[..., 1] > 40
    assert red[mirror].sum() > 30
    assert not red[~mirror].any()
    assert not (bare.rgb.astype(int)[..., 0] - bare.rgb.astype(int)[..., 1] > 40)[mirror].any()


@pytest.mark.skipif(choose_renderer("auto").kind != "egl", reason="EGL does not start here")
def test_mirrors_of_many_sizes_are_looked_into_one_after_the_other(library: Library) -> None:
    hung = thing(70, "mirror_91", (1.98, 0.0, 1.0), quat_from_yaw(math.pi), fixed=True)
    lamp = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)
    with open_renderer("egl") as renderer:
        renderer.load(library, box_room([lamp, hung]))
        pictures = [
            renderer.draw(camera_at((x, 0.1, 1.3), (1.9, 0.1, 1.3), (320, 240))).rgb
            for x in (1.5, 1.2, 0.8, 0.4, 0.0, -0.6, -1.5, 1.5)
        ]
    assert np.array_equal(pictures[0], pictures[-1])
