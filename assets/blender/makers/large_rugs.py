"""Large rugs, for under a sofa's group, a bed or a dining table, and small ones of their kind."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw
from toolkit import labels
from toolkit.materials import label, plain, shade
from toolkit.model import Model
from toolkit.shapes import box

from .joinery import Assembly

#: Pixels of a picture, along the rug and across it; drawn so many times larger, then averaged.
SIZE, FINE = (352, 256), 3

Tones = tuple[str, ...]


def _lozenge(x: float, y: float, rx: float, ry: float) -> list[tuple[float, float]]:
    return [(x - rx, y), (x, y - ry), (x + rx, y), (x, y + ry)]


def _persian(draw: ImageDraw.ImageDraw, w: int, h: int, tones: Tones) -> None:
    """Borders with flowers, a field, a stepped medallion and quarters of it in the corners."""
    field, border, light, accent = tones
    u = h / 64
    for inset, tone in ((0, border), (2, light), (2.8, border), (8, light), (8.8, field)):
        draw.rectangle((inset * u, inset * u, w - inset * u, h - inset * u), fill=tone)
    for k in range(1, round(w / u / 6)):
        x = k * w / round(w / u / 6)
        for y in (5.4 * u, h - 5.4 * u):
            draw.polygon(_lozenge(x, y, 1.9 * u, 1.7 * u), fill=accent if k % 2 else light)
    for k in range(2, 10):
        y = k * h / 11 + h / 22
        for x in (5.4 * u, w - 5.4 * u):
            draw.polygon(_lozenge(x, y, 1.7 * u, 1.9 * u), fill=light if k % 2 else accent)
    inner = (9.6 * u, 9.6 * u, w - 9.6 * u, h - 9.6 * u)
    for j in range(11):
        for i in range(17):
            x, y = inner[0] + (i + 0.5 * (j % 2)) * 4.2 * u, inner[1] + (j + 0.5) * 4.2 * u
            if x < inner[2] - u and y < inner[3] - u:
                draw.ellipse((x - 0.6 * u, y - 0.6 * u, x + 0.6 * u, y + 0.6 * u), fill=accent)
    for rx, tone in ((23, border), (21.5, light), (20, border), (13, field), (11.5, accent)):
        draw.polygon(_lozenge(w / 2, h / 2, rx * u, rx * 0.78 * u), fill=tone)
    draw.polygon(_lozenge(w / 2, h / 2, 6 * u, 5 * u), fill=light)
    for x, sx in ((inner[0], 1), (inner[2], -1)):
        for y, sy in ((inner[1], 1), (inner[3], -1)):
            for r, tone in ((15, light), (14, border)):
                draw.polygon([(x, y), (x + sx * r * u, y), (x, y + sy * r * u)], fill=tone)


def _lattice(draw: ImageDraw.ImageDraw, w: int, h: int, tones: Tones) -> None:
    """Thin lines that cross to lozenges, none quite like another."""
    ground, line = tones[:2]
    draw.rectangle((0, 0, w, h), fill=ground)
    rng = np.random.default_rng(3)
    across, along = w / 6, h / 4
    for k in range(-5, 12):
        for s in (-1, 1):
            path = [
                (across * (k + s * t * h / along) + rng.normal(0, w / 220), t * h)
                for t in np.linspace(0, 1, 13)
            ]
            draw.line(path, fill=line, width=round(h / 46), joint="curve")


def _heather(draw: ImageDraw.ImageDraw, w: int, h: int, tones: Tones) -> None:
    """One tone, and a band of another along the edge."""
    ground, band = tones[:2]
    draw.rectangle((0, 0, w, h), fill=ground)
    for inset, tone in ((0.05, band), (0.085, ground)):
        draw.rectangle((inset * h, inset * h, w - inset * h, h - inset * h), fill=tone)


def _bands(draw: ImageDraw.ImageDraw, w: int, h: int, tones: Tones) -> None:
    """Broad and narrow bands across, the same from both ends."""
    draw.rectangle((0, 0, w, h), fill=tones[0])
    shares = ((0.0, 0.07, 1), (0.1, 0.12, 2), (0.16, 0.26, 3), (0.29, 0.31, 1), (0.37, 0.44, 2))
    for low, high, tone in (*shares, (0.48, 0.5, 3)):
        draw.rectangle((low * w, 0, high * w, h), fill=tones[tone])
        draw.rectangle(((1 - high) * w, 0, (1 - low) * w, h), fill=tones[tone])


def _arcs(draw: ImageDraw.ImageDraw, w: int, h: int, tones: Tones) -> None:
    """Overlapping half discs and rings."""
    draw.rectangle((0, 0, w, h), fill=tones[0])
    discs = ((0.08, 0.2, 0.62, 1), (0.98, 0.9, 0.66, 2), (0.62, 0.02, 0.34, 3), (0.3, 1.0, 0.36, 3))
    for x, y, r, tone in discs:
        for share, colour in ((1.0, tones[tone]), (0.72, tones[0]), (0.6, tones[tone])):
            q = r * share * h
            draw.ellipse((x * w - q, y * h - q, x * w + q, y * h + q), fill=colour)


def _braid(draw: ImageDraw.ImageDraw, w: int, h: int, tones: Tones) -> None:
    """Braided rounds, one about another."""
    draw.rectangle((0, 0, w, h), fill=tones[0])
    rounds = 22
    for k in range(rounds):
        r = (1 - k / rounds) * h / 2
        tone = tones[1] if k in (2, 3, 9) else tones[0]
        fill = tuple(round(255 * c) for c in shade(tone, 1.04 if k % 2 else 0.93))
        draw.ellipse((w / 2 - r, h / 2 - r, w / 2 + r, h / 2 + r), fill=fill)


PATTERNS = {
    "persian": _persian,
    "lattice": _lattice,
    "heather": _heather,
    "bands": _bands,
    "arcs": _arcs,
    "braid": _braid,
}


def woven_picture(pattern: str, tones: Tones) -> Image.Image:
    """A woven pattern, as seen from above."""
    width, height = (SIZE[1], SIZE[1]) if pattern == "braid" else SIZE
    image, draw = labels.canvas(FINE * width, FINE * height, tones[0])
    PATTERNS[pattern](draw, FINE * width, FINE * height, tones)
    image = image.convert("RGB").resize((width, height), Image.Resampling.BOX)
    pixels = np.asarray(image, float)
    rng = np.random.default_rng(len(pattern))
    # Yarn is not dyed evenly: rows are a little lighter or darker, and so is every knot.
    rows = 0.02 * rng.standard_normal((1, width, 1))
    knots = 0.035 * rng.standard_normal((height, width, 1))
    return Image.fromarray((pixels * (1 + rows + knots)).clip(0, 255).astype(np.uint8))


def large_rug(pattern: str, tones: Tones, length: float, depth: float) -> Model:
    """A large rug, its length along y."""
    asm, thickness = Assembly(), 0.004
    side = plain(shade(tones[0], 0.8), 0.05, 60)
    face = label(woven_picture(pattern, tones), occlusion=0.0)
    flat = box(depth, length, thickness, (0, 0, 0), side, 0.0, labels={"+z": face})
    asm.add("body", flat, solid=True)
    mass = round(2.2 * length * depth, 1)
    size = "large rug" if depth > 1.5 else "rug"
    return Model(f"{size}, {pattern}", asm.parts(), mass, friction=0.8, texture_size=512)


def _large(pattern: str, depth: float, length: float, *tones: str) -> dict:
    return {"form": "large", "pattern": pattern, "depth": depth, "length": length, "tones": tones}


LARGE_RUGS = [
    _large("persian", 2.0, 3.0, "#8c3a36", "#2f3d56", "#e3d6bb", "#c08a4a"),
    _large("lattice", 2.4, 3.3, "#e9e3d6", "#6a625a"),
    _large("heather", 2.2, 3.2, "#a9a49b", "#d8d3c8"),
    _large("bands", 2.0, 2.9, "#e2d9c6", "#5f7f8f", "#c9a45c", "#39566b"),
    _large("arcs", 2.2, 3.0, "#ebe2d0", "#b9694c", "#7d9080", "#d3a55a"),
    _large("persian", 2.4, 3.4, "#38506c", "#7a3b3a", "#ded3bc", "#b99a66"),
    _large("heather", 1.7, 2.4, "#8d9a8b", "#e0dccf"),
    _large("lattice", 1.7, 2.4, "#d8cdb9", "#8a5c48"),
    {"form": "round", "sx": 2.3, "sy": 2.3, "tones": ("#c8ad7f", "#8f6f47")},
]
#: For small rooms: before a child's bed, where a door swings.
SMALL_RUGS = [
    {"form": "round", "sx": 1.2, "sy": 1.2, "tones": ("#f2d7a6", "#4f8f8f", "#d9776a")},
    _large("arcs", 1.0, 1.5, "#e8eef0", "#6fa3b5", "#e2a66b", "#8fb58a"),
]
