"""What stands on what, where pictures leave it open."""

import numpy as np
import pytest
import shapely
from sdgen.perception.kinds import Kind
from sdgen.perception.levels import Level
from sdgen.perception.standing import settle
from sdgen.perception.things import Piece, Thing

UPRIGHT = (0.0, 0.0, 0.0, 1.0)


def thing(number, box, low, high, fixed=False, ends=True, levels=(), tall=None, **kind):
    size = np.array([1.0, 1.0, high - low if tall is None else tall])
    known = Kind(largest=size, usual=size, **kind)
    body = Piece(shapely.box(*box), low, high)
    return Thing(number, "thing", known, fixed, UPRIGHT, body, [], list(levels), ends)


def settled(*things):
    by_id = {one.id: one for one in things}
    settle(by_id)
    return by_id


def table(z=0.75, box=(0, 0, 2, 1), **more):
    level = Level(z, shapely.box(*box))
    return thing(1, box, 0.0, z, fixed=True, carries=True, flat=True, levels=[level], **more)


def test_what_ends_just_above_a_surface_stands_on_it():
    found = settled(table(), thing(2, (1, 0.2, 1.1, 0.3), 0.758, 0.9))
    assert found[2].body.low == 0.75


def test_what_is_hidden_below_goes_down_to_the_highest_surface():
    found = settled(table(), thing(2, (1, 0.2, 1.1, 0.3), 0.83, 0.95, ends=False, tall=0.25))
    assert found[2].body.low == 0.75


def test_what_is_too_short_to_reach_a_surface_does_not():
    short = thing(2, (1, 0.2, 1.1, 0.3), 1.5, 1.55, ends=False, tall=0.1)
    assert settled(table(), short)[2].body.low == 1.5


def test_a_tin_on_a_tin_stands_on_that_whose_top_nobody_sees():
    lower = thing(2, (1, 0.2, 1.1, 0.3), 0.75, 0.86, carries=True)
    upper = thing(3, (1, 0.2, 1.1, 0.3), 0.862, 0.97)
    found = settled(table(), lower, upper)
    assert found[3].body.low == pytest.approx(0.86)
    assert [level.z_m for level in found[2].levels] == [0.86]


def test_what_ends_in_the_air_within_furniture_stands_on_a_board():
    shelf = thing(1, (0, 0, 1, 0.3), 0.0, 2.0, fixed=True, carries=True, levels=())
    book = thing(2, (0.4, 0.1, 0.5, 0.2), 1.5, 1.7)
    found = settled(shelf, book)
    assert found[2].body.low == 1.5
    assert [level.z_m for level in found[1].levels] == [1.5]


def test_what_hangs_alone_stays_where_it_is():
    towel = thing(2, (5, 5, 5.3, 5.1), 1.0, 1.5)
    assert settled(table(), towel)[2].body.low == 1.0
    lamp = thing(3, (1, 0.5, 1.2, 0.7), 2.2, 2.5, fixed=True, ends=False, hung=True)
    assert settled(table(), lamp)[3].body.low == 2.2


def test_furniture_stands_on_the_floor_whatever_hides_its_feet():
    sofa = thing(4, (5, 5, 7, 6), 0.35, 0.9, fixed=True, ends=False, tall=0.95)
    assert settled(sofa)[4].body.low == 0.0


def test_neighbours_do_not_take_what_stands_beside_them():
    beside = table(z=0.755, box=(2, 0, 3, 1))
    beside.id = 9
    near_the_joint = thing(2, (1.85, 0.2, 1.95, 0.3), 0.75, 0.9)
    found = settled(table(), beside, near_the_joint)
    assert found[2].body.low == 0.75


def test_a_surface_reaches_under_what_hides_its_far_end():
    seen = table(box=(0, 0, 2, 0.5))
    far = thing(2, (1, 0.45, 1.1, 0.6), 0.751, 1.0)
    found = settled(seen, far)
    assert found[1].levels[0].outline.covers(far.body.outline)
