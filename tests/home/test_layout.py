"""Spots lie within supports, under headroom and clear of what is there already."""

import itertools
import math

import pytest
from sdgen.actions import at_rest, in_state
from sdgen.facts import Body
from sdgen.geometry import quat_from_yaw, yaw_of
from sdgen.home.ground import Ground
from sdgen.home.layout import Intent, Layout, at_spot, corners_of
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import lane
from shapely.geometry import LineString, Polygon, box

from tests.shipped import shipped_library

LIBRARY = shipped_library()


@pytest.fixture
def layout():
    return Layout(LIBRARY, itertools.count(1))


def put(layout, category, x=0.0, y=0.0, z=0.0, yaw=0.0):
    asset = LIBRARY.by_category(category)[0]
    item = ObjectInstance(
        id=next(layout.ids),
        category=category,
        asset=asset.id,
        pose=Pose(position_m=(x, y, z), quat_xyzw=quat_from_yaw(yaw)),
        room_id=1,
        fixed=True,
    )
    layout.put(at_rest(item, asset))
    return item.id


def test_things_on_a_table_do_not_overlap_and_stay_on_it(layout):
    table = put(layout, "coffee_table", 1, 2, yaw=0.6)
    top = layout.info(table)
    surface = Polygon(corners_of(top, 1, 2, 0.6))
    rng = lane(0, 0, "layout")
    mug = LIBRARY.by_category("mug")[0]
    placed = []
    for _ in range(12):
        spot = layout.spot_on_object(mug, table, "ON", rng)
        if spot is None:
            continue
        item = layout.new_item(mug, spot, 1)
        layout.put(item, Intent("ON", table))
        print_ = Polygon(corners_of(mug, item.pose.position_m[0], item.pose.position_m[1], spot[1]))
        assert surface.contains(print_)
        z = item.pose.position_m[2]  # the table may have a lower shelf
        assert not any(print_.intersects(other) for other, height in placed if height == z)
        placed.append((print_, z))
    assert len(placed) >= 4


def test_inside_a_fridge_headroom_is_kept(layout):
    fridge = put(layout, "fridge")
    info = layout.info(fridge)
    rng = lane(0, 1, "layout")
    milk = LIBRARY.by_category("milk_carton")[0]
    for _ in range(10):
        spot = layout.spot_on_object(milk, fridge, "INSIDE", rng)
        if spot is None:
            continue
        z = spot[0][2]
        (shelf,) = [s for s in info.supports if s.container and abs(s.z_m - z) < 1e-6]
        assert shelf.headroom_m is None or milk.extents_m[2] < shelf.headroom_m
        layout.put(layout.new_item(milk, spot, 1), Intent("INSIDE", fridge))
    assert layout.spot_on_object(LIBRARY.by_category("wardrobe")[0], fridge, "INSIDE", rng) is None


def test_an_open_door_takes_room(layout):
    fridge = put(layout, "fridge")
    shut = layout.blocks_of(layout.items[fridge])
    opened = in_state(layout.items[fridge], layout.info(fridge), "OPEN", lane(0, 2, "layout"))
    assert opened is not None
    blocks = layout.blocks_of(opened)
    assert len(shut) == 1
    assert len(blocks) == 2
    assert blocks[1].shape.bounds[2] > shut[0].shape.bounds[2]


def test_floor_spots_keep_to_their_area(layout):
    put(layout, "coffee_table", 1, 1)
    area, avoid = box(0, 0, 3, 3), box(0, 0, 1.5, 3)
    outline = box(0.5, -1, 2.5, 4)
    ground = Ground(outline, area, keep_share=0.7, avoid=avoid)
    ball = LIBRARY.by_category("toy_ball")[0]
    rng = lane(0, 3, "layout")
    for _ in range(20):
        spot = layout.spot_on_floor(ball, ground, rng)
        if spot is not None:
            print_ = Polygon(corners_of(ball, spot[0][0], spot[0][1], spot[1]))
            assert outline.covers(print_)
            assert print_.intersection(area).area >= 0.7 * print_.area
            assert print_.intersection(avoid).area <= 0.2 * print_.area + 1e-9


def test_floor_spots_touch_nothing_of_what_they_must_keep_off(layout):
    area, off = box(0, 0, 3, 3), box(0, 0, 1.5, 3)
    crate = LIBRARY.by_category("cardboard_box")[0]
    rng = lane(0, 3, "layout")
    ground = Ground(area, area, off=off)
    spots = [layout.spot_on_floor(crate, ground, rng) for _ in range(20)]
    found = [spot for spot in spots if spot is not None]
    assert found
    for (x, y, _), yaw in found:
        assert not Polygon(corners_of(crate, x, y, yaw)).intersects(off)


