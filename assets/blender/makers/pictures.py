"""Drawn pictures: paintings, the view out of a window. All original."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageColor, ImageDraw, ImageFilter
from toolkit import labels


def _hills(
    draw: ImageDraw.ImageDraw,
    size: tuple[int, int],
    base: float,
    height: float,
    fill: str,
    phase: float,
) -> None:
    """A ridge across the picture; base and height as shares of the picture's height."""
    w, h = size
    ridge = [
        (
            x,
            h
            * (
                base
                - height
                * (
                    0.5 * math.sin(2.1 * x / w * math.pi + phase)
                    + 0.3 * math.sin(5 * x / w + 2 * phase)
                )
            ),
        )
        for x in range(0, w + 1, 4)
    ]
    draw.polygon([*ridge, (w, h), (0, h)], fill=fill)


def _cloud(draw: ImageDraw.ImageDraw, x: float, y: float, r: float, fill: str) -> None:
    for dx, dy, k in ((-1.3, 0.1, 0.65), (-0.5, -0.25, 0.9), (0.5, -0.15, 1.0), (1.4, 0.15, 0.6)):
        draw.ellipse(
            (
                x + dx * r - k * r,
                y + dy * r - k * r * 0.6,
                x + dx * r + k * r,
                y + dy * r + k * r * 0.6,
            ),
            fill=fill,
        )


def _tree(
    draw: ImageDraw.ImageDraw,
    x: float,
    foot: float,
    size: float,
    leaf: str,
    rng: np.random.Generator,
) -> None:
    draw.rectangle((x - size * 0.06, foot - size * 0.5, x + size * 0.06, foot), fill="#6b4a30")
    for _ in range(7):
        dx, dy = rng.normal(0, 0.18, 2) * size
        r = size * float(rng.uniform(0.18, 0.3))
        shift = int(rng.integers(-14, 15))
        fill = tuple(max(0, min(255, c + shift)) for c in ImageColor.getrgb(leaf))
        draw.ellipse(
            (x + dx - r, foot - size * 0.75 + dy - r, x + dx + r, foot - size * 0.75 + dy + r),
            fill=fill,
        )


def garden(seed: int = 0, width: int = 256, height: int = 256) -> Image.Image:
    """The view out of a window: sky, clouds, hills, trees and a lawn."""
    rng = np.random.default_rng(seed)
    image = labels.gradient(width, height, "#6fb2ee", "#dff0fb")
    draw = ImageDraw.Draw(image)
    for _ in range(3):
        _cloud(
            draw,
            rng.uniform(0.1, 0.9) * width,
            rng.uniform(0.1, 0.35) * height,
            width * rng.uniform(0.06, 0.1),
            "#ffffff",
        )
    size = (width, height)
    _hills(draw, size, 0.66, 0.07, "#8fb7a8", rng.uniform(0, 6))
    _hills(draw, size, 0.72, 0.05, "#6da26a", rng.uniform(0, 6))
    draw.rectangle((0, int(height * 0.78), width, height), fill="#86bb5c")
    for _ in range(4):
        x = float(rng.uniform(0.05, 0.95)) * width
        _tree(
            draw,
            x,
            height * rng.uniform(0.79, 0.86),
            height * rng.uniform(0.22, 0.36),
            "#4f8f45",
            rng,
        )
    for _ in range(60):
        x, y = rng.uniform(0, width), rng.uniform(0.82, 1.0) * height
        draw.line((x, y, x + 1, y - 4), fill="#76ab4f")
    return image.filter(ImageFilter.GaussianBlur(0.8))


def painting(
    kind: str = "abstract", seed: int = 0, width: int = 256, height: int = 192
) -> Image.Image:
    """Wall art: "abstract" shapes, a "landscape" or a "flower" in a vase."""
    rng = np.random.default_rng(seed)
    palettes = [
        ["#e8dcc6", "#c8553d", "#2d4a53", "#e0a458", "#7a9e9f"],
        ["#f1ebe0", "#31586a", "#d98f5c", "#a3b18a", "#3a3a3a"],
    ]
    tones = palettes[int(rng.integers(len(palettes)))]
    image = Image.new("RGBA", (width, height), tones[0])
    draw = ImageDraw.Draw(image)
    if kind == "landscape":
        image.paste(labels.gradient(width, height, "#f3c98b", "#f7ead2"))
        draw.ellipse(
            (width * 0.62, height * 0.18, width * 0.78, height * 0.18 + width * 0.16),
            fill="#e4664a",
        )
        for k, fill in enumerate(("#a9b7b2", "#7d9a94", "#4f7672", "#2d4f50")):
            _hills(draw, (width, height), 0.55 + 0.12 * k, 0.1, fill, float(rng.uniform(0, 6)))
    elif kind == "flower":
        image.paste(labels.gradient(width, height, "#dfe6df", "#c9d5cf"))
        draw.rectangle((0, height * 0.8, width, height), fill="#b98d63")
        cx, foot = width * 0.5, height * 0.88
        draw.polygon(
            [(cx - 24, foot - 56), (cx + 24, foot - 56), (cx + 32, foot), (cx - 32, foot)],
            fill="#3f6f86",
        )
        for _ in range(9):
            x, y = cx + rng.normal(0, 34), foot - 90 + rng.normal(0, 22)
            draw.line((cx, foot - 54, x, y), fill="#4d7a45", width=3)
            fill = ["#d9534a", "#f0b04a", "#e58aa0"][int(rng.integers(3))]
            for a in range(6):
                t = a * math.pi / 3
                draw.ellipse(
                    (
                        x + 9 * math.cos(t) - 8,
                        y + 9 * math.sin(t) - 8,
                        x + 9 * math.cos(t) + 8,
                        y + 9 * math.sin(t) + 8,
                    ),
                    fill=fill,
                )
            draw.ellipse((x - 6, y - 6, x + 6, y + 6), fill="#6b4a24")
    else:
        for k in range(5):
            x, y = rng.uniform(0.1, 0.9) * width, rng.uniform(0.15, 0.85) * height
            r = rng.uniform(0.12, 0.28) * width
            fill = tones[1 + k % 4]
            if k % 2:
                draw.ellipse((x - r, y - r, x + r, y + r), fill=fill)
            else:
                labels.blob(draw, x, y, r, rng, fill, 0.3)
        for k in range(3):
            y = height * (0.2 + 0.3 * k)
            draw.arc((width * 0.1, y - 40, width * 0.9, y + 60), 200, 340, fill=tones[2], width=4)
    return image
