"""Pictures to points: what the pixels of each object say of where it is.

A pixel is a ray through its centre and a planar depth: a point of the surface it shows, to half a
millimetre. Masks and depth are drawn in one pass and never filtered, so that no pixel lies between
a thing and what is behind it; cameras that are not so kind are guarded against by leaving out
points that no neighbour of the same object is near.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.scene import Camera

Mask = npt.NDArray[np.uint16]
Points = npt.NDArray[np.float32]

#: Normals are taken between pixels so far to both sides: closer ones lie nearer to each other than
#: millimetres of depth can tell apart.
REACH_PX = 2
#: Cosine of the steepest slope that still counts as looking up: 26 degrees. Neighbours at an arm's
#: length tilt by some degrees through rounding alone; what is no level is told by heights later.
UPWARD = 0.9
#: What is nearer than the pixel above it by more than this share of its depth, metres, stands
#: before that: the outline ends there only because something hides the rest.
BEFORE_M = 0.05
BEFORE_SHARE = 0.02
#: A point further than this from all four neighbours of its object, in shares of its depth, hangs
#: in the air between two surfaces.
ALONE_SHARE = 0.1

#: All pairs of neighbours in a picture.
_BESIDE = ((np.s_[:-1, :], np.s_[1:, :]), (np.s_[:, :-1], np.s_[:, 1:]))


@dataclass(frozen=True)
class View:
    """One picture: ``instance`` (H, W) ids, ``depth_mm`` (H, W), 0 = none, and where it was taken;
    ``part`` (H, W) 1-based parts of each object, None where nothing tells."""

    camera: Camera
    instance: Mask
    depth_mm: Mask
    part: npt.NDArray[np.uint8] | None = None


@dataclass(frozen=True)
class Cloud:
    """What all views show of one object: ``points`` (N, 3) in the world, metres, and of each: the
    ``part`` it is of; whether the surface looks ``upward`` there; whether the object ``ends`` below
    it, with nothing before it that hides the rest; whether it ends beside it, at its ``rim``.
    ``pixels`` and ``part_pixels``: most that a view shows of the object, and of each part."""

    points: Points
    part: npt.NDArray[np.uint8]
    upward: npt.NDArray[np.bool_]
    ends: npt.NDArray[np.bool_]
    rim: npt.NDArray[np.bool_]
    pixels: int
    part_pixels: dict[int, int]


def unproject(camera: Camera, rows: Array, columns: Array, depth_m: Array) -> Array:
    """World points (N, 3) that pixels at these rows and columns show, at these planar depths."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    y = (rows - k[1, 2]) / k[1, 1]
    x = (columns - k[0, 2] - k[0, 1] * y) / k[0, 0]
    local = np.stack([x * depth_m, y * depth_m, depth_m], axis=-1)
    return np.asarray(local @ pose[:3, :3].T + pose[:3, 3])


def clouds(views: Iterable[View], ids: Iterable[int]) -> dict[int, Cloud]:
    """Points of those of these objects that any view shows, views together, by id."""
    wanted = np.zeros(2**16, dtype=np.bool_)
    wanted[list(ids)] = True
    found = [_pixels(view, wanted) for view in views]
    found = [one for one in found if len(one.owner)]
    if not found:
        return {}
    most: dict[int, int] = {}
    parts: dict[int, dict[int, int]] = {}
    for one in found:
        both, counts = np.unique(one.owner.astype(np.uint32) << 8 | one.part, return_counts=True)
        whole: dict[int, int] = {}
        for key, count in zip(both.tolist(), counts.tolist(), strict=True):
            owner, part = key >> 8, key & 0xFF
            of = parts.setdefault(owner, {})
            of[part] = max(of.get(part, 0), count)
            whole[owner] = whole.get(owner, 0) + count
        for owner, count in whole.items():
            most[owner] = max(most.get(owner, 0), count)
    owners = np.concatenate([one.owner for one in found])
    order = np.argsort(owners, kind="stable")
    owners = owners[order]
    points = np.concatenate([one.points for one in found])[order]
    parts_at = np.concatenate([one.part for one in found])[order]
    upward = np.concatenate([one.upward for one in found])[order]
    ends = np.concatenate([one.ends for one in found])[order]
    rim = np.concatenate([one.rim for one in found])[order]
    first = np.flatnonzero(np.diff(owners, prepend=0)).tolist()
    out = {}
    for a, b in zip(first, [*first[1:], len(owners)], strict=True):
        key = int(owners[a])
        out[key] = Cloud(
            points[a:b],
            parts_at[a:b],
            upward[a:b],
            ends[a:b],
            rim[a:b],
            most[key],
            parts[key],
        )
    return out


