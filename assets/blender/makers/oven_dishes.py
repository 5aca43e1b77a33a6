"""Baking dishes and colanders."""

from __future__ import annotations

import numpy as np
from toolkit import labels
from toolkit.materials import Material, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, Support, box_piece, rectangle, round_polygon
from toolkit.sampling import noise_offset
from toolkit.shapes import box, lathe, tube

from makers.cookware import long_handle, loops
from makers.ware import (
    DIRTY,
    hollow,
    r_at,
    remains,
    runs,
    smear,
    squared,
    wall_pieces,
    wall_profile,
)

# half length (y), depth over length, height, outline, squareness, columns, grips
DISHES = {
    "rectangular": (
        0.165,
        0.66,
        0.062,
        [(0.9, 0), (0.93, 0.1), (0.98, 0.9), (1, 1)],
        9,
        16,
        "lugs",
    ),
    "oval": (0.16, 0.66, 0.055, [(0.84, 0), (0.9, 0.12), (0.98, 0.9), (1, 1)], 2, 18, "lugs"),
    "tart": (0.138, 1.0, 0.034, [(0.9, 0), (0.92, 0.1), (0.99, 0.9), (1, 1)], 2, 22, ""),
    "square": (0.115, 1.0, 0.055, [(0.9, 0), (0.94, 0.1), (0.98, 0.9), (1, 1)], 8, 16, "lugs"),
    "loaf": (0.14, 0.46, 0.075, [(0.86, 0), (0.88, 0.06), (0.98, 0.95), (1.04, 1)], 9, 16, ""),
    "casserole": (0.12, 1.0, 0.085, [(0.88, 0), (0.95, 0.1), (1, 0.5), (1, 1)], 2, 16, "lid"),
}


def baking_dish(
    form="rectangular", colour="#c8402c", inside="#f4efe2", material="", dirt="burnt", look=0
) -> Model:
    """A dish of a form of DISHES; material: '' (glazed), steel or glass."""
    rng = np.random.default_rng(look)
    half, ratio, height, shares, power, n, grips = DISHES[form]
    outer = [(half * q, height * z) for q, z in shares]
    wall, floor = 0.0055, 0.007
    profile, kinds = wall_profile(outer, wall, floor, 0.0015)
    if material == "steel":
        glaze = inner = metal("a8adb2", "5e6368", (1, 8, 1), 40, noise_offset(rng))
    else:
        glaze, inner = plain(colour, 0.05, 30, noise_offset(rng)), plain(inside, 0.04, 30)
    mats = [glaze, inner, glaze, glaze if material else inner]
    rib = None
    if form == "tart":
        rib = lambda k, i: 1 - 0.028 * (i % 2) if k >= 4 else 1  # noqa: E731
    dish = lathe(profile, n, mats=mats, mat_of_segment=kinds, rib=rib)
    squared(dish, ratio, 1.0, power)
    meshes = [dish]
    reach = np.array([ratio, 1.0, 1.0])
    pieces = [p * reach for p in wall_pieces(outer, wall, floor)]
    if power > 4:  # wedges of a circle would cut the corners
        x, y = half * ratio, half
        pieces = [box_piece((0, 0, floor / 2), (1.8 * x, 1.8 * y, floor))]
        for s in (-1, 1):
            pieces.append(box_piece((s * (x * 0.96), 0, height / 2), (x * 0.08, 1.9 * y, height)))
            pieces.append(
                box_piece((0, s * (y - x * 0.05), height / 2), (1.9 * x, x * 0.1, height))
            )
    if grips:
        for s in (-1, 1):
            wide = half * ratio * 0.75 if grips == "lugs" else 0.05
            at = (0, s * (half + 0.011), height - 0.014)
            meshes.append(box(wide, 0.034, 0.012, at, glaze, 0.005))
            pieces.append(box_piece((0, at[1], at[2] + 0.006), (wide, 0.034, 0.012)))
    flat = outer[0][0]
    narrow = flat * ratio
    crust = plain("3a2010", 0.25, 80)
    mess = [m.scale(ratio, 1, 1) for m in remains(dirt, flat * 0.92, floor + 0.0006, look, 0.9, 9)]
    ring = [smear(0, 0, floor + 0.0003, flat * 0.9, rng, plain("8a5a26", 0.2, 60), 0.0006, 14)]
    drips = runs(outer, rng, 6, crust, -wall - 0.002, 0.0045) + runs(
        outer, rng, 2, crust, 0.0006, 0.004
    )
    for mesh in (*ring, *drips):
        mess.append(squared(mesh, ratio, 1.0, power))
    space = hollow(outer, wall, floor)
    inner_side = 1.25 * (narrow if power < 4 else 1.3 * narrow)
    space.size = (inner_side, inner_side / ratio, height - floor - 0.004)
    hold = rectangle(1.25 * narrow, 1.25 * flat)
    return Model(
        f"{form} baking dish" if form != "loaf" else "loaf tin",
        {
            "body": Part(meshes, collision=pieces),
            "remains": Part(mess, collision="none", open=True),
        },
        mass=1.1 if form != "loaf" else 0.45,
        variants={"default": ["body"], "dirty": ["body", "remains"]},
        states=DIRTY,
        texture_size=128,
        supports=[Support("bottom", floor, hold, container="inside")],
        containers=[space],
    )


