"""What tables call the scores, and how they write them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sdgen.benchmark.compare import Difference
from sdgen.benchmark.scores import Score

#: Row of a table -> field of the evaluation.
ROWS: Mapping[str, str] = {
    "AS (Anomaly Success)": "AS",
    "CAS (Conditioned Anomaly Success)": "CAS",
    "unwanted a scene": "unwanted_per_scene",
    "false alarms a scene": "false_alarms_per_scene",
    "precision": "precision",
    "recall": "recall",
    "F1": "f1",
    "label accuracy": "label_accuracy",
    "hazard-free, alarmed": "hazard_free_alarmed",
    "lookalikes reported": "lookalikes_reported",
    "twins told apart": "twins_told_apart",
    "false alarms a twin": "twin_false_alarms",
    "recall, seen minus unseen ways": "seen_gap",
    "recall, seen minus unseen categories": "category_seen_gap",
}
#: Those that are told whether or not there is a value, and over what they are taken.
FIXED: Mapping[str, str] = {
    "AS": "scenes",
    "CAS": "scenes",
    "unwanted_per_scene": "scenes",
    "false_alarms_per_scene": "scenes",
    "precision": "scenes",
    "recall": "scenes",
    "f1": "scenes",
    "label_accuracy": "scenes",
}
#: Row of a table -> key of ``micro``.
MICRO: Mapping[str, str] = {
    "precision, all objects": "precision",
    "recall, all objects": "recall",
    "F1, all objects": "f1",
}
#: What is said of one word after another -> field of the evaluation.
CUTS: Mapping[str, str] = {
    "recall by hazard": "recall_by_hazard",
    "recall by group": "recall_by_group",
    "recall by label": "recall_by_label",
    "recall by pixels of the best view": "recall_by_visibility",
    "recall by split": "recall_by_split",
    "recall by way, outside train": "recall_by_seen",
    "recall by category, outside train": "recall_by_category_seen",
    "lookalikes reported, by hazard": "lookalikes_reported_by_hazard",
}


def over_in_words(counts: Sequence[int]) -> str:
    """Over how many values scores of several detectors are taken: once where it is the same."""
    return str(counts[0]) if len(set(counts)) == 1 else ", ".join(map(str, counts))


def in_words(score: Score | Difference) -> str:
    """``0.812 [0.790, 0.831]``; a dash where there is no value."""
    if score.mean is None:
        return "–"
    if score.low is None or score.high is None:
        return _number(score.mean)
    return f"{_number(score.mean)} [{_number(score.low)}, {_number(score.high)}]"


def p_in_words(p: float | None) -> str:
    """A p-value as it may be told: never as nothing."""
    if p is None:
        return "–"
    return "< 0.001" if p < 0.001 else f"{p:.3f}"


def _number(value: float) -> str:
    return f"{value:.3f}" if abs(value) < 100 else f"{value:.1f}"
