"""Strawberries and grapes; fresh, overripe and rotten."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import ellipsoid, tube

from makers.clusters import dull, fur, grapes_served, strawberries_served, strawberry
from makers.spoilage import age, aged


def served(make: Callable[..., Model], other: Callable[..., Model]) -> Callable[..., Model]:
    """`make`, or `other` where a preset says `serve`."""

    @functools.wraps(make)
    def maker(serve: dict | None = None, **parameters) -> Model:
        return other(**serve) if serve else make(**parameters)

    return maker


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

    def shape(look: str) -> list[Mesh]:
        out = []
        for (x, y, z), (a, tilt, spin) in zip(places, angles, strict=True):
            if x or y:  # tips outwards, more or less
                a = math.atan2(y, x) + math.pi + 0.3 * (a - math.pi)
            berry, star = strawberry(look, s, o, True)
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
        mats, out = [skin(look)] * 2, []
        if look == "rotten":
            mats = [dull(o, "6a4424"), fur(o)]
        k = {"fresh": 1.0, "overripe": 0.93, "rotten": 0.84}[look]
        for i, ((x, y, z), (a, b, c)) in enumerate(zip(places, jitter, strict=True)):
            furred = i in (4, 5, 7, 8, 12, 13, 16, 17)
            shrunk = k * (1 - 0.06 * (look == "overripe") * (a > 0))
            if look == "rotten" and furred:
                shrunk *= 1.1
            mat = mats[furred]
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
        served(strawberries, strawberries_served),
        strawberries_random,
        count=6,
        presets=[
            {"count": 6},
            {"count": 7},
            {"serve": {"form": "punnet", "seed": 3}},
            {"serve": {"form": "three", "size": 1.25, "seed": 4}},
            {"serve": {"form": "halves", "size": 1.25, "seed": 5}},
            {"serve": {"form": "one", "size": 1.4, "seed": 6}},
        ],
    ),
    "grapes": Maker(
        served(grapes, grapes_served),
        grapes_random,
        count=7,
        presets=[
            {"kind": "green"},
            {"kind": "blue"},
            {"serve": {"form": "long", "kind": "red", "seed": 3}},
            {"serve": {"form": "wide", "kind": "green", "seed": 4}},
            {"serve": {"form": "small", "kind": "blue", "seed": 5}},
            {"serve": {"form": "loose", "kind": "green", "seed": 6}},
            {"serve": {"form": "wide", "kind": "blue", "seed": 4}},
        ],
    ),
}
