"""Electric things of a desk: alarm clock, lamp, extension lead."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import Material, glowing, metal, plain, shade
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
    TAU,
    box,
    extrude,
    lathe,
    spline,
    tube,
)

from makers.projection import project_label


def alarm_clock(style: str, radius: float, colour: str, paper: str, ink: str, hour: float) -> Model:
    """A twin-bell alarm clock, or a box with lit digits ('digital')."""
    paint = plain(colour, 0.03)
    if style == "digital":
        minutes = int(hour % 1 * 60)
        panel = printed(prints.digital_time(f"{int(hour):02d}:{minutes:02d}", ink), occlusion=0.0)
        body = extrude(
            [(-0.035, 0), (0.035, 0), (0.027, 0.07), (-0.033, 0.07)],
            0.15,
            mat=paint,
            axis="y",
            bevel_width=0.005,
        )
        face = box(
            0.004, 0.126, 0.05, (0, 0, 0), plain("#0b0d10", 0), labels={"+x": panel}, weight=1.4
        )
        face.turn(ry=-0.114).move(0.0325, 0, 0.009)
        button = box(0.02, 0.06, 0.006, (-0.003, 0, 0.069), plain(shade(colour, 1.6), 0.02), 0.002)
        pieces = [box_piece((0, 0, 0.037), (0.07, 0.15, 0.074))]
        return Model(
            "digital alarm clock", {"body": Part([body, face, button], collision=pieces)}, mass=0.25
        )
    r, centre = radius, radius + 0.016
    dial = printed(prints.clock_face(paper, ink, hour))
    steel = metal("c9cdd1", "80878d")
    ring = [
        (0, -0.022),
        (r * 0.8, -0.022),
        (r, -0.012),
        (r, 0.02),
        (r * 0.93, 0.024),
        (r * 0.9, 0.018),
        (0, 0.018),
    ]
    case = lathe(ring, 28, mats=[paint], weight=1.0)
    case.turn(ry=math.pi / 2).move(0, 0, centre)
    project_label(
        case, dial, "+x", (0, centre), (1.8 * r, 1.8 * r), 0.9, lambda c: abs(c[0] - 0.018) < 0.001
    )
    meshes = [case.weigh(1.4)]
    for q in (-1, 1):
        bell = lathe(
            [(0, 0.02), (0.014, 0.016), (0.021, 0.004), (0.0215, 0), (0.018, 0), (0, 0.004)],
            12,
            mat=steel,
        )
        lean = q * 0.62
        meshes.append(
            bell.turn(rx=-lean).move(
                0, math.sin(lean) * (r + 0.003), centre + math.cos(lean) * (r + 0.003)
            )
        )
        foot = tube(
            [(0, q * r * 0.5, 0.018), (0, q * r * 0.72, 0.001)], [0.005, 0.0065], 7, mat=steel
        )
        meshes.append(foot)
    top = centre + r
    loop = [
        (0, y, top + 0.012 + 0.022 * math.sqrt(max(0, 1 - (y / 0.034) ** 2)))
        for y in np.linspace(-0.034, 0.034, 9)
    ]
    meshes.append(tube(loop, 0.003, 6, mat=steel))
    meshes.append(
        lathe(
            [(0, 0), (0.003, 0), (0.003, 0.016), (0.006, 0.018), (0.006, 0.024), (0, 0.026)],
            8,
            mat=steel,
        ).move(0, 0, top - 0.002)
    )
    pieces = [
        cylinder_piece(r, -0.022, 0.024, 14) @ np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]])
        + [0, 0, centre],
        box_piece((0, 0, 0.0065), (0.012, r * 1.6, 0.018)),
        box_piece((0, 0, top + 0.012), (0.04, 0.08, 0.03)),
    ]
    return Model("twin-bell alarm clock", {"body": Part(meshes, collision=pieces)}, mass=0.3)


def alarm_clock_random(rng: np.random.Generator) -> dict:
    return {
        "style": "bells",
        "radius": uniform(rng, 0.048, 0.056),
        "colour": pick(rng, ["#c8303a", "#2f8f8a", "#26282c", "#e8b92c"]),
        "paper": "#fffdf4",
        "ink": "#222222",
        "hour": uniform(rng, 1, 11.9),
    }


def desk_lamp(height: float, colour: str, steel_arm: bool) -> Model:
    """A jointed desk lamp; variant `on` has a glowing bulb and a warm glow inside the shade."""
    s = height / 0.42
    paint, arm = plain(colour, 0.03), metal() if steel_arm else plain(shade(colour, 0.85), 0.03)
    base = lathe(
        [
            (0, 0),
            (0.078, 0),
            (0.082, 0.004),
            (0.08, 0.014),
            (0.068, 0.02),
            (0.016, 0.024),
            (0, 0.024),
        ],
        24,
        mat=paint,
    )
    elbow, neck = (-0.105 * s, 0, 0.235 * s), (0.04 * s, 0, 0.385 * s)
    foot = (0, 0, 0.022)
    meshes = [base]
    for q in (-1, 1):
        shift = np.array([0, 0.011 * q, 0])
        meshes += [
            tube([np.add(foot, shift), np.add(elbow, shift)], 0.004, 6, mat=arm),
            tube([np.add(elbow, shift), np.add(neck, shift)], 0.004, 6, mat=arm),
        ]
    knob = plain("#26282c", 0.04)
    for at, radius in ((foot, 0.012), (elbow, 0.014), (neck, 0.013)):
        knuckle = lathe(
            [(0, -0.019), (radius, -0.019), (radius, 0.019), (0, 0.019)], 10, mat=knob
        ).turn(rx=math.pi / 2)
        meshes.append(knuckle.move(at[0], 0, at[2] + (0.006 if at is foot else 0)))
    wall = 0.005
    outer = [(0, 0.075), (0.018, 0.075), (0.026, 0.066), (0.034, 0.05), (0.066, 0.012), (0.072, 0)]
    inner = [(0.072 - wall, 0), (0.06, 0.012), (0.029, 0.05), (0, 0.056)]

    def hood(material: Material) -> Mesh:
        return lathe(
            [*outer, *inner][::-1], 22, mats=[paint, material], mat_of_segment=[1] * 3 + [0] * 6
        )

    def place(mesh: Mesh) -> Mesh:
        return mesh.scale(s).turn(ry=-0.55).move(neck[0] + 0.04 * s, 0, neck[2] - 0.058 * s)

    glow_inside = Material(occlusion=0.0)
    glow_inside.colour("#ffe9b0")
    bulb_shape = [(0, 0), (0.014, 0.006), (0.02, 0.018), (0.018, 0.03), (0.011, 0.045), (0, 0.05)]
    bulb_off, bulb_on = plain("#f4f2ea", 0.02), glowing("#fff6d0")
    parts = {
        "body": Part(
            meshes,
            collision=[
                cylinder_piece(0.082, 0, 0.022, 12),
                *(
                    np.r_[box_piece(a, (0.016, 0.03, 0.016)), box_piece(b, (0.016, 0.03, 0.016))]
                    for a, b in ((foot, elbow), (elbow, neck))
                ),
                box_piece(
                    (neck[0] + 0.03 * s, 0, neck[2] - 0.03 * s), (0.13 * s, 0.12 * s, 0.08 * s)
                ),
            ],
        ),
        "shade": Part(
            [place(hood(plain("#f3f0e6", 0.02))), place(lathe(bulb_shape, 10, mat=bulb_off))],
            collision="none",
        ),
        "shade_lit": Part([place(hood(glow_inside))], collision="none"),
        "bulb_lit": Part(
            [place(lathe(bulb_shape, 10, mat=bulb_on))], rgba=(1.8, 1.8, 1.7, 1.0), collision="none"
        ),
    }
    return Model(
        "desk lamp",
        parts,
        mass=1.3,
        texture_size=128,
        variants={"default": ["body", "shade"], "on": ["body", "shade_lit", "bulb_lit"]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["bulb_lit"]},
            {"state": "OFF", "variants": ["default"], "parts": ["shade"]},
        ],
    )


def desk_lamp_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.38, 0.45),
        "colour": pick(rng, ["#c8302c", "#26282c", "#2f7f8f", "#e8c23a"]),
        "steel_arm": True,
    }


def extension_cord(colour: str, block: str, sockets: int, coiled: bool, seed: int) -> Model:
    """A multi-socket block with its cable lying on the floor, in loose loops or a coil."""
    rng = np.random.default_rng(seed)
    length = 0.05 + 0.05 * sockets
    white, dark = plain(block, 0.03), plain("#2a2b2e", 0.03)
    meshes = [box(length, 0.056, 0.038, (0.06, 0, 0), white, 0.006)]
    for i in range(sockets):
        x = 0.06 - length / 2 + 0.05 + 0.05 * i
        well = lathe(
            [(0.019, 0.0), (0.0185, 0.0008), (0, 0.0008)], 14, mat=plain(shade(block, 0.78), 0.0)
        ).move(x, 0, 0.0378)
        meshes.append(well)
        for q in (-1, 1):
            meshes.append(
                lathe([(0.003, 0), (0, 0.0006)], 6, mat=dark, weight=0.6).move(
                    x, q * 0.0095, 0.0387
                )
            )
    meshes.append(
        box(0.012, 0.02, 0.006, (0.06 - length / 2 + 0.014, 0, 0.0365), plain("#d8302c", 0), 0.001)
    )
    start = (0.06 - length / 2 + 0.004, 0.0)
    if coiled:
        turns = [
            (
                -0.16 + (0.085 + 0.01 * math.sin(3 * t)) * math.cos(t),
                0.06 + (0.085 + 0.011 * math.sin(2 * t + 1)) * math.sin(t),
            )
            for t in np.linspace(-1.2, 3.2 * TAU - 1.2, 34)
        ]
        points = [start, (start[0] - 0.05, -0.01), *turns, (-0.3, 0.1), (-0.33, 0.02)]
        heights = np.r_[0.018, 0.0045, 0.0045 + np.arange(34) / 33 * 0.026, 0.0045, 0.0045]
    else:
        points = [start, (start[0] - 0.06, 0.0)]
        x = start[0] - 0.1
        for k in range(4):
            q = 1 if k % 2 else -1
            points += [
                (x, q * float(rng.uniform(0.03, 0.09))),
                (x - 0.04, q * float(rng.uniform(0.09, 0.14))),
                (x - 0.08, q * 0.03),
            ]
            x -= 0.1
        points += [(x, 0.02), (x - 0.05, 0.0)]
        heights = np.r_[0.018, np.full(len(points) - 1, 0.0045)]
    path = spline(np.c_[np.array(points), heights], 1 if coiled else 2)
    meshes.append(tube(path, 0.0045, 5, mat=plain(colour, 0.03), up=(0, 0, 1), weight=0.6))
    end, towards = path[-1], path[-1] - path[-2]
    turn = math.atan2(towards[1], towards[0])
    plug = lathe(
        [(0, 0), (0.009, 0), (0.016, 0.014), (0.0175, 0.034), (0, 0.034)],
        10,
        mat=plain(block, 0.03),
    ).turn(ry=math.pi / 2)
    prongs = [
        tube([(0.03, q * 0.008, 0), (0.052, q * 0.008, 0)], 0.0026, 6, mat=metal()) for q in (-1, 1)
    ]
    for mesh in (plug, *prongs):
        meshes.append(mesh.turn(rz=turn).move(end[0] - 0.004 * math.cos(turn), end[1], 0.0175))
    pieces = [
        box_piece((0.06, 0, 0.02), (length, 0.056, 0.04)),
        box_piece((end[0], end[1], 0.0175), (0.04, 0.034, 0.034)),
    ]
    flat = path[4:]
    for a in range(0, len(flat) - 1, 6):
        span = flat[a : a + 7]
        low, high = span.min(0) - 0.0045, span.max(0) + 0.0045
        pieces.append(box_piece((low + high) / 2, high - low))
    return Model(
        "extension lead",
        {"body": Part(meshes, collision=pieces)},
        mass=0.4,
        friction=0.7,
        texture_size=128,
    )


def extension_cord_random(rng: np.random.Generator) -> dict:
    return {
        "colour": pick(rng, ["#f1f1ee", "#2a2b2e", "#e8702c"]),
        "block": pick(rng, ["#f1f1ee", "#3a3c40"]),
        "sockets": 3,
        "coiled": True,
        "seed": int(rng.integers(1e9)),
    }


MODELS = {
    "alarm_clock": Maker(
        alarm_clock,
        alarm_clock_random,
        3,
        [
            {"colour": "#c8303a"},
            {"style": "digital", "colour": "#2a2c30", "ink": "#ff5a3a"},
            {"colour": "#2f8f8a"},
        ],
    ),
    "desk_lamp": Maker(
        desk_lamp,
        desk_lamp_random,
        3,
        [{"colour": "#c8302c"}, {"colour": "#26282c"}, {"colour": "#e8c23a"}],
    ),
    "extension_cord": Maker(
        extension_cord,
        extension_cord_random,
        3,
        [
            {"colour": "#f1f1ee", "block": "#f1f1ee"},
            {"coiled": False, "colour": "#2a2b2e", "block": "#3a3c40"},
            {"coiled": False, "colour": "#e8702c", "block": "#2a2b2e"},
        ],
    ),
}
