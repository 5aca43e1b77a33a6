"""Sausages and cold cuts, as the butcher packs them."""

from __future__ import annotations

import math

import numpy as np
from labels import foods
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import TAU, box, lathe, loft, rounded_rectangle, tube

from makers import chilled
from makers.pack_parts import by_style, tub_ring
from makers.projection import project_label


def pork_skin(colour: str) -> Material:
    m = Material(occlusion=0.9)
    c = m.mottle(colour, 0.14, 60)
    c = m.mix(m.remap(m.voronoi(260), 0.08, 0.16, 0.5, 0), c, "f2c8a8")
    shine = m.remap(m.noise(30, 1, stretch=(1, 0.3, 1)), 0.62, 0.7, 0, 0.5)
    return m.colour(m.mix(shine, c, "fbe0cc"))


def sausage_label(word: str, brand: str, band: str):
    image, d = labels.canvas(300, 150, band)
    labels.text(d, brand, (60, 4, 240, 32), "italic", "#ffe9b0")
    labels.text(d, word, (8, 34, 292, 90), "bold", "#ffffff")
    foods.sausage(d, 150, 120, 190, 20, "#c0562c")
    return image


def sausage_coil(skin: str, word: str, band: str, brand: str) -> Model:
    """One long sausage rolled up like a snail."""
    mat = pork_skin(skin)
    turns = np.linspace(1.2 * math.pi, 6.4 * math.pi, 44)
    radius = 0.0118 + 0.0041 * turns
    path = np.c_[radius * np.cos(turns), radius * np.sin(turns), np.full(44, 0.02)]
    thick = np.full(44, 0.0125)
    thick[[0, -1]], thick[[1, -2]] = 0.004, 0.009
    coil = tube(path, thick, 7, mat=mat, up=(0, 0, 1))
    tray = chilled.tray(0.21, 0.215, 0.024, plain("#1f2124", 0.05, 200), 0.006)
    tag = chilled.sticker((0.075, 0.12), (0.0, 0, 0.0322), sausage_label(word, brand, band))
    return Model(
        title="coiled sausage in a tray",
        parts={
            "body": Part(
                [tray, coil, tag], collision=[box_piece((0, 0, 0.016), (0.2, 0.205, 0.032))]
            )
        },
        mass=0.45,
        friction=0.5,
    )


def vacuum_pack(skin: str, word: str, band: str, brand: str) -> Model:
    """Frankfurters under a tight film, with a printed card at the head."""
    r, count, length = 0.011, 5, 0.17
    mat = pork_skin(skin)
    film = plain("#e6e2dc", 0.05, 80)
    width, head = 2 * r * count + 0.03, 0.05
    sheet = loft(
        [
            np.c_[rounded_rectangle(length + head + 0.03, width, 0.008, 3), np.full(12, z)]
            for z in (0.0, 0.005)
        ],
        mat=film,
    )
    meshes = [sheet.move(0.0, 0, 0)]
    for k in range(count):
        y = (k - (count - 1) / 2) * 2 * r * 1.03
        path = [
            (t * (length / 2) + head / 2, y, 0.004 + r * 0.75)
            for t in (-1.0, -0.93, -0.8, 0, 0.8, 0.93, 1.0)
        ]
        meshes.append(tube(path, np.array([0.3, 0.75, 1, 1.0, 1, 0.75, 0.3]) * r, 8, mat=mat))
    image, d = labels.canvas(320, 160, band)
    labels.text(d, brand, (80, 4, 240, 34), "italic", "#ffe9b0")
    labels.text(d, word, (8, 36, 312, 104), "bold", "#ffffff")
    foods.sausage(d, 160, 132, 200, 18, "#d0703c")
    card = box(
        head + 0.012,
        width - 0.004,
        0.003,
        (-length / 2 - 0.008, 0, 0.004),
        plain(band, 0.02),
        labels={"+z": label(image)},
        weight=1.6,
    )
    return Model(
        title=f"pack of {word.lower()}",
        parts={
            "body": Part(
                [*meshes, card],
                collision=[box_piece((0, 0, 0.011), (length + head + 0.03, width, 0.022))],
            )
        },
        mass=0.3,
        friction=0.5,
    )


