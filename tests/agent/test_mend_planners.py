"""Every remedy, run as actions, clears its anomaly; a careless planner is caught."""

from __future__ import annotations

import pytest
from sdgen.agent.mend import careless_planner, remedy_planner, score
from sdgen.hazards.twin import GONE, SET_BACK

from tests.agent import mend_scenes
from tests.agent.mend_scenes import CATALOG, TODDLER, holding, mending

RULES = [(hazard.id, number) for hazard in CATALOG.hazards for number in range(len(hazard.remedy))]

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def made(shared):
    with mend_scenes.scenes_and_client(shared) as both:
        yield both


@pytest.mark.parametrize(("hazard", "number"), RULES)
def test_a_remedy_run_as_actions_clears_its_anomaly_and_causes_none(made, hazard, number):
    scenes, client = made
    scene, pair = holding(scenes, hazard)
    rule = CATALOG.hazard(hazard).remedy[number]
    only = tuple(
        one.model_copy(update={"remedy": (rule,)}) if one.id == hazard else one
        for one in CATALOG.hazards
    )
    one = mending(scene, client, catalog=CATALOG.model_copy(update={"hazards": only}))
    assert pair in one.pairs
    before = set(one.pairs)
    assert remedy_planner(one, [pair]) == ()
    after = set(one.pairs)
    assert after < before
    assert pair not in after
    found = score(one)
    home = {item.category for item in scene.scene.objects}
    if rule.action in (*SET_BACK, *GONE, "move_away") or home & set(rule.targets):
        done = [o.action for o in one.outcomes if o.done]
        assert rule.action in {action.action for action in done}
        assert found.unadvised == 0
    # What is opened on the way is shut again.
    assert {o.action.object_id for o in one.outcomes if o.done and o.action.action == "open"} <= {
        o.action.object_id for o in one.outcomes if o.done and o.action.action == "close"
    }
    assert one.in_hand is None


@pytest.mark.parametrize("index", range(3))
def test_the_remedies_remove_all_and_cause_nothing(made, index):
    scenes, client = made
    one = mending(scenes[index], client)
    assert set(one.pairs) == {
        (anomaly.object_id, anomaly.hazard) for anomaly in scenes[index].anomalies.anomalies
    }
    assert remedy_planner(one) == ()
    found = score(one)
    assert found.anomalies == found.removed == len(scenes[index].anomalies.anomalies)
    assert (found.caused, found.caused_reported, found.left_reported, one.pairs) == (0, 0, 0, {})
    assert found.actions - found.refused <= 3 * found.remedy_actions


def test_the_same_seed_does_the_same(made):
    scenes, client = made
    first, again = (mending(scenes[0], client, seed=3) for _ in range(2))
    remedy_planner(first)
    remedy_planner(again)
    assert first.outcomes == again.outcomes
    assert first.scene == again.scene
    other = mending(scenes[0], client, seed=4)
    remedy_planner(other)
    assert other.scene != first.scene


@pytest.mark.parametrize("shuts", [False, True])
def test_a_careless_planner_is_caught_where_toddlers_live(made, shuts):
    scenes, client = made
    scores = []
    for scene in scenes:
        one = mending(scene, client, TODDLER)
        careless_planner(one, shuts=shuts)
        scores.append(score(one))
        held = {
            anomaly.object_id
            for anomaly in scene.anomalies.anomalies
            if anomaly.hazard.startswith("poison")
        }
        if held:
            told = sum(now for (key, _), now in one.pairs.items() if key in held)
            assert told + scores[-1].unadvised_reported >= 1
    bad = [one.left_reported + one.caused_reported + one.unadvised_reported for one in scores]
    assert sum(bad) >= 3
    assert sum(one.removed for one in scores) < sum(one.anomalies for one in scores)
