"""Pears, lemons, peaches, avocados; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import ellipsoid, lathe, loft, spline, tube

from makers import table_fruit as table
from makers.produce_forms import served, with_forms
from makers.spoilage import age, aged, lying_pieces, spots_around, wither


def smooth_profile(points, count: int) -> list[tuple[float, float]]:
    """A lathe profile through a few (radius, z) points, evenly spaced along the curve."""
    curve = spline(points, 8)
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))]
    at = np.linspace(0, along[-1], count)
    profile = [
        (max(0.0, float(np.interp(t, along, curve[:, 0]))), float(np.interp(t, along, curve[:, 1])))
        for t in at
    ]
    profile[0], profile[-1] = (0.0, profile[0][1]), (0.0, profile[-1][1])
    return profile


def stem(base, height: float, radius: float, colour="5a3a1c", lean: float = 0.003) -> Mesh:
    """A short woody stalk standing on `base`."""
    x, y, z = base
    path = [(x, y, z - 0.003), (x + lean * 0.3, y, z + height * 0.5), (x + lean, y, z + height)]
    return tube(path, [radius, radius * 0.85, radius * 1.3], 5, mat=plain(colour, 0.2, 300))


PEARS = {  # low, mid, blush
    "green": ("9fae3a", "c0c84c", "b8863a"),
    "yellow": ("d8b83a", "ecd45c", "c8742c"),
}


def pear(size=1.0, kind="green", seed=0) -> Model:
    rng = np.random.default_rng(seed)
    o, phase = noise_offset(rng), rng.uniform(0, 6.28, 2)
    s = size
    r = 0.036 * s
    spots = spots_around(r, 0.032 * s)
    outline = [
        (0, 0.005),
        (0.014, 0.0),
        (0.029, 0.011),
        (0.036, 0.031),
        (0.031, 0.052),
        (0.021, 0.07),
        (0.015, 0.084),
        (0.009, 0.093),
        (0, 0.092),
    ]

    def skin(look: str) -> Material:
        m = Material()
        low, mid, blush = PEARS[kind]
        c = m.mix(m.remap(m.noise(25, 3, offset=o), 0.35, 0.65), low, mid)
        c = m.mix(m.remap(m.noise(14, 2, offset=(o[1], 1, 0)), 0.52, 0.75, 0, 0.6), c, blush)
        c = m.mix(m.remap(m.voronoi(300, o), 0.08, 0.16, 0.6, 0), c, "7a6a2c")
        c = m.mix(m.remap(m.axis(2), 0.08 * s, 0.095 * s, 0, 0.7), c, "8f7a34")
        return m.colour(age(look, m, c, r, spots, o))

    def shape(look: str) -> list[Mesh]:
        profile = smooth_profile([(q * s, z * s) for q, z in outline], 12)
        mesh = lathe(profile, 14, mat=skin(look), discs=False)
        mesh.warp(
            lambda x, y, z: (
                x * (1 + 0.03 * math.cos(3 * math.atan2(y, x) + phase[0])) + 0.05 * z * (z / 0.09),
                y * (1 + 0.03 * math.cos(2 * math.atan2(y, x) + phase[1])),
                z,
            )
        )
        wither(look, mesh, r, spots, 0.15)
        top = mesh.v[mesh.v[:, 2].argmax()]
        return [mesh, stem((top[0] - 0.001, 0, top[2]), 0.02 * s, 0.0016, lean=0.006)]

    return aged(f"{kind} pear", shape, 0.18)


def pear_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.92, 1.1), "seed": seed_of(rng)}


def lemon(size=1.0, colour="f4d21c", seed=0) -> Model:
    """A lemon lying along y; its own axis is z until it is laid down (its upper side: +y)."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.028 * s
    spots = [
        (r * 0.6, r * 0.75, 0.004 * s),
        (-r * 0.7, r * 0.6, -0.02 * s, 0.8),
        (-r * 0.3, r * 0.8, 0.026 * s, 0.75),
    ]
    half = [
        (0.029, 0.0),
        (0.0265, 0.014),
        (0.018, 0.028),
        (0.009, 0.037),
        (0.006, 0.043),
        (0, 0.046),
    ]
    outline = [(q * s, -z * s) for q, z in half[:0:-1]] + [(q * s, z * s) for q, z in half]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(40, 3, offset=o), 0.3, 0.7), shade(colour, 0.93), colour)
        c = m.mix(m.remap(m.voronoi(380, o), 0.0, 0.35, 0.5, 0), c, shade(colour, 0.78))
        tips = m.remap(m.math("ABSOLUTE", m.axis(2)), 0.033 * s, 0.045 * s, 0, 0.7)
        c = m.mix(tips, c, "9aa83a")
        c = m.mix(m.remap(m.distance((0, r, 0.008)), 0, r * 0.5, 0.45, 0), c, "fff4b0")
        return m.colour(age(look, m, c, r * 1.1, spots, o, "4a3a1c", 0.4))

    def shape(look: str) -> list[Mesh]:
        mesh = lathe(smooth_profile(outline, 13), 14, mat=skin(look), discs=False)
        mesh.warp(lambda x, y, z: (x * (1 + 2 * z * z), y + 0.06 * z * z / 0.05, z))
        wither(look, mesh, r, spots, 0.14)
        return [mesh.keep_pattern().turn(rx=math.pi / 2)]

    return aged("lemon", shape, 0.12, lambda group: lying_pieces(group[0], 2))


