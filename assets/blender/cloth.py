"""A small cloth solver (position based dynamics, numpy only) for garments thrown on the floor.

A garment is a flat outline filled with a square grid. Garments start crumpled in the air, one above
the other, and fall. Particles keep their distance from each other, so layers lie on one another
instead of passing through. Runs the same everywhere: no threads, no Blender simulation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

Outline = Sequence[tuple[float, float]]


@dataclass
class Sheet:
    """A flat piece of cloth: rest points (n, 2), triangles, and where it starts in the world."""

    rest: np.ndarray
    triangles: np.ndarray
    start: np.ndarray


def inside(points: np.ndarray, outline: Outline) -> np.ndarray:
    """Even-odd test of points (n, 2) against a polygon."""
    corners = np.asarray(outline, float)
    result = np.zeros(len(points), bool)
    for (xa, ya), (xb, yb) in zip(corners, np.roll(corners, -1, 0), strict=True):
        crosses = (ya > points[:, 1]) != (yb > points[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            x = (xb - xa) * (points[:, 1] - ya) / (yb - ya) + xa
        result ^= crosses & (points[:, 0] < x)
    return result


def fill_outline(outline: Outline, spacing: float) -> tuple[np.ndarray, np.ndarray]:
    """Fill a polygon with a grid whose border follows it; return points (n, 2) and triangles."""
    corners = np.asarray(outline, float)
    low, high = corners.min(0), corners.max(0)
    counts = np.maximum(np.round((high - low) / spacing).astype(int), 1)
    step = (high - low) / counts
    index: dict[tuple[int, int], int] = {}
    points: list[np.ndarray] = []
    triangles: list[tuple[int, int, int]] = []

    def vertex(i: int, j: int) -> int:
        if (i, j) not in index:
            index[i, j] = len(points)
            points.append(low + step * (i, j))
        return index[i, j]

    for i in range(counts[0]):
        for j in range(counts[1]):
            centre = low + step * (i + 0.5, j + 0.5)
            if not inside(centre[None], outline)[0]:
                continue
            a, b, c, d = vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    return _snap_border(np.array(points), np.array(triangles), corners), np.array(triangles)


def _snap_border(points: np.ndarray, triangles: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Move border points of the grid onto the outline, so that slanted edges are straight."""
    edges: dict[tuple[int, int], int] = {}
    for a, b, c in triangles.tolist():
        for i, j in ((a, b), (b, c), (c, a)):
            edges[min(i, j), max(i, j)] = edges.get((min(i, j), max(i, j)), 0) + 1
    border = sorted({v for edge, count in edges.items() if count == 1 for v in edge})
    start, along = corners, np.roll(corners, -1, 0) - corners
    result = points.copy()
    for v in border:
        t = np.clip(((points[v] - start) * along).sum(1) / (along**2).sum(1), 0, 1)
        nearest = start + along * t[:, None]
        result[v] = nearest[np.linalg.norm(nearest - points[v], axis=1).argmin()]
    return result


def throw(
    outline: Outline,
    spacing: float,
    height: float,
    crumple: float,
    rng: np.random.Generator,
    aside: float = 0.05,
) -> Sheet:
    """Place a garment in the air, turned at random and pressed together sideways by `crumple`.

    aside: how far off the middle it may start.
    """
    rest, triangles = fill_outline(outline, spacing)
    centred = rest - rest.mean(0)
    turn = rng.uniform(0, 2 * np.pi)
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    flat = centred @ rotation.T * (1 - crumple) + rng.uniform(-aside, aside, 2)
    waves = np.zeros(len(flat))
    for _ in range(5):
        direction = rng.normal(size=2)
        direction /= np.linalg.norm(direction)
        waves += np.sin(flat @ direction * rng.uniform(18, 42) + rng.uniform(0, 6.28)) * 0.02
    start = np.c_[flat, height + waves + rng.normal(0, 0.003, len(flat))]
    return Sheet(rest, triangles, start)


