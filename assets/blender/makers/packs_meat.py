"""Raw meat on trays."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import TAU, box, ellipsoid, loft, tube

from makers import chilled, food_trays
from makers.pack_parts import by_style


def flesh(base: str, dark: str, fat: str, form: int, veins: float = 0.02) -> Material:
    """Muscle: streaks along y and threads of fat."""
    m = Material(occlusion=0.7)
    o = noise_offset(np.random.default_rng(form))
    c = m.mix(m.remap(m.noise(30, 4, offset=o, stretch=(1, 3, 1)), 0.35, 0.65), dark, base)
    if veins:
        v = m.noise(24, 3, distortion=2.5, offset=(o[1], o[0], o[2]))
        thin = m.math("ABSOLUTE", m.math("SUBTRACT", v, 0.5))
        c = m.mix(m.remap(thin, veins * 0.4, veins, 0.8, 0), c, fat)
    shine = m.noise(22, 1, offset=(o[2], 0, 1), stretch=(1, 2.5, 1))
    return m.colour(m.mix(m.remap(shine, 0.62, 0.68, 0, 0.45), c, "ffece4"))


def price_tag(words: str, at: tuple[float, float, float], band: str, size=(0.045, 0.075)) -> Mesh:
    image, d = labels.canvas(250, 150, "#ffffff")
    d.rectangle((0, 0, 250, 92), fill=band)
    labels.text(d, words, (10, 10, 240, 84), "bold")
    labels.text(d, "KEEP COLD", (8, 98, 150, 120), "bold", "#1f4f9c", align="left")
    labels.small_print(d, (8, 124, 130, 146), 2, "#777777")
    labels.barcode(d, (166, 102, 240, 144), np.random.default_rng(2))
    return chilled.sticker(size, at, image)


def on_tray(
    title: str,
    meshes: list[Mesh],
    width: float,
    length: float,
    dish: str,
    words: str,
    band: str,
    tag_at: tuple[float, float, float],
    mass: float,
    top: float,
    size=(0.045, 0.075),
) -> Model:
    """Meat on a foam tray with its label."""
    tray = chilled.tray(width, length, 0.024, plain(dish, 0.05, 200), 0.006)
    tag = price_tag(words, tag_at, band, size)
    solids = [box_piece((0, 0, 0.012), (width - 0.006, length - 0.006, 0.024))]
    solids.append(box_piece((0, 0, top / 2), (width * 0.72, length * 0.74, top)))
    return Model(
        title=title,
        parts={"body": Part([tray, *meshes, tag], collision=solids)},
        mass=mass,
        friction=0.5,
    )


def drumsticks(dish: str) -> Model:
    """Four chicken legs, side by side."""
    skin = Material(occlusion=0.7)
    c = skin.mottle("#f0c8a0", 0.1, 60)
    bumps = skin.remap(skin.voronoi(230), 0.1, 0.3, 0.35, 0)
    skin.colour(skin.mix(bumps, c, "d69a78"))
    bone = plain("#f6efe0", 0.05, 90)
    meshes = []
    for k in range(4):
        path = [
            (0, -0.052, 0.024),
            (0, -0.04, 0.025),
            (0, -0.015, 0.026),
            (0, 0.015, 0.022),
            (0, 0.04, 0.017),
            (0, 0.052, 0.016),
        ]
        leg = tube(path, np.array([0.008, 0.02, 0.0245, 0.018, 0.0105, 0.009]), 8, mat=skin)
        shank = tube([(0, 0.046, 0.016), (0, 0.07, 0.015)], [0.0065, 0.006], 6, mat=bone)
        knob = [
            ellipsoid((0.0075, 0.006, 0.0075), (s * 0.005, 0.071, 0.015), 5, 4, bone)
            for s in (-1, 1)
        ]
        x = (k - 1.5) * 0.036
        for mesh in (leg, shank, *knob):
            mesh.keep_pattern()
            if k % 2:
                mesh.turn(rz=math.pi)
            meshes.append(mesh.move(x))
    return on_tray(
        "raw chicken drumsticks in a tray",
        meshes,
        0.165,
        0.205,
        dish,
        "CHICKEN",
        "#e0a81c",
        (0.0, 0.0, 0.05),
        0.55,
        0.05,
    )


def whole_chicken(dish: str) -> Model:
    """A plucked bird on its back."""
    skin = Material(occlusion=0.7)
    c = skin.mottle("#f2cfa6", 0.09, 50)
    bumps = skin.remap(skin.voronoi(210), 0.1, 0.3, 0.35, 0)
    skin.colour(skin.mix(bumps, c, "d89c7a"))
    bone = plain("#f6efe0", 0.05, 90)
    body = ellipsoid((0.058, 0.085, 0.046), (0, 0, 0.05), 16, 10, skin)
    body.v[:, 0] *= 1 - 1.6 * (body.v[:, 1] - 0.02).clip(0)
    body.v[:, 2] += 0.012 * np.cos(body.v[:, 0] * 50) * (body.v[:, 2] > 0.06)
    meshes = [body]
    for s in (-1, 1):
        thigh = [
            (s * 0.052, 0.02, 0.04),
            (s * 0.06, 0.01, 0.052),
            (s * 0.052, 0.045, 0.06),
            (s * 0.032, 0.085, 0.062),
            (s * 0.028, 0.1, 0.06),
        ]
        meshes.append(tube(thigh, np.array([0.02, 0.028, 0.024, 0.013, 0.009]), 8, mat=skin))
        meshes.append(
            tube([(s * 0.028, 0.098, 0.06), (s * 0.026, 0.115, 0.058)], 0.0065, 6, mat=bone)
        )
        wing = [
            (s * 0.048, -0.06, 0.05),
            (s * 0.068, -0.04, 0.034),
            (s * 0.07, -0.01, 0.03),
            (s * 0.055, 0.005, 0.04),
        ]
        meshes.append(tube(wing, np.array([0.014, 0.014, 0.011, 0.006]), 7, mat=skin))
    return on_tray(
        "whole raw chicken on a tray",
        meshes,
        0.165,
        0.25,
        dish,
        "CHICKEN",
        "#e0a81c",
        (0.0, -0.015, 0.107),
        1.3,
        0.098,
        (0.04, 0.068),
    )


def pork_chops(dish: str) -> Model:
    """Chops with their bone and rim of fat, leaning on one another."""
    pink, fat = flesh("#e58a84", "#c86a64", "#f6dcd0", 5, 0.012), plain("#f6e6d4", 0.05, 70)
    bone = plain("#efe6d4", 0.06, 90)
    meshes = []
    for k in range(3):
        t = np.arange(20) * TAU / 20
        r = (
            1
            + 0.18 * np.cos(t - 0.5)
            + 0.1 * np.cos(2 * t + 0.7)
            - 0.14 * np.exp(-(((t - 2.7) / 0.5) ** 2))
        )
        shape = np.c_[0.042 * r * np.cos(t), 0.056 * r * np.sin(t)]
        rings = [
            np.c_[shape * q, np.full(20, z)]
            for q, z in ((0.96, 0), (1, 0.004), (1, 0.014), (0.93, 0.017), (0.9, 0.0165))
        ]
        chop = loft(rings, mats=[fat, pink], mat_of_face=lambda k, i: 0 if 0 <= k < 3 else 1)
        chop.bake_uv = None
        stick = tube(
            [(-0.03, -0.01, 0.0145), (-0.026, 0.016, 0.015), (-0.012, 0.03, 0.0145)],
            0.0055,
            6,
            mat=bone,
        )
        for mesh in (chop, stick):
            mesh.keep_pattern()
            meshes.append(
                mesh.turn(ry=-0.28, rz=0.12 * (k - 1)).move(
                    0.036 * (k - 1), 0.0, 0.016 + (0.004 if k else 0)
                )
            )
    return on_tray(
        "raw pork chops in a tray",
        meshes,
        0.16,
        0.18,
        dish,
        "PORK",
        "#d05a6a",
        (0.06, 0.058, 0.024),
        0.6,
        0.04,
        (0.036, 0.058),
    )


def roast(dish: str) -> Model:
    """A joint of beef in its net of string."""
    red, fat = flesh("#a8242c", "#74121c", "#f0d6c6", 7, 0.018), plain("#f4e4d2", 0.08, 60)
    string = plain("#f2ead8", 0.05, 100)
    ys = np.linspace(-0.09, 0.09, 11)
    rings = []
    for k, y in enumerate(ys):
        q = (1 - abs(y / 0.098) ** 4) ** 0.5 * (0.9 if k % 2 else 1.0)
        t = np.arange(16) * TAU / 16
        rings.append(np.c_[0.048 * q * np.cos(t), np.full(16, y), 0.042 + 0.038 * q * np.sin(t)])
    joint = loft(rings, mats=[red, fat], mat_of_face=lambda k, i: int(2 <= i <= 5))
    joint.bake_uv = None
    meshes = [joint]
    for k in range(1, 10, 2):
        t = np.arange(10) * TAU / 10
        q = (1 - abs(ys[k] / 0.098) ** 4) ** 0.5 * 0.93
        loop = np.c_[0.048 * q * np.cos(t), np.full(10, ys[k]), 0.042 + 0.038 * q * np.sin(t)]
        meshes.append(tube(loop, 0.0028, 3, closed=True, mat=string, weight=0.5))
    return on_tray(
        "raw beef joint tied with string",
        meshes,
        0.145,
        0.225,
        dish,
        "BEEF",
        "#b01c24",
        (0.0, 0.0, 0.0805),
        1.2,
        0.08,
        (0.036, 0.06),
    )


def diced(dish: str) -> Model:
    """A heap of cubes for stew."""
    red = flesh("#b4303a", "#84181f", "#f2d8ca", 9, 0.02)
    rng = np.random.default_rng(12)
    meshes = []
    for layer, spots in enumerate((18, 10, 4)):
        for k in range(spots):
            a, q = k * 2.4 + layer, math.sqrt((k + 0.5) / spots) * (0.85 - 0.27 * layer)
            s = float(rng.uniform(0.021, 0.026))
            cube = box(s, s * 1.1, s * 0.9, (0, 0, -s * 0.45), red).keep_pattern()
            cube.v += rng.normal(0, 0.0012, cube.v.shape)
            cube.turn(*rng.uniform(-0.3, 0.3, 2), rng.uniform(0, 3))
            meshes.append(
                cube.move(0.058 * q * math.cos(a), 0.085 * q * math.sin(a), 0.017 + 0.014 * layer)
            )
    return on_tray(
        "diced raw beef in a tray",
        meshes,
        0.15,
        0.21,
        dish,
        "BEEF",
        "#b01c24",
        (0.052, -0.07, 0.034),
        0.6,
        0.05,
        (0.036, 0.06),
    )


BLACK, WHITE = "#1f2124", "#f0efec"

MODELS = {
    "raw_meat": Maker(
        by_style(
            "raw_meat",
            {
                "tray": food_trays.raw_meat,
                "legs": drumsticks,
                "bird": whole_chicken,
                "chops": pork_chops,
                "roast": roast,
                "diced": diced,
            },
        ),
        food_trays.raw_meat_random,
        count=7,
        presets=[
            {"style": "tray", "kind": "steak"},
            {"style": "tray", "kind": "mince", "tray": "#f0efec"},
            {"style": "legs", "dish": WHITE},
            {"style": "bird", "dish": "#e0b83a"},
            {"style": "chops", "dish": BLACK},
            {"style": "roast", "dish": WHITE},
            {"style": "diced", "dish": BLACK},
        ],
    ),
}
