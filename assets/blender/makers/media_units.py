"""Television stands and televisions in further shapes."""

from __future__ import annotations

import math

import numpy as np
from labels.screens import programme
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.mesh import cube_project
from toolkit.model import Model
from toolkit.shapes import loft, rounded_rectangle, tube

from .casework import Case, cane, metal_or, striped
from .joinery import Assembly, finish, leg, surface

Offset = tuple[float, float, float]


def stand_doors(
    width: float = 1.5,
    height: float = 0.55,
    depth: float = 0.4,
    wood: str = "oak",
    face: str | None = None,
    panel: str = "cane",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two doors left and right of an open middle, on splayed legs."""
    case = Case(wood, face, wood, "knob", "shaker", "brass", offset, 0.02)
    case.panel = cane() if panel == "cane" else striped(panel, "#5a4630", 0.03, 1)
    half, t, base, third = width / 2, 0.02, 0.16, width / 6
    x = (-depth / 2, depth / 2 - 0.02)
    case.legs((x[0], depth / 2), (-half, half), base + 0.01, 0.1, (0.013, 0.022), splay=0.03)
    case.carcass(x, (-half, half), (base, height - 0.022))
    case.top((x[0], depth / 2), (-half, half), (height - 0.022, height))
    roof = height - 0.022 - t
    for s in (-1, 1):
        case.board(x, (s * third - t / 2, s * third + t / 2), (base + t, roof), case.across)
    case.bay("", x, (-third + t / 2, third - t / 2), (base + t, roof), 1, container=False)
    for k, support in enumerate(case.supports[1:]):
        support.name = f"shelf_{k + 1}"
    for side, inner, y in (
        ("left", (-half + t, -third - t / 2), (-half, -third)),
        ("right", (third + t / 2, half - t), (third, half)),
    ):
        door = f"door_{side}"
        case.bay(f"inside_{side}", x, inner, (base + t, roof), 0, door, f"inside_{side}")
        case.door(door, x[1], y, (base, height - 0.024), side == "right", rail=0.045)
    return case.model("tv stand with two doors", 30.0)


def stand_drawers(
    width: float = 1.4,
    height: float = 0.4,
    depth: float = 0.4,
    wood: str = "#e9e7e1",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A low board: three wide drawers under an open niche along the whole width."""
    case = Case(wood, face, "birch", "groove", offset=offset, t=0.022)
    half, t, base = width / 2, 0.022, 0.04
    x = (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), base)
    case.carcass((x[0], depth / 2), (-half, half), (base, height))
    case.supports.append(surface("top", (x[0], -half), (depth / 2, half), height))
    middle = height - t - 0.12
    inner = (-half + t, half - t)
    case.board(x, inner, (middle - t, middle), case.across)
    case.bay("", (x[0], depth / 2), inner, (middle, height - t), container=False)
    case.supports[-1].name = "shelf_1"
    third = (inner[1] - inner[0]) / 3
    for k in range(3):
        y = (inner[0] + k * third, inner[0] + (k + 1) * third)
        case.drawer(f"drawer_{k + 1}", x, y, (base + t, middle - t), pull_at=0.75)
    return case.model("tv stand with three drawers", 32.0)


