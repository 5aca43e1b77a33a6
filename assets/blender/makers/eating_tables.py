"""Kitchen and dining tables other than the plain and the turned ones."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import (
    Container,
    Joint,
    Maker,
    Model,
    Support,
    cylinder_piece,
    prism_piece,
)
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import extrude, lathe, loft, superellipse, tube

from .dining import dining_table as turned_table
from .dining_forms import WHITE, Offset, crossed, glass, parsons
from .dining_forms import model_of as _model
from .dining_forms import named as _named
from .forms import by_form
from .joinery import Assembly, drawer_box, finish, front, open_closed, steel, surface
from .tables import kitchen_table as plain_table


def _oval_top(
    asm: Assembly, hx: float, hy: float, z: tuple, mat: Material, power: float = 2.0
) -> Support:
    z0, z1 = z
    steps = [(0.03, z0), (0.004, z0 + 0.4 * (z1 - z0)), (0, z1 - 0.005), (0.006, z1)]
    rings = [superellipse(hx - i, hy - i, power, 32, at) for i, at in steps]
    asm.add("body", loft(rings, mat, weight=1.3))
    asm.piece("body", prism_piece(superellipse(hx, hy, power, 16)[:, :2], z0, z1))
    outline = superellipse(hx - 0.015, hy - 0.015, power, 16)[:, :2]
    return Support("top", z1, [tuple(p) for p in outline])


def pedestal(
    diameter: float = 0.95,
    length: float | None = None,
    wood: str = "oak",
    frame: str = WHITE,
    what: str = "kitchen",
    height: float = 0.75,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A round or oval top on one flared foot, like a tulip."""
    asm, paint = Assembly(), finish(frame, 2, offset)
    z = height - 0.026
    long = length or diameter
    support = _oval_top(asm, diameter / 2, long / 2, (z, height), finish(wood, 1, offset))
    r = 0.3 * diameter
    foot = [(0, 0), (r, 0), (r, 0.008), (0.7 * r, 0.02), (0.3 * r, 0.06), (0.055, 0.18)]
    foot += [(0.042, 0.36), (0.05, 0.55), (0.09, z - 0.04), (0.17, z), (0, z)]
    mesh = lathe(foot, 24, mat=paint)
    stretch = 1.0 if length is None else 1.35
    asm.add("body", mesh.scale(1, stretch, 1))
    for piece in (cylinder_piece(r, 0, 0.03, 12), cylinder_piece(0.06, 0.03, z, 8)):
        asm.piece("body", piece * [1, stretch, 1])
    shape = "oval" if length else "round"
    title = f"{shape} {what} table, {_named(wood)} top, {_named(frame)} pedestal"
    return _model(asm, title, 24.0 if what == "kitchen" else 38.0, support)


def hairpin(
    length: float = 1.3, depth: float = 0.75, wood: str = "walnut", offset: Offset = (0, 0, 0)
) -> Model:
    """A slab on four legs of bent steel rod."""
    asm, iron = Assembly(), plain("#232527", 0.05, 20)
    hx, hy, z0, z1 = depth / 2, length / 2, 0.716, 0.75
    asm.board(
        "body", (-hx, -hy, z0), (hx, hy, z1), finish(wood, 1, offset), 0.006, segments=2, weight=1.3
    )
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (hx - 0.1), sy * (hy - 0.12)
            foot = (x + sx * 0.06, y + sy * 0.07)
            for d in (-0.055, 0.055):
                rod = [(x + d * sy, y - d * sx, z0), (*foot, 0.014), (*foot, 0.0)]
                asm.add("body", tube(rod, 0.0065, 5, mat=iron))
            asm.solid(
                "body",
                (min(x, foot[0]) - 0.03, min(y, foot[1]) - 0.03, 0),
                (max(x, foot[0]) + 0.03, max(y, foot[1]) + 0.03, z0),
            )
            asm.board(
                "body",
                (x - 0.07, y - 0.07, z0 - 0.006),
                (x + 0.07, y + 0.07, z0),
                iron,
                solid=False,
            )
    return _model(
        asm, f"{wood} kitchen table on hairpin legs", 22.0, surface("top", (-hx, -hy), (hx, hy), z1)
    )


