"""What ``rooms.py`` counts of furniture that stands too near to something, and of odd groups."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from sdgen.facts import Body
from sdgen.freespace import opening_rectangle
from sdgen.geometry import yaw_of
from sdgen.scene import Opening, Room
from sdgen.vocabulary import FLAT_M, HALF_WALL_M, OVERHEAD_M
from sdgen.zones import swing_sectors
from shapely.geometry import Polygon

#: What readers of pictures called in the way: so far before a doorway, beside its frame, from an
#: open leaf, before a window or a radiator.
LINE_M, FRAME_M, LEAF_M, WINDOW_M, RADIATOR_M = 1.3, 0.35, 0.3, 0.4, 0.3
#: Beside a frame only what reaches no further from the wall than this; from there on it is in line.
AT_WALL_M = 0.6
#: Floor that legs need before an armchair, and between its sides or back and what is no part of it.
LEGS_M, ELBOW_M = 0.28, 0.12
BEHIND_M, LAMP_M, END_TO_END_M, BUTTED_M, TALL_M = 1.6, 0.6, 0.2, 0.12, 1.5
TOUCH_M2 = 2e-3
#: What belongs to a seat, and which seats belong to what they stand at.
ITS_OWN = ("side_table", "floor_lamp", "ottoman", "coffee_table", "rug")
AT_TABLES = ("chair", "stool", "bar_stool", "office_chair", "high_chair")
#: Lives at walls' ends, windows and doors.
SMALL = ("plant_pot", "trash_bin")

#: Worktops stand under windows.
WORKTOPS = ("kitchen",)

#: Notes one more of a kind, and whether it is at fault.
Note = Callable[[str, bool], None]


def look_at_openings(
    room: Room, openings: Sequence[Opening], here: Sequence[Body], doors: Sequence[Body], note: Note
) -> None:
    """Count what crowds the doors and windows of a room of these pieces; ``doors``: the bodies in
    them."""
    pieces = [b for b in here if b.item.category not in (*AT_TABLES, *SMALL)]
    pieces = [b for b in pieces if b.high[2] > FLAT_M and b.low[2] < OVERHEAD_M]
    beside: dict[int, int] = {}
    outline = Polygon(room.polygon_m)
    for opening in openings:
        if opening.kind == "window":
            below = opening_rectangle(opening, HALF_WALL_M + WINDOW_M).intersection(outline)
            if room.type in WORKTOPS:
                continue
            found = [b for b in pieces if _takes(b, below)]
            note("windows with furniture before them", bool(found))
            note("windows with a bed before them", any("bed" in b.item.category for b in found))
            continue
        line = opening_rectangle(opening, HALF_WALL_M + LINE_M).intersection(outline)
        note("doorways with furniture in their line", any(_takes(b, line) for b in pieces))
        wide = opening.model_copy(update={"width_m": opening.width_m + 2 * FRAME_M})
        frame = opening_rectangle(wide, HALF_WALL_M + AT_WALL_M).intersection(outline)
        crowding = [b for b in pieces if _takes(b, frame)]
        note("doorways with furniture at their frame", bool(crowding))
        for body in crowding:
            beside[body.item.id] = beside.get(body.item.id, 0) + 1
    for body in doors:
        for sector in swing_sectors([body]):
            if outline.intersection(sector).area > sector.area / 2:
                near = sector.buffer(LEAF_M)
                note("leaves that open onto furniture", any(_takes(b, near) for b in pieces))
    for body in pieces:
        note("pieces between two doorways", beside.get(body.item.id, 0) > 1)


def look_at_groups(
    here: Sequence[Body], radiators: Sequence[Body], tables: Sequence[str], note: Note
) -> None:
    """Count odd groups: of seats, lamps, benches, shelves and radiators, round tables."""
    standing = [b for b in here if b.high[2] > FLAT_M and b.low[2] < OVERHEAD_M]
    for radiator in radiators:
        before = ahead(radiator, RADIATOR_M)
        covered = any(_takes(b, before) for b in standing)
        note("radiators with furniture before them", covered)
    chairs = _of(standing, "armchair")
    for chair in chairs:
        legs = ahead(chair, LEGS_M)
        others = [b for b in standing if b is not chair]
        no_room = any(_takes(b, legs) for b in others if b.item.category != "ottoman")
        note("armchairs without room for legs", no_room)
        strange = [b for b in others if b.item.category not in ITS_OWN]
        near = any(chair.footprint.distance(b.footprint) < ELBOW_M for b in strange)
        note("armchairs that touch something", near)
        behind = any(
            _takes(c, ahead(chair, BEHIND_M)) and _turned(chair, c) < 60
            for c in chairs
            if c is not chair
        )
        note("armchairs one behind the other", behind)
        for tv in _of(here, "tv"):
            note("armchairs that look away from the television", _off(chair, tv) > 110)
    seats = [b for b in standing if b.item.category in ("armchair", "sofa")]
    for lamp in _of(standing, "floor_lamp"):
        note("floor lamps before a seat", any(_takes(lamp, ahead(s, LAMP_M)) for s in seats))
    racks = _of(standing, "shoe_rack")
    for bench in _of(standing, "bench"):
        close = any(bench.footprint.distance(r.footprint) < END_TO_END_M for r in racks)
        note("benches end to end with a shoe rack", close)
    tall = [b for b in standing if b.high[2] > TALL_M]
    for shelf in _of(here, "wall_shelf"):
        butted = any(shelf.footprint.distance(b.footprint) < BUTTED_M for b in tall)
        note("wall shelves against something tall", butted)
    for table in [b for b in standing if b.item.category in tables]:
        sat_at = [c for c in _of(standing, "chair") if c.footprint.distance(table.footprint) < 0.1]
        note("tables with an odd number of chairs", len(sat_at) % 2 == 1)
        sides = [side for side in (_side_at(table, c) for c in sat_at) if side is not None]
        uneven = len(set(sides)) == 2 and sides.count(1) != sides.count(-1)
        note("tables with more chairs on one side", uneven)


def ahead(body: Body, deep_m: float) -> Polygon:
    """The floor before a body, a little narrower than it is."""
    yaw = yaw_of(body.item.pose.quat_xyzw)
    x, y, _ = body.item.pose.position_m
    half, wide = body.info.extents_m[0] / 2, body.info.extents_m[1] / 2 - 0.05
    c, s = math.cos(yaw), math.sin(yaw)
    ring = [(half, -wide), (half + deep_m, -wide), (half + deep_m, wide), (half, wide)]
    return Polygon([(x + c * u - s * v, y + s * u + c * v) for u, v in ring])


def _of(here: Sequence[Body], category: str) -> list[Body]:
    return [b for b in here if b.item.category == category]


def _takes(body: Body, shape: Polygon) -> bool:
    return bool(shape.intersection(body.footprint).area > TOUCH_M2)


def _local(body: Body, other: Body) -> tuple[float, float]:
    yaw = yaw_of(body.item.pose.quat_xyzw)
    dx, dy = (other.center - body.center)[:2].tolist()
    return dx * math.cos(yaw) + dy * math.sin(yaw), dy * math.cos(yaw) - dx * math.sin(yaw)


def _off(body: Body, other: Body) -> float:
    """Degrees between where a body looks and where the other is."""
    x, y = _local(body, other)
    return abs(math.degrees(math.atan2(y, x)))


def _turned(body: Body, other: Body) -> float:
    """Degrees between where two bodies look."""
    off = yaw_of(body.item.pose.quat_xyzw) - yaw_of(other.item.pose.quat_xyzw)
    return abs(math.degrees(math.remainder(off, 2 * math.pi)))


def _side_at(table: Body, chair: Body) -> int | None:
    """Which long side of a table a chair is at; None: an end."""
    x, y = _local(table, chair)
    if abs(y) > table.info.extents_m[1] / 2:
        return None
    return 1 if x > 0 else -1
