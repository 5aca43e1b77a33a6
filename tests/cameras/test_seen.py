"""Depth maps of the furniture tell what its views would show of a thing that is not there yet."""

import numpy as np
import pytest
import shapely
from sdgen.cameras.framing import glance_pixels
from sdgen.cameras.parts import part_area, part_points
from sdgen.cameras.seen import Seen
from sdgen.cameras.sight import estimate_pixels
from sdgen.cameras.spots import SetTo
from sdgen.cameras.view import View
from sdgen.geometry import Array, box_corners
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.vocabulary import EVIDENCE_PIXELS

from tests.fakes import box_room, thing

#: What a view shows in a state.
OPENED = thing(11, "table_01", (2.0, 2.0, 0))


def small(x: float, y: float, z: float, size: float = 0.1) -> Array:
    return box_corners((x - size / 2, y - size / 2, z), (x + size / 2, y + size / 2, z + size))


@pytest.fixture(scope="module")
def seen(library: Library) -> Seen:
    """One view of a table in a room, from 1.5 m before it."""
    scene = box_room([thing(10, "table_01", (0.5, 0.8, 0))])
    view = View("near", np.array([0.5, -0.9, 1.2]), np.array([0.5, 0.8, 0.7]))
    with RayWorld(library, scene) as world:
        return Seen(library, [view], [SetTo(OPENED, "OPEN", ("body",))], [12], world.cast)


@pytest.mark.parametrize(
    ("where", "shown"),
    [
        ((0.3, 0.6, 0.74), True),  # on the table
        ((0.8, 1.1, 0.74), True),  # at its far edge
        ((0.8, 0.6, 0.0), True),  # on the floor below
        ((0.5, 1.6, 0.0), False),  # on the floor behind, hidden by the top
        ((0.5, -1.5, 0.0), False),  # behind the camera
        ((-1.8, 0.8, 0.0), False),  # beside the picture
        ((0.5, 2.3, 0.8), False),  # behind the wall
    ],
)
def test_what_stands_where_is_seen(seen: Seen, where, shown: bool) -> None:
    assert seen.thing(small(*where)) is shown


def test_a_floor_is_seen_where_things_on_it_are(seen: Seen) -> None:
    """Below the table's near edge, but neither behind it, nor beside or behind the camera."""
    floor = seen.floor(shapely.box(-2.0, -2.0, 3.0, 3.0))
    assert floor.contains(shapely.Point(0.8, 0.3))
    for hidden in ((0.5, 2.0), (0.5, -1.5), (-1.8, 0.8)):
        assert not floor.contains(shapely.Point(hidden))
    assert seen.floor(shapely.box(0.4, -1.8, 0.6, -1.6)).is_empty
    assert seen.floor(shapely.Polygon()).is_empty


def test_what_is_too_small_to_tell_is_not_seen(seen: Seen) -> None:
    assert not seen.thing(small(0.3, 0.6, 0.74, size=0.02))


def test_what_is_cut_off_by_the_edge_is_not_seen(seen: Seen, library: Library) -> None:
    """Half of a cube in the picture does not do, though it has pixels enough."""
    assert seen.thing(small(1.1, 0.4, 0.9))
    edge = np.tan(np.deg2rad(35)) * 1.5 + 0.5
    assert not seen.thing(small(edge, 0.6, 0.9, size=0.2))


@pytest.mark.parametrize("model", ["sheet_01", "cube_01", "plank_01"])
def test_parts_tell_by_what_of_them_faces_a_view(library: Library, model: str) -> None:
    """On the table about so many pixels as rays count; behind a wall and behind the camera
    none."""
    view = View("near", np.array([0.5, -0.9, 1.2]), np.array([0.5, 0.8, 0.7]))
    scene = box_room([thing(10, "table_01", (0.5, 0.8, 0)), thing(11, model, (0.5, 0.6, 0.74))])
    item = scene.object(11)
    with RayWorld(library, scene) as world:
        pose, points = [view.world_from_camera], part_points(library, item, ())
        (counted,) = estimate_pixels(world.cast, pose, points, 11, np.array([1]))
        told = Seen(library, [view], [], [], world.cast)
    promised = counted / (1.2 * glance_pixels(part_area(library, item, ()))) * EVIDENCE_PIXELS
    assert told.telling(item, ("body",), int(0.85 * promised))
    assert not told.telling(item, ("body",), int(1.15 * promised) + 1)
    for hidden in ((0.5, 2.3, 0.8), (0.5, -1.5, 0.0)):
        assert not told.telling(thing(11, model, hidden), ("body",), 1)


def test_states_are_those_that_were_shown(seen: Seen) -> None:
    assert seen.set_to(11, "OPEN") == (OPENED,)
    assert seen.set_to(11, "ON") == ()
    assert seen.set_to(10, "OPEN") == ()


def test_only_furniture_known_to_be_hidden_is_not_tried(seen: Seen) -> None:
    assert [seen.anything_on(number) for number in (10, 11, 12)] == [True, True, False]
