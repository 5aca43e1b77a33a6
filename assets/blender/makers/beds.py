"""Beds, made up: mattress, blanket and pillows."""

from __future__ import annotations

import numpy as np
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick

from .bed_forms import BEDS
from .bedding import bedspread, pillow
from .designs import extend
from .joinery import Assembly, cushion, fabric, finish, leg, surface

Offset = tuple[float, float, float]


def bed(
    width: float = 1.6,
    length: float = 2.05,
    wood: str = "oak",
    blanket: str = "#7f93a8",
    sheet: str = "#eeebe4",
    headboard: str = "panel",
    throw: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A bed with its head at the back (-X): frame, headboard, mattress, blanket, pillows.

    headboard: "panel" of wood, "slats", or "padded"; throw: colour of a strip across the foot.
    """
    asm, half, x0, x1 = Assembly(), width / 2, -length / 2, length / 2
    cross, along = finish(wood, 1, offset), finish(wood, 0, offset)
    upright = finish(wood, 2, offset)
    rail_z, rail_top, mattress_top, head_z = 0.16, 0.32, 0.47, 1.0
    for side in (-1, 1):
        low, high = sorted((side * half, side * (half - 0.03)))
        asm.board("body", (x0 + 0.05, low, rail_z), (x1, high, rail_top), along, 0.006)
    asm.board("body", (x1 - 0.03, -half + 0.03, rail_z), (x1, half - 0.03, rail_top), cross, 0.006)
    for x in (x0 + 0.12, x1 - 0.1):
        for y in (-half + 0.07, half - 0.07):
            leg(asm, "body", (x, y), (x, y), (0, rail_z + 0.02), (0.024, 0.03), upright, 4)
    asm.board(
        "body",
        (x0 + 0.05, -half + 0.03, rail_z + 0.06),
        (x1 - 0.03, half - 0.03, rail_z + 0.09),
        cross,
    )
    if headboard == "padded":
        cloth = fabric(blanket, offset, 0.07)
        columns = 4
        step = width / columns
        for k in range(columns):
            pad = cushion((head_z - 0.3, step - 0.004, 0.045), (0, 0, 0), cloth, 0.025, 0.012, 0.02)
            pad.turn(ry=np.pi / 2).move(x0 + 0.02, -half + (k + 0.5) * step, (head_z + 0.3) / 2)
            asm.add("body", pad)
        asm.board("body", (x0, -half, 0.06), (x0 + 0.04, half, head_z), cross, 0.01)
        asm.solid("body", (x0, -half, 0.3), (x0 + 0.08, half, head_z))
    elif headboard == "slats":
        for y in (-half, half - 0.05):
            asm.board("body", (x0, y, 0), (x0 + 0.05, y + 0.05, head_z), upright, 0.008)
        for z in (0.42, head_z - 0.1):
            asm.board(
                "body",
                (x0 + 0.012, -half + 0.05, z),
                (x0 + 0.038, half - 0.05, z + 0.08),
                cross,
                0.005,
            )
        for y in np.linspace(-half + 0.16, half - 0.16, 7):
            asm.board(
                "body", (x0 + 0.018, y - 0.02, 0.5), (x0 + 0.032, y + 0.02, head_z - 0.1), upright
            )
    else:
        asm.board("body", (x0, -half, 0.06), (x0 + 0.05, half, head_z), cross, 0.012, segments=2)
    white = fabric(sheet, offset, 0.025)
    mattress_low = rail_z + 0.078
    size = (length - 0.1, width - 0.08, mattress_top - mattress_low)
    mattress = cushion(size, (0.025, 0, mattress_low), white, 0.06, 0.01, 0.05)
    asm.add("body", mattress, solid=True)
    # the blanket hangs over both sides and the foot; its upper edge is turned down
    cloth = fabric(blanket, offset, 0.05)
    cover_x0, cover_x1 = x0 + 0.62, x1 - 0.04
    asm.add(
        "body",
        bedspread(cover_x0, cover_x1, width, rail_top - 0.1, mattress_top, cloth, offset, True),
    )
    fold = cushion(
        (0.22, width - 0.045, 0.018),
        (cover_x0 + 0.1, 0, mattress_top + 0.022),
        white,
        0.05,
        0.006,
        0.012,
    )
    asm.add("body", fold)
    if throw:
        strip = bedspread(
            x1 - 0.62,
            x1 - 0.22,
            width + 0.012,
            rail_top - 0.04,
            mattress_top + 0.008,
            fabric(throw, offset),
            offset,
        )
        asm.add("body", strip)
    count = 2 if width >= 1.3 else 1
    for k in range(count):
        y = (k - (count - 1) / 2) * (width * 0.47)
        wide = min(0.68, width * 0.78)
        asm.add("body", pillow((x0 + 0.33, y, mattress_top), 0.42, wide, 0.115, white))
        asm.solid(
            "body",
            (x0 + 0.12, y - wide / 2, mattress_top),
            (x0 + 0.54, y + wide / 2, mattress_top + 0.12),
        )
    low, high = (cover_x0 + 0.18, -half + 0.1), (x1 - 0.1, half - 0.1)
    asm.solid(
        "body",
        (cover_x0, -half + 0.02, mattress_top),
        (x1 - 0.03, half - 0.02, mattress_top + 0.03),
    )
    return Model(
        title=f"{'double' if width >= 1.3 else 'single'} bed, {wood} frame",
        parts=asm.parts(),
        mass=55.0,
        supports=[surface("top", low, high, mattress_top + 0.033)],
        ground_shadow=True,
    )


def bed_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bed."""
    return {
        "width": pick(rng, [1.0, 1.4, 1.6]),
        "wood": pick(rng, ["oak", "walnut", "#e9e7e1"]),
        "blanket": pick(rng, ["#7f93a8", "#8a9a7e", "#b98372", "#c9b79a"]),
        "headboard": pick(rng, ["panel", "slats", "padded"]),
        "throw": pick(rng, [None, "#c9a24b", "#5d6d7c"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "bed": extend(
        Maker(
            bed,
            bed_random,
            3,
            [
                {
                    "width": 1.6,
                    "wood": "oak",
                    "headboard": "panel",
                    "blanket": "#7f93a8",
                    "throw": "#d3b56a",
                },
                {
                    "width": 1.0,
                    "wood": "#e9e7e1",
                    "headboard": "slats",
                    "blanket": "#8fa184",
                    "throw": None,
                },
                {
                    "width": 1.4,
                    "wood": "walnut",
                    "headboard": "padded",
                    "blanket": "#b59a8a",
                    "throw": None,
                },
            ],
        ),
        BEDS,
    ),
}
