"""What can be seen through doorways: nothing that is seen is missing."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
from sdgen.agent.eyes import Eyes
from sdgen.agent.house import House
from sdgen.agent.walk import Floor
from sdgen.cameras.lens import Gaze, Lens, camera_at, toward
from sdgen.cameras.portals import Portals, arc_of
from sdgen.freespace import random_point
from sdgen.render.process import process_renderer
from sdgen.seeding import lane

from tests.agent import homes
from tests.agent.conftest import no_renderer_is_left as no_renderer_is_left
from tests.shipped import shipped_library

LENS = Lens(width=96, height=96)


def test_masks_are_those_of_the_whole_home() -> None:
    """Drawn with only what can be seen, each pixel is of the same thing at the same depth."""
    with Eyes(shipped_library(), process_renderer(), whole_home=True) as whole:
        for home in range(2):
            scene = homes.stage(home).scene
            floor, rng = Floor(scene), lane(home, 0, "poses")
            gazes = []
            for _ in range(25):
                gaze = floor.random(rng)
                assert gaze is not None
                gazes.append(gaze._replace(pitch_rad=float(rng.uniform(-0.9, 0.6))))
            looks = []
            for eyes in (whole, homes.eyes()):
                eyes.show(scene)
                looks.append([eyes.look(g, floor.room_at(g.point), LENS) for g in gazes])
            for one, other in zip(*looks, strict=True):
                assert (one.instance == other.instance).all()
                assert (one.depth_mm == other.depth_mm).all()
                assert (one.rgb != other.rgb).mean() < 0.02


def test_a_camera_sees_less_than_one_that_turns() -> None:
    scene = homes.stage().scene
    portals, floor, rng = Portals(scene.home), Floor(scene), lane(3, 0, "poses")
    for _ in range(50):
        gaze = floor.random(rng)
        assert gaze is not None
        here = floor.room_at(gaze.point)
        around = portals.rooms_around(gaze.point)
        seen = portals.rooms(camera_at(gaze, here, LENS))
        assert here in seen
        assert seen <= around <= {room.id for room in scene.home.rooms}


def test_nothing_is_seen_through_a_shut_door() -> None:
    """Shut, a room with one door is seen alone, and its pictures are those of the whole home."""
    library, scene = shipped_library(), homes.stage().scene
    ways = [one for one in scene.home.openings if len(one.room_ids) == 2]
    count = Counter(room for one in ways for room in one.room_ids)
    door = next(o for o in ways if o.kind == "door" and 1 in (count[k] for k in o.room_ids))
    here, beyond = sorted(door.room_ids, key=lambda room: count[room])
    floor, rng = Floor(scene), lane(5, 0, "poses")
    point = random_point(floor.main.intersection(floor.outline_of(here)), rng)
    assert point is not None
    house = House(scene, library)
    assert house.moved(door.object_id, False, point) is None

    assert beyond in Portals(scene.home).rooms_around(point)
    assert Portals(scene.home, {door.object_id}).rooms_around(point) == {here}
    gazes = []
    for _ in range(20):
        end = random_point(house.floor.main.intersection(floor.outline_of(here)), rng)
        assert end is not None
        yaw, pitch = toward(np.array([*end, LENS.height_m]), np.array(door.center_m))
        gazes.append(Gaze(*end, yaw + float(rng.normal(0, 0.3)), pitch / 2))
    with Eyes(library, process_renderer(), whole_home=True) as whole:
        looks = []
        for eyes in (whole, homes.eyes()):
            eyes.show(house.scene)
            looks.append([eyes.look(gaze, here, LENS) for gaze in gazes])
    for one, other in zip(*looks, strict=True):
        assert (one.instance == other.instance).all()
        assert (one.depth_mm == other.depth_mm).all()


def test_an_arc_is_the_field_of_view_and_wider_when_looking_down() -> None:
    level = arc_of(camera_at(Gaze(0.0, 0.0, 1.0), 1, LENS))
    assert math.isclose(level[0], 1.0)
    assert math.isclose(level[1], math.pi / 4, abs_tol=1e-6)
    down = arc_of(camera_at(Gaze(0.0, 0.0, 1.0, -0.6), 1, LENS))
    assert level[1] < down[1] < math.pi
    assert arc_of(camera_at(Gaze(0.0, 0.0, 1.0, -1.2), 1, LENS))[1] == math.pi
