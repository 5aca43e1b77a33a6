import math

import pytest
from sdgen.geometry import quat_from_axis_angle, rotation_matrix
from sdgen.library import Library
from sdgen.physics.bodies import collision_of
from sdgen.physics.client import GRAVITY_M_S2, STEP_S, Client
from sdgen.physics.settle import moving, settle_scene
from sdgen.physics.world import World
from sdgen.vocabulary import DRIFT_LIMIT_M

from tests.fakes import box_room, thing

TABLE_TOP = 0.74


def test_free_fall_is_half_g_t_squared() -> None:
    with Client() as client:
        body = client.body(client.box((0.1, 0.1, 0.1)), (0, 0, 10), mass_kg=1.0)
        client.step(60)
        fallen = 10 - client.pose(body).position_m[2]
    t = 60 * STEP_S
    assert fallen == pytest.approx(0.5 * GRAVITY_M_S2 * t * t, rel=0.03)


def test_a_cube_on_a_table_stays_where_it_was_put(library: Library) -> None:
    scene = box_room(
        [thing(10, "table_01", (0, 0, 0)), thing(11, "cube_01", (0.2, 0.1, TABLE_TOP))]
    )
    result = settle_scene(library, scene, [11])
    x, y, z = result.poses[11].position_m
    assert (x, y) == pytest.approx((0.2, 0.1), abs=2e-4)
    assert z == pytest.approx(TABLE_TOP, abs=0.0015)
    assert result.drift_m[11] < 0.002
    assert result.tilt_rad[11] < 0.002
    assert result.unstable == ()
    assert [(c.a, c.b) for c in result.contacts] == [(10, 11)]


def test_poses_are_of_the_object_frame_not_of_the_centre_of_mass(library: Library) -> None:
    """A cube lying on its side: its origin, the middle of a face, ends half a cube up."""
    quat = quat_from_axis_angle((1, 0, 0), math.pi / 2)
    scene = box_room([thing(11, "cube_01", (0.0, 0.0, 0.1), quat)])
    result = settle_scene(library, scene, [11])
    assert result.poses[11].position_m == pytest.approx((0.0, 0.0, 0.1), abs=0.002)
    up = rotation_matrix(result.poses[11].quat_xyzw)[:, 2]
    assert up == pytest.approx((0, -1, 0), abs=0.01)


def test_what_hangs_over_the_edge_falls_and_is_called_unstable(library: Library) -> None:
    plank = thing(11, "plank_01", (0.75, 0.0, TABLE_TOP))
    result = settle_scene(library, box_room([thing(10, "table_01", (0, 0, 0)), plank]), [11])
    assert result.unstable == (11,)
    assert result.drift_m[11] > DRIFT_LIMIT_M  # it is not waited for any longer


def test_only_drawn_parts_at_their_joints_hold_things(library: Library) -> None:
    """A plank lies on the closed door, and falls past it when the door is open."""
    plank = thing(11, "plank_01", (0.02, 0.0, 0.8))
    closed = box_room([thing(10, "cabinet_01", (0, 0, 0)), plank])
    opened = box_room([thing(10, "cabinet_01", (0, 0, 0), joints={"door": -1.5}), plank])
    assert settle_scene(library, closed, [11]).drift_m[11] < 0.002
    assert settle_scene(library, opened, [11]).drift_m[11] > 0.05


def test_a_used_client_gives_the_same_bytes(library: Library) -> None:
    things = [thing(10, "table_01", (0, 0, 0))]
    things += [thing(11 + k, "cube_01", (-0.3 + 0.25 * k, 0.02 * k, 0.75)) for k in range(3)]
    things += [thing(20, "plank_01", (0.0, 0.0, 1.0))]
    scene = box_room(things)
    ids = [11, 12, 13, 20]
    fresh = settle_scene(library, scene, ids)
    with Client() as client:
        settle_scene(library, box_room([thing(5, "cube_02", (1, 1, 0.5))]), [5], client)
        again = settle_scene(library, scene, list(reversed(ids)), client)
        third = settle_scene(library, scene, ids, client)
    assert fresh == again == third


def moved(library: Library, all_awake: bool) -> dict[int, float]:
    """Of a plank that tips over a table's edge, a cube that falls upon the end of a plank that
    lies across another cube, and a cube aside: what moves, and by how much."""
    things = [
        thing(10, "table_01", (0, 0, 0), fixed=True),
        thing(11, "plank_01", (0.75, 0.0, TABLE_TOP)),
        thing(12, "cube_01", (-0.3, 0.0, TABLE_TOP)),
        thing(16, "cube_01", (1.0, 1.0, 0.0)),
        thing(13, "plank_01", (1.0, 1.0, 0.2)),
        thing(14, "cube_01", (1.25, 1.0, 0.8)),
        thing(15, "cube_01", (-1.0, 1.0, 0.0)),
    ]
    scene = box_room(things)
    with Client() as client:
        world = World(library, client)
        world.become(scene, [item.id for item in scene.objects if not item.fixed])
        return {v.objects[0]: v.measured for v in moving(world, all_awake=all_awake)}


def test_what_sleeps_hides_nothing_that_moves_or_is_moved_later(library: Library) -> None:
    """The second plank has been at rest for long when the cube falls upon it."""
    awake, asleep = moved(library, True), moved(library, False)
    assert set(awake) == set(asleep) == {11, 13, 14}
    assert asleep == pytest.approx(awake, rel=0.05)


def test_collision_pieces_are_made_once_and_follow_the_joints(library: Library) -> None:
    shut = thing(10, "cabinet_01", (0, 0, 0))
    again = thing(11, "cabinet_01", (1, 0, 0))
    (joint, *_) = library.info("cabinet_01").joints
    opened = shut.model_copy(update={"joints": {joint.name: joint.lower}})
    assert collision_of(library, shut) is collision_of(library, again)
    assert collision_of(library, opened).obj != collision_of(library, shut).obj
