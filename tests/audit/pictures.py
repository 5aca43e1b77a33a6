"""What the masks show against ``visibility.json``."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from PIL import Image

from tests.audit.dataset import Finding, Scene

NEEDED_AT_VGA = 100
#: So many views a home (what `sdgen build` takes) show every label.
PROMISED_VIEWS = 8


def visibility(scene: Scene) -> Iterator[Finding]:
    """Boxes and pixels of every object in every view, and the pixels that show each label."""
    evidence: dict[str, list[int]] = {a["id"]: [] for a in scene.labels["anomalies"]}
    told = {view["view"]: view["objects"] for view in scene.visibility["views"]}
    size = 640 * 480
    for number, file in enumerate(scene.view_files):
        if not (file.parent / "instance.png").exists():
            return
        ids = np.array(Image.open(file.parent / "instance.png")).astype(np.int64)
        parts = np.array(Image.open(file.parent / "part.png")).astype(np.int64)
        size = ids.size
        pairs, counts = np.unique(ids * 256 + parts, return_counts=True)
        pixels: dict[int, int] = {}
        for pair, count in zip(pairs.tolist(), counts.tolist(), strict=True):
            pixels[pair // 256] = pixels.get(pair // 256, 0) + count
        for record in told.get(number, []):
            id = record["object_id"]
            if pixels.get(id, 0) != record["pixels"]:
                what = f"view {number}: {record['pixels']} pixels told"
                yield scene.found(scene.things[id], what, pixels.get(id, 0))
                continue
            ys, xs = np.nonzero(ids == id) if record["pixels"] < 2000 else ([], [])
            if len(ys):
                box = [xs.min(), ys.min(), np.ptp(xs) + 1, np.ptp(ys) + 1]
                if [int(side) for side in box] != record["bbox"]:
                    yield scene.found(scene.things[id], f"view {number}: box is not its mask's")
        listed = {record["object_id"] for record in told.get(number, [])}
        for id in set(pixels) & scene.things.keys() - listed:
            yield scene.found(scene.things[id], f"view {number}: seen and not listed", pixels[id])
        count_of = dict(zip(pairs.tolist(), counts.tolist(), strict=True))
        for label in scene.labels["anomalies"]:
            names = scene.things[label["object_id"]].json["parts"]
            evidence[label["id"]].append(
                sum(
                    count_of.get(label["object_id"] * 256 + names.index(part) + 1, 0)
                    for part in label["evidence_parts"]
                )
            )
    needed = NEEDED_AT_VGA * size / (640 * 480)
    for label in scene.labels["anomalies"]:
        shown = max(evidence[label["id"]], default=0)
        # With fewer views than the promise is made for, the file says so.
        promised = scene.visibility["all_visible"] or len(scene.view_files) >= PROMISED_VIEWS
        if shown < needed and promised:
            yield scene.found(scene.things[label["object_id"]], "label not shown", shown)
