"""Book covers, pages and magazines. Titles and names are invented."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw
from toolkit.labels import barcode, gradient, small_print
from toolkit.labels import text as fit_text

from labels.drawing import flower, hills, leaf, shade, star

BOOKS: list[dict[str, str]] = [
    {
        "title": "THE LONG\nRIVER",
        "author": "M. Ashdown",
        "cover": "#1f4e6b",
        "accent": "#e9b949",
        "motif": "hills",
    },
    {
        "title": "COOKING\nAT HOME",
        "author": "Lina Ferro",
        "cover": "#c8402c",
        "accent": "#fff1d6",
        "motif": "pot",
    },
    {
        "title": "Night\nTrains",
        "author": "J. K. Ostrow",
        "cover": "#22252e",
        "accent": "#d9d2c0",
        "motif": "moon",
    },
    {
        "title": "GARDEN\nBOOK",
        "author": "Ida Holm",
        "cover": "#3f7a45",
        "accent": "#f4e7b8",
        "motif": "flower",
    },
    {
        "title": "FOX AND\nSTAR",
        "author": "P. Lindqvist",
        "cover": "#e8a33a",
        "accent": "#7a2f1c",
        "motif": "star",
    },
]


def _motif(
    canvas: ImageDraw.ImageDraw,
    box: tuple[float, float, float, float],
    kind: str,
    accent: str,
    cover: str,
) -> None:
    x0, y0, x1, y1 = box
    cx, cy, r = (x0 + x1) / 2, (y0 + y1) / 2, min(x1 - x0, y1 - y0) / 2
    if kind == "hills":
        canvas.ellipse((cx - 0.5 * r, cy - 0.9 * r, cx + 0.5 * r, cy + 0.1 * r), fill=accent)
        canvas.polygon(
            [(x0, y1), (cx - 0.3 * r, cy - 0.1 * r), (cx + 0.5 * r, y1)], fill=shade(cover, 0.6)
        )
        canvas.polygon(
            [(cx - 0.3 * r, y1), (cx + 0.5 * r, cy + 0.1 * r), (x1, y1)], fill=shade(cover, 0.4)
        )
    elif kind == "pot":
        canvas.rounded_rectangle(
            (cx - 0.7 * r, cy - 0.2 * r, cx + 0.7 * r, cy + 0.7 * r), 16, fill=accent
        )
        canvas.rectangle((cx - 0.8 * r, cy - 0.38 * r, cx + 0.8 * r, cy - 0.24 * r), fill=accent)
        for dx in (-0.3, 0.05, 0.4):
            canvas.arc(
                (cx + (dx - 0.2) * r, cy - r, cx + dx * r, cy - 0.5 * r),
                90,
                300,
                fill=accent,
                width=6,
            )
    elif kind == "moon":
        canvas.ellipse((cx - 0.6 * r, cy - 0.7 * r, cx + 0.5 * r, cy + 0.4 * r), fill=accent)
        canvas.ellipse((cx - 0.2 * r, cy - 0.8 * r, cx + 0.75 * r, cy + 0.2 * r), fill=cover)
        canvas.line((x0, y1 - 0.2 * r, x1, y1 - 0.5 * r), fill=accent, width=6)
    elif kind == "flower":
        leaf(canvas, (cx, y1), (cx + 0.6 * r, cy), 0.16 * r, shade(cover, 1.6))
        leaf(canvas, (cx, y1), (cx - 0.6 * r, cy + 0.1 * r), 0.16 * r, shade(cover, 1.6))
        flower(canvas, cx, cy - 0.2 * r, 0.75 * r, accent, "#d9822b")
    else:
        star(canvas, cx, cy, 0.9 * r, accent)
        star(canvas, cx, cy, 0.45 * r, cover)


def book_cover(
    title: str,
    author: str,
    cover: str,
    accent: str,
    motif: str,
    spine: float,
    rng: np.random.Generator,
) -> Image.Image:
    """Unfolded cover: back, spine, front side by side; `spine` is its width over the cover's."""
    width, height = 256, 360
    band = max(12, int(width * spine))
    image = Image.new("RGB", (2 * width + band, height), cover)
    canvas = ImageDraw.Draw(image)
    small_print(canvas, (30, 40, width - 30, 190), 9, accent, rng)
    barcode(canvas, (60, 268, 180, 320), rng)
    x = width + band
    canvas.rectangle((x + 12, 12, x + width - 13, height - 13), outline=accent, width=4)
    lines = title.split("\n")
    for i, line in enumerate(lines):
        fit_text(canvas, line, (x + 24, 30 + 56 * i, x + width - 24, 80 + 56 * i), "serif", accent)
    _motif(canvas, (x + 40, 160, x + width - 40, 296), motif, accent, cover)
    fit_text(canvas, author, (x + 40, 306, x + width - 40, 336), "sans", accent)
    canvas.rectangle((width, 0, width + band, height), fill=shade(cover, 0.85))
    label = Image.new("RGBA", (height - 60, band), (0, 0, 0, 0))
    text = title.replace("\n", " ")
    fit_text(
        ImageDraw.Draw(label), text, (0, 0.15 * band, height - 60, 0.85 * band), "serif", accent
    )
    turned = label.rotate(-90, expand=True)
    image.paste(turned, (width, 30), turned)
    return image


