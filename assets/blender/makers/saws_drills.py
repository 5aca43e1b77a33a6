"""Hand saws lying flat, and power drills standing on their battery or lying. Along +X."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import label as printed
from toolkit.materials import metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Model, Part
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, spline, superellipse, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners
from makers.hand_tools import lying
from makers.knives import NO_SHADOW


# ---- saws: the teeth look towards -y
def teeth(x0: float, y0: float, x1: float, y1: float, depth: float, count: int) -> list:
    """A toothed line between two points, the tips at its level, the gaps `depth` higher (+y)."""
    out = []
    for k in range(count):
        for share, gap in ((0.0, depth), (0.35, 0.0)):
            t = (k + share) / count
            out.append((x0 + (x1 - x0) * t, y0 + (y1 - y0) * t + gap))
    return [*out, (x1, y1 + depth)]


def saw(title: str, hold: list[list[Mesh]], blade: list[Mesh], mass: float) -> Model:
    """A saw: groups of its frame and handle with a hull each, and its blade."""
    for mesh in blade:
        for material in mesh.mats:
            material.block["occlusion"] = 0.4
    hulls = [few_corners(np.concatenate([m.v for m in group])) for group in hold]
    return Model(
        title,
        {
            "handle": Part([m for g in hold for m in g], collision=hulls, occlusion="handle"),
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
        front="-y",
    )


def loop_handle(timber, z: float, x: float = 0.0, size: float = 1.0) -> list[Mesh]:
    """A saw's closed wooden handle, its plate reaching over the blade."""
    ring = [(-0.012, 0.052), (-0.05, 0.072), (-0.095, 0.05), (-0.1, 0.0), (-0.088, -0.045)]
    ring += [(-0.045, -0.05), (-0.018, -0.02), (-0.02, 0.02)]
    line = [(x + a * size, b * size, z) for a, b in ring]
    loop = tube(
        spline(line, 2, closed=True), 0.0145 * size, 7, closed=True, mat=timber, up=(0, 0, 1)
    )
    plate_line = [(-0.02, 0.056), (0.028, 0.05), (0.036, 0.0), (0.012, -0.05), (-0.03, -0.05)]
    plate = extrude(
        [(x + a * size, b * size) for a, b in plate_line], 0.02, timber, bevel_width=0.004
    )
    steel = metal("c9a24a", "7d6428")
    pins = []
    for a, b in ((0.008, 0.03), (0.012, -0.012)):
        pin = lathe([(0, 0), (0.006, 0), (0.005, 0.0016), (0, 0.002)], 8, mat=steel)
        pins.append(pin.move(x + a * size, b * size, z + 0.01))
    return [loop, plate.move(z=z - 0.01), *pins]


def panel_saw(colour: str) -> Model:
    """The carpenter's saw: a long tapering blade with big teeth."""
    z = 0.0148
    timber = wood(colour, "7d5230", 0, 14)
    steel = metal("cdd1d5", "9aa0a6", (40, 1, 1), 30)
    edge = teeth(0.015, -0.05, 0.43, -0.05, 0.012, 26)
    blade = extrude([*edge, (0.43, 0.004), (0.415, 0.012), (0.0, 0.055)], 0.005, steel)
    return saw("hand saw", [loop_handle(timber, z)], [blade.move(z=z - 0.0025)], 0.55)


def tenon_saw(colour: str, spine: str) -> Model:
    """A short stiff saw with a heavy strip along its back."""
    z = 0.0128
    timber, brass = wood(colour, "4a2c18", 0, 14), metal(spine, "7d6428")
    steel = metal("cdd1d5", "9aa0a6", (40, 1, 1), 30)
    edge = teeth(0.015, -0.05, 0.27, -0.05, 0.009, 20)
    blade = extrude([*edge, (0.27, 0.035), (0.0, 0.035)], 0.005, steel).move(z=z - 0.0025)
    back = box(0.265, 0.017, 0.012, (0.14, 0.034, z - 0.006), brass, 0.002)
    return saw("back saw", [loop_handle(timber, z, 0, 0.86), [back]], [blade], 0.5)


