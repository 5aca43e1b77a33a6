"""For small children: cots, high chairs, and beds in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Joint, Maker, Model, Support, rectangle
from toolkit.sampling import noise_offset
from toolkit.shapes import extrude, lathe, loft, rounded_rectangle, spline, tube

from .casework import metal_or
from .child_bed_forms import spotted
from .cots import cradle, round_cot, travel_cot
from .designs import designed
from .joinery import Assembly, cushion, fabric, finish, leg, open_closed, surface
from .upholstery import section, solid_path, wall

Offset = tuple[float, float, float]


def _bars(asm: Assembly, part: str, a, b, z: tuple[float, float], n: int, mat, w=0.013) -> None:
    """Square bars upright between two ends (x, y)."""
    for t in np.linspace(0, 1, n + 2)[1:-1]:
        x, y = a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t
        low, high = (x - w / 2, y - w / 2, z[0]), (x + w / 2, y + w / 2, z[1])
        asm.board(part, low, high, mat, solid=False)


def crib(
    length: float = 1.26, width: float = 0.68, height: float = 0.88, wood: str = "birch",
    style: str = "bars", accent: str | None = None, drop: bool = False, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A cot with bars all round; long sides to the front and back.

    style: ends of "bars", solid "panel" ends, or "sleigh" ends curving out. drop: the front side
    is a joint that slides down.
    """
    asm, hx, hy = Assembly(), width / 2, length / 2
    up, along, deep = (finish(wood, axis, offset) for axis in (2, 1, 0))
    end = finish(accent or wood, 2, offset)
    deck, t = 0.36, 0.036
    joints, states, settings = {}, [], {}
    for x in (-hx, hx - t):
        for y in (-hy, hy - t):
            asm.board("body", (x, y, 0), (x + t, y + t, height), end, 0.008)
    for s, x in (("back", -hx + 0.007), ("front", hx - 0.029)):
        part = "side" if drop and s == "front" else "body"
        top = height - 0.05 if s == "front" else height - 0.01
        for z in (0.24, top - 0.04):
            low, high = (x, -hy + t + 0.001, z), (x + 0.022, hy - t - 0.001, z + 0.04)
            asm.board(part, low, high, along, 0.006, solid=False)
        _bars(asm, part, (x + 0.011, -hy + t), (x + 0.011, hy - t), (0.27, top - 0.03), 15, up)
        asm.solid(part, (x, -hy + t + 0.002, 0.24), (x + 0.022, hy - t - 0.002, top))
        if part == "side":
            joints["side"] = Joint("prismatic", (x, 0.0, 0.24), (0, 0, -1), 0.0, 0.2)
            states += open_closed("side", "side", 0.01, 0.12)
            settings["side"] = {"joint": "side"}
    for e in (-1, 1):
        y = e * (hy - t / 2)
        if style == "bars":
            for z in (0.24, height - 0.05):
                asm.board(
                    "body", (-hx + t, y - 0.011, z), (hx - t, y + 0.011, z + 0.04), deep, 0.006
                )
            _bars(asm, "body", (-hx + t, y), (hx - t, y), (0.27, height - 0.03), 7, up)
        elif style == "panel":
            xs = np.linspace(hx - t, -hx + t, 9)
            outline = [(-hx + t, 0.2), (hx - t, 0.2)]
            outline += [(float(x), height + 0.02 + 0.05 * math.cos(1.5 * x / hx)) for x in xs]
            panel = extrude(outline, 0.022, end, axis="y").move(0, y, 0)
            asm.add("body", panel)
        else:
            curve = spline([(0, 0.1), (0.0, 0.55), (0.03, 0.8), (0.09, height + 0.03)], 4)
            outline = [(y + e * (p - 0.012), z) for p, z in curve]
            outline += [(y + e * (p + 0.016), z) for p, z in curve[::-1]]
            asm.add("body", extrude(outline, width - 0.01, end, axis="x"))
        asm.solid("body", (-hx, y - 0.012, 0.2), (hx, y + 0.012, height))
    asm.board("body", (-hx + 0.03, -hy + t, deck - 0.02), (hx - 0.03, hy - t, deck), along)
    white = spotted("#f6f2ea", accent or "#9cc4c8", offset)
    pad = cushion(
        (width - 0.085, length - 2 * t - 0.01, 0.09), (0, 0, deck), white, 0.04, 0.006, 0.03
    )
    asm.add("body", pad, solid=True)
    rug = fabric("#9cc4c8" if accent is None else "#f0c9a0", offset, 0.05)
    cover = cushion((width - 0.1, 0.5, 0.024), (0, 0.28, deck + 0.092), rug, 0.05, 0.01, 0.014)
    asm.add("body", cover)
    pillow = cushion(
        (0.36, 0.24, 0.04), (0, -hy + 0.2, deck + 0.09), fabric("#fbf8f1"), 0.05, 0.02, 0.02
    )
    asm.add("body", pillow)
    z = deck + 0.097
    bed = surface("top", (-hx + 0.09, 0.07), (hx - 0.09, 0.48), z + 0.028)
    pad_top = surface("mattress", (-hx + 0.05, -0.26), (hx - 0.05, 0.0), z)
    return Model(
        "cot" + (", one side lowers" if drop else ""),
        asm.parts(**settings), 19.0 + 8 * (style != "bars"),
        joints=joints, states=states, supports=[bed, pad_top], ground_shadow=True,
    )  # fmt: skip


