"""``min_m`` and ``max_m``: a measured length within limits, with a margin."""

from __future__ import annotations

from collections.abc import Iterable

from sdgen.catalog.predicate import Span
from sdgen.catalog.reader import Reader
from sdgen.kleene import Kleene, all_of, at_least, at_most


def read_limits(reader: Reader, margin_m: float) -> tuple[float | None, float | None, float]:
    """Both limits of a mapping, metres, of which one may be left out, and the margin."""
    low = reader.number("min_m", None, low=0.0, high=100.0)
    high = reader.number("max_m", None, low=0.0, high=100.0)
    if reader.ok and not reader.has("min_m") and not reader.has("max_m"):
        reader.problem("needs min_m or max_m (metres)")
    if low == 0.0:
        # It would be true of everything, yet in doubt of what is within the margin of 0.
        reader.problem("0 is no lower limit: nothing is less; leave it out", "min_m")
    if low is not None and high is not None and low > high:
        reader.problem(f"min_m ({low:g}) is above max_m ({high:g})", "min_m")
    margin = float(reader.number("margin_m", margin_m, low=0.0, high=1.0))
    if high is not None and high - (low or 0.0) < (margin if low is None else 2 * margin):
        reader.problem(f"nothing is surely within these limits: the margin is {margin:g} m")
    return low, high, margin


def within(measured: float, low: float | None, high: float | None, margin: float) -> Kleene:
    """Between the limits; undecided nearer than ``margin`` to one that matters."""
    parts = [] if low is None else [at_least(measured, low, margin)]
    parts += [] if high is None else [at_most(measured, high, margin)]
    return all_of(parts)


def within_span(span: Span, low: float | None, high: float | None, margin: float) -> Kleene:
    """Between the limits, whatever it may be of what it spans."""
    parts = [] if low is None else [_same(at_least(m, low, margin) for m in span)]
    parts += [] if high is None else [_same(at_most(m, high, margin) for m in span)]
    return all_of(parts)


def _same(answers: Iterable[Kleene]) -> Kleene:
    """The first answer: sure when all are, and agree."""
    first, *others = answers
    return Kleene(first.value, first.sure and all(other == first for other in others))


def limits_in_words(low: float | None, high: float | None) -> str:
    """``at most 1.3 m``."""
    if low is not None and high is not None:
        return f"{low:g} to {high:g} m"
    if high is not None:
        return f"at most {high:g} m"
    return f"at least {low or 0.0:g} m"
