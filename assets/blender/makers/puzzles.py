"""Jigsaw puzzles in their boxes."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw
from toolkit.labels import canvas, gradient, text
from toolkit.materials import label as printed
from toolkit.materials import plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.shapes import box

from makers.choking import loose


def _scene(kind: str, w: int = 256, h: int = 192) -> Image.Image:
    """A bright picture cut up by jigsaw lines."""
    image = gradient(w, h, "#6fb8e8", "#d8f0f8").convert("RGB")
    draw = ImageDraw.Draw(image)
    if kind == "castle":
        draw.ellipse((-40, h * 0.6, w + 60, h * 2), fill="#5fae4a")
        for x, top in ((60, 70), (120, 40), (176, 76)):
            draw.rectangle((x, top, x + 34, 150), fill="#c9b8a0")
            draw.polygon([(x - 6, top), (x + 17, top - 36), (x + 40, top)], fill="#c8303a")
        draw.rectangle((60, 104, 208, 150), fill="#d8c8b0")
        draw.pieslice((120, 108, 156, 180), 180, 360, fill="#5a3820")
    elif kind == "ship":
        draw.rectangle((0, 124, w, h), fill="#2a6fb0")
        draw.polygon([(40, 118), (216, 118), (186, 156), (70, 156)], fill="#8a4a22")
        draw.rectangle((124, 24, 131, 118), fill="#5a3018")
        draw.polygon([(136, 28), (206, 106), (136, 106)], fill="#f6f4ee")
        draw.polygon([(118, 40), (118, 106), (60, 106)], fill="#e8402c")
    elif kind == "balloon":
        draw.rectangle((0, 150, w, h), fill="#6fb04a")
        for x, y, r, a, b in (
            (80, 64, 44, "#e8402c", "#f2c81e"),
            (190, 86, 32, "#7b3fb5", "#f6f4ee"),
        ):
            draw.ellipse((x - r, y - r, x + r, y + r), fill=a)
            draw.ellipse((x - r / 2.4, y - r, x + r / 2.4, y + r), fill=b)
            draw.rectangle((x - 8, y + r + 10, x + 8, y + r + 24), fill="#7a4a22")
    else:
        draw.rectangle((0, 120, w, h), fill="#6fb04a")
        draw.ellipse((60, 60, 200, 170), fill="#8a8f96")
        draw.ellipse((160, 40, 236, 112), fill="#9aa0a8")
        draw.ellipse((150, 50, 190, 110), fill="#7a8088")
        draw.line([(226, 90), (240, 130), (226, 156)], fill="#9aa0a8", width=14)
        for x in (82, 160):
            draw.rectangle((x, 140, x + 24, 186), fill="#8a8f96")
        draw.ellipse((206, 64, 216, 76), fill="#17181a")
    for i in range(1, 6):
        _cut(draw, i * w / 6, h, False)
    for j in range(1, 5):
        _cut(draw, j * h / 5, w, True)
    return image


def _cut(draw, at: float, length: float, flat: bool) -> None:
    """A wavy saw cut with knobs across the picture."""
    steps = 5 if not flat else 6
    for k in range(steps):
        a, b = k * length / steps, (k + 1) * length / steps
        m, s = (a + b) / 2, (1 if (k + int(at)) % 2 else -1)
        r = (b - a) * 0.16
        line = [(a, at), (m - r, at)]
        knob = (m - r, at + s * r - r, m + r, at + s * r + r)
        tail = [(m + r, at), (b, at)]
        if not flat:
            line, tail = [p[::-1] for p in line], [p[::-1] for p in tail]
            knob = (knob[1], knob[0], knob[3], knob[2])
        draw.line(line, fill="#22252a", width=2)
        draw.line(tail, fill="#22252a", width=2)
        draw.ellipse(knob, outline="#22252a", width=2)


def _lid_print(kind: str, paint: str, count: int) -> Image.Image:
    image, draw = canvas(320, 256, paint)
    picture = _scene(kind, 256, 192).resize((264, 160))
    image.paste(picture, (28, 68))
    draw.rectangle((26, 66, 293, 229), outline="#ffffff", width=3)
    text(draw, "PUZZLE", (28, 8, 214, 62), "bold", "#ffffff", 2, "#22252a")
    draw.ellipse((232, 4, 302, 74), fill="#f2c81e", outline="#22252a", width=2)
    text(draw, str(count), (242, 16, 292, 48), "bold", "#22252a")
    text(draw, "pieces", (244, 48, 290, 62), "bold", "#22252a")
    text(draw, "JOYMILL", (110, 234, 210, 252), "bold", "#ffffff")
    return image


def puzzle_box(kind: str, picture: str, paint: str, count: int) -> Model:
    """A jigsaw in its box: 'flat', 'cube' (for small children), 'pair' (two boxes, one on the
    other), 'tray' (a puzzle half laid). No piece lies loose: it would be a small part."""
    skin, cardboard = printed(_lid_print(picture, paint, count)), plain(paint, 0.03)
    pieces: list[list[Mesh]] = []
    sides = dict.fromkeys(("+x", "-x", "+y", "-y"), (skin, (0.09, 0.74, 0.7, 0.98)))
    if kind == "flat":
        sx, sy, sz = 0.19, 0.27, 0.045
        lid = box(sx, sy, sz, (0, 0, 0), cardboard, 0.0, 1, {"+z": skin} | sides)
        pieces.append([lid])
    elif kind == "cube":
        word = {"+x": skin, "-x": skin, "+y": skin, "-y": skin, "+z": skin}
        body = box(0.13, 0.16, 0.13, (0, 0, 0), cardboard, 0.002, 1, word)
        # Without a handle: with one it is taken for a lunch box.
        pieces = [[body]]
    elif kind == "pair":
        under = printed(_lid_print("balloon", "#d8782a", 200))
        low = dict.fromkeys(sides, (under, (0.09, 0.74, 0.7, 0.98))) | {"+z": under}
        large = box(0.2, 0.28, 0.045, (0, 0, 0), plain("#d8782a", 0.03), 0.0, 1, low)
        small = box(0.15, 0.21, 0.04, (0, 0, 0), cardboard, 0.0, 1, {"+z": skin} | sides)
        pieces = [[large], [small.turn(rz=0.22).move(0.004, -0.01, 0.045)]]
    else:
        image = _scene(picture)
        frame = box(0.2, 0.27, 0.006, (0, 0, 0), plain(paint, 0.04), 0.0)
        board = plain("#d8c8a8", 0.06)
        laid = box(0.17, 0.24, 0.005, (0, 0, 0.005), board, 0, 1, {"+z": printed(image)})
        gap = plain("#cdbb96", 0.05)
        holes = [box(0.034, 0.04, 0.0006, (0.051, y, 0.0099), gap) for y in (-0.1, 0.02)]
        rims = []
        for q in (-1, 1):
            rims.append(box(0.015, 0.27, 0.012, (q * 0.0925, 0, 0), plain(paint, 0.04)))
            rims.append(box(0.17, 0.015, 0.012, (0, q * 0.1275, 0), plain(paint, 0.04)))
        pieces = [[frame, laid, *holes, *rims]]
    return loose("jigsaw puzzle", pieces, 0.5)


def puzzle_box_random(rng: np.random.Generator) -> dict:
    return {"kind": "flat", "picture": "castle", "paint": "#c8242c", "count": 100}


MODELS = {
    "puzzle_box": Maker(
        puzzle_box,
        puzzle_box_random,
        7,
        [
            {},
            {"kind": "cube", "picture": "elephant", "paint": "#2f8a5a", "count": 24},
            {"kind": "pair", "picture": "ship", "paint": "#1f4f98", "count": 500},
            {"kind": "tray", "picture": "balloon", "paint": "#f2b91c"},
            {"picture": "elephant", "paint": "#7b3fb5", "count": 48},
            {"picture": "ship", "paint": "#1f4f98", "count": 500},
            {"kind": "cube", "picture": "castle", "paint": "#e0609a", "count": 12},
        ],
    ),
}
