"""Backpacks and handbags of all forms."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import (
    box,
    ellipsoid,
    extrude,
    lathe,
    loft,
    rounded_rectangle,
    superellipse,
    tube,
)

from makers import bags
from makers.bags import backpack_random, handbag_random, woven
from makers.convex import few_corners
from makers.soft_forms import bent, each_hull, footing, ring


def _straps(meshes: list[Mesh], h: float, back: float, half: float, mat: Material) -> None:
    """Two shoulder straps and a loop on top, at the back (-X)."""
    for q in (-1, 1):
        path = [(back, q * half * 0.45, h * 0.93), (back - 0.05, q * half * 0.6, h * 0.85)]
        path += [(back - 0.06, q * half * 0.75, h * 0.5), (back - 0.01, q * half * 0.8, h * 0.08)]
        meshes.append(bent(path, 0.02, mat, 5, 2, flatten=0.35, up=(1, 0, 0.1)))
    loop = [
        (back + 0.02, -0.03, h * 0.97),
        (back + 0.01, -0.02, h * 1.05),
        (back + 0.01, 0.02, h * 1.05),
    ]
    loop.append((back + 0.02, 0.03, h * 0.97))
    meshes.append(tube(np.array(loop), 0.008, 5, mat=mat))


def hiking(colour: str, second: str, trim: str, seed: int) -> Model:
    """A tall trekking rucksack: a lid, side pockets, a rolled mat under it, buckles."""
    rng = np.random.default_rng(seed)
    cloth, other = woven(colour, noise_offset(rng)), woven(second, noise_offset(rng))
    dark, pale = plain(trim, 0.05), plain("#d8d4c8", 0.05)
    rings = []
    for z, w, d in (
        (0.08, 0.12, 0.1),
        (0.1, 0.15, 0.13),
        (0.3, 0.16, 0.14),
        (0.48, 0.15, 0.125),
        (0.5, 0.12, 0.1),
    ):
        rings.append(superellipse(d, w, 3, 12, z))
    body = loft(rings, cloth)
    lid = loft(
        [
            superellipse(d, w, 3, 12, z) + np.array([0.01, 0, 0])
            for z, w, d in (
                (0.47, 0.15, 0.13),
                (0.5, 0.165, 0.145),
                (0.54, 0.15, 0.12),
                (0.56, 0.09, 0.07),
            )
        ],
        other,
    )
    roll = lathe(
        [(0, -0.2), (0.055, -0.2), (0.06, -0.19), (0.06, 0.19), (0.055, 0.2), (0, 0.2)],
        10,
        mat=plain("#c8a03a", 0.08, 60),
    )
    roll.turn(rx=math.pi / 2).move(0.03, 0, 0.062)
    pocket = loft(
        [
            superellipse(d, w, 3, 10, z) + np.array([0.13, 0, 0])
            for z, w, d in (
                (0.13, 0.09, 0.03),
                (0.15, 0.11, 0.05),
                (0.3, 0.105, 0.045),
                (0.32, 0.08, 0.02),
            )
        ],
        other,
    )
    meshes = [body, lid, roll, pocket]
    for q in (-1, 1):
        side = loft(
            [
                superellipse(d, 0.04, 2.6, 8, z) + np.array([0, q * 0.155, 0])
                for z, d in ((0.12, 0.05), (0.15, 0.07), (0.28, 0.065), (0.3, 0.04))
            ],
            other,
        )
        meshes.append(side)
        belt = [(0.135, q * 0.07, 0.53), (0.165, q * 0.075, 0.45), (0.15, q * 0.075, 0.36)]
        meshes.append(tube(np.array(belt), 0.012, 4, mat=dark, flatten=0.35, up=(1, 0, 0)))
        meshes.append(box(0.014, 0.034, 0.028, (0.168, q * 0.075, 0.42), pale))
        meshes.append(box(0.13, 0.02, 0.128, (0.03, q * 0.12, 0.0), dark))
    meshes.append(
        bent(
            [(0.1, 0.166, 0.16), (0.11, 0.2, 0.3), (0.06, 0.185, 0.42)],
            0.01,
            plain("#7fb4d0", 0.05),
            5,
            2,
        )
    )
    _straps(meshes, 0.52, -0.12, 0.13, dark)
    pieces = [*each_hull(meshes), footing(meshes)]
    return Model(
        "trekking rucksack", {"body": Part(meshes, collision=pieces)}, mass=4.0, friction=0.8
    )


def roll_top(colour: str, second: str, trim: str, seed: int) -> Model:
    """A city backpack with a rolled top and a buckled strap."""
    rng = np.random.default_rng(seed)
    cloth, leather = woven(colour, noise_offset(rng)), plain(second, 0.1, 30)
    steel = metal("b9bdc2", "6a7076")
    rings = []
    for z, w, d in (
        (0, 0.13, 0.065),
        (0.014, 0.14, 0.075),
        (0.3, 0.14, 0.07),
        (0.38, 0.15, 0.035),
        (0.41, 0.15, 0.02),
    ):
        rings.append(superellipse(d, w, 4, 12, z))
    body = loft(rings, mats=[cloth, leather], mat_of_face=lambda k, i: int(k == 0))
    roll = (
        lathe([(0, -0.15), (0.024, -0.15), (0.026, 0.0), (0.024, 0.15), (0, 0.15)], 9, mat=cloth)
        .turn(rx=math.pi / 2)
        .move(0.005, 0, 0.41)
    )
    base = loft([superellipse(0.078, 0.143, 4, 12, z) for z in (0.0, 0.09)], leather)
    strap = [(-0.05, 0, 0.4), (0.0, 0, 0.44), (0.035, 0, 0.42), (0.06, 0, 0.34), (0.085, 0, 0.22)]
    meshes = [
        body,
        roll,
        base,
        tube(np.array(strap), 0.022, 5, mat=leather, flatten=0.3, up=(1, 0, 1)),
    ]
    meshes.append(box(0.012, 0.055, 0.04, (0.082, 0, 0.22), steel))
    pocket = box(0.03, 0.17, 0.13, (0.08, 0, 0.07), cloth, 0.01)
    meshes += [pocket, box(0.008, 0.172, 0.018, (0.094, 0, 0.185), leather)]
    _straps(meshes, 0.4, -0.07, 0.12, leather)
    pieces = each_hull(meshes)
    return Model(
        "roll-top backpack", {"body": Part(meshes, collision=pieces)}, mass=1.8, friction=0.8
    )


def animal(colour: str, second: str, trim: str, seed: int) -> Model:
    """A small child's backpack with ears, eyes and a muzzle on its pocket."""
    rng = np.random.default_rng(seed)
    cloth, muzzle = plain(colour, 0.1, 90, noise_offset(rng)), plain(second, 0.08, 90)
    dark, pink = plain("#1d1a1a", 0), plain("#e89aa8", 0.04)
    rings = []
    for z, w, d in (
        (0, 0.09, 0.05),
        (0.012, 0.115, 0.068),
        (0.12, 0.128, 0.078),
        (0.22, 0.11, 0.065),
        (0.27, 0.07, 0.04),
        (0.285, 0.02, 0.015),
    ):
        rings.append(superellipse(d, w, 2.6, 14, z))
    body = loft(rings, cloth)
    meshes = [body, ellipsoid((0.03, 0.075, 0.05), (0.072, 0, 0.085), 12, 6, muzzle)]
    meshes.append(ellipsoid((0.014, 0.02, 0.014), (0.1, 0, 0.105), 8, 4, dark))
    zipper = [
        (0.066, -0.1, 0.15),
        (0.06, -0.09, 0.21),
        (0.045, 0, 0.258),
        (0.06, 0.09, 0.21),
        (0.066, 0.1, 0.15),
    ]
    meshes.append(tube(np.array(zipper), 0.005, 3, mat=plain(trim, 0.04)))
    for q in (-1, 1):
        meshes.append(ellipsoid((0.008, 0.014, 0.018), (0.072, q * 0.042, 0.165), 8, 5, dark))
        meshes.append(
            ellipsoid((0.004, 0.005, 0.006), (0.08, q * 0.039, 0.172), 5, 3, plain("#ffffff", 0))
        )
        meshes.append(ellipsoid((0.022, 0.036, 0.036), (0, q * 0.08, 0.275), 8, 5, cloth))
        meshes.append(ellipsoid((0.012, 0.022, 0.022), (0.014, q * 0.08, 0.277), 7, 4, pink))
    _straps(meshes, 0.27, -0.06, 0.1, plain(trim, 0.05))
    pieces = each_hull(meshes)
    return Model(
        "child's backpack", {"body": Part(meshes, collision=pieces)}, mass=0.7, friction=0.8
    )


