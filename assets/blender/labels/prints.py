"""Book covers, magazines, photos, screens, clock faces and boxes. Titles and names are invented."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from labels.drawing import flower, hills, ink_on, leaf, shade, star
from toolkit.labels import barcode, gradient, small_print
from toolkit.labels import text as fit_text

BOOKS: list[dict[str, str]] = [
    {"title": "THE LONG\nRIVER", "author": "M. Ashdown", "cover": "#1f4e6b", "accent": "#e9b949", "motif": "hills"},
    {"title": "COOKING\nAT HOME", "author": "Lina Ferro", "cover": "#c8402c", "accent": "#fff1d6", "motif": "pot"},
    {"title": "Night\nTrains", "author": "J. K. Ostrow", "cover": "#22252e", "accent": "#d9d2c0", "motif": "moon"},
    {"title": "GARDEN\nBOOK", "author": "Ida Holm", "cover": "#3f7a45", "accent": "#f4e7b8", "motif": "flower"},
    {"title": "FOX AND\nSTAR", "author": "P. Lindqvist", "cover": "#e8a33a", "accent": "#7a2f1c", "motif": "star"},
]


def _motif(canvas: ImageDraw.ImageDraw, box: tuple[float, float, float, float], kind: str, accent: str, cover: str) -> None:
    x0, y0, x1, y1 = box
    cx, cy, r = (x0 + x1) / 2, (y0 + y1) / 2, min(x1 - x0, y1 - y0) / 2
    if kind == "hills":
        canvas.ellipse((cx - 0.5 * r, cy - 0.9 * r, cx + 0.5 * r, cy + 0.1 * r), fill=accent)
        canvas.polygon([(x0, y1), (cx - 0.3 * r, cy - 0.1 * r), (cx + 0.5 * r, y1)], fill=shade(cover, 0.6))
        canvas.polygon([(cx - 0.3 * r, y1), (cx + 0.5 * r, cy + 0.1 * r), (x1, y1)], fill=shade(cover, 0.4))
    elif kind == "pot":
        canvas.rounded_rectangle((cx - 0.7 * r, cy - 0.2 * r, cx + 0.7 * r, cy + 0.7 * r), 16, fill=accent)
        canvas.rectangle((cx - 0.8 * r, cy - 0.38 * r, cx + 0.8 * r, cy - 0.24 * r), fill=accent)
        for dx in (-0.3, 0.05, 0.4):
            canvas.arc((cx + (dx - 0.2) * r, cy - r, cx + dx * r, cy - 0.5 * r), 90, 300, fill=accent, width=6)
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
    title: str, author: str, cover: str, accent: str, motif: str, spine: float, rng: np.random.Generator
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
    fit_text(ImageDraw.Draw(label), text, (0, 0.15 * band, height - 60, 0.85 * band), "serif", accent)
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
    {"name": "PETALIA", "sky": "#f6d9df", "ground": "#e9a3b4", "ink": "#4b2a5e", "subject": "flowers"},
]


def magazine_cover(name: str, sky: str, ground: str, ink: str, subject: str, rng: np.random.Generator) -> Image.Image:
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
        canvas.line([(82, 220), (110, 160), (160, 160), (128, 220), (82, 220)], fill="#ffffff", width=9)
        canvas.line([(178, 220), (158, 150), (176, 142)], fill="#ffffff", width=9)
        canvas.line([(96, 154), (122, 154)], fill=ink, width=10)
    else:
        for x, y, r, c in ((128, 180, 54, "#ffffff"), (70, 236, 40, "#d9486a"), (192, 240, 44, "#f3c33c")):
            flower(canvas, x, y, r, c, "#8a4b2a")
    fit_text(canvas, name, (10, 8, width - 10, 82), "bold", ink)
    canvas.rectangle((0, 300, width, height), fill=ink)
    fit_text(canvas, "25 ideas for spring", (16, 308, 176, 332), "bold", "#ffffff")
    barcode(canvas, (196, 308, 246, 332), rng)
    for i in range(3):
        canvas.rectangle((12, 96 + 22 * i, 12 + (80, 64, 72)[i], 107 + 22 * i), fill=ink)
    return image


def photo(kind: str) -> Image.Image:
    """A drawn photograph: 'lake', 'family' or 'dog'."""
    image = gradient(256, 256, "#8fc0e8", "#e8eef0")
    canvas = ImageDraw.Draw(image)
    if kind == "lake":
        canvas.polygon([(0, 170), (70, 70), (120, 140), (180, 50), (256, 160), (256, 180), (0, 180)], fill="#6b7f8e")
        canvas.polygon([(180, 50), (160, 82), (182, 90), (202, 82)], fill="#ffffff")
        canvas.polygon([(70, 70), (54, 94), (72, 100), (88, 94)], fill="#ffffff")
        canvas.rectangle((0, 172, 256, 256), fill="#3f7fa6")
        hills(canvas, 256, 232, 8, 2.0, "#4c7a3a")
    else:
        hills(canvas, 256, 168, 10, 0.8, "#6f9f52")
        if kind == "family":
            people = ((78, 84, 30, "#3c5c8c", "#4a2f1c"), (168, 96, 28, "#b8404c", "#8a5a2c"), (124, 150, 22, "#e0b040", "#5a3a20"))
            for x, y, r, shirt, hair in people:
                canvas.rounded_rectangle((x - 1.5 * r, y + r, x + 1.5 * r, 270), int(r), fill=shirt)
                canvas.ellipse((x - 1.08 * r, y - 1.25 * r, x + 1.08 * r, y + 0.8 * r), fill=hair)
                canvas.ellipse((x - 0.85 * r, y - 0.8 * r, x + 0.85 * r, y + r), fill="#ecc3a2")
                canvas.arc((x - 0.4 * r, y, x + 0.4 * r, y + 0.6 * r), 10, 170, fill="#a04038", width=3)
                for s in (-1, 1):
                    canvas.ellipse((x + 0.35 * s * r - 3, y - 6, x + 0.35 * s * r + 3, y), fill="#222222")
        else:
            canvas.ellipse((68, 150, 188, 290), fill="#a8713c")
            canvas.ellipse((76, 60, 180, 172), fill="#b98049")
            for x in (66, 160):
                canvas.ellipse((x, 66, x + 32, 146), fill="#7a4a26")
            canvas.ellipse((100, 112, 156, 164), fill="#e2c49c")
            canvas.ellipse((116, 114, 140, 132), fill="#1c1614")
            for x in (106, 140):
                canvas.ellipse((x, 88, x + 13, 104), fill="#1c1614")
    return image


def clock_face(paper: str, ink: str, hour: float, numerals: bool = True) -> Image.Image:
    """A dial with hands at `hour` (0 to 12)."""
    image = Image.new("RGB", (256, 256), paper)
    canvas = ImageDraw.Draw(image)
    for i in range(60):
        a = math.tau * i / 60
        inner = 108 if i % 5 else 98
        canvas.line(
            [(128 + r * math.sin(a), 128 - r * math.cos(a)) for r in (inner, 118)], fill=ink, width=3 if i % 5 else 6
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
            [(128 - 14 * math.sin(angle), 128 + 14 * math.cos(angle)), (128 + length * math.sin(angle), 128 - length * math.cos(angle))],
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
    canvas.rounded_rectangle((172, 218, 340, 330), 8, fill=shade(deck, 0.9), outline=shade(deck, 0.62), width=3)
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
        canvas.rounded_rectangle((150 + 31 * i, 294, 174 + 31 * i, 317), 5, fill=("#e0564a", "#f0f0f0", "#4fae58", "#e8b33c", "#6a8fd8", "#b06ad0", "#f0f0f0")[i])
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
    colours = ("#4fae58", "#e8b33c", "#e0564a", "#3f8fd8", "#f4f4f4", "#b06ad0", "#30b0a8", "#f08a3c")
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
    """Print on a cardboard box side (transparent ground): arrows and a glass, or a shipping label."""
    image = Image.new("RGBA", (256, 200), (0, 0, 0, 0))
    canvas = ImageDraw.Draw(image)
    ink = "#4a3320"
    if kind == "fragile":
        for x in (60, 110):
            canvas.polygon([(x, 110), (x - 22, 140), (x - 8, 140), (x - 8, 176), (x + 8, 176), (x + 8, 140), (x + 22, 140)], fill=ink)
        canvas.rectangle((36, 182, 134, 190), fill=ink)
        canvas.polygon([(168, 110), (222, 110), (210, 146), (200, 152), (200, 176), (214, 186), (176, 186), (190, 176), (190, 152), (180, 146)], fill=ink)
        fit_text(canvas, "FRAGILE", (28, 40, 228, 96), "bold", ink)
    else:
        canvas.rectangle((90, 50, 236, 166), fill="#fbfaf6")
        fit_text(canvas, "PARZEL", (98, 56, 178, 78), "oblique", "#c8242c")
        small_print(canvas, (98, 86, 190, 126), 4, "#444444", rng)
        barcode(canvas, (102, 132, 222, 160), rng)
    return image


def tissue_pattern(ground: str, accent: str, second: str, kind: str, rng: np.random.Generator) -> Image.Image:
    """All-over print of a tissue box."""
    image = Image.new("RGB", (384, 192), ground)
    canvas = ImageDraw.Draw(image)
    for i in range(8):
        for j in range(4):
            x, y = 24 + 48 * i + 24 * (j % 2), 24 + 48 * j
            if kind == "flowers":
                flower(canvas, x, y, 19, accent if (i + j) % 2 else second, "#f5d04a")
            elif kind == "dots":
                canvas.ellipse((x - 12, y - 12, x + 12, y + 12), fill=accent if (i + j) % 2 else second)
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
    """Cloth pattern for place mats and cushions: 'check', 'stripes', 'plain', 'diamonds' or 'leaves'."""
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
                leaf(canvas, (x - 16, y + 18), (x + 16, y - 18), 10, first if (i + j) % 2 else second)
    return image
