"""What a check found, and how two records differ."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

from sdgen.dataset.text import compact, plain

Check = Literal["file", "hash", "count", "scene", "graph", "label", "view", "physics", "rebuild"]

#: Differences shown of one file; more only repeat what is wrong.
SHOWN = 5


@dataclass(frozen=True)
class Problem:
    """Something a data set promises and does not keep. ``text`` is ``file: key path: problem``."""

    check: Check
    text: str

    def __str__(self) -> str:
        return self.text


def differences(stored: Any, derived: Any, path: str = "") -> Iterator[str]:
    """Where two values differ, as ``key path: stored …, derived …``; lazily, depth first."""
    yield from _differences(plain(stored), plain(derived), path)


def _differences(stored: Any, derived: Any, path: str) -> Iterator[str]:
    if isinstance(stored, dict) and isinstance(derived, dict):
        for key in [*stored, *(k for k in derived if k not in stored)]:
            inner = f"{path}.{key}" if path else str(key)
            if key not in derived:
                yield f"{inner}: {_short(stored[key])} stored, nothing derived"
            elif key not in stored:
                yield f"{inner}: nothing stored, {_short(derived[key])} derived"
            else:
                yield from _differences(stored[key], derived[key], inner)
    elif isinstance(stored, list) and isinstance(derived, list) and len(stored) == len(derived):
        for k, (one, other) in enumerate(zip(stored, derived, strict=True)):
            yield from _differences(one, other, f"{path}[{k}]")
    elif stored != derived or type(stored) is not type(derived):
        if isinstance(stored, int | float) and stored == derived:
            return
        yield f"{path}: {_short(stored)} stored, {_short(derived)} derived"


def _short(value: Any) -> str:
    text = compact(value)
    return text if len(text) <= 60 else text[:57] + "..."
