"""An answer as lines: what a model thinks aloud is left out, JSON becomes a line an entry."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

#: So much of an answer is read; no model says more of a question of ours.
LONGEST = 200_000
_DEEPEST = 8
#: A number beyond it is no pixel of a picture.
_FAR = 1e6

#: What ends the part of an answer that a model thinks aloud.
_THOUGHT = ("</think>", "</thinking>")
_FENCE = re.compile(r"```[a-zA-Z]*\n(.*?)```", re.S)
#: Keys of an object of JSON that answers for one thing.
_LABEL_KEYS = frozenset({"label", "class", "classification", "category", "verdict", "type"})
_BOX_KEYS = frozenset({"box", "bbox", "bounding_box", "box_2d"})
#: Keys of what must not stand before the label: reasons name labels, too.
_REASONS = frozenset({"reason", "explanation", "reasoning", "why", "description", "comment"})


def lines_of_answer(text: str) -> tuple[str, ...]:
    """The lines of an answer that hold anything, without fences. JSON that holds nothing is the
    line ``none``."""
    text = text[:LONGEST]
    for end in _THOUGHT:
        text = text.rpartition(end)[2]
    for block in (*_FENCE.findall(text), text):
        stripped = block.strip()
        if stripped[:1] in ("[", "{"):
            try:
                found = json.loads(stripped)
            except (ValueError, RecursionError):
                continue
            return tuple(filter(None, _entries(found, "", 0))) or ("none",)
    return tuple(line for line in text.splitlines() if line.strip() and not line.startswith("```"))


def _entries(value: Any, key: str, depth: int) -> Iterator[str]:
    """JSON as lines; ``key`` is what it stands under: a string that was asked, or a label."""
    if depth > _DEEPEST:
        return
    if isinstance(value, Mapping):
        names = {name.lower() for name in value}
        if names & (_LABEL_KEYS | _BOX_KEYS):
            yield _joined(
                _said("", key), *(_said(*pair) for pair in sorted(value.items(), key=_at))
            )
            return
        for name, item in value.items():
            yield from _entries(item, name, depth + 1)
    elif isinstance(value, list) and not _is_box(value):
        for item in value:
            yield from _entries(item, key, depth + 1)
    else:
        yield _joined(_said("", key), _said("", value))


def _at(pair: tuple[str, Any]) -> int:
    """Where in a line a key stands: what it is about, its label, reasons."""
    name = pair[0].lower()
    return 1 if name in _LABEL_KEYS else 2 if name in _REASONS else 0


def _joined(*parts: str) -> str:
    return ": ".join(filter(None, parts))


def _said(key: str, value: Any) -> str:
    """``'kitchen'``, ``picture 2``, ``[1.0, 2.0, 3.0, 4.0]``; nothing for what is none of these."""
    if isinstance(value, str):
        words = " ".join(value.split())
        return f"'{words}'" if words else ""
    if _is_box(value):
        return str([float(item) for item in value])
    return f"{key} {value}".strip() if _is_number(value) else ""


def _is_number(value: Any) -> bool:
    # Whole numbers of thousands of digits cannot be made floats; none of them is meant.
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= _FAR


def _is_box(value: Any) -> bool:
    return isinstance(value, list) and len(value) == 4 and all(map(_is_number, value))
