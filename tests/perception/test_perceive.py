"""A perceived scene: what is given, what is made out, how it fails; twins fail alike."""

import pytest
from sdgen.hazards.certify import facts_of, survey
from sdgen.perception import Perception
from sdgen.perception.noise import Draws
from sdgen.truth import build_graph

from tests import toy
from tests.perception.toys import facts_about, kinds, perceived, views_of, without_part

STOVE, FRIDGE, TABLE, MILK, KNIFE, HIGH_KNIFE = 11, 305, 77, 4000, 600, 512


def ids(seen):
    return {item.id for item in seen.scene.objects}


def true_graph(made):
    return build_graph(made, toy.infos(), toy.catalog(), facts_of(made, toy.infos(), toy.catalog()))


def test_relations_of_what_is_seen_are_the_true_ones():
    made = toy.scene(3)
    seen = perceived(made)
    assert {TABLE, MILK, KNIFE, HIGH_KNIFE, STOVE, FRIDGE} <= ids(seen)
    home = {room.id for room in made.home.rooms} | {s.id for s in made.home.structures}
    true = facts_about(true_graph(made), ids(seen) | home)
    said = facts_about(seen.graph, ids(seen) | home)
    assert said == true
    assert {(MILK, TABLE, "ON"), (KNIFE, TABLE, "ON"), (HIGH_KNIFE, 30, "ON")} <= said


def test_boxes_are_measured_not_copied():
    made = toy.scene(3)
    true, said = facts_of(made, toy.infos(), toy.catalog()), perceived(made).facts
    for key in (TABLE, MILK):
        assert said.bodies[key].low == pytest.approx(true.bodies[key].low, abs=0.02)
        assert said.bodies[key].high == pytest.approx(true.bodies[key].high, abs=0.02)
    # Its back is in the wall, and no camera is behind it.
    stove = said.bodies[STOVE]
    assert (stove.high - stove.low)[0] < 0.3


def test_what_is_shut_in_or_small_is_not_seen():
    shut = perceived(toy.scene(0))
    assert FRIDGE in ids(shut)
    assert MILK not in ids(shut)
    most = max(int((view.instance == KNIFE).sum()) for view in views_of(toy.scene(3)))
    scale = 640 * 480 / (320 * 240)
    assert KNIFE in ids(perceived(toy.scene(3), pixels=int(most * scale)))
    assert KNIFE not in ids(perceived(toy.scene(3), pixels=int(most * scale) + 10))


def test_hidden_lower_ends_stand_on_what_is_below():
    # The milk's lower half is hidden: only rows above its middle are left of it.
    made = toy.scene(3)
    views = views_of(made)
    view = views[0]
    rows = (view.instance == MILK).any(axis=1).nonzero()[0]
    middle = int(rows.mean())
    hidden = (view.instance == MILK).copy()
    hidden[:middle] = False
    view.instance[hidden] = 9
    view.depth_mm[hidden] = 300  # something just before the camera
    seen = perceived(made, views)
    assert seen.facts.bodies[MILK].low[2] == pytest.approx(0.74, abs=0.005)
    assert (MILK, TABLE, "ON") in facts_about(seen.graph, ids(seen))


def test_states_are_known_by_the_part_that_shows_them():
    made = toy.scene(1)
    assert perceived(made).facts.states(STOVE) == ("ON",)
    blind = [without_part(view) for view in views_of(made)]
    assert perceived(made, blind).facts.states(STOVE) == ()
    assert perceived(made, states=False).facts.states(STOVE) == ()


def test_predicates_hold_of_what_was_seen():
    seen = perceived(toy.scene(3))
    found = survey(seen.facts, seen.catalog).positives
    assert {(p.object_id, p.hazard) for p in found} == {
        (STOVE, "stove_on"),
        (KNIFE, "sharp_object"),
        (MILK, "refrigerated_food_out"),
    }


