"""Why a thing is a hazard, or why it is none: the clauses of the hazard's predicate, one by one."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from sdgen.catalog.terms import AllTerm, AnyTerm, CategoryTerm, NotTerm, Term
from sdgen.facts import Facts
from sdgen.gallery.words import measured, plain

#: Names of a list that are said; of more, how many there are.
_SAID = 4
_LIST = re.compile(r"\w+(?: or \w+){%d,}" % _SAID)


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
        text = {"all": "all of this", "any": "one of this", "not": "not so"}[term.kind]
        below = [_rule(one, object_id, facts, name) for one in term.within()]
        return Rule(text, holds, parts=tuple(below))
    if isinstance(term, CategoryTerm):
        text = f"it is a kind of: {_few(list(term.any_of))}"
        return Rule(text, holds, (("it is", plain(facts.category(object_id))),))
    text = _LIST.sub(lambda found: _few(found[0].split(" or ")), term.in_words())
    return Rule(plain(text), holds, measured(term.measure(object_id, facts), name))


def _few(names: list[str]) -> str:
    words = [plain(name) for name in names]
    if len(words) <= _SAID:
        return " or ".join(words)
    return f"{', '.join(words[: _SAID - 1])} … ({len(words)} kinds)"