def drop_leaf(
    wood: str = "pine", length: float = 0.95, depth: float = 0.66, offset: Offset = (0, 0, 0)
) -> Model:
    """A small table with its two leaves hanging at the ends, on turned legs."""
    asm, top, timber = Assembly(), finish(wood, 1, offset), finish(wood, 2, offset)
    hx, hy, z1 = depth / 2, length / 2, 0.75
    z0 = z1 - 0.024
    asm.board("body", (-hx, -hy + 0.024, z0), (hx, hy - 0.024, z1), top, 0.004, weight=1.3)
    corner = [
        (-hx, 0.0),
        (-hx, -0.28),
        (-hx + 0.14, -0.4),
        (hx - 0.14, -0.4),
        (hx, -0.28),
        (hx, 0.0),
    ]
    for s in (-1, 1):
        leaf = extrude(corner, 0.022, mat=finish(wood, 0, offset), axis="y", bevel_width=0.003)
        asm.add("body", leaf.move(0, s * (hy - 0.011), z1 - 0.002), solid=True)
    turned = [
        (0, 0),
        (0.017, 0),
        (0.024, 0.06),
        (0.016, 0.1),
        (0.02, 0.3),
        (0.031, 0.5),
        (0.02, 0.54),
    ]
    turned += [(0.032, 0.57), (0.032, z0), (0, z0)]
    for x in (-hx + 0.08, hx - 0.08):
        for y in (-hy + 0.1, hy - 0.1):
            asm.add("body", lathe(turned, 8, mat=timber).move(x, y, 0), solid=True)
    for x in (-hx + 0.08, hx - 0.08):
        asm.board("body", (x - 0.011, -hy + 0.1, z0 - 0.1), (x + 0.011, hy - 0.1, z0), timber)
    for y in (-hy + 0.1, hy - 0.1):
        asm.board("body", (-hx + 0.08, y - 0.011, z0 - 0.1), (hx - 0.08, y + 0.011, z0), timber)
    return _model(
        asm,
        f"{_named(wood)} drop-leaf kitchen table",
        20.0,
        surface("top", (-hx, -hy), (hx, hy), z1),
    )