def book_pages(rng: np.random.Generator) -> Image.Image:
    """An open double page: text left, text and a picture right."""
    image = Image.new("RGB", (512, 360), "#f7f1e2")
    canvas = ImageDraw.Draw(image)
    for x in (0, 256):
        top = 170 if x else 44
        small_print(canvas, (x + 34, top, x + 226, 330), 10 if x else 18, "#4c4842", rng, 0.5)
    picture = gradient(180, 100, "#a9c8dd", "#dfe9e0")
    hills(ImageDraw.Draw(picture), 180, 64, 14, 1.0, "#6d8f5a")
    image.paste(picture, (294, 46))
    canvas.line((256, 0, 256, 360), fill="#cbbfa6", width=5)
    return image


MAGAZINES: list[dict[str, str]] = [
    {"name": "HAVNIA", "sky": "#9fc7e6", "ground": "#7aa24f", "ink": "#c2202e", "subject": "house"},
    {"name": "PEDALO", "sky": "#f6c84c", "ground": "#e2813a", "ink": "#1d2d50", "subject": "bike"},
    {
        "name": "PETALIA",
        "sky": "#f6d9df",
        "ground": "#e9a3b4",
        "ink": "#4b2a5e",
        "subject": "flowers",
    },
]


def magazine_cover(
    name: str, sky: str, ground: str, ink: str, subject: str, rng: np.random.Generator
) -> Image.Image:
    """Front page with masthead, a drawn picture and cover lines."""
    width, height = 256, 340
    image = gradient(width, height, sky, shade(sky, 1.8))
    canvas = ImageDraw.Draw(image)
    hills(canvas, width, 0.68 * height, 16, 0.4, ground)
    if subject == "house":
        canvas.rectangle((80, 170, 190, 262), fill="#fdf6e8")
        canvas.polygon([(64, 176), (135, 116), (206, 176)], fill="#a63a2a")
        canvas.rectangle((124, 212, 150, 262), fill="#5b4634")
        for x in (92, 160):
            canvas.rectangle((x, 190, x + 22, 214), fill="#6d9bb8")
    elif subject == "bike":
        for x in (82, 178):
            canvas.ellipse((x - 40, 180, x + 40, 260), outline=ink, width=8)
        canvas.line(
            [(82, 220), (110, 160), (160, 160), (128, 220), (82, 220)], fill="#ffffff", width=9
        )
        canvas.line([(178, 220), (158, 150), (176, 142)], fill="#ffffff", width=9)
        canvas.line([(96, 154), (122, 154)], fill=ink, width=10)
    else:
        for x, y, r, c in (
            (128, 180, 54, "#ffffff"),
            (70, 236, 40, "#d9486a"),
            (192, 240, 44, "#f3c33c"),
        ):
            flower(canvas, x, y, r, c, "#8a4b2a")
    fit_text(canvas, name, (10, 8, width - 10, 82), "bold", ink)
    canvas.rectangle((0, 300, width, height), fill=ink)
    fit_text(canvas, "25 ideas for spring", (16, 308, 176, 332), "bold", "#ffffff")
    barcode(canvas, (196, 308, 246, 332), rng)
    for i in range(3):
        canvas.rectangle((12, 96 + 22 * i, 12 + (80, 64, 72)[i], 107 + 22 * i), fill=ink)
    return image
