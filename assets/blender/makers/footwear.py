"""Pairs of shoes; one shoe is made toes to +X and mirrored."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, loft, spline, tube

from makers.convex import few_corners
from makers.shoes import CENTRE, HALF_WIDTH, SOLE_TOP, STATIONS, loafer, sneaker, sole_of, upper
from makers.soft_forms import ring


def tops(*mm: float) -> np.ndarray:
    """Heights of an upper in millimetres, heel to toe, at the stations."""
    return np.interp(STATIONS, [0, 0.1, 0.2, 0.3, 0.42, 0.5, 0.63, 0.79, 0.92, 1], mm) / 1000


def at(t: float) -> float:
    return (t - 0.5) * 0.28


def foot(
    top: list[float],
    mat: Material,
    start: int = 0,
    wide: float = 1.0,
    base=None,
    rear: Material | None = None,
) -> Mesh:
    """The closed body of a shoe from station `start` to the toe; `rear` closes it behind."""
    base = SOLE_TOP if base is None else base
    rings = []
    for k in range(start, len(STATIONS)):
        w, low = HALF_WIDTH[k] * wide, base[k] - 0.004
        arc = math.pi * np.linspace(0, 1, 7)
        y = -w * np.sign(np.cos(arc)) * np.abs(np.cos(arc)) ** 0.75
        z = low + (top[k] - low) * np.abs(np.sin(arc)) ** 0.85
        rings.append(np.c_[np.full(7, at(STATIONS[k])), CENTRE[k] + y, z])
    mesh = loft(rings, mats=[mat, rear or mat])
    for i, face in enumerate(mesh.f):
        if len(face) > 4 and mesh.v[list(face)][:, 0].mean() < at(STATIONS[start]) + 0.01:
            mesh.mi[i] = 1
    return mesh


def shaft(height: float, skin: Material, inside: Material, rim: Material, flare: float) -> Mesh:
    """The leg of a boot: an open tube that rises from the heel."""
    shape = [
        (0.022, 0.058, 0.036, -0.07),
        (0.08, 0.062, 0.04, -0.07),
        (0.12, 0.056, 0.044, -0.078),
        (height - 0.02, 0.058 * flare, 0.048 * flare, -0.08),
        (height, 0.058 * flare, 0.048 * flare, -0.08),
    ]
    rings = [ring(8, rx, ry, z, cx) for z, rx, ry, cx in shape]
    rings.append(ring(8, 0.046 * flare, 0.036 * flare, height - 0.04, -0.08))
    return loft(
        rings, mats=[skin, rim, inside], mat_of_face=lambda k, i: 2 if k >= 4 else int(k >= 3)
    )


def boot(leather: str, sole: str, lace: str) -> list[Mesh]:
    """A laced work boot."""
    skin, dark = plain(leather, 0.1, 60), plain("#33291f", 0.05)
    top = tops(90, 100, 110, 115, 110, 100, 78, 66, 58, 30)
    meshes = [
        foot(top, skin),
        shaft(0.19, skin, dark, plain(shade(leather, 0.6), 0.08), 1.0),
        sole_of(sole, sole, "#241c18", 0.008),
    ]
    string, eye = plain(lace, 0.04), plain(shade(leather, 0.55), 0.05)
    front = [(0.024, 0.094), (-0.006, 0.126), (-0.024, 0.165)]
    meshes.append(
        loft(
            [
                [
                    (x + 0.001, -0.022, z - 0.012),
                    (x + 0.009, 0, z),
                    (x + 0.001, 0.022, z - 0.012),
                    (x - 0.012, 0, z - 0.012),
                ]
                for x, z in [(0.045, 0.08), *front[1:], (-0.022, 0.2)]
            ],
            eye,
        )
    )
    for x, z in front:
        meshes.append(
            tube(
                [(x - 0.004, -0.026, z - 0.01), (x + 0.013, 0, z), (x - 0.004, 0.026, z - 0.01)],
                0.0045, 3, mat=string, up=(1, 0, 0),
            )
        )  # fmt: skip
    return meshes


def rubber_boot(rubber: str, sole: str, height: float) -> list[Mesh]:
    skin, band = plain(rubber, 0.03, 30), plain(sole, 0.03)
    top = tops(90, 100, 110, 115, 110, 100, 82, 70, 60, 30)
    meshes = [
        foot(top, skin, 0, 1.06),
        shaft(height, skin, plain("#3a3d40", 0.05), band, 1.12),
        sole_of(sole, sole, "#241c18", 0.01),
    ]
    return meshes


def high_top(cloth: str, accent: str) -> list[Mesh]:
    """A canvas basketball boot: white toe cap, round badge, laces up the front."""
    skin, white = plain(cloth, 0.06, 120), plain("#f4f3ee", 0.03)
    top = tops(80, 90, 100, 105, 100, 90, 72, 58, 50, 28)
    meshes = [
        foot(top, skin, 3),
        shaft(0.155, skin, plain("#e4e0d4", 0.05), plain(accent, 0.03), 0.95),
        sole_of("#f4f3ee", accent, "#8a5a3a", 0.0),
        ellipsoid((0.05, 0.045, 0.04), (0.098, 0.004, 0.024), 7, 4, white),
    ]
    for x, z in ((0.046, 0.078), (0.016, 0.1), (-0.012, 0.122), (-0.022, 0.145)):
        meshes.append(
            tube(
                [(x - 0.006, -0.028, z - 0.014), (x + 0.008, 0, z), (x - 0.006, 0.028, z - 0.014)],
                0.005, 3, mat=white, up=(1, 0, 0),
            )
        )  # fmt: skip
    return meshes


def flat_sole(thick: float, mat: Material, bed: Material, wide: float = 1.0) -> Mesh:
    """A sandal's or slipper's slab, its footbed in the second material."""
    t = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, 7))
    keys = [0, 0.04, 0.1, 0.2, 0.35, 0.5, 0.65, 0.75, 0.85, 0.93, 0.98, 1]
    w = wide * np.interp(
        t, keys, [.008, .024, .032, .036, .035, .037, .044, .047, .044, .034, .022, .004]
    )  # fmt: skip
    c = np.interp(t, [0, 0.5, 0.7, 0.9, 1], [0, -0.001, 0, 0.006, 0.01])
    x = (t - 0.5) * 0.285
    outline = np.r_[np.c_[x, c - w], np.c_[x, c + w][::-1][1:-1]]
    rings = [
        np.c_[outline * f, np.full(len(outline), z)]
        for f, z in (
            (0.97, 0),
            (1, 0.006),
            (1, thick - 0.003),
            (0.97, thick),
            (0.86, thick - 0.004),
        )
    ]
    mesh = loft(rings, mats=[mat, bed], mat_of_face=lambda k, i: int(k >= 2))
    return mesh


def strap(t: float, z: float, wide: float, mat: Material, spread: float = 1.0, base=0.02) -> Mesh:
    """A band over the foot at station t, `z` high, `wide` along the foot."""
    w = float(np.interp(t, STATIONS, HALF_WIDTH)) * spread
    x, n = at(t), 6
    a = np.linspace(0, math.pi, n)
    rings = []
    for k in range(n):
        y, h = -w * math.cos(a[k]), base + (z - base) * math.sin(a[k]) ** 0.8
        out = np.array([-math.cos(a[k]), math.sin(a[k])]) * 0.005
        rings.append(
            [
                (x - wide / 2, y, h),
                (x + wide / 2, y, h),
                (x + wide / 2, y + out[0], h + out[1]),
                (x - wide / 2, y + out[0], h + out[1]),
            ]
        )
    return loft(rings, mat)


def sandal(leather: str, sole: str, cork: str) -> list[Mesh]:
    skin = plain(leather, 0.08, 60)
    meshes = [flat_sole(0.03, plain(sole, 0.05), plain(cork, 0.1, 120))]
    meshes += [strap(0.8, 0.064, 0.034, skin), strap(0.58, 0.084, 0.036, skin)]
    around = [(at(0.36), -0.036, 0.028), (at(0.3), -0.036, 0.075), (at(0.08), -0.03, 0.095)]
    around += [(at(0.02), 0.0, 0.098), (at(0.08), 0.03, 0.095), (at(0.3), 0.036, 0.075)]
    around += [(at(0.36), 0.036, 0.028)]
    meshes.append(tube(spline(around, 1), 0.013, 4, mat=skin, flatten=0.35, up=(0.3, 1, 0.1)))
    gold = metal("d8b45a", "8a6a24")
    for t, z in ((0.8, 0.052), (0.58, 0.07)):
        meshes.append(box(0.02, 0.006, 0.02, (at(t), 0.033, z - 0.01), gold).turn(rx=0.0))
    return meshes


def high_heel(colour: str, lining: str) -> list[Mesh]:
    """A pump on a thin heel, its throat cut low."""
    gloss, inner = plain(colour, 0.03, 20), plain(lining, 0.06)
    lift = np.interp(STATIONS, [0, 0.22, 0.45, 0.62, 1], [0.092, 0.086, 0.045, 0.012, 0.008])
    rim = np.interp(STATIONS, [0, 0.15, 0.4, 0.6, 0.72, 0.79, 0.92, 1],
                    [0.05, 0.042, 0.026, 0.024, 0.03, 0.034, 0.026, 0.012])  # fmt: skip
    narrow = upper(lift + rim, 0.66, gloss, inner, lift + 0.004)
    t = STATIONS
    w = HALF_WIDTH * 0.98
    outline = np.r_[np.c_[at(t), CENTRE - w], np.c_[at(t), CENTRE + w][::-1]]
    z = np.r_[lift, lift[::-1]]
    sole = loft(
        [np.c_[outline * 0.98, z - 0.008], np.c_[outline, z + 0.001]],
        plain(shade(colour, 0.5), 0.03),
    )
    heel = loft(
        [
            ring(6, 0.008, 0.008, 0.0, at(0.1)),
            ring(6, 0.007, 0.007, 0.03, at(0.1)),
            ring(6, 0.018, 0.018, 0.075, at(0.1)),
            ring(6, 0.03, 0.027, 0.088, at(0.12)),
        ],
        gloss,
    )
    bow = ellipsoid(
        (0.012, 0.026, 0.008), (at(0.67), 0.001, 0.05), 6, 4, plain(shade(colour, 0.6), 0.03)
    )
    return [narrow, sole, heel, bow]


_MAKE = {
    "sneaker": sneaker,
    "loafer": loafer,
    "boot": boot,
    "rubber boot": rubber_boot,
    "high-top": high_top,
    "sandal": sandal,
    "high heel": high_heel,
}


def pair(
    make: Callable[..., list[Mesh]],
    title: str,
    length: float,
    look: dict,
    turn: float,
    slip: float,
    tall: bool = False,
) -> Model:
    """A pair of shoes as somebody steps out of them; toes towards +X."""
    meshes, pieces = [], []
    s = length / 0.28
    for side in (-1, 1):
        one = make(**look)
        for mesh in one:
            mesh.scale(s, s * side, s)
            mesh.turn(rz=side * 0.06 + (turn if side > 0 else 0.0)).move(
                slip if side > 0 else 0.0, side * 0.062 * s
            )
        meshes += one
        points = np.concatenate([m.v for m in one])
        low, high = points[:, 0].min(), points[:, 0].max()
        x = (points[:, 0] - low) / (high - low)
        flat = points[:, 2] < (0.12 if tall else 1) * s
        for a, b in ((0.0, 0.5), (0.4, 1.0)):
            pieces.append(few_corners(points[(x >= a) & (x <= b) & flat]))
        if tall:
            pieces.append(few_corners(points[x <= 0.55]))
    lowest = min(float(m.v[:, 2].min()) for m in meshes)
    for mesh in meshes:
        mesh.move(z=-lowest)
    pieces = [p - [0, 0, lowest] for p in pieces]
    part = Part(meshes, collision=pieces)
    return Model(title, {"body": part}, mass=0.7, friction=0.8)


def shoe(style: str, **parameters) -> Model:
    """A pair of shoes."""
    tall = style in ("boot", "rubber boot", "high-top")
    return pair(_MAKE[style], f"pair of {style}s", tall=tall, **parameters)


def shoe_random(rng: np.random.Generator) -> dict:
    leather = pick(rng, ["#7a4526", "#2f2a28", "#8a5a34"])
    return {
        "style": "loafer",
        "length": 0.28,
        "look": {"leather": leather, "sole": "#2a211c"},
        "turn": 0.18,
        "slip": -0.02,
    }


def _sneaker_look(main: str, accent: str, cap: str, stripe: str) -> dict:
    return {
        "main": main,
        "accent": accent,
        "cap": cap,
        "tongue": accent if accent != "#ffffff" else main,
        "sole": "#f4f4f0",
        "lace": "#ffffff",
        "stripe": stripe,
    }


MODELS = {
    "shoe": Maker(
        shoe,
        shoe_random,
        9,
        [
            {"style": "sneaker", "look": _sneaker_look("#f2f2f0", "#1d4fa8", "#f2f2f0", "three")},
            {},
            {"style": "sneaker", "look": _sneaker_look("#c8242c", "#ffffff", "#f4f4f0", "wave")},
            {
                "style": "boot",
                "look": {"leather": "#b07a3a", "sole": "#3a2f28", "lace": "#e8d8a8"},
                "length": 0.29,
            },
            {
                "style": "sandal",
                "look": {"leather": "#6a4026", "sole": "#2f2823", "cork": "#c9a06a"},
            },
            {
                "style": "high heel",
                "look": {"colour": "#b81e2c", "lining": "#e0c09a"},
                "length": 0.25,
            },
            {
                "style": "rubber boot",
                "look": {"rubber": "#e8b820", "sole": "#f0ece0", "height": 0.29},
                "length": 0.27,
                "turn": 0.1,
            },
            {"style": "high-top", "look": {"cloth": "#1f2024", "accent": "#b8242c"}},
            {
                "style": "rubber boot",
                "look": {"rubber": "#2f6a44", "sole": "#20261f", "height": 0.29},
                "length": 0.27,
                "turn": 0.1,
            },
        ],
    ),
}
