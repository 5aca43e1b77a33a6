"""Floor lamps in further shapes; every one can be on."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Model, cylinder_piece
from toolkit.shapes import ellipsoid, extrude, lathe, spline, tube

from .casework import metal_or
from .joinery import Assembly, finish
from .lamp_forms import lamp_model, lit_pair

Offset = tuple[float, float, float]


def torchiere(
    height: float = 1.75,
    stand: str = "steel",
    glass: str = "#f1ece0",
    reader: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A bowl that shines at the ceiling, a reading lamp on an arm lower down."""
    asm, pole = Assembly(), metal_or(stand)
    base = [
        (0, 0),
        (0.14, 0),
        (0.145, 0.008),
        (0.13, 0.022),
        (0.03, 0.034),
        (0.013, 0.06),
        (0.012, height - 0.14),
    ]
    asm.add("body", lathe([*base, (0.03, height - 0.13), (0, height - 0.12)], 22, mat=pole))
    z0, z1 = height - 0.13, height
    for part, mat in lit_pair(glass, (0, 0, z1), 0.22, offset):
        bowl = [
            (0, z0),
            (0.06, z0 + 0.006),
            (0.13, z0 + 0.05),
            (0.185, z1),
            (0.176, z1),
            (0.12, z0 + 0.058),
            (0.05, z0 + 0.02),
            (0, z0 + 0.018),
        ]
        asm.add(part, lathe(bowl, 26, mat=mat))
    if reader:
        arm = spline([(0.012, 0, 1.1), (0.1, 0, 1.2), (0.22, 0, 1.2), (0.28, 0, 1.14)], 3)
        asm.add("body", tube(arm, 0.007, 6, mat=pole))
        for part, mat in (
            ("shade", plain("#e8e4da", 0.02)),
            ("shade_lit", Material("#fff3cc", 0.0)),
        ):
            cone = [(0, 0.0), (0.05, -0.07), (0.045, -0.07), (0, -0.02)]
            asm.add(
                part,
                lathe([(0, 0.012), (0.02, 0.01), (0.055, -0.07), (0, -0.055)][::-1], 14, mat=mat)
                .turn(ry=-0.5)
                .move(0.29, 0, 1.13),
            )
            _ = cone
    asm.piece("body", cylinder_piece(0.145, 0, 0.03, 12))
    asm.solid("body", (-0.013, -0.013, 0.03), (0.013, 0.013, height - 0.14))
    asm.piece("body", cylinder_piece(0.06, z0, z1, 12, 0.185))
    return lamp_model("uplighter floor lamp", asm, 6.0)


def paper_column(height: float = 1.3, wood: str = "black", offset: Offset = (0, 0, 0)) -> Model:
    """A square lantern of paper in a wooden lattice."""
    asm, h = Assembly(), 0.15
    timber = finish(wood, 2, offset)
    for x in (-h, h - 0.02):
        for y in (-h, h - 0.02):
            asm.board("body", (x, y, 0), (x + 0.02, y + 0.02, height), timber, 0.002)
    for z in np.linspace(0.06, height - 0.02, 6):
        for s in (-1, 1):
            for low, high in (
                ((-h, s * (h - 0.01) - 0.008, z), (h, s * (h - 0.01) + 0.008, z + 0.016)),
                ((s * (h - 0.01) - 0.008, -h, z), (s * (h - 0.01) + 0.008, h, z + 0.016)),
            ):
                asm.board("body", low, high, timber, solid=False)
    for part, mat in lit_pair("#f3ead6", (0, 0, height * 0.5), 0.5, offset):
        asm.board(
            part,
            (-h + 0.012, -h + 0.012, 0.07),
            (h - 0.012, h - 0.012, height - 0.01),
            mat,
            solid=False,
        )
    asm.solid("body", (-h, -h, 0), (h, h, height))
    return lamp_model("paper lantern floor lamp", asm, 3.5, glow=1.35)


