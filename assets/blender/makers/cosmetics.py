"""Nail polish and lipstick."""

from __future__ import annotations

import math

import numpy as np
from labels.hazards import front
from toolkit.materials import label as printed
from toolkit.materials import metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import pick, uniform
from toolkit.shapes import lathe, loft, rounded_rectangle

from makers.choking import loose
from makers.projection import project_label
from makers.remedies import glassy


def polish_bottle(height: float, colour: str, lid: str, square: bool) -> list[Mesh]:
    """One little flask of nail polish with its long cap."""
    s = height / 0.075
    glass = glassy(colour, 0.036 * s)
    if square:
        outline = rounded_rectangle(0.027, 0.027, 0.005, 3)
        rings = ((0, 0.92), (0.002, 1), (0.03, 1), (0.035, 0.62))
        flask = loft(
            [np.c_[outline * f, np.full(len(outline), z * s)] for z, f in rings], mat=glass
        )
    else:
        belly = [
            (0, 0),
            (0.013, 0),
            (0.0165, 0.004),
            (0.017, 0.018),
            (0.013, 0.029),
            (0.008, 0.035),
        ]
        flask = lathe([*((r, z * s) for r, z in belly), (0, 0.035 * s)], 14, mat=glass)
    label = printed(front("NOVA", ["NAIL", "POLISH"], "#ffffff", "#ffffff"), base=colour)
    project_label(flask, label, "+x", (0, 0.016 * s), (0.025, 0.024 * s), 0.6)
    z = 0.034 * s
    top = [(0, z), (0.0085, z), (0.0078, 0.07 * s), (0.0065, 0.075 * s), (0, 0.075 * s)]
    return [flask, lathe(top, 12, mat=plain(lid, 0.03))]


def nail_polish(height: float, colours: list[str], lid: str, square: bool) -> Model:
    """One bottle, or a few in a row."""
    pieces = []
    for k, colour in enumerate(colours):
        y = (k - (len(colours) - 1) / 2) * 0.036
        bottle = polish_bottle(height, colour, lid, square)
        pieces.append(
            [m.keep_pattern().turn(rz=0.25 * (k % 2)).move(0.006 * (k % 2), y) for m in bottle]
        )
    return loose("nail polish", pieces, 0.045 * len(colours))


def nail_polish_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.07, 0.082),
        "lid": pick(rng, ["#1c1c20", "#f4f4f0"]),
        "square": bool(rng.random() < 0.5),
    }


def lipstick(colour: str, case: str, height: float) -> Model:
    """An opened lipstick, upright, its cap lying beside it."""
    s = height / 0.07
    shell = plain(case, 0.04)
    gold = metal("e0bc5a", "94722a")
    base = lathe([(0, 0), (0.0105, 0), (0.0105, 0.026), (0.0095, 0.027), (0, 0.027)], 14, mat=shell)
    collar = lathe(
        [(0, 0.027), (0.0088, 0.027), (0.0088, 0.045), (0.0078, 0.046), (0, 0.046)], 14, mat=gold
    )
    n, r = 12, 0.0072
    rings = []
    for z, lean in ((0.045, 0.0), (0.056, 0.0), (0.063, 0.75)):
        ring = []
        for k in range(n):
            a = 2 * math.pi * k / n
            ring.append((r * math.cos(a), r * math.sin(a), z + lean * r * math.cos(a + math.pi)))
        rings.append(ring)
    bullet = loft(rings, mat=plain(colour, 0.04))
    cap = lathe(
        [
            (0, 0),
            (0.0105, 0),
            (0.0112, 0.001),
            (0.0112, 0.036),
            (0.0098, 0.036),
            (0.0098, 0.004),
            (0, 0.004),
        ],
        14,
        mats=[shell, plain(shade(case, 0.5), 0.03)],
        mat_of_segment=[0, 0, 0, 0, 1, 1],
    )
    cap.turn(ry=math.pi / 2).turn(rz=2.2).move(0.012, 0.028, 0.0112)
    pieces = [[base, collar, bullet], [cap]]
    for mesh in (base, collar, bullet, cap):
        mesh.scale(s)
    return loose("open lipstick", pieces, 0.028)


def lipstick_random(rng: np.random.Generator) -> dict:
    return {"height": uniform(rng, 0.07, 0.08)}


MODELS = {
    "nail_polish": Maker(
        nail_polish,
        nail_polish_random,
        3,
        [
            {"colours": ["#c8102c"], "square": False, "lid": "#1c1c20"},
            {"colours": ["#e0408a", "#7b3fb5"], "square": True, "lid": "#1c1c20"},
            {"colours": ["#1f8fc0", "#c8102c", "#e8641c"], "square": False, "lid": "#f4f4f0"},
        ],
    ),
    "lipstick": Maker(
        lipstick,
        lipstick_random,
        2,
        [{"colour": "#c80f2a", "case": "#1c1c20"}, {"colour": "#d8488a", "case": "#8a1f5c"}],
    ),
}
