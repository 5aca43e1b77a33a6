"""Ladles and spatulas, lying as they come to rest."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import extrude, lathe, loft, rounded_rectangle, spline, tube

from makers.cutlery import handle_rings
from makers.ware import wall_profile


def stuff(kind: str, look: int) -> Material:
    """steel, wood, or a colour."""
    offset = noise_offset(np.random.default_rng(look))
    if kind == "wood":
        return wood("c99a5c", "8a5a2c", 0, 14, offset)
    if kind == "steel":
        return metal("c6cace", "858b91", (1, 12, 1), 60, offset, occlusion=0.5)
    return plain(kind, 0.05, 60, offset)


# radius and depth of the bowl, length and thickness of the handle, its form
LADLES = {
    "soup": (0.045, 0.038, 0.25, 0.0065, "hook"),
    "nylon": (0.047, 0.036, 0.23, 0.012, "flat"),
    "wooden": (0.036, 0.032, 0.22, 0.0085, "round"),
    "gravy": (0.028, 0.024, 0.15, 0.0055, "hook"),
    "wide": (0.062, 0.034, 0.3, 0.0095, "round"),
    "standing": (0.043, 0.044, 0.22, 0.006, "upright"),
}


def ladle(form="soup", head="steel", handle="steel", look=0) -> Model:
    """A ladle on its bowl and the end of its handle; the bowl towards +X, open upwards."""
    r, deep, length, thick, end = LADLES[form]
    mat, grip = stuff(head, look), stuff(handle, look + 1)
    outer = [(r * q, deep * z) for q, z in ((0.3, 0), (0.66, 0.16), (0.92, 0.55), (1, 1))]
    profile, kinds = wall_profile(outer, 0.004, 0.0045, 0.0005)
    bowl = lathe(profile, 18, mats=[mat] * 4, mat_of_segment=kinds)
    if form == "gravy":  # a lip on both sides
        bowl.warp(lambda x, y, z: (x, y * (1 + 0.35 * (z / deep) ** 2 * (abs(y) / r) ** 3), z))
    bowl.turn(ry=-0.16)
    bowl.v[:, 2] -= bowl.v[:, 2].min()
    top = float(bowl.v[bowl.v[:, 0] < -0.9 * r][:, 2].max()) - 0.003
    if end == "upright":  # the handle rises steeply and ends in a hook
        points = [
            (-r + 0.003, 0, top - 0.004),
            (-r - 0.02, 0, top + 0.05),
            (-r - 0.07, 0, top + length),
        ]
        points += [(-r - 0.095, 0, top + length + 0.008), (-r - 0.1, 0, top + length - 0.03)]
    else:
        points = [(-r + 0.003, 0, top), (-r - 0.012, 0, top + 0.012), (-r - 0.06, 0, top + 0.004)]
        points += [(-r - length, 0, thick + 0.001)]
        if end == "hook":
            points += [
                (-r - length - 0.018, 0, thick + 0.008),
                (-r - length - 0.012, 0, thick + 0.024),
            ]
    path = spline(points, 3)
    radii = np.full(len(path), thick)
    radii[:3] = min(thick, 0.0065)
    if end == "round":
        radii[-2:] = [thick * 1.25, thick * 0.7]
    bar = tube(
        path, radii, 8, mat=grip, up=(0, 1.0, 0), flatten=1.5 if end in ("flat", "hook") else 1
    )
    meshes = [bowl, bar]
    if end == "flat":
        hole = lathe([(0, 0), (0.006, 0), (0.006, 0.004), (0, 0.004)], 8, mat=plain("c8c0b4", 0.02))
        meshes.append(hole.move(-r - length + 0.018, 0, 2 * thick * 0.78))
    pieces = [cylinder_piece(0.4 * r, 0, deep + 0.006, 12, r)]
    if end == "upright":
        a, b = points[0], points[2]
    else:
        a, b = (-r, 0, top), (-r - length, 0, thick)
    corners = [
        (x, y, z + q) for x, _, z in (a, b) for y in (-thick, thick) for q in (-thick, thick)
    ]
    pieces.append(np.array(corners))
    return Model(
        f"{form} ladle",
        {"body": Part(meshes, collision=pieces)},
        mass=0.15 if form != "gravy" else 0.06,
        friction=0.5,
        texture_size=128,
    )


def ladle_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


def blade_outline(form: str) -> list[tuple[float, float]]:
    """Outline of a spatula's blade in xy, its neck at the origin, its front at +X."""
    if form == "scraper":
        edge = [(0, -0.014), (0.006, -0.024), (0.075, -0.029), (0.078, -0.026), (0.08, 0.012)]
        return [*edge, (0.074, 0.023), (0.062, 0.029), (0.006, 0.024), (0, 0.014)]
    if form == "wooden":
        return [
            (0, -0.012),
            (0.03, -0.024),
            (0.085, -0.031),
            (0.094, 0.029),
            (0.03, 0.024),
            (0, 0.012),
        ]
    if form == "burger":
        return [(0, -0.03), (0.012, -0.055), (0.1, -0.058), (0.1, 0.058), (0.012, 0.055), (0, 0.03)]
    if form == "fish":
        return [
            (0, -0.016),
            (0.03, -0.028),
            (0.12, -0.05),
            (0.15, 0.022),
            (0.14, 0.034),
            (0.03, 0.026),
            (0, 0.016),
        ]
    return [
        (0, -0.016),
        (0.018, -0.036),
        (0.095, -0.041),
        (0.1, -0.037),
        (0.1, 0.037),
        (0.095, 0.041),
        (0.018, 0.036),
        (0, 0.016),
    ]


