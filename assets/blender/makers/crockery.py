"""Plates and bowls; broken, or dirty after a meal."""

from __future__ import annotations

import math

import numpy as np
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material, plain, wood
from toolkit.mesh import face_normal
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    cylinder_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import lathe, tube

from makers.breakage import wall_seeds
from makers.ware import (
    SAUCES,
    WARE_STATES,
    hollow,
    r_at,
    remains,
    runs,
    smear,
    spread_out,
    squared,
    wall_pieces,
    wall_profile,
)

# (share of the radius, height in metres) of the upper side, from the middle outwards
PLATES = {
    "dinner": [(0.62, 0), (0.7, 0.008), (0.98, 0.02), (1, 0.022)],
    "coupe": [(0.6, 0), (0.8, 0.006), (0.95, 0.02), (1, 0.03)],
    "soup": [(0.5, 0), (0.58, 0.01), (0.68, 0.034), (0.98, 0.041), (1, 0.043)],
    "square": [(0.62, 0), (0.72, 0.006), (0.97, 0.022), (1, 0.025)],
    "oval": [(0.62, 0), (0.7, 0.008), (0.98, 0.022), (1, 0.024)],
}


def plate_glaze(colour, accent, style: str, radius: float, look: int) -> Material:
    """White ware with coloured bands, a spiral of dots or a coloured well."""
    rng = np.random.default_rng(look)
    m = Material(occlusion=0.8)
    base = m.mottle(colour, 0.03, 25, noise_offset(rng))
    far = m.distance((0, 0, 0.01), (1, 1, 0))
    bands = {
        "rim": [(0.9, 1.5)],
        "rings": [(0.7, 0.73), (0.77, 0.79), (0.93, 0.96)],
        "well": [(0, 0.62)],
        "wide": [(0.7, 1.5)],
    }.get(style, [])
    for low, high in bands:
        above, below = (
            m.math("GREATER_THAN", far, low * radius),
            m.math("LESS_THAN", far, high * radius),
        )
        base = m.mix(m.math("MULTIPLY", above, below), base, accent)
    if style == "speckled":
        base = m.mix(m.math("LESS_THAN", m.voronoi(90), 0.16), base, accent)
    return m.colour(base)


def plate(
    shape="dinner",
    radius=0.13,
    colour="#f3f1ea",
    accent="#2d5f8a",
    style="rim",
    leftover="pasta",
    stack=1,
    look=0,
    seed=0,
) -> Model:
    """A plate of a form of PLATES, or a stack of them; seed: how it breaks."""
    r, wall = radius, 0.0052
    outer = [(r * q, z) for q, z in PLATES[shape]]
    floor = 0.0065
    profile, kinds = wall_profile(outer, wall, floor, 0.0015)
    glaze = plate_glaze(colour, accent, style, r, look)
    below = plain(colour, 0.03, 25)
    n = 16 if shape == "square" else 18 if shape == "soup" else 22

    def form(mesh):
        if shape == "square":
            return squared(mesh, 0.9, 0.9, 5)
        return mesh.scale(0.72, 1.08, 1) if shape == "oval" else mesh

    def dish(count: int):
        mats = [below, glaze, below, glaze]
        return form(lathe(profile, count, mats=mats, mat_of_segment=kinds))

    count, step = (n, 0.0) if stack == 1 else (14, 0.0098)
    meshes = [dish(count).keep_pattern().move(z=step * k) for k in range(stack)]
    for k, mesh in enumerate(meshes[:-1]):  # the others cover the middle of the lower ones
        faces = [(np.hypot(*mesh.v[list(f)].mean(0)[:2]), mesh.v[list(f)]) for f in mesh.f]
        edge = [q > 0.86 * r or (k == 0 and face_normal(c)[2] < 0) for q, c in faces]
        mesh.keep_faces([i for i, kept in enumerate(edge) if kept])
    angle = float(np.random.default_rng(seed).uniform(0, 2 * math.pi))
    seeds = [
        (r * q * math.cos(angle + a), r * q * math.sin(angle + a), 0.01)
        for q, a in ((0.3, 0.4), (0.65, 1.9), (0.75, 3.0), (0.55, 4.0), (0.8, 5.0))
    ]
    raw = plain("d8c8a8", 0.12, 300)
    weights = [(0.35 * r) ** 2, 0, 0, 0, 0]
    shards = fracture([dish(14)], seeds, raw, weights, seed, 0.004, 0.07)
    fallen = spread_out(shards, np.random.default_rng(seed), 0.34, 0.012)
    top = step * (stack - 1)
    rng = np.random.default_rng(look)
    sauce = plain(SAUCES[leftover], 0.2, 90)
    left = remains(leftover, r * 0.56, floor + 0.0006 + top, look, 0.8, 9)
    left.append(smear(r * 0.72, r * 0.25, 0.014 + top, r * 0.11, rng, sauce, 0.003))
    floor_r = outer[0][0]
    if shape == "square":
        floor_r *= 0.9
    pieces = [cylinder_piece(floor_r, 0, floor + top, 12)]
    (ra, _), (rb, zb) = outer[0], outer[-1]
    pieces += ring_pieces(
        [(ra * 0.97, top), (rb, zb + top - 0.004)],
        [(ra * 0.97, floor + top), (rb * 0.97, zb + top)],
    )
    if shape == "square":
        pieces = [p * [0.94, 0.94, 1] for p in pieces]
    if shape == "oval":
        pieces = [p * [0.72, 1.08, 1] for p in pieces]
    hold = [(x * (0.72 if shape == "oval" else 1), y) for x, y in round_polygon(floor_r * 0.86)]
    name = {"soup": "soup plate", "oval": "oval serving plate"}.get(shape, f"{shape} plate")
    return Model(
        title=f"stack of {stack} plates" if stack > 1 else f"{name}, {style}",
        mass=0.5 * stack,
        texture_size=256 if style in ("rings", "speckled") else 128,
        parts={
            "body": Part(meshes, collision=pieces, open=stack > 1),
            "remains": Part(left, collision="none"),
            "shards": Part(shards, collision=fallen),
        },
        variants={"default": ["body"], "dirty": ["body", "remains"], "broken": ["shards"]},
        states=WARE_STATES,
        supports=[Support("inside", floor + top, hold)],
    )


