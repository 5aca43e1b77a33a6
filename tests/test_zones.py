"""Zones follow from home and furniture; a door's sweep covers its leaf wherever it stands."""

import itertools

import numpy as np
import pytest
from sdgen.catalog.load import load_catalog
from sdgen.facts import bodies_of
from sdgen.geometry import apply, quat_from_yaw
from sdgen.hazards.splits import SplitModels
from sdgen.library.states import object_from_part
from sdgen.pipeline.furnished import FurnishedHome, furnished_home
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import lane
from sdgen.zones import swing_blocked, swing_sectors
from shapely.geometry import MultiPoint, Point, Polygon

from tests.shipped import shipped_library

LIBRARY = shipped_library()


def door(asset, x=0.0, y=0.0, yaw=0.0):
    return ObjectInstance(
        id=1,
        category=asset.category,
        asset=asset.id,
        pose=Pose(position_m=(x, y, 0), quat_xyzw=quat_from_yaw(yaw)),
        room_id=2,
    )


@pytest.mark.parametrize(
    "asset", [*LIBRARY.by_category("door"), *LIBRARY.by_category("front_door")], ids=lambda a: a.id
)
def test_the_sweep_covers_the_leaf_from_shut_to_open(asset):
    (sector,) = swing_sectors(bodies_of([door(asset)], LIBRARY.infos))
    (joint,) = asset.joints
    leaf = next(part.name for part in asset.parts if part.joint == joint.name)
    vertices = LIBRARY.mesh(asset.id)[leaf].vertices
    for value in np.linspace(0.3, 1.4, 6):
        moved = apply(object_from_part(asset, leaf, {joint.name: float(value)}), vertices)
        shape = MultiPoint(moved[:, :2]).convex_hull
        assert shape.difference(sector.buffer(0.1)).area < 0.02 * shape.area
    assert sector.contains(Point(0.3, 0))  # it opens towards +X


def test_a_box_in_the_sweep_is_named_and_one_beside_it_is_not():
    asset = LIBRARY.by_category("door")[0]
    box = LIBRARY.by_category("cardboard_box")[0]

    def placed(number, x, y, z=0.0):
        pose = Pose(position_m=(x, y, z), quat_xyzw=quat_from_yaw(0))
        return ObjectInstance(id=number, category=box.category, asset=box.id, pose=pose, room_id=2)

    things = [door(asset), placed(7, 0.5, 0), placed(8, 2.0, 0), placed(9, 0.5, 0, z=1.5)]
    assert swing_blocked(bodies_of(things, LIBRARY.infos)) == (7,)


def test_a_staged_home_has_the_zones_its_doors_and_appliances_need():
    catalog = load_catalog()
    base = catalog.homes[0]
    stage = next(
        found
        for attempt in range(5)
        if isinstance(
            found := furnished_home(
                base,
                catalog,
                LIBRARY,
                SplitModels(LIBRARY, "train"),
                itertools.count(1),
                lane(0, attempt, "stage"),
            ),
            FurnishedHome,
        )
    )
    home, zones = stage.context.home, stage.context.zones
    doors = [o for o in home.openings if o.kind != "window"]
    for opening in doors:
        kinds = [z.kind for z in zones if z.source_id == opening.object_id]
        assert kinds.count("doorway") == len(opening.room_ids)
        assert kinds.count("swing") == 1
    stove = next(i for i in stage.layout.items.values() if i.category == "stove")
    (heat,) = [z for z in zones if z.kind == "heat" and z.source_id == stove.id]
    assert Polygon(heat.polygon_m).contains(Point(stove.pose.position_m[:2]))
    walkways = {z.room_id for z in zones if z.kind == "walkway"}
    assert walkways == {room.id for room in home.rooms}
    assert len({z.name for z in zones}) == len(zones)
    outlines = {room.id: Polygon(room.polygon_m).buffer(0.07) for room in home.rooms}
    assert all(
        outlines[z.room_id].contains(Polygon(z.polygon_m)) for z in zones if z.kind != "swing"
    )
