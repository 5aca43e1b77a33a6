"""Boxes of chocolates, opened."""

from __future__ import annotations

import math

import cloth
import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, prism_piece
from toolkit.shapes import TAU, box, extrude, lathe, loft

from makers.projection import project_label

TONES = ("#4a2614", "#6f3f20", "#e9d8b8", "#3a1c10")


def lid_picture(ground: str, ink: str) -> Image.Image:
    """What is printed on a lid: a word in a frame, a bow."""
    image, draw = labels.canvas(256, 180, ground)
    draw.rectangle((10, 10, 246, 170), outline=ink, width=4)
    labels.text(draw, "Pralines", (34, 22, 222, 96), "oblique", ink)
    labels.text(draw, "FINE CHOCOLATE", (54, 104, 202, 128), "bold", ink)
    for s in (-1, 1):
        draw.polygon([(128, 148), (128 + 30 * s, 138), (128 + 30 * s, 160)], fill=ink)
    return image.convert("RGB")


def heart_word(ground: str, ink: str) -> Image.Image:
    """What is printed on the lid of a heart."""
    image, draw = labels.canvas(200, 200, ground)
    labels.text(draw, "Pralines", (34, 62, 166, 112), "oblique", ink)
    return image.convert("RGB")


def praline(kind: int, size: float) -> Mesh:
    """One chocolate on z = 0: a dome, a square with a stripe, a drop or a cup with a swirl."""
    tone = TONES[kind % 4]
    mat = Material(occlusion=0.8)
    stripe = mat.remap(mat.math("SINE", mat.math("MULTIPLY", mat.axis(1), 900)), 0.6, 0.8)
    mat.colour(mat.mix(stripe, mat.mottle(tone, 0.1, 90), shade(tone, 1.9) if kind % 2 else tone))
    r = size / 2
    if kind % 4 == 1:
        rings = []
        for k, z in ((0.92, 0.0), (0.95, 0.6 * r), (0.6, 1.0 * r)):
            square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
            rings.append(np.array([(x * k * r, y * k * r, z) for x, y in square]))
        mesh = loft(rings, mat=mat).flat()
    else:
        shape = {
            0: [(0.95, 0), (0.9, 0.5), (0.5, 0.95), (0, 1.1)],
            2: [(0.8, 0), (1.0, 0.6), (0.45, 0.9), (0, 1.35)],
            3: [(0.75, 0), (1.0, 0.8), (0.6, 0.75), (0, 1.1)],
        }[kind % 4]
        mesh = lathe([(q * r, z * r) for q, z in shape], 6, mat=mat, discs=False)
    keep = [i for i, f in enumerate(mesh.f) if mesh.v[list(f)][:, 2].max() > 1e-6]
    mesh.keep_faces(keep)
    return mesh


def heart(size: float, n: int = 24) -> np.ndarray:
    """The outline of a heart, its point towards the front (+x)."""
    t = np.arange(n) * TAU / n
    x = 16 * np.sin(t) ** 3
    y = 13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)
    return np.c_[-y - 2.5, x] / 32 * size


def tray(outline, height: float, wall: Material, floor: Material) -> Mesh:
    """A flat box without a lid over an outline: wall 3 mm thick, its floor 4 mm up."""
    p = np.asarray(outline, float)
    middle = p.mean(0)
    inner = p - (p - middle) / np.linalg.norm(p - middle, axis=1, keepdims=True) * 0.0035
    rings = [np.c_[p, 0 * p[:, 0]], np.c_[p, 0 * p[:, 0] + height]]
    rings += [np.c_[inner, 0 * p[:, 0] + height], np.c_[inner, 0 * p[:, 0] + 0.008]]
    mesh = loft(rings, mats=[wall, floor], mat_of_face=lambda k, i: 1 if k == 2 else 0)
    for i, face in enumerate(mesh.f):
        if len(face) > 4 or np.ptp(mesh.v[list(face)][:, 2]) < 1e-9:
            mesh.mi[i] = 1 if abs(mesh.v[face[0]][2] - 0.008) < 1e-6 else 0
    return mesh


