"""Overviews of rooms, as somebody takes a picture of a room: from a corner or a doorway, the gaze
nearly level along the longest way through the room, with much furniture and none of it too near.

By few rays: a fan of them from each place tells where to look, a grid of them what is seen there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.judged import Inventory, Judged, judge
from sdgen.cameras.pinhole import FOV_X_RAD
from sdgen.cameras.sight import Cast
from sdgen.cameras.view import HEIGHT_JITTER_M, View, alike, clear
from sdgen.freespace import polygons
from sdgen.geometry import Array, Vec2
from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import Home, Opening, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import HALF_WALL_M

#: Directions in which the corners of a free floor are looked for: those of a rectangle twice each.
_CORNERS = 8
#: Eyes stand up to so far off such a corner, and so far inside of a doorway, or before a shut leaf.
_OFF_CORNER_M, _OFF_DOORWAY_M, _OFF_LEAF_M = 0.25, (0.02, 0.2), (0.3, 0.45)
#: Overviews look down by so much, degrees: a floor is not a room, and what hangs on walls is part
#: of it; with the horizon in the middle half of a picture would be bare wall.
_PITCH_DEG = (5.0, 9.5)
#: Rays of a fan at eye height, and how far they go: into no further room.
_FAN, _FAR_M = 40, 10.0
#: Gazes from one place are so many rays of the fan apart, and so many at most.
_APART, _GAZES = 6, 2
#: Gazes of a room that are looked at more closely, and how many of them are kept at most.
_LOOKED_AT, _KEPT = 12, 4
#: Those are kept that are so nearly as good as the best; one with a flaw is worth so much less.
_NEARLY, _FLAWED = 0.8, 0.2
#: Outlines of free floor are this exact: plain overlays stumble over slivers.
_GRID_M = 1e-4


def overviews(
    home: Home, inventory: Inventory, free: BaseGeometry, cast: Cast, rng: Rng
) -> list[View]:
    """The best few overviews of each room, at least one where an eye can stand; ``free`` is where
    eyes may."""
    shapely.prepare(free)
    out: list[View] = []
    for room in home.rooms:
        eyes = _eyes(room, home.openings, free, rng)
        eyes = eyes[clear(cast, [View("room", eye, eye) for eye in eyes])]
        views = _gazes(room, eyes, cast, rng)
        if not views:
            continue
        out += _best(views, judge(views, inventory, cast))
    return out


def _best(views: Sequence[View], judged: Judged) -> list[View]:
    """A room's best few views, no two of them nearly the same: of those that have no flaw, or the
    one that has least."""
    order = sorted(range(len(views)), key=lambda k: (judged.flaw[k], -judged.worth[k]))
    good = [k for k in order if judged.flaw[k] == 0.0] or order[:1]
    same = alike(views)
    kept: list[int] = []
    for k in good:
        nearly = judged.worth[k] >= _NEARLY * judged.worth[good[0]]
        if nearly and len(kept) < _KEPT and not same[k, kept].any():
            kept.append(k)
    flawed = _FLAWED if judged.flaw[good[0]] > 0.0 else 1.0
    return [replace(views[k], worth=flawed * float(judged.worth[k])) for k in kept]


def _eyes(room: Room, openings: Sequence[Opening], free: BaseGeometry, rng: Rng) -> Array:
    """Eyes near the corners of a room's free floor and in its doorways, (N, 3)."""
    outline = Polygon(room.polygon_m)
    floor = shapely.intersection(free, outline, grid_size=_GRID_M)
    points = [point for piece in polygons(floor) for point in _corners(piece, rng)]
    for opening in openings:
        if opening.kind != "window" and room.id in opening.room_ids:
            points += _doorway(opening, outline, rng)
    at = np.array(points).reshape(-1, 2)
    heights = EYE_HEIGHT_M + rng.uniform(0.0, 2 * HEIGHT_JITTER_M, len(at))
    stands = shapely.contains_xy(free, at[:, 0], at[:, 1])
    stands &= shapely.contains_xy(outline, at[:, 0], at[:, 1])
    return np.asarray(np.column_stack([at, heights])[stands])


