"""Frozen vegetables and fish sticks."""

from __future__ import annotations

import math

import numpy as np
from labels import foods, groceries
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.shapes import box, ellipsoid, tube

from makers import frozen
from makers.pack_parts import (
    by_style,
    carton,
    carton_piece,
    flap,
    print_on,
    standing_bag,
)
from makers.projection import project_label


def frosted(picture, share: float = 0.5) -> Material:
    """A print under a bloom of frost at its edges."""
    m = Material()
    rime = m.remap(m.noise(45, 4), 0.56, 0.72, 0, share)
    return m.colour(m.mix(rime, m.image(picture), "eef7ff"))


def frozen_face(w: int, h: int, ground: str, band: str, word: str, brand: str, motif, sub="FROZEN"):
    """A package front with the word FROZEN and a snowflake."""
    image = groceries.face(w, h, ground, band, word, brand, motif, sub, "#ffffff")
    from PIL import ImageDraw

    d = ImageDraw.Draw(image)
    wide = w > 1.35 * h
    r = (h * 0.09) if wide else w * 0.09
    x, y = (w * 0.6, h * 0.14) if wide else (w * 0.88, h * 0.1)
    d.ellipse((x - 1.3 * r, y - 1.3 * r, x + 1.3 * r, y + 1.3 * r), fill="#1f6fc4")
    foods.snowflake(d, x, y, r)
    return image


VEG = {  # kind: (word, ground, band, motif)
    "peas": ("PEAS", "#dff2ff", "#2f8a3a", "peas"),
    "broccoli": ("BROCCOLI", "#dff2ff", "#1f6a34", "broccoli"),
    "carrots": ("CARROTS", "#dff2ff", "#d8660e", "peas"),
    "mixed": ("MIXED\nVEGETABLES", "#dff2ff", "#1f5fb8", "broccoli"),
}


def veg_pouch(kind: str, brand: str, width: float, depth: float, height: float, top: str) -> Model:
    """A stand-up bag, sealed, or rolled down and clipped."""
    word, ground, band, motif = VEG[kind]
    art = frosted(
        frozen_face(
            300, int(300 * height / width), ground, band, word, brand, getattr(groceries, motif)
        ),
        0.35,
    )
    bag = standing_bag(width, depth, height, plain(band, 0.08, 60), top, 0.12, 0.05, 4)
    print_on(bag, art, width, height, 0.2)
    meshes = [bag.weigh(1.2)]
    if top == "open" and kind == "peas":
        green = plain("#6fb23c", 0.2, 200)
        for k in range(13):
            a, q = k * 2.4, math.sqrt(k / 13) * 0.38
            spot = (depth * q * math.cos(a), width * q * math.sin(a), height * 0.9)
            meshes.append(ellipsoid((0.0065,) * 3, spot, 6, 4, green))
    return Model(
        title=f"bag of frozen {word.lower()}".replace("\n", " "),
        parts={"body": Part(meshes, collision="hull")},
        mass=0.5,
        friction=0.6,
    )


def veg_clipped(kind: str, brand: str) -> Model:
    """A bag begun: half empty, its head rolled and held by a clip."""
    word, ground, band, motif = VEG[kind]
    length, width, height = 0.17, 0.18, 0.06
    bag = frozen.pillow(length, width, height, plain(band, 0.05), np.random.default_rng(5))
    art = frosted(frozen_face(320, 300, ground, band, word, brand, getattr(groceries, motif)), 0.35)
    project_label(bag, art, "+z", (0, 0), (width, 0.86 * length), 0.1)
    roll = tube(
        [(-length / 2 + 0.004, s * width * 0.47, 0.014) for s in (-1, 0, 1)],
        0.013,
        8,
        mat=plain(band, 0.06),
    )
    clip = [
        box(0.03, 0.075, 0.006, (-length / 2 + 0.004, 0.02, 0.026), plain("#f2c21c", 0.03), 0.002),
        box(0.03, 0.075, 0.005, (-length / 2 + 0.004, 0.02, 0.0), plain("#f2c21c", 0.03), 0.002),
    ]
    return Model(
        title=f"clipped bag of frozen {word.lower()}".replace("\n", " "),
        parts={"body": Part([bag.weigh(1.3), roll, *clip], collision="hull")},
        mass=0.35,
        friction=0.6,
    )


