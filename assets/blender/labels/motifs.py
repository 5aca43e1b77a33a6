"""Small pictures on labels of cleaners and sprays: insects, a shining pane, a plate, an oven."""

from __future__ import annotations

import math

from PIL import ImageDraw

from labels.drawing import star

Box = tuple[float, float, float, float]


def _body(canvas: ImageDraw.ImageDraw, box: Box, at, radii, fill: str) -> None:
    x0, y0, x1, y1 = box
    (x, y), (a, b) = at, radii
    w, h = x1 - x0, y1 - y0
    left, low, right, high = x - a, y - b, x + a, y + b
    canvas.ellipse((x0 + left * w, y0 + low * h, x0 + right * w, y0 + high * h), fill=fill)


def insect(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A fat black fly from above, struck through by a red ring and bar."""
    x0, y0, x1, y1 = box
    w, h = x1 - x0, y1 - y0
    canvas.ellipse(box, fill="#ffffff")
    for side in (-1, 1):
        for y, reach in ((0.34, 0.12), (0.5, 0.5), (0.62, 0.88)):
            points = [(0.5, 0.45), (0.5 + side * 0.26, (y + reach) / 2), (0.5 + side * 0.34, reach)]
            line = [(x0 + x * w, y0 + yy * h) for x, yy in points]
            canvas.line(line, fill="#111111", width=max(3, int(w * 0.05)), joint="curve")
        wing = [(0.5, 0.38), (0.5 + side * 0.34, 0.72), (0.5 + side * 0.14, 0.86)]
        canvas.polygon([(x0 + x * w, y0 + y * h) for x, y in wing], fill="#8a9aa8")
    _body(canvas, box, (0.5, 0.62), (0.12, 0.26), "#111111")
    _body(canvas, box, (0.5, 0.36), (0.14, 0.14), "#111111")
    _body(canvas, box, (0.5, 0.2), (0.12, 0.1), "#111111")
    for side in (-1, 1):
        _body(canvas, box, (0.5 + side * 0.09, 0.17), (0.05, 0.05), "#d8202c")
    width = max(4, int(w * 0.09))
    canvas.ellipse(box, outline="#d81820", width=width)
    reach = 0.5 - 0.5 * math.sqrt(0.5)
    ends = [(x0 + reach * w, y0 + reach * h), (x1 - reach * w, y1 - reach * h)]
    canvas.line(ends, fill="#d81820", width=width)


def window(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A shining pane of glass."""
    x0, y0, x1, y1 = box
    w, h = x1 - x0, y1 - y0
    canvas.rectangle(box, fill="#bfe4fa", outline=colour, width=max(4, int(w * 0.08)))
    canvas.line((x0, (y0 + y1) / 2, x1, (y0 + y1) / 2), fill=colour, width=max(3, int(w * 0.06)))
    canvas.line(((x0 + x1) / 2, y0, (x0 + x1) / 2, y1), fill=colour, width=max(3, int(w * 0.06)))
    star(canvas, x0 + 0.75 * w, y0 + 0.25 * h, 0.26 * w, "#ffffff", 4)


def plate(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A clean plate that sparkles."""
    x0, y0, x1, y1 = box
    w = x1 - x0
    canvas.ellipse(box, fill="#ffffff", outline=colour, width=max(4, int(w * 0.06)))
    inner = (x0 + 0.2 * w, y0 + 0.2 * w, x1 - 0.2 * w, y1 - 0.2 * w)
    canvas.ellipse(inner, outline="#b8c4cc", width=max(3, int(w * 0.04)))
    star(canvas, x0 + 0.72 * w, y0 + 0.26 * w, 0.24 * w, "#f2c21e", 4)


def oven(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """An oven's front."""
    x0, y0, x1, y1 = box
    w, h = x1 - x0, y1 - y0
    canvas.rounded_rectangle(box, 0.08 * w, fill=colour)
    canvas.rectangle((x0 + 0.14 * w, y0 + 0.4 * h, x1 - 0.14 * w, y1 - 0.12 * h), fill="#26282c")
    for k in range(4):
        x = x0 + (0.2 + 0.2 * k) * w
        canvas.ellipse((x - 0.06 * w, y0 + 0.1 * h, x + 0.06 * w, y0 + 0.22 * h), fill="#ffffff")


def flame(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """The warning square on its point with a flame: highly flammable."""
    x0, y0, x1, y1 = box
    cx, cy, r = (x0 + x1) / 2, (y0 + y1) / 2, (x1 - x0) / 2
    square = [(cx, cy - r), (cx + r, cy), (cx, cy + r), (cx - r, cy)]
    canvas.polygon(square, fill="#ffffff", outline="#d01818", width=max(3, int(r * 0.16)))
    line = [(0, -0.5), (0.2, -0.15), (0.14, 0.02), (0.3, -0.08), (0.28, 0.25), (0.1, 0.42)]
    line += [(-0.1, 0.42), (-0.28, 0.25), (-0.26, -0.05), (-0.12, 0.05), (-0.1, -0.25)]
    canvas.polygon([(cx + x * r, cy + y * r) for x, y in line], fill="#111111")
