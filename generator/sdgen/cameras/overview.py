"""Overviews: views of whole rooms that show as many different things as they can."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.sight import Cast, overview_rays
from sdgen.cameras.view import HEIGHT_JITTER_M, View, clear, free_area
from sdgen.geometry import Array, look_at, vec3
from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import Room, Scene
from sdgen.seeding import Rng

#: Poses tried for an overview, 300 rays each.
_CANDIDATES = 10
#: Points thrown into a room's box so that enough fall on its free floor, a twentieth at worst.
_DRAWS = 60 * _CANDIDATES
#: Free-floor points that candidates are picked from.
_POINTS = 4 * _CANDIDATES
#: Free floor below this is a gap between furniture, square metres.
_LEAST_FLOOR_M2 = 0.01
#: Overviews aim at the room's middle at the height of seats and tables, give or take (x, y, z).
_AIM_Z_M = 0.65
_AIM_JITTER_M = (0.5, 0.5, 0.15)
#: An aim nearer than this would look down the camera's own post; it is moved this far away.
_NEAREST_AIM_M, _MOVED_AIM_M = 0.3, 0.5
#: What a thing counts that an earlier overview has shown: less, not nothing.
_SEEN_AGAIN = 0.25
#: A blocked candidate is taken only where every other is blocked or sees nothing.
_BLOCKED = 0.1
_NOTHING_SEEN = 0.01
#: One thing may fill this share of the picture without loss.
_FILLED = 0.3
#: Views with half of their rays shorter than this look at a wall.
_DEEP_M, _DEPTH_CAP_M = 2.0, 10.0

Ints = npt.NDArray[np.int64]


def room_views(
    scene: Scene, cast: Cast, count: int, rng: Rng, eye_height_m: float = EYE_HEIGHT_M
) -> tuple[View, ...]:
    """``count`` overviews, rooms in turn in a drawn order; each shows as much as it can that
    the ones before have not shown. Fewer only when no room has free floor."""
    free = free_area(scene)
    rooms = [scene.home.rooms[i] for i in rng.permutation(len(scene.home.rooms))]
    floors = {room.id: free.intersection(Polygon(room.polygon_m)) for room in rooms}
    rooms = [room for room in rooms if floors[room.id].area > _LEAST_FLOOR_M2]
    shown: set[int] = set()
    views: list[View] = []
    for number in range(count if rooms else 0):
        room = rooms[number % len(rooms)]
        pose, seen = _best_overview(cast, room, floors[room.id], shown, rng, eye_height_m)
        shown |= seen
        views.append(View("room", room.id, pose))
    return tuple(views)


def _best_overview(
    cast: Cast, room: Room, floor: BaseGeometry, shown: set[int], rng: Rng, eye_height_m: float
) -> tuple[Array, set[int]]:
    """The pose of some candidates that shows most, and what it shows."""
    points = _spread(floor, rng)
    middle = Polygon(room.polygon_m).centroid
    heights = eye_height_m + rng.uniform(0.0, 2 * HEIGHT_JITTER_M, len(points))
    jitters = rng.uniform(-1.0, 1.0, (len(points), 3)) * _AIM_JITTER_M
    eyes = np.column_stack([points, heights])
    poses = []
    for eye, jitter in zip(eyes, jitters, strict=True):
        aim = np.array([middle.x, middle.y, _AIM_Z_M]) + jitter
        if math.hypot(aim[0] - eye[0], aim[1] - eye[1]) < _NEAREST_AIM_M:
            aim[:2] = eye[:2] + _MOVED_AIM_M * np.sign(aim[:2] - eye[:2] + 1e-9)
        poses.append(look_at(vec3(eye), vec3(aim)))
    unblocked = clear(cast, eyes)
    rays = [overview_rays(pose) for pose in poses]
    hits = cast(np.concatenate([r[0] for r in rays]), np.concatenate([r[1] for r in rays]))
    each = len(rays[0][0])
    best, best_score, best_seen = 0, -1.0, set[int]()
    for k in range(len(poses)):
        rows = slice(k * each, (k + 1) * each)
        object_ids = hits.object_id[rows][hits.part[rows] > 0]
        seen = set(object_ids.tolist())
        score = _worth(object_ids, hits.distance_m[rows], seen, shown) * (_BLOCKED + unblocked[k])
        if score > best_score:
            best, best_score, best_seen = k, score, seen
    return poses[best], best_seen


def _worth(object_ids: Ints, distance_m: Array, seen: set[int], shown: set[int]) -> float:
    """Distinct things, new ones above all; views close to a wall or one thing count little.

    ``object_ids`` are those of the rays that meet an object, ``distance_m`` of all rays.
    """
    if len(object_ids) == 0:
        return _NOTHING_SEEN
    fresh = len(seen - shown) + _SEEN_AGAIN * len(seen & shown)
    biggest = float(np.bincount(object_ids).max()) / len(distance_m)
    depth = float(np.median(np.minimum(distance_m, _DEPTH_CAP_M)))
    return fresh * (1.0 - max(biggest - _FILLED, 0.0)) * min(depth / _DEEP_M, 1.0)


def _spread(floor: BaseGeometry, rng: Rng) -> Array:
    """Candidate points of a free floor, those near its rim preferred: corners and doorways."""
    x0, y0, x1, y1 = floor.bounds
    points = rng.uniform((x0, y0), (x1, y1), (_DRAWS, 2))
    points = points[shapely.contains_xy(floor, points[:, 0], points[:, 1])]
    if len(points) == 0:
        point = floor.representative_point()
        return np.array([[point.x, point.y]])
    points = points[:_POINTS]
    centre = floor.centroid
    away = np.hypot(points[:, 0] - centre.x, points[:, 1] - centre.y)
    order = np.argsort(-away * rng.uniform(0.5, 1.0, len(points)), kind="stable")
    return np.asarray(points[order[:_CANDIDATES]], dtype=np.float64)
