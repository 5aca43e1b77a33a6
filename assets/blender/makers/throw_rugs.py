"""Small loose rugs, flat or with an edge or a corner turned up. Their length is along y."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, prism_piece
from toolkit.shapes import loft

from makers.convex import few_corners

THICK = 0.009
#: Rows of faces in what is turned up.
ROWS = 9
CURLED = {"state": "CURLED", "variants": ["curled"], "parts": ["curl"]}


def picture(kind: str, tones: tuple[str, ...]) -> Image.Image:
    """A woven pattern, the rug's length across: "bands", "zigzag", "medallion" or "tiles"."""
    w, h = 256, 160
    image, draw = labels.canvas(w, h, tones[0])
    if kind == "bands":
        for x, width, tone in ((18, 20, 1), (44, 7, 2), (66, 26, 1), (100, 7, 2), (115, 26, 1)):
            for a in (x, w - x - width):
                draw.rectangle((a, 0, a + width, h), fill=tones[tone])
    elif kind == "zigzag":
        for k, x in enumerate(range(-6, w + 20, 24)):
            line = [(x + 12 * (i % 2), i * 16) for i in range(12)]
            draw.line(line, fill=tones[1 + k % 2], width=9)
    elif kind == "medallion":
        for inset, tone in ((7, 1), (17, 0), (23, 2), (28, 1)):
            draw.rectangle((inset, inset, w - inset, h - inset), fill=tones[tone])
        for r, tone in ((46, 0), (38, 2), (26, 0), (15, 1)):
            cx, cy = w / 2, h / 2
            diamond = [(cx - 1.7 * r, cy), (cx, cy - r), (cx + 1.7 * r, cy), (cx, cy + r)]
            draw.polygon(diamond, fill=tones[tone])
    else:
        for i in range(6):
            for j in range(4):
                x, y = 5 + 41 * i, 4 + 38.5 * j
                draw.rectangle((x, y, x + 37, y + 34), fill=tones[1 + (i + j) % 2])
                draw.ellipse((x + 9, y + 8, x + 28, y + 26), fill=tones[0])
    pixels = np.asarray(image.convert("RGB"), float)
    weave = 1 + 0.06 * np.random.default_rng(1).standard_normal((h, w, 1))
    return Image.fromarray((pixels * weave).clip(0, 255).astype(np.uint8))


def strip(rows: list[tuple], heights: np.ndarray, mats: tuple[Material, Material]) -> Mesh:
    """Cloth between pairs of points of its flat pattern, each pair lifted to a place of its own.

    rows: (left, right) points of the pattern, (x, y), and their places (x, y, z) in the world;
    heights: unit vectors out of the upper side at each row. mats: (pattern, back).
    """
    rings, flat = [], []
    for (a, b, left, right), up in zip(rows, heights, strict=True):
        left, right = np.array(left), np.array(right)
        rings.append([left, right, right + up * THICK, left + up * THICK])
        flat.append([a, b, b, a])
    mesh = loft(rings, mats=list(mats))
    pattern = np.array(flat).reshape(-1, 2)
    for i, face in enumerate(mesh.f):
        corner = [j % 4 for j in face]
        upper = len(set(corner)) == 2 and set(corner) == {2, 3}
        mesh.mi[i] = 0 if upper else 1
        level = upper or set(corner) == {0, 1}
        side = 0.0 if upper else 3.0 if level else 6.0
        mirror = 1 if upper else -1
        points = pattern[list(face)]
        if level:
            mesh.bake_uv[i] = [(side + mirror * x, y) for x, y in points]
        else:
            mesh.bake_uv[i] = [
                (side + (0.5 if j > 1 else 0.5 + THICK), x + y)
                for j, (x, y) in zip(corner, points, strict=True)
            ]
    mesh.rest = np.c_[pattern, np.zeros(len(pattern))]
    return mesh


def dressed(mesh: Mesh, sx: float, sy: float) -> Mesh:
    """The drawn pattern on all faces, as it lies on the whole rug: u along y, v against x."""
    mesh.label_uv = [
        [(y / sy + 0.5, 0.5 - x / sx) for x, y, _ in mesh.rest[list(f)]] for f in mesh.f
    ]
    return mesh


