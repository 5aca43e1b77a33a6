"""Dining tables and side tables."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Maker, Model, Support, cylinder_piece, prism_piece, round_polygon
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, loft, superellipse, tube

from .designs import extend
from .joinery import Assembly, finish, leg, surface
from .low_tables import SIDE_TABLES

Offset = tuple[float, float, float]


def _round_top(asm: Assembly, radius: float, z: tuple[float, float], mat, n: int = 40) -> None:
    """A round board between two heights, its edge eased."""
    z0, z1 = z
    profile = [(0, z0), (radius - 0.02, z0), (radius, z0 + 0.4 * (z1 - z0)), (radius, z1 - 0.004)]
    profile += [(radius - 0.005, z1), (0, z1)]
    asm.add("body", lathe(profile, n, mat=mat, weight=1.3))
    asm.piece("body", cylinder_piece(radius, z0, z1, 14))


def _pedestal(asm: Assembly, z: float, radius: float, wood: str, offset: Offset) -> None:
    """A turned column on four feet."""
    upright = finish(wood, 2, offset)
    turned = [(0, 0.1), (0.075, 0.1), (0.08, 0.16), (0.06, 0.2), (0.05, 0.3), (0.062, 0.42)]
    turned += [(0.05, 0.52), (0.045, z - 0.06), (0.09, z - 0.03), (0.2, z), (0, z)]
    asm.add("body", lathe(turned, 18, mat=upright))
    asm.piece("body", cylinder_piece(0.07, 0.1, z - 0.03, 8))
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        path = [(0.03, 0.17, 0.04), (0.2, 0.12, 0.035), (radius, 0.03, 0.028)]
        rings = []
        for r, height, thick in path:
            # a foot's section stands across its run
            square = [(-thick, -0.03), (thick, -0.03), (thick, 0.03), (-thick, 0.03)]
            rings.append(np.array([(r * c - w * s, r * s + w * c, height + h) for w, h in square]))
        asm.add("body", loft(rings, upright))
        asm.piece("body", np.concatenate(rings))


def dining_table(
    style: str = "round",
    length: float = 1.6,
    depth: float = 0.9,
    wood: str = "oak",
    frame: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """style: "round" on a pedestal (`depth` across), "oval" on splayed legs, or "trestle"."""
    asm, height, t = Assembly(), 0.74, 0.032
    top, upright = finish(wood, 1, offset), finish(frame or wood, 2, offset)
    z = height - t
    if style == "round":
        _round_top(asm, depth / 2, (z, height), top)
        _pedestal(asm, z, 0.36 * depth, frame or wood, offset)
        polygon = round_polygon(depth / 2 - 0.015, 16)
        support = Support("top", height, polygon)
    elif style == "oval":
        hx, hy = depth / 2, length / 2
        steps = [(0.025, z), (0, z + 0.014), (0, height - 0.005), (0.006, height)]
        rings = [superellipse(hx - inset, hy - inset, 2.6, 36, at) for inset, at in steps]
        asm.add("body", loft(rings, top, weight=1.3))
        outline = superellipse(hx, hy, 2.6, 16)[:, :2]
        asm.piece("body", prism_piece(outline, z, height))
        for sx in (-1, 1):
            for sy in (-1, 1):
                x, y = sx * (hx - 0.19), sy * (hy - 0.3)
                foot = x + sx * 0.08, y + sy * 0.13
                leg(asm, "body", foot, (x, y), (0, z), (0.019, 0.034), upright, 12)
        for s in (-1, 1):
            x, y = s * (hx - 0.19), s * (hy - 0.3)
            rail = (x - 0.012, -abs(y), z - 0.07), (x + 0.012, abs(y), z)
            asm.board("body", *rail, upright)
            asm.board("body", (-hx + 0.19, y - 0.012, z - 0.07), (hx - 0.19, y + 0.012, z), upright)
        polygon = [tuple(p) for p in superellipse(hx - 0.015, hy - 0.015, 2.6, 18)[:, :2]]
        support = Support("top", height, polygon)
    else:
        hx, hy = depth / 2, length / 2
        planks = 5
        for k in range(planks):  # planks with a hair's breadth between them, breadboard ends
            a = -hx + k * depth / planks
            low, high = (a + 0.001, -hy + 0.07, z), (a + depth / planks - 0.001, hy - 0.07, height)
            asm.board("body", low, high, finish(wood, 1, np.add(offset, k)), 0.003, weight=1.2)
        for s in (-1, 1):
            low, high = sorted((s * hy, s * (hy - 0.069)))
            asm.board("body", (-hx, low, z), (hx, high, height), finish(wood, 0, offset), 0.004)
            y = s * (hy - 0.28)
            for sx in (-1, 1):
                foot, head = (sx * (hx - 0.08), y), (sx * 0.2, y)
                leg(asm, "body", foot, head, (0, z - 0.05), (0.035, 0.035), upright, 4)
            asm.board("body", (-0.34, y - 0.035, z - 0.06), (0.34, y + 0.035, z), upright, 0.004)
            asm.board("body", (-0.3, y - 0.02, 0.26), (0.3, y + 0.02, 0.32), upright, 0.004)
        stretcher = (-0.02, -hy + 0.22, 0.265), (0.02, hy - 0.22, 0.315)
        asm.board("body", *stretcher, finish(frame or wood, 1, offset), 0.004)
        support = surface("top", (-hx, -hy), (hx, hy), height)
    return Model(
        title=f"{style} {wood} dining table",
        parts=asm.parts(),
        mass=32.0,
        supports=[support],
        ground_shadow=True,
    )


def dining_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random dining table."""
    return {
        "style": pick(rng, ["round", "oval", "trestle"]),
        "length": round(float(rng.uniform(1.4, 1.7)), 2),
        "depth": round(float(rng.uniform(0.88, 1.0)), 2),
        "wood": pick(rng, ["oak", "walnut", "pine"]),
        "offset": noise_offset(rng),
    }


