"""``holds: {category: [grapes, chocolate], relation: INSIDE}``: what stands in it, or on it.

A full bin, a bowl of nuts, a tray with glasses.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.several import counted, limits_of, read_numbers
from sdgen.catalog.terms.state import of_state
from sdgen.catalog.terms.term import Scope, Term, either
from sdgen.kleene import NO, Kleene, all_of, any_of
from sdgen.vocabulary import HOLDING, HoldingRelation


class HoldsTerm(Term):
    """So many things of these categories (in that state) are INSIDE the object or ON it: in one of
    its hollows, whatever they stand on there; on it, or on or in something that stands on it."""

    kind: Literal["holds"] = "holds"
    category: tuple[str, ...]
    relation: HoldingRelation | None = None
    state: str | None = None
    min: int | None = 1
    max: int | None = None

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> HoldsTerm | None:
        if not reader.has("holds"):
            return None
        below = reader.child("holds")
        low, high = read_numbers(below, least=0)
        term = cls(
            category=below.words("category", choices=scope.categories, what="category"),
            relation=below.choice("relation", HOLDING, None),
            state=below.state("state", None),
            min=1 if low is None and high is None else low,
            max=high,
        )
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        members = list(self._members(object_id, facts))
        value, sure, found = counted((holds for _, holds in members), self.min, self.max)
        return Verdict(value, sure, _evidence(found, members) if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        members = list(self._members(object_id, facts))
        return _evidence(counted((holds for _, holds in members), None, None)[2], members)

    def _members(self, object_id: int, facts: FactSource) -> Iterator[tuple[int, Kleene]]:
        """Of each thing that it may hold, by id, whether it does."""
        relations = HOLDING if self.relation is None else (self.relation,)
        found: dict[int, list[Kleene]] = {}
        for relation in relations:
            for other, holds in facts.carried(object_id, self.category, relation):
                found.setdefault(other, []).append(holds)
        for other, ways in sorted(found.items()):
            holds = all_of((any_of(ways), of_state(other, self.state, facts)))
            if holds != NO:
                yield other, holds

    def in_words(self) -> str:
        state = f" that is {self.state}" if self.state else ""
        where = {"ON": "on", "INSIDE": "in"}.get(self.relation or "", "on or in")
        number = limits_of(self.min, self.max)
        return f"there is {number} {either(self.category)}{state} {where} it"


def _evidence(number: int, members: list[tuple[int, Kleene]]) -> Evidence:
    evidence: Evidence = {"held": number}
    first = next((other for other, holds in members if holds.value), None)
    if first is not None:
        evidence["held_id"] = first
    return evidence
