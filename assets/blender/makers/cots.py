"""Travel cots, cradles and oval cots."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.model import Model, Support, rectangle
from toolkit.shapes import extrude, lathe, loft, rounded_rectangle, tube

from .child_bed_forms import spotted
from .joinery import Assembly, cushion, fabric, finish, leg, surface

Offset = tuple[float, float, float]


def travel_cot(colour: str = "#4a6a8c", trim: str = "#d8dde0", offset: Offset = (0, 0, 0)) -> Model:
    """Cloth and netting on a folding frame: a play pen to sleep in."""
    asm, hx, hy, height = Assembly(), 0.34, 0.56, 0.76
    cloth = fabric(colour, offset)
    net = Material()
    holes = net.remap(net.voronoi(55, offset=offset, randomness=0.0), 0.28, 0.42)
    net.colour(net.mix(holes, shade(trim, 0.95), shade(colour, 0.55)))
    ring = rounded_rectangle(2 * hx, 2 * hy, 0.08, 4)
    rail = np.c_[ring, np.full(len(ring), height - 0.03)]
    asm.add("body", tube(rail, 0.03, 8, closed=True, mat=cloth))
    inner = ring * [(hx - 0.016) / hx, (hy - 0.016) / hy]
    outer = ring * [(hx - 0.006) / hx, (hy - 0.006) / hy]
    for z0, z1, mat in ((0.04, 0.3, cloth), (0.3, height - 0.03, net)):
        profile = [
            np.c_[r, np.full(len(r), z)]
            for r, z in ((outer, z0), (outer, z1), (inner, z1), (inner, z0))
        ]
        asm.add("body", loft([*profile, profile[0]], mat, caps=(False, False)).outward())
    for x in (-hx + 0.03, hx - 0.03):
        for y in (-hy + 0.03, hy - 0.03):
            asm.board(
                "body",
                (x - 0.04, y - 0.04, 0),
                (x + 0.04, y + 0.04, 0.05),
                plain("#2c2e30", 0.05, 12),
                0.01,
            )
            asm.board(
                "body",
                (x - 0.03, y - 0.03, 0.05),
                (x + 0.03, y + 0.03, height - 0.04),
                cloth,
                0.015,
            )
    asm.board(
        "body",
        (-hx + 0.02, -hy + 0.02, 0.1),
        (hx - 0.02, hy - 0.02, 0.16),
        spotted("#efeae0", colour, offset),
        0.02,
    )
    for s in (-1, 1):
        asm.solid("body", (s * hx - 0.012, -hy, 0.05), (s * hx + 0.012, hy, height))
        asm.solid("body", (-hx, s * hy - 0.012, 0.05), (hx, s * hy + 0.012, height))
    bed = surface("top", (-hx + 0.06, -hy + 0.08), (hx - 0.06, hy - 0.08), 0.16)
    return Model("travel cot with netting", asm.parts(), 10.0, supports=[bed], ground_shadow=True)


def cradle(wood: str = "pine", cloth: str = "#e8b7a8", offset: Offset = (0, 0, 0)) -> Model:
    """A rocking cradle: sloping boards on two curved runners, a hood at one end."""
    asm, hy = Assembly(), 0.46
    along, end = finish(wood, 1, offset), finish(wood, 2, offset)
    for s in (-1, 1):
        outline = [(s * 0.2, 0.16), (s * 0.22, 0.16), (s * 0.31, 0.52), (s * 0.29, 0.52)]
        asm.add("body", extrude(outline, 2 * hy, along, axis="y"))
        asm.piece("body", np.array([(x, y, z) for x, z in outline for y in (-hy, hy)]))
    for y, top in ((-hy, 0.78), (hy, 0.6)):
        a = np.linspace(-1, 1, 7)
        outline = [(-0.2, 0.14), (0.2, 0.14), (0.3, 0.52)]
        outline += [(0.29 * -t, top - (top - 0.52) * t * t) for t in a[1:-1]] + [(-0.3, 0.52)]
        asm.add("body", extrude(outline, 0.024, end, axis="y").move(0, y, 0))
        asm.solid("body", (-0.25, y - 0.012, 0.14), (0.25, y + 0.012, top - 0.08))
        lows = [(x, 0.01 + 0.22 * x * x) for x in np.linspace(-0.38, 0.38, 9)]
        rocker = lows + [(x, z + 0.05) for x, z in lows[::-1]]
        yy = y * 0.8
        asm.add("body", extrude(rocker, 0.03, end, axis="y").move(0, yy, 0))
        asm.solid("body", (-0.18, yy - 0.015, 0), (0.18, yy + 0.015, 0.05))
        asm.board("body", (-0.14, yy - 0.014, 0.04), (0.14, yy + 0.014, 0.17), end)
    asm.board("body", (-0.21, -hy, 0.15), (0.21, hy, 0.17), along)
    hood = []
    for y in (-hy, -hy + 0.3):
        arc = np.linspace(0, math.pi, 9)
        ring = [(0.3 * math.cos(t), y, 0.5 + 0.3 * math.sin(t)) for t in arc]
        ring += [(0.28 * math.cos(t), y, 0.5 + 0.28 * math.sin(t)) for t in arc[::-1]]
        hood.append(np.array(ring))
    asm.add("body", loft(hood, along).outward())
    asm.solid("body", (-0.2, -hy, 0.74), (0.2, -hy + 0.3, 0.8))
    pad = cushion(
        (0.44, 2 * hy - 0.04, 0.12), (0, 0, 0.17), fabric("#f7f2e8", offset, 0.03), 0.06, 0.02, 0.05
    )
    asm.add("body", pad, solid=True)
    cover = cushion(
        (0.48, 0.52, 0.05), (0, 0.16, 0.29), spotted(cloth, "#fffaf0", offset), 0.06, 0.03, 0.03
    )
    asm.add("body", cover)
    asm.solid("body", (-0.22, -0.08, 0.29), (0.22, 0.4, 0.35))
    bed = surface("top", (-0.16, -0.04), (0.16, 0.36), 0.365)
    return Model("rocking cradle", asm.parts(), 12.0, supports=[bed], ground_shadow=True)


def round_cot(wood: str = "#f3f1ec", cloth: str = "#a9c4b0", offset: Offset = (0, 0, 0)) -> Model:
    """An oval cot on castors, bars all round."""
    asm, rx, ry, height = Assembly(), 0.37, 0.56, 0.86
    up = finish(wood, 2, offset)
    a = np.linspace(0, 2 * math.pi, 25)[:-1]
    for z0, z1 in ((0.24, 0.29), (height - 0.05, height)):
        loop = np.c_[rx * np.cos(a), ry * np.sin(a), np.full(len(a), (z0 + z1) / 2)]
        asm.add("body", tube(loop, 0.024, 6, closed=True, mat=up))
    for t in np.linspace(0, 2 * math.pi, 31)[:-1]:
        x, y = rx * math.cos(t), ry * math.sin(t)
        asm.board(
            "body",
            (x - 0.007, y - 0.007, 0.27),
            (x + 0.007, y + 0.007, height - 0.03),
            up,
            solid=False,
        )
    for i in range(12):
        t0, t1 = 2 * math.pi * i / 12, 2 * math.pi * (i + 1) / 12
        pts = [
            (k * rx * math.cos(t), k * ry * math.sin(t), z)
            for t in (t0, t1)
            for k in (0.96, 1.04)
            for z in (0.24, height)
        ]
        asm.piece("body", np.array(pts))
    for k in range(4):
        t = math.pi / 4 + k * math.pi / 2
        x, y = 0.9 * rx * math.cos(t), 0.9 * ry * math.sin(t)
        leg(asm, "body", (x, y), (x, y), (0.05, 0.26), (0.02, 0.024), up, 8)
        wheel = [(0, -0.014), (0.03, -0.014), (0.034, 0), (0.03, 0.014), (0, 0.014)]
        asm.add(
            "body",
            lathe(wheel, 10, mat=plain("#3a3c3e", 0.05, 9)).turn(rx=math.pi / 2).move(x, y, 0.034),
        )
        asm.solid("body", (x - 0.02, y - 0.02, 0), (x + 0.02, y + 0.02, 0.06))
    pad = [(0, 0.3), (0.95, 0.3), (0.97, 0.32), (0.97, 0.39), (0.9, 0.42), (0, 0.425)]
    mesh = lathe(pad, 24, mat=spotted("#f7f3ea", cloth, offset))
    mesh.v = mesh.v * [rx, ry, 1]
    asm.add("body", mesh)
    asm.solid("body", (-rx * 0.7, -ry * 0.7, 0.28), (rx * 0.7, ry * 0.7, 0.42))
    cover = cushion((0.56, 0.42, 0.024), (0, 0.17, 0.421), fabric(cloth, offset), 0.1, 0.008, 0.012)
    asm.add("body", cover)
    bed = Support("top", 0.453, rectangle(0.4, 0.26, 0.0, 0.17))
    low = Support("mattress", 0.425, rectangle(0.3, 0.24, 0.0, -0.22))
    return Model("oval cot on castors", asm.parts(), 18.0, supports=[bed, low], ground_shadow=True)
