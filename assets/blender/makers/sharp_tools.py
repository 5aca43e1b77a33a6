"""Sharp things lying flat: razors, box cutter, screwdriver, peeler, corkscrew, pizza cutter.

Modelled with handles towards -X and turned at export. Blades are a part of their own that casts
no shadow (a thin blade would throw acne onto itself).
"""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import label as printed
from toolkit.materials import metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Model, Part
from toolkit.shapes import box, extrude, lathe, loft, spline, tube

from makers.convex import few_corners
from makers.projection import project_label

NO_SHADOW = (1.0, 1.0, 1.0, 0.999)
STEEL, STEEL_DARK = "c9cdd1", "8f959b"


def sharp(
    title: str, hold: list[Mesh], blade: list[Mesh], pieces: list, mass: float, length: float
) -> Model:
    """The model, scaled to its length along x, from its handle and blade."""
    for mesh in blade:
        for material in mesh.mats:
            material.block["occlusion"] = 0.4
    points = np.concatenate([m.v for m in (*hold, *blade)])
    s = length / float(np.ptp(points[:, 0]))
    for mesh in (*hold, *blade):
        mesh.scale(s)
    grip = [few_corners(np.asarray(p) * s) for p in pieces]
    return Model(
        title,
        {
            "handle": Part(hold, collision=grip, occlusion="handle"),
            "blade": Part(
                blade,
                rgba=NO_SHADOW,
                collision=[few_corners(np.concatenate([m.v for m in blade]))],
                occlusion="blade",
            ),
        },
        mass=mass,
        friction=0.5,
        texture_size=128,
        front="-y",  # they end up lying along y
    )


def turned(profile: list[tuple[float, float]], mat, n: int = 12, rib=None) -> Mesh:
    """A turned handle lying along x: (radius, x) pairs from its far end, its belly on z = 0."""
    mesh = lathe([(r, x) for r, x in profile], n, mat=mat, rib=rib).turn(ry=math.pi / 2)
    return mesh.move(z=max(r for r, _ in profile))


def razor(kind: str, colour: str, strip: str, length: float) -> Model:
    """A wet razor with a cartridge across its end, or an opened cut-throat razor."""
    grip, steel = plain(colour, 0.04), metal(STEEL, STEEL_DARK)
    edge = plain("eef1f4", 0.0)
    if kind == "wet":
        path = spline(
            [(-0.1, 0, 0.008), (-0.06, 0, 0.009), (-0.02, 0, 0.012), (0.014, 0, 0.013)], 3
        )
        width = [0.0055, 0.007, 0.0075, 0.0075, 0.007, 0.0065, 0.006, 0.0055, 0.005, 0.0045]
        handle = tube(path, width, 8, mat=grip)
        inlay = tube(np.add(path[2:6], (0, 0, 0.0035)), 0.0046, 6, mat=plain(strip, 0.03))
        head = box(0.024, 0.044, 0.007, (0.018, 0, 0.0085), plain("#2c3036", 0.03), 0.001)
        lube = box(0.0045, 0.04, 0.0015, (0.0275, 0, 0.0155), plain(strip, 0.0))
        blades = [
            box(0.0022, 0.039, 0.0012, (0.0115 + 0.0052 * k, 0, 0.0153), edge) for k in range(3)
        ]
        pieces = [handle.v, head.v]
        return sharp("wet razor", [handle, inlay, head, lube], blades, pieces, 0.03, length)
    scales = spline(
        [(-0.145, 0.006), (-0.08, 0.0125), (0, 0.009), (0, -0.004), (-0.08, 0.0), (-0.142, -0.005)],
        3,
        closed=True,
    )
    hold = [extrude(scales, 0.011, grip, bevel_width=0.0015)]
    for x in (-0.004, -0.12):
        pin = lathe([(0, 0), (0.0035, 0), (0.003, 0.0008), (0, 0.001)], 8, mat=steel)
        hold.append(pin.move(x, 0.0025, 0.0112))
    outline = [(0, -0.009), (0.028, -0.008), (0.034, -0.0125), (0.11, -0.0125), (0.116, 0.002)]
    outline += [(0.106, 0.0095), (0.034, 0.009), (0.026, 0.003), (0, 0.003)]
    blade = extrude(outline, 0.003, steel)
    rim = extrude(
        [(0.035, -0.0128), (0.11, -0.0128), (0.11, -0.0085), (0.035, -0.0085)], 0.0034, edge
    )
    blades = [m.turn(rz=0.5).move(-0.004, 0.0025, 0.004) for m in (blade, rim)]
    return sharp("cut-throat razor", hold, blades, [hold[0].v], 0.06, length)


