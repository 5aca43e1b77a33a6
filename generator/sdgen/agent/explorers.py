"""Ways to explore a home: each drives an episode until it has seen what it wanted to.

None of them reports: what the pictures show is for a detector to say.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
import shapely

from sdgen.agent.episode import Episode
from sdgen.agent.eyes import Look
from sdgen.agent.tour import Tour
from sdgen.agent.ways import length_m
from sdgen.freespace import lattice_points, polygons
from sdgen.geometry import Vec2
from sdgen.seeding import Rng

#: Drives an episode, and gives the pictures that it had. The tour is that of the certificates, of
#: which only one explorer may know.
Explorer = Callable[[Episode, Rng, "Tour | None"], list[Look]]

#: Of a random walk's moves, this share is a step ahead.
_AHEAD = 0.6
#: Whoever scans a room sees all of it from within so far, metres: a knife is some 15 pixels long.
_SCAN_M = 1.5
#: Places to scan from are chosen among those of a lattice, so far apart.
_LATTICE_M = 0.5
#: After a level turn one looks down so often, for what lies on the floor and low tables.
_DOWN = 1


def random_walk(episode: Episode, rng: Rng, _: Tour | None) -> list[Look]:
    """Steps ahead and turns, drawn, until there are no more steps."""
    looks = [episode.look()]
    while not episode.over:
        draw = float(rng.random())
        if draw < _AHEAD:
            result = episode.forward()
        else:
            result = episode.turn(1 if draw < (1 + _AHEAD) / 2 else -1)
        looks += result.looks
    return looks


def room_by_room(episode: Episode, _rng: Rng, _tour: Tour | None) -> list[Look]:
    """Room after room, the nearest first: to places from which all of its floor is near and in
    sight, and a full turn at each, level and looking down."""
    looks = [episode.look()]
    rooms = [room.id for room in episode.stage.scene.home.rooms]
    while rooms and not episode.over:
        floor = episode.house.floor
        reached = floor.within_reach(episode.gaze.point)
        spots = {key: _scan_places(reached.intersection(floor.outline_of(key))) for key in rooms}
        ways = {key: _nearest(episode, spots[key]) for key in rooms if spots[key]}
        if not ways:
            break
        key = min(ways, key=lambda k: (ways[k][0], k))
        waiting = spots[key]
        while waiting and not episode.over:
            _, spot = _nearest(episode, waiting)
            waiting.remove(spot)
            looks += _scan_at(episode, spot)
        rooms.remove(key)
    return looks


def nearest_frontier(episode: Episode, _rng: Rng, _tour: Tour | None) -> list[Look]:
    """To the nearest place of the floor beside what nobody has seen yet, and a full turn there,
    until nothing is left to get to (Yamauchi 1997)."""
    looks = [episode.look(), *_scan_at(episode, episode.gaze.point)]
    been: set[Vec2] = {episode.gaze.point}
    while not episode.over:
        floor = episode.house.floor
        places = _lattice(floor.within_reach(episode.gaze.point), _LATTICE_M)
        frontier = [place for place in _beside_unseen(episode, places) if place not in been]
        if not frontier:
            return looks
        _, spot = _nearest(episode, frontier)
        been.add(spot)
        looks += _scan_at(episode, spot)
    return looks


def planner(episode: Episode, _rng: Rng, tour: Tour | None) -> list[Look]:
    """The shortest tour past a pose for each anomaly that can be seen, and past others where a door
    that it opened hides one: it knows the certificates and what its pictures show, and so bounds
    all others. ValueError without a tour."""
    if tour is None:
        raise ValueError("the planner needs the tour of a scene's certificates")
    looks = [episode.look()]
    for gaze, _ in tour.stops:
        if episode.over:
            break
        looks += episode.go(gaze.point, gaze.yaw_rad, gaze.pitch_rad).looks
    for name, gazes in tour.more.items():
        for gaze in gazes:
            if episode.over or name in episode.account.first_shown:
                break
            looks += episode.go(gaze.point, gaze.yaw_rad, gaze.pitch_rad).looks
    return looks


EXPLORERS: Mapping[str, Explorer] = {
    "random": random_walk,
    "rooms": room_by_room,
    "frontier": nearest_frontier,
    "planner": planner,
}


def _scan_at(episode: Episode, spot: Vec2) -> list[Look]:
    looks = [*episode.go(spot, pitch_rad=math.radians(episode.options.pitch_deg)).looks]
    looks += episode.scan().looks
    for _ in range(_DOWN):
        if episode.over:
            break
        looks += episode.tilt(-1).looks
        looks += episode.scan().looks
    if not episode.over:
        looks += episode.tilt(_DOWN).looks
    return looks


def _lattice(shape: shapely.Geometry, spacing_m: float) -> list[Vec2]:
    """Points of a square lattice within a shape; of each piece without any, one."""
    out: list[Vec2] = []
    for piece in polygons(shape):
        found = lattice_points(piece, spacing_m)
        if not found:
            middle = piece.representative_point()
            found = [(float(middle.x), float(middle.y))]
        out += found
    return out


def _scan_places(part: shapely.Geometry) -> list[Vec2]:
    """Few places of a room's floor from which each other is near and in sight: the one that serves
    most first."""
    places = _lattice(part, _LATTICE_M)
    if not places:
        return []
    at = np.array(places)
    first, second = (k.ravel() for k in np.indices((len(at), len(at))))
    lines = shapely.linestrings(np.stack([at[first], at[second]], axis=1))
    shapely.prepare(part)
    near = (np.linalg.norm(at[first] - at[second], axis=1) <= _SCAN_M) & shapely.covers(part, lines)
    serves = near.reshape(len(at), len(at)) | np.eye(len(at), dtype=bool)
    left = np.ones(len(at), dtype=bool)
    chosen: list[Vec2] = []
    while left.any():
        best = int((serves & left).sum(axis=1).argmax())
        chosen.append(places[best])
        left &= ~serves[best]
    return chosen


def _beside_unseen(episode: Episode, places: Sequence[Vec2]) -> list[Vec2]:
    """Places around which some of the home was never seen."""
    if not places:
        return []
    cells = episode.account.cells
    unseen = cells.home & ~cells.seen
    i, j = cells.index(np.array(places))
    padded = np.pad(unseen, 2)
    around = sum(
        padded[i + 2 + a, j + 2 + b].astype(int) for a in range(-2, 3) for b in range(-2, 3)
    )
    # A cell or two behind furniture stays unseen for ever: a frontier is more.
    return [place for place, count in zip(places, np.asarray(around), strict=True) if count >= 4]


def _nearest(episode: Episode, spots: Sequence[Vec2]) -> tuple[float, Vec2]:
    """The spot that is got to soonest, and how far it is."""
    here = episode.gaze.point
    best: tuple[float, Vec2] | None = None
    for spot in sorted(spots, key=lambda one: math.dist(here, one)):
        if best is not None and math.dist(here, spot) >= best[0]:
            break
        way = episode.house.floor.route(here, spot, doors=True)
        far = math.inf if way is None else length_m(way)
        if best is None or far < best[0]:
            best = far, spot
    assert best is not None
    return best
