"""Toy boxes in further shapes; every lid is hinged at the back."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.model import Container, Joint, Model
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, tube

from .casework import metal_or
from .joinery import AJAR, Assembly, cushion, fabric, finish, surface

Offset = tuple[float, float, float]
COLOURS = ("#d9534a", "#f0b429", "#4a90c4", "#5aa469", "#9b6bb3")


def _chest(
    asm: Assembly, title: str, mass: float, hx: float, hy: float, floor: float, rim: float,
    t: float, hinge: tuple[float, float], upper: float = 1.4,
) -> Model:  # fmt: skip
    """The record: what is inside, and the lid's joint at (x, z)."""
    room = rim - floor
    inside = surface("floor", (-hx + t, -hy + t), (hx - t, hy - t), floor, room - 0.015, "inside")
    center, size = (0.0, 0.0, floor + room / 2), (2 * (hx - t), 2 * (hy - t), room - 0.004)
    return Model(
        title,
        asm.parts(lid={"joint": "lid"}),
        mass,
        joints={"lid": Joint("revolute", (hinge[0], 0.0, hinge[1]), (0, -1, 0), 0.0, upper)},
        states=[
            {"state": "CLOSED", "joint": "lid", "max": 0.03, "parts": ["lid"]},
            {"state": "OPEN", "joint": "lid", "min": AJAR, "parts": ["lid"]},
        ],
        supports=[inside],
        containers=[Container("inside", center, size, "body", "lid")],
        ground_shadow=True,
    )


def _walls(asm: Assembly, hx, hy, low, rim, t, side, along, inner, front=None, bevel=0.002) -> None:
    """Four walls and a bottom; the inner faces wear `inner`."""
    asm.board("body", (-hx, -hy, low), (hx, hy, low + t), along, 0, {"+z": inner})
    for s in (-1, 1):
        y = sorted((s * hy, s * (hy - t)))
        asm.board(
            "body",
            (-hx, y[0], low + t),
            (hx, y[1], rim),
            side,
            bevel,
            {"-y" if s > 0 else "+y": inner},
        )
        x = sorted((s * hx, s * (hx - t)))
        skins = {"-x" if s > 0 else "+x": inner}
        if s > 0 and front is not None:
            skins["+x"] = front
        weight = 1.5 if s > 0 and front is not None else 1.0
        asm.board(
            "body", (x[0], -hy + t, low + t), (x[1], hy - t, rim), along, 0, skins, weight=weight
        )


def treasure(
    wood: str = "walnut", metal: str = "brass", width: float = 0.68, offset: Offset = (0, 0, 0)
) -> Model:
    """A pirate's chest: a domed lid, metal bands, a lock."""
    asm, hx, hy, rim, t = Assembly(), 0.21, width / 2, 0.3, 0.018
    side, along, inner = finish(wood, 2, offset), finish(wood, 1, offset), finish("pine", 1, offset)
    gold = metal_or(metal)
    _walls(asm, hx, hy, 0.02, rim, t, side, along, inner)
    a = np.linspace(0, math.pi, 9)
    outer = [(hx * math.cos(q), rim + 0.004 + 0.2 * math.sin(q)) for q in a]
    inner_arc = [((hx - t) * math.cos(q), rim + 0.004 + (0.2 - t) * math.sin(q)) for q in a[::-1]]
    asm.add("lid", extrude([*outer, *inner_arc], 2 * hy, along, axis="y"))
    for s in (-1, 1):
        asm.add("lid", extrude(outer, t, side, axis="y").move(0, s * (hy - t / 2), 0))
    for y in (-hy + 0.05, 0.0, hy - 0.05):
        ring = [((hx + 0.006) * math.cos(q), rim + 0.004 + 0.207 * math.sin(q)) for q in a]
        thin = [((hx - 0.002) * math.cos(q), rim + 0.004 + 0.198 * math.sin(q)) for q in a[::-1]]
        asm.add("lid", extrude([*ring, *thin], 0.045, gold, axis="y").move(0, y, 0))
        for x in (-hx - 0.006, hx - 0.001):
            asm.board("body", (x, y - 0.022, 0.02), (x + 0.007, y + 0.022, rim), gold, solid=False)
    asm.board(
        "lid",
        (hx - 0.004, -0.045, rim - 0.05),
        (hx + 0.014, 0.045, rim + 0.05),
        gold,
        0.006,
        solid=False,
    )
    asm.board(
        "lid",
        (hx + 0.01, -0.01, rim - 0.03),
        (hx + 0.016, 0.01, rim),
        plain("#1d1a16", 0),
        solid=False,
    )
    for s in (-1, 1):
        grip = [
            (0.07, s * (hy + 0.004), 0.2),
            (0.06, s * (hy + 0.02), 0.15),
            (-0.06, s * (hy + 0.02), 0.15),
            (-0.07, s * (hy + 0.004), 0.2),
        ]
        asm.add("body", tube(grip, 0.008, 6, mat=metal_or("iron")))
    for i in range(0, 8, 2):
        pts = [
            (x, y, z) for x, z in (*outer[i : i + 3], *inner_arc[6 - i : 9 - i]) for y in (-hy, hy)
        ]
        asm.piece("lid", np.array(pts))
    return _chest(
        asm, "toy chest like a treasure chest", 12.0, hx, hy, 0.038, rim, t, (-hx, rim + 0.004)
    )


