"""Verdicts: values, sureness, evidence."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from sdgen.catalog.predicate import Related, Span, Verdict, ZoneGap, ZoneShare
from sdgen.catalog.terms import (
    AllTerm,
    AnyTerm,
    CategoryTerm,
    DistanceTerm,
    EdgeTerm,
    HeightTerm,
    NotTerm,
    Predicate,
    RelationTerm,
    RoomTerm,
    StateTerm,
    ZoneTerm,
)
from sdgen.kleene import NO as NO_
from sdgen.kleene import Kleene

from .worlds import Thing, World, on


def verdict(predicate: Predicate, thing: Thing, **others: Thing) -> Verdict:
    things = {1: thing, **{int(key[1:]): other for key, other in others.items()}}
    return predicate.evaluate(1, World(things))


def test_category_and_room() -> None:
    assert verdict(CategoryTerm(any_of=("knife", "fork")), Thing("fork")) == Verdict(True, True)
    assert verdict(CategoryTerm(any_of=("knife",)), Thing("fork")) == Verdict(False, True)
    assert verdict(RoomTerm(any_of=("hall",)), Thing(room="hall")).value
    assert not verdict(RoomTerm(any_of=("hall",)), Thing(room="kitchen")).value


def test_states_in_the_dead_band_are_unsure() -> None:
    term = StateTerm(any_of=("OPEN", "BROKEN"))
    assert verdict(term, Thing(states=("OPEN",))) == Verdict(True, True, {"state": "OPEN"})
    assert verdict(term, Thing(states=("CLOSED",))) == Verdict(False, True)
    assert verdict(term, Thing(undecided=("CLOSED", "OPEN"))) == Verdict(False, False)
    # One door stands open, the other ajar: open all the same.
    assert verdict(term, Thing(states=("OPEN",), undecided=("OPEN",))).sure


@pytest.mark.parametrize(
    ("height", "value", "sure"),
    [
        (0.0, True, True),
        (1.27, True, True),
        (1.28, True, False),
        (1.3, True, False),
        (1.31, False, False),
        (1.33, False, True),
    ],
)
def test_height_has_a_margin(height: float, value: bool, sure: bool) -> None:
    term = HeightTerm(max_m=1.3, evidence="reach_height_m")
    found = verdict(term, Thing(height_m=height))
    assert (found.value, found.sure) == (value, sure)
    assert found.evidence == ({"reach_height_m": height} if value else {})


@pytest.mark.parametrize(
    ("height", "value", "sure"),
    [
        (0.9, False, True),
        (0.98, False, False),
        (1.02, True, False),
        (1.5, True, True),
        (1.98, True, False),
        (2.02, False, False),
        (3.0, False, True),
    ],
)
def test_height_between_two_limits(height: float, value: bool, sure: bool) -> None:
    found = verdict(HeightTerm(min_m=1.0, max_m=2.0), Thing(height_m=height))
    assert (found.value, found.sure) == (value, sure)


def test_distance_to_the_nearest() -> None:
    near, far = DistanceTerm(to=("stove",), max_m=0.5), DistanceTerm(to=("stove",), min_m=0.5)
    close_by = Thing(gaps={("stove",): ((0.2, 7),)})
    assert verdict(near, close_by) == Verdict(True, True, {"distance_m": 0.2, "nearest_id": 7})
    assert verdict(far, close_by) == Verdict(False, True)
    assert not verdict(near, Thing(gaps={("stove",): ((0.48, 7),)})).sure
    assert verdict(near, Thing()) == Verdict(False, True)
    assert verdict(far, Thing()) == Verdict(True, True)


def test_distance_to_a_zone_that_something_in_a_state_makes() -> None:
    near = DistanceTerm(to_zone=("heat",), max_m=0.5)
    cold, hot = ZoneGap(0.1, "heat:a", 7), ZoneGap(0.3, "heat:b", 8)
    thing = Thing("towel", zone_gaps=(("heat", cold), ("heat", hot)))
    stoves = {"_7": Thing("stove", states=("OFF",)), "_8": Thing("stove", states=("ON",))}
    nearest = {"distance_m": 0.1, "zone_name": "heat:a"}
    assert verdict(near, thing, **stoves) == Verdict(True, True, nearest)
    on = near.model_copy(update={"to_state": "ON"})
    found = verdict(on, thing, **stoves)
    assert found == Verdict(True, True, {"distance_m": 0.3, "zone_name": "heat:b"})
    assert verdict(DistanceTerm(to_zone=("water",), max_m=0.5), thing) == Verdict(False, True)
    # What nothing makes is in no state.
    bare = Thing(zone_gaps=(("heat", ZoneGap(0.1, "heat:c")),))
    assert verdict(near, bare).value
    assert verdict(on, bare) == Verdict(False, True)
    # Whether it is at its height may be undecided, seen from above it does not matter.
    level = Thing(zone_gaps=(("heat", ZoneGap(0.1, "heat:c", level=Kleene(True, False))),))
    assert not verdict(near, level).sure
    assert verdict(near.model_copy(update={"from_above": True}), level).sure
    # So may be whether it is in the same room, where that is asked for.
    next_door = Thing(zone_gaps=(("heat", ZoneGap(0.1, "heat:c", together=Kleene(False))),))
    assert verdict(near, next_door).value
    same = near.model_copy(update={"same_room": True})
    assert verdict(same, next_door) == Verdict(False, True)


def test_distance_within_its_room_and_seen_from_above() -> None:
    near = DistanceTerm(to=("stove",), max_m=0.5, same_room=True)
    gaps: dict[tuple[str, ...], tuple[tuple[float, int], ...]] = {("stove",): ((0.1, 7), (0.2, 8))}
    thing = Thing(gaps=gaps, elsewhere={7: Kleene(False)})
    assert verdict(near, thing) == Verdict(True, True, {"distance_m": 0.2, "nearest_id": 8})
    assert verdict(near, Thing(gaps=gaps, elsewhere={7: NO_, 8: NO_})) == Verdict(False, True)
    doubt = Thing(gaps=gaps, elsewhere={7: NO_, 8: Kleene(True, False)})
    assert not verdict(near, doubt).sure
    above = DistanceTerm(to=("stove",), max_m=0.5, from_above=True)
    assert verdict(above, Thing(gaps=gaps)) == Verdict(False, True)
    assert verdict(above, Thing(above=gaps)).evidence == {"distance_m": 0.1, "nearest_id": 7}


def test_zone_takes_the_largest_share() -> None:
    term = ZoneTerm(any_of=("doorway", "walkway"))
    a, b = ZoneShare("d:hall", "doorway", 0.2), ZoneShare("w:hall", "walkway", 0.8)
    assert verdict(term, Thing(zones=(a, b))).evidence == {
        "zone": "walkway",
        "zone_name": "w:hall",
        "zone_overlap": 0.8,
    }
    assert verdict(term, Thing(zones=(a,))) == Verdict(False, True)
    assert verdict(term, Thing(zones=(ZoneShare("x", "heat", 1.0),))) == Verdict(False, True)
    assert verdict(term, Thing()) == Verdict(False, True)
    half = verdict(term, Thing(zones=(ZoneShare("d", "doorway", 0.55),)))
    assert (half.value, half.sure) == (True, False)
    less = verdict(term, Thing(zones=(ZoneShare("d", "doorway", 0.45),)))
    assert (less.value, less.sure) == (False, False)


def test_relation_to_a_category() -> None:
    term = RelationTerm(relation="ON", targets=("floor",))
    both = Thing(related={"ON": (on(5, "rug"), on(6, "floor"))})
    assert verdict(term, both).evidence == {
        "relation": "ON",
        "target_id": 6,
        "target_category": "floor",
        "gap_m": 0.001,
    }
    assert verdict(RelationTerm(relation="ON"), both).evidence["target_id"] == 5
    assert verdict(term, Thing(related={"ON": (on(5, "rug"),)})) == Verdict(False, True)
    assert verdict(term, Thing(related={"INSIDE": (on(6, "floor"),)})) == Verdict(False, True)
    unsure = verdict(term, Thing(related={"ON": (on(6, "floor", sure=False),)}))
    assert (unsure.value, unsure.sure) == (True, False)
    unsure = verdict(term, Thing(related={"ON": (on(6, "floor", holds=False, sure=False),)}))
    assert (unsure.value, unsure.sure) == (False, False)


def test_two_relations_of_one_object_are_both_told() -> None:
    """A lamp on a bed, near the heat: neither relation takes the other's place in the evidence."""
    bed, warm = RelationTerm(relation="ON", targets=("bed",)), RelationTerm(relation="NEAR_HEAT")
    reach = HeightTerm(max_m=1.3, evidence="reach_height_m")
    near = Related(9, "stove", True, True, {"gap_m": 0.1})
    lamp = Thing(height_m=0.5, related={"ON": (on(5, "bed"),), "NEAR_HEAT": (near,)})
    both = {
        "relation": "ON",
        "target_id": 5,
        "target_category": "bed",
        "gap_m": 0.001,
        "relation_2": "NEAR_HEAT",
        "target_id_2": 9,
        "target_category_2": "stove",
        "gap_m_2": 0.1,
    }
    assert verdict(AllTerm(terms=(bed, warm)), lamp).evidence == both
    assert AllTerm(terms=(bed, warm)).measure(1, World({1: lamp})) == both
    assert AnyTerm(terms=(bed, warm)).measure(1, World({1: lamp})) == both
    # What is measured twice alike is told once, and a height keeps its name wherever it stands.
    assert verdict(AllTerm(terms=(bed, bed)), lamp).evidence == verdict(bed, lamp).evidence
    nested = AllTerm(terms=(bed, AllTerm(terms=(warm, reach))))
    assert verdict(nested, lamp).evidence == both | {"reach_height_m": 0.5}
    gaps = {("stove",): ((2.0, 7),), ("tv",): ((3.0, 8),), ("bed",): ((4.0, 9),)}
    three = tuple(DistanceTerm(to=to, min_m=1.0) for to in gaps)
    assert verdict(AllTerm(terms=three), Thing(gaps=gaps)).evidence == {
        "distance_m": 2.0,
        "nearest_id": 7,
        "distance_m_2": 3.0,
        "nearest_id_2": 8,
        "distance_m_3": 4.0,
        "nearest_id_3": 9,
    }


