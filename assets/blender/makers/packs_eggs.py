"""Egg cartons of four to twelve, and the open tray."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Joint, Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import box, lathe, loft

from makers import food_trays
from makers.pack_parts import by_style, tub_ring

PITCH_X, PITCH_Y = 0.049, 0.05


def pulp_of(colour: str, form: int) -> Material:
    pulp = Material()
    return pulp.colour(pulp.mottle(colour, 0.12, 220, noise_offset(np.random.default_rng(form))))


def half_egg(x: float, y: float, z: float, mat: Material, n: int = 6) -> Mesh:
    """The upper part of an egg; what is below the rim nobody sees."""
    profile = [(0, -0.002), (0.0205, -0.001), (0.0195, 0.012), (0.012, 0.0245), (0, 0.0295)]
    return lathe(profile, n, mat=mat, discs=False).move(x, y, z)


def places(rows: int, columns: int) -> list[tuple[float, float]]:
    return [
        ((i - (rows - 1) / 2) * PITCH_X, (j - (columns - 1) / 2) * PITCH_Y)
        for i in range(rows)
        for j in range(columns)
    ]


def box_of_eggs(rows: int, columns: int, colour: str, paper: str, ink: str, egg: str) -> Model:
    """A pulp box; the lid opens towards the back."""
    pulp, shell = pulp_of(colour, 3), plain(egg, 0.08, 260)
    sx, sy = rows * PITCH_X + 0.008, columns * PITCH_Y + 0.006
    rim, top = 0.042, 0.078
    count = rows * columns
    spots = places(rows, columns)
    base = [food_trays.tapered_box(sx, sy, rim - 0.008, rim, 0.001, pulp, 0.01)]
    edge = [(x, y) for x, y in spots if max(abs(x) / (sx / 2), 0) > 0.3]
    for x, y in edge:
        cup = [(0, 0), (0.0155, 0), (0.0235, rim - 0.005), (0, rim - 0.005)]
        base.append(lathe(cup, 5, mat=pulp, start=math.pi / 8).move(x, y))
    eggs = [half_egg(x, y, rim, shell) for x, y in spots]
    w, h = max(200, 44 * columns), 46 * rows + 80
    image, d = labels.canvas(w, h, paper)
    d.rectangle((6, 6, w - 6, h - 6), outline=ink, width=6)
    labels.text(d, f"{count} EGGS", (20, 14, w - 20, h * 0.55), "bold", ink)
    for i in range(4):
        x = w * (0.2 + 0.2 * i)
        d.ellipse((x - 15, h * 0.6, x + 15, h * 0.92), fill=egg, outline=ink, width=3)
    lid_z = [(rim + 0.0005, 0.0), (top - 0.008, 0.006), (top, 0.013)]
    outer = [tub_ring(sx, sy, 0.014, z, k, 3) for z, k in lid_z]
    inner = [
        tub_ring(sx - 0.01, sy - 0.01, 0.01, z - 0.004 * (i > 0), k, 3)
        for i, (z, k) in enumerate(lid_z)
    ]
    lid = loft([inner[2], inner[1], inner[0], *outer], mat=pulp)
    sticker = box(
        sx - 0.036,
        sy - 0.04,
        0.0025,
        (0, 0, top - 0.0002),
        pulp,
        labels={"+z": label(image)},
        weight=1.5,
    )
    tongue = box(0.004, 0.05, 0.016, (sx / 2 + 0.001, 0, rim - 0.012), pulp)
    walls = [box_piece((0, 0, top - 0.003), (sx - 0.02, sy - 0.02, 0.006))]
    walls += [
        box_piece((s * (sx / 2 - 0.006), 0, (rim + top) / 2), (0.008, sy - 0.006, top - rim))
        for s in (-1, 1)
    ]
    walls += [
        box_piece((0, s * (sy / 2 - 0.006), (rim + top) / 2), (sx - 0.006, 0.008, top - rim))
        for s in (-1, 1)
    ]
    return Model(
        title=f"egg carton, {count} eggs",
        parts={
            "body": Part(base, collision=[box_piece((0, 0, rim / 2), (sx * 0.94, sy * 0.96, rim))]),
            "eggs": Part(eggs, collision="none", occlusion="fixed"),
            "lid": Part([lid, sticker, tongue], joint="lid", collision=walls),
        },
        joints={"lid": Joint("revolute", (-sx / 2, 0, rim), (0, -1, 0), 0.0, 2.2)},
        mass=0.07 * count,
        friction=0.7,
        states=[
            {"state": "CLOSED", "joint": "lid", "max": 0.05},
            {"state": "OPEN", "joint": "lid", "min": 0.6, "parts": ["lid", "eggs"]},
        ],
    )


def egg_tray(rows: int, columns: int, colour: str, egg: str, missing: int = 0) -> Model:
    """A flat tray full of eggs, open above."""
    pulp, shell = pulp_of(colour, 4), plain(egg, 0.08, 260)
    sx, sy, rim = rows * PITCH_X + 0.012, columns * PITCH_Y + 0.012, 0.03
    slab = [
        tub_ring(sx, sy, 0.012, z, k, 3) for z, k in ((0, 0.004), (rim - 0.008, 0.0), (rim, 0.0))
    ]
    tray = loft(slab, mat=pulp)
    tray.bake_uv = None
    meshes = [tray]
    for i in range(rows + 1):
        for j in range(columns + 1):
            x, y = (i - rows / 2) * PITCH_X, (j - columns / 2) * PITCH_Y
            peak = [(0.011, 0), (0.004, 0.02), (0, 0.02)]
            meshes.append(
                lathe([(0, 0), *peak], 4, mat=pulp, start=0.785).move(
                    x * 0.97, y * 0.97, rim - 0.001
                )
            )
    spots = places(rows, columns)
    eggs = [half_egg(x, y, rim + 0.006, shell, 6) for x, y in spots[missing:]]
    hollows = []
    for x, y in spots[:missing]:
        hollows.append(
            lathe(
                [(0, 0), (0.017, 0), (0.017, 0.001), (0, 0.001)], 8, mat=plain("#6f6c62", 0.1)
            ).move(x, y, rim)
        )
    return Model(
        title=f"tray of {rows * columns - missing} eggs",
        parts={
            "body": Part(
                [*meshes, *hollows],
                collision=[box_piece((0, 0, 0.026), (sx - 0.008, sy - 0.008, 0.052))],
            ),
            "eggs": Part(eggs, collision="none", occlusion="fixed"),
        },
        mass=0.065 * (rows * columns - missing) + 0.05,
        friction=0.7,
    )


GREY = {"colour": "#a9a79c", "paper": "#f4e6b8", "ink": "#7a4a1c", "egg": "#d9a878"}
BLUE = {"colour": "#7fa0b8", "paper": "#ffffff", "ink": "#2d5f8a", "egg": "#f0e6d6"}
GREEN = {"colour": "#8fae84", "paper": "#fbf6e0", "ink": "#2f6a34", "egg": "#c98f60"}

MODELS = {
    "egg_carton": Maker(
        by_style(
            "egg_carton", {"six": food_trays.egg_carton, "box": box_of_eggs, "tray": egg_tray}
        ),
        food_trays.egg_carton_random,
        count=7,
        presets=[
            {"style": "six", "egg": "#d9a878"},
            {"style": "six", **BLUE},
            {"style": "box", "rows": 2, "columns": 5, **GREY},
            {"style": "box", "rows": 2, "columns": 6, **BLUE},
            {"style": "box", "rows": 2, "columns": 2, **GREEN},
            {"style": "tray", "rows": 3, "columns": 4, "colour": "#a9a79c", "egg": "#d9a878"},
            {"style": "box", "rows": 2, "columns": 5, **GREEN},
        ],
    ),
}