def hacksaw(colour: str, grip: str) -> Model:
    """A metal saw: an arched frame, a pistol grip, a thin blade."""
    z = 0.013
    frame_mat, grip_mat = plain(colour, 0.04), plain(grip, 0.06, 150)
    path = [(-0.005, -0.02, z), (0.0, 0.04, z), (0.02, 0.07, z), (0.27, 0.07, z), (0.295, 0.045, z)]
    frame = tube([*path, (0.295, -0.045, z)], 0.0075, 7, mat=frame_mat, up=(0, 0, 1))
    line = [(0.006, 0.05), (-0.016, 0.056), (-0.045, 0.02), (-0.08, -0.045), (-0.07, -0.062)]
    line += [(-0.05, -0.06), (-0.02, -0.03), (0.0, -0.05), (0.012, -0.03)]
    handle = extrude(line, 0.026, grip_mat, bevel_width=0.006).move(z=z - 0.013)
    ends = [
        box(0.02, 0.014, 0.014, (x, -0.04, z - 0.007), metal("b8bcc0", "6f757b"), 0.002)
        for x in (0.008, 0.292)
    ]
    edge = teeth(0.0, -0.052, 0.3, -0.052, 0.005, 28)
    blade = extrude([*edge, (0.3, -0.032), (0.0, -0.032)], 0.005, plain("#3a5a8a", 0.04))
    return saw("hacksaw", [[handle], [frame], ends], [blade.move(z=z - 0.0025)], 0.5)


def bow_saw(colour: str) -> Model:
    """A bow saw: a bent tube and a long blade with large teeth."""
    z = 0.013
    paint, steel = plain(colour, 0.04), metal("cdd1d5", "9aa0a6")
    path = [
        (0.0, -0.045, z),
        (-0.015, 0.03, z),
        (0.035, 0.115, z),
        (0.16, 0.15, z),
        (0.34, 0.115, z),
    ]
    frame = tube(
        spline([*path, (0.52, 0.01, z), (0.545, -0.045, z)], 3), 0.0125, 8, mat=paint, up=(0, 0, 1)
    )
    guard = tube(
        [(0.0, -0.04, z), (-0.045, -0.01, z), (-0.05, 0.05, z), (-0.005, 0.06, z)], 0.009, 6
    )
    guard.mats = [plain("#26282c", 0.04)]
    edge = teeth(0.0, -0.068, 0.55, -0.068, 0.014, 24)
    blade = extrude([*edge, (0.55, -0.034), (0.0, -0.034)], 0.005, steel).move(z=z - 0.0025)
    return saw("bow saw", [[frame], [guard]], [blade], 0.8)


def pruning_saw(colour: str) -> Model:
    """A folding pruning saw, half open."""
    z = 0.014
    grip, steel = plain(colour, 0.05, 150), metal("cdd1d5", "9aa0a6")
    line = [(0.012, 0.015), (-0.08, 0.018), (-0.16, 0.024), (-0.21, 0.012), (-0.215, -0.01)]
    line += [(-0.19, -0.022), (-0.14, -0.014), (-0.06, -0.019), (0.005, -0.017), (0.018, 0.0)]
    handle = extrude(line, 0.028, grip, bevel_width=0.006)
    pads = [
        box(0.012, 0.02, 0.002, (-0.05 - 0.03 * k, 0.001, 0.0275), plain("#26282c", 0.04))
        for k in range(4)
    ]
    pin = lathe([(0, 0), (0.008, 0), (0.0065, 0.003), (0, 0.0034)], 10, mat=steel)
    edge = teeth(0.012, -0.018, 0.19, -0.004, 0.009, 16)
    blade = extrude(
        [*edge, (0.2, 0.012), (0.12, 0.022), (0.0, 0.016), (-0.01, -0.005)], 0.005, steel
    )
    blade.turn(rz=0.75).move(z=z - 0.0025)
    return saw("folding saw", [[handle, *pads, pin.move(0, 0, 0.0275)]], [blade], 0.3)


def handsaw(kind: str, colour: str, second: str) -> Model:
    """A saw: "panel", "tenon", "hacksaw", "bow" or "pruning"."""
    if kind == "tenon":
        return tenon_saw(colour, second)
    if kind == "hacksaw":
        return hacksaw(colour, second)
    return {"panel": panel_saw, "bow": bow_saw, "pruning": pruning_saw}[kind](colour)


