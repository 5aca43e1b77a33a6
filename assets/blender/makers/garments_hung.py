"""What hangs on hooks: coats, jackets, scarves, bags, hats, umbrellas.

Each hangs from a hook at (0, 0, 0) with its front to +X and its back at about x = -0.05.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from toolkit.materials import plain, shade
from toolkit.mesh import Mesh
from toolkit.shapes import box, lathe, loft, rounded_rectangle, spline, tube

from .joinery import Assembly, fabric

Offset = tuple[float, float, float]
Point = tuple[float, float, float]
#: Columns of a coat's body: enough for its folds.
AROUND = 16
#: Flat against the wall behind it.
BACK = -0.05


def _loop(length: float, colour: str) -> Mesh:
    """The loop by which it hangs, behind its collar."""
    path = [(-0.02, -0.012, -length), (-0.008, 0, 0.004), (-0.02, 0.012, -length)]
    return tube(np.array(path), 0.005, 4, mat=plain(shade(colour, 0.6), 0.05))


def _body(length: float, width: float, fold: float, puff: float = 0.0) -> list[np.ndarray]:
    """Rings from the hem up: sloping shoulders, folds that deepen towards an uneven hem; ``puff``
    quilts it."""
    rows = [(1.0, 1.05, 0.075), (0.8, 1.0, 0.072), (0.6, 0.96, 0.068), (0.4, 0.97, 0.066)]
    rows += [(0.25, 1.0, 0.064)]
    if puff:
        rows = [(f, 1.0, 0.074) for f in (1.0, 0.9, 0.78, 0.66, 0.54, 0.42, 0.3)]
    t = np.arange(AROUND) * math.tau / AROUND
    rings = []
    for k, (f, wide, deep) in enumerate(rows):
        soft = 1 + fold * f * np.sin(5 * t + 2.2 * f + 0.6)
        if puff:
            soft = soft * (1 + puff * (k % 2))
        hem = 0.014 * np.sin(2 * t + 0.9) * (f == 1.0)
        x, y = deep * np.cos(t) * soft, width / 2 * wide * np.sin(t) * soft
        rings.append(np.c_[np.maximum(x + 0.008, BACK), y, -0.05 - length * f + hem])
    for z, wide, deep in ((-0.135, 0.9, 0.062), (-0.09, 0.66, 0.055), (-0.055, 0.36, 0.045)):
        ring = np.c_[deep * np.cos(t), width / 2 * wide * np.sin(t), np.full(AROUND, z)]
        rings.append(ring)
    return rings


def _down_front(rings: list[np.ndarray], down_to: float, colour) -> list[Mesh]:
    """A band that follows the middle of a body's front, from its hem up to a height."""
    middle = [ring[0] for ring in rings if ring[0][2] <= down_to]
    path = np.add(middle, (0.001, 0.0, 0.0))
    return [tube(path, 0.0075, 4, mat=colour, flatten=0.7, up=(1, 0, 0))]


def _sleeves(length: float, width: float, cloth, cuff: float = 0.9) -> list[Mesh]:
    """Arms that hang close to the body, a little creased at the elbow."""
    meshes = []
    for s in (-1, 1):
        out = width / 2
        points = [(0.0, 0.62 * out, -0.1), (0.004, 0.97 * out, -0.2), (0.0, 1.1 * out, -0.36)]
        points += [(0.014, 1.1 * out, -0.24 - 0.5 * length), (0.034, 1.0 * out, -0.1 - length)]
        path = spline([(x, s * y, z) for x, y, z in points], 2)
        radii = np.array([0.042, 0.054, 0.055, 0.053, 0.05, 0.05, 0.05, 0.047, 0.045 * cuff / 0.9])
        meshes.append(tube(path, radii, 8, mat=cloth, flatten=0.85))
    return meshes


def _collar(width: float, rise: float, cloth) -> Mesh:
    """A band round the neck, open in front, its points turned down."""
    a = np.linspace(0.5, math.tau - 0.5, 9)
    rx, ry = 0.05, 0.24 * width
    low = np.c_[rx * np.cos(a), ry * np.sin(a), -0.078 - 0.028 * np.cos(a)]
    return tube(low, np.linspace(0.02, 0.02, 9) * rise, 6, mat=cloth, flatten=1.5)


