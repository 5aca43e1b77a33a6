"""What is told of a measure near its limit: whether it holds, and whether that is sure.

Strong Kleene logic, as `output/README.md` asks: what is made of undecided parts is undecided where
they matter.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

#: Noise of floats: poses are on a grid of 1e-5 m.
NOISE = 1e-9


class Told(NamedTuple):
    """``holds`` as measured; ``sure`` where nothing undecided could turn it."""

    holds: bool
    sure: bool = True

    def denied(self) -> Told:
        return Told(not self.holds, self.sure)


YES, NO = Told(True), Told(False)


class Limit(NamedTuple):
    """A limit, and the values between which a measure says nothing."""

    at: float
    low: float
    high: float

    def _sure(self, value: float) -> bool:
        return value <= self.low + NOISE or value >= self.high - NOISE

    def at_most(self, value: float) -> Told:
        return Told(value <= self.at + NOISE, self._sure(value))

    def at_least(self, value: float) -> Told:
        return Told(value >= self.at - NOISE, self._sure(value))

    def more(self, value: float) -> Told:
        return self.at_most(value).denied()

    def less(self, value: float) -> Told:
        return self.at_least(value).denied()


def about(at: float, margin: float) -> Limit:
    """A limit with the same margin to both sides."""
    return Limit(at, at - margin, at + margin)


def every(parts: Iterable[Told]) -> Told:
    found = list(parts)
    if NO in found:
        return NO
    return Told(all(p.holds for p in found), all(p.sure for p in found))


def some(parts: Iterable[Told]) -> Told:
    return every(part.denied() for part in parts).denied()


def same(answers: Iterable[Told]) -> Told:
    """The first answer, sure where all are and agree: what a span of values says."""
    first, *others = answers
    return Told(first.holds, first.sure and all(other == first for other in others))


def number(members: Iterable[Told], least: int | None, most: int | None) -> tuple[Told, int]:
    """Whether so many hold as is asked for, and how many do as measured."""
    known = [member for member in members if member != NO]
    measured = sum(member.holds for member in known)

    def asked(many: int) -> bool:
        return (least is None or many >= least) and (most is None or many <= most)

    may_be = {asked(many) for many in range(known.count(YES), len(known) + 1)}
    return Told(asked(measured), len(may_be) == 1), measured
