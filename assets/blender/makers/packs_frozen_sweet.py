"""Frozen pizza, and ice cream."""

from __future__ import annotations

import math

import numpy as np
from labels import foods, groceries
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import TAU, box, ellipsoid, lathe, loft, tube

from makers import frozen
from makers.pack_parts import (
    by_style,
    carton,
    carton_piece,
    flap,
    tub_ring,
    vessel,
)
from makers.packs_frozen import frosted, frozen_face
from makers.projection import project_label

ICY = "#bfe4ff"


def scoops(flavours: list[str], spots, radius: float, z: float) -> list[Mesh]:
    meshes = []
    for k, (x, y) in enumerate(spots):
        cream, dark, _, _ = frozen.ICE[flavours[k % len(flavours)]]
        m = Material(occlusion=0.8)
        c = m.mottle(cream, 0.05, 90)
        m.colour(m.mix(m.remap(m.voronoi(160), 0.1, 0.2, 0.4, 0), c, dark))
        ball = ellipsoid((radius,) * 3, (0, 0, 0), 12, 8, m)
        skirt = lathe(
            [
                (0, -0.6 * radius),
                (1.12 * radius, -0.55 * radius),
                (1.05 * radius, -0.2 * radius),
                (0, 0),
            ],
            12,
            mat=m,
            rib=lambda k, i: 1 + 0.09 * (i % 2),
        )
        for mesh in (ball, skirt):
            meshes.append(mesh.move(x, y, z))
    return meshes


def open_tub(flavours: list[str], brand: str) -> Model:
    """A round tub without its lid, three scoops in it; the lid leans behind."""
    flavour = flavours[0]
    radius, height = 0.052, 0.088
    pack = frozen.ICE[flavour][2]
    w, h = 300, 230
    image, d = labels.canvas(3 * w, h, pack)
    for k in range(3):
        frozen.ice_front(w, h, flavour, brand, d, k * w)
    low = 0.86 * radius
    body = vessel(
        [
            (0, low, low, 2.0),
            (height - 0.005, radius, radius, 2.0),
            (height, radius + 0.002, radius + 0.002, 2.0),
            (height, radius - 0.003, radius - 0.003, 2.0),
            (height - 0.02, radius - 0.005, radius - 0.005, 2.0),
        ],
        [plain(pack, 0.02), label(image)],
        [1, 0, 0, 0],
        22,
    )
    spots = [(0.02 * math.cos(a), 0.02 * math.sin(a)) for a in (0.4, 2.5, 4.6)]
    balls = scoops(flavours, spots, 0.025, height - 0.006)
    lid = lathe(
        [(0, 0), (radius + 0.004, 0), (radius + 0.004, 0.01), (radius, 0.013), (0, 0.013)],
        20,
        mat=plain(pack, 0.02),
    )
    project_label(
        lid,
        label(frozen.ice_lid(300, 300, flavour, brand, pack)),
        "+z",
        (0, 0),
        (2.1 * radius, 2.1 * radius),
        0.9,
    )
    lid.turn(ry=1.25).move(-radius - 0.022, 0.0, radius * 0.98)
    return Model(
        title=f"opened tub of {flavour.lower()} ice cream",
        parts={
            "body": Part(
                [body.weigh(1.2), *balls, lid],
                collision=[
                    cylinder_piece(low, 0, height, 14, radius),
                    cylinder_piece(0.8 * radius, height, height + 0.018, 10, 0.5 * radius),
                    box_piece((-radius - 0.015, 0, radius), (0.03, 2 * radius, 2 * radius)),
                ],
            )
        },
        mass=0.5,
        friction=0.5,
    )


def ice_bucket(flavour: str, brand: str) -> Model:
    """Two litres and more in a square pail with a handle."""
    _, _, pack, ink = frozen.ICE[flavour]
    side, h = 0.16, 0.15
    body = loft(
        [
            tub_ring(side, side, 0.03, z, k, 4)
            for z, k in ((0, 0.014), (0.004, 0.011), (h - 0.016, 0.003))
        ],
        mat=plain(pack, 0.02),
    )
    top = loft(
        [
            tub_ring(side, side, 0.03, z, k, 4)
            for z, k in ((h - 0.018, 0), (h - 0.003, 0), (h, 0.003))
        ],
        mat=plain(ink, 0.02),
    )
    image, d = labels.canvas(300, 280, pack)
    frozen.ice_front(300, 280, flavour, brand, d, 0)
    art = label(image)
    for mesh in (body, top):
        mesh.bake_uv = None
    for s in ("+x", "-x", "+y", "-y"):
        project_label(body, art, s, (0, (h - 0.016) / 2), (side * 0.86, h - 0.016), 0.7)
    project_label(
        top, label(frozen.ice_lid(300, 300, flavour, brand, pack)), "+z", (0, 0), (side, side), 0.9
    )
    arch = [
        (0, y, z)
        for y, z in (
            (-0.083, h - 0.025),
            (-0.086, h - 0.06),
            (-0.07, 0.055),
            (0, 0.045),
            (0.07, 0.055),
            (0.086, h - 0.06),
            (0.083, h - 0.025),
        )
    ]
    arch = [(0.02 + 0.075 * math.sin(math.pi * k / 6), y, z) for k, (_, y, z) in enumerate(arch)]
    grip = tube(arch, 0.003, 5, mat=plain("#f4f4f0", 0.02))
    return Model(
        title=f"large pail of {flavour.lower()} ice cream",
        parts={
            "body": Part(
                [body.weigh(1.2), top, grip],
                collision=[box_piece((0, 0, h / 2), (side - 0.01, side - 0.01, h))],
            )
        },
        mass=1.4,
        friction=0.5,
    )


