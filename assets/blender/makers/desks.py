"""Desks and console tables in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Model
from toolkit.shapes import extrude, tube

from .casework import Case, metal_or, smoked_glass
from .joinery import finish, leg, surface

Offset = tuple[float, float, float]


def desk_writing(
    width: float = 1.15,
    depth: float = 0.58,
    height: float = 0.76,
    wood: str = "walnut",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A writing table: three shallow drawers in a row over four tapering legs."""
    case = Case(wood, face, "birch", "knob", pull_finish="brass", offset=offset)
    half, x = width / 2, (-depth / 2, depth / 2 - 0.03)
    z0, z1 = height - 0.15, height - 0.024
    case.legs((x[0], x[1] + 0.02), (-half + 0.01, half - 0.01), z1, 0.03, (0.012, 0.024), sides=4)
    case.carcass(x, (-half + 0.02, half - 0.02), (z0, z1))
    case.top((x[0] - 0.01, depth / 2), (-half, half), (z1, height))
    inner = half - 0.055
    cuts = (-inner, -inner / 3, inner / 3, inner)
    for k in range(3):
        name = "drawer" if k == 1 else f"drawer_{k + 1}"
        case.drawer(name, x, (cuts[k], cuts[k + 1]), (z0, z1))
    return case.model("writing desk with three drawers", 21.0)


