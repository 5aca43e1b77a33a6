"""What a grid of rays says of an overview: what must hold, and what it is worth."""

from dataclasses import dataclass

import numpy as np
import pytest
from sdgen.cameras.judged import Inventory, judge
from sdgen.cameras.view import View
from sdgen.geometry import Array

from tests.fakes import box_room

RAYS = 300
WALL, CEILING, FLOOR = 4, 3, 2
VIEW = View("room", np.zeros(3), np.array([1.0, 0.0, 0.0]), 1)
THINGS = range(10, 40)
INVENTORY = Inventory.of(box_room().home, dict.fromkeys(THINGS, 1), [*THINGS][5:])


@dataclass
class Met:
    """Hits of things by their ids, a number of rays each, all so far away; walls else."""

    object_id: Array
    distance_m: Array
    part: Array


def judged(of: dict[int, int], far_m: float = 3.0) -> tuple[float, float]:
    """Flaw and worth of a view whose rays meet so."""
    ids = np.repeat([*of, WALL], [*of.values(), RAYS - sum(of.values())])

    def cast(origins: Array, _ends: Array) -> Met:
        assert len(origins) == RAYS
        return Met(ids, np.full(RAYS, far_m), np.zeros(RAYS))

    found = judge([VIEW], INVENTORY, cast)
    return float(found.flaw[0]), float(found.worth[0])


@pytest.mark.parametrize("thing", [10, 20])
def test_no_thing_takes_a_quarter_of_the_picture_be_it_a_leaf_or_a_bed(thing: int) -> None:
    assert judged({thing: 60})[0] == 0.0
    assert 0.0 < judged({thing: 75})[0] < judged({thing: 150})[0]
    assert judged({thing: 60, thing + 1: 60})[0] == 0.0


def test_walls_floors_and_the_open_may() -> None:
    assert judged({FLOOR: 120, CEILING: 100})[0] == 0.0
    assert judged({0: 200})[0] == 0.0


def test_nothing_is_too_near() -> None:
    assert judged({}, far_m=1.0)[0] == 0.0
    assert 0.0 < judged({}, far_m=0.6)[0] < judged({}, far_m=0.3)[0]


def test_more_pieces_of_furniture_more_of_it_and_more_room_are_worth_more() -> None:
    one = judged({20: 30})[1]
    assert judged({20 + k: 10 for k in range(3)})[1] > one
    assert judged({20: 60})[1] > one
    assert judged({20: 30, CEILING: 20})[1] > one
    assert judged({20: 30}, far_m=4.0)[1] > one > judged({20: 30}, far_m=2.0)[1]
    # What is no furniture, such as a leaf or a rug, is worth no more than the wall behind it.
    assert judged({10: 30})[1] == pytest.approx(judged({})[1])
    assert judged({20 + k: 12 for k in range(12)} | {CEILING: 20}, far_m=9.0)[1] <= 1.0
