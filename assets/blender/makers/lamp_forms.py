"""Table lamps; every one can be on."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, cylinder_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, extrude, lathe, spline, tube

from .casework import metal_or
from .designs import designed
from .joinery import Assembly, finish, leg

Offset = tuple[float, float, float]
STATES = [
    {"state": "OFF", "variants": ["default"], "parts": ["shade"]},
    {"state": "ON", "variants": ["on"], "parts": ["shade_lit"]},
]


def lit_pair(colour: str, centre, reach: float, offset: Offset = (0, 0, 0)) -> list:
    """The cloth of a shade, dark and lit from within around a point."""
    off, on = Material(occlusion=0.7), Material(occlusion=0.0)
    off.colour(off.mottle(colour, 0.04, 120, offset))
    warm = blend(colour, "#ffdf9e", 0.7)
    near = on.remap(on.distance(centre), 0.4 * reach, reach)
    on.colour(on.ramp(near, [(0, "#fff8dc"), (0.5, warm), (1, shade(warm, 0.88))]))
    return [("shade", off), ("shade_lit", on)]


def _open_shade(r0: float, r1: float, z0: float, z1: float, mat, n: int = 24, t=0.006) -> Mesh:
    """A shade open above and below, with an inside; r0, r1 may be a list of (r, z)."""
    outer = [(r0, z0), (r1, z1)]
    profile = [(r0 - t, z0), *outer, (r1 - t, z1), (r0 - t, z0)]
    return lathe(profile, n, mat=mat).outward()


def lamp_model(
    title: str, asm: Assembly, mass: float, small: bool = False, glow: float = 1.5
) -> Model:
    return Model(
        title=title,
        parts=asm.parts(shade_lit={"rgba": (glow, glow, glow, 1.0)}),
        mass=mass,
        variants={"default": ["body", "shade"], "on": ["body", "shade_lit"]},
        states=STATES,
        ground_shadow=not small,
        texture_size=128 if small else 256,
    )


def _bulb(asm: Assembly, at, r: float = 0.03) -> None:
    for part, mat in (("shade", plain("#f3f1ea", 0)), ("shade_lit", Material("#fff8e0", 0.0))):
        asm.add(part, ellipsoid((r, r, 1.35 * r), at, 8, 5, mat))


# ---- table lamps
def table_lamp(
    foot: str = "vase", height: float = 0.5, colour: str = "#3f7f8c", cloth: str = "#efe6d2",
    drum: bool = False, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A shaded lamp on a ceramic "vase", a turned "stick", a "tripod", a "ball" or a "block"."""
    asm = Assembly()
    paint = (
        metal_or(colour, 2, offset)
        if colour in ("brass", "iron", "steel")
        else finish(colour, 2, offset)
    )
    gold = metal_or("brass")
    tall = 0.2 if height > 0.42 else 0.16
    z1, z0 = height, height - tall
    r0, r1 = (0.155, 0.15) if drum else (0.165, 0.105)
    if height <= 0.42:
        r0, r1 = 0.82 * r0, 0.82 * r1
    neck = z0 - 0.02
    if foot == "vase":
        k = neck / 0.28
        profile = [
            (0, 0),
            (0.062, 0),
            (0.066, 0.012),
            (0.06, 0.02 * k),
            (0.1, 0.09 * k),
            (0.105, 0.13 * k),
        ]
        profile += [
            (0.085, 0.19 * k),
            (0.04, 0.235 * k),
            (0.026, 0.26 * k),
            (0.03, neck),
            (0, neck),
        ]
        asm.add("body", lathe(profile, 24, mat=paint))
        asm.piece("body", cylinder_piece(0.1, 0, 0.2 * k, 12))
    elif foot == "stick":
        k = neck / 0.28
        profile = [
            (0, 0),
            (0.085, 0),
            (0.088, 0.012),
            (0.06, 0.024),
            (0.022, 0.045),
            (0.03, 0.07),
            (0.016, 0.1 * k),
        ]
        profile += [
            (0.016, 0.15 * k),
            (0.032, 0.175 * k),
            (0.016, 0.2 * k),
            (0.014, neck - 0.02),
            (0.03, neck),
            (0, neck),
        ]
        asm.add("body", lathe(profile, 18, mat=paint))
        asm.piece("body", cylinder_piece(0.088, 0, 0.02, 12))
        asm.piece("body", cylinder_piece(0.03, 0.02, neck, 8))
    elif foot == "tripod":
        for k in range(3):
            a = 2 * math.pi * k / 3
            c, s = math.cos(a), math.sin(a)
            leg(
                asm,
                "body",
                (0.13 * c, 0.13 * s),
                (0.012 * c, 0.012 * s),
                (0, neck),
                (0.008, 0.011),
                paint,
                8,
            )
        hub = [(0, neck - 0.02), (0.026, neck - 0.02), (0.026, neck + 0.01), (0, neck + 0.01)]
        asm.add("body", lathe(hub, 12, mat=gold))
    elif foot == "ball":
        n = max(2, round(neck / 0.14))
        r = neck / (2 * n)
        for k in range(n):
            asm.add(
                "body",
                ellipsoid(
                    (0.9 * r + 0.012, 0.9 * r + 0.012, r * 1.04),
                    (0, 0, r * (2 * k + 1)),
                    10,
                    6,
                    paint,
                ),
            )
        disc = [(0, 0), (0.075, 0), (0.075, 0.012), (0, 0.014)]
        asm.add("body", lathe(disc, 14, mat=gold))
        asm.piece("body", cylinder_piece(0.075, 0, 0.012, 12))
        asm.piece("body", cylinder_piece(r, 0.012, neck, 10))
    else:
        asm.board("body", (-0.06, -0.06, 0), (0.06, 0.06, neck - 0.03), paint, 0.008, segments=2)
    asm.add("body", tube([(0, 0, neck - 0.035), (0, 0, z0 + 0.09)], 0.007, 6, mat=gold))
    for part, mat in lit_pair(cloth, (0, 0, (z0 + z1) / 2), 0.2, offset):
        asm.add(part, _open_shade(r0, r1, z0, z1, mat, 22))
    _bulb(asm, (0, 0, z0 + 0.1), 0.028)
    for a in (0, 2 * math.pi / 3, 4 * math.pi / 3):
        r = r0 + (r1 - r0) * 0.25
        asm.add(
            "body",
            tube(
                [(0, 0, z0 + 0.05), (r * math.cos(a), r * math.sin(a), z0 + 0.05)],
                0.003,
                3,
                mat=gold,
            ),
        )
    asm.piece("body", cylinder_piece(r0, z0, z1, 12, r1))
    return lamp_model(f"table lamp, {foot}", asm, 1.6, small=True)


