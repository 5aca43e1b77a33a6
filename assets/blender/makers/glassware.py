"""Drinking glasses and stemmed glasses: empty, full or broken."""

from __future__ import annotations

import math

import numpy as np
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material, plain, shade
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    cylinder_piece,
    prism_piece,
    ring_pieces,
)
from toolkit.sampling import pick
from toolkit.shapes import lathe, tube

from makers.breakage import BROKEN, wall_seeds
from makers.ware import FULL, hollow, r_at, wall_pieces, wall_profile

CLEAR = (1.0, 1.0, 1.0, 0.5)
SPLINTERS = (1.0, 1.0, 1.0, 0.66)


def clear_glass(tint: str, height: float, bands: tuple = (), cut: int = 0) -> Material:
    """Glass: bright rim, upright reflections, darker foot; drawn half see-through."""
    m = Material(occlusion=0.35)
    z = m.remap(m.axis(2), 0, height)
    left = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5)), 0.0, 0.16, 0.95, 0)
    right = m.remap(m.math("ABSOLUTE", m.math("SUBTRACT", m.normal(1), 0.72)), 0.0, 0.08, 0.6, 0)
    shine = m.math("MAXIMUM", left, right)
    stops = [
        (0, shade(tint, 0.6)),
        (0.07, shade(tint, 0.8)),
        (0.13, tint),
        (0.92, tint),
        (0.965, "ffffff"),
        (1, "ffffff"),
    ]
    base = m.mix(shine, m.ramp(z, stops), "ffffff")
    for low, high, colour in bands:
        above = m.math("GREATER_THAN", m.axis(2), low * height)
        below = m.math("LESS_THAN", m.axis(2), high * height)
        base = m.mix(m.math("MULTIPLY", above, below), base, colour)
    return m.colour(base)


def drink(colour: str, radius: float, z: float, depth: float) -> Material:
    """What is in a glass: an upright reflection at its side, a bright rim round its top."""
    m = Material(occlusion=0.15)
    side = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5)), 0.0, 0.12, 0.55, 0)
    body = m.ramp(m.remap(m.axis(2), z - depth, z), [(0, shade(colour, 0.75)), (1, colour)])
    body = m.mix(side, body, "ffffff")
    far = m.distance((0, 0, z), (1, 1, 0))
    ring = m.remap(far, 0.8 * radius, radius, 0, 0.55)
    top = m.mix(ring, shade(colour, 1.12), "ffffff")
    return m.colour(m.mix(m.math("GREATER_THAN", m.normal(2), 0.7), body, top))


DRINKS = {
    "water": "a9cdda",
    "juice": "f39a1a",
    "milk": "fbf8ef",
    "cola": "34160c",
    "beer": "e2a020",
    "tomato": "c02a18",
    "lemonade": "e6e27a",
}

# radius, height, outline in shares, columns
GLASSES = {
    "tumbler": (0.036, 0.122, [(0.82, 0), (0.84, 0.03), (0.92, 0.5), (1, 1)], 20),
    "highball": (0.032, 0.165, [(0.96, 0), (1, 0.03), (1, 0.5), (1, 1)], 18),
    "whisky": (0.044, 0.088, [(0.92, 0), (0.96, 0.05), (1, 0.5), (1, 1)], 8),
    "pint": (0.044, 0.15, [(0.7, 0), (0.72, 0.04), (0.8, 0.45), (1, 0.78), (0.96, 1)], 18),
    "mug": (0.041, 0.135, [(0.97, 0), (1, 0.05), (1, 0.5), (1, 1)], 10),
    "bistro": (0.042, 0.095, [(0.66, 0), (0.7, 0.06), (0.8, 0.56), (0.97, 0.6), (1, 1)], 10),
    "footed": (
        0.042,
        0.175,
        [(0.8, 0), (0.78, 0.02), (0.24, 0.07), (0.22, 0.16), (0.7, 0.26), (0.84, 0.6), (1, 1)],
        16,
    ),
}


