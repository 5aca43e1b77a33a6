"""Vacuum cleaners: canister, upright, stick, drum, robot."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, glowing, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import (
    box,
    ellipsoid,
    lathe,
    loft,
    rounded_rectangle,
    spline,
    superellipse,
    tube,
)

from makers.convex import few_corners
from makers.projection import project_label
from makers.soft_forms import bent, each_hull


def _ribbed(points: list, radius: float, per_span: int = 4) -> Mesh:
    """A corrugated hose: the ribs are drawn along its length."""
    m = Material()
    mesh = tube(spline(points, 2), radius, 6, mat=m, weight=0.8)
    turns = canvas(8, 256, "#26282c")
    for k in range(32):
        turns[1].rectangle((0, 8 * k, 8, 8 * k + 3), fill="#5a5e64")
    m.colour(m.image(turns[0]))
    return mesh


def _wheel(r: float, wide: float, mats: list[Material]) -> Mesh:
    if r < 0.04:
        profile = [(0, -wide / 2), (r, -wide / 2), (r, wide / 2), (0, wide / 2)]
        return lathe(profile, 7, mat=mats[0]).turn(rx=math.pi / 2)
    profile = [(0, -wide / 2), (r * 0.6, -wide / 2), (r, -wide / 2), (r, wide / 2)]
    profile += [(r * 0.6, wide / 2), (0, wide / 2)]
    return lathe(profile, 12, mats=mats, mat_of_segment=[1, 0, 0, 0, 1]).turn(rx=math.pi / 2)


def _nozzle(wide: float, long: float, mat: Material) -> list[Mesh]:
    """A floor nozzle, its neck at the origin's height, reaching to +X."""
    rings = []
    for z, f in ((0.004, 0.96), (0.02, 1.0), (0.04, 0.9), (0.05, 0.6)):
        o = rounded_rectangle(long * f, wide * f, 0.02, 3)
        rings.append(np.c_[o, np.full(12, z)])
    neck = bent([(-0.01, 0, 0.03), (-0.05, 0, 0.05), (-0.08, 0, 0.1)], 0.02, mat, 7, 2)
    return [loft(rings, mat), neck]


def _name(words: str, ground: str, ink: str) -> Material:
    picture, draw = canvas(192, 64, ground)
    text(draw, words, (8, 8, 184, 56), "oblique", ink)
    return printed(picture)


def canister(colour: str, trim: str) -> tuple[list[Mesh], list[np.ndarray], float]:
    """A body on two big wheels; hose, bent wand and nozzle."""
    shell, dark, chrome = plain(colour, 0.03, 20), plain(trim, 0.04), metal("c8ccd0", "878d93")
    rings = []
    for x, w, h, z in (
        (-0.2, 0.1, 0.08, 0.1),
        (-0.185, 0.17, 0.16, 0.12),
        (-0.06, 0.22, 0.21, 0.135),
        (0.1, 0.2, 0.17, 0.12),
        (0.185, 0.13, 0.1, 0.1),
        (0.2, 0.06, 0.05, 0.1),
    ):
        ring = superellipse(h / 2, w / 2, 2.8, 12)
        rings.append(np.c_[np.full(12, x), ring[:, 1], z + ring[:, 0]])
    body = loft(rings, shell)
    meshes = [body]
    for q in (-1, 1):
        meshes.append(_wheel(0.09, 0.035, [dark, shell]).move(-0.09, q * 0.115, 0.09))
    meshes.append(_wheel(0.026, 0.03, [dark, dark]).move(0.14, 0, 0.026))
    handle = [(-0.14, 0, 0.22), (-0.1, 0, 0.27), (0.02, 0, 0.265), (0.06, 0, 0.215)]
    meshes.append(bent(handle, 0.013, dark, 5, 1))
    meshes.append(ellipsoid((0.03, 0.03, 0.012), (-0.17, 0.0, 0.19), 7, 3, plain("#c8302c", 0)))
    hose = [
        (0.2, 0, 0.11),
        (0.3, 0.0, 0.16),
        (0.38, 0.12, 0.12),
        (0.3, 0.26, 0.05),
        (0.12, 0.3, 0.04),
        (-0.04, 0.32, 0.14),
        (-0.06, 0.33, 0.36),
        (-0.02, 0.33, 0.62),
    ]
    meshes.append(_ribbed(hose[:-3] + hose[-2:], 0.021, 3))
    grip, foot = (-0.02, 0.33, 0.62), (0.36, 0.33, 0.09)
    meshes.append(bent([grip, (0.02, 0.33, 0.72), (0.09, 0.33, 0.7)], 0.02, dark, 7, 2))
    meshes.append(
        tube([(0.08, 0.33, 0.7), (0.22, 0.33, 0.4), foot], [0.018, 0.018, 0.018], 8, mat=chrome)
    )
    meshes += [m.move(0.43, 0.33, 0) for m in _nozzle(0.27, 0.1, dark)]
    pieces = [
        few_corners(body.v, 26),
        box_piece((-0.09, 0, 0.09), (0.17, 0.26, 0.17)),
        few_corners(meshes[-2].v, 16),
    ]
    pieces.append(np.r_[few_corners(meshes[-3].v, 12)])
    return meshes, pieces, 5.5


