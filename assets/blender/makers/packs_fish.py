"""Raw fish as the fishmonger sells it: fillets, cutlets, a whole side, smoked slices."""

from __future__ import annotations

import math

import numpy as np
from labels import foods
from toolkit import labels
from toolkit.materials import metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.shapes import TAU, loft, rounded_rectangle, superellipse, tube

from makers import chilled
from makers.pack_parts import by_style

SILVER = "9aa4ac"


def fish_tag(word: str, brand: str, band: str, size, at) -> Mesh:
    image, d = labels.canvas(300, 190, band)
    labels.text(d, brand, (60, 4, 240, 36), "italic", "#ffe9b0")
    labels.text(d, word, (8, 38, 292, 110), "bold", "#ffffff")
    foods.fish(d, 150, 150, 76, "#ffb48a" if word == "SALMON" else "#dfeaf2")
    return chilled.sticker(size, at, image)


def salmon_side(brand: str, band: str) -> Model:
    """A whole side with its skin on, on a golden board."""
    length, width = 0.4, 0.125
    flesh, skin = chilled.flesh_of("SALMON", (3, 1, 2)), plain(SILVER, 0.15, 120)
    board = loft(
        [
            np.c_[rounded_rectangle(width + 0.03, length + 0.03, 0.01, 3), np.full(12, z)]
            for z in (0, 0.005)
        ],
        mat=metal("d8b84a", "9a7a2c"),
    )
    rings = []
    for z, k in ((0.005, 0.97), (0.012, 1.0), (0.024, 0.9), (0.029, 0.6), (0.03, 0.2)):
        t = np.arange(24) * TAU / 24
        y = length / 2 * k * np.sin(t)
        half = width / 2 * k * (0.72 - 0.42 * y / (length / 2)) * np.cos(t) * 1.35
        rings.append(np.c_[half, y, z - (z - 0.005) * 0.4 * (0.5 + y / length)])
    side = loft(rings, mats=[flesh, skin], mat_of_face=lambda k, i: int(k == 0))
    side.bake_uv = None
    tag = fish_tag("SALMON", brand, band, (0.06, 0.09), (0.0, -0.08, 0.0265))
    solids = [
        box_piece((0, 0, 0.0025), (width + 0.03, length + 0.03, 0.005)),
        box_piece((0, -0.02, 0.016), (0.1, 0.33, 0.026)),
    ]
    return Model(
        "side of salmon on a board",
        {"body": Part([board, side, tag], collision=solids)},
        mass=0.95,
        friction=0.5,
    )


def cutlets(kind: str, dish: str, band: str, brand: str) -> Model:
    """Two horseshoe-shaped slices across the fish."""
    width, length = 0.17, 0.22
    flesh, skin = chilled.flesh_of(kind, (5, 2, 1)), plain(SILVER, 0.2, 120)
    bone = plain("#f6efe0", 0.05, 90)
    meshes = [chilled.tray(width, length, 0.022, plain(dish, 0.05, 200))]
    for s in (-1, 1):
        t = np.linspace(-2.35, 2.35, 17)
        outer = (
            np.c_[0.042 * np.cos(t), 0.045 * np.sin(t)] * (1 + 0.28 * (np.abs(t) > 1.9))[:, None]
        )
        t2 = t[::-1]
        inner = np.c_[
            -0.012 + 0.008 * np.cos(t2), 0.012 * np.sin(t2) * (1 + 1.0 * (np.abs(t2) > 1.9))
        ]
        shape = np.concatenate([outer, inner])
        rings = [np.c_[shape, np.full(len(shape), z)] for z in (0.006, 0.01, 0.026)]
        piece = loft(rings, mats=[skin, flesh], mat_of_face=lambda k, i: 0 if i < 16 else 1)
        piece.mi[-2:] = [1, 1]
        piece.bake_uv = None
        piece.keep_pattern()
        spine = tube([(-0.001, 0, 0.006), (-0.001, 0, 0.0275)], 0.0055, 7, mat=bone)
        for mesh in (piece, spine):
            meshes.append(mesh.turn(rz=math.pi / 2 * s + 0.2).move(0.0, s * 0.05))
    tag = fish_tag(kind, brand, band, (0.05, 0.07), (0.055, 0.0, 0.0205))
    solid = box_piece((0, 0, 0.014), (width - 0.006, length - 0.006, 0.028))
    return Model(
        f"{kind.lower()} steaks on a tray",
        {"body": Part([*meshes, tag], collision=[solid])},
        mass=0.45,
        friction=0.5,
    )


