"""Background and clear panes show the world outside; nothing else is painted."""

import numpy as np
import pytest
from sdgen.cameras.pinhole import intrinsics, matrix4
from sdgen.geometry import look_at
from sdgen.library import Library
from sdgen.render.outdoors import Outside
from sdgen.render.panorama import panorama
from sdgen.scene import Camera, Outdoors
from sdgen.vocabulary import SEASONS, WEATHERS

from tests import toy

SUMMER = Outdoors(season="summer", weather="clear")


def camera(yaw: float = 0.0) -> Camera:
    eye = (0.0, 0.0, 1.2)
    return Camera(
        index=0,
        kind="room",
        room_id=1,
        width=64,
        height=48,
        K=intrinsics(64, 48),
        world_from_camera=matrix4(look_at(eye, (5.0 * np.cos(yaw), 5.0 * np.sin(yaw), 1.2))),
        near_m=0.05,
        far_m=60.0,
    )


def outside(outdoors=SUMMER, panes=(), home=None):
    """The world outside a home without things but for these panes."""
    home = home or toy.scene().home
    bare = toy.scene().model_copy(
        update={"home": home.model_copy(update={"outdoors": outdoors}), "objects": ()}
    )
    world = Outside(Library([]), bare)
    world._panes = panes
    return world


def painted(instance, part=None, panes=(), outdoors=SUMMER, view=None):
    before = np.full((48, 64, 3), 7, dtype=np.uint8)
    part = np.zeros((48, 64), dtype=np.uint8) if part is None else part
    world = outside(outdoors, panes)
    after = world.paint(before, instance, part, view or camera())
    assert np.all(before == 7)
    return before, after


def test_background_is_sky_above_and_lawn_below():
    instance = np.ones((48, 64), dtype=np.uint16)
    instance[:, :32] = 0
    _, after = painted(instance)
    assert np.all(after[:, 32:] == 7)
    red, green, blue = after[0, :32].mean(axis=0)
    assert blue > green > red
    red, green, blue = after[28, :32].mean(axis=0)
    assert green > red > blue


def test_a_picture_without_background_stays_as_it_is():
    before, after = painted(np.ones((48, 64), dtype=np.uint16))
    assert after is before


def test_of_a_window_the_clear_pane_alone_is_painted_a_little_paler_than_the_open():
    instance = np.full((48, 64), 5, dtype=np.uint16)
    part = np.ones((48, 64), dtype=np.uint8)
    part[:, :32] = 2
    _, after = painted(instance, part, [(5, 2)])
    assert np.all(after[:, 32:] == 7)
    _, bare = painted(np.where(part == 2, 0, instance).astype(np.uint16))
    through, without = after[:, :32].astype(int), bare[:, :32].astype(int)
    assert np.all(np.abs(through - without) <= 20)
    assert through.mean() > without.mean()
    _, other = painted(instance, part, [(6, 2)])
    assert np.all(other == 7)


def test_the_world_turns_with_the_camera():
    sky = np.zeros((48, 64), dtype=np.uint16)
    _, ahead = painted(sky)
    _, turned = painted(sky, view=camera(np.pi / 2))
    _, around = painted(sky, view=camera(2 * np.pi))
    assert np.abs(ahead.astype(int) - around).max() <= 1
    assert np.abs(ahead.astype(int) - turned).mean() > 3


@pytest.mark.parametrize("storey", [0, 1, 5])
def test_worlds_differ_by_season_and_weather_and_close_round(storey):
    worlds = [
        panorama(Outdoors(storey=storey, season=season, weather=weather))
        for season in SEASONS
        for weather in WEATHERS
    ]
    for k, world in enumerate(worlds):
        steps = np.abs(np.diff(world.astype(int), axis=1)).mean(axis=(0, 2))
        seam = np.abs(world[:, 0].astype(int) - world[:, -1]).mean()
        assert seam <= steps.max()
        for other in worlds[:k]:
            assert np.abs(world.astype(int) - other).mean() > 2


def test_a_world_is_the_same_however_often_it_is_painted():
    first = panorama(SUMMER).copy()
    panorama.cache_clear()
    assert np.array_equal(first, panorama(SUMMER))
