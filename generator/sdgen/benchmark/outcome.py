"""What became of one scene: its scores, and a row for each thing that was found, missed or made up.

For a scene, *A* are the objects that are anomalies, *A+* those of them this household wants
reported, *D* the objects a prediction names, *D+* those it reports (not ``silent``). Objects, not
pairs: an object with two anomalies counts once, and is in *A+* when one of them is to be reported.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

from sdgen.benchmark.truth import Truth, Way, Wrong
from sdgen.dataset.records import Report
from sdgen.scene import Notify

#: ``lookalike``: one that was left alone; one that was not is a false alarm.
ItemKind = Literal["hit", "miss", "false_alarm", "lookalike"]


class Labelled(Protocol):
    """What the scores of a scene need of an anomaly."""

    @property
    def object_id(self) -> int: ...
    @property
    def label(self) -> str: ...
    @property
    def report(self) -> bool: ...


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
    wrong: int
    detected: int
    hits: int


@dataclass(frozen=True)
class Item:
    """One anomaly, false alarm or lookalike left alone. ``said`` is what was said of its object."""

    scene: str
    split: str
    kind: ItemKind
    object_id: int
    category: str | None
    room: str | None
    said: Report | None
    wrong: Wrong | None = None
    near_miss_of: tuple[str, ...] = ()

    @property
    def way(self) -> Way | None:
        """In what way it is wrong."""
        return self.wrong.way if self.wrong is not None else None


@dataclass(frozen=True)
class Outcome:
    """A scene's scores and items; ``twin`` is what was said of its benign twin, None where nobody
    looked at it."""

    scene: str
    split: str
    scores: SceneScores
    items: tuple[Item, ...]
    twin: Outcome | None = None

    @property
    def hazard_free(self) -> bool:
        """Whether nothing is wrong there."""
        return self.scores.wrong == 0

    def anomalies(self) -> Iterable[tuple[Wrong, bool]]:
        """Its anomalies, and whether each was detected."""
        return ((one.wrong, one.kind == "hit") for one in self.items if one.wrong is not None)


def score_scene(anomalies: Sequence[Labelled], reports: Sequence[Report]) -> SceneScores:
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
        wrong=len(wrong),
        detected=len(detected),
        hits=len(hits),
    )


def outcome(truth: Truth, predictions: Mapping[str, Sequence[Report]]) -> Outcome:
    """What became of a scene, and of its twin where there is a line for it; a scene without one
    counts as silence."""
    reports = predictions.get(truth.id, ())
    twin = truth.twin
    return Outcome(
        scene=truth.id,
        split=truth.split,
        scores=score_scene(truth.anomalies, reports),
        items=tuple(_items(truth, reports)),
        twin=outcome(twin, predictions) if twin is not None and twin.id in predictions else None,
    )


def _items(truth: Truth, reports: Sequence[Report]) -> Iterable[Item]:
    said = {report.object_id: report for report in reports}
    bad = set()
    for one in truth.anomalies:
        bad.add(one.object_id)
        told = said.get(one.object_id)
        kind: ItemKind = "miss" if told is None else "hit"
        category = one.way.category
        yield Item(truth.id, truth.split, kind, one.object_id, category, one.room, told, wrong=one)
    for key in sorted({*said, *truth.lookalikes} - bad):
        told = said.get(key)
        thing = truth.things.get(key)
        yield Item(
            truth.id,
            truth.split,
            "lookalike" if told is None else "false_alarm",
            key,
            thing.category if thing is not None else None,
            thing.room if thing is not None else None,
            told,
            near_miss_of=truth.lookalikes.get(key, ()),
        )


#: How much a household wants to hear of something, by what is said of it.
URGENCY: Mapping[Notify, int] = {"now": 0, "summary": 1, "silent": 2}


def wanted_notify(wrongs: Iterable[Wrong]) -> Notify:
    """How an object's household wants to hear of it: by the most urgent of its anomalies."""
    return min((one.notify for one in wrongs), key=URGENCY.__getitem__)
