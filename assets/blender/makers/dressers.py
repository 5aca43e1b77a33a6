"""Chests of drawers, nightstands and filing cabinets in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain, shade
from toolkit.model import Maker, Model, Support, cylinder_piece, round_polygon
from toolkit.sampling import noise_offset
from toolkit.shapes import extrude, lathe

from .casework import Case, cane, metal_or
from .designs import designed
from .joinery import finish, leg, surface

Offset = tuple[float, float, float]


def dresser_mixed(
    width: float = 1.2,
    height: float = 0.8,
    depth: float = 0.44,
    wood: str = "oak",
    face: str | None = None,
    woven: bool = False,
    pulls: str = "knob",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A sideboard on splayed legs: three drawers in the middle, a door on either side."""
    case = Case(wood, face, "birch", pulls, "shaker" if woven else "slab", "brass", offset)
    case.panel = cane() if woven else None
    half, t, base = width / 2, case.t, 0.2
    x = (-depth / 2, depth / 2 - 0.02)
    case.legs((x[0], depth / 2), (-half, half), base + 0.01, 0.09, (0.012, 0.022), splay=0.035)
    case.carcass(x, (-half, half), (base, height - 0.022))
    case.top((x[0], depth / 2 + 0.004), (-half - 0.006, half + 0.006), (height - 0.022, height))
    third = width / 6
    z0, z1 = base, height - 0.024
    for s in (-1, 1):
        span = (s * third - t / 2, s * third + t / 2)
        case.board(x, span, (base + t, height - 0.04), case.inside)
    row = (z1 - z0) / 3
    case.style = "slab"
    for k in range(3):
        case.drawer(f"drawer_{k + 1}", x, (-third, third), (z1 - (k + 1) * row, z1 - k * row))
    case.style = "shaker" if woven else "slab"
    for side, a, b, y0, y1 in (
        ("left", -half + t, -third - t / 2, -half, -third),
        ("right", third + t / 2, half - t, third, half),
    ):
        door = f"door_{side}"
        case.bay(
            f"inside_{side}", (x[0], x[1] - 0.005), (a, b), (base + t, height - 0.04), 1, door, side
        )
        case.door(door, x[1], (y0, y1), (z0, z1), side == "right")
    return case.model("sideboard dresser, three drawers and two doors", 46.0)


