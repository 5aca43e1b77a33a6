"""Questions about household hazards, as a task of inspect-ai.

    inspect eval inspect_task.py --model openai/gpt-4o

``-T kind=anomaly`` asks those of one kind, ``-T split=test`` those of one split. Needs no sdgen.
"""

from __future__ import annotations

import json
from pathlib import Path

from inspect_ai import Task, task
from inspect_ai.dataset import MemoryDataset, Sample
from inspect_ai.model import ChatMessageUser, ContentImage, ContentText
from inspect_ai.scorer import Metric, SampleScore, accuracy, choice, grouped, metric, stderr
from inspect_ai.solver import multiple_choice

HERE = Path(__file__).resolve().parent


@metric
def pairs_right() -> Metric:
    """The share of pairs, a place and the same place in its twin, that are both right."""

    def compute(scores: list[SampleScore]) -> float:
        pairs: dict[str, list[bool]] = {}
        for one in scores:
            twin = (one.sample_metadata or {}).get("twin")
            if twin is not None:
                pairs.setdefault(twin, []).append(one.score.as_float() == 1.0)
        whole = [all(both) for both in pairs.values() if len(both) == 2]
        return sum(whole) / len(whole) if whole else 0.0

    return compute


@task
def sdgen_questions(kind: str | None = None, split: str | None = None) -> Task:
    """All questions, or those of one kind or split."""
    lines = (HERE / "questions.jsonl").read_text(encoding="utf-8").splitlines()
    rows = [json.loads(line) for line in lines]
    samples = [
        _sample(row)
        for row in rows
        if kind in (None, row["kind"]) and split in (None, row["split"])
    ]
    return Task(
        dataset=MemoryDataset(samples, name="sdgen_questions"),
        solver=multiple_choice(),
        scorer=choice(),
        metrics=[grouped(accuracy(), "kind"), accuracy(), stderr(), pairs_right()],
    )


def _sample(row: dict[str, object]) -> Sample:
    text = f"{row['hint']}\n\n{row['question']}" if row["hint"] else str(row["question"])
    message = ChatMessageUser(
        content=[ContentImage(image=str(HERE / str(row["image"]))), ContentText(text=text)]
    )
    return Sample(
        id=str(row["id"]),
        input=[message],
        choices=[str(option) for option in row["options"]],  # type: ignore[attr-defined]
        target=str(row["answer"]),
        metadata={key: row[key] for key in ("kind", "split", "twin", "hazard", "scene")},
    )
