"""Bottles of water, wine and beer."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, metal, plain, shade
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import lathe


def repeated(draw_one, width=768, height=256, fill="#ffffff"):
    """A wrap-round label with its front (u = 0.5) and back alike."""
    image, d = labels.canvas(width, height, fill)
    for cx in (0, width // 2, width):
        draw_one(d, cx, height)
    return image


def shiny(colour, height: float, strength=0.7, dark=0.6, low_colour=None, level=None) -> Material:
    """Glass or PET: dark to the edges, vertical reflections painted in."""
    m = Material(occlusion=0.3)
    base = m.mix(m.remap(m.axis(2), 0, height * 0.12), shade(colour, dark), colour)
    if level is not None:  # filled up to here
        base = m.mix(m.remap(m.axis(2), level - 0.001, level + 0.001), base, low_colour)
    for direction, width, share in ((-0.45, 0.09, strength), (0.75, 0.05, strength * 0.6)):
        line = m.math("ABSOLUTE", m.math("SUBTRACT", m.normal(1), direction))
        front = m.remap(m.normal(0), 0, 0.1)
        base = m.mix(
            m.math("MULTIPLY", m.remap(line, width * 0.4, width, share, 0), front), base, "ffffff"
        )
    return m.colour(base)


def water_bottle(
    radius=0.032,
    height=0.22,
    tint="#bcdcea",
    band="#2a6fc4",
    brand="AQUELLA",
    cap="#2a6fc4",
    seed=0,
) -> Model:
    """A PET bottle with ribs and a paper band."""

    def print_one(d, cx, h):
        labels.text(d, brand, (cx - 150, h * 0.12, cx + 150, h * 0.5), "oblique", "#ffffff")
        labels.text(d, "NATURAL WATER", (cx - 120, h * 0.54, cx + 120, h * 0.68), "bold", "#dff1ff")
        points = [
            (cx - 110, h),
            (cx - 60, h * 0.74),
            (cx - 20, h * 0.88),
            (cx + 30, h * 0.7),
            (cx + 110, h),
        ]
        d.polygon(points, fill="#ffffff")

    r, h = radius, height
    wrap = label(repeated(print_one, fill=band), occlusion=0.6)
    pet = shiny(tint, h, 0.8, 0.8, "e6f3f8", h * 0.82)
    z0, z1 = h * 0.4, h * 0.64
    profile = [(0, 0.004), (r * 0.6, 0.004), (r * 0.8, 0), (r, 0.008)]
    for k in range(3):
        z = 0.02 + k * (z0 - 0.03) / 3
        profile += [(r, z), (r * 0.93, z + 0.006), (r, z + 0.012)]
    profile += [
        (r, z0),
        (r * 1.01, z0),
        (r * 1.01, z1),
        (r, z1),
        (r * 0.97, h * 0.7),
        (r * 0.82, h * 0.79),
        (r * 0.5, h * 0.87),
        (r * 0.4, h * 0.9),
        (r * 0.4, h * 0.93),
    ]
    paper = profile.index((r * 1.01, z0))
    mats = [1 if k == paper else 0 for k in range(len(profile))]
    body = lathe(
        profile, 17, mats=[pet, wrap], mat_of_segment=mats, label_z=(z0, z1), start=-math.pi
    )
    top = [(0, h * 0.92), (r * 0.46, h * 0.92), (r * 0.46, h * 0.985), (r * 0.42, h), (0, h)]
    lid = lathe(
        top, 16, mat=plain(cap, 0.02), rib=lambda k, i: 1 - 0.05 * (i % 2) if k in (1, 2) else 1
    )
    pieces = [cylinder_piece(r, 0, h * 0.75), cylinder_piece(r * 0.95, h * 0.75, h, 10, r * 0.45)]
    return Model(
        title="bottle of water",
        parts={
            "body": Part([body], collision=pieces),
            "cap": Part([lid], collision="none", occlusion="fixed"),
        },
        mass=0.52,
        friction=0.4,
    )


def water_bottle_random(rng: np.random.Generator) -> dict:
    band = pick(rng, ["#2a6fc4", "#2f9a6a", "#d8486a"])
    return {
        "radius": uniform(rng, 0.031, 0.036),
        "height": uniform(rng, 0.2, 0.24),
        "band": band,
        "cap": pick(rng, [band, "#ffffff"]),
        "brand": pick(rng, ["AQUELLA", "Fontis", "BERGQUELL"]),
        "seed": seed_of(rng),
    }


def glass_bottle(
    title, radius, shoulder, neck, height, glass, wrap, band, seal, seal_from, closure, mass
) -> Model:
    """Common shape of wine and beer bottles. shoulder: (start, end) of the curve as heights."""
    r, (z0, z1) = radius, band
    profile = [
        (0, 0.006),
        (r * 0.7, 0.003),
        (r * 0.9, 0),
        (r, 0.004),
        (r, z0),
        (r * 1.008, z0),
        (r * 1.008, z1),
        (r, z1),
        (r, shoulder[0]),
    ]
    for t in (0.25, 0.5, 0.75, 1.0):
        k = 0.5 + 0.5 * math.cos(math.pi * t)
        profile.append((neck + (r - neck) * k, shoulder[0] + (shoulder[1] - shoulder[0]) * t))
    profile += [
        (neck, seal_from),
        (neck * 1.03, seal_from),
        (neck * 0.98, height - 0.012),
        (neck * 1.12, height - 0.011),
        (neck * 1.12, height - 0.003),
        (neck * 0.95, height),
        (0, height),
    ]
    seal_at = profile.index((neck * 1.03, seal_from))
    mats = [1 if k == 5 else 2 if k >= seal_at - 1 else 0 for k in range(len(profile))]
    body = lathe(
        profile, 19, mats=[glass, wrap, seal], mat_of_segment=mats, label_z=(z0, z1), start=-math.pi
    )
    pieces = [
        cylinder_piece(r, 0, shoulder[0]),
        cylinder_piece(r, shoulder[0], shoulder[1], 10, neck),
        cylinder_piece(neck * 1.1, shoulder[1], height, 8),
    ]
    return Model(
        title=title,
        parts={"body": Part([body, *closure], collision=pieces)},
        mass=mass,
        friction=0.4,
    )


def wine_bottle(
    kind="red", height=0.3, radius=0.0375, paper="#f3ead2", accent="#7a1326", name="Castell", seed=0
) -> Model:
    def print_one(d, cx, h):
        d.rectangle((cx - 135, 6, cx + 135, h - 6), outline=accent, width=5)
        labels.text(d, name, (cx - 115, h * 0.08, cx + 115, h * 0.34), "italic", accent)
        d.polygon(
            [
                (cx - 50, h * 0.66),
                (cx - 50, h * 0.46),
                (cx - 20, h * 0.46),
                (cx - 20, h * 0.38),
                (cx + 20, h * 0.38),
                (cx + 20, h * 0.46),
                (cx + 50, h * 0.46),
                (cx + 50, h * 0.66),
            ],
            fill=accent,
        )
        labels.text(
            d,
            "RED WINE" if kind == "red" else "WHITE WINE",
            (cx - 110, h * 0.7, cx + 110, h * 0.84),
            "serif",
            "#333333",
        )
        labels.small_print(d, (cx - 70, h * 0.88, cx + 70, h * 0.96), 2, "#888888")

    colour = "#1c2a1c" if kind == "red" else "#8f9f4a"
    return glass_bottle(
        f"bottle of {kind} wine",
        radius,
        (height * 0.6, height * 0.74),
        radius * 0.37,
        height,
        shiny(colour, height, 0.6),
        label(repeated(print_one, fill=paper)),
        (height * 0.16, height * 0.48),
        plain(accent, 0.05),
        height * 0.8,
        [],
        1.25,
    )


def wine_bottle_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.29, 0.315),
        "radius": uniform(rng, 0.036, 0.039),
        "name": pick(rng, ["Castell", "Montegra", "Rebenhof"]),
        "seed": seed_of(rng),
    }


def beer_bottle(
    height=0.235,
    radius=0.0305,
    glass="#5a2c0e",
    paper="#f0e2b8",
    accent="#1f5a2c",
    name="Dorfbräu",
    seed=0,
) -> Model:
    def print_one(d, cx, h):
        d.ellipse((cx - 130, h * 0.04, cx + 130, h * 0.96), fill=accent)
        d.ellipse((cx - 118, h * 0.09, cx + 118, h * 0.91), outline="#f4d35a", width=5)
        labels.text(d, name, (cx - 105, h * 0.3, cx + 105, h * 0.58), "italic", "#ffffff")
        labels.text(d, "BEER", (cx - 60, h * 0.62, cx + 60, h * 0.8), "bold", "#f4d35a")

    crown = metal("d8b23a", "8a6a1c")
    rim = radius * 0.46
    top = [
        (0, height - 0.004),
        (rim, height - 0.005),
        (rim * 0.96, height - 0.001),
        (rim * 0.75, height + 0.001),
        (0, height + 0.001),
    ]
    cap = lathe(top, 12, mat=crown, rib=lambda k, i: 1 + 0.06 * (i % 2) if k == 1 else 1)
    wrap = label(repeated(print_one, fill=paper))
    foil = plain(accent, 0.05)
    return glass_bottle(
        "beer bottle",
        radius,
        (height * 0.52, height * 0.72),
        radius * 0.42,
        height,
        shiny(glass, height, 0.6),
        wrap,
        (height * 0.15, height * 0.43),
        foil,
        height * 0.8,
        [cap],
        0.85,
    )


def beer_bottle_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.225, 0.25),
        "radius": uniform(rng, 0.0295, 0.0325),
        "seed": seed_of(rng),
    }


MODELS = {
    "water_bottle": Maker(water_bottle, water_bottle_random, count=2),
    "wine_bottle": Maker(
        wine_bottle,
        wine_bottle_random,
        count=2,
        presets=[{"kind": "red"}, {"kind": "white", "accent": "#1f4f5a"}],
    ),
    "beer_bottle": Maker(
        beer_bottle,
        beer_bottle_random,
        count=2,
        presets=[{}, {"glass": "#1f4a24", "accent": "#a3202c", "name": "Nordstern"}],
    ),
}
