"""Corkscrews, vegetable peelers and pizza cutters, lying flat, with handles towards -X."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import label as printed
from toolkit.materials import metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Model
from toolkit.shapes import TAU, box, extrude, lathe, loft, rounded_rectangle, spline, tube

from makers.cleaner_forms import maker
from makers.projection import project_label
from makers.sharp_tools import STEEL, STEEL_DARK, pizza_cutter, sharp, turned


def worm(start, length: float, radius: float, wire: float, turns: float, mat, axis="x") -> Mesh:
    """A corkscrew's spiral from `start` along x (or y), its point at the far end."""
    points, n = [], int(turns * 7) + 1
    for t in np.linspace(0, 1, n):
        a, r = TAU * turns * t, radius * min(1.0, t * 8, (1 - t) * 9 + 0.1)
        across = (length * t, r * math.cos(a), r * math.sin(a))
        points.append(across if axis == "x" else (across[1], across[0], across[2]))
    radii = np.minimum(1.0, (1 - np.linspace(0, 1, n)) * 5 + 0.15) * wire
    return tube(np.add(points, start), radii, 4, mat=mat)


def cork(x0: float, z: float) -> Mesh:
    """A cork on the worm, lying along x."""
    mat = plain("#c89a62", 0.3, 500)
    body = lathe([(0, 0), (0.0112, 0), (0.012, 0.002), (0.012, 0.04), (0, 0.041)], 12, mat=mat)
    return body.turn(ry=math.pi / 2).move(x0, 0, z)


def t_corkscrew(colour: str, with_cork: bool) -> Model:
    """A wooden bar with a big spiral, perhaps with the cork still on it."""
    steel = metal(STEEL, STEEL_DARK)
    timber = wood(colour, "3a2010", 1, 30)
    z = 0.0125
    grip = [(0, -0.055), (0.0095, -0.053), (0.012, -0.034), (0.0095, 0), (0.012, 0.034)]
    bar = lathe([*grip, (0.0095, 0.053), (0, 0.055)], 10, mat=timber)
    hold = [bar.turn(rx=math.pi / 2).move(-0.004, 0, z)]
    blades = [
        tube([(0, 0, z), (0.025, 0, z)], 0.0042, 7, mat=steel),
        worm((0.022, 0, z), 0.085, 0.0082, 0.0027, 5, steel),
    ]
    pieces = [bar.v]
    if with_cork:
        hold.append(cork(0.07, z))
        pieces.append(hold[-1].v)
    return sharp("corkscrew", hold, blades, pieces, 0.08, 0.123)


def wing_corkscrew(colour: str, raised: bool) -> Model:
    """The corkscrew with two toothed wings, raised (spiral out) or down."""
    steel, paint = metal(STEEL, STEEL_DARK), plain(colour, 0.04)
    dark = metal("a4a9ae", "6a7075")
    z = 0.017
    bell = lathe(
        [(0.0, 0.034), (0.012, 0.034), (0.0165, 0.04), (0.0165, 0.06), (0.013, 0.061), (0, 0.061)],
        12,
        mats=[paint, plain("1c1c20", 0.0)],
        mat_of_segment=[0, 0, 0, 0, 1],
    )
    hold = [bell.turn(ry=math.pi / 2).move(z=z)]
    for side in (-1, 1):
        hold.append(box(0.046, 0.0055, 0.012, (0.018, side * 0.0125, z - 0.006), paint, 0.001))
    hold.append(box(0.02, 0.034, 0.016, (0.002, 0, z - 0.008), paint, 0.003))
    lean = 0.62 if raised else 2.72  # from the handle's direction
    for side in (-1, 1):
        gear = lathe(
            [(0, -0.0055), (0.0115, -0.0055), (0.0115, 0.0055), (0, 0.0055)],
            12,
            mat=dark,
            rib=lambda k, i: 0.84 if i % 2 else 1,
        )
        hold.append(gear.move(0.002, side * 0.019, z))
        outline = [
            (0.0, -0.006),
            (0.06, -0.0055),
            (0.082, -0.0095),
            (0.094, -0.004),
            (0.094, 0.004),
        ]
        outline += [(0.082, 0.0095), (0.06, 0.0055), (0.0, 0.006)]
        arm = extrude(outline, 0.009, paint, bevel_width=0.0015)
        arm.turn(rz=math.pi - side * lean).move(0.002, side * 0.021, z - 0.0045)
        hold.append(arm)
    back = -0.055 if raised else -0.085
    hold.append(tube([(back, 0, z), (0.0, 0, z)], 0.0048, 7, mat=steel))
    ring = [
        (back - 0.014 + 0.013 * math.cos(a), 0.019 * math.sin(a), z)
        for a in np.arange(10) * TAU / 10
    ]
    hold.append(tube(ring, 0.005, 5, closed=True, mat=steel))
    reach = 0.1 if raised else 0.055
    screw = worm((0.016, 0, z), reach, 0.0092, 0.003, 5 if raised else 4, steel)
    pieces = [np.concatenate([m.v for m in hold[:4]]), hold[5].v, hold[7].v, hold[-1].v]
    span = 0.2 if raised else 0.18
    return sharp("winged corkscrew", hold, [screw], pieces, 0.22, span)


