"""More microwave ovens: rounded retro, drop-down door, two dials; and the light behind a window."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image, ImageDraw
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.model import Container, Joint, Model
from toolkit.shapes import lathe

from .joinery import Assembly, bar_handle, hinge, open_closed, steel, surface

Offset = tuple[float, float, float]
GLOW = (1.5, 1.5, 1.5, 1.0)
NAMES = {
    "#e9eaea": "white",
    "#2c2e31": "black",
    "#b9bdc0": "silver",
    "#efe4cb": "cream",
    "#a8322c": "red",
    "steel": "steel",
    "#26282b": "black",
    "#f1f1ee": "white",
}
SWITCHED = [
    {"state": "OFF", "variants": ["default"], "parts": ["door"]},
    {"state": "ON", "variants": ["on"], "parts": ["light"]},
]


def _window(lit: bool, aspect: float = 0.6) -> Image.Image:
    """A perforated window: dark, or with the turning plate lit behind it."""
    width, height = 128, int(128 * aspect)
    image, pen = labels.canvas(width, height, "#1b1d1f")
    if lit:
        image = labels.gradient(width, height, "#ffdf8a", "#e8a840")
        pen = ImageDraw.Draw(image)
        pen.ellipse((14, height * 0.66, 114, height * 0.98), fill="#fff0c0")
    for k in range(0, height, 6):
        for j in range(0, width, 6):
            pen.point((j + (k // 6 % 2) * 3, k), fill="#8a6a2a" if lit else "#3a3e42")
    if not lit:
        pen.polygon([(10, height), (48, 0), (76, 0), (38, height)], fill="#2b3034")
    return image


def window_light(asm: Assembly, part: str, x: float, y: tuple, z: tuple) -> None:
    """The window as it looks while the oven runs; lies on the door's face at x."""
    lit = label(_window(True, (z[1] - z[0]) / (y[1] - y[0])), occlusion=0.0)
    low, high = (x - 0.004, y[0], z[0]), (x + 0.004, y[1], z[1])
    asm.board(part, low, high, plain("#8a6a2a", 0), 0, {"+x": lit}, 1.5, solid=False)


def _hollow(
    asm: Assembly, x: tuple, y: tuple, z: tuple, half: float, h: tuple, shell, liner
) -> None:
    """A case from -half to half between heights h, hollow between y and z, open in front."""
    (x0, x1), (y0, y1), (z0, z1) = x, y, z
    asm.board("body", (x0, -half, h[0]), (x1, y0, h[1]), shell, 0.012, {"+y": liner})
    asm.board("body", (x0, y1, h[0]), (x1, half, h[1]), shell, 0.012, {"-y": liner})
    asm.board("body", (x0 + 0.004, y0 - 0.01, h[0]), (x1, y1 + 0.01, z0), shell, 0, {"+z": liner})
    asm.board("body", (x0 + 0.004, y0 - 0.01, z1), (x1, y1 + 0.01, h[1]), shell, 0, {"-z": liner})
    asm.board("body", (x0 + 0.004, y0, z0), (x0 + 0.02, y1, z1), shell, 0, {"+x": liner})


def _plate(asm: Assembly, x: float, y: float, z: float, r: float = 0.125) -> None:
    plate = [(0, 0), (0.85 * r, 0), (r, 0.008), (0.98 * r, 0.012), (0.8 * r, 0.006), (0, 0.006)]
    asm.add("body", lathe(plate, 14, mat=plain("#cfe0e2", 0.04, 20)).move(x, y, z + 0.008))
    asm.solid("body", (x - 0.09, y - 0.09, z), (x + 0.09, y + 0.09, z + 0.014))


def _finished(
    asm: Assembly,
    title: str,
    mass: float,
    joint: Joint,
    x: tuple,
    y: tuple,
    z: tuple,
    half: float,
    top: float,
) -> Model:
    middle = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2)
    plate = surface(
        "plate",
        (middle[0] - 0.08, middle[1] - 0.08),
        (middle[0] + 0.08, middle[1] + 0.08),
        z[0] + 0.014,
        z[1] - z[0] - 0.03,
        "inside",
    )
    size = (x[1] - x[0] - 0.02, y[1] - y[0], z[1] - z[0])
    center = (middle[0], middle[1], (z[0] + z[1]) / 2)
    return Model(
        title=title,
        parts=asm.parts(door={"joint": "door"}, light={"joint": "door", "rgba": GLOW}),
        mass=mass,
        variants={"default": ["body", "door"], "on": ["body", "door", "light"]},
        joints={"door": joint},
        states=SWITCHED + open_closed("door", "door"),
        supports=[surface("top", (x[0], -half + 0.02), (x[1], half - 0.02), top), plate],
        containers=[Container("inside", center, size, "body", "door")],
    )


