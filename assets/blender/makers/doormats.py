"""Doormats: thin enough for a front door to swing over them. Their length is along y."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, prism_piece
from toolkit.shapes import box, extrude

COIR, DARK = "#9a7444", "#3a2a1c"
#: No mat is thicker, metres: the leaf of a front door ends 0.022 above the floor.
THICK = 0.013


def _fibres(image: Image.Image, amount: float) -> Image.Image:
    """The short bristles of coir over what is printed on it."""
    pixels = np.asarray(image.convert("RGB"), float)
    noise = np.random.default_rng(3).standard_normal((*pixels.shape[:2], 1))
    return Image.fromarray((pixels * (1 + amount * noise)).clip(0, 255).astype(np.uint8))


def _printed(kind: str, ground: str, ink: str, word: str) -> Image.Image:
    """What is on a mat, its long side across: "plain", "border", "stripes" or "word"."""
    w, h = 256, 170
    image, draw = labels.canvas(w, h, ground)
    if kind in ("border", "word"):
        draw.rectangle((10, 10, w - 10, h - 10), outline=ink, width=7 if kind == "border" else 3)
    if kind == "border":
        draw.rectangle((24, 24, w - 24, h - 24), outline=ink, width=2)
    elif kind == "word":
        labels.text(draw, word, (26, 40, w - 26, h - 40), "serif", ink)
    elif kind == "stripes":
        for k, x in enumerate(range(8, w, 30)):
            draw.rectangle((x, 0, x + (16 if k % 2 else 7), h), fill=ink)
    return image


def coir(
    kind: str, sx: float, sy: float, ground: str = COIR, ink: str = DARK, word: str = ""
) -> Model:
    """An oblong mat of bristles."""
    face = label(_fibres(_printed(kind, ground, ink, word), 0.11), occlusion=0.0)
    side = plain(shade(ground, 0.7), 0.12, 200)
    mesh = box(sx, sy, THICK, (0, 0, 0), side, labels={"+z": face})
    part = Part([mesh], collision=[box_piece((0, 0, THICK / 2), (sx, sy, THICK))])
    title = {"word": f"doormat that says {word}", "plain": "plain doormat of coir"}
    name = title.get(kind, f"doormat with {kind}" if kind != "border" else "doormat with a border")
    return Model(name, {"body": part}, mass=round(7 * sx * sy, 1), friction=0.8)


def half_round(sx: float = 0.42, sy: float = 0.72) -> Model:
    """A half disc, straight at the door, with arcs about its middle."""
    t = np.linspace(-math.pi / 2, math.pi / 2, 21)
    outline = np.c_[sx * np.cos(t) - sx / 2, sy / 2 * np.sin(t)]
    w, h = 150, 256
    image, draw = labels.canvas(w, h, COIR)
    for share, tone in ((0.94, DARK), (0.84, COIR), (0.5, DARK), (0.42, COIR), (0.2, DARK)):
        x, y = share * w, share * h / 2
        draw.ellipse((-x, h / 2 - y, x, h / 2 + y), fill=tone)
    face = label(_fibres(image, 0.11), occlusion=0.0)
    mesh = extrude(outline, THICK, face, plain(shade(COIR, 0.7), 0.12, 200))
    part = Part([mesh], collision=[prism_piece(outline[::2], 0, THICK)])
    return Model("half-round doormat", {"body": part}, mass=1.6, friction=0.8)


def ribbed(sx: float = 0.4, sy: float = 0.6, pile: str = "#6d7276") -> Model:
    """A grey carpet of ribs in a broad edge of rubber."""
    rubber = plain("#2b2c2e", 0.06, 80)
    image, draw = labels.canvas(256, 160, pile)
    for x in range(0, 256, 9):
        draw.rectangle((x, 0, x + 3, 160), fill="#4a4e52")
    face = label(_fibres(image, 0.08), occlusion=0.0)
    meshes = [box(sx, sy, 0.008, (0, 0, 0), rubber, 0.003)]
    inner = box(sx - 0.09, sy - 0.09, 0.005, (0, 0, 0.0075), rubber, labels={"+z": face})
    part = Part([*meshes, inner], collision=[box_piece((0, 0, 0.006), (sx, sy, 0.012))])
    return Model("grey doormat with a rubber edge", {"body": part}, mass=1.9, friction=0.8)


def rings(sx: float = 0.4, sy: float = 0.7) -> Model:
    """Black rubber with rows of holes."""
    image, draw = labels.canvas(256, 146, "#35363a")
    for j in range(8):
        for i in range(15):
            x, y = 8.5 + 17 * i + (8.5 if j % 2 else 0), 10 + 18 * j
            draw.ellipse((x - 6, y - 6, x + 6, y + 6), fill="#131315", outline="#55575c", width=2)
    rubber = plain("#2f3034", 0.05, 60)
    face = label(image.convert("RGB"), occlusion=0.0)
    mesh: Mesh = box(sx, sy, THICK, (0, 0, 0), rubber, 0.004, labels={"+z": face})
    part = Part([mesh], collision=[box_piece((0, 0, THICK / 2), (sx, sy, THICK))])
    return Model("rubber doormat with holes", {"body": part}, mass=3.2, friction=0.9)


def rails(sx: float = 0.42, sy: float = 0.66, pile: str = "#50555a") -> Model:
    """Strips of carpet between rails of aluminium."""
    carpet, bright = plain(pile, 0.14, 160), plain("#b9bec2", 0.05, 60)
    meshes = [box(sx, sy, 0.007, (0, 0, 0), plain("#26272a", 0.04))]
    count = 9
    for k in range(count):
        x = (k + 0.5) / count * sx - sx / 2
        meshes.append(box(0.034, sy - 0.012, 0.004, (x, 0, 0.007), carpet))
        if k:
            meshes.append(box(0.006, sy - 0.006, 0.006, (x - sx / count / 2, 0, 0.007), bright))
    part = Part(meshes, collision=[box_piece((0, 0, 0.006), (sx, sy, 0.012))])
    title = "doormat of carpet strips and rails"
    return Model(title, {"body": part}, mass=3.6, friction=0.8, prune=False)


FORMS = {"half_round": half_round, "ribbed": ribbed, "rings": rings, "rails": rails}


def doormat(form: str, **more) -> Model:
    """A doormat: one of ``FORMS``, or of coir with something printed on it."""
    return FORMS[form](**more) if form in FORMS else coir(form, **more)


def doormat_random(rng: np.random.Generator) -> dict:
    return {}


MODELS = {
    "doormat": Maker(
        doormat,
        doormat_random,
        8,
        [
            {"form": "plain", "sx": 0.4, "sy": 0.6},
            {"form": "border", "sx": 0.45, "sy": 0.75},
            {"form": "stripes", "sx": 0.4, "sy": 0.65, "ground": "#7d6a55", "ink": "#cdbfa6"},
            {"form": "word", "sx": 0.42, "sy": 0.7, "word": "HOME"},
            {"form": "ribbed"},
            {"form": "half_round"},
            {"form": "rings"},
            {"form": "rails"},
        ],
    ),
}
