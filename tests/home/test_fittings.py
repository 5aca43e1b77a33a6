"""Curtains, radiators, switches and sockets: each in its place, in nobody's way."""

from __future__ import annotations

import math
from itertools import count, product

import numpy as np
import pytest
import shapely
from sdgen.catalog.load import load_catalog
from sdgen.errors import InputError
from sdgen.facts import bodies_of, in_the_air
from sdgen.freespace import union
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.anchors import sides_of
from sdgen.home.clearances import sight_of
from sdgen.home.fittings import _hung, _lamp_places
from sdgen.home.layout import corners_of
from sdgen.home.room_try import free_parts
from sdgen.home.wall_sets import WallSets
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome, furnished_home, pick_home
from sdgen.scene import Room
from sdgen.seeding import lane
from sdgen.zones import doorway_blocked, swing_blocked, swing_sectors
from shapely.geometry import LineString, Point, Polygon

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
SUITES = {m.id: m.suite for name in LIBRARY.categories for m in LIBRARY.by_category(name)}
HUNG = ("curtain", "blind", "radiator", "light_switch", "power_socket")


@pytest.fixture(scope="module")
def homes() -> list[FurnishedHome]:
    models, options, out = SplitModels(LIBRARY, "test"), BuildOptions(seed=4), []
    for index in range(6):
        spec = pick_home(CATALOG, options, index).spec(CATALOG, lane(4, index, "plan"))
        made = furnished_home(spec, CATALOG, LIBRARY, models, count(1), lane(4, index, "furnish"))
        out += [made] if isinstance(made, FurnishedHome) else []
    assert len(out) > 3
    return out


def things(home, category):
    return [item for item in home.layout.items.values() if item.category == category]


def test_every_home_has_each_of_one_model_or_one_suite(homes):
    for category in HUNG:
        assert sum(len(things(home, category)) for home in homes) >= len(homes)
        for home in homes:
            assert len({SUITES[item.asset] or item.asset for item in things(home, category)}) <= 1


def test_they_hang_at_a_wall_of_their_room(homes):
    for home in homes:
        rooms = {room.id: Polygon(room.polygon_m) for room in home.context.home.rooms}
        for category in HUNG:
            for item in things(home, category):
                outline = rooms[item.room_id]
                x, y, z = item.pose.position_m
                assert outline.exterior.distance(Point(x, y)) < 0.1
                assert z > 0.1
                assert item.parts


def test_windows_have_one_thing_that_fits_them(homes):
    dressed = windows = 0
    for home in homes:
        hung = [*things(home, "curtain"), *things(home, "blind")]
        for window in home.context.home.openings:
            if window.kind != "window":
                continue
            at = [i for i in hung if math.dist(i.pose.position_m[:2], window.center_m[:2]) < 0.2]
            assert len(at) <= 1
            windows, dressed = windows + 1, dressed + len(at)
            for item in at:
                _, wide, tall = LIBRARY.info(item.asset).extents_m
                assert window.width_m - 0.05 <= wide <= window.width_m + 0.6
                above = item.pose.position_m[2] + tall - window.center_m[2] - window.height_m
                assert 0 < above < 0.1
                room = next(r for r in home.context.home.rooms if r.id == item.room_id)
                assert item.pose.position_m[2] + tall < room.height_m
    assert dressed > 0.7 * windows


def test_lamps_hug_the_ceilings(homes):
    lit = rooms = 0
    for home in homes:
        for room in home.context.home.rooms:
            found = [i for i in things(home, "ceiling_lamp") if i.room_id == room.id]
            assert len(found) <= 3
            rooms, lit = rooms + 1, lit + (len(found) > 0)
            outline = Polygon(room.polygon_m)
            for lamp in found:
                x, y, z = lamp.pose.position_m
                top = z + LIBRARY.info(lamp.asset).extents_m[2]
                assert room.height_m - 0.01 < top < room.height_m
                assert outline.exterior.distance(Point(x, y)) > 0.2
    assert lit == rooms


def test_light_goes_round_no_corner():
    """A room with an arm has a lamp there, too; a square one has one in its middle."""
    square = Room(
        id=1, name="r", type="living_room", polygon_m=((0, 0), (4, 0), (4, 4), (0, 4)), height_m=2.6
    )
    assert list(_lamp_places(square)) == [(2.0, 2.0)]
    corner = ((0, 0), (7, 0), (7, 2.5), (3, 2.5), (3, 8), (0, 8))
    places = list(_lamp_places(square.model_copy(update={"polygon_m": corner})))
    assert 2 <= len(places) <= 3
    outline = Polygon(corner)
    assert all(outline.contains(Point(place)) for place in places)
    dark = sum(
        not any(outline.buffer(0.05).covers(LineString([point, place])) for place in places)
        for point in product(np.arange(0.1, 7, 0.2), np.arange(0.1, 8, 0.2))
        if outline.contains(Point(point))
    )
    assert dark * 0.04 < 3.0


