"""Toilet, washbasin and bathtub. Mirrors, towel rails and mats have files of their own."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Container, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, loft, rounded_rectangle, superellipse, tube

from .bath_forms import ceramic_basin, hand_basin, oval_tub, vessel_basin
from .bath_water import WATER, fill, filled
from .designs import extend
from .joinery import (
    Assembly,
    carcass,
    finish,
    front,
    hinge,
    open_closed,
    steel,
    surface,
)
from .kitchen import basin, stream, switched, tap

Offset = tuple[float, float, float]
#: The ceramic top of a washstand.
SLAB_M = 0.05


def _ceramic(offset: Offset) -> Material:
    return plain("#f4f5f3", 0.012, 8, offset)


def _egg(length: float, width: float, n: int = 24) -> np.ndarray:
    """A toilet seat's outline, (n, 2): blunt at the back (-x), round in front, around (0, 0)."""
    t = np.arange(n) * 2 * math.pi / n
    c, s = np.cos(t), np.sin(t)
    x = length / 2 * np.sign(c) * np.abs(c) ** np.where(c > 0, 1.0, 0.55)
    y = width / 2 * np.sign(s) * np.abs(s) ** 0.85 * (1 - 0.06 * c)
    return np.c_[x, y]


def _tone(colour: str) -> str:
    return {"#e9e8e4": "white", "#8fa3a8": "blue-grey"}.get(colour, colour)


