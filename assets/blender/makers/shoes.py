"""Uppers and soles of shoes, sneakers and loafers (the categories: footwear.py)."""

from __future__ import annotations

import numpy as np
from labels import skins
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.shapes import (
    loft,
    tube,
)

# Stations from heel (0) to toe (1) of a shoe 0.28 m long.
STATIONS = np.array([0, 0.03, 0.13, 0.28, 0.42, 0.5, 0.63, 0.79, 0.92, 1.0])


_KEYS = [0, 0.012, 0.04, 0.1, 0.2, 0.35, 0.5, 0.65, 0.75, 0.85, 0.93, 0.98, 1]


HALF_WIDTH = np.interp(
    STATIONS,
    _KEYS,
    [0.0006, 0.016, 0.024, 0.031, 0.034, 0.034, 0.038, 0.045, 0.047, 0.044, 0.034, 0.020, 0.006],
)


CENTRE = np.interp(STATIONS, [0, 0.3, 0.5, 0.7, 0.9, 1], [0, 0, -0.001, 0, 0.006, 0.010])


SOLE_TOP = np.interp(STATIONS, [0, 0.3, 0.6, 0.85, 1], [0.028, 0.026, 0.021, 0.020, 0.024])


_ACROSS = 12  # faces across the upper


def upper(
    top: np.ndarray,
    opening_end: float,
    skin: Material,
    lining: Material,
    sole_top: np.ndarray | None = None,
) -> Mesh:
    """The shoe's upper: an open trough at the ankle that closes into the toe box.

    top: height of the rim (at the opening) or of the ridge, per station.
    """
    opening = np.interp(
        STATIONS, [0, 0.02, 0.09, 0.2, 0.32, 0.42, 0.5], [0.2, 0.5, 0.7, 0.74, 0.74, 0.66, 0.5]
    )
    us = np.linspace(0, 1, _ACROSS + 1)
    rings, is_open = [], opening_end > STATIONS
    sole_top = SOLE_TOP if sole_top is None else sole_top
    for k, t in enumerate(STATIONS):
        x, w, c, h, base = (
            (t - 0.5) * 0.28,
            HALF_WIDTH[k],
            CENTRE[k],
            top[k],
            sole_top[k] - 0.004,
        )
        if is_open[k]:
            rim = w * opening[k]
            side = []
            for f in np.linspace(0, 1, 4):
                bulge = 0.004 * min(1.0, w / 0.03) ** 2 * np.sin(np.pi * f)
                side.append((w + (rim * 1.02 - w) * f**1.6 + bulge, base + (h - base) * f))
            side += [(rim * 0.9, h - 0.002), (rim * 0.82, base + 0.012)]
            left = [(x, c - y, z) for y, z in side]
            right = [(x, c + y, z) for y, z in side[::-1]]
            rings.append(np.array([*left, (x, c, base + 0.010), *right]))
        else:
            arc = np.pi * us
            cos, sin = np.cos(arc), np.sin(arc)
            y = c - w * np.sign(cos) * np.abs(cos) ** (2 / 2.6)
            rings.append(
                np.c_[np.full(len(us), x), y, base + (h - base) * np.abs(sin) ** (2 / 2.2)]
            )
    inside = range(4, 8)

    def which(k: int, i: int) -> int:
        return (
            1
            if is_open[k]
            and i in (inside if is_open[min(k + 1, len(STATIONS) - 1)] else range(4, 8))
            else 0
        )

    mesh = loft(rings, mats=[skin, lining], closed=False, mat_of_face=which)
    for number, _ in enumerate(mesh.f):
        k, j = divmod(number, _ACROSS)

        def u(a: int, open_here: bool = bool(is_open[k])) -> float:
            if not open_here:
                return a / _ACROSS
            return a / 4 * 0.4 if a <= 4 else 0.6 + (a - 8) / 4 * 0.4 if a >= 8 else 0.5

        mesh.label_uv[number] = [
            (u(j), STATIONS[k]),
            (u(j + 1), STATIONS[k]),
            (u(j + 1), STATIONS[k + 1]),
            (u(j), STATIONS[k + 1]),
        ]
    return mesh.flip().weigh(1.25)


