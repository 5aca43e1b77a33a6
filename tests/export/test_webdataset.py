"""WebDataset shards, read by webdataset itself."""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.dataset import Dataset
from sdgen.export import export
from sdgen.export import webdataset as ours

from tests import toy

wds = pytest.importorskip("webdataset")


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("toy") / "d", n=6)


def test_every_view_is_a_sample_with_its_own_pixels(path: Path, tmp_path: Path) -> None:
    export(Dataset(path), "webdataset", tmp_path / "w")
    seen = 0
    for split in Dataset(path).info.splits:
        data = Dataset(path, split=split)
        shards = sorted(str(p) for p in (tmp_path / "w/views").glob(f"{split}-*.tar"))
        for sample in wds.WebDataset(shards, shardshuffle=False).decode("rgb8"):
            scene, view = sample["__key__"].split("-")
            item = data.scene(scene)
            assert np.array_equal(sample["rgb.png"], item.rgb(int(view)))
            for key, pixels in (("depth", item.depth_mm), ("instance", item.instance)):
                picture = Image.open(io.BytesIO(sample[f"{key}.png16"]))
                assert np.array_equal(np.asarray(picture), pixels(int(view)))
            shown = item.visibility.views[int(view)].objects
            assert [o["object_id"] for o in sample["json"]["objects"]] == [
                o.object_id for o in shown
            ]
            assert sample["json"]["split"] == split
            seen += 1
    assert seen == Dataset(path).info.counts.views


def test_scenes_are_samples_of_their_files(path: Path, tmp_path: Path) -> None:
    export(Dataset(path), "webdataset", tmp_path / "w")
    shards = sorted(str(p) for p in (tmp_path / "w/scenes").glob("*.tar"))
    samples = list(wds.WebDataset(shards, shardshuffle=False).decode())
    assert sorted(sample["__key__"] for sample in samples) == [item.id for item in Dataset(path)]
    wrong = sum(len(sample["anomalies.json"]["anomalies"]) for sample in samples)
    assert wrong == Dataset(path).info.counts.anomalies
    twins = sorted(str(p) for p in (tmp_path / "w/twin_scenes").glob("*.tar"))
    keys = [sample["__key__"] for sample in wds.WebDataset(twins, shardshuffle=False)]
    assert sorted(keys) == [item.id for item in Dataset(path, twins=True)]


def test_full_shards_are_followed_by_others(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ours, "SHARD_BYTES", 1)
    export(Dataset(path), "webdataset", tmp_path / "w")
    views = sorted(p.name for p in (tmp_path / "w/views").glob("train-*.tar"))
    assert len(views) == sum(
        entry.views
        for entry in Dataset(path, split="train").entries
        if entry.split == "train" and entry.kind == "scene"
    )
    assert views[1] == "train-000001.tar"


def test_one_split_alone(path: Path, tmp_path: Path) -> None:
    export(Dataset(path, split="val"), "webdataset", tmp_path / "w")
    assert {p.name for p in (tmp_path / "w").rglob("*.tar")} == {"val-000000.tar"}