def test_relation_to_something_in_a_state() -> None:
    term = RelationTerm(relation="INSIDE", targets=("fridge",), target_state="OPEN")
    inside = Thing("cheese", related={"INSIDE": (on(2, "fridge"),)})
    assert verdict(term, inside, _2=Thing("fridge", states=("OPEN",))).value
    assert verdict(term, inside, _2=Thing("fridge", states=("CLOSED",))) == Verdict(False, True)
    ajar = verdict(term, inside, _2=Thing("fridge", undecided=("OPEN", "CLOSED")))
    assert (ajar.value, ajar.sure) == (False, False)


def test_the_leaf_that_shuts_a_container_counts_not_the_furniture() -> None:
    """A knife in the sink's basin is not shut in because the cupboard below it is."""
    term = RelationTerm(relation="INSIDE", target_state="CLOSED")
    sink = Thing("sink_cabinet", states=("CLOSED",))

    def inside(states: tuple[str, ...], undecided: tuple[str, ...] = ()) -> Verdict:
        related = Related(2, "sink_cabinet", True, True, {}, states, undecided)
        return verdict(term, Thing(related={"INSIDE": (related,)}), _2=sink)

    assert inside(("CLOSED",)).value
    assert inside(()) == Verdict(False, True)
    assert inside((), ("CLOSED", "OPEN")) == Verdict(False, False)


