"""Lamps that can be on or off."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, cylinder_piece
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import ellipsoid, lathe, spline, tube

from .designs import extend
from .floor_lamp_forms import FLOOR_LAMPS
from .joinery import Assembly, finish, leg

Offset = tuple[float, float, float]


def _shade(r_low: float, r_high: float, z0: float, z1: float, mat: Material, n: int = 28) -> Mesh:
    """An open lampshade with an inside."""
    t = 0.006
    profile = [(r_low - t, z0), (r_low, z0), (r_high, z1), (r_high - t, z1), (r_low - t, z0)]
    return lathe(profile, n, mat=mat).outward()


def floor_lamp(
    style: str = "straight",
    height: float = 1.55,
    shade_colour: str = "#e8dcc4",
    stand: str = "#2b2c2e",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A standing lamp, "straight", "arc" or "tripod"; the variant `on` has a glowing shade."""
    asm = Assembly()
    pole = (
        metal("c9a45c", "8a6a2c", (1, 1, 8), 30) if stand == "brass" else finish(stand, 2, offset)
    )
    r_low, r_high, tall = 0.21, 0.155, 0.28
    x = 0.0
    if style == "tripod":
        for k in range(3):
            a = 2 * math.pi * k / 3 + math.pi
            c, s = math.cos(a), math.sin(a)
            leg(
                asm,
                "body",
                (0.26 * c, 0.26 * s),
                (0.03 * c, 0.03 * s),
                (0, height - tall),
                (0.013, 0.017),
                pole,
            )
        hub = [
            (0, height - tall - 0.06),
            (0.045, height - tall - 0.06),
            (0.045, height - tall),
            (0, height - tall),
        ]
        asm.add("body", lathe(hub, 14, mat=plain("#2b2c2e", 0.05, 20)))
    else:
        base = [
            (0, 0),
            (0.15, 0),
            (0.155, 0.008),
            (0.15, 0.018),
            (0.03, 0.028),
            (0.018, 0.05),
            (0, 0.05),
        ]
        asm.add("body", lathe(base, 28, mat=pole))
        if style == "arc":  # a block of stone holds the reach
            block = [(0, 0), (0.17, 0), (0.172, 0.006), (0.172, 0.052), (0.166, 0.06), (0, 0.06)]
            asm.add("body", lathe(block, 28, mat=plain("#d9d6d0", 0.08, 12, offset)))
            asm.piece("body", cylinder_piece(0.172, 0, 0.06))
        asm.piece("body", cylinder_piece(0.15, 0, 0.02))
        path = np.array([(0, 0, 0.02), (0, 0, height - tall * 0.5)])
        if style == "arc":
            x, r_low, r_high, tall = 0.42, 0.17, 0.12, 0.2
            bend = [
                (0, 0, 0.02),
                (0, 0, height * 0.55),
                (0.03, 0, height * 0.85),
                (0.2, 0, height),
                (0.38, 0, height * 0.985),
                (x, 0, height - 0.1),
            ]
            path = spline(bend, 4)
        asm.add("body", tube(path, 0.011, 8, mat=pole))
        asm.solid("body", (-0.012, -0.012, 0.02), (0.012, 0.012, height * 0.8))
    z1 = height if style != "arc" else height - 0.05
    z0 = z1 - tall
    off, on = Material(occlusion=0.7), Material(occlusion=0.0)
    off.colour(off.mottle(shade_colour, 0.04, 120, offset))
    warm = blend(shade_colour, "#ffdf9e", 0.7)
    middle = on.remap(on.distance((x, 0, (z0 + z1) / 2), (0.7, 0.7, 1.0)), 0.1, 0.24)
    on.colour(on.ramp(middle, [(0, "#fff6d8"), (0.5, warm), (1, shade(warm, 0.9))]))
    for part, mat in (("shade", off), ("shade_lit", on)):
        asm.add(part, _shade(r_low, r_high, z0, z1, mat).move(x, 0, 0))
    bulb = ellipsoid((0.035, 0.035, 0.05), (x, 0, (z0 + z1) / 2), 10, 6, plain("#f3f1ea", 0))
    asm.add("shade", bulb)
    glow = ellipsoid((0.037, 0.037, 0.053), (x, 0, (z0 + z1) / 2), 10, 6, Material("#fff8e0", 0.0))
    asm.add("shade_lit", glow)
    for a in (0, 2 * math.pi / 3, 4 * math.pi / 3):
        r = r_low + (r_high - r_low) * 0.5
        spoke = [
            (x, 0, (z0 + z1) / 2 - 0.045),
            (x + r * math.cos(a), r * math.sin(a), (z0 + z1) / 2 - 0.045),
        ]
        asm.add("body", tube(spoke, 0.004, 4, mat=pole))
    if style == "arc":  # a light shade: its whole volume would tip the lamp over
        asm.piece("body", np.add(cylinder_piece(0.085, z0 + 0.04, z1 - 0.04, 10), [x, 0, 0]))
    else:
        asm.piece("body", np.add(cylinder_piece(r_low, z0, z1, 10, r_high), [x, 0, 0]))
    return Model(
        title=f"{style} floor lamp",
        parts=asm.parts(shade_lit={"rgba": (1.5, 1.5, 1.5, 1.0)}),
        mass=5.5,
        variants={"default": ["body", "shade"], "on": ["body", "shade_lit"]},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["shade"]},
            {"state": "ON", "variants": ["on"], "parts": ["shade_lit"]},
        ],
        ground_shadow=True,
    )


def floor_lamp_random(rng: np.random.Generator) -> dict:
    """Parameters of a random floor lamp."""
    return {
        "style": pick(rng, ["straight", "tripod", "arc"]),
        "height": round(float(rng.uniform(1.45, 1.65)), 2),
        "shade_colour": pick(rng, ["#e8dcc4", "#d9d4cc", "#7d8b86"]),
        "stand": pick(rng, ["#2b2c2e", "brass", "oak"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "floor_lamp": extend(
        Maker(
            floor_lamp,
            floor_lamp_random,
            3,
            [
                {"style": "straight", "stand": "brass", "shade_colour": "#e8dcc4"},
                {"style": "tripod", "stand": "oak", "shade_colour": "#dcd6cb"},
                {"style": "arc", "stand": "#2b2c2e", "shade_colour": "#d9d4cc"},
            ],
        ),
        FLOOR_LAMPS,
    ),
}
