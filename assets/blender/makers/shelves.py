"""Shelves that hang on a wall, their back at -X."""

from __future__ import annotations

import numpy as np
from toolkit.materials import plain
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick

from .bookcases import WALL_SHELVES
from .designs import extend
from .joinery import Assembly, finish, surface

Offset = tuple[float, float, float]


def wall_shelf(
    width: float = 0.8,
    depth: float = 0.24,
    wood: str = "oak",
    style: str = "floating",
    offset: Offset = (0, 0, 0),
) -> Model:
    """style: a thick "floating" board, one on metal "brackets", or a "box" of two levels."""
    asm, half, x0, x1 = Assembly(), width / 2, -depth / 2, depth / 2
    board, side = finish(wood, 1, offset), finish(wood, 2, offset)
    supports = []
    if style == "floating":
        height, mass = 0.045, 4.0
        low, high = (x0, -half, 0), (x1, half, height)
        asm.board("body", low, high, board, 0.004, segments=2)
    elif style == "brackets":
        height, mass, t = 0.2, 4.5, 0.024
        asm.board("body", (x0, -half, height - t), (x1, half, height), board, 0.004, segments=2)
        iron = plain("#2b2c2e", 0.06, 30)
        for y in (-half * 0.62, half * 0.62):
            a, b = y - 0.013, y + 0.013
            asm.board("body", (x0, a, 0), (x0 + 0.006, b, height - t), iron)
            asm.board("body", (x0, a, height - t - 0.006), (x1 - 0.03, b, height - t), iron)
            # the brace, from low on the wall to the front of the arm
            c, d = y - 0.006, y + 0.006
            brace = asm.board("body", (x0, c, 0), (x0 + 0.01, d, 1), iron, solid=False)
            reach, rise = depth - 0.07, height - t - 0.03
            v = brace.v.copy()
            brace.v = np.c_[
                v[:, 0] + v[:, 2] * reach,
                v[:, 1],
                0.012 + v[:, 2] * rise + (v[:, 0] < x0 + 0.005) * 0.012,
            ]
            asm.piece("body", brace.v)
    else:
        height, mass, t = 0.28, 7.0, 0.02
        for y in (-half, half - t):
            asm.board("body", (x0, y, 0), (x1, y + t, height), side, 0.003)
        asm.board("body", (x0, -half + t, 0), (x1 - 0.002, half - t, t), board, 0.002)
        asm.board(
            "body",
            (x0, -half + t, height - t - 0.02),
            (x1 - 0.002, half - t, height - 0.02),
            board,
            0.002,
        )
        asm.board("body", (x0, -half + t, t), (x0 + 0.006, half - t, height - t - 0.02), side)
        low, high = (x0 + 0.006, -half + t), (x1, half - t)
        room = height - 0.02 - 2 * t
        supports.append(surface("shelf_1", low, high, t, room))
        supports.insert(0, surface("top", low, high, height - 0.02))
    if style != "box":
        supports.append(surface("top", (x0, -half), (x1, half), height))
    names = {"floating": "floating board", "brackets": "board on brackets", "box": "two levels"}
    return Model(
        title=f"wall shelf, {names[style]}",
        parts=asm.parts(),
        mass=mass * width / 0.8,
        supports=supports,
    )


def wall_shelf_random(rng: np.random.Generator) -> dict:
    """Parameters of a random wall shelf."""
    return {
        "width": round(float(rng.uniform(0.65, 0.95)), 2),
        "depth": round(float(rng.uniform(0.2, 0.26)), 2),
        "wood": pick(rng, ["oak", "walnut", "#efede8"]),
        "style": pick(rng, ["floating", "brackets", "box"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "wall_shelf": extend(
        Maker(
            wall_shelf,
            wall_shelf_random,
            3,
            [
                {"style": "floating", "wood": "oak", "width": 0.8, "depth": 0.24},
                {"style": "brackets", "wood": "pine", "width": 0.95, "depth": 0.25},
                {"style": "box", "wood": "#e6e4de", "width": 0.7, "depth": 0.22},
            ],
        ),
        WALL_SHELVES,
    ),
}
