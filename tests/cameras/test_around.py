"""What is to be in the picture with a place: its surface up to the edges, and the way before it."""

from collections.abc import Iterator

import numpy as np
import pytest
from sdgen.cameras.around import Surroundings
from sdgen.home.layout import Layout
from sdgen.library import Library
from sdgen.scene import Zone

from tests.fakes import thing


@pytest.fixture
def surroundings(library: Library) -> Surroundings:
    """A table at (1, 1), a walkway through room 1, and water, which nobody walks on."""

    def ids() -> Iterator[int]:
        yield 10

    layout = Layout(library, ids())
    layout.put(thing(10, "table_01", (1.0, 1.0, 0.0)))
    zones = [
        Zone(name=kind, kind=kind, polygon_m=ring, z_min_m=0, z_max_m=2, room_id=1)
        for kind, ring in (
            ("walkway", ((-2, -1), (2, -1), (2, -0.2), (-2, -0.2))),
            ("water", ((-2, 0.3), (2, 0.3), (2, 0.4), (-2, 0.4))),
        )
    ]
    return Surroundings(layout, zones)


def test_a_surface_is_shown_up_to_its_near_edges_and_below(surroundings: Surroundings) -> None:
    points = surroundings.of(10, np.array([1.4, 0.7, 0.78]))
    assert len(points) == 8
    assert sorted(set(points[:, 2].round(6).tolist())) == [0.43, 0.78]
    assert points[:, :2].min(axis=0) == pytest.approx([0.95, 0.6])
    assert points[:, :2].max(axis=0) == pytest.approx([1.5, 1.15])


def test_a_floor_is_shown_around_and_to_the_way(surroundings: Surroundings) -> None:
    points = surroundings.of(1, np.array([0.0, 0.8, 0.04]))
    assert points[:, 1].min() == pytest.approx(-0.65)
    assert points[:, 1].max() == pytest.approx(1.25)
    assert np.abs(points[:, 0]).max() == pytest.approx(0.45)
    # On the way itself what is around tells; a far one does not matter.
    for y in (-0.5, 2.0):
        assert np.abs(surroundings.of(1, np.array([0.0, y, 0.04]))[:, 1] - y).max() < 0.46
    assert len(surroundings.of(2, np.array([0.0, 0.8, 0.04]))) == 4
