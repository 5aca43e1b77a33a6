"""What a camera would see, by rays: no picture is drawn, so geometry alone decides content."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from sdgen.cameras.pinhole import intrinsics
from sdgen.geometry import Array, apply, inverse

Ints = npt.NDArray[np.int64]

#: Pixels are always counted at this size, whatever size is rendered: options of pictures must
#: not decide content.
WIDTH, HEIGHT = 640, 480
#: Length of an overview's rays: longer than any home.
REACH_M = 25.0

#: Rays along each side of a target's rectangle: 256 come within 15 % of the picture's pixels.
GRID = 16
#: Points nearer to a camera than this are left out of the rectangle: they project anywhere.
_NEAREST_M = 0.05
#: Rays end this much behind the target's furthest point.
_BEYOND_M = 0.5
#: Rays across an overview: 300 in all, as many as find most things larger than a cup.
_ACROSS = 20


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


def in_picture(world_from_camera: Array, points_m: Array) -> npt.NDArray[np.bool_]:
    """Which world points (N, 3) fall into the picture, hidden or not."""
    seen = apply(inverse(world_from_camera), points_m)
    k = np.asarray(intrinsics(WIDTH, HEIGHT))
    across = np.abs(seen[:, 0]) <= seen[:, 2] * (WIDTH / 2) / k[0, 0]
    down = np.abs(seen[:, 1]) <= seen[:, 2] * (HEIGHT / 2) / k[1, 1]
    return np.asarray((seen[:, 2] > 0) & across & down)


def target_rays(
    world_from_camera: Array, points_m: Array, grid: int = GRID
) -> tuple[Array, Array, float]:
    """Rays over the picture's rectangle around ``points_m``, and pixels each ray stands for.

    No rays when the points are not in the picture.
    """
    seen = apply(inverse(world_from_camera), points_m)
    seen = seen[seen[:, 2] > _NEAREST_M]
    nothing = np.empty((0, 3))
    if len(seen) == 0:
        return nothing, nothing, 0.0
    k = np.asarray(intrinsics(WIDTH, HEIGHT))
    u = k[0, 0] * seen[:, 0] / seen[:, 2] + k[0, 2]
    v = k[1, 1] * seen[:, 1] / seen[:, 2] + k[1, 2]
    left, right = max(float(u.min()), -0.5), min(float(u.max()), WIDTH - 0.5)
    top, bottom = max(float(v.min()), -0.5), min(float(v.max()), HEIGHT - 0.5)
    if right <= left or bottom <= top:
        return nothing, nothing, 0.0
    steps = (np.arange(grid) + 0.5) / grid
    grid_u, grid_v = np.meshgrid(left + steps * (right - left), top + steps * (bottom - top))
    pixels = np.stack([grid_u.ravel(), grid_v.ravel()], axis=1)
    origins, targets = pixel_rays(world_from_camera, pixels, float(seen[:, 2].max()) + _BEYOND_M)
    return origins, targets, (right - left) * (bottom - top) / grid**2


def estimate_pixels(
    cast: Cast,
    poses: Sequence[Array],
    points_m: Array,
    object_id: int,
    parts: Ints,
    grid: int = GRID,
) -> Array:
    """Pixels at 640x480 of an object's ``parts`` that each camera pose would see, (len(poses),).

    ``points_m`` are the parts' vertices. All rays go in one cast.
    """
    rays = [target_rays(pose, points_m, grid) for pose in poses]
    if not any(len(r[0]) for r in rays):
        return np.zeros(len(poses))
    hits = cast(np.concatenate([r[0] for r in rays]), np.concatenate([r[1] for r in rays]))
    wanted = (hits.object_id == object_id) & np.isin(hits.part, parts)
    ends = np.cumsum([len(r[0]) for r in rays])
    counts = [int(part.sum()) for part in np.split(wanted, ends[:-1])]
    return np.array([n * r[2] for n, r in zip(counts, rays, strict=True)])


def overview_rays(world_from_camera: Array, across: int = _ACROSS) -> tuple[Array, Array]:
    """A coarse grid of rays over the whole picture."""
    down = across * HEIGHT // WIDTH
    u = (np.arange(across) + 0.5) * WIDTH / across - 0.5
    v = (np.arange(down) + 0.5) * HEIGHT / down - 0.5
    grid_u, grid_v = np.meshgrid(u, v)
    pixels = np.stack([grid_u.ravel(), grid_v.ravel()], axis=1)
    return pixel_rays(world_from_camera, pixels, REACH_M)
