"""Leaves for doors: glazed, louvred, planked; each fills the leaf of `openings`."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain, shade

from .joinery import Assembly

LEAF = 0.044
Rect = tuple[float, float, float, float]


def pane_material(low: float, high: float, frosted: bool = False) -> Material:
    """Glass, lighter towards its top, or frosted."""
    glass = Material(occlusion=0.3)
    if frosted:
        grain = glass.remap(glass.noise(120, 2), 0.35, 0.65)
        return glass.colour(glass.mix(grain, "#c3d3d6", "#dde8e9"))
    return glass.colour(glass.mix(glass.remap(glass.axis(2), low, high), "#a9c0c7", "#d2e2e7"))


def glaze(
    asm: Assembly, rect: Rect, grid: tuple[int, int], frame: Material, frosted: bool = False
) -> None:
    """A window in the leaf, (y0, z0, y1, z1), parted by bars into columns and rows."""
    y0, z0, y1, z1 = rect
    glass = pane_material(z0, z1, frosted)
    x = LEAF / 2 + 0.002
    asm.board("door", (-x, y0, z0), (x, y1, z1), glass, solid=False)
    out, t = LEAF / 2 + 0.009, 0.014
    columns, rows = grid
    for k in range(columns + 1):
        y = y0 + (y1 - y0) * k / columns
        asm.board("door", (-out, y - t, z0 - t), (out, y + t, z1 + t), frame, solid=False)
    out -= 0.0015 if columns > 1 else 0.0  # where bars cross, one of them is in front
    for k in range(rows + 1):
        z = z0 + (z1 - z0) * k / rows
        asm.board("door", (-out, y0 + t, z - t), (out, y1 - t, z + t), frame, solid=False)


def louvre(asm: Assembly, rect: Rect, slats: int, mat: Material, dark: Material) -> None:
    """Slanting slats over a shadow gap, on both faces."""
    y0, z0, y1, z1 = rect
    x = LEAF / 2
    asm.board("door", (-x - 0.001, y0, z0), (x + 0.001, y1, z1), dark, solid=False)
    step = (z1 - z0) / slats
    for k in range(slats):
        z = z0 + k * step
        for s in (-1, 1):
            a, b = sorted((s * (x - 0.004), s * (x + 0.012)))
            slat = asm.board(
                "door", (a, y0, z + 0.2 * step), (b, y1, z + 0.85 * step), mat, solid=False
            )
            # the upper edge leans into the leaf
            inwards = slat.v[:, 2] > z + 0.5 * step
            slat.v[inwards, 0] -= s * 0.009


def planks(
    asm: Assembly,
    span: Rect,
    count: int,
    mat: Material,
    groove: Material,
    brace: str | None,
    iron=None,
) -> None:
    """Upright planks with grooves, and on both faces a brace: "z", or iron "straps"."""
    y0, z0, y1, z1 = span
    x = LEAF / 2
    for k in range(1, count):
        y = y0 + (y1 - y0) * k / count
        asm.board(
            "door", (-x - 0.001, y - 0.004, z0), (x + 0.001, y + 0.004, z1), groove, solid=False
        )
    for s in (-1, 1):
        a, b = sorted((s * (x - 0.002), s * (x + 0.018)))
        if brace == "z":
            for low, high in ((z0 + 0.12, z0 + 0.26), (z1 - 0.28, z1 - 0.14)):
                asm.board(
                    "door", (a, y0 + 0.02, low), (b, y1 - 0.02, high), mat, 0.003, solid=False
                )
            bar = asm.board(
                "door", (a, y0 + 0.02, z0 + 0.26), (b, y0 + 0.18, z1 - 0.28), mat, solid=False
            )
            upper = bar.v[:, 2] > (z0 + z1) / 2
            bar.v[upper, 1] += (y1 - y0) - 0.2
        elif brace == "straps":
            for z in (z0 + 0.25, z1 - 0.3):
                tip = asm.board(
                    "door", (a, y0 + 0.16, z), (b, y1 - 0.01, z + 0.055), iron, solid=False
                )
                end = tip.v[:, 1] < y0 + 0.2
                tip.v[end, 2] = z + 0.0275 + 0.4 * (tip.v[end, 2] - z - 0.0275)
                for y in np.linspace(y0 + 0.3, y1 - 0.08, 3):
                    c, d = sorted((s * (x + 0.016), s * (x + 0.026)))
                    low, high = (c, y - 0.011, z + 0.017), (d, y + 0.011, z + 0.039)
                    asm.board("door", low, high, iron, solid=False)


def grooved(asm: Assembly, span: Rect, count: int, colour: str) -> None:
    """Level grooves across a modern flush leaf."""
    y0, z0, y1, z1 = span
    dark, x = plain(shade(colour, 0.6), 0.03), LEAF / 2
    for k in range(1, count):
        z = z0 + (z1 - z0) * k / count
        asm.board(
            "door", (-x - 0.001, y0, z - 0.006), (x + 0.001, y1, z + 0.006), dark, solid=False
        )
