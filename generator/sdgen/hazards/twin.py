"""The benign twin of a scene: the same ids, cameras and household, its anomalies undone.

What was put there is taken away; what was brought into a state is back at rest. The records alone
are enough: an anomaly whose hazard changes states (it has no relation) is undone by its object's
rest state, every other by leaving its object out.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from sdgen.actions import at_rest
from sdgen.catalog.records import Catalog, SetRecipe
from sdgen.library.records import AssetInfo
from sdgen.scene import Anomaly, PhysicsReport, Scene


def undone(
    scene: Scene,
    anomalies: Collection[Anomaly],
    catalog: Catalog,
    infos: Mapping[str, AssetInfo],
) -> Scene:
    """The scene with these anomalies undone; its id gets ``-twin`` and ``twin_of`` names it."""
    by_object = {anomaly.object_id: anomaly for anomaly in anomalies}
    objects = []
    for item in scene.objects:
        anomaly = by_object.get(item.id)
        if anomaly is None:
            objects.append(item)
        elif _is_state_change(catalog, anomaly):
            objects.append(at_rest(item, infos[item.asset]))
    return scene.model_copy(
        update={"id": f"{scene.id}-twin", "twin_of": scene.id, "objects": tuple(objects)}
    )


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
