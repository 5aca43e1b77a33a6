"""How well predictions match: the paper's Anomaly Success scores, and usual ones.

For a scene, *A* are the objects that are anomalies, *A+* those of them this household wants
reported, *D* the objects a prediction names, *D+* those it reports (not ``silent``). Objects, not
pairs: an object with two anomalies counts once, and is in *A+* when one of them is to be reported.

The paper leaves open what a hazard-free scene scores and what CAS is divided by. Our reading: AS
is taken over scenes that have an anomaly, CAS over those that have one to report, divided by
|A+| and not clipped; what is said of hazard-free scenes counts as unwanted or as false alarm.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from sdgen.benchmark.predictions import read_predictions
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Predictions, Report
from sdgen.errors import InputError, did_you_mean
from sdgen.scene import Anomaly, Record


class Score(Record):
    """A mean, its standard error and over how many values; None where there are too few."""

    mean: float | None
    se: float | None
    n: int


class Evaluation(Record):
    """All scores of a prediction (``evaluate --json``)."""

    AS: Score
    CAS: Score
    unwanted_per_scene: Score
    false_alarms_per_scene: Score
    precision: Score
    recall: Score
    f1: Score
    label_accuracy: Score
    recall_by_hazard: dict[str, Score]


@dataclass(frozen=True)
class SceneScores:
    """What one scene contributes; None where a score is not defined for it."""

    as_: float | None
    cas: float | None
    unwanted: float
    false_alarms: float
    precision: float | None
    f1: float | None
    label_accuracy: float | None
    found_by_hazard: tuple[tuple[str, bool], ...]


def score(values: Iterable[float | None]) -> Score:
    """Mean and standard error (sample deviation over root n) of the values that are defined."""
    kept = [value for value in values if value is not None]
    n = len(kept)
    if n == 0:
        return Score(mean=None, se=None, n=0)
    mean = math.fsum(kept) / n
    if n == 1:
        return Score(mean=mean, se=None, n=1)
    variance = math.fsum((value - mean) ** 2 for value in kept) / (n - 1)
    return Score(mean=mean, se=math.sqrt(variance / n), n=n)


def score_scene(anomalies: Sequence[Anomaly], reports: Sequence[Report]) -> SceneScores:
    """The scores of one scene."""
    wrong = {a.object_id for a in anomalies}
    wanted = {a.object_id for a in anomalies if a.report}
    detected = {r.object_id for r in reports}
    reported = {r.object_id for r in reports if r.notify != "silent"}
    hits = wrong & detected
    unwanted = len((wrong - wanted) & reported)
    labels: dict[int, set[str]] = {}
    for anomaly in anomalies:
        labels.setdefault(anomaly.object_id, set()).add(anomaly.label)
    right = [r.label in labels[r.object_id] for r in reports if r.object_id in hits]
    return SceneScores(
        as_=len(hits) / len(wrong) if wrong else None,
        cas=(len(wanted & reported) - unwanted) / len(wanted) if wanted else None,
        unwanted=float(unwanted),
        false_alarms=float(len(detected - wrong)),
        precision=len(hits) / len(detected) if detected else None,
        f1=2 * len(hits) / (len(wrong) + len(detected)) if wrong or detected else None,
        label_accuracy=sum(right) / len(right) if right else None,
        found_by_hazard=tuple((a.hazard, a.object_id in detected) for a in anomalies),
    )


def _anomalies(data: Dataset, item: SceneItem) -> tuple[Anomaly, ...]:
    for anomaly in item.anomalies.anomalies:
        if anomaly.hazard not in data.info.hazards_enabled:
            known = list(data.info.hazards_enabled)
            hint = did_you_mean(anomaly.hazard, known)
            where = item.where("anomalies.json")
            raise InputError([f"{where}: {anomaly.id}: no hazard {anomaly.hazard!r}{hint}"])
    return item.anomalies.anomalies


def evaluate(data: Dataset | str | Path, predictions: Predictions | str | Path) -> Evaluation:
    """Score predictions (or their file) against a data set (or its folder).

    Scenes without a prediction count as silence. Raises InputError for a bad file, located, and for
    a catalogue that is not the data set's.
    """
    if isinstance(data, str | Path):
        data = Dataset(data)
    _ = data.catalog  # refused where it is not the one of the labels
    if isinstance(predictions, str | Path):
        predictions = read_predictions(predictions, data)
    scenes = [score_scene(_anomalies(data, item), predictions.get(item.id, ())) for item in data]
    by_hazard: dict[str, list[float]] = {hazard: [] for hazard in data.info.hazards_enabled}
    for scene in scenes:
        for hazard, found in scene.found_by_hazard:
            by_hazard[hazard].append(float(found))
    anomaly_score = score(s.as_ for s in scenes)
    return Evaluation(
        AS=anomaly_score,
        CAS=score(s.cas for s in scenes),
        unwanted_per_scene=score(s.unwanted for s in scenes),
        false_alarms_per_scene=score(s.false_alarms for s in scenes),
        precision=score(s.precision for s in scenes),
        # By a scene's objects, recall is what the paper calls Anomaly Success.
        recall=anomaly_score,
        f1=score(s.f1 for s in scenes),
        label_accuracy=score(s.label_accuracy for s in scenes),
        recall_by_hazard={hazard: score(values) for hazard, values in by_hazard.items()},
    )
