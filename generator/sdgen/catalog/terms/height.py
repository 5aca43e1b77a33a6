"""``height: {max_m: 1.3}``: how high the object's lowest point is above the floor.

Where a child's reach decides (``evidence: reach_height_m``), above where a child gets to stand: the
floor, or something near that it climbs on.
"""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, ReachHeight, Verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits, within
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term
from sdgen.kleene import Kleene

#: Settling moves things by millimetres; nobody would call three centimetres of height a mistake.
MARGIN_M = 0.03


class HeightTerm(Term):
    """Height of the object's lowest point, metres, within limits.

    ``evidence`` names the measured height in the evidence: ``height_m`` is above the floor,
    ``reach_height_m`` above where a child gets to stand. Where that is not the floor,
    ``height_m`` and ``climbed_id`` are there, too.
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
        if self.evidence == "height_m":
            height = facts.height(object_id)
            value, sure = self._within(height)
            return Verdict(value, sure, {"height_m": rounded(height)} if value else {})
        reach = facts.reach(object_id)
        value, sure = self._within(reach.above_m)
        # Undecided where something stands so far off that it may or may not be climbed on.
        sure = sure and all(self._within(m) == (value, True) for m in (reach.least_m, reach.most_m))
        return Verdict(value, sure, _evidence(reach) if value else {})

    def _within(self, height_m: float) -> Kleene:
        return within(height_m, self.min_m, self.max_m, self.margin_m)

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        if self.evidence == "height_m":
            return {"height_m": rounded(facts.height(object_id))}
        return _evidence(facts.reach(object_id))

    def in_words(self) -> str:
        limits = limits_in_words(self.min_m, self.max_m)
        if self.evidence == "height_m":
            return f"its lowest point is {limits} up"
        return f"its lowest point is {limits} above where a child gets to stand"

    def possible(self, case: Case) -> Can:
        floor = case.on_the_floor
        low = 0.0 if floor else case.min_height_m
        high = 0.0 if floor else case.max_height_m
        # Above the floor; who climbs may be nearer to it, by as much as nobody knows.
        climbs = self.evidence == "reach_height_m" and not floor
        under = high is not None and self.min_m is not None and high < self.min_m
        over = low is not None and self.max_m is not None and low > self.max_m and not climbs
        if under or over:
            return NEVER
        above = self.min_m is None or (
            low is not None and low >= self.min_m + self.margin_m and not climbs
        )
        below = self.max_m is None or (high is not None and high <= self.max_m - self.margin_m)
        return ALWAYS if above and below else EITHER


def _evidence(reach: ReachHeight) -> Evidence:
    found: Evidence = {"reach_height_m": rounded(reach.above_m)}
    if reach.climbed_id is not None:
        found |= {"height_m": rounded(reach.height_m), "climbed_id": reach.climbed_id}
    return found
