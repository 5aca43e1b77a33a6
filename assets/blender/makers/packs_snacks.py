"""Bags and tubes of chips."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import TAU, box, lathe, loft, tube

from makers import frozen
from makers.pack_parts import by_style, carton_piece, print_on, standing_bag, vessel
from makers.projection import project_label


def chips_face(w: int, h: int, ground: str, band: str, word: str, flavour: str, brand="Knusper"):
    motif = groceries.nachos if word == "NACHOS" else groceries.chips
    return groceries.face(w, h, ground, band, word, brand, motif, flavour)


def chip(radius: float, form: int, mat: Material) -> Mesh:
    """One curved chip, 4 mm thick."""
    rng = np.random.default_rng(form)
    n = 9
    t = np.arange(n) * TAU / n
    r = radius * (1 + 0.1 * np.sin(2 * t + rng.uniform(0, 6)))
    x, y = r * np.cos(t), 0.8 * r * np.sin(t)
    z = 7.0 * (x * x - 0.6 * y * y) * rng.uniform(0.6, 1.4)
    mesh = loft([np.c_[x, y, z], np.c_[x, y, z + 0.004]], mat=mat)
    mesh.bake_uv = None
    mesh.v[:, 2] -= mesh.v[:, 2].min()
    return mesh.keep_pattern()


def fried() -> Material:
    m = Material(occlusion=0.8)
    c = m.mottle("#f2c548", 0.12, 110)
    return m.colour(m.mix(m.remap(m.noise(60, 3), 0.58, 0.7, 0, 0.6), c, "c07a24"))


def chips_standing(
    word: str,
    flavour: str,
    ground: str,
    band: str,
    width: float,
    depth: float,
    h: float,
    top: str = "seal",
) -> Model:
    """A plump bag on its folded bottom; an opened one shows chips."""
    bag = standing_bag(width, depth, h, plain(ground, 0.06, 60), top, 0.28, 0.05, 11)
    print_on(bag, chips_face(300, int(300 * h / width), ground, band, word, flavour), width, h, 0.2)
    meshes = [bag.weigh(1.3)]
    if top == "open":
        mat = fried()
        for k in range(7):
            a, q = k * 2.4, 0.33 * math.sqrt((k + 0.4) / 7)
            one = chip(0.026, k, mat).turn(rx=0.9 * math.sin(k * 2), ry=0.9 * math.cos(k * 3), rz=k)
            meshes.append(
                one.move(
                    depth * q * math.cos(a), width * q * math.sin(a), 0.88 * h + 0.008 * (k % 3)
                )
            )
        for k, (x, y) in enumerate(((0.105, -0.03), (0.085, 0.055), (0.12, 0.03))):
            meshes.append(chip(0.027, 20 + k, mat).turn(rz=k * 2.0).move(x, y))
    return Model(
        title=f"{'opened ' if top == 'open' else ''}bag of {word.lower()}",
        parts={
            "body": Part(
                meshes, collision="hull" if top != "open" else [carton_piece(depth, width, h)]
            )
        },
        mass=0.19,
        friction=0.5,
    )


def chips_lying(
    word: str, flavour: str, ground: str, band: str, length: float, width: float, height: float
) -> Model:
    """A pillow bag on its back, puffed with air, crimped at both ends."""
    bag = frozen.pillow(length, width, height, plain(ground, 0.06, 60), np.random.default_rng(3))
    art = chips_face(300, int(300 * length / width), ground, band, word, flavour)
    project_label(bag, label(art), "+z", (0, 0), (width, 0.86 * length), 0.1)
    return Model(
        title=f"bag of {word.lower()}",
        parts={"body": Part([bag.weigh(1.3)], collision="hull")},
        mass=0.17,
        friction=0.5,
    )


def chips_spilled(word: str, flavour: str, ground: str, band: str) -> Model:
    """A bag lying torn open, its chips slid out in front."""
    length, width, height = 0.2, 0.18, 0.07
    n = 20
    t = np.arange(n) * TAU / n
    steps = [
        (-0.5, 0.98, 0.05),
        (-0.46, 1.0, 0.1),
        (-0.3, 0.97, 0.8),
        (0.0, 0.94, 1.0),
        (0.34, 0.95, 0.82),
        (0.5, 1.0, 0.7),
        (0.5, 0.94, 0.62),
        (0.34, 0.9, 0.7),
    ]
    rings = []
    for x, w, d in steps:
        wave = 1 + 0.06 * np.sin(5 * t + 9 * x)
        z = height / 2 * d * np.sin(t) * wave
        rings.append(np.c_[np.full(n, x * length), width / 2 * w * np.cos(t), (z - z.min()) * 1.0])
    bag = loft(
        rings,
        mats=[plain(ground, 0.06, 60), metal("d8dcdf", "9aa2a8")],
        mat_of_face=lambda k, i: int(k >= 5),
    )
    bag.bake_uv = None
    art = label(chips_face(300, 340, ground, band, word, flavour))
    project_label(
        bag,
        art,
        "+z",
        (0, 0),
        (width, 0.9 * length),
        0.1,
        lambda c: c[2] > 0.4 * height * 0.5 and c[0] < 0.48 * length,
    )
    mat = fried()
    spots = [
        (0.1, 0.0, 0.01),
        (0.085, 0.045, 0.006),
        (0.085, -0.045, 0.006),
        (0.12, 0.02, 0.004),
        (0.135, -0.035, 0),
        (0.15, 0.02, 0),
        (0.128, 0.065, 0),
        (0.175, -0.012, 0),
        (0.115, -0.075, 0),
    ]
    meshes = [bag.weigh(1.3)]
    for k, (x, y, z) in enumerate(spots):
        meshes.append(chip(0.026, k, mat).turn(rz=k * 1.7).move(x, y, z))
    return Model(
        title=f"opened bag of {word.lower()}, some spilled",
        parts={
            "body": Part(
                meshes,
                collision=[
                    box_piece((0, 0, 0.38 * height), (0.9 * length, 0.86 * width, 0.7 * height)),
                    box_piece((0.13, 0, 0.006), (0.08, 0.15, 0.012)),
                ],
            )
        },
        mass=0.12,
        friction=0.5,
    )


def chips_tube(word: str, flavour: str, ground: str, band: str, opened: bool) -> Model:
    """Stacked chips in a cardboard tube."""
    r, h = 0.038, 0.235
    art = groceries.wrapped(3, 240, 620, ground, band, word, "Stapler", groceries.chips, flavour)
    body = vessel(
        [
            (0, r, r, 2.0),
            (0.004, r, r, 2.0),
            (h - 0.012, r, r, 2.0),
            (h - 0.008, 1.02 * r, 1.02 * r, 2.0),
        ],
        [metal("c9ced2", "868c91"), label(art)],
        [0, 1, 0],
        22,
    )
    z = h - 0.009
    cap = lathe(
        [
            (0, z),
            (1.06 * r, z),
            (1.06 * r, h - 0.001),
            (1.0 * r, h),
            (0.92 * r, h - 0.003),
            (0, h - 0.003),
        ],
        22,
        mat=plain("#f0f0ec", 0.03),
    )
    return Model(
        title=f"tube of {word.lower()}",
        parts={"body": Part([body.weigh(1.2), cap], collision=[cylinder_piece(r, 0, h, 14)])},
        mass=0.22,
        friction=0.5,
    )


def chips_clipped(word: str, flavour: str, ground: str, band: str) -> Model:
    """A begun bag, rolled down, with a clip."""
    width, depth, h = 0.19, 0.085, 0.15
    bag = standing_bag(width, depth, h, plain(ground, 0.06, 60), "seal", 0.2, 0.05, 12)
    print_on(bag, chips_face(300, int(300 * h / width), ground, band, word, flavour), width, h, 0.2)
    roll = tube(
        [(0, y * width, h + 0.004) for y in (-0.5, 0, 0.5)], 0.015, 8, mat=plain(ground, 0.08, 60)
    )
    clip = [
        box(0.006, 0.14, 0.026, (s * 0.017, 0, h - 0.006), plain("#2a6fc4", 0.03), 0.002)
        for s in (-1, 1)
    ]
    hinge = tube(
        [(s * 0.017, 0.072, h + 0.007) for s in (-1, 0, 1)], 0.011, 8, mat=plain("#2a6fc4", 0.03)
    )
    return Model(
        title=f"bag of {word.lower()}, clipped shut",
        parts={"body": Part([bag.weigh(1.3), roll, *clip, hinge], collision="hull")},
        mass=0.12,
        friction=0.5,
    )


PAPRIKA = {"word": "CHIPS", "flavour": "PAPRIKA", "ground": "#d8281e", "band": "#f2b21c"}

SALTED = {"word": "CHIPS", "flavour": "SALTED", "ground": "#f2c21c", "band": "#c8202c"}

ONION = {"word": "CHIPS", "flavour": "SOUR CREAM", "ground": "#2f8a3a", "band": "#14501e"}

NACHOS = {"word": "NACHOS", "flavour": "CHEESE", "ground": "#e8661c", "band": "#1c1c24"}

MODELS = {
    "chips_bag": Maker(
        by_style(
            "chips_bag",
            {
                "stand": chips_standing,
                "lying": chips_lying,
                "spill": chips_spilled,
                "tube": chips_tube,
                "clip": chips_clipped,
            },
        ),
        lambda rng: {},
        count=8,
        presets=[
            {"style": "stand", **PAPRIKA, "width": 0.2, "depth": 0.085, "h": 0.27},
            {"style": "lying", **SALTED, "length": 0.27, "width": 0.2, "height": 0.075},
            {"style": "tube", **ONION, "opened": False},
            {"style": "spill", **PAPRIKA},
            {"style": "stand", **SALTED, "width": 0.17, "depth": 0.085, "h": 0.16, "top": "open"},
            {"style": "clip", **NACHOS},
            {"style": "lying", **NACHOS, "length": 0.27, "width": 0.2, "height": 0.075},
            {"style": "tube", **PAPRIKA, "opened": False},
        ],
    ),
}
