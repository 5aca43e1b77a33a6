"""Which pixels an object would cover with nothing in front of it: triangles without depth.

A scan-line rasteriser in numpy with OpenGL's rule: a pixel belongs to a triangle when its
centre lies inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array

Ints = npt.NDArray[np.int64]


def clip_near(triangles: Array, near_m: float) -> Array:
    """Camera-frame triangles (N, 3, 3) cut at z = ``near_m``; what lies nearer is dropped."""
    inside = triangles[:, :, 2] >= near_m
    if inside.all():
        return triangles
    count = inside.sum(axis=1)
    whole = triangles[count == 3]
    pieces = [whole]
    one = triangles[count == 1]
    if len(one):
        # Turn so that the vertex inside comes first, then pull the other two to the plane.
        a, b, c = _rolled(one, inside[count == 1])
        pieces.append(np.stack([a, _cut(a, b, near_m), _cut(a, c, near_m)], axis=1))
    two = triangles[count == 2]
    if len(two):
        # Turn so that the vertex outside comes first; the rest is a quadrilateral.
        a, b, c = _rolled(two, ~inside[count == 2])
        ab, ac = _cut(b, a, near_m), _cut(c, a, near_m)
        pieces.append(np.stack([ab, b, c], axis=1))
        pieces.append(np.stack([ab, c, ac], axis=1))
    return np.concatenate(pieces)


def _rolled(triangles: Array, first: npt.NDArray[np.bool_]) -> tuple[Array, Array, Array]:
    rows, start = np.arange(len(triangles)), first.argmax(axis=1)
    a, b, c = (triangles[rows, (start + k) % 3] for k in range(3))
    return a, b, c


def _cut(inside: Array, outside: Array, near_m: float) -> Array:
    share = (inside[:, 2] - near_m) / (inside[:, 2] - outside[:, 2])
    return np.asarray(inside + share[:, None] * (outside - inside), dtype=np.float64)


#: The smallest mask of covered pixels, and its rows and columns of the picture.
Covered = tuple[npt.NDArray[np.bool_], slice, slice]


def coverage(triangles: Array, k: Array, width: int, height: int, near_m: float) -> Covered:
    """Pixels that front faces of camera-frame triangles (N, 3, 3) cover, of a (height, width)
    picture."""
    return coverages([triangles], k, width, height, near_m)[0]


def coverages(
    things: Sequence[Array], k: Array, width: int, height: int, near_m: float
) -> list[Covered]:
    """What each of several things covers, given as camera-frame triangles (N, 3, 3): nearly all of
    it computed for all of them in one go, as most are small."""
    if not things:
        return []
    clipped = [clip_near(triangles, near_m) for triangles in things]
    owner = np.repeat(np.arange(len(things)), [len(triangles) for triangles in clipped])
    seen = np.concatenate(clipped)
    x = k[0, 0] * seen[:, :, 0] / seen[:, :, 2] + k[0, 2]
    y = k[1, 1] * seen[:, :, 1] / seen[:, :, 2] + k[1, 2]
    area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
    # Image y points down, so what is counter-clockwise in the world turns negative here.
    front = area < 0
    x, y, owner = x[front], y[front], owner[front]
    top = np.maximum(np.ceil(y.min(axis=1, initial=np.inf)), 0)
    bottom = np.minimum(np.floor(y.max(axis=1, initial=-np.inf)), height - 1)
    # Most triangles of a small thing lie between two rows or two columns of pixels.
    first = np.maximum(np.ceil(x.min(axis=1, initial=np.inf)), 0)
    last = np.minimum(np.floor(x.max(axis=1, initial=-np.inf)), width - 1)
    met = (bottom >= top) & (last >= first)
    x, y, top, owner = x[met], y[met], top[met].astype(np.int64), owner[met]
    rows = bottom[met].astype(np.int64) - top + 1
    before = np.cumsum(rows) - rows
    row = np.arange(rows.sum()) + np.repeat(top - before, rows)
    left, right = _span(x, y, rows, row.astype(np.float64))
    left, right = np.maximum(np.ceil(left), 0), np.minimum(np.floor(right), width - 1)
    kept = right >= left
    row, owner = row[kept], np.repeat(owner, rows)[kept]
    start, stop = left[kept].astype(np.int64), right[kept].astype(np.int64) + 1
    ends = np.searchsorted(owner, np.arange(len(things) + 1)).tolist()
    return [_mask(row[a:b], start[a:b], stop[a:b]) for a, b in pairwise(ends)]


def _mask(row: Ints, start: Ints, stop: Ints) -> Covered:
    """The mask of runs of pixels, one from ``start`` to before ``stop`` in each ``row``."""
    if len(row) == 0:
        return np.zeros((0, 0), dtype=bool), slice(0, 0), slice(0, 0)
    first_row, first_column = int(row.min()), int(start.min())
    down, across = int(row.max()) + 1 - first_row, int(stop.max()) - first_column
    # A run adds one where it begins and takes it away behind its end; one column more for that.
    base = (row - first_row) * (across + 1) - first_column
    cells = down * (across + 1)
    change = np.bincount(base + start, minlength=cells)
    change -= np.bincount(base + stop, minlength=cells)
    mask = (np.cumsum(change, out=change) > 0).reshape(down, across + 1)[:, :across]
    rows_cut = slice(first_row, first_row + down)
    return np.asarray(mask), rows_cut, slice(first_column, first_column + across)


def _span(x: Array, y: Array, rows: Ints, row: Array) -> tuple[Array, Array]:
    """Where each line y = ``row`` enters and leaves its triangle; the first triangle has the first
    ``rows[0]`` lines, and so on. The line leaves before it enters where it meets no edge."""
    left = np.full(len(row), np.inf)
    right = np.full(len(row), -np.inf)
    for a, b in ((0, 1), (1, 2), (2, 0)):
        rise = y[:, b] - y[:, a]
        # A level edge is met nowhere: its ends belong to the other two.
        rise[np.abs(rise) < 1e-12] = np.nan
        share = (row - np.repeat(y[:, a], rows)) / np.repeat(rise, rows)
        at = np.repeat(x[:, a], rows) + share * np.repeat(x[:, b] - x[:, a], rows)
        at[~((share >= 0) & (share <= 1))] = np.nan
        np.fmin(left, at, out=left)
        np.fmax(right, at, out=right)
    return left, right
