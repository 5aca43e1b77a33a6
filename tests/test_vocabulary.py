"""One vocabulary: what is written as data agrees with what the package takes it to be."""

from __future__ import annotations

from collections.abc import Iterator
from typing import get_args

from sdgen.catalog.load import load_catalog
from sdgen.catalog.terms import HeightTerm, Term
from sdgen.freespace import THROUGH_DOOR_M
from sdgen.households import reach_at
from sdgen.scene import Opening, Zone
from sdgen.vocabulary import (
    CHILD_REACH_M,
    DOORS,
    HALF_WALL_M,
    OPENINGS,
    OVERHEAD_M,
    ZONE_KINDS,
)

CATALOG = load_catalog()


def within(term: Term) -> Iterator[Term]:
    """A term and all terms in it."""
    yield term
    for inner in term.within():
        yield from within(inner)


def test_each_hazard_asks_for_the_reach_of_the_oldest_child_it_concerns() -> None:
    """And tags and zones for that of those who are poisoned."""
    limits = {
        hazard.id: (term.max_m, reach_at(hazard.concerns.max_age or 0, CATALOG.reach))
        for hazard in CATALOG.hazards
        for term in within(hazard.predicate)
        if isinstance(term, HeightTerm) and term.evidence == "reach_height_m"
    }
    assert all(asked == reached for asked, reached in limits.values()), limits
    same = {"poison_cleaning", "poison_medication"}
    assert {name for name, (limit, _) in limits.items() if limit == CHILD_REACH_M} == same


def test_words_are_those_of_the_records() -> None:
    assert get_args(Opening.model_fields["kind"].annotation) == OPENINGS
    assert get_args(Zone.model_fields["kind"].annotation) == ZONE_KINDS
    assert set(DOORS) < set(OPENINGS)
    assert {c.name for c in CATALOG.categories if c.kind == "opening"} == set(OPENINGS)


def test_wall_and_overhead_measures_fit_the_homes() -> None:
    assert HALF_WALL_M < THROUGH_DOOR_M < 2 * HALF_WALL_M
    hung = [
        rule.z_m
        for room in CATALOG.room_types
        for rule in room.furniture
        if rule.category in ("wall_cabinet", "wall_shelf", "bathroom_cabinet")
    ]
    assert hung
    assert min(hung) >= OVERHEAD_M
