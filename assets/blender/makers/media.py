"""Televisions."""

from __future__ import annotations

import math

import numpy as np
from labels.screens import programme
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.model import (
    Maker,
    Model,
)
from toolkit.sampling import noise_offset, pick

from .designs import extend
from .joinery import Assembly, finish, leg
from .media_units import TVS

Offset = tuple[float, float, float]


def tv(
    width: float = 1.1, stand: str = "feet", scene: int = 0, offset: Offset = (0, 0, 0)
) -> Model:
    """A flat television; the variant `on` shows a bright picture."""
    asm, half = Assembly(), width / 2
    picture_width = width - 0.03
    screen_height = picture_width * 9 / 16
    z0, thick = 0.07, 0.045
    z1 = z0 + screen_height + 0.04
    black, dark = plain("#17181a", 0.05, 20), finish("#232528", 2, offset)
    asm.board("body", (-0.02, -half, z0), (0.012, half, z1), black, 0.005)
    asm.board(
        "body", (-thick, -half * 0.6, z0 + 0.06), (-0.015, half * 0.6, z1 - 0.12), dark, 0.008
    )
    off, pen = labels.canvas(96, 54, "#0b0c0f")
    pen.polygon([(30, 54), (62, 0), (88, 0), (56, 54)], fill="#15181c")
    middle = (z0 + 0.025 + z1 - 0.015) / 2
    low = (-0.012, -picture_width / 2, middle - screen_height / 2)
    high = (0.018, picture_width / 2, middle + screen_height / 2)
    asm.board("screen_off", low, high, black, 0, {"+x": label(off)}, solid=False)
    shining = label(programme(("sunset", "weather")[scene]), occlusion=0.0)
    asm.board("screen_on", low, high, black, 0, {"+x": shining}, 3.0, solid=False)
    if stand == "feet":
        for y in (-half * 0.62, half * 0.62):
            for s in (-1, 1):
                leg(asm, "body", (s * 0.11, y), (0, y), (0, z0 + 0.02), (0.012, 0.014), black, 4)
    else:
        asm.board("body", (-0.11, -0.17, 0), (0.11, 0.17, 0.016), black, 0.006)
        asm.board("body", (-0.035, -0.05, 0.01), (-0.012, 0.05, z0 + 0.06), black, 0.004)
    asm.solid("body", (-0.11, -half * 0.64, 0), (0.11, half * 0.64, 0.015))
    return Model(
        title=f"television, {math.hypot(picture_width, screen_height) / 0.0254:.0f} inch",
        parts=asm.parts(screen_on={"rgba": (1.45, 1.45, 1.45, 1.0)}),
        mass=11.0,
        variants={"default": ["body", "screen_off"], "on": ["body", "screen_on"]},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["screen_off"]},
            {"state": "ON", "variants": ["on"], "parts": ["screen_on"]},
        ],
    )


def tv_random(rng: np.random.Generator) -> dict:
    """Parameters of a random television."""
    return {
        "width": round(float(rng.uniform(0.95, 1.25)), 2),
        "stand": pick(rng, ["feet", "plate"]),
        "scene": int(rng.integers(2)),
        "offset": noise_offset(rng),
    }


MODELS = {
    "tv": extend(
        Maker(tv, tv_random, 2, [{"stand": "feet", "scene": 0}, {"stand": "plate", "scene": 1}]),
        TVS,
    ),
}
