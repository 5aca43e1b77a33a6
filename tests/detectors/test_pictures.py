"""Crops show what the masks say, and trees as arrays say what scikit-learn says."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.dataset import Dataset
from sdgen.detectors.boosted import Growth, grow
from sdgen.detectors.pictures import SIDE, by_thing, crops_of
from sdgen.detectors.scored import Scored, best_threshold, mean_f1, scene_f1

from tests import toy


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build(tmp_path_factory.mktemp("set") / "d"))


def test_a_crop_has_the_thing_in_its_middle_and_its_own_pixels_as_mask(data: Dataset) -> None:
    item = data[3]
    crops = crops_of(item, {11, 77}, views=1)
    assert set(crops.ids.tolist()) == {11, 77}
    for object_id, pixels in zip(crops.ids.tolist(), crops.pixels, strict=True):
        view = max(
            (v for v in item.visibility.views if object_id in {o.object_id for o in v.objects}),
            key=lambda v: next(o.pixels for o in v.objects if o.object_id == object_id),
        ).view
        # The whole mask, cut out the plain way around the mask's own pixels.
        mask = item.instance(view) == object_id
        rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
        shown = pixels[..., 3] > 127
        assert 0.02 < shown.mean() < 0.5
        high, wide = np.flatnonzero(shown.any(axis=1)), np.flatnonzero(shown.any(axis=0))
        assert abs((high[0] + high[-1]) / 2 - SIDE / 2) < 3
        assert abs((wide[0] + wide[-1]) / 2 - SIDE / 2) < 3
        ratio = (rows[-1] - rows[0] + 1) / (columns[-1] - columns[0] + 1)
        assert abs(np.log(len(high) / len(wide) / ratio)) < 0.35
        own = item.rgb(view)[mask].mean(axis=0)
        assert np.abs(pixels[shown][:, :3].mean(axis=0) - own).max() < 25


def test_pictures_beyond_the_edge_are_black_and_small(tmp_path: Path) -> None:
    from sdgen.detectors.pictures import _resized

    white = Image.new("L", (10, 10), 255)
    assert _resized(white, 20, 20, 8).max() == 0
    assert _resized(white, 0, 0, 10).min() == 255


def test_what_is_said_of_views_is_averaged_by_thing() -> None:
    ids, means = by_thing(np.array([5, 3, 5]), np.array([[1.0], [0.5], [0.0]]))
    assert ids == [3, 5]
    assert means.tolist() == [[0.5], [0.5]]


@pytest.mark.parametrize("classes", [1, 2, 4])
def test_trees_as_arrays_tell_classes(classes: int) -> None:
    pytest.importorskip("sklearn")
    rng = np.random.default_rng(0)
    x = rng.normal(size=(400, 3)).astype(np.float32)
    y = np.clip(((x[:, 1] + 2) * classes / 4).astype(np.int64), 0, classes - 1)
    trees = grow(x, y, classes, Growth(rounds=20, share=1.0), seed=1)
    said = trees.probabilities(x)
    assert said.shape == (400, classes)
    assert (said.argmax(axis=1) == y).mean() > 0.95
    assert trees.probabilities(x[:0]).shape == (0, classes)


def test_f1_of_a_scene_is_the_one_that_evaluate_has() -> None:
    assert scene_f1((), ()) is None
    assert scene_f1({1}, ()) == 0
    assert scene_f1({1, 2}, {2, 3}) == 0.5


def test_the_threshold_is_the_one_with_the_best_mean_f1() -> None:
    def scored(*scores: float) -> list[Scored]:
        return [Scored(k, score, "unsafe", "spill") for k, score in enumerate(scores)]

    said = {"a": scored(0.9, 0.3, 0.1), "b": scored(0.2, 0.8, 0.05), "c": scored(0.25)}
    wrong: dict[str, set[int]] = {"a": {0}, "b": {1}, "c": set()}
    threshold = best_threshold(said, wrong)
    assert mean_f1(said, wrong, threshold) == 1.0
    assert 0.3 < threshold <= 0.8
    assert best_threshold({}, {}) == 0.5


def test_one_class_is_kept_and_read(tmp_path: Path) -> None:
    from sdgen.detectors.boosted import Boosted

    trees = grow(np.zeros((3, 2)), np.zeros(3, dtype=np.int64), 1, Growth(rounds=2), seed=0)
    again = Boosted.from_arrays(trees.arrays("t"), "t", features=2, classes=1)
    assert again.probabilities(np.zeros((5, 2))).tolist() == [[1.0]] * 5
