"""Toys: ball, big toy car, bricks, wooden train."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    box,
    ellipsoid,
    extrude,
    lathe,
    spline,
)


def toy_ball(radius: float, style: str, colours: list[str]) -> Model:
    """A play ball: 'beach' (gores meeting at the poles), 'stripe' (band and stars) or 'dots'."""
    width, height = 768, 384
    picture, draw = canvas(width, height, colours[0])
    if style == "beach":
        for i in range(6):
            draw.rectangle(
                (128 * i, 0, 128 * i + 127, height),
                fill=["#f6f4ee", colours[0], "#f6f4ee", colours[1], "#f6f4ee", colours[2]][i],
            )
        draw.rectangle((0, 0, width, 26), fill="#f6f4ee")
        draw.rectangle((0, height - 26, width, height), fill="#f6f4ee")
    elif style == "stripe":
        draw.rectangle((0, 128, width, 256), fill=colours[1])
        draw.rectangle((0, 120, width, 134), fill="#f6f4ee")
        draw.rectangle((0, 250, width, 264), fill="#f6f4ee")
        for i in range(6):
            text(draw, "\u2605", (128 * i + 20, 140, 128 * i + 108, 244), "sans", colours[2])
    else:
        for j in range(4):
            for i in range(8):
                x, y = 96 * i + 48 * (j % 2) + 24, 60 + 88 * j
                draw.ellipse(
                    (x - 28, y - 24, x + 28, y + 24),
                    fill=[colours[1], "#f6f4ee", colours[2]][(i + j) % 3],
                )
    ball = ellipsoid(radius, (0, 0, radius), 20, 12, printed(picture))
    ball.turn(0.45, 0.3, 0.2, pivot=(0, 0, radius))
    shell = [ellipsoid(radius, (0, 0, radius), 8, 5).v]
    return Model("toy ball", {"body": Part([ball], collision=shell)}, mass=0.15, friction=0.6)


def toy_ball_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.09, 0.11),
        "style": "beach",
        "colours": pick(
            rng, [["#d8303a", "#2f6fc0", "#f2c52a"], ["#e8862c", "#2f9a5a", "#3f7fd0"]]
        ),
    }


def _wheel(
    radius: float, width: float, tyre: Material, hub: Material, side: int, n: int = 14
) -> Mesh:
    """A wheel about the y axis, centred on the origin; its hub shows on one side (+1: +Y)."""
    w = width / 2
    profile = [
        (0, -w),
        (radius * 0.97, -w),
        (radius, -w * 0.7),
        (radius, w * 0.5),
        (radius * 0.9, w),
        (radius * 0.55, w),
        (0, w * 0.8),
    ]
    wheel = lathe(profile, n, mats=[tyre, hub], mat_of_segment=[0, 0, 0, 0, 0, 1])
    return wheel.turn(rx=-side * math.pi / 2)


def toy_car(kind: str, length: float, paint: str, second: str, hub: str) -> Model:
    """A big plastic vehicle, 'truck' (tipper) or 'car'; it drives towards +X."""
    s = length / 0.28
    body, dark, glass = plain(paint, 0.03), plain("#26282b", 0.05), plain("#9cc9e2", 0.04, 20)
    tyre, cap = plain("#232326", 0.06, 120), plain(hub, 0.03)
    lamp, red = plain("#fff3b8", 0.0), plain("#c8242c", 0.0)
    meshes: list[Mesh] = []
    if kind == "truck":
        tip = plain(second, 0.03)
        meshes.append(box(0.27, 0.1, 0.022, (0, 0, 0.034), dark, 0.004))
        cabin = [(0.045, 0.052), (0.135, 0.052), (0.135, 0.098), (0.112, 0.148), (0.045, 0.148)]
        meshes.append(extrude(cabin, 0.124, mat=body, axis="y", bevel_width=0.005))
        meshes.append(
            extrude(
                [(0.062, 0.1), (0.118, 0.1), (0.105, 0.137), (0.062, 0.137)],
                0.127,
                mat=glass,
                axis="y",
            )
        )
        meshes.append(box(0.003, 0.098, 0.04, (0, 0, 0), glass).turn(ry=-0.43).move(0.1335, 0, 0.1))
        hopper = [(0.035, 0.066), (0.045, 0.138), (-0.15, 0.138), (-0.138, 0.066)]
        meshes.append(
            extrude(
                [(0.03, 0.06), (0.035, 0.07), (-0.136, 0.07), (-0.132, 0.06)],
                0.118,
                mat=tip,
                axis="y",
            )
        )
        for q in (-1, 1):
            meshes.append(
                extrude(hopper, 0.008, mat=tip, axis="y", bevel_width=0.0015).move(y=q * 0.06)
            )
            for x in (-0.1, -0.05, 0.0):
                meshes.append(box(0.01, 0.006, 0.062, (x, q * 0.065, 0.07), tip))
            meshes.append(box(0.005, 0.022, 0.018, (0.1355, q * 0.042, 0.062), lamp, 0.002))
        meshes.append(box(0.008, 0.12, 0.07, (0.0, 0, 0), tip).turn(ry=0.13).move(0.037, 0, 0.068))
        meshes.append(
            box(0.008, 0.12, 0.07, (0.0, 0, 0), tip).turn(ry=-0.16).move(-0.139, 0, 0.068)
        )
        meshes.append(box(0.016, 0.12, 0.018, (0.14, 0, 0.038), dark, 0.003))
        axles, radius, track = (0.092, -0.088), 0.037, 0.06
        pieces = [
            box_piece((0.09, 0, 0.095), (0.1, 0.126, 0.11)),
            box_piece((-0.055, 0, 0.1), (0.19, 0.126, 0.076)),
            box_piece((0, 0, 0.03), (0.26, 0.12, 0.06)),
        ]
    else:
        side = spline(
            [
                (-0.14, 0.03),
                (-0.142, 0.062),
                (-0.128, 0.078),
                (-0.085, 0.083),
                (0.055, 0.08),
                (0.125, 0.066),
                (0.142, 0.05),
                (0.14, 0.03),
            ],
            2,
        )
        meshes.append(extrude(side, 0.116, mat=body, axis="y", bevel_width=0.007, segments=1))
        roof = [(-0.095, 0.078), (-0.07, 0.122), (0.012, 0.125), (0.062, 0.079)]
        meshes.append(extrude(roof, 0.098, mat=body, axis="y", bevel_width=0.006))
        meshes.append(
            extrude(
                [(-0.082, 0.084), (-0.064, 0.115), (-0.03, 0.117), (-0.03, 0.084)],
                0.101,
                mat=glass,
                axis="y",
            )
        )
        meshes.append(
            extrude(
                [(-0.022, 0.084), (-0.022, 0.117), (0.008, 0.118), (0.046, 0.084)],
                0.101,
                mat=glass,
                axis="y",
            )
        )
        meshes.append(
            box(0.003, 0.084, 0.05, (0, 0, 0), glass).turn(ry=-0.82).move(0.0545, 0, 0.086)
        )
        meshes.append(
            box(0.003, 0.084, 0.038, (0, 0, 0), glass).turn(ry=0.5).move(-0.0935, 0, 0.084)
        )
        number, draw = canvas(64, 64)
        draw.ellipse((2, 2, 61, 61), fill="#ffffff")
        text(draw, "7", (16, 10, 48, 54), "bold", "#1c1c20")
        meshes.append(
            box(
                0.036,
                0.119,
                0.036,
                (-0.03, 0, 0.036),
                body,
                labels={"-y": printed(number, paint), "+y": printed(number, paint)},
            )
        )
        meshes.append(
            box(0.1, 0.03, 0.0025, (0, 0, 0), plain(second, 0.02))
            .turn(ry=0.13)
            .move(0.086, 0, 0.071)
        )
        meshes.append(box(0.076, 0.03, 0.0025, (-0.03, 0, 0.1238), plain(second, 0.02)))
        for q in (-1, 1):
            meshes.append(ellipsoid((0.006, 0.012, 0.009), (0.137, q * 0.038, 0.055), 8, 5, lamp))
            meshes.append(box(0.005, 0.022, 0.011, (-0.141, q * 0.038, 0.052), red))
        meshes.append(box(0.014, 0.112, 0.014, (0.139, 0, 0.027), dark, 0.003))
        axles, radius, track = (0.085, -0.085), 0.032, 0.055
        pieces = [
            box_piece((0, 0, 0.05), (0.28, 0.122, 0.06)),
            box_piece((-0.02, 0, 0.1), (0.13, 0.1, 0.05)),
        ]
    for x in axles:
        for q in (-1, 1):
            meshes.append(_wheel(radius, 0.026, tyre, cap, q).move(x, q * track, radius))
            pieces.append(
                cylinder_piece(radius, -0.013, 0.013, 10)
                @ np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0]])
                + [x, q * track, radius]
            )
    for mesh in meshes:
        mesh.scale(s)
    pieces = [piece * s for piece in pieces]
    return Model(f"toy {kind}", {"body": Part(meshes, collision=pieces)}, mass=0.4, friction=0.4)


def toy_car_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "car",
        "length": uniform(rng, 0.22, 0.3),
        "paint": pick(rng, ["#d8303a", "#2f6fc0", "#2f9a5a"]),
        "second": pick(rng, ["#f6f4ee", "#f2c52a"]),
        "hub": pick(rng, ["#e8e8e6", "#f2c52a"]),
    }


def toy_brick(columns: int, rows: int, unit: float, colour: str, tall: float) -> Model:
    """A building brick; unit is the pitch of its studs (8 mm small, 16 mm for toddlers)."""
    m = Material()
    m.colour(m.edge_highlight(m.mottle(colour, 0.02, 300), unit * 0.06, 0.35))
    height = unit * 1.2 * tall
    sx, sy = columns * unit - 0.0002, rows * unit - 0.0002
    meshes = [box(sx, sy, height, (0, 0, 0), m, bevel_width=unit * 0.03)]
    r = unit * 0.3
    sides = 12 if columns * rows <= 8 else 10
    for i in range(columns):
        for j in range(rows):
            stud = [(r, 0), (r, unit * 0.2), (r * 0.93, unit * 0.225), (0, unit * 0.225)]
            at = ((i - (columns - 1) / 2) * unit, (j - (rows - 1) / 2) * unit, height)
            meshes.append(lathe(stud, sides, mat=m).move(*at))
    whole = box_piece((0, 0, (height + 0.2 * unit) / 2), (sx, sy, height + 0.2 * unit))
    mass = 1100 * columns * rows * unit**2 * height * 0.35
    return Model(
        "toy brick",
        {"body": Part(meshes, collision=[whole])},
        mass=round(mass, 4),
        friction=0.4,
        texture_size=128,
    )


def toy_brick_random(rng: np.random.Generator) -> dict:
    return {
        "columns": 4,
        "rows": 2,
        "unit": 0.008,
        "tall": 1.0,
        "colour": pick(rng, ["#c91a1e", "#1157b8", "#f4c812", "#12873c"]),
    }


def toy_train(first: str, second: str, third: str) -> Model:
    """A wooden engine with one wagon full of blocks."""
    red, blue, yellow = plain(first, 0.05), plain(second, 0.05), plain(third, 0.05)
    dark, beech = plain("#2a2a2c", 0.05), plain("#d8b27c", 0.1, 60)
    meshes = [
        box(0.14, 0.06, 0.016, (0.085, 0, 0.018), beech, 0.003),
        box(0.05, 0.056, 0.07, (0.04, 0, 0.034), red, 0.004),
        box(0.062, 0.066, 0.01, (0.04, 0, 0.104), blue, 0.003),
        lathe(
            [
                (0, -0.042),
                (0.024, -0.042),
                (0.026, -0.038),
                (0.026, 0.038),
                (0.023, 0.042),
                (0, 0.042),
            ],
            16,
            mat=blue,
        )
        .turn(ry=math.pi / 2)
        .move(0.105, 0, 0.058),
        lathe(
            [(0.007, 0), (0.008, 0.018), (0.014, 0.03), (0.013, 0.034), (0, 0.034)], 12, mat=dark
        ).move(0.128, 0, 0.08),
        ellipsoid((0.01, 0.01, 0.01), (0.088, 0, 0.084), 8, 5, yellow),
        box(0.026, 0.058, 0.028, (0.04, 0, 0.066), yellow),
        box(0.12, 0.06, 0.016, (-0.085, 0, 0.018), beech, 0.003),
        box(0.03, 0.008, 0.008, (0.005, 0, 0.022), dark),
    ]
    for x, y, colour, turn in (
        (-0.115, -0.014, red, 0.1),
        (-0.083, 0.012, yellow, 0.5),
        (-0.053, -0.01, blue, -0.2),
    ):
        meshes.append(
            box(0.026, 0.026, 0.026, (0, 0, 0), colour, 0.002).turn(rz=turn).move(x, y, 0.034)
        )
    for q in (-1, 1):
        meshes.append(box(0.12, 0.006, 0.014, (-0.085, q * 0.028, 0.034), beech, 0.001))
        for x in (0.13, 0.085, 0.04, -0.05, -0.12):
            wheel = _wheel(0.018, 0.012, dark if x > 0 else red, yellow, q, 8)
            meshes.append(wheel.move(x, q * 0.034, 0.018))
    pieces = [
        box_piece((0, 0, 0.03), (0.3, 0.08, 0.06)),
        box_piece((0.04, 0, 0.08), (0.06, 0.066, 0.07)),
        box_piece((0.11, 0, 0.07), (0.09, 0.05, 0.08)),
    ]
    return Model(
        "wooden toy train",
        {"body": Part(meshes, collision=pieces)},
        mass=0.45,
        friction=0.4,
        texture_size=128,
    )


def toy_train_random(rng: np.random.Generator) -> dict:
    first, second, third = pick(
        rng, [("#c8302c", "#2f6fb0", "#f2c238"), ("#2f8a5a", "#c8402c", "#f2c238")]
    )
    return {"first": first, "second": second, "third": third}


MODELS = {
    "toy_ball": Maker(
        toy_ball,
        toy_ball_random,
        3,
        [
            {},
            {"style": "stripe", "colours": ["#2f6fc0", "#d8303a", "#f2c52a"]},
            {"style": "dots", "colours": ["#e8c22c", "#d8303a", "#2f8fc0"]},
        ],
    ),
    "toy_car": Maker(
        toy_car,
        toy_car_random,
        3,
        [
            {"paint": "#d8303a", "second": "#f6f4ee"},
            {"kind": "truck", "paint": "#e8b92c", "second": "#2f6fc0"},
            {"paint": "#2f6fc0", "second": "#f2c52a"},
        ],
    ),
    "toy_brick": Maker(
        toy_brick,
        toy_brick_random,
        4,
        [
            {"colour": "#c91a1e"},
            {"unit": 0.016, "colour": "#1157b8"},
            {"unit": 0.016, "columns": 2, "colour": "#f4c812", "tall": 1.0},
            {"columns": 6, "colour": "#12873c"},
        ],
    ),
    "toy_train": Maker(
        toy_train,
        toy_train_random,
        2,
        [
            {"first": "#c8302c", "second": "#2f6fb0", "third": "#f2c238"},
            {"first": "#2f8a5a", "second": "#c8402c", "third": "#f2c238"},
        ],
    ),
}
