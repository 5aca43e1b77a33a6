"""Cleaners: trigger bottle, bleach, washing-up liquid."""

from __future__ import annotations

import numpy as np
from labels import bottles
from toolkit.materials import label as printed
from toolkit.materials import plain
from toolkit.model import (
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    lathe,
    spline,
    tube,
)

from makers.bottle_shapes import cap, oval_body
from makers.projection import project_label
from makers.vessels import trigger_head


def spray_cleaner(
    height: float,
    width: float,
    body: str,
    paper: str,
    band: str,
    accent: str,
    ink: str,
    head: str,
    trigger: str,
    brand: str,
    kind: str,
) -> Model:
    """A trigger bottle: label on both broad faces, the nozzle to the left of the label."""
    s = height / 0.26
    plastic = plain(body, 0.03)
    label = printed(bottles.cleaner_label(brand, kind, paper, band, accent, ink), base=body)
    steps = [
        (0, 0.9, 0.88),
        (0.004, 1, 1),
        (0.075, 1, 1),
        (0.105, 0.96, 0.95),
        (0.13, 0.85, 0.86),
        (0.15, 0.68, 0.72),
        (0.164, 0.45, 0.58),
        (0.172, 0.32, 0.54),
        (0.185, 0.3, 0.52),
    ]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], width, 0.056, plastic, 3.0).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle,
            label,
            side,
            (0, 0.072 * s),
            (width * 0.86, 0.125 * s),
            0.3,
            lambda c: 0.004 * s < c[2] < 0.14 * s and abs(c[1]) < 0.42 * width,
        )
    neck = 0.185 * s
    head_meshes = trigger_head(neck, head, trigger)
    pieces = [
        box_piece((0, 0, 0.065 * s), (0.054, width * 0.96, 0.13 * s)),
        box_piece((0, 0, 0.157 * s), (0.036, width * 0.55, 0.056 * s)),
        box_piece((0, -0.01, neck + 0.04), (0.026, 0.1, 0.046)),
    ]
    part = Part([bottle, *head_meshes], collision=pieces)
    return Model(f"trigger bottle of {kind.lower()}", {"body": part}, mass=0.55, friction=0.5)


def spray_cleaner_random(rng: np.random.Generator) -> dict:
    body, paper, accent, ink = pick(
        rng,
        [
            ("#2f7fd8", "#dff0ff", "#1f5fc4", "#16305c"),
            ("#f4f4f2", "#d8f0fb", "#1b9ad6", "#0c4a6a"),
            ("#f0d21e", "#f7ffe8", "#2d9a48", "#14622a"),
            ("#e9e4f4", "#f6eefc", "#7b3fb5", "#3a1a5c"),
        ],
    )
    return {
        "height": uniform(rng, 0.235, 0.28),
        "width": uniform(rng, 0.085, 0.1),
        "body": body,
        "paper": paper,
        "accent": accent,
        "ink": ink,
        "band": pick(rng, ["#d4202c", "#143a8c", "#e2661a"]),
        "head": pick(rng, ["#f5f5f5", "#d8262e", "#1f4fa8"]),
        "trigger": pick(rng, ["#d8262e", "#f08a1c", "#2f9a48"]),
        "brand": pick(rng, ["BRIZZO", "Klarenta", "SPLAZH", "Zappli"]),
        "kind": pick(rng, ["GLASS CLEANER", "MULTI SURFACE", "BATHROOM", "KITCHEN"]),
    }