def backpack(kind: str, colour: str, second: str, trim: str, seed: int, **more) -> Model:
    """A backpack: "school", "hiking", "rolltop" or "animal"."""
    if kind == "school":
        return bags.backpack(colour=colour, second=second, trim=trim, seed=seed, **more)
    make = {"hiking": hiking, "rolltop": roll_top, "animal": animal}[kind]
    return make(colour, second, trim, seed)


def backpack_any_random(rng: np.random.Generator) -> dict:
    return backpack_random(rng) | {"kind": "school"}


# ---- handbags
def tote(leather: str, trim: str) -> list[Mesh]:
    """An open shopper that widens upwards, on two long handles."""
    cloth, edge = woven(leather, (1.0, 2.0, 3.0), 300), plain(trim, 0.06)
    inner = plain(shade(leather, 0.5), 0.06)
    rings = []
    for z, d, w in ((0, 0.1, 0.3), (0.008, 0.11, 0.31), (0.27, 0.1, 0.38)):
        rings.append(np.c_[rounded_rectangle(d, w, 0.025, 3), np.full(12, z)])
    for z, d, w in ((0.27, 0.085, 0.365), (0.03, 0.09, 0.3)):
        rings.append(np.c_[rounded_rectangle(d, w, 0.02, 3), np.full(12, z)])
    body = loft(rings, mats=[cloth, inner], mat_of_face=lambda k, i: int(k >= 2))
    meshes = [body, box(0.113, 0.315, 0.05, (0, 0, 0), edge, 0.02)]
    for q in (-1, 1):
        x = q * 0.052
        arch = [(x, -0.09, 0.22), (x, -0.085, 0.32), (x * 0.9, -0.05, 0.41), (x * 0.8, 0.0, 0.43)]
        arch += [(x * 0.9, 0.05, 0.41), (x, 0.085, 0.32), (x, 0.09, 0.22)]
        meshes.append(tube(np.array(arch), 0.008, 5, mat=edge))
        meshes += [box(0.006, 0.026, 0.06, (x * 1.02, y, 0.18), edge) for y in (-0.09, 0.09)]
    return meshes