def _dial(
    asm: Assembly, x: float, y: float, z: float, r: float, mat: Material, mark: Material
) -> None:
    knob = [(0, 0), (r, 0), (0.92 * r, 0.016), (0.6 * r, 0.02), (0, 0.02)]
    asm.add("body", lathe(knob, 10, mat=mat).turn(ry=math.pi / 2).move(x, y, z))
    low, high = (x + 0.018, y - 0.003, z), (x + 0.023, y + 0.003, z + 0.85 * r)
    asm.board("body", low, high, mark, solid=False)
    for a in np.linspace(-2.2, 2.2, 4):
        yy, zz = y + 1.35 * r * math.sin(a), z + 1.35 * r * math.cos(a)
        asm.board(
            "body",
            (x - 0.001, yy - 0.003, zz - 0.003),
            (x + 0.002, yy + 0.003, zz + 0.003),
            mark,
            solid=False,
        )


def retro_microwave(colour: str = "#efe4cb", offset: Offset = (0, 0, 0)) -> Model:
    """Rounded, on little feet, with chrome dials and a chrome frame round its window."""
    asm, half, h = Assembly(), 0.235, (0.022, 0.3)
    shell, chrome = plain(colour, 0.02, 10, offset), metal("d3d7da", "82888e", (1, 1, 5), 30)
    liner, dark = plain("#dcdedd", 0.02, 10), plain("#2a2c2e", 0.04)
    x, y, z = (-0.18, 0.14), (-half + 0.025, 0.115), (0.045, 0.278)
    asm.board("body", (x[0], -half, h[0]), (x[1], y[0], h[1]), shell, 0.02, {"+y": liner})
    asm.board(
        "body",
        (x[0], y[1], h[0]),
        (x[1] + 0.03, half, h[1]),
        shell,
        0.024,
        {"-y": liner},
        segments=2,
    )
    asm.board(
        "body",
        (x[0] + 0.01, y[0] - 0.012, h[0]),
        (x[1], y[1] + 0.03, z[0]),
        shell,
        0,
        {"+z": liner},
    )
    asm.board(
        "body",
        (x[0] + 0.01, y[0] - 0.012, z[1]),
        (x[1], y[1] + 0.03, h[1]),
        shell,
        0,
        {"-z": liner},
    )
    asm.board("body", (x[0] + 0.01, y[0], z[0]), (x[0] + 0.03, y[1], z[1]), shell, 0, {"+x": liner})
    for fx in (x[0] + 0.04, x[1] - 0.03):
        for fy in (-half + 0.05, half - 0.05):
            foot = [(0, 0), (0.015, 0), (0.012, 0.026), (0, 0.026)]
            asm.add("body", lathe(foot, 6, mat=chrome).move(fx, fy, 0), solid=True)
    _plate(asm, -0.02, (y[0] + y[1]) / 2, z[0])
    for zz in (0.215, 0.115):
        _dial(asm, x[1] + 0.029, (y[1] + half) / 2 + 0.004, zz, 0.03, chrome, dark)
    low, high = (x[1] + 0.001, -half, h[0] + 0.002), (x[1] + 0.032, y[1] - 0.002, h[1] - 0.002)
    asm.board("door", low, high, shell, 0.022, segments=2)
    face = x[1] + 0.032
    wy, wz = (-half + 0.045, y[1] - 0.06), (0.085, 0.24)
    asm.board(
        "door",
        (face - 0.004, wy[0] - 0.012, wz[0] - 0.012),
        (face + 0.003, wy[1] + 0.012, wz[1] + 0.012),
        chrome,
        0.003,
        solid=False,
    )
    asm.board(
        "door",
        (face, wy[0], wz[0]),
        (face + 0.006, wy[1], wz[1]),
        dark,
        0,
        {"+x": label(_window(False))},
        1.5,
        solid=False,
    )
    window_light(asm, "light", face + 0.006, wy, wz)
    bar_handle(asm, "door", face, y[1] - 0.028, 0.16, 0.15, chrome, reach=0.035, radius=0.009)
    return _finished(
        asm,
        f"{NAMES.get(colour, 'coloured')} retro microwave with dials",
        12.5,
        hinge(face, -half),
        (x[0] + 0.03, x[1]),
        y,
        z,
        half,
        h[1],
    )


