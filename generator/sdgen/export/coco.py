"""A data set as COCO: things and hazards as instances, everything as a panoptic segmentation.

``images/SPLIT/000041-03.png``; ``annotations/instances_SPLIT.json`` with our categories,
``hazards_SPLIT.json`` with the anomalies alone and hazards for categories,
``panoptic_SPLIT.json`` and ``panoptic_SPLIT/000041-03.png``, whose colours are node ids
(R + 256 G). Masks are compressed run lengths. Ids of annotations count from 1; ``object_id`` is
the node's. Format: https://cocodataset.org/#format-data
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.images import rgb_bytes
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.text import compact
from sdgen.errors import SdgenError
from sdgen.export.formats import OnScene
from sdgen.export.rows import picture_files, rows_of_views
from sdgen.export.shards import groups, scenes_in
from sdgen.vocabulary import STRUCTURES

Ids = npt.NDArray[np.uint16]


def export_coco(data: Dataset, output: Path, on_scene: OnScene = None) -> None:
    """Write pictures and annotations into a new folder; the same bytes for the same data set.

    Raises SdgenError for a bad place or a data set without masks or colours, InputError for a file
    that is missing or changed, ModuleNotFoundError without pycocotools (pip install sdgen[coco]).
    """
    if not {"rgb", "instance"} <= set(data.info.options.sensors):
        raise SdgenError(f"{data.path}: COCO needs the sensors rgb and instance")
    import pycocotools  # noqa: F401  (before the work)

    total, done = scenes_in(data), 0
    with output_folder(output) as folder:
        (folder / "annotations").mkdir()
        for kind, split, scenes in groups(data):
            name = split if kind == "scene" else f"{split}_{kind}"
            with _Split(data, folder, name) as out:
                for item in scenes:
                    with derived_from(data, item):
                        out.scene(item)
                    done += 1
                    if on_scene is not None:
                        on_scene(done, total)


class _Split:
    """The files of one split, its lists streamed: ``images`` come with the first of their lists."""

    def __init__(self, data: Dataset, folder: Path, name: str) -> None:
        self._folder = folder
        self._name = name
        words, hazards = data.info.vocabularies.categories, data.info.hazards_enabled
        self._category = {word: number for number, word in enumerate(words, start=1)}
        self._hazard = {word: number for number, word in enumerate(hazards, start=1)}
        superclass = {c.name: c.superclass for c in data.catalog.categories}
        things = [
            {
                "id": number,
                "name": word,
                "supercategory": superclass.get(word, "Building"),
                "isthing": int(word not in STRUCTURES),
            }
            for word, number in self._category.items()
        ]
        group = {hazard.id: hazard.group for hazard in data.catalog.hazards}
        of_hazards = [
            {"id": number, "name": word, "supercategory": group[word]}
            for word, number in self._hazard.items()
        ]
        self._stack = ExitStack()
        self._instances = self._list("instances", things)
        self._hazards = self._list("hazards", of_hazards)
        self._panoptic = self._list("panoptic", things)
        self._images = 0
        for kind in ("images", "annotations"):
            place = folder / (
                f"images/{name}" if kind == "images" else f"annotations/panoptic_{name}"
            )
            place.mkdir(parents=True)

    def _list(self, kind: str, categories: Sequence[Mapping[str, Any]]) -> _Annotations:
        path = self._folder / "annotations" / f"{kind}_{self._name}.json"
        return self._stack.enter_context(_Annotations(path, categories))

    def __enter__(self) -> _Split:
        return self

    def __exit__(self, *error: Any) -> None:
        self._stack.close()

    def scene(self, item: SceneItem) -> None:
        """Add all views of a scene."""
        names = {node.id: node.class_name for node in item.scene_graph.nodes}
        for row in rows_of_views(item):
            view = row["view"]
            self._images += 1
            pictures = picture_files(item, view)
            stem = f"{item.id}-{view:02d}"
            file_name = f"{stem}{Path(pictures['image']).suffix}"
            (self._folder / "images" / self._name / file_name).write_bytes(
                item.file(pictures["image"])
            )
            image = {
                "id": self._images,
                "file_name": file_name,
                "width": row["width"],
                "height": row["height"],
                **{key: row[key] for key in ("scene", "twin_of", "view", "room_type")},
            }
            ids = item.instance(view)
            segments = segments_of(ids)
            for thing in row["objects"]:
                said = _instance(segments[thing["object_id"]], thing, ids.shape)
                self._instances.add(
                    said
                    | {
                        "image_id": self._images,
                        "category_id": self._category[thing["category"]],
                        "hazards": thing["hazards"],
                        "near_miss_of": thing["near_miss_of"],
                    }
                )
                for hazard in thing["hazards"]:
                    number = self._hazard[hazard]
                    self._hazards.add(said | {"image_id": self._images, "category_id": number})
            self._panoptic.add(
                {
                    "image_id": self._images,
                    "file_name": f"{stem}.png",
                    "segments_info": [
                        {
                            "id": number,
                            "category_id": self._category[names[number]],
                            "bbox": segment.bbox,
                            "area": segment.area,
                            "iscrowd": 0,
                        }
                        for number, segment in segments.items()
                    ],
                },
                numbered=False,
            )
            place = self._folder / "annotations" / f"panoptic_{self._name}" / f"{stem}.png"
            place.write_bytes(rgb_bytes(_colours(ids), "png"))
            for file in (self._instances, self._hazards, self._panoptic):
                file.image(image)


@dataclass(frozen=True)
class Segment:
    """The pixels of one id: where its runs begin and end in column-major order, its box and area.
    ``bbox`` is [x, y, w, h]."""

    starts: npt.NDArray[np.int64]
    ends: npt.NDArray[np.int64]
    bbox: list[int]
    area: int


def segments_of(ids: Ids) -> dict[int, Segment]:
    """The segments of an (H, W) mask by id, sorted; 0 is none."""
    height = ids.shape[0]
    flat = ids.T.ravel()  # column after column, as COCO counts
    cut = np.flatnonzero(flat[1:] != flat[:-1]) + 1
    # A run that goes on in the next column is one run; the box needs it cut there.
    starts = np.concatenate([[0], cut])
    ends = np.concatenate([cut, [flat.size]])
    values = flat[starts]
    order = np.argsort(values, kind="stable")
    numbers, first = np.unique(values[order], return_index=True)
    out = {}
    for number, some in zip(numbers.tolist(), np.split(order, first[1:]), strict=True):
        if number == 0:
            continue
        begin, end = starts[some], ends[some]
        x0, x1 = int(begin[0]) // height, int(end[-1] - 1) // height + 1
        if np.any(begin // height != (end - 1) // height):
            y0, y1 = 0, height  # some run reaches the foot of one column and the head of the next
        else:
            y0, y1 = int((begin % height).min()), int(((end - 1) % height).max()) + 1
        area = int((end - begin).sum())
        out[number] = Segment(begin, end, [x0, y0, x1 - x0, y1 - y0], area)
    return out


def _instance(segment: Segment, thing: Mapping[str, Any], shape: tuple[int, ...]) -> dict[str, Any]:
    """An annotation but for its id, image and category."""
    return {
        "object_id": thing["object_id"],
        "bbox": segment.bbox,
        "area": segment.area,
        "segmentation": run_lengths(segment, shape),
        "iscrowd": 0,
        "fraction": thing["fraction"],
    }


def run_lengths(segment: Segment, shape: tuple[int, ...]) -> dict[str, Any]:
    """COCO's compressed run lengths of a segment of an (H, W) picture."""
    from pycocotools import mask

    height, width = shape
    edges = np.empty(2 * len(segment.starts) + 2, dtype=np.int64)
    edges[0], edges[-1] = 0, height * width
    edges[1:-1:2], edges[2:-1:2] = segment.starts, segment.ends
    counts = np.diff(edges)
    if counts[-1] == 0:
        counts = counts[:-1]
    packed = mask.frPyObjects({"size": [height, width], "counts": counts.tolist()}, height, width)
    return {"size": [height, width], "counts": packed["counts"].decode("ascii")}


