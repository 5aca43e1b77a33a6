"""``facing_away: {from: [tv], min_deg: 120}``: the object's front is turned away from something.

A screen that cannot be seen from the sofa, a photo frame that faces the wall behind the chair.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.heading import HeadingTerm
from sdgen.catalog.terms.term import Scope, either
from sdgen.kleene import Kleene, at_least
from sdgen.vocabulary import HEADING_MARGIN_DEG

#: More behind than ahead.
MIN_DEG = 90.0


class FacingAwayTerm(HeadingTerm):
    """Seen from above, the angle between the object's front and the direction to the centre of
    something of these categories in its room is at least so large."""

    kind: Literal["facing_away"] = "facing_away"
    away_from: tuple[str, ...]
    min_deg: float = MIN_DEG
    margin_deg: float = HEADING_MARGIN_DEG

    angle_name: ClassVar[str] = "away_deg"
    thing_name: ClassVar[str] = "away_from_id"
    widest: ClassVar[bool] = True

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

    @property
    def towards(self) -> tuple[str, ...]:
        return self.away_from

    def keeps(self, angle_deg: float) -> Kleene:
        return at_least(angle_deg, self.min_deg, self.margin_deg)

    def in_words(self) -> str:
        return f"its front is at least {self.min_deg:g} degrees away from {either(self.away_from)}"
