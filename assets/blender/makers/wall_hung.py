"""What hangs on walls without frame or glass (back at -X): posters and calendars, hooks with coats,
holders of toilet rolls."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import box, ellipsoid, extrude, lathe, rounded_rectangle, tube

from .convex import few_corners
from .frames import pane
from .garments_hung import hang
from .joinery import Assembly, finish, steel
from .pictures import painting

Offset = tuple[float, float, float]


# ---- posters
def alphabet(width: int, height: int) -> Image.Image:
    """A chart of the letters, each on a tile of its colour."""
    tones = ["#e4664a", "#e0a458", "#7d9a78", "#4f8a9a", "#8a6a9a"]
    image = Image.new("RGBA", (width, height), "#f6f1e4")
    draw = ImageDraw.Draw(image)
    columns, rows = 4, 7
    w, h = width / columns, height / rows
    for k, letter in enumerate("ABCDEFGHIJKLMNOPQRSTUVWXYZ"):
        x, y = k % columns * w, k // columns * h
        draw.rectangle((x + 5, y + 5, x + w - 5, y + h - 5), fill=tones[(k + k // columns) % 5])
        labels.text(draw, letter, (x + 8, y + 8, x + w - 8, y + h - 8), "bold", "#ffffff")
    return image


def calendar(seed: int, width: int, height: int) -> Image.Image:
    """A picture over the days of a month."""
    image = Image.new("RGBA", (width, height), "#fbfaf6")
    image.paste(painting("landscape", seed, width, int(height * 0.52)))
    draw = ImageDraw.Draw(image)
    top = height * 0.56
    labels.text(draw, "OCTOBER", (12, top, width - 12, top + 24), "bold", "#b8423a")
    w, h = (width - 24) / 7, (height * 0.97 - top - 28) / 5
    for day in range(31):
        x, y = 12 + (day + 2) % 7 * w, top + 28 + (day + 2) // 7 * h
        ink = "#b8423a" if (day + 2) % 7 == 6 else "#3a3a3a"
        labels.text(draw, str(day + 1), (x + 5, y + 4, x + w - 5, y + h - 4), "bold", ink)
    return image


def planets(width: int, height: int) -> Image.Image:
    """The sun and its planets on a night sky."""
    rng = np.random.default_rng(4)
    image = Image.new("RGBA", (width, height), "#1c2740")
    draw = ImageDraw.Draw(image)
    for _ in range(90):
        x, y = rng.uniform(0, width), rng.uniform(0, height)
        draw.ellipse((x, y, x + 2, y + 2), fill="#e9e6d8")
    draw.ellipse((-width * 0.4, -width * 0.4, width * 0.4, width * 0.4), fill="#f0b04a")
    tones = ["#b9a18a", "#e0a458", "#4f8ab0", "#c8553d", "#d9b98a", "#e8dcc6", "#7ab0b8", "#4a63a0"]
    sizes = [0.03, 0.05, 0.055, 0.04, 0.12, 0.1, 0.07, 0.065]
    for k, (tone, size) in enumerate(zip(tones, sizes, strict=True)):
        x, y, r = width * (0.3 + 0.45 * ((k * 5) % 8) / 8), height * (0.3 + 0.085 * k), size * width
        draw.ellipse((x - r, y - r, x + r, y + r), fill=tone)
    return image


def leaves(seed: int, width: int, height: int) -> Image.Image:
    """One branch with its leaves, as in a book of plants."""
    rng = np.random.default_rng(seed)
    image = Image.new("RGBA", (width, height), ["#f1ebe0", "#e8ece2"][seed % 2])
    draw = ImageDraw.Draw(image)
    tone, other = [("#4d7a45", "#6a9a5a"), ("#3f6f62", "#5a8f80"), ("#7d8a45", "#99a660")][seed % 3]
    x, low, high = width / 2, height * 0.92, height * 0.12
    draw.line((x, low, x, high), fill=tone, width=5)
    for k in range(9):
        y = low - (low - high) * (0.12 + 0.1 * k)
        long = width * (0.38 - 0.03 * k) * float(rng.uniform(0.9, 1.1))
        for side in (-1, 1):
            tip = (x + side * long, y - long * 0.6)
            middle = (x + side * long * 0.55, y - long * 0.1)
            upper = (x + side * long * 0.4, y - long * 0.52)
            draw.polygon([(x, y), middle, tip, upper], fill=tone if k % 2 else other)
    return image


def drawn(kind: str, seed: int, width: float, height: float) -> Image.Image:
    """A poster's print of the right shape."""
    wide, tall = 256, int(256 * height / width)
    if kind == "alphabet":
        return alphabet(wide, tall)
    if kind == "calendar":
        return calendar(seed, wide, tall)
    if kind == "planets":
        return planets(wide, tall)
    if kind == "leaves":
        return leaves(seed, wide, tall)
    return painting(kind, seed, wide, tall)


