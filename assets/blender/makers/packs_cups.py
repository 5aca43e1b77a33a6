"""Yogurt: cups, packs of four, pails and jars."""

from __future__ import annotations

import math

import numpy as np
from labels import foods, groceries
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import box, lathe, loft, tube

from makers import chilled, food_trays
from makers.bottle_shapes import cap
from makers.convex import few_corners
from makers.pack_parts import by_style, tub_ring, vessel
from makers.projection import project_label

YOGURTS = {  # flavour: (ground, band, motif)
    "STRAWBERRY": ("#fff4f2", "#d8283a", "strawberry"),
    "BLUEBERRY": ("#f4f4fb", "#4a4fa8", "blueberry"),
    "PLAIN": ("#fbfbf8", "#2a6fc4", "grass_cow"),
    "CHERRY": ("#fff2f0", "#a81430", "cherry"),
    "APRICOT": ("#fff8ea", "#e07a10", "apricot"),
    "LEMON": ("#fdfbe4", "#d8b400", "lemon"),
}

CREAMY = "#fbf3ea"


def yogurt_face(w: int, h: int, word: str, flavour: str, brand: str):
    ground, band, motif = YOGURTS[flavour]
    return groceries.face(w, h, ground, band, word, brand, getattr(groceries, motif), flavour)


def squarish_cup(
    side: float, height: float, mat: Material, art, foil: Material, top_art=None
) -> list[Mesh]:
    """One cup of a pack: tapered, round-cornered, a sealed foil on top."""
    rings = [
        tub_ring(side, side, 0.014, z, k, 3)
        for z, k in ((0, 0.011), (0.003, 0.009), (height - 0.004, 0.003))
    ]
    body = loft(rings, mat=mat)
    body.bake_uv = None
    for s in ("+x", "-x", "+y", "-y"):
        project_label(body, art, s, (0, height / 2), (side * 0.86, height), 0.7)
    lid = box(side, side, 0.003, (0, 0, height - 0.004), foil, 0.0008)
    if top_art is not None:
        project_label(lid, top_art, "+z", (0, 0), (side, side), 0.9)
    return [body, lid]


def cup_pack(
    word: str,
    flavour: str,
    brand: str,
    rows: int,
    columns: int,
    side: float,
    height: float,
    pudding: str = "",
) -> Model:
    """Cups that hang together at their rims."""
    if pudding:
        tone, light, ground, ink = chilled.PUDDINGS[pudding]
        art, d = labels.canvas(220, 240, ground)
        labels.text(d, word, (12, 20, 208, 90), "bold", ink)
        foods.swirl(d, 110, 160, 80, tone, light)
        labels.text(d, pudding, (20, 204, 200, 236), "bold", ink)
        lid, d = labels.canvas(220, 220, ground)
        labels.text(d, word, (12, 26, 208, 96), "bold", ink)
        foods.swirl(d, 110, 160, 74, tone, light)
        cup_colour = ground
    else:
        art = yogurt_face(220, 240, word, flavour, brand)
        lid = yogurt_face(220, 220, word, flavour, brand)
        cup_colour = YOGURTS[flavour][0]
    art, lid = label(art), label(lid)
    plastic, foil = plain(cup_colour, 0.02), metal("e2e5e8", "aeb4ba")
    meshes, solids = [], []
    for i in range(rows):
        for j in range(columns):
            x, y = (i - (rows - 1) / 2) * side, (j - (columns - 1) / 2) * side
            for mesh in squarish_cup(side, height, plastic, art, foil, lid):
                meshes.append(mesh.move(x, y))
            solids.append(box_piece((x, y, height / 2), (side - 0.004, side - 0.004, height)))
    kind = f"{pudding.lower()} pudding" if pudding else f"{flavour.lower()} yogurt"
    return Model(
        title=f"pack of {rows * columns} cups of {kind}",
        parts={"body": Part(meshes, collision=solids)},
        mass=0.13 * rows * columns,
        friction=0.5,
    )


