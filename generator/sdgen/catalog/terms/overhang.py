"""``overhang: {min_m: 0.05}``: how far the object reaches over an edge.

A pan's handle over the edge of the worktop. An edge is where a drop begins: over the neighbouring
worktop, or over the floor that is right below, there is none.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits, within_span
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term

#: Models and the outlines of what things stand on are true to millimetres.
MARGIN_M = 0.01


class OverhangTerm(Term):
    """How far the object reaches beyond all that would catch it, metres, within limits: 0 where it
    is ON nothing, or where the floor would catch it."""

    kind: Literal["overhang"] = "overhang"
    min_m: float | None = None
    max_m: float | None = None
    margin_m: float = MARGIN_M

    dear: ClassVar[bool] = True

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> OverhangTerm | None:
        if not reader.has("overhang"):
            return None
        below = reader.child("overhang")
        low, high, margin = read_limits(below, MARGIN_M)
        below.done()
        return cls(min_m=low, max_m=high, margin_m=margin)

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        over = facts.overhang(object_id)
        value, sure = within_span(over, self.min_m, self.max_m, self.margin_m)
        return Verdict(value, sure, {"overhang_m": rounded(over.measured_m)} if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return {"overhang_m": rounded(facts.overhang(object_id).measured_m)}

    def in_words(self) -> str:
        return f"it reaches {limits_in_words(self.min_m, self.max_m)} over an edge"

    def possible(self, case: Case) -> Can:
        if not case.on_the_floor:
            return EITHER
        return ALWAYS if self.min_m is None else NEVER
