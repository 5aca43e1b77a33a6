"""Carrier bags that lie crumpled, and walking sticks that lie."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import label, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.shapes import lathe, loft, superellipse, tube

from makers.convex import few_corners
from makers.projection import project_label


def print_on_bag(ground: str, ink: str, words: str) -> Image.Image:
    """What a shop prints on its bags."""
    image, draw = labels.canvas(200, 240, ground)
    for k, word in enumerate(words.split()):
        labels.text(draw, word, (24, 54 + 62 * k, 176, 110 + 62 * k), "bold", ink)
    for k in range(12):  # creases catch the light
        x = (k * 53) % 200
        draw.line([(x, 0), (x - 40 + (k * 29) % 80, 240)], fill=_tint(ground, 0.86), width=2)
    draw.rectangle((20, 24, 180, 38), fill=ink)
    return image.convert("RGB")


def _tint(colour: str, factor: float) -> str:
    return "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, factor))


def strap(line, half: float, mat) -> Mesh:
    """A flat band along a line, seen from both sides, lying nearly level."""
    path = np.array(line, float)
    along = np.gradient(path, axis=0)
    across = np.c_[-along[:, 1], along[:, 0], 0 * along[:, 0]]
    across /= np.linalg.norm(across, axis=1)[:, None] + 1e-9
    rings = []
    up = np.array([0, 0, 0.004])
    for p, a in zip(path, across * half, strict=True):
        rings.append([p - a, p + up, p + a, p - up])
    return loft(rings, mat)


def plastic_bag(
    length: float, width: float, height: float, ground: str, ink: str, words: str, seed: int
) -> Model:
    """A thin bag thrown down: its bottom towards -x, its mouth and two handles towards +x."""
    rng = np.random.default_rng(seed)
    film = plain(ground, 0.12, 45)
    n, rings = 16, []
    profile = [(0.0, 0.7, 0.16), (0.04, 0.96, 0.5), (0.2, 1.0, 1.0), (0.42, 0.94, 0.85)]
    profile += [(0.64, 0.9, 0.6), (0.84, 0.86, 0.42), (1.0, 0.8, 0.3)]
    swing = rng.normal(0, 0.035, (len(profile), 2))
    for k, (t, w, h) in enumerate(profile):
        half = h * height / 2
        ring = superellipse(half, w * width / 2, 2.6, n)
        points = np.array([(t * length, y, z + half) for z, y, _ in ring])
        bump = rng.normal(0, 1, n)
        up = points[:, 2] > 0.3 * half
        points[:, 2] += up * bump * 0.14 * height * min(1.0, h + 0.2)
        points[:, 1] += swing[k, 0] * width + rng.normal(0, 0.018, n) * width
        points[:, 0] += rng.normal(0, 0.02, n) * length * (0 < k < len(profile) - 1)
        points[:, 2] = np.maximum(points[:, 2], 0.0)
        rings.append(points)
    mouth = rings[-1]
    middle = mouth.mean(0)
    inner = middle + (mouth - middle) * [1, 0.93, 0.7] - [0.004, 0, 0]
    deep = middle + (mouth - middle) * [1, 0.8, 0.35] - [0.09, 0, 0]
    body = loft(
        [*rings, inner, deep],
        mats=[film, plain(shade(ground, 0.62), 0.1)],
        mat_of_face=lambda k, i: 1 if k >= len(rings) else 0,
    )
    body.flat()  # every facet for itself, as crumpled film is
    picture = label(print_on_bag(ground, ink, words))
    # read from the mouth's end
    project_label(body, picture, "+z", (0.0, -0.48 * length), (0.8 * width, 0.78 * length), 0.45)
    meshes = [body]
    for side in (-1, 1):
        y0 = side * 0.27 * width
        bend = float(rng.normal(0, 0.02))
        for lift, lean in ((0.16 * height, 1.0), (0.02 * height, 1.35)):
            line = [
                (0.94 * length, y0 + 0.03 * side, lift + 0.006),
                (1.1 * length, y0 + 0.035 * side * lean, lift + 0.02),
                (1.22 * length, y0 + bend * lean, lift + 0.012),
                (1.2 * length, y0 - 0.05 * side * lean, lift + 0.006),
                (1.08 * length, y0 - 0.04 * side, lift + 0.014),
                (0.95 * length, y0 - 0.035 * side, lift + 0.006),
            ]
            meshes.append(strap(line, 0.017, film).flat().weigh(0.6))
    pieces = [few_corners(np.concatenate(rings), 30)]
    pieces.append(few_corners(np.concatenate([m.v for m in meshes[1:]]), 20))
    return Model(
        "crumpled plastic bag",
        {"body": Part(meshes, collision=pieces)},
        mass=0.015,
        friction=0.6,
        texture_size=128,
        prune=False,
    )


def walking_stick(form: str, length: float, light: str, dark: str) -> Model:
    """A stick lying along y: with a "crook" in the plane it lies in, or a straight "grip"."""
    r = 0.0105
    grain = wood(light, dark, 1, 8)
    rubber, brass = plain("#26262a", 0.06), plain("#c8a24a", 0.08)
    end = -length / 2
    top = length / 2 - (0.06 if form == "crook" else 0.016)
    shaft = [(0, end + 0.03, r), (0, 0, r), (0, top, r)]
    if form == "crook":
        bend = 0.052
        t = np.linspace(0, 1.12 * math.pi, 9)
        arc = [(bend - bend * math.cos(a), top + bend * math.sin(a), r) for a in t]
        line = [*shaft, *arc[1:]]
        meshes = [tube(line, r, 8, mat=grain)]
        hook = np.array([(x + dx, y, z) for x, y, _ in arc for dx in (-r, r) for z in (0, 2 * r)])
        knobs = [hook[: len(hook) // 2 + 2], hook[len(hook) // 2 - 2 :]]
    else:
        grip = plain("#2c2826", 0.12, 140)
        meshes = [tube(shaft, r, 8, mat=grain)]
        line = [(-0.035, top - 0.004, r), (-0.02, top + 0.004, r), (0.02, top + 0.006, r)]
        line += [(0.06, top + 0.0, r), (0.088, top - 0.014, r)]
        meshes.append(tube(line, [0.012, 0.0155, 0.0145, 0.013, 0.009], 8, mat=grip, flatten=0.72))
        knobs = []
    collar = lathe([(0, -0.02), (r + 0.0015, -0.02), (r + 0.0015, 0.02), (0, 0.02)], 10, mat=brass)
    foot = [(0, -0.035), (0.0165, -0.035), (0.0155, -0.018), (0.0125, 0.012), (0, 0.012)]
    tip = lathe(foot, 10, mat=rubber)
    meshes.append(collar.turn(rx=-math.pi / 2).move(0, top - 0.05, r))
    meshes.append(tip.turn(rx=-math.pi / 2).move(0, end + 0.035, 0.0165))
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for mesh in meshes:
        mesh.move(z=-low)
    pole = np.array([(x, y, z) for x in (-r, r) for y in (end + 0.03, top) for z in (0, 2 * r)])
    if form == "crook":
        knobs = [knob - [0, 0, low] for knob in knobs]
    else:
        knobs = [few_corners(meshes[1].v, 30)]
    return Model(
        "walking stick",
        {"body": Part(meshes, collision=[pole - [0, 0, low], few_corners(tip.v, 20), *knobs])},
        mass=0.35,
        friction=0.7,
        texture_size=128,
    )


def nothing_random(rng: np.random.Generator) -> dict:
    return {}


_BAG = {"length": 0.34, "width": 0.29, "height": 0.1, "seed": 4}

MODELS = {
    "plastic_bag": Maker(
        plastic_bag,
        nothing_random,
        3,
        [
            _BAG | {"ground": "#f4f6f6", "ink": "#d0202c", "words": "THANK YOU"},
            _BAG | {"ground": "#3f8fd0", "ink": "#f8f8f4", "words": "SHOP SMART"},
            {"length": 0.3, "width": 0.32, "height": 0.085, "seed": 9}
            | {"ground": "#f2c430", "ink": "#1f5f3a", "words": "FRESH MARKET"},
        ],
    ),
    "walking_stick": Maker(
        walking_stick,
        nothing_random,
        2,
        [
            {"form": "crook", "length": 0.9, "light": "#a8743c", "dark": "#6a4220"},
            {"form": "grip", "length": 0.88, "light": "#5a3420", "dark": "#2f1a10"},
        ],
    ),
}
