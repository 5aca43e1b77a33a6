"""``facing_away: {from: [tv], min_deg: 120}``: the object's front is turned away from something.

A screen that cannot be seen from the sofa, a photo frame that faces the wall behind the chair.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Literal

from sdgen.catalog.predicate import Bearing, Evidence, FactSource, Verdict, any_verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import Scope, Term, either
from sdgen.kleene import Kleene, all_of, at_least
from sdgen.vocabulary import HEADING_MARGIN_DEG

#: More behind than ahead.
MIN_DEG = 90.0


class FacingAwayTerm(Term):
    """Seen from above, the angle between the object's front and the direction to the centre of
    something of these categories in its room is at least so large."""

    kind: Literal["facing_away"] = "facing_away"
    away_from: tuple[str, ...]
    min_deg: float = MIN_DEG
    margin_deg: float = HEADING_MARGIN_DEG

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> FacingAwayTerm | None:
        if not reader.has("facing_away"):
            return None
        below = reader.child("facing_away")
        term = cls(
            away_from=below.words("from", choices=scope.categories, what="category"),
            min_deg=below.number("min_deg", MIN_DEG, low=1.0, high=179.0),
            margin_deg=below.number("margin_deg", HEADING_MARGIN_DEG, low=0.0, high=45.0),
        )
        if not term.margin_deg <= term.min_deg <= 180.0 - term.margin_deg:
            below.problem(f"nothing surely faces away: the margin is {term.margin_deg:g} degrees")
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return any_verdict(self._from(found) for found in self._widest_first(object_id, facts))

    def _from(self, found: Bearing) -> Verdict:
        away = at_least(math.degrees(found.angle_rad), self.min_deg, self.margin_deg)
        away = Kleene(away.value, away.sure and found.clear)
        value, sure = all_of((found.together, away))
        return Verdict(value, sure, _evidence(found) if value else {})

    def _widest_first(self, object_id: int, facts: FactSource) -> Iterable[Bearing]:
        found = facts.bearings(object_id, self.away_from)
        return sorted(found, key=lambda one: (-one.angle_rad, one.target_id))

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return next(map(_evidence, self._widest_first(object_id, facts)), {})

    def in_words(self) -> str:
        return f"its front is at least {self.min_deg:g} degrees away from {either(self.away_from)}"


def _evidence(found: Bearing) -> Evidence:
    return {"away_deg": rounded(math.degrees(found.angle_rad)), "away_from_id": found.target_id}
