"""What needs no thought: silence, alarm, and a coin."""

from __future__ import annotations

from sdgen.catalog.records import Label
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.detectors.told import things
from sdgen.scene import Notify
from sdgen.seeding import lane

LABELS: tuple[Label, ...] = ("unsafe", "unsanitary", "unsafe for children")
_NOTIFY: tuple[Notify, ...] = ("now", "silent")


def never(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """Notices nothing."""
    return ()


def always(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """Reports every object that it is shown, at once and as unsafe."""
    return tuple(
        Report(object_id=node.id, label="unsafe", score=1.0) for node in things(item.shown_graph)
    )


def chance(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """A fair coin for each object it is shown, a fair one for whether to tell, a label of three.

    Its expectations are known: recall 1/2, label accuracy by the labels of what is found, CAS as
    half of ``always`` with half of that told.
    """
    rng = lane(data.info.seed, item.entry.index, f"detect:chance:{item.id}")
    reports = []
    for node in things(item.shown_graph):
        score, tell, label = rng.random(), rng.random(), int(rng.integers(len(LABELS)))
        if score >= 0.5:
            notify = _NOTIFY[int(tell >= 0.5)]
            reports.append(
                Report(object_id=node.id, label=LABELS[label], notify=notify, score=score)
            )
    return tuple(reports)