def poster(
    kind: str, seed: int, width: float, height: float, bars: str = "", offset: Offset = (0, 0, 0)
) -> Model:
    """A print without a frame; between two ``bars`` of wood, if one is named."""
    sheet = rounded_rectangle(width, height, 0.002, 2)
    margin = 0.0 if kind in ("calendar", "planets") else 0.02
    seen = rounded_rectangle(width - 2 * margin, height - 2 * margin, 0.001, 2)
    meshes = [pane(sheet, 0.0, 0.006, plain("#f6f4ee", 0.01, 20))]
    print_ = label(drawn(kind, seed, width - 2 * margin, height - 2 * margin))
    meshes.append(pane(seen, 0.001, 0.0075, print_, 3.0))
    if bars:
        wood = finish(bars, 1, offset)
        for z in (-height / 2 - 0.012, height / 2 - 0.012):
            meshes.append(box(0.014, width + 0.03, 0.024, (0.007, 0, z), wood, 0.003))
    wide, tall = width + (0.03 if bars else 0), height + (0.024 if bars else 0)
    piece = box_piece((0.006, 0, 0), (0.012, wide, tall))
    title = "wall calendar" if kind == "calendar" else f"poster, {kind}"
    return Model(title, {"body": Part(meshes, collision=[piece])}, mass=0.2)


def poster_random(rng: np.random.Generator) -> dict:
    return {
        "kind": pick(rng, ("landscape", "abstract", "flower")),
        "seed": seed_of(rng),
        "width": 0.5,
        "height": 0.7,
        "offset": noise_offset(rng),
    }


