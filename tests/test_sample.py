"""The committed sample is what this version writes and passes validation."""

import shutil
from pathlib import Path

import pytest
from sdgen.dataset.reader import Dataset
from sdgen.validate import validate

SAMPLE = Path(__file__).resolve().parent.parent / "output" / "sample"


@pytest.mark.slow
def test_the_sample_is_sound():
    assert validate(SAMPLE) == []


def test_the_sample_shows_anomalies_and_lookalikes():
    scenes = list(Dataset(SAMPLE))
    assert len(scenes) == 3
    assert all(scene.anomalies.anomalies and scene.anomalies.lookalikes for scene in scenes)
    assert all(scene.rgb(0).shape == (240, 320, 3) for scene in scenes)


def test_another_seed_is_noticed(tmp_path: Path):
    """Drawn homes are named by the seed they were drawn with."""
    path = Path(shutil.copytree(SAMPLE, tmp_path / "d"))
    text = (path / "dataset.json").read_text(encoding="utf-8")
    assert text.count('"seed": 54') == 2
    (path / "dataset.json").write_text(text.replace('"seed": 54', '"seed": 55'), encoding="utf-8")
    told = [problem.text for problem in validate(path)]
    assert "dataset.json: seed 55, scene 000000 was drawn with 54" in told
