"""How well predictions match: the paper's Anomaly Success scores, and usual ones.

The paper leaves open what a hazard-free scene scores and what CAS is divided by. Our reading: AS
is taken over scenes that have an anomaly, CAS over those that have one to report, divided by
|A+| and not clipped; what is said of hazard-free scenes counts as unwanted or as false alarm.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from sdgen.benchmark.collect import Collected, collect, opened, predicted
from sdgen.benchmark.outcome import Outcome, SceneScores, score_scene
from sdgen.benchmark.scores import Column, Score, means, ratio, score, scores_of, shares
from sdgen.benchmark.truth import SHOWN_BY, Ways, Wrong
from sdgen.dataset import Dataset
from sdgen.dataset.records import SPLITS, Predictions
from sdgen.scene import Record
from sdgen.seeding import lane

__all__ = ["Evaluation", "Score", "SceneScores", "evaluate", "evaluation", "score", "score_scene"]

SEEN, UNSEEN = "seen", "unseen"


class Evaluation(Record):
    """All scores of a prediction (``evaluate --json``); docs/metrics.md says what each is."""

    AS: Score
    CAS: Score
    unwanted_per_scene: Score
    false_alarms_per_scene: Score
    precision: Score
    recall: Score
    f1: Score
    label_accuracy: Score
    recall_by_hazard: dict[str, Score]
    micro: dict[str, Score]
    hazard_free_alarmed: Score
    recall_by_group: dict[str, Score]
    recall_by_label: dict[str, Score]
    recall_by_visibility: dict[str, Score]
    recall_by_split: dict[str, Score]
    recall_by_seen: dict[str, Score]
    seen_gap: Score
    recall_by_category_seen: dict[str, Score]
    category_seen_gap: Score
    lookalikes_reported: Score
    lookalikes_reported_by_hazard: dict[str, Score]
    twins_told_apart: Score
    twin_false_alarms: Score


def evaluate(data: Dataset | str | Path, predictions: Predictions | str | Path) -> Evaluation:
    """Score predictions (or their file) against a data set (or its folder).

    Scenes without a prediction count as silence; lines of benign twins are used for what is said of
    twins alone. Raises InputError for a bad file, located, and for a catalogue that is not the data
    set's.
    """
    data = opened(data)
    return evaluation(collect(data, {"": predicted(data, predictions)}), "")


def evaluation(found: Collected, name: str) -> Evaluation:
    """The scores of one of several detectors."""
    outcomes = found.outcomes[name]
    info = found.data.info
    nested: dict[str, dict[str, Column]] = {"": _plain(outcomes), "micro": _micro(outcomes)}
    rows = [(k, wrong, yes) for k, one in enumerate(outcomes) for wrong, yes in one.anomalies()]
    splits = [one.split for one in outcomes]
    hazards = tuple(info.hazards_enabled)
    present = set(splits)
    for field, words, word in _cuts(
        hazards, info.vocabularies.groups, info.vocabularies.labels, found.ways
    ):
        said = [(word(wrong, splits[k]), k, yes) for k, wrong, yes in rows]
        if field == "recall_by_split":
            words = (*(s for s in SPLITS if s in present), *sorted(present - set(SPLITS)))
        more = sorted({one for one, _, _ in said if one is not None} - set(words))
        nested[field] = {
            key: shares(len(outcomes), [(k, yes) for one, k, yes in said if one == key])
            for key in (*words, *more)
        }
    nested["lookalikes_reported_by_hazard"] = _lookalikes(outcomes, hazards)
    flat = {f"{field}/{key}": c for field, cs in nested.items() for key, c in cs.items()}
    gaps = {
        f"/{gap}": (f"{field}/{SEEN}", f"{field}/{UNSEEN}")
        for gap, field in (
            ("seen_gap", "recall_by_seen"),
            ("category_seen_gap", "recall_by_category_seen"),
        )
    }
    # The same scenes are drawn whoever the detector is.
    scores = scores_of(flat, lane(info.seed, 0, "evaluate:scenes"), gaps)
    top: dict[str, Score] = {key[1:]: value for key, value in scores.items() if key[0] == "/"}
    parts: dict[str, dict[str, Score]] = {
        field: {key: scores[f"{field}/{key}"] for key in columns}
        for field, columns in nested.items()
        if field
    }
    # By a scene's objects, recall is what the paper calls Anomaly Success.
    return Evaluation.model_validate({**top, "recall": top["AS"], **parts})


#: What an anomaly of a scene of some split counts for; None: for nothing.
_Word = Callable[[Wrong, str], str | None]


def _cuts(
    hazards: Sequence[str], groups: Sequence[str], labels: Sequence[str], ways: Ways
) -> Iterable[tuple[str, Sequence[str], _Word]]:
    """Each way to cut recall: its field, the words that are told in any case, and an anomaly's."""

    def told(seen: bool | None) -> str | None:
        return None if seen is None else SEEN if seen else UNSEEN

    yield "recall_by_hazard", hazards, lambda one, _: one.way.hazard
    yield "recall_by_group", groups, lambda one, _: one.group
    yield "recall_by_label", labels, lambda one, _: one.label
    yield "recall_by_visibility", SHOWN_BY, lambda one, _: one.shown
    yield "recall_by_split", (), lambda _, split: split
    seen = (SEEN, UNSEEN)
    yield "recall_by_seen", seen, lambda one, split: told(ways.seen(one.way, split))
    yield (
        "recall_by_category_seen",
        seen,
        lambda one, split: told(ways.category_seen(one.way, split)),
    )


