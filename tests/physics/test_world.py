"""A world is loaded once and follows the scene: what goes, what changes, what sleeps on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from sdgen.library import Library
from sdgen.physics.checks import penetrations
from sdgen.physics.client import Client
from sdgen.physics.settle import Settled, moving, settle
from sdgen.physics.world import World
from sdgen.scene import ObjectInstance, Scene

from tests.fakes import box_room, thing

TABLE_TOP = 0.74
TABLE = thing(10, "table_01", (0, 0, 0), fixed=True)


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with Client() as one:
        yield one


def loose(scene: Scene) -> list[int]:
    return [item.id for item in scene.objects if not item.fixed]


def rest(world: World, *things: ObjectInstance) -> Settled:
    scene = box_room(things)
    world.become(scene, loose(scene))
    return settle(world)


def posed(item: ObjectInstance, settled: Settled) -> ObjectInstance:
    return item.model_copy(update={"pose": settled.poses[item.id]})


def test_what_stood_on_something_that_goes_falls_and_the_rest_sleeps(
    library: Library, client: Client
) -> None:
    world = World(library, client)
    below, above = thing(11, "cube_01", (0, 0, 0.001)), thing(12, "cube_02", (0, 0, 0.202))
    aside = thing(13, "cube_01", (1, 1, 0.001))
    first = rest(world, below, above, aside)
    assert first.unstable == ()
    assert {(c.a, c.b) for c in first.contacts} == {(2, 11), (11, 12), (2, 13)}
    second = rest(world, posed(above, first), posed(aside, first))
    assert second.drift_m[12] > 0.1
    assert second.unstable == (12,)
    assert second.drift_m[13] == 0.0
    assert (2, 13) in {(c.a, c.b) for c in second.contacts}


def test_what_nothing_touched_takes_no_steps_again(library: Library, client: Client) -> None:
    world = World(library, client)
    things = [thing(11 + k, "cube_01", (-0.3 + 0.3 * k, 0, TABLE_TOP + 0.001)) for k in range(3)]
    first = rest(world, TABLE, *things)
    again = rest(world, TABLE, *(posed(item, first) for item in things[1:]))
    assert again.steps <= 12 < first.steps
    assert set(again.drift_m.values()) == {0.0}


def test_a_thing_that_sleeps_still_holds_others(library: Library, client: Client) -> None:
    world = World(library, client)
    below = thing(11, "cube_01", (0, 0, 0.001))
    first = rest(world, below)
    above = thing(12, "cube_02", (0, 0, 0.25))
    both = rest(world, posed(below, first), above)
    assert both.poses[12].position_m[2] == pytest.approx(0.2, abs=0.003)


def test_what_is_thrown_at_a_sleeper_wakes_it(library: Library, client: Client) -> None:
    """A plank that lies across two cubes' edge of balance: what lands on its end tips it."""
    world = World(library, client)
    cube, plank = thing(11, "cube_01", (0, 0, 0.001)), thing(12, "plank_01", (0.05, 0, 0.202))
    first = rest(world, cube, plank)
    assert first.drift_m[12] < 0.01
    weight = thing(13, "cube_02", (0.28, 0, 0.24))
    second = rest(world, posed(cube, first), posed(plank, first), weight)
    assert second.tilt_rad[12] > 0.2


def test_a_changed_piece_is_loaded_anew(library: Library, client: Client) -> None:
    world = World(library, client)
    shut = thing(10, "cabinet_01", (0, 0, 0), fixed=True, joints={"door": 0.0})
    opened = shut.model_copy(update={"joints": {"door": -1.5}})
    cube = thing(11, "cube_01", (0.7, 0.35, 0), fixed=True)
    for cabinet, found in ((shut, []), (opened, [(10, 11)]), (shut, [])):
        world.become(box_room([cabinet, cube]), ())
        assert [v.objects for v in penetrations(world)] == found


def test_checks_see_the_poses_a_thing_was_put_back_to(library: Library, client: Client) -> None:
    world = World(library, client)
    cube = thing(11, "cube_01", (0, 0, TABLE_TOP + 0.001))
    first = rest(world, TABLE, cube)
    assert penetrations(world) == []
    lower = posed(cube, first).pose.model_copy(update={"position_m": (0, 0, TABLE_TOP - 0.02)})
    world.become(box_room([TABLE, cube.model_copy(update={"pose": lower})]), [11])
    (violation,) = penetrations(world)
    assert violation.objects == (10, 11)
    assert violation.measured == pytest.approx(0.02, abs=0.002)


def test_a_world_that_starts_anew_is_the_scene_as_if_loaded(
    library: Library, client: Client
) -> None:
    """Awake, where the scene has it, and touching nothing before the first step."""
    world = World(library, client)
    stands, hangs = thing(11, "cube_01", (0, 0, TABLE_TOP)), thing(12, "cube_02", (1, 0, 0.5))
    world.become(box_room([TABLE, stands, hangs]), [11, 12])
    client.step(60)
    for one in world.loose.values():
        client.sleep(one.body)
    assert world.pose(12).position_m[2] < 0.4
    assert client.contacts()
    world.start_anew()
    assert world.pose(12).position_m == pytest.approx((1, 0, 0.5), abs=1e-9)
    client.detect()
    met = {frozenset((point.a, point.b)) for point in client.contacts()}
    assert met == {frozenset(world_body(world, k) for k in (10, 11))}
    found = moving(world)
    assert [violation.objects for violation in found] == [(12,)]
    world.start_anew()
    assert moving(world) == found


def world_body(world: World, key: int) -> int:
    (body,) = (one.body for one in world.placed if one.owner == key)
    return body


def test_the_same_calls_give_the_same_bytes(library: Library, client: Client) -> None:
    def play() -> list[Any]:
        world = World(library, client)
        cubes = [thing(11 + k, "cube_01", (0.02 * k, 0.03, 0.75 + 0.21 * k)) for k in range(3)]
        first = rest(world, TABLE, *cubes)
        return [first, rest(world, TABLE, *(posed(c, first) for c in cubes[1:]))]

    once = play()
    rest(World(library, client), thing(5, "cube_02", (1, 1, 0.5)))
    assert play() == once


def test_a_loose_id_that_is_not_there_is_an_error(library: Library, client: Client) -> None:
    with pytest.raises(KeyError):
        World(library, client).become(box_room([TABLE]), [99])
