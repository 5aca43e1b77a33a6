"""Surfaces of placed objects, and where on them a thing may be put.

Most spots that are tried fail. A surface is convex but for models that no one ships, and a thing
is a rectangle: plain arithmetic tells nearly all, in a tenth of the time that polygons take.
"""

from __future__ import annotations

import math
from functools import cached_property
from itertools import pairwise

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.facts.thresholds import TILTED_M
from sdgen.freespace import LEAST_M2, POINT_TRIES, random_point
from sdgen.geometry import Array, Vec2, Vec3, apply
from sdgen.kleene import YES
from sdgen.library.records import AssetInfo, Support
from sdgen.library.states import drawn_supports
from sdgen.library.supports import MARGIN_M
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: So much of a thing's footprint lies on the surface: what reaches further over the edge looks
#: about to fall.
CARRIED_SHARE = 0.97
#: Furniture that is higher than its surface by this, metres, has something beside the surface that
#: a small thing could enter; by less, it has a rim.
RISES_M = 0.03


class PlacingSurface:
    """A support of a placed object as it lies in the world: where a thing may be put.

    Its outline is a centimetre within the real one, that of :class:`~sdgen.facts.surfaces.Surface`,
    which says what a thing is ON.
    """

    def __init__(self, support: Support, points: Array, walled: bool = False) -> None:
        """``points`` (N, 3) is the support's outline in the world; ``walled`` says that what
        reaches beyond it stands in a wall of its owner, so that all of a thing lies within."""
        self.support = support
        self._most_lost = 1e-9 if walled else 1.0 - CARRIED_SHARE
        self.z_m = float(points[:, 2].mean())
        self.shape = shapely.polygons(points[:, :2])
        self._corner: Vec2 = tuple(points[:, :2].min(axis=0).tolist())
        self._size: Vec2 = tuple((points[:, :2].max(axis=0) - points[:, :2].min(axis=0)).tolist())
        self._sides = _sides(points[:, :2].tolist())

    @cached_property
    def edge(self) -> BaseGeometry:
        """The outline of the real one."""
        edge = self.shape.buffer(MARGIN_M, join_style="mitre")
        shapely.prepare(edge)
        return edge

    def random_point(self, rng: Rng) -> Vec2 | None:
        """What :func:`~sdgen.freespace.random_point` draws from the surface."""
        if not self._sides or self.support.area_m2 < 2 * LEAST_M2:
            return random_point(self.shape, rng)
        (x0, y0), (wide, deep) = self._corner, self._size
        for u, v in rng.random((POINT_TRIES, 2)).tolist():
            x, y = x0 + wide * u, y0 + deep * v
            if all(a * x + b * y > c for a, b, c in self._sides):
                return x, y
        middle = self.shape.representative_point()
        return float(middle.x), float(middle.y)

    def carries(self, size: Vec3, point: Vec2, yaw: float) -> bool:
        """True when enough of a thing's footprint of this size lies on the surface."""
        w, d = size[0] / 2, size[1] / 2
        cos, sin = math.cos(yaw), math.sin(yaw)
        lost = 0.0
        for a, b, c in self._sides:
            off = a * point[0] + b * point[1] - c
            lost_here = _share_beyond(abs(a * cos + b * sin) * w, abs(b * cos - a * sin) * d, off)
            if lost_here > self._most_lost:
                return False
            lost += lost_here
        if self._sides and lost <= self._most_lost:
            return True
        # At a corner two sides may cut off the same piece.
        turned = [
            (x * cos - y * sin, x * sin + y * cos) for x, y in ((-w, -d), (w, -d), (w, d), (-w, d))
        ]
        outline = shapely.polygons([(point[0] + x, point[1] + y) for x, y in turned])
        return bool(outline.difference(self.shape).area <= self._most_lost * outline.area)


def placing_surfaces(item: ObjectInstance, info: AssetInfo) -> list[PlacingSurface]:
    """The supports of a placed object that surely lie level, as they lie in the world."""
    world = item.pose.matrix()
    out = []
    for support, moved in drawn_supports(info, item.variant, item.joints):
        corners = apply(world @ moved, [(x, y, support.z_m) for x, y in support.polygon_m])
        if TILTED_M.at_most(float(np.ptp(corners[:, 2]))) == YES:
            # Bowls are round and give. Furniture that rises above a surface has walls, a back,
            # arms or a tap beside it, which bulge over its edge.
            walled = item.fixed and info.extents_m[2] > support.z_m + RISES_M
            out.append(PlacingSurface(support, corners, walled))
    return out


def _sides(ring: list[Vec2]) -> list[tuple[float, float, float]]:
    """(a, b, c) of each side of a counter-clockwise outline: inside where a x + b y > c, (a, b)
    of length 1. None at all of an outline that is not convex."""
    sides = []
    for (x0, y0), (x1, y1) in pairwise([*ring, ring[0]]):
        length = math.hypot(x1 - x0, y1 - y0)
        if length > 0:
            a, b = (y0 - y1) / length, (x1 - x0) / length
            sides.append((a, b, a * x0 + b * y0))
    convex = all(a * x + b * y > c - 1e-9 for a, b, c in sides for x, y in ring)
    return sides if convex else []


def _share_beyond(half_a: float, half_b: float, off: float) -> float:
    """Share of a rectangle beyond a line that its middle is ``off`` within. ``half_a`` and
    ``half_b`` are how far the halves of its sides reach across the line."""
    deep = half_a + half_b - off
    if deep <= 0.0:
        return 0.0
    a, b = 2 * max(half_a, 1e-6), 2 * max(half_b, 1e-6)
    # Two uniform spreads of widths a and b, added up: the share that exceeds ``off``.
    parts = deep**2 - max(0.0, deep - a) ** 2 - max(0.0, deep - b) ** 2
    return (parts + max(0.0, deep - a - b) ** 2) / (2 * a * b)
