"""Things that hang on a wall, their back at -X: paintings, mirrors, towel rails."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend
from toolkit.mesh import cube_project
from toolkit.model import (
    Model,
)
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import loft, tube

from .joinery import Assembly, steel

Offset = tuple[float, float, float]


def towel_rail(width: float = 0.6, towel: str = "#5f8ea0", offset: Offset = (0, 0, 0)) -> Model:
    """A rail to hang on a wall (back at -X) with a towel over it."""
    asm, metal = Assembly(), steel(30)
    half, z, x = width / 2, 0.5, 0.03
    asm.add("body", tube([(x, -half, z), (x, half, z)], 0.009, 8, mat=metal))
    for y in (-half + 0.02, half - 0.02):
        asm.board("body", (-0.045, y - 0.012, z - 0.012), (x, y + 0.012, z + 0.012), metal, 0.003)
        asm.board(
            "body", (-0.05, y - 0.022, z - 0.022), (-0.043, y + 0.022, z + 0.022), metal, 0.002
        )
    band = Material()
    line = band.remap(
        band.math("ABSOLUTE", band.math("SUBTRACT", band.axis(2), 0.09)), 0.012, 0.016, 1, 0
    )
    weave = band.mottle(towel, 0.06, 160, offset)
    band.colour(band.mix(line, weave, blend(towel, "#ffffff", 0.6)))
    rings = []
    w = half * 0.72
    for y in np.linspace(-w, w, 9):
        fold = 0.004 * math.sin(14 * y / w)
        outer = [
            (x + 0.024 + fold, 0.02),
            (x + 0.022 + fold, 0.3),
            (x + 0.018, z),
            (x + 0.009, z + 0.017),
            (x - 0.009, z + 0.017),
            (x - 0.018, z),
            (x - 0.022 - fold, 0.16),
        ]
        inner = [
            (x - 0.015 - fold, 0.16),
            (x - 0.011, z),
            (x, z + 0.009),
            (x + 0.011, z),
            (x + 0.014 + fold, 0.3),
            (x + 0.015 + fold, 0.02),
        ]
        rings.append(np.array([(a, y, b) for a, b in outer + inner]))
    asm.add("body", cube_project(loft(rings, band)))
    asm.solid("body", (x - 0.02, -half, 0.02), (x + 0.025, half, z + 0.02))
    return Model(title="towel rail with a towel", parts=asm.parts(), mass=1.6, texture_size=128)


def towel_rail_random(rng: np.random.Generator) -> dict:
    """Parameters of a random towel rail."""
    return {
        "width": round(float(rng.uniform(0.5, 0.7)), 2),
        "towel": pick(rng, ["#5f8ea0", "#d9cbb0", "#a0655a", "#7d9a78"]),
        "offset": noise_offset(rng),
    }
