"""The committed sample is what this version writes and passes validation."""

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
