"""Drawing labels with Pillow. Brands are invented ones."""

from __future__ import annotations

import functools
import math
import os

from PIL import Image, ImageDraw, ImageFont

FONT_FOLDER = os.environ.get("SDGEN_FONTS", "/usr/share/fonts/truetype/dejavu")
FONTS = {
    "sans": "DejaVuSans.ttf",
    "bold": "DejaVuSans-Bold.ttf",
    "condensed": "DejaVuSansCondensed-Bold.ttf",
    "serif": "DejaVuSerif-Bold.ttf",
    "italic": "DejaVuSerif-BoldItalic.ttf",
    "oblique": "DejaVuSans-BoldOblique.ttf",
}


@functools.cache
def font(kind: str, size: int) -> ImageFont.FreeTypeFont:
    # the default layout engine draws nothing inside Blender (two FreeTypes meet), without an error
    path = os.path.join(FONT_FOLDER, FONTS[kind])
    return ImageFont.truetype(path, size, layout_engine=ImageFont.Layout.BASIC)


def canvas(width: int, height: int, fill=None) -> tuple[Image.Image, ImageDraw.ImageDraw]:
    """A picture to draw on; transparent when fill is None."""
    image = Image.new("RGBA", (width, height), fill or (0, 0, 0, 0))
    return image, ImageDraw.Draw(image)


def text(
    draw, words: str, box, kind="bold", fill="#fff", stroke=0, stroke_fill="#000", align="centre"
) -> None:
    """The largest lettering that fits the box (x0, y0, x1, y1)."""
    x0, y0, x1, y1 = box
    size = y1 - y0
    while True:
        chosen = font(kind, max(5, int(size)))
        left, top, right, bottom = draw.textbbox((0, 0), words, font=chosen, stroke_width=stroke)
        if size <= 5 or (right - left <= x1 - x0 and bottom - top <= y1 - y0):
            break
        size *= 0.93
    x = (x0 + x1 - (right - left)) / 2 if align == "centre" else x0
    y = (y0 + y1 - (bottom - top)) / 2
    draw.text(
        (x - left, y - top),
        words,
        font=chosen,
        fill=fill,
        stroke_width=stroke,
        stroke_fill=stroke_fill,
    )


def small_print(draw, box, rows: int, fill="#777", rng=None, thickness=0.45) -> None:
    """Grey bars standing for text nobody reads."""
    x0, y0, x1, y1 = box
    step = (y1 - y0) / rows
    for i in range(rows):
        short = rng.random() if rng is not None else (i * 37 % 10) / 10
        draw.rectangle(
            (x0, y0 + i * step, x1 - (x1 - x0) * short * 0.35, y0 + (i + thickness) * step),
            fill=fill,
        )


def barcode(draw, box, rng) -> None:
    x0, y0, x1, y1 = box
    draw.rectangle((x0 - 4, y0 - 4, x1 + 4, y1 + 4), fill="#fff")
    x = x0
    while x < x1:
        bar = int(rng.integers(2, 6))
        draw.rectangle((x, y0, min(x + bar, x1), y1), fill="#111")
        x += bar + int(rng.integers(2, 6))


def gradient(width: int, height: int, top: str, bottom: str) -> Image.Image:
    from PIL import ImageColor

    a, b = ImageColor.getrgb(top), ImageColor.getrgb(bottom)
    column = Image.new("RGBA", (1, height))
    for y in range(height):
        t = y / max(height - 1, 1)
        column.putpixel((0, y), (*(int(a[i] + (b[i] - a[i]) * t) for i in range(3)), 255))
    return column.resize((width, height))


def blob(draw, cx, cy, radius, rng, fill, unevenness=0.45) -> None:
    """An irregular spot."""
    phase = rng.random(3) * 2 * math.pi
    points = []
    for i in range(40):
        t = 2 * math.pi * i / 40
        wave = (
            0.5 * math.sin(2 * t + phase[0])
            + 0.3 * math.sin(3 * t + phase[1])
            + 0.2 * math.sin(5 * t + phase[2])
        )
        r = radius * (1 + unevenness * wave)
        points.append((cx + r * math.cos(t), cy + r * math.sin(t)))
    draw.polygon(points, fill=fill)
