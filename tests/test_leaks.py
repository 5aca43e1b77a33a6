"""Nothing beside the scene itself tells which object is an anomaly.

Boosted trees get all that must be neutral (ids, order, prefab names, cameras) and try to tell
anomalies from other objects of the same category, in scenes they were not trained on. A planted
leak shows that they would find one. ``SDGEN_LEAK_SCENES`` sets how many scenes are looked at.
"""

from __future__ import annotations

import os
import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pytest
from sdgen.cameras.parts import part_points
from sdgen.catalog.load import load_catalog
from sdgen.geometry import apply, inverse
from sdgen.library import Library
from sdgen.scene import Camera, ObjectInstance
from sdgen.truth.graph import opaque_name
from sklearn.ensemble import HistGradientBoostingClassifier
from threadpoolctl import threadpool_limits

from tests.made import Made, made_scenes
from tests.shared import Shared
from tests.shipped import shipped_library

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

SCENES = int(os.environ.get("SDGEN_LEAK_SCENES", "60"))
LIMIT = 0.55
#: What the oldest children that a class concerns reach (households.yaml: sharp things), metres.
REACHED_M = 1.44
FOLDS, REPEATS = 5, 4
#: Fewer homes than this are too few to keep some apart: then scenes are kept apart.
HOMES_NEEDED = 10

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Table:
    """One row an object: features, whether it is an anomaly, its category, what is kept apart."""

    features: Floats
    anomaly: Bools
    category: npt.NDArray[np.str_]
    group: npt.NDArray[np.str_]


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


@pytest.fixture(scope="module")
def scenes(library: Library, shared: Shared) -> list[Made]:
    return made_scenes(shared, load_catalog(), library, range(SCENES))


def table(scenes: list[Made], row: Callable[[Made, ObjectInstance], list[float] | None]) -> Table:
    """Rows of all objects whose category has anomalies and others; ``row`` may leave one out."""
    rows: list[list[float]] = []
    about: list[tuple[bool, str, str]] = []
    homes = {made.bundle.scene.home.id for made in scenes}
    for made in scenes:
        scene = made.bundle.scene
        group = scene.home.id if len(homes) >= HOMES_NEEDED else scene.id
        anomalies = {a.object_id for a in made.bundle.anomalies.anomalies}
        for item in scene.objects:
            features = row(made, item)
            if features is not None:
                rows.append(features)
                about.append((item.id in anomalies, item.category, group))
    anomaly = np.array([a for a, _, _ in about])
    category = np.array([c for _, c, _ in about])
    both = set(category[anomaly]) & set(category[~anomaly])
    kept = np.isin(category, sorted(both))
    group_of = np.array([g for _, _, g in about])
    return Table(np.array(rows)[kept], anomaly[kept], category[kept], group_of[kept])


def auc(scores: Floats, anomaly: Bools) -> float:
    """Chance that an anomaly scores above another object; ties count half."""
    above = scores[anomaly][:, None] - scores[~anomaly][None, :]
    return float((above > 0).mean() + 0.5 * (above == 0).mean())


def probe(data: Table) -> tuple[float, float]:
    """AUC within categories of boosted trees on unseen groups, and its noise (one sigma).

    Categories count by how much they can tell, n+ n- / (n+ + n-). The AUC is the mean over
    several divisions into folds, which takes the luck of one away.
    """
    weight = np.zeros(len(data.anomaly))
    tell: dict[str, float] = {}
    for name in sorted(set(data.category)):
        here = data.category == name
        yes, no = here & data.anomaly, here & ~data.anomaly
        tell[name] = yes.sum() * no.sum() / here.sum()
        weight[yes], weight[no] = tell[name] / yes.sum(), tell[name] / no.sum()
    groups = np.unique(data.group)
    values = []
    for repeat in range(REPEATS):
        rng = np.random.default_rng(repeat)
        fold_of = dict(zip(groups, rng.permutation(len(groups)) % FOLDS, strict=True))
        fold = np.array([fold_of[g] for g in data.group])
        scores = np.zeros(len(fold))
        for k in range(FOLDS):
            trees = HistGradientBoostingClassifier(
                max_iter=40, max_depth=4, min_samples_leaf=10, max_bins=63, random_state=repeat
            )
            train = fold != k
            with threadpool_limits(1):  # small data: threads would only wait for each other
                trees.fit(data.features[train], data.anomaly[train], weight[train])
            scores[~train] = trees.predict_proba(data.features[~train])[:, 1]
        # A model's level differs from fold to fold: only pairs of the same fold are compared.
        pairs = []
        for name in tell:
            for k in range(FOLDS):
                here = (data.category == name) & (fold == k)
                yes, no = (here & data.anomaly).sum(), (here & ~data.anomaly).sum()
                if yes and no:
                    value = auc(scores[here], data.anomaly[here])
                    pairs.append((value, yes * no / (yes + no)))
        values.append(float(np.average([v for v, _ in pairs], weights=[w for _, w in pairs])))
    return float(np.mean(values)), float((12 * sum(tell.values())) ** -0.5)


def poses(cameras: tuple[Camera, ...]) -> Floats:
    """Where cameras are and where they look, (N, 6)."""
    matrices = np.array([camera.world_from_camera for camera in cameras])
    return np.concatenate([matrices[:, :3, 3], matrices[:, :3, 2]], axis=1)


