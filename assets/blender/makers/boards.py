"""Cutting boards and serving trays."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    prism_piece,
    rectangle,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset
from toolkit.shapes import TAU, box, extrude, lathe, rounded_rectangle, superellipse, tube

from makers.ware import squared, wall_profile

# length (y), depth (x), thickness, what it is like
BOARDS = {
    "slab": (0.38, 0.26, 0.024),
    "paddle": (0.42, 0.2, 0.018),
    "round": (0.32, 0.32, 0.022),
    "sheet": (0.34, 0.24, 0.01),
    "block": (0.3, 0.3, 0.05),
    "slim": (0.36, 0.14, 0.018),
    "round_handle": (0.4, 0.26, 0.018),
}


def outline_of(form: str) -> np.ndarray:
    """The board's outline in xy; handles to -Y."""
    length, depth, _ = BOARDS[form]
    if form == "round":
        a = np.arange(32) * TAU / 32
        return np.c_[depth / 2 * np.cos(a), depth / 2 * np.sin(a)]
    if form == "round_handle":
        r = depth / 2
        a = np.linspace(-math.pi / 2 + 0.2, 1.5 * math.pi - 0.2, 26)
        disc = np.c_[r * np.cos(a), r * np.sin(a) + length / 2 - r]
        y = -length / 2
        return np.r_[disc, [(-0.024, y + 0.02), (-0.014, y), (0.014, y), (0.024, y + 0.02)]]
    if form == "paddle":
        x, y, neck = depth / 2, length / 2, -length / 2 + 0.13
        right = [
            (0.02, -y + 0.012),
            (0.022, -y + 0.1),
            (0.05, neck + 0.01),
            (x - 0.01, neck + 0.02),
        ]
        right += [(x, neck + 0.04), (x, y - 0.02), (x - 0.02, y)]
        return np.array([(0.011, -y), *right, *[(-a, b) for a, b in right[::-1]], (-0.011, -y)])
    if form == "slim":
        x, y = depth / 2, length / 2
        half = [
            (0.0, -y),
            (0.03, -y + 0.006),
            (0.045, -y + 0.05),
            (x, -y + 0.1),
            (x, y - 0.03),
            (x - 0.03, y),
        ]
        return np.array([*half, *[(-a, b) for a, b in half[:0:-1]]])
    return rounded_rectangle(depth, length, 0.03 if form != "block" else 0.012, 4)


def board_print(form: str, groove: str, seed: int):
    """Juice groove, handle hole and knife cuts; u runs along x, v along y."""
    length, depth, _ = BOARDS[form]
    h = 512
    w = int(h * depth / length)
    image, draw = labels.canvas(w, h)
    rng = np.random.default_rng(seed)
    for _ in range(34):
        x, y = (
            rng.uniform(0.22, 0.78) * w,
            rng.uniform(0.25 if form != "paddle" else 0.12, 0.62) * h,
        )
        a, q = rng.normal(0.4, 0.25), rng.uniform(24, 80)
        light = rng.random() < 0.35
        fill = (255, 245, 225, 120) if light else (60, 36, 14, 120)
        draw.line([(x, y), (x + q * math.cos(a), y + q * math.sin(a))], fill=fill, width=3)
    m = 0.075 * w
    if groove and form in ("slab", "sheet", "block"):
        draw.rounded_rectangle((m, m, w - m, h - m), 22, outline=groove, width=9)
    if groove and form == "round":
        draw.ellipse((m, m, w - m, h - m), outline=groove, width=9)
    hole = (40, 30, 22, 255)
    if form in ("slab", "sheet"):  # a slot to hold it by, at the low end
        draw.rounded_rectangle((w * 0.3, h * 0.875, w * 0.7, h * 0.92), 11, fill=hole)
    elif form in ("paddle", "slim", "round_handle"):
        r = 12 if form != "slim" else 16
        y = h * (0.965 if form == "round_handle" else 0.955 if form == "paddle" else 0.9)
        draw.ellipse((w / 2 - r, y - r, w / 2 + r, y + r), fill=hole)
    elif form == "round":
        draw.ellipse((w / 2 - 20, h * 0.9 - 20, w / 2 + 20, h * 0.9 + 20), fill=hole)
    return image


def board_material(kind: str, colour: str, look: int) -> Material:
    """Wood, striped bamboo, or plastic."""
    rng = np.random.default_rng(look)
    offset = noise_offset(rng)
    if kind == "wood":
        m = wood(colour, "6b4020" if colour != "#8a5a34" else "4a2a14", 1, 9, offset)
        return m
    m = Material()
    base = m.mottle(colour, 0.05, 30, offset)
    if kind == "strips":  # glued strips along y
        strip = m.math("FRACT", m.math("MULTIPLY", m.axis(0), 26.0))
        base = m.mix(m.math("GREATER_THAN", strip, 0.5), base, "7a4a26")
        fine = m.remap(m.noise(30, 3, offset=offset, stretch=(7, 0.6, 1)), 0.35, 0.65, 0, 0.4)
        base = m.mix(fine, base, "a87848")
    return m.colour(base)


