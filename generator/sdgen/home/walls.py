"""Walls of a floor plan on a grid: straight stretches with one room (or outdoors) on each side."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Vec2


@dataclass(frozen=True)
class Owners:
    """Which room each cell belongs to (negative: none); cells are ``cell_m`` wide, centred."""

    cells: npt.NDArray[np.int64]
    cell_m: float

    def corner(self, i: int, j: int) -> Vec2:
        """The point in metres at the lower corner of cell (i, j); the grid's middle is (0, 0)."""
        columns, rows = self.cells.shape
        return (
            round((i - columns / 2) * self.cell_m, 4) + 0.0,
            round((j - rows / 2) * self.cell_m, 4) + 0.0,
        )


@dataclass(frozen=True)
class Wall:
    """A straight stretch along an axis, from ``low_m`` to ``high_m``, at ``at_m`` across it.

    ``first`` lies on its lower side (smaller y or x), ``second`` on its upper.
    """

    first: int
    second: int
    along: Literal["x", "y"]
    at_m: float
    low_m: float
    high_m: float

    @property
    def length_m(self) -> float:
        """Length in metres, from middle line to middle line."""
        return self.high_m - self.low_m

    def point(self, t: float) -> Vec2:
        """The point at ``t`` along the axis."""
        return (t, self.at_m) if self.along == "x" else (self.at_m, t)


def shared_walls(owners: Owners) -> tuple[Wall, ...]:
    """Every stretch of wall between two different owners, in a fixed order."""
    out = _along_y(owners)
    flipped = _along_y(Owners(np.ascontiguousarray(owners.cells.T), owners.cell_m))
    out += [Wall(w.first, w.second, "x", w.at_m, w.low_m, w.high_m) for w in flipped]
    return tuple(out)


def _along_y(owners: Owners) -> list[Wall]:
    cells = owners.cells
    out: list[Wall] = []
    for i in range(1, cells.shape[0]):
        left, right = cells[i - 1], cells[i]
        changes = (left[1:] != left[:-1]) | (right[1:] != right[:-1])
        starts = [0, *(np.flatnonzero(changes) + 1).tolist(), cells.shape[1]]
        for start, end in pairwise(starts):
            if left[start] != right[start]:
                at, low = owners.corner(i, start)
                high = owners.corner(i, end)[1]
                out.append(Wall(int(left[start]), int(right[start]), "y", at, low, high))
    return out
