"""Irons and ironing boards."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import Material, glowing, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, Support, box_piece, rectangle
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, extrude, lathe, loft, tube

from makers.convex import few_corners
from makers.joinery import steel
from makers.projection import project_label
from makers.soft_forms import bars, bent, each_hull


# ---- irons: made lying, the tip to +X
def _boat(length: float, width: float, n: int = 6) -> np.ndarray:
    """A soleplate's outline."""
    t = np.linspace(0, 1, n)
    x = -length / 2 + length * t
    y = width / 2 * np.clip(1 - t**2.6, 0, 1) ** 0.75
    y[0] *= 0.86
    return np.r_[np.c_[x, -y], np.c_[x, y][-2::-1]]


def _iron_body(s: float, colour: str, accent: str, tank: bool) -> list[Mesh]:
    """Soleplate, shell, handle, dial, water window."""
    shell, dark, sole = plain(colour, 0.03, 20), plain(accent, 0.04), steel(60)
    p = _boat(0.24, 0.115)
    n = len(p)
    meshes = [extrude(p, 0.014, sole)]
    rings = []
    for z, fx, fy, shift in (
        (0.014, 0.97, 0.96, 0.0),
        (0.035, 0.95, 0.94, 0.0),
        (0.062, 0.84, 0.74, -0.006),
        (0.078, 0.66, 0.5, -0.02),
    ):
        rings.append(np.c_[p[:, 0] * fx + shift, p[:, 1] * fy, np.full(n, z)])
    meshes.append(loft(rings, shell))
    rear = [
        (-0.108, 0, 0.06),
        (-0.118, 0, 0.11),
        (-0.1, 0, 0.142),
        (-0.03, 0, 0.15),
        (0.03, 0, 0.138),
    ]
    rear += [(0.056, 0, 0.11), (0.05, 0, 0.066)]
    meshes.append(tube(np.array(rear), 0.0175, 6, mat=dark, up=(0, 1, 0)))
    meshes.append(box(0.03, 0.09, 0.07, (-0.112, 0, 0.014), dark, 0.008))
    dial = lathe([(0.026, 0), (0.022, 0.014), (0, 0.014)], 12, mat=plain("#e8e8e4", 0.03))
    meshes.append(dial.move(-0.02, 0, 0.076))
    meshes.append(box(0.02, 0.004, 0.003, (-0.012, 0, 0.09), plain("#c8302c", 0)))
    if tank:
        window = plain("#9fd0e8", 0.05)
        meshes.append(loft([r * [0.55, 1.02, 1] + [0.028, 0, 0] for r in rings[1:3]], window))
        meshes.append(ellipsoid((0.014, 0.014, 0.01), (0.052, 0, 0.078), 8, 4, plain("#5a9ac8", 0)))
        for y in (-0.012, 0.012):
            meshes.append(box(0.016, 0.014, 0.01, (0.036, y, 0.142), plain("#e8e8e4", 0), 0.003))
    for m in meshes:
        m.scale(s)
    return meshes


def _cord(points: list, mat: Material) -> Mesh:
    return bent(points, 0.005, mat, 4, 2)


def _puff(at, scale: float) -> list[Mesh]:
    """A cloud of steam."""
    mat = Material(occlusion=0.3)
    mat.colour(mat.mottle("#f4f8fa", 0.05, 30))
    blobs = (
        (0, 0, 0, 0.03),
        (0.03, 0.02, 0.03, 0.036),
        (-0.02, -0.02, 0.045, 0.032),
        (0.0, 0.0, 0.085, 0.04),
    )
    return [
        ellipsoid(r * scale, (at[0] + x * scale, at[1] + y * scale, at[2] + z * scale), 6, 4, mat)
        for x, y, z, r in blobs
    ]


