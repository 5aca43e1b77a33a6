"""Portable electric hobs with one plate or two."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, glowing, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, Support, box_piece, cylinder_piece, round_polygon
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe, tube

from makers.convex import few_corners
from makers.joinery import steel
from makers.soft_forms import bars, bent
from makers.stove import _zone_picture

SHINE = (1.6, 1.6, 1.6, 1.0)


def _red(x: float, y: float, z: float, radius: float) -> Material:
    """Iron that glows, brightest in its middle."""
    hot = Material(occlusion=0.0)
    fade = hot.remap(hot.distance((x, y, z)), 0, radius)
    return hot.colour(hot.ramp(fade, [(0, "#ff7a2e"), (0.6, "#ff4a18"), (1, "#d8280c")]))


def _disc(x: float, y: float, r: float, top: float, face: Material) -> Mesh:
    """A thin glass disc that wears a picture."""
    disc = lathe(
        [(r, top - 0.004), (r, top), (0, top)],
        18,
        mats=[plain("#131416", 0.02), face],
        mat_of_segment=[0, 1],
        weight=1.4,
    )
    disc.label_uv = [
        [(0.5 + disc.v[i][1] / (2 * r), 0.5 - disc.v[i][0] / (2 * r)) for i in corners]
        for corners in disc.f
    ]
    return disc.move(x, y, 0)


def _plate(
    kind: str, x: float, y: float, r: float, top: float, n: int
) -> tuple[list[Mesh], list[Mesh], float]:
    """What is there, what glows, and the height on which a pot stands; n: corners of its iron."""
    if kind == "glass":
        cold, hot = label(_zone_picture(False)), label(_zone_picture(True), occlusion=0.0)
        return (
            [_disc(x, y, r, top + 0.002, cold)],
            [_disc(x, y, r * 1.05, top + 0.004, hot)],
            top + 0.002,
        )
    if kind == "coil":
        rise, t = top + 0.014, np.linspace(0, 1, 21)
        a, radius = 2 * math.pi * 2.4 * t, r * (0.2 + 0.78 * t)
        path = np.c_[x + radius * np.cos(a), y + radius * np.sin(a), np.full(len(t), rise - 0.0075)]
        black, chrome = plain("#2a2a2c", 0.1, 60), metal("c9cdd1", "7b8187", (1, 1, 1), 30)
        bowl = [(r * 1.14, top), (r * 1.16, top + 0.006), (r * 1.04, top + 0.008)]
        bowl += [(r * 0.9, top + 0.003), (0, top + 0.003)]
        cold = [
            lathe(bowl, 12, mat=chrome).move(x, y, 0),
            tube(path, 0.0075, 4, mat=black, up=(0, 0, 1)),
        ]
        path[:, 2] += 0.001
        pool = [(r, top + 0.001), (r, top + 0.005), (0, top + 0.005)]
        lit = [
            tube(path, 0.009, 4, mat=_red(x, y, rise, r), up=(0, 0, 1)),
            lathe(pool, 12, mat=glowing("#b8340e")).move(x, y, 0),
        ]
        return cold, lit, rise - 0.003
    rise, iron, rim = top + 0.016, plain("#232427", 0.1, 60), metal("b9bdc0", "7d8286")
    collar = [(r * 1.1, top), (r * 1.08, top + 0.008), (r, top + 0.008)]
    disc = [(r, top + 0.004), (r, rise - 0.002), (r * 0.96, rise), (0, rise)]
    skin = [(r, top + 0.008), (r * 1.015, rise - 0.001), (r * 0.97, rise + 0.0015)]
    cold = [lathe(collar, n, mat=rim).move(x, y, 0), lathe(disc, n, mat=iron).move(x, y, 0)]
    lit = [lathe([*skin, (0, rise + 0.0015)], n, mat=_red(x, y, rise, r)).move(x, y, 0)]
    return cold, lit, rise


def hot_plate(kind: str, plates: int, colour: str, knob: str, offset: tuple) -> Model:
    """A hob on four feet, its knobs in front: plates of cast "iron", a "coil", or under "glass".
    Variant `on`: they glow red."""
    double = plates == 2
    x, y, foot, top = 0.13, 0.25 if double else 0.13, 0.012, 0.072
    enamel = steel(20) if colour == "steel" else plain(colour, 0.02, 12, offset)
    dark = plain("#1f2023", 0.03)
    body = [box(2 * x, 2 * y, top - foot, (0, 0, foot), enamel, 0.007)]
    if kind == "glass":
        body.append(box(2 * x - 0.016, 2 * y - 0.016, 0.004, (0, 0, top - 0.003), dark, 0.001))
    for sx in (-1, 1):
        for sy in (-1, 1):
            body.append(
                lathe([(0, 0), (0.013, 0), (0.015, foot + 0.004)], 6, mat=dark).move(
                    sx * (x - 0.03), sy * (y - 0.03), 0
                )
            )
    spots = [(-0.012, -0.122, 0.092), (-0.012, 0.122, 0.076)] if double else [(-0.012, 0.0, 0.094)]
    lit: list[Mesh] = []
    supports, pieces = [], [box_piece((0, 0, (foot + top) / 2), (2 * x, 2 * y, top - foot))]
    knob_mat, mark, bulb = plain(knob, 0.03), plain("#f2f2ef", 0), plain("#3a1210", 0)
    for k, (px, py, r) in enumerate(spots):
        cold, hot, height = _plate(kind, px, py, r, top, 13 if double else 16)
        body += cold
        lit += hot
        name = f"plate_{k + 1}" if double else "plate"
        ring = [(px + u, py + v) for u, v in round_polygon(r * 0.9)]
        supports.append(Support(name, height, ring))
        pieces.append(cylinder_piece(r, top - 0.005, height, 12) + np.array([px, py, 0]))
        turned = [(0, 0), (0.024, 0), (0.022, 0.008), (0.018, 0.024), (0, 0.024)]
        at = (x - 0.001, py, 0.042)
        body.append(lathe(turned, 7, mat=knob_mat).turn(ry=math.pi / 2).move(*at))
        body.append(box(0.002, 0.004, 0.018, (x + 0.0235, py, 0.044), mark))
        body.append(box(0.003, 0.014, 0.008, (x, py + 0.045, 0.038), bulb))
        lit.append(box(0.005, 0.016, 0.01, (x, py + 0.045, 0.037), glowing("#ff4a1c")))
    route = [(-x + 0.003, 0.03, 0.03), (-x - 0.02, 0.03, 0.02), (-x - 0.03, 0.0, 0.0048)]
    route += [(-x - 0.03, -0.05, 0.0048), (-x - 0.028, -0.08, 0.0048)]
    body.append(bent(route, 0.0048, dark, 4, 3))
    profile = [(0, 0), (0.008, 0), (0.0155, 0.014), (0.0165, 0.034), (0, 0.034)]
    pins = bars([[(0.032, q * 0.008, 0), (0.05, q * 0.008, 0)] for q in (-1, 1)], 0.003, metal(), 4)
    for mesh in (lathe(profile, 7, mat=dark).turn(ry=math.pi / 2), *pins):
        body.append(mesh.turn(rz=-math.pi / 2).move(-x - 0.028, -0.078, 0.0165))
    pieces.append(few_corners(body[-3].v, 20))
    pieces += [
        box_piece((sx * (x - 0.03), sy * (y - 0.03), foot / 2), (0.028, 0.028, foot))
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    parts = {
        "body": Part(body, collision=pieces),
        "glow": Part(lit, collision="none", rgba=SHINE),
    }
    names = {"iron": "cast-iron", "coil": "coil", "glass": "glass-ceramic"}
    return Model(
        f"{'double' if double else 'single'} {names[kind]} hot plate",
        parts,
        mass=4.2 if double else 2.0,
        variants={"default": ["body"], "on": ["body", "glow"]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["glow"]},
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
        ],
        supports=supports,
        texture_size=128,
    )


def hot_plate_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "iron",
        "plates": 1,
        "colour": pick(rng, ["#f1f1ee", "#26272b"]),
        "knob": "#2a2b2e",
        "offset": noise_offset(rng),
    }


MODELS = {
    "hot_plate": Maker(
        hot_plate,
        hot_plate_random,
        4,
        [
            {"colour": "#f1f1ee"},
            {"plates": 2, "colour": "steel", "knob": "#26272a"},
            {"kind": "coil", "colour": "#2b2c30", "knob": "#d5d7d9"},
            {"kind": "glass", "plates": 2, "colour": "#3a3c41", "knob": "#d5d7d9"},
        ],
    ),
}
