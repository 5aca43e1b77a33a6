"""Flat drawings of garments, laid over the bounding box of their outlines in `cloth.py`."""

from __future__ import annotations

from PIL import Image, ImageDraw

from labels.drawing import ink_on, shade, star

SIZE = 384


def _blank(colour: str) -> tuple[Image.Image, ImageDraw.ImageDraw]:
    image = Image.new("RGB", (SIZE, SIZE), colour)
    return image, ImageDraw.Draw(image)


def _stitch(canvas: ImageDraw.ImageDraw, points: list[tuple[float, float]], fill: str) -> None:
    canvas.line([(x * SIZE, y * SIZE) for x, y in points], fill=fill, width=6)


def shirt(colour: str, second: str, style: str) -> Image.Image:
    """A T-shirt ('plain', 'stripes', 'print') or a shirt with a placket ('buttons')."""
    image, canvas = _blank(colour)
    seam, s = shade(colour, 0.7), SIZE
    if style == "stripes":
        for i in range(9):
            canvas.rectangle((0, (i + 0.1) * s / 9, s, (i + 0.5) * s / 9), fill=second)
    elif style == "print":
        canvas.ellipse((0.36 * s, 0.3 * s, 0.64 * s, 0.66 * s), fill=second)
        star(canvas, 0.5 * s, 0.49 * s, 0.12 * s, colour)
    elif style == "buttons":
        canvas.rectangle(
            (0.47 * s, 0, 0.53 * s, s), fill=shade(colour, 1.35), outline=seam, width=3
        )
        for i in range(7):
            y = (0.16 + 0.125 * i) * s
            canvas.ellipse((0.5 * s - 8, y - 8, 0.5 * s + 8, y + 8), fill=ink_on(colour))
        canvas.rectangle((0.58 * s, 0.3 * s, 0.7 * s, 0.46 * s), outline=seam, width=5)
        canvas.line((0.58 * s, 0.335 * s, 0.7 * s, 0.335 * s), fill=seam, width=4)
    band = second if style in ("stripes", "print") else shade(colour, 1.3)
    neck = ((0.36, 0), (0.43, 0.1), (0.5, 0.125), (0.57, 0.1), (0.64, 0))
    canvas.line([(x * s, y * s) for x, y in neck], fill=band, width=22)
    canvas.rectangle((0, 0.965 * s, s, s), fill=band)
    for q in (0, 1):
        x = [abs(q - u) for u in (0.0, 0.09, 0.205, 0.227)]
        canvas.line([(x[0] * s, 0.26 * s), (x[1] * s, 0.47 * s)], fill=band, width=22)
        _stitch(canvas, [(x[2], 0.03), (x[3], 0.33)], seam)
    return image


def trousers(colour: str, thread: str) -> Image.Image:
    """Jeans or trousers: waistband with loops, fly, pockets, seams and hems."""
    image, canvas = _blank(colour)
    s, dark = SIZE, shade(colour, 0.65)
    for i in range(5):  # worn pale along the thighs
        pale = shade(colour, 1.06 + 0.05 * i)
        for x in (0.16, 0.66):
            left, right = x + 0.015 * i, x + 0.18 - 0.015 * i
            top, bottom = 0.2 + 0.03 * i, 0.6 - 0.03 * i
            canvas.rectangle((left * s, top * s, right * s, bottom * s), fill=pale)
    canvas.rectangle((0, 0, s, 0.05 * s), fill=shade(colour, 0.8))
    _stitch(canvas, [(0, 0.055), (1, 0.055)], thread)
    for x in (0.16, 0.34, 0.66, 0.84):
        canvas.rectangle((x * s - 7, 0, x * s + 7, 0.06 * s), fill=dark)
    _stitch(canvas, [(0.5, 0.05), (0.5, 0.3)], dark)
    _stitch(canvas, [(0.57, 0.05), (0.57, 0.17), (0.5, 0.24)], thread)
    canvas.ellipse((0.5 * s - 9, 0.02 * s - 5, 0.5 * s + 9, 0.02 * s + 13), fill="#c9a85a")
    for q in (0, 1):
        _stitch(
            canvas, [(abs(q - 0.3), 0.055), (abs(q - 0.27), 0.11), (abs(q - 0.09), 0.15)], thread
        )
        _stitch(canvas, [(abs(q - 0.09), 0.0), (abs(q - 0.03), 1.0)], dark)
        _stitch(canvas, [(abs(q - 0.49), 0.3), (abs(q - 0.36), 1.0)], thread)
    canvas.rectangle((0, 0.955 * s, s, 0.965 * s), fill=thread)
    return image


def sock(colour: str, second: str) -> Image.Image:
    """A sock: striped cuff, coloured heel and toe."""
    image, canvas = _blank(colour)
    s = SIZE
    for y in (0.06, 0.16):
        canvas.rectangle((0, y * s, s, (y + 0.05) * s), fill=second)
    canvas.rectangle((0.78 * s, 0, s, s), fill=second)
    canvas.pieslice((-0.3 * s, 0.72 * s, 0.3 * s, 1.3 * s), 180, 360, fill=second)
    return image


def towel(colour: str, second: str) -> Image.Image:
    """A towel with stripes at both ends."""
    image, canvas = _blank(colour)
    for y in (0.06, 0.1, 0.85, 0.89):
        canvas.rectangle((0, y * SIZE, SIZE, (y + 0.025) * SIZE), fill=second)
    return image
