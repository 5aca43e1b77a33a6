"""Ottomans and poufs."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.model import (
    Container,
    Joint,
    Maker,
    Model,
    Support,
    cylinder_piece,
    round_polygon,
)
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, lathe

from .casework import metal_or
from .designs import designed
from .joinery import AJAR, Assembly, cushion, fabric, finish, leg, surface

Offset = tuple[float, float, float]


def quilted(colour: str, step: float = 0.12, offset: Offset = (0, 0, 0)) -> Material:
    """Upholstery buttoned down in diamonds, painted on: seams dark, fields light."""
    m = Material()
    fields = []
    for sign in ("ADD", "SUBTRACT"):
        across = m.math(sign, m.axis(1), m.math("ADD", m.axis(0), m.axis(2)))
        phase = m.math("FRACT", m.math("MULTIPLY", across, 1.0 / step))
        fields.append(m.math("ABSOLUTE", m.math("SUBTRACT", phase, 0.5)))
    edge = m.math("MAXIMUM", *fields)
    seam = m.remap(edge, 0.38, 0.5, 0, 0.75)
    body = m.mottle(colour, 0.08, 30, offset)
    return m.colour(m.mix(seam, body, shade(colour, 0.5)))


def buttons(asm: Assembly, spots, colour: str, r: float = 0.012) -> None:
    """Covered buttons at points."""
    mat = plain(shade(colour, 0.7), 0.05, 20)
    for p in spots:
        asm.add("body", ellipsoid((r, r, 0.6 * r), p, 7, 4, mat))


def ottoman_cube(
    width: float = 0.42, depth: float = 0.42, height: float = 0.42, colour: str = "#6f7f8c",
    lid: str | None = None, buttoned: bool = False, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A box covered in cloth; the padded lid is hinged at the back and opens on a hollow."""
    asm, hx, hy, t = Assembly(), depth / 2, width / 2, 0.02
    cloth, inner = fabric(colour, offset), plain("#3c3835", 0.05, 20)
    top = quilted(lid or colour, 0.14, offset) if buttoned else fabric(lid or colour, offset)
    rim = height - 0.1
    for x in (-hx + 0.03, hx - 0.07):
        for y in (-hy + 0.03, hy - 0.07):
            asm.board("body", (x, y, 0), (x + 0.04, y + 0.04, 0.022), plain("#242424", 0.04, 9))
    asm.board("body", (-hx, -hy, 0.02), (hx, hy, 0.04), cloth, 0.004, {"+z": inner})
    for s in (-1, 1):
        y = sorted((s * hy, s * (hy - t)))
        side = {"-y" if s > 0 else "+y": inner}
        asm.board("body", (-hx, y[0], 0.04), (hx, y[1], rim), cloth, 0.006, side)
        x = sorted((s * hx, s * (hx - t)))
        side = {"-x" if s > 0 else "+x": inner}
        asm.board("body", (x[0], -hy + t, 0.04), (x[1], hy - t, rim), cloth, 0.0, side)
    asm.add(
        "lid",
        cushion((depth + 0.012, width + 0.012, 0.088), (0, 0, rim + 0.002), top, 0.03, 0.012, 0.02),
    )
    asm.solid("lid", (-hx, -hy, rim + 0.002), (hx, hy, height))
    if buttoned:
        mat = plain(shade(lid or colour, 0.6), 0.05, 20)
        for x in np.arange(-hx + 0.14, hx - 0.1, 0.14):
            for y in np.arange(-hy + 0.14, hy - 0.1, 0.14):
                asm.add("lid", ellipsoid((0.012, 0.012, 0.008), (x, y, height + 0.001), 7, 4, mat))
    room = rim - 0.04
    supports = [
        surface("top", (-hx, -hy), (hx, hy), height + 0.003, part="lid", margin=0.04),
        surface("floor", (-hx + t, -hy + t), (hx - t, hy - t), 0.04, room - 0.01, "inside"),
    ]
    center, size = (0.0, 0.0, 0.04 + room / 2), (depth - 2 * t, width - 2 * t, room - 0.002)
    return Model(
        "storage ottoman with a lid",
        asm.parts(lid={"joint": "lid"}),
        6.0 + 6 * width * depth,
        joints={"lid": Joint("revolute", (-hx, 0.0, rim + 0.002), (0, -1, 0), 0.0, 1.4)},
        states=[
            {"state": "CLOSED", "joint": "lid", "max": 0.03, "parts": ["lid"]},
            {"state": "OPEN", "joint": "lid", "min": AJAR, "parts": ["lid"]},
        ],
        supports=[supports[1]],
        containers=[Container("inside", center, size, "body", "lid")],
        ground_shadow=True,
    )


