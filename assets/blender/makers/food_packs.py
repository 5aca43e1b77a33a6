"""Packed food: juice, cereal, tins, butter."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import label, metal, plain
from toolkit.model import (
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, extrude, lathe, rounded_rectangle


def orange_slice(draw, cx, cy, r, peel="#f08a12", flesh="#ffb83a") -> None:
    draw.ellipse((cx - r, cy - r, cx + r, cy + r), fill=peel)
    draw.ellipse((cx - r * 0.88, cy - r * 0.88, cx + r * 0.88, cy + r * 0.88), fill="#fff3d8")
    for k in range(8):
        draw.pieslice(
            (cx - r * 0.8, cy - r * 0.8, cx + r * 0.8, cy + r * 0.8),
            45 * k + 4,
            45 * k + 41,
            fill=flesh,
        )


def juice_front(w, h, fruit, colour, dark, brand):
    image, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.16), fill=dark)
    labels.text(d, brand, (w * 0.08, h * 0.03, w * 0.92, h * 0.14), "oblique")
    labels.text(d, fruit, (w * 0.06, h * 0.2, w * 0.94, h * 0.33), "bold", "#ffffff", 3, dark)
    labels.text(d, "100% JUICE", (w * 0.2, h * 0.35, w * 0.8, h * 0.41), "bold", dark)
    if fruit == "APPLE":
        d.ellipse((w * 0.18, h * 0.5, w * 0.6, h * 0.86), fill="#c3262c")
        d.ellipse((w * 0.42, h * 0.5, w * 0.84, h * 0.86), fill="#d63a34")
        d.ellipse((w * 0.3, h * 0.54, w * 0.42, h * 0.62), fill="#f3b0a0")
        d.line((w * 0.52, h * 0.54, w * 0.58, h * 0.44), fill="#4a2c14", width=8)
        d.ellipse((w * 0.58, h * 0.43, w * 0.8, h * 0.5), fill="#3f8a2c")
    else:
        orange_slice(d, w * 0.38, h * 0.66, w * 0.3)
        orange_slice(d, w * 0.7, h * 0.8, w * 0.22)
        d.ellipse((w * 0.55, h * 0.45, w * 0.8, h * 0.52), fill="#3f8a2c")
    d.rectangle((0, h * 0.95, w, h), fill=dark)
    return image


def pack_side(w, h, colour, dark, brand, rng):
    image, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.16), fill=dark)
    labels.text(d, brand, (w * 0.1, h * 0.04, w * 0.9, h * 0.13), "oblique")
    d.rectangle((w * 0.12, h * 0.22, w * 0.88, h * 0.6), fill="#ffffff", outline=dark, width=3)
    labels.small_print(d, (w * 0.17, h * 0.25, w * 0.83, h * 0.58), 9, "#555555", rng)
    labels.barcode(d, (w * 0.22, h * 0.68, w * 0.78, h * 0.82), rng)
    d.rectangle((0, h * 0.95, w, h), fill=dark)
    return image


def screw_cap(radius: float, height: float, colour: str):
    profile = [(0, 0), (radius, 0), (radius, height * 0.85), (radius * 0.85, height), (0, height)]
    return lathe(
        profile,
        16,
        mat=plain(colour, 0.02),
        rib=lambda k, i: 1 - 0.05 * (i % 2) if k in (1, 2) else 1,
    )


def juice_carton(
    width=0.092,
    depth=0.06,
    height=0.195,
    fruit="ORANGE",
    colour="#f6a21c",
    dark="#d8560e",
    brand="Sunny Hof",
    cap="#3f8a2c",
    seed=0,
) -> Model:
    """A long-life brick with a screw cap on its flat top."""
    rng = np.random.default_rng(seed)
    w, h = 220, int(220 * height / width)
    front = label(juice_front(w, h, fruit, colour, dark, brand))
    side = label(pack_side(int(w * depth / width), h, colour, dark, brand, rng))
    faces = {"+x": front, "-x": front, "+y": side, "-y": side}
    body = [
        box(
            depth,
            width,
            height,
            mat=plain(colour, 0.02),
            bevel_width=0.0018,
            labels=faces,
            weight=1.2,
        )
    ]
    flap = plain(dark, 0.02)
    body.append(box(0.01, width * 0.96, 0.0035, (-depth * 0.12, 0, height - 0.0015), flap, 0.001))
    body.append(screw_cap(0.0135, 0.014, cap).move(depth * 0.16, width * 0.2, height - 0.001))
    return Model(
        title=f"{fruit.lower()} juice, long-life carton",
        parts={
            "body": Part(
                body,
                collision=[
                    box_piece((0, 0, height / 2), (depth, width, height)),
                    cylinder_piece(0.0135, 0, 0.014, 8)
                    + np.array([depth * 0.16, width * 0.2, height - 0.001]),
                ],
            )
        },
        mass=1.05,
        friction=0.5,
    )


def juice_carton_random(rng: np.random.Generator) -> dict:
    return {
        "width": uniform(rng, 0.085, 0.097),
        "depth": uniform(rng, 0.056, 0.066),
        "height": uniform(rng, 0.18, 0.225),
        "brand": pick(rng, ["Sunny Hof", "Frutta", "Orchard"]),
        "cap": pick(rng, ["#3f8a2c", "#ffffff", "#d8560e"]),
        "seed": seed_of(rng),
    }


def cereal_front(w, h, name, colour, dark, ring):
    image = labels.gradient(w, h, dark, colour)
    from PIL import ImageDraw

    d = ImageDraw.Draw(image)
    rng = np.random.default_rng(7)
    d.polygon([(0, h * 0.08), (w, h * 0.03), (w, h * 0.3), (0, h * 0.36)], fill="#ffffff")
    labels.text(d, name, (w * 0.05, h * 0.09, w * 0.95, h * 0.3), "oblique", ring, 4, "#2a1a10")
    labels.text(d, "WHOLE GRAIN", (w * 0.1, h * 0.37, w * 0.9, h * 0.42), "bold", "#ffffff")
    d.pieslice((w * 0.06, h * 0.42, w * 0.94, h * 1.02), 0, 180, fill="#2f5fa8")
    d.ellipse((w * 0.06, h * 0.62, w * 0.94, h * 0.82), fill="#fbf8ef", outline="#2f5fa8", width=5)
    for _ in range(34):
        a, q = rng.uniform(0, 2 * math.pi), math.sqrt(rng.uniform(0, 1))
        x, y, s = (
            w * (0.5 + 0.36 * q * math.cos(a)),
            h * (0.71 + 0.072 * q * math.sin(a)),
            w * 0.042,
        )
        d.ellipse(
            (x - s, y - s * 0.8, x + s, y + s * 0.8),
            fill=pick(rng, ["#d9962c", "#c47a1c", "#e8b04a"]),
            outline="#8a5410",
        )
        d.ellipse((x - s * 0.35, y - s * 0.3, x + s * 0.35, y + s * 0.3), fill="#8a5410")
    return image


def cereal_box(
    width=0.19,
    depth=0.06,
    height=0.29,
    name="LOOPS",
    colour="#f2b21c",
    dark="#d8402c",
    ring="#d8402c",
    seed=0,
) -> Model:
    rng = np.random.default_rng(seed)
    w, h = 256, int(256 * height / width)
    front = label(cereal_front(w, h, name, colour, dark, ring))
    side = label(pack_side(int(w * depth / width) + 1, h, colour, dark, name, rng))
    top, d = labels.canvas(180, 60, dark)
    labels.text(d, name, (20, 10, 160, 50), "oblique")
    faces = {"+x": front, "-x": front, "+y": side, "-y": side, "+z": label(top)}
    body = box(depth, width, height, mat=plain(dark, 0.02), bevel_width=0.0015, labels=faces)
    return Model(
        title=f"cereal box, {name.capitalize()}",
        mass=0.42,
        friction=0.5,
        parts={
            "body": Part([body], collision=[box_piece((0, 0, height / 2), (depth, width, height))])
        },
    )


def cereal_box_random(rng: np.random.Generator) -> dict:
    return {
        "width": uniform(rng, 0.17, 0.2),
        "depth": uniform(rng, 0.05, 0.07),
        "height": uniform(rng, 0.25, 0.31),
        "seed": seed_of(rng),
    }


def tin_label(kind, colour, dark, brand, rng):
    w, h = 768, 256
    image, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.1), fill=dark)
    d.rectangle((0, h * 0.9, w, h), fill=dark)
    for cx in (0, w / 2, w):
        labels.text(d, brand, (cx - 110, h * 0.14, cx + 110, h * 0.28), "italic", dark)
        labels.text(d, kind, (cx - 115, h * 0.3, cx + 115, h * 0.48), "bold", "#ffffff", 3, dark)
        for i in range(7):
            x, y, r = cx + (i - 3) * 30, h * (0.68 + 0.05 * (i % 2)), 24
            if kind == "TOMATOES":
                d.ellipse((x - r, y - r, x + r, y + r), fill="#e0362a", outline="#9a1c16", width=2)
                d.ellipse((x - 6, y - r, x + 6, y - r + 9), fill="#3f8a2c")
            elif kind == "CORN":
                d.ellipse(
                    (x - 15, y - r, x + 15, y + r), fill="#f8cf2c", outline="#b8860e", width=2
                )
            else:
                d.ellipse(
                    (x - r, y - 16, x + r, y + 16), fill="#8a3a22", outline="#5a2010", width=2
                )
    for cx in (w / 4, 3 * w / 4):
        labels.small_print(d, (cx - 60, h * 0.2, cx + 60, h * 0.55), 6, "#ffffff", rng)
        labels.barcode(d, (cx - 45, h * 0.62, cx + 45, h * 0.8), rng)
    return image


def canned_food(
    radius=0.037,
    height=0.11,
    kind="TOMATOES",
    colour="#d9482c",
    dark="#7a1712",
    brand="Campo",
    seed=0,
) -> Model:
    rng = np.random.default_rng(seed)
    paper = label(tin_label(kind, colour, dark, brand, rng))
    steel = metal("c6cacd", "868c91", (8, 8, 1), 60, noise_offset(rng))
    r, h = radius, height
    profile = [
        (0, 0.003),
        (r * 0.93, 0.003),
        (r * 0.95, 0),
        (r * 1.015, 0.001),
        (r * 1.015, 0.004),
        (r, 0.006),
        (r, h - 0.006),
    ]
    profile += [
        (r * 1.015, h - 0.004),
        (r * 1.015, h - 0.001),
        (r * 0.95, h),
        (r * 0.93, h - 0.0035),
        (r * 0.6, h - 0.003),
        (r * 0.58, h - 0.0038),
        (0, h - 0.0038),
    ]
    mats = [0] * 5 + [1] + [0] * 7
    body = [
        lathe(
            profile,
            26,
            mats=[steel, paper],
            mat_of_segment=mats,
            label_z=(0.006, h - 0.006),
            start=-math.pi,
        )
    ]
    tab = extrude(rounded_rectangle(0.026, 0.015, 0.006, 3), 0.0022, steel).move(
        r * 0.42, 0, h - 0.0038
    )
    return Model(
        title=f"tin of {kind.lower()}",
        parts={"body": Part([*body, tab], collision=[cylinder_piece(r, 0, h, 14)])},
        mass=0.46,
        friction=0.5,
    )


def canned_food_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.034, 0.042),
        "height": uniform(rng, 0.09, 0.115),
        "brand": pick(rng, ["Campo", "Verde", "La Huerta"]),
        "seed": seed_of(rng),
    }


def butter(
    length=0.1, width=0.065, height=0.04, colour="#e8c84a", dark="#1f4f9c", brand="Hofgut", seed=0
) -> Model:
    """A block of butter in printed foil."""
    top, d = labels.canvas(300, 195, colour)
    d.rectangle((0, 0, 300, 32), fill=dark)
    d.rectangle((0, 163, 300, 195), fill=dark)
    labels.text(d, "BUTTER", (30, 70, 270, 130), "serif", dark)
    labels.text(d, brand, (60, 38, 240, 66), "italic", dark)
    labels.text(d, "250 g", (110, 134, 190, 158), "bold", dark)
    side, d = labels.canvas(300, 120, colour)
    d.rectangle((0, 0, 300, 20), fill=dark)
    labels.text(d, "BUTTER", (60, 36, 240, 96), "serif", dark)
    foil = plain(colour, 0.06, 90)
    faces = {"+z": label(top), "+x": label(side), "-x": label(side)}
    body = box(width, length, height, mat=foil, bevel_width=0.003, labels=faces)
    return Model(
        title="butter",
        parts={
            "body": Part([body], collision=[box_piece((0, 0, height / 2), (width, length, height))])
        },
        mass=0.25,
    )


def butter_random(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}
