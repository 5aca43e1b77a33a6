"""What a model's free text says of pictures: boxes and node numbers with a class each."""

from __future__ import annotations

import re
from dataclasses import dataclass

from sdgen.catalog.records import Label
from sdgen.detectors.answer_lines import lines_of_answer
from sdgen.detectors.parsing import notify_in, says_nothing, verdict_in
from sdgen.scene import Notify

_NUMBER = r"\s*(-?\d{1,7}(?:\.\d{1,9})?)\s*"
_BOX = re.compile(rf"[\[(]{_NUMBER},{_NUMBER},{_NUMBER},{_NUMBER}[\])]")
_PICTURE = re.compile(
    r"\b(?:picture|image|view|photo)\s*(?:no\.?|number)?\s*#?\s*(\d{1,3})\b", re.I
)
_NODE = re.compile(r"\[\s*#?(\d{1,5})\s*\]|\b(?:id|node|number)\s*[:#]?\s*(\d{1,5})\b", re.I)


@dataclass(frozen=True)
class Pointing:
    """A line of an answer: ``picture`` from 1, its ``box`` as it was drawn, or a ``node`` by its
    number; its class, None where it has none of ours."""

    label: Label | None
    picture: int | None = None
    box: tuple[float, float, float, float] | None = None
    node: int | None = None
    notify: Notify | None = None


@dataclass(frozen=True)
class Pointings:
    """An answer, read; ``nothing``: it says that there is nothing."""

    found: tuple[Pointing, ...]
    nothing: bool = False

    @property
    def readable(self) -> bool:
        """False for an answer that answers nothing."""
        return bool(self.found) or self.nothing


def read_pointings(text: str, nodes: bool) -> Pointings:
    """The boxes of an answer and, where ``nodes`` may be named, their numbers. What is called
    normal is left out. A heading names the picture of the lines below it."""
    found: list[Pointing] = []
    nothing = False
    below: int | None = None
    for line in lines_of_answer(text):
        box = _BOX.search(line)
        rest = line[: box.start()] + line[box.end() :] if box else line
        picture = _PICTURE.search(rest)
        node = _NODE.search(line) if nodes and box is None else None
        if box is None and node is None:
            below = int(picture[1]) if picture else below
            nothing |= says_nothing(_PICTURE.sub("", line))
            continue
        verdict = verdict_in(rest)
        if verdict == "normal":
            nothing = True
            continue
        x, y, w, h = (float(v) for v in box.groups()) if box else (0.0, 0.0, 0.0, 0.0)
        number = next(filter(None, node.groups()), None) if node else None
        found.append(
            Pointing(
                label=verdict,
                picture=int(picture[1]) if picture else below,
                box=(x, y, w, h) if box else None,
                node=int(number) if number else None,
                notify=notify_in(rest),
            )
        )
    return Pointings(tuple(found), nothing)
