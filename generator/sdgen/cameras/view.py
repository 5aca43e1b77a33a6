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
from sdgen.cameras.sight import HEIGHT, WIDTH, Cast, pixel_rays
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
#: Rays along a picture's sides that tell how much of a room it shows, and how far they go.
_WIDE_RAYS, _WIDE_M = (8, 6), 10.0


@dataclass(frozen=True, eq=False)
class View:
    """Where a camera stands, (3,), the point it aims at, (3,), what it is for, and of which room
    it is an overview."""

    kind: Literal["room", "near"]
    eye_m: Array
    aim_m: Array
    overview_of: int | None = None

    @cached_property
    def world_from_camera(self) -> Array:
        """The camera's pose, (4, 4)."""
        return look_at(vec3(self.eye_m), vec3(self.aim_m))

    def at(self, eye_height_m: float) -> View:
        """The same place looked at from another usual eye height."""
        raised = np.array([0.0, 0.0, eye_height_m - EYE_HEIGHT_M])
        return replace(self, eye_m=self.eye_m + raised)


def poses_of(views: Sequence[View]) -> Array:
    """``world_from_camera`` of views, (N, 4, 4)."""
    return np.array([view.world_from_camera for view in views]).reshape(-1, 4, 4)


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


def clear(cast: Cast, views: Sequence[View]) -> npt.NDArray[np.bool_]:
    """Which views have nothing within :data:`CLEARANCE_M` of their eye, at its height, (N,)."""
    eyes = np.array([view.eye_m for view in views]).reshape(-1, 3)
    angles = np.arange(_CLEARANCE_RAYS) * (2 * math.pi / _CLEARANCE_RAYS)
    ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(len(angles))]) * CLEARANCE_M
    origins = np.repeat(eyes, len(ring), axis=0)
    hits = cast(origins, origins + np.tile(ring, (len(eyes), 1)))
    return np.asarray((hits.object_id.reshape(-1, len(ring)) == 0).all(axis=1))


def wide(cast: Cast, views: Sequence[View]) -> npt.NDArray[np.bool_]:
    """Which views to keep, (N,): near views, and of each room's overviews the half that sees
    furthest. A leaf or a wardrobe before the lens hides what an overview is for."""
    columns, rows = _WIDE_RAYS
    u, v = np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    pixels = np.column_stack([u.ravel() * WIDTH, v.ravel() * HEIGHT])
    of: dict[int, list[int]] = {}
    for k, view in enumerate(views):
        if view.overview_of is not None:
            of.setdefault(view.overview_of, []).append(k)
    among = [k for group in of.values() for k in group]
    out = np.ones(len(views), dtype=np.bool_)
    if not among:
        return out
    rays = [pixel_rays(views[k].world_from_camera, pixels, _WIDE_M) for k in among]
    origins, ends = (np.concatenate(side) for side in zip(*rays, strict=True))
    far = np.minimum(cast(origins, ends).distance_m, _WIDE_M).reshape(len(among), -1)
    # Of logarithms, since half a picture behind a leaf is worse than a far wall is good.
    sees = dict(zip(among, np.log(far).mean(axis=1).tolist(), strict=True))
    for group in of.values():
        best = sorted(group, key=sees.__getitem__, reverse=True)
        out[best[(len(best) + 1) // 2 :]] = False
    return out