def turned(
    cut: tuple, tip: tuple, radius: float, mats: tuple[Material, Material], bent: bool
) -> Mesh:
    """What lies beyond the line `cut` of two points, to the narrower line `tip`: flat, or `bent`
    up along an arc of this radius."""
    (a, b), (c, d) = np.array(cut, float), np.array(tip, float)
    axis = (b - a) / np.linalg.norm(b - a)
    away = np.array([-axis[1], axis[0]])
    if away @ (c - a) < 0:
        away = -away
    rows, ups = [], []
    for t in np.linspace(0, 1, ROWS + 1) if bent else (0.0, 1.0):
        left, right = a + (c - a) * t, b + (d - b) * t
        s = float(away @ (left - a))
        angle = s / radius
        reach, z = (radius * math.sin(angle), radius * (1 - math.cos(angle))) if bent else (s, 0.0)
        places = [(*(p + away * (reach - s)), z) for p in (left, right)]
        rows.append((left, right, *places))
        lean = angle if bent else 0.0
        ups.append([*(-away * math.sin(lean)), math.cos(lean)])
    return strip(rows, np.array(ups), mats)


def throw_rug(
    form: str, sx: float, sy: float, kind: str, tones: tuple[str, ...], turn: float, radius: float
) -> Model:
    """A rug; `turn` metres of an "edge" (at +y) or a "corner" (at +x, +y) may be turned up."""
    face = label(picture(kind, tones), occlusion=0.35)
    mats = face, plain(shade(tones[3], 0.9), 0.14, 150)
    x, y = sx / 2, sy / 2
    if form == "edge":
        cut, tip = ((x, y - turn), (-x, y - turn)), ((x, y), (-x, y))
        ends = [((x, -y), (-x, -y)), cut]
        outline = [(x, -y), (x, y - turn), (-x, y - turn), (-x, -y)]
    else:
        cut = ((x, y - turn), (x - turn, y))
        near = 0.06  # the corner itself is round
        tip = ((x, y - near * turn), (x - near * turn, y))
        ends = [((x, -y), (-x, -y)), ((x, y - turn), (-x, y - turn)), ((x - turn, y), (-x, y))]
        outline = [(x, -y), cut[0], cut[1], (-x, y), (-x, -y)]
    rows = [(p, q, (*p, 0), (*q, 0)) for p, q in ends]
    body = strip(rows, np.array([[0, 0, 1.0]] * len(rows)), mats)
    flap, curl = (turned(cut, tip, radius, mats, bent) for bent in (False, True))
    for mesh in (body, flap, curl):
        dressed(mesh, sx, sy)
    parts = {
        "body": Part([body], collision=[prism_piece(outline, 0, THICK)]),
        "flap": Part([flap], collision=[few_corners(flap.v, 40)]),
        "curl": Part([curl], collision=[few_corners(curl.v, 40)]),
    }
    return Model(
        "small loose rug",
        parts,
        mass=round(1.6 * sx * sy, 2),
        friction=0.8,
        variants={"default": ["body", "flap"], "curled": ["body", "curl"]},
        states=[CURLED],
        texture_size=128,
        prune=False,  # the ends that meet are seen when one of them is turned up
    )


def throw_rug_random(rng: np.random.Generator) -> dict:
    return {}


_EDGE = {"form": "edge", "sx": 0.5, "sy": 0.8, "turn": 0.16, "radius": 0.058}
_CORNER = {"form": "corner", "sx": 0.55, "sy": 0.9, "turn": 0.3, "radius": 0.061}

MODELS = {
    "throw_rug": Maker(
        throw_rug,
        throw_rug_random,
        4,
        [
            _EDGE | {"kind": "bands", "tones": ("#e9dfca", "#b5483a", "#2f4a68", "#c9b48c")},
            _CORNER | {"kind": "zigzag", "tones": ("#efe7d6", "#2f6f78", "#d8993a", "#b8a27c")},
            _CORNER | {"kind": "medallion", "tones": ("#e6d3a8", "#8a2a32", "#2a3a5a", "#a88e62")},
            _EDGE
            | {"kind": "tiles", "tones": ("#f2ead8", "#5a8a6a", "#d8b45a", "#c2b08a")}
            | {"sx": 0.62, "sy": 1.0, "turn": 0.17, "radius": 0.061},
        ],
    )
}
