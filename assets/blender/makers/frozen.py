"""Frozen food: ice cream tubs, pizza boxes, bags and boxes of vegetables."""

from __future__ import annotations

import math

import numpy as np
from labels import foods
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import box, lathe, loft, rounded_rectangle

from makers.projection import project_label

ICE = {  # flavour: (ice cream, its shadow, package, ink)
    "VANILLA": ("#fbeebc", "#d9b860", "#9ccdee", "#1c3f8a"),
    "CHOCOLATE": ("#7a4a2c", "#4a2814", "#c89a6c", "#3a1c0c"),
    "STRAWBERRY": ("#f7a3b8", "#c85a7a", "#f8c8d4", "#a81c4a"),
}


def ice_front(w: int, h: int, flavour: str, brand: str, d, x0: float) -> None:
    cream, dark, _, ink = ICE[flavour]
    labels.text(d, brand, (x0 + w * 0.3, h * 0.03, x0 + w * 0.7, h * 0.13), "italic", ink)
    d.rectangle((x0 + w * 0.05, h * 0.15, x0 + w * 0.95, h * 0.43), fill=ink)
    labels.text(d, "ICE CREAM", (x0 + w * 0.08, h * 0.17, x0 + w * 0.92, h * 0.41))
    for i in (-1, 0, 1):
        x = x0 + w * (0.5 + 0.22 * i)
        foods.cone(d, x, h * 0.68, w * 0.1, h * 0.22)
        foods.scoop(d, x, h * 0.6, w * 0.1, cream, dark)
    labels.text(d, flavour, (x0 + w * 0.15, h * 0.87, x0 + w * 0.85, h * 0.98), "bold", ink)


def ice_lid(w: int, h: int, flavour: str, brand: str, colour: str):
    cream, dark, _, ink = ICE[flavour]
    image, d = labels.canvas(w, h, colour)
    labels.text(d, brand, (w * 0.3, h * 0.07, w * 0.7, h * 0.17), "italic", ink)
    labels.text(d, "ICE CREAM", (w * 0.08, h * 0.2, w * 0.92, h * 0.42), "bold", ink)
    for i in (-1, 0, 1):
        foods.scoop(d, w * (0.5 + 0.2 * i), h * 0.6, min(w, h) * 0.14, cream, dark)
    labels.text(d, flavour, (w * 0.24, h * 0.78, w * 0.76, h * 0.9), "bold", ink)
    return image


def round_tub(radius: float, height: float, flavour: str, brand: str, lid: str) -> Model:
    """A paper tub with a push-on lid."""
    pack = ICE[flavour][2]
    w, h = 300, 250
    image, d = labels.canvas(3 * w, h, pack)
    for k in range(3):  # one of them at u = 0.5, which is the front
        ice_front(w, h, flavour, brand, d, k * w)
    low, z = radius * 0.86, height - 0.014
    body = lathe(
        [(0, 0.003), (low * 0.92, 0.003), (low * 0.95, 0), (low, 0.001), (radius, z), (0, z)],
        22,
        mats=[plain(pack, 0.02), label(image)],
        mat_of_segment=[0, 0, 0, 1, 0],
        label_z=(0.001, z),
        start=-math.pi,
        weight=1.2,
    )
    r = radius + 0.003
    cap = lathe(
        [(0, z - 0.004), (r, z - 0.004), (r, height - 0.002), (r - 0.002, height), (0, height)],
        22,
        mat=plain(lid, 0.02),
    )
    project_label(
        cap, label(ice_lid(300, 300, flavour, brand, lid)), "+z", (0, 0), (r * 2, r * 2), 0.9
    )
    solid = cylinder_piece(low, 0, height, 14, r)
    return Model(
        title=f"tub of {flavour.lower()} ice cream",
        parts={"body": Part([body, cap], collision=[solid])},
        mass=0.5,
        friction=0.5,
    )


