"""Every remedy of every hazard, in made homes: what it undoes is undone, all else stays."""

from dataclasses import replace
from itertools import chain

import pytest
from sdgen.cameras.nearest import cut_by_near_planes, drawn_boxes
from sdgen.cameras.pinhole import NEAR_M
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import RemedyRule
from sdgen.catalog.terms import AllTerm, CategoryTerm, HeightTerm, NotTerm, RelationTerm
from sdgen.facts import unheld
from sdgen.hazards.certify import certify, facts_of
from sdgen.hazards.twin import PUT, SET_BACK, TAKE_AWAY
from sdgen.library.states import undecided_states
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline import make_scene, remedied
from sdgen.pipeline.remedied import Tools, by_remedy, undone_records
from sdgen.pipeline.scene import furnish_for
from sdgen.pipeline.spec import draw_spec
from sdgen.rejection import Rejection
from sdgen.validate.twin_views import changed_ids

from tests.shipped import shipped_library

CATALOG = load_catalog()
#: Three scenes hold all hazards: they are drawn in turn.
OPTIONS = BuildOptions(n=3, seed=6, hazards_min=5, hazards_max=5, views=1, twins=True, toggles=True)
RULES = [(hazard.id, number) for hazard in CATALOG.hazards for number in range(len(hazard.remedy))]

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def client():
    with Client() as one:
        yield one


@pytest.fixture(scope="module")
def bundles(shared, library, client):
    """The scenes with their twins and toggles."""
    return shared.values(
        [f"remedies-{index}" for index in range(OPTIONS.n)],
        lambda name: make_scene(int(name[-1]), CATALOG, library, OPTIONS, client),
    )


def holding(bundles, hazard):
    """A scene with an anomaly of a hazard, and that anomaly."""
    return next(
        (bundle, one)
        for bundle in bundles
        for one in bundle.anomalies.anomalies
        if one.hazard == hazard
    )


@pytest.fixture(scope="module")
def tools_of(library, client):
    """What a scene was made with, by its number; furnished once."""
    known = {}

    def found(bundle):
        index = bundle.scene.index
        if index not in known:
            spec = draw_spec(index, CATALOG, OPTIONS)
            home = furnish_for(spec, bundle.physics.home_attempts - 1, CATALOG, library)
            assert not isinstance(home, Rejection)
            tools = Tools(home.context, home.layout, library, client, bundle.cameras)
            known[index] = spec, tools
        return known[index]

    return found


def pairs(scene):
    """Pairs that hold, each surely."""
    found = certify(scene, shipped_library().infos, CATALOG)
    assert all(one.verdict.sure and one.verdict.value for one in found)
    return {(one.object_id, one.hazard) for one in found}


def check_undone(bundle, scene, undone, stays):
    """Nothing of what was undone holds, all else does and is as it was, but for leaves that a
    remedy shut and what they took along."""
    infos = shipped_library().infos
    assert pairs(scene) == {(one.object_id, one.hazard) for one in stays}
    facts = facts_of(scene, infos, CATALOG)
    assert list(unheld(facts)) == []
    moved = {one.object_id for one in undone}
    shut = {one.target_id for one in undone if PUT.get(one.action) == "INSIDE"}
    known = facts_of(bundle.scene, infos, CATALOG)
    for key in set(changed_ids(bundle.scene, scene)) - moved:
        before, after = bundle.scene.object(key), scene.object(key)
        if key in shut:
            assert after.pose == before.pose
            assert "OPEN" in before.states
            assert all(v in (0.0, before.joints[name]) for name, v in after.joints.items())
        else:
            holders = {r.target_id for r in (*known.on(key), *known.inside(key))}
            assert holders & (moved | shut), (key, before.category)
            assert after.model_copy(update={"pose": before.pose}) == before
    for one in undone:
        assert one.removed == (one.object_id not in facts.bodies)
        if one.target_id is not None:
            related = facts.related(one.object_id, PUT[one.action])
            assert any(r.target_id == one.target_id and r.holds and r.sure for r in related)
        if not one.removed:
            item = scene.object(one.object_id)
            assert not undecided_states(infos[item.asset], item.variant, item.joints)
            assert one.moved == (item.pose != bundle.scene.object(one.object_id).pose)


