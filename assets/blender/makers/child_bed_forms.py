"""Children's beds in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.model import Model
from toolkit.shapes import box, extrude, lathe

from .bedding import make_up
from .casework import Case
from .joinery import Assembly, finish, surface

Offset = tuple[float, float, float]


def spotted(colour: str, dots: str, offset: Offset) -> Material:
    m = Material()
    spot = m.remap(m.voronoi(12, offset=offset, randomness=0.3), 0.24, 0.3, 1, 0)
    return m.colour(m.mix(spot, m.mottle(colour, 0.04, 12), dots))


def _car_side(colour: str, w: int = 256, h: int = 72):
    picture, draw = labels.canvas(w, h, colour)
    draw.rectangle((0, h * 0.62, w, h * 0.72), fill="#f6f3ea")
    draw.ellipse((w * 0.42, h * 0.08, w * 0.58, h * 0.6), fill="#f6f3ea")
    labels.text(draw, "7", (w * 0.44, h * 0.12, w * 0.56, h * 0.56), "bold", "#222222")
    return label(picture)


def bed_car(
    colour: str = "#d0342c",
    blanket: str = "#3f6fb0",
    length: float = 1.8,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A racing car to sleep in: wheels, windscreen wings, a spoiler at the head."""
    asm, half, x0, x1 = Assembly(), 0.46, -length / 2, length / 2
    paint, dark = plain(colour, 0.03, 6, offset), plain("#26282b", 0.05, 12)
    outline = [
        (x0, 0.1),
        (x1 - 0.16, 0.1),
        (x1, 0.2),
        (x1, 0.3),
        (x1 - 0.35, 0.4),
        (x0 + 0.75, 0.42),
    ]
    outline += [(x0 + 0.6, 0.56), (x0 + 0.1, 0.6), (x0, 0.56)]
    for s in (-1, 1):
        side = extrude(outline, 0.03, _car_side(colour), paint, axis="y", weight=1.3)
        if s < 0:
            pass
        asm.add("body", side.move(0, s * (half - 0.015), 0))
        for a, b, t in ((x0, x0 + 0.65, 0.56), (x0 + 0.65, x1 - 0.2, 0.4), (x1 - 0.2, x1, 0.3)):
            y = sorted((s * half, s * (half - 0.03)))
            asm.solid("body", (a, y[0], 0.1), (b, y[1], t))
        for x in (x0 + 0.36, x1 - 0.42):
            tyre = [
                (0, -0.05),
                (0.15, -0.05),
                (0.17, -0.03),
                (0.17, 0.03),
                (0.15, 0.05),
                (0.085, 0.05),
            ]
            hub = [(0.085, 0.05), (0.08, 0.04), (0, 0.046)]
            wheel = lathe([*tyre, *hub[1:]], 20, mats=[dark, plain("#d8dadb", 0.04, 20)],
                          mat_of_segment=[0] * 5 + [1, 1])  # fmt: skip
            wheel.turn(rx=-s * math.pi / 2).move(x, s * (half + 0.0), 0.17)
            asm.add("body", wheel)
            asm.solid("body", (x - 0.1, s * half - 0.05, 0), (x + 0.1, s * half + 0.05, 0.3))
    nose = [(0.1, x1 - 0.16), (0.2, x1), (0.3, x1), (0.395, x1 - 0.33)]
    _ = nose
    hood = [(x1 - 0.38, 0.1), (x1 - 0.16, 0.1), (x1, 0.2), (x1, 0.3), (x1 - 0.38, 0.4)]
    asm.add("body", extrude(hood, 2 * half - 0.062, paint, axis="y"))
    asm.solid("body", (x1 - 0.38, -half + 0.03, 0.1), (x1 - 0.02, half - 0.03, 0.3))
    for s in (-1, 1):
        lamp = lathe([(0, 0), (0.06, 0), (0.05, 0.02), (0, 0.026)], 14, mat=plain("#fff3c4", 0.02))
        asm.add("body", lamp.turn(ry=math.pi / 2).move(x1 - 0.004, s * 0.28, 0.25))
    asm.board("body", (x1 - 0.01, -0.14, 0.14), (x1 + 0.006, 0.14, 0.2), dark, 0.004, solid=False)
    asm.board("body", (x0, -half + 0.03, 0.1), (x0 + 0.03, half - 0.03, 0.6), paint)
    for s in (-1, 1):
        asm.board("body", (x0 + 0.02, s * 0.3 - 0.02, 0.58), (x0 + 0.1, s * 0.3 + 0.02, 0.74), dark)
    wing = box(0.22, 2 * half, 0.03, (0, 0, -0.015), paint, 0.01)
    asm.add("body", wing.turn(ry=-0.22).move(x0 + 0.09, 0, 0.74))
    asm.solid("body", (x0 - 0.02, -half, 0.71), (x0 + 0.2, half, 0.77))
    asm.board("body", (x0 + 0.03, -half + 0.03, 0.16), (x1 - 0.38, half - 0.03, 0.2), dark)
    low, high, z = make_up(
        asm, (x0 + 0.06, x1 - 0.41), 2 * half - 0.09, (0.2, 0.36),
        spotted(blanket, "#f6f3ea", offset),
        hem=0.28, drop=False, start=0.45, offset=offset,
    )  # fmt: skip
    return Model(
        "child's bed like a racing car",
        asm.parts(),
        32.0,
        supports=[surface("top", low, high, z)],
        ground_shadow=True,
    )