def box_tub(
    length: float, width: float, height: float, flavour: str, brand: str, lid: str
) -> Model:
    """A family tub: rounded plastic box with a lid."""
    _, _, pack, ink = ICE[flavour]
    front, d = labels.canvas(400, 200, pack)
    ice_front(400, 200, flavour, brand, d, 0)
    side, d = labels.canvas(260, 200, pack)
    labels.text(d, "ICE CREAM", (12, 30, 248, 90), "bold", "#fff", 3, ink)
    labels.text(d, flavour, (30, 110, 230, 150), "bold", ink)

    def ring(z: float, inset: float) -> np.ndarray:
        outline = rounded_rectangle(width - 2 * inset, length - 2 * inset, 0.022, 4)
        return np.c_[outline, np.full(len(outline), z)]

    z = height - 0.018
    body = loft([ring(0, 0.014), ring(0.004, 0.011), ring(z, 0.003)], mat=plain(pack, 0.02))
    body.bake_uv = None
    high, middle = z * 1.05, z / 2
    for sign, picture, span in (("x", front, length), ("y", side, width)):
        material = label(picture)
        for s in "+-":
            project_label(body, material, s + sign, (0, middle), (span * 0.9, high), 0.8)
    top = loft(
        [ring(z - 0.006, 0.0), ring(height - 0.003, 0.0), ring(height, 0.004)], mat=plain(lid, 0.02)
    )
    top.bake_uv = None
    picture = label(ice_lid(400, int(400 * width / length), flavour, brand, lid))
    project_label(top, picture, "+z", (0, 0), (length, width), 0.9)
    return Model(
        title=f"family tub of {flavour.lower()} ice cream",
        parts={
            "body": Part(
                [body.weigh(1.1), top.weigh(1.2)],
                collision=[box_piece((0, 0, height / 2), (width - 0.008, length - 0.008, height))],
            )
        },
        mass=0.7,
        friction=0.5,
    )


def ice_cream_tub(
    form="round", size=1.0, flavour="VANILLA", brand="Nevada", lid="#fdf6e6", seed=0
) -> Model:
    if form == "round":
        return round_tub(0.05 * size, 0.1 * size, flavour, brand, lid)
    return box_tub(0.165 * size, 0.11 * size, 0.095 * size, flavour, brand, lid)


def ice_cream_tub_random(rng: np.random.Generator) -> dict:
    return {
        "size": uniform(rng, 0.92, 1.06),
        "brand": pick(rng, ["Nevada", "Gelata", "Polo"]),
        "seed": seed_of(rng),
    }


def pizza_top(topping: str, colour: str, dark: str, brand: str, rng):
    image, d = labels.canvas(400, 400, colour)
    d.rectangle((0, 0, 400, 118), fill=dark)
    labels.text(d, brand, (16, 8, 150, 38), "italic", "#ffe9b0")
    labels.text(d, "FROZEN", (150, 6, 320, 44), "bold", "#bfe4ff")
    labels.text(d, "PIZZA", (16, 40, 320, 116), "bold", "#ffffff", 3, "#3a0a08")
    foods.snowflake(d, 358, 58, 34)
    foods.pizza(d, 200, 262, 136, topping, rng)
    name = "SALAMI" if topping == "salami" else "MARGHERITA"
    d.rectangle((0, 356, 400, 400), fill=dark)
    labels.text(d, name, (20, 360, 230, 396))
    labels.text(d, "-18 °C", (280, 364, 386, 394), "bold", "#bfe4ff")
    return image


def frozen_pizza(
    size=0.28,
    height=0.035,
    topping="salami",
    colour="#f4d9a0",
    dark="#b8241c",
    brand="Vesuvio",
    seed=0,
) -> Model:
    """A flat square box."""
    rng = np.random.default_rng(seed)
    edge, d = labels.canvas(400, 52, dark)
    labels.text(d, "FROZEN PIZZA", (90, 5, 370, 47))
    foods.snowflake(d, 48, 26, 20)
    side, top = label(edge), label(pizza_top(topping, colour, dark, brand, rng))
    faces = dict.fromkeys(("+x", "-x", "+y", "-y"), side)
    body = box(size, size, height, mat=plain(colour, 0.02), bevel_width=0.0015, labels=faces)
    body.keep_faces(
        [i for i, f in enumerate(body.f) if body.v[list(f)][:, 2].min() < height * 0.99]
    )
    lid = box(
        size - 0.002,
        size - 0.002,
        0.002,
        (0, 0, height - 0.002),
        plain(dark, 0),
        labels={"+z": top},
    )
    return Model(
        title=f"frozen pizza in its box, {topping}",
        parts={
            "body": Part(
                [body.weigh(0.8), lid.weigh(1.3)],
                collision=[box_piece((0, 0, height / 2), (size, size, height))],
            )
        },
        mass=0.42,
        friction=0.5,
    )


def frozen_pizza_random(rng: np.random.Generator) -> dict:
    return {
        "size": uniform(rng, 0.26, 0.295),
        "height": uniform(rng, 0.03, 0.04),
        "brand": pick(rng, ["Vesuvio", "Da Nino", "Forno"]),
        "seed": seed_of(rng),
    }


