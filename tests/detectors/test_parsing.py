"""What is read from a model's free text: only what was asked, whatever it says."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.detectors.parsing import read_answer, verdict_in

APPLE = "apple (expired) INSIDE kitchen ON counter"
KNIFE = "knife INSIDE livingroom ON floor"
MUG = "mug INSIDE kitchen ON counter"
ASKED = [APPLE, KNIFE, MUG]
RIGHT = {APPLE: "unsanitary", KNIFE: "unsafe for children", MUG: "normal"}


def verdicts(text: str, asked: list[str] = ASKED, loose: bool = True) -> dict[str, str | None]:
    return {name: said.verdict for name, said in read_answer(text, asked, loose).said.items()}


@pytest.mark.parametrize(
    "text",
    [
        # As the paper's prompt teaches it.
        f"'{APPLE}': 'unsanitary' as it is rotten\n\n'{KNIFE}': 'unsafe for children' as a child "
        f"may cut itself, which is unsafe\n\n'{MUG}': 'normal'",
        # Other quotes, markdown, numbers, small letters, spaces.
        f"1. **“{APPLE.lower()}”** – *Unsanitary*\n2. “{KNIFE}” – Unsafe for children\n3. `{MUG}`: "
        "NORMAL",
        f"- {APPLE}:   unsanitary\n-   {KNIFE.replace(' ', '  ')} :unsafe_for_children\n- {MUG} => "
        "normal",
        # All on one line.
        f"['{APPLE}': 'unsanitary', '{KNIFE}': 'unsafe for children', '{MUG}': 'normal']",
        # The label first, below, in headings.
        f"unsanitary: {APPLE}\nunsafe for children: {KNIFE}\nnormal: {MUG}",
        f"Unsanitary: {APPLE}; unsafe for children: {KNIFE}; normal: {MUG}",
        f"**{APPLE}**\n- Classification: unsanitary\n- Why: old\n\n**{KNIFE}**\n- Classification: "
        f"unsafe for children\n\n**{MUG}**\n- Classification: normal",
        f"## Unsanitary\n- {APPLE}\n## Unsafe for children\n- {KNIFE}\n## Normal objects:\n- {MUG}",
        # JSON of several kinds.
        json.dumps(RIGHT),
        "```json\n" + json.dumps([{"relation": k, "label": v} for k, v in RIGHT.items()]) + "\n```",
        json.dumps(
            {"results": [{"label": v, "why": "unsafe", "object": k} for k, v in RIGHT.items()]}
        ),
        json.dumps({v: [k] for k, v in RIGHT.items()}),
        json.dumps({k: {"classification": v, "reason": "not unsafe"} for k, v in RIGHT.items()}),
        # What it thinks aloud does not count.
        f"<think>'{APPLE}': 'normal'?</think>\n'{APPLE}': 'unsanitary'\n'{KNIFE}': 'unsafe for "
        f"children'\n'{MUG}': 'normal'",
        # The question again, before the answer.
        f"Classify into 'normal', 'unsafe', 'unsanitary', or 'unsafe for children' - ['{APPLE}', "
        f"'{KNIFE}', '{MUG}']\n'{APPLE}': 'unsanitary'\n'{KNIFE}': 'unsafe for children'\n'{MUG}': "
        "'normal'",
    ],
)
def test_an_answer_in_any_dress_is_understood(text: str) -> None:
    assert verdicts(text) == RIGHT
    assert read_answer(text, ASKED).invented == ()


def test_several_strings_with_one_label() -> None:
    assert verdicts(f"'{APPLE}', '{KNIFE}' and '{MUG}': 'normal'") == dict.fromkeys(ASKED, "normal")


def test_the_first_of_two_labels_counts() -> None:
    assert verdicts(f"'{MUG}': 'normal'\n'{MUG}': 'unsafe'") == {MUG: "normal"}


def test_half_an_answer_is_half() -> None:
    whole = "\n".join(f"'{name}': '{label}'" for name, label in RIGHT.items())
    assert verdicts(whole[: whole.index(KNIFE) + len(KNIFE) + 3]) == {
        APPLE: "unsanitary",
        KNIFE: None,
    }


def test_a_class_nobody_offered_is_none() -> None:
    assert verdicts(f"'{MUG}': 'quite risky'\n'{APPLE}': 'not unsafe'") == {MUG: None, APPLE: None}


def test_what_was_never_asked_is_invented() -> None:
    text = f"'unicorn INSIDE hall ON rug': 'unsafe'\nghost INSIDE hall: normal\n'{MUG}': 'normal'"
    found = read_answer(text, ASKED)
    assert set(found.said) == {MUG}
    assert found.invented == ("unicorn inside hall on rug", "ghost inside hall: normal")


def test_a_string_that_begins_with_another_is_told_apart() -> None:
    asked = ["mug INSIDE kitchen", MUG]
    assert verdicts(f"'{MUG}': 'unsafe'", asked) == {MUG: "unsafe"}
    assert verdicts(f"'{asked[0]}': 'unsafe'", asked) == {asked[0]: "unsafe"}


def test_names_alone_are_read_where_they_are_answered_for() -> None:
    asked = ["knife", "counter", "fridge (open)", "fridge"]
    text = (
        "'knife': 'unsafe for children' as the counter is normal and a fridge unsafe\n"
        "counter: normal, fridge (open): unsanitary\n3. fridge - normal"
    )
    assert verdicts(text, asked, loose=False) == {
        "knife": "unsafe for children",
        "counter": "normal",
        "fridge (open)": "unsanitary",
        "fridge": "normal",
    }


@pytest.mark.parametrize(
    "text",
    ["none", "None.", "A: 'none'", "There are no lions", "[]", "No anomalies.", "All is fine"],
)
def test_nothing_is_an_answer(text: str) -> None:
    found = read_answer(text, ASKED)
    assert found.said == {}
    assert found.readable is (text != "There are no lions")


@pytest.mark.parametrize("text", ["", "I like turtles.", "```\n{[}\n```", "<html>", "{" * 5000])
def test_nonsense_is_not_readable(text: str) -> None:
    assert not read_answer(text, ASKED).readable


def test_whom_to_tell_is_read_where_it_is_said() -> None:
    text = f"'{APPLE}': 'unsanitary' (summary) as right now it rots\n'{KNIFE}': 'unsafe': silent"
    said = read_answer(text, ASKED).said
    assert (said[APPLE].notify, said[KNIFE].notify) == ("summary", "silent")
    assert read_answer(f"'{MUG}': 'unsafe' as now it falls", ASKED).said[MUG].notify is None


def test_one_word_of_a_second_model() -> None:
    assert verdict_in("Unsafe for children.") == "unsafe for children"
    assert verdict_in("Classification: **unsanitary**") == "unsanitary"
    assert verdict_in("dangerous") is None


words = st.sampled_from(
    [*ASKED, "mug", "'", '"', ":", "\n", "unsafe", "normal", "unsanitary", "[", "]"]
)
texts = st.one_of(
    st.text(),
    st.lists(st.one_of(words, st.text(max_size=5))).map(" ".join),
    st.recursive(
        st.one_of(st.text(max_size=9), words, st.integers(), st.floats(), st.none(), st.booleans()),
        lambda inner: (
            st.lists(inner) | st.dictionaries(st.one_of(words, st.text(max_size=5)), inner)
        ),
        max_leaves=20,
    ).map(json.dumps),
)


@given(texts, st.booleans(), st.lists(st.one_of(words, st.text(max_size=9)), max_size=5))
def test_whatever_it_says_only_what_was_asked_comes_back(
    text: str, loose: bool, asked: list[str]
) -> None:
    found = read_answer(text, asked, loose)
    assert set(found.said) <= set(asked)


@given(
    st.permutations(ASKED),
    st.dictionaries(st.sampled_from(ASKED), st.sampled_from(list(RIGHT.values()))),
)
def test_what_is_said_plainly_is_what_is_read(order: list[str], labels: dict[str, str]) -> None:
    lines = [f"'{name}': '{labels[name]}'" for name in order if name in labels]
    assert verdicts("\n".join(lines)) == labels
