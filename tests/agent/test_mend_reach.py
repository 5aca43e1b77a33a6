"""Where an agent stands to get at things, and which leaf is meant, in the toy home."""

from __future__ import annotations

import math

import pytest
from sdgen.agent.mend.leaves import is_open, leaves_of, meant
from sdgen.agent.mend.reach import REACH_M, Arms
from sdgen.cameras.lens import Gaze
from sdgen.facts import bodies_of
from shapely.geometry import box

from tests import toy

SCENE = toy.scene(3)
ARMS = Arms(SCENE)
START = ARMS.start(SCENE)
BODIES = {body.item.id: body for body in bodies_of(SCENE.objects, toy.infos())}


@pytest.mark.parametrize("key", sorted(BODIES))
def test_one_stands_near_a_thing_and_looks_at_it(key: int) -> None:
    body = BODIES[key]
    there = ARMS.beside(START, body.footprint, body.item.room_id, key)
    assert there is not None
    assert ARMS.floor.holds(there.point)
    assert ARMS.reaches(there.point, body.footprint, key)
    x, y = body.footprint.centroid.x - there.x_m, body.footprint.centroid.y - there.y_m
    assert math.cos(math.atan2(y, x) - there.yaw_rad) > 0.5
    way_m = ARMS.way_m(START, there)
    assert way_m is not None
    assert way_m >= math.dist(START.point, there.point) - 1e-9


def test_reach_ends_at_an_arm_and_at_walls() -> None:
    crumb = box(2.0, 2.0, 2.01, 2.01)
    assert ARMS.reaches((2.0, 2.0 - REACH_M + 0.01), crumb)
    assert not ARMS.reaches((2.0, 2.0 - REACH_M - 0.01), crumb)
    home = SCENE.home
    pieces = tuple(
        one.model_copy(update={"center_m": (2.0, 3.05, 1.25), "size_m": (4.0, 0.1, 2.5)})
        for one in home.structures[0].pieces
    )
    between = home.structures[0].model_copy(update={"category": "wall", "pieces": pieces})
    walled = home.model_copy(update={"structures": (*home.structures, between)})
    arms = Arms(SCENE.model_copy(update={"home": walled}))
    near = box(1.0, 3.2, 1.01, 3.21)
    assert ARMS.reaches((1.0, 2.7), near)
    assert not arms.reaches((1.0, 2.7), near)
    # A door is got at from both of its rooms.
    assert arms.reaches((2.0, 2.7), BODIES[42].footprint, 42)
    assert arms.reaches((2.0, 3.4), BODIES[42].footprint, 42)


def test_a_start_in_a_pocket_is_moved_to_the_floor_that_ways_are_on() -> None:
    pocket = ((3.0, 2.0), (3.2, 2.0), (3.2, 2.2), (3.0, 2.2))
    hall = ((0.5, 0.5), (2.0, 0.5), (2.0, 2.5), (0.5, 2.5))
    start = SCENE.agent_start.model_copy(update={"position_m": (3.1, 2.1, 0.0)})
    scene = SCENE.model_copy(update={"free_space": (hall, pocket), "agent_start": start})
    arms = Arms(scene)
    assert arms.start(scene) == Gaze(2.0, 2.1, start.yaw_rad)
    assert arms.beside(arms.start(scene), box(3.6, 2.1, 3.7, 2.2), 100) is None
    assert arms.into_room(arms.start(scene), 101) is None


def test_which_leaf_is_meant() -> None:
    fridge, info = BODIES[305].item, BODIES[305].info
    assert leaves_of(info) == ("door",)
    assert meant(fridge, info, None) == meant(fridge, info, "inside") == ("door",)
    assert "(there is: door, inside)" in str(meant(fridge, info, "freezer"))
    assert not is_open(fridge, info, "door")
    assert is_open(fridge.model_copy(update={"joints": {"door": 1.0}}), info, "door")
    # Neither shut nor open: nothing is got out of it.
    assert not is_open(fridge.model_copy(update={"joints": {"door": 0.3}}), info, "door")
    assert is_open(fridge, info, None)
    table = BODIES[77]
    assert "has nothing that opens or shuts" in str(meant(table.item, table.info, None))
