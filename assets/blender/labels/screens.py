"""What is on television: further programmes for the `on` variants."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw, ImageFilter
from toolkit import labels


def _football(w: int, h: int) -> Image.Image:
    image, draw = labels.canvas(w, h, "#2f9e44")
    for k in range(0, w, 32):
        draw.rectangle((k, 30, k + 15, h), fill="#37b04e")
    draw.rectangle((0, 0, w, 30), fill="#38506e")
    rng = np.random.default_rng(3)
    for _ in range(260):
        x, y = rng.uniform(0, w), rng.uniform(0, 26)
        fill = ["#e8c34a", "#d9534a", "#f1f1f1", "#5f8fd0"][int(rng.integers(4))]
        draw.ellipse((x - 2, y - 2, x + 2, y + 2), fill=fill)
    draw.rectangle((180, 22, 246, 66), outline="#ffffff", width=3)
    draw.line((128, 30, 110, h), fill="#e8f5e8", width=3)
    draw.ellipse((78, 66, 158, 116), outline="#e8f5e8", width=3)
    for x, y, shirt in ((60, 76, "#e03a30"), (150, 62, "#f4f4f4"), (112, 88, "#e03a30")):
        draw.line((x - 5, y + 24, x - 2, y + 12), fill="#2a2a2a", width=4)
        draw.line((x + 6, y + 24, x + 2, y + 12), fill="#2a2a2a", width=4)
        draw.rectangle((x - 7, y - 6, x + 7, y + 13), fill=shirt)
        draw.ellipse((x - 5, y - 16, x + 5, y - 6), fill="#d9a277")
    draw.ellipse((176, 92, 188, 104), fill="#ffffff", outline="#222222", width=2)
    draw.rectangle((8, 6, 82, 24), fill="#101c3c")
    labels.text(draw, "RED 2:1 WHI", (12, 8, 78, 22), "bold", "#ffffff")
    return image


def _fish(w: int, h: int) -> Image.Image:
    image = labels.gradient(w, h, "#39b8d8", "#0b4f86")
    draw = ImageDraw.Draw(image)
    draw.ellipse((-40, 116, w + 40, 210), fill="#d8c08a")
    for x, colour in ((30, "#e0604a"), (60, "#2f9e6a"), (210, "#e07ab0"), (236, "#2f9e6a")):
        for k in range(3):
            draw.line((x + 8 * k - 8, 132, x + 12 * k - 14, 86 + 10 * k), fill=colour, width=6)
    for x, y, s, a, b in (
        (130, 66, 34, "#ff8a1e", "#ffffff"),
        (66, 46, 18, "#ffd23a", "#2a4fb0"),
        (198, 42, 16, "#ffd23a", "#2a4fb0"),
    ):
        draw.polygon([(x - s, y), (x - 1.7 * s, y - 0.6 * s), (x - 1.7 * s, y + 0.6 * s)], fill=a)
        draw.ellipse((x - 1.1 * s, y - 0.62 * s, x + 1.1 * s, y + 0.62 * s), fill=a)
        for d in (-0.3, 0.35):
            draw.rectangle((x + d * s - 3, y - 0.55 * s, x + d * s + 3, y + 0.55 * s), fill=b)
        draw.ellipse((x + 0.68 * s, y - 0.2 * s, x + 0.86 * s, y), fill="#111111")
    for k in range(9):
        x, y = 176 + 6 * math.sin(k), 110 - 11 * k
        draw.ellipse((x - 3, y - 3, x + 3, y + 3), outline="#e8fbff", width=1)
    return image


def _news(w: int, h: int) -> Image.Image:
    image = labels.gradient(w, h, "#16305e", "#2f6ab0")
    draw = ImageDraw.Draw(image)
    draw.ellipse((150, 12, 240, 102), outline="#7fb2e8", width=3)
    draw.ellipse((176, 12, 214, 102), outline="#7fb2e8", width=2)
    draw.line((150, 57, 240, 57), fill="#7fb2e8", width=2)
    draw.polygon([(54, 144), (62, 92), (126, 92), (134, 144)], fill="#26282f")
    draw.polygon([(84, 92), (104, 92), (94, 118)], fill="#ffffff")
    draw.polygon([(90, 94), (98, 94), (94, 118)], fill="#c0302c")
    draw.ellipse((74, 38, 114, 92), fill="#d9a277")
    draw.pieslice((70, 30, 118, 82), 180, 360, fill="#4a3020")
    draw.ellipse((82, 60, 88, 66), fill="#222")
    draw.ellipse((100, 60, 106, 66), fill="#222")
    draw.rectangle((0, 112, w, h), fill="#d8302c")
    draw.rectangle((0, 112, 74, h), fill="#ffffff")
    labels.text(draw, "NEWS", (6, 115, 68, 141), "bold", "#c0201c")
    labels.text(draw, "SUN AFTER RAIN", (80, 116, 250, 140), "bold", "#ffffff")
    return image


def _cartoon(w: int, h: int) -> Image.Image:
    image = labels.gradient(w, h, "#8fd8ff", "#e6f8ff")
    draw = ImageDraw.Draw(image)
    draw.ellipse((-60, 92, w + 60, 260), fill="#8ad05a")
    draw.ellipse((200, 10, 240, 50), fill="#ffd93a")
    draw.polygon([(20, 62), (58, 30), (96, 62)], fill="#d9534a")
    draw.rectangle((28, 62, 88, 108), fill="#fff1c8", outline="#8a5a2a", width=2)
    draw.rectangle((50, 78, 66, 108), fill="#8a5a2a")
    x, y = 158, 76
    for s in (-1, 1):
        draw.ellipse((x + s * 26 - 14, y - 46, x + s * 26 + 14, y - 18), fill="#8a6a4a")
    draw.ellipse((x - 36, y - 34, x + 36, y + 34), fill="#a5825a")
    draw.ellipse((x - 20, y, x + 20, y + 28), fill="#f1dfc0")
    for s in (-1, 1):
        draw.ellipse((x + s * 14 - 8, y - 18, x + s * 14 + 8, y + 2), fill="#ffffff")
        draw.ellipse((x + s * 12 - 3, y - 10, x + s * 12 + 3, y - 2), fill="#111111")
    draw.ellipse((x - 6, y + 2, x + 6, y + 11), fill="#2a1a12")
    draw.arc((x - 12, y + 4, x + 12, y + 24), 20, 160, fill="#7a2a1a", width=3)
    draw.ellipse((x - 34, y + 30, x + 34, y + 90), fill="#4a90c4")
    return image


def _cooking(w: int, h: int) -> Image.Image:
    image, draw = labels.canvas(w, h, "#f2e3c6")
    for k in range(0, w, 24):
        draw.line((k, 0, k, 70), fill="#e2cfa8", width=1)
    draw.rectangle((0, 96, w, h), fill="#b9875a")
    draw.ellipse((70, 100, 190, 138), fill="#f8f8f6", outline="#c8c8c4", width=2)
    for k in range(16):
        a = k * 0.9
        x, y = 130 + 34 * math.cos(a), 117 + 9 * math.sin(2.3 * a)
        draw.arc((x - 16, y - 7, x + 16, y + 7), 0, 300, fill="#f0c64a", width=3)
    draw.ellipse((112, 104, 148, 122), fill="#d0342c")
    draw.ellipse((126, 104, 138, 111), fill="#3f9a3f")
    draw.rectangle((104, 40, 156, 92), fill="#ffffff")
    draw.ellipse((112, 28, 148, 72), fill="#e0ac82")
    draw.ellipse((104, 2, 156, 34), fill="#ffffff")
    draw.rectangle((112, 22, 148, 38), fill="#f4f4f4")
    draw.ellipse((120, 46, 125, 51), fill="#222")
    draw.ellipse((135, 46, 140, 51), fill="#222")
    draw.arc((120, 50, 140, 64), 20, 160, fill="#a03a2a", width=2)
    draw.rectangle((6, 8, 86, 30), fill="#c0302c")
    labels.text(draw, "COOK IT!", (10, 10, 82, 28), "bold", "#ffffff")
    return image


def _western(w: int, h: int) -> Image.Image:
    image = labels.gradient(w, h, "#e8e4da", "#8d8a84")
    draw = ImageDraw.Draw(image)
    draw.polygon(
        [(0, 96), (50, 60), (86, 60), (120, 92), (256, 88), (256, 144), (0, 144)], fill="#6c6a66"
    )
    draw.rectangle((196, 50, 206, 120), fill="#3a3937")
    draw.arc((180, 60, 202, 96), 90, 180, fill="#3a3937", width=7)
    draw.ellipse((96, 78, 160, 106), fill="#2c2b2a")
    for x in (104, 116, 142, 152):
        draw.line((x, 100, x - 6, 132), fill="#2c2b2a", width=6)
    draw.polygon([(150, 84), (172, 58), (184, 66), (166, 96)], fill="#2c2b2a")
    draw.rectangle((116, 50, 136, 84), fill="#4a4846")
    draw.ellipse((116, 34, 136, 54), fill="#cfccc4")
    draw.ellipse((106, 32, 146, 42), fill="#1c1b1a")
    draw.rectangle((116, 22, 136, 38), fill="#1c1b1a")
    return image


PROGRAMMES = {
    "football": _football,
    "fish": _fish,
    "news": _news,
    "cartoon": _cartoon,
    "cooking": _cooking,
    "western": _western,
}


def programme(kind: str, width: int = 256, height: int = 144) -> Image.Image:
    """A frame of a television programme by name (see PROGRAMMES)."""
    return PROGRAMMES[kind](width, height).filter(ImageFilter.GaussianBlur(0.6))
