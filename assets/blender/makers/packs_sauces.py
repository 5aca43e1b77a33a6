"""Ketchup and olive oil."""

from __future__ import annotations

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import lathe, loft, tube

from makers import drinks
from makers.bottle_shapes import cap
from makers.pack_parts import by_style, print_on, tub_ring, vessel
from makers.projection import project_label

RED = "#c8141a"


def glossy(colour: str) -> Material:
    """Coloured plastic with an upright reflection."""
    m = Material(occlusion=0.8)
    line = m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5))
    return m.colour(m.mix(m.remap(line, 0.02, 0.1, 0.35, 0), m.mottle(colour, 0.03, 40), "ffffff"))


def ketchup_face(w: int, h: int, brand: str, paper: str, ink: str):
    image, d = labels.canvas(w, h, paper)
    d.rectangle((0, 0, w, h * 0.08), fill="#2f8a34")
    labels.text(d, brand, (w * 0.14, h * 0.1, w * 0.86, h * 0.24), "italic", "#2f8a34")
    labels.text(d, "KETCHUP", (w * 0.04, h * 0.26, w * 0.96, h * 0.54), "bold", ink)
    groceries.tomato(d, w * 0.5, h * 0.76, min(w * 0.24, h * 0.19))
    return image


def flat_label(mesh: Mesh, picture, width: float, tall: float, low: float, base: str) -> Mesh:
    """A label on front and back between two heights; the rest keeps its colour."""
    print_on(mesh, label(picture, base=base), width, tall, 0.4, low)
    for i, f in enumerate(mesh.f):
        z = mesh.v[list(f)][:, 2].mean()
        if mesh.mi[i] == len(mesh.mats) - 1 and not low < z < low + tall:
            mesh.mi[i] = 0
    return mesh


def ketchup_squeeze(brand: str, paper: str, ink: str) -> Model:
    """The squeeze bottle with a pointed flip cap."""
    h, w, d = 0.2, 0.072, 0.05
    steps = [
        (0, 0.9, 0.86),
        (0.02, 1, 1),
        (0.15, 1, 1),
        (0.62, 0.94, 0.96),
        (0.72, 0.72, 0.8),
        (0.78, 0.48, 0.62),
    ]
    body = vessel(
        [(z * h, d / 2 * q, w / 2 * p, 2.5) for z, p, q in steps], [glossy(RED)], None, 20
    )
    flat_label(body, ketchup_face(256, 330, brand, paper, ink), w, 0.5 * h, 0.14 * h, RED)
    lid = lathe(
        [
            (0, 0.77 * h),
            (0.018, 0.77 * h),
            (0.017, 0.86 * h),
            (0.009, 0.92 * h),
            (0.006, 1.0 * h),
            (0, 1.0 * h),
        ],
        16,
        mat=plain("#f6f4ee", 0.02),
    )
    pieces = [
        box_piece((0, 0, 0.34 * h), (d * 0.9, w * 0.92, 0.68 * h)),
        cylinder_piece(0.02, 0.68 * h, h, 10, 0.007),
    ]
    return Model(
        "squeeze bottle of ketchup",
        {"body": Part([body.weigh(1.3), lid], collision=pieces)},
        mass=0.5,
        friction=0.5,
    )


def ketchup_head_down(brand: str, paper: str, ink: str) -> Model:
    """The bottle that stands on its wide cap."""
    h, w, d = 0.185, 0.078, 0.054
    steps = [
        (0.17, 0.62, 0.7),
        (0.24, 0.86, 0.9),
        (0.34, 0.98, 1),
        (0.8, 1, 1),
        (0.93, 0.9, 0.86),
        (0.98, 0.66, 0.6),
        (1.0, 0.4, 0.36),
    ]
    body = vessel(
        [(z * h, d / 2 * q, w / 2 * p, 2.6) for z, p, q in steps], [glossy(RED)], None, 20
    )
    flat_label(body, ketchup_face(256, 300, brand, paper, ink), w, 0.5 * h, 0.32 * h, RED)
    foot = [(0, 0.86, 0.95), (0.02, 0.9, 1.0), (0.14, 0.82, 0.92), (0.185, 0.66, 0.76)]
    lid = vessel(
        [(z * h, d / 2 * q, w / 2 * p, 2.6) for z, p, q in foot], [plain("#f6f4ee", 0.03)], None, 20
    )
    pieces = [box_piece((0, 0, h / 2), (d * 0.9, w * 0.9, h))]
    return Model(
        "ketchup bottle standing on its cap",
        {"body": Part([body.weigh(1.3), lid], collision=pieces)},
        mass=0.48,
        friction=0.5,
    )


