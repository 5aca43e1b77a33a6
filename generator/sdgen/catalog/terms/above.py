"""``above: {of: [bed, sofa], within_m: 0.3, drop_m: 0.3}``: it would fall onto such a thing.

A heavy vase on the shelf over a bed, a picture above the sofa.
"""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Overlooked, Verdict, any_verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import EITHER, NEVER, Can, Case, Scope, Term, either
from sdgen.kleene import EPS, all_of, at_least, at_most

#: As far aside as what is knocked off lands, about, metres; and how much higher counts.
WITHIN_M = 0.3
DROP_M = 0.3
#: Outlines and tops of soft furniture are true to a few centimetres.
MARGIN_M = 0.05


class AboveTerm(Term):
    """The object's lowest point is at least ``drop_m`` above the top of something of these
    categories in its room, and seen from above the gap between their outlines is at most
    ``within_m``."""

    kind: Literal["above"] = "above"
    of: tuple[str, ...]
    within_m: float = WITHIN_M
    drop_m: float = DROP_M
    margin_m: float = MARGIN_M

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> AboveTerm | None:
        if not reader.has("above"):
            return None
        below = reader.child("above")
        term = cls(
            of=below.words("of", choices=scope.categories, what="category"),
            within_m=below.number("within_m", WITHIN_M, low=0.0, high=10.0),
            drop_m=below.number("drop_m", DROP_M, low=0.0, high=10.0),
            margin_m=below.number("margin_m", MARGIN_M, low=0.0, high=1.0),
        )
        if term.within_m < term.margin_m - EPS:
            text = f"nothing is surely so near: the margin is {term.margin_m:g} m"
            below.problem(text, "within_m")
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return any_verdict(self._over(found) for found in facts.overlooked(object_id, self.of))

    def _over(self, found: Overlooked) -> Verdict:
        near = at_most(found.gap_m, self.within_m, self.margin_m)
        higher = at_least(found.drop_m, self.drop_m, self.margin_m)
        value, sure = all_of((found.together, near, higher))
        return Verdict(value, sure, _evidence(found) if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return next(map(_evidence, facts.overlooked(object_id, self.of)), {})

    def in_words(self) -> str:
        return (
            f"it is at least {self.drop_m:g} m above {either(self.of)}, and seen from above at "
            f"most {self.within_m:g} m beside it"
        )

    def possible(self, case: Case) -> Can:
        """Nothing has a top below the floor."""
        return NEVER if case.on_the_floor and self.drop_m > self.margin_m else EITHER


def _evidence(found: Overlooked) -> Evidence:
    return {
        "above_id": found.target_id,
        "above_gap_m": rounded(found.gap_m),
        "above_drop_m": rounded(found.drop_m),
    }
