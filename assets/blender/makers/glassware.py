"""Drinking glasses."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    cylinder_piece,
    ring_pieces,
)
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import lathe

from makers.breakage import BROKEN, broken, wall_seeds


def drinking_glass(
    radius=0.034, height=0.12, taper=0.82, tint="#dcebef", water=0.0, seed=0
) -> Model:
    """A tumbler; what is behind shows through it. water: filled share of the height."""
    t, foot, bottom = 0.003, radius * taper, 0.012
    m = Material(occlusion=0.35)
    z = m.remap(m.axis(2), 0, height)
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.45)), 0.0, 0.12, 0.75, 0)
    rimmed = [
        (0, shade(tint, 0.72)),
        (0.09, shade(tint, 0.86)),
        (0.14, tint),
        (0.93, tint),
        (0.985, "ffffff"),
        (1, "ffffff"),
    ]
    m.colour(m.mix(shine, m.ramp(z, rimmed), "ffffff"))
    profile = [
        (0, 0.0015),
        (foot * 0.9, 0),
        (foot, 0.003),
        (radius, height - 0.0015),
        (radius - t / 2, height),
    ]
    profile += [
        (radius - t, height - 0.0015),
        (foot - t, bottom + 0.003),
        (foot - t - 0.004, bottom),
        (0, bottom),
    ]
    pieces = [cylinder_piece(foot, 0, bottom)]
    pieces += ring_pieces([(foot, 0), (radius, height)], [(foot - t, 0), (radius - t, height)])
    clear = (1, 1, 1, 0.5)
    parts = {"body": Part([lathe(profile, 24, mat=m)], rgba=clear, collision=pieces)}
    seeds = wall_seeds(radius, height, 6, np.random.default_rng(seed))
    splinters = plain("f2fafb", 0.0, occlusion=0.2)
    parts["shards"] = broken(
        [lathe(profile, 16, mat=m)],
        splinters,
        seeds,
        (0.3 * radius) ** 2,
        seed,
        (1, 1, 1, 0.62),
        edge=0.03,
    )
    if water:
        top = bottom + (height - bottom) * water
        r_top = foot + (radius - foot) * top / height - t - 0.0005
        w = Material(occlusion=0.2)
        glint = w.remap(w.distance((0, 0, top)), r_top * 0.75, r_top, 0, 0.8)
        w.colour(w.mix(glint, "b9d4de", "f4fafc"))
        fill = [(0, bottom + 0.001), (foot - t - 0.001, bottom + 0.001), (r_top, top), (0, top)]
        parts["liquid"] = Part([lathe(fill, 20, mat=w)], rgba=(1, 1, 1, 0.7), collision="none")
    return Model(
        title="glass of water" if water else "drinking glass",
        parts=parts,
        mass=0.25,
        texture_size=128,
        variants={"default": [n for n in parts if n != "shards"], "broken": ["shards"]},
        states=BROKEN,
        containers=[
            Container(
                "inside",
                (0, 0, (height + bottom) / 2),
                (foot * 1.2, foot * 1.2, height - bottom - 0.004),
            )
        ],
    )


def drinking_glass_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.032, 0.04),
        "height": uniform(rng, 0.095, 0.145),
        "taper": uniform(rng, 0.74, 0.95),
        "tint": pick(rng, ["#dcebef", "#d5e6e0", "#e2e6ee"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "drinking_glass": Maker(
        drinking_glass,
        drinking_glass_random,
        count=3,
        presets=[{}, {"water": 0.65}, {"tint": "#bfd9e6"}],
    ),
}
