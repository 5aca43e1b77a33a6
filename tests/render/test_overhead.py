"""Lamps that hug a ceiling: seen from wherever one looks, at their depth, without a shadow."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.geometry import Vec3, apply
from sdgen.library import Library
from sdgen.render import choose_renderer, open_renderer
from sdgen.render.frames import render_frames
from sdgen.render.overhead import overhead
from sdgen.scene import Camera, Frame, Scene

from tests.fakes import box_room, camera_at, thing

EGL = choose_renderer("auto").kind == "egl"
#: A cube of 0.2 m under a ceiling at 2.5 m.
LAMP = 900
AT: Vec3 = (0.3, -0.2, 2.295)


def lit(*others, at: Vec3 = AT, asset: str = "cube_01") -> Scene:
    return box_room([thing(LAMP, asset, at, fixed=True), *others])


def frames(library: Library, scene: Scene, views: list[Camera]) -> list[Frame]:
    with open_renderer("egl") as renderer:
        return list(render_frames(renderer, library, scene, views, supersample=1))


def all_round() -> list[Camera]:
    """Looking at the lamp from all sides and heights, it at the top or the bottom of the view."""
    out = []
    for k in range(8):
        turn = math.pi * k / 4
        eye = (AT[0] + 1.4 * math.cos(turn), AT[1] + 1.4 * math.sin(turn), 0.4 + 0.22 * k)
        target = (AT[0], AT[1], AT[2] - 0.5 + 0.13 * k)
        out.append(camera_at(eye, target, (320, 240)))
    return out


def test_only_what_is_fixed_convex_and_at_the_ceiling_is_overhead(library: Library) -> None:
    def found(scene: Scene) -> list[int]:
        return [solid.node_id for solid in overhead(library, scene)]

    assert found(lit()) == [LAMP]
    assert found(lit(at=(0.3, -0.2, 2.0))) == []
    assert found(box_room([thing(LAMP, "cube_01", AT)])) == []
    # Its legs stand out of the planes of others.
    assert found(lit(asset="table_01", at=(0.0, 0.0, 1.755))) == []


@pytest.mark.skipif(not EGL, reason="EGL does not start here")
def test_it_is_seen_from_everywhere_at_its_depth(library: Library) -> None:
    views = all_round()
    for view, frame in zip(views, frames(library, lit(), views), strict=True):
        shown = frame.instance == LAMP
        assert shown.sum() > 150
        red, green, blue = frame.rgb[shown].astype(float).T
        # The ceiling is white: nowhere has it been drawn over the lamp.
        assert np.median(red - blue) > 40
        assert np.mean(red - green > 20) > 0.9
        rows, columns = np.nonzero(shown)
        k, depth = np.asarray(view.K), frame.depth_mm[shown] / 1000.0
        x, y = (columns - k[0, 2]) / k[0, 0] * depth, (rows - k[1, 2]) / k[1, 1] * depth
        points = apply(np.asarray(view.world_from_camera), np.column_stack([x, y, depth]))
        off = np.abs(points - (AT[0], AT[1], AT[2] + 0.1)).max(axis=1)
        assert np.abs(off - 0.1).max() < 0.004


@pytest.mark.skipif(not EGL, reason="EGL does not start here")
def test_it_throws_no_shadow_and_things_before_it_hide_it(library: Library) -> None:
    view = camera_at((-1.5, -1.5, 1.5), (0.3, 0.3, 0.0), (320, 240))
    (bare,) = frames(library, box_room(), [view])
    (with_lamp,) = frames(library, lit(), [view])
    floor = (bare.instance == 2) & (with_lamp.instance == 2)
    assert floor.sum() > 10000
    assert np.array_equal(bare.rgb[floor], with_lamp.rgb[floor])
    before = thing(7, "cube_02", (0.3, -0.2, 1.9), fixed=True)
    below = camera_at((0.3, -0.21, 0.5), (0.3, -0.2, 2.3), (320, 240))
    (hidden,) = frames(library, lit(before), [below])
    middle = hidden.instance[110:130, 150:170]
    assert (middle == 7).all()