def ketchup_glass(brand: str, paper: str, ink: str) -> Model:
    """The old glass bottle: eight-sided, long-necked, a white screw cap."""
    h, r = 0.225, 0.031
    image = labels.canvas(900, 300, paper)[0]
    for k in range(3):
        image.paste(ketchup_face(300, 300, brand, paper, ink), (300 * k, 0))
    steps = [
        (0, 0.92),
        (0.02, 1),
        (0.1, 1),
        (0.46, 1),
        (0.54, 0.94),
        (0.66, 0.62),
        (0.84, 0.44),
        (0.9, 0.42),
    ]
    body = vessel(
        [(z * h, k * r, k * r, 2.0) for z, k in steps],
        [glossy("#a8100f"), label(image)],
        [0, 0, 1, 0, 0, 0, 0],
        16,
    )
    band = lathe(
        [(0.6 * r, 0.68 * h), (0.62 * r, 0.68 * h), (0.53 * r, 0.76 * h), (0.5 * r, 0.76 * h)],
        16,
        mat=plain(paper, 0.03),
    )
    lid = cap(0.5 * r, 0.885 * h, 0.115 * h, plain("#f6f4ee", 0.02), 16)
    pieces = [cylinder_piece(r, 0, 0.54 * h), cylinder_piece(r, 0.54 * h, h, 10, 0.45 * r)]
    return Model(
        "glass bottle of ketchup",
        {"body": Part([body.weigh(1.3), band, lid], collision=pieces)},
        mass=0.62,
        friction=0.45,
    )


def ketchup_diner(word: str) -> Model:
    """The round red bottle of the snack bar, with a nozzle."""
    h, r = 0.21, 0.034
    image, d = labels.canvas(900, 300, "#d8161c")
    for k in range(3):
        labels.text(
            d, word, (300 * k + 14, 80, 300 * k + 286, 180), "bold", "#ffffff", 4, "#7a0a0c"
        )
        groceries.tomato(d, 300 * k + 150, 242, 44)
    body = vessel(
        [
            (0, 0.95 * r, 0.95 * r, 2.0),
            (0.006, r, r, 2.0),
            (0.64 * h, r, r, 2.0),
            (0.68 * h, 0.94 * r, 0.94 * r, 2.0),
        ],
        [plain("#d8161c", 0.03), label(image)],
        [0, 1, 0],
        20,
    )
    lid = lathe(
        [
            (0, 0.67 * h),
            (1.02 * r, 0.67 * h),
            (1.02 * r, 0.74 * h),
            (0.5 * r, 0.78 * h),
            (0.2 * r, 0.83 * h),
            (0.1 * r, 1.0 * h),
            (0, 1.0 * h),
        ],
        20,
        mat=glossy("#b81016"),
    )
    pieces = [cylinder_piece(r, 0, 0.74 * h), cylinder_piece(r, 0.74 * h, h, 10, 0.006)]
    return Model(
        "ketchup dispenser bottle",
        {"body": Part([body.weigh(1.3), lid], collision=pieces)},
        mass=0.42,
        friction=0.5,
    )


# ---- olive oil
def oil_face(w: int, h: int, brand: str, paper: str, ink: str):
    image, d = labels.canvas(w, h, paper)
    d.rectangle((5, 5, w - 6, h - 6), outline=ink, width=5)
    labels.text(d, brand, (w * 0.14, h * 0.05, w * 0.86, h * 0.16), "italic", ink)
    labels.text(d, "OLIVE", (w * 0.07, h * 0.18, w * 0.93, h * 0.38), "bold", ink)
    labels.text(d, "OIL", (w * 0.2, h * 0.38, w * 0.8, h * 0.58), "bold", ink)
    groceries.olives(d, w * 0.5, h * 0.78, min(w * 0.36, h * 0.17))
    return image