def test_curtains_and_radiators_are_at_windows(homes):
    for home in homes:
        windows = [o for o in home.context.home.openings if o.kind == "window"]
        for category in ("curtain", "radiator"):
            for item in things(home, category):
                x, y, z = item.pose.position_m
                at = min(windows, key=lambda o: math.dist((x, y), o.center_m[:2]))
                assert math.dist((x, y), at.center_m[:2]) < 0.2
                top = z + LIBRARY.info(item.asset).extents_m[2]
                sill, head = at.center_m[2], at.center_m[2] + at.height_m
                assert top > head if category == "curtain" else top < sill


def test_switches_are_at_hand_beside_doors(homes):
    for home in homes:
        doors = [o for o in home.context.home.openings if o.kind != "window"]
        for item in things(home, "light_switch"):
            x, y, z = item.pose.position_m
            near = min(math.dist((x, y), o.center_m[:2]) - o.width_m / 2 for o in doors)
            assert 0.1 < near < 0.4
            assert 0.9 < z < 1.2


def test_switches_are_on_the_side_of_the_latch(homes):
    """Nobody reaches behind an open leaf for the light."""
    seen = 0
    for home in homes:
        for opening in home.context.home.openings:
            door = home.layout.items[opening.object_id]
            joints = LIBRARY.info(door.asset).joints
            if opening.kind not in ("door", "front_door"):
                continue
            axis = "xy".index(opening.along)
            hinge = door.pose.matrix() @ (*joints[0].origin_m, 1.0)
            to_hinge = hinge[axis] - opening.center_m[axis]
            sweep = shapely.union_all(swing_sectors(bodies_of([door], LIBRARY.infos)))
            rooms = {r.id: Polygon(r.polygon_m) for r in home.context.home.rooms}
            for switch in things(home, "light_switch"):
                x, y, _ = switch.pose.position_m
                if math.dist((x, y), opening.center_m[:2]) > opening.width_m / 2 + 0.25:
                    continue
                if rooms[switch.room_id].intersection(sweep).area > 0.1:
                    seen += 1
                    assert to_hinge * (switch.pose.position_m[axis] - opening.center_m[axis]) < 0
    assert seen > len(homes)


def test_a_doormat_lies_inside_every_front_door(homes):
    for home in homes:
        (mat,) = things(home, "doormat")
        (door,) = (o for o in home.context.home.openings if o.kind == "front_door")
        rooms = {room.id: Polygon(room.polygon_m) for room in home.context.home.rooms}
        x, y, z = mat.pose.position_m
        assert mat.room_id in door.room_ids
        assert math.dist((x, y), door.center_m[:2]) < 0.5
        assert z == 0
        assert rooms[mat.room_id].contains(Point(x, y))
        # Neither in the way of the door, nor of anybody.
        bodies = bodies_of(list(home.layout.items.values()), LIBRARY.infos)
        assert not swing_blocked(bodies)
        assert not doorway_blocked(home.context.home, bodies)


def test_front_doors_swing_over_doormats():
    thickest = max(mat.extents_m[2] for mat in LIBRARY.by_category("doormat"))
    for door in LIBRARY.by_category("front_door"):
        assert LIBRARY.bounds(door.id)["door"][0][2] > thickest + 0.005


def test_nothing_hangs_where_a_door_swings(homes):
    for home in homes:
        hung = bodies_of(home.layout.items.values(), LIBRARY.infos)
        assert not swing_blocked(hung)


def test_sockets_are_beside_beds_and_desks(homes):
    near = 0
    for home in homes:
        for piece in (*things(home, "nightstand"), *things(home, "desk")):
            for socket in things(home, "power_socket"):
                apart = math.dist(piece.pose.position_m[:2], socket.pose.position_m[:2])
                near += apart < LIBRARY.info(piece.asset).extents_m[1] / 2 + 0.5
    assert near >= len(homes)


def test_nothing_hangs_beyond_the_end_of_its_wall():
    side = next(s for s in sides_of([(0, 0), (2, 0), (2, 3), (0, 3)]) if s.length_m == 2)
    (socket,) = [m for m in LIBRARY.by_category("power_socket") if m.id == "power_socket_01"]
    wide = socket.extents_m[1]
    for along, count_ in ((1.0, 1), (wide / 2 - 0.01, 0), (2 - wide / 2 + 0.01, 0), (2.2, 0)):
        assert len(list(_hung(socket, side, along, 0.3))) == count_


def test_nothing_hangs_in_the_air_of_a_doorway(homes):
    for home in homes:
        assert not list(in_the_air(home.facts))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("mine: {category: curtian, where: window}", "did you mean 'curtain'"),
        ("mine: {category: curtain, where: roof}", "fittings.yaml:1: mine.where"),
        ("mine: {category: curtain, where: window, rooms: [den]}", "den"),
        ("mine: {category: curtain, where: beside}", "missing key 'of'"),
        ("mine: {category: doormat, where: before_door}", "missing key 'of'"),
        ("mine: {category: doormat, where: before_door, of: desk}", "desk is no door"),
        ("mine: {category: curtain, where: window, of: desk}", "mine.of"),
        ("mine: {category: curtain, where: beside, of: dsek}", "did you mean 'desk'"),
        ("curtains: {category: curtain, where: window}", "is already defined"),
    ],
)
def test_mistakes_are_located(tmp_path, text, said):
    (tmp_path / "fittings.yaml").write_text(text)
    with pytest.raises(InputError) as caught:
        load_catalog([tmp_path])
    assert said in "\n".join(caught.value.problems)


