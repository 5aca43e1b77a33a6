"""Background and clear panes show the world outside; nothing else is painted."""

import subprocess
import sys
from zlib import crc32

import numpy as np
import pytest
from sdgen.cameras.pinhole import intrinsics, matrix4
from sdgen.geometry import look_at
from sdgen.library import Library
from sdgen.render.backdrop.canvas import COLUMNS, ROWS, row_of
from sdgen.render.backdrop.world import _painted, panorama
from sdgen.render.outdoors import Outside
from sdgen.scene import Camera, Daylight, Outdoors
from sdgen.vocabulary import SEASONS, WEATHERS

from tests import toy

SUMMER = Outdoors(season="summer", weather="clear")
#: Above what stands about a home at the ground: the sky.
HIGH = slice(0, 60)


def at(time, azimuth=90.0, elevation=30.0):
    return Daylight(time=time, sun_azimuth_deg=azimuth, sun_elevation_deg=elevation)


DAY, EVENING, NIGHT = at("day"), at("evening", elevation=8.0), at("night")


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


def outside(outdoors=SUMMER, panes=(), home=None, daylight=DAY):
    """The world outside a home without things but for these panes."""
    home = home or toy.scene().home
    home = home.model_copy(update={"outdoors": outdoors, "daylight": daylight})
    bare = toy.scene().model_copy(update={"home": home, "objects": ()})
    world = Outside(Library([]), bare)
    world._panes = panes
    return world


def painted(instance, part=None, panes=(), outdoors=SUMMER, view=None, daylight=DAY):
    before = np.full((48, 64, 3), 7, dtype=np.uint8)
    part = np.zeros((48, 64), dtype=np.uint8) if part is None else part
    world = outside(outdoors, panes, daylight=daylight)
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
    below = [painted(instance, view=camera(yaw))[1][28:32, :32] for yaw in (0, 1.6, 3.2, 4.8)]
    red, green, blue = np.concatenate(below).mean(axis=(0, 1))
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


@pytest.mark.parametrize("time", ["day", "evening", "night"])
@pytest.mark.parametrize("storey", [0, 5])
def test_worlds_differ_by_season_and_weather_and_close_round(storey, time):
    worlds = [
        panorama(Outdoors(storey=storey, season=season, weather=weather), at(time))
        for season in SEASONS
        for weather in WEATHERS
    ]
    for k, world in enumerate(worlds):
        steps = np.abs(np.diff(world.astype(int), axis=1)).mean(axis=(0, 2))
        seam = np.abs(world[:, 0].astype(int) - world[:, -1]).mean()
        assert seam <= steps.max()
        for other in worlds[:k]:
            assert np.abs(world.astype(int) - other).mean() > (2 if time != "night" else 1)


@pytest.mark.parametrize("weather", WEATHERS)
@pytest.mark.parametrize("storey", [0, 3])
def test_it_gets_dark(storey, weather):
    world = Outdoors(storey=storey, weather=weather)
    day, evening, night = (panorama(world, light).mean() for light in (DAY, EVENING, NIGHT))
    assert day > 1.4 * evening > 2.5 * night
    assert night > 3


def side(picture, azimuth):
    """An eighth of the sky about there."""
    middle = round(azimuth / 360 * picture.shape[1])
    columns = np.arange(middle - 128, middle + 128) % picture.shape[1]
    return picture[HIGH][:, columns].mean(axis=(0, 1))


@pytest.mark.parametrize("azimuth", [0.0, 135.0, 270.0])
def test_the_sky_is_brighter_towards_the_sun_and_warmer_in_the_evening(azimuth):
    outdoors = Outdoors(storey=5)
    day, evening = (panorama(outdoors, at(time, azimuth)) for time in ("day", "evening"))
    for picture in (day, evening):
        assert side(picture, azimuth).sum() > 1.02 * side(picture, azimuth + 180).sum()
    red, _, blue = side(evening, azimuth)
    away_red, _, away_blue = side(evening, azimuth + 180)
    assert red / blue > 1.1 * away_red / away_blue


def test_by_night_windows_are_lit_and_by_day_none_is():
    outdoors = Outdoors(storey=3, weather="cloudy")

    def warm(light):
        red, _, blue = np.moveaxis(panorama(outdoors, light).astype(int), 2, 0)
        return (red > 150) & (red > 1.3 * blue)

    dark = panorama(outdoors, NIGHT).mean(axis=2) < 60
    assert dark.mean() > 0.8
    assert 200 < warm(NIGHT).sum() < 0.05 * dark.size