def bed_house(
    wood: str = "pine", blanket: str = "#e3b04b", length: float = 1.66, offset: Offset = (0, 0, 0)
) -> Model:
    """Head and foot like the gables of a little house, a low fence at the back."""
    asm, half, x0, x1 = Assembly(), 0.42, -length / 2, length / 2
    up, along, cross = finish(wood, 2, offset), finish(wood, 0, offset), finish(wood, 1, offset)
    for x in (x0, x1 - 0.04):
        eave, ridge = 0.6, 0.94
        for y in (-half, half - 0.04):
            asm.board("body", (x, y, 0), (x + 0.04, y + 0.04, eave), up, 0.004)
        for s in (-1, 1):
            roof = [
                (s * half, eave - 0.02),
                (s * half, eave + 0.035),
                (0, ridge),
                (0, ridge - 0.055),
            ]
            asm.add("body", extrude(roof, 0.04, cross, axis="x").move(x + 0.02, 0, 0))
            asm.piece("body", np.array([(x + e, *p) for e in (0, 0.04) for p in roof]))
        for z in (0.16, 0.5):
            asm.board(
                "body", (x + 0.01, -half + 0.04, z), (x + 0.03, half - 0.04, z + 0.06), cross, 0.003
            )
        for y in np.linspace(-half + 0.14, half - 0.14, 4):
            asm.board("body", (x + 0.014, y - 0.02, 0.2), (x + 0.026, y + 0.02, 0.51), up)
        asm.solid("body", (x, -half, 0.16), (x + 0.04, half, 0.56))
    for s in (-1, 1):
        y = sorted((s * half, s * (half - 0.025)))
        asm.board("body", (x0 + 0.04, y[0], 0.14), (x1 - 0.04, y[1], 0.27), along, 0.004)
        end = x1 - 0.04 if s < 0 else x0 + 0.62
        asm.board("body", (x0 + 0.04, y[0], 0.48), (end, y[1], 0.53), along, 0.004)
        for x in np.arange(x0 + 0.16, end - 0.03, 0.16):
            asm.board("body", (x - 0.02, y[0] + 0.004, 0.26), (x + 0.02, y[1] - 0.004, 0.58), up)
    asm.board("body", (x0 + 0.04, -half + 0.03, 0.17), (x1 - 0.04, half - 0.03, 0.2), cross)
    low, high, z = make_up(
        asm, (x0 + 0.05, x1 - 0.05), 2 * half - 0.07, (0.2, 0.36),
        spotted(blanket, "#fffaf0", offset),
        hem=0.28, drop=False, start=0.45, offset=offset,
    )  # fmt: skip
    return Model(
        "child's bed like a little house",
        asm.parts(),
        26.0,
        supports=[surface("top", low, high, z)],
        ground_shadow=True,
    )