def waiters_friend(colour: str) -> Model:
    """A sommelier's folding corkscrew, its spiral and lever swung out."""
    steel, paint = metal(STEEL, STEEL_DARK), plain(colour, 0.04)
    z = 0.0105
    line = [(-0.062, -0.006), (-0.05, -0.011), (0, -0.006), (0.05, -0.009), (0.06, -0.004)]
    line += [(0.06, 0.006), (0.05, 0.009), (0, 0.008), (-0.05, 0.006), (-0.062, 0.003)]
    grip = extrude(spline(line, 2, closed=True), 0.018, paint, bevel_width=0.003).move(z=z - 0.009)
    hold = [grip]
    for x in (-0.045, 0.002, 0.05):
        pin = lathe([(0, 0), (0.004, 0), (0.0034, 0.0015), (0, 0.0018)], 8, mat=steel)
        hold.append(pin.move(x, 0, z + 0.0088))
    lever = [(0.05, 0.004), (0.062, -0.002), (0.09, 0.02), (0.104, 0.05), (0.096, 0.058)]
    lever += [(0.09, 0.05), (0.078, 0.028), (0.058, 0.012)]
    boot = extrude(lever, 0.011, steel, bevel_width=0.001).move(z=z - 0.0055)
    screw = worm((0.002, 0.002, z), 0.072, 0.0075, 0.0026, 5, steel, "y")
    return sharp("waiter's corkscrew", hold, [boot, screw], [grip.v], 0.12, 0.166)


def corkscrew_form(shape: str, colour: str) -> Model:
    """A T-bar with or without its cork, wings up or down, or a waiter's friend."""
    if shape in ("T", "cork"):
        return t_corkscrew(colour, shape == "cork")
    if shape == "waiter":
        return waiters_friend(colour)
    return wing_corkscrew(colour, shape == "wings up")


def y_peeler(colour: str, curl: bool) -> Model:
    """A Y-shaped peeler with its slotted blade across the fork, perhaps with a curl of peel."""
    grip, steel, edge = plain(colour, 0.04), metal(STEEL, STEEL_DARK), plain("f2f4f6", 0)
    slot = plain("16181c", 0)
    line = [(-0.1, -0.006), (-0.094, -0.0125), (-0.06, -0.011), (-0.03, -0.0085), (-0.006, -0.012)]
    line += [(0.006, -0.02), (0.012, 0), (0.006, 0.02)]
    line += [(x, -y) for x, y in line[4::-1]]
    hold = [extrude(line, 0.013, grip, bevel_width=0.003)]
    for side in (-1, 1):
        arm = [(0.0, side * 0.014, 0.0065), (0.018, side * 0.03, 0.0065)]
        arm += [(0.04, side * 0.036, 0.007), (0.064, side * 0.036, 0.0075)]
        hold.append(tube(spline(arm, 2), 0.0055, 7, mat=grip))
    blades = [
        box(0.007, 0.07, 0.005, (0.049, 0, 0.006), steel),
        box(0.006, 0.062, 0.0045, (0.0555, 0, 0.0055), slot),
        box(0.007, 0.07, 0.005, (0.062, 0, 0.006), edge),
    ]
    pieces = [hold[0].v, np.concatenate([hold[1].v, hold[2].v])]
    if curl:
        peel = plain("#f08a1c", 0.12, 300)
        rings = []
        for t in np.linspace(0, 1, 16):
            a, r = 1.5 * TAU * t, 0.011 + 0.007 * t
            x, z = 0.058 - 0.012 * (1 - t) + r * math.sin(a), 0.021 + r * math.cos(a) * 0.95
            half = 0.016 + 0.004 * t
            u = np.array([math.sin(a), math.cos(a)]) * 0.0012
            corners = ((-half, -1), (half, -1), (half, 1), (-half, 1))
            rings.append([(x + s * u[0], y, z + s * u[1]) for y, s in corners])
        hold.append(loft(rings, mat=peel))
        strip = []
        for t in np.linspace(0, 1, 12):  # a longer peel on the floor in front
            x, y = 0.098 + 0.022 * math.sin(5 * t), -0.065 + 0.14 * t
            z = 0.001 + 0.014 * math.sin(TAU * 1.5 * t) ** 2
            corners = ((-0.013, 0), (0.013, 0), (0.013, 0.0022), (-0.013, 0.0022))
            strip.append([(x + a, y, z + b) for a, b in corners])
        hold.append(loft(strip, mat=peel))
        pieces.append(hold[-2].v)
        pieces.append(hold[-1].v)
    length = float(np.ptp(np.concatenate([m.v for m in hold])[:, 0])) if curl else 0.17
    return sharp("peeler", hold, blades, pieces, 0.06, length)