def test_few_worlds_are_painted_for_suns_that_differ_little():
    assert panorama(SUMMER, at("day", 92.0)) is panorama(SUMMER, at("day", 88.0))
    assert panorama(SUMMER, at("day", 359.0)) is panorama(SUMMER, at("day", 1.0))
    assert panorama(SUMMER, at("day", 90.0)) is not panorama(SUMMER, at("day", 110.0))
    assert panorama(SUMMER, at("night", 10.0, 50.0)) is panorama(SUMMER, at("night", 200.0))
    grey = Outdoors(weather="overcast")
    assert panorama(grey, at("day", 10.0)) is panorama(grey, at("day", 200.0, 60.0))


_CRC = """
from zlib import crc32
from sdgen.render.backdrop.world import panorama
from sdgen.scene import Daylight, Outdoors
print(crc32(panorama(Outdoors(storey=2, season="winter"), Daylight(time="evening")).tobytes()))
"""


def test_a_world_is_the_same_in_every_process():
    here = panorama(Outdoors(storey=2, season="winter"), Daylight(time="evening"))
    done = subprocess.run(
        [sys.executable, "-c", _CRC], capture_output=True, text=True, check=True, timeout=60
    )
    assert int(done.stdout) == crc32(here.tobytes())


def test_nobody_can_write_into_the_one_that_is_kept():
    with pytest.raises(ValueError, match="read-only"):
        panorama(SUMMER, DAY)[0, 0] = 0


def widths(picture):
    """How many pixels of a world the clear edges of what stands before the sky take."""
    grey = picture[200:330].astype(float).mean(axis=2)
    out = []
    for line in grey:
        steps = np.abs(line[8:] - line[:-8])
        for at in np.flatnonzero((steps > 90) & (steps == np.max(steps))):
            low, high = sorted((line[at], line[at + 8]))
            part = (line[at : at + 9] - low) / (high - low)
            out.append(int(((part > 0.1) & (part < 0.9)).sum()))
    return out


@pytest.mark.parametrize("storey", [0, 2])
def test_edges_outside_are_sharp(storey):
    # A picture of a room has some seven pixels a degree, a world eleven.
    found = widths(panorama(Outdoors(storey=storey, weather="clear"), DAY))
    assert len(found) > 30
    assert np.median(found) <= 2


def test_what_is_seen_lies_where_it_is_painted(monkeypatch):
    # One bright place a little over the horizon, ahead; then to the left.
    world = np.zeros((ROWS, COLUMNS, 3), dtype=np.uint8)
    rows = np.abs(row_of(np.array([0.1])) - np.arange(ROWS)) < 6
    monkeypatch.setattr("sdgen.render.outdoors.panorama", lambda *_: world)
    sky = np.zeros((48, 64), dtype=np.uint16)
    for yaw in (0.0, 0.3):
        world[:] = 0
        middle = int(yaw / (2 * np.pi) * COLUMNS)
        world[np.ix_(rows, np.arange(middle - 6, middle + 7) % COLUMNS)] = 255
        _, after = painted(sky, view=camera(yaw))
        seen_rows, seen_columns = np.nonzero(after[..., 0] > 60)
        assert seen_columns.mean() == pytest.approx(31.5, abs=1.0)
        focal = intrinsics(64, 48)[1][1]
        assert seen_rows.mean() == pytest.approx(23.5 - 0.1 * focal, abs=1.0)


def test_the_few_worlds_that_are_kept_take_moderate_memory():
    one = panorama(SUMMER, DAY)
    assert one.nbytes * _painted.cache_info().maxsize < 80 * 2**20


def test_a_bright_sky_turns_paler_and_keeps_its_hue():
    from sdgen.render.outdoors import _brighter

    dim, sky, white = _brighter(np.array([[50.0, 60, 70], [120, 180, 240], [255, 255, 255]]), 1.3)
    assert dim == pytest.approx([65, 78, 91])
    assert sky.max() <= 255
    assert sky[0] < sky[1] < sky[2]
    assert sky[0] > 1.1 * 120
    assert white == pytest.approx([255, 255, 255])