def sole_of(colour: str, stripe: str, tread: str, heel: float) -> Mesh:
    """The sole with a toe spring; `heel` raises the shoe's back (a leather shoe's heel block)."""
    t = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, 8))
    w = np.interp(
        t,
        [0, 0.04, 0.1, 0.2, 0.35, 0.5, 0.65, 0.75, 0.85, 0.93, 0.98, 1],
        [0.006, 0.027, 0.034, 0.037, 0.036, 0.040, 0.047, 0.050, 0.047, 0.037, 0.024, 0.003],
    )
    c = np.interp(t, [0, 0.3, 0.5, 0.7, 0.9, 1], [0, 0, -0.001, 0, 0.006, 0.010])
    x = (t - 0.5) * 0.29
    spring = 0.012 * np.clip((t - 0.78) / 0.22, 0, 1) ** 2
    arch = heel * np.clip((t - 0.27) / 0.06, 0, 1) * np.clip((0.6 - t) / 0.12, 0, 1)
    low = np.r_[spring + arch, (spring + arch)[::-1]]
    high_one = np.interp(t, [0, 0.3, 0.6, 0.85, 1], [0.030, 0.028, 0.023, 0.022, 0.026])
    high = np.r_[high_one, high_one[::-1]]
    outline = np.r_[np.c_[x, c - w], np.c_[x, c + w][::-1]]

    def ring(z: np.ndarray, factor: float) -> np.ndarray:
        return np.c_[outline * factor, z]

    middle = 0.5 * (low + high)
    rings = [
        ring(low, 0.98),
        ring(middle, 1.01),
        ring(middle + 0.004, 1.01),
        ring(high - 0.0005, 0.985),
    ]
    mats = [plain(colour, 0.04, 80), plain(stripe, 0.0), plain(tread, 0.1, 120)]
    return loft(rings, mats=mats, mat_of_face=lambda k, i: 1 if k == 1 else 0)


def sneaker(
    main: str, accent: str, cap: str, tongue: str, sole: str, lace: str, stripe: str
) -> list[Mesh]:
    keys = [0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.46, 0.5, 0.6, 0.7, 0.8, 0.88, 0.94, 0.98, 1]
    top = np.interp(
        STATIONS,
        keys,
        [
            0.094,
            0.095,
            0.090,
            0.076,
            0.070,
            0.079,
            0.090,
            0.089,
            0.076,
            0.061,
            0.050,
            0.045,
            0.040,
            0.032,
            0.024,
        ],
    )
    skin, lining = (
        printed(skins.sneaker(main, accent, cap, tongue, stripe)),
        plain("#5b6068", 0.1, 100),
    )
    meshes = [upper(top, 0.47, skin, lining), sole_of(sole, accent, "#3a3330", 0.0)]
    rings = []
    for t, z, w in (
        (0.6, 0.074, 0.013),
        (0.5, 0.093, 0.018),
        (0.42, 0.117, 0.02),
    ):
        x = (t - 0.5) * 0.28
        rings.append(
            [
                (x, -w, z - 0.003),
                (x, 0, z + 0.002),
                (x, w, z - 0.003),
                (x - 0.004, w, z - 0.008),
                (x - 0.005, 0, z - 0.005),
                (x - 0.004, -w, z - 0.008),
            ]
        )
    meshes.append(loft(rings, mat=plain(tongue, 0.06, 200)))
    string = plain(lace, 0.05, 300)
    for t in (0.51, 0.6, 0.69):
        x, z = (t - 0.5) * 0.28, float(np.interp(t, STATIONS, top)) + 0.0015
        half = float(np.interp(t, STATIONS, HALF_WIDTH)) * 0.42
        points = [(x - 0.004, -half, z - 0.009), (x, 0, z), (x - 0.004, half, z - 0.009)]
        meshes.append(tube(points, 0.004, 3, mat=string, up=(1, 0, 0), weight=0.8))
    return meshes


def loafer(leather: str, sole: str) -> list[Mesh]:
    keys = [0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.46, 0.5, 0.6, 0.7, 0.8, 0.88, 0.94, 0.98, 1]
    top = np.interp(
        STATIONS,
        keys,
        [
            0.083,
            0.084,
            0.079,
            0.066,
            0.058,
            0.056,
            0.06,
            0.072,
            0.07,
            0.058,
            0.049,
            0.044,
            0.039,
            0.032,
            0.025,
        ],
    )
    skin, lining = printed(skins.loafer(leather)), plain("#c2a078", 0.08, 90)
    rings = []
    for t, z, w in (
        (0.57, 0.072, 0.02),
        (0.5, 0.077, 0.024),
        (0.42, 0.078, 0.02),
    ):
        x = (t - 0.5) * 0.28
        rings.append(
            [
                (x, -w, z - 0.008),
                (x, 0, z + 0.002),
                (x, w, z - 0.008),
                (x - 0.003, w, z - 0.014),
                (x - 0.004, 0, z - 0.005),
                (x - 0.003, -w, z - 0.014),
            ]
        )
    return [
        upper(top, 0.5, skin, lining),
        sole_of(sole, shade(sole, 0.8), "#241c18", 0.007),
        loft(rings, mat=plain(shade(leather, 0.9), 0.05, 100)),
    ]
