"""Moves as lines of text: what ``sdgen explore`` reads from a file or the command line."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sdgen.agent.episode import Episode, Result
from sdgen.agent.moves import AIMED, LABELS, MOVES, NOTIFY, Move
from sdgen.errors import InputError, UsageError, did_you_mean
from sdgen.scene import LARGEST_ID, Notify

#: A move may be repeated so often in one line.
_MOST_TIMES = 10_000


@dataclass(frozen=True)
class Line:
    """A move, how often, and what it is about."""

    move: Move
    times: int = 1
    target: int | str = 0
    label: str = ""
    notify: Notify = "now"

    def do(self, episode: Episode) -> Iterator[Result]:
        """Do it, until the episode is over."""
        for _ in range(self.times):
            if episode.over:
                return
            target = meant(episode, self.target) if self.move in AIMED else 0
            yield episode.do(self.move, target, self.label, self.notify)


def meant(episode: Episode, target: int | str) -> int:
    """The id of what is called by an id, by the type of a room, or by the category of an object
    (the nearest one). UsageError for what is not there."""
    if isinstance(target, int):
        return target
    rooms = [room.id for room in episode.stage.scene.home.rooms if room.type == target]
    if rooms:
        return rooms[0]
    here = episode.gaze.point
    things = {key: body.item.category for key, body in episode.house.bodies.items()}
    near = [
        (episode.house.away_m(here, key), key) for key, name in things.items() if name == target
    ]
    if not near:
        known = sorted({*things.values(), *(r.type for r in episode.stage.scene.home.rooms)})
        raise UsageError(f"no room or object called {target!r}{did_you_mean(target, known)}")
    return min(near)[1]


def read_script(text: str, where: str) -> tuple[Line, ...]:
    """Lines of a script: a move a line (or between commas), empty lines and what follows a ``#``
    left out.

    ``forward 4``, ``turn_left 3``, ``look_down``, ``scan``, ``go_to kitchen``, ``open 17``,
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
        raise ValueError(f"{move} takes a room or an object: its id, its type or category")
    named = re.fullmatch("[a-z][a-z0-9_]*", rest[0], re.ASCII) is not None
    target = rest[0] if named else _number(move, rest[0], LARGEST_ID)
    if move != "report":
        if len(rest) > 1:
            raise ValueError(f"{move} takes one of them, and no more")
        return Line(move, target=target)
    said = rest[1:]
    notify: Notify = "now"
    if said and said[-1] in NOTIFY:
        notify = next(word for word in NOTIFY if word == said[-1])
        said = said[:-1]
    label = " ".join(said)
    if label not in LABELS:
        known, ways = ", ".join(LABELS), ", ".join(NOTIFY)
        raise ValueError(f"report takes an object, a label ({known}) and {ways}: not {label!r}")
    return Line(move, target=target, label=label, notify=notify)


def _number(move: str, text: str, most: int) -> int:
    if not re.fullmatch("[0-9]{1,6}", text, re.ASCII) or not 1 <= int(text) <= most:
        raise ValueError(f"{move}: {text!r} is no number from 1 to {most}")
    return int(text)
