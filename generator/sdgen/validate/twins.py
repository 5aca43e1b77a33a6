"""A twin against its scene: what its scene is with anomalies undone as it says, nothing else."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any

from sdgen.actions import at_rest, settled_states
from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset
from sdgen.dataset.item import SceneItem
from sdgen.errors import InputError
from sdgen.facts import Facts
from sdgen.hazards.certify import facts_of
from sdgen.hazards.twin import (
    PUT,
    SET_BACK,
    TAKE_AWAY,
    physics_of_twin,
    set_back,
    with_changes,
)
from sdgen.library.records import AssetInfo
from sdgen.scene import Anomaly, ObjectInstance, PhysicsReport, Scene, Undone
from sdgen.validate.labels import check_scene
from sdgen.validate.problems import SHOWN, Problem, differences
from sdgen.validate.twin_views import check_twin_views


def check_twin(data: Dataset, item: SceneItem) -> Iterator[Problem]:
    """What a twin says was undone, and that it is its scene otherwise: objects, home, physics,
    lookalikes, and every pixel of the masks that shows nothing of what was changed.

    Nothing is said where that scene is not sound itself: it is told of there.
    """
    base = _base(data, item)
    if base is None:
        return
    for text in islice(_undone(data, item, base), SHOWN):
        yield Problem("scene", f"{item.where('anomalies.json')}: undone{text}")
    # By the data set's own catalogue: another one says other things of hazards, not of the twin.
    after = _after(item, base, data.infos)
    objects = with_changes(base.scene, after, data.infos)
    stated = {"id": item.scene.id, "twin_of": base.id, "objects": objects}
    derived = base.scene.model_copy(update=stated)
    put = {one.object_id for one in item.anomalies.undone if one.moved}
    found: dict[str, Iterator[str]] = {
        "scene.json": _scene_differences(item.scene, derived),
        "physics.json": differences(
            _without(item.physics, put),
            _without(physics_of_twin(derived, base.physics), put),
            "physics",
        ),
        "anomalies.json": differences(
            _lookalikes(item),
            [pair for pair in _lookalikes(base) if pair[0] not in _shut(after, item)],
            "lookalikes",
        ),
    }
    for name, texts in found.items():
        for text in islice(texts, SHOWN):
            path = f"{item.where(name)}: {text.removeprefix('physics.')}"
            yield Problem("scene", f"{path} from {base.id} with its anomalies undone")
    yield from check_twin_views(item, base)


def _base(data: Dataset, item: SceneItem) -> SceneItem | None:
    """The scene a twin is of; None where there is none, or none to derive from."""
    entry = next((e for e in data.entries if e.id == item.scene.twin_of), None)
    if entry is None:
        return None
    base = SceneItem(data.path, entry, checked=False)
    hazards = {hazard.id for hazard in data.catalog.hazards}
    try:
        if any(check_scene(base, data.infos, data.catalog, data.info.format_version)):
            return None
        sound = all(anomaly.hazard in hazards for anomaly in base.anomalies.anomalies)
        _ = base.physics
    except InputError:
        return None
    return base if sound else None


def _undone(data: Dataset, item: SceneItem, base: SceneItem) -> Iterator[str]:
    """What is wrong with the list of what was undone."""
    every = {one.id: one for one in base.anomalies.anomalies}
    undone = [one.anomaly_id for one in item.anomalies.undone]
    left = {one.id: (one.object_id, one.hazard) for one in item.anomalies.anomalies}
    if undone != sorted(set(undone)):
        yield ": not sorted by anomaly_id, one an anomaly"
    for key, pair in left.items():
        if key not in every or pair != (every[key].object_id, every[key].hazard):
            yield f": anomaly {key} of {item.id} is none of {base.id}"
    for key in sorted(every.keys() - left.keys() - set(undone)):
        yield f": nothing of anomaly {key} of {base.id}"
    for key in sorted(left.keys() & set(undone)):
        yield f": anomaly {key} is said to be undone and still listed"
    if item.entry.kind == "toggle" and item.id.rpartition("-")[2] not in undone:
        yield ": not the anomaly of its id"
    facts = facts_of(item.scene, data.infos, data.catalog)
    for k, one in enumerate(item.anomalies.undone):
        anomaly = every.get(one.anomaly_id)
        if anomaly is None or (anomaly.object_id, anomaly.hazard) != (one.object_id, one.hazard):
            yield f"[{k}]: no such anomaly of {base.id}"
        else:
            for text in _one(one, base.anomalies.anomalies, facts, data.catalog):
                yield f"[{k}]: {text}"


def _one(
    one: Undone, anomalies: tuple[Anomaly, ...], facts: Facts, catalog: Catalog
) -> Iterator[str]:
    """Whether one was undone as its hazard's remedies (or others of its object's) say."""
    there = one.object_id in facts.bodies
    if one.removed == there:
        is_now = "there" if there else "gone"
        yield f"removed: {str(one.removed).lower()}, object {one.object_id} is {is_now}"
    hazards = {a.hazard for a in anomalies if a.object_id == one.object_id}
    rules = [rule for name in sorted(hazards) for rule in catalog.hazard(name).remedy]
    ways = [rule for rule in rules if rule.action == one.action]
    if one.action not in (None, TAKE_AWAY) and not ways:
        yield f"action: {one.action!r} is no remedy of {one.hazard}"
        return
    if one.target_id is None:
        if there and one.moved and one.action in PUT:
            yield f"target_id: nothing, though the object was put somewhere ({one.action})"
        return
    relation = PUT.get(one.action or "")
    known = one.target_id in facts.bodies or one.target_id in facts.structures
    category = facts.category(one.target_id) if known else None
    allowed = {name for rule in ways for name in rule.targets}
    if one.action == "move_away":
        allowed = {"floor"}
    if relation is None or not there or category not in allowed:
        yield f"target_id: {one.target_id} ({category or 'not there'}) is no target of {one.action}"
        return
    last = all(a.object_id != one.object_id or a.id <= one.anomaly_id for a in anomalies)
    related = facts.related(one.object_id, relation)
    held = any(r.target_id == one.target_id and r.holds and r.sure for r in related)
    if not held and last:
        yield f"object {one.object_id} is not {relation} {category} {one.target_id}"


def _after(
    item: SceneItem, base: SceneItem, infos: Mapping[str, AssetInfo]
) -> dict[int, ObjectInstance | None]:
    """The objects that were changed, as they may be after what is said to have been done: as they
    are stored where that is possible."""
    before = {thing.id: thing for thing in base.scene.objects}
    stored = {thing.id: thing for thing in item.scene.objects}
    after: dict[int, ObjectInstance | None] = {}
    for one in item.anomalies.undone:
        thing = before.get(one.object_id)
        if thing is None:
            continue
        now = stored.get(thing.id)
        if one.removed or now is None:
            after[thing.id] = None if one.removed else thing
            continue
        may_be = [thing, *_set_back(thing, infos[thing.asset], one, item.anomalies.undone)]
        alike = [m for m in may_be if (m.joints, m.variant) == (now.joints, now.variant)]
        changed = alike[0] if alike else may_be[-1]
        if one.moved:
            changed = changed.model_copy(update={"pose": now.pose, "room_id": now.room_id})
        after[thing.id] = changed
    for one in item.anomalies.undone:
        target = before.get(one.target_id or 0)
        if target is not None and target.id in stored and target.id not in after:
            shut = _with_leaves_as(target, stored[target.id], infos[target.asset])
            if shut != target:
                after[target.id] = shut
    return after


def _set_back(
    thing: ObjectInstance, info: AssetInfo, one: Undone, undone: tuple[Undone, ...]
) -> list[ObjectInstance]:
    """All that setting an object back may come to."""
    actions = [other.action for other in undone if other.object_id == one.object_id]
    found = [
        after for action in actions if action in SET_BACK for after in set_back(thing, info, action)
    ]
    return [*found, at_rest(thing, info)] if found or TAKE_AWAY in actions else []


def _with_leaves_as(before: ObjectInstance, now: ObjectInstance, info: AssetInfo) -> ObjectInstance:
    """An object with those leaves of its hollows shut that are shut now."""
    rest = at_rest(before, info).joints
    leaves = {hollow.closed_by for hollow in info.containers}
    joints = {
        name: rest[name] if name in leaves and now.joints.get(name) == rest[name] else value
        for name, value in before.joints.items()
    }
    if joints == before.joints:
        return before
    return settled_states(before.model_copy(update={"joints": joints}), info)


def _shut(after: Mapping[int, ObjectInstance | None], item: SceneItem) -> set[int]:
    """What was changed for the sake of an anomaly of something else."""
    return after.keys() - {one.object_id for one in item.anomalies.undone}


def _without(report: PhysicsReport, put: set[int]) -> PhysicsReport:
    """A report without what was put elsewhere: no file says how that came to rest."""
    drifts = {key: v for key, v in report.settled_drift_m.items() if int(key) not in put}
    contacts = tuple(c for c in report.contacts if put.isdisjoint({c.a, c.b}))
    return report.model_copy(update={"settled_drift_m": drifts, "contacts": contacts})


def _scene_differences(stored: Scene, derived: Scene) -> Iterator[str]:
    if stored != derived:
        yield from differences(_by_id(stored), _by_id(derived))


def _by_id(scene: Scene) -> dict[str, Any]:
    """The scene's fields, its objects by id: a difference names the object, not its place."""
    fields = {name: getattr(scene, name) for name in Scene.model_fields if name != "objects"}
    return {f"object {item.id} ({item.category})": item for item in scene.objects} | fields


def _lookalikes(item: SceneItem) -> list[tuple[int, str]]:
    return [(one.object_id, one.near_miss_of) for one in item.anomalies.lookalikes]