def pail(
    word: str, flavour: str, brand: str, radius: float, height: float, lid: str, handle: bool
) -> Model:
    """A large pot with a snap-on lid, for half a kilo and more."""
    r, h = radius, height
    art = label(
        groceries.wrapped(
            3,
            300,
            int(300 * 3 * h / (math.tau * r)),
            *YOGURTS[flavour][:2],
            word,
            brand,
            getattr(groceries, YOGURTS[flavour][2]),
            flavour,
        )
    )
    z = h - 0.012
    body = vessel(
        [
            (0, 0.84 * r, 0.84 * r, 2.0),
            (0.003, 0.86 * r, 0.86 * r, 2.0),
            (z, 0.98 * r, 0.98 * r, 2.0),
        ],
        [plain(YOGURTS[flavour][0], 0.02), art],
        [0, 1],
        22,
    )
    top = lathe(
        [
            (0, z - 0.003),
            (1.04 * r, z - 0.003),
            (1.04 * r, h - 0.003),
            (1.0 * r, h),
            (0.9 * r, h),
            (0.88 * r, h - 0.003),
            (0, h - 0.003),
        ],
        22,
        mat=plain(lid, 0.02),
    )
    disc = groceries.face(
        256,
        256,
        *YOGURTS[flavour][:2],
        word,
        brand,
        getattr(groceries, YOGURTS[flavour][2]),
        flavour,
    )
    project_label(
        top,
        label(disc),
        "+z",
        (0, 0),
        (1.8 * r, 1.8 * r),
        0.95,
        lambda c: math.hypot(c[0], c[1]) < 0.7 * r,
    )
    meshes = [body.weigh(1.2), top]
    if handle:
        path = [
            (0, 1.06 * r * math.cos(a), h - 0.01 - 0.5 * h * math.sin(a))
            for a in np.linspace(0, math.pi, 9)
        ]
        meshes.append(
            tube(
                [(1.05 * r + 0.002 if 0 < k < 8 else 0, y, z) for k, (_, y, z) in enumerate(path)],
                0.0025,
                5,
                mat=plain("#f4f4f0", 0.02),
            )
        )
    return Model(
        title=f"large pot of {flavour.lower()} yogurt",
        parts={"body": Part(meshes, collision=[cylinder_piece(0.86 * r, 0, h, 14, 1.04 * r)])},
        mass=0.55 if h < 0.115 else 1.05,
        friction=0.5,
    )


def twin_cup(word: str, flavour: str, brand: str) -> Model:
    """Yogurt with a second chamber of fruit, opened: the foil is folded back."""
    ground, band, motif = YOGURTS[flavour]
    depth, width, h = 0.092, 0.098, 0.05
    plastic = plain(ground, 0.02)
    rings = [
        tub_ring(depth, width, 0.018, z, k, 4)
        for z, k in ((0, 0.016), (0.003, 0.013), (h - 0.004, 0.004), (h - 0.003, 0.0), (h, 0.0))
    ]
    body = loft(rings, mat=plastic)
    body.bake_uv = None
    art = label(
        groceries.face(300, 150, ground, band, word, brand, getattr(groceries, motif), flavour)
    )
    for s, span in (("+x", width), ("-x", width), ("+y", depth), ("-y", depth)):
        project_label(body, art, s, (0, h / 2), (span * 0.84, h * 0.96), 0.7)
    cream = Material(occlusion=0.6)
    wave = cream.math("SINE", cream.math("MULTIPLY", cream.distance((0, -0.016, 0)), 700.0))
    cream.colour(cream.mix(cream.remap(wave, -0.4, 0.9, 0, 0.5), CREAMY, "e2d6c8"))
    fruit = plain(band, 0.4, 220)
    white = loft(
        [tub_ring(0.078, 0.052, 0.016, z, 0, 4) for z in (h - 0.0005, h + 0.0008)], mat=cream
    ).move(0, -0.017)
    jam = loft(
        [tub_ring(0.078, 0.026, 0.01, z, 0, 4) for z in (h - 0.0005, h + 0.0008)], mat=fruit
    ).move(0, 0.029)
    foil_art = label(
        groceries.face(300, 280, ground, band, word, brand, getattr(groceries, motif), flavour)
    )
    foil = box(0.09, width - 0.004, 0.003, (0, 0, 0), metal("e2e5e8", "aeb4ba"), 0.0008)
    project_label(foil, foil_art, "-z", (0, 0), (width, 0.09), 0.9)
    foil.move(0.045).turn(ry=-1.9).move(-depth / 2 + 0.001, 0, h)
    for mesh in (white, jam):
        mesh.bake_uv = None
    return Model(
        title=f"opened yogurt with {flavour.lower()} corner",
        parts={
            "body": Part(
                [body.weigh(1.2), white, jam, foil],
                collision=[
                    box_piece((0, 0, h / 2), (depth - 0.01, width - 0.01, h)),
                    few_corners(foil.v),
                ],
            )
        },
        mass=0.16,
        friction=0.5,
    )