def _springs(sheets: list[Sheet]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Distance constraints along edges, and weak ones across shared edges (bending)."""
    pairs, lengths, stiffness, offset = [], [], [], 0
    for sheet in sheets:
        opposite: dict[tuple[int, int], list[int]] = {}
        for a, b, c in sheet.triangles.tolist():
            for i, j, k in ((a, b, c), (b, c, a), (c, a, b)):
                opposite.setdefault((min(i, j), max(i, j)), []).append(k)
        for (i, j), far in opposite.items():
            pairs.append((i + offset, j + offset))
            lengths.append(np.linalg.norm(sheet.rest[i] - sheet.rest[j]))
            stiffness.append(1.0)
            if len(far) == 2:
                pairs.append((far[0] + offset, far[1] + offset))
                lengths.append(np.linalg.norm(sheet.rest[far[0]] - sheet.rest[far[1]]))
                stiffness.append(0.06)
        offset += len(sheet.rest)
    return np.array(pairs), np.array(lengths), np.array(stiffness)


def settle(sheets: list[Sheet], gap: float, radius: float, steps: int = 300) -> list[np.ndarray]:
    """Let the sheets fall on the floor; `gap` is the least distance between cloth particles.

    For most of the time an invisible drum of `radius` keeps the garments in one heap, then it goes.
    """
    position = np.concatenate([s.start for s in sheets])
    velocity = np.zeros_like(position)
    pairs, lengths, stiffness = _springs(sheets)
    joined = np.eye(len(position), dtype=bool)
    joined[pairs[:, 0], pairs[:, 1]] = joined[pairs[:, 1], pairs[:, 0]] = True
    degree = np.bincount(pairs.ravel(), minlength=len(position))[:, None]
    upper = np.triu(~joined)
    dt = 1 / 90
    for step in range(steps):
        velocity[:, 2] -= 9.81 * dt
        velocity *= 0.97
        target = position + np.clip(velocity, -2.0, 2.0) * dt
        for sweep in range(12):
            if sweep % 3 == 0:
                i, j, push = _overlaps(target, upper, gap)
                np.add.at(target, i, push)
                np.add.at(target, j, -push)
            line = target[pairs[:, 0]] - target[pairs[:, 1]]
            length = np.linalg.norm(line, axis=1) + 1e-9
            shift = (stiffness * (length - lengths) / length * 0.5)[:, None] * line
            change = np.zeros_like(target)
            np.add.at(change, pairs[:, 0], -shift)
            np.add.at(change, pairs[:, 1], shift)
            target += change / degree * 2.0
            np.maximum(target[:, 2], 0.004, out=target[:, 2])
            if step < 0.85 * steps:
                reach = np.linalg.norm(target[:, :2], axis=1, keepdims=True)
                target[:, :2] *= np.minimum(1, radius / (reach + 1e-9))
        velocity = (target - position) / dt
        velocity[target[:, 2] < 0.006, :2] *= 0.3
        position = target
    ends = np.cumsum([len(s.start) for s in sheets])[:-1]
    return np.split(position, ends)


def _overlaps(
    points: np.ndarray, candidates: np.ndarray, gap: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pairs of particles that are too close, and how far to push the first of each."""
    squared = (points**2).sum(1)
    distance2 = squared[:, None] + squared[None] - 2 * points @ points.T
    i, j = np.nonzero(candidates & (distance2 < gap * gap))
    delta = points[i] - points[j]
    distance = np.linalg.norm(delta, axis=1) + 1e-9
    return i, j, ((gap - distance) / distance * 0.4)[:, None] * delta


SHIRT: Outline = [
    (-0.24, -0.34),
    (0.24, -0.34),
    (0.24, 0.12),
    (0.36, 0.02),
    (0.44, 0.16),
    (0.26, 0.34),
    (0.10, 0.34),
    (0.0, 0.26),
    (-0.10, 0.34),
    (-0.26, 0.34),
    (-0.44, 0.16),
    (-0.36, 0.02),
    (-0.24, 0.12),
]
TROUSERS: Outline = [
    (-0.20, 0.48),
    (0.20, 0.48),
    (0.24, -0.48),
    (0.06, -0.48),
    (0.0, 0.20),
    (-0.06, -0.48),
    (-0.24, -0.48),
]
SOCK: Outline = [
    (-0.05, 0.18),
    (0.05, 0.18),
    (0.05, -0.06),
    (0.16, -0.08),
    (0.16, -0.18),
    (-0.05, -0.18),
]
TOWEL: Outline = [(-0.22, -0.34), (0.22, -0.34), (0.22, 0.34), (-0.22, 0.34)]
