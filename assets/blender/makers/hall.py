"""Hall furniture: coat rack and shoe rack."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, spline, tube

from .designs import extend
from .garments_hung import hang
from .hall_forms import COAT_RACKS, SHOE_RACKS, pair
from .joinery import Assembly, finish, surface

Offset = tuple[float, float, float]
#: Of a coat rack, round its pole, high and low by turns.
HOOKS = 6
#: The pairs on the lower and the upper shelf of a shoe rack.
SHOES = (("#2f3f55", "#8a5a32"), ("#b8b2a4",))


def coat_rack(
    wood: str = "walnut",
    worn: tuple[tuple[str, ...], ...] = (),
    offset: Offset = (0, 0, 0),
) -> Model:
    """A standing coat rack on four feet; `worn`: what hangs round it, by garments_hung."""
    asm, timber, height = Assembly(), finish(wood, 2, offset), 1.72
    pole = [
        (0, 0.1),
        (0.024, 0.1),
        (0.02, 0.5),
        (0.018, height - 0.03),
        (0.026, height - 0.02),
        (0.016, height),
        (0, height),
    ]
    asm.add("body", lathe(pole, 10, mat=timber))
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        foot = spline(
            [(0.01 * c, 0.01 * s, 0.16), (0.12 * c, 0.12 * s, 0.1), (0.24 * c, 0.24 * s, 0.016)], 2
        )
        asm.add("body", tube(foot, 0.015, 6, mat=timber))
        asm.solid(
            "body",
            (min(0, 0.24 * c), min(0, 0.24 * s), 0),
            (max(0, 0.24 * c), max(0, 0.24 * s), 0.03),
        )
    for k in range(HOOKS):
        a = 2 * math.pi * k / HOOKS
        c, s = math.cos(a), math.sin(a)
        z = height - 0.12 - 0.1 * (k % 2)
        curve = spline(
            [
                (0.01 * c, 0.01 * s, z),
                (0.07 * c, 0.07 * s, z + 0.01),
                (0.115 * c, 0.115 * s, z + 0.07),
            ],
            2,
        )
        asm.add("body", tube(curve, 0.009, 6, mat=timber))
    asm.solid("body", (-0.02, -0.02, 0.03), (0.02, 0.02, height))
    for k, what in enumerate(worn):
        hook = 2 * k
        a = 2 * math.pi * hook / HOOKS
        at = (0.085 * math.cos(a), 0.085 * math.sin(a), height - 0.095)
        hang(asm, what, at, a)
    return Model(
        title="coat rack with " + " and ".join(what[0] for what in worn),
        parts=asm.parts(),
        mass=8.0,
        ground_shadow=True,
    )


def coat_rack_random(rng: np.random.Generator) -> dict:
    """Parameters of a random coat rack."""
    pool = ["#8a3f35", "#3f5568", "#b59a6a", "#4b5a45", "#2f3136"]
    order = [pool[int(i)] for i in rng.permutation(len(pool))]
    return {
        "wood": pick(rng, ["walnut", "oak", "black"]),
        "worn": (("coat", order[0], order[1]), ("jacket", order[2], order[3])),
        "offset": noise_offset(rng),
    }


def shoe_rack(
    width: float = 0.7,
    depth: float = 0.3,
    wood: str = "oak",
    metal_frame: bool = False,
    shoes: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An open rack: two slatted shelves, with or without three pairs of shoes, and a board on
    top."""
    asm, half, height, t = Assembly(), width / 2, 0.48, 0.022
    x0, x1 = -depth / 2, depth / 2
    boards = finish(wood, 1, offset)
    frame = plain("#2c2d2f", 0.05, 20) if metal_frame else finish(wood, 2, offset)
    thick = 0.018 if metal_frame else 0.03
    for x in (x0, x1 - thick):
        for y in (-half, half - thick):
            asm.board("body", (x, y, 0), (x + thick, y + thick, height - t), frame, 0.002)
    supports = [surface("top", (x0, -half), (x1, half), height)]
    asm.board("body", (x0, -half, height - t), (x1, half, height), boards, 0.004)
    for i, z in enumerate((0.09, 0.27)):
        for y in (-half, half - thick):
            asm.board(
                "body",
                (x0 + thick, y, z - 0.03),
                (x1 - thick, y + thick, z - 0.008),
                frame,
                solid=False,
            )
        slats, gap = 4, 0.012
        step = (depth + gap) / slats
        for k in range(slats):
            a = x0 + k * step
            asm.board(
                "body",
                (a, -half + thick, z - 0.014),
                (a + step - gap, half - thick, z),
                boards,
                solid=False,
            )
        asm.solid("body", (x0, -half, z - 0.03), (x1, half, z))
        headroom = (0.24, 0.458)[i] - z - 0.002
        worn = SHOES[i] if shoes else ()
        for k, colour in enumerate(worn):
            pair(asm, (0, -half + 0.13 + 0.19 * k, z), colour)
        low = -half + (0.05 + 0.19 * len(worn) if worn else thick)
        supports.append(surface(f"shelf_{i + 1}", (x0, low), (x1, half - thick), z, headroom))
    return Model(
        title=f"{wood} shoe rack{' on a metal frame' if metal_frame else ''}",
        parts=asm.parts(),
        mass=8.0,
        supports=supports,
        ground_shadow=True,
    )


def shoe_rack_random(rng: np.random.Generator) -> dict:
    """Parameters of a random shoe rack."""
    return {
        "width": round(float(rng.uniform(0.6, 0.9)), 2),
        "wood": pick(rng, ["oak", "birch", "walnut"]),
        "metal_frame": bool(rng.random() < 0.5),
        "offset": noise_offset(rng),
    }


MODELS = {
    "coat_rack": extend(
        Maker(
            coat_rack,
            coat_rack_random,
            2,
            [
                {
                    "worn": (
                        ("coat", "#8a3f35", "#6e322a"),
                        ("jacket", "#3f5568", "#c9a24a"),
                        ("scarf", "#d8cbb0", "#8a3f35"),
                    )
                },
                {
                    "wood": "black",
                    "worn": (
                        ("coat", "#b59a6a", "#8f7750"),
                        ("tote", "#e6dfcf", "#3f5568"),
                        ("cap", "#4b5a45", "#e6dfcf"),
                    ),
                },
            ],
        ),
        COAT_RACKS,
    ),
    "shoe_rack": extend(
        Maker(
            shoe_rack,
            shoe_rack_random,
            2,
            [{"wood": "oak", "metal_frame": False}, {"metal_frame": True, "shoes": True}],
        ),
        SHOE_RACKS,
    ),
}