def drink_yogurt(word: str, flavour: str, brand: str, height: float, radius: float) -> Model:
    """A small waisted bottle to drink from, with a foil cap."""
    ground, band, motif = YOGURTS[flavour]
    h, r = height, radius
    art = label(
        groceries.wrapped(
            3, 200, 256, ground, band, word, brand, getattr(groceries, motif), flavour
        )
    )
    steps = [
        (0, 0.88),
        (0.02, 1),
        (0.06, 1),
        (0.6, 1),
        (0.68, 0.86),
        (0.76, 0.8),
        (0.86, 0.86),
        (0.9, 0.72),
        (0.97, 0.72),
    ]
    body = vessel(
        [(z * h, k * r, k * r, 2.0) for z, k in steps],
        [plain(ground, 0.02), art],
        [0, 0, 1, 0, 0, 0, 0, 0],
        20,
    )
    lid = cap(0.8 * r, 0.945 * h, 0.055 * h, plain(band, 0.05), 18, 0.98)
    return Model(
        title=f"bottle of {flavour.lower()} drinking yogurt",
        parts={
            "body": Part([body.weigh(1.2), lid], collision=[cylinder_piece(r, 0, h, 12, 0.75 * r)])
        },
        mass=0.3,
        friction=0.5,
    )


def spoon(length: float) -> list[Mesh]:
    """A teaspoon along +x, its bowl at the origin, 4 mm thick."""
    steel = metal("c9ced2", "868c91")
    path = [(0.012, 0, 0.004), (0.02, 0, 0.008), (length * 0.5, 0, 0.01), (length, 0, 0.012)]
    return [
        tube(path, [0.0035, 0.0025, 0.003, 0.005], 6, mat=steel, flatten=0.6),
        lathe(
            [(0, 0), (0.008, 0.001), (0.012, 0.006), (0.011, 0.008), (0, 0.004)], 12, mat=steel
        ).scale(1.5, 1, 1),
    ]


def open_cup(word: str, flavour: str, brand: str, pudding: str = "") -> Model:
    """An opened cup: the foil folded back, a spoon stuck in."""
    r, h = 0.038, 0.072 if not pudding else 0.06
    if pudding:
        tone, light, ground, ink = chilled.PUDDINGS[pudding]
        one, d = labels.canvas(240, 220, ground)
        labels.text(d, word, (12, 14, 228, 80), "bold", ink)
        foods.swirl(d, 120, 150, 84, tone, light)
        content, band, motif = tone, ink, groceries.swirl
        image, _ = labels.canvas(720, 220)
        for k in range(3):
            image.paste(one, (240 * k, 0))
    else:
        ground, band, motif = YOGURTS[flavour]
        motif = getattr(groceries, motif)
        image = groceries.wrapped(3, 260, 256, ground, band, word, brand, motif, flavour)
        content = {"STRAWBERRY": "#f4bcc4", "BLUEBERRY": "#c4b4dc"}.get(flavour, CREAMY)
    low = 0.78 * r
    z = h - 0.004
    body = vessel(
        [
            (0, low * 0.96, low * 0.96, 2.0),
            (0.003, low, low, 2.0),
            (z, r, r, 2.0),
            (z + 0.001, r + 0.004, r + 0.004, 2.0),
            (h, r + 0.004, r + 0.004, 2.0),
            (h, r - 0.002, r - 0.002, 2.0),
            (h - 0.012, r - 0.005, r - 0.005, 2.0),
        ],
        [plain(ground, 0.02), label(image)],
        [0, 1, 0, 0, 0, 0],
        22,
    )
    cream = Material(occlusion=0.6)
    wave = cream.math("SINE", cream.math("MULTIPLY", cream.distance((0.006, 0.004, h)), 650.0))
    cream.colour(cream.mix(cream.remap(wave, -0.4, 0.9, 0, 0.25), content, "ffffff"))
    level = lathe(
        [
            (0, h - 0.013),
            (r - 0.004, h - 0.013),
            (r - 0.0045, h - 0.009),
            (0.012, h - 0.006),
            (0, h - 0.003),
        ],
        20,
        mat=cream,
    )
    foil = lathe(
        [(0, 0), (r + 0.003, 0), (r + 0.003, 0.003), (0, 0.003)], 20, mat=metal("e2e5e8", "aeb4ba")
    )
    art = groceries.face(
        256,
        256,
        ground,
        band,
        word,
        brand,
        motif,
        pudding or flavour,
        "#ffffff" if not pudding else ground,
    )
    project_label(foil, label(art), "-z", (0, 0), (2 * r, 2 * r), 0.9)
    foil.move(r).turn(ry=-1.95).move(-r - 0.003, 0, h - 0.001)
    piece = spoon(0.12)
    for mesh in piece:
        mesh.turn(ry=-0.95).turn(rz=-0.9).move(0.004, 0.004, h - 0.02)
    kind = f"{pudding.lower()} pudding" if pudding else f"{flavour.lower()} yogurt"
    return Model(
        title=f"opened cup of {kind} with a spoon",
        parts={
            "body": Part(
                [body.weigh(1.2), level, foil, *piece],
                collision=[
                    cylinder_piece(low, 0, h, 12, r + 0.004),
                    few_corners(foil.v),
                    few_corners(np.concatenate([mesh.v for mesh in piece])),
                ],
            )
        },
        mass=0.16,
        friction=0.5,
    )


