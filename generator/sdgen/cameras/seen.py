"""What a home's views would show of a thing that is not there yet: depth maps of the furniture."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Sequence

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.framing import (
    Bools,
    Framed,
    enough,
    facing_pixels,
    framed,
    glance_pixels,
    uncut,
)
from sdgen.cameras.parts import part_area, part_points, world_triangles
from sdgen.cameras.sight import HEIGHT, WIDTH, Cast, pixel_rays
from sdgen.cameras.spots import SetTo
from sdgen.cameras.view import View, poses_of
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import EVIDENCE_PIXELS

#: Pixels across and down that one ray stands for: a hand's width at three metres.
_CELL = 16
#: Longer than any home.
_REACH_M = 25.0
#: Slack of a depth: what stands on a table top seen at a low angle is as far as the cell's middle,
#: give or take half of what its neighbours differ by.
_SLACK_M = (0.02, 0.15)
#: Parts that tell must show so many times what rays will count in the end: a thing hides some of
#: its own sides, and what is put there later more.
_TELLING_TIMES = 1.2
#: Floors are looked at so closely, metres.
_PATCH_M = 0.2


class Seen:
    """What a home's views would show, the furniture at rest: a
    :class:`~sdgen.home.context.Shows`."""

    def __init__(
        self,
        library: Library,
        views: Sequence[View],
        states: Sequence[SetTo],
        hidden: Collection[int],
        cast: Cast,
    ) -> None:
        """``states`` is what the views show set to a state, ``hidden`` the ids of furniture and
        rooms that they show nothing on."""
        self._library = library
        self._set_to: defaultdict[tuple[int, str], list[ObjectInstance]] = defaultdict(list)
        for one in states:
            self._set_to[one.item.id, one.state].append(one.item)
        self._hidden = frozenset(hidden)
        across, down = WIDTH // _CELL, HEIGHT // _CELL
        u, v = np.meshgrid((np.arange(across) + 0.5) * _CELL, (np.arange(down) + 0.5) * _CELL)
        pixels = np.stack([u.ravel() - 0.5, v.ravel() - 0.5], axis=1)
        self._poses = poses_of(views)
        #: How deep each view sees, cell by cell, the slack included.
        self._depth = np.empty((len(views), down, across))
        for k, pose in enumerate(self._poses):
            origins, targets = pixel_rays(pose, pixels, _REACH_M)
            reached = cast(origins, targets).distance_m / np.linalg.norm(targets - origins, axis=1)
            # Planar depth is a ray's share of its length.
            depth = (np.minimum(reached, 1.0) * _REACH_M).reshape(down, across)
            self._depth[k] = depth + np.clip(_slope(depth), *_SLACK_M)

    def anything_on(self, target_id: int) -> bool:
        """False when no view would show a thing on a piece of furniture, or on a room's floor."""
        return target_id not in self._hidden

    def floor(self, shape: BaseGeometry) -> BaseGeometry:
        """The part of a floor that views have in their pictures with no furniture before it,
        roughly: what is small and lies elsewhere is not seen."""
        if shape.is_empty:
            return shape
        x0, y0, x1, y1 = shape.bounds
        x, y = np.meshgrid(np.arange(x0, x1, _PATCH_M), np.arange(y0, y1, _PATCH_M))
        points = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
        at = framed(self._poses, points)
        seen = points[(at.inside & self._unhidden(at)).any(axis=0)]
        # Each point speaks for what is nearer to it than to its neighbours, and a little more:
        # things are larger than points.
        patches = shapely.box(*(seen[:, :2] - _PATCH_M).T, *(seen[:, :2] + _PATCH_M).T)
        return shape.intersection(shapely.union_all(patches))

    def set_to(self, object_id: int, state: str) -> tuple[ObjectInstance, ...]:
        """An object in a state, its leaves as far open as some view shows them."""
        return tuple(self._set_to.get((object_id, state), ()))

    def thing(self, corners_m: Array) -> bool:
        """True when some view shows enough of a thing with these outermost points (N, 3)."""
        at = framed(self._poses, corners_m)
        if not at.inside.any():
            return False
        shown = self._poses[enough(at, self._unhidden(at), corners_m)]
        return bool(uncut(shown, corners_m, corners_m).any())

    def telling(self, item: ObjectInstance, parts: Collection[str], pixels: int) -> bool:
        """True when some view would show enough of these parts of a thing where it is: so many
        pixels, or more of what is larger than a small thing."""
        corners = world_triangles(self._library, item, parts)
        at = framed(self._poses, corners.mean(axis=1))
        shown = facing_pixels(self._poses, corners, at.depth) * (at.inside & self._unhidden(at))
        area = part_area(self._library, item, parts)
        needed = _TELLING_TIMES * pixels / EVIDENCE_PIXELS * glance_pixels(area)
        poses = self._poses[shown.sum(axis=1) >= needed]
        whole = part_points(self._library, item, ())
        return bool(uncut(poses, whole, corners.reshape(-1, 3)).any())

    def _unhidden(self, at: Framed) -> Bools:
        """Which points in a picture no furniture stands before, (cameras, points)."""
        rows, columns = (
            np.where(at.inside, along // _CELL, 0).astype(np.int64) for along in (at.v, at.u)
        )
        reached = self._depth[np.arange(len(self._depth))[:, None], rows, columns]
        return np.asarray(at.depth <= reached)


def _slope(depth: Array) -> Array:
    """Half of what neighbouring cells of a depth map (H, W) differ by, along the steeper axis;
    at an edge, on the side where the surface goes on."""
    steps = []
    for axis in (0, 1):
        step = np.abs(np.diff(depth, axis=axis))
        before = np.insert(step, 0, np.inf, axis=axis)
        after = np.insert(step, step.shape[axis], np.inf, axis=axis)
        steps.append(np.minimum(before, after))
    return np.asarray(np.maximum(*steps) / 2)