def banker(hood: str = "#1f7a4a", stand: str = "brass", offset: Offset = (0, 0, 0)) -> Model:
    """A banker's lamp: a brass foot and arm, a long glass hood."""
    asm, gold = Assembly(), metal_or(stand)
    base = [(0, 0), (0.09, 0), (0.092, 0.01), (0.07, 0.022), (0.02, 0.03), (0, 0.032)]
    asm.add("body", lathe(base, 20, mat=gold).scale(1, 1.15, 1))
    asm.add(
        "body",
        tube(
            spline([(-0.03, 0, 0.02), (-0.035, 0, 0.2), (-0.01, 0, 0.315), (0.02, 0, 0.325)], 3),
            0.009,
            7,
            mat=gold,
        ),
    )
    a = np.linspace(0, math.pi, 9)
    outer = [(0.085 * math.cos(t), 0.075 * math.sin(t)) for t in a]
    inner = [(0.077 * math.cos(t), 0.067 * math.sin(t) - 0.002) for t in a[::-1]]
    light = blend(hood, "#eaffd8", 0.45)
    for part, mat in (("shade", finish(hood, 1, offset)), ("shade_lit", Material(light, 0.0))):
        mesh = extrude([*outer, *inner], 0.27, mat, axis="y").move(0.03, 0, 0.255)
        asm.add(part, mesh)
        for s in (-1, 1):
            cap = extrude(outer, 0.008, mat, axis="y").move(0.03, s * 0.131, 0.255)
            asm.add(part, cap)
    for part, mat in (("shade", plain("#f4f1e8", 0)), ("shade_lit", Material("#fffbe6", 0.0))):
        asm.add(part, ellipsoid((0.022, 0.1, 0.022), (0.03, 0, 0.275), 8, 5, mat))
    chain = [(0.05, 0.06, 0.26), (0.05, 0.06, 0.17)]
    asm.add("body", tube(chain, 0.003, 4, mat=gold))
    asm.piece("body", cylinder_piece(0.09, 0, 0.025, 12))
    asm.solid("body", (-0.045, -0.01, 0.025), (-0.02, 0.01, 0.3))
    asm.solid("body", (-0.05, -0.135, 0.255), (0.11, 0.135, 0.33))
    return lamp_model("banker's lamp with a green hood", asm, 2.0, small=True, glow=1.3)


