"""Roofs: courses of tiles, windows in them, snow."""

from __future__ import annotations

import numpy as np

from sdgen.render.backdrop.canvas import Floats, looked_up
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.solids import Block

#: How far courses of tiles and tiles in one are apart, metres.
_COURSE_M, _TILE_M = 0.34, 0.3
#: Windows in roofs: how far apart, where between eaves and ridge, how wide and high, metres.
_SKYLIGHT_M = (4.2, 0.8, 1.15)


def roof_colours(
    block: Block, light: Light, along: Floats, across: Floats, pixel_m: Floats, grain: Floats
) -> Floats:
    """Colours (N, 3) of a roof at places along its ridge and across it, metres."""
    k = 1 - block.ridge
    tilt = 1 / float(np.hypot(1, block.slope))
    lean = [0.0, 0.0, tilt]
    lean[k] = block.slope * tilt
    sides = np.stack([light.on((sign * lean[0], sign * lean[1], tilt)) for sign in (-1.0, 1.0)])
    shade = sides[(across > 0).astype(np.intp)]
    # Down the slope from the ridge.
    down = np.abs(across) * np.float32(1 / tilt)
    tone = 1 + 0.05 * looked_up(grain, along * 3, down * 5)
    if not block.tiled:
        return np.asarray(block.top * tone[:, None] * shade, dtype=np.float32)
    course = down * np.float32(1 / _COURSE_M)
    tile = along * np.float32(1 / _TILE_M) + 0.5 * (np.floor(course) % 2)
    # What is finer than a pixel is not seen.
    clear = np.clip(1.4 - pixel_m * np.float32(1.6 / _COURSE_M), 0, 1)
    low = course - np.floor(course)
    deep = np.where(low > 0.78, np.float32(-0.42), 0.1 * low)
    deep += 0.09 * looked_up(grain, np.floor(tile) * 3, np.floor(course) * 5)
    deep += np.where(tile - np.floor(tile) > 0.85, np.float32(-0.14), np.float32(0))
    tone += clear * deep
    # Weather leaves streaks; along the ridge lies a row of its own.
    tone += 0.07 * looked_up(grain, along * 1.3, down * 0.25)
    tone *= np.where(down < 0.2, np.float32(0.8), np.float32(1))
    colours = block.top * tone[:, None] * shade
    if block.seed % 3:
        _with_skylights(colours, block, light, along, across, shade)
    return np.asarray(colours, dtype=np.float32)


def _with_skylights(
    colours: Floats, block: Block, light: Light, along: Floats, across: Floats, shade: Floats
) -> None:
    step, wide, high = _SKYLIGHT_M
    k = 1 - block.ridge
    half = (block.high[k] - block.low[k]) / 2
    bays = max(1, round((block.high[1 - k] - block.low[1 - k]) / step))
    size = np.float32((block.high[1 - k] - block.low[1 - k]) / bays)
    bay = np.floor(along / size)
    x = np.abs(along - (bay + np.float32(0.5)) * size) / np.float32(wide / 2)
    slant = float(np.hypot(1, block.slope))
    z = np.abs(np.abs(across) - np.float32(half * 0.5)) / np.float32(high / 2 / slant)
    # Some bays have one.
    kept = ((bay.astype(np.int32) * 7 + block.seed) % 5 < 2) | (across < 0) & (block.seed % 2 == 0)
    there = np.nonzero((x < 1.2) & (z < 1.15) & kept)[0]
    inner = (x[there] < 1) & (z[there] < 1)
    lit = light.lit > 0 and block.seed % 4 == 1
    pane = np.array((0.9, 0.58, 0.26), np.float32) * light.glow * 0.6 if lit else light.sky * 0.5
    frame = np.float32(0.12) * shade[there]
    colours[there] = np.where(inner[:, None], pane, frame)
