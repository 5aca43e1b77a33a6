"""Base homes: what a drawing can get wrong, and that the shipped ones can be lived in."""

from __future__ import annotations

import math
from collections import Counter
from itertools import combinations, count
from pathlib import Path
from typing import Literal

import pytest
from sdgen.catalog.home_shape import frame_size
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import FurnitureItem, HomeSpec, OpeningSpec
from sdgen.hazards.splits import SplitModels, split_of_home
from sdgen.home.layout import within_room
from sdgen.home.shell import build_shell
from sdgen.home.style import HomeStyle
from sdgen.library import Library
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.seeding import lane
from sdgen.vocabulary import OPENINGS
from shapely import box
from shapely.affinity import rotate, translate
from shapely.geometry import Polygon
from shapely.ops import unary_union

from tests.shipped import shipped_library

from .worlds import problems, write

HOME = """\
id: hut
title: A hut
rooms:
  - name: stube
    type: living_room
    rectangles_m: [[0, 0, 4, 3]]
    furniture:
      - {category: sofa, position_m: [2, 1, 0], yaw_deg: 90}
      - {category: tv_stand, position_m: [2, 2.8, 0], yaw_deg: 270, against_wall: true}
      - {category: tv, position_m: [2, 2.6, 0], yaw_deg: 270, on: tv_stand, optional: true}
  - name: kammer
    type: bedroom
    rectangles_m: [[4, 0, 7, 3]]
openings:
  - {kind: front_door, center_m: [1, 0], along: x}
  - {kind: door, center_m: [4, 1.5], along: y, hinge_flip: true}
  - {kind: window, center_m: [7, 1.5], along: y, sill_m: 0.9, small: true}
"""


def test_a_drawing_is_read(tmp_path: Path) -> None:
    catalog = load_catalog([write(tmp_path, homes__hut=HOME)])
    (hut,) = (home for home in catalog.homes if home.id == "hut")
    assert hut.height_m == 2.6
    assert hut.rooms[0].furniture[2] == FurnitureItem(
        category="tv", position_m=(2.0, 2.6, 0.0), yaw_deg=270.0, on="tv_stand", optional=True
    )
    assert hut.openings[1].hinge_flip
    assert hut.openings[2].sill_m == 0.9


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("[[4, 0, 7, 3]]", "[[3, 0, 7, 3]]", ":13: rooms[1].rectangles_m: overlaps room 'stube'"),
        ("[[4, 0, 7, 3]]", "[[7, 0, 4, 3]]", "expected [x_min, y_min, x_max, y_max]"),
        ("[[4, 0, 7, 3]]", "[4, 0, 7, 3]", "rectangles_m[0]: expected a list of 4 numbers"),
        ("name: kammer", "name: stube", "a second room named 'stube'"),
        ("type: bedroom", "type: bedrom", "unknown room type 'bedrom'"),
        ("[2, 1, 0], yaw", "[5, 1, 0], yaw", "sofa stands outside room 'stube'"),
        ("category: sofa", "category: soffa", "unknown category 'soffa' (did you mean 'sofa'?)"),
        ("on: tv_stand", "on: desk", "furniture[2].on: no desk is placed before it"),
        ("yaw_deg: 90", "yaw_deg: north", "yaw_deg: expected a number, got text 'north'"),
        ("center_m: [4, 1.5]", "center_m: [3.9, 1.5]", "this door has 0 rooms beside it (none)"),
        ("center_m: [4, 1.5], along: y", "center_m: [4, 1.5], along: x", "has 0 rooms beside it"),
        ("center_m: [1, 0], along: x", "center_m: [4, 1], along: y", "this front_door has 2 rooms"),
        ("kind: front_door", "kind: door", "openings: a home has exactly one front_door"),
        (
            "[[4, 0, 7, 3]]",
            "[[4, 0, 7, 1], [4, 2, 7, 3]]",
            "rooms[1].rectangles_m: the rectangles do",
        ),
        ("[[4, 0, 7, 3]]", "[[4, 0, 7, 3], [7, 3, 8, 5]]", "do not join: each must share a side"),
        (
            "[[4, 0, 7, 3]]",
            "[[4, 0, 5, 3], [5, 0, 7, 1], [5, 2, 7, 3], [6, 0, 7, 3]]",
            ":13: rooms[1].rectangles_m: the rectangles leave a hole",
        ),
        ("[[4, 0, 7, 3]]", "[[4, 0, 7, 0.1]]", "the room is too narrow: walls 0.12 m thick leave"),
        (
            "[[4, 0, 7, 3]]",
            "[[4, 0, 7, 3], [7, 1, 8, 1.1], [8, 0, 9, 3]]",
            "the room is too narrow",
        ),
        (
            "center_m: [4, 1.5]",
            "center_m: [4, 2.8]",
            "this door is 0.9 m wide, and only 0.59 m of it lie in the wall of room 'stube'",
        ),
        ("center_m: [1, 0]", "center_m: [0.5, 0]", ":15: openings[0].center_m: this front_door is"),
        (
            "openings:",
            "openings:\n  - {kind: window, center_m: [1.9, 0], along: x}",
            "this front_door overlaps openings[0], a window",
        ),
        (
            "sill_m: 0.9, small",
            "sill_m: 2.1, small",
            ":17: openings[2].sill_m: this window ends 2.7 m up, and the rooms at 2.6 m",
        ),
        ("title: A hut", "title: A hut\nheight_m: 2.0", "kind: this front_door ends 2.1 m up"),
        (
            "{kind: door, center_m: [4, 1.5], along: y, hinge_flip: true}",
            "{kind: window, center_m: [5.5, 0], along: x}",
            ":11: rooms[1]: no doors lead from the front_door to room 'kammer'",
        ),
    ],
)
def test_a_bad_drawing_is_told(tmp_path: Path, old: str, new: str, problem: str) -> None:
    assert old in HOME
    found = problems(write(tmp_path, homes__hut=HOME.replace(old, new, 1)))
    assert any(problem in line for line in found), found


