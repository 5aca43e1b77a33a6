"""Cereal in boxes, opened boxes and canisters."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import lathe

from makers import food_packs
from makers.pack_parts import (
    by_style,
    carton,
    carton_piece,
    flap,
    standing_bag,
    vessel,
)


def cereal_art(w: int, h: int, word: str, ground: str, band: str, motif: str, brand="Morgenglück"):
    return groceries.face(
        w, h, ground, band, word, brand, getattr(groceries, motif), "CEREAL", "#ffe04a"
    )


def cereal_open(
    word: str, ground: str, band: str, motif: str, depth: float, width: float, h: float
) -> Model:
    """The top flaps stand open and the inner bag looks out."""
    front = cereal_art(256, int(256 * h / width), word, ground, band, motif)
    side = food_packs.pack_side(90, 400, ground, band, word, np.random.default_rng(3))
    body = carton(depth, width, h, front, side, None, band)
    grey = plain("#b9a68a", 0.06, 80)
    meshes = [body.weigh(1.2)]
    for turn, reach, span in ((0, 0.045, width), (math.pi, 0.045, width)):
        one = flap(span - 0.004, reach * 0.75, reach * 0.65, 0.004, grey)
        meshes.append(one.move(depth / 2 - 0.003, 0, h - 0.001).turn(rz=turn))
    for turn in (math.pi / 2, -math.pi / 2):
        one = flap(depth - 0.004, 0.034, 0.03, 0.004, grey)
        meshes.append(one.move(width / 2 - 0.003, 0, h - 0.001).turn(rz=turn))
    bag = standing_bag(
        width * 0.86, depth * 0.7, 0.05, plain("#f0ede6", 0.08, 60), "open", 0.05, 0.06, 2, 16
    )
    meshes.append(bag.move(0, 0, h - 0.012))
    return Model(
        title=f"opened cereal box, {word.capitalize()}",
        parts={
            "body": Part(
                meshes,
                collision=[
                    carton_piece(depth, width, h),
                    box_piece((0, 0, h + 0.02), (depth * 0.8, width * 0.8, 0.04)),
                ],
            )
        },
        mass=0.35,
        friction=0.5,
    )


def cereal_plain(
    word: str, ground: str, band: str, motif: str, depth: float, width: float, h: float
) -> Model:
    """A shut box of any proportions."""
    wide = width > 1.2 * h
    front = cereal_art(
        300 if wide else 256, int((300 if wide else 256) * h / width), word, ground, band, motif
    )
    side = food_packs.pack_side(
        100, max(100, int(100 * h / depth)), ground, band, word, np.random.default_rng(3)
    )
    top, d = labels.canvas(180, 60, band)
    labels.text(d, word, (20, 10, 160, 50), "oblique")
    body = carton(depth, width, h, front, side, top, band)
    return Model(
        title=f"cereal box, {word.capitalize()}",
        parts={"body": Part([body.weigh(1.2)], collision=[carton_piece(depth, width, h)])},
        mass=round(depth * width * h * 135, 2) + 0.02,
        friction=0.5,
    )


def oats_tub(word: str, ground: str, band: str) -> Model:
    """Oats in a round cardboard canister."""
    r, h = 0.058, 0.19
    art = groceries.wrapped(3, 300, 460, ground, band, word, "Kornhof", groceries.wheat, "CEREAL")
    body = vessel(
        [(0, r, r, 2.0), (h - 0.014, r, r, 2.0)], [plain(ground, 0.03), label(art)], [1], 24
    )
    lid = lathe(
        [
            (0, h - 0.016),
            (r * 1.03, h - 0.016),
            (r * 1.03, h - 0.001),
            (r * 0.98, h),
            (r * 0.95, h - 0.004),
            (0, h - 0.004),
        ],
        24,
        mat=plain(band, 0.03),
    )
    return Model(
        title="round canister of oats",
        parts={"body": Part([body.weigh(1.2), lid], collision=[cylinder_piece(r, 0, h, 14)])},
        mass=0.55,
        friction=0.5,
    )


LOOPS = {"word": "LOOPS", "ground": "#f2b21c", "band": "#d8402c", "motif": "loops"}

FLAKES = {"word": "CORN\nFLAKES", "ground": "#fdf6e0", "band": "#1f7a3a", "motif": "flakes"}

CRUNCH = {"word": "CRUNCH", "ground": "#8fcaf0", "band": "#2a4fa0", "motif": "loops"}

MODELS = {
    "cereal_box": Maker(
        by_style(
            "cereal_box",
            {
                "box": food_packs.cereal_box,
                "open": cereal_open,
                "plain": cereal_plain,
                "tub": oats_tub,
            },
        ),
        food_packs.cereal_box_random,
        count=7,
        presets=[
            {"style": "box", "width": 0.19, "depth": 0.062, "height": 0.28},
            {
                "style": "box",
                "name": "CRUNCH",
                "colour": "#6fb8e8",
                "dark": "#2a4fa0",
                "ring": "#e87a1c",
                "width": 0.19,
                "depth": 0.062,
                "height": 0.28,
            },
            {"style": "plain", **FLAKES, "depth": 0.085, "width": 0.245, "h": 0.34},
            {"style": "open", **FLAKES, "depth": 0.07, "width": 0.19, "h": 0.25},
            {"style": "plain", **LOOPS, "depth": 0.042, "width": 0.075, "h": 0.185},
            {"style": "tub", "word": "OATS", "ground": "#f6e8c4", "band": "#1f4f9c"},
            {"style": "open", **CRUNCH, "depth": 0.07, "width": 0.19, "h": 0.25},
        ],
    ),
}
