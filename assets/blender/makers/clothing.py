"""Heaps of clothes."""

from __future__ import annotations

import cloth
import numpy as np
from labels import garments
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
)
from toolkit.sampling import noise_offset, seed_of, uniform

from makers.convex import few_corners

HEAPS: list[list[dict]] = [
    [
        {"kind": "trousers", "colour": "#3f5f94", "second": "#d8a24a"},
        {"kind": "shirt", "colour": "#efeae0", "second": "#c8303a", "style": "stripes"},
        {"kind": "shirt", "colour": "#c8453a", "second": "#f4f0e6", "style": "print"},
        {"kind": "sock", "colour": "#f2f2ee", "second": "#2f5fa8"},
    ],
    [
        {"kind": "towel", "colour": "#7fa8b8", "second": "#f4f4f0"},
        {"kind": "trousers", "colour": "#34363e", "second": "#7a7e88"},
        {"kind": "shirt", "colour": "#f2c53a", "second": "#2f4f8a", "style": "print"},
        {"kind": "sock", "colour": "#c8303a", "second": "#f2f2ee"},
    ],
    [
        {"kind": "shirt", "colour": "#f2f0ea", "second": "#2f4f8a", "style": "stripes"},
        {"kind": "shirt", "colour": "#7fb0d0", "second": "#f4f4f0", "style": "buttons"},
        {"kind": "trousers", "colour": "#4a6aa0", "second": "#e0b060"},
        {"kind": "sock", "colour": "#3a3a44", "second": "#e8862c"},
    ],
]


def _outside(garment: dict, rng: np.random.Generator) -> Material:
    """The garment's drawing with a little mottling."""
    kind, colour, second = garment["kind"], garment["colour"], garment["second"]
    if kind == "shirt":
        picture = garments.shirt(colour, second, garment.get("style", "plain"))
    else:
        draw = {"trousers": garments.trousers, "sock": garments.sock, "towel": garments.towel}
        picture = draw[kind](colour, second)
    m = Material()
    creases = m.noise(60, 3, offset=noise_offset(rng))
    dark = m.mix(0.25, m.image(picture), "#000000")
    return m.colour(m.mix(m.remap(creases, 0.35, 0.65, 0.45, 0), m.image(picture), dark))


def clothes_pile(things: list[dict], spread: float, size: float, seed: int) -> Model:
    """A heap of garments dropped on the floor one after the other (see cloth.py)."""
    rng = np.random.default_rng(seed)
    outlines = {
        "shirt": cloth.SHIRT,
        "trousers": cloth.TROUSERS,
        "towel": cloth.TOWEL,
        "sock": cloth.SOCK,
    }
    sheets = []
    for k, g in enumerate(things):
        spacing = 0.062 if g["kind"] != "sock" else 0.05
        sheets.append(
            cloth.throw(
                outlines[g["kind"]],
                spacing,
                0.1 + 0.14 * k,
                g.get("crumple", 0.5),
                rng,
                0.6 * spread,
            )
        )
    settled = cloth.settle(sheets, 0.05, spread)
    meshes = []
    for g, sheet, points in zip(things, sheets, settled, strict=True):
        points = points * size
        outside = _outside(g, rng)
        inside = plain(shade(g["colour"], 0.8), 0.06, 60)
        meshes += _two_sided(points, sheet, outside, inside, 0.004)
    everything = np.concatenate([m.v for m in meshes])
    pieces = _heap_pieces(everything)
    names = {"shirt": "shirts", "trousers": "trousers"}
    title = (
        "heap of clothes ("
        + ", ".join(sorted({names.get(g["kind"], g["kind"]) for g in things}))
        + ")"
    )
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass=1.5, friction=0.9)


def clothes_pile_random(rng: np.random.Generator) -> dict:
    return {
        "things": HEAPS[0],
        "spread": 0.22,
        "size": uniform(rng, 0.66, 0.72),
        "seed": seed_of(rng),
    }


def _two_sided(
    points: np.ndarray, sheet: cloth.Sheet, outside: Material, inside: Material, half: float
) -> list[Mesh]:
    """The drawn side of a cloth, and its inner side with the rim (unseen faces go later)."""
    triangles = sheet.triangles
    normal = np.zeros_like(points)
    corner = points[triangles]
    flat = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    for k in range(3):
        np.add.at(normal, triangles[:, k], flat)
    normal /= np.linalg.norm(normal, axis=1)[:, None] + 1e-9
    edges = {edge for a, b, c in triangles.tolist() for edge in ((a, b), (b, c), (c, a))}
    rim = sorted(edge for edge in edges if edge[::-1] not in edges)
    n = len(points)
    vertices = np.r_[points + normal * half, points - normal * half]
    low, high = sheet.rest.min(0), sheet.rest.max(0)
    drawn = (sheet.rest - low) / (high - low)
    front = triangles.tolist()
    upper = Mesh(
        vertices,
        front,
        materials=[outside],
        label_uv=[[tuple(drawn[i]) for i in face] for face in front],
        bake_uv=[[tuple(sheet.rest[i]) for i in face] for face in front],
    )
    back = [[i + n for i in face[::-1]] for face in front]
    band = [(b, a, a + n, b + n) for a, b in rim]
    mirrored = np.r_[sheet.rest, sheet.rest] * [-1, 1]
    lower = Mesh(
        vertices,
        back + band,
        materials=[inside],
        bake_uv=[[tuple(mirrored[i]) for i in face] for face in back]
        + [[(3 + mirrored[i][0], mirrored[i][1] + 0.01 * (i >= n)) for i in face] for face in band],
        weight=0.35,
    )
    return [upper, lower]


def _heap_pieces(points: np.ndarray) -> list[np.ndarray]:
    """Low convex pieces: the heap cut into four quarters about its middle."""
    middle = np.median(points[:, :2], 0)
    pieces = []
    for sx in (-1, 1):
        for sy in (-1, 1):
            quarter = points[
                ((points[:, 0] - middle[0]) * sx > -0.02)
                & ((points[:, 1] - middle[1]) * sy > -0.02)
            ]
            if len(quarter) > 8:
                floor = quarter * [1, 1, 0] + [0, 0, 0.0]
                pieces.append(np.r_[few_corners(quarter, 22), few_corners(floor, 10)])
    return pieces


MODELS = {
    "clothes_pile": Maker(
        clothes_pile, clothes_pile_random, 3, [{"things": heap} for heap in HEAPS]
    ),
}
