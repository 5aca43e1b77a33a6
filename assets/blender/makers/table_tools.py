"""Forks and spoons, lying as they rest: flat; dirty ones with food on them."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import ellipsoid, lathe, loft, tube

from makers.cutlery import handle_rings
from makers.ware import DIRTY, smear

STEM = [
    (-0.095, 0.006, 0.004),
    (-0.09, 0.0105, 0.004),
    (-0.06, 0.0085, 0.005),
    (-0.02, 0.0042, 0.008),
    (0.02, 0.0038, 0.012),
]


def fork_head(mat: Material, tines: int, gap: float, reach: float, thick: float) -> list[Mesh]:
    """Handle and head of a fork, its tines up and towards +X."""
    half = (tines - 1) / 2 * gap + thick
    neck = [
        (0.035, 0.0055, 0.0105),
        (0.045, max(0.9 * half, 0.006), 0.008),
        (0.06, half, 0.006),
        (0.066, half, 0.0055),
    ]
    meshes = [loft(handle_rings(STEM + neck, max(0.0042, 1.7 * thick)), mat=mat)]
    for i in range(tines):
        y = (i - (tines - 1) / 2) * gap
        steps = ((0, 0.0055), (0.4, 0.005), (0.75, 0.007), (1, 0.011))
        path = [(0.063 + reach * t, y * (1 - 0.04 * t), z) for t, z in steps]
        radii = [thick, thick, 0.92 * thick, 0.56 * thick]
        meshes.append(tube(path, radii, 5, mat=mat, up=(0, 0, 1.0)))
    return meshes


def spoon_head(mat: Material, a: float, b: float, tip: float, n: int = 14) -> list[Mesh]:
    """Handle and bowl of a spoon lying bowl up, bowl towards +X; tip: how pointed it is."""
    meshes = [loft(handle_rings([*STEM, (0.045, 0.005, 0.0105)], 0.0042), mat=mat)]
    angles = [2 * math.pi * i / n for i in range(n)]
    deep = max(1.0, b / 0.02) ** 0.5

    def ring(k: float, z: float) -> list[tuple[float, float, float]]:
        return [
            (
                0.038 + a + a * k * math.cos(t),
                b * k * math.sin(t) * (1 - tip * math.cos(t)),
                z * deep,
            )
            for t in angles
        ]

    levels = [
        (0.3, 0.0005),
        (0.65, 0.003),
        (0.9, 0.0072),
        (1.0, 0.0115),
        (0.96, 0.0122),
        (0.85, 0.0086),
        (0.6, 0.0052),
        (0.25, 0.0038),
    ]
    bowl = loft([ring(k, z) for k, z in levels], mat=mat)
    bowl.bake_uv = None
    return [*meshes, bowl]


# tines, their distance, length and thickness; length of the fork; how many lie there
FORKS = {
    "table": (4, 0.0066, 0.042, 0.0025, 0.2, 1),
    "cake": (3, 0.0064, 0.03, 0.0024, 0.15, 1),
    "picnic": (4, 0.0092, 0.036, 0.0032, 0.175, 1),
    "set": (4, 0.0066, 0.042, 0.0025, 0.195, 2),
    "salad": (5, 0.0112, 0.034, 0.0042, 0.27, 1),
}
# half length and half width of the bowl, pointedness; length of the spoon; how many
SPOONS = {
    "table": (0.03, 0.02, 0.12, 0.2, 1),
    "tea": (0.024, 0.0165, 0.12, 0.14, 1),
    "soup": (0.027, 0.0265, 0.0, 0.185, 1),
    "wooden": (0.031, 0.022, 0.05, 0.31, 1),
    "set": (0.03, 0.02, 0.12, 0.19, 2),
    "baby": (0.024, 0.019, 0.0, 0.15, 1),
    "serving": (0.037, 0.028, 0.08, 0.25, 1),
}


def tool_material(kind: str, colour: str, seed: int) -> Material:
    """Steel, brass, wood with its grain along the tool, or coloured plastic."""
    offset = noise_offset(np.random.default_rng(seed))
    if kind == "wood":
        return wood("c99a5c", "8a5a2c", 0, 14, offset)
    if kind == "plastic":
        return plain(colour, 0.05, 90, offset)
    light, dark = ("d8b25a", "8f6a24") if kind == "brass" else ("c6cace", "858b91")
    return metal(light, dark, (1, 12, 1), 60, offset, occlusion=0.5)


def fork(form="table", material="steel", handle="", colour="#f4f2ec", look=0) -> Model:
    """A fork of a form of FORKS; `handle`: colour of a plastic or wooden grip."""
    tines, gap, reach, thick, length, count = FORKS[form]
    mat = tool_material(material, colour, look)
    heads = [fork_head(mat, tines, gap, reach, thick) for _ in range(count)]
    rng = np.random.default_rng(look)
    tip = 0.063 + reach
    sauce, pasta = plain("b8321a", 0.25, 90), plain("ecd080", 0.12, 120)
    half = (tines - 1) / 2 * gap + thick
    mess = [ellipsoid((0.3 * reach, half * 1.15, 0.0042), (0.066, 0, 0.0075), 9, 5, sauce)]
    for k in range(2):  # spaghetti wound round the tines
        x = tip - reach * (0.34 + 0.24 * k)
        turns = np.linspace(0, 2 * math.pi, 9)[:-1]
        ring = [
            (
                x + 0.003 * math.sin(a),
                (half + 0.0022) * math.cos(a),
                0.0085 + 0.0062 * math.sin(a),
            )
            for a in turns
        ]
        mess.append(tube(ring, 0.0024, 4, closed=True, mat=pasta, weight=0.5))
    mess.append(smear(0.01, 0.001, 0.0142, 0.006, rng, sauce, 0.0012, 8))
    name = {"set": "two table forks", "table": "table fork"}
    title = name.get(form, f"{form} fork")
    return table_tool(title, heads, handle, length, mess, tip + 0.095)


def spoon(form="table", material="steel", handle="", colour="#f4f2ec", look=0) -> Model:
    """A spoon of a form of SPOONS, lying bowl up."""
    a, b, tip, length, count = SPOONS[form]
    mat = tool_material(material, colour, look)
    heads = [spoon_head(mat, a, b, tip) for _ in range(count)]
    rng = np.random.default_rng(look)
    z = max(1.0, b / 0.02) ** 0.5
    stuff = plain("7a4a22" if form in ("tea", "table") else "e6b23a", 0.25, 90)
    flat = [(0.8, 0.0078 * z), (0.7, 0.0104 * z), (0, 0.0112 * z)]
    pool = lathe(flat, 14, mat=stuff).scale(a, b, 1).move(0.038 + a, 0.0, 0)
    lump = (0.038 + a * 1.2, b * 0.2, 0.0115 * z)
    mess = [pool, ellipsoid((a * 0.34, b * 0.34, 0.004), lump, 7, 4, stuff)]
    mess += [smear(x, 0, 0.013, 0.0055, rng, stuff, 0.0012, 8) for x in (0.026, 0.008)]
    name = {"set": "two table spoons", "tea": "teaspoon"}
    title = name.get(form, f"{form} spoon")
    return table_tool(title, heads, handle, length, mess, 0.038 + 2 * a + 0.095)


def table_tool(
    name: str, heads: list[list[Mesh]], handle: str, length: float, mess: list[Mesh], drawn: float
) -> Model:
    """Common end of fork and spoon: grips, size, several side by side, collision."""
    s = length / drawn
    meshes: list[Mesh] = []
    places = [k - (len(heads) - 1) / 2 for k in range(len(heads))]
    for head, place in zip(heads, places, strict=True):
        if handle:
            stations = [
                (-0.1, 0.008, 0.0045),
                (-0.096, 0.0115, 0.0045),
                (-0.05, 0.0095, 0.0055),
                (-0.01, 0.007, 0.0085),
            ]
            head.append(loft(handle_rings(stations, 0.0085), mat=plain(handle, 0.06, 120)))
        for mesh in head:
            mesh.scale(s).turn(rz=0.13 * place).move(-0.012 * abs(place), 0.042 * place, 0)
        meshes += head
    for mesh in mess:
        mesh.scale(s)
    pieces = []
    for head in heads:
        tines = [m.v for m in head[1:] if len(m.v) < 30]
        pieces += [m.v.copy() for m in head if len(m.v) >= 30]
        if tines:
            pieces.append(np.concatenate(tines))
    return Model(
        title=name + (", coloured handle" if handle else ""),
        parts={
            "body": Part(meshes, collision=pieces),
            "remains": Part(mess, collision="none"),
        },
        variants={"default": ["body"], "dirty": ["body", "remains"]},
        states=DIRTY,
        mass=0.05 if length < 0.24 and len(heads) == 1 else 0.078,
        friction=0.5,
        texture_size=128,
    )


def table_tool_random(rng: np.random.Generator) -> dict:
    return {"look": seed_of(rng)}


MODELS = {
    "fork": Maker(
        fork,
        table_tool_random,
        7,
        [
            {"form": "table"},
            {"form": "salad"},
            {"form": "cake", "material": "brass"},
            {"form": "picnic", "material": "plastic", "colour": "#7ab648"},
            {"form": "picnic", "material": "plastic", "colour": "#f4f2ec"},
            {"form": "set"},
            {"form": "salad", "material": "wood"},
        ],
    ),
    "spoon": Maker(
        spoon,
        table_tool_random,
        8,
        [
            {"form": "table"},
            {"form": "table", "handle": "#2d6a9a"},
            {"form": "tea", "material": "brass"},
            {"form": "soup"},
            {"form": "wooden", "material": "wood"},
            {"form": "set"},
            {"form": "baby", "material": "plastic", "colour": "#e8702a"},
            {"form": "serving", "handle": "#26262a"},
        ],
    ),
}