def baking_dish_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


# radius, height, outline, grips, ring foot
COLANDERS = {
    "bowl": (
        0.125,
        0.105,
        [(0.45, 0), (0.62, 0.1), (0.86, 0.42), (0.97, 0.8), (1.04, 1)],
        "loops",
        True,
    ),
    "deep": (0.1, 0.13, [(0.74, 0), (0.8, 0.06), (0.92, 0.5), (1, 0.96), (1.06, 1)], "loops", True),
    "sieve": (
        0.09,
        0.062,
        [(0.26, 0), (0.55, 0.14), (0.86, 0.5), (1, 0.95), (1.04, 1)],
        "long",
        False,
    ),
    "basket": (0.12, 0.09, [(0.78, 0), (0.82, 0.08), (0.94, 0.9), (1.02, 1)], "square", False),
    "wide": (
        0.145,
        0.08,
        [(0.5, 0), (0.7, 0.12), (0.9, 0.5), (0.98, 0.9), (1.05, 1)],
        "loops",
        True,
    ),
}


def holes(rows: int, columns: int, colour: str, kind: str):
    """Rows of round holes, or a wire mesh, all round."""
    w, h = 1024, 320
    image, draw = labels.canvas(w, h)
    if kind == "mesh":
        for x in range(0, w, 22):
            draw.line([(x, 0), (x, h)], fill=colour, width=6)
        for y in range(0, h, 22):
            draw.line([(0, y), (w, y)], fill=colour, width=6)
        return image
    for j in range(rows):
        for i in range(columns):
            if kind == "stars" and (i + j) % 4 == 3:
                continue
            x, y = w * (i + 0.5 * (j % 2) + 0.25) / columns, h * (j + 0.9) / (rows + 1.2)
            r = h * 0.36 / (rows + 1)
            if kind == "slots":
                draw.rounded_rectangle(
                    (x - r * 0.6, y - r * 1.4, x + r * 0.6, y + r * 1.4), 4, fill=colour
                )
            else:
                draw.ellipse((x - r * 1.05, y - r, x + r * 1.05, y + r), fill=colour)
    return image


