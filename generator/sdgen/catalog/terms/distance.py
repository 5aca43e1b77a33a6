"""``distance: {to: [stove], to_state: ON, max_m: 0.5}``: how near the nearest such thing is."""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits, within
from sdgen.catalog.terms.term import Scope, Term, either

#: Gaps are between axis-aligned boxes, which a turn of a degree or two changes by centimetres.
MARGIN_M = 0.05


class DistanceTerm(Term):
    """Gap between the object's box and the nearest object of one of these categories."""

    kind: Literal["distance"] = "distance"
    to: tuple[str, ...]
    to_state: str | None = None
    min_m: float | None = None
    max_m: float | None = None
    margin_m: float = MARGIN_M

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> DistanceTerm | None:
        if not reader.has("distance"):
            return None
        below = reader.child("distance")
        low, high = read_limits(below)
        term = cls(
            to=below.words("to", choices=scope.categories, what="category"),
            to_state=below.state("to_state", None),
            min_m=low,
            max_m=high,
            margin_m=below.number("margin_m", MARGIN_M, low=0.0, high=1.0),
        )
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        gap, nearest = facts.distance(object_id, self.to, self.to_state)
        if nearest is None:
            # Nothing there: nearer than something is false, farther than it is true.
            return Verdict(self.max_m is None, True)
        value, sure = within(gap, self.min_m, self.max_m, self.margin_m)
        evidence: Evidence = {"distance_m": round(gap, 4), "nearest_id": nearest}
        return Verdict(value, sure, evidence if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        gap, nearest = facts.distance(object_id, self.to, self.to_state)
        return {} if nearest is None else {"distance_m": round(gap, 4), "nearest_id": nearest}

    def in_words(self) -> str:
        state = f" that is {self.to_state}" if self.to_state else ""
        return f"it is {limits_in_words(self.min_m, self.max_m)} from {either(self.to)}{state}"