# thickness of the blade, slots (x from, x to, distance, count), length of the handle, its rise
SPATULAS = {
    "turner": (0.004, (0.028, 0.085, 0.016, 4), 0.2, 0.035),
    "fish": (0.004, (0.035, 0.115, 0.015, 4), 0.16, 0.028),
    "scraper": (0.011, None, 0.19, 0.0),
    "wooden": (0.007, (0.03, 0.075, 0.014, 3), 0.21, 0.0),
    "burger": (0.004, None, 0.15, 0.04),
}


def spatula(form="turner", head="steel", handle="steel", look=0) -> Model:
    """A spatula on the edge of its blade and the end of its handle."""
    thick, slots, length, rise = SPATULAS[form]
    mat, grip = stuff(head, look), stuff(handle, look + 1)
    blade = extrude(blade_outline(form), thick, mat, bevel_width=0.0014 if thick > 0.005 else 0)
    meshes: list[Mesh] = [blade]
    if slots:
        x0, x1, gap, count = slots
        dark = plain("3a3630" if head != "#232427" else "9c948a", 0.03)
        for k in range(count):
            y = (k - (count - 1) / 2) * gap
            hole = rounded_rectangle(x1 - x0, 0.0066, 0.0032, 3)
            meshes.append(extrude(hole, thick + 0.001, dark).move((x0 + x1) / 2, y, -0.0005))
    tilt = math.atan2(rise, 0.12)
    front = float(blade.v[:, 0].max())
    for mesh in meshes:
        mesh.turn(ry=tilt, pivot=(front, 0, 0))
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for mesh in meshes:
        mesh.move(z=-low)
    z = float(blade.v[blade.v[:, 0] < blade.v[:, 0].min() + 0.004][:, 2].mean())
    end = 0.008
    if form == "wooden":
        rings = [
            (-length, 0.008, z),
            (-length + 0.01, 0.012, z),
            (-0.06, 0.0085, z),
            (0.02, 0.0135, z),
        ]
        meshes.append(loft(handle_rings(rings, 0.0135), mat=grip))
        z_end = z
    else:
        neck = stuff("steel", look) if handle != head or head == "steel" else mat
        z_end = end if rise else z
        a, b = np.array([0.012, 0, z]), np.array([-length, 0, z_end])
        shoulder = a * 0.62 + b * 0.38 + [0, 0, 0.3 * rise]
        shaft = spline([a, a * 0.85 + b * 0.15 + [0, 0, 0.2 * rise], shoulder], 3)
        meshes.append(tube(shaft, 0.0052, 6, mat=neck, up=(0, 1.0, 0)))
        stations = [
            shoulder,
            shoulder * 0.8 + b * 0.2,
            shoulder * 0.3 + b * 0.7,
            b,
            b - [0.006, 0, 0],
        ]
        widths = [0.007, 0.0095, 0.0105, 0.011, 0.006]
        meshes.append(tube(stations, widths, 8, mat=grip, up=(0, 0, 1.0), flatten=0.7))
    hole = lathe([(0, 0), (0.0045, 0), (0.0045, 0.003), (0, 0.003)], 8, mat=plain("c8c0b4", 0.02))
    meshes.append(hole.move(-length + 0.016, 0, z_end + 0.0062))
    high = max(float(m.v[:, 2].max()) for m in meshes)
    corners = [(-length, y, q) for y in (-0.01, 0.01) for q in (z_end - 0.007, z_end + 0.007)]
    corners += [(0, y, q) for y in (-0.01, 0.01) for q in (z - 0.005, min(z + 0.006, high))]
    return Model(
        f"{form} spatula" if form not in ("turner", "burger") else f"{form}, a spatula",
        {"body": Part(meshes, collision=[blade.v.copy(), np.array(corners)])},
        mass=0.09,
        friction=0.5,
        texture_size=128,
    )


def spatula_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


BLACK = "#232427"
MODELS = {
    "ladle": Maker(
        ladle,
        ladle_random,
        7,
        [
            {"form": "soup"},
            {"form": "nylon", "head": BLACK, "handle": BLACK},
            {"form": "wooden", "head": "wood", "handle": "wood"},
            {"form": "gravy"},
            {"form": "wide", "head": "steel", "handle": "wood"},
            {"form": "standing", "head": "#2f5f9a", "handle": "#2f5f9a"},
            {"form": "nylon", "head": "#c8302c", "handle": "#c8302c"},
        ],
    ),
    "spatula": Maker(
        spatula,
        spatula_random,
        8,
        [
            # Of one colour each: edge-on, a head below a handle of another is a blade to many.
            {"form": "turner", "head": "steel", "handle": "steel"},
            {"form": "turner", "head": BLACK, "handle": BLACK},
            {"form": "turner", "head": "#d8342c", "handle": "#d8342c"},
            {"form": "wooden", "head": "wood", "handle": "wood"},
            {"form": "fish", "head": BLACK, "handle": BLACK},
            {"form": "burger", "head": "#e8a01c", "handle": "#e8a01c"},
            {"form": "fish", "head": "#2d5f8a", "handle": "#2d5f8a"},
            {"form": "turner", "head": "#3aa0a8", "handle": "#3aa0a8"},
        ],
    ),
}
