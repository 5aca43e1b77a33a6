"""Towels and blankets: folded, stacked, rolled, thrown."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.shapes import box, extrude, tube

from makers import soft_things
from makers.clothing import heap_pieces
from makers.convex import few_corners
from makers.soft_forms import drape, folds, mound, rectangle_outline
from makers.soft_things import blanket_random, block, folded, terry, towel_random


def roll(radius: float, width: float, layer: float, turns: float, mat: Material) -> Mesh:
    """A cloth rolled up, lying along y on z = 0; the spiral shows at both ends."""
    n = int(turns * 11)
    t = np.linspace(0, turns * math.tau, n)
    mid = np.linspace(radius - turns * layer, radius, n) - layer / 2
    end = 2.2 - t[-1]  # the loose end lies at the front, above the floor
    c = np.c_[np.cos(t + end), np.sin(t + end)]
    outer, inner = (
        c * (mid + layer * 0.42)[:, None],
        c * np.maximum(mid - layer * 0.42, 0.001)[:, None],
    )
    outline = np.r_[outer, inner[::-1]]
    mesh = extrude(outline, width, mat=mat, axis="y")
    return mesh.move(z=-float(mesh.v[:, 2].min()))


def _lying(radius: float, width: float, at=(0.0, 0.0, 0.0)) -> np.ndarray:
    """Collision of a roll along y."""
    p = cylinder_piece(radius, -width / 2, width / 2, 10)
    return np.c_[p[:, 0], p[:, 2], p[:, 1] + radius] + at


def _wet(mesh: Mesh, colour: str, keep) -> Mesh:
    """A dark patch just above the upper faces of a cloth for which keep(x, y) holds."""
    wet = mesh.copy()
    middle = [wet.v[list(f)].mean(0) for f in wet.f]
    wet.keep_faces([i for i, c in enumerate(middle) if keep(c[0], c[1]) and wet.mi[i] == 0])
    wet.mats = [plain(shade(colour, 0.6), 0.16, 40), plain(shade(colour, 0.5))]
    wet.label_uv = None
    return wet.move(z=0.0025)


def _thrown(
    size: tuple[float, float], heap: tuple, height: float, fold: float, spacing: float,
    mats: tuple[Material, Material], rng: np.random.Generator, hem: float = 0.014,
) -> Mesh:  # fmt: skip
    """A cloth that was dropped: a sheet over an uneven mound, full of folds."""
    field = mound(heap, height, rng)
    mesh, _ = drape(
        rectangle_outline(*size), spacing, field, folds(rng, fold, 1.2), (0, 0), 0.35,
        (0.8, 0.8), mats, hem,
    )  # fmt: skip
    return mesh.move(z=-float(mesh.v[:, 2].min()))


def towel(style: str, colour: str, band: str, seed: int, **size) -> Model:
    """A terry towel: "folded", "long", "stack", "roll", "rolls" or "crumpled"."""
    rng = np.random.default_rng(seed)
    if style in ("folded", "long"):
        return soft_things.towel(colour=colour, band=band, seed=seed, **size)
    parts: dict[str, Part] = {}
    supports, variants, states = [], None, []
    if style == "stack":
        meshes, pieces, z = [], [], 0.0
        for tone, stripe in ((colour, band), (band, colour), (colour, band)):
            mat = terry(tone, stripe, [(0.09, 0.11), (0.12, 0.126)], 1, rng, 330)
            one = folded(0.26, 0.34, 0.03, 2, mat, rng)[0].keep_pattern()
            one.turn(rz=math.pi + float(rng.normal(0, 0.03))).move(z=z)
            piece, support = block(one, 0.05)
            z = float(one.v[:, 2].max())
            meshes.append(one)
            pieces.append(piece)
        supports = [support]
        parts["body"] = Part(meshes, collision=pieces)
        title, mass = "stack of folded towels", 1.2
    elif style in ("roll", "rolls"):
        places = [(0.0, 0.0)] if style == "roll" else [(0.066, 0.0), (-0.066, 0.0), (0.0, 0.112)]
        r, w = (0.075, 0.34) if style == "roll" else (0.064, 0.3)
        meshes, pieces = [], []
        for k, (x, z) in enumerate(places):
            tone, stripe = (colour, band) if k != 2 else (band, colour)
            mat = terry(tone, stripe, [(w * 0.3, w * 0.36), (w * 0.38, w * 0.4)], 1, rng, 330)
            mesh = roll(
                r, w, 0.019 if style == "roll" else 0.021, 3.1 if style == "roll" else 2.4, mat
            )
            meshes.append(mesh.keep_pattern().turn(rz=0.04 * (k - 1)).move(x, 0, z))
            pieces.append(_lying(r, w, (x, 0, z)))
        parts["body"] = Part(meshes, collision=pieces)
        title, mass = ("rolled towel", 0.45) if style == "roll" else ("rolled towels", 1.0)
    else:
        mats = (
            terry(colour, band, [(0.22, 0.24), (0.25, 0.265), (-0.265, -0.25)], 1, rng, 330),
            plain(shade(colour, 0.85), 0.05),
        )
        mesh = _thrown((0.5, 0.72), (0.13, 0.19), 0.1, 0.07, 0.052, mats, rng)
        wet = _wet(mesh, colour, lambda x, y: (x / 0.17) ** 2 + ((y + 0.06) / 0.17) ** 2 < 1)
        parts["body"] = Part([mesh], collision=[few_corners(mesh.v, 30)])
        parts["wet"] = Part([wet], collision="none")
        variants = {"default": ["body"], "wet": ["body", "wet"]}
        states = [{"state": "WET", "variants": ["wet"], "parts": ["wet"]}]
        title, mass = "crumpled towel", 0.45
    return Model(
        title, parts, mass=mass, friction=0.9, supports=supports, variants=variants, states=states,
        texture_size=128, occlusion_strength=1.2,
    )  # fmt: skip


def towel_any_random(rng: np.random.Generator) -> dict:
    return towel_random(rng) | {"style": "folded"}


def blanket(style: str, colours: list[str], pattern: str, seed: int, **size) -> Model:
    """A blanket: "folded", "roll" (with two straps) or "thrown"."""
    if style == "folded":
        return soft_things.blanket(colours=colours, pattern=pattern, seed=seed, **size)
    rng = np.random.default_rng(seed)
    if style == "roll":
        wool = soft_things.blanket_wool(colours, pattern, 0.55, rng)
        meshes = [roll(0.095, 0.55, 0.03, 2.6, wool)]
        strap, buckle = plain("#6a3f22", 0.06), plain("#c9a85a", 0.05)
        for q in (-1, 1):
            meshes.append(_belt(0.1, 0.03, q * 0.15, 0.095, strap))
            meshes.append(box(0.008, 0.04, 0.04, (0.1, q * 0.15, 0.08), buckle, 0.002))
        handle = [(0.0, -0.15, 0.19), (0.0, -0.1, 0.225), (0.0, 0.1, 0.225), (0.0, 0.15, 0.19)]
        meshes.append(tube(np.array(handle), 0.009, 6, mat=strap))
        part = Part(meshes, collision=[_lying(0.098, 0.55)])
        title, mass = "rolled blanket with straps", 1.6
    else:
        big = style == "thrown"
        wool = soft_things.blanket_wool(colours, pattern, 1.0, rng)
        mats = wool, plain(shade(colours[0], 0.8), 0.06)
        spread = (
            ((1.15, 1.25), (0.3, 0.34), 0.17, 0.12)
            if big
            else ((1.3, 0.75), (0.2, 0.3), 0.14, 0.09)
        )
        mesh = _thrown(*spread, 0.085, mats, rng, 0.022)
        part = Part([mesh], collision=heap_pieces(mesh.v))
        title, mass = "blanket thrown down", 1.6
    return Model(
        title, {"body": part}, mass=mass, friction=0.9, texture_size=128, occlusion_strength=1.2
    )  # fmt: skip


def _belt(radius: float, width: float, y: float, z: float, mat: Material) -> Mesh:
    """A flat band around a roll."""
    t = np.arange(16) * math.tau / 16
    outer = np.c_[np.cos(t), np.sin(t)] * radius
    mesh = extrude(outer, width, mat=mat, axis="y")
    return mesh.move(0, y, z)


def blanket_any_random(rng: np.random.Generator) -> dict:
    return blanket_random(rng) | {"style": "folded"}


_TOWEL = {"length": 0.225, "width": 0.33, "layer": 0.02, "folds": 4, "seed": 11}
_LONG = {"length": 0.36, "width": 0.3, "layer": 0.017, "folds": 2, "seed": 5}
_FOLD = {"length": 0.35, "width": 0.46, "layer": 0.036, "seed": 21}

MODELS = {
    "towel": Maker(
        towel,
        towel_any_random,
        8,
        [
            {"colour": "#7fb0c8", "band": "#f4f4f0", **_TOWEL},
            {"colour": "#f2efe6", "band": "#8a6a4a", **_TOWEL},
            {"colour": "#c8505c", "band": "#f6e8e6", **_TOWEL},
            {"style": "roll", "colour": "#3f8f86", "band": "#f2f0e6"},
            {"style": "stack", "colour": "#5a86b8", "band": "#f2efe6"},
            {"style": "crumpled", "colour": "#e0c45a", "band": "#fbf8ec"},
            {"style": "rolls", "colour": "#c9a0b8", "band": "#f6f0f2"},
            {"style": "long", "colour": "#8fae6a", "band": "#f4f4ea", **_LONG},
        ],
    ),
    "blanket": Maker(
        blanket,
        blanket_any_random,
        7,
        [
            {"colours": ["#a8323a", "#26303c", "#e9dcc0"], **_FOLD},
            {
                "pattern": "stripes",
                "fringe": False,
                "colours": ["#efe8d8", "#3f6a94", "#c8503a"],
                **_FOLD,
                "length": 0.3,
                "width": 0.55,
                "folds": 2,
                "layer": 0.045,
            },
            {"colours": ["#3a5a4a", "#1f2c28", "#e0cf9a"], **_FOLD},
            {"style": "roll", "colours": ["#3a5f8a", "#1f2f4a", "#e8e0c8"]},
            {"style": "thrown", "colours": ["#c8503a", "#2f3a48", "#f0e4c8"], "seed": 4},
            {
                "style": "bunched",
                "pattern": "stripes",
                "colours": ["#e8e0cc", "#6a8f7a", "#b8744a"],
                "seed": 9,
            },
            {
                "pattern": "stripes",
                "fringe": False,
                "colours": ["#d8c4d8", "#8a6a9a", "#f4ecf4"],
                "length": 0.4,
                "width": 0.4,
                "layer": 0.05,
                "folds": 4,
                "seed": 3,
            },
        ],
    ),
}
