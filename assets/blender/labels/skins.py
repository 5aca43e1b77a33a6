"""Drawn skins of shoes: u runs across the upper (0, 1: the sole's edges), v from heel to toe."""

from __future__ import annotations

import math
from itertools import pairwise

from PIL import Image, ImageDraw

from labels.drawing import shade


class _Upper:
    """A canvas addressed in (u, v), mirrored left and right."""

    def __init__(self, ground: str, size: int = 512):
        self.size = size
        self.image = Image.new("RGB", (size, size), ground)
        self.canvas = ImageDraw.Draw(self.image)

    def xy(self, u: float, v: float) -> tuple[float, float]:
        return u * self.size, (1 - v) * self.size

    def both(self, points: list[tuple[float, float]], fill: str) -> None:
        self.canvas.polygon([self.xy(u, v) for u, v in points], fill=fill)
        self.canvas.polygon([self.xy(1 - u, v) for u, v in points], fill=fill)

    def stitch(self, points: list[tuple[float, float]], fill: str, width: int = 3) -> None:
        for mirrored in (False, True):
            path = [self.xy(1 - u if mirrored else u, v) for u, v in points]
            for (ax, ay), (bx, by) in pairwise(path):
                steps = max(2, int(math.hypot(bx - ax, by - ay) / 9))
                for i in range(steps):
                    a, b = i / steps, (i + 0.55) / steps
                    line = (
                        ax + (bx - ax) * a,
                        ay + (by - ay) * a,
                        ax + (bx - ax) * b,
                        ay + (by - ay) * b,
                    )
                    self.canvas.line(line, fill=fill, width=width)


def sneaker(main: str, accent: str, cap: str, tongue: str, stripe: str) -> Image.Image:
    """Sneaker upper: toe cap, eyelet stays, tongue, heel counter and a side stripe."""
    upper = _Upper(main)
    canvas, size = upper.canvas, upper.size
    canvas.rectangle((0, 0, size, 0.14 * size), fill=cap)
    canvas.pieslice((0.18 * size, 0.02 * size, 0.82 * size, 0.26 * size), 0, 360, fill=cap)
    for i in range(4):
        for j in range(6):
            x, y = size * (0.35 + 0.06 * j), size * (0.09 + 0.032 * i)
            canvas.ellipse((x - 4, y - 4, x + 4, y + 4), fill=shade(cap, 0.6))
    upper.both([(0, 0), (0.22, 0), (0.22, 0.1), (0, 0.2)], accent)
    if stripe == "three":
        for k in range(3):
            v = 0.34 + 0.085 * k
            upper.both([(0, v), (0.3, v + 0.1), (0.3, v + 0.145), (0, v + 0.05)], accent)
    elif stripe == "wave":
        upper.both(
            [
                (0.02, 0.74),
                (0.08, 0.6),
                (0.2, 0.34),
                (0.28, 0.2),
                (0.2, 0.24),
                (0.06, 0.42),
                (0.0, 0.58),
            ],
            accent,
        )
    else:
        upper.both([(0, 0.42), (0.3, 0.5), (0.3, 0.6), (0, 0.52)], accent)
    canvas.rectangle((0.405 * size, 0.24 * size, 0.595 * size, 0.6 * size), fill=tongue)
    upper.both([(0.3, 0.4), (0.405, 0.4), (0.405, 0.745), (0.33, 0.73)], shade(main, 0.86))
    thread = "#9a9a96" if main != "#26282c" else "#e8e8e6"
    upper.stitch([(0.3, 0.4), (0.325, 0.73), (0.4, 0.76)], thread)
    upper.stitch([(0, 0.84), (0.2, 0.86), (0.35, 0.8)], thread)
    return upper.image


def loafer(leather: str) -> Image.Image:
    """Slip-on shoe: raised apron seam on the toe, a saddle strap with a slot, a heel seam."""
    upper = _Upper(leather)
    dark, light = shade(leather, 0.55), shade(leather, 1.25)
    upper.both([(0.24, 0.62), (0.3, 0.86), (0.5, 0.93), (0.5, 0.62)], light)
    upper.stitch([(0.24, 0.62), (0.3, 0.86), (0.5, 0.935)], dark, 9)
    upper.both([(0.02, 0.5), (0.5, 0.545), (0.5, 0.645), (0.02, 0.6)], shade(leather, 0.8))
    upper.stitch([(0.02, 0.505), (0.5, 0.55)], light)
    upper.stitch([(0.02, 0.595), (0.5, 0.64)], light)
    size = upper.size
    upper.canvas.rounded_rectangle(
        (0.42 * size, 0.375 * size, 0.58 * size, 0.43 * size), 10, fill=dark
    )
    upper.both([(0.0, 0.0), (0.25, 0.0), (0.2, 0.05), (0.0, 0.09)], shade(leather, 0.8))
    return upper.image
