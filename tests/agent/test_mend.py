"""Actions on a scene: what they need, what they do, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.agent.mend import ACTIONS, Action, Mending, mending_of, remedy_planner, score
from sdgen.agent.mend.hands import Hands
from sdgen.agent.mend.leaves import shut_in
from sdgen.dataset import Dataset
from sdgen.errors import InputError
from sdgen.facts import unheld
from sdgen.seeding import lane
from shapely.geometry import Point

from tests import toy
from tests.agent import mend_scenes
from tests.agent.mend_scenes import ADULTS, TODDLER, holding, mending
from tests.shipped import shipped_library

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def made(shared):
    with mend_scenes.scenes_and_client(shared) as both:
        yield both


@pytest.fixture
def fresh(made):
    """The scene with food, drawers and a full home, as it was made."""
    scenes, client = made
    return mending(scenes[1], client)


def loose(one: Mending, *, on: bool = True) -> list[int]:
    """Loose things that bear nothing and are in nothing, on furniture."""
    facts = one.facts
    bears = {r.target_id for key in facts.bodies for r in (*facts.on(key), *facts.inside(key))}
    return [
        key
        for key, body in facts.bodies.items()
        if not body.item.fixed
        and key not in bears
        and not any(r.holds for r in facts.inside(key))
        and any(r.target_id in facts.bodies for r in facts.on(key)) == on
    ]


def refused(one: Mending, text: str, **action) -> None:
    """The action is refused with this text, counted, and nothing has changed."""
    before, count = one.state, len(one.outcomes)
    outcome = one.do(action)
    assert not outcome.done
    assert text in (outcome.refused or "")
    assert one.state is before
    assert len(one.outcomes) == count + 1
    assert (outcome.removed, outcome.caused, outcome.walked_m) == ((), (), 0.0)


def test_what_is_no_action_is_refused(fresh):
    refused(fresh, "no action 'opne' (did you mean 'open'", action="opne", object_id=1)
    refused(fresh, "no action: ", object_id=3)
    refused(fresh, "no action: object_id", action="grab", object_id="the mug")
    refused(fresh, "no action: ", action="grab", object_id=1, more=2)
    assert not fresh.do("grab the mug").done  # type: ignore[arg-type]
    assert score(fresh).refused == len(fresh.outcomes) == 5


@pytest.mark.parametrize(
    "word", [word for word in ACTIONS if word not in ("put_down", "move_away")]
)
def test_ids_that_are_not_there_are_refused(fresh, word):
    key = next(k for k in loose(fresh) if fresh.do({"action": "go_to", "object_id": k}).done)
    in_hand = word.startswith(("put_on", "put_in", "throw"))
    if in_hand:
        assert fresh.do({"action": "grab", "object_id": key}).done
    for wrong in (-1, 0, 70_000, 10**30):
        ids = {"target_id": wrong} if in_hand else {"object_id": wrong}
        refused(fresh, f"no object {wrong} in this scene", action=word, **ids)
    if word != "throw_away":
        refused(fresh, "it needs the id of an object", action=word)


def test_what_is_out_of_reach_is_refused_until_one_goes_there(fresh):
    far = max(
        loose(fresh),
        key=lambda k: math.dist(fresh.place.point, fresh.facts.bodies[k].center[:2].tolist()),
    )
    refused(fresh, "is out of reach: go there first", action="grab", object_id=far)
    gone = fresh.do({"action": "go_to", "object_id": far})
    assert gone.done
    assert gone.walked_m > 0
    assert fresh.do({"action": "grab", "object_id": far}).done
    assert fresh.in_hand == far


def test_the_hand_holds_one_thing_and_only_that_is_put(fresh):
    keys = loose(fresh)
    refused(fresh, "the hand is empty", action="put_down")
    assert Hands(fresh).fetch(keys[0])
    assert keys[0] not in fresh.facts.bodies
    other = next(k for k in keys[1:] if fresh.do({"action": "go_to", "object_id": k}).done)
    refused(fresh, "the hand is full", action="grab", object_id=other)
    refused(fresh, f"{keys[0]} is in the hand", action="grab", object_id=keys[0])
    refused(fresh, f"not {other}", action="put_down", object_id=other)
    assert fresh.do({"action": "put_down"}).done
    floors = {one.id for one in fresh.scene.home.structures if one.category == "floor"}
    assert floors & set(fresh.facts.holds(keys[0], "ON"))


def test_what_is_fixed_or_bears_something_is_not_grabbed(fresh):
    (bed, *_) = fresh.facts.ids_of(["bed", "sofa", "stove"])
    assert fresh.do({"action": "go_to", "object_id": bed}).done
    refused(fresh, "is fixed", action="grab", object_id=bed)
    bodies = fresh.facts.bodies
    alone = [
        (on[0].target_id, key)
        for key in sorted(bodies)
        if len(on := [r for r in fresh.facts.on(key) if r.holds]) == 1
        if not any(r.holds for r in fresh.facts.inside(key))
    ]
    # From under a mug a coaster can be drawn, from under a bowl a plate: what is let pass for
    # touching is as much as the bowl is above the table.
    board = next(
        under
        for under, key in alone
        if under in bodies and not bodies[under].item.fixed
        if bodies[key].low[2] - bodies[under].low[2] > 0.015
    )
    assert fresh.do({"action": "go_to", "object_id": board}).done
    refused(fresh, "rests on", action="grab", object_id=board)
    # A planner's hands put aside what is on it.
    assert Hands(fresh).fetch(board)


def test_nothing_is_got_out_of_or_put_into_what_is_shut(fresh):
    facts = fresh.facts
    key, around = next(
        (key, around)
        for key in facts.bodies
        if (around := shut_in(facts, key)) is not None
        and len(facts.bodies[around].info.containers) == 1
    )
    assert fresh.do({"action": "go_to", "object_id": around}).done
    refused(fresh, "is shut in by", action="grab", object_id=key)
    assert fresh.do({"action": "open", "object_id": around}).done
    refused(fresh, "stands open already", action="open", object_id=around)
    assert fresh.do({"action": "grab", "object_id": key}).done
    assert fresh.do({"action": "close", "object_id": around}).done
    refused(fresh, "is shut already", action="close", object_id=around)
    refused(fresh, "is shut: open it first", action="put_in", target_id=around)
    assert fresh.do({"action": "open", "object_id": around}).done
    assert fresh.do({"action": "put_in", "target_id": around}).done
    assert around in fresh.facts.holds(key, "INSIDE")


def test_parts_are_named_or_refused(fresh):
    (fridge, *_) = fresh.facts.ids_of(["fridge"])
    assert fresh.do({"action": "go_to", "object_id": fridge}).done
    refused(fresh, "(there is: ", action="open", object_id=fridge, part="oven")
    (bed, *_) = fresh.facts.ids_of(["stool", "chair", "coffee_table"])
    assert fresh.do({"action": "go_to", "object_id": bed}).done
    refused(fresh, "has nothing that opens or shuts", action="open", object_id=bed)
    assert Hands(fresh).fetch(loose(fresh)[0])
    assert fresh.do({"action": "go_to", "object_id": bed}).done
    refused(fresh, "has no hollow", action="put_in", target_id=bed)


def test_only_what_is_on_is_switched_off_and_only_spills_are_wiped_up(made):
    scenes, client = made
    one = mending(scenes[2], client)
    stove = holding(scenes[2:], "stove_on")[1][0]
    candle = holding(scenes[2:], "candle_on")[1][0]
    puddle = holding(scenes[2:], "spill")[1][0]
    for key, word, wrong in (
        (stove, "switch_off", "put_out"),
        (candle, "put_out", "switch_off"),
        (puddle, "wipe_up", "sweep_up"),
    ):
        assert one.do({"action": "go_to", "object_id": key}).done
        refused(one, "is nothing to", action=wrong, object_id=key)
        refused(one, "is nothing to", action="empty", object_id=key)
        if word != "wipe_up":
            refused(one, "is nothing to", action="wipe_up", object_id=key)
        else:
            refused(one, "is fixed", action="grab", object_id=key)
        assert one.do({"action": word, "object_id": key}).removed
        gone = "no object" if word == "wipe_up" else "is nothing to"
        refused(one, gone, action=word, object_id=key)


def test_contents_travel_with_a_drawer(fresh):
    facts = fresh.facts
    chest, part, key = next(
        (owner, hollow.name, key)
        for owner in facts.ids_of(["dresser"])
        for key in facts.bodies
        if any(r.holds and r.target_id == owner for r in facts.inside(key))
        for hollow in facts.bodies[owner].info.containers
        if facts.part_holding(key, owner) == hollow.part and hollow.closed_by == hollow.part
    )
    at_first = np.array(facts.bodies[key].item.pose.position_m)
    assert fresh.do({"action": "go_to", "object_id": chest}).done
    refused(fresh, "is shut in by", action="grab", object_id=key)
    assert fresh.do({"action": "open", "object_id": chest, "part": part}).done
    there = np.array(fresh.facts.bodies[key].item.pose.position_m)
    assert np.linalg.norm(there - at_first) > 0.1
    assert there[2] == at_first[2]
    assert chest in fresh.facts.holds(key, "INSIDE")
    assert fresh.do({"action": "close", "object_id": chest, "part": part}).done
    back = np.array(fresh.facts.bodies[key].item.pose.position_m)
    assert np.linalg.norm(back - at_first) < 1e-4


def test_what_is_in_the_hand_is_still_what_it_was(made):
    scenes, client = made
    scene, pair = holding(scenes, "broken_item")
    one = mending(scene, client)
    assert Hands(one).fetch(pair[0])
    assert pair in one.pairs
    assert score(one).removed == 0
    # Rubbish is carried out from the front door alone.
    refused(one, "no front door is within reach", action="throw_away")
    (door,) = one.facts.ids_of(["front_door"])
    assert one.do({"action": "go_to", "object_id": door}).done
    out = one.do({"action": "throw_away"})
    assert out.removed == (pair,)
    assert one.in_hand is None
    assert Hands(one).fetch(loose(one)[0])
    assert one.do({"action": "go_to", "object_id": door}).done
    refused(one, "is no rubbish", action="throw_away")


def test_what_no_way_leads_to_is_refused(made):
    scenes, client = made
    x, y, _ = scenes[0].scene.agent_start.position_m
    ring = ((x - 0.1, y - 0.1), (x + 0.1, y - 0.1), (x + 0.1, y + 0.1), (x - 0.1, y + 0.1))
    for free in ((ring,), ()):
        alone = mending(scenes[0], client)
        scene = alone.scene.model_copy(update={"free_space": free})
        one = Mending(scene, TODDLER, mend_scenes.CATALOG, shipped_library(), client)
        far = max(
            one.facts.bodies,
            key=lambda k: math.dist((x, y), one.facts.bodies[k].center[:2].tolist()),
        )
        refused(one, "no place that can be got to", action="go_to", object_id=far)
        left = remedy_planner(one)
        assert left
        assert all("no place that can be got to" in each.why for each in left)
        assert score(one).refused > 0


def test_nobody_reaches_through_walls(fresh):
    arms = fresh.setting.arms
    rooms = {room.id: room for room in fresh.scene.home.rooms}
    checked = 0
    for key, body in fresh.facts.bodies.items():
        there = arms.beside(fresh.place, body.footprint, body.item.room_id, key)
        if there is None or body.item.room_id not in rooms:
            continue
        assert arms.floor.holds(there.point)
        assert body.footprint.distance(Point(there.point)) <= arms.reach_m
        checked += arms.floor.room_at(there.point) == body.item.room_id
    assert checked > 0.9 * len(fresh.facts.bodies)


def bleach(made, household, shuts):
    """Cleaning products put into the cupboard under the sink."""
    scenes, client = made
    scene, pair = holding(scenes, "poison_cleaning")
    one = mending(scene, client, household)
    (sink,) = one.facts.ids_of(["sink_cabinet"])
    assert Hands(one).fetch(pair[0])
    for action in ({"action": "go_to", "object_id": sink}, {"action": "open", "object_id": sink}):
        assert one.do(action).done
    assert one.do({"action": "put_in", "target_id": sink}).done
    if shuts:
        assert one.do({"action": "close", "object_id": sink}).done
    return one, pair


def test_bleach_under_the_sink_of_a_family_with_toddlers_is_caught(made):
    one, pair = bleach(made, TODDLER, shuts=False)
    # The leaf stands open: a child gets at it, and at all else that is in there.
    assert one.pairs[pair]
    assert score(one).left_reported >= 1
    one, pair = bleach(made, TODDLER, shuts=True)
    # Behind a shut leaf the hazard is gone, but nobody advises it where children live.
    assert pair not in one.pairs
    assert (score(one).unadvised, score(one).unadvised_reported) == (1, 1)
    one, pair = bleach(made, ADULTS, shuts=True)
    assert (score(one).unadvised, score(one).unadvised_reported) == (1, 0)


def test_any_sequence_of_actions_leaves_a_sound_scene(made):
    scenes, client = made
    one = mending(scenes[1], client)
    rng = lane(5, 0, "test")
    words, ids = [*ACTIONS, "", "jump"], [*one.facts.bodies, 0, -3, 70_000]
    here = one.scene.home.rooms[0].id
    for _ in range(150):
        key = ids[int(rng.integers(len(ids)))]
        one.do({"action": "go_to", "object_id": key if rng.random() < 0.8 else here})
        for _ in range(3):
            word = words[int(rng.integers(len(words)))]
            target = key if rng.random() < 0.8 else None
            before = one.state
            outcome = one.do(Action(action=word, object_id=target, target_id=key))
            if word in ("put_on", "put_in", "put_down", "move_away", "throw_away"):
                outcome = one.do(Action(action=word, target_id=key))
            assert outcome.done or one.state is before or len(one.outcomes) > 1
            assert outcome.done == (outcome.refused is None)
    assert {o.action.action for o in one.outcomes if o.done} >= {"go_to", "grab", "open"}
    assert any(o.done and o.action.action.startswith("put") for o in one.outcomes)
    assert not set(unheld(one.facts)) - set(unheld(one.start.facts))
    objects = [item.id for item in one.scene.objects]
    assert objects == sorted(set(objects))
    assert score(one).actions == len(one.outcomes)


def test_other_models_are_refused(tmp_path, made):
    data = Dataset(toy.build(tmp_path / "toy"))
    with pytest.raises(InputError, match="other models than the ones at hand"):
        mending_of(data, data[1], shipped_library(), made[1])
