"""Things left on the floor: umbrella, pet bowl, watering can."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
    ring_pieces,
)
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import (
    TAU,
    box,
    ellipsoid,
    lathe,
    spline,
    tube,
)


def umbrella(length: float, cloth: str, second: str, crook: bool) -> Model:
    """A closed umbrella lying on its side."""
    s = length / 0.85
    r = 0.036
    skin = Material()
    folds = skin.math(
        "SINE",
        skin.math(
            "ADD",
            skin.math(
                "MULTIPLY",
                skin.math("ARCTAN2", skin.axis(1), skin.math("SUBTRACT", skin.axis(2), r * s)),
                8,
            ),
            skin.math("MULTIPLY", skin.axis(0), 26),
        ),
    )
    skin.colour(skin.mix(skin.remap(folds, -1, 0.6, 0.5, 0), cloth, shade(cloth, 0.4)))
    profile = [
        (0, 0.02),
        (0.009, 0.03),
        (0.016, 0.12),
        (0.026, 0.3),
        (r, 0.5),
        (r * 1.02, 0.56),
        (0.024, 0.585),
        (0.014, 0.58),
        (0, 0.57),
    ]
    canopy = lathe(
        [(a * s, z * s) for a, z in profile],
        16,
        mat=skin,
        rib=lambda k, i: 1 + (0.13 if i % 2 else -0.1) * min(1.0, k / 3),
        discs=False,
    )
    strap = lathe(
        [
            (0.032 * s, 0.4 * s),
            (0.0365 * s, 0.405 * s),
            (0.0375 * s, 0.43 * s),
            (0.034 * s, 0.435 * s),
        ],
        14,
        mat=plain(second, 0.03),
    )
    steel, grip = (
        metal("b9bdc2", "6a7076"),
        wood("8a5a34", "4a2c18", 0, 20) if crook else plain(second, 0.04),
    )
    tip = lathe([(0, 0), (0.003 * s, 0), (0.005 * s, 0.04 * s), (0, 0.045 * s)], 8, mat=steel)
    stick = tube([(0, 0, 0.57 * s), (0, 0, 0.75 * s)], 0.0055, 8, mat=steel)
    upright = [canopy, strap, tip, stick]
    if crook:
        bend = (
            [(0, 0, 0.68), (0, 0, 0.78)]
            + [
                (0.0, 0.055 - 0.055 * math.cos(t), 0.79 + 0.055 * math.sin(t))
                for t in np.linspace(0.2, math.pi, 8)
            ]
            + [(0, 0.11, 0.765)]
        )
        upright.append(tube(np.array(bend) * s, 0.011, 8, mat=grip))
    else:
        upright.append(
            lathe(
                [
                    (0, 0.68 * s),
                    (0.012, 0.68 * s),
                    (0.014, 0.76 * s),
                    (0.017, 0.84 * s),
                    (0.012, 0.85 * s),
                    (0, 0.85 * s),
                ],
                10,
                mat=grip,
            )
        )
    # it lies on its cone, the tip on the floor, and rolled over until the crook's end touches too
    rest, roll, axis = 0.05, -0.4 if crook else 0.0, (0, 0, r * s)
    for mesh in upright:
        mesh.turn(ry=math.pi / 2).move(-0.42 * s, 0, r * s).turn(rx=roll, pivot=axis).turn(ry=-rest)
    lowest = min(float(mesh.v[:, 2].min()) for mesh in upright)
    for mesh in upright:
        mesh.move(z=-lowest)
    outline = ((0.0, 0.003), (0.03, 0.008), (0.5, 0.039), (0.56, 0.04), (0.585, 0.024))
    cone = [
        (x * s - 0.42 * s, y * s, r * s + z * s)
        for x, w in outline
        for y, z in ((w, 0), (0, w), (-w, 0), (0, -w), (0.7 * w, -0.7 * w), (-0.7 * w, -0.7 * w))
    ]
    pieces = [np.array(cone), box_piece((0.24 * s, 0, r * s), (0.2 * s, 0.02, 0.02))]
    if crook:
        hook = box_piece((0.39 * s, 0.055 * s, 0), (0.07 * s, 0.13 * s, 0.022))
        c, n = math.cos(roll), math.sin(roll)
        pieces.append(hook @ np.array([[1, 0, 0], [0, c, n], [0, -n, c]]) + axis)
    c, n = math.cos(rest), math.sin(rest)
    pieces = [
        piece @ np.array([[c, 0, n], [0, 1, 0], [-n, 0, c]]) - [0, 0, lowest] for piece in pieces
    ]
    return Model(
        "closed umbrella", {"body": Part(upright, collision=pieces)}, mass=0.45, texture_size=128
    )


def umbrella_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.8, 0.9),
        "cloth": pick(rng, ["#26282c", "#2f4f8a", "#c8302c", "#2f7f5a"]),
        "second": "#1c1d20",
        "crook": True,
    }


def pet_bowl(
    radius: float, height: float, colour: str, steel: bool, content: str, seed: int
) -> Model:
    """A pet's bowl, wider at its foot, with water or dry food in it."""
    rng = np.random.default_rng(seed)
    shell = metal("b4b9be", "565c62") if steel else plain(colour, 0.04)
    inner = metal("c4c9cd", "72787e") if steel else plain(shade(colour, 1.1), 0.03)
    rim, wall, level = radius * 0.84, 0.008, height * 0.72
    profile = [
        (0, 0.002),
        (radius * 0.94, 0.002),
        (radius, 0),
        (radius, 0.006),
        (rim + 0.004, height - 0.004),
        (rim, height),
        (rim - wall, height - 0.003),
        (rim * 0.8, level),
        (0, level - 0.001),
    ]
    bowl = lathe(profile, 26, mats=[shell, inner], mat_of_segment=[0] * 5 + [1] * 3)
    meshes = [bowl]
    if content == "water":
        water = Material(occlusion=0.3)
        swirl = water.noise(22, 2, distortion=1.5)
        water.colour(
            water.ramp(
                swirl,
                [
                    (0.3, "7fb0c8"),
                    (0.5, "a9cfde"),
                    (0.56, "e6f4fa"),
                    (0.6, "a9cfde"),
                    (0.8, "8fbdd2"),
                ],
            )
        )
        meshes.append(
            lathe(
                [(rim * 0.86, level + 0.001), (rim * 0.84, level + 0.003), (0, level + 0.003)],
                22,
                mat=water,
            )
        )
    else:
        kibble = plain("#8a5a30", 0.3, 200)
        heap = lathe(
            [
                (rim * 0.84, level),
                (rim * 0.6, level + 0.006),
                (rim * 0.3, level + 0.011),
                (0, level + 0.012),
            ],
            16,
            mat=kibble,
        )
        meshes.append(heap)
        for _ in range(14):
            a, q = float(rng.uniform(0, TAU)), rim * 0.74 * math.sqrt(float(rng.random()))
            z = level + 0.012 - 0.009 * q / rim
            meshes.append(
                lathe(
                    [(0, 0), (0.0065, 0), (0.007, 0.003), (0.005, 0.006), (0, 0.006)],
                    4,
                    mat=plain(pick(rng, ["#9a6636", "#7a4a26", "#b07a44"]), 0.1),
                    weight=0.6,
                ).move(q * math.cos(a), q * math.sin(a), z)
            )
    if not steel:
        bone = plain("#f7f4ea", 0.0)
        paw = [box(0.002, 0.045, 0.012, (0, 0, -0.006), bone)] + [
            ellipsoid((0.0012, 0.009, 0.009), (0, q * 0.022, w * 0.007), 8, 5, bone)
            for q in (-1, 1)
            for w in (-1, 1)
        ]
        slope = math.atan2(radius - rim - 0.004, height - 0.01)
        for mesh in paw:
            meshes.append(
                mesh.turn(ry=-slope).move((radius + rim + 0.004) / 2 - 0.0005, 0, height / 2)
            )
    pieces = [
        cylinder_piece(radius, 0, level, 14, radius * 0.9),
        *ring_pieces(
            [(radius * 0.92, level * 0.9), (rim + 0.004, height)],
            [(rim * 0.85, level * 0.9), (rim - wall, height)],
            10,
        ),
    ]
    inside = Container(
        "inside",
        (0, 0, (level + height) / 2 + 0.002),
        (rim * 1.1, rim * 1.1, max(0.01, height - level)),
    )
    return Model(
        f"pet bowl with {content}",
        {"body": Part(meshes, collision=pieces)},
        mass=0.5,
        containers=[inside],
        ground_shadow=True,
        texture_size=128,
    )


