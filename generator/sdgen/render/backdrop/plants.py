"""Trees: a few crowns are drawn, and stand turned to the eye, lit from where the sun is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Vec2
from sdgen.render.backdrop.canvas import COLUMNS, Canvas, Floats, linear, noise, places_of, soft
from sdgen.render.backdrop.light import Light
from sdgen.vocabulary import Season

#: A crown is drawn so many pixels high: as many as the nearest of them takes of the picture.
SIZE = 256
#: Twigs of a bare crown.
_TWIGS = 620
_BARK = linear(88, 74, 62)

#: Colours of leaves, and of grass, by season; how many of the broad-leaved trees are bare.
_LEAVES: dict[Season, tuple[Floats, ...]] = {
    "spring": (linear(128, 156, 74), linear(106, 142, 70), linear(150, 168, 88)),
    "summer": (linear(78, 112, 54), linear(94, 122, 62), linear(66, 100, 58)),
    "autumn": (
        linear(176, 118, 50),
        linear(188, 146, 62),
        linear(140, 82, 46),
        linear(118, 120, 60),
    ),
    "winter": (linear(84, 96, 70), linear(74, 92, 72)),
}
_BLOSSOM = (linear(232, 206, 214), linear(238, 232, 226))
_NEEDLES = (linear(54, 78, 56), linear(62, 84, 66))
_BARE: dict[Season, float] = {"spring": 0.1, "summer": 0.0, "autumn": 0.15, "winter": 0.85}


class Crown(NamedTuple):
    """A tree's looks from the side, (SIZE, SIZE), top first: where it is, its colours, and which
    way it faces: to the side and up."""

    there: npt.NDArray[np.bool_]
    colours: Floats
    aside: Floats
    up: Floats
    #: Its width as a share of its height.
    wide: float


class _Waves(NamedTuple):
    """What makes crowns uneven: leaf by leaf and bough by bough, (SIZE, SIZE)."""

    fine: Floats
    broad: Floats


class Tree(NamedTuple):
    """Where a tree stands and how high it is."""

    at: tuple[float, float]
    high_m: float
    crown: Crown

    @property
    def away_m(self) -> float:
        """How far it is."""
        return float(np.hypot(*self.at))


def crowns(season: Season, snow: bool, rng: np.random.Generator) -> list[Crown]:
    """The kinds of trees of one world: the last two are bushes and firs."""
    out = []
    waves = _Waves(noise(rng, SIZE, 0.75, 16), noise(rng, SIZE, 1.0, 4))
    for _ in range(4):
        if rng.random() < _BARE[season]:
            out.append(_bare(rng))
            continue
        leaves = _LEAVES[season][int(rng.integers(len(_LEAVES[season])))]
        if season == "spring" and rng.random() < 0.25:
            leaves = _BLOSSOM[int(rng.integers(2))]
        out.append(_leafy(leaves, float(rng.uniform(0.62, 1.0)), 0.3, rng, waves))
    leaves = _LEAVES[season][int(rng.integers(len(_LEAVES[season])))]
    out.append(_leafy(leaves, 1.25, 0.0, rng, waves))
    out.append(_fir(_NEEDLES[int(rng.integers(2))], snow, waves))
    return out


def _grid() -> tuple[Floats, Floats]:
    """Across from -1 to 1, and up from 0 to 1."""
    line = (np.arange(SIZE, dtype=np.float32) + 0.5) / SIZE
    across, up = (2 * line - 1)[None, :], (1 - line)[:, None]
    return across.astype(np.float32), up.astype(np.float32)


def _leafy(
    leaves: Floats, wide: float, trunk: float, rng: np.random.Generator, waves: _Waves
) -> Crown:
    """A heap of clumps, with gaps between leaves at its edges."""
    x, z = _grid()
    shift = int(rng.integers(SIZE))
    fine, broad = (np.roll(field, shift, axis=(0, 1)) for field in waves)
    there = np.zeros((SIZE, SIZE), dtype=bool)
    aside, up, tone = (np.zeros((SIZE, SIZE), dtype=np.float32) for _ in range(3))
    depth = np.full((SIZE, SIZE), -1, dtype=np.float32)
    for _ in range(46):
        angle, out = rng.uniform(0, 2 * math.pi), math.sqrt(float(rng.random())) * 0.76
        middle_x = out * math.cos(angle) * 0.92
        middle_z = trunk + (1 - trunk) * (0.5 + 0.48 * out * math.sin(angle))
        r = float(rng.uniform(0.13, 0.3))
        # None is cut off at the edges of the drawing.
        middle_x = min(max(middle_x, 1.05 * r - 1), 1 - 1.05 * r)
        middle_z = min(middle_z, 1 - 0.68 * r)
        # No clump reaches farther than this.
        near = (
            slice(*_span(1 - middle_z, 0.62 * r * 1.5, 1.0)),
            slice(*_span(middle_x + 1, r * 1.5, 2.0)),
        )
        dx, dz = (x[:, near[1]] - middle_x) / r, (z[near[0]] - middle_z) / (r * 0.62)
        away = dx * dx + dz * dz + 0.26 * fine[near] + 0.2 * broad[near]
        bulge = np.sqrt(np.clip(1 - away, 0, 1)) * r + np.float32(rng.uniform(0, 0.25))
        front = (away < 1) & (bulge > depth[near])
        depth[near] = np.where(front, bulge, depth[near])
        there[near] |= front
        aside[near] = np.where(front, 0.6 * dx + 0.4 * x[:, near[1]], aside[near])
        lifted = 0.6 * dz + 0.9 * (z[near[0]] - trunk - (1 - trunk) / 2)
        up[near] = np.where(front, lifted, up[near])
        tone[near] = np.where(front, np.float32(rng.normal(0, 0.1)), tone[near])
    # Here and there one sees through.
    there &= broad * 0.7 + fine * 0.6 > -1.75
    rough = np.clip(1 + tone + 0.3 * fine, 0.3, 1.9)
    # The inside of a crown is dark.
    rough *= 0.7 + 0.3 * soft(-0.6, 0.5, up)
    colours = leaves * rough[..., None]
    stem = (np.abs(x) < 0.045 * (1.4 - z)) & (z < trunk + 0.25) & ~there & (trunk > 0)
    bark = _BARK * (1 + 0.15 * fine + 0.25 * x / 0.06)[..., None]
    colours = np.where(stem[..., None], bark, colours)
    there |= stem
    aside, up = np.clip(aside + 0.2 * fine, -1, 1), np.clip(up + 0.2 * fine, -1, 1)
    return Crown(there, colours.astype(np.float32), aside, up, wide)


def _span(middle: float, reach: float, whole: float) -> tuple[int, int]:
    """First and last of the cells about a place, counted along a side so long."""
    low, high = (middle + sign * reach for sign in (-1, 1))
    return max(0, int(low / whole * SIZE)), min(SIZE, max(0, int(high / whole * SIZE) + 1))


def _fir(needles: Floats, snow: bool, waves: _Waves) -> Crown:
    x, z = _grid()
    fine = waves.fine
    tier = (z * 11 + 0.12 * fine + 0.5 * np.abs(x)) % 1.0
    edge = (1 - z) * (0.74 + 0.32 * (1 - tier)) + 0.05 * fine
    there = (np.abs(x) < edge) & (z > 0.07)
    stem = (np.abs(x) < 0.05) & (z <= 0.07)
    rough = np.clip(0.6 + 0.55 * tier + 0.25 * fine, 0.25, 1.7)
    colours = needles * rough[..., None]
    if snow:
        white = soft(0.1, 0.8, tier + 0.2 * fine)[..., None] * 0.7
        colours = colours * (1 - white) + np.float32(0.75) * white
    colours = np.where(stem[..., None], _BARK, colours).astype(np.float32)
    aside = np.clip(x / np.maximum(edge, 0.05), -1, 1).astype(np.float32)
    return Crown(there | stem, colours, aside, np.full_like(aside, 0.25), 0.42)


def _bare(rng: np.random.Generator) -> Crown:
    """A trunk that branches, and a haze of twigs."""
    there = np.zeros((SIZE, SIZE), dtype=bool)
    tips = [(0.0, 0.0, math.pi / 2, 0.3, 0.05)]
    for _ in range(7):
        grown = []
        for x, z, way, length, thick in tips:
            steps = np.linspace(0, 1, max(3, int(length * SIZE * 1.2)))
            px, pz = x + steps * length * math.cos(way), z + steps * length * math.sin(way)
            half = max(0, round(thick * SIZE / 2 - 0.5))
            column = ((px + 0.62) / 1.24 * SIZE).astype(int)
            row = ((1 - pz) * SIZE).astype(int)
            for off in range(-half, half + 1):
                inside = (column + off >= 0) & (column + off < SIZE) & (row >= 0) & (row < SIZE)
                there[row[inside], column[inside] + off] = True
            for _ in range(2 if thick > 0.04 else int(rng.integers(2, 4))):
                bend = way + float(rng.normal(0, 0.48)) + 0.1 * (math.pi / 2 - way)
                short = length * float(rng.uniform(0.62, 0.82))
                grown.append((float(px[-1]), float(pz[-1]), bend, short, thick * 0.62))
        tips = grown[:130]
    _add_twigs(there, rng)
    x_, _ = _grid()
    colours = np.broadcast_to(_BARK * np.float32(1.05), (SIZE, SIZE, 3))
    aside = np.broadcast_to(x_ * 0.5, (SIZE, SIZE)).astype(np.float32)
    return Crown(there, colours, aside, np.full_like(aside, 0.1), 0.85)


def _add_twigs(there: npt.NDArray[np.bool_], rng: np.random.Generator) -> None:
    """Fine ones all over a bare crown, each pointing away from the trunk's upper end."""
    angle, out = rng.uniform(0, 2 * math.pi, _TWIGS), np.sqrt(rng.random(_TWIGS))
    x, z = 0.86 * out * np.cos(angle), 0.66 + 0.32 * out * np.sin(angle)
    way = np.arctan2(z - 0.36, x * 0.8) + rng.normal(0, 0.45, _TWIGS)
    steps = np.arange(14)[:, None] / SIZE
    column = ((x + 2 * steps * np.cos(way) + 1) / 2 * SIZE).astype(int)
    row = ((1 - z - steps * np.sin(way)) * SIZE).astype(int)
    inside = (column >= 0) & (column < SIZE) & (row >= 0) & (row < SIZE)
    there[row[inside], column[inside]] = True


