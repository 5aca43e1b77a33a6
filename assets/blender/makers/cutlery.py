"""Handles of cutlery, and scissors (forks and spoons: table_tools.py)."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain
from toolkit.model import Model, Part, box_piece, prism_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import extrude, lathe, spline, tube

from makers.knives import NO_SHADOW


def handle_rings(stations: list[tuple[float, float, float]], thick: float) -> list[np.ndarray]:
    """Rounded bars along x: stations of (x, half width, z)."""
    rings = []
    for x, half, z in stations:
        t = thick / 2
        section = [
            (half, -t * 0.5),
            (half, t * 0.5),
            (half * 0.6, t),
            (-half * 0.6, t),
            (-half, t * 0.5),
        ]
        section += [(-half, -t * 0.5), (-half * 0.6, -t), (half * 0.6, -t)]
        rings.append(np.array([(x, y, z + dz) for y, dz in section]))
    return rings


def scissors(length=0.2, angle_deg=24.0, colour="#e8641e", seed=0) -> Model:
    """Household scissors lying slightly open, points towards +X."""
    rng = np.random.default_rng(seed)
    s = length / 0.2
    steel = metal("c3c7cb", "868c92", (30, 2, 1), 25, noise_offset(rng), occlusion=0.4)
    edge, grip = plain("eceef0", 0.02, occlusion=0.4), plain(colour, 0.06, 150, noise_offset(rng))
    blades, handles = [], []
    blade = [
        (0.105, -0.001),
        (0.06, 0.0085),
        (0.012, 0.01),
        (-0.01, 0.011),
        (-0.03, 0.014),
        (-0.034, 0.006),
        (-0.01, -0.006),
        (0, -0.0065),
        (0.03, -0.0055),
    ]
    ground = [
        (0.104, -0.0012),
        (0.03, -0.0058),
        (0, -0.0067),
        (0, -0.0045),
        (0.03, -0.0035),
        (0.1, 0.0002),
    ]
    for half, side in ((0, 1), (1, -1)):
        big = half == 0
        a, c = (0.026, 0.0165) if big else (0.019, 0.0155)
        cx, cy = (-0.066, 0.024) if big else (-0.058, 0.023)
        t = np.arange(16) * 2 * math.pi / 16
        ring = np.c_[
            cx + a * np.cos(t) + 0.12 * c * np.sin(t),
            cy - 0.12 * a * np.cos(t) + c * np.sin(t),
            0 * t,
        ]
        loop = tube(ring, 0.0046, 6, closed=True, mat=grip, up=(0, 0, 1.0))
        y_end = 0.017 if big else 0.019
        path = spline([(-0.022, 0.01, 0), (-0.034, 0.012, 0), (-0.046, y_end, 0)], 2)
        shank = tube(
            path, [0.0048, 0.006, 0.0064, 0.0062, 0.0052], 6, mat=grip, up=(0, 0, 1.0), flatten=0.75
        )
        steel_blade = extrude(blade, 0.0022, steel)
        shine = extrude(ground, 0.0024, edge).move(z=-0.0001)
        for mesh in (steel_blade, shine, loop, shank):
            if mesh in (loop, shank):
                mesh.move(z=0.0011)
            if side < 0:
                mesh.scale(1, -1, 1)
            # handles apart when the points are: each half turns about the screw
            mesh.turn(rz=-side * math.radians(angle_deg / 2)).scale(s).move(
                z=0.0049 if big else 0.0026
            )
        blades += [steel_blade, shine]
        handles += [loop, shank]
    screw = [(0, 0), (0.0052, 0), (0.0052, 0.0012), (0.004, 0.0022), (0, 0.0024)]
    blades.append(lathe(screw, 12, mat=metal("aeb2b6", "6a6f74")).scale(s).move(z=0.0068))
    points = np.concatenate([m.v for m in handles])
    low, high = points.min(0), points.max(0)
    pieces = [
        box_piece(
            ((low[0] + high[0]) / 2, y * 0.7, (low[2] + high[2]) / 2),
            (high[0] - low[0], abs(y) * 0.6, high[2] - low[2]),
        )
        for y in (low[1], high[1])
    ]
    tip = np.concatenate([m.v for m in blades])
    flat = [
        (tip[:, 0].max(), tip[tip[:, 0] > 0.07 * s][:, 1].max()),
        (-0.03 * s, 0.015 * s),
        (-0.03 * s, -0.015 * s),
        (tip[:, 0].max(), tip[tip[:, 0] > 0.07 * s][:, 1].min()),
    ]
    return Model(
        title="scissors",
        parts={
            "handles": Part(handles, collision=pieces, occlusion="handles"),
            "blades": Part(
                blades,
                rgba=NO_SHADOW,
                collision=[prism_piece(flat, 0.001, 0.009)],
                occlusion="blades",
            ),
        },
        mass=0.11,
        friction=0.5,
        texture_size=128,
    )


def scissors_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.17, 0.22),
        "angle_deg": uniform(rng, 16, 36),
        "colour": pick(rng, ["#e8641e", "#d42a30", "#26262a", "#2b62c4", "#2f9a55"]),
        "seed": seed_of(rng),
    }
