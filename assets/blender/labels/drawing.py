"""Small drawn motifs and colour helpers (lettering, barcodes and gradients: `toolkit.labels`)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from PIL import ImageColor, ImageDraw

Canvas = ImageDraw.ImageDraw


def shade(colour: str, factor: float) -> str:
    """Return `colour` darker (factor < 1) or lighter (factor > 1)."""
    rgb = ImageColor.getrgb(colour)[:3]
    out = [c * factor if factor <= 1 else 255 - (255 - c) / factor for c in rgb]
    return "#" + "".join(f"{int(min(255, max(0, c))):02x}" for c in out)


def ink_on(colour: str) -> str:
    """Return near-black or white, whichever reads better on `colour`."""
    r, g, b = ImageColor.getrgb(colour)[:3]
    return "#1c1c20" if 0.3 * r + 0.59 * g + 0.11 * b > 150 else "#ffffff"


def star(canvas: Canvas, cx: float, cy: float, radius: float, fill: str, points: int = 5) -> None:
    """Draw a star standing on two points."""
    corners = []
    for i in range(points * 2):
        r = radius if i % 2 == 0 else radius * 0.42
        a = math.pi * i / points - math.pi / 2
        corners.append((cx + r * math.cos(a), cy + r * math.sin(a)))
    canvas.polygon(corners, fill=fill)


def hills(canvas: Canvas, width: float, base: float, rise: float, phase: float, fill: str) -> None:
    """Fill everything below a wavy horizon, down to a generous depth."""
    crest = [
        (
            x,
            base
            - rise
            * (0.6 * math.sin(x / width * 5 + phase) + 0.4 * math.sin(x / width * 11 + phase)),
        )
        for x in np.linspace(0, width, 40)
    ]
    canvas.polygon([*crest, (width, 4 * width), (0, 4 * width)], fill=fill)


def flower(canvas: Canvas, cx: float, cy: float, radius: float, petal: str, heart: str) -> None:
    """Draw a six-petalled flower."""
    for i in range(6):
        a = math.tau * i / 6
        x, y = cx + radius * 0.6 * math.cos(a), cy + radius * 0.6 * math.sin(a)
        r = radius * 0.42
        canvas.ellipse((x - r, y - r, x + r, y + r), fill=petal)
    r = radius * 0.36
    canvas.ellipse((cx - r, cy - r, cx + r, cy + r), fill=heart)


def drop(canvas: Canvas, cx: float, cy: float, radius: float, fill: str, outline: str) -> None:
    """Draw a water drop, its point up."""
    outline_points = [
        (
            cx + radius * math.sin(t) * math.sin(t / 2) ** 1.2,
            cy + 0.35 * radius - 1.25 * radius * math.cos(t),
        )
        for t in np.linspace(0, math.tau, 40)
    ]
    canvas.polygon(outline_points, fill=fill, outline=outline)


def leaf(
    canvas: Canvas, start: Sequence[float], end: Sequence[float], width: float, fill: str
) -> None:
    """Draw a pointed leaf between two points."""
    a, b = np.asarray(start, float), np.asarray(end, float)
    across = np.array([-(b - a)[1], (b - a)[0]]) / (np.linalg.norm(b - a) + 1e-9)
    ts = np.linspace(0, 1, 12)
    bulge = np.sin(math.pi * ts)[:, None] * across * width
    spine = a + (b - a) * ts[:, None]
    canvas.polygon([tuple(p) for p in [*(spine + bulge), *(spine - bulge)[::-1]]], fill=fill)
