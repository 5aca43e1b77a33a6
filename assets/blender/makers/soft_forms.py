"""What makers of soft things share: pads, draped sheets, broken panes, thin bars."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import cloth
import numpy as np
from toolkit.materials import Material
from toolkit.mesh import Mesh
from toolkit.shapes import extrude, loft, spline, tube

from makers.convex import few_corners

Field = Callable[[np.ndarray], np.ndarray]


def bars(lines: Sequence, radius: float, mat: Material, n: int = 5) -> list[Mesh]:
    """Straight or bent rods, one a list of points."""
    return [tube(np.array(line, float), radius, n, mat=mat) for line in lines]


def bent(points: Sequence, radius, mat: Material, n: int = 6, per_span: int = 3, **more) -> Mesh:
    """A tube along a smooth curve."""
    return tube(spline(points, per_span), radius, n, mat=mat, **more)


def ring(n: int, rx: float, ry: float, z: float = 0.0, cx: float = 0.0, cy: float = 0.0):
    """An ellipse as a ring for lofts."""
    t = np.arange(n) * math.tau / n
    return np.c_[cx + rx * np.cos(t), cy + ry * np.sin(t), np.full(n, z)]


def pad(
    outline,
    height: float,
    mat: Material,
    edge: float = 0.3,
    crown: float = 0.0,
    mats: Sequence | None = None,
    top_from: int = 3,
) -> Mesh:
    """A stuffed or thick flat thing over a 2D outline (star-shaped about 0), on z = 0.

    edge: how much of the height is rounded; crown: rise of the middle above the rim.
    mats: (side, top): the top wears the second, its label upright as seen from +X.
    """
    p = np.asarray(outline, float)
    r = np.linalg.norm(p, axis=1, keepdims=True)
    e = height * edge

    def inset(d: float) -> np.ndarray:
        return p * np.maximum(0.05, 1 - d / r)

    section = [(inset(e * 0.7), 0.0), (p, e), (p, height - e), (inset(e), height)]
    if crown:
        section += [(p * 0.6, height + crown * 0.7)]
        section += [(p * 0.2, height + crown)]
    rings = [np.c_[q, np.full(len(p), z)] for q, z in section]
    if not mats:
        return loft(rings, mat)
    mesh = loft(rings, mats=list(mats), mat_of_face=lambda k, i: int(k >= top_from - 1))
    low, span = p.min(0), np.ptp(p, axis=0)
    far = 3 * float(span.max())
    for i, face in enumerate(mesh.f):
        corners = mesh.v[list(face)]
        flat = bool((corners[:, 2] > height - e - 1e-9).all())
        if len(face) > 4 or flat:
            up = corners[:, 2].mean() > height * 0.5
            mesh.mi[i] = int(up)
            mesh.label_uv[i] = [
                ((y - low[1]) / span[1], 1 - (x - low[0]) / span[0]) for x, y, _ in corners
            ]
            side = 1 if up else -1
            mesh.bake_uv[i] = [(far * (1 + up) + side * y, -x) for x, y, _ in corners]
    return mesh


def each_hull(meshes: Sequence[Mesh], least: float = 0.05, corners: int = 14) -> list[np.ndarray]:
    """A light hull of every mesh that is longer than `least`."""
    return [few_corners(m.v, corners) for m in meshes if np.ptp(m.v, axis=0).max() > least]


def footing(meshes: Sequence[Mesh], below: float = 0.02) -> np.ndarray:
    """A thin plate under all that touches the floor, so that the thing rests as modelled."""
    points = np.concatenate([m.v for m in meshes])
    near = few_corners(points[points[:, 2] < points[:, 2].min() + below] * [1, 1, 0], 26)
    return np.r_[near, near + np.array([0, 0, 0.003])]


# ---- draped cloth
def folds(rng: np.random.Generator, amount: float, scale: float = 1.0, waves: int = 4) -> Field:
    """Soft ridges as crumpled cloth has them, 0 .. `amount`; scale 1: about 15 cm apart."""
    a = rng.uniform(0, math.tau, waves)
    k = rng.uniform(16, 34, waves) / scale
    phase, bend = rng.uniform(0, math.tau, (2, waves))

    def height(p: np.ndarray) -> np.ndarray:
        total = np.zeros(len(p))
        for i in range(waves):
            along = p[:, 0] * math.cos(a[i]) + p[:, 1] * math.sin(a[i])
            across = p[:, 1] * math.cos(a[i]) - p[:, 0] * math.sin(a[i])
            wave = np.sin(k[i] * along + phase[i] + 1.3 * np.sin(0.45 * k[i] * across + bend[i]))
            total += (1 - np.abs(wave)) ** 1.3
        return amount * total / waves * 1.6

    return height


def mound(radius: tuple[float, float], height: float, rng: np.random.Generator) -> Field:
    """An uneven dome over the floor."""
    lumps = folds(rng, 0.5, 2.0)

    def field(p: np.ndarray) -> np.ndarray:
        r2 = (p[:, 0] / radius[0]) ** 2 + (p[:, 1] / radius[1]) ** 2
        return height * np.clip(1 - r2, 0, 1) ** 0.75 * (0.75 + lumps(p))

    return field


def drape(
    outline: Sequence,
    spacing: float,
    field: Field,
    fold: Field,
    at: tuple[float, float],
    turn: float,
    squeeze: tuple[float, float],
    mats: tuple[Material, Material],
    hem: float = 0.012,
) -> tuple[Mesh, Field]:
    """Lay a flat outline over a height field; also the field with it on top.

    Only the upper side is made, with a hem bent down around it: nobody sees below.
    """
    rest, triangles = cloth.fill_outline(outline, spacing)
    c, s = math.cos(turn), math.sin(turn)
    matrix = np.array([[c, -s], [s, c]]) @ np.diag(squeeze)
    flat = rest @ matrix.T + at
    z = field(flat) + hem + fold(flat)
    pull = 0.35 * fold(flat + np.array([0.03, 0.0])) - 0.35 * fold(flat - np.array([0.03, 0.0]))
    top = np.c_[flat[:, 0] + pull, flat[:, 1] - 0.7 * pull, z]
    triangles = triangles.tolist()
    edges = {edge for t in triangles for edge in zip(t, t[1:] + t[:1], strict=True)}
    rim = sorted(e for e in edges if e[::-1] not in edges)
    on_rim = sorted({v for e in rim for v in e})
    number = {v: len(top) + i for i, v in enumerate(on_rim)}
    centre = flat.mean(0)
    skirt = top[on_rim].copy()
    skirt[:, :2] += (skirt[:, :2] - centre) * 0.015
    skirt[:, 2] = np.maximum(skirt[:, 2] - 1.6 * hem - 0.8 * fold(flat[on_rim]), 0.0)
    low, span = rest.min(0), np.ptp(rest, axis=0)
    drawn = (rest - low) / span
    band = [(b, a, number[a], number[b]) for a, b in rim]
    faces = [*triangles, *band]
    label = [[tuple(drawn[i]) for i in t] for t in triangles] + [[(0, 0)] * 4 for _ in band]
    far = 2.5 * float(span.max())
    bake = [[tuple(rest[i]) for i in t] for t in triangles]
    bake += [
        [(far + rest[i][0], rest[i][1]) for i in (b, a)]
        + [(far + rest[i][0] * 1.04, rest[i][1] * 1.04) for i in (a, b)]
        for a, b in rim
    ]
    kinds = [0] * len(triangles) + [1] * len(band)
    mesh = Mesh(np.r_[top, skirt], faces, kinds, list(mats), label, bake)
    inverse = np.linalg.inv(matrix)

    def above(p: np.ndarray) -> np.ndarray:
        below = field(p)
        covered = cloth.inside((p - np.asarray(at)) @ inverse.T, outline)
        return np.where(covered, below + hem + fold(p), below)

    return mesh, above


def rectangle_outline(sx: float, sy: float) -> list[tuple[float, float]]:
    return [(-sx / 2, -sy / 2), (sx / 2, -sy / 2), (sx / 2, sy / 2), (-sx / 2, sy / 2)]


# ---- broken panes
def shards(
    outline, centre: tuple[float, float], rng: np.random.Generator, rays: int = 7
) -> list[np.ndarray]:
    """A convex pane cracked like a star about `centre`: convex pieces, one of them left out."""
    p = np.asarray(outline, float)
    reach = float(np.linalg.norm(p - p.mean(0), axis=1).max())
    angles = np.sort((np.arange(rays) + rng.uniform(-0.3, 0.3, rays)) * math.tau / rays)
    seeds = [np.array(centre)]
    for i, a in enumerate(angles):
        for r in (0.34 + 0.08 * (i % 2), 0.95):
            q = a + (0.25 if r > 0.5 else 0) + rng.uniform(-0.12, 0.12)
            seeds.append(np.array(centre) + reach * r * np.array([math.cos(q), math.sin(q)]))
    pieces = []
    for i, seed in enumerate(seeds):
        cell = p
        for j, other in enumerate(seeds):
            if j != i and len(cell):
                cell = _cut(cell, (seed + other) / 2, other - seed)
        if len(cell) > 2:
            pieces.append(cell)
    sizes = [abs(_area(c)) for c in pieces]
    missing = int(np.argsort(sizes)[len(sizes) // 2])
    return [c for i, c in enumerate(pieces) if i != missing]


def _area(p: np.ndarray) -> float:
    x, y = p[:, 0], p[:, 1]
    return float((x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2)


def _cut(p: np.ndarray, through: np.ndarray, away: np.ndarray) -> np.ndarray:
    """The part of a convex polygon behind a line."""
    d = (p - through) @ away
    out = []
    for i in range(len(p)):
        j = (i + 1) % len(p)
        if d[i] <= 0:
            out.append(p[i])
        if d[i] * d[j] < 0:
            out.append(p[i] + (p[j] - p[i]) * d[i] / (d[i] - d[j]))
    return np.array(out)


def pane_shards(
    outline, x: float, mat: Material, rng: np.random.Generator, centre=(0.0, 0.0), gap=0.006
) -> list[Mesh]:
    """Cracked glass facing +X over a (y, z) outline: pieces with gaps between, a little askew."""
    meshes = []
    for cell in shards(outline, centre, rng):
        middle = cell.mean(0)
        r = np.linalg.norm(cell - middle, axis=1, keepdims=True)
        cell = middle + (cell - middle) * np.maximum(0.3, 1 - gap / (r + 1e-9))
        piece = extrude(cell, 0.006, mat, axis="x").move(x)
        piece.label_uv = None
        pivot = (x, middle[0], middle[1])
        tilt = rng.uniform(-0.035, 0.035, 2)
        meshes.append(piece.turn(ry=float(tilt[0]), rz=float(tilt[1]), pivot=pivot))
    return meshes
