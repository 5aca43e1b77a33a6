"""Small things that stand or hang: photo frame, wall clock, tissues."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import label as printed
from toolkit.materials import plain, shade, wood
from toolkit.model import (
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import (
    TAU,
    box,
    extrude,
    lathe,
    loft,
)

from makers.projection import project_label


def photo_frame(
    width: float, height: float, border: float, frame: str, wooden: bool, picture: str
) -> Model:
    """A framed photo leaning back on its stand."""
    mat = wood(frame, shade(frame, 0.6), 1, 14) if wooden else plain(frame, 0.04)
    photo = printed(prints.photo(picture))
    depth, lean = 0.016, -0.22
    w, h = width / 2, height / 2
    meshes = []
    for sx, sz, y, z in (
        (width, border, 0, 0),
        (width, border, 0, height - border),
        (border, height - 2 * border, -w + border / 2, border),
        (border, height - 2 * border, w - border / 2, border),
    ):
        meshes.append(box(depth, sx, sz, (0, y, z), mat, 0.003))
    mount = box(
        0.006,
        width - 2 * border + 0.004,
        height - 2 * border + 0.004,
        (-0.004, 0, border - 0.002),
        plain("#f7f4ea", 0.0),
    )
    print_face = box(
        0.006,
        width - 2 * border - 0.02,
        height - 2 * border - 0.02,
        (-0.003, 0, border + 0.01),
        plain("#f7f4ea", 0.0),
        labels={"+x": photo},
        weight=1.6,
    )
    back = box(
        0.005, width - border, height - border, (-0.0085, 0, border / 2), plain("#2c2a28", 0.05)
    )
    meshes += [mount, print_face, back]
    for mesh in meshes:
        mesh.turn(ry=lean)
    hinge = (-math.sin(-lean) * h * 1.25 - 0.01, 0, math.cos(lean) * h * 1.25)
    foot_x = -height * 0.52
    stand = extrude(
        [
            (hinge[0], hinge[2]),
            (foot_x, 0.002),
            (foot_x - 0.006, 0.003),
            (hinge[0] - 0.004, hinge[2] + 0.004),
        ],
        width * 0.28,
        mat=plain("#2c2a28", 0.05),
        axis="y",
    )
    meshes.append(stand)
    turn = np.array(
        [[math.cos(lean), 0, math.sin(lean)], [0, 1, 0], [-math.sin(lean), 0, math.cos(lean)]]
    )
    pieces = [
        box_piece((0, 0, h), (depth, width, height)) @ turn.T,
        np.array(
            [
                (x, y, z)
                for x, z in ((hinge[0], hinge[2]), (foot_x, 0), (foot_x - 0.006, 0.002))
                for y in (-width * 0.14, width * 0.14)
            ]
        ),
    ]
    return Model("photo in a frame", {"body": Part(meshes, collision=pieces)}, mass=0.35)


def photo_frame_random(rng: np.random.Generator) -> dict:
    return {
        "width": uniform(rng, 0.14, 0.19),
        "height": uniform(rng, 0.18, 0.23),
        "border": uniform(rng, 0.014, 0.02),
        "frame": pick(rng, ["#b98552", "#7a4a2a"]),
        "wooden": True,
        "picture": pick(rng, ["lake", "family", "dog"]),
    }


def wall_clock(radius: float, rim: str, paper: str, ink: str, hour: float) -> Model:
    """A round clock to hang on a wall (back at its rear face)."""
    paint = plain(rim, 0.04)
    dial = printed(prints.clock_face(paper, ink, hour))
    r = radius
    case = lathe(
        [
            (0, 0),
            (r, 0),
            (r, 0.03),
            (r - 0.008, 0.036),
            (r - 0.018, 0.034),
            (r - 0.02, 0.024),
            (0, 0.024),
        ],
        32,
        mats=[paint],
    )
    case.turn(ry=math.pi / 2).move(0, 0, r)
    project_label(
        case,
        dial,
        "+x",
        (0, r),
        (2 * r - 0.036, 2 * r - 0.036),
        0.9,
        lambda c: abs(c[0] - 0.024) < 0.001,
    )
    pieces = [
        cylinder_piece(r, 0, 0.036, 16) @ np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]]) + [0, 0, r]
    ]
    return Model("wall clock", {"body": Part([case.weigh(1.2)], collision=pieces)}, mass=0.7)


def wall_clock_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.13, 0.16),
        "rim": pick(rng, ["#26282c", "#8a5a34", "#c8402c"]),
        "paper": "#fbf8ee",
        "ink": "#222222",
        "hour": uniform(rng, 1, 11.9),
    }


def tissue_box(cube: bool, ground: str, accent: str, second: str, pattern: str, seed: int) -> Model:
    """A box of paper tissues with one pulled half out."""
    rng = np.random.default_rng(seed)
    skin = printed(prints.tissue_pattern(ground, accent, second, pattern, rng))
    sx, sy, sz = (0.115, 0.115, 0.125) if cube else (0.115, 0.225, 0.075)
    long = (0, 0, 1, 1) if not cube else (0, 0, 0.6, 1)
    short = (0, 0, 0.6, 1)
    body = box(
        sx,
        sy,
        sz,
        (0, 0, 0),
        plain(ground, 0.03),
        0.003,
        labels={
            "+x": (skin, long),
            "-x": (skin, long),
            "+y": (skin, short),
            "-y": (skin, short),
            "+z": (skin, long),
        },
    )
    slot = loft(
        [
            np.c_[0.024 * np.cos(t), 0.052 * np.sin(t), np.full(16, z)]
            for z, t in (
                (sz - 0.0004, np.arange(16) * TAU / 16),
                (sz + 0.0006, np.arange(16) * TAU / 16),
            )
        ],
        mat=plain("#cfd6da", 0.0),
    )
    paper = plain("#fbfbf9", 0.03, 60)
    rings = []
    n = 18
    for z, wide, deep, wave in (
        (0, 0.034, 0.007, 0.2),
        (0.018, 0.03, 0.008, 0.3),
        (0.045, 0.042, 0.013, 0.45),
        (0.066, 0.05, 0.016, 0.7),
        (0.071, 0.042, 0.01, 0.8),
    ):
        ring = []
        for i in range(n):
            t = TAU * i / n
            r = 1 + wave * 0.4 * math.sin(4 * t + 1.1)
            lift = 0.018 * wave * math.sin(3 * t + 0.7) if z > 0.03 else 0.0
            ring.append((deep * r * math.cos(t), wide * r * math.sin(t), sz + z + lift))
        rings.append(ring)
    tissue = loft(rings, mat=paper)
    pieces = [
        box_piece((0, 0, sz / 2), (sx, sy, sz)),
        box_piece((0, 0, sz + 0.03), (0.02, 0.07, 0.06)),
    ]
    return Model("box of tissues", {"body": Part([body, slot, tissue], collision=pieces)}, mass=0.2)


def tissue_box_random(rng: np.random.Generator) -> dict:
    ground, accent, second = pick(
        rng,
        [
            ("#8fc3cf", "#f4f2ea", "#3a7a94"),
            ("#f3e3e6", "#d9708c", "#7ab0c8"),
            ("#2f5f7a", "#f2c52a", "#e9eef0"),
        ],
    )
    return {
        "cube": False,
        "ground": ground,
        "accent": accent,
        "second": second,
        "pattern": pick(rng, ["flowers", "dots", "leaves"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "photo_frame": Maker(
        photo_frame,
        photo_frame_random,
        3,
        [
            {"picture": "family"},
            {"picture": "lake", "wooden": False, "frame": "#f2f0ea", "width": 0.22, "height": 0.17},
            {"picture": "dog", "wooden": False, "frame": "#26282c"},
        ],
    ),
    "wall_clock": Maker(wall_clock, wall_clock_random, 2, [{"rim": "#26282c"}, {"rim": "#8a5a34"}]),
    "tissue_box": Maker(
        tissue_box,
        tissue_box_random,
        3,
        [
            {"pattern": "leaves"},
            {
                "cube": True,
                "pattern": "flowers",
                "ground": "#f3e3e6",
                "accent": "#d9708c",
                "second": "#7ab0c8",
            },
            {"pattern": "dots", "ground": "#2f5f7a", "accent": "#f2c52a", "second": "#e9eef0"},
        ],
    ),
}
