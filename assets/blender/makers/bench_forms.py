"""Benches and step stools in further shapes."""

from __future__ import annotations

import numpy as np
from toolkit.materials import plain
from toolkit.model import (
    Model,
    Support,
    cylinder_piece,
    round_polygon,
)
from toolkit.shapes import extrude, lathe, loft, rounded_rectangle, tube

from .casework import Case, cane, metal_or
from .footstools import buttons, quilted
from .joinery import Assembly, cushion, fabric, finish, leg, surface

Offset = tuple[float, float, float]


def bench_trestle(
    length: float = 1.25, depth: float = 0.34, height: float = 0.45, wood: str = "pine",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A plank on two shaped ends, a rail between them."""
    asm, hx, hy, t = Assembly(), depth / 2, length / 2, 0.035
    asm.board(
        "body", (-hx, -hy, height - t), (hx, hy, height), finish(wood, 1, offset), 0.006, segments=2
    )
    up = finish(wood, 2, offset)
    shape = [
        (-hx + 0.02, 0),
        (-0.05, 0),
        (0, 0.09),
        (0.05, 0),
        (hx - 0.02, 0),
        (hx - 0.06, height - t),
    ]
    shape += [(-hx + 0.06, height - t)]
    for y in (-hy + 0.14, hy - 0.14):
        asm.add("body", extrude(shape, 0.03, up, axis="y").move(0, y, 0))
        asm.solid("body", (-hx + 0.03, y - 0.015, 0), (hx - 0.03, y + 0.015, height - t))
    asm.board(
        "body", (-0.02, -hy + 0.08, 0.17), (0.02, hy - 0.08, 0.26), finish(wood, 1, offset), 0.003
    )
    top = surface("top", (-hx, -hy), (hx, hy), height)
    return Model(
        f"{wood} bench on two plank ends", asm.parts(), 11.0, supports=[top], ground_shadow=True
    )


def bench_drawers(
    length: float = 1.05, depth: float = 0.42, height: float = 0.48, wood: str = "#eceae5",
    pad: str = "#7d8f80", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A padded seat over three drawers."""
    case = Case(wood, None, "birch", "cup", pull_finish="iron", offset=offset)
    half, x = length / 2, (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), 0.05)
    case.carcass(x, (-half, half), (0.05, height - 0.065))
    case.board((x[0], depth / 2), (-half - 0.004, half + 0.004), (height - 0.065, height - 0.045))
    third = length / 3
    for k in range(3):
        y = (-half + k * third, -half + (k + 1) * third)
        case.drawer(f"drawer_{k + 1}", x, y, (0.05, height - 0.066), 0.27)
    cloth = fabric(pad, offset)
    soft = cushion((depth, length, 0.036), (0, 0, height - 0.045), cloth, 0.03, 0.01, 0.016)
    case.asm.add("body", soft)
    case.asm.solid("body", (x[0], -half, height - 0.045), (depth / 2, half, height - 0.002))
    top = surface("top", (x[0], -half), (depth / 2, half), height + 0.001, margin=0.04)
    case.supports.insert(0, top)
    return case.model("storage bench with three drawers", 20.0)