def coat(
    colour: str, collar: str, offset: Offset = (0, 0, 0), length: float = 0.78, width: float = 0.3
) -> list[Mesh]:
    """A coat with lapels and buttons."""
    cloth, trim = fabric(colour, offset, 0.08), fabric(collar, offset, 0.06)
    dark = plain(shade(colour, 0.5), 0.03, 40)
    rings = _body(length, width, 0.16)
    meshes = [loft(rings, cloth), *_sleeves(0.62, width, cloth)]
    meshes += [_collar(width, 1.0, trim), _loop(0.06, colour)]
    meshes += _down_front(rings, -0.2, dark)
    for s in (-1, 1):  # lapels
        lapel = box(0.008, 0.05, 0.18, (0, 0, -0.18), trim).turn(rx=s * 0.32, ry=0.02)
        meshes.append(lapel.move(0.066, s * 0.036, -0.09))
    for ring in rings[1:4]:
        x, _, z = ring[0]
        meshes.append(box(0.012, 0.022, 0.022, (x, -0.028, z - 0.01), dark))
    return meshes


def jacket(
    colour: str, trim: str, offset: Offset = (0, 0, 0), length: float = 0.56, width: float = 0.32
) -> list[Mesh]:
    """A quilted jacket with a hood and a zip."""
    cloth, inside = fabric(colour, offset, 0.05), plain(trim, 0.05, 40)
    rings = _body(length, width, 0.05, 0.07)
    meshes = [loft(rings, cloth), *_sleeves(0.56, width, cloth)]
    hood = [(0.02, 0.1, -0.16), (0.035, 0.12, -0.1), (0.028, 0.105, -0.045), (0.01, 0.05, -0.02)]
    t = np.arange(10) * math.tau / 10
    turns = [np.c_[-0.016 + r * np.cos(t), w * np.sin(t), np.full(10, z)] for r, w, z in hood]
    meshes.append(loft(turns, cloth))
    return [*meshes, *_down_front(rings, -0.06, inside), _loop(0.05, colour)]


def scarf(colour: str, stripe: str, offset: Offset = (0, 0, 0), length: float = 0.7) -> list[Mesh]:
    """A scarf over a hook, one end longer, with stripes and fringes."""
    cloth, band = fabric(colour, offset, 0.1), fabric(stripe, offset, 0.08)
    meshes = []
    for s, long in ((-1, length), (1, 0.76 * length)):
        path = [(0.0, s * 0.01, 0.014), (0.02, s * 0.035, -0.06), (0.024, s * 0.05, -0.3 * long)]
        path += [(0.02, s * 0.056, -0.7 * long), (0.026, s * 0.05, -long)]
        wide = np.array([0.03, 0.036, 0.05, 0.058, 0.06])
        meshes.append(tube(np.array(path), wide, 8, mat=cloth, flatten=0.3, up=(1, 0, 0)))
        for z in (0.72, 0.84):
            meshes.append(box(0.04, 0.118, 0.03, (0.022, s * 0.055, -z * long), band))
        for k in range(5):
            y = s * 0.05 + (k - 2) * 0.022
            meshes.append(box(0.012, 0.008, 0.05, (0.026, y, -long - 0.045), cloth))
    return meshes


def bag(colour: str, strap: str, offset: Offset = (0, 0, 0), drop: float = 0.3) -> list[Mesh]:
    """A shoulder bag by its strap."""
    leather, dark = plain(colour, 0.08, 18, offset), plain(strap, 0.06, 20)
    w, h = 0.3, 0.24
    path = [(0.0, -w / 2 + 0.01, -drop - 0.03), (0.0, -0.09, -0.4 * drop), (0.0, -0.02, -0.01)]
    path += [(0.0, 0.02, -0.01), (0.0, 0.09, -0.4 * drop), (0.0, w / 2 - 0.01, -drop - 0.03)]
    meshes = [tube(np.array(path), 0.009, 5, mat=dark)]
    outline = rounded_rectangle(0.085, w, 0.04, 3)
    rings = [
        np.c_[outline * k, np.full(len(outline), -drop - d)]
        for k, d in ((0.9, h), (1, h - 0.03), (1.04, 0.08), (0.93, 0.0))
    ]
    meshes.append(loft(rings, leather))
    flap = box(0.01, w - 0.03, 0.13, (0.046, 0, -drop - 0.13), dark, 0.003)
    clasp = box(0.006, 0.04, 0.03, (0.054, 0, -drop - 0.125), plain("#c9a24a", 0.04))
    return [*meshes, flap, clasp]


def tote(colour: str, print_: str, offset: Offset = (0, 0, 0), drop: float = 0.24) -> list[Mesh]:
    """A cloth bag by its two handles, flat and a little creased."""
    cloth = fabric(colour, offset, 0.06)
    w, h = 0.34, 0.36
    meshes = []
    for s in (-1, 1):
        path = [(0.012 * s, -0.09, -drop - 0.01), (0.008 * s, -0.03, -0.05), (0.0, 0.0, 0.0)]
        path += [(0.008 * s, 0.03, -0.05), (0.012 * s, 0.09, -drop - 0.01)]
        meshes.append(tube(np.array(path), 0.009, 4, mat=cloth))
    t = np.arange(12) * math.tau / 12
    rows = ((0.8, 0.025, h), (0.92, 0.05, h - 0.05), (0.96, 0.045, 0.14), (0.98, 0.022, 0.0))
    rings = [
        np.c_[deep * np.cos(t), w / 2 * wide * np.sin(t), np.full(12, -drop - d)]
        for wide, deep, d in rows
    ]
    meshes.append(loft(rings, cloth))
    mark = box(0.006, 0.13, 0.1, (0.045, 0, -drop - 0.26), plain(print_, 0.04)).turn(ry=0.0)
    return [*meshes, mark]


