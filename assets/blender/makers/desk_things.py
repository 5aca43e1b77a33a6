"""Electric things: extension lead."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain, shade
from toolkit.model import (
    Model,
    Part,
    box_piece,
)
from toolkit.sampling import pick
from toolkit.shapes import (
    TAU,
    box,
    lathe,
    spline,
    tube,
)


def extension_cord(colour: str, block: str, sockets: int, coiled: bool, seed: int) -> Model:
    """A multi-socket block with its cable lying on the floor, in loose loops or a coil."""
    rng = np.random.default_rng(seed)
    length = 0.05 + 0.05 * sockets
    white, dark = plain(block, 0.03), plain("#2a2b2e", 0.03)
    meshes = [box(length, 0.056, 0.038, (0.06, 0, 0), white, 0.006)]
    for i in range(sockets):
        x = 0.06 - length / 2 + 0.05 + 0.05 * i
        well = lathe(
            [(0.019, 0.0), (0.0185, 0.0008), (0, 0.0008)], 14, mat=plain(shade(block, 0.78), 0.0)
        ).move(x, 0, 0.0378)
        meshes.append(well)
        for q in (-1, 1):
            meshes.append(
                lathe([(0.003, 0), (0, 0.0006)], 6, mat=dark, weight=0.6).move(
                    x, q * 0.0095, 0.0387
                )
            )
    meshes.append(
        box(0.012, 0.02, 0.006, (0.06 - length / 2 + 0.014, 0, 0.0365), plain("#d8302c", 0), 0.001)
    )
    start = (0.06 - length / 2 + 0.004, 0.0)
    if coiled:
        turns = [
            (
                -0.16 + (0.085 + 0.01 * math.sin(3 * t)) * math.cos(t),
                0.06 + (0.085 + 0.011 * math.sin(2 * t + 1)) * math.sin(t),
            )
            for t in np.linspace(-1.2, 3.2 * TAU - 1.2, 34)
        ]
        points = [start, (start[0] - 0.05, -0.01), *turns, (-0.3, 0.1), (-0.33, 0.02)]
        heights = np.r_[0.018, 0.0045, 0.0045 + np.arange(34) / 33 * 0.026, 0.0045, 0.0045]
    else:
        points = [start, (start[0] - 0.06, 0.0)]
        x = start[0] - 0.1
        for k in range(4):
            q = 1 if k % 2 else -1
            points += [
                (x, q * float(rng.uniform(0.03, 0.09))),
                (x - 0.04, q * float(rng.uniform(0.09, 0.14))),
                (x - 0.08, q * 0.03),
            ]
            x -= 0.1
        points += [(x, 0.02), (x - 0.05, 0.0)]
        heights = np.r_[0.018, np.full(len(points) - 1, 0.0045)]
    path = spline(np.c_[np.array(points), heights], 1 if coiled else 2)
    meshes.append(tube(path, 0.0045, 5, mat=plain(colour, 0.03), up=(0, 0, 1), weight=0.6))
    end, towards = path[-1], path[-1] - path[-2]
    turn = math.atan2(towards[1], towards[0])
    plug = lathe(
        [(0, 0), (0.009, 0), (0.016, 0.014), (0.0175, 0.034), (0, 0.034)],
        10,
        mat=plain(block, 0.03),
    ).turn(ry=math.pi / 2)
    prongs = [
        tube([(0.03, q * 0.008, 0), (0.052, q * 0.008, 0)], 0.0026, 6, mat=metal()) for q in (-1, 1)
    ]
    for mesh in (plug, *prongs):
        meshes.append(mesh.turn(rz=turn).move(end[0] - 0.004 * math.cos(turn), end[1], 0.0175))
    pieces = [
        box_piece((0.06, 0, 0.02), (length, 0.056, 0.04)),
        box_piece((end[0], end[1], 0.0175), (0.04, 0.034, 0.034)),
    ]
    flat = path[4:]
    for a in range(0, len(flat) - 1, 6):
        span = flat[a : a + 7]
        low, high = span.min(0) - 0.0045, span.max(0) + 0.0045
        pieces.append(box_piece((low + high) / 2, high - low))
    return Model(
        "extension lead",
        {"body": Part(meshes, collision=pieces)},
        mass=0.4,
        friction=0.7,
        texture_size=128,
    )


def extension_cord_random(rng: np.random.Generator) -> dict:
    return {
        "colour": pick(rng, ["#f1f1ee", "#2a2b2e", "#e8702c"]),
        "block": pick(rng, ["#f1f1ee", "#3a3c40"]),
        "sockets": 3,
        "coiled": True,
        "seed": int(rng.integers(1e9)),
    }
