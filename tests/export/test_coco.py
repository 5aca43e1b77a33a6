"""COCO annotations, read by pycocotools."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.dataset import Dataset
from sdgen.export import export
from sdgen.export.coco import run_lengths, segments_of

from tests import toy

pytest.importorskip("pycocotools")


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("toy") / "d", n=6)


@pytest.fixture(scope="module")
def folder(path: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("coco") / "coco"
    export(Dataset(path), "coco", out)
    return out


def test_masks_boxes_and_areas_are_the_views_own(path: Path, folder: Path) -> None:
    from pycocotools.coco import COCO

    for split in Dataset(path).info.splits:
        coco = COCO(str(folder / f"annotations/instances_{split}.json"))
        assert coco.getImgIds()
        for image in coco.loadImgs(coco.getImgIds()):
            item = Dataset(path).scene(image["scene"])
            picture = Image.open(folder / "images" / split / image["file_name"])
            assert np.array_equal(np.asarray(picture), item.rgb(image["view"]))
            ids = item.instance(image["view"])
            shown = {o.object_id: o for o in item.visibility.views[image["view"]].objects}
            found = coco.loadAnns(coco.getAnnIds(imgIds=image["id"]))
            assert {a["object_id"] for a in found} == set(shown)
            for annotation in found:
                mask = ids == annotation["object_id"]
                assert np.array_equal(coco.annToMask(annotation).astype(bool), mask)
                seen = shown[annotation["object_id"]]
                assert (annotation["bbox"], annotation["area"]) == (list(seen.bbox), seen.pixels)
                (category,) = coco.loadCats(annotation["category_id"])
                assert category["name"] == item.scene.object(annotation["object_id"]).category


def test_hazards_are_the_anomalies_that_views_show(path: Path, folder: Path) -> None:
    from pycocotools.coco import COCO

    for split in Dataset(path).info.splits:
        coco = COCO(str(folder / f"annotations/hazards_{split}.json"))
        found = set()
        for annotation in coco.loadAnns(coco.getAnnIds()):
            (image,) = coco.loadImgs(annotation["image_id"])
            (category,) = coco.loadCats(annotation["category_id"])
            found.add((image["scene"], image["view"], annotation["object_id"], category["name"]))
        wanted = {
            (item.id, view.view, anomaly.object_id, anomaly.hazard)
            for item in Dataset(path, split=split)
            for anomaly in item.anomalies.anomalies
            for view in item.visibility.views
            if any(o.object_id == anomaly.object_id for o in view.objects)
        }
        assert found == wanted


def test_panoptic_colours_are_ids_and_every_segment_is_told(path: Path, folder: Path) -> None:
    for split in Dataset(path).info.splits:
        said = json.loads((folder / f"annotations/panoptic_{split}.json").read_text())
        images = {image["id"]: image for image in said["images"]}
        names = {category["id"]: category for category in said["categories"]}
        for annotation in said["annotations"]:
            image = images[annotation["image_id"]]
            place = folder / f"annotations/panoptic_{split}" / annotation["file_name"]
            colours = np.asarray(Image.open(place)).astype(int)
            ids = colours[..., 0] + 256 * colours[..., 1] + 65536 * colours[..., 2]
            item = Dataset(path).scene(image["scene"])
            assert np.array_equal(ids, item.instance(image["view"]))
            areas = {s["id"]: s["area"] for s in annotation["segments_info"]}
            values, counts = np.unique(ids[ids > 0], return_counts=True)
            assert areas == dict(zip(values.tolist(), counts.tolist(), strict=True))
            for segment in annotation["segments_info"]:
                node = next(n for n in item.scene_graph.nodes if n.id == segment["id"])
                category = names[segment["category_id"]]
                assert category["name"] == node.class_name
                assert category["isthing"] == (node.class_name not in ("floor", "wall", "ceiling"))


def test_segments_of_any_mask() -> None:
    """Also runs that go on from the foot of one column at the head of the next."""
    from pycocotools import mask

    rng = np.random.default_rng(3)
    for _ in range(30):
        height, width = rng.integers(1, 12, 2)
        ids = rng.integers(0, 4, (height, width)).astype(np.uint16)
        found = segments_of(ids)
        assert set(found) == set(np.unique(ids).tolist()) - {0}
        for number, segment in found.items():
            here = ids == number
            rows, columns = np.nonzero(here)
            x, y = int(columns.min()), int(rows.min())
            box = [x, y, int(columns.max()) - x + 1, int(rows.max()) - y + 1]
            assert (segment.area, segment.bbox) == (int(here.sum()), box)
            packed = run_lengths(segment, ids.shape)
            assert np.array_equal(mask.decode(packed).astype(bool), here)
