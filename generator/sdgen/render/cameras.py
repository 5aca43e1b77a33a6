"""Chooses where to look from: views near given things, and overviews of rooms in turn.

Cameras stand where a robot can, at eye height, and are accepted by ray tests only.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import shapely
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.geometry import Array, Vec2, look_at, rotation_matrix, vec3
from sdgen.library import Library
from sdgen.render.projection import FAR_M, NEAR_M, intrinsics, matrix4
from sdgen.render.sight import (
    Cast,
    Ints,
    estimate_pixels,
    in_picture,
    overview_rays,
    part_numbers,
    part_points,
)
from sdgen.scene import Camera, ObjectInstance, Room, Scene
from sdgen.seeding import Rng

#: A near view counts when rays promise this many pixels at 640x480: twice what is needed, since
#: rays are few and pictures exact.
PIXELS_NEEDED = 200
EYE_HEIGHT_M = 1.2

_NEAR_DISTANCE_M = (0.8, 2.2)
# Furniture is looked at from further away: this much of its size beyond a metre is added.
_DISTANCE_PER_SIZE = 0.6
# What stands on the floor is seen with the floor around it: whether it is in the way depends on
# where it lies. Small things and narrow things would be lost from there.
_FLOOR_FURTHER_M = 0.9
_FLOOR_LOW_M = 0.1
_FLOOR_TOP_M = 0.5
_FLOOR_WIDTH_M = 0.12
_FLOOR_ENOUGH_PIXELS = 2500.0
_NEAR_CANDIDATES = 32
# Few rays choose among candidates, many count the pixels of the best until one is enough.
_ROUGH_GRID = 6
_FINALISTS = 8
_NEAR_DRAWS = 40 * _NEAR_CANDIDATES
# Beyond this many pixels, or half of the most, more is not better, so that near views differ.
_ENOUGH_PIXELS = 12000.0
_ROOM_CANDIDATES = 10
_CLEARANCE_M = 0.3
_HEIGHT_JITTER_M = 0.1


@dataclass(frozen=True)
class Target:
    """Something a near view shows: an object, and the parts that matter (empty = all)."""

    object_id: int
    parts: tuple[str, ...] = ()


@dataclass(frozen=True)
class View:
    """A camera pose, and for a near view the pixels at 640x480 that rays promise."""

    kind: Literal["room", "near"]
    room_id: int
    world_from_camera: Array
    estimated_pixels: float = 0.0


def best_near_pose(
    library: Library,
    scene: Scene,
    cast: Cast,
    target: Target,
    rng: Rng,
    eye_height_m: float = EYE_HEIGHT_M,
    pixels_needed: float = PIXELS_NEEDED,
) -> View | None:
    """About the best of 32 views 0.8 to 2.2 m from a target, or None when none shows enough of it.

    The target is not quite in the middle of the picture. Only rays decide, so a
    placement can be rejected on None before any picture exists.
    """
    item = scene.object(target.object_id)
    points = part_points(library, item, target.parts)
    free = free_area(scene)
    # Aimed at the whole object whatever its parts: a lit burner must not be more central than
    # a cold one is.
    whole = part_points(library, item, ())
    centre = (whole.min(axis=0) + whole.max(axis=0)) / 2
    _, width, size = np.sort(np.ptp(whole, axis=0)).tolist()
    further = _DISTANCE_PER_SIZE * max(size - 1.0, 0.0)
    low, top = float(whole[:, 2].min()), float(whole[:, 2].max())
    on_floor = low < _FLOOR_LOW_M and top < _FLOOR_TOP_M and width > _FLOOR_WIDTH_M
    if on_floor:
        further += _FLOOR_FURTHER_M
    eyes = _eyes_around(free, (float(centre[0]), float(centre[1])), further, rng)
    if len(eyes) == 0:
        return None
    heights = eye_height_m + rng.uniform(-_HEIGHT_JITTER_M, _HEIGHT_JITTER_M, len(eyes))
    aims = rng.uniform(-1.0, 1.0, (len(eyes), 2))
    fade = rng.uniform(0.8, 1.0, len(eyes))
    stands = np.column_stack([eyes, heights])
    poses = [_aimed(eye, centre, aim) for eye, aim in zip(stands, aims, strict=True)]
    clear = _clear(cast, stands)
    numbers = part_numbers(library, item, target.parts)
    rough = estimate_pixels(cast, poses, points, item.id, numbers, _ROUGH_GRID)
    enough = max(_ENOUGH_PIXELS, 0.5 * float(rough.max()))
    if on_floor:
        enough = _FLOOR_ENOUGH_PIXELS
    promise = np.minimum(rough, enough) * fade * clear
    promise *= [_framing(pose, whole, item) for pose in poses]
    for first in np.argsort(-promise, kind="stable")[:_FINALISTS].tolist():
        if promise[first] <= 0:
            break
        (pixels,) = estimate_pixels(cast, [poses[first]], points, item.id, numbers)
        if pixels >= pixels_needed:
            room_id = _room_at(scene, eyes[first], item.room_id)
            return View("near", room_id, poses[first], float(pixels))
    return None


def room_views(
    scene: Scene, cast: Cast, count: int, rng: Rng, eye_height_m: float = EYE_HEIGHT_M
) -> tuple[View, ...]:
    """``count`` overviews, rooms in turn in a drawn order; each shows as much as it can that
    the ones before have not shown. Fewer only when no room has free floor."""
    free = free_area(scene)
    rooms = [scene.home.rooms[i] for i in rng.permutation(len(scene.home.rooms))]
    floors = {room.id: free.intersection(Polygon(room.polygon_m)) for room in rooms}
    rooms = [room for room in rooms if floors[room.id].area > 0.01]
    shown: set[int] = set()
    views: list[View] = []
    for number in range(count if rooms else 0):
        room = rooms[number % len(rooms)]
        pose, found = _best_overview(cast, room, floors[room.id], shown, rng, eye_height_m)
        shown |= found
        views.append(View("room", room.id, pose))
    return tuple(views)


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


def _framing(pose: Array, points_m: Array, item: ObjectInstance) -> float:
    """How well a view shows what the thing is: all of it in the picture, and from its front."""
    inside = float(in_picture(pose, points_m).mean())
    front = rotation_matrix(item.pose.quat_xyzw)[:2, 0]
    towards = pose[:2, 3] - np.asarray(item.pose.position_m[:2])
    facing = float(front @ towards) / max(float(np.linalg.norm(towards)), 1e-9)
    return (0.25 + 0.75 * inside) * (0.8 + 0.2 * facing if item.fixed else 1.0)


def _eyes_around(free: BaseGeometry, centre: Vec2, further_m: float, rng: Rng) -> Array:
    """Up to 32 points of the free area in the ring around ``centre``, (N, 2)."""
    low, high = (limit + further_m for limit in _NEAR_DISTANCE_M)
    distance = np.sqrt(rng.uniform(low**2, high**2, _NEAR_DRAWS))
    angle = rng.uniform(-math.pi, math.pi, _NEAR_DRAWS)
    points = np.array(centre) + distance[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    inside = shapely.contains_xy(free, points[:, 0], points[:, 1])
    return np.asarray(points[inside][:_NEAR_CANDIDATES], dtype=np.float64)


def _aimed(eye: Array, centre: Array, aim: Array) -> Array:
    """Look at ``centre`` or up to 0.2 of the way to the picture's edge beside it."""
    straight = look_at(vec3(eye), vec3(centre))
    reach = float(np.linalg.norm(centre - eye))
    beside = straight[:3, 0] * aim[0] * 0.14 + straight[:3, 1] * aim[1] * 0.1
    return look_at(vec3(eye), vec3(centre + reach * beside))


