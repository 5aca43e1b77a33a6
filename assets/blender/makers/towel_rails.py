"""Towel rails, ladders, rings and hooks (back at -X), with towels."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset
from toolkit.shapes import loft, tube

from .joinery import Assembly, finish, steel
from .soft_forms import bars, ring
from .wall_items import towel_rail, towel_rail_random

Offset = tuple[float, float, float]


def _terry(colour: str, offset: Offset, stripe_z: float) -> Material:
    band = Material()
    line = band.remap(
        band.math("ABSOLUTE", band.math("SUBTRACT", band.axis(2), stripe_z)), 0.012, 0.016, 1, 0
    )
    weave = band.mottle(colour, 0.08, 160, offset)
    return band.colour(band.mix(line, weave, blend(colour, "#ffffff", 0.6)))


def hung_towel(
    x: float, y: float, width: float, z: float, front: float, back: float, mat: Material
) -> Mesh:
    """A towel over a bar at (x, z): `front` and `back` are how far it hangs down."""
    rings = []
    for q in np.linspace(-1, 1, 7):
        f = 0.006 * math.sin(7 * q + 30 * y)
        outer = [(0.026 + f, -front), (0.02 + f / 2, -front * 0.4), (0.018, 0.0), (0.0, 0.018)]
        outer += [(-0.018, 0.0), (-0.024 - f, -back)]
        inner = [
            (-0.014 - f, -back),
            (-0.009, 0.0),
            (0.0, 0.009),
            (0.009, 0.0),
            (0.014 + f, -front),
        ]
        rings.append(np.array([(x + a, y + q * width / 2, z + b) for a, b in outer + inner]))
    return cube_project(loft(rings, mat))


def _mount(asm: Assembly, y: float, z: float, reach: float, mat: Material) -> None:
    asm.board("body", (0, y - 0.012, z - 0.012), (reach, y + 0.012, z + 0.012), mat, 0.003)
    asm.board("body", (0, y - 0.024, z - 0.024), (0.008, y + 0.024, z + 0.024), mat, 0.002)


def double_rail(width: float, towels: list[str], offset: Offset) -> Model:
    asm, metal = Assembly(), steel(30)
    half = width / 2
    for x, z, colour, q in ((0.055, 0.62, towels[0], -1), (0.12, 0.54, towels[1], 1)):
        asm.add("body", tube([(x, -half, z), (x, half, z)], 0.009, 6, mat=metal))
        mat = _terry(colour, offset, 0.2 if q < 0 else 0.12)
        y, w = q * 0.13 * width, width * 0.6
        asm.add("body", hung_towel(x, y, w, z, z - 0.06, 0.3, mat))
        asm.solid("body", (x - 0.02, y - w / 2, 0.06), (x + 0.025, y + w / 2, z + 0.02))
        for s in (-1, 1):
            _mount(asm, s * (half - 0.02), z, x, metal)
    return Model("double towel rail with towels", asm.parts(), mass=2.2, texture_size=128)


def ladder(width: float, height: float, towels: list[str], colour: str, offset: Offset) -> Model:
    """A heated towel radiator: two uprights and many rungs in groups."""
    asm, paint = Assembly(), finish(colour, 2, offset)
    half, x = width / 2, 0.055
    for s in (-1, 1):
        asm.board(
            "body",
            (x - 0.015, s * half - 0.016, 0),
            (x + 0.015, s * half + 0.016, height),
            paint,
            0.008,
        )
        for z in (0.12, height - 0.12):
            asm.board(
                "body", (0, s * half - 0.01, z), (x, s * half + 0.01, z + 0.02), paint, solid=False
            )
    levels = [
        f * height for f in (0.05, 0.12, 0.19, 0.26, 0.42, 0.49, 0.56, 0.63, 0.79, 0.86, 0.93)
    ]
    for mesh in bars([[(x, -half, z), (x, half, z)] for z in levels], 0.011, paint, 6):
        asm.add("body", mesh)
    asm.solid("body", (x - 0.012, -half, 0.04 * height), (x + 0.012, half, 0.95 * height))
    for k, (level, tone) in enumerate(zip((7, 3), towels, strict=False)):
        z = levels[level]
        y, w = (-0.06 if k == 0 else 0.08) * width, width * 0.7
        mat = _terry(tone, offset, z - 0.2)
        asm.add("body", hung_towel(x, y, w, z, 0.27 - 0.06 * k, 0.14, mat))
        asm.solid("body", (x, y - w / 2, z - 0.25), (x + 0.03, y + w / 2, z + 0.02))
    return Model("heated towel rail with towels", asm.parts(), mass=4.8, texture_size=128)


def towel_ring(radius: float, towel: str, offset: Offset) -> Model:
    """A ring on a round plate with a hand towel pulled through."""
    asm, metal = Assembly(), steel(30)
    x, z = 0.045, 0.42
    hoop = ring(20, radius, radius)[:, [2, 0, 1]] + [x, 0, z + radius]
    asm.add("body", tube(hoop, 0.008, 6, closed=True, mat=metal))
    top = z + 2 * radius
    asm.board("body", (0, -0.014, top - 0.016), (x + 0.01, 0.014, top + 0.016), metal, 0.004)
    asm.board("body", (0, -0.034, top - 0.034), (0.01, 0.034, top + 0.034), metal, 0.006)
    mat = _terry(towel, offset, z - 0.33)
    rings = []
    for q, w in ((0.012, 0.05), (0.0, 0.08), (-0.1, 0.12), (-0.24, 0.145), (-0.4, 0.15)):
        n = 14
        t = np.arange(n) * math.tau / n
        fold = 1 + 0.16 * np.sin(5 * t) * min(1.0, (0.05 - q) * 4)
        rings.append(np.c_[x + 0.03 * np.cos(t) * fold, w * np.sin(t), np.full(n, z + q)])
    asm.add("body", loft(rings, mat))
    asm.solid("body", (x - 0.03, -0.145, z - 0.4), (x + 0.03, 0.145, z + 0.02))
    asm.solid("body", (x - 0.01, -radius, z), (x + 0.01, radius, top))
    return Model("towel ring with a towel", asm.parts(), mass=0.8, texture_size=128)


def hook_board(width: float, towels: list[str], wood: str, offset: Offset) -> Model:
    """A board with hooks, towels hanging by their loops."""
    asm, timber, metal = Assembly(), finish(wood, 1, offset), steel(30)
    z = 0.62
    asm.board("body", (0, -width / 2, z), (0.02, width / 2, z + 0.09), timber, 0.005)
    count = 4
    for k in range(count):
        y = (k - (count - 1) / 2) * width / count
        hook = [(0.02, y, z + 0.055), (0.06, y, z + 0.045), (0.075, y, z + 0.07)]
        asm.add("body", tube(np.array(hook), 0.007, 6, mat=metal))
        if k >= len(towels):
            continue
        mat = _terry(towels[k], offset, 0.15 + 0.05 * k)
        rings = []
        long = 0.58 - 0.09 * k
        for q, w in ((0.0, 0.018), (0.05, 0.045), (0.18, 0.075), (0.4, 0.09), (1.0, 0.1)):
            n = 12
            t = np.arange(n) * math.tau / n
            fold = 1 + 0.22 * np.sin(4 * t + k) * min(1.0, q * 5)
            flat = np.c_[0.05 + 0.034 * np.cos(t) * fold, y + w * np.sin(t) * fold]
            rings.append(np.c_[flat, np.full(n, z + 0.06 - q * long)])
        asm.add("body", loft(rings, mat))
        asm.solid("body", (0.02, y - 0.09, z + 0.06 - long), (0.085, y + 0.09, z + 0.05))
    return Model("towel hooks with towels", asm.parts(), mass=1.5, texture_size=128)


def towel_rail_any(kind: str, **more) -> Model:
    """A rail: "single", "double", "ladder", "ring" or "hooks"."""
    make = {
        "single": towel_rail,
        "double": double_rail,
        "ladder": ladder,
        "ring": towel_ring,
        "hooks": hook_board,
    }
    return make[kind](**more)


def towel_rail_any_random(rng: np.random.Generator) -> dict:
    return {"kind": "single", "offset": towel_rail_random(rng)["offset"]}


_AT = {"offset": noise_offset(np.random.default_rng(3))}

MODELS = {
    "towel_rail": Maker(
        towel_rail_any,
        towel_rail_any_random,
        7,
        [
            {"width": 0.6, "towel": "#5f8ea0", **_AT},
            {"width": 0.6, "towel": "#d9cbb0", **_AT},
            {"kind": "double", "width": 0.62, "towels": ["#e8e0cc", "#4f8a86"]},
            {
                "kind": "ladder",
                "width": 0.48,
                "height": 0.86,
                "towels": ["#c8707c", "#e8e4dc"],
                "colour": "#f0f0ee",
            },
            {"kind": "ring", "radius": 0.085, "towel": "#7a9ac8"},
            {
                "kind": "hooks",
                "width": 0.6,
                "towels": ["#e0b84a", "#5a86b8", "#c86a5a"],
                "wood": "oak",
            },
            {
                "kind": "ladder",
                "width": 0.48,
                "height": 0.86,
                "towels": ["#4f8a86", "#d8c49a"],
                "colour": "#2f3134",
            },
        ],
    ),
}
