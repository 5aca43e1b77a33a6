"""Beds in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.model import Model
from toolkit.shapes import ellipsoid, extrude, lathe, spline, tube

from .bedding import make_up
from .casework import Case, cane, metal_or
from .joinery import Assembly, cushion, fabric, finish, leg, surface
from .upholstery import buttoned

Offset = tuple[float, float, float]


def _done(title: str, asm: Assembly, mass: float, top: tuple) -> Model:
    low, high, z = top
    return Model(
        title, asm.parts(), mass, supports=[surface("top", low, high, z)], ground_shadow=True
    )


def bed_metal(
    width: float = 1.42, length: float = 2.04, metal: str = "iron", blanket: str = "#b5675a",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A frame of metal tube: arched head and foot with upright bars and knobs."""
    asm, rod, half = Assembly(), metal_or(metal), width / 2
    x0, x1 = -length / 2, length / 2
    for x, top, rise in ((x0 + 0.02, 0.82, 0.22), (x1 - 0.02, 0.58, 0.14)):
        for y in (-half + 0.02, half - 0.02):
            asm.add("body", tube([(x, y, 0), (x, y, top)], 0.017, 8, mat=rod), solid=True)
            asm.add("body", ellipsoid(0.028, (x, y, top + 0.015), 10, 6, metal_or("brass")))
        ys = np.linspace(-half + 0.02, half - 0.02, 9)
        arch = [(x, y, top - 0.06 + rise * math.cos(1.5 * y / half)) for y in ys]
        asm.add("body", tube(arch, 0.012, 6, mat=rod))
        low = 0.42 if x < 0 else 0.3
        asm.add("body", tube([(x, -half, low), (x, half, low)], 0.012, 6, mat=rod))
        for y in np.linspace(-half, half, 10)[1:-1]:
            z = top - 0.06 + rise * math.cos(1.5 * y / half)
            asm.add("body", tube([(x, y, low), (x, y, z)], 0.007, 5, mat=rod))
        asm.solid("body", (x - 0.015, -half, low), (x + 0.015, half, top))
    for y in (-half + 0.02, half - 0.02):
        asm.board("body", (x0 + 0.02, y - 0.012, 0.27), (x1 - 0.02, y + 0.012, 0.31), rod)
    top = make_up(
        asm, (x0 + 0.06, x1 - 0.07), width - 0.06, (0.29, 0.5), fabric(blanket, offset, 0.05),
        hem=0.36, offset=offset,
    )  # fmt: skip
    return _done("bed with a frame of metal tube", asm, 48.0, top)


