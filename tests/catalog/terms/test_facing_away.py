"""facing_away: read, evaluated, measured, said. Its threshold is swept in tests/facts."""

from __future__ import annotations

import math
from typing import Any

import pytest
from sdgen.catalog.predicate import Bearing
from sdgen.kleene import Kleene

from tests.catalog.worlds import Thing, World

from .reading import read

AWAY = read("facing_away: {from: sofa, min_deg: 120}")[0]


@pytest.mark.parametrize(
    ("bearings", "value", "sure"),
    [
        ((), False, True),
        ((Bearing(2, math.radians(170)),), True, True),
        ((Bearing(2, math.radians(123)),), True, False),
        ((Bearing(2, math.radians(117)),), False, False),
        ((Bearing(2, 0.0),), False, True),
        ((Bearing(2, 0.0), Bearing(3, math.pi)), True, True),
        ((Bearing(2, math.pi, clear=False),), True, False),
        ((Bearing(2, math.pi, together=Kleene(False, False)),), False, False),
    ],
)
def test_away_from_any_such_thing(bearings: Any, value: bool, sure: bool) -> None:
    world = World({1: Thing("tv", bearings={("sofa",): bearings})})
    found = AWAY.evaluate(1, world)
    assert (found.value, found.sure) == (value, sure)
    if value:
        assert found.evidence == AWAY.measure(1, world)
        assert found.evidence["away_from_id"] == bearings[-1].target_id


def test_it_is_read_strictly_and_said() -> None:
    assert AWAY.in_words() == "its front is at least 120 degrees away from sofa"
    for text, problem in (
        ("facing_away: {}", "missing key 'from'"),
        ("facing_away: {from: sofe}", "did you mean 'sofa'?"),
        ("facing_away: {from: sofa, min_deg: 178}", "nothing surely faces away"),
    ):
        assert problem in read(text)[1][0]