def iron(kind: str, colour: str, accent: str, cord: str) -> Model:
    """A steam iron: "standing" on its heel, "lying", a "station" on its tank, "old" (cast)."""
    dark_cord, lamp_at = plain(cord or "#2a2b2e", 0.04), np.array([-0.06, 0.0, 0.083])
    if kind == "old":
        p = _boat(0.2, 0.11)
        black = plain(colour, 0.12, 60)
        rings = [
            np.c_[p * f, np.full(len(p), z)]
            for z, f in ((0, 1), (0.012, 1.01), (0.04, 0.97), (0.055, 0.9))
        ]
        meshes = [loft(rings, mats=[steel(60), black], mat_of_face=lambda k, i: int(k > 0))]
        for x in (-0.06, 0.05):
            meshes.append(tube([(x, 0, 0.05), (x, 0, 0.12)], 0.009, 6, mat=black))
        grip = plain(accent, 0.12, 30)
        meshes.append(
            tube(
                [(-0.085, 0, 0.126), (-0.04, 0, 0.13), (0.035, 0, 0.13), (0.075, 0, 0.126)],
                [0.014, 0.02, 0.02, 0.014],
                8,
                mat=grip,
            )
        )
        s = 1.0
    else:
        s = 0.85 if kind == "travel" else 1.0
        meshes = _iron_body(s, colour, accent, True)
        if kind != "station":
            tail = [
                (-0.115, 0, 0.125),
                (-0.16, 0.01, 0.13),
                (-0.2, 0.05, 0.06),
                (-0.19, 0.12, 0.006),
            ]
            tail += [(-0.1, 0.15, 0.006), (-0.02, 0.13, 0.006)]
            if kind == "standing":
                tail = [
                    (-0.115, 0, 0.125),
                    (-0.12, 0.03, 0.15),
                    (-0.118, 0.08, 0.17),
                    (-0.119, 0.14, 0.12),
                    (-0.119, 0.13, 0.04),
                ]
            cable = _cord([tuple(np.array(q) * s) for q in tail], dark_cord)
            meshes.append(cable)
            meshes.append(
                tube([(-0.1 * s, 0, 0.12 * s), (-0.135 * s, 0, 0.128 * s)], 0.009, 6, mat=dark_cord)
            )
    # what shows that it is hot: a red rim along the sole, a lamp, steam
    p = _boat(0.24 if kind != "old" else 0.2, 0.115 if kind != "old" else 0.11) * s
    hot = glowing("ff5a1e")
    rim = [
        np.c_[p * f, np.full(len(p), z * s)]
        for z, f in ((0.001, 1.035), (0.0145, 1.035), (0.008, 0.94))
    ]
    glow = [loft([*rim, rim[0]], hot, caps=(False, False)).outward()]
    lamp = lamp_at * s
    if kind != "old":
        glow.append(ellipsoid(0.011, lamp, 5, 4, glowing("ff2a18")))
        meshes.append(ellipsoid(0.008, lamp, 5, 3, plain("#4a1814", 0)))
    steam = _puff((0.1 * s, 0, 0.05), 0.9)
    groups = [meshes, glow, steam]
    if kind == "standing":
        for group in groups:
            for m in group:
                m.turn(ry=-math.pi / 2 + 0.0)
        steam[:] = _puff((-0.03, 0.0, 0.27), 0.9)
        low = min(float(m.v[:, 2].min()) for m in meshes)
        for group in groups[:2]:
            for m in group:
                m.move(z=-low)
    elif kind == "station":
        tank = plain(shade(colour, 0.92), 0.03, 20)
        p2 = _boat(0.36, 0.25)
        rings = [
            np.c_[p2 * f, np.full(len(p2), z)]
            for z, f in ((0, 0.94), (0.02, 1), (0.1, 0.98), (0.125, 0.8))
        ]
        base = [loft(rings, tank)]
        base.append(
            loft([r * [0.9, 1.02, 1] + [0.03, 0, 0] for r in rings[1:3]], plain("#9fd0e8", 0.05))
        )
        base.append(box(0.012, 0.16, 0.05, (-0.182, 0, 0.03), plain(accent, 0.04)))
        dial = lathe([(0.024, 0), (0.02, 0.016), (0, 0.016)], 8, mat=plain("#e8e8e4", 0.02))
        base.append(dial.move(-0.14, 0.0, 0.118))
        for group in groups:
            for m in group:
                m.turn(ry=-0.2).move(0.02, 0, 0.15)
        steam.pop()
        hose = [
            (-0.1, 0.0, 0.29),
            (-0.2, 0.06, 0.3),
            (-0.24, 0.12, 0.15),
            (-0.16, 0.15, 0.03),
            (-0.08, 0.115, 0.05),
        ]
        base.append(bent(hose, 0.009, dark_cord, 5, 1))
        meshes += base
    pieces = each_hull(meshes[: 6 if kind == "old" else 3], 0.03, 22)
    if kind == "station":
        pieces.append(few_corners(base[0].v, 26))
    parts = {
        "body": Part(meshes, collision=pieces),
        "glow": Part(glow, collision="none", rgba=(1.7, 1.7, 1.7, 1.0)),
        "steam": Part(steam, collision="none", rgba=(1.15, 1.15, 1.15, 0.999)),
    }
    hot_parts = ["glow"] if kind == "old" else ["glow", "steam"]
    if kind == "old":
        del parts["steam"]
    title = {
        "standing": "steam iron on its heel",
        "lying": "steam iron",
        "station": "steam iron station",
        "travel": "travel iron",
        "old": "cast iron flat-iron",
    }
    return Model(
        title[kind],
        parts,
        mass=3.5 if kind == "station" else 1.2,
        variants={"default": ["body"], "on": ["body", *hot_parts]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": hot_parts},
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
        ],
        front="-y",
        texture_size=128,
    )