def bed_drawers(
    width: float = 1.46, length: float = 2.08, wood: str = "#eceae5", blanket: str = "#6f8f86",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A storage bed: two deep drawers in the foot end, shelves' high box at the head."""
    case = Case(wood, None, "birch", "groove", offset=offset, t=0.022)
    asm, half, x0, x1 = case.asm, width / 2, -length / 2, length / 2
    low, rail = 0.04, 0.36
    mid = 0.0
    case.plinth((x0, x1), (-half, half), low)
    for s in (-1, 1):
        y = tuple(sorted((s * half, s * (half - 0.022))))
        case.board((x0, x1 - 0.022), y, (low, rail), finish(wood, 0, offset), 0.003)
    case.board((x0, x1 - 0.05), (-half + 0.022, half - 0.022), (low, low + 0.02), case.inside)
    case.board(
        (x0, x1 - 0.03), (-half + 0.022, half - 0.022), (rail - 0.04, rail - 0.02), case.across
    )
    case.board((mid, x1 - 0.03), (-0.011, 0.011), (low + 0.02, rail - 0.04), case.inside)
    case.board(
        (mid - 0.02, mid), (-half + 0.022, half - 0.022), (low + 0.02, rail - 0.04), case.inside
    )
    for k, y in enumerate(((-half + 0.006, 0.0), (0.0, half - 0.006))):
        case.drawer(
            f"drawer_{k + 1}", (mid + 0.2, x1 - 0.022), y, (low, rail), 0.5, 0.022, pull_at=0.8
        )
    # the head: a shallow box with a ledge
    case.board((x0, x0 + 0.16), (-half, half), (rail, 0.94), case.across, 0.004)
    soft = fabric(blanket, offset, 0.06)
    for k in range(2):
        pad = cushion((0.4, width / 2 - 0.08, 0.05), (0, 0, 0), soft, 0.05, 0.02, 0.02)
        pad.turn(ry=math.pi / 2 - 0.08).move(x0 + 0.15, (k - 0.5) * width / 2, 0.68)
        asm.add("body", pad)
    top = make_up(
        asm, (x0 + 0.19, x1 - 0.05), width - 0.05, (rail - 0.02, 0.54), soft, hem=rail - 0.01,
        drop=True, offset=offset,
    )  # fmt: skip
    lo, hi, z = top
    case.supports.insert(0, surface("top", lo, hi, z))
    case.supports.append(surface("shelf", (x0, -half), (x0 + 0.12, half), 0.94))
    return case.model("bed with two drawers in its foot", 88.0)


def bed_posts(
    width: float = 1.62, length: float = 2.1, wood: str = "walnut", blanket: str = "#d8cdb8",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Four turned posts, a panelled head board."""
    asm, half, x0, x1 = Assembly(), width / 2, -length / 2, length / 2
    up, cross, along = finish(wood, 2, offset), finish(wood, 1, offset), finish(wood, 0, offset)
    for x in (x0 + 0.05, x1 - 0.05):
        for y in (-half + 0.05, half - 0.05):
            tall = 1.28
            post = [
                (0, 0),
                (0.032, 0),
                (0.04, 0.12),
                (0.05, 0.2),
                (0.05, 0.46),
                (0.03, 0.5),
                (0.04, 0.56),
            ]
            post += [
                (0.026, 0.62),
                (0.034, 0.9),
                (0.024, 1.12),
                (0.04, 1.15),
                (0.02, 1.18),
                (0.032, 1.23),
                (0, tall),
            ]
            asm.add("body", lathe(post, 10, mat=up).move(x, y, 0))
            asm.solid("body", (x - 0.045, y - 0.045, 0), (x + 0.045, y + 0.045, 1.2))
    for s in (-1, 1):
        y = s * (half - 0.05)
        asm.board("body", (x0 + 0.05, y - 0.016, 0.24), (x1 - 0.05, y + 0.016, 0.42), along, 0.006)
    asm.board(
        "body", (x1 - 0.066, -half + 0.05, 0.24), (x1 - 0.034, half - 0.05, 0.5), cross, 0.006
    )
    ys = np.linspace(half - 0.05, -half + 0.05, 11)
    outline = [(-half + 0.05, 0.24), (half - 0.05, 0.24)]
    outline += [(float(y), 0.86 + 0.2 * math.cos(1.45 * y / half) ** 2) for y in ys]
    asm.add("body", extrude(outline, 0.032, cross, axis="x").move(x0 + 0.05, 0, 0))
    asm.solid("body", (x0 + 0.034, -half + 0.05, 0.24), (x0 + 0.066, half - 0.05, 0.92))
    top = make_up(
        asm, (x0 + 0.08, x1 - 0.09), width - 0.14, (0.3, 0.54), fabric(blanket, offset, 0.05),
        hem=0.4, offset=offset,
    )  # fmt: skip
    return _done("bed with four posts", asm, 80.0, top)


def bed_sleigh(
    width: float = 1.56, length: float = 2.18, wood: str = "oak", blanket: str = "#7a8fb0",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Head and foot boards that roll outwards like a sleigh's."""
    asm, half, x0, x1 = Assembly(), width / 2, -length / 2, length / 2
    cross, along = finish(wood, 1, offset), finish(wood, 0, offset)
    for x, s, top in ((x0 + 0.16, -1, 1.0), (x1 - 0.15, 1, 0.72)):
        inner = spline([(0, 0.06), (0.0, top * 0.55), (0.05, top * 0.85), (0.12, top - 0.02)], 4)
        outer = [(px + 0.04, pz - 0.02 * (pz > 0.2)) for px, pz in inner]
        roll = [
            (0.12 + 0.03 * math.cos(a), top - 0.03 + 0.035 * math.sin(a))
            for a in (2.0, 1.2, 0.3, -0.6, -1.4)
        ]
        outline = [(x + s * px, pz) for px, pz in [*inner, *roll, *outer[::-1]]]
        asm.add("body", extrude(outline, width, cross, axis="y"))
        asm.solid("body", (x - 0.03, -half, 0.06), (x + 0.03, half, top * 0.8))
        for y in (-half + 0.05, half - 0.05):
            leg(asm, "body", (x, y), (x, y), (0, 0.1), (0.03, 0.045), cross, 4)
    for s in (-1, 1):
        y = s * (half - 0.03)
        asm.board("body", (x0 + 0.14, y - 0.016, 0.14), (x1 - 0.13, y + 0.016, 0.36), along, 0.006)
    top = make_up(
        asm, (x0 + 0.18, x1 - 0.17), width - 0.08, (0.26, 0.5), fabric(blanket, offset, 0.05),
        hem=0.34, drop=False, offset=offset,
    )  # fmt: skip
    return _done("sleigh bed", asm, 85.0, top)


def bed_box(
    width: float = 1.66, length: float = 2.12, colour: str = "#8c8578", blanket: str = "#ebe6dc",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A padded box with a tall buttoned head board between two wings."""
    asm, half, x0, x1 = Assembly(), width / 2, -length / 2, length / 2
    cloth = fabric(colour, offset)
    asm.board(
        "body", (x0 + 0.06, -half + 0.05, 0), (x1 - 0.05, half - 0.05, 0.05), finish("black", 1)
    )
    box = cushion((length - 0.08, width, 0.27), (0.04, 0, 0.04), cloth, 0.05, 0.0, 0.03)
    asm.add("body", box, solid=True)
    head = cushion((1.2, width, 0.09), (0, 0, 0), buttoned(colour, 0.19, offset), 0.04, 0.01, 0.035)
    asm.add("body", head.turn(ry=math.pi / 2).move(x0 + 0.0, 0, 0.64), solid=True)
    for s in (-1, 1):
        wing = cushion(
            (0.26, 0.07, 0.9), (x0 + 0.13, s * (half - 0.035), 0.32), cloth, 0.03, 0.01, 0.03
        )
        asm.add("body", wing, solid=True)
    top = make_up(
        asm, (x0 + 0.11, x1 - 0.06), width - 0.16, (0.31, 0.54), fabric(blanket, offset, 0.04),
        hem=0.33, case=fabric("#c9b7a0", offset, 0.04), offset=offset,
    )  # fmt: skip
    return _done("upholstered bed with a tall head board", asm, 90.0, top)


def bed_platform(
    width: float = 1.64, length: float = 2.16, wood: str = "pine", blanket: str = "#4f5d66",
    woven: bool = True, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A low platform wider than its mattress, a woven head board."""
    asm, half, x0, x1 = Assembly(), width / 2, -length / 2, length / 2
    cross, along = finish(wood, 1, offset), finish(wood, 0, offset)
    asm.board(
        "body", (x0 + 0.25, -half + 0.2, 0), (x1 - 0.25, half - 0.2, 0.16), finish("black", 1)
    )
    for k in range(6):
        y = -half + k * width / 6
        asm.board("body", (x0, y + 0.002, 0.16), (x1, y + width / 6 - 0.002, 0.2), along, 0.004)
    asm.board("body", (x0, -half, 0.2), (x0 + 0.03, half, 0.3), cross, 0.004)
    for k in range(3):
        w = width / 3
        y = -half + k * w
        panel = (x0 + 0.006, y + 0.03, 0.3), (x0 + 0.024, y + w - 0.03, 0.74)
        asm.board("body", *panel, cane() if woven else cross, 0.002)
        for a in (y, y + w - 0.03):
            asm.board("body", (x0, a, 0.3), (x0 + 0.03, a + 0.03, 0.78), cross, 0.004)
        asm.board("body", (x0, y, 0.74), (x0 + 0.03, y + w, 0.78), cross, 0.004)
    top = make_up(
        asm, (x0 + 0.06, x1 - 0.16), width - 0.22, (0.2, 0.4), fabric(blanket, offset, 0.05),
        hem=0.22, offset=offset,
    )  # fmt: skip
    return _done("low platform bed", asm, 70.0, top)


BEDS = [(bed_metal, {}), (bed_drawers, {}), (bed_posts, {}), (bed_sleigh, {}), (bed_box, {})]
BEDS += [(bed_platform, {})]
