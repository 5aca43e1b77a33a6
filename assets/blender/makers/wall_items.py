"""Things that hang on a wall, their back at -X: paintings, mirrors, towel rails."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, label, plain
from toolkit.mesh import cube_project
from toolkit.model import (
    Maker,
    Model,
)
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import lathe, loft, tube

from .joinery import Assembly, finish, steel
from .pictures import painting

Offset = tuple[float, float, float]


def picture_frame(
    width: float = 0.7,
    height: float = 0.5,
    kind: str = "landscape",
    frame: str = "oak",
    seed: int = 0,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A framed painting to hang on a wall (back at -X)."""
    asm, t = Assembly(), 0.03
    wood, cross = finish(frame, 2, offset), finish(frame, 1, offset)
    for y0, y1 in ((-width / 2, -width / 2 + t), (width / 2 - t, width / 2)):
        asm.board("body", (0, y0, 0), (0.02, y1, height), wood, 0.004)
    for z0, z1 in ((0, t), (height - t, height)):
        asm.board("body", (0, -width / 2 + t, z0), (0.02, width / 2 - t, z1), cross, 0.004)
    mount = plain("#f2efe8", 0.01, 20)
    asm.board("body", (0, -width / 2 + t, t), (0.009, width / 2 - t, height - t), mount)
    m = t + 0.045
    art = label(painting(kind, seed, 256, int(256 * (height - 2 * m) / (width - 2 * m))))
    # as thick as the frame allows: thin boards facing +X throw a blotchy shadow on themselves
    low, high = (0, -width / 2 + m, m), (0.015, width / 2 - m, height - m)
    asm.board("body", low, high, mount, 0, {"+x": art}, 3.0, solid=False)
    return Model(title=f"framed painting, {kind}", parts=asm.parts(), mass=1.8)


def picture_frame_random(rng: np.random.Generator) -> dict:
    """Parameters of a random painting."""
    upright = bool(rng.random() < 0.35)
    long, short = round(float(rng.uniform(0.6, 0.85)), 2), round(float(rng.uniform(0.45, 0.55)), 2)
    return {
        "width": short if upright else long,
        "height": long if upright else short,
        "kind": pick(rng, ["landscape", "abstract", "flower"]),
        "frame": pick(rng, ["oak", "walnut", "black", "#f0efec"]),
        "seed": seed_of(rng),
        "offset": noise_offset(rng),
    }


def mirror(
    width: float = 0.6,
    height: float = 0.8,
    frame: str = "oak",
    rounded: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A wall mirror (back at -X): what it mirrors is hinted at by bright, slanting bands."""
    asm = Assembly()
    glass = Material(occlusion=0.3)
    slant = glass.math("ADD", glass.math("MULTIPLY", glass.axis(1), 0.9), glass.axis(2))
    span = glass.remap(slant, 0, height + 0.2)
    stops = [
        (0, "#a9bcc6"),
        (0.3, "#c3d3da"),
        (0.33, "#dbe7ec"),
        (0.46, "#e4eef2"),
        (0.48, "#c6d5dc"),
        (0.62, "#bccdd5"),
    ]
    glass.colour(
        glass.ramp(
            span, [*stops, (0.64, "#d6e3e8"), (0.7, "#d9e5ea"), (0.72, "#c2d1d8"), (1, "#dfe9ed")]
        )
    )
    wood = finish(frame, 2, offset)
    if rounded:
        r = width / 2
        for radius, x0, x1, mat in ((r, 0.0, 0.022, wood), (r - 0.022, 0.02, 0.026, glass)):
            disc = lathe([(0, x0), (radius, x0), (radius, x1), (0, x1)], 36, mat=mat)
            asm.add("body", disc.turn(ry=math.pi / 2).move(0, 0, r))
        asm.solid("body", (0, -r * 0.9, r * 0.1), (0.026, r * 0.9, 2 * r * 0.95))
    else:
        t = 0.035
        asm.board("body", (0, -width / 2, 0), (0.024, -width / 2 + t, height), wood, 0.004)
        asm.board("body", (0, width / 2 - t, 0), (0.024, width / 2, height), wood, 0.004)
        cross = finish(frame, 1, offset)
        asm.board("body", (0, -width / 2 + t, 0), (0.024, width / 2 - t, t), cross, 0.004)
        asm.board(
            "body", (0, -width / 2 + t, height - t), (0.024, width / 2 - t, height), cross, 0.004
        )
        asm.board(
            "body", (0, -width / 2 + t, t), (0.014, width / 2 - t, height - t), glass, weight=1.4
        )
    return Model(title=f"{'round ' if rounded else ''}mirror", parts=asm.parts(), mass=6.0)


def mirror_random(rng: np.random.Generator) -> dict:
    """Parameters of a random mirror."""
    return {
        "width": round(float(rng.uniform(0.5, 0.7)), 2),
        "height": round(float(rng.uniform(0.7, 0.95)), 2),
        "frame": pick(rng, ["oak", "walnut", "black"]),
        "rounded": bool(rng.random() < 0.4),
        "offset": noise_offset(rng),
    }


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


MODELS = {
    "picture_frame": Maker(
        picture_frame,
        picture_frame_random,
        4,
        [
            {"kind": "landscape", "frame": "oak"},
            {"kind": "abstract", "frame": "black"},
            {"kind": "flower", "frame": "#f0efec", "width": 0.46, "height": 0.62},
            {"kind": "landscape", "frame": "walnut", "width": 0.8, "height": 0.5, "seed": 5},
        ],
    ),
    "towel_rail": Maker(
        towel_rail, towel_rail_random, 2, [{"towel": "#5f8ea0"}, {"towel": "#d9cbb0"}]
    ),
    "mirror": Maker(
        mirror,
        mirror_random,
        2,
        [{"rounded": False, "frame": "oak"}, {"rounded": True, "frame": "black"}],
    ),
}
