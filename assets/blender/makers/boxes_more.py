"""Cardboard boxes, laundry baskets and storage bins of all forms, some of them filled."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.labels import canvas, text
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    rectangle,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, ellipsoid, lathe, loft, rounded_rectangle, tube

from makers import boxes_baskets
from makers.boxes_baskets import basket_wall, kraft
from makers.clothing import heap
from makers.joinery import fabric
from makers.projection import project_label
from makers.soft_forms import bars, bent, pad, ring

FULL = [{"state": "FULL", "variants": ["full"], "parts": ["filling"]}]


def filled(model: Model, meshes: list[Mesh], piece: np.ndarray) -> Model:
    """The model with a variant `full`."""
    model.parts["filling"] = Part(meshes, collision=[piece])
    model.variants = {"default": ["body"], "full": ["body", "filling"]}
    model.states = [*model.states, *FULL]
    return model


# ---- cardboard boxes
def _things(sx: float, sy: float, z: float, rng: np.random.Generator) -> list[Mesh]:
    """Household things looking out of a box: books, a ball, a vase, crumpled paper."""
    meshes = [box(sx, sy, 0.02, (0, 0, z - 0.05), plain("#d8c9a8", 0.2, 30))]
    tones = ["#b8303a", "#2f5f94", "#e0b83a", "#3f7f5a"]
    for k, tone in enumerate(tones):
        page = box(0.12, 0.028, 0.16, (0, 0, 0), plain(tone, 0.05), 0.002)
        meshes.append(page.turn(rx=-0.12).move(-0.2 * sx, -0.32 * sy + 0.036 * k, z - 0.09))
    meshes.append(
        ellipsoid(0.062, (0.22 * sx, -0.2 * sy, z - 0.005), 12, 8, plain("#e8702c", 0.04))
    )
    profile = [(0, 0), (0.03, 0), (0.045, 0.05), (0.02, 0.12), (0.028, 0.145), (0, 0.14)]
    vase = lathe(profile, 10, mat=plain("#7fb0b8", 0.05), discs=False)
    meshes.append(vase.turn(ry=0.25).move(-0.1 * sx, 0.28 * sy, z - 0.06))
    paper = plain("#f0ece0", 0.06, 40)
    for _ in range(2):
        x, y = float(rng.uniform(0.1, 0.25)) * sx, float(rng.uniform(0.1, 0.3)) * sy
        lump = ellipsoid((0.06, 0.055, 0.035), (x, y, z - 0.02), 7, 5, paper)
        lump.v += rng.normal(0, 0.006, lump.v.shape)
        meshes.append(lump)
    return meshes


def tall_box(sx: float, sy: float, h: float, title: str, seed: int) -> Model:
    """A moving box, taller than wide, taped, with hand holes and big lettering."""
    rng = np.random.default_rng(seed)
    card, tape, dark = kraft(seed), plain("#d9b987", 0.04, 60), plain("#3a2816", 0.05)
    picture, draw = canvas(256, 256)
    text(draw, title, (16, 70, 240, 130), "bold", "#3a2816")
    arrow = [(128, 150), (164, 196), (140, 196), (140, 236), (116, 236), (116, 196), (92, 196)]
    draw.polygon(arrow, fill="#3a2816")
    ink = Material()
    ink.colour(ink.image(picture, ink.mottle("#bb8d5c", 0.05, 30, noise_offset(rng))))
    body = box(sx, sy, h, (0, 0, 0), card, 0.003)
    side = min(sy, h) * 0.8
    for face in ("+x", "-x"):
        project_label(body, ink, face, (0, h * 0.5), (side, side), 0.9)
    if h < 0.15:  # too low for lettering on its side: a label on top, beside the tape
        slip = Material()
        sticker = prints.carton_side("shipping", rng)
        slip.colour(slip.image(sticker, slip.mottle("#bb8d5c", 0.05, 30, noise_offset(rng))))
        project_label(body, slip, "+z", (-0.04, -sx * 0.26), (sx * 0.62, sx * 0.48), 0.9)
    meshes = [body, box(0.055, sy + 0.003, 0.0016, (0, 0, h - 0.0008), tape)]
    meshes.append(box(sx - 0.01, 0.005, 0.003, (0, 0, h - 0.002), plain("#8a6238", 0.03)))
    for q in (-1, 1):
        meshes.append(box(0.055, 0.0016, 0.07, (0, q * (sy / 2 + 0.0007), h - 0.07), tape))
        slot = rounded_rectangle(0.1, 0.032, 0.015, 3)
        hole = loft([np.c_[slot[:, 0], np.full(12, y), slot[:, 1]] for y in (-0.001, 0.001)], dark)
        meshes.append(hole.move(0, q * (sy / 2 + 0.0005), h * 0.78))
    part = Part(meshes, collision=[box_piece((0, 0, h / 2), (sx, sy, h))])
    support = Support("top", h + 0.0008, rectangle(sx - 0.02, sy - 0.02))
    mass = round(min(9.0, 110 * sx * sy * h), 2)
    return Model("closed cardboard box", {"body": part}, mass=mass, supports=[support])


def lidded_box(sx: float, sy: float, h: float, seed: int) -> Model:
    """An archive box: a deep lid over it, hand holes, a label field."""
    rng = np.random.default_rng(seed)
    card, dark = kraft(seed), plain("#3a2816", 0.05)
    picture = prints.carton_side("shipping", rng)
    ink = Material()
    ink.colour(ink.image(picture, ink.mottle("#bb8d5c", 0.05, 30, noise_offset(rng))))
    lid_h = 0.085
    body = box(sx - 0.012, sy - 0.012, h - 0.02, (0, 0, 0), card, 0.002)
    project_label(body, ink, "+x", (0, h * 0.3), (sy * 0.7, h * 0.56), 0.9)
    meshes = [body, box(sx, sy, lid_h, (0, 0, h - lid_h), card, 0.003)]
    for q in (-1, 1):
        slot = rounded_rectangle(0.1, 0.034, 0.016, 3)
        hole = loft([np.c_[slot[:, 0], np.full(12, y), slot[:, 1]] for y in (-0.001, 0.001)], dark)
        meshes.append(hole.move(0, q * (sy / 2 - 0.0055), h * 0.5))
    part = Part(meshes, collision=[box_piece((0, 0, h / 2), (sx, sy, h))])
    support = Support("top", h, rectangle(sx - 0.02, sy - 0.02))
    return Model("cardboard box with a lid", {"body": part}, mass=2.5, supports=[support])


def cardboard_box(form: str, seed: int, **more) -> Model:
    """A cardboard box: "shipping" (closed or open), "tall", "flat" or "lidded"."""
    if form in ("tall", "flat"):
        return tall_box(seed=seed, **more)
    if form == "lidded":
        return lidded_box(seed=seed, **more)
    model = boxes_baskets.cardboard_box(seed=seed, **more)
    if more["is_open"]:
        sx, sy, h = more["length"], more["width"], more["height"]
        things = _things(sx - 0.016, sy - 0.016, h - 0.01, np.random.default_rng(seed))
        return filled(model, things, box_piece((0, 0, h * 0.5), (sx * 0.9, sy * 0.9, h * 0.9)))
    return model


def cardboard_box_random(rng: np.random.Generator) -> dict:
    return {"form": "shipping", "seed": seed_of(rng)}


# ---- laundry baskets
def laundry(rx: float, ry: float, z: float, seed: int) -> list[Mesh]:
    """A heap of washing that fills an opening of half-axes rx, ry at height z."""
    rng = np.random.default_rng(seed)
    colours = [("#7fb0d0", "#f4f4f0"), ("#c8453a", "#f4f0e6"), ("#3f5f94", "#d8a24a")]
    t = np.arange(10) * math.tau / 10
    outline = np.c_[rx * np.cos(t) * 0.96, ry * np.sin(t) * 0.96]
    base = pad(outline, 0.05, fabric("#e8e2d4", noise_offset(rng), 0.15), 0.4, 0.06)
    meshes = [base.move(z=z - 0.075)]

    def field(p: np.ndarray) -> np.ndarray:
        r2 = (p[:, 0] / rx) ** 2 + (p[:, 1] / ry) ** 2
        return z - 0.045 + 0.1 * np.clip(1 - r2, -0.1, 1)

    things = [
        {"kind": "towel", "colour": colours[0][0], "second": colours[0][1],
         "at": (0, -35 * ry), "turn": 1.3},
        {"kind": "shirt", "colour": colours[1][0], "second": colours[1][1], "style": "stripes",
         "at": (10 * rx, 30 * ry), "turn": 2.0},
        {"kind": "trousers", "colour": colours[2][0], "second": colours[2][1],
         "at": (-8 * rx, -2 * ry), "turn": 0.7},
    ]  # fmt: skip
    size = min(rx, ry) * 2.1
    return meshes + heap(things, field, rng, size * 0.72, 0.028, 0.17)


def round_hamper(style: str, radius: float, height: float, taper: float, colour: str, seed: int):
    """A round basket: "wicker", "tub" (soft plastic, two grips) or "popup" (mesh)."""
    wall, n = 0.009, 16
    r0, r1 = radius * taper, radius
    if style == "wicker":
        picture, rim_colour = basket_wall("wicker", colour)
        outside, rim = printed(picture), plain(rim_colour, 0.08, 90)
    elif style == "popup":
        picture, draw = canvas(512, 256, colour)
        for i in range(64):
            draw.line((8 * i, 0, 8 * i, 256), fill="#f4f4f0" if i % 2 else "#d8dcd8", width=2)
        for j in range(32):
            draw.line((0, 8 * j, 512, 8 * j), fill="#e8ece8", width=2)
        outside, rim = printed(picture), plain(shade(colour, 0.6), 0.04)
    else:
        outside, rim = plain(colour, 0.04, 20), plain(shade(colour, 0.85), 0.03)
    mid = 0.5 * (r0 + r1) * (1.03 if style == "wicker" else 1.0)
    inner = plain(shade(colour, 0.7), 0.08, 60)
    profile = [(0, 0), (r0, 0), (mid, height * 0.5), (r1, height - 0.02)]
    profile += [(r1 - wall, height - 0.02), (r0 - wall, 0.012), (0, 0.012)]
    body = lathe(
        profile, n, mats=[outside, inner], mat_of_segment=[0, 0, 0, 1, 1, 1],
        label_z=(0, height), discs=True,
    )  # fmt: skip
    edge = tube(ring(n, r1 - 0.003, r1 - 0.003, height - 0.014), 0.014, 5, closed=True, mat=rim)
    meshes = [body, edge]
    if style == "popup":
        meshes.append(tube(ring(n, r0, r0, 0.012), 0.012, 3, closed=True, mat=rim))
    for q in (-1, 1):
        y, z = q * r1, height - 0.015
        if style == "tub":
            grip = [(-0.075, y * 0.93, z), (-0.06, y * 0.98, z + 0.06), (0.06, y * 0.98, z + 0.06)]
            grip.append((0.075, y * 0.93, z))
        elif style == "popup":
            grip = [(-0.08, y * 0.93, z), (-0.05, y * 1.04, z + 0.08), (0.05, y * 1.04, z + 0.08)]
            grip.append((0.08, y * 0.93, z))
        else:
            grip = [(-0.06, y, z - 0.05), (-0.045, y + q * 0.04, z - 0.04)]
            grip += [(0.045, y + q * 0.04, z - 0.04), (0.06, y, z - 0.05)]
        meshes.append(bent(grip, 0.011, rim, 5 if style == "popup" else 6, 2))
    outer = [(r0, 0), (r1, height)]
    inside = [(r0 - wall, 0.012), (r1 - wall, height)]
    pieces = [cylinder_piece(r0, 0, 0.012), *ring_pieces(outer, inside, 10)]
    title = {"wicker": "wicker hamper", "tub": "laundry tub", "popup": "pop-up laundry basket"}
    flat = r0 * 1.35
    model = Model(
        title[style],
        {"body": Part(meshes, collision=pieces)},
        mass=0.9,
        containers=[Container("inside", (0, 0, height / 2), (flat, flat, height - 0.02))],
        supports=[Support("floor", 0.012, round_polygon(r0 - 0.03), container="inside")],
    )
    heap_meshes = laundry(r1 - 0.02, r1 - 0.02, height - 0.015, seed)
    return filled(model, heap_meshes, cylinder_piece(r1 * 0.9, 0.02, height + 0.03))


def framed_hamper(sx: float, sy: float, height: float, colour: str, seed: int) -> Model:
    """A cloth bag hung in a folding wooden frame."""
    rng = np.random.default_rng(seed)
    cloth, wood = fabric(colour, noise_offset(rng), 0.1), plain("#c9a06a", 0.08, 30)
    inner, stripe = plain(shade(colour, 0.6), 0.06), plain("#4a5a6a", 0.05)
    z0 = 0.08
    rings = []
    for z, f in ((z0, 0.86), (z0 + 0.05, 0.97), (height - 0.03, 1.0)):
        o = rounded_rectangle(sx * f, sy * f, 0.04, 3)
        rings.append(np.c_[o, np.full(len(o), z)])
    for z, f in ((height - 0.03, 0.95), (z0 + 0.06, 0.9)):
        o = rounded_rectangle(sx * f, sy * f, 0.04, 3)
        rings.append(np.c_[o, np.full(len(o), z)])
    meshes = [loft(rings, mats=[cloth, inner], mat_of_face=lambda k, i: int(k >= 3))]
    band = rounded_rectangle(sx * 1.005, sy * 1.005, 0.04, 3)
    low, high = height * 0.66, height * 0.76
    meshes.append(
        loft([np.c_[band, np.full(12, z)] for z in (low, high)], stripe, caps=(False, False))
    )
    for q in (-1, 1):
        y = q * (sy / 2 + 0.008)
        x = sx / 2
        meshes += bars([[(-x, y, 0), (x, y, height)], [(x, y, 0), (-x, y, height)]], 0.011, wood, 5)
    edge = sy / 2 + 0.02
    rails = [[(x, -edge, height - 0.008), (x, edge, height - 0.008)] for x in (-sx / 2, sx / 2)]
    meshes += bars(rails, 0.013, wood, 6)
    pieces = [box_piece((0, 0, z0 + 0.01), (sx * 0.9, sy * 0.9, 0.02))]
    for q in (-1, 1):
        pieces.append(box_piece((q * sx / 2, 0, height * 0.55), (0.02, sy, height * 0.88)))
        pieces.append(box_piece((0, q * sy / 2, height / 2), (sx, 0.03, height)))
    centre, size = (0, 0, (z0 + height) / 2), (sx * 0.84, sy * 0.84, height - z0 - 0.02)
    model = Model(
        "laundry bag in a wooden frame",
        {"body": Part(meshes, collision=pieces)},
        mass=1.6,
        containers=[Container("inside", centre, size)],
        supports=[Support("floor", z0 + 0.06, rectangle(sx * 0.7, sy * 0.7), container="inside")],
    )
    things = laundry(sx * 0.46, sy * 0.46, height - 0.03, seed)
    return filled(
        model, things, box_piece((0, 0, height * 0.55), (sx * 0.9, sy * 0.9, height * 0.9))
    )


def laundry_basket(form: str, seed: int, **more) -> Model:
    """A laundry basket: "oblong", "round" or "frame"; each may be full of washing."""
    if form == "round":
        return round_hamper(seed=seed, **more)
    if form == "frame":
        return framed_hamper(seed=seed, **more)
    model = boxes_baskets.laundry_basket(**more)
    w, h = more["width"], more["height"]
    things = laundry(w * 0.72 * 0.47, w * 0.47, h - 0.02, seed)
    return filled(model, things, box_piece((0, 0, h * 0.55), (w * 0.6, w * 0.85, h)))


def laundry_basket_random(rng: np.random.Generator) -> dict:
    return {"form": "oblong", "seed": seed_of(rng)}


_SHIP = {"length": 0.32, "width": 0.4, "height": 0.28, "marking": "fragile", "is_open": False}
_SLOTS = {"style": "slotted", "width": 0.55, "height": 0.29, "seed": 5}

MODELS = {
    "cardboard_box": Maker(
        cardboard_box,
        cardboard_box_random,
        8,
        [
            _SHIP,
            {**_SHIP, "is_open": True, "seed": 4},
            {**_SHIP, "marking": "shipping", "length": 0.24, "width": 0.3, "height": 0.16},
            {
                **_SHIP,
                "is_open": True,
                "marking": "shipping",
                "length": 0.28,
                "width": 0.36,
                "height": 0.2,
            },
            {"form": "tall", "sx": 0.34, "sy": 0.36, "h": 0.66, "title": "MOVING"},
            {"form": "flat", "sx": 0.36, "sy": 0.5, "h": 0.09, "title": "PARCEL"},
            {"form": "lidded", "sx": 0.34, "sy": 0.42, "h": 0.27},
            {"form": "tall", "sx": 0.34, "sy": 0.36, "h": 0.66, "title": "KITCHEN"},
        ],
    ),
    "laundry_basket": Maker(
        laundry_basket,
        laundry_basket_random,
        7,
        [
            {**_SLOTS, "colour": "#f2f2ef"},
            {"style": "wicker", "colour": "#c09558", "width": 0.55, "height": 0.3, "seed": 6},
            {**_SLOTS, "colour": "#7fb4d0"},
            {
                "form": "round",
                "style": "wicker",
                "radius": 0.2,
                "height": 0.55,
                "taper": 0.8,
                "colour": "#a87a48",
            },
            {"form": "frame", "sx": 0.36, "sy": 0.42, "height": 0.6, "colour": "#e8e2d4"},
            {
                "form": "round",
                "style": "popup",
                "radius": 0.19,
                "height": 0.5,
                "taper": 1.0,
                "colour": "#5fa88a",
            },
            {
                "form": "round",
                "style": "tub",
                "radius": 0.23,
                "height": 0.3,
                "taper": 0.8,
                "colour": "#c84a8a",
            },
        ],
    ),
}
