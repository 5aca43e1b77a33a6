"""Racks beside the sink, in which washed plates and cups drain. Long along y, their front to +X."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.shapes import box, lathe, loft, rounded_rectangle, tube

from .casework import metal_or
from .joinery import finish
from .soft_forms import bars

#: Plates stand so far apart.
SLOT = 0.036


def plate(radius: float, at: tuple[float, float, float], colour: str, rim: str) -> Mesh:
    """A plate on its edge at a point, leaning a little to -Y."""
    glaze = Material()
    far = glaze.distance((0, 0, 0), (1, 1, 0))
    glaze.colour(glaze.mix(glaze.remap(far, 0.86 * radius, 0.88 * radius), colour, rim))
    r = radius
    profile = [(0, 0), (0.6 * r, 0), (r, 0.014), (0.98 * r, 0.02), (0, 0.007)]
    mesh = lathe(profile, 13, mat=glaze).keep_pattern()
    return mesh.turn(rx=-math.pi / 2 + 0.12).move(at[0], at[1], at[2] + r)


def cup(at: tuple[float, float, float], colour: str, radius: float = 0.04) -> list[Mesh]:
    """A mug upside down on a point, its handle to the front."""
    r, h, mat = radius, 2.3 * radius, plain(colour, 0.03)
    foot = [(0, 0), (r, 0), (0.94 * r, h - 0.006), (0.8 * r, h), (0, h)]
    ear = [(0, 0.9 * r, 0.25 * h), (0, 1.55 * r, 0.32 * h), (0, 1.5 * r, 0.7 * h)]
    ear.append((0, 0.88 * r, 0.8 * h))
    handle = tube(np.array(ear), 0.005, 4, mat=mat).turn(rz=-1.1)
    return [m.move(*at) for m in (lathe(foot, 10, mat=mat), handle)]


def glass(at: tuple[float, float, float]) -> list[Mesh]:
    """A drinking glass upside down."""
    profile = [(0, 0), (0.036, 0), (0.028, 0.1), (0, 0.102)]
    return [lathe(profile, 9, mat=plain("#c4d6da", 0.05)).move(*at)]


def _cups(kinds: tuple[str, ...], x: float, y: float, z: float, step: float) -> list[Mesh]:
    """A row of cups by colour, or "glass", towards +Y."""
    meshes = []
    for k, kind in enumerate(kinds):
        at = (x, y + k * step, z)
        meshes += glass(at) if kind == "glass" else cup(at, kind)
    return meshes


def _pieces(bodies: list[np.ndarray]) -> list[np.ndarray]:
    """A box round each group of corners."""
    found = []
    for points in bodies:
        low, high = points.min(0), points.max(0)
        found.append(box_piece((low + high) / 2, high - low))
    return found


def _model(title: str, frame: list[Mesh], held: list[list[Mesh]], mass: float) -> Model:
    groups = [frame, *(group for group in held if group)]
    pieces = _pieces([np.concatenate([m.v for m in group]) for group in groups])
    meshes = [mesh for group in groups for mesh in group]
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass, texture_size=128)


def wire(
    metal: str,
    tray: str | None,
    plates: tuple[str, str],
    cups: tuple[str, ...],
    width: float = 0.42,
    depth: float = 0.3,
) -> Model:
    """A basket of wire on a tray: plates in the slots, cups before them."""
    rod = metal_or(metal)
    hx, hy, z0, z1 = depth / 2, width / 2, 0.03, 0.115
    frame = [box(depth, width, 0.014, (0, 0, 0), plain(tray, 0.03), 0.004)] if tray else []
    x1, y1 = hx - 0.015, hy - 0.015
    ring = rounded_rectangle(2 * x1, 2 * y1, 0.012, 2)
    frame.append(tube(np.c_[ring, np.full(len(ring), z1)], 0.0042, 5, closed=True, mat=rod))
    lines = [[(x, -y1, z0), (x, y1, z0)] for x in np.linspace(-x1, x1, 3)]
    lines += [[(-x1, y, z1), (-x1, y, z0), (x1, y, z0), (x1, y, z1)] for y in (-y1, 0.0, y1)]
    lines += [[(x, y, 0.0), (x, y, z1)] for x in (-x1, x1) for y in (-0.8 * y1, 0.8 * y1)]
    back = -hx + 0.125
    slots = [-y1 + 0.04 + SLOT * k for k in range(5)]
    lines += [[(back - 0.055, y, z0), (back, y, z0 + 0.085), (back + 0.055, y, z0)] for y in slots]
    frame += bars(lines, 0.0034, rod, 4)
    stack = [plate(0.115, (back, y - SLOT / 2, z0), *plates) for y in slots[1:4]]
    rows = _cups(cups, hx - 0.085, 0.02, z0, 0.1)
    return _model("dish rack of wire with plates and cups", frame, [stack, rows], 2.6)


def crossed(
    wood: str, plates: tuple[str, str], count: int, width: float = 0.4, mugs: tuple[str, ...] = ()
) -> Model:
    """Two frames of wood that cross, plates between their rods, cups hung on the upper ends."""
    timber, along = finish(wood, 2), finish(wood, 1)
    half, tall = width / 2, 0.25
    frame = []
    for y in (-half + 0.011, half - 0.011):
        for s in (-1, 1):
            long = math.hypot(0.27, tall)
            arm = box(0.022, 0.018, long, (0, 0, -long / 2), timber)
            tip = math.atan2(0.27, tall)
            frame.append(arm.turn(ry=s * tip).move(0, y + s * 0.004, tall / 2 + 0.004))
    for s in (-1, 1):
        for share in (0.12, 0.34, 0.72, 0.95):
            x, z = s * 0.135 * (2 * share - 1), tall * share + 0.004
            frame.append(tube([(x, -half, z), (x, half, z)], 0.006, 5, mat=along))
    low = tall / 2 + 0.012
    stack = [
        plate(0.105, (0.0, -half + 0.06 + SLOT * k, low), *plates).turn(rz=0.0)
        for k in range(count)
    ]
    rows = _cups(mugs, 0.0, half - 0.14, low + 0.04, 0.09)
    return _model("wooden dish rack with plates", frame, [stack, rows], 1.7)


def tub(
    colour: str,
    plates: tuple[str, str],
    cups: tuple[str, ...],
    width: float = 0.38,
    depth: float = 0.28,
) -> Model:
    """A bin of plastic with slots for plates at one side."""
    shell = plain(colour, 0.03)
    rings = []
    for inset, z in ((0.02, 0.0), (0.0, 0.1), (0.008, 0.1), (0.028, 0.012)):
        outline = rounded_rectangle(depth - 2 * inset, width - 2 * inset, 0.035, 4)
        rings.append(np.c_[outline, np.full(len(outline), z)])
    frame = [loft(rings, shell)]
    start, floor = -width / 2 + 0.05, 0.012
    for k in range(5):
        rib = box(0.16, 0.006, 0.05, (-0.02, start + SLOT * k, floor), plain(shade(colour, 0.85)))
        frame.append(rib)
    stack = [plate(0.11, (-0.02, start + SLOT * (k + 0.4), floor), *plates) for k in range(4)]
    rows = _cups(cups, 0.03, width / 2 - 0.13, floor, 0.085)
    rows += _cups(cups[:1], -0.065, width / 2 - 0.09, floor, 0.085)
    return _model("plastic dish drainer with plates and cups", frame, [stack, rows], 2.4)


def tiers(metal: str, plates: tuple[str, str], cups: tuple[str, ...]) -> Model:
    """Two tiers between bent ends: cups below, plates above."""
    rod, width, depth, tall = metal_or(metal), 0.4, 0.26, 0.3
    hx, hy = depth / 2, width / 2
    lines = []
    for y in (-hy, hy):
        bend = [(-hx, y, 0.0), (-hx, y, tall), (hx - 0.04, y, tall - 0.06), (hx, y, 0.0)]
        lines += pairwise(bend)
    frame = bars(lines, 0.006, rod, 5)
    lines = []
    for z, x0, x1 in ((0.03, -hx, hx), (0.15, -hx, hx - 0.03)):
        lines += [[(x, -hy, z), (x, hy, z)] for x in np.linspace(x0, x1, 4)]
        lines += [[(x0, y, z), (x1, y, z)] for y in (-hy, hy)]
    slots = [-hy + 0.05 + SLOT * k for k in range(5)]
    lines += [[(-0.09, y, 0.15), (-0.03, y, 0.22), (0.03, y, 0.15)] for y in slots]
    frame += bars(lines, 0.0034, rod, 4)
    stack = [plate(0.1, (-0.03, y - SLOT / 2, 0.153), *plates) for y in slots[1:4]]
    rows = _cups(cups, 0.03, -0.1, 0.033, 0.1)
    return _model("steel dish rack with two tiers", frame, [stack, rows], 2.8)


FORMS = {"wire": wire, "crossed": crossed, "tub": tub, "tiers": tiers}


def dish_rack(form: str, **more) -> Model:
    """A dish rack, by a name in ``FORMS``."""
    return FORMS[form](**more)


def dish_rack_random(rng: np.random.Generator) -> dict:
    return {}


WHITE, BLUE = ("#f4f3ee", "#f4f3ee"), ("#f2f1ec", "#4a6a92")
GREEN, CLAY = ("#9db3a0", "#86a08c"), ("#e6dccb", "#b5684a")

MODELS = {
    "dish_rack": Maker(
        dish_rack,
        dish_rack_random,
        8,
        [
            {"form": "wire", "metal": "iron", "tray": "#f0efea", "plates": WHITE,
             "cups": ("#4a6a92", "#d8b25a")},
            {"form": "wire", "metal": "steel", "tray": "#c9ced1", "plates": BLUE,
             "cups": ("#f0ece0", "glass"), "width": 0.4, "depth": 0.27},
            {"form": "wire", "metal": "#eeece6", "tray": None, "plates": CLAY,
             "cups": ("glass", "#b5684a"), "width": 0.38, "depth": 0.32},
            {"form": "crossed", "wood": "birch", "plates": BLUE, "count": 5},
            {"form": "crossed", "wood": "teak", "plates": GREEN, "count": 3, "width": 0.36,
             "mugs": ("#e6dccb",)},
            {"form": "tub", "colour": "#e9e8e2", "plates": GREEN, "cups": ("#3f5a56", "#f0ece0")},
            {"form": "tub", "colour": "#5f8a8f", "plates": WHITE, "cups": ("#c8553d", "glass"),
             "width": 0.42, "depth": 0.3},
            {"form": "tiers", "metal": "steel", "plates": WHITE,
             "cups": ("glass", "#8a9aa8", "#f0ece0")},
        ],
    ),
}  # fmt: skip