def sausage_chain(skin: str, links: int) -> Model:
    """A string of linked sausages lying in loops."""
    mat = pork_skin(skin)
    meshes = []
    for k in range(links):
        row = k // 2
        x, y = (k % 2 - 0.5) * 0.132, (row - (links / 2 - 1) / 2) * 0.034
        bend = 0.008 if row % 2 else -0.008
        path = [
            (x + t * 0.062, y + bend * (1 - t * t), 0.0155)
            for t in (-1.03, -0.93, -0.7, 0, 0.7, 0.93, 1.03)
        ]
        radii = np.array([0.2, 0.65, 0.95, 1, 0.95, 0.65, 0.2]) * 0.0155
        meshes.append(tube(path, radii, 8, mat=mat, up=(0, 0, 1)))
        if k % 2 == 0 and k + 2 < links + 1:
            side = 1 if row % 2 else -1
            if row + 1 < links / 2:
                loop = [
                    (side * 0.13, y, 0.01),
                    (side * 0.142, y + 0.017, 0.008),
                    (side * 0.13, y + 0.034, 0.01),
                ]
                meshes.append(tube(loop, 0.003, 5, mat=mat))
    return Model(
        title="string of sausages",
        parts={
            "body": Part(
                meshes, collision=[box_piece((0, 0, 0.0155), (0.26, 0.034 * links / 2, 0.03))]
            )
        },
        mass=0.1 * links,
        friction=0.6,
    )


def sausage_ring(skin: str, word: str, band: str, brand: str) -> Model:
    """A ring of boiled sausage, tied at its ends, with a paper tag."""
    mat = pork_skin(skin)
    t = np.linspace(0.3, TAU - 0.3, 22)
    r = np.full(22, 0.0215)
    r[[0, -1]], r[[1, -2]] = 0.004, 0.016
    ring = tube(np.c_[0.072 * np.cos(t), 0.072 * np.sin(t), np.full(22, 0.0215)], r, 9, mat=mat)
    knot = tube(
        [(0.072, -0.028, 0.02), (0.082, 0, 0.024), (0.072, 0.028, 0.02)],
        0.003,
        5,
        mat=plain("#f2ead8", 0.05),
    )
    tag = chilled.sticker((0.05, 0.085), (-0.068, 0, 0.0425), sausage_label(word, brand, band))
    return Model(
        title="ring of sausage",
        parts={
            "body": Part(
                [ring, knot, tag], collision=[box_piece((0, 0, 0.021), (0.15, 0.15, 0.042))]
            )
        },
        mass=0.4,
        friction=0.5,
    )


def ham_slice_mat(kind: str) -> Material:
    tones = {"HAM": ("f2aaa6", "ecdcc8", "e08c88"), "SALAMI": ("a8322a", "f2d6c6", "7a1c18")}
    base, spots, dark = tones[kind]
    m = Material(occlusion=0.8)
    c = m.mottle(base, 0.06, 40)
    c = m.mix(m.remap(m.noise(26, 3, distortion=1.5), 0.55, 0.62, 0, 0.5), c, dark)
    size = 190 if kind == "SALAMI" else 90
    return m.colour(m.mix(m.remap(m.voronoi(size), 0.14, 0.22, 0.85, 0), c, spots))


