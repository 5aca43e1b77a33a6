"""Walls of houses, gardens and cars: what a pixel of one shows."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sdgen.render.backdrop.canvas import Floats, Ints, between, linear, looked_up, soft
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.solids import Wall

#: Doors are so wide and high, metres.
_DOOR_M = (1.0, 2.1)
_DOORS = (linear(70, 88, 78), linear(112, 62, 50), linear(58, 66, 84), linear(126, 96, 66))


def _within(away: Floats, half: float | Floats, pixel_m: Floats) -> Floats:
    """How much of a pixel is nearer than ``half``, (N,)."""
    return np.asarray(np.clip((half - away) / pixel_m + 0.5, 0, 1), dtype=np.float32)


def _mix(under: Floats, over: Floats, share: Floats) -> Floats:
    return np.asarray(under + (over - under) * share[:, None], dtype=np.float32)


@dataclass(frozen=True, eq=False)
class Facade:
    """How a house looks: colours, the height of its floors, how far apart windows are, how wide and
    high, and whether it has balconies, shutters (of a colour) and shops below."""

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
    shutters: Floats | None = None
    shops: bool = False

    def __call__(
        self, wall: Wall, lights: Floats, light: Light, grain: Floats, seed: int
    ) -> Floats:
        """The colours of a wall."""
        table = np.random.default_rng(seed).random((4, 24, 64, 5)).astype(np.float32)
        bays = np.maximum(np.round(wall.long_m / np.float32(self.bay_m)), 1)
        bay_m = wall.long_m / bays
        bay = np.clip((wall.along_m / bay_m).astype(np.int32), 0, 63)
        aside = np.abs(wall.along_m - (bay + np.float32(0.5)) * bay_m)
        floor = np.clip((wall.up_m * np.float32(1 / self.floor_m)).astype(np.int32), 0, 23)
        up = wall.up_m - floor * np.float32(self.floor_m)
        colours = self._plaster(wall, grain) * lights
        # Party walls of some houses have few windows.
        own = table.reshape(-1, 5)[(wall.facing * 24 + floor) * 64 + bay]
        there = (floor < self.floors) & (wall.long_m > 3.0)
        there &= (wall.facing >= 2) | (own[:, 3] >= 0.25)
        door_bay = (table[wall.facing, 0, 63, 3] * bays).astype(np.int32)
        doors = (floor == 0) & (bay == door_bay) & (wall.long_m > 6.0)
        if self.balconies:
            doors &= wall.facing >= 2
        some = np.nonzero(there & ~doors)[0]
        if len(some):
            cut = wall.some(some)
            colours[some] = self._windows(
                colours[some],
                cut,
                aside[some],
                up[some],
                floor[some],
                own[some],
                lights[some],
                light,
                float(table[0, 0, 0, 4]),
            )
        some = np.nonzero(doors & (aside < 1.0) & (up < 2.6))[0]
        if len(some):
            paint = _DOORS[seed % len(_DOORS)]
            size = wall.pixel_m[some]
            colours[some] = _door(
                colours[some], aside[some], up[some], size, lights[some], light, paint
            )
        if self.balconies:
            self._add_balconies(colours, wall, aside, bay_m, up, floor, lights, light)
        return colours

    def _plaster(self, wall: Wall, grain: Floats) -> Floats:
        rough = 1 + 0.015 * looked_up(grain, wall.along_m * 21, wall.up_m * 21)
        rough += 0.025 * between(grain, wall.along_m * np.float32(0.9), wall.up_m * np.float32(0.3))
        if self.brick:
            # Courses of bricks where they are some pixels high.
            course = wall.up_m * np.float32(1 / 0.085)
            row = np.floor(course)
            brick = wall.along_m * np.float32(1 / 0.24) + 0.5 * (row % 2)
            deep = 0.1 * looked_up(grain, np.floor(brick) * 3, row * 5)
            joint = (course - row > 0.82) | (brick - np.floor(brick) > 0.93)
            deep += np.where(joint, np.float32(0.22), np.float32(-0.03))
            rough += np.clip(1.6 - wall.pixel_m * np.float32(30), 0.15, 1) * deep
        # Plinths are darker, and what is under the eaves, with its gutter.
        rough *= np.where(wall.up_m < 0.5, np.float32(0.75), np.float32(1))
        under = np.float32(self.floors * self.floor_m) - wall.up_m
        rough *= 1 - 0.3 * soft(0.3, 0.0, under) * (under > -0.18)
        return np.asarray(self.colour * rough[:, None], dtype=np.float32)

    def _windows(
        self,
        colours: Floats,
        wall: Wall,
        aside: Floats,
        up: Floats,
        floor: Ints,
        own: Floats,
        lights: Floats,
        light: Light,
        broad: float,
    ) -> Floats:
        """A wall's colours with windows: their frames, bars, sills and shutters."""
        pixel = wall.pixel_m
        sill, high = (0.25, 2.0) if self.balconies else (0.9, self.high_m)
        half: float | Floats = self.wide_m * (0.9 + 0.25 * (broad > 0.5)) / 2
        if self.shops:
            below = floor == 0
            half = np.where(below, np.float32(self.bay_m * 0.42), np.float32(half))
            sill_m = np.where(below, np.float32(0.45), np.float32(sill))
            high_m = np.where(below, np.float32(1.9), np.float32(high))
        else:
            half, sill_m, high_m = np.float32(half), np.float32(sill), np.float32(high)
        middle = np.abs(up - (sill_m + high_m / 2))
        framed = _within(aside, half + 0.08, pixel) * _within(middle, high_m / 2 + 0.08, pixel)
        pane = _within(aside, half - 0.02, pixel) * _within(middle, high_m / 2 - 0.02, pixel)
        # Bars: one upright, and one across some way up.
        bars = _within(aside, 0.035, np.maximum(pixel, 0.03)) * np.minimum(1, 0.07 / pixel)
        bars = np.maximum(bars, _within(np.abs(up - sill_m - 0.7 * high_m), 0.03, pixel))
        pane = pane * (1 - np.minimum(bars, np.minimum(1, 0.09 / pixel)))
        if self.shutters is not None:
            beside = np.abs(aside - half * 1.55 - 0.08)
            cloth = _within(beside, half * 0.45, pixel)
            cloth *= _within(middle, high_m / 2 + 0.04, pixel)
            slats = np.where((up * 14) % 1 > 0.6, np.float32(0.75), np.float32(1))
            slats = 1 - (1 - slats) * np.clip(1.5 - pixel * 25, 0, 1)
            colours = _mix(colours, self.shutters * lights * slats[:, None], cloth)
        ledge = _within(aside, half + 0.14, pixel) * _within(
            np.abs(up - sill_m + 0.12), 0.05, pixel
        )
        colours = _mix(colours, self.colour * np.float32(1.12) * lights, ledge)
        x = aside / half
        z = (up - sill_m) / high_m
        colours = _mix(colours, self.frame * lights, framed)
        return _mix(colours, _panes(x, z, own, pixel, light), pane)

    def _add_balconies(
        self,
        colours: Floats,
        wall: Wall,
        aside: Floats,
        bay_m: Floats,
        up: Floats,
        floor: Ints,
        lights: Floats,
        light: Light,
    ) -> None:
        reach = aside < bay_m / 2 - 0.25
        within = reach & (floor > 0) & (floor < self.floors)
        # In the shade of the balcony above.
        deep = within & (up > 1.05) & (up < self.floor_m - 0.15)
        if light.lit == 0.0:
            colours[deep] *= np.float32(0.72)
        rail = np.nonzero(within & (up < 1.05))[0]
        bars = self.rail * lights[rail]
        if float(self.rail.mean()) <= 0.5:
            # Posts one sees between, or glass where they are finer than a pixel.
            size = wall.pixel_m[rail]
            post = (wall.along_m[rail] % 0.12 < 0.04) | (up[rail] > 0.98)
            share = np.where(post, np.float32(1), np.float32(0.12))
            share += (0.45 - share) * np.clip(size * 22 - 0.6, 0, 1)
            bars = _mix(colours[rail], bars, share)
        else:
            bars *= np.where(up[rail, None] > 0.98, np.float32(0.8), np.float32(1))
        colours[rail] = bars
        slab = within & (up < 0.18)
        colours[slab] = self.colour * np.float32(0.8) * lights[slab]


