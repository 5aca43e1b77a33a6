"""Outlines as the rectangles that a base home is drawn with."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np
import shapely
from shapely import affinity
from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry

Rect = tuple[float, float, float, float]

#: Lines of one outline nearer to each other than this are one, metres.
_SAME_M = 0.02
#: Bounds the work: an outline that is drawn with more lines is none of rooms.
_MOST_LINES = 80
#: Corners nearer than this to a straight line are none, metres.
_STRAIGHT_M = 0.05
_DIGITS = 4


def rectangles_of(shape: BaseGeometry) -> tuple[Rect, ...]:
    """Rectangles along the axes that cover a shape: cells between its own lines that lie in it for
    the most part, joined to as few as one row takes. Aslant sides become stairs."""
    shape = shape.simplify(_STRAIGHT_M) if len(shapely.get_coordinates(shape)) > 400 else shape
    points = shapely.get_coordinates(shape)
    if not len(points):
        return ()
    xs, ys = (merged(points[:, k], _SAME_M) for k in (0, 1))
    if len(xs) > _MOST_LINES or len(ys) > _MOST_LINES:
        xs, ys = (np.linspace(v[0], v[-1], min(len(v), _MOST_LINES)) for v in (xs, ys))
    if len(xs) < 2 or len(ys) < 2:
        return ()
    shapely.prepare(shape)
    rows: list[list[Rect]] = []
    for low, high in pairwise(ys):
        row: list[Rect] = []
        for left, right in pairwise(xs):
            cell = box(left, low, right, high)
            if shape.intersection(cell).area < 0.5 * cell.area:
                continue
            if row and row[-1][2] == left:
                row[-1] = (row[-1][0], low, right, high)
            else:
                row.append((left, low, right, high))
        rows.append(row)
    return _stacked(rows)


def _stacked(rows: Sequence[Sequence[Rect]]) -> tuple[Rect, ...]:
    """Rows joined where one has the same left and right as the one below."""
    done: list[Rect] = []
    open_: list[Rect] = []
    for row in rows:
        going = []
        for rect in row:
            below = next((r for r in open_ if r[0] == rect[0] and r[2] == rect[2]), None)
            if below is not None and below[3] == rect[1]:
                open_.remove(below)
                rect = (below[0], below[1], rect[2], rect[3])
            going.append(rect)
        done += open_
        open_ = going
    every = sorted(done + open_)
    return tuple(tuple(round(float(v), _DIGITS) + 0.0 for v in r) for r in every)  # type: ignore[misc]


def merged(
    values: Iterable[float], within_m: float
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Values in rising order, those that follow each other within ``within_m`` as their middle."""
    ordered = np.unique(np.asarray(list(values), dtype=float))
    if not len(ordered):
        return ordered
    groups = np.split(ordered, np.flatnonzero(np.diff(ordered) > within_m) + 1)
    return np.array([(group[0] + group[-1]) / 2 for group in groups])


def joined(rectangles: Iterable[Rect]) -> BaseGeometry:
    """What rectangles cover."""
    return shapely.union_all([box(*rectangle) for rectangle in rectangles])


def main_turn(shapes: Iterable[BaseGeometry]) -> float:
    """How far, in radians within an eighth of a circle, the sides of shapes are turned off the
    axes, by their lengths."""
    turns, lengths = [], []
    for shape in shapes:
        for part in shapely.get_parts(shape):
            ring = shapely.get_coordinates(part.exterior if isinstance(part, Polygon) else part)
            steps = np.diff(ring, axis=0)
            turns.append(np.arctan2(steps[:, 1], steps[:, 0]))
            lengths.append(np.hypot(steps[:, 0], steps[:, 1]))
    if not turns:
        return 0.0
    angles, weights = np.concatenate(turns), np.concatenate(lengths)
    # Four times the angle is the same for sides that stand square on each other.
    mean = (weights * np.exp(4j * angles)).sum()
    if abs(mean) < 0.5 * weights.sum():  # round, or everywhere: as good as any
        return 0.0
    turn = float(np.angle(mean)) / 4
    return turn if abs(turn) > 1e-4 else 0.0


def turned(shape: BaseGeometry, angle_rad: float) -> BaseGeometry:
    """A shape turned about the origin."""
    return affinity.rotate(shape, angle_rad, origin=(0, 0), use_radians=True)
