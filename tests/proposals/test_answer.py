"""An answer is data from a stranger: it is a list, or told what it is, with its line."""

from __future__ import annotations

import time

import pytest
from sdgen.errors import InputError
from sdgen.proposals.answer import MAX_BYTES, MAX_LINES, read_answer


def test_a_list_is_read_with_its_lines() -> None:
    source = read_answer(b"- {place: vase}\n\n- {set: stove}\n", "a")
    assert source.value == [{"place": "vase"}, {"set": "stove"}]
    assert [source.line((k,)) for k in (0, 1)] == [1, 3]


@pytest.mark.parametrize("fence", ["```yaml", "```", "~~~ yml", "  ```"])
def test_a_fenced_block_is_read_on_the_lines_it_has(fence: str) -> None:
    end = fence.strip()[:3]
    text = f"Sure: here, and *more*\n\n{fence}\n- {{place: vase}}\n{end}\nHope: it: helps\n"
    source = read_answer(text.encode(), "a")
    assert source.value == [{"place": "vase"}]
    assert source.line((0,)) == 4
    # Cut short, as answers are.
    assert read_answer(f"{fence}\n- {{place: vase}}\n".encode(), "a").value == source.value


@pytest.mark.parametrize(
    ("raw", "told"),
    [
        (b"", "a:1: is empty"),
        (b"Sorry, I cannot help with that.", "a:1: expected a list of recipes, got text 'Sorry"),
        (b"Sure: here:\n- {place: vase}", "a:1: not valid YAML"),
        (b"anomalies:\n- {place: vase}", "a:1: expected a list of recipes, got a mapping"),
        (b"- {place: vase\n", "a:2: not valid YAML"),
        (b"- place: vase\n  place: mug\n", "a:2: [0].place: duplicate key 'place'"),
        (b"- !!python/object/apply:os.system ['x']\n", "a:1: [0]: tags are not allowed"),
        (b"- &a {place: vase}\n- *a\n", "a:1: anchors are not allowed here"),
        (b"- *a\n", "a:1: *a is used before"),
        (b"- &a [*a]\n", "a:1: *a is used before"),
        (b"- {<<: {place: vase}}\n", "a:1: [0].<<: merge keys are not supported"),
        (b"[" * 40, "a:1: is nested more than 32 deep"),
        (b"[" * 5000, "a:1: "),
        (b"- " * 5000, "a:1: is nested more than 32 deep"),
        (b"\xff\xfe\x00\x01", "a:1: is not UTF-8 text"),
        (b"- vase\x00\n", "a:1: not valid YAML"),
        (b"- a\n---\n- b\n", "a:2: holds more than one document"),
        (b"[" + b"a," * 30_000 + b"]", "a:1: holds more than 20000 values"),
        (b"\n" * (MAX_LINES + 1), f"a: has more than {MAX_LINES} lines"),
        (b"x" * (MAX_BYTES + 1), "a: is larger than 200 kB"),
    ],
)
def test_what_is_no_list_is_told_with_its_line(raw: bytes, told: str) -> None:
    start = time.monotonic()
    with pytest.raises(InputError) as caught:
        read_answer(raw, "a")
    assert caught.value.problems[0].startswith(told)
    assert time.monotonic() - start < 5
