"""The world around a home as one picture: sky, hills, houses, trees and ground, all the way round,
by the time of the day.

Painted by numpy from a plan of what stands there, the nearest first, a little softer than pixels
of a picture of a room: such a camera looks at three metres, and sees what is far away nearly as
sharp. The world is far away: it turns with a camera but does not shift.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple
from zlib import crc32

import numpy as np
import numpy.typing as npt

from sdgen.render.backdrop.boxes import paint_block
from sdgen.render.backdrop.builder import Place
from sdgen.render.backdrop.canvas import COLUMNS, HIGHEST, Canvas, Floats, noise
from sdgen.render.backdrop.far import paint_hills, paint_woods
from sdgen.render.backdrop.ground import paint_ground
from sdgen.render.backdrop.light import Light, light_of
from sdgen.render.backdrop.places import place_random
from sdgen.render.backdrop.plants import Tree, paint_tree
from sdgen.render.backdrop.sky import moon_of, paint_sky
from sdgen.render.backdrop.solids import Block
from sdgen.scene import Daylight, Outdoors
from sdgen.vocabulary import DayTime

#: The sun's place is rounded to so many degrees, so that few worlds are painted.
_STEP_DEG = 15.0
#: An eye is so high over the floor, and a storey so high, metres.
_EYE_M, _STOREY_M = 1.5, 2.9
#: How far one sees, metres, by weather.
_HAZE_M = {"clear": 2200.0, "cloudy": 1500.0, "overcast": 900.0}
#: Above this share of white, colours are drawn together.
_SHOULDER = 0.6
#: Steps of a table of colours between black and white, and how bright the last of them is.
_LEVELS, _BRIGHTEST = 16384, 3.99
#: So many worlds are kept, 7.9 MB each.
_KEPT = 8


class _Sun(NamedTuple):
    """The time, and where the sun is, in steps: 0 where that is not seen."""

    time: DayTime
    azimuth: int
    elevation: int


def panorama(outdoors: Outdoors, daylight: Daylight) -> npt.NDArray[np.uint8]:
    """The world as (ROWS, COLUMNS, 3) colours, the highest elevation first; the last few are kept.
    Not to be written to."""
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


@lru_cache(maxsize=_KEPT)
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
    # Walls that are seen along their length and rows at eye level divide by nothing.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        _paint(canvas, light, place, outdoors, weather)
    picture = _softened(np.roll(_developed(canvas.colours), quarter * COLUMNS // 4, axis=1))
    picture.setflags(write=False)
    return picture


def _paint(
    canvas: Canvas, light: Light, place: Place, outdoors: Outdoors, rng: np.random.Generator
) -> None:
    paint_sky(canvas, light, outdoors.weather, rng)
    grain = noise(rng, 256, 0.3, 1.0)
    things: list[Block | Tree] = [*place.blocks, *place.trees]
    for thing in sorted(things, key=lambda thing: thing.away_m):
        if isinstance(thing, Tree):
            paint_tree(canvas, light, thing, place.lamps)
        else:
            paint_block(canvas, light, thing, grain, place.lamps)
    paint_woods(canvas, light, place, outdoors.season, rng)
    paint_ground(
        canvas, light, place.base, place.patches, place.blocks, place.trees, place.lamps, grain
    )
    paint_hills(canvas, light, place, outdoors.season, rng)
    if light.lamps:
        _lamps(canvas, light, place)


def _lamps(canvas: Canvas, light: Light, place: Place) -> None:
    """The heads of street lamps and the light round them, where nothing stands before them."""
    warm = np.array((1.0, 0.68, 0.34))
    for x, y in place.lamps:
        away = math.hypot(x, y)
        azimuth, climb = math.atan2(y, x) % (2 * math.pi), (5.2 - canvas.eye_m) / away
        rise = climb / math.hypot(1, climb)
        column = int(azimuth / (2 * math.pi) * COLUMNS) % COLUMNS
        row = int(np.argmin(np.abs(canvas.rises - rise)))
        if abs(rise) > HIGHEST or canvas.far_m[row, column] < away - 1.0:
            continue
        size = max(0.2 / away, 0.004)
        canvas.add(azimuth, rise, size, warm * 3.0 * light.lamps)
        canvas.add(azimuth, rise, max(2.0 / away, 0.02), warm * 0.16 * light.lamps)


def _softened(picture: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """Each pixel with the ones to its right and below: no steps along edges, no more."""
    wide = np.empty((picture.shape[0], COLUMNS, 3), dtype=np.uint16)
    np.add(picture[:, :-1], picture[:, 1:], out=wide[:, :-1], dtype=np.uint16)
    np.add(picture[:, -1], picture[:, 0], out=wide[:, -1], dtype=np.uint16)
    wide[:-1] += wide[1:]
    wide[-1] *= 2
    wide += 2
    wide >>= 2
    return np.asarray(wide.astype(np.uint8))


@lru_cache(maxsize=1)
def _table() -> npt.NDArray[np.uint8]:
    """Linear light as the eight bits of sRGB; the brightest drawn together."""
    levels = np.arange(int(_LEVELS * _BRIGHTEST) + 1) / _LEVELS
    over = np.maximum(levels - _SHOULDER, 0) / (1 - _SHOULDER)
    share = np.minimum(levels, _SHOULDER) + (1 - _SHOULDER) * (1 - np.exp(-over))
    bright = 1.055 * np.maximum(share, 1e-9) ** (1 / 2.4) - 0.055
    eight = np.rint(np.where(share <= 0.0031308, 12.92 * share, bright) * 255)
    return np.asarray(eight.astype(np.uint8))


def _developed(colours: Floats) -> npt.NDArray[np.uint8]:
    """What a camera makes of light. A table is quicker than powers; ``colours`` are used up."""
    table = _table()
    colours *= _LEVELS
    np.clip(colours, 0, len(table) - 1, out=colours)
    return np.asarray(table.take(colours.astype(np.uint16)))
