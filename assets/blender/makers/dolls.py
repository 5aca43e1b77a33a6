"""Dolls."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit.labels import canvas
from toolkit.materials import Material, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import ellipsoid, lathe, tube

from makers.projection import project_label
from makers.solids import flattened, grown, solids


def _face(style: str) -> Image.Image:
    """Eyes, cheeks and mouth on a transparent ground."""
    image, draw = canvas(192, 192)
    ink = "#2a1c18"
    for q in (-1, 1):
        x = 96 + 36 * q
        if style == "rag":
            draw.ellipse((x - 15, 70, x + 15, 100), fill=ink)
            draw.line((x - 7, 78, x + 7, 92), fill="#ffffff", width=3)
            draw.line((x - 7, 92, x + 7, 78), fill="#ffffff", width=3)
        else:
            draw.ellipse((x - 17, 62, x + 17, 104), fill="#ffffff", outline=ink, width=4)
            draw.ellipse((x - 12, 68, x + 12, 103), fill="#3a7fc0" if style != "baby" else ink)
            draw.ellipse((x - 7, 76, x + 7, 97), fill=ink)
            draw.ellipse((x - 9, 72, x - 1, 81), fill="#ffffff")
            for k in (-1, 0, 1):
                draw.line((x + 9 * k, 66, x + 15 * k + 4 * q, 50), fill=ink, width=4)
        draw.ellipse((x + 14 * q - 15, 106, x + 14 * q + 15, 130), fill="#f08a80")
    if style == "rag":
        draw.polygon([(96, 100), (84, 120), (108, 120)], fill="#d8402c")
        draw.arc((58, 90, 134, 152), 25, 155, fill=ink, width=5)
    elif style == "baby":
        draw.ellipse((84, 126, 108, 146), fill="#c83a48")
    else:
        draw.chord((72, 112, 120, 150), 10, 170, fill="#d02a40")
    return image


def _cloth(kind: str, first: str, second: str) -> Material:
    """Plain, with dots, or striped across."""
    m = Material()
    if kind == "dots":
        cell = m.voronoi(42, randomness=0.15)
        return m.colour(m.mix(m.remap(cell, 0.25, 0.29, 1, 0), first, second))
    if kind == "stripes":
        wave = m.math("SINE", m.math("MULTIPLY", m.axis(2), 380))
        return m.colour(m.mix(m.remap(wave, -0.1, 0.1), first, second))
    return m.colour(m.mottle(first, 0.05, 120))


def _head(at, radius: float, skin: str, hair: str, style: str, do: str) -> list[Mesh]:
    """A head with its hair: 'pigtails', 'long', 'bald' (a curl), 'yarn' or 'hat'."""
    x, y, z = at
    face = ellipsoid((radius * 0.94, radius, radius * 1.03), (0, 0, 0), 12, 7, plain(skin, 0.02))
    marks = printed(_face(style), skin)
    project_label(face, marks, "+x", (0, -0.04 * radius), (1.9 * radius,) * 2, 0.2)
    locks = plain(hair, 0.14, 260)
    meshes = [face.weigh(1.6)]

    def blob(radii, where, n=9, m=6, turn=(0, 0, 0)):
        scaled = [radius * r for r in radii]
        ball = ellipsoid(scaled, (0, 0, 0), n, m, locks).turn(*turn)
        meshes.append(ball.move(*(radius * w for w in where)))

    if do == "bald":
        blob((0.24, 0.3, 0.12), (0.45, 0, 0.92), 7, 4)
    else:
        blob((0.86, 1.07, 1.0), (-0.27, 0, 0.12), 9, 6)
        blob((0.36, 0.72, 0.22), (0.6, 0, 0.76), 8, 4, (0, 0.75, 0))
    if do == "pigtails":
        for q in (-1, 1):
            blob((0.34, 0.36, 0.62), (-0.15, 1.32 * q, -0.1), 7, 4, (0.3 * q, 0, 0))
            bow = ellipsoid(radius * 0.18, (0, 0, 0), 5, 3, plain("#d8202c", 0))
            meshes.append(bow.move(-0.12 * radius, 1.1 * q * radius, 0.42 * radius))
    elif do == "long":
        blob((0.42, 0.92, 1.5), (-0.72, 0, -0.85), 9, 6)
        for q in (-1, 1):
            blob((0.3, 0.28, 1.15), (-0.2, 0.92 * q, -0.62), 7, 5)
    elif do == "yarn":
        for k in range(9):
            a = -1.9 + 3.8 * k / 8
            blob(
                (0.17, 0.17, 0.62),
                (-0.2, 1.05 * math.sin(a), 0.2 + 0.75 * math.cos(a)),
                5,
                4,
                (-a, 0, 0),
            )
    elif do == "hat":
        straw = plain("#e8c87a", 0.12, 200)
        brim = [(0, 0), (1.6, 0.05), (1.6, 0.13), (0.98, 0.2), (0.86, 0.72), (0, 0.85)]
        hat = lathe([(radius * r, radius * h) for r, h in brim], 14, mat=straw)
        meshes.append(hat.turn(ry=-0.22).move(-0.14 * radius, 0, 0.62 * radius))
        for q in (-1, 1):
            blob((0.26, 0.28, 0.75), (-0.05, 0.98 * q, -0.45), 7, 5)
    for mesh in meshes:
        mesh.move(x, y, z)
    return meshes


def doll(
    kind: str, height: float, skin: str, hair: str, first: str, second: str, pattern: str
) -> Model:
    """'girl' and 'hat' stand, 'seated' sits, 'baby' sits, 'rag' lies, 'lady' wears a gown."""
    cloth, trim = _cloth(pattern, first, second), plain(second, 0.04)
    flesh, shoe = plain(skin, 0.03), plain("#b01c2c" if kind != "rag" else "#26242a", 0.03)
    meshes: list[Mesh] = []

    def limb(points, radii, mat, n=6):
        meshes.append(tube(points, radii, n, mat=mat))

    def dress(profile, n=12):
        meshes.append(lathe(profile, n, mats=[cloth, trim], mat_of_segment=[1] + [0] * 9))

    if kind in ("girl", "hat"):
        dress(
            [
                (0, 0.09),
                (0.078, 0.09),
                (0.082, 0.1),
                (0.05, 0.16),
                (0.031, 0.2),
                (0.03, 0.235),
                (0, 0.25),
            ]
        )
        for q in (-1, 1):
            limb([(0, 0.026 * q, 0.11), (0, 0.026 * q, 0.06)], 0.014, flesh)
            limb([(0, 0.026 * q, 0.062), (0, 0.026 * q, 0.02)], 0.0155, plain("#f6f4ee", 0.02))
            meshes.append(ellipsoid((0.028, 0.017, 0.014), (0.01, 0.026 * q, 0.013), 7, 4, shoe))
            meshes.append(ellipsoid((0.019, 0.02, 0.02), (0, 0.034 * q, 0.222), 6, 4, cloth))
            hand = [(0, 0.04 * q, 0.217), (0.008, 0.072 * q, 0.175), (0.02, 0.09 * q, 0.142)]
            limb(hand, [0.011, 0.0105, 0.012], flesh, 6)
        head = _head(
            (0, 0, 0.298), 0.056, skin, hair, "girl", "pigtails" if kind == "girl" else "hat"
        )
        tall = 0.36
    elif kind == "seated":
        dress(
            [
                (0, 0.0),
                (0.075, 0.0),
                (0.08, 0.014),
                (0.052, 0.05),
                (0.033, 0.085),
                (0.03, 0.125),
                (0, 0.14),
            ]
        )
        for q in (-1, 1):
            leg = [(0.04, 0.03 * q, 0.02), (0.1, 0.042 * q, 0.02), (0.125, 0.046 * q, 0.022)]
            limb(leg[:2], 0.016, flesh)
            limb(leg[1:], 0.0175, plain("#f6f4ee", 0.02))
            meshes.append(ellipsoid((0.016, 0.018, 0.03), (0.142, 0.048 * q, 0.028), 7, 4, shoe))
            meshes.append(ellipsoid((0.019, 0.02, 0.02), (0, 0.034 * q, 0.112), 6, 4, cloth))
            limb(
                [(0, 0.04 * q, 0.108), (0.035, 0.062 * q, 0.07), (0.06, 0.05 * q, 0.052)],
                [0.011, 0.0105, 0.012],
                flesh,
                6,
            )
        head = _head((0, 0, 0.188), 0.056, skin, hair, "girl", "long")
        tall = 0.26
    elif kind == "baby":
        meshes.append(ellipsoid((0.058, 0.062, 0.072), (0, 0, 0.07), 12, 8, cloth))
        for q in (-1, 1):
            limb([(0.03, 0.04 * q, 0.034), (0.088, 0.058 * q, 0.026)], [0.032, 0.022], cloth, 8)
            meshes.append(ellipsoid((0.016, 0.018, 0.027), (0.108, 0.064 * q, 0.028), 8, 5, flesh))
            limb([(0, 0.046 * q, 0.112), (0.03, 0.086 * q, 0.086)], [0.02, 0.016], cloth, 8)
            meshes.append(ellipsoid(0.016, (0.038, 0.094 * q, 0.078), 7, 5, flesh))
        ring = [(0.036 * math.cos(a), 0.04 * math.sin(a), 0.135) for a in np.linspace(0, 5.6, 9)]
        meshes.append(tube(ring, 0.012, 5, closed=True, mat=trim))
        head = _head((0.004, 0, 0.196), 0.066, skin, hair, "baby", "bald")
        tall = 0.265
    elif kind == "rag":
        dress(
            [
                (0, 0.1),
                (0.072, 0.1),
                (0.075, 0.112),
                (0.046, 0.165),
                (0.033, 0.2),
                (0.031, 0.238),
                (0, 0.25),
            ]
        )
        socks = _cloth("stripes", "#f6f4ee", "#c8202c")
        for q in (-1, 1):
            limb([(0, 0.026 * q, 0.12), (0.0, 0.044 * q, 0.03)], 0.0165, socks)
            meshes.append(ellipsoid((0.03, 0.02, 0.018), (0.014, 0.046 * q, 0.018), 7, 4, shoe))
            limb([(0, 0.034 * q, 0.222), (0.0, 0.1 * q, 0.205)], [0.016, 0.019], cloth)
            meshes.append(ellipsoid(0.017, (0, 0.115 * q, 0.2), 7, 5, flesh))
        head = _head((0, 0, 0.296), 0.058, skin, hair, "rag", "yarn")
        tall = 0.37
    else:
        dress(
            [
                (0, 0),
                (0.085, 0),
                (0.088, 0.012),
                (0.062, 0.05),
                (0.042, 0.11),
                (0.022, 0.168),
                (0.017, 0.19),
                (0.026, 0.22),
                (0, 0.238),
            ]
        )
        limb([(0, 0, 0.23), (0, 0, 0.255)], 0.008, flesh, 6)
        for q in (-1, 1):
            limb(
                [(0, 0.026 * q, 0.226), (0.004, 0.05 * q, 0.186), (0.03, 0.06 * q, 0.158)],
                [0.0085, 0.007, 0.0075],
                flesh,
                6,
            )
        head = _head((0, 0, 0.278), 0.032, skin, hair, "girl", "long")
        crown = [(0.019, 0), (0.022, 0.014), (0.018, 0.01), (0.016, 0)]
        head.append(
            lathe(
                crown, 10, mat=plain("#f0c030", 0.05), rib=lambda k, i: 1.0 + 0.12 * (i % 2)
            ).move(0, 0, 0.305)
        )
        tall = 0.32
    parts = [*meshes, *head]
    if kind == "rag":
        for mesh in parts:
            mesh.keep_pattern()
        meshes[0].scale(0.45, 1, 1)  # the skirt lies flat
        for mesh in parts:
            mesh.turn(ry=-math.pi / 2).turn(rz=-1.2)
    flattened(grown(parts, height / tall), 0.005 if kind != "baby" else 0.009)
    pieces = solids(meshes[:1], meshes[1:], head)
    return Model("doll", {"body": Part(parts, collision=pieces)}, mass=0.35, friction=0.6)


def doll_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "girl",
        "height": 0.36,
        "skin": "#f2c8a4",
        "hair": pick(rng, ["#e0b040", "#7a4420"]),
        "first": "#e0609a",
        "second": "#f6f4ee",
        "pattern": "plain",
    }


MODELS = {
    "doll": Maker(
        doll,
        doll_random,
        7,
        [
            {"hair": "#e8b83a", "pattern": "dots"},
            {"kind": "baby", "height": 0.3, "first": "#8fc4e8", "hair": "#b07a3a"},
            {
                "kind": "rag",
                "height": 0.4,
                "first": "#3f6fc0",
                "second": "#f6f4ee",
                "hair": "#d8521c",
                "pattern": "dots",
            },
            {
                "kind": "lady",
                "height": 0.3,
                "first": "#a04ac0",
                "second": "#f2c52a",
                "hair": "#f0cf5a",
            },
            {"kind": "seated", "height": 0.28, "first": "#d8303a", "hair": "#4a2a18"},
            {"skin": "#8a5a3a", "hair": "#1c1614", "first": "#f2b92c", "second": "#d8303a"},
            {"kind": "hat", "first": "#4fa86a", "hair": "#c8642c", "pattern": "dots"},
        ],
    ),
}
