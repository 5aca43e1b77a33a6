"""Houses, hedges, fences, sheds and cars: blocks with a flat or pitched top, found by rays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Vec2
from sdgen.render.backdrop.canvas import Canvas, Floats, linear, looked_up, soft
from sdgen.render.backdrop.light import Light

Mask = npt.NDArray[np.bool_]


class Wall(NamedTuple):
    """What of a wall is seen: along it and up it, metres (R, C), which way its columns' faces look
    (C,), 0 to 3 for +x, -x, +y, -y, and how long these are."""

    along_m: Floats
    up_m: Floats
    facing: npt.NDArray[np.intp]
    long_m: Floats


#: From what is seen of a wall and the light on it (C, 3) to its colours (R, C, 3).
Painter = Callable[[Wall, Floats, Light, Floats, int], Floats]


class Block(NamedTuple):
    """A block on the ground from ``low`` to ``high`` (x, y), its walls so high. Its top is flat or
    rises by ``slope`` to a ridge along ``ridge`` (0: x, 1: y)."""

    low: tuple[float, float]
    high: tuple[float, float]
    wall_m: float
    painter: Painter
    top: Floats
    slope: float = 0.0
    ridge: int = 0
    foot_m: float = 0.0
    seed: int = 0

    @property
    def away_m(self) -> float:
        """How far its nearest point is."""
        x, y = (max(self.low[k], -self.high[k], 0.0) for k in (0, 1))
        return float(np.hypot(x, y))

    @property
    def high_m(self) -> float:
        """Its highest point."""
        k = 1 - self.ridge
        return self.wall_m + self.slope * (self.high[k] - self.low[k]) / 2


_FACINGS = ((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0))


def paint_block(
    canvas: Canvas, light: Light, block: Block, grain: Floats, lamps: Sequence[Vec2] = ()
) -> None:
    """Put it into the picture. ``grain``: noise, one cell for some centimetres."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = [
            np.stack([block.low[k] / canvas.ways[k], block.high[k] / canvas.ways[k]])
            for k in (0, 1)
        ]
    enter = [np.nan_to_num(end.min(axis=0), nan=-np.inf) for end in ends]
    leave = [np.nan_to_num(end.max(axis=0), nan=np.inf) for end in ends]
    first, last = np.maximum(*enter), np.minimum(*leave)
    columns = np.nonzero((first < last) & (first > 0.5))[0]
    if len(columns) == 0:
        return
    ways = canvas.ways[:, columns]
    first, last = (a[columns].astype(np.float32) for a in (first, last))
    by_x = enter[0][columns] > enter[1][columns]
    # The top over the way of each ray: up to the ridge, then down.
    k = 1 - block.ridge
    middle, half = (block.low[k] + block.high[k]) / 2, (block.high[k] - block.low[k]) / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        turn = np.clip(np.nan_to_num(middle / ways[k], nan=0.0), first, last).astype(np.float32)

    def top(far: Floats) -> Floats:
        rise = half - np.abs(far * ways[k] - middle)
        return np.asarray(block.wall_m + block.slope * np.maximum(rise, 0), dtype=np.float32)

    heights = [top(far) for far in (first, turn, last)]
    over = block.high_m - canvas.eye_m
    under = block.foot_m - canvas.eye_m
    near, far = float(first.min()), float(last.max())
    rows = canvas.rows(
        under / (near if under < 0 else far) - 1e-4, over / (near if over > 0 else far) + 1e-4
    )
    climbs = canvas.climbs[rows][:, None]
    if len(climbs) == 0:
        return
    up = canvas.eye_m + first * climbs
    walls = (up <= heights[0]) & (up >= block.foot_m)
    gap_first = up - heights[0]
    gap_turn = canvas.eye_m + turn * climbs - heights[1]
    gap_last = canvas.eye_m + last * climbs - heights[2]
    with np.errstate(divide="ignore", invalid="ignore"):
        on_front = first + (turn - first) * gap_first / (gap_first - gap_turn)
        on_back = turn + (last - turn) * gap_turn / (gap_turn - gap_last)
    front = (gap_first > 0) & (gap_turn <= 0)
    back = (gap_first > 0) & (gap_turn > 0) & (gap_last <= 0)
    along = np.where(by_x, first * ways[1] - block.low[1], first * ways[0] - block.low[0])
    facing = np.where(by_x, np.where(ways[0] > 0, 1, 0), np.where(ways[1] > 0, 3, 2))
    long = np.where(by_x, block.high[1] - block.low[1], block.high[0] - block.low[0])
    lights = np.stack([light.on(way) for way in _FACINGS])[facing]
    wall = Wall(
        np.broadcast_to(along.astype(np.float32), up.shape), up, facing, long.astype(np.float32)
    )
    # Walls reach from row to row only: colours are asked for where they are.
    some = np.nonzero(walls.any(axis=1))[0]
    if light.lamps and block.wall_m > 1.0:
        lights = lights + _lamplight(first * ways, up, facing, lamps, light)
    colours = np.zeros((*up.shape, 3), dtype=np.float32)
    if len(some):
        part = slice(int(some[0]), int(some[-1]) + 1)
        cut = Wall(wall.along_m[part], wall.up_m[part], wall.facing, wall.long_m)
        colours[part] = block.painter(
            cut, lights if lights.ndim == 2 else lights[part], light, grain, block.seed
        )
    roof = front | back
    distance = np.where(front, on_front, np.where(back, on_back, first))
    if roof.any():
        tilt = 1 / float(np.hypot(1, block.slope))
        lean = [0.0, 0.0, tilt]
        lean[k] = block.slope * tilt
        sides = [light.on((sign * lean[0], sign * lean[1], tilt)) for sign in (1.0, -1.0)]
        across = distance * ways[k] - middle
        shade = np.where((across > 0)[..., None], sides[0], sides[1])
        rough = 1 + 0.07 * looked_up(grain, distance * ways[block.ridge] * 4, np.abs(across) * 9)
        colours = np.where(roof[..., None], block.top * rough[..., None] * shade, colours)
    canvas.put(rows, columns, distance, colours, (walls | roof).astype(np.float32))


