"""facing: the mirror of facing_away. Its threshold is swept in tests/facts."""

from __future__ import annotations

import math
from typing import Any

import pytest
from sdgen.catalog.predicate import Bearing
from sdgen.kleene import Kleene

from tests.catalog.worlds import Thing, World

from .reading import read

FACING = read("facing: {to: sofa, max_deg: 60}")[0]


@pytest.mark.parametrize(
    ("bearings", "value", "sure"),
    [
        ((), False, True),
        ((Bearing(2, math.radians(30)),), True, True),
        ((Bearing(2, math.radians(57)),), True, False),
        ((Bearing(2, math.radians(63)),), False, False),
        ((Bearing(2, math.pi),), False, True),
        ((Bearing(3, math.pi), Bearing(2, 0.1)), True, True),
        ((Bearing(2, 0.1, clear=False),), True, False),
        ((Bearing(2, 0.1, together=Kleene(False, False)),), False, False),
    ],
)
def test_towards_any_such_thing(bearings: Any, value: bool, sure: bool) -> None:
    world = World({1: Thing("tv", bearings={("sofa",): bearings})})
    found = FACING.evaluate(1, world)
    assert (found.value, found.sure) == (value, sure)
    if value:
        assert found.evidence == FACING.measure(1, world)
        assert found.evidence["facing_id"] == 2
    if bearings:
        least = round(min(math.degrees(b.angle_rad) for b in bearings), 4)
        assert FACING.measure(1, world)["facing_deg"] == least


def test_it_is_read_strictly_and_said() -> None:
    assert FACING.in_words() == "its front points within 60 degrees of sofa"
    for text, problem in (
        ("facing: {}", "missing key 'to'"),
        ("facing: {to: sofe}", "did you mean 'sofa'?"),
        ("facing: {to: sofa, max_deg: 3}", "nothing surely faces it"),
    ):
        assert problem in read(text)[1][0]
