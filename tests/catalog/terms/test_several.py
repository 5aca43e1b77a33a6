"""count and holds: read, evaluated, measured, said. Swept in tests/facts."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.catalog.predicate import Member, Verdict
from sdgen.catalog.terms.several import counted
from sdgen.catalog.terms.term import ALWAYS, EITHER, Case
from sdgen.kleene import NO, YES, Kleene

from tests.catalog.worlds import Thing, World

from .reading import read

MAYBE, MAYBE_NOT = Kleene(True, False), Kleene(False, False)
DIRTY = ("DIRTY",)


@pytest.mark.parametrize(
    ("members", "low", "value", "sure"),
    [
        ((YES, YES, YES), 3, True, True),
        ((YES, YES), 3, False, True),
        ((YES, YES, MAYBE), 3, True, False),
        ((YES, YES, MAYBE_NOT), 3, False, False),
        ((YES, YES, YES, MAYBE_NOT), 3, True, True),
        ((YES, MAYBE, NO), 3, False, True),
    ],
)
def test_a_number_is_sure_when_no_undecided_member_could_change_the_answer(
    members: tuple[Kleene, ...], low: int, value: bool, sure: bool
) -> None:
    assert counted(members, low, None)[:2] == (value, sure)


_ANY = st.sampled_from([YES, NO, MAYBE, MAYBE_NOT])


@given(st.lists(_ANY, max_size=5), st.integers(1, 4), st.integers(0, 4))
def test_it_is_as_trying_every_way_says(members: list[Kleene], low: int, high: int) -> None:
    found = counted(members, low, max(low, high))
    ways = itertools.product(*({m.value} if m.sure else {True, False} for m in members))
    answers = {low <= sum(way) <= max(low, high) for way in ways}
    assert found.sure == (len(answers) == 1)
    assert found.value in answers


def dishes(*shared: Kleene, **more: Thing) -> World:
    """Object 1 is a dirty plate; the others share its counter, a dirty plate each."""
    members = tuple(Member(10 + k, holds) for k, holds in enumerate(shared))
    others = {m.object_id: Thing("plate", states=DIRTY) for m in members}
    return World({1: Thing("plate", states=DIRTY, sharing=members), **others})


PILE = read("count: {of: [plate, bowl], state: DIRTY, min: 3, on: same}")[0]


def test_dirty_dishes_on_one_counter() -> None:
    assert PILE.evaluate(1, dishes(YES, YES)) == Verdict(True, True, {"count": 3})
    assert PILE.evaluate(1, dishes(YES)) == Verdict(False, True)
    assert PILE.measure(1, dishes(YES)) == {"count": 2}
    assert not PILE.evaluate(1, dishes(YES, MAYBE_NOT)).sure
    clean = dishes(YES, YES)
    clean.things[11].states = ()
    assert PILE.evaluate(1, clean) == Verdict(False, True)
    clean.things[11].undecided = DIRTY
    assert PILE.evaluate(1, clean) == Verdict(False, False)
    # What is none of them itself is not counted.
    tap = dishes(YES, YES)
    tap.things[1].category = "shelf"
    assert PILE.evaluate(1, tap) == Verdict(False, True)


def test_things_near_each_other_in_a_room() -> None:
    near = read("count: {of: plate, min: 2, max: 3, within_m: 0.5}")[0]

    def beside(*gaps: float, **elsewhere: Kleene) -> World:
        found = tuple((gap, 2 + k) for k, gap in enumerate(gaps))
        rooms = {int(key[1:]): holds for key, holds in elsewhere.items()}
        one = Thing("plate", gaps={("plate",): found}, elsewhere=rooms)
        return World({1: one, **{k: Thing("plate") for _, k in found}})

    assert near.evaluate(1, beside(0.1)) == Verdict(True, True, {"count": 2})
    assert near.evaluate(1, beside()) == Verdict(False, True)
    assert near.evaluate(1, beside(0.6)) == Verdict(False, True)
    assert near.evaluate(1, beside(0.52)) == Verdict(False, False)
    assert near.evaluate(1, beside(0.1, 0.48)) == Verdict(True, True, {"count": 3})
    assert near.evaluate(1, beside(0.1, 0.1, 0.1)) == Verdict(False, True)
    assert near.evaluate(1, beside(0.1, _2=NO)) == Verdict(False, True)
    assert not near.evaluate(1, beside(0.1, _2=MAYBE)).sure


def test_what_stands_in_a_thing_or_on_it() -> None:
    full = World(
        {
            1: Thing("bowl", carried={"INSIDE": (Member(3, YES),), "ON": (Member(2, YES),)}),
            2: Thing("plate", states=DIRTY),
            3: Thing("tv"),
        }
    )
    for text, held in (
        ("{category: tv}", {"held": 1, "held_id": 3}),
        ("{category: [plate, tv], min: 2}", {"held": 2, "held_id": 2}),
        ("{category: [plate, tv], relation: INSIDE}", {"held": 1, "held_id": 3}),
        ("{category: [plate, tv], relation: ON, state: DIRTY}", {"held": 1, "held_id": 2}),
        ("{category: [plate, tv], state: CUT, max: 0}", {"held": 0}),
    ):
        term = read(f"holds: {text}")[0]
        assert term.evaluate(1, full) == Verdict(True, True, held), text
        assert term.measure(1, full) == held
    for text in ("{category: bed}", "{category: tv, relation: ON}", "{category: tv, max: 0}"):
        assert read(f"holds: {text}")[0].evaluate(1, full) == Verdict(False, True), text
    full.things[1].carried = {"INSIDE": (Member(3, MAYBE_NOT),), "ON": (Member(3, MAYBE),)}
    found = read("holds: {category: tv}")[0].evaluate(1, full)
    assert found == Verdict(True, False, {"held": 1, "held_id": 3})


def test_what_recipes_say_of_a_number() -> None:
    alone = read("count: {of: plate, state: DIRTY, min: 1, on: same}")[0]
    assert alone.possible(Case("plate", "DIRTY")) == ALWAYS
    assert alone.possible(Case("plate")) == EITHER
    assert alone.possible(Case("bowl", "DIRTY")) == EITHER
    assert PILE.possible(Case("plate", "DIRTY")) == EITHER
    assert read("holds: {category: plate}")[0].possible(Case("bowl")) == EITHER


def test_they_are_read_strictly_and_said() -> None:
    for text, problem in (
        ("count: {min: 3, on: same}", "count: missing key 'of'"),
        ("count: {of: plate, on: same}", "count: needs min or max (how many)"),
        ("count: {of: plate, min: 0, on: same}", "count.min: 0 is not between 1 and 65535"),
        ("count: {of: plate, min: 1.5, on: same}", "count.min: expected a whole number"),
        ("count: {of: plate, min: 3, max: 2, on: same}", "count.min: min (3) is above max (2)"),
        ("count: {of: plate, min: 3}", "count: needs either 'on: same' or within_m (metres)"),
        ("count: {of: plate, min: 3, on: same, within_m: 1}", "count: needs either 'on: same' or"),
        ("count: {of: plate, min: 3, on: table}", "count.on: 'table' is not one of same"),
        ("count: {of: plate, min: 3, within_m: 0.01}", "count.within_m: nothing is surely so near"),
        ("count: {of: plate, state: dirty, min: 3, on: same}", "write DIRTY"),
        ("holds: {}", "holds: missing key 'category'"),
        ("holds: {category: plate, relation: UNDER}", "holds.relation: 'UNDER' is not one of ON"),
        ("holds: {category: plate, min: true}", "holds.min: expected a whole number, got true"),
        ("holds: {of: plate, category: plate}", "holds.of: unknown key"),
    ):
        assert any(problem in found for found in read(text)[1]), (text, read(text)[1])
    words = {
        "count: {of: [plate, bowl], state: DIRTY, min: 3, on: same}": (
            "there are at least 3 plate or bowl that are DIRTY on or in the same thing"
        ),
        "count: {of: plate, min: 2, max: 4, within_m: 1}": "there are 2 to 4 plate within 1 m",
        "holds: {category: tv, relation: INSIDE}": "there is at least 1 tv in it",
        "holds: {category: tv, state: ON, max: 2}": "there is at most 2 tv that is ON on or in it",
    }
    assert {text: read(text)[0].in_words() for text in words} == words
