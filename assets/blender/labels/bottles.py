"""Labels of cleaners, toiletries and medicine. Front panels; brands are invented."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw
from toolkit.labels import barcode, small_print
from toolkit.labels import text as fit_text

from labels.drawing import drop, leaf, shade, star


def _panel(
    width: int, height: int, paper: str, round_to: int = 40
) -> tuple[Image.Image, ImageDraw.ImageDraw]:
    image = Image.new("RGBA", (width, height), (0, 0, 0, 0))
    canvas = ImageDraw.Draw(image)
    canvas.rounded_rectangle((3, 3, width - 4, height - 4), round_to, fill=paper)
    return image, canvas


def _bubbles(canvas: ImageDraw.ImageDraw, width: int, height: int, top: float, line: str) -> None:
    for x, y, r in (
        (0.3, 0.25, 0.13),
        (0.64, 0.2, 0.09),
        (0.73, 0.55, 0.15),
        (0.45, 0.66, 0.1),
        (0.2, 0.72, 0.07),
    ):
        cx, cy, radius = x * width, height * (top + (1 - top) * 0.85 * y), r * width
        box = (cx - radius, cy - radius, cx + radius, cy + radius)
        canvas.ellipse(box, fill="#ffffff", outline=line, width=3)
        inner = tuple(c + (d - c) * 0.3 for c, d in zip(box, (cx, cy, cx, cy), strict=True))
        canvas.pieslice(inner, 180, 270, fill="#bfe6ff")


def cleaner_label(
    brand: str, kind: str, paper: str, band: str, accent: str, ink: str
) -> Image.Image:
    """Front of a trigger bottle: slanted brand band, kind of cleaner, bubbles."""
    width, height = 256, 340
    image, canvas = _panel(width, height, paper)
    canvas.pieslice((-0.4 * width, 0.48 * height, 1.4 * width, 1.7 * height), 180, 360, fill=accent)
    canvas.polygon(
        [(0, 0.12 * height), (width, 0.03 * height), (width, 0.3 * height), (0, 0.39 * height)],
        fill=band,
    )
    fit_text(
        canvas,
        brand,
        (18, 0.1 * height, width - 18, 0.32 * height),
        "oblique",
        "#ffffff",
        3,
        shade(band, 0.4),
    )
    fit_text(canvas, kind, (20, 0.40 * height, width - 20, 0.49 * height), "bold", ink)
    _bubbles(canvas, width, height, 0.52, ink)
    return image


def bleach_label(brand: str, paper: str, band: str, accent: str) -> Image.Image:
    """Front of a bleach bottle: big word BLEACH and the orange corrosive square."""
    width, height = 256, 340
    image, canvas = _panel(width, height, paper, 26)
    canvas.rectangle((3, 30, width - 4, 112), fill=band)
    fit_text(canvas, brand, (22, 36, width - 22, 106), "oblique", "#ffffff", 3, shade(band, 0.4))
    fit_text(canvas, "BLEACH", (12, 122, width - 12, 196), "bold", accent, 2, "#ffffff")
    fit_text(canvas, "thick & strong", (40, 200, width - 40, 226), "italic", band)
    cx, cy, r = 70, 280, 48
    canvas.polygon(
        [(cx, cy - r), (cx + r, cy), (cx, cy + r), (cx - r, cy)],
        fill="#ffffff",
        outline="#d01818",
        width=7,
    )
    canvas.polygon(
        [(cx - 22, cy - 12), (cx - 4, cy - 20), (cx, cy - 12), (cx - 16, cy - 4)], fill="#111111"
    )
    canvas.rectangle((cx - 24, cy + 12, cx + 24, cy + 18), fill="#111111")
    canvas.line((cx - 12, cy - 2, cx - 14, cy + 10), fill="#111111", width=4)
    for i in range(4):
        canvas.rectangle(
            (136, 244 + 20 * i, 136 + (96, 84, 96, 60)[i], 253 + 20 * i), fill="#555555"
        )
    return image


def dish_soap_label(brand: str, paper: str, band: str, fruit: str) -> Image.Image:
    """Front of a washing-up bottle: brand, a sparkling plate and a fruit slice."""
    width, height = 256, 340
    image, canvas = _panel(width, height, paper, 90)
    canvas.ellipse((12, 24, width - 12, 130), fill=band)
    fit_text(canvas, brand, (34, 42, width - 34, 112), "oblique", "#ffffff", 3, shade(band, 0.4))
    fit_text(canvas, "DISH SOAP", (30, 138, width - 30, 170), "bold", shade(band, 0.7))
    canvas.ellipse((26, 184, 190, 320), fill="#ffffff", outline=shade(band, 0.8), width=5)
    canvas.ellipse((62, 214, 154, 290), outline="#b9d4e0", width=4)
    star(canvas, 176, 196, 30, "#ffffff", 4)
    canvas.ellipse((150, 240, 236, 326), fill=fruit, outline="#ffffff", width=4)
    for i in range(8):
        a = math.tau * i / 8
        canvas.line(
            (193, 283, 193 + 38 * math.cos(a), 283 + 38 * math.sin(a)), fill="#ffffff", width=3
        )
    return image


def shampoo_label(brand: str, kind: str, paper: str, ink: str, accent: str) -> Image.Image:
    """Front of a shampoo bottle: brand, hair waves, the word SHAMPOO."""
    width, height = 256, 400
    image, canvas = _panel(width, height, paper, 30)
    fit_text(canvas, brand, (20, 30, width - 20, 100), "italic", ink)
    canvas.line((40, 112, width - 40, 112), fill=accent, width=5)
    fit_text(canvas, "SHAMPOO", (24, 124, width - 24, 168), "bold", ink)
    fit_text(canvas, kind, (40, 176, width - 40, 204), "sans", ink)
    for i in range(7):
        points = [
            (30 + 34 * i * 0.55 + 55 * t + 18 * math.sin(5 * t + 0.35 * i), 222 + 150 * t)
            for t in np.linspace(0, 1, 24)
        ]
        canvas.line(points, fill=accent if i % 2 else shade(accent, 0.75), width=9)
    leaf(canvas, (170, 360), (224, 250), 26, "#5d9a48")
    leaf(canvas, (170, 360), (236, 316), 20, "#7fb860")
    return image


def soap_label(paper: str, ink: str) -> Image.Image:
    """Front of a dispenser that is filled again and again: SOAP and a drop."""
    width, height = 256, 300
    image, canvas = _panel(width, height, paper, 36)
    fit_text(canvas, "SOAP", (8, 40, width - 8, 150), "bold", ink)
    drop(canvas, width / 2, 220, 42, ink, ink)
    return image


def medicine_label(
    style: str,
    drug: str,
    dose: str,
    count: str,
    brand: str,
    colour: str,
    accent: str,
    rng: np.random.Generator,
) -> Image.Image:
    """Wrap-around band, three panels, the middle one in front. `style` is 'pharmacy' or 'shop'."""
    width, height = 768, 256
    third = width // 3
    image = Image.new("RGB", (width, height), "#fbfbf8")
    canvas = ImageDraw.Draw(image)
    canvas.rectangle((0, 0, width, 0.22 * height), fill=colour)
    canvas.rectangle((0, 0.92 * height, width, height), fill=colour)
    for x in (0, 2 * third):
        small_print(canvas, (x + 20, 68, x + third - 20, 156), 5, "#888888", rng)
        barcode(canvas, (x + 56, 172, x + third - 56, 222), rng)
    x = third
    if style == "pharmacy":
        fit_text(canvas, "PHARMACY", (x + 20, 6, x + third - 20, 50), "bold", "#ffffff")
        fit_text(canvas, "Rx", (x + 6, 60, x + 86, 150), "serif", colour)
        fit_text(canvas, drug, (x + 92, 62, x + third - 6, 108), "condensed", "#222222")
        fit_text(canvas, dose, (x + 92, 112, x + third - 6, 150), "sans", "#222222")
        small_print(canvas, (x + 14, 164, x + third - 14, 230), 4, "#666666", rng)
        canvas.rectangle((x + 0.62 * third, 152, x + third - 8, 162), fill=accent)
    else:
        fit_text(canvas, brand, (x + 20, 6, x + third - 20, 50), "bold", "#ffffff")
        fit_text(canvas, drug, (x + 10, 62, x + third - 10, 126), "condensed", colour)
        fit_text(canvas, dose, (x + 16, 134, x + 150, 176), "bold", "#333333")
        canvas.ellipse((x + 166, 132, x + 246, 212), fill=accent)
        fit_text(canvas, count, (x + 176, 148, x + 236, 196), "bold", "#ffffff")
        small_print(canvas, (x + 16, 186, x + 150, 228), 3, "#888888", rng)
    return image


def perfume_label(brand: str, ink: str) -> Image.Image:
    """A small paper label with a thin frame."""
    image = Image.new("RGBA", (256, 256), (0, 0, 0, 0))
    canvas = ImageDraw.Draw(image)
    canvas.rectangle((36, 60, 220, 196), fill="#fbf7ec", outline=ink, width=5)
    fit_text(canvas, brand, (50, 74, 206, 138), "italic", ink)
    fit_text(canvas, "PARFUM", (60, 150, 196, 180), "sans", ink)
    return image


def pill_days(box: str, lid: str, ink: str) -> Image.Image:
    """Lid of a weekly pill box, seen from above: seven windows with the initials of the days."""
    width, height = 7 * 96, 128
    image = Image.new("RGB", (width, height), box)
    canvas = ImageDraw.Draw(image)
    for i, letter in enumerate("SMTWTFS"):
        x = 96 * i
        canvas.rounded_rectangle(
            (x + 6, 8, x + 90, height - 8), 16, fill=lid, outline=shade(lid, 0.7), width=4
        )
        fit_text(canvas, letter, (x + 22, 26, x + 74, height - 30), "bold", ink)
    return image
