"""A cursor over a parsed YAML mapping, for terms of predicates: asks for keys by type.

Values are checked by the validators of all records, and what is wrong is said in the words of
:mod:`sdgen.strict`: a term is written in another shape than its record has, so that keys are
asked for one by one, and that is all this adds. After a problem is noted a harmless value
comes back, so that one pass finds all of them; ``done()`` reports the keys nobody asked for.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from typing import Annotated, Any, Literal

from pydantic import BaseModel, TypeAdapter, ValidationError

from sdgen.catalog.words import State, between, names_of
from sdgen.strict import empty_key, explain, missing_key, no_mapping, unknown_key
from sdgen.yaml_source import Path_, Source

_REQUIRED: Any = object()


class Reader:
    """One mapping of a file, and which of its keys have been asked for."""

    def __init__(self, source: Source, path: Path_, value: Any) -> None:
        self.source = source
        self.path = path
        self.asked: list[str] = []
        self.ok = isinstance(value, dict)
        self.data: dict[str, Any] = value if self.ok else {}
        if not self.ok:
            source.problem(path, no_mapping(value))

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
                self.problem(unknown_key(key, known), key)

    def child(self, key: str) -> Reader:
        """A mapping below this one (an empty reader after noting that it is missing)."""
        value = self.data.get(key) if self.has(key) else {}
        below = Reader(self.source, (*self.path, key), value)
        if not self.has(key):
            below.ok = False
            self._missing(key, "a mapping (key: value)")
        return below

    def words(
        self,
        key: str,
        default: Any = _REQUIRED,
        *,
        choices: Iterable[str] | None = None,
        what: str = "name",
    ) -> tuple[str, ...]:
        """One word or a list of words, without repeats, each among ``choices`` when given."""
        known = None if choices is None else tuple(sorted(choices))
        kind = _words(what, known, 1 if default is _REQUIRED else 0)
        found: tuple[str, ...] = self._take(key, kind, f"a {what} or a list of them", default, ())
        return found

    def states(self, key: str) -> tuple[str, ...]:
        """One state or a list of states."""
        return self.words(key, what="state")

    def choice(self, key: str, choices: Sequence[str], default: Any = _REQUIRED) -> Any:
        """One of some words."""
        kind = _choice(tuple(choices))
        return self._take(key, kind, f"one of {', '.join(choices)}", default, choices[0])

    def state(self, key: str, default: Any = _REQUIRED) -> Any:
        """A state such as ``ON``; says how to write it when it is ``on`` or ``true``."""
        return self._take(key, _STATE, "a state such as ON or OPEN", default, "")

    def number(
        self, key: str, default: Any = _REQUIRED, *, low: float = -1e6, high: float = 1e6
    ) -> Any:
        """A number within limits (inclusive); after a problem, the default it would have had."""
        harmless = low if default is _REQUIRED else default
        return self._take(key, _number(low, high), "a number", default, harmless)

    def whole(self, key: str, default: Any = _REQUIRED, *, low: int, high: int) -> Any:
        """A whole number within limits (inclusive)."""
        harmless = low if default is _REQUIRED else default
        return self._take(key, _whole(low, high), "a whole number", default, harmless)

    def flag(self, key: str, default: bool) -> bool:
        """``true`` or ``false``."""
        found: bool = self._take(key, _FLAG, "true or false", default, default)
        return found

    def _take(
        self, key: str, kind: TypeAdapter[Any], want: str, default: Any, harmless: Any
    ) -> Any:
        if not self.has(key):
            if default is not _REQUIRED:
                return default
            self._missing(key, want)
            return harmless
        value = self.data[key]
        try:
            return kind.validate_python(value, strict=True)
        except ValidationError as error:
            for path, text in explain(error, BaseModel, value):
                self.problem(text, key, *path)
        return harmless

    def _missing(self, key: str, want: str) -> None:
        if key in self.data:
            self.problem(empty_key(want), key)
        elif self.ok:
            self.problem(missing_key(key, want))


_STATE: TypeAdapter[Any] = TypeAdapter(State)
_FLAG: TypeAdapter[Any] = TypeAdapter(bool)


@cache
def _number(low: float, high: float) -> TypeAdapter[Any]:
    return TypeAdapter(Annotated[float, between(low, high)])


@cache
def _whole(low: int, high: int) -> TypeAdapter[Any]:
    return TypeAdapter(Annotated[int, between(low, high)])


@cache
def _choice(choices: tuple[str, ...]) -> TypeAdapter[Any]:
    kind: Any = Literal[choices]
    return TypeAdapter(kind)


@cache
def _words(what: str, choices: tuple[str, ...] | None, least: int) -> TypeAdapter[Any]:
    return TypeAdapter(Annotated[tuple[str, ...], names_of(what, least, choices)])
