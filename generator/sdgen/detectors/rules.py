"""The upper bound: predicates over the scene, the household's rule for what to say."""

from __future__ import annotations

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.errors import UsageError
from sdgen.hazards.certify import Positive, certify, survey
from sdgen.households import decide
from sdgen.perception import Perceived

#: The score of what measures within a margin of a limit: of what was perceived, not of the truth.
UNSURE = 0.5
_URGENCY = {"now": 0, "summary": 1, "silent": 2}


def rules(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """What the predicates say of the exact scene or, with ``graph_view="perceived"``, of what was
    made out of it. It never opens ``anomalies.json``: agreement with it shows that labels follow
    from the files.

    UsageError for the ``neutral`` graph: predicates ask for states.
    """
    if item.graph_view == "neutral":
        raise UsageError(
            "the rules ask for states, which graph_view 'neutral' hides: take full or perceived"
        )
    catalog = data.catalog
    if item.graph_view == "perceived":
        scene, positives = item.perceived.scene, _surely_or_not(item.perceived)
    else:
        # In doubt are only things of others' scenes: nobody's label says what these are.
        scene = item.scene
        found = certify(scene, data.infos, catalog)
        positives = [p for p in found if p.verdict.value and p.verdict.sure]
    best: dict[int, Report] = {}
    rooms = {room.id: room.type for room in scene.home.rooms}
    room_of = {thing.id: thing.room_id for thing in scene.objects}
    for positive in positives:
        hazard = catalog.hazard(positive.hazard)
        room = rooms[room_of[positive.object_id]]
        evidence = positive.verdict.evidence
        decision = decide(hazard, evidence, item.household, catalog.reach, room)
        report = Report(
            object_id=positive.object_id,
            label=hazard.label,
            notify=decision.notify,
            score=1.0 if positive.verdict.sure else UNSURE,
        )
        before = best.get(report.object_id)
        if before is None or _URGENCY[report.notify] < _URGENCY[before.notify]:
            best[report.object_id] = report
    return tuple(best[key] for key in sorted(best))


def _surely_or_not(perceived: Perceived) -> list[Positive]:
    """What holds of a perceived scene, as measured: what is perceived is never exact."""
    found = survey(perceived.facts, perceived.catalog).positives
    return [positive for positive in found if positive.verdict.value]