def veg_box(kind: str, brand: str, depth: float, width: float, h: float) -> Model:
    """A standing box."""
    word, ground, band, motif = VEG[kind]
    front = frozen_face(
        300, int(300 * h / width), ground, band, word, brand, getattr(groceries, motif)
    )
    side, d = labels.canvas(120, 300, band)
    foods.snowflake(d, 60, 70, 40)
    body = carton(depth, width, h, frosted_picture(front), side, None, band)
    return Model(
        title=f"box of frozen {word.lower()}",
        parts={"body": Part([body.weigh(1.2)], collision=[carton_piece(depth, width, h)])},
        mass=0.45,
        friction=0.5,
    )


def frosted_picture(image):
    """Frost drawn into the picture itself."""
    rng = np.random.default_rng(6)
    layer, d = labels.canvas(*image.size)
    w, h = image.size
    for _ in range(220):
        x, y = rng.uniform(0, w), h * rng.beta(0.5, 0.5)
        r = rng.uniform(1, 4)
        d.ellipse((x - r, y - r, x + r, y + r), fill=(240, 248, 255, 150))
    image.alpha_composite(layer)
    return image


def crumbed() -> Material:
    m = Material(occlusion=0.8)
    c = m.mottle("#e0902e", 0.18, 120)
    c = m.mix(m.remap(m.voronoi(420), 0.1, 0.2, 0.7, 0), c, "f8cc74")
    return m.colour(m.mix(m.remap(m.noise(160, 2), 0.62, 0.7, 0, 0.5), c, "eef6ff"))


def stick(mat: Material) -> Mesh:
    return box(0.024, 0.085, 0.015, (0, 0, 0), mat, 0.003)


def fish_box(
    depth: float, width: float, h: float, count: str, brand: str, ground: str, band: str, flat: bool
) -> Model:
    """A printed box, standing or lying."""
    word = "FISH\nSTICKS"
    edge = frozen_face(
        420,
        max(60, int(420 * (h if flat else depth) / width)),
        band,
        band,
        "FISH STICKS",
        "",
        None,
        "",
    )
    if flat:
        top = frozen_face(
            420,
            int(420 * depth / width),
            ground,
            band,
            word,
            brand,
            groceries.fish_fingers,
            f"FROZEN  {count}",
        )
        body = carton(depth, width, h, edge, edge, frosted_picture(top), band)
    else:
        front = frozen_face(
            360,
            int(360 * h / width),
            ground,
            band,
            word,
            brand,
            groceries.fish_fingers,
            f"FROZEN  {count}",
        )
        side, d = labels.canvas(120, 300, band)
        foods.fish(d, 60, 150, 46, "#bfe4ff")
        foods.snowflake(d, 60, 60, 34)
        body = carton(depth, width, h, frosted_picture(front), side, edge, band)
    return Model(
        title="box of frozen fish sticks",
        parts={"body": Part([body.weigh(1.2)], collision=[carton_piece(depth, width, h)])},
        mass=round(depth * width * h * 430, 2),
        friction=0.5,
    )


def fish_open(brand: str, ground: str, band: str) -> Model:
    """The box lies opened at one end, sticks sliding out."""
    depth, width, h, t = 0.125, 0.2, 0.05, 0.005
    top = label(
        frosted_picture(
            frozen_face(420, 262, ground, band, "FISH\nSTICKS", brand, groceries.fish_fingers)
        )
    )
    edge = label(frozen_face(420, 105, band, band, "FISH STICKS", "", None, ""))
    board, inside = plain(band, 0.03), plain("#d8d2c4", 0.05)
    meshes = [
        box(depth, width, t, (0, 0, h - t), board, 0.001, 1, {"+z": top}).weigh(1.3),
        box(depth, width, t, (0, 0, 0), inside),
    ]
    meshes += [box(depth, t, h - 2 * t, (0, s * (width - t) / 2, t), board) for s in (-1, 1)]
    meshes.append(box(t, width, h - 2 * t, (-(depth - t) / 2, 0, t), board, 0, 1, {"-x": edge}))
    meshes.append(flap(width - 0.008, 0.026, 0.026, 0.005, board).move(depth / 2 - 0.002, 0, h - t))
    meshes.append(flap(width - 0.008, 0.03, 0.001, 0.004, board).move(depth / 2 - 0.004, 0, 0.002))
    crumbs = crumbed()
    spots = [
        (0.058, -0.06, 0.006, 1.5),
        (0.066, 0.0, 0.006, 1.62),
        (0.06, 0.055, 0.006, 1.5),
        (0.05, -0.03, 0.0215, 1.7),
        (0.056, 0.04, 0.0215, 1.45),
        (0.14, -0.05, 0.0, 0.5),
        (0.15, 0.045, 0.0, -0.4),
    ]
    meshes += [stick(crumbs).turn(rz=a).move(x, y, z) for x, y, z, a in spots]
    solids = [
        box_piece((0, 0, h / 2), (depth, width, h)),
        box_piece((0.14, 0, 0.008), (0.07, 0.17, 0.015)),
    ]
    return Model(
        title="opened box of frozen fish sticks",
        parts={"body": Part(meshes, collision=solids)},
        mass=0.35,
        friction=0.5,
    )


