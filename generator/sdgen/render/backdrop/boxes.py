"""Houses, hedges, fences, sheds and cars: blocks with a flat or pitched top, found by rays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Vec2
from sdgen.render.backdrop.canvas import PIXEL, Canvas, Floats, Ints, places_of
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.roofs import roof_colours
from sdgen.render.backdrop.solids import Block, Wall

Mask = npt.NDArray[np.bool_]


_FACINGS = ((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0))


class _Rays(NamedTuple):
    """Columns whose rays meet a block, their level directions (2, C), where they enter and leave
    it, metres, and where they do so through a side across x."""

    columns: Ints
    ways: Floats
    first: Floats
    last: Floats
    by_x: Mask


def _rays(canvas: Canvas, block: Block) -> _Rays | None:
    ends = [
        np.stack([block.low[k] / canvas.ways[k], block.high[k] / canvas.ways[k]]) for k in (0, 1)
    ]
    enter, leave = [end.min(axis=0) for end in ends], [end.max(axis=0) for end in ends]
    first, last = np.maximum(*enter), np.minimum(*leave)
    columns = np.nonzero((first < last) & (first > 0.5))[0]
    if len(columns) == 0:
        return None
    by_x = enter[0][columns] > enter[1][columns]
    return _Rays(columns, canvas.ways[:, columns], first[columns], last[columns], by_x)


def paint_block(
    canvas: Canvas, light: Light, block: Block, grain: Floats, lamps: Sequence[Vec2] = ()
) -> None:
    """Put it into the picture. ``grain``: noise, one cell for some centimetres."""
    rays = _rays(canvas, block)
    if rays is None:
        return
    near, far = float(rays.first.min()), float(rays.first.max())
    beyond = float(rays.last.max()) if block.slope else far
    over, under = block.high_m - canvas.eye_m, block.foot_m - canvas.eye_m
    rows = canvas.rows(
        under / (near if under < 0 else far) - 1e-4,
        over / (near if over > 0 else beyond) + 1e-4,
    )
    if rows.stop <= rows.start:
        return
    free = canvas.before(rows, rays.columns) > rays.first
    # Rows of which nothing is seen at their top and bottom are left.
    some = np.nonzero(free.any(axis=1))[0]
    if len(some) == 0:
        return
    rows, free = (
        slice(rows.start + int(some[0]), rows.start + int(some[-1]) + 1),
        free[some[0] : some[-1] + 1],
    )
    climbs = canvas.climbs[rows][:, None]
    up = canvas.eye_m + rays.first * climbs
    k = 1 - block.ridge
    half = (block.high[k] - block.low[k]) / 2
    middle = (block.low[k] + block.high[k]) / 2

    def top(far: Floats) -> Floats:
        rise = half - np.abs(far * rays.ways[k] - middle)
        return np.asarray(block.wall_m + block.slope * np.maximum(rise, 0), dtype=np.float32)

    eaves = top(rays.first)
    above = up > eaves
    above &= free
    walls = free & ~above
    walls &= up >= block.foot_m
    _paint_walls(canvas, light, block, rays, rows, (walls, up), grain, lamps)
    if (block.slope or canvas.eye_m > block.wall_m) and above.any():
        # The top over the way of each ray: up to the ridge, then down.
        turn = np.clip(middle / rays.ways[k], rays.first, rays.last)
        r, c = np.nonzero(above)
        stops = np.stack([rays.first, turn, rays.last])
        heights = np.stack([eaves, top(turn), top(rays.last)])
        _paint_top(canvas, light, block, rays, rows, (r, c), stops, heights, grain)


def _paint_walls(
    canvas: Canvas,
    light: Light,
    block: Block,
    rays: _Rays,
    rows: slice,
    seen: tuple[Mask, Floats],
    grain: Floats,
    lamps: Sequence[Vec2],
) -> None:
    r, c = np.nonzero(seen[0])
    if len(r) == 0:
        return
    first, ways, by_x = rays.first, rays.ways, rays.by_x
    along = np.where(by_x, first * ways[1] - block.low[1], first * ways[0] - block.low[0])
    facing = np.where(by_x, np.where(ways[0] > 0, 1, 0), np.where(ways[1] > 0, 3, 2))
    long = np.where(by_x, block.high[1] - block.low[1], block.high[0] - block.low[0])
    far, up = first[c], seen[1][r, c]
    wall = Wall(along[c], up, facing[c], long.astype(np.float32)[c], far * np.float32(PIXEL))
    lights = np.stack([light.on(way) for way in _FACINGS])[wall.facing]
    if light.lamps and block.wall_m > 1.0 and block.away_m < 90.0:
        thrown = _lamplight(first * ways, facing, lamps)[c]
        thrown *= 1 / (1 + (np.maximum(up - 3.0, 0) / 4.0) ** 2)
        warm = np.array((0.5, 0.33, 0.15), dtype=np.float32) * np.float32(light.lamps)
        lights += thrown[:, None] * warm
    colours = block.painter(wall, lights, light, grain, block.seed)
    canvas.fill(places_of(r + rows.start, rays.columns[c]), far, colours)


def _paint_top(
    canvas: Canvas,
    light: Light,
    block: Block,
    rays: _Rays,
    rows: slice,
    seen: tuple[Ints, Ints],
    stops: Floats,
    heights: Floats,
    grain: Floats,
) -> None:
    """``stops``, ``heights``: where rays enter, turn at the ridge and leave, and the top there."""
    r, c = seen
    climbs = canvas.climbs[rows][r]
    enter, turn, leave = stops[0][c], stops[1][c], stops[2][c]
    gap_enter, gap_turn, gap_leave = (
        canvas.eye_m + stop * climbs - high[c]
        for stop, high in zip((enter, turn, leave), heights, strict=True)
    )
    front = gap_turn <= 0
    start, stop = np.where(front, enter, turn), np.where(front, turn, leave)
    gap_start = np.where(front, gap_enter, gap_turn)
    gap_stop = np.where(front, gap_turn, gap_leave)
    met = np.nonzero(gap_stop <= 0)[0]
    if len(met) == 0:
        return
    part = gap_start[met] / np.maximum(gap_start[met] - gap_stop[met], 1e-9)
    far = start[met] + (stop[met] - start[met]) * part
    r, c = r[met], c[met]
    k = 1 - block.ridge
    across = far * rays.ways[k][c] - np.float32((block.low[k] + block.high[k]) / 2)
    along = far * rays.ways[1 - k][c] - np.float32(block.low[1 - k])
    colours = roof_colours(block, light, along, across, far * np.float32(PIXEL), grain)
    canvas.fill(places_of(r + rows.start, rays.columns[c]), far, colours)


def _lamplight(at_m: Floats, facing: Ints, lamps: Sequence[Vec2]) -> Floats:
    """How much street lamps throw on walls at places (2, C), (C,)."""
    out = np.array(_FACINGS, dtype=np.float32)[facing, :2].T
    total = np.zeros(at_m.shape[1], dtype=np.float32)
    for lamp in lamps:
        way = np.array(lamp, dtype=np.float32)[:, None] - at_m
        away = np.hypot(*way)
        total += np.maximum((way * out).sum(axis=0), 0) / (away + 1) / (1 + (away / 6) ** 2)
    return total
