"""Vases of flowers."""

from __future__ import annotations

import math

import numpy as np
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
    cylinder_piece,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    TAU,
    lathe,
    loft,
    tube,
)

from makers.breakage import BROKEN, wall_seeds
from makers.ware import squared


def _blossom(kind: str, radius: float, petal: str) -> list[Mesh]:
    """A flower looking up, its middle at the origin."""
    paint, heart = (
        plain(petal, 0.08, 150),
        plain("#f0b92c" if kind == "daisy" else shade(petal, 0.7), 0.1, 300),
    )
    if kind == "tulip":
        cup = [(0, -0.3), (0.5, -0.17), (0.56, 0.2), (0.43, 0.95), (0.3, 0.6), (0, 0.1)]
        bell = lathe(
            [(r * radius, z * radius) for r, z in cup],
            6,
            mat=paint,
            rib=lambda k, i: 1.12 - 0.24 * (i % 2) if k in (2, 3) else 1.0,
        )
        return [bell]
    if kind == "pampas":
        plume = [(0, -0.4), (0.42, 0.4), (0.5, 1.6), (0.36, 3.0), (0, 4.2)]
        return [lathe([(r * radius, z * radius) for r, z in plume], 6, mat=plain(petal, 0.25, 260))]
    if kind == "rose":
        bud = [(0, -0.35), (0.6, -0.2), (0.72, 0.08), (0.48, 0.36), (0.4, 0.2), (0, 0.34)]
        return [
            lathe(
                [(r * radius, z * radius) for r, z in bud],
                7,
                mat=paint,
                rib=lambda k, i: 1 + 0.12 * math.sin(2.4 * i + k),
            )
        ]
    disc = [(0, -0.12), (1.0, 0.06), (0.34, 0.08), (0, 0.26)]
    petals = lathe(
        [(r * radius, z * radius) for r, z in disc],
        14,
        mats=[paint, heart],
        mat_of_segment=[0, 0, 1],
        rib=lambda k, i: 1.0 if i % 2 or k != 1 else 0.55,
    )
    return [petals]


def _leaf(length: float, width: float, mat: Material) -> Mesh:
    """A long leaf rising along z from the origin and bending towards +X, 5 mm thick."""
    rings = []
    for t in np.linspace(0, 1, 5):
        w = width * math.sin(math.pi * min(1, 0.12 + 0.86 * t)) ** 0.8 / 2
        x, z = 0.35 * length * t**2.2, length * (t - 0.18 * t**3)
        rings.append([(x, -w, z), (x + 0.002, 0, z), (x, w, z), (x - 0.003, 0, z)])
    return loft(rings, mat=mat)


def _fallen(bunch: list[Mesh]) -> list[Mesh]:
    """The flowers lying on the floor among the shards, flattened by their weight."""
    lying = [mesh.copy().keep_pattern().turn(ry=math.pi / 2).turn(rz=0.7) for mesh in bunch]
    points = np.concatenate([mesh.v for mesh in lying])
    low, middle = points.min(0), points.mean(0)
    for mesh in lying:
        mesh.v = (mesh.v - [middle[0], middle[1], low[2]]) * [1, 1, 0.4]
        mesh.move(0.1, -0.12)  # clear of the foot, which stays standing
    return lying


