"""Chairs, sofas and armchairs."""

from __future__ import annotations

import numpy as np
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box

from .armchairs import ARMCHAIRS
from .designs import extend
from .joinery import Assembly, cushion, fabric, finish, leg, surface
from .sofas import SOFAS

Offset = tuple[float, float, float]


def chair(
    wood: str = "oak",
    seat: str | None = "#7a8a99",
    style: str = "slats",
    height: float = 0.86,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A dining chair; seat: colour of the cushion, None for a bare wooden seat.

    style: back of "slats" (upright), "rungs" (crosswise) or one "panel".
    """
    asm, timber, cross = Assembly(), finish(wood, 2, offset), finish(wood, 1, offset)
    w, d, seat_z, r = 0.43, 0.42, 0.45, 0.018
    lean = 0.07
    for y in (-w / 2 + r, w / 2 - r):
        leg(asm, "body", (d / 2 - r, y), (d / 2 - r, y), (0, seat_z - 0.03), (0.014, r), timber, 4)
        leg(
            asm, "body", (-d / 2 - 0.03 + r, y), (-d / 2 + r, y), (0, seat_z), (0.014, r), timber, 4
        )
        leg(
            asm,
            "body",
            (-d / 2 + r, y),
            (-d / 2 - lean + r, y),
            (seat_z, height),
            (r, 0.013),
            timber,
            4,
        )
        asm.board("body", (-d / 2 + r, y - 0.01, 0.2), (d / 2 - r, y + 0.01, 0.225), timber)
    for x in (-d / 2 + r, d / 2 - r):
        asm.board(
            "body",
            (x - 0.011, -w / 2 + r, seat_z - 0.085),
            (x + 0.011, w / 2 - r, seat_z - 0.025),
            cross,
        )
    for y in (-w / 2 + r, w / 2 - r):
        asm.board(
            "body",
            (-d / 2 + r, y - 0.011, seat_z - 0.085),
            (d / 2 - r, y + 0.011, seat_z - 0.025),
            timber,
        )
    asm.board(
        "body",
        (-d / 2 + 0.005, -w / 2, seat_z - 0.025),
        (d / 2 + 0.01, w / 2, seat_z),
        cross,
        0.008,
        segments=2,
    )
    top = seat_z
    if seat:
        asm.add(
            "body",
            cushion(
                (d - 0.04, w - 0.03, 0.035),
                (0.005, 0, seat_z),
                fabric(seat, offset),
                0.05,
                0.008,
                0.015,
            ),
        )
        asm.solid(
            "body",
            (-d / 2 + 0.025, -w / 2 + 0.015, seat_z),
            (d / 2 - 0.015, w / 2 - 0.015, seat_z + 0.04),
        )
        top = seat_z + 0.04

    def back_x(z: float) -> float:
        return -d / 2 + r - lean * (z - seat_z) / (height - seat_z)

    tilt = -np.arctan2(lean, height - seat_z)

    def slanted(size, y: float, z: float) -> None:
        """A board of the back, leaning as the posts do, its middle at height z."""
        mesh = box(*size, (0, 0, -size[2] / 2), timber if size[2] > size[1] else cross, 0.004)
        asm.add("body", mesh.turn(ry=tilt).move(back_x(z), y, z))

    inner = w - 3 * r
    slanted((0.02, w - 0.02, 0.075), 0, height - 0.035)
    if style == "slats":
        slanted((0.016, inner, 0.035), 0, seat_z + 0.12)
        for y in np.linspace(-inner / 2 + 0.045, inner / 2 - 0.045, 4):
            slanted((0.012, 0.03, height - seat_z - 0.17), y, (seat_z + 0.12 + height - 0.05) / 2)
    elif style == "rungs":
        for z in (seat_z + 0.12, seat_z + 0.22):
            slanted((0.016, inner, 0.05), 0, z)
    else:
        slanted((0.014, inner, height - seat_z - 0.2), 0, (seat_z + 0.16 + height - 0.06) / 2)
    low = np.array(
        [
            (back_x(z) + s, y, z)
            for z in (seat_z + 0.1, height)
            for s in (-0.012, 0.012)
            for y in (-inner / 2, inner / 2)
        ]
    )
    asm.piece("body", low)
    return Model(
        title=f"{wood} chair{' with a cushion' if seat else ''}",
        parts=asm.parts(),
        mass=5.0,
        supports=[
            surface("seat", (-d / 2 + 0.03, -w / 2 + 0.02), (d / 2 - 0.02, w / 2 - 0.02), top)
        ],
        ground_shadow=True,
    )


def chair_random(rng: np.random.Generator) -> dict:
    """Parameters of a random chair."""
    return {
        "wood": pick(rng, ["oak", "walnut", "#e8e6e0", "black"]),
        "seat": pick(rng, [None, "#7a8a99", "#a3644c", "#8d9a7b"]),
        "style": pick(rng, ["slats", "rungs", "panel"]),
        "height": round(float(rng.uniform(0.82, 0.94)), 2),
        "offset": noise_offset(rng),
    }


def upholstered_seat(
    seats: int = 3,
    seat_width: float = 0.62,
    depth: float = 0.88,
    colour: str = "#6f7f8c",
    arm: float = 0.16,
    arm_height: float = 0.6,
    back_height: float = 0.82,
    wood: str = "walnut",
    pillows: tuple[str, ...] = (),
    offset: Offset = (0, 0, 0),
) -> Model:
    """A sofa or, with one seat, an armchair: base, arms, back, loose cushions, short legs."""
    asm, cloth, timber = Assembly(), fabric(colour, offset), finish(wood, 2, offset)
    inner = seats * seat_width
    half, x0, x1 = inner / 2 + arm, -depth / 2, depth / 2
    foot, seat_base, seat_z, back = 0.11, 0.27, 0.43, 0.2
    asm.board(
        "body",
        (x0 + 0.02, -half + 0.03, foot),
        (x1 - 0.03, half - 0.03, seat_base + 0.03),
        cloth,
        0.012,
    )
    for side in (-1, 1):
        mesh = cushion(
            (depth - 0.01, arm, arm_height - foot - 0.02),
            (0, side * (half - arm / 2), foot),
            cloth,
            0.045,
            0.015,
            0.05,
        )
        asm.add("body", mesh, solid=True)
    rest = cushion(
        (back, inner + 0.02, back_height - foot - 0.03),
        (x0 + back / 2, 0, foot),
        cloth,
        0.04,
        0.02,
        0.06,
    )
    asm.add("body", rest, solid=True)
    for k in range(seats):
        y = -inner / 2 + (k + 0.5) * seat_width
        size = (depth - back - 0.005, seat_width - 0.008, seat_z - seat_base - 0.02)
        asm.add(
            "body",
            cushion(
                size, (x0 + back + size[0] / 2 + 0.012, y, seat_base), cloth, 0.05, 0.02, 0.045
            ),
            solid=True,
        )
        # the back cushion stands on the seat and leans on the back
        thick, tall = 0.15, back_height - seat_z + 0.01
        mesh = cushion((tall, seat_width - 0.02, thick - 0.03), (0, 0, 0), cloth, 0.07, 0.03, 0.05)
        mesh.turn(ry=np.pi / 2).turn(ry=-0.16).move(x0 + back - 0.015, y, seat_z + tall / 2 + 0.012)
        asm.add("body", mesh)
        asm.solid(
            "body",
            (x0 + back, y - seat_width / 2, seat_z),
            (x0 + back + 0.15, y + seat_width / 2, back_height),
        )
    for i, shade_of_pillow in enumerate(pillows):
        side = -1 if i % 2 == 0 else 1
        mesh = cushion(
            (0.40, 0.40, 0.07), (0, 0, 0), fabric(shade_of_pillow, offset, 0.06), 0.05, 0.035, 0.05
        )
        mesh.turn(ry=np.pi / 2 - 0.35, rz=0.0).turn(rz=-side * 0.35)
        mesh.move(x0 + back + 0.17, side * (inner / 2 - 0.2), seat_z + 0.2)
        asm.add("body", mesh)
    for x in (x0 + 0.07, x1 - 0.09):
        for y in (-half + 0.08, half - 0.08):
            leg(asm, "body", (x, y), (x, y), (0, foot + 0.01), (0.016, 0.026), timber)
    low, high = (x0 + back + 0.19, -inner / 2 + 0.04), (x1 - 0.06, inner / 2 - 0.04)
    name = "armchair" if seats == 1 else f"sofa for {seats}"
    return Model(
        title=name,
        parts=asm.parts(),
        mass=18.0 + 16 * seats,
        supports=[surface("seat", low, high, seat_z)],
        ground_shadow=True,
    )


def sofa_random(rng: np.random.Generator) -> dict:
    """Parameters of a random sofa."""
    return {
        "seats": int(rng.integers(2, 4)),
        "seat_width": round(float(rng.uniform(0.58, 0.68)), 2),
        "colour": pick(rng, ["#6f7f8c", "#8a7a68", "#5f6f5c", "#9a5b48", "#b9ad9b"]),
        "arm": round(float(rng.uniform(0.13, 0.2)), 2),
        "arm_height": round(float(rng.uniform(0.54, 0.64)), 2),
        "back_height": round(float(rng.uniform(0.76, 0.86)), 2),
        "wood": pick(rng, ["walnut", "oak", "black"]),
        "offset": noise_offset(rng),
    }


def armchair_random(rng: np.random.Generator) -> dict:
    """Parameters of a random armchair."""
    return {**sofa_random(rng), "seats": 1, "depth": round(float(rng.uniform(0.78, 0.86)), 2)}


MODELS = {
    "sofa": extend(
        Maker(
            upholstered_seat,
            sofa_random,
            3,
            [
                {"seats": 3, "colour": "#6f7f8c", "pillows": ("#d8a84e", "#e6ded0")},
                {"seats": 2, "colour": "#a89a86", "pillows": ("#5d7a78",)},
                {"seats": 3, "colour": "#5f6f5c", "pillows": ("#c98f5a", "#c98f5a")},
            ],
        ),
        SOFAS,
    ),
    "armchair": extend(
        Maker(
            upholstered_seat,
            armchair_random,
            2,
            [{"colour": "#b0563c", "wood": "oak"}, {"colour": "#5f7a6a", "pillows": ()}],
        ),
        ARMCHAIRS,
    ),
}
