"""Pasta and flour."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.shapes import TAU, box, lathe, tube

from makers import frozen
from makers.pack_parts import (
    by_style,
    carton,
    carton_piece,
    lump,
    print_on,
    puddle,
    standing_bag,
)
from makers.projection import project_label

PASTA_TONE = "#ecc262"


def pasta_front(w: int, h: int, kind: str, ground: str, band: str, brand: str):
    """The word on top, a window below."""
    image, d = labels.canvas(w, h, ground)
    if w > 1.35 * h:
        groceries.pasta_window(
            d, (w * 0.5, h * 0.1, w * 0.97, h * 0.9), kind, np.random.default_rng(3)
        )
        d.rectangle((0, h * 0.3, w * 0.48, h * 0.74), fill=band)
        labels.text(d, "PASTA", (w * 0.02, h * 0.34, w * 0.46, h * 0.7))
        labels.text(d, brand, (w * 0.06, h * 0.06, w * 0.42, h * 0.26), "italic", band)
        labels.text(d, kind.upper(), (w * 0.04, h * 0.78, w * 0.46, h * 0.94), "bold", band)
        return image
    labels.text(d, brand, (w * 0.15, h * 0.04, w * 0.85, h * 0.12), "italic", band)
    d.rectangle((0, h * 0.13, w, h * 0.36), fill=band)
    labels.text(d, "PASTA", (w * 0.05, h * 0.15, w * 0.95, h * 0.345))
    labels.text(d, kind.upper(), (w * 0.06, h * 0.37, w * 0.94, h * 0.45), "bold", band)
    groceries.pasta_window(
        d, (w * 0.08, h * 0.47, w * 0.92, h * 0.92), kind, np.random.default_rng(3)
    )
    return image


def pasta_bag(
    kind: str, ground: str, band: str, brand: str, width: float, depth: float, h: float
) -> Model:
    """A standing bag with a window."""
    bag = standing_bag(width, depth, h, plain(band, 0.06, 60), "seal", 0.1, 0.03, 6)
    print_on(bag, pasta_front(300, int(300 * h / width), kind, ground, band, brand), width, h, 0.2)
    return Model(
        title=f"bag of {kind} pasta",
        parts={"body": Part([bag.weigh(1.2)], collision="hull")},
        mass=0.52,
        friction=0.55,
    )


def pasta_box(
    kind: str, ground: str, band: str, brand: str, depth: float, width: float, h: float
) -> Model:
    """A cardboard box with a window."""
    front = pasta_front(300, int(300 * h / width), kind, ground, band, brand)
    side, d = labels.canvas(120, max(120, int(120 * h / depth)), band)
    height = side.size[1]
    labels.text(d, "PASTA", (8, height * 0.1, 112, height * 0.4))
    labels.small_print(d, (18, height * 0.5, 102, height * 0.9), 6, "#ffffff")
    body = carton(depth, width, h, front, side, None, ground)
    return Model(
        title=f"box of {kind}",
        parts={"body": Part([body.weigh(1.2)], collision=[carton_piece(depth, width, h)])},
        mass=0.53,
        friction=0.5,
    )


def strands(length: float, radius: float, form: int) -> list[Mesh]:
    """A bundle of spaghetti along y, its ends uneven."""
    m = Material(occlusion=0.7)
    streak = m.noise(10, 2, stretch=(60, 1.0, 60))
    m.colour(m.ramp(streak, [(0.35, "#b9852c"), (0.48, PASTA_TONE), (0.6, "#fbe49a")]))
    n = 20
    t = np.arange(n) * TAU / n
    ridge = 1 - 0.09 * (np.arange(n) % 2)
    rings = [
        np.c_[radius * ridge * np.cos(t), np.full(n, y), 0.62 * radius * (1 + ridge * np.sin(t))]
        for y in np.linspace(-length / 2, length / 2, 3)
    ]
    from toolkit.shapes import loft

    bundle = loft(rings, mat=m)
    rng = np.random.default_rng(form)
    meshes = [bundle]
    for k in range(9):
        a, q = k * 2.4, radius * 0.75 * math.sqrt((k + 0.5) / 9)
        y = length / 2 + rng.uniform(0.004, 0.03)
        x, z = q * math.cos(a), 0.62 * (radius + q * math.sin(a))
        meshes.append(tube([(x, 0, z), (x, y, z)], 0.0026, 4, mat=m, weight=0.5))
    return meshes


def spaghetti_pack(ground: str, band: str, brand: str, opened: bool) -> Model:
    """A long clear pack lying down; opened, the strands slide out of it."""
    length, r = 0.27, 0.03
    from toolkit.shapes import loft

    n = 20
    t = np.arange(n) * TAU / n
    rings = []
    ends = [
        (-0.5, 1.0, 0.05),
        (-0.465, 1.02, 0.08),
        (-0.44, 1.0, 0.9),
        (-0.2, 1, 1),
        (0.2, 1, 1),
        (0.44, 1.0, 0.9),
    ]
    ends += [(0.465, 1.02, 0.08), (0.5, 1.0, 0.05)] if not opened else []
    for y, w, d in ends:
        rings.append(
            np.c_[r * w * 1.15 * np.cos(t), np.full(n, y * length), 0.021 * (1 + d * np.sin(t))]
        )
    clear = Material(occlusion=0.7)
    streak = clear.noise(10, 2, stretch=(60, 1.0, 60))
    tone = clear.ramp(streak, [(0.35, "#c8963a"), (0.5, "#f0cf74"), (0.62, "#fdeeb4")])
    gloss = clear.remap(clear.noise(20, 1, stretch=(1, 0.4, 1)), 0.6, 0.66, 0, 0.5)
    clear.colour(clear.mix(gloss, tone, "ffffff"))
    pack = loft(rings, mat=clear)
    pack.bake_uv = None
    image, d = labels.canvas(420, 200, band)
    labels.text(d, brand, (120, 8, 300, 46), "italic", "#ffe9b0")
    labels.text(d, "SPAGHETTI", (14, 48, 406, 128))
    labels.text(d, "PASTA", (120, 132, 300, 190), "bold", ground)
    # the band lies along the pack, to be read from the front
    project_label(
        pack,
        label(image),
        "+z",
        (0, 0),
        (0.118, 2.2 * r),
        0.15,
        lambda c: abs(c[1]) < 0.2 * length + 0.001,
    )
    meshes = [pack.weigh(1.2)]
    solid = box_piece((0, 0, 0.02), (2 * r, length, 0.04))
    if opened:
        meshes += [mesh.move(0, 0.075, 0.004) for mesh in strands(0.2, 0.026, 4)]
        solid = box_piece((0, 0.02, 0.02), (2 * r, length + 0.03, 0.04))
    return Model(
        title="opened pack of spaghetti" if opened else "pack of spaghetti",
        parts={"body": Part(meshes, collision=[solid])},
        mass=0.5,
        friction=0.5,
    )


def pasta_jar_bag(kind: str, ground: str, band: str, brand: str) -> Model:
    """A lying pillow bag, lumpy with what is in it."""
    length, width, height = 0.24, 0.17, 0.06
    bag = frozen.pillow(length, width, height, plain(band, 0.05), np.random.default_rng(9))
    project_label(
        bag,
        label(pasta_front(300, 420, kind, ground, band, brand)),
        "+z",
        (0, 0),
        (width, 0.86 * length),
        0.1,
    )
    return Model(
        title=f"bag of {kind} pasta",
        parts={"body": Part([bag.weigh(1.3)], collision="hull")},
        mass=0.52,
        friction=0.6,
    )


def flour_bag(
    brand: str,
    ground: str,
    band: str,
    width: float,
    depth: float,
    h: float,
    top: str = "block",
    spilled: bool = False,
    word: str = "FLOUR",
) -> Model:
    """A paper block bag; an opened one shows the flour."""
    white = plain("#fdfbf4", 0.03, 60)
    paper = plain(ground, 0.04, 60)
    bag = standing_bag(width, depth, h, paper, top, 0.05, 0.025, 3)
    front = groceries.face(
        300, int(300 * h / width), ground, band, word, brand, groceries.wheat, "1 kg"
    )
    print_on(bag, front, width, h, 0.25)
    side, d = labels.canvas(200, int(200 * h / depth), ground)
    tall = side.size[1]
    d.rectangle((0, tall * 0.17, 200, tall * 0.47), fill=band)
    labels.text(d, word, (14, tall * 0.22, 186, tall * 0.42))
    labels.small_print(d, (30, tall * 0.55, 170, tall * 0.8), 6, "#8a8a80")
    for s in ("+y", "-y"):
        project_label(bag, label(side), s, (0, h / 2), (depth, h), 0.6)
    meshes = [bag.weigh(1.2)]
    if top == "block":
        for k, x in enumerate((-0.2, 0.22)):
            meshes.append(
                box(
                    depth * 0.34,
                    width * 0.8,
                    0.005,
                    (x * depth, 0, h - 0.002 + 0.001 * k),
                    paper,
                    0.001,
                )
            )
    if top == "open":
        heap = lathe(
            [(0, 0.84 * h), (0.45 * depth, 0.84 * h), (0.3 * depth, 0.9 * h), (0, 0.95 * h)],
            14,
            mat=white,
        )
        heap.scale(1, width / depth, 1)
        meshes.append(heap)
    solids = [carton_piece(depth, width, h)]
    if spilled:
        pool = puddle(0.06, "#fbf8ee", 4, 0.006).move(depth / 2 + 0.045, 0.03)
        mound = lathe(
            [(0, 0), (0.045, 0), (0.022, 0.014), (0, 0.02)],
            12,
            mat=white,
            rib=lambda k, i: 1 + 0.08 * (i % 2),
        )
        meshes += [pool, mound.move(depth / 2 + 0.04, 0.03, 0.003)]
        solids.append(box_piece((depth / 2 + 0.045, 0.03, 0.004), (0.1, 0.1, 0.008)))
    return Model(
        title=f"bag of {word.lower()}",
        parts={"body": Part(meshes, collision=solids)},
        mass=round(depth * width * h * 620, 2),
        friction=0.6,
    )


def flour_rolled(brand: str, ground: str, band: str) -> Model:
    """A begun bag, its head rolled down and clipped with a peg."""
    width, depth, h = 0.105, 0.07, 0.125
    paper = plain(ground, 0.05, 60)
    bag = standing_bag(width, depth, h, paper, "seal", 0.06, 0.05, 8)
    front = groceries.face(
        300, int(300 * h / width), ground, band, "FLOUR", brand, groceries.wheat, "1 kg"
    )
    print_on(bag, front, width, h * 1.02, 0.2)
    roll = tube([(0, y, h + 0.004) for y in (-0.5 * width, 0, 0.5 * width)], 0.012, 8, mat=paper)
    peg = [
        box(0.007, 0.013, 0.06, (s * 0.013, 0.014, h - 0.022), plain("#c89a5a", 0.1), 0.001).turn(
            ry=s * 0.12, pivot=(0, 0.014, h)
        )
        for s in (-1, 1)
    ]
    return Model(
        title="bag of flour, rolled shut",
        parts={"body": Part([bag.weigh(1.2), roll, *peg], collision="hull")},
        mass=0.6,
        friction=0.6,
    )


def flour_sack(brand: str, ground: str, band: str) -> Model:
    """A fat five-kilo sack with a sewn head."""
    width, depth, h = 0.2, 0.12, 0.3
    bag = standing_bag(width, depth, h, plain(ground, 0.06, 90), "seal", 0.16, 0.045, 5)
    front = groceries.face(
        300, int(300 * h / width), ground, band, "FLOUR", brand, groceries.wheat, "5 kg"
    )
    print_on(bag, front, width, h, 0.2)
    seam = tube(
        [(0, y * width, 0.955 * h) for y in (-0.5, 0, 0.5)], 0.004, 5, mat=plain(band, 0.05)
    )
    ears = [
        lump((0.014, 0.02, 0.02), (0, s * width * 0.46, h * 0.93), plain(ground, 0.06), 2, 8, 5)
        for s in (-1, 1)
    ]
    return Model(
        title="sack of flour",
        parts={"body": Part([bag.weigh(1.2), seam, *ears], collision="hull")},
        mass=5.0,
        friction=0.6,
    )


BLUE = {"ground": "#eef4fb", "band": "#1f4f9c"}
#: Blue and white, a bag of flour was a carton of milk.
OCHRE = {"ground": "#f0dcae", "band": "#c9781a"}

RED = {"ground": "#fdf2e0", "band": "#b8242c"}

GREEN = {"ground": "#f4f8e8", "band": "#1f6a34"}

ORANGE = {"ground": "#d9622b", "band": "#5a1f14"}

MODELS = {
    "pasta_pack": Maker(
        by_style(
            "pasta_pack",
            {
                "bag": pasta_bag,
                "box": pasta_box,
                "spaghetti": spaghetti_pack,
                "pillow": pasta_jar_bag,
            },
        ),
        lambda rng: {},
        count=7,
        presets=[
            {
                "style": "bag",
                "kind": "penne",
                **BLUE,
                "brand": "Bellini",
                "width": 0.15,
                "depth": 0.075,
                "h": 0.23,
            },
            {"style": "spaghetti", **BLUE, "brand": "Bellini", "opened": False},
            {
                "style": "box",
                "kind": "farfalle",
                **BLUE,
                "brand": "Bellini",
                "depth": 0.055,
                "width": 0.13,
                "h": 0.18,
            },
            {"style": "spaghetti", **GREEN, "brand": "Da Nino", "opened": True},
            # White, it was taken for butter in its wrapper.
            {"style": "pillow", "kind": "fusilli", **ORANGE, "brand": "Verdelli"},
            {
                "style": "bag",
                "kind": "fusilli",
                **RED,
                "brand": "Rustica",
                "width": 0.15,
                "depth": 0.075,
                "h": 0.23,
            },
            {
                "style": "box",
                "kind": "spaghetti",
                **RED,
                "brand": "Rustica",
                "depth": 0.032,
                "width": 0.075,
                "h": 0.28,
            },
        ],
    ),
    "flour_bag": Maker(
        by_style("flour_bag", {"bag": flour_bag, "rolled": flour_rolled, "sack": flour_sack}),
        lambda rng: {},
        count=7,
        presets=[
            {
                "style": "bag",
                "brand": "Mühlhof",
                **OCHRE,
                "width": 0.105,
                "depth": 0.07,
                "h": 0.175,
            },
            {"style": "bag", "brand": "Kornhof", **RED, "width": 0.105, "depth": 0.07, "h": 0.175},
            {
                "style": "bag",
                "brand": "Mühlhof",
                "ground": "#d8b98a",
                "band": "#5a3a1c",
                "width": 0.13,
                "depth": 0.095,
                "h": 0.25,
            },
            {"style": "rolled", "brand": "Kornhof", **RED},
            {
                "style": "bag",
                "brand": "Mühlhof",
                **OCHRE,
                "width": 0.11,
                "depth": 0.075,
                "h": 0.185,
                "top": "open",
                "spilled": True,
            },
            {"style": "sack", "brand": "Kornhof", "ground": "#efe2c6", "band": "#1f6a34"},
            {"style": "rolled", "brand": "Mühlhof", **OCHRE},
        ],
    ),
}
