"""Sofas in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Model
from toolkit.shapes import lathe, loft, spline, tube

from .joinery import Assembly, cushion, fabric, finish, leg, surface
from .upholstery import (
    buttoned,
    horseshoe,
    leather,
    scroll,
    section,
    solid_path,
    unrolled,
    velvet_studs,
    wall,
)

Offset = tuple[float, float, float]


def finished(title: str, asm: Assembly, mass: float, low, high, z: float) -> Model:
    seat = surface("seat", low, high, z)
    return Model(title, asm.parts(), mass, supports=[seat], ground_shadow=True)


def _feet(asm, x0, x1, half, height, mat, r=(0.018, 0.03), inset=0.09, sides=10) -> None:
    for x in (x0 + inset, x1 - inset):
        for y in (-half + inset, half - inset):
            leg(asm, "body", (x, y), (x, y), (0, height + 0.01), r, mat, sides)


def chesterfield(
    seats: int = 3, width: float = 2.05, depth: float = 0.9, colour: str = "#6b3f26",
    wood: str = "walnut", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Arms and back of one height, rolled outwards and buttoned; leather."""
    asm, skin = Assembly(), buttoned(colour, 0.13, offset, 0.18)
    hide = leather(colour, offset)
    timber = finish(wood, 2, offset)
    foot, top, t, r = 0.1, 0.72, 0.15, 0.105
    x0, x1, half = -depth / 2 + 0.14, depth / 2 - 0.03, width / 2 - 0.14
    path = horseshoe(x0, x1, half, 0.12, 4, 2, 2)
    cut = scroll(t, foot + 0.02, top, r)
    # Seams cross at the buttons below, which begin 0.15 m from the corner and 0.52 m high.
    length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
    origin = (length / 2 - half + 0.15 - 0.13 / 2, 0.52 - foot - 0.02)
    mesh = unrolled(wall(path, lambda s: cut, skin), path, cut, range(7, len(cut) - 1), origin)
    asm.add("body", mesh.weigh(1.4))
    solid_path(asm, path, 0.2, foot, lambda s: top)
    asm.board("body", (x0, -half, foot), (x1 - 0.01, half, 0.31), hide, 0.015)
    inner = 2 * (half - t / 2)
    w = inner / seats
    for k in range(seats):
        y = -inner / 2 + (k + 0.5) * w
        size = (x1 - x0 - t / 2 + 0.02, w - 0.006, 0.12)
        asm.add(
            "body", cushion(size, ((x0 + t / 2 + x1 + 0.02) / 2, y, 0.31), hide, 0.04, 0.018, 0.04)
        )
    asm.solid("body", (x0, -half, foot), (x1, half, 0.43))
    spots = [
        (x0 + t / 2, y, z)
        for z, shift in ((0.52, 0), (0.61, 0.065))
        for y in np.arange(-half + 0.15 + shift, half - 0.1, 0.13)
    ]
    velvet_studs(asm, spots, colour)
    _feet(asm, -depth / 2 + 0.06, x1 + 0.04, half + 0.05, foot, timber, (0.024, 0.038), 0.07)
    low, high = (x0 + t / 2 + 0.03, -inner / 2 + 0.04), (x1 - 0.03, inner / 2 - 0.04)
    name = f"chesterfield sofa for {seats}" if seats > 1 else "club armchair of leather"
    return finished(name, asm, 22.0 + 17 * seats, low, high, 0.447)