CORNER = """\
id: hut
title: Three rooms that meet
rooms:
  - {name: a, type: living_room, rectangles_m: [[0, 0, 4, 4]]}
  - {name: b, type: kitchen, rectangles_m: [[4, 0, 8, 2]]}
  - {name: c, type: bedroom, rectangles_m: [[4, 2, 8, 6]]}
openings:
  - {kind: front_door, center_m: [2, 0], along: x}
  - {kind: door, center_m: [4, 1.95], along: y}
  - {kind: door, center_m: [6, 2], along: x}
"""


def test_a_door_where_three_rooms_meet_is_told(tmp_path: Path) -> None:
    """Its centre is beside two of them, its width beside the third, too."""
    (problem,) = problems(write(tmp_path, homes__hut=CORNER))
    assert ":9: openings[1].center_m: this door has 3 rooms beside it (a, b, c)" in problem
    apart = CORNER.replace("[4, 1.95]", "[4, 1.2]")
    (hut,) = (h for h in load_catalog([write(tmp_path, homes__hut=apart)]).homes if h.id == "hut")
    home = build_shell(hut, HomeStyle(), shipped_library(), count(1), lane(0, 0, "shell"))
    names = {room.id: room.name for room in home.rooms}
    between = [tuple(names[key] for key in opening.room_ids) for opening in home.openings]
    assert between == [("a",), ("a", "b"), ("b", "c")]


def test_a_seam_within_a_room_is_no_wall(tmp_path: Path) -> None:
    text = HOME.replace("[[4, 0, 7, 3]]", "[[4, 0, 5.5, 3], [5.5, 0, 7, 3]]")
    text = text.replace("{kind: window, center_m: [7, 1.5]", "{kind: window, center_m: [5.5, 1.5]")
    (problem,) = problems(write(tmp_path, homes__hut=text))
    assert "this window has 0 rooms beside it (none)" in problem


