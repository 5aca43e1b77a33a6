"""Which views a home gets: together they show as much as they can of where small things lie."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sdgen.cameras.counted import shows_pixels
from sdgen.cameras.framing import RAYS_SHARE, Bools, framed, glance_pixels, uncut
from sdgen.cameras.outdoors import FINE, ROUGH, looks_out
from sdgen.cameras.parts import part_area, part_points
from sdgen.cameras.sight import HEIGHT, WIDTH, Cast, Ints
from sdgen.cameras.spots import SetTo
from sdgen.cameras.view import View, alike, poses_of
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.seeding import Rng

#: So near and so far a small thing shows well: 8 cm are 12 pixels wide at 3 m, 150 in all.
_DEPTH_M = (0.45, 3.0)
#: A thing's middle is this far from the picture's edges: 8 cm at 1.2 m, so that it is not cut off.
_MARGIN_PIXELS = 16
#: What is set to a state must show so many times what a glance needs, since other things will stand
#: before it, and from no further; views of which few rays promise less than that are not needed.
_STATE_TIMES, _FAR_M, _TOO_LITTLE = 2.5, 5.0, 1.0
#: And of the outdoors so many times what rays must promise: little stands before a doorway.
_OUTDOORS_TIMES = 1.2
#: About so many points of a part tell whether something stands before it.
_AT_REST = 16
#: A ray that ends so near to a point has met what the point stands at, or nothing.
_AT_M = 0.03
#: What a spot counts that views show already: less, not nothing.
_AGAIN = 0.2
#: Views that show nearly as much as the best are told apart by chance.
_NEARLY = 0.85
#: What an overview is worth tells more than what it shows of spots: near views are for these.
_WORTH = 3
#: And that of a room of which there is an overview already so much less.
_SAME_ROOM = 0.5
#: Views of the usual options. They decide content, whatever number of views is asked for.
CANONICAL = 8
#: Near views are what small things are told in; overviews place them.
_NEAR_SHARE = 2 / 3


def near_count(count: int) -> int:
    """How many of so many views are near views, in every scene."""
    return round(count * _NEAR_SHARE)


def things_shown(views: Sequence[View], points_m: Array, cast: Cast) -> Bools:
    """Which view would show a small thing at which point well, (views, points)."""
    poses, margin = poses_of(views), _MARGIN_PIXELS
    at = framed(poses, points_m)
    out = (at.depth >= _DEPTH_M[0]) & (at.depth <= _DEPTH_M[1])
    out &= (at.u >= margin) & (at.u <= WIDTH - margin)
    out &= (at.v >= margin) & (at.v <= HEIGHT - margin)
    return _unhidden(poses, points_m, out, cast)


def states_shown(
    library: Library, views: Sequence[View], states: Sequence[SetTo], cast: Cast
) -> Bools:
    """Which view would show well what is set to a state, (views, states), by rays into the home
    with all of it so."""
    poses = poses_of(views)
    out = np.zeros((len(poses), len(states)), dtype=np.bool_)
    for k, one in enumerate(states):
        points = part_points(library, one.item, one.parts)
        needed = _STATE_TIMES * glance_pixels(part_area(library, one.item, one.parts))
        near = _toward(poses, points.mean(axis=0), one.item.id, cast)
        near = near[uncut(poses[near], part_points(library, one.item, ()), points)]
        enough = shows_pixels(library, one.item, cast, poses[near], one.parts, needed, _TOO_LITTLE)
        near = near[enough]
        if one.outdoors:
            outdoors = _OUTDOORS_TIMES * RAYS_SHARE * one.outdoors
            # Three rows tell most; one of them may graze what twelve would not count.
            for rays in (ROUGH, FINE):
                near = near[looks_out(cast, list(poses[near]), one.opening, outdoors, rays)]
        out[near, k] = True
    return out


def shown_at_rest(
    library: Library, views: Sequence[View], states: Sequence[SetTo], shown: Bools, cast: Cast
) -> Bools:
    """Which of what :func:`states_shown` found, (views, states), holds where only one is set so:
    rays into the home at rest reach where most of it will be, and meet no other shut door."""
    poses = poses_of(views)
    out = np.zeros_like(shown)
    for k, one in enumerate(states):
        near = np.flatnonzero(shown[:, k])
        if len(near) == 0:
            continue
        points = part_points(library, one.item, one.parts)
        points = points[:: max(len(points) // _AT_REST, 1)]
        eyes = np.repeat(poses[near, :3, 3], len(points), axis=0)
        ends = np.tile(points, (len(near), 1))
        hits = cast(eyes, ends)
        free = hits.distance_m >= np.linalg.norm(ends - eyes, axis=1) - _AT_M
        free |= hits.object_id == one.item.id
        out[near, k] = free.reshape(len(near), -1).mean(axis=1) >= 0.5
    return out


def _toward(poses: Array, point_m: Array, object_id: int, cast: Cast) -> Ints:
    """Numbers of the views that have an object's middle in their picture, with nothing else
    before it."""
    at = framed(poses, point_m[None])
    near = np.flatnonzero(at.inside[:, 0] & (at.depth[:, 0] < _FAR_M))
    eyes = poses[near, :3, 3]
    hits = cast(eyes, np.repeat(point_m[None], len(near), axis=0))
    reached = hits.distance_m >= np.linalg.norm(point_m - eyes, axis=1) - _AT_M
    return np.asarray(near[reached | (hits.object_id == object_id)])


def _unhidden(poses: Array, points_m: Array, among: Bools, cast: Cast) -> Bools:
    """Which of these pairs of a camera and a point nothing stands between."""
    out = np.zeros(among.shape, dtype=np.bool_)
    which, point = np.nonzero(among)
    eyes = poses[which, :3, 3]
    hits = cast(eyes, points_m[point])
    length = np.linalg.norm(points_m[point] - eyes, axis=1)
    out[which, point] = hits.distance_m >= length - _AT_M
    return out


def choose(views: Sequence[View], shows: Bools, weight: Array, count: int, rng: Rng) -> list[int]:
    """Up to ``count`` of the views, by number, for what each adds (Nemhauser et al. 1978: the
    greedy choice is within 1 - 1/e of the best); a longer choice begins with a shorter one.

    ``shows`` says which view shows which spot, (views, spots), ``weight`` how likely spots are.
    What an overview shows counts by what it is worth as one.
    """
    near = np.array([view.kind == "near" for view in views])
    same = alike(views)
    value = np.array([view.worth**_WORTH for view in views])
    room = np.array([-1 if view.overview_of is None else view.overview_of for view in views])
    worth = weight.copy()
    left = np.ones(len(views), dtype=np.bool_)
    chosen: list[int] = []
    while len(chosen) < count and left.any():
        fresh = left & ~same[chosen].any(axis=0)
        wanted = _allowed(near, near[chosen])
        among = next((a for a in (fresh & wanted, left & wanted) if a.any()), left)
        pictured = np.isin(room, room[chosen]) & ~near
        again = np.where(pictured, _SAME_ROOM, 1.0)
        gain = np.where(among, value * again * (shows @ worth), -1.0)
        good = np.flatnonzero(gain >= _NEARLY * gain.max())
        best = int(good[int(rng.integers(len(good)))])
        chosen.append(best)
        left[best] = False
        worth = np.where(shows[best], worth * _AGAIN, worth)
    return chosen


def _allowed(near: Bools, chosen: Bools) -> Bools:
    """The views of a kind still wanted; ``near`` and ``chosen`` say which are near views."""
    wanted = max(CANONICAL, len(chosen) + 1)
    got = int(chosen.sum())
    more_near = got < near_count(wanted)
    more_rooms = len(chosen) - got < wanted - near_count(wanted)
    return np.asarray(np.where(near, more_near, more_rooms))
