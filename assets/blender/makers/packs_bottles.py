"""Plastic bottles: water, lemonade and cola."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.sampling import pick, seed_of
from toolkit.shapes import lathe, tube

from makers import drinks
from makers.bottle_shapes import cap
from makers.pack_parts import by_style, vessel


def wrap_print(word: str, sub: str, band: str, ink: str, motif=None, w: int = 300, h: int = 256):
    """A wrap-round label, three times the same."""
    image, d = labels.canvas(3 * w, h, band)
    for k in range(3):
        x = k * w
        low = h * (0.5 if motif else 0.68)
        labels.text(
            d, word, (x + 14, h * 0.08, x + w - 14, low), "oblique", ink, 3, shade_hex(band)
        )
        labels.text(d, sub, (x + 36, low + 4, x + w - 36, low + h * 0.15), "bold", ink)
        if motif:
            motif(d, x + w / 2, h * 0.83, h * 0.16)
    return image


def shade_hex(colour: str) -> str:
    return "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, 0.45))


def petaloid(body: Mesh, radius: float) -> Mesh:
    """Five feet at the bottom."""

    def foot(x: float, y: float, z: float):
        q = math.hypot(x, y)
        if z > 0.012 or q < 0.3 * radius:
            return x, y, z
        return x, y, z + 0.012 * (0.5 - 0.5 * math.cos(5 * math.atan2(y, x)))

    return body.warp(foot)


BOTTLES = {  # shape: (profile as shares of height and radius, the label's segments)
    "still": (  # half a litre, waisted, ribs above and below
        [
            (0, 0.8),
            (0.03, 1),
            (0.12, 1),
            (0.15, 0.92),
            (0.18, 1),
            (0.34, 1),
            (0.34, 1.02),
            (0.6, 1.02),
            (0.6, 1),
            (0.7, 0.96),
            (0.8, 0.76),
            (0.88, 0.46),
            (0.93, 0.42),
        ],
        [6],
    ),
    "tall": (
        [
            (0, 0.8),
            (0.02, 1),
            (0.1, 1),
            (0.13, 0.93),
            (0.16, 1),
            (0.22, 1),
            (0.25, 0.93),
            (0.28, 1),
            (0.42, 1),
            (0.45, 0.86),
            (0.48, 1.0),
            (0.5, 1.02),
            (0.68, 1.02),
            (0.69, 0.98),
            (0.8, 0.85),
            (0.88, 0.44),
            (0.94, 0.34),
        ],
        [11],
    ),
    "contour": (
        [
            (0, 0.78),
            (0.03, 0.96),
            (0.2, 1.0),
            (0.34, 0.84),
            (0.42, 0.83),
            (0.5, 0.98),
            (0.66, 0.98),
            (0.7, 0.9),
            (0.8, 0.62),
            (0.9, 0.4),
            (0.94, 0.38),
        ],
        [5],
    ),
    "family": (
        [
            (0, 0.8),
            (0.02, 0.98),
            (0.08, 1.0),
            (0.36, 1.0),
            (0.36, 1.015),
            (0.64, 1.015),
            (0.65, 0.98),
            (0.76, 0.86),
            (0.87, 0.48),
            (0.92, 0.3),
            (0.95, 0.28),
        ],
        [4],
    ),
    "litre": (
        [
            (0, 0.85),
            (0.02, 1),
            (0.2, 1.0),
            (0.2, 1.01),
            (0.46, 1.01),
            (0.47, 0.98),
            (0.56, 0.9),
            (0.7, 0.66),
            (0.86, 0.42),
            (0.94, 0.36),
        ],
        [3],
    ),
}


def drink_bottle(
    shape: str,
    height: float,
    radius: float,
    word: str,
    sub: str,
    band: str,
    ink: str,
    cap_colour: str,
    drink: str,
    title: str,
    motif: str = "",
    feet: bool = False,
    mass: float = 0.55,
    glass: str = "",
) -> Model:
    """A round bottle with a band round it."""
    profile, worn = BOTTLES[shape]
    h, r = height, radius
    sections = [(z * h, k * r, k * r, 2.0) for z, k in profile]
    which = [1 if k in worn else 0 for k in range(len(profile) - 1)]
    if glass:
        look = drinks.shiny(glass, h, 0.8, 0.7)
    else:
        look = drinks.shiny(drink, h, 0.7, 0.75, "#e6f3f8", 0.82 * h)
    art = wrap_print(word, sub, band, ink, getattr(groceries, motif) if motif else None)
    body = vessel(sections, [look, label(art, occlusion=0.6)], which, 18)
    if feet:
        petaloid(body, r)
    neck = profile[-1][1] * r
    low = profile[-1][0] * h - 0.002
    lid = cap(neck * 1.16, low, h - low, plain(cap_colour, 0.02), 14)
    ring = lathe(
        [
            (neck, low - 0.006),
            (neck * 1.3, low - 0.006),
            (neck * 1.3, low - 0.003),
            (neck, low - 0.003),
        ],
        12,
        mat=plain(cap_colour, 0.02),
    )
    shoulder = 0.7 * h
    pieces = [
        cylinder_piece(r, 0, shoulder),
        cylinder_piece(r * 0.95, shoulder, h, 10, neck * 1.16),
    ]
    return Model(
        title=title,
        parts={"body": Part([body.weigh(1.2), lid, ring], collision=pieces)},
        mass=mass,
        friction=0.4,
    )


def canister(height: float, radius: float, word: str, band: str, cap_colour: str) -> Model:
    """Five litres of water, with a carrying handle over its cap."""
    h, r = height, radius
    profile = [(0, 0.86), (0.02, 1), (0.1, 1), (0.13, 0.95), (0.16, 1), (0.22, 1), (0.25, 0.95)]
    profile += [
        (0.28, 1),
        (0.3, 1.01),
        (0.58, 1.01),
        (0.6, 0.98),
        (0.68, 0.92),
        (0.78, 0.6),
        (0.84, 0.3),
    ]
    profile += [(0.88, 0.27)]
    sections = [(z * h, k * r, k * r, 2.6 if z < 0.7 else 2.0) for z, k in profile]
    which = [1 if k == 8 else 0 for k in range(len(profile) - 1)]
    look = drinks.shiny("#a8d0e4", h, 0.8, 0.75, "#e6f3f8", 0.72 * h)
    art = wrap_print("WATER", "NATURAL SPRING", band, "#ffffff", groceries.mountains)
    body = vessel(sections, [look, label(art, occlusion=0.6)], which, 20)
    lid = cap(0.3 * r, 0.86 * h, 0.07 * h, plain(cap_colour, 0.02), 16)
    path = [
        (0, y * r, z * h)
        for y, z in (
            (-0.36, 0.82),
            (-0.62, 0.87),
            (-0.5, 0.97),
            (0, 0.985),
            (0.5, 0.97),
            (0.62, 0.87),
            (0.36, 0.82),
        )
    ]
    grip = tube(path, 0.0065, 6, mat=plain(cap_colour, 0.02), flatten=1.6)
    pieces = [
        cylinder_piece(r, 0, 0.66 * h),
        cylinder_piece(r * 0.95, 0.66 * h, 0.84 * h, 10, 0.3 * r),
    ]
    pieces.append(cylinder_piece(0.3 * r, 0.84 * h, 0.985 * h, 8))
    return Model(
        title="large water bottle with a handle",
        parts={"body": Part([body.weigh(1.2), lid, grip], collision=pieces)},
        mass=4.2,
        friction=0.4,
    )


def sports_bottle(height: float, radius: float, colour: str, accent: str) -> Model:
    """A refillable bottle with a pull-up spout and a grip waist."""
    h, r = height, radius
    profile = [
        (0, 0.9),
        (0.02, 1),
        (0.4, 1),
        (0.5, 0.82),
        (0.58, 0.82),
        (0.66, 1),
        (0.8, 1),
        (0.84, 0.96),
    ]
    sections = [(z * h, k * r, k * r, 2.0) for z, k in profile]
    art = wrap_print("WATER", "SPORT", colour, "#ffffff", groceries.cola)
    body = vessel(sections, [plain(colour, 0.04), label(art)], [0, 1, 0, 0, 0, 0, 0], 20)
    top = [(0, 0.83), (1.03, 0.83), (1.03, 0.88), (0.6, 0.91), (0.32, 0.92), (0.32, 0.95)]
    top += [(0.4, 0.955), (0.36, 1.0), (0, 1.0)]
    lid = lathe([(k * r, z * h) for k, z in top], 18, mat=plain(accent, 0.03))
    pieces = [cylinder_piece(r, 0, 0.86 * h), cylinder_piece(r, 0.86 * h, h, 10, 0.4 * r)]
    return Model(
        title="sports water bottle",
        parts={"body": Part([body.weigh(1.2), lid], collision=pieces)},
        mass=0.6,
        friction=0.5,
    )


def water_bottle_random(rng: np.random.Generator) -> dict:
    return drinks.water_bottle_random(rng)


def soda_random(rng: np.random.Generator) -> dict:
    return {"word": pick(rng, ["COLA", "LEMON"]), "seed": seed_of(rng)}


FULL_COLA = {
    "word": "COLA",
    "sub": "SODA",
    "band": "#c8141e",
    "ink": "#ffffff",
    "cap_colour": "#c8141e",
    "drink": "#2c1008",
    "title": "bottle of cola",
}

FULL_ORANGE = {
    "word": "ORANGE",
    "sub": "SODA",
    "band": "#2c4fa8",
    "ink": "#ffd24a",
    "cap_colour": "#f07a10",
    "drink": "#f08a1c",
    "title": "bottle of orange soda",
    "motif": "orange",
}

FULL_LEMON = {
    "word": "LEMON",
    "sub": "SODA",
    "band": "#2f8a34",
    "ink": "#fff27a",
    "cap_colour": "#e8d21c",
    "drink": "#dfe8a0",
    "title": "bottle of lemon soda",
    "motif": "lemon",
}

WATER = {
    "word": "WATER",
    "sub": "SPRING",
    "ink": "#ffffff",
    "drink": "#bcdcea",
    "motif": "mountains",
    "title": "bottle of water",
}

MODELS = {
    "water_bottle": Maker(
        by_style(
            "water_bottle",
            {
                "plain": drinks.water_bottle,
                "drink": drink_bottle,
                "canister": canister,
                "sports": sports_bottle,
            },
        ),
        water_bottle_random,
        count=7,
        presets=[
            {"style": "plain"},
            {
                "style": "drink",
                "shape": "still",
                "radius": 0.0325,
                "height": 0.21,
                **WATER,
                "band": "#d8486a",
                "cap_colour": "#d8486a",
            },
            {
                "style": "drink",
                "shape": "tall",
                "radius": 0.045,
                "height": 0.33,
                **WATER,
                "band": "#1f6fc4",
                "cap_colour": "#1f6fc4",
                "mass": 1.55,
            },
            {
                "style": "canister",
                "radius": 0.075,
                "height": 0.33,
                "word": "WATER",
                "band": "#2a7fd0",
                "cap_colour": "#2a6fc4",
            },
            {
                "style": "sports",
                "radius": 0.036,
                "height": 0.23,
                "colour": "#2f8fd8",
                "accent": "#1c1c24",
            },
            {
                "style": "drink",
                "shape": "litre",
                "radius": 0.042,
                "height": 0.3,
                **WATER,
                "band": "#f4f4ee",
                "ink": "#1f5fa8",
                "cap_colour": "#c8ccd0",
                "glass": "#4f9a7a",
                "mass": 1.3,
            },
            {
                "style": "drink",
                "shape": "tall",
                "radius": 0.045,
                "height": 0.33,
                **WATER,
                "band": "#2f9a5a",
                "cap_colour": "#2f9a5a",
                "mass": 1.55,
                "sub": "SPARKLING",
            },
        ],
    ),
    "soda_bottle": Maker(
        drink_bottle,
        lambda rng: {},
        count=7,
        presets=[
            {"shape": "contour", "radius": 0.033, "height": 0.235, **FULL_COLA},
            {
                "shape": "family",
                "radius": 0.054,
                "height": 0.335,
                **FULL_COLA,
                "feet": True,
                "mass": 2.1,
            },
            {
                "shape": "family",
                "radius": 0.054,
                "height": 0.335,
                **FULL_ORANGE,
                "feet": True,
                "mass": 2.1,
            },
            {"shape": "litre", "radius": 0.042, "height": 0.28, **FULL_LEMON, "mass": 1.05},
            {"shape": "contour", "radius": 0.033, "height": 0.235, **FULL_ORANGE},
            {"shape": "still", "radius": 0.036, "height": 0.2, **FULL_COLA, "mass": 0.45},
            {"shape": "litre", "radius": 0.042, "height": 0.28, **FULL_COLA, "mass": 1.05},
        ],
    ),
}
