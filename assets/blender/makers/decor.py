"""Potted plants and bins."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh, cube_project
from toolkit.model import (
    Container,
    Maker,
    Model,
    Support,
    cylinder_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import lathe, loft, spline, tube

from .joinery import Assembly

Offset = tuple[float, float, float]


def leaf(
    length: float,
    width: float,
    bend: float,
    mat: Material,
    thickness: float = 0.005,
    sections: int = 6,
) -> Mesh:
    """A leaf along +X, bending down, grooved along the middle; closed: it shows from below too."""
    rings = []
    for t in np.linspace(0, 1, sections):
        half = width / 2 * math.sin(math.pi * min(1.0, 0.12 + 0.86 * t)) ** 0.8 + 0.002
        z = length * (0.35 * t - bend * t * t)
        x = length * t
        rings.append(
            np.array(
                [
                    (x, -half, z + half * 0.25),
                    (x, 0, z),
                    (x, half, z + half * 0.25),
                    (x, 0, z - thickness),
                ]
            )
        )
    return cube_project(loft(rings, mat))


def plant_pot(
    kind: str = "broad",
    height: float = 1.0,
    pot: str = "#b5623f",
    seed: int = 0,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A potted plant: "broad" leaves on stems, a "palm", or upright "blades"."""
    rng, asm = np.random.default_rng(seed), Assembly()
    r, tall = 0.15, 0.28
    clay = plain(pot, 0.05, 25, offset)
    profile = [
        (0, 0),
        (r * 0.72, 0),
        (r * 0.76, 0.01),
        (r, tall),
        (r * 1.02, tall + 0.004),
        (r * 0.9, tall + 0.004),
    ]
    profile += [(r * 0.88, tall - 0.035), (0, tall - 0.03)]
    soil = plain("#4a3627", 0.25, 60)
    asm.add("body", lathe(profile, 24, mats=[clay, soil], mat_of_segment=[0, 0, 0, 0, 0, 0, 1]))
    asm.piece("body", cylinder_piece(r * 0.74, 0, tall, 12, r))
    green = Material(occlusion=0.7)
    tint = green.remap(green.noise(14, 3, offset=offset), 0.35, 0.65)
    green.colour(green.mix(tint, "#2f6b33", "#5f9c48"))
    stem = plain("#5f7a3c", 0.1, 40)
    base = np.array([0, 0, tall - 0.03])
    crown = height - tall
    count = {"broad": 12, "palm": 10, "blades": 15}[kind]
    for k in range(count):
        a = 2.4 * k + rng.uniform(-0.25, 0.25)  # golden angle: leaves avoid one another
        lift = (k + 0.5) / count
        out = np.array([math.cos(a), math.sin(a), 1.0])
        if kind == "blades":
            length = crown * rng.uniform(0.75, 1.0)
            blade = (
                leaf(length, 0.055, -0.05, green, 0.008)
                .turn(ry=-(math.pi / 2 - 0.12 - 0.4 * rng.random()))
                .turn(rz=a)
            )
            foot = base + out * [0.05 * rng.random(), 0.05 * rng.random(), 0]
            asm.add("body", blade.move(*foot))
            continue
        reach = 0.06 + 0.1 * (1 - lift)
        top = base + out * [reach, reach, crown * (0.25 + 0.6 * lift)]
        bend = base + out * [0.25 * reach, 0.25 * reach, crown * 0.5 * (0.25 + 0.6 * lift)]
        asm.add(
            "body",
            tube(
                spline([base, bend, top], 2), [0.008, 0.007, 0.006, 0.005, 0.005], 5, mat=stem
            ).weigh(0.5),
        )
        if kind == "palm":
            for s in range(-2, 3):
                frond = (
                    leaf(crown * 0.42, 0.05, 0.45, green, sections=4)
                    .turn(ry=-0.35 - 0.5 * lift)
                    .turn(rz=a + 0.42 * s)
                )
                asm.add("body", frond.move(*top).weigh(0.7))
        else:
            size = rng.uniform(0.85, 1.15)
            blade = (
                leaf(0.3 * size, 0.16 * size, 0.55, green).turn(ry=-0.25 - 0.7 * lift).turn(rz=a)
            )
            asm.add("body", blade.move(*top))
    radius = 0.08 if kind == "blades" else 0.16
    asm.piece("body", cylinder_piece(radius, tall + 0.05, height * 0.9, 8))
    return Model(
        title=f"potted plant, {kind} leaves",
        parts=asm.parts(),
        mass=7.0,
        ground_shadow=True,
        prune=False,
    )


