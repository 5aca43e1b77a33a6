"""Potted plants; the pot may be broken, its soil spilled."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import ellipsoid, extrude, lathe, loft, spline, tube

from makers.breakage import BROKEN, broken, wall_seeds
from makers.convex import few_corners
from makers.decor import leaf
from makers.solids import rod

# (radius, height) of the pot's outline as shares of its radius and height
POTS = {
    "taper": [(0.72, 0), (0.76, 0.03), (0.97, 0.86), (1.06, 0.87), (1.06, 1.0)],
    "bowl": [(0.5, 0), (0.78, 0.12), (0.97, 0.5), (1.0, 0.85), (0.98, 1.0)],
    "straight": [(0.92, 0), (0.97, 0.03), (1.0, 0.5), (1.0, 1.0)],
    "belly": [(0.6, 0), (0.85, 0.15), (1.0, 0.5), (0.9, 0.85), (0.86, 1.0)],
}


def _green(a: str, b: str, scale: float = 14.0) -> Material:
    m = Material(occlusion=0.7)
    return m.colour(m.mix(m.remap(m.noise(scale, 3), 0.35, 0.65), a, b))


def _palm_like(kind: str, crown: float, seed: int) -> list[Mesh]:
    """Broad leaves on stems ("broad"), a "palm", or upright "blades" with pale edges."""
    rng = np.random.default_rng(seed)
    green, stem = _green("#2f6b33", "#5f9c48"), plain("#5f7a3c", 0.1, 40)
    if kind == "blades":
        green = Material(occlusion=0.7)
        bands = green.noise(9, 3, distortion=1.0, stretch=(0.4, 0.4, 4))
        green.colour(green.ramp(bands, [(0.4, "#1f4f2c"), (0.5, "#5f9a50"), (0.6, "#c8c860")]))
    out: list[Mesh] = []
    count = {"broad": 11, "palm": 7, "blades": 11}[kind]
    for k in range(count):
        a = 2.4 * k + rng.uniform(-0.25, 0.25)  # golden angle: leaves avoid one another
        lift = (k + 0.5) / count
        way = np.array([math.cos(a), math.sin(a), 1.0])
        if kind == "blades":
            blade = leaf(crown * rng.uniform(0.65, 1.0), 0.07, -0.05, green, 0.008)
            blade.keep_pattern().turn(ry=-(math.pi / 2 - 0.1 - 0.4 * rng.random())).turn(rz=a)
            out.append(blade.move(*(way * [0.055 * rng.random(), 0.055 * rng.random(), 0])))
            continue
        reach = 0.06 + 0.1 * (1 - lift)
        top = way * [reach, reach, crown * (0.25 + 0.6 * lift)]
        bend = way * [0.25 * reach, 0.25 * reach, crown * 0.5 * (0.25 + 0.6 * lift)]
        out.append(tube([(0, 0, 0), bend, top], [0.008, 0.006, 0.005], 5, mat=stem).weigh(0.5))
        if kind == "palm":
            for s in range(-2, 3):
                frond = leaf(crown * 0.42, 0.05, 0.45, green, sections=4)
                frond.turn(ry=-0.35 - 0.5 * lift).turn(rz=a + 0.42 * s)
                out.append(frond.move(*top).weigh(0.7))
        else:
            size = rng.uniform(0.85, 1.15)
            blade = leaf(0.3 * size, 0.16 * size, 0.55, green)
            out.append(blade.turn(ry=-0.25 - 0.7 * lift).turn(rz=a).move(*top))
    return out


def _cactus(size: float) -> list[Mesh]:
    """A ribbed column with two arms and a flower."""
    skin = Material(occlusion=0.8)
    dots = skin.voronoi(48 / size, randomness=0.3)
    tone = skin.mix(skin.remap(skin.noise(20, 2), 0.35, 0.65), "#2f7a3c", "#4f9a50")
    skin.colour(skin.mix(skin.remap(dots, 0.14, 0.2, 1, 0), tone, "#f4ecc0"))

    def column(radius: float, height: float) -> Mesh:
        profile = [(0, 0), (0.86, 0), (1.0, 0.2), (1.0, 0.7), (0.8, 0.92), (0, 1.0)]
        return lathe(
            [(radius * r, height * z) for r, z in profile],
            16,
            mat=skin,
            rib=lambda k, i: 1.0 if i % 2 else 0.82,
            discs=False,
        )

    out = [column(0.075, 0.5)]
    for q, z, tall in ((-1, 0.2, 0.2), (1, 0.14, 0.26)):
        elbow = [(0, q * 0.06, z), (0, q * 0.125, z + 0.005), (0, q * 0.145, z + 0.05)]
        out.append(tube(spline(elbow, 2), 0.036, 8, mat=skin))
        out.append(column(0.042, tall).move(0, q * 0.145, z + 0.03))
    bloom = lathe(
        [(0, 0), (0.03, 0.012), (0.04, 0.034), (0, 0.016)],
        10,
        mats=[plain("#f0407a", 0.05), plain("#f6d04a", 0)],
        mat_of_segment=[0, 0, 1],
        rib=lambda k, i: 1.0 if i % 2 else 0.7,
    )
    out.append(bloom.move(z=0.49))
    return [m.scale(size) for m in out]


def _monstera(size: float) -> list[Mesh]:
    """Large heart-shaped leaves with deep notches."""
    green, stem = _green("#1f5f33", "#3f8a48", 9), plain("#5f8a44", 0.1, 40)
    half = [(0.0, 0.03), (0.0, 0.1), (0.04, 0.17), (0.12, 0.19), (0.09, 0.06), (0.17, 0.18)]
    half += [(0.23, 0.15), (0.17, 0.05), (0.27, 0.13), (0.31, 0.09), (0.24, 0.035), (0.34, 0.05)]
    outline = half + [(0.38, 0.0)] + [(x, -y) for x, y in half[::-1]]
    out = []
    for k in range(7):
        a, lift = 2.4 * k, (k + 0.5) / 7
        tall, reach = 0.16 + 0.42 * lift, 0.24 - 0.14 * lift
        top = (reach * math.cos(a), reach * math.sin(a), tall)
        mid = (0.3 * top[0], 0.3 * top[1], 0.6 * tall)
        out.append(tube([(0, 0, 0), mid, top], [0.009, 0.008, 0.006], 5, mat=stem).weigh(0.5))
        blade = extrude([(x - 0.02, y) for x, y in outline], 0.006, green)
        blade.warp(lambda x, y, z: (x, y, z + 0.25 * abs(y) - 0.7 * x * x))
        out.append(
            blade.scale(0.8 + 0.15 * math.sin(5 * k))
            .turn(ry=0.25 - 0.35 * lift)
            .turn(rz=a)
            .move(*top)
        )
    return [m.scale(size) for m in out]


def _fern(size: float) -> list[Mesh]:
    """Many feathered fronds that hang over the rim."""
    green, out = _green("#3f8a3c", "#7ab85a", 18), []
    for k in range(13):
        a, inner = 2.4 * k, k / 13
        long = 0.4 - 0.12 * inner
        xs = np.linspace(0, 1, 9)
        wide = 0.075 * np.sin(math.pi * (0.12 + 0.86 * xs)) * np.where(np.arange(9) % 2, 1.0, 0.35)
        rings = [
            [(x * long, -w, 0), (x * long, 0, 0.006), (x * long, w, 0), (x * long, 0, -0.004)]
            for x, w in zip(xs, wide, strict=True)
        ]
        frond = cube_project(loft(rings, green))
        rise, drop = 0.9 + 1.0 * inner, 2.6 - 0.6 * inner
        frond.warp(
            lambda x, y, z, r=rise, d=drop: (x * 0.92, y, z + r * x - d * x * x - 0.3 * abs(y))
        )
        out.append(frond.turn(rz=a))
    return [m.scale(size) for m in out]


def _flower(petal: Material, heart: Material, r: float, n: int = 10) -> Mesh:
    """An open flower looking to +Z."""
    disc = [(0, -0.12 * r), (r, 0.1 * r), (0.32 * r, 0.1 * r), (0, 0.26 * r)]
    return lathe(
        disc,
        n,
        mats=[petal, heart],
        mat_of_segment=[0, 0, 1],
        rib=lambda k, i: 1.0 if i % 2 or k != 1 else 0.45,
    )


def _orchid(petal: str) -> list[Mesh]:
    """Two arching stems of flowers over strap leaves."""
    green, stem = _green("#2f6b3c", "#4f8a4c"), plain("#6a8a4a", 0.1, 60)
    paint, heart = plain(petal, 0.08, 100), plain("#c8207a", 0.05)
    out = []
    for k in range(5):
        blade = leaf(0.2, 0.07, 0.8, green, 0.006, 5)
        out.append(blade.turn(ry=-0.35).turn(rz=1.25 * k))
    for q, turn in ((1, 0.5), (-1, -0.7)):
        path = [
            (0, 0.01 * q, 0),
            (-0.01, 0.02 * q, 0.2),
            (0.03, 0.03 * q, 0.36),
            (0.14, 0.05 * q, 0.4),
        ]
        path.append((0.22, 0.07 * q, 0.34))
        line = spline(path, 2)
        out.append(tube(line, 0.0045, 5, mat=stem).turn(rz=turn).weigh(0.5))
        for k, i in enumerate((4, 5, 6, 7, 8)):
            bloom = _flower(paint, heart, 0.047 - 0.004 * k, 8)
            side = 0.02 * (-1) ** k
            bloom.turn(ry=1.15).turn(rz=0.4 * (-1) ** k)
            x, y, z = line[i]
            out.append(bloom.move(x + 0.015, y + side, z - 0.012).turn(rz=turn))
    return out


def _succulents() -> list[Mesh]:
    """Rosettes and a small round cactus in a bowl."""
    out = []
    for x, y, r, colour in (
        (0.03, -0.06, 0.062, "#7ab89a"),
        (-0.06, -0.01, 0.05, "#a87a9a"),
        (0.045, 0.065, 0.055, "#8ab05a"),
    ):
        m, tip = plain(colour, 0.1, 60), plain(shade(colour, 0.75), 0.1, 60)
        for k, (share, lean) in enumerate(((1.0, 0.16), (0.74, 0.42), (0.46, 0.7))):
            ring = [(0, 0), (0.35 * r, 0), (r * share, r * lean), (0.3 * r, r * 0.22), (0, r * 0.2)]
            layer = lathe(
                ring, 10, mat=m if k % 2 else tip, rib=lambda j, i: 1.0 if i % 2 or j != 2 else 0.6
            )
            out.append(layer.turn(rz=0.22 * k).move(x, y, 0.01 + 0.012 * k))
    skin = Material()
    dots = skin.voronoi(70, randomness=0.2)
    skin.colour(skin.mix(skin.remap(dots, 0.14, 0.2, 1, 0), "#3f8a44", "#f6f0d0"))
    out.append(ellipsoid((0.04, 0.04, 0.05), (-0.055, 0.085, 0.04), 9, 6, skin))
    out.append(ellipsoid((0.014, 0.014, 0.01), (-0.055, 0.085, 0.09), 8, 5, plain("#e83a5a", 0)))
    return out


def _blossoms(petal: str) -> list[Mesh]:
    """A bushy flowering plant: round leaves and bright flowers."""
    green, stem = _green("#3f8a3c", "#5fa84a", 20), plain("#5f8a44", 0.1, 40)
    paint, heart = plain(petal, 0.06, 120), plain("#f6c82a", 0.05)
    out = []
    for k in range(11):
        a, lift = 2.4 * k, (k + 0.5) / 11
        reach, tall = 0.15 * (1 - 0.75 * lift), 0.05 + 0.1 * lift
        blade = leaf(0.12, 0.1, 0.6, green, 0.006, 4).turn(ry=-0.3 - 0.3 * lift).turn(rz=a)
        out.append(blade.move(0.4 * reach * math.cos(a), 0.4 * reach * math.sin(a), tall * 0.6))
    for k in range(9):
        a, r = 2.4 * k + 1.0, 0.13 * math.sqrt(k / 9)
        top = (r * math.cos(a), r * math.sin(a), 0.23 - 0.5 * r)
        out.append(rod((0.3 * top[0], 0.3 * top[1], 0), top, 0.004, stem, 4))
        bloom = _flower(paint, heart, 0.043, 8)
        out.append(bloom.turn(ry=3.0 * r).turn(rz=a).move(*top))
    return out


def _heap(radius: float, soil: Material) -> Mesh:
    """Spilled soil."""
    profile = [(0, 0), (1.0, 0), (0.8, 0.09), (0.45, 0.2), (0, 0.26)]
    heap = lathe(
        [(radius * r, radius * z) for r, z in profile],
        14,
        mat=soil,
        rib=lambda k, i: 1 + 0.16 * math.sin(2.3 * i + k),
    )
    return heap


def plant_pot(
    kind: str, pot: str, shape: str, radius: float, tall: float, size: float, petal: str, seed: int
) -> Model:
    """A potted plant; variant `broken`: shards, spilled soil and the plant lying in it."""
    plants = {
        "cactus": lambda: _cactus(size),
        "monstera": lambda: _monstera(size),
        "fern": lambda: _fern(size),
        "orchid": lambda: [m.scale(size) for m in _orchid(petal)],
        "succulents": lambda: [m.scale(size) for m in _succulents()],
        "flowers": lambda: [m.scale(size) for m in _blossoms(petal)],
    }
    plant = plants[kind]() if kind in plants else _palm_like(kind, size, seed)
    clay, soil = plain(pot, 0.06, 25), plain("#3f2d20", 0.3, 90)
    outer = [(radius * r, tall * z) for r, z in POTS[shape]]
    rim, wall = outer[-1][0], max(0.006, 0.07 * radius)
    inner = [(rim - wall, tall), (rim - wall * 1.2, tall * 0.88)]
    vessel = lathe(
        [(0, 0), *outer, *inner, (0, tall * 0.9)],
        18,
        mats=[clay, soil],
        mat_of_segment=[0] * (len(outer) + 2) + [1],
    )
    for mesh in plant:
        mesh.keep_pattern().move(z=tall * 0.88)
    points = np.concatenate([m.v for m in plant])
    hollow = [(max(r - wall, 0.3 * r), max(z, wall)) for r, z in outer[::-1]]
    shell = lathe([(0, 0), *outer, *hollow, (0, wall)], 12, mat=clay)
    seeds = wall_seeds(radius, tall, 5, np.random.default_rng(seed))
    shards = broken(
        [shell],
        plain("#d8b89a", 0.1, 200),
        seeds,
        (0.3 * radius) ** 2,
        seed,
        edge=max(0.06, 0.65 * radius),
    )
    fallen = [m.copy() for m in plant]
    leafy = kind in ("broad", "palm", "monstera", "fern", "flowers")
    away = 0.6 + math.pi * leafy  # leaves fall back, so as not to hide the shards
    for mesh in fallen:
        mesh.move(z=-tall * 0.88).turn(ry=math.pi / 2 - 0.12).turn(rz=away)
    lying = np.concatenate([m.v for m in fallen])
    low = float(lying[:, 2].min())
    for mesh in fallen:
        mesh.v = (mesh.v - [0, 0, low]) * [1, 1, 0.55]
        push = -0.35 if leafy else 0.35
        mesh.move(push * radius, 0.7 * push * radius, 0.02)
    spilled = [_heap(1.15 * radius, soil).move(0.5 * radius, 0.3 * radius, 0), *fallen]
    foot, widest = outer[0][0], max(r for r, _ in outer)
    pieces = [cylinder_piece(foot, 0, tall, 12, widest)]
    if shape == "bowl":
        low = outer[2][1]
        pieces = [cylinder_piece(foot, 0, low, 12, outer[2][0])]
        pieces.append(cylinder_piece(outer[2][0], low, tall, 12, widest))
    pieces.append(few_corners(points, 30))
    return Model(
        f"potted plant, {kind}",
        {
            "body": Part([vessel, *plant], collision=pieces),
            "shards": shards,
            "spilled": Part(spilled, collision="none"),
        },
        mass=min(18.0, round(1400 * radius**2 * tall * 2, 1)),
        ground_shadow=True,
        prune=False,
        variants={"default": ["body"], "broken": ["shards", "spilled"]},
        states=BROKEN,
    )


def plant_pot_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "broad",
        "pot": pick(rng, ["#b5623f", "#e4e1da", "#4d5b63"]),
        "shape": "taper",
        "radius": 0.14,
        "tall": 0.26,
        "size": 0.7,
        "petal": "#d8202c",
        "seed": 4,
    }


MODELS = {
    "plant_pot": Maker(
        plant_pot,
        plant_pot_random,
        9,
        [
            {"kind": "broad", "pot": "#e4e1da", "shape": "straight"},
            {"kind": "blades", "pot": "#b5623f", "size": 0.62},
            {"kind": "palm", "pot": "#4d5b63", "shape": "belly", "size": 0.9},
            {"kind": "cactus", "pot": "#b5623f", "radius": 0.13, "tall": 0.2, "size": 0.9},
            {"kind": "monstera", "pot": "#f2f0ea", "shape": "belly", "radius": 0.15, "size": 0.85},
            {
                "kind": "orchid",
                "pot": "#e8dcc8",
                "shape": "straight",
                "radius": 0.09,
                "tall": 0.16,
                "size": 1.22,
                "petal": "#f6f0f4",
            },
            {
                "kind": "fern",
                "pot": "#2f5f6a",
                "shape": "bowl",
                "radius": 0.165,
                "tall": 0.23,
                "size": 0.95,
            },
            {
                "kind": "flowers",
                "pot": "#b5623f",
                "radius": 0.18,
                "tall": 0.26,
                "size": 1.75,
                "petal": "#d8202c",
            },
            {
                "kind": "succulents",
                "pot": "#e8e4da",
                "shape": "bowl",
                "radius": 0.31,
                "tall": 0.18,
                "size": 1.95,
            },
        ],
    ),
}
