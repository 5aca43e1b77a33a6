"""Kitchen blenders: a motor base with a jug, round or square, and a personal one with its cup."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.model import Maker, Model, cylinder_piece
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe, loft, rounded_rectangle, spline, tube

from .joinery import Assembly

Offset = tuple[float, float, float]


def _glass(z0: float, z1: float, content: str | None, level: float) -> Material:
    """Clear plastic with something blended up to a level; graduation marks as lighter bands."""
    m = Material()
    t = m.remap(m.axis(2), z0, z1)
    clear = [(level + 0.03, "#b9d0d8"), (0.86, "#cfe2e7"), (1, "#e6f1f3")]
    low = [(0, "#9fb9c3"), (level, "#b4ccd5")]
    if content:
        low = [(0, content), (level, content), (level + 0.015, "#ffffff")]
    base = m.ramp(t, low + clear)
    marks = m.math("SINE", m.math("MULTIPLY", m.axis(2), 330))
    m.colour(m.mix(m.remap(marks, 0.93, 1.0, 0, 0.35), base, "#ffffff"))
    return m


def _square_ring(side: float, r: float, z: float) -> np.ndarray:
    outline = rounded_rectangle(side, side, r, 3)
    return np.c_[outline, np.full(len(outline), z)]


def stand_blender(
    form: str = "round",
    colour: str = "#26282b",
    content: str | None = "#7fae3f",
    level: float = 0.55,
    offset: Offset = (0, 0, 0),
) -> Model:
    """form: "round" jug, "square" jug, "personal" (an inverted cup) or "retro" (a chrome cone)."""
    asm = Assembly()
    shell = (
        metal("c8ccd0", "7f858b", (1, 8, 1), 18)
        if colour == "steel"
        else plain(colour, 0.025, 14, offset)
    )
    dark, chrome = plain("#232528", 0.03), metal("cfd3d6", "848a90", (1, 1, 4), 30)
    n, handle = 20, True
    if form == "square":
        rings = [_square_ring(s, 0.03, z) for s, z in ((0.19, 0), (0.2, 0.02), (0.185, 0.12))]
        rings += [_square_ring(0.15, 0.03, 0.165), _square_ring(0.12, 0.03, 0.17)]
        asm.add("body", loft(rings, shell))
        z0, z1, r0, r1 = 0.175, 0.4, 0.058, 0.078
        jug = [
            _square_ring(2 * r, 0.022, z) for r, z in ((r0, z0), (r0 + 0.002, z0 + 0.02), (r1, z1))
        ]
        asm.add("body", loft(jug, _glass(z0, z1, content, level), weight=1.4))
        lid = [
            _square_ring(2 * r, 0.022, z) for r, z in ((r1 + 0.004, z1), (r1 + 0.004, z1 + 0.02))
        ]
        lid += [_square_ring(0.07, 0.02, z1 + 0.024), _square_ring(0.06, 0.02, z1 + 0.045)]
        asm.add("body", loft(lid, dark))
        base = 0.095
    elif form == "personal":
        base_p = [(0, 0), (0.06, 0), (0.066, 0.012), (0.06, 0.08), (0.052, 0.12), (0, 0.12)]
        asm.add("body", lathe(base_p, n, mat=shell))
        z0, z1, r0, r1, handle = 0.125, 0.3, 0.043, 0.034, False
        collar = [(0, 0.115), (0.05, 0.115), (0.05, 0.15), (0.044, 0.152)]
        asm.add("body", lathe([*collar, (0, 0.152)], n, mat=chrome))
        cup = [(0, 0.14), (r0, 0.14), (r0, 0.21), (0.04, 0.27), (r1, 0.293), (0.02, z1), (0, z1)]
        asm.add(
            "body", lathe(cup, n, mat=_glass(0.14, z1, content, level), discs=False, weight=1.4)
        )
        base = 0.062
    else:
        retro = form == "retro"
        foot = [(0, 0), (0.088, 0), (0.092, 0.012), (0.088, 0.06), (0.07, 0.13), (0.058, 0.15)]
        if retro:
            foot = [(0, 0), (0.082, 0), (0.085, 0.012), (0.07, 0.024), (0.064, 0.03)]
            foot += [(0.058, 0.1), (0.05, 0.165), (0.056, 0.185)]
        top = foot[-1][1]
        asm.add("body", lathe([*foot, (0, top)], n, mat=shell))
        z0, z1, r0, r1 = top, top + (0.21 if retro else 0.2), 0.048, (0.062 if retro else 0.075)
        collar = [
            (0, z0 - 0.002),
            (r0 + 0.014, z0 - 0.002),
            (r0 + 0.012, z0 + 0.024),
            (0, z0 + 0.024),
        ]
        asm.add("body", lathe(collar, n, mat=dark))
        jug = [(0, z0 + 0.02), (r0, z0 + 0.02), (r1, z1 - 0.004), (r1 + 0.004, z1), (0, z1)]
        asm.add("body", lathe(jug, n, mat=_glass(z0, z1, content, level), discs=False, weight=1.4))
        lid = [(0, z1), (r1 + 0.005, z1), (r1 + 0.005, z1 + 0.016), (r1 - 0.01, z1 + 0.022)]
        lid += [(0.03, z1 + 0.022), (0.027, z1 + 0.045), (0, z1 + 0.047)]
        asm.add("body", lathe(lid, n, mat=chrome if retro else dark))
        base = 0.09
    if handle:
        y0, y1 = 0.9 * r1, r1 + 0.055
        path = [(0, y0, z1 - 0.02), (0, y1, z1 - 0.025), (0, y1 - 0.004, (z0 + z1) / 2)]
        path.append((0, r0 + 0.008, z0 + 0.05))
        asm.add("body", tube(spline(path, 3), 0.011, 7, mat=dark))
        low, high = (-0.011, r1, z0 + 0.05), (0.011, y1 + 0.01, z1)
        asm.solid("body", low, high)
    # knob and buttons on the front of the base
    tilt = 0.16 if form != "personal" else 0.0
    dial = [(0, 0), (0.024, 0), (0.022, 0.016), (0, 0.018)]
    x = {"square": 0.096, "retro": 0.06, "personal": 0.06}.get(form, 0.083)
    if form == "personal":
        dial = [(0, 0), (0.014, 0), (0.013, 0.008), (0, 0.009)]
    knob = lathe(dial, 12, mat=chrome if form != "retro" else dark)
    asm.add("body", knob.turn(ry=math.pi / 2 - tilt).move(x - 0.004, 0, 0.07))
    if form in ("round", "square"):
        picture, draw = labels.canvas(160, 40, "#e9ebec" if colour != "#e9e7e1" else "#303336")
        ink = "#26292c" if colour != "#e9e7e1" else "#f2f2f2"
        labels.text(draw, "BLENDER", (8, 5, 152, 35), "bold", ink)
        sign = box(
            0.006, 0.09, 0.022, (0, 0, -0.011), dark, labels={"+x": label(picture)}, weight=2.0
        )
        asm.add(
            "body", sign.turn(ry=-tilt).move(x + 0.005 if form == "round" else x + 0.002, 0, 0.03)
        )
    asm.piece("body", cylinder_piece(base, 0, z0, 12, top_radius=base * 0.75))
    asm.piece("body", cylinder_piece(r0, z0, z1 + 0.03, 12, top_radius=r1))
    names = {"personal": "personal blender", "retro": "retro kitchen blender"}
    return Model(
        title=f"{names.get(form, f'kitchen blender, {form} jug')}{', full' if content else ''}",
        parts=asm.parts(),
        mass=1.6 if form == "personal" else 3.6,
        texture_size=128,
    )


def stand_blender_random(rng: np.random.Generator) -> dict:
    """Parameters of a random blender."""
    return {
        "form": pick(rng, ["round", "square", "personal", "retro"]),
        "colour": pick(rng, ["#26282b", "#e9e7e1", "#a8322c", "steel"]),
        "content": pick(rng, [None, "#7fae3f", "#d8607a", "#e0b060"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "stand_blender": Maker(
        stand_blender,
        stand_blender_random,
        8,
        [
            {"form": "round", "colour": "#e9e7e1", "content": "#d8607a"},
            {"form": "round", "colour": "#a8322c", "content": None},
            {"form": "square", "colour": "#26282b", "content": "#7fae3f"},
            {"form": "square", "colour": "steel", "content": None},
            {"form": "personal", "colour": "#3f4a55", "content": "#c65a86"},
            {"form": "personal", "colour": "#2f8f86", "content": None},
            {"form": "retro", "colour": "steel", "content": "#e8b35a"},
            {"form": "retro", "colour": "#9fd0c6", "content": None},
        ],
    ),
}
