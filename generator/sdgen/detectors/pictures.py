"""Crops of what the views show: things without a name, as a camera has them.

A crop is a square around a thing's mask, with what is beside it, and the mask as a fourth channel.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from PIL import Image

from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.examples import Ints, Progress, hazards_of, train_split
from sdgen.errors import InputError
from sdgen.seeding import lane

Bytes = npt.NDArray[np.uint8]
Floats = npt.NDArray[np.float32]

#: Pixels of a crop's side, and how much larger than the thing's box it is.
SIDE = 64
CONTEXT = 1.8
#: A crop has at least this side, pixels of a picture 640 wide, so that little things are not all
#: blur.
LEAST_SIDE = 28
#: Things with fewer pixels than this in a view, of a picture 640 x 480, are not looked at there.
LEAST_PIXELS = 16
#: Views that are looked at of a thing, those that show most of it: to learn, and to tell.
LEARN_VIEWS, TELL_VIEWS = 2, 3
#: Things nothing is wrong with that are kept of a scene, and of its twin.
KEPT_EASY = 20
#: Where in its picture a thing is and how large: middle, size, share of the box that is mask, and
#: whether the box is cut off.
PLACE = ("x", "y", "width", "height", "filled", "cut")


@dataclass(frozen=True)
class Crops:
    """Crops (n, SIDE, SIDE, 4) of the things ``ids`` (n,), and ``place`` (n, 6)."""

    ids: Ints
    pixels: Bytes
    place: Floats


def need_pictures(data: Dataset) -> None:
    """InputError for a data set without colour or masks."""
    lacking = {"rgb", "instance"} - set(data.info.options.sensors)
    if lacking or not data.info.options.views_about:
        raise InputError(
            [f"{data.path}: has no {' and no '.join(sorted(lacking)) or 'views'} (--sensors)"]
        )


def crops_of(item: SceneItem, wanted: Collection[int], views: int) -> Crops:
    """Crops of the ``wanted`` things from so many views each, those that show most of them."""
    seen: dict[int, list[tuple[int, int]]] = {}
    for view in item.visibility.views:
        camera = item.cameras[view.view]
        least = LEAST_PIXELS * camera.width * camera.height / (640 * 480)
        for thing in view.objects:
            if thing.object_id in wanted and thing.pixels >= least:
                seen.setdefault(thing.object_id, []).append((-thing.pixels, view.view))
    by_view: dict[int, list[int]] = {}
    for object_id, found in seen.items():
        for _, view_index in sorted(found)[:views]:
            by_view.setdefault(view_index, []).append(object_id)
    ids, pixels, place = [], [], []
    for view_index in sorted(by_view):
        for object_id, crop, where in _cut(item, view_index, sorted(by_view[view_index])):
            ids.append(object_id)
            pixels.append(crop)
            place.append(where)
    return Crops(
        ids=np.array(ids, dtype=np.int64),
        pixels=np.array(pixels, dtype=np.uint8).reshape(-1, SIDE, SIDE, 4),
        place=np.array(place, dtype=np.float32).reshape(-1, len(PLACE)),
    )


def _cut(
    item: SceneItem, view: int, ids: list[int]
) -> Iterator[tuple[int, Bytes, tuple[float, ...]]]:
    rgb, mask = item.rgb(view), item.instance(view)
    height, width = mask.shape
    picture = Image.fromarray(rgb)
    boxes = {
        thing.object_id: thing.bbox
        for shown in item.visibility.views
        if shown.view == view
        for thing in shown.objects
    }
    for object_id in ids:
        x, y, w, h = boxes[object_id]
        own = mask[y : y + h, x : x + w] == object_id
        if not own.any():
            continue
        side = max(CONTEXT * max(w, h), LEAST_SIDE * width / 640)
        middle = (x + w / 2, y + h / 2)
        left, top = round(middle[0] - side / 2), round(middle[1] - side / 2)
        size = max(1, round(side))
        crop = np.zeros((SIDE, SIDE, 4), dtype=np.uint8)
        crop[..., :3] = _resized(picture, left, top, size)
        # The mask of its own box alone, seen from there: whole ones take most of the time.
        alone = Image.fromarray(own.astype(np.uint8) * 255)
        crop[..., 3] = _resized(alone, left - x, top - y, size)
        cut = x == 0 or y == 0 or x + w == width or y + h == height
        place = (
            middle[0] / width,
            middle[1] / height,
            w / width,
            h / height,
            float(own.mean()),
            float(cut),
        )
        yield object_id, crop, place


def _resized(picture: Image.Image, left: int, top: int, size: int) -> Bytes:
    """A square of a picture at the size of crops; black where it reaches beyond it."""
    # Large ones are averaged, small ones smoothed.
    how = Image.Resampling.BOX if size > SIDE else Image.Resampling.BILINEAR
    square = picture.crop((left, top, left + size, top + size))
    return np.asarray(square.resize((SIDE, SIDE), how))


@dataclass(frozen=True)
class PictureExamples:
    """Crops of training scenes and twins; ``hazard`` as in ``Examples``."""

    pixels: Bytes
    place: Floats
    hazard: Ints


def gather_crops(
    data: Dataset, hazards: tuple[str, ...], seed: int, on_scene: Progress | None = None
) -> PictureExamples:
    """Crops of the train split: of what is wrong, of what nearly is, of what was wrong before it
    was put right (in twins), and of some of the rest. InputError where there is nothing."""
    need_pictures(data)
    kept = train_split(data)
    number = {name: k for k, name in enumerate(hazards)}
    parts: list[tuple[Bytes, Floats, Ints]] = []
    for done, item in enumerate(kept, start=1):
        twin = item.twin
        found = hazards_of(item)
        for one in (item, *(() if twin is None else (twin,))):
            wanted = _worth(one, set(found), seed)
            crops = crops_of(one, wanted, LEARN_VIEWS)
            wrong = hazards_of(one)
            hazard = [number[wrong[k][0]] if k in wrong else -1 for k in crops.ids.tolist()]
            parts.append((crops.pixels, crops.place, np.array(hazard, dtype=np.int64)))
        if on_scene is not None:
            on_scene(done, len(kept))
    made = PictureExamples(*(np.concatenate([part[k] for part in parts]) for k in range(3)))
    if not (made.hazard >= 0).any():
        raise InputError([f"{data.path}: no view of the split 'train' shows an anomaly"])
    return made


def _worth(item: SceneItem, suspects: set[int], seed: int) -> set[int]:
    """Things of a scene that are learned from."""
    near = {one.object_id for one in item.anomalies.lookalikes}
    every = sorted(thing.id for thing in item.scene.objects)
    shown = {o.object_id for view in item.visibility.views for o in view.objects}
    rest = [k for k in every if k in shown and k not in near and k not in suspects]
    rng = lane(seed, item.entry.index, f"train:crops:{item.id}")
    some = rng.permutation(len(rest))[:KEPT_EASY]
    return (suspects | near | {rest[k] for k in some}) & set(every)


def by_thing(
    ids: Ints, values: npt.NDArray[np.float64]
) -> tuple[list[int], npt.NDArray[np.float64]]:
    """Means over the crops of each thing, sorted by id."""
    every, place = np.unique(ids, return_inverse=True)
    out = np.zeros((len(every), values.shape[1]))
    np.add.at(out, place, values)
    count = np.bincount(place, minlength=len(every)).reshape(-1, 1)
    return every.tolist(), out / np.maximum(count, 1)