@dataclass(frozen=True)
class _Pixels:
    owner: Mask
    points: Points
    part: npt.NDArray[np.uint8]
    upward: npt.NDArray[np.bool_]
    ends: npt.NDArray[np.bool_]
    rim: npt.NDArray[np.bool_]


def _pixels(view: View, wanted: npt.NDArray[np.bool_]) -> _Pixels:
    """The pixels of wanted objects of one view."""
    instance = view.instance
    depth = view.depth_mm.astype(np.float32) / np.float32(1000)
    shown = wanted[instance] & (view.depth_mm > 0) & _held(instance, depth)
    world = _world(view.camera, depth)
    upward = _upward(instance, world)
    ends, rim = _ends(instance, depth), _rim(instance)
    part = np.zeros_like(instance, dtype=np.uint8) if view.part is None else view.part
    return _Pixels(
        instance[shown], world[shown], part[shown], upward[shown], ends[shown], rim[shown]
    )


def _world(camera: Camera, depth: npt.NDArray[np.float32]) -> Points:
    """World points (H, W, 3) of all pixels."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    height, width = depth.shape
    y = ((np.arange(height) - k[1, 2]) / k[1, 1])[:, None]
    x = (np.arange(width)[None] - k[0, 2] - k[0, 1] * y) / k[0, 0]
    # world = (right x + down y + forward) depth + eye: an axis at a time, for nothing larger is
    # ever kept than one picture of floats.
    out = np.empty((height, width, 3), dtype=np.float32)
    for axis in range(3):
        ray = pose[axis, 0] * x + pose[axis, 1] * y + pose[axis, 2]
        out[..., axis] = ray.astype(np.float32) * depth + np.float32(pose[axis, 3])
    return out


def _upward(instance: Mask, world: Points) -> npt.NDArray[np.bool_]:
    """Pixels (H, W) whose surface looks up, by the points of the same object around them."""
    out = np.zeros(instance.shape, dtype=np.bool_)
    n = REACH_PX
    middle = instance[n:-n, n:-n]
    same = (instance[n:-n, : -2 * n] == middle) & (instance[n:-n, 2 * n :] == middle)
    same &= (instance[: -2 * n, n:-n] == middle) & (instance[2 * n :, n:-n] == middle)
    across = world[n:-n, 2 * n :] - world[n:-n, : -2 * n]
    down = world[2 * n :, n:-n] - world[: -2 * n, n:-n]
    # Down the picture times across it looks at the camera.
    x = down[..., 1] * across[..., 2] - down[..., 2] * across[..., 1]
    y = down[..., 2] * across[..., 0] - down[..., 0] * across[..., 2]
    z = down[..., 0] * across[..., 1] - down[..., 1] * across[..., 0]
    out[n:-n, n:-n] = same & (z > 0) & (z * z >= UPWARD**2 * (x * x + y * y + z * z))
    return out


def _ends(instance: Mask, depth: npt.NDArray[np.float32]) -> npt.NDArray[np.bool_]:
    """Pixels (H, W) of the lower outline of objects, where what is below lies no nearer."""
    out = np.zeros(instance.shape, dtype=np.bool_)
    above, below = depth[:-1], depth[1:]
    hidden = (below > 0) & (below < above * np.float32(1 - BEFORE_SHARE) - np.float32(BEFORE_M))
    out[:-1] = (instance[:-1] != instance[1:]) & ~hidden
    return out


def _rim(instance: Mask) -> npt.NDArray[np.bool_]:
    """Pixels (H, W) beside another object's."""
    out = np.zeros(instance.shape, dtype=np.bool_)
    for a, b in _BESIDE:
        differ = instance[a] != instance[b]
        out[a] |= differ
        out[b] |= differ
    return out


def _held(instance: Mask, depth: npt.NDArray[np.float32]) -> npt.NDArray[np.bool_]:
    """Pixels (H, W) that some neighbour of their own object is near to in depth, or that have no
    such neighbour at all."""
    near = np.zeros(instance.shape, dtype=np.bool_)
    any_same = np.zeros(instance.shape, dtype=np.bool_)
    limit = depth * np.float32(ALONE_SHARE)
    for a, b in _BESIDE:
        same = instance[a] == instance[b]
        close = same & (np.abs(depth[a] - depth[b]) <= np.minimum(limit[a], limit[b]))
        for side in (a, b):
            any_same[side] |= same
            near[side] |= close
    return near | ~any_same
