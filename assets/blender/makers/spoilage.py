"""Rot and mould, for the `rotten` variant of food."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh
from toolkit.model import Model, Part

SPOILED = [{"state": "EXPIRED", "variants": ["rotten"], "parts": ["body_rotten"]}]


MOULD, MOULD_GREEN = "dfe0d2", "6f8a6a"


def decay(m: Material, colour, size: float, spot, offset, brown="3b200e", amount: float = 0.55):
    """Lay rot over a skin: browned all over, dark spots, and mould around the point `spot`."""
    o = offset
    near = m.distance(spot)
    rough = m.math(
        "MULTIPLY", m.math("SUBTRACT", m.noise(1.7 / size, 4, offset=o), 0.5), size * 1.1
    )
    field = m.math("ADD", near, rough)
    colour = m.mix(amount, colour, "6b4520")
    colour = m.mix(m.remap(field, size * 0.75, size * 1.0, 1, 0), colour, "5d3716")
    colour = m.mix(m.remap(field, size * 0.52, size * 0.68, 1, 0), colour, brown)
    freckles = m.math(
        "ADD",
        m.voronoi(2.8 / size, (o[2], 1, 0)),
        m.math("MULTIPLY", m.noise(3.4 / size, 3, offset=(o[2], 2, 0)), 0.4),
    )
    colour = m.mix(m.remap(freckles, 0.34, 0.44, 0.9, 0), colour, "4a2a12")
    fuzz = m.math(
        "MULTIPLY",
        m.math("SUBTRACT", m.noise(4.5 / size, 5, 0.7, offset=(o[1], o[0], o[2])), 0.5),
        size,
    )
    mould = m.math("ADD", near, fuzz)
    colour = m.mix(m.remap(mould, size * 0.32, size * 0.42, 1, 0), colour, MOULD)
    grain = m.remap(m.noise(10 / size, 3, offset=o), 0.35, 0.6, 0.45, 1)
    return m.mix(
        m.math("MULTIPLY", m.remap(mould, size * 0.2, size * 0.3, 1, 0), grain), colour, MOULD_GREEN
    )


def shrivel(mesh: Mesh, size: float, spot, strength: float = 0.16) -> Mesh:
    """Cave a fruit in around the spot."""

    def pull(x, y, z):
        d = math.dist((x, y, z), spot) / size
        k = (
            1
            - strength * math.exp(-((d / 0.6) ** 2))
            - 0.02 * math.sin(9 * z / size + 3 * math.atan2(y, x))
        )
        return x * k, y * k, z * (0.5 + 0.5 * k) * 0.97

    return mesh.warp(pull)


def on_table(*groups: list[Mesh]) -> None:
    """Stand every group on z = 0."""
    for group in groups:
        low = min(m.v[:, 2].min() for m in group)
        for mesh in group:
            mesh.move(z=-low)


def round_piece(group: list[Mesh]) -> np.ndarray:
    """A drum-like hull of a round fruit: a small flat foot keeps it from rolling off."""
    v = group[0].v
    radius, height = np.hypot(v[:, 0], v[:, 1]).max(), v[:, 2].max()
    rings = ((0.3, 0.0), (0.76, 0.14), (1.0, 0.5), (0.76, 0.86), (0.3, 1.0))
    angles = [2 * math.pi * i / 6 for i in range(6)]
    return np.array(
        [
            (radius * r * math.cos(a + k / 2), radius * r * math.sin(a + k / 2), height * z)
            for k, (r, z) in enumerate(rings)
            for a in angles
        ]
    )


def fruit(title: str, fresh: list[Mesh], rotten: list[Mesh], mass: float, pieces=None) -> Model:
    solid, solid_rotten = pieces or ([round_piece(fresh)], [round_piece(rotten)])
    return Model(
        title=title,
        mass=mass,
        friction=0.7,
        texture_size=128,
        parts={
            "body": Part(fresh, collision=solid),
            "body_rotten": Part(rotten, collision=solid_rotten),
        },
        variants={"default": ["body"], "rotten": ["body_rotten"]},
        states=SPOILED,
    )
