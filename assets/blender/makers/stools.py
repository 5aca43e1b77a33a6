"""Benches, stools and step stools."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Maker, Model, Support, cylinder_piece, prism_piece, round_polygon
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import extrude, lathe, loft, rounded_rectangle, tube

from .bench_forms import BENCHES, STEP_STOOLS
from .designs import extend
from .joinery import Assembly, cushion, fabric, finish, leg, surface
from .stool_forms import STOOLS

Offset = tuple[float, float, float]


def bench(
    length: float = 1.1,
    depth: float = 0.36,
    height: float = 0.45,
    wood: str = "oak",
    pad: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A bench without a back: a slatted seat and a slatted shelf, or a `pad` (its colour)."""
    asm, hx, hy = Assembly(), depth / 2, length / 2
    along, upright, cross = (finish(wood, axis, offset) for axis in (1, 2, 0))
    seat = height - (0.055 if pad else 0.0)
    z = seat - 0.026
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (hx - 0.045), sy * (hy - 0.09)
            foot = (x + sx * 0.02, y + sy * 0.03) if pad else (x, y)
            leg(asm, "body", foot, (x, y), (0, z), (0.018, 0.026), upright, 10 if pad else 4)
    supports = []
    if pad:
        asm.board("body", (-hx + 0.01, -hy + 0.01, z), (hx - 0.01, hy - 0.01, seat), along, 0.004)
        cloth = fabric(pad, offset)
        cover = cushion(
            (depth, length, height - seat - 0.008), (0, 0, seat), cloth, 0.04, 0.008, 0.02
        )
        asm.add("body", cover)
        asm.solid("body", (-hx + 0.01, -hy + 0.01, seat), (hx - 0.01, hy - 0.01, height + 0.002))
        for x in (-hx + 0.045, hx - 0.045):
            asm.board("body", (x - 0.01, -hy + 0.09, z - 0.05), (x + 0.01, hy - 0.09, z), along)
    else:
        for level, slats, inset in ((seat, 4, 0.0), (0.15, 4, 0.03)):
            wide = (depth - 2 * inset) / slats
            for k in range(slats):
                a = -hx + inset + k * wide
                low, high = (
                    (a + 0.004, -hy + inset, level - 0.022),
                    (a + wide - 0.004, hy - inset, level),
                )
                asm.board("body", low, high, along, 0.003)
        for y in (-hy + 0.09, hy - 0.09):
            for z1 in (seat - 0.022, 0.128):
                asm.board(
                    "body", (-hx + 0.03, y - 0.012, z1 - 0.04), (hx - 0.03, y + 0.012, z1), cross
                )
        low, high = (-hx + 0.03, -hy + 0.12), (hx - 0.03, hy - 0.12)
        supports.append(surface("shelf_1", low, high, 0.15, seat - 0.07 - 0.15))
    supports.insert(0, surface("top", (-hx, -hy), (hx, hy), height, margin=0.02))
    return Model(
        title=f"{wood} bench{' with a padded seat' if pad else ' with slats and a shelf'}",
        parts=asm.parts(),
        mass=10.0 * length,
        supports=supports,
        ground_shadow=True,
    )


