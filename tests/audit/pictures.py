"""What the masks show against ``visibility.json``."""

from __future__ import annotations

import json
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
from PIL import Image

from tests.audit.dataset import Finding, Json, Scene

NEEDED_AT_VGA = 100
#: What people look for in a picture to call a thing hazardous, where its models have such a part,
#: and so many of its pixels at 640 x 480: a handle alone is no knife, wax alone no fire.
SHOWN_BY = {"candle_on": ({"flame"}, 20), "sharp_object": ({"blade", "blades"}, 15)}
#: A door's leaf shows when it is shut, too: what shows that it is open is the outdoors within the
#: doorway, so many pixels of it at 640 x 480.
SEEN_THROUGH = {"front_door_open": 500}
#: Of each row of such a picture, as many beside each other: nobody sees thinner strips.
STRIP_AT_VGA = 6
#: So many views a home (what `sdgen build` takes) show every label.
PROMISED_VIEWS = 8


def telling(mark: Json, names: list[str]) -> tuple[list[str], int]:
    """The drawn parts that show a label or a near miss, and how many of their pixels at 640 x 480
    do."""
    parts, least = SHOWN_BY.get(mark.get("hazard") or mark["near_miss_of"], (set(), 0))
    here = [name for name in names if name in parts]
    return (here, least) if here else (mark.get("evidence_parts", names), NEEDED_AT_VGA)


def outdoors(scene: Scene, id: int, view: Json, ids: npt.NDArray[np.int64]) -> int:
    """Pixels of nothing within the doorway that a door fills, strips thinner than people see left
    out: within the outline that the middle of its wall has in the picture."""
    gap = next(o for o in scene.scene["home"]["openings"] if o["object_id"] == id)
    middle = np.array(gap["center_m"])
    across = np.array([1.0, 0.0, 0.0] if gap["along"] == "x" else [0.0, 1.0, 0.0])
    sides = (across * gap["width_m"] / 2, np.array([0.0, 0.0, gap["height_m"]]))
    pose, k = np.array(view["world_from_camera"]), np.array(view["K"])
    low = middle - sides[0]
    # The plane's own axes as the camera has them: one 3 x 3 system for all pixels.
    plane = np.column_stack([2 * sides[0], sides[1], low - pose[:3, 3]])
    to_plane = np.linalg.inv(k @ pose[:3, :3].T @ plane)
    ys, xs = np.nonzero(ids == 0)
    a, b, c = to_plane @ np.stack([xs, ys, np.ones(len(xs))])
    share = np.stack([a / c, b / c])
    # Depth along a pixel's ray is 1 / c: before the camera where it is positive.
    beyond = np.zeros(ids.shape, dtype=bool)
    beyond[ys, xs] = ((share >= 0) & (share <= 1)).all(axis=0) & (c > 0)
    total = 0
    for row in beyond[beyond.any(axis=1)]:
        # Lengths of what lies between pixels that are none.
        strips = np.diff(np.flatnonzero(np.concatenate([[True], ~row, [True]]))) - 1
        total += int(strips[strips >= STRIP_AT_VGA * ids.shape[1] / 640].sum())
    return total


def visibility(scene: Scene) -> Iterator[Finding]:
    """Boxes and pixels of every object in every view, and the pixels that show each label and
    each near miss."""
    marks = [*scene.labels["anomalies"], *scene.labels["lookalikes"]]
    evidence: list[list[tuple[int, int, int]]] = [[] for _ in marks]
    told = {view["view"]: view["objects"] for view in scene.visibility["views"]}
    through = {view["view"]: view.get("outdoors") for view in scene.visibility["views"]}
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
        for mark, seen in zip(marks, evidence, strict=True):
            id = mark["object_id"]
            names = scene.things[id].json["parts"]
            wanted, _ = telling(mark, names)
            of_parts = sum(count_of.get(id * 256 + names.index(part) + 1, 0) for part in wanted)
            # Near misses of an open front door are other leaves.
            least_outdoors = SEEN_THROUGH.get(mark.get("hazard", ""))
            beyond = 0
            if least_outdoors is not None:
                beyond = outdoors(scene, id, json.loads(file.read_text("utf-8")), ids)
                # Older data sets do not tell.
                stated = through.get(number)
                written = beyond if stated is None else stated.get(str(id), 0)
                if abs(beyond - written) > 2:
                    what = f"view {number}: {written} pixels of outdoors told"
                    yield scene.found(scene.things[id], what, beyond)
            seen.append((of_parts, pixels.get(id, 0), beyond))
    share = size / (640 * 480)
    for mark, seen in zip(marks, evidence, strict=True):
        thing = scene.things[mark["object_id"]]
        _, least = telling(mark, thing.json["parts"])
        least_outdoors = SEEN_THROUGH.get(mark.get("hazard", ""), 0) * share
        large = [one for one in seen if one[1] >= NEEDED_AT_VGA * share]
        shown = max((one[0] for one in large if one[2] >= least_outdoors), default=0)
        # With fewer views than the promise is made for, the file says so of labels.
        promised = len(scene.view_files) >= PROMISED_VIEWS
        promised |= "hazard" in mark and scene.visibility["all_visible"]
        if shown < least * share and promised:
            what = "label not shown" if "hazard" in mark else "near miss not shown"
            yield scene.found(thing, what, shown)
