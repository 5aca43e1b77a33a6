"""Hollow ware: walls from an outline, what is in it, what was left in it, and its breaking."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Container, cylinder_piece, ring_pieces
from toolkit.shapes import TAU, box, ellipsoid, lathe, tube

from makers.breakage import BROKEN

Outline = list[tuple[float, float]]

#: Rings of a wall follow its outline as near as this, metres: a third of the gap that is seen.
BEND_M = 0.003

DIRTY = [{"state": "DIRTY", "variants": ["dirty"], "parts": ["remains"]}]
FULL = [{"state": "FULL", "variants": ["full"], "parts": ["filling"]}]
WARE_STATES = [*BROKEN, *DIRTY]


def r_at(outer: Outline, z: float) -> float:
    """Radius of an outline (z rising) at a height."""
    return float(np.interp(z, [q for _, q in outer], [r for r, _ in outer]))


def wall_profile(
    outer: Outline, wall: float, floor: float, foot: float = 0.002
) -> tuple[Outline, list[int]]:
    """Lathe profile of a vessel, and per segment 0 outside, 1 inside, 2 foot, 3 rim."""
    points = np.array(outer)
    along = np.gradient(points, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    inner = points + wall * np.c_[-along[:, 1], along[:, 0]]
    inner[-1] = points[-1] - [wall, 0]
    within = [(r, z) for r, z in inner[::-1] if z > floor + 0.002 and r > wall]
    low = within[-1][0]
    base = outer[0][0]
    profile = [(0, foot), (base * 0.8, foot), (base * 0.86, 0), *outer]
    kinds = [2, 2, 2] + [0] * (len(outer) - 1)
    rim_r, rim_z = outer[-1]
    profile += [(rim_r - wall / 2, rim_z + wall * 0.25), *within]
    kinds += [3, 3] + [1] * (len(within) - 1)
    profile += [(min(low - 0.001, r_at(outer, floor) - wall) * 0.96, floor), (0, floor)]
    return profile, [*kinds, 1, 1]


def wall_pieces(outer: Outline, wall: float, floor: float, n: int = 8) -> list[np.ndarray]:
    """Convex pieces of a vessel that leave its inside free: rings where its wall bends."""
    points = np.array(outer)
    picks = {0, len(outer) - 1}
    while True:  # the wall's farthest point from the rings so far begins another
        ends = sorted(picks)
        off = np.abs(np.interp(points[:, 1], points[ends, 1], points[ends, 0]) - points[:, 0])
        if off.max() <= BEND_M:
            break
        picks.add(int(off.argmax()))
    pieces = [cylinder_piece(outer[0][0], 0, floor, 12, r_at(outer, floor))]
    for a, b in pairwise(sorted(picks)):
        (ra, za), (rb, zb) = outer[a], outer[b]
        within = [(max(ra - wall, 0.002), max(za, 0)), (max(rb - wall, 0.002), zb)]
        pieces += ring_pieces([(ra, za), (rb, zb)], within, n)
    return pieces


def hollow(outer: Outline, wall: float, floor: float) -> Container:
    """The free space of a vessel as a container."""
    top = outer[-1][1]
    narrow = min(r_at(outer, q) for q in np.linspace(floor + 0.3 * (top - floor), top, 6)) - wall
    side = 1.3 * narrow
    return Container("inside", (0, 0, (floor + top) / 2 + 0.001), (side, side, top - floor - 0.004))


def squared(mesh: Mesh, sx: float = 1.0, sy: float = 1.0, power: float = 5.0) -> Mesh:
    """Make a lathed thing rectangular with rounded corners (power 2: leave it oval)."""

    def pull(x, y, z):
        r = math.hypot(x, y)
        if r < 1e-9:
            return x, y, z
        c, s = abs(x / r), abs(y / r)
        f = (c**power + s**power) ** (-1 / power)
        return x * f * sx, y * f * sy, z

    return mesh.warp(pull)


def liquid(colour, radius: float, z: float, froth=None) -> Material:
    """A still liquid from above: darker edge, a window's reflection, froth along the rim."""
    m = Material(occlusion=0.15)
    far = m.distance((0, 0, z), (1, 1, 0))
    base = m.ramp(
        m.remap(far, 0, radius),
        [
            (0, shade(colour, 1.15)),
            (0.7, colour),
            (0.93, shade(colour, 0.85)),
            (1, froth or colour),
        ],
    )
    glint = m.distance((-0.36 * radius, 0.3 * radius, z), (1, 1.8, 0))
    return m.colour(m.mix(m.remap(glint, 0.14 * radius, 0.3 * radius, 0.75, 0), base, "ffffff"))


def surface_of(colour, radius: float, z: float, n: int = 18, froth=None) -> Mesh:
    """The visible top of a filling."""
    top = [(radius, z), (0.85 * radius, z + 0.0006), (0, z + 0.0008)]
    return lathe(top, n, mat=liquid(colour, radius, z, froth))


def runs(
    outer: Outline, rng: np.random.Generator, count: int, mat: Material, off: float, thick=0.0022
) -> list[Mesh]:
    """Dried runs down a wall (off: metres outside the outline; negative: on the inner side)."""
    top, found = outer[-1][1], []
    for k in range(count):
        a = TAU * (k + float(rng.uniform(-0.3, 0.3))) / count + 0.4
        low = top * (1 - float(rng.uniform(0.3, 0.72)))
        path = []
        for z in np.linspace(top - 0.001, low, 3):
            r = r_at(outer, z) + off
            path.append((r * math.cos(a), r * math.sin(a), z))
        widths = np.array([1.9, 1.0, 1.4]) * thick
        found.append(tube(path, widths, 3, mat=mat, weight=0.4))
    return found


