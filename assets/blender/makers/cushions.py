"""Cushions: square, oblong, round, bolster, floor cushion, heart."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.shapes import ellipsoid, lathe, loft, tube

from makers import soft_things
from makers.convex import few_corners
from makers.joinery import fabric
from makers.soft_forms import bent
from makers.soft_things import cushion_random


def _pleated(colour: str, second: str, pleats: int) -> Material:
    """Cloth gathered towards the middle."""
    m = Material()
    angle = m.math("ARCTAN2", m.axis(1), m.axis(0))
    wave = m.math("SINE", m.math("MULTIPLY", angle, pleats))
    m.colour(m.mix(m.remap(wave, -0.2, 1.0, 0, 0.6), m.mottle(colour, 0.06, 90), second))
    return m


def _corduroy(colour: str, second: str) -> Material:
    """Ribbed cloth: of one colour a heart looks like plastic."""
    m = Material()
    wave = m.math("SINE", m.math("MULTIPLY", m.axis(1), 420.0))
    return m.colour(m.mix(m.remap(wave, -0.4, 0.8, 0, 1), m.mottle(colour, 0.12, 90), second))


def _round(size: float, colours: list[str]) -> list[Mesh]:
    r, h = size / 2, 0.13
    cloth, rim = _pleated(colours[0], shade(colours[0], 0.6), 14), plain(colours[1], 0.05)
    profile = [(0, 0), (r * 0.7, 0.0), (r * 0.95, h * 0.22), (r, h * 0.46), (r, h * 0.54)]
    profile += [(r * 0.92, h * 0.82), (r * 0.66, h * 1.0), (r * 0.3, h * 0.94), (0, h * 0.7)]
    body = lathe(profile, 20, mats=[cloth, rim], mat_of_segment=[0, 0, 0, 1, 0, 0, 0, 0])
    button = ellipsoid((0.025, 0.025, 0.012), (0, 0, h * 0.74), 10, 5, rim)
    return [body, button]


def _bolster(length: float, colours: list[str]) -> list[Mesh]:
    r, half = 0.09, length / 2
    stripes = Material()
    wave = stripes.math("SINE", stripes.math("MULTIPLY", stripes.axis(1), 70.0))
    stripes.colour(
        stripes.mix(stripes.remap(wave, 0.3, 0.4), stripes.mottle(colours[0], 0.06, 90), colours[1])
    )
    end = plain(colours[1], 0.08)
    profile = [(0, -half + 0.012), (r * 0.6, -half - 0.004), (r * 0.96, -half), (r, -half + 0.014)]
    profile += [(r * 1.03, -half * 0.4), (r * 1.03, half * 0.4)]
    profile += [(q, -z) for q, z in profile[3::-1]]
    body = lathe(
        profile, 18, mats=[stripes, end], mat_of_segment=[1, 1, 1, 0, 0, 0, 1, 1, 1], discs=False
    )
    meshes = [body.turn(rx=math.pi / 2).move(z=r * 1.02)]
    tassel = plain(colours[2], 0.06)
    for q in (-1, 1):
        meshes.append(ellipsoid((0.02, 0.016, 0.02), (0, q * half, r * 1.02), 8, 5, tassel))
        hang = [(0, q * (half + 0.008), r), (0, q * (half + 0.022), r - 0.03)]
        hang.append((0, q * (half + 0.024), r - 0.075))
        meshes.append(tube(np.array(hang), [0.005, 0.009, 0.016], 6, mat=tassel))
    return meshes


def _floor_cushion(size: float, colours: list[str]) -> list[Mesh]:
    """A thick, buttoned block with a carrying handle."""
    n, h = 6, 0.13
    us = np.linspace(-1, 1, n + 1)
    rings = []
    outline = [(u, -1) for u in us[:-1]] + [(1, u) for u in us[:-1]]
    outline += [(-u, 1) for u in us[:-1]] + [(-1, -u) for u in us[:-1]]
    p = np.array(outline) * size / 2
    for inset, z in ((0.97, 0.0), (1.0, 0.016), (0.985, h / 2), (1.0, h - 0.016), (0.96, h)):
        rings.append(np.c_[p * inset, np.full(len(p), z)])
    dents = [(a * size / 4, b * size / 4) for a in (-1, 1) for b in (-1, 1)] + [(0.0, 0.0)]

    def puff(q: np.ndarray) -> np.ndarray:
        d = np.min([np.hypot(q[:, 0] - x, q[:, 1] - y) for x, y in dents], 0)
        edge = np.clip((size / 2 - np.abs(q).max(1)) / (size * 0.12), 0, 1)
        return h + 0.03 * np.clip(d / (size * 0.13), 0, 1) * edge - 0.012 * (1 - edge)

    cover = fabric(colours[0], amount=0.12)
    side = loft_open([*rings[:4], np.c_[p * 0.96, puff(p * 0.96)]], cover)
    grid = np.array([(a, b) for a in us for b in us]) * size / 2 * 0.96
    faces = [
        (i * (n + 1) + j, (i + 1) * (n + 1) + j, (i + 1) * (n + 1) + j + 1, i * (n + 1) + j + 1)
        for i in range(n)
        for j in range(n)
    ]
    uv = [[tuple(grid[i]) for i in face] for face in faces]
    top = Mesh(np.c_[grid, puff(grid)], faces, materials=[cover], bake_uv=uv)
    knob = plain(colours[1], 0.05)
    meshes = [side, top]
    for x, y in dents:
        z = float(puff(np.array([(x, y)]))[0])
        meshes.append(ellipsoid((0.018, 0.018, 0.009), (x, y, z + 0.002), 8, 4, knob))
    piping = [np.c_[p, np.full(len(p), z)][::2] for z in (0.016, h - 0.016)]
    meshes += [tube(q, 0.006, 4, closed=True, mat=knob, weight=0.5) for q in piping]
    grip = [(size / 2, -0.07, h / 2), (size / 2 + 0.03, -0.05, h / 2 - 0.01)]
    grip += [(size / 2 + 0.03, 0.05, h / 2 - 0.01), (size / 2, 0.07, h / 2)]
    meshes.append(bent(grip, 0.011, knob, 6, 2))
    return meshes


def loft_open(rings: list[np.ndarray], mat: Material) -> Mesh:
    return loft(rings, mat, caps=(True, False))


def _heart(size: float, colours: list[str]) -> list[Mesh]:
    t = np.arange(28) * math.tau / 28
    y = 16 * np.sin(t) ** 3
    x = -(13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)) - 2.5
    p = np.c_[x, y] * size / 33
    h = 0.15
    rings = [
        np.c_[p * f, np.full(len(p), z)]
        for f, z in ((0.75, 0), (0.95, h * 0.22), (1, h * 0.45), (0.94, h * 0.75), (0.72, h * 0.96),
                     (0.35, h * 1.04))
    ]  # fmt: skip
    seam = [(*q, h * 0.45) for q in p]
    piping = tube(seam, 0.006, 5, closed=True, mat=plain(colours[2], 0.08, 120))
    return [loft(rings, _corduroy(*colours[:2])), piping]


def cushion(style: str, size: float, colours: list[str], **more) -> Model:
    """A sofa cushion: "square" (aspect), "round", "bolster", "floor" or "heart"."""
    if style == "square":
        return soft_things.cushion(size=size, colours=colours, **more)
    make = {"round": _round, "bolster": _bolster, "floor": _floor_cushion, "heart": _heart}
    meshes = make[style](size, colours)
    points = np.concatenate([m.v for m in meshes[:2]])
    piece = few_corners(points, 40)
    if style == "round":
        piece = cylinder_piece(size / 2, 0, 0.12, 12)
    title = {"round": "round cushion", "bolster": "bolster", "floor": "floor cushion"}
    return Model(
        title.get(style, "heart cushion"),
        {"body": Part(meshes, collision=[piece])},
        mass=1.2 if style == "floor" else 0.5,
        friction=0.9,
        texture_size=128,
    )


def cushion_any_random(rng: np.random.Generator) -> dict:
    return cushion_random(rng) | {"style": "square"}


_SQUARE = {"size": 0.43, "puff": 0.14, "seed": 7}

MODELS = {
    "cushion": Maker(
        cushion,
        cushion_any_random,
        8,
        [
            _SQUARE,
            {"pattern": "plain", "colours": ["#2f7f78", "#24645f", "#ffffff"], **_SQUARE},
            {"pattern": "diamonds", "colours": ["#f0e6d0", "#e2a02c", "#3a4f78"], **_SQUARE},
            {"style": "round", "size": 0.4, "colours": ["#d8a03a", "#8a5a20", "#ffffff"]},
            {"style": "bolster", "size": 0.5, "colours": ["#efe8d8", "#3f6a94", "#c8503a"]},
            {"style": "floor", "size": 0.5, "colours": ["#7a6f9a", "#f0e8d8", "#ffffff"]},
            {"style": "heart", "size": 0.4, "colours": ["#c98b8c", "#a5656a", "#efe6d8"]},
            {
                "size": 0.55,
                "aspect": 0.55,
                "puff": 0.13,
                "pattern": "leaves",
                "colours": ["#f2ece0", "#4f8a5a", "#c8703a"],
            },
        ],
    ),
}
