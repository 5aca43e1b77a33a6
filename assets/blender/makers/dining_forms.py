"""Rectangular dining tables: steel crosses, glass on panels, thick boards."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Model, Support
from toolkit.shapes import extrude, lathe

from .casework import smoked_glass
from .joinery import Assembly, finish, leg, steel, surface

Offset = tuple[float, float, float]
WHITE = "#eeece6"


def named(finish_name: str) -> str:
    return {WHITE: "white", "#e8e6e0": "white", "#2c2e30": "black"}.get(finish_name, finish_name)


def model_of(asm: Assembly, title: str, mass: float, support: Support, **more) -> Model:
    parts = more.pop("parts", None) or asm.parts()
    supports = [support, *more.pop("supports", [])]
    return Model(title=title, parts=parts, mass=mass, supports=supports, ground_shadow=True, **more)


def crossed(
    wood: str = "oak", length: float = 1.7, depth: float = 0.92, offset: Offset = (0, 0, 0)
) -> Model:
    """A heavy top with wavy edges on two black steel X frames."""
    asm, iron = Assembly(), plain("#26282a", 0.05, 14)
    hx, hy, z0, z1 = depth / 2, length / 2, 0.695, 0.745
    t = np.linspace(-1, 1, 9)
    edge = [(hx - 0.02 + 0.02 * math.sin(4.1 * u + 0.6), hy * u) for u in t]
    edge += [(-hx + 0.02 + 0.02 * math.sin(3.3 * u), hy * u) for u in t[::-1]]
    asm.add(
        "body",
        extrude(edge, z1 - z0, mat=finish(wood, 1, offset), bevel_width=0.008, weight=1.3).move(
            0, 0, z0
        ),
    )
    asm.solid("body", (-hx + 0.02, -hy, z0), (hx - 0.02, hy, z1))
    for s in (-1, 1):
        y = s * (hy - 0.33)
        for d in (-1, 1):
            leg(
                asm, "body", (d * 0.36, y), (-d * 0.36, y), (0, z0 - 0.012), (0.042, 0.042), iron, 4
            )
        asm.board("body", (-0.4, y - 0.05, z0 - 0.013), (0.4, y + 0.05, z0), iron)
    return model_of(
        asm,
        f"{wood} dining table on steel X legs",
        48.0,
        surface("top", (-hx + 0.03, -hy), (hx - 0.03, hy), z1),
    )


def glass(length: float = 1.5, depth: float = 0.9, offset: Offset = (0, 0, 0)) -> Model:
    """A pane of dark glass on two broad white panels."""
    asm, white = Assembly(), plain("#f1f0ec", 0.02, 8, offset)
    hx, hy, z1 = depth / 2, length / 2, 0.74
    pane = smoked_glass()
    edge = plain("#2c3a38", 0.05)
    faces = {"+x": edge, "-x": edge, "+y": edge, "-y": edge}
    asm.board("body", (-hx, -hy, z1 - 0.014), (hx, hy, z1), pane, 0, faces, 1.2)
    for s in (-1, 1):
        y = s * (hy - 0.36)
        asm.board("body", (-0.3, y - 0.045, 0), (0.3, y + 0.045, z1 - 0.02), white, 0.006)
        for x in (-0.25, 0.25):
            disc = [(0, z1 - 0.02), (0.03, z1 - 0.02), (0.03, z1 - 0.014), (0, z1 - 0.014)]
            asm.add("body", lathe(disc, 10, mat=steel()).move(x, y, 0))
    asm.board("body", (-0.04, -hy + 0.36, 0.3), (0.04, hy - 0.36, 0.36), white, 0.004)
    return model_of(
        asm, "dining table with a glass top", 46.0, surface("top", (-hx, -hy), (hx, hy), z1)
    )


def parsons(
    wood: str = "walnut", length: float = 1.6, depth: float = 0.9, offset: Offset = (0, 0, 0)
) -> Model:
    """A rectangular table of thick boards, its square legs flush with the corners."""
    asm, top, timber = Assembly(), finish(wood, 1, offset), finish(wood, 2, offset)
    hx, hy, z1, t = depth / 2, length / 2, 0.75, 0.075
    asm.board("body", (-hx, -hy, z1 - t), (hx, hy, z1), top, 0.004, weight=1.3)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (hx - t / 2), sy * (hy - t / 2)
            asm.board(
                "body", (x - t / 2, y - t / 2, 0), (x + t / 2, y + t / 2, z1 - t), timber, 0.003
            )
    return model_of(
        asm,
        f"{named(wood)} dining table with square legs",
        44.0,
        surface("top", (-hx, -hy), (hx, hy), z1),
    )