def smear(x, y, z, radius: float, rng, mat: Material, height=0.002, n: int = 12) -> Mesh:
    """A flat, uneven patch of sauce."""
    wobble = rng.uniform(0.72, 1.18, n)
    flat = lathe(
        [(radius, 0), (0.86 * radius, height), (0, height)],
        n,
        mat=mat,
        rib=lambda k, i: float(wobble[i]) if k < 2 else 1.0,
        weight=0.5,
    )
    stretch = float(rng.uniform(0.75, 1.3))
    return flat.scale(stretch, 1 / stretch, 1).turn(rz=float(rng.uniform(0, 3))).move(x, y, z)


def noodle(x, y, z, size: float, rng, mat: Material, thick=0.0026) -> Mesh:
    """A strand of spaghetti in a loose curl."""
    a, bend = float(rng.uniform(0, 6.28)), float(rng.uniform(2.5, 4.5))
    path = []
    for t in np.linspace(0, 1, 7):
        r = size * (0.55 + 0.45 * t)
        path.append((x + r * math.cos(a + bend * t), y + r * math.sin(a + bend * t), z))
    return tube(path, thick, 4, mat=mat, weight=0.4)


def bone(x, y, z, length: float, yaw: float) -> list[Mesh]:
    """A gnawed chicken bone."""
    ivory = plain("e9dcc0", 0.12, 200)
    half, thick = length / 2, length * 0.07
    shaft = [(-half, 0, 0), (0, 0, thick * 0.4), (half, 0, 0)]
    meshes = [tube(shaft, [thick, thick * 0.8, thick], 5, mat=ivory)]
    for end in (-1, 1):
        for side in (-1, 1):
            at = (end * half, side * thick * 0.9, 0)
            meshes.append(ellipsoid(thick * 1.25, at, 5, 3, ivory))
    return [m.turn(rz=yaw).move(x, y, z + thick * 1.2) for m in meshes]


SAUCES = {
    "pasta": "b8321a",
    "peas": "6b4020",
    "bones": "7a4a22",
    "cake": "4a2614",
    "egg": "f0b020",
    "soup": "d0702a",
    "milk": "f6f2e6",
    "burnt": "2a1a10",
}


def remains(
    kind: str, radius: float, z: float, seed: int, spread: float = 0.8, n: int = 12
) -> list[Mesh]:
    """Leftovers on a flat round floor: sauce smears and scraps. kind: a key of SAUCES."""
    rng = np.random.default_rng(seed)
    sauce = plain(SAUCES[kind], 0.25, 90)
    found: list[Mesh] = []

    def at(share: float, angle: float) -> tuple[float, float]:
        return share * radius * math.cos(angle), share * radius * math.sin(angle)

    turn = float(rng.uniform(0, 6.28))
    for k, (share, size) in enumerate(((0.15, 0.5), (0.55, 0.24), (0.66, 0.17), (0.6, 0.13))):
        x, y = at(share * spread, turn + 1.7 * k)
        found.append(smear(x, y, z, size * radius, rng, sauce, n=n))
    scraps = {
        "pasta": ("e9c870", 3),
        "peas": ("5f9a32", 6),
        "egg": ("f8f4e6", 3),
        "cake": ("7a4a26", 5),
        "soup": ("e08a2a", 4),
        "milk": ("d8a050", 4),
        "burnt": ("5a3216", 5),
        "bones": ("c8924a", 3),
    }[kind]
    scrap = plain(scraps[0], 0.15, 150)
    for k in range(scraps[1]):
        x, y = at(float(rng.uniform(0.1, 0.75)) * spread, turn + 2.4 * k)
        size = max(0.004, 0.06 * radius)
        if kind == "pasta":
            found.append(noodle(x * 0.5, y * 0.5, z + 0.004, 0.42 * radius, rng, scrap))
        elif kind in ("cake", "bones", "burnt"):
            lump = box(1.6 * size, 1.3 * size, size, mat=scrap, weight=0.4)
            found.append(lump.turn(rz=float(rng.uniform(0, 3))).move(x, y, z))
        elif kind == "milk":
            hoop = [(0.5, 0), (1, 0.2), (1, 0.6), (0.5, 0.8)]
            ring = lathe([(r * size, h * size) for r, h in hoop], 5, mat=scrap, weight=0.3)
            found.append(ring.move(x, y, z + 0.001))
        else:
            flat = 0.45 if kind in ("egg", "soup") else 0.9
            wide = size * (2.2 if kind == "egg" else 1.0)
            found.append(ellipsoid((wide, wide * 0.8, size * flat), (x, y, z + 0.002), 6, 3, scrap))
    if kind == "bones":
        found += bone(*at(0.2, turn), z, radius * 0.95, turn + 0.6)
    return found


def spread_out(shards: list[Mesh], rng: np.random.Generator, share: float, gap: float) -> list:
    """Pull shards apart as they fell, each still the right way up; returns the pieces."""
    middle = np.mean([s.v.mean(0)[:2] for s in shards], axis=0)
    for shard in shards:
        shard.keep_pattern()
        away = shard.v.mean(0)[:2] - middle
        far = float(np.linalg.norm(away)) + 1e-9
        shift = away * share + away / far * gap * float(rng.uniform(0.6, 1.4))
        pivot = (*shard.v.mean(0)[:2], 0)
        shard.turn(rz=float(rng.normal(0, 0.16)), pivot=pivot).move(*shift, -shard.v[:, 2].min())
    return [s.v.copy() for s in shards]