def vase(
    shape: str,
    height: float,
    glaze: str,
    band: str,
    flower: str,
    petals: list[str],
    stems: int,
    seed: int,
    handles: bool = False,
) -> Model:
    """A vase with a bunch of flowers."""
    rng = np.random.default_rng(seed)
    s = height / 0.2
    profiles = {
        "belly": [
            (0.034, 0),
            (0.05, 0.02),
            (0.066, 0.07),
            (0.06, 0.115),
            (0.036, 0.155),
            (0.028, 0.175),
            (0.037, 0.2),
        ],
        "cylinder": [(0.036, 0), (0.04, 0.004), (0.041, 0.07), (0.042, 0.14), (0.044, 0.2)],
        "bottle": [
            (0.03, 0),
            (0.046, 0.012),
            (0.05, 0.05),
            (0.03, 0.1),
            (0.014, 0.135),
            (0.012, 0.185),
            (0.018, 0.2),
        ],
        "ball": [
            (0.03, 0),
            (0.056, 0.02),
            (0.072, 0.062),
            (0.064, 0.1),
            (0.036, 0.125),
            (0.034, 0.135),
        ],
        "amphora": [
            (0.026, 0),
            (0.03, 0.01),
            (0.06, 0.09),
            (0.066, 0.13),
            (0.044, 0.165),
            (0.026, 0.18),
            (0.034, 0.2),
        ],
        "square": [(0.036, 0), (0.038, 0.004), (0.041, 0.07), (0.044, 0.14), (0.047, 0.2)],
        "flare": [
            (0.032, 0),
            (0.036, 0.01),
            (0.03, 0.05),
            (0.034, 0.1),
            (0.045, 0.155),
            (0.058, 0.2),
        ],
    }
    wall = 0.005
    outer = [(r * s, z * s) for r, z in profiles[shape]]
    rim, low = outer[-1], outer[-2]
    inner = [
        (rim[0] - wall / 2, rim[1] + 0.002),
        (rim[0] - wall, rim[1]),
        (low[0] - wall, low[1]),
        (0, low[1]),
    ]
    clay = Material()
    base = clay.mottle(glaze, 0.06, 40, noise_offset(rng))
    wave = clay.math("SINE", clay.math("MULTIPLY", clay.axis(2), 150 / s))
    inside_band = clay.math(
        "MULTIPLY",
        clay.remap(clay.axis(2), 0.05 * s, 0.056 * s),
        clay.remap(clay.axis(2), 0.115 * s, 0.121 * s, 1, 0),
    )
    clay.colour(
        clay.mix(clay.math("MULTIPLY", inside_band, clay.remap(wave, 0.0, 0.25)), base, band)
    )
    pot = lathe(
        [(0, 0), *outer, *inner],
        15,
        mats=[clay, plain(shade(glaze, 0.5), 0.03)],
        mat_of_segment=[0] * (len(outer) + 2) + [1, 1],
    )
    green = plain("#4f8a3c", 0.12, 120)
    leaf_mat = plain("#5f9a44", 0.15, 80)
    bunch: list[Mesh] = []
    top = rim[1]
    for k in range(stems):
        a, spread = (
            TAU * (k * 0.618 % 1) + float(rng.normal(0, 0.2)),
            0.0 if k == 0 else float(rng.uniform(0.03, 0.075)) * s**0.5,
        )
        tall = top + float(rng.uniform(0.09, 0.15)) - 0.6 * spread
        tip = (spread * math.cos(a), spread * math.sin(a), tall)
        start = (rim[0] * 0.5 * math.cos(a), rim[0] * 0.5 * math.sin(a), top - 0.03)
        middle = np.array(start) * 0.4 + np.array(tip) * 0.6 - [0.25 * tip[0], 0.25 * tip[1], 0]
        bunch.append(tube([start, middle, tip], 0.003, 3, mat=green, weight=0.5))
        lean = 0.25 + 6.0 * spread if k else 0.15
        for mesh in _blossom(flower, float(rng.uniform(0.026, 0.033)), petals[k % len(petals)]):
            bunch.append(mesh.turn(ry=lean).turn(rz=a).move(*tip))
    for k in range(3 if stems > 1 and flower != "pampas" else min(stems, 1)):
        blade = _leaf(float(rng.uniform(0.1, 0.15)), 0.03, leaf_mat)
        bunch.append(
            blade.move(x=rim[0] * 0.3).turn(ry=0.25).turn(rz=1.9 * k + 0.6).move(z=top - 0.012)
        )
    if shape == "square":
        squared(pot, 0.92, 0.92, 7)
    ears = []
    if handles:
        for side in (-1, 1):
            z = np.array([0.09, 0.12, 0.165, 0.185, 0.182]) * s
            y = np.array([0.058, 0.078, 0.07, 0.045, 0.026]) * s * side
            ears.append(tube(np.c_[0 * z, y, z], 0.0055, 5, mat=clay, up=(1.0, 0, 0)))
    widest = max(r for r, _ in outer)
    pieces = [
        cylinder_piece(outer[0][0] + 0.006, 0, 0.03 * s, 12, widest),
        cylinder_piece(widest, 0.03 * s, 0.65 * top, 12),
        cylinder_piece(widest * 0.8, 0.65 * top, top, 12, rim[0]),
    ]
    if stems:
        pieces.append(
            cylinder_piece(min(rim[0], 0.04), top, top + 0.13, 8, 0.065 if stems > 1 else 0.02)
        )
    hollow = [(max(r - wall, 0.003), max(z, 0.008)) for r, z in outer[::-1]]
    shell = lathe([(0, 0), *outer, *hollow, (0, 0.008)], 9, mat=clay)
    if shape == "square":
        shell = squared(lathe([(0, 0), *outer, *hollow, (0, 0.008)], 8, mat=clay), 0.92, 0.92, 7)
    seeds = wall_seeds(widest, top, 4, np.random.default_rng(seed))
    raw = plain("e9ddc8", 0.1, 300)
    broken_ears = [m.copy() for m in ears]
    weights = [(0.6 * widest) ** 2] + [0.0] * 4
    shards = fracture([shell, *broken_ears], seeds, raw, weights, seed, 0.003, 0.14)
    fallen = scatter(shards, np.random.default_rng(seed))
    parts = {
        "body": Part([pot, *ears, *bunch], collision=pieces),
        "shards": Part(shards, collision=fallen),
    }
    if stems:  # some of the flowers lie among the shards
        heads = [m for m in bunch[: 2 * stems] if len(m.f)]
        parts["spilled"] = Part(_fallen(heads[:4]), collision="none")
    return Model(
        "vase of flowers" if stems > 1 else "vase with a flower" if stems else "empty vase",
        parts,
        mass=0.9,
        variants={"default": ["body"], "broken": [n for n in parts if n != "body"]},
        states=BROKEN,
        texture_size=128 if not stems else 256,
        prune=False,  # the inside of an empty vase is seen from straight above only
    )


