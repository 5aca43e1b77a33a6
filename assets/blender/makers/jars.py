"""Glass that breaks: wine glasses and jars, each with a `broken` variant."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.model import Container, Maker, Model, Part, cylinder_piece, ring_pieces
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import lathe

from makers.breakage import BROKEN, broken, wall_seeds

CLEAR = (1.0, 1.0, 1.0, 0.55)


def clear_glass(tint: str, height: float) -> Material:
    """Glass: bright rim, upright reflection, darker foot; drawn half see-through."""
    m = Material(occlusion=0.35)
    z = m.remap(m.axis(2), 0, height)
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.45)), 0.0, 0.12, 0.75, 0)
    stops = [(0, shade(tint, 0.7)), (0.06, shade(tint, 0.85)), (0.3, tint), (0.95, tint)]
    return m.colour(m.mix(shine, m.ramp(z, [*stops, (0.985, "ffffff"), (1, "ffffff")]), "ffffff"))


def wine_glass(radius: float, height: float, wine: str, tint: str, seed: int) -> Model:
    """A stemmed glass, empty or (wine: its colour) a third full."""
    r, h, t = radius, height, 0.003
    base = 0.46 * h  # where the bowl begins
    foot = [(0, 0), (0.84 * r, 0), (0.86 * r, 0.0025), (0.3 * r, 0.007), (0.0052, 0.018)]
    stem = [(0.0046, 0.5 * base), (0.0055, 0.92 * base)]
    bowl = [(0.55, 0.05), (0.9, 0.22), (1.0, 0.42), (0.95, 0.7), (0.8, 1.0)]
    outer = [(k * r, base + z * (h - base)) for k, z in bowl]
    inner = [(q - t, z + (0.004 if z < 0.8 * h else 0)) for q, z in outer[::-1]]
    profile = [*foot, *stem, *outer, *inner, (0, base + 0.007)]
    glass = clear_glass(tint, h)
    pieces = [cylinder_piece(0.85 * r, 0, 0.006, 12), cylinder_piece(0.006, 0.006, base, 6)]
    low = outer[0]
    pieces.append(cylinder_piece(0.008, base, low[1], 8, low[0]))
    for a, b in ((outer[0], outer[2]), (outer[2], outer[4])):
        pieces += ring_pieces([a, b], [(a[0] - t, a[1]), (b[0] - t, b[1])], 8)
    parts = {"body": Part([lathe(profile, 16, mat=glass)], rgba=CLEAR, collision=pieces)}
    if wine:
        top = base + 0.42 * (h - base)
        liquid = Material(occlusion=0.2)
        band = liquid.math("ABSOLUTE", liquid.math("ADD", liquid.normal(1), 0.45))
        shine = liquid.remap(band, 0.0, 0.1, 0.6, 0)
        liquid.colour(liquid.mix(shine, wine, "ffffff"))
        # drawn just outside the glass: seen through it, red would pale to pink
        skin = [(q + 0.0005, z) for q, z in outer[:3]]
        fill = [(0, base + 0.001), (0.008, base + 0.003), *skin, (r - t, top), (0, top)]
        parts["liquid"] = Part([lathe(fill, 16, mat=liquid)], collision="none", occlusion="liquid")
    rng = np.random.default_rng(seed)
    turn = rng.uniform(0, 2 * math.pi)
    seeds = [(0, 0, 0.1 * base), (0.3 * r, 0, 0.95 * base)]
    for i in range(5):
        a = turn + 2 * math.pi * i / 5
        z = base + (h - base) * (0.75 if i % 2 else 0.45)
        seeds.append((1.1 * r * math.cos(a), 1.1 * r * math.sin(a), z))
    parts["shards"] = broken(
        [lathe(profile, 12, mat=clear_glass(tint, h))],
        plain("f2fafb", 0.0, occlusion=0.2),
        seeds,
        0.0,
        seed,
        (1.0, 1.0, 1.0, 0.62),
        edge=0.03,
    )
    return Model(
        "glass of red wine" if wine else "wine glass",
        parts,
        mass=0.18,
        friction=0.4,
        texture_size=128,
        variants={"default": [n for n in parts if n != "shards"], "broken": ["shards"]},
        states=BROKEN,
        containers=[
            Container("inside", (0, 0, (base + h) / 2 + 0.01), (1.1 * r, 1.1 * r, 0.4 * (h - base)))
        ],
    )


def wine_glass_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.038, 0.043),
        "height": uniform(rng, 0.185, 0.215),
        "tint": "#dcebef",
        "seed": seed_of(rng),
    }


def glass_jar(
    radius: float, height: float, filling: str, lid: str, words: str, colour: str, seed: int
) -> Model:
    """A jar with a screwed lid: jam with a paper label, or an empty preserving jar."""
    rng = np.random.default_rng(seed)
    r, h, t, shoulder = radius, height, 0.0035, 0.84 * height
    offset = noise_offset(rng)
    glass = clear_glass("#cfe3e4", h)
    if filling:
        glass = Material(occlusion=0.5)
        lumps = glass.ramp(
            glass.noise(130, 3, offset=offset),
            [(0.35, shade(filling, 0.6)), (0.5, filling), (0.65, shade(filling, 1.4))],
        )
        full = glass.mix(glass.remap(glass.axis(2), 0.78 * h, 0.8 * h), lumps, "dfeaec")
        band = glass.math("ABSOLUTE", glass.math("ADD", glass.normal(1), 0.5))
        glass.colour(glass.mix(glass.remap(band, 0.02, 0.1, 0.6, 0), full, "ffffff"))
    low, high = 0.2 * h, 0.62 * h
    outer = [(0.9 * r, 0), (r, 0.006), (r, low), (r, high), (r, 0.74 * h), (0.82 * r, shoulder)]
    outer.append((0.8 * r, 0.985 * h))
    inner = [(0.8 * r - t, 0.985 * h), (0.8 * r - t, shoulder), (r - t, 0.72 * h), (r - t, 0.008)]
    profile = [(0, 0.002), *outer, *inner, (0, 0.006)]
    picture, draw = canvas(1024, 192, "#f8f2e0")
    for k in range(5):  # four times round, one of them in front
        x = 256 * k - 128
        draw.rectangle((x + 6, 8, x + 249, 183), outline=colour, width=6)
        text(draw, words, (x + 16, 16, x + 240, 96), "bold", colour)
        text(draw, "JAM", (x + 50, 102, x + 206, 178), "bold", colour)
    mats = [glass, printed(picture)] if words else [glass, glass]

    def shell(n: int):
        return lathe(
            profile,
            n,
            mats=mats,
            mat_of_segment=[1 if k == 3 else 0 for k in range(len(profile) - 1)],
            label_z=(low, high),
            start=-math.pi,
        )

    tin = plain(lid, 0.04) if lid != "steel" else metal("d0b25a", "8f7430")
    top = lathe(
        [(0, 0.87 * h), (0.88 * r, 0.87 * h), (0.88 * r, 0.985 * h), (0.82 * r, h), (0, h)],
        18,
        mat=tin,
        rib=lambda k, i: 1 - 0.03 * (i % 2) if k in (1, 2) else 1,
    )
    pieces = [cylinder_piece(r, 0, 0.008, 12)]
    pieces += ring_pieces([(r, 0), (r, 0.74 * h)], [(r - t, 0.008), (r - t, 0.74 * h)], 10)
    pieces.append(cylinder_piece(r, 0.74 * h, shoulder, 12, 0.85 * r))
    seeds = wall_seeds(r, h, 5, rng)
    raw = plain("e6f4f2", 0.0, occlusion=0.2)
    rgba = None if filling else (1.0, 1.0, 1.0, 0.42)
    shards = broken([shell(12).weigh(0.6)], raw, seeds, (0.3 * r) ** 2, seed, rgba, edge=0.03)
    parts = {
        "body": Part([shell(18).weigh(1.4)], rgba=rgba, collision=pieces),
        "lid": Part([top], collision=[cylinder_piece(0.88 * r, 0.86 * h, h, 12)]),
        "shards": shards,
    }
    if filling:  # what was in it lies among the shards
        blob = lathe(
            [(0, 0), (0.8 * r, 0), (0.66 * r, 0.006), (0, 0.012)], 12, mat=plain(filling, 0.2)
        )
        parts["spill"] = Part([blob], collision="none")
    return Model(
        f"jar of {words.lower()} jam" if words else "empty glass jar",
        parts,
        mass=0.5 if filling else 0.28,
        friction=0.5,
        variants={
            "default": ["body", "lid"],
            "broken": ["shards", *(["spill"] if filling else [])],
        },
        states=BROKEN,
    )


def glass_jar_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.034, 0.038),
        "height": uniform(rng, 0.105, 0.125),
        "seed": seed_of(rng),
    }


MODELS = {
    "wine_glass": Maker(wine_glass, wine_glass_random, 2, [{"wine": ""}, {"wine": "#7a1024"}]),
    "glass_jar": Maker(
        glass_jar,
        glass_jar_random,
        2,
        [
            {"filling": "#b01822", "lid": "#c8202c", "words": "CHERRY", "colour": "#a0182a"},
            {"filling": "", "lid": "steel", "words": "", "colour": "#444444", "height": 0.15},
        ],
    ),
}