def straight_peeler(colour: str) -> Model:
    """A straight peeler: a long slotted swivel blade with a pointed tip."""
    grip, steel, edge = plain(colour, 0.04), metal(STEEL, STEEL_DARK), plain("f6f8fa", 0)
    slot = plain("16181c", 0)
    profile = [(0, -0.1), (0.011, -0.099), (0.0135, -0.08), (0.0105, -0.045), (0.0135, -0.012)]
    handle = turned([*profile, (0.007, 0), (0, 0)], grip, 10)
    z = 0.0105
    half = spline([(-0.002, 0.004), (0.012, 0.0125), (0.06, 0.0125), (0.082, 0.006), (0.096, 0)], 2)
    whole = [*half.tolist(), *[(x, -y) for x, y in half[::-1].tolist()[1:]]]
    blade = extrude(whole, 0.006, steel, bevel_width=0.0015).move(z=z)
    gap = extrude(rounded_rectangle(0.058, 0.0095, 0.004, 3), 0.0067, slot).move(0.042, 0, z)
    rims = [box(0.056, 0.0022, 0.007, (0.042, side * 0.0042, z + 0.0002), edge) for side in (-1, 1)]
    return sharp("peeler", [handle], [blade, gap, *rims], [handle.v], 0.07, 0.196)


def rex_peeler(colour: str) -> Model:
    """The all-metal peeler: a bent band for a handle, the blade across its mouth."""
    band, steel, edge = metal(colour, "6f757b"), metal(STEEL, STEEL_DARK), plain("f2f4f6", 0)
    slot = plain("16181c", 0)
    path = [(0.03, -0.03, 0), (0.012, -0.031, 0), (-0.012, -0.021, 0), (-0.05, -0.018, 0)]
    path += [(-0.068, -0.01, 0), (-0.072, 0, 0)]
    path += [(x, -y, z) for x, y, z in path[-2::-1]]
    line = spline(path, 2)
    rings = []
    for k, p in enumerate(line):
        d = line[min(k + 1, len(line) - 1)] - line[max(k - 1, 0)]
        n = np.array([-d[1], d[0], 0]) / np.linalg.norm(d) * 0.0026
        rings.append([p + n + [0, 0, h] if s else p - n + [0, 0, h] for s, h in CORNERS])
    hold = [loft(rings, mat=band)]
    blades = [
        box(0.006, 0.06, 0.005, (0.017, 0, 0.0045), steel),
        box(0.006, 0.05, 0.0045, (0.0228, 0, 0.0042), slot),
        box(0.006, 0.06, 0.005, (0.0288, 0, 0.0045), edge),
    ]
    return sharp("peeler", hold, blades, [hold[0].v], 0.05, 0.105)


CORNERS = ((0, 0.0), (1, 0.0), (1, 0.012), (0, 0.012))  # of the band's section: side, height


def peeler_form(shape: str, colour: str) -> Model:
    """A Y peeler (with a curl of carrot peel or without), a straight one, an all-metal one."""
    if shape == "straight":
        return straight_peeler(colour)
    return rex_peeler(colour) if shape == "rex" else y_peeler(colour, shape == "curl")


def big_wheel(colour: str) -> Model:
    """A pizza cutter with a very large wheel and a steel handle."""
    steel, edge = metal(STEEL, STEEL_DARK), plain("f2f4f6", 0)
    grip = plain(colour, 0.04)
    profile = [(0, -0.13), (0.011, -0.129), (0.0145, -0.11), (0.011, -0.06), (0.0145, -0.02)]
    handle = turned([*profile, (0.008, 0), (0, 0)], grip, 10)
    z = 0.0145
    fork = box(0.075, 0.02, 0.0045, (0.03, 0, z + 0.0015), metal("aab0b6", "6f757b"), 0.001)
    wheel = lathe(
        [(0, 0.0095), (0.042, 0.0095), (0.05, 0.011), (0.042, 0.0145), (0, 0.0145)],
        24,
        mats=[steel, edge],
        mat_of_segment=[0, 1, 1, 0],
    ).move(0.068)
    picture, draw = canvas(128, 128)
    draw.ellipse((10, 10, 118, 118), outline="#8f959b", width=3)
    text(draw, "PIZZA", (20, 82, 108, 108), "bold", "#c8202c")
    project_label(wheel, printed(picture, base="#c9cdd1"), "+z", (0, -0.068), (0.084, 0.084), 0.95)
    hub = lathe([(0, 0), (0.011, 0), (0.009, 0.006), (0, 0.007)], 10, mat=grip)
    hub.move(0.068, 0, z)
    return sharp("pizza cutter", [handle, fork, hub], [wheel], [handle.v], 0.2, 0.248)


