"""Plain values and their lines; nothing that YAML can hold becomes a traceback."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
import yaml
from hypothesis import example, given, settings
from hypothesis import strategies as st
from sdgen import yaml_source
from sdgen.errors import SHOWN, InputError
from sdgen.yaml_source import MAX_BYTES, parse_yaml, read_yaml, show_path


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("on", "on"),
        ("off", "off"),
        ("yes", "yes"),
        ("No", "No"),
        ("true", True),
        ("false", False),
        ("~", None),
        ("", None),
        ("'1'", "1"),
        ('"true"', "true"),
        ("! 1", "1"),
        ("1", 1),
        ("-3", -3),
        ("1.5", 1.5),
        (".5", 0.5),
        ("1e3", 1000.0),
        ("0x10", "0x10"),
        ("0o17", "0o17"),
        ("1_000", "1_000"),
        ("2020-01-01", "2020-01-01"),
        ("12:30", "12:30"),
        (".nan", ".nan"),
        (".inf", ".inf"),
        ("9" * 5000, "9" * 5000),
    ],
)
def test_scalars_mean_what_they_look_like(text: str, value: object) -> None:
    source = parse_yaml(f"key: {text}\n".encode(), "f.yaml")
    assert source.problems == []
    assert source.value == {"key": value}
    assert type(source.value["key"]) is type(value)


@pytest.mark.parametrize("loader", [yaml.SafeLoader, getattr(yaml, "CSafeLoader", None)])
def test_both_parsers_of_pyyaml_give_the_same(
    loader: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    if loader is None:
        pytest.skip("PyYAML without libyaml")
    monkeypatch.setattr(yaml_source, "_LOADER", loader)
    text = "a: &x [on, 1, 'two']\nb: *x\nc:\n  d: {e: no, f: null}\n"
    source = parse_yaml(text.encode(), "f.yaml")
    assert source.value == {
        "a": ["on", 1, "two"],
        "b": ["on", 1, "two"],
        "c": {"d": {"e": "no", "f": None}},
    }
    assert source.lines["c", "d", "e"] == 4
    assert source.lines["b", 1] == 1  # where the value is written


@pytest.mark.parametrize(
    ("raw", "problem"),
    [
        (b"", "f.yaml:1: is empty"),
        (b"# a comment\n", "f.yaml:1: is empty"),
        (b"a: 1\nb: \xff\n", "f.yaml:2: is not UTF-8 text"),
        (b"a: 1\nb: 2\na: 3\n", "f.yaml:3: a: duplicate key 'a' (first on line 1)"),
        (b"x:\n  a: 1\n  'a': 3\n", "f.yaml:3: x.a: duplicate key 'a' (first on line 2)"),
        (b"a: !!python/name:os.system x\n", "f.yaml:1: a: tags are not allowed"),
        (b"a: !mine [1]\n", "f.yaml:1: a: tags are not allowed (!mine)"),
        (b"b: {c: 1}\na:\n  <<: {b: 1}\n", "f.yaml:3: a.<<: merge keys are not supported"),
        (b"a: 1\n---\nb: 2\n", "f.yaml:2: holds more than one document"),
        (b"? [1, 2]\n: 3\n", "f.yaml:1: top level: a key must be a word"),
        (b"a: [1\nb: 2\n", "f.yaml:2: not valid YAML"),
        (b"a: \x00\n", "f.yaml:1: not valid YAML"),
        (b"a: &a [1, *a]\n", "f.yaml:1: *a is used before (or inside) its anchor"),
        (b"a: *nowhere\n", "f.yaml:1: *nowhere is used before"),
        (b"[" * 100, "f.yaml:1: is nested more than"),
        (b"a: 1e999\n", "f.yaml:1: a: 1e999 is too large a number"),
        (b"a: " + b"x" * MAX_BYTES, "f.yaml: is larger than"),
    ],
)
def test_bad_files_are_problems_with_a_line(raw: bytes, problem: str) -> None:
    source = parse_yaml(raw, "f.yaml")
    assert len(source.problems) == 1, source.problems
    assert source.problems[0].startswith(problem)


def test_aliases_cannot_blow_up() -> None:
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x, x]"]
    for k in range(1, 12):
        lines.append(f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 10)}]")
    source = parse_yaml("\n".join(lines).encode(), "bomb.yaml")
    assert "through aliases" in source.problems[0] or "nested" in source.problems[0]
    many = "\n".join(f"k{k}: &k{k} 1" for k in range(2000))
    assert "anchors" in parse_yaml(many.encode(), "many.yaml").problems[0]


def test_a_missing_file_is_one_clear_error(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_yaml(tmp_path / "none.yaml")
    with pytest.raises(InputError, match="is a folder, not a file"):
        read_yaml(tmp_path)
    os.mkfifo(tmp_path / "pipe.yaml")
    with pytest.raises(InputError, match="is a FIFO, not a file"):
        read_yaml(tmp_path / "pipe.yaml")
    with pytest.raises(InputError, match="is a device, not a file"):
        read_yaml(Path("/dev/zero"))


def test_of_very_many_problems_only_some_are_told() -> None:
    raw = b"".join(b"a: 1\n" for _ in range(50_000))
    problems = parse_yaml(raw, "f.yaml").problems
    assert len(problems) == SHOWN + 1
    assert problems[-1] == f"f.yaml: and {50_000 - 1 - SHOWN} more problems"


def test_a_path_reads_like_code() -> None:
    assert show_path(("anomalies", 0, "target", 2)) == "anomalies[0].target[2]"
    assert show_path(()) == ""


_YAML_LIKE = st.text(alphabet=" \n\t:-[]{}#&*!|>'\"%@`,?ab01.~<é\x00\ufeff", max_size=200)


@settings(max_examples=400)
@given(st.one_of(st.binary(max_size=300), _YAML_LIKE.map(lambda t: t.encode())))
@example(b"\xef\xbb\xbfa: 1")
@example(b"%YAML 1.1\n---\na: 1")
@example(b"- - - - -\n")
@example(b"a: &a\n  b: *a\n")
def test_no_bytes_raise(raw: bytes) -> None:
    source = parse_yaml(raw, "junk.yaml")
    for problem in source.problems:
        assert re.match(r"junk\.yaml(:\d+)?: ", problem)
        assert "\n" not in problem


_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(10**14), 10**14) | st.text(max_size=10),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(st.text(min_size=1, max_size=6), inner, max_size=4)
    ),
    max_leaves=20,
)


@given(st.dictionaries(st.text(min_size=1, max_size=6), _VALUES, min_size=1, max_size=5))
def test_what_is_written_quoted_is_read_back(value: dict[str, object]) -> None:
    text = yaml.safe_dump(value, default_style='"', allow_unicode=True)
    text = re.sub(r'!!(int|bool|null|float) "([^"]*)"', r"\2", text)
    source = parse_yaml(text.encode("utf-8"), "f.yaml")
    assert source.problems == []
    assert source.value == value
