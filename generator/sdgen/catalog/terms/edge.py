"""``edge: {max_m: 0.08}``: how near the object is to the edge of what it is on.

A heavy thing that a push sends down. An edge is where a drop begins: none where the neighbouring
worktop goes on, against a wall, or where the floor is right below.
"""

from __future__ import annotations

import math
from typing import ClassVar, Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits, within_span
from sdgen.catalog.terms.term import EITHER, NEVER, Can, Case, Scope, Term
from sdgen.kleene import Kleene, all_of

#: An outline is that of the whole piece, a knob or a rim included.
MARGIN_M = 0.02


class EdgeTerm(Term):
    """How far the object's outline is from where a drop begins, metres, within limits; 0 where it
    reaches over. Not of what has no edge: ON nothing, on the floor, walled in."""

    kind: Literal["edge"] = "edge"
    min_m: float | None = None
    max_m: float | None = None
    margin_m: float = MARGIN_M

    dear: ClassVar[bool] = True

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> EdgeTerm | None:
        if not reader.has("edge"):
            return None
        below = reader.child("edge")
        low, high, margin = read_limits(below, MARGIN_M)
        below.done()
        return cls(min_m=low, max_m=high, margin_m=margin)

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        edge = facts.edge(object_id)
        some, all_ways = math.isfinite(edge.measured_m), map(math.isfinite, edge)
        there = Kleene(some, all(has == some for has in all_ways))
        limits = within_span(edge, self.min_m, self.max_m, self.margin_m)
        value, sure = all_of((there, limits))
        return Verdict(value, sure, {"edge_m": rounded(edge.measured_m)} if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        edge_m = facts.edge(object_id).measured_m
        return {"edge_m": rounded(edge_m)} if math.isfinite(edge_m) else {}

    def in_words(self) -> str:
        return f"it is {limits_in_words(self.min_m, self.max_m)} from the edge of what it is on"

    def possible(self, case: Case) -> Can:
        return NEVER if case.on_the_floor else EITHER
