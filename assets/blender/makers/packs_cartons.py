"""Juice and milk in cartons of every form, and milk in jugs and bottles."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import box, loft, tube

from makers import food_packs, packages
from makers.bottle_shapes import cap
from makers.pack_parts import by_style, carton, carton_piece, print_on, vessel


def fruit_faces(w: int, h: int, word: str, colour: str, dark: str, brand: str, motif: str):
    words = f"{word}\nJUICE"
    front = groceries.face(w, h, colour, dark, words, brand, getattr(groceries, motif), "100%")
    side, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.16), fill=dark)
    labels.text(d, "JUICE", (w * 0.1, h * 0.03, w * 0.9, h * 0.14))
    d.rectangle((w * 0.12, h * 0.24, w * 0.88, h * 0.6), fill="#ffffff", outline=dark, width=4)
    labels.small_print(d, (w * 0.18, h * 0.28, w * 0.82, h * 0.57), 7, "#666666")
    d.rectangle((0, h * 0.89, w, h), fill=dark)
    return front, side


def straw_box(
    fruit: str, colour: str, dark: str, brand: str, motif: str, straw: str = "#f4f4f0"
) -> Model:
    """A small box with a bent straw stuck in."""
    depth, width, height = 0.042, 0.056, 0.105
    front, side = fruit_faces(200, 375, fruit, colour, dark, brand, motif)
    body = carton(depth, width, height, front, side, None, colour, bevel=0.0015)
    path = [(0, 0.012, height - 0.012), (0, 0.012, height + 0.035), (0, 0.006, height + 0.044)]
    path.append((0, -0.018, height + 0.052))
    pipe = tube(path, 0.003, 8, mat=plain(straw, 0.03), weight=0.5)
    flaps = [
        box(
            depth * 0.96,
            0.003,
            0.012,
            (0, s * (width / 2 + 0.0012), height - 0.013),
            plain(dark, 0),
        )
        for s in (-1, 1)
    ]
    return Model(
        title=f"small {fruit.lower()} juice box with a straw",
        parts={
            "body": Part(
                [body.weigh(1.3), pipe, *flaps], collision=[carton_piece(depth, width, height)]
            )
        },
        mass=0.22,
        friction=0.5,
    )


def slant_carton(
    fruit: str, colour: str, dark: str, brand: str, motif: str, cap_colour: str
) -> Model:
    """A tall litre whose top slants towards the front, with a large cap in the slope."""
    depth, width, height, front_z = 0.073, 0.073, 0.238, 0.185
    front, side = fruit_faces(256, int(256 * height / width), fruit, colour, dark, brand, motif)
    x, y = depth / 2, width / 2
    v = [(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)]
    v += [(-x, -y, height), (x, -y, front_z), (x, y, front_z), (-x, y, height)]
    f = [(3, 2, 1, 0), (4, 5, 6, 7), (1, 2, 6, 5), (3, 0, 4, 7), (0, 1, 5, 4), (2, 3, 7, 6)]
    k = front_z / height
    flat = [(0.02, 0.97)] * 4
    uv = [flat, flat, [(0, 0), (1, 0), (1, k), (0, k)], [(0, 0), (1, 0), (1, 1), (0, 1)]]
    uv += [[(0, 0), (1, 0), (1, k), (0, 1)], [(0, 0), (1, 0), (1, 1), (0, k)]]
    mats = [label(front), label(side)]
    body = cube_project(Mesh(v, f, [0, 0, 0, 0, 1, 1], mats, uv, weight=1.2, smooth=False))
    slope = math.atan2(height - front_z, depth)
    lid = cap(0.016, 0.0, 0.015, plain(cap_colour, 0.02), 16).turn(ry=slope)
    lid.move(0.008, 0, (height + front_z) / 2 - 0.008 * math.tan(slope) - 0.001)
    ridge = box(0.006, width, 0.012, (-x + 0.003, 0, height - 0.006), plain(dark, 0.02))
    low = box_piece((0, 0, front_z / 2), (depth, width, front_z))
    wedge = np.array([v[i] for i in (4, 5, 6, 7)] + [(-x, -y, front_z), (-x, y, front_z)])
    return Model(
        title=f"{fruit.lower()} juice, tall carton",
        parts={"body": Part([body, lid, ridge], collision=[low, wedge])},
        mass=1.06,
        friction=0.5,
    )


def juice_print(width, height, roof, fruit, colour, dark, brand, motif):
    """Four panels side by side (front, right, back, left), roof above wall."""
    w = 256
    h0, r = int(w * height / width), int(w * roof / width)
    front, side = fruit_faces(w, h0, fruit, colour, dark, brand, motif)
    image, d = labels.canvas(4 * w, h0 + r, dark)
    for k in range(4):
        image.paste(front if k % 2 == 0 else side, (k * w, r))
        if k % 2 == 0:
            labels.text(d, "JUICE", (k * w + 30, 0.42 * r, k * w + w - 30, 0.95 * r), fill=colour)
    return image


def milk_faces(w: int, h: int, colour: str, dark: str, brand: str, fat: str, motif: str):
    white = "#fbfaf4"
    front = groceries.face(w, h, white, colour, "MILK", brand, getattr(groceries, motif), fat)
    side, d = labels.canvas(w, h, white)
    d.rectangle((0, h * 0.17, w, h * 0.47), fill=colour)
    labels.text(d, "MILK", (w * 0.08, h * 0.2, w * 0.92, h * 0.44))
    d.rectangle((w * 0.12, h * 0.54, w * 0.88, h * 0.82), outline=dark, width=3)
    labels.small_print(d, (w * 0.18, h * 0.56, w * 0.82, h * 0.8), 6, "#777777")
    d.rectangle((0, h * 0.89, w, h), fill=colour)
    return front, side


def milk_brick(
    width: float,
    depth: float,
    height: float,
    colour: str,
    dark: str,
    brand: str,
    fat: str,
    cap_colour: str,
    motif: str = "grass_cow",
) -> Model:
    """A long-life brick with a screw cap on its flat top."""
    front, side = milk_faces(220, int(220 * height / width), colour, dark, brand, fat, motif)
    body = carton(depth, width, height, front, side, None, "#fbfaf4")
    ridge = box(
        0.01, width * 0.96, 0.004, (-depth * 0.15, 0, height - 0.0015), plain(colour, 0.02), 0.001
    )
    radius = min(0.014, depth * 0.22)
    lid = food_packs.screw_cap(radius, 0.014, cap_colour).move(
        depth * 0.18, width * 0.18, height - 0.001
    )
    return Model(
        title=f"milk, long-life carton, {fat}",
        parts={
            "body": Part(
                [body.weigh(1.2), ridge, lid], collision=[carton_piece(depth, width, height)]
            )
        },
        mass=1.05 if height > 0.15 else 0.55,
        friction=0.5,
    )


def milk_jug(colour: str, dark: str, brand: str, fat: str) -> Model:
    """A large plastic jug with its handle moulded in at the back corner."""
    h, a = 0.25, 0.052
    milky = Material(occlusion=0.9)
    milky.colour(milky.mottle("#f6f4ec", 0.02, 30))
    steps = [(0, 0.94, 5), (0.006, 1, 5), (0.58, 1, 5), (0.7, 0.9, 4), (0.82, 0.62, 3)]
    steps += [(0.88, 0.4, 2), (0.92, 0.3, 2), (0.94, 0.3, 2)]
    rings = []
    for z, k, power in steps:
        c = np.arange(20) * math.tau / 20 - math.pi / 2
        x = a * k * np.sign(np.cos(c)) * abs(np.cos(c)) ** (2 / power)
        y = a * k * np.sign(np.sin(c)) * abs(np.sin(c)) ** (2 / power)
        # what lies behind leaves room for the handle
        hollow = 0.032 * max(0, min(1, (z - 0.42) / 0.2)) * (z < 0.9)
        x = np.where(x < -0.3 * a, x + hollow * (-x / a), x)
        rings.append(np.c_[x, y, np.full(20, z * h)])
    body = loft(rings, mat=milky)
    art = groceries.face(256, 256, "#ffffff", colour, "MILK", brand, groceries.grass_cow, fat)
    print_on(body, art, 0.092, 0.13, 0.75, 0.012)
    for i, f in enumerate(body.f):
        if body.mi[i] and not 0.004 < body.v[list(f)][:, 2].mean() < 0.6 * h:
            body.mi[i] = 0
    path = [(-a * 0.95, 0, 0.4 * h), (-a * 1.0, 0, 0.5 * h), (-a * 0.98, 0, 0.68 * h)]
    path += [(-a * 0.75, 0, 0.8 * h), (-a * 0.3, 0, 0.86 * h)]
    handle = tube(path, 0.011, 8, mat=milky)
    lid = cap(0.021, 0.93 * h, 0.018, plain(colour, 0.02), 18)
    pieces = [
        box_piece((0, 0, 0.28 * h), (2 * a, 2 * a, 0.56 * h)),
        cylinder_piece(a * 0.95, 0.56 * h, 0.9 * h, 10, 0.02),
        cylinder_piece(0.02, 0.9 * h, h, 8),
    ]
    return Model(
        title=f"jug of milk, {fat}",
        parts={"body": Part([body.weigh(1.2), handle, lid], collision=pieces)},
        mass=1.9,
        friction=0.5,
    )


def milk_glass_bottle(colour: str, brand: str) -> Model:
    """The dairy's glass bottle with a foil lid."""
    h, r = 0.22, 0.042
    look = Material(occlusion=0.5)
    base = look.mix(look.remap(look.axis(2), 0.85 * h, 0.87 * h), "fbfaf2", "dfeaf0")
    line = look.math("ABSOLUTE", look.math("ADD", look.normal(1), 0.55))
    look.colour(look.mix(look.remap(line, 0.02, 0.08, 0.5, 0), base, "c8d8e4"))
    art = groceries.wrapped(3, 240, 256, "#fbfaf2", colour, "MILK", brand, groceries.grass_cow)
    steps = [(0, 0.92), (0.02, 1), (0.08, 1), (0.5, 1), (0.6, 0.96), (0.75, 0.66), (0.85, 0.56)]
    steps += [(0.93, 0.55), (0.935, 0.64), (0.98, 0.64)]
    which = [0, 0, 1] + [0] * (len(steps) - 4)
    body = vessel([(z * h, k * r, k * r, 2.0) for z, k in steps], [look, label(art)], which, 20)
    foil = cap(0.7 * r, 0.955 * h, 0.045 * h, plain(colour, 0.1, 120), 18, 0.98)
    pieces = [cylinder_piece(r, 0, 0.6 * h), cylinder_piece(r, 0.6 * h, h, 10, 0.6 * r)]
    return Model(
        title="glass bottle of milk",
        parts={"body": Part([body.weigh(1.2), foil], collision=pieces)},
        mass=1.1,
        friction=0.45,
    )


