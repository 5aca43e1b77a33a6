"""Beds for children, made up."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, shade
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import extrude

from .bedding import bedspread, pillow
from .child_bed_forms import CHILD_BEDS
from .designs import extend
from .joinery import Assembly, cushion, fabric, finish, leg, surface

Offset = tuple[float, float, float]
CRAYONS = ("#d9534a", "#ee9b3a", "#f2cf4a", "#67ab6e", "#4a90c4", "#8a6fb5")


def dotted(colour: str, dots: str, offset: Offset) -> Material:
    """Cotton printed with dots."""
    m = Material()
    cell = m.voronoi(13, offset=offset, randomness=0.35)
    spot = m.remap(cell, 0.24, 0.3, 1, 0)
    soft = m.remap(m.noise(7, 3, offset=offset), 0.3, 0.7, 0, 0.6)
    return m.colour(m.mix(spot, m.mix(soft, colour, shade(colour, 0.93)), dots))


def _rainbow(width: float, height: float, ground: str) -> Image.Image:
    """A rainbow between two clouds, as on a head board (seen from the front)."""
    w, h = 256, int(256 * height / width)
    picture, draw = labels.canvas(w, h, ground)
    for k, colour in enumerate(CRAYONS[:5]):
        r = 0.28 * w - k * 0.034 * w
        cx, cy = 0.5 * w, 0.54 * h
        draw.pieslice((cx - r, cy - r, cx + r, cy + r), 180, 360, fill=colour)
    r = 0.28 * w - 5 * 0.034 * w
    draw.pieslice((0.5 * w - r, 0.54 * h - r, 0.5 * w + r, 0.54 * h + r), 180, 360, fill=ground)
    for cx in (0.29, 0.71):
        for dx, dy, q in ((-0.07, 0.02, 0.055), (0, -0.03, 0.075), (0.07, 0.02, 0.055)):
            x, y = (cx + dx) * w, 0.54 * h + dy * w
            draw.ellipse((x - q * w, y - q * w, x + q * w, y + q * w), fill="#ffffff")
    for x, y in ((0.07, 0.42), (0.93, 0.42), (0.17, 0.26), (0.83, 0.26)):
        points = []
        for k in range(10):
            q, a = (0.035 if k % 2 == 0 else 0.015) * w, math.pi * k / 5 - math.pi / 2
            points.append((w * x + q * math.cos(a), h * y + q * math.sin(a)))
        draw.polygon(points, fill="#f2cf4a")
    return picture


def _arched(width: float, z0: float, z1: float, rise: float) -> list[tuple[float, float]]:
    """A board's outline (y, z): straight sides, the top a low arch."""
    half = width / 2
    outline = [(-half, z0), (half, z0)]
    for t in np.linspace(0, 1, 11):
        y = half - width * t
        outline.append((float(y), z1 - rise + rise * math.sin(math.pi * t)))
    return outline