def seat_chest(
    paint: str = "#f2ead8", pad: str = "#e0705a", width: float = 0.76, offset: Offset = (0, 0, 0)
) -> Model:
    """A low bench with a padded lid between two arm rests, animals painted on its front."""
    asm, hx, hy, rim, t = Assembly(), 0.2, width / 2, 0.3, 0.02
    side, inner = finish(paint, 2, offset), finish("birch", 1, offset)
    picture, draw = labels.canvas(256, 96, paint)
    labels.text(draw, "TOYS", (70, 20, 186, 76), "bold", "#4a90c4")
    for x, c in ((34, "#d9534a"), (222, "#5aa469")):  # a bear's and a frog's face
        for s in (-1, 1):
            draw.ellipse((x + s * 17 - 9, 18, x + s * 17 + 9, 36), fill=c)
        draw.ellipse((x - 25, 24, x + 25, 74), fill=c)
        for s in (-1, 1):
            draw.ellipse((x + s * 9 - 4, 40, x + s * 9 + 4, 48), fill="#222222")
        draw.arc((x - 10, 46, x + 10, 64), 20, 160, fill="#222222", width=3)
    _walls(asm, hx, hy - 0.03, 0.03, rim, t, side, side, inner, label(picture))
    for s in (-1, 1):
        y = s * (hy - 0.015)
        shape = [
            (-hx - 0.01, 0),
            (hx + 0.01, 0),
            (hx + 0.01, 0.34),
            (hx - 0.03, 0.42),
            (-hx - 0.01, 0.47),
        ]
        asm.add(
            "body",
            extrude(shape, 0.026, finish(pad, 2, offset), axis="y", bevel_width=0.005).move(
                0, y, 0
            ),
        )
        asm.solid("body", (-hx, y - 0.013, 0), (hx, y + 0.013, 0.42))
    asm.board(
        "lid", (-hx, -hy + 0.034, rim + 0.002), (hx + 0.01, hy - 0.034, rim + 0.02), side, 0.003
    )
    third = (2 * hy - 0.08) / 3
    for k in range(3):
        soft = cushion(
            (2 * hx - 0.01, third - 0.006, 0.04),
            (0, (k - 1) * third, rim + 0.02),
            fabric(pad, offset),
            0.04,
            0.02,
            0.025,
        )
        asm.add("lid", soft)
    asm.solid("lid", (-hx, -hy + 0.034, rim + 0.02), (hx, hy - 0.034, rim + 0.07))
    model = _chest(asm, "toy box to sit on", 12.5, hx, hy - 0.03, 0.05, rim, t, (-hx, rim + 0.002))
    return model


