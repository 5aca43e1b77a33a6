"""Rugs under the pieces of a group: as a whole under what can be shifted, off what cannot."""

from dataclasses import replace

import shapely
from sdgen.catalog.load import load_catalog
from sdgen.geometry import quat_from_yaw
from sdgen.home.layout import Layout, corners_of
from sdgen.home.room_try import RoomTry, empty_room
from sdgen.home.rugs import APART_M, SEEN_SHARE, lying
from sdgen.library import load_library
from sdgen.scene import Home, ObjectInstance, Pose, Room
from sdgen.seeding import lane

CATALOG, LIBRARY = load_catalog(), load_library()
LARGE, SMALL, MAT = (LIBRARY.info(name) for name in ("rug_15", "rug_01", "bath_mat_01"))


def room_with(*pieces: tuple[str, float, float, float]) -> RoomTry:
    """A room of 5 x 6 m, its corner at (0, 0), with these models (id, x, y, yaw) in it."""
    outline = ((0.0, 0.0), (5.0, 0.0), (5.0, 6.0), (0.0, 6.0))
    room = Room(id=1, name="room", type="living_room", polygon_m=outline, height_m=2.5)
    home = Home(id="one", kind="procedural", rooms=(room,), openings=(), structures=())
    layout = Layout(LIBRARY, iter(range(100, 200)))
    tried = empty_room(home, room, layout, CATALOG, LIBRARY.by_category, lane(0, 0, "rugs"))
    for number, (model, x, y, yaw) in enumerate(pieces, 10):
        asset = LIBRARY.info(model)
        item = ObjectInstance(
            id=number,
            category=asset.category,
            asset=model,
            pose=Pose(position_m=(x, y, 0.0), quat_xyzw=quat_from_yaw(yaw)),
            room_id=1,
            fixed=True,
        )
        tried.layout.put(item)
        shape = shapely.polygons(corners_of(asset, x, y, yaw))
        tried = replace(tried, prints={**tried.prints, number: shape})
        tried = replace(tried, placed={**tried.placed, asset.category: (number,)})
    return tried


def outlines(asset, poses):
    return [shapely.polygons(corners_of(asset, x, y, yaw)) for x, y, _, yaw in poses]


def test_a_rug_lies_under_the_middle_of_its_table_where_nothing_keeps_it_off():
    tried = room_with(("coffee_table_02", 2.5, 3.0, 0.0))
    x, y, z, _ = lying(LARGE, 10, 0.0, tried)[0]
    assert (round(x, 3), round(y, 3), z) == (2.5, 3.0, 0.0)


def test_a_rug_keeps_off_shelves_and_is_not_hidden_by_a_bed():
    tried = room_with(("bed_01", 1.2, 3.0, 0.0), ("bookshelf_01", 4.8, 3.0, 3.14159))
    found = outlines(SMALL, lying(SMALL, 10, 0.8, tried))
    assert found
    bed, shelf = tried.prints[10], tried.prints[11]
    for rug in found:
        assert not rug.intersects(shelf.buffer(-0.02))
        assert rug.difference(bed).area > SEEN_SHARE * rug.area
        assert tried.outline.contains(rug)


def test_no_chair_stands_half_on_a_rug():
    tried = room_with(("dining_table_01", 2.5, 3.0, 0.0), ("chair_01", 4.0, 3.0, 3.14159))
    chair = tried.prints[11]
    found = outlines(LARGE, lying(LARGE, 10, 0.0, tried))
    on = [rug.intersection(chair).area / chair.area for rug in found]
    assert any(share > 0.99 for share in on)
    assert all(share > 0.99 or share < 0.4 for share in on)


def test_a_rug_too_large_for_the_room_lies_nowhere():
    walls = [("bookshelf_01", 0.8 * k + 0.6, 4.3, 0.0) for k in range(5)]
    assert lying(LARGE, 10, 0.0, room_with(("coffee_table_02", 2.5, 3.6, 0.0), *walls)) == []


def test_two_large_rugs_keep_apart_and_mats_need_not():
    tried = room_with(("rug_01", 1.6, 2.0, 0.0))
    lies = shapely.polygons(corners_of(SMALL, 1.6, 2.0, 0.0))
    rugs, mats = (outlines(asset, lying(asset, None, 0.0, tried)) for asset in (SMALL, MAT))
    assert rugs
    assert min(rug.distance(lies) for rug in rugs) > APART_M
    assert min(mat.distance(lies) for mat in mats) < APART_M
