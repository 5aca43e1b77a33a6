"""Clothes drying racks, bare or hung with washing."""

from __future__ import annotations

import math

import numpy as np
from labels import garments
from toolkit.materials import Material, label, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, extrude, tube

from makers.soft_forms import bars, each_hull
from makers.towel_rails import hung_towel

_SHIRT = [
    (-0.2, -0.3),
    (0.2, -0.3),
    (0.2, 0.1),
    (0.3, -0.02),
    (0.37, 0.1),
    (0.22, 0.28),
    (0.08, 0.28),
]
_SHIRT += [(0.0, 0.22), (-0.08, 0.28), (-0.22, 0.28), (-0.37, 0.1), (-0.3, -0.02), (-0.2, 0.1)]
_LEGS = [
    (-0.18, -0.42),
    (-0.03, -0.42),
    (0.0, 0.12),
    (0.03, -0.42),
    (0.18, -0.42),
    (0.19, 0.42),
    (-0.19, 0.42),
]
_SOCK = [
    (-0.045, 0.17),
    (0.045, 0.17),
    (0.045, -0.05),
    (0.13, -0.08),
    (0.13, -0.16),
    (-0.045, -0.16),
]


def hung(kind: str, colour: str, second: str, at, style: str = "stripes") -> Mesh:
    """A flat garment hanging down, its middle top at `at`, seen from +X and -X."""
    outline = {"shirt": _SHIRT, "trousers": _LEGS, "sock": _SOCK}[kind]
    if kind == "shirt":
        picture = garments.shirt(colour, second, style)
    else:
        picture = (garments.trousers if kind == "trousers" else garments.sock)(colour, second)
    mat = label(picture)
    mesh = extrude(np.array(outline) * 0.86, 0.014, mat, plain(shade(colour, 0.8), 0.05), axis="x")
    top = float(mesh.v[:, 2].max())
    return mesh.move(at[0], at[1], at[2] - top)


def _washing(lines: list[tuple[float, float, float]], rng: np.random.Generator) -> list[Mesh]:
    """Washing on rods along y at (x, z), each `width` long, from the front row backwards."""
    meshes = []
    for k, (x, z, width) in enumerate(lines):
        if k % 3 == 0:
            shirt = hung("shirt", "#f0ece0", "#c8303a", (x, -width * 0.2, z + 0.006))
            meshes += [shirt, hung("sock", "#3a3a44", "#e8862c", (x, width * 0.28, z + 0.004))]
            meshes.append(hung("sock", "#3a3a44", "#e8862c", (x, width * 0.42, z + 0.004)))
        elif k % 3 == 1:
            m = Material()
            m.colour(m.mottle("#7fb0d0", 0.08, 120, noise_offset(rng)))
            meshes.append(hung_towel(x, -width * 0.15, width * 0.5, z, 0.34, 0.3, m))
        else:
            meshes.append(hung("trousers", "#4a6aa0", "#e0b060", (x, width * 0.12, z + 0.006)))
    return meshes


def winged(colour: str, washing: bool, rng: np.random.Generator) -> tuple[list[Mesh], list, float]:
    """The common folding rack: crossed legs, a flat bed of rods, two raised wings."""
    wire, cap = (
        metal("e0e2e4", "a0a6aa") if colour == "steel" else plain(colour, 0.03),
        plain("#3f7fb0", 0.03),
    )
    w, d, h = 0.54, 0.58, 0.9
    meshes = []
    for y in (-w / 2, w / 2):
        meshes += bars(
            [[(-0.3, y, 0.01), (d / 2, y, h)], [(0.3, y, 0.01), (-d / 2, y, h)]], 0.01, wire, 5
        )
    for x in (-0.3, 0.3):
        meshes += bars([[(x, -w / 2 - 0.03, 0.012), (x, w / 2 + 0.03, 0.012)]], 0.011, wire, 5)
        for y in (-1, 1):
            meshes.append(box(0.034, 0.03, 0.03, (x, y * (w / 2 + 0.03), 0), cap, 0.006))
    rods = []
    for k in range(6):
        rods.append((-d / 2 + d * k / 5, h))
    for q in (-1, 1):
        tip = (q * (d / 2 + 0.3), h + 0.16)
        for y in (-w / 2, w / 2):
            meshes += bars([[(q * d / 2, y, h), (tip[0], y, tip[1])]], 0.009, wire, 5)
        for f in (0.35, 0.68, 1.0):
            rods.append((q * (d / 2 + 0.3 * f), h + 0.16 * f))
    for y in (-w / 2, w / 2):
        meshes += bars([[(-d / 2, y, h), (d / 2, y, h)]], 0.009, wire, 5)
    meshes += bars([[(x, -w / 2, z), (x, w / 2, z)] for x, z in rods], 0.0055, wire, 4)
    if washing:
        meshes += _washing(
            [
                (d / 2 + 0.3, h + 0.16, w),
                (d / 2 - 0.02, h, w),
                (-d / 10, h, w),
                (-d / 2 - 0.3, h + 0.16, w),
            ],
            rng,
        )
    pieces = [box_piece((0, 0, h), (d, w, 0.02)), box_piece((0, 0, 0.01), (0.64, w, 0.02))]
    for q in (-1, 1):
        pieces.append(
            np.array(
                [
                    (q * x, y, z)
                    for x, z in (
                        (d / 2, h - 0.01),
                        (d / 2, h + 0.01),
                        (d / 2 + 0.3, h + 0.15),
                        (d / 2 + 0.3, h + 0.17),
                    )
                    for y in (-w / 2, w / 2)
                ]
            )
        )
    for y in (-w / 2, w / 2):
        pieces.append(box_piece((0, y, h / 2), (0.12, 0.03, h)))
    return meshes, pieces, 3.2


