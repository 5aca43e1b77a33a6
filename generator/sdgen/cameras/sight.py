"""What a camera would see, by rays: no picture is drawn, so geometry alone decides content."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from sdgen.cameras.pinhole import intrinsics
from sdgen.geometry import Array, apply
from sdgen.vocabulary import REFERENCE_SIZE

Ints = npt.NDArray[np.int64]

#: The size that pixels are counted at.
WIDTH, HEIGHT = REFERENCE_SIZE

#: Rays along each side of a target's rectangle: 256 come within 15 % of the picture's pixels.
GRID = 16
#: Points nearer to a camera than this are left out of the rectangle: they project anywhere.
_NEAREST_M = 0.05
#: Rays end this much behind the target's furthest point.
_BEYOND_M = 0.5


class Hits(Protocol):
    """What N rays met first: node id (0 = nothing), part (1-based index into the object's drawn
    parts, 0 for structures) and distance in metres (inf = nothing)."""

    @property
    def object_id(self) -> Ints: ...

    @property
    def part(self) -> Ints: ...

    @property
    def distance_m(self) -> Array: ...


class Cast(Protocol):
    """Casts rays into a scene; :meth:`sdgen.physics.rays.RayWorld.cast` does."""

    def __call__(self, origins_m: Array, targets_m: Array, /) -> Hits:
        """First thing each segment from (N, 3) origins to (N, 3) targets meets."""
        ...


def pixel_rays(world_from_camera: Array, pixels: Array, reach_m: float) -> tuple[Array, Array]:
    """Origins and targets of rays through canonical ``pixels`` (N, 2), to depth ``reach_m``."""
    k = np.asarray(intrinsics(WIDTH, HEIGHT))
    local = np.empty((len(pixels), 3))
    local[:, 0] = (pixels[:, 0] - k[0, 2]) / k[0, 0] * reach_m
    local[:, 1] = (pixels[:, 1] - k[1, 2]) / k[1, 1] * reach_m
    local[:, 2] = reach_m
    origins = np.repeat(world_from_camera[None, :3, 3], len(pixels), axis=0)
    return origins, apply(world_from_camera, local)


def target_rays(
    world_from_camera: Array,
    points_m: Array,
    grid: tuple[int, int] = (GRID, GRID),
    beyond_m: float = _BEYOND_M,
) -> tuple[Array, Array, Array]:
    """Rays over each picture's rectangle around ``points_m``, a ``grid`` (across, down) of them a
    camera, for (N, 4, 4) poses.

    Origins and targets, (M, 3), and the pixels that each ray of a camera stands for, (N,); cameras
    whose picture the points are not in have no rays, and 0.
    """
    eyes, turns = world_from_camera[:, :3, 3], world_from_camera[:, :3, :3]
    across, down = grid
    (left, right, top, bottom), depth = _rectangles(world_from_camera, points_m)
    shown = (right > left) & (bottom > top)
    pixels = np.where(shown, (right - left) * (bottom - top), 0.0) / (across * down)
    left, right, top, bottom = (side[shown, None, None] for side in (left, right, top, bottom))
    reach = depth[shown, None, None] + beyond_m
    k = np.asarray(intrinsics(WIDTH, HEIGHT))
    steps = (np.arange(across) + 0.5) / across
    steps_down = (np.arange(down)[:, None] + 0.5) / down
    local = np.empty((len(reach), down, across, 3))
    local[..., 0] = (left + steps * (right - left) - k[0, 2]) / k[0, 0] * reach
    local[..., 1] = (top + steps_down * (bottom - top) - k[1, 2]) / k[1, 1] * reach
    local[..., 2] = reach
    ends = (
        local.reshape(len(reach), across * down, 3) @ turns[shown].transpose(0, 2, 1)
        + eyes[shown, None]
    )
    return np.repeat(eyes[shown], across * down, axis=0), ends.reshape(-1, 3), pixels


def rectangle_pixels(world_from_camera: Array, points_m: Array) -> Array:
    """Pixels of each picture's rectangle around ``points_m``, (N,), for (N, 4, 4) poses; 0 where
    they are not in it."""
    sides, _ = _rectangles(world_from_camera, points_m)
    left, right, top, bottom = sides
    return np.maximum(right - left, 0.0) * np.maximum(bottom - top, 0.0)


def _rectangles(
    world_from_camera: Array, points_m: Array
) -> tuple[tuple[Array, Array, Array, Array], Array]:
    """Left, right, top and bottom of each picture's rectangle around ``points_m``, (N,) each, and
    how deep the furthest of them is."""
    eyes, turns = world_from_camera[:, :3, 3], world_from_camera[:, :3, :3]
    seen = points_m @ turns - eyes[:, None] @ turns
    depth = seen[..., 2]
    ahead = depth > _NEAREST_M
    k = np.asarray(intrinsics(WIDTH, HEIGHT))
    sides = []
    for axis, size in ((0, WIDTH), (1, HEIGHT)):
        along = k[axis, axis] * seen[..., axis] / np.where(ahead, depth, 1.0) + k[axis, 2]
        low = np.where(ahead, along, np.inf).min(axis=1)
        high = np.where(ahead, along, -np.inf).max(axis=1)
        sides += [np.maximum(low, -0.5), np.minimum(high, size - 0.5)]
    left, right, top, bottom = sides
    return (left, right, top, bottom), np.where(ahead, depth, 0.0).max(axis=1)


def estimate_pixels(
    cast: Cast,
    poses: Sequence[Array] | Array,
    points_m: Array,
    object_id: int,
    parts: Ints,
    grid: int = GRID,
) -> Array:
    """Pixels at 640x480 of an object's ``parts`` that each camera pose would see, (len(poses),).

    ``points_m`` are the parts' vertices. All rays go in one cast.
    """
    origins, targets, pixels = target_rays(
        np.asarray(poses).reshape(-1, 4, 4), points_m, (grid, grid)
    )
    if len(origins) == 0:
        return pixels
    hits = cast(origins, targets)
    wanted = (hits.object_id == object_id) & np.isin(hits.part, parts)
    counts = np.zeros(len(pixels))
    counts[pixels > 0] = wanted.reshape(-1, grid**2).sum(axis=1)
    return counts * pixels