BLUE = {"colour": "#1f5fc4", "dark": "#123a80"}
RED = {"colour": "#c4262e", "dark": "#8c141c"}
GREEN = {"colour": "#2c8f4a", "dark": "#14582a"}
WHOLE = {"width": 0.07, "height": 0.17}

MODELS = {
    "juice_carton": Maker(
        by_style(
            "juice_carton",
            {
                "brick": food_packs.juice_carton,
                "straw": straw_box,
                "slant": slant_carton,
            },
        ),
        food_packs.juice_carton_random,
        count=7,
        presets=[
            {"style": "brick", "fruit": "ORANGE"},
            {
                "style": "brick",
                "fruit": "APPLE",
                "colour": "#b9d67a",
                "dark": "#3d7a2a",
                "cap": "#d63a34",
                "width": 0.094,
                "depth": 0.064,
                "height": 0.165,
            },
            {
                "style": "straw",
                "fruit": "APPLE",
                "colour": "#b9d67a",
                "dark": "#3d7a2a",
                "brand": "Frutta",
                "motif": "apple",
            },
            # None with a gable: so juice is sold that is kept cold.
            {
                "style": "brick",
                "fruit": "ORANGE",
                "colour": "#f0953a",
                "dark": "#a8341a",
                "cap": "#a8341a",
                "width": 0.076,
                "depth": 0.06,
                "height": 0.23,
            },
            {
                "style": "slant",
                "fruit": "GRAPE",
                "colour": "#d8c0e6",
                "dark": "#5a2a78",
                "brand": "Sunny Hof",
                "motif": "grapes",
                "cap_colour": "#ffffff",
            },
            {
                "style": "straw",
                "fruit": "ORANGE",
                "colour": "#fbc14a",
                "dark": "#d8560e",
                "brand": "Orchard",
                "motif": "orange",
            },
            {
                "style": "slant",
                "fruit": "ORANGE",
                "colour": "#fbd27a",
                "dark": "#e0660e",
                "brand": "Frutta",
                "motif": "orange",
                "cap_colour": "#2f8a3a",
            },
        ],
    ),
    "milk_carton": Maker(
        by_style(
            "milk_carton",
            {
                "gable": packages.milk_carton,
                "brick": milk_brick,
                "jug": milk_jug,
                "bottle": milk_glass_bottle,
            },
        ),
        packages.milk_carton_random,
        count=8,
        presets=[
            {"style": "gable", "motif": "cow", "word": "MILK", **WHOLE},
            {
                "style": "gable",
                **RED,
                "grass": "#c4262e",
                "word": "MILK",
                "motif": "cow",
                "cap": "",
                "width": 0.07,
                "height": 0.085,
                "roof": 0.035,
            },
            {
                "style": "gable",
                **GREEN,
                "grass": "#7fbf3f",
                "motif": "glass",
                "word": "MILK",
                **WHOLE,
                "cap": "#ffffff",
            },
            {
                "style": "brick",
                **BLUE,
                "width": 0.092,
                "depth": 0.06,
                "height": 0.168,
                "brand": "Alpina",
                "fat": "3.5% fat",
                "cap_colour": "#1f5fc4",
                "motif": "grass_cow",
            },
            {
                "style": "brick",
                **GREEN,
                "width": 0.072,
                "depth": 0.068,
                "height": 0.225,
                "brand": "Daisy",
                "fat": "1.5% fat",
                "cap_colour": "#2c8f4a",
                "motif": "grass_cow",
            },
            {"style": "jug", **BLUE, "brand": "Meadow", "fat": "WHOLE"},
            {"style": "bottle", "colour": "#1f7a4a", "brand": "Hofgut"},
            {"style": "jug", **RED, "brand": "Alpina", "fat": "3.5% fat"},
        ],
    ),
}
