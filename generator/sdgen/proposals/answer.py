"""An answer as lines of data: bounded, plain YAML, whatever it was written by."""

from __future__ import annotations

from sdgen.errors import InputError
from sdgen.strict import shown
from sdgen.yaml_source import Source, parse_yaml

MAX_BYTES = 200_000
#: Lines of text, and values in them: the prompt asks for 40 lines, of ten values each.
MAX_LINES = 500
MAX_VALUES = 20_000
_FENCES = ("```", "~~~")


def read_answer(raw: bytes, name: str) -> Source:
    """The answer's list, as plain values with their lines. Raises InputError, located, for what
    is too large, no text, no YAML or no list."""
    if len(raw) > MAX_BYTES:
        raise InputError([f"{name}: is larger than {MAX_BYTES // 1000} kB"])
    lines = raw.splitlines()
    if len(lines) > MAX_LINES:
        raise InputError([f"{name}: has more than {MAX_LINES} lines"])
    source = parse_yaml(_fenced(lines), name, MAX_BYTES, MAX_VALUES, max_anchors=0)
    if not source.problems and not isinstance(source.value, list):
        source.problem((), f"expected a list of recipes, got {shown(source.value)}")
    if source.problems:
        raise InputError(source.problems)
    return source


def _fenced(lines: list[bytes]) -> bytes:
    """The first fenced block alone, on the lines it had; all of it where there is none."""
    marks = [
        number
        for number, line in enumerate(lines)
        if line.strip().startswith(tuple(fence.encode() for fence in _FENCES))
    ]
    if not marks:
        return b"\n".join(lines)
    first, end = marks[0], marks[1] if len(marks) > 1 else len(lines)
    return b"\n".join([b""] * (first + 1) + lines[first + 1 : end])