def box_cutter(colour: str, slide: str, length: float, out: float) -> Model:
    """A cutter with its scored blade out."""
    body, dark = plain(colour, 0.04), plain("#26282c", 0.04)
    outline = [(-0.075, -0.01), (-0.07, 0.012), (0.04, 0.012), (0.062, 0.006), (0.062, -0.008)]
    outline += [(0.03, -0.013), (-0.03, -0.012)]
    hold = [extrude(outline, 0.015, body, bevel_width=0.003)]
    hold.append(box(0.09, 0.006, 0.0012, (-0.005, 0.002, 0.0146), dark))
    hold.append(box(0.02, 0.009, 0.006, (0.02, 0.002, 0.0146), plain(slide, 0.03), 0.0015))
    for k in range(4):
        hold.append(box(0.003, 0.018, 0.0016, (-0.066 + 0.007 * k, 0, 0.0146), dark))
    tip = 0.062 + out
    steel, edge = metal("d4d8dc", "9aa0a6"), plain("f4f6f8", 0.0)
    blade = [(0.05, -0.0065), (tip - 0.001, -0.0065), (tip - 0.0085, 0.0065), (0.05, 0.0065)]
    blades = [extrude(blade, 0.004, steel).move(z=0.0055)]
    rim = [(0.05, -0.0067), (tip - 0.001, -0.0067), (tip - 0.002, -0.0042), (0.05, -0.0042)]
    blades.append(extrude(rim, 0.0045, edge).move(z=0.0053))
    score = plain("5c636a", 0.0)
    for k in range(int(out / 0.0085)):
        x = 0.068 + 0.0085 * k
        line = [(x, -0.004), (x + 0.0009, -0.004), (x - 0.003, 0.0065), (x - 0.0039, 0.0065)]
        blades.append(extrude(line, 0.0046, score).move(z=0.0052))
    return sharp("box cutter, blade out", hold, blades, [hold[0].v], 0.08, length)


def screwdriver(kind: str, colour: str, second: str, length: float) -> Model:
    """A screwdriver: flat tip or cross tip."""
    n = 12
    grip, band = plain(colour, 0.04), plain(second, 0.03)
    steel, tip_steel = metal(STEEL, STEEL_DARK), metal("9a9fa5", "5c6268")
    profile = [(0, -0.1), (0.011, -0.1), (0.0145, -0.094), (0.0155, -0.07), (0.014, -0.03)]
    profile += [(0.0105, -0.02), (0.0135, -0.008), (0.009, 0), (0, 0)]
    handle = turned(profile, grip, n, lambda k, i: 1 - 0.12 * (i % 2) if 2 <= k <= 4 else 1)
    height = 0.0155
    ring = lathe(
        [(0.0153, -0.09), (0.0158, -0.089), (0.0158, -0.079), (0.0153, -0.078)], n, mat=band
    )
    cap_end = lathe([(0, -0.1015), (0.0105, -0.1012), (0.0112, -0.0985)], n, mat=band)
    hold = [handle, *(m.turn(ry=math.pi / 2).move(z=height) for m in (ring, cap_end))]
    rod = lathe([(0, 0), (0.0037, 0), (0.0037, 0.1), (0, 0.1)], 8, mat=steel)
    blades = [rod.turn(ry=math.pi / 2).move(z=height)]
    if kind == "flat":
        rings = []
        for x, wide, tall in (
            (0.094, 0.0037, 0.0037),
            (0.107, 0.0055, 0.0022),
            (0.118, 0.005, 0.0008),
        ):
            corners = ((wide, tall), (-wide, tall), (-wide, -tall), (wide, -tall))
            rings.append([(x, y, height + z) for y, z in corners])
        blades.append(loft(rings, mat=tip_steel))
    else:
        star = lathe(
            [(0, 0.096), (0.0042, 0.097), (0.0042, 0.106), (0.0012, 0.118), (0, 0.118)],
            8,
            mat=tip_steel,
            rib=lambda k, i: 0.55 if i % 2 else 1,
        )
        blades.append(star.turn(ry=math.pi / 2).move(z=height))
    return sharp(f"screwdriver, {kind} tip", hold, blades, [handle.v], 0.11, length)


def pizza_cutter(colour: str, length: float, words: str) -> Model:
    """A wheel with a handle, lying on its side."""
    grip, steel, edge = plain(colour, 0.04), metal(STEEL, STEEL_DARK), plain("f2f4f6", 0)
    handle = turned(
        [
            (0, -0.12),
            (0.01, -0.119),
            (0.0125, -0.1),
            (0.01, -0.06),
            (0.013, -0.02),
            (0.008, 0),
            (0, 0),
        ],
        grip,
        10,
    )
    fork = box(0.05, 0.014, 0.0035, (0.02, 0, 0.0145), metal("aab0b6", "6f757b"), 0.0005)
    guard = box(0.006, 0.036, 0.018, (-0.001, 0, 0.003), grip, 0.002)
    wheel = lathe(
        [(0, 0.007), (0.028, 0.007), (0.0335, 0.0085), (0.028, 0.012), (0, 0.012)],
        24,
        mats=[steel, edge],
        mat_of_segment=[0, 1, 1, 0],
    ).move(0.045)
    picture, draw = canvas(128, 128)
    draw.ellipse((16, 16, 112, 112), outline="#8f959b", width=3)
    text(draw, words, (22, 82, 106, 108), "bold", "#c8202c")
    project_label(wheel, printed(picture, base="#c9cdd1"), "+z", (0, -0.045), (0.056, 0.056), 0.95)
    hub = lathe([(0, 0.012), (0.007, 0.012), (0.006, 0.0195), (0, 0.02)], 10, mat=grip).move(0.045)
    return sharp(
        "pizza cutter", [handle, fork, guard, hub], [wheel], [handle.v, guard.v], 0.14, length
    )