def bench_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bench."""
    return {
        "length": round(float(rng.uniform(0.95, 1.25)), 2),
        "depth": round(float(rng.uniform(0.35, 0.4)), 2),
        "height": round(float(rng.uniform(0.43, 0.48)), 2),
        "wood": pick(rng, ["oak", "walnut", "birch"]),
        "pad": pick(rng, [None, "#6d8077", "#a9705a"]),
        "offset": noise_offset(rng),
    }


def stool(
    height: float = 0.46,
    width: float = 0.33,
    wood: str = "birch",
    pad: str | None = None,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A round stool on four splayed legs with rungs; a `pad` (its colour) makes a bar stool."""
    asm, r, top = Assembly(), width / 2, finish(wood, 1, offset)
    upright = plain("#2d2f31", 0.05, 20) if pad else finish(wood, 2, offset)
    t = 0.03
    z, seat_r = height - t, 0.92 * r
    if pad:
        cloth = fabric(pad, offset)
        z = height - 0.06
        profile = [(0, z), (seat_r - 0.01, z), (seat_r, z + 0.012), (seat_r, z + 0.038)]
        profile += [(seat_r - 0.015, height - 0.006), (0.6 * seat_r, height), (0, height)]
        asm.add("body", lathe(profile, 24, mat=cloth, weight=1.2))
    else:
        profile = [(0, z), (seat_r - 0.012, z), (seat_r, z + 0.012), (seat_r, height - 0.005)]
        profile += [(seat_r - 0.008, height), (0.7 * seat_r, height - 0.004), (0, height - 0.006)]
        asm.add("body", lathe(profile, 28, mat=top, weight=1.3))
    asm.piece("body", cylinder_piece(seat_r, z, height - (0.0 if pad else 0.004), 14))
    feet = []
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        foot, head = (1.32 * r * c, 1.32 * r * s), (0.66 * r * c, 0.66 * r * s)
        thick = (0.011, 0.012) if pad else (0.012, 0.018)
        leg(asm, "body", foot, head, (0, z), thick, upright, 8)
        feet.append((np.array(foot), np.array(head)))
    rung_z = 0.36 * height if pad else 0.4 * height

    def at(k: int, height_: float) -> tuple[float, float, float]:
        foot, head = feet[k % 4]
        x, y = foot + (head - foot) * height_ / z
        return (float(x), float(y), height_)

    for k in range(4):
        level = rung_z if pad or k % 2 == 0 else rung_z + 0.05
        rung = tube([at(k, level), at(k + 1, level)], 0.009, 6, mat=upright)
        asm.add("body", rung)
    return Model(
        title=f"bar stool, {height:.2f} m" if pad else f"{wood} stool",
        parts=asm.parts(),
        mass=5.5 if pad else 3.5,
        supports=[
            Support("seat", height - (0 if pad else 0.004), round_polygon(seat_r - 0.02, 14))
        ],
        ground_shadow=True,
    )


def stool_random(rng: np.random.Generator) -> dict:
    """Parameters of a random stool."""
    high = bool(rng.random() < 0.4)
    return {
        "height": round(float(rng.uniform(0.6, 0.65) if high else rng.uniform(0.44, 0.48)), 2),
        "width": round(float(rng.uniform(0.32, 0.36)), 2),
        "wood": pick(rng, ["birch", "oak", "#d8d5cc"]),
        "pad": pick(rng, ["#8c4f3d", "#40505c"]) if high else None,
        "offset": noise_offset(rng),
    }


