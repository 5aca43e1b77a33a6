"""What rays tell of the outdoors through an opening."""

from dataclasses import replace

import numpy as np
import pytest
from sdgen.cameras.choice import Marked, shows
from sdgen.cameras.cover import states_shown
from sdgen.cameras.outdoors import FINE, ROUGH, Rays, in_strips, looks_out, outer_opening, passes
from sdgen.cameras.spots import SetTo
from sdgen.cameras.view import View
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.scene import ObjectInstance, Opening, Scene

from tests.fakes import box_room, thing

NORTH = 6
#: In the north wall of the box room, which the test scenes lack: nothing is beside it, too.
DOORWAY = Opening(
    object_id=10,
    kind="front_door",
    room_ids=(1,),
    center_m=(0.0, 2.0, 0.0),
    along="x",
    width_m=1.0,
    height_m=2.0,
)
VIEW = View("near", np.array([0.0, -1.0, 1.0]), np.array([0.0, 2.0, 1.0]))
TABLE = thing(10, "table_01", (0.0, 2.0, 0.0))
#: 1 m is so many pixels, 3 m away: 640 across 70 degrees.
PER_M = 320 / np.tan(np.radians(35)) / 3


def doorway_with(*things: ObjectInstance, rooms: tuple[int, ...] = (1,)) -> Scene:
    """The room with a doorway and what stands in it."""
    scene = box_room(things)
    shell = tuple(one for one in scene.home.structures if one.id != NORTH)
    opening = DOORWAY.model_copy(update={"room_ids": rooms})
    home = scene.home.model_copy(update={"structures": shell, "openings": (opening,)})
    return scene.model_copy(update={"home": home})


@pytest.mark.parametrize("along", ["x", "y"])
def test_rays_pass_through_an_opening_within_its_sides_and_ahead(along: str) -> None:
    """At the opening's plane, 3 m away: within, beside, above and below; then the other way."""
    opening = DOORWAY.model_copy(update={"center_m": (0.0, 2.0, 0.5)})
    directions = np.array([(0.4, 3, 1), (-0.6, 3, 1), (0, 3, 1.6), (0, 3, -0.6), (0, -3, 0)])
    eye = np.array([0.0, -1.0, 1.0])
    if along == "y":
        opening = opening.model_copy(update={"along": "y", "center_m": (2.0, 0.0, 0.5)})
        directions, eye = directions[:, [1, 0, 2]], eye[[1, 0, 2]]
    found = [True, False, False, False, False]
    assert passes(opening, eye, directions).tolist() == found
    assert passes(opening, np.repeat(eye[None], 5, axis=0), 0.1 * directions).tolist() == found


@pytest.mark.parametrize("rays", [ROUGH, FINE])
def test_rays_count_the_outdoors_within_the_opening_as_pictures_would(
    library: Library, rays: Rays
) -> None:
    """A tower of cubes, 0.2 m wide, shuts a fifth of the doorway."""
    tower = [thing(10 + k, "cube_01", (0.3, 2.0, 0.2 * k)) for k in range(10)]
    scene = doorway_with(*tower)
    away = View("near", np.array([0.0, -1.0, 1.0]), np.array([0.0, -2.0, 1.0]))
    poses = [VIEW.world_from_camera, away.world_from_camera]
    with RayWorld(library, scene) as world:
        for square_metres, seen in ((1.5, True), (1.7, False)):
            needed = square_metres * PER_M**2
            found = looks_out(world.cast, poses, DOORWAY, needed, rays)
            assert found.tolist() == [seen, False]
        assert looks_out(world.cast, poses, None, 1).tolist() == [False, False]
        assert looks_out(world.cast, [], DOORWAY, 1).tolist() == []


@pytest.mark.parametrize("slit_m", [0.055, 0.065, 0.08])
def test_few_rays_count_a_slit_as_many_do(library: Library, slit_m: float) -> None:
    """Two walls of cubes leave a slit in the doorway, somewhere between two columns of rays."""
    walls = [
        thing(10 + 10 * k + n, "cube_01", (x, 2.0, 0.2 * n))
        for k, x in enumerate((-0.4, -0.2, 0.0, 0.2 + slit_m, 0.4 + slit_m))
        for n in range(10)
    ]
    with RayWorld(library, doorway_with(*walls)) as world:
        poses = [VIEW.world_from_camera]
        rough, fine = (
            [bool(looks_out(world.cast, poses, DOORWAY, n, rays)[0]) for n in range(50, 8000, 50)]
            for rays in (ROUGH, FINE)
        )
    assert sum(fine)
    assert 0.9 * sum(fine) <= sum(rough) <= 1.1 * sum(fine)


def test_strips_count_that_are_wide_enough() -> None:
    rows = np.array([[1, 1, 0, 1, 1, 1], [0, 0, 0, 0, 0, 0], [1, 1, 1, 1, 1, 1]], dtype=np.bool_)
    assert in_strips(rows, 2).tolist() == [5, 0, 6]
    assert in_strips(rows, 2.5).tolist() == [3, 0, 6]
    assert in_strips(rows, np.array([4, 1, 7])).tolist() == [0, 0, 0]


@pytest.mark.parametrize("rays", [ROUGH, FINE])
@pytest.mark.parametrize(("slit_m", "tells"), [(0.026, False), (0.06, True)])
def test_a_strip_thinner_than_people_see_tells_nothing(
    library: Library, rays: Rays, slit_m: float, tells: bool
) -> None:
    """Of 4 and of 9 pixels, for 2 m of height: 1,100 and 2,600 in all."""
    walls = [
        thing(10 + 10 * k + n, "cube_01", (x, 2.0, 0.2 * n))
        for k, x in enumerate((-0.4, -0.2, 0.0, 0.2 + slit_m, 0.4 + slit_m))
        for n in range(10)
    ]
    with RayWorld(library, doorway_with(*walls)) as world:
        # Beside the walls another strip is left.
        gap = DOORWAY.model_copy(update={"width_m": 0.5})
        assert bool(looks_out(world.cast, [VIEW.world_from_camera], gap, 500, rays)[0]) is tells


def test_what_fills_an_opening_shows_by_the_outdoors_too(library: Library) -> None:
    """And through a doorway between two rooms there is none."""
    found = []
    for rooms in ((1,), (1, 2)):
        scene = doorway_with(TABLE, rooms=rooms)
        marked = [Marked(10, outdoors=outdoors) for outdoors in (0, 500, 40_000)]
        with RayWorld(library, scene) as world:
            found.append(shows(library, scene, world.cast, [VIEW], marked)[0].tolist())
    assert found == [[True, True, False], [True, False, False]]


def test_views_are_chosen_that_look_out_where_that_tells(library: Library) -> None:
    scene = doorway_with(TABLE)
    opening = outer_opening(scene.home, 10)
    set_to = SetTo(scene.object(10), "OPEN", ("top", "legs"), 0, opening)
    states = [replace(set_to, outdoors=outdoors) for outdoors in (0, 500, 60_000)]
    above = View("near", np.array([0.0, 0.3, 1.7]), np.array([0.0, 2.0, 0.9]))
    with RayWorld(library, scene) as world:
        assert states_shown(library, [above], states, world.cast)[0].tolist() == [True, True, False]
