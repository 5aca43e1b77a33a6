"""``relation: ON, target: [floor], target_state: OPEN``: how the object stands to others.

Each relation's threshold and margin is that of ``sdgen.facts``, which finds the candidates.
"""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Related, Verdict, any_verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.state import in_state
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term, either
from sdgen.vocabulary import RELATIONS


class RelationTerm(Term):
    """The object stands in ``relation`` to an object (or floor) of one of these categories.

    Empty ``targets`` means any target. ``target_state`` further asks that the target be in
    that state.
    """

    kind: Literal["relation"] = "relation"
    relation: str
    targets: tuple[str, ...] = ()
    target_state: str | None = None

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> RelationTerm | None:
        if not reader.has("relation"):
            if reader.has("target") or reader.has("target_state"):
                reader.problem("'target' needs a 'relation' beside it (such as relation: ON)")
            return None
        state = reader.state("target_state", None)
        relation = reader.choice("relation", RELATIONS)
        # A door is BETWEEN rooms: those are named by their types.
        between = relation == "BETWEEN"
        targets = reader.words(
            "target",
            (),
            choices=scope.rooms if between else scope.categories,
            what="room type" if between else "category",
        )
        if between and state is not None:
            reader.problem("rooms have no states", "target_state")
        return cls(relation=relation, targets=targets, target_state=state)

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return any_verdict(
            self._to(candidate, facts)
            for candidate in facts.related(object_id, self.relation)
            if not self.targets or candidate.target_category in self.targets
        )

    def _to(self, item: Related, facts: FactSource) -> Verdict:
        evidence: Evidence = {"relation": self.relation, "target_id": item.target_id}
        evidence["target_category"] = item.target_category
        evidence.update({key: rounded(value) for key, value in item.evidence.items()})
        if self.target_state is None:
            return Verdict(item.holds, item.sure, evidence if item.holds else {})
        wanted = (self.target_state,)
        if item.states is None:
            of = item.target_id
            state = in_state(wanted, facts.states(of), lambda: facts.undecided_states(of))
        else:
            state = in_state(wanted, item.states, lambda: item.undecided)
        if (not item.holds and item.sure) or (not state.value and state.sure):
            return Verdict(False, True)
        value = item.holds and state.value
        evidence["target_state"] = self.target_state
        return Verdict(value, item.sure and state.sure, evidence if value else {})

    def in_words(self) -> str:
        target = either(self.targets) if self.targets else "something"
        state = f" that is {self.target_state}" if self.target_state else ""
        return f"it is {self.relation} {target}{state}"

    def possible(self, case: Case) -> Can:
        if case.relation != self.relation:
            return EITHER
        if self.targets and case.target not in self.targets:
            return NEVER
        return EITHER if self.target_state else ALWAYS
