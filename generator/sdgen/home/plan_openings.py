"""Doors, passages and windows of a floor plan: every room opens to the one it stands off, one front
door, daylight."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import shapely
from shapely.geometry import LineString, Polygon

from sdgen.catalog.home_shape import FRAME_M, frame_size
from sdgen.catalog.records import OpeningSpec
from sdgen.geometry import Vec2
from sdgen.home.plan import EPS, Plan, PlannedRoom
from sdgen.home.plan_rooms import DOOR_WALL_M, FRONT_DOOR_WALL_M
from sdgen.home.walls import Wall
from sdgen.rejection import Rejection, reject
from sdgen.seeding import Rng
from sdgen.vocabulary import HALF_WALL_M, OpeningKind

#: From a corner (walls' middle lines) to the middle of a door, a front door, a window: half its
#: width, half a wall, and by eye about 20 cm of wall (14 cm beside a front door or a window).
DOOR_MARGIN_M = 0.72
FRONT_DOOR_MARGIN_M = 0.8
WINDOW_MARGIN_M = 0.8
SMALL_WINDOW_MARGIN_M = 0.5
#: Wall beside a passage or a double door, to the corner.
CASING_M = 0.04
#: What stands in the middle of its wall rather than near a corner.
MIDDLE = ("wide_passage", "double_door")
#: Openings leave so much wall between them: doors nearer than this would open into each other.
APART_M = 0.35
#: Shares chosen by eye, not measured: doors mostly near corners, larger rooms often with two
#: windows.
NEAR_CORNER_CHANCE = 0.7
#: A door near a corner is up to so much further from it than its margin, metres. By eye.
NEAR_CORNER_M = 0.3
SECOND_WINDOW_CHANCE = 0.5
SECOND_WINDOW_AREA_M2 = 11.0
#: Places drawn for a door; of 909 doors that found one, all did within six.
TRIES = 12
#: A room with so many doors already gets no further one that it need not have: its walls are for
#: furniture. By eye.
WAYS_MOST = 3
#: What a door keeps free before it, and how deep furniture along a wall is, metres.
KEPT_M = 0.9
STRIP_M = 0.65
#: Windows look so far out at least before another wall, metres: light falls in.
SIGHT_M = 1.5
#: Where on a wall (shares of what its margins leave) a window may be: near its middle, by eye.
WINDOW_ALONG = (0.25, 0.75)


def openings_random(plan: Plan, rng: Rng) -> tuple[OpeningSpec, ...] | Rejection:
    """Openings of a plan, doors first; rejected when some door, or daylight, finds no place."""
    doors: list[OpeningSpec] = []
    front = _door(plan.outer(0), "front_door", doors, FRONT_DOOR_WALL_M, rng)
    if front is None:
        return reject("home", "no_place", category="front_door")
    doors.append(front)
    for room in range(1, len(plan.rooms)):
        opening = _between(plan, plan.parents[room], room, doors, rng)
        if opening is None:
            return reject("home", "no_place", category="door")
        doors.append(opening)
    ways = [sum(k == p for p in plan.parents) + (k > 0) for k in range(len(plan.rooms))]
    for a, b, chance in _also_joined(plan):
        wanted = rng.random() < chance and max(ways[a], ways[b]) < WAYS_MOST
        opening = _between(plan, a, b, doors, rng) if wanted else None
        if opening is not None:
            doors.append(opening)
            ways[a], ways[b] = ways[a] + 1, ways[b] + 1
    for planned in plan.rooms:
        least = planned.spec.free_wall_m
        if least and _longest_free_m(planned, doors) < least:
            return reject("home", "no_free_wall", category=planned.type)
    windows = _windows(plan, doors, rng)
    return windows if isinstance(windows, Rejection) else (*doors, *windows)


def _also_joined(plan: Plan) -> list[tuple[int, int, float]]:
    """Pairs of rooms, neither off the other, that may have a door between them, and how often."""
    return [
        (a, b, chance)
        for a, room in enumerate(plan.rooms)
        for other, chance in room.spec.joined
        for b, beside in enumerate(plan.rooms)
        if beside.type == other and a != plan.parents[b] and b != plan.parents[a]
    ]


def _between(
    plan: Plan, a: int, b: int, others: Sequence[OpeningSpec], rng: Rng
) -> OpeningSpec | None:
    """An opening between two rooms of a kind that their types ask, or a door where there is no
    place for it; the leaf of a door opens into ``b``."""
    walls, kind = plan.between(a, b), _kind(plan.rooms[a], plan.rooms[b], rng)
    found = _door(walls, kind, others, DOOR_WALL_M, rng) if kind != "door" else None
    found = found or _door(walls, "door", others, DOOR_WALL_M, rng)
    return found and found.model_copy(update={"hinge_flip": a < b})


def _kind(a: PlannedRoom, b: PlannedRoom, rng: Rng) -> OpeningKind:
    """What joins two rooms: as one of their types says of the other's, else a door."""
    chances = dict(a.spec.opens_to).get(b.type) or dict(b.spec.opens_to).get(a.type) or ()
    draw = float(rng.random())
    for kind, chance in chances:
        draw -= chance
        if draw < 0:
            return kind
    return "door"


