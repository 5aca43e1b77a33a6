"""Islands: units side by side in the middle of a kitchen, with room to walk all round them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import shapely
from shapely.geometry import Polygon

from sdgen.catalog.records import FurnitureRule
from sdgen.freespace import polygons, union
from sdgen.geometry import Vec2, yaw_of
from sdgen.home.anchors import PlacedAt
from sdgen.home.room_try import RoomTry, with_placed
from sdgen.home.run_shapes import UNIT_GAP_M
from sdgen.library.records import Asset

#: Bound the search: rows of models drawn, and places tried for each beside the middle of the floor
#: that is free, so far from it (one sigma).
DRAWN, PLACES, SPREAD_M = 4, 6, 0.15
#: Who sits at an island's back has so much of it, and stands so far from it.
SEAT_M, SEAT_GAP_M = 0.6, 0.05


def with_island(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with the units of a row in its middle, ``gap_m`` from walls and furniture, their
    fronts towards a run; of ``extra``, what finds a place at their backs. None where there is no
    room for it."""
    free = tried.outline.buffer(-rule.gap_m, join_style="mitre").difference(tried.doors)
    free = free.difference(union([shape.buffer(rule.gap_m) for shape in tried.prints.values()]))
    for part in polygons(free)[:1]:
        middle = shapely.maximum_inscribed_circle(part, tolerance=0.05).coords[0]
        for _ in range(DRAWN):
            units = _drawn(rule.row, tried)
            if not units:
                return None
            for yaw in _headings(rule, tried):
                made = _placed(rule, units, part, (middle[0], middle[1]), yaw, tried)
                if made is not None:
                    return made
    return None


def _drawn(categories: Sequence[str], tried: RoomTry) -> list[Asset]:
    """A model of each category; none where one has none."""
    found = [tried.models(category) for category in categories]
    return [m[int(tried.rng.integers(len(m)))] for m in found] if all(found) else []


def _headings(rule: FurnitureRule, tried: RoomTry) -> list[float]:
    """Headings with the front towards units that stand at walls, those that most stand at first."""
    yaws = [yaw_of(tried.layout.items[k].pose.quat_xyzw) for k in tried.all(rule.row)]
    turned = [round(yaw + math.pi, 3) for yaw in yaws]
    return sorted(dict.fromkeys(turned), key=lambda yaw: -turned.count(yaw))


def _placed(
    rule: FurnitureRule,
    units: Sequence[Asset],
    free: Polygon,
    middle: Vec2,
    yaw: float,
    tried: RoomTry,
) -> RoomTry | None:
    deep = max(unit.extents_m[0] for unit in units)
    wide = sum(unit.extents_m[1] for unit in units) + UNIT_GAP_M * (len(units) - 1)
    for _ in range(PLACES):
        x, y = (float(at + tried.rng.normal(0.0, SPREAD_M)) for at in middle)
        corners = [
            _at((x, y), yaw, u * deep / 2, v * wide / 2)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
        if not free.contains(shapely.polygons(corners)):
            continue
        made: RoomTry | None = tried
        t = -wide / 2
        for unit in units:
            spot = _at((x, y), yaw, 0.0, t + unit.extents_m[1] / 2)
            t += unit.extents_m[1] + UNIT_GAP_M
            made = None if made is None else with_placed(rule, unit, (*spot, 0.0, yaw), None, made)
        if made is not None:
            seated = _with_seats(rule, made, (x, y, 0.0, yaw), (deep, wide))
            # All else keeps off what it takes to walk round it.
            around = shapely.polygons(corners).buffer(rule.gap_m)
            island = next(reversed(made.layout.items))
            return replace(seated, keep=(*seated.keep, (island, around)))
    return None


def _with_seats(rule: FurnitureRule, tried: RoomTry, at: PlacedAt, size: Vec2) -> RoomTry:
    """The room with seats at the back of an island of a size (depth, width)."""
    x, y, z, yaw = at
    deep, wide = size
    standing = rule.model_copy(update={"front_m": 0.0})
    seats = rule.extra[: int(wide / SEAT_M)]
    seated: Asset | None = None
    for number, category in enumerate(seats):
        found = tried.models(category)
        if not found or tried.full(category):
            break
        seated = seated or found[int(tried.rng.integers(len(found)))]
        off = -(deep / 2 + SEAT_GAP_M + seated.extents_m[0] / 2)
        along = wide * ((number + 0.5) / len(seats) - 0.5)
        pose = (*_at((x, y), yaw, off, along), z, yaw)
        tried = with_placed(standing, seated, pose, None, tried) or tried
    return tried


def _at(middle: Vec2, yaw: float, ahead: float, left: float) -> Vec2:
    """A point so far before and beside a point, seen along a heading."""
    c, s = math.cos(yaw), math.sin(yaw)
    return middle[0] + c * ahead - s * left, middle[1] + s * ahead + c * left
