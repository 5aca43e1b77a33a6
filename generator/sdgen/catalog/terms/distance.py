"""``distance: {to: [stove], to_state: ON, max_m: 0.5}``: how near the nearest such thing is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits
from sdgen.catalog.terms.state import in_state
from sdgen.catalog.terms.term import Scope, Term, either
from sdgen.kleene import NO, YES, Kleene, all_of, any_of, at_least, at_most

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
        low, high, margin = read_limits(below, MARGIN_M)
        term = cls(
            to=below.words("to", choices=scope.categories, what="category"),
            to_state=below.state("to_state", None),
            min_m=low,
            max_m=high,
            margin_m=margin,
        )
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        """Nothing that counts is nearer than ``min_m``, and something is within ``max_m``. Which
        things count may be undecided, too: those whose state is."""
        found = facts.gaps(object_id, self.to)
        parts = []
        if self.min_m is not None:
            low = self.min_m
            nearer = (at_least(gap, low, self.margin_m).negated() for gap, _ in found)
            parts.append(self._any(nearer, found, facts).negated())
        if self.max_m is not None:
            high = self.max_m
            parts.append(
                self._any((at_most(gap, high, self.margin_m) for gap, _ in found), found, facts)
            )
        value, sure = all_of(parts)
        return Verdict(value, sure, self.measure(object_id, facts) if value else {})

    def _any(
        self, limits: Iterable[Kleene], found: Sequence[tuple[float, int]], facts: FactSource
    ) -> Kleene:
        """Some thing keeps the limit and counts."""
        return any_of(
            NO if limit == NO else all_of((limit, self._counts(other, facts)))
            for limit, (_, other) in zip(limits, found, strict=True)
        )

    def _counts(self, other: int, facts: FactSource) -> Kleene:
        if self.to_state is None:
            return YES
        undecided = facts.undecided_states
        state = in_state((self.to_state,), facts.states(other), lambda: undecided(other))
        return Kleene(state.value, state.sure)

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        for gap, other in facts.gaps(object_id, self.to):
            if self._counts(other, facts).value:
                return {"distance_m": rounded(gap), "nearest_id": other}
        return {}

    def in_words(self) -> str:
        state = f" that is {self.to_state}" if self.to_state else ""
        return f"it is {limits_in_words(self.min_m, self.max_m)} from {either(self.to)}{state}"
