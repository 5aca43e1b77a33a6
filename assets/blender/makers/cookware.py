"""Pots: with soup in them, or dirty after cooking; the lid lies beside or on top."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain
from toolkit.mesh import Mesh
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import box, ellipsoid, lathe, spline, tube

from makers.ware import DIRTY, FULL, remains, runs, smear, surface_of


def vessel(radius, height, outer, inner, rim, wall=0.004, n=18, flare=1.0) -> Mesh:
    """A pan's wall and floor; flare: top radius over bottom radius."""
    low = radius / flare
    profile = [
        (0, 0),
        (low * 0.93, 0),
        (low, 0.005),
        (radius, height - 0.002),
        (radius + 0.002, height - 0.0005),
    ]
    profile += [
        (radius + 0.0005, height),
        (radius - wall, height - 0.0015),
        (low - wall, 0.011),
        (low * 0.9, 0.006),
        (0, 0.006),
    ]
    return lathe(profile, n, mats=[outer, inner, rim], mat_of_segment=[0, 0, 0, 2, 2, 2, 1, 1, 1])


def vessel_pieces(radius, height, wall=0.006, flare=1.0) -> list[np.ndarray]:
    low = radius / flare
    return [
        cylinder_piece(low, 0, 0.006),
        *ring_pieces(
            [(low, 0), (radius, height)], [(low - wall, 0.0), (radius - wall, height)], 10
        ),
    ]


def inside_of(radius: float, height: float, flare: float = 1.0) -> dict:
    """Support and container of an open vessel."""
    low = radius / flare
    return {
        "supports": [Support("bottom", 0.006, round_polygon(low * 0.88), container="inside")],
        "containers": [
            Container("inside", (0, 0, height / 2 + 0.004), (low * 1.3, low * 1.3, height - 0.01))
        ],
    }


def loops(radius: float, z: float, mat, wide=0.045, out=0.042) -> tuple[list[Mesh], list]:
    """Two loop handles at the sides."""
    meshes, pieces = [], []
    for side in (-1, 1):
        path = [
            (
                wide * math.sin(a) / math.sin(1.2),
                side * (radius - 0.004 + out * (math.cos(a) - 0.36) / 0.64),
                z,
            )
            for a in np.linspace(-1.2, 1.2, 7)
        ]
        meshes.append(tube(path, 0.0065, 5, mat=mat, up=(0, 0, 1.0)))
        pieces.append(
            box_piece((0, side * (radius + 0.42 * out), z), (2 * wide, out * 0.86, 0.013))
        )
    return meshes, pieces


def long_handle(radius: float, z: float, length: float, mat, rise=0.03) -> tuple[list[Mesh], list]:
    """A long handle to +X."""
    ends = [
        (radius - 0.004, 0, z),
        (radius + 0.3 * length, 0, z + 0.7 * rise),
        (radius + length, 0, z + rise),
    ]
    radii = [0.006, 0.008, 0.009, 0.011, 0.012, 0.0125, 0.0105]
    bar = tube(spline(ends, 3), radii, 8, mat=mat, up=(0, 0, 1.0), flatten=0.65)
    corners = [
        (x, y, q + dz)
        for x, q in ((radius - 0.004, z), (radius + length, z + rise))
        for y in (-0.011, 0.011)
        for dz in (-0.008, 0.008)
    ]
    return [bar], [np.array(corners)]


# radius, height, handles, flare
POTS = {
    "stock": (0.11, 0.14, "loops", 1.0),
    "low": (0.125, 0.085, "loops", 1.03),
    "saucepan": (0.085, 0.09, "long", 1.0),
    "tall": (0.12, 0.205, "loops", 1.0),
    "milk": (0.062, 0.085, "long", 1.1),
    "dutch": (0.12, 0.115, "lugs", 1.06),
}
SOUPS = {"tomato": "c83a18", "pea": "7a9a34", "chicken": "e0b04a", "pumpkin": "e8871c"}