def colander(form="bowl", colour="steel", rim="", pattern="dots", look=0) -> Model:
    """A colander or sieve full of holes."""
    rng = np.random.default_rng(look)
    radius, height, shares, grips, foot = COLANDERS[form]
    lift = 0.014 if foot else 0.0
    outer = [(radius * q, height * z) for q, z in shares]
    wall, floor = 0.004, 0.005
    profile, kinds = wall_profile(outer, wall, floor, 0.001)
    ground = "c2c6ca" if colour == "steel" else colour
    dark = "#2a2c2e" if colour != "#26272b" else "#b8b2a6"
    picture = holes(6, 24 if pattern != "slots" else 30, dark, pattern)
    if form == "sieve":
        picture = holes(0, 0, "#6c7074", "mesh")
    pierced = Material()
    base = pierced.mottle(ground, 0.05, 30, noise_offset(rng))
    if colour == "steel":
        shine = pierced.remap(
            pierced.math("ABSOLUTE", pierced.math("ADD", pierced.normal(1), 0.4)), 0, 0.3, 0.6, 0
        )
        base = pierced.mix(shine, base, "f4f6f8")
    pierced.colour(pierced.image(picture, base))
    edge = plain(rim, 0.03) if rim else metal("c8ccd0", "84898e")
    body = lathe(
        profile,
        16,
        mats=[pierced, pierced, pierced, edge],
        mat_of_segment=kinds,
        label_z=(0.0, height * 0.97),
    )
    meshes: list[Mesh] = [body.keep_pattern().move(z=lift)]
    if form == "basket":
        squared(body, 1.0, 1.25, 6)
    if foot:
        q = outer[0][0] * 1.18
        band = [(q, 0), (q + 0.003, 0), (q + 0.003, 0.02), (q - 0.002, 0.02), (q - 0.002, 0)]
        meshes.append(lathe(band, 16, mat=edge))
    pieces = [p + np.array([0, 0, lift]) for p in wall_pieces(outer, wall, floor)]
    z = height * 0.94 + lift
    grip = edge
    if grips == "loops":
        more, bars = loops(radius * 1.03, z - 0.004, grip, 0.042, 0.036)
    elif grips == "long":
        more, bars = long_handle(radius, z - 0.006, 0.17, plain(rim or "#26272b", 0.05), 0.0)
        hook = [
            (-radius, 0.03, z - 0.004),
            (-radius - 0.022, 0.016, z - 0.004),
            (-radius - 0.022, -0.016, z - 0.004),
            (-radius, -0.03, z - 0.004),
        ]
        more.append(tube(hook, 0.0032, 5, mat=metal("c8ccd0", "84898e")))
    else:
        more = [
            box(0.09, 0.03, 0.009, (0, s * (radius * 1.25 + 0.008), z - 0.002), grip, 0.003)
            for s in (-1, 1)
        ]
        bars = [
            box_piece((0, s * (radius * 1.25 + 0.008), z), (0.09, 0.03, 0.009)) for s in (-1, 1)
        ]
        pieces = [p * [1, 1.25, 1] for p in pieces]
    space = hollow(outer, wall, floor)
    space.center = (0, 0, space.center[2] + lift)
    low = r_at(outer, floor + 0.01) - wall
    return Model(
        "sieve" if form == "sieve" else f"{form} colander",
        {"body": Part([*meshes, *more], collision=pieces + bars)},
        mass=0.4,
        texture_size=256,
        supports=[Support("bottom", floor + lift, round_polygon(low * 0.7), container="inside")],
        containers=[space],
    )


def colander_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


MODELS = {
    "baking_dish": Maker(
        baking_dish,
        baking_dish_random,
        7,
        [
            {"form": "rectangular", "colour": "#c8402c", "dirt": "soup"},
            {"form": "oval", "colour": "#2f5f8a", "dirt": "burnt"},
            {"form": "tart", "colour": "#f2ece0", "inside": "#f2ece0", "dirt": "cake"},
            {"form": "square", "colour": "#b9dcd6", "inside": "#d6ebe6", "dirt": "soup"},
            {"form": "loaf", "material": "steel", "dirt": "burnt"},
            {"form": "casserole", "colour": "#e8b83a", "dirt": "burnt"},
            {"form": "rectangular", "colour": "#f2efe6", "inside": "#e9e4d6", "dirt": "burnt"},
        ],
    ),
    "colander": Maker(
        colander,
        colander_random,
        7,
        [
            {"form": "bowl", "colour": "steel"},
            {"form": "deep", "colour": "#f2efe6", "rim": "#22406a"},
            {"form": "sieve", "colour": "steel", "rim": "#26272b"},
            {"form": "basket", "colour": "#5fae4a", "rim": "#4a9438", "pattern": "slots"},
            {"form": "wide", "colour": "#d8342c", "rim": "#d8342c"},
            {"form": "deep", "colour": "#4fa8b8", "rim": "#3a8c9c", "pattern": "stars"},
            {"form": "bowl", "colour": "#e8c33a", "rim": "#d0a820"},
        ],
    ),
}
