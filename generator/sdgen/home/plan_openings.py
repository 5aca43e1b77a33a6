"""Doors and windows of a floor plan: every room opens to the hub, one front door, daylight."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sdgen.catalog.records import OpeningSpec
from sdgen.geometry import Vec2
from sdgen.home.plan import DOOR_WALL_M, FRONT_DOOR_WALL_M, Plan, PlannedRoom
from sdgen.home.walls import Wall
from sdgen.rejection import Rejection, reject
from sdgen.seeding import Rng

#: From a corner (walls' middle lines) to the middle of a door, a front door, a window: half its
#: width, half a wall, and by eye about 20 cm of wall (14 cm beside a front door or a window).
DOOR_MARGIN_M = 0.72
FRONT_DOOR_MARGIN_M = 0.8
WINDOW_MARGIN_M = 0.8
SMALL_WINDOW_MARGIN_M = 0.5
#: Doors whose middles are nearer than this would open into each other.
DOORS_APART_M = 1.25
#: Shares chosen by eye, not measured: doors mostly near corners, larger rooms often with two
#: windows.
NEAR_CORNER_CHANCE = 0.7
#: A door near a corner is up to so much further from it than its margin, metres. By eye.
NEAR_CORNER_M = 0.3
SECOND_WINDOW_CHANCE = 0.5
SECOND_WINDOW_AREA_M2 = 11.0
#: Places drawn for a door; of 909 doors that found one, all did within six.
TRIES = 12
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
        door = _door(plan.between(0, room), "door", doors, DOOR_WALL_M, rng)
        if door is None:
            return reject("home", "no_place", category="door")
        # The leaf opens away from the hub, which comes first in the list of rooms.
        doors.append(door.model_copy(update={"hinge_flip": True}))
    for a, b, chance in _also_joined(plan):
        wanted = rng.random() < chance
        door = _door(plan.between(a, b), "door", doors, DOOR_WALL_M, rng)
        if wanted and door is not None:
            doors.append(door)
    windows = _windows(plan, doors, rng)
    return windows if isinstance(windows, Rejection) else (*doors, *windows)


def _also_joined(plan: Plan) -> list[tuple[int, int, float]]:
    """Pairs of rooms, none the hub, that may have a door between them, and how often."""
    rooms = list(enumerate(plan.rooms))[1:]
    return [
        (a, b, chance)
        for a, room in rooms
        for other, chance in room.spec.joined
        for b, beside in rooms
        if beside.type == other
    ]


def _door(
    walls: Sequence[Wall], kind: str, others: Sequence[OpeningSpec], least_m: float, rng: Rng
) -> OpeningSpec | None:
    margin = FRONT_DOOR_MARGIN_M if kind == "front_door" else DOOR_MARGIN_M
    fitting = [w for w in walls if w.length_m >= max(least_m, 2 * margin)]
    for _ in range(TRIES if fitting else 0):
        wall = fitting[int(rng.integers(len(fitting)))]
        spare = wall.length_m - 2 * margin
        t = float(rng.uniform(0.0, min(spare, NEAR_CORNER_M)))
        if rng.random() >= NEAR_CORNER_CHANCE:
            t = float(rng.uniform(0.0, spare))
        t = wall.low_m + margin + t if rng.random() < 0.5 else wall.high_m - margin - t
        center = _rounded(wall.point(t))
        if _apart(center, others):
            return OpeningSpec.model_validate(
                {"kind": kind, "center_m": center, "along": wall.along}
            )
    return None


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
            found += [] if window is None else [window]
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
    if not _apart(center, others):
        return None
    return OpeningSpec(
        kind="window",
        center_m=center,
        along=wall.along,
        sill_m=room.spec.sill_m,
        small=room.spec.windows == "small",
    )


def _apart(center: Vec2, others: Sequence[OpeningSpec]) -> bool:
    return all(math.dist(center, other.center_m) >= DOORS_APART_M for other in others)


def _rounded(point: Vec2) -> Vec2:
    return round(point[0], 3) + 0.0, round(point[1], 3) + 0.0
