"""Ageing of food: the `overripe` (dull, spotted) and `rotten` (browned, mouldy) variants."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh
from toolkit.model import Model, Part

from makers.convex import few_corners

SPOILED = [{"state": "EXPIRED", "variants": ["rotten"], "parts": ["body_rotten"]}]
AGED = [
    {"state": "OVERRIPE", "variants": ["overripe"], "parts": ["body_overripe"]},
    *SPOILED,
]
LOOKS = ("fresh", "overripe", "rotten")

MOULD, MOULD_GREEN = "dfe0d2", "6f8a6a"


def spots_around(radius: float, z: float) -> list[tuple[float, ...]]:
    """Where a round thing about the z axis goes bad: three sides, so that every view shows it."""
    r = radius
    return [
        (r * 0.85, r * 0.25, z + r * 0.35),
        (-r * 0.7, r * 0.6, z + r * 0.3, 0.85),
        (-r * 0.15, -r * 0.85, z + r * 0.45, 0.75),
    ]


def _nearest(m: Material, spots):
    """Distance to the nearest of the spots (x, y, z[, scale]); scale makes a spot larger."""
    found = None
    for x, y, z, *scale in spots:
        d = m.math("DIVIDE", m.distance((x, y, z)), scale[0] if scale else 1.0)
        found = d if found is None else m.math("MINIMUM", found, d)
    return found


def decay(m: Material, colour, size: float, spots, offset, brown="3b200e", amount: float = 0.55):
    """Lay rot over a skin: browned all over, dark blotches, and mould around every spot."""
    o = offset
    near = _nearest(m, spots)
    rough = m.math(
        "MULTIPLY", m.math("SUBTRACT", m.noise(1.7 / size, 4, offset=o), 0.5), size * 1.1
    )
    field = m.math("ADD", near, rough)
    colour = m.mix(amount, colour, "6b4520")
    colour = m.mix(m.remap(field, size * 0.75, size * 1.0, 1, 0), colour, "5d3716")
    colour = m.mix(m.remap(field, size * 0.56, size * 0.72, 1, 0), colour, brown)
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
    colour = m.mix(m.remap(mould, size * 0.36, size * 0.46, 1, 0), colour, MOULD)
    grain = m.remap(m.noise(10 / size, 3, offset=o), 0.35, 0.6, 0.45, 1)
    return m.mix(
        m.math("MULTIPLY", m.remap(mould, size * 0.2, size * 0.32, 1, 0), grain),
        colour,
        MOULD_GREEN,
    )


def bruise(m: Material, colour, size: float, offset, brown="5f3a18", amount: float = 0.42):
    """Lay overripeness over a skin: dull, soft brown blotches and freckles, no mould."""
    o = offset
    colour = m.mix(amount, colour, "8a6230")
    blotch = m.noise(1.5 / size, 3, 0.6, offset=(o[1], 7, o[0]))
    colour = m.mix(m.remap(blotch, 0.47, 0.57, 0, 0.85), colour, brown)
    freckles = m.math(
        "ADD",
        m.voronoi(3.2 / size, (o[2], 5, 0)),
        m.math("MULTIPLY", m.noise(5 / size, 3, offset=(o[2], 6, 0)), 0.35),
    )
    return m.mix(m.remap(freckles, 0.36, 0.46, 0.95, 0), colour, "3d2410")


def age(look: str, m: Material, colour, size: float, spots, offset, brown="3b200e", amount=0.5):
    """The colour of a skin at one of the LOOKS."""
    if look == "overripe":
        return bruise(m, colour, size, offset)
    return decay(m, colour, size, spots, offset, brown, amount) if look == "rotten" else colour


def shrivel(mesh: Mesh, size: float, spots, strength: float = 0.16, middle=(0, 0, 0)) -> Mesh:
    """Cave a fruit in around the spots, towards its axis (through `middle`)."""

    def pull(x, y, z):
        x, y = x - middle[0], y - middle[1]
        k = 1 - 0.02 * math.sin(9 * z / size + 3 * math.atan2(y, x))
        for sx, sy, sz, *_ in spots:
            d = math.dist((x, y, z), (sx - middle[0], sy - middle[1], sz)) / size
            k -= strength * math.exp(-((d / 0.6) ** 2))
        return x * k + middle[0], y * k + middle[1], z * (0.5 + 0.5 * k) * 0.97

    return mesh.warp(pull)


def soften(mesh: Mesh, size: float, strength: float = 0.05) -> Mesh:
    """Give a fruit the dents and the sag of overripeness."""

    def pull(x, y, z):
        a = math.atan2(y, x)
        k = 1 - strength * (0.5 + 0.5 * math.sin(3 * a + 4 * z / size)) + strength * 0.4
        return x * k, y * k, z * (1 - 0.8 * strength)

    return mesh.warp(pull)


def wither(look: str, mesh: Mesh, size: float, spots, strength: float = 0.16) -> Mesh:
    """The shape of a fruit at one of the LOOKS."""
    if look == "overripe":
        return soften(mesh, size)
    return shrivel(mesh, size, spots, strength) if look == "rotten" else mesh


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


def lying_pieces(mesh: Mesh, stretches: int = 3) -> list[np.ndarray]:
    """Hulls of stretches along y of a long thing that lies; a flat foot keeps it from rolling."""
    v, pieces = mesh.v, []
    bounds = np.linspace(v[:, 1].min(), v[:, 1].max(), stretches + 1)
    slack = np.ptp(bounds) * 0.06
    for low, high in pairwise(bounds):
        points = few_corners(v[(v[:, 1] >= low - slack) & (v[:, 1] <= high + slack)], 22)
        middle, half = points.mean(0), np.ptp(points, axis=0) * 0.3
        foot = [
            (middle[0] + a * half[0], middle[1] + b * half[1], 0.0)
            for a in (-1, 1)
            for b in (-1, 1)
        ]
        pieces.append(np.concatenate([points, foot]))
    return pieces


def aged(
    title: str,
    shape: Callable[[str], list[Mesh]],
    mass: float,
    pieces: Callable[[list[Mesh]], list[np.ndarray]] | None = None,
    texture_size: int = 256,
) -> Model:
    """A fruit or vegetable fresh, overripe and rotten: `shape(look)` builds each of the LOOKS."""
    groups = {look: shape(look) for look in LOOKS}
    on_table(*groups.values())
    solid = pieces or (lambda group: [round_piece(group)])
    names = {"fresh": "body", "overripe": "body_overripe", "rotten": "body_rotten"}
    return Model(
        title=title,
        mass=mass,
        friction=0.7,
        texture_size=texture_size,
        parts={names[k]: Part(g, collision=solid(g)) for k, g in groups.items()},
        variants={
            "default": ["body"],
            "overripe": ["body_overripe"],
            "rotten": ["body_rotten"],
        },
        states=AGED,
        smooth_deg=62,
    )
