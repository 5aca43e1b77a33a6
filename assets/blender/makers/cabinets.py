"""Cupboards with hinged doors: the bathroom cabinet on the wall, the tall utility cupboard."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, tube

from .designs import extend
from .joinery import (
    Assembly,
    bar_handle,
    carcass,
    finish,
    front,
    hinge,
    open_closed,
    steel,
    surface,
)
from .larders import larder

Offset = tuple[float, float, float]


def mirror_glass(height: float) -> Material:
    """A looking glass: silver, a little lighter towards its top. No light is painted on it: the
    renderer adds a sheen, and bands of light that do not move look drawn."""
    m = Material(occlusion=0.3)
    return m.colour(m.mix(m.remap(m.axis(2), 0.0, height), "#b3c1c8", "#cbd7dc"))


def round_knob(asm: Assembly, part: str, x: float, y: float, z: float, mat: Material) -> None:
    """A small knob on a front whose outer face lies at x."""
    profile = [(0, 0), (0.006, 0), (0.006, 0.007), (0.012, 0.012), (0.011, 0.018), (0, 0.02)]
    asm.add(part, lathe(profile, 10, mat=mat).turn(ry=np.pi / 2).move(x - 0.001, y, z))


def bathroom_cabinet(
    width: float = 0.6,
    height: float = 0.65,
    depth: float = 0.16,
    colour: str = "#f1f1ee",
    layout: str = "two",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A cabinet to hang on a bathroom wall, two shelves in each bay.

    layout: "one" mirrored door, "two" doors (the left one mirrored), or a mirrored door and an
    open "niche".
    """
    asm, half, t = Assembly(), width / 2, 0.016
    back, case_front = -depth / 2, depth / 2 - 0.018
    case, inner, metal = finish(colour, 2, offset), plain("#f4f5f4", 0.012, 8), steel(30)
    board = plain("#c6dade", 0.04, 12)
    carcass(asm, "body", (back, -half, 0), (case_front, half, height), case, inner, t)
    split = {"one": half, "two": 0.0, "niche": 0.18 * width}[layout]
    bays = [("left", -half + t, half - t if layout == "one" else split - t / 2)]
    if layout != "one":
        asm.board("body", (back, split - t / 2, t), (case_front, split + t / 2, height - t), inner)
        bays.append(("right", split + t / 2, half - t))
    shelf = case_front - (0.008 if layout == "niche" else 0.014)
    joints: dict[str, Joint] = {}
    settings: dict[str, dict] = {}
    states: list[dict] = []
    containers: list[Container] = []
    supports = [surface("top", (back, -half), (case_front, half), height, margin=0.008)]
    outer = depth / 2
    for side, a, b in bays:
        doored = side == "left" or layout == "two"
        inside = "inside" if len(bays) == 1 else f"inside_{side}" if doored else "niche"
        step = (height - t) / 3
        for k in range(3):
            z = t + k * step
            if k:
                low, high = (back + 0.008, a, z - 0.008), (shelf, b, z)
                asm.board("body", low, high, board if doored else inner, 0.001)
            name = f"{inside}_floor" if k == 0 else f"{inside}_shelf_{k}"
            low, high = (back + 0.008, a), (shelf if k else case_front, b)
            supports.append(
                surface(name, low, high, z, step - (0.008 if k < 2 else t), inside, margin=0.006)
            )
        center = ((back + 0.008 + case_front) / 2, (a + b) / 2, height / 2)
        size = (case_front - back - 0.012, b - a, height - 2 * t)
        door = "door" if len(bays) == 1 else f"door_{side}"
        containers.append(Container(inside, center, size, "body", door if doored else None))
        if not doored:
            continue
        y0, y1 = (-half, split) if side == "left" else (split, half)
        y0, y1 = y0 + 0.0015, y1 - 0.0015
        leaf = (case_front + 0.001, y0, 0.002), (outer, y1, height - 0.002)
        if side == "left":
            asm.board(door, *leaf, metal, 0.003, {"+x": mirror_glass(height)}, weight=1.3)
            grip = (outer - 0.012, y1 - 0.09, 0.0), (outer + 0.008, y1 - 0.03, 0.012)
            asm.board(door, *grip, metal, 0.002, solid=False)
        else:
            asm.board(door, *leaf, case, 0.003)
            round_knob(asm, door, outer, y0 + 0.03, 0.16 * height, metal)
        hinge_y = y0 if side == "left" else y1
        joints[door] = hinge(outer, hinge_y)
        settings[door] = {"joint": door}
        states += open_closed(door, door)
    what = {"one": "one mirrored door", "two": "two doors", "niche": "mirrored door and niche"}
    return Model(
        title=f"bathroom cabinet, {what[layout]}",
        parts=asm.parts(**settings),
        mass=14 * width / 0.6,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
    )


