"""What is known of another scene of the same home is taken over, and changes nothing."""

from __future__ import annotations

import pytest
from sdgen.facts import Facts
from sdgen.facts.relations import FINDERS

from .scenes import DOOR, INFOS, PROPERTIES, scene, thing, zone

TABLE, STOVE, FRIDGE, APPLE, PLATE = range(1, 6)


@pytest.fixture
def empty():
    zones = [zone("heat", ((0.7, 0.7), (1.3, 0.7), (1.3, 1.3), (0.7, 1.3)), 0.8, 1.4, STOVE)]
    furniture = [
        thing(DOOR, "door", 4.06, 2),
        thing(TABLE, "table", 2, 2),
        thing(STOVE, "stove", 1, 1),
        thing(FRIDGE, "fridge", 3.5, 0.5),
    ]
    return scene(*furniture, zones=zones)


def with_things(empty, *things):
    return empty.model_copy(update={"objects": (*empty.objects, *things)})


def all_of(facts):
    keys = [(key, relation) for key in facts.bodies for relation in FINDERS]
    return (
        {key: facts.related(*key) for key in keys},
        {k: (facts.zones(k), facts.room_ids(k), facts.tags(k)) for k in facts.bodies},
        {k: (facts.overhang(k), facts.edge(k), facts.carriers(k)) for k in facts.bodies},
        facts.edges(),
    )


def test_facts_are_the_same_with_and_without_what_is_known(empty):
    known = Facts(empty, INFOS, PROPERTIES)
    before = with_things(empty, thing(APPLE, "apple", 2, 2, 0.75), thing(PLATE, "plate", 1, 1, 0.9))
    first = Facts(before, INFOS, PROPERTIES, known)
    assert all_of(first) == all_of(Facts(before, INFOS, PROPERTIES))
    # The apple lies in the fridge instead, which was turned; the plate is gone.
    turned = thing(FRIDGE, "fridge", 3.4, 0.6, yaw=0.5)
    moved = tuple(turned if item.id == FRIDGE else item for item in empty.objects)
    after = empty.model_copy(update={"objects": (*moved, thing(APPLE, "apple", 3.4, 0.6, 0.5))})
    second = Facts(after, INFOS, PROPERTIES, first)
    assert all_of(second) == all_of(Facts(after, INFOS, PROPERTIES))
    assert second.bodies[TABLE] is known.bodies[TABLE]
    assert second.bodies[FRIDGE] is not known.bodies[FRIDGE]


def test_the_ground_beside_furniture_is_found_once_for_all_that_is_put_there(empty):
    known = Facts(empty, INFOS, PROPERTIES)
    spots = ((2, 2), (2.1, 1.9))
    first, second = (
        Facts(with_things(empty, thing(APPLE, "apple", *spot, 0.75)), INFOS, PROPERTIES, known)
        for spot in spots
    )
    assert first.edge(APPLE) != second.edge(APPLE)
    assert len(known.grounds._found) == 3  # as measured, with the least and with the most
    assert first.grounds._found == second.grounds._found == {}
    # Not where the table was moved.
    table = thing(TABLE, "table", 2.1, 2)
    moved = tuple(table if item.id == TABLE else item for item in empty.objects)
    after = empty.model_copy(update={"objects": (*moved, thing(APPLE, "apple", 2, 2, 0.75))})
    elsewhere = Facts(after, INFOS, PROPERTIES, known)
    assert elsewhere.edge(APPLE) == Facts(after, INFOS, PROPERTIES).edge(APPLE)
    assert elsewhere.edge(APPLE) != first.edge(APPLE)


def test_another_home_tells_nothing(empty):
    known = Facts(empty, INFOS, PROPERTIES)
    elsewhere = empty.model_copy(update={"home": empty.home.model_copy(update={"id": "other"})})
    other_zones = empty.model_copy(update={"zones": ()})
    for one in (elsewhere, other_zones):
        made = Facts(one, INFOS, PROPERTIES, known)
        assert made.bodies[TABLE] is not known.bodies[TABLE]
        assert all_of(made) == all_of(Facts(one, INFOS, PROPERTIES))