def _colours(ids: Ids) -> npt.NDArray[np.uint8]:
    """Ids as colours, (H, W, 3): red + 256 green, as panopticapi's ``rgb2id`` has it."""
    out = np.zeros((*ids.shape, 3), dtype=np.uint8)
    out[..., 0], out[..., 1] = ids & 255, ids >> 8
    return out


@dataclass
class _Annotations:
    """A JSON file of COCO, its annotations written as they come, its images last."""

    path: Path
    categories: Sequence[Mapping[str, Any]]
    _file: IO[str] = field(init=False)
    _spool: IO[str] = field(init=False)
    _number: int = 0

    def __enter__(self) -> _Annotations:
        import tempfile

        self._file = self.path.open("x", encoding="utf-8")
        self._spool = tempfile.TemporaryFile("w+", encoding="utf-8", dir=self.path.parent)
        info = {"description": "sdgen household hazards", "version": "1.0"}
        self._file.write(f'{{"info": {compact(info)},\n"categories": {compact(self.categories)}')
        self._file.write(',\n"annotations": [')
        return self

    def __exit__(self, *error: Any) -> None:
        import shutil

        self._file.write('\n],\n"images": [')
        self._spool.seek(0)
        shutil.copyfileobj(self._spool, self._file)
        self._file.write("\n]}\n")
        self._spool.close()
        self._file.close()

    def add(self, annotation: Mapping[str, Any], numbered: bool = True) -> None:
        """Add an annotation, with the next id unless it has none of its own."""
        self._number += 1
        own = {"id": self._number} if numbered else {}
        self._file.write(("," if self._number > 1 else "") + "\n" + compact({**own, **annotation}))

    def image(self, image: Mapping[str, Any]) -> None:
        """Add a picture."""
        self._spool.write(("," if image["id"] > 1 else "") + "\n" + compact(image))
