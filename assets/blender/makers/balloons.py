"""Balloons without air."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import TAU, box, lathe, loft, superellipse, tube

from makers.choking import loose


def limp_balloon(paint: str, length: float, rng: np.random.Generator) -> list[Mesh]:
    """A deflated balloon on its side: a wrinkled bag, a neck, a rolled lip. Along +X."""
    m = Material(occlusion=0.9)
    creases = m.noise(90, 3, distortion=1.0, offset=noise_offset(rng), stretch=(0.5, 1.6, 1))
    base = m.ramp(creases, [(0.36, shade(paint, 0.6)), (0.5, paint), (0.68, shade(paint, 1.15))])
    glint = m.remap(m.noise(60, 1, offset=noise_offset(rng)), 0.62, 0.68, 0, 0.55)
    m.colour(m.mix(glint, base, "ffffff"))
    s = length / 0.09
    phase = rng.uniform(0, TAU, 3)
    rings = []
    for x, wide, tall in (
        (-0.045, 0.004, 0.003),
        (-0.043, 0.012, 0.0055),
        (-0.03, 0.021, 0.0065),
        (-0.012, 0.0235, 0.0068),
        (0.006, 0.018, 0.0062),
        (0.018, 0.009, 0.0055),
        (0.026, 0.006, 0.005),
        (0.039, 0.0052, 0.0048),
    ):
        ring = superellipse(wide, tall, 2.2, 12)
        ripple = 1 + 0.09 * np.sin(3 * np.arange(12) * TAU / 12 * 2 + phase[0] + 90 * x)
        bend = 0.004 * math.sin(40 * x + phase[1])
        rings.append(np.c_[np.full(12, x), ring[:, 0] * ripple + bend, ring[:, 1] * ripple])
    bag = loft([r * s for r in rings], mat=m)
    lip_path = [
        (0.04 * s, 0.0075 * s * math.cos(a), 0.0055 * s * math.sin(a))
        for a in (TAU * k / 8 for k in range(8))
    ]
    bend = rings[-1][:, 1].mean() * s
    lip = tube(lip_path, 0.0022 * s, 4, closed=True, mat=plain(shade(paint, 0.85), 0.05))
    lip.move(y=float(bend))
    return [bag, lip]


def slack_balloon(paint: str) -> Model:
    """A tied balloon that has lost most of its air, its ribbon still on it."""
    m = Material(occlusion=0.7)
    soft = m.ramp(m.noise(60, 2, stretch=(0.4, 2, 2)), [(0.35, shade(paint, 0.85)), (0.6, paint)])
    shine = m.remap(m.distance((0.012, -0.012, 0.105)), 0.01, 0.017, 0.95, 0)
    m.colour(m.mix(shine, soft, "ffffff"))
    profile = [(0, 0), (0.028, 0.004), (0.05, 0.026), (0.056, 0.054), (0.046, 0.088)]
    profile += [(0.024, 0.118), (0.009, 0.134), (0.005, 0.14)]
    bag = lathe(
        [*profile, (0.013, 0.152), (0.009, 0.15), (0, 0.143)],
        18,
        mat=m,
        rib=lambda k, i: 1 + 0.1 * math.sin(5 * i) * (4 < k < 8),
    )
    bag.turn(ry=math.pi / 2 + 0.25).move(-0.07, 0, 0.052)
    low = bag.v[:, 2] < 0.006  # it sags on the floor
    bag.v[low, 2] = 0.006 - 0.1 * (0.006 - bag.v[low, 2])
    bag.move(z=-float(bag.v[:, 2].min()))
    line = [(0.068, 0, 0.015), (0.085, 0.02, 0.004), (0.07, 0.055, 0.004), (0.03, 0.075, 0.004)]
    line += [(0.0, 0.06, 0.004), (-0.02, 0.085, 0.004)]
    ribbon = tube(line, 0.0022, 4, mat=plain("#f6f4ee", 0))
    piece = box_piece((-0.005, 0, 0.05), (0.11, 0.1, 0.1))
    return Model("slack balloon", {"body": Part([bag, ribbon], collision=[piece])}, 0.004, 0.6)


def balloon_bag(paint: str) -> Model:
    """A bag of balloons as sold, a card on top."""
    image, draw = canvas(256, 320, "#eef6fb")
    colours = ["#d8202c", "#f2c21e", "#2fa04a", "#1f6fd8", "#e0609a", "#e8701c"]
    for k in range(14):
        x, y = 28 + 60 * (k % 4) + 24 * (k // 4 % 2), 120 + 54 * (k // 4)
        c = colours[(5 * k) % 6]
        draw.ellipse((x - 26, y - 28, x + 26, y + 24), fill=c, outline="#ffffff", width=2)
        draw.polygon([(x - 7, y + 20), (x + 7, y + 20), (x + 11, y + 44), (x - 11, y + 44)], fill=c)
        draw.ellipse((x - 14, y - 18, x - 5, y - 6), fill="#ffffff")
    draw.rectangle((0, 0, 256, 78), fill=paint)
    text(draw, "BALLOONS", (12, 8, 244, 52), "bold", "#ffffff")
    text(draw, "25 pieces", (60, 54, 196, 74), "sans", "#ffffff")
    skin = printed(image)
    bag = box(0.15, 0.12, 0.014, (0, 0, 0), plain("#dcebf3", 0.05), 0.004, 1, {"+z": skin})
    piece = box_piece((0, 0, 0.007), (0.15, 0.12, 0.014))
    return Model("bag of balloons", {"body": Part([bag], collision=[piece])}, 0.02, 0.5)


def balloon(kind: str, paints: list[str], length: float) -> Model:
    """'limp' ones (one to three) lying about, a 'slack' one, or a 'bag' of them."""
    if kind != "limp":
        return (slack_balloon if kind == "slack" else balloon_bag)(paints[0])
    rng = np.random.default_rng(3)
    pieces = []
    turns, steps = (0.5, 2.6, -0.7), (0.0, 0.055, 0.11)
    for k, paint in enumerate(paints):
        piece = limp_balloon(paint, length, rng)
        low = min(float(m.v[:, 2].min()) for m in piece)
        for mesh in piece:
            mesh.keep_pattern().turn(rz=turns[k]).move(0, steps[k] - 0.024, -low)
        pieces.append(piece)
    name = "deflated balloon" + "s" * (len(paints) > 1)
    return loose(name, pieces, 0.003 * len(paints))


def balloon_random(rng: np.random.Generator) -> dict:
    return {"kind": "limp", "length": 0.1}


MODELS = {
    "balloon": Maker(
        balloon,
        balloon_random,
        6,
        [
            {"paints": ["#d8202c"]},
            {"paints": ["#1f6fd8", "#f2c21e"]},
            {"paints": ["#2fa04a"]},
            {"kind": "slack", "paints": ["#d8202c"]},
            {"paints": ["#e0609a", "#2f8fd8", "#f2c21e"]},
            {"kind": "bag", "paints": ["#d8202c"]},
        ],
    ),
}