def bleach_bottle(height: float, body: str, band: str, accent: str, lid: str, brand: str) -> Model:
    """A bottle with a moulded handle hole's loop at its side and a big ribbed cap."""
    s = height / 0.27
    plastic = plain(body, 0.03)
    label = printed(bottles.bleach_label(brand, "#ffffff", band, accent), base=body)
    steps = [
        (0, 0.88, 0.86),
        (0.005, 1, 1),
        (0.135, 1, 1),
        (0.16, 0.94, 0.92),
        (0.185, 0.72, 0.76),
        (0.21, 0.42, 0.56),
        (0.225, 0.3, 0.44),
        (0.24, 0.3, 0.44),
    ]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.105, 0.07, plastic, 3.4).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle,
            label,
            side,
            (0, 0.075 * s),
            (0.09, 0.125 * s),
            0.3,
            lambda c: 0.004 * s < c[2] < 0.15 * s and abs(c[1]) < 0.046,
        )
    handle = tube(
        spline(
            [
                (0, 0.034, 0.205 * s),
                (0, 0.052, 0.2 * s),
                (0, 0.057, 0.17 * s),
                (0, 0.05, 0.145 * s),
            ],
            3,
        ),
        0.0085,
        8,
        mat=plastic,
        up=(1, 0, 0),
    )
    lid_mesh = cap(0.021, 0.233 * s, 0.037 * s, plain(lid, 0.02))
    pieces = [
        box_piece((0, 0, 0.085 * s), (0.068, 0.103, 0.17 * s)),
        cylinder_piece(0.038, 0.17 * s, 0.23 * s, 10, 0.022),
        cylinder_piece(0.02, 0.23 * s, 0.27 * s, 10),
    ]
    part = Part([bottle, handle, lid_mesh], collision=pieces)
    return Model("bottle of bleach", {"body": part}, mass=1.05, friction=0.5)


def bleach_bottle_random(rng: np.random.Generator) -> dict:
    body, band, lid = pick(
        rng,
        [
            ("#f6f6f2", "#1f4fa8", "#1f4fa8"),
            ("#f2cf2a", "#c4202c", "#c4202c"),
            ("#2a62b8", "#16305c", "#f5f5f5"),
        ],
    )
    return {
        "height": uniform(rng, 0.25, 0.29),
        "body": body,
        "band": band,
        "accent": pick(rng, ["#c4202c", "#1c1c20"]),
        "lid": lid,
        "brand": pick(rng, ["Blanqo", "Javelin", "Purexa"]),
    }


def dish_soap(height: float, liquid: str, band: str, fruit: str, lid: str, brand: str) -> Model:
    """A waisted bottle of coloured washing-up liquid with a push-pull cap."""
    s = height / 0.23
    liquid_mat = plain(liquid, 0.04, 30)
    label = printed(bottles.dish_soap_label(brand, "#fbfce8", band, fruit), base=liquid)
    steps = [
        (0, 0.86, 0.84),
        (0.005, 1, 1),
        (0.05, 0.97, 0.98),
        (0.09, 0.86, 0.92),
        (0.125, 0.9, 0.94),
        (0.155, 0.82, 0.86),
        (0.175, 0.5, 0.6),
        (0.186, 0.36, 0.46),
    ]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.078, 0.046, liquid_mat, 2.6).weigh(
        1.2
    )
    for side in ("+x", "-x"):
        project_label(
            bottle,
            label,
            side,
            (0, 0.08 * s),
            (0.066, 0.13 * s),
            0.3,
            lambda c: 0.004 * s < c[2] < 0.16 * s and abs(c[1]) < 0.036,
        )
    top = plain(lid, 0.02)
    z = 0.183 * s
    spout = lathe(
        [
            (0, z),
            (0.016, z),
            (0.0155, z + 0.014),
            (0.009, z + 0.018),
            (0.0085, z + 0.032),
            (0.011, z + 0.034),
            (0.0105, z + 0.041),
            (0, z + 0.043),
        ],
        14,
        mat=top,
    )
    pieces = [
        box_piece((0, 0, 0.08 * s), (0.042, 0.07, 0.16 * s)),
        cylinder_piece(0.016, 0.16 * s, z + 0.043, 10, 0.01),
    ]
    part = Part([bottle, spout], collision=pieces)
    return Model("washing-up liquid", {"body": part}, mass=0.52, friction=0.5)


def dish_soap_random(rng: np.random.Generator) -> dict:
    liquid, band, fruit = pick(
        rng,
        [
            ("#8fc83a", "#2c8f4a", "#c8d838"),
            ("#f2c52a", "#e2762a", "#f2d23a"),
            ("#3aa0d8", "#1f5fa8", "#f08a3c"),
        ],
    )
    return {
        "height": uniform(rng, 0.21, 0.25),
        "liquid": liquid,
        "band": band,
        "fruit": fruit,
        "lid": pick(rng, ["#f5f5f5", "#e2402c", "#1f5fa8"]),
        "brand": pick(rng, ["Plinka", "Tellora", "Glanzy"]),
    }
