"""Oblong rugs and tufted bath mats (the categories: floor_mats.py)."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.model import (
    Model,
)
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box

from .joinery import Assembly

Offset = tuple[float, float, float]


def rug_pattern(
    kind: str, tones: tuple[str, ...], width: int = 256, height: int = 176
) -> Image.Image:
    """A woven pattern: "border", "stripes", "diamonds" or "hexagons"."""
    image, draw = labels.canvas(width, height, tones[0])
    w, h = width, height
    if kind == "border":
        for k, inset in enumerate((8, 20, 26)):
            draw.rectangle((inset, inset, w - inset, h - inset), fill=tones[(k + 1) % len(tones)])
        draw.rectangle((34, 34, w - 34, h - 34), fill=tones[0])
        for k in range(5):
            r = 44 - 9 * k
            draw.polygon(
                [
                    (w / 2 - 2 * r, h / 2),
                    (w / 2, h / 2 - r),
                    (w / 2 + 2 * r, h / 2),
                    (w / 2, h / 2 + r),
                ],
                fill=tones[(k + 1) % len(tones)],
            )
    elif kind == "stripes":
        for k, x in enumerate(range(0, w, 16)):
            draw.rectangle((x, 0, x + 9 - 4 * (k % 3), h), fill=tones[1 + k % (len(tones) - 1)])
    elif kind == "diamonds":
        for j in range(-1, 6):
            for i in range(-1, 9):
                x, y = i * 32 + 16 * (j % 2), j * 36
                draw.polygon(
                    [(x, y + 18), (x + 16, y), (x + 32, y + 18), (x + 16, y + 36)],
                    outline=tones[1],
                    fill=tones[2] if (i + j) % 3 == 0 else None,
                    width=3,
                )
    else:
        s = 19.0
        for j in range(-1, 8):
            for i in range(-1, 9):
                cx, cy = (i + 0.5 * (j % 2)) * s * math.sqrt(3), j * 1.5 * s
                six = [
                    (cx + s * math.sin(a), cy + s * math.cos(a))
                    for a in (k * math.pi / 3 for k in range(6))
                ]
                draw.polygon(six, outline=tones[1], width=3)
    pixels = np.asarray(image.convert("RGB"), float)
    weave = 1 + 0.05 * np.random.default_rng(0).standard_normal((height, width, 1))
    return Image.fromarray((pixels * weave).clip(0, 255).astype(np.uint8))


def rug(
    length: float = 2.0,
    depth: float = 1.4,
    pattern: str = "border",
    tones: tuple[str, ...] = ("#d9cdb8", "#8c4a3f", "#41566b"),
    thickness: float = 0.004,
    corner: float = 0.01,
    title: str = "rug",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A flat rug, its length along y."""
    asm = Assembly()
    side = plain(shade(tones[0], 0.8), 0.05, 60)
    face = label(rug_pattern(pattern, tones), occlusion=0.0)
    rug_mesh = box(depth, length, thickness, (0, 0, 0), side, 0.0, labels={"+z": face})
    asm.add("body", rug_mesh, solid=True)
    return Model(
        title=f"{title}, {pattern}",
        parts=asm.parts(),
        mass=round(2.2 * length * depth, 1),
        friction=0.8,
        supports=[],
        texture_size=256,
    )


RUG_TONES = [
    ("#d9cdb8", "#8c4a3f", "#41566b"),
    ("#e6e0d2", "#b8ab92", "#cfc4ad"),
    ("#6f7f88", "#d8d2c4", "#4d5a63"),
    ("#c7a26a", "#f0e6d2", "#7a5436"),
]


def rug_random(rng: np.random.Generator) -> dict:
    """Parameters of a random rug."""
    return {
        "length": round(float(rng.uniform(1.8, 2.3)), 2),
        "depth": round(float(rng.uniform(1.2, 1.6)), 2),
        "pattern": pick(rng, ["border", "stripes", "diamonds", "hexagons"]),
        "tones": pick(rng, RUG_TONES),
        "offset": noise_offset(rng),
    }


def bath_mat(
    length: float = 0.8, depth: float = 0.5, colour: str = "#7fa0a8", offset: Offset = (0, 0, 0)
) -> Model:
    """A thick, tufted mat."""
    asm, thickness = Assembly(), 0.015
    pile = Material()
    tufts = pile.remap(pile.voronoi(70, offset), 0.1, 0.6)
    pile.colour(pile.mix(tufts, shade(colour, 1.1), shade(colour, 0.82)))
    low = box(depth, length, thickness, (0, 0, 0), pile, 0.006, 2)
    asm.add("body", low, solid=True)
    frame = plain(shade(colour, 0.88), 0.05, 60)
    w = 0.012
    for x0, x1, y0, y1 in ((-1, 1, -1, -1), (-1, 1, 1, 1), (-1, -1, -1, 1), (1, 1, -1, 1)):
        ax, bx = x0 * (depth / 2 - 0.05) - w / 2, x1 * (depth / 2 - 0.05) + w / 2
        ay, by = y0 * (length / 2 - 0.05) - w / 2, y1 * (length / 2 - 0.05) + w / 2
        asm.board(
            "body", (ax, ay, thickness - 0.004), (bx, by, thickness + 0.005), frame, solid=False
        )
    return Model(title="bath mat", parts=asm.parts(), mass=0.9, friction=0.8, texture_size=128)


def bath_mat_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bath mat."""
    return {
        "length": round(float(rng.uniform(0.7, 0.9)), 2),
        "depth": round(float(rng.uniform(0.45, 0.55)), 2),
        "colour": pick(rng, ["#7fa0a8", "#cfc3ad", "#a77f78"]),
        "offset": noise_offset(rng),
    }