def shoulder(leather: str, trim: str) -> list[Mesh]:
    """A small flap bag with a gold clasp and a long chain laid beside it."""
    gold = metal("d8b45a", "8a6a24")
    quilt = Material()
    a = quilt.math(
        "SINE", quilt.math("MULTIPLY", quilt.math("ADD", quilt.axis(1), quilt.axis(2)), 150.0)
    )
    b = quilt.math(
        "SINE", quilt.math("MULTIPLY", quilt.math("SUBTRACT", quilt.axis(1), quilt.axis(2)), 150.0)
    )
    seam = quilt.math("MINIMUM", quilt.math("ABSOLUTE", a), quilt.math("ABSOLUTE", b))
    quilt.colour(
        quilt.mix(
            quilt.remap(seam, 0.0, 0.25, 0.7, 0),
            quilt.mottle(leather, 0.05, 40),
            shade(leather, 0.35),
        )
    )
    meshes = [box(0.075, 0.25, 0.16, (0, 0, 0), quilt, 0.014, 2)]
    flap = [
        (-0.036, 0.155),
        (-0.034, 0.17),
        (0.03, 0.17),
        (0.046, 0.15),
        (0.05, 0.06),
        (0.043, 0.055),
        (0.036, 0.15),
    ]
    meshes.append(extrude(np.array(flap), 0.246, quilt, axis="y", bevel_width=0.002))
    meshes.append(box(0.012, 0.045, 0.032, (0.05, 0, 0.062), gold, 0.004))
    chain = [
        (0, -0.118, 0.15),
        (0.01, -0.15, 0.28),
        (0.0, -0.08, 0.4),
        (0.0, 0.08, 0.4),
        (0.01, 0.15, 0.28),
        (0, 0.118, 0.15),
    ]
    meshes.append(bent(chain, 0.006, gold, 5, 3))
    meshes += [ellipsoid((0.012, 0.006, 0.014), (0, q * 0.122, 0.15), 7, 4, gold) for q in (-1, 1)]
    return meshes


