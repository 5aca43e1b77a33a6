"""Bands of walls that wear a surface of their own: skirtings, tiles behind worktops and in the wet.

They are drawn on the wall and as flat as it: nothing stands out that furniture would cut.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

import shapely
from shapely.geometry import LineString, Polygon

from sdgen.catalog.records import Catalog
from sdgen.geometry import Vec2, yaw_of
from sdgen.home.layout import Layout, corners_of
from sdgen.home.style import HomeStyle
from sdgen.library import Library
from sdgen.scene import Band, Home, Room, Structure
from sdgen.vocabulary import FLAT_M, Facing

Edge = tuple[Vec2, Vec2]

#: Units with a worktop are so high, metres, with the tap of a sink: what is higher of a run (a
#: fridge) needs no tiles behind it.
WORKTOP_M = (0.7, 1.35)
#: Tiles end so far above a worktop: where wall units begin.
SPLASH_M = 0.55
#: A unit's back is so near the wall that it stands at (the ends of a U stand a little off it), and
#: gaps up to so wide are tiled too.
BACK_M = 0.1
JOIN_M = 0.65
#: Walls end at outlines but for rounding.
RIM_M = 1e-4
#: A tub or a basin is so near a wall that it wets, tiles go on so far beside it, and up to a corner
#: that is no further away. By eye.
WET_M, BESIDE_WET_M, TO_CORNER_M = 0.15, 0.1, 0.35


class _Span(NamedTuple):
    """What stands at a wall: from where to where along it, and how high it is (or its tiles)."""

    low: float
    high: float
    top: float


def skirting_of(start: Vec2, end: Vec2, library: Library, surface: str) -> Band:
    """The skirting along the wall behind an edge of a room's outline (counter-clockwise): one tile
    of the surface high."""
    axis, facing = _facing(start, end)
    low, high = sorted((start[axis], end[axis]))
    return Band(
        surface=surface,
        facing=facing,
        low_m=(round(low, 4), 0.0),
        high_m=(round(high, 4), library.tile_m(surface)),
    )


def with_tiles(home: Home, layout: Layout, catalog: Catalog, style: HomeStyle) -> Home:
    """The home with tiles, in rooms that its style has some for, on the walls behind the worktops
    of runs and behind furniture whose category says how high its walls are tiled."""
    types = {room_type.name: room_type for room_type in catalog.room_types}
    heights = {c.name: c.tiled_m for c in catalog.categories if c.tiled_m is not None}
    rooms = {room.id: room for room in home.rooms}
    out = []
    for wall in home.structures:
        room = rooms[wall.room_id]
        surface = style.surface("splashback", room.type)
        spec = types.get(room.type)
        edge = _edge_of(wall, room) if wall.category == "wall" and surface is not None else None
        if edge is not None and surface is not None and spec is not None:
            # Not those of an island: at its back, in the middle of the room, stand seats.
            runs = [rule for rule in spec.furniture if rule.where in ("row", "run")]
            units = {name for rule in runs for name in (*rule.row, *rule.extra, rule.corner)}
            areas = [*_behind_worktops(edge, room, layout, units)]
            areas += _in_the_wet(edge, room, layout, heights)
            _, facing = _facing(*edge)
            # Down to the floor there is no skirting.
            tiles = [Band(surface=surface, facing=facing, low_m=a, high_m=b) for a, b in areas]
            if tiles:
                wall = wall.model_copy(update={"bands": (*tiles, *wall.bands)})
        out.append(wall)
    return home.model_copy(update={"structures": tuple(out)})


def _behind_worktops(
    edge: Edge, room: Room, layout: Layout, units: Collection[str]
) -> Iterator[tuple[Vec2, Vec2]]:
    """Lower and upper corners, along and up the wall, of what is above its worktops."""
    axis, _ = _facing(*edge)
    joined: list[_Span] = []
    for span in sorted(_standing_at(edge, BACK_M, room, layout, units)):
        if not WORKTOP_M[0] < span.top < WORKTOP_M[1] or span.high - span.low < 2 * BACK_M:
            continue
        if joined and span.low - joined[-1].high < JOIN_M:
            before = joined.pop()
            high, top = max(before.high, span.high), min(before.top, span.top)
            span = _Span(before.low, high, top)
        joined.append(span)
    ends = sorted((edge[0][axis], edge[1][axis]))
    for span in joined:
        low, high = _to_corners(span.low, span.high, ends, BACK_M)
        yield (low, round(span.top - 0.02, 3)), (high, round(span.top + SPLASH_M, 3))


def _in_the_wet(
    edge: Edge, room: Room, layout: Layout, heights: Mapping[str, float]
) -> Iterator[tuple[Vec2, Vec2]]:
    """Lower and upper corners of what is tiled from the floor up, the highest first."""
    axis, _ = _facing(*edge)
    ends = sorted((edge[0][axis], edge[1][axis]))
    found = sorted(_standing_at(edge, WET_M, room, layout, heights, heights))
    spans = [s for s in found if s.high - s.low > WET_M]
    grown: list[_Span] = []
    for k, span in enumerate(spans):
        low, high = span.low - BESIDE_WET_M, span.high + BESIDE_WET_M
        if k + 1 < len(spans) and 0 < spans[k + 1].low - high < JOIN_M:
            high = spans[k + 1].low
        low, high = _to_corners(low, high, ends, TO_CORNER_M)
        grown.append(_Span(low, high, span.top))
    for span in sorted(grown, key=lambda s: -s.top):
        yield (span.low, 0.0), (span.high, span.top)


def _standing_at(
    edge: Edge,
    reach_m: float,
    room: Room,
    layout: Layout,
    categories: Collection[str],
    heights: Mapping[str, float] | None = None,
) -> Iterator[_Span]:
    """Furniture of these categories on the floor within ``reach_m`` of a wall, as high as it is or
    as ``heights`` says."""
    axis, _ = _facing(*edge)
    strip = LineString(edge).buffer(reach_m, cap_style="flat")
    for object_id in sorted(layout.items):
        item = layout.items[object_id]
        x, y, z = item.pose.position_m
        if item.room_id != room.id or item.category not in categories or z > FLAT_M:
            continue
        info = layout.info(object_id)
        shape = Polygon(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
        at_wall = shapely.intersection(shape, strip)
        if not at_wall.is_empty:
            top = z + info.extents_m[2] if heights is None else heights[item.category]
            yield _Span(at_wall.bounds[axis], at_wall.bounds[axis + 2], top)


def _to_corners(low: float, high: float, ends: Sequence[float], near_m: float) -> Vec2:
    """A stretch of a wall, within its ends and up to one that is near."""
    low = ends[0] if low - ends[0] < near_m else low
    high = ends[1] if ends[1] - high < near_m else high
    return round(low, 4), round(high, 4)


def _edge_of(wall: Structure, room: Room) -> Edge | None:
    """The edge of a room's outline that a wall stands behind."""
    feet = wall.pieces
    low = [min(p.center_m[k] - p.size_m[k] / 2 for p in feet) for k in (0, 1)]
    high = [max(p.center_m[k] + p.size_m[k] / 2 for p in feet) for k in (0, 1)]
    # A line on the very rim of a box may miss it by the last digit.
    body = shapely.box(*low, *high).buffer(RIM_M, join_style="mitre")
    ring: Sequence[Vec2] = room.polygon_m
    for k, start in enumerate(ring):
        end = ring[(k + 1) % len(ring)]
        line = LineString([start, end])
        if body.intersection(line).length > 0.5 * line.length:
            return start, end
    return None


def _facing(start: Vec2, end: Vec2) -> tuple[int, Facing]:
    """The axis that an edge runs along, and where the wall behind it looks: to its left."""
    if abs(end[1] - start[1]) < 1e-9:
        return 0, "+y" if end[0] > start[0] else "-y"
    return 1, "-x" if end[1] > start[1] else "+x"