def pourer(z: float, radius: float, steel: Material) -> list[Mesh]:
    """A cork with a bent spout."""
    cork = lathe(
        [(0, z), (radius, z), (radius * 0.9, z + 0.012), (0, z + 0.012)],
        12,
        mat=plain("#c8965a", 0.15, 200),
    )
    spout = tube(
        [(0, 0, z + 0.01), (0, 0, z + 0.025), (0.006, 0, z + 0.036), (0.018, 0, z + 0.046)],
        [0.005, 0.0045, 0.004, 0.0035],
        8,
        mat=steel,
    )
    return [cork, spout]


def oil_square(
    brand: str, paper: str, ink: str, glass: str, height: float, lid_colour: str
) -> Model:
    """The square bottle with a long neck."""
    h, a = height, 0.064
    steps = [
        (0, 0.94, 6),
        (0.02, 1, 6),
        (0.1, 1, 6),
        (0.6, 1, 6),
        (0.66, 0.94, 5),
        (0.72, 0.56, 3),
        (0.78, 0.4, 2),
        (0.9, 0.36, 2),
    ]
    body = vessel(
        [(z * h, a / 2 * k, a / 2 * k, p) for z, k, p in steps],
        [drinks.shiny(glass, h, 0.5)],
        None,
        20,
    )
    art = label(oil_face(240, 400, brand, paper, ink), base=glass)
    for side in ("+x", "-x", "+y", "-y"):
        project_label(
            body,
            art,
            side,
            (0, 0.33 * h),
            (a * 0.9, 0.48 * h),
            0.75,
            lambda c: 0.09 * h < c[2] < 0.62 * h,
        )
    lid = cap(0.24 * a, 0.885 * h, 0.115 * h, plain(lid_colour, 0.04), 16, 0.98)
    pieces = [
        box_piece((0, 0, 0.34 * h), (a, a, 0.68 * h)),
        cylinder_piece(0.4 * a, 0.68 * h, h, 10, 0.2 * a),
    ]
    return Model(
        "bottle of olive oil",
        {"body": Part([body.weigh(1.3), lid], collision=pieces)},
        mass=0.95,
        friction=0.45,
    )


def oil_round(brand: str, paper: str, ink: str) -> Model:
    """A tall round clear bottle full of golden oil, with a cork pourer."""
    h, r = 0.27, 0.036
    look = drinks.shiny("#b8a81c", h, 0.7, 0.6, "#e4e8d0", 0.86 * h)
    image = labels.canvas(780, 330, paper)[0]
    for k in range(3):
        image.paste(oil_face(260, 330, brand, paper, ink), (260 * k, 0))
    steps = [
        (0, 0.92),
        (0.02, 1),
        (0.12, 1),
        (0.48, 1),
        (0.56, 0.95),
        (0.66, 0.6),
        (0.74, 0.4),
        (0.92, 0.36),
        (0.925, 0.46),
        (0.96, 0.46),
    ]
    body = vessel(
        [(z * h, k * r, k * r, 2.0) for z, k in steps],
        [look, label(image)],
        [0, 0, 1] + [0] * 6,
        20,
    )
    meshes = [body.weigh(1.3), *pourer(0.955 * h, 0.36 * r, metal("c9ced2", "868c91"))]
    pieces = [cylinder_piece(r, 0, 0.56 * h), cylinder_piece(r, 0.56 * h, h, 10, 0.4 * r)]
    return Model(
        "bottle of olive oil with a pourer",
        {"body": Part(meshes, collision=pieces)},
        mass=0.9,
        friction=0.45,
    )


def oil_tin(brand: str, paper: str, ink: str, height: float) -> Model:
    """The oblong can with a small cap and a handle."""
    depth, width, h = 0.08, 0.115, height
    steel = metal("c6cacd", "868c91")
    body = loft(
        [
            tub_ring(depth, width, 0.012, z, k, 3)
            for z, k in (
                (0, 0.002),
                (0.003, 0),
                (h - 0.003, 0),
                (h, 0.002),
                (h, 0.005),
                (h - 0.004, 0.007),
            )
        ],
        mat=steel,
    )
    body.bake_uv = None
    art = label(oil_face(300, int(300 * h / width), brand, paper, ink))
    for side in ("+x", "-x"):
        project_label(body, art, side, (0, h / 2), (width, h), 0.75)
    edge, d = labels.canvas(150, int(150 * h / depth), ink)
    labels.text(d, "OLIVE", (12, 40, 138, 110), "bold", paper)
    labels.text(d, "OIL", (30, 112, 120, 180), "bold", paper)
    for side in ("+y", "-y"):
        project_label(body, label(edge), side, (0, h / 2), (depth, h), 0.75)
    lid = cap(0.016, h - 0.004, 0.022, plain("#c8202c", 0.03), 16).move(0, width * 0.3)
    grip = tube(
        [
            (0, -0.042, h - 0.003),
            (0, -0.04, h + 0.018),
            (0, 0.004, h + 0.018),
            (0, 0.006, h - 0.003),
        ],
        0.0045,
        6,
        mat=steel,
    )
    return Model(
        "can of olive oil",
        {
            "body": Part(
                [body.weigh(1.3), lid, grip],
                collision=[box_piece((0, 0, h / 2), (depth, width, h))],
            )
        },
        mass=round(depth * width * h * 930, 2),
        friction=0.45,
    )