# ---- hooks with coats
def coat_hooks(
    width: float,
    wood: str,
    worn: tuple[tuple[str, ...], ...],
    metal: str = "#2c2d2f",
    shelf: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A board with a hook for each of `worn` (by garments_hung; none hangs on an empty one), with
    or without a shelf for hats over it."""
    asm, timber = Assembly(), finish(wood, 1, offset)
    iron = steel(30) if metal == "steel" else plain(metal, 0.03)
    low = 0.84
    asm.board("body", (0, -width / 2, low), (0.022, width / 2, low + 0.13), timber, 0.005)
    if shelf:
        top = low + 0.13
        asm.board("body", (0, -width / 2, top), (0.2, width / 2, top + 0.02), timber, 0.004)
        for y in (-width / 2 + 0.04, width / 2 - 0.04):
            brace = [(0.0, low + 0.02), (0.022, low + 0.02), (0.17, top), (0.0, top)]
            mesh = extrude(brace, 0.018, timber, axis="y").move(0, y, 0)
            asm.add("body", mesh)
    for k, what in enumerate(worn):
        y = (k + 0.5 - len(worn) / 2) * width / len(worn)
        asm.add("body", box(0.008, 0.03, 0.1, (0.026, y, low + 0.015), iron, 0.003))
        for z, out in ((low + 0.06, 0.1), (low + 0.03, 0.06)):
            hook = [(0.026, y, z), (out * 0.8, y, z - 0.008), (out, y, z + 0.03)]
            asm.add("body", tube(np.array(hook), 0.009, 6, mat=iron))
        knob = ellipsoid(0.015, (0.1, y, low + 0.096), 8, 5, iron)
        asm.add("body", knob)
        if what:
            hang(asm, what, (0.062, y, low + 0.025))
    kinds = dict.fromkeys(what[0] for what in worn if what)
    return Model("coat hooks with " + ", ".join(kinds), asm.parts(), mass=4.5)


def coat_hooks_random(rng: np.random.Generator) -> dict:
    worn = (("coat", "#8a3f35", "#6e322a"), (), ("jacket", "#3f5568", "#c9a24a"))
    return {"width": 0.9, "wood": "oak", "worn": worn}


# ---- toilet rolls
def roll(radius: float, offset: Offset) -> list[Mesh]:
    """A roll on its way down, its axis along Y through 0, and what hangs off its front."""
    paper, card = Material(), plain("#b08a5e", 0.08, 200)
    paper.colour(paper.mottle("#f5f3ee", 0.03, 120, offset))
    core, half = 0.021, 0.05
    profile = [(core, -half), (radius, -half), (radius, half), (core, half), (core, -half)]
    body = lathe(profile, 24, mats=[paper, card], mat_of_segment=[0, 0, 0, 1])
    hanging = box(0.002, 0.098, 0.1, (radius - 0.001, 0, -0.1), paper)
    return [body.turn(rx=math.pi / 2), hanging]


def toilet_roll_holder(kind: str, metal: str, radius: float, offset: Offset) -> Model:
    """A holder with its roll: on a bent "arm", or under a "lid"."""
    shine = steel(30) if metal == "steel" else plain(metal, 0.02)
    x, z = radius + 0.014, 0.13
    meshes = [m.move(x, 0, z) for m in roll(radius, offset)]
    pieces = [few_corners(meshes[0].v, 24)]
    if kind == "lid":
        meshes.append(box(0.006, 0.125, 0.07, (0.003, 0, z), shine, 0.002))
        lid = box(2 * radius + 0.01, 0.125, 0.004, (radius + 0.008, 0, z + radius + 0.004), shine)
        meshes.append(lid)
        bar = [(0.004, -0.058, z), (x, -0.058, z), (x, 0.058, z), (0.004, 0.058, z)]
        pieces.append(box_piece((x / 2, 0, z + radius + 0.006), (x, 0.125, 0.006)))
    else:
        meshes.append(box(0.008, 0.045, 0.045, (0.004, -0.075, z - 0.022), shine, 0.004))
        bar = [(0.004, -0.075, z), (x, -0.075, z), (x, 0.062, z)]
    meshes.append(tube(np.array(bar), 0.006, 6, mat=shine))
    model = {"body": Part([cube_project(m) for m in meshes], collision=pieces)}
    return Model("toilet roll on its holder", model, mass=0.4, texture_size=128)


def toilet_roll_holder_random(rng: np.random.Generator) -> dict:
    return {"kind": "arm", "metal": "steel", "radius": 0.055, "offset": noise_offset(rng)}


_LARGE = {"width": 0.5, "height": 0.7}
_SMALL = {"width": 0.4, "height": 0.5}

MODELS = {
    "poster": Maker(
        poster,
        poster_random,
        10,
        [
            {"kind": "abstract", "seed": 11, **_LARGE},
            {"kind": "leaves", "seed": 2, "bars": "oak", **_LARGE},
            {"kind": "leaves", "seed": 3, "bars": "oak", **_LARGE},
            {"kind": "landscape", "seed": 14, **_LARGE},
            {"kind": "abstract", "seed": 17, **_SMALL},
            {"kind": "flower", "seed": 15, **_SMALL},
            {"kind": "leaves", "seed": 4, **_SMALL},
            {"kind": "alphabet", "seed": 0, "bars": "walnut", **_LARGE},
            {"kind": "planets", "seed": 0, **_LARGE},
            {"kind": "calendar", "seed": 16, "width": 0.3, "height": 0.44},
        ],
    ),
    "coat_hooks": Maker(
        coat_hooks,
        coat_hooks_random,
        6,
        [
            {
                "width": 0.85,
                "wood": "oak",
                "worn": (("coat", "#8a3f35", "#6e322a"), (), ("tote", "#e6dfcf", "#3f5568")),
            },
            {
                "width": 1.1,
                "wood": "walnut",
                "metal": "#b08d4a",
                "shelf": True,
                "worn": (
                    ("coat", "#3a3f45", "#2a2e33"),
                    ("scarf", "#a08a5a", "#e6dfcf"),
                    ("jacket", "#5a6a4a", "#c98a3a"),
                    ("umbrella", "#2f3a52"),
                ),
            },
            {
                "width": 0.7,
                "wood": "#f0efec",
                "metal": "steel",
                "worn": (("jacket", "#2f3a52", "#c8403a"), ("bag", "#a3694f", "#6a4226")),
            },
            {
                "width": 1.0,
                "wood": "oak",
                "metal": "steel",
                "worn": (
                    ("jacket", "#c0a880", "#5a4632"),
                    ("hat", "#6a5a48"),
                    ("coat", "#5f6f52", "#4c5942"),
                ),
            },
            {
                "width": 0.62,
                "wood": "black",
                "metal": "#b08d4a",
                "worn": (("coat", "#8a5a6a", "#6e4855"), ("cap", "#d8b25a", "#f0ece0")),
            },
            {
                "width": 0.95,
                "wood": "#dfe3dc",
                "shelf": True,
                "worn": (
                    ("jacket", "#c9a03a", "#e8e4da"),
                    ("cap", "#3f5568", "#c8403a"),
                    ("coat", "#6b7a86", "#56636d"),
                ),
            },
        ],
    ),
    "toilet_roll_holder": Maker(
        toilet_roll_holder,
        toilet_roll_holder_random,
        4,
        [
            {},
            {"kind": "lid"},
            {"metal": "#2a2a2c", "radius": 0.05},
            {"kind": "lid", "metal": "#e8e6e0", "radius": 0.045},
        ],
    ),
}