def pot(
    shape="stock", colour="", handle="#1c1c1e", soup="tomato", lid="metal", dirt="soup", look=0
) -> Model:
    """A pot of a form of POTS; colour: enamel (steel without); lid: '', metal or glass."""
    rng = np.random.default_rng(look)
    radius, height, grips, flare = POTS[shape]
    steel = metal("c2c6ca", "7e848a", (1, 1, 14), 40, noise_offset(rng))
    outer = plain(colour, 0.05, 20, noise_offset(rng)) if colour else steel
    inner = plain("e9e6de", 0.04, 30) if colour else metal("b3b8bc", "858b90", (12, 12, 1), 40)
    body = [vessel(radius, height, outer, inner, steel, 0.004, 18, flare)]
    grip = plain(handle, 0.06, 120)
    pieces = vessel_pieces(radius, height, 0.006, flare)
    if grips == "long":
        meshes, more = long_handle(
            radius, height * 0.82, 0.16 if radius > 0.07 else 0.12, grip, 0.012
        )
        body, pieces = body + meshes, pieces + more
    elif grips == "loops":
        meshes, more = loops(radius, height * 0.8, grip)
        body, pieces = body + meshes, pieces + more
    else:
        for side in (-1, 1):
            at = (0, side * (radius + 0.014), height * 0.8)
            body.append(box(0.075, 0.036, 0.013, at, outer, 0.005))
            pieces.append(box_piece((at[0], at[1], at[2] + 0.006), (0.075, 0.036, 0.013)))
    parts = {"body": Part(body, collision=pieces)}
    variants = {"default": ["body"]}
    level = height * 0.82
    broth = [surface_of(SOUPS[soup], radius * 0.985 - 0.004, level, 16)]
    bits = ["d8702a", "4f8a34", "f0e2b0", "6f3a1a"]
    for k in range(7):
        a, far = 2.4 * k, radius * 0.82 * math.sqrt((k + 0.5) / 7)
        at = (far * math.cos(a), far * math.sin(a), level + 0.001)
        size = 0.075 * radius
        lump = ellipsoid((1.4 * size, size, 0.5 * size), at, 6, 3, plain(bits[k % 4], 0.15))
        broth.append(lump.turn(rz=0.8 * k, pivot=at))
    parts["filling"] = Part(broth, collision="none")
    dry = plain(
        {"soup": "a8401c", "burnt": "2a1a10", "milk": "efe6cc"}.get(dirt, "7a4a22"), 0.25, 90
    )
    mess = remains(dirt, radius * 0.8 / flare, 0.0068, look, 0.8, 9)
    mess.append(
        smear(0, 0, 0.0066, radius * 0.74 / flare, rng, plain("2c1c12", 0.2, 60), 0.0008, 16)
    )
    straight = [(radius / flare, 0), (radius, height)]
    mess += runs(straight, rng, 3, dry, -0.0055, 0.005) + runs(straight, rng, 3, dry, 0.0006, 0.005)
    parts["remains"] = Part(mess, collision="none")
    variants |= {"full": ["body", "filling"], "dirty": ["body", "remains"]}
    if lid:
        z = height
        top = [
            (0, z + 0.001),
            (radius - 0.002, z + 0.001),
            (radius + 0.004, z + 0.002),
            (radius + 0.003, z + 0.006),
            (radius * 0.75, z + 0.018),
            (radius * 0.35, z + 0.025),
            (0, z + 0.027),
        ]
        z += 0.026
        knob = [
            (0, z),
            (0.009, z),
            (0.007, z + 0.01),
            (0.017, z + 0.016),
            (0.016, z + 0.024),
            (0, z + 0.026),
        ]
        cover = outer if colour else metal("c9cdd0", "8a9096", (9, 9, 1), 30)
        mats = [plain("c4dade", 0.05), steel] if lid == "glass" else [cover, cover]
        meshes = [
            lathe(top, 18, mats=mats, mat_of_segment=[0, 1, 1, 0, 0, 0]),
            lathe(knob, 10, mat=grip),
        ]
        parts["lid"] = Part(meshes, collision="hull")
        variants["covered"] = ["body", "lid"]
    return Model(
        title=f"{'enamel' if colour else 'steel'} {shape} pot"
        if shape != "saucepan"
        else "saucepan",
        parts=parts,
        variants=variants,
        states=[*FULL, *DIRTY],
        mass=1.4 if shape != "dutch" else 3.2,
        texture_size=128,
        **inside_of(radius, height, flare),
    )


def pot_random(rng: np.random.Generator) -> dict:
    return {"soup": pick(rng, list(SOUPS)), "look": seed_of(rng)}


MODELS = {
    "pot": Maker(
        pot,
        pot_random,
        count=8,
        presets=[
            {"shape": "stock", "colour": "", "soup": "tomato", "dirt": "soup"},
            {"shape": "low", "colour": "#b3302c", "soup": "pumpkin", "dirt": "burnt"},
            {"shape": "saucepan", "colour": "", "soup": "pea", "dirt": "burnt"},
            {"shape": "tall", "colour": "", "lid": "glass", "soup": "chicken", "dirt": "soup"},
            {"shape": "milk", "colour": "#e8dcc0", "lid": "", "soup": "pumpkin", "dirt": "milk"},
            {"shape": "dutch", "colour": "#2d5f6e", "handle": "#c8a050", "soup": "chicken"}
            | {"dirt": "bones"},
            {"shape": "stock", "colour": "#2f6a4a", "soup": "pea", "dirt": "peas"},
            {"shape": "saucepan", "colour": "#d8702a", "soup": "tomato", "dirt": "soup"},
        ],
    ),
}
