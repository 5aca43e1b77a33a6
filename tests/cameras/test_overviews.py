"""Overviews are taken from corners and doorways along the room, and every room has one."""

import numpy as np
import pytest
from sdgen.cameras.judged import Inventory, judge
from sdgen.cameras.overviews import overviews
from sdgen.cameras.view import View
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.scene import Box, Opening, Scene
from sdgen.seeding import lane
from shapely.geometry import Point, box
from shapely.geometry.base import BaseGeometry

from tests.fakes import box_room, thing

TABLE, CABINET = thing(10, "table_01", (0.6, 0.3, 0)), thing(11, "cabinet_01", (2.5, 1.5, 0))
FURNITURE = {10: 1, 11: 1}


def taken(library: Library, scene: Scene, free: BaseGeometry, seed: int = 0) -> list[View]:
    inventory = Inventory.of(scene.home, FURNITURE, FURNITURE)
    with RayWorld(library, scene) as world:
        return overviews(scene.home, inventory, free, world.cast, lane(seed, 0, "views"))


def pitch_deg(view: View) -> float:
    return float(np.degrees(np.arcsin(view.world_from_camera[2, 2])))


def test_they_look_from_corners_along_the_room_nearly_level(library: Library) -> None:
    scene = box_room([TABLE, CABINET], size_m=(6.0, 4.0))
    free = box(-2.7, -1.7, 2.7, 1.7)
    places = set()
    for seed in range(6):
        views = taken(library, scene, free, seed)
        assert 0 < len(views) <= 4
        for view in views:
            x, y, z = view.eye_m.tolist()
            assert (view.kind, view.overview_of) == ("room", 1)
            assert free.contains(Point(x, y))
            assert 2.7 - abs(x) < 0.26 > 1.7 - abs(y)
            assert 1.2 <= z <= 1.4
            assert -10.0 < pitch_deg(view) < -3.0
            across = np.array([-np.sign(x) * 5.4, -np.sign(y) * 3.4])
            ahead = view.world_from_camera[:2, 2]
            assert across @ ahead > 0.75 * np.linalg.norm(across) * np.linalg.norm(ahead)
            assert 0.3 < view.worth <= 1.0
            places.add((x, y))
    assert len(places) > 6


def test_what_must_hold_holds_where_some_place_lets_it(library: Library) -> None:
    """Cubes hang before the lens in three of the four corners."""
    cubes = [
        thing(12 + k, "cube_01", (x, y, 1.2))
        for k, (x, y) in enumerate([(-1.2, -0.8), (1.2, -0.8), (-1.2, 0.8)])
    ]
    scene = box_room([TABLE, *cubes])
    inventory = Inventory.of(scene.home, dict.fromkeys(range(10, 16), 1), [10])
    free = box(-1.7, -1.7, 1.7, 1.7).difference(box(-1.1, -1.1, 1.1, 1.1))
    for seed in range(4):
        views = taken(library, scene, free, seed)
        with RayWorld(library, scene) as world:
            assert judge(views, inventory, world.cast).flaw.tolist() == [0.0] * len(views)


def test_a_room_too_small_has_the_least_bad_one_at_less_worth(library: Library) -> None:
    scene = box_room(size_m=(1.0, 1.0))
    (view,) = taken(library, scene, box(-0.2, -0.2, 0.2, 0.2))
    with RayWorld(library, scene) as world:
        (flaw,) = judge([view], Inventory.of(scene.home, {}, ()), world.cast).flaw
    assert flaw > 0.0
    assert view.worth < 0.5
    assert taken(library, scene, box(0, 0, 0, 0)) == []


@pytest.mark.parametrize("kind", ["door", "window"])
def test_they_look_in_from_doorways_too(library: Library, kind: str) -> None:
    """The wall open over a metre; through a window nobody comes."""
    whole = box_room([TABLE])
    sides = [Box(center_m=(s * 1.25, -2.05, 1.25), size_m=(1.5, 0.1, 2.5)) for s in (-1, 1)]
    shell = [
        one.model_copy(update={"pieces": tuple(sides)}) if one.id == 7 else one
        for one in whole.home.structures
    ]
    opening = Opening(
        object_id=30,
        kind=kind,
        room_ids=(1, 9),
        center_m=(0.0, -2.06, 0.0),
        along="x",
        width_m=1.0,
        height_m=2.1,
    )
    home = whole.home.model_copy(update={"structures": tuple(shell), "openings": (opening,)})
    scene = whole.model_copy(update={"home": home})
    free = box(-0.2, -2.35, 0.21, -1.75)
    views = [view for seed in range(6) for view in taken(library, scene, free, seed)]
    in_the_middle = [view for view in views if abs(view.eye_m[0]) < 1e-9]
    assert bool(in_the_middle) == (kind == "door")
    for view in views:
        assert view.eye_m[1] > -2.0
        assert view.world_from_camera[1, 2] > 0.5


def test_they_follow_from_the_home_and_the_draw(library: Library) -> None:
    scene, free = box_room([TABLE, CABINET], size_m=(6.0, 4.0)), box(-2.7, -1.7, 2.7, 1.7)
    first, again, other = (
        [view.world_from_camera.tolist() for view in taken(library, scene, free, seed)]
        for seed in (1, 1, 2)
    )
    assert first == again != other
