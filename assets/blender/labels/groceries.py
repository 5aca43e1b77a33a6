"""Package fronts: a brand, a large word for what is inside, and a picture of it (Pillow)."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from PIL import Image, ImageDraw
from toolkit import labels

from labels import foods
from labels.drawing import leaf, shade

Canvas = ImageDraw.ImageDraw
Motif = Callable[[Canvas, float, float, float], None]


def _disc(d: Canvas, cx: float, cy: float, rx: float, ry: float, fill, outline=None) -> None:
    d.ellipse((cx - rx, cy - ry, cx + rx, cy + ry), fill=fill, outline=outline, width=3)


def _bar(d: Canvas, cx, cy, length, width, angle, fill, outline=None) -> None:
    """A rectangle turned by an angle."""
    c, s = math.cos(angle), math.sin(angle)
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    points = [
        (
            cx + x * length / 2 * c - y * width / 2 * s,
            cy + x * length / 2 * s + y * width / 2 * c,
        )
        for x, y in corners
    ]
    d.polygon(points, fill=fill, outline=outline)


def wheat(d: Canvas, cx: float, cy: float, s: float) -> None:
    for tilt in (-0.45, 0.0, 0.45):
        top = (cx + math.sin(tilt) * s, cy - math.cos(tilt) * s)
        d.line((cx, cy + s, *top), fill="#a9761c", width=max(3, int(s * 0.07)))
        for k in range(5):
            t = 0.25 + 0.17 * k
            x = cx + (top[0] - cx) * t
            y = cy + s + (top[1] - cy - s) * t
            for side in (-1, 1):
                a = tilt + side * 0.6
                tip = (x + math.sin(a) * s * 0.34, y - math.cos(a) * s * 0.34)
                leaf(d, (x, y), tip, s * 0.085, "#e0a82c")


def chips(d: Canvas, cx: float, cy: float, s: float) -> None:
    rng = np.random.default_rng(3)
    for k in range(9):
        a = k * 2.4
        x, y = cx + s * 0.62 * math.cos(a) * (k > 0), cy + s * 0.5 * math.sin(a) * (k > 0)
        _disc(d, x, y, s * 0.42, s * 0.3, "#f4c542", "#b9781a")
        _disc(d, x + s * 0.05, y - s * 0.04, s * 0.28, s * 0.16, "#fbe08a")
        for _ in range(4):
            u, v = rng.uniform(-0.25, 0.25, 2) * s
            _disc(d, x + u, y + v * 0.6, s * 0.03, s * 0.03, "#b0601c")


def nachos(d: Canvas, cx: float, cy: float, s: float) -> None:
    for x, y, turn in ((-0.45, 0.1, 0.2), (0.45, 0.15, 1.1), (0, -0.3, 0.6), (0, 0.4, 0.0)):
        points = [
            (
                cx + s * (x + 0.5 * math.cos(turn + k * 2.09)),
                cy + s * (y + 0.5 * math.sin(turn + k * 2.09)),
            )
            for k in range(3)
        ]
        d.polygon(points, fill="#eea52c", outline="#9a5a10")


def chocolate(d: Canvas, cx: float, cy: float, s: float, tone="#5a2f18") -> None:
    for i in range(3):
        for j in range(2):
            x, y = cx + (i - 1) * s * 0.62, cy + (j - 0.5) * s * 0.62
            d.rectangle(
                (x - s * 0.3, y - s * 0.3, x + s * 0.3, y + s * 0.3), fill=tone, outline="#2c140a"
            )
            d.rectangle(
                (x - s * 0.18, y - s * 0.18, x + s * 0.18, y + s * 0.18), fill=shade(tone, 1.35)
            )


def white_chocolate(d: Canvas, cx: float, cy: float, s: float) -> None:
    chocolate(d, cx, cy, s, "#f0dcae")


def tomato(d: Canvas, cx: float, cy: float, s: float) -> None:
    _disc(d, cx, cy, s * 0.95, s * 0.85, "#dd2a1e", "#8f120c")
    _disc(d, cx - s * 0.35, cy - s * 0.3, s * 0.2, s * 0.14, "#ff9a86")
    for k in range(5):
        a = math.tau * k / 5 - math.pi / 2
        tip = (cx + s * 0.6 * math.cos(a), cy - s * 0.6 + s * 0.3 * math.sin(a))
        leaf(d, (cx, cy - s * 0.62), tip, s * 0.1, "#2f8a2c")


def olives(d: Canvas, cx: float, cy: float, s: float) -> None:
    d.line((cx - s, cy - s * 0.5, cx + s, cy - s * 0.7), fill="#6a5a2c", width=max(3, int(s / 14)))
    for x, up in ((-0.7, 1), (-0.2, -1), (0.35, 1), (0.8, -1)):
        at = (cx + x * s, cy - s * 0.58)
        leaf(d, at, (at[0] + s * 0.35, at[1] - up * s * 0.5), s * 0.13, "#7f9a4a")
    for x, y, tone in ((-0.4, 0.15, "#8fa832"), (0.35, 0.25, "#6f8a24")):
        _disc(d, cx + x * s, cy + y * s, s * 0.32, s * 0.46, tone, "#46591a")
        _disc(d, cx + x * s - s * 0.1, cy + y * s - s * 0.18, s * 0.08, s * 0.14, "#d8e49a")


def strawberry(d: Canvas, cx: float, cy: float, s: float) -> None:
    shape = [(-0.75, -0.4), (-0.4, -0.62), (0.4, -0.62), (0.75, -0.4), (0.5, 0.3), (0, 0.9)]
    shape.append((-0.5, 0.3))
    d.polygon([(cx + x * s, cy + y * s) for x, y in shape], fill="#d81e34", outline="#8a0c1c")
    for x, y in ((-0.4, -0.2), (0, -0.3), (0.4, -0.2), (-0.2, 0.1), (0.22, 0.1), (0, 0.45)):
        _disc(d, cx + x * s, cy + y * s, s * 0.05, s * 0.08, "#ffe28a")
    for x in (-0.6, -0.2, 0.2, 0.6):
        leaf(d, (cx, cy - s * 0.55), (cx + x * s, cy - s * 0.95), s * 0.14, "#2f8a2c")


def _berries(tone: str, places, radius: float) -> Motif:
    def draw(d: Canvas, cx: float, cy: float, s: float) -> None:
        for x, y in places:
            r = radius * s
            _disc(d, cx + x * s, cy + y * s, r, r, tone, shade(tone, 0.55))
            _disc(d, cx + x * s - r * 0.3, cy + y * s - r * 0.35, r * 0.25, r * 0.2, "#ffffff")
        leaf(d, (cx, cy - 0.5 * s), (cx + 0.7 * s, cy - 0.95 * s), s * 0.18, "#2f8a2c")

    return draw


blueberry = _berries("#3f4fa8", [(-0.45, 0.2), (0.45, 0.2), (0, -0.25)], 0.44)
grapes = _berries(
    "#7a3a94",
    [(-0.5, -0.4), (0, -0.45), (0.5, -0.4), (-0.25, 0.02), (0.28, 0.02), (0, 0.45)],
    0.3,
)


def cherry(d: Canvas, cx: float, cy: float, s: float) -> None:
    for x in (-0.45, 0.45):
        d.line((cx + x * s, cy + s * 0.3, cx + s * 0.1, cy - s * 0.9), fill="#3f7a24", width=4)
        _disc(d, cx + x * s, cy + s * 0.4, s * 0.42, s * 0.42, "#c0142a", "#6a0812")
        _disc(d, cx + (x - 0.14) * s, cy + s * 0.25, s * 0.1, s * 0.09, "#ff9aa4")
    leaf(d, (cx + 0.1 * s, cy - 0.85 * s), (cx + 0.8 * s, cy - 0.7 * s), s * 0.16, "#3f8a2c")


def orange(d: Canvas, cx: float, cy: float, s: float, peel="#f08a12", flesh="#ffb83a") -> None:
    _disc(d, cx, cy, s, s, peel)
    _disc(d, cx, cy, s * 0.86, s * 0.86, "#fff3d8")
    for k in range(8):
        box = (cx - s * 0.8, cy - s * 0.8, cx + s * 0.8, cy + s * 0.8)
        d.pieslice(box, 45 * k + 4, 45 * k + 41, fill=flesh)


def lemon(d: Canvas, cx: float, cy: float, s: float) -> None:
    orange(d, cx, cy, s, "#f2d21c", "#fbec7a")


def apricot(d: Canvas, cx: float, cy: float, s: float) -> None:
    for x in (-0.4, 0.4):
        _disc(d, cx + x * s, cy + 0.1 * s, s * 0.58, s * 0.6, "#f5a02c", "#b8640c")
        d.arc(
            (cx + x * s - 5, cy - s * 0.5, cx + x * s + s * 0.5, cy + s * 0.7),
            110,
            250,
            "#b8640c",
            4,
        )
    leaf(d, (cx, cy - 0.45 * s), (cx + 0.75 * s, cy - 0.9 * s), s * 0.18, "#3f8a2c")


def apple(d: Canvas, cx: float, cy: float, s: float) -> None:
    for x in (-0.3, 0.3):
        _disc(d, cx + x * s, cy + s * 0.1, s * 0.6, s * 0.75, "#d2322c")
    _disc(d, cx - s * 0.4, cy - s * 0.2, s * 0.14, s * 0.2, "#f7b0a0")
    d.line((cx, cy - s * 0.45, cx + s * 0.12, cy - s * 0.95), fill="#4a2c14", width=6)
    leaf(d, (cx + s * 0.08, cy - s * 0.7), (cx + s * 0.75, cy - s * 0.9), s * 0.16, "#3f8a2c")


def cola(d: Canvas, cx: float, cy: float, s: float) -> None:
    """Bubbles."""
    spots = ((0, 0, 0.5), (0.7, -0.5, 0.26), (-0.7, 0.45, 0.3), (0.6, 0.6, 0.2), (-0.5, -0.6, 0.2))
    for x, y, r in spots:
        _disc(d, cx + x * s, cy + y * s, r * s, r * s, None, "#ffffff")


def fish_fingers(d: Canvas, cx: float, cy: float, s: float) -> None:
    rng = np.random.default_rng(5)
    for k in range(4):
        y = cy + (k - 1.5) * s * 0.44
        x = cx + (0.12 if k % 2 else -0.12) * s
        box = (x - s, y - s * 0.19, x + s, y + s * 0.19)
        d.rounded_rectangle(box, s * 0.08, fill="#e8962c", outline="#8f4c10", width=3)
        for _ in range(26):
            u, v = rng.uniform(-0.92, 0.92) * s, rng.uniform(-0.14, 0.14) * s
            tone = ("#f8c060", "#b8641a")[int(rng.integers(2))]
            _disc(d, x + u, y + v, s * 0.04, s * 0.03, tone)
    d.rectangle((cx + s * 0.9, cy - s * 0.85, cx + s * 1.0, cy - s * 0.48), fill="#fff6ea")


def grass_cow(d: Canvas, cx: float, cy: float, s: float) -> None:
    from makers.packages import cow

    cow(d, cx, cy, s)


def milk_glass(d: Canvas, cx: float, cy: float, s: float) -> None:
    from makers.packages import full_glass

    full_glass(d, cx, cy, s)


def mountains(d: Canvas, cx: float, cy: float, s: float) -> None:
    for x, h in ((-0.6, 0.7), (0.55, 0.85), (0, 1.25)):
        top = (cx + x * s, cy + s * (0.6 - h * 1.1))
        d.polygon(
            [(cx + (x - 0.75) * s, cy + 0.6 * s), top, (cx + (x + 0.75) * s, cy + 0.6 * s)],
            fill="#5a8fc8",
        )
        snow = [(-0.2, 0.3), (0, 0), (0.2, 0.3), (0.06, 0.22), (-0.06, 0.3)]
        d.polygon([(top[0] + u * s, top[1] + v * s) for u, v in snow], fill="#ffffff")


def castle(d: Canvas, cx: float, cy: float, s: float, fill="#7a1326") -> None:
    shape = [(-0.9, 0.7), (-0.9, -0.3), (-0.4, -0.3), (-0.4, -0.8), (0.4, -0.8), (0.4, -0.3)]
    shape += [(0.9, -0.3), (0.9, 0.7)]
    d.polygon([(cx + x * s, cy + y * s) for x, y in shape], fill=fill)
    _disc(d, cx, cy + s * 0.4, s * 0.2, s * 0.35, "#f3ead2")


def loops(d: Canvas, cx: float, cy: float, s: float) -> None:
    """A bowl of cereal."""
    rng = np.random.default_rng(7)
    d.pieslice((cx - s, cy - s * 0.9, cx + s, cy + s * 0.95), 0, 180, fill="#2f5fa8")
    _disc(d, cx, cy, s, s * 0.3, "#fbf8ef", "#2f5fa8")
    for _ in range(30):
        a, q = rng.uniform(0, 6.28), math.sqrt(rng.uniform(0, 0.75))
        x, y, r = cx + s * q * math.cos(a), cy + s * 0.28 * q * math.sin(a), s * 0.1
        _disc(d, x, y, r, r * 0.75, ("#d9962c", "#e8b04a")[int(rng.integers(2))], "#8a5410")


def flakes(d: Canvas, cx: float, cy: float, s: float) -> None:
    rng = np.random.default_rng(8)
    d.pieslice((cx - s, cy - s * 0.9, cx + s, cy + s * 0.95), 0, 180, fill="#c8322c")
    _disc(d, cx, cy, s, s * 0.3, "#fbf8ef", "#c8322c")
    for _ in range(34):
        a, q = rng.uniform(0, 6.28), math.sqrt(rng.uniform(0, 0.8))
        x, y = cx + s * q * math.cos(a), cy + s * (0.28 * q * math.sin(a) - 0.04)
        _bar(d, x, y, s * 0.2, s * 0.12, rng.uniform(0, 3), "#f0b030", "#b0700c")


def broccoli(d: Canvas, cx: float, cy: float, s: float) -> None:
    d.polygon(
        [(cx - 0.2 * s, cy), (cx + 0.2 * s, cy), (cx + 0.16 * s, cy + s), (cx - 0.16 * s, cy + s)],
        fill="#9fc06a",
    )
    spots = ((-0.6, -0.1), (0.6, -0.1), (-0.3, -0.5), (0.3, -0.5), (0, -0.1), (-0.1, -0.75))
    for x, y in spots:
        _disc(d, cx + x * s, cy + y * s, s * 0.4, s * 0.36, "#3f8a34", "#235a1c")


def pizza(d: Canvas, cx: float, cy: float, s: float) -> None:
    foods.pizza(d, cx, cy, s, "salami", np.random.default_rng(2))


def snow(d: Canvas, cx: float, cy: float, s: float) -> None:
    foods.snowflake(d, cx, cy, s)


def peas(d: Canvas, cx: float, cy: float, s: float) -> None:
    foods.peas(d, (cx - s, cy - s * 0.7, cx + s, cy + s * 0.7), np.random.default_rng(4))


def ice_scoops(colour: str, dark: str) -> Motif:
    def draw(d: Canvas, cx: float, cy: float, s: float) -> None:
        foods.cone(d, cx, cy + s * 0.1, s * 0.45, s * 0.95)
        foods.scoop(d, cx, cy - s * 0.25, s * 0.55, colour, dark)

    return draw


def fish(d: Canvas, cx: float, cy: float, s: float) -> None:
    foods.fish(d, cx, cy, s)


def swirl(d: Canvas, cx: float, cy: float, s: float) -> None:
    foods.swirl(d, cx, cy, s, "#5a2f1a", "#8a5230")


def hop(d: Canvas, cx: float, cy: float, s: float) -> None:
    """A mug of beer."""
    d.rectangle((cx - 0.55 * s, cy - 0.5 * s, cx + 0.4 * s, cy + 0.9 * s), fill="#f0b020")
    d.arc(
        (cx + 0.15 * s, cy - 0.2 * s, cx + 0.95 * s, cy + 0.6 * s), -90, 90, "#f6e8c0", int(s / 6)
    )
    for x, y in ((-0.5, -0.5), (-0.1, -0.65), (0.3, -0.5)):
        _disc(d, cx + x * s, cy + y * s, s * 0.32, s * 0.26, "#ffffff")


def pasta_window(d: Canvas, box, kind: str, rng) -> None:
    """A see-through window full of pasta."""
    x0, y0, x1, y1 = box
    d.rounded_rectangle(box, 14, fill="#b9822c")
    if kind == "spaghetti":
        for x in np.arange(x0 + 5, x1 - 4, 6):
            tone = ("#f6d678", "#e8bd52", "#fbe49a")[int(rng.integers(3))]
            d.line((x, y0 + 5, x + rng.uniform(-3, 3), y1 - 5), fill=tone, width=4)
        return
    step = 30
    for y in np.arange(y0 + 16, y1 - 12, step * 0.72):
        for x in np.arange(x0 + 22, x1 - 18, step * 1.25):
            a, u, v = rng.uniform(-0.9, 0.9), *rng.uniform(-6, 6, 2)
            cx, cy = x + u, y + v
            if kind == "penne":
                _bar(d, cx, cy, 44, 17, a, "#f2cc68", "#a87420")
                c, s = math.cos(a), math.sin(a)
                d.line((cx - 16 * c, cy - 16 * s, cx + 16 * c, cy + 16 * s), "#fbe6a4", 5)
            elif kind == "fusilli":
                for k in range(-2, 3):
                    px, py = cx + 9 * k * math.cos(a), cy + 9 * k * math.sin(a)
                    _bar(d, px, py, 22, 7, a + 1.0, "#f4d070", "#a87420")
            else:  # farfalle
                for side in (-1, 1):
                    px, py = cx + side * 13 * math.cos(a), cy + side * 13 * math.sin(a)
                    _bar(d, px, py, 20, 28, a, "#f6d678", "#a87420")
                _disc(d, cx, cy, 6, 7, "#d9a640")


def face(
    w: int,
    h: int,
    ground: str,
    band: str,
    word: str,
    brand: str = "",
    motif: Motif | None = None,
    sub: str = "",
    ink: str = "#ffffff",
    edge: str = "",
    image: Image.Image | None = None,
) -> Image.Image:
    """A package front: upright ones are stacked, wide ones have the picture on the right."""
    image = image or labels.canvas(w, h, ground)[0]
    d = ImageDraw.Draw(image)
    stroke = edge or shade(band, 0.45)
    lines = word.split("\n")

    def words(x0: float, y0: float, x1: float, y1: float) -> None:
        step = (y1 - y0) / len(lines)
        for k, line in enumerate(lines):
            box = (x0, y0 + k * step + 2, x1, y0 + (k + 1) * step - 2)
            labels.text(d, line, box, "bold", ink, max(2, h // 90), stroke)

    if w > 1.35 * h:
        split = 0.66 * w if motif else 0.97 * w
        d.rectangle((0, h * 0.3, split, h * 0.8), fill=band)
        labels.text(
            d, brand, (w * 0.05, h * 0.05, split * 0.8, h * 0.27), "italic", shade(band, 0.7)
        )
        words(w * 0.04, h * 0.34, split * 0.98, h * 0.76)
        if motif:
            motif(d, w * 0.83, h * 0.5, min(w * 0.15, h * 0.36))
        if sub:
            labels.text(d, sub, (w * 0.05, h * 0.83, split, h * 0.97), "bold", stroke)
        return image
    d.rectangle((0, h * 0.17, w, h * 0.47), fill=band)
    labels.text(d, brand, (w * 0.1, h * 0.04, w * 0.9, h * 0.15), "italic", shade(band, 0.7))
    words(w * 0.05, h * 0.19, w * 0.95, h * 0.45)
    if motif:
        motif(d, w * 0.5, h * 0.68, min(w * 0.4, h * 0.185))
    if sub:
        d.rectangle((0, h * 0.89, w, h), fill=band)
        labels.text(d, sub, (w * 0.06, h * 0.9, w * 0.94, h * 0.985), "bold", ink)
    return image


def wrapped(
    repeats: int,
    w: int,
    h: int,
    ground: str,
    band: str,
    word: str,
    brand: str = "",
    motif: Motif | None = None,
    sub: str = "",
    ink: str = "#ffffff",
) -> Image.Image:
    """The same front several times round; an odd number has one of them at the middle."""
    one = face(w, h, ground, band, word, brand, motif, sub, ink)
    image = Image.new("RGBA", (w * repeats, h))
    for k in range(repeats):
        image.paste(one, (k * w, 0))
    return image