def test_pictures_hang_over_the_middle_of_furniture_or_on_bare_walls_and_behind_nothing(homes):
    over = hung = 0
    for home in homes:
        doors = swing_sectors(bodies_of(list(home.layout.items.values()), LIBRARY.infos))
        for item in [*things(home, "picture_frame"), *things(home, "poster")]:
            room = next(r for r in home.context.home.rooms if r.id == item.room_id)
            assert (
                Polygon(room.polygon_m).exterior.distance(Point(*item.pose.position_m[:2])) < 0.05
            )
            low = item.pose.position_m[2]
            tall = LIBRARY.info(item.asset).extents_m[2]
            assert 1.0 < low < low + tall < room.height_m
            assert not any(s.contains(Point(*item.pose.position_m[:2])) for s in doors)
            hung += 1
            below = [i for i in home.layout.items.values() if i.category in ("sofa", "bed")]
            below = [i for i in below if i.room_id == room.id]
            over += any(
                math.dist(i.pose.position_m[:2], item.pose.position_m[:2]) < 1.3 for i in below
            )
    assert hung > 4 * len(homes)
    assert over > len(homes) / 2


def test_hardly_a_wall_of_rooms_one_lives_in_stays_bare(homes):
    bare = walls = 0
    fitting = next(f for f in CATALOG.fittings if f.name == "posters_elsewhere")
    for home in homes:
        for room in home.context.home.rooms:
            if room.type not in fitting.rooms:
                continue
            mine = [o for o in home.context.home.openings if room.id in o.room_ids]
            sets = WallSets(
                fitting,
                LIBRARY.by_category("poster"),
                room,
                home.layout,
                sides_of(room.polygon_m),
                [(o, sight_of(o)) for o in mine],
                union(swing_sectors(bodies_of(list(home.layout.items.values()), LIBRARY.infos))),
                lane(0, 0, "test"),
            )
            for side in sets.sides:
                walls += 1
                bare += bool(sets.bare_parts(side, 1.3, 1.9))
    assert walls > 40
    assert bare < 0.06 * walls


def test_no_print_hangs_twice_in_a_room(homes):
    for made in (*homes, *base_homes()):
        for room in made.context.home.rooms:
            items = [i for i in made.layout.items.values() if i.room_id == room.id]
            hung = [i.asset for i in items if i.category in ("picture_frame", "poster")]
            # "framed painting, landscape" and "poster, landscape" show the same.
            prints = [LIBRARY.info(asset).title.rpartition(", ")[2] for asset in hung]
            assert len(set(prints)) == len(prints), (room.type, prints)


def base_homes():
    """All that are drawn, where pictures are of drawings, too."""
    for number, spec in enumerate(CATALOG.homes):
        models, rng = SplitModels(LIBRARY, "train"), lane(4, number, "furnish")
        made = furnished_home(spec, CATALOG, LIBRARY, models, count(1), rng)
        assert isinstance(made, FurnishedHome), made
        yield made


def test_long_walls_have_something_at_the_height_of_eyes(homes):
    """On nearly every wall that is free of what is tall, of windows and of doors over 2.5 m."""
    hung = walls = 0
    for made in homes:
        for room in made.context.home.rooms:
            if room.type not in LIVED_IN:
                continue
            mine = [o for o in made.context.home.openings if room.id in o.room_ids]
            taken = [shapely.get_coordinates(sight_of(o).before) for o in mine]
            items = [i for i in made.layout.items.values() if i.room_id == room.id]
            tall = [i for i in items if i.pose.position_m[2] < 0.9 and top_of(i) > 1.3]
            taken += [outline(i) for i in tall]
            on_walls = [i for i in items if i.pose.position_m[2] >= 0.9 and top_of(i) > 1.4]
            for side in sides_of(room.polygon_m):
                for part in free_parts(side, taken, 0.45):
                    if part.length_m > 2.5:
                        spots = [part.measure(i.pose.position_m[:2]) for i in on_walls]
                        walls += 1
                        hung += any(0 < t < part.length_m and away < 0.3 for t, away in spots)
    assert walls >= 12
    assert hung >= 0.9 * walls


LIVED_IN = ("living_room", "bedroom", "child_room", "dining_room", "office", "hall")


def top_of(item):
    return item.pose.position_m[2] + LIBRARY.info(item.asset).extents_m[2]


def outline(item):
    x, y, _ = item.pose.position_m
    corners = corners_of(LIBRARY.info(item.asset), x, y, yaw_of(item.pose.quat_xyzw))
    return np.array(corners)
