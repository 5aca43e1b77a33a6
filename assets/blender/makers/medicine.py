"""Medicine bottles and pill boxes."""

from __future__ import annotations

import numpy as np
from labels import bottles
from toolkit.materials import Material, plain
from toolkit.materials import label as printed
from toolkit.model import (
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    TAU,
    box,
    lathe,
)

from makers.bottle_shapes import cap


def amber_with_pills(height: float, offset: tuple[float, float, float]) -> Material:
    """See-through brown plastic, faked: pale pills shine through in the lower part."""
    m = Material(occlusion=0.7)
    stops = [(0, "8f3d06"), (0.08, "c8650f"), (0.5, "d8781a"), (0.9, "e08a2a"), (1, "a9500b")]
    base = m.ramp(m.remap(m.axis(2), 0, height), stops)
    cells = m.voronoi(110, offset)
    pills = m.ramp(cells, [(0, "fbe3b4"), (0.42, "eeb566"), (0.62, "a04c0a"), (1, "8a3d06")])
    level = m.remap(m.axis(2), height * 0.42, height * 0.46, 0.9, 0.0)
    return m.colour(m.mix(level, base, pills))


def medicine_bottle(
    style: str,
    radius: float,
    height: float,
    body: str,
    colour: str,
    accent: str,
    drug: str,
    dose: str,
    count: str,
    brand: str,
    seed: int,
) -> Model:
    """A round pill bottle with a printed band; 'pharmacy' is amber, 'shop' opaque."""
    rng = np.random.default_rng(seed)
    picture = bottles.medicine_label(style, drug, dose, count, brand, colour, accent, rng)
    shoulder = height * 0.74
    glass = (
        amber_with_pills(shoulder, noise_offset(rng)) if style == "pharmacy" else plain(body, 0.03)
    )
    low, high = height * (0.24 if style == "pharmacy" else 0.12), height * 0.64
    r = radius
    profile = [
        (0, 0.0015),
        (r * 0.88, 0),
        (r * 0.98, 0.0012),
        (r, 0.004),
        (r, low),
        (r + 0.0004, low),
        (r + 0.0004, high),
        (r, high),
        (r, shoulder - 0.006),
        (r * 0.8, shoulder + 0.001),
        (r * 0.8, shoulder + 0.004),
    ]
    bottle = lathe(
        profile,
        22,
        mats=[glass, printed(picture)],
        mat_of_segment=[0] * 5 + [1] + [0] * 4,
        label_z=(low, high),
        start=-TAU / 2,
        weight=1.2,
    )
    lid = cap(
        r * 1.05, shoulder + 0.003, height - shoulder - 0.003, plain("#f7f7f4", 0.03), 28, 0.97
    )
    pieces = [cylinder_piece(r, 0, shoulder, 12), cylinder_piece(r * 1.05, shoulder, height, 12)]
    title = f"{'amber' if style == 'pharmacy' else 'plastic'} bottle of pills"
    return Model(title, {"body": Part([bottle, lid], collision=pieces)}, mass=0.06, friction=0.5)


def medicine_bottle_random(rng: np.random.Generator) -> dict:
    return {
        "style": "pharmacy",
        "radius": uniform(rng, 0.022, 0.028),
        "height": uniform(rng, 0.08, 0.105),
        "body": pick(rng, ["#f4f4f0", "#2f7d4f"]),
        "colour": pick(rng, ["#1d4f9c", "#b3202a", "#1f7a4d", "#5b2d8c"]),
        "accent": pick(rng, ["#f2b81e", "#e2583e", "#37a0d8"]),
        "drug": pick(rng, ["AMOXICILLIN", "IBUPROFEN", "PARACETAMOL", "CETIRIZINE"]),
        "dose": pick(rng, ["500 mg", "200 mg", "10 mg"]),
        "count": pick(rng, ["30", "60", "100"]),
        "brand": pick(rng, ["NORMEDA", "Salvira", "HELIOTA"]),
        "seed": seed_of(rng),
    }


def pill_box(length: float, tray: str, lid: str, ink: str, seed: int) -> Model:
    """A weekly box of seven lidded cells; the third is open and shows its tablets."""
    rng = np.random.default_rng(seed)
    width, height, cell = length / 5.4, 0.022, length / 7
    picture = bottles.pill_days(tray, lid, ink)
    body_mat, top_mat = plain(tray, 0.03), printed(picture)
    meshes = [box(width, length, 0.016, (0, 0, 0), body_mat, bevel_width=0.002)]
    open_cell = 2
    for i in range(7):
        y = -length / 2 + cell * (i + 0.5)
        if i == open_cell:
            meshes.append(
                box(width * 0.86, cell * 0.86, 0.0006, (0, y, 0.0157), plain("#e9eef2", 0.02))
            )
            for k in range(3):
                x, dy = (-0.008, 0.0005, 0.008)[k], float(rng.uniform(-0.002, 0.002))
                colour = ["#f4f2ea", "#d8453a", "#f2c53a"][k]
                tablet = [(0, 0), (0.0036, 0), (0.0042, 0.0015), (0.0036, 0.003), (0, 0.003)]
                meshes.append(lathe(tablet, 8, mat=plain(colour, 0.03)).move(x, y + dy, 0.0163))
            flap = box(
                width * 0.94, cell * 0.94, 0.005, (0, 0, 0), plain(lid, 0.03), bevel_width=0.001
            )
            meshes.append(flap.turn(ry=-1.9).move(-width / 2 - 0.004, y, 0.024 + 0.006))
            continue
        rect = (i / 7, 0.0, (i + 1) / 7, 1.0)
        meshes.append(
            box(
                width * 0.97,
                cell * 0.96,
                height - 0.016,
                (0, y, 0.016),
                body_mat,
                0.0015,
                labels={"+z": (top_mat, rect)},
            )
        )
    part = Part(meshes, collision=[box_piece((0, 0, height / 2), (width, length, height))])
    return Model("weekly pill box", {"body": part}, mass=0.06, friction=0.5)


def pill_box_random(rng: np.random.Generator) -> dict:
    tray, lid, ink = pick(
        rng,
        [
            ("#2f7fc0", "#cfe6f6", "#14345c"),
            ("#7a4fb0", "#e6daf4", "#3a1a5c"),
            ("#2f9a6a", "#d3f0e0", "#0f4a2e"),
        ],
    )
    return {
        "length": uniform(rng, 0.165, 0.2),
        "tray": tray,
        "lid": lid,
        "ink": ink,
        "seed": seed_of(rng),
    }


MODELS = {
    "medicine_bottle": Maker(
        medicine_bottle,
        medicine_bottle_random,
        3,
        [
            {},
            {"style": "shop", "body": "#f4f4f0", "colour": "#1f7a4d", "drug": "VITAMIN C"},
            {"colour": "#b3202a"},
        ],
    ),
    "pill_box": Maker(
        pill_box,
        pill_box_random,
        2,
        [
            {"tray": "#2f7fc0", "lid": "#cfe6f6", "ink": "#14345c"},
            {"tray": "#7a4fb0", "lid": "#e6daf4", "ink": "#3a1a5c"},
        ],
    ),
}