@pytest.mark.parametrize(("hazard", "number"), RULES)
def test_a_remedy_undoes_its_hazard_and_nothing_else(hazard, number, bundles, tools_of):
    bundle, anomaly = holding(bundles, hazard)
    assert (anomaly.object_id, hazard) in pairs(bundle.scene)
    spec, tools = tools_of(bundle)
    # This remedy alone.
    rule = CATALOG.hazard(hazard).remedy[number]
    only = tuple(
        one.model_copy(update={"remedy": (rule,)}) if one.id == hazard else one
        for one in CATALOG.hazards
    )
    context = replace(tools.context, catalog=CATALOG.model_copy(update={"hazards": only}))
    staying = [one for one in bundle.anomalies.anomalies if one is not anomaly]
    known = facts_of(bundle.scene, tools.library.infos, CATALOG)
    found = by_remedy(
        bundle.scene, known, [anomaly], staying, replace(tools, context=context), spec.lane
    )
    assert found is not None
    (undone,) = undone_records(bundle.anomalies.anomalies, found)
    check_undone(bundle, found.facts.scene, [undone], staying)
    home = {item.category for item in bundle.scene.objects}
    if rule.action in SET_BACK or rule.action == "move_away" or home & set(rule.targets):
        possible = {rule.action, TAKE_AWAY} if rule.action == "put_on" else {rule.action}
        assert undone.action in possible
    assert undone.removed == (undone.target_id is None and undone.action not in SET_BACK)


@pytest.mark.parametrize("index", range(OPTIONS.n))
def test_a_twin_has_everything_undone(index, bundles):
    bundle = bundles[index]
    every, twin = bundle.anomalies.anomalies, bundle.twin
    assert [one.anomaly_id for one in twin.anomalies.undone] == [one.id for one in every]
    check_undone(bundle, twin.scene, twin.anomalies.undone, [])
    assert (twin.cameras, twin.household) == (bundle.cameras, bundle.household)
    loose = {str(item.id) for item in twin.scene.objects if not item.fixed}
    assert set(twin.physics.settled_drift_m) == loose


@pytest.mark.parametrize("index", range(OPTIONS.n))
def test_a_toggle_has_one_undone(index, bundles):
    bundle = bundles[index]
    every = {one.id: one for one in bundle.anomalies.anomalies}
    assert len(bundle.toggles) == len(every)
    for key, toggle in zip(every, bundle.toggles, strict=True):
        assert toggle.scene.id == f"{bundle.scene.id}-undo-{key}"
        assert [one.anomaly_id for one in toggle.anomalies.undone] == [key]
        left = {one.id: one for one in toggle.anomalies.anomalies}
        assert left.keys() == every.keys() - {key}
        for one in left.values():  # where it was measured again the proof may be another
            same = {"evidence": every[one.id].evidence, "remedy": every[one.id].remedy}
            assert one.model_copy(update=same) == every[one.id]
        staying = [one for one in every.values() if one.id != key]
        check_undone(bundle, toggle.scene, toggle.anomalies.undone, staying)


@pytest.mark.parametrize("index", range(OPTIONS.n))
def test_a_scene_and_its_twins_reach_before_no_near_plane(index, bundles, library):
    bundle = bundles[index]
    assert max(camera.near_m for camera in bundle.cameras) > NEAR_M
    for one in (bundle, bundle.twin, *bundle.toggles):
        assert not cut_by_near_planes(bundle.cameras, drawn_boxes(library, one.scene))


def test_what_would_come_before_a_lens_is_taken_away(bundles, library, client, monkeypatch):
    """Or what is as it was would be drawn from another depth on."""
    assert any(one.moved for one in bundles[0].twin.anomalies.undone)
    monkeypatch.setattr(remedied, "cut_by_near_planes", lambda cameras, boxes: True)
    made = make_scene(0, CATALOG, library, OPTIONS, client)
    for one in (made.twin, *made.toggles):
        assert not any(undone.moved for undone in one.anomalies.undone)
    for toggle, before in zip(made.toggles, bundles[0].toggles, strict=True):
        ids = [[undone.anomaly_id for undone in one.anomalies.undone] for one in (toggle, before)]
        assert ids[0] == ids[1]


def test_most_things_are_put_back_and_not_taken_away(bundles):
    every = list(chain.from_iterable(bundle.twin.anomalies.undone for bundle in bundles))
    assert sum(one.action == TAKE_AWAY for one in every) <= 0.2 * len(every)
    # Nothing of the thirteen classes is emptied.
    wanted = {*SET_BACK, "put_in", "wipe_up", "throw_away"} - {"empty"}
    assert {one.action for one in every} >= wanted


def test_twins_change_nothing_of_their_scene(bundles, library, client):
    plain = OPTIONS.model_copy(update={"twins": False, "toggles": False})
    alone = make_scene(0, CATALOG, library, plain, client)
    assert alone == replace(bundles[0], twin=None, toggles=())


