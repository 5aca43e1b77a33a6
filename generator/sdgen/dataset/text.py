"""Records to text and back: one deterministic layout, whatever the locale or platform.

A value that fits on a line stays on it, others get one line an item, so that files are compact,
readable and good to compare. Keys of records keep their order, keys of mappings are sorted,
floats are written by ``repr``; UTF-8, LF, one newline at the end.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from sdgen.errors import SHOWN, InputError
from sdgen.files import lines_of, read_plain
from sdgen.strict import explain
from sdgen.yaml_source import show_path

T = TypeVar("T", bound=BaseModel)

#: Characters, by eye: a pose or an edge of the graph stays on one line.
LINE = 110


#: Types of most values, known without asking for abstract classes.
_SCALARS = frozenset({str, int, float, bool, type(None)})

#: Writes floats by ``repr`` and refuses NaN and infinities.
_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False)


def plain(value: Any) -> Any:
    """A record as dicts and lists: record keys in their order, mapping keys sorted."""
    if type(value) in _SCALARS:
        return value
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, BaseModel):
        return {name: plain(getattr(value, name)) for name in _fields(type(value))}
    if isinstance(value, Mapping):
        return {str(key): plain(value[key]) for key in sorted(value)}
    return value


def compact(value: Any) -> str:
    """``value`` (dicts, lists, scalars) on one line. ValueError for NaN and infinities."""
    return _ENCODER.encode(value)


def pretty(value: Any) -> str:
    """A record, or dicts, lists and scalars, with whatever fits a line of ``LINE`` characters kept
    on one."""
    return _laid_out(value, 0)[0]


def _laid_out(value: Any, indent: int) -> tuple[str, bool]:
    """The text of ``value`` behind ``indent`` characters, and whether it is one line."""
    kind = type(value)
    # Numbers and short names are most of a scene: what the encoder makes of them, without it.
    if kind is float and math.isfinite(value):
        return float.__repr__(value), True
    if kind is int:
        return int.__repr__(value), True
    deeper = indent + 1
    one_line = True
    items = []
    if isinstance(value, list | tuple):
        ends = "[]"
        for item in value:
            text, short = _laid_out(item, deeper)
            items.append(text)
            one_line &= short
    elif isinstance(value, BaseModel):
        ends = "{}"
        for name in _fields(type(value)):
            text, short = _laid_out(getattr(value, name), deeper)
            items.append(f'"{name}": {text}')
            one_line &= short
    elif isinstance(value, Mapping):
        ends = "{}"
        for key in sorted(value):
            text, short = _laid_out(value[key], deeper)
            items.append(f"{compact(str(key))}: {text}")
            one_line &= short
    else:
        return compact(value), True
    if one_line:
        line = f"{ends[0]}{', '.join(items)}{ends[1]}"
        if not items or indent + len(line) <= LINE:
            return line, True
    inner = " " * deeper
    lines = f",\n{inner}".join(items)
    return f"{ends[0]}\n{inner}{lines}\n{' ' * indent}{ends[1]}", False


@cache
def _fields(model: type[BaseModel]) -> tuple[str, ...]:
    return tuple(model.model_fields)


def record_bytes(record: BaseModel) -> bytes:
    """A record as the bytes of its file."""
    return (pretty(record) + "\n").encode("utf-8")


def line_bytes(record: BaseModel) -> bytes:
    """A record as one line of a ``.jsonl`` file."""
    return (compact(plain(record)) + "\n").encode("utf-8")


# --- reading, strictly ---------------------------------------------------------------------------

#: Python itself reads whole numbers of up to 4,300 digits; no number of ours has more than 20.
_DIGITS = 40
_SHOWN_DIGITS = 20

#: Of one file, or one line where it has many: three times the ``dataset.json`` of a million
#: homes, and of a picture of the largest size twice what it takes when nothing can be packed.
MAX_BYTES = 200_000_000


def _refuse_duplicates(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    out: dict[str, Any] = {}
    for key, value in pairs:
        if key in out:
            raise ValueError(f"key {key!r} appears twice")
        out[key] = value
    return out


class _BadNumberError(ValueError):
    """A number that is none of ours; ``text`` is how it is written."""

    def __init__(self, text: str, what: str) -> None:
        shown = text if len(text) <= _SHOWN_DIGITS else f"{text[:_SHOWN_DIGITS]}..."
        super().__init__(f"{shown} is {what}")
        self.text = text


def _refuse_constant(name: str) -> Any:
    raise _BadNumberError(name, "not a number of JSON")


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise _BadNumberError(text, "too large a number")
    return value


def _whole(text: str) -> int:
    if len(text) > _DIGITS:
        raise _BadNumberError(text, f"too large a number ({len(text)} digits)")
    return int(text)


def parse(data: bytes, where: str, any_number: bool = False) -> Any:
    """JSON from bytes; with ``any_number`` those that are none (``NaN``) are text.

    Raises InputError ``where: line: problem``."""
    try:
        text = data.decode("utf-8")
        return json.loads(
            text,
            object_pairs_hook=_refuse_duplicates,
            parse_constant=str if any_number else _refuse_constant,
            parse_float=float if any_number else _finite,
            parse_int=_whole,
        )
    except UnicodeDecodeError as error:
        raise InputError([f"{where}: not UTF-8 text (byte {error.start})"]) from None
    except json.JSONDecodeError as error:
        line = f":{error.lineno}" if b"\n" in data.strip() else ""
        raise InputError([f"{where}{line}: not JSON: {error.msg}"]) from None
    except _BadNumberError as error:
        number = text.count("\n", 0, text.find(error.text)) + 1
        line = f":{number}" if b"\n" in data.strip() else ""
        raise InputError([f"{where}{line}: {error}"]) from None
    except RecursionError:
        raise InputError([f"{where}: nested too deeply"]) from None
    except ValueError as error:
        raise InputError([f"{where}: {error}"]) from None


def read_bytes(path: Path, where: str) -> bytes:
    """Bytes of a file. Raises InputError when it is missing, too large, a link or no file."""
    return read_plain(path, where, MAX_BYTES, links=False)


def numbered_lines(path: Path, where: str) -> Iterator[tuple[int, bytes]]:
    """Lines of a file that are not empty, with their numbers. InputError as ``read_bytes``, which
    looks at one line at a time: a manifest may be larger than any other file."""
    return ((k, line) for k, line in lines_of(path, where, MAX_BYTES) if line.strip())


def to_record(
    model: type[T], data: bytes, where: str, as_now: Callable[[Any], Any] | None = None
) -> T:
    """JSON bytes as a record. Raises InputError with all problems, ``where: key path: problem``."""
    value = parse(data, where)  # what pydantic's parser lets pass: duplicate keys, NaN, 1e999
    if as_now is not None and (now := as_now(value)) is not value:
        value, data = now, compact(now).encode()
    try:
        # Strict, in JSON mode: a list may become a tuple, but "1" stays no number.
        return model.model_validate_json(data, strict=True)
    except ValidationError as error:
        problems = explain(error, model, value)
        lines = [
            f"{where}: {show_path(path)}: {text}" if path else f"{where}: {text}"
            for path, text in problems
        ]
        raise InputError(lines) from None


def read_record(
    model: type[T], path: Path, where: str, as_now: Callable[[Any], Any] | None = None
) -> T:
    """A record from its file; ``as_now`` says one of an older version our way. Raises InputError,
    located."""
    return to_record(model, read_bytes(path, where), where, as_now)


def read_lines(
    model: type[T], path: Path, where: str, as_now: Callable[[Any], Any] | None = None
) -> tuple[T, ...]:
    """Records of a ``.jsonl`` file; ``as_now`` says the lines of an older version our way. Raises
    InputError with the problems, ``where:line: …``; it stops reading where there are too many."""
    out: list[T] = []
    problems: list[str] = []
    for number, line in numbered_lines(path, where):
        try:
            out.append(to_record(model, line, f"{where}:{number}", as_now))
        except InputError as error:
            problems.extend(error.problems)
            if len(problems) >= SHOWN:
                problems.append(f"{where}:{number}: not read further: too many problems")
                break
    if problems:
        raise InputError(problems)
    return tuple(out)