# ---- drills: chuck towards +x, standing on z = 0
def turned_x(profile, mats, segments=None, n: int = 12, rib=None) -> Mesh:
    """A turned piece along x: (radius, x) pairs."""
    mesh = lathe(profile, n, mats=mats, mat_of_segment=segments, rib=rib)
    return mesh.turn(ry=math.pi / 2)


def drill_top(colour: str, r: float, back: float, bit: float, z: float) -> list[Mesh]:
    """Motor housing, clutch ring, chuck and bit along x at height z."""
    shell, dark = plain(colour, 0.03), plain("#26282c", 0.04)
    steel = metal("b8bcc0", "5c6268")
    body = turned_x(
        [
            (0, back),
            (0.72 * r, back),
            (0.98 * r, back + 0.012),
            (r, back + 0.04),
            (r, 0.035),
            (0.9 * r, 0.045),
            (0, 0.045),
        ],
        [shell, dark],
        [1, 1, 0, 0, 0, 0],
    )
    clutch = turned_x(
        [(0, 0.045), (0.86 * r, 0.045), (0.86 * r, 0.068), (0.7 * r, 0.074), (0, 0.074)],
        [dark],
        rib=lambda k, i: 1 - 0.07 * (i % 2) if k in (1, 2) else 1,
    )
    chuck = turned_x(
        [(0, 0.074), (0.68 * r, 0.074), (0.66 * r, 0.1), (0.36 * r, 0.118), (0, 0.118)],
        [dark, steel],
        [0, 0, 1, 1],
        12,
        lambda k, i: 1 - 0.09 * (i % 2) if k in (1, 2) else 1,
    )
    spiral = turned_x(
        [(0, 0.116), (0.0045, 0.116), (0.0045, 0.116 + 0.82 * bit), (0, 0.116 + bit)],
        [steel],
        None,
        6,
    )
    vents = [
        box(0.004, 0.004, 1.0 * r, (back + 0.03 + 0.011 * k, s * 0.96 * r, -0.5 * r), dark)
        for k in range(3)
        for s in (-1, 1)
    ]
    return [m.move(z=z) for m in (body, clutch, chuck, spiral, *vents)]


def brand_plate(colour: str, name: str, r: float, z: float) -> list[Mesh]:
    """The maker's name on both sides of the motor."""
    picture, draw = canvas(256, 96, colour)
    text(draw, name, (10, 10, 246, 86), "oblique", "#ffffff" if colour != "#f2c21e" else "#111111")
    plate = printed(picture)
    return [
        box(
            0.075,
            0.004,
            0.028,
            (-0.012, s * 0.97 * r, z - 0.012),
            plain(colour, 0.02),
            0,
            1,
            {side: plate},
        )
        for s, side in ((1, "+y"), (-1, "-y"))
    ]


def grip_loft(z0: float, z1: float, x0: float, x1: float, mat, wide: float = 0.034) -> Mesh:
    """The pistol grip between two heights; its middle line leans from x0 to x1."""
    rings = []
    for t, f in ((0, 1.08), (0.15, 0.95), (0.55, 1.0), (0.85, 1.05), (1, 1.2)):
        ring = superellipse(0.023 * f, wide / 2 * f, 2.6, 12, z0 + (z1 - z0) * t)
        rings.append(ring + np.array([x0 + (x1 - x0) * t, 0, 0]))
    return loft(rings, mat=mat)


def cordless(colour: str, name: str, size: str) -> list[list[Mesh]]:
    """Top, grip and battery of a cordless drill standing on its battery."""
    big = size != "compact"
    r, top, back = (0.034, 0.185, -0.085) if big else (0.029, 0.16, -0.06)
    dark, shell = plain("#26282c", 0.05), plain(colour, 0.03)
    upper = drill_top(colour, r, back, 0.16 if size == "hammer" else 0.07, top)
    bit = upper.pop(3)
    upper += brand_plate(colour, name, r, top)
    grip = [grip_loft(0.055, top - 0.6 * r, -0.035, -0.018, dark)]
    grip.append(box(0.014, 0.02, 0.034, (0.012, 0, top - r - 0.036), plain("#d8202c", 0.03), 0.004))
    foot = extrude(rounded_rectangle(0.13, 0.086, 0.016, 2), 0.03, shell, bevel_width=0.005)
    pack = extrude(rounded_rectangle(0.125, 0.082, 0.012, 2), 0.034, dark, bevel_width=0.004)
    base = [pack.move(-0.015), foot.move(-0.018, 0, 0.032)]
    for k in range(3):
        lamp = plain("#5fe05a" if k < 2 else "#4a4f55", 0.0)
        base.append(box(0.002, 0.007, 0.007, (0.0472, -0.018 + 0.012 * k, 0.043), lamp))
    groups = [upper, grip, base, [bit]]
    if size == "hammer":
        profile = [(0, 0.03), (0.011, 0.032), (0.0165, 0.055), (0.0125, 0.08), (0.016, 0.11)]
        bar = lathe([*profile, (0, 0.112)], 7)
        bar.mats = [dark]
        ring = lathe([(0.9 * r, 0.037), (1.14 * r, 0.037), (1.14 * r, 0.052), (0.9 * r, 0.052)], 8)
        ring.mats = [dark]
        ring.turn(ry=math.pi / 2).move(z=top)
        groups.append([bar.turn(rx=math.pi / 2).move(0.045, 0, top), ring])
    return groups


