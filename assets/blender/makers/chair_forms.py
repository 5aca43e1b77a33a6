"""Office chairs in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Model
from toolkit.shapes import extrude, lathe, loft, rounded_rectangle, spline, tube

from .casework import metal_or
from .joinery import Assembly, cushion, fabric, finish, surface
from .upholstery import leather, section, solid_path, wall

Offset = tuple[float, float, float]


def star(
    asm: Assembly, metal, radius: float = 0.28, hub_z: float = 0.1, top: float = 0.4, feet: int = 5
) -> None:
    """A foot of arms on castors and the column on it."""
    tyre = plain("#1f2021", 0.06, 20)
    for k in range(feet):
        a = 2 * math.pi * k / feet + math.pi / 5
        c, s = math.cos(a), math.sin(a)
        arm = [(0.02 * c, 0.02 * s, hub_z + 0.01), (radius * c, radius * s, hub_z - 0.035)]
        asm.add("body", tube(arm, (0.028, 0.016), 6, mat=metal, flatten=0.7))
        wheel = [
            (0, -0.02),
            (0.022, -0.02),
            (0.026, -0.012),
            (0.026, 0.012),
            (0.022, 0.02),
            (0, 0.02),
        ]
        mesh = lathe(wheel, 9, mat=tyre).turn(rx=math.pi / 2).turn(rz=a + 0.9)
        asm.add("body", mesh.move(radius * c, radius * s, 0.026))
        asm.solid(
            "body",
            (radius * c - 0.022, radius * s - 0.022, 0),
            (radius * c + 0.022, radius * s + 0.022, 0.06),
        )
        asm.piece(
            "body",
            np.array(
                [
                    (q * c - w * s, q * s + w * c, z)
                    for q in (0, radius)
                    for w in (-0.015, 0.015)
                    for z in (0.06, 0.1)
                ]
            ),
        )
    column = [
        (0, hub_z - 0.03),
        (0.034, hub_z - 0.03),
        (0.034, hub_z + 0.03),
        (0.025, hub_z + 0.05),
        (0.025, 0.26),
        (0.016, 0.265),
        (0.016, top),
        (0, top),
    ]
    asm.add("body", lathe(column, 10, mat=metal), solid=True)


def _done(
    title: str, asm: Assembly, mass: float, z: float, half: float = 0.18, back: float = -0.1
) -> Model:
    seat = surface("seat", (back, -half), (0.19, half), z)
    return Model(title, asm.parts(), mass, supports=[seat], ground_shadow=True)


def _back_piece(asm: Assembly, x: float, z0: float, z1: float, lean: float, half: float) -> None:
    pts = [
        (x + e - lean * (z - z0), y, z)
        for z in (z0, z1)
        for e in (-0.05, 0.05)
        for y in (-half, half)
    ]
    asm.piece("body", np.array(pts))


def executive(
    colour: str = "#2b2624", metal: str = "steel", height: float = 1.17, offset: Offset = (0, 0, 0)
) -> Model:
    """A director's chair: a high padded back of leather in rolls, looped arm rests."""
    asm, hide, frame = Assembly(), leather(colour, offset), metal_or(metal)
    star(asm, frame, 0.3)
    asm.board("body", (-0.12, -0.12, 0.39), (0.12, 0.12, 0.415), plain("#1f2021", 0.05, 20))
    asm.add("body", cushion((0.5, 0.52, 0.12), (0.02, 0, 0.4), hide, 0.09, 0.025, 0.05), solid=True)
    lean = 0.13
    z = 0.53
    for tall in (0.24, 0.21, 0.18):
        pad = cushion(
            (tall + 0.03, 0.5 - 0.05 * (z > 0.9), 0.09), (0, 0, 0), hide, 0.07, 0.03, 0.04
        )
        pad.turn(ry=math.pi / 2 - lean).move(-0.25 - lean * (z + tall / 2 - 0.5), 0, z + tall / 2)
        asm.add("body", pad)
        z += tall - 0.015
    asm.board("body", (-0.3, -0.05, 0.4), (-0.27, 0.05, 0.75), frame, 0.004, solid=False)
    _back_piece(asm, -0.24, 0.54, min(height, z), lean, 0.24)
    for s in (-1, 1):
        y = s * 0.285
        loop = [
            (0.12, s * 0.24, 0.43),
            (0.15, y, 0.5),
            (0.14, y, 0.66),
            (-0.16, y, 0.68),
            (-0.27, s * 0.25, 0.7),
        ]
        asm.add("body", tube(spline(loop, 3), 0.016, 6, mat=frame))
        asm.add(
            "body",
            cushion((0.26, 0.06, 0.035), (0.0, y, 0.668), hide, 0.025, 0.006, 0.014),
            solid=True,
        )
        asm.solid("body", (0.12, y - 0.02, 0.44), (0.16, y + 0.02, 0.66))
    return _done("executive chair of leather", asm, 17.0, 0.544)


