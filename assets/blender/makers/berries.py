"""Strawberries and grapes; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import ellipsoid, lathe, tube

from makers.spoilage import age, aged


def strawberries(count=6, size=1.0, seed=0) -> Model:
    """A loose heap: most on the table, the last one or two on top."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.0165 * s
    base = count - 1
    places = [(0.0, 0.0, 0.0)] if base > 5 else []
    around = base - len(places)
    ring = r * (2.0 if base > 5 else 1.75)
    places += [
        (ring * math.cos(a), ring * math.sin(a), 0.0)
        for a in (math.tau * i / around + 0.3 for i in range(around))
    ]
    heap = [(0.0, 0.0)]
    places += [(x, y, r * 1.35) for x, y in heap[: count - len(places)]]
    angles = rng.uniform(0, math.tau, (count, 3))
    spots = [(x + r * 0.4, y, z + r * 1.7) for x, y, z in places[::2]]
    spots += [(x, y - r * 0.5, z + r * 1.7, 0.6) for x, y, z in places[1::4]]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(60, 2, offset=o), 0.35, 0.65), "b8141c", "d8242a")
        c = m.mix(m.remap(m.voronoi(300, o), 0.1, 0.2, 0.9, 0), c, "f2c860")
        return m.colour(age(look, m, c, r * 1.5, spots, o, "38101a", 0.4))

    def shape(look: str) -> list[Mesh]:
        mat, out = skin(look), []
        leaf = plain({"fresh": "4a8f2a", "overripe": "8a7f34", "rotten": "4a3a1c"}[look], 0.2, 200)
        k = {"fresh": 1.0, "overripe": 0.95, "rotten": 0.86}[look]
        profile = [
            (0, -0.021),
            (0.0075, -0.017),
            (0.0135, -0.006),
            (0.0165, 0.006),
            (0.012, 0.014),
            (0, 0.015),
        ]
        for (x, y, z), (a, tilt, spin) in zip(places, angles, strict=True):
            if x or y:  # tips outwards, more or less
                a = math.atan2(y, x) + math.pi + 0.3 * (a - math.pi)
            berry = lathe([(q * s * k, w * s * k) for q, w in profile], 7, mat=mat, discs=False)
            star = lathe(
                [(0, 0.0125 * s), (0.0145 * s, 0.013 * s), (0, 0.0175 * s)],
                10,
                mat=leaf,
                rib=lambda k, i: 1 - 0.6 * (i % 2),
            )
            for mesh in (berry, star):
                mesh.turn(rz=spin).turn(ry=1.25 + 0.5 * math.sin(tilt)).turn(rz=a)
                mesh.move(x, y, z + r)
            low = min(berry.v[:, 2].min(), star.v[:, 2].min())
            if z == 0:
                berry.move(z=-low)
                star.move(z=-low)
            out += [berry, star]
        return out

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        points = np.concatenate([m.v for m in group])
        foot = points * [0.8, 0.8, 0.0]
        return [np.concatenate([points, foot])]

    return aged(f"heap of {count} strawberries", shape, 0.018 * count, solids)


def strawberries_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 1.0, 1.15), "seed": seed_of(rng)}


GRAPES = {"green": ("a8bf4a", "c4d46a", "eef4b8"), "blue": ("3a2348", "54305f", "9a86b8")}


def grapes(kind="green", size=1.0, seed=0) -> Model:
    """A bunch lying along y, its stalk to the right, tapering to the left."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.0135 * s
    low, mid, bloom = GRAPES[kind]
    places = []
    rows = ((-0.06, 1), (-0.037, 2), (-0.012, 3), (0.013, 3), (0.037, 2))
    for y, wide in rows:
        for j in range(wide):
            x = (j - (wide - 1) / 2) * r * 1.85
            places.append((x, y * s, r))
        for j in range(wide - 1):
            x = (j - (wide - 2) / 2) * r * 1.9
            places.append((x, (y + 0.01) * s, r * 2.4))
    jitter = rng.uniform(-0.12, 0.12, (len(places), 3)) * r
    spots = [
        (r * 1.6, -0.03 * s, r * 2.6),
        (-r * 1.2, 0.0, r * 3.2),
        (r * 0.9, 0.026 * s, r * 3.0),
        (-r * 0.4, -0.055 * s, r * 2.6, 0.7),
    ]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(60, 2, offset=o), 0.35, 0.65), low, mid)
        c = m.mix(m.remap(m.normal(2), 0.55, 1.0, 0, 0.55), c, bloom)
        if look == "overripe":
            c = m.mix(0.35, c, "7a4a24")
        return m.colour(age(look, m, c, r * 3.4, spots, o, shade("3b200e", 0.8), 0.45))

    def shape(look: str) -> list[Mesh]:
        mat, out = skin(look), []
        k = {"fresh": 1.0, "overripe": 0.93, "rotten": 0.82}[look]
        for (x, y, z), (a, b, c) in zip(places, jitter, strict=True):
            shrunk = k * (1 - (0.16 if look == "rotten" else 0.06 * (look == "overripe")) * (a > 0))
            berry = ellipsoid((r * shrunk, r * 1.12 * shrunk, r * shrunk), n=6, m=4, mat=mat)
            berry.keep_faces(range(6, len(berry.f)))  # nobody sees it from below
            out.append(berry.turn(rz=b * 200).move(x + a, y + b, r * k + (z - r) * k + c * 0.3))
        # a dark heart so that no gap shows through
        dark = blend(low, "201408", 0.9 if look == "rotten" else 0.5)
        heart = ellipsoid(
            (r * 1.7, 0.045 * s, r * 1.0), (0, -0.006 * s, r * 1.1), 7, 4, plain(dark, 0)
        )
        wood = plain("7a6a34" if look == "fresh" else "5a3f1c", 0.2, 300)
        stalk = tube(
            [(0, 0.03 * s, r * 2), (0.002, 0.055 * s, r * 2.4), (-0.004, 0.076 * s, r * 2.2)],
            [0.0022, 0.002, 0.003],
            5,
            mat=wood,
        )
        return [*out, heart, stalk]

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        points = np.concatenate([m.v for m in group[:-2]])
        out = []
        for part in (points[points[:, 1] < 0], points[points[:, 1] >= -0.01]):
            out.append(np.concatenate([part, part * [0.75, 1, 0]]))
        return out

    return aged(f"bunch of {kind} grapes", shape, 0.3, solids)


def grapes_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 1.0, 1.12), "seed": seed_of(rng)}


MODELS = {
    "strawberries": Maker(
        strawberries, strawberries_random, count=2, presets=[{"count": 6}, {"count": 7}]
    ),
    "grapes": Maker(grapes, grapes_random, count=2, presets=[{"kind": "green"}, {"kind": "blue"}]),
}