def test_nothing_of_the_truth_but_ids_and_the_plan_is_in_it():
    made = toy.scene(3)
    seen = perceived(made)
    assert all(node.prefab_name == "" for node in seen.graph.nodes)
    assert all(item.asset.startswith("perceived_") for item in seen.scene.objects)
    assert all(item.variant == "default" for item in seen.scene.objects)
    assert seen.scene.home == made.home


def test_zones_of_doors_that_were_not_seen_have_no_source():
    made = toy.scene(3)
    seen = perceived(made, views_of(made)[1:])
    assert 42 not in ids(seen)
    assert any(zone.kind == "doorway" for zone in seen.scene.zones)
    assert all(zone.source_id in ids(seen) | {None} for zone in seen.scene.zones)
    assert seen.graph.nodes  # and nothing asks for the door


def test_no_view_at_all_is_an_empty_home():
    seen = perceived(toy.scene(3), [])
    assert seen.scene.objects == ()
    assert {node.id for node in seen.graph.nodes} >= {100, 101}


def test_shares_are_missed_and_confused():
    draws = Draws(Perception(missed=0.3, confused=0.3), 5)
    missed = [draws.missed(k) for k in range(1, 2001)]
    assert sum(missed) / 2000 == pytest.approx(0.3, abs=0.03)
    names = [draws.name(k, "knife", kinds()) for k in range(1, 2001)]
    wrong = sum(name != "knife" for name in names) / 2000
    assert wrong in (0, pytest.approx(0.3, abs=0.03))
    assert not any(Draws(Perception(), 5).missed(k) for k in range(1, 50))


def test_all_missed_is_nothing():
    assert perceived(toy.scene(3), missed=1.0).scene.objects == ()


def test_failures_are_drawn_the_same_every_time_and_otherwise_by_another_seed():
    made, views = toy.scene(3), views_of(toy.scene(3))
    once = perceived(made, views, missed=0.5)
    assert once.scene == perceived(made, views, missed=0.5).scene
    others = {frozenset(ids(perceived(made, views, missed=0.5, seed=k))) for k in range(6)}
    assert len(others) > 1


def test_twins_fail_alike():
    made = toy.scene(3)
    twin = toy.remedied(toy.bundle(3)).scene
    assert twin.index == made.index
    for seed in range(8):
        how = {"missed": 0.4, "confused": 0.4, "seed": seed}
        first, second = perceived(made, **how), perceived(twin, views_of(twin), **how)
        kept = {TABLE, STOVE, FRIDGE, HIGH_KNIFE, 30, 42}
        assert ids(first) & kept == ids(second) & kept
        names = [{i.id: i.category for i in seen.scene.objects} for seen in (first, second)]
        both = names[0].keys() & names[1].keys()
        assert {k: names[0][k] for k in both} == {k: names[1][k] for k in both}


def test_a_confused_thing_is_taken_for_one_of_its_kind():
    by_name = {category.name: category for category in toy.catalog().categories}
    draws = Draws(Perception(confused=1.0), 1)
    for name in ("kitchen_table", "knife", "stove"):
        for object_id in range(20):
            other = by_name[draws.name(object_id, name, kinds())]
            assert other.superclass == by_name[name].superclass
            assert other.kind == by_name[name].kind


def test_coarse_classes_are_superclasses_and_everything_still_runs():
    seen = perceived(toy.scene(3), coarse=True)
    by_id = {node.id: node for node in seen.graph.nodes}
    assert by_id[MILK].class_name == by_id[MILK].category == "Food"
    assert (MILK, TABLE, "ON") in facts_about(seen.graph, ids(seen))
    assert survey(seen.facts, seen.catalog).positives == ()


@pytest.mark.parametrize(
    "how",
    [
        {"pixels": 0},
        {"missed": 1.5},
        {"confused": -0.1},
        {"views": (-1,)},
        {"views": "all"},
        {"blur": 1},
    ],
)
def test_senseless_perception_is_refused(how):
    with pytest.raises(ValueError, match="validation error"):
        Perception(**how)
