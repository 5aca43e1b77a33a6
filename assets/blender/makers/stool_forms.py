"""Stools and bar stools in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Support, cylinder_piece, rectangle, round_polygon
from toolkit.sampling import noise_offset
from toolkit.shapes import lathe, loft, rounded_rectangle, spline, tube

from .casework import metal_or
from .designs import designed
from .joinery import Assembly, cushion, fabric, finish, leg

Offset = tuple[float, float, float]


def round_seat(r: float, z: float, height: float, mat: Material, soft: bool = False) -> Mesh:
    """A round seat between two heights: a dished board, or a cushion."""
    if soft:
        profile = [
            (0, z),
            (r - 0.012, z),
            (r, z + 0.014),
            (r, height - 0.02),
            (r - 0.014, height - 0.005),
        ]
        profile += [(0.6 * r, height + 0.004), (0, height + 0.006)]
    else:
        profile = [(0, z), (r - 0.014, z), (r, z + 0.012), (r, height - 0.006), (r - 0.008, height)]
        profile += [(0.7 * r, height - 0.005), (0, height - 0.007)]
    return lathe(profile, 22, mat=mat, weight=1.3)


def splayed(
    asm: Assembly, n: int, foot: float, head: float, z: float, r: tuple, mat: Material,
    start: float = math.pi / 4, sides: int = 8, rung: float | None = None, rung_r: float = 0.009,
) -> None:  # fmt: skip
    """`n` legs round the middle and, if wanted, rungs between them at a height."""

    def at(k: int, h: float) -> tuple[float, float, float]:
        a, q = start + 2 * math.pi * k / n, foot + (head - foot) * h / z
        return (q * math.cos(a), q * math.sin(a), h)

    for k in range(n):
        leg(asm, "body", at(k, 0)[:2], at(k, z)[:2], (0, z), r, mat, sides)
        if rung:
            level = rung + (0.03 if k % 2 and n == 4 else 0)
            asm.add("body", tube([at(k, level), at(k + 1, level)], rung_r, 6, mat=mat))


def _stool(title: str, asm: Assembly, mass: float, height: float, r: float, square: bool = False):
    polygon = rectangle(2 * r, 2 * r) if square else round_polygon(r, 14)
    seat = Support("seat", height, polygon)
    return Model(title, asm.parts(), mass, supports=[seat], ground_shadow=True)


def stool_milking(
    height: float = 0.42, width: float = 0.36, wood: str = "walnut", offset: Offset = (0, 0, 0)
) -> Model:
    """Three thick legs let into a heavy round seat."""
    asm, r = Assembly(), width / 2
    asm.add("body", round_seat(r, height - 0.05, height, finish(wood, 1, offset)))
    asm.piece("body", cylinder_piece(r, height - 0.05, height - 0.0035, 14))
    splayed(asm, 3, 0.95 * r, 0.5 * r, height - 0.045, (0.014, 0.023), finish(wood, 2, offset), 0.0)
    # Between the rim and the hollow: what is wide lies on the one, what is small in the other.
    return _stool("three-legged stool", asm, 3.4, height - 0.0035, r - 0.02)


def stool_rush(
    height: float = 0.45, width: float = 0.38, wood: str = "oak", seat: str = "#c8a866",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Four straight posts, rungs all round, a woven seat in four triangles."""
    asm, h, timber = Assembly(), width / 2, finish(wood, 2, offset)
    for x in (-1, 1):
        for y in (-1, 1):
            at = (x * (h - 0.018), y * (h - 0.018))
            leg(asm, "body", at, at, (0, height + 0.012), (0.015, 0.019), timber, 10)
    for s in (-1, 1):
        for z in (0.12, 0.24):
            for ends in (
                [(-h + 0.018, s * (h - 0.018), z), (h - 0.018, s * (h - 0.018), z)],
                [(s * (h - 0.018), -h + 0.018, z + 0.04), (s * (h - 0.018), h - 0.018, z + 0.04)],
            ):
                asm.piece("body", asm.add("body", tube(ends, 0.009, 6, mat=timber)).v)
    m = Material()
    a, b = m.math("ABSOLUTE", m.axis(0)), m.math("ABSOLUTE", m.axis(1))
    lines = m.math("SINE", m.math("MULTIPLY", m.math("MAXIMUM", a, b), 420.0))
    seam = m.remap(m.math("ABSOLUTE", m.math("SUBTRACT", a, b)), 0.004, 0.012, 0.7, 0)
    base = m.mix(m.remap(lines, -0.2, 0.8, 0, 0.6), seat, "#7a5a2a")
    m.colour(m.mix(seam, base, "#6a4c22"))
    for k, z in ((0.985, height - 0.035), (1.0, height - 0.015), (0.96, height)):
        _ = k, z
    ring = rounded_rectangle(width - 0.02, width - 0.02, 0.02, 3)
    rings = [np.c_[ring * k, np.full(len(ring), z)] for k, z in (
        (0.96, height - 0.045), (1, height - 0.03), (1, height - 0.012), (0.95, height),
        (0.4, height - 0.008))]  # fmt: skip
    asm.add("body", loft(rings, m, weight=1.3))
    asm.solid("body", (-h, -h, height - 0.045), (h, h, height))
    return _stool("stool with a woven seat", asm, 3.0, height, h - 0.03, True)


