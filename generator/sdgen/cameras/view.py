"""A camera's pose with what it is for, where a camera can stand, and the cameras of a scene."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
import numpy.typing as npt
from shapely.geometry import Point, Polygon

from sdgen.cameras.pinhole import FAR_M, NEAR_M, intrinsics, matrix4
from sdgen.cameras.sight import Cast
from sdgen.freespace import ROBOT_RADIUS_M
from sdgen.geometry import Array, look_at, vec3
from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import Camera, Home, Room
from sdgen.seeding import Rng

#: Robots differ, and one height would be a regularity to learn.
HEIGHT_JITTER_M = 0.1
#: Nothing may be nearer to a camera, or the robot would stand inside of it, or see nothing else.
CLEARANCE_M = ROBOT_RADIUS_M + 0.05
_CLEARANCE_RAYS = 8
#: Two views from nearer to each other than this, less than 35 degrees apart, are the same picture.
_SAME_M, _SAME_COS = 0.8, 0.82
#: Overviews look down or up by so much at most, a tangent (10 degrees): a floor is no room.
LEVEL = math.tan(math.radians(10.0))


@dataclass(frozen=True, eq=False)
class View:
    """Where a camera stands, (3,), the point it aims at, (3,), what it is for, of which room it is
    an overview, and what that is ``worth``, up to 1."""

    kind: Literal["room", "near"]
    eye_m: Array
    aim_m: Array
    overview_of: int | None = None
    worth: float = 1.0

    @cached_property
    def world_from_camera(self) -> Array:
        """The camera's pose, (4, 4)."""
        return look_at(vec3(self.eye_m), vec3(self.aim_m))

    def at(self, eye_height_m: float) -> View:
        """The same place looked at from another usual eye height; an overview stays level."""
        eye = self.eye_m + np.array([0.0, 0.0, eye_height_m - EYE_HEIGHT_M])
        aim = self.aim_m.copy()
        if self.kind == "room":
            steep = LEVEL * math.dist(aim[:2], eye[:2])
            aim[2] = min(max(aim[2], eye[2] - steep), eye[2] + steep)
        return replace(self, eye_m=eye, aim_m=aim)


def poses_of(views: Sequence[View]) -> Array:
    """``world_from_camera`` of views, (N, 4, 4)."""
    return np.array([view.world_from_camera for view in views]).reshape(-1, 4, 4)


def alike(views: Sequence[View]) -> npt.NDArray[np.bool_]:
    """Which two views are the same picture, nearly, (views, views)."""
    poses = poses_of(views)
    apart = np.linalg.norm(poses[:, None, :3, 3] - poses[None, :, :3, 3], axis=-1)
    return np.asarray((apart < _SAME_M) & (poses[:, :3, 2] @ poses[:, :3, 2].T > _SAME_COS))


def to_cameras(
    views: Sequence[View], home: Home, size: tuple[int, int], rng: Rng
) -> tuple[Camera, ...]:
    """Cameras of ``size`` (width, height) of these views, in a drawn order."""
    order = rng.permutation(len(views))
    return tuple(
        Camera(
            index=index,
            kind=views[k].kind,
            room_id=_room_id(home.rooms, views[k]),
            width=size[0],
            height=size[1],
            K=intrinsics(*size),
            world_from_camera=matrix4(views[k].world_from_camera),
            near_m=NEAR_M,
            far_m=FAR_M,
            daylight=home.daylight,
        )
        for index, k in enumerate(order.tolist())
    )


def _room_id(rooms: Sequence[Room], view: View) -> int:
    """The room that a camera stands in or, in a doorway, on whose side."""
    eye = Point(*view.eye_m[:2].tolist())
    return min(rooms, key=lambda room: Polygon(room.polygon_m).distance(eye)).id


def clear(cast: Cast, views: Sequence[View], below_m: float = 0.0) -> npt.NDArray[np.bool_]:
    """Which views have nothing within :data:`CLEARANCE_M` of their eye, at its height or so far
    below it, (N,)."""
    eyes = np.array([view.eye_m for view in views]).reshape(-1, 3) - (0.0, 0.0, below_m)
    angles = np.arange(_CLEARANCE_RAYS) * (2 * math.pi / _CLEARANCE_RAYS)
    ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(len(angles))]) * CLEARANCE_M
    origins = np.repeat(eyes, len(ring), axis=0)
    hits = cast(origins, origins + np.tile(ring, (len(eyes), 1)))
    return np.asarray((hits.object_id.reshape(-1, len(ring)) == 0).all(axis=1))