def desk_trestle(
    width: float = 1.35,
    depth: float = 0.65,
    height: float = 0.74,
    wood: str = "birch",
    frame: str = "#e9e7e1",
    box: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A board on two A-shaped trestles, a drawer box hung under it."""
    case = Case(wood, None, "birch", "groove", offset=offset)
    half, x, t = width / 2, (-depth / 2, depth / 2), 0.028
    paint = finish(frame, 2, offset)
    case.top(x, (-half, half), (height - t, height))
    z1 = height - t
    for s in (-1, 1):
        y = s * (half - 0.28)
        for sx in (-1, 1):
            for e in (-1, 1):
                foot = (sx * (depth / 2 - 0.05), y + e * 0.17)
                head = (sx * (depth / 2 - 0.08), y + e * 0.025)
                leg(case.asm, "body", foot, head, (0, z1 - 0.03), (0.017, 0.019), paint, 4)
        for e in (-1, 1):
            span = (y + e * 0.13 - 0.012, y + e * 0.13 + 0.012)
            case.board((-depth / 2 + 0.06, depth / 2 - 0.06), span, (0.18, 0.215), paint)
        case.board(
            (-depth / 2 + 0.06, depth / 2 - 0.06), (y - 0.04, y + 0.04), (z1 - 0.035, z1), paint
        )
    if box:
        y, deep, z0 = (-0.2, 0.2), (x[0] + 0.1, x[1] - 0.05), z1 - 0.13
        case.carcass(deep, y, (z0, z1))
        case.drawer("drawer", deep, y, (z0, z1), pull_at=0.75)
    return case.model("desk on trestles", 22.0)


def desk_pedestals(
    width: float = 1.4,
    depth: float = 0.68,
    height: float = 0.77,
    wood: str = "walnut",
    leather: str | None = "#2f4a3c",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A heavy desk: three drawers in each pedestal, one between, a leather top."""
    case = Case(wood, None, "birch", "cup", "shaker", "brass", offset, 0.02)
    half, x = width / 2, (-depth / 2, depth / 2 - 0.03)
    z1 = height - 0.03
    case.top((x[0] - 0.005, depth / 2), (-half, half), (z1, height), bevel=0.008)
    if leather:
        skin = plain(leather, 0.06, 40, offset)
        low, high = (
            (x[0] + 0.07, -half + 0.09, height - 0.001),
            (x[1] - 0.05, half - 0.09, height + 0.003),
        )
        case.asm.board("body", low, high, skin, 0, solid=False)
        case.supports[-1].z = height + 0.003
    k = 0
    for s in (-1, 1):
        a, b = sorted((s * (half - 0.02), s * (half - 0.41)))
        case.plinth((x[0], x[1] + 0.02), (a - 0.014, b + 0.014), 0.06, case.wood)
        case.carcass(x, (a, b), (0.05, z1))
        row = (z1 - 0.054) / 3
        for r in range(3):
            k += 1
            case.drawer(f"drawer_{k}", x, (a, b), (z1 - (r + 1) * row, z1 - r * row))
    y = (-half + 0.41, half - 0.41)
    case.board((x[0], x[0] + 0.018), y, (0.25, z1))
    case.board((x[0] + 0.018, x[1]), y, (z1 - 0.125, z1 - 0.112), case.across)
    case.drawer("drawer", x, y, (z1 - 0.112, z1 - 0.002))
    return case.model("desk with two pedestals and a leather top", 55.0)


def desk_metal(
    width: float = 1.3,
    depth: float = 0.62,
    height: float = 0.73,
    wood: str = "#f1f0ec",
    metal: str = "#2c2e30",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A height-adjustable desk: a plain top on two telescopic columns, a drawer, a hand switch."""
    case = Case(wood, None, "birch", "groove", offset=offset)
    half, x, t = width / 2, (-depth / 2, depth / 2), 0.025
    iron, bright = plain(metal, 0.05, 20), metal_or("steel")
    case.top(x, (-half, half), (height - t, height))
    z1 = height - t
    for s in (-1, 1):
        y = s * (half - 0.2)
        case.board((x[0] + 0.02, x[1] - 0.02), (y - 0.04, y + 0.04), (0, 0.035), iron, 0.008)
        case.board((-0.045, 0.045), (y - 0.033, y + 0.033), (0.03, 0.4), iron, 0.003)
        case.board((-0.034, 0.034), (y - 0.024, y + 0.024), (0.4, z1), bright, 0.002)
        case.board((x[0] + 0.06, x[1] - 0.06), (y - 0.03, y + 0.03), (z1 - 0.03, z1), iron)
    # the beam between the columns stops at the drawer's case
    for y in ((-half + 0.2, -half + 0.3), (-half + 0.72, half - 0.2)):
        case.board((-0.03, 0.03), y, (z1 - 0.045, z1 - 0.005), iron)
    y, deep, z0 = (-half + 0.3, -half + 0.72), (-0.2, x[1] - 0.04), z1 - 0.1
    case.carcass(deep, y, (z0, z1), outside=iron)
    case.drawer("drawer", deep, y, (z0, z1), pull_at=0.8)
    case.board((x[1] - 0.06, x[1] - 0.01), (half - 0.4, half - 0.28), (z1 - 0.022, z1), iron, 0.006)
    return case.model("standing desk", 34.0)


def desk_secretary(
    width: float = 1.0,
    depth: float = 0.55,
    height: float = 0.85,
    wood: str = "oak",
    face: str = "#dfe6e2",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Small drawers and pigeonholes stand on the back of the top; a drawer below."""
    case = Case(wood, face, "birch", "knob", pull_finish="brass", offset=offset)
    half, x, top = width / 2, (-depth / 2, depth / 2 - 0.02), 0.72
    case.legs((x[0], x[1] + 0.01), (-half, half), top - 0.02, 0.05, (0.012, 0.022), splay=0.03)
    case.carcass(x, (-half + 0.02, half - 0.02), (top - 0.13, top - 0.022))
    case.top((x[0] - 0.01, depth / 2), (-half, half), (top - 0.022, top))
    # Clear of the knobs of the small drawers.
    case.supports[-1].polygon = [(max(a, x[0] + 0.225), b) for a, b in case.supports[-1].polygon]
    case.drawer("drawer", x, (-half + 0.02, half - 0.02), (top - 0.13, top - 0.022))
    deep = (x[0], x[0] + 0.18)
    t = 0.014
    case.t = t
    case.carcass(deep, (-half, half), (top, height - 0.0))
    case.supports.append(surface("shelf_top", (deep[0], -half), (deep[1], half), height))
    third = width / 3
    for s in (-1, 1):
        case.board(deep, (s * third / 2 - t / 2, s * third / 2 + t / 2), (top + t, height - t))
        y = sorted((s * half - s * t, s * (third / 2)))
        case.drawer(
            f"drawer_{2 + (s > 0)}",
            (deep[0], deep[1] - 0.004),
            tuple(y),
            (top + t, height - t),
            0.1,
            0.014,
        )
    low, high = (deep[0], -third / 2), (deep[1], third / 2)
    case.supports.append(surface("niche", low, high, top + t, height - top - 2 * t))
    return case.model("secretary desk with small drawers", 27.0)


# ---- console tables
def console_half_round(
    width: float = 1.0,
    depth: float = 0.38,
    height: float = 0.8,
    wood: str = "walnut",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A half-moon top on three turned legs, a half-moon shelf below."""
    case = Case(wood, offset=offset)
    half, x0 = width / 2, -depth / 2
    a = np.linspace(-math.pi / 2, math.pi / 2, 19)
    edge = np.array([(depth * math.cos(t), half * math.sin(t)) for t in a])
    for name, k, z, t in (("top", 1.0, height, 0.024), ("shelf_1", 0.82, 0.2, 0.018)):
        outline = edge * k + [x0 + 0.01 * (k < 1), 0]
        mesh = extrude(outline, t, case.across, bevel_width=0.005).move(z=z - t)
        case.asm.add("body", mesh.weigh(1.2))
        case.asm.piece("body", np.array([(*p, q) for p in outline[::2] for q in (z - t, z)]))
        support = surface(name, (x0, -half), (x0 + 0.1, half), z, None if k == 1 else 0.46)
        shrink = 0.97 if k == 1 else 0.86
        inner = edge * k * shrink + [x0 + 0.006, 0]
        support.polygon = [(float(p), float(q)) for p, q in inner[1:-1:2]]
        case.supports.append(support)
    apron = edge * 0.92 + [x0, 0]
    mesh = extrude(np.r_[apron, apron[::-1] * 0.94 + [x0 * 0.06 + 0.004, 0]], 0.1, case.wood)
    case.asm.add("body", mesh.move(z=height - 0.124))
    for t in (-1.32, 0.0, 1.32):
        c, s = 0.86 * depth * math.cos(t) + x0, 0.86 * half * math.sin(t)
        leg(case.asm, "body", (c, s), (c, s), (0, height - 0.03), (0.012, 0.022), case.wood, 10)
    for s in (-1, 1):
        y = s * 0.84 * half
        leg(
            case.asm,
            "body",
            (x0 + 0.025, y),
            (x0 + 0.025, y),
            (0, height - 0.03),
            (0.012, 0.02),
            case.wood,
            10,
        )
    return case.model("half-round console table", 13.0)


def console_frame(
    width: float = 1.1,
    depth: float = 0.3,
    height: float = 0.78,
    top: str = "glass",
    metal: str = "brass",
    crossed: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A thin metal frame with a top and a shelf of glass or wood; crossed: X-shaped ends."""
    case = Case("oak", offset=offset)
    half, x0, x1, r = width / 2, -depth / 2, depth / 2, 0.011
    rod = metal_or(metal)
    board = smoked_glass() if top == "glass" else finish(top, 1, offset)
    for y in (-half, half - 2 * r):
        if crossed:
            for a, b in ((x0, x1), (x1, x0)):
                s = r if a < 0 else -r
                ends = [(a + s, y + r, 0.0), (b - s, y + r, height - 0.03)]
                case.asm.add("body", tube(ends, r, 4, mat=rod))
            case.asm.solid("body", (x0, y, 0), (x1, y + 2 * r, height - 0.02))
        else:
            for x in (x0, x1 - 2 * r):
                case.board((x, x + 2 * r), (y, y + 2 * r), (0, height - 0.02), rod)
    for name, z in (("top", height), ("shelf_1", 0.2)):
        low = half if name == "top" else half - 2 * r
        for x in (x0, x1 - 2 * r):
            case.board((x, x + 2 * r), (-low, low), (z - 0.036, z - 0.014), rod, solid=crossed)
        if not crossed or name == "top":
            case.board((x0, x1), (-low, low), (z - 0.014, z), board, 0.003)
            room = None if name == "top" else height - 0.036 - z
            case.supports.append(surface(name, (x0, -low), (x1, low), z, room, margin=0.02))
    return case.model(f"console table, {top} on a metal frame", 11.0)


def console_cupboard(
    width: float = 0.95,
    depth: float = 0.34,
    height: float = 0.82,
    wood: str = "#8fa3a0",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two drawers over two doors: a narrow hall cupboard on feet."""
    case = Case(wood, face, "birch", "knob", "shaker", "brass", offset)
    half, t, base = width / 2, case.t, 0.12
    x = (-depth / 2, depth / 2 - 0.03)
    case.legs((x[0], x[1] + 0.02), (-half, half), base + 0.01, 0.045, (0.016, 0.024), sides=4)
    case.carcass(x, (-half, half), (base, height - 0.024))
    case.top((x[0], depth / 2), (-half - 0.015, half + 0.015), (height - 0.024, height))
    split, z1 = height - 0.17, height - 0.026
    case.board(x, (-half + t, half - t), (split - t, split), case.inside)
    case.board(x, (-t / 2, t / 2), (base + t, height - 0.04), case.inside)
    for k, (side, y) in enumerate((("left", (-half, 0.0)), ("right", (0.0, half)))):
        case.drawer(f"drawer_{k + 1}", x, y, (split - t / 2, z1))
        inner = (-half + t, -t / 2) if k == 0 else (t / 2, half - t)
        door = f"door_{side}"
        case.bay(f"inside_{side}", x, inner, (base + t, split - t), 1, door, f"inside_{side}")
        case.door(door, x[1], y, (base, split - t / 2), k == 1)
    return case.model("console cupboard, two drawers and two doors", 24.0)


def console_drawers(
    width: float = 1.05,
    depth: float = 0.34,
    height: float = 0.8,
    wood: str = "oak",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two drawers on slender legs, a slatted shelf near the floor."""
    case = Case(wood, None, "birch", "knob", pull_finish="iron", offset=offset)
    half, x = width / 2, (-depth / 2, depth / 2 - 0.03)
    z0, z1 = height - 0.16, height - 0.024
    case.legs((x[0], x[1] + 0.02), (-half + 0.02, half - 0.02), z1, 0.025, (0.016, 0.022), sides=4)
    case.carcass(x, (-half + 0.03, half - 0.03), (z0, z1))
    case.top((x[0], depth / 2), (-half, half), (z1, height))
    for k, y in enumerate(((-half + 0.05, 0.0), (0.0, half - 0.05))):
        case.drawer(f"drawer_{k + 1}", x, y, (z0, z1))
    for k in range(4):
        a = x[0] + 0.012 + k * 0.076
        case.board((a, a + 0.062), (-half + 0.03, half - 0.03), (0.142, 0.16), case.across)
    low, high = (x[0] + 0.01, -half + 0.06), (x[1], half - 0.06)
    case.supports.append(surface("shelf_1", low, high, 0.16, z0 - 0.16))
    return case.model("console table with two drawers", 15.0)


DESKS = [
    (desk_writing, {}),
    (desk_trestle, {}),
    (desk_pedestals, {}),
    (desk_metal, {}),
    (desk_secretary, {}),
]
CONSOLES = [
    (console_half_round, {}),
    (console_frame, {}),
    (console_cupboard, {}),
    (console_drawers, {}),
    (console_frame, {"top": "pine", "metal": "iron", "crossed": True, "width": 1.15}),
]
