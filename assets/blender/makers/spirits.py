"""Bottles of whisky."""

from __future__ import annotations

import numpy as np
from labels.hazards import front
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick, uniform
from toolkit.shapes import lathe

from makers.bottle_shapes import oval_body
from makers.poisons import both_sides


def amber(drink: str, height: float) -> Material:
    """Clear glass full of spirit nearly to its neck, with an upright reflection."""
    m = Material(occlusion=0.5)
    z = m.remap(m.axis(2), 0, height)
    stops = [(0, shade(drink, 0.55)), (0.05, shade(drink, 0.9)), (0.45, shade(drink, 1.2))]
    stops += [(0.79, drink), (0.81, "dccfb0"), (1, "efe8d8")]
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5)), 0.05, 0.2, 0.5, 0)
    return m.colour(m.mix(shine, m.ramp(z, stops), "ffffff"))


def whisky_bottle(
    height: float, square: bool, drink: str, paper: str, ink: str, accent: str, lid: str, brand: str
) -> Model:
    """A square-shouldered or a round bottle of amber spirit."""
    s = height / 0.26
    steps = [
        (0, 0.93, 0.92),
        (0.005, 1, 1),
        (0.15, 1, 1),
        (0.172, 0.9, 0.92),
        (0.186, 0.5, 0.56),
        (0.198, 0.34, 0.36),
        (0.226, 0.31, 0.33),
    ]
    width, depth = (0.086, 0.08) if square else (0.09, 0.086)
    bottle = oval_body(
        [(z * s, w, d) for z, w, d in steps],
        width,
        depth,
        amber(drink, 0.226 * s),
        5.0 if square else 2.0,
        20,
    ).weigh(1.2)
    label = printed(front(brand, ["WHISKY"], ink, accent, paper), base=drink)
    both_sides(bottle, label, 0.08 * s, width * 0.94, 0.12 * s, 0.47 * width)
    z = 0.218 * s
    top = [(0, z), (0.0165, z), (0.0165, 0.254 * s), (0.0145, 0.26 * s), (0, 0.26 * s)]
    lid_mesh = lathe(top, 14, mat=plain(lid, 0.03))
    pieces = [
        box_piece((0, 0, 0.085 * s), (depth * 0.97, width * 0.97, 0.17 * s)),
        cylinder_piece(0.04, 0.17 * s, 0.196 * s, 10, 0.016),
        cylinder_piece(0.016, 0.196 * s, 0.26 * s, 10),
    ]
    part = Part([bottle, lid_mesh], collision=pieces)
    return Model("bottle of whisky", {"body": part}, mass=1.15, friction=0.4)


def whisky_bottle_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.25, 0.285),
        "brand": pick(rng, ["Glen Torvie", "OLD HERON", "Kilbrae"]),
    }


MODELS = {
    "whisky_bottle": Maker(
        whisky_bottle,
        whisky_bottle_random,
        2,
        [
            {
                "square": True,
                "drink": "#b8620f",
                "paper": "#1c1c20",
                "ink": "#f4ecd8",
                "accent": "#d8b45a",
                "lid": "#1c1c20",
                "brand": "OLD HERON",
            },
            {
                "square": False,
                "drink": "#c8781a",
                "paper": "#f4ead0",
                "ink": "#5a1a14",
                "accent": "#8a1a1a",
                "lid": "#8a1a1a",
                "brand": "Glen Torvie",
            },
        ],
    ),
}
