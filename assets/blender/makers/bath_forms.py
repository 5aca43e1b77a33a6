"""More washbasins and bathtubs: on a pedestal, on the wall, a bowl on a board; oval, with feet."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Container, Joint, Model
from toolkit.shapes import lathe, loft, superellipse, tube

from .bath_water import WATER, fill, filled
from .joinery import (
    Assembly,
    bar_handle,
    carcass,
    drawer_box,
    finish,
    front,
    open_closed,
    steel,
    surface,
)
from .kitchen import stream, switched, tap

Offset = tuple[float, float, float]
WET = (1.15, 1.15, 1.15, 1.0)


def _bowl(
    asm: Assembly, cx: float, half: tuple, z: tuple, china, power: float, wall: float = 0.012
) -> None:
    """A hollow basin: outside from z[0] up to the rim at z[1], floor 2 cm above its underside."""
    (hx, hy), (z0, z1) = half, z

    def ring(k: float, at: float, inset: float = 0.0) -> np.ndarray:
        r = superellipse(hx * k - inset, hy * k - inset, power, 20, at)
        return r + np.array([cx, 0, 0])

    rings = [ring(0.55, z0), ring(0.85, z0 + 0.3 * (z1 - z0)), ring(1.0, z1 - 0.01), ring(1.0, z1)]
    rings += [
        ring(1.0, z1, wall),
        ring(0.98, z1 - 0.01, wall),
        ring(0.8, z0 + 0.35 * (z1 - z0), wall),
    ]
    rings += [ring(0.5, z0 + 0.022)]
    asm.add("body", loft(rings, china))
    asm.solid("body", (cx - 0.6 * hx, -0.6 * hy, z0), (cx + 0.6 * hx, 0.6 * hy, z0 + 0.022))
    for low, high in (
        ((cx - hx, -hy), (cx - 0.8 * hx, hy)),
        ((cx + 0.8 * hx, -hy), (cx + hx, hy)),
        ((cx - hx, -hy), (cx + hx, -0.82 * hy)),
        ((cx - hx, 0.82 * hy), (cx + hx, hy)),
    ):
        asm.solid("body", (*low, z0 + 0.4 * (z1 - z0)), (*high, z1))
    drain = [(0, z0 + 0.02), (0.024, z0 + 0.021), (0.022, z0 + 0.027), (0, z0 + 0.025)]
    asm.add("body", lathe(drain, 10, mat=plain("#55585b", 0.05, 40)).move(cx, 0, 0))


def ceramic_basin(
    stand: str = "pedestal", width: float = 0.58, offset: Offset = (0, 0, 0)
) -> Model:
    """stand: on a "pedestal", or on two chrome "legs" with its bottle trap showing."""
    asm, china, metal = Assembly(), plain("#f4f5f3", 0.012, 8, offset), steel(30)
    half, x0, top = width / 2, -0.23, 0.85
    # a deck at the back for tap and soap, joined to the bowl
    asm.board("body", (x0, -half, top - 0.07), (x0 + 0.13, half, top), china, 0.016, segments=2)
    _bowl(asm, 0.03, (0.2, half), (top - 0.16, top), china, 3.0 if stand == "legs" else 2.4)
    tap(asm, x0 + 0.07, 0, top, 0.13, 0.15, metal)
    stream(asm, x0 + 0.2, 0, top + 0.093, top - 0.14, 0.011)
    if stand == "pedestal":
        foot = [(0.14, 0.15, 0), (0.135, 0.145, 0.03), (0.085, 0.09, 0.12), (0.075, 0.08, 0.45)]
        foot += [(0.11, 0.13, top - 0.14)]
        rings = [superellipse(a, b, 2.6, 16, z) - [0.06, 0, 0] for a, b, z in foot]
        asm.add("body", loft(rings, china), solid=False)
        asm.solid("body", (-0.2, -0.13, 0), (0.06, 0.13, 0.05))
        asm.solid("body", (-0.14, -0.085, 0.05), (0.02, 0.085, top - 0.15))
    else:
        for y in (-half + 0.06, half - 0.06):
            post = [(0, 0), (0.022, 0), (0.022, 0.012), (0.014, 0.02), (0.014, top - 0.06)]
            asm.add(
                "body", lathe([*post, (0, top - 0.06)], 8, mat=metal).move(0.12, y, 0), solid=True
            )
            low, high = (x0, y - 0.012, 0.0), (x0 + 0.03, y + 0.012, top - 0.06)
            asm.board("body", low, high, metal, 0.003)
        trap = [(0, 0.5), (0.035, 0.5), (0.035, 0.62), (0.02, 0.63), (0.02, 0.7), (0, 0.7)]
        asm.add("body", lathe(trap, 12, mat=metal).move(0.03, 0, 0), solid=True)
        asm.add("body", tube([(0.03, 0, 0.56), (-0.2, 0, 0.56)], 0.018, 8, mat=metal))
        plate = [(0, 0), (0.035, 0), (0.03, 0.01), (0, 0.012)]
        asm.add("body", lathe(plate, 12, mat=metal).turn(ry=math.pi / 2).move(x0, 0, 0.56))
        asm.board("body", (x0, -0.04, 0.5), (x0 + 0.02, 0.04, top - 0.07), china, 0.004)
    switch = switched(asm, "water")
    return Model(
        title="pedestal washbasin" if stand == "pedestal" else "washbasin on chrome legs",
        parts=asm.parts(water={"rgba": WET}),
        mass=24.0 if stand == "pedestal" else 15.0,
        variants=switch["variants"],
        states=switch["states"],
        supports=[
            surface("top", (x0, 0.06), (x0 + 0.12, half), top, margin=0.008),
            surface("top_right", (x0, -half), (x0 + 0.12, -0.05), top, margin=0.008),
            surface("basin_floor", (-0.05, -0.12), (0.11, 0.12), top - 0.136, None, "basin"),
        ],
        containers=[Container("basin", (0.03, 0, top - 0.07), (0.28, 2 * half - 0.16, 0.13))],
        ground_shadow=True,
    )


def vessel_basin(wood: str = "oak", bowl: str = "round", offset: Offset = (0, 0, 0)) -> Model:
    """A bowl that stands on a wooden unit with a drawer."""
    asm, metal = Assembly(), steel(30)
    half, x0, case_front, floor, height = 0.4, -0.24, 0.215, 0.2, 0.72
    fronts, board = finish(wood, 1, offset), finish(wood, 2, offset)
    carcass(asm, "body", (x0, -half, floor), (case_front, half, height), board, board)
    for x in (x0 + 0.03, case_front - 0.06):
        for y in (-half + 0.03, half - 0.06):
            asm.board("body", (x, y, 0), (x + 0.03, y + 0.03, floor), plain("#26282b", 0.04))
    asm.board(
        "body",
        (x0 - 0.004, -half - 0.005, height),
        (0.245, half + 0.005, height + 0.025),
        fronts,
        0.004,
    )
    front(
        asm,
        "drawer",
        case_front,
        (-half + 0.002, half - 0.002),
        (floor + 0.002, height - 0.004),
        fronts,
    )
    bar_handle(asm, "drawer", case_front + 0.018, 0, height - 0.1, 0.3, metal, False, 0.026)
    low, high = (x0 + 0.06, -half + 0.03, floor + 0.03), (case_front, half - 0.03, floor + 0.3)
    drawer_box(asm, "drawer", low, high, finish("birch", 0, offset))
    top = height + 0.025
    china = plain("#f4f5f3", 0.012, 8, offset)
    r = (0.19, 0.2) if bowl == "round" else (0.17, 0.24)
    _bowl(asm, 0.02, r, (top, top + 0.13), china, 2.0 if bowl == "round" else 6.0)
    tap(asm, x0 + 0.045, 0, top, 0.15, 0.32, metal)
    stream(asm, x0 + 0.195, 0, top + 0.198, top + 0.02, 0.011)
    switch = switched(asm, "water")
    return Model(
        title=f"{bowl} basin on a {wood} unit with a drawer",
        parts=asm.parts(drawer={"joint": "drawer"}, water={"rgba": WET}),
        mass=34.0,
        joints={"drawer": Joint("prismatic", (0, 0, floor + 0.1), (1, 0, 0), 0.0, 0.3)},
        variants=switch["variants"],
        states=switch["states"] + open_closed("drawer", "drawer", 0.01, 0.12),
        supports=[
            surface("top", (x0, -half), (0.24, -r[1] - 0.01), top),
            surface("top_left", (x0, r[1] + 0.01), (0.24, half), top),
            surface(
                "drawer_floor",
                (low[0] + 0.012, low[1] + 0.012),
                (high[0], high[1] - 0.012),
                low[2] + 0.008,
                0.3,
                "inside",
                "drawer",
            ),
            surface("basin_floor", (-0.05, -0.07), (0.09, 0.07), top + 0.024, None, "basin"),
        ],
        containers=[
            Container(
                "inside",
                ((low[0] + high[0]) / 2, 0, low[2] + 0.16),
                (0.38, 0.68, 0.28),
                "drawer",
                "drawer",
            ),
            Container("basin", (0.02, 0, top + 0.075), (1.4 * r[0], 1.4 * r[1], 0.11)),
        ],
        ground_shadow=True,
    )


def hand_basin(colour: str = "#eceae6", offset: Offset = (0, 0, 0)) -> Model:
    """A small basin for a small room: a ceramic bowl on a narrow cabinet of two drawer fronts."""
    asm, china, metal = Assembly(), plain("#f4f5f3", 0.012, 8, offset), steel(30)
    case, dark = finish(colour, 2, offset), plain("#26282b", 0.04)
    x0, half, top = -0.18, 0.24, 0.85
    asm.board("body", (x0 + 0.01, -0.19, 0), (0.12, 0.19, 0.08), dark)
    asm.board("body", (x0, -0.2, 0.08), (0.14, 0.2, top - 0.17), case, 0.003)
    for low, high in ((0.085, 0.38), (0.386, top - 0.175)):
        asm.board("body", (0.139, -0.197, low), (0.156, 0.197, high), case, 0.004, solid=False)
        knob = [(0, 0), (0.006, 0), (0.006, 0.01), (0.013, 0.014), (0, 0.022)]
        mesh = lathe(knob, 10, mat=metal).turn(ry=math.pi / 2)
        asm.add("body", mesh.move(0.156, 0, high - 0.07))
    # a deck at the back for tap and soap, joined to the bowl
    asm.board("body", (x0, -half, top - 0.06), (x0 + 0.12, half, top), china, 0.014, segments=2)
    _bowl(asm, 0.03, (0.15, half), (top - 0.17, top), china, 4.0)
    tap(asm, x0 + 0.06, 0, top, 0.11, 0.13, metal)
    stream(asm, x0 + 0.17, 0, top + 0.08, top - 0.15, 0.01)
    switch = switched(asm, "water")
    name = {"#eceae6": "white", "#8fa3a8": "blue-grey"}.get(colour, colour)
    return Model(
        title=f"small washbasin on a narrow {name} cabinet",
        parts=asm.parts(water={"rgba": WET}),
        mass=18.0,
        variants=switch["variants"],
        states=switch["states"],
        supports=[
            surface("top", (x0, 0.05), (x0 + 0.11, half), top, margin=0.006),
            surface("top_right", (x0, -half), (x0 + 0.11, -0.05), top, margin=0.006),
            surface("basin_floor", (-0.03, -0.09), (0.09, 0.09), top - 0.146, None, "basin"),
        ],
        containers=[Container("basin", (0.03, 0, top - 0.075), (0.22, 2 * half - 0.14, 0.13))],
        ground_shadow=True,
    )


def oval_tub(
    style: str = "modern", colour: str = "#f4f5f3", length: float = 1.65, offset: Offset = (0, 0, 0)
) -> Model:
    """style: "modern" (an egg down to the floor), "slipper" (one end raised, on claw feet),
    "corner" (a short deep tub in a square surround) or "inset" (an oval in a long one)."""
    asm, metal = Assembly(), steel(20)
    china, inside = plain(colour, 0.015, 8, offset), plain("#f4f5f3", 0.012, 8, offset)
    hx = {"modern": 0.38, "corner": 0.41}.get(style, 0.37)
    hy, boxed = 0.71 if style == "corner" else length / 2, style in ("corner", "inset")
    height, floor = 0.58, 0.15

    def ring(k: float, z: float, power: float = 2.6, inset: float = 0.0) -> np.ndarray:
        r = superellipse(hx * k - inset, hy * (k + 0.06 * (1 - k)) - inset, power, 28, z)
        if style == "slipper":  # the rim climbs towards the +y end
            share = np.clip((z - 0.2) / (height - 0.2), 0, 1)
            r[:, 2] += share * 0.2 * np.clip(r[:, 1] / hy, 0, 1) ** 2
        return r

    base = 0.12 if style == "slipper" else 0.0
    power = 6.0 if style == "corner" else 2.6
    if boxed:
        rings = [superellipse(hx, hy, 24, 28, z) for z in (0, height - 0.01, height)]
        inset = 0.07
    else:
        rings = [
            ring(0.72, base),
            ring(0.8 if style == "modern" else 0.86, base + 0.12),
            ring(0.97, height - 0.06),
        ]
        rings += [ring(1.0, height - 0.015), ring(1.0, height)]
        inset = 0.035
    outer = len(rings)
    rings += [ring(1.0, height + 0.002, power, inset), ring(0.97, height - 0.05, power, inset)]
    rings += [
        ring(0.84, floor + 0.12, power, inset),
        ring(0.74, floor + 0.02, power, inset),
        ring(0.68, floor, power, inset),
    ]
    asm.add(
        "body",
        loft(rings, mats=[china, inside], mat_of_face=lambda k, i: 0 if k < outer - 1 else 1),
    )
    if style == "slipper":
        for sx in (-1, 1):
            for sy in (-1, 1):
                claw = [(0, 0), (0.036, 0), (0.04, 0.025), (0.02, 0.06), (0.034, 0.15), (0, 0.16)]
                x, y = sx * 0.2, sy * (hy - 0.3)
                asm.add("body", lathe(claw, 8, mat=metal).move(x, y, 0), solid=True)
    asm.solid("body", (-0.8 * hx, -0.8 * hy, base), (0.8 * hx, 0.8 * hy, floor))
    w = 0.075
    for low, high in (
        ((-hx, -0.85 * hy), (-hx + w, 0.85 * hy)),
        ((hx - w, -0.85 * hy), (hx, 0.85 * hy)),
        ((-0.75 * hx, -hy), (0.75 * hx, -hy + w)),
        ((-0.75 * hx, hy - w), (0.75 * hx, hy)),
    ):
        asm.solid("body", (*low, floor), (*high, height))
    y = -hy + (0.035 if boxed else 0.02)
    if boxed:
        spout = [
            (0, y, height),
            (0, y, height + 0.1),
            (0, y + 0.05, height + 0.13),
            (0, y + 0.15, height + 0.11),
        ]
        land = y + 0.152
    else:  # a tall pipe beside the tub
        spout = [(0, y - 0.06, 0), (0, y - 0.06, height + 0.22), (0, y - 0.02, height + 0.29)]
        spout += [(0, y + 0.08, height + 0.29), (0, y + 0.15, height + 0.24)]
        land = y + 0.152
        plate = [(0, 0), (0.05, 0), (0.05, 0.01), (0, 0.012)]
        asm.add("body", lathe(plate, 12, mat=metal).move(0, y - 0.06, 0))
        asm.solid("body", (-0.02, y - 0.08, 0), (0.02, y - 0.04, height + 0.25))
    asm.add("body", tube(spout, 0.016, 8, mat=metal))
    for x in (-0.08, 0.08):
        z = height if boxed else height + 0.12
        at = y if boxed else y - 0.06
        if not boxed:
            asm.add("body", tube([(0, at, z), (x, at, z)], 0.011, 6, mat=metal))
        knob = [
            (0, z),
            (0.018, z),
            (0.013, z + 0.02),
            (0.024, z + 0.035),
            (0.02, z + 0.05),
            (0, z + 0.052),
        ]
        asm.add("body", lathe(knob, 8, mat=metal).move(x, at, 0))
    stream(asm, 0, land, spout[-1][2], floor + (0.03 if boxed else 0.09), 0.016)
    drain = [(0, floor), (0.03, floor), (0.028, floor + 0.005), (0, floor + 0.004)]
    asm.add("body", lathe(drain, 10, mat=metal).move(0, -hy + 0.5, 0))
    tongues = ((-0.42 * hy, 0.3), (0.06 * hy, 0.2))
    if style != "slipper":  # whose rim climbs
        tongues += ((0.5 * hy, 0.24),)
    fill(asm, rings[outer:], rings[outer - 1 :: -1], 2 * hy, tongues)
    switch = filled(switched(asm, "water"))
    names = {
        "modern": "free-standing oval bathtub",
        "slipper": "slipper bathtub on claw feet",
        "corner": "short deep bathtub, boxed in",
        "inset": "oval bathtub, boxed in",
    }
    # the rectangle within the level floor, an oval of the loft's last ring
    last, share = ring(0.68, floor, power, inset), 2 ** (-1 / power)
    flat = (float(last[:, 0].max()) * share, float(last[:, 1].max()) * share)
    return Model(
        title=names[style] + ("" if colour == "#f4f5f3" else ", coloured outside"),
        parts=asm.parts(water={"rgba": WET}, bath=WATER, brim=WATER | {"open": True}),
        mass=70.0,
        variants=switch["variants"],
        states=switch["states"],
        supports=[surface("floor", (-flat[0], -flat[1]), flat, floor, None, "tub")],
        containers=[
            Container("tub", (0, 0, (floor + height) / 2), (1.5 * hx, 1.6 * hy, height - floor))
        ],
        ground_shadow=True,
    )
