"""Views that a furnished home offers of places, from near by."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.framing import framed
from sdgen.cameras.parts import part_points
from sdgen.cameras.spots import SetTo, Spots
from sdgen.cameras.view import HEIGHT_JITTER_M, View
from sdgen.freespace import union
from sdgen.geometry import Array, look_at, vec3
from sdgen.home.layout import Layout
from sdgen.library import Library
from sdgen.options import EYE_HEIGHT_M
from sdgen.seeding import Rng

#: Places that near views are aimed at, and eyes tried for each.
_PLACES, _EYES = 60, 3
#: What is to be in the picture with a place on a piece of furniture, or on a room's floor, (N, 3).
Around = Callable[[int, Array], Array]

#: Near enough to tell what a thing is, far enough for a robot that wants to look at it.
_DISTANCE_M = (0.8, 2.2)
#: What lies on the floor is seen with the floor around it: whether it is in the way depends on
#: where it lies.
_FLOOR_Z_M, _FLOOR_FURTHER_M = 0.1, 0.5
#: Furniture is looked at from further away: this much of its size is added, or only a piece of it
#: would be in the picture.
_DISTANCE_PER_SIZE = 0.5
#: How far beside its place a near view aims, as tangents to the right and down: up to halfway to
#: the picture's edges (tan 35 and tan 27.7 degrees), and to nowhere from where what is around the
#: place would be nearer to them than this, some 20 pixels off.
_BESIDE, _EDGE = (0.35, 0.26), (0.655, 0.48)
#: What is no further before an eye than this has no place in its picture.
_NEAREST_M = 0.1
#: Near views look up by so much at most, a tangent: high shelves are in the picture, ceilings not.
_UP = 0.12
#: To look onto what is higher than its eyes a robot lifts them until they are somewhat above the
#: place, at most to where a tall adult's are (a judgement; Fetch's torso lifts its head by
#: 0.39 m, and a raised arm the camera of its hand higher): what lies flat shows only from above.
#: Coins fit on a shelf at 1.5 m where views show them three times as often as from 0.1 m lower.
_LIFT_M, _LOOKS_DOWN_M = 0.6, 0.25
#: And from nearer: seen so flat, coins show 300 pixels at 1.3 m and none to speak of at 2 m.
_LIFTED_DISTANCE_M = (0.8, 1.5)
#: Poses of a leaf between shut and wide open.
_LEAF_STEPS = 3
#: Points thrown into the ring so that enough fall on the free floor, a fortieth of it at worst.
_DRAWS = 40 * _EYES


def near_views(
    library: Library, free: BaseGeometry, spots: Spots, around: Around, rng: Rng
) -> list[View]:
    """Near views of drawn spots; ``free`` is where they may stand, ``around`` what is to be in the
    picture with each."""
    shapely.prepare(free)
    return list(_near(library, free, spots, around, rng))


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


def _near(
    library: Library, free: BaseGeometry, spots: Spots, around: Around, rng: Rng
) -> Iterator[View]:
    if len(spots.weight) == 0:
        return
    for k in rng.choice(len(spots.weight), _PLACES, p=spots.weight).tolist():
        state = k - len(spots.points_m)
        if state < 0:
            place, size = spots.points_m[k], 0.0
            points = around(int(spots.target[k]), place)
        else:
            found = spots.states[state]
            points = part_points(library, found.item, found.parts)
            place, size = points.mean(axis=0), float(np.ptp(points, axis=0).max())
        for eye in _eyes_around(free, place, size, rng, _EYES):
            yield View("near", eye, _beside(eye, place, points, rng.uniform(0.0, 1.0, 2)))


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


def _beside(eye: Array, place: Array, around: Array, draw: Array) -> Array:
    """A point beside a place to aim at, somewhere by ``draw``, from (0, 0) to (1, 1), where the
    points ``around`` it (N, 3) are in the picture: or, where there are too many, as many to every
    side."""
    straight = look_at(vec3(eye), vec3(place))
    reach = float(np.linalg.norm(place - eye))
    points = np.concatenate([around, place[None]])
    seen = (points - eye) @ straight[:3, :3]
    seen = seen[seen[:, 2] > _NEAREST_M]
    low, high = np.zeros(2), np.zeros(2)
    for axis in (0, 1):
        along, edge = seen[:, axis] / seen[:, 2], _EDGE[axis]
        ends = along.max() - edge, along.min() + edge
        if ends[0] > ends[1]:
            ends = (sum(ends) / 2,) * 2
        low[axis], high[axis] = np.clip(ends, -_BESIDE[axis], _BESIDE[axis])
    # What is far aside moves further than tangents do; from the middle of what is allowed it fits.
    for share in (draw, 0.5):
        aside = low + share * (high - low)
        aim = place + reach * (straight[:3, :2] @ aside)
        if framed(look_at(vec3(eye), vec3(aim))[None], points).inside.all():
            break
    level = math.dist(aim[:2], eye[:2])
    aim[2] = min(aim[2], eye[2] + _UP * level)
    return np.asarray(aim)
