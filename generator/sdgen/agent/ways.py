"""Shortest ways through free space: along straight lines from corner to corner.

A shortest way among polygons bends at their corners alone (the visibility graph, Lozano-Pérez and
Wesley 1979), and only where free space lies around more than half of one.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.freespace import polygons
from sdgen.geometry import Array, Vec2

#: A line may touch the edge of free space, whose corners are rounded to millimetres.
TOUCH_M = 0.002


class Ways:
    """Shortest ways within a shape."""

    def __init__(self, shape: BaseGeometry) -> None:
        self.within = shape.buffer(TOUCH_M, join_style="mitre")
        shapely.prepare(self.within)
        #: Where ways may bend, (N, 2).
        self.corners = np.array([*_bends(shape)], dtype=np.float64).reshape(-1, 2)
        first, second = np.triu_indices(len(self.corners), 1)
        self._near = self.joined(self.corners, first, second)

    def joined(
        self, points: Array, first: npt.NDArray[np.int64], second: npt.NDArray[np.int64]
    ) -> list[list[tuple[int, float]]]:
        """Of each of these points those of its pairs (indices ``first`` and ``second``) to which a
        straight line leads within, and how far they are."""
        seen = self.all_seen(points[first], points[second])
        apart = np.hypot(*(points[first] - points[second]).T)
        near: list[list[tuple[int, float]]] = [[] for _ in points]
        for a, b, far in zip(
            first[seen].tolist(), second[seen].tolist(), apart[seen].tolist(), strict=True
        ):
            near[a].append((b, far))
            near[b].append((a, far))
        return near

    def all_seen(self, a: Array, b: Array) -> npt.NDArray[np.bool_]:
        """Whether the straight lines between points (n, 2) lie within, (n,)."""
        if not len(a):
            return np.zeros(0, dtype=np.bool_)
        lines = shapely.linestrings(np.stack([a, b], axis=1))
        return np.asarray(shapely.covers(self.within, lines))

    def sees(self, a: Vec2, b: Vec2) -> bool:
        """Whether the straight line between two points lies within."""
        return bool(self.all_seen(np.array([a]), np.array([b]))[0])

    def route(self, start: Vec2, goal: Vec2) -> tuple[Vec2, ...] | None:
        """The corners of the shortest way, start and goal among them; None where there is none."""
        if start == goal:
            return (start,)
        if self.sees(start, goal):
            return start, goal
        from_start, to_goal = (self._reached(point) for point in (start, goal))
        best = dict(from_start)
        before: dict[int, int | None] = dict.fromkeys(best)
        queue = [(far, k) for k, far in best.items()]
        heapq.heapify(queue)
        done: set[int] = set()
        end: tuple[float, int] | None = None
        while queue:
            far, k = heapq.heappop(queue)
            if end is not None and far >= end[0]:
                break
            if k in done:
                continue
            done.add(k)
            if k in to_goal and (end is None or far + to_goal[k] < end[0]):
                end = far + to_goal[k], k
            for other, more in self._near[k]:
                if far + more < best.get(other, math.inf):
                    best[other], before[other] = far + more, k
                    heapq.heappush(queue, (far + more, other))
        if end is None:
            return None
        way: list[Vec2] = [goal]
        at: int | None = end[1]
        while at is not None:
            x, y = self.corners[at].tolist()
            way.append((x, y))
            at = before[at]
        return (start, *reversed(way))

    def _reached(self, point: Vec2) -> dict[int, float]:
        """Corners that are seen from a point, and how far each is."""
        here = np.tile(np.asarray(point, dtype=np.float64), (len(self.corners), 1))
        seen = np.flatnonzero(self.all_seen(here, self.corners))
        return {int(k): math.dist(point, self.corners[k]) for k in seen.tolist()}


def _bends(shape: BaseGeometry) -> Iterator[Vec2]:
    """Corners around which a way may bend: free space lies around more than half of each."""
    for polygon in polygons(shape):
        for k, ring in enumerate((polygon.exterior, *polygon.interiors)):
            points = np.asarray(shapely.simplify(ring, 0.0).coords)[:-1]
            # Free space lies to the left of an exterior that runs counter-clockwise, and outside
            # of an interior, so to the left of one that runs clockwise.
            if ring.is_ccw != (k == 0):
                points = points[::-1]
            before, after = (
                points - np.roll(points, 1, axis=0),
                np.roll(points, -1, axis=0) - points,
            )
            turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
            yield from ((float(x), float(y)) for x, y in points[turn < 0])


def length_m(way: Sequence[Vec2]) -> float:
    """How long a way is."""
    return math.fsum(math.dist(a, b) for a, b in pairwise(way))


def first_part(way: Sequence[Vec2], most_m: float) -> tuple[Vec2, ...]:
    """As much of a way, from its start, as is so long."""
    out = [way[0]]
    left = most_m
    for a, b in pairwise(way):
        far = math.dist(a, b)
        if far > left:
            share = left / far
            out.append((a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])))
            break
        out.append(b)
        left -= far
    return tuple(out)