def records_row(made: Made, item: ObjectInstance, ids: dict[int, int] | None = None) -> list[float]:
    """All that must be neutral: ids, order, prefab, number of views, cameras as they come and
    sorted."""
    scene, cameras = made.bundle.scene, made.bundle.cameras
    renamed = ids or {}
    order = sorted(renamed.get(other.id, other.id) for other in scene.objects)
    own = renamed.get(item.id, item.id)
    rank = order.index(own)
    gaps = np.diff([0, *order, 65536])
    prefab = int(opaque_name(item.asset)[-8:], 16)
    where = poses(cameras)
    ordered = where[np.lexsort(where.T)]
    near = sum(camera.kind == "near" for camera in cameras)
    return [
        *(own, rank, rank / len(order), gaps[rank], gaps[rank + 1], len(order)),
        *(prefab, zlib.crc32(item.category.encode()), len(cameras), near),
        *where.ravel(),
        *ordered.ravel(),
    ]


def planted_row(made: Made, item: ObjectInstance) -> list[float]:
    """The same, if anomalies had been numbered first."""
    anomalies = {a.object_id for a in made.bundle.anomalies.anomalies}
    every = sorted(other.id for other in made.bundle.scene.objects)
    first = sorted(every, key=lambda object_id: (object_id not in anomalies, object_id))
    return records_row(made, item, dict(zip(first, every, strict=True)))


def test_records_do_not_tell_anomalies_from_others_of_their_category(scenes: list[Made]) -> None:
    value, noise = probe(table(scenes, records_row))
    assert noise < 0.05
    assert value <= LIMIT, f"AUC {value:.3f} (noise {noise:.3f})"


def test_a_planted_leak_is_found(scenes: list[Made]) -> None:
    assert probe(table(scenes, planted_row))[0] > 0.8


def picture_row(made: Made, item: ObjectInstance, library: Library) -> list[float] | None:
    """All that pictures tell of a thing without what it is: where it is in the best picture of it,
    how large, how far away, in how many. None for what no view shows."""
    counts = made.pixels.get(item.id)
    if counts is None:
        return None
    best = int(np.argmax(counts))
    camera = made.bundle.cameras[best]
    points = part_points(library, item, ())
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    x, y, z = apply(inverse(np.asarray(camera.world_from_camera)), centre[None])[0].tolist()
    return [
        zlib.crc32(item.category.encode()),
        *(float(np.hypot(x, y)) / max(z, 1e-9), abs(x / z), z),
        *(counts[best], float(sum(n > 0 for n in counts)), best, camera.kind == "near"),
    ]


def against_lookalikes(scenes: list[Made]) -> dict[str, set[int]]:
    """Anomalies and near misses of each scene, by its id."""
    return {
        made.bundle.scene.id: {
            one.object_id
            for one in (*made.bundle.anomalies.anomalies, *made.bundle.anomalies.lookalikes)
        }
        for made in scenes
    }


@pytest.mark.parametrize("near_misses", [True, False])
def test_pictures_do_not_tell_anomalies_by_where_they_are_in_them(
    scenes: list[Made], library: Library, near_misses: bool
) -> None:
    """Against lookalikes, and against all small things of the same categories, that lie as low as
    labels of what children reach: higher ones are no label by definition, and seen from below.

    Of four times 200 scenes (seeds 4022, 4023) the AUC was 0.56 to 0.62 against such near misses,
    0.60 to 0.70 against all. Things of a class are few in so many scenes: two sigmas of the
    probe's noise are granted.
    """
    marked, limit = against_lookalikes(scenes), 0.60

    def row(made: Made, item: ObjectInstance) -> list[float] | None:
        if item.fixed or (near_misses and item.id not in marked[made.bundle.scene.id]):
            return None
        if item.pose.position_m[2] > REACHED_M:
            return None
        return picture_row(made, item, library)

    value, noise = probe(table(scenes, row))
    assert value <= limit + 2 * noise, f"AUC {value:.3f} (noise {noise:.3f})"


def test_a_view_aimed_at_anomalies_is_found_out(scenes: list[Made], library: Library) -> None:
    """The same probe, had a view each been turned towards them."""
    marked = [{a.object_id for a in made.bundle.anomalies.anomalies} for made in scenes]
    by_scene = {made.bundle.scene.id: m for made, m in zip(scenes, marked, strict=True)}

    def row(made: Made, item: ObjectInstance) -> list[float] | None:
        found = None if item.fixed else picture_row(made, item, library)
        if found is not None and item.id in by_scene[made.bundle.scene.id]:
            found[1:3] = [value / 4 for value in found[1:3]]
        return found

    assert probe(table(scenes, row))[0] > 0.75


def test_views_are_as_many_and_of_the_same_kinds_in_every_scene(scenes: list[Made]) -> None:
    kinds = {tuple(sorted(c.kind for c in made.bundle.cameras)) for made in scenes}
    assert kinds == {("near",) * 5 + ("room",) * 3}


def test_most_of_what_could_be_an_anomaly_is_seen(scenes: list[Made]) -> None:
    """Everyday things of the same categories that are not shut away, as anomalies always are."""
    anomalies = {
        (made.bundle.scene.id, a.object_id)
        for made in scenes
        for a in made.bundle.anomalies.anomalies
    }
    categories = {
        made.bundle.scene.object(k).category
        for made in scenes
        for i, k in anomalies
        if i == made.bundle.scene.id
    }
    seen = []
    for made in scenes:
        shut = {item.id for item in made.bundle.scene.objects if "CLOSED" in item.states}
        inside = {
            e.from_id
            for e in made.bundle.graph.edges
            if e.relation_type == "INSIDE" and e.to_id in shut
        }
        seen += [
            item.id in made.pixels
            for item in made.bundle.scene.objects
            if not item.fixed
            and item.category in categories
            and item.id not in inside
            and (made.bundle.scene.id, item.id) not in anomalies
        ]
    # Homes are full: eight views show two thirds of what stands about in six rooms or more.
    assert np.mean(seen) >= 0.65