def tower(colour: str, washing: bool, rng: np.random.Generator) -> tuple[list[Mesh], list, float]:
    """A tall narrow rack with three tiers on castors."""
    wire, cap = plain(colour, 0.03), plain("#2a2b2e", 0.04)
    w, d, h = 0.6, 0.5, 1.32
    meshes = []
    for x in (-0.03, 0.03):
        for y in (-w / 2, w / 2):
            meshes += bars([[(x, y, 0.04), (x, y, h)]], 0.011, wire, 4)
    for y in (-w / 2, w / 2):
        meshes += bars([[(-d / 2, y, 0.05), (d / 2, y, 0.05)]], 0.012, wire, 4)
        for q in (-1, 1):
            meshes.append(box(0.035, 0.026, 0.05, (q * d / 2, y, 0), cap, 0.01))
    tiers = (0.42, 0.82, 1.22)
    for z in tiers:
        for q in (-1, 1):
            for y in (-w / 2, w / 2):
                meshes += bars([[(q * 0.03, y, z), (q * d / 2, y, z + 0.02)]], 0.008, wire, 4)
            rods = [0.13, d / 2]
            meshes += bars(
                [
                    [(q * x, -w / 2, z + 0.02 * x / d * 2), (q * x, w / 2, z + 0.02 * x / d * 2)]
                    for x in rods
                ],
                0.0055,
                wire,
                4,
            )
    meshes += bars([[(0, -w / 2, h), (0, w / 2, h)]], 0.012, wire, 5)
    if washing:
        lines = [(d / 2, 1.24, w)]
        m = Material()
        m.colour(m.mottle("#e0b84a", 0.08, 120, noise_offset(rng)))
        meshes += [m_.scale(1, 0.92, 1) for m_ in _washing(lines, rng)]
        meshes.append(hung_towel(d / 2, 0.02, w * 0.6, 0.84, 0.3, 0.2, m))
        blue = Material()
        blue.colour(blue.mottle("#5a9a8a", 0.08, 120, noise_offset(rng)))
        meshes.append(hung_towel(d / 2, -0.05, w * 0.7, 0.44, 0.28, 0.2, blue))
    pieces = [box_piece((0, 0, z + 0.01), (d, w, 0.03)) for z in tiers]
    pieces += [box_piece((0, y, h / 2), (0.08, 0.03, h)) for y in (-w / 2, w / 2)]
    pieces += [box_piece((0, y, 0.025), (d, 0.03, 0.05)) for y in (-w / 2, w / 2)]
    return meshes, pieces, 4.5


def a_frame(colour: str, washing: bool, rng: np.random.Generator) -> tuple[list[Mesh], list, float]:
    """A wooden clothes horse: two ladders that lean together."""
    wood = plain(colour, 0.12, 24)
    w, h, foot = 0.66, 1.0, 0.3
    meshes = []
    lines = []
    for q in (-1, 1):
        for y in (-w / 2, w / 2):
            meshes += bars([[(q * foot, y, 0.0), (-q * 0.015, y, h)]], 0.013, wood, 5)
        for f in (0.22, 0.42, 0.62, 0.8, 0.97):
            x, z = q * (foot - (foot + 0.015) * f), h * f
            meshes += bars([[(x, -w / 2, z), (x, w / 2, z)]], 0.008, wood, 5)
            lines.append((x, z))
    if washing:
        m = Material()
        m.colour(m.mottle("#c86a5a", 0.08, 120, noise_offset(rng)))
        front = sorted(q for q in lines if q[0] > 0)
        meshes.append(hung_towel(front[0][0] + 0.004, -0.1, 0.36, front[0][1], 0.42, 0.3, m))
        x, z = front[-1]
        meshes.append(hung("sock", "#f0ece0", "#2f5fa8", (x + 0.012, 0.2, z)).scale(1, 1, 1))
        x, z = front[1]
        meshes.append(hung("sock", "#f0ece0", "#2f5fa8", (x + 0.012, 0.2, z)))
    pieces = []
    for q in (-1, 1):
        pieces.append(
            np.array(
                [
                    (q * x + e, y, z)
                    for x, z in ((foot, 0), (-0.015, h))
                    for y in (-w / 2 - 0.013, w / 2 + 0.013)
                    for e in (-0.013, 0.013)
                ]
            )
        )
    return meshes, pieces, 3.0