def bed_chest(
    wood: str = "#f0eee8", face: str = "#a9c4e0", blanket: str = "#d98f9a", length: float = 1.75,
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A cabin bed: two drawers and an open niche in the side, a rail round three sides.

    Made with the drawers to the front and turned at the end: its head is at the back.
    """
    case = Case(wood, face, "birch", "knob", pull_finish="brass", offset=offset)
    asm, hy, x0, x1 = case.asm, length / 2, -0.44, 0.44
    x = (x0, x1 - 0.02)
    case.plinth((x0, x1), (-hy, hy), 0.05)
    case.carcass(x, (-hy, hy), (0.05, 0.42))
    split = hy - 0.42
    for y in (-hy + (split + hy) / 2, split):
        case.board(x, (y - 0.009, y + 0.009), (0.068, 0.402), case.inside)
    middle = -hy + (split + hy) / 2
    for k, y in enumerate(((-hy, middle), (middle, split))):
        case.drawer(f"drawer_{k + 1}", (x0 + 0.3, x[1]), y, (0.05, 0.42), 0.4)
    niche = (split + 0.009, hy - 0.018)
    case.bay("", (x0 + 0.3, x1 - 0.02), niche, (0.068, 0.402), container=False)
    case.supports[-1].name = "niche"
    end = finish(wood, 2, offset)
    for y in (-hy, hy - 0.022):
        case.board((x0, x1 - 0.02), (y, y + 0.022), (0.42, 0.9 if y > 0 else 0.74), end, 0.006)
    case.board((x0, x0 + 0.022), (-hy + 0.022, hy - 0.022), (0.42, 0.74), case.across, 0.004)
    sub = Assembly()
    low, high, z = make_up(
        sub, (-hy + 0.03, hy - 0.03), 0.8, (0.42, 0.54), spotted(blanket, "#fffaf0", offset),
        hem=0.46,
        drop=False, start=0.45, offset=offset,
    )  # fmt: skip
    for mesh in sub.meshes["body"]:
        mesh.v = mesh.v @ np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
        asm.add("body", mesh)
    for piece in sub.pieces["body"]:
        asm.piece("body", np.asarray(piece) @ np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]]))
    lo, hi = (low[1], -high[0]), (high[1], -low[0])
    case.supports.insert(0, surface("top", lo, hi, z))
    return case.model("child's cabin bed with drawers", 45.0, front="-y")


def bed_toddler(
    wood: str = "#f3f1ec", side: str = "#b7d3c4", blanket: str = "#8fbcd4", length: float = 1.46,
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A first bed: clouds for head and foot, closed guards at both sides of the head."""
    asm, half, x0, x1 = Assembly(), 0.37, -length / 2, length / 2
    paint, soft = finish(wood, 2, offset), finish(side, 2, offset)
    for x, lift in ((x0, 0.22), (x1 - 0.028, 0.0)):
        puffs = [(-0.26, 0.36, 0.12), (-0.08, 0.44, 0.15), (0.14, 0.42, 0.14), (0.28, 0.35, 0.1)]
        outline = [
            (-half, 0.0),
            (-half + 0.06, 0.0),
            (-half + 0.06, 0.1),
            (half - 0.06, 0.1),
            (half - 0.06, 0),
            (half, 0),
        ]
        edge = []
        for y in np.linspace(half, -half, 25):
            z = max(cz + lift + math.sqrt(max(r * r - (y - cy) ** 2, 0)) for cy, cz, r in puffs)
            edge.append((float(y), z))
        asm.add("body", extrude([*outline, *edge], 0.028, soft, axis="x").move(x + 0.014, 0, 0))
        asm.solid("body", (x, -half, 0.0), (x + 0.028, half, 0.36 + lift))
    for s in (-1, 1):
        y = sorted((s * half, s * (half - 0.02)))
        outline = [
            (x0 + 0.03, 0.14),
            (x1 - 0.03, 0.14),
            (x1 - 0.03, 0.3),
            (x0 + 0.8, 0.32),
            (x0 + 0.66, 0.5),
            (x0 + 0.03, 0.52),
        ]
        asm.add("body", extrude(outline, 0.02, paint, axis="y").move(0, sum(y) / 2, 0))
        asm.solid("body", (x0, y[0], 0.14), (x0 + 0.7, y[1], 0.5))
        asm.solid("body", (x0 + 0.7, y[0], 0.14), (x1, y[1], 0.31))
    asm.board("body", (x0 + 0.03, -half + 0.02, 0.16), (x1 - 0.03, half - 0.02, 0.19), paint)
    low, high, z = make_up(
        asm, (x0 + 0.04, x1 - 0.04), 2 * half - 0.06, (0.19, 0.33),
        spotted(blanket, "#ffffff", offset),
        hem=0.25, drop=False, start=0.42, offset=offset,
    )  # fmt: skip
    return Model(
        "toddler's bed with clouds",
        asm.parts(),
        18.0,
        supports=[surface("top", low, high, z)],
        ground_shadow=True,
    )


CHILD_BEDS = [(bed_car, {}), (bed_house, {}), (bed_chest, {}), (bed_toddler, {})]
CHILD_BEDS += [(bed_car, {"colour": "#2f74c0", "blanket": "#e3b04b"})]
