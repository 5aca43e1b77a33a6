"""Relations follow VirtualHome's geometry, and know when they are near a threshold."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.terms import HeightTerm, RelationTerm, ZoneTerm
from sdgen.facts import Edge, Facts, room_at
from sdgen.kleene import YES
from sdgen.scene import Zone

from .scenes import DOOR, FLOOR, HALL, INFOS, ROOM, asset, facts, scene, square, thing

HEAT = Zone(
    name="heat:a",
    kind="heat",
    polygon_m=((1.7, 1.7), (2.3, 1.7), (2.3, 2.3), (1.7, 2.3)),
    z_min_m=0.8,
    z_max_m=1.4,
    room_id=ROOM,
    source_id=1,
)


def test_on_is_the_direct_support_only():
    f = facts(
        thing(1, "table", 2, 2),
        thing(2, "plate", 2, 2, 0.75),
        thing(3, "apple", 2, 2, 0.76),
    )
    assert f.holds(1, "ON") == (FLOOR,)
    assert f.holds(2, "ON") == (1,)
    assert f.holds(3, "ON") == (2,)
    assert Edge(2, ROOM, "INSIDE") in f.edges()


@pytest.mark.parametrize(
    ("gap", "holds", "sure"),
    [
        (0.0, True, True),
        (0.005, True, True),
        (0.009, True, False),
        (0.012, False, False),
        (0.018, False, False),
    ],
)
def test_on_within_a_centimetre_with_a_dead_band(gap, holds, sure):
    (found,) = facts(thing(1, "table", 2, 2), thing(2, "apple", 2, 2, 0.75 + gap)).related(2, "ON")
    assert (found.holds, found.sure) == (holds, sure)


@pytest.mark.parametrize(
    ("x", "holds", "sure"), [(2.45, True, True), (2.497, True, False), (2.503, False, False)]
)
def test_on_needs_more_than_half_of_the_footprint(x, holds, sure):
    (found,) = facts(thing(1, "table", 2, 2), thing(2, "apple", x, 2, 0.75)).related(2, "ON")
    assert (found.holds, found.sure) == (holds, sure)


def test_a_door_in_the_middle_of_its_wall_is_on_neither_floor_and_that_is_undecided():
    for noise in (-1e-12, 0.0, 1e-12):
        f = facts(thing(DOOR, "door", 4.06 + noise, 2))
        assert f.holds(DOOR, "ON") == ()
        assert [(r.holds, r.sure) for r in f.related(DOOR, "ON")] == [(False, False)] * 2


def test_inside_a_fridge_is_not_on_it_and_a_shut_door_shuts_in():
    shut = thing(1, "fridge", 2, 2)
    milk = thing(2, "apple", 2, 2, 0.5)
    f = facts(shut, milk)
    assert f.holds(2, "INSIDE") == (1,)
    assert f.holds(2, "ON") == ()
    (found,) = f.related(2, "INSIDE")
    assert found.states == ("CLOSED",)
    assert "IN_REACH_OF_CHILD" not in f.tags(2)
    opened = shut.model_copy(update={"joints": {"door": 1.0}})
    assert "IN_REACH_OF_CHILD" in facts(opened, milk).tags(2)


def test_the_shut_cupboard_does_not_shut_in_what_lies_in_the_basin_above_it():
    shut = thing(1, "sink_cabinet", 2, 2)
    f = facts(shut, thing(2, "apple", 2, 2, 0.76), thing(3, "apple", 2, 2, 0.1))
    assert f.holds(2, "INSIDE") == f.holds(3, "INSIDE") == (1,)
    assert "IN_REACH_OF_CHILD" in f.tags(2)
    assert "IN_REACH_OF_CHILD" not in f.tags(3)


def test_near_the_mouth_of_a_container_is_in_doubt():
    edge = 2 + 0.25
    for x, holds in ((edge - 0.002, True), (edge + 0.002, False)):
        (found,) = facts(thing(1, "fridge", 2, 2), thing(2, "apple", x, 2, 0.5)).related(
            2, "INSIDE"
        )
        assert (found.holds, found.sure) == (holds, False)


def test_close_only_within_a_room_and_both_ways():
    f = facts(thing(1, "box", 3.7, 2), thing(2, "box", 3, 2), thing(3, "box", 4.4, 2, room=HALL))
    close = {(e.from_id, e.to_id) for e in f.edges() if e.relation == "CLOSE"}
    assert close == {(1, 2), (2, 1)}


def test_facing_within_75_degrees():
    f = facts(thing(1, "sofa", 1, 2), thing(2, "tv", 3.5, 2))
    assert Edge(1, 2, "FACING") in f.edges()
    turned = facts(thing(1, "sofa", 1, 2, yaw=math.radians(100)), thing(2, "tv", 3.5, 2))
    assert Edge(1, 2, "FACING") not in turned.edges()


@pytest.mark.parametrize(
    ("x", "yaw", "faces"), [(2.4, 0.0, True), (1.7, 0.0, False), (2.4, math.pi, False)]
)
def test_a_seat_faces_the_table_it_stands_at(x, yaw, faces):
    """The sofa's front is 0.15 m or 0.85 m away."""
    table = thing(2, "table", 3.5, 2)
    f = facts(thing(1, "sofa", x, 2, yaw=yaw), table)
    assert (Edge(1, 2, "FACING") in f.edges()) is faces


