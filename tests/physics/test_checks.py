from typing import Any

import pytest
from sdgen.geometry import Vec3
from sdgen.library import Library
from sdgen.physics.checks import penetrations, unsupported
from sdgen.physics.world import standing
from sdgen.scene import ObjectInstance, Scene, Violation

from tests.fakes import box_room, thing


def penetrations_of(library: Library, scene: Scene, **more: Any) -> list[Violation]:
    with standing(library, scene) as world:
        return penetrations(world, **more)


def unsupported_of(library: Library, scene: Scene) -> list[Violation]:
    with standing(library, scene) as world:
        return unsupported(world)


def test_touching_is_no_penetration(library: Library) -> None:
    scene = box_room([thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0.2, 0.1, 0.74))])
    assert penetrations_of(library, scene) == []


@pytest.mark.parametrize("depth", [0.01, 0.03])
def test_depth_is_measured(library: Library, depth: float) -> None:
    scene = box_room(
        [thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0.2, 0.1, 0.74 - depth))]
    )
    (violation,) = penetrations_of(library, scene)
    assert violation.objects == (10, 11)
    assert violation.measured == pytest.approx(depth, abs=0.002)


def furniture(number: int, asset: str, position_m: Vec3, **more: Any) -> ObjectInstance:
    """A thing as furniture really is: it never moves."""
    return thing(number, asset, position_m, fixed=True, **more)


def test_furniture_in_a_wall_and_in_furniture(library: Library) -> None:
    scene = box_room(
        [furniture(10, "table_01", (1.55, 0, 0)), furniture(11, "table_01", (1, 0, 0))]
    )
    assert [v.objects for v in penetrations_of(library, scene)] == [(4, 10), (10, 11)]
    assert [v.objects for v in penetrations_of(library, scene, ids=[11])] == [(10, 11)]


@pytest.mark.parametrize(
    ("position_m", "shell"), [((1.8, 0, 0), 4), ((0, 0, -0.05), 2), ((0, 0, 1.75), 3)]
)
def test_furniture_in_wall_floor_and_ceiling(
    library: Library, position_m: Vec3, shell: int
) -> None:
    scene = box_room([furniture(10, "cabinet_01", position_m)])
    assert [v.objects for v in penetrations_of(library, scene)] == [(shell, 10)]


def test_furniture_that_only_touches_is_found_sound(library: Library) -> None:
    """A hand's breadth from nothing: side by side, back to the wall, under the ceiling."""
    scene = box_room(
        [
            furniture(10, "cabinet_01", (1.67, 0.0, 0)),  # its door touches the wall
            furniture(11, "cabinet_01", (1.67, 0.6, 0)),
            furniture(12, "cabinet_01", (0, 0, 1.7)),
        ]
    )
    assert penetrations_of(library, scene) == []


@pytest.mark.parametrize(("x", "met"), [(0.0, 11), (1.6, 4)], ids=["window", "wall"])
def test_an_open_leaf_counts_where_it_is(library: Library, x: float, met: int) -> None:
    window = furniture(11, "cube_01", (0.7, 0.4, 0.3)).model_copy(update={"category": "window"})
    shut = furniture(10, "cabinet_01", (x, 0, 0))
    assert penetrations_of(library, box_room([shut, window])) == []
    opened = furniture(10, "cabinet_01", (x, 0, 0), joints={"door": -1.5})
    (violation,) = penetrations_of(library, box_room([opened, window]))
    assert sorted(violation.objects) == sorted([10, met])


def test_furniture_presses_into_a_rug_and_a_door_or_a_loose_thing_does_not(
    library: Library,
) -> None:
    table, rug = furniture(10, "table_01", (0, 0, 0)), furniture(11, "sheet_01", (0, 0, 0))
    assert penetrations_of(library, box_room([table, rug])) == []
    thick = furniture(11, "plank_01", (0, 0, 0))  # 2 cm: a leg would cut it
    assert [v.objects for v in penetrations_of(library, box_room([table, thick]))] == [(10, 11)]
    rug = thick
    door = furniture(10, "table_01", (0, 0, 0)).model_copy(update={"category": "door"})
    assert [v.objects for v in penetrations_of(library, box_room([door, rug]))] == [(10, 11)]
    loose = thing(10, "cube_01", (0, 0, 0.005))
    assert [v.objects for v in penetrations_of(library, box_room([loose, rug]))] == [(10, 11)]


def test_what_floats_is_unsupported(library: Library) -> None:
    scene = box_room(
        [
            thing(10, "table_01", (0, 0, 0)),
            thing(11, "cube_01", (0.2, 0.1, 0.74)),
            thing(12, "cube_01", (-0.2, 0.1, 0.80)),
            thing(13, "cube_01", (1.0, 1.0, 1.0), fixed=True),
        ]
    )
    assert [v.objects for v in unsupported_of(library, scene)] == [(12,)]