CATALOG = load_catalog()
HOMES = pytest.mark.parametrize("home", CATALOG.homes, ids=lambda home: home.id)
FACE_M = 0.06
#: How far a leaf sweeps; nothing swings in a passage.
SWING_M = {"door": 0.9, "front_door": 1.0, "double_door": 0.8}
FLAT = ("rug", "bath_mat")
#: Their fronts reach under the table or desk they stand at.
TUCKED_IN = ("chair", "office_chair")


def _rooms(home: HomeSpec) -> dict[str, Polygon]:
    return {room.name: unary_union([box(*r) for r in room.rectangles_m]) for room in home.rooms}


def _print(item: FurnitureItem, largest: bool) -> Polygon:
    """Footprint of a piece with the largest (or smallest) size its category allows."""
    category = CATALOG.category(item.category)
    depth, width, _ = category.extents_max_m if largest else category.extents_min_m
    if item.width_m is not None:
        width = min(max(width, item.width_m[0]), item.width_m[1])
    shape = box(-depth / 2, -width / 2, depth / 2, width / 2)
    if item.against_wall:
        shape = translate(shape, depth / 2, 0)
    turned = rotate(shape, item.yaw_deg, origin=(0, 0))
    return translate(turned, item.position_m[0], item.position_m[1])


def _swing(home: HomeSpec, opening: OpeningSpec) -> Polygon:
    """What a door's leaves sweep, in the room listed first (or last, when flipped)."""
    x, y = opening.center_m
    reach = SWING_M[opening.kind]
    half = frame_size(opening)[0] / 2
    across = box(x - half, y - reach, x + half, y + reach)
    beside = box(x - reach, y - half, x + reach, y + half)
    both = across if opening.along == "x" else beside
    rooms = [room for room in _rooms(home).values() if room.intersection(both).area > 0.1]
    return both.intersection(rooms[-1] if opening.hinge_flip else rooms[0])


@HOMES
def test_furniture_stays_in_its_room_off_walls_and_apart(home: HomeSpec) -> None:
    outlines = _rooms(home)
    for room in home.rooms:
        inner = outlines[room.name].buffer(-FACE_M + 0.001, join_style="mitre")
        standing = [i for i in room.furniture if i.on is None and i.position_m[2] < 1.0]
        for item in standing:
            assert inner.contains(_print(item, largest=False)), f"{room.name}: {item.category}"
        needed = [i for i in standing if i.category not in (*FLAT, *TUCKED_IN)]
        for a, b in combinations(needed, 2):
            if "crib" in (a.category, b.category) and a.optional and b.optional:
                continue  # a cot takes the place of what an infant's parents do without
            overlap = _print(a, False).intersection(_print(b, False)).area
            assert overlap < 1e-6, f"{room.name}: {a.category} and {b.category}"


@HOMES
def test_backs_stand_two_to_four_centimetres_off_the_wall(home: HomeSpec) -> None:
    outlines = _rooms(home)
    for room in home.rooms:
        inner = outlines[room.name].buffer(-FACE_M, join_style="mitre")
        for item in room.furniture:
            if item.against_wall and item.on is None and item.position_m[2] == 0.0:
                back = box(*([item.position_m[0], item.position_m[1]] * 2)).centroid
                gap = inner.exterior.distance(back)
                assert 0.0 <= gap <= 0.045, f"{room.name}: {item.category} {gap:.3f}"


@HOMES
def test_doors_swing_free_even_beside_the_largest_furniture(home: HomeSpec) -> None:
    pieces = [
        (item, _print(item, largest=True))
        for room in home.rooms
        for item in room.furniture
        if item.category not in FLAT and item.position_m[2] < 1.0
    ]
    for opening in home.openings:
        if opening.kind not in SWING_M:
            continue
        swing = _swing(home, opening)
        for item, shape in pieces:
            assert swing.intersection(shape).area < 1e-6, f"{item.category} at {item.position_m}"