def yogurt_jar(word: str, flavour: str, brand: str) -> Model:
    """Half a litre in a returnable glass."""
    ground, band, motif = YOGURTS[flavour]
    h, r = 0.125, 0.045
    look = Material(occlusion=0.5)
    line = look.math("ABSOLUTE", look.math("ADD", look.normal(1), 0.55))
    base = look.mix(look.remap(look.axis(2), 0.8 * h, 0.82 * h), CREAMY, "dfeaf0")
    look.colour(look.mix(look.remap(line, 0.02, 0.08, 0.5, 0), base, "c8d8e4"))
    art = label(
        groceries.wrapped(
            3, 260, 230, ground, band, word, brand, getattr(groceries, motif), flavour
        )
    )
    steps = [
        (0, 0.92),
        (0.03, 1.0),
        (0.12, 1.0),
        (0.66, 1.0),
        (0.72, 0.98),
        (0.82, 0.84),
        (0.9, 0.84),
    ]
    body = vessel(
        [(z * h, k * r, k * r, 2.0) for z, k in steps], [look, art], [0, 0, 1, 0, 0, 0], 20
    )
    lid = cap(0.9 * r, 0.88 * h, 0.12 * h, plain(band, 0.04), 20, 0.98)
    return Model(
        title=f"glass of {flavour.lower()} yogurt",
        parts={
            "body": Part([body.weigh(1.2), lid], collision=[cylinder_piece(r, 0, h, 12, 0.9 * r)])
        },
        mass=0.75,
        friction=0.45,
    )


Y = "YOGURT"

MODELS = {
    "yogurt_cup": Maker(
        by_style(
            "yogurt_cup",
            {
                "cup": food_trays.yogurt_cup,
                "pack": cup_pack,
                "pail": pail,
                "twin": twin_cup,
                "drink": drink_yogurt,
                "open": open_cup,
                "jar": yogurt_jar,
            },
        ),
        food_trays.yogurt_cup_random,
        count=8,
        presets=[
            {
                "style": "pail",
                "word": Y,
                "flavour": "STRAWBERRY",
                "brand": "Alba",
                "radius": 0.0365,
                "height": 0.082,
                "lid": "#f4f4f4",
                "handle": False,
            },
            {
                "style": "pail",
                "word": Y,
                "flavour": "BLUEBERRY",
                "brand": "Alba",
                "radius": 0.0365,
                "height": 0.082,
                "lid": "#f4f4f4",
                "handle": False,
            },
            {
                "style": "pack",
                "word": Y,
                "flavour": "CHERRY",
                "brand": "Cremosa",
                "rows": 2,
                "columns": 2,
                "side": 0.054,
                "height": 0.066,
            },
            {
                "style": "pail",
                "word": Y,
                "flavour": "PLAIN",
                "brand": "Hofgut",
                "radius": 0.05,
                "height": 0.125,
                "lid": "#2a6fc4",
                "handle": True,
            },
            {"style": "twin", "word": Y, "flavour": "STRAWBERRY", "brand": "Duetta"},
            {"style": "open", "word": Y, "flavour": "BLUEBERRY", "brand": "Alba"},
            {"style": "jar", "word": Y, "flavour": "PLAIN", "brand": "Alpina"},
            {
                "style": "pail",
                "word": Y,
                "flavour": "APRICOT",
                "brand": "Cremosa",
                "radius": 0.05,
                "height": 0.125,
                "lid": "#e07a10",
                "handle": True,
            },
        ],
    ),
}
