"""Moves as lines of text: what ``sdgen explore`` reads from a file or the command line."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sdgen.agent.episode import Episode, Result
from sdgen.agent.moves import AIMED, LABELS, MOVES, NOTIFY, Move
from sdgen.errors import InputError, did_you_mean
from sdgen.scene import LARGEST_ID, Notify

#: A move may be repeated so often in one line.
_MOST_TIMES = 10_000


@dataclass(frozen=True)
class Line:
    """A move, how often, and what it is about."""

    move: Move
    times: int = 1
    target: int = 0
    label: str = ""
    notify: Notify = "now"

    def do(self, episode: Episode) -> Iterator[Result]:
        """Do it, until the episode is over."""
        for _ in range(self.times):
            if episode.over:
                return
            yield episode.do(self.move, self.target, self.label, self.notify)


def read_script(text: str, where: str) -> tuple[Line, ...]:
    """Lines of a script: a move a line (or between commas), empty lines and what follows a ``#``
    left out.

    ``forward 4``, ``turn_left 3``, ``look_down``, ``scan``, ``go_to 17``, ``open 17``,
    ``report 17 unsafe for children now``, ``stop``. Raises InputError with all that is wrong.
    """
    problems: list[str] = []
    lines = []
    for number, row in enumerate(text.splitlines(), start=1):
        for piece in row.partition("#")[0].split(","):
            words = piece.split()
            if words:
                try:
                    lines.append(_line(words))
                except ValueError as error:
                    problems.append(f"{where}:{number}: {error}")
    if problems:
        raise InputError(problems)
    return tuple(lines)


def _line(words: Sequence[str]) -> Line:
    """One move. ValueError says what is wrong with it."""
    name, *rest = words
    if name not in MOVES:
        raise ValueError(f"no move {name!r}{did_you_mean(name, MOVES)}")
    move: Move = name
    if move not in AIMED:
        if len(rest) > 1:
            raise ValueError(f"{move} takes how often, and no more")
        times = _number(move, rest[0], _MOST_TIMES) if rest else 1
        return Line(move, times)
    if not rest:
        raise ValueError(f"{move} takes the id of a room or an object")
    target = _number(move, rest[0], LARGEST_ID)
    if move != "report":
        if len(rest) > 1:
            raise ValueError(f"{move} takes one id, and no more")
        return Line(move, target=target)
    said = rest[1:]
    notify: Notify = "now"
    if said and said[-1] in NOTIFY:
        notify = next(word for word in NOTIFY if word == said[-1])
        said = said[:-1]
    label = " ".join(said)
    if label not in LABELS:
        known = ", ".join(LABELS)
        raise ValueError(f"report takes an id and a label ({known}): not {label!r}")
    return Line(move, target=target, label=label, notify=notify)


def _number(move: str, text: str, most: int) -> int:
    if not re.fullmatch("[0-9]{1,6}", text, re.ASCII) or not 1 <= int(text) <= most:
        raise ValueError(f"{move}: {text!r} is no number from 1 to {most}")
    return int(text)
