"""Extractor hoods, to hang above a hob: the part `lamp` shines from below when ON."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, glowing, label, plain
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import extrude, lathe, loft

from .joinery import Assembly, steel

Offset = tuple[float, float, float]


def _mesh_filter() -> Material:
    """A grease filter: a fine aluminium grid."""
    m = Material()
    cells = m.remap(m.voronoi(90, randomness=0.0), 0.2, 0.4)
    return m.colour(m.mix(cells, "#5d6368", "#a5abb0"))


def _underside(asm: Assembly, x: tuple, half: float, z: float) -> None:
    """Filters and lamps below the canopy."""
    x0, x1 = x
    grid, frame = _mesh_filter(), steel(20)
    for a, b in ((-half + 0.05, -0.008), (0.008, half - 0.05)):
        asm.board("body", (x0, a, z - 0.004), (x1 - 0.07, b, z + 0.004), grid, solid=False)
        asm.board(
            "body",
            (x0 + 0.02, (a + b) / 2 - 0.03, z - 0.009),
            (x0 + 0.032, (a + b) / 2 + 0.03, z - 0.002),
            frame,
            solid=False,
        )
    for y in (-half * 0.62, half * 0.62):
        disc = [(0, z - 0.006), (0.034, z - 0.006), (0.034, z + 0.002), (0, z + 0.002)]
        asm.add("body", lathe(disc, 14, mat=plain("#d8d8d2", 0.02)).move(x1 - 0.04, y, 0))
        lit = [(0, z - 0.012), (0.04, z - 0.012), (0.04, z - 0.002), (0, z - 0.002)]
        asm.add("lamp", lathe(lit, 14, mat=glowing("#fff3c8")).move(x1 - 0.04, y, 0))


def _buttons(asm: Assembly, x: float, z: float, dark: bool) -> None:
    picture, draw = labels.canvas(200, 32, "#c9cdd0" if not dark else "#1c1e20")
    ink = "#26292c" if not dark else "#dfe3e6"
    for k in range(5):
        draw.rounded_rectangle((14 + k * 38, 6, 38 + k * 38, 26), 5, outline=ink, width=3)
    face = {"+x": label(picture)}
    low, high = (x - 0.004, -0.09, z - 0.013), (x + 0.004, 0.09, z + 0.013)
    asm.board("body", low, high, plain("#c9cdd0", 0.02), 0, face, 2.0, solid=False)
    lamp = (x, 0.072, z - 0.005), (x + 0.007, 0.082, z + 0.005)
    asm.board("lamp", *lamp, glowing("#6fd0ff"), solid=False)


def range_hood(
    form: str = "pyramid",
    colour: str = "steel",
    width: float = 0.6,
    tall: float = 0.95,
    offset: Offset = (0, 0, 0),
) -> Model:
    """form: "pyramid" under a chimney, flat "box" under a chimney, curved "glass" canopy,
    "slanted" black glass, or a slim "visor".

    Chimneys are `tall` with what is below them: homes hang them so that they end at the ceiling.
    The others give back the air that they clean, and have no duct that would end in mid-air."""
    asm, half = Assembly(), width / 2
    shell = steel(3.0) if colour == "steel" else plain(colour, 0.02, 8, offset)
    back, depth = -0.25, 0.5
    x1 = back + depth
    if form in ("pyramid", "box", "glass"):
        low, rise = 0.05, {"pyramid": 0.24, "box": 0.05, "glass": 0.09}[form]
        wide = half if form != "glass" else half - 0.1
        deep = x1 if form != "glass" else x1 - 0.1
        asm.board("body", (back, -wide, 0), (deep, wide, low), shell, 0.004)
        # Two sleeves, the upper one drawn out to the ceiling with a collar where they meet.
        top, meet = tall - 0.009, tall - 0.26
        asm.board("body", (back, -0.13, low), (0.0, 0.13, meet), shell, 0.004)
        asm.board("body", (back + 0.01, -0.12, meet), (-0.01, 0.12, top - 0.004), shell, 0.003)
        asm.board("body", (back, -0.13, top - 0.015), (0.0, 0.13, top), shell, 0.003)
        slit = plain("#3a3d40", 0.03)
        for k in range(4):
            for s in (-1, 1):
                a, b = sorted((s * 0.1195, s * 0.1225))
                z = top - 0.1 + 0.02 * k
                asm.board("body", (-0.17, a, z), (-0.07, b, z + 0.009), slit, solid=False)
        if form == "pyramid":
            rings = []
            for a, b, y, z in ((back, x1, half, low), (back, 0.0, 0.13, low + rise)):
                rings.append(np.array([(b, -y, z), (b, y, z), (a, y, z), (a, -y, z)]))
            asm.add("body", loft(rings, shell))
            asm.piece("body", np.concatenate(rings))
        if form == "glass":
            curve = [
                (x, 0.05 + 0.07 * (1 - (2 * x / width) ** 2)) for x in np.linspace(-half, half, 13)
            ]
            outline = curve + [(x, z + 0.012) for x, z in curve[::-1]]
            pane = extrude(outline, depth, mat=plain("#bcd3d9", 0.08, 6, offset), axis="y")
            pane.v = pane.v[:, [1, 0, 2]]
            asm.add("body", pane.flip().outward().move(back + depth / 2, 0, 0), solid=True)
        _underside(asm, (back + 0.03, deep - 0.02), wide, 0.0)
        _buttons(asm, deep + 0.001, 0.025, False)
        mass = 13.0
    elif form == "slanted":
        side = [(back, 0.0), (back + 0.12, 0.0), (x1 - 0.1, 0.36), (x1 - 0.14, 0.42), (back, 0.42)]
        asm.add("body", extrude(side, width, mat=shell, axis="y", bevel_width=0.004))
        asm.piece("body", np.array([(x, y, z) for x, z in side for y in (-half, half)]))
        # a pane of dark glass laid on the slope, standing off it
        a, b = np.array([back + 0.13, 0.0]), np.array([x1 - 0.085, 0.36])
        along = (b - a) / np.linalg.norm(b - a)
        out = np.array([along[1], -along[0]])
        glass = Material()
        glass.colour(glass.mix(glass.remap(glass.axis(2), 0.0, 0.4), "#191b1d", "#262a2d"))
        corners = [a + out * 0.012, b + out * 0.012, b + out * 0.026, a + out * 0.026]
        asm.add("body", extrude(corners, width - 0.01, mat=glass, axis="y", bevel_width=0.003))
        _lamps_on_slope(asm, a, along, out, half)
        mass = 15.0
    else:
        side = [(back, 0.0), (x1, 0.0), (x1, 0.045), (x1 - 0.16, 0.13), (back, 0.13)]
        asm.add("body", extrude(side, width, mat=shell, axis="y", bevel_width=0.003))
        asm.piece("body", np.array([(x, y, z) for x, z in side for y in (-half, half)]))
        slit = plain("#3a3d40", 0.03)
        for k in range(9):
            y = (k - 4) * 0.045
            bar = extrude([(0, 0), (0.05, 0), (0.05, 0.003), (0, 0.003)], 0.014, slit, axis="y")
            bar.turn(ry=math.atan2(0.085, 0.16))
            asm.add("body", bar.move(x1 - 0.125, y, 0.112))
        _underside(asm, (back + 0.03, x1 - 0.05), half, -0.002)
        _buttons(asm, x1 + 0.001, 0.022, False)
        mass = 6.5
    if form != "slanted":  # a light bar under the front edge, for those who look down on it
        edge = x1 if form != "glass" else x1 - 0.1
        reach = 0.75 * (half if form != "glass" else half - 0.1)
        low, high = (edge - 0.02, -reach, -0.004), (edge + 0.006, reach, 0.007)
        asm.board("lamp", low, high, glowing("#fff3c8"), solid=False)
    fixed = [name for name in asm.meshes if name != "lamp"]
    words = {
        "pyramid": "chimney range hood",
        "box": "flat chimney range hood",
        "glass": "range hood with a glass canopy",
        "slanted": "slanted range hood of black glass",
        "visor": "slim range hood",
    }
    return Model(
        title=words[form],
        parts=asm.parts(lamp={"rgba": (1.6, 1.6, 1.6, 1.0)}),
        mass=mass,
        variants={"default": fixed, "on": [*fixed, "lamp"]},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
            {"state": "ON", "variants": ["on"], "parts": ["lamp"]},
        ],
    )


def _lamps_on_slope(asm: Assembly, a, along, out, half: float) -> None:
    """Touch keys and two lamps on a slanted hood's lower edge."""
    turn = math.atan2(along[0], along[1])
    for y in (-0.6 * half, 0.6 * half):
        centre = a + along * 0.06 + out * 0.024
        disc = [(0, 0), (0.03, 0), (0.03, 0.008), (0, 0.008)]
        mesh = lathe(disc, 14, mat=glowing("#fff3c8")).turn(ry=math.pi / 2 + turn)
        asm.add("lamp", mesh.move(centre[0], y, centre[1]))
    for k in range(5):
        centre = a + along * 0.33 + out * 0.026
        y = (k - 2) * 0.035
        low = (centre[0] - 0.004, y - 0.008, centre[1] - 0.008)
        high = (centre[0] + 0.004, y + 0.008, centre[1] + 0.008)
        asm.board("body", low, high, plain("#dfe3e6", 0.02), solid=False)
        if k == 2:
            low, high = np.subtract(low, 0.003), np.add(high, 0.003)
            asm.board("lamp", low, high, glowing("#6fd0ff"), solid=False)


def range_hood_random(rng: np.random.Generator) -> dict:
    """Parameters of a random hood."""
    return {
        "form": pick(rng, ["pyramid", "box", "glass", "slanted", "visor"]),
        "colour": pick(rng, ["steel", "#f1f1ee", "#26282b"]),
        "tall": 0.95,
        "offset": noise_offset(rng),
    }


MODELS = {
    "range_hood": Maker(
        range_hood,
        range_hood_random,
        8,
        [
            {"form": "pyramid", "colour": "steel"},
            {"form": "pyramid", "colour": "#26282b"},
            {"form": "box", "colour": "steel", "tall": 0.85},
            {"form": "glass", "colour": "steel", "tall": 0.85},
            {"form": "slanted", "colour": "#e9e8e4"},
            {"form": "slanted", "colour": "#26282b"},
            {"form": "visor", "colour": "#f1f1ee"},
            {"form": "visor", "colour": "steel"},
        ],
    ),
}