def iron_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "lying",
        "colour": pick(rng, ["#f0f0ec", "#3f6fa8"]),
        "accent": "#2f5f94",
        "cord": "#2a2b2e",
    }


# ---- ironing boards
def _cover(colours: list[str], pattern: str) -> Material:
    return printed(prints.woven(colours, pattern))


def ironing_board(kind: str, colours: list[str], pattern: str) -> Model:
    """An ironing board: "open" on crossed legs, "folded" lying, "table" (short legs), "sleeve"."""
    long, wide = {
        "open": (1.2, 0.36),
        "folded": (1.2, 0.36),
        "table": (0.78, 0.32),
        "wide": (1.25, 0.45),
    }[kind]
    top_z = {"open": 0.88, "folded": 0.1, "table": 0.2, "wide": 0.9}[kind]
    n = 8
    t = np.linspace(0, 1, n)
    x = -long / 2 + long * t
    y = wide / 2 * np.interp(t, [0, 0.04, 0.55, 0.8, 0.95, 1], [0.85, 1, 1, 0.72, 0.34, 0.1])
    p = np.r_[np.c_[y, x], np.c_[-y, x][::-1]]
    cloth, side = _cover(colours, pattern), plain(shade(colours[1], 0.85), 0.06)
    rings = [
        np.c_[p * f, np.full(len(p), z)]
        for z, f in ((top_z - 0.035, 0.96), (top_z - 0.012, 1.0), (top_z, 0.965))
    ]
    board = loft(rings, mats=[side])
    project_label(board, cloth, "+z", (0, 0), (0.5, 0.5), 0.8)
    for i, face in enumerate(board.f):  # the pattern repeats along the board
        if board.mi[i]:
            board.label_uv[i] = [
                (board.v[j][1] / long + 0.5, board.v[j][0] / long * 0.5 + 0.5) for j in face
            ]
            board.bake_uv[i] = [(5 + board.v[j][1], -board.v[j][0]) for j in face]
    leg, foot = metal("c8ccd0", "878d93"), plain("#2a2b2e", 0.04)
    meshes = [board]
    pieces = [np.r_[np.c_[p, np.full(len(p), top_z - 0.035)], rings[-1]]]
    under = top_z - 0.035
    if kind in ("open", "wide"):
        a, b = 0.46 * long, 0.3 * long
        for q, (y0, y1) in ((-0.16, (-a, b)), (0.16, (a, -b))):
            for s in (-1, 1):
                x0 = s * (0.13 if q < 0 else 0.1)
                meshes.append(tube([(x0, y0, 0.015), (x0, y1, under)], 0.011, 5, mat=leg))
            meshes.append(tube([(-0.2, y0, 0.016), (0.2, y0, 0.016)], 0.014, 6, mat=foot))
        meshes += bars(
            [[(-0.13, 0.1 * long, under * 0.6), (0.13, 0.1 * long, under * 0.6)]], 0.008, leg
        )
        end = -long / 2
        rest = [
            (-0.12, end + 0.02, under),
            (-0.12, end - 0.2, under + 0.01),
            (0.12, end - 0.2, under + 0.01),
            (0.12, end + 0.02, under),
        ]
        meshes.append(tube(np.array(rest), 0.008, 5, mat=leg))
        for k in range(3):
            yy = end - 0.05 - 0.06 * k
            meshes.append(
                tube([(-0.12, yy, under + 0.008), (0.12, yy, under + 0.008)], 0.005, 4, mat=leg)
            )
        for s in (-1, 1):
            slant = [
                np.array([(0.1 * s + d, s2 * y_, z_) for d in (-0.03, 0.03)])
                for s2, y_, z_ in ((1, a, 0), (1, -b, under))
            ]
            pieces.append(
                np.concatenate([q + np.array([0, 0, e]) for q in slant for e in (0, 0.02)])
            )
            slant = [
                np.array([(0.1 * s + d, y_, z_) for d in (-0.03, 0.03)])
                for y_, z_ in ((-a, 0), (b, under))
            ]
            pieces.append(
                np.concatenate([q + np.array([0, 0, e]) for q in slant for e in (0, 0.02)])
            )
        if kind == "wide":
            arm = [
                np.c_[p * [0.35, 0.36] + [0, -0.0], np.full(len(p), top_z + z)]
                for z in (0.07, 0.09)
            ]
            sleeve = loft(arm, side)
            meshes.append(sleeve.move(0, -long * 0.26, 0.02))
            meshes += bars(
                [[(0, -long * 0.4, top_z - 0.01), (0, -long * 0.4, top_z + 0.1)]], 0.012, leg, 6
            )
    elif kind == "table":
        for q in (-1, 1):
            yy = q * long * 0.3
            bow = [
                (-0.12, yy + q * 0.06, 0.01),
                (-0.1, yy, under),
                (0.1, yy, under),
                (0.12, yy + q * 0.06, 0.01),
            ]
            meshes.append(tube(np.array(bow), 0.011, 5, mat=leg))
            meshes += bars(
                [[(-0.13, yy + q * 0.06, 0.012), (0.13, yy + q * 0.06, 0.012)]], 0.014, foot
            )
            pieces.append(box_piece((0, yy + q * 0.03, under / 2), (0.26, 0.09, under)))
    else:  # folded flat, the legs under the board
        for s in (-1, 1):
            meshes.append(
                tube(
                    [(0.12 * s, -0.55 * long, 0.016), (0.12 * s, 0.42 * long, 0.04)],
                    0.012,
                    5,
                    mat=leg,
                )
            )
        for yy in (-0.55, 0.4):
            meshes.append(
                tube([(-0.19, yy * long, 0.016), (0.19, yy * long, 0.016)], 0.015, 6, mat=foot)
            )
        pieces.append(box_piece((0, -0.06 * long, 0.03), (0.28, 0.96 * long, 0.06)))
    span, mid = (0.3, 0.1) if kind == "wide" else (0.55, -0.13)
    surface = Support("top", top_z, rectangle(wide * 0.74, long * span, 0, long * mid))
    title = {
        "open": "ironing board",
        "wide": "ironing board with a sleeve board",
        "table": "table-top ironing board",
        "folded": "ironing board, folded",
    }
    return Model(
        title[kind],
        {"body": Part(meshes, collision=pieces)},
        mass=2.5 if kind == "table" else 6.0,
        supports=[surface],
    )