def gaming(colour: str = "#c0302c", offset: Offset = (0, 0, 0)) -> Model:
    """A racing seat on castors: shoulder wings, side bolsters, a stripe, two small cushions."""
    asm, black = Assembly(), plain("#232427", 0.06, 25, offset)
    skin, bright = leather("#26272a", offset), plain(colour, 0.05, 20)
    star(asm, black, 0.3)
    asm.board("body", (-0.12, -0.12, 0.39), (0.12, 0.12, 0.42), black)
    asm.add("body", cushion((0.5, 0.34, 0.09), (0.02, 0, 0.41), skin, 0.05, 0.01, 0.04), solid=True)
    for s in (-1, 1):
        side = cushion((0.48, 0.1, 0.12), (0.02, s * 0.21, 0.41), bright, 0.045, 0.01, 0.045)
        asm.add("body", side, solid=True)
    outline = [
        (-0.17, 0.0),
        (0.17, 0.0),
        (0.24, 0.1),
        (0.2, 0.3),
        (0.27, 0.46),
        (0.23, 0.58),
        (0.13, 0.62),
        (0.12, 0.76),
    ]
    half = spline(outline[1:], 2)
    shape = np.r_[half, (half * [-1, 1])[::-1]]
    rings = []
    lean = -0.16
    for x, k in ((0.0, 0.9), (0.012, 0.98), (0.07, 1.0), (0.085, 0.94)):
        rings.append(
            np.array(
                [
                    (x + 0.0 + 0.06 * (abs(y) > 0.16) * (x > 0.05), y * k, 0.38 + (z - 0.38) * k)
                    for y, z in shape
                ]
            )
        )
    back = loft(rings, skin).outward().turn(ry=lean).move(-0.24, 0, 0.43)
    asm.add("body", back)
    for s in (-1, 1):
        stripe = [(0.088, s * 0.07, 0.1), (0.091, s * 0.09, 0.4), (0.089, s * 0.06, 0.7)]
        asm.add("body", tube(stripe, 0.014, 5, mat=bright).turn(ry=lean).move(-0.24, 0, 0.43))
        wing = [
            (0.1, s * 0.2, 0.14),
            (0.11, s * 0.18, 0.3),
            (0.12, s * 0.23, 0.45),
            (0.11, s * 0.2, 0.56),
        ]
        asm.add(
            "body", tube(spline(wing, 2), 0.03, 6, mat=bright).turn(ry=lean).move(-0.25, 0, 0.43)
        )
    head = cushion((0.12, 0.24, 0.05), (0, 0, 0), bright, 0.05, 0.015, 0.024)
    asm.add("body", head.turn(ry=math.pi / 2 + lean).move(-0.265, 0, 1.04))
    lumbar = cushion((0.16, 0.28, 0.05), (0, 0, 0), bright, 0.05, 0.015, 0.024)
    asm.add("body", lumbar.turn(ry=math.pi / 2 + lean).move(-0.17, 0, 0.66))
    _back_piece(asm, -0.21, 0.5, 1.15, 0.16, 0.22)
    for s in (-1, 1):
        y = s * 0.31
        asm.board("body", (-0.03, y - 0.02, 0.41), (0.03, y + 0.02, 0.66), black, 0.008)
        asm.board("body", (-0.03, min(y, s * 0.1), 0.4), (0.03, max(y, s * 0.1), 0.42), black)
        asm.board("body", (-0.13, y - 0.04, 0.655), (0.13, y + 0.04, 0.685), black, 0.012)
    return _done("gaming chair", asm, 19.0, 0.512, 0.13, -0.02)


