"""Jars of jam; each can break."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import Material, label, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.shapes import TAU, lathe, loft, tube

from makers.breakage import BROKEN
from makers.pack_parts import hollow, puddle, shards_of, vessel

FRUIT = {  # word: (jam, motif, ink)
    "STRAWBERRY": ("#c0142a", "strawberry", "#b01024"),
    "APRICOT": ("#f08a1c", "apricot", "#b8560c"),
    "BLUEBERRY": ("#3a2a6a", "blueberry", "#33337a"),
    "CHERRY": ("#8a0c20", "cherry", "#8a0c20"),
    "ORANGE": ("#f0a020", "orange", "#c8640c"),
}

JARS = {  # shape: (height, radius, power, corners, shares of height and radius)
    "round": (
        0.115,
        0.036,
        2.0,
        20,
        [(0, 0.9), (0.04, 1), (0.16, 1), (0.62, 1), (0.74, 1), (0.82, 0.84), (0.99, 0.82)],
    ),
    "squat": (
        0.078,
        0.043,
        2.0,
        20,
        [(0, 0.92), (0.05, 1), (0.14, 1), (0.62, 1), (0.7, 1), (0.8, 0.9), (0.99, 0.88)],
    ),
    "hex": (
        0.105,
        0.041,
        2.0,
        6,
        [(0, 0.92), (0.05, 1), (0.16, 1), (0.62, 1), (0.72, 0.98), (0.82, 0.82), (0.99, 0.8)],
    ),
    "tall": (
        0.165,
        0.034,
        2.0,
        20,
        [(0, 0.9), (0.03, 1), (0.2, 1), (0.58, 1), (0.7, 1), (0.8, 0.8), (0.99, 0.78)],
    ),
    "square": (
        0.1,
        0.038,
        5.0,
        20,
        [(0, 0.92), (0.05, 1), (0.16, 1), (0.62, 1), (0.72, 0.98), (0.82, 0.82), (0.99, 0.8)],
    ),
}


def jelly(colour: str, height: float) -> Material:
    """Jam seen through the glass, with pips, and the clear rim above it."""
    m = Material(occlusion=0.5)
    lumps = m.ramp(
        m.noise(120, 3), [(0.35, shade(colour, 0.6)), (0.5, colour), (0.65, shade(colour, 1.4))]
    )
    full = m.mix(m.remap(m.axis(2), 0.77 * height, 0.79 * height), lumps, "dfeaec")
    band = m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5))
    return m.colour(m.mix(m.remap(band, 0.02, 0.1, 0.55, 0), full, "ffffff"))


def gingham(colour: str) -> Material:
    m = Material()
    waves = [
        m.remap(m.math("SINE", m.math("MULTIPLY", m.axis(i), 700.0)), -0.1, 0.1, 0, 0.5)
        for i in (0, 1)
    ]
    return m.colour(m.mix(m.math("ADD", *waves), "fbf6ee", colour))


def cloth_cover(radius: float, z: float, colour: str) -> list[Mesh]:
    """A checked cloth over the lid, tied with string, its edge in folds."""
    n = 20
    t = np.arange(n) * TAU / n
    wave = 1 + 0.09 * (np.arange(n) % 2)
    steps = [
        (1.45, -0.012, 1.0),
        (1.4, -0.008, 1.0),
        (1.06, -0.004, 0.0),
        (1.04, 0.008, 0.0),
        (0.9, 0.012, 0.0),
        (0.3, 0.0135, 0.0),
    ]
    rings = []
    for k, dz, w in steps:
        q = radius * k * (1 + (wave - 1) * w)
        rings.append(np.c_[q * np.cos(t), q * np.sin(t), z + dz + 0.003 * w * (np.arange(n) % 2)])
    cover = loft(rings, mat=gingham(colour))
    cover.bake_uv = None
    loop = np.c_[
        1.1 * radius * np.cos(t[::2]), 1.1 * radius * np.sin(t[::2]), np.full(n // 2, z - 0.0015)
    ]
    return [cover, tube(loop, 0.0022, 4, closed=True, mat=plain("#c8a878", 0.1), weight=0.5)]


def jam_jar(
    shape: str,
    fruit: str,
    lid: str,
    paper: str,
    cover: str = "",
    opened: bool = False,
    seed: int = 4,
) -> Model:
    """A jar with a paper label. cover: a cloth's colour; opened: lid beside it, spoon in it."""
    h, r, power, n, steps = JARS[shape]
    colour, motif, ink = FRUIT[fruit]
    w = 270
    image, d = labels.canvas(3 * w, 240, paper)
    for k in range(3):
        x = k * w
        d.rectangle((x + 5, 6, x + w - 6, 233), outline=ink, width=6)
        labels.text(d, "JAM", (x + 24, 14, x + w - 24, 104), "bold", ink)
        labels.text(d, fruit, (x + 18, 106, x + w - 18, 148), "bold", ink)
        getattr(groceries, motif)(d, x + w / 2, 190, 38)
    sections = [(z * h, k * r, k * r, power if z < 0.8 else 2.0) for z, k in steps]
    which = [0, 0, 1, 0, 0, 0]
    mats = [jelly(colour, h), label(image)]
    body, shell = (
        vessel(sections, mats, which, n),
        hollow(sections, mats, which, 0.004, max(6, min(n, 10))),
    )
    if n == 6:
        body.flat()
        shell.flat()
    top = steps[-1][1] * r
    tin = plain(lid, 0.04) if lid != "gold" else metal("d8b84a", "8f7430")
    profile = [
        (0, 0.86 * h),
        (top * 1.08, 0.86 * h),
        (top * 1.08, 0.985 * h),
        (top * 1.0, h),
        (0, h),
    ]
    closing = [
        lathe(profile, 20, mat=tin, rib=lambda k, i: 1 - 0.025 * (i % 2) if k in (1, 2) else 1)
    ]
    pieces = [cylinder_piece(r, 0, 0.74 * h, 12), cylinder_piece(r, 0.74 * h, h, 12, top)]
    if cover:
        closing = cloth_cover(top * 1.1, 0.95 * h, cover)
    if opened:
        level = lathe(
            [
                (0, 0.8 * h),
                (top * 0.95, 0.8 * h),
                (top * 0.95, 0.992 * h),
                (top * 0.85, 0.994 * h),
                (top * 0.85, 0.95 * h),
                (0, 0.94 * h),
            ],
            18,
            mat=plain(colour, 0.3, 160),
        )
        closing[0].move(0, 0, -0.86 * h).turn(ry=0.0).move(0.0, r + top + 0.016)
        steel = metal("c9ced2", "868c91")
        spoon = tube(
            [(0, 0, 0.9 * h), (-0.012, -0.01, 1.2 * h), (-0.034, -0.024, 1.72 * h)],
            [0.003, 0.0028, 0.005],
            6,
            mat=steel,
        )
        closing += [level, spoon]
        pieces.append(
            cylinder_piece(top * 1.08, 0, 0.14 * h, 12) + np.array([0, r + top + 0.016, 0])
        )
    blob = puddle(0.95 * r, colour, seed, 0.011)
    return Model(
        title=f"{'opened ' if opened else ''}jar of {fruit.lower()} jam",
        parts={
            "body": Part([body.weigh(1.3), *closing], collision=pieces),
            "shards": shards_of(shell, r, h, "#e6f4f2", seed, 0.9),
            "spill": Part([blob], collision="none"),
        },
        mass=round(0.15 + math.pi * r * r * h * 1150, 2),
        friction=0.5,
        variants={"default": ["body"], "broken": ["shards", "spill"]},
        states=BROKEN,
    )


MODELS = {
    "jam_jar": Maker(
        jam_jar,
        lambda rng: {},
        count=7,
        presets=[
            {"shape": "round", "fruit": "STRAWBERRY", "lid": "#c8202c", "paper": "#fbf4e4"},
            {"shape": "hex", "fruit": "APRICOT", "lid": "gold", "paper": "#fffaf0"},
            {"shape": "squat", "fruit": "CHERRY", "lid": "#c8202c", "paper": "#fbf4e4"},
            {
                "shape": "round",
                "fruit": "CHERRY",
                "lid": "#c8202c",
                "paper": "#fbf4e4",
                "cover": "#c8202c",
            },
            {"shape": "squat", "fruit": "ORANGE", "lid": "#c8202c", "paper": "#fffaf0"},
            {
                "shape": "squat",
                "fruit": "STRAWBERRY",
                "lid": "#c8202c",
                "paper": "#fff4f0",
                "opened": True,
            },
            {"shape": "hex", "fruit": "STRAWBERRY", "lid": "gold", "paper": "#fbf4e4"},
        ],
    ),
}