def ice_brick(flavour: str, brand: str) -> Model:
    """A cardboard half-gallon, long and low."""
    _, _, pack, ink = frozen.ICE[flavour]
    depth, width, h = 0.085, 0.18, 0.07
    front, d = labels.canvas(420, 170, pack)
    frozen.ice_front(300, 170, flavour, brand, d, 0)
    for k in range(2):
        foods.cone(d, 326 + 60 * k, 80, 26, 70)
        foods.scoop(d, 326 + 60 * k, 62, 30, *frozen.ICE[flavour][:2])
    top = frozen.ice_lid(420, 200, flavour, brand, pack)
    side, d = labels.canvas(200, 170, ink)
    labels.text(d, "ICE", (20, 14, 180, 84))
    labels.text(d, "CREAM", (14, 86, 186, 156))
    body = carton(depth, width, h, front, side, top, pack)
    return Model(
        title=f"carton of {flavour.lower()} ice cream",
        parts={"body": Part([body.weigh(1.2)], collision=[carton_piece(depth, width, h)])},
        mass=0.6,
        friction=0.5,
    )


def pizza_disc(radius: float, form: int = 1) -> list[Mesh]:
    """A frozen pizza: crust, cheese with frost on it, salami."""
    image, d = labels.canvas(400, 400, "#dda452")
    foods.pizza(d, 200, 200, 200, "salami", np.random.default_rng(form))
    crust = Material()
    crust.colour(crust.mottle("#d69a4a", 0.12, 50))
    base = lathe(
        [
            (0, 0),
            (radius * 0.97, 0),
            (radius, 0.006),
            (radius * 0.98, 0.015),
            (radius * 0.9, 0.017),
            (radius * 0.86, 0.012),
            (0, 0.012),
        ],
        28,
        mat=crust,
    )
    project_label(base, frosted(image, 0.55), "+z", (0, 0), (2 * radius, 2 * radius), 0.9)
    meat = plain("#a8281c", 0.14, 120)
    meshes = [base.weigh(1.2)]
    for k in range(6):
        a, q = k * TAU / 6 + 0.3, radius * (0.56 if k % 2 else 0.3)
        meshes.append(
            lathe(
                [(0, 0.011), (0.02, 0.011), (0.02, 0.015), (0.017, 0.0165), (0, 0.0155)],
                10,
                mat=meat,
            ).move(q * math.cos(a), q * math.sin(a))
        )
    return meshes


def wrapped_pizza(radius: float, brand: str) -> Model:
    """Without a box: a pizza on its card under film, with a round label."""
    meshes = pizza_disc(radius)
    card = lathe(
        [(0, 0), (radius * 1.06, 0), (radius * 1.06, 0.004), (0, 0.004)],
        28,
        mat=plain("#f2f2ee", 0.03),
    )
    for mesh in meshes:
        mesh.move(0, 0, 0.004)
    image, d = labels.canvas(256, 256)
    d.ellipse((0, 0, 255, 255), fill="#1f6fc4", outline="#ffffff", width=8)
    labels.text(d, "FROZEN", (60, 36, 196, 82), "bold", ICY)
    labels.text(d, "PIZZA", (22, 84, 234, 160), "bold")
    foods.snowflake(d, 128, 204, 32)
    badge = lathe(
        [(0, 0.02), (0.052, 0.02), (0.052, 0.0255), (0, 0.0255)], 22, mat=plain("#1f6fc4", 0)
    )
    project_label(badge, label(image, base="#1f6fc4"), "+z", (0, 0), (0.104, 0.104), 0.9)
    badge.move(radius * 0.4, -radius * 0.42)
    return Model(
        title="frozen pizza in film",
        parts={
            "body": Part(
                [card, *meshes, badge.weigh(1.3)], collision=[cylinder_piece(radius, 0, 0.022, 16)]
            )
        },
        mass=0.38,
        friction=0.5,
    )