def lemon_random(rng: np.random.Generator) -> dict:
    return {
        "size": uniform(rng, 0.95, 1.12),
        "colour": pick(rng, ["f4d21c", "f0da3a", "eec80e"]),
        "seed": seed_of(rng),
    }


def peach(radius=0.036, kind="peach", seed=0) -> Model:
    """A peach (velvety, yellow and red) or a nectarine (darker red)."""
    rng = np.random.default_rng(seed)
    o, r = noise_offset(rng), radius
    zc = r * 0.92
    spots = spots_around(r, zc)
    low, mid, blush = (
        ("f0a848", "f8c878", "d2483c") if kind == "peach" else ("e0802c", "ee9c3a", "a81c24")
    )

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(30, 3, offset=o), 0.35, 0.65), low, mid)
        red = m.noise(16, 3, offset=(o[1], o[2], 0))
        c = m.mix(m.remap(red, 0.4, 0.62, 0, 0.9), c, blush)
        fuzz = 0.25 if kind == "peach" else 0.0
        c = m.mix(m.remap(m.noise(420, 2, offset=o), 0.4, 0.7, 0, fuzz), c, "fbe6cc")
        c = m.mix(m.remap(m.distance((0, 0, zc + r * 0.8)), r * 0.1, r * 0.4, 0.7, 0), c, "9a7a2c")
        return m.colour(age(look, m, c, r, spots, o))

    def shape(look: str) -> list[Mesh]:
        profile = []
        for k in range(12):
            a = math.pi * k / 11
            dip = math.exp(-((math.sin(a) / 0.4) ** 2)) * (0.22 if k > 5 else -0.06)
            profile.append((math.sin(a) * r, (-math.cos(a) * 0.92 - dip) * r + zc))
        profile[0], profile[-1] = (0, profile[0][1]), (0, profile[-1][1])
        mesh = lathe(profile, 16, mat=skin(look), discs=False)

        def seam(x, y, z):
            a = math.remainder(math.atan2(y, x) - 0.39, math.tau)
            groove = 1 - 0.09 * math.exp(-((a / 0.22) ** 2)) * min(1, max(0, (z / r)))
            return x * groove, y * groove, z

        mesh.warp(seam)
        wither(look, mesh, r, spots, 0.15)
        top = mesh.v[-1]
        stalk = stem((0, 0, float(top[2])), 0.004, 0.0022, lean=0.001)
        return [mesh, stalk]

    return aged(kind, shape, 0.15)


def peach_random(rng: np.random.Generator) -> dict:
    return {"radius": uniform(rng, 0.033, 0.039), "seed": seed_of(rng)}