def ironing_board_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "open",
        "colours": pick(
            rng, [["#e8ecf0", "#3f6fa8", "#c8d8e8"], ["#f0e8dc", "#b8505a", "#e8c8b8"]]
        ),
        "pattern": "stripes",
    }


_BOARD = ["#e8ecf0", "#3f6fa8", "#c8d8e8"]

MODELS = {
    "iron": Maker(
        iron,
        iron_random,
        7,
        [
            {"kind": "standing", "colour": "#f0f0ec", "accent": "#2f5f94", "cord": "#2a2b2e"},
            {"colour": "#7a4a9a", "accent": "#2a2b2e", "cord": "#2a2b2e"},
            {"kind": "station", "colour": "#f0f0ec", "accent": "#2a2b2e", "cord": "#3a3c40"},
            {"kind": "old", "colour": "#2b2a2a", "accent": "#8a5a34", "cord": ""},
            {"kind": "standing", "colour": "#c8303a", "accent": "#26282c", "cord": "#e8e8e4"},
            {"colour": "#2f8f86", "accent": "#f0f0ec", "cord": "#e8e8e4"},
            {"kind": "travel", "colour": "#e8e0cc", "accent": "#c86a3a", "cord": "#2a2b2e"},
        ],
    ),
    "ironing_board": Maker(
        ironing_board,
        ironing_board_random,
        6,
        [
            {"colours": _BOARD},
            {"kind": "table", "colours": ["#f0e8dc", "#b8505a", "#e8c8b8"], "pattern": "check"},
            {"kind": "folded", "colours": ["#e8e4d8", "#4f8a6a", "#a8c8b0"], "pattern": "leaves"},
            {"kind": "wide", "colours": ["#f2f0ea", "#c8703a", "#e8c08a"], "pattern": "diamonds"},
            {"colours": ["#f0e0e4", "#a84a6a", "#e8b8c8"], "pattern": "leaves"},
            {"kind": "table", "colours": _BOARD, "pattern": "stripes"},
        ],
    ),
}
