"""Labels of things that poison: a brand, big plain words, a pictogram. Brands are invented."""

from __future__ import annotations

import math

from PIL import Image, ImageDraw
from toolkit.labels import small_print
from toolkit.labels import text as fit_text

from labels import motifs
from labels.drawing import drop, ink_on, shade, star

Box = tuple[float, float, float, float]


def _warning(canvas: ImageDraw.ImageDraw, cx: float, cy: float, r: float, sign: str) -> None:
    """The red-framed square on its point, with '!', a flame or the corrosive tilted vessel."""
    square = [(cx, cy - r), (cx + r, cy), (cx, cy + r), (cx - r, cy)]
    if sign == "flame":
        motifs.flame(canvas, (cx - r, cy - r, cx + r, cy + r), "#111111")
        return
    canvas.polygon(square, fill="#ffffff", outline="#d01818", width=max(3, int(r * 0.16)))
    if sign == "!":
        fit_text(
            canvas, "!", (cx - 0.4 * r, cy - 0.55 * r, cx + 0.4 * r, cy + 0.5 * r), fill="#111"
        )
        return
    tilted = [(-0.5, -0.3), (-0.1, -0.45), (0, -0.28), (-0.38, -0.1)]
    canvas.polygon([(cx + x * r, cy + y * r) for x, y in tilted], fill="#111111")
    for x in (-0.22, -0.1):
        canvas.line(
            (cx + x * r, cy - 0.12 * r, cx + x * r, cy + 0.2 * r), fill="#111111", width=int(r / 12)
        )
    canvas.rectangle((cx - 0.5 * r, cy + 0.24 * r, cx + 0.5 * r, cy + 0.38 * r), fill="#111111")


