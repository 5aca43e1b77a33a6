"""The world around a home as one picture: sky, hills, roofs, trees and ground, all the way round.

Painted by numpy from layers of silhouettes, far to near, as a theatre paints its backdrop. The
world is far away: it turns with a camera but does not shift.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple
from zlib import crc32

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.scene import Outdoors
from sdgen.vocabulary import Season, Weather

#: Columns for a full turn, and rows between the lowest and the highest elevation (sine): some six
#: pixels a degree, as many as a picture of 640 pixels has.
COLUMNS, ROWS = 2048, 320
LOWEST, HIGHEST = -0.7, 0.7

Rgb = tuple[int, int, int]


class _Sky(NamedTuple):
    """Colours at the horizon and overhead, of clouds and how much of the sky they take, and how
    much of a far layer's colour haze takes."""

    low: Rgb
    high: Rgb
    clouds: Rgb
    cover: float
    haze: float


_SKIES: dict[Weather, _Sky] = {
    "clear": _Sky((212, 230, 243), (112, 168, 226), (250, 251, 253), 0.12, 0.45),
    "cloudy": _Sky((214, 226, 236), (128, 172, 216), (244, 245, 247), 0.5, 0.5),
    "overcast": _Sky((222, 225, 228), (186, 193, 201), (206, 210, 214), 0.9, 0.65),
}


class _Plants(NamedTuple):
    """Colours of leaves (from shade to light) and of grass, and how bare the trees are."""

    shade: Rgb
    light: Rgb
    grass: Rgb
    bare: float


_PLANTS: dict[Season, _Plants] = {
    "spring": _Plants((92, 134, 66), (168, 196, 108), (134, 178, 92), 0.15),
    "summer": _Plants((58, 104, 56), (122, 164, 88), (122, 158, 84), 0.0),
    "autumn": _Plants((126, 84, 40), (214, 152, 66), (150, 154, 88), 0.25),
    "winter": _Plants((64, 82, 66), (128, 146, 130), (172, 178, 158), 0.5),
}
_WALLS = ((232, 222, 202), (206, 170, 140), (226, 226, 222), (186, 120, 96), (214, 200, 160))
_ROOFS = ((150, 78, 58), (98, 84, 80), (122, 112, 106), (168, 96, 66))
_PANES = (96, 112, 126)
_SNOW = (236, 240, 245)


