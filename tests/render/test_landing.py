"""Upstairs an open front door shows a landing; windows, and doors at the ground, show the world."""

import numpy as np
import pytest
from sdgen.render.landing import landings, seen_on
from sdgen.render.outdoors import paint_outdoors
from sdgen.scene import Opening, Outdoors

from tests import toy

from .test_outdoors import camera

WIDE_M, HIGH_M = 0.9, 2.0


def home(storey: int, **opening):
    """A toy home of one room with a front door in the wall at x = 4.06."""
    base = toy.scene().home
    room = base.rooms[0]
    door = {
        "object_id": 90,
        "kind": "front_door",
        "room_ids": (room.id,),
        "center_m": (4.06, 0.0, 0.0),
        "along": "y",
        "width_m": WIDE_M,
        "height_m": HIGH_M,
    }
    return base.model_copy(
        update={
            "outdoors": Outdoors(storey=storey),
            "openings": (Opening(**{**door, **opening}),),
        }
    )


def test_only_front_doors_upstairs_have_one():
    assert landings(home(0)) == ()
    assert landings(home(2, kind="window")) == ()
    (landing,) = landings(home(2))
    assert landing.outward == (1.0, 0.0)
    assert landing.right == (0.0, -1.0)


@pytest.mark.parametrize("y", [-0.4, 0.0, 0.4])
def test_rays_through_the_doorway_meet_it_and_others_do_not(y):
    (landing,) = landings(home(3))
    eye = np.array([1.0, 0.0, 1.4])
    ends = np.array(
        [(4.06, y, 1.0), (4.06, y, 1.99), (4.06, y, 2.01), (4.06, 0.46, 1.0), (-2.0, y, 1.0)]
    )
    there, colours = seen_on(landing, eye, ends - eye)
    assert there.tolist() == [True, True, False, False, False]
    assert colours.shape == (2, 3)
    assert np.isfinite(colours).all()
    assert (colours > 0).all()
    assert (colours < 255).all()


def test_one_sees_the_neighbours_door_opposite_between_walls():
    (landing,) = landings(home(1))
    eye = np.array([1.0, 0.0, 1.2])
    opposite, wall = (5.7, 0.0, 1.2), (5.7, -0.68, 1.2)
    _, (door, plaster) = seen_on(landing, eye, np.array([opposite, wall]) - eye)
    assert door.sum() < 0.6 * plaster.sum()


def test_background_beside_the_doorway_stays_the_world():
    instance = np.zeros((48, 64), dtype=np.uint16)
    before, part = np.full((48, 64, 3), 7, np.uint8), np.zeros((48, 64), np.uint8)
    flat = home(2)
    args = (before, instance, part, (), flat.outdoors, flat.daylight, camera())
    world, both = paint_outdoors(*args), paint_outdoors(*args, landings(flat))
    changed = (world != both).any(axis=2)
    # 0.9 m by 2.0 m at 4.06 m.
    assert changed[24, 32]
    assert not changed[:, 0].any()
    assert not changed[0].any()
    assert 100 < changed.sum() < 500
