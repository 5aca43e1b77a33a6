"""Candles of feasts: Advent wreaths and birthday cakes; the `lit` variant adds their flames."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, box_piece, cylinder_piece, ring_pieces
from toolkit.sampling import noise_offset
from toolkit.shapes import box, ellipsoid, lathe, loft, tube

from makers.candle_kinds import alight, burning, lit_end, placed, waxen, wick
from makers.candles import small_flame


def seeded(rng: np.random.Generator) -> dict:
    return {"seed": 1}


def needles(o, tone: str) -> Material:
    """Fir: light and dark needles in all directions, nearly black between them."""
    m = Material(occlusion=0.8)
    c = m.mix(m.remap(m.noise(70, 3, 0.7, 2.0, o), 0.4, 0.56), shade(tone, 0.3), tone)
    fine = m.noise(150, 2, 0.6, 4.0, (o[1], o[2], o[0]))
    return m.colour(m.mix(m.remap(fine, 0.53, 0.6, 0, 0.85), c, shade(tone, 1.9)))


def advent_wreath(wax="#a8262c", trim="#c8302c", tone="#2f5a34", seed=0) -> Model:
    """A ring of fir with four thick candles, ribbons and baubles."""
    rng = np.random.default_rng(seed)
    o, big, thick, n, m = noise_offset(rng), 0.105, 0.036, 18, 6
    fir = needles(o, tone)
    bumps = 1 + rng.uniform(-0.12, 0.12, (n, m)) + 0.16 * (-1.0) ** np.add.outer(range(n), range(m))
    rings = []
    for i in range(n):
        a, ring = math.tau * i / n, []
        for j in range(m):
            b = math.tau * j / m - 0.5 * math.pi
            q = thick * bumps[i, j] * (1.0 if j else 0.9)
            away = big + q * math.cos(b)
            z = max(0.0, thick * 0.82 + q * 0.86 * math.sin(b))
            ring.append((away * math.cos(a), away * math.sin(a), z))
        rings.append(ring)
    wreath = loft([*rings, rings[0]], mat=fir, caps=(False, False)).outward()
    body, fire, glow = [wreath], [], []
    pieces = ring_pieces(
        [(big + thick, 0), (big + thick, 0.06)], [(big - thick, 0), (big - thick, 0.06)], 8
    )
    candle, bow = waxen(wax, o), plain(trim, 0.08)
    foot, top = 0.05, 0.128
    for k in range(4):
        a = math.tau * (k + 0.5) / 4
        x, y = big * math.cos(a), big * math.sin(a)
        profile = [(0.0235, foot), (0.0235, top), (0.012, top - 0.002), (0, top - 0.002)]
        body += placed([lathe(profile, 7, mat=candle), wick(top - 0.002)], x, y)
        flame, pool = burning(top - 0.0005, wax, 0.014, 0.046, 5)
        fire += placed([flame], x, y)
        glow += placed([pool], x, y)
        pieces.append(cylinder_piece(0.0235, foot, top, 8) + np.array([x, y, 0]))
        b = a + math.pi / 4
        for turn, far, size in ((-0.12, 0.94, 0.016), (0.17, 1.12, 0.013)):
            at = (big * far * math.cos(b + turn), big * far * math.sin(b + turn), 0.06)
            body.append(ellipsoid(size, at, 5, 4, bow))
    return alight("Advent wreath with four candles", body, fire, glow, pieces, 0.7)


# ---- cakes
def icing(tone: str, o) -> Material:
    m = Material(occlusion=0.8)
    return m.colour(m.mottle(tone, 0.05, 40, o))


def side_picture(tone: str, dots: tuple[str, ...]):
    """Sprinkles all round."""
    image, d = labels.canvas(512, 96, tone)
    rng = np.random.default_rng(3)
    for k in range(110):
        x, y = rng.uniform(0, 512), rng.uniform(4, 92)
        d.ellipse((x - 5, y - 4, x + 5, y + 4), fill=dots[k % len(dots)])
    return image


def top_picture(tone: str, ink: str):
    image, d = labels.canvas(256, 256, tone)
    labels.text(d, "HAPPY", (62, 84, 194, 122), "bold", ink)
    labels.text(d, "BIRTHDAY", (50, 130, 206, 164), "bold", ink)
    return image


def drum(r: float, h: float, z: float, tone: str, ink: str, dots, n: int = 24) -> list[Mesh]:
    """A round cake with sprinkles on its side and lettering on top."""
    side = label(side_picture(tone, dots), tone, 0.8)
    wall = lathe([(0, z), (r, z), (r, z + h)], n, mats=[side], label_z=(z, z + h))
    top = label(top_picture(tone, ink), tone, 0.8)
    lid = lathe([(r, z + h), (r * 0.6, z + h + 0.001), (0, z + h + 0.001)], n, mat=top)
    lid.label_uv = [
        # upright for somebody at the front (+X)
        [(lid.v[i][1] / r / 2 + 0.5, 0.5 - lid.v[i][0] / r / 2) for i in face]
        for face in lid.f
    ]
    return [wall, lid]


def cream(count: int, away: float, z: float, tone: str, size=0.014) -> list[Mesh]:
    mat, out = plain(tone, 0.05), []
    for k in range(count):
        a = math.tau * (k + 0.5) / count
        blob = lathe([(size, 0.0), (size * 0.75, size * 0.6), (0, size * 1.2)], 5, mat=mat)
        out.append(blob.move(away * math.cos(a), away * math.sin(a), z - 0.0005))
    return out


def cake_plate(radius: float) -> Mesh:
    profile = [(0, 0), (radius * 0.6, 0), (radius, 0.009), (radius, 0.012), (radius * 0.6, 0.006)]
    return lathe([*profile, (0, 0.006)], 16, mat=plain("eef0f2", 0.03))


STICKS = ("3f8ad0", "e8503c", "f2c23a", "4fae5a", "c860b8")


def birthday_cake(
    form="round",
    tone="#f6b4c4",
    ink="#b01c50",
    trim="#fdf8f0",
    dots=("#ffffff", "#f2d23a", "#6fb8e8"),
    candles=5,
    seed=0,
) -> Model:
    """A cake with candles stuck in it: "round", "tiers" (two) or "sheet" (oblong)."""
    o = noise_offset(np.random.default_rng(seed))
    r, h = 0.11, 0.075
    if form == "sheet":
        half = (0.085, 0.125)
        board = box(0.21, 0.29, 0.006, mat=plain("d8dadd", 0.04))
        picture = label(top_picture(tone, ink), tone, 0.8)
        block = box(2 * half[0], 2 * half[1], h, (0, 0, 0.006), icing(tone, o), 0.004)
        sheet = box(
            2 * half[0] - 0.012,
            2 * half[1] - 0.012,
            0.001,
            (0, 0, h + 0.0058),
            icing(tone, o),
            labels={"+z": picture},
        )
        body, top = [board, block, sheet], h + 0.0065
        for s in (-1, 1):
            for k in range(4):
                y = (k - 1.5) * 0.07
                body += [m.move(s * 0.077, y) for m in cream(1, 0.0, top, trim, 0.013)]
        ys = np.linspace(-0.09, 0.09, candles)
        spots = [(-0.05, float(y)) for y in ys]
        pieces = [box_piece((0, 0, (h + 0.006) / 2), (2 * half[0], 2 * half[1], h + 0.006))]
    else:
        body = [cake_plate(r * 1.2), *drum(r, h, 0.006, tone, ink, dots)]
        top, away = h + 0.006, r * 0.62
        body += cream(9, r * 0.87, top, trim)
        pieces = [cylinder_piece(r, 0, top, 14), cylinder_piece(r * 1.19, 0.004, 0.012, 14)]
        if form == "tiers":
            body += drum(r * 0.62, 0.06, top, trim, ink, dots, 18)
            pieces.append(cylinder_piece(r * 0.62, top, top + 0.06, 12))
            top, away = top + 0.06, r * 0.4
        angles = [math.tau * (k + 0.5) / candles for k in range(candles)]
        spots = [(away * math.cos(a), away * math.sin(a)) for a in angles]
        if form == "round":  # in a bow behind the lettering
            bow = np.linspace(0.62 * math.pi, 1.38 * math.pi, candles)
            spots = [(r * 0.68 * math.cos(a), r * 0.68 * math.sin(a)) for a in bow]
    fire, glow = [], []
    for k, (x, y) in enumerate(spots):
        colour = STICKS[k % len(STICKS)]
        end = top + 0.05
        stick = tube(
            [(x, y, top - 0.002), (x, y, end)], 0.0045, 4, mat=plain(colour, 0.03, occlusion=0.4)
        )
        body += [stick, *placed([wick(end, 0.006)], x, y)]
        fire += placed([small_flame(end + 0.002, 0.038, 5)], x, y)
        glow += placed([lit_end(0.0056, end + 0.0006, 0.008)], x, y)
        pieces.append(cylinder_piece(0.0045, top, end, 6) + np.array([x, y, 0]))
    title = {"round": "birthday cake", "tiers": "birthday cake of two tiers"}
    return alight(title.get(form, "oblong birthday cake"), body, fire, glow, pieces, 1.3)


MODELS = {
    "advent_wreath": Maker(
        advent_wreath,
        seeded,
        count=4,
        presets=[
            {"wax": "#a8262c", "trim": "#c8302c"},
            {"wax": "#f3ead6", "trim": "#c8a24a"},
            {"wax": "#5a3a7a", "trim": "#c8ccd2"},
            {"wax": "#d8b45a", "trim": "#8a2430", "tone": "#3f5a3a"},
        ],
    ),
    "birthday_cake": Maker(
        birthday_cake,
        seeded,
        count=5,
        presets=[
            {"form": "round"},
            {
                "form": "round",
                "tone": "#4a2814",
                "ink": "#f6e2b8",
                "dots": ("#e8503c", "#f2c23a", "#6fb8e8"),
            },
            {"form": "tiers", "tone": "#8cc4e8", "candles": 4, "ink": "#24508a"},
            {"form": "sheet", "tone": "#fbf6ea", "trim": "#f29ab0", "candles": 7},
            {
                "form": "round",
                "tone": "#fbf6ea",
                "ink": "#2f7f4a",
                "trim": "#a8d8a0",
                "dots": ("#e8503c", "#f2c23a", "#4fae5a"),
            },
        ],
    ),
}
