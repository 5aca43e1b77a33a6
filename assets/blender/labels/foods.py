"""Drawn pictures of food for packages (Pillow)."""

from __future__ import annotations

import math

import numpy as np
from PIL import ImageDraw

Canvas = ImageDraw.ImageDraw


def snowflake(d: Canvas, cx: float, cy: float, radius: float, fill: str = "#ffffff") -> None:
    """Six branched arms: the sign for frozen food."""
    wide = max(2, int(radius * 0.14))
    for i in range(6):
        a = math.pi * i / 3
        end = (cx + radius * math.cos(a), cy + radius * math.sin(a))
        d.line((cx, cy, *end), fill=fill, width=wide)
        for turn in (-0.6, 0.6):
            x, y = cx + radius * 0.55 * math.cos(a), cy + radius * 0.55 * math.sin(a)
            tip = (
                x + radius * 0.35 * math.cos(a + turn),
                y + radius * 0.35 * math.sin(a + turn),
            )
            d.line((x, y, *tip), fill=fill, width=wide)


def scoop(d: Canvas, cx: float, cy: float, r: float, colour: str, dark: str) -> None:
    """A ball of ice cream with a ragged foot."""
    d.ellipse((cx - r, cy - r, cx + r, cy + r), fill=colour, outline=dark, width=3)
    for i in range(-3, 4):
        x = cx + i * r * 0.3
        d.ellipse((x - r * 0.24, cy + r * 0.5, x + r * 0.24, cy + r * 0.98), fill=colour)
    d.ellipse((cx - r * 0.55, cy - r * 0.65, cx - r * 0.1, cy - r * 0.3), fill="#fffaf0")


def cone(d: Canvas, cx: float, top: float, half: float, height: float) -> None:
    """A waffle cone."""
    d.polygon(
        [(cx - half, top), (cx + half, top), (cx, top + height)],
        fill="#d9a055",
        outline="#9a6428",
    )
    for t in (-0.5, 0.0, 0.5):
        d.line((cx + t * half, top, cx + t * 0.3 * half, top + height * 0.6), "#9a6428", 2)
    d.line((cx - half * 0.7, top + height * 0.3, cx + half * 0.7, top + height * 0.3), "#9a6428", 2)


def pizza(d: Canvas, cx: float, cy: float, r: float, topping: str, rng) -> None:
    """A round pizza seen from above; topping is salami or basil."""
    for k, colour in ((1.0, "#b9722c"), (0.94, "#dda452"), (0.85, "#c8361c"), (0.81, "#f3d06a")):
        d.ellipse((cx - r * k, cy - r * k, cx + r * k, cy + r * k), fill=colour)
    for _ in range(26):
        a, q, s = rng.uniform(0, 6.28), rng.uniform(0, 0.68), rng.uniform(0.05, 0.1)
        x, y = cx + r * q * math.cos(a), cy + r * q * math.sin(a)
        colour = ("#fff1c4", "#e0552c", "#f8e08c")[int(rng.integers(3))]
        d.ellipse((x - r * s, y - r * s * 0.8, x + r * s, y + r * s * 0.8), fill=colour)
    for i in range(8):
        a, q = i * 2.4, 0.62 if i % 3 else 0.25
        x, y = cx + r * q * math.cos(a), cy + r * q * math.sin(a)
        if topping == "salami":
            s = r * 0.17
            d.ellipse((x - s, y - s, x + s, y + s), fill="#a8281c", outline="#7a1410", width=3)
            for _ in range(5):
                u, v = rng.uniform(-0.6, 0.6, 2) * s
                d.ellipse((x + u - 3, y + v - 3, x + u + 3, y + v + 3), fill="#f0b8a0")
        elif i % 2:
            d.ellipse((x - r * 0.15, y - r * 0.07, x + r * 0.15, y + r * 0.07), fill="#2f7a2a")
        else:
            s = r * 0.14
            d.ellipse((x - s, y - s, x + s, y + s), fill="#d8341c", outline="#9a1c10", width=3)


def peas(d: Canvas, box, rng, colours=("#5fae35", "#77c247", "#4f9a2c"), size: float = 13) -> None:
    """A pile of peas filling a box."""
    x0, y0, x1, y1 = box
    for _ in range(int((x1 - x0) * (y1 - y0) / size**2 / 1.3)):
        x, y = rng.uniform(x0, x1), rng.uniform(y0, y1)
        fill = colours[int(rng.integers(len(colours)))]
        d.ellipse((x - size, y - size, x + size, y + size), fill=fill, outline="#2f6a1c", width=2)
        d.ellipse((x - size * 0.5, y - size * 0.6, x, y - size * 0.2), fill="#c4ee9a")


