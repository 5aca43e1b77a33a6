"""Lanterns and oil lamps: a flame behind bars or in a glass chimney.

The mask sees a flame behind glass as glass: the middle of a chimney is left out while it burns, but
for the streaks that its edges reflect.
"""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, glowing, metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece, prism_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import box, lathe, loft, tube

from makers.candle_kinds import alight, burning, wick
from makers.candles import small_flame

PANE = (1.0, 1.0, 1.0, 0.38)


def seeded(rng: np.random.Generator) -> dict:
    return {"seed": 1}


def square_ring(half: float, z: float) -> np.ndarray:
    return np.array([(x * half, y * half, z) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))])


def frame_lantern(tone: str, wax: str, o, wooden: bool) -> Model:
    """Four posts on a base under a pointed roof with a ring, a thick candle in the middle."""
    half, high = 0.062, 0.185
    stuff = wood(tone, shade(tone, 0.62), 2) if wooden else plain(tone, 0.08, 60, o)
    roof = stuff if not wooden else plain("3a3c40", 0.08)
    body = [
        box(2 * half + 0.016, 2 * half + 0.016, 0.014, mat=stuff, bevel_width=0.002),
        box(2 * half, 2 * half, 0.012, (0, 0, high), stuff),
        loft(
            [
                square_ring(half + 0.012, high + 0.012),
                square_ring(half + 0.006, high + 0.022),
                square_ring(0.016, high + 0.07),
                square_ring(0.013, high + 0.082),
            ],
            mat=roof,
        ),
        tube(
            [
                (0, 0.024 * math.cos(a), high + 0.1 + 0.024 * math.sin(a))
                for a in np.linspace(0, math.tau, 11)[:-1]
            ],
            0.0032,
            4,
            closed=True,
            mat=roof,
            up=(1.0, 0, 0),
        ),
    ]
    pieces = [
        box_piece((0, 0, 0.007), (2 * half + 0.016, 2 * half + 0.016, 0.014)),
        prism_piece(square_ring(half + 0.008, 0)[:, :2], high, high + 0.02),
        prism_piece(square_ring(0.02, 0)[:, :2], high + 0.02, high + 0.082),
        cylinder_piece(0.03, 0.014, 0.1, 10),
    ]
    for x in (-1, 1):
        for y in (-1, 1):
            at = (x * (half - 0.005), y * (half - 0.005))
            body.append(box(0.011, 0.011, high - 0.012, (*at, 0.013), stuff))
            pieces.append(box_piece((*at, high / 2), (0.011, 0.011, high)))
    candle = Material(occlusion=0.45)
    candle.colour(candle.mottle(wax, 0.05, 50, o))
    z = 0.094
    profile = [(0, 0.013), (0.029, 0.013), (0.029, z), (0.025, z + 0.003), (0.012, z), (0, z)]
    body += [lathe(profile, 14, mat=candle), wick(z, 0.01)]
    flame, pool = burning(z + 0.001, wax, 0.018, 0.052, 10)
    title = f"{'wooden' if wooden else 'metal'} lantern with a candle"
    return alight(title, body, [flame], [pool], pieces, 0.8)


def glass_of(tint: str) -> Material:
    m = Material(occlusion=0.2)
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.4)), 0.0, 0.2, 0.9, 0)
    return m.colour(m.mix(shine, tint, "ffffff"))


def chimney(outline, low: float, high: float, n: int, tint="e4eef0"):
    """Glass parts: what is always drawn, the pane before the flame, the streaks along it.

    outline: (radius, z), rising; the pane covers low to high.
    """
    zs, rs = [z for _, z in outline], [r for r, _ in outline]

    def part(a: float, b: float) -> list[tuple[float, float]]:
        inside = [(r, z) for r, z in outline if a + 1e-6 < z < b - 1e-6]
        return [(float(np.interp(a, zs, rs)), a), *inside, (float(np.interp(b, zs, rs)), b)]

    glass = glass_of(tint)
    ends = [lathe(part(a, b), n, mat=glass, discs=False) for a, b in ((zs[0], low), (high, zs[-1]))]
    pane = [lathe(part(low, high), n, mat=glass, discs=False)]
    streaks = []
    for k in range(4):
        a = math.tau * (k + 0.5) / 4
        path = [(r * math.cos(a), r * math.sin(a), z) for r, z in part(low - 0.003, high + 0.003)]
        streaks.append(tube(path, 0.0011, 3, mat=plain("eef6f8", 0.0)))
    return ends, pane, streaks


