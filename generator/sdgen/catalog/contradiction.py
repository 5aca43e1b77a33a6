"""Predicates that hold of nothing, or of everything: what follows from their terms alone.

A predicate is written out as its ways to hold, each a list of plain terms that must hold or must
not. A way whose terms contradict one another is none.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import NamedTuple

from sdgen.catalog.terms import (
    AllTerm,
    AnyTerm,
    CategoryTerm,
    HeightTerm,
    NotTerm,
    RelationTerm,
    RoomTerm,
    StateTerm,
    Term,
)
from sdgen.catalog.terms.state import OPPOSITE
from sdgen.catalog.terms.term import either
from sdgen.vocabulary import DOORS, STRUCTURES

#: Ways to hold that are looked at: of ours the most has 18. What has more is left to the builds.
_MOST_WAYS = 2000


class Plain(NamedTuple):
    """A term that is made of no others, and whether it must hold."""

    term: Term
    holds: bool


Way = tuple[Plain, ...]
#: Says why a way is none; empty where it might be one.
Objection = Callable[[Way], str]


def never(predicate: Term, *further: Objection) -> str:
    """Why a predicate can hold of nothing; empty where it might hold, as far as one can tell."""
    return _no_way(predicate, True, (_objection, *further))


def always(predicate: Term) -> bool:
    """True for a predicate that holds of everything, as far as one can tell."""
    return _no_way(predicate, False, (_objection,)) != ""


def _no_way(predicate: Term, holds: bool, objections: Collection[Objection]) -> str:
    ways = _ways(predicate, holds)
    reasons = []
    for way in ways or ():
        reason = next((text for objects in objections if (text := objects(way))), "")
        if not reason:
            return ""
        reasons.append(reason)
    return "; ".join(dict.fromkeys(reasons))


def _ways(term: Term, holds: bool) -> list[Way] | None:
    """The ways in which a term holds (or does not); None where they are too many."""
    if isinstance(term, NotTerm):
        return _ways(term.term, not holds)
    if not isinstance(term, AllTerm | AnyTerm):
        return [(Plain(term, holds),)]
    together = isinstance(term, AllTerm) == holds
    out: list[Way] = [()] if together else []
    for part in term.terms:
        below = _ways(part, holds)
        if below is None or (len(out) * len(below) if together else len(out)) > _MOST_WAYS:
            return None
        out = [(*a, *b) for a in out for b in below] if together else [*out, *below]
    return out


def _objection(way: Way) -> str:
    held = [plain.term for plain in way if plain.holds]
    denied = [plain.term for plain in way if not plain.holds]
    return next(
        (
            text
            for text in (
                *(f"not both: {term.in_words()}, and not" for term in held if term in denied),
                _words(held, denied, CategoryTerm, "of a category"),
                _words(held, denied, RoomTerm, "in a room"),
                _states(held),
                _heights(held),
                _kinds(held),
            )
            if text
        ),
        "",
    )


def _left(
    held: list[Term], denied: list[Term], kind: type[CategoryTerm | RoomTerm]
) -> set[str] | None:
    """The words that all terms of a kind leave; None where they leave any."""
    asked = [set(term.any_of) for term in held if isinstance(term, kind)]
    if not asked:
        return None
    left = set.intersection(*asked)
    return left.difference(*(term.any_of for term in denied if isinstance(term, kind)))


def _words(
    held: list[Term], denied: list[Term], kind: type[CategoryTerm | RoomTerm], what: str
) -> str:
    if _left(held, denied, kind) != set():
        return ""
    asked = [either(term.any_of) for term in held if isinstance(term, kind)]
    return f"nothing is {what} that is {', and '.join(asked)}" + (
        "" if len(asked) > 1 else ", and none of what 'not' names"
    )


def _states(held: list[Term]) -> str:
    terms = [term for term in held if isinstance(term, StateTerm)]
    for first in terms:
        for second in terms:
            if all(OPPOSITE.get(a) == b for a in first.any_of for b in second.any_of):
                return f"nothing is {either(first.any_of)} and {either(second.any_of)}"
    return ""


def _heights(held: list[Term]) -> str:
    terms = [term for term in held if isinstance(term, HeightTerm)]
    for evidence in ("height_m", "reach_height_m"):
        low = max(
            (t.min_m for t in terms if t.min_m is not None and t.evidence == evidence), default=0.0
        )
        high = min(
            (t.max_m for t in terms if t.max_m is not None and t.evidence == evidence),
            default=low,
        )
        if low > high:
            return f"nothing is at least {low:g} m and at most {high:g} m up"
    return ""


def _kinds(held: list[Term]) -> str:
    """What is no thing, and what stands in no such relation."""
    categories = _left(held, [], CategoryTerm)
    if categories is not None and categories <= set(STRUCTURES):
        return f"{either(sorted(categories))} is no object: predicates are asked of things"
    for term in held:
        if not isinstance(term, RelationTerm):
            continue
        if term.relation == "BETWEEN" and categories is not None and not categories & set(DOORS):
            return f"only doors are BETWEEN rooms, no {either(sorted(categories))}"
        if term.relation == "INSIDE" and term.targets and set(term.targets) <= set(STRUCTURES):
            return f"nothing is INSIDE a {either(term.targets)}"
    return ""


def models_object(
    library_states: Mapping[str, Collection[str]], library_holding: Mapping[str, Collection[str]]
) -> Objection:
    """The objection to ways that ask for what no model can be: a state that none of the categories
    has, a target that holds nothing."""

    def objects(way: Way) -> str:
        held = [plain.term for plain in way if plain.holds]
        return next(_unmade(held, library_states, library_holding), "")

    return objects


def _unmade(
    held: list[Term],
    library_states: Mapping[str, Collection[str]],
    library_holding: Mapping[str, Collection[str]],
) -> Iterator[str]:
    categories = _left(held, [], CategoryTerm)
    # Of what has no model nothing is known.
    made = sorted((categories or set()) & library_states.keys())
    for term in held:
        if isinstance(term, StateTerm) and made:
            known = {state for name in made for state in library_states[name]}
            if not known & set(term.any_of):
                yield f"no model of {either(made)} can be {either(term.any_of)}"
        if isinstance(term, RelationTerm) and term.relation == "INSIDE" and term.targets:
            there = [name for name in term.targets if name in library_states]
            if there and not set(there) & set(library_holding["INSIDE"]):
                yield f"no model of {either(there)} has a hollow to be INSIDE of"