def paint_tree(canvas: Canvas, light: Light, tree: Tree, lamps: Sequence[Vec2] = ()) -> None:
    """Put it into the picture, lit by street lamps near it, too."""
    away = tree.away_m
    azimuth = math.atan2(tree.at[1], tree.at[0])
    half = tree.high_m * tree.crown.wide / 2
    middle = azimuth / (2 * math.pi) * COLUMNS - 0.5
    across = math.ceil(math.atan(half / away) / (2 * math.pi) * COLUMNS)
    columns = np.arange(round(middle) - across, round(middle) + across + 1)
    aside = np.tan((columns - middle) / COLUMNS * 2 * math.pi) * away / half
    columns, aside = columns[np.abs(aside) < 1] % COLUMNS, aside[np.abs(aside) < 1]
    rows = canvas.rows(-canvas.eye_m / away, (tree.high_m - canvas.eye_m) / away)
    up = (canvas.eye_m + away * canvas.climbs[rows]) / tree.high_m
    if len(columns) < 2 or len(up) == 0:
        return
    free = canvas.before(rows, columns) > away
    if not free.any():
        return
    crown = tree.crown
    down = np.clip(((1 - up) * SIZE).astype(int), 0, SIZE - 1)
    over = np.clip(((aside + 1) / 2 * SIZE).astype(int), 0, SIZE - 1)
    r, c = np.nonzero(free & crown.there[np.ix_(down, over)])
    at = down[r], over[c]
    # Columns go on against the clock, seen from above: to the left.
    left = (-math.sin(azimuth), math.cos(azimuth))
    out = (-math.cos(azimuth), -math.sin(azimuth))
    x, z = crown.aside[at], crown.up[at]
    y = np.sqrt(np.clip(1 - x * x - z * z, 0, 1))
    sun = light.towards
    facing = x * (left[0] * sun[0] + left[1] * sun[1]) + z * sun[2]
    facing = facing + y * (out[0] * sun[0] + out[1] * sun[1])
    # Some light comes through leaves.
    shone = np.clip(0.8 * facing + 0.22, 0.06, 1)[:, None] * light.sun
    lit = shone + light.sky * (0.62 + 0.3 * z)[:, None]
    if light.lamps:
        near = sum(1 / (1 + ((p - tree.at[0]) ** 2 + (q - tree.at[1]) ** 2) / 16) for p, q in lamps)
        lit += near * np.array((0.22, 0.15, 0.07), dtype=np.float32) * light.lamps
    colours = np.asarray(crown.colours[at] * lit, dtype=np.float32)
    canvas.fill(places_of(r + rows.start, columns[c]), away, colours)


