"""A predicate in words, for people who read ``sdgen catalog show``."""

from __future__ import annotations

from collections.abc import Sequence

from sdgen.catalog.records import (
    AllTerm,
    AnyTerm,
    CategoryTerm,
    DistanceTerm,
    HeightTerm,
    NotTerm,
    Predicate,
    RelationTerm,
    RoomTerm,
    StateTerm,
)


def in_words(predicate: Predicate) -> str:
    """One line, such as ``it is stove, and it is ON``."""
    if isinstance(predicate, CategoryTerm):
        return f"it is a {_either(predicate.any_of)}"
    if isinstance(predicate, StateTerm):
        return f"it is {_either(predicate.any_of)}"
    if isinstance(predicate, RoomTerm):
        return f"it is in a {_either(predicate.any_of)}"
    if isinstance(predicate, RelationTerm):
        target = _either(predicate.targets) if predicate.targets else "something"
        state = f" that is {predicate.target_state}" if predicate.target_state else ""
        return f"it is {predicate.relation} {target}{state}"
    if isinstance(predicate, HeightTerm):
        return f"its lowest point is {_limits(predicate.min_m, predicate.max_m)} up"
    if isinstance(predicate, DistanceTerm):
        state = f" that is {predicate.to_state}" if predicate.to_state else ""
        limits = _limits(predicate.min_m, predicate.max_m)
        return f"it is {limits} from {_either(predicate.to)}{state}"
    if isinstance(predicate, AllTerm):
        return _joined(predicate.terms, ", and ")
    if isinstance(predicate, AnyTerm):
        return _joined(predicate.terms, ", or ")
    if isinstance(predicate, NotTerm):
        return f"not ({in_words(predicate.term)})"
    return f"at least {predicate.overlap:.0%} of it is in a {_either(predicate.any_of)}"


def _either(words: Sequence[str]) -> str:
    return " or ".join(words)


def _joined(terms: Sequence[Predicate], between: str) -> str:
    parts = [
        f"({in_words(term)})" if isinstance(term, AllTerm | AnyTerm) else in_words(term)
        for term in terms
    ]
    return between.join(parts) or "always"


def _limits(low: float | None, high: float | None) -> str:
    if low is not None and high is not None:
        return f"{low:g} to {high:g} m"
    if high is not None:
        return f"at most {high:g} m"
    return f"at least {low or 0.0:g} m"
