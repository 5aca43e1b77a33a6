"""Rugs and bath mats of all forms."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, prism_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import box, extrude, loft, rounded_rectangle

from makers import textiles
from makers.large_rugs import LARGE_RUGS, SMALL_RUGS, large_rug, woven_picture
from makers.soft_forms import folds, pad
from makers.textiles import RUG_TONES, bath_mat_random, rug_pattern, rug_random


def _woven(image: Image.Image, seed: int = 0) -> Image.Image:
    """A little weave over a drawn pattern."""
    pixels = np.asarray(image.convert("RGB"), float)
    noise = np.random.default_rng(seed).standard_normal((*pixels.shape[:2], 1))
    return Image.fromarray((pixels * (1 + 0.05 * noise)).clip(0, 255).astype(np.uint8))


def _rings(tones: tuple[str, ...]) -> Image.Image:
    """Concentric rings and a flower."""
    image, draw = labels.canvas(256, 256, tones[0])
    for k, (r, tone) in enumerate(((124, 1), (108, 0), (98, 2), (90, 0), (62, 1), (54, 0))):
        draw.ellipse((128 - r, 128 - r, 128 + r, 128 + r), fill=tones[tone % len(tones)])
        if k == 3:
            for i in range(16):
                a = i * math.pi / 8
                x, y = 128 + 76 * math.cos(a), 128 + 76 * math.sin(a)
                draw.ellipse((x - 9, y - 9, x + 9, y + 9), fill=tones[2])
    for i in range(8):
        a = i * math.pi / 4
        x, y = 128 + 26 * math.cos(a), 128 + 26 * math.sin(a)
        draw.ellipse((x - 14, y - 14, x + 14, y + 14), fill=tones[2])
    draw.ellipse((112, 112, 144, 144), fill=tones[1])
    return _woven(image)


def _ellipse(sx: float, sy: float, n: int = 28) -> np.ndarray:
    t = np.arange(n) * math.tau / n
    return np.c_[sx / 2 * np.cos(t), sy / 2 * np.sin(t)]


def _skin_outline(sx: float, sy: float) -> np.ndarray:
    """A sheepskin: broad body, four legs, a neck."""
    half = [(0.0, 0.5), (0.1, 0.5), (0.2, 0.44), (0.3, 0.46), (0.42, 0.42), (0.42, 0.34)]
    half += [(0.33, 0.26), (0.32, 0.1), (0.34, -0.1), (0.36, -0.22), (0.47, -0.3), (0.5, -0.4)]
    half += [(0.42, -0.45), (0.3, -0.4), (0.18, -0.44), (0.08, -0.5), (0.0, -0.5)]
    p = np.array(half + [(-x, y) for x, y in half[-2:0:-1]])
    return p * [sx, sy]


def _flat(title: str, mesh: Mesh, outline: np.ndarray, height: float, mass: float) -> Model:
    """A mat whose collision is the outline's hull (near enough for something so thin)."""
    piece = prism_piece(outline[:: max(1, len(outline) // 16)], 0, height)
    return Model(title, {"body": Part([mesh], collision=[piece])}, mass=mass, friction=0.8)


def sheepskin(sx: float, sy: float, colour: str, seed: int) -> Model:
    rng = np.random.default_rng(seed)
    fur = Material()
    patch = fur.remap(fur.noise(2.6, 2, 0.4, offset=noise_offset(rng)), 0.5, 0.53)
    fine = fur.remap(fur.noise(120, 3, 0.7, offset=noise_offset(rng)), 0.35, 0.65, 0, 0.3)
    coat = fur.mix(patch, colour, "#6a3f22")
    fur.colour(fur.mix(fine, coat, fur.mix(patch, shade(colour, 0.84), "#4a2a16")))
    p = _skin_outline(sx, sy)
    t = np.linspace(0, 1, len(p), endpoint=False)
    p = p * (1 + 0.02 * np.sin(40 * t))[:, None]
    bumps = folds(rng, 0.0045, 0.8)
    rings = []
    for f, z in (
        (1, 0.0),
        (1.01, 0.012),
        (0.93, 0.02),
        (0.7, 0.018),
        (0.42, 0.018),
        (0.15, 0.018),
    ):
        q = p * f
        rings.append(np.c_[q, z + bumps(q) * (z > 0.015)])
    mesh = loft(rings, fur)
    mesh.bake_uv = [[(x, y) for x, y, _ in mesh.v[list(f)]] for f in mesh.f]
    mesh.keep_faces(
        [i for i, f in enumerate(mesh.f) if not (len(f) > 4 and mesh.v[f[0]][2] < 0.01)]
    )
    model = _flat("animal skin rug", mesh, p, 0.022, 2.0)
    return model


def rug(form: str, **more) -> Model:
    """A rug: "oblong", "large", "round", "oval", "runner" (fringed) or "sheepskin"."""
    if form == "oblong":
        return textiles.rug(**more)
    if form == "large":
        return large_rug(more["pattern"], more["tones"], more["length"], more["depth"])
    if form == "sheepskin":
        return sheepskin(more["sx"], more["sy"], more["tones"][0], 5)
    sx, sy, tones = more["sx"], more["sy"], more["tones"]
    h = 0.004
    if form in ("round", "oval"):
        outline = _ellipse(sx, sy)
        drawn = woven_picture("braid", tones) if more["sx"] > 2 else _rings(tones)
        face = label(drawn, occlusion=0.0)
        mesh = pad(outline, h, face, 0.3, mats=(plain(shade(tones[1], 0.8), 0.05), face))
        return _flat(f"{form} rug", mesh, outline, h, round(2.2 * sx * sy, 1))
    picture = rug_pattern(more["pattern"], tones, 320, 110)
    face, side = label(picture, occlusion=0.0), plain(shade(tones[0], 0.8), 0.05, 60)
    meshes = [box(sx, sy - 0.14, h, (0, 0, 0), side, labels={"+z": face})]
    thread = plain(shade(tones[0], 1.05), 0.08, 40)
    for q in (-1, 1):
        for i in range(11):
            x = (i - 5) / 11 * sx
            tassel = box(sx / 18, 0.075, 0.003, (0, 0, 0), thread).turn(rz=0.12 * math.sin(3 * i))
            meshes.append(tassel.move(x, q * (sy / 2 - 0.036), 0))
    part = Part(meshes, collision=[box_piece((0, 0, h / 2), (sx, sy, h))])
    mass = round(2.2 * sx * sy, 1)
    return Model(f"{form} rug with fringes", {"body": part}, mass=mass, friction=0.8)


def rug_any_random(rng: np.random.Generator) -> dict:
    return {"form": "oblong"} | rug_random(rng)


# ---- bath mats
def _mat_picture(words: str, ground: str, ink: str, w: int = 256, h: int = 192) -> Image.Image:
    """BATH in large letters, with two footprints or waves."""
    image, draw = labels.canvas(w, h, ground)
    for inset in (10, 18):
        draw.rounded_rectangle((inset, inset, w - inset, h - inset), 30, outline=ink, width=4)
    labels.text(draw, words, (0.2 * w, 0.14 * h, 0.8 * w, 0.42 * h), "bold", ink)
    for q in (-1, 1):
        x, y = w / 2 + 30 * q, 0.7 * h
        draw.ellipse((x - 13, y - 16, x + 13, y + 8), fill=ink)
        draw.ellipse((x - 10, y + 6, x + 8, y + 30), fill=ink)
        for k in range(5):
            tx, r = x - q * 12 + q * 6 * k, 4.5 - 0.5 * k
            ty = y - 24 + k * k * 0.7
            draw.ellipse((tx - r, ty - r, tx + r, ty + r), fill=ink)
    return _woven(image, 1)


def _pile(colour: str, offset) -> Material:
    pile = Material()
    tufts = pile.remap(pile.voronoi(70, offset), 0.1, 0.6)
    return pile.colour(pile.mix(tufts, shade(colour, 1.1), shade(colour, 0.82)))


def bath_mat(form: str, colour: str, offset, **more) -> Model:
    """A bath mat: "tufted", "oval" or "round" (drawn), "contour" (cut out) or "slats" (wood)."""
    if form == "tufted":
        return textiles.bath_mat(colour=colour, offset=offset, **more)
    h = 0.018
    if form == "slats":
        wood, dark = plain("#b98552", 0.12, 24, offset), plain("#8a5c34", 0.1, 24, offset)
        meshes = [box(0.44, 0.04, 0.016, (0, y, 0), dark) for y in (-0.24, 0.0, 0.24)]
        for k in range(9):
            meshes.append(box(0.038, 0.66, 0.014, ((k - 4) * 0.05, 0, 0.016), wood, 0.003))
        part = Part(meshes, collision=[box_piece((0, 0, 0.015), (0.44, 0.66, 0.03))])
        return Model("wooden bath mat", {"body": part}, mass=2.2, friction=0.7, texture_size=128)
    if form == "contour":
        t = np.linspace(0, math.pi, 9)
        cut = np.c_[0.1 - 0.13 * np.sin(t), 0.15 * np.cos(t)]
        outer = rounded_rectangle(0.5, 0.58, 0.1, 4)
        right = [tuple(p) for p in outer if not (p[0] > 0.2 and abs(p[1]) < 0.1)]
        k = next(i for i, p in enumerate(right) if p[0] > 0.2 and p[1] > 0)
        lip = [(0.25, 0.17), (0.2, 0.155), *[tuple(q) for q in cut], (0.2, -0.155), (0.25, -0.17)]
        outline = np.array(right[:k] + lip[::-1] + right[k:])
        mesh = extrude(outline, h, _pile(colour, offset), bevel_width=0.005)
        pieces = [box_piece((-0.13, 0, h / 2), (0.24, 0.56, h))]
        pieces += [box_piece((0.12, q * 0.22, h / 2), (0.26, 0.13, h)) for q in (-1, 1)]
        part = Part([mesh], collision=pieces)
        return Model("pedestal bath mat", {"body": part}, mass=0.8, friction=0.8, texture_size=128)
    sx, sy = (0.62, 0.62) if form == "round" else (0.5, 0.8)
    if form == "round":
        n = 40
        t = np.arange(n) * math.tau / n
        r = 0.3 * (1 + 0.035 * np.cos(10 * t))
        outline = np.c_[r * np.cos(t), r * np.sin(t)]
    else:
        outline = _ellipse(sx, sy)
    face = label(_mat_picture("BATH", colour, "#f6f4ee", 256, 256 if form == "round" else 170))
    mesh = pad(outline, h, face, 0.4, mats=(plain(shade(colour, 0.8), 0.06), face))
    return _flat(f"{form} bath mat", mesh, outline, h, 0.9)


def bath_mat_any_random(rng: np.random.Generator) -> dict:
    p = bath_mat_random(rng)
    return {"form": "tufted", "colour": p["colour"], "offset": p["offset"]}


_A = {"length": 2.2, "depth": 1.5}
_MAT = {"length": 0.8, "depth": 0.5}
_ROUND = {"form": "round", "sx": 1.7, "sy": 1.7}

MODELS = {
    "rug": Maker(
        rug,
        rug_any_random,
        9 + len(LARGE_RUGS) + len(SMALL_RUGS),
        [
            {"pattern": "border", "tones": RUG_TONES[0], **_A},
            {"pattern": "hexagons", "tones": RUG_TONES[1], **_A},
            {"pattern": "stripes", "tones": RUG_TONES[2], "length": 1.8, "depth": 1.2},
            {"pattern": "diamonds", "tones": RUG_TONES[3], "length": 1.8, "depth": 1.2},
            {**_ROUND, "tones": ("#e6dcc6", "#3f6a8a", "#c8703a")},
            {"form": "oval", "sx": 1.2, "sy": 1.9, "tones": ("#e0d4bc", "#7a4a3f", "#5a7a5a")},
            {
                "form": "runner",
                "sx": 0.82,
                "sy": 2.5,
                "pattern": "diamonds",
                "tones": ("#a8323a", "#f0e4c8", "#2f3a55"),
            },
            {"form": "sheepskin", "sx": 1.3, "sy": 1.7, "tones": ("#f0ebe0",)},
            {**_ROUND, "tones": ("#8a9a8f", "#f0ece0", "#3a4a44")},
            *LARGE_RUGS,
            *SMALL_RUGS,
        ],
    ),
    "bath_mat": Maker(
        bath_mat,
        bath_mat_any_random,
        7,
        [
            {"colour": "#7fa0a8", "offset": (3.0, 1.0, 2.0), **_MAT},
            {"colour": "#cfc3ad", "offset": (3.0, 1.0, 2.0), **_MAT},
            {"form": "round", "colour": "#3f7f9a"},
            {"form": "contour", "colour": "#b8828a"},
            {"form": "oval", "colour": "#5a8f6a"},
            {"form": "slats"},
            {"form": "oval", "colour": "#8a5a7a"},
        ],
    ),
}
