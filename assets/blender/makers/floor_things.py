"""Closed umbrellas."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade, wood
from toolkit.model import (
    Model,
    Part,
    box_piece,
)
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    lathe,
    tube,
)


def umbrella(length: float, cloth: str, second: str, crook: bool) -> Model:
    """A closed umbrella lying on its side."""
    s = length / 0.85
    r = 0.036
    skin = Material()
    folds = skin.math(
        "SINE",
        skin.math(
            "ADD",
            skin.math(
                "MULTIPLY",
                skin.math("ARCTAN2", skin.axis(1), skin.math("SUBTRACT", skin.axis(2), r * s)),
                8,
            ),
            skin.math("MULTIPLY", skin.axis(0), 26),
        ),
    )
    skin.colour(skin.mix(skin.remap(folds, -1, 0.6, 0.5, 0), cloth, shade(cloth, 0.4)))
    profile = [
        (0, 0.02),
        (0.009, 0.03),
        (0.016, 0.12),
        (0.026, 0.3),
        (r, 0.5),
        (r * 1.02, 0.56),
        (0.024, 0.585),
        (0.014, 0.58),
        (0, 0.57),
    ]
    canopy = lathe(
        [(a * s, z * s) for a, z in profile],
        16,
        mat=skin,
        rib=lambda k, i: 1 + (0.13 if i % 2 else -0.1) * min(1.0, k / 3),
        discs=False,
    )
    strap = lathe(
        [
            (0.032 * s, 0.4 * s),
            (0.0365 * s, 0.405 * s),
            (0.0375 * s, 0.43 * s),
            (0.034 * s, 0.435 * s),
        ],
        14,
        mat=plain(second, 0.03),
    )
    steel, grip = (
        metal("b9bdc2", "6a7076"),
        wood("8a5a34", "4a2c18", 0, 20) if crook else plain(second, 0.04),
    )
    tip = lathe([(0, 0), (0.003 * s, 0), (0.005 * s, 0.04 * s), (0, 0.045 * s)], 8, mat=steel)
    stick = tube([(0, 0, 0.57 * s), (0, 0, 0.75 * s)], 0.0055, 8, mat=steel)
    upright = [canopy, strap, tip, stick]
    if crook:
        bend = (
            [(0, 0, 0.68), (0, 0, 0.78)]
            + [
                (0.0, 0.055 - 0.055 * math.cos(t), 0.79 + 0.055 * math.sin(t))
                for t in np.linspace(0.2, math.pi, 8)
            ]
            + [(0, 0.11, 0.765)]
        )
        upright.append(tube(np.array(bend) * s, 0.011, 8, mat=grip))
    else:
        upright.append(
            lathe(
                [
                    (0, 0.68 * s),
                    (0.012, 0.68 * s),
                    (0.014, 0.76 * s),
                    (0.017, 0.84 * s),
                    (0.012, 0.85 * s),
                    (0, 0.85 * s),
                ],
                10,
                mat=grip,
            )
        )
    # it lies on its cone, the tip on the floor, and rolled over until the crook's end touches too
    rest, roll, axis = 0.05, -0.4 if crook else 0.0, (0, 0, r * s)
    for mesh in upright:
        mesh.turn(ry=math.pi / 2).move(-0.42 * s, 0, r * s).turn(rx=roll, pivot=axis).turn(ry=-rest)
    lowest = min(float(mesh.v[:, 2].min()) for mesh in upright)
    for mesh in upright:
        mesh.move(z=-lowest)
    outline = ((0.0, 0.003), (0.03, 0.008), (0.5, 0.039), (0.56, 0.04), (0.585, 0.024))
    cone = [
        (x * s - 0.42 * s, y * s, r * s + z * s)
        for x, w in outline
        for y, z in ((w, 0), (0, w), (-w, 0), (0, -w), (0.7 * w, -0.7 * w), (-0.7 * w, -0.7 * w))
    ]
    pieces = [np.array(cone), box_piece((0.24 * s, 0, r * s), (0.2 * s, 0.02, 0.02))]
    if crook:
        hook = box_piece((0.39 * s, 0.055 * s, 0), (0.07 * s, 0.13 * s, 0.022))
        c, n = math.cos(roll), math.sin(roll)
        pieces.append(hook @ np.array([[1, 0, 0], [0, c, n], [0, -n, c]]) + axis)
    c, n = math.cos(rest), math.sin(rest)
    pieces = [
        piece @ np.array([[c, 0, n], [0, 1, 0], [-n, 0, c]]) - [0, 0, lowest] for piece in pieces
    ]
    return Model(
        "closed umbrella", {"body": Part(upright, collision=pieces)}, mass=0.45, texture_size=128
    )


def umbrella_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.8, 0.9),
        "cloth": pick(rng, ["#26282c", "#2f4f8a", "#c8302c", "#2f7f5a"]),
        "second": "#1c1d20",
        "crook": True,
    }


MODELS = {}
