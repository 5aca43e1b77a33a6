"""Every relation and term, moved through its thresholds: true, then undecided, then false."""

import itertools
import math

import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.terms import TERMS
from sdgen.facts.relations import FINDERS
from sdgen.scene import Pose
from sdgen.vocabulary import RELATIONS
from sdgen.yaml_source import parse_yaml

from .scenes import DOOR, FIXED, FLOOR, INFOS, asset, facts, thing, zone

#: x, y: a shift of everything by up to 0.2 m.
SHIFT = st.floats(-0.2, 0.2)


def predicate(text):
    source = parse_yaml(text.encode(), "p.yaml")
    found = read_predicate(source, (), source.value, {*INFOS, "floor"}, {"kitchen", "hall"})
    assert source.problems == []
    return found


def square(x, y, half):
    return ((x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half))


def on_gap(t, x, y):
    return facts(thing(1, "table", 2 + x, 2 + y), thing(2, "apple", 2 + x, 2 + y, 0.75 + t))


def on_share(t, x, y):
    return facts(thing(1, "table", 2 + x, 2 + y), thing(2, "apple", 2 + x + t, 2 + y, 0.75))


def on_level(t, x, y):
    """A plate rises out of the table: once it is a level higher, the apple is on it alone."""
    plate = thing(3, "plate", 2 + x, 2 + y, 0.74 + t)
    apple = thing(2, "apple", 2 + x, 2 + y, 0.75 + t)
    return facts(thing(1, "table", 2 + x, 2 + y), plate, apple)


def tilted_table(t, x, y):
    """A table leaning over by ``t`` radians about y, and where the middle of its top is."""
    leaning = Pose(position_m=(2 + x, 2 + y, 0), quat_xyzw=(0, math.sin(t / 2), 0, math.cos(t / 2)))
    table = thing(1, "table", 2 + x, 2 + y).model_copy(update={"pose": leaning})
    return table, (2 + x + 0.75 * math.sin(t), 2 + y, 0.75 * math.cos(t))


def on_tilted(t, x, y):
    table, top = tilted_table(t, x, y)
    return facts(table, thing(2, "apple", *top))


def under_tilted(t, x, y):
    table, _ = tilted_table(t, x, y)
    return facts(table, thing(2, "box", 2 + x, 2 + y))


def inside(t, x, y):
    return facts(thing(1, "fridge", 2 + x, 2 + y), thing(2, "apple", 2 + x + t, 2 + y, 0.5))


def not_inside(t, x, y):
    """On the fridge's shelf when it is not inside it: its box starts above the shelf."""
    top = {"name": "top", "part": "body", "z_m": 1.0, "polygon_m": square(0, 0, 0.25)}
    bowl = {"name": "in", "part": "body", "center_m": (0, 0, 1.0), "size_m": (0.3, 0.3, 0.5)}
    info = asset("dresser", (0.6, 0.6, 1.2), supports=[top], containers=[bowl])
    spot = thing(2, "apple", 2 + x + 0.17 - t, 2 + y, 1.0)
    return facts(thing(1, "dresser", 2 + x, 2 + y), spot, more=[info])


def close(t, x, y):
    return facts(thing(1, "stove", 1 + x, 2 + y), thing(2, "apple", 1.34 + x + t, 2 + y))


def facing(t, x, y):
    return facts(thing(2, "sofa", 1.3 + x, 2 + y, yaw=t), thing(1, "tv", 3.5 + x, 2 + y))


def facing_table(t, x, y):
    sofa = thing(2, "sofa", 2.4 - t + x, 2 + y)
    return facts(sofa, thing(1, "table", 3.5 + x, 2 + y))


def under_share(t, x, y):
    return facts(thing(1, "table", 1.5 + x, 2 + y), thing(2, "box", 1.5 + x + t, 2 + y))


def under_height(t, x, y):
    return facts(thing(1, "table", 1.5 + x, 2 + y), thing(2, "box", 1.5 + x, 2 + y, t))


def doorway():
    shape = ((3.0, 1.3), (4.06, 1.3), (4.06, 2.7), (3.0, 2.7))
    return zone("doorway", shape, 0.0, 0.5, DOOR), thing(DOOR, "door", 4.06, 2)


def blocks_share(t, x, y):
    where, door = doorway()
    return facts(door, thing(2, "box", 3.4 - t, 2 + y), zones=[where])


def blocks_height(t, x, y):
    where, door = doorway()
    slab = asset("box", (0.3, 0.3, 0.1 - t))
    return facts(door, thing(2, "box", 3.5 + x, 2 + y), zones=[where], more=[slab])


def blocks_level(t, x, y):
    where, door = doorway()
    return facts(door, thing(2, "box", 3.5 + x, 2 + y, t), zones=[where])


