"""Frying pans, woks and grill pans; dirty ones show fat and scraps."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    Support,
    cylinder_piece,
    rectangle,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, ellipsoid, lathe

from makers.cookware import long_handle, loops
from makers.ware import DIRTY, remains, smear, squared, wall_profile

# radius, height, outline in shares, length of the handle
PANS = {
    "frying": (0.13, 0.046, [(0.8, 0), (0.83, 0.1), (0.99, 0.94), (1.01, 1)], 0.19),
    "wok": (0.155, 0.085, [(0.36, 0), (0.52, 0.1), (0.8, 0.42), (0.98, 0.94), (1, 1)], 0.19),
    "grill": (0.128, 0.042, [(0.92, 0), (0.95, 0.1), (0.99, 0.94), (1.01, 1)], 0.17),
    "crepe": (0.13, 0.02, [(0.9, 0), (0.93, 0.2), (0.99, 0.9), (1.01, 1)], 0.18),
    "saute": (0.125, 0.07, [(0.97, 0), (1, 0.06), (1, 0.94), (1.02, 1)], 0.19),
    "paella": (0.17, 0.046, [(0.84, 0), (0.87, 0.1), (0.99, 0.94), (1.01, 1)], 0.0),
    "egg": (0.085, 0.034, [(0.84, 0), (0.87, 0.1), (0.99, 0.94), (1.01, 1)], 0.15),
}


def frying_pan(
    shape="frying", outside="#2a2b2e", handle="#1c1c1e", inside="", dirt="egg", look=0
) -> Model:
    """A pan of a form of PANS, its handle to the front; inside: '' (coated), steel, or a colour."""
    rng = np.random.default_rng(look)
    radius, height, shares, length = PANS[shape]
    outer = [(radius * q, height * z) for q, z in shares]
    wall, floor = 0.005, 0.0065
    coated = Material()
    ring = coated.noise(260, 3, offset=noise_offset(rng))
    sheen = coated.remap(coated.distance((radius * 0.3, radius * 0.2, 0)), 0, radius * 0.9, 0.35, 0)
    coated.colour(
        coated.mix(sheen, coated.mix(coated.remap(ring, 0.35, 0.65), "232426", "2f3033"), "5a5d62")
    )
    steel = metal("c2c6ca", "7e848a")
    if inside:
        coated = steel if inside == "steel" else plain(inside, 0.06, 50)
    paint = steel if outside == "steel" else plain(outside, 0.05, 20, noise_offset(rng))
    profile, kinds = wall_profile(outer, wall, floor, 0.001)
    dish = lathe(
        profile,
        14 if shape == "wok" else 16 if shape == "grill" else 18,
        mats=[paint, coated, paint, steel],
        mat_of_segment=kinds,
    )
    body, square = [dish], shape == "grill"
    if square:
        squared(dish, 0.92, 0.92, 7)
        for k in range(7):  # ridges
            y = (k - 3) * radius * 0.22
            body.append(
                box(1.45 * radius, 0.005, 0.005, (0, y, floor - 0.0005), coated, weight=0.5)
            )
    low = outer[0][0]
    n = len(outer) // 2
    pieces = [cylinder_piece(low, 0, floor)]
    for a, b in ((outer[0], outer[n]), (outer[n], outer[-1])):
        pieces += ring_pieces([a, b], [(a[0] - 0.007, a[1]), (b[0] - 0.007, b[1])], 10)
    if length:
        fix = plain(outside, 0.05) if outside != "steel" else steel
        start = radius * 0.92 if square else radius
        meshes, more = long_handle(
            start + 0.012, height * 0.8, length, plain(handle, 0.06, 120), 0.028
        )
        body += [
            box(0.034, 0.02, 0.012, (start + 0.006, 0, height * 0.8 - 0.006), steel, 0.003),
            *meshes,
        ]
        if shape == "wok":
            grip = loops(radius, height * 0.86, fix, 0.035, 0.03)[0][0]
            body.append(grip.turn(rz=-math.pi / 2))
    else:
        meshes, more = loops(radius, height * 0.8, plain(handle, 0.06, 120), 0.05, 0.045)
        body += meshes
    flat = low * 0.9
    fat = plain("8a5a1c", 0.2, 60)
    top = floor + (0.0048 if square else 0.0004)
    mess = [smear(0, 0, top, flat * 0.82, rng, fat, 0.0008, 12)]
    mess += remains(dirt, flat, top + 0.0009, look, 0.85, 9)
    if dirt == "egg":  # a fried egg left over
        white, yolk = plain("fbf8ee", 0.04), plain("f2ac18", 0.05)
        mess.append(
            smear(flat * 0.3, -flat * 0.25, top + 0.0015, flat * 0.36, rng, white, 0.004, 14)
        )
        mess.append(
            ellipsoid((0.016, 0.016, 0.009), (flat * 0.3, -flat * 0.25, top + 0.006), 8, 4, yolk)
        )
    hold = rectangle(1.3 * flat, 1.3 * flat) if square else round_polygon(flat * 0.95)
    name = {"frying": "frying pan", "grill": "square grill pan", "crepe": "pancake pan"}
    return Model(
        title=name.get(shape, "small frying pan" if shape == "egg" else f"{shape} pan"),
        parts={
            "body": Part(body, collision=pieces + more),
            "remains": Part(mess, collision="none"),
        },
        variants={"default": ["body"], "dirty": ["body", "remains"]},
        states=DIRTY,
        mass=1.1 if shape != "egg" else 0.6,
        texture_size=128,
        supports=[Support("bottom", top if square else floor, hold, container="inside")],
        containers=[
            Container("inside", (0, 0, height / 2 + 0.005), (1.3 * low, 1.3 * low, height - 0.011))
        ],
    )


def frying_pan_random(rng: np.random.Generator) -> dict:
    return {"look": seed_of(rng)}


MODELS = {
    "frying_pan": Maker(
        frying_pan,
        frying_pan_random,
        count=8,
        presets=[
            {"shape": "frying", "outside": "#2a2b2e", "handle": "#1c1c1e", "dirt": "egg"},
            {"shape": "frying", "outside": "#9a2f2b", "handle": "#6b3d1e", "dirt": "burnt"},
            {"shape": "wok", "outside": "#26272a", "handle": "#8a5a2e", "dirt": "burnt"},
            {"shape": "grill", "outside": "#232427", "handle": "#1c1c1e", "dirt": "burnt"},
            {"shape": "crepe", "outside": "#35536b", "handle": "#26262a", "dirt": "cake"},
            {"shape": "saute", "outside": "steel", "inside": "steel", "handle": "#9a9ea2"}
            | {"dirt": "peas"},
            {"shape": "paella", "outside": "steel", "inside": "#3c3e42", "handle": "#c8302c"}
            | {"dirt": "peas"},
            {"shape": "egg", "outside": "#c8702c", "inside": "#e9e4d8", "handle": "#6b3d1e"}
            | {"dirt": "egg"},
        ],
    ),
}
