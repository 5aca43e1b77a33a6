"""How what is in a data set is spread: counts by name, and numbers in bins."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from sdgen.dataset.derived import derived_from
from sdgen.dataset.item import SceneItem
from sdgen.dataset.reader import Dataset
from sdgen.scene import Record

#: No number of ours is as large: the end of a last bin.
ENDLESS = 10.0**9
#: Distribution of numbers -> its title and where its bins begin and end.
NUMBERS: Mapping[str, tuple[str, tuple[float, ...]]] = {
    "objects_per_scene": ("objects a scene", tuple(range(0, 601, 50))),
    "rooms_per_home": ("rooms a home", tuple(range(1, 14))),
    "floor_area_m2": ("floor of a home, m²", tuple(range(0, 261, 20))),
    "size_m": ("largest side of a loose thing, m", (0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1, 2, 4)),
    "height_m": (
        "height at which a loose thing stands, m",
        (0, 0.01, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 4),
    ),
    "anomaly_height_m": (
        "height at which an anomaly stands, m",
        (0, 0.01, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 4),
    ),
    "evidence_pixels": (
        "pixels of an anomaly's evidence in its best view",
        (0, 1, 100, 200, 400, 800, 1600, 3200, 6400, 12800, ENDLESS),
    ),
    "visible_fraction": (
        "part of an anomaly that its best view shows",
        (0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0001),
    ),
    "views_of_an_anomaly": ("views that show an anomaly", tuple(range(0, 14))),
    "drift_mm": (
        "how far a thing moved as it settled, mm",
        (0, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30),
    ),
}
#: Distribution over names -> its title.
NAMES: Mapping[str, str] = {
    "anomalies_by_hazard": "anomalies by hazard",
    "anomalies_by_room": "anomalies by room",
    "anomalies_by_notify": "anomalies by what this household wants",
    "lookalikes_by_hazard": "lookalikes by the hazard they are not",
    "rooms_by_type": "rooms by type",
    "scenes_by_household": "scenes by household",
}


class Spread(Record):
    """Numbers in bins: ``counts[k]`` of ``edges[k]`` <= x < ``edges[k + 1]``; those beyond the ends
    are counted in the first and the last. None where there are no numbers."""

    title: str
    n: int
    minimum: float | None
    median: float | None
    mean: float | None
    maximum: float | None
    edges: tuple[float, ...]
    counts: tuple[int, ...]


class Tally(Record):
    """Counts by name, most first."""

    title: str
    counts: dict[str, int]


class Distributions(Record):
    """All distributions of a data set, by name."""

    names: dict[str, Tally]
    numbers: dict[str, Spread]


@dataclass
class _Sums:
    names: dict[str, Counter[str]] = field(
        default_factory=lambda: {name: Counter() for name in NAMES}
    )
    numbers: dict[str, list[float]] = field(default_factory=lambda: {name: [] for name in NUMBERS})


def distributions(
    data: Dataset, on_scene: Callable[[int, int], None] | None = None
) -> Distributions:
    """Distributions over the scenes of ``data`` (its twins only if it is opened for them), from
    their files; no pixel is read. Raises InputError for files that are missing or disagree."""
    sums = _Sums()
    for done, item in enumerate(data, start=1):
        with derived_from(data, item):
            _names(item, sums.names)
            for name, value in _numbers(data, item):
                sums.numbers[name].append(value)
        if on_scene is not None:
            on_scene(done, len(data))
    return Distributions(
        names={
            name: Tally(title=NAMES[name], counts=dict(counted.most_common()))
            for name, counted in sums.names.items()
        },
        numbers={name: _spread(name, values) for name, values in sums.numbers.items()},
    )


def _names(item: SceneItem, into: Mapping[str, Counter[str]]) -> None:
    rooms = {room.id: room.type for room in item.scene.home.rooms}
    into["rooms_by_type"].update(rooms.values())
    into["scenes_by_household"][item.household.template] += 1
    for anomaly in item.anomalies.anomalies:
        into["anomalies_by_hazard"][anomaly.hazard] += 1
        into["anomalies_by_room"][rooms[anomaly.room_id]] += 1
        into["anomalies_by_notify"][anomaly.notify] += 1
    into["lookalikes_by_hazard"].update(near.near_miss_of for near in item.anomalies.lookalikes)


def _numbers(data: Dataset, item: SceneItem) -> Iterator[tuple[str, float]]:
    scene = item.scene
    yield "objects_per_scene", len(scene.objects)
    yield "rooms_per_home", len(scene.home.rooms)
    yield "floor_area_m2", sum(_area(room.polygon_m) for room in scene.home.rooms)
    wrong = {anomaly.object_id for anomaly in item.anomalies.anomalies}
    for thing in scene.objects:
        if not thing.fixed:
            yield "size_m", max(data.infos[thing.asset].extents_m)
            yield "height_m", thing.pose.position_m[2]
        if thing.id in wrong:
            yield "anomaly_height_m", thing.pose.position_m[2]
    for drift in item.physics.settled_drift_m.values():
        yield "drift_mm", 1000 * drift
    if not item.visibility.views:
        return
    fractions = {
        (view.view, seen.object_id): seen.fraction
        for view in item.visibility.views
        for seen in view.objects
    }
    for shown in item.visibility.anomalies:
        most = max(shown.evidence_pixels, default=0)
        yield "evidence_pixels", most
        yield "views_of_an_anomaly", sum(pixels > 0 for pixels in shown.evidence_pixels)
        if most:
            best = shown.evidence_pixels.index(most)
            yield "visible_fraction", fractions.get((best, shown.object_id), 0.0)


def _area(polygon: tuple[tuple[float, float], ...]) -> float:
    x, y = np.asarray(polygon, dtype=float).T
    return float(abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2)


def _spread(name: str, numbers: list[float]) -> Spread:
    title, edges = NUMBERS[name]
    values = np.asarray(numbers, dtype=float)
    # Whatever lies beyond the ends belongs to the first and the last bin.
    inside = np.clip(values, edges[0], np.nextafter(edges[-1], edges[0]))
    counts, _ = np.histogram(inside, edges)
    told = (
        {
            "minimum": round(float(values.min()), 4),
            "median": round(float(np.median(values)), 4),
            "mean": round(float(values.mean()), 4),
            "maximum": round(float(values.max()), 4),
        }
        if len(values)
        else dict.fromkeys(("minimum", "median", "mean", "maximum"))
    )
    return Spread(title=title, n=len(values), edges=edges, counts=tuple(counts.tolist()), **told)
