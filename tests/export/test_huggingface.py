"""Parquet tables, loaded by datasets and described by Croissant."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sdgen.dataset import Dataset
from sdgen.export import export
from sdgen.export import huggingface as ours

from tests import toy

datasets = pytest.importorskip("datasets")


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("toy") / "d", n=6)


@pytest.fixture(scope="module")
def folder(path: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("hf") / "hf"
    export(Dataset(path), "huggingface", out)
    return out


def load(folder: Path, name: str | None, tmp_path: Path) -> Any:
    return datasets.load_dataset(str(folder), name, cache_dir=str(tmp_path / "cache"))


def test_views_have_their_pixels_and_boxes(path: Path, folder: Path, tmp_path: Path) -> None:
    data, loaded = Dataset(path), load(folder, None, tmp_path)
    assert set(loaded) == {entry.split for entry in data.entries}
    assert sum(len(rows) for rows in loaded.values()) == data.info.counts.views
    for split, rows in loaded.items():
        for row in rows:
            item, view = data.scene(row["scene"]), row["view"]
            assert item.entry.split == split == row["split"]
            assert np.array_equal(np.asarray(row["image"]), item.rgb(view))
            assert np.array_equal(np.asarray(row["depth"]), item.depth_mm(view))
            assert np.array_equal(np.asarray(row["instance"]), item.instance(view))
            assert np.array_equal(np.asarray(row["part"]), item.part(view))
            assert np.allclose(row["K"], item.cameras[view].K)
            shown = item.visibility.views[view].objects
            assert [o["bbox"] for o in row["objects"]] == [list(o.bbox) for o in shown]


def test_scenes_and_anomalies_are_counted_as_stats_does(
    path: Path, folder: Path, tmp_path: Path
) -> None:
    counts = Dataset(path).info.counts
    scenes = datasets.concatenate_datasets(list(load(folder, "scenes", tmp_path).values()))
    assert len(scenes) == counts.scenes
    assert sum(len(row["anomalies"]) for row in scenes) == counts.anomalies
    assert sum(len(row["lookalikes"]) for row in scenes) == counts.lookalikes
    assert sum(len(row["objects"]) for row in scenes) == counts.objects
    wrong = datasets.concatenate_datasets(list(load(folder, "anomalies", tmp_path).values()))
    assert len(wrong) == counts.anomalies
    by_hazard = {name: wrong["hazard"][:].count(name) for name in set(wrong["hazard"])}
    assert by_hazard == {k: v for k, v in counts.anomalies_by_hazard.items() if v}


def test_twins_have_tables_of_their_own(path: Path, folder: Path, tmp_path: Path) -> None:
    twins = datasets.concatenate_datasets(list(load(folder, "twin_scenes", tmp_path).values()))
    assert sorted(twins["twin_of"]) == [item.id for item in Dataset(path)]
    assert not any(twins["anomalies"])


def test_full_files_are_followed_by_others(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ours, "SHARD_BYTES", 1)
    monkeypatch.setattr(ours, "ROWS", 1)
    export(Dataset(path), "huggingface", tmp_path / "hf")
    names = sorted(p.name for p in (tmp_path / "hf/views").glob("train-*"))
    assert names[0] == f"train-00000-of-{len(names):05d}.parquet"
    assert len(names) > 1
    rows = load(tmp_path / "hf", "views", tmp_path)["train"]
    assert len(rows) == len(names)


def test_without_pictures_views_are_cameras_and_boxes(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=("depth",)))
    export(Dataset(path), "huggingface", tmp_path / "hf")
    rows = next(iter(load(tmp_path / "hf", "views", tmp_path).values()))
    assert "depth" in rows.column_names
    assert "image" not in rows.column_names


def test_croissant_is_valid_and_gives_the_same_rows(path: Path, folder: Path) -> None:
    croissant = pytest.importorskip("mlcroissant")
    read = croissant.Dataset(jsonld=str(folder / "croissant.json"))
    assert not read.metadata.issues.errors
    counts = Dataset(path).info.counts
    views = list(read.records("views"))
    assert len(views) == counts.views
    first = views[0]
    item = Dataset(path).scene(first["views/scene"].decode())
    assert np.array_equal(np.asarray(first["views/image"]), item.rgb(first["views/view"]))
    assert len(list(read.records("scenes"))) == counts.scenes
    hazards = [row["anomalies/hazard"].decode() for row in read.records("anomalies")]
    assert len(hazards) == counts.anomalies
    assert set(hazards) <= set(counts.anomalies_by_hazard)


def test_rows_wait_by_what_they_weigh(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Scenes hold no pictures and long lists: a hundred of them would be all of a data set."""
    from pyarrow.parquet import ParquetFile

    monkeypatch.setattr(ours, "ROWS_BYTES", 20_000)
    export(Dataset(path), "huggingface", tmp_path / "out")
    for file in (tmp_path / "out" / "scenes").glob("*.parquet"):
        table = ParquetFile(file)
        assert table.num_row_groups == table.metadata.num_rows