def plate_random(rng: np.random.Generator) -> dict:
    return {
        "shape": pick(rng, list(PLATES)),
        "colour": pick(rng, ["#f3f1ea", "#eceae4", "#d9e3e4", "#e6dcc8"]),
        "accent": pick(rng, ["#2d5f8a", "#a33b35", "#4c7a54", "#3a3a3e"]),
        "style": pick(rng, ["rim", "rings", "plain", "wide"]),
        "leftover": pick(rng, ["pasta", "peas", "bones", "cake", "egg"]),
        "look": seed_of(rng),
        "seed": 3,
    }


# shares of (radius, height)
BOWLS = {
    "cereal": (0.082, 0.066, [(0.48, 0), (0.5, 0.1), (0.76, 0.35), (0.93, 0.66), (1, 1)]),
    "salad": (0.135, 0.088, [(0.5, 0), (0.62, 0.06), (0.85, 0.34), (0.96, 0.68), (1, 1)]),
    "rice": (0.061, 0.068, [(0.46, 0), (0.44, 0.12), (0.74, 0.3), (0.94, 0.64), (1, 1)]),
    "ramekin": (0.052, 0.05, [(0.93, 0), (0.96, 0.05), (1, 0.5), (1, 1)]),
    "mixing": (
        0.115,
        0.115,
        [(0.42, 0), (0.55, 0.05), (0.82, 0.36), (0.94, 0.7), (1, 0.97), (1.05, 1)],
    ),
    "onion": (0.066, 0.062, [(0.6, 0), (0.72, 0.06), (1, 0.4), (1, 0.7), (0.92, 1)]),
    "flared": (0.11, 0.06, [(0.34, 0), (0.36, 0.14), (0.5, 0.3), (0.74, 0.6), (1, 1)]),
}


