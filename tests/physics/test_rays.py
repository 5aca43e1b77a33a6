import numpy as np
import pytest
from sdgen.library import Library
from sdgen.physics.rays import RayWorld
from sdgen.physics.still import Still

from tests.fakes import box_room, thing


def test_rays_tell_object_part_and_distance(library: Library) -> None:
    scene = box_room([thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0, 0, 0.74))])
    origins = np.array([[0, 0, 2.0], [0.3, 0.2, 2.0], [-1.0, 0, 0.3], [1.0, 1.0, 1.0], [1, 1, 1]])
    targets = np.array([[0, 0, 0.0], [0.3, 0.2, 0.0], [1.0, 0, 0.3], [1.0, 1.0, -1.0], [1, 1, 0.5]])
    with RayWorld(library, scene) as world:
        hits = world.cast(origins, targets)
    assert hits.object_id.tolist() == [11, 10, 10, 2, 0]
    assert hits.part.tolist() == [1, 1, 2, 0, 0]
    assert hits.distance_m[:4] == pytest.approx([1.06, 1.26, 0.95, 1.0], abs=1e-3)
    assert np.isinf(hits.distance_m[4])


def test_hollows_are_hollow_and_doors_swing(library: Library) -> None:
    origins, targets = np.array([[1.0, 0.0, 0.4]]), np.array([[-1.0, 0.0, 0.4]])
    for angle, part in ((0.0, 3), (-1.5, 1)):
        scene = box_room([thing(10, "cabinet_01", (0, 0, 0), joints={"door": angle})])
        with RayWorld(library, scene) as world:
            assert world.cast(origins, targets).part.tolist() == [part]


def test_many_rays_in_batches_equal_few(library: Library) -> None:
    scene = box_room([thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0, 0, 0.74))])
    rng = np.random.default_rng(1)
    targets = rng.uniform(-3, 3, (20000, 3))
    origins = np.tile([1.5, 1.5, 1.5], (20000, 1))
    still = Still()
    first = RayWorld(library, scene, still).cast(origins, targets)
    again = RayWorld(library, scene, still).cast(origins[15000:], targets[15000:])
    still.close()
    assert set(first.object_id.tolist()) >= {2, 4, 10, 11}
    assert np.array_equal(first.object_id[15000:], again.object_id)
    assert np.array_equal(first.distance_m[15000:], again.distance_m)


def test_what_rays_come_near_later_is_there_then(library: Library) -> None:
    scene = box_room([thing(10, "cube_01", (-1.5, 0, 0)), thing(11, "cube_02", (1.5, 0, 0))])
    left, right = np.array([[-1.5, 0, 1.0]]), np.array([[1.5, 0, 1.0]])
    with RayWorld(library, scene) as world:
        assert world.cast(left, left - [0, 0, 1]).object_id.tolist() == [10]
        assert world.cast(right, right - [0, 0, 1]).object_id.tolist() == [11]
        assert world.cast(left - [0, 0, 0.9], right - [0, 0, 0.9]).object_id.tolist() == [10]
        inwards = world.cast(left - [-0.5, 0, 0.9], right - [0, 0, 0.9])
        assert inwards.object_id.tolist() == [11]
