"""YAML from strangers, read strictly: plain values, and the line each of them stands on.

Only mappings with text keys, lists, text, numbers, ``true``/``false`` and ``null`` exist. ``on``,
``off``, ``yes`` and ``no`` stay text (YAML 1.1 reads them as booleans: ``state: on`` would become
``True``), dates and ``0o17`` too. Duplicate keys, tags, merge keys, several documents, files
that are too large, too deep or expand too far through aliases are problems, never tracebacks.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from sdgen.errors import SHOWN
from sdgen.files import read_plain

Path_ = tuple[str | int, ...]

#: Against files that are not meant to be read: the largest one shipped has 14 kB, 1,700
#: values and three anchors, and is nested six deep.
MAX_BYTES = 1_000_000
MAX_DEPTH = 32
MAX_VALUES = 100_000
MAX_ANCHORS = 100
#: Characters shown of a key: by eye, any file's name of ours fits; a stranger's key may be a book.
_LONGEST_KEY = 80

_INT = re.compile(r"[-+]?[0-9]{1,15}")
_FLOAT = re.compile(r"[-+]?([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+(?=[eE]))([eE][-+]?[0-9]{1,4})?")
_NULL = ("", "~", "null", "Null", "NULL")
_BOOL = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}

# libyaml's event parser does not recurse and is ten times faster; both give the same events.
_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def show_path(path: Path_) -> str:
    """``anomalies[0].target`` for ``("anomalies", 0, "target")``; of a long key its beginning."""
    out = ""
    for step in path:
        if isinstance(step, str) and len(step) > _LONGEST_KEY:
            step = f"{step[:_LONGEST_KEY]}..."
        out += f"[{step}]" if isinstance(step, int) else f".{step}" if out else step
    return out


@dataclass
class Source:
    """One parsed file: its ``value`` (dict, list, str, int, float, bool or None).

    ``lines`` gives the 1-based line of every key path, ``noted`` the problems so far with theirs.
    """

    file: str
    value: Any = None
    lines: dict[Path_, int] = field(default_factory=dict)
    noted: list[tuple[int, str]] = field(default_factory=list)
    more: int = 0
    #: Entries that people know by a name rather than by their place in a list.
    named: dict[Path_, str] = field(default_factory=dict)

    @property
    def problems(self) -> list[str]:
        """What is wrong, by line, each ``file:line: key path: problem``; at most ``SHOWN``."""
        ordered = sorted(self.noted, key=lambda item: item[0])
        lines = [
            f"{self.file}:{line}: {text}" if line else f"{self.file}: {text}"
            for line, text in ordered
        ]
        return [*lines, f"{self.file}: and {self.more} more problems"] if self.more else lines

    def line(self, path: Path_) -> int:
        """Line of the path, or of the nearest thing above it that has one."""
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 1)

    def problem(self, path: Path_, message: str, line: int | None = None) -> None:
        """Note a problem at a key path (on its line, unless another is given)."""
        if len(self.noted) >= SHOWN:
            self.more += 1
            return
        lead = next((path[:k] for k in range(len(path) + 1) if path[:k] in self.named), ())
        where = [self.named.get(lead, ""), show_path(path[len(lead) :]), message]
        text = ": ".join(part for part in where if part)
        self.noted.append((self.line(path) if line is None else line, text))


class _Stop(Exception):
    """Reading this file any further makes no sense."""

    def __init__(self, line: int, message: str) -> None:
        self.line = line
        super().__init__(message)


def read_yaml(
    path: Path,
    name: str | None = None,
    max_bytes: int = MAX_BYTES,
    max_values: int = MAX_VALUES,
) -> Source:
    """Read a file; ``name`` is what problems call it (default: the path as given).

    Raises InputError when there is no such file, it is none or too large; what is wrong in it
    ends up in the ``problems`` of the source.
    """
    shown = name or str(path)
    return parse_yaml(read_plain(path, shown, max_bytes), shown, max_bytes, max_values)


def parse_yaml(
    raw: bytes,
    name: str,
    max_bytes: int = MAX_BYTES,
    max_values: int = MAX_VALUES,
    max_anchors: int = MAX_ANCHORS,
) -> Source:
    """Parse bytes. Syntax problems end up in ``problems`` with ``value`` None; never raises."""
    source = Source(name)
    if len(raw) > max_bytes:
        source.problem((), f"is larger than {max_bytes // 1000} kB", line=0)
        return source
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        source.problem((), "is not UTF-8 text", line)
        return source
    try:
        source.value = _Builder(source, text, max_values, max_anchors).document()
    except _Stop as stop:
        source.problem((), str(stop), stop.line)
    except yaml.YAMLError as error:
        source.problem((), _error_text(error), _error_line(error))
    except (RecursionError, ValueError) as error:  # belt and braces: never a traceback
        source.problem((), f"cannot be parsed ({type(error).__name__})", line=0)
    return source


def _line(event: Any) -> int:
    return int(event.start_mark.line) + 1


def _error_line(error: yaml.YAMLError) -> int:
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    return mark.line + 1 if mark is not None else 1


def _error_text(error: yaml.YAMLError) -> str:
    reason = getattr(error, "problem", None) or getattr(error, "reason", None) or "bad syntax"
    context = getattr(error, "context", None)
    return f"not valid YAML: {reason}{f' ({context})' if context else ''}"


class _Builder:
    """Turns the event stream into values, noting lines on the way."""

    def __init__(self, source: Source, text: str, max_values: int, max_anchors: int) -> None:
        self.source = source
        self.max_values = max_values
        self.max_anchors = max_anchors
        self.events: Iterator[Any] = iter(yaml.parse(text, Loader=_LOADER))
        # What an anchor stands for: the value and its lines relative to the anchor.
        self.anchors: dict[str, tuple[Any, dict[Path_, int]]] = {}
        self.count = 0

    def document(self) -> Any:
        next(self.events)  # stream start
        first = next(self.events)
        if isinstance(first, yaml.StreamEndEvent):
            raise _Stop(1, "is empty")
        value = self.value(next(self.events), (), 0)
        next(self.events)  # document end
        more = next(self.events)
        if isinstance(more, yaml.DocumentStartEvent):
            raise _Stop(_line(more), "holds more than one document (remove '---')")
        return value

    def value(self, event: Any, path: Path_, depth: int) -> Any:
        line = _line(event)
        self.source.lines[path] = line
        self.count += 1
        if self.count > self.max_values:
            raise _Stop(line, f"holds more than {self.max_values} values")
        if depth > MAX_DEPTH:
            raise _Stop(line, f"is nested more than {MAX_DEPTH} deep")
        if isinstance(event, yaml.AliasEvent):
            return self.alias(str(event.anchor), path, line)
        if event.tag not in (None, "!"):
            self.source.problem(path, f"tags are not allowed ({event.tag}): write plain YAML")
        if isinstance(event, yaml.MappingStartEvent):
            out: Any = self.mapping(path, depth)
        elif isinstance(event, yaml.SequenceStartEvent):
            out = self.sequence(path, depth)
        else:
            out = self.scalar(event, path)
        if event.anchor:
            if len(self.anchors) >= self.max_anchors:
                most = f"has more than {self.max_anchors} anchors"
                raise _Stop(line, most if self.max_anchors else "anchors are not allowed here")
            size = len(path)
            lines = {k[size:]: v for k, v in self.source.lines.items() if k[:size] == path}
            self.anchors[event.anchor] = (out, lines)
        return out

    def alias(self, anchor: str, path: Path_, line: int) -> Any:
        if anchor not in self.anchors:
            raise _Stop(line, f"*{anchor} is used before (or inside) its anchor &{anchor}")
        value, lines = self.anchors[anchor]
        self.count += len(lines)
        if self.count > self.max_values:
            raise _Stop(line, f"expands to more than {self.max_values} values through aliases")
        if any(len(path) + len(below) > MAX_DEPTH for below in lines):
            raise _Stop(line, f"is nested more than {MAX_DEPTH} deep")
        self.source.lines.update({path + below: at for below, at in lines.items()})
        return value

    def sequence(self, path: Path_, depth: int) -> list[Any]:
        out: list[Any] = []
        while not isinstance(event := next(self.events), yaml.SequenceEndEvent):
            out.append(self.value(event, (*path, len(out)), depth + 1))
        return out

    def mapping(self, path: Path_, depth: int) -> dict[str, Any]:
        out: dict[str, Any] = {}
        spare = 0
        while not isinstance(event := next(self.events), yaml.MappingEndEvent):
            line = _line(event)
            if not isinstance(event, yaml.ScalarEvent):
                raise _Stop(line, f"{show_path(path) or 'top level'}: a key must be a word")
            key = event.value
            place: Path_ = (*path, key)
            if key in out:
                spare += 1
                place = (*path, f"{key}#{spare}")
                first = self.source.line((*path, key))
                self.source.lines[place] = line
                self.value(next(self.events), place, depth + 1)
                message = f"duplicate key {key!r} (first on line {first})"
                self.source.problem((*path, key), message, line)
                continue
            if key == "<<" and not event.style:
                self.source.lines[place] = line
                self.source.problem(place, "merge keys are not supported")
            out[key] = self.value(next(self.events), place, depth + 1)
            self.source.lines[place] = line
        return out

    def scalar(self, event: Any, path: Path_) -> Any:
        text: str = event.value
        if event.style or event.tag == "!":  # quoted, block or forced to be text
            return text
        if text in _NULL:
            return None
        if text in _BOOL:
            return _BOOL[text]
        if _INT.fullmatch(text):
            return int(text)
        if _FLOAT.fullmatch(text):
            number = float(text)
            if not math.isfinite(number):
                self.source.problem(path, f"{text} is too large a number")
                return 0.0
            return number
        return text