def near(kind):
    def make(t, x, y):
        where = zone(kind, square(1.5 + x, 2 + y, 0.3), 0.8, 1.4, 1)
        apple = thing(2, "apple", 1.84 + x + t, 2 + y, 0.9)
        return facts(thing(1, "stove", 1.5 + x, 2 + y), apple, zones=[where])

    return make


def near_level(t, x, y):
    where = zone("heat", square(1.5 + x, 2 + y, 0.3), 0.8, 1.4, 1)
    apple = thing(2, "apple", 1.5 + x, 2 + y, t)
    return facts(thing(1, "stove", 1.5 + x, 2 + y), apple, zones=[where])


def zone_share(t, x, y):
    where = zone("walkway", square(1.5 + x, 2 + y, 0.5), 0.0, 0.5, None)
    return facts(thing(2, "box", 1.5 + x + t, 2 + y), zones=[where])


def zone_level(t, x, y):
    where = zone("walkway", square(1.5 + x, 2 + y, 0.5), 0.0, 0.5, None)
    return facts(thing(2, "box", 1.5 + x, 2 + y, t), zones=[where])


def height(t, x, y):
    return facts(thing(2, "apple", 2 + x, 2 + y, t))


PLANK = asset("plank", (0.6, 0.1, 0.02))


def over_an_edge(t, x, y):
    """A plank that reaches by ``t`` over the edge of a table."""
    plank = thing(2, "plank", 2.2 + t + x, 2 + y, 0.75)
    return facts(thing(1, "table", 2 + x, 2 + y), plank, more=[PLANK])


def over_a_drop(t, x, y):
    """It reaches over what is ``t`` high."""
    top = {"name": "top", "part": "body", "z_m": t, "polygon_m": square(0, 0, 0.24)}
    block = asset("block", (0.5, 0.5, t), supports=[top])
    plank = thing(2, "plank", 2.1 + x, 2 + y, t)
    return facts(thing(1, "block", 2 + x, 2 + y), plank, more=[PLANK, block])


def over_a_stove(t, x, y):
    """What is below the plank's end is fixed and its surface ``t`` high; its back is higher."""
    top = {"name": "top", "part": "body", "z_m": t, "polygon_m": square(0, 0, 0.29)}
    low = asset("stove", (0.6, 0.6, t + 0.3), supports=[top])
    plank, below = thing(2, "plank", 2.3 + x, 2 + y, 0.75), thing(3, "stove", 2.81 + x, 2 + y)
    return facts(thing(1, "table", 2 + x, 2 + y), plank, below, more=[PLANK, low])


def at_an_edge(t, x, y):
    return facts(thing(1, "table", 2 + x, 2 + y), thing(2, "box", 2.35 - t + x, 2 + y, 0.75))


def at_a_gap(t, x, y):
    """Another table goes on beyond a gap."""
    tables = thing(1, "table", 1.3 + x, 2 + y), thing(3, "table", 2.3 + t + x, 2 + y)
    return facts(*tables, thing(2, "box", 1.64 + x, 2 + y, 0.75))


def at_a_wall(t, x, y):
    """The table's edge is ``t`` off the wall; the box is at that edge."""
    table = thing(1, "table", 3.5 - t, 2 + y)
    return facts(table, thing(2, "box", 3.84 - t, 2 + y, 0.75))


def beside_below(t, x, y):
    return facts(thing(1, "stove", 1.5 + x, 2 + y), thing(2, "apple", 1.84 + t + x, 2 + y, 1.6))


def higher_by(t, x, y):
    return facts(thing(1, "stove", 1.5 + x, 2 + y), thing(2, "apple", 1.5 + x, 2 + y, 0.9 + t))


def above_through_the_door(t, x, y):
    return facts(thing(1, "stove", 3.6, 2 + y), thing(2, "apple", t, 2 + y, 1.6))


def two_plates(t, x, y):
    plates = thing(2, "plate", 1.7 + x, 2 + y, 0.75), thing(3, "plate", 2.3 + t + x, 2 + y, 0.75)
    return facts(thing(1, "table", 2 + x, 2 + y), *plates)


def apart(t, x, y):
    return facts(thing(2, "apple", 1.5 + x, 2 + y), thing(3, "apple", 1.58 + t + x, 2 + y))


def apart_through_the_door(t, x, y):
    return facts(thing(2, "apple", t, 2 + y), thing(3, "apple", 3.7, 2 + y))


def through_the_door(t, x, y):
    return facts(thing(2, "apple", t, 2 + y))


def out_of_the_house(t, x, y):
    return facts(thing(2, "apple", -t, 2 + y))


def ajar(t, x, y):
    """A fridge whose door opens; the apple is in it or stands before it."""
    fridge = thing(1, "fridge", 2 + x, 2 + y, joints={"door": t})
    return facts(thing(2, "apple", 2 + x, 2 + y, 0.5), thing(3, "box", 3 + x, 2 + y), fridge)