def plant_pot_random(rng: np.random.Generator) -> dict:
    """Parameters of a random potted plant."""
    return {
        "kind": pick(rng, ["broad", "palm", "blades"]),
        "height": round(float(rng.uniform(0.85, 1.2)), 2),
        "pot": pick(rng, ["#b5623f", "#e4e1da", "#4d5b63"]),
        "seed": seed_of(rng),
        "offset": noise_offset(rng),
    }


def trash_bin(
    height: float = 0.42,
    radius: float = 0.15,
    colour: str = "#5b6470",
    bag: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An open bin, hollow; `bag` turns a white liner over its rim."""
    asm, r0 = Assembly(), radius * 0.8
    shell, inner = (
        plain(colour, 0.03, 20, offset),
        plain("#f0f0ee" if bag else shade(colour, 0.7), 0.04, 25, offset),
    )
    t = 0.008
    profile = [
        (0, 0),
        (r0, 0),
        (r0 + 0.004, 0.01),
        (radius, height - 0.01),
        (radius + 0.004, height),
        (radius - t + 0.004, height),
    ]
    profile += [(radius - t, height - 0.02), (r0 - t, 0.02), (0, 0.016)]
    asm.add(
        "body", lathe(profile, 28, mats=[shell, inner], mat_of_segment=[0, 0, 0, 0, 1, 1, 1, 1])
    )
    if bag:
        hem = height - 0.07
        q = radius - (radius - r0) * 0.07 / height
        fold = [
            (q + 0.002, hem),
            (q + 0.007, hem),
            (radius + 0.012, height - 0.004),
            (radius + 0.006, height + 0.006),
            (radius - 0.008, height + 0.004),
            (radius - 0.004, height - 0.01),
        ]
        asm.add(
            "body",
            lathe(
                fold, 28, mat=inner, rib=lambda k, i: 1 + 0.008 * math.sin(7.3 * i) * (k in (0, 1))
            ),
        )
    for piece in ring_pieces(
        [(r0, 0.0), (radius, height)], [(r0 - t, 0.0), (radius - t, height)], 10
    ):
        asm.piece("body", piece)
    asm.piece("body", cylinder_piece(r0, 0, 0.016))
    return Model(
        title="open bin",
        parts=asm.parts(),
        mass=1.4,
        supports=[Support("floor", 0.016, round_polygon(r0 - 0.02, 12), "body", None, "inside")],
        containers=[
            Container("inside", (0, 0, height / 2 + 0.01), (1.35 * r0, 1.35 * r0, height - 0.02))
        ],
        ground_shadow=True,
        texture_size=128,
    )


def trash_bin_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bin."""
    return {
        "height": round(float(rng.uniform(0.34, 0.48)), 2),
        "radius": round(float(rng.uniform(0.13, 0.17)), 3),
        "colour": pick(rng, ["#5b6470", "#b9bdc0", "#3f6b52", "#d9d6cf"]),
        "bag": bool(rng.random() < 0.5),
        "offset": noise_offset(rng),
    }


MODELS = {
    "plant_pot": Maker(
        plant_pot,
        plant_pot_random,
        3,
        [
            {"kind": "broad", "pot": "#e4e1da"},
            {"kind": "blades", "pot": "#b5623f"},
            {"kind": "palm", "pot": "#4d5b63"},
        ],
    ),
    "trash_bin": Maker(
        trash_bin,
        trash_bin_random,
        2,
        [{"colour": "#5b6470", "bag": True}, {"colour": "#b9bdc0", "bag": False}],
    ),
}