def pet_bowl_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.095, 0.115),
        "height": uniform(rng, 0.055, 0.068),
        "colour": pick(rng, ["#c8302c", "#2f6fb0", "#3a9a8a"]),
        "steel": False,
        "content": "water",
        "seed": seed_of(rng),
    }


def _double_sided(sheet: Mesh, thickness: float) -> Mesh:
    """Give a thin open dome an inner side (back faces are not drawn), a little further in."""
    n, faces = len(sheet.v), len(sheet.f)
    inner = sheet.v - [0, 0, thickness]
    inner[:, :2] *= 1 - thickness / np.abs(sheet.v[:, :2]).max()
    sheet.v = np.r_[sheet.v, inner]
    sheet.f = sheet.f + [tuple(i + n for i in face[::-1]) for face in sheet.f]
    sheet.mi = sheet.mi * 2
    apart = 3 * np.ptp([u for face in sheet.bake_uv for u, _ in face])
    sheet.label_uv = sheet.label_uv + [face[::-1] for face in sheet.label_uv]
    sheet.bake_uv = sheet.bake_uv + [
        [(apart - u, v) for u, v in face[::-1]] for face in sheet.bake_uv[:faces]
    ]
    return sheet


def watering_can(height: float, colour: str, zinc: bool) -> Model:
    """A watering can with a long spout and rose, and a loop handle."""
    s = height / 0.24
    paint = metal("b9c0c4", "767e84") if zinc else plain(colour, 0.04)
    body = lathe(
        [
            (0, 0),
            (0.082, 0),
            (0.088, 0.004),
            (0.08, 0.15),
            (0.082, 0.156),
            (0.076, 0.156),
            (0.078, 0.05),
            (0, 0.05),
        ],
        20,
        mats=[paint, plain(shade(colour, 0.45), 0.02)],
        mat_of_segment=[0] * 5 + [1, 1],
    )
    dome = lathe([(0.081, 0.15), (0.07, 0.172), (0.045, 0.182), (0, 0.186)], 14, mat=paint)
    dome.keep_faces([i for i, f in enumerate(dome.f) if dome.v[list(f)].mean(0)[0] > 0.02])
    hood = _double_sided(dome, 0.004)
    spout = tube(
        spline([(0.07, 0, 0.035), (0.12, 0, 0.08), (0.18, 0, 0.16), (0.21, 0, 0.2)], 3),
        np.linspace(0.019, 0.0105, 10),
        8,
        mat=paint,
    )
    direction = 0.68
    rose = (
        lathe(
            [(0, 0), (0.011, 0), (0.03, 0.024), (0.03, 0.03), (0, 0.034)],
            14,
            mats=[paint, plain(shade(colour, 0.6), 0.3, 500)],
            mat_of_segment=[0, 0, 0, 1],
        )
        .turn(ry=direction)
        .move(0.206, 0, 0.196)
    )
    brace = tube([(0.075, 0, 0.152), (0.165, 0, 0.146)], 0.0045, 6, mat=paint)
    handle = tube(
        spline(
            [
                (0.03, 0, 0.178),
                (0.0, 0, 0.235),
                (-0.08, 0, 0.245),
                (-0.135, 0, 0.19),
                (-0.13, 0, 0.1),
                (-0.082, 0, 0.045),
            ],
            3,
        ),
        0.0085,
        7,
        mat=paint,
        up=(0, 1, 0),
    )
    meshes = [body, hood, spout, rose, brace, handle]
    for mesh in meshes:
        mesh.scale(s)
    pieces = [
        cylinder_piece(0.088, 0, 0.156, 14, 0.081),
        np.array(
            [
                (x, y * w, z)
                for x, z, w in (
                    (0.075, 0.02, 0.018),
                    (0.08, 0.06, 0.018),
                    (0.21, 0.19, 0.012),
                    (0.235, 0.23, 0.03),
                    (0.25, 0.19, 0.03),
                )
                for y in (-1, 1)
            ]
        ),
        box_piece((-0.06, 0, 0.235), (0.16, 0.018, 0.03)),
        box_piece((-0.125, 0, 0.14), (0.03, 0.018, 0.16)),
    ]
    pieces = [p * s for p in pieces]
    return Model(
        "watering can",
        {"body": Part(meshes, collision=pieces)},
        mass=0.7,
        texture_size=128,
        front="-y",  # its spout to the right
    )


def watering_can_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.22, 0.26),
        "colour": pick(rng, ["#2f8a5a", "#3a7fb0"]),
        "zinc": False,
    }


MODELS = {
    "umbrella": Maker(
        umbrella,
        umbrella_random,
        3,
        [{"cloth": "#2f4f8a"}, {"cloth": "#26282c", "crook": False}, {"cloth": "#c8302c"}],
    ),
    "pet_bowl": Maker(
        pet_bowl,
        pet_bowl_random,
        3,
        [{"colour": "#c8302c"}, {"steel": True}, {"colour": "#2f6fb0", "content": "food"}],
    ),
    "watering_can": Maker(
        watering_can,
        watering_can_random,
        2,
        [{"colour": "#2f8a5a"}, {"zinc": True, "colour": "#b9c0c4"}],
    ),
}
