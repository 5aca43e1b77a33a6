"""Rolls of kitchen paper on their stands, upright."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.shapes import ellipsoid, extrude, lathe, spline, tube

from .casework import metal_or
from .joinery import finish, stone

Offset = tuple[float, float, float]
CORE, TALL = 0.02, 0.24


def _print(motif: str, ink: str) -> Image.Image:
    """What paper is printed with: "dots", "leaves" or "checks"; faint quilting over all of it."""
    w, h = 256, 144
    image, draw = labels.canvas(w, h, "#f7f6f2")
    for x in range(0, w, 16):
        draw.line((x, 0, x, h), fill="#ecebe6")
    for y in range(0, h, 16):
        draw.line((0, y, w, y), fill="#ecebe6")
    for j, y in enumerate(range(12, h, 24)):
        for i, x in enumerate(range(8, w, 32)):
            at = x + 16 * (j % 2)
            if motif == "dots":
                draw.ellipse((at - 4, y - 4, at + 4, y + 4), fill=ink)
            elif motif == "leaves":
                lean = 4 if i % 2 else -4
                draw.line((at, y + 7, at + lean, y - 7), fill=ink, width=3)
                draw.ellipse((at + lean - 5, y - 10, at + lean + 5, y - 3), fill=ink)
            elif motif == "checks":
                draw.rectangle((at - 8, y - 2, at + 8, y + 2), fill=ink)
                draw.rectangle((at - 2, y - 8, at + 2, y + 8), fill=ink)
    return image


def paper_roll(radius: float, z: float, motif: str, ink: str) -> list[Mesh]:
    """A roll standing at a height, the last sheet hanging loose at its front."""
    paper, card = label(_print(motif, ink)), plain("#b08a5e", 0.08, 200)
    rim = Material()
    rim.colour(rim.mottle("#efede7", 0.06, 160))
    profile = [(CORE, z), (radius, z), (radius, z + TALL), (CORE, z + TALL), (CORE, z)]
    mats = [paper, rim, card]
    body = lathe(profile, 22, mats=mats, mat_of_segment=[1, 0, 1, 2], label_z=(z, z + TALL))
    # The last sheet comes off where the roll faces the front and bends back towards its end.
    a, r = np.linspace(-0.5, 0.0, 3), radius + 0.0015
    line = [(r * math.cos(t), r * math.sin(t)) for t in a]
    line += [(r + 0.002, 0.02), (r + 0.009, 0.036), (r + 0.021, 0.048)]
    outline = [*line, *((x - 0.002, y + 0.0004) for x, y in line[::-1])]
    sheet = extrude(outline, TALL - 0.004, rim).move(z=z + 0.002)
    return [body, sheet]


def kitchen_roll(
    stand: str,
    colour: str = "oak",
    radius: float = 0.058,
    motif: str = "none",
    ink: str = "#6a8fb0",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A roll on a stand: a "post" with a knob, an "arm" that holds the paper, a "ring" to carry it
    by, a "slab" of stone, or on "none"."""
    z, base = 0.0, radius + 0.012
    meshes: list[Mesh] = []
    pieces = []
    if stand != "none":
        z = 0.022 if stand == "slab" else 0.014
        if stand == "slab":
            mat = stone(colour, "#8d8a86", offset)
        else:
            mat = metal_or(colour) if stand in ("arm", "ring") else finish(colour, 1, offset)
        foot = [(0, 0), (base, 0), (base, z - 0.003), (base - 0.003, z), (0, z)]
        meshes.append(lathe(foot, 22, mat=mat))
        pieces.append(cylinder_piece(base, 0, z, 12))
        rod = metal_or("steel") if stand == "slab" else mat
        top = z + TALL + 0.03
        meshes.append(tube([(0, 0, z), (0, 0, top)], 0.008, 8, mat=rod))
        if stand in ("post", "slab"):
            meshes.append(ellipsoid(0.016, (0, 0, top + 0.008), 10, 7, rod))
            pieces.append(cylinder_piece(0.016, z, top + 0.024, 8))
        elif stand == "ring":
            t = np.arange(12) * math.tau / 12
            eye = np.c_[np.zeros(12), 0.02 * np.cos(t), top + 0.018 + 0.02 * np.sin(t)]
            meshes.append(tube(eye, 0.005, 5, closed=True, mat=rod))
            pieces.append(cylinder_piece(0.022, z, top + 0.04, 8))
        else:
            x = radius + 0.006
            path = [(0, x, z), (0, x, z + 0.16), (0, x + 0.004, z + 0.19)]
            meshes.append(tube(spline(path, 2), 0.005, 6, mat=rod))
            pieces.append(cylinder_piece(0.008, z, top, 8))
    meshes += paper_roll(radius, z, motif, ink)
    pieces.append(cylinder_piece(radius, z, z + TALL, 12))
    part = Part(meshes, collision=pieces)
    title = "kitchen roll" if stand == "none" else f"kitchen roll on a stand with a {stand}"
    title = "kitchen roll on a slab of stone" if stand == "slab" else title
    mass = {"none": 0.25, "slab": 1.5}.get(stand, 0.8)
    return Model(title, {"body": part}, mass, texture_size=128)


def kitchen_roll_random(rng: np.random.Generator) -> dict:
    return {}


MODELS = {
    "kitchen_roll": Maker(
        kitchen_roll,
        kitchen_roll_random,
        8,
        [
            {"stand": "post", "colour": "oak"},
            {"stand": "arm", "colour": "steel", "radius": 0.062},
            {"stand": "slab", "colour": "#e9e6e0", "radius": 0.052, "motif": "leaves",
             "ink": "#8fae8a"},
            {"stand": "none", "radius": 0.065, "motif": "dots", "ink": "#7fa0c8"},
            {"stand": "ring", "colour": "iron", "radius": 0.048},
            {"stand": "post", "colour": "walnut", "radius": 0.066, "motif": "checks",
             "ink": "#c8a0a0"},
            {"stand": "arm", "colour": "iron", "radius": 0.055, "motif": "leaves",
             "ink": "#7fa0b8"},
            {"stand": "post", "colour": "#f0efea", "radius": 0.036},
        ],
    ),
}  # fmt: skip
