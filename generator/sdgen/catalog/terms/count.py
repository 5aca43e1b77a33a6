"""``count: {of: [plate, bowl], state: DIRTY, min: 3, on: same}``: so many are together.

Dishes that pile up on one counter, medicines that stand within arm's length of each other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.several import counted, limits_of, read_numbers
from sdgen.catalog.terms.state import of_state
from sdgen.catalog.terms.term import ALWAYS, EITHER, Can, Case, Scope, Term, either
from sdgen.kleene import Kleene, all_of, at_most

#: As that of ``distance``: gaps are between axis-aligned boxes.
MARGIN_M = 0.05


class CountTerm(Term):
    """So many things of these categories (in that state), the object itself included if it is one,
    are on or in the same thing as it, or within that gap in its room."""

    kind: Literal["count"] = "count"
    of: tuple[str, ...]
    state: str | None = None
    min: int | None = None
    max: int | None = None
    on: Literal["same"] | None = None
    within_m: float | None = None
    margin_m: float = MARGIN_M

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> CountTerm | None:
        if not reader.has("count"):
            return None
        below = reader.child("count")
        low, high = read_numbers(below, least=1)
        if below.ok and low is None and high is None:
            below.problem("needs min or max (how many)")
        term = cls(
            of=below.words("of", choices=scope.categories, what="category"),
            state=below.state("state", None),
            min=low,
            max=high,
            on=below.choice("on", ("same",), None),
            within_m=below.number("within_m", None, low=0.0, high=100.0),
            margin_m=below.number("margin_m", MARGIN_M, low=0.0, high=1.0),
        )
        if below.ok and below.has("on") == below.has("within_m"):
            below.problem("needs either 'on: same' or within_m (metres)")
        elif term.within_m is not None and term.within_m < term.margin_m:
            text = f"nothing is surely so near: the margin is {term.margin_m:g} m"
            below.problem(text, "within_m")
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        value, sure, found = counted(self._members(object_id, facts), self.min, self.max)
        return Verdict(value, sure, {"count": found} if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return {"count": counted(self._members(object_id, facts), None, None)[2]}

    def _members(self, object_id: int, facts: FactSource) -> Iterator[Kleene]:
        """Of each thing that may be one of them, whether it is."""
        if facts.category(object_id) in self.of:
            yield of_state(object_id, self.state, facts)
        for other, near in self._others(object_id, facts):
            yield all_of((near, of_state(other, self.state, facts)))

    def _others(self, object_id: int, facts: FactSource) -> Iterator[tuple[int, Kleene]]:
        if self.within_m is None:
            yield from facts.sharing(object_id, self.of)
            return
        for gap, other in facts.gaps(object_id, self.of):
            if gap >= self.within_m + self.margin_m:
                return
            near = at_most(gap, self.within_m, self.margin_m)
            yield other, all_of((near, facts.together(object_id, other)))

    def in_words(self) -> str:
        state = f" that are {self.state}" if self.state else ""
        where = (
            "on or in the same thing" if self.within_m is None else f"within {self.within_m:g} m"
        )
        return f"there are {limits_of(self.min, self.max)} {either(self.of)}{state} {where}"

    def possible(self, case: Case) -> Can:
        """It is one of them itself."""
        one = case.category in self.of and (self.state is None or case.state == self.state)
        sole = self.min in (None, 1) and self.max is None
        return ALWAYS if one and sole else EITHER