def hamper(lid: str = "#e9c46a", width: float = 0.62, offset: Offset = (0, 0, 0)) -> Model:
    """A woven trunk with ears and a face: a bear."""
    asm, hx, hy, rim, t = Assembly(), 0.2, width / 2, 0.36, 0.018
    m = Material()
    across = m.math("SINE", m.math("MULTIPLY", m.axis(1), 210.0))
    down = m.math("SINE", m.math("MULTIPLY", m.axis(2), 300.0))
    weave = m.remap(m.math("MULTIPLY", across, down), -0.4, 0.6, 0, 0.6)
    m.colour(m.mix(weave, "#c99a5e", "#7a5228"))
    _walls(asm, hx, hy, 0.0, rim, t, m, m, finish("pine", 1, offset))
    felt = fabric(lid, offset)
    rings = []
    for k, z in ((1.0, 0.002), (1.04, 0.006), (1.04, 0.03), (0.3, 0.1)):
        ring = rounded_rectangle(2 * hx * k + 0.012, 2 * hy * k - 0.012, 0.03, 3)
        rings.append(np.c_[np.add(ring, [0.002, 0]), np.full(len(ring), rim + z)])
    asm.add("lid", loft(rings, m).outward())
    asm.solid("lid", (-hx - 0.006, -hy, rim + 0.002), (hx + 0.012, hy, rim + 0.04))
    asm.solid("lid", (-0.12, -0.2, rim + 0.04), (0.12, 0.2, rim + 0.08))
    for s in (-1, 1):
        ear = lathe([(0, -0.02), (0.06, -0.018), (0.075, 0), (0.06, 0.018), (0, 0.02)], 16, mat=m)
        asm.add("lid", ear.turn(ry=math.pi / 2).move(hx - 0.07, s * (hy - 0.1), rim + 0.085))
        inner = lathe([(0, 0.0), (0.045, 0.0), (0.04, 0.006), (0, 0.008)], 14, mat=felt)
        asm.add("lid", inner.turn(ry=math.pi / 2).move(hx - 0.051, s * (hy - 0.1), rim + 0.09))
        eye = lathe([(0, 0), (0.026, 0), (0.022, 0.008), (0, 0.01)], 12, mat=plain("#26211d", 0))
        asm.add("body", eye.turn(ry=math.pi / 2).move(hx - 0.001, s * 0.1, 0.25))
    snout = lathe([(0, 0), (0.085, 0), (0.08, 0.014), (0, 0.02)], 18, mat=fabric("#f3e4c8", offset))
    asm.add("body", snout.scale(0.75, 1, 1).turn(ry=math.pi / 2).move(hx - 0.001, 0, 0.16))
    nose = lathe([(0, 0), (0.03, 0), (0.024, 0.014), (0, 0.018)], 12, mat=plain("#26211d", 0))
    asm.add("body", nose.scale(0.7, 1, 1).turn(ry=math.pi / 2).move(hx + 0.016, 0, 0.19))
    return _chest(
        asm, "toy hamper with a bear's face", 6.0, hx, hy, t, rim, t, (-hx - 0.008, rim + 0.05)
    )


def bins(wood: str = "birch", width: float = 0.78, offset: Offset = (0, 0, 0)) -> Model:
    """A chest with a shallow bin for books before it, a slatted front in colours."""
    asm, hx, hy, rim, t = Assembly(), 0.21, width / 2, 0.42, 0.018
    side, along, inner = finish(wood, 2, offset), finish(wood, 1, offset), finish("pine", 1, offset)
    _walls(asm, hx - 0.06, hy, 0.05, rim, t, side, along, inner)
    for mesh in asm.meshes["body"]:
        mesh.move(-0.06, 0, 0)
    for piece in asm.pieces["body"]:
        piece += [-0.06, 0, 0]
    x = hx - 0.12
    n = 6
    for k in range(n):
        w = 2 * hy / n
        y = -hy + k * w
        tone = finish(COLOURS[k % 5], 2, offset)
        asm.board(
            "body",
            (x, y + 0.006, 0.06),
            (x + 0.012, y + w - 0.006, rim - 0.01),
            tone,
            0.003,
            solid=False,
        )
    for y in (-hy, hy - t):
        shape = [(x, 0.04), (x + 0.11, 0.04), (x + 0.13, 0.2), (x, 0.26)]
        asm.add("body", extrude(shape, t, side, axis="y").move(0, y + t / 2, 0))
        asm.solid("body", (x, y, 0.04), (x + 0.12, y + t, 0.22))
    asm.board("body", (x, -hy + t, 0.04), (x + 0.11, hy - t, 0.055), along)
    asm.board("body", (x + 0.112, -hy, 0.05), (x + 0.13, hy, 0.17), along, 0.004)
    for k, (c, y, tall) in enumerate(
        (("#d9534a", -0.2, 0.27), ("#4a90c4", -0.02, 0.24), ("#f0b429", 0.17, 0.28))
    ):
        book = box(0.02, 0.16, tall, (x + 0.04 + 0.012 * k, y, 0.056), finish(c, 2, offset), 0.002)
        asm.add("body", book.turn(ry=-0.06))
        asm.solid("body", (x + 0.02, y - 0.08, 0.056), (x + 0.07, y + 0.08, tall))
    for a in (-hx - 0.0, x + 0.06):
        for y in (-hy + 0.02, hy - 0.07):
            asm.board("body", (a, y, 0), (a + 0.05, y + 0.05, 0.05), side)
    low, high = (-hx - 0.002, -hy - 0.008, rim + 0.002), (x + 0.02, hy + 0.008, rim + 0.022)
    asm.board("lid", low, high, finish("#5aa469", 1, offset), 0.005, segments=2)
    for y in (-hy / 2, 0.0, hy / 2):
        strip = (-hx, y - 0.025, rim + 0.021), (x + 0.018, y + 0.025, rim + 0.036)
        asm.board("lid", *strip, finish("#5aa469", 1, offset), 0.004, solid=False)
    model = _chest(
        asm,
        "toy chest with a book bin",
        13.0,
        hx - 0.06,
        hy,
        0.068,
        rim,
        t,
        (-hx - 0.002, rim + 0.022),
    )
    for support in model.supports:
        support.polygon = [(px - 0.06, py) for px, py in support.polygon]
    inside = model.containers[0]
    inside.center = (inside.center[0] - 0.06, *inside.center[1:])
    return model


