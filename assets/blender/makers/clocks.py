"""Alarm clocks and wall clocks."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import label as printed
from toolkit.materials import metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, extrude, lathe, rounded_rectangle, tube

from makers.projection import project_label
from makers.solids import cylinder, rod, solids


def _bells(radius: float, colour: str, paper: str, ink: str, hour: float) -> Model:
    """The classic one, two bells on top."""
    paint = plain(colour, 0.03)
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


def _drum(r: float, depth: float, colour: str, dial, n: int = 24) -> Mesh:
    """A round case looking to +X, its middle at the origin."""
    d = depth / 2
    ring = [(0, -d), (r * 0.94, -d), (r, -d * 0.7), (r, d * 0.8), (r * 0.94, d), (r * 0.9, d * 0.8)]
    case = lathe([*ring, (0, d * 0.8)], n, mats=[plain(colour, 0.03)])
    case.turn(ry=math.pi / 2)
    size = (1.8 * r, 1.8 * r)
    project_label(case, dial, "+x", (0, 0), size, 0.9, lambda c: abs(c[0] - d * 0.8) < 0.001)
    return case.weigh(1.4)


def _digits(style: str, colour: str, ink: str, hour: float) -> Model:
    """Lit digits: 'digital' (a low box) or 'cube'."""
    time = f"{int(hour):02d}:{int(hour % 1 * 60):02d}"
    panel, paint = printed(prints.digital_time(time, ink), occlusion=0.0), plain(colour, 0.03)
    dark = plain("#0b0d10", 0)
    if style == "cube":
        body = box(0.085, 0.11, 0.095, (0, 0, 0), paint, 0.012)
        face = box(0.003, 0.1, 0.044, (0.0425, 0, 0.036), dark, labels={"+x": panel})
        top = cylinder(0.026, 0.005, (0, 0, 0.094), plain(shade(colour, 0.7), 0.02), 14)
        dots = [
            box(0.003, 0.012, 0.006, (0.0425, 0.02 * k, 0.02), plain(ink, 0)) for k in (-1, 0, 1)
        ]
        meshes = [body, face.weigh(1.5), top, *dots]
        return Model("digital alarm clock", {"body": Part(meshes, collision=solids(meshes))}, 0.3)
    side = [(-0.035, 0), (0.035, 0), (0.027, 0.07), (-0.033, 0.07)]
    body = extrude(side, 0.15, mat=paint, axis="y", bevel_width=0.005)
    face = box(0.004, 0.126, 0.05, (0, 0, 0), dark, labels={"+x": panel}, weight=1.4)
    face.turn(ry=-0.114).move(0.0325, 0, 0.009)
    button = box(0.02, 0.06, 0.006, (-0.003, 0, 0.069), plain(shade(colour, 1.6), 0.02), 0.002)
    pieces = [box_piece((0, 0, 0.037), (0.07, 0.15, 0.074))]
    body_part = Part([body, face, button], collision=pieces)
    return Model("digital alarm clock", {"body": body_part}, mass=0.25)


def alarm_clock(style: str, radius: float, colour: str, paper: str, ink: str, hour: float) -> Model:
    """A clock for the bedside: 'bells', lit digits ('digital', 'cube'), 'square' (for travelling),
    'bear' (a child's, with ears and feet)."""
    if style == "bells":
        return _bells(radius, colour, paper, ink, hour)
    if style in ("digital", "cube"):
        return _digits(style, colour, ink, hour)
    dial, paint = printed(prints.clock_face(paper, ink, hour)), plain(colour, 0.03)
    if style == "square":
        body = box(0.045, 0.09, 0.09, (0, 0, 0.004), paint, 0.009)
        face = box(0.003, 0.076, 0.076, (0.0225, 0, 0.011), plain(paper, 0), 0, 1, {"+x": dial})
        feet = box(0.05, 0.07, 0.006, (-0.002, 0, 0), plain("#26282c", 0.03))
        snooze = box(0.02, 0.05, 0.008, (0, 0, 0.092), plain(shade(colour, 1.9), 0.03), 0.002)
        meshes = [body, face.weigh(1.5), feet, snooze]
        return Model("alarm clock", {"body": Part(meshes, collision=solids(meshes))}, 0.15)
    r = radius
    drum = _drum(r, 0.05, colour, dial).move(0, 0, r + 0.014)
    meshes, inner = [drum], plain(shade(colour, 1.35), 0.03)
    for q in (-1, 1):
        at = (0, q * r * 0.78, r * 1.86 + 0.008)
        meshes.append(ellipsoid((0.014, 0.03, 0.03), at, 10, 6, paint))
        meshes.append(ellipsoid((0.006, 0.018, 0.018), (0.011, *at[1:]), 8, 5, inner))
        foot = ellipsoid((0.034, 0.019, 0.016), (0.008, q * r * 0.5, 0.0), 10, 6, paint)
        foot.warp(lambda x, y, z: (x, y, max(z, -0.008) + 0.008))
        meshes.append(foot)
        arm = [(0.01, q * r * 0.95, r + 0.02), (0.03, q * r * 1.12, r * 0.7)]
        meshes.append(tube(arm, [0.012, 0.014], 7, mat=paint))
    feet = [m for m in meshes[1:] if m.v[:, 2].mean() < 0.03]
    ears = [[m] for m in meshes[1:] if m.v[:, 2].mean() > 1.6 * r]
    body = Part(meshes, collision=solids([drum], feet, *ears))
    return Model("child's alarm clock", {"body": body}, mass=0.3)


def alarm_clock_random(rng: np.random.Generator) -> dict:
    return {
        "style": "bells",
        "radius": 0.052,
        "colour": pick(rng, ["#c8303a", "#2f8f8a", "#26282c", "#e8b92c"]),
        "paper": "#fffdf4",
        "ink": "#222222",
        "hour": 10.15,
    }


def wall_clock(kind: str, radius: float, rim: str, paper: str, ink: str, hour: float) -> Model:
    """A clock to hang on a wall, its back at the rear: 'round', 'square', 'octagon', 'sun' (rays),
    'pendulum' (in a long case) or 'cuckoo' (a little house)."""
    paint, r = plain(rim, 0.04), radius
    dial = printed(prints.clock_face(paper, ink, hour))
    meshes: list[Mesh] = []

    def dial_plate(size: float, x: float, z: float, n: int = 24) -> Mesh:
        """A round dial in a ring."""
        ring = [(0, 0), (size, 0), (size, 0.01), (size * 0.93, 0.013), (size * 0.91, 0.008)]
        plate = lathe([*ring, (0, 0.008)], n, mats=[plain(shade(rim, 0.6), 0.04)])
        plate.turn(ry=math.pi / 2).move(x, 0, z)
        fits = (1.84 * size, 1.84 * size)
        return project_label(
            plate, dial, "+x", (0, z), fits, 0.9, lambda c: abs(c[0] - x - 0.008) < 0.001
        ).weigh(1.4)

    if kind == "round":
        ring = [(0, 0), (r, 0), (r, 0.03), (r - 0.008, 0.036), (r - 0.018, 0.034)]
        case = lathe([*ring, (r - 0.02, 0.024), (0, 0.024)], 32, mats=[paint])
        case.turn(ry=math.pi / 2).move(0, 0, r)
        fits = (2 * r - 0.036, 2 * r - 0.036)
        project_label(case, dial, "+x", (0, r), fits, 0.9, lambda c: abs(c[0] - 0.024) < 0.001)
        turned = cylinder_piece(r, 0, 0.036, 16) @ np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]])
        pieces = [np.add(turned, (0, 0, r))]
        meshes = [case.weigh(1.2)]
    elif kind in ("square", "octagon"):
        if kind == "square":
            outline = rounded_rectangle(2 * r, 2 * r, 0.02, 3)
        else:
            a = np.arange(8) * math.pi / 4 + math.pi / 8
            outline = np.c_[np.cos(a), np.sin(a)] * r / math.cos(math.pi / 8)
        grain = wood(rim, shade(rim, 0.65), 1, 12) if kind == "octagon" else paint
        case = extrude(outline, 0.03, mat=grain, axis="x", bevel_width=0.006)
        meshes = [case.move(0.015, 0, r), dial_plate(0.82 * r, 0.0295, r)]
        pieces = solids([case])
    elif kind == "sun":
        for k in range(24):
            a, long = k * math.pi / 12, (1.0, 0.78)[k % 2] * r
            base = 0.5 * r
            spike = [(-0.013, base * 0.9), (0.013, base * 0.9), (0.005, long), (-0.005, long)]
            ray = extrude(spike, 0.008, mat=paint, axis="x")
            meshes.append(ray.turn(rx=a).move(0.006, 0, r))
        meshes.append(dial_plate(0.56 * r, 0.006, r, 24))
        pieces = solids(meshes)
    else:
        grain = wood(rim, shade(rim, 0.65), 2, 10)
        gold = metal("d8b050", "8a6a20")
        if kind == "pendulum":
            w, h, d = 0.25, 0.48, 0.07
            meshes.append(box(d, w, h - 0.09, (d / 2, 0, 0.03), grain, 0.006))
            roof = [(-w / 2 - 0.012, h - 0.07), (w / 2 + 0.012, h - 0.07), (0.0, h)]
            meshes.append(extrude(roof, d + 0.01, mat=grain, axis="x").move(d / 2))
            meshes.append(box(d, w * 0.7, 0.03, (d / 2, 0, 0), grain, 0.004))
            pane = plain("#2a1a10", 0.05)
            meshes.append(box(0.004, w * 0.6, 0.17, (d, 0, 0.045), pane))
            meshes.append(rod((d + 0.004, 0, 0.22), (d + 0.004, 0, 0.09), 0.004, gold, 5))
            meshes.append(cylinder(0.03, 0.008, (d, 0, 0.085), gold, 14, "x"))
            meshes.append(dial_plate(0.085, d, 0.31))
            pieces = solids(meshes)
        else:
            w, h, d, z0 = 0.2, 0.2, 0.075, 0.15
            meshes.append(box(d, w, h, (d / 2, 0, z0), grain, 0.003))
            for q in (-1, 1):
                slope = box(d + 0.014, 0.018, 0.18, (d / 2 + 0.007, 0, 0), paint)
                meshes.append(slope.turn(rx=q * 0.95).move(0, q * 0.148, z0 + h - 0.028))
            gable = [(-w / 2, z0 + h), (w / 2, z0 + h), (0, z0 + h + 0.075)]
            meshes.append(extrude(gable, d, mat=grain, axis="x").move(d / 2))
            meshes.append(dial_plate(0.07, d, z0 + 0.085))
            meshes.append(box(0.006, 0.05, 0.05, (d, 0, z0 + 0.17), plain("#2a1a10", 0)))
            bird, beak = plain("#f2c52a", 0.03), plain("#d8402c", 0)
            meshes.append(ellipsoid((0.018, 0.014, 0.015), (d + 0.006, 0, z0 + 0.19), 8, 5, bird))
            meshes.append(ellipsoid(0.011, (d + 0.012, 0, z0 + 0.205), 8, 5, bird))
            tip = (d + 0.019, 0, z0 + 0.205)
            meshes.append(cylinder(0.005, 0.008, tip, beak, 5, "x", 0.001))
            for y, low in ((-0.04, 0.02), (0.04, 0.0)):
                chain = rod((d / 2, y, z0), (d / 2, y, low + 0.06), 0.003, gold, 4)
                cone = [(0, 0), (0.012, 0.01), (0.014, 0.05), (0.004, 0.062), (0, 0.064)]
                weight = lathe(cone, 8, mat=plain("#6a4526", 0.08))
                meshes += [chain, weight.move(d / 2, y, low)]
            pieces = solids(meshes[:5], meshes[-4:-2], meshes[-2:])
    return Model("wall clock", {"body": Part(meshes, collision=pieces)}, mass=0.7)


