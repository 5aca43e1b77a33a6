"""``height: {max_m: 1.3}``: how high the object's lowest point is above the floor."""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits, within
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term

#: Settling moves things by millimetres; nobody would call three centimetres of height a mistake.
MARGIN_M = 0.03


class HeightTerm(Term):
    """Height of the object's lowest point above the floor, metres, within limits.

    ``evidence`` names the measured height in the evidence (``reach_height_m`` where a child's
    reach decides).
    """

    kind: Literal["height"] = "height"
    min_m: float | None = None
    max_m: float | None = None
    margin_m: float = MARGIN_M
    evidence: Literal["height_m", "reach_height_m"] = "height_m"

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> HeightTerm | None:
        if not reader.has("height"):
            return None
        below = reader.child("height")
        low, high, margin = read_limits(below, MARGIN_M)
        term = cls(
            min_m=low,
            max_m=high,
            margin_m=margin,
            evidence=below.choice("evidence", ("height_m", "reach_height_m"), "height_m"),
        )
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        height = facts.height(object_id)
        value, sure = within(height, self.min_m, self.max_m, self.margin_m)
        return Verdict(value, sure, {self.evidence: rounded(height)} if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return {self.evidence: rounded(facts.height(object_id))}

    def in_words(self) -> str:
        return f"its lowest point is {limits_in_words(self.min_m, self.max_m)} up"

    def possible(self, case: Case) -> Can:
        floor = case.relation == "ON" and case.target == "floor"
        low = 0.0 if floor else case.min_height_m
        high = 0.0 if floor else case.max_height_m
        under = high is not None and self.min_m is not None and high < self.min_m
        over = low is not None and self.max_m is not None and low > self.max_m
        if under or over:
            return NEVER
        above = self.min_m is None or (low is not None and low >= self.min_m + self.margin_m)
        below = self.max_m is None or (high is not None and high <= self.max_m - self.margin_m)
        return ALWAYS if above and below else EITHER
