"""Bars of chocolate, wrapped, opened and in pieces."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from labels.drawing import shade
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.shapes import TAU, box, loft

from makers.pack_parts import by_style, carton_piece
from makers.projection import project_label


def cocoa(tone: str) -> Material:
    m = Material(occlusion=1.0)
    return m.colour(m.edge_highlight(m.mottle(tone, 0.08, 80), 0.0015, 0.3, shade(tone, 1.7)))


def tablet(
    rows: int, columns: int, pitch: float, mat: Material, thick: float = 0.0095
) -> list[Mesh]:
    """Squares on a slab, its first square at the back right."""
    meshes = [box(rows * pitch, columns * pitch, thick * 0.55, (0, 0, 0), mat, 0.0008)]
    for i in range(rows):
        for j in range(columns):
            x, y = (i - (rows - 1) / 2) * pitch, (j - (columns - 1) / 2) * pitch
            top = loft(
                [
                    np.array(
                        [(sx * k, sy * k, z) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                    )
                    for k, z in ((pitch * 0.47, thick * 0.5), (pitch * 0.36, thick))
                ],
                mat=mat,
            )
            top.smooth = False
            meshes.append(top.move(x, y))
    return meshes


def bar_face(w: int, h: int, ground: str, band: str, kind: str, brand: str):
    motif = groceries.white_chocolate if kind == "WHITE" else groceries.chocolate
    return groceries.face(w, h, ground, band, "CHOCOLATE", brand, motif, kind, "#ffe9b0")


def choc_wrapped(kind: str, ground: str, band: str, brand: str) -> Model:
    """A flat tablet in its paper."""
    depth, width, h = 0.078, 0.162, 0.011
    art = bar_face(440, 212, ground, band, kind, brand)
    body = box(depth, width, h, (0, 0, 0), plain(band, 0.04, 80), 0.002, 1, {"+z": label(art)})
    ends = [
        box(
            depth * 0.94,
            0.006,
            0.004,
            (0, s * (width / 2 + 0.002), h * 0.35),
            metal("d9c27a", "9a7c34"),
        )
        for s in (-1, 1)
    ]
    return Model(
        title=f"bar of {kind.lower()} chocolate",
        parts={"body": Part([body.weigh(1.3), *ends], collision=[carton_piece(depth, width, h)])},
        mass=0.1,
        friction=0.5,
    )


def choc_open(kind: str, tone: str, ground: str, band: str, brand: str) -> Model:
    """Half unwrapped: the foil is torn back and squares show, one broken off."""
    pitch, rows, columns = 0.0245, 3, 3
    mat = cocoa(tone)
    squares = [mesh.move(0, 0.04, 0.001) for mesh in tablet(rows, columns, pitch, mat)]
    depth, h = 0.079, 0.0125
    art = bar_face(330, 260, ground, band, kind, brand)
    sleeve = box(
        depth, 0.095, h, (0, -0.044, 0), plain(band, 0.04, 80), 0.002, 1, {"+z": label(art)}
    )
    foil = metal("dfe3e6", "9aa2a8", (6, 6, 1), 200)
    n = 12
    jag = [0.012 + 0.009 * (k % 2) + 0.004 * math.sin(k * 2.3) for k in range(n)]
    top = [
        (depth * 0.52 * (2 * k / (n - 1) - 1), 0.001 + jag[k], h + 0.002 + 0.003 * (k % 3))
        for k in range(n)
    ]
    low = [(depth * 0.5 * (2 * k / (n - 1) - 1), -0.004, h - 0.001) for k in range(n)]
    v = top + low + [(x, y, z - 0.003) for x, y, z in top + low]
    f = []
    for k in range(n - 1):
        f += [(n + k, n + k + 1, k + 1, k), (2 * n + k, 2 * n + k + 1, 3 * n + k + 1, 3 * n + k)]
        f += [(k, k + 1, 2 * n + k + 1, 2 * n + k)]
    torn = Mesh(v, f, None, [foil], smooth=False)
    loose = tablet(1, 2, pitch, mat)
    for mesh in loose:
        mesh.turn(rz=0.7).move(0.06, 0.075, 0)
    solids = [
        box_piece((0, -0.005, h / 2), (depth, 0.17, h)),
        box_piece((0.06, 0.075, 0.005), (0.04, 0.04, 0.01)),
    ]
    return Model(
        title=f"opened bar of {kind.lower()} chocolate",
        parts={"body": Part([*squares, sleeve.weigh(1.3), torn, *loose], collision=solids)},
        mass=0.08,
        friction=0.5,
    )


def choc_snack(kind: str, ground: str, band: str, brand: str) -> Model:
    """A single bar in a flow wrap with crimped ends, standing out round."""
    n, length, r = 14, 0.125, 0.016
    t = np.arange(n) * TAU / n
    steps = [
        (-0.5, 1.15, 0.12),
        (-0.42, 1.15, 0.14),
        (-0.37, 1.0, 0.9),
        (0, 1.0, 1.0),
        (0.37, 1.0, 0.9),
        (0.42, 1.15, 0.14),
        (0.5, 1.15, 0.12),
    ]
    rings = [
        np.c_[r * w * np.cos(t), np.full(n, y * length), 0.0125 + 0.0125 * d * np.sin(t)]
        for y, w, d in steps
    ]
    bar = loft(rings, mat=plain(band, 0.05, 90))
    bar.bake_uv = None
    art, d = labels.canvas(420, 130, band)
    d.rectangle((0, 0, 420, 12), fill=ground)
    d.rectangle((0, 118, 420, 130), fill=ground)
    labels.text(d, "CHOCOLATE", (50, 22, 370, 82), "oblique", "#ffe9b0", 3, shade(band, 0.4))
    labels.text(d, "BAR", (140, 84, 280, 116), "bold", ground)
    project_label(bar, label(art), "+z", (0, 0), (length * 0.98, 2.1 * r), 0.05)
    return Model(
        title="chocolate snack bar",
        parts={
            "body": Part(
                [bar.weigh(1.3)],
                collision=[box_piece((0, 0, 0.0125), (2 * r, length * 0.86, 0.025))],
            )
        },
        mass=0.05,
        friction=0.5,
    )


def choc_prism(kind: str, ground: str, band: str, brand: str) -> Model:
    """A long three-sided carton."""
    length, side, h = 0.21, 0.042, 0.0365
    v = [
        (x, s * length / 2, z) for s in (-1, 1) for x, z in ((-side / 2, 0), (side / 2, 0), (0, h))
    ]
    f = [(0, 1, 2), (5, 4, 3), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)]
    uv = [
        [(0.02, 0.1)] * 3,
        [(0.02, 0.1)] * 3,
        [(0.01, 0.05)] * 4,
        [(0, 0), (1, 0), (1, 1), (0, 1)],
        [(0, 1), (1, 1), (1, 0), (0, 0)],
    ]
    uv[4] = [(1, 1), (0, 1), (0, 0), (1, 0)]
    art, d = labels.canvas(520, 105, ground)
    d.rectangle((0, 82, 520, 105), fill=band)
    labels.text(d, "CHOCOLATE", (24, 8, 400, 78), "bold", band)
    groceries.chocolate(d, 462, 42, 34)
    prism = Mesh(v, f, None, [label(art)], uv, weight=1.3, smooth=False).outward()
    solid = np.array(v)
    return Model(
        title="three-sided chocolate bar",
        parts={"body": Part([prism], collision=[solid])},
        mass=0.11,
        friction=0.5,
    )


def choc_stack(tone: str) -> Model:
    """Broken pieces without a wrapper, heaped."""
    mat = cocoa(tone)
    pitch = 0.0245
    meshes = tablet(2, 4, pitch, mat)
    for rows, columns, x, y, z, yaw, tilt in (
        (1, 2, 0.01, -0.012, 0.0105, 0.5, 0.0),
        (2, 2, -0.004, 0.028, 0.0105, -0.3, 0.06),
        (1, 1, 0.05, 0.03, 0, 0.8, 0),
        (1, 2, 0.045, -0.03, 0, 1.2, 0),
    ):
        for mesh in tablet(rows, columns, pitch, mat):
            meshes.append(mesh.turn(rx=tilt).turn(rz=yaw).move(x, y, z))
    solids = [
        box_piece((0, 0, 0.005), (2 * pitch, 4 * pitch, 0.01)),
        box_piece((0, 0.01, 0.015), (0.045, 0.07, 0.01)),
        box_piece((0.048, 0, 0.005), (0.03, 0.09, 0.01)),
    ]
    return Model(
        title="broken chocolate pieces",
        parts={"body": Part(meshes, collision=solids)},
        mass=0.09,
        friction=0.6,
        texture_size=128,
    )


MILK = {"kind": "MILK", "ground": "#f0dcb0", "band": "#7a4424", "brand": "Alpina"}

DARK = {"kind": "DARK", "ground": "#e8d8b0", "band": "#4a1f10", "brand": "Cacaoro"}

NUT = {"kind": "WHITE", "ground": "#fff6e0", "band": "#c8202c", "brand": "Dolcina"}
#: Red and white, an opened bar lay there like rashers of bacon; of white chocolate, like cheese.
BLUE = {**MILK, "brand": "Dolcina", "ground": "#dcecf8", "band": "#1f5f9f"}

MODELS = {
    "chocolate_bar": Maker(
        by_style(
            "chocolate_bar",
            {
                "bar": choc_wrapped,
                "open": choc_open,
                "snack": choc_snack,
                "prism": choc_prism,
                "pieces": choc_stack,
            },
        ),
        lambda rng: {},
        count=7,
        presets=[
            {"style": "bar", **MILK},
            {"style": "bar", **DARK},
            {"style": "open", **MILK, "tone": "#6a3a1e"},
            {"style": "snack", **NUT},
            {
                "style": "prism",
                "kind": "MILK",
                "ground": "#fbe9b8",
                "band": "#b01c24",
                "brand": "Gipfel",
            },
            {"style": "pieces", "tone": "#5a2c16"},
            {"style": "open", **BLUE, "tone": "#5a2c16"},
        ],
    ),
}
