"""Pots, frying pans and kettles."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, ellipsoid, extrude, lathe, spline, tube


def vessel(radius, height, outer, inner, rim, wall=0.004, n=26, flare=1.0):
    """A pan's wall and floor; flare: top radius over bottom radius."""
    low = radius / flare
    profile = [
        (0, 0),
        (low * 0.93, 0),
        (low, 0.005),
        (radius, height - 0.002),
        (radius + 0.002, height - 0.0005),
    ]
    profile += [
        (radius + 0.0005, height),
        (radius - wall, height - 0.0015),
        (low - wall, 0.011),
        (low * 0.9, 0.006),
        (0, 0.006),
    ]
    return lathe(profile, n, mats=[outer, inner, rim], mat_of_segment=[0, 0, 0, 2, 2, 2, 1, 1, 1])


def vessel_pieces(radius, height, wall=0.006, flare=1.0):
    low = radius / flare
    return [
        cylinder_piece(low, 0, 0.006),
        *ring_pieces(
            [(low, 0), (radius, height)], [(low - wall, 0.0), (radius - wall, height)], 10
        ),
    ]


def inside_of(radius: float, height: float, flare: float = 1.0) -> dict:
    """Support and container of an open vessel."""
    low = radius / flare
    return {
        "supports": [Support("bottom", 0.006, round_polygon(low * 0.88), container="inside")],
        "containers": [
            Container("inside", (0, 0, height / 2 + 0.004), (low * 1.3, low * 1.3, height - 0.01))
        ],
    }


def pot(
    radius=0.11, height=0.13, colour="", handle="#1c1c1e", saucepan=False, lid=True, seed=0
) -> Model:
    """A stock pot (two loops) or a saucepan (one long handle to the front); `colour`: enamel."""
    rng = np.random.default_rng(seed)
    steel = metal("c2c6ca", "7e848a", (1, 1, 14), 40, noise_offset(rng))
    outer = plain(colour, 0.05, 20, noise_offset(rng)) if colour else steel
    inner = plain("e9e6de", 0.04, 30) if colour else metal("b3b8bc", "858b90", (12, 12, 1), 40)
    body = [vessel(radius, height, outer, inner, steel)]
    grip = plain(handle, 0.06, 120)
    pieces = vessel_pieces(radius, height)
    if saucepan:
        path = spline(
            [
                (radius - 0.004, 0, height * 0.8),
                (radius + 0.05, 0, height * 0.88),
                (radius + 0.17, 0, height * 0.92),
            ],
            3,
        )
        body.append(
            tube(
                path,
                [0.006, 0.008, 0.009, 0.011, 0.012, 0.0125, 0.0105],
                8,
                mat=grip,
                up=(0, 0, 1.0),
                flatten=0.65,
            )
        )
        pieces.append(box_piece((radius + 0.085, 0, height * 0.88), (0.17, 0.022, 0.02)))
    else:
        for side in (-1, 1):
            angles = np.linspace(-1.2, 1.2, 7)
            path = [
                (
                    0.045 * math.sin(a) / math.sin(1.2),
                    side * (radius - 0.012 + 0.042 * (math.cos(a) - 0.36) / 0.64 + 0.008),
                    height * 0.8,
                )
                for a in angles
            ]
            body.append(tube(path, 0.0065, 7, mat=grip, up=(0, 0, 1.0)))
            pieces.append(
                box_piece((0, side * (radius + 0.018), height * 0.8), (0.09, 0.036, 0.013))
            )
    parts = {"body": Part(body, collision=pieces)}
    variants = {"default": ["body"]}
    if lid:
        top = [
            (0, height + 0.001),
            (radius - 0.002, height + 0.001),
            (radius + 0.004, height + 0.002),
            (radius + 0.003, height + 0.006),
        ]
        top += [
            (radius * 0.75, height + 0.018),
            (radius * 0.35, height + 0.025),
            (0, height + 0.027),
        ]
        z = height + 0.026
        knob = lathe(
            [
                (0, z),
                (0.009, z),
                (0.007, z + 0.01),
                (0.017, z + 0.016),
                (0.016, z + 0.024),
                (0, z + 0.026),
            ],
            12,
            mat=grip,
        )
        parts["lid"] = Part(
            [
                lathe(top, 24, mat=outer if colour else metal("c9cdd0", "8a9096", (9, 9, 1), 30)),
                knob,
            ],
            collision="hull",
        )
        variants["covered"] = ["body", "lid"]
    kind = "saucepan" if saucepan else "cooking pot"
    return Model(
        title=f"{'enamel' if colour else 'steel'} {kind}",
        parts=parts,
        variants=variants,
        mass=1.4,
        texture_size=128,
        **inside_of(radius, height),
    )


