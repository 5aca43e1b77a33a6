"""``category: [knife, scissors]``: what the object is. Exact: a lookup has no threshold."""

from __future__ import annotations

from typing import ClassVar, Literal

from sdgen.catalog.predicate import FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import ALWAYS, NEVER, Can, Case, Scope, Term, either


class CategoryTerm(Term):
    """The object is of one of these categories."""

    kind: Literal["category"] = "category"
    any_of: tuple[str, ...]

    cheap: ClassVar[bool] = True

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> CategoryTerm | None:
        if not reader.has("category"):
            return None
        return cls(any_of=reader.words("category", choices=scope.categories, what="category"))

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return Verdict(facts.category(object_id) in self.any_of, True)

    def in_words(self) -> str:
        return f"it is a {either(self.any_of)}"

    def possible(self, case: Case) -> Can:
        return ALWAYS if case.category in self.any_of else NEVER