def bucket_bag(leather: str, trim: str) -> list[Mesh]:
    """A round, gathered pouch with a drawstring and a strap."""
    skin, edge = plain(leather, 0.1, 30), plain(trim, 0.06)
    profile = [(0, 0), (0.1, 0), (0.112, 0.012), (0.115, 0.12), (0.1, 0.19), (0.062, 0.215)]
    profile += [(0.085, 0.25), (0.078, 0.252), (0.05, 0.215), (0, 0.2)]
    body = lathe(
        profile,
        18,
        mat=skin,
        rib=lambda k, i: 1 + (0.07 if i % 2 else -0.05) * (k in (4, 5, 6, 7, 8)),
        discs=False,
    )
    meshes = [body, lathe([(0.1, 0), (0.116, 0.01), (0.117, 0.05), (0.113, 0.05)], 18, mat=edge)]
    meshes.append(tube(ring(12, 0.066, 0.066, 0.215), 0.006, 4, closed=True, mat=edge))
    for q in (-1, 1):
        cord = [(0.066, q * 0.01, 0.215), (0.1, q * 0.025, 0.18), (0.122, q * 0.03, 0.1)]
        meshes.append(tube(np.array(cord), 0.005, 4, mat=edge))
        meshes.append(ellipsoid((0.011, 0.011, 0.02), (0.124, q * 0.03, 0.085), 7, 4, edge))
    strap = [
        (0, -0.085, 0.2),
        (0, -0.12, 0.3),
        (0, -0.06, 0.4),
        (0, 0.06, 0.4),
        (0, 0.12, 0.3),
        (0, 0.085, 0.2),
    ]
    meshes.append(bent(strap, 0.011, edge, 5, 2, flatten=0.45, up=(1, 0, 0)))
    return meshes


def doctor(leather: str, trim: str) -> list[Mesh]:
    """A bowling bag: rounded top, a zip over it, two stiff handles."""
    skin, edge, gold = plain(leather, 0.08, 25), plain(trim, 0.05), metal("d8b45a", "8a6a24")
    t = np.linspace(0, math.pi, 9)
    top = np.c_[0.165 * np.cos(t), 0.1 + 0.11 * np.sin(t)]
    outline = np.r_[[(-0.16, 0.0), (0.16, 0.0)], top]
    body = extrude(outline, 0.13, skin, axis="x", bevel_width=0.012)
    meshes = [body]
    for x in (-0.062, 0.062):
        loop = np.c_[np.full(len(outline), x), outline * [1.0, 1.0]]
        meshes.append(tube(loop, 0.006, 4, closed=True, mat=edge))
    arc = np.c_[np.zeros(9), top * [1.005, 1.01]]
    meshes.append(tube(arc, 0.007, 4, mat=plain("#1d1e21", 0)))
    meshes.append(box(0.012, 0.012, 0.035, (0.0, 0.1, 0.185), gold))
    for q in (-1, 1):
        x = q * 0.067
        h = [
            (x, -0.075, 0.12),
            (x, -0.07, 0.21),
            (x * 0.9, -0.03, 0.28),
            (x * 0.9, 0.03, 0.28),
            (x, 0.07, 0.21),
            (x, 0.075, 0.12),
        ]
        meshes.append(tube(np.array(h), 0.0085, 6, mat=edge))
        meshes += [box(0.008, 0.03, 0.05, (x, y, 0.1), edge) for y in (-0.075, 0.075)]
    return meshes