def side_table(
    style: str = "tripod",
    width: float = 0.45,
    height: float = 0.52,
    wood: str = "oak",
    offset: Offset = (0, 0, 0),
) -> Model:
    """style: a round "tripod", a square one with a "shelf", or a metal "tray"."""
    asm, r, t = Assembly(), width / 2, 0.024
    top, upright = finish(wood, 1, offset), finish(wood, 2, offset)
    z = height - t
    if style == "tripod":
        _round_top(asm, r, (z, height), top, 30)
        for k in range(3):
            a = 2 * math.pi * k / 3
            c, s = math.cos(a), math.sin(a)
            foot, head = (0.84 * r * c, 0.84 * r * s), (0.45 * r * c, 0.45 * r * s)
            leg(asm, "body", foot, head, (0, z), (0.011, 0.019), upright, 10)
        supports, mass = [Support("top", height, round_polygon(r - 0.012, 14))], 4.5
    elif style == "shelf":
        asm.board("body", (-r, -r, z), (r, r, height), top, 0.005, segments=2, weight=1.3)
        for x in (-r + 0.03, r - 0.03):
            for y in (-r + 0.03, r - 0.03):
                leg(asm, "body", (x, y), (x, y), (0, z), (0.017, 0.02), upright, 4)
        for s in (-1, 1):
            c, e = s * (r - 0.03), r - 0.03
            asm.board("body", (c - 0.009, -e, z - 0.06), (c + 0.009, e, z), upright)
            asm.board("body", (-e, c - 0.009, z - 0.06), (e, c + 0.009, z), upright)
        e = r - 0.02
        asm.board("body", (-e, -e, 0.13), (e, e, 0.148), top, 0.002)
        supports = [
            surface("top", (-r, -r), (r, r), height),
            surface("shelf_1", (-e, -e), (e, e), 0.148, z - 0.06 - 0.148, margin=0.035),
        ]
        mass = 6.5
    else:
        iron = plain(wood if wood.startswith("#") else "#2c2e30", 0.05, 20, offset)
        dish = [(0, z + 0.012), (r - 0.004, z + 0.012), (r, z + 0.018), (r, height + 0.012)]
        dish += [(r - 0.008, height + 0.012), (r - 0.008, z + 0.022), (0, z + 0.022)]
        asm.add("body", lathe(dish, 32, mat=iron, weight=1.2))
        asm.piece("body", cylinder_piece(r, z + 0.012, z + 0.022, 14))
        for k in range(14):  # the rim
            a, b = 2 * math.pi * k / 14, 2 * math.pi * (k + 1) / 14
            wall = [
                (q * math.cos(w), q * math.sin(w), h)
                for q in (r - 0.008, r)
                for w in (a, b)
                for h in (z + 0.022, height + 0.012)
            ]
            asm.piece("body", np.array(wall))
        ring = [
            (0.8 * r * math.cos(a), 0.8 * r * math.sin(a)) for a in np.arange(20) * math.pi / 10
        ]
        asm.add("body", tube([(x, y, 0.008) for x, y in ring], 0.008, 6, closed=True, mat=iron))
        for k in range(4):
            x, y = ring[5 * k]
            rod = tube([(x, y, 0.008), (x, y, z + 0.014)], 0.008, 6, mat=iron)
            asm.add("body", rod, solid=True)
        supports, mass = [Support("top", z + 0.022, round_polygon(r - 0.022, 14))], 4.0
    return Model(
        title=f"side table, {style}",
        parts=asm.parts(),
        mass=mass,
        supports=supports,
        ground_shadow=True,
    )


def side_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random side table."""
    return {
        "style": pick(rng, ["tripod", "shelf", "tray"]),
        "width": round(float(rng.uniform(0.42, 0.5)), 2),
        "height": round(float(rng.uniform(0.47, 0.57)), 2),
        "wood": pick(rng, ["oak", "walnut", "birch"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "side_table": extend(
        Maker(
            side_table,
            side_table_random,
            3,
            [
                {"style": "tripod", "wood": "oak", "width": 0.46, "height": 0.5},
                {"style": "shelf", "wood": "walnut", "width": 0.42, "height": 0.56},
                {"style": "tray", "wood": "#3c5a50", "width": 0.44, "height": 0.5},
            ],
        ),
        SIDE_TABLES,
    ),
}
