"""What the views of a data set show, and whether how things show tells which are anomalies.

Run: ``python benchmarks/views.py DATASET``. Boosted trees (those of ``tests/test_leaks.py``) get of
each thing what pictures tell without what it is: where in its best picture it is, how large, how
far, in how many views and of which kind; and try to tell anomalies from near misses, and from
everyday things of their categories, in homes that they were not trained on. How high a thing stands
tells by definition: what is in a child's reach is low. So beside what pictures tell there is what
its height alone does, and what both do: more than height is what pictures add. Prints Markdown.
"""

from __future__ import annotations

import sys
import zlib
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from sdgen import Dataset
from sdgen.dataset import SceneItem

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from tests.test_leaks import Table, probe

#: A thing shows when it has so many pixels of 640x480.
LEAST_PIXELS = 100


class Thing(NamedTuple):
    """A thing of a scene: ``anomaly``, ``lookalike`` or ``other``; what its best picture tells."""

    kind: str
    category: str
    home: str
    views: int
    features: tuple[float, ...]
    height_m: float


def things(item: SceneItem) -> Iterator[Thing]:
    """All things of a scene; those without features show in no view."""
    scene, cameras = item.scene, item.cameras
    kinds = {one.object_id: "lookalike" for one in item.anomalies.lookalikes}
    kinds |= {one.object_id: "anomaly" for one in item.anomalies.anomalies}
    seen: dict[int, list[tuple[int, int, tuple[int, ...]]]] = {}
    for view in item.visibility.views:
        for one in view.objects:
            if one.pixels >= LEAST_PIXELS:
                seen.setdefault(one.object_id, []).append((one.pixels, view.view, tuple(one.bbox)))
    for thing in scene.objects:
        shown = seen.get(thing.id, [])
        features: tuple[float, ...] = ()
        if shown:
            pixels, best, (left, _, wide, _) = max(shown)
            camera = cameras[best]
            k = np.asarray(camera.K)
            aside = abs(left + wide / 2 - k[0, 2]) / k[0, 0]
            eye = np.asarray(camera.world_from_camera)[:3, 3]
            far = float(np.linalg.norm(eye - np.asarray(thing.pose.position_m)))
            near = camera.kind == "near"
            features = (zlib.crc32(thing.category.encode()), aside, pixels, far, len(shown), near)
        kind = kinds.get(thing.id, "other")
        yield Thing(
            kind, thing.category, scene.home.id, len(shown), features, thing.pose.position_m[2]
        )


def auc(rows: Sequence[Thing], against: str, columns: str) -> tuple[float, float]:
    """How well trees tell anomalies from the others by these columns, and the noise."""
    some = [row for row in rows if row.features and row.kind in ("anomaly", against)]
    anomalies = {row.category for row in some if row.kind == "anomaly"}
    both = anomalies & {row.category for row in some if row.kind != "anomaly"}
    some = [row for row in some if row.category in both]
    values = {
        "pictures": [row.features for row in some],
        "height": [(row.features[0], row.height_m) for row in some],
        "both": [(*row.features, row.height_m) for row in some],
    }[columns]
    anomaly = np.array([row.kind == "anomaly" for row in some])
    category = np.array([row.category for row in some])
    return probe(
        Table(np.array(values, float), anomaly, category, np.array([r.home for r in some]))
    )


def main() -> None:
    """Print it."""
    items = [item for item in Dataset(Path(sys.argv[1])) if item.scene.twin_of is None]
    rows = [thing for item in items for thing in things(item)]
    labelled = {row.category for row in rows if row.kind != "other"}
    print(f"{len(items)} scenes, {len(rows)} things\n\n| things | how many | show | views each |")
    print("|---|---|---|---|")
    for kind in ("anomaly", "lookalike", "other"):
        some = [r for r in rows if r.kind == kind and (kind != "other" or r.category in labelled)]
        shown = [row for row in some if row.features]
        views = sum(row.views for row in shown) / max(1, len(shown))
        print(f"| {kind} | {len(some)} | {len(shown) / max(1, len(some)):.1%} | {views:.2f} |")
    print("\n| told from anomalies | by pictures | by its height alone | by both |")
    print("|---|---|---|---|")
    for against in ("lookalike", "other"):
        found = [auc(rows, against, columns) for columns in ("pictures", "height", "both")]
        print(f"| {against} | " + " | ".join(f"{a:.2f} ± {n:.2f}" for a, n in found) + " |")
    kinds = Counter(c.kind for item in items for c in item.cameras)
    print(f"\nviews: {dict(kinds)}")


if __name__ == "__main__":
    main()