def bowl(
    shape="cereal",
    colour="#4f7f86",
    inside="#f3efe4",
    band=True,
    material="",
    leftover="milk",
    stack=1,
    look=0,
    seed=0,
) -> Model:
    """A bowl of a form of BOWLS; material: '', 'wood' or 'glass'."""
    rng = np.random.default_rng(look)
    radius, height, shares = BOWLS[shape]
    outer = [(radius * r, height * z) for r, z in shares]
    wall, floor = (0.008, 0.014) if material == "wood" else (0.0048, 0.011)
    paint = Material()
    base = paint.mottle(colour, 0.07, 40, noise_offset(rng))
    if band:
        z = paint.axis(2)
        top = paint.math("GREATER_THAN", z, height * 0.84)
        low = paint.math("LESS_THAN", z, height * 0.2)
        base = paint.mix(paint.math("MAXIMUM", top, low), base, inside)
    paint.colour(base)
    inner = plain(inside, 0.04, 40, noise_offset(rng))
    if material == "wood":
        paint, inner = (wood("b5824e", "74481f", 1, 14, noise_offset(rng)) for _ in range(2))
    rim = plain(colour, 0.04) if not band and not material else inner
    profile, kinds = wall_profile(outer, wall, floor)
    mats = [paint, inner, inner, rim]

    def shell(n: int):
        return lathe(profile, n, mats=list(mats), mat_of_segment=kinds)

    step = height * 0.3
    meshes = [
        shell(12 if stack > 1 else 14 if shape == "onion" else 16).keep_pattern().move(z=step * k)
        for k in range(stack)
    ]
    whole, pieces = [shell(11)], wall_pieces(outer, wall, floor)
    if shape == "onion":  # two lugs
        for side in (-1, 1):
            ys = [(-0.02, 0.96), (-0.014, 1.2), (0, 1.3), (0.014, 1.2), (0.02, 0.96)]
            path = [(x, side * radius * q, height * 0.7) for x, q in ys]
            for group, sides in ((meshes, 5), (whole, 5)):
                group.append(tube(path, 0.0065, sides, mat=paint, up=(0, 0, 1.0)))
    seeds = wall_seeds(radius, height, 4, np.random.default_rng(seed))
    weights = [(0.55 * radius) ** 2, 0, 0, 0, 0]
    raw = plain("c99a5c" if material == "wood" else "d8c8a8", 0.12, 300)
    shards = fracture(whole, seeds, raw, weights, seed, 0.003, 0.06)
    fallen = scatter(shards, np.random.default_rng(seed))
    up = step * (stack - 1)
    sauce = plain(SAUCES[leftover], 0.2, 90)
    low_r = r_at(outer, floor + 0.004) - wall - 0.001
    left = remains(leftover, max(low_r, radius * 0.4), floor + 0.0014, look, 0.7)
    left += runs(outer, rng, 5, sauce, -wall * 1.5, 0.0032)
    left.append(smear(0, 0, floor + 0.001, low_r * 0.95, rng, sauce))
    for mesh in left:
        mesh.keep_pattern().move(z=up)
    space = hollow(outer, wall, floor)
    space.center = (0, 0, space.center[2] + up)
    pieces = [p + np.array([0, 0, up]) for p in pieces]
    if stack > 1:
        pieces.append(cylinder_piece(outer[0][0], 0, up + 0.002, 12, radius))
    return Model(
        title=f"stack of {stack} bowls" if stack > 1 else f"{material} {shape} bowl".strip(),
        mass=0.4 * stack,
        texture_size=128,
        parts={
            "body": Part(meshes, collision=pieces),
            "remains": Part(left, collision="none"),
            "shards": Part(shards, collision=fallen),
        },
        variants={"default": ["body"], "dirty": ["body", "remains"], "broken": ["shards"]},
        states=WARE_STATES,
        supports=[Support("bottom", floor + up, round_polygon(low_r * 0.85), container="inside")],
        containers=[space],
    )


def bowl_random(rng: np.random.Generator) -> dict:
    return {
        "shape": pick(rng, list(BOWLS)),
        "colour": pick(rng, ["#4f7f86", "#b5533c", "#3c4a6b", "#c9b27c", "#efece4"]),
        "inside": pick(rng, ["#f3efe4", "#e9e2d0"]),
        "band": bool(rng.random() < 0.5),
        "leftover": pick(rng, ["milk", "soup", "peas"]),
        "look": seed_of(rng),
        "seed": 4,
    }


MODELS = {
    "plate": Maker(
        plate,
        plate_random,
        count=8,
        presets=[
            {"shape": "dinner", "style": "rim", "accent": "#2d5f8a", "leftover": "pasta"},
            {"shape": "dinner", "style": "rings", "accent": "#a33b35", "leftover": "bones"},
            {"shape": "coupe", "style": "wide", "radius": 0.095, "colour": "#f0ece0"}
            | {"accent": "#7aa6a8", "leftover": "cake"},
            {"shape": "soup", "style": "rim", "radius": 0.115, "accent": "#4c7a54"}
            | {"leftover": "soup"},
            {
                "shape": "square",
                "style": "plain",
                "radius": 0.095,
                "colour": "#34383e",
                "leftover": "egg",
            },
            {"shape": "dinner", "style": "rim", "stack": 3, "radius": 0.12, "accent": "#a33b35"}
            | {"leftover": "cake"},
            {"shape": "oval", "style": "wide", "radius": 0.165, "accent": "#d8a23a"}
            | {"leftover": "bones"},
            {
                "shape": "square",
                "style": "well",
                "radius": 0.095,
                "colour": "#f3f1ea",
                "accent": "#6d8fb3",
            }
            | {"leftover": "peas"},
        ],
    ),
    "bowl": Maker(
        bowl,
        bowl_random,
        count=8,
        presets=[
            {"shape": "cereal", "colour": "#4f7f86", "band": True, "leftover": "milk"},
            {"shape": "flared", "colour": "#b5533c", "band": False, "leftover": "pasta"},
            {"shape": "rice", "colour": "#efece4", "band": False, "leftover": "peas"},
            {"shape": "salad", "colour": "#9a6a3a", "material": "wood", "band": False}
            | {"leftover": "peas"},
            {"shape": "ramekin", "colour": "#7fb8a8", "band": False, "leftover": "cake"},
            {"shape": "mixing", "colour": "#e8c33a", "band": True, "leftover": "egg"},
            {"shape": "onion", "colour": "#7a4a26", "inside": "#e6d2a8", "band": False}
            | {"leftover": "soup"},
            {"shape": "cereal", "colour": "#3c4a6b", "band": True, "stack": 3, "leftover": "soup"},
        ],
    ),
}
