"""Numbers of things within limits: what ``count`` and ``holds`` share."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from sdgen.catalog.reader import Reader
from sdgen.kleene import NO, YES, Kleene

#: No home has more of anything: ids have 16 bits.
MANY = 65535


class Counted(NamedTuple):
    """Whether a number is within limits, how surely, and the number as measured."""

    value: bool
    sure: bool
    number: int


def read_numbers(reader: Reader, least: int) -> tuple[int | None, int | None]:
    """``min`` (from 1) and ``max`` (from ``least``) of a mapping, each of which may be left out."""
    low = reader.whole("min", None, low=1, high=MANY)
    high = reader.whole("max", None, low=least, high=MANY)
    if low is not None and high is not None and low > high:
        reader.problem(f"min ({low}) is above max ({high})", "min")
    return low, high


def counted(members: Iterable[Kleene], low: int | None, high: int | None) -> Counted:
    """How many there are, and whether within the limits: sure when no change of undecided members
    could change that."""
    known = [belongs for belongs in members if belongs != NO]
    number = sum(belongs.value for belongs in known)
    surely, perhaps = known.count(YES), len(known)

    def within(number: int) -> bool:
        return (low is None or number >= low) and (high is None or number <= high)

    value = within(number)
    sure = all(within(could) == value for could in range(surely, perhaps + 1))
    return Counted(value, sure, number)


def limits_of(low: int | None, high: int | None) -> str:
    """``at least 3``."""
    if low is not None and high is not None:
        return f"{low}" if low == high else f"{low} to {high}"
    return f"at most {high}" if high is not None else f"at least {low or 0}"
