"""Undoing a scene: what stands in a drawer travels with it, what stands elsewhere stays."""

import math

import pytest
from sdgen.actions import settled_states
from sdgen.catalog.load import load_catalog
from sdgen.facts import Facts, unheld
from sdgen.geometry import quat_from_yaw, round_quat
from sdgen.hazards.twin import undone
from sdgen.scene import Anomaly, ObjectInstance, Pose

from tests.fakes import box_room
from tests.shipped import shipped_library

#: A drawer below (``freezer_door``) and shelves behind doors above.
FRIDGE = "fridge_07"
OPEN_M = 0.2256


def item(number, asset, position_m, yaw=0.0, **more):
    info = shipped_library().info(asset)
    pose = Pose(position_m=position_m, quat_xyzw=round_quat(quat_from_yaw(yaw)))
    joints = {joint.name: 0.0 for joint in info.joints} | more.pop("joints", {})
    made = ObjectInstance(
        id=number, category=info.category, asset=asset, pose=pose, room_id=1, joints=joints, **more
    )
    return settled_states(made, info)


def drawer_scene(yaw=0.0, opened=OPEN_M):
    """An open drawer with a plate, an apple on that and milk; milk on a shelf and on top."""
    c, s = math.cos(yaw), math.sin(yaw)

    def inside(number, asset, x, y, z):
        return item(number, asset, (c * x - s * y, s * x + c * y, z), yaw)

    plate = shipped_library().info("plate_01")
    top = plate.supports[0].z_m if plate.supports else plate.extents_m[2]
    return box_room(
        [
            item(10, FRIDGE, (0, 0, 0), yaw, fixed=True, joints={"freezer_door": opened}),
            inside(20, "milk_carton_04", opened, 0.25, 0.128),
            inside(21, "plate_01", opened, -0.1, 0.128),
            inside(22, "apple_01", opened, -0.1, 0.128 + top),
            inside(23, "milk_carton_04", -0.1, 0.0, 0.666),
            inside(24, "milk_carton_04", -0.1, 0.0, 1.78),
        ]
    )


def anomaly(object_id, category, hazard="fridge_open"):
    return Anomaly.model_construct(hazard=hazard, object_id=object_id, category=category)


@pytest.mark.parametrize("yaw", [0.0, -math.pi / 2])
def test_what_stands_in_a_drawer_travels_with_it(yaw):
    infos, scene = shipped_library().infos, drawer_scene(yaw)
    twin = undone(scene, [anomaly(10, "fridge")], load_catalog(), infos)
    assert twin.object(10).joints["freezer_door"] == 0.0
    back = (-OPEN_M * math.cos(yaw), -OPEN_M * math.sin(yaw), 0.0)
    for key in (20, 21, 22):
        old, new = scene.object(key), twin.object(key)
        moved = [b - a for a, b in zip(old.pose.position_m, new.pose.position_m, strict=True)]
        assert moved == pytest.approx(back, abs=2e-5)
        assert new.pose.quat_xyzw == pytest.approx(old.pose.quat_xyzw, abs=2e-6)
        assert new.model_copy(update={"pose": old.pose}) == old
    assert [twin.object(k) for k in (23, 24)] == [scene.object(k) for k in (23, 24)]
    assert list(unheld(Facts(twin, infos))) == []
    # A function of what is written: the scene's facts at hand change nothing.
    known = Facts(scene, infos)
    assert undone(scene, [anomaly(10, "fridge")], load_catalog(), infos, known) == twin


def test_what_is_only_switched_off_takes_nothing_along():
    scene = drawer_scene(opened=0.0)
    twin = undone(scene, [anomaly(10, "fridge")], load_catalog(), shipped_library().infos)
    assert twin.objects == scene.objects


def test_a_placed_anomaly_in_the_drawer_goes():
    both = [anomaly(10, "fridge"), anomaly(22, "apple", "spill")]
    twin = undone(drawer_scene(), both, load_catalog(), shipped_library().infos)
    assert [thing.id for thing in twin.objects] == [10, 20, 21, 23, 24]