def places(kind: str, depth: float, width: float, rows: int, columns: int):
    """Where pralines lie, (x, y)."""
    if kind != "heart":
        dx, dy = (depth - 0.012) / rows, (width - 0.012) / columns
        return [
            ((i - (rows - 1) / 2) * dx, (j - (columns - 1) / 2) * dy)
            for i in range(rows)
            for j in range(columns)
        ]
    grid = [(0.036 * (i - 2), 0.037 * (j - 2)) for i in range(5) for j in range(5)]
    around = np.arange(8) * TAU / 8
    rim = 0.018 * np.c_[np.cos(around), np.sin(around)]  # a whole one, clear of the wall
    outline = heart(depth - 0.012)
    return [p for p in grid if cloth.inside(p + rim, outline).all()]


def chocolate_box(
    kind: str, depth: float, width: float, ground: str, ink: str, rows: int = 3, columns: int = 5,
    gone: tuple[int, ...] = (),
) -> Model:  # fmt: skip
    """A box: "hinged" with its lid up behind, "beside" with the lid next to it, or a "heart"."""
    h = 0.03
    card, gold = plain(ground, 0.05, 60), plain("#d8b25a", 0.1, 200)
    cover = label(lid_picture(ground, ink), occlusion=0.6)
    if kind == "heart":
        outline = heart(depth)
        meshes = [tray(outline, h, card, gold)]
        pieces = [prism_piece(outline[::2], 0, h)]
    else:
        outline = [(-depth / 2, -width / 2), (depth / 2, -width / 2)]
        outline += [(depth / 2, width / 2), (-depth / 2, width / 2)]
        meshes = [tray(outline, h, card, gold)]
        pieces = [box_piece((0, 0, h / 2), (depth, width, h))]
    for k, (x, y) in enumerate(places(kind, depth, width, rows, columns)):
        if k in gone:
            continue
        pitch = 0.034 if kind == "heart" else min((depth - 0.012) / rows, (width - 0.012) / columns)
        one = praline((k * 7 + k // 4) % 4, 0.82 * pitch)
        meshes.append(one.keep_pattern().move(x, y, 0.008).weigh(0.8))
    if kind == "hinged":
        lid = box(depth, width, 0.012, (0, 0, 0), card, 0.0, labels={"-z": gold, "+z": cover})
        lid.weigh(0.8).move(x=depth / 2).turn(ry=math.radians(-108)).move(-depth / 2 - 0.001, 0, h)
        lid.move(z=-0.004)
        meshes.append(lid)
        pieces.append(lid.v.copy())
    elif kind == "beside":
        lid = box(depth + 0.004, width + 0.004, 0.014, (0, 0, 0), card, 0.0, labels={"+z": cover})
        lid.turn(rz=0.22).move(x=depth + 0.03, y=0.02)
        meshes.append(lid)
        pieces.append(lid.v.copy())
    else:  # the lid lies beside it
        lid = extrude(heart(depth + 0.004), 0.014, card, bevel_width=0.0)
        word = label(heart_word(ground, ink), occlusion=0.6)
        project_label(lid, word, "+z", (0, 0), (depth, depth), 0.9)
        lid.weigh(1.6).turn(rz=0.3).move(x=0.02, y=0.2)
        meshes.append(lid)
        pieces.append(prism_piece(lid.v[lid.v[:, 2] < 0.001][::2, :2], 0, 0.014))
    return Model(
        "open box of chocolates",
        {"body": Part(meshes, collision=pieces)},
        mass=0.3,
        friction=0.6,
        texture_size=128,
        prune=False,
    )


def chocolate_box_random(rng: np.random.Generator) -> dict:
    return {}


MODELS = {
    "chocolate_box": Maker(
        chocolate_box,
        chocolate_box_random,
        3,
        [
            {"kind": "hinged", "depth": 0.15, "width": 0.23, "ground": "#7a1626", "ink": "#e8c878"}
            | {"gone": (8, 12)},
            {"kind": "beside", "depth": 0.14, "width": 0.18, "ground": "#22386a", "ink": "#e6d9b0"}
            | {"rows": 3, "columns": 4, "gone": (5,)},
            {"kind": "heart", "depth": 0.2, "width": 0.2, "ground": "#c8202e", "ink": "#ffffff"}
            | {"gone": (4,)},
        ],
    )
}
