"""Is going on in vain? Watches a build for a hazard that can be placed but never be made.

A predicate that its own recipe does not meet, or a model that nobody can see, shows only when
scenes are made. What is decided here follows from the scenes' numbers alone: outcomes count in
the order of the indices, whichever worker is first, so a build stops at the same scene every time.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable
from dataclasses import dataclass

from sdgen.hazards.inject import ALREADY_SET
from sdgen.rejection import Cause, Causes, causes_in_words, most_frequent

#: Scenes that fail for good, mostly through one hazard that no scene before them shows, end a
#: build. A hazard is in about every fifth scene: a small --range seldom draws one so often, and
#: a long build knows after some twenty scenes.
FAILURES = 4
MOSTLY = 0.5


@dataclass(frozen=True)
class _Failure:
    index: int
    causes: Causes


class EarlyStop:
    """Takes in the outcome of every scene of ``indices``, in any order."""

    def __init__(self, hazards: Iterable[str], indices: Iterable[int]) -> None:
        self._hazards = sorted(hazards)
        self._open = sorted(indices, reverse=True)
        self._early: dict[int, Collection[str] | _Failure] = {}
        self._shown: set[str] = set()
        self._failures: list[_Failure] = []

    def made(self, index: int, hazards: Collection[str]) -> str | None:
        """A scene is there with these hazards; why to stop, if its predecessors say so."""
        return self._take(index, hazards)

    def failed(self, index: int, causes: Causes) -> str | None:
        """A scene failed for good; why to stop, when going on is in vain."""
        return self._take(index, _Failure(index, causes))

    def _take(self, index: int, outcome: Collection[str] | _Failure) -> str | None:
        self._early[index] = outcome
        while self._open and self._open[-1] in self._early:
            known = self._early.pop(self._open.pop())
            if not isinstance(known, _Failure):
                self._shown.update(known)
                continue
            self._failures.append(known)
            verdict = self._verdict()
            if verdict is not None:
                return verdict
        return None

    def _verdict(self) -> str | None:
        """The hazard for whose sake enough scenes so far failed, while none shows it."""
        for name in self._hazards:
            if name in self._shown:
                continue
            against = [(f, _against(name, f.causes)) for f in self._failures]
            mostly = [
                why for f, why in against if why.total() >= MOSTLY * sum(f.causes.values()) > 0
            ]
            if len(mostly) >= FAILURES:
                return _in_words(name, sum(mostly, Counter()), len(mostly))
        return None


def _against(hazard: str, causes: Causes) -> Counter[Cause]:
    return Counter({cause: count for cause, count in causes.items() if cause.hazard == hazard})


def _in_words(hazard: str, why: Counter[Cause], scenes: int) -> str:
    return (
        f"hazard {hazard!r} fits nowhere: never made in {why.total()} tries for {scenes} scenes "
        f"({causes_in_words(why, 4)}); {hint(most_frequent(why)[0][0])}"
    )


def hint(cause: Cause) -> str:
    """What to look at first."""
    if cause.other is not None:
        return f"what it puts there also is {cause.other}: make the predicates exclude each other"
    if cause.check == ALREADY_SET:
        return none_left(cause)
    return {
        "no_place": "look at the targets, rooms, zones and heights of its recipes",
        "not_proved": "its recipes make what its predicate does not accept",
        "unseen": "no camera sees enough of it: look at the size and the place",
    }.get(cause.check, "look at its recipes and models")


def none_left(cause: Cause) -> str:
    """What ``already_set`` means: ``no door there that is not OPEN already``."""
    return f"no {cause.category} there that is not {cause.state} already"
