"""``facing: {to: [sofa], max_deg: 45}``: the object's front points at something in its room.

A heater that blows at the curtain, a screen before a chair. The relation FACING is narrower: of
seats alone, towards what is looked at or sat at, and with a limit of its own.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.heading import HeadingTerm
from sdgen.catalog.terms.term import Scope, either
from sdgen.kleene import Kleene, at_most
from sdgen.vocabulary import HEADING_MARGIN_DEG

#: Half of a right angle to each side.
MAX_DEG = 45.0


class FacingTerm(HeadingTerm):
    """Seen from above, the angle between the object's front and the direction to the centre of
    something of these categories in its room is at most so large."""

    kind: Literal["facing"] = "facing"
    to: tuple[str, ...]
    max_deg: float = MAX_DEG
    margin_deg: float = HEADING_MARGIN_DEG

    angle_name: ClassVar[str] = "facing_deg"
    thing_name: ClassVar[str] = "facing_id"
    widest: ClassVar[bool] = False

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> FacingTerm | None:
        if not reader.has("facing"):
            return None
        below = reader.child("facing")
        term = cls(
            to=below.words("to", choices=scope.categories, what="category"),
            max_deg=below.number("max_deg", MAX_DEG, low=1.0, high=179.0),
            margin_deg=below.number("margin_deg", HEADING_MARGIN_DEG, low=0.0, high=45.0),
        )
        if not term.margin_deg <= term.max_deg <= 180.0 - term.margin_deg:
            below.problem(f"nothing surely faces it: the margin is {term.margin_deg:g} degrees")
        below.done()
        return term

    @property
    def towards(self) -> tuple[str, ...]:
        return self.to

    def keeps(self, angle_deg: float) -> Kleene:
        return at_most(angle_deg, self.max_deg, self.margin_deg)

    def in_words(self) -> str:
        return f"its front points within {self.max_deg:g} degrees of {either(self.to)}"
