"""Chests: of drawers, and for toys."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe

from .cabinets import round_knob
from .designs import extend
from .dressers import DRESSERS
from .joinery import (
    AJAR,
    Assembly,
    bar_handle,
    carcass,
    drawer_box,
    finish,
    leg,
    open_closed,
    steel,
    surface,
)
from .toy_chests import TOY_BOXES

Offset = tuple[float, float, float]


def _pulls(
    asm: Assembly, part: str, x: float, y: tuple[float, float], z: float, kind: str, mat: Material
) -> None:
    """What a drawer is pulled by: one bar, two knobs, or a groove cut into its upper edge."""
    middle, wide = (y[0] + y[1]) / 2, y[1] - y[0]
    if kind == "bar":
        bar_handle(asm, part, x, middle, z, min(0.3, 0.4 * wide), mat, False, 0.026)
    elif kind == "knobs":
        for s in (-0.28, 0.28) if wide > 0.5 else (0.0,):
            round_knob(asm, part, x, middle + s * wide, z, mat)
    else:
        low, high = (x - 0.012, middle - 0.07, z + 0.03), (x + 0.0015, middle + 0.07, z + 0.055)
        asm.board(part, low, high, plain("#3a2c22", 0.05, 20), 0.004, solid=False)


def dresser(
    width: float = 0.9,
    height: float = 0.85,
    depth: float = 0.46,
    rows: int = 3,
    columns: int = 1,
    moving: tuple[int, ...] = (0, 1, 2),
    wood: str = "oak",
    fronts: str | None = None,
    legs: bool = True,
    pulls: str = "bar",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A chest of drawers. `moving` numbers (from the top left, row by row) those that slide."""
    asm, half, t = Assembly(), width / 2, 0.018
    back, case_front = -depth / 2, depth / 2 - 0.02
    base = 0.13 if legs else 0.05
    case, face = finish(wood, 2, offset), finish(fronts or wood, 1, offset)
    inside, metal = finish("birch", 0, offset), steel()
    carcass(asm, "body", (back, -half, base), (case_front, half, height - 0.022), case, inside, t)
    for mesh in asm.meshes["body"][2:]:  # bottom, top and back are hardly seen
        mesh.weigh(0.3)
    lid = (back, -half - 0.006, height - 0.022), (depth / 2 + 0.004, half + 0.006, height)
    asm.board("body", *lid, finish(wood, 1, offset), 0.004, segments=2, weight=1.2)
    if legs:
        for x in (back + 0.05, case_front - 0.04):
            for y in (-half + 0.06, half - 0.06):
                leg(asm, "body", (x, y), (x, y), (0, base), (0.015, 0.023), case, 10)
    else:
        kick = (back, -half + 0.015, 0), (case_front - 0.03, half - 0.015, base)
        asm.board("body", *kick, plain("#3f3d3a", 0.05, 10))
    z_low, z_high = base + 0.004, height - 0.026
    row = (z_high - z_low) / rows
    column = width / columns
    joints: dict[str, Joint] = {}
    settings: dict[str, dict] = {}
    states: list[dict] = []
    containers: list[Container] = []
    supports = [surface("top", (back, -half), (depth / 2, half), height)]
    stroke = round(0.6 * depth, 3)
    for c in range(1, columns):
        y = -half + c * column
        asm.board(
            "body", (back, y - t / 2, base + t), (case_front, y + t / 2, height - 0.04), inside
        )
    for r in range(1, rows):  # the rails between the rows, seen when a drawer is out
        z = z_high - r * row
        low, high = (case_front - 0.05, -half + t, z - 0.008), (case_front, half - t, z + 0.008)
        asm.board("body", low, high, case, solid=False)
    for k in range(rows * columns):
        r, c = divmod(k, columns)
        z0, z1 = z_high - (r + 1) * row + 0.002, z_high - r * row - 0.002
        y0, y1 = -half + c * column + 0.003, -half + (c + 1) * column - 0.003
        part = f"drawer_{moving.index(k) + 1}" if k in moving else "fronts"
        asm.board(part, (case_front, y0, z0), (depth / 2, y1, z1), face, 0.002, weight=1.2)
        _pulls(asm, part, depth / 2, (y0, y1), (z0 + z1) / 2, pulls, metal)
        if part == "fronts":
            # shaded on their own as the drawers are, or they would be darker than those
            settings[part] = {"occlusion": part}
            continue
        low = (back + 0.025, y0 + 0.028, z0 + 0.02)
        high = (case_front, y1 - 0.028, z0 + 0.78 * (z1 - z0))
        seen = len(asm.meshes[part])
        drawer_box(asm, part, low, high, inside)
        for mesh in asm.meshes[part][seen:]:  # the texture is for the fronts
            mesh.weigh(0.4)
        inner = (low[0] + 0.012, low[1] + 0.012), (high[0], high[1] - 0.012)
        room = z1 - 0.012 - low[2] - 0.008
        supports.append(surface(f"{part}_floor", *inner, low[2] + 0.008, room, part, part))
        center = tuple(np.add(low, high) / 2)
        size = tuple(np.subtract(high, low) - [0.012, 0.024, 0])
        containers.append(Container(part, center, size, part, part))
        joints[part] = Joint("prismatic", (0.0, (y0 + y1) / 2, z0), (1, 0, 0), 0.0, stroke)
        settings[part] = {"joint": part}
        states += open_closed(part, part, 0.01, 0.14)
    return Model(
        title=f"{'painted' if wood.startswith('#') else wood} dresser, {rows * columns} drawers",
        parts=asm.parts(**settings),
        mass=38.0 * width / 0.9,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def dresser_random(rng: np.random.Generator) -> dict:
    """Parameters of a random dresser."""
    wide = bool(rng.random() < 0.4)
    return {
        "width": round(float(rng.uniform(1.05, 1.2) if wide else rng.uniform(0.8, 0.95)), 2),
        "height": round(float(rng.uniform(0.76, 0.98)), 2),
        "depth": round(float(rng.uniform(0.43, 0.48)), 2),
        "rows": 3,
        "columns": 2 if wide else 1,
        "moving": (0, 1, 3) if wide else (0, 1, 2),
        "wood": pick(rng, ["oak", "walnut", "#eceae5"]),
        "legs": bool(rng.random() < 0.6),
        "pulls": pick(rng, ["bar", "knobs", "groove"]),
        "offset": noise_offset(rng),
    }


TOY_COLOURS = ("#d9534a", "#f0b429", "#4a90c4", "#5aa469", "#9b6bb3")


def _toy_front(width: float, height: float, ground: str) -> Material:
    """Letters and stars painted on the front."""
    picture, draw = labels.canvas(256, int(256 * height / width), ground)
    w, h = picture.size
    for i, letter in enumerate("TOYS"):
        x = w * (0.16 + 0.175 * i)
        labels.text(draw, letter, (x, h * 0.28, x + w * 0.15, h * 0.72), "bold", TOY_COLOURS[i])
    for i, (x, y) in enumerate(((0.08, 0.25), (0.9, 0.7), (0.1, 0.76), (0.92, 0.24), (0.5, 0.12))):
        points = []
        for k in range(10):
            r, a = (0.045 if k % 2 == 0 else 0.019) * w, math.pi * k / 5 - math.pi / 2
            points.append((w * x + r * math.cos(a), h * y + r * math.sin(a)))
        draw.polygon(points, fill=TOY_COLOURS[(i + 2) % 5])
    return label(picture)


def toy_box(
    width: float = 0.7,
    height: float = 0.44,
    depth: float = 0.42,
    wood: str = "#f2ead8",
    lid: str = "#4a90c4",
    letters: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A chest for toys; the lid is hinged to a fixed ledge at the back, where things may stand."""
    asm, half, t, foot = Assembly(), width / 2, 0.018, 0.02
    x0, x1, rim = -depth / 2, depth / 2 - 0.012, height - 0.022
    wall, cross = finish(wood, 2, offset), finish(wood, 1, offset)
    top = finish(lid, 1, offset)
    for x in (x0 + 0.02, x1 - 0.06):
        for y in (-half + 0.02, half - 0.06):
            asm.board("body", (x, y, 0), (x + 0.04, y + 0.04, foot + 0.002), top)
    asm.board("body", (x0, -half, foot), (x1, half, foot + t), cross, 0.002)
    for s in (-1, 1):
        low, high = sorted((s * half, s * (half - t)))
        asm.board("body", (x0, low, foot + t), (x1, high, rim), wall, 0.003)
        # a grip cut into each end
        grip = sorted((s * (half - 0.006), s * (half + 0.0015)))
        asm.board(
            "body",
            (-0.06, grip[0], rim - 0.11),
            (0.05, grip[1], rim - 0.075),
            plain("#4b4138", 0.05, 20),
            0.003,
            solid=False,
        )
    asm.board("body", (x0, -half + t, foot + t), (x0 + t, half - t, rim), cross, 0.002)
    front_mesh = box(
        t,
        width - 2 * t,
        rim - foot - t,
        (x1 - t / 2, 0, foot + t),
        cross,
        0,
        labels={"+x": _toy_front(width - 2 * t, rim - foot - t, wood)} if letters else None,
        weight=1.5 if letters else 1.0,
    )
    asm.add("body", front_mesh, solid=True)
    if not letters:
        for i, colour in enumerate(TOY_COLOURS):
            r = 0.045
            profile = [(0, 0), (r, 0), (r, 0.006), (r - 0.004, 0.01), (0, 0.01)]
            spot = lathe(profile, 18, mat=plain(colour, 0.02, 20)).turn(ry=np.pi / 2)
            y = (i - 2) * width * 0.17
            asm.add("body", spot.move(x1 - 0.001, y, rim * 0.5 + 0.035 * (-1) ** i))
    ledge = x0 + 0.15
    rest = (x0, -half - 0.008, rim), (ledge, half + 0.008, height)
    asm.board("body", *rest, top, 0.004)
    leaf = (ledge + 0.003, -half - 0.008, rim + 0.001), (depth / 2, half + 0.008, height)
    asm.board("lid", *leaf, top, 0.005, segments=2, weight=1.2)
    for y in (-width / 6, width / 6):  # and on it: nothing stands on what will tilt
        strip = (ledge + 0.003, y - 0.045, height - 0.001), (depth / 2, y + 0.045, height + 0.014)
        asm.board("lid", *strip, top, 0.004, solid=False)
    for y in (-half + 0.1, half - 0.1):  # battens under the lid
        low, high = (ledge + 0.03, y - 0.02, rim - 0.014), (x1 - 0.05, y + 0.02, rim + 0.002)
        asm.board("lid", low, high, top, solid=False)
    inner = (x0 + t, -half + t), (x1 - t, half - t)
    floor, room = foot + t, rim - foot - t
    center = ((x0 + x1) / 2, 0.0, floor + room / 2)
    return Model(
        title=f"{'painted' if letters else wood} toy box",
        parts=asm.parts(lid={"joint": "lid"}),
        mass=11.0,
        joints={"lid": Joint("revolute", (ledge + 0.003, 0.0, height), (0, -1, 0), 0.0, 1.4)},
        states=[
            {"state": "CLOSED", "joint": "lid", "max": 0.03, "parts": ["lid"]},
            {"state": "OPEN", "joint": "lid", "min": AJAR, "parts": ["lid"]},
        ],
        supports=[
            surface("top", (x0, -half), (ledge, half), height, margin=0.008),
            surface("floor", *inner, floor, room - 0.015, "inside"),
        ],
        containers=[
            Container(
                "inside", center, (x1 - x0 - 2 * t, width - 2 * t, room - 0.002), "body", "lid"
            )
        ],
        ground_shadow=True,
    )


def toy_box_random(rng: np.random.Generator) -> dict:
    """Parameters of a random toy box."""
    letters = bool(rng.random() < 0.5)
    return {
        "width": round(float(rng.uniform(0.62, 0.78)), 2),
        "height": round(float(rng.uniform(0.4, 0.48)), 2),
        "depth": round(float(rng.uniform(0.4, 0.46)), 2),
        "wood": pick(rng, ["#f2ead8", "#dcebe6"]) if letters else pick(rng, ["pine", "birch"]),
        "lid": pick(rng, ["#4a90c4", "#d9534a", "#5aa469"]),
        "letters": letters,
        "offset": noise_offset(rng),
    }


MODELS = {
    "dresser": extend(
        Maker(
            dresser,
            dresser_random,
            3,
            [
                {
                    "width": 0.9,
                    "height": 0.84,
                    "wood": "oak",
                    "rows": 3,
                    "columns": 1,
                    "moving": (0, 1, 2),
                    "legs": True,
                    "pulls": "bar",
                },
                {
                    "width": 1.18,
                    "height": 0.78,
                    "wood": "#eceae5",
                    "rows": 3,
                    "columns": 2,
                    "moving": (0, 1, 2, 3, 4, 5),
                    "legs": False,
                    "pulls": "knobs",
                },
                {
                    "width": 0.8,
                    "height": 0.98,
                    "wood": "walnut",
                    "fronts": "#dfe3dc",
                    "rows": 4,
                    "columns": 1,
                    "moving": (0, 1, 2, 3),
                    "legs": True,
                    "pulls": "groove",
                },
            ],
        ),
        DRESSERS,
    ),
    "toy_box": extend(
        Maker(
            toy_box,
            toy_box_random,
            2,
            [
                {"wood": "#f2ead8", "lid": "#4a90c4", "letters": True, "width": 0.72},
                {"wood": "pine", "lid": "#d9534a", "letters": False, "width": 0.66},
            ],
        ),
        TOY_BOXES,
    ),
}
