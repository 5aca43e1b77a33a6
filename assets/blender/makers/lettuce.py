"""Heads of lettuce; fresh, overripe (yellowed, limp) and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, blend
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import ellipsoid

from makers.spoilage import age, aged

LETTUCES = {"green": ("#4f9a2c", "#8fc84a", "#e4f0b8"), "red": ("#6a2438", "#7a9a3a", "#e0e8b0")}


def leaf_picture(edge: str, middle: str, vein: str):
    """A leaf from its pale foot (bottom) to its frilly edge (top), with branching veins."""
    image = labels.gradient(128, 128, edge, middle)
    from PIL import ImageDraw

    d = ImageDraw.Draw(image)
    d.polygon([(52, 128), (76, 128), (67, 20), (61, 20)], fill=vein)
    for k in range(5):
        y = 112 - 20 * k
        for side in (-1, 1):
            x = 64 + side * (48 - 3 * k)
            d.line((64, y, 64 + side * 24, y - 15, x, y - 24), fill=vein, width=4 - k // 2)
    return image


def lettuce(size=1.0, kind="green", leaves=8, seed=0) -> Model:
    """A tight heart with loose outer leaves."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    edge, middle, vein = LETTUCES[kind]
    r = 0.07 * s
    turns = [math.tau * i / leaves + rng.uniform(-0.15, 0.15) for i in range(leaves)]
    phases = rng.uniform(0, 6.28, leaves)
    spots = [
        (r * 0.6, r * 0.35, r * 1.75),
        (-r * 0.75, r * 0.45, r * 1.55),
        (0, -r * 0.85, r * 1.55),
        (r * 1.1, -r * 0.35, r * 1.0, 0.9),
        (r * 0.25, r * 1.15, r * 0.9, 0.9),
        (-r * 1.05, -r * 0.45, r * 1.0, 0.9),
    ]

    def skin(look: str, heart: bool) -> Material:
        m = Material(occlusion=0.8)
        if heart:
            folds = m.math(
                "ABSOLUTE", m.math("SUBTRACT", m.noise(26, 2, distortion=1.0, offset=o), 0.5)
            )
            c = m.mix(
                m.remap(m.noise(18, 3, offset=o), 0.35, 0.65), middle, blend(middle, vein, 0.5)
            )
            c = m.mix(m.remap(folds, 0.0, 0.035, 0.8, 0), c, vein)
        else:
            c = m.image(leaf_picture(edge, middle, vein))
            c = m.mix(m.remap(m.noise(50, 3, offset=o), 0.4, 0.65, 0, 0.3), c, edge)
        if look == "overripe":
            c = m.mix(0.55, c, "c8b84a")
        return m.colour(age(look, m, c, r * 1.05, spots, o, "2a1c0e", 0.6))

    def leaf(turn: float, phase: float, wraps: bool, look: str, mat: Material) -> Mesh:
        nu, nv = 5, 4
        droop = {"fresh": 0.0, "overripe": 0.12, "rotten": 0.2}[look]
        points, uv = [], []
        for j in range(nv):
            v = j / (nv - 1)
            up = -1.1 + ((2.35 if wraps else 1.6) - droop) * v
            flare = 0.03 if wraps else 0.3 + 0.3 * droop
            for i in range(nu):
                u = 2 * i / (nu - 1) - 1
                ruffle = (0.03 if wraps else 0.08) * v * math.sin(4.2 * u + phase) + 0.04 * v * (
                    i % 2
                )
                q = r * (1.03 + flare * v * v + ruffle)
                a = turn + u * (0.4 + (0.75 if wraps else 0.3) * v)
                high = q * math.sin(up) * (1 - 0.1 * u * u * v)
                points.append(
                    (q * math.cos(up) * math.cos(a), q * math.cos(up) * math.sin(a), high + r)
                )
                uv.append((0.5 + u / 2, v))
        faces = []
        for j in range(nv - 1):
            for i in range(nu - 1):
                k = j * nu + i
                faces.append((k, k + 1, k + nu + 1, k + nu))
        shift = len(points)
        middle_ = np.array([0, 0, r])
        inner = [tuple(middle_ + (np.array(p) - middle_) * 0.985) for p in points]
        both = faces + [tuple(i + shift for i in f[::-1]) for f in faces]
        corners = [[uv[i % shift] for i in f] for f in both]
        return Mesh(points + inner, both, None, [mat], corners)

    def shape(look: str) -> list[Mesh]:
        k = {"fresh": 1.0, "overripe": 0.95, "rotten": 0.86}[look]
        heart = ellipsoid((r * 0.97 * k, r * 0.97 * k, r * k), (0, 0, r), 12, 8, skin(look, True))
        mat = skin(look, False)
        out = [
            leaf(t, p, i % 2 == 0, look, mat)
            for i, (t, p) in enumerate(zip(turns, phases, strict=True))
        ]
        return [heart, *out]

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        points = np.concatenate([m.v for m in group])
        return [np.concatenate([points, points * [0.5, 0.5, 0.0]])]

    return aged(f"head of {kind} lettuce", shape, 0.35, solids)


def lettuce_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.95, 1.1), "seed": seed_of(rng)}


MODELS = {
    "lettuce": Maker(lettuce, lettuce_random, count=2, presets=[{}, {"kind": "red"}]),
}
