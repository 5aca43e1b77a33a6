"""Big toy vehicles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, extrude, spline, tube

from makers.solids import grown, rod, solids, wheel


@dataclass
class Paints:
    body: Material
    second: Material
    dark: Material
    glass: Material
    lamp: Material
    red: Material
    paint: str
    second_paint: str


# Each draws a vehicle 0.28 m long without its wheels, and returns the wheels as
# (x, half track, radius, width) per axle.
def _truck(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    """A tipper."""
    body, dark, glass, lamp, tip = c.body, c.dark, c.glass, c.lamp, c.second
    meshes.append(box(0.27, 0.1, 0.022, (0, 0, 0.034), dark, 0.004))
    cabin = [(0.045, 0.052), (0.135, 0.052), (0.135, 0.098), (0.112, 0.148), (0.045, 0.148)]
    meshes.append(extrude(cabin, 0.124, mat=body, axis="y", bevel_width=0.005))
    meshes.append(
        extrude(
            [(0.062, 0.1), (0.118, 0.1), (0.105, 0.137), (0.062, 0.137)],
            0.127,
            mat=glass,
            axis="y",
        )
    )
    meshes.append(box(0.003, 0.098, 0.04, (0, 0, 0), glass).turn(ry=-0.43).move(0.1335, 0, 0.1))
    hopper = [(0.035, 0.066), (0.045, 0.138), (-0.15, 0.138), (-0.138, 0.066)]
    meshes.append(
        extrude(
            [(0.03, 0.06), (0.035, 0.07), (-0.136, 0.07), (-0.132, 0.06)],
            0.118,
            mat=tip,
            axis="y",
        )
    )
    for q in (-1, 1):
        meshes.append(
            extrude(hopper, 0.008, mat=tip, axis="y", bevel_width=0.0015).move(y=q * 0.06)
        )
        for x in (-0.1, -0.05, 0.0):
            meshes.append(box(0.01, 0.006, 0.062, (x, q * 0.065, 0.07), tip))
        meshes.append(box(0.005, 0.022, 0.018, (0.1355, q * 0.042, 0.062), lamp, 0.002))
    meshes.append(box(0.008, 0.12, 0.07, (0.0, 0, 0), tip).turn(ry=0.13).move(0.037, 0, 0.068))
    meshes.append(box(0.008, 0.12, 0.07, (0.0, 0, 0), tip).turn(ry=-0.16).move(-0.139, 0, 0.068))
    meshes.append(box(0.016, 0.12, 0.018, (0.14, 0, 0.038), dark, 0.003))
    return [(0.092, 0.06, 0.037, 0.026), (-0.088, 0.06, 0.037, 0.026)]


def _saloon(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    body, dark, glass, lamp, red = c.body, c.dark, c.glass, c.lamp, c.red
    side = spline(
        [
            (-0.14, 0.03),
            (-0.142, 0.062),
            (-0.128, 0.078),
            (-0.085, 0.083),
            (0.055, 0.08),
            (0.125, 0.066),
            (0.142, 0.05),
            (0.14, 0.03),
        ],
        2,
    )
    meshes.append(extrude(side, 0.116, mat=body, axis="y", bevel_width=0.007, segments=1))
    roof = [(-0.095, 0.078), (-0.07, 0.122), (0.012, 0.125), (0.062, 0.079)]
    meshes.append(extrude(roof, 0.098, mat=body, axis="y", bevel_width=0.006))
    meshes.append(
        extrude(
            [(-0.082, 0.084), (-0.064, 0.115), (-0.03, 0.117), (-0.03, 0.084)],
            0.101,
            mat=glass,
            axis="y",
        )
    )
    meshes.append(
        extrude(
            [(-0.022, 0.084), (-0.022, 0.117), (0.008, 0.118), (0.046, 0.084)],
            0.101,
            mat=glass,
            axis="y",
        )
    )
    meshes.append(box(0.003, 0.084, 0.05, (0, 0, 0), glass).turn(ry=-0.82).move(0.0545, 0, 0.086))
    meshes.append(box(0.003, 0.084, 0.038, (0, 0, 0), glass).turn(ry=0.5).move(-0.0935, 0, 0.084))
    number, draw = canvas(64, 64)
    draw.ellipse((2, 2, 61, 61), fill="#ffffff")
    text(draw, "7", (16, 10, 48, 54), "bold", "#1c1c20")
    meshes.append(
        box(
            0.036,
            0.119,
            0.036,
            (-0.03, 0, 0.036),
            body,
            labels={"-y": printed(number, c.paint), "+y": printed(number, c.paint)},
        )
    )
    meshes.append(box(0.1, 0.03, 0.0025, (0, 0, 0), c.second).turn(ry=0.13).move(0.086, 0, 0.071))
    meshes.append(box(0.076, 0.03, 0.0025, (-0.03, 0, 0.1238), c.second))
    for q in (-1, 1):
        meshes.append(ellipsoid((0.006, 0.012, 0.009), (0.137, q * 0.038, 0.055), 8, 5, lamp))
        meshes.append(box(0.005, 0.022, 0.011, (-0.141, q * 0.038, 0.052), red))
    meshes.append(box(0.014, 0.112, 0.014, (0.139, 0, 0.027), dark, 0.003))
    return [(0.085, 0.055, 0.032, 0.026), (-0.085, 0.055, 0.032, 0.026)]


def _bus(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    """A school or town bus with a row of windows."""
    w = 0.1
    meshes.append(box(0.28, w, 0.105, (0, 0, 0.026), c.body, 0.009))
    meshes.append(box(0.26, w - 0.012, 0.01, (0, 0, 0.13), c.second, 0.004))
    sign, draw = canvas(256, 64, "#1c1c20")
    text(draw, "BUS", (20, 6, 236, 58), "bold", "#ffd23a")
    for q in (-1, 1):
        for k in range(5):
            pane = box(0.04, 0.004, 0.04, (0.096 - 0.048 * k, q * w / 2, 0.08), c.glass)
            meshes.append(pane)
        meshes.append(box(0.27, 0.004, 0.012, (0, q * w / 2, 0.052), c.second))
        meshes.append(box(0.004, 0.02, 0.014, (0.139, q * 0.034, 0.042), c.lamp))
    meshes.append(box(0.004, w - 0.018, 0.046, (0.139, 0, 0.066), c.glass))
    meshes.append(box(0.005, 0.074, 0.018, (0.139, 0, 0.113), c.dark, labels={"+x": printed(sign)}))
    meshes.append(box(0.01, w, 0.012, (0.138, 0, 0.026), c.dark))
    return [(0.085, 0.044, 0.027, 0.02), (-0.08, 0.044, 0.027, 0.02)]


def _tractor(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    """Small wheels in front, huge ones behind, a roofed cab and a smoke stack."""
    meshes.append(box(0.13, 0.062, 0.06, (0.065, 0, 0.075), c.body, 0.009))
    meshes.append(box(0.004, 0.05, 0.045, (0.131, 0, 0.082), c.dark))
    meshes.append(box(0.16, 0.04, 0.04, (0.03, 0, 0.045), c.dark))
    meshes.append(box(0.1, 0.08, 0.03, (-0.055, 0, 0.075), c.body, 0.006))
    for x in (-0.1, -0.005):
        for q in (-1, 1):
            meshes.append(box(0.009, 0.009, 0.085, (x, q * 0.037, 0.1), c.dark))
    meshes.append(box(0.125, 0.1, 0.012, (-0.052, 0, 0.183), c.body, 0.004))
    meshes.append(box(0.03, 0.05, 0.03, (-0.07, 0, 0.105), c.dark, 0.005))
    ring = [
        (-0.016 + 0.006 * math.sin(a), 0.02 * math.cos(a), 0.142 + 0.018 * math.sin(a))
        for a in np.linspace(0, math.tau, 8, endpoint=False)
    ]
    meshes.append(tube(ring, 0.004, 4, closed=True, mat=c.dark))
    meshes.append(rod((0.085, 0, 0.13), (0.085, 0, 0.195), 0.0075, c.dark, 8))
    for q in (-1, 1):
        meshes.append(box(0.004, 0.014, 0.014, (0.131, q * 0.022, 0.118), c.lamp))
        arch = [
            (-0.06 + 0.078 * math.cos(a), 0.07 + 0.078 * math.sin(a))
            for a in np.linspace(0.5, 2.4, 6)
        ]
        arch += [(x * 0.93 - 0.004, z * 0.93) for x, z in arch[::-1]]
        meshes.append(extrude(arch, 0.034, mat=c.body, axis="y").move(y=q * 0.056))
    return [(0.095, 0.05, 0.036, 0.026), (-0.06, 0.066, 0.07, 0.036)]


def _racer(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    """An open racing car: long nose, wings, wheels outside the body."""
    side = [(-0.13, 0.03), (-0.13, 0.07), (-0.06, 0.078), (-0.03, 0.055), (0.02, 0.052)]
    side += [(0.135, 0.034), (0.135, 0.024), (-0.1, 0.022)]
    body = extrude(side, 0.05, mat=c.body, axis="y", bevel_width=0.005)
    meshes.append(body.warp(lambda x, y, z: (x, y * (1.15 - 3.2 * max(x, 0)), z)))
    meshes.append(box(0.1, 0.03, 0.034, (-0.045, 0.037, 0.022), c.body, 0.006))
    meshes.append(box(0.1, 0.03, 0.034, (-0.045, -0.037, 0.022), c.body, 0.006))
    meshes.append(box(0.026, 0.15, 0.006, (0.13, 0, 0.024), c.second))
    meshes.append(box(0.03, 0.12, 0.006, (-0.126, 0, 0.094), c.second))
    for q in (-1, 1):
        meshes.append(box(0.036, 0.006, 0.03, (-0.126, q * 0.06, 0.07), c.second))
        meshes.append(box(0.006, 0.006, 0.03, (-0.124, q * 0.018, 0.066), c.dark))
        for x in (0.085, -0.095):
            meshes.append(box(0.008, 0.08, 0.008, (x, q * 0.045, 0.034), c.dark))
    meshes.append(ellipsoid(0.017, (-0.018, 0, 0.074), 8, 6, c.second))
    meshes.append(box(0.006, 0.026, 0.008, (-0.001, 0, 0.07), c.dark))
    number, draw = canvas(64, 64)
    draw.ellipse((2, 2, 61, 61), fill="#ffffff")
    text(draw, "5", (16, 8, 48, 56), "bold", "#1c1c20")
    disc = box(0.036, 0.03, 0.004, (0, 0, 0), c.body, labels={"+z": printed(number, c.paint)})
    meshes.append(disc.turn(ry=0.15).move(0.05, 0, 0.0465))
    return [(0.085, 0.075, 0.031, 0.028), (-0.095, 0.075, 0.036, 0.034)]


def _fire_engine(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    """A box body with a ladder on the roof, blue lamps and the word FIRE."""
    w = 0.1
    cabin = [(0.06, 0.03), (0.138, 0.03), (0.138, 0.075), (0.125, 0.122), (0.06, 0.122)]
    meshes.append(extrude(cabin, w, mat=c.body, axis="y", bevel_width=0.004))
    words, draw = canvas(256, 72, c.paint)
    draw.rectangle((0, 58, 256, 72), fill="#f6f4ee")
    text(draw, "FIRE", (24, 4, 232, 54), "bold", "#f6f4ee")
    sides = {"-y": printed(words), "+y": printed(words)}
    meshes.append(box(0.195, w, 0.08, (-0.04, 0, 0.03), c.body, 0.0, labels=sides))
    for q in (-1, 1):
        meshes.append(box(0.045, 0.004, 0.032, (0.096, q * w / 2, 0.082), c.glass))
        meshes.append(box(0.012, 0.022, 0.016, (0.1, q * 0.03, 0.121), plain("#2f6ff0", 0)))
        meshes.append(box(0.004, 0.018, 0.014, (0.138, q * 0.034, 0.045), c.lamp))
        rail = rod((0.09, q * 0.02, 0.156), (-0.145, q * 0.02, 0.128), 0.0045, c.second, 4)
        meshes.append(rail)
    for k in range(7):
        x = 0.07 - 0.034 * k
        z = 0.128 + (x + 0.145) * 0.119
        meshes.append(rod((x, -0.02, z), (x, 0.02, z), 0.0035, c.second, 4))
    meshes.append(box(0.03, 0.06, 0.022, (-0.1, 0, 0.108), c.dark, 0.003))
    meshes.append(
        box(0.004, w - 0.02, 0.04, (0, 0, 0), c.glass).turn(ry=-0.27).move(0.133, 0, 0.078)
    )
    meshes.append(box(0.01, w, 0.014, (0.139, 0, 0.028), c.second))
    return [(0.092, 0.046, 0.028, 0.022), (-0.085, 0.046, 0.028, 0.022)]


def _digger(c: Paints, meshes: list[Mesh]) -> list[tuple]:
    """An excavator on wheels with its arm stretched forward."""
    meshes.append(box(0.19, 0.075, 0.03, (-0.035, 0, 0.04), c.dark, 0.004))
    meshes.append(box(0.13, 0.1, 0.045, (-0.06, 0, 0.072), c.body, 0.007))
    meshes.append(box(0.062, 0.05, 0.062, (-0.03, 0.025, 0.115), c.body, 0.005))
    meshes.append(box(0.004, 0.04, 0.045, (0.001, 0.025, 0.122), c.glass))
    meshes.append(box(0.045, 0.004, 0.042, (-0.03, 0.0505, 0.124), c.glass))
    for a, b, r in (
        ((-0.01, -0.02, 0.11), (0.07, -0.02, 0.19), 0.011),
        ((0.07, -0.02, 0.19), (0.125, -0.02, 0.09), 0.0095),
        ((0.01, -0.02, 0.1), (0.05, -0.02, 0.16), 0.005),
    ):
        meshes.append(rod(a, b, r, c.body if r > 0.006 else c.dark, 6))
    scoop = [(0.13, 0.1), (0.148, 0.05), (0.125, 0.03), (0.085, 0.04), (0.112, 0.055), (0.115, 0.1)]
    meshes.append(extrude(scoop, 0.06, mat=c.second, axis="y").move(y=-0.02))
    for k in (-1, 0, 1):
        meshes.append(box(0.016, 0.009, 0.007, (0.083, -0.02 + 0.022 * k, 0.036), c.dark))
    return [(0.045, 0.05, 0.034, 0.028), (-0.105, 0.05, 0.034, 0.028)]


KINDS = {
    "truck": _truck,
    "car": _saloon,
    "bus": _bus,
    "tractor": _tractor,
    "racing car": _racer,
    "fire engine": _fire_engine,
    "digger": _digger,
}


def toy_car(kind: str, length: float, paint: str, second: str, hub: str) -> Model:
    """A big plastic vehicle; it drives towards +X."""
    c = Paints(
        plain(paint, 0.03),
        plain(second, 0.03),
        plain("#26282b", 0.05),
        plain("#9cc9e2", 0.04, 20),
        plain("#fff3b8", 0.0),
        plain("#c8242c", 0.0),
        paint,
        second,
    )
    meshes: list[Mesh] = []
    axles = KINDS[kind](c, meshes)
    wheels, tyre, cap = [], plain("#232326", 0.06, 120), plain(hub, 0.03)
    for x, track, radius, wide in axles:
        n = 16 if radius > 0.06 else 12
        wheels += [wheel(radius, wide, tyre, cap, q, n).move(x, q * track, radius) for q in (-1, 1)]
    grown([*meshes, *wheels], length / 0.28)
    s = length / 0.28
    high = [m for m in meshes if m.v[:, 2].mean() > 0.11 * s]
    low = [m for m in meshes if not m.v[:, 2].mean() > 0.11 * s]
    pieces = solids(low, *([m for m in wheels if m.v[:, 0].mean() * q > 0] for q in (-1, 1)))
    if high:
        pieces += solids(high)
    return Model(f"toy {kind}", {"body": Part(meshes + wheels, collision=pieces)}, 0.4, 0.4)


def toy_car_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "car",
        "length": 0.27,
        "paint": pick(rng, ["#d8303a", "#2f6fc0", "#2f9a5a"]),
        "second": pick(rng, ["#f6f4ee", "#f2c52a"]),
        "hub": pick(rng, ["#e8e8e6", "#f2c52a"]),
    }


MODELS = {
    "toy_car": Maker(
        toy_car,
        toy_car_random,
        9,
        [
            {"paint": "#d8303a", "second": "#f6f4ee"},
            {"kind": "truck", "paint": "#e8b92c", "second": "#2f6fc0"},
            {"paint": "#2f6fc0", "second": "#f2c52a"},
            {"kind": "bus", "paint": "#f2b01c", "second": "#26282b", "length": 0.3},
            {"kind": "tractor", "paint": "#2f8a3a", "second": "#e8c22c", "hub": "#f2c52a"},
            {"kind": "racing car", "paint": "#d8202c", "second": "#f6f4ee", "length": 0.25},
            {"kind": "fire engine", "paint": "#d01c20", "second": "#e8e8e6", "length": 0.37},
            {"kind": "digger", "paint": "#f2b01c", "second": "#5a5e62", "hub": "#f2b01c"},
            {"kind": "tractor", "paint": "#c8242c", "second": "#e8c22c", "hub": "#f6f4ee"},
        ],
    ),
}