def fish_bag(brand: str, ground: str, band: str) -> Model:
    """A family bag lying flat."""
    length, width, height = 0.27, 0.2, 0.058
    bag = frozen.pillow(length, width, height, plain(band, 0.05), np.random.default_rng(7))
    art = frosted(
        frozen_face(300, 400, ground, band, "FISH\nSTICKS", brand, groceries.fish_fingers), 0.3
    )
    project_label(bag, art, "+z", (0, 0), (width, 0.86 * length), 0.1)
    return Model(
        title="bag of frozen fish sticks",
        parts={"body": Part([bag.weigh(1.3)], collision="hull")},
        mass=0.75,
        friction=0.6,
    )


SEA = {"ground": "#e6f3ff", "band": "#14509c"}

RED = {"ground": "#eaf6ff", "band": "#c8242c"}

MODELS = {
    "frozen_vegetables": Maker(
        by_style(
            "frozen_vegetables",
            {
                "old": frozen.frozen_vegetables,
                "pouch": veg_pouch,
                "clip": veg_clipped,
                "box": veg_box,
            },
        ),
        frozen.frozen_vegetables_random,
        count=7,
        presets=[
            {"style": "old", "kind": "peas", "seed": 3, "height": 0.05},
            {"style": "old", "kind": "mixed", "seed": 3, "height": 0.05},
            {"style": "old", "kind": "spinach", "length": 0.15, "width": 0.13, "height": 0.042},
            {
                "style": "pouch",
                "kind": "broccoli",
                "brand": "Verde",
                "width": 0.18,
                "depth": 0.075,
                "height": 0.24,
                "top": "seal",
            },
            {
                "style": "pouch",
                "kind": "peas",
                "brand": "Kaltfeld",
                "width": 0.15,
                "depth": 0.075,
                "height": 0.16,
                "top": "open",
            },
            {"style": "clip", "kind": "mixed", "brand": "Hofgut"},
            {
                "style": "pouch",
                "kind": "mixed",
                "brand": "Kaltfeld",
                "width": 0.18,
                "depth": 0.075,
                "height": 0.24,
                "top": "seal",
            },
        ],
    ),
    "fish_sticks": Maker(
        by_style("fish_sticks", {"box": fish_box, "open": fish_open, "bag": fish_bag}),
        lambda rng: {},
        count=6,
        presets=[
            {
                "style": "box",
                "depth": 0.135,
                "width": 0.2,
                "h": 0.035,
                "count": "10",
                "brand": "Nordhav",
                **SEA,
                "flat": True,
            },
            {
                "style": "box",
                "depth": 0.07,
                "width": 0.2,
                "h": 0.155,
                "count": "20",
                "brand": "Fjordal",
                **SEA,
                "flat": False,
            },
            {"style": "open", "brand": "Nordhav", **SEA},
            {"style": "bag", "brand": "Marisol", **SEA},
            {
                "style": "box",
                "depth": 0.135,
                "width": 0.2,
                "h": 0.035,
                "count": "10",
                "brand": "Marisol",
                **RED,
                "flat": True,
            },
            {
                "style": "box",
                "depth": 0.16,
                "width": 0.28,
                "h": 0.06,
                "count": "30",
                "brand": "Kapitan",
                **RED,
                "flat": True,
            },
        ],
    ),
}
