"""Game controllers."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.shapes import box, ellipsoid, extrude, rounded_rectangle, spline, tube

from makers.solids import cylinder, grounded, rod, solids

BUTTONS = ("#2fa04a", "#d8202c", "#f2b81c", "#2f7fe0")


def _stick(x: float, y: float, z: float, base: str) -> list[Mesh]:
    dark = plain("#3a3d43", 0.03)
    return [
        cylinder(0.0135, 0.003, (x, y, z - 0.001), plain(base, 0), 12),
        cylinder(0.005, 0.011, (x, y, z), dark, 6),
        cylinder(0.0095, 0.006, (x, y, z + 0.008), dark, 12, top=0.0085),
    ]


def _cross(x: float, y: float, z: float, size: float, paint: str) -> list[Mesh]:
    m = plain(paint, 0.03)
    return [
        box(size, size * 0.34, 0.005, (x, y, z - 0.001), m),
        box(size * 0.34, size, 0.005, (x, y, z - 0.001), m),
    ]


def _diamond(x: float, y: float, z: float, pitch: float, radius: float) -> list[Mesh]:
    spots = ((1, 0), (0, 1), (-1, 0), (0, -1))
    return [
        cylinder(radius, 0.006, (x + pitch * a, y + pitch * b, z - 0.001), plain(c, 0.02), 9)
        for (a, b), c in zip(spots, BUTTONS, strict=True)
    ]


def _pad(paint: str, trim: str, wide: float = 1.0) -> list[Mesh]:
    """A gamepad with two grips; the player sits at +X."""
    half = [
        (-0.036, 0.0),
        (-0.036, 0.028),
        (-0.042, 0.05),
        (-0.034, 0.068),
        (-0.008, 0.078),
        (0.03, 0.08),
        (0.056, 0.073),
        (0.062, 0.06),
        (0.05, 0.048),
        (0.026, 0.034),
        (0.02, 0.02),
        (0.02, 0.0),
    ]
    outline = half + [(x, -y) for x, y in half[-2:0:-1]]
    curve = spline([(x, y * wide) for x, y in outline], 1, closed=True)
    body = extrude(curve, 0.036, mat=plain(paint, 0.03), bevel_width=0.009)
    body.warp(lambda x, y, z: (x, y, z - (0.35 * max(0, x - 0.01)) * (z > 0.018)))
    z, dark = 0.036, shade_hex(paint)
    meshes = [body]
    meshes += _stick(-0.008, -0.052, z, dark) + _stick(0.012, 0.024, z - 0.001, dark)
    meshes += _cross(0.012, -0.024, z, 0.022, trim) + _diamond(-0.01, 0.052, z, 0.0125, 0.0062)
    meshes.append(cylinder(0.008, 0.003, (-0.026, 0, z - 0.0005), plain("#f4f4f2", 0), 10))
    for q in (-1, 1):
        meshes.append(box(0.005, 0.009, 0.003, (-0.012, q * 0.015, z - 0.001), plain(trim, 0)))
        trigger = box(0.016, 0.032, 0.02, (-0.04, q * 0.052, 0.013), plain(trim, 0.03), 0.004)
        meshes.append(trigger)
    return meshes


def shade_hex(colour: str) -> str:
    """Darker, as text."""
    return "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, 0.6))


def _cable(points, paint: str = "#26282c") -> Mesh:
    return tube(spline(points, 2), 0.0032, 4, mat=plain(paint, 0))


def game_controller(kind: str, paint: str, trim: str) -> Model:
    """'pad', 'cable' (a pad with its cable), 'retro' (a flat one), 'stick' (of an arcade), 'two'
    (coloured halves in a grip), 'dock' (upright in its charger) or 'wheel' (for racing)."""
    if kind in ("pad", "cable", "dock"):
        meshes = _pad(paint, trim)
        pieces = solids(meshes)
        if kind == "cable":
            line = [(-0.03, 0, 0.018), (-0.07, 0.01, 0.004), (-0.1, 0.06, 0.004)]
            line += [(-0.085, 0.12, 0.004), (-0.03, 0.13, 0.004), (0.0, 0.15, 0.004)]
            meshes.append(_cable(line))
            meshes.append(
                box(0.03, 0.013, 0.007, (0.012, 0.157, 0.001), plain("#26282c", 0), 0.001)
            )
        if kind == "dock":
            for mesh in meshes:
                mesh.keep_pattern().turn(ry=1.15).move(0.0, 0, 0.105)
            stand = [box(0.1, 0.1, 0.014, (0, 0, 0), plain("#17181a", 0.03), 0.005)]
            stand.append(box(0.02, 0.06, 0.05, (-0.004, 0, 0.012), plain("#17181a", 0.03), 0.004))
            stand.append(box(0.003, 0.07, 0.004, (0.0495, 0, 0.005), plain("#3ad0ff", 0)))
            pieces = solids(meshes, stand)
            meshes += stand
    elif kind == "retro":
        body = plain(paint, 0.03)
        meshes = [box(0.055, 0.13, 0.018, (0, 0, 0), body, 0.004)]
        meshes.append(box(0.042, 0.116, 0.002, (0, 0, 0.0175), plain(trim, 0.03)))
        meshes += _cross(0.002, -0.036, 0.019, 0.027, "#17181a")
        for k in (0, 1):
            meshes.append(
                cylinder(0.0088, 0.006, (0.008, 0.026 + 0.023 * k, 0.018), plain("#d8202c"), 12)
            )
            pill = box(
                0.005, 0.013, 0.004, (0.01, -0.008 + 0.017 * k, 0.018), plain("#55595f"), 0.001
            )
            meshes.append(pill)
        line = [(-0.026, 0, 0.009), (-0.06, 0.0, 0.004), (-0.085, 0.04, 0.004)]
        meshes.append(_cable([*line, (-0.07, 0.085, 0.004), (-0.1, 0.11, 0.004)], "#55595f"))
        pieces = solids(meshes[:3])
    elif kind == "stick":
        side = [(-0.1, 0), (0.1, 0), (0.1, 0.045), (-0.1, 0.065)]
        case = extrude(side, 0.28, mat=plain(paint, 0.04), axis="y", bevel_width=0.005)
        meshes = [case, cylinder(0.024, 0.006, (0, -0.08, 0.053), plain("#17181a"), 12)]
        meshes.append(rod((0, -0.08, 0.055), (0, -0.08, 0.11), 0.006, plain("#b4b9be"), 6))
        meshes.append(ellipsoid(0.02, (0, -0.08, 0.12), 10, 7, plain("#d8202c", 0.02)))
        for k in range(6):
            x, y = 0.024 - 0.048 * (k // 3), 0.01 + 0.045 * (k % 3)
            spot = cylinder(
                0.017,
                0.009,
                (x, y, 0.0535 - 0.1 * x),
                plain((*BUTTONS, "#f4f4f2", "#7b3fb5")[k], 0.02),
                12,
            )
            meshes.append(spot)
        pieces = solids([case], meshes[2:4])
    elif kind == "two":
        meshes = []
        for q, colour in ((-1, paint), (1, trim)):
            half = rounded_rectangle(0.1, 0.038, 0.016, 4)
            grip = extrude(half, 0.022, mat=plain(colour, 0.03), bevel_width=0.004)
            meshes.append(grip.turn(rz=-0.06 * q).move(0, q * 0.062, 0))
            meshes += _stick(-0.024 if q < 0 else 0.02, q * 0.06, 0.022, shade_hex(colour))
            x = 0.012 if q < 0 else -0.024
            for a, b in ((1, 0), (0, 1), (-1, 0), (0, -1)):
                at = (x + 0.011 * a, q * 0.061 + 0.011 * b, 0.0215)
                meshes.append(cylinder(0.0048, 0.004, at, plain("#26282c", 0), 8))
        middle = box(0.085, 0.088, 0.024, (0, 0, 0), plain("#33363b", 0.03), 0.006)
        meshes.append(middle)
        for k in range(4):
            lamp = box(0.004, 0.006, 0.002, (0.03, -0.018 + 0.012 * k, 0.0235), plain("#7af08a", 0))
            meshes.append(lamp)
        pieces = solids(meshes)
    else:
        ring = [
            (0.1 * math.cos(a), 0.115 * math.sin(a), 0.0)
            for a in np.linspace(0, math.tau, 20, endpoint=False)
        ]
        rim = [tube(ring, 0.014, 7, closed=True, mat=plain(paint, 0.06, 200))]
        hub = extrude(
            [
                (-0.03, -0.1),
                (-0.012, -0.1),
                (0.03, -0.03),
                (0.09, -0.018),
                (0.09, 0.018),
                (0.03, 0.03),
                (-0.012, 0.1),
                (-0.03, 0.1),
            ],
            0.018,
            plain("#55595f", 0.04),
        )
        rim.append(hub.move(z=-0.009))
        rim += _diamond(0.0, 0.04, 0.009, 0.011, 0.005) + _cross(0.0, -0.04, 0.01, 0.024, "#17181a")
        rim.append(cylinder(0.018, 0.006, (0.03, 0, 0.007), plain(trim, 0), 12))
        for mesh in rim:
            mesh.keep_pattern().turn(ry=1.05).move(0.05, 0, 0.155)
        base = [box(0.21, 0.16, 0.06, (-0.03, 0, 0), plain("#26282c", 0.04), 0.01)]
        base.append(rod((-0.04, 0, 0.05), (0.045, 0, 0.15), 0.026, plain("#26282c", 0.04), 10))
        meshes = rim + base
        pieces = solids(rim, base[:1], base[1:])
    grounded(meshes) if kind in ("pad",) else None
    return Model(
        "game controller", {"body": Part(meshes, collision=pieces)}, mass=0.25, friction=0.6
    )


def game_controller_random(rng: np.random.Generator) -> dict:
    return {"kind": "pad", "paint": "#26282c", "trim": "#17181a"}


MODELS = {
    "game_controller": Maker(
        game_controller,
        game_controller_random,
        8,
        [
            {"paint": "#9aa8b8"},
            {"kind": "cable", "paint": "#f2f2ee", "trim": "#3a3d43"},
            {"kind": "retro", "paint": "#c9cdd1", "trim": "#3a3d43"},
            {"kind": "stick", "paint": "#26282c"},
            # Red and blue, on a dark sofa it was toy bricks.
            {"kind": "two", "paint": "#e6e8ea", "trim": "#d4d8dc"},
            {"kind": "dock", "paint": "#f2f2ee", "trim": "#17181a"},
            {"kind": "wheel", "paint": "#1c1d20", "trim": "#d8202c"},
            {"paint": "#1f5fc0"},
        ],
    ),
}
