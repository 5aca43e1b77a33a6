"""Soap dispenser, shampoo, perfume."""

from __future__ import annotations

import numpy as np
from labels import bottles
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.model import (
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    TAU,
    lathe,
    loft,
    rounded_rectangle,
    spline,
    tube,
)

from makers.bottle_shapes import oval_body
from makers.projection import project_label


def soap_dispenser(round_body: bool, height: float, body: str, ink: str, pump: str) -> Model:
    """A dispenser of hand soap, of glazed stoneware: nobody takes it for shampoo."""
    s = height / 0.17
    colour = plain(body, 0.03)
    label = printed(bottles.soap_label(body, ink), base=body)
    if round_body:
        profile = [
            (0, 0.001),
            (0.031, 0),
            (0.034, 0.003),
            (0.034, 0.095 * s),
            (0.03, 0.105 * s),
            (0.014, 0.114 * s),
            (0.014, 0.12 * s),
        ]
        bottle = lathe(profile, 22, mat=colour, start=-TAU / 2)
        width, pieces = (
            0.06,
            [cylinder_piece(0.034, 0, 0.1 * s, 14), cylinder_piece(0.014, 0.1 * s, 0.15 * s, 8)],
        )
    else:
        steps = [
            (0, 0.94, 0.92),
            (0.003, 1, 1),
            (0.09, 1, 1),
            (0.104, 0.9, 0.88),
            (0.114, 0.36, 0.6),
            (0.12, 0.34, 0.56),
        ]
        bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.078, 0.05, colour, 3.2)
        width, pieces = (
            0.064,
            [
                box_piece((0, 0, 0.052 * s), (0.05, 0.078, 0.104 * s)),
                cylinder_piece(0.014, 0.1 * s, 0.15 * s, 8),
            ],
        )
    for side in ("+x", "-x"):
        project_label(
            bottle,
            label,
            side,
            (0, 0.05 * s),
            (width, 0.084 * s),
            0.3,
            lambda c: 0.003 < c[2] < 0.1 * s,
        )
    plastic = plain(pump, 0.02)
    z = 0.118 * s
    neck = lathe(
        [
            (0, z - 0.004),
            (0.0165, z - 0.004),
            (0.016, z + 0.012),
            (0.0065, z + 0.014),
            (0.0055, z + 0.036),
            (0, z + 0.036),
        ],
        14,
        mat=plastic,
    )
    head = lathe(
        [(0, z + 0.034), (0.012, z + 0.034), (0.0135, z + 0.046), (0.01, z + 0.05), (0, z + 0.05)],
        14,
        mat=plastic,
    )
    path = spline(
        [(0, 0, z + 0.043), (0.025, 0, z + 0.044), (0.038, 0, z + 0.041), (0.043, 0, z + 0.032)], 3
    )
    spout = tube(path, np.linspace(0.0062, 0.0042, len(path)), 8, mat=plastic)
    pieces.append(box_piece((0.016, 0, z + 0.04), (0.058, 0.022, 0.02)))
    part = Part([bottle.weigh(1.3), neck, head, spout], collision=pieces)
    return Model("hand soap dispenser", {"body": part}, mass=0.34, friction=0.5)


def soap_dispenser_random(rng: np.random.Generator) -> dict:
    return {
        "round_body": True,
        "height": uniform(rng, 0.155, 0.185),
        "body": pick(rng, ["#f1f0ea", "#5d7482", "#a9b8a0"]),
        "ink": pick(rng, ["#1c2a30"]),
        "pump": "#b0b6ba",
    }


def shampoo_bottle(
    height: float, body: str, paper: str, ink: str, accent: str, lid: str, brand: str, kind: str
) -> Model:
    """An oval bottle with a wide flip cap."""
    s = height / 0.22
    colour = plain(body, 0.03, 40)
    label = printed(bottles.shampoo_label(brand, kind, paper, ink, accent), base=body)
    steps = [
        (0, 0.9, 0.88),
        (0.004, 1, 1),
        (0.1, 1.0, 1.0),
        (0.15, 0.93, 0.95),
        (0.172, 0.76, 0.82),
        (0.18, 0.64, 0.76),
    ]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.074, 0.043, colour, 2.5).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle,
            label,
            side,
            (0, 0.08 * s),
            (0.062, 0.14 * s),
            0.3,
            lambda c: 0.004 < c[2] < 0.165 * s and abs(c[1]) < 0.035,
        )
    rings = [(0.178, 0.66, 0.8), (0.179, 0.72, 0.86), (0.212, 0.68, 0.8), (0.218, 0.6, 0.7)]
    lid_mat = plain(lid, 0.03)
    top = oval_body([(z * s, w, d) for z, w, d in rings], 0.074, 0.043, lid_mat, 2.5)
    seam = oval_body(
        [(0.206 * s, 0.715, 0.855), (0.2075 * s, 0.715, 0.855)],
        0.074,
        0.043,
        plain(shade(lid, 0.7), 0),
    )
    pieces = [
        box_piece((0, 0, 0.09 * s), (0.041, 0.072, 0.18 * s)),
        box_piece((0, 0, 0.2 * s), (0.034, 0.05, 0.038 * s)),
    ]
    part = Part([bottle, top, seam], collision=pieces)
    return Model("shampoo bottle", {"body": part}, mass=0.33, friction=0.5)