def banker_chair(
    wood: str = "oak", seat: str | None = "#3f5a4a", offset: Offset = (0, 0, 0)
) -> Model:
    """An old swivel chair of wood: a bent arm rail on spindles, a wooden star foot."""
    asm, up = Assembly(), finish(wood, 2, offset)
    star(asm, up, 0.29, 0.12, 0.4, 4)
    ring = rounded_rectangle(0.46, 0.48, 0.16, 4)
    rings = [
        np.c_[ring * k, np.full(len(ring), z)]
        for k, z in ((0.94, 0.41), (1, 0.425), (1, 0.445), (0.96, 0.452))
    ]
    asm.add("body", loft(rings, finish(wood, 1, offset)))
    asm.solid("body", (-0.21, -0.22, 0.4), (0.22, 0.22, 0.452))
    z = 0.452
    if seat:
        asm.add(
            "body",
            cushion((0.4, 0.42, 0.03), (0, 0, 0.452), leather(seat, offset), 0.12, 0.012, 0.014),
        )
        z = 0.486
    a = np.linspace(-math.radians(118), math.radians(118), 17)
    path = np.array([(-0.25 * math.cos(t), 0.27 * math.sin(t)) for t in a])

    def top(s: float) -> float:
        return 0.7 + 0.12 * math.cos((s - 0.5) * math.pi) ** 4

    asm.add("body", wall(path, lambda s: section(0.04, 0.665, top(s), 0.012), up))
    for k in range(0, 17, 2):
        x, y = path[k]
        asm.add("body", tube([(0.86 * x, 0.82 * y, 0.44), (x, y, 0.68)], 0.011, 6, mat=up))
    solid_path(asm, path, 0.04, 0.46, top)
    return _done("wooden swivel chair", asm, 14.0, z)


def shell_chair(colour: str = "#d9a441", metal: str = "steel", offset: Offset = (0, 0, 0)) -> Model:
    """One moulded shell for seat and back on a star foot."""
    asm, shell = Assembly(), plain(colour, 0.04, 10, offset)
    star(asm, metal_or(metal), 0.27, 0.1, 0.44)
    curve = spline(
        [
            (0.24, 0.43),
            (0.2, 0.455),
            (0.05, 0.44),
            (-0.12, 0.445),
            (-0.2, 0.5),
            (-0.235, 0.62),
            (-0.26, 0.82),
        ],
        3,
    )
    rings = []
    n = len(curve)
    for k, (x, z) in enumerate(curve):
        u = k / (n - 1)
        w = 0.2 + 0.05 * math.sin(math.pi * min(1.0, u * 1.25)) - 0.03 * max(0.0, u - 0.75) / 0.25
        w *= 0.86 if k in (0, n - 1) else 1.0
        tx, tz = np.gradient(curve, axis=0)[k]
        nrm = np.array([-tz, tx]) / math.hypot(tx, tz)
        nrm = -nrm if nrm[1] * (1 - u) + nrm[0] * u < 0 else nrm
        ys = np.linspace(-w, w, 7)
        face = [
            (x + nrm[0] * 0.05 * (y / w) ** 2 * 1.2, y, z + nrm[1] * 0.05 * (y / w) ** 2 * 1.2)
            for y in ys
        ]
        under = [(px - nrm[0] * 0.014, y, pz - nrm[1] * 0.014) for px, y, pz in face[::-1]]
        rings.append(np.array([*face, *under]))
    asm.add("body", loft(rings, shell).outward())
    asm.solid("body", (-0.17, -0.2, 0.425), (0.22, 0.2, 0.448))
    pts = [
        (x, y, z)
        for x, z in ((-0.18, 0.5), (-0.22, 0.5), (-0.24, 0.82), (-0.28, 0.82))
        for y in (-0.2, 0.2)
    ]
    asm.piece("body", np.array(pts))
    pad = cushion((0.3, 0.34, 0.02), (0.03, 0, 0.446), fabric("#4a4a4c", offset), 0.1, 0.008, 0.01)
    asm.add("body", pad)
    return _done("swivel chair with a plastic shell", asm, 8.0, 0.474, 0.14)