def corded(colour: str, name: str) -> list[list[Mesh]]:
    """A mains drill lying on its side, its cable coiled behind."""
    r, top = 0.036, 0.17
    dark = plain("#26282c", 0.05)
    upper = drill_top(colour, r, -0.1, 0.09, top) + brand_plate(colour, name, r, top)
    bit = upper.pop(3)
    grip = [grip_loft(0.03, top - 0.6 * r, -0.075, -0.06, plain(colour, 0.04), 0.04)]
    grip.append(box(0.014, 0.02, 0.045, (-0.03, 0, top - r - 0.05), dark, 0.004))
    for group in (upper, grip, [bit]):
        for mesh in group:
            mesh.turn(rx=math.pi / 2)  # the grip points to +y
    low = min(m.v[:, 2].min() for m in (*upper, *grip))
    for mesh in (*upper, *grip, bit):
        mesh.move(z=-low)
    z = r
    path = [(-0.078, -0.034, z), (-0.085, 0.01, 0.02), (-0.11, 0.045, 0.006), (-0.15, 0.02, 0.006)]
    path += [(-0.16, -0.06, 0.006), (-0.13, -0.13, 0.006), (-0.17, -0.17, 0.006)]
    cable = tube(spline(path, 3), 0.0055, 6, mat=dark)
    plug = box(0.042, 0.026, 0.02, (-0.185, -0.185, 0), dark, 0.005)
    pins = [
        box(0.02, 0.0055, 0.0055, (-0.212, -0.185 + s * 0.007, 0.008), metal("c9cdd1"))
        for s in (-1, 1)
    ]
    return [upper, grip, [bit], [cable], [plug, *pins]]


def power_drill(kind: str, colour: str, name: str) -> Model:
    """A drill: cordless "standard", "compact", "hammer" (side handle), "lying", or "corded"."""
    if kind == "corded":
        return lying("electric drill", corded(colour, name), 1.9, 256)
    groups = cordless(colour, name, kind)
    if kind == "lying":
        for group in groups:
            for mesh in group:
                mesh.turn(rx=math.pi / 2)
        low = min(m.v[:, 2].min() for g in groups for m in g)
        for group in groups:
            for mesh in group:
                mesh.move(z=-low)
    mass = {"compact": 1.1, "hammer": 2.0}.get(kind, 1.5)
    return lying("cordless drill", groups, mass, 256)


MODELS = {
    "handsaw": maker(
        handsaw,
        ("kind", "colour", "second"),
        [
            ("panel", "#c8935a", ""),
            ("hacksaw", "#c8202c", "#26282c"),
            ("tenon", "#8a5228", "#c9a24a"),
            ("bow", "#e8641c", ""),
            ("pruning", "#2f8f4a", ""),
            ("panel", "#7a4a26", ""),
            ("hacksaw", "#1f5fb0", "#1c1c20"),
        ],
    ),
    "power_drill": maker(
        power_drill,
        ("kind", "colour", "name"),
        [
            ("standard", "#f2c21e", "BORAX"),
            ("compact", "#1f7fb0", "MINIX"),
            ("hammer", "#c8202c", "TORQO"),
            ("lying", "#e8641c", "DRILLO"),
            ("corded", "#2f8f5a", "BOHRA"),
            ("standard", "#1f8f9a", "TORQO"),
            ("compact", "#d8202c", "DRILLO"),
        ],
    ),
}
