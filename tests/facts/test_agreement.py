"""Edges, tags and predicates come from one computation, in memory and from written files."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.catalog.terms import AllTerm, HeightTerm, NotTerm, RelationTerm, RoomTerm, ZoneTerm
from sdgen.dataset import Dataset
from sdgen.facts import Facts
from sdgen.facts.relations import FINDERS
from sdgen.hazards.certify import facts_of

from tests import toy

from .scenes import DOOR, INFOS, facts, thing, zone

LOOSE = ("apple", "plate", "box")
BUILT_IN = ("table", "fridge", "sink_cabinet", "sofa", "tv", "stove")


@st.composite
def scenes(draw):
    """Two to four pieces of furniture and as many loose things on, in, under and beside them."""
    grid = st.sampled_from([0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.06, 5.0])
    fixed = draw(st.lists(st.tuples(st.sampled_from(BUILT_IN), grid, grid), min_size=2, max_size=4))
    things = [thing(DOOR, "door", 4.06, 2)]
    for number, (name, x, y) in enumerate(fixed, 1):
        yaw = draw(st.floats(-3, 3))
        door = {"joints": {"door": draw(st.sampled_from([0.0, 0.2, 1.0]))}}
        things.append(thing(number, name, x, y, yaw=yaw, **door))
    for number in range(20, 20 + draw(st.integers(2, 4))):
        _, x, y = draw(st.sampled_from(fixed))
        shift = st.sampled_from([0.0, 0.0, 0.1, 0.24, 0.5, 0.8])
        z = draw(st.sampled_from([0.0, 0.002, 0.3, 0.5, 0.75, 0.76, 0.8, 0.9]))
        name = draw(st.sampled_from(LOOSE))
        things.append(thing(number, name, x + draw(shift), y + draw(shift), z))
    zones = [
        zone("doorway", ((3.0, 1.3), (4.06, 1.3), (4.06, 2.7), (3.0, 2.7)), 0.0, 0.5, DOOR),
        zone("walkway", ((0.5, 1.5), (3.5, 1.5), (3.5, 2.5), (0.5, 2.5)), 0.0, 0.5, None),
        zone("heat", ((0.7, 0.7), (1.3, 0.7), (1.3, 1.3), (0.7, 1.3)), 0.8, 1.4, 1),
        zone("water", ((1.7, 1.7), (2.3, 1.7), (2.3, 2.3), (1.7, 2.3)), 0.0, 1.2, 2),
    ]
    return facts(*things, zones=zones)


def check_agreement(f: Facts) -> set[str]:
    """Compare edges and tags with predicates; the relations that held at all."""
    rooms = {room.id for room in f.scene.home.rooms}
    edges = [e for e in f.edges() if e.from_id in f.bodies]
    inside = {(e.from_id, e.to_id) for e in edges if e.relation == "INSIDE" and e.to_id in rooms}
    for object_id in f.bodies:
        for relation in FINDERS:
            targets = {
                e.to_id
                for e in edges
                if e.from_id == object_id
                and e.relation == relation
                and (relation == "BETWEEN" or e.to_id not in rooms)
            }
            named = {f.category(k) for k in targets}
            others = {body.item.category for body in f.bodies.values()} | {"floor", "kitchen"}
            for category in named | others:
                term = RelationTerm(relation=relation, targets=(category,))
                assert term.evaluate(object_id, f).value == (category in named), (relation, term)
            term = RelationTerm(relation=relation)
            assert term.evaluate(object_id, f).value == bool(targets)
        for room in f.scene.home.rooms:
            if RoomTerm(any_of=(room.type,)).evaluate(object_id, f).value:
                assert any(
                    (object_id, r.id) in inside for r in f.scene.home.rooms if r.type == room.type
                )
        shut = RelationTerm(relation="INSIDE", target_state="CLOSED")
        reach = AllTerm(terms=(HeightTerm(max_m=1.3), NotTerm(term=shut)))
        tags = f.tags(object_id)
        loose = not f.bodies[object_id].item.fixed
        said = {
            "IN_REACH_OF_CHILD": loose and reach.evaluate(object_id, f).value,
            "IN_DOORWAY": ZoneTerm(any_of=("doorway",)).evaluate(object_id, f).value,
            "IN_WALKWAY": ZoneTerm(any_of=("walkway",)).evaluate(object_id, f).value,
        }
        assert {tag for tag in said if said[tag]} == {tag for tag in tags if tag in said}
        if "NEAR_EDGE" in tags:
            assert f.holds(object_id, "ON")
    return {e.relation for e in edges}


@settings(max_examples=40, deadline=None)
@given(scenes())
def test_edges_and_tags_are_what_predicates_say(f):
    check_agreement(f)


def test_the_drawn_scenes_have_every_relation():
    """Or the property above would prove nothing."""
    seen = set()

    @settings(max_examples=400, deadline=None, derandomize=True, database=None)
    @given(scenes())
    def look(f):
        seen.update(e.relation for e in f.edges())

    look()
    assert seen == set(FINDERS)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    return Dataset(toy.build(tmp_path_factory.mktemp("toy") / "d", toy.small(sensors=())))


def test_every_relation_means_the_same_in_written_files(written):
    held = set()
    for item in written:
        catalog = toy.catalog()
        made = facts_of(toy.bundle(item.scene.index).scene, toy.infos(), catalog)
        read = facts_of(item.scene, written.infos, catalog)
        assert check_agreement(read)
        edges = {(e.from_id, e.to_id, e.relation_type) for e in item.scene_graph.edges}
        assert {tuple(e) for e in read.edges()} == edges
        assert {n.id: n.tags for n in item.scene_graph.nodes if n.id in read.bodies} == {
            k: read.tags(k) for k in read.bodies
        }
        for object_id in read.bodies:
            for relation in FINDERS:
                term = RelationTerm(relation=relation)
                assert term.evaluate(object_id, read) == term.evaluate(object_id, made)
                if term.evaluate(object_id, read).value:
                    held.add(relation)
    assert {"ON", "INSIDE", "BETWEEN", "CLOSE"} <= held


def test_the_models_of_these_tests_have_every_part_relations_look_at():
    assert any(info.supports for info in INFOS.values())
    assert any(info.containers for info in INFOS.values())