def cutting_board(form="slab", kind="wood", colour="#c08a54", groove="", food="", look=0) -> Model:
    """A cutting board lying flat; food: what was cut on it."""
    length, depth, thick = BOARDS[form]
    base = board_material(kind, colour, look)
    outline = outline_of(form)
    slab = extrude(outline, thick, base)
    top = Material()
    socket = board_material(kind, colour, look)
    picture = board_print(form, groove, 7)
    top = socket
    under = socket._emission.inputs["Color"].links[0].from_socket
    top.colour(top.image(picture, under))
    slab.mats.append(top)
    slab.mi[1] = 1
    meshes: list[Mesh] = [slab]
    if form == "block":
        for side in (-1, 1):  # grips
            grip = box(
                0.09,
                0.006,
                0.016,
                (0, side * (length / 2 - 0.001), thick * 0.45),
                plain("4a2c14", 0.05),
            )
            meshes.append(grip)
    if food == "bread":
        crust, crumb = plain("a8682c", 0.15, 90), plain("f0dcae", 0.1, 150)
        loaf = extrude(
            [(-0.05, 0), (0.05, 0), (0.055, 0.04), (0.03, 0.07), (-0.03, 0.07), (-0.055, 0.04)],
            0.1,
            crumb,
            crust,
            axis="y",
        )
        meshes.append(loaf.move(0, 0.06, thick))
        for k in range(2):
            piece = extrude(
                [(-0.05, 0), (0.05, 0), (0.055, 0.04), (0.03, 0.07), (-0.03, 0.07), (-0.055, 0.04)],
                0.014,
                crumb,
                crust,
                axis="y",
            )
            meshes.append(piece.turn(rx=1.45).move(0, -0.01 - 0.065 * k, thick + 0.009))
    solid = outline if len(outline) <= 16 else outline[::2]
    return Model(
        f"{form} cutting board, {kind}".replace("_", " "),
        {"body": Part(meshes, collision=[prism_piece(solid, 0, thick)])},
        mass=min(2.6, 700 * length * depth * thick + 0.1),
        supports=[]
        if food
        else [Support("top", thick, rectangle(depth * 0.6, length * 0.5, 0, 0.03))],
        texture_size=256,
    )


def cutting_board_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


# length (y), depth (x), height of the rim, form
TRAYS = {
    "butler": (0.46, 0.32, 0.05, "rect"),
    "round": (0.36, 0.36, 0.026, "round"),
    "oval": (0.48, 0.33, 0.03, "oval"),
    "canteen": (0.44, 0.33, 0.022, "rect"),
    "bed": (0.52, 0.32, 0.045, "rect"),
    "cocktail": (0.3, 0.3, 0.045, "round"),
}


