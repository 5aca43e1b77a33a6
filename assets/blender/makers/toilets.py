"""Toilets: close-coupled, skirted, hung on the wall, and an old one; the lid is on a joint."""

from __future__ import annotations

import numpy as np
from toolkit.materials import plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe, loft, tube

from .bathroom import _ceramic as ceramic
from .bathroom import _egg as egg
from .joinery import Assembly, open_closed, steel, surface

Offset = tuple[float, float, float]
CENTRE = 0.08
# outlines from the floor up: (length, width, z, x of the middle)
OUTSIDES = {
    "close": [
        (0.34, 0.22, 0, 0),
        (0.33, 0.21, 0.02, 0),
        (0.3, 0.19, 0.12, 0),
        (0.36, 0.26, 0.24, 0.04),
    ],
    "skirted": [(0.56, 0.34, 0, -0.02), (0.57, 0.345, 0.05, -0.02), (0.6, 0.355, 0.25, 0.0)],
    "hung": [(0.2, 0.16, 0.11, 0.0), (0.36, 0.28, 0.17, 0.04), (0.45, 0.34, 0.27, 0.07)],
    "old": [(0.32, 0.24, 0, 0), (0.3, 0.2, 0.03, 0), (0.2, 0.15, 0.1, 0), (0.24, 0.17, 0.2, 0.03)],
}


def _ring(length: float, width: float, z: float, x: float = CENTRE, n: int = 20) -> np.ndarray:
    outline = egg(length, width, n)
    return np.c_[np.add(outline, [x, 0]), np.full(len(outline), z)]


def _cistern(asm: Assembly, style: str, button: bool, china, metal, seat) -> float:
    """What holds the water; returns the height of its top."""
    if style in ("close", "skirted"):
        low = 0.39 if style == "close" else 0.02
        asm.board("body", (-0.345, -0.19, low), (-0.175, 0.19, 0.74), china, 0.02, segments=2)
        asm.board("body", (-0.352, -0.2, 0.74), (-0.168, 0.2, 0.775), china, 0.012, segments=2)
        if style == "close":
            asm.board("body", (-0.33, -0.11, 0.02), (-0.1, 0.11, 0.395), china, 0.02, segments=2)
        top = 0.775
        if button:
            knob = [
                (0, top),
                (0.026, top),
                (0.026, top + 0.007),
                (0.02, top + 0.011),
                (0, top + 0.011),
            ]
            asm.add("body", lathe(knob, 12, mat=metal).move(-0.26, 0, 0))
        else:
            lever = [(-0.172, -0.13, 0.69), (-0.155, -0.13, 0.69), (-0.15, -0.07, 0.685)]
            asm.add("body", tube(lever, 0.008, 6, mat=metal))
    elif (
        style == "hung"
    ):  # a narrow cistern down to the floor, of glass, with the flush plate on it
        asm.board("body", (-0.35, -0.24, 0), (-0.165, 0.24, 1.0), metal, 0.004)
        asm.board("body", (-0.168, -0.24, 0.004), (-0.16, 0.24, 1.0), china, 0.003)
        asm.board("body", (-0.352, -0.242, 1.0), (-0.158, 0.242, 1.022), china, 0.004)
        asm.board("body", (-0.16, -0.12, 0.82), (-0.148, 0.12, 0.96), metal, 0.004, solid=False)
        for y in (-0.055, 0.055):
            asm.board(
                "body",
                (-0.15, y - 0.045, 0.84),
                (-0.142, y + 0.045, 0.94),
                china,
                0.003,
                solid=False,
            )
        top = 1.022
    else:
        asm.board("body", (-0.345, -0.24, 0.55), (-0.17, 0.24, 0.93), china, 0.025, segments=2)
        asm.board("body", (-0.352, -0.25, 0.93), (-0.162, 0.25, 0.955), seat, 0.008, segments=2)
        pipe = [(-0.25, 0, 0.56), (-0.25, 0, 0.36), (-0.22, 0, 0.31), (-0.1, 0, 0.3)]
        asm.add("body", tube(pipe, 0.024, 8, mat=metal))
        asm.solid("body", (-0.275, -0.025, 0.3), (-0.225, 0.025, 0.55))
        chain = [(-0.26, 0.245, 0.88), (-0.22, 0.262, 0.88), (-0.16, 0.262, 0.86)]
        asm.add("body", tube(chain, 0.009, 6, mat=metal))
        top = 0.955
    return top