def wall_clock_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "round",
        "radius": 0.15,
        "rim": pick(rng, ["#26282c", "#8a5a34", "#c8402c"]),
        "paper": "#fbf8ee",
        "ink": "#222222",
        "hour": 10.15,
    }


MODELS = {
    "alarm_clock": Maker(
        alarm_clock,
        alarm_clock_random,
        7,
        [
            {"colour": "#c8303a"},
            {"style": "digital", "colour": "#2a2c30", "ink": "#ff5a3a", "hour": 7.5},
            {"colour": "#2f8f8a"},
            {"style": "square", "colour": "#26282c"},
            {"style": "bear", "colour": "#b07a3e", "radius": 0.055},
            {"style": "cube", "colour": "#f2f2ee", "ink": "#3ad0ff", "hour": 6.75},
            {"style": "bear", "colour": "#e888b0", "radius": 0.055},
        ],
    ),
    "wall_clock": Maker(
        wall_clock,
        wall_clock_random,
        7,
        [
            {"rim": "#26282c"},
            {"rim": "#8a5a34"},
            {"kind": "square", "rim": "#2f6fb0"},
            {"kind": "pendulum", "rim": "#7a4a24"},
            {"kind": "cuckoo", "rim": "#8a5a30"},
            {"kind": "sun", "rim": "#d8a838", "radius": 0.23},
            {"kind": "octagon", "rim": "#9a6a3a"},
        ],
    ),
}
