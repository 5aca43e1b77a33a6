"""Tables: kitchen table, coffee table, desk, console table."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Maker, Model, Support, cylinder_piece, round_polygon
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe

from .casework import Case
from .designs import extend
from .desks import CONSOLES, DESKS
from .joinery import (
    Assembly,
    finish,
    leg,
    surface,
)
from .low_tables import COFFEE_TABLES

Offset = tuple[float, float, float]


def _four_legs(
    asm: Assembly,
    half: tuple[float, float],
    inset: float,
    z: float,
    radius: tuple[float, float],
    mat: Material,
    sides: int = 4,
    splay: float = 0.0,
) -> None:
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (half[0] - inset), sy * (half[1] - inset)
            leg(asm, "body", (x + sx * splay, y + sy * splay), (x, y), (0, z), radius, mat, sides)


def kitchen_table(
    length: float = 1.4,
    depth: float = 0.8,
    wood: str = "oak",
    legs: str | None = None,
    square: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Four legs, aprons and a board, long along y. legs: their finish, None: as the top."""
    asm, height, t = Assembly(), 0.75, 0.028
    hx, hy = depth / 2, length / 2
    top, frame = finish(wood, 1, offset), finish(legs or wood, 2, offset)
    asm.board("body", (-hx, -hy, height - t), (hx, hy, height), top, 0.005, segments=2, weight=1.3)
    inset, r = 0.07, 0.033
    _four_legs(asm, (hx, hy), inset, height - t, (0.022, r), frame, 4 if square else 10)
    low, high = height - t - 0.09, height - t
    for s in (-1, 1):
        y, x = s * (hy - inset), s * (hx - inset)
        asm.board("body", (-hx + inset, y - 0.011, low), (hx - inset, y + 0.011, high), frame)
        asm.board("body", (x - 0.011, -hy + inset, low), (x + 0.011, hy - inset, high), frame)
    return Model(
        title=f"{wood} kitchen table",
        parts=asm.parts(),
        mass=26.0,
        supports=[surface("top", (-hx, -hy), (hx, hy), height)],
        ground_shadow=True,
    )


def kitchen_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random kitchen table."""
    return {
        "length": round(float(rng.uniform(1.1, 1.6)), 2),
        "depth": round(float(rng.uniform(0.72, 0.85)), 2),
        "wood": pick(rng, ["oak", "walnut", "pine"]),
        "legs": pick(rng, [None, "#e8e6e0"]),
        "square": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


def coffee_table(
    length: float = 1.1,
    depth: float = 0.6,
    height: float = 0.42,
    wood: str = "walnut",
    shelf: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A low table, with or without a shelf under the top."""
    asm, t = Assembly(), 0.03
    hx, hy = depth / 2, length / 2
    top, frame = finish(wood, 1, offset), finish(wood, 2, offset)
    asm.board("body", (-hx, -hy, height - t), (hx, hy, height), top, 0.008, segments=2, weight=1.3)
    _four_legs(
        asm,
        (hx, hy),
        0.06,
        height - t,
        (0.018, 0.026),
        frame,
        4 if shelf else 10,
        0 if shelf else 0.03,
    )
    supports = [surface("top", (-hx, -hy), (hx, hy), height)]
    if shelf:
        z = 0.15
        low, high = (-hx + 0.045, -hy + 0.045), (hx - 0.045, hy - 0.045)
        asm.board("body", (*low, z - 0.018), (*high, z), top, 0.003)
        supports.append(surface("shelf_1", low, high, z, height - t - z, margin=0.05))
    return Model(
        title=f"{wood} coffee table{' with a shelf' if shelf else ''}",
        parts=asm.parts(),
        mass=14.0,
        supports=supports,
        ground_shadow=True,
    )


