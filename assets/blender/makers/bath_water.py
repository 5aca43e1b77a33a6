"""Water in bathtubs: standing in them, and running over the rim."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh
from toolkit.shapes import loft

from .joinery import Assembly

Rings = Sequence[np.ndarray]
BELOW_RIM_M = 0.06
INTO_WALL_M = 0.004
SHEET_M = 0.006  # how far a sheet of water stands out of what it runs down
WATER = {"rgba": (1.12, 1.12, 1.12, 1.0)}


def _water(length: float, foam: float) -> Material:
    """Clear, bluish, darker in the middle of a tub along y; foam: how much of it floats there."""
    m = Material(occlusion=0.25)
    deep = m.remap(m.distance((0, 0, 0), (2.2 / 0.7, 2 / length, 0)), 0.3, 1.0)
    base = m.ramp(deep, [(0, "#62adc8"), (0.6, "#8ac4d8"), (1, "#b4dce8")])
    ripple = m.remap(m.noise(16, 2, distortion=1.5, stretch=(1.4, 0.7, 0.2)), 0.5, 0.62)
    base = m.mix(m.math("MULTIPLY", ripple, 0.55), base, "#d6ecf4")
    patches = m.noise(4.5, 3, distortion=0.6, offset=(3.1, 0.4, 0))
    bubbles = m.remap(m.voronoi(60), 0.15, 0.6)
    white = m.ramp(bubbles, [(0, "#ffffff"), (1, "#d4e9f2")])
    where = m.remap(patches, 0.63 - 0.12 * foam, 0.66 - 0.12 * foam)
    return m.colour(m.mix(where, base, white))


def _falling() -> Material:
    """Water running down, in streaks."""
    m = Material(occlusion=0.15)
    streaks = m.noise(34, 2, stretch=(2, 2, 0.25))
    return m.colour(
        m.ramp(streaks, [(0.32, "#57b4d8"), (0.47, "#9fdcf0"), (0.6, "#e4f7fd"), (0.7, "#8fd2ea")])
    )


def waterline(inside: Rings, level: float) -> np.ndarray:
    """Where water of a level meets a tub, (n, 3): a point of each column of rings from the rim
    down, a little inside the wall."""
    stack = np.array(inside)
    out = stack[0].copy()
    for i in range(stack.shape[1]):
        z = stack[:, i, 2]
        for k in range(len(z) - 1):
            if z[k] >= level > z[k + 1]:
                t = (z[k] - level) / (z[k] - z[k + 1])
                out[i] = stack[k, i] * (1 - t) + stack[k + 1, i] * t
    out[:, :2] += INTO_WALL_M * out[:, :2] / np.linalg.norm(out[:, :2], axis=1)[:, None]
    out[:, 2] = level
    return out


def _front_at(ring: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Points of a ring's front side (+X) at these y."""
    half = ring[ring[:, 0] > 0]
    half = half[np.argsort(half[:, 1])]
    return np.c_[np.interp(y, half[:, 1], half[:, 0]), y, np.interp(y, half[:, 1], half[:, 2])]


def _tongue(path: Rings, rim: int, y0: float, width: float, mat: Material) -> Mesh:
    """A sheet of water over the rim in front and down the outside; path: rings from the water's
    edge over the rim (the first `rim`) to the foot."""
    across = np.linspace(-1, 1, 7)
    rise = np.array([-0.5, 0.7, 1.0, 0.8, 1.0, 0.7, -0.5]) * SHEET_M
    rows = []
    for k, ring in enumerate(path):
        wide = width / 2 * (1.15, 1.0, 0.8, 0.9, 0.75, 0.85)[k % 6]
        row = _front_at(ring, y0 + across * wide)
        if k < rim:
            row[:, 2] += rise
        else:
            row[:, 0] += rise
        rows.append(row)
    mesh = loft(rows, mat, closed=False)
    a, b, c = (mesh.v[i] for i in mesh.f[len(mesh.f) // 2][:3])
    return mesh if np.cross(b - a, c - a) @ [1, 0, 1] > 0 else mesh.flip()


def fill(asm: Assembly, inside: Rings, outside: Rings, length: float, tongues: Sequence) -> None:
    """The parts `bath` (water up to 6 cm below the rim) and `brim` (up to the rim, and over it).

    inside: rings of the tub from its rim to its floor; outside: from the rim to the foot, both
    of equally many points; tongues: (y, width) of each place where it runs over.
    """
    rim = float(min(ring[:, 2].min() for ring in inside[:1]))
    for part, level, foam in (("bath", rim - BELOW_RIM_M, 1.0), ("brim", rim + 0.001, 0.6)):
        edge = waterline(inside, level)
        surface = loft([edge - [0, 0, 0.012], edge], _water(length, foam), weight=1.3)
        asm.add(part, surface)
    mat = _falling()
    lip = waterline(inside, rim)
    for y, width in tongues:
        path = [lip * [0.97, 1, 1], inside[0], *outside]
        asm.add("brim", _tongue(path, 3, y, width, mat))


def filled(switch: dict) -> dict:
    """Variants and states of a tub with the part `water`, filled and running over as well."""
    body, on = switch["variants"]["default"], switch["variants"]["on"]
    body = [name for name in body if name not in ("bath", "brim")]
    return {
        "variants": {
            "default": body,
            "on": [*body, *(name for name in on if name == "water")],
            "full": [*body, "bath"],
            "full_on": [*body, "water", "brim"],
        },
        "states": [
            {"state": "OFF", "variants": ["default", "full"], "parts": ["body"]},
            {"state": "ON", "variants": ["on", "full_on"], "parts": ["water"]},
            {"state": "FULL", "variants": ["full"], "parts": ["bath"]},
            {"state": "FULL", "variants": ["full_on"], "parts": ["brim"]},
            {"state": "OVERFLOWING", "variants": ["full_on"], "parts": ["brim"]},
        ],
    }