def shampoo_bottle_random(rng: np.random.Generator) -> dict:
    body, paper, ink, accent, lid = pick(
        rng,
        [
            ("#e8d3c2", "#fbf4ee", "#5a2c50", "#c98a5a", "#5a2c50"),
            ("#2f8f7a", "#e9f6ef", "#12473c", "#2f8f7a", "#f4f4f0"),
            ("#3a5fb0", "#eaf0fb", "#1c2f66", "#e8a33a", "#26282e"),
        ],
    )
    return {
        "height": uniform(rng, 0.2, 0.24),
        "body": body,
        "paper": paper,
        "ink": ink,
        "accent": accent,
        "lid": lid,
        "brand": pick(rng, ["Silvane", "Orelia", "Hairo"]),
        "kind": pick(rng, ["repair & shine", "daily care", "volume"]),
    }


def perfume_bottle(
    square: bool, height: float, liquid: str, lid: str, ink: str, brand: str
) -> Model:
    """A small thick-glass flask with tinted content and a bright cap."""
    s = height / 0.1
    glass = Material(occlusion=0.6)
    level = glass.ramp(
        glass.remap(glass.axis(2), 0, 0.07 * s),
        [
            (0, "e9f2f4"),
            (0.12, "f4fafb"),
            (0.16, liquid),
            (0.7, shade(liquid, 1.12)),
            (0.74, "eef5f7"),
            (1, "fbfdfe"),
        ],
    )
    glass.colour(level)
    label = printed(bottles.perfume_label(brand, ink), base=liquid)
    if square:
        outline = rounded_rectangle(0.03, 0.058, 0.006, 3)
        rings = [
            np.c_[outline * f, np.full(len(outline), z)]
            for z, f in ((0, 0.93), (0.003, 1), (0.062 * s, 1), (0.068 * s, 0.86))
        ]
        flask = loft(rings, mat=glass)
    else:
        flask = lathe(
            [
                (0, 0),
                (0.024, 0),
                (0.028, 0.003),
                (0.033, 0.02 * s),
                (0.031, 0.042 * s),
                (0.018, 0.06 * s),
                (0.009, 0.066 * s),
                (0, 0.067 * s),
            ],
            20,
            mat=glass,
            discs=False,
        )
    size = (0.048, 0.044 * s) if square else (0.046, 0.04 * s)
    project_label(
        flask,
        label,
        "+x",
        (0, 0.033 * s if square else 0.03 * s),
        size,
        0.55,
        lambda c: 0.012 * s < c[2] < 0.055 * s,
    )
    gold = metal("d8b45a", "8a6a24") if lid == "gold" else metal("c8ccd0", "7a8086")
    z = 0.067 * s
    top = lathe(
        [
            (0, z - 0.002),
            (0.0085, z - 0.002),
            (0.0085, z + 0.006),
            (0.0125, z + 0.006),
            (0.0125, z + 0.03 * s),
            (0.011, z + 0.033 * s),
            (0, z + 0.033 * s),
        ],
        16,
        mat=gold,
    )
    wide = (0.03, 0.058) if square else (0.058, 0.058)
    pieces = [
        box_piece((0, 0, 0.034 * s), (*wide, 0.068 * s)),
        cylinder_piece(0.0125, z, z + 0.033 * s, 8),
    ]
    return Model(
        "perfume bottle", {"body": Part([flask, top], collision=pieces)}, mass=0.18, friction=0.5
    )


def perfume_bottle_random(rng: np.random.Generator) -> dict:
    return {
        "square": True,
        "height": uniform(rng, 0.09, 0.11),
        "liquid": pick(rng, ["#e8b06a", "#e79ab0", "#9ac0e0"]),
        "lid": pick(rng, ["gold", "silver"]),
        "ink": pick(rng, ["#6a4a2a", "#3a3a4a"]),
        "brand": pick(rng, ["Lunaire", "Amara", "Nuvole"]),
    }


MODELS = {
    "soap_dispenser": Maker(
        soap_dispenser,
        soap_dispenser_random,
        3,
        [
            {"body": "#f1f0ea", "ink": "#1c2a30"},
            {"round_body": False, "body": "#4f6b7c", "ink": "#ffffff"},
            {"body": "#8fa886", "ink": "#ffffff"},
        ],
    ),
    "shampoo_bottle": Maker(
        shampoo_bottle,
        shampoo_bottle_random,
        3,
        [
            {
                "body": "#e8d3c2",
                "paper": "#fbf4ee",
                "ink": "#5a2c50",
                "accent": "#c98a5a",
                "lid": "#5a2c50",
                "brand": "Silvane",
            },
            {
                "body": "#2f8f7a",
                "paper": "#e9f6ef",
                "ink": "#12473c",
                "accent": "#2f8f7a",
                "lid": "#f4f4f0",
            },
            {
                "body": "#3a5fb0",
                "paper": "#eaf0fb",
                "ink": "#1c2f66",
                "accent": "#e8a33a",
                "lid": "#26282e",
            },
        ],
    ),
    "perfume_bottle": Maker(
        perfume_bottle,
        perfume_bottle_random,
        2,
        [{"lid": "gold"}, {"square": False, "liquid": "#e79ab0", "lid": "silver"}],
    ),
}
