"""Skirtings run along the walls of the rooms that a style gives them; tiles are behind worktops."""

from __future__ import annotations

from itertools import pairwise

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import HomeSpec
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.layout import corners_of
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome, furnished_home, pick_home
from sdgen.seeding import lane
from shapely.geometry import LineString, Polygon

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()


@pytest.fixture(scope="module")
def homes() -> list[FurnishedHome]:
    options = BuildOptions(n=20, seed=5, homes="procedural")
    made = []
    for index in range(8):
        spec = pick_home(CATALOG, options, index).spec(CATALOG, lane(5, index, "plan"))
        assert isinstance(spec, HomeSpec)
        ids = iter((lane(5, index, "ids").permutation(65535) + 1).tolist())
        models = SplitModels(LIBRARY, "train")
        home = furnished_home(spec, CATALOG, LIBRARY, models, ids, lane(5, index, "furnish"))
        made += [home] if isinstance(home, FurnishedHome) else []
    assert len(made) >= 5
    return made


def line_of(wall, band) -> LineString:
    """Where a band is on the floor plan, on the face of its wall."""
    sign, axis = (1 if band.facing[0] == "+" else -1), "xy".index(band.facing[1])
    (piece, *_) = wall.pieces
    at = piece.center_m[axis] + sign * piece.size_m[axis] / 2
    ends = [(at, t) if axis == 0 else (t, at) for t in (band.low_m[0], band.high_m[0])]
    return LineString(ends)


def test_skirtings_run_along_the_outline_of_their_room(homes):
    for made in homes:
        home = made.context.home
        style = next(s for s in CATALOG.styles if s.name == home.style)
        dry = {room for choice in style.skirtings for room in choice.rooms}
        rooms = {room.id: room for room in home.rooms}
        for wall in home.structures:
            feet = [b for b in wall.bands if LIBRARY.surfaces[b.surface].kind == "skirting"]
            room = rooms[wall.room_id]
            assert len(feet) == (wall.category == "wall" and room.type in dry)
            for band in feet:
                assert (band.low_m[1], band.high_m[1]) == (0.0, LIBRARY.tile_m(band.surface))
                outline = Polygon(room.polygon_m).exterior
                assert line_of(wall, band).distance(outline) < 1e-3
                # It looks into the room.
                sign, axis = (1 if band.facing[0] == "+" else -1), "xy".index(band.facing[1])
                x, y = line_of(wall, band).interpolate(0.5, normalized=True).coords[0]
                into = (x + 0.05 * sign, y) if axis == 0 else (x, y + 0.05 * sign)
                assert Polygon(room.polygon_m).contains(LineString([into, into]).centroid)


def test_tiles_are_behind_worktops_and_nowhere_else(homes):
    tiled = 0
    for made in homes:
        for wall in made.context.home.structures:
            for band in wall.bands:
                if LIBRARY.surfaces[band.surface].kind == "skirting" or not band.low_m[1]:
                    continue
                line = line_of(wall, band)
                behind = 0.0
                for item in made.layout.items.values():
                    if item.room_id == wall.room_id and item.category in UNITS:
                        x, y, _ = item.pose.position_m
                        info = made.layout.info(item.id)
                        ring = corners_of(info, x, y, yaw_of(item.pose.quat_xyzw))
                        behind += Polygon(ring).buffer(0.11).intersection(line).length
                # Between two units that stand a little apart, too.
                assert behind > 0.3 * line.length
                assert line.length - behind < 1.4
                # From the worktop, or the console at a stove's back, to the wall units.
                assert 0.75 < band.low_m[1] < 1.2 < band.high_m[1] < 1.8
                tiled += 1
    assert tiled >= len(homes)