def _lamplight(
    at_m: Floats, up_m: Floats, facing: npt.NDArray[np.intp], lamps: Sequence[Vec2], light: Light
) -> Floats:
    """What street lamps throw on walls at places (2, C), so high up, (R, C, 3)."""
    out = np.array(_FACINGS, dtype=np.float32)[facing, :2].T
    total = np.zeros(at_m.shape[1], dtype=np.float32)
    for lamp in lamps:
        way = np.array(lamp, dtype=np.float32)[:, None] - at_m
        away = np.hypot(*way)
        total += np.maximum((way * out).sum(axis=0), 0) / (away + 1) / (1 + (away / 6) ** 2)
    fade = 1 / (1 + (np.maximum(up_m - 3.0, 0) / 4.0) ** 2)
    warm = np.array((0.5, 0.33, 0.15), dtype=np.float32) * light.lamps
    return np.asarray((total * fade)[..., None] * warm, dtype=np.float32)


@dataclass(frozen=True, eq=False)
class Facade:
    """How a house looks: colours, the height of its floors, how far apart windows are, how wide and
    high, and whether it has balconies."""

    colour: Floats
    frame: Floats
    floor_m: float = 2.9
    bay_m: float = 3.0
    wide_m: float = 1.2
    high_m: float = 1.4
    balconies: bool = False
    rail: Floats = field(default_factory=lambda: linear(150, 155, 158))
    brick: bool = False
    #: How many floors: above them is the gable.
    floors: int = 2

    def __call__(
        self, wall: Wall, lights: Floats, light: Light, grain: Floats, seed: int
    ) -> Floats:
        """The colours of a wall."""
        table = np.random.default_rng(seed).random((4, 24, 64, 5)).astype(np.float32)
        bays = np.maximum(np.round(wall.long_m / self.bay_m), 1)
        bay_m = (wall.long_m / bays).astype(np.float32)
        bay = np.clip((wall.along_m / bay_m).astype(np.int32), 0, 63)
        aside = wall.along_m - (bay.astype(np.float32) + np.float32(0.5)) * bay_m
        floor = np.clip((wall.up_m / self.floor_m).astype(np.int32), 0, 23)
        up = wall.up_m - floor.astype(np.float32) * np.float32(self.floor_m)
        own = table[np.broadcast_to(wall.facing, bay.shape), floor, bay]
        sill = 0.9 if not self.balconies else 0.25
        high = self.high_m if not self.balconies else 2.0
        wide = self.wide_m * (0.9 + 0.25 * (table[0, 0, 0, 4] > 0.5))
        half = np.float32(wide / 2)
        x = np.asarray(np.abs(aside) / half, dtype=np.float32)
        z = np.asarray((up - sill) / np.float32(high), dtype=np.float32)
        there = (floor < self.floors) & (wall.long_m > 3.0)
        # Party walls of some houses have few windows.
        there &= ~((wall.facing < 2) & (own[..., 3] < 0.35))
        pane = there & (x < 1) & (z > 0) & (z < 1)
        border = 0.09
        framed = there & (np.abs(aside) < wide / 2 + border)
        framed &= (up > sill - border) & (up < sill + high + border)
        frames = framed & ~pane
        frames |= pane & (np.abs(aside) < 0.035)
        rough = 1 + 0.025 * looked_up(grain, wall.along_m * 5, wall.up_m * 5)
        if self.brick:
            rough = rough + 0.05 * looked_up(grain, wall.along_m * 4.5, wall.up_m * 14)
        # Plinths are darker, and what is under the eaves.
        rough = rough * np.where(wall.up_m < 0.5, np.float32(0.75), np.float32(1))
        rough = rough * (1 - 0.3 * soft(0.35, 0.0, self.floors * self.floor_m - wall.up_m))
        colours = self.colour * rough[..., None] * lights
        # Under a window it is a little darker, over it a lintel.
        colours = np.where(frames[..., None], self.frame * lights, colours)
        colours = np.where((pane & ~frames)[..., None], self._panes(x, z, own, light), colours)
        if self.balconies:
            colours = self._with_balconies(colours, aside, bay_m, up, floor, lights, own, light)
        return np.asarray(colours, dtype=np.float32)

    def _panes(self, x: Floats, z: Floats, own: Floats, light: Light) -> Floats:
        """By day they show the sky and curtains; in the dark, the light inside."""
        mirrored = light.sky * 0.45 * (0.25 + 0.75 * own[..., 4:5]) * (0.5 + 0.5 * z[..., None])
        drawn = (x > 0.45 + 0.5 * own[..., 2]) | (z > 1.35 - 0.9 * own[..., 3])
        dark = np.float32(0.03) + mirrored
        cloth = np.array((0.62, 0.6, 0.56), np.float32) * light.sky * 0.75
        day = np.where(drawn[..., None], cloth, dark)
        if light.lit == 0.0:
            return np.asarray(day)
        on = own[..., 0:1] < light.lit
        warm = np.array((1.0, 0.62, 0.27), np.float32)
        cool = np.array((0.75, 0.78, 0.8), np.float32)
        tone = np.where(own[..., 1:2] < 0.15, cool, warm)
        power = light.glow * (0.3 + 0.8 * own[..., 1:2] ** 1.5) * (0.65 + 0.45 * z[..., None])
        power = power * np.where(drawn[..., None], np.float32(0.55), np.float32(1.0))
        return np.where(on, tone * power + day, day)

    def _with_balconies(
        self,
        colours: Floats,
        aside: Floats,
        bay_m: Floats,
        up: Floats,
        floor: npt.NDArray[np.int32],
        lights: Floats,
        own: Floats,
        light: Light,
    ) -> Floats:
        reach = np.abs(aside) < bay_m / 2 - 0.25
        within = reach & (floor > 0) & (floor < self.floors) & (own[..., 3] > -1)
        # In the shade of the balcony above.
        deep = within & (up > 1.05) & (up < self.floor_m - 0.15)
        dim = np.where(deep & (light.lit == 0.0), np.float32(0.72), np.float32(1.0))
        colours = colours * dim[..., None]
        rail = within & (up < 1.05)
        slab = within & (up < 0.2)
        bars = self.rail * lights
        if float(self.rail.mean()) > 0.5:
            colours = np.where(rail[..., None], bars, colours)
        else:
            colours = np.where(rail[..., None], 0.6 * bars + 0.4 * colours, colours)
        return np.where(slab[..., None], 0.8 * self.colour * lights, colours)