def avocado(size=1.0, cut=False, seed=0) -> Model:
    """An avocado lying along y; or half of one, cut face up, with its pit."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.034 * s
    spots = [
        (r * 0.65, r * 0.7, -0.012 * s),
        (-r * 0.7, r * 0.65, 0.004 * s, 0.8),
        (r * 0.1, r * 0.75, 0.032 * s, 0.7),
        (-r * 0.3, -r * 0.9, -0.014 * s),
        (r * 0.7, -r * 0.4, 0.012 * s, 0.8),
    ]
    if not cut:  # the blunt end, and beside it
        spots += [(-r * 0.1, r * 0.35, -0.044 * s), (-r * 0.85, r * 0.1, -0.026 * s, 0.8)]
    outline = [
        (0, -0.046),
        (0.017, -0.043),
        (0.031, -0.028),
        (0.034, -0.01),
        (0.029, 0.012),
        (0.021, 0.03),
        (0.014, 0.043),
        (0, 0.05),
    ]

    def skin(look: str) -> Material:
        m = Material()
        low, mid = ("243d16", "3d6422") if look == "fresh" else ("241a12", "3a2a1c")
        c = m.mix(m.remap(m.noise(45, 3, offset=o), 0.35, 0.65), low, mid)
        pebbles = m.voronoi(260, o)
        c = m.mix(m.remap(pebbles, 0.0, 0.4, 0.7, 0), c, blend(mid, "c8d88a", 0.45))
        return m.colour(age(look, m, c, r, spots, o, "1c120a", 0.25))

    def flesh(look: str) -> Material:
        m = Material(occlusion=0.8)
        # how far from the axis, as a share of the radius there
        c = m.mix(m.remap(m.noise(40, 2, offset=o), 0.35, 0.65), "e6e08a", "f0eaa0")
        rim = m.math("ADD", m.distance((0, 0, -0.004 * s), (1, 1, 0.62)), 0.0)
        c = m.mix(m.remap(rim, r * 0.55, r * 0.92), c, "a8c24a")
        face = [(x, 0.0, z, *k) for x, _, z, *k in spots]
        return m.colour(age(look, m, c, r, face, o, "2c1a0e", 0.6))

    def whole(look: str) -> list[Mesh]:
        profile = smooth_profile([(q * s, z * s) for q, z in outline], 12)
        mesh = lathe(profile, 14, mat=skin(look), discs=False)
        wither(look, mesh, r, spots, 0.14)
        nub = ellipsoid((0.004, 0.004, 0.003), (0, 0, 0.0505 * s), 6, 4, plain("5a3a1c", 0.2))
        return [part.keep_pattern().turn(rx=math.pi / 2) for part in (mesh, nub)]

    def half(look: str) -> list[Mesh]:
        profile = smooth_profile([(q * s, z * s) for q, z in outline], 11)
        profile[0], profile[-1] = (0.003, profile[0][1]), (0.003, profile[-1][1])
        n = 11
        rings = []
        for q, z in profile:
            angles = np.linspace(-math.pi, 0, n)  # the skin below, the cut face above (y = 0)
            ring = [(q * math.cos(a), q * math.sin(a), z) for a in angles]
            rings.append([*ring, (q * 0.45, 0, z), (-q * 0.45, 0, z)])
        mesh = loft(rings, mats=[skin(look), flesh(look)], mat_of_face=lambda k, i: int(i >= n - 1))
        mesh.bake_uv = None
        if look == "rotten":
            mesh.warp(lambda x, y, z: (x * 0.94, y * 0.9, z * 0.96))
        dark = {"fresh": "7a4a22", "overripe": "5a3416", "rotten": "38220f"}[look]
        pit = ellipsoid((0.015 * s,) * 3, (0, 0.003, -0.012 * s), 12, 7, plain(dark, 0.12, 90))
        return [part.keep_pattern().turn(rx=math.pi / 2) for part in (mesh, pit)]

    title = "half an avocado" if cut else "avocado"
    return aged(title, half if cut else whole, 0.1 if cut else 0.2, lambda g: lying_pieces(g[0], 3))


def avocado_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.95, 1.12), "seed": seed_of(rng)}


MODELS = {
    "pear": Maker(
        with_forms(pear),
        pear_random,
        count=7,
        presets=[
            {"kind": "green"},
            {"kind": "yellow"},
            served(table.PEAR, "lying", "green", 3),
            served(table.PEAR, "half", "yellow", 4),
            served(table.PEAR, "three", "green", 5),
            served(table.PEAR, "pair", "yellow", 6),
            served(table.PEAR, "lying", "red", 3),
        ],
    ),
    "lemon": Maker(
        with_forms(lemon),
        lemon_random,
        count=7,
        presets=[
            {},
            {},
            served(table.LEMON, "half", "yellow", 3),
            served(table.LEMON, "three", "yellow", 4),
            served(table.LEMON, "whole_half", "yellow", 5),
            served(table.LEMON, "net", "yellow", 6),
            served(table.LEMON, "slices", "yellow", 7),
        ],
    ),
    "peach": Maker(
        with_forms(peach),
        peach_random,
        count=7,
        presets=[
            {},
            {"kind": "nectarine"},
            served(table.PEACH, "half", "peach", 3),
            served(table.PEACH, "three", "peach", 4),
            served(table.PEACH, "one", "peach", 5),
            served(table.PEACH, "pair", "nectarine", 6),
            served(table.PEACH, "three", "white", 4),
        ],
    ),
    "avocado": Maker(
        with_forms(avocado),
        avocado_random,
        count=6,
        presets=[
            {},
            {"cut": True},
            served(table.AVOCADO, "pair", "dark", 3),
            served(table.AVOCADO, "upright", "dark", 4),
            served(table.AVOCADO, "halves", "green", 5),
            served(table.AVOCADO, "whole_half", "green", 6),
        ],
    ),
}
