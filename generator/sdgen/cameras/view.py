"""A camera's pose with what it is for, where a camera can stand, and the cameras of a scene."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.pinhole import FAR_M, NEAR_M, intrinsics, matrix4
from sdgen.cameras.sight import Cast
from sdgen.freespace import ROBOT_RADIUS_M
from sdgen.geometry import Array
from sdgen.scene import Camera, Scene
from sdgen.seeding import Rng

#: Robots differ, and one height would be a regularity to learn.
HEIGHT_JITTER_M = 0.1
#: Nothing may be nearer to a camera, or the robot would stand inside of it, or see nothing else.
CLEARANCE_M = ROBOT_RADIUS_M + 0.05
_CLEARANCE_RAYS = 8


@dataclass(frozen=True)
class View:
    """A camera's pose, what it is for and the room it stands in."""

    kind: Literal["room", "near"]
    room_id: int
    world_from_camera: Array


def to_cameras(views: Sequence[View], size: tuple[int, int], rng: Rng) -> tuple[Camera, ...]:
    """Cameras of ``size`` (width, height) at these poses, in a drawn order."""
    order = rng.permutation(len(views))
    return tuple(
        Camera(
            index=index,
            kind=views[k].kind,
            room_id=views[k].room_id,
            width=size[0],
            height=size[1],
            K=intrinsics(*size),
            world_from_camera=matrix4(views[k].world_from_camera),
            near_m=NEAR_M,
            far_m=FAR_M,
        )
        for index, k in enumerate(order.tolist())
    )


def free_area(scene: Scene) -> BaseGeometry:
    """Where a robot's centre, and so a camera, can be."""
    rings = [Polygon(ring) for ring in scene.free_space if len(ring) >= 3]
    return shapely.union_all([r if r.is_valid else r.buffer(0) for r in rings])


def clear(cast: Cast, eyes_m: Array) -> Array:
    """1.0 for eyes (N, 3) with nothing within :data:`CLEARANCE_M` at their height, else 0.0."""
    angles = np.arange(_CLEARANCE_RAYS) * (2 * math.pi / _CLEARANCE_RAYS)
    ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(len(angles))]) * CLEARANCE_M
    origins = np.repeat(eyes_m, len(ring), axis=0)
    hits = cast(origins, origins + np.tile(ring, (len(eyes_m), 1)))
    nothing = hits.object_id.reshape(-1, len(ring)) == 0
    return np.asarray(nothing.all(axis=1), dtype=np.float64)