@pytest.fixture(scope="module")
def low_candles(bundles, tools_of):
    """Lit candles that another hazard asks to be put higher, too, the lowest first: the scene, what
    it is undone with, and both anomalies."""
    found = [
        (one, bundle)
        for bundle in bundles
        for one in bundle.anomalies.anomalies
        if one.hazard == "candle_on"
    ]
    found.sort(key=lambda one: one[1].scene.object(one[0].object_id).pose.position_m[2])
    return [low_one(*one, tools_of) for one in found]


@pytest.fixture(scope="module")
def low_candle(low_candles):
    # The lowest there is: others leave no shelf or cupboard that is higher.
    return low_candles[0]


def low_one(lit, bundle, tools_of):
    spec, tools = tools_of(bundle)
    facts = facts_of(bundle.scene, tools.library.infos, CATALOG)
    heights = [facts.height(k) for k in facts.ids_of([lit.category])]
    limit = facts.height(lit.object_id)
    while any(abs(limit - height) < 0.05 for height in heights):
        limit += 0.02
    low = CATALOG.hazard("candle_on").model_copy(
        update={
            "id": "candle_low",
            "predicate": AllTerm(
                terms=(CategoryTerm(any_of=(lit.category,)), HeightTerm(max_m=limit))
            ),
            "remedy": (RemedyRule(action="put_on", targets=("wall_shelf", "bookshelf", "fridge")),),
        }
    )
    catalog = CATALOG.model_copy(update={"hazards": (*CATALOG.hazards, low)})
    tools = replace(tools, context=replace(tools.context, catalog=catalog))
    return bundle, spec, tools, (lit, lit.model_copy(update={"id": "a98", "hazard": low.id}))


def undo(low_candle, undone, staying):
    bundle, spec, tools, both = low_candle
    known = facts_of(bundle.scene, tools.library.infos, tools.context.catalog)
    rest = [one for one in bundle.anomalies.anomalies if one.object_id != both[0].object_id]
    found = by_remedy(bundle.scene, known, undone, [*rest, *staying], tools, spec.lane)
    assert found is not None
    return found, undone_records(both, found)


def test_a_thing_that_is_two_hazards_is_undone_for_both(low_candle):
    both = low_candle[3]
    found, records = undo(low_candle, both, [])
    assert both[0].object_id not in {key for key, _ in found.pairs}
    assert [(one.action, one.moved) for one in records] == [("put_out", True), ("put_on", True)]
    assert "ON" not in found.facts.scene.object(both[0].object_id).states


def test_of_two_hazards_of_a_thing_one_is_undone(low_candle):
    lit, low = low_candle[3]
    found, records = undo(low_candle, [lit], [low])
    assert (low.object_id, low.hazard) in found.pairs
    assert [(one.anomaly_id, one.action, one.moved) for one in records] == [
        (lit.id, "put_out", False)
    ]
    found, records = undo(low_candle, [low], [lit])
    assert (lit.object_id, lit.hazard) in found.pairs
    assert [(one.anomaly_id, one.action, one.moved) for one in records] == [("a98", "put_on", True)]
    assert "ON" in found.facts.scene.object(low.object_id).states


def test_what_is_put_elsewhere_twice_is_told_of_where_it_is(low_candles):
    """First onto a shelf, and since it is not shut away there, into a cupboard."""
    # Not every home has a cupboard that is higher, with room in it.
    assert any(shut_away(one) for one in low_candles)


def shut_away(low_candle):
    """Whether a candle is put into something; what is told of it then is true."""
    bundle, spec, tools, (lit, low) = low_candle
    away = CATALOG.hazard("candle_on").model_copy(
        update={
            "id": "candle_about",
            "predicate": AllTerm(
                terms=(
                    CategoryTerm(any_of=(lit.category,)),
                    NotTerm(term=RelationTerm(relation="INSIDE")),
                    HeightTerm(max_m=2.5),
                )
            ),
            "remedy": (
                RemedyRule(
                    action="put_in",
                    targets=(
                        "wall_cabinet",
                        "kitchen_counter",
                        "dresser",
                        "tv_stand",
                        "nightstand",
                        "wardrobe",
                        "bathroom_cabinet",
                    ),
                ),
            ),
        }
    )
    catalog = CATALOG.model_copy(update={"hazards": (*tools.context.catalog.hazards, away)})
    tools = replace(tools, context=replace(tools.context, catalog=catalog))
    anomalies = (low, low.model_copy(update={"id": "a99", "hazard": away.id}))
    found, records = undo((bundle, spec, tools, anomalies), anomalies, [])
    assert (low.object_id, away.id) not in found.pairs
    if [one.action for one in records] != ["put_in", "put_in"]:
        return False
    held = {r.target_id for r in found.facts.inside(low.object_id) if r.holds}
    assert {one.target_id for one in records} <= held
    return True
