"""One try at a scene's contents: bring about, let settle, prove. A rejection is a value."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from sdgen.freespace import free_shape, reachable
from sdgen.geometry import round_position, round_quat
from sdgen.hazards.certify import Positive, Survey, facts_of, survey
from sdgen.hazards.inject import add_lookalikes, inject, undo
from sdgen.hazards.ways import Made
from sdgen.home.clutter import add_clutter
from sdgen.home.layout import Layout
from sdgen.library import Library
from sdgen.physics.checks import penetrations
from sdgen.physics.client import Client
from sdgen.physics.settle import Settled, settle
from sdgen.pipeline.stage import Stage
from sdgen.relations import Facts
from sdgen.scene import Pose, Scene
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M
from sdgen.zones import floor_obstacles, swing_blocked

SETTLE_ROUNDS = 4
#: After things were taken away, the rest must stand as it stood.
STILL_M = 0.003


@dataclass(frozen=True)
class Proved:
    """Settled, rounded contents whose labels hold, and how they were reached."""

    scene: Scene
    facts: Facts
    positives: tuple[Positive, ...]
    lookalikes: tuple[Made, ...]
    settled: Settled
    pairs: int
    removed: dict[str, int]


def attempt(
    index: int,
    stage: Stage,
    hazards: Sequence[str],
    training: bool,
    library: Library,
    client: Client,
    rng: Rng,
) -> Proved | str:
    """Contents of a scene with exactly the drawn anomalies, or the reason of rejection."""
    layout = stage.layout.copy()
    injection = inject(hazards, layout, stage.site, training, rng)
    if injection.failed is not None:
        return f"{injection.failed}: no place found"
    anomalies = {made.object_id: made for made in injection.anomalies}
    lookalikes = {
        made.object_id: made
        for made in add_lookalikes(layout, stage.site, injection.anomalies, rng)
    }
    add_clutter(
        layout, stage.site.home, stage.site.zones, stage.site.catalog, stage.site.models, rng
    )
    removed: dict[str, int] = {}
    settled = None
    for round_ in range(SETTLE_ROUNDS):
        done = _settle(index, stage, layout, library, client, first=round_ == 0)
        if isinstance(done, str):
            return done
        settled, offenders = done
        offenders = _with_dependents(layout, offenders)
        for object_id, why in offenders.items():
            if object_id in anomalies:
                return f"{anomalies[object_id].hazard}: {why}"
            if not _take_away(layout, object_id, lookalikes):
                return f"home: {layout.items[object_id].category} {why}"
            removed[why] = removed.get(why, 0) + 1
        if offenders:
            continue
        verdict = _certify(index, stage, layout, library, anomalies, lookalikes)
        if isinstance(verdict, _Sound):
            if _blocked(stage, layout, library, anomalies):
                return "home: clutter cuts a room off"
            return Proved(
                verdict.facts.scene,
                verdict.facts,
                verdict.survey.found,
                tuple(lookalikes[k] for k in sorted(lookalikes)),
                settled,
                verdict.survey.pairs,
                removed,
            )
        for object_id, why in verdict.items():
            if object_id in anomalies:
                return why
            if not _take_away(layout, object_id, lookalikes):
                return why
            removed[why] = removed.get(why, 0) + 1
    return "home: things would not come to rest"


def _take_away(layout: Layout, object_id: int, lookalikes: dict[int, Made]) -> bool:
    """Remove clutter or undo a lookalike; False for furniture, which stays."""
    made = lookalikes.pop(object_id, None)
    if made is not None:
        undo(made, layout)
        return True
    if object_id not in layout.items or layout.items[object_id].fixed:
        return object_id not in layout.items
    layout.drop(object_id)
    return True


def _settle(
    index: int, stage: Stage, layout: Layout, library: Library, client: Client, first: bool
) -> tuple[Settled, dict[int, str]] | str:
    """Let everything loose come to rest and take the rounded poses over; offenders with why."""
    scene = stage.scene(index, layout)
    dynamic = [item.id for item in scene.objects if not item.fixed]
    settled = settle(library, scene, dynamic, client)
    offenders: dict[int, str] = {}
    for object_id in dynamic:
        pose = settled.poses[object_id]
        if object_id in settled.unstable:
            offenders[object_id] = "would not stand"
        elif not first and settled.drift_m[object_id] > STILL_M:
            offenders[object_id] = "moved again"
        item = layout.items[object_id]
        rounded = Pose(
            position_m=round_position(pose.position_m), quat_xyzw=round_quat(pose.quat_xyzw)
        )
        layout.put(item.model_copy(update={"pose": rounded}))
    scene = stage.scene(index, layout)
    facts = facts_of(scene, library.infos, stage.site.catalog)
    for object_id, intent in layout.intents.items():
        if object_id in offenders or layout.items[object_id].fixed:
            continue
        holding = [
            r
            for r in facts.related(object_id, intent.relation)
            if r.target_id == intent.target_id and r.holds and r.sure
        ]
        if not holding:
            offenders[object_id] = f"is not {intent.relation} its target"
    if not offenders:
        for violation in penetrations(library, scene, client=client):
            if _rests_on_mat(layout, violation.objects):
                continue
            loose = [k for k in violation.objects if not _fixed(layout, k)]
            for object_id in loose or violation.objects[:1]:
                offenders[object_id] = "cuts into something"
    return settled, offenders


def _rests_on_mat(layout: Layout, pair: Sequence[int]) -> bool:
    """Furniture stands through a rug by the rug's few millimetres; nobody can see it."""
    items = [layout.items[k] for k in pair if k in layout.items]
    return all(item.fixed for item in items) and any(
        layout.info(item.id).extents_m[2] <= FLAT_M for item in items
    )