def open_pizza_box(size: float, brand: str) -> Model:
    """The box slit open at one end, the pizza half out."""
    h = 0.036
    top = label(frozen.pizza_top("salami", "#f4d9a0", "#b8241c", brand, np.random.default_rng(3)))
    edge, d = labels.canvas(400, 52, "#b8241c")
    labels.text(d, "FROZEN PIZZA", (40, 5, 360, 47))
    board, inside = plain("#b8241c", 0.03), plain("#d8c8a8", 0.05)
    t = 0.005
    faces = {"+z": top}
    meshes = [
        box(size, size, t, (0, 0, h - t), board, 0.001, 1, faces).weigh(1.3),
        box(size, size, t, (0, 0, 0), inside, 0.001),
    ]
    for s in (-1, 1):
        meshes.append(
            box(
                size,
                t,
                h - 2 * t,
                (0, s * (size - t) / 2, t),
                board,
                0,
                1,
                {"+y" if s > 0 else "-y": label(edge)},
            )
        )
    meshes.append(box(t, size, h - 2 * t, (-(size - t) / 2, 0, t), board))
    meshes.append(flap(size - 0.01, 0.032, 0.022, 0.005, board).move(size / 2 - 0.002, 0, h - t))
    pie = pizza_disc(size * 0.45, 4)
    for mesh in pie:
        mesh.move(size * 0.36, 0, 0.006)
    solids = [
        box_piece((0, 0, h / 2), (size, size, h)),
        cylinder_piece(size * 0.44, 0.005, 0.024, 14) + np.array([size * 0.36, 0, 0]),
    ]
    return Model(
        title="frozen pizza slid out of its box",
        parts={"body": Part([*meshes, *pie], collision=solids)},
        mass=0.42,
        friction=0.5,
    )


def snack_pizza(
    word: str, brand: str, ground: str, band: str, depth: float, width: float, h: float
) -> Model:
    """Small pizzas or a baguette in an oblong box."""
    top = frozen_face(
        420, int(420 * depth / width), ground, band, f"{word}", brand, groceries.pizza
    )
    edge, d = labels.canvas(420, int(420 * h / width), band)
    labels.text(d, f"FROZEN {word}".replace("\n", " "), (30, 6, 390, int(420 * h / width) - 6))
    body = carton(depth, width, h, edge, edge, top, ground)
    return Model(
        title="box of small frozen pizzas",
        parts={"body": Part([body.weigh(1.2)], collision=[carton_piece(depth, width, h)])},
        mass=0.35,
        friction=0.5,
    )


MODELS = {
    "ice_cream_tub": Maker(
        by_style(
            "ice_cream_tub",
            {"old": frozen.ice_cream_tub, "open": open_tub, "pail": ice_bucket, "brick": ice_brick},
        ),
        frozen.ice_cream_tub_random,
        count=7,
        presets=[
            {"style": "old", "form": "round", "flavour": "VANILLA", "size": 1.0},
            {"style": "old", "form": "box", "flavour": "STRAWBERRY"},
            {
                "style": "old",
                "form": "round",
                "flavour": "CHOCOLATE",
                "lid": "#e8d2b4",
                "size": 1.0,
            },
            {
                "style": "open",
                "flavours": ["VANILLA", "CHOCOLATE", "STRAWBERRY"],
                "brand": "Nevada",
            },
            {"style": "pail", "flavour": "VANILLA", "brand": "Polo"},
            {"style": "brick", "flavour": "CHOCOLATE", "brand": "Gelata"},
            {"style": "pail", "flavour": "STRAWBERRY", "brand": "Nevada"},
        ],
    ),
    "frozen_pizza": Maker(
        by_style(
            "frozen_pizza",
            {
                "box": frozen.frozen_pizza,
                "film": wrapped_pizza,
                "open": open_pizza_box,
                "snack": snack_pizza,
            },
        ),
        frozen.frozen_pizza_random,
        count=7,
        presets=[
            {"style": "box", "topping": "salami", "size": 0.28, "height": 0.034},
            {
                "style": "box",
                "topping": "basil",
                "colour": "#f6ead0",
                "dark": "#1f6a34",
                "size": 0.28,
                "height": 0.034,
            },
            {"style": "film", "radius": 0.135, "brand": "Forno"},
            {"style": "open", "size": 0.27, "brand": "Vesuvio"},
            {
                "style": "snack",
                "word": "PIZZA\nSNACKS",
                "brand": "Da Nino",
                "ground": "#fbe9c4",
                "band": "#b8241c",
                "depth": 0.17,
                "width": 0.26,
                "h": 0.045,
            },
            {
                "style": "snack",
                "word": "PIZZA\nBAGUETTE",
                "brand": "Forno",
                "ground": "#e6f3ff",
                "band": "#14509c",
                "depth": 0.1,
                "width": 0.25,
                "h": 0.055,
            },
            {
                "style": "box",
                "topping": "salami",
                "colour": "#dbeaf6",
                "dark": "#14509c",
                "size": 0.28,
                "height": 0.034,
            },
        ],
    ),
}