def washbasin(
    width: float = 0.8,
    colour: str = "#e9e8e4",
    top: str = "oak",
    style: str = "slab",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A washstand: a broad ceramic basin, in the middle of its top, over a cabinet on legs."""
    asm, half = Assembly(), width / 2
    x0, case_front, x1, floor, height = -0.24, 0.2, 0.24, 0.2, 0.85
    fronts, board, metal = finish(colour, 2, offset), finish(top, 1, offset), steel()
    china = _ceramic(offset)
    carcass(
        asm,
        "body",
        (x0, -half + 0.01, floor),
        (case_front, half - 0.01, height - SLAB_M),
        fronts,
        fronts,
        top=False,
    )
    for x in (x0 + 0.03, case_front - 0.05):
        for y in (-half + 0.03, half - 0.06):
            asm.board("body", (x, y, 0), (x + 0.03, y + 0.03, floor), board)
    sx, sy, cx, cy, rim = 0.28, 0.36, 0.035, 0.0, 0.054
    a, b = cx - sx / 2 - 0.002, cx + sx / 2 + 0.002
    c, d = cy - sy / 2 - 0.002, cy + sy / 2 + 0.002
    for low, high in (
        ((x0, -half), (x1, c)),
        ((x0, d), (x1, half)),
        ((x0, c), (a, d)),
        ((b, c), (x1, d)),
    ):
        asm.board("body", (*low, height - SLAB_M), (*high, height), china)
    asm.board("body", (x0, -half, height), (x0 + 0.014, half, height + 0.05), china, 0.004)
    basin(asm, (cx, cy), (sx, sy), height, 0.13, china, rim, 0.12)
    tap(asm, x0 + 0.052, cy, height, 0.13, 0.17, metal)
    stream(asm, x0 + 0.182, cy, height + 0.105, height - 0.128, 0.011)
    states, joints, settings = [], {}, {}
    for door, y0, y1 in (("door_left", -half + 0.01, 0.0), ("door_right", 0.0, half - 0.01)):
        z = (floor + 0.002, height - SLAB_M - 0.004)
        front(asm, door, case_front, (y0 + 0.002, y1 - 0.002), z, fronts, style)
        y = -0.04 if door == "door_left" else 0.04
        knob = lathe([(0, 0), (0.006, 0), (0.006, 0.01), (0.013, 0.014), (0, 0.022)], 10, mat=metal)
        asm.add(door, knob.turn(ry=math.pi / 2).move(case_front + 0.018, y, 0.62), solid=True)
        joints[door] = hinge(case_front + 0.018, y0 if door == "door_left" else y1)
        states += open_closed(door, door)
        settings[door] = {"joint": door}
    low, high = (x0 + 0.01, -half + 0.03), (case_front, half - 0.03)
    room = height - 0.15 - floor - 0.018
    aside = sy / 2 + rim + 0.002
    center = ((low[0] + high[0]) / 2, 0, floor + 0.018 + room / 2)
    return Model(
        title=f"washbasin on a {_tone(colour)} cabinet",
        parts=asm.parts(**settings, water={"rgba": (1.15, 1.15, 1.15, 1.0)}),
        mass=36.0,
        joints=joints,
        variants=switched(asm, "water")["variants"],
        states=switched(asm, "water")["states"] + states,
        supports=[
            surface("top", (x0 + 0.014, -half), (x1, cy - aside), height),
            surface("top_left", (x0 + 0.014, cy + aside), (x1, half), height),
            surface("inside_floor", low, high, floor + 0.018, room, "inside"),
            surface(
                "basin_floor",
                (cx - 0.08, cy - 0.12),
                (cx + 0.08, cy + 0.12),
                height - 0.128,
                None,
                "basin",
            ),
        ],
        containers=[
            Container(
                "inside", center, (high[0] - low[0], high[1] - low[1], room), "body", "door_left"
            ),
            Container("basin", (cx, cy, height - 0.065), (sx - 0.02, sy - 0.02, 0.13)),
        ],
        ground_shadow=True,
    )


def washbasin_random(rng: np.random.Generator) -> dict:
    """Parameters of a random washbasin."""
    return {
        "width": pick(rng, [0.8, 0.9, 1.0]),
        "colour": pick(rng, ["#e9e8e4", "walnut", "#8fa3a8"]),
        "top": pick(rng, ["oak", "#2f3133"]),
        "style": pick(rng, ["slab", "shaker"]),
        "offset": noise_offset(rng),
    }


def bathtub(
    length: float = 1.65,
    width: float = 0.74,
    panelled: bool = True,
    panel: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A tub, hollow, along y, with its tap at one end; boxed in (in a colour or wood of its own:
    `panel`), or free-standing on feet."""
    asm, height, floor = Assembly(), 0.58, 0.16
    china, metal = _ceramic(offset), steel(20)

    def ring(grow: float, z: float, power: float = 4.0) -> np.ndarray:
        return superellipse(width / 2 + grow, length / 2 + grow, power, 32, z)

    if panelled:
        outside = [(-0.0, 0.0), (0.0, height - 0.02), (0.0, height)]
        shell = []
        for grow, z in outside:
            outline = rounded_rectangle(width + 2 * grow, length + 2 * grow, 0.03, 8)
            order = np.argsort(np.arctan2(outline[:, 1] / length, outline[:, 0] / width))
            shell.append(np.c_[outline[order], np.full(len(outline), z)])
        start = ring(0, 0)
        begin = np.argsort(np.arctan2(start[:, 1] / length, start[:, 0] / width))

        def inner(grow: float, z: float, power: float) -> np.ndarray:
            return ring(grow, z, power)[begin]

        rings = [
            *shell,
            inner(-0.06, height + 0.008, 6),
            inner(-0.075, height - 0.01, 6),
            inner(-0.11, 0.3, 5),
        ]
        rings += [inner(-0.15, floor + 0.03, 4), inner(-0.19, floor, 4)]
        outer = 3
    else:
        rings = [
            ring(-0.17, 0.1, 3),
            ring(-0.1, 0.14, 3),
            ring(-0.03, 0.4, 3),
            ring(-0.01, height - 0.03, 3),
        ]
        rings += [ring(0, height - 0.015, 3), ring(0, height, 3), ring(-0.05, height + 0.006, 3)]
        rings += [
            ring(-0.06, height - 0.01, 3),
            ring(-0.09, 0.35, 3),
            ring(-0.15, floor + 0.04, 3),
            ring(-0.2, floor, 3),
        ]
        outer = 6
        for sx in (-1, 1):
            for sy in (-1, 1):
                foot = [(0, 0), (0.03, 0), (0.034, 0.02), (0.018, 0.06), (0.03, 0.12), (0, 0.13)]
                x, y = sx * (width / 2 - 0.16), sy * (length / 2 - 0.28)
                asm.add("body", lathe(foot, 10, mat=metal).move(x, y, 0))
                asm.solid("body", (x - 0.03, y - 0.03, 0), (x + 0.03, y + 0.03, 0.12))
    box = finish(panel, 2, offset) if panel else china
    sides = 0 if panelled else -1  # the first ring of faces
    asm.add("body", loft(rings, mats=[china, box], mat_of_face=lambda k, i: int(k == sides)))
    hx, hy, w = width / 2, length / 2, 0.09
    low_z = 0.0 if panelled else 0.1
    asm.solid("body", (-hx + 0.03, -hy + 0.03, low_z), (hx - 0.03, hy - 0.03, floor))
    for low, high in (
        ((-hx, -hy), (-hx + w, hy)),
        ((hx - w, -hy), (hx, hy)),
        ((-hx + w, -hy), (hx - w, -hy + w)),
        ((-hx + w, hy - w), (hx - w, hy)),
    ):
        asm.solid("body", (*low, floor if not panelled else 0), (*high, height + 0.006))
    drain = lathe(
        [(0, floor), (0.03, floor), (0.028, floor + 0.004), (0, floor + 0.003)], 12, mat=metal
    )
    asm.add("body", drain.move(0, -hy + 0.45, 0))
    # filler tap on the rim at the -y end
    y = -hy + 0.03
    spout = [
        (0, y, height),
        (0, y, height + 0.11),
        (0, y + 0.04, height + 0.14),
        (0, y + 0.13, height + 0.12),
    ]
    asm.add("body", tube(spout, 0.015, 8, mat=metal))
    for x in (-0.09, 0.09):
        knob = [
            (0, height),
            (0.02, height),
            (0.014, height + 0.02),
            (0.026, height + 0.035),
            (0.026, height + 0.05),
            (0, height + 0.056),
        ]
        asm.add("body", lathe(knob, 10, mat=metal).move(x, y, 0))
    stream(asm, 0, y + 0.135, height + 0.12, floor, 0.016)
    tongues = ((-0.38, 0.3), (0.12, 0.24), (0.5, 0.2))
    fill(asm, rings[outer:], rings[outer - 1 :: -1], length, tongues)
    switch = filled(switched(asm, "water"))
    # the rectangle within the level floor, an oval of the loft's last ring
    grow, power = (0.19, 4.0) if panelled else (0.2, 3.0)
    share = 2 ** (-1 / power)
    inside = ((width - 2 * grow) * share, (length - 2 * grow) * share)
    return Model(
        title="bathtub, boxed in" if panelled else "free-standing bathtub",
        parts=asm.parts(
            water={"rgba": (1.15, 1.15, 1.15, 1.0)}, bath=WATER, brim=WATER | {"open": True}
        ),
        variants=switch["variants"],
        states=switch["states"],
        mass=60.0,
        supports=[
            surface(
                "floor",
                (-inside[0] / 2, -inside[1] / 2),
                (inside[0] / 2, inside[1] / 2),
                floor,
                None,
                "tub",
            )
        ],
        containers=[
            Container(
                "tub", (0, 0, (floor + height) / 2), (width - 0.18, length - 0.18, height - floor)
            )
        ],
        ground_shadow=True,
    )


def bathtub_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bathtub."""
    return {
        "length": round(float(rng.uniform(1.55, 1.75)), 2),
        "width": round(float(rng.uniform(0.7, 0.78)), 2),
        "panelled": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


MODELS = {
    "washbasin": extend(
        Maker(
            washbasin,
            washbasin_random,
            2,
            [
                {"width": 0.8, "colour": "#e9e8e4", "top": "oak"},
                {"width": 1.0, "colour": "walnut", "top": "#2f3133"},
            ],
        ),
        [
            (washbasin, {"width": 0.8, "colour": "#8fa3a8", "top": "oak"}),
            (ceramic_basin, {"stand": "pedestal"}),
            (ceramic_basin, {"stand": "legs"}),
            (vessel_basin, {"wood": "oak", "bowl": "round"}),
            (vessel_basin, {"wood": "walnut", "bowl": "square"}),
            (hand_basin, {"colour": "#eceae6"}),
            (hand_basin, {"colour": "#8fa3a8"}),
            (hand_basin, {"colour": "oak"}),
            (hand_basin, {"colour": "walnut"}),
        ],
    ),
    "bathtub": extend(
        Maker(
            bathtub, bathtub_random, 2, [{"panelled": True}, {"panelled": True, "panel": "#a9b3a6"}]
        ),
        [
            (oval_tub, {"style": "inset"}),
            (oval_tub, {"style": "modern", "colour": "#4c5357"}),
            (oval_tub, {"style": "slipper"}),
            (oval_tub, {"style": "slipper", "colour": "#5f7f86"}),
            (oval_tub, {"style": "corner"}),
        ],
    ),
}
