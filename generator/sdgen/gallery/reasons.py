"""Why a thing is a hazard, or why it is none: the clauses of the hazard's predicate, one by one."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from sdgen.catalog.terms import AllTerm, AnyTerm, CategoryTerm, NotTerm, Term
from sdgen.facts import Facts
from sdgen.gallery.words import measured, plain

#: Names of a list that are said; of more, how many there are.
_SAID = 4
_LIST = re.compile(rf"\w+(?: or \w+){{{_SAID},}}")


@dataclass(frozen=True)
class Rule:
    """A clause: whether it holds of a thing, what was measured, and the clauses it is made of."""

    text: str
    holds: bool
    measured: tuple[tuple[str, str], ...] = ()
    parts: tuple[Rule, ...] = ()


def rules_of(
    predicate: Term, object_id: int, facts: Facts, name: Callable[[int], str]
) -> tuple[Rule, ...]:
    """The clauses that must all hold, with how it is with this thing."""
    terms = predicate.terms if isinstance(predicate, AllTerm) else (predicate,)
    return tuple(_rule(term, object_id, facts, name) for term in terms)


def _rule(term: Term, object_id: int, facts: Facts, name: Callable[[int], str]) -> Rule:
    holds = term.evaluate(object_id, facts).value
    if isinstance(term, AllTerm | AnyTerm | NotTerm):
        inner = term.term if isinstance(term, NotTerm) else term
        text = "all of this" if isinstance(inner, AllTerm) else "one of this"
        if inner is not term:
            text = "not all of this" if isinstance(inner, AllTerm) else "none of this"
        terms = inner.within() if isinstance(inner, AllTerm | AnyTerm) else (inner,)
        # Of several cases those that speak of things of other kinds say nothing of this one.
        meant = [one for one in terms if not _of_other_kinds(one, object_id, facts)]
        parts = [_rule(one, object_id, facts, name) for one in meant]
        if len(meant) < len(terms):
            parts.append(Rule(f"cases of other kinds ({len(terms) - len(meant)})", False))
        return Rule(text, holds, parts=tuple(parts))
    if isinstance(term, CategoryTerm):
        here = (("here", plain(facts.category(object_id))),)
        return Rule(f"kind: {_few(term.any_of)}", holds, here)
    text = _LIST.sub(lambda found: _few(found[0].split(" or ")), term.in_words())
    return Rule(plain(text), holds, measured(term.measure(object_id, facts), name))


def _of_other_kinds(term: Term, object_id: int, facts: Facts) -> bool:
    kinds = [one for one in term.within() if isinstance(one, CategoryTerm)]
    return isinstance(term, AllTerm) and not all(
        kind.evaluate(object_id, facts).value for kind in kinds
    )


def _few(names: Sequence[str]) -> str:
    words = [plain(name) for name in names]
    if len(words) <= _SAID:
        return " or ".join(words)
    return f"{', '.join(words[: _SAID - 1])} … ({len(words)} kinds)"