def handbag(kind: str, leather: str, trim: str, **more) -> Model:
    """A handbag: "framed", "tote", "shoulder", "bucket" or "bowling"."""
    if kind == "framed":
        return bags.handbag(leather=leather, trim=trim, **more)
    make = {"tote": tote, "shoulder": shoulder, "bucket": bucket_bag, "bowling": doctor}[kind]
    meshes = make(leather, trim)
    body = meshes[0].v
    points = np.concatenate([m.v for m in meshes])
    low, high = points.min(0), points.max(0)
    top = float(body[:, 2].max())
    pieces = [few_corners(body, 30)]
    if high[2] - top > 0.02:
        pieces.append(
            box_piece((0, 0, (top + high[2]) / 2), (0.03, (high[1] - low[1]) * 0.5, high[2] - top))
        )
    title = {
        "tote": "tote bag",
        "shoulder": "shoulder bag",
        "bucket": "bucket bag",
        "bowling": "handbag",
    }
    return Model(
        title[kind],
        {"body": Part(meshes, collision=pieces)},
        mass=0.9,
        friction=0.7,
        texture_size=128,
    )


def handbag_any_random(rng: np.random.Generator) -> dict:
    return handbag_random(rng) | {"kind": "framed"}


_SCHOOL = {"height": 0.43, "seed": 8}
_FRAMED = {"width": 0.3}

MODELS = {
    "backpack": Maker(
        backpack,
        backpack_any_random,
        7,
        [
            {"colour": "#2f5fa8", "second": "#f08a2c", "trim": "#1d2e50", **_SCHOOL},
            {"colour": "#3a3d44", "second": "#6a707a", "trim": "#1c1d20", **_SCHOOL},
            {"colour": "#c8304a", "second": "#3a3d55", "trim": "#5a1422", **_SCHOOL},
            {"kind": "hiking", "colour": "#3f6a4a", "second": "#c8702c", "trim": "#22251f"},
            {"kind": "rolltop", "colour": "#c8a860", "second": "#6a3f22", "trim": "#3a2a1c"},
            {"kind": "animal", "colour": "#b8834a", "second": "#efe0c4", "trim": "#c8302c"},
            {"kind": "animal", "colour": "#8a9098", "second": "#e8e8ea", "trim": "#2f5fa8"},
        ],
    ),
    "handbag": Maker(
        handbag,
        handbag_any_random,
        7,
        [
            {"leather": "#a8502c", "trim": "#6a2f18", **_FRAMED},
            {"leather": "#26282c", "trim": "#3c3e44", "flap": False, **_FRAMED},
            {"leather": "#b8304a", "trim": "#7a1c2e", **_FRAMED},
            {"kind": "tote", "leather": "#e0d4b8", "trim": "#8a5a34"},
            {"kind": "shoulder", "leather": "#2a2428", "trim": "#1c1a1c"},
            {"kind": "bucket", "leather": "#7a3f5a", "trim": "#4a2438"},
            {"kind": "bowling", "leather": "#2f6a70", "trim": "#6a3f22"},
        ],
    ),
}