def table_rack(
    colour: str, washing: bool, rng: np.random.Generator
) -> tuple[list[Mesh], list, float]:
    """A low rack of an umbrella's kind: a post on three feet, arms that spread, cords between."""
    wire, cap = metal("e0e2e4", "a0a6aa"), plain(colour, 0.03)
    h, r, n = 1.25, 0.48, 4
    meshes = [tube([(0, 0, 0.16), (0, 0, h)], 0.016, 7, mat=wire)]
    for k in range(3):
        a = k * math.tau / 3 + 0.4
        meshes.append(
            tube(
                [(0.0, 0.0, 0.24), (0.34 * math.cos(a), 0.34 * math.sin(a), 0.012)],
                0.012,
                5,
                mat=wire,
            )
        )
        meshes.append(
            box(0.04, 0.04, 0.024, (0.34 * math.cos(a), 0.34 * math.sin(a), 0), cap, 0.006)
        )
    ends = []
    for k in range(n):
        a = k * math.tau / n + math.pi / 4
        tip = (r * math.cos(a), r * math.sin(a), h + 0.06)
        meshes.append(tube([(0, 0, h - 0.22), tip], 0.009, 5, mat=wire))
        ends.append(np.array(tip))
    for f in (0.4, 0.6, 0.8, 0.98):
        for k in range(n):
            a, b = (
                np.array([0, 0, h - 0.22]) * (1 - f) + e * f for e in (ends[k], ends[(k + 1) % n])
            )
            meshes.append(tube([a, b], 0.004, 3, mat=plain("#f0f0ee", 0), weight=0.5))
    meshes.append(box(0.06, 0.06, 0.06, (0, 0, h - 0.26), cap, 0.01))
    if washing:
        x = float(ends[0][0]) * 0.98
        z = h - 0.22 + 0.28 * 0.98
        meshes.append(
            hung("shirt", "#7fb0d0", "#f4f4f0", (x, -0.02, z), "buttons").scale(1, 0.95, 1)
        )
    pieces = [box_piece((0, 0, h / 2), (0.05, 0.05, h)), box_piece((0, 0, 0.05), (0.5, 0.5, 0.1))]
    pieces.append(
        np.array(
            [
                (q * s, p * s, z)
                for s, z in ((0.05, h - 0.24), (r * 0.7, h + 0.05))
                for q in (-1, 1)
                for p in (-1, 1)
            ]
        )
    )
    return meshes, pieces, 3.5


def drying_rack(kind: str, colour: str, washing: bool, seed: int) -> Model:
    """A clothes drying rack: "winged", "tower", "wood" or "umbrella"."""
    make = {"winged": winged, "tower": tower, "wood": a_frame, "umbrella": table_rack}
    meshes, pieces, mass = make[kind](colour, washing, np.random.default_rng(seed))
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for m in meshes:
        m.move(z=-low)
    pieces = [np.asarray(p) - [0, 0, low] for p in pieces] + each_hull(meshes, 0.28, 10)
    title = "drying rack" + (" with washing" if washing else "")
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass=mass)


def drying_rack_random(rng: np.random.Generator) -> dict:
    return {"kind": "winged", "colour": pick(rng, ["steel", "#f0f0ee"]), "washing": True, "seed": 3}


MODELS = {
    "drying_rack": Maker(
        drying_rack,
        drying_rack_random,
        6,
        [
            {"kind": "winged", "colour": "steel"},
            {"kind": "winged", "colour": "#f0f0ee", "washing": False},
            {"kind": "tower", "colour": "#c8ccd0"},
            {"kind": "wood", "colour": "#c9a06a"},
            {"kind": "umbrella", "colour": "#3f7fb0"},
            {"kind": "wood", "colour": "#c9a06a", "washing": False},
        ],
    ),
}