def _margin(kind: OpeningKind) -> float:
    if kind in ("passage", "wide_passage", "double_door"):
        return FRAME_M[kind][0] / 2 + HALF_WALL_M + CASING_M
    return FRONT_DOOR_MARGIN_M if kind == "front_door" else DOOR_MARGIN_M


def _door(
    walls: Sequence[Wall],
    kind: OpeningKind,
    others: Sequence[OpeningSpec],
    least_m: float,
    rng: Rng,
) -> OpeningSpec | None:
    margin = _margin(kind)
    fitting = [w for w in walls if w.length_m >= max(least_m, 2 * margin) - 1e-6]
    for _ in range(TRIES if fitting else 0):
        wall = fitting[int(rng.integers(len(fitting)))]
        spare = max(wall.length_m - 2 * margin, 0.0)
        t = float(rng.uniform(0.0, min(spare, NEAR_CORNER_M)))
        if kind in MIDDLE:
            t = spare * float(rng.uniform(*WINDOW_ALONG))
        elif rng.random() >= NEAR_CORNER_CHANCE:
            t = float(rng.uniform(0.0, spare))
        t = wall.low_m + margin + t if rng.random() < 0.5 else wall.high_m - margin - t
        found = OpeningSpec(kind=kind, center_m=_rounded(wall.point(t)), along=wall.along)
        if _apart(found, others):
            return found
    return None


def _longest_free_m(room: PlannedRoom, doors: Sequence[OpeningSpec]) -> float:
    """The longest straight wall of a room where furniture can stand: between walls' middle lines,
    without the doors in it and what those round the corner keep free."""
    outline = shapely.union_all([shapely.box(*r) for r in room.rectangles_m]).simplify(EPS)
    kept = [_kept_free(door, KEPT_M) for door in doors]
    longest = 0.0
    for a, b in pairwise(outline.exterior.coords):
        strip = LineString([a, b]).buffer(STRIP_M, cap_style="flat").intersection(outline)
        along = 0 if abs(b[1] - a[1]) < EPS else 1
        low, high = sorted((a[along], b[along]))
        cuts = [(low, low), (high, high)]
        for shape in kept:
            if strip.intersection(shape).area > EPS:
                bounds = shape.bounds
                cuts.append((max(low, bounds[along]), min(high, bounds[along + 2])))
        cuts.sort()
        reached = low
        for start, end in cuts:
            longest, reached = max(longest, start - reached), max(reached, end)
    return longest


def _kept_free(door: OpeningSpec, depth_m: float) -> Polygon:
    """The floor before and behind a door."""
    half, (x, y) = frame_size(door)[0] / 2, door.center_m
    dx, dy = (half, depth_m) if door.along == "x" else (depth_m, half)
    return shapely.box(x - dx, y - dy, x + dx, y + dy)


def _windows(plan: Plan, doors: Sequence[OpeningSpec], rng: Rng) -> list[OpeningSpec] | Rejection:
    """Windows of all rooms; rejected when one that needs daylight finds no place for any."""
    out: list[OpeningSpec] = []
    for index, room in enumerate(plan.rooms):
        if room.spec.windows == "none":
            continue
        small = room.spec.windows == "small"
        area = sum((c - a) * (d - b) for a, b, c, d in room.rectangles_m)
        second = rng.random() < SECOND_WINDOW_CHANCE and area > SECOND_WINDOW_AREA_M2
        margin = SMALL_WINDOW_MARGIN_M if small else WINDOW_MARGIN_M
        walls = [w for w in plan.outer(index) if w.length_m >= 2 * margin]
        missing = 2 if second and not small else 1
        found: list[OpeningSpec] = []
        # At most one a wall, so that two are never side by side.
        for k in rng.permutation(len(walls)).tolist():
            if len(found) == missing:
                break
            window = _window(walls[k], room, margin, (*doors, *out, *found), rng)
            if window is not None and plan.free_before(walls[k], window.center_m, SIGHT_M):
                found.append(window)
        if room.spec.daylight and not found:
            return reject("home", "no_daylight", category=room.type)
        out += found
    return out


def _window(
    wall: Wall, room: PlannedRoom, margin: float, others: Sequence[OpeningSpec], rng: Rng
) -> OpeningSpec | None:
    """A window near the middle of a wall; None when that is beside another opening."""
    spare = wall.length_m - 2 * margin
    center = _rounded(wall.point(wall.low_m + margin + spare * float(rng.uniform(*WINDOW_ALONG))))
    found = OpeningSpec(
        kind="window",
        center_m=center,
        along=wall.along,
        sill_m=room.spec.sill_m,
        small=room.spec.windows == "small",
    )
    return found if _apart(found, others) else None


def _apart(opening: OpeningSpec, others: Sequence[OpeningSpec]) -> bool:
    width = frame_size(opening)[0]
    return all(
        math.dist(opening.center_m, other.center_m) >= (width + frame_size(other)[0]) / 2 + APART_M
        for other in others
    )


def _rounded(point: Vec2) -> Vec2:
    return round(point[0], 3) + 0.0, round(point[1], 3) + 0.0
