"""Armchairs in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Model
from toolkit.shapes import extrude, lathe, loft, tube

from .casework import metal_or
from .joinery import Assembly, cushion, fabric, finish, leg
from .sofas import chesterfield, finished, wooden_frame
from .upholstery import (
    horseshoe,
    leather,
    section,
    solid_path,
    wall,
)

Offset = tuple[float, float, float]


def wing_chair(colour: str = "#3f5f6a", wood: str = "walnut", offset: Offset = (0, 0, 0)) -> Model:
    """A high back with wings, rolled arms, a loose seat cushion."""
    asm, cloth, timber = Assembly(), fabric(colour, offset), finish(wood, 2, offset)
    width, depth, foot = 0.78, 0.82, 0.19
    x0, x1, half, t = -depth / 2 + 0.08, depth / 2 - 0.06, width / 2 - 0.06, 0.1
    path = horseshoe(x0, x1, half, 0.1, 3, 9, 2)
    n = len(path)

    def top(s: float) -> float:
        x = float(np.interp(s * (n - 1), np.arange(n), path[:, 0]))
        reach = (x - x0) / (x1 - x0)
        if reach > 0.52:
            return 0.62
        return 0.62 + 0.45 * min(1.0, (0.52 - reach) / 0.16) ** 0.6

    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    exact = {round(float(s), 6): top(k / (n - 1)) for k, s in enumerate(steps / steps[-1])}
    asm.add("body", wall(path, lambda s: section(t, foot, exact[round(s, 6)], 0.05), cloth, 0.06))
    solid_path(asm, path, t, foot, lambda s: 0.62)
    asm.solid("body", (x0 - 0.07, -half, 0.62), (x0 + 0.06, half, 1.05))
    for s in (-1, 1):
        arm = cushion((0.52, 0.13, 0.09), (0.1, s * (half + 0.015), 0.55), cloth, 0.05, 0.015, 0.04)
        asm.add("body", arm)
        asm.solid("body", (x0, s * half - 0.05, 0.6), (x0 + 0.27, s * half + 0.05, 1.03))
    asm.board("body", (x0, -half, foot), (x1, half, 0.34), cloth, 0.012)
    seat = cushion(
        (x1 - x0 + 0.0, 2 * half - t, 0.12),
        ((x0 + x1) / 2 + 0.04, 0, 0.34),
        cloth,
        0.06,
        0.025,
        0.045,
    )
    asm.add("body", seat, solid=True)
    pad = cushion((0.6, 2 * half - t - 0.04, 0.06), (0, 0, 0), cloth, 0.07, 0.03, 0.03)
    pad.turn(ry=math.pi / 2 - 0.07).move(x0 + 0.05, 0, 0.75)
    asm.add("body", pad)
    for x in (x0 + 0.03, x1 - 0.04):
        for y in (-half + 0.02, half - 0.02):
            foot_at = (x + (0.0 if x > 0 else -0.05), y)
            leg(asm, "body", foot_at, (x, y), (0, foot + 0.02), (0.014, 0.027), timber, 10)
    low, high = (x0 + 0.16, -half + 0.09), (x1 - 0.02, half - 0.09)
    return finished("wing armchair", asm, 26.0, low, high, 0.482)


def tub_chair(colour: str = "#b7657a", base: str = "brass", offset: Offset = (0, 0, 0)) -> Model:
    """A round seat half enclosed by one curved back."""
    asm, cloth = Assembly(), fabric(colour, offset, 0.07)
    r, t, foot = 0.33, 0.09, 0.16
    a = np.linspace(-math.radians(112), math.radians(112), 19)
    path = np.array([(-r * math.cos(q), r * math.sin(q)) for q in a])

    def top(s: float) -> float:
        return 0.6 + 0.17 * math.cos((s - 0.5) * math.pi) ** 1.3

    asm.add("body", wall(path, lambda s: section(t, foot, top(s), 0.042), cloth, 0.05))
    solid_path(asm, path, t, foot, top)
    drum = [(0, foot), (r - 0.02, foot), (r - 0.01, foot + 0.02), (r - 0.01, 0.33), (0, 0.33)]
    asm.add("body", lathe(drum, 26, mat=cloth))
    pad = [
        (0, 0.325),
        (r - 0.055, 0.325),
        (r - 0.035, 0.35),
        (r - 0.04, 0.42),
        (r - 0.08, 0.45),
        (0.12, 0.462),
        (0, 0.464),
    ]
    asm.add("body", lathe(pad, 24, mat=cloth).move(0.02, 0, 0))
    asm.solid("body", (-0.24, -0.24, foot), (0.26, 0.24, 0.455))
    rod = metal_or(base)
    for k in range(4):
        q = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(q), math.sin(q)
        leg(
            asm,
            "body",
            (0.33 * c, 0.33 * s),
            (0.24 * c, 0.24 * s),
            (0, foot + 0.01),
            (0.009, 0.014),
            rod,
            8,
        )
    return finished("tub armchair", asm, 15.0, (-0.14, -0.18), (0.24, 0.18), 0.466)


def rocking_chair(
    wood: str = "pine", seat: str | None = "#a3483c", offset: Offset = (0, 0, 0)
) -> Model:
    """A rocking chair: curved runners, spindles in a high back, arm rests."""
    asm = Assembly()
    up, along, deep = (finish(wood, axis, offset) for axis in (2, 1, 0))
    w, d, z = 0.57, 0.48, 0.42
    half = w / 2
    for s in (-1, 1):
        y = s * (half + 0.03)
        runner = [(x, y, 0.022 + 0.22 * (x + 0.03) ** 2) for x in np.linspace(-0.52, 0.44, 12)]
        asm.add("body", tube(runner, 0.02, 6, mat=deep, flatten=1.1))
        asm.solid("body", (-0.3, y - 0.02, 0.0), (0.25, y + 0.02, 0.05))
        for x0, x1 in ((0.2, 0.17), (-0.24, -0.19)):
            low_z = 0.03 + 0.22 * (x0 + 0.03) ** 2
            leg(asm, "body", (x0, y), (x1, s * (half - 0.04)), (low_z, z), (0.015, 0.02), up, 8)
        rung = [(0.18, s * half, 0.2), (-0.22, s * half, 0.2)]
        asm.add("body", tube(rung, 0.011, 6, mat=up))
        arm = (-0.2, s * (half + 0.015) - 0.035, 0.64), (0.25, s * (half + 0.015) + 0.035, 0.664)
        asm.board("body", *arm, deep, 0.01, segments=2)
        for x in (0.0, 0.1, 0.2):
            post = [(x - 0.01, s * (half - 0.03), z), (x, s * (half + 0.015), 0.645)]
            asm.add("body", tube(post, 0.011, 6, mat=up))
    asm.board("body", (-d / 2, -half, z - 0.02), (d / 2, half, z + 0.012), along, 0.012, segments=2)
    rung = [(0.185, -half, 0.24), (0.185, half, 0.24)]
    asm.add("body", tube(rung, 0.012, 6, mat=up))

    def back_x(h: float) -> float:
        return -d / 2 + 0.03 - 0.28 * (h - z)

    for s in (-1, 1):
        y = s * (half - 0.03)
        asm.add("body", tube([(back_x(z), y, z), (back_x(1.06), y * 1.06, 1.06)], 0.018, 8, mat=up))
    for y in np.linspace(-half + 0.09, half - 0.09, 5):
        spindle = [(back_x(z), y * 0.95, z), (back_x(0.7), y, 0.7), (back_x(0.98), y * 1.05, 0.98)]
        asm.add("body", tube(spindle, (0.009, 0.013, 0.009), 6, mat=up))
    crest = []
    for y in np.linspace(-half - 0.02, half + 0.02, 9):
        lift = 0.03 * math.cos(math.pi * y / w)
        x = back_x(1.0)
        ring = [(-0.012, -0.06), (0.012, -0.06), (0.012, 0.06 + lift), (-0.012, 0.06 + lift)]
        crest.append(np.array([(x + a - 0.28 * b, y, 1.0 + b) for a, b in ring]))
    asm.add("body", loft(crest, along))
    pts = [(back_x(h) + e, y, h) for h in (z, 1.06) for e in (-0.02, 0.02) for y in (-half, half)]
    asm.piece("body", np.array(pts))
    top = z + 0.012
    if seat:
        pad = cushion(
            (d - 0.06, w - 0.06, 0.04), (0.01, 0, top), fabric(seat, offset), 0.06, 0.012, 0.018
        )
        asm.add("body", pad)
        asm.solid("body", (-0.18, -0.22, top), (0.2, 0.22, top + 0.048))
        top += 0.05
    return finished("rocking chair", asm, 12.0, (-0.13, -0.19), (0.2, 0.19), top)


def recliner(colour: str = "#4a3a33", offset: Offset = (0, 0, 0)) -> Model:
    """A fat leather chair, its back leant and its foot rest a little out."""
    asm, hide, dark = Assembly(), leather(colour, offset), plain("#1f1d1c", 0.05, 12)
    half, x0 = 0.46, -0.42
    asm.board("body", (x0 + 0.1, -half + 0.06, 0.0), (0.3, half - 0.06, 0.1), dark)
    for s in (-1, 1):
        arm = cushion((0.76, 0.2, 0.5), (-0.02, s * (half - 0.1), 0.06), hide, 0.07, 0.04, 0.08)
        asm.add("body", arm, solid=True)
        mesh = cushion((0.5, 0.21, 0.08), (0.06, s * (half - 0.1), 0.55), hide, 0.06, 0.03, 0.04)
        asm.add("body", mesh)
    asm.board("body", (x0 + 0.14, -half + 0.18, 0.1), (0.34, half - 0.18, 0.3), hide, 0.02)
    seat = cushion((0.62, 2 * half - 0.4, 0.17), (0.08, 0, 0.28), hide, 0.08, 0.04, 0.06)
    asm.add("body", seat, solid=True)
    lean = -0.27
    for h, tall, thick in ((0.15, 0.3, 0.17), (0.36, 0.3, 0.16), (0.56, 0.24, 0.18)):
        pad = cushion((tall, 2 * half - 0.3, thick), (0, 0, 0), hide, 0.08, 0.03, 0.06)
        pad.turn(ry=math.pi / 2 + lean)
        z = 0.4 + h * math.cos(lean)
        pad.move(x0 + 0.15 + h * math.sin(lean) * 0.95, 0, z)
        asm.add("body", pad)
    core = [
        (x0 + 0.12 - 0.26 * (z - 0.4) + e, z)
        for z, e in ((0.3, 0), (0.3, 0.1), (0.98, 0.1), (0.98, 0))
    ]
    asm.add("body", extrude(core, 2 * half - 0.36, hide, axis="y"))
    pts = [
        (x0 + 0.1 + e - 0.26 * (z - 0.4), y, z)
        for z in (0.3, 1.0)
        for e in (-0.02, 0.18)
        for y in (-0.3, 0.3)
    ]
    asm.piece("body", np.array(pts))
    rest = cushion((0.3, 2 * half - 0.42, 0.1), (0, 0, 0), hide, 0.06, 0.025, 0.04)
    rest.turn(ry=0.85).move(0.385, 0, 0.23)
    asm.add("body", rest)
    asm.solid("body", (0.36, -0.24, 0.1), (0.5, 0.24, 0.34))
    handle = tube(
        [(0.2, half - 0.005, 0.3), (0.3, half + 0.012, 0.34)], 0.012, 6, mat=finish("oak")
    )
    asm.add("body", handle)
    return finished("recliner armchair", asm, 40.0, (x0 + 0.38, -0.2), (0.3, 0.2), 0.486)


ARMCHAIRS = [
    (wing_chair, {}),
    (tub_chair, {}),
    (rocking_chair, {}),
    (recliner, {}),
    (chesterfield, {"seats": 1, "width": 1.0, "depth": 0.88, "colour": "#7a4a2a"}),
    (
        wooden_frame,
        {"seats": 1, "depth": 0.78, "colour": "#6f8a7a", "wood": "walnut", "slats": False},
    ),
    (tub_chair, {"colour": "#5f7f8a"}),
]