def mixed_vegetables(d: Canvas, box, rng) -> None:
    """Peas, carrot slices and sweetcorn."""
    x0, y0, x1, y1 = box
    d.rectangle(box, fill="#6f9a3a")
    for k in range(int((x1 - x0) * (y1 - y0) / 260)):
        x, y, s = rng.uniform(x0, x1), rng.uniform(y0, y1), 12
        if k % 3 == 0:
            s = 17
            d.ellipse((x - s, y - s, x + s, y + s), fill="#f08a1c", outline="#b85a0c", width=2)
            d.ellipse((x - 6, y - 6, x + 6, y + 6), fill="#f8b45a")
        else:
            fill, edge = (("#6fc03f", "#3a7a1c"), ("#f8d83a", "#b8920e"))[k % 3 - 1]
            d.ellipse((x - s, y - s, x + s, y + s), fill=fill, outline=edge, width=2)


def spinach(d: Canvas, box, rng) -> None:
    """Dark leaves."""
    x0, y0, x1, y1 = box
    for _ in range(26):
        x, y, a = rng.uniform(x0, x1), rng.uniform(y0, y1), rng.uniform(0, 6.28)
        s = (y1 - y0) * 0.24
        c, q = math.cos(a), math.sin(a)
        leaf = [(-1, 0), (-0.5, 0.4), (0.2, 0.5), (1, 0), (0.2, -0.5), (-0.5, -0.4)]
        points = [(x + s * (u * c - v * q), y + s * (u * q + v * c)) for u, v in leaf]
        fill = ("#2f6f24", "#3f8a2c", "#24581c")[int(rng.integers(3))]
        d.polygon(points, fill=fill, outline="#173f10")
        d.line((*points[0], *points[3]), fill="#8fc26a", width=3)


def ham_slices(d: Canvas, box, rng, flesh="#f0a8a4", rim="#e6d2b8", dark="#d98884") -> None:
    """Overlapping slices, as seen through a film."""
    x0, y0, x1, y1 = box
    w, h = x1 - x0, y1 - y0
    for i in range(4):
        x = x0 + w * (0.0 + 0.14 * i)
        slice_ = (x, y0 + h * 0.03, x + w * 0.58, y1 - h * 0.03)
        d.ellipse(slice_, fill=rim)
        inner = (
            slice_[0] + w * 0.02,
            slice_[1] + w * 0.02,
            slice_[2] - w * 0.02,
            slice_[3] - w * 0.02,
        )
        d.ellipse(inner, fill=flesh, outline=dark, width=2)
        cx, cy = (slice_[0] + slice_[2]) / 2, (slice_[1] + slice_[3]) / 2
        for _ in range(22):
            a, q = rng.uniform(0, 6.28), math.sqrt(rng.uniform(0, 1)) * 0.42
            u, v = cx + w * 0.58 * q * math.cos(a), cy + h * 0.94 * q * math.sin(a)
            r = rng.uniform(2, 5)
            d.ellipse((u - r, v - r * 0.7, u + r, v + r * 0.7), fill=(dark, "#f8ccc4")[_ % 2])


def sausage(d: Canvas, cx: float, cy: float, length: float, r: float, fill: str) -> None:
    """One sausage lying across."""
    d.rounded_rectangle(
        (cx - length / 2, cy - r, cx + length / 2, cy + r), r, fill=fill, outline="#6a2a14", width=3
    )
    d.rounded_rectangle(
        (cx - length * 0.36, cy - r * 0.6, cx + length * 0.3, cy - r * 0.25),
        r * 0.2,
        fill="#e8b090",
    )


def fish(d: Canvas, cx: float, cy: float, s: float, fill: str = "#7fa8c4") -> None:
    """A fish looking left."""
    d.polygon([(cx + s * 0.55, cy), (cx + s, cy - s * 0.32), (cx + s, cy + s * 0.32)], fill=fill)
    d.ellipse((cx - s, cy - s * 0.36, cx + s * 0.7, cy + s * 0.36), fill=fill)
    d.ellipse((cx - s * 0.78, cy - s * 0.16, cx - s * 0.62, cy), fill="#ffffff")
    d.arc(
        (cx - s * 0.7, cy - s * 0.3, cx - s * 0.3, cy + s * 0.3), -70, 70, fill="#ffffff", width=3
    )


def swirl(d: Canvas, cx: float, cy: float, r: float, colour: str, light: str) -> None:
    """A bowl's worth of pudding with a swirl on top."""
    d.ellipse((cx - r, cy - r * 0.5, cx + r, cy + r * 0.5), fill=colour)
    for i, k in enumerate(np.linspace(0.6, 0.12, 5)):
        x, y = cx, cy - r * 0.16 * i
        d.ellipse(
            (x - r * k, y - r * k * 0.42, x + r * k, y + r * k * 0.42),
            fill=light if i % 2 == 0 else colour,
            outline=colour,
            width=2,
        )
