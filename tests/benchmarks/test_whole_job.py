"""The benchmark of the whole job measures what it says, with the package as it is now."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest
from sdgen import Dataset
from sdgen.library.cache import cache_root

from tests.by_path import ROOT, module_at

SAMPLE = ROOT / "output" / "sample"


@pytest.fixture(scope="module")
def job() -> ModuleType:
    return module_at("benchmarks/whole_job.py")


@pytest.mark.slow
def test_content_is_timed_in_the_tree_it_is_told(job: ModuleType) -> None:
    (found,) = job.content([ROOT], [cache_root()], count=1, seed=7, workers=1)
    assert 0.05 < found["content_core_s_a_scene"] < 60
    assert found["start_core_s_a_process"] > 0.1


def test_bare_frames_are_those_of_the_data_set(job: ModuleType) -> None:
    found = job.bare_frames(SAMPLE, cache_root(), 1)
    assert found["faces_a_view_median"] > 10_000
    views = sum(len(item.cameras) for item in Dataset(SAMPLE))
    assert found["bare_wall_s"] == pytest.approx(views * found["bare_frame_mean_ms"] / 1000)


def test_memory_is_that_of_the_process_and_its_children(job: ModuleType) -> None:
    hold = "import time; held = b'x' * 150_000_000; time.sleep(1.5)"
    nest = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {hold!r}])"
    with (
        subprocess.Popen([sys.executable, "-c", nest], text=True) as process,
        job.memory_watched(process, 0.2) as most,
    ):
        process.wait()
    assert most["largest"] > 140
    assert 140 < most["together"] < 400


def test_a_failed_process_ends_the_measurement(job: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="failed with 1"):
        job.bare_frames(tmp_path / "nothing", cache_root(), 1)