def upright(colour: str, trim: str) -> tuple[list[Mesh], list[np.ndarray], float]:
    """A floor head with a bag body and a handle leaning back."""
    shell, dark, chrome = plain(colour, 0.03, 20), plain(trim, 0.04), metal("c8ccd0", "878d93")
    head = []
    for z, f, x in (
        (0.01, 0.96, 0.0),
        (0.035, 1.0, 0.0),
        (0.075, 0.86, -0.01),
        (0.095, 0.6, -0.03),
    ):
        o = rounded_rectangle(0.26 * f, 0.32 * f, 0.04, 3)
        head.append(np.c_[o + np.array([x, 0]), np.full(12, z)])
    meshes = [loft(head, dark)]
    meshes.append(box(0.02, 0.2, 0.024, (0.125, 0, 0.03), plain("#e8f0ff", 0), 0.003))
    rings = []
    for z, w, d, x in (
        (0.09, 0.15, 0.12, -0.05),
        (0.13, 0.2, 0.16, -0.055),
        (0.42, 0.22, 0.17, -0.09),
        (0.56, 0.17, 0.13, -0.105),
        (0.6, 0.08, 0.07, -0.11),
    ):
        ring = superellipse(d / 2, w / 2, 3, 14, z)
        rings.append(ring + np.array([x, 0, 0]))
    body = loft(rings, shell)
    project_label(
        body,
        _name("SWIRL", colour, "#ffffff"),
        "+x",
        (0, 0.5),
        (0.15, 0.06),
        0.6,
        lambda c: 0.42 < c[2] < 0.56,
    )
    meshes.append(body)
    cup = lathe(
        [(0, 0.13), (0.062, 0.13), (0.066, 0.15), (0.066, 0.34), (0.05, 0.37), (0, 0.37)],
        12,
        mat=plain("#9fb8c4", 0.1, 14),
    )
    meshes.append(cup.move(0.0, 0, 0))
    meshes.append(tube([(-0.11, 0, 0.58), (-0.16, 0, 0.98)], 0.014, 7, mat=chrome))
    loop = [(-0.16, 0, 0.96), (-0.18, 0, 1.06), (-0.13, 0, 1.12), (-0.09, 0, 1.08), (-0.13, 0, 1.0)]
    meshes.append(bent(loop, 0.017, dark, 6, 2))
    for q in (-1, 1):
        meshes.append(_wheel(0.055, 0.03, [dark, shell]).move(-0.12, q * 0.12, 0.055))
    meshes.append(
        _ribbed(
            [(-0.12, 0.1, 0.12), (-0.19, 0.11, 0.3), (-0.2, 0.06, 0.5), (-0.13, 0.03, 0.58)],
            0.018,
            2,
        )
    )
    pieces = [
        few_corners(meshes[0].v, 22),
        few_corners(body.v, 24),
        box_piece((-0.14, 0, 0.85), (0.05, 0.05, 0.56)),
    ]
    pieces.append(box_piece((-0.12, 0, 0.055), (0.1, 0.27, 0.11)))
    return meshes, pieces, 6.5


