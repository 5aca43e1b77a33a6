"""Undoes anomalies one after another by their remedies, and looks whether each way will do.

A way will do when its thing comes to rest where the remedy says, all others fixed, cuts into
nothing, stays and comes before no lens; when the predicate no longer holds and no other has come
to hold; and when everything else stands as before. What cannot be undone so is taken away.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from sdgen.cameras.nearest import cut_by_near_planes, drawn_boxes
from sdgen.facts import Facts, unheld
from sdgen.hazards.certify import Survey, facts_of, survey
from sdgen.hazards.remedies import Remedies, Step, stocked
from sdgen.hazards.twin import PUT, SET_BACK, TAKE_AWAY, plainly
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.library import Library
from sdgen.physics.client import Client
from sdgen.pipeline.putting import Rest, come_to_rest, facts_after, stands_there, stays
from sdgen.pipeline.undoing import check_standing
from sdgen.scene import Anomaly, Camera, ObjectInstance, Scene, Undone
from sdgen.seeding import Rng

#: Ways tried for one anomaly before its object is taken away: each costs some hundredths of a
#: second.
WAYS_TRIED = 24

Pair = tuple[int, str]


@dataclass(frozen=True)
class Tools:
    """What trying remedies needs, all of it of the build; ``cameras`` are the scene's, which show
    its twins from the same depth on."""

    context: HomeContext
    layout: Layout
    library: Library
    client: Client
    cameras: tuple[Camera, ...]


@dataclass(frozen=True)
class Remedied:
    """A scene in the middle of being undone, or at its end: its facts, the pairs that still hold,
    what was done for which pair, and how what was put elsewhere came to rest."""

    facts: Facts
    surveyed: Survey
    done: Mapping[Pair, Step] = field(default_factory=dict)
    rests: Mapping[int, Rest] = field(default_factory=dict)
    altered: frozenset[int] = frozenset()

    @property
    def pairs(self) -> frozenset[Pair]:
        """The pairs that hold."""
        return frozenset((one.object_id, one.hazard) for one in self.surveyed.positives)


def by_remedy(
    scene: Scene,
    known: Facts,
    anomalies: Sequence[Anomaly],
    staying: Collection[Anomaly],
    tools: Tools,
    lane: Callable[[str], Rng],
) -> Remedied | None:
    """``scene`` with these anomalies undone, those that are to be ``staying`` left as they are;
    None where not even taking the objects away leaves it sound.

    ``known`` are facts of the scene with all its anomalies, ``lane`` gives each anomaly its own
    generator.
    """
    catalog = tools.context.catalog
    facts = facts_of(scene, tools.library.infos, catalog, known)
    now = Remedied(facts, survey(facts, catalog))
    keep = frozenset((one.object_id, one.hazard) for one in staying)
    for anomaly in _in_order(anomalies, tools):
        if (anomaly.object_id, anomaly.hazard) not in now.pairs:
            continue  # something that was done before was enough
        after = _undo(now, anomaly, keep, tools, lane(f"remedy:{anomaly.id}"))
        if after is None:
            return None
        now = after
    return now


def _in_order(anomalies: Sequence[Anomaly], tools: Tools) -> list[Anomaly]:
    """What is only switched off or shut comes first: things go into a fridge that is shut."""

    def key(one: Anomaly) -> tuple[bool, bool, str]:
        rules = tools.context.catalog.hazard(one.hazard).remedy
        # Drawn ones before those that another's object merely satisfies, too.
        return rules[0].action not in SET_BACK, not one.drawn, one.id

    return sorted(anomalies, key=key)


def _undo(
    now: Remedied, anomaly: Anomaly, keep: frozenset[Pair], tools: Tools, rng: Rng
) -> Remedied | None:
    item = now.facts.bodies[anomaly.object_id].item
    for number, step in enumerate(_ways(now, anomaly, item, keep, tools, rng)):
        after = _after(now, anomaly, step, keep, tools)
        if after is not None:
            return after
        if number + 1 == WAYS_TRIED:
            break
    taken = plainly(now.facts.scene, [anomaly], tools.context.catalog, tools.library.infos)
    return _after(now, anomaly, Step(TAKE_AWAY, taken[item.id]), keep, tools)


def _ways(
    now: Remedied,
    anomaly: Anomaly,
    item: ObjectInstance,
    keep: frozenset[Pair],
    tools: Tools,
    rng: Rng,
) -> Iterator[Step]:
    layout = stocked(tools.layout, (o for o in now.facts.scene.objects if o.id != item.id))
    kept = frozenset(key for key, _ in keep)
    remedies = Remedies(now.facts, layout, tools.context, kept, rng)
    return remedies.steps(tools.context.catalog.hazard(anomaly.hazard).remedy, item)


def _after(
    now: Remedied, anomaly: Anomaly, step: Step, keep: frozenset[Pair], tools: Tools
) -> Remedied | None:
    """The scene after a step; None where it will not do."""
    key, library, catalog = anomaly.object_id, tools.library, tools.context.catalog
    before = now.facts.bodies[key].item
    put = step.item is not None and step.item.pose != before.pose
    changes: dict[int, ObjectInstance | None] = {key: step.item}
    if step.shut is not None:
        changes[step.shut.id] = step.shut
    rests = dict(now.rests)
    if put or step.item is None:
        rests = {k: rest.without(key) for k, rest in rests.items() if k != key}
    if put and step.item is not None:
        anyhow = step.action == "throw_away"
        rested = come_to_rest(step.item, changes, now.facts, anyhow, library, tools.client)
        if rested is None:
            return None
        changes[key], rests[key] = rested
    facts = facts_after(now.facts, changes, library.infos, catalog)
    surveyed = survey(facts, catalog)
    pairs = {(one.object_id, one.hazard) for one in surveyed.positives}
    if not all(one.verdict.sure and one.verdict.value for one in surveyed.positives):
        return None
    # A step for one pair may undo others of those that are to be undone, and brings about none.
    if not keep <= pairs or not pairs <= now.pairs - {(key, anomaly.hazard)}:
        return None
    if put and not stands_there(key, PUT[step.action], step.target_id, facts):
        return None
    # What is only set otherwise, or shut, was looked at when the cameras were made.
    if put and cut_by_near_planes(tools.cameras, drawn_boxes(library, facts.scene)):
        return None
    if any(True for _ in unheld(facts)) or (
        check_standing(now.facts.scene, facts, library, tools.client) is not None
    ):
        return None
    if step.item is not None and not before.fixed and not stays(key, facts, library, tools.client):
        return None
    cleared = {pair: step for pair in now.pairs - pairs if pair[0] == key}
    # What was done to it before is no longer so: it was put elsewhere since, or is gone.
    past = {pair: one for pair, one in now.done.items() if pair[0] == key}
    if put:
        cleared |= {pair: step for pair, one in past.items() if one.action in PUT}
    elif step.item is None:
        cleared |= dict.fromkeys(past, step)
    altered = now.altered | ({step.shut.id} if step.shut is not None else set())
    return Remedied(facts, surveyed, {**now.done, **cleared}, rests, altered)


def undone_records(anomalies: Sequence[Anomaly], after: Remedied) -> tuple[Undone, ...]:
    """What became of the anomalies that no longer hold, by their ids."""
    pairs, there = after.pairs, after.facts.bodies
    out = []
    for one in sorted(anomalies, key=lambda one: one.id):
        key = one.object_id
        if (key, one.hazard) in pairs:
            continue
        step = after.done.get((key, one.hazard))
        out.append(
            Undone(
                anomaly_id=one.id,
                hazard=one.hazard,
                object_id=key,
                action=None if step is None else step.action,
                target_id=None if step is None else step.target_id,
                moved=key in after.rests,
                removed=key not in there,
            )
        )
    return tuple(out)
