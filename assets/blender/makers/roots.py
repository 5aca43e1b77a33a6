"""Potatoes and onions; fresh, overripe (sprouting) and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import ellipsoid, lathe, tube

from makers import table_roots as table
from makers.fruit import smooth_profile
from makers.produce_forms import served, with_forms
from makers.produce_kit import matured, patches
from makers.spoilage import age, aged, lying_pieces, wither

POTATOES = {"brown": ("a8824a", "c8a468", "6a4a24"), "red": ("8f3f42", "b05a58", "5a2428")}


def sprout(at, towards, length: float, colour: str, radius: float = 0.0028) -> Mesh:
    """A shoot growing from a point, bending up."""
    start, way = np.array(at, float), np.array(towards, float)
    way = way / np.linalg.norm(way)
    path = [
        start - way * 0.003,
        start + way * length * 0.5,
        start + way * length * 0.8 + np.array([0, 0, length * 0.35]),
    ]
    return tube(path, [radius, radius * 0.9, radius * 0.35], 5, mat=plain(colour, 0.15, 200))


def potato(size=1.0, kind="brown", seed=0) -> Model:
    """A lumpy potato lying along y."""
    rng = np.random.default_rng(seed)
    o, phase, s = noise_offset(rng), rng.uniform(0, 6.28, 4), size
    rx, ry, rz = 0.031 * s, 0.045 * s, 0.028 * s
    low, mid, dark = POTATOES[kind]
    r = rx * 1.15
    spots = [
        (rx * 0.7, ry * 0.2, rz * 1.6),
        (-rx * 0.6, -ry * 0.4, rz * 1.6, 0.85),
        (-rx * 0.2, ry * 0.7, rz * 1.6, 0.75),
    ]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(40, 4, offset=o), 0.35, 0.65), low, mid)
        c = m.mix(m.remap(m.noise(260, 3, offset=o), 0.56, 0.68, 0, 0.5), c, dark)
        eyes = m.voronoi(52, o)
        c = m.mix(m.remap(eyes, 0.1, 0.17, 0.85, 0), c, dark)
        if look == "overripe":  # greened and wrinkled
            green = m.noise(20, 2, offset=(o[1], 2, o[0]))
            c = m.mix(m.remap(green, 0.4, 0.6, 0.15, 0.75), c, "7f8a3a")
        return m.colour(age(look, m, c, r, spots, o, "1c140e", 0.5))

    def shape(look: str) -> list[Mesh]:
        mesh = ellipsoid((rx, ry, rz), (0, 0, 0), 14, 9, skin(look))

        def lumps(x, y, z):
            a, t = math.atan2(z, x), y / ry
            f = 1 + 0.07 * math.sin(2 * a + phase[0] + 2 * t) + 0.06 * math.sin(3 * t + phase[1])
            f += 0.03 * math.sin(5 * a + 4 * t + phase[2])
            return x * f, y * (1 + 0.04 * math.sin(3 * a + phase[3])), z * f + rz

        mesh.warp(lumps)
        wither(look, mesh, r, spots, 0.14)
        if look != "overripe":
            return [mesh]
        tone = "dfe4b4" if kind == "brown" else "e8c4d0"
        out = [mesh]
        middle = np.array([0, 0, rz])
        for k in (17, 45, 61, 83, 96):
            at = mesh.v[k]
            way = at - middle + [0, 0, 0.012]
            if at[2] > rz * 0.9:
                out.append(sprout(at, way, rng.uniform(0.016, 0.026) * s, tone))
        return out

    return aged("potato", shape, 0.16, lambda group: lying_pieces(group[0], 2))


def potato_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.9, 1.12), "seed": seed_of(rng)}


ONIONS = {"brown": ("b8742c", "d89a48", "7a4818"), "red": ("6a1c40", "8f3460", "3f0f28")}


def onion(size=1.0, kind="brown", seed=0) -> Model:
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.037 * s
    spots = patches(r, 0.034 * s, seed)
    low, mid, dark = ONIONS[kind]
    outline = [
        (0, 0.002),
        (0.008, 0.0),
        (0.024, 0.007),
        (0.035, 0.021),
        (0.037, 0.036),
        (0.031, 0.051),
        (0.018, 0.061),
        (0.007, 0.068),
        (0.0045, 0.077),
        (0.006, 0.085),
        (0, 0.084),
    ]

    def skin(look: str) -> Material:
        m = Material()
        lines = m.noise(1, 2, stretch=(190, 190, 6), offset=o)
        c = m.mix(m.remap(lines, 0.38, 0.62), low, mid)
        c = m.mix(
            m.remap(m.noise(1, 2, stretch=(330, 330, 8), offset=o), 0.6, 0.68, 0, 0.7), c, dark
        )
        light = m.noise(18, 2, offset=(o[1], o[2], 1))
        c = m.mix(m.remap(light, 0.55, 0.72, 0, 0.55), c, "f0c88a" if kind == "brown" else "c878a0")
        c = m.mix(m.remap(m.axis(2), 0.06 * s, 0.075 * s, 0, 0.75), c, "c8a468")
        c = m.mix(m.remap(m.axis(2), 0.002, 0.006 * s, 0.7, 0), c, "a89068")
        return m.colour(matured(look, m, c, r, spots, o, "2c1c10", 0.45))

    def shape(look: str) -> list[Mesh]:
        profile = smooth_profile([(q * s, z * s) for q, z in outline], 13)
        mesh = lathe(profile, 14, mat=skin(look), discs=False)
        mesh.warp(
            lambda x, y, z: (
                x * (1 + 0.02 * math.cos(3 * math.atan2(y, x))) + 0.5 * max(0, z - 0.06 * s) ** 1.2,
                y,
                z,
            )
        )
        wither(look, mesh, r, spots, 0.16)
        if look != "overripe":
            return [mesh]
        tip = mesh.v[mesh.v[:, 2].argmax()] - [0, 0, 0.006]
        shoots = []
        for lean, yaw, length in ((0.25, 0.4, 0.034), (0.5, 2.6, 0.028), (0.55, 4.6, 0.024)):
            way = (lean * math.cos(yaw), lean * math.sin(yaw), 1.0)
            shoots.append(sprout(tip, way, length * s, "5a9a2c", 0.0038))
        return [mesh, *shoots]

    return aged(f"{kind} onion", shape, 0.13)


def onion_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.9, 1.08), "seed": seed_of(rng)}


MODELS = {
    "potato": Maker(
        with_forms(potato),
        potato_random,
        count=7,
        presets=[
            {},
            {"kind": "red"},
            served(table.POTATO, "three", "brown", 3),
            served(table.POTATO, "five", "pale", 4),
            served(table.POTATO, "net", "brown", 5),
            served(table.POTATO, "whole_half", "brown", 6),
            served(table.POTATO, "three", "red", 3),
        ],
    ),
    "onion": Maker(
        with_forms(onion),
        onion_random,
        count=8,
        presets=[
            {},
            {"kind": "red"},
            served(table.ONION, "half", "red", 3),
            served(table.ONION, "three", "brown", 4),
            served(table.ONION, "net", "brown", 5),
            served(table.ONION, "whole_half", "brown", 6),
            served(table.ONION, "three", "red", 4),
            served(table.ONION, "pair", "white", 7),
        ],
    ),
}
