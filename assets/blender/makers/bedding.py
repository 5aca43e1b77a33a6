"""Cloth on beds: the blanket over the mattress, and a bed made up."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh, cube_project
from toolkit.shapes import loft

from .joinery import Assembly, cushion, fabric

Offset = tuple[float, float, float]


def bedspread(
    x0: float,
    x1: float,
    width: float,
    hem: float,
    top: float,
    mat: Material,
    offset: Offset,
    drop: bool = False,
) -> Mesh:
    """Cloth over the mattress, rounded and softly waved; `drop` hangs it over the foot."""
    half, thick = width / 2, 0.03
    across = [
        (-half - 0.008, hem),
        (-half - 0.014, (hem + top) / 2),
        (-half + 0.004, top - 0.01),
        (-half + 0.05, top + thick * 0.8),
    ]
    across += [(y, top + thick) for y in np.linspace(-half + 0.2, half - 0.2, 5)]
    across += [(-y, z) for y, z in across[3::-1]]
    phase = np.array(offset[:2]) % 6.28
    # (x, how high the cloth may reach): level along the bed, then down over the foot
    stations = [(x, top + thick) for x in np.linspace(x0, x1, 8)]
    if drop:
        stations += [(x1 + 0.03, top + 0.012), (x1 + 0.042, top - 0.03), (x1 + 0.046, hem + 0.004)]
    rings = []
    for x, roof in stations:
        wave = [
            0.004 * np.sin(9 * x + 3 * y + phase[0]) + 0.003 * np.sin(7 * y - 5 * x + phase[1])
            for y, _ in across
        ]
        outer = [
            (
                x,
                y + 1.5 * w * np.sign(y) * (abs(y) > half - 0.02),
                min(z + w * (abs(y) < half), roof),
            )
            for (y, z), w in zip(across, wave, strict=True)
        ]
        lining = roof - 0.016 if roof > top else roof - 0.002
        inner = [
            (
                x - 0.018 * (roof <= top + 0.02),
                y * (half - 0.018) / half,
                max(min(z - 0.016, lining), hem),
            )
            for y, z in across
        ]
        rings.append(np.array(outer + inner[::-1]))
    return cube_project(loft(rings, mat))


def pillow(at: tuple[float, float, float], length: float, wide: float, high: float, mat: Material):
    """A pillow that lies on what ends at ``at``, pressed into it a little by its own weight."""
    x, y, z = at
    crown = 0.4 * high
    size = (length, wide, high - crown + 0.004)
    return cushion(size, (x, y, z - 0.004), mat, 0.09, crown, 0.045)


def make_up(
    asm: Assembly,
    x: tuple[float, float],
    width: float,
    z: tuple[float, float],
    blanket: Material,
    sheet: str = "#eeebe4",
    hem: float = 0.22,
    spread: float | None = None,
    start: float = 0.55,
    case: Material | None = None,
    drop: bool = True,
    offset: Offset = (0, 0, 0),
) -> tuple[tuple[float, float], tuple[float, float], float]:
    """Mattress between two heights, blanket, turned-down sheet, pillows at low x.

    spread: width of the blanket (the frame's, if it is to hang over it). Returns the corners and
    the height of what one may lay things on.
    """
    (x0, x1), (low, top), half = x, z, width / 2
    white = fabric(sheet, offset, 0.025)
    low -= 0.012  # into the slats: what it hides is pruned
    size = (x1 - x0, width, top - low)
    mattress = cushion(size, ((x0 + x1) / 2, 0, low), white, 0.06, 0.01, 0.05)
    asm.add("body", mattress, solid=True)
    wide = spread or width + 0.012
    c0, c1 = x0 + start, x1 - (0.0 if drop else 0.05)
    asm.add("body", bedspread(c0, c1, wide, hem, top, blanket, offset, drop))
    fold = cushion(
        (0.2, wide - 0.04, 0.018), (c0 + 0.09, 0, top + 0.022), white, 0.05, 0.006, 0.012
    )
    asm.add("body", fold)
    count = 2 if width >= 1.25 else 1
    for k in range(count):
        y = (k - (count - 1) / 2) * (width * 0.48)
        w = min(0.66, width * 0.78)
        asm.add("body", pillow((x0 + 0.24, y, top), 0.38, w, 0.105, case or white))
        asm.solid("body", (x0 + 0.04, y - w / 2, top), (x0 + 0.44, y + w / 2, top + 0.11))
    asm.solid("body", (c0, -half + 0.02, top), (x1 - 0.02, half - 0.02, top + 0.03))
    return (c0 + 0.16, -half + 0.08), (x1 - 0.08, half - 0.08), top + 0.033
