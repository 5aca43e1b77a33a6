"""Recordings for Rerun, checked by its own command."""

import subprocess
import sys
from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.export import export

from tests import toy

pytest.importorskip("rerun")


def rerun(*args: str) -> str:
    command = [sys.executable, "-m", "rerun", *args]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)
    return done.stdout


def test_rerun_reads_what_a_scene_holds(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    export(Dataset(path), "rerun", tmp_path / "r")
    assert sorted(p.name for p in (tmp_path / "r").iterdir()) == ["000000.rrd", "000001.rrd"]
    recording = str(tmp_path / "r/000001.rrd")
    rerun("rrd", "verify", recording)
    said = rerun("rrd", "print", "-vvv", recording)
    for path_in_it in (
        "/household",
        "/world/rooms",
        "/world/objects",
        "/world/anomalies",
        "/world/cameras/00/rgb",
        "/world/cameras/00/depth",
    ):
        assert path_in_it in said
    anomaly = Dataset(path)[1].anomalies.anomalies[0]
    assert anomaly.message[:20] in said