def smoked_pack(brand: str, band: str) -> Model:
    """A flat vacuum pack of smoked slices, lapping like tiles, on a silver board."""
    width, length = 0.13, 0.24
    flesh = chilled.flesh_of("SALMON", (7, 3, 4))
    board = loft(
        [np.c_[rounded_rectangle(width, length, 0.008, 3), np.full(12, z)] for z in (0, 0.005)],
        mat=metal("dfe3e6", "9aa2a8"),
    )
    meshes = [board]
    for k in range(5):
        rings = []
        for z, q in ((0, 1.0), (0.0045, 1.0), (0.006, 0.9)):
            ring = superellipse(0.052 * q, 0.036 * q, 2.6, 16, z)
            rings.append(ring)
        piece = loft(rings, mat=flesh)
        piece.bake_uv = None
        piece.keep_pattern()
        meshes.append(piece.turn(rx=-0.14).move(0.003 * (k % 2), 0.078 - 0.033 * k, 0.0095))
    tag = fish_tag("SALMON", brand, band, (0.11, 0.052), (0.0, -0.09, 0.0125))
    solid = box_piece((0, 0, 0.008), (width, length, 0.016))
    return Model(
        "pack of smoked salmon slices",
        {"body": Part([*meshes, tag], collision=[solid])},
        mass=0.2,
        friction=0.5,
    )


def loins(kind: str, dish: str, band: str, brand: str) -> Model:
    """Three thick loins side by side."""
    width, length = 0.19, 0.18
    flesh, skin = (
        chilled.flesh_of(kind, (2, 9, 4)),
        plain("b9b2a4" if kind == "COD" else SILVER, 0.15, 120),
    )
    meshes = [chilled.tray(width, length, 0.024, plain(dish, 0.05, 200))]
    for k in range(3):
        rings = []
        for z, q in ((0.005, 0.94), (0.014, 1.0), (0.032, 0.96), (0.04, 0.8), (0.042, 0.4)):
            rings.append(superellipse(0.023 * q, 0.064 * q, 4.0, 16, z))
        piece = loft(rings, mats=[flesh, skin], mat_of_face=lambda k, i: int(k == 0))
        piece.bake_uv = None
        piece.keep_pattern()
        meshes.append(piece.turn(rz=0.05 * (k - 1)).move((k - 1) * 0.05))
    tag = fish_tag(kind, brand, band, (0.06, 0.085), (0.0, 0.0, 0.0415))
    solids = [
        box_piece((0, 0, 0.011), (width - 0.006, length - 0.006, 0.022)),
        box_piece((0, 0, 0.02), (0.14, 0.12, 0.04)),
    ]
    return Model(
        f"{kind.lower()} loins on a tray",
        {"body": Part([*meshes, tag], collision=solids)},
        mass=0.5,
        friction=0.5,
    )


TRAY = {"length": 0.24, "width": 0.15}

MODELS = {
    "fish_fillet": Maker(
        by_style(
            "fish_fillet",
            {
                "tray": chilled.fish_fillet,
                "side": salmon_side,
                "cutlets": cutlets,
                "smoked": smoked_pack,
                "loins": loins,
            },
        ),
        chilled.fish_fillet_random,
        count=6,
        presets=[
            {"style": "tray", "kind": "SALMON", **TRAY},
            {"style": "tray", "kind": "COD", "dish": "#2f6fb8", "band": "#14508a", **TRAY},
            {"style": "side", "brand": "Nordhav", "band": "#0f4f8a"},
            {
                "style": "cutlets",
                "kind": "SALMON",
                "dish": "#f0efec",
                "band": "#0f4f8a",
                "brand": "Fjordal",
            },
            {"style": "smoked", "brand": "Nordhav", "band": "#1c2a4a"},
            {
                "style": "loins",
                "kind": "COD",
                "dish": "#1f2124",
                "band": "#14508a",
                "brand": "Marisol",
            },
        ],
    ),
}
