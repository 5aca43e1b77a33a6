"""The world around a home as one picture: sky, hills, houses, trees and ground, all the way round,
by the time of the day.

Painted by numpy from a plan of what stands there (:mod:`sdgen.render.backdrop`), a little out of
focus, as a camera sees it that looks at a room. The world is far away: it turns with a camera but
does not shift.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple
from zlib import crc32

import numpy as np
import numpy.typing as npt

from sdgen.render.backdrop.boxes import Block, paint_block
from sdgen.render.backdrop.builder import Place
from sdgen.render.backdrop.canvas import COLUMNS, HIGHEST, LOWEST, ROWS, Canvas, Floats, noise
from sdgen.render.backdrop.far import paint_hills, paint_woods
from sdgen.render.backdrop.ground import paint_ground
from sdgen.render.backdrop.light import Light, light_of
from sdgen.render.backdrop.places import place_random
from sdgen.render.backdrop.plants import Tree, paint_tree
from sdgen.render.backdrop.sky import moon_of, paint_sky
from sdgen.scene import Daylight, Outdoors
from sdgen.vocabulary import DayTime

__all__ = ["COLUMNS", "HIGHEST", "LOWEST", "ROWS", "panorama"]

#: The sun's place is rounded to so many degrees, so that few worlds are painted.
_STEP_DEG = 15.0
#: An eye is so high over the floor, and a storey so high, metres.
_EYE_M, _STOREY_M = 1.5, 2.9
#: How far one sees, metres, by weather.
_HAZE_M = {"clear": 1400.0, "cloudy": 1000.0, "overcast": 600.0}
#: Above this share of white, colours are drawn together.
_SHOULDER = 0.6


class _Sun(NamedTuple):
    """The time, and where the sun is, in steps: 0 where that is not seen."""

    time: DayTime
    azimuth: int
    elevation: int


def panorama(outdoors: Outdoors, daylight: Daylight) -> npt.NDArray[np.uint8]:
    """The world as (ROWS, COLUMNS, 3) colours, the highest elevation first; painted once a
    process, as far as memory serves (2 MB each). Not to be written to."""
    return _painted(outdoors, _sun_of(outdoors, daylight))


def _sun_of(outdoors: Outdoors, daylight: Daylight) -> _Sun:
    """By night no sun is seen, and behind thick clouds one does not see where it is."""
    if daylight.time == "night" or outdoors.weather == "overcast":
        return _Sun(daylight.time, 0, 0)
    azimuth = round(daylight.sun_azimuth_deg / _STEP_DEG) % round(360 / _STEP_DEG)
    # Evening suns all stand low.
    high = (
        0 if daylight.time == "evening" else max(1, round(daylight.sun_elevation_deg / _STEP_DEG))
    )
    return _Sun(daylight.time, azimuth, high)


@lru_cache(maxsize=32)
def _painted(outdoors: Outdoors, sun: _Sun) -> npt.NDArray[np.uint8]:
    words = f"{outdoors.storey} {outdoors.season} {outdoors.weather} {outdoors.variant}"
    plan, weather, moon = (np.random.default_rng([crc32(words.encode()), k]) for k in (1, 2, 3))
    # Streets run along the walls of a home, on any side of it.
    quarter = int(plan.integers(4))
    place = place_random(outdoors, plan)
    azimuth = math.radians(sun.azimuth * _STEP_DEG)
    elevation = math.radians(8.0 if sun.time == "evening" else sun.elevation * _STEP_DEG)
    if sun.time == "night":
        azimuth, elevation = moon_of(moon)
    light = light_of(sun.time, outdoors.weather, azimuth - quarter * math.pi / 2, elevation)
    canvas = Canvas(_EYE_M + _STOREY_M * outdoors.storey)
    canvas.haze_m = _HAZE_M[outdoors.weather]
    paint_sky(canvas, light, outdoors.weather, weather)
    grain = noise(weather, 256, 0.3, 1.0)
    paint_hills(canvas, light, place, outdoors.season, weather)
    paint_ground(
        canvas, light, place.base, place.patches, place.blocks, place.trees, place.lamps, grain
    )
    paint_woods(canvas, light, place, outdoors.season, weather)
    things: list[Block | Tree] = [*place.blocks, *place.trees]
    for thing in sorted(things, key=lambda thing: -thing.away_m):
        if isinstance(thing, Tree):
            paint_tree(canvas, light, thing)
        else:
            paint_block(canvas, light, thing, grain, place.lamps)
    if light.lamps:
        _lamps(canvas, light, place)
    colours = np.roll(_blurred(canvas.colours), quarter * COLUMNS // 4, axis=1)
    picture = _developed(colours)
    picture.setflags(write=False)
    return picture


def _lamps(canvas: Canvas, light: Light, place: Place) -> None:
    """The heads of street lamps and the light round them, where nothing stands before them."""
    warm = np.array((1.0, 0.68, 0.34))
    for x, y in place.lamps:
        away = math.hypot(x, y)
        azimuth, climb = math.atan2(y, x) % (2 * math.pi), (5.2 - canvas.eye_m) / away
        rise = climb / math.hypot(1, climb)
        column = int(azimuth / (2 * math.pi) * COLUMNS)
        row = int(np.argmin(np.abs(canvas.rises - rise)))
        if abs(rise) > HIGHEST or canvas.far_m[row, column] < away - 1.0:
            continue
        size = max(0.3 / away, 0.0035)
        canvas.add(azimuth, rise, size, warm * 2.2 * light.lamps)
        canvas.add(azimuth, rise, 8 * size, warm * 0.12 * light.lamps)


def _blurred(colours: Floats) -> Floats:
    """A camera that looks at a room does not see the world sharp."""
    out = colours
    for axis in (1, 0):
        padded = np.concatenate(
            [out[:, -3:], out, out[:, :3]] if axis else [out[:1]] * 3 + [out] + [out[-1:]] * 3,
            axis=axis,
        )
        count = out.shape[axis]
        total = np.zeros_like(out)
        for k, weight in enumerate((0.06, 0.12, 0.2, 0.24, 0.2, 0.12, 0.06)):
            cut = padded[:, k : k + count] if axis else padded[k : k + count]
            total += np.float32(weight) * cut
        out = total
    return out


def _developed(colours: Floats) -> npt.NDArray[np.uint8]:
    """Linear light as the eight bits of sRGB; the brightest drawn together."""
    over = np.maximum(colours - _SHOULDER, 0) / (1 - _SHOULDER)
    bent = np.minimum(colours, _SHOULDER) + (1 - _SHOULDER) * (1 - np.exp(-over))
    share = np.clip(bent, 0, 1)
    # A table is quicker than powers.
    levels = np.arange(4096) / 4095
    table = np.where(
        levels <= 0.0031308, 12.92 * levels, 1.055 * np.maximum(levels, 1e-9) ** (1 / 2.4) - 0.055
    )
    eight = np.rint(table * 255).astype(np.uint8)
    return np.asarray(eight[(share * 4095 + 0.5).astype(np.int32)])