def drop_microwave(colour: str = "steel", offset: Offset = (0, 0, 0)) -> Model:
    """Broad, its door hinged below under a strip of controls."""
    asm, half, h = Assembly(), 0.275, (0.015, 0.345)
    shell = steel(4.0) if colour == "steel" else plain(colour, 0.02, 10, offset)
    liner, dark = plain("#dcdedd", 0.02, 10), plain("#17191b", 0.04)
    x, y, z = (-0.2, 0.17), (-half + 0.03, half - 0.03), (0.04, 0.25)
    _hollow(asm, x, y, z, half, h, shell, liner)
    for fx in (x[0] + 0.04, x[1] - 0.04):
        for fy in (-half + 0.05, half - 0.05):
            asm.board("body", (fx - 0.015, fy - 0.015, 0), (fx + 0.015, fy + 0.015, 0.016), dark)
    _plate(asm, -0.015, 0.0, z[0], 0.14)
    picture, draw = labels.canvas(440, 64, "#17191b")
    labels.text(draw, "MICROWAVE", (14, 18, 150, 46), "bold", "#dfe3e6")
    draw.rectangle((168, 10, 262, 54), fill="#07110e")
    labels.text(draw, "9:05", (174, 14, 256, 50), "bold", "#46f0b4")
    for k in range(6):
        draw.rounded_rectangle((276 + 26 * k, 20, 296 + 26 * k, 44), 4, outline="#c9cdd0", width=2)
    low, high = (x[1], -half + 0.004, 0.268), (x[1] + 0.03, half - 0.004, h[1] - 0.004)
    asm.board("body", low, high, dark, 0, {"+x": label(picture)}, 2.0)
    face = x[1] + 0.032
    asm.board(
        "door",
        (x[1] + 0.001, -half + 0.003, h[0] + 0.003),
        (face, half - 0.003, 0.264),
        shell,
        0.006,
        segments=2,
    )
    wy, wz = (-half + 0.05, half - 0.05), (0.05, 0.205)
    asm.board(
        "door",
        (face - 0.004, wy[0], wz[0]),
        (face + 0.003, wy[1], wz[1]),
        dark,
        0.002,
        {"+x": label(_window(False, 0.35))},
        1.5,
        solid=False,
    )
    window_light(asm, "light", face + 0.002, wy, wz)
    bar_handle(asm, "door", face, 0, 0.234, 0.42, steel(), False, reach=0.038, radius=0.009)
    joint = Joint("revolute", (face, 0, h[0] + 0.003), (0, 1, 0), 0.0, 1.5)
    return _finished(
        asm,
        f"{NAMES.get(colour, 'coloured')} microwave with a drop-down door",
        16.5,
        joint,
        (x[0] + 0.02, x[1]),
        y,
        z,
        half,
        h[1],
    )


def dial_microwave(colour: str = "#f1f1ee", offset: Offset = (0, 0, 0)) -> Model:
    """Small and plain: two big dials, a push button for the door."""
    asm, half, h = Assembly(), 0.215, (0.012, 0.25)
    shell, liner = plain(colour, 0.02, 10, offset), plain("#dcdedd", 0.02, 10)
    dark, grey = plain("#2a2c2e", 0.04), plain("#b9bec2", 0.03)
    x, y, z = (-0.155, 0.125), (-half + 0.02, half - 0.12), (0.032, 0.23)
    _hollow(asm, x, y, z, half, h, shell, liner)
    for fx in (x[0] + 0.03, x[1] - 0.03):
        for fy in (-half + 0.04, half - 0.04):
            asm.board("body", (fx - 0.012, fy - 0.012, 0), (fx + 0.012, fy + 0.012, 0.013), dark)
    _plate(asm, -0.01, (y[0] + y[1]) / 2, z[0], 0.11)
    panel = (x[1], y[1] + 0.002, h[0]), (x[1] + 0.026, half, h[1])
    asm.board("body", *panel, shell, 0.004)
    middle = (y[1] + half) / 2
    for zz in (0.2, 0.115):
        _dial(asm, x[1] + 0.025, middle, zz, 0.027, grey, dark)
    asm.board(
        "body",
        (x[1] + 0.022, middle - 0.04, 0.025),
        (x[1] + 0.034, middle + 0.04, 0.055),
        grey,
        0.004,
        solid=False,
    )
    face = x[1] + 0.026
    asm.board(
        "door", (x[1] + 0.001, -half, h[0]), (face, y[1] - 0.001, h[1]), shell, 0.006, segments=2
    )
    wy, wz = (-half + 0.03, y[1] - 0.035), (0.05, 0.212)
    asm.board(
        "door",
        (face - 0.004, wy[0], wz[0]),
        (face + 0.003, wy[1], wz[1]),
        dark,
        0.002,
        {"+x": label(_window(False))},
        1.5,
        solid=False,
    )
    window_light(asm, "light", face + 0.002, wy, wz)
    return _finished(
        asm,
        f"small {NAMES.get(colour, 'coloured')} microwave with two dials",
        10.5,
        hinge(face, -half),
        (x[0] + 0.02, x[1]),
        y,
        z,
        half,
        h[1],
    )