def _fixed(layout: Layout, object_id: int) -> bool:
    item = layout.items.get(object_id)
    return item is None or item.fixed


def _with_dependents(layout: Layout, offenders: dict[int, str]) -> dict[int, str]:
    """Offenders, and whatever stands on or in an offender that will go."""
    out = dict(offenders)
    grew = True
    while grew:
        grew = False
        for object_id, intent in layout.intents.items():
            loose = intent.target_id in layout.items and not layout.items[intent.target_id].fixed
            if object_id not in out and intent.target_id in out and loose:
                out[object_id] = "lost its support"
                grew = True
    return out


@dataclass(frozen=True)
class _Sound:
    facts: Facts
    survey: Survey


def _certify(
    index: int,
    stage: Stage,
    layout: Layout,
    library: Library,
    anomalies: dict[int, Made],
    lookalikes: dict[int, Made],
) -> _Sound | dict[int, str]:
    """Sound when exactly the drawn pairs hold and none is in doubt; else objects with why."""
    scene = stage.scene(index, layout)
    facts = facts_of(scene, library.infos, stage.site.catalog)
    result = survey(facts, stage.site.catalog)
    wrong: dict[int, str] = {}
    proved: set[int] = set()
    for positive in result.found:
        made = anomalies.get(positive.object_id)
        if made is not None and made.hazard == positive.hazard:
            if positive.verdict.value and positive.verdict.sure:
                proved.add(positive.object_id)
            continue
        doubt = "" if positive.verdict.sure else " in doubt"
        wrong[positive.object_id] = f"{positive.hazard}: accidental{doubt}"
    benign = [item for item in layout.items.values() if item.id not in anomalies]
    for object_id in swing_blocked(benign, library.infos):
        wrong[object_id] = "stands in a door's swing"
    for object_id, made in anomalies.items():
        if object_id not in proved:
            wrong[object_id] = f"{made.hazard}: not proved"
    return wrong or _Sound(facts, result)


def _blocked(stage: Stage, layout: Layout, library: Library, anomalies: Collection[int]) -> bool:
    """True when benign things on the floor cut a room off."""
    benign = [item for item in layout.items.values() if item.id not in anomalies]
    obstacles = floor_obstacles(benign, library.infos)
    return bool(reachable(stage.site.home, free_shape(stage.site.home, obstacles)))