def bench_padded(
    length: float = 1.2, depth: float = 0.42, height: float = 0.5, colour: str = "#6d7f99",
    metal: str = "brass", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """For the foot of a bed: a thick buttoned cushion on crossed metal legs."""
    asm, hx, hy = Assembly(), depth / 2, length / 2
    rod = metal_or(metal)
    z = height - 0.13
    for y in (-hy + 0.2, hy - 0.2):
        for e in (-1, 1):
            ends = [(-hx + 0.03, y + e * 0.14, 0.0), (hx - 0.03, y - e * 0.14, z)]
            ends2 = [(hx - 0.03, y + e * 0.14, 0.0), (-hx + 0.03, y - e * 0.14, z)]
            for path in (ends, ends2)[: 1 if e > 0 else 2]:
                asm.add("body", tube(path, 0.013, 6, mat=rod))
        asm.solid("body", (-hx + 0.03, y - 0.14, 0), (hx - 0.03, y + 0.14, z))
    asm.board("body", (-hx + 0.02, -hy + 0.03, z - 0.004), (hx - 0.02, hy - 0.03, z + 0.02), rod)
    pad = cushion(
        (depth, length, height - z - 0.028),
        (0, 0, z + 0.014),
        quilted(colour, 0.15, offset),
        0.05,
        0.014,
        0.035,
    )
    asm.add("body", pad.weigh(1.3), solid=True)
    buttons(
        asm,
        [(x, y, height) for x in (-0.075, 0.075) for y in np.arange(-hy + 0.15, hy - 0.1, 0.15)],
        colour,
    )
    top = surface("top", (-hx, -hy), (hx, hy), height + 0.004, margin=0.06)
    return Model(
        "padded bench on metal legs", asm.parts(), 12.0, supports=[top], ground_shadow=True
    )


def bench_woven(
    length: float = 1.0, depth: float = 0.4, height: float = 0.46, wood: str = "teak",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A woven seat in a frame whose two ends rise to arms."""
    asm, hx, hy = Assembly(), depth / 2, length / 2
    up, along = finish(wood, 2, offset), finish(wood, 1, offset)
    rise = 0.5
    for x in (-hx + 0.018, hx - 0.018):
        for y in (-hy + 0.018, hy - 0.018):
            leg(asm, "body", (x, y), (x, y), (0, rise), (0.014, 0.018), up, 10)
        asm.board(
            "body", (x - 0.014, -hy, height - 0.06), (x + 0.014, hy, height - 0.02), along, 0.004
        )
    for y in (-hy + 0.018, hy - 0.018):
        for z in (height - 0.06, rise - 0.02):
            asm.board("body", (-hx, y - 0.014, z), (hx, y + 0.014, z + 0.03), up, 0.006)
    asm.board(
        "body",
        (-hx + 0.03, -hy + 0.03, height - 0.035),
        (hx - 0.03, hy - 0.03, height - 0.012),
        cane(),
        0.008,
    )
    for z in (0.14,):
        for x in (-hx + 0.018, hx - 0.018):
            asm.board("body", (x - 0.009, -hy + 0.02, z), (x + 0.009, hy - 0.02, z + 0.02), along)
    top = surface("top", (-hx + 0.03, -hy + 0.04), (hx - 0.03, hy - 0.04), height - 0.012)
    return Model("bench with a woven seat", asm.parts(), 9.0, supports=[top], ground_shadow=True)


# ---- step stools
def step_folding(
    colour: str = "#b9bdc1", tread: str = "#2a2c2e", offset: Offset = (0, 0, 0)
) -> Model:
    """A folding ladder of two wide treads in a frame of tube."""
    asm, w = Assembly(), 0.4
    rod, rubber = (
        metal_or("steel") if colour == "#b9bdc1" else plain(colour, 0.04, 12),
        plain(tread, 0.05, 20),
    )
    for s in (-1, 1):
        y = s * (w / 2 - 0.012)
        front = [(0.23, y, 0.012), (0.02, y, 0.47)]
        back = [(-0.22, y * 0.96, 0.012), (-0.02, y * 0.96, 0.46)]
        for path in (front, back):
            asm.piece("body", asm.add("body", tube(path, 0.012, 6, mat=rod)).v)
    for z in (0.09,):
        bar = [(-0.185, -w / 2 + 0.02, z), (-0.185, w / 2 - 0.02, z)]
        asm.add("body", tube(bar, 0.01, 6, mat=rod))
    supports = []
    for name, x, z, d in (("top", 0.0, 0.46, 0.22), ("step", 0.15, 0.23, 0.17)):
        low, high = (x - d / 2, -w / 2 + 0.02), (x + d / 2, w / 2 - 0.02)
        asm.board("body", (*low, z - 0.026), (*high, z), rubber, 0.006)
        for k in range(4):
            a = x - d / 2 + 0.03 + k * (d - 0.06) / 3
            asm.board(
                "body",
                (a - 0.004, low[1] + 0.02, z - 0.002),
                (a + 0.004, high[1] - 0.02, z + 0.003),
                rod,
                solid=False,
            )
        room = None if name == "top" else 0.18
        supports.append(surface(name, low, high, z + 0.003, room))
    return Model(
        "folding step stool, two steps", asm.parts(), 3.6, supports=supports, texture_size=128
    )


def step_wood(wood: str = "oak", offset: Offset = (0, 0, 0)) -> Model:
    """One step: a board with a slot for the hand on four splayed plank legs."""
    asm, sx, sy, height = Assembly(), 0.26, 0.4, 0.23
    board = finish(wood, 1, offset)
    top = extrude(rounded_rectangle(sx, sy, 0.03, 3), 0.024, board, bevel_width=0.004)
    asm.add("body", top.move(z=height - 0.024))
    asm.solid("body", (-sx / 2, -sy / 2, height - 0.024), (sx / 2, sy / 2, height))
    hole = rounded_rectangle(0.03, 0.1, 0.014, 3)
    slot = [np.c_[hole, np.full(len(hole), z)] for z in (height - 0.01, height + 0.001)]
    asm.add("body", loft(slot, plain("#2a1c12", 0)))
    up = finish(wood, 2, offset)
    for s in (-1, 1):
        for e in (-1, 1):
            foot, head = (
                (s * (sx / 2 - 0.01), e * (sy / 2 + 0.005)),
                (s * (sx / 2 - 0.06), e * (sy / 2 - 0.07)),
            )
            leg(asm, "body", foot, head, (0, height - 0.02), (0.016, 0.02), up, 4)
        low, high = (
            (-sx / 2 + 0.05, s * (sy / 2 - 0.035) - 0.008, 0.09),
            (sx / 2 - 0.05, s * (sy / 2 - 0.035) + 0.008, 0.12),
        )
        asm.board("body", low, high, up)
    low, high = (-sx / 2 + 0.02, 0.06), (sx / 2 - 0.02, sy / 2 - 0.02)
    return Model(
        "wooden step stool, one step",
        asm.parts(),
        2.2,
        supports=[surface("top", low, high, height)],
    )


def step_plastic(
    colour: str = "#e07a5f", tread: str = "#f6f3ea", offset: Offset = (0, 0, 0)
) -> Model:
    """Two moulded steps for children, closed at the sides."""
    asm, sy, depth = Assembly(), 0.38, 0.38
    shell, pad = plain(colour, 0.03, 9, offset), plain(tread, 0.04, 20)
    x0, x1, low_z, high_z = -depth / 2, depth / 2, 0.15, 0.29
    outline = [
        (x0, 0),
        (x0 + 0.03, 0),
        (x0 + 0.05, 0.05),
        (x1 - 0.05, 0.05),
        (x1 - 0.03, 0),
        (x1, 0),
    ]
    outline += [(x1 - 0.02, low_z), (0.0, low_z), (-0.015, high_z), (x0 + 0.025, high_z)]
    for s in (-1, 1):
        y = s * (sy / 2 - 0.02)
        mesh = extrude(outline, 0.035, shell, axis="y", bevel_width=0.006).move(0, y, 0)
        asm.add("body", mesh)
        asm.solid("body", (x0, y - 0.018, 0), (0, y + 0.018, high_z))
        asm.solid("body", (0, y - 0.018, 0), (x1, y + 0.018, low_z))
    supports = []
    for name, a, b, z in (("top", x0 + 0.005, 0.0, high_z), ("step", -0.02, x1 - 0.005, low_z)):
        asm.board(
            "body", (a, -sy / 2 + 0.006, z - 0.03), (b, sy / 2 - 0.006, z), shell, 0.008, segments=2
        )
        asm.board(
            "body",
            (a + 0.025, -sy / 2 + 0.05, z - 0.002),
            (b - 0.02, sy / 2 - 0.05, z + 0.003),
            pad,
            0.002,
            solid=False,
        )
        start = a if name == "top" else 0.0
        supports.append(
            surface(name, (start + 0.02, -sy / 2 + 0.05), (b - 0.02, sy / 2 - 0.05), z + 0.003)
        )
    asm.board(
        "body", (x0 + 0.02, -sy / 2 + 0.02, 0.06), (x0 + 0.04, sy / 2 - 0.02, high_z - 0.02), shell
    )
    asm.board(
        "body", (0.0, -sy / 2 + 0.02, low_z - 0.01), (0.015, sy / 2 - 0.02, high_z - 0.02), shell
    )
    return Model(
        "plastic step stool, two steps", asm.parts(), 2.0, supports=supports, texture_size=128
    )


def step_kick(colour: str = "#3a6a9c", offset: Offset = (0, 0, 0)) -> Model:
    """The round one of offices and libraries: a ribbed cone with a rubber tread."""
    asm, height = Assembly(), 0.43
    shell, rubber = plain(colour, 0.04, 12, offset), plain("#26282a", 0.06, 40)
    wall = [
        (0, 0.012),
        (0.215, 0.012),
        (0.215, 0.04),
        (0.2, 0.05),
        (0.165, 0.22),
        (0.185, 0.225),
        (0.185, 0.25),
    ]
    wall += [
        (0.155, 0.258),
        (0.138, height - 0.03),
        (0.15, height - 0.026),
        (0.15, height - 0.008),
        (0, height - 0.008),
    ]
    asm.add("body", lathe(wall, 24, mat=shell))
    for r0, r1, z in ((0.0, 0.135, height), (0.158, 0.183, 0.254)):
        ring = (
            [(r0, z - 0.012), (r1, z - 0.012), (r1, z), (r0, z), (r0, z - 0.012)]
            if r0
            else [(0, z - 0.012), (r1, z - 0.012), (r1, z), (0, z)]
        )
        asm.add("body", lathe(ring, 20, mat=rubber))
    band = [(0.214, 0.0), (0.222, 0.0), (0.222, 0.03), (0.214, 0.03), (0.214, 0.0)]
    asm.add("body", lathe(band, 20, mat=rubber))
    asm.piece("body", cylinder_piece(0.22, 0, 0.05, 14))
    asm.piece("body", cylinder_piece(0.2, 0.05, 0.25, 12, 0.18))
    asm.piece("body", cylinder_piece(0.16, 0.25, height, 12, 0.14))
    top = Support("top", height, round_polygon(0.125, 12))
    return Model("round kick stool", asm.parts(), 3.2, supports=[top], texture_size=128)


BENCHES = [(bench_trestle, {}), (bench_drawers, {}), (bench_padded, {}), (bench_woven, {})]
BENCHES += [(bench_drawers, {"wood": "oak", "pad": "#8a4f3d"})]
STEP_STOOLS = [(step_folding, {}), (step_wood, {}), (step_plastic, {}), (step_kick, {})]
STEP_STOOLS += [(step_plastic, {"colour": "#5b9bd0"})]
