"""A full turn of views from one place of each room, as a robot takes that looks around.

The robot of Mullen et al. (2024, section 5) "captures images from 360°" of a room; ours stands
where it sees most of what is on the furniture and the floor.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.cover import things_shown
from sdgen.cameras.pinhole import FAR_M, FOV_X_RAD, NEAR_M, intrinsics, matrix4
from sdgen.cameras.sight import Cast
from sdgen.cameras.view import View, clear
from sdgen.freespace import Pieces
from sdgen.geometry import Array, look_at, vec3
from sdgen.options import MAX_VIEWS
from sdgen.scene import Camera, Panorama, Room, Turn
from sdgen.seeding import Rng

#: Neighbours of a turn share so much at least, and so many views go once round: six of 70 degrees.
_OVERLAP_RAD = math.radians(5.0)
ROOM_TURN = math.ceil(2 * math.pi / (FOV_X_RAD - _OVERLAP_RAD))
#: Rooms of a home that have a turn: of more the largest, or their views had no two digits.
MOST_ROOMS = MAX_VIEWS // ROOM_TURN
#: Places tried in each room.
_PLACES = 24
#: Free floor below this is a gap between furniture, square metres.
_LEAST_FLOOR_M2 = 0.01
#: Outlines of free floor are this exact: plain overlays stumble over slivers.
_GRID_M = 1e-4
#: A panorama has about as many pixels in a degree as the middle of a view: four fifths of the
#: view's width for a quarter turn; and no more than this in all.
_PER_WIDTH, _WIDEST = 3.2, 4096
#: Straight up and down is seen half as sharp: nothing is there but floor and ceiling.
_POLE_SHARPNESS = 0.5
#: Half of what a view up or down shows, a tangent, at most (76 degrees): views much wider than high
#: leave a gap to it.
_POLE_REACH = 4.0
#: Views up and down count from here on, two a panorama: no view that is written does.
POLES_FROM = 100


class Post(NamedTuple):
    """A place in a room, the eye (3,), where a turn begins at a yaw, radians."""

    room_id: int
    eye_m: Array
    yaw_rad: float


def posts(
    rooms: Sequence[Room],
    free: BaseGeometry,
    points_m: Array,
    weight: Array,
    cast: Cast,
    height_m: float,
    rng: Rng,
) -> list[list[Post]]:
    """Of each room with free floor (``free``) places to turn in, the one that sees most first.

    That counts the ``points_m`` (N, 3) of the room that a turn shows well, by their ``weight``
    (N,). Rooms without a place that stands clear are left out.
    """
    shapely.prepare(free)
    largest = sorted(rooms, key=lambda room: -Polygon(room.polygon_m).area)[:MOST_ROOMS]
    chosen = {room.id for room in largest}
    out = []
    for room in (room for room in rooms if room.id in chosen):
        outline = Polygon(room.polygon_m)
        floor = shapely.intersection(free, outline, grid_size=_GRID_M)
        yaw = float(rng.uniform(-math.pi, math.pi))
        if floor.area < _LEAST_FLOOR_M2:
            continue
        pieces = Pieces(floor)
        drawn = [pieces.random_point(rng) for _ in range(_PLACES)]
        found = [Post(room.id, np.array([*at, height_m]), yaw) for at in drawn if at is not None]
        found = [found[k] for k in np.flatnonzero(standing_clear(found, cast)).tolist()]
        if not found:
            continue
        here = shapely.contains_xy(outline, points_m[:, 0], points_m[:, 1])
        worth = _worth(found, points_m[here], weight[here], cast)
        out.append([found[k] for k in np.argsort(-worth, kind="stable").tolist()])
    return out


def standing_clear(found: Sequence[Post], cast: Cast) -> Array:
    """Which posts have nothing too near to their eye, (N,) of True and False."""
    return np.asarray(clear(cast, [View("room", p.eye_m, _ahead(p, p.yaw_rad)) for p in found]))


def _worth(found: Sequence[Post], points_m: Array, weight: Array, cast: Cast) -> Array:
    """What each post's turn shows, by weight, (N,)."""
    views = [View("room", post.eye_m, aim) for post in found for aim in _aims(post)]
    shown = things_shown(views, points_m, cast).reshape(len(found), ROOM_TURN, len(points_m))
    return np.asarray(shown.any(axis=1) @ weight)


def _aims(post: Post) -> Iterator[Array]:
    step = 2 * math.pi / ROOM_TURN
    return (_ahead(post, post.yaw_rad + k * step) for k in range(ROOM_TURN))


def _ahead(post: Post, yaw_rad: float) -> Array:
    return np.asarray(post.eye_m + np.array([math.cos(yaw_rad), math.sin(yaw_rad), 0.0]))


def turn_cameras(found: Sequence[Post], size: tuple[int, int]) -> tuple[Camera, ...]:
    """The cameras, of ``size`` (width, height), of a turn in each of these posts, one after
    another: level, and turning left by equal steps."""
    return tuple(
        Camera(
            index=number * ROOM_TURN + step,
            kind="turn",
            room_id=post.room_id,
            width=size[0],
            height=size[1],
            K=intrinsics(*size),
            world_from_camera=matrix4(look_at(vec3(post.eye_m), vec3(aim)) + 0.0),
            near_m=NEAR_M,
            far_m=FAR_M,
            turn=Turn(step=step, of=ROOM_TURN),
        )
        for number, post in enumerate(found)
        for step, aim in enumerate(_aims(post))
    )


def panoramas_of(cameras: Sequence[Camera]) -> tuple[Panorama, ...]:
    """The panorama of each turn among a scene's cameras."""
    return tuple(
        Panorama(
            index=number,
            room_id=ring[0].room_id,
            views=tuple(camera.index for camera in ring),
            width=panorama_width(ring[0].width),
            height=panorama_width(ring[0].width) // 2,
            world_from_panorama=ring[0].world_from_camera,
        )
        for number, ring in enumerate(rings(cameras))
    )


def rings(cameras: Sequence[Camera]) -> list[Sequence[Camera]]:
    """The turns among a scene's cameras, each whole and in its order."""
    starts = [k for k, camera in enumerate(cameras) if camera.turn and camera.turn.step == 0]
    return [cameras[k : k + ROOM_TURN] for k in starts]


def panorama_width(width: int) -> int:
    """Pixels across of a panorama made of views so wide; twice as many as down."""
    return min(4 * round(_PER_WIDTH * width / 4), _WIDEST)


def poles_of(panorama: Panorama, camera: Camera) -> tuple[Camera, Camera]:
    """Cameras straight up and down for what the views of a turn, like ``camera``, do not show."""
    rise = (camera.height / 2) / camera.K[1][1] * math.cos(math.pi / ROOM_TURN)
    reach = min(1.0 / rise, _POLE_REACH)
    size = max(2 * round(reach * _POLE_SHARPNESS * panorama.width / (2 * math.pi)), 2)
    pose = np.asarray(panorama.world_from_panorama)
    right, down, ahead = pose[:3, 0], pose[:3, 1], pose[:3, 2]
    out = []
    for side, axes in enumerate(((right, ahead, -down), (right, -ahead, down))):
        turned = pose.copy()
        turned[:3, :3] = np.column_stack(axes)
        out.append(
            camera.model_copy(
                update={
                    "index": POLES_FROM + 2 * panorama.index + side,
                    "width": size,
                    "height": size,
                    "K": intrinsics(size, size, 2 * math.atan(reach)),
                    "world_from_camera": matrix4(turned),
                    "near_m": NEAR_M,
                    "turn": None,
                    "look": None,
                }
            )
        )
    return out[0], out[1]
