"""Bands of walls that wear a surface of their own: skirtings, and tiles behind kitchen units.

They are drawn on the wall and as flat as it: nothing stands out that furniture would cut.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import shapely
from shapely.geometry import LineString, Polygon

from sdgen.catalog.records import RoomType
from sdgen.geometry import Vec2, yaw_of
from sdgen.home.layout import Layout, corners_of
from sdgen.home.style import HomeStyle
from sdgen.library import Library
from sdgen.scene import Band, Home, Room, Structure
from sdgen.vocabulary import FLAT_M, Facing

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


def with_splashbacks(
    home: Home, layout: Layout, types: Mapping[str, RoomType], style: HomeStyle
) -> Home:
    """The home with tiles on the walls behind the worktops of its runs, if its style has any."""
    walls = {structure.id: structure for structure in home.structures}
    for room in home.rooms:
        surface = style.surface("splashback", room.type)
        spec = types.get(room.type)
        if surface is None or spec is None:
            continue
        # Not those of an island: at its back, in the middle of the room, stand seats.
        runs = [rule for rule in spec.furniture if rule.where in ("row", "run")]
        units = {name for rule in runs for name in (*rule.row, *rule.extra, rule.corner)}
        for structure in home.structures:
            if structure.room_id == room.id and structure.category == "wall":
                bands = tuple(_splashes(structure, room, layout, units, surface))
                if bands:
                    old = walls[structure.id]
                    walls[structure.id] = old.model_copy(update={"bands": (*old.bands, *bands)})
    return home.model_copy(update={"structures": tuple(walls.values())})


def _splashes(
    wall: Structure, room: Room, layout: Layout, units: Iterable[str], surface: str
) -> Iterable[Band]:
    """Bands of one wall above the worktops that stand against it."""
    edge = _edge_of(wall, room)
    if edge is None:
        return
    axis, facing = _facing(*edge)
    strip = LineString(edge).buffer(BACK_M, cap_style="flat")
    spans: list[tuple[float, float, float]] = []
    for object_id in sorted(layout.items):
        item = layout.items[object_id]
        info = layout.info(object_id)
        x, y, z = item.pose.position_m
        top = z + info.extents_m[2]
        if item.room_id != room.id or item.category not in units or z > FLAT_M:
            continue
        if not WORKTOP_M[0] < top < WORKTOP_M[1]:
            continue
        shape = Polygon(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
        at_wall = shapely.intersection(shape, strip)
        if not at_wall.is_empty:
            bounds = at_wall.bounds
            spans.append((bounds[axis], bounds[axis + 2], top))
    spans.sort()
    joined: list[tuple[float, float, float]] = []
    for low, high, top in spans:
        if high - low < 2 * BACK_M:
            continue
        if joined and low - joined[-1][1] < JOIN_M:
            before = joined.pop()
            low, high, top = before[0], max(before[1], high), min(before[2], top)
        joined.append((low, high, top))
    ends = sorted((edge[0][axis], edge[1][axis]))
    for low, high, top in joined:
        # Up to a corner that a run ends at.
        low = ends[0] if low - ends[0] < BACK_M else low
        high = ends[1] if ends[1] - high < BACK_M else high
        base = round(top - 0.02, 3)
        yield Band(
            surface=surface,
            facing=facing,
            low_m=(round(low, 4), base),
            high_m=(round(high, 4), round(top + SPLASH_M, 3)),
        )


def _edge_of(wall: Structure, room: Room) -> tuple[Vec2, Vec2] | None:
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
