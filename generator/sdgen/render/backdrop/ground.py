"""The ground: lawns, roads, paths and water, as they lie, with shadows and the light of lamps."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sdgen.geometry import Vec2
from sdgen.render.backdrop.canvas import COLUMNS, Canvas, Floats, Ints, looked_up, soft
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.plants import Tree, shadow_of
from sdgen.render.backdrop.solids import Block

#: Shadows are reckoned for so many metres around, one of so many pixels each way.
_SHADOWS_M, _COARSE = 70.0, 4
#: A lamp lights the ground for so many metres.
_POOL_M = 14.0
#: Blocks that are thinner or lower than this cast no shadow that one would see.
_THIN_M, _FLAT_M = 0.2, 0.9


class Patch(NamedTuple):
    """Ground from ``low`` to ``high`` (x, y) of one colour; ``rough``: how grainy. Paths may bend
    by ``bend_m``; ``shine``: water, which shows the sky; ``dash_m``: lines on a road, so long."""

    low: Vec2
    high: Vec2
    colour: Floats
    rough: float = 0.06
    bend_m: float = 0.0
    shine: float = 0.0
    slabs_m: float = 0.0
    dash_m: float = 0.0


class _Seen(NamedTuple):
    """The ground that is seen: places in the picture, where these lie and how far, metres, (N,)."""

    places: Ints
    x: Floats
    y: Floats
    far_m: Floats


def paint_ground(
    canvas: Canvas,
    light: Light,
    base: Patch,
    patches: Sequence[Patch],
    blocks: Sequence[Block],
    trees: Sequence[Tree],
    lamps: Sequence[Vec2],
    grain: Floats,
) -> None:
    """All below the horizon where nothing stands before it."""
    rows = slice(int(np.argmax(canvas.climbs < -0.002)), len(canvas.climbs))
    seen = _seen(canvas, rows)
    far, x, y = seen.far_m, seen.x, seen.y
    # Far away grain is finer than a pixel.
    rough = looked_up(grain, x * 22, y * 22)
    # Broad spots have no straight edges: their places are shaken.
    px, py = x + 0.35 * rough, y + 0.35 * rough
    rough *= np.exp(far * np.float32(-1 / 22.0))
    rough += looked_up(grain, px * 3.1, py * 3.1) * np.exp(far * np.float32(-1 / 60.0)) * 0.6
    rough += looked_up(grain, px * 0.9, py * 0.9) * np.exp(far * np.float32(-1 / 150.0)) * 0.5
    which = np.zeros(len(x), dtype=np.uint8)
    joints = np.ones(len(x), dtype=np.float32)
    for k, patch in enumerate(patches, start=1):
        inside = _inside(patch, x, y)
        if patch.slabs_m:
            # Joints are seen where they are some pixels apart.
            near = np.nonzero(inside & (far < 30.0))[0]
            size = patch.slabs_m
            sx, sy = x[near] / size, y[near] / size
            line = (sx % 1 < 0.03 / size) | (sy % 1 < 0.03 / size)
            tone = 0.1 * looked_up(grain, np.floor(sx) * 5, np.floor(sy) * 7)
            deep = np.exp(far[near] / -14.0)
            joints[near] = 1 + deep * np.where(line, np.float32(-0.35), tone)
        which[inside] = k
    kinds = (base, *patches)
    rough *= np.array([kind.rough for kind in kinds], dtype=np.float32)[which]
    colours = np.stack([kind.colour for kind in kinds]).astype(np.float32)[which]
    colours *= ((1 + rough) * joints)[:, None]
    _fields(colours, seen, which, grain)
    sun = 1 - _shadows(canvas, rows, seen, light, blocks, trees)
    up = light.sky + light.sun * np.float32(max(0.05, float(light.towards[2]))) * sun[:, None]
    if light.lamps:
        up += _pools(x, y, lamps)[:, None] * np.array((0.5, 0.33, 0.15), np.float32) * light.lamps
    colours *= up
    shine = np.array([kind.shine for kind in kinds], dtype=np.float32)
    if shine.any():
        _mirror(canvas, colours, seen, shine[which], grain)
    canvas.fill(seen.places, far, colours)


def _seen(canvas: Canvas, rows: slice) -> _Seen:
    free = np.flatnonzero(np.isinf(canvas.far_m[rows]))
    depth = (canvas.eye_m / -canvas.climbs[rows]).astype(np.float32)
    far = depth[free // COLUMNS]
    columns = free & (COLUMNS - 1)
    x, y = far * canvas.ways[0][columns], far * canvas.ways[1][columns]
    return _Seen(free + rows.start * COLUMNS, x, y, far)


def _inside(patch: Patch, x: Floats, y: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """The places that belong to a patch."""
    along = y - np.float32(patch.bend_m) * np.sin(x / 9.0) if patch.bend_m else y
    inside = (along > patch.low[1]) & (along < patch.high[1])
    inside &= (x > patch.low[0]) & (x < patch.high[0])
    if patch.dash_m:
        inside &= x % (2.5 * patch.dash_m) < patch.dash_m
    return inside


def _fields(
    colours: Floats, seen: _Seen, which: np.ndarray[tuple[int], np.dtype[np.uint8]], grain: Floats
) -> None:
    """Far away lie fields and woods."""
    there = np.nonzero((seen.far_m > 90.0) & (which == 0))[0]
    x, y, far = seen.x[there], seen.y[there], seen.far_m[there]
    tone = soft(90, 260, far) * np.clip(0.35 * looked_up(grain, x / 60, y / 60), -0.55, 0.5)
    colours[there] *= 1 + tone[:, None] * np.array((1.1, 0.8, 0.7), dtype=np.float32)


def _pools(x: Floats, y: Floats, lamps: Sequence[Vec2]) -> Floats:
    """Light under street lamps, (N,)."""
    out = np.zeros(len(x), dtype=np.float32)
    for level in sorted({lamp[1] for lamp in lamps}):
        near = np.nonzero(np.abs(y - np.float32(level)) < _POOL_M)[0]
        px, aside = x[near], (y[near] - np.float32(level)) ** 2
        total = np.zeros(len(near), dtype=np.float32)
        for lamp in lamps:
            if lamp[1] == level:
                total += 1 / (1 + ((px - np.float32(lamp[0])) ** 2 + aside) / 9.0) ** 2
        out[near] += total
    return out


def _mirror(canvas: Canvas, colours: Floats, seen: _Seen, shine: Floats, grain: Floats) -> None:
    """The flatter water is seen, the more of the sky it mirrors."""
    wet = np.nonzero(shine)[0]
    x, y, far, places = seen.x[wet], seen.y[wet], seen.far_m[wet], seen.places[wet]
    fine = looked_up(grain, x * 0.7 / (1 + far / 60), y * 2.2 / (1 + far / 60))
    waves = 1 + 0.12 * fine
    share = shine[wet] * np.clip(0.25 + 0.75 * np.exp(-canvas.eye_m / far * 6), 0, 1)
    mirrored = canvas.haze[places & (COLUMNS - 1)] * waves[:, None]
    colours[wet] += (mirrored - colours[wet]) * share[:, None]


def _shadows(
    canvas: Canvas,
    rows: slice,
    seen: _Seen,
    light: Light,
    blocks: Sequence[Block],
    trees: Sequence[Tree],
) -> Floats:
    """How much of the sun is kept from places of the ground: coarse, then drawn out."""
    out = np.zeros(len(seen.places), dtype=np.float32)
    if not light.sun.any():
        return out
    far = (canvas.eye_m / -canvas.climbs[rows][::_COARSE])[:, None]
    some = far[:, 0] < 3 * _SHADOWS_M
    if not some.any():
        return out
    # Farther rows have none.
    start = int(np.argmax(some))
    far = far[start:]
    px, py = far * canvas.ways[0][::_COARSE], far * canvas.ways[1][::_COARSE]
    shade = np.zeros(px.shape, dtype=np.float32)
    level = float(np.hypot(*light.towards[:2]))
    way = light.towards[:2] / max(level, 1e-3)
    climb = float(light.towards[2]) / max(level, 1e-3)
    for block in blocks:
        thin = min(block.high[0] - block.low[0], block.high[1] - block.low[1]) < _THIN_M
        if block.away_m > _SHADOWS_M or thin or block.high_m < _FLAT_M:
            continue
        enter: Floats = np.zeros(px.shape, dtype=np.float32)
        leave: Floats = np.full(px.shape, np.inf, dtype=np.float32)
        for k, at in ((0, px), (1, py)):
            step = float(way[k]) if abs(float(way[k])) > 1e-3 else 1e-3
            a, b = (np.float32(side / step) - at * np.float32(1 / step) for side in _ends(block, k))
            enter, leave = np.maximum(enter, np.minimum(a, b)), np.minimum(leave, np.maximum(a, b))
        # Under its ridge, too: a pitched roof is taken for one half as high.
        high = block.wall_m + (block.high_m - block.wall_m) / 2
        hit = enter < leave
        hit &= enter < 1.15 * high / max(climb, 1e-3)
        if hit.any():
            cast = soft(1.15, 0.9, enter[hit] * np.float32(climb / high))
            shade[hit] = np.maximum(shade[hit], cast)
    for tree in trees:
        if tree.away_m < _SHADOWS_M:
            shade = np.maximum(shade, shadow_of(tree, light, px, py))
    near = np.nonzero(seen.far_m < 3 * _SHADOWS_M)[0]
    places = seen.places[near]
    drawn = _drawn_out(shade, places // COLUMNS - rows.start - start * _COARSE, places % COLUMNS)
    # A smooth field is cut where it passes the middle: edges are as sharp as pixels.
    dark = soft(0.3, 0.62, drawn) * soft(3 * _SHADOWS_M, _SHADOWS_M, seen.far_m[near])
    out[near] = dark * np.float32(0.92)
    return out


def _ends(block: Block, k: int) -> tuple[float, float]:
    return block.low[k], block.high[k]


def _drawn_out(coarse: Floats, rows: Ints, columns: Ints) -> Floats:
    """A field of some rows and all columns round, between its values, at places (N,)."""
    count, wide = coarse.shape
    flat = coarse.reshape(-1)
    y = np.clip(rows.astype(np.float32) / _COARSE, 0, count - 1.001)
    x = columns.astype(np.float32) / _COARSE
    top, left = y.astype(np.int32), x.astype(np.int32)
    down, across = y - top, x - left
    right, top = (left + 1) % wide, top * wide
    above, below = flat.take(top + left), flat.take(top + wide + left)
    above += (flat.take(top + right) - above) * across
    below += (flat.take(top + wide + right) - below) * across
    above += (below - above) * down
    return np.asarray(above, dtype=np.float32)