def dresser_old(
    width: float = 0.92,
    height: float = 0.9,
    depth: float = 0.48,
    wood: str = "walnut",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An old chest: two short drawers over two long ones, framed fronts, bracket feet."""
    case = Case(wood, face, "pine", "cup", "shaker", "brass", offset, 0.022)
    half, base = width / 2, 0.12
    x = (-depth / 2, depth / 2 - 0.022)
    for y in (-half, half - 0.11):
        for a in (x[0], x[1] - 0.09):
            case.board((a, a + 0.11), (y, y + 0.11), (0, base), case.across, 0.02)
    skirt = (x[0], depth / 2 + 0.01), (-half - 0.01, half + 0.01)
    case.board(*skirt, (base - 0.03, base + 0.012), case.across, 0.008)
    case.carcass(x, (-half, half), (base, height - 0.03))
    case.top((x[0], depth / 2 + 0.02), (-half - 0.02, half + 0.02), (height - 0.03, height))
    z1, z0 = height - 0.034, base + 0.014
    short = 0.17
    row = (z1 - short - z0) / 2
    case.board((x[1] - 0.05, x[1]), (-half + 0.02, half - 0.02), (z1 - short - 0.008, z1 - short))
    for k, y in enumerate(((-half + 0.012, 0.0), (0.0, half - 0.012))):
        case.drawer(f"drawer_{k + 1}", x, y, (z1 - short, z1))
    case.pulls = "cup"
    for k in range(2):
        z = (z1 - short - (k + 1) * row, z1 - short - k * row)
        case.drawer(f"drawer_{k + 3}", x, (-half + 0.012, half - 0.012), z)
    return case.model(f"old {wood} chest of drawers", 48.0)


def dresser_frame(
    width: float = 0.78,
    height: float = 1.02,
    depth: float = 0.42,
    colours: tuple[str, ...] = ("#d8d2c6", "#b8c4c0", "#8fa5a5", "#6c8487"),
    wood: str = "birch",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A light frame of metal or wood, four drawers in graded colours hanging in it."""
    case = Case(wood, None, "birch", "groove", offset=offset)
    half, r = width / 2, 0.014
    x0, x1 = -depth / 2, depth / 2 - 0.02
    rod = metal_or("iron")
    for a in (x0, x1 - 2 * r):
        for y in (-half, half - 2 * r):
            case.board((a, a + 2 * r), (y, y + 2 * r), (0, height - 0.022), rod)
    case.top((x0, depth / 2 + 0.004), (-half, half), (height - 0.022, height))
    rows, low = 4, 0.2
    row = (height - 0.05 - low) / rows
    for k in range(rows):
        z1 = height - 0.05 - k * row
        face = finish(colours[k % len(colours)], 1, offset)
        y = (-half + 2 * r + 0.004, half - 2 * r - 0.004)
        case.drawer(f"drawer_{k + 1}", (x0, x1), y, (z1 - row + 0.014, z1), pull_at=0.82, face=face)
        for y in (-half, half - 2 * r):
            case.board((x0, x1), (y, y + 2 * r), (z1 - row, z1 - row + 0.012), rod, solid=False)
    case.board((x0, x0 + 0.01), (-half, half), (low, height - 0.022), case.wood)
    return case.model("dresser, four drawers in an open frame", 30.0)


def dresser_wide(
    width: float = 1.24,
    height: float = 0.74,
    depth: float = 0.46,
    wood: str = "#eceae5",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Eight drawers in two columns, on a sled base of metal."""
    case = Case(wood, face, "birch", "bar", pull_finish="brass", offset=offset)
    half, t, base = width / 2, case.t, 0.16
    x = (-depth / 2, depth / 2 - 0.02)
    gold = metal_or("brass")
    for y in (-half + 0.1, half - 0.125):
        case.board(x, (y, y + 0.025), (0, 0.025), gold)
        for a in (x[0], x[1] - 0.025):
            case.board((a, a + 0.025), (y, y + 0.025), (0.02, base), gold)
    case.carcass(x, (-half, half), (base, height - 0.022))
    case.top((x[0], depth / 2 + 0.004), (-half - 0.004, half + 0.004), (height - 0.022, height))
    case.board(x, (-t / 2, t / 2), (base + t, height - 0.04), case.inside)
    z1, z0 = height - 0.024, base + 0.002
    row = (z1 - z0) / 3
    k = 0
    for r in range(3):
        for y in ((-half, 0.0), (0.0, half)):
            k += 1
            case.drawer(f"drawer_{k}", x, y, (z1 - (r + 1) * row, z1 - r * row))
    return case.model("wide dresser, six drawers", 55.0)


# ---- nightstands
def nightstand_two(
    width: float = 0.46,
    height: float = 0.6,
    depth: float = 0.4,
    wood: str = "#eceae5",
    face: str | None = None,
    style: str = "slab",
    rows: int = 3,
    pulls: str = "knob",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A small chest: two or three drawers down to the plinth."""
    case = Case(wood, face, "birch", pulls, style, "brass", offset)
    half, base = width / 2, 0.05
    x = (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), base)
    case.carcass(x, (-half, half), (base, height - 0.022))
    case.top((x[0], depth / 2 + 0.006), (-half - 0.008, half + 0.008), (height - 0.022, height))
    z1, z0 = height - 0.024, base + 0.002
    row = (z1 - z0) / rows
    for k in range(rows):
        name = "drawer" if k == 0 else f"drawer_{k + 1}"
        case.drawer(name, x, (-half, half), (z1 - (k + 1) * row, z1 - k * row))
    return case.model(f"nightstand with {rows} drawers", 16.0)


def nightstand_leggy(
    width: float = 0.46,
    height: float = 0.6,
    depth: float = 0.38,
    wood: str = "walnut",
    face: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A shallow drawer on four long, thin legs, with a slatted shelf low down."""
    case = Case(wood, face, "birch", "knob", pull_finish="brass", offset=offset)
    half, z0, z1 = width / 2, height - 0.16, height - 0.02
    x = (-depth / 2, depth / 2 - 0.02)
    case.legs((x[0], depth / 2), (-half, half), z1, 0.022, (0.013, 0.018), sides=4)
    case.carcass(x, (-half + 0.01, half - 0.01), (z0, z1))
    case.top((x[0] - 0.005, depth / 2 + 0.01), (-half - 0.01, half + 0.01), (z1, height))
    case.drawer("drawer", x, (-half + 0.035, half - 0.035), (z0, z1))
    shelf = 0.16
    for k in range(5):
        a = x[0] + 0.01 + k * (depth - 0.03) / 5
        case.board((a, a + 0.055), (-half + 0.01, half - 0.01), (shelf - 0.014, shelf), case.across)
    case.t = 0.014
    case.supports.append(_shelf(x, half, shelf, z0 - shelf))
    return case.model("nightstand on long legs, one drawer and a shelf", 9.0)


def _shelf(x, half: float, z: float, room: float):
    return surface("compartment", (x[0], -half), (x[1], half), z, room, margin=0.04)


def nightstand_round(
    radius: float = 0.21,
    height: float = 0.52,
    wood: str = "birch",
    face: str = "#7f9a8c",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A drum on three legs with a drawer let into it."""
    case = Case(wood, face, "birch", "knob", pull_finish="brass", offset=offset)
    r, base, z0 = radius, 0.2, 0.22
    drum, top = finish(face, 2, offset), finish(wood, 1, offset)
    xf = r * 0.78
    half = math.sqrt(r * r - xf * xf)
    n = 28
    # the wall leaves a flat front at xf, where the drawer is
    ring = []
    start = math.atan2(half, xf)
    for k in range(n + 1):
        a = start + (2 * math.pi - 2 * start) * k / n
        ring.append((r * math.cos(a), r * math.sin(a)))
    wall = extrude(ring, 0.03, drum).move(z=base)
    case.asm.add("body", wall)
    case.asm.piece("body", np.array([(x, y, z) for x, y in ring[::3] for z in (base, base + 0.03)]))
    t = 0.016
    inner = [(x * (r - t) / r, y * (r - t) / r) for x, y in ring]
    shell = ring + inner[::-1]
    tall = height - 0.02 - base - 0.03
    case.asm.add("body", extrude(shell, tall, drum).move(z=base + 0.03))
    for k in range(0, n, 4):
        pts = [ring[k], ring[min(k + 4, n)], inner[k], inner[min(k + 4, n)]]
        piece = [(x, y, z) for x, y in pts for z in (base + 0.03, height - 0.02)]
        case.asm.piece("body", np.array(piece))
    lid = [(0, height - 0.02), (r + 0.004, height - 0.02), (r + 0.01, height - 0.012)]
    lid += [(r + 0.008, height), (0, height)]
    case.asm.add("body", lathe(lid, 32, mat=top, weight=1.3))
    case.asm.piece("body", cylinder_piece(r + 0.01, height - 0.02, height, 14))
    case.supports.append(Support("top", height, round_polygon(r - 0.008, 14)))
    reach = (-math.sqrt((r - t) ** 2 - half**2), xf - 0.006)
    case.drawer("drawer", reach, (-half, half), (base + 0.032, height - 0.022), thick=0.016)
    for k in range(3):
        a = 2 * math.pi * k / 3
        c, s = math.cos(a), math.sin(a)
        foot, head = (0.95 * r * c, 0.95 * r * s), (0.7 * r * c, 0.7 * r * s)
        leg(case.asm, "body", foot, head, (0, z0), (0.011, 0.018), finish(wood, 2, offset), 10)
    return case.model("round nightstand with a drawer", 8.0)


def nightstand_door(
    width: float = 0.42,
    height: float = 0.56,
    depth: float = 0.36,
    wood: str = "oak",
    face: str = "#efece4",
    woven: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An open niche over a cupboard with one door, on a metal frame."""
    case = Case(wood, face, "birch", "knob", "shaker" if woven else "slab", "iron", offset)
    case.panel = cane() if woven else None
    half, t, base = width / 2, case.t, 0.12
    x = (-depth / 2, depth / 2 - 0.02)
    iron = metal_or("iron")
    for y in (-half, half - 0.018):
        for a in (x[0], x[1] - 0.005):
            case.board((a, a + 0.018), (y, y + 0.018), (0, base), iron)
    case.carcass(x, (-half, half), (base, height - 0.018))
    case.top((x[0], depth / 2), (-half, half), (height - 0.018, height))
    middle = height - 0.19
    case.board(x, (-half + t, half - t), (middle - t, middle), case.wood)
    inner = (-half + t, half - t)
    case.bay("compartment", x, inner, (middle, height - 0.018 - t), prefix="", container=True)
    case.supports[-1].name = "compartment"
    case.bay("inside", (x[0], x[1] - 0.004), inner, (base + t, middle - t), 0, "door", "inside")
    case.door("door", x[1], (-half, half), (base, middle - t / 2), True, rail=0.045)
    return case.model("nightstand with a niche and a door", 12.0)


# ---- filing cabinets
FOLDERS = ("#c9a25a", "#7f9fc0", "#c96f5a", "#86a878", "#d8c27a", "#9a86b5")


def filing_cabinet(
    rows: int = 3,
    width: float = 0.42,
    height: float = 1.02,
    depth: float = 0.55,
    colour: str = "#8d9499",
    face: str | None = None,
    castors: bool = False,
    wooden: bool = False,
    flat: int = 0,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A steel (or wooden) filing cabinet: deep drawers with label holders and hanging folders.

    flat: so many shallow drawers on top (a pedestal under a desk); castors lift it.
    """
    case = Case(colour, face, colour if not wooden else "birch", "cup", offset=offset, t=0.014)
    case.style = "shaker" if wooden else "slab"
    case.metal = metal_or("brass" if wooden else "steel")
    half, base = width / 2, 0.06 if castors else 0.04
    x = (-depth / 2, depth / 2 - 0.022)
    if castors:
        tyre = plain("#202224", 0.05, 20)
        for a in (x[0] + 0.05, x[1] - 0.04):
            for y in (-half + 0.05, half - 0.05):
                wheel = [(0, -0.012), (0.029, -0.012), (0.029, 0.012), (0, 0.012)]
                mesh = lathe(wheel, 8, mat=tyre).turn(rx=math.pi / 2).move(a, y, 0.029)
                case.asm.add("body", mesh, solid=True)
                case.board((a - 0.012, a + 0.012), (y - 0.016, y + 0.016), (0.03, base), tyre)
    else:
        case.plinth(x, (-half, half), base, plain(shade("#8d9499", 0.5), 0.05, 10))
    case.carcass(x, (-half, half), (base, height - 0.016))
    case.top((x[0], depth / 2), (-half, half), (height - 0.016, height), case.wood, 0.005)
    z1, z0 = height - 0.02, base + 0.004
    weights = [0.45] * flat + [1.0] * rows
    unit = (z1 - z0) / sum(weights)
    holder, paper = case.metal, plain("#f4f1e6", 0.03)
    z = z1
    for k, w in enumerate(weights):
        name = f"drawer_{k + 1}"
        span = (z - w * unit, z)
        low, high = case.drawer(
            name, x, (-half + 0.004, half - 0.004), span, 0.42 * 1.0, 0.022, 0.62, 0.5
        )
        xf, cz = x[1] + 0.022, span[0] + 0.8 * w * unit
        if w == 1.0:
            card = (xf - 0.002, -0.05, cz - 0.02), (xf + 0.005, 0.05, cz + 0.02)
            case.asm.board(name, *card, holder, 0.002, solid=False)
            note = (xf, -0.042, cz - 0.013), (xf + 0.0065, 0.042, cz + 0.013)
            case.asm.board(name, *note, paper, solid=False)
            n = 5
            for i in range(n):
                a = low[0] + 0.04 + 0.03 * i
                folder = finish(FOLDERS[(i + k) % len(FOLDERS)], 1, offset)
                tab = span[1] - 0.045
                box = (a, low[1] + 0.02, low[2] + 0.008), (a + 0.012, high[1] - 0.02, tab)
                case.asm.board(name, *box, folder, solid=False)
            block = (low[0] + 0.04, low[1] + 0.02, low[2] + 0.008)
            end = (low[0] + 0.03 * n + 0.02, high[1] - 0.02, span[1] - 0.05)
            case.asm.solid(name, block, end)
            floor = case.supports[-1]
            front_of = low[0] + 0.04 + 0.03 * n
            floor.polygon = [(max(px, front_of), py) for px, py in floor.polygon]
        z -= w * unit
    return case.model(f"filing cabinet, {len(weights)} drawers", 9.0 + 26 * height * width)


def filing_cabinet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random filing cabinet."""
    return {"offset": noise_offset(rng)}


DRESSERS = [(dresser_mixed, {}), (dresser_old, {}), (dresser_frame, {}), (dresser_wide, {})]
DRESSERS += [(dresser_mixed, {"wood": "walnut", "woven": True})]
NIGHTSTANDS = [(nightstand_two, {}), (nightstand_leggy, {}), (nightstand_round, {})]
NIGHTSTANDS += [(nightstand_door, {})]
NIGHTSTANDS += [(nightstand_round, {"wood": "walnut", "face": "#e6e2d8"})]

MODELS: dict[str, Maker] = {
    "filing_cabinet": designed(
        [
            (filing_cabinet, {}),
            (filing_cabinet, {"rows": 4, "height": 1.32, "width": 0.46, "colour": "#b9b6a6"}),
            (filing_cabinet, {"rows": 2, "height": 0.7, "colour": "#5d7d8f"}),
            (
                filing_cabinet,
                {"rows": 1, "flat": 2, "height": 0.62, "castors": True, "colour": "#e9e9e6"},
            ),
            (filing_cabinet, {"rows": 2, "width": 0.85, "height": 0.72, "colour": "#3d4246"}),
            (
                filing_cabinet,
                {"rows": 2, "height": 0.74, "width": 0.48, "colour": "oak", "wooden": True},
            ),
        ],
        filing_cabinet_random,
    ),
}