def test_a_door_is_between_its_rooms_and_a_box_in_its_zone_blocks_it():
    zone = Zone(
        name="doorway:a",
        kind="doorway",
        polygon_m=((3.4, 1.5), (4.06, 1.5), (4.06, 2.5), (3.4, 2.5)),
        z_min_m=0,
        z_max_m=0.5,
        room_id=ROOM,
        source_id=DOOR,
    )
    door = thing(DOOR, "door", 4.06, 2)
    f = facts(thing(1, "box", 3.7, 2), thing(2, "rug", 3.0, 2), door, zones=[zone])
    assert {(e.to_id) for e in f.edges() if e.relation == "BETWEEN"} == {ROOM, HALL}
    assert Edge(1, DOOR, "BLOCKS") in f.edges()
    assert Edge(2, DOOR, "BLOCKS") not in f.edges()
    assert "IN_DOORWAY" in f.tags(1)
    (share,) = f.zones(1)
    assert share.fraction == pytest.approx(1.0)


def test_a_box_blocks_the_front_door_and_a_predicate_can_ask_for_that():
    front = asset("front_door", (0.12, 0.9, 2.1))
    where = Zone(
        name="doorway:a",
        kind="doorway",
        polygon_m=((0.0, 1.5), (0.9, 1.5), (0.9, 2.5), (0.0, 2.5)),
        z_min_m=0,
        z_max_m=0.5,
        room_id=ROOM,
        source_id=20,
    )
    door = thing(20, "front_door", -0.06, 2).model_copy(update={"fixed": True})
    f = facts(door, thing(1, "box", 0.5, 2), zones=[where], more=[front])
    blocks = RelationTerm(relation="BLOCKS", targets=("front_door",))
    assert blocks.evaluate(1, f).evidence["target_id"] == 20
    assert not RelationTerm(relation="BLOCKS", targets=("door",)).evaluate(1, f).value


def test_distance_from_above_is_between_outlines_whatever_the_heights():
    """Turned by 45 degrees, the box's own box is wider than its outline."""
    turned = thing(2, "box", 2.0, 1, 1.5, yaw=math.pi / 4)
    f = facts(thing(1, "stove", 1, 1), turned, thing(3, "box", 1, 1, 0.9))
    assert f.gaps(2, {"stove"}, True) == ((pytest.approx(0.7 - 0.15 * math.sqrt(2)), 1),)
    assert f.gaps(3, {"stove"}, True) == ((0.0, 1),)
    assert f.gaps(2, {"tv"}, True) == ()


def test_gaps_to_zones_are_those_of_near_heat_also_for_what_is_fixed():
    f = facts(thing(1, "stove", 2, 2), thing(2, "apple", 2.54, 2, 0.9), zones=[HEAT])
    (near,) = f.related(2, "NEAR_HEAT")
    (gap,) = f.zone_gaps(2, {"heat"})
    assert (gap.gap_m, gap.source_id) == (near.evidence["gap_m"], 1)
    assert f.zone_gaps(1, {"heat"}) == ()  # its own
    assert f.zone_gaps(2, {"water"}) == ()
    below = facts(thing(1, "stove", 2, 2), thing(2, "tv", 2.5, 2), zones=[HEAT])
    assert below.zone_gaps(2, {"heat"}) == ()
    assert [z.gap_m for z in below.zone_gaps(2, {"heat"}, True)] == [pytest.approx(0.15)]