YES, NO = Verdict(True, True), Verdict(False, True)
MAYBE_YES, MAYBE_NO = Verdict(True, False), Verdict(False, False)


def term_for(index: int, wanted: Verdict) -> tuple[Predicate, ZoneShare]:
    """A zone term of its own kind of zone, and the share that gives the wanted verdict."""
    kind = ("doorway", "walkway", "swing", "heat")[index]
    share = {(True, True): 0.9, (False, True): 0.1, (True, False): 0.55, (False, False): 0.45}
    fraction = share[wanted.value, wanted.sure]
    return ZoneTerm(any_of=(kind,)), ZoneShare(kind, kind, fraction)


@pytest.mark.parametrize(
    ("parts", "both", "either"),
    [
        ((YES, YES), YES, YES),
        ((YES, NO), NO, YES),
        ((NO, NO), NO, NO),
        ((YES, MAYBE_YES), MAYBE_YES, YES),
        ((YES, MAYBE_NO), MAYBE_NO, YES),
        ((NO, MAYBE_YES), NO, MAYBE_YES),
        ((NO, MAYBE_NO), NO, MAYBE_NO),
        ((MAYBE_YES, MAYBE_NO), MAYBE_NO, MAYBE_YES),
    ],
)
def test_all_any_and_not_are_kleene(
    parts: tuple[Verdict, ...], both: Verdict, either: Verdict
) -> None:
    for ordered in (parts, parts[::-1]):
        made = [term_for(index, wanted) for index, wanted in enumerate(ordered)]
        terms = tuple(term for term, _ in made)
        thing = Thing(zones=tuple(share for _, share in made))
        for predicate, wanted in ((AllTerm(terms=terms), both), (AnyTerm(terms=terms), either)):
            found = verdict(predicate, thing)
            assert (found.value, found.sure) == (wanted.value, wanted.sure)
            turned = verdict(NotTerm(term=predicate), thing)
            assert (turned.value, turned.sure) == (not wanted.value, wanted.sure)
            assert turned.evidence == {}