# ---- high chairs
def high_chair(
    style: str = "wood", colour: str = "#5fa8a0", wood: str = "birch", offset: Offset = (0, 0, 0)
) -> Model:
    """A child's chair as high as a table, with a tray.

    style: "wood" (splayed legs, bars), "plastic" (a moulded seat on thin splayed legs), "ladder"
    (two sloping sides with boards let into them) or "folding" (a padded seat on crossed tubes).
    """
    asm = Assembly()
    up, deep = finish(wood, 2, offset), finish(wood, 1, offset)
    shell = plain(colour, 0.03, 9, offset)
    white = plain("#f4f2ec", 0.02, 9)
    seat_z, hy, tray_z = 0.54, 0.18, 0.74
    steel = metal_or("steel")
    if style == "ladder":
        for s in (-1, 1):
            y = s * 0.2
            side = [(0.24, 0.0), (0.27, 0.035), (-0.13, 0.84), (-0.21, 0.84), (0.17, 0.035)]
            asm.add("body", extrude(side, 0.026, up, axis="y", bevel_width=0.004).move(0, y, 0))
            asm.piece("body", np.array([(x, y + e * 0.013, z) for x, z in side for e in (-1, 1)]))
            foot = (-0.26, y - 0.013, 0), (0.27, y + 0.013, 0.035)
            asm.board("body", *foot, deep, 0.006)
        for x0, x1, z in ((-0.14, 0.2, seat_z), (-0.02, 0.32, 0.3)):
            asm.board("body", (x0, -0.19, z - 0.018), (x1, 0.19, z), deep, 0.006)
        for z in (0.66, 0.78):
            x = 0.255 - 0.5 * z + 0.02 - 0.06
            asm.board(
                "body", (x - 0.01, -0.19, z - 0.045), (x + 0.012, 0.19, z + 0.045), deep, 0.006
            )
        asm.add("body", tube([(-0.24, -0.2, 0.02), (-0.24, 0.2, 0.02)], 0.012, 6, mat=steel))
        seat_x = (-0.09, 0.18)
        pad = cushion(
            (0.25, 0.32, 0.025), (0.04, 0, seat_z), fabric(colour, offset), 0.05, 0.006, 0.01
        )
        asm.add("body", pad)
        top = seat_z + 0.03
        rim = (0.12, 0.4)
    else:
        splay = 0.1 if style != "folding" else 0.0
        thin = style == "plastic"
        if style == "folding":
            for s in (-1, 1):
                y = s * 0.23
                for a, b in ((0.3, -0.17), (-0.3, 0.17)):
                    asm.add(
                        "body", tube([(a, y, 0.014), (b, y * 0.88, seat_z)], 0.013, 6, mat=steel)
                    )
                asm.solid("body", (-0.3, y - 0.014, 0), (0.3, y + 0.014, 0.03))
                asm.solid("body", (-0.1, y - 0.014, 0.03), (0.1, y + 0.014, seat_z))
            for x in (-0.3, 0.3):
                asm.add("body", tube([(x, -0.23, 0.014), (x, 0.23, 0.014)], 0.013, 6, mat=steel))
        else:
            for sx in (-1, 1):
                for sy in (-1, 1):
                    foot, head = (sx * (0.15 + splay), sy * (0.15 + splay)), (sx * 0.14, sy * 0.14)
                    r = (0.011, 0.013) if thin else (0.014, 0.02)
                    leg(asm, "body", foot, head, (0, seat_z), r, steel if thin else up, 8)
            q = 0.15 + splay * 0.55
            if not thin:
                for s in (-1, 1):
                    for ends in (
                        [(-q, s * q, 0.25), (q, s * q, 0.25)],
                        [(s * q, -q, 0.25), (s * q, q, 0.25)],
                    ):
                        asm.add("body", tube(ends, 0.011, 6, mat=up))
        step = (0.14, -0.14, 0.24), (0.3, 0.14, 0.26)
        asm.board("body", *step, shell if thin else deep, 0.006)
        if style == "wood":
            asm.board("body", (-0.17, -hy, seat_z - 0.02), (0.17, hy, seat_z), deep, 0.008)
            for s in (-1, 1):
                y = s * (hy - 0.02)
                asm.add("body", tube([(-0.16, y, seat_z), (-0.22, y, 0.93)], 0.016, 8, mat=up))
                arm = (-0.19, y - 0.018, 0.7), (0.16, y + 0.018, 0.722)
                asm.board("body", *arm, deep, 0.006)
                asm.add("body", tube([(0.13, y, seat_z), (0.13, y, 0.7)], 0.012, 6, mat=up))
            for z in (0.68, 0.79, 0.9):
                x = -0.16 - 0.06 * (z - seat_z) / 0.39
                asm.board(
                    "body",
                    (x - 0.01, -hy + 0.02, z - 0.025),
                    (x + 0.01, hy - 0.02, z + 0.025),
                    deep,
                    0.006,
                )
            asm.solid("body", (-0.24, -hy, seat_z), (-0.15, hy, 0.92))
            pad = cushion(
                (0.3, 0.3, 0.03),
                (0, 0, seat_z),
                spotted(colour, "#fdf6ea", offset),
                0.05,
                0.01,
                0.012,
            )
            asm.add("body", pad)
            top = seat_z + 0.0375
        else:
            path = np.array(
                [(-0.17 * math.cos(q), 0.19 * math.sin(q)) for q in np.linspace(-2.3, 2.3, 15)]
            )

            def rise(s: float) -> float:
                return 0.68 + 0.26 * math.cos((s - 0.5) * math.pi) ** 2

            cover = fabric(colour, offset) if style == "folding" else shell
            asm.add(
                "body",
                wall(path, lambda s: section(0.035, seat_z - 0.03, rise(s), 0.016), cover, 0.1),
            )
            solid_path(asm, path, 0.035, seat_z, lambda s: 0.7)
            asm.solid("body", (-0.23, -0.1, 0.7), (-0.17, 0.1, 0.92))
            dish = [(0, seat_z - 0.03), (0.17, seat_z - 0.03), (0.18, seat_z), (0, seat_z + 0.004)]
            asm.add("body", lathe(dish, 20, mat=cover))
            asm.solid("body", (-0.13, -0.13, seat_z - 0.03), (0.16, 0.13, seat_z))
            if style == "folding":
                pad = cushion(
                    (0.34, 0.24, 0.03),
                    (0, 0, 0),
                    spotted("#fdf6ea", colour, offset),
                    0.05,
                    0.01,
                    0.012,
                )
                asm.add("body", pad.turn(ry=math.pi / 2 - 0.1).move(-0.16, 0, 0.74))
            top = seat_z + 0.004
        seat_x = (-0.11, 0.13)
        rim = (0.07, 0.37)
    x0, x1 = rim
    middle = (x0 + x1) / 2
    ring = rounded_rectangle(x1 - x0, 0.46, 0.08, 4)
    rings = [np.c_[ring * k + [middle, 0], np.full(len(ring), tray_z + z)] for k, z in (
        (0.94, -0.012), (1, 0.0), (1, 0.024), (0.94, 0.024), (0.9, 0.008))]  # fmt: skip
    asm.add("body", loft(rings, white if style != "wood" else finish(wood, 1, offset), weight=1.2))
    asm.solid("body", (x0, -0.23, tray_z - 0.012), (x1, 0.23, tray_z + 0.006))
    if style in ("ladder", "plastic", "folding"):
        for s in (-1, 1):
            y = s * 0.19
            start = -0.12 if style == "ladder" else -0.06
            bar = [(start, y, tray_z - 0.02), (x0 + 0.06, y, tray_z - 0.004)]
            asm.add("body", tube(bar, 0.012, 6, mat=white if style != "ladder" else up))
    rests = [surface("step", (0.08, -0.17), (0.31, 0.17), 0.3, 0.2)] if style == "ladder" else []
    tray = Support("tray", tray_z + 0.009, rectangle((x1 - x0) * 0.74, 0.36, middle))
    seat = surface("seat", (seat_x[0], -0.12), (min(seat_x[1], x0), 0.12), top, tray_z - 0.02 - top)
    names = {
        "wood": "wooden high chair",
        "plastic": "high chair of plastic on thin legs",
        "ladder": "high chair with sloping sides",
        "folding": "folding high chair",
    }
    return Model(names[style], asm.parts(), 6.0, supports=[tray, seat, *rests], ground_shadow=True)


def nursery_random(rng: np.random.Generator) -> dict:
    """Parameters of random furniture for small children."""
    return {"offset": noise_offset(rng)}


MODELS: dict[str, Maker] = {
    "crib": designed(
        [
            (crib, {}),
            (crib, {"wood": "#f3f1ec", "style": "panel", "accent": "#b7d3c4", "drop": True}),
            (crib, {"wood": "walnut", "style": "sleigh", "length": 1.3}),
            (travel_cot, {}),
            (cradle, {}),
            (round_cot, {}),
        ],
        nursery_random,
    ),
    "high_chair": designed(
        [
            (high_chair, {}),
            (high_chair, {"style": "plastic", "colour": "#f0b429"}),
            (high_chair, {"style": "ladder", "wood": "oak", "colour": "#c9604a"}),
            (high_chair, {"style": "folding", "colour": "#6f8fb5"}),
            (high_chair, {"style": "plastic", "colour": "#e9e7e1"}),
            (high_chair, {"style": "ladder", "wood": "#e9e7e1", "colour": "#7f9a8c"}),
        ],
        nursery_random,
    ),
}