@dataclass(frozen=True, eq=False)
class Plain:
    """One colour with a grain; ``slats_m``: boards so wide; ``leaves``: of a hedge."""

    colour: Floats
    slats_m: float = 0.0
    leaves: bool = False

    def __call__(
        self, wall: Wall, lights: Floats, light: Light, grain: Floats, seed: int
    ) -> Floats:
        """The colours of a wall."""
        if self.leaves:
            leaf = looked_up(grain, wall.along_m * 9, wall.up_m * 9 + seed % 97)
            clump = looked_up(grain, wall.along_m * 1.7 + seed % 89, wall.up_m * 1.7)
            rough = np.clip(0.85 + 0.22 * leaf + 0.15 * clump, 0.25, 1.7)
            rough = rough * (0.75 + 0.25 * soft(0.0, 0.8, wall.up_m))
        else:
            rough = 1 + 0.05 * looked_up(grain, wall.along_m * 6 + seed % 83, wall.up_m * 2)
        if self.slats_m:
            board = wall.along_m / self.slats_m
            tone = looked_up(grain, np.floor(board) * 7 + seed % 79, np.zeros_like(board))
            gap = np.abs(board - np.floor(board) - 0.5) > 0.44
            rough = rough * (1 + 0.08 * tone) * np.where(gap, np.float32(0.45), np.float32(1))
        return np.asarray(self.colour * rough[..., None] * lights, dtype=np.float32)


@dataclass(frozen=True, eq=False)
class Cabin:
    """The windows of a car between its posts."""

    colour: Floats

    def __call__(
        self, wall: Wall, lights: Floats, light: Light, grain: Floats, seed: int
    ) -> Floats:
        """The colours of a side."""
        share = wall.along_m / wall.long_m
        post = (np.abs(share - 0.5) < 0.04) | (np.abs(share - 0.5) > 0.46) | (wall.up_m > 1.36)
        glass = np.float32(0.025) + light.sky * 0.16
        return np.where(post[..., None], self.colour * lights, glass).astype(np.float32)