def mushroom(colour: str = "#e8703a", height: float = 0.36, offset: Offset = (0, 0, 0)) -> Model:
    """One glass body: a foot that swells into a dome."""
    asm = Assembly()
    r, h = 0.14, height
    stem = [
        (0, 0),
        (0.085, 0),
        (0.085, 0.012),
        (0.05, 0.06),
        (0.04, h - 0.17),
        (0.045, h - 0.13),
        (0, h - 0.13),
    ]
    foot = finish(colour, 2, offset)
    asm.add("body", lathe(stem, 22, mat=foot))
    for part, mat in lit_pair(colour, (0, 0, h - 0.1), 0.17, offset):
        dome = [
            (0.036, h - 0.135),
            (r, h - 0.135),
            (r, h - 0.115),
            (r * 0.94, h - 0.07),
            (r * 0.72, h - 0.026),
            (r * 0.4, h - 0.006),
            (0, h),
        ]
        asm.add(part, lathe([(0, h - 0.13), *dome], 26, mat=mat))
    asm.piece("body", cylinder_piece(0.085, 0, 0.06, 12, 0.05))
    asm.piece("body", cylinder_piece(0.05, 0.06, h - 0.135, 8))
    asm.piece("body", cylinder_piece(r, h - 0.135, h, 12, 0.4 * r))
    return lamp_model("mushroom table lamp", asm, 1.2, small=True)


def lantern(wood: str = "oak", height: float = 0.34, offset: Offset = (0, 0, 0)) -> Model:
    """A globe of white glass in a wooden ring foot."""
    asm, r = Assembly(), 0.12
    ring = [(0.04, 0), (0.085, 0), (0.095, 0.03), (0.08, 0.07), (0.05, 0.07), (0.04, 0)]
    asm.add("body", lathe(ring, 24, mat=finish(wood, 2, offset)))
    c = height - r
    for part, mat in lit_pair("#f5f0e6", (0, 0, c), 0.2, offset):
        asm.add(part, ellipsoid(r, (0, 0, c), 20, 12, mat))
    asm.piece("body", cylinder_piece(0.09, 0, 0.07, 12))
    asm.piece("body", cylinder_piece(r * 0.8, 0.07, height - 0.03, 12))
    return lamp_model("globe table lamp", asm, 1.0, small=True)


def table_lamp_random(rng: np.random.Generator) -> dict:
    """Parameters of a random table lamp."""
    return {"offset": noise_offset(rng)}


MODELS: dict[str, Maker] = {
    "table_lamp": designed(
        [
            (table_lamp, {}),
            (table_lamp, {"foot": "stick", "colour": "brass", "height": 0.56, "cloth": "#d9cdb6"}),
            (table_lamp, {"foot": "tripod", "colour": "oak", "height": 0.42, "drum": True}),
            (table_lamp, {"foot": "ball", "colour": "#e9e4da", "cloth": "#c9d4cf", "drum": True}),
            (banker, {}),
            (mushroom, {}),
            (table_lamp, {"colour": "#b5533c", "cloth": "#f3efe6"}),
        ],
        table_lamp_random,
    ),
}
