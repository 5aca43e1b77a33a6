"""Mugs and cups with handles of several forms; broken, stained or with coffee in them."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material, plain
from toolkit.model import Maker, Model, Part, cylinder_piece, prism_piece
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import lathe, tube

from makers.ware import (
    FULL,
    WARE_STATES,
    hollow,
    r_at,
    runs,
    smear,
    surface_of,
    wall_pieces,
    wall_profile,
)

# radius, height, outline (shares of both), how far the handle stands out, its form
SHAPES = {
    "straight": (0.041, 0.095, [(0.9, 0), (0.96, 0.05), (1, 0.5), (1, 1)], 0.03, "d"),
    "barrel": (
        0.052,
        0.086,
        [(0.68, 0), (0.8, 0.08), (1, 0.42), (0.97, 0.66), (0.84, 1)],
        0.03,
        "d",
    ),
    "tall": (0.042, 0.14, [(0.66, 0), (0.72, 0.05), (0.84, 0.5), (1, 1)], 0.032, "low"),
    "espresso": (0.032, 0.055, [(0.6, 0), (0.72, 0.08), (0.95, 0.5), (1, 1)], 0.02, "ring"),
    "cappuccino": (
        0.053,
        0.064,
        [(0.44, 0), (0.5, 0.06), (0.8, 0.3), (0.96, 0.7), (1, 1)],
        0.026,
        "ring",
    ),
    "camp": (0.046, 0.078, [(0.97, 0), (1, 0.04), (1, 0.5), (1, 0.95), (1.05, 1)], 0.03, "square"),
    "conical": (0.054, 0.108, [(0.46, 0), (0.5, 0.05), (0.75, 0.5), (1, 1)], 0.036, "square"),
}
DRINKS = {
    "coffee": ("43240f", "9a6a3a"),
    "tea": ("a8561a", "c07a30"),
    "latte": ("c8a078", "f2e4cc"),
}


def mug_print(style: str, words: str, accent: str):
    """The decoration all round, transparent elsewhere (u = 0.25 and 0.75 are front and back)."""
    w, h = 768, 256
    image, draw = labels.canvas(w, h)
    if style == "stripes":
        for y0, y1 in ((0.12, 0.2), (0.25, 0.28), (0.72, 0.75), (0.8, 0.88)):
            draw.rectangle((0, h * y0, w, h * y1), fill=accent)
    elif style == "rim":
        draw.rectangle((0, 0, w, h * 0.13), fill=accent)
    elif style == "heart":
        for cx in (w * 0.25, w * 0.75):
            r, cy = h * 0.19, h * 0.43
            draw.ellipse((cx - 2 * r, cy - r, cx, cy + r), fill=accent)
            draw.ellipse((cx, cy - r, cx + 2 * r, cy + r), fill=accent)
            low = cy + 0.38 * r
            draw.polygon(
                [(cx - 1.93 * r, low), (cx + 1.93 * r, low), (cx, cy + 2.3 * r)], fill=accent
            )
    elif style == "text":
        for cx in (w * 0.25, w * 0.75):
            labels.text(
                draw, words, (cx - w * 0.135, h * 0.2, cx + w * 0.135, h * 0.8), fill=accent
            )
    elif style == "dots":
        for row in range(4):
            for i in range(12):
                x, y = w * (i + 0.5 * (row % 2) + 0.25) / 12, h * (0.18 + 0.21 * row)
                draw.ellipse((x - h * 0.06, y - h * 0.06, x + h * 0.06, y + h * 0.06), fill=accent)
    elif style == "flowers":
        for i in range(6):
            x, y = w * (i + 0.5) / 6, h * (0.42 + 0.2 * (i % 2))
            for k in range(6):
                a = k * math.pi / 3
                px, py, q = x + 26 * math.cos(a), y + 26 * math.sin(a), 19
                draw.ellipse((px - q, py - q, px + q, py + q), fill=accent)
            draw.ellipse((x - 15, y - 15, x + 15, y + 15), fill="#f2c230")
    return image


def handle_path(form: str, outer, radius: float, height: float, deep: float) -> np.ndarray:
    """The middle line of a handle to +Y."""
    z, tall = height * (0.42 if form == "low" else 0.52), height * 0.3
    ends = 1.45
    if form == "ring":
        z, tall = height * 0.62, height * 0.26
    if form == "low":
        tall = height * 0.22
    if form == "square":
        corners = [(-0.1, -1), (0.75, -1), (1, -0.75), (1, 0.75), (0.75, 1), (-0.1, 1)]
        path = [(0, deep * u, z + tall * w) for u, w in corners]
    else:
        power = 0.55 if form == "ring" else 0.8
        turns = np.linspace(-ends, ends, 9)
        path = [(0, deep * max(math.cos(t), 0) ** power, z + tall * math.sin(t)) for t in turns]
    path = np.array([(0, r_at(outer, q) * 0.9 + y, q) for _, y, q in path])
    far = r_at(outer, z) + deep
    path[:, 1] = np.minimum(path[:, 1], far)
    for end in (0, -1):
        path[end][1] = r_at(outer, path[end][2]) - 0.003
    return path


def mug(
    shape="straight",
    colour="#f4f1ea",
    inside="#f6f3ec",
    accent="#c92a36",
    style="heart",
    words="COFFEE",
    drink="coffee",
    saucer=False,
    look=0,
    seed=0,
) -> Model:
    """A mug, its handle to +Y so that the print faces the front; seed: how it breaks."""
    noise = np.random.default_rng(look)
    radius, height, shares, deep, form = SHAPES[shape]
    outer = [(radius * r, height * z) for r, z in shares]
    wall, floor = 0.0042, 0.008
    profile, kinds = wall_profile(outer, wall, floor)
    paint = Material()
    base = paint.mottle(colour, 0.04, 40, noise_offset(noise))
    paint.colour(paint.image(mug_print(style, words, accent), base))
    glaze, raw = plain(inside, 0.03, 40, noise_offset(noise)), plain("d9c7a8", 0.12, 300)
    edge = plain(accent, 0.03) if style == "rim" else glaze
    mats = [paint, glaze, plain("d9cdbb", 0.08, 200), edge]

    def shell(n: int):
        return lathe(
            profile,
            n,
            mats=list(mats),
            mat_of_segment=kinds,
            label_z=(0.01, height),
            start=math.pi / 2,
        )

    grip = plain(accent if style == "rim" else colour, 0.04, 40)
    path = handle_path(form, outer, radius, height, deep)
    thick = 0.0048 if radius < 0.04 else 0.0064
    handles = [
        tube(path[::step], thick, n, mat=grip, up=(1.0, 0, 0), flatten=1.2)
        for n, step in ((5 if saucer else 6, 1), (5, 1))
    ]
    lift = 0.008 if saucer else 0.0
    meshes, dish = [shell(12 if saucer else 18), handles[0]], []
    if saucer:
        wide = radius * (2.05 if shape == "espresso" else 1.36)
        rim = [(wide * 0.5, 0), (wide * 0.55, 0.003), (wide * 0.9, 0.013), (wide, 0.017)]
        sheet, of = wall_profile(rim, 0.004, 0.0055)
        dish = [
            lathe(sheet, n, mats=[glaze, glaze, mats[2], edge], mat_of_segment=of) for n in (12, 8)
        ]
        for mesh in meshes:
            mesh.keep_pattern().move(z=lift)
    # the foot with half the wall stands, its handle lies beside it
    turn = float(np.random.default_rng(seed).uniform(0.3, 1.0)) + math.pi
    seeds = [(-0.3 * radius * math.cos(turn), -0.3 * radius * math.sin(turn), height * 0.1)]
    for k, z in enumerate((0.9, 0.72, 0.92, 0.75)):
        a = turn + 2 * math.pi * k / 4
        seeds.append((1.1 * radius * math.cos(a), 1.1 * radius * math.sin(a), height * z))
    seeds.append((0, radius + 0.8 * deep, float(path[:, 2].mean())))
    weights = [(0.75 * radius) ** 2] + [0.0] * 5
    coarse = lathe(
        profile,
        8 if saucer else 10,
        mats=list(mats),
        mat_of_segment=kinds,
        label_z=(0.01, height),
        start=math.pi / 2,
    )
    shards = fracture([coarse, handles[1]], seeds, raw, weights, seed, 0.003, 0.07)
    fallen = scatter(shards, np.random.default_rng(seed))
    if saucer:
        aside = dish[1].keep_pattern().move(x=-2.1 * wide)
        shards.append(aside)
        fallen = [*fallen, aside.v.copy()]
    broken = Part(shards, collision=fallen)

    colours = DRINKS[drink]
    level = height * 0.86
    drinkable = surface_of(colours[0], r_at(outer, level) - wall, level, 18, colours[1])
    dry = plain("5a3418", 0.2, 120)
    stains = [surface_of("4a2810", r_at(outer, floor) - wall, floor + 0.002, 14, "7a4c26")]
    stains += runs(outer, noise, 2 if saucer else 4, dry, 0.0004) + runs(
        outer, noise, 2 if saucer else 3, dry, -wall - 0.0006
    )
    stains.append(smear(*[0.5 * radius] * 2, floor + 0.003, radius * 0.2, noise, dry))
    if saucer:
        stains.append(smear(radius * 1.1, -radius * 0.5, 0.011, radius * 0.28, noise, dry))
        for mesh in (drinkable, *stains):
            mesh.keep_pattern().move(z=lift)
        stains[-1].move(z=-lift)

    pieces = [p + np.array([0, 0, lift]) for p in wall_pieces(outer, wall, floor)]
    low, high = float(path[:, 2].min()) + lift, float(path[:, 2].max()) + lift
    y0, y1 = radius * 0.8, float(path[:, 1].max()) + thick
    strip = [(-thick, y0), (thick, y0), (thick, y1), (-thick, y1)]
    front = [(-thick, y1 - 0.011), (thick, y1 - 0.011), *strip[2:]]
    pieces += [
        prism_piece(strip, low - thick, low + thick),
        prism_piece(strip, high - thick, high + thick),
        prism_piece(front, low, high),
    ]
    if saucer:
        pieces.append(cylinder_piece(wide * 0.5, 0, 0.008, 12, wide))
    space = hollow(outer, wall, floor)
    space.center = (0, 0, space.center[2] + lift)
    kind = {"espresso": "espresso cup", "cappuccino": "cup"}.get(shape, f"{shape} mug")
    return Model(
        title=f"{kind}, {style} pattern" if style != "none" else f"plain {kind}",
        parts={
            "body": Part([*meshes, *dish[:1]], collision=pieces),
            "filling": Part([drinkable], collision="none"),
            "remains": Part(stains, collision="none"),
            "shards": broken,
        },
        variants={
            "default": ["body"],
            "full": ["body", "filling"],
            "dirty": ["body", "remains"],
            "broken": ["shards"],
        },
        states=[*WARE_STATES, *FULL],
        mass=0.32,
        texture_size=256 if style in ("heart", "text", "flowers") else 128,
        containers=[space],
        prune=False,  # all of the inside is seen from somewhere
    )


def mug_random(rng: np.random.Generator) -> dict:
    return {
        "shape": pick(rng, list(SHAPES)),
        "colour": pick(rng, ["#f4f1ea", "#2d5f8a", "#d9532c", "#e8c33a", "#8fb8a0"]),
        "accent": pick(rng, ["#c92a36", "#20487a", "#222222", "#2c8060"]),
        "style": pick(rng, ["stripes", "heart", "text", "dots", "none"]),
        "drink": pick(rng, list(DRINKS)),
        "look": seed_of(rng),
        "seed": 5,
    }


WHITE = "#f4f1ea"
MODELS = {
    "mug": Maker(
        mug,
        mug_random,
        count=9,
        presets=[
            {"shape": "straight", "style": "heart", "colour": WHITE, "accent": "#c92a36"},
            {"shape": "barrel", "style": "stripes", "colour": "#2d5f8a", "accent": "#ffffff"},
            {"shape": "straight", "style": "text", "colour": "#e8c33a", "accent": "#222222"},
            {"shape": "tall", "style": "text", "words": "LATTE", "colour": "#efe6d4"}
            | {"accent": "#5a3218", "drink": "latte"},
            {"shape": "espresso", "style": "rim", "colour": WHITE, "accent": "#9a2230"}
            | {"saucer": True, "drink": "coffee"},
            {"shape": "cappuccino", "style": "flowers", "colour": WHITE, "accent": "#d8486a"}
            | {"saucer": True, "drink": "tea"},
            {"shape": "camp", "style": "rim", "colour": "#3f7f86", "accent": "#16242c"},
            {"shape": "conical", "style": "dots", "colour": "#8fb8a0", "accent": "#ffffff"}
            | {"drink": "tea"},
            {"shape": "barrel", "style": "text", "words": "TEA", "colour": "#d9532c"}
            | {"accent": "#fff4e0", "drink": "tea"},
        ],
    ),
}