def farmhouse(
    wood: str = "oak",
    frame: str = WHITE,
    length: float = 1.5,
    depth: float = 0.85,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A long table with fat turned legs and a drawer in its apron."""
    asm, top, paint = Assembly(), finish(wood, 1, offset), finish(frame, 2, offset)
    hx, hy, z1 = depth / 2, length / 2, 0.76
    z0 = z1 - 0.036
    asm.board("body", (-hx, -hy, z0), (hx, hy, z1), top, 0.006, segments=2, weight=1.3)
    turned = [
        (0, 0),
        (0.03, 0),
        (0.044, 0.06),
        (0.03, 0.1),
        (0.04, 0.24),
        (0.052, 0.42),
        (0.034, 0.47),
    ]
    turned += [(0.05, 0.5), (0.05, 0.53), (0, 0.53)]
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (hx - 0.075), sy * (hy - 0.075)
            asm.add("body", lathe(turned, 9, mat=paint).move(x, y, 0), solid=True)
            asm.board(
                "body", (x - 0.045, y - 0.045, 0.53), (x + 0.045, y + 0.045, z0), paint, 0.003
            )
    low, a, b = z0 - 0.13, hx - 0.075, hy - 0.075
    for s in (-1, 1):
        asm.board("body", (-a, s * b - 0.011, low), (a, s * b + 0.011, z0), paint)
    asm.board("body", (-a - 0.011, -b, low), (-a + 0.011, b, z0), paint)
    for y0, y1 in ((-b, -0.28), (0.28, b)):
        asm.board("body", (a - 0.011, y0, low), (a + 0.011, y1, z0), paint)
    asm.board("body", (a - 0.011, -0.28, low), (a + 0.011, 0.28, low + 0.012), paint)
    front(asm, "drawer", a - 0.004, (-0.277, 0.277), (low + 0.014, z0 - 0.003), paint, "slab")
    knob = [(0, 0), (0.007, 0), (0.007, 0.01), (0.016, 0.018), (0.012, 0.028), (0, 0.03)]
    for y in (-0.14, 0.14):
        mesh = lathe(knob, 10, mat=steel()).turn(ry=math.pi / 2)
        asm.add("drawer", mesh.move(a + 0.013, y, low + 0.07))
    drawer = (a - 0.42, -0.262, low + 0.018), (a - 0.004, 0.262, z0 - 0.02)
    drawer_box(asm, "drawer", *drawer, finish("birch", 0, offset))
    inner = surface(
        "drawer_floor",
        (drawer[0][0] + 0.012, -0.25),
        (drawer[1][0], 0.25),
        low + 0.026,
        0.085,
        "drawer",
        "drawer",
    )
    center = (a - 0.212, 0.0, low + 0.068)
    return _model(
        asm,
        f"farmhouse kitchen table with a drawer, {_named(wood)} top, {_named(frame)} legs",
        38.0,
        surface("top", (-hx, -hy), (hx, hy), z1),
        parts=asm.parts(drawer={"joint": "drawer"}),
        supports=[inner],
        joints={"drawer": Joint("prismatic", (a, 0, low + 0.07), (1, 0, 0), 0.0, 0.3)},
        states=open_closed("drawer", "drawer", 0.01, 0.1),
        containers=[Container("drawer", center, (0.39, 0.48, 0.085), "drawer", "drawer")],
    )


def column(wood: str = WHITE, offset: Offset = (0, 0, 0)) -> Model:
    """A café table: a nearly square top on an iron column with a cross foot."""
    asm, iron = Assembly(), plain("#26282a", 0.06, 20)
    hx, hy, z1 = 0.35, 0.46, 0.75
    z0 = z1 - 0.03
    asm.board(
        "body", (-hx, -hy, z0), (hx, hy, z1), finish(wood, 1, offset), 0.008, segments=2, weight=1.3
    )
    post = [(0, 0.02), (0.06, 0.03), (0.038, 0.08), (0.034, z0 - 0.03), (0.07, z0 - 0.012), (0, z0)]
    asm.add("body", lathe(post, 12, mat=iron))
    asm.piece("body", cylinder_piece(0.04, 0.02, z0, 8))
    for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        reach = 0.28 if dx else 0.34
        path = [(dx * 0.02, dy * 0.02, 0.07), (dx * reach * 0.6, dy * reach * 0.6, 0.045)]
        path.append((dx * reach, dy * reach, 0.016))
        asm.add("body", tube(path, [0.03, 0.024, 0.016], 6, mat=iron), solid=True)
    return _model(
        asm,
        f"café kitchen table, {_named(wood)} top on an iron column",
        18.0,
        surface("top", (-hx, -hy), (hx, hy), z1),
    )


KITCHEN = {
    "plain": plain_table,
    "pedestal": pedestal,
    "hairpin": hairpin,
    "drop_leaf": drop_leaf,
    "farmhouse": farmhouse,
    "column": column,
}
DINING = {
    "turned": turned_table,
    "pedestal": pedestal,
    "crossed": crossed,
    "glass": glass,
    "parsons": parsons,
}


def kitchen_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random kitchen table."""
    return {
        "form": pick(rng, sorted(KITCHEN)),
        "length": None,
        "wood": pick(rng, ["oak", "walnut", "pine"]),
        "offset": noise_offset(rng),
    }


def dining_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random dining table."""
    return {
        "form": "turned",
        "style": pick(rng, ["round", "oval", "trestle"]),
        "length": round(float(rng.uniform(1.4, 1.7)), 2),
        "depth": round(float(rng.uniform(0.88, 1.0)), 2),
        "wood": pick(rng, ["oak", "walnut", "pine"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "kitchen_table": Maker(
        by_form("kitchen_table", KITCHEN),
        kitchen_table_random,
        9,
        [
            {"form": "plain", "wood": "oak", "legs": None, "length": 1.4, "depth": 0.75},
            {
                "form": "plain",
                "wood": "pine",
                "legs": "#e8e6e0",
                "length": 1.2,
                "square": False,
                "depth": 0.74,
            },
            {"form": "pedestal", "wood": "oak", "frame": WHITE},
            {"form": "pedestal", "wood": WHITE, "frame": WHITE},
            {"form": "hairpin", "wood": "walnut", "length": 1.3},
            {"form": "drop_leaf", "wood": "pine", "length": 0.95},
            {"form": "farmhouse", "wood": "oak", "length": 1.5},
            {"form": "farmhouse", "wood": "walnut", "frame": "#7d8f86", "length": 1.5},
            {"form": "column", "wood": WHITE},
        ],
    ),
    "dining_table": Maker(
        by_form("dining_table", DINING),
        dining_table_random,
        8,
        [
            {"form": "turned", "style": "round", "depth": 1.1, "wood": "walnut"},
            {"style": "oval", "depth": 0.95, "length": 1.5, "wood": "oak", "frame": "#ebe9e3"},
            {"style": "trestle", "depth": 0.9, "length": 1.65, "wood": "pine"},
            {
                "form": "pedestal",
                "wood": WHITE,
                "diameter": 0.95,
                "length": 1.6,
                "what": "dining",
                "height": 0.74,
            },
            {"form": "crossed", "wood": "oak", "length": 1.7, "depth": 0.92},
            {"form": "glass", "length": 1.5, "depth": 0.9},
            {"form": "parsons", "wood": "walnut", "length": 1.6, "depth": 0.9},
            {"form": "parsons", "wood": WHITE, "length": 1.6, "depth": 0.9},
        ],
    ),
}
