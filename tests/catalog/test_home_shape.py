"""Where walls are, and which rooms an opening lies between."""

from __future__ import annotations

from typing import Literal

import pytest
from sdgen.catalog.home_shape import OutlineError, in_wall, inner_ring, rooms_beside
from sdgen.catalog.records import OpeningSpec, RoomSpec


def room(*rectangles: tuple[float, float, float, float]) -> RoomSpec:
    return RoomSpec(name="a", type="kitchen", rectangles_m=rectangles)


def test_a_floor_ends_half_a_wall_inside_the_outline() -> None:
    assert set(inner_ring(room((0, 0, 4, 3)))) == {
        (0.06, 0.06),
        (3.94, 0.06),
        (3.94, 2.94),
        (0.06, 2.94),
    }
    corner = inner_ring(room((0, 0, 4, 2), (0, 2, 2, 4)))
    assert len(corner) == 6
    assert (1.94, 1.94) in corner  # where the walls turn into the room, the floor ends early, too


@pytest.mark.parametrize(
    ("rectangles", "why"),
    [
        (((0, 0, 2, 2), (5, 5, 7, 7)), "do not join"),
        (((0, 0, 2, 2), (2, 2, 4, 4)), "do not join"),
        (((0, 0, 3, 1), (0, 2, 3, 3), (0, 0, 1, 3), (2, 0, 3, 3)), "leave a hole"),
        (((0, 0, 3, 0.12),), "too narrow"),
        (((0, 0, 2, 2), (2, 1, 3, 1.1), (3, 0, 5, 2)), "too narrow"),
    ],
)
def test_rectangles_that_make_no_room(
    rectangles: tuple[tuple[float, float, float, float], ...], why: str
) -> None:
    with pytest.raises(OutlineError, match=why):
        inner_ring(room(*rectangles))


@pytest.mark.parametrize(
    ("center", "along", "metres"),
    [
        ((2.0, 0.0), "x", 1.0),
        ((0.3, 0.0), "x", 0.74),  # past the corner
        ((2.0, 0.12), "x", 0.0),  # as far from the edge, but within the room
        ((2.0, 0.1), "x", 0.0),
        ((2.0, 0.0), "y", 0.0),
        ((9.0, 0.0), "x", 0.0),
    ],
)
def test_how_much_of_an_opening_is_in_a_wall(
    center: tuple[float, float], along: Literal["x", "y"], metres: float
) -> None:
    """Of an edge along x, and the same turned to the left, to run along y."""
    found = in_wall((0.06, 0.06), (3.94, 0.06), center, along, 1.0)
    assert found == pytest.approx(metres)
    (x, y) = center
    turned: Literal["x", "y"] = "y" if along == "x" else "x"
    assert in_wall((-0.06, 0.06), (-0.06, 3.94), (-y, x), turned, 1.0) == pytest.approx(metres)


def test_the_rooms_beside_an_opening_come_with_what_their_walls_hold() -> None:
    rings = [inner_ring(room(r)) for r in ((0, 0, 4, 4), (4, 0, 8, 2), (4, 2, 8, 6))]
    door = OpeningSpec(kind="door", center_m=(4.0, 1.95), along="y")
    assert rooms_beside(rings, door) == pytest.approx({0: 0.9, 1: 0.44, 2: 0.34})
    lower = door.model_copy(update={"center_m": (4.0, 1.0)})
    assert rooms_beside(rings, lower) == pytest.approx({0: 0.9, 1: 0.9})
