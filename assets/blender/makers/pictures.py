"""Drawn pictures: television, paintings, the view out of a window. All original."""

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


def television(scene: int = 0, width: int = 256, height: int = 144) -> Image.Image:
    """What is on: a sailing boat at sunset, or the weather map."""
    if scene == 0:
        image = labels.gradient(width, height, "#3b62c4", "#ffb46a")
        draw = ImageDraw.Draw(image)
        draw.ellipse((150, 62, 190, 102), fill="#fff3c0")
        draw.rectangle((0, 92, width, height), fill="#2a79b8")
        for k in range(14):
            y = 95 + k * 4
            draw.line((155 - k * 3, y, 190 + k * 2, y), fill="#ffd48a", width=2)
        draw.polygon([(60, 100), (120, 100), (108, 114), (70, 114)], fill="#8a3a2a")
        draw.polygon([(88, 36), (88, 98), (122, 98)], fill="#ffffff")
        draw.polygon([(84, 46), (84, 98), (62, 98)], fill="#f0603c")
        draw.polygon([(0, 92), (40, 70), (90, 92)], fill="#2f5d54")
    else:
        image = labels.gradient(width, height, "#2c6fd6", "#5fb0f2")
        draw = ImageDraw.Draw(image)
        draw.polygon(
            [(30, 30), (90, 18), (140, 40), (130, 80), (160, 120), (80, 132), (28, 96)],
            fill="#6cc06a",
        )
        draw.ellipse((60, 40, 86, 66), fill="#ffdf4a")
        _cloud(draw, 112, 86, 14, "#f4f7fb")
        draw.rectangle((172, 14, 246, 112), fill="#133a86")
        for k, words in enumerate(("MON 21", "TUE 19", "WED 23")):
            labels.text(draw, words, (178, 20 + 30 * k, 240, 42 + 30 * k), "bold", "#ffffff")
        draw.rectangle((0, 122, width, height), fill="#d8302c")
        labels.text(draw, "WEATHER TODAY", (10, 125, 200, 142), "bold", "#ffffff")
    return image


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
