"""Sports things: dumbbell, skateboard."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import label as printed
from toolkit.materials import metal, plain, shade
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    rectangle,
)
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    TAU,
    box,
    extrude,
    lathe,
    loft,
    tube,
)

from makers.projection import project_label


def dumbbell(style: str, length: float, colour: str) -> Model:
    """A hand weight lying on its side: 'hex' rubber heads or smooth 'round' vinyl."""
    rubber, steel = plain(colour, 0.06, 90), metal("c2c6ca", "767c82", (12, 1, 12), 60)
    r = length * 0.2
    half = length / 2
    if style == "hex":
        n, profile = (
            6,
            [
                (0, 0),
                (r * 0.72, 0),
                (r, r * 0.28),
                (r, r * 1.2),
                (r * 0.72, r * 1.45),
                (0, r * 1.45),
            ],
        )
        height = r * math.cos(math.pi / 6)
        grip = lathe(
            [(0.013, -half + r), (0.0145, -0.03), (0.016, 0), (0.0145, 0.03), (0.013, half - r)],
            12,
            mat=steel,
        )
    else:
        n, profile = (
            16,
            [(0, 0), (r * 0.7, 0), (r, r * 0.3), (r, r * 1.0), (r * 0.75, r * 1.3), (0, r * 1.3)],
        )
        height = r
        grip = lathe([(0.015, -half + r), (0.0165, 0), (0.015, half - r)], 12, mat=rubber)
    start = 0.0
    heads = []
    for q in (-1, 1):
        head = lathe(profile, n, mat=rubber, start=start)
        if style == "hex":
            head.flat()
        heads.append(head.move(z=-half) if q < 0 else head.scale(1, 1, -1).move(z=half))
    plate = lathe(
        [(0, -0.0006), (r * 0.45, -0.0006), (r * 0.45, 0)], 12, mat=plain(shade(colour, 2.2), 0)
    ).move(z=-half)
    plate2 = plate.copy().scale(1, 1, -1)
    meshes = [*heads, grip, plate, plate2]
    pieces = [
        cylinder_piece(r, -half, -half + 1.4 * r, 8),
        cylinder_piece(r, half - 1.4 * r, half, 8),
        cylinder_piece(0.016, -half + r, half - r, 6),
    ]
    if style == "hex":
        angles = [start + TAU * i / 6 for i in range(6)]
        ends = ((-half, -half + 1.4 * r), (half - 1.4 * r, half))
        pieces[:2] = [
            np.array([(r * math.cos(a), r * math.sin(a), z) for z in span for a in angles])
            for span in ends
        ]
    turn = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    for mesh in meshes:
        mesh.turn(rx=-math.pi / 2).move(z=height)
    pieces = [p @ turn.T + [0, 0, height] for p in pieces]
    return Model(
        "dumbbell",
        {"body": Part(meshes, collision=pieces)},
        mass=round(60 * length**2, 1),
        friction=0.7,
        texture_size=128,
    )


def dumbbell_random(rng: np.random.Generator) -> dict:
    return {"style": "hex", "length": uniform(rng, 0.19, 0.24), "colour": "#2a2c30"}


def skateboard(length: float, ground: str, accent: str, wheel: str) -> Model:
    """A skateboard on its wheels: grip tape on top, both ends bent up."""
    width, z0, thick = length * 0.255, 0.082, 0.011
    grip, art = (
        printed(prints.skateboard_deck(ground, accent, True)),
        printed(prints.skateboard_deck(ground, accent, False)),
    )
    ply = plain("#c99a5c", 0.08, 120)
    rings = []
    for t in np.linspace(-1, 1, 17):
        x = t * length / 2
        bend = max(0.0, abs(t) - 0.68) / 0.32
        w = width / 2 * math.sqrt(max(0.02, 1 - max(0.0, (abs(t) - 0.72) / 0.285) ** 2.2))
        z = z0 + 0.042 * bend**1.5
        dish = 0.004 * (1 - bend)
        rings.append(
            [
                (x, -w, z + dish),
                (x, -w, z + dish + thick),
                (x, 0, z + thick),
                (x, w, z + dish + thick),
                (x, w, z + dish),
                (x, 0, z),
            ]
        )
    deck = loft(rings, mat=ply)
    project_label(deck, grip, "+z", (0, 0), (width, length), 0.4)
    project_label(deck, art, "-z", (0, 0), (width, length), 0.4)
    for i, face in enumerate(deck.f):  # the drawings lie along the board
        if deck.mi[i]:
            deck.label_uv[i] = [
                (deck.v[j][0] / length + 0.5, deck.v[j][1] / width + 0.5) for j in face
            ]
    steel, tyre = metal("b4b9be", "62686e"), plain(wheel, 0.04)
    meshes = [deck]
    radius = 0.029
    pieces = [box_piece((0, 0, z0 + 0.006), (length * 0.72, width, 0.016))]
    for q in (-1, 1):
        x = q * length * 0.3
        pieces.append(
            box_piece((q * length * 0.43, 0, z0 + 0.03), (length * 0.14, width * 0.9, 0.03))
        )
        meshes.append(box(0.075, 0.05, 0.012, (x, 0, z0 - 0.011), steel, 0.002))
        meshes.append(
            extrude(
                [(-0.04, 0), (0.04, 0), (0.016, 0.04), (-0.016, 0.04)], 0.022, mat=steel, axis="x"
            ).move(x, 0, 0.034)
        )
        meshes.append(
            tube([(x, -width * 0.42, radius), (x, width * 0.42, radius)], 0.006, 6, mat=steel)
        )
        for s in (-1, 1):
            w = 0.017
            profile = [
                (0, -w),
                (0.011, -w),
                (0.024, -w),
                (radius, -w * 0.6),
                (radius, w * 0.6),
                (0.024, w),
                (0.011, w),
                (0, w),
            ]
            disc = lathe(
                profile, 12, mats=[tyre, steel], mat_of_segment=[1, 0, 0, 0, 0, 0, 1]
            ).turn(rx=math.pi / 2)
            meshes.append(disc.move(x, s * width * 0.42, radius))
            pieces.append(
                cylinder_piece(radius, -w, w, 10) @ np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0]])
                + [x, s * width * 0.42, radius]
            )
    top = Support("deck", z0 + thick + 0.002, rectangle(length * 0.6, width - 0.04))
    return Model(
        "skateboard",
        {"body": Part(meshes, collision=pieces)},
        mass=2.4,
        friction=0.3,
        supports=[top],
    )


def skateboard_random(rng: np.random.Generator) -> dict:
    ground, accent = pick(
        rng, [("#2a6fb0", "#f2c53a"), ("#c8302c", "#f6f4ee"), ("#2f8a5a", "#f2a83a")]
    )
    return {
        "length": uniform(rng, 0.74, 0.8),
        "ground": ground,
        "accent": accent,
        "wheel": pick(rng, ["#f2ead0", "#e8502c", "#3fa0c8"]),
    }


MODELS = {
    "dumbbell": Maker(
        dumbbell,
        dumbbell_random,
        3,
        [
            {},
            {"style": "round", "colour": "#c8306a"},
            {"style": "round", "colour": "#2f8fc0", "length": 0.17},
        ],
    ),
    "skateboard": Maker(
        skateboard,
        skateboard_random,
        2,
        [
            {"ground": "#2a6fb0", "accent": "#f2c53a", "wheel": "#f2ead0"},
            {"ground": "#c8302c", "accent": "#e8502c", "wheel": "#e8502c"},
        ],
    ),
}
