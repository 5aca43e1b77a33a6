"""Why a try was thrown away, as a record: made in one way everywhere, never parsed from text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

Stage = Literal["home", "hazards", "physics", "proof", "views", "twin", "worker"]


class Cause(NamedTuple):
    """What rejections are counted by.

    ``stage`` of the pipeline, ``check`` that failed (snake_case, such as ``no_place``), and, where
    they apply, the ``hazard`` at fault, the ``category`` concerned and the ``other`` hazard whose
    predicate claimed what this one's recipe made.
    """

    stage: Stage
    check: str
    hazard: str | None = None
    category: str | None = None
    other: str | None = None

    def in_words(self) -> str:
        """One short line for people; nothing reads it back."""
        words = self.check.replace("_", " ")
        if self.category is not None:
            words = f"{words} ({self.category})"
        if self.other is not None:
            words = f"{words} as {self.other}"
        return f"{self.hazard or self.stage}: {words}"


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
