"""Tries do not depend on one another, and what goes wrong in one is a record."""

from collections import Counter
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import pytest
from sdgen.catalog.predicate import Verdict
from sdgen.engines.protocol import Outcome
from sdgen.engines.tally import Tally
from sdgen.errors import SceneRejected
from sdgen.facts import bodies_of
from sdgen.hazards.certify import Positive, Survey
from sdgen.hazards.placing import Injected
from sdgen.home.layout import Intent
from sdgen.options import BuildOptions
from sdgen.pipeline import attempt as attempt_module
from sdgen.pipeline import scene as scene_module
from sdgen.pipeline.attempt import _unproved, placed, staying_bodies
from sdgen.pipeline.contents import Contents, Culprit, Reduced, culprits, lost, without
from sdgen.pipeline.finish import with_history
from sdgen.pipeline.rest import Rested
from sdgen.pipeline.scene import (
    HOME_ATTEMPTS,
    HOME_TRIES,
    OVERLAP_HOMES,
    OVERLAP_TRIES,
    furnish_for,
    hopeless_of,
    make_scene,
)
from sdgen.pipeline.spec import draw_spec, node_ids
from sdgen.pipeline.undoing import check_undone
from sdgen.rejection import Cause, Rejection
from sdgen.scene import causes_of
from sdgen.seeding import lane

from tests import toy

OVERLAP = Cause("proof", "accidental", "pills_by_bed", "pill_bottle", "poison_medication")
NO_REST = Cause("physics", "no_rest")
UNSEEN = Cause("views", "unseen", "spill")
FALLEN = Cause("physics", "fallen", "spill", "puddle")


@pytest.mark.slow
def test_an_attempt_repeated_alone_is_the_same(catalog, library):
    spec = draw_spec(3, catalog, BuildOptions(n=9, seed=5))
    home = furnish_for(spec, 0, catalog, library)
    in_turn = [placed(spec, home, 0, k) for k in range(4)]
    contents = [one for one in in_turn if not isinstance(one, Rejection)]
    assert len(contents) > 1
    assert all(one != other for one, other in pairwise(contents))
    for k in (3, 1):
        assert placed(spec, furnish_for(spec, 0, catalog, library), 0, k) == in_turn[k]


def test_hazards_find_their_places_in_another_order_after_the_first_try(catalog, monkeypatch):
    spec = draw_spec(0, catalog, BuildOptions(n=9, seed=5, hazards_min=4, hazards_max=4))
    home = SimpleNamespace(ids=frozenset(), layout=SimpleNamespace(copy=lambda ids: None))
    monkeypatch.setattr(attempt_module, "place_contents", lambda hazards, *_: tuple(hazards))
    orders = [placed(spec, home, 0, k) for k in range(8)]
    assert orders[0] == spec.hazards
    assert {tuple(sorted(order)) for order in orders} == {tuple(sorted(spec.hazards))}
    assert len(set(orders)) > 3
    assert orders[5] == placed(spec, home, 0, 5)


def test_ids_of_a_placement_are_random_and_none_of_the_homes():
    taken = set(range(1, 60000))
    ids = list(node_ids(lane(1, 2, "ids:0:0"), taken))
    assert sorted(ids) == list(range(60000, 65536))
    assert ids != sorted(ids)
    assert ids == list(node_ids(lane(1, 2, "ids:0:0"), taken))
    assert ids != list(node_ids(lane(1, 2, "ids:0:1"), taken))


def contents(**changes):
    """A table with milk on it, a cushion on the milk; the stove is lit as a lookalike."""
    table = toy.thing(77, "kitchen_table_01", (1.5, 1.0, 0), fixed=True)
    milk = toy.thing(40, "milk_carton_01", (1.4, 0.8, 0.74))
    cushion = toy.thing(9, "cushion_01", (1.4, 0.8, 0.94))
    stove = toy.thing(11, "stove_01", (3.5, 0.5, 0), variant="lit", fixed=True)
    rest = toy.thing(11, "stove_01", (3.5, 0.5, 0), fixed=True)
    values = {
        "items": {item.id: item for item in (table, milk, cushion, stove)},
        "intents": {40: Intent("ON", 77), 9: Intent("ON", 40)},
        "anomalies": {},
        "lookalikes": {11: Injected("stove_on", 11, rest)},
    }
    return Contents(**(values | changes))


