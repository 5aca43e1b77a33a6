"""The benign twin of a scene: the same ids, cameras and household, its anomalies undone.

What was put there is taken away; what was brought into a state is back at rest, and what stands in
a drawer travels with it. The records alone are enough: an anomaly of a category that its hazard
sets is undone by its object's rest state, every other by leaving its object out. No hazard both
sets and places a category: the catalogue refuses it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from sdgen.actions import at_rest
from sdgen.catalog.records import Catalog, SetRecipe
from sdgen.facts import Measured
from sdgen.geometry import Array
from sdgen.hazards.carried import carried_along, parts_moved
from sdgen.library.records import AssetInfo
from sdgen.scene import Anomaly, ObjectInstance, PhysicsReport, Scene


def undone(
    scene: Scene,
    anomalies: Collection[Anomaly],
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
    known: Measured | None = None,
) -> Scene:
    """The scene with these anomalies undone; its id gets ``-twin`` and ``twin_of`` names it.

    ``known`` are the scene's own facts, where they are at hand: they say what a part that moves
    takes along.
    """
    by_object = {anomaly.object_id: anomaly for anomaly in anomalies}
    gone = {k for k, anomaly in by_object.items() if not _is_state_change(catalog, anomaly)}
    moved = parts_shut(scene, anomalies, catalog, infos)
    carried: Mapping[int, ObjectInstance] = {}
    if moved:
        carried = carried_along(moved, known or Measured(scene, infos))
    objects = []
    for item in scene.objects:
        there = carried.get(item.id, item)
        if item.id not in by_object:
            objects.append(there)
        elif item.id not in gone:
            objects.append(at_rest(there, infos[item.asset]))
    return scene.model_copy(
        update={"id": f"{scene.id}-twin", "twin_of": scene.id, "objects": tuple(objects)}
    )


def parts_shut(
    scene: Scene,
    anomalies: Collection[Anomaly],
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
) -> dict[int, dict[str, Array]]:
    """The parts that undoing moves, by object: none for what is only switched off."""
    changed = {a.object_id for a in anomalies if _is_state_change(catalog, a)}
    out = {}
    for item in scene.objects:
        if item.id in changed:
            info = infos[item.asset]
            parts = parts_moved(item, at_rest(item, info), info)
            if parts:
                out[item.id] = parts
    return out


def physics_of_twin(scene: Scene, report: PhysicsReport) -> PhysicsReport:
    """The report without what the twin has not: it must not tell what was taken away."""
    present = {item.id for item in scene.objects}
    present |= {structure.id for structure in scene.home.structures}
    return report.model_copy(
        update={
            "settled_drift_m": {
                key: value for key, value in report.settled_drift_m.items() if int(key) in present
            },
            "contacts": tuple(c for c in report.contacts if {c.a, c.b} <= present),
            "rejections": (),
            "taken_away": (),
        }
    )


def _is_state_change(catalog: Catalog, anomaly: Anomaly) -> bool:
    recipes = catalog.hazard(anomaly.hazard).anomalies
    return any(
        isinstance(recipe, SetRecipe) and anomaly.category in recipe.categories
        for recipe in recipes
    )