@HOMES
def test_a_person_gets_from_door_to_door(home: HomeSpec) -> None:
    """0.7 m wide ways join all the doorways of a room, past its usual furniture."""
    outlines = _rooms(home)
    for room in home.rooms:
        free = outlines[room.name].buffer(-FACE_M, join_style="mitre")
        for item in room.furniture:
            low = item.category in FLAT
            if not low and item.on is None and item.position_m[2] < 1.0:
                free = free.difference(_print(item, largest=False))
        ways = free.buffer(-0.35)
        parts = list(ways.geoms) if hasattr(ways, "geoms") else [ways]
        doors = [
            box(x - 0.5, y - 0.5, x + 0.5, y + 0.5)
            for x, y in (o.center_m for o in home.openings if o.kind != "window")
            if outlines[room.name].distance(box(x, y, x, y).centroid) < 0.01
        ]
        assert doors, room.name
        assert any(all(part.intersects(door) for door in doors) for part in parts), room.name


@HOMES
def test_the_home_has_its_rooms_and_size(home: HomeSpec) -> None:
    types = {room.type for room in home.rooms}
    assert types >= {"kitchen", "living_room", "bedroom", "bathroom"}
    area = sum(outline.area for outline in _rooms(home).values())
    assert 40 <= area <= 140
    present = {item.category for room in home.rooms for item in room.furniture if not item.optional}
    assert present >= {"fridge", "stove", "kitchen_counter", "sofa", "bed"}
    assert present & {"kitchen_table", "dining_table"}
    assert all(math.isfinite(v) for room in home.rooms for r in room.rectangles_m for v in r)


@HOMES
def test_every_hazard_finds_what_it_needs(home: HomeSpec) -> None:
    needed = {i.category for room in home.rooms for i in room.furniture if not i.optional}
    assert needed >= {"sink_cabinet", "washbasin", "nightstand", "coffee_table", "bookshelf"}
    assert {"trash_bin"} <= {i.category for room in home.rooms for i in room.furniture}
    left, low, right, high = unary_union(list(_rooms(home).values())).bounds
    assert max(right - left, high - low) <= 18  # wider homes would lose shadows at the rim


def test_unknown_names_do_not_hide_what_is_drawn_wrong(tmp_path: Path) -> None:
    text = HOME.replace("type: bedroom", "type: bedrom").replace("[[4, 0, 7, 3]]", "[[3, 0, 7, 3]]")
    text = text.replace("category: sofa", "category: soffa")
    told = problems(write(tmp_path, homes__hut=text))
    for line in (
        ":8: rooms[0].furniture[0].category: unknown category 'soffa' (did you mean 'sofa'?)",
        ":12: rooms[1].type: unknown room type 'bedrom' (did you mean 'bedroom'?)",
        ":13: rooms[1].rectangles_m: overlaps room 'stube'",
    ):
        assert any(line in one for one in told), told
    assert len(told) == len(set(told))


def test_a_home_is_known_by_what_it_holds(tmp_path: Path) -> None:
    file = tmp_path / "hut.yaml"
    file.write_text(HOME)
    assert "hut" in [home.id for home in load_catalog([file]).homes]


def test_every_split_has_base_homes() -> None:
    """At least seven, most of them to train with, and families with children in every split."""
    homes = Counter(split_of_home(home.id) for home in CATALOG.homes)
    assert homes.total() >= 7
    assert homes["train"] > max(homes["val"], homes["test"])
    assert min(homes["val"], homes["test"]) >= 1
    for_children = [h for h in CATALOG.homes if any(r.type == "child_room" for r in h.rooms)]
    assert {split_of_home(home.id) for home in for_children} == {"train", "val", "test"}


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


@HOMES
@pytest.mark.parametrize("split", ["train", "test"])
def test_the_home_can_be_furnished_every_time(
    home: HomeSpec, split: Literal["train", "test"], library: Library
) -> None:
    """Whatever models are drawn: every needed piece stands, none on the floor reaches into a wall,
    every room is reached."""
    models = SplitModels(library, split)
    for index in range(8):
        stage = furnished_home(home, CATALOG, library, models, count(1), lane(0, index, "furnish"))
        assert isinstance(stage, FurnishedHome), stage
        for item in stage.layout.items.values():
            if item.category not in OPENINGS and item.pose.position_m[2] == 0.0:
                blocks = stage.layout.space_of(item.id)
                assert within_room(blocks, stage.context.home, item.room_id), item
