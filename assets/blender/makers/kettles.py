"""Kettles: electric jugs on their base, whistling stove kettles, goosenecks."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import box, ellipsoid, extrude, lathe, spline, tube


def old_kettle(style: str, shell: Material, black: Material, height: float):
    """An electric jug or a whistling stove kettle: meshes and collision pieces."""
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
    return body, pieces


def base_plate(radius: float, black: Material) -> Mesh:
    plate = [(0, 0), (radius, 0), (radius, 0.014), (radius * 0.92, 0.02), (0, 0.02)]
    return lathe(plate, 20, mat=black)


def lid(radius: float, z: float, mat: Material, knob: Material) -> list[Mesh]:
    dome = [
        (0, z),
        (radius, z),
        (radius * 0.9, z + 0.008),
        (radius * 0.4, z + 0.014),
        (0, z + 0.015),
    ]
    return [
        lathe(dome, 16, mat=mat),
        ellipsoid((0.012, 0.012, 0.01), (0, 0, z + 0.022), 8, 5, knob),
    ]


def new_kettle(style: str, shell: Material, black: Material):
    """A gooseneck, pyramid, glass or enamel kettle: meshes and collision pieces."""
    if style == "gooseneck":
        outer = [(0.078, 0.022), (0.08, 0.03), (0.074, 0.08), (0.055, 0.135), (0.052, 0.14)]
        body = [base_plate(0.075, black), lathe([(0, 0.021), *outer, (0, 0.14)], 18, mat=shell)]
        body += lid(0.05, 0.139, shell, black)
        points = [
            (0.07, 0, 0.05),
            (0.115, 0, 0.055),
            (0.125, 0, 0.1),
            (0.145, 0, 0.15),
            (0.175, 0, 0.152),
        ]
        neck = tube(
            spline(points, 3), np.linspace(0.0115, 0.0065, 13), 8, mat=shell, up=(0, 1.0, 0)
        )
        grip = [(-0.05, 0, 0.13), (-0.12, 0, 0.138), (-0.135, 0, 0.12), (-0.125, 0, 0.045)]
        body += [neck, tube(spline(grip, 3), 0.0105, 8, mat=black, up=(0, 1.0, 0), flatten=1.2)]
        pieces = [cylinder_piece(0.08, 0, 0.08, 12), cylinder_piece(0.075, 0.08, 0.17, 12, 0.03)]
        pieces += [neck.v.copy(), box_piece((-0.11, 0, 0.09), (0.03, 0.024, 0.1))]
    elif style == "pyramid":
        outer = [(0.092, 0.022), (0.096, 0.03), (0.088, 0.08), (0.06, 0.17), (0.05, 0.182)]
        steel = metal("c2c6ca", "7e848a")
        body = [base_plate(0.088, steel), lathe([(0, 0.021), *outer, (0, 0.182)], 22, mat=shell)]
        body += lid(0.049, 0.181, steel, black)
        beak = [(0.05, 0.125), (0.1, 0.165), (0.098, 0.172), (0.04, 0.176)]
        body.append(extrude(beak, 0.036, steel, axis="y", bevel_width=0.006))
        grip = [(-0.05, 0, 0.172), (-0.105, 0, 0.178), (-0.135, 0, 0.15), (-0.132, 0, 0.07)]
        body.append(tube(spline(grip, 3), 0.011, 8, mat=black, up=(0, 1.0, 0), flatten=1.3))
        pieces = [
            cylinder_piece(0.096, 0, 0.08, 12, 0.088),
            cylinder_piece(0.088, 0.08, 0.215, 12, 0.03),
        ]
        pieces += [np.array([(x, y, z) for x, z in beak for y in (-0.018, 0.018)])]
        pieces += [box_piece((-0.115, 0, 0.125), (0.04, 0.026, 0.12))]
    elif style == "glass":
        outer = [(0.078, 0.022), (0.08, 0.03), (0.08, 0.1), (0.078, 0.2), (0.074, 0.206)]
        m = Material(occlusion=0.4)
        water = m.ramp(
            m.remap(m.axis(2), 0, 0.206),
            [
                (0, "2a2c30"),
                (0.19, "2a2c30"),
                (0.2, "6fb6e0"),
                (0.66, "8ccbee"),
                (0.68, "f4fbff"),
                (0.7, "d3e4ea"),
                (0.95, "dfecf0"),
                (0.96, "2a2c30"),
                (1, "2a2c30"),
            ],
        )
        band = m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.45))
        m.colour(m.mix(m.remap(band, 0.0, 0.1, 0.55, 0), water, "ffffff"))
        body = [base_plate(0.082, black), lathe([(0, 0.021), *outer, (0, 0.206)], 22, mat=m)]
        body += lid(0.072, 0.205, black, black)
        beak = [(0.06, 0.165), (0.11, 0.2), (0.108, 0.207), (0.05, 0.205)]
        body.append(extrude(beak, 0.04, black, axis="y", bevel_width=0.006))
        grip = [
            (-0.07, 0, 0.198),
            (-0.125, 0, 0.196),
            (-0.138, 0, 0.13),
            (-0.125, 0, 0.05),
            (-0.076, 0, 0.04),
        ]
        body.append(tube(spline(grip, 3), 0.0115, 8, mat=black, up=(0, 1.0, 0), flatten=1.4))
        pieces = [
            cylinder_piece(0.08, 0, 0.21, 12),
            box_piece((-0.12, 0, 0.12), (0.04, 0.03, 0.17)),
        ]
        pieces += [np.array([(x, y, z) for x, z in beak for y in (-0.02, 0.02)])]
    else:  # enamel, tall and conical, with a bail and a gooseneck spout low on its wall
        outer = [(0.1, 0), (0.102, 0.006), (0.084, 0.1), (0.06, 0.155), (0.062, 0.16)]
        body = [
            lathe(
                [(0, 0.001), *outer, (0, 0.16)],
                22,
                mats=[shell, black],
                mat_of_segment=[0, 0, 0, 0, 1, 1],
            )
        ]
        body += lid(0.06, 0.159, shell, black)
        points = [(0.08, 0, 0.07), (0.12, 0, 0.09), (0.135, 0, 0.14), (0.165, 0, 0.17)]
        neck = tube(spline(points, 3), np.linspace(0.02, 0.0095, 10), 8, mat=shell, up=(0, 1.0, 0))
        turns = np.linspace(0.15, math.pi - 0.15, 11)
        arch = [(0.075 * math.cos(a), 0, 0.13 + 0.115 * math.sin(a)) for a in turns]
        wire = metal("b5b9bd", "6d7278")
        body += [neck, tube(arch, 0.004, 5, mat=wire, up=(0, 1.0, 0))]
        body.append(tube(arch[3:8], 0.0105, 8, mat=black, up=(0, 1.0, 0)))
        pieces = [
            cylinder_piece(0.102, 0, 0.1, 12, 0.084),
            cylinder_piece(0.084, 0.1, 0.19, 12, 0.03),
        ]
        pieces += [neck.v.copy(), box_piece((0, 0, 0.238), (0.08, 0.022, 0.025))]
    return body, pieces


TITLES = {
    "electric": "electric kettle",
    "stove": "whistling stove kettle",
    "gooseneck": "gooseneck kettle",
    "pyramid": "retro electric kettle",
    "glass": "glass electric kettle",
    "enamel": "enamel kettle",
}


def kettle(style="electric", colour="#d8dade", accent="#1c1c1e", height=0.2, look=0) -> Model:
    """A kettle of a style of TITLES, its spout to the right."""
    rng = np.random.default_rng(look)
    shell = (
        metal("c6cace", "80868c", (1, 1, 10), 40, noise_offset(rng))
        if colour == "steel"
        else plain(colour, 0.04, 15, noise_offset(rng))
    )
    black = plain(accent, 0.06, 120)
    if style in ("electric", "stove"):
        body, pieces = old_kettle(style, shell, black, height)
    else:
        body, pieces = new_kettle(style, shell, black)
    return Model(
        TITLES[style],
        {"body": Part(body, collision=pieces)},
        mass=1.1,
        texture_size=128,
        front="-y",
    )


def kettle_random(rng: np.random.Generator) -> dict:
    return {"accent": pick(rng, ["#1c1c1e", "#3a3a3e"]), "look": seed_of(rng)}


MODELS = {
    "kettle": Maker(
        kettle,
        kettle_random,
        count=8,
        presets=[
            {"style": "electric", "colour": "steel"},
            {"style": "stove", "colour": "#b3302c"},
            {"style": "electric", "colour": "#eceae4", "accent": "#54585e"},
            {"style": "gooseneck", "colour": "#2c2e32"},
            {"style": "glass", "accent": "#26282c"},
            {"style": "pyramid", "colour": "#bfd8cf", "accent": "#26282c"},
            {"style": "enamel", "colour": "#2f5f9a", "accent": "#15181c"},
            {"style": "stove", "colour": "steel"},
        ],
    ),
}