def _clear(cast: Cast, stands: Array) -> Array:
    """1.0 for eyes with nothing within 0.3 m around them at their height, else 0.0."""
    angles = np.arange(8) * (math.pi / 4)
    around = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(8)]) * _CLEARANCE_M
    origins = np.repeat(stands, 8, axis=0)
    hits = cast(origins, origins + np.tile(around, (len(stands), 1)))
    return np.asarray((hits.object_id.reshape(-1, 8) == 0).all(axis=1), dtype=np.float64)


def _best_overview(
    cast: Cast, room: Room, floor: BaseGeometry, shown: set[int], rng: Rng, eye_height_m: float
) -> tuple[Array, set[int]]:
    """The pose of some candidates that shows most, things shown before counting a quarter."""
    eyes = _spread(floor, rng)
    middle = Polygon(room.polygon_m).centroid
    heights = eye_height_m + rng.uniform(0.0, 2 * _HEIGHT_JITTER_M, len(eyes))
    looks = rng.uniform(-1.0, 1.0, (len(eyes), 3)) * (0.5, 0.5, 0.15)
    stands = np.column_stack([eyes, heights])
    poses = []
    for eye, look in zip(stands, looks, strict=True):
        goal = np.array([middle.x, middle.y, 0.65]) + look
        if math.hypot(goal[0] - eye[0], goal[1] - eye[1]) < 0.3:
            goal[:2] = eye[:2] + 0.5 * np.sign(goal[:2] - eye[:2] + 1e-9)
        poses.append(look_at(vec3(eye), vec3(goal)))
    clear = _clear(cast, stands)
    rays = [overview_rays(pose) for pose in poses]
    hits = cast(np.concatenate([r[0] for r in rays]), np.concatenate([r[1] for r in rays]))
    each = len(rays[0][0])
    best, best_score, best_seen = 0, -1.0, set[int]()
    for k in range(len(poses)):
        rows = slice(k * each, (k + 1) * each)
        found = hits.object_id[rows][hits.part[rows] > 0]
        seen = set(found.tolist())
        score = _worth(found, hits.distance_m[rows], seen, shown) * (0.1 + clear[k])
        if score > best_score:
            best, best_score, best_seen = k, score, seen
    return poses[best], best_seen