def fanned_pack(kind: str, colour: str, brand: str) -> Model:
    """An opened pack: the film is peeled back, slices stand up in folds."""
    width, length = 0.14, 0.19
    film = plain("#e9ecee", 0.04)
    tray = loft(
        [
            tub_ring(width, length, 0.014, z, k, 3)
            for z, k in ((0, 0.012), (0.012, 0.0), (0.0135, 0.0), (0.0135, 0.008), (0.005, 0.014))
        ],
        mat=film,
    )
    tray.bake_uv = None
    meat, rind = ham_slice_mat(kind), plain("ecdcc4" if kind == "HAM" else "7a4030", 0.06)
    meshes = [tray]
    for k in range(6):
        t = np.arange(18) * TAU / 18
        shape = np.c_[0.044 * np.cos(t), 0.05 * np.sin(t)]
        rings = [np.c_[shape, np.full(18, z)] for z in (0.0, 0.005)]
        piece = loft(rings, mats=[rind, meat], mat_of_face=lambda k, i: 0)
        piece.mi[-2:] = [1, 1]
        piece.bake_uv = None
        piece.keep_pattern()
        piece.warp(lambda x, y, z: (x, y, z + 0.012 * (x / 0.044) ** 2))
        meshes.append(
            piece.turn(rx=0.42).move(0.012 * (k % 2), (k - 2.5) * 0.024, 0.02 + (0.004 if k else 0))
        )
    lid = box(0.07, length - 0.01, 0.005, (0, 0, 0), film, 0.001)
    art = label(ham_front(kind, colour, brand))
    for side in ("+z", "-z"):
        project_label(lid, art, side, (0, 0), (length - 0.01, 0.07), 0.9)
    lid.move(0.035).turn(ry=-2.0).move(-width / 2 + 0.002, 0, 0.012)
    return Model(
        title=f"opened pack of sliced {kind.lower()}",
        parts={
            "body": Part(
                [*meshes, lid.weigh(1.3)],
                collision=[box_piece((0, 0, 0.02), (width, length, 0.04))],
            )
        },
        mass=0.13,
        friction=0.5,
    )


def ham_front(kind: str, colour: str, brand: str):
    image, d = labels.canvas(400, 170, colour)
    labels.text(d, brand, (20, 8, 200, 44), "italic", "#ffe9b0")
    labels.text(d, kind, (20, 44, 380, 132), "bold", "#ffffff")
    labels.text(d, "SLICED", (120, 134, 280, 164), "bold", "#ffffff")
    return image


def round_pack(kind: str, colour: str, brand: str) -> Model:
    """A round flat pack of large slices, lapping round in a circle."""
    r, h = 0.082, 0.02
    film = plain("#e9ecee", 0.04)
    tray = lathe(
        [
            (0, 0),
            (0.9 * r, 0),
            (r * 0.96, h - 0.004),
            (1.06 * r, h - 0.004),
            (1.06 * r, h),
            (0.98 * r, h),
            (0.93 * r, 0.006),
            (0, 0.006),
        ],
        26,
        mat=film,
    )
    meat, rind = ham_slice_mat(kind), plain("ecdcc4" if kind == "HAM" else "7a4030", 0.06)
    meshes = [tray]
    for k in range(7):
        t = np.arange(16) * TAU / 16
        rings = [np.c_[0.036 * np.cos(t), 0.036 * np.sin(t), np.full(16, z)] for z in (0.0, 0.005)]
        piece = loft(rings, mat=rind)
        piece.mats, piece.mi = [rind, meat], [0] * 16 + [1, 1]
        piece.bake_uv = None
        piece.keep_pattern()
        a = k * TAU / 7
        meshes.append(
            piece.turn(ry=0.18)
            .turn(rz=a + 1.2)
            .move(0.041 * math.cos(a), 0.041 * math.sin(a), 0.014)
        )
    art, d = labels.canvas(256, 256)
    d.ellipse((0, 0, 255, 255), fill=colour)
    labels.text(d, brand, (60, 40, 196, 80), "italic", "#ffe9b0")
    labels.text(d, kind, (18, 84, 238, 168), "bold", "#ffffff")
    labels.text(d, "SLICED", (66, 176, 190, 212), "bold", "#ffffff")
    badge = lathe(
        [(0, 0.0245), (0.04, 0.0245), (0.04, 0.027), (0, 0.027)], 20, mat=plain(colour, 0)
    )
    project_label(badge, label(art, base=colour), "+z", (0, 0), (0.08, 0.08), 0.9)
    return Model(
        title=f"round pack of sliced {kind.lower()}",
        parts={
            "body": Part([*meshes, badge.weigh(1.4)], collision=[cylinder_piece(r, 0, 0.026, 14)])
        },
        mass=0.2,
        friction=0.5,
    )