def drinking_glass(
    shape="tumbler", tint="#dcebef", liquid="water", bands=(), level=0.84, seed=0
) -> Model:
    """A glass of a form of GLASSES; what is behind shows through it."""
    radius, height, shares, n = GLASSES[shape]
    outer = [(radius * r, height * z) for r, z in shares]
    wall = 0.003
    floor = 0.26 * height + 0.004 if shape == "footed" else 0.013
    bowl_at = next(k for k, (_, z) in enumerate(outer) if z >= floor - 0.005)
    profile, kinds = wall_profile(outer, wall, floor)
    glass = clear_glass(tint, height, bands)
    thick = 0.0055

    def shell(count: int):
        return lathe(profile, count, mats=[glass] * 4, mat_of_segment=kinds)

    meshes, whole = [shell(n)], [shell(min(n, 11))]
    pieces = wall_pieces(outer, wall, floor)
    if shape == "footed":
        pieces = [cylinder_piece(0.8 * radius, 0, 0.006, 12), cylinder_piece(0.012, 0, floor, 8)]
        a, b = outer[bowl_at], outer[-1]
        pieces += ring_pieces([a, b], [(a[0] - wall, a[1]), (b[0] - wall, b[1])], 8)
    if shape == "mug":
        ys = [
            (-0.001, 0.2),
            (0.03, 0.22),
            (0.036, 0.35),
            (0.036, 0.66),
            (0.03, 0.8),
            (-0.001, 0.82),
        ]
        path = [(0, radius + y, q * height) for y, q in ys]
        for group in (meshes, whole):
            group.append(tube(path, thick, 6, mat=glass, up=(1.0, 0, 0), flatten=1.3))
        strip = [
            (-thick, radius),
            (thick, radius),
            (thick, radius + 0.042),
            (-thick, radius + 0.042),
        ]
        pieces.append(prism_piece(strip, 0.2 * height, 0.85 * height))
    seeds = wall_seeds(radius, height, 5, np.random.default_rng(seed))
    weights = [(0.6 * radius) ** 2] + [0.0] * 5
    if shape == "footed":
        seeds[0] = (0, 0, 0.1 * height)
    if shape == "mug":
        seeds.append((0, radius + 0.05, 0.5 * height))
        weights.append(0.0)
    raw = plain("f2fafb", 0.0, occlusion=0.2)
    shards = fracture(whole, seeds, raw, weights, seed, 0.003, 0.06)
    fallen = scatter(shards, np.random.default_rng(seed))
    top = height * level
    r_top = r_at(outer, top) + 0.0004  # just outside: seen through glass, colours pale
    steps = np.linspace(floor + 0.001, top, 4)
    side = [(r_at(outer, z) + 0.0004, z) for z in steps]
    poured = drink(DRINKS[liquid], r_top, top, top - floor)
    fill = [(0, floor + 0.001), *side, (0, top + 0.0004)]
    contents = [lathe(fill, min(n, 14), mat=poured)]
    if liquid == "beer":
        foam = plain("f8f2e0", 0.05, 200)
        head = [
            (r_top, top - 0.018),
            (r_top + 0.0002, top),
            (0.7 * r_top, top + 0.006),
            (0, top + 0.008),
        ]
        contents = [lathe([(0, top - 0.018), *head], 14, mat=foam), *contents]
    narrow = r_at(outer, (floor + height) / 2) - wall
    space = hollow(outer, wall, floor)
    if shape == "footed":
        size = (narrow * 1.2, narrow * 1.2, height - floor - 0.004)
        space = Container("inside", (0, 0, (floor + height) / 2), size)
    return Model(
        title={"mug": "beer mug", "footed": "footed drinking glass"}.get(shape, f"{shape} glass"),
        parts={
            "body": Part(meshes, rgba=CLEAR, collision=pieces),
            "filling": Part(contents, collision="none"),
            "shards": Part(shards, rgba=SPLINTERS, collision=fallen),
        },
        mass=0.3,
        texture_size=128,
        variants={"default": ["body"], "full": ["filling", "body"], "broken": ["shards"]},
        states=[*BROKEN, *FULL],
        containers=[space],
        prune=False,
    )


