"""What does not stand as it was meant to is named, furniture too."""

import math

import pytest
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.settle import TILT_LIMIT_RAD, Settled
from sdgen.physics.world import World
from sdgen.pipeline.contents import Contents
from sdgen.pipeline.rest import come_to_rest, will_not_stay
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import draw_spec
from sdgen.rejection import Cause
from sdgen.scene import ObjectInstance, Pose
from sdgen.vocabulary import DRIFT_LIMIT_M


@pytest.fixture(scope="module")
def home(catalog, library):
    return furnish_for(draw_spec(3, catalog, BuildOptions(n=9, seed=5)), 0, catalog, library)


def rested(home, library, items):
    with Client() as client:
        contents = Contents(items, {}, {}, {})
        return come_to_rest(0, home, contents, False, library, World(library, client))


def test_furniture_as_it_was_arranged_stands(home, library):
    assert rested(home, library, home.layout.items).offenders == {}


def test_furniture_in_the_air_is_an_offence(home, library):
    items = dict(home.layout.items)
    key, item = next((k, item) for k, item in items.items() if item.category == "wardrobe")
    x, y, z = item.pose.position_m
    pose = item.pose.model_copy(update={"position_m": (x, y, z + 0.04)})
    items[key] = item.model_copy(update={"pose": pose})
    (offence,) = rested(home, library, items).offenders.values()
    assert offence.cause == Cause("physics", "in_the_air", None, "wardrobe")
    assert offence.objects == (key,)
    assert offence.measured is not None
    assert offence.measured > offence.limit


def test_what_falls_is_an_offence_that_says_how_far(home, library):
    info = library.by_category("cutting_board")[0]
    room = home.context.home.rooms[0]
    x, y = home.agent_start.position_m[:2]
    board = ObjectInstance(
        id=60_000,
        category="cutting_board",
        asset=info.id,
        pose=Pose(position_m=(x, y, 0.4), quat_xyzw=(0, 0, 0, 1)),
        room_id=room.id,
        parts=info.variants["default"],
    )
    offenders = rested(home, library, {**home.layout.items, board.id: board}).offenders
    assert offenders[board.id].cause.check == "would_not_stand"
    # Nothing waits for what has left its place: how far it had come by then.
    assert DRIFT_LIMIT_M < offenders[board.id].measured < 0.4
    assert offenders[board.id].limit == DRIFT_LIMIT_M


def test_a_fall_is_told_before_a_tilt_and_what_only_moves_has_no_measure():
    settled = Settled({}, {1: 0.2, 2: 0.05, 3: 0.0}, {1: 1.5, 2: 1.0, 3: 0.1}, (), 1, (1, 2, 3))
    assert settled.beyond(1) == (0.2, DRIFT_LIMIT_M)
    assert settled.beyond(2) == (1.0, TILT_LIMIT_RAD)
    assert settled.beyond(3) is None


def staying(home, library, items):
    with Client() as client:
        world = World(library, client)
        world.become(home.scene(0, items), [k for k, item in items.items() if not item.fixed])
        return will_not_stay(Contents(items, {}, {}, {}), world)


def test_what_stands_on_an_edge_is_an_offence_before_it_has_tipped(home, library):
    (asset,) = [a for a in library.by_category("cutting_board") if a.id == "cutting_board_01"]
    room = home.context.home.rooms[0]
    x, y = home.agent_start.position_m[:2]
    # On its long edge, ten degrees off the upright: it falls, but slowly at first.
    half = math.radians(80) / 2
    pose = Pose(
        position_m=(x, y, asset.extents_m[0] / 2),
        quat_xyzw=(0.0, math.sin(half), 0.0, math.cos(half)),
    )
    board = ObjectInstance(
        id=60_000,
        category="cutting_board",
        asset=asset.id,
        pose=pose,
        room_id=room.id,
        fixed=False,
        parts=asset.variants["default"],
    )
    items = {**home.layout.items, board.id: board}
    found = staying(home, library, items)
    assert staying(home, library, home.layout.items) == {}
    assert list(found) == [board.id]
    assert found[board.id].cause.check in ("moves", "tips")
    assert found[board.id].measured > found[board.id].limit