def test_on_a_flat_woven_rug_the_floor_is_so_much_higher_and_nothing_lies_over_its_edge(layout):
    rug = put(layout, "rug")
    thick_m = layout.info(rug).extents_m[2]
    lies = Polygon(corners_of(layout.info(rug), 0.0, 0.0, 0.0))
    room, rng = box(-2, -2, 2, 2), lane(0, 4, "layout")
    book = LIBRARY.by_category("book")[0]
    found = [layout.spot_on_floor(book, Ground(room, room), rng) for _ in range(60)]
    heights = []
    for (x, y, z), yaw in (spot for spot in found if spot is not None):
        print_ = Polygon(corners_of(book, x, y, yaw))
        assert lies.covers(print_) if z else not lies.intersects(print_)
        heights.append(z)
    assert sorted(set(heights)) == [0.0, thick_m]


def test_nothing_is_put_on_a_thick_rug_nor_on_what_lies_on_a_flat_one(layout):
    room, rng = box(-2, -2, 2, 2), lane(0, 5, "layout")
    book = LIBRARY.by_category("book")[0]
    put(layout, "bath_mat")
    rug = put(layout, "rug", 1.0, 0.0)
    for _ in range(40):
        spot = layout.spot_on_floor(book, Ground(room, room), rng)
        if spot is not None:
            layout.put(layout.new_item(book, spot, 1))
    lying = [item for item in layout.items.values() if item.category == "book"]
    prints = [
        Polygon(corners_of(book, *i.pose.position_m[:2], yaw_of(i.pose.quat_xyzw))) for i in lying
    ]
    assert len(prints) > 5
    for one, other in itertools.combinations(prints, 2):
        assert not one.intersects(other)
    mat = layout.space_of(rug - 1)[0].shape
    assert not any(mat.intersects(print_) for print_ in prints)


def test_a_dropped_thing_leaves_no_trace(layout):
    table = put(layout, "coffee_table")
    before = dict(layout.items)
    copy = layout.copy()
    copy.drop(table)
    assert layout.items == before
    assert copy.items == {}


def test_what_is_looked_at_faces_the_way_its_support_does():
    front = 0.7
    layout = Layout(LIBRARY, itertools.count(1), frozenset({"photo_frame"}))
    dresser = put(layout, "dresser", yaw=front)
    rng = lane(0, 5, "layout")
    turned = {"photo_frame": [], "mug": []}
    for category, seen in turned.items():
        for _ in range(60):
            spot = layout.spot_on_object(LIBRARY.by_category(category)[0], dresser, "ON", rng)
            if spot is not None:
                seen.append(math.cos(spot[1] - front))
                if category == "photo_frame":
                    (x, y, _), yaw = spot
                    left = math.cos(front) * y - math.sin(front) * x
                    assert math.sin(yaw - front) * left <= 0.0, "turned to the dresser's middle"
    assert min(turned["photo_frame"]) > 0.5
    assert len(set(turned["photo_frame"])) > 10, "not all alike"
    assert min(turned["mug"]) < -0.5
    assert layout.copy().fronted == layout.fronted


def test_what_is_looked_at_on_the_floor_faces_no_wall():
    layout = Layout(LIBRARY, itertools.count(1), frozenset({"laptop"}))
    room, rng = box(0, 0, 4, 3), lane(0, 6, "layout")
    for category, faces_in in (("laptop", True), ("backpack", False)):
        asset, before = LIBRARY.by_category(category)[0], []
        for _ in range(60):
            spot = layout.spot_on_floor(asset, Ground(room, room), rng)
            (x, y, _), yaw = spot
            ray = LineString([(x, y), (x + 9 * math.cos(yaw), y + 9 * math.sin(yaw))])
            before.append(ray.intersection(room).length)
        assert (min(before) > 0.6) == faces_in, category


@pytest.mark.parametrize("on_floor", [False, True])
def test_shards_lie_on_what_they_are_put_on_every_one_of_them(layout, on_floor):
    """What a broken thing covers is not what the whole one did."""
    table = put(layout, "coffee_table", 1, 2, yaw=0.6)
    info, rng, floor = layout.info(table), lane(0, 0, "shards"), box(-2, -2, 0.4, 0.4)
    surfaces = [s.outline for s in Body(layout.items[table], info).surfaces]
    found = 0
    for asset in LIBRARY.by_category("wine_glass"):
        thing = in_state(layout.new_thing(asset), asset, "BROKEN", rng)
        bulk = layout.bulk_of(thing)
        for _ in range(8):
            if on_floor:
                spot = layout.spot_on_floor(asset, Ground(floor, floor), rng, bulk)
            else:
                spot = layout.spot_on_object(asset, table, "ON", rng, bulk=bulk)
            if spot is None:
                continue
            found += 1
            body = Body(at_spot(thing, spot, 1), LIBRARY.info(asset.id))
            for shard in body.pieces:
                carriers = [floor] if on_floor else surfaces
                assert max(s.intersection(shard).area for s in carriers) >= 0.9 * shard.area
    assert found >= 10
