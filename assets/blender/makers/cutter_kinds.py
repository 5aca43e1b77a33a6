"""Razors, box cutters and screwdrivers in their kinds, lying flat, handles towards -X."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Model
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle

from makers.cleaner_forms import maker
from makers.sharp_tools import STEEL, STEEL_DARK, box_cutter, razor, screwdriver, sharp


# ---- razors
def safety_razor(colour: str) -> Model:
    """A double-edged safety razor: a knurled metal handle and its curved head."""
    chrome = metal(colour, "5c6268")
    edge, dark = plain("f4f6f8", 0.0), plain("#3a4046", 0.0)
    profile = [(0, -0.1), (0.0075, -0.1), (0.0085, -0.095), (0.0085, -0.05), (0.006, -0.046)]
    profile += [(0.006, -0.04), (0.008, -0.036), (0.008, -0.012), (0.005, -0.006), (0.005, 0)]
    handle = lathe(
        [*profile, (0, 0)],
        12,
        mat=chrome,
        rib=lambda k, i: 1 - 0.13 * (i % 2) if k in (3, 6, 7) else 1,
    ).turn(ry=math.pi / 2)
    hold, blades = [handle], []
    for x, thick, mat in ((0.0, 0.0045, chrome), (0.0065, 0.006, chrome)):
        t = np.linspace(-1, 1, 7)
        bow = 0.004 if x else 0.003
        near = [(x - bow * a * a, 0.0135 * a) for a in t]
        far = [(px + thick * (1 - 0.5 * a * a), z) for (px, z), a in zip(near, t, strict=True)]
        plate = extrude([*near, *far[::-1]], 0.044, mat, axis="y")
        hold.append(plate)
    blades.append(box(0.002, 0.046, 0.031, (0.0035, 0, -0.0155), edge))
    blades.append(box(0.0022, 0.03, 0.0312, (0.0035, 0, -0.0156), dark))
    for mesh in (*hold, *blades):
        mesh.turn(ry=-0.07).move(z=0.0155)
    pieces = [handle.v, np.concatenate([m.v for m in hold[1:]])]
    return sharp("safety razor", hold, blades, pieces, 0.08, 0.112)


def disposable(colour: str, turn: float, y: float) -> tuple[list[Mesh], list[Mesh]]:
    """One thin ribbed disposable razor."""
    grip, edge = plain(colour, 0.04), plain("eef1f4", 0.0)
    line = [(-0.095, -0.004), (-0.09, -0.0065), (-0.02, -0.0045), (0.008, -0.007), (0.012, -0.02)]
    line += [(x, -y) for x, y in line[::-1]]
    handle = extrude(line, 0.008, grip, bevel_width=0.0015)
    hold = [handle]
    for k in range(5):
        hold.append(box(0.004, 0.012, 0.0015, (-0.08 + 0.009 * k, 0, 0.008), grip))
    hold.append(box(0.016, 0.042, 0.008, (0.018, 0, 0.001), plain("#f4f4f2", 0.03), 0.001))
    blades = [box(0.0026, 0.038, 0.0016, (0.0145 + 0.006 * k, 0, 0.009), edge) for k in range(2)]
    for mesh in (*hold, *blades):
        mesh.turn(rz=turn).move(y=y)
    return hold, blades


def disposable_pair(colour: str) -> Model:
    """Two disposable razors lying together."""
    a, b = disposable(colour, 0.25, 0.026), disposable(colour, -0.3, -0.03)
    pieces = [np.concatenate([m.v for m in group[0]]) for group in (a, b)]
    return sharp("disposable razors", a[0] + b[0], a[1] + b[1], pieces, 0.02, 0.125)


def razor_form(shape: str, colour: str, accent: str) -> Model:
    """A wet, cut-throat, safety or disposable razor; an electric shaver cuts nobody."""
    if shape in ("wet", "cut-throat"):
        length = 0.12529974802053634 if shape == "wet" else 0.19
        return razor(shape, colour, accent, length)
    if shape == "safety":
        return safety_razor(colour)
    return disposable_pair(colour)


# ---- box cutters
def scored_blade(x0: float, x1: float, wide: float, z: float) -> list[Mesh]:
    """A snap-off blade between two x, its edge towards -y."""
    steel, edge = metal("d4d8dc", "9aa0a6"), plain("f4f6f8", 0.0)
    h = wide / 2
    line = [(x0, -h), (x1 - 0.001, -h), (x1 - 1.2 * h, h), (x0, h)]
    blades = [extrude(line, 0.004, steel).move(z=z)]
    rim = [(x0, -h * 1.03), (x1 - 0.001, -h * 1.03), (x1 - 0.003, -0.62 * h), (x0, -0.62 * h)]
    blades.append(extrude(rim, 0.0045, edge).move(z=z - 0.0002))
    score, x = plain("5c636a", 0.0), x0 + wide * 0.6
    while x < x1 - wide:
        line = [(x, -0.6 * h), (x + 0.001, -0.6 * h), (x - 0.7 * h, h), (x - 0.7 * h - 0.001, h)]
        blades.append(extrude(line, 0.0046, score).move(z=z - 0.0003))
        x += wide * 0.65
    return blades


def heavy_cutter(colour: str, accent: str) -> Model:
    """A broad cutter with a screw wheel and its long blade far out."""
    body, dark = plain(colour, 0.04), plain(accent, 0.04)
    line = [(-0.09, -0.014), (-0.085, 0.016), (-0.03, 0.018), (0.05, 0.017), (0.062, 0.011)]
    line += [(0.062, -0.012), (0.03, -0.018), (0.0, -0.014), (-0.03, -0.018), (-0.06, -0.014)]
    hold = [extrude(line, 0.02, body, bevel_width=0.004)]
    hold.append(
        extrude([(-0.075, -0.009), (-0.075, 0.01), (0.01, 0.01), (0.01, -0.009)], 0.0225, dark)
    )
    wheel = lathe(
        [(0, 0), (0.0125, 0), (0.0125, 0.006), (0.01, 0.008), (0, 0.008)],
        14,
        mat=dark,
        rib=lambda k, i: 1 - 0.1 * (i % 2),
    )
    hold.append(wheel.move(0.036, 0, 0.0195))
    return sharp(
        "box cutter, blade out",
        hold,
        scored_blade(0.05, 0.152, 0.022, 0.008),
        [hold[0].v],
        0.16,
        0.242,
    )


def mini_cutter(colour: str, accent: str) -> Model:
    """A slim pocket cutter with a clip."""
    body, dark = plain(colour, 0.04), plain(accent, 0.04)
    shell = extrude(rounded_rectangle(0.088, 0.016, 0.005, 3), 0.011, body, bevel_width=0.002)
    hold = [shell.move(-0.002)]
    hold.append(box(0.05, 0.0045, 0.0008, (0.008, 0, 0.0108), plain("#26282c", 0.02)))
    hold.append(box(0.013, 0.01, 0.006, (0.02, 0, 0.0105), dark, 0.0015))
    hold.append(box(0.04, 0.006, 0.002, (-0.03, 0, 0.0125), metal(STEEL, STEEL_DARK)))
    hold.append(box(0.005, 0.006, 0.004, (-0.049, 0, 0.0105), metal(STEEL, STEEL_DARK)))
    blades = scored_blade(0.036, 0.078, 0.0105, 0.0035)
    return sharp("small box cutter", hold, blades, [shell.v], 0.03, 0.13)


def trapezoid(x0: float, reach: float, z: float) -> list[Mesh]:
    """The point of a trapezoid blade, edge towards -y."""
    steel, edge = metal("d4d8dc", "9aa0a6"), plain("f8fafc", 0.0)
    line = [(x0, -0.0095), (x0 + reach, -0.0095), (x0 + 0.55 * reach, 0.0095), (x0, 0.0095)]
    rim = [(x0, -0.0098), (x0 + reach, -0.0098), (x0 + 0.93 * reach, -0.005), (x0, -0.005)]
    return [extrude(line, 0.004, steel).move(z=z), extrude(rim, 0.0045, edge).move(z=z - 0.0002)]


def utility_knife(colour: str, accent: str) -> Model:
    """A thick metal knife with a trapezoid blade."""
    body, dark = metal(colour, "5c6268"), plain(accent, 0.04)
    line = [(-0.085, -0.017), (-0.08, 0.006), (-0.05, 0.016), (0.0, 0.02), (0.045, 0.017)]
    line += [(0.066, 0.011), (0.066, -0.012), (0.03, -0.014), (-0.02, -0.01), (-0.06, -0.024)]
    hold = [extrude(line, 0.024, body, bevel_width=0.005)]
    hold.append(box(0.03, 0.013, 0.006, (0.012, 0.008, 0.0225), dark, 0.002))
    for k in range(3):
        hold.append(box(0.003, 0.013, 0.0015, (0.004 + 0.008 * k, 0.008, 0.028), dark))
    screw = lathe([(0, 0), (0.005, 0), (0.004, 0.0014), (0, 0.0016)], 10)
    screw.mats = [metal("9a9fa5", "5c6268")]
    hold.append(screw.move(-0.03, 0.001, 0.0238))
    panel = [(-0.078, -0.013), (-0.074, 0.003), (-0.05, 0.0105), (-0.02, 0.0125), (-0.02, -0.006)]
    hold.append(extrude([*panel, (-0.056, -0.018)], 0.0255, dark))
    return sharp("utility knife", hold, trapezoid(0.06, 0.036, 0.01), [hold[0].v], 0.22, 0.181)


def folding_cutter(colour: str, accent: str) -> Model:
    """A folding utility knife, half open."""
    body, dark = plain(colour, 0.04), metal(accent, "4c5258")
    line = [
        (-0.105, -0.01),
        (-0.1, 0.01),
        (-0.04, 0.012),
        (0.006, 0.012),
        (0.01, 0),
        (0.004, -0.012),
    ]
    line += [(-0.04, -0.012), (-0.075, -0.008)]
    hold = [extrude(line, 0.018, body, bevel_width=0.004)]
    for k in range(3):
        hold.append(
            box(0.012, 0.012, 0.0015, (-0.03 - 0.02 * k, 0, 0.0178), plain("#26282c", 0.03))
        )
    clamp = extrude(
        [(-0.008, -0.012), (0.05, -0.0115), (0.05, 0.0115), (-0.008, 0.012)], 0.013, dark
    )
    clamp.move(z=0.0025)
    pin = lathe([(0, 0), (0.006, 0), (0.005, 0.002), (0, 0.0022)], 10)
    pin.mats = [metal(STEEL, STEEL_DARK)]
    blades = trapezoid(0.044, 0.04, 0.007)
    for mesh in (clamp, *blades):
        mesh.turn(rz=1.15)
    hold += [clamp, pin.move(0, 0, 0.0178)]
    points = np.concatenate([m.v for m in (*hold, *blades)])
    length = float(np.ptp(points[:, 0]))
    return sharp("folding box cutter", hold, blades, [hold[0].v, clamp.v], 0.15, length)


def cutter_form(shape: str, colour: str, accent: str) -> Model:
    """A snap-off cutter (classic, heavy, mini), a utility knife, a folding one."""
    if shape == "classic":
        return box_cutter(colour, accent, 0.1755629178791283, 0.045)
    made = {"heavy": heavy_cutter, "mini": mini_cutter, "utility": utility_knife}
    return {**made, "folding": folding_cutter}[shape](colour, accent)


# ---- screwdrivers
def driver(
    grip: tuple[float, float], rod: tuple[float, float], tip: str, colour: str, second: str
) -> tuple[list[Mesh], list[Mesh]]:
    """A screwdriver along x: lengths and radii of grip and rod; the rod starts at x = 0."""
    (length, r), (reach, thin) = grip, rod
    n = 12
    paint, band = plain(colour, 0.04), plain(second, 0.03)
    steel, dark = metal(STEEL, STEEL_DARK), metal("9a9fa5", "5c6268")
    profile = [(0, -length), (0.7 * r, -length), (0.95 * r, -0.94 * length), (r, -0.7 * length)]
    profile += [(0.9 * r, -0.3 * length), (0.68 * r, -0.2 * length), (0.87 * r, -0.08 * length)]
    handle = lathe(
        [*profile, (0.58 * r, 0), (0, 0)],
        n,
        mat=paint,
        rib=lambda k, i: 1 - 0.12 * (i % 2) if 2 <= k <= 4 else 1,
    )
    butt = lathe(
        [(0, -length - 0.0015), (0.68 * r, -length - 0.0012), (0.72 * r, -length + 0.002)], n
    )
    butt.mats = [band]
    hold = [m.turn(ry=math.pi / 2).move(z=r) for m in (handle, butt)]
    shaft = lathe([(0, 0), (thin, 0), (thin, reach * 0.94), (0, reach * 0.94)], 8, mat=steel)
    blades = [shaft.turn(ry=math.pi / 2).move(z=r)]
    x = 0.9 * reach
    if tip == "flat":
        rings = []
        for at, wide, tall in ((0, 1, 1), (3.4, 1.5, 0.6), (6.5, 1.4, 0.22)):
            c = ((wide, tall), (-wide, tall), (-wide, -tall), (wide, -tall))
            rings.append([(x + at * thin, y * thin, r + z * thin) for y, z in c])
        blades.append(loft(rings, mat=dark))
    else:
        point = [(1.15 * thin, x), (1.15 * thin, x + 3 * thin), (0.35 * thin, x + 6 * thin)]
        star = lathe(
            [(0, x), *point, (0, x + 6 * thin)],
            8,
            mat=dark,
            rib=lambda k, i: 0.55 if i % 2 else 1,
        )
        blades.append(star.turn(ry=math.pi / 2).move(z=r))
    return hold, blades


SIZES = {  # grip length and radius, rod length and radius
    "stubby": ((0.058, 0.0185), (0.04, 0.0042)),
    "long": ((0.115, 0.017), (0.175, 0.0042)),
    "precision": ((0.075, 0.0065), (0.062, 0.0018)),
}


def screwdriver_set(colour: str, second: str) -> Model:
    """Three screwdrivers of a set, side by side."""
    hold, blades, pieces = [], [], []
    table = (((0.1, 0.0155), (0.11, 0.0036), "flat"), ((0.085, 0.0135), (0.085, 0.003), "cross"))
    for k, (grip, rod, tip) in enumerate((*table, ((0.07, 0.0115), (0.065, 0.0024), "flat"))):
        h, b = driver(grip, rod, tip, colour, second)
        for mesh in (*h, *b):
            mesh.turn(rz=0.12 * (1 - k)).move(-0.006 * k, 0.045 * (1 - k), 0)
        hold += h
        blades += b
        pieces.append(h[0].v)
    return sharp("screwdrivers", hold, blades, pieces, 0.25, 0.212)


def t_handle(colour: str, second: str) -> Model:
    """A screwdriver with a handle across its shaft."""
    paint, steel, dark = plain(colour, 0.04), metal(STEEL, STEEL_DARK), metal("9a9fa5", "5c6268")
    bar = [(0, -0.05), (0.011, -0.049), (0.0145, -0.04), (0.0115, -0.012), (0.0155, 0)]
    bar += [(r, -y) for r, y in bar[-2::-1]]
    z = 0.0155
    hold = [lathe(bar, 10, mat=paint).turn(rx=math.pi / 2).move(-0.004, 0, z)]
    collar = lathe([(0, 0), (0.0085, 0), (0.0065, 0.02), (0, 0.02)], 10, mat=plain(second, 0.03))
    hold.append(collar.turn(ry=math.pi / 2).move(0.006, 0, z))
    rod = lathe([(0, 0), (0.0042, 0), (0.0042, 0.125), (0, 0.125)], 8, mat=steel)
    blades = [rod.turn(ry=math.pi / 2).move(0.02, 0, z)]
    star = lathe([(0, 0), (0.0048, 0), (0.0048, 0.014), (0.0014, 0.027), (0, 0.027)], 8, mat=dark)
    blades.append(star.turn(ry=math.pi / 2).move(0.138, 0, z))
    return sharp("T-handled screwdriver", hold, blades, [hold[0].v], 0.14, 0.1845)


def screwdriver_form(shape: str, tip: str, colour: str, second: str) -> Model:
    """A screwdriver: usual, stubby, long, precision, with a T-handle, or a set of three."""
    if shape == "usual":
        return screwdriver(tip, colour, second, 0.21788727114343504 if tip == "flat" else 0.22336)
    if shape == "set":
        return screwdriver_set(colour, second)
    if shape == "T":
        return t_handle(colour, second)
    hold, blades = driver(*SIZES[shape], tip, colour, second)
    points = np.concatenate([m.v for m in (*hold, *blades)])
    mass = {"stubby": 0.08, "long": 0.18, "precision": 0.03}[shape]
    title = f"{shape} screwdriver, {tip} tip"
    return sharp(title, hold, blades, [hold[0].v], mass, float(np.ptp(points[:, 0])))


KEYS = ("shape", "colour", "accent")
MODELS = {
    "razor": maker(
        razor_form,
        KEYS,
        [
            ("wet", "#1f6fd0", "#5fe0c0"),
            ("cut-throat", "#5a1a1a", ""),
            ("safety", "#c9cdd1", ""),
            ("disposable", "#f08a1c", ""),
            ("cut-throat", "#e6d8b8", ""),
            ("wet", "#f2c21e", "#26282c"),
            ("wet", "#e83a8a", "#f4f4f2"),
        ],
    ),
    "box_cutter": maker(
        cutter_form,
        KEYS,
        [
            ("classic", "#f2c21e", "#1c1c20"),
            ("classic", "#d8202c", "#f2f2ee"),
            ("heavy", "#e8641c", "#26282c"),
            ("utility", "#a4a9ae", "#d8202c"),
            ("folding", "#c8202c", "#7a8086"),
            ("mini", "#2f8fd8", "#f2c21e"),
            ("utility", "#8a8f52", "#26282c"),
        ],
    ),
    "screwdriver": maker(
        screwdriver_form,
        ("shape", "tip", "colour", "second"),
        [
            ("usual", "flat", "#e8b81e", "#c8202c"),
            ("usual", "cross", "#c8202c", "#1c1c20"),
            ("stubby", "flat", "#2f7fd8", "#f2c21e"),
            ("long", "cross", "#e8641c", "#26282c"),
            ("set", "", "#c8202c", "#f2c21e"),
            ("T", "cross", "#2f8f4a", "#26282c"),
            ("precision", "flat", "#1f9ad0", "#f4f4f2"),
            ("long", "cross", "#2f8f4a", "#f2c21e"),
        ],
    ),
}
