"""Bottles of water, and the look of glass."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.model import Model, Part, cylinder_piece
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
