import pytest
from sdgen.library import Library
from sdgen.physics.checks import penetrations, unsupported

from tests.fakes import box_room, thing


def test_touching_is_no_penetration(library: Library) -> None:
    scene = box_room([thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0.2, 0.1, 0.74))])
    assert penetrations(library, scene) == []


@pytest.mark.parametrize("depth", [0.01, 0.03])
def test_depth_is_measured(library: Library, depth: float) -> None:
    scene = box_room(
        [thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0.2, 0.1, 0.74 - depth))]
    )
    (violation,) = penetrations(library, scene)
    assert violation.objects == (10, 11)
    assert violation.measured == pytest.approx(depth, abs=0.002)


def test_furniture_in_a_wall_and_in_furniture(library: Library) -> None:
    scene = box_room(
        [thing(10, "table_01", (1.55, 0, 0)), thing(11, "table_01", (1.0, 0.0, 0.0))],
    )
    assert [v.objects for v in penetrations(library, scene)] == [(4, 10), (10, 11)]
    assert [v.objects for v in penetrations(library, scene, ids=[11])] == [(10, 11)]


def test_fixed_things_may_sit_in_the_wall(library: Library) -> None:
    scene = box_room([thing(10, "cabinet_01", (1.8, 0, 0), fixed=True)])
    assert penetrations(library, scene) == []


def test_what_floats_is_unsupported(library: Library) -> None:
    scene = box_room(
        [
            thing(10, "table_01", (0, 0, 0)),
            thing(11, "cube_01", (0.2, 0.1, 0.74)),
            thing(12, "cube_01", (-0.2, 0.1, 0.80)),
            thing(13, "cube_01", (1.0, 1.0, 1.0), fixed=True),
        ]
    )
    assert [v.objects for v in unsupported(library, scene)] == [(12,)]