def _door(
    colours: Floats,
    aside: Floats,
    up: Floats,
    pixel_m: Floats,
    lights: Floats,
    light: Light,
    paint: Floats,
) -> Floats:
    """A front door with a pane at its top and a step."""
    wide, high = _DOOR_M
    frame = _within(aside, wide / 2 + 0.1, pixel_m) * _within(up, high + 0.35, pixel_m)
    leaf = _within(aside, wide / 2, pixel_m) * _within(up, high, pixel_m)
    pane = _within(aside, wide / 2 - 0.02, pixel_m) * (up > high + 0.06) * (up < high + 0.3)
    pane = pane + _within(aside, 0.22, pixel_m) * (up > 1.35) * (up < 1.85)
    colours = _mix(colours, np.float32(0.8) * lights, frame)
    colours = _mix(colours, paint * lights, leaf)
    glow = np.array((1.0, 0.62, 0.27), np.float32) * light.glow * 0.8
    colours = _mix(colours, glow if light.lit else light.sky * 0.2, pane)
    return _mix(colours, np.float32(0.4) * lights, (up < 0.18) * _within(aside, 0.8, pixel_m))


def _panes(x: Floats, z: Floats, own: Floats, pixel_m: Floats, light: Light) -> Floats:
    """By day they show the sky and curtains; in the dark, the light inside."""
    mirrored = light.sky * ((0.12 + 0.36 * own[:, 4]) * (0.45 + 0.55 * z))[:, None]
    # In the depth of the wall, and what hangs inside.
    drawn = (x > 0.45 + 0.5 * own[:, 2]) | (z > 1.35 - 0.9 * own[:, 3])
    cloth = np.array((0.62, 0.6, 0.56), np.float32) * light.sky * np.float32(0.75)
    day = np.where(drawn[:, None], cloth, np.float32(0.02) + mirrored)
    day *= np.where(z > 0.93, np.float32(0.55), np.float32(1))[:, None]
    if light.lit == 0.0:
        return np.asarray(day, dtype=np.float32)
    on = np.nonzero(own[:, 0] < light.lit)[0]
    some = own[on]
    warm = np.array((1.0, 0.62, 0.27), np.float32)
    cool = np.array((0.75, 0.78, 0.8), np.float32)
    tone = np.where(some[:, 1:2] < 0.15, cool, warm)
    power = light.glow * (0.3 + 0.8 * some[:, 1] ** 1.5) * (0.65 + 0.45 * z[on])
    # A lamp hangs in the room; furniture stands dark below: seen from near by only.
    near = np.clip(1.4 - 12 * pixel_m[on], 0, 1)
    lamp = np.exp(-(((x[on] - 0.2) / 0.3) ** 2) - ((z[on] - 0.72) / 0.16) ** 2)
    power *= 1 + 0.9 * near * lamp * (some[:, 4] > 0.4)
    power *= 1 - 0.6 * near * ((z[on] < 0.3 * some[:, 4]) & (x[on] > some[:, 3] - 0.4))
    power *= np.where(drawn[on], np.float32(0.6), np.float32(1.0))
    day[on] += tone * power[:, None]
    return np.asarray(day, dtype=np.float32)