def ham_plate(kind: str, colour: str, brand: str) -> Model:
    """Slices folded into rosettes on butcher's paper."""
    paper = loft(
        [np.c_[rounded_rectangle(0.16, 0.21, 0.004, 2), np.full(8, z)] for z in (0.0, 0.005)],
        mat=plain("#f4efe2", 0.04, 50),
    )
    paper.v[:, 2] += 0.01 * (np.abs(paper.v[:, 1]) > 0.09)
    meat, rind = ham_slice_mat(kind), plain("ecdcc4" if kind == "HAM" else "7a4030", 0.06)
    meshes = [paper]
    for k in range(7):
        t = np.linspace(-1.25, 1.25, 9)
        rings = []
        for q in (1.0,):
            arc = np.c_[0.042 * q * np.sin(t), 0.042 * q * np.cos(t)]
            rings.append(arc)
        outline = np.concatenate([rings[0], [[0, 0.004]]])
        v = [(x, y, z) for z in (0, 0.006) for x, y in outline]
        n = len(outline)
        f = [tuple(range(n)), tuple(range(n, 2 * n))[::-1]] + [
            (i, i + n, (i + 1) % n + n, (i + 1) % n) for i in range(n)
        ]
        piece = Mesh(v, f, [1, 1] + [0] * n, [rind, meat]).outward()
        piece.keep_pattern()
        row, column = divmod(k, 2)
        piece.turn(rx=0.25).turn(rz=(0.35 if column else -0.35) + math.pi / 2 * 0)
        meshes.append(piece.move((column - 0.5) * 0.062, (row - 1.9) * 0.034, 0.006 + 0.001 * k))
    tag = chilled.sticker((0.045, 0.06), (0.045, 0.072, 0.0162), ham_front(kind, colour, brand))
    tag.turn(rx=0.0)
    return Model(
        title=f"slices of {kind.lower()} on paper",
        parts={
            "body": Part(
                [*meshes, tag],
                collision=[
                    box_piece((0, 0, 0.003), (0.16, 0.2, 0.006)),
                    box_piece((0, 0, 0.008), (0.1, 0.14, 0.014)),
                ],
            )
        },
        mass=0.15,
        friction=0.5,
    )


SNACK = {"length": 0.19, "width": 0.14, "height": 0.016}

MODELS = {
    "sausage_pack": Maker(
        by_style(
            "sausage_pack",
            {
                "tray": chilled.sausage_pack,
                "coil": sausage_coil,
                "vacuum": vacuum_pack,
                "chain": sausage_chain,
                "ring": sausage_ring,
            },
        ),
        chilled.sausage_pack_random,
        count=7,
        presets=[
            {"style": "tray"},
            {
                "style": "tray",
                "count": 6,
                "skin": "#d99a80",
                "word": "BRATWURST",
                "band": "#1f6a34",
            },
            {
                "style": "coil",
                "skin": "#c8705a",
                "word": "SAUSAGE",
                "band": "#a81c24",
                "brand": "Hofgut",
            },
            {
                "style": "vacuum",
                "skin": "#d0653c",
                "word": "SAUSAGES",
                "band": "#1f4f9c",
                "brand": "Wurstel",
            },
            {"style": "chain", "skin": "#b8543a", "links": 6},
            {
                "style": "ring",
                "skin": "#c4553a",
                "word": "SAUSAGE",
                "band": "#1f6a34",
                "brand": "Dorfmetz",
            },
            {
                "style": "vacuum",
                "skin": "#a8442c",
                "word": "HOT DOGS",
                "band": "#c8202c",
                "brand": "Hofgut",
            },
        ],
    ),
    "sliced_ham": Maker(
        by_style(
            "sliced_ham",
            {
                "flat": chilled.sliced_ham,
                "open": fanned_pack,
                "round": round_pack,
                "paper": ham_plate,
            },
        ),
        chilled.sliced_ham_random,
        count=7,
        presets=[
            {"style": "flat", "kind": "HAM", **SNACK},
            {"style": "flat", "kind": "SMOKED HAM", "colour": "#2a5a34", **SNACK},
            {"style": "flat", "kind": "HAM", "colour": "#b01f2a", **SNACK},
            {"style": "open", "kind": "HAM", "colour": "#1f4f9c", "brand": "Hofgut"},
            {"style": "round", "kind": "HAM", "colour": "#b01f2a", "brand": "Alba"},
            {"style": "paper", "kind": "HAM", "colour": "#2a5a34", "brand": "Dorfmetz"},
            {
                "style": "flat",
                "kind": "HAM",
                "colour": "#d8862a",
                "length": 0.13,
                "width": 0.1,
                "height": 0.022,
            },
        ],
    ),
}