def test_what_is_above_something_is_measured_from_where_one_sits_or_lies():
    seat = {"name": "seat", "part": "body", "z_m": 0.45, "polygon_m": square(0.3)}
    sofa = asset("sofa", (0.9, 2.0, 0.8), supports=[seat])
    f = facts(thing(1, "sofa", 1, 2), thing(2, "box", 1.8, 2, 1.4), more=[sofa])
    (found,) = f.overlooked(2, {"sofa"})
    assert found == (1, pytest.approx(0.2), pytest.approx(0.95), YES)
    (found,) = facts(thing(1, "sofa", 1, 2), thing(2, "box", 1.8, 2, 1.4)).overlooked(2, {"sofa"})
    assert found.drop_m == pytest.approx(0.6)  # no surface: the top of its box
    assert facts(thing(1, "sofa", 3, 2), thing(2, "box", 4.5, 2, 1.4)).overlooked(2, {"sofa"}) == ()


def test_what_lies_across_the_border_of_two_zones_is_in_them_together():
    def strip(kind, x0, x1):
        return Zone(
            name=f"{kind}:{x0}",
            kind=kind,
            polygon_m=((x0, 1.0), (x1, 1.0), (x1, 3.0), (x0, 3.0)),
            z_min_m=0,
            z_max_m=0.5,
            room_id=ROOM,
        )

    zones = [strip("doorway", 1.0, 2.0), strip("walkway", 2.0, 3.0), strip("walkway", 1.9, 2.05)]
    f = facts(thing(1, "box", 2.0, 2), zones=zones)
    half, most = f.zone_shares(1, ("doorway",)), f.zone_shares(1, ("doorway", "walkway"))
    assert [(s.kind, round(s.fraction, 3)) for s in half] == [("doorway", 0.5)]
    assert [round(s.fraction, 3) for s in most] == [1.0]  # what two zones share counts once
    assert not ZoneTerm(any_of=("doorway",)).evaluate(1, f).sure
    assert ZoneTerm(any_of=("doorway", "walkway")).evaluate(1, f)[:2] == (True, True)


CLIMBS = {"table": 0.45}


def reached(*things, climbs=CLIMBS):
    return Facts(scene(*things), INFOS, climbs=climbs).reach(1)


def test_a_child_reaches_from_what_it_climbs_on():
    """The table ends at 2.5; the apple lies beside it, higher than one stands on it."""
    table = thing(2, "table", 2, 2)
    near, far = thing(1, "apple", 2.74, 2, 1.5), thing(1, "apple", 3.2, 2, 1.5)
    found = reached(near, table)
    assert (found.height_m, found.climbed_id) == (pytest.approx(1.5), 2)
    assert found.above_m == found.least_m == found.most_m == pytest.approx(1.05)
    assert reached(far, table)[1:] == (pytest.approx(1.5),) * 3 + (None,)
    # What lies lower than the seat is taken from the floor.
    assert reached(thing(1, "apple", 2.74, 2, 0.3), table).above_m == pytest.approx(0.3)


@pytest.mark.parametrize(("about_m", "stands_m"), [(0.6, 0.75), (0.9, 0.75), (0.45, 0.45)])
def test_a_model_lifts_by_its_own_surface_where_it_has_one_about_there(about_m, stands_m):
    """The table's top is at 0.75 m; 0.3 m lower it is a cistern over a toilet's lid."""
    found = reached(
        thing(1, "apple", 2.74, 2, 1.5), thing(2, "table", 2, 2), climbs={"table": about_m}
    )
    assert found.above_m == pytest.approx(1.5 - stands_m)


def test_whether_something_is_near_enough_to_climb_on_may_be_undecided():
    table = thing(2, "table", 2, 2)
    within, beyond = (reached(thing(1, "apple", 2.54 + gap, 2, 1.5), table) for gap in (0.47, 0.53))
    for found, above in ((within, 1.05), (beyond, 1.5)):
        assert found.above_m == pytest.approx(above)
        assert (found.least_m, found.most_m) == (pytest.approx(1.05), pytest.approx(1.5))
    high = HeightTerm(max_m=1.29, evidence="reach_height_m")
    f = Facts(scene(thing(1, "apple", 3.01, 2, 1.5), table), INFOS, climbs=CLIMBS)
    assert high.evaluate(1, f)[:2] == (True, False)
    assert HeightTerm(max_m=2.0, evidence="reach_height_m").evaluate(1, f).sure
    assert HeightTerm(max_m=1.29).evaluate(1, f)[:2] == (False, True)  # above the floor


