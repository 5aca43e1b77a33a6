"""Scissors of many trades: kitchen, nail, tailor's, children's; open or closed. Points to +X."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Model, Part
from toolkit.shapes import extrude, lathe, spline, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners
from makers.cutlery import scissors
from makers.knives import NO_SHADOW

# blade length and half width, tip; angle between the halves; per half: ring radii along x and y,
# its middle; thickness of the rings' tube
KINDS = {
    "kitchen": (
        0.095,
        0.0115,
        "point",
        7,
        ((0.03, 0.017), (0.022, 0.016)),
        (-0.082, 0.024),
        0.0058,
    ),
    "nail": (
        0.026,
        0.0042,
        "point",
        26,
        ((0.0125, 0.0105), (0.0125, 0.0105)),
        (-0.05, 0.0125),
        0.0026,
    ),
    "tailor": (
        0.145,
        0.0155,
        "point",
        15,
        ((0.04, 0.018), (0.022, 0.018)),
        (-0.092, 0.027),
        0.0062,
    ),
    "child": (
        0.056,
        0.0095,
        "round",
        44,
        ((0.022, 0.017), (0.022, 0.017)),
        (-0.052, 0.021),
        0.0056,
    ),
    "paper": (0.115, 0.01, "point", 55, ((0.027, 0.0165), (0.021, 0.0165)), (-0.07, 0.024), 0.005),
}


def blade_outline(length: float, w: float, tip: str) -> list[tuple[float, float]]:
    """One blade from above, its cutting edge towards -y, the pivot at the origin."""
    if tip == "round":
        end = [(length - 0.4 * w, -0.45 * w), (length, 0.1 * w), (length - 0.4 * w, 0.7 * w)]
        top = [(length * 0.5, w)]
    else:
        end = [(length, -0.1 * w)]
        top = [(length * 0.6, 0.8 * w)]
    back = [(0.0, w), (-0.35 * w - 0.01, 1.15 * w), (-0.35 * w - 0.012, 0.2 * w)]
    return [*end, *top, *back, (0, -0.65 * w), (0.3 * length, -0.6 * w)]


def tall(points: np.ndarray, z0: float, z1: float) -> np.ndarray:
    """A blade's outline between two heights, so that a falling blade slips through nothing."""
    corners = few_corners(points * np.array([1, 1, 0]) + np.array([0, 0, z0]), 14)
    return np.concatenate([corners, corners + np.array([0, 0, z1 - z0])])


def shears(kind: str, colour: str, second: str) -> Model:
    """Scissors of a kind; `colour` "steel": handles of metal."""
    length, w, tip, angle, rings, (cx, cy), t = KINDS[kind]
    steel = metal("c3c7cb", "868c92", (30, 2, 1), 25, occlusion=0.4)
    edge = plain("eceef0", 0.02, occlusion=0.4)
    grips = [
        metal("c3c7cb", "868c92") if c == "steel" else plain(c, 0.06, 150) for c in (colour, second)
    ]
    blades: list[Mesh] = []
    handles: list[Mesh] = []
    thick = max(0.0022, 0.2 * w)
    for half, side in ((0, 1), (1, -1)):
        a, c = rings[half]
        x = cx + (0.0 if half == 0 else rings[0][0] - a)
        turn = np.arange(14) * 2 * math.pi / 14
        ring = np.c_[x + a * np.cos(turn), cy + c * np.sin(turn) - 0.1 * a * np.cos(turn), 0 * turn]
        loop = tube(ring, t, 6, closed=True, mat=grips[half], up=(0, 0, 1.0))
        path = spline(
            [(0.2 * x, 0.7 * w, 0), (0.5 * (x + a), 0.9 * w, 0), (x + 0.92 * a, cy - 0.3 * c, 0)], 2
        )
        shank = tube(
            path, t * np.linspace(0.95, 1.15, len(path)), 6, mat=grips[half], up=(0, 0, 1.0)
        )
        outline = blade_outline(length, w, tip)
        blade = extrude(outline, thick, steel)
        ground = [(length * 0.98, -0.12 * w), (0.3 * length, -0.62 * w), (0, -0.66 * w)]
        ground += [(0, -0.38 * w), (0.3 * length, -0.3 * w)]
        shine = extrude(ground, thick + 0.0002, edge).move(z=-0.0001)
        for mesh in (blade, shine, loop, shank):
            if mesh in (loop, shank):
                mesh.move(z=thick / 2)
            if side < 0:
                mesh.scale(1, -1, 1)
            mesh.turn(rz=-side * math.radians(angle / 2)).move(z=t + (thick if half == 0 else 0))
        blades += [blade, shine]
        handles += [loop, shank]
    r = max(0.003, 0.42 * w)
    screw = lathe([(0, 0), (r, 0), (r, 0.0012), (0.75 * r, 0.002), (0, 0.0022)], 10)
    screw.mats = [metal("aeb2b6", "6a6f74")]
    blades.append(screw.move(z=t + 2 * thick))
    pieces = [few_corners(m.v) for m in handles]
    hulls = [tall(m.v, 0.5 * t, t + 2 * thick) for m in (blades[0], blades[2])]
    return Model(
        f"{kind} scissors",
        {
            "handles": Part(handles, collision=pieces, occlusion="handles"),
            "blades": Part(
                blades,
                rgba=NO_SHADOW,
                collision=hulls,
                occlusion="blades",
            ),
        },
        mass={"nail": 0.03, "child": 0.05, "tailor": 0.2}.get(kind, 0.12),
        friction=0.5,
        texture_size=128,
    )


def scissors_form(shape: str, colour: str, second: str) -> Model:
    """Scissors: the half-open household ones, or another kind of KINDS."""
    if shape == "household":
        made = scissors(0.20864430946144227, 20.648568774085433, colour, 947838364)
        handles, blades = made.parts["handles"], made.parts["blades"]
        handles.collision = [few_corners(m.v) for m in handles.meshes]
        blades.collision = [tall(blades.meshes[k].v, 0.001, 0.009) for k in (0, 2)]
        return made
    return shears(shape, colour, second)


MODELS = {
    "scissors": maker(
        scissors_form,
        ("shape", "colour", "second"),
        [
            ("household", "#e8641e", ""),
            ("household", "#26262a", ""),
            ("household", "#2b62c4", ""),
            ("kitchen", "#c8202c", "#26282c"),
            ("nail", "steel", "steel"),
            ("tailor", "#1c1c20", "#1c1c20"),
            ("child", "#f2c21e", "#2f9ad8"),
            ("paper", "#7a3fb0", "#7a3fb0"),
        ],
    ),
}
