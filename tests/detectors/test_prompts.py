"""The prompts: the paper's word for word, the others named as what they are."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from sdgen.detectors.prompted import SIMPLIFY
from sdgen.detectors.prompts import PROMPTS

from tests.by_path import ROOT

DATA = Path(__file__).parent / "data"


def plain(latex: str) -> str:
    """LaTeX of the paper as text: paragraphs, words, straight quotes."""
    text = re.sub(r"\\(?:begin|end)\{\w+\}", "", latex)
    text = re.sub(r"\\textbf\{([^}]*)\}", r"\1", text)
    text = text.translate(dict.fromkeys(map(ord, "`’"), "'"))
    return "\n\n".join(
        " ".join(part.split()) for part in re.split(r"\n\s*\n", text) if part.strip()
    )


def test_the_prompt_of_the_paper_is_word_for_word() -> None:
    golden = (DATA / "cot_prompt.txt").read_text(encoding="utf-8").rstrip("\n")
    assert PROMPTS["cot-sg-c"].template == golden
    assert plain((DATA / "cot_prompt.tex").read_text(encoding="utf-8")) == golden


def test_only_that_one_is_no_reconstruction() -> None:
    assert [name for name, one in PROMPTS.items() if not one.reconstruction] == ["cot-sg-c"]


def test_the_papers_seven_are_there_in_the_order_of_its_table() -> None:
    assert [prompt.title for prompt in PROMPTS.values()] == [
        "Object List + E, C",
        "Scene Description + E, C",
        "SG, no C",
        "E + SG, no C",
        "SG & C",
        "E + SG & C",
        "CoT + SG & C",
        "Views",
    ]


@pytest.mark.parametrize("name", [name for name in PROMPTS if name != "views"])
def test_a_prompt_holds_what_its_row_says(name: str) -> None:
    prompt = PROMPTS[name]
    text = prompt.filled("WHAT IS ASKED", "WHO")
    assert text.startswith("WHO\n\nQ: ")
    assert text.count("WHAT IS ASKED") == 1
    assert ("medication" in text) is prompt.examples
    assert ("'unsanitary'" in text) is prompt.categories
    assert ("poison hazard" in text) is prompt.cot
    assert "[CONTENT]" not in text


def test_what_is_asked_about_may_hold_our_own_marks() -> None:
    assert PROMPTS["sg"].filled("[CONTENT] x").count("[CONTENT] x") == 1


def test_the_guide_shows_the_prompts_that_are_asked() -> None:
    page = (ROOT / "docs" / "prompts.md").read_text(encoding="utf-8")
    for name, prompt in PROMPTS.items():
        assert f"```text\n{prompt.template}\n```" in page, name
        assert f"| `{name}` |" in page
    assert f"```text\n{SIMPLIFY}\n```" in page