@lru_cache(maxsize=32)
def panorama(outdoors: Outdoors) -> npt.NDArray[np.uint8]:
    """The world as (ROWS, COLUMNS, 3) colours, the highest elevation first; painted once a
    process, as far as memory serves (2 MB each)."""
    words = f"{outdoors.storey} {outdoors.season} {outdoors.weather} {outdoors.variant}"
    rng = np.random.default_rng([crc32(words.encode()), 1])
    sky, plants = _SKIES[outdoors.weather], _PLANTS[outdoors.season]
    winter = outdoors.season == "winter"
    rise = np.linspace(HIGHEST, LOWEST, ROWS)[:, None]
    picture = _sky(sky, rise, rng)
    # From higher up one sees over the near, and down on it.
    drop = 0.045 * outdoors.storey
    ground = np.array(plants.grass, dtype=float)
    far = _mixed(plants.shade, sky.low, sky.haze)
    _cover(picture, rise < 0.05 + 0.05 * _wave(rng, 5), far)
    _cover(picture, rise < -0.004, _mixed(ground, sky.low, sky.haze * 0.7))
    for distance in (0.5, 0.25, 0.0):
        haze = sky.haze * distance
        low = -0.02 - drop * (1.6 - distance)
        # Streets are seen from above, gardens from the ground.
        houses = int(rng.integers(5, 10)) + 3 * outdoors.storey
        _houses(picture, low, 0.11 - 0.1 * distance, houses, haze, sky, winter, rng)
        tall = 0.22 - 0.2 * distance - drop / 2
        _trees(picture, rise, low, tall, int(rng.integers(20, 32)), haze, sky, plants, rng)
        grass = _mixed(ground, sky.low, haze * 0.7) * (1 - 0.05 * distance)
        _cover(picture, rise < low, grass)
    _cover(picture, rise < -0.35 - drop, np.array((176, 172, 164), dtype=float))
    if outdoors.storey == 0:
        _trees(picture, rise, -0.16, 0.42, int(rng.integers(5, 9)), 0.0, sky, plants, rng)
    speckle = np.tile(0.025 * rng.standard_normal((ROWS, COLUMNS // 8)), (1, 8)) * (rise < 0)
    return np.clip(picture * (1 + speckle[..., None]), 0, 255).astype(np.uint8)


def _sky(sky: _Sky, rise: Array, rng: np.random.Generator) -> Array:
    height = np.clip(rise / HIGHEST, 0, 1)[..., None]
    picture = np.array(sky.low) * (1 - height) + np.array(sky.high) * height
    picture = np.broadcast_to(picture, (ROWS, COLUMNS, 3)).copy()
    # Clouds lie flatter the lower they stand.
    field = np.zeros((ROWS, COLUMNS))
    for waves, weight in ((5, 1.0), (11, 0.6), (23, 0.35), (47, 0.2)):
        along, up = rng.uniform(0, 2 * np.pi, 2)
        turn = np.linspace(0, 2 * np.pi, COLUMNS, endpoint=False)[None, :]
        bend = 1.5 * np.sin(waves * 0.5 * 6 * rise + up)
        field += weight * np.sin(waves * turn + along + bend) * np.sin(waves * 2.2 * rise + up)
    cut = np.quantile(field, 1 - sky.cover)
    amount = np.clip((field - cut) / 0.9, 0, 1)[..., None] * 0.9
    return np.asarray(picture * (1 - amount) + np.array(sky.clouds) * amount)


def _wave(rng: np.random.Generator, first: int) -> Array:
    """A line round the horizon, (1, COLUMNS), of some -1 to 1."""
    turn = np.linspace(0, 2 * np.pi, COLUMNS, endpoint=False)
    waves = [(first, 0.5), (2 * first + 1, 0.3), (5 * first + 2, 0.2)]
    parts = [w * np.sin(n * turn + rng.uniform(0, 2 * np.pi)) for n, w in waves]
    return np.asarray(sum(parts))[None, :]


def _mixed(a: Array | Rgb, b: Array | Rgb, share: float) -> Array:
    return np.asarray(a, dtype=float) * (1 - share) + np.asarray(b, dtype=float) * share


def _cover(picture: Array, where: npt.NDArray[np.bool_], colour: Array) -> None:
    shape = np.broadcast_to(where, picture.shape[:2])
    picture[shape] = colour if colour.ndim == 1 else colour[shape]


def _row(rise: float) -> int:
    return int(np.clip((HIGHEST - rise) / (HIGHEST - LOWEST) * ROWS, 0, ROWS))


def _houses(
    picture: Array,
    low: float,
    tall: float,
    count: int,
    haze: float,
    sky: _Sky,
    winter: bool,
    rng: np.random.Generator,
) -> None:
    """Houses that stand at an elevation: walls with windows under a gable or a hip."""
    for _ in range(count):
        wide = int(rng.uniform(1.2, 2.6) * tall * COLUMNS / 6.3)
        at = int(rng.integers(0, COLUMNS - wide - 1))
        top = low + tall * float(rng.uniform(0.7, 1.2))
        wall = _mixed(_WALLS[int(rng.integers(len(_WALLS)))], sky.low, haze)
        roof = _mixed(_ROOFS[int(rng.integers(len(_ROOFS)))], sky.low, haze)
        first, last = _row(top), _row(low)
        if last - first < 6 or wide < 8:
            continue
        picture[first:last, at : at + wide] = wall
        ridge = max(0, first - (last - first) * 2 // 3)
        for row in range(ridge, first):
            inset = int((first - row) / max(1, first - ridge) * wide * 0.28)
            left, right = max(0, at - 2 + inset), at + wide + 2 - inset
            picture[row, left:right] = _SNOW if winter else roof
        panes = _mixed(_PANES, sky.low, haze)
        step, size = max(6, wide // 4), max(2, wide // 10)
        for x in range(at + step // 2, at + wide - size, step):
            for y in range(first + 3, last - 4, max(6, (last - first) // 3)):
                picture[y : y + size + 2, x : x + size] = panes


def _trees(
    picture: Array,
    rise: Array,
    low: float,
    tall: float,
    count: int,
    haze: float,
    sky: _Sky,
    plants: _Plants,
    rng: np.random.Generator,
) -> None:
    """A row of crowns and bushes: heaps of round clumps, lit from above."""
    for _ in range(count):
        middle, crown = rng.uniform(0, COLUMNS), float(tall * rng.uniform(0.45, 1.0))
        trunk = _mixed((92, 72, 56), sky.low, haze)
        x = int(middle)
        first, last = _row(low + crown * 0.6), _row(low)
        picture[first:last, max(0, x - 1) : x + 2] = trunk
        # The larger a tree looks, the finer its clumps.
        fine = 0.5 if tall > 0.3 else 1.0
        for _ in range(int(rng.integers(6, 11) / fine**2)):
            if rng.random() < plants.bare:
                continue
            size = crown * fine * float(rng.uniform(0.18, 0.32))
            up = low + crown * float(rng.uniform(0.45, 0.95))
            off = middle + float(rng.normal(0, 0.16)) * crown * COLUMNS / 6.3
            reach = size * COLUMNS / 6.3
            near = np.arange(math.ceil(off - reach), math.ceil(off + reach))
            rows = np.arange(_row(up + size), _row(up - size))
            if len(near) == 0 or len(rows) == 0:
                continue
            across = (near[None, :] - off) / reach
            high = (rise[rows] - up) / size
            inside = across**2 + high**2 < 1
            lit = np.clip(0.5 + 0.4 * high - 0.15 * across, 0, 1)[..., None]
            leaves = np.array(plants.shade) * (1 - lit) + np.array(plants.light) * lit
            leaves = leaves * (1 + 0.1 * rng.standard_normal((len(rows), len(near), 1)))
            # Round the horizon: what reaches over the picture's end goes on at its beginning.
            crowned = np.ix_(rows, near % COLUMNS)
            leaves = _mixed(leaves, sky.low, haze)
            picture[crowned] = np.where(inside[..., None], leaves, picture[crowned])