def stand_frame(
    width: float = 1.3,
    height: float = 0.5,
    depth: float = 0.38,
    wood: str = "pine",
    metal: str = "iron",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two thick boards in an open metal frame."""
    case, half, r = Case(wood, offset=offset), width / 2, 0.016
    x0, x1, rod = -depth / 2, depth / 2, metal_or(metal)
    for y in (-half, half - 2 * r):
        for x in (x0, x1 - 2 * r):
            case.board((x, x + 2 * r), (y, y + 2 * r), (0, height - 0.03), rod)
        case.board((x0, x1), (y, y + 2 * r), (0.0, 0.022), rod, solid=False)
    for k, (name, z) in enumerate((("top", height), ("shelf_1", 0.2))):
        low = -half + (0 if k == 0 else 2 * r)
        case.board((x0, x1), (low, -low), (z - 0.032, z), case.across, 0.004)
        room = None if k == 0 else height - 0.032 - 0.2
        case.supports.append(surface(name, (x0, low), (x1, -low), z, room, margin=0.02))
    for s in (-1, 1):
        ends = [(x0 + 0.01, s * half * 0.9, 0.2), (x0 + 0.01, s * 0.1, height - 0.03)]
        case.asm.add("body", tube(ends, 0.007, 5, mat=rod))
    return case.model("tv stand, two boards in a metal frame", 19.0)


def stand_tall(
    width: float = 1.1,
    height: float = 0.64,
    depth: float = 0.42,
    wood: str = "walnut",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A tall old-fashioned one: two open bays over two doors."""
    case = Case(wood, None, wood, "ring", "shaker", "brass", offset, 0.022)
    half, t, base = width / 2, 0.022, 0.06
    x = (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), base, case.wood)
    case.carcass(x, (-half, half), (base, height - 0.026))
    over = (-half - 0.02, half + 0.02)
    case.top((x[0], depth / 2 + 0.015), over, (height - 0.026, height), bevel=0.008)
    middle, inner = 0.42, (-half + t, half - t)
    case.board(x, inner, (middle - t, middle), case.across)
    case.board(x, (-t / 2, t / 2), (base + t, height - 0.026 - t), case.across)
    for k, y in enumerate(((inner[0], -t / 2), (t / 2, inner[1]))):
        case.bay("", x, y, (middle, height - 0.026 - t), container=False)
        case.supports[-1].name = f"shelf_{k + 1}"
        side = ("left", "right")[k]
        case.bay(
            f"inside_{side}", x, y, (base + t, middle - t), 0, f"door_{side}", f"inside_{side}"
        )
        outer = (-half, 0.0) if k == 0 else (0.0, half)
        case.door(f"door_{side}", x[1], outer, (base, middle - t / 2), k == 1, rail=0.055)
    return case.model("tall tv stand, open bays over doors", 34.0)


# ---- televisions
def _states(asm: Assembly, title: str, mass: float, glow: float = 1.45) -> Model:
    return Model(
        title=title,
        parts=asm.parts(screen_on={"rgba": (glow, glow, glow, 1.0)}),
        mass=mass,
        variants={"default": ["body", "screen_off"], "on": ["body", "screen_on"]},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["screen_off"]},
            {"state": "ON", "variants": ["on"], "parts": ["screen_on"]},
        ],
    )


def _dark():
    off, pen = labels.canvas(96, 54, "#0b0c0f")
    pen.polygon([(30, 54), (62, 0), (88, 0), (56, 54)], fill="#15181c")
    return label(off)