def step_stool(
    steps: int = 1,
    colour: str = "#5aa9a0",
    accent: str = "#f3f1ea",
    offset: Offset = (0, 0, 0),
) -> Model:
    """One step of moulded plastic with a ribbed tread, or two steps of wood."""
    asm = Assembly()
    if steps == 1:
        sx, sy, height = 0.3, 0.36, 0.22
        shell, rib = plain(colour, 0.03, 9, offset), plain(accent, 0.03, 20)
        rings = [
            np.c_[rounded_rectangle(sx + grow, sy + grow, 0.05, 4), np.full(16, z)]
            for grow, z in (
                (0.012, height - 0.05),
                (0.014, height - 0.02),
                (0.008, height - 0.008),
                (-0.006, height - 0.002),
            )
        ]
        asm.add("body", loft(rings, shell))
        outline = rounded_rectangle(sx + 0.01, sy + 0.01, 0.05, 2)
        asm.piece("body", prism_piece(outline, height - 0.05, height))
        for s in (-1, 1):
            for e in (-1, 1):  # four broad feet at the corners, flaring downwards
                foot, head = np.array([s * sx / 2, e * sy / 2]), np.array([s * sx / 2, e * sy / 2])
                foot, head = foot - [s * 0.005, e * 0.01], head - [s * 0.045, e * 0.05]
                rings = [
                    np.c_[rounded_rectangle(a, b, 0.02, 3) + at, np.full(12, z)]
                    for a, b, at, z in (
                        (0.075, 0.085, foot, 0.0),
                        (0.08, 0.1, head, height - 0.045),
                    )
                ]
                asm.add("body", loft(rings, shell))
                asm.piece("body", np.concatenate([ring[::2] for ring in rings]))
        for x in np.linspace(-0.1, 0.1, 5):  # non-slip ribs
            low = (x - 0.008, -sy / 2 + 0.05, height - 0.004)
            asm.board(
                "body", low, (x + 0.008, sy / 2 - 0.05, height + 0.001), rib, 0.001, solid=False
            )
        supports = [
            surface("top", (-sx / 2, -sy / 2), (sx / 2, sy / 2), height + 0.001, margin=0.03)
        ]
        title, mass = "plastic step stool, one step", 1.4
    else:
        sy, depth, low_z, height, t = 0.4, 0.4, 0.22, 0.43, 0.022
        side, board = finish(colour, 2, offset), finish(accent, 1, offset)
        x0, x1, mid = -depth / 2, depth / 2, -0.01
        outline = [(x0, 0), (x0 + 0.05, 0), (x0 + 0.09, 0.1), (x1 - 0.13, 0.1), (x1 - 0.06, 0)]
        outline += [(x1, 0), (x1 - 0.02, low_z - t), (mid, low_z - t), (mid, height - t)]
        outline += [(x0 + 0.02, height - t)]
        for s in (-1, 1):
            y = s * (sy / 2 - t)
            panel = extrude(outline, 0.02, side, axis="y").move(0, y, 0)
            asm.add("body", panel)
            for low, high in (
                ((x0, 0), (x0 + 0.07, height - t)),
                ((x0 + 0.07, 0.1), (mid, height - t)),
                ((mid, 0.1), (x1 - 0.06, low_z - t)),
                ((x1 - 0.06, 0), (x1, low_z - t)),
            ):
                asm.solid("body", (low[0], y - 0.01, low[1]), (high[0], y + 0.01, high[1]))
        upper = (x0, -sy / 2, height - t), (mid + 0.02, sy / 2, height)
        lower = (mid - 0.02, -sy / 2 + 0.03, low_z - t), (x1, sy / 2 - 0.03, low_z)
        asm.board("body", *upper, board, 0.004, segments=2, weight=1.2)
        asm.board("body", *lower, board, 0.004, segments=2, weight=1.2)
        brace = (x0 + 0.03, -sy / 2 + 0.03, 0.14), (x0 + 0.045, sy / 2 - 0.03, 0.2)
        asm.board("body", *brace, board)
        supports = [
            surface("top", (x0, -sy / 2), (mid + 0.02, sy / 2), height),
            surface("step", (mid + 0.02, -sy / 2 + 0.03), (x1, sy / 2 - 0.03), low_z),
        ]
        title, mass = "wooden step stool, two steps", 3.4
    return Model(
        title=title,
        parts=asm.parts(),
        mass=mass,
        supports=supports,
        texture_size=128 if steps == 1 else 256,
    )


def step_stool_random(rng: np.random.Generator) -> dict:
    """Parameters of a random step stool."""
    wooden = bool(rng.random() < 0.5)
    return {
        "steps": 2 if wooden else 1,
        "colour": pick(rng, ["birch", "#7fa6b8"]) if wooden else pick(rng, ["#5aa9a0", "#e07a5f"]),
        "accent": pick(rng, ["birch", "oak"]) if wooden else "#f3f1ea",
        "offset": noise_offset(rng),
    }


MODELS = {
    "bench": extend(
        Maker(
            bench,
            bench_random,
            2,
            [
                {"wood": "oak", "pad": None, "length": 1.0, "depth": 0.36, "height": 0.46},
                {"wood": "walnut", "pad": "#6d8077", "length": 1.2, "depth": 0.4, "height": 0.47},
            ],
        ),
        BENCHES,
    ),
    "stool": extend(
        Maker(
            stool,
            stool_random,
            2,
            [
                {"height": 0.46, "wood": "birch", "pad": None, "width": 0.35},
                {"height": 0.64, "wood": "oak", "pad": "#8c4f3d", "width": 0.34},
            ],
        ),
        STOOLS,
    ),
    "step_stool": extend(
        Maker(
            step_stool,
            step_stool_random,
            2,
            [
                {"steps": 1, "colour": "#5aa9a0", "accent": "#f3f1ea"},
                {"steps": 2, "colour": "#7fa6b8", "accent": "birch"},
            ],
        ),
        STEP_STOOLS,
    ),
}