def offence(there, object_id):
    return {object_id: there.objection(object_id, "physics", "would_not_stand")}


def test_what_stands_on_a_thing_goes_with_it():
    there = contents()
    reduced = without(there, offence(there, 40))
    assert isinstance(reduced, Reduced)
    assert sorted(reduced.contents.items) == [11, 77]
    assert reduced.contents.intents == {}
    assert [r.cause.check for r in reduced.taken_away] == ["would_not_stand", "lost_its_support"]
    assert sorted(there.items) == [9, 11, 40, 77]  # a value: what was there is as it was


def test_a_lookalike_by_state_is_switched_back_not_taken_away():
    there = contents()
    reduced = without(there, offence(there, 11))
    assert reduced.contents.items[11].variant == "default"
    assert reduced.contents.lookalikes == {}
    assert sorted(reduced.contents.items) == sorted(there.items)


def test_a_try_that_lost_what_a_household_always_has_is_rejected():
    there = contents()
    kitchen = toy.catalog()
    always = kitchen.model_copy(
        update={
            "categories": tuple(
                category.model_copy(update={"always": category.name == "milk_carton"})
                for category in kitchen.categories
            )
        }
    )
    for going, check in ((40, "always_there"), (9, None)):
        reduced = without(there, offence(there, going))
        rejection = lost(there, reduced.contents, always)
        assert (rejection and rejection.cause.check) == check
    assert lost(there, without(there, offence(there, 40)).contents, kitchen) is None


@pytest.mark.parametrize(("culprit", "hazard"), [(9, "spill"), (77, None)])
def test_an_anomaly_or_furniture_at_fault_rejects_the_try(culprit, hazard):
    there = contents()
    there = replace(there, anomalies={9: Culprit("spill", ("spill",))})
    rejection = without(there, offence(there, culprit))
    assert isinstance(rejection, Rejection)
    assert rejection.cause.hazard == hazard
    assert rejection.objects == (culprit,)
    # What an anomaly stands on cannot go either.
    assert isinstance(without(there, offence(there, 40)), Rejection)


def test_a_twin_that_is_not_benign_is_a_rejection_not_a_crash():
    made = toy.bundle(3)
    assert not isinstance(
        check_undone(made.scene, made.anomalies.anomalies, toy.catalog(), toy.infos()), Rejection
    )
    kept = made.anomalies.anomalies[1:]
    left = made.anomalies.anomalies[0]
    rejection = check_undone(made.scene, kept, toy.catalog(), toy.infos())
    assert isinstance(rejection, Rejection)
    assert rejection.cause == Cause("twin", "not_benign", None, left.category, left.hazard)
    assert rejection.objects == (left.object_id,)


def test_a_twin_does_not_tell_why_tries_failed():
    made = replace(toy.bundle(3), twin=toy.twin(toy.bundle(3)))
    told = with_history(made, 2, 7, {OVERLAP: 6})
    assert causes_of(told.physics.rejections) == {OVERLAP: 6}
    assert (told.physics.home_attempts, told.physics.placement_attempts) == (2, 7)
    assert told.twin.physics.rejections == ()
    assert told.twin.physics.placement_attempts == 7


def test_only_the_same_cause_in_nearly_all_tries_ends_them():
    assert hopeless_of({OVERLAP: OVERLAP_TRIES - 1}) is None
    assert hopeless_of({OVERLAP: OVERLAP_TRIES}) == OVERLAP
    assert hopeless_of({OVERLAP: 8, NO_REST: 2}) == OVERLAP
    assert hopeless_of({OVERLAP: 6, NO_REST: 6}) is None
    assert hopeless_of({NO_REST: HOME_TRIES - 1}) is None
    assert hopeless_of({NO_REST: HOME_TRIES}) == NO_REST
    # What no view shows wherever it is put, none will show at the next try.
    assert hopeless_of({UNSEEN: HOME_TRIES}) == UNSEEN
    assert hopeless_of({UNSEEN: 12, NO_REST: 8}) is None
    # Where it falls down, the next try puts it elsewhere.
    assert hopeless_of({FALLEN: 20}) is None


