"""Toy dinosaurs."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, loft, tube

from makers.solids import grounded, grown, solids

# x, z, half height, half width along the back, tail to snout
SPINES = {
    "tyrannosaur": [
        (-0.068, 0.012, 0.0015, 0.0015),
        (-0.05, 0.014, 0.004, 0.004),
        (-0.03, 0.023, 0.009, 0.008),
        (-0.01, 0.034, 0.014, 0.0125),
        (0.01, 0.043, 0.012, 0.011),
        (0.02, 0.055, 0.0085, 0.008),
        (0.024, 0.066, 0.0085, 0.0085),
        (0.034, 0.069, 0.0085, 0.0085),
        (0.048, 0.066, 0.0055, 0.006),
        (0.052, 0.065, 0.003, 0.004),
    ],
    "sauropod": [
        (-0.085, 0.012, 0.0012, 0.0012),
        (-0.06, 0.017, 0.003, 0.003),
        (-0.035, 0.028, 0.008, 0.008),
        (-0.015, 0.034, 0.0145, 0.0145),
        (0.008, 0.035, 0.0145, 0.014),
        (0.024, 0.044, 0.0085, 0.0085),
        (0.034, 0.06, 0.0055, 0.0055),
        (0.041, 0.078, 0.0045, 0.0045),
        (0.046, 0.089, 0.0055, 0.0058),
        (0.055, 0.09, 0.0055, 0.0058),
        (0.064, 0.087, 0.0035, 0.0042),
    ],
    "triceratops": [
        (-0.066, 0.012, 0.0015, 0.0015),
        (-0.045, 0.02, 0.006, 0.006),
        (-0.025, 0.029, 0.0145, 0.0145),
        (0.0, 0.031, 0.0165, 0.0165),
        (0.02, 0.03, 0.0135, 0.0135),
        (0.034, 0.031, 0.0115, 0.0115),
        (0.048, 0.028, 0.009, 0.0085),
        (0.06, 0.023, 0.005, 0.0045),
        (0.064, 0.02, 0.002, 0.0025),
    ],
    "stegosaur": [
        (-0.074, 0.014, 0.0015, 0.0015),
        (-0.052, 0.018, 0.0045, 0.004),
        (-0.03, 0.028, 0.012, 0.01),
        (-0.008, 0.036, 0.018, 0.0145),
        (0.014, 0.032, 0.0145, 0.0125),
        (0.032, 0.023, 0.0075, 0.007),
        (0.045, 0.017, 0.0055, 0.0055),
        (0.058, 0.013, 0.005, 0.0048),
        (0.066, 0.011, 0.0025, 0.003),
    ],
    "pterosaur": [
        (-0.034, 0.03, 0.0015, 0.0015),
        (-0.02, 0.033, 0.0065, 0.0065),
        (-0.002, 0.038, 0.009, 0.0085),
        (0.012, 0.043, 0.006, 0.006),
        (0.02, 0.05, 0.0045, 0.0045),
        (0.026, 0.053, 0.006, 0.0055),
        (0.036, 0.051, 0.0045, 0.0042),
        (0.058, 0.046, 0.0012, 0.0014),
    ],
}


def _body(spine: list, mat: Material, n: int = 9) -> Mesh:
    path = np.array([(x, z) for x, z, _, _ in spine])
    rings = []
    for (x, z, tall, wide), (dx, dz) in zip(spine, np.gradient(path, axis=0), strict=True):
        up = np.array([-dz, dx]) / math.hypot(dx, dz)
        rings.append(
            [
                (x + up[0] * tall * math.cos(a), wide * math.sin(a), z + up[1] * tall * math.cos(a))
                for a in (TAU * k / n for k in range(n))
            ]
        )
    return loft(rings, mat=mat)


def _eyes(x: float, y: float, z: float, size: float = 0.0026) -> list[Mesh]:
    white, black = plain("#f6f4ea", 0), plain("#141416", 0)
    out = []
    for q in (-1, 1):
        out.append(ellipsoid(size, (x, q * y, z), 6, 4, white))
        out.append(ellipsoid(size * 0.62, (x + 0.5 * size, q * (y + 0.6 * size), z), 5, 3, black))
    return out


def _feet(xs, y: float, hip: float, radius: float, mat: Material, nail: Material) -> list[Mesh]:
    """Four pillar legs with pale toes."""
    out = []
    for x in xs:
        for q in (-1, 1):
            leg = [(x, q * y * 0.85, hip), (x + 0.002, q * y, hip / 2), (x, q * y, 0)]
            out.append(tube(leg, [radius * 1.2, radius * 0.85, radius], 7, mat=mat))
            out.append(box(0.003, radius * 1.3, 0.003, (x + radius * 0.9, q * y, 0), nail))
    return out


def _horn(base, tip, radius: float, mat: Material, n: int = 6) -> Mesh:
    return tube([base, tip], [radius, radius * 0.12], n, mat=mat)


def dinosaur(kind: str, length: float, skin: str, belly: str, spikes: str) -> Model:
    """A plastic dinosaur, its head towards +X."""
    hide = Material()
    spots = hide.noise(160, 2, offset=(3, 1, 4))
    patched = hide.mix(hide.remap(spots, 0.54, 0.6), skin, shade(skin, 0.55))
    hide.colour(hide.mix(hide.remap(hide.normal(2), -0.75, -0.5, 1, 0), patched, belly))
    plate, ivory = plain(spikes, 0.05), plain("#f4ecd6", 0.03)
    spine = SPINES[kind]
    body = _body(spine, hide)
    meshes = [body]
    if kind == "tyrannosaur":
        foot = plain(shade(skin, 0.8), 0.05)
        for q in (-1, 1):
            leg = [(-0.008, q * 0.011, 0.034), (0.004, q * 0.014, 0.02), (-0.002, q * 0.014, 0.004)]
            meshes.append(tube(leg, [0.0085, 0.0065, 0.005], 7, mat=hide))
            meshes.append(box(0.022, 0.012, 0.006, (0.005, q * 0.014, 0), foot, 0.0012))
            arm = [(0.017, q * 0.009, 0.046), (0.026, q * 0.011, 0.04), (0.031, q * 0.01, 0.043)]
            meshes.append(tube(arm, [0.0038, 0.0028, 0.002], 5, mat=hide))
        meshes.append(box(0.016, 0.0105, 0.003, (0.044, 0, 0.0612), ivory))
        meshes += _eyes(0.033, 0.0075, 0.0745)
        for x, z, tall, _ in spine[1:7]:
            tip = [(x - 0.005, z + tall * 0.7), (x + 0.004, z + tall * 0.7)]
            tip.append((x - 0.006, z + tall + 0.007))
            meshes.append(extrude(tip, 0.005, plate, axis="y"))
    elif kind == "sauropod":
        meshes += _feet((-0.022, 0.013), 0.0105, 0.03, 0.0062, hide, ivory)
        meshes += _eyes(0.054, 0.0052, 0.0925, 0.0022)
        meshes.append(box(0.001, 0.007, 0.0012, (0.0635, 0, 0.0855), plain(shade(skin, 0.3), 0)))
    elif kind == "triceratops":
        meshes += _feet((-0.024, 0.02), 0.0125, 0.028, 0.0065, hide, ivory)
        frill = [(0, 0), (0.021, 0.001), (0.024, 0.004), (0.021, 0.007), (0, 0.006)]
        collar = lathe(
            frill,
            14,
            mats=[plate, hide],
            mat_of_segment=[1, 1, 0, 1],
            rib=lambda k, i: 1.1 if k == 2 and i % 2 else 1.0,
        )
        meshes.append(collar.scale(1, 1.05, 1).turn(ry=math.pi / 2 - 0.5).move(0.033, 0, 0.039))
        for q in (-1, 1):
            horn = ((0.043, q * 0.0065, 0.036), (0.066, q * 0.011, 0.052))
            meshes.append(_horn(*horn, 0.0032, ivory))
        meshes.append(_horn((0.056, 0, 0.027), (0.063, 0, 0.037), 0.0026, ivory))
        meshes += _eyes(0.047, 0.0078, 0.0325, 0.0022)
    elif kind == "stegosaur":
        meshes += _feet((-0.022, 0.016), 0.0115, 0.028, 0.0056, hide, ivory)
        for k, (x, size) in enumerate(
            (
                (-0.044, 0.4),
                (-0.031, 0.65),
                (-0.016, 0.95),
                (0.002, 1.0),
                (0.018, 0.75),
                (0.031, 0.45),
            )
        ):
            z = np.interp(x, [s[0] for s in spine], [s[1] + s[2] for s in spine]) - 0.002
            s = size * 0.021
            leaf = [
                (x - 0.3 * s, z),
                (x + 0.3 * s, z),
                (x + 0.5 * s, z + 0.55 * s),
                (x, z + s * 1.1),
            ]
            leaf.append((x - 0.5 * s, z + 0.55 * s))
            blade = extrude(leaf, 0.005, plate, axis="y")
            meshes.append(
                blade.turn(rx=-0.12 * (-1) ** k, pivot=(x, 0, z)).move(y=0.0025 * (-1) ** k)
            )
        for x in (-0.066, -0.058):
            for q in (-1, 1):
                meshes.append(_horn((x, 0, 0.018), (x - 0.004, q * 0.012, 0.027), 0.002, ivory, 5))
        meshes += _eyes(0.056, 0.0045, 0.0155, 0.002)
    else:
        for q in (-1, 1):
            wing = [(0.012, 0.006), (0.022, 0.045), (0.006, 0.095), (-0.012, 0.06), (-0.02, 0.03)]
            wing.append((-0.024, 0.005))
            sail = extrude([(x * 1.35, q * y) for x, y in wing], 0.0045, plate)
            sail.warp(lambda x, y, z: (x, y, z + 0.034 - 0.5 * x + 0.12 * abs(y)))
            meshes.append(sail)
            meshes.append(
                tube(
                    [
                        (-0.012, q * 0.005, 0.032),
                        (-0.02, q * 0.009, 0.016),
                        (-0.014, q * 0.011, 0.003),
                    ],
                    [0.004, 0.0028, 0.0025],
                    6,
                    mat=hide,
                )
            )
            meshes.append(box(0.034, 0.012, 0.005, (0.004, q * 0.012, 0), plate))
        meshes.append(_horn((0.024, 0, 0.056), (0.0, 0, 0.071), 0.0042, plate))
        meshes += _eyes(0.028, 0.0048, 0.0555, 0.0022)
    grounded(grown(meshes, length / 0.14))
    cut = np.median(body.v[:, 0])
    front = [m for m in meshes if m.v[:, 0].mean() > cut and m is not body]
    back = [m for m in meshes if not m.v[:, 0].mean() > cut and m is not body]
    pieces = solids([body], *(g for g in (front, back) if g))
    body_part = Part(meshes, collision=pieces)
    return Model("toy dinosaur", {"body": body_part}, mass=0.2, friction=0.5)


def dinosaur_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "tyrannosaur",
        "length": 0.24,
        "skin": pick(rng, ["#4fa83a", "#c8642c"]),
        "belly": "#e8e0a0",
        "spikes": "#e8641c",
    }


MODELS = {
    "dinosaur": Maker(
        dinosaur,
        dinosaur_random,
        7,
        [
            {"skin": "#4fa83a"},
            {"kind": "sauropod", "skin": "#4a86b8", "length": 0.3},
            {"kind": "triceratops", "skin": "#9a7a4a", "spikes": "#c8502c"},
            {"kind": "stegosaur", "skin": "#6a9a3a", "spikes": "#e08a2c", "length": 0.26},
            {"kind": "pterosaur", "skin": "#a8482a", "spikes": "#e8a83c", "length": 0.22},
            {"skin": "#c8582c", "spikes": "#4a2a1c"},
            {"kind": "sauropod", "skin": "#7aa83a", "length": 0.3},
        ],
    ),
}
