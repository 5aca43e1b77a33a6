"""A coat as it hangs."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain, shade
from toolkit.mesh import Mesh
from toolkit.shapes import box, loft, spline, tube

from .joinery import fabric

Offset = tuple[float, float, float]


def coat(colour: str, collar: str, offset: Offset = (0, 0, 0)) -> list[Mesh]:
    """A coat hanging from a hook at (0, 0, 0): body, sleeves, collar; its front to +X."""
    cloth = fabric(colour, offset, 0.08)
    rings = []
    # (z, width across, depth, bulge to the front)
    for z, w, d, x in (
        (-0.98, 0.34, 0.14, 0.02),
        (-0.7, 0.31, 0.13, 0.015),
        (-0.4, 0.29, 0.12, 0.01),
        (-0.2, 0.3, 0.12, 0.005),
        (-0.1, 0.26, 0.1, 0.0),
        (-0.03, 0.13, 0.07, 0.0),
    ):
        t = np.arange(16) * 2 * math.pi / 16
        fold = 1 + 0.09 * np.sin(5 * t + 7 * z) * min(1.0, -z * 1.6)
        rings.append(np.c_[x + d / 2 * np.cos(t) * fold, w / 2 * np.sin(t) * fold, np.full(16, z)])
    meshes = [loft(rings, cloth)]
    for s in (-1, 1):
        arm = spline(
            [
                (0, s * 0.1, -0.1),
                (0.005, s * 0.17, -0.22),
                (0.02, s * 0.185, -0.45),
                (0.035, s * 0.17, -0.68),
            ],
            2,
        )
        meshes.append(tube(arm, [0.05, 0.058, 0.058, 0.055, 0.05, 0.047, 0.044], 9, mat=cloth))
    band = fabric(collar, offset, 0.06)
    ring = [
        (0.045 * math.cos(a) + 0.005, 0.07 * math.sin(a), -0.05 + 0.02 * math.cos(a))
        for a in np.arange(10) * 2 * math.pi / 10
    ]
    meshes.append(tube(np.array(ring), 0.022, 6, closed=True, mat=band))
    strip = box(0.008, 0.022, 0.86, (0.074, 0, -0.95), plain(shade(colour, 0.62), 0.05, 40))
    meshes.append(strip.turn(ry=0.012))
    return meshes
