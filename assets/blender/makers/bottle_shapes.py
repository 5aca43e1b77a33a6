"""Shapes shared by bottles: oval bodies and ribbed caps."""

from __future__ import annotations

from toolkit.mesh import Mesh
from toolkit.shapes import (
    lathe,
    loft,
    superellipse,
)


def oval_body(
    profile: list[tuple[float, float, float]],
    width: float,
    depth: float,
    mat,
    power: float = 2.8,
    n: int = 18,
) -> Mesh:
    """A bottle with an oval section, wide along y. profile: (z, width factor, depth factor)."""
    rings = [superellipse(depth / 2 * d, width / 2 * w, power, n, z) for z, w, d in profile]
    return loft(rings, mat=mat)


def cap(radius: float, z: float, height: float, mat, n: int = 16, taper: float = 0.94) -> Mesh:
    """A ribbed screw cap."""
    profile = [
        (0, z),
        (radius, z),
        (radius * taper, z + height * 0.9),
        (radius * taper * 0.86, z + height),
    ]
    profile.append((0, z + height))
    return lathe(profile, n, mat=mat, rib=lambda k, i: 1 - 0.06 * (i % 2) if k in (1, 2) else 1)
