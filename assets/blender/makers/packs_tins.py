"""Tins: tall, large, flat, of sardines, stacked and opened; butter in every form it is sold."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle

from makers import food_packs
from makers.pack_parts import by_style, flap, lump, tub_ring, vessel
from makers.projection import project_label

TINS = {  # word: (ground, band, motif)
    "TUNA": ("#f2f6fa", "#14509c", "fish"),
    "PEACHES": ("#fbe4a8", "#c8560e", "apricot"),
    "SARDINES": ("#f8d84a", "#b8242c", "fish"),
    "PEAS": ("#dff0c8", "#2f8a3a", "peas"),
    "SOUP": ("#fbf2e0", "#b8202c", "tomato"),
    "PASTE": ("#fbe6d0", "#b01c14", "tomato"),
}


def steel_of(rng) -> Material:
    return metal("c6cacd", "868c91", (8, 8, 1), 60, noise_offset(rng))


def ring_pull(x: float, z: float, steel: Material) -> Mesh:
    return extrude(rounded_rectangle(0.026, 0.016, 0.007, 3), 0.0025, steel).move(x, 0, z)


def can_steps(r: float, h: float) -> list[tuple[float, float]]:
    return [
        (0.95 * r, 0),
        (1.02 * r, 0.002),
        (1.0 * r, 0.006),
        (1.0 * r, h - 0.006),
        (1.02 * r, h - 0.003),
        (0.97 * r, h),
        (0.93 * r, h - 0.003),
    ]


def tin_body(r: float, h: float, word: str, brand: str, steel: Material, cells: int, n=22) -> Mesh:
    ground, band, motif = TINS[word]
    w = 300
    tall = max(90, int(w * cells * h / (math.tau * r)))
    art = groceries.wrapped(cells, w, tall, ground, band, word, brand, getattr(groceries, motif))
    sections = [(z, q, q, 2.0) for q, z in can_steps(r, h)]
    return vessel(sections, [steel, label(art)], [0, 0, 1, 0, 0, 0], n).weigh(1.2)


def round_tin(radius: float, height: float, word: str, brand: str, stack: int = 1) -> Model:
    """A tin, or some of the same on top of one another."""
    steel = steel_of(np.random.default_rng(1))
    ground, band, motif = TINS[word]
    cells = 3 if height > 0.06 else 5
    meshes, solids = [], []
    for k in range(stack):
        z = k * (height + 0.0005)
        meshes.append(
            tin_body(radius, height, word, brand, steel, cells, 22 if stack == 1 else 16).move(
                0, 0, z
            )
        )
        solids.append(cylinder_piece(radius, z, z + height, 14))
    top = (stack - 1) * (height + 0.0005) + height
    if height < 0.06:  # a printed lid
        art, d = labels.canvas(256, 256, ground)
        d.ellipse((4, 4, 252, 252), fill=ground, outline=band, width=14)
        labels.text(d, word, (34, 60, 222, 130), "bold", band)
        getattr(groceries, motif)(d, 128, 178, 46)
        lid = loft(
            [
                tub_ring(2 * radius * 0.93, 2 * radius * 0.93, radius * 0.92, z, 0, 6)
                for z in (top - 0.004, top - 0.0018)
            ],
            mat=steel,
        )
        lid.bake_uv = None
        project_label(lid, label(art), "+z", (0, 0), (1.86 * radius, 1.86 * radius), 0.9)
        meshes.append(lid)
    meshes.append(ring_pull(-radius * 0.5, top - (0.003 if height > 0.06 else 0.0018), steel))
    return Model(
        title=f"tin of {word.lower()}"
        if stack == 1
        else f"stack of {stack} tins of {word.lower()}",
        parts={"body": Part(meshes, collision=solids)},
        mass=round(stack * (0.03 + radius**2 * math.pi * height * 1050), 2),
        friction=0.5,
    )


def open_tin(
    radius: float, height: float, word: str, brand: str, food: str, form: int = 3
) -> Model:
    """An opened tin: the jagged lid stands up at the back, the food shows."""
    rng = np.random.default_rng(form)
    steel = steel_of(rng)
    r, h = radius, height
    body = tin_body(r, h, word, brand, steel, 3)
    filling = plain(food, 0.25, 160)
    meshes = [body]
    level = lathe(
        [(0, h - 0.012), (0.94 * r, h - 0.012), (0.94 * r, h - 0.0025), (0, h - 0.0025)],
        16,
        mat=filling,
    )
    meshes.append(level)
    if word == "PEAS":
        pea = plain("#6fae3c", 0.15, 200)
        for k in range(8):
            a, q = k * 2.4, 0.72 * r * math.sqrt(k / 8)
            meshes.append(
                lump(
                    (0.0058,) * 3, (q * math.cos(a), q * math.sin(a), h - 0.006), pea, k, 6, 4, 0.05
                )
            )
    disc = lathe(
        [(0, 0), (0.9 * r, 0), (0.93 * r, 0.0015), (0.9 * r, 0.003), (0, 0.003)],
        20,
        mat=steel,
        rib=lambda k, i: 1 - 0.05 * (i % 2) if k == 2 else 1,
    )
    pull = ring_pull(r * 0.5, 0.003, steel)
    for mesh in (disc, pull):
        mesh.move(r * 0.93).turn(ry=-1.25).move(-r * 0.96, 0, h - 0.001)
    pieces = [cylinder_piece(r, 0, h, 14)]
    pieces.append(disc.v[np.abs(disc.v[:, 2] - disc.v[:, 2].mean()) < 1].copy()[::3])
    return Model(
        title=f"opened tin of {word.lower()}",
        parts={"body": Part([*meshes, disc, pull], collision=pieces)},
        mass=0.4,
        friction=0.5,
    )


def sardine_tin(word: str, brand: str) -> Model:
    """The flat tin with rounded corners."""
    steel = steel_of(np.random.default_rng(2))
    depth, width, h, radius = 0.062, 0.106, 0.026, 0.018
    ground, band, motif = TINS[word]
    levels = [(0, 0.003), (0.002, 0.0), (0.004, 0.001), (h - 0.004, 0.001), (h - 0.002, 0.0)]
    levels += [(h, 0.001), (h, 0.003), (h - 0.002, 0.005)]
    body = loft([tub_ring(depth, width, radius, z, k, 5) for z, k in levels], mat=steel)
    body.bake_uv = None
    art = groceries.face(400, 234, ground, band, word, brand, getattr(groceries, motif), "IN OIL")
    project_label(
        body,
        label(art),
        "+z",
        (0, 0),
        (width - 0.01, depth - 0.01),
        0.95,
        lambda c: abs(c[1]) < 0.046 and abs(c[0]) < 0.024,
    )
    edge = groceries.face(400, 100, band, band, word, "", None, "")
    for side, span in (("+x", width), ("-x", width), ("+y", depth), ("-y", depth)):
        project_label(body, label(edge), side, (0, h / 2), (span * 1.1, h * 1.15), 0.75)
    pull = ring_pull(0, h - 0.0015, steel).move(0, -width * 0.36)
    return Model(
        title="tin of sardines",
        parts={
            "body": Part(
                [body.weigh(1.2), pull], collision=[box_piece((0, 0, h / 2), (depth, width, h))]
            )
        },
        mass=0.16,
        friction=0.5,
    )


def butter_art(w: int, h: int, colour: str, dark: str, brand: str):
    image, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.15), fill=dark)
    d.rectangle((0, h * 0.85, w, h), fill=dark)
    labels.text(d, brand, (w * 0.2, h * 0.18, w * 0.8, h * 0.34), "italic", dark)
    labels.text(d, "BUTTER", (w * 0.06, h * 0.34, w * 0.94, h * 0.82), "serif", dark)
    return image


def yellow_butter() -> Material:
    m = Material()
    return m.colour(m.mottle("#f6dc74", 0.05, 60))


def butter_tub(colour: str, dark: str, brand: str) -> Model:
    """Spreadable butter in an oval tub."""
    depth, width, h = 0.09, 0.13, 0.062
    low = [
        tub_ring(depth, width, 0.035, z, k, 5)
        for z, k in ((0, 0.012), (0.003, 0.01), (h - 0.014, 0.003))
    ]
    body = loft(low, mat=plain(colour, 0.02))
    top = loft(
        [
            tub_ring(depth, width, 0.036, z, k, 5)
            for z, k in (
                (h - 0.016, 0.0),
                (h - 0.004, 0.0),
                (h - 0.002, 0.002),
                (h - 0.002, 0.008),
                (h - 0.004, 0.01),
            )
        ],
        mat=plain(dark, 0.02),
    )
    for mesh in (body, top):
        mesh.bake_uv = None
    art = label(butter_art(320, 130, colour, dark, brand))
    for side, span in (("+x", width), ("-x", width), ("+y", depth), ("-y", depth)):
        project_label(body, art, side, (0, (h - 0.012) / 2), (span * 0.82, h - 0.012), 0.7)
    project_label(
        top, label(butter_art(320, 220, colour, dark, brand)), "+z", (0, 0), (width, depth), 0.9
    )
    return Model(
        title="tub of butter",
        parts={
            "body": Part(
                [body, top.weigh(1.2)],
                collision=[box_piece((0, 0, h / 2), (depth - 0.006, width - 0.006, h))],
            )
        },
        mass=0.27,
        friction=0.5,
    )


def butter_open(colour: str, dark: str, brand: str) -> Model:
    """A block on its opened wrapper, some of it cut off in slices."""
    fat = yellow_butter()
    foil = plain("#e8e8e4", 0.08, 90)
    print_ = label(butter_art(300, 180, colour, dark, brand))
    paper = loft(
        [
            np.c_[q, np.full(len(q), z)]
            for q, z in (
                (rounded_rectangle(0.125, 0.185, 0.006, 2), 0.0),
                (rounded_rectangle(0.13, 0.19, 0.006, 2), 0.005),
            )
        ],
        mat=foil,
    )
    block = box(0.065, 0.075, 0.042, (0, 0.018, 0.004), fat, 0.003, 2)
    meshes = [paper, block]
    for k, y in enumerate((-0.036, -0.05)):
        piece = box(0.064, 0.008, 0.041, (0, y, 0.004), fat, 0.002)
        lean = 0.5 + 0.7 * k
        meshes.append(piece.turn(rx=lean, pivot=(0, y, 0.004)))
    wrap = box(
        0.069,
        0.05,
        0.0445,
        (0, 0.048, 0.0035),
        foil,
        0.003,
        labels={"+z": print_, "+x": print_, "-x": print_},
    )
    skirt = [flap(0.066, 0.022, 0.01, 0.003, foil).move(0.034, 0.05, 0.004)]
    meshes += [wrap.weigh(1.2), *skirt]
    return Model(
        title="opened butter on its wrapper",
        parts={
            "body": Part(
                meshes,
                collision=[
                    box_piece((0, 0, 0.0025), (0.125, 0.185, 0.005)),
                    box_piece((0, 0.01, 0.025), (0.069, 0.125, 0.042)),
                ],
            )
        },
        mass=0.2,
        friction=0.5,
    )


def butter_dish(lid: bool, colour: str) -> Model:
    """Butter on a plate, under its dome or beside it."""
    fat = yellow_butter()
    pot = Material()
    pot.colour(pot.mottle(colour, 0.03, 60))
    depth, width = 0.115, 0.19
    plate = loft(
        [
            tub_ring(depth, width, 0.02, z, k, 4)
            for z, k in ((0, 0.018), (0.004, 0.014), (0.014, 0.0), (0.016, 0.002), (0.009, 0.016))
        ],
        mat=pot,
    )
    plate.bake_uv = None
    meshes = [plate, box(0.066, 0.1, 0.04, (0, 0, 0.008), fat, 0.003, 2)]
    grooves = box(0.06, 0.007, 0.036, (0, -0.06, 0.009), fat, 0.002).turn(
        rx=1.1, pivot=(0, -0.06, 0.009)
    )
    meshes.append(grooves)
    knife = [
        box(0.014, 0.085, 0.0035, (0, 0.0, 0.0), metal("c9ced2", "868c91"), 0.0015),
        box(0.012, 0.07, 0.009, (0, 0.075, -0.003), plain("#5a3a24", 0.08), 0.003),
    ]
    for mesh in knife:
        mesh.turn(rz=0.25).move(0.005, 0.02, 0.051)
    solids = [
        box_piece((0, 0, 0.007), (depth, width, 0.014)),
        box_piece((0, 0, 0.03), (0.066, 0.12, 0.04)),
    ]
    return Model(
        title="butter on a dish",
        parts={"body": Part([*meshes, *knife], collision=solids)},
        mass=0.5,
        friction=0.5,
    )


def butter_sticks(colour: str, dark: str, brand: str) -> Model:
    """A long half-pound stick."""
    depth, width, h = 0.034, 0.13, 0.034
    art = label(butter_art(400, 105, colour, dark, brand))
    faces = dict.fromkeys(("+x", "-x", "+z"), art)
    body = box(depth, width, h, (0, 0, 0), plain(colour, 0.04, 90), 0.003, 1, faces)
    return Model(
        title="stick of butter",
        parts={"body": Part([body], collision=[box_piece((0, 0, h / 2), (depth, width, h))])},
        mass=0.125,
        friction=0.5,
    )


GOLD = {"colour": "#e8c84a", "dark": "#1f4f9c"}
GREEN = {"colour": "#f2ead0", "dark": "#1f7a3a"}

MODELS = {
    "canned_food": Maker(
        by_style(
            "canned_food",
            {
                "tin": food_packs.canned_food,
                "round": round_tin,
                "open": open_tin,
                "sardines": sardine_tin,
            },
        ),
        food_packs.canned_food_random,
        count=9,
        presets=[
            {"style": "tin", "kind": "TOMATOES"},
            {
                "style": "tin",
                "kind": "CORN",
                "colour": "#3f9a4a",
                "dark": "#1c4f26",
                "radius": 0.038,
                "height": 0.082,
            },
            {
                "style": "tin",
                "kind": "BEANS",
                "colour": "#e8b93a",
                "dark": "#5a2a10",
                "radius": 0.038,
                "height": 0.082,
            },
            {
                "style": "round",
                "word": "TUNA",
                "radius": 0.0425,
                "height": 0.036,
                "brand": "Marisol",
            },
            {"style": "sardines", "word": "SARDINES", "brand": "Nordhav"},
            {
                "style": "round",
                "word": "PEACHES",
                "radius": 0.0505,
                "height": 0.12,
                "brand": "La Huerta",
            },
            {
                "style": "open",
                "word": "PEAS",
                "radius": 0.0375,
                "height": 0.1,
                "brand": "Verde",
                "food": "#7a9a3c",
            },
            {
                "style": "round",
                "word": "TUNA",
                "radius": 0.0425,
                "height": 0.036,
                "brand": "Marisol",
                "stack": 3,
            },
            {"style": "round", "word": "SOUP", "radius": 0.0505, "height": 0.12, "brand": "Campo"},
        ],
    ),
    "butter": Maker(
        by_style(
            "butter",
            {
                "block": food_packs.butter,
                "tub": butter_tub,
                "open": butter_open,
                "dish": butter_dish,
                "stick": butter_sticks,
            },
        ),
        food_packs.butter_random,
        count=7,
        presets=[
            {"style": "block"},
            {"style": "block", **GREEN, "brand": "Alpina"},
            {"style": "tub", **GOLD, "brand": "Hofgut"},
            {"style": "open", **GOLD, "brand": "Hofgut"},
            {"style": "dish", "colour": "#dfe8ee", "lid": False},
            {"style": "stick", **GREEN, "brand": "Meadow"},
            {"style": "tub", **GREEN, "brand": "Alpina"},
        ],
    ),
}