def child_bed(
    length: float = 1.6,
    width: float = 0.82,
    wood: str = "#f3f1ec",
    boards: str = "#9cc9c4",
    blanket: str = "#f0b7b0",
    dots: str = "#fdf6ee",
    style: str = "rainbow",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A low bed, head at the back (-X), with a guard rail on both sides of the head.

    style: arched boards with a "rainbow" painted on them, or "crayons" as slats in the ends.
    """
    asm, half, x0, x1 = Assembly(), width / 2, -length / 2, length / 2
    upright, along, cross = (finish(wood, axis, offset) for axis in (2, 0, 1))
    rail_low, rail_top, bed_z, head_z, foot_z = 0.13, 0.29, 0.38, 0.74, 0.5
    for s in (-1, 1):
        low, high = sorted((s * half, s * (half - 0.022)))
        asm.board("body", (x0 + 0.03, low, rail_low), (x1 - 0.03, high, rail_top), along, 0.005)
        # guard: a bar on posts, over the half nearer the head
        end = x0 + 0.46 * length
        bar = (x0 + 0.03, low, 0.5), (end, high, 0.545)
        asm.board("body", *bar, along, 0.008, segments=2)
        for x in np.linspace(x0 + 0.24, end - 0.05, 3):
            post = (x - 0.02, low + 0.002, rail_top - 0.01), (x + 0.02, high - 0.002, 0.505)
            asm.board("body", *post, upright, 0.003)
    if style == "rainbow":
        for x, top, rise, seen in ((x0, head_z, 0.12, 1), (x1 - 0.03, foot_z, 0.07, 0)):
            outline = _arched(width, 0.1, top, rise)
            plain_board = finish(boards, 2, offset)
            face = label(_rainbow(width, top - 0.1, boards)) if seen else plain_board
            panel = extrude(outline, 0.03, face, plain_board, axis="x", weight=1.5 if seen else 1)
            asm.add("body", panel.move(x + 0.015, 0, 0))
            asm.solid("body", (x, -half, 0.1), (x + 0.03, half, top - rise))
            peak = np.array([(a, *p) for a in (x, x + 0.03) for p in outline[2:]])
            asm.piece("body", peak)
        for x in (x0 + 0.015, x1 - 0.015):
            for y in (-half + 0.05, half - 0.05):
                leg(asm, "body", (x, y), (x, y), (0, 0.12), (0.018, 0.024), finish(boards, 2), 4)
    else:
        for x, top in ((x0, head_z), (x1 - 0.045, foot_z)):
            for y in (-half, half - 0.045):
                asm.board("body", (x, y, 0), (x + 0.045, y + 0.045, top), upright, 0.008)
            for z in (0.2, top - 0.09):
                rail = (x + 0.01, -half + 0.045, z), (x + 0.035, half - 0.045, z + 0.07)
                asm.board("body", *rail, cross, 0.004)
            ys = np.linspace(-half + 0.14, half - 0.14, len(CRAYONS))
            for y, colour in zip(ys, CRAYONS, strict=True):
                slat = (x + 0.014, y - 0.032, 0.265), (x + 0.031, y + 0.032, top - 0.085)
                asm.board("body", *slat, finish(colour, 2, offset), 0.003)
    low, high = (
        (x0 + 0.03, -half + 0.02, rail_low + 0.05),
        (x1 - 0.03, half - 0.02, rail_low + 0.08),
    )
    asm.board("body", low, high, cross)
    white = fabric("#f6f2ea", offset, 0.02)
    size = (length - 0.1, width - 0.09, bed_z - rail_low - 0.068)
    mattress = cushion(size, (0, 0, rail_low + 0.068), white, 0.05, 0.008, 0.04)
    asm.add("body", mattress, solid=True)
    cloth = dotted(blanket, dots, offset)
    start, finish_x = x0 + 0.5, x1 - 0.085
    asm.add(
        "body",
        bedspread(start, finish_x, width - 0.078, rail_top - 0.03, bed_z, cloth, offset, True),
    )
    turned = cushion(
        (0.16, width - 0.1, 0.016), (start + 0.07, 0, bed_z + 0.022), white, 0.04, 0.005, 0.01
    )
    asm.add("body", turned)
    case = dotted("#fbf7ef", boards if boards[0] == "#" else "#d9534a", offset)
    asm.add("body", pillow((x0 + 0.25, 0, bed_z), 0.32, width - 0.28, 0.085, case))
    asm.solid("body", (x0 + 0.08, -half + 0.13, bed_z), (x0 + 0.42, half - 0.13, bed_z + 0.09))
    asm.solid("body", (start, -half + 0.04, bed_z), (finish_x, half - 0.04, bed_z + 0.03))
    low_xy, high_xy = (start + 0.13, -half + 0.09), (finish_x - 0.06, half - 0.09)
    return Model(
        title=f"child's bed, {style}",
        parts=asm.parts(),
        mass=24.0,
        supports=[surface("top", low_xy, high_xy, bed_z + 0.033)],
        ground_shadow=True,
    )


def child_bed_random(rng: np.random.Generator) -> dict:
    """Parameters of a random child's bed."""
    return {
        "length": pick(rng, [1.5, 1.6, 1.9]),
        "width": pick(rng, [0.82, 0.9]),
        "wood": pick(rng, ["#f3f1ec", "pine", "birch"]),
        "boards": pick(rng, ["#9cc9c4", "#a9c4e0", "#f0d9a0"]),
        "blanket": pick(rng, ["#f0b7b0", "#8fbcd4", "#b7d3a8"]),
        "style": pick(rng, ["rainbow", "crayons"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "child_bed": extend(
        Maker(
            child_bed,
            child_bed_random,
            2,
            [
                {
                    "style": "rainbow",
                    "length": 1.55,
                    "width": 0.82,
                    "wood": "#f3f1ec",
                    "boards": "#8cc3cf",
                    "blanket": "#f2a9a0",
                },
                {
                    "style": "crayons",
                    "length": 1.9,
                    "width": 0.94,
                    "wood": "pine",
                    "boards": "#d9534a",
                    "blanket": "#5b9bd0",
                    "dots": "#ffe08a",
                },
            ],
        ),
        CHILD_BEDS,
    ),
}
