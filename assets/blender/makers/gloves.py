"""Rubber gloves: pairs, crossed, single, long, one on the other."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Model, Part
from toolkit.shapes import loft, superellipse, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners

FINGERS = (
    (-0.036, 0.062, 0.0115, 0.22),
    (-0.0125, 0.078, 0.0125, 0.07),
    (0.0125, 0.082, 0.0125, -0.05),
)


def glove(colour: str, cuff: float, right: bool, curl: float = 0.0) -> list[Mesh]:
    """A rubber glove lying flat, fingers towards +x, its cuff's open end at x = -cuff - 0.09."""
    m = Material()
    ribs = m.math("SINE", m.math("MULTIPLY", m.axis(0), 900))
    skin = m.mix(m.remap(ribs, 0.2, 1.0, 0, 0.12), m.mottle(colour, 0.07, 40), shade(colour, 0.6))
    m.colour(skin)
    hole = plain(shade(colour, 0.72), 0.05)
    rings = []
    stations = [(-cuff - 0.09, 0.064, 0.0205)]
    stations += [(-cuff - 0.082, 0.063, 0.02), (-cuff - 0.076, 0.058, 0.017), (-0.09, 0.046, 0.014)]
    stations += [
        (-0.06, 0.045, 0.015),
        (-0.02, 0.052, 0.016),
        (0.004, 0.05, 0.0135),
        (0.014, 0.042, 0.009),
    ]
    for x, half, t in stations:
        ring = superellipse(t, half, 2.6, 10)
        rings.append([(x, y, z + 0.021) for z, y, _ in ring])
    inner = [(x, y * 0.93, 0.021 + (z - 0.021) * 0.8) for x, y, z in rings[0]]
    deep = [(x + 0.025, y, z) for x, y, z in inner]
    palm = loft(
        [deep, inner, *rings],
        mats=[m, hole],
        mat_of_face=lambda k, i: 1 if k == 0 else 0,
    )
    out = [palm]
    for y, length, r, splay in (*FINGERS, (0.036, 0.07, 0.0115, -0.2)):
        base = (0.0, y, 0.019)
        c, s = math.cos(-splay), math.sin(-splay)
        path = [base]
        for t in (0.5, 0.88, 1.0):
            d = length * t
            path.append((c * d, y + s * d, 0.019 - 0.004 * t + curl * t * t))
        out.append(tube(path, [r * 1.15, r * 1.05, 0.92 * r, 0.4 * r], 5, mat=m, flatten=0.95))
    side = -0.045
    thumb = [
        (-0.05, side + 0.012, 0.019),
        (-0.03, side - 0.018, 0.019),
        (-0.002, side - 0.038, 0.017),
    ]
    thumb += [(0.016, side - 0.045, 0.016), (0.021, side - 0.047, 0.016)]
    out.append(tube(thumb, [0.019, 0.0165, 0.0135, 0.0105, 0.005], 6, mat=m))
    if right:
        for mesh in out:
            mesh.scale(1, -1, 1)
    return out


def rubber_gloves(kind: str, colour: str) -> Model:
    """Household gloves: a pair side by side, crossed, one alone, long ones, or laid together."""
    if kind == "single":
        groups = [glove(colour, 0.05, False, 0.004)]
    elif kind == "together":  # palm to palm, a little askew
        groups = [glove(colour, 0.05, False, 0.004) for _ in range(2)]
        for mesh in groups[1]:
            mesh.keep_pattern().turn(rz=0.14).move(-0.012, 0.004, 0.034)
    else:
        cuff = 0.14 if kind == "long" else 0.05
        groups = [glove(colour, cuff, right) for right in (False, True)]
        for k, group in enumerate(groups):
            for mesh in group:
                mesh.keep_pattern()
                if kind == "crossed":
                    mesh.turn(rz=0.55 * (1 - 2 * k)).move(0.0, 0.0, 0.036 * k)
                else:
                    mesh.turn(rz=0.1 * (2 * k - 1)).move(y=0.07 * (2 * k - 1))
    hulls = [few_corners(np.concatenate([m.v for m in g])) for g in groups]
    part = Part([m for g in groups for m in g], collision=hulls)
    name = "rubber glove" if kind == "single" else "rubber gloves"
    return Model(name, {"body": part}, mass=0.08, friction=0.8, texture_size=128, front="-y")


MODELS = {
    "rubber_gloves": maker(
        rubber_gloves,
        ("kind", "colour"),
        [
            ("pair", "#f08fb4"),
            ("crossed", "#e8609a"),
            ("single", "#2f8fd8"),
            ("long", "#2f9a6a"),
            ("together", "#8ad0e0"),
            ("pair", "#2f8fd8"),
        ],
    ),
}