def pot_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.095, 0.125),
        "height": uniform(rng, 0.11, 0.16),
        "colour": pick(rng, ["", "", "#b3302c", "#2d5f6e", "#e8dcc0"]),
        "saucepan": bool(rng.random() < 0.4),
        "seed": seed_of(rng),
    }


def frying_pan(radius=0.13, height=0.045, outside="#2a2b2e", handle="#1c1c1e", seed=0) -> Model:
    """A frying pan, its handle to the front."""
    rng = np.random.default_rng(seed)
    coated = Material()
    ring = coated.noise(260, 3, offset=noise_offset(rng))
    sheen = coated.remap(coated.distance((radius * 0.3, radius * 0.2, 0)), 0, radius * 0.9, 0.35, 0)
    coated.colour(
        coated.mix(sheen, coated.mix(coated.remap(ring, 0.35, 0.65), "232426", "2f3033"), "5a5d62")
    )
    outer = plain(outside, 0.05, 20, noise_offset(rng))
    body = [vessel(radius, height, outer, coated, metal("b5b9bd", "7c8187"), 0.005, 28, 1.22)]
    steel = metal("c2c6ca", "7e848a")
    body.append(box(0.03, 0.02, 0.012, (radius + 0.006, 0, height - 0.018), steel, 0.003))
    path = spline(
        [
            (radius + 0.012, 0, height - 0.012),
            (radius + 0.07, 0, height + 0.008),
            (radius + 0.18, 0, height + 0.016),
        ],
        3,
    )
    body.append(
        tube(
            path,
            [0.008, 0.0095, 0.0105, 0.012, 0.0135, 0.0135, 0.011],
            8,
            mat=plain(handle, 0.06, 120),
            up=(0, 0, 1.0),
            flatten=0.65,
        )
    )
    pieces = vessel_pieces(radius, height, 0.007, 1.22)
    pieces.append(
        np.array(
            [
                (x, y, z + dz)
                for x, z in ((radius - 0.004, height - 0.012), (radius + 0.18, height + 0.016))
                for y in (-0.012, 0.012)
                for dz in (-0.008, 0.008)
            ]
        )
    )
    return Model(
        title="frying pan",
        parts={"body": Part(body, collision=pieces)},
        mass=1.1,
        texture_size=128,
        **inside_of(radius, height, 1.22),
    )


def frying_pan_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.11, 0.145),
        "height": uniform(rng, 0.04, 0.052),
        "outside": pick(rng, ["#2a2b2e", "#9a2f2b", "#35536b"]),
        "handle": pick(rng, ["#1c1c1e", "#6b3d1e"]),
        "seed": seed_of(rng),
    }


