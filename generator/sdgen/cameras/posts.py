"""Views that a furnished home offers: places looked at from near by, and overviews of rooms."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.parts import part_points
from sdgen.cameras.spots import SetTo, Spots
from sdgen.cameras.view import HEIGHT_JITTER_M, View
from sdgen.freespace import Pieces, union
from sdgen.geometry import Array, look_at, vec3
from sdgen.home.layout import Layout
from sdgen.library import Library
from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import Room
from sdgen.seeding import Rng

#: Places that near views are aimed at, and eyes tried for each.
_PLACES, _EYES = 60, 3
#: Near enough to tell what a thing is, far enough for a robot that wants to look at it.
_DISTANCE_M = (0.8, 2.2)
#: What lies on the floor is seen with the floor around it: whether it is in the way depends on
#: where it lies.
_FLOOR_Z_M, _FLOOR_FURTHER_M = 0.1, 0.5
#: Furniture is looked at from further away: this much of its size is added, or only a piece of it
#: would be in the picture.
_DISTANCE_PER_SIZE = 0.5
#: How far beside its place a near view aims, as tangents to the right and down: up to halfway to
#: the picture's edges (tan 35 and tan 27.7 degrees).
_BESIDE = (0.35, 0.26)
#: Near views look up by so much at most, a tangent: high shelves are in the picture, ceilings not.
_UP = 0.12
#: To look onto what is higher than its eyes a robot lifts them until they are somewhat above the
#: place, at most to where a tall adult's are (a judgement; Fetch's torso lifts its head by
#: 0.39 m, and a raised arm the camera of its hand higher): what lies flat shows only from above.
#: Coins fit on a shelf at 1.5 m where views show them three times as often as from 0.1 m lower.
_LIFT_M, _LOOKS_DOWN_M = 0.6, 0.25
#: And from nearer: seen so flat, coins show 300 pixels at 1.3 m and none to speak of at 2 m.
_LIFTED_DISTANCE_M = (0.8, 1.5)
#: Overviews tried of each room.
_OVERVIEWS = 8
#: Free-floor points drawn for an eye: those nearest to a room's rim see most of it.
_RIM_OF = 8
#: Overviews aim at the room's middle at the height of seats and tables, give or take (x, y, z).
_AIM_Z_M = 0.65
_AIM_JITTER_M = (0.5, 0.5, 0.15)
#: But look down by so much at most, a tangent (15 degrees): a floor is not a room, and what hangs
#: on walls belongs to it.
_DOWN = 0.27
#: An aim nearer than this would look down the camera's own post.
_NEAREST_AIM_M = 0.5
#: Free floor below this is a gap between furniture, square metres.
_LEAST_FLOOR_M2 = 0.01
#: Poses of a leaf between shut and wide open.
_LEAF_STEPS = 3
#: Outlines of free floor are this exact: plain overlays stumble over slivers.
_GRID_M = 1e-4
#: Points thrown into the ring so that enough fall on the free floor, a fortieth of it at worst.
_DRAWS = 40 * _EYES


def candidates(
    library: Library, rooms: Sequence[Room], free: BaseGeometry, spots: Spots, rng: Rng
) -> list[View]:
    """Near views of drawn spots and overviews of every room; ``free`` is where they may stand."""
    shapely.prepare(free)
    return [*_near(library, free, spots, rng), *_overviews(rooms, free, rng)]


def views_of(points_m: Array, free: BaseGeometry, rng: Rng, count: int) -> list[View]:
    """At most ``count`` near views straight at a thing with these points (N, 3), from where it
    could be looked at: from none that lies behind what cannot be walked around."""
    place, size = points_m.mean(axis=0), float(np.ptp(points_m, axis=0).max())
    return [View("near", eye, place) for eye in _eyes_around(free, place, size, rng, count)]


def swept_by(layout: Layout, states: Sequence[SetTo]) -> BaseGeometry:
    """The floor under every leaf, lid and drawer that may be set open: no eye stands in its way."""
    shapes = []
    for one in states:
        item, info = layout.items[one.item.id], layout.info(one.item.id)
        for rule in info.states:
            if rule.state == one.state and rule.joint is not None:
                joint = info.joint(rule.joint)
                for value in np.linspace(joint.lower, joint.upper, _LEAF_STEPS).tolist():
                    opened = item.model_copy(
                        update={"joints": {**item.joints, rule.joint: round(value, 4)}}
                    )
                    shapes += [block.shape for block in layout.blocks_of(opened)]
    return union(shapes)


def _near(library: Library, free: BaseGeometry, spots: Spots, rng: Rng) -> Iterator[View]:
    if len(spots.weight) == 0:
        return
    for k in rng.choice(len(spots.weight), _PLACES, p=spots.weight).tolist():
        state = k - len(spots.points_m)
        if state < 0:
            place, size = spots.points_m[k], 0.0
        else:
            found = spots.states[state]
            points = part_points(library, found.item, found.parts)
            place, size = points.mean(axis=0), float(np.ptp(points, axis=0).max())
        for eye in _eyes_around(free, place, size, rng, _EYES):
            yield View("near", eye, _beside(eye, place, rng.uniform(-1.0, 1.0, 2)))


def _eyes_around(free: BaseGeometry, place: Array, size_m: float, rng: Rng, count: int) -> Array:
    """At most ``count`` eyes over the free floor in the ring around a place or a thing of a size,
    (N, 3), lifted to look onto a high one."""
    lifted = min(max(float(place[2]) + _LOOKS_DOWN_M - EYE_HEIGHT_M, 0.0), _LIFT_M)
    further = _DISTANCE_PER_SIZE * size_m
    if place[2] < _FLOOR_Z_M:
        further += _FLOOR_FURTHER_M
    limits = _LIFTED_DISTANCE_M if lifted > 0.0 else _DISTANCE_M
    low, high = (limit + further for limit in limits)
    distance = np.sqrt(rng.uniform(low**2, high**2, _DRAWS))
    angle = rng.uniform(-math.pi, math.pi, _DRAWS)
    points = place[:2] + distance[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    inside = shapely.contains_xy(free, points[:, 0], points[:, 1])
    stands = points[inside][:count]
    heights = EYE_HEIGHT_M + lifted + rng.uniform(-HEIGHT_JITTER_M, HEIGHT_JITTER_M, count)
    return np.column_stack([stands, heights[: len(stands)]])


def _beside(eye: Array, place: Array, aim: Array) -> Array:
    """A point beside a place: ``aim`` from (-1, -1) to (1, 1)."""
    straight = look_at(vec3(eye), vec3(place))
    reach = float(np.linalg.norm(place - eye))
    beside = straight[:3, 0] * aim[0] * _BESIDE[0] + straight[:3, 1] * aim[1] * _BESIDE[1]
    aim = place + reach * beside
    level = math.dist(aim[:2], eye[:2])
    aim[2] = min(aim[2], eye[2] + _UP * level)
    return np.asarray(aim)


def _overviews(rooms: Sequence[Room], free: BaseGeometry, rng: Rng) -> Iterator[View]:
    for room in rooms:
        outline = Polygon(room.polygon_m)
        floor = shapely.intersection(free, outline, grid_size=_GRID_M)
        if floor.area < _LEAST_FLOOR_M2:
            continue
        pieces = Pieces(floor)
        middle = np.array([*outline.centroid.coords[0], _AIM_Z_M])
        for _ in range(_OVERVIEWS):
            found = [pieces.random_point(rng) for _ in range(_RIM_OF)]
            points = np.array([point for point in found if point is not None])
            away = np.hypot(*(points - middle[:2]).T)
            height = EYE_HEIGHT_M + rng.uniform(0.0, 2 * HEIGHT_JITTER_M)
            eye = np.array([*points[int(np.argmax(away))], height])
            aim = middle + rng.uniform(-1.0, 1.0, 3) * _AIM_JITTER_M
            level = math.dist(aim[:2], eye[:2])
            aim[2] = max(aim[2], height - _DOWN * level)
            if level >= _NEAREST_AIM_M:
                yield View("room", eye, aim, room.id)