def toilet(
    style: str = "close", lid: str = "#f6f6f4", button: bool = True, offset: Offset = (0, 0, 0)
) -> Model:
    """OPEN: the lid is up. lid: colour of seat and lid."""
    asm, china, metal = Assembly(), ceramic(offset), steel(30)
    rings = [_ring(*r) for r in OUTSIDES[style]]
    rings += [_ring(0.47, 0.36, 0.36), _ring(0.48, 0.37, 0.39), _ring(0.47, 0.36, 0.40)]
    rings += [_ring(0.36, 0.27, 0.40), _ring(0.33, 0.24, 0.36), _ring(0.24, 0.17, 0.26)]
    rings.append(_ring(0.14, 0.11, 0.225 if style != "hung" else 0.235))
    asm.add("body", loft(rings, china))
    water = [(0, 0.24), (0.09, 0.24), (0.09, 0.246), (0, 0.246)]
    mesh = lathe(water, 14, mat=plain("#bcd6dd", 0.05, 30))
    asm.add("body", mesh.scale(1, 0.75, 1).move(CENTRE, 0, 0))
    seat = plain(lid, 0.012, 8)
    layers = []
    for (length, width), z in (
        ((0.46, 0.37), 0.403),
        ((0.46, 0.37), 0.418),
        ((0.3, 0.22), 0.42),
        ((0.3, 0.22), 0.403),
    ):
        layers.append(_ring(length, width, z))
    asm.add("body", loft([*layers, layers[0]], seat, caps=(False, False)).outward())
    shut = [
        _ring(0.45, 0.37, 0.422),
        _ring(0.45, 0.37, 0.434),
        _ring(0.4, 0.32, 0.444),
        _ring(0.2, 0.16, 0.448),
    ]
    asm.add("lid", loft(shut, seat), solid=True)
    for y in (-0.07, 0.07):
        asm.add("body", box(0.03, 0.035, 0.018, (-0.155, y, 0.402), metal, 0.003))
    top = _cistern(asm, style, button, china, metal, seat)
    # collision: foot, and the rim as eight pieces round the hollow
    base = {"skirted": (0.28, 0.17), "hung": (0.1, 0.08)}.get(style, (0.16, 0.11))
    asm.solid("body", (-base[0] + 0.02, -base[1], 0.12 if style == "hung" else 0), (*base, 0.2))
    outside, inside = egg(0.48, 0.37, 8), egg(0.30, 0.22, 8)
    for k in range(8):
        j = (k + 1) % 8
        quad = [outside[k], outside[j], inside[j], inside[k]]
        asm.piece("body", np.array([(q[0] + CENTRE, q[1], z) for q in quad for z in (0.2, 0.42)]))
    names = {
        "close": "close-coupled toilet",
        "skirted": "skirted toilet",
        "hung": "wall-hung toilet before a narrow cistern",
        "old": "old-fashioned toilet, low-level cistern",
    }
    wide = {"hung": 0.23, "old": 0.24}.get(style, 0.2)
    tops = surface(
        "top",
        (-0.35, (0.03 if style in ("close", "skirted") else -wide)),
        (-0.165, wide),
        top,
    )
    finish_ = "" if lid.startswith("#f") else ", wooden seat"
    return Model(
        title=names[style] + finish_,
        parts=asm.parts(lid={"joint": "lid"}),
        mass=32.0 if style != "hung" else 45.0,
        joints={
            "lid": Joint(
                "revolute",
                (-0.145, 0, 0.424),
                (0, -1, 0),
                0.0,
                1.4 if style in ("hung", "old") else 1.6,
            )
        },
        states=open_closed("lid", "lid"),
        supports=[tops],
        containers=[Container("bowl", (CENTRE, 0, 0.32), (0.26, 0.18, 0.16), "body", "lid")],
        ground_shadow=True,
    )


def toilet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random toilet."""
    return {
        "style": pick(rng, sorted(OUTSIDES)),
        "lid": pick(rng, ["#f6f6f4", "#f6f6f4", "#b98a56"]),
        "button": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


WOOD = "#9a6a3c"
MODELS = {
    "toilet": Maker(
        toilet,
        toilet_random,
        7,
        [
            {"style": "close", "lid": "#f6f6f4", "button": True},
            {"style": "close", "lid": "#b98a56", "button": False},
            {"style": "skirted", "lid": "#f6f6f4", "button": True},
            {"style": "hung", "lid": "#f6f6f4"},
            {"style": "hung", "lid": "#2c2e31"},
            {"style": "old", "lid": WOOD},
            {"style": "old", "lid": "#f6f6f4"},
        ],
    ),
}
