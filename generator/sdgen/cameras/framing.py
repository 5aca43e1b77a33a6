"""How large a thing shows in a picture, and when that is enough to tell what it is."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import shapely

from sdgen.cameras.pinhole import intrinsics
from sdgen.cameras.sight import HEIGHT, WIDTH
from sdgen.geometry import Array
from sdgen.vocabulary import EVIDENCE_PIXELS

Bools = npt.NDArray[np.bool_]

#: A view shows a thing when rays promise half as much again as is needed at the reference size:
#: rays are few and pictures exact.
RAYS_SHARE = 1.5
PIXELS_NEEDED = RAYS_SHARE * EVIDENCE_PIXELS
#: Surface of a small thing, a mug or a bowl; larger ones must show more pixels.
SMALL_M2 = 0.04
#: Enough to tell a wardrobe: 45 x 45 pixels. More would refuse most views of it.
GLANCE_MOST = 2000.0
#: Points nearer to a camera than this are not in its picture.
_NEAREST_M = 0.05
#: What is to lie somewhere must show so much of itself, by its outermost points, and so many times
#: the pixels that a glance needs: things fill half of their boxes, and others will stand before
#: them. Of what is large, less will do.
_SHARE, _TIMES = 0.75, 2.0
_LARGE_PIXELS = 10_000.0
#: What is no larger than this, metres, is judged by all of it: no edge of a picture cuts it, nor
#: comes so near, pixels. Of what is larger, a door or a fridge, so much must be in the picture.
_WHOLE_M, _EDGE_PIXELS, _MOST = 0.6, 4.0, 0.6


def glance_pixels(surface_m2: float) -> float:
    """Pixels at 640x480 that tell a thing at a glance, in proportion to what can be seen of it.

    A quarter of its surface is what a convex thing shows on average. Somewhat more than the
    promised 100 for small things; large ones must show more than a sliver.
    """
    return min(max(PIXELS_NEEDED, PIXELS_NEEDED * surface_m2 / SMALL_M2), GLANCE_MOST)


class Framed(NamedTuple):
    """Points as several cameras have them: pixel coordinates from the corner and planar depths,
    (cameras, points), and which fall into the picture."""

    u: Array
    v: Array
    depth: Array
    inside: Bools


def framed(poses: Array, points_m: Array) -> Framed:
    """Where ``world_from_camera`` poses (N, 4, 4) have world points (M, 3)."""
    eyes, turns = poses[:, :3, 3], poses[:, :3, :3]
    local = points_m @ turns - eyes[:, None] @ turns
    depth = local[..., 2]
    safe = np.maximum(depth, _NEAREST_M)
    k = np.asarray(intrinsics(WIDTH, HEIGHT))
    u = k[0, 0] * local[..., 0] / safe + WIDTH / 2
    v = k[1, 1] * local[..., 1] / safe + HEIGHT / 2
    inside = (depth > _NEAREST_M) & (u >= 0) & (u < WIDTH) & (v >= 0) & (v < HEIGHT)
    return Framed(u, v, depth, inside)


def uncut(poses: Array, points_m: Array, telling_m: Array) -> Bools:
    """Which cameras (N, 4, 4) have a thing with these points in their pictures, and no edge of them
    cuts it; or most of what tells, where it is large. (N,)"""
    large = float(np.ptp(points_m, axis=0).max()) > _WHOLE_M
    at = framed(poses, _filled(telling_m if large else points_m))
    off = _EDGE_PIXELS
    inside = at.inside & (at.u >= off) & (at.u <= WIDTH - off)
    inside &= (at.v >= off) & (at.v <= HEIGHT - off)
    return np.asarray(inside.mean(axis=1) >= (_MOST if large else 1.0))


def _filled(points_m: Array) -> Array:
    """Points all over the box around these, (64, 3)."""
    low, high = points_m.min(axis=0), points_m.max(axis=0)
    steps = np.linspace(0.0, 1.0, 4)
    shares = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3)
    return np.asarray(low + shares * (high - low))


def facing_pixels(poses: Array, corners_m: Array, depth: Array) -> Array:
    """Pixels of each triangle (M, 3, 3) that faces a camera, (N, M), nothing before it: about, by
    the planar ``depth`` of its middle, (N, M)."""
    first, second = corners_m[:, 1] - corners_m[:, 0], corners_m[:, 2] - corners_m[:, 0]
    normals, middles = np.cross(first, second) / 2, corners_m.mean(axis=1)
    facing = poses[:, :3, 3] @ normals.T - (middles * normals).sum(axis=1)
    focal = intrinsics(WIDTH, HEIGHT)[0][0]
    return np.asarray(np.maximum(facing, 0.0) * focal**2 / np.maximum(depth, _NEAREST_M) ** 3)


def enough(seen: Framed, unhidden: Bools, points_m: Array) -> Bools:
    """Which cameras would show a thing with these outermost points (M, 3) well, (N,).

    ``unhidden`` says which of the points, (N, M), nothing stands before.
    """
    share = (seen.inside & unhidden).mean(axis=1)
    pixels = np.zeros(len(share))
    u, v = np.clip(seen.u, 0, WIDTH), np.clip(seen.v, 0, HEIGHT)
    # No outline is larger than its box: most views are told by that.
    at_most = share * np.ptp(u, axis=1) * np.ptp(v, axis=1)
    rows = np.flatnonzero((share >= _SHARE) | (at_most >= 0.99 * _LARGE_PIXELS))
    if len(rows) == 0:
        return np.zeros(len(share), dtype=np.bool_)
    inner = np.stack([u[rows], v[rows]], axis=-1)
    pixels[rows] = share[rows] * shapely.area(shapely.convex_hull(shapely.multipoints(inner)))
    needed = _TIMES * glance_pixels(_surface_m2(points_m))
    return np.asarray((share >= _SHARE) & (pixels >= needed) | (pixels >= _LARGE_PIXELS))


def _surface_m2(points_m: Array) -> float:
    """About the surface of a thing with these outermost points: that of their box."""
    a, b, c = np.ptp(points_m, axis=0).tolist()
    return float(2.0 * (a * b + b * c + c * a))