def hat(colour: str) -> list[Mesh]:
    """A felt hat, upside up, its brim's middle at 0: it stands on a pole or a shelf."""
    cloth = fabric(colour, (1, 2, 3), 0.05)
    shape = [(0, -0.01), (0.15, -0.006), (0.155, 0.004), (0.1, 0.01), (0.092, 0.07)]
    shape += [(0.075, 0.105), (0.03, 0.1), (0, 0.095)]
    band = [(0.101, 0.012), (0.104, 0.012), (0.102, 0.036), (0.098, 0.036), (0.101, 0.012)]
    felt = lathe(shape, 20, mat=cloth).scale(1.05, 0.9, 1)
    ribbon = lathe(band, 20, mat=plain(shade(colour, 0.45), 0.05, 20)).scale(1.05, 0.9, 1)
    return [felt, ribbon]


def hung_hat(colour: str) -> list[Mesh]:
    """The same, hung up by its crown, its brim upright."""
    return [mesh.turn(ry=math.pi / 2 - 0.16).move(-0.03, 0, -0.05) for mesh in hat(colour)]


def cap(colour: str, band: str) -> list[Mesh]:
    """A knitted cap by its loop, its band turned up."""
    shape = [(0, -0.18), (0.07, -0.18), (0.086, -0.175), (0.088, -0.13), (0.076, -0.125)]
    shape += [(0.074, -0.085), (0.05, -0.03), (0, -0.018)]
    mats = [fabric(colour, (2, 1, 3), 0.14), fabric(band, (2, 1, 3), 0.14)]
    wool = lathe(shape, 14, mats=mats, mat_of_segment=[0, 1, 1, 1, 0, 0, 0])
    return [wool.scale(0.7, 1.0, 1.0), _loop(0.03, colour)]


def umbrella(colour: str, handle: str = "#6a4526") -> list[Mesh]:
    """A rolled umbrella by its crook, its tip down."""
    crook = [(0.0, -0.035, -0.03), (0.0, -0.03, 0.0), (0.0, 0.0, 0.02), (0.0, 0.03, 0.0)]
    crook += [(0.0, 0.034, -0.06), (0.0, 0.034, -0.16)]
    stick = tube(spline(crook, 2), 0.01, 6, mat=plain(handle, 0.08, 20))
    roll = [(0, -0.82), (0.006, -0.82), (0.007, -0.76), (0.026, -0.7), (0.032, -0.4)]
    roll += [(0.024, -0.2), (0.012, -0.17), (0, -0.16)]
    cloth = lathe(roll, 10, mat=fabric(colour, (3, 1, 2), 0.08), rib=lambda k, i: 1 - 0.1 * (i % 2))
    return [stick, cloth.move(0, 0.034, 0)]


#: By a word, for what a model lists: a maker of colours, and half of the space that it fills, as
#: (half its width, how far down from the hook it reaches, from where).
HUNG: dict[str, tuple[Callable[..., list[Mesh]], tuple[float, float, float]]] = {
    "coat": (coat, (0.17, 0.8, 0.1)),
    "jacket": (jacket, (0.18, 0.6, 0.1)),
    "scarf": (scarf, (0.1, 0.72, 0.03)),
    "bag": (bag, (0.14, 0.54, 0.3)),
    "tote": (tote, (0.16, 0.6, 0.24)),
    "hat": (hung_hat, (0.14, 0.18, 0.0)),
    "cap": (cap, (0.08, 0.18, 0.02)),
    "umbrella": (umbrella, (0.04, 0.8, 0.1)),
}


def hang(asm: Assembly, what: tuple[str, ...], at: Point, turn: float = 0.0) -> None:
    """Hang something on a hook: its word in ``HUNG`` and its colours; its front turned so far."""
    word, *colours = what
    make, (half, reach, start) = HUNG[word]
    for mesh in make(*colours):
        asm.add("body", mesh.turn(rz=turn).move(*at))
    c, s = math.cos(turn), math.sin(turn)
    corners = [
        (at[0] + c * x - s * y, at[1] + s * x + c * y, at[2] - z)
        for x in (-0.045, 0.055)
        for y in (-half, half)
        for z in (reach, start)
    ]
    asm.piece("body", np.array(corners))