def pharmacy(
    height: float = 1.35, stand: str = "brass", hood: str = "#2f5d4a", offset: Offset = (0, 0, 0)
) -> Model:
    """A reading lamp: a low pole, a swing arm, a half-round metal hood."""
    asm, pole = Assembly(), metal_or(stand)
    base = [
        (0, 0),
        (0.13, 0),
        (0.135, 0.008),
        (0.12, 0.02),
        (0.02, 0.03),
        (0.012, 0.06),
        (0.011, height - 0.05),
        (0, height - 0.04),
    ]
    asm.add("body", lathe(base, 20, mat=pole))
    top = height - 0.06
    arm = [(0, 0, top), (0.2, 0, top + 0.03), (0.36, 0, top - 0.02)]
    asm.add("body", tube(spline(arm, 3), 0.008, 6, mat=pole))
    asm.add("body", ellipsoid(0.022, (0, 0, top), 10, 6, pole))
    a = np.linspace(0, math.pi, 9)
    outer = [(0.07 * math.cos(t), 0.07 * math.sin(t)) for t in a]
    inner = [(0.062 * math.cos(t), 0.062 * math.sin(t) - 0.002) for t in a[::-1]]
    for part, mat in (("shade", finish(hood, 1, offset)), ("shade_lit", finish(hood, 1, offset))):
        mesh = extrude([*outer, *inner], 0.26, mat, axis="y").turn(ry=0.25).move(0.4, 0, top - 0.07)
        asm.add(part, mesh)
    for part, mat in (("shade", plain("#f1eee4", 0.02)), ("shade_lit", Material("#fff6d8", 0.0))):
        asm.add(part, ellipsoid((0.045, 0.11, 0.05), (0.4, 0, top - 0.06), 10, 6, mat))
    asm.piece("body", cylinder_piece(0.135, 0, 0.045, 12))
    asm.solid("body", (-0.013, -0.013, 0.03), (0.013, 0.013, height - 0.05))
    asm.solid("body", (0.36, -0.1, top - 0.07), (0.44, 0.1, top - 0.01))
    return lamp_model("reading floor lamp with a metal hood", asm, 5.0, glow=1.4)


def globes(height: float = 1.6, stand: str = "brass", offset: Offset = (0, 0, 0)) -> Model:
    """Three glass globes on arms of different height."""
    asm, pole = Assembly(), metal_or(stand)
    base = [(0, 0), (0.15, 0), (0.155, 0.012), (0.15, 0.024), (0.02, 0.03), (0, 0.03)]
    asm.add("body", lathe(base, 24, mat=pole))
    asm.add("body", tube([(0, 0, 0.02), (0, 0, height - 0.13)], 0.011, 8, mat=pole))
    for k, (q, z) in enumerate(((0.0, height - 0.11), (0.19, height - 0.42), (0.19, height - 0.7))):
        a = 2 * math.pi * k / 3 + 0.5
        x, y = q * math.cos(a), q * math.sin(a)
        if q:
            arm = spline([(0, 0, z - 0.12), (0.6 * x, 0.6 * y, z - 0.14), (x, y, z - 0.09)], 3)
            asm.add("body", tube(arm, 0.008, 6, mat=pole))
        cup = [(0, -0.115), (0.03, -0.11), (0.04, -0.09), (0, -0.08)]
        asm.add("body", lathe(cup, 12, mat=pole).move(x, y, z))
        for part, mat in lit_pair("#f4efe4", (x, y, z), 0.2, offset):
            asm.add(part, ellipsoid(0.105, (x, y, z), 16, 10, mat))
        asm.solid("body", (x - 0.08, y - 0.08, z - 0.08), (x + 0.08, y + 0.08, z + 0.08))
    asm.piece("body", cylinder_piece(0.155, 0, 0.03, 12))
    asm.solid("body", (-0.013, -0.013, 0.03), (0.013, 0.013, height - 0.2))
    return lamp_model("floor lamp with three globes", asm, 6.5)


FLOOR_LAMPS = [(torchiere, {}), (paper_column, {}), (pharmacy, {}), (globes, {})]
