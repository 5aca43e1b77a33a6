"""A scene with anomalies undone: the same ids, cameras and household, all else as it was.

:func:`undone` is the plain way, which always works: what was put there is taken away, what was
brought into a state is back at rest. ``remedies`` knows the better one, which puts things where
they belong. In both what stands in a drawer that is shut travels with it, and the records alone
say what else may differ.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from types import MappingProxyType

from sdgen.actions import at_rest, settled_states
from sdgen.catalog.records import Catalog, SetRecipe
from sdgen.facts import Measured
from sdgen.hazards.carried import carried_along, parts_moved
from sdgen.library.records import AssetInfo
from sdgen.scene import (
    Anomaly,
    Contact,
    ObjectInstance,
    PhysicsReport,
    Scene,
    Undone,
    twin_id,
)

#: What is done where no remedy can be carried out.
TAKE_AWAY = "take_away"
#: Actions that bring the very object back to rest where it stands, those after which it is gone,
#: and those that put it somewhere (``move_away``: on a floor).
SET_BACK = ("close", "switch_off", "put_out", "empty")
GONE = ("wipe_up", "sweep_up")
PUT: Mapping[str, str] = {
    "put_in": "INSIDE",
    "put_on": "ON",
    "throw_away": "INSIDE",
    "move_away": "ON",
}

#: Objects as they are after something was done, by id; None: gone.
After = Mapping[int, ObjectInstance | None]


def undone(
    scene: Scene,
    anomalies: Collection[Anomaly],
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    known: Measured | None = None,
) -> Scene:
    """The scene with these anomalies undone the plain way; its id gets ``-twin`` and ``twin_of``
    names it.

    ``known`` are the scene's own facts, where they are at hand: they say what a part that moves
    takes along.
    """
    after = plainly(scene, anomalies, catalog, infos)
    objects = with_changes(scene, after, infos, known)
    return scene.model_copy(
        update={"id": twin_id(scene.id), "twin_of": scene.id, "objects": objects}
    )


def plainly(
    scene: Scene,
    anomalies: Iterable[Anomaly],
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
) -> dict[int, ObjectInstance | None]:
    """What becomes of the objects of these anomalies the plain way."""
    by_object: dict[int, list[Anomaly]] = {}
    for anomaly in anomalies:
        by_object.setdefault(anomaly.object_id, []).append(anomaly)
    return {
        item.id: at_rest(item, infos[item.asset])
        if _was_there(item, by_object[item.id], catalog)
        else None
        for item in scene.objects
        if item.id in by_object
    }


def plain_records(
    anomalies: Iterable[Anomaly], after: After, catalog: Catalog
) -> tuple[Undone, ...]:
    """What became of anomalies that were undone the plain way."""
    return tuple(
        Undone(
            anomaly_id=one.id,
            hazard=one.hazard,
            object_id=one.object_id,
            action=_plain_action(one, after.get(one.object_id) is None, catalog),
            removed=after.get(one.object_id) is None,
        )
        for one in sorted(anomalies, key=lambda one: one.id)
    )


def _plain_action(anomaly: Anomaly, removed: bool, catalog: Catalog) -> str:
    words = (*GONE, "throw_away") if removed else SET_BACK
    actions = (rule.action for rule in catalog.hazard(anomaly.hazard).remedy)
    return next((action for action in actions if action in words), TAKE_AWAY)


def with_changes(
    scene: Scene, after: After, infos: Mapping[str, AssetInfo], known: Measured | None = None
) -> tuple[ObjectInstance, ...]:
    """The objects of a scene with these changed or gone, and with what their moved parts carry.

    What is put elsewhere takes nothing along, and goes along with nothing. ``known`` are the
    scene's own facts.
    """
    moved = {}
    for item in scene.objects:
        changed = after.get(item.id)
        if changed is not None and changed.pose == item.pose:
            parts = parts_moved(item, changed, infos[item.asset])
            if parts:
                moved[item.id] = parts
    carried: Mapping[int, ObjectInstance] = {}
    if moved:
        carried = carried_along(moved, known or Measured(scene, infos))
    objects = []
    for item in scene.objects:
        there = carried.get(item.id, item)
        if item.id not in after:
            objects.append(there)
            continue
        changed = after[item.id]
        if changed is not None and changed.pose == item.pose and there is not item:
            changed = changed.model_copy(update={"pose": there.pose, "room_id": there.room_id})
        if changed is not None:
            objects.append(changed)
    return tuple(objects)


def set_back(item: ObjectInstance, info: AssetInfo, action: str) -> tuple[ObjectInstance, ...]:
    """What may come of setting an object back, the least change first: its joints shut
    (``close``), or its variant the default one (the other actions); then both. Nothing where it is
    so already."""
    rest = at_rest(item, info)
    kept = {"variant": item.variant} if action == "close" else {"joints": item.joints}
    least = settled_states(rest.model_copy(update=kept), info)
    found = (least,) if least == rest else (least, rest)
    return tuple(one for one in found if one != item)


def physics_of_twin(
    scene: Scene,
    report: PhysicsReport,
    drift_m: Mapping[int, float] = MappingProxyType({}),
    contacts: Iterable[Contact] = (),
) -> PhysicsReport:
    """The report without what the twin has not: it must not tell what was taken away.

    ``drift_m`` and ``contacts`` are of what a remedy put elsewhere, in place of what it touched.
    """
    present = {item.id for item in scene.objects}
    present |= {structure.id for structure in scene.home.structures}
    drifts = {k: v for k, v in report.settled_drift_m.items() if int(k) in present}
    drifts |= {str(key): round(value, 5) for key, value in drift_m.items()}
    touching = [
        c
        for c in report.contacts
        if {c.a, c.b} <= present and drift_m.keys().isdisjoint({c.a, c.b})
    ]
    touching += contacts
    return report.model_copy(
        update={
            "settled_drift_m": dict(sorted(drifts.items(), key=lambda one: int(one[0]))),
            "contacts": tuple(sorted(touching, key=lambda c: (c.a, c.b))),
            "rejections": (),
            "taken_away": (),
        }
    )


def _was_there(item: ObjectInstance, anomalies: Sequence[Anomaly], catalog: Catalog) -> bool:
    """Whether an anomaly's object is of the home, brought into a state: furniture is, and what
    the drawn hazard (of the others it merely satisfies the predicate) sets."""
    if item.fixed and catalog.category(item.category).kind != "hazard_only":
        return True
    drawn = [one for one in anomalies if one.drawn] or anomalies
    return any(
        isinstance(recipe, SetRecipe) and one.category in recipe.categories
        for one in drawn
        for recipe in catalog.hazard(one.hazard).anomalies
    )
