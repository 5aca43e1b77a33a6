"""Things stand on the furniture that is there now, and floors are where most things stand."""

from __future__ import annotations

import numpy as np
import pytest
from sdgen.home.surfaces import PlacingSurface
from sdgen.importing.scenes.found import FoundPiece, FoundScene
from sdgen.importing.scenes.rooms import level_and_square
from sdgen.importing.scenes.standing import shifts_m
from sdgen.library.records import Support


def thing(x: float, z: float, high: float = 0.1, name: str = "cup") -> FoundPiece:
    return FoundPiece(name, (x, 0.0, z), (0.0, 0.0, 0.0, 1.0), (0.1, 0.1, high))


def counter(z: float) -> PlacingSurface:
    """A surface of 1 by 1 m around the origin."""
    corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
    support = Support(name="top", part="body", z_m=z, polygon_m=tuple(corners))
    return PlacingSurface(support, np.array([(x, y, z) for x, y in corners]))


def test_things_go_down_to_the_counter_with_what_lies_on_them() -> None:
    pieces = [thing(0, 1.06), thing(0, 0.96), thing(0.3, 0.86), thing(0, 1.16, name="on both")]
    assert shifts_m(pieces, [counter(0.9)]) == pytest.approx([-0.06, -0.06, 0.04, -0.06])


def test_what_nothing_carries_stays() -> None:
    pieces = [thing(0, 1.2), thing(2.0, 0.9), thing(2.0, 0.03)]
    assert shifts_m(pieces, [counter(0.9)]) == pytest.approx([0, 0, -0.03])


def test_the_nearest_of_several_boards_carries() -> None:
    boards = [counter(0.3), counter(0.6)]
    assert shifts_m([thing(0, 0.4), thing(0.2, 0.5)], boards) == pytest.approx([-0.1, 0.1])


@pytest.mark.parametrize(
    ("bottoms", "floor"),
    [([-0.12, 0.0, 0.01, 0.0, 0.9, 0.9], 0.0), ([0.4, 0.41, 1.2], 0.405), ([2.0], 2.0), ([], 0.0)],
)
def test_a_floor_that_is_not_there_is_where_most_things_stand(
    bottoms: list[float], floor: float
) -> None:
    scene = FoundScene(source="s", title="t", pieces=[thing(0, z) for z in bottoms])
    levelled = level_and_square(scene)
    assert [p.position_m[2] for p in levelled.pieces] == pytest.approx([z - floor for z in bottoms])