def vase_random(rng: np.random.Generator) -> dict:
    return {
        "shape": "belly",
        "height": uniform(rng, 0.18, 0.24),
        "glaze": pick(rng, ["#3a6a9c", "#e9e2d2", "#2f7f78", "#b85a3a"]),
        "band": "#f2ead6",
        "flower": pick(rng, ["tulip", "rose", "daisy"]),
        "petals": ["#d8303a", "#f2c52a"],
        "stems": 6,
        "seed": seed_of(rng),
    }


MODELS = {
    "vase": Maker(
        vase,
        vase_random,
        8,
        [
            {
                "flower": "tulip",
                "petals": ["#d8303a", "#f2b92c"],
                "glaze": "#e9e2d2",
                "band": "#3a6a9c",
            },
            {"shape": "cylinder", "flower": "daisy", "petals": ["#f8f6ee"], "glaze": "#2f7f78"},
            {
                "shape": "flare",
                "flower": "rose",
                "petals": ["#d8486a", "#f3b7c0"],
                "glaze": "#3a4f78",
            },
            {"shape": "bottle", "flower": "rose", "petals": ["#c81e34"], "stems": 1}
            | {"height": 0.24, "glaze": "#5a8f86"},
            {"shape": "ball", "flower": "daisy", "petals": ["#f2c52a", "#f8f6ee"], "height": 0.2}
            | {"glaze": "#e9e2d2", "band": "#e9e2d2"},
            {"shape": "amphora", "stems": 0, "handles": True, "height": 0.34, "glaze": "#b85a3a"}
            | {"band": "#2a2320"},
            {"shape": "square", "flower": "tulip", "petals": ["#8a4ab0", "#e88ab0"]}
            | {"height": 0.22, "glaze": "#3a3c42", "band": "#3a3c42"},
            {"shape": "bottle", "flower": "pampas", "petals": ["#e6d2a8", "#d8bc88"], "stems": 4}
            | {"height": 0.3, "glaze": "#efe9dc", "band": "#c8a878"},
        ],
    ),
}
