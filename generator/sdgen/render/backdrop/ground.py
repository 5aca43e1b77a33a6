"""The ground: lawns, roads, paths and water, as they lie, with shadows and the light of lamps."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sdgen.geometry import Vec2
from sdgen.render.backdrop.boxes import Block
from sdgen.render.backdrop.canvas import Canvas, Floats, looked_up, soft
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.plants import Tree, shadow_of

#: Shadows are reckoned for so many metres around, one of so many pixels each way.
_SHADOWS_M, _COARSE = 70.0, 4


class Patch(NamedTuple):
    """Ground from ``low`` to ``high`` (x, y) of one colour; ``rough``: how grainy. Paths may bend
    by ``bend_m``; ``shine``: water, which shows the sky."""

    low: Vec2
    high: Vec2
    colour: Floats
    rough: float = 0.06
    bend_m: float = 0.0
    shine: float = 0.0
    slabs_m: float = 0.0


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
    """All below the horizon."""
    rows = slice(int(np.argmax(canvas.climbs < -0.002)), len(canvas.climbs))
    far = canvas.eye_m / -canvas.climbs[rows][:, None]
    x, y = far * canvas.ways[0], far * canvas.ways[1]
    # Far away grain is finer than a pixel.
    near = np.exp(-far / 45.0)
    fine, broad = looked_up(grain, x * 12, y * 12), looked_up(grain, x * 0.9, y * 0.9)
    rough = (0.8 * fine * near + 0.6 * broad * np.exp(-far / 150.0)).astype(np.float32)
    colours = base.colour * (1 + base.rough * rough)[..., None]
    # Far away lie fields and woods.
    fields = looked_up(grain, x / 60, y / 60)
    fields = soft(90, 260, far) * np.clip(0.35 * fields, -0.55, 0.5)
    colours = colours * (1 + fields[..., None] * np.array((1.1, 0.8, 0.7), dtype=np.float32))
    sky = np.zeros_like(rough)
    for patch in patches:
        bent = patch.bend_m * np.sin(x / 9.0) if patch.bend_m else 0.0
        inside = (x > patch.low[0]) & (x < patch.high[0])
        inside &= (y > patch.low[1] + bent) & (y < patch.high[1] + bent)
        tone = 1 + patch.rough * rough
        if patch.slabs_m:
            joint = (x % patch.slabs_m < 0.03) | (y % patch.slabs_m < 0.03)
            tone = np.where(joint, np.float32(0.8), np.float32(1)) * tone
        colours = np.where(inside[..., None], patch.colour * tone[..., None], colours)
        sky = np.where(inside, np.float32(patch.shine), sky)
    sun = 1 - _shadows(x, y, far, light, blocks, trees)
    up = light.sky + light.sun * (max(0.05, float(light.towards[2])) * sun[..., None])
    colours = colours * up
    if light.lamps:
        pools = np.zeros_like(rough)
        for lamp in lamps:
            pools += 1 / (1 + ((x - lamp[0]) ** 2 + (y - lamp[1]) ** 2) / 9.0) ** 2
        warm = np.array((0.5, 0.33, 0.15), dtype=np.float32) * light.lamps
        colours = colours + base_light(colours, up) * pools[..., None] * warm
    if sky.any():
        waves = 1 + 0.12 * looked_up(grain, x * 0.7 / (1 + far / 60), y * 2.2 / (1 + far / 60))
        # The flatter water is seen, the more it mirrors.
        share = sky * np.clip(0.25 + 0.75 * np.exp(canvas.climbs[rows][:, None] * 6), 0, 1)
        colours += (canvas.haze * waves[..., None] - colours) * share[..., None]
    everywhere = np.arange(canvas.ways.shape[1])
    canvas.put(rows, everywhere, far, colours, np.ones_like(rough))


def base_light(colours: Floats, light: Floats) -> Floats:
    """What colour the ground itself has under colours that a light shows."""
    return np.asarray(colours / np.maximum(light, 1e-4), dtype=np.float32)


def _shadows(
    x: Floats,
    y: Floats,
    far: Floats,
    light: Light,
    blocks: Sequence[Block],
    trees: Sequence[Tree],
) -> Floats:
    """How much of the sun is kept from places of the ground: coarse, then drawn out."""
    out = np.zeros(x.shape, dtype=np.float32)
    if not light.sun.any():
        return out
    some = (slice(None, None, _COARSE), slice(None, None, _COARSE))
    px, py = x[some], y[some]
    shade = np.zeros(px.shape, dtype=np.float32)
    level = float(np.hypot(*light.towards[:2]))
    way = light.towards[:2] / max(level, 1e-3)
    climb = float(light.towards[2]) / max(level, 1e-3)
    for block in blocks:
        if block.away_m > _SHADOWS_M:
            continue
        enter = np.full(px.shape, -np.inf, dtype=np.float32)
        leave = np.full(px.shape, np.inf, dtype=np.float32)
        for k, at in ((0, px), (1, py)):
            step = float(way[k]) if abs(float(way[k])) > 1e-3 else 1e-3
            a, b = (block.low[k] - at) / step, (block.high[k] - at) / step
            enter, leave = np.maximum(enter, np.minimum(a, b)), np.minimum(leave, np.maximum(a, b))
        # Under its ridge, too: a pitched roof is taken for one half as high.
        high = block.wall_m + (block.high_m - block.wall_m) / 2
        hit = (enter < leave) & (leave > 0)
        shade = np.maximum(shade, hit * soft(1.15, 0.9, np.maximum(enter, 0) * climb / high))
    for tree in trees:
        if tree.away_m < _SHADOWS_M:
            shade = np.maximum(shade, shadow_of(tree, light, px, py))
    return np.asarray(_drawn_out(shade, x.shape) * np.exp(-far / _SHADOWS_M), dtype=np.float32)


def _drawn_out(coarse: Floats, shape: tuple[int, ...]) -> Floats:
    """A field of some rows and all columns round, between its values."""
    rows = np.minimum(np.arange(shape[0]) / _COARSE, coarse.shape[0] - 1.001)
    first = rows.astype(int)
    part = (rows - first)[:, None].astype(np.float32)
    tall = coarse[first] * (1 - part) + coarse[np.minimum(first + 1, len(coarse) - 1)] * part
    columns = np.arange(shape[1]) / _COARSE
    left = columns.astype(int)
    part = (columns - left)[None, :].astype(np.float32)
    right = (left + 1) % coarse.shape[1]
    return np.asarray(tall[:, left] * (1 - part) + tall[:, right] * part, dtype=np.float32)