VEGETABLES = {  # kind: (word, package, dark)
    "peas": ("PEAS", "#2f8a3a", "#14501e"),
    "mixed": ("MIXED VEGETABLES", "#2f6fb8", "#143a70"),
    "spinach": ("SPINACH", "#e6efe0", "#1f5a24"),
}


def vegetables_front(w: int, h: int, kind: str, brand: str, rng):
    word, colour, dark = VEGETABLES[kind]
    image, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.1), fill=dark)
    labels.text(
        d,
        brand,
        (w * 0.16, h * 0.11, w * 0.6, h * 0.2),
        "italic",
        "#ffe98a" if kind != "spinach" else dark,
    )
    foods.snowflake(d, w * 0.76, h * 0.17, w * 0.09, "#ffffff" if kind != "spinach" else "#2f8fd0")
    box_ = (w * 0.05, h * 0.5, w * 0.95, h * 0.87)
    if kind == "peas":
        labels.text(d, "PEAS", (w * 0.14, h * 0.24, w * 0.86, h * 0.46), "bold", "#fff", 4, dark)
        foods.peas(d, box_, rng)
    elif kind == "mixed":
        labels.text(d, "MIXED", (w * 0.16, h * 0.22, w * 0.84, h * 0.36), "bold", "#fff", 3, dark)
        labels.text(
            d, "VEGETABLES", (w * 0.13, h * 0.37, w * 0.87, h * 0.48), "bold", "#fff", 3, dark
        )
        foods.mixed_vegetables(d, box_, rng)
    else:
        labels.text(d, word, (w * 0.05, h * 0.24, w * 0.95, h * 0.47), "bold", dark)
        foods.spinach(d, (w * 0.14, h * 0.58, w * 0.86, h * 0.8), rng)
    d.rectangle((0, h * 0.9, w, h), fill=dark)
    labels.text(d, "KEEP FROZEN", (w * 0.14, h * 0.91, w * 0.86, h * 0.99), "bold", "#bfe4ff")
    return image


def pillow(length: float, width: float, height: float, mat, rng) -> Mesh:
    """A filled bag lying flat, sealed at both ends of x, lumpy on top, its print up towards -x."""
    nx, ny = 12, 8
    phase = rng.uniform(0, 6.28, 4)
    rows = []
    for i in range(nx + 1):
        t = 2 * i / nx - 1
        full = max(0.0, 1 - abs(t) ** 5) ** 0.6 if abs(t) < 0.999 else 0.0
        half = width / 2 * (0.94 + 0.06 * (1 - full))
        top, bottom = [], []
        for j in range(ny + 1):
            s = 2 * j / ny - 1
            swell = (max(0.0, 1 - s**4) ** 0.7) * full
            lump = 1 + 0.12 * math.sin(9 * t + phase[0] + 3 * s) + 0.1 * math.sin(7 * s + phase[1])
            z = 0.004 + (height - 0.004) * swell * lump / 1.15
            top.append((t * length / 2, half * s, z))
            if 0 < j < ny:
                bottom.append((t * length / 2, half * s, 0.001 if full > 0.1 else 0.0025))
        rows.append(np.array(top + bottom[::-1]))
    mesh = loft(rows, mat=mat)
    mesh.bake_uv = None
    return mesh


def frozen_vegetables(
    kind="peas", length=0.22, width=0.17, height=0.05, brand="Hofgut", seed=0
) -> Model:
    """A bag of peas or mixed vegetables, or a box of spinach."""
    rng = np.random.default_rng(seed)
    _, colour, dark = VEGETABLES[kind]
    front = label(vegetables_front(300, int(300 * length / width), kind, brand, rng))
    if kind == "spinach":
        side, d = labels.canvas(300, 84, dark)
        labels.text(d, "SPINACH", (20, 8, 280, 76))
        side = label(side)
        body = box(
            length,
            width,
            height,
            mat=plain(dark, 0.02),
            bevel_width=0.002,
            labels={"+z": front, "+x": side, "-x": side, "+y": side, "-y": side},
        )
        solid = [box_piece((0, 0, height / 2), (length, width, height))]
    else:
        body = pillow(length, width, height, plain(colour, 0.03), rng)
        project_label(body, front, "+z", (0, 0), (width, length), 0.15)
        solid = "hull"
    container = "box" if kind == "spinach" else "bag"
    return Model(
        title=f"{container} of frozen {'mixed vegetables' if kind == 'mixed' else kind}",
        parts={"body": Part([body], collision=solid)},
        mass=0.45,
        friction=0.6,
    )


def frozen_vegetables_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.045, 0.055),
        "brand": pick(rng, ["Hofgut", "Verde", "Kaltfeld"]),
        "seed": seed_of(rng),
    }