def inside_ajar(t, x, y):
    """A fridge whose door opens, on a table."""
    fridge = thing(2, "fridge", 2 + x, 2 + y, 0.75, joints={"door": t})
    return facts(thing(1, "table", 2 + x, 2 + y), fridge)


#: What is moved, the predicate of object 2 (or another), from where it holds to where it does not.
SWEEPS = {
    "ON gap": (on_gap, "{relation: ON, target: table}", 0.0, 0.03),
    "ON share": (on_share, "{relation: ON, target: table}", 0.45, 0.55),
    "ON level": (on_level, "{relation: ON, target: table}", 0.0, 0.003),
    "ON tilted": (on_tilted, "{relation: ON, target: table}", 0.0, 0.05),
    "ON, not INSIDE": (not_inside, "{relation: ON}", 0.0, 0.05),
    "INSIDE": (inside, "{relation: INSIDE, target: fridge}", 0.2, 0.3),
    "CLOSE": (close, "{relation: CLOSE, target: stove}", 1.3, 1.7),
    "FACING": (facing, "{relation: FACING, target: tv}", 0.0, math.pi),
    "FACING, sat at": (facing_table, "{relation: FACING, target: table}", 0.0, 0.8),
    "UNDER share": (under_share, "{relation: UNDER, target: table}", 0.3, 0.8),
    "UNDER height": (under_height, "{relation: UNDER, target: table}", 0.4, 0.5),
    "UNDER tilted": (under_tilted, "{relation: UNDER, target: table}", 0.0, 0.05),
    "BLOCKS share": (blocks_share, "{relation: BLOCKS, target: door}", 0.0, 0.8),
    "BLOCKS height": (blocks_height, "{relation: BLOCKS, target: door}", 0.0, 0.09),
    "BLOCKS level": (blocks_level, "{relation: BLOCKS, target: door}", 0.4, 0.6),
    "NEAR_HEAT": (near("heat"), "{relation: NEAR_HEAT, target: stove}", 0.1, 0.5),
    "NEAR_HEAT level": (near_level, "{relation: NEAR_HEAT, target: stove}", 1.3, 1.5),
    "NEAR_WATER": (near("water"), "{relation: NEAR_WATER, target: stove}", 0.3, 0.7),
    "zone share": (zone_share, "zone: walkway", 0.2, 0.8),
    "zone level": (zone_level, "zone: walkway", 0.4, 0.6),
    "height": (height, "height: {max_m: 1.3}", 1.2, 1.4),
    "height of two": (height, "height: {min_m: 0.2, max_m: 1.3}", 1.0, 1.4),
    "distance": (close, "distance: {to: stove, max_m: 0.5}", 0.3, 0.7),
    "distance from above": (
        beside_below,
        "distance: {to: stove, from_above: true, max_m: 0.3}",
        0.1,
        0.5,
    ),
    "distance.same_room": (
        apart_through_the_door,
        "distance: {to: apple, same_room: true, max_m: 1}",
        3.9,
        4.2,
    ),
    "distance to a zone": (near("heat"), "distance: {to_zone: heat, max_m: 0.3}", 0.1, 0.5),
    "distance to a zone, level": (near_level, "distance: {to_zone: heat, max_m: 0.3}", 1.3, 1.5),
    "facing": (facing, "facing: {to: tv, max_deg: 60}", 0.0, math.pi),
    "overhang": (over_an_edge, "overhang: {min_m: 0.05}", 0.1, 0.0),
    "overhang, caught by the floor": (over_a_drop, "overhang: {min_m: 0.05}", 0.4, 0.1),
    "overhang, caught by a stove": (over_a_stove, "overhang: {min_m: 0.05}", 0.3, 0.74),
    "overhang at most": (over_an_edge, "overhang: {max_m: 0.05}", 0.0, 0.1),
    "edge": (at_an_edge, "edge: {max_m: 0.08}", 0.0, 0.2),
    "edge at least": (at_an_edge, "edge: {min_m: 0.08}", 0.2, 0.0),
    "edge, caught by the floor": (over_a_drop, "edge: {max_m: 0.08}", 0.4, 0.1),
    "edge, gap": (at_a_gap, "edge: {max_m: 0.08}", 0.3, 0.0),
    "edge, wall": (at_a_wall, "edge: {max_m: 0.08}", 0.3, 0.0),
    "above, aside": (beside_below, "above: {of: stove, within_m: 0.3}", 0.0, 0.6),
    "above, higher": (higher_by, "above: {of: stove}", 0.5, 0.0),
    "above, room": (
        above_through_the_door,
        "above: {of: stove, within_m: 0.5}",
        3.9,
        4.2,
    ),
    "count on the same": (two_plates, "count: {of: plate, min: 2, on: same}", 0.0, 0.4),
    "count within": (apart, "count: {of: apple, min: 2, within_m: 0.5}", 0.3, 0.7),
    "count within, room": (
        apart_through_the_door,
        "count: {of: apple, min: 2, within_m: 1}",
        3.9,
        4.2,
    ),
    "holds ON": (two_plates, "holds: {category: plate, relation: ON, min: 2}", 0.0, 0.4),
    "holds INSIDE": (inside, "holds: {category: apple, relation: INSIDE}", 0.2, 0.3),
    "holds state": (inside_ajar, "holds: {category: fridge, state: CLOSED}", 0.0, 0.8),
    "facing_away": (facing, "facing_away: {from: tv, min_deg: 100}", math.pi, 0.0),
    "room": (through_the_door, "room: kitchen", 3.9, 4.2),
    "room, outdoors": (out_of_the_house, "room: kitchen", 0.0, 0.3),
    "state": (ajar, "state: CLOSED", 0.0, 0.8),
    "target_state": (ajar, "{relation: INSIDE, target_state: CLOSED}", 0.0, 0.8),
    "CLOSE target_state": (
        ajar,
        "{relation: CLOSE, target: fridge, target_state: CLOSED}",
        0.0,
        0.8,
    ),
    "distance.to_state": (ajar, "distance: {to: fridge, to_state: CLOSED, max_m: 1}", 0.0, 0.8),
}
OF = {
    "holds ON": 1,
    "holds INSIDE": 1,
    "holds state": 1,
    "state": 1,
    "CLOSE target_state": 3,
    "distance.to_state": 3,
}