def glazed(title: str, body, fire, glow, glass: tuple, pieces, mass: float, **more) -> Model:
    """Like `alight`, with a chimney."""
    model = alight(title, [*body, *glass[2]], fire, glow, pieces, mass, prune=False, **more)
    model.parts["glass"] = Part(glass[0], rgba=PANE, collision="none", open=True)
    model.parts["pane"] = Part(glass[1], rgba=PANE, collision="none", open=True)
    model.variants = {
        "default": ["body", "glass", "pane"],
        "lit": ["body", "glass", "flame", "glow"],
    }
    return model


def burner_glow(z: float, radius: float) -> Mesh:
    """The top of the burner, lit from above."""
    m = glowing("ffb84a")
    return lathe([(0, z), (radius, z), (radius * 0.8, z + 0.001), (0, z + 0.001)], 8, mat=m)


def storm_lantern(tone: str, o) -> Model:
    """A hurricane lantern: tank, globe, hood, two side tubes and a bail."""
    paint = plain(tone, 0.07, 60, o)
    steel = metal("b8bcc0", "6a7076")
    tank = [(0, 0), (0.06, 0), (0.064, 0.006), (0.064, 0.036), (0.054, 0.05), (0.03, 0.056)]
    tank += [(0.028, 0.07), (0.034, 0.076), (0, 0.076)]
    hood = [(0, 0.178), (0.036, 0.178), (0.038, 0.19), (0.026, 0.2), (0.03, 0.214), (0, 0.226)]
    body = [lathe(tank, 16, mat=paint), lathe(hood, 12, mat=paint)]
    for s in (-1, 1):
        path = [(0, s * 0.056, 0.03), (0, s * 0.074, 0.07), (0, s * 0.072, 0.16)]
        path.append((0, s * 0.026, 0.208))
        body.append(tube(path, 0.0055, 5, mat=paint, up=(1.0, 0, 0)))
    bail = [
        (0.0, 0.074 * math.cos(a), 0.13 + 0.135 * math.sin(a)) for a in np.linspace(0, math.pi, 9)
    ]
    body.append(tube(bail, 0.0022, 4, mat=steel, up=(1.0, 0, 0)))
    body.append(wick(0.076, 0.01))
    globe = [(0.034, 0.076), (0.05, 0.1), (0.052, 0.125), (0.044, 0.155), (0.036, 0.178)]
    glass = chimney(globe, 0.088, 0.158, 12)
    pieces = [
        cylinder_piece(0.062, 0, 0.05, 12),
        cylinder_piece(0.05, 0.05, 0.178, 10, 0.04),
        cylinder_piece(0.03, 0.178, 0.226, 8, 0.012),
    ]
    fire = [small_flame(0.084, 0.056, 7)]
    return glazed("storm lantern", body, fire, [burner_glow(0.0762, 0.026)], glass, pieces, 1.0)


def lantern(form="frame", tone="#2c2e32", wax="#f3e7cf", seed=0) -> Model:
    """A lantern: "frame" (metal), "wood", or "storm"."""
    o = noise_offset(np.random.default_rng(seed))
    if form == "storm":
        return storm_lantern(tone, o)
    return frame_lantern(tone, wax, o, form == "wood")