def _worth(found: Ints, distance_m: Array, seen: set[int], shown: set[int]) -> float:
    """Distinct things, new ones above all; views close to a wall or one thing count little."""
    if len(found) == 0:
        return 0.01
    fresh = len(seen - shown) + 0.25 * len(seen & shown)
    biggest = float(np.bincount(found).max()) / len(distance_m)
    depth = float(np.median(np.minimum(distance_m, 10.0)))
    return fresh * (1.0 - max(biggest - 0.3, 0.0)) * min(depth / 2.0, 1.0)


def _spread(floor: BaseGeometry, rng: Rng) -> Array:
    """Candidate points of a free floor, those near its rim preferred: corners and doorways."""
    x0, y0, x1, y1 = floor.bounds
    points = rng.uniform((x0, y0), (x1, y1), (60 * _ROOM_CANDIDATES, 2))
    points = points[shapely.contains_xy(floor, points[:, 0], points[:, 1])]
    if len(points) == 0:
        point = floor.representative_point()
        return np.array([[point.x, point.y]])
    points = points[: 4 * _ROOM_CANDIDATES]
    centre = floor.centroid
    away = np.hypot(points[:, 0] - centre.x, points[:, 1] - centre.y)
    kept = np.argsort(-away * rng.uniform(0.5, 1.0, len(points)), kind="stable")
    return np.asarray(points[kept[:_ROOM_CANDIDATES]], dtype=np.float64)


def _room_at(scene: Scene, eye: Array, default: int) -> int:
    for room in scene.home.rooms:
        if Polygon(room.polygon_m).covers(Point(eye)):
            return room.id
    return default
