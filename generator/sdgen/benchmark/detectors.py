"""Detectors to compare with: what a perfect reader, a silent and an anxious one would say."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from sdgen.benchmark.predictions import Predictions
from sdgen.catalog.records import Label
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.records import Report
from sdgen.errors import UsageError, did_you_mean
from sdgen.hazards.certify import certify
from sdgen.households import decide

#: A detector looks at one scene of a data set.
Detector = Callable[[Dataset, SceneItem], tuple[Report, ...]]

_URGENCY = {"now": 0, "summary": 1, "silent": 2}


def rules(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """The catalogue's predicates over the files, the household's rule for what to say.

    It never opens ``anomalies.json``: agreement with it shows that labels follow from the files.
    """
    catalog = data.catalog
    best: dict[int, Report] = {}
    rooms = {room.id: room.type for room in item.scene.home.rooms}
    room_of = {thing.id: thing.room_id for thing in item.scene.objects}
    for positive in certify(item.scene, data.infos, catalog):
        # In doubt are only things of others' scenes: nobody's label says what these are.
        if not (positive.verdict.value and positive.verdict.sure):
            continue
        hazard = catalog.hazard(positive.hazard)
        room = rooms[room_of[positive.object_id]]
        evidence = positive.verdict.evidence
        decision = decide(hazard, evidence, item.household, catalog.reach, room)
        report = Report(object_id=positive.object_id, label=hazard.label, notify=decision.notify)
        before = best.get(report.object_id)
        if before is None or _URGENCY[report.notify] < _URGENCY[before.notify]:
            best[report.object_id] = report
    return tuple(best[key] for key in sorted(best))


def never(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """Notices nothing."""
    return ()


def always(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """Reports every object, at once and as unsafe."""
    label: Label = "unsafe"
    return tuple(Report(object_id=thing.id, label=label) for thing in item.scene.objects)


DETECTORS: Mapping[str, Detector] = {"rules": rules, "never": never, "always": always}


def detect(
    data: Dataset, method: str, on_scene: Callable[[int, int], None] | None = None
) -> Predictions:
    """Reports of a detector for every scene.

    UsageError for a method nobody knows, InputError for a scene whose files disagree.
    """
    if method not in DETECTORS:
        raise UsageError(f"no method {method!r}{did_you_mean(method, list(DETECTORS))}")
    detector = DETECTORS[method]
    out: dict[str, tuple[Report, ...]] = {}
    for done, item in enumerate(data, start=1):
        with derived_from(data, item):
            out[item.id] = detector(data, item)
        if on_scene is not None:
            on_scene(done, len(data))
    return out