def leaves_of(season: Season, rng: np.random.Generator) -> Floats:
    """The colour of a hedge."""
    kinds = _LEAVES["summer"] if season != "spring" else _LEAVES["spring"]
    shade = {"winter": 0.7, "autumn": 0.85}.get(season, 0.9)
    return np.asarray(kinds[int(rng.integers(len(kinds)))] * np.float32(shade))


def shadow_of(tree: Tree, light: Light, x: Floats, y: Floats) -> Floats:
    """How much of the sun a tree takes from places on the ground."""
    climb = max(0.12, float(light.towards[2]))
    level = light.towards[:2] / max(1e-3, float(np.hypot(*light.towards[:2])))
    away = 0.6 * tree.high_m * math.sqrt(1 - min(1.0, climb) ** 2) / climb
    dx, dy = x - tree.at[0] + level[0] * away, y - tree.at[1] + level[1] * away
    wide = tree.high_m * tree.crown.wide / 2
    far = (dx * level[0] + dy * level[1]) * min(1.0, climb * 1.3)
    side = dy * level[0] - dx * level[1]
    shade = soft(1.1, 0.6, np.hypot(far, side) / wide)
    return np.asarray(shade * np.float32(tree.crown.there.mean() * 1.4).clip(0, 0.85))


def grass_of(season: Season) -> Floats:
    """The colour of a lawn."""
    return {
        "spring": linear(108, 132, 72),
        "summer": linear(102, 120, 68),
        "autumn": linear(118, 122, 68),
        "winter": linear(124, 124, 88),
    }[season]