def test_evidence_comes_from_the_terms_that_made_it_true() -> None:
    low, wide = HeightTerm(max_m=1.0), ZoneTerm(any_of=("doorway",))
    thing = Thing(height_m=0.5, zones=(ZoneShare("d", "doorway", 0.1),))
    assert verdict(AnyTerm(terms=(wide, low)), thing).evidence == {"height_m": 0.5}
    assert verdict(AllTerm(terms=(low, wide)), thing).evidence == {}
    thing = Thing(height_m=0.5, zones=(ZoneShare("d", "doorway", 0.9),))
    found = verdict(AllTerm(terms=(low, wide)), thing).evidence
    assert found == {"height_m": 0.5, "zone": "doorway", "zone_name": "d", "zone_overlap": 0.9}


def test_a_near_miss_is_measured_all_the_same() -> None:
    low, wide = HeightTerm(max_m=1.0), ZoneTerm(any_of=("doorway",))
    far = DistanceTerm(to=("stove",), max_m=1.0)
    inside = NotTerm(term=HeightTerm(max_m=9.0, evidence="reach_height_m"))
    world = World({1: Thing(height_m=1.8, zones=(ZoneShare("d", "doorway", 0.1),))})
    predicate = AllTerm(terms=(CategoryTerm(any_of=("fork",)), low, wide, far, inside))
    assert predicate.measure(1, world) == {"height_m": 1.8, "zone_overlap": 0.1}


def test_the_category_decides_before_anything_is_measured() -> None:
    world = World({1: Thing("sofa")})
    predicate = AllTerm(terms=(HeightTerm(max_m=1.0), CategoryTerm(any_of=("knife",))))
    assert predicate.evaluate(1, world) == Verdict(False, True)
    assert world.dear == 0


def test_what_a_floor_plan_is_made_for_is_asked_last() -> None:
    class Plain(World):
        def edge(self, object_id: int) -> Span:
            raise AssertionError("asked")

    world = Plain({1: Thing(height_m=1.8)})
    predicate = AllTerm(terms=(EdgeTerm(max_m=0.1), HeightTerm(max_m=1.0)))
    assert predicate.evaluate(1, world) == Verdict(False, True)


def test_evidence_is_never_minus_zero() -> None:
    low, near = HeightTerm(max_m=1.0), DistanceTerm(to=("stove",), max_m=1.0)
    world = World({1: Thing(height_m=-1e-6, gaps={("stove",): ((-0.0, 7),)})})
    for term in (low, near):
        for evidence in (term.evaluate(1, world).evidence, term.measure(1, world)):
            assert "-0.0" not in [str(value) for value in evidence.values()]


_MARGIN = 0.02


def _predicates() -> st.SearchStrategy[Predicate]:
    limit = st.sampled_from([0.3, 0.6, 0.9, 1.2])
    height = limit.map(lambda m: HeightTerm(max_m=m, margin_m=_MARGIN))
    distance = limit.map(lambda m: DistanceTerm(to=("stove",), min_m=m, margin_m=_MARGIN))
    zone = limit.filter(lambda m: m < 1).map(
        lambda m: ZoneTerm(any_of=("heat",), overlap=m, margin=_MARGIN)
    )
    leaf: st.SearchStrategy[Predicate] = st.one_of(height, distance, zone)
    return st.recursive(
        leaf,
        lambda inner: st.one_of(
            st.lists(inner, min_size=1, max_size=3).map(lambda t: AllTerm(terms=tuple(t))),
            st.lists(inner, min_size=1, max_size=3).map(lambda t: AnyTerm(terms=tuple(t))),
            inner.map(lambda t: NotTerm(term=t)),
        ),
        max_leaves=6,
    )


_METRES = st.floats(0.0, 1.5, allow_nan=False)
_SHIFT = st.floats(-0.99 * _MARGIN, 0.99 * _MARGIN, allow_nan=False)


@given(_predicates(), st.tuples(_METRES, _METRES, _METRES), st.tuples(_SHIFT, _SHIFT, _SHIFT))
def test_a_sure_verdict_survives_any_change_within_the_margins(
    predicate: Predicate,
    at: tuple[float, float, float],
    shift: tuple[float, float, float],
) -> None:
    def world(height: float, gap: float, share: float) -> World:
        zones = (ZoneShare("h", "heat", share),)
        return World({1: Thing(height_m=height, gaps={("stove",): ((gap, 2),)}, zones=zones)})

    found = predicate.evaluate(1, world(*at))
    assume(found.sure)
    moved = [a + b for a, b in zip(at, shift, strict=True)]
    assert predicate.evaluate(1, world(*moved)).value == found.value
    assert all(not isinstance(v, float) or math.isfinite(v) for v in found.evidence.values())