@dataclass(frozen=True, eq=False)
class Plain:
    """One colour, so ``rough``; ``slats_m``: boards so wide; ``leaves``: of a hedge."""

    colour: Floats
    slats_m: float = 0.0
    leaves: bool = False
    rough: float = 0.05

    def __call__(
        self, wall: Wall, lights: Floats, light: Light, grain: Floats, seed: int
    ) -> Floats:
        """The colours of a wall."""
        if self.leaves:
            # Askew, as no leaf lies along the rows of a picture.
            askew = np.float32(0.6)
            x, z = wall.along_m + askew * wall.up_m, wall.up_m - askew * wall.along_m
            leaf = 0.6 * looked_up(grain, x * 43, z * 43 + seed % 97)
            leaf += 0.7 * looked_up(grain, x * 23, z * 23)
            broad = np.float32(3.7)
            clump = between(grain, x * broad + np.float32(seed % 89), z * broad)
            rough = np.clip(0.85 + 0.28 * leaf + 0.16 * clump, 0.25, 1.8)
            rough *= 0.75 + 0.25 * soft(0.0, 0.8, wall.up_m)
        else:
            tone = looked_up(grain, wall.along_m * 6 + seed % 83, wall.up_m * 2)
            rough = 1 + np.float32(self.rough) * tone
        if self.slats_m:
            board = wall.along_m * np.float32(1 / self.slats_m)
            tone = looked_up(grain, np.floor(board) * 7 + seed % 79, np.zeros_like(board))
            gap = np.abs(board - np.floor(board) - 0.5) > 0.44
            clear = np.clip(1.5 - wall.pixel_m * np.float32(1.5 / self.slats_m), 0, 1)
            rough *= 1 + clear * np.where(gap, np.float32(-0.55), 0.1 * tone)
        return np.asarray(self.colour * rough[:, None] * lights, dtype=np.float32)


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
        return np.where(post[:, None], self.colour * lights, glass).astype(np.float32)
