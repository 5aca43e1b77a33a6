"""Apples, oranges, tomatoes; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import lathe, loft, spline, tube

from makers import table_fruit as table
from makers.clusters import vine_tomatoes
from makers.produce_forms import served, with_forms
from makers.spoilage import age, aged, spots_around, wither

APPLES = {
    "red": ("a31420", "c8262c", "e4a93a"),
    "green": ("79a52c", "9cc544", "c9dc78"),
    "gala": ("c6402c", "dd7a3a", "ecc860"),
}


def apple(radius=0.038, kind="red", leaf=True, seed=0) -> Model:
    rng = np.random.default_rng(seed)
    r, o, phase = radius, noise_offset(rng), rng.uniform(0, 6.28, 3)
    zb = r * 0.8

    def body() -> Mesh:
        profile = []
        for t in np.linspace(0, 1, 12):
            a = math.pi * (1 - t)
            dimple = math.exp(-((math.sin(a) / 0.42) ** 2))
            z = math.cos(a) * 0.88 + (-0.3 if math.cos(a) > 0 else 0.2) * dimple
            profile.append(
                (math.sin(a) * (1 + 0.1 * math.cos(a)) * 1.05 * r if 0 < t < 1 else 0, z * r)
            )
        mesh = lathe(profile, 16, discs=False)

        def dent(x, y, z):
            a = math.atan2(y, x)
            f = (
                1
                + 0.025 * math.cos(5 * a + phase[0]) * max(0, -z / r * 0.8)
                + 0.02 * math.cos(a + phase[1])
            )
            return x * f, y * f, z * (1 + 0.03 * math.cos(a + phase[2])) + zb

        return mesh.warp(dent)

    def skin(look: str) -> Material:
        m = Material()
        low, mid, blush = APPLES[kind]
        streaks = m.noise(1, 3, stretch=(160, 160, 14), offset=o)
        c = m.mix(m.remap(streaks, 0.42, 0.62), low, mid)
        c = m.mix(m.remap(m.noise(22, 2, offset=o), 0.56, 0.8, 0, 0.75), c, blush)
        hollow = m.distance((0, 0, r * 0.62 + zb), (1, 1, 0.6))
        c = m.mix(
            m.remap(hollow, r * 0.15, r * 0.62, 0.85, 0),
            c,
            "8f8a3a" if kind == "green" else "b9a53f",
        )
        c = m.mix(m.remap(m.voronoi(230, o), 0.06, 0.13, 0.7, 0), c, "f0d9a0")
        return m.colour(age(look, m, c, r, spots, o))

    spots = spots_around(r, zb)
    top = r * 0.58 + zb
    stem_path = spline(
        [(0, 0, top - 0.003), (0.001, 0, top + 0.008), (0.004, 0.001, top + 0.018)], 2
    )

    def shape(look: str) -> list[Mesh]:
        fruit = wither(look, body(), r, spots)
        fruit.mats = [skin(look)]
        radii = [0.0013, 0.0012, 0.0013, 0.0016, 0.0019]
        stem = tube(stem_path, radii, 5, mat=plain("5a3a1c", 0.2, 300))
        if look == "rotten":
            return [fruit, stem.move(-0.002, -0.001, -0.004)]
        return [fruit, stem, *([leaf_mesh(look)] if leaf else [])]

    def leaf_mesh(look: str) -> Mesh:
        rings, length = [], 0.034
        for t in np.linspace(0, 1, 6):
            w, z = (
                0.0105 * math.sin(math.pi * min(1, t * 0.94 + 0.03)) ** 0.8,
                0.009 * math.sin(t * 2.3),
            )
            rings.append(
                [
                    (t * length, -w, z),
                    (t * length, 0, z - 0.002),
                    (t * length, w, z),
                    (t * length, 0, z - 0.0032),
                ]
            )
        tones = ("3f7a22", "5c9a33") if look == "fresh" else ("6a5a24", "7f7a30")
        green = Material()
        green.colour(green.mix(green.remap(green.noise(300, 2), 0.35, 0.65), *tones))
        return loft(rings, mat=green).turn(rz=-0.9).move(0.001, 0, top + 0.01)

    return aged(f"{kind} apple", shape, 0.17)


def apple_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.034, 0.041),
        "kind": pick(rng, list(APPLES)),
        "leaf": bool(rng.random() < 0.5),
        "seed": seed_of(rng),
    }


def orange(radius=0.038, colour="f08a14", seed=0) -> Model:
    rng = np.random.default_rng(seed)
    r, o = radius, noise_offset(rng)
    spots = spots_around(r, r * 0.95)

    def shape(look: str) -> list[Mesh]:
        m = Material()
        c = m.mix(
            m.remap(m.noise(30, 3, offset=o), 0.3, 0.7),
            shade(colour, 0.93),
            blend(colour, "ffc04a", 0.3),
        )
        c = m.mix(m.remap(m.voronoi(420, o), 0.0, 0.35, 0.55, 0), c, shade(colour, 0.72))
        c = m.mix(
            m.remap(m.distance((r * 0.35, -r * 0.3, r * 1.75)), 0, r * 0.5, 0.5, 0), c, "ffd9a0"
        )
        m.colour(age(look, m, c, r * 1.05, spots, o, "4a3a1c", 0.3))
        profile = [
            (math.sin(math.pi * k / 10) * r, -math.cos(math.pi * k / 10) * r * 0.95)
            for k in range(11)
        ]
        profile[0], profile[-1] = (0, -r * 0.93), (0, r * 0.9)
        mesh = lathe(profile, 18, mat=m, discs=False).move(z=r * 0.95)
        wither(look, mesh, r, spots, 0.12)
        star = lathe(
            [(0, -0.001), (0.0042, 0), (0.003, 0.0012), (0, 0.0014)],
            5,
            mat=plain("6f8a3a", 0.1, 300),
        )
        return [mesh, star.move(z=mesh.v[:, 2].max() - 0.0005)]

    return aged("orange", shape, 0.18)


def orange_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.034, 0.042),
        "colour": pick(rng, ["f08a14", "f29a1c", "ea7a10"]),
        "seed": seed_of(rng),
    }


def tomato(radius=0.036, colour="c8281c", seed=0, vine: dict | None = None) -> Model:
    """A beef tomato; vine: or small ones on a truss."""
    if vine:
        return vine_tomatoes(**vine)
    rng = np.random.default_rng(seed)
    r, o, phase = radius, noise_offset(rng), rng.uniform(0, 6.28)
    spots = spots_around(r, r * 0.8)

    def shape(look: str) -> list[Mesh]:
        m = Material()
        c = m.mix(
            m.remap(m.noise(25, 2, offset=o), 0.35, 0.7),
            shade(colour, 0.9),
            blend(colour, "ff6a3a", 0.25),
        )
        c = m.mix(
            m.remap(m.distance((r * 0.45, -r * 0.35, r * 1.5)), 0, r * 0.4, 0.65, 0), c, "ffb9a0"
        )
        c = m.mix(m.remap(m.distance((0, 0, r * 1.6)), r * 0.2, r * 0.6, 0.5, 0), c, "9a8a2c")
        m.colour(age(look, m, c, r * 1.05, spots, o, "2c1a10", 0.4))
        profile = []
        for k in range(11):
            a = math.pi * k / 10
            dip = math.exp(-((math.sin(a) / 0.4) ** 2)) * (0.14 if k > 5 else 0.06)
            profile.append((math.sin(a) * r, (-math.cos(a) * 0.84 - (dip if k > 5 else -dip)) * r))
        profile[0], profile[-1] = (0, profile[0][1]), (0, profile[-1][1])
        mesh = lathe(profile, 20, mat=m, discs=False)
        mesh.warp(
            lambda x, y, z: (
                *(q * (1 + 0.025 * math.cos(5 * math.atan2(y, x) + phase)) for q in (x, y)),
                z + r * 0.84,
            )
        )
        wither(look, mesh, r, spots, 0.18)
        top, green = r * 1.53, plain("4f8a2c" if look == "fresh" else "6a5a2c", 0.15, 200)
        leaves = []
        for i in range(5):
            a = 2 * math.pi * i / 5 + phase
            rings = [
                [(x, -w, z), (x, 0, z + 0.0012), (x, w, z), (x, 0, z - 0.0015)]
                for x, w, z in (
                    (0, 0.003, 0),
                    (0.008, 0.004, 0.0035),
                    (0.017, 0.0025, 0.003),
                    (0.023, 0.0003, 0.006),
                )
            ]
            leaves.append(loft(rings, mat=green).turn(rz=a).move(z=top))
        stalk = tube(
            [(0, 0, top - 0.002), (0, 0, top + 0.006), (0.003, 0.001, top + 0.012)],
            [0.0022, 0.002, 0.0024],
            5,
            mat=green,
        )
        return [mesh, *leaves, stalk]

    return aged("tomato", shape, 0.12)


def tomato_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.031, 0.04),
        "colour": pick(rng, ["c8281c", "d2331c", "b8201c"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "apple": Maker(
        with_forms(apple),
        apple_random,
        count=8,
        presets=[
            {"kind": "red"},
            {"kind": "green"},
            {"kind": "gala"},
            served(table.APPLE, "three", "red", 3),
            served(table.APPLE, "half", "green", 4),
            served(table.APPLE, "whole_half", "red", 5),
            served(table.APPLE, "three", "golden", 3),
            served(table.APPLE, "wedges", "red", 6),
        ],
    ),
    "orange": Maker(
        with_forms(orange),
        orange_random,
        count=8,
        presets=[
            {},
            {},
            served(table.ORANGE, "half", seed=3),
            served(table.ORANGE, "net", seed=4),
            served(table.ORANGE, "three", seed=5),
            served(table.ORANGE, "whole_half", seed=6),
            served(table.MANDARIN, "one", seed=7),
            served(table.ORANGE, "half", "blood", 3),
        ],
    ),
    "tomato": Maker(
        with_forms(tomato),
        tomato_random,
        count=8,
        presets=[
            {},
            {},
            served(table.TOMATO, "three", "red", 3),
            served(table.TOMATO, "half", "red", 4),
            served(table.ROMA, "pair", seed=5),
            {"vine": {"count": 6, "seed": 6}},
            served(table.TOMATO, "three", "yellow", 3),
            served(table.TOMATO, "whole_half", "red", 8),
        ],
    ),
}