def _pipe(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A drain's S-bend with water in it."""
    x0, y0, x1, y1 = box
    w, h = x1 - x0, y1 - y0
    path = [(0.15, 0.0), (0.15, 0.7), (0.3, 0.9), (0.45, 0.7), (0.45, 0.45), (0.6, 0.3), (0.9, 0.3)]
    points = [(x0 + x * w, y0 + y * h) for x, y in path]
    canvas.line(points, fill="#5d666e", width=int(w * 0.2), joint="curve")
    canvas.line(points, fill=colour, width=int(w * 0.11), joint="curve")


def _toilet(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A toilet from the side."""
    x0, y0, x1, y1 = box
    w, h = x1 - x0, y1 - y0

    def place(points):
        return [(x0 + x * w, y0 + y * h) for x, y in points]

    canvas.polygon(place([(0.05, 0.0), (0.3, 0.0), (0.3, 0.5), (0.05, 0.5)]), fill=colour)
    bowl = [(0.12, 0.5), (0.98, 0.46), (0.9, 0.68), (0.62, 0.8), (0.66, 1), (0.22, 1), (0.24, 0.8)]
    canvas.polygon(place(bowl), fill=colour)
    canvas.line(place([(0.3, 0.42), (0.95, 0.4)]), fill=colour, width=int(h * 0.06))


def _shirt(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A T-shirt."""
    x0, y0, x1, y1 = box
    outline = [(0.3, 0.05), (0.42, 0.14), (0.58, 0.14), (0.7, 0.05), (1, 0.3), (0.86, 0.48)]
    outline += [(0.75, 0.38), (0.75, 1), (0.25, 1), (0.25, 0.38), (0.14, 0.48), (0, 0.3)]
    points = [(x0 + x * (x1 - x0), y0 + y * (y1 - y0)) for x, y in outline]
    canvas.polygon(points, fill=colour, outline="#ffffff", width=4)


def _tablet(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A layered dishwasher tablet with its ball."""
    x0, y0, x1, y1 = box
    h = y1 - y0
    canvas.rounded_rectangle((x0, y0 + 0.3 * h, x1, y1), h * 0.1, fill="#ffffff")
    canvas.rectangle((x0, y0 + 0.45 * h, x1, y0 + 0.7 * h), fill=colour)
    cx, r = (x0 + x1) / 2, 0.24 * h
    canvas.ellipse((cx - r, y0 + 0.04 * h, cx + r, y0 + 0.04 * h + 2 * r), fill="#d8202c")


def _pod(canvas: ImageDraw.ImageDraw, box: Box, colour: str) -> None:
    """A two-chambered laundry pod."""
    x0, y0, x1, y1 = box
    canvas.rounded_rectangle(box, (y1 - y0) * 0.3, fill="#ffffff")
    inner = (x0 + 6, y0 + 6, x1 - 6, y1 - 6)
    canvas.pieslice(inner, 60, 240, fill=colour)
    canvas.pieslice(inner, 240, 420, fill="#f08a1c")


MOTIFS = {
    "pipe": _pipe,
    "toilet": _toilet,
    "shirt": _shirt,
    "tablet": _tablet,
    "pod": _pod,
    "insect": motifs.insect,
    "window": motifs.window,
    "plate": motifs.plate,
    "oven": motifs.oven,
}


def cleaner_front(
    brand: str,
    lines: list[str],
    paper: str,
    band: str,
    ink: str,
    motif: str = "",
    sign: str = "corrosive",
    size: tuple[int, int] = (256, 340),
) -> Image.Image:
    """Brand band, what it is in big letters, then a picture and the warning sign."""
    width, height = size
    image = Image.new("RGBA", size, (0, 0, 0, 0))
    canvas = ImageDraw.Draw(image)
    canvas.rounded_rectangle((2, 2, width - 3, height - 3), 22, fill=paper)
    canvas.polygon(
        [
            (2, 0.06 * height),
            (width - 3, 0.02 * height),
            (width - 3, 0.24 * height),
            (2, 0.28 * height),
        ],
        fill=band,
    )
    box = (14, 0.06 * height, width - 14, 0.24 * height)
    fit_text(canvas, brand, box, "oblique", "#ffffff", 3, shade(band, 0.4))
    top, bottom = 0.3 * height, 0.62 * height
    step = (bottom - top) / len(lines)
    for i, line in enumerate(lines):
        row = (8, top + i * step, width - 8, top + (i + 0.92) * step)
        fit_text(canvas, line, row, "condensed", ink)
    low = (0.66 * height, 0.96 * height)
    half = (low[1] - low[0]) / 2
    if motif == "star":
        star(canvas, 0.3 * width, low[0] + half, half, band, 8)
    elif motif == "drop":
        drop(canvas, 0.3 * width, low[0] + half, half * 0.62, band, "#ffffff")
    elif motif:
        MOTIFS[motif](canvas, (0.1 * width, low[0], 0.1 * width + 2 * half, low[1]), band)
    if sign:
        _warning(canvas, width - 10 - half, low[0] + half, half, sign)
    return image


def remedy_band(
    brand: str, words: list[str], paper: str, colour: str, picture: str = "", note: str = ""
) -> Image.Image:
    """A wrap-around paper of a remedy: the same front panel four times, all round."""
    width, height = 1024, 288
    image = Image.new("RGB", (width, height), paper)
    canvas = ImageDraw.Draw(image)
    panel = width // 4
    for k in range(5):  # one of them is centred on the front
        x = k * panel - panel // 2
        canvas.rectangle((x, 0, x + panel, 0.22 * height), fill=colour)
        box = (x + 16, 0.03 * height, x + panel - 16, 0.2 * height)
        fit_text(canvas, brand, box, "oblique", ink_on(colour))
        step = 0.42 * height / len(words)
        for i, word in enumerate(words):
            y = 0.26 * height + i * step
            fit_text(canvas, word, (x + 8, y, x + panel - 8, y + 0.92 * step), fill=colour)
        cx, cy, r = x + 66, 0.84 * height, 0.13 * height
        if picture == "orange":
            canvas.ellipse((cx - r, cy - r, cx + r, cy + r), fill="#f08a1c", outline="#d86a0c")
            for i in range(8):
                a = math.tau * i / 8
                end = (cx + 0.85 * r * math.cos(a), cy + 0.85 * r * math.sin(a))
                canvas.line((cx, cy, *end), fill="#ffe6c0", width=4)
        elif picture == "cross":
            canvas.rectangle((cx - r * 0.35, cy - r, cx + r * 0.35, cy + r), fill="#d01828")
            canvas.rectangle((cx - r, cy - r * 0.35, cx + r, cy + r * 0.35), fill="#d01828")
        elif picture == "capsule":
            canvas.rounded_rectangle(
                (cx - 1.4 * r, cy - 0.5 * r, cx + 1.4 * r, cy + 0.5 * r), r / 2
            )
            canvas.rounded_rectangle(
                (cx - 1.4 * r, cy - 0.5 * r, cx + 1.4 * r, cy + 0.5 * r), r / 2, fill="#f2c52a"
            )
            canvas.rectangle((cx, cy - 0.5 * r, cx + 0.8 * r, cy + 0.5 * r), fill="#d01828")
        if note:
            box = (x + 112, 0.74 * height, x + panel - 10, 0.93 * height)
            fit_text(canvas, note, box, "bold", "#333333")
        else:
            box = (x + 120, 0.76 * height, x + panel - 20, 0.94 * height)
            small_print(canvas, box, 3, "#888888")
    return image


def front(
    brand: str,
    lines: list[str],
    ink: str,
    accent: str,
    paper: str = "",
    size: tuple[int, int] = (256, 256),
    kind: str = "serif",
) -> Image.Image:
    """A plain elegant label: brand over a line over what it is; no paper: printed on the thing."""
    width, height = size
    image = Image.new("RGBA", size, (0, 0, 0, 0))
    canvas = ImageDraw.Draw(image)
    if paper:
        canvas.rectangle((2, 2, width - 3, height - 3), fill=paper, outline=accent, width=6)
    fit_text(canvas, brand, (18, 0.08 * height, width - 18, 0.42 * height), kind, ink)
    canvas.rectangle((30, 0.46 * height, width - 30, 0.49 * height), fill=accent)
    step = 0.4 * height / len(lines)
    for i, line in enumerate(lines):
        y = 0.53 * height + i * step
        fit_text(canvas, line, (20, y, width - 20, y + 0.85 * step), "bold", ink)
    return image