def test_wet_rooms_are_tiled_all_round(homes):
    """From corner to corner of every wall, as high as the home has it; higher where a tub wets."""
    heights = {c.name: c.tiled_m for c in CATALOG.categories if c.tiled_m}
    used = set()
    for made in homes:
        wet = {i.room_id for i in made.layout.items.values() if i.category in heights}
        rooms = {r.id: r for r in made.context.home.rooms}
        lower = {}
        for wall in made.context.home.structures:
            if wall.category != "wall" or rooms[wall.room_id].type not in ("bathroom", "toilet"):
                continue
            assert wall.room_id in wet
            (band,) = wall.bands
            line = line_of(wall, band)
            outline = Polygon(rooms[wall.room_id].polygon_m).exterior
            corners = [LineString([c, c]).centroid for c in outline.coords]
            for end in line.boundary.geoms:
                assert min(end.distance(corner) for corner in corners) < 1e-3
            assert band.low_m[1] == 0
            tubs = [i for i in made.layout.items.values() if i.category == "bathtub"]
            if not any(distance(made, tub, line) < 0.2 for tub in tubs):
                lower.setdefault(wall.room_id, set()).add(band.high_m[1])
        assert all(len(found) == 1 for found in lower.values())
        of_home = set().union(*lower.values())
        assert len(of_home) <= 1
        used |= of_home
    assert used == {1.2, 2.1}


def test_tiles_of_one_kitchen_are_between_two_heights_and_run_on(homes):
    """Between two worktops at one wall there is no hole but where something long is no worktop."""
    for made in homes:
        rooms = {r.id: r for r in made.context.home.rooms}
        found = {}
        for wall in made.context.home.structures:
            if rooms[wall.room_id].type == "kitchen":
                bands = [b for b in wall.bands if LIBRARY.surfaces[b.surface].kind != "skirting"]
                found.setdefault(wall.room_id, set()).update(
                    (b.low_m[1], b.high_m[1]) for b in bands
                )
                spans = sorted((b.low_m[0], b.high_m[0]) for b in bands)
                assert all(b[0] - a[1] > 0.6 for a, b in pairwise(spans))
        assert all(len(heights) <= 1 for heights in found.values())


def test_every_basin_has_tiles_behind_it(homes):
    """On whichever wall it hangs: all four find the edge that they stand behind."""
    for made in homes:
        rooms = {room.id: room for room in made.context.home.rooms}
        walls = [s for s in made.context.home.structures if s.category == "wall"]
        for item in made.layout.items.values():
            if item.category != "washbasin" or rooms[item.room_id].type != "bathroom":
                continue
            lines = [line_of(w, b) for w in walls if w.room_id == item.room_id for b in w.bands]
            assert min(distance(made, item, line) for line in lines) < 0.1


def distance(made, item, line) -> float:
    x, y, _ = item.pose.position_m
    ring = corners_of(made.layout.info(item.id), x, y, yaw_of(item.pose.quat_xyzw))
    return Polygon(ring).distance(line)


#: Some fridges are as low as a worktop.
def test_every_stove_at_a_wall_has_tiles_behind_it(homes):
    """At whichever wall it stands: all find the edge of the outline that they are behind."""
    at_walls = 0
    for made in homes:
        rooms = {room.id: Polygon(room.polygon_m) for room in made.context.home.rooms}
        for item in made.layout.items.values():
            if item.category != "stove":
                continue
            x, y, _ = item.pose.position_m
            ring = corners_of(made.layout.info(item.id), x, y, yaw_of(item.pose.quat_xyzw))
            shape = Polygon(ring).buffer(0.1)
            walls = [w for w in made.context.home.structures if w.room_id == item.room_id]
            tiled = [
                line_of(wall, band)
                for wall in walls
                for band in wall.bands
                if LIBRARY.surfaces[band.surface].kind == "splashback"
            ]
            if rooms[item.room_id].exterior.intersects(shape):
                assert any(shape.intersects(line) for line in tiled)
                at_walls += 1
    assert at_walls > 4


UNITS = ("kitchen_counter", "sink_cabinet", "stove", "dishwasher", "corner_counter", "fridge")