def tray_print(style: str, ground: str, accent: str):
    """A pattern over the tray's floor."""
    image, draw = labels.canvas(320, 460, ground)
    if style == "lemons":
        for k in range(20):
            x, y = 40 + 80 * (k % 4) + 40 * (k // 4 % 2), 50 + 92 * (k // 4)
            draw.ellipse(
                (x - 30, y - 22, x + 30, y + 22), fill="#f4cf2e", outline="#c89a14", width=4
            )
            draw.ellipse((x + 22, y - 30, x + 50, y - 14), fill="#4f8f3a")
    elif style == "check":
        for i in range(0, 320, 64):
            for j in range(0, 460, 64):
                if (i + j) // 64 % 2:
                    draw.rectangle((i, j, i + 63, j + 63), fill=accent)
    elif style == "border":
        draw.rounded_rectangle((24, 24, 296, 436), 30, outline=accent, width=10)
    return image


def serving_tray(
    form="butler", material="wood", colour="#9a6a3a", accent="#ffffff", style="", look=0
) -> Model:
    """A tray, wider than deep."""
    rng = np.random.default_rng(look)
    length, depth, rim, shape = TRAYS[form]
    if material == "wood":
        body_mat = wood(colour, "5a3416", 1, 9, noise_offset(rng))
    elif material == "metal":
        body_mat = metal("c9cdd1", "8a9096", (6, 6, 1), 40, noise_offset(rng))
    else:
        body_mat = plain(colour, 0.05, 40, noise_offset(rng))
    half = length / 2
    flare = 0.9 if form in ("canteen", "oval") else 0.975
    outer = [(half * flare, 0), (half * (flare + 1) / 2, rim * 0.4), (half, rim)]
    wall, floor = 0.008, 0.009
    profile, kinds = wall_profile(outer, wall, floor, 0.001)
    dish = lathe(profile, 32 if shape == "round" else 24, mats=[body_mat] * 4, mat_of_segment=kinds)
    ratio = depth / length
    power = {"rect": 9, "oval": 2.6, "round": 2}[shape]
    squared(dish, ratio, 1.0, power)
    meshes: list[Mesh] = [dish]
    lift = 0.0
    x, y = depth / 2, half
    inner = (depth * flare - 0.05, length * flare - 0.05)
    if style:
        art = Material()
        art.colour(art.image(tray_print(style, colour, accent)))
        mat = box(
            inner[0] + 0.012, inner[1] + 0.012, 0.0012, (0, 0, floor), art, labels={"+z": art}
        )
        meshes.append(mat)
    pieces = [prism_piece(superellipse(x * flare, y * flare, max(power, 2), 16)[:, :2], 0, floor)]
    grip = body_mat if material != "metal" else metal("b5954a", "7a5c20")
    if shape == "round":
        pieces = [cylinder_piece(half * flare, 0, floor, 14)]
        pieces += ring_pieces(
            [(half * flare, 0), (half, rim)], [(half * flare - 0.01, 0), (half - 0.01, rim)], 12
        )
    else:
        for s in (-1, 1):
            pieces.append(box_piece((s * (x - 0.006), 0, rim / 2), (0.012, length * 0.9, rim)))
            pieces.append(box_piece((0, s * (y - 0.006), rim / 2), (depth * 0.9, 0.012, rim)))
    if form in ("butler", "bed"):  # raised ends with a dark slot to hold it by
        dark = plain("2c1c10", 0.04)
        for s in (-1, 1):
            end = rounded_rectangle(depth * 0.55, 0.07, 0.03, 4) + np.array([0, rim + 0.005])
            meshes.append(extrude(end, 0.012, body_mat, axis="y").move(0, s * (y - 0.007), 0))
            slot = rounded_rectangle(0.1, 0.022, 0.0105, 4) + np.array([0, rim + 0.014])
            meshes.append(extrude(slot, 0.0136, dark, axis="y").move(0, s * (y - 0.007), 0))
            pieces.append(box_piece((0, s * (y - 0.007), rim), (depth * 0.5, 0.012, 0.07)))
    elif form in ("oval", "cocktail"):
        for s in (-1, 1):
            turns = np.linspace(-1.3, 1.3, 8)
            arch = [
                (
                    0.06 * math.sin(a) / 0.96,
                    s * (y - 0.006 + 0.034 * (math.cos(a) - 0.27)),
                    rim + 0.004 + 0.014 * math.cos(a),
                )
                for a in turns
            ]
            meshes.append(tube(arch, 0.0062, 6, mat=grip, up=(0, 0, 1.0)))
            pieces.append(box_piece((0, s * (y + 0.012), rim + 0.01), (0.11, 0.028, 0.02)))
    if form == "bed":  # folding legs
        lift = 0.19
        for mesh in meshes:
            mesh.keep_pattern().move(z=lift)
        pieces = [p + np.array([0, 0, lift]) for p in pieces]
        for s in (-1, 1):
            for t in (-1, 1):
                leg = tube(
                    [
                        (t * (x - 0.04), s * (y - 0.05), lift + 0.004),
                        (t * (x - 0.03), s * (y - 0.03), 0.0),
                    ],
                    0.0095,
                    6,
                    mat=body_mat,
                )
                meshes.append(leg)
                pieces.append(
                    box_piece((t * (x - 0.035), s * (y - 0.04), lift / 2), (0.022, 0.03, lift))
                )
            bar = tube(
                [(-(x - 0.03), s * (y - 0.03), 0.03), (x - 0.03, s * (y - 0.03), 0.03)],
                0.0075,
                6,
                mat=body_mat,
            )
            meshes.append(bar)
    hold = (
        round_polygon(half * flare * 0.9)
        if shape == "round"
        else rectangle(inner[0] * 0.9, inner[1] * (0.9 if shape == "rect" else 0.72))
    )
    return Model(
        f"{form} tray, {material}",
        {"body": Part(meshes, collision=pieces)},
        mass=1.0 if form != "bed" else 2.0,
        supports=[Support("top", floor + lift + 0.0012, hold)],
        texture_size=256 if style or material == "wood" else 128,
    )


def serving_tray_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


MODELS = {
    "cutting_board": Maker(
        cutting_board,
        cutting_board_random,
        8,
        [
            {"form": "slab", "groove": "#6b4020"},
            {"form": "paddle", "colour": "#8a5a34"},
            {"form": "round", "colour": "#c99a5c", "groove": "#7a4a22", "food": "bread"},
            {"form": "sheet", "kind": "plastic", "colour": "#f2f2ee", "groove": "#b8bab8"},
            {"form": "block", "kind": "strips", "colour": "#c99a62", "groove": "#5a3216"},
            {"form": "slim", "colour": "#d0a468"},
            {"form": "sheet", "kind": "plastic", "colour": "#4fa05a", "groove": "#2f7a3c"},
            {"form": "round_handle", "kind": "strips", "colour": "#d8ac70"},
        ],
    ),
    "serving_tray": Maker(
        serving_tray,
        serving_tray_random,
        7,
        [
            {"form": "butler", "material": "wood", "colour": "#a8703c"},
            {"form": "round", "material": "metal"},
            {"form": "oval", "material": "metal"},
            {"form": "canteen", "material": "plastic", "colour": "#2f7f8f", "style": "lemons"},
            {"form": "bed", "material": "wood", "colour": "#d0a468"},
            {"form": "cocktail", "material": "plastic", "colour": "#26272b"},
            {"form": "canteen", "material": "plastic", "colour": "#f2efe6", "accent": "#c8302c"}
            | {"style": "check"},
        ],
    ),
}