def stick(colour: str, trim: str) -> tuple[list[Mesh], list[np.ndarray], float]:
    """A cordless stick cleaner standing in its floor dock."""
    shell, dark, chrome = plain(colour, 0.03, 20), plain(trim, 0.04), metal("b8a0d8", "7a5a9a")
    meshes = [box(0.3, 0.32, 0.018, (0, 0, 0), plain("#d8dadc", 0.03), 0.005)]
    meshes.append(tube([(-0.1, 0, 0.015), (-0.1, 0, 0.72)], 0.016, 6, mat=plain("#d8dadc", 0.03)))
    meshes.append(box(0.1, 0.05, 0.04, (-0.06, 0, 0.68), plain("#d8dadc", 0.03), 0.006))
    meshes += [m.move(0.03, 0, 0.018) for m in _nozzle(0.25, 0.11, dark)]
    meshes.append(tube([(-0.03, 0, 0.1), (-0.03, 0, 0.76)], 0.019, 8, mat=chrome))
    cyclone = lathe(
        [
            (0, 0.74),
            (0.04, 0.74),
            (0.052, 0.76),
            (0.052, 0.88),
            (0.06, 0.89),
            (0.06, 0.95),
            (0.03, 0.98),
            (0, 0.98),
        ],
        14,
        mats=[plain("#a8bcc8", 0.1, 14), shell],
        mat_of_segment=[0, 0, 0, 1, 1, 1, 1],
    )
    meshes.append(cyclone.move(-0.03, 0, 0))
    loop = [
        (-0.07, 0, 0.93),
        (-0.15, 0, 0.95),
        (-0.165, 0, 0.83),
        (-0.13, 0, 0.76),
        (-0.06, 0, 0.78),
    ]
    meshes.append(bent(loop, 0.017, dark, 6, 2))
    meshes.append(box(0.07, 0.07, 0.05, (-0.15, 0, 0.74), dark, 0.008))
    meshes.append(box(0.014, 0.012, 0.026, (-0.115, 0, 0.86), plain("#c8302c", 0)))
    pieces = [
        box_piece((0, 0, 0.009), (0.3, 0.32, 0.018)),
        box_piece((-0.07, 0, 0.5), (0.17, 0.1, 0.96)),
    ]
    pieces.append(few_corners(meshes[3].v, 16))
    return meshes, pieces, 3.5


def drum(colour: str, trim: str) -> tuple[list[Mesh], list[np.ndarray], float]:
    """A workshop cleaner: a drum on castors with a lid motor and a hose around it."""
    steel, dark, lid = plain(colour, 0.05, 20), plain(trim, 0.04), plain(shade(colour, 0.5), 0.03)
    profile = [
        (0, 0.06),
        (0.15, 0.06),
        (0.17, 0.08),
        (0.175, 0.34),
        (0.182, 0.35),
        (0.182, 0.38),
        (0.17, 0.4),
    ]
    profile += [(0.12, 0.47), (0.07, 0.5), (0, 0.505)]
    body = lathe(profile, 18, mats=[steel, dark], mat_of_segment=[0, 0, 0, 1, 1, 1, 1, 1, 1])
    meshes = [body]
    band = _name("TURBOVAC", "#f2f0ea", trim)
    project_label(body, band, "+x", (0, 0.22), (0.24, 0.08), 0.75, lambda c: 0.1 < c[2] < 0.3)
    meshes.append(
        bent(
            [(0, -0.08, 0.48), (0, -0.06, 0.54), (0, 0.06, 0.54), (0, 0.08, 0.48)], 0.015, lid, 6, 2
        )
    )
    meshes.append(ellipsoid((0.03, 0.03, 0.02), (0.11, 0, 0.475), 9, 4, plain("#c8302c", 0)))
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        x, y = 0.16 * math.cos(a), 0.16 * math.sin(a)
        meshes.append(_wheel(0.03, 0.024, [dark, dark]).move(x, y, 0.03))
        meshes.append(box(0.05, 0.05, 0.03, (x * 0.95, y * 0.95, 0.05), dark))
    hose = [
        (0.17, 0.06, 0.3),
        (0.26, 0.1, 0.3),
        (0.28, 0.24, 0.2),
        (0.16, 0.34, 0.12),
        (-0.02, 0.33, 0.2),
        (-0.06, 0.28, 0.4),
        (0.02, 0.22, 0.56),
        (0.1, 0.2, 0.45),
    ]
    meshes.append(_ribbed(hose, 0.024, 3))
    meshes.append(
        tube(
            [(0.1, 0.2, 0.46), (0.16, 0.2, 0.25), (0.19, 0.2, 0.12)],
            [0.026, 0.022, 0.018],
            8,
            mat=dark,
        )
    )
    pieces = [cylinder_piece(0.18, 0.05, 0.4, 12), cylinder_piece(0.17, 0.4, 0.5, 12, 0.07)]
    pieces.append(box_piece((0, 0, 0.03), (0.27, 0.27, 0.06)))
    return meshes, pieces, 7.0