def _plain(outcomes: Sequence[Outcome]) -> dict[str, Column]:
    """The scores that are one number."""
    scenes = [one.scores for one in outcomes]
    twins = [one.twin for one in outcomes]
    reported, near = [0.0] * len(outcomes), [0.0] * len(outcomes)
    apart, pairs = [0.0] * len(outcomes), [0.0] * len(outcomes)
    for k, one in enumerate(outcomes):
        likes = [item for item in one.items if item.near_miss_of]
        near[k], reported[k] = len(likes), sum(item.said is not None for item in likes)
        if one.twin is not None:
            again = {item.object_id for item in one.twin.items if item.said is not None}
            both = [(wrong, yes) for wrong, yes in one.anomalies() if wrong.in_twin]
            pairs[k] = len(both)
            apart[k] = sum(yes and wrong.object_id not in again for wrong, yes in both)
    return {
        "AS": means([s.as_ for s in scenes]),
        "CAS": means([s.cas for s in scenes]),
        "unwanted_per_scene": means([s.unwanted for s in scenes]),
        "false_alarms_per_scene": means([s.false_alarms for s in scenes]),
        "precision": means([s.precision for s in scenes]),
        "f1": means([s.f1 for s in scenes]),
        "label_accuracy": means([s.label_accuracy for s in scenes]),
        "hazard_free_alarmed": means(
            [float(s.scores.false_alarms > 0) if s.hazard_free else None for s in outcomes]
        ),
        "lookalikes_reported": ratio(reported, near),
        "twins_told_apart": ratio(apart, pairs),
        "twin_false_alarms": means(
            [t.scores.false_alarms if t is not None else None for t in twins]
        ),
    }


def _micro(outcomes: Sequence[Outcome]) -> dict[str, Column]:
    """Precision, recall and F1 over all objects at once."""
    hits = [float(one.scores.hits) for one in outcomes]
    detected = [float(one.scores.detected) for one in outcomes]
    wrong = [float(one.scores.wrong) for one in outcomes]
    both = [a + b for a, b in zip(detected, wrong, strict=True)]
    return {
        "precision": ratio(hits, detected),
        "recall": ratio(hits, wrong),
        "f1": ratio([2 * value for value in hits], both),
    }


def _lookalikes(outcomes: Sequence[Outcome], hazards: Sequence[str]) -> dict[str, Column]:
    found: dict[str, list[tuple[int, bool]]] = {hazard: [] for hazard in hazards}
    for k, one in enumerate(outcomes):
        for item in one.items:
            for hazard in item.near_miss_of:
                found.setdefault(hazard, []).append((k, item.said is not None))
    return {hazard: shares(len(outcomes), rows) for hazard, rows in found.items()}