def wooden_frame(
    seats: int = 3, seat_width: float = 0.58, depth: float = 0.82, wood: str = "oak",
    colour: str = "#c8b998", back: float = 0.78, slats: bool = True, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Loose cushions on an open wooden frame with flat arm rests."""
    asm, cloth = Assembly(), fabric(colour, offset)
    up, along, deep = (finish(wood, axis, offset) for axis in (2, 1, 0))
    inner = seats * seat_width
    half, x0, x1 = inner / 2 + 0.06, -depth / 2, depth / 2
    for s in (-1, 1):
        y = s * (half - 0.02)
        leg(asm, "body", (x1 - 0.05, y), (x1 - 0.09, y), (0, 0.56), (0.014, 0.02), up, 10)
        leg(asm, "body", (x0 + 0.02, y), (x0 + 0.12, y), (0, 0.56), (0.014, 0.02), up, 10)
        asm.board(
            "body", (x0 + 0.06, y - 0.035, 0.56), (x1, y + 0.035, 0.585), deep, 0.01, segments=2
        )
        asm.board("body", (x0 + 0.08, y - 0.014, 0.24), (x1 - 0.08, y + 0.014, 0.3), deep, 0.004)
        if slats:
            for x in np.linspace(x0 + 0.22, x1 - 0.2, 5):
                asm.board("body", (x - 0.014, y - 0.008, 0.29), (x + 0.014, y + 0.008, 0.565), up)
    for x in (x0 + 0.12, x1 - 0.12):
        asm.board(
            "body", (x - 0.015, -half + 0.02, 0.235), (x + 0.015, half - 0.02, 0.3), along, 0.004
        )
    asm.board("body", (x0 + 0.13, -half + 0.03, 0.285), (x1 - 0.1, half - 0.03, 0.3), along)
    tilt = -0.2
    for z in (0.4, 0.56, back - 0.03):
        x = x0 + 0.13 - 0.2 * (z - 0.3)
        asm.board(
            "body",
            (x - 0.014, -half + 0.02, z - 0.03),
            (x + 0.01, half - 0.02, z + 0.03),
            along,
            0.006,
        )
    for y in np.linspace(-half + 0.03, half - 0.03, seats + 1):
        post = [(x0 + 0.14, y, 0.26), (x0 + 0.13 - 0.2 * (back - 0.3), y, back)]
        asm.add("body", tube(post, 0.016, 6, mat=up))
    for k in range(seats):
        y = -inner / 2 + (k + 0.5) * seat_width
        size = (depth - 0.2, seat_width - 0.01, 0.1)
        asm.add("body", cushion(size, (0.06, y, 0.3), cloth, 0.04, 0.02, 0.04))
        mesh = cushion((back - 0.36, seat_width - 0.02, 0.1), (0, 0, 0), cloth, 0.06, 0.025, 0.045)
        mesh.turn(ry=math.pi / 2 + tilt).move(x0 + 0.13, y, 0.4 + (back - 0.36) / 2)
        asm.add("body", mesh)
    asm.solid("body", (x0 + 0.1, -inner / 2, 0.24), (x1 - 0.04, inner / 2, 0.42))
    asm.solid("body", (x0, -inner / 2, 0.42), (x0 + 0.26, inner / 2, back))
    low, high = (x0 + 0.27, -inner / 2 + 0.03), (x1 - 0.07, inner / 2 - 0.03)
    name = "armchair" if seats == 1 else f"sofa for {seats}"
    return finished(f"{name}, cushions on a wooden frame", asm, 13.0 + 9 * seats, low, high, 0.417)


def chaise_sofa(
    width: float = 2.35, depth: float = 1.05, colour: str = "#7d848c", left: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Two seats and a longer one to put the feet up; no arm on that side."""
    asm, cloth = Assembly(), fabric(colour, offset)
    s = -1 if left else 1
    half, x0, x1 = width / 2, -depth / 2, depth / 2
    seat_x1, foot, base, arm = x1 - 0.26, 0.08, 0.28, 0.18
    long_w = 0.86
    edge = s * (half - long_w)
    dark = plain("#26282a", 0.05, 12)
    for x in (x0 + 0.08, seat_x1 - 0.08):
        for y in (-half + 0.1, half - 0.1):
            asm.board("body", (x - 0.025, y - 0.025, 0), (x + 0.025, y + 0.025, foot), dark)
    asm.board(
        "body", (x1 - 0.1, s * half * 0.9 - 0.03, 0), (x1 - 0.05, s * half * 0.9 + 0.03, foot), dark
    )
    lo, hi = sorted((edge, -s * (half - 0.02)))
    asm.board("body", (x0 + 0.02, lo, foot), (seat_x1 - 0.02, hi, base + 0.02), cloth, 0.014)
    lo, hi = sorted((edge, s * (half - 0.005)))
    asm.board("body", (x0 + 0.02, lo, foot), (x1 - 0.02, hi, base + 0.02), cloth, 0.014)
    pad = cushion(
        (depth - 0.24, long_w - 0.02, 0.15),
        (0.11, (edge + s * half) / 2, base),
        cloth,
        0.06,
        0.02,
        0.05,
    )
    asm.add("body", pad, solid=True)
    arm_mesh = cushion(
        (seat_x1 - x0, arm, 0.5),
        ((x0 + seat_x1) / 2, -s * (half - arm / 2), foot),
        cloth,
        0.05,
        0.02,
        0.06,
    )
    asm.add("body", arm_mesh, solid=True)
    asm.add(
        "body",
        cushion((0.2, width - 0.02, 0.56), (x0 + 0.1, 0, foot), cloth, 0.05, 0.02, 0.06),
        solid=True,
    )
    inner = abs(-s * (half - arm) - edge)
    for k in range(2):
        y = edge - s * (k + 0.5) * inner / 2
        size = (seat_x1 - x0 - 0.2, inner / 2 - 0.01, 0.15)
        asm.add(
            "body",
            cushion(size, (x0 + 0.2 + size[0] / 2, y, base), cloth, 0.05, 0.02, 0.05),
            solid=True,
        )
    ys = [(edge + s * half) / 2] + [edge - s * (k + 0.5) * inner / 2 for k in range(2)]
    for y, w in zip(ys, (long_w, inner / 2, inner / 2), strict=True):
        mesh = cushion((0.42, w - 0.03, 0.13), (0, 0, 0), cloth, 0.08, 0.03, 0.05)
        mesh.turn(ry=math.pi / 2 - 0.16).move(x0 + 0.19, y, 0.64)
        asm.add("body", mesh)
    asm.solid("body", (x0 + 0.2, -half + 0.05, 0.43), (x0 + 0.34, half - 0.2, 0.82))
    for y, c in ((ys[0], "#d8a84e"), (ys[2], "#3f6a70")):
        mesh = cushion((0.38, 0.4, 0.07), (0, 0, 0), fabric(c, offset, 0.06), 0.05, 0.035, 0.05)
        asm.add("body", mesh.turn(ry=math.pi / 2 - 0.38).move(x0 + 0.37, y, 0.63))
    low, high = (x0 + 0.46, -half + 0.2), (seat_x1 - 0.05, half - 0.2)
    return finished("corner sofa with a chaise longue", asm, 78.0, low, high, 0.448)


def round_sofa(
    width: float = 1.95, depth: float = 0.92, colour: str = "#e3dccf", offset: Offset = (0, 0, 0)
) -> Model:
    """One soft wall bends round a kidney of a seat."""
    asm, cloth = Assembly(), fabric(colour, offset, 0.06)
    half, t = width / 2 - 0.11, 0.2
    x0, x1 = -depth / 2 + 0.11, depth / 2 - 0.3
    path = horseshoe(x0, x1, half, 0.62, 9, 1, 2)

    def top(s: float) -> float:
        return 0.58 + 0.16 * math.sin(math.pi * min(1.0, max(0.0, s))) ** 0.7

    asm.add("body", wall(path, lambda s: section(t, 0.05, top(s), 0.09), cloth))
    solid_path(asm, path, t, 0.05, top)
    ring = [(x1 + 0.17, -half + 0.14), (x1 + 0.29, 0.0), (x1 + 0.17, half - 0.14)]
    front = [(x1 - 0.02, -half + 0.02), *ring, (x1 - 0.02, half - 0.02)]
    edge = spline(front, 4)
    inner = horseshoe(x0 + 0.1, x1, half - 0.09, 0.54, 6, 1, 2)
    outline = np.r_[edge, inner[::-1]]
    rings = []
    middle = outline.mean(0)
    for k, z in ((0.95, 0.04), (0.99, 0.08), (1, 0.36), (0.985, 0.41), (0.95, 0.435), (0.9, 0.445)):
        rings.append(np.c_[(outline - middle) * k + middle, np.full(len(outline), z)])
    asm.add("body", loft(rings, cloth).outward())
    asm.solid("body", (x0 + 0.1, -half + 0.15, 0.04), (x1 + 0.2, half - 0.15, 0.44))
    for y, c in ((-0.5, "#b9805a"), (0.52, "#8f9a86")):
        mesh = cushion((0.36, 0.38, 0.07), (0, 0, 0), fabric(c, offset, 0.06), 0.05, 0.035, 0.05)
        asm.add("body", mesh.turn(ry=math.pi / 2 - 0.3).move(x0 + 0.2, y, 0.63))
    low, high = (x0 + 0.28, -half + 0.35), (x1 + 0.12, half - 0.35)
    return finished("rounded sofa", asm, 60.0, low, high, 0.452)


def slender_sofa(
    seats: int = 2, width: float = 1.55, depth: float = 0.8, colour: str = "#c28a2e",
    wood: str = "walnut", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Thin arms and a buttoned back on long tapering legs, bolsters at the ends."""
    asm, cloth, timber = Assembly(), fabric(colour, offset), finish(wood, 2, offset)
    half, x0, x1 = width / 2, -depth / 2, depth / 2
    for x in (x0 + 0.12, x1 - 0.1):
        for y in (-half + 0.1, half - 0.1):
            foot = (x + (0.05 if x > 0 else -0.05), y + (0.04 if y > 0 else -0.04))
            leg(asm, "body", foot, (x, y), (0, 0.25), (0.01, 0.021), timber, 10)
    asm.board(
        "body", (x0 + 0.06, -half + 0.03, 0.235), (x1 - 0.02, half - 0.03, 0.265), timber, 0.006
    )
    seat = cushion((depth - 0.14, width - 0.12, 0.15), (0.05, 0, 0.262), cloth, 0.04, 0.014, 0.04)
    asm.add("body", seat, solid=True)
    for s in (-1, 1):
        arm = cushion(
            (depth - 0.12, 0.07, 0.3), (0, s * (half - 0.035), 0.255), cloth, 0.03, 0.008, 0.03
        )
        asm.add("body", arm, solid=True)
        roll = [(0.0, 0.0), (0.075, 0.0), (0.085, 0.012), (0.085, 0.4), (0.075, 0.412), (0, 0.412)]
        mesh = lathe(roll, 12, mat=cloth).turn(ry=math.pi / 2)
        asm.add("body", mesh.move(-0.12, s * (half - 0.165), 0.505))
    back = cushion(
        (0.44, width - 0.02, 0.1), (0, 0, 0), buttoned(colour, 0.2, offset), 0.05, 0.015, 0.04
    )
    back.turn(ry=math.pi / 2 - 0.14).move(x0 + 0.09, 0, 0.58)
    asm.add("body", back)
    asm.solid("body", (x0, -half + 0.02, 0.4), (x0 + 0.2, half - 0.02, 0.8))
    low, high = (x0 + 0.24, -half + 0.3), (x1 - 0.04, half - 0.3)
    return finished(f"sofa for {seats}, thin arms and long legs", asm, 38.0, low, high, 0.42)


SOFAS = [
    (chesterfield, {}),
    (chaise_sofa, {}),
    (wooden_frame, {}),
    (round_sofa, {}),
    (slender_sofa, {"depth": 0.88}),
    (chesterfield, {"colour": "#2f4a3f"}),
]
