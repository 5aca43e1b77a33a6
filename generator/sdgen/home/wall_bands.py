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
#: A wall by its id, and a lower and an upper corner, along and up it.
Area = tuple[int, Vec2, Vec2]

#: Units with a worktop are so high, metres, with the tap of a sink: what is higher of a run (a
#: fridge) needs no tiles behind it, but between two worktops they go on behind it.
WORKTOP_M = (0.7, 1.35)
#: Tiles begin so far below the lowest worktop of a room, and end where its wall units begin, or so
#: far above it.
BELOW_TOP_M, SPLASH_M = 0.02, 0.55
#: A unit's back is so near the wall that it stands at (the ends of a U stand a little off it), and
#: gaps up to so wide are tiled too, to a corner of the room up to so wide.
BACK_M = 0.1
JOIN_M, TO_CORNER_M = 0.65, 0.2
#: Walls end at outlines but for rounding.
RIM_M = 1e-4
#: A tub or a basin is so near a wall that it wets.
WET_M = 0.15


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
    """The home with tiles, in rooms that its style has some for: round all walls of a room with
    wet furniture (whose category says how high its walls are tiled), and behind worktops of runs,
    both between the same heights wherever they are in a room."""
    types = {room_type.name: room_type for room_type in catalog.room_types}
    heights = {c.name: c.tiled_m for c in catalog.categories if c.tiled_m is not None}
    walls = [wall for wall in home.structures if wall.category == "wall"]
    tiles: dict[int, list[Band]] = {}
    for room in home.rooms:
        surface, spec = style.surface("splashback", room.type), types.get(room.type)
        if surface is None or spec is None:
            continue
        edges = {w.id: _edge_of(w, room) for w in walls if w.room_id == room.id}
        found = {k: edge for k, edge in edges.items() if edge is not None}
        # Not those of an island: at its back, in the middle of the room, stand seats.
        runs = [rule for rule in spec.furniture if rule.where in ("row", "run")]
        units = {name for rule in runs for name in (*rule.row, *rule.extra, rule.corner)}
        hung_m = next((rule.z_m for rule in spec.furniture if rule.where == "over"), None)
        areas = [
            *_behind_worktops(found, room, layout, units, hung_m),
            *_in_the_wet(found, room, layout, heights, style.tiled_m),
        ]
        for k, low, high in areas:
            _, facing = _facing(*found[k])
            band = Band(surface=surface, facing=facing, low_m=low, high_m=high)
            tiles.setdefault(k, []).append(band)
    # Down to the floor there is no skirting: of bands that overlap the first is seen.
    structures = (
        wall.model_copy(update={"bands": (*tiles[wall.id], *wall.bands)})
        if wall.id in tiles
        else wall
        for wall in home.structures
    )
    return home.model_copy(update={"structures": tuple(structures)})


def _behind_worktops(
    edges: Mapping[int, Edge],
    room: Room,
    layout: Layout,
    units: Collection[str],
    hung_m: float | None,
) -> list[Area]:
    """What is tiled above worktops: at each wall from where a run of units begins to where it
    ends, up to ``hung_m`` where wall units are, all of a room between the same heights."""
    found: list[tuple[int, float, float]] = []
    tops: list[float] = []
    for k, edge in edges.items():
        axis, _ = _facing(*edge)
        ends = sorted((edge[0][axis], edge[1][axis]))
        for run in _runs(sorted(_standing_at(edge, BACK_M, room, layout, units))):
            # What is only the side of the last unit of a run along the next wall is as good.
            tiled = [s for s in run if _is_worktop(s) and s.high - s.low >= 2 * BACK_M]
            if tiled:
                low, high = min(s.low for s in tiled), max(s.high for s in tiled)
                found.append((k, *_to_corners(low, high, ends)))
                tops += [s.top for s in tiled]
    if not found:
        return []
    bottom = round(min(tops) - BELOW_TOP_M, 3)
    top = round(min(tops) + SPLASH_M, 3) if hung_m is None else hung_m
    return [(k, (low, bottom), (high, top)) for k, low, high in found]


def _runs(spans: Sequence[_Span]) -> Iterator[list[_Span]]:
    """Units at one wall, in order along it, parted where nothing stands for long."""
    run: list[_Span] = []
    for span in spans:
        if run and span.low - max(s.high for s in run) >= JOIN_M:
            yield run
            run = []
        run.append(span)
    if run:
        yield run


def _is_worktop(span: _Span) -> bool:
    return WORKTOP_M[0] < span.top < WORKTOP_M[1]


def _in_the_wet(
    edges: Mapping[int, Edge],
    room: Room,
    layout: Layout,
    heights: Mapping[str, float],
    tiled_m: float,
) -> Iterator[Area]:
    """All walls of a room with wet furniture from the floor up to ``tiled_m``, a wall that some
    stands at up to what it wets, if that is higher: tiles end at corners of the room alone."""
    if not any(i.room_id == room.id and i.category in heights for i in layout.items.values()):
        return
    for k, edge in edges.items():
        axis, _ = _facing(*edge)
        low, high = sorted((edge[0][axis], edge[1][axis]))
        wet = _standing_at(edge, WET_M, room, layout, heights, heights)
        top = max((s.top for s in wet if s.high - s.low > WET_M), default=0.0)
        top = min(max(top, tiled_m), room.height_m)
        yield k, (round(low, 4), 0.0), (round(high, 4), round(top, 3))


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
        # What only touches the strip has its edge there by the last digit.
        if at_wall.area > RIM_M:
            top = z + info.extents_m[2] if heights is None else heights[item.category]
            yield _Span(at_wall.bounds[axis], at_wall.bounds[axis + 2], top)


def _to_corners(low: float, high: float, ends: Sequence[float]) -> Vec2:
    """A stretch of a wall, within its ends and up to one that is near."""
    low = ends[0] if low - ends[0] < TO_CORNER_M else low
    high = ends[1] if ends[1] - high < TO_CORNER_M else high
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