def bathroom_cabinet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bathroom cabinet."""
    return {
        "width": round(float(rng.uniform(0.55, 0.78)), 2),
        "height": round(float(rng.uniform(0.58, 0.72)), 2),
        "depth": round(float(rng.uniform(0.15, 0.18)), 3),
        "colour": pick(rng, ["#f1f1ee", "oak", "#8fa3a8"]),
        "layout": pick(rng, ["one", "two", "niche"]),
        "offset": noise_offset(rng),
    }


def _vents(asm: Assembly, part: str, outer: float, y: tuple[float, float], z: float) -> None:
    """Ventilation slots across a door, around height z."""
    dark = plain("#55585a", 0.05, 20)
    for k in range(5):
        low = (outer - 0.006, y[0] + 0.06, z + 0.028 * k)
        asm.board(part, low, (outer + 0.001, y[1] - 0.06, low[2] + 0.01), dark, solid=False)


def utility_cupboard(
    width: float = 0.8,
    height: float = 1.9,
    depth: float = 0.42,
    wood: str = "#e7e8e6",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A tall cupboard: shelves, and from 0.7 m on a second bay for brooms, with a shelf high up."""
    asm, half, t, plinth = Assembly(), width / 2, 0.018, 0.06
    back, case_front = -depth / 2, depth / 2 - 0.018
    outside, metal = finish(wood, 2, offset), steel()
    inside = finish("#efede8" if wood.startswith("#") else "birch", 2, offset)
    kick = plain("#4a4c4e", 0.04, 8)
    asm.board("body", (back, -half + 0.01, 0), (case_front - 0.03, half - 0.01, plinth), kick)
    carcass(asm, "body", (back, -half, plinth), (case_front, half, height), outside, inside, t)
    floor, roof, outer = plinth + t, height - t, depth / 2
    two = width >= 0.7
    if two:
        asm.board("body", (back, -t / 2, floor), (case_front, t / 2, roof), inside)
    bays = [("left", -half, 0.0), ("right", 0.0, half)] if two else [("", -half, half)]
    joints, settings, states, containers = {}, {}, [], []
    supports = [surface("top", (back, -half), (case_front, half), height)]
    for side, y0, y1 in bays:
        tail = f"_{side}" if side else ""
        hollow, door = f"inside{tail}", f"door{tail}"
        a, b = y0 + (t if y0 == -half else t / 2), y1 - (t if y1 == half else t / 2)
        shelved = [float(z) for z in np.linspace(floor, roof, 6)[:5]]
        levels = [floor, roof - 0.36] if side == "right" else shelved
        low, high = (back + 0.008, a), (case_front - 0.025, b)
        for k, z in enumerate(levels):
            if k:
                asm.board("body", (*low, z - t), (*high, z), inside, 0.001)
            roof_of_shelf = levels[k + 1] - t if k + 1 < len(levels) else roof
            name = f"{hollow}_floor" if k == 0 else f"{hollow}_shelf_{k}"
            supports.append(surface(name, low, high, z, roof_of_shelf - z, hollow))
        if side == "right":
            rail = [(back + 0.03, a, roof - 0.5), (back + 0.03, b, roof - 0.5)]
            asm.add("body", tube(rail, 0.008, 6, mat=metal))
        center = ((back + case_front) / 2, (a + b) / 2, (floor + roof) / 2)
        containers.append(
            Container(hollow, center, (case_front - back - 0.01, b - a, roof - floor), "body", door)
        )
        leaf = (y0 + 0.002, y1 - 0.002)
        front(asm, door, case_front, leaf, (plinth + 0.003, height - 0.002), outside)
        _vents(asm, door, outer, leaf, height - 0.28)
        _vents(asm, door, outer, leaf, plinth + 0.1)
        left_hung = side == "left"
        handle_y = leaf[1] - 0.04 if left_hung else leaf[0] + 0.04
        bar_handle(asm, door, outer, handle_y, 1.0, 0.18, metal, reach=0.026)
        joints[door] = hinge(outer, y0 if left_hung else y1)
        settings[door] = {"joint": door}
        states += open_closed(door, door)
    return Model(
        title=f"tall utility cupboard, {'two doors' if two else 'one door'}",
        parts=asm.parts(**settings),
        mass=48 * width / 0.6,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def utility_cupboard_random(rng: np.random.Generator) -> dict:
    """Parameters of a random utility cupboard."""
    return {
        "width": pick(rng, [0.5, 0.6, 0.8]),
        "height": round(float(rng.uniform(1.82, 1.98)), 2),
        "depth": round(float(rng.uniform(0.4, 0.5)), 2),
        "wood": pick(rng, ["#e7e8e6", "oak", "#b7c0bd"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "bathroom_cabinet": extend(
        Maker(
            bathroom_cabinet,
            bathroom_cabinet_random,
            3,
            [
                {"layout": "one", "width": 0.5, "height": 0.66, "colour": "#f1f1ee", "depth": 0.15},
                {"layout": "two", "width": 0.66, "height": 0.62, "colour": "oak", "depth": 0.16},
                {
                    "layout": "niche",
                    "width": 0.8,
                    "height": 0.7,
                    "colour": "#8fa3a8",
                    "depth": 0.17,
                },
            ],
        ),
        [
            (
                bathroom_cabinet,
                {"layout": "one", "width": 0.5, "height": 0.66, "colour": "oak", "depth": 0.15},
            ),
            (
                bathroom_cabinet,
                {
                    "layout": "two",
                    "width": 0.66,
                    "height": 0.62,
                    "colour": "#f1f1ee",
                    "depth": 0.16,
                },
            ),
            (
                bathroom_cabinet,
                {"layout": "one", "width": 0.42, "height": 0.8, "colour": "walnut", "depth": 0.24},
            ),
            (
                bathroom_cabinet,
                {
                    "layout": "two",
                    "width": 0.84,
                    "height": 0.52,
                    "colour": "#f1f1ee",
                    "depth": 0.14,
                },
            ),
        ],
    ),
    "utility_cupboard": extend(
        Maker(
            utility_cupboard,
            utility_cupboard_random,
            2,
            [
                {"width": 0.8, "height": 1.9, "wood": "#e7e8e6", "depth": 0.44},
                {"width": 0.55, "height": 1.84, "wood": "oak", "depth": 0.5},
            ],
        ),
        [
            (utility_cupboard, {"width": 0.8, "height": 1.9, "wood": "oak", "depth": 0.44}),
            (utility_cupboard, {"width": 0.55, "height": 1.84, "wood": "#e7e8e6", "depth": 0.5}),
            (utility_cupboard, {"width": 0.45, "height": 2.05, "wood": "#b7c0bd", "depth": 0.38}),
            (larder, {"wood": "#e7e8e6"}),
            (larder, {"wood": "#93a68f"}),
        ],
    ),
}
