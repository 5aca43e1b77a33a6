"""What lmms-eval calls for each question; beside ``sdgen_questions.yaml``."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from PIL import Image

#: The folder of the questions.
HERE = Path(__file__).resolve().parent.parent
LETTERS = "ABCD"


def doc_to_visual(doc: dict[str, Any]) -> list[Image.Image]:
    """The picture of a question."""
    return [Image.open(HERE / doc["image"]).convert("RGB")]


def doc_to_text(
    doc: dict[str, Any], lmms_eval_specific_kwargs: dict[str, str] | None = None
) -> str:
    """The question with its options."""
    given = lmms_eval_specific_kwargs or {}
    options = [f"{letter}. {one}" for letter, one in zip(LETTERS, doc["options"])]  # noqa: B905
    asked = [doc["hint"], doc["question"], *options]
    text = "\n".join(line for line in asked if line)
    return f"{given.get('pre_prompt', '')}{text}\n{given.get('post_prompt', '')}"


def doc_to_target(doc: dict[str, Any]) -> str:
    """The letter of the right option."""
    return str(doc["answer"])


def process_results(doc: dict[str, Any], results: list[str]) -> dict[str, Any]:
    """What one answer says for each metric; the first lone letter in it is the answer."""
    found = re.search(r"\b([A-D])\b", results[0].upper())
    right = found is not None and found[1] == doc["answer"]
    said = {"id": doc["id"], "kind": doc["kind"], "twin": doc["twin"], "right": right}
    return {"accuracy": said, "pairs_right": said}


def accuracy(results: list[dict[str, Any]]) -> float:
    """The share of questions answered rightly."""
    return sum(bool(one["right"]) for one in results) / max(len(results), 1)


def pairs_right(results: list[dict[str, Any]]) -> float:
    """The share of pairs, a place and the same place in its twin, that are both right."""
    pairs: dict[str, list[bool]] = {}
    for one in results:
        if one["twin"]:
            pairs.setdefault(one["twin"], []).append(one["right"])
    whole = [all(both) for both in pairs.values() if len(both) == 2]
    return sum(whole) / max(len(whole), 1)