def stool_metal(
    height: float = 0.46, width: float = 0.4, colour: str = "#c0392b", back: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Pressed sheet metal: flared legs, a square seat with a hole for the hand."""
    asm, h = Assembly(), width / 2
    paint = plain(colour, 0.05, 14, offset)
    top = 0.74 * h
    for x in (-1, 1):
        for y in (-1, 1):
            foot, head = (x * (h - 0.016), y * (h - 0.016)), (x * (top - 0.03), y * (top - 0.03))
            leg(asm, "body", foot, head, (0, height - 0.02), (0.016, 0.03), paint, 4)
    k = 0.45
    span = h - (h - top) * k - 0.02
    z = k * height
    for s in (-1, 1):
        for low, high in (
            ((-span, s * span - 0.008, z), (span, s * span + 0.008, z + 0.03)),
            ((s * span - 0.008, -span, z), (s * span + 0.008, span, z + 0.03)),
        ):
            asm.board("body", low, high, paint)
    ring = rounded_rectangle(2 * top, 2 * top, 0.05, 4)
    cut = ((1, height - 0.055), (1.02, height - 0.02), (0.98, height), (0.82, height - 0.006))
    rings = [np.c_[ring * q, np.full(len(ring), t)] for q, t in cut]
    asm.add("body", loft(rings, paint, weight=1.3))
    asm.solid("body", (-top, -top, height - 0.05), (top, top, height - 0.004))
    hole = rounded_rectangle(0.03, 0.09, 0.014, 3)
    slot = [np.c_[hole, np.full(len(hole), t)] for t in (height - 0.02, height - 0.004)]
    asm.add("body", loft(slot, plain("#1a1a1a", 0)))
    if back:
        arch = [(-top + 0.02, s * (top - 0.02), height - 0.02) for s in (-1,)]
        arch += [(-top - 0.02, -top + 0.01, height + 0.2), (-top - 0.03, -0.1, height + 0.27)]
        arch += [(-top - 0.03, 0.1, height + 0.27), (-top - 0.02, top - 0.01, height + 0.2)]
        arch += [(-top + 0.02, top - 0.02, height - 0.02)]
        asm.add("body", tube(spline(arch, 3), 0.013, 6, mat=paint))
        low = (-top - 0.032, -0.055, height - 0.02)
        asm.board("body", low, (-top - 0.02, 0.055, height + 0.265), paint, 0.004, solid=False)
        asm.solid("body", (-top - 0.04, -top, height), (-top, top, height + 0.28))
    return _stool(
        "metal stool" + (" with a low back" if back else ""),
        asm,
        4.5,
        height - 0.005,
        top - 0.02,
        True,
    )


def stool_waist(
    height: float = 0.44, width: float = 0.34, colour: str = "#e8b23a", offset: Offset = (0, 0, 0)
) -> Model:
    """An hourglass of moulded plastic."""
    asm, r = Assembly(), width / 2
    m = plain(colour, 0.03, 9, offset)
    profile = [(0, 0), (r, 0), (r, 0.02), (0.86 * r, 0.08), (0.5 * r, 0.2), (0.48 * r, height / 2)]
    profile += [
        (0.5 * r, height - 0.2),
        (0.86 * r, height - 0.08),
        (r, height - 0.025),
        (r - 0.01, height),
    ]
    asm.add("body", lathe([*profile, (0.6 * r, height - 0.004), (0, height - 0.006)], 28, mat=m))
    for z0, z1, a, b in ((0, height / 2, r, 0.5 * r), (height / 2, height - 0.005, 0.5 * r, r)):
        asm.piece("body", cylinder_piece(a, z0, z1, 12, b))
    return _stool("hourglass stool of plastic", asm, 2.4, height - 0.005, r - 0.02)


def stool_piano(
    height: float = 0.52, width: float = 0.36, colour: str = "#26282b", wood: str = "walnut",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A round padded seat on a screw, four curved feet."""
    asm, r, timber = Assembly(), width / 2, finish(wood, 2, offset)
    asm.add(
        "body", round_seat(r, height - 0.075, height - 0.006, fabric(colour, offset, 0.05), True)
    )
    rim = [
        (0, height - 0.09),
        (r - 0.02, height - 0.09),
        (r - 0.005, height - 0.072),
        (0, height - 0.072),
    ]
    asm.add("body", lathe(rim, 18, mat=timber))
    asm.piece("body", cylinder_piece(r, height - 0.09, height, 14))
    post = [
        (0, 0.16),
        (0.03, 0.16),
        (0.045, 0.2),
        (0.036, 0.26),
        (0.018, 0.3),
        (0.018, height - 0.09),
    ]
    asm.add("body", lathe([*post, (0, height - 0.09)], 10, mat=timber))
    asm.piece("body", cylinder_piece(0.03, 0.16, height - 0.09, 8))
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        path = spline(
            [(q * c, q * s, z) for q, z in ((0.02, 0.22), (0.1, 0.2), (0.15, 0.07), (0.2, 0.016))],
            2,
        )
        foot = tube(path, [0.022 - 0.0012 * i for i in range(len(path))], 6, mat=timber)
        asm.piece("body", asm.add("body", foot).v[::2])
    return _stool("swivel piano stool", asm, 6.0, height, r - 0.03)


# ---- bar stools
def bar_plain(
    height: float = 0.74, width: float = 0.36, wood: str = "oak", seat: str | None = None,
    frame: str | None = None, back: bool = False, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """Four long splayed legs with foot rests; a wooden or padded seat, a low back if wanted."""
    asm, r = Assembly(), width / 2
    up = metal_or(frame or wood, 2, offset)
    z = height - 0.045
    if seat:
        asm.add("body", round_seat(r, z - 0.01, height - 0.006, fabric(seat, offset), True))
    else:
        asm.add("body", round_seat(r, z, height, finish(wood, 1, offset)))
    asm.piece("body", cylinder_piece(r, z, height, 14))
    splayed(asm, 4, 1.28 * r, 0.6 * r, z, (0.013, 0.018), up, rung=0.26)
    if back:
        for s in (-1, 1):
            path = [(-0.75 * r, s * 0.45 * r, z), (-0.95 * r, s * 0.62 * r, height + 0.22)]
            asm.add("body", tube(path, 0.011, 7, mat=up))
        a = np.linspace(math.pi - 0.85, math.pi + 0.85, 9)
        rings = []
        for t in a:
            c, s = math.cos(t), math.sin(t)
            for_ring = rounded_rectangle(0.03, 0.13, 0.014, 3)
            rings.append(
                np.array([((r + p) * c, (r + p) * s, height + 0.22 + q) for p, q in for_ring])
            )
        mat = fabric(seat, offset) if seat else finish(wood, 1, offset)
        asm.add("body", loft(rings, mat))
        asm.solid(
            "body", (-r - 0.02, -0.7 * r, height + 0.15), (-0.65 * r, 0.7 * r, height + 0.285)
        )
    what = "padded" if seat else wood
    title = f"bar stool, {what}{' with a low back' if back else ''}"
    return _stool(title, asm, 6.0, height - 0.006, r - 0.03)


def bar_swivel(
    height: float = 0.76, colour: str = "#8c2f2f", metal: str = "steel", offset: Offset = (0, 0, 0)
) -> Model:
    """A bucket seat on a chromed column, a disc for a foot, a ring to rest the feet on."""
    asm, chrome = Assembly(), metal_or(metal)
    cloth = fabric(colour, offset, 0.05)
    base = [
        (0, 0),
        (0.205, 0),
        (0.21, 0.01),
        (0.19, 0.018),
        (0.05, 0.056),
        (0.032, 0.075),
        (0.026, 0.4),
    ]
    base += [(0.026, height - 0.16), (0.1, height - 0.1), (0, height - 0.1)]
    asm.add("body", lathe(base, 28, mat=chrome))
    asm.piece("body", cylinder_piece(0.21, 0, 0.025, 14))
    asm.piece("body", cylinder_piece(0.028, 0.025, height - 0.1, 8))
    a = np.arange(16) * 2 * math.pi / 16
    hoop = np.c_[0.11 + 0.13 * np.cos(a), 0.15 * np.sin(a), np.full(16, 0.27)]
    asm.add("body", tube(hoop, 0.009, 6, closed=True, mat=chrome))
    pad = cushion((0.4, 0.42, 0.085), (0, 0, height - 0.1), cloth, 0.14, 0.012, 0.03)
    asm.add("body", pad)
    asm.solid("body", (-0.19, -0.2, height - 0.1), (0.19, 0.2, height - 0.004))
    rings = []
    for t in np.linspace(math.pi - 1.75, math.pi + 1.75, 15):
        c, s = math.cos(t), math.sin(t)
        up = 0.12 + 0.16 * max(0.0, -c) ** 1.0
        ring = rounded_rectangle(0.05, up, 0.022, 3)
        r = 0.2 + 0.03 * max(0.0, -c)
        rings.append(
            np.array([((r + p) * c, (r + p) * s, height - 0.07 + up / 2 + q) for p, q in ring])
        )
    asm.add("body", loft(rings, cloth))
    asm.solid("body", (-0.26, -0.17, height), (-0.2, 0.17, height + 0.2))
    for s in (-1, 1):
        asm.solid(
            "body", (-0.2, s * 0.215 - 0.025, height), (0.05, s * 0.215 + 0.025, height + 0.1)
        )
    return _stool("bar stool, swivel bucket seat", asm, 8.0, height + 0.002, 0.13)


def bar_high_back(
    height: float = 0.66, colour: str = "#7d8b86", wood: str = "walnut", offset: Offset = (0, 0, 0)
) -> Model:
    """A tall upholstered chair for a counter: square legs, a full back."""
    asm, timber, cloth = Assembly(), finish(wood, 2, offset), fabric(colour, offset)
    w, d = 0.42, 0.42
    z = height - 0.09
    for x in (-1, 1):
        for y in (-1, 1):
            foot, head = (x * 0.2, y * 0.2), (x * 0.17, y * 0.17)
            leg(asm, "body", foot, head, (0, z), (0.015, 0.022), timber, 4)
    for s in (-1, 1):
        for level, low, high in (
            (0.22, (-0.19, s * 0.19 - 0.009), (0.19, s * 0.19 + 0.009)),
            (0.18 if s > 0 else 0.28, (s * 0.19 - 0.009, -0.19), (s * 0.19 + 0.009, 0.19)),
        ):
            asm.board("body", (*low, level), (*high, level + 0.028), timber)
    asm.add("body", cushion((d, w, 0.085), (0, 0, z), cloth, 0.04, 0.012, 0.03), solid=True)
    back = cushion((0.4, w - 0.02, 0.055), (0, 0, 0), cloth, 0.05, 0.012, 0.024)
    back.turn(ry=math.pi / 2 - 0.1).move(-0.2, 0, height + 0.17)
    asm.add("body", back)
    asm.solid("body", (-0.23, -0.2, height), (-0.15, 0.2, height + 0.36))
    seat = Support("seat", height + 0.002, rectangle(0.28, 0.34, 0.03))
    return Model(
        "upholstered bar stool with a back", asm.parts(), 7.5, supports=[seat], ground_shadow=True
    )


def bar_saddle(
    height: float = 0.68, wood: str = "birch", frame: str | None = None, offset: Offset = (0, 0, 0)
) -> Model:
    """A wide seat, hollowed like a saddle, on four square legs."""
    asm, timber = Assembly(), finish(frame or wood, 2, offset)
    w, d, z = 0.44, 0.28, height - 0.06
    rings = []
    for y in np.linspace(-w / 2, w / 2, 9):
        lift = 0.04 * (2 * y / w) ** 2
        ring = rounded_rectangle(d, 0.035, 0.012, 2)
        rings.append(np.array([(p, y, z + lift + 0.0175 + q) for p, q in ring]))
    asm.add("body", loft(rings, finish(wood, 1, offset), weight=1.3))
    asm.solid("body", (-d / 2, -w / 2, z), (d / 2, w / 2, z + 0.04))
    for x in (-1, 1):
        for y in (-1, 1):
            foot, head = (x * 0.16, y * 0.2), (x * 0.1, y * 0.15)
            leg(asm, "body", foot, head, (0, z + 0.012), (0.016, 0.02), timber, 4)
    for s in (-1, 1):
        asm.board("body", (-0.14, s * 0.183 - 0.009, 0.26), (0.14, s * 0.183 + 0.009, 0.29), timber)
        x = s * 0.142
        asm.board("body", (x - 0.009, -0.18, 0.18), (x + 0.009, 0.18, 0.21), timber)
    seat = Support("seat", z + 0.038, rectangle(0.2, 0.22))
    return Model(
        "bar stool with a saddle seat", asm.parts(), 5.0, supports=[seat], ground_shadow=True
    )


def bar_stool_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bar stool."""
    return {"offset": noise_offset(rng)}


STOOLS = [
    (stool_milking, {}),
    (stool_rush, {}),
    (stool_metal, {}),
    (stool_waist, {}),
    (stool_piano, {}),
    (stool_waist, {"colour": "#e9e7e1"}),
]
MODELS: dict[str, Maker] = {
    "bar_stool": designed(
        [
            (bar_plain, {}),
            (bar_swivel, {}),
            (stool_metal, {"height": 0.74, "width": 0.43, "colour": "#46525c", "back": True}),
            (bar_high_back, {}),
            (bar_saddle, {}),
            (bar_plain, {"seat": "#b58a4a", "frame": "iron", "back": True, "width": 0.38}),
            (bar_swivel, {"colour": "#e3e0d8"}),
        ],
        bar_stool_random,
    ),
}
