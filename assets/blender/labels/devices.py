"""Drawings for computers and what belongs to them: keys, sheets of paper, cracks."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw
from toolkit.labels import small_print
from toolkit.labels import text as fit_text

from labels.drawing import ink_on, shade
from labels.prints import phone_screen

ROWS = ("`1234567890-=", "QWERTYUIOP[]", "ASDFGHJKL;'", "ZXCVBNM,./")


def cracked(
    image: Image.Image,
    seed: int,
    centre: tuple[float, float] = (0.42, 0.38),
    ink: str = "#ffffff",
    width: int = 4,
) -> Image.Image:
    """The picture behind broken glass: rays from a blow and rings between them."""
    rng = np.random.default_rng(seed)
    image = image.convert("RGB").copy()
    w, h = image.size
    cx, cy, far = centre[0] * w, centre[1] * h, 1.1 * math.hypot(w, h)
    draw = ImageDraw.Draw(image, "RGBA")
    angles = np.sort(np.arange(11) * math.tau / 11 + rng.normal(0, 0.12, 11))
    steps = np.array([0.0, 0.07, 0.15, 0.26, 0.42, 0.66, 1.0]) * far
    bend = np.cumsum(rng.normal(0, 0.035, (11, 7)), axis=1)
    rays = [
        [
            (cx + r * math.cos(a + b), cy + r * math.sin(a + b))
            for r, b in zip(steps, line, strict=True)
        ]
        for a, line in zip(angles, bend, strict=True)
    ]
    for k in range(11):  # some facets catch the light
        a, b = rays[k], rays[(k + 1) % 11]
        for j in range(1, 6):
            if rng.random() < 0.3:
                draw.polygon([a[j], a[j + 1], b[j + 1], b[j]], fill=(255, 255, 255, 60))
    for k in range(11):
        draw.line(rays[k], fill=ink, width=width)
        for j in (1, 2, 3, 4):
            if rng.random() < 0.75 or j < 3:
                shift = rng.uniform(-0.05, 0.05) * far * (j > 1) * 0.5
                p, q = rays[k][j], rays[(k + 1) % 11][j]
                draw.line([p, (q[0] + shift, q[1] + shift / 2)], fill=ink, width=max(2, width - 1))
    r = 0.025 * far
    draw.ellipse((cx - r, cy - r, cx + r, cy + r), fill=ink)
    return image


def keyboard(
    deck: str, key: str, numpad: bool, glow: bool = False, columns: int = 14
) -> Image.Image:
    """A keyboard seen from above, its far side at the top."""
    width, height = 640, 200 if numpad else 250
    image = Image.new("RGB", (width, height), deck)
    draw = ImageDraw.Draw(image)
    main = width * (0.74 if numpad else 1.0)
    hues = ("#ff3a3a", "#ffb02c", "#f6f03a", "#3aff6a", "#3ab0ff", "#a04aff")
    ink = ink_on(key)
    unit, tall = (main - 12) / 15, (height - 12) / 6

    def cap(x: float, y: float, w: float, word: str = "", paint: str = key) -> None:
        if glow:
            hue = hues[int(x / width * 5.99)]
            draw.rectangle((x, y, x + w * unit, y + tall), fill=hue)
        rect = (x + 3, y + 3, x + w * unit - 3, y + tall - 3)
        draw.rounded_rectangle(rect, 5, fill=paint)
        if word:
            box = (rect[0] + 5, rect[1] + 4, rect[2] - 5, rect[3] - 8)
            fit_text(draw, word, box, "bold", hues[int(x / width * 5.99)] if glow else ink)

    grey = shade(key, 0.72) if ink == "#1c1c20" else shade(key, 1.6)
    for k in range(15):
        if numpad and k in (1, 6, 11):
            continue
        cap(6 + k * unit, 6, 1, "", "#d8402c" if k == 0 else grey)
    for row, (letters, lead) in enumerate(zip(ROWS, (0, 1.5, 1.8, 2.3), strict=True)):
        y, x = 6 + (row + 1) * tall, 6.0
        if lead:
            cap(x, y, lead, "", grey)
            x += lead * unit
        for letter in letters:
            cap(x, y, 1, letter)
            x += unit
        rest = (6 + 15 * unit - x) / unit
        if rest > 0.3:
            cap(x, y, rest, "", grey)
    y, x = 6 + 5 * tall, 6.0
    for w in (1.4, 1.2, 1.2, 6.2, 1.2, 1.2, 1.3, 1.3):
        cap(x, y, w, "", key if w > 6 else grey)
        x += w * unit
    if numpad:
        left = main + 4
        for j in range(3):
            for i in range(3):
                cap(left + i * unit * 0.98, 6 + j * tall, 0.98, "", grey)
        cap(left + unit, 6 + 4 * tall, 0.98, "", grey)
        for i in range(3):
            cap(left + i * unit * 0.98, 6 + 5 * tall, 0.98, "", grey)
        right = left + 3.2 * unit
        pad = (width - 6 - right) / 4 / unit
        for j in range(5):
            for i in range(4):
                word = "789456123"[3 * (j - 1) + i] if 1 <= j <= 3 and i < 3 else ""
                cap(
                    right + i * pad * unit,
                    6 + (j + 1) * tall,
                    pad,
                    word or ("0" * (j == 4 and not i)),
                )
    return image


def mouse_top(paint: str, line: str, wheel: str) -> Image.Image:
    """Buttons and wheel; the front at the top."""
    image = Image.new("RGB", (128, 224), paint)
    draw = ImageDraw.Draw(image)
    draw.line((64, 0, 64, 100), fill=line, width=5)
    draw.arc((-20, 66, 148, 122), 10, 170, fill=line, width=5)
    draw.rounded_rectangle((54, 26, 74, 78), 9, fill=wheel, outline=line, width=3)
    return image


def sheet(picture: bool, seed: int = 1) -> Image.Image:
    """A printed page."""
    image = Image.new("RGB", (160, 226), "#fdfdfb")
    draw = ImageDraw.Draw(image)
    rng = np.random.default_rng(seed)
    draw.rectangle((18, 16, 110, 28), fill="#22252a")
    if picture:
        draw.rectangle((18, 40, 142, 112), fill="#8fc8ee")
        draw.polygon([(18, 112), (60, 62), (90, 96), (112, 74), (142, 112)], fill="#4f8a4a")
        draw.ellipse((108, 48, 128, 68), fill="#f2c81e")
        small_print(draw, (18, 122, 142, 212), 8, "#4c4f55", rng)
    else:
        small_print(draw, (18, 42, 142, 212), 14, "#4c4f55", rng)
    return image


def keypad(body: str, key: str, columns: str = "123456789*0#") -> Image.Image:
    """A telephone's keys below a pair of call keys."""
    image = Image.new("RGB", (128, 176), body)
    draw = ImageDraw.Draw(image)
    draw.rounded_rectangle((8, 6, 44, 30), 8, fill="#2fa04a")
    draw.rounded_rectangle((84, 6, 120, 30), 8, fill="#d8202c")
    draw.ellipse((50, 2, 78, 34), fill=key)
    for k, word in enumerate(columns):
        x, y = 8 + 39 * (k % 3), 40 + 34 * (k // 3)
        draw.rounded_rectangle((x, y, x + 34, y + 28), 7, fill=key)
        fit_text(draw, word, (x + 8, y + 5, x + 26, y + 24), "bold", ink_on(key))
    return image


def old_screen(lit: bool) -> Image.Image:
    """The small display of a phone with keys."""
    image = Image.new("RGB", (128, 128), "#3f7fd8" if lit else "#1c2226")
    draw = ImageDraw.Draw(image)
    if lit:
        draw.rectangle((0, 0, 128, 20), fill="#1f4f98")
        draw.rectangle((102, 5, 122, 15), fill="#7af08a")
        fit_text(draw, "12:45", (10, 34, 118, 76), "bold", "#ffffff")
        fit_text(draw, "Menu", (8, 98, 60, 122), "bold", "#ffffff")
    else:
        draw.polygon([(70, 0), (110, 0), (50, 128), (10, 128)], fill="#2c353b")
    return image


def small_remote(body: str) -> Image.Image:
    """A streaming box's remote: a round pad and few keys."""
    image = Image.new("RGB", (128, 400), body)
    draw = ImageDraw.Draw(image)
    key = shade(body, 2.4) if ink_on(body) == "#ffffff" else shade(body, 0.5)
    draw.ellipse((52, 18, 76, 42), fill="#e03a30")
    draw.ellipse((18, 62, 110, 154), fill=key)
    draw.ellipse((44, 88, 84, 128), fill=body)
    for k in range(6):
        x, y = 22 + 48 * (k % 2), 176 + 46 * (k // 2)
        draw.ellipse((x, y, x + 36, y + 36), fill=key)
        fit_text(draw, "<=+>-o"[k], (x + 9, y + 8, x + 27, y + 28), "bold", body)
    for k, (word, c) in enumerate((("FLIX", "#c8202c"), ("MUSE", "#2fa04a"))):
        y = 322 + 34 * k
        draw.rounded_rectangle((14, y, 114, y + 27), 8, fill=c)
        fit_text(draw, word, (24, y + 4, 104, y + 23), "bold", "#ffffff")
    return image


def cool_remote(body: str) -> Image.Image:
    """An air conditioner's remote: a display and big keys."""
    image = Image.new("RGB", (192, 420), body)
    draw = ImageDraw.Draw(image)
    draw.rounded_rectangle((16, 20, 176, 150), 10, fill="#b8c8a8", outline="#6a7078", width=5)
    fit_text(draw, "21\u00b0C", (30, 36, 162, 108), "bold", "#22301c")
    fit_text(draw, "COOL", (40, 114, 150, 142), "bold", "#22301c")
    draw.rounded_rectangle((24, 172, 88, 214), 14, fill="#f07a1c")
    fit_text(draw, "ON", (36, 180, 76, 206), "bold", "#ffffff")
    draw.rounded_rectangle((104, 172, 168, 214), 14, fill="#2f8fd8")
    fit_text(draw, "MODE", (110, 182, 162, 204), "bold", "#ffffff")
    for k, word in enumerate("+-"):
        y = 232 + 60 * k
        draw.rounded_rectangle((50, y, 142, y + 48), 16, fill="#8a9098")
        fit_text(draw, word, (80, y + 6, 112, y + 42), "bold", "#ffffff")
    for k in range(3):
        draw.rounded_rectangle((20 + 54 * k, 364, 64 + 54 * k, 398), 10, fill="#c9cdd1")
    return image


def phone_charging() -> Image.Image:
    """A phone's glass while it charges: a large green battery with a bolt of lightning on it."""
    image = Image.new("RGB", (160, 320), "#05070a")
    draw = ImageDraw.Draw(image)
    draw.rounded_rectangle((58, 44, 102, 64), 6, fill="#eef4f0")
    draw.rounded_rectangle((26, 60, 134, 262), 18, fill="#eef4f0")
    draw.rounded_rectangle((36, 70, 124, 252), 11, fill="#0a120c")
    draw.rounded_rectangle((40, 96, 120, 248), 8, fill="#22d84e")
    draw.polygon([(92, 92), (50, 170), (78, 170), (66, 232), (110, 148), (82, 148)], fill="#ffffff")
    return image


def phone_front(lit: bool, cracks: int = 0) -> Image.Image:
    """A phone's glass: dark, lit, or cracked."""
    image = phone_screen(lit)
    draw = ImageDraw.Draw(image)
    draw.rounded_rectangle((62, 6, 98, 14), 4, fill="#000000")
    if not lit:
        draw.ellipse((84, 7, 90, 13), fill="#3a5a9a")
        draw.rounded_rectangle((50, 306, 110, 311), 2, fill="#6a7078")
        draw.rounded_rectangle((2, 2, 157, 317), 14, outline="#3a3f48", width=3)
    return cracked(image, cracks, (0.62, 0.3), "#f4f6f8", 5) if cracks else image