def robot(colour: str, trim: str) -> tuple[list[Mesh], list[np.ndarray], float]:
    """A flat round robot with a bumper, a turret, a lit button and side brushes."""
    shell, dark = plain(colour, 0.03, 20), plain(trim, 0.04)
    profile = [
        (0, 0.008),
        (0.15, 0.008),
        (0.17, 0.018),
        (0.172, 0.07),
        (0.16, 0.086),
        (0.15, 0.088),
        (0, 0.09),
    ]
    body = lathe(profile, 26, mats=[dark, shell], mat_of_segment=[0, 0, 0, 0, 1, 1])
    meshes = [body]
    turret = lathe(
        [(0, 0.09), (0.048, 0.088), (0.046, 0.108), (0.03, 0.112), (0, 0.112)], 16, mat=dark
    )
    meshes.append(turret.move(-0.05))
    bumper = []
    for t in np.linspace(-1.35, 1.35, 11):
        c, s = math.cos(t), math.sin(t)
        bumper.append(
            [
                (0.168 * c, 0.168 * s, 0.02),
                (0.182 * c, 0.182 * s, 0.026),
                (0.182 * c, 0.182 * s, 0.066),
                (0.168 * c, 0.168 * s, 0.07),
            ]
        )
    meshes.append(loft(bumper, plain(shade(trim, 1.8), 0.04)))
    meshes.append(
        lathe(
            [(0, 0.086), (0.024, 0.089), (0.02, 0.094), (0, 0.094)], 12, mat=glowing("5ac8ff")
        ).move(0.07)
    )
    meshes.append(
        lathe(
            [(0.028, 0.086), (0.031, 0.092), (0.026, 0.092), (0.028, 0.086)],
            14,
            mat=plain("#c8ccd0", 0),
        ).move(0.07)
    )
    meshes.append(
        box(0.09, 0.16, 0.003, (-0.0, 0, 0.0885), plain(shade(colour, 0.82), 0.02)).move(-0.05)
    )
    white = plain("#f2f2ee", 0.05)
    for q in (-1, 1):
        for k in range(3):
            a = 0.3 + k * math.tau / 3
            meshes.append(
                tube(
                    [
                        (0.13, q * 0.1, 0.006),
                        (0.13 + 0.075 * math.cos(a), q * (0.1 + 0.075 * math.sin(a)), 0.004),
                    ],
                    [0.006, 0.0035],
                    4,
                    mat=white,
                )
            )
    return meshes, [cylinder_piece(0.175, 0, 0.088, 16)], 3.2


def vacuum_cleaner(kind: str, colour: str, trim: str) -> Model:
    """A vacuum cleaner: "canister", "upright", "stick", "drum" or "robot"."""
    make = {"canister": canister, "upright": upright, "stick": stick, "drum": drum, "robot": robot}
    meshes, pieces, mass = make[kind](colour, trim)
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for m in meshes:
        m.move(z=-low)
    pieces = [np.asarray(p) - [0, 0, low] for p in pieces] + each_hull(meshes[3:], 0.12)
    names = {"canister": "vacuum cleaner", "drum": "workshop vacuum cleaner"}
    title = names.get(kind, f"{kind} vacuum cleaner")
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass=mass)


def vacuum_cleaner_random(rng: np.random.Generator) -> dict:
    return {
        "kind": pick(rng, ["canister", "upright"]),
        "colour": pick(rng, ["#b8242c", "#2f5f94"]),
        "trim": "#2a2b2e",
    }


MODELS = {
    "vacuum_cleaner": Maker(
        vacuum_cleaner,
        vacuum_cleaner_random,
        7,
        [
            {"kind": "canister", "colour": "#b8242c", "trim": "#2a2b2e"},
            {"kind": "upright", "colour": "#5a3f8a", "trim": "#2a2b2e"},
            {"kind": "stick", "colour": "#8a4ab0", "trim": "#3a3c40"},
            {"kind": "drum", "colour": "#d8a02c", "trim": "#26282c"},
            {"kind": "robot", "colour": "#f0f0ee", "trim": "#3a3d42"},
            {"kind": "canister", "colour": "#2f6fb0", "trim": "#26282c"},
            {"kind": "upright", "colour": "#2f8a6a", "trim": "#26282c"},
        ],
    ),
}
