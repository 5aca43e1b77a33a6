"""Lamps that hug the ceiling. All are convex: see-through as renderers draw them, lest their shadow
lies on the floor, they have no depth of their own to tell front from back.
"""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, lathe

SHADES = {"opal": "#f6f3ea", "linen": "#e2d5bd", "grey": "#b9bab8", "sage": "#b3bda6"}
METALS = {"steel": "#6a6c6e", "brass": "#7a6234", "black": "#1c1d1e", "white": "#a8a7a3"}
#: Glass lets the light of the room through: brighter than the shader makes what looks down.
BRIGHT = (1.6, 1.6, 1.6, 1.0)


def ceiling_lamp(kind: str, shade: str, metal: str, radius: float = 0.18) -> Model:
    """A "dome" of glass, a "drum" of cloth or a square "panel" under a base of metal."""
    glass, base = plain(SHADES[shade], 0.03), plain(METALS[metal], 0.03)
    if kind == "panel":
        meshes = [box(2 * radius, 2 * radius, 0.05, (0, 0, 0), glass, 0.006)]
    else:
        if kind == "dome":
            deep = 0.5 * radius
            turns = [0.5 * math.pi * k / 6 for k in range(7)]
            profile = [(radius * math.sin(t), deep * (1 - math.cos(t))) for t in turns]
        else:
            deep = 0.12
            profile = [(0, 0), (radius - 0.012, 0), (radius, 0.012), (radius, deep)]
        profile += [(radius, deep + 0.018), (0, deep + 0.018)]
        parts = [0] * (len(profile) - 3) + [1, 1]
        meshes = [lathe(profile, 24, mats=[glass, base], mat_of_segment=parts)]
    return Model("ceiling lamp", {"body": Part(meshes, rgba=BRIGHT, collision="hull")}, mass=1.4)


def ceiling_lamp_random(rng: np.random.Generator) -> dict:
    return {
        "kind": pick(rng, ("dome", "drum", "panel")),
        "shade": pick(rng, tuple(SHADES)),
        "metal": pick(rng, tuple(METALS)),
        "radius": float(rng.uniform(0.15, 0.22)),
    }


MODELS = {
    "ceiling_lamp": Maker(
        ceiling_lamp,
        ceiling_lamp_random,
        6,
        [
            {"kind": "dome", "shade": "opal", "metal": "steel", "radius": 0.17},
            {"kind": "dome", "shade": "opal", "metal": "brass", "radius": 0.2},
            {"kind": "drum", "shade": "linen", "metal": "white", "radius": 0.22},
            {"kind": "drum", "shade": "grey", "metal": "black", "radius": 0.2},
            {"kind": "panel", "shade": "opal", "metal": "white", "radius": 0.18},
            {"kind": "dome", "shade": "opal", "metal": "black", "radius": 0.18},
        ],
    ),
}
