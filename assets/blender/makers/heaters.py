"""Electric heaters; in the variant `on` their elements glow."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, glowing, metal, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import (
    box,
    ellipsoid,
    extrude,
    lathe,
    loft,
    rounded_rectangle,
    superellipse,
    tube,
)

from makers.soft_forms import bars, bent

SHINE = (1.7, 1.7, 1.7, 1.0)


def switched(
    title: str, body: list[Mesh], off: list[Mesh], lit: list[Mesh], pieces: list, mass: float
) -> Model:
    """A model whose element is dark (`element`) or glows (`element_lit`)."""
    parts = {
        "body": Part(body, collision=pieces),
        "element": Part(off, collision="none"),
        "element_lit": Part(lit, collision="none", rgba=SHINE),
    }
    return Model(
        title,
        parts,
        mass=mass,
        variants={"default": ["body", "element"], "on": ["body", "element_lit"]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["element_lit"]},
            {"state": "OFF", "variants": ["default"], "parts": ["element"]},
        ],
    )


def _glow() -> Material:
    m = glowing("ffffff")
    wave = m.noise(60, 2)
    return m.colour(
        m.ramp(m.remap(wave, 0.3, 0.7), [(0, "ff5a14"), (0.6, "ff8a2a"), (1, "ffc04a")])
    )


def _lamp(at, r: float, mat: Material) -> Mesh:
    return ellipsoid((r * 0.6, r, r), at, 7, 4, mat)


# ---- heaters
def oil_radiator(colour: str, trim: str, fins: int) -> Model:
    """Hollow fins in a row on castors, a control box at the front end."""
    paint, dark = plain(colour, 0.03, 20), plain(trim, 0.04)
    h, d, step = 0.56, 0.15, 0.055
    length = fins * step
    body: list[Mesh] = []
    outline = rounded_rectangle(d, h, 0.05, 2)
    for k in range(fins):
        y = (k - (fins - 1) / 2) * step
        body.append(extrude(outline, 0.032, paint, axis="y").move(0, y, 0.06 + h / 2))
    for z in (0.14, 0.54):
        body += bars([[(0, -length / 2, z), (0, length / 2, z)]], 0.02, paint, 6)
    y = -length / 2 - 0.05
    body.append(box(d * 0.95, 0.1, h * 0.94, (0, y, 0.08), dark, 0.02, 2))
    for q in (0.36, 0.49):
        knob = lathe([(0.026, 0), (0.022, 0.016), (0, 0.016)], 10, mat=plain("#d8dadc", 0.03))
        body.append(knob.turn(ry=math.pi / 2).move(d * 0.47, y, q + 0.03))
    for yy in (-length * 0.36, length * 0.36):
        body.append(box(0.24, 0.03, 0.02, (0, yy, 0.045), dark, 0.004))
        for x in (-0.1, 0.1):
            wheel = lathe([(0, -0.012), (0.026, -0.012), (0.026, 0.012), (0, 0.012)], 8, mat=dark)
            body.append(wheel.turn(rx=math.pi / 2).move(x, yy, 0.026))
    grip = [(0, y - 0.02, 0.6), (0, y, 0.66), (0, y + 0.1, 0.66), (0, y + 0.12, 0.62)]
    body.append(bent(grip, 0.012, dark, 5, 1))
    at = (d * 0.48, y, 0.28)
    off = [_lamp(at, 0.018, plain("#5a2420", 0))]
    lit = [_lamp(at, 0.02, glowing("ff3418"))]
    for k in range(fins - 1):  # warmth between the fins
        yy = (k - (fins - 2) / 2) * step
        lit.append(box(0.1, 0.012, h * 0.82, (0, yy, 0.06 + h * 0.09), _glow()))
    pieces = [
        box_piece((0, -0.05, 0.34), (d, length + 0.1, 0.56)),
        box_piece((0, 0, 0.03), (0.24, length * 0.8, 0.06)),
    ]
    return switched("oil-filled radiator", body, off, lit, pieces, 11.0)


def _coils(lit: bool) -> Material:
    """A grille with a wound wire behind it."""
    picture, draw = canvas(256, 192, "#ff7a20" if lit else "#2a2a2c")
    wire = "#ffd060" if lit else "#5a5550"
    for row in range(5):
        y = 24 + 36 * row
        points = [(8 + 4 * i, y + (10 if i % 2 else -10)) for i in range(61)]
        draw.line(points, fill=wire, width=4)
    for i in range(9):
        draw.line((0, 12 + 21 * i, 256, 12 + 21 * i), fill="#3a2418" if lit else "#8a8d90", width=4)
    return printed(picture, occlusion=0.0 if lit else 1.0)


def fan_heater(colour: str, trim: str) -> Model:
    """A small box with a grille, a dial and a handle."""
    paint, dark = plain(colour, 0.03, 20), plain(trim, 0.04)
    w, d, h = 0.25, 0.14, 0.27
    rings = [np.c_[rounded_rectangle(d, w, 0.035, 3), np.full(12, z)] for z in (0.015, h - 0.02)]
    rings.append(np.c_[rounded_rectangle(d * 0.86, w * 0.92, 0.03, 3), np.full(12, h)])
    body = [loft(rings, paint)]
    body.append(box(0.012, w * 0.86, h * 0.56, (d / 2, 0, 0.04), dark, 0.004))
    body.append(
        bent(
            [
                (0, -0.07, h - 0.01),
                (0, -0.05, h + 0.035),
                (0, 0.05, h + 0.035),
                (0, 0.07, h - 0.01),
            ],
            0.012,
            dark,
            6,
            2,
        )
    )
    dial = lathe([(0.026, 0), (0.023, 0.018), (0, 0.018)], 12, mat=dark)
    body.append(dial.turn(ry=math.pi / 2).move(d / 2 - 0.002, 0.04, h * 0.83))
    body.append(box(0.01, 0.005, 0.02, (d / 2 + 0.016, 0.04, h * 0.83), plain("#ffffff", 0)))
    body += [box(0.1, 0.025, 0.018, (0, q * 0.09, 0), dark, 0.003) for q in (-1, 1)]
    at = (d / 2 + 0.004, 0, 0.055)
    lamp = (d / 2, -0.05, h * 0.84)

    def element(lit: bool) -> list[Mesh]:
        back = plain("#2a2a2c", 0) if not lit else glowing("ff7a20")
        panel = box(0.008, w * 0.76, h * 0.46, at, back, labels={"+x": _coils(lit)})
        return [panel, _lamp(lamp, 0.012, glowing("ff3418") if lit else plain("#5a2420", 0))]

    pieces = [box_piece((0, 0, h / 2), (d, w, h)), box_piece((0, 0, h + 0.02), (0.024, 0.14, 0.05))]
    return switched("fan heater", body, element(False), element(True), pieces, 1.4)


def halogen(colour: str, trim: str, tubes: int, upright: bool) -> Model:
    """A bent reflector with glass tubes and a wire guard, on a foot; upright or wide."""
    paint, mirror, wire = (
        plain(colour, 0.03, 20),
        metal("d8dce0", "8a9096"),
        metal("b9bdc2", "6a7076"),
    )
    w, h = (0.28, 0.5) if upright else (0.56, 0.2)
    z0 = 0.09 if upright else 0.06
    shape = [
        (0.06, -0.5),
        (0.0, -0.44),
        (-0.04, -0.26),
        (-0.05, 0),
        (-0.04, 0.26),
        (0.0, 0.44),
        (0.06, 0.5),
    ]
    p = np.array(shape)
    if upright:  # bent about z
        inner = np.c_[p[:, 0], p[:, 1] * w]
        outer = inner + np.c_[np.full(7, -0.02), np.zeros(7)]
        body = [extrude(np.r_[inner, outer[::-1]], h, mirror, paint).move(0, 0, z0)]
        cap = np.r_[inner, [(0.06, 0.5 * w), (0.06, -0.5 * w)]]
        body += [
            extrude(np.r_[cap[:7] * [1, 1.05]] + [-0.004, 0], 0.03, paint).move(0, 0, z)
            for z in (z0 - 0.015, z0 + h - 0.015)
        ]
    else:
        inner = np.c_[p[:, 0], p[:, 1] * h]
        outer = inner + np.c_[np.full(7, -0.02), np.zeros(7)]
        body = [
            extrude(np.r_[inner, outer[::-1]], w, mirror, paint, axis="y").move(0, 0, z0 + h / 2)
        ]
        for q in (-1, 1):
            end = np.r_[inner * [1, 1.03], [(-0.055, 0.3 * h), (-0.055, -0.3 * h)]]
            body.append(extrude(end, 0.03, paint, axis="y").move(0, q * w / 2, z0 + h / 2))
    if upright:
        profile = [
            (0, 0),
            (0.15, 0),
            (0.155, 0.012),
            (0.13, 0.03),
            (0.05, 0.05),
            (0.04, 0.09),
            (0, 0.09),
        ]
        body.append(lathe(profile, 18, mat=plain(trim, 0.04)))
        for k in range(3):
            body.append(box(0.01, 0.03, 0.016, (0.148 - 0.02, (k - 1) * 0.05, 0.024), paint, 0.003))
    else:
        for q in (-1, 1):
            body.append(box(0.16, 0.03, 0.05, (0, q * w * 0.4, 0), plain(trim, 0.04), 0.006))
            body.append(box(0.03, 0.03, 0.06, (-0.03, q * w * 0.4, 0.04), plain(trim, 0.04)))
    guard = []
    for k in range(6):
        f = (k - 2.5) / 6
        if upright:
            guard.append(
                [
                    (0.06, -w / 2, z0 + h / 2 + f * h),
                    (0.085, 0, z0 + h / 2 + f * h),
                    (0.06, w / 2, z0 + h / 2 + f * h),
                ]
            )
        else:
            guard.append([(0.06, f * w, z0), (0.09, f * w, z0 + h / 2), (0.06, f * w, z0 + h)])
    body += [tube(np.array(g), 0.0035, 3, mat=wire, weight=0.5) for g in guard]

    def element(lit: bool) -> list[Mesh]:
        mat = _glow() if lit else plain("#e8e6e0", 0.05)
        out = []
        for k in range(tubes):
            if upright:
                z = z0 + h * (k + 0.5) / tubes
                line = [(0.012, -w * 0.4, z), (0.012, w * 0.4, z)]
            else:
                z = z0 + h * (0.32 + 0.36 * k / max(1, tubes - 1))
                line = [(0.012, -w * 0.46, z), (0.012, w * 0.46, z)]
            out.append(tube(np.array(line), 0.013, 8, mat=mat))
            if lit:  # the reflector behind it shines too
                a, b = np.array(line[0]), np.array(line[1])
                size = b - a
                out.append(
                    box(0.006, float(size[1]), 0.05, (-0.03, 0, z - 0.025), glowing("ffa048"))
                )
        return out

    if upright:
        pieces = [cylinder_piece(0.15, 0, 0.04), box_piece((0.01, 0, z0 + h / 2), (0.13, w, h))]
    else:
        pieces = [box_piece((0, 0, (z0 + h) / 2), (0.16, w, z0 + h))]
    name = "halogen heater" if upright else "electric bar heater"
    return switched(name, body, element(False), element(True), pieces, 1.8)


def tower_heater(colour: str, trim: str) -> Model:
    """A ceramic tower: an oval column with a tall grille and a display."""
    paint, dark = plain(colour, 0.03, 20), plain(trim, 0.04)
    rings = [superellipse(0.075, 0.09, 2.6, 16, z) for z in (0.03, 0.59)]
    rings.append(superellipse(0.06, 0.075, 2.6, 16, 0.61))
    body = [
        loft(rings, paint),
        lathe([(0, 0), (0.125, 0), (0.12, 0.02), (0.07, 0.032), (0, 0.032)], 18, mat=dark),
    ]
    body.append(box(0.02, 0.12, 0.36, (0.068, 0, 0.07), dark, 0.006))
    for k in range(9):
        body.append(box(0.016, 0.11, 0.006, (0.078, 0, 0.09 + 0.037 * k), dark))

    def element(lit: bool) -> list[Mesh]:
        picture, draw = canvas(96, 64, "#101214")
        text(draw, "24°" if lit else "--", (10, 8, 86, 56), "bold", "#ffb040" if lit else "#3a3d40")
        screen = box(
            0.012, 0.07, 0.045, (0.072, 0, 0.49), dark, labels={"+x": printed(picture, occlusion=0)}
        )
        mat = _glow() if lit else plain("#54575a", 0.06)
        return [screen, box(0.006, 0.1, 0.34, (0.077, 0, 0.08), mat)]

    pieces = [cylinder_piece(0.12, 0, 0.03), box_piece((0, 0, 0.32), (0.15, 0.18, 0.58))]
    return switched("ceramic tower heater", body, element(False), element(True), pieces, 2.4)


def convector(colour: str, trim: str) -> Model:
    """A flat panel on two feet, slots above, its coils glowing through the lower grille."""
    paint, dark = plain(colour, 0.02, 20), plain(trim, 0.04)
    w, h, d = 0.62, 0.42, 0.09
    body = [box(d, w, h, (0, 0, 0.06), paint, 0.02, 2)]
    for k in range(13):
        y = (k - 6) * 0.042
        body.append(box(0.004, 0.026, 0.09, (d / 2, y, 0.34), dark))
        body.append(box(d * 0.6, 0.024, 0.003, (0, y, 0.479), dark))
    body += [box(0.24, 0.03, 0.06, (0, q * 0.22, 0), dark, 0.01) for q in (-1, 1)]
    for z in (0.3, 0.36):
        knob = lathe([(0.018, 0), (0.016, 0.014), (0, 0.014)], 10, mat=dark)
        body.append(knob.turn(rx=-math.pi / 2).move(0, w / 2, z))

    def element(lit: bool) -> list[Mesh]:
        mat = _coils(lit)
        panel = box(0.006, w * 0.84, 0.13, (d / 2, 0, 0.1), dark, labels={"+x": mat})
        lamp = _lamp((d / 2, 0.25, 0.27), 0.012, glowing("ff3418") if lit else plain("#5a2420", 0))
        return [panel, lamp]

    pieces = [box_piece((0, 0, 0.27), (d, w, h)), box_piece((0, 0, 0.03), (0.24, 0.47, 0.06))]
    return switched("convector heater", body, element(False), element(True), pieces, 4.0)


def heater(kind: str, colour: str, trim: str) -> Model:
    """An electric heater: "oil", "fan", "halogen", "bars", "tower" or "convector"."""
    if kind == "oil":
        return oil_radiator(colour, trim, 7)
    if kind in ("halogen", "bars"):
        return halogen(colour, trim, 3 if kind == "halogen" else 2, kind == "halogen")
    return {"fan": fan_heater, "tower": tower_heater, "convector": convector}[kind](colour, trim)


def heater_random(rng: np.random.Generator) -> dict:
    kind = pick(rng, ["oil", "fan", "halogen", "bars", "tower", "convector"])
    return {"kind": kind, "colour": pick(rng, ["#f0efea", "#3a3d42"]), "trim": "#2a2b2e"}


MODELS = {
    "heater": Maker(
        heater,
        heater_random,
        8,
        [
            {"kind": "oil", "colour": "#f0efea", "trim": "#3a3d42"},
            {"kind": "fan", "colour": "#e8e8e4", "trim": "#3a3d42"},
            {"kind": "halogen", "colour": "#d8dadc", "trim": "#2a2b2e"},
            {"kind": "tower", "colour": "#2f3136", "trim": "#1c1d20"},
            {"kind": "convector", "colour": "#f2f2ee", "trim": "#54575c"},
            {"kind": "bars", "colour": "#b8bcc0", "trim": "#2a2b2e"},
            {"kind": "oil", "colour": "#3a3d42", "trim": "#1c1d20"},
            {"kind": "fan", "colour": "#7a2f34", "trim": "#26282c"},
        ],
    ),
}
