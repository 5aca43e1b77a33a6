"""What the masks show against ``visibility.json``."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from PIL import Image

from tests.audit.dataset import Finding, Json, Scene

NEEDED_AT_VGA = 100
#: What people look for in a picture to call a thing hazardous, where its models have such a part,
#: and so many of its pixels at 640 x 480: a handle alone is no knife, wax alone no fire.
SHOWN_BY = {"candle_on": ({"flame"}, 20), "sharp_object": ({"blade", "blades"}, 15)}
#: So many views a home (what `sdgen build` takes) show every label.
PROMISED_VIEWS = 8


def telling(label: Json, names: list[str]) -> tuple[list[str], int]:
    """The drawn parts that show a label, and how many of their pixels at 640 x 480 do."""
    parts, least = SHOWN_BY.get(label["hazard"], (set(), 0))
    here = [name for name in names if name in parts]
    return (here, least) if here else (label["evidence_parts"], NEEDED_AT_VGA)


def visibility(scene: Scene) -> Iterator[Finding]:
    """Boxes and pixels of every object in every view, and the pixels that show each label."""
    evidence: dict[str, list[tuple[int, int]]] = {a["id"]: [] for a in scene.labels["anomalies"]}
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
            id = label["object_id"]
            names = scene.things[id].json["parts"]
            wanted, _ = telling(label, names)
            of_parts = sum(count_of.get(id * 256 + names.index(part) + 1, 0) for part in wanted)
            evidence[label["id"]].append((of_parts, pixels.get(id, 0)))
    share = size / (640 * 480)
    for label in scene.labels["anomalies"]:
        _, least = telling(label, scene.things[label["object_id"]].json["parts"])
        large = [seen for seen in evidence[label["id"]] if seen[1] >= NEEDED_AT_VGA * share]
        shown = max((of_parts for of_parts, _ in large), default=0)
        # With fewer views than the promise is made for, the file says so.
        promised = scene.visibility["all_visible"] or len(scene.view_files) >= PROMISED_VIEWS
        if shown < least * share and promised:
            yield scene.found(scene.things[label["object_id"]], "label not shown", shown)