def coffee_table_round(
    radius: float = 0.42, height: float = 0.42, wood: str = "oak", offset: Offset = (0, 0, 0)
) -> Model:
    """A round low table on three splayed legs."""
    asm, t = Assembly(), 0.03
    z0 = height - t
    profile = [(0, z0), (radius - 0.02, z0), (radius, z0 + 0.014), (radius, height - 0.004)]
    profile += [(radius - 0.005, height), (0, height)]
    asm.add("body", lathe(profile, 36, mat=finish(wood, 1, offset), weight=1.3))
    asm.piece("body", cylinder_piece(radius, z0, height, 14))
    for k in range(3):
        a = 2 * np.pi * k / 3 + 0.3
        c, s = np.cos(a), np.sin(a)
        foot, head = (radius * 0.86 * c, radius * 0.86 * s), (radius * 0.6 * c, radius * 0.6 * s)
        leg(asm, "body", foot, head, (0, z0), (0.013, 0.022), finish(wood, 2, offset), 10)
    return Model(
        title=f"round {wood} coffee table",
        parts=asm.parts(),
        mass=11.0,
        supports=[Support("top", height, round_polygon(radius - 0.015, 14))],
        ground_shadow=True,
    )


def coffee_table_any(
    round_top: bool = False,
    length: float = 1.1,
    radius: float = 0.42,
    height: float = 0.42,
    wood: str = "walnut",
    shelf: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A rectangular or a round coffee table."""
    if round_top:
        return coffee_table_round(radius, height, wood, offset)
    return coffee_table(length, 0.55 * length, height, wood, shelf, offset)


def coffee_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random coffee table."""
    return {
        "round_top": bool(rng.random() < 0.35),
        "length": round(float(rng.uniform(0.95, 1.25)), 2),
        "radius": round(float(rng.uniform(0.36, 0.46)), 2),
        "height": round(float(rng.uniform(0.38, 0.46)), 2),
        "wood": pick(rng, ["walnut", "oak", "pine"]),
        "shelf": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


def desk(
    length: float = 1.2,
    depth: float = 0.6,
    wood: str = "oak",
    frame: str = "#f0efec",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A writing desk: legs on the left, a pedestal with a drawer that opens on the right."""
    asm, height, t = Assembly(), 0.74, 0.026
    hx, hy = depth / 2, length / 2
    top, paint = finish(wood, 1, offset), finish(frame, 2, offset)
    asm.board("body", (-hx, -hy, height - t), (hx, hy, height), top, 0.004, segments=2, weight=1.3)
    for x in (-hx + 0.04, hx - 0.05):
        leg(asm, "body", (x, -hy + 0.05), (x, -hy + 0.05), (0, height - t), (0.02, 0.024), paint, 4)
    low, high = height - t - 0.07, height - t
    asm.board("body", (-hx + 0.03, -hy + 0.05, low), (-hx + 0.05, hy - 0.05, high), paint)
    asm.board("body", (-hx + 0.04, -hy + 0.04, low), (hx - 0.05, -hy + 0.06, high), paint)
    # pedestal
    y0, y1, x0, x1, z1 = hy - 0.42, hy - 0.03, -hx + 0.04, hx - 0.045, height - t
    for y in (y0, y1 - 0.018):
        asm.board("body", (x0, y, 0.05), (x1, y + 0.018, z1), paint, 0.002)
    asm.board("body", (x0, y0 + 0.018, 0.05), (x0 + 0.01, y1 - 0.018, z1), paint)
    asm.board(
        "body", (x0 + 0.03, y0 + 0.02, 0), (x1 - 0.05, y1 - 0.02, 0.068), plain("#3a3a3a", 0.04, 8)
    )
    drawer_low = z1 - 0.15
    asm.board(
        "body", (x0 + 0.01, y0 + 0.018, drawer_low - 0.018), (x1, y1 - 0.018, drawer_low), paint
    )
    case = Case(wood, frame, "birch", "bar", offset=offset)
    case.asm = asm
    spans = ((drawer_low + 0.002, z1 - 0.004), (0.314, drawer_low - 0.002), (0.07, 0.31))
    for name, z in zip(("drawer", "drawer_2", "drawer_3"), spans, strict=True):
        case.drawer(name, (x0 + 0.01, x1), (y0, y1), z, 0.34, 0.018)
    asm.board("body", (x0 + 0.01, y0 + 0.018, 0.05), (x1, y1 - 0.018, 0.066), paint)
    return Model(
        title=f"desk with {wood} top and drawers",
        parts=asm.parts(**case.settings),
        mass=31.0,
        joints=case.joints,
        states=case.states,
        supports=[surface("top", (-hx, -hy), (hx, hy), height), *case.supports],
        containers=case.containers,
        ground_shadow=True,
    )


def desk_random(rng: np.random.Generator) -> dict:
    """Parameters of a random desk."""
    return {
        "length": round(float(rng.uniform(1.1, 1.4)), 2),
        "depth": round(float(rng.uniform(0.56, 0.65)), 2),
        "wood": pick(rng, ["oak", "walnut", "birch"]),
        "frame": pick(rng, ["#f0efec", "#3d4043", "oak"]),
        "offset": noise_offset(rng),
    }


def console_table(
    length: float = 1.0,
    depth: float = 0.32,
    wood: str = "walnut",
    shelf: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A narrow hall table, a pair of drawers under the top, and a shelf low down if wanted."""
    asm, height, t = Assembly(), 0.8, 0.024
    hx, hy = depth / 2, length / 2
    top, frame = finish(wood, 1, offset), finish(wood, 2, offset)
    asm.board("body", (-hx, -hy, height - t), (hx, hy, height), top, 0.004, segments=2, weight=1.2)
    _four_legs(asm, (hx, hy), 0.04, height - t, (0.015, 0.022), frame)
    supports = [surface("top", (-hx, -hy), (hx, hy), height)]
    low, x = height - t - 0.13, (-hx + 0.03, hx - 0.045)
    case = Case(wood, None, "birch", "knob", offset=offset)
    case.asm = asm
    case.carcass(x, (-hy + 0.05, hy - 0.05), (low, height - t))
    for k, y in enumerate(((-hy + 0.06, 0.0), (0.0, hy - 0.06))):
        case.drawer(f"drawer_{k + 1}", x, y, (low, height - t), thick=0.018)
    supports += case.supports
    if shelf:
        z = 0.18
        a, b = (-hx + 0.03, -hy + 0.03), (hx - 0.03, hy - 0.03)
        asm.board("body", (*a, z - 0.018), (*b, z), top, 0.002)
        supports.append(surface("shelf_1", a, b, z, low - z, margin=0.04))
    return Model(
        title=f"{wood} console table",
        parts=asm.parts(**case.settings),
        mass=15.0,
        joints=case.joints,
        states=case.states,
        containers=case.containers,
        supports=supports,
        ground_shadow=True,
    )


def console_table_random(rng: np.random.Generator) -> dict:
    """Parameters of a random console table."""
    return {
        "length": round(float(rng.uniform(0.85, 1.15)), 2),
        "depth": round(float(rng.uniform(0.3, 0.36)), 2),
        "wood": pick(rng, ["walnut", "oak", "#e8e5de"]),
        "shelf": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


MODELS = {
    "coffee_table": extend(
        Maker(
            coffee_table_any,
            coffee_table_random,
            3,
            [
                {"round_top": False, "wood": "walnut", "shelf": True, "length": 1.1},
                {"round_top": False, "wood": "oak", "shelf": False, "length": 1.0},
                {"round_top": True, "wood": "oak"},
            ],
        ),
        COFFEE_TABLES,
    ),
    "desk": extend(
        Maker(
            desk,
            desk_random,
            2,
            [{"wood": "oak", "frame": "#f0efec"}, {"wood": "walnut", "frame": "#3d4043"}],
        ),
        DESKS,
    ),
    "console_table": extend(
        Maker(
            console_table,
            console_table_random,
            2,
            [{"wood": "walnut", "shelf": True}, {"wood": "#e8e5de", "shelf": False}],
        ),
        CONSOLES,
    ),
}