def drinking_glass_random(rng: np.random.Generator) -> dict:
    return {
        "shape": pick(rng, list(GLASSES)),
        "tint": pick(rng, ["#dcebef", "#d5e6e0", "#e2e6ee"]),
        "liquid": pick(rng, list(DRINKS)),
        "seed": 6,
    }


# foot radius, stem's share of the height, radius, height, bowl in shares (radius, bowl's height)
STEMMED = {
    "red": (
        0.84,
        0.46,
        0.042,
        0.2,
        [(0.55, 0.05), (0.9, 0.22), (1.0, 0.42), (0.95, 0.7), (0.8, 1.0)],
    ),
    "white": (
        0.9,
        0.5,
        0.034,
        0.19,
        [(0.5, 0.04), (0.9, 0.3), (1.0, 0.5), (0.94, 0.75), (0.82, 1.0)],
    ),
    "flute": (
        1.15,
        0.36,
        0.027,
        0.235,
        [(0.3, 0.02), (0.72, 0.2), (1.0, 0.55), (0.96, 0.8), (0.86, 1.0)],
    ),
    "martini": (
        0.62,
        0.56,
        0.054,
        0.175,
        [(0.12, 0.04), (0.4, 0.34), (0.7, 0.67), (0.98, 0.97), (1.0, 1.0)],
    ),
    "coupe": (
        0.66,
        0.6,
        0.048,
        0.15,
        [(0.4, 0.06), (0.8, 0.3), (0.95, 0.6), (1.0, 0.85), (1.0, 1.0)],
    ),
    "brandy": (
        0.72,
        0.26,
        0.05,
        0.145,
        [(0.55, 0.03), (0.9, 0.2), (1.0, 0.42), (0.88, 0.75), (0.66, 1.0)],
    ),
}