def verdicts(name, points, x, y):
    """The predicate's verdicts along the way, as words."""
    make, text, first, last = SWEEPS[name]
    wanted = predicate(text)
    out = []
    for share in points:
        found = wanted.evaluate(OF.get(name, 2), make(first + share * (last - first), x, y))
        out.append("undecided" if not found.sure else "true" if found.value else "false")
    return out


@pytest.mark.parametrize("name", SWEEPS)
# Sixty points a try are dear to shrink, and the numbers of a failure say enough.
@settings(max_examples=6, deadline=None, phases=[Phase.explicit, Phase.generate])
@given(SHIFT, SHIFT, st.floats(0.0, 1.0))
def test_true_then_undecided_then_false(name, x, y, phase):
    points = [0.0, *((k + phase) / 60 for k in range(60)), 1.0]
    seen = [word for word, _ in itertools.groupby(verdicts(name, points, x, y))]
    assert seen == ["true", "undecided", "false"]


def test_every_relation_and_term_is_moved_through_its_thresholds():
    texts = " ".join(text for _, text, _, _ in SWEEPS.values())
    exact = {"BETWEEN"}
    assert {name for name in RELATIONS if f"relation: {name}" not in texts} == exact
    keys = {"category", "relation", "all", "any", "not"}  # exact, or made of the others
    assert {key for key in TERMS if f"{key}:" not in texts} <= keys


def test_the_registry_has_every_relation_of_the_vocabulary():
    assert tuple(FINDERS) == RELATIONS


def test_between_is_exact_and_names_room_types():
    f = facts(thing(DOOR, "door", 4.06, 2), thing(1, "table", 2, 2))
    for text, value in (("kitchen", True), ("hall", True), ("[kitchen, hall]", True)):
        found = predicate(f"{{relation: BETWEEN, target: {text}}}").evaluate(DOOR, f)
        assert (found.value, found.sure) == (value, True)
        assert found.evidence["target_category"] in ("kitchen", "hall")
    found = predicate("relation: BETWEEN").evaluate(1, f)
    assert (found.value, found.sure) == (False, True)


def test_a_nearer_thing_in_an_undecided_state_leaves_a_distance_undecided():
    near, far = (
        predicate("distance: {to: fridge, to_state: CLOSED, max_m: 1.5}"),
        predicate("distance: {to: fridge, to_state: CLOSED, min_m: 0.5}"),
    )
    box, ajar_, shut = (
        thing(3, "box", 0.5, 2),
        thing(1, "fridge", 1.2, 2, joints={"door": 0.2}),
        thing(2, "fridge", 2.0, 2),
    )
    f = facts(box, ajar_, shut)
    assert near.evaluate(3, f).sure  # the shut one is near enough, whatever the other is
    assert near.evaluate(3, f).evidence["nearest_id"] == 2
    assert not far.evaluate(3, f).sure  # it is only far enough if the near one is open
    assert far.evaluate(3, facts(box, shut)).sure


def test_two_lookers_above_each_other_have_no_bearing():
    f = facts(thing(2, "sofa", 2, 2), thing(1, "tv", 2.05, 2, 1.5))
    assert not predicate("relation: FACING").evaluate(2, f).sure
    assert FLOOR not in FIXED
