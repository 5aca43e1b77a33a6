"""Cups of pudding."""

from __future__ import annotations

import math

from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.shapes import box, lathe

from makers import chilled
from makers.pack_parts import by_style, vessel
from makers.packs_cups import cup_pack, open_cup


def pudding_coupe(flavour: str, brand: str) -> Model:
    """A clear dessert cup: pudding below, whipped cream and a dome above."""
    tone, _, ground, ink = chilled.PUDDINGS[flavour]
    r, h = 0.044, 0.092
    look = Material(occlusion=0.5)
    base = look.mix(look.remap(look.axis(2), 0.52 * h, 0.54 * h), tone, "fffaf0")
    line = look.math("ABSOLUTE", look.math("ADD", look.normal(1), 0.55))
    look.colour(look.mix(look.remap(line, 0.02, 0.08, 0.4, 0), base, "ffffff"))
    one = [(0, 0.7), (0.03, 0.74), (0.18, 0.8), (0.46, 0.93), (0.66, 1.0)]
    image, d = labels.canvas(720, 120, ground)
    for k in range(3):
        labels.text(d, "PUDDING", (240 * k + 12, 6, 240 * k + 228, 70), "bold", ink)
        labels.text(d, flavour, (240 * k + 30, 74, 240 * k + 210, 112), "bold", ink)
    body = vessel(
        [(z * h, k * r, k * r, 2.0) for z, k in one], [look, label(image)], [0, 0, 1, 0], 22
    )
    rim = lathe(
        [(0, 0.65 * h), (1.08 * r, 0.65 * h), (1.08 * r, 0.68 * h), (0, 0.68 * h)],
        22,
        mat=plain("#f4f4f0", 0.02),
    )
    cream = plain("#fff6e6", 0.05, 90)
    swirl = lathe(
        [
            (0.86 * r, 0.68 * h),
            (0.9 * r, 0.74 * h),
            (0.62 * r, 0.82 * h),
            (0.66 * r, 0.86 * h),
            (0.36 * r, 0.93 * h),
            (0.38 * r, 0.95 * h),
            (0, 1.06 * h),
        ],
        18,
        mat=cream,
        rib=lambda k, i: 1 + 0.07 * (i % 2),
    )
    chip = [
        box(
            0.012,
            0.004,
            0.004,
            (0.01 * math.cos(a), 0.014 * math.sin(a), 0.9 * h),
            plain(tone, 0.1),
        )
        for a in (0.3, 2.2, 4.3)
    ]
    return Model(
        title=f"{flavour.lower()} pudding with whipped cream",
        parts={
            "body": Part(
                [body.weigh(1.2), rim, swirl, *chip],
                collision=[
                    cylinder_piece(0.72 * r, 0, 0.68 * h, 14, 1.05 * r),
                    cylinder_piece(0.85 * r, 0.68 * h, 0.95 * h, 10, 0.3 * r),
                ],
            )
        },
        mass=0.2,
        friction=0.5,
    )


MODELS = {
    "pudding_cup": Maker(
        by_style(
            "pudding_cup",
            {
                "cup": chilled.pudding_cup,
                "pack": cup_pack,
                "open": open_cup,
                "coupe": pudding_coupe,
            },
        ),
        chilled.pudding_cup_random,
        count=7,
        presets=[
            {"style": "cup", "flavour": "CHOCOLATE"},
            {"style": "cup", "flavour": "VANILLA", "radius": 0.044, "height": 0.05},
            {
                "style": "pack",
                "word": "PUDDING",
                "flavour": "",
                "pudding": "CHOCOLATE",
                "brand": "Dolcina",
                "rows": 2,
                "columns": 2,
                "side": 0.062,
                "height": 0.056,
            },
            {
                "style": "open",
                "word": "PUDDING",
                "flavour": "",
                "pudding": "CHOCOLATE",
                "brand": "Cremosa",
            },
            {"style": "coupe", "flavour": "CHOCOLATE"},
            {"style": "coupe", "flavour": "CARAMEL"},
            {
                "style": "pack",
                "word": "PUDDING",
                "flavour": "",
                "pudding": "VANILLA",
                "brand": "Dolcina",
                "rows": 1,
                "columns": 2,
                "side": 0.07,
                "height": 0.07,
            },
        ],
    ),
}