@pytest.mark.parametrize(
    ("cause", "homes", "tries"),
    [
        (OVERLAP, OVERLAP_HOMES, OVERLAP_HOMES * OVERLAP_TRIES),
        (NO_REST, HOME_ATTEMPTS, HOME_ATTEMPTS * HOME_TRIES),
        (UNSEEN, HOME_ATTEMPTS, HOME_ATTEMPTS * HOME_TRIES),
        (FALLEN, HOME_ATTEMPTS, HOME_ATTEMPTS * 20),
    ],
)
def test_what_is_hopeless_is_not_tried_a_hundred_times(cause, homes, tries, monkeypatch):
    rejected = Rejection(cause)
    monkeypatch.setattr(scene_module, "furnish_for", lambda *_: None)
    monkeypatch.setattr(scene_module, "overlooked", lambda *_: None)
    monkeypatch.setattr(scene_module, "out_of_view", lambda *_: None)
    monkeypatch.setattr(scene_module, "try_scene", lambda *_: rejected)
    with pytest.raises(SceneRejected) as caught:
        make_scene(0, toy.catalog(), None, BuildOptions(), client=object())
    assert caught.value.causes == Counter({cause: tries})
    # The report's share of accepted homes counts those that were tried, not those allowed.
    tally = Tally(1)
    tally.take_failed(Outcome(0, error=caught.value))
    assert tally.report(Path(), 0.0, 0.0, "none").home_attempts == homes


def test_an_open_fridge_is_in_the_way_and_a_dropped_thing_is_picked_up():
    bodies = {
        body.item.id: body
        for body in bodies_of(
            [
                toy.thing(11, "stove_01", (3.5, 0.5, 0), variant="lit", fixed=True),
                toy.thing(40, "milk_carton_01", (1.4, 0.8, 0)),
                toy.thing(9, "cushion_01", (2.4, 0.8, 0)),
            ],
            toy.infos(),
        )
    }
    assert [body.item.id for body in staying_bodies(bodies, {11, 40})] == [11, 9]


def positive(object_id, hazard, value=True, sure=True):
    return Positive(object_id, hazard, Verdict(value, sure))


def proved_of(positives):
    """What ``_unproved`` says where milk was put for one hazard and drawn for another, a stove lit
    for the first, and a cushion lies about."""
    there = contents(
        lookalikes={},
        anomalies=culprits(
            [Injected("warm_milk", 40, None, (11,)), Injected("refrigerated_food_out", 40, None)]
        ),
    )
    facts = SimpleNamespace(bodies={})
    rested = Rested(there, facts, None, {})
    return _unproved(rested, Survey(tuple(positives), 9), None)


def test_what_is_put_for_one_hazard_may_be_others_too():
    """The drawn pairs must hold; others of the same objects are implied, of all else a mistake."""
    drawn = [positive(40, "warm_milk"), positive(40, "refrigerated_food_out")]
    assert proved_of(drawn) == {}
    assert proved_of([*drawn, positive(11, "stove_on"), positive(40, "tripping_hazard")]) == {}
    (missed,) = proved_of(drawn[:1]).values()
    assert (missed.cause.check, missed.cause.hazard) == ("not_proved", "warm_milk")
    (accident,) = proved_of([*drawn, positive(9, "tripping_hazard")]).values()
    assert (accident.cause.check, accident.cause.hazard) == ("accidental", None)
    (doubt,) = proved_of([*drawn, positive(11, "stove_on", sure=False)]).values()
    assert (doubt.cause.check, doubt.cause.other) == ("in_doubt", "stove_on")
    unsure = [drawn[0], positive(40, "refrigerated_food_out", sure=False)]
    (missed,) = proved_of(unsure).values()
    assert missed.cause.check == "not_proved"


def test_culprits_are_all_that_was_put_changed_and_brought():
    first = Injected("warm_milk", 40, None, (11,))
    assert culprits([first, Injected("stove_on", 11, None)]) == {
        40: Culprit("warm_milk", ("warm_milk",)),
        11: Culprit("warm_milk", ("stove_on",)),
    }
