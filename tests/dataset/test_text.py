"""JSON in and out: deterministic, strict, located."""

import contextlib
import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.dataset.text import (
    LINE,
    line_bytes,
    plain,
    pretty,
    read_lines,
    read_record,
    record_bytes,
    to_record,
)
from sdgen.errors import InputError
from sdgen.scene import Household, Member

JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=30,
)


@given(JSON)
def test_pretty_text_reads_back_as_the_same_value(value: Any) -> None:
    assert json.loads(pretty(value)) == value


def slow_pretty(value: Any, indent: str = "") -> tuple[str, bool]:
    """The layout from the inside out: the text, and whether it is one line."""
    if not isinstance(value, dict | list) or not value:
        return json.dumps(value, ensure_ascii=False), True
    inner = indent + " "
    laid = [slow_pretty(item, inner) for item in (value.values() if is_dict(value) else value)]
    keys = [f"{json.dumps(key, ensure_ascii=False)}: " for key in value] if is_dict(value) else []
    parts = [key + text for key, (text, _) in zip(keys or [""] * len(laid), laid, strict=True)]
    opening, closing = "{}" if is_dict(value) else "[]"
    short = opening + ", ".join(parts) + closing
    if all(one_line for _, one_line in laid) and len(indent) + len(short) <= LINE:
        return short, True
    lines = ",\n".join(inner + part for part in parts)
    return f"{opening}\n{lines}\n{indent}{closing}", False


def is_dict(value: Any) -> bool:
    return isinstance(value, dict)


@given(JSON, st.integers(0, LINE))
def test_the_layout_is_that_of_slow_code(value: Any, pad: int) -> None:
    padded = {"x" * pad: value, "rest": [value, "y" * pad]}
    assert pretty(padded) == slow_pretty(plain(padded))[0]


def test_what_fits_a_line_stays_on_it() -> None:
    text = pretty({"short": [1, 2, 3], "long": ["x" * 50, "y" * 50, "z" * 50]})
    assert '"short": [1, 2, 3]' in text
    assert max(len(line) for line in text.splitlines()) <= LINE


def test_mapping_keys_are_sorted_record_keys_keep_their_order() -> None:
    one = Household(template="t", members=(), notifications={"b": "now", "a": "silent"})
    text = record_bytes(one).decode()
    assert text.index('"template"') < text.index('"members"')
    assert text.index('"a"') < text.index('"b"')
    assert text.endswith("}\n")


def test_lines_hold_no_line_break_and_keep_letters() -> None:
    data = line_bytes(Household(template="naïve\n東", members=()))
    assert data.count(b"\n") == 1
    assert data.endswith(b"\n")
    assert "naïve\\n東".encode() in data


def test_not_a_number_is_never_written() -> None:
    with pytest.raises(ValueError):
        pretty({"x": float("nan")})


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (b'{"role": "adult", "age": 3', "where: not JSON"),
        (b'{\n"role": 1x}', "where:2: not JSON"),
        (b'\xff{"role"', "where: not UTF-8"),
        (b'{"role": "a", "age": 3, "age": 4}', "where: key 'age' appears twice"),
        (b'{"role": "a", "age": NaN}', "where: NaN is not a number"),
        (b'{"role": "a", "age": 1e999}', "where: 1e999 is too large"),
        (b'{"role": "a",\n"age": 1e999}', "where:2: 1e999 is too large"),
        (
            b'{"role": "a",\n"age":\n' + b"7" * 5001 + b"}",
            "where:3: 77777777777777777777... is too",
        ),
        (b'{"role": "a", "age": ' + b"7" * 5001 + b"}", "where: 77777777777777777777... is too"),
        (b'{"role": "a", "age": "3"}', "where: age: expected a whole number, got text '3'"),
        (b'{"role": "a", "age": 300}', "where: age: input should be less than"),
        (b'{"role": "a", "age": 3, "agee": 1}', "where: agee: unknown key (did you mean 'age'?)"),
        (b'{"role": "a"}', "where: missing key 'age'"),
        (b"[" * 100_000, "where: nested too deeply"),
        (b"[]", "where: expected a mapping (key: value), got a list"),
    ],
)
def test_bad_text_is_located(data: bytes, expected: str) -> None:
    with pytest.raises(InputError) as caught:
        to_record(Member, data, "where")
    assert caught.value.problems[0].startswith(expected)


def test_all_bad_lines_are_reported_at_once(tmp_path: Path) -> None:
    path = tmp_path / "members.jsonl"
    path.write_bytes(b'{"role": "a", "age": 3}\n{"role": 1, "age": 3}\n\nx\n')
    with pytest.raises(InputError) as caught:
        read_lines(Member, path, "members.jsonl")
    first, second = caught.value.problems
    assert first.startswith("members.jsonl:2: role:")
    assert second.startswith("members.jsonl:4")


@given(st.binary(max_size=60))
def test_no_bytes_raise_anything_else(data: bytes) -> None:
    with contextlib.suppress(InputError):
        to_record(Member, data, "where")


def test_records_survive_the_round_trip() -> None:
    scene = toy_scene()
    assert to_record(type(scene), record_bytes(scene), "x") == scene


def toy_scene() -> Any:
    from tests import toy

    return toy.scene(3)


def test_a_file_far_too_large_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "a.json").open("wb") as file:  # nothing but a hole
        file.truncate(201 * 10**6)
    for reader in (read_record, read_lines):
        with pytest.raises(InputError, match=r"^a\.json(:1)?: is larger than 200000 kB"):
            reader(Member, tmp_path / "a.json", "a.json")
