"""Wardrobes beyond the plain two-door one: mirrors, sliding doors, an old one, an open one."""

from __future__ import annotations

import numpy as np
from toolkit.model import Joint, Model
from toolkit.shapes import extrude, spline, tube

from .cabinets import mirror_glass
from .casework import Case, slatted
from .joinery import bar_handle, fabric, finish, open_closed, surface

Offset = tuple[float, float, float]
Span = tuple[float, float]


def _rail(case: Case, y: Span, z: float, x: float = 0.0) -> None:
    rod = tube([(x, y[0], z), (x, y[1], z)], 0.013, 8, mat=case.metal)
    case.asm.add("body", rod, solid=True)


def hang(case: Case, y: float, z: float, colour: str, length: float, x: float = 0.0) -> None:
    """A garment on a hanger from a rail at height z, seen edge on from the front."""
    asm, wire = case.asm, case.metal
    hook = [(x, y, z - 0.06), (x, y, z - 0.03), (x + 0.014, y, z), (x, y, z + 0.018)]
    asm.add("body", tube(spline(hook, 2), 0.0035, 4, mat=wire))
    top = z - 0.065
    w = 0.19
    outline = [(-0.03, top), (0.03, top), (w - 0.03, top - 0.05), (w, top - 0.12)]
    outline += [(w - 0.01, top - min(0.52, length)), (w - 0.05, top - min(0.52, length))]
    outline += [(w - 0.06, top - length), (-w + 0.06, top - length)]
    outline += [(-w + 0.05, top - min(0.52, length)), (-w + 0.01, top - min(0.52, length))]
    outline += [(-w, top - 0.12), (-w + 0.03, top - 0.05)]
    cloth = extrude(outline, 0.034, fabric(colour, (y * 9, 0, 0), 0.08), axis="y")
    asm.add("body", cloth.move(x, y, 0))


CLOTHES = ("#3f5568", "#b9473f", "#d9d3c6", "#5b7355", "#2f3136", "#c99a4b", "#7c9db5", "#8a5a72")


def _folded(case: Case, y: Span, z: float, first: int, many: int) -> None:
    """A pile of jumpers and shirts on a board."""
    middle, high = (y[0] + y[1]) / 2, 0.036
    for k in range(many):
        colour, wide = CLOTHES[(first * 3 + k) % len(CLOTHES)], 0.148 - 0.006 * (k * 5 % 3)
        aside, front = 0.008 * (k * 3 % 4 - 1.5), 0.15 + 0.008 * (k * 7 % 3)
        low = (front - 0.36, middle + aside - wide, z + k * high)
        top = (front, middle + aside + wide, z + (k + 1) * high - 0.002)
        cloth = fabric(colour, (k, first, 0), 0.08)
        case.asm.board("body", low, top, cloth, 0.014, solid=False)
    case.asm.solid("body", (-0.22, middle - 0.16, z), (0.166, middle + 0.16, z + many * high))