def flat_tv(
    width: float = 1.2,
    picture: str = "football",
    stand: str = "neck",
    rim: str = "#17181a",
    bar: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A flat set: stand "neck" (one foot in the middle), "easel" (wooden legs) or "wide" feet.

    bar: a loudspeaker bar stands before its foot.
    """
    asm, half = Assembly(), width / 2
    z0 = {"neck": 0.13, "easel": 0.12, "wide": 0.1}[stand]
    frame = 0.024 if rim != "#17181a" else 0.012
    tall = (width - 2 * frame) * 9 / 16
    z1 = z0 + tall + 2 * frame
    shell, black = finish(rim, 1, offset), plain("#17181a", 0.05, 20)
    asm.board("body", (-0.03, -half, z0), (0.012, half, z1), shell, 0.004)
    asm.board("body", (-0.05, -half * 0.5, z0 + 0.08), (-0.02, half * 0.5, z1 - 0.2), black, 0.008)
    low, high = (-0.01, -half + frame, z0 + frame), (0.016, half - frame, z1 - frame)
    asm.board("screen_off", low, high, black, 0, {"+x": _dark()}, solid=False)
    shining = label(programme(picture), occlusion=0.0)
    asm.board("screen_on", low, high, black, 0, {"+x": shining}, 3.0, solid=False)
    if stand == "neck":
        base = rounded_rectangle(0.26, 0.52, 0.12, 5)
        rings = [
            np.c_[base * s, np.full(len(base), z)] for s, z in ((1, 0), (1, 0.012), (0.9, 0.018))
        ]
        asm.add("body", cube_project(loft(rings, plain("#3a3d41", 0.05, 20))), solid=True)
        asm.board("body", (-0.04, -0.07, 0.012), (-0.015, 0.07, z0 + 0.1), black, 0.006)
    elif stand == "easel":
        oak = finish("oak", 2, offset)
        for y in (-half * 0.55, half * 0.55):
            for s in (-1, 1):
                foot = (s * 0.13, y * 1.08)
                leg(asm, "body", foot, (s * 0.012, y), (0, z0 + 0.03), (0.012, 0.016), oak, 10)
    else:
        for y in (-half * 0.8, half * 0.8):
            path = [(-0.12, y, 0.009), (0.0, y, z0 + 0.012), (0.12, y, 0.009)]
            asm.add("body", tube(path, 0.01, 6, mat=metal_or("steel")))
        for s in (-1, 1):
            for x in (-0.12, 0.12):
                asm.solid(
                    "body",
                    (x - 0.01, s * half * 0.8 - 0.01, 0),
                    (x + 0.01, s * half * 0.8 + 0.01, 0.02),
                )
    if bar:
        cloth = striped("#26282b", "#111214", 0.012, 1)
        asm.board("body", (0.06, -half * 0.7, 0), (0.13, half * 0.7, 0.062), cloth, 0.012)
    return _states(asm, f"television, {math.hypot(width, tall) / 0.0254:.0f} inch", 13.0)


def tube_tv(
    width: float = 0.62,
    shell: str = "#3a3d40",
    picture: str = "lake",
    offset: Offset = (0, 0, 0),
) -> Model:
    """An old set with a picture tube: deep, its back tapering, knobs and aerial."""
    asm, half, tall = Assembly(), width / 2, 0.78 * width
    body, black = finish(shell, 1, offset), plain("#1c1d1f", 0.05, 20)
    rings = []
    for x, k, lift in (
        (-0.18, 0.5, 0.06),
        (-0.16, 0.56, 0.04),
        (0.02, 0.94, 0.01),
        (0.06, 1, 0),
        (0.19, 1, 0),
    ):
        ring = rounded_rectangle(width * k, tall * k, 0.03, 2)
        rings.append(
            np.c_[np.full(len(ring), x), ring[:, 0], ring[:, 1] + tall * k / 2 + lift + 0.02]
        )
    asm.add("body", cube_project(loft(rings, body)))
    asm.solid("body", (0.02, -half, 0.02), (0.19, half, tall + 0.02))
    asm.piece("body", np.concatenate([ring[::2] for ring in rings[:3]]))
    for y in (-half + 0.09, half - 0.09):
        asm.board("body", (-0.14, y - 0.02, 0), (0.16, y + 0.02, 0.045), black)
    side = 0.11
    frame = (0.17, -half + 0.03, 0.05), (0.195, half - side, tall - 0.01)
    asm.board("body", *frame, black, 0.01, solid=False)
    low, high = (0.18, -half + 0.055, 0.075), (0.2, half - side - 0.025, tall - 0.035)
    asm.board("screen_off", low, high, black, 0.004, {"+x": _dark()}, solid=False)
    shining = label(programme(picture, 208, 180), occlusion=0.0)
    asm.board("screen_on", low, high, black, 0.004, {"+x": shining}, 3.0, solid=False)
    chrome = metal_or("steel")
    y = half - side / 2
    for z, r in ((tall - 0.07, 0.03), (tall - 0.15, 0.03)):
        knob = tube([(0.188, y, z), (0.214, y, z)], r, 12, mat=chrome)
        asm.add("body", knob)
    grille = striped("#6a6d70", "#222324", 0.014, 2)
    asm.board("body", (0.185, y - 0.035, 0.07), (0.196, y + 0.035, 0.24), grille, solid=False)
    for s in (-1, 1):
        rod = tube([(0, s * 0.012, tall), (-0.02, s * 0.2, tall + 0.2)], 0.005, 5, mat=chrome)
        asm.add("body", rod)
    asm.board("body", (-0.03, -0.05, tall - 0.02), (0.03, 0.05, tall + 0.035), black, 0.01)
    return _states(asm, "old television with a picture tube", 17.0)


TV_STANDS = [(stand_doors, {}), (stand_drawers, {}), (stand_frame, {}), (stand_tall, {})]
TV_STANDS += [(stand_doors, {"wood": "walnut", "panel": "#8a5c38"})]
TVS = [
    (flat_tv, {}),
    (tube_tv, {}),
    (flat_tv, {"width": 1.0, "picture": "fish", "stand": "easel", "rim": "oak"}),
    (flat_tv, {"width": 1.3, "picture": "news", "stand": "wide", "bar": True}),
    (tube_tv, {"shell": "walnut", "picture": "western"}),
    (flat_tv, {"picture": "cooking", "rim": "#17181a"}),
]
