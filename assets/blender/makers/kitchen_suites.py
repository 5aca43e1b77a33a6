"""Kitchen suites: what the units of one kitchen share, so that runs of them join without a step."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain, wood
from toolkit.mesh import cube_project
from toolkit.shapes import extrude, lathe, loft

from .casework import metal_or
from .joinery import WOODS, Assembly, bar_handle, front, stone

#: Fronts (colour or wood, slab or shaker), case, worktop, pull and its metal, plinth.
SUITES = {
    "white_shaker": {
        "front": "#f0eee8", "style": "shaker", "case": "#f2f0ec", "top": "oak",
        "pull": "knob", "metal": "steel", "plinth": "#e4e2dc",
    },
    "sage_shaker": {
        "front": "#93a68f", "style": "shaker", "case": "#efede7", "top": "pale stone",
        "pull": "knob", "metal": "brass", "plinth": "#889a84",
    },
    "oak_flat": {
        "front": "oak", "style": "slab", "case": "#f2f0ec", "top": "white quartz",
        "pull": "bar", "metal": "iron", "plinth": "#3a3a3a",
    },
    "navy_shaker": {
        "front": "#3d4c66", "style": "shaker", "case": "#f2f0ec", "top": "white quartz",
        "pull": "knob", "metal": "brass", "plinth": "#36435a",
    },
    "grey_flat": {
        "front": "#a6abad", "style": "slab", "case": "#efede7", "top": "walnut",
        "pull": "bar", "metal": "steel", "plinth": "#8b9092",
    },
    "birch_flat": {
        "front": "birch", "style": "slab", "case": "#f2f0ec", "top": "grey stone",
        "pull": "lip", "metal": "steel", "plinth": "#55575a",
    },
    "cream_farmhouse": {
        "front": "#ece2c6", "style": "shaker", "case": "#f0ead9", "top": "birch",
        "pull": "cup", "metal": "iron", "plinth": "#ddd2b4",
    },
    "anthracite_flat": {
        "front": "#44484c", "style": "slab", "case": "#55595d", "top": "concrete",
        "pull": "lip", "metal": "iron", "plinth": "#2b2d2f",
    },
    "white_flat": {
        "front": "#f4f4f2", "style": "slab", "case": "#f4f4f2", "top": "black granite",
        "pull": "bar", "metal": "steel", "plinth": "#d8d9d8",
    },
}  # fmt: skip
#: Those whose models come first; further ones are added behind, so that ids stay what they are.
FIRST = ("white_shaker", "sage_shaker", "oak_flat", "navy_shaker", "grey_flat")
FURTHER = tuple(name for name in SUITES if name not in FIRST)
STYLES = tuple(SUITES)
Offset = tuple[float, float, float]
BACK, CASE_FRONT, DOOR_FRONT, TOP_FRONT = -0.30, 0.26, 0.278, 0.284
PLINTH, CASE_TOP, WORKTOP = 0.10, 0.86, 0.90
DOOR = 0.018
#: How far a pull stands off its front; the same for all, or units would differ in depth.
REACH = 0.022

_STONES = {
    "pale stone": ("#cfcac0", "#a9a398"),
    "white quartz": ("#e3e1db", "#c4c1b9"),
    "grey stone": ("#77797b", "#a5a6a5"),
    "concrete": ("#aeaca7", "#bdbbb6"),
    "black granite": ("#2f3133", "#5c5e60"),
}


def worktop_material(suite: dict, offset: Offset, grain_axis: int = 1) -> Material:
    """What the suite's worktops are made of: fine enough that a joint does not show."""
    if suite["top"] in _STONES:
        return stone(*_STONES[suite["top"]], offset)
    light, dark = WOODS[suite["top"]]
    return wood(light, dark, grain_axis, 5.0, tuple(offset), 0.45)


def slab(asm: Assembly, x: tuple, y: tuple, mat: Material, turned: bool = False) -> None:
    """A piece of worktop whose upper front edge alone is rounded: its ends butt on neighbours.

    turned: by a quarter about the origin, so that it faces +Y.
    """
    (x0, x1), (y0, y1), r = x, y, 0.004
    outline = [(x0, CASE_TOP), (x1, CASE_TOP), (x1, WORKTOP - r), (x1 - 0.3 * r, WORKTOP - 0.3 * r)]
    outline += [(x1 - r, WORKTOP), (x0, WORKTOP)]
    mesh = extrude(outline, y1 - y0, mat, axis="y").move(0, (y0 + y1) / 2, 0)
    asm.add("body", mesh.turn(rz=np.pi / 2) if turned else mesh, solid=True)


def leaf(
    asm: Assembly, part: str, x: float, y: tuple, z: tuple, look: dict, mat: Material, rail=0.06
) -> None:
    """A front whose back lies at x, in the suite's style.

    A shaker's frame and panel are one skin: of boards laid together the seams, thinner than a
    pixel of their texture, show as dashes.
    """
    if look["style"] == "slab":
        front(asm, part, x, y, z, mat)
        return
    outer = x + DOOR
    r = min(rail, 0.3 * (z[1] - z[0]), 0.3 * (y[1] - y[0]))

    def ring(inset: float, at: float) -> np.ndarray:
        (y0, y1), (z0, z1) = (y[0] + inset, y[1] - inset), (z[0] + inset, z[1] - inset)
        return np.array([(at, y0, z0), (at, y1, z0), (at, y1, z1), (at, y0, z1)])

    rings = [ring(0, x), ring(0, outer), ring(r, outer), ring(r + 0.006, outer - 0.007)]
    asm.add(part, cube_project(loft(rings, mat)))
    asm.solid(part, (x, y[0], z[0]), (outer, y[1], z[1]))


def pull(
    asm: Assembly,
    part: str,
    look: dict,
    at: tuple[float, float, float],
    length: float,
    upright: bool = True,
    lip: tuple[float, float] | None = None,
) -> None:
    """The suite's handle on a front whose outer face lies at at[0]; bars are centred on `at`.

    lip: (y of its middle, z of the front's edge) for the suites whose fronts are pulled by a strip
    along an edge: an upper one, or a lower one where `at` lies below it.
    """
    (x, y, z), kind, metal = at, look["pull"], metal_or(look["metal"])
    if kind == "bar":
        bar_handle(asm, part, x, y, z, length, metal, upright, reach=REACH)
    elif kind == "lip":
        middle, edge = lip or (y, z)
        half = 0.6 * length
        low, high = sorted((edge, edge - 0.012 if z < edge else edge + 0.012))
        front = (x + REACH, middle + half, high)
        asm.board(part, (x - 0.001, middle - half, low), front, metal, 0.003, solid=False)
    elif kind == "cup" and not upright:
        low, high = (x - 0.001, y - 0.045, z - 0.014), (x + REACH, y + 0.045, z + 0.016)
        asm.board(part, low, high, metal, 0.009, solid=False, segments=2)
    else:
        profile = [(0, 0), (0.008, 0), (0.007, 0.008), (0.015, 0.013), (0.014, 0.02)]
        knob = lathe([*profile, (0, REACH + 0.001)], 10, mat=metal).turn(ry=np.pi / 2)
        asm.add(part, knob.move(x - 0.001, y, z))


def plinth_material(look: dict) -> Material:
    """The board before the feet."""
    return plain(look["plinth"], 0.03, 8)


def named(suite: str) -> str:
    """The suite as titles say it."""
    return suite.replace("_", " ")