def three_door(
    width: float = 1.4,
    height: float = 2.02,
    depth: float = 0.58,
    wood: str = "oak",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Three doors, the middle one a looking glass; drawers under the middle and right bays."""
    case = Case(wood, face, "birch", offset=offset, style="slab")
    half, t, base = width / 2, case.t, 0.07
    x = (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), base)
    case.carcass(x, (-half, half), (base, height - 0.025))
    case.top((x[0], depth / 2), (-half - 0.006, half + 0.006), (height - 0.025, height))
    third = width / 3
    floor, roof, low = base + t, height - 0.025 - t, base + 0.3
    for s in (-1, 1):
        case.board(x, (s * third / 2 - t / 2, s * third / 2 + t / 2), (floor, roof), case.inside)
    cells = [
        ("left", -half + t, -third / 2 - t / 2, floor, -half, -third / 2),
        ("middle", -third / 2 + t / 2, third / 2 - t / 2, low + t, -third / 2, third / 2),
        ("right", third / 2 + t / 2, half - t, low + t, third / 2, half),
    ]
    for k, (side, a, b, z0, y0, y1) in enumerate(cells):
        shelves = 4 if side == "left" else 0
        name, door = f"inside_{side}", f"door_{side}"
        if side != "left":
            case.board(x, (a, b), (low, low + t), case.inside)
            case.drawer(f"drawer_{k}", x, (y0, y1), (base, low + t / 2), pull_at=0.6)
            _rail(case, (a, b), roof - 0.09)
        case.bay(name, (x[0], x[1] - 0.005), (a, b), (z0, roof), shelves, door, side)
        if side == "middle":
            box = (x[1], y0 + 0.002, low + t / 2), (x[1] + 0.02, y1 - 0.002, height - 0.028)
            glass = {"+x": mirror_glass(height)}
            case.asm.board(door, *box, case.wood, 0.003, glass, weight=1.3)
            bar_handle(case.asm, door, x[1] + 0.02, y1 - 0.035, 1.05, 0.2, case.metal, reach=0.026)
            joint = Joint("revolute", (x[1] + 0.02, y0, 0.0), (0, 0, -1), 0.0, 1.9)
            case.joints[door], case.settings[door] = joint, {"joint": door}
            case.states += open_closed(door, door)
        else:
            bottom = base if side == "left" else low + t / 2
            case.door(door, x[1], (y0, y1), (bottom, height - 0.026), side == "right", pull_z=1.05)
    return case.model("wardrobe, three doors with a mirror", 110.0)


def sliding(
    width: float = 1.4,
    height: float = 2.05,
    depth: float = 0.62,
    wood: str = "#eceae5",
    face: str = "oak",
    mirrored: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two sliding doors on two tracks, one of them a looking glass if wanted."""
    case = Case(wood, face, "birch", offset=offset, t=0.022)
    half, t, base = width / 2, case.t, 0.05
    x = (-depth / 2, depth / 2 - 0.06)
    case.plinth((x[0], depth / 2), (-half, half), base)
    case.carcass((x[0], depth / 2), (-half, half), (base, height))
    case.supports.append(_top((x[0], depth / 2), half, height))
    floor, roof = base + t, height - t
    case.board(x, (-0.011, 0.011), (floor, roof), case.inside)
    case.board((x[1] + 0.002, depth / 2 + 0.004), (-half + t, half - t), (roof - 0.04, roof))
    case.bay("inside_left", x, (-half + t, -0.011), (floor, roof), 4, "door_left", "left")
    case.bay("inside_right", x, (0.011, half - t), (floor, roof), 0, "door_right", "right")
    _rail(case, (0.011, half - t), roof - 0.1, -0.04)
    leaf, stroke = (width - 2 * t) / 2 + 0.02, (width - 2 * t) / 2 - 0.02
    for side, s, track in (("left", -1, 0.004), ("right", 1, 0.03)):
        y0 = -half + t if s < 0 else half - t - leaf
        door, xd = f"door_{side}", x[1] + track
        skin = {"+x": mirror_glass(height)} if mirrored and s > 0 else None
        box = (xd, y0, floor + 0.002), (xd + 0.024, y0 + leaf, roof - 0.035)
        case.asm.board(door, *box, case.face_up, 0.003, skin, weight=1.2)
        frame = finish("#c9ccce", 2) if skin else case.metal
        for y in (y0, y0 + leaf - 0.03):
            strip = (xd + 0.022, y, floor + 0.004), (xd + 0.029, y + 0.03, roof - 0.037)
            case.asm.board(door, *strip, frame, 0.002, solid=False)
        axis = (0, -s, 0)
        joint = Joint("prismatic", (xd, y0, floor), axis, 0.0, round(stroke, 3))
        case.joints[door], case.settings[door] = joint, {"joint": door}
        case.states += open_closed(door, door, 0.02, 0.25)
    return case.model("wardrobe with sliding doors", 105.0)


def _top(x: Span, half: float, z: float):
    return surface("top", (x[0], -half), (x[1], half), z)


def old_wardrobe(
    width: float = 1.05,
    height: float = 2.08,
    depth: float = 0.56,
    wood: str = "walnut",
    offset: Offset = (0, 0, 0),
) -> Model:
    """An old wardrobe: bun feet, a drawer at the foot, framed doors, an arched crown."""
    case = Case(wood, None, "pine", "ring", "shaker", "brass", offset, 0.022)
    half, t, base = width / 2, case.t, 0.1
    x = (-depth / 2, depth / 2 - 0.022)
    case.legs((x[0], depth / 2), (-half, half), base, 0.06, (0.03, 0.042), sides=10)
    case.carcass(x, (-half, half), (base, height - 0.16))
    skirt = (x[0], depth / 2 + 0.012), (-half - 0.014, half + 0.014)
    case.board(*skirt, (base, base + 0.035), case.across, 0.008)
    z1 = height - 0.16
    case.top(*skirt, (z1, z1 + 0.035), bevel=0.012)
    ys = np.linspace(-half - 0.01, half + 0.01, 13)
    crown = [(float(ys[-1]), z1 + 0.03), (float(ys[0]), z1 + 0.03)]
    crown += [(float(y), z1 + 0.05 + 0.11 * float(np.cos(1.5 * y / half) ** 1.0)) for y in ys]
    mesh = extrude(crown, 0.03, case.across, axis="x")
    case.asm.add("body", mesh.move(depth / 2 - 0.006, 0, 0))
    points = np.array([(a, *p) for a in (depth / 2 - 0.02, depth / 2) for p in crown])
    case.asm.piece("body", points)
    low = base + 0.3
    case.board(x, (-half + t, half - t), (low, low + t), case.inside)
    case.pulls = "knobs"
    case.drawer("drawer", x, (-half + 0.01, half - 0.01), (base + 0.036, low + t), stroke=0.3)
    case.pulls = "ring"
    floor, roof = low + t, z1 - t
    case.board(x, (-0.011, 0.011), (floor, roof), case.inside)
    for side, a, b, y0, y1 in (
        ("left", -half + t, -0.011, -half + 0.008, 0.0),
        ("right", 0.011, half - t, 0.0, half - 0.008),
    ):
        door = f"door_{side}"
        shelves = 3 if side == "left" else 0
        case.bay(f"inside_{side}", (x[0], x[1] - 0.01), (a, b), (floor, roof), shelves, door, side)
        case.door(door, x[1], (y0, y1), (low + t, z1), side == "right", 0.022, 1.2, rail=0.085)
    _rail(case, (0.011, half - t), roof - 0.1)
    return case.model("old wooden wardrobe with a drawer", 95.0)


def open_wardrobe(
    width: float = 1.2,
    height: float = 1.85,
    depth: float = 0.52,
    wood: str = "birch",
    metal: str = "iron",
    offset: Offset = (0, 0, 0),
) -> Model:
    """No doors: clothes on a rail, shelves at the side, two drawers at the foot."""
    case = Case(wood, None, "birch", "groove", offset=offset)
    half, t, base = width / 2, 0.022, 0.05
    case.t = t
    x = (-depth / 2, depth / 2 - 0.02)
    split = half - 0.42
    case.plinth(x, (-half, half), base)
    case.carcass((x[0], depth / 2), (-half, half), (base, height))
    case.board(x, (split - t / 2, split + t / 2), (base + t, height - t))
    case.supports.append(_top((x[0], depth / 2), half, height))
    low = base + 0.34
    left = (-half + t, split - t / 2)
    case.board(x, left, (low, low + t), case.inside)
    middle = (left[0] + left[1]) / 2
    for k, span in enumerate(((left[0], middle), (middle, left[1]))):
        case.drawer(f"drawer_{k + 1}", x, span, (base + t, low), pull_at=0.8)
    rail_z = height - 0.13
    _rail(case, left, rail_z)
    ys = np.linspace(left[0] + 0.07, left[1] - 0.07, 9)
    for k, y in enumerate(ys):
        if k != 6:
            length = (0.74, 0.95, 0.7, 0.82, 1.02, 0.72, 0, 0.9, 0.76)[k]
            hang(case, float(y), rail_z, CLOTHES[k % len(CLOTHES)], length)
    case.asm.solid(
        "body", (-0.18, left[0] + 0.04, rail_z - 1.0), (0.18, left[1] - 0.04, rail_z - 0.1)
    )
    right = (split + t / 2, half - t)
    case.bay("", x, right, (base + t, height - t), 4, prefix="right", container=False)
    levels = [s for s in case.supports if s.name.startswith("right")]
    for k in (1, 2, 4):
        case.supports.remove(levels[k])
        _folded(case, right, levels[k].z, k, 6 if k < 4 else 3)
    return case.model("open wardrobe with clothes on a rail", 60.0)


def louvred(
    width: float = 0.95,
    height: float = 1.9,
    depth: float = 0.55,
    wood: str = "#f2f0ea",
    dark: str = "#b9b4a6",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two louvred doors over two wide drawers, on a plinth."""
    case = Case(wood, None, "birch", "knobs", "shaker", "brass", offset)
    half, t, base = width / 2, case.t, 0.06
    x = (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), base)
    case.carcass(x, (-half, half), (base, height - 0.03))
    case.top((x[0], depth / 2 + 0.01), (-half - 0.01, half + 0.01), (height - 0.03, height))
    low = base + 0.5
    case.board(x, (-half + t, half - t), (low, low + t), case.inside)
    for k in range(2):
        z = (base + 0.25 * k + 0.01, base + 0.25 * (k + 1) + 0.01)
        case.drawer(f"drawer_{2 - k}", x, (-half, half), z)
    case.panel = slatted(wood if wood[0] == "#" else "#c9a06a", dark, 0.045)
    case.pulls = "knob"
    floor, roof = low + t, height - 0.03 - t
    case.board(x, (-0.009, 0.009), (floor, roof), case.inside)
    for side, a, b, y0, y1 in (
        ("left", -half + t, -0.009, -half, 0.0),
        ("right", 0.009, half - t, 0.0, half),
    ):
        door = f"door_{side}"
        case.bay(
            f"inside_{side}", (x[0], x[1] - 0.01), (a, b), (floor, roof),
            3 if side == "left" else 0, door, side,
        )  # fmt: skip
        case.door(door, x[1], (y0, y1), (low + t, height - 0.032), side == "right", pull_z=1.15)
    _rail(case, (0.009, half - t), roof - 0.1)
    return case.model("wardrobe with louvred doors and two drawers", 70.0)


WARDROBES = [
    (three_door, {}),
    (sliding, {}),
    (old_wardrobe, {}),
    (open_wardrobe, {}),
    (louvred, {}),
    (sliding, {"wood": "#3b3734", "face": "#d8d2c6", "mirrored": False}),
]
