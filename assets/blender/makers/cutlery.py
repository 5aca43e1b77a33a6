"""Forks, spoons and scissors, lying as they rest: flat."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, prism_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import extrude, lathe, loft, spline, tube

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


STEM = [
    (-0.095, 0.006, 0.004),
    (-0.09, 0.0105, 0.004),
    (-0.06, 0.0085, 0.005),
    (-0.02, 0.0042, 0.008),
    (0.02, 0.0038, 0.012),
]


def fork(length=0.2, handle="", seed=0) -> Model:
    """A table fork, its tines up and towards +X; `handle`: colour of a plastic or wooden grip."""
    steel = metal(
        "c6cace", "858b91", (1, 12, 1), 60, noise_offset(np.random.default_rng(seed)), occlusion=0.5
    )
    neck = [
        (0.035, 0.0055, 0.0105),
        (0.045, 0.0115, 0.008),
        (0.06, 0.0125, 0.006),
        (0.066, 0.0125, 0.0055),
    ]
    meshes = [loft(handle_rings(STEM + neck, 0.0042), mat=steel)]
    for i in range(4):
        y = (i - 1.5) * 0.0066
        path = [(0.063, y, 0.0055), (0.08, y, 0.005), (0.095, y, 0.007), (0.105, y * 0.96, 0.011)]
        meshes.append(tube(path, [0.0025, 0.0025, 0.0023, 0.0014], 5, mat=steel, up=(0, 0, 1.0)))
    return table_tool("fork", meshes, handle, length, steel)


def spoon(length=0.2, handle="", seed=0) -> Model:
    """A tablespoon lying bowl up, bowl towards +X."""
    steel = metal(
        "c6cace", "858b91", (1, 12, 1), 60, noise_offset(np.random.default_rng(seed)), occlusion=0.5
    )
    meshes = [loft(handle_rings([*STEM, (0.045, 0.005, 0.0105)], 0.0042), mat=steel)]
    a, b, n = 0.03, 0.02, 20
    angles = [2 * math.pi * i / n for i in range(n)]

    def ring(k: float, z: float) -> list[tuple[float, float, float]]:
        return [
            (0.068 + a * k * math.cos(t), b * k * math.sin(t) * (1 - 0.12 * math.cos(t)), z)
            for t in angles
        ]

    levels = [
        (0.3, 0.0005),
        (0.65, 0.003),
        (0.9, 0.0072),
        (1.0, 0.0115),
        (0.96, 0.0122),
        (0.85, 0.0086),
        (0.6, 0.0052),
        (0.25, 0.0038),
    ]
    bowl = loft([ring(k, z) for k, z in levels], mat=steel)
    bowl.bake_uv = None
    return table_tool("spoon", [*meshes, bowl], handle, length, steel)


def table_tool(name: str, meshes: list[Mesh], handle: str, length: float, steel: Material) -> Model:
    """Common end of fork and spoon: grip, size, collision."""
    if handle:
        grip = plain(handle, 0.06, 120)
        stations = [
            (-0.1, 0.008, 0.0045),
            (-0.096, 0.0115, 0.0045),
            (-0.05, 0.0095, 0.0055),
            (-0.01, 0.007, 0.0085),
        ]
        meshes.append(loft(handle_rings(stations, 0.0085), mat=grip))
    s = length / 0.2
    for mesh in meshes:
        mesh.scale(s)
    points = np.concatenate([m.v for m in meshes])
    low, high = points.min(0), points.max(0)
    head = [
        (0.04 * s, -0.02 * s),
        (high[0], -0.016 * s),
        (high[0], 0.016 * s),
        (0.04 * s, 0.02 * s),
    ]
    head = [(x, np.clip(y, low[1], high[1])) for x, y in head]
    grip_piece = prism_piece(
        [(low[0], -0.01 * s), (0.045 * s, -0.005 * s), (0.045 * s, 0.005 * s), (low[0], 0.01 * s)],
        low[2],
        low[2] + 0.012,
    )
    return Model(
        title=f"table {name}" + (", coloured handle" if handle else ""),
        parts={"body": Part(meshes, collision=[prism_piece(head, low[2], high[2]), grip_piece])},
        mass=0.05,
        friction=0.5,
        texture_size=128,
    )


def table_tool_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.185, 0.21),
        "handle": pick(rng, ["", "#b3302c", "#2a2a2e", "#2d6a9a"]),
        "seed": seed_of(rng),
    }


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


MODELS = {
    "fork": Maker(fork, table_tool_random, presets=[{"handle": ""}, {"handle": "#b3302c"}]),
    "spoon": Maker(spoon, table_tool_random, presets=[{"handle": ""}, {"handle": "#2d6a9a"}]),
    "scissors": Maker(
        scissors,
        scissors_random,
        count=3,
        presets=[{"colour": "#e8641e"}, {"colour": "#26262a"}, {"colour": "#2b62c4"}],
    ),
}
