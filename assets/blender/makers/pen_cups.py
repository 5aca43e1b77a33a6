"""Pens in a cup, a stand or a tray."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, rounded_rectangle, tube

from makers.choking import loose
from makers.solids import cylinder, flattened, solids

COLOURS = ["#d8303a", "#2f6fc0", "#f2b92c", "#2f9a5a", "#26282c", "#e87a2c", "#7b3fb5", "#e0609a"]


def _pen(k: int, tall: float) -> Mesh:
    """A pencil (odd) or a ball pen (even), standing on the origin."""
    colour = COLOURS[k % 8]
    if k % 2:
        shape = [(0, 0), (0.0045, 0), (0.0045, tall - 0.02), (0.0012, tall - 0.002), (0, tall)]
        mats = [plain(colour, 0.02), plain("#e2bd88", 0.05)]
        return lathe(shape, 6, mats=mats, mat_of_segment=[0, 0, 1, 1])
    shape = [(0, 0), (0.005, 0), (0.005, tall - 0.05), (0.0062, tall - 0.05), (0.0055, tall)]
    mats = [plain("#f0f0ee", 0.0), plain(colour, 0.02)]
    return lathe([*shape, (0, tall)], 6, mats=mats, mat_of_segment=[0, 0, 1, 1, 1])


def _bunch(radius: float, count: int, base: float, crayons: bool) -> list[Mesh]:
    """Pens leaning outward all round."""
    rng = np.random.default_rng(11)
    out = []
    for k in range(count):
        a = TAU * k / count + float(rng.normal(0, 0.15))
        tall = float(rng.uniform(0.145, 0.175)) - base
        pen = _pen(2 * k + 1 if crayons else k, tall)
        lean = float(rng.uniform(0.1, 0.22))
        x = radius * 0.55 - 0.1 * math.sin(lean)
        out.append(pen.turn(ry=lean).move(x, 0, base + 0.006).turn(rz=a))
    return out


def pen_cup(kind: str, colour: str, crayons: bool) -> Model:
    """'cup', 'mesh' (of wire), 'mug', 'block' (of wood, with holes), 'tidy' (compartments), 'cat'
    (an animal's head) or 'fallen' (the cup on its side)."""
    paint, inside = plain(colour, 0.04), plain(shade(colour, 0.5), 0.02)
    ruler = box(0.005, 0.026, 0.19, (0, 0, 0), plain("#e9cf7a", 0.05)).turn(rx=-0.1)
    r, h = 0.04, 0.1
    if kind == "mesh":
        paint = metal("5a5f66", "2c2f33", (9, 9, 9), 160)
    if kind in ("cup", "mesh", "mug", "cat", "fallen"):
        if kind == "cat":
            r, h = 0.046, 0.085
        profile = [(0, 0), (r, 0), (r, h), (r - 0.005, h), (r - 0.005, h * 0.5), (0, h * 0.5)]
        cup = [lathe(profile, 16, mats=[paint, inside], mat_of_segment=[0, 0, 0, 1, 1])]
    pens = _bunch(r, 6, 0.0, crayons)
    if kind == "fallen":
        cup[0].keep_pattern().turn(ry=-math.pi / 2).move(0, 0, r)  # the mouth points to -X
        cup[0].turn(rz=math.pi)
        pieces = [cup]
        for k, (x, y, turn) in enumerate(
            (
                (0.11, -0.05, 0.5),
                (0.125, -0.005, -0.15),
                (0.115, 0.04, -0.6),
                (0.09, 0.075, 0.2),
                (0.15, 0.02, 1.2),
            )
        ):
            pen = _pen(k, 0.15).keep_pattern().move(z=-0.075).turn(ry=math.pi / 2).turn(rz=turn)
            pieces.append([pen.move(x + 0.02, y, 0.006)])
        for k in (5, 6):
            pen = _pen(k, 0.15).keep_pattern().turn(ry=math.pi / 2 + 0.12)
            pieces[0].append(pen.move(0.045, 0.012 * (k - 5.5), 0.028))
        model = loose("fallen cup of pens", pieces, 0.2, size=128)
        model.parts["body"].collision = solids(*(flattened(p, 0.0) for p in pieces))
        return model
    if kind in ("cup", "mesh"):
        meshes = [*cup, *pens, ruler.move(-0.008, -0.004, 0.006)]
    elif kind == "mug":
        ear = [
            (0, r + 0.028 * math.sin(a) - 0.003, h * 0.5 + 0.03 * math.cos(a))
            for a in np.linspace(0.2, 2.94, 8)
        ]
        meshes = [*cup, tube(ear, 0.006, 7, mat=paint), *pens]
    elif kind == "cat":
        meshes = [*cup, *pens]
        white, ink = plain("#f6f4ee", 0), plain("#1c1614", 0)
        for q in (-1, 1):
            ear = cylinder(0.018, 0.028, (r * 0.72, q * 0.022, h - 0.004), paint, 4, top=0.002)
            meshes.append(ear)
            meshes.append(
                ellipsoid((0.005, 0.0095, 0.012), (r * 0.93, q * 0.017, h * 0.62), 8, 5, white)
            )
            meshes.append(
                ellipsoid((0.004, 0.005, 0.007), (r * 0.99, q * 0.016, h * 0.61), 6, 4, ink)
            )
        meshes.append(
            ellipsoid((0.006, 0.006, 0.005), (r + 0.002, 0, h * 0.47), 6, 4, plain("#e0708a", 0))
        )
    elif kind == "block":
        grain = wood(colour, shade(colour, 0.65), 1, 12)
        meshes = [box(0.075, 0.15, 0.06, (0, 0, 0), grain, 0.005)]
        hole = plain("#2a1c12", 0)
        for k in range(8):
            x, y = 0.017 * (-1) ** k, -0.058 + 0.0165 * k
            meshes.append(cylinder(0.007, 0.001, (x, y, 0.0595), hole, 8))
            if k not in (2, 5):
                pen = _pen(2 * k + 1 if crayons else k, 0.13)
                meshes.append(pen.turn(rx=0.05 * math.sin(5 * k)).move(x, y, 0.035))
    else:  # three boxes of falling height
        meshes = []
        for k, tall in enumerate((0.11, 0.085, 0.05)):
            ring = rounded_rectangle(0.075, 0.06, 0.008, 3)
            wall = extrude(ring, tall, mat=paint)
            top = extrude(rounded_rectangle(0.066, 0.051, 0.006, 2), 0.001, mat=inside)
            meshes += [wall.move(y=0.062 * (k - 1)), top.move(0, 0.062 * (k - 1), tall - 0.0004)]
        for k in range(6):
            pen = _pen(k, 0.1 + 0.01 * (k % 3)).turn(
                ry=0.12 * math.sin(3 * k), rx=0.1 * math.cos(2 * k)
            )
            meshes.append(
                pen.move(0.02 * math.sin(2.2 * k), -0.075 + 0.062 * (k % 2) + 0.01 * (k % 3), 0.06)
            )
        note = box(0.045, 0.045, 0.022, (0, 0.062, 0.045), plain("#f6e04a", 0.03))
        meshes.append(note)
    low = [m for m in meshes if m.v[:, 2].min() < 0.005 and m.v[:, 2].max() < 0.115]
    high = [m for m in meshes if m not in low]
    body = Part(meshes, collision=solids(low or meshes[:1], high))
    return Model("cup of pens", {"body": body}, mass=0.22, texture_size=128)


def pen_cup_random(rng: np.random.Generator) -> dict:
    return {"kind": "cup", "colour": pick(rng, ["#2f7f8f", "#e8e2d4", "#c8402c"]), "crayons": False}


MODELS = {
    "pen_cup": Maker(
        pen_cup,
        pen_cup_random,
        7,
        [
            {"colour": "#e8e2d4"},
            {"kind": "mesh", "colour": "#5a5f66"},
            {"kind": "mug", "colour": "#2f7fc0", "crayons": True},
            {"kind": "block", "colour": "#c8965a", "crayons": True},
            {"kind": "tidy", "colour": "#3a3d43"},
            {"kind": "cat", "colour": "#e8a04a"},
            {"kind": "fallen", "colour": "#c8402c"},
        ],
    ),
}
