"""Unary facts of an object: the same terms that predicates use, so that they cannot disagree."""

from __future__ import annotations

from sdgen.catalog.predicate import FactSource
from sdgen.catalog.terms import AllTerm, HeightTerm, NotTerm, RelationTerm, Term, ZoneTerm
from sdgen.facts.measured import Measured
from sdgen.vocabulary import CHILD_REACH_M

#: Tag -> the predicate that says it. IN_REACH_OF_CHILD is for loose things only.
PREDICATES: dict[str, Term] = {
    "IN_DOORWAY": ZoneTerm(any_of=("doorway",)),
    "IN_REACH_OF_CHILD": AllTerm(
        terms=(
            HeightTerm(max_m=CHILD_REACH_M, evidence="reach_height_m"),
            NotTerm(term=RelationTerm(relation="INSIDE", target_state="CLOSED")),
        )
    ),
    "IN_WALKWAY": ZoneTerm(any_of=("walkway",)),
}


def tags(facts: FactSource, measured: Measured, object_id: int) -> tuple[str, ...]:
    """Tags that hold, sorted; as measured, also within a margin."""
    body = measured.bodies[object_id]
    out = [
        name
        for name, predicate in PREDICATES.items()
        if not (name == "IN_REACH_OF_CHILD" and body.item.fixed)
        and predicate.evaluate(object_id, facts).value
    ]
    under = {r.target_id for r in measured.on(object_id) if r.holds} & measured.bodies.keys()
    if any(measured.supports.near_edge(body, target) for target in under):
        out.append("NEAR_EDGE")
    return tuple(sorted(out))
