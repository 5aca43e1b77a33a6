"""Leaves, and bins."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh, cube_project
from toolkit.model import (
    Container,
    Model,
    Support,
    cylinder_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, loft

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
    asm.piece("body", cylinder_piece(r0, 0, 0.018))
    return Model(
        title="open bin",
        parts=asm.parts(),
        mass=1.4,
        supports=[Support("floor", 0.018, round_polygon(r0 - 0.02, 12), "body", None, "inside")],
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


MODELS = {}