def oil_lamp(form="font", tone="#2f7f5a", seed=0) -> Model:
    """A lamp with a glass chimney: a low "font" of glass, on a "pedestal", or brass with a
    "handle"."""
    o = noise_offset(np.random.default_rng(seed))
    brass = metal("d0a545", "8a6420")
    base = Material(occlusion=0.5)
    off = base.math("ABSOLUTE", base.math("ADD", base.normal(1), 0.45))
    shine = base.remap(off, 0, 0.2, 0.7, 0)
    base.colour(base.mix(shine, base.mottle(tone, 0.06, 40, o), "ffffff"))
    lift = 0.075 if form == "pedestal" else 0.0
    body = []
    if form == "pedestal":
        foot = [(0, 0), (0.055, 0), (0.056, 0.006), (0.02, 0.02), (0.011, 0.05), (0.02, lift)]
        body.append(lathe([*foot, (0, lift)], 12, mat=brass))
    profile = [(0, 0.0), (0.045, 0), (0.056, 0.012), (0.058, 0.03), (0.046, 0.052), (0.022, 0.06)]
    font = brass if form == "handle" else base
    body.append(lathe([(r, z + lift) for r, z in [*profile, (0, 0.06)]], 14, mat=font))
    z = lift + 0.06
    collar = [(0.02, z - 0.002), (0.021, z + 0.014), (0.031, z + 0.018), (0.031, z + 0.024)]
    body.append(lathe([*collar, (0, z + 0.026)], 12, mat=brass))
    knob = tube([(0.018, 0, z + 0.008), (0.042, 0, z + 0.008)], 0.0022, 4, mat=brass)
    body += [knob, lathe([(0, 0), (0.008, 0), (0.008, 0.003), (0, 0.003)], 8, mat=brass)]
    body[-1].turn(ry=math.pi / 2).move(0.041, 0, z + 0.008)
    if form == "handle":
        ear = [
            (0, 0.05 + 0.026 * math.sin(a), 0.034 - 0.024 * math.cos(a))
            for a in np.linspace(0.1, math.pi - 0.1, 8)
        ]
        body.append(tube(ear, 0.0035, 4, mat=brass, up=(1.0, 0, 0)))
    body.append(wick(z + 0.026, 0.008))
    outline = [(0.029, 0.02), (0.03, 0.032), (0.041, 0.06), (0.038, 0.082), (0.025, 0.115)]
    outline += [(0.022, 0.16), (0.024, 0.172)]
    glass = chimney([(r, q + z) for r, q in outline], z + 0.034, z + 0.1, 12)
    pieces = [
        cylinder_piece(0.05, lift, z, 12),
        cylinder_piece(0.036, z, z + 0.1, 10),
        cylinder_piece(0.024, z + 0.1, z + 0.172, 8),
    ]
    if lift:
        pieces += [cylinder_piece(0.055, 0, 0.008), cylinder_piece(0.018, 0.008, lift, 8)]
    fire = [small_flame(z + 0.032, 0.056, 7)]
    titles = {"font": "oil lamp", "pedestal": "tall oil lamp", "handle": "brass oil lamp"}
    glow = [burner_glow(z + 0.0262, 0.022)]
    return glazed(titles[form], body, fire, glow, glass, pieces, 0.9)


MODELS = {
    "lantern": Maker(
        lantern,
        seeded,
        count=6,
        presets=[
            {"form": "frame", "tone": "#2c2e32"},
            {"form": "frame", "tone": "#e8e4da", "wax": "#a8262c"},
            {"form": "wood", "tone": "#b98552"},
            {"form": "storm", "tone": "#b8241c"},
            {"form": "storm", "tone": "#2f5f4a"},
            {"form": "frame", "tone": "#b4682c", "wax": "#efe2c8"},
        ],
    ),
    "oil_lamp": Maker(
        oil_lamp,
        seeded,
        count=5,
        presets=[
            {"form": "font", "tone": "#2f7f5a"},
            {"form": "pedestal", "tone": "#c8d8dc"},
            {"form": "handle"},
            {"form": "font", "tone": "#2f5f9a"},
            {"form": "pedestal", "tone": "#8a2430"},
        ],
    ),
}
