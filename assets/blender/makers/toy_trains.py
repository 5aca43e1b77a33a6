"""Toy trains."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, plain, wood
from toolkit.materials import label as printed
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, extrude, lathe, tube

from makers.solids import cylinder, rod, solids


def _wheels(xs, y: float, radius: float, rim: Material, hub: Material, n: int = 10) -> list[Mesh]:
    """Thin wheels on both sides."""
    out = []
    for x in xs:
        for q in (-1, 1):
            profile = [(0, -0.005), (radius, -0.005), (radius, 0.006), (0, 0.004)]
            one = lathe(profile, n, mats=[rim, hub], mat_of_segment=[0, 0, 1])
            out.append(one.turn(rx=-q * math.pi / 2).move(x, q * y, radius))
    return out


def _engine(red: Material, blue: Material, yellow: Material, dark: Material) -> list[Mesh]:
    """A steam engine with a cab, a boiler, a funnel and a cow-catcher; from x = 0 to 0.155."""
    boiler = lathe([(0, -0.042), (0.026, -0.042), (0.026, 0.04), (0.021, 0.044), (0, 0.044)], 14)
    boiler.mats = [blue]
    funnel = lathe([(0.008, 0), (0.009, 0.022), (0.017, 0.038), (0.013, 0.04), (0, 0.034)], 10)
    funnel.mats = [dark]
    nose = [(0.148, 0.012), (0.17, 0.008), (0.148, 0.034)]
    return [
        box(0.14, 0.058, 0.016, (0.085, 0, 0.018), red, 0.003),
        box(0.05, 0.058, 0.072, (0.04, 0, 0.034), red, 0.004),
        box(0.064, 0.068, 0.01, (0.04, 0, 0.104), blue, 0.003),
        box(0.028, 0.0595, 0.028, (0.04, 0, 0.066), plain("#bfe3f2", 0.03)),
        boiler.turn(ry=math.pi / 2).move(0.105, 0, 0.058),
        funnel.move(0.128, 0, 0.08),
        ellipsoid((0.012, 0.012, 0.012), (0.09, 0, 0.084), 8, 5, yellow),
        cylinder(0.009, 0.006, (0.148, 0, 0.068), yellow, 8, "x"),
        extrude(nose, 0.046, mat=dark, axis="y"),
    ]


def _wagon(x: float, length: float, side: Material, floor: Material) -> list[Mesh]:
    """An open wagon."""
    meshes = [box(length, 0.056, 0.014, (x, 0, 0.018), floor, 0.002)]
    for q in (-1, 1):
        meshes.append(box(length, 0.006, 0.022, (x, q * 0.025, 0.032), side))
        meshes.append(box(0.006, 0.044, 0.022, (x + q * (length / 2 - 0.003), 0, 0.032), side))
    return meshes


def _coach(x: float, length: float, paint: str, band: str, nose: int = 0) -> list[Mesh]:
    """A passenger coach with windows drawn on; nose +1 or -1: a streamlined end."""
    side, draw = canvas(256, 96, paint)
    draw.rectangle((0, 66, 256, 80), fill=band)
    for k in range(5):
        draw.rounded_rectangle((12 + 48 * k, 16, 48 + 48 * k, 54), 6, fill="#1d2a38")
        draw.line((20 + 48 * k, 50, 34 + 48 * k, 20), fill="#7fb4d8", width=6)
    skin = printed(side)
    a, b = x - length / 2, x + length / 2
    body = box(
        length, 0.058, 0.062, (x, 0, 0.02), plain(paint, 0.02), 0, 1, {"+y": skin, "-y": skin}
    )
    meshes = [body, box(length - 0.01, 0.044, 0.008, (x, 0, 0.081), plain("#c9cdd1", 0.04), 0.003)]
    if nose:
        p = [(0, 0.02), (0, 0.085), (0.03, 0.074), (0.062, 0.045), (0.066, 0.026), (0.06, 0.02)]
        head = extrude(p, 0.058, mat=plain(paint, 0.02), axis="y", bevel_width=0.004)
        pane = box(0.03, 0.046, 0.004, (0, 0, 0), plain("#1d2a38", 0)).turn(ry=0.74)
        strip = box(0.01, 0.0595, 0.008, (0.03, 0, 0.034), plain(band, 0)).scale(4, 1, 1)
        for m in (head, pane.move(0.046, 0, 0.063), strip.move(-0.098, 0, 0)):
            if nose < 0:
                m.turn(rz=math.pi)
            meshes.append(m.move(b if nose > 0 else a))
    return meshes


def line_normals(line: np.ndarray) -> np.ndarray:
    """To the right of a closed line at each of its points."""
    ahead = np.roll(line, -1, 0) - np.roll(line, 1, 0)
    return np.c_[ahead[:, 1], -ahead[:, 0]] / np.linalg.norm(ahead, axis=1)[:, None]


def _ring(line: np.ndarray, half: float, height: float, mat: Material):
    """A flat band along a closed line, and its convex pieces."""
    profile = [(-half, 0), (-half, height), (half, height), (half, 0)]
    ends = [
        (*(p + q * d), z) for p, q in zip(line, line_normals(line), strict=True) for d, z in profile
    ]
    n = len(line)
    faces = [
        (i * 4 + k, (i + 1) % n * 4 + k, (i + 1) % n * 4 + (k + 1) % 4, i * 4 + (k + 1) % 4)
        for i in range(n)
        for k in range(4)
    ]
    mesh = cube_project(Mesh(ends, faces, None, [mat]).outward()).flat()
    corners = np.array(ends + ends[:4])
    return mesh, [corners[4 * i : 4 * i + 12] for i in range(0, n, 2)]


def toy_train(kind: str, first: str, second: str, third: str) -> Model:
    """'freight' (engine and a wagon of blocks), 'engine' alone, 'express' (streamlined set),
    'track' (on an oval of rails), 'long' (engine and three wagons) or 'tram'."""
    red, blue, yellow = plain(first, 0.05), plain(second, 0.05), plain(third, 0.05)
    dark, beech = plain("#2a2a2c", 0.05), plain("#d8b27c", 0.1, 60)
    meshes: list[Mesh] = []
    pieces: list[np.ndarray] = []
    if kind == "express":
        white = first
        meshes += _coach(0.09, 0.16, white, second, 1) + _coach(-0.1, 0.17, white, second, -1)
        meshes.append(box(0.04, 0.044, 0.05, (0.0, 0, 0.024), dark))
        meshes += _wheels((-0.15, -0.05, 0.05, 0.13), 0.024, 0.014, dark, dark, 8)
        halves = ([m for m in meshes if q * m.v[:, 0].mean() > 0] for q in (-1, 1))
        pieces = solids(*halves)
    elif kind == "tram":
        meshes += _coach(0.0, 0.22, first, third)
        front, draw = canvas(128, 128, first)
        draw.rounded_rectangle((14, 18, 114, 74), 8, fill="#1d2a38")
        text(draw, "7", (50, 80, 78, 112), "bold", third)
        for x in (18, 94):
            draw.ellipse((x, 86, x + 18, 104), fill="#fff3b8")
        for q in (-1, 1):
            end = box(
                0.014,
                0.056,
                0.058,
                (q * 0.115, 0, 0.022),
                plain(first, 0.02),
                0,
                1,
                {"+x" if q > 0 else "-x": printed(front)},
            )
            meshes.append(end)
            meshes.append(rod((q * 0.03, 0, 0.088), (0, 0, 0.112), 0.003, dark, 4))
            meshes.append(rod((q * 0.03, 0, 0.136), (0, 0, 0.112), 0.003, dark, 4))
        meshes.append(box(0.012, 0.07, 0.005, (0.03, 0, 0.135), dark))
        meshes.append(box(0.012, 0.07, 0.005, (-0.03, 0, 0.135), dark))
        meshes += _wheels((-0.07, -0.035, 0.035, 0.07), 0.024, 0.015, dark, dark, 8)
        pieces = solids(meshes[:4])
    else:
        meshes += _engine(red, blue, yellow, dark)
        meshes += _wheels(
            (0.13, 0.09, 0.04), 0.033, 0.019, dark, yellow, 10 if kind == "engine" else 8
        )
        pieces = solids(meshes[:4], meshes[4:])
        at = {"engine": [], "freight": [-0.085], "long": [-0.085, -0.24, -0.395], "track": [-0.085]}
        length = 0.12
        for k, x in enumerate(at[kind]):
            wagon = _wagon(x, length, (blue, yellow, red)[k % 3], beech)
            meshes.append(box(0.045, 0.008, 0.008, (x + length / 2 + 0.014, 0, 0.022), dark))
            if k == 1:
                log = cylinder(
                    0.012, length - 0.02, (x - length / 2 + 0.01, 0, 0.044), beech, 8, "x"
                )
                wagon += [log.copy().move(y=-0.012), log.copy().move(y=0.012), log.move(z=0.02)]
            else:
                for dx, dy, colour, turn in (
                    (-0.032, -0.008, red, 0.1),
                    (0.0, 0.006, yellow, 0.5),
                    (0.032, -0.006, blue, -0.2),
                ):
                    block = box(0.026, 0.026, 0.026, (0, 0, 0), colour).turn(rz=turn)
                    wagon.append(block.move(x + dx, dy, 0.032))
            pieces += solids(wagon)
            meshes += wagon + _wheels((x - 0.035, x + 0.035), 0.031, 0.016, red, yellow, 8)
        if kind == "engine":
            for mesh in meshes:
                mesh.scale(1.5)
            pieces = [p * 1.5 for p in pieces]
    if kind == "track":
        rails = wood("d8b27c", "b98a52", 0, 12)
        for mesh in meshes:
            mesh.move(-0.02, -0.2, 0.012)
        pieces = [np.add(p, (-0.02, -0.2, 0.012)) for p in pieces]
        t = np.linspace(0, math.tau, 32, endpoint=False)  # straights joined by half circles
        line = np.c_[np.sign(np.round(np.cos(t), 6)) * 0.13 + 0.2 * np.cos(t), 0.2 * np.sin(t)]
        rail, parts = _ring(line, 0.034, 0.012, rails)
        meshes.append(rail)
        pieces += parts
        for shift in (-0.02, 0.02):
            groove = line + shift * line_normals(line)
            path = np.c_[groove, np.full(len(line), 0.0125)]
            meshes.append(tube(path, 0.0035, 3, closed=True, mat=plain("#7a5530", 0.05)))
    if kind != "engine":
        low = min(m.v[:, 2].min() for m in meshes)
        for mesh in meshes:
            mesh.move(z=-low)
    return Model(
        "wooden toy train" if kind not in ("express", "tram") else f"toy {kind}",
        {"body": Part(meshes, collision=pieces)},
        mass=0.45,
        friction=0.4,
        texture_size=256 if kind in ("express", "tram") else 128,
    )


def toy_train_random(rng: np.random.Generator) -> dict:
    first, second, third = pick(
        rng, [("#c8302c", "#2f6fb0", "#f2c238"), ("#2f8a5a", "#c8402c", "#f2c238")]
    )
    return {"kind": "freight", "first": first, "second": second, "third": third}


MODELS = {
    "toy_train": Maker(
        toy_train,
        toy_train_random,
        7,
        [
            {"first": "#c8302c", "second": "#2f6fb0", "third": "#f2c238"},
            {"first": "#2f8a5a", "second": "#c8402c", "third": "#f2c238"},
            {"kind": "engine", "first": "#c8302c", "second": "#26282b", "third": "#f2c238"},
            {"kind": "express", "first": "#f4f4f2", "second": "#c8242c", "third": "#f2c238"},
            {"kind": "track", "first": "#2f6fb0", "second": "#c8302c", "third": "#f2c238"},
            {"kind": "long", "first": "#2f8a5a", "second": "#c8302c", "third": "#f2c238"},
            {"kind": "engine", "first": "#2f6fb0", "second": "#2f8a5a", "third": "#f2c238"},
        ],
    ),
}
