"""The cache follows what was read, never what happens to lie on disk."""

import numpy as np
import pytest
from sdgen.errors import AssetError
from sdgen.library import Library

from tests.fakes import write_library


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("SDGEN_CACHE", str(tmp_path / "cache"))
    return write_library(tmp_path / "assets")


def top_of(path):
    lines = [line.split() for line in path.read_text().splitlines() if line.startswith("v ")]
    return max(float(line[3]) for line in lines)


def test_parts_are_unpacked_once_and_shared(folder):
    first = Library([folder]).objs("cube_01")["body"]
    stamp = first.stat().st_mtime_ns
    again = Library([folder]).objs("cube_01")["body"]
    assert again == first
    assert again.stat().st_mtime_ns == stamp
    assert "map_Kd" in first.with_suffix(".mtl").read_text()


def test_a_mesh_that_changes_after_it_was_read_poisons_nothing(folder):
    old = Library([folder])
    height = float(np.ptp(old.mesh("cube_01")["body"].vertices[:, 2]))
    other = (folder / old.assets["plank_01"].mesh).read_bytes()
    (folder / old.assets["cube_01"].mesh).write_bytes(other)
    assert top_of(old.objs("cube_01")["body"]) == pytest.approx(height)
    fresh = Library([folder])
    assert top_of(fresh.objs("cube_01")["body"]) == pytest.approx(0.02)


def test_missing_and_broken_files_are_named(folder):
    mesh = folder / Library([folder]).assets["cube_01"].mesh
    mesh.write_bytes(mesh.read_bytes()[:60])
    with pytest.raises(AssetError, match="cube_01"):
        Library([folder]).mesh("cube_01")
    mesh.unlink()
    with pytest.raises(AssetError, match="cube_01"):
        Library([folder]).mesh("cube_01")