def test_nobody_climbs_through_a_wall():
    table = thing(2, "table", 3.4, 2)
    assert reached(thing(1, "apple", 3.95, 2, 1.5), table).climbed_id == 2
    assert reached(thing(1, "apple", 4.2, 2, 1.5), table).climbed_id is None


def test_near_heat_and_under():
    f = facts(thing(1, "stove", 2, 2), thing(2, "apple", 2.5, 2, 0.9), zones=[HEAT])
    assert Edge(2, 1, "NEAR_HEAT") in f.edges()
    g = facts(thing(1, "table", 2, 2), thing(2, "box", 2, 2))
    assert Edge(2, 1, "UNDER") in g.edges()
    assert g.holds(2, "ON") == (FLOOR,)


@given(st.floats(0.2, 3.8), st.floats(0.2, 3.8), st.floats(-3, 3))
def test_turning_and_moving_together_changes_no_relation(x, y, yaw):
    dx, dy = 0.2 * math.cos(yaw), 0.2 * math.sin(yaw)
    f = facts(thing(1, "table", x, y, yaw=yaw), thing(2, "apple", x + dx, y + dy, 0.75, yaw=yaw))
    (found,) = f.related(2, "ON")
    assert found.target_id == 1
    assert found.holds
    assert found.sure


def test_distance_is_between_boxes():
    f = facts(thing(1, "stove", 1, 1), thing(2, "box", 2.0, 1), thing(3, "box", 3, 3))
    assert f.gaps(2, {"stove"}) == ((pytest.approx(0.55), 1),)
    assert f.gaps(2, {"tv"}) == ()


def test_room_at_reaches_half_a_wall():
    rooms = facts(thing(1, "box", 1, 1)).scene.home.rooms
    assert room_at(rooms, 3.99, 1).id == ROOM
    assert room_at(rooms, 4.02, 1).id == ROOM
    assert room_at(rooms, 9, 9) is None


def test_a_relation_that_holds_has_its_measurement():
    f = facts(thing(1, "stove", 2, 2), thing(2, "apple", 2.54, 2, 0.9), zones=[HEAT])
    (near,) = f.related(2, "NEAR_HEAT")
    assert near.evidence == {"gap_m": pytest.approx(0.2)}
    (close,) = (r for r in f.related(2, "CLOSE") if r.target_id == 1)
    assert close.evidence == {"gap_m": pytest.approx(0.2)}
    f = facts(thing(1, "sofa", 1, 2), thing(2, "tv", 3, 3), thing(3, "table", 1, 1))
    (seen,) = f.related(1, "FACING")
    assert seen.evidence == {"facing_deg": pytest.approx(26.565, abs=1e-3)}
    f = facts(thing(1, "table", 2, 2), thing(2, "apple", 2, 2))
    (under,) = f.related(2, "UNDER")
    assert under.evidence == {"overlap": pytest.approx(1.0), "below_m": pytest.approx(0.67)}


def test_what_is_fixed_is_not_inside_the_loose_vessel_that_stands_on_it():
    vessel = thing(1, "fridge", 2, 2, room=ROOM).model_copy(update={"fixed": False})
    middle = thing(2, "table", 2, 2, 0.5)
    assert facts(vessel, middle).related(2, "INSIDE") == ()
    loose = middle.model_copy(update={"fixed": False})
    assert facts(vessel, loose).holds(2, "INSIDE") == (1,)


def test_a_bin_that_cannot_shut_as_it_is_leaves_nothing_undecided():
    lid = [
        {"state": "CLOSED", "joint": "door", "max": 0.03, "variants": ["default"]},
        {"state": "OPEN", "joint": "door", "min": 0.5, "variants": ["default"]},
    ]
    hollow = {"name": "in", "part": "body", "center_m": (0, 0, 0.3), "size_m": (0.3, 0.3, 0.6)}
    info = asset(
        "bin",
        (0.4, 0.4, 0.6),
        containers=[{**hollow, "closed_by": "door"}],
        states=lid,
        variants={"default": ["body", "door"], "full": ["body"]},
    )
    apple = thing(2, "apple", 2, 2, 0.2)

    def inside(variant):
        found = facts(thing(1, "bin", 2, 2, variant=variant), apple, more=[info])
        (bin_,) = found.related(2, "INSIDE")
        return bin_.states, bin_.undecided, found.undecided_states(1)

    assert inside("default") == (("CLOSED",), (), ())
    assert inside("full") == ((), (), ())
