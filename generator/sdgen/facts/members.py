"""Which things are among several: what shares a table with a thing, what a thing holds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdgen.catalog.predicate import Member
from sdgen.facts.measured import Measured
from sdgen.kleene import NO, Kleene, all_of, any_of


def sharing(facts: Measured, object_id: int, others: Iterable[int]) -> Iterator[Member]:
    """Those of some others that something carries which carries the object, too."""
    mine = facts.carriers(object_id)
    for other in sorted(others):
        if other == object_id:
            continue
        theirs = facts.carriers(other)
        both = (all_of((mine[k].either, theirs[k].either)) for k in mine.keys() & theirs.keys())
        yield from _member(other, any_of(both))


def carried(
    facts: Measured, object_id: int, others: Iterable[int], relation: str
) -> Iterator[Member]:
    """Those of some others that the object holds: ON it also what stands on, or lies in, what
    stands on it; INSIDE it those in its hollows themselves, whatever they stand on there."""
    for other in sorted(others):
        if other == object_id:
            continue
        if relation == "ON":
            carrier = facts.carriers(other).get(object_id)
            holds = NO if carrier is None else carrier.on
        else:
            hollows = (r for r in facts.inside(other) if r.target_id == object_id)
            holds = any_of(Kleene(r.holds, r.sure) for r in hollows)
        yield from _member(other, holds)


def _member(other: int, belongs: Kleene) -> Iterator[Member]:
    if belongs != NO:
        yield Member(other, belongs)