def ottoman_drum(
    radius: float = 0.27, height: float = 0.4, colour: str = "#a8566a", wood: str = "brass",
    offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A round velvet one, pleated all round, on a metal plinth."""
    asm, r = Assembly(), radius
    asm.add(
        "body", lathe([(0, 0), (r - 0.02, 0), (r - 0.02, 0.03), (0, 0.03)], 26, mat=metal_or(wood))
    )
    wall = [(0, 0.03), (r - 0.01, 0.03), (r, 0.05), (r, height - 0.1), (r - 0.006, height - 0.095)]
    mat = fabric(colour, offset, 0.06)
    asm.add(
        "body",
        lathe([*wall, (0, height - 0.095)], 48, mat=mat, rib=lambda k, i: 1 if i % 2 else 0.96),
    )
    lid = [
        (0, height - 0.095),
        (r + 0.004, height - 0.095),
        (r + 0.012, height - 0.08),
        (r + 0.01, height - 0.02),
    ]
    lid += [(r - 0.02, height), (0.5 * r, height + 0.008), (0, height + 0.002)]
    asm.add("body", lathe(lid, 28, mat=mat, weight=1.2))
    buttons(asm, [(0, 0, height + 0.004)], colour, 0.018)
    asm.piece("body", cylinder_piece(r, 0, height + 0.004, 14))
    top = Support("top", height + 0.006, round_polygon(r - 0.03, 14))
    return Model("round ottoman of velvet", asm.parts(), 6.5, supports=[top], ground_shadow=True)


def pouf(
    radius: float = 0.26, height: float = 0.34, colour: str = "#d8cfc0", style: str = "knit",
    second: str = "#8a4a2c", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A stuffed cushion for the floor: "knit" in thick stitches, or "leather" in segments."""
    asm, r, n = Assembly(), radius, 9
    if style == "knit":
        m = Material()
        angle = m.math("ARCTAN2", m.axis(1), m.axis(0))
        stitch = m.math("ABSOLUTE", m.math("SINE", m.math("MULTIPLY", angle, 18.0)))
        zig = m.math("MULTIPLY", stitch, 0.016)
        row = m.math("FRACT", m.math("MULTIPLY", m.math("ADD", m.axis(2), zig), 22.0))
        dark = m.math(
            "MAXIMUM", m.remap(row, 0.7, 0.95, 0, 0.7), m.remap(stitch, 0.16, 0.04, 0, 0.7)
        )
        m.colour(m.mix(dark, m.mottle(colour, 0.08, 30, offset), shade(colour, 0.45)))
        rows = [math.pi * k / 10 for k in range(11)]
        profile = [(r * math.sin(t) ** 0.62, height / 2 - height / 2 * math.cos(t)) for t in rows]
        profile[0], profile[-1] = (0, 0), (0, height)
        asm.add("body", lathe(profile, 28, mat=m, discs=False))
    else:
        m = Material()
        angle = m.math("ARCTAN2", m.axis(1), m.axis(0))
        phase = m.math("FRACT", m.math("MULTIPLY", angle, 12 / (2 * math.pi)))
        near = m.math("ABSOLUTE", m.math("SUBTRACT", phase, 0.5))
        radial = m.math(
            "SQRT", m.math("ADD", m.math("POWER", m.axis(0), 2), m.math("POWER", m.axis(1), 2))
        )
        star = m.math("ADD", radial, m.math("MULTIPLY", near, 0.18))
        inner = m.remap(star, 0.135, 0.145, 1, 0)
        leather = m.mix(inner, m.mottle(colour, 0.08, 30, offset), second)
        seam = m.math(
            "MAXIMUM",
            m.remap(near, 0.46, 0.49, 0, 0.8),
            m.remap(m.math("ABSOLUTE", m.math("SUBTRACT", star, 0.14)), 0.01, 0.004, 0, 0.9),
        )
        m.colour(m.mix(seam, leather, "#f0e4cc"))
        profile = [(0, 0), (0.86 * r, 0), (r, 0.07), (1.03 * r, height * 0.45), (r, height - 0.08)]
        profile += [(0.82 * r, height - 0.02), (0.4 * r, height - 0.002), (0, height)]
        asm.add(
            "body", lathe(profile, 36, mat=m, discs=False, rib=lambda k, i: 1.0 if i % 3 else 0.975)
        )
    _ = n
    asm.piece("body", cylinder_piece(0.9 * r, 0, height, 12))
    top = Support("top", height - 0.004, round_polygon(0.45 * r, 12))
    title = "knitted pouf" if style == "knit" else "leather pouf"
    return Model(title, asm.parts(), 4.0, supports=[top], ground_shadow=True)


def ottoman_long(
    width: float = 0.95, depth: float = 0.5, height: float = 0.43, colour: str = "#b9a98e",
    wood: str = "walnut", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A long padded one on turned feet, buttoned in diamonds."""
    asm, hx, hy = Assembly(), depth / 2, width / 2
    cloth, timber = quilted(colour, 0.16, offset), finish(wood, 2, offset)
    for x in (-hx + 0.07, hx - 0.07):
        for y in (-hy + 0.08, hy - 0.08):
            leg(asm, "body", (x, y), (x, y), (0, 0.15), (0.018, 0.032), timber, 10)
    asm.board(
        "body",
        (-hx + 0.01, -hy + 0.01, 0.14),
        (hx - 0.01, hy - 0.01, 0.26),
        fabric(colour, offset),
        0.012,
    )
    pad = cushion((depth, width, height - 0.262), (0, 0, 0.25), cloth, 0.06, 0.02, 0.05)
    asm.add("body", pad.weigh(1.4), solid=True)
    spots = [
        (x, y, height) for x in (-0.16, 0.0, 0.16) for y in np.arange(-hy + 0.155, hy - 0.1, 0.16)
    ]
    buttons(asm, spots, colour)
    top = surface("top", (-hx, -hy), (hx, hy), height + 0.006, margin=0.07)
    return Model("long buttoned ottoman", asm.parts(), 11.0, supports=[top], ground_shadow=True)


def ottoman_random(rng: np.random.Generator) -> dict:
    """Parameters of a random ottoman."""
    return {"offset": noise_offset(rng)}


MODELS: dict[str, Maker] = {
    "ottoman": designed(
        [
            (ottoman_cube, {}),
            (ottoman_drum, {}),
            (pouf, {}),
            (ottoman_long, {}),
            (pouf, {"style": "leather", "colour": "#b8793f", "radius": 0.28, "height": 0.36}),
            (ottoman_cube, {"width": 0.78, "depth": 0.4, "colour": "#6b4a36", "buttoned": True}),
            (ottoman_drum, {"colour": "#3f6f6a"}),
        ],
        ottoman_random,
    ),
}
