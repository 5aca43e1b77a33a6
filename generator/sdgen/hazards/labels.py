"""The records of anomalies and lookalikes, from what the predicates measured."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence

from sdgen.catalog.records import Catalog, Hazard, PlaceRecipe
from sdgen.facts import Facts
from sdgen.hazards.certify import Positive
from sdgen.hazards.evidence import evidence_of
from sdgen.hazards.placing import Injected
from sdgen.households import decide
from sdgen.scene import Anomaly, EvidenceValue, Household, Lookalike, Remedy, anomaly_id

#: Evidence that names a thing which makes an anomaly together with its object.
SHOWN_WITH = ("nearest_id", "above_id", "held_id", "facing_id", "away_from_id")
#: Relations of which the target does, rather than hold it: the door that a box stands before.
SHOWN_TARGETS = ("BLOCKS", "CLOSE", "FACING", "UNDER", "NEAR_HEAT", "NEAR_WATER")


def anomaly_records(
    positives: Sequence[Positive],
    facts: Facts,
    catalog: Catalog,
    household: Household,
    drawn: Collection[tuple[int, str]],
) -> tuple[Anomaly, ...]:
    """Anomalies sorted by object id; ids ``a00`` … follow that order and say nothing else.

    ``drawn`` are the pairs of object and hazard that the scene was asked for.
    """
    records = []
    ordered = sorted(positives, key=lambda p: (p.object_id, p.hazard))
    for number, positive in enumerate(ordered):
        hazard = catalog.hazard(positive.hazard)
        item = facts.bodies[positive.object_id].item
        relation, target = _relation(hazard, facts, item.id)
        evidence = dict(positive.verdict.evidence)
        parts, pixels = evidence_of(hazard, facts.bodies[item.id].info, item)
        room = facts.category(item.room_id)
        report, notify, reason = decide(hazard, evidence, household, catalog.reach, room)
        records.append(
            Anomaly(
                id=anomaly_id(number),
                hazard=hazard.id,
                group=hazard.group,
                label=hazard.label,
                object_id=item.id,
                category=item.category,
                states=facts.states(item.id),
                relation=relation,
                target_id=target,
                room_id=item.room_id,
                drawn=(item.id, hazard.id) in drawn,
                evidence=evidence,
                evidence_parts=parts,
                evidence_objects=_shown_with(evidence, facts, item.id),
                evidence_pixels_needed=pixels,
                evidence_outdoors_needed=hazard.evidence_outdoors,
                report=report,
                notify=notify,
                reason=reason,
                urgency=hazard.urgency,
                severity=hazard.severity and hazard.severity.harm,
                message=message(hazard, facts, item.id, target),
                remedy=remedy(hazard, facts, item.id),
            )
        )
    return tuple(records)


def _relation(hazard: Hazard, facts: Facts, object_id: int) -> tuple[str | None, int | None]:
    """The relation a label names, and its first target: the one that the hazard asks for, else
    the one that holds; none of what is only brought into a state where it is."""
    category = facts.category(object_id)
    placed = any(
        isinstance(recipe, PlaceRecipe) and category in recipe.categories
        for recipe in hazard.anomalies
    )
    if hazard.relation is None and not placed:
        return None, None
    for relation in (hazard.relation, "INSIDE", "ON"):
        if relation is not None:
            targets = facts.holds(object_id, relation)
            if targets:
                return relation, targets[0]
    return None, None


def _shown_with(
    evidence: Mapping[str, EvidenceValue], facts: Facts, object_id: int
) -> tuple[int, ...]:
    """The other things that make it an anomaly and are to be seen with it, by what was measured:
    the heater it is near, the bed below, the door it blocks. What it lies on is seen anyhow, and
    what a child climbs on matters where it is seen from above alone."""
    found = {
        value
        for key, value in evidence.items()
        if isinstance(value, int) and (_plain(key) in SHOWN_WITH or _is_beside(key, evidence))
    }
    return tuple(sorted(key for key in found if key in facts.bodies and key != object_id))


def _plain(key: str) -> str:
    """The name of a piece of evidence that several terms have."""
    return key.rstrip("_0123456789")


def _is_beside(key: str, evidence: Mapping[str, EvidenceValue]) -> bool:
    """Whether it names the target of a relation to something that does not hold the object."""
    number = key.removeprefix("target_id")
    # A second term's relation is left out where it is the first one's.
    relation = evidence.get(f"relation{number}", evidence.get("relation"))
    return _plain(key) == "target_id" and relation in SHOWN_TARGETS


def _words(category: str) -> str:
    return category.replace("_", " ")


def message(hazard: Hazard, facts: Facts, object_id: int, target_id: int | None) -> str:
    """The hazard's sentence with the object, its target and the room filled in."""
    words = {
        "object": _words(facts.category(object_id)),
        "target": _words(facts.category(target_id)) if target_id is not None else "",
        "room": _words(facts.room_type(object_id)),
    }
    text = hazard.message
    for key, value in words.items():
        text = text.replace("{" + key + "}", value)
    return text


def remedy(hazard: Hazard, facts: Facts, object_id: int) -> tuple[Remedy, ...]:
    """The hazard's steps, each with the nearest object of its target categories in this home."""
    here = facts.bodies[object_id].center
    out = []
    for rule in hazard.remedy:
        target: int | None = None
        best = math.inf
        for other_id, other in sorted(facts.bodies.items()):
            if other_id == object_id or other.item.category not in rule.targets:
                continue
            apart = math.dist(here.tolist(), other.center.tolist())
            if apart < best:
                best, target = apart, other_id
        out.append(Remedy(action=rule.action, object_id=object_id, target_id=target))
    return tuple(out)


def lookalike_records(
    lookalikes: Sequence[Injected], facts: Facts, catalog: Catalog
) -> tuple[Lookalike, ...]:
    """Lookalikes sorted by object id, with what the missed predicate measures of them."""
    records: Mapping[int, Lookalike] = {
        missed.object_id: Lookalike(
            object_id=missed.object_id,
            near_miss_of=missed.hazard,
            evidence=catalog.hazard(missed.hazard).predicate.measure(missed.object_id, facts),
        )
        for missed in lookalikes
    }
    return tuple(records[k] for k in sorted(records))


def measured_again(
    lookalikes: Iterable[Lookalike], facts: Facts, catalog: Catalog
) -> tuple[Lookalike, ...]:
    """Lookalikes of a twin: what is near them may be gone or have moved."""
    return tuple(
        one.model_copy(
            update={
                "evidence": catalog.hazard(one.near_miss_of).predicate.measure(one.object_id, facts)
            }
        )
        for one in lookalikes
    )


def with_ids_of(anomalies: Iterable[Anomaly], others: Iterable[Anomaly]) -> tuple[Anomaly, ...]:
    """Anomalies with the ids that the same pairs have among others, in a scene with more."""
    ids = {(one.object_id, one.hazard): one.id for one in others}
    return tuple(one.model_copy(update={"id": ids[one.object_id, one.hazard]}) for one in anomalies)
