"""A twin against its scene: what its scene is with the anomalies undone, and nothing else."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

from sdgen.dataset import Dataset
from sdgen.dataset.reader import SceneItem
from sdgen.errors import InputError
from sdgen.hazards.twin import physics_of_twin, undone
from sdgen.scene import Scene
from sdgen.validate.labels import check_scene
from sdgen.validate.problems import SHOWN, Problem, differences


def check_twin(data: Dataset, item: SceneItem) -> Iterator[Problem]:
    """Objects, home, physics and lookalikes of a twin, derived again from its scene.

    Nothing is said where that scene is not sound itself: it is told of there.
    """
    base = _base(data, item)
    if base is None:
        return
    # By the data set's own catalogue: another one says other things of hazards, not of the twin.
    derived = undone(base.scene, base.anomalies.anomalies, data.catalog, data.infos)
    found: dict[str, Iterator[str]] = {
        "scene.json": _scene_differences(item.scene, derived),
        "physics.json": differences(
            item.physics, physics_of_twin(derived, base.physics), "physics"
        ),
        "anomalies.json": differences(_lookalikes(item), _lookalikes(base), "lookalikes"),
    }
    for name, texts in found.items():
        for text in islice(texts, SHOWN):
            path = f"{item.where(name)}: {text.removeprefix('physics.')}"
            yield Problem("scene", f"{path} from {base.id} with its anomalies undone")


def _base(data: Dataset, item: SceneItem) -> SceneItem | None:
    """The scene a twin is of; None where there is none, or none to derive from."""
    entry = next((e for e in data.entries if e.id == item.scene.twin_of), None)
    if entry is None:
        return None
    base = SceneItem(data.path, entry)
    hazards = {hazard.id for hazard in data.catalog.hazards}
    try:
        if any(check_scene(base, data.infos, data.catalog)):
            return None
        sound = all(anomaly.hazard in hazards for anomaly in base.anomalies.anomalies)
        _ = base.physics
    except InputError:
        return None
    return base if sound else None


def _scene_differences(stored: Scene, derived: Scene) -> Iterator[str]:
    if stored != derived:
        yield from differences(_by_id(stored), _by_id(derived))


def _by_id(scene: Scene) -> dict[str, Any]:
    """The scene's fields, its objects by id: a difference names the object, not its place."""
    fields = {name: getattr(scene, name) for name in Scene.model_fields if name != "objects"}
    return {f"object {item.id} ({item.category})": item for item in scene.objects} | fields


def _lookalikes(item: SceneItem) -> list[tuple[int, str]]:
    return [(one.object_id, one.near_miss_of) for one in item.anomalies.lookalikes]
