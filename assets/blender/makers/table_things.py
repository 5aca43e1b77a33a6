"""Flat and small things of a table: pens in a cup, place mat, coaster."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import Material, blend, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    rectangle,
    round_polygon,
)
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import (
    TAU,
    box,
    lathe,
)

from makers.projection import project_label


def pen_cup(radius: float, height: float, colour: str, mesh_metal: bool, seed: int) -> Model:
    """A cup full of pens, pencils and a ruler."""
    rng = np.random.default_rng(seed)
    wall = 0.005
    out = metal("5a5f66", "2c2f33", (9, 9, 9), 160) if mesh_metal else plain(colour, 0.04)
    profile = [
        (0, 0),
        (radius, 0),
        (radius, height),
        (radius - wall, height),
        (radius - wall, height * 0.6),
        (0, height * 0.6),
    ]
    cup = lathe(
        profile, 18, mats=[out, plain(shade(colour, 0.5), 0.02)], mat_of_segment=[0, 0, 0, 1, 1]
    )
    meshes = [cup]
    colours = ["#d8303a", "#2f6fc0", "#f2b92c", "#2f9a5a", "#26282c", "#e87a2c"]
    for k in range(6):
        a = TAU * k / 6 + float(rng.normal(0, 0.15))
        tall = float(rng.uniform(0.145, 0.175))
        if k % 2:
            shape = [(0, 0), (0.0038, 0), (0.0038, tall - 0.018), (0.0010, tall - 0.002), (0, tall)]
            stick = lathe(
                shape,
                6,
                mats=[plain(colours[k], 0.02), plain("#e2bd88", 0.05)],
                mat_of_segment=[0, 0, 1, 1],
            )
        else:
            shape = [
                (0, 0),
                (0.0045, 0),
                (0.0045, tall - 0.05),
                (0.0056, tall - 0.05),
                (0.005, tall),
                (0, tall),
            ]
            stick = lathe(
                shape,
                7,
                mats=[plain("#f0f0ee", 0.0), plain(colours[k], 0.02)],
                mat_of_segment=[0, 0, 1, 1, 1],
            )
        lean = float(rng.uniform(0.1, 0.22))
        meshes.append(
            stick.turn(ry=lean).move(-0.1 * math.sin(lean) + radius * 0.55, 0, 0.006).turn(rz=a)
        )
    ruler = (
        box(0.004, 0.024, 0.2, (0, 0, 0), plain("#e9cf7a", 0.05))
        .turn(rx=-0.1)
        .move(-0.008, -0.004, 0.006)
    )
    pieces = [
        cylinder_piece(radius, 0, height, 12),
        cylinder_piece(radius * 0.6, height, 0.17, 8, radius * 0.9),
    ]
    return Model(
        "cup of pens",
        {"body": Part([*meshes, ruler], collision=pieces)},
        mass=0.22,
        texture_size=128,
    )


def pen_cup_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.036, 0.042),
        "height": uniform(rng, 0.095, 0.105),
        "colour": pick(rng, ["#2f7f8f", "#e8e2d4", "#c8402c"]),
        "mesh_metal": False,
        "seed": seed_of(rng),
    }


def placemat(size: tuple[float, float], colours: list[str], pattern: str, is_round: bool) -> Model:
    """A cloth place mat, quite flat."""
    cloth = printed(prints.woven(colours, pattern))
    thick, edge = 0.005, plain(colours[1], 0.08, 150)
    if is_round:
        r = size[0] / 2
        mat = lathe(
            [(0, 0), (r, 0), (r, thick - 0.001), (r - 0.004, thick), (0, thick)], 28, mats=[edge]
        )
        whole, polygon = cylinder_piece(r, 0, thick, 16), round_polygon(r - 0.01)
    else:
        mat = box(size[0], size[1], thick, (0, 0, 0), edge, 0.002)
        whole, polygon = (
            box_piece((0, 0, thick / 2), (*size, thick)),
            rectangle(size[0] - 0.02, size[1] - 0.02),
        )
    project_label(mat, cloth, "+z", (0, 0), (size[1], size[0]), 0.9)
    return Model(
        "place mat",
        {"body": Part([mat], collision=[whole])},
        mass=0.12,
        friction=0.8,
        supports=[Support("top", thick, polygon)],
    )


def placemat_random(rng: np.random.Generator) -> dict:
    return {
        "size": (uniform(rng, 0.29, 0.33), uniform(rng, 0.4, 0.46)),
        "colours": ["#f2ecdc", "#3a6a9c", "#c8402c"],
        "pattern": "check",
        "is_round": False,
    }


def coaster(size: float, kind: str, light: str, dark: str) -> Model:
    """A drinks coaster: a ring-stained cork disc or a square tile."""
    if kind == "cork":
        m = Material()
        grains = m.voronoi(420)
        m.colour(
            m.mix(
                m.remap(m.noise(90, 3), 0.35, 0.65, 0, 0.4),
                m.ramp(grains, [(0, dark), (0.35, light), (1, blend(light, "#ffffff", 0.2))]),
                light,
            )
        )
        r = size / 2
        disc = lathe(
            [
                (0, 0),
                (r, 0),
                (r, 0.006),
                (r - 0.002, 0.0075),
                (r * 0.86, 0.0075),
                (r * 0.84, 0.0065),
                (0, 0.0065),
            ],
            24,
            mat=m,
        )
        whole, polygon = cylinder_piece(r, 0, 0.0075, 14), round_polygon(r - 0.01)
        mesh, z = disc, 0.0075
    else:
        tile = printed(prints.woven([light, dark, blend_hex(light, dark)], "diamonds"))
        mesh, z = (
            box(
                size,
                size,
                0.008,
                (0, 0, 0),
                plain(dark, 0.03),
                0.002,
                labels={"+z": (tile, (0, 0, 0.5, 0.5))},
            ),
            0.008,
        )
        whole, polygon = (
            box_piece((0, 0, 0.004), (size, size, 0.008)),
            rectangle(size - 0.02, size - 0.02),
        )
    return Model(
        "coaster",
        {"body": Part([mesh], collision=[whole])},
        mass=0.05,
        supports=[Support("top", z, polygon)],
        texture_size=128,
    )


def coaster_random(rng: np.random.Generator) -> dict:
    return {
        "size": uniform(rng, 0.092, 0.105),
        "kind": "cork",
        "light": "#c99a62",
        "dark": "#6a4526",
    }


def blend_hex(a: str, b: str) -> str:
    """The colour halfway between two, as text."""
    return "#" + "".join(f"{int(255 * c):02x}" for c in blend(a, b, 0.5))


MODELS = {
    "pen_cup": Maker(pen_cup, pen_cup_random, 2, [{}, {"mesh_metal": True}]),
    "placemat": Maker(
        placemat,
        placemat_random,
        3,
        [
            {},
            {"pattern": "stripes", "colours": ["#d9c7a2", "#7a5a34", "#a8402c"]},
            {
                "is_round": True,
                "size": (0.36, 0.36),
                "pattern": "leaves",
                "colours": ["#8fb8a0", "#f4f0e0", "#3f6a4c"],
            },
        ],
    ),
    "coaster": Maker(
        coaster, coaster_random, 2, [{}, {"kind": "tile", "light": "#eef2f0", "dark": "#2f5f8a"}]
    ),
}