def _corners(piece: Polygon, rng: Rng) -> Iterator[Vec2]:
    """Points of a floor that are furthest in this direction or that, or somewhat inside of them."""
    ring = np.array(piece.exterior.coords)[:-1]
    angles = (np.arange(_CORNERS) + 0.5) * (2 * math.pi / _CORNERS)
    reach = ring @ np.stack([np.cos(angles), np.sin(angles)])
    middle = np.array(piece.representative_point().coords[0])
    for k in np.unique(reach.argmax(axis=0)).tolist():
        inward = middle - ring[k]
        far = max(float(np.hypot(*inward)), 1e-6)
        # Never on the very edge: a rounding would put it outside.
        off = min(max(rng.uniform(0.0, _OFF_CORNER_M), 0.01), far)
        x, y = (ring[k] + inward * (off / far)).tolist()
        yield x, y


def _doorway(opening: Opening, outline: Polygon, rng: Rng) -> Iterator[Vec2]:
    """Points in a doorway on the room's side of it, and before its leaf."""
    x, y, _ = opening.center_m
    step = (0.0, 1.0) if opening.along == "x" else (1.0, 0.0)
    side = HALF_WALL_M + 0.05
    inward = 1.0 if shapely.contains_xy(outline, x + side * step[0], y + side * step[1]) else -1.0
    for near, far in (_OFF_DOORWAY_M, _OFF_LEAF_M):
        off = inward * (HALF_WALL_M + rng.uniform(near, far))
        yield x + off * step[0], y + off * step[1]


def _gazes(room: Room, eyes: Array, cast: Cast, rng: Rng) -> list[View]:
    """Views from eyes (N, 3) along the longest ways through the room at their height: one of each
    eye, then others, the furthest first."""
    far = _fan(room, eyes, cast)
    # What a picture shows: of logarithms, since a near wall is worse than a far one is good.
    half = round(FOV_X_RAD / 2 / (2 * math.pi / _FAN))
    around = (np.arange(_FAN)[:, None] + np.arange(-half, half + 1)) % _FAN
    sees = np.log(far)[:, around].mean(axis=2)
    pitches = np.radians(rng.uniform(*_PITCH_DEG, sees.shape))
    found: list[tuple[int, float, int, int]] = []
    for k, row in enumerate(sees):
        taken: list[int] = []
        for way in np.argsort(-row, kind="stable").tolist():
            apart = [min((way - one) % _FAN, (one - way) % _FAN) for one in taken]
            if all(gap >= _APART for gap in apart):
                found.append((len(taken), -float(row[way]), k, way))
                taken.append(way)
            if len(taken) == _GAZES:
                break
    out = []
    for _, _, k, way in sorted(found)[:_LOOKED_AT]:
        angle = way * (2 * math.pi / _FAN)
        level = max(float(far[k, way]), 1.0)
        ahead = (math.cos(angle), math.sin(angle), -math.tan(pitches[k, way]))
        out.append(View("room", eyes[k], eyes[k] + level * np.array(ahead), room.id))
    return out


def _fan(room: Room, eyes: Array, cast: Cast) -> Array:
    """How far one sees at the eyes' height all around, within the room, (N, rays)."""
    angles = np.arange(_FAN) * (2 * math.pi / _FAN)
    ahead = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(_FAN)])
    reach = np.minimum(_to_outline(np.array(room.polygon_m), eyes, ahead), _FAR_M)
    origins = np.repeat(eyes, _FAN, axis=0)
    ends = origins + (ahead * reach[..., None]).reshape(-1, 3)
    far = cast(origins, ends).distance_m.reshape(len(eyes), _FAN)
    return np.asarray(np.maximum(np.minimum(far, reach), 0.05))


def _to_outline(ring: Array, eyes: Array, ahead: Array) -> Array:
    """How far it is from eyes (N, 3) in directions (D, 3) to a room's walls (S, 2), (N, D)."""
    start, along = ring, np.roll(ring, -1, axis=0) - ring
    across = ahead[:, None, 0] * along[:, 1] - ahead[:, None, 1] * along[:, 0]
    across = np.where(np.abs(across) < 1e-12, np.inf, across)
    to = start[None] - eyes[:, None, :2]
    distance = (to[..., 0] * along[:, 1] - to[..., 1] * along[:, 0])[:, None] / across
    at = (to[:, None, :, 0] * ahead[:, None, 1] - to[:, None, :, 1] * ahead[:, None, 0]) / across
    meets = (distance > 1e-6) & (at >= 0.0) & (at <= 1.0)
    return np.asarray(np.where(meets, distance, np.inf).min(axis=2))
