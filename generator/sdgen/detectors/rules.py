"""The upper bound: predicates over the exact scene, the household's rule for what to say."""

from __future__ import annotations

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.hazards.certify import certify
from sdgen.households import decide

_URGENCY = {"now": 0, "summary": 1, "silent": 2}


def rules(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """What the predicates say of the exact scene, whatever part of its graph is shown.

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
        report = Report(
            object_id=positive.object_id, label=hazard.label, notify=decision.notify, score=1.0
        )
        before = best.get(report.object_id)
        if before is None or _URGENCY[report.notify] < _URGENCY[before.notify]:
            best[report.object_id] = report
    return tuple(best[key] for key in sorted(best))
