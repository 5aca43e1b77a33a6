"""Screens, clock faces, printed boxes and cloth. Names are invented."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw, ImageFilter
from toolkit.labels import barcode, gradient, small_print
from toolkit.labels import text as fit_text

from labels.drawing import flower, hills, ink_on, leaf, shade, star


def clock_face(paper: str, ink: str, hour: float, numerals: bool = True) -> Image.Image:
    """A dial with hands at `hour` (0 to 12)."""
    image = Image.new("RGB", (256, 256), paper)
    canvas = ImageDraw.Draw(image)
    for i in range(60):
        a = math.tau * i / 60
        inner = 108 if i % 5 else 98
        canvas.line(
            [(128 + r * math.sin(a), 128 - r * math.cos(a)) for r in (inner, 118)],
            fill=ink,
            width=3 if i % 5 else 6,
        )
    if numerals:
        for i in range(1, 13):
            a = math.tau * i / 12
            x, y = 128 + 80 * math.sin(a), 128 - 80 * math.cos(a)
            fit_text(canvas, str(i), (x - 19, y - 15, x + 19, y + 15), "bold", ink)
    minute = (hour % 1) * math.tau
    turn = hour / 12 * math.tau
    for angle, length, width in ((turn, 54, 13), (minute, 90, 8)):
        canvas.line(
            [
                (128 - 14 * math.sin(angle), 128 + 14 * math.cos(angle)),
                (128 + length * math.sin(angle), 128 - length * math.cos(angle)),
            ],
            fill=ink,
            width=width,
        )
    canvas.ellipse((118, 118, 138, 138), fill="#c8242c")
    return image


def digital_time(text: str, glow: str, back: str = "#0b0d10") -> Image.Image:
    """A lit seven-segment style display."""
    image = Image.new("RGB", (256, 112), back)
    fit_text(ImageDraw.Draw(image), text, (20, 16, 236, 96), "bold", glow)
    return image


def laptop_keyboard(deck: str, key: str) -> Image.Image:
    """Keyboard deck seen from above, the hinge at the top edge."""
    width, height = 512, 352
    image = Image.new("RGB", (width, height), deck)
    canvas = ImageDraw.Draw(image)
    canvas.rounded_rectangle((34, 30, width - 34, 198), 8, fill=shade(deck, 0.72))
    for row in range(5):
        y = 36 + 32 * row
        x = 40.0
        keys = [1.0] * 14 if row < 4 else [1, 1, 1.2, 5.6, 1.2, 1, 1, 1, 1]
        unit = (width - 80) / sum(keys)
        for size in keys:
            canvas.rounded_rectangle((x + 1, y, x + size * unit - 4, y + 27), 4, fill=key)
            x += size * unit
    canvas.rounded_rectangle(
        (172, 218, 340, 330), 8, fill=shade(deck, 0.9), outline=shade(deck, 0.62), width=3
    )
    return image


def desktop_screen(lit: bool) -> Image.Image:
    """A laptop screen: dark, or a desktop with a window and a row of icons."""
    if not lit:
        image = gradient(512, 320, "#23272d", "#101214")
        ImageDraw.Draw(image).polygon([(300, 0), (430, 0), (250, 320), (120, 320)], fill="#2c3138")
        return image.filter(ImageFilter.GaussianBlur(6))
    image = gradient(512, 320, "#2f6fb0", "#79c2d8")
    canvas = ImageDraw.Draw(image)
    hills(canvas, 512, 240, 30, 0.5, "#2f8a6a")
    canvas.rectangle((110, 40, 420, 230), fill="#fbfbfb")
    canvas.rectangle((110, 40, 420, 64), fill="#d7dbe0")
    for i, c in enumerate(("#e0564a", "#e8b33c", "#4fae58")):
        canvas.ellipse((120 + 20 * i, 46, 132 + 20 * i, 58), fill=c)
    small_print(canvas, (130, 80, 300, 215), 9, "#66707a", np.random.default_rng(3))
    canvas.rectangle((320, 82, 400, 150), fill="#e2a23c")
    canvas.rectangle((0, 290, 512, 320), fill="#1d2733")
    for i in range(7):
        canvas.rounded_rectangle(
            (150 + 31 * i, 294, 174 + 31 * i, 317),
            5,
            fill=("#e0564a", "#f0f0f0", "#4fae58", "#e8b33c", "#6a8fd8", "#b06ad0", "#f0f0f0")[i],
        )
    return image


def phone_screen(lit: bool) -> Image.Image:
    """A phone's front: dark glass, or a home screen with the time and coloured app icons."""
    image = gradient(160, 320, "#1b1d22", "#0c0d0f")
    canvas = ImageDraw.Draw(image)
    if not lit:
        canvas.polygon([(90, 0), (150, 0), (60, 320), (0, 320)], fill="#2b2f37")
        return image.filter(ImageFilter.GaussianBlur(4))
    image.paste(gradient(148, 306, "#5b4bc8", "#e0789a"), (6, 7))
    fit_text(canvas, "12:45", (30, 34, 130, 84), "sans", "#ffffff")
    colours = (
        "#4fae58",
        "#e8b33c",
        "#e0564a",
        "#3f8fd8",
        "#f4f4f4",
        "#b06ad0",
        "#30b0a8",
        "#f08a3c",
    )
    for i in range(16):
        x, y = 16 + 33 * (i % 4), 112 + 44 * (i // 4)
        if i >= 12:
            y += 10
        canvas.rounded_rectangle((x, y, x + 28, y + 28), 7, fill=colours[(3 * i + i // 4) % 8])
    return image


def remote_face(body: str, power: str) -> Image.Image:
    """A remote control's keys, seen from above, the sending end at the top."""
    width, height = 128, 480
    image = Image.new("RGB", (width, height), body)
    canvas = ImageDraw.Draw(image)
    key = shade(body, 2.2) if ink_on(body) == "#ffffff" else shade(body, 0.55)
    canvas.ellipse((16, 20, 46, 50), fill=power)
    canvas.ellipse((84, 20, 110, 46), fill=key)
    for row in range(4):
        for col in range(3):
            x, y = 14 + 36 * col, 72 + 36 * row
            canvas.rounded_rectangle((x, y, x + 28, y + 24), 8, fill="#e9e9e6")
            text = "123456789*0#"[3 * row + col]
            fit_text(canvas, text, (x + 6, y + 4, x + 22, y + 20), "bold", "#222222")
    canvas.ellipse((20, 226, 108, 314), fill=key)
    canvas.ellipse((46, 252, 82, 288), fill="#e9e9e6")
    for x in (14, 86):
        canvas.rounded_rectangle((x, 328, x + 28, 388), 12, fill="#e9e9e6")
    for i, c in enumerate(("#d8323a", "#3aa04a", "#e8c23a", "#3a6ad0")):
        canvas.rounded_rectangle((12 + 27 * i, 402, 34 + 27 * i, 416), 5, fill=c)
    fit_text(canvas, "VISTRO", (30, 440, 98, 462), "bold", key)
    return image


def carton_side(kind: str, rng: np.random.Generator) -> Image.Image:
    """Print on a cardboard box side, transparent around it: arrows and a glass, or a label."""
    image = Image.new("RGBA", (256, 200), (0, 0, 0, 0))
    canvas = ImageDraw.Draw(image)
    ink = "#4a3320"
    if kind == "fragile":
        for x in (60, 110):
            canvas.polygon(
                [
                    (x, 110),
                    (x - 22, 140),
                    (x - 8, 140),
                    (x - 8, 176),
                    (x + 8, 176),
                    (x + 8, 140),
                    (x + 22, 140),
                ],
                fill=ink,
            )
        canvas.rectangle((36, 182, 134, 190), fill=ink)
        canvas.polygon(
            [
                (168, 110),
                (222, 110),
                (210, 146),
                (200, 152),
                (200, 176),
                (214, 186),
                (176, 186),
                (190, 176),
                (190, 152),
                (180, 146),
            ],
            fill=ink,
        )
        fit_text(canvas, "FRAGILE", (28, 40, 228, 96), "bold", ink)
    else:
        canvas.rectangle((90, 50, 236, 166), fill="#fbfaf6")
        fit_text(canvas, "PARZEL", (98, 56, 178, 78), "oblique", "#c8242c")
        small_print(canvas, (98, 86, 190, 126), 4, "#444444", rng)
        barcode(canvas, (102, 132, 222, 160), rng)
    return image


def tissue_pattern(
    ground: str, accent: str, second: str, kind: str, rng: np.random.Generator
) -> Image.Image:
    """All-over print of a tissue box."""
    image = Image.new("RGB", (384, 192), ground)
    canvas = ImageDraw.Draw(image)
    for i in range(8):
        for j in range(4):
            x, y = 24 + 48 * i + 24 * (j % 2), 24 + 48 * j
            if kind == "flowers":
                flower(canvas, x, y, 19, accent if (i + j) % 2 else second, "#f5d04a")
            elif kind == "dots":
                canvas.ellipse(
                    (x - 12, y - 12, x + 12, y + 12), fill=accent if (i + j) % 2 else second
                )
            else:
                tip = (x + 18 * math.cos(i), y + 18 * math.sin(i))
                leaf(canvas, (2 * x - tip[0], 2 * y - tip[1]), tip, 8, accent if j % 2 else second)
    return image


def skateboard_deck(ground: str, accent: str, grip: bool) -> Image.Image:
    """Deck print: dark grip tape on top, or a bold star picture below."""
    image = Image.new("RGB", (512, 128), "#26272a" if grip else ground)
    canvas = ImageDraw.Draw(image)
    if grip:
        canvas.rectangle((236, 0, 276, 128), fill=accent)
        return image
    canvas.polygon([(0, 0), (180, 0), (80, 128), (0, 128)], fill=accent)
    star(canvas, 256, 64, 56, accent)
    fit_text(canvas, "ROLLA", (320, 30, 490, 98), "oblique", accent)
    return image


def woven(colours: list[str], kind: str) -> Image.Image:
    """Cloth pattern: 'check', 'stripes', 'diamonds', 'leaves' or, for any other word, plain."""
    ground, first, second = colours
    image = Image.new("RGB", (256, 256), ground)
    canvas = ImageDraw.Draw(image)
    if kind == "check":
        overlay = np.asarray(image).astype(float)
        dark = np.array([int(first[i : i + 2], 16) for i in (1, 3, 5)], float)
        band = (np.arange(256) // 32) % 2
        weight = (band[:, None] + band[None, :])[..., None] * 0.45
        return Image.fromarray((overlay * (1 - weight) + dark * weight).astype(np.uint8))
    if kind == "stripes":
        for i in range(0, 256, 32):
            canvas.rectangle((i, 0, i + 11, 256), fill=first)
            canvas.rectangle((i + 17, 0, i + 20, 256), fill=second)
    elif kind == "diamonds":
        for i in range(5):
            for j in range(5):
                x, y = 64 * i, 64 * j
                for r, c in ((32, first), (18, second), (8, ground)):
                    canvas.polygon([(x, y - r), (x + r, y), (x, y + r), (x - r, y)], fill=c)
    elif kind == "leaves":
        for i in range(5):
            for j in range(5):
                x, y = 26 + 52 * i, 30 + 52 * j
                leaf(
                    canvas, (x - 16, y + 18), (x + 16, y - 18), 10, first if (i + j) % 2 else second
                )
    return image