def combo(
    wood: str = "#eceae5", lid: str = "#f0b429", width: float = 0.84, offset: Offset = (0, 0, 0)
) -> Model:
    """A chest beside a low shelf with a fixed top, pictures of toys on the front."""
    asm, hx, hy, rim, t = Assembly(), 0.21, width / 2, 0.43, 0.018
    side, along, inner = (
        finish(wood, 2, offset),
        finish(wood, 1, offset),
        finish("birch", 1, offset),
    )
    split = -hy + 0.36  # the shelf is to the left of it
    asm.board("body", (-hx, -hy, 0.02), (hx, hy, 0.02 + t), along)
    for y in (-hy, split, hy - t):
        asm.board("body", (-hx, y, 0.02 + t), (hx - t, y + t, rim), side, 0.002)
    asm.board("body", (-hx, -hy + t, 0.038), (-hx + t, hy - t, rim), along, 0, {"+x": inner})
    picture, draw = labels.canvas(160, 144, wood)
    for (x, y), c in zip(((40, 40), (104, 40), (40, 104), (104, 104)), COLOURS, strict=False):
        draw.rectangle((x - 24, y - 24, x + 24, y + 24), fill=c)
    for letter, x, y in (("T", 40, 40), ("O", 104, 40), ("Y", 40, 104), ("S", 104, 104)):
        labels.text(draw, letter, (x - 18, y - 18, x + 18, y + 18), "bold", "#ffffff")
    low, high = (hx - t, split, 0.038), (hx, hy, rim)
    asm.board("body", low, high, along, 0, {"+x": label(picture), "-x": inner}, weight=1.4)
    asm.board("body", (-hx + t, -hy + t, 0.22), (hx - 0.01, split, 0.22 + t), along)
    asm.board("body", (-hx, -hy - 0.004, rim), (hx + 0.006, split + t, rim + 0.02), along, 0.003)
    lift = (-hx, split + t + 0.003, rim + 0.001), (hx + 0.012, hy + 0.006, rim + 0.021)
    asm.board("lid", *lift, finish(lid, 1, offset), 0.004, segments=2)
    for k in (1, 2):
        y = split + (hy - split) * k / 3
        strip = (-hx, y - 0.025, rim + 0.02), (hx + 0.01, y + 0.025, rim + 0.035)
        asm.board("lid", *strip, finish(lid, 1, offset), 0.004, solid=False)
    model = _chest(
        asm, "toy box beside a low shelf", 14.0, hx, (hy - split) / 2, 0.038, rim, t,
        (-hx, rim + 0.021),
    )  # fmt: skip
    middle = (hy + split) / 2
    model.supports[0].polygon = [(px, py + middle) for px, py in model.supports[0].polygon]
    held = model.containers[0]
    held.center = (0.0, middle, held.center[2])
    left, right = (-hx, -hy), (hx, split + t)
    model.supports.insert(0, surface("top", left, right, rim + 0.02))
    for k, z in enumerate((0.038, 0.238)):
        at = (-hx + t, -hy + t), (hx - 0.01, split)
        model.supports.append(surface(f"shelf_{k + 1}", *at, z, 0.18))
    return model


TOY_BOXES = [(treasure, {}), (seat_chest, {}), (hamper, {}), (bins, {}), (combo, {})]
