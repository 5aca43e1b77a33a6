"""Umbrellas and extension leads."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import box, lathe, loft, spline, tube

from makers import desk_things, floor_things
from makers.convex import few_corners
from makers.desk_things import extension_cord_random
from makers.floor_things import umbrella_random
from makers.soft_forms import bars, each_hull, footing, ring

TAU = math.tau


def _settle(meshes: list[Mesh], parts: tuple[list[Mesh], list[Mesh]]) -> None:
    """Tip about y until both groups of meshes touch the floor."""
    best, angle = 9.0, 0.0
    a, b = (np.concatenate([m.v for m in group]) for group in parts)
    for t in np.linspace(0.4, 2.6, 221):
        row = np.array([-math.sin(t), 0, math.cos(t)])
        gap = abs(float((a @ row).min() - (b @ row).min()))
        if gap < best:
            best, angle = gap, float(t)
    for m in meshes:  # then towards the front, so that shaft and handle show
        m.turn(ry=angle).turn(rz=2.3)
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for m in meshes:
        m.move(z=-low)


def open_umbrella(radius: float, cloth: str, second: str, crook: bool) -> Model:
    """An open umbrella put down to dry: it rests on its rim and its handle."""
    r, n = radius, 16
    panel = Material()
    angle = panel.math("ARCTAN2", panel.axis(1), panel.axis(0))
    wave = panel.math("SINE", panel.math("MULTIPLY", angle, 4))
    panel.colour(panel.mix(panel.remap(wave, -0.02, 0.02), cloth, second))
    inside = plain(shade(cloth, 0.55), 0.04)
    steps = [(0, 0.0), (0.25, -0.018), (0.55, -0.085), (0.8, -0.18), (1.0, -0.3)]
    outer = [(q * r, z * r / 0.48 + 0.4) for q, z in steps]
    inner = [(q * 0.985, z - 0.006) for q, z in outer]
    profile = [*outer, *inner[::-1]]
    canopy = lathe(
        profile, n, mats=[panel, inside], mat_of_segment=[0, 0, 0, 0, 1, 1, 1, 1, 1],
        rib=lambda k, i: 1.0 if i % 2 == 0 else 1 - 0.09 * min(k, 9 - k) / 4, discs=False,
    ).outward()  # fmt: skip
    steel = metal("b9bdc2", "6a7076")
    grip = wood("8a5a34", "4a2c18", 2, 20) if crook else plain(second, 0.04)
    length = 0.8 * r / 0.48
    foot = 0.4 - length
    shaft = tube([(0, 0, 0.45), (0, 0, foot + 0.08)], 0.006, 6, mat=steel)
    if crook:
        bend = [(0, 0, foot + 0.13), (0, 0, foot + 0.03)]
        bend += [
            (0.04 * (1 - math.cos(t)), 0, foot + 0.03 - 0.04 * math.sin(t))
            for t in np.linspace(0.5, math.pi, 5)
        ]
        handle = tube(np.array(bend), 0.011, 7, mat=grip)
    else:
        handle = tube(
            [(0, 0, foot + 0.1), (0, 0, foot + 0.05), (0, 0, foot)],
            [0.012, 0.014, 0.017],
            7,
            mat=grip,
        )
    meshes = [canopy, shaft, handle]
    hub = 0.4 - 0.24 * r / 0.48
    for k in range(0, n, 2):
        a = TAU * k / n
        c, s = math.cos(a), math.sin(a)
        end = (0.55 * r * c, 0.55 * r * s, 0.4 - 0.098 * r / 0.48)
        meshes.append(tube([(0, 0, hub), end], 0.004, 3, mat=steel, weight=0.5))
    _settle(meshes, ([canopy], [handle]))
    points = canopy.v
    pieces = [
        few_corners(points[points[:, 2] >= np.quantile(points[:, 2], q)], 26) for q in (0.0, 0.5)
    ]
    ends = np.r_[shaft.v[:6], handle.v]
    pieces += [few_corners(ends, 14), footing(meshes)]
    return Model(
        "open umbrella", {"body": Part(meshes, collision=pieces)}, mass=0.5, texture_size=128
    )


def pocket_umbrella(length: float, cloth: str, second: str, crook: bool) -> Model:
    """A folding umbrella, rolled up and strapped, lying down."""
    s = length
    skin = Material()
    turn = skin.math("ARCTAN2", skin.axis(1), skin.axis(0))
    wave = skin.math(
        "SINE",
        skin.math("ADD", skin.math("MULTIPLY", turn, 8), skin.math("MULTIPLY", skin.axis(2), 50)),
    )
    skin.colour(skin.mix(skin.remap(wave, -1, 0.6, 0.55, 0), cloth, shade(cloth, 0.4)))
    profile = [
        (0, 0),
        (0.02, 0.0),
        (0.027, 0.02),
        (0.031, 0.1),
        (0.032, 0.19),
        (0.024, 0.205),
        (0, 0.205),
    ]
    body = lathe(
        profile, 12, mat=skin, rib=lambda k, i: 1 + (0.09 if i % 2 else -0.06), discs=False
    )
    strap = lathe(
        [(0.03, 0.11), (0.0345, 0.112), (0.0345, 0.138), (0.03, 0.14)], 12, mat=plain(second, 0.03)
    )
    bend = [(0, 0, 0.2), (0, 0, 0.25)]
    bend += [
        (0.0, 0.028 * (1 - math.cos(t)), 0.255 + 0.028 * math.sin(t))
        for t in np.linspace(0.5, math.pi, 5)
    ]
    grip = tube(
        np.array([*bend, (0, 0.056, 0.235)]), 0.0095, 7, mat=wood("8a5a34", "4a2c18", 2, 20)
    )
    tip = lathe([(0, -0.02), (0.006, -0.02), (0.008, 0.0), (0, 0.002)], 8, mat=metal())
    ribs = plain("#c9ccd0", 0.05)
    meshes = [body, strap, grip, tip]
    for k in range(6):
        a = k * math.tau / 6
        c, q = 0.03 * math.cos(a), 0.03 * math.sin(a)
        meshes.append(tube([(c, q, 0.18), (c * 1.05, q * 1.05, 0.212)], 0.003, 3, mat=ribs))
    for m in meshes:
        m.scale(s / 0.31).turn(ry=math.pi / 2)
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for m in meshes:
        m.move(z=-low)
    pieces = [few_corners(np.concatenate([body.v, grip.v]), 30), footing(meshes)]
    return Model(
        "folding umbrella", {"body": Part(meshes, collision=pieces)}, mass=0.3, texture_size=128
    )


def umbrella(form: str, length: float, cloth: str, second: str, crook: bool) -> Model:
    """An umbrella: "closed", "open" or "pocket"."""
    if form == "closed":
        return floor_things.umbrella(length, cloth, second, crook)
    make = open_umbrella if form == "open" else pocket_umbrella
    return make(length, cloth, second, crook)


def umbrella_any_random(rng: np.random.Generator) -> dict:
    return umbrella_random(rng) | {"form": "closed"}


# ---- extension leads
def _socket(
    x: float, y: float, z: float, block: str, mats: tuple[Material, Material]
) -> list[Mesh]:
    well, hole = mats
    meshes = [
        lathe([(0.019, 0.0), (0.0185, 0.0008), (0, 0.0008)], 10, mat=well).move(x, y, z - 0.0002)
    ]
    for q in (-1, 1):
        meshes.append(box(0.005, 0.005, 0.0008, (x, y + q * 0.0095, z + 0.0004), hole))
    return meshes


def _plug(block: str, at, turn: float) -> list[Mesh]:
    body = lathe(
        [(0, 0), (0.009, 0), (0.016, 0.014), (0.0175, 0.034), (0, 0.034)], 8, mat=plain(block, 0.03)
    ).turn(ry=math.pi / 2)
    prongs = bars(
        [[(0.03, q * 0.008, 0), (0.052, q * 0.008, 0)] for q in (-1, 1)], 0.003, metal(), 4
    )
    return [m.turn(rz=turn).move(*at) for m in (body, *prongs)]


def power_strip(colour: str, block: str, sockets: int, seed: int) -> Model:
    """A long strip of sockets with a lit switch, its cable tied in a figure of eight."""
    length = 0.07 + 0.05 * sockets
    body, hole, well = plain(block, 0.03), plain("#2a2b2e", 0), plain(shade(block, 0.75), 0)
    meshes = [box(0.056, length, 0.04, (0, 0, 0), body, 0.006)]
    for k in range(sockets):
        y = -length / 2 + 0.04 + 0.05 * k
        meshes += _socket(0, y, 0.04, block, (well, hole))
    meshes.append(
        box(0.024, 0.03, 0.008, (0, length / 2 - 0.025, 0.038), plain("#e0342c", 0), 0.002)
    )
    t = np.linspace(0, 2 * TAU, 34)
    loops = np.c_[
        0.11 + 0.045 * np.sin(2 * t) * 0.8, 0.0 + 0.13 * np.cos(t), 0.006 + 0.014 * t / t[-1]
    ]
    start = [
        (0.0, length / 2, 0.018),
        (0.02, length / 2 + 0.04, 0.006),
        (0.08, length / 2 + 0.02, 0.006),
    ]
    path = np.r_[np.array(start), loops, [(0.2, 0.16, 0.006), (0.22, 0.2, 0.006)]]
    meshes.append(tube(path, 0.0048, 4, mat=plain(colour, 0.03), up=(0, 0, 1), weight=0.6))
    tie = plain("#2a2b2e", 0)
    meshes.append(box(0.05, 0.012, 0.034, (0.11, 0.0, 0.0), tie, 0.003))
    meshes += _plug(block, (0.22, 0.205, 0.0175), 1.2)
    pieces = [
        box_piece((0, 0, 0.02), (0.056, length, 0.04)),
        box_piece((0.11, 0, 0.013), (0.09, 0.27, 0.026)),
    ]
    pieces.append(box_piece((0.225, 0.215, 0.0175), (0.035, 0.05, 0.034)))
    return Model(
        "power strip", {"body": Part(meshes, collision=pieces)}, mass=0.6, texture_size=128
    )


def cable_reel(colour: str, block: str, radius: float, seed: int) -> Model:
    """A drum of cable on a stand with a handle, four sockets in its face."""
    r, w, z = radius, 0.1, radius + 0.03
    drum, cable, frame = plain(block, 0.04), Material(), metal("b9bdc2", "6a7076")
    wave = cable.math("SINE", cable.math("MULTIPLY", cable.axis(0), 620.0))
    cable.colour(cable.mix(cable.remap(wave, -0.7, 0.5, 0.55, 0), colour, shade(colour, 0.4)))
    hole = plain("#2a2b2e", 0)
    profile = [
        (0, -w / 2),
        (r * 0.55, -w / 2),
        (r, -w / 2 - 0.004),
        (r, -w / 2 + 0.008),
        (r * 0.86, -w / 2 + 0.012),
    ]
    profile += [
        (r * 0.86, w / 2 - 0.012),
        (r, w / 2 - 0.008),
        (r, w / 2 + 0.004),
        (r * 0.55, w / 2),
        (0, w / 2),
    ]
    reel = lathe(profile, 16, mats=[drum, cable], mat_of_segment=[0, 0, 0, 0, 1, 0, 0, 0, 0])
    meshes = [reel]
    plate = lathe(
        [(r * 0.5, w / 2), (r * 0.5, w / 2 + 0.006), (0, w / 2 + 0.006)],
        16,
        mat=plain("#26282c", 0.03),
    )
    meshes.append(plate)
    for k in range(4):
        a = k * math.pi / 2 + math.pi / 4
        meshes += _socket(
            0.3 * r * math.cos(a),
            0.3 * r * math.sin(a),
            w / 2 + 0.006,
            block,
            (plain("#c8a02c", 0.02), hole),
        )
    for m in meshes:
        m.turn(ry=math.pi / 2).move(0, 0, z)
    for x in (-w / 2 - 0.03, w / 2 + 0.03):
        feet = [
            (x, -r * 0.9, 0.007),
            (x, -r * 0.55, 0.02),
            (x, 0, z + 0.0),
            (x, r * 0.55, 0.02),
            (x, r * 0.9, 0.007),
        ]
        if x < 0:
            meshes.append(tube(np.array(feet), 0.008, 5, mat=frame))
        else:
            meshes.append(tube([(x, -r * 0.8, 0.008), (x, r * 0.8, 0.008)], 0.008, 5, mat=frame))
    for y in (-0.8, 0.8):
        meshes.append(
            tube([(-w / 2 - 0.03, y * r, 0.01), (w / 2 + 0.03, y * r, 0.008)], 0.008, 5, mat=frame)
        )
    top = z + r + 0.06
    arch = [
        (-w / 2 - 0.03, 0, z),
        (-w / 2 - 0.03, 0, top - 0.02),
        (-w / 2, 0, top),
        (w / 2, 0, top),
    ]
    meshes.append(tube(np.array(arch), 0.009, 5, mat=frame))
    meshes.append(tube([(-w / 2, 0, top), (w / 2, 0, top)], 0.016, 6, mat=plain("#1f2023", 0.04)))
    tail = [
        (0.0, r * 0.9, 0.05),
        (0.02, r + 0.03, 0.006),
        (0.06, r + 0.05, 0.006),
        (0.1, r + 0.02, 0.006),
    ]
    meshes.append(tube(spline(tail, 2), 0.0055, 4, mat=plain(colour, 0.03)))
    meshes += _plug("#2a2b2e", (0.1, r + 0.02, 0.0175), -0.7)
    drum_piece = cylinder_piece(r, -w / 2, w / 2, 12)
    pieces = [np.c_[drum_piece[:, 2], drum_piece[:, 0], drum_piece[:, 1] + z]]
    pieces.append(box_piece((0, 0, 0.01), (w + 0.07, 1.7 * r, 0.02)))
    pieces.append(box_piece((-0.03, 0, top - 0.03), (w, 0.03, 0.07)))
    return Model("cable reel", {"body": Part(meshes, collision=pieces)}, mass=4.0, texture_size=128)


def coiled_lead(colour: str, block: str, radius: float, seed: int) -> Model:
    """A long lead wound in a thick coil, tied, with its plug and its coupling."""
    rng = np.random.default_rng(seed)
    cable = plain(colour, 0.05, 40)
    meshes = []
    for k in range(4):
        r = radius - 0.012 * (k % 3)
        z = 0.008 + 0.013 * (k // 3) + 0.002 * (k % 3)
        turn = ring(15, r + float(rng.normal(0, 0.003)), r * 0.96 + float(rng.normal(0, 0.003)), z)
        meshes.append(tube(turn, 0.0075, 4, closed=True, mat=cable, up=(0, 0, 1), weight=0.6))
    tie = plain("#1f2023", 0.03)
    for a in (0.8, 2.9):
        at = ((radius - 0.012) * math.cos(a), (radius - 0.012) * math.sin(a), 0.0)
        meshes.append(box(0.056, 0.024, 0.036, (0, 0, 0), tie, 0.004).turn(rz=a).move(*at))
    tail = [(radius, 0.0, 0.008), (radius + 0.05, -0.06, 0.008), (radius + 0.05, -0.12, 0.012)]
    meshes.append(tube(spline(tail, 2), 0.0075, 4, mat=cable))
    meshes += _plug(block, (radius + 0.05, -0.115, 0.0175), -1.6)
    tail = [(radius * 0.9, 0.05, 0.008), (radius * 0.5, 0.02, 0.008), (radius * 0.2, -0.01, 0.018)]
    meshes.append(tube(spline(tail, 2), 0.0075, 4, mat=cable))
    coupling = loft(
        [ring(10, 0.012, 0.012, 0), ring(10, 0.02, 0.02, 0.015), ring(10, 0.022, 0.022, 0.055)],
        plain(block, 0.04),
    )
    meshes.append(coupling.turn(ry=-math.pi / 2).move(radius * 0.22, -0.01, 0.021))
    pieces = []
    for k in range(8):
        a, b = TAU * k / 8, TAU * (k + 1) / 8
        pieces.append(
            np.array(
                [
                    (q * math.cos(t), q * math.sin(t), z)
                    for q in (radius - 0.035, radius + 0.008)
                    for t in (a, b)
                    for z in (0, 0.03)
                ]
            )
        )
    pieces += each_hull(meshes[4:], 0.03)
    return Model(
        "coiled extension lead",
        {"body": Part(meshes, collision=pieces)},
        mass=1.2,
        texture_size=128,
    )


def extension_cord(form: str, colour: str, block: str, seed: int, **more) -> Model:
    """An extension lead: "loose", "strip", "reel" or "coil"."""
    if form == "loose":
        return desk_things.extension_cord(colour=colour, block=block, seed=seed, **more)
    if form == "strip":
        return power_strip(colour, block, 6, seed)
    return (cable_reel if form == "reel" else coiled_lead)(colour, block, 0.13, seed)


def extension_cord_any_random(rng: np.random.Generator) -> dict:
    p = extension_cord_random(rng) | {"form": "loose"}
    p["colour"] = pick(rng, ["#f1f1ee", "#2a2b2e"])
    return p


_LOOSE = {"sockets": 3, "coiled": False, "seed": 77}
_CROOK = {"length": 0.85, "crook": True, "second": "#1c1d20"}

MODELS = {
    "umbrella": Maker(
        umbrella,
        umbrella_any_random,
        8,
        [
            {**_CROOK, "cloth": "#2f4f8a"},
            {"cloth": "#26282c", "crook": False},
            {**_CROOK, "cloth": "#c8302c"},
            {"form": "open", "length": 0.46, "cloth": "#c8302c", "second": "#f4f0e6"},
            {"form": "pocket", "length": 0.3, "cloth": "#2f7f5a", "second": "#e8e4d8"},
            {
                "form": "open",
                "length": 0.34,
                "cloth": "#2f8fc8",
                "second": "#f2c83a",
                "crook": False,
            },
            {"form": "open", "length": 0.46, "cloth": "#2a2c33", "second": "#2a2c33"},
            {"form": "pocket", "length": 0.3, "cloth": "#26282c", "second": "#c8302c"},
        ],
    ),
    "extension_cord": Maker(
        extension_cord,
        extension_cord_any_random,
        7,
        [
            {"colour": "#f1f1ee", "block": "#f1f1ee", "sockets": 3, "coiled": True},
            {**_LOOSE, "colour": "#2a2b2e", "block": "#3a3c40"},
            {**_LOOSE, "colour": "#e8702c", "block": "#2a2b2e"},
            {"form": "strip", "colour": "#f1f1ee", "block": "#f1f1ee"},
            {"form": "reel", "colour": "#e8702c", "block": "#d8302c"},
            {"form": "coil", "colour": "#e8702c", "block": "#26282c"},
            {"form": "strip", "colour": "#26282c", "block": "#2f3136"},
        ],
    ),
}