def wine_glass(shape="red", wine="#7a1024", tint="#dcebef", stem="", poured=False, seed=0) -> Model:
    """A stemmed glass; poured: wine in it in the default variant too."""
    foot_share, base_share, r, h, bowl = STEMMED[shape]
    t, base = 0.003, base_share * h
    foot_r = foot_share * r
    foot = [(0, 0), (foot_r, 0), (1.02 * foot_r, 0.0025), (0.35 * foot_r, 0.007), (0.0056, 0.018)]
    stalk = [(0.0052, 0.5 * base), (0.006, 0.92 * base)]
    outer = [(k * r, base + z * (h - base)) for k, z in bowl]
    inner = [(q - t, z + (0.004 if z < 0.8 * h else 0)) for q, z in outer[::-1]]
    profile = [*foot, *stalk, *outer, *inner, (0, base + 0.007)]
    glass = clear_glass(tint, h, ((-0.01, base_share, stem),) if stem else ())
    pieces = [cylinder_piece(foot_r, 0, 0.006, 12), cylinder_piece(0.006, 0.006, base, 6)]
    low = outer[0]
    pieces.append(cylinder_piece(0.008, base, low[1], 8, low[0]))
    for a, b in ((outer[0], outer[2]), (outer[2], outer[4])):
        inside = [(max(a[0] - t, 0.001), a[1]), (b[0] - t, b[1])]
        pieces += ring_pieces([a, b], inside, 8)
    level = {
        "red": 0.42,
        "white": 0.5,
        "flute": 0.82,
        "martini": 0.85,
        "coupe": 0.75,
        "brandy": 0.35,
    }
    top = base + level[shape] * (h - base)
    r_top = r_at(outer, top)
    # drawn just outside the glass: seen through it, red would pale to pink
    skin = [(q + 0.0005, z) for q, z in outer if z < top - 0.001]
    fill = [(0, base + 0.001), (0.008, base + 0.003), *skin, (r_top + 0.0004, top), (0, top)]
    contents = lathe(fill, 14, mat=drink(wine, r_top, top, top - base))
    turn = float(np.random.default_rng(seed).uniform(0, 2 * math.pi))
    seeds = [(0, 0, 0.1 * base), (0.3 * r, 0, 0.95 * base)]
    for i in range(4):
        a = turn + 2 * math.pi * i / 4
        z = base + (h - base) * (0.85 if i % 2 else 0.5)
        seeds.append((1.1 * r * math.cos(a), 1.1 * r * math.sin(a), z))
    # the foot keeps most of its stem
    weights = [(0.35 * base) ** 2] + [0.0] * 5
    raw = plain("f2fafb", 0.0, occlusion=0.2)
    shards = fracture([lathe(profile, 11, mat=glass)], seeds, raw, weights, seed, 0.003, 0.06)
    fallen = scatter(shards, np.random.default_rng(seed))
    name = {"flute": "champagne flute", "martini": "cocktail glass", "brandy": "brandy glass"}
    shown = ["filling", "body"] if poured else ["body"]
    variants = {"default": shown, "broken": ["shards"]}
    states = list(BROKEN)
    if not poured:
        variants["full"] = ["filling", "body"]
        states += FULL
    space = (1.1 * r_at(outer, base + 0.5 * (h - base)),) * 2
    return Model(
        name.get(shape, f"{shape} wine glass") + (", with wine" if poured else ""),
        {
            "body": Part([lathe(profile, 16, mat=glass)], rgba=CLEAR, collision=pieces),
            "filling": Part([contents], collision="none", occlusion="filling"),
            "shards": Part(shards, rgba=SPLINTERS, collision=fallen),
        },
        mass=0.18,
        friction=0.4,
        texture_size=128,
        variants=variants,
        states=states,
        prune=False,
        containers=[Container("inside", (0, 0, (base + h) / 2 + 0.01), (*space, 0.4 * (h - base)))],
    )


def wine_glass_random(rng: np.random.Generator) -> dict:
    return {"tint": "#dcebef", "seed": 8}


MODELS = {
    "drinking_glass": Maker(
        drinking_glass,
        drinking_glass_random,
        count=8,
        presets=[
            {"shape": "tumbler", "liquid": "water", "tint": "#dcebef"},
            {"shape": "highball", "liquid": "juice", "tint": "#d5e6e0"},
            {"shape": "whisky", "liquid": "cola", "tint": "#dfe8ee"},
            {"shape": "pint", "liquid": "beer", "tint": "#e6eeee"},
            {"shape": "mug", "liquid": "beer", "tint": "#dcebef"},
            {"shape": "bistro", "liquid": "milk", "tint": "#b9dcd0"},
            {"shape": "footed", "liquid": "lemonade", "tint": "#dcebef"},
            {"shape": "tumbler", "liquid": "tomato", "tint": "#d9e6f0"}
            | {"bands": ((0.5, 0.56, "#2f6fb0"), (0.62, 0.68, "#d8303a"), (0.74, 0.8, "#f2b92c"))},
        ],
    ),
    "wine_glass": Maker(
        wine_glass,
        wine_glass_random,
        count=8,
        presets=[
            {"shape": "red", "wine": "#7a1024"},
            {"shape": "red", "wine": "#7a1024", "poured": True},
            {"shape": "white", "wine": "#e4b93c", "poured": True},
            {"shape": "flute", "wine": "#ecd070"},
            {"shape": "martini", "wine": "#d8443c", "poured": True},
            {"shape": "coupe", "wine": "#f0cf6a"},
            {"shape": "brandy", "wine": "#a85a14", "poured": True},
            {"shape": "white", "wine": "#d98a7a", "stem": "#3f8a5a"},
        ],
    ),
}
