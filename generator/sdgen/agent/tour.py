"""The shortest tour that sees every anomaly that can be seen, among the certificates' places.

Places of the lattice that see each other are joined by straight ways; the shortest walk that
passes, for each anomaly, a place from which it can be seen is found exactly among them (Dijkstra
over place and set of anomalies seen). It is then drawn tight over the free floor. Between places of
the lattice there may be shorter ones, by as much as its spacing for each anomaly.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from sdgen.agent.walk import Floor
from sdgen.agent.ways import length_m
from sdgen.cameras.lens import Gaze
from sdgen.geometry import Array, Vec2
from sdgen.truth.observable import Observability, Observable, gaze_of, seen_at

Bools = npt.NDArray[np.bool_]

#: Lattice places further apart than this, in spacings, are joined through others: enough to get
#: through a doorway between them.
_JOINED = 3.0
#: More anomalies than this are toured a few at a time: sets double with each.
_AT_ONCE = 10
#: From so near, metres, one sees what a thing stands on: one of 128 pixels in 90 degrees is 3 cm.
_NEAR_M = 2.0
#: Poses that are tried where an anomaly was not seen after all.
_OTHERS = 8


@dataclass(frozen=True)
class Tour:
    """Poses in their order, each with the ids of the anomalies that are first seen there, and how
    long the walk past them is. ``unreachable``: anomalies that no pose one gets to sees. ``more``:
    other poses that see an anomaly, by its id, for when a door that was opened hides it."""

    stops: tuple[tuple[Gaze, tuple[str, ...]], ...]
    length_m: float
    unreachable: tuple[str, ...] = ()
    more: Mapping[str, tuple[Gaze, ...]] = field(default_factory=dict)


def shortest_tour(
    found: Observability, floor: Floor, start: Vec2, clearly: Mapping[str, Vec2] | None = None
) -> Tour:
    """The tour of a home from a point of its floor. ``clearly``: by the ids of anomalies where they
    are on the plan; past poses that show each with a margin and from nearby, where it has any."""
    places = np.array([start, *found.positions_m], dtype=np.float64).reshape(-1, 2)
    near = _joined(places, floor, found.spacing_m)
    reached = _reached(near)[1 : len(places)]
    masks = [_mask(found, one, reached, clearly) for one in found.anomalies]
    views = [np.asarray(mask.any(axis=(1, 2))) for mask in masks]
    can = [k for k, view in enumerate(views) if view.any()]
    names = [one.anomaly_id for one in found.anomalies]
    out: list[tuple[Gaze, tuple[str, ...]]] = []
    at = 0
    for first in range(0, len(can), _AT_ONCE):
        wanted = can[first : first + _AT_ONCE]
        walk = _shortest(near, [views[k] for k in wanted], at)
        done: set[int] = set()
        for place in walk:
            at = place
            if not 0 < place < len(places):
                continue
            fresh = [k for k in wanted if k not in done and views[k][place - 1]]
            out += [(_pose(found, masks[k], place - 1), (names[k],)) for k in fresh]
            done.update(fresh)
    lost = tuple(names[k] for k in range(len(names)) if k not in can)
    more = {names[k]: _others(found, masks[k]) for k in can}
    return Tour(_together(out), _length(floor, start, out), lost, more)


def _joined(places: Array, floor: Floor, spacing_m: float) -> list[list[tuple[int, float]]]:
    """Of each place, and of the corners of the floor after them, those to which a straight way
    leads, and how far they are."""
    ways = floor.open_ways
    points = np.concatenate([places, ways.corners])
    first, second = np.triu_indices(len(points), 1)
    apart = np.linalg.norm(points[first] - points[second], axis=1)
    wanted = (second >= len(places)) | (first == 0) | (apart <= _JOINED * spacing_m)
    return ways.joined(points, first[wanted], second[wanted])


def _reached(near: Sequence[Sequence[tuple[int, float]]]) -> Bools:
    """Which places are got to from the first."""
    out = np.zeros(len(near), dtype=np.bool_)
    out[0] = True
    todo = [0]
    while todo:
        for other, _ in near[todo.pop()]:
            if not out[other]:
                out[other] = True
                todo.append(other)
    return out


def _shortest(
    near: Sequence[Sequence[tuple[int, float]]], views: Sequence[Bools], start: int
) -> list[int]:
    """Places of the shortest walk from ``start`` that sees all of these views."""
    sees = [0] * len(near)
    for k, view in enumerate(views):
        for place in np.flatnonzero(view).tolist():
            sees[int(place) + 1] |= 1 << k
    every = (1 << len(views)) - 1
    begin = (start, sees[start])
    best = {begin: 0.0}
    before: dict[tuple[int, int], tuple[int, int]] = {}
    queue = [(0.0, begin)]
    while queue:
        far, state = heapq.heappop(queue)
        if far > best[state]:
            continue
        place, seen = state
        if seen == every:
            walk = [place]
            while state in before:
                state = before[state]
                walk.append(state[0])
            return walk[::-1]
        for other, more in near[place]:
            after = (other, seen | sees[other])
            if far + more < best.get(after, math.inf):
                best[after], before[after] = far + more, state
                heapq.heappush(queue, (far + more, after))
    return [start]


def _mask(
    found: Observability, one: Observable, reached: Bools, clearly: Mapping[str, Vec2] | None
) -> Bools:
    """The poses that one gets to and that see an anomaly, (places, pitches, headings)."""
    best = seen_at(found, one.seen) & reached[:, None, None]
    if clearly is None:
        return np.asarray(best)
    places = np.array(found.positions_m).reshape(-1, 2)
    near = np.linalg.norm(places - clearly[one.anomaly_id], axis=1) <= _NEAR_M
    for wanted in (seen_at(found, one.sure), near[:, None, None]):
        if (best & wanted).any():
            best = best & wanted
    return np.asarray(best)


def _pose(found: Observability, mask: Bools, place: int) -> Gaze:
    """A pose at a place that sees an anomaly: level if one does, in the middle of such headings."""
    seen = mask[place]
    pitches = sorted(np.flatnonzero(seen.any(axis=1)), key=lambda p: abs(found.pitches_deg[p]))
    pitch = int(pitches[0])
    headings = np.flatnonzero(seen[pitch])
    turn = np.exp(2j * np.pi * headings / found.headings)
    heading = int(headings[np.argmax((turn * np.conj(turn.mean())).real)])
    return gaze_of(found, (place, pitch, heading))


def _others(found: Observability, mask: Bools) -> tuple[Gaze, ...]:
    """A few poses that see an anomaly, far from each other."""
    places = np.flatnonzero(mask.any(axis=(1, 2)))
    points = np.asarray(found.positions_m)[places]
    chosen = [0]
    while len(chosen) < min(_OTHERS, len(places)):
        apart = np.linalg.norm(points[:, None] - points[chosen][None], axis=2).min(axis=1)
        chosen.append(int(apart.argmax()))
    return tuple(_pose(found, mask, int(places[k])) for k in chosen)


def _together(
    stops: Sequence[tuple[Gaze, tuple[str, ...]]],
) -> tuple[tuple[Gaze, tuple[str, ...]], ...]:
    """Stops with the same pose as one."""
    out: dict[Gaze, tuple[str, ...]] = {}
    for gaze, names in stops:
        out[gaze] = (*out.get(gaze, ()), *names)
    return tuple(out.items())


def _length(floor: Floor, start: Vec2, stops: Sequence[tuple[Gaze, tuple[str, ...]]]) -> float:
    """The length of the walk past these stops, drawn tight."""
    total, at = 0.0, start
    for gaze, _ in stops:
        way = floor.route(at, gaze.point, doors=True)
        total += length_m(way) if way is not None else math.dist(at, gaze.point)
        at = gaze.point
    return total
