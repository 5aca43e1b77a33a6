"""Truth near a threshold: strong Kleene logic (Kleene 1952, section 64) over measured values.

A value that lies within a margin of its threshold is *undecided*: it still has a value as
measured, but it is not sure. What is made of parts is sure when no change of its undecided parts
could change it, so that anyone who measures again agrees with whatever is sure.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

#: Float noise of a threshold test: poses are on a grid of 1e-5 m.
EPS = 1e-9


class Kleene(NamedTuple):
    """A truth value: ``value`` as measured, ``sure`` when it clears every margin that matters."""

    value: bool
    sure: bool = True

    def negated(self) -> Kleene:
        """The opposite, as sure."""
        return Kleene(not self.value, self.sure)


YES, NO = Kleene(True), Kleene(False)


def at_most(measured: float, limit: float, margin: float) -> Kleene:
    """``measured`` is at most ``limit``; sure when at least ``margin`` away from it."""
    return Kleene(measured <= limit + EPS, abs(measured - limit) >= margin - EPS)


def at_least(measured: float, limit: float, margin: float) -> Kleene:
    """``measured`` is at least ``limit``; sure when at least ``margin`` away from it."""
    return Kleene(measured >= limit - EPS, abs(measured - limit) >= margin - EPS)


def all_of(parts: Iterable[Kleene]) -> Kleene:
    """True when all are: surely false when one surely is, sure otherwise when all are sure."""
    value, sure = True, True
    for part in parts:
        if part == NO:
            return NO
        value, sure = value and part.value, sure and part.sure
    return Kleene(value, sure)


def any_of(parts: Iterable[Kleene]) -> Kleene:
    """True when one is: surely true when one surely is, sure otherwise when all are sure."""
    return all_of(part.negated() for part in parts).negated()
