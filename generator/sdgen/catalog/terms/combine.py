"""``all``, ``any`` and ``not``: terms made of terms, by strong Kleene logic."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from sdgen.catalog.predicate import (
    Evidence,
    FactSource,
    Verdict,
    add_evidence,
    all_verdicts,
    any_verdict,
)
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import Can, Case, Scope, Term
from sdgen.strict import shown

if TYPE_CHECKING:
    # At run time the registry gives pydantic the union of all terms.
    from sdgen.catalog.terms.term import Term as Predicate


class AllTerm(Term):
    """Every term holds."""

    kind: Literal["all"] = "all"
    terms: tuple[Predicate, ...]

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> AllTerm | None:
        return cls(terms=_listed(reader, "all", scope)) if reader.has("all") else None

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return all_verdicts(term.evaluate(object_id, facts) for term in self.cheap_first)

    @cached_property
    def cheap_first(self) -> tuple[Term, ...]:
        """The terms in the order they are asked: most pairs of object and hazard end early."""
        return tuple(sorted(self.terms, key=lambda term: (not term.cheap, term.dear)))

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return _measured(self.terms, object_id, facts)

    def in_words(self) -> str:
        return _joined(self.terms, ", and ")

    def possible(self, case: Case) -> Can:
        parts = [term.possible(case) for term in self.terms]
        return Can(all(p.be_true for p in parts), any(p.be_false for p in parts))

    def within(self) -> tuple[Term, ...]:
        return self.terms


class AnyTerm(Term):
    """Some term holds."""

    kind: Literal["any"] = "any"
    terms: tuple[Predicate, ...]

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> AnyTerm | None:
        return cls(terms=_listed(reader, "any", scope)) if reader.has("any") else None

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return any_verdict(term.evaluate(object_id, facts) for term in self.terms)

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return _measured(self.terms, object_id, facts)

    def in_words(self) -> str:
        return _joined(self.terms, ", or ")

    def possible(self, case: Case) -> Can:
        parts = [term.possible(case) for term in self.terms]
        return Can(any(p.be_true for p in parts), all(p.be_false for p in parts))

    def within(self) -> tuple[Term, ...]:
        return self.terms


class NotTerm(Term):
    """The term does not hold."""

    kind: Literal["not"] = "not"
    term: Predicate

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> NotTerm | None:
        if not reader.has("not"):
            return None
        return cls(term=scope.read(reader.source, (*reader.path, "not"), reader.data["not"]))

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        inner = self.term.evaluate(object_id, facts)
        return Verdict(not inner.value, inner.sure)

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return {}

    def in_words(self) -> str:
        return f"not ({self.term.in_words()})"

    def possible(self, case: Case) -> Can:
        inner = self.term.possible(case)
        return Can(inner.be_false, inner.be_true)

    def within(self) -> tuple[Term, ...]:
        return (self.term,)


def _listed(reader: Reader, key: str, scope: Scope) -> tuple[Term, ...]:
    value = reader.data[key]
    if not isinstance(value, list) or not value:
        reader.problem(f"expected a list of terms, got {shown(value)}", key)
        return ()
    return tuple(
        scope.read(reader.source, (*reader.path, key, index), item)
        for index, item in enumerate(value)
    )


def _measured(terms: Sequence[Term], object_id: int, facts: FactSource) -> Evidence:
    out: Evidence = {}
    for term in terms:
        add_evidence(out, term.measure(object_id, facts))
    return out


def _joined(terms: Sequence[Term], between: str) -> str:
    nested = (AllTerm, AnyTerm)
    parts = [
        f"({term.in_words()})" if isinstance(term, nested) else term.in_words() for term in terms
    ]
    return between.join(parts) or "always"
