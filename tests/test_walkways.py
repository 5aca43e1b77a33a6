"""People walk between doors, to what they use, and across open floor; not under the furniture."""

import pytest
import shapely
from sdgen.facts import bodies_of
from sdgen.freespace import free_shape
from sdgen.walkways import (
    OPEN_FLOOR_M,
    SEATED_M,
    USED_FROM_M,
    WALKWAY_HALF_M,
    front,
    narrow,
    used,
    walked,
)
from sdgen.zones import doorway_point, floor_obstacles
from shapely.geometry import Point, Polygon, box

from tests import toy

KITCHEN, LIVING = 0, 1
TRAITS = {category.name: category.properties for category in toy.catalog().categories}


def floor_walked(room, *furniture, traits=TRAITS):
    home = toy.scene().home
    bodies = bodies_of(furniture, toy.infos())
    obstacles = floor_obstacles(bodies)
    found = walked(
        Polygon(home.rooms[room].polygon_m),
        [doorway_point(home.openings[0], home.rooms[room])],
        used(bodies, traits),
        traits,
        free_shape(home, obstacles),
        shapely.union_all(obstacles),
        free_shape(home, obstacles, OPEN_FLOOR_M),
    )
    assert found.is_valid
    return found


def walks_at(found, x, y, half=0.05):
    return found.contains(Point(x, y).buffer(half))


def test_open_floor_is_walked_and_the_floor_along_walls_is_not():
    found = floor_walked(LIVING)
    assert walks_at(found, 1.0, 5.2)  # nobody needs to go there, and everybody may
    for x, y in ((0.2, 5.8), (3.8, 4.5), (1.0, 5.8)):
        assert not found.intersects(Point(x, y).buffer(0.1))


def test_a_way_leads_from_the_door_to_what_is_used_and_is_wide_enough_to_walk():
    """The bookshelf stands at the wall: its own front is no open floor."""
    shelf = toy.thing(30, "bookshelf_01", (0.2, 5.0, 0), room=101, fixed=True)
    found = floor_walked(LIVING, shelf)
    before = Point(0.62, 5.0)
    assert found.contains(before)
    assert not floor_walked(LIVING, shelf, traits={}).contains(before)
    # From the door at (2, 3.5) to the shelf: as wide as the rule says, halfway.
    middle, across = (1.4, 4.15), (0.72, 0.69)
    for share in (-0.9, 0.9):
        x, y = (m + share * WALKWAY_HALF_M * d for m, d in zip(middle, across, strict=True))
        assert walks_at(found, x, y, 0.01)


def test_a_way_goes_round_furniture_and_nobody_walks_under_it():
    """From the door the stove is behind the table."""
    table = toy.thing(77, "kitchen_table_01", (2.2, 1.4, 0), fixed=True)
    stove = toy.thing(11, "stove_01", (2.2, 0.3, 0), yaw=1.570796, fixed=True)
    found = floor_walked(KITCHEN, table, stove)
    assert not found.intersects(Point(2.2, 1.4).buffer(0.3))
    assert walks_at(found, 1.2, 1.6, 0.1) or walks_at(found, 3.2, 1.6, 0.1)
    # One piece: whoever walks gets everywhere.
    assert found.geom_type == "Polygon"


@pytest.mark.parametrize(("traits", "count"), [({"stove": ("HAS_SWITCH",)}, 1), ({}, 0)])
def test_what_is_used_follows_from_the_catalogue(traits, count):
    stove = toy.thing(11, "stove_01", (2.2, 0.3, 0), fixed=True)
    assert len(used(bodies_of([stove], toy.infos()), traits)) == count


def test_what_hangs_or_lies_flat_is_nothing_to_walk_up_to():
    hung = toy.thing(30, "bookshelf_01", (0.2, 5.0, 1.5), room=101, fixed=True)
    flat = toy.thing(31, "knife_01", (2.0, 5.0, 0), room=101, fixed=True)
    traits = {"bookshelf": ("SURFACES",), "knife": ("SURFACES",)}
    assert used(bodies_of([hung, flat], toy.infos()), traits) == []


def test_what_has_its_front_to_a_wall_is_got_at_from_beside():
    """As a chair at its table is: the floor nearest to it is no open floor."""
    away = toy.thing(11, "stove_01", (2.2, 0.3, 0), yaw=-1.570796, fixed=True)
    behind = Point(2.2, 0.8)
    assert floor_walked(KITCHEN, away).contains(behind)
    assert not floor_walked(KITCHEN, away, traits={}).contains(behind)


ROOM = box(0, 0, 6, 4)


@pytest.mark.parametrize(("gap", "passed"), [(0.3, False), (0.4, True), (0.9, True), (1.1, False)])
def test_a_gap_that_people_pass_one_by_one_is_no_place_to_put_things_aside(gap, passed):
    beside_wall = narrow(ROOM, [box(2, gap, 4, gap + 1)], [])
    assert beside_wall.contains(Point(3, gap / 2)) is passed
    pieces = [box(1.5, 1.5, 2.5, 2.5), box(2.5 + gap, 1.5, 3.5 + gap, 2.5)]
    assert narrow(ROOM, pieces, []).contains(Point(2.5 + gap / 2, 2)) is passed


def test_beside_a_lone_piece_and_along_walls_there_is_room_to_put_things_aside():
    found = narrow(ROOM, [box(2, 0, 4, 0.6)], [])
    assert found.is_empty


def test_where_people_sit_down_at_a_table_is_no_place_to_put_things_aside():
    table = box(2, 1.5, 4, 2.5)
    found = narrow(ROOM, [table], [table])
    assert found.contains(Point(3, 2.5 + SEATED_M - 0.05))
    assert not found.contains(Point(3, 2.5 + SEATED_M + 0.05))
    assert not narrow(ROOM, [table], []).contains(Point(3, 2.6))


def test_before_what_is_used_is_no_place_to_put_things_aside():
    """Over all its width: the way to it leads to its middle alone."""
    (stove,) = bodies_of(
        [toy.thing(10, "stove_01", (2.2, 2.0, 0), yaw=1.570796, fixed=True)], toy.infos()
    )
    width, depth = stove.info.extents_m[1], stove.info.extents_m[0]
    floor = front(stove)
    assert floor.area == pytest.approx(width * USED_FROM_M)
    for side in (-0.45, 0.0, 0.45):
        assert floor.contains(Point(2.2 + side * width, 2.0 + depth / 2 + 0.05))
        assert not floor.contains(Point(2.2 + side * width, 2.0 - depth / 2 - 0.05))
    assert narrow(ROOM, [], [], [floor]).contains(Point(2.2, 2.0 + depth / 2 + 0.3))
