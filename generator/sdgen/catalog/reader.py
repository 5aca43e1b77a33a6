"""A cursor over a parsed YAML mapping: asks for keys by type, notes every problem, goes on.

Each getter returns a harmless value of its type after noting a problem, so that one pass over a
file finds all of them. ``done()`` reports the keys nobody asked for.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

from sdgen.errors import did_you_mean
from sdgen.yaml_source import Path_, Source

WORD = re.compile(r"[a-z][a-z0-9_]*")
STATE = re.compile(r"[A-Z][A-Z_]*")
_REQUIRED: Any = object()


def shown(value: Any) -> str:
    """What a YAML value is, for a message: ``a list``, ``text 'abc'``, ``the number 3``."""
    if isinstance(value, str):
        return f"text {value[:40]!r}"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int | float):
        return f"the number {value:g}"
    kinds = {dict: "a mapping", list: "a list", type(None): "nothing"}
    return kinds.get(type(value), type(value).__name__)


def state_problem(text: str) -> str:
    """Why a word is no state, and how to write it; empty when it is one."""
    if STATE.fullmatch(text):
        return ""
    better = re.sub(r"[^A-Z]+", "_", text.upper()).strip("_")
    hint = f": write {better}" if better else ""
    return f"{text!r} is not a state; states are UPPER CASE words{hint}"


class Reader:
    """One mapping of a file, and which of its keys have been asked for."""

    def __init__(self, source: Source, path: Path_, value: Any) -> None:
        self.source = source
        self.path = path
        self.asked: list[str] = []
        self.ok = isinstance(value, dict)
        self.data: dict[str, Any] = value if self.ok else {}
        if not self.ok:
            source.problem(path, f"expected a mapping (key: value), got {shown(value)}")

    def problem(self, message: str, *steps: str | int) -> None:
        """Note a problem at a path below this mapping."""
        self.source.problem((*self.path, *steps), message)

    def has(self, key: str) -> bool:
        """True when the key is there (and not empty); counts as asking for it."""
        self.asked.append(key)
        return self.data.get(key) is not None

    def done(self) -> None:
        """Report unknown keys."""
        known = list(dict.fromkeys(self.asked))
        for key in self.data:
            if key not in known:
                near = did_you_mean(key, known) or f" (known keys: {', '.join(known)})"
                self.problem(f"unknown key{near}", key)

    def _get(self, key: str, default: Any, want: str, types: tuple[type, ...]) -> Any:
        self.asked.append(key)
        value = self.data.get(key)
        if value is None:
            if default is _REQUIRED:
                if self.ok:
                    word = "is empty" if key in self.data else f"missing key {key!r}"
                    self.problem(f"{word}: expected {want}", *([key] if key in self.data else []))
                return None
            return default
        if not isinstance(value, types) or (isinstance(value, bool) and bool not in types):
            self.problem(f"expected {want}, got {shown(value)}", key)
            return None if default is _REQUIRED else default
        return value

    def text(self, key: str, default: Any = _REQUIRED) -> str:
        """Free text, one line or many; white space is folded."""
        value = self._get(key, default, "text", (str,))
        return " ".join(value.split()) if isinstance(value, str) else ""

    def choice(self, key: str, choices: Sequence[str], default: Any = _REQUIRED) -> Any:
        """One of some words."""
        value = self._get(key, default, f"one of {', '.join(choices)}", (str,))
        if isinstance(value, str) and value not in choices:
            near = did_you_mean(value, choices)
            self.problem(f"{value!r} is not one of {', '.join(choices)}{near}", key)
            return choices[0]
        return value if value is not None or default is not _REQUIRED else choices[0]

    def word(self, key: str, default: Any = _REQUIRED) -> str:
        """A lower case name such as ``milk_carton``."""
        value = self._get(key, default, "a lower case name", (str,))
        if isinstance(value, str) and not WORD.fullmatch(value):
            self.problem(f"{value!r} is not a name (lower case letters, digits, _)", key)
        return value if isinstance(value, str) else ""

    def state(self, key: str, default: Any = _REQUIRED) -> Any:
        """A state such as ``ON``; says how to write it when it is ``on`` or ``true``."""
        value = self._get(key, default, "a state such as ON or OPEN", (str,))
        if isinstance(value, str) and (why := state_problem(value)):
            self.problem(why, key)
        return value

    def words(
        self,
        key: str,
        default: Any = _REQUIRED,
        *,
        choices: Iterable[str] | None = None,
        what: str = "name",
    ) -> tuple[str, ...]:
        """One word or a list of words, without repeats, each among ``choices`` when given."""
        value = self._get(key, default, f"a {what} or a list of them", (str, list))
        listed = [value] if isinstance(value, str) else list(value or ())
        if isinstance(value, list) and not value and default is _REQUIRED:
            self.problem(f"expected at least one {what}", key)
        known = None if choices is None else sorted(choices)
        out: list[str] = []
        for index, item in enumerate(listed):
            steps = (key,) if isinstance(value, str) else (key, index)
            if not isinstance(item, str):
                self.problem(f"expected a {what}, got {shown(item)}", *steps)
            elif known is not None and item not in known:
                self.problem(f"unknown {what} {item!r}{did_you_mean(item, known)}", *steps)
            elif item in out:
                self.problem(f"{item!r} is listed twice", *steps)
            else:
                out.append(item)
        return tuple(out)

    def listed(self, key: str, what: str) -> list[str]:
        """A list of words in which one may come twice (a row of units, two bedrooms)."""
        value = self._get(key, _REQUIRED, f"a list of {what}", (list,))
        if value == []:
            self.problem(f"expected a list of {what}", key)
        out = []
        for index, item in enumerate(value or ()):
            if isinstance(item, str):
                out.append(item)
            else:
                self.problem(f"expected a word, got {shown(item)}", key, index)
        return out

    def states(self, key: str) -> tuple[str, ...]:
        """One state or a list of states."""
        out = self.words(key, what="state")
        single = isinstance(self.data.get(key), str)
        for index, item in enumerate(out):
            if why := state_problem(item):
                self.problem(why, *((key,) if single else (key, index)))
        return out

    def number(
        self, key: str, default: Any = _REQUIRED, *, low: float = -1e6, high: float = 1e6
    ) -> Any:
        """A number within limits (inclusive)."""
        value = self._get(key, default, "a number", (int, float))
        if value is None:
            return 0.0 if default is _REQUIRED else None
        if not low <= value <= high:
            self.problem(f"{value} is not between {low:g} and {high:g}", key)
            return low
        return float(value)

    def integer(self, key: str, default: Any = _REQUIRED, *, low: int = 0, high: int = 999) -> Any:
        """A whole number within limits (inclusive)."""
        value = self._get(key, default, "a whole number", (int,))
        if value is None:
            return low if default is _REQUIRED else None
        if not low <= value <= high:
            self.problem(f"{value} is not between {low} and {high}", key)
            return low
        return int(value)

    def flag(self, key: str, default: bool = False) -> bool:
        """``true`` or ``false``."""
        value = self._get(key, default, "true or false", (bool,))
        return bool(value)

    def numbers(
        self, key: str, count: int, *, low: float = -1e4, high: float = 1e4
    ) -> tuple[float, ...]:
        """A list of exactly ``count`` numbers."""
        value = self._get(key, _REQUIRED, f"a list of {count} numbers", (list,))
        return self.vector(value, count, (key,), low, high)

    def vector(
        self, value: Any, count: int, steps: tuple[str | int, ...], low: float, high: float
    ) -> tuple[float, ...]:
        """Check that a value found below this mapping is ``count`` numbers within limits."""
        zeros = (max(0.0, low),) * count
        if value is None:
            return zeros
        if not isinstance(value, list) or len(value) != count:
            got = f"{len(value)} items" if isinstance(value, list) else shown(value)
            self.problem(f"expected a list of {count} numbers, got {got}", *steps)
            return zeros
        for index, item in enumerate(value):
            if isinstance(item, bool) or not isinstance(item, int | float):
                got = f"{shown(item)}"
                self.problem(f"expected a number, got {got}", *steps, index)
                return zeros
            if not low <= item <= high:
                self.problem(f"{item} is not between {low:g} and {high:g}", *steps, index)
                return zeros
        return tuple(float(item) for item in value)

    def span(self, key: str, *, low: float = 0.0, high: float = 1e4) -> tuple[float, float]:
        """``[least, most]``."""
        least, most = self.numbers(key, 2, low=low, high=high)
        if least > most:
            self.problem(f"the first number ({least:g}) is above the second ({most:g})", key)
            return (most, least)
        return (least, most)

    def rows(self, key: str, default: Any = _REQUIRED) -> list[Reader]:
        """A list of mappings."""
        value = self._get(key, default, "a list", (list,))
        if value == [] and default is _REQUIRED:
            self.problem("expected at least one item", key)
        return [
            Reader(self.source, (*self.path, key, index), item)
            for index, item in enumerate(value or ())
        ]

    def child(self, key: str) -> Reader:
        """A mapping below this one (an empty reader after noting that it is missing)."""
        value = self._get(key, _REQUIRED, "a mapping (key: value)", (dict,))
        below = Reader(self.source, (*self.path, key), {} if value is None else value)
        below.ok = value is not None
        return below

    def named(self, key: str | None = None) -> list[tuple[str, Reader]]:
        """A mapping of names to mappings: ``key`` below this one, or this one itself."""
        here = self if key is None else self.child(key)
        out: list[tuple[str, Reader]] = []
        for name, value in here.data.items():
            if not WORD.fullmatch(name):
                here.problem(f"{name!r} is not a name (lower case letters, digits, _)", name)
            out.append((name, Reader(self.source, (*here.path, name), value)))
        return out
