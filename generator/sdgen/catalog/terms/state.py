"""``state: ON``: what state the object is in; undecided between a joint's two limits."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import ClassVar, Literal

from sdgen.catalog.predicate import FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term, either
from sdgen.kleene import YES, Kleene

#: States of which a thing is never in both.
OPPOSITE = {"ON": "OFF", "OFF": "ON", "OPEN": "CLOSED", "CLOSED": "OPEN"}


class StateTerm(Term):
    """The object is in one of these states."""

    kind: Literal["state"] = "state"
    any_of: tuple[str, ...]

    cheap: ClassVar[bool] = True

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> StateTerm | None:
        if not reader.has("state"):
            return None
        return cls(any_of=reader.states("state"))

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return in_state(
            self.any_of, facts.states(object_id), lambda: facts.undecided_states(object_id)
        )

    def in_words(self) -> str:
        return f"it is {either(self.any_of)}"

    def possible(self, case: Case) -> Can:
        if case.state in self.any_of:
            return ALWAYS
        if set(self.any_of) <= set(case.not_state):
            return NEVER
        return NEVER if set(self.any_of) == {OPPOSITE.get(case.state or "")} else EITHER


def in_state(
    wanted: Collection[str], holding: Collection[str], undecided: Callable[[], Collection[str]]
) -> Verdict:
    """Whether one of some states holds, given those that do and those too near to call."""
    for state in wanted:
        if state in holding:
            return Verdict(True, True, {"state": state})
    open_question = undecided()
    return Verdict(False, not any(state in open_question for state in wanted))


def of_state(object_id: int, state: str | None, facts: FactSource) -> Kleene:
    """Whether an object is in a state, if one is asked for."""
    if state is None:
        return YES
    undecided = facts.undecided_states
    found = in_state((state,), facts.states(object_id), lambda: undecided(object_id))
    return Kleene(found.value, found.sure)
