"""Flat tables: as many rows as are counted, values as in the files."""

import pickle
from pathlib import Path

import pytest
from sdgen.dataset import Dataset

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8))
    for picture in made.rglob("*.png"):
        picture.unlink()  # labels are read without them
    return made


def test_they_have_the_rows_that_the_manifest_counts(path: Path) -> None:
    data = Dataset(path)
    counts = data.info.counts
    assert len(data.anomalies) == counts.anomalies > 0
    assert len(data.objects) == counts.objects
    assert len(data.views) == counts.views
    some = data.filter(split="train")
    assert len(some.anomalies) == sum(entry.anomalies for entry in some.shown) < counts.anomalies


def test_a_row_is_its_record(path: Path) -> None:
    data = Dataset(path)
    item = data[3]
    rows = [row for row in data.anomalies if row["scene"] == item.id]
    for row, anomaly in zip(rows, item.anomalies.anomalies, strict=True):
        assert tuple(row) == data.anomalies.columns
        assert (row["hazard"], row["object_id"]) == (anomaly.hazard, anomaly.object_id)
        assert row["evidence"] == anomaly.evidence
        assert row["report"] is anomaly.report
        pixels = next(
            s.evidence_pixels for s in item.visibility.anomalies if s.anomaly_id == anomaly.id
        )
        assert row["best_pixels"] == max(pixels)
        assert row["best_view"] is None or pixels[row["best_view"]] == max(pixels)
    things = {row["object_id"]: row for row in data.objects if row["scene"] == item.id}
    assert set(things) == {thing.id for thing in item.scene.objects}
    for anomaly in item.anomalies.anomalies:
        assert anomaly.hazard in things[anomaly.object_id]["hazards"]
    near = item.anomalies.lookalikes[0]
    assert near.near_miss_of in things[near.object_id]["near_miss_of"]


def test_views_name_their_picture_and_the_hazards_in_it(path: Path) -> None:
    data = Dataset(path)
    for row in data.views:
        assert row["rgb"] == f"scenes/{row['scene']}/views/{row['view']:02d}/rgb.png"
        item = data.scene(row["scene"])
        wrong = {a.object_id: a.hazard for a in item.anomalies.anomalies}
        seen = {o.object_id for o in item.visibility.views[row["view"]].objects}
        assert set(row["hazards"]) == {wrong[k] for k in seen & set(wrong)}


def test_to_pandas_and_columns(path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    data = Dataset(path)
    frame = data.anomalies.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    by_hazard = frame.groupby("hazard").size().to_dict()
    assert by_hazard == {k: v for k, v in data.info.counts.anomalies_by_hazard.items() if v}
    assert data.anomalies.column("hazard") == list(frame["hazard"])
    with pytest.raises(KeyError):
        data.anomalies.column("no such")
    empty = data.filter(hazard="spill") if "spill" in data.info.hazards_enabled else None
    assert empty is None or list(empty.anomalies.to_pandas().columns) == list(frame.columns)


def test_they_pickle_and_show_themselves(path: Path) -> None:
    table = pickle.loads(pickle.dumps(Dataset(path).objects))
    assert len(table) == Dataset(path).info.counts.objects
    assert "rows of scene, split, object_id" in repr(table)
    html = table._repr_html_()
    assert html.count("<tr>") == 11
    assert f"{len(table)} rows" in html