def palm_wheel(colour: str) -> Model:
    """A pizza wheel held in the palm: a round plastic cap over half of the wheel."""
    grip, steel, edge = plain(colour, 0.04), metal(STEEL, STEEL_DARK), plain("f2f4f6", 0)
    t = np.linspace(math.pi * 0.42, math.pi * 1.58, 15)
    outline = [(0.056 * math.cos(a), 0.056 * math.sin(a)) for a in t]
    cap_mesh = extrude(outline, 0.028, grip, bevel_width=0.005)
    wheel = lathe(
        [(0, 0.0105), (0.041, 0.0105), (0.049, 0.013), (0.041, 0.0165), (0, 0.0165)],
        24,
        mats=[steel, edge],
        mat_of_segment=[0, 1, 1, 0],
    )
    hub = lathe([(0, 0.006), (0.012, 0.006), (0.012, 0.022), (0.009, 0.0235), (0, 0.0235)], 10)
    hub.mats = [grip]
    picture, draw = canvas(128, 128, colour)
    text(draw, "PIZZA", (8, 40, 120, 88), "bold", "#ffffff")
    project_label(cap_mesh, printed(picture), "+z", (0, 0.028), (0.07, 0.07), 0.9)
    return sharp("pizza wheel", [cap_mesh, hub], [wheel], [cap_mesh.v], 0.12, 0.105)


def rocker(colour: str) -> Model:
    """A long rocking pizza knife: an arc of steel with a grip along its back, lying flat."""
    steel, edge = metal(STEEL, STEEL_DARK, (1, 20, 1), 30), plain("f2f4f6", 0)
    timber = wood(colour, "3a2010", 1, 20)
    arc = np.linspace(-1, 1, 13)
    cut = [(0.125 - 0.085 * a * a, 0.17 * a) for a in arc]
    blade = extrude([*cut, (0.0, 0.165), (0.0, -0.165)], 0.005, steel).move(z=0.0075)
    rim_line = [*cut, *[(x - 0.007, y * 0.985) for x, y in cut[::-1]]]
    rim = extrude(rim_line, 0.0056, edge).move(z=0.0072)
    picture, draw = canvas(256, 64)
    text(draw, "PIZZA", (50, 6, 206, 58), "bold", "#7a2020")
    project_label(blade, printed(picture, base="#c4c8cc"), "+z", (0, -0.06), (0.22, 0.06), 0.95)
    bar = extrude(rounded_rectangle(0.028, 0.3, 0.01, 3), 0.02, timber, bevel_width=0.005)
    return sharp("rocking pizza cutter", [bar], [blade, rim], [bar.v], 0.3, 0.139)


def pizza_form(shape: str, colour: str) -> Model:
    """A pizza cutter: a wheel on a handle, a large one, one held in the palm, a rocking knife."""
    if shape == "wheel":
        return pizza_cutter(colour, 0.2032588608346198, "PIZZA")
    makers = {"large": big_wheel, "palm": palm_wheel, "rocker": rocker}
    return makers[shape](colour)


KEYS = ("shape", "colour")
MODELS = {
    "corkscrew": maker(
        corkscrew_form,
        KEYS,
        [
            ("T", "#a8703a"),
            ("wings up", "#b01828"),
            ("wings down", "#b4b9be"),
            ("waiter", "#1c1c20"),
            ("cork", "#6b4426"),
            ("wings up", "#b4b9be"),
            ("waiter", "#b01828"),
        ],
    ),
    "vegetable_peeler": maker(
        peeler_form,
        KEYS,
        [
            ("Y", "#d8202c"),
            ("straight", "#2f8f4a"),
            ("rex", "#c9cdd1"),
            ("curl", "#26282c"),
            ("straight", "#e8781c"),
            ("Y", "#2f9a48"),
        ],
    ),
    "pizza_cutter": maker(
        pizza_form,
        KEYS,
        [
            ("wheel", "#1c1c20"),
            ("wheel", "#c8202c"),
            ("large", "#a82028"),
            ("palm", "#d8202c"),
            ("rocker", "#a8703a"),
            ("large", "#26282c"),
        ],
    ),
}
