"""A tiny renderer of boxes for the toy home: the nearest box each pixel's ray meets."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
import numpy.typing as npt
from sdgen.geometry import Vec3, inverse, matrix
from sdgen.library.records import AssetInfo
from sdgen.scene import Camera, Frame, Scene

Array = npt.NDArray[np.float64]


def frame(scene: Scene, camera: Camera, infos: Mapping[str, AssetInfo]) -> Frame:
    """One view. Objects wear a colour each and are as large as their models; the left of one with
    two parts is the first, the right the second. The toy home has no ceilings (one looks in)."""
    sizes = tuple((info.id, info.extents_m) for info in infos.values())
    pixels = _frame(scene.model_dump_json(), camera.model_dump_json(), sizes)
    return Frame(camera, *pixels)


@lru_cache(maxsize=64)
def _frame(
    scene_json: str, camera_json: str, sizes: tuple[tuple[str, Vec3], ...]
) -> tuple[object, ...]:
    scene, camera = Scene.model_validate_json(scene_json), Camera.model_validate_json(camera_json)
    shape = (camera.height, camera.width)
    near = np.full(shape, np.inf)
    instance = np.zeros(shape, dtype=np.uint16)
    alone = {}
    for structure in scene.home.structures:
        if structure.category != "ceiling":
            for piece in structure.pieces:
                world = matrix(piece.center_m, (0, 0, 0, 1))
                depth = _box_depth(camera, world, np.asarray(piece.size_m) / 2)
                instance[depth < near] = structure.id
                near = np.minimum(near, depth)
    for thing in scene.objects:
        half = np.asarray(dict(sizes)[thing.asset]) / 2
        world = matrix(thing.pose.position_m, thing.pose.quat_xyzw)
        world[:3, 3] += world[:3, 2] * half[2]
        depth = _box_depth(camera, world, half)
        alone[thing.id] = int(np.isfinite(depth).sum())
        instance[depth < near] = thing.id
        near = np.minimum(near, depth)
    part = np.zeros(shape, dtype=np.uint8)
    for thing in scene.objects:
        _, columns = np.nonzero(instance == thing.id)
        if len(columns):
            right = np.arange(camera.width) > (columns.min() + columns.max()) / 2
            both = np.where(right, len(thing.parts), 1)
            part[instance == thing.id] = np.broadcast_to(both, shape)[instance == thing.id]
    depth_mm = np.where(np.isfinite(near), np.rint(1000 * near), 0).astype(np.uint16)
    # Ids spread over the colours, so that neighbours differ.
    spread = instance.astype(np.uint64) * 2654435761
    colours = [(spread >> shift & 255).astype(np.uint8) for shift in (8, 16, 24)]
    return np.stack(colours, axis=2), depth_mm, instance, part, alone


def _box_depth(camera: Camera, world_from_box: Array, half: Array) -> Array:
    """Planar depth (H, W) of a box, infinite beside it (slabs; Kay and Kajiya 1986)."""
    k = np.asarray(camera.K)
    rows, columns = np.mgrid[0 : camera.height, 0 : camera.width]
    rays = np.stack(
        [(columns - k[0, 2]) / k[0, 0], (rows - k[1, 2]) / k[1, 1], np.ones(rows.shape)], axis=-1
    )
    box_from_camera = inverse(world_from_box) @ np.asarray(camera.world_from_camera)
    origin, rays = box_from_camera[:3, 3], rays @ box_from_camera[:3, :3].T
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = (-half - origin) / rays, (half - origin) / rays
    enter = np.fmax.reduce(np.fmin(one, other), axis=-1)
    leave = np.fmin.reduce(np.fmax(one, other), axis=-1)
    return np.where((enter <= leave) & (enter > 0), enter, np.inf)
