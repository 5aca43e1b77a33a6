"""Small things that stand: tissues."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import label as printed
from toolkit.materials import plain
from toolkit.model import (
    Maker,
    Model,
    Part,
    box_piece,
)
from toolkit.sampling import pick, seed_of
from toolkit.shapes import (
    TAU,
    box,
    loft,
)


def tissue_box(cube: bool, ground: str, accent: str, second: str, pattern: str, seed: int) -> Model:
    """A box of paper tissues with one pulled half out."""
    rng = np.random.default_rng(seed)
    skin = printed(prints.tissue_pattern(ground, accent, second, pattern, rng))
    sx, sy, sz = (0.115, 0.115, 0.125) if cube else (0.115, 0.225, 0.075)
    long = (0, 0, 1, 1) if not cube else (0, 0, 0.6, 1)
    short = (0, 0, 0.6, 1)
    body = box(
        sx,
        sy,
        sz,
        (0, 0, 0),
        plain(ground, 0.03),
        0.003,
        labels={
            "+x": (skin, long),
            "-x": (skin, long),
            "+y": (skin, short),
            "-y": (skin, short),
            "+z": (skin, long),
        },
    )
    slot = loft(
        [
            np.c_[0.024 * np.cos(t), 0.052 * np.sin(t), np.full(16, z)]
            for z, t in (
                (sz - 0.0004, np.arange(16) * TAU / 16),
                (sz + 0.0006, np.arange(16) * TAU / 16),
            )
        ],
        mat=plain("#cfd6da", 0.0),
    )
    paper = plain("#fbfbf9", 0.03, 60)
    rings = []
    n = 18
    for z, wide, deep, wave in (
        (0, 0.034, 0.007, 0.2),
        (0.018, 0.03, 0.008, 0.3),
        (0.045, 0.042, 0.013, 0.45),
        (0.066, 0.05, 0.016, 0.7),
        (0.071, 0.042, 0.01, 0.8),
    ):
        ring = []
        for i in range(n):
            t = TAU * i / n
            r = 1 + wave * 0.4 * math.sin(4 * t + 1.1)
            lift = 0.018 * wave * math.sin(3 * t + 0.7) if z > 0.03 else 0.0
            ring.append((deep * r * math.cos(t), wide * r * math.sin(t), sz + z + lift))
        rings.append(ring)
    tissue = loft(rings, mat=paper)
    pieces = [
        box_piece((0, 0, sz / 2), (sx, sy, sz)),
        box_piece((0, 0, sz + 0.03), (0.02, 0.07, 0.06)),
    ]
    return Model("box of tissues", {"body": Part([body, slot, tissue], collision=pieces)}, mass=0.2)


def tissue_box_random(rng: np.random.Generator) -> dict:
    ground, accent, second = pick(
        rng,
        [
            ("#8fc3cf", "#f4f2ea", "#3a7a94"),
            ("#f3e3e6", "#d9708c", "#7ab0c8"),
            ("#2f5f7a", "#f2c52a", "#e9eef0"),
        ],
    )
    return {
        "cube": False,
        "ground": ground,
        "accent": accent,
        "second": second,
        "pattern": pick(rng, ["flowers", "dots", "leaves"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "tissue_box": Maker(
        tissue_box,
        tissue_box_random,
        3,
        [
            {"pattern": "leaves"},
            {
                "cube": True,
                "pattern": "flowers",
                "ground": "#f3e3e6",
                "accent": "#d9708c",
                "second": "#7ab0c8",
            },
            {"pattern": "dots", "ground": "#2f5f7a", "accent": "#f2c52a", "second": "#e9eef0"},
        ],
    ),
}
