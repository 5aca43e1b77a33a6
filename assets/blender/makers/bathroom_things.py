"""Toilet paper, toothbrushes in a cup, hairbrush."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.model import (
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
    ring_pieces,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    box,
    ellipsoid,
    extrude,
    lathe,
    loft,
    spline,
    superellipse,
)


def toilet_paper(radius: float, pattern: bool, tail: bool, seed: int) -> Model:
    """A standing roll with its cardboard core and, if wanted, a loose end."""
    rng = np.random.default_rng(seed)
    height, core = 0.1, 0.021
    paper = Material()
    base = paper.mottle("#f5f3ee", 0.03, 120, noise_offset(rng))
    dots = paper.voronoi(90, noise_offset(rng), randomness=0.2)
    paper.colour(
        paper.mix(paper.remap(dots, 0.1, 0.35, 0.16 if pattern else 0.05, 0), base, "b9b4ac")
    )
    ends = Material()
    rings = ends.math("SINE", ends.math("MULTIPLY", ends.distance((0, 0, height), (1, 1, 0)), 1500))
    ends.colour(ends.mix(ends.remap(rings, -1, 1, 0, 0.22), "f5f3ee", "a9a49a"))
    card = plain("#b08a5e", 0.08, 200)
    profile = [
        (core, 0.001),
        (radius - 0.003, 0),
        (radius, 0.003),
        (radius, height - 0.003),
        (radius - 0.003, height),
        (core, height - 0.001),
        (core - 0.002, height - 0.0005),
        (core - 0.002, 0.0005),
        (core, 0.001),
    ]
    roll = lathe(profile, 26, mats=[paper, ends, card], mat_of_segment=[1, 0, 0, 0, 1, 2, 2, 2])
    meshes = [roll]
    if tail:
        points = [
            (radius - 0.004, -0.03),
            (radius + 0.002, 0.0),
            (radius + 0.006, 0.03),
            (radius + 0.02, 0.06),
        ]
        curve = spline(points, 3)
        outline = np.r_[curve, curve[::-1] + np.array([0.005, 0.0])]
        meshes.append(extrude(outline, height - 0.004, mat=paper).move(z=0.002))
    pieces = [cylinder_piece(radius, 0, height, 16)]
    return Model(
        "roll of toilet paper",
        {"body": Part(meshes, collision=pieces)},
        mass=0.12,
        friction=0.7,
        texture_size=128,
    )


def toilet_paper_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.05, 0.06),
        "pattern": True,
        "tail": False,
        "seed": seed_of(rng),
    }


def toothbrush_cup(cup: str, first: str, second: str, paste: str, height: float) -> Model:
    """A cup with two toothbrushes and a tube of toothpaste standing in it."""
    r, wall = 0.037, 0.0045
    ceramic, inner = plain(cup, 0.04), plain(shade(cup, 0.9), 0.03)
    profile = [
        (0, 0.002),
        (r * 0.84, 0.0),
        (r * 0.9, 0.003),
        (r, height - 0.002),
        (r - wall / 2, height),
        (r - wall, height - 0.002),
        (r * 0.9 - wall, 0.008),
        (0, 0.007),
    ]
    vessel = lathe(profile, 20, mats=[ceramic, inner], mat_of_segment=[0] * 5 + [1, 1])
    meshes = [vessel]
    hair = plain("#f4f6f8", 0.05)
    for colour, lean, turn in ((first, 0.2, 0.5), (second, -0.17, 2.5)):
        stick = extrude(
            [
                (-0.0045, 0),
                (0.0045, 0),
                (0.006, 0.06),
                (0.0035, 0.12),
                (0.0042, 0.15),
                (0.0065, 0.16),
                (0.0065, 0.185),
                (-0.0065, 0.185),
                (-0.0065, 0.16),
                (-0.0042, 0.15),
                (-0.0035, 0.12),
                (-0.006, 0.06),
            ],
            0.0062,
            mat=plain(colour, 0.03),
            axis="y",
            bevel_width=0.0012,
        )
        bristles = box(0.0125, 0.015, 0.028, (0, -0.0105, 0.157), hair)
        tip = box(0.0128, 0.004, 0.01, (0, -0.0165, 0.166), plain(colour, 0.03))
        for mesh in (stick, bristles, tip):
            mesh.turn(rz=turn).turn(ry=lean).move(-math.sin(lean) * 0.06, 0.004 * lean, 0.01)
            meshes.append(mesh)
    tube_mat, lid = plain(paste, 0.02), plain("#f7f7f5", 0.02)
    rings = [
        superellipse(0.017 * a, 0.017 * b, 2, 12, z)
        for z, a, b in ((0.015, 0.8, 0.8), (0.04, 1, 1), (0.09, 1.08, 0.7), (0.142, 1.22, 0.12))
    ]
    squeeze = loft(rings, mat=tube_mat)
    band = loft(
        [
            superellipse(0.0175 * a, 0.0175 * b, 2, 12, z)
            for z, a, b in ((0.1, 1.12, 0.66), (0.125, 1.2, 0.4))
        ],
        mat=plain("#f2f4f6", 0.0),
    )
    for mesh in (squeeze, band):
        meshes.append(mesh.turn(rz=1.2).turn(rx=0.14).move(0.002, 0.012, 0))
    meshes.append(
        lathe([(0, 0.008), (0.011, 0.008), (0.012, 0.022), (0, 0.022)], 10, mat=lid).move(
            0, 0.012, 0
        )
    )
    pieces = [
        cylinder_piece(r * 0.9, 0, 0.01, 12),
        *ring_pieces([(r * 0.9, 0), (r, height)], [(r * 0.9 - wall, 0.008), (r - wall, height)], 8),
        box_piece((0, 0.006, 0.1), (0.03, 0.03, 0.13)),
    ]
    return Model(
        "cup with toothbrushes and toothpaste", {"body": Part(meshes, collision=pieces)}, mass=0.32
    )


def toothbrush_cup_random(rng: np.random.Generator) -> dict:
    first, second = pick(
        rng, [("#d8303a", "#2f7fd8"), ("#2f9a5a", "#e8862c"), ("#8a4fc0", "#1fa8b0")]
    )
    return {
        "cup": pick(rng, ["#f4f3ee", "#8fc3cf", "#3a5a78"]),
        "first": first,
        "second": second,
        "paste": pick(rng, ["#1f8fd0", "#2fa07a", "#d8303a"]),
        "height": uniform(rng, 0.095, 0.11),
    }


def hairbrush(wooden: bool, colour: str, pad: str, length: float) -> Model:
    """A paddle brush on its back, bristles up."""
    s = length / 0.24
    handle_mat = plain(colour, 0.08 if wooden else 0.03, 60)
    outline = (
        spline(
            [
                (0.12, 0),
                (0.105, 0.028),
                (0.065, 0.036),
                (0.02, 0.026),
                (-0.01, 0.011),
                (-0.06, 0.009),
                (-0.105, 0.0125),
                (-0.12, 0),
                (-0.105, -0.0125),
                (-0.06, -0.009),
                (-0.01, -0.011),
                (0.02, -0.026),
                (0.065, -0.036),
                (0.105, -0.028),
            ],
            2,
            closed=True,
        )
        * s
    )
    body = extrude(outline, 0.014 * s, mat=handle_mat, bevel_width=0.004)
    cushion = ellipsoid(
        (0.046 * s, 0.028 * s, 0.009 * s), (0.065 * s, 0, 0.013 * s), 16, 6, plain(pad, 0.04)
    )
    meshes = [body, cushion]
    pin_mat = plain("#2a2a2e" if pad != "#26262a" else "#d8d4cc", 0.0)
    for i in range(-3, 4):
        for j in range(-2, 3):
            x, y = 0.012 * i * s, (0.0105 * j + 0.005 * (i % 2)) * s
            if (x / 0.042) ** 2 + (y / 0.026) ** 2 > 1.05 * s * s:
                continue
            z = 0.019 * s
            pin = [(0.0017, z - 0.006), (0.0015, z + 0.013), (0, z + 0.015)]
            meshes.append(lathe(pin, 4, mat=pin_mat, weight=0.3).move(0.065 * s + x, y))
    pieces = [
        box_piece((0.065 * s, 0, 0.014 * s), (0.105 * s, 0.066 * s, 0.028 * s)),
        box_piece((-0.05 * s, 0, 0.007 * s), (0.14 * s, 0.022 * s, 0.014 * s)),
    ]
    return Model("hairbrush", {"body": Part(meshes, collision=pieces)}, mass=0.09, texture_size=128)


def hairbrush_random(rng: np.random.Generator) -> dict:
    return {
        "wooden": True,
        "colour": pick(rng, ["#b07a45", "#8a5a30"]),
        "pad": pick(rng, ["#c8453a", "#26262a"]),
        "length": uniform(rng, 0.22, 0.25),
    }


MODELS = {
    "toilet_paper": Maker(
        toilet_paper, toilet_paper_random, 2, [{"tail": True}, {"pattern": False}]
    ),
    "toothbrush_cup": Maker(
        toothbrush_cup,
        toothbrush_cup_random,
        2,
        [
            {"cup": "#f4f3ee", "first": "#d8303a", "second": "#2f7fd8", "paste": "#1f8fd0"},
            {"cup": "#8fc3cf", "first": "#2f9a5a", "second": "#e8862c"},
        ],
    ),
    "hairbrush": Maker(
        hairbrush,
        hairbrush_random,
        2,
        [{"pad": "#c8453a"}, {"wooden": False, "colour": "#2a2c34", "pad": "#d88aa8"}],
    ),
}