def kneeler(colour: str = "#3f5f8a", wood: str = "birch", offset: Offset = (0, 0, 0)) -> Model:
    """No back: a sloping seat and a pad for the shins on two curved beams with castors."""
    asm, timber, cloth = Assembly(), finish(wood, 0, offset), fabric(colour, offset)
    for s in (-1, 1):
        y = s * 0.14
        beam = spline([(-0.28, 0.06), (-0.1, 0.2), (0.08, 0.42), (0.14, 0.5)], 4)
        shape = [*beam, *[(x + 0.055, z - 0.02) for x, z in beam[::-1]]]
        asm.add("body", extrude(shape, 0.03, timber, axis="y").move(-0.12, y, 0))
        low = spline([(-0.3, 0.06), (-0.05, 0.16), (0.2, 0.2), (0.3, 0.3)], 3)
        shape = [*low, *[(x + 0.01, z - 0.05) for x, z in low[::-1]]]
        asm.add("body", extrude(shape, 0.03, timber, axis="y").move(0.0, y * 0.8, 0))
        asm.solid("body", (-0.36, y - 0.015, 0.04), (-0.2, y + 0.015, 0.12))
        asm.solid("body", (0.0, y - 0.015, 0.15), (0.28, y + 0.015, 0.2))
    asm.solid("body", (-0.1, -0.15, 0.2), (0.0, 0.15, 0.48))
    for x in (-0.36, 0.2):
        asm.board("body", (x - 0.03, -0.25, 0.055), (x + 0.03, 0.25, 0.09), timber, 0.008)
        for y in (-0.22, 0.22):
            wheel = [(0, -0.02), (0.024, -0.02), (0.028, 0), (0.024, 0.02), (0, 0.02)]
            asm.add(
                "body",
                lathe(wheel, 10, mat=plain("#1f2021", 0.06, 20))
                .turn(rx=math.pi / 2)
                .move(x, y, 0.028),
            )
            asm.solid("body", (x - 0.02, y - 0.02, 0), (x + 0.02, y + 0.02, 0.06))
    asm.board("body", (0.17, -0.04, 0.08), (0.23, 0.04, 0.17), timber)
    seat = cushion((0.32, 0.42, 0.08), (0, 0, 0), cloth, 0.08, 0.02, 0.035)
    asm.add("body", seat.turn(ry=0.3).move(-0.06, 0, 0.49))
    asm.solid("body", (-0.2, -0.2, 0.47), (0.09, 0.2, 0.55))
    knee = cushion((0.22, 0.46, 0.08), (0, 0, 0), cloth, 0.07, 0.02, 0.035)
    asm.add("body", knee.turn(ry=-0.62).move(0.27, 0, 0.25))
    asm.solid("body", (0.17, -0.22, 0.2), (0.36, 0.22, 0.34))
    seat_at = surface("seat", (-0.17, -0.16), (0.03, 0.16), 0.578)
    return Model("kneeling chair", asm.parts(), 9.0, supports=[seat_at], ground_shadow=True)


OFFICE_CHAIRS = [(executive, {}), (gaming, {}), (banker_chair, {}), (shell_chair, {})]
OFFICE_CHAIRS += [(executive, {"colour": "#6b4630"}), (shell_chair, {"colour": "#e6e4de"})]