def kettle(style="electric", colour="#d8dade", accent="#1c1c1e", height=0.2, seed=0) -> Model:
    """An electric jug kettle on its base, or a whistling stove kettle; the spout to the front."""
    rng = np.random.default_rng(seed)
    shell = (
        metal("c6cace", "80868c", (1, 1, 10), 40, noise_offset(rng))
        if colour == "steel"
        else plain(colour, 0.04, 15, noise_offset(rng))
    )
    black = plain(accent, 0.06, 120)
    if style == "electric":
        low, top, h = 0.075, 0.058, height
        body = [lathe([(0, 0), (0.078, 0), (0.078, 0.016), (0.07, 0.02), (0, 0.02)], 24, mat=black)]
        profile = [
            (0, 0.021),
            (low, 0.021),
            (low + 0.001, 0.03),
            (low * 0.96, h * 0.5),
            (top + 0.002, h * 0.88),
            (top, h * 0.92),
            (0, h * 0.92),
        ]
        body.append(lathe(profile, 24, mat=shell))
        body.append(
            lathe(
                [
                    (0, h * 0.915),
                    (top * 0.96, h * 0.915),
                    (top * 0.9, h * 0.95),
                    (top * 0.4, h * 0.975),
                    (0, h * 0.98),
                ],
                24,
                mat=black,
            )
        )
        body.append(
            lathe(
                [(0, h * 0.97), (0.012, h * 0.97), (0.013, h * 1.0), (0, h * 1.01)], 12, mat=black
            )
        )
        beak = [
            (top * 0.8, h * 0.74),
            (top + 0.032, h * 0.9),
            (top + 0.03, h * 0.93),
            (top * 0.7, h * 0.925),
        ]
        spout = extrude(beak, 0.034, shell, axis="y", bevel_width=0.006)
        body.append(spout)
        path = spline(
            [
                (-top * 0.8, 0, h * 0.92),
                (-top - 0.045, 0, h * 0.9),
                (-top - 0.06, 0, h * 0.6),
                (-low - 0.03, 0, h * 0.24),
                (-low * 0.95, 0, h * 0.2),
            ],
            3,
        )
        body.append(tube(path, 0.0105, 8, mat=black, up=(0, 1.0, 0), flatten=1.25))
        level = plain("8fb4c4", 0.1, 50)
        body.append(
            box(0.006, 0.014, h * 0.4, (0, low * 0.93, h * 0.3), level, 0.002)
            .turn(rx=0.0)
            .move(0, -0.002)
        )
        switch = box(0.012, 0.018, 0.012, (-top - 0.052, 0, h * 0.34), plain("c0392b", 0.02), 0.003)
        body.append(switch)
        pieces = [
            cylinder_piece(low + 0.003, 0, h * 0.98, 12, top),
            box_piece((-top - 0.045, 0, h * 0.55), (0.035, 0.026, h * 0.72)),
        ]
        pieces.append(np.array([(x, y, z) for x, z in beak for y in (-0.017, 0.017)]))
        mass, title = 1.1, "electric kettle"
    else:
        r, h = 0.1, height * 0.72
        profile = [
            (0, 0),
            (r * 0.95, 0),
            (r, 0.008),
            (r, 0.022),
            (r * 0.93, h * 0.42),
            (r * 0.7, h * 0.72),
            (r * 0.42, h * 0.86),
            (0, h * 0.86),
        ]
        body = [lathe(profile, 24, mat=shell)]
        body.append(
            lathe(
                [
                    (0, h * 0.85),
                    (r * 0.44, h * 0.85),
                    (r * 0.42, h * 0.89),
                    (r * 0.2, h * 0.95),
                    (0, h * 0.96),
                ],
                16,
                mat=shell,
            )
        )
        body.append(ellipsoid((0.012, 0.012, 0.011), (0, 0, h * 1.02), 10, 6, black))
        path = spline([(r * 0.72, 0, h * 0.4), (r * 1.05, 0, h * 0.62), (r * 1.38, 0, h * 0.92)], 3)
        body.append(tube(path, [0.022, 0.021, 0.019, 0.017, 0.015, 0.013, 0.012], 10, mat=shell))
        body.append(ellipsoid((0.014, 0.014, 0.012), (r * 1.39, 0, h * 0.93), 10, 6, black))
        arc = [
            (r * 0.72 * math.cos(a), 0, h * 0.72 + h * 0.72 * math.sin(a))
            for a in np.linspace(0.1, math.pi - 0.1, 11)
        ]
        body.append(tube(arc, 0.005, 6, mat=metal("b5b9bd", "6d7278"), up=(0, 1.0, 0)))
        body.append(tube(arc[3:8], 0.011, 8, mat=black, up=(0, 1.0, 0)))
        pieces = [
            cylinder_piece(r, 0, h * 0.42, 12, r * 0.93),
            cylinder_piece(r * 0.93, h * 0.42, h * 0.9, 12, r * 0.4),
        ]
        pieces.append(
            np.array(
                [
                    (x, y, z)
                    for x, z in ((r * 0.8, h * 0.3), (r * 1.38, h * 0.98), (r * 0.75, h * 0.7))
                    for y in (-0.018, 0.018)
                ]
            )
        )
        pieces.append(box_piece((0, 0, h * 1.4), (r, 0.022, 0.03)))
        mass, title = 1.2, "stove kettle"
    return Model(
        title=title, parts={"body": Part(body, collision=pieces)}, mass=mass, texture_size=128
    )


def kettle_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.19, 0.22),
        "accent": pick(rng, ["#1c1c1e", "#3a3a3e"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "pot": Maker(
        pot,
        pot_random,
        count=3,
        presets=[
            {"colour": "", "saucepan": False},
            {"colour": "#b3302c", "saucepan": False},
            {"colour": "", "saucepan": True, "radius": 0.085, "height": 0.09},
        ],
    ),
    "frying_pan": Maker(
        frying_pan,
        frying_pan_random,
        count=2,
        presets=[
            {"outside": "#2a2b2e", "handle": "#1c1c1e"},
            {"outside": "#9a2f2b", "handle": "#6b3d1e"},
        ],
    ),
    "kettle": Maker(
        kettle,
        kettle_random,
        count=3,
        presets=[
            {"style": "electric", "colour": "steel"},
            {"style": "stove", "colour": "#b3302c"},
            {"style": "electric", "colour": "#eceae4", "accent": "#54585e"},
        ],
    ),
}