def oil_jug(brand: str, paper: str, ink: str) -> Model:
    """A small bellied flagon with a ring handle."""
    h, r = 0.2, 0.048
    look = drinks.shiny("#7f8a1c", h, 0.7, 0.6, "#e4e8d0", 0.74 * h)
    image = labels.canvas(900, 240, paper)[0]
    for k in range(3):
        image.paste(oil_face(300, 240, brand, paper, ink), (300 * k, 0))
    steps = [
        (0, 0.8),
        (0.02, 0.9),
        (0.12, 1.0),
        (0.4, 1.0),
        (0.52, 0.84),
        (0.64, 0.44),
        (0.72, 0.3),
        (0.86, 0.28),
        (0.865, 0.36),
        (0.9, 0.36),
    ]
    body = vessel(
        [(z * h, k * r, k * r, 2.0) for z, k in steps],
        [look, label(image)],
        [0, 0, 1] + [0] * 6,
        20,
    )
    ring = tube(
        [
            (0, 0.3 * r + 0.017 * (1 - np.cos(t)), 0.74 * h + 0.017 * np.sin(t) * 1.2)
            for t in np.linspace(-2.6, 2.6, 9)
        ],
        0.0045,
        6,
        mat=look,
    )
    cork = lathe(
        [(0, 0.89 * h), (0.26 * r, 0.89 * h), (0.32 * r, h), (0, h)],
        12,
        mat=plain("#c8965a", 0.15, 200),
    )
    pieces = [cylinder_piece(r, 0, 0.5 * h), cylinder_piece(r, 0.5 * h, h, 10, 0.35 * r)]
    return Model(
        "flagon of olive oil",
        {"body": Part([body.weigh(1.3), ring, cork], collision=pieces)},
        mass=0.75,
        friction=0.45,
    )


OLD = {"brand": "Tomatella", "paper": "#f6ecd2", "ink": "#b01018"}
NEW = {"brand": "Rossini", "paper": "#ffffff", "ink": "#c8141a"}
CRETA = {"brand": "Kalamos", "paper": "#f4efd8", "ink": "#2f4a1c"}
TUSCA = {"brand": "Olivella", "paper": "#e8d890", "ink": "#5a3a0c"}

MODELS = {
    "ketchup_bottle": Maker(
        by_style(
            "ketchup_bottle",
            {
                "squeeze": ketchup_squeeze,
                "down": ketchup_head_down,
                "glass": ketchup_glass,
                "diner": ketchup_diner,
            },
        ),
        lambda rng: {},
        count=6,
        presets=[
            {"style": "squeeze", **OLD},
            {"style": "down", **OLD},
            {"style": "glass", **OLD},
            {"style": "diner", "word": "KETCHUP"},
            {"style": "down", **NEW},
            {"style": "glass", **NEW},
        ],
    ),
    "olive_oil_bottle": Maker(
        by_style(
            "olive_oil_bottle",
            {"square": oil_square, "round": oil_round, "tin": oil_tin, "jug": oil_jug},
        ),
        lambda rng: {},
        count=6,
        presets=[
            {
                "style": "square",
                **CRETA,
                "glass": "#2f4a1c",
                "height": 0.28,
                "lid_colour": "#1c1c1c",
            },
            {"style": "round", **TUSCA},
            {"style": "tin", **CRETA, "height": 0.2},
            {"style": "jug", **TUSCA},
            {
                "style": "square",
                **TUSCA,
                "glass": "#3a4a14",
                "height": 0.28,
                "lid_colour": "#c8a23a",
            },
            {"style": "tin", **TUSCA, "height": 0.2},
        ],
    ),
}
