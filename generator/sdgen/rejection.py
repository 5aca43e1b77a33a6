"""Why a try was thrown away, as a record: made in one way everywhere, never parsed from text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

Stage = Literal["home", "hazards", "physics", "proof", "views", "twin", "worker"]


class Cause(NamedTuple):
    """What rejections are counted by.

    ``stage`` of the pipeline, ``check`` that failed (snake_case, such as ``no_place``), and, where
    they apply, the ``hazard`` at fault, the ``category`` (or room type) concerned, the ``other``
    hazard whose predicate claimed what this one's recipe made, and the ``state`` concerned.
    """

    stage: Stage
    check: str
    hazard: str | None = None
    category: str | None = None
    other: str | None = None
    state: str | None = None

    def in_words(self) -> str:
        """One short line for people; nothing reads it back."""
        return f"{self.hazard or self.stage}: {self.what()}"

    def what(self) -> str:
        """The part of the line that says what went wrong, without whose fault it was."""
        words = self.check.replace("_", " ")
        concerned = " ".join(part for part in (self.category, self.state) if part is not None)
        if concerned:
            words = f"{words} ({concerned})"
        if self.other is not None:
            words = f"{words} as {self.other}"
        return words

    @property
    def overlap(self) -> bool:
        """One hazard's anomaly satisfies another's predicate too: placing it anew seldom helps."""
        return self.hazard is not None and self.other is not None

    def sort_key(self) -> tuple[tuple[bool, str], ...]:
        """Causes by stage, check, hazard, category, other, state; what is not there comes first."""
        return tuple((part is not None, part or "") for part in self)


@dataclass(frozen=True)
class Rejection:
    """One failed try: its cause, the objects concerned, and what was measured against which limit
    (both None where the check measures nothing)."""

    cause: Cause
    objects: tuple[int, ...] = ()
    measured: float | None = None
    limit: float | None = None


#: How often each cause threw a try away.
Causes = Mapping[Cause, int]


def reject(
    stage: Stage,
    check: str,
    *,
    hazard: str | None = None,
    category: str | None = None,
    other: str | None = None,
    state: str | None = None,
    objects: tuple[int, ...] = (),
    measured: float | None = None,
    limit: float | None = None,
) -> Rejection:
    """The one way to make a rejection."""
    return Rejection(Cause(stage, check, hazard, category, other, state), objects, measured, limit)


def most_frequent(causes: Causes) -> list[tuple[Cause, int]]:
    """Causes with their counts, most frequent first, then by name."""
    return sorted(causes.items(), key=lambda pair: (-pair[1], pair[0].sort_key()))


def causes_in_words(causes: Causes, most: int | None = None) -> str:
    """``spill: no place x3, home: no free floor x1``; the ``most`` frequent ones only."""
    shown = most_frequent(causes)[:most]
    return ", ".join(f"{cause.in_words()} x{count}" for cause, count in shown)
