"""What is prepared on disk is what the files hold; what is broken there is made again."""

from __future__ import annotations

import multiprocessing
import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from sdgen.errors import AssetError
from sdgen.library import Library, library, prepared
from sdgen.library.cache import cache_root, usable_cache, write
from sdgen.library.meshes import MeshData, read_glb, read_hulls, within_meshes
from sdgen.library.outlines import outlines_of
from sdgen.library.reaching import reaching_meshes
from sdgen.scratch import PREFIX

from tests.fakes import MODELS, write_library


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SDGEN_CACHE", str(tmp_path / "cache"))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write_library(tmp_path / "assets")


def entries(kind: str) -> list[Path]:
    return sorted(path for path in (cache_root() / kind).rglob("*") if path.is_file())


def check(found: Library, folder: Path) -> None:
    """Raise AssertionError unless every number is the one in the model's files, bit by bit."""
    for asset in found.assets.values():
        meshes = read_glb(folder / asset.mesh, asset)
        assert list(found.mesh(asset.id)) == list(meshes)
        for part, mesh in meshes.items():
            for field in fields(MeshData):
                ours = getattr(found.mesh(asset.id)[part], field.name)
                assert ours.dtype == getattr(mesh, field.name).dtype
                assert np.array_equal(ours, getattr(mesh, field.name))
        cut = within_meshes(read_hulls(folder / asset.hulls, asset), meshes, asset)
        pieces = reaching_meshes(cut, meshes, asset)
        assert [hull.part for hull in found.hulls(asset.id)] == [hull.part for hull in pieces]
        for ours, theirs in zip(found.hulls(asset.id), pieces, strict=True):
            assert np.array_equal(ours.vertices_m, theirs.vertices_m)
        outlines = {part: outlines_of(mesh) for part, mesh in meshes.items()}
        assert found.info(asset.id).outlines_m == outlines


def test_what_is_mapped_is_what_the_files_hold(folder: Path) -> None:
    check(Library([folder]), folder)
    check(Library([folder]), folder)


def test_no_glb_is_read_and_no_record_checked_again(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = Library([folder])
    infos = [first.info(name) for name in MODELS]
    monkeypatch.setattr(prepared, "read_glb", None)
    monkeypatch.setattr("sdgen.library.kept.read_manifest", None)
    again = Library([folder])
    assert [again.info(name) for name in MODELS] == infos
    assert again.assets == first.assets
    assert again.surfaces == first.surfaces
    assert [a.model_fields_set for a in again.assets.values()] == [
        a.model_fields_set for a in first.assets.values()
    ]
    assert again.sha256 == first.sha256


def test_nobody_can_write_into_what_all_share(folder: Path) -> None:
    for _ in range(2):
        mesh = Library([folder]).mesh("cube_01")["body"]
        with pytest.raises(ValueError, match="read-only"):
            mesh.vertices[0] = 0.0


def test_models_that_were_let_go_are_mapped_again(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(library, "_HELD", 2)
    found = Library([folder])
    check(found, folder)
    # As it was read, whatever became of the file since.
    before = found.mesh("cube_01")["body"].vertices.copy()
    for name in MODELS:
        found.mesh(name)
    (folder / found.assets["cube_01"].mesh).write_bytes(b"other")
    assert np.array_equal(found.mesh("cube_01")["body"].vertices, before)
    with pytest.raises(AssetError, match="cube_01"):
        Library([folder]).mesh("cube_01")


def test_boxes_of_parts_are_known_without_mapping_a_model_again(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(library, "_HELD", 1)
    found = Library([folder])
    for name in MODELS:
        boxes = found.bounds(name)
        assert set(boxes) == set(found.mesh(name))
        for part, mesh in found.mesh(name).items():
            assert np.array_equal(boxes[part], mesh.bounds_m)
    monkeypatch.setattr(Library, "model", None)
    for name in MODELS:
        assert set(found.bounds(name)) == {part.name for part in found.assets[name].parts}


def _cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-40])


def _to_nothing(path: Path) -> None:
    path.write_bytes(b"")


def _flip(path: Path) -> None:
    raw = bytearray(path.read_bytes())
    raw[len(raw) // 2] ^= 1
    path.write_bytes(raw)


def _junk(path: Path) -> None:
    path.write_bytes(b"\0" * 200)


def _away(path: Path) -> None:
    path.unlink()


@pytest.mark.parametrize("damage", [_cut, _to_nothing, _flip, _junk, _away])
def test_broken_entries_are_made_again(folder: Path, damage: Callable[[Path], None]) -> None:
    def load() -> Library:
        found = Library([folder])
        for asset in found.assets:
            found.objs(asset)
        return found

    load()
    kept = {path: path.read_bytes() for path in entries("")}
    kinds = {path.relative_to(cache_root()).parts[0] for path in kept}
    assert kinds == {"models", "prepared", "records", "textures"}
    for path in kept:
        damage(path)
    check(load(), folder)
    assert {path: path.read_bytes() for path in entries("")} == kept


def test_a_file_that_went_is_told_though_records_are_kept(folder: Path) -> None:
    texture = folder / Library([folder]).assets["cube_01"].texture
    texture.unlink()
    with pytest.raises(AssetError, match=f"cube_01: {texture.relative_to(folder)}: no such file"):
        Library([folder])


def _prepare(folder: Path) -> int:
    found = Library([folder])
    return sum(len(found.objs(asset)) for asset in found.assets)


def test_two_processes_may_prepare_at_once(folder: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        first, second = pool.map(_prepare, [folder, folder], chunksize=1)
    assert first == second
    check(Library([folder]), folder)
    assert list((cache_root() / "making").iterdir()) == []


def test_without_a_cache_models_are_read_all_the_same(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("SDGEN_CACHE", str(tmp_path / "file" / "below"))
    check(Library([folder]), folder)


def test_a_scratch_folder_stands_in_for_a_cache_that_cannot_be_written(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("")
    chosen = tmp_path / "file" / "below"
    monkeypatch.setenv("SDGEN_CACHE", str(chosen))
    with pytest.raises(AssetError, match="set SDGEN_CACHE to a folder that can"):
        Library([folder]).objs("cube_01")
    with usable_cache() as warning:
        assert warning is not None
        assert warning.startswith(f"{chosen}: Not a directory: ")
        path = Library([folder]).objs("cube_01")["body"]
        assert path.is_file()
    assert not path.exists()
    assert cache_root() == chosen


def test_what_a_killed_writer_left_is_cleared() -> None:
    dead = cache_root() / "making" / f"{PREFIX}dead"
    dead.mkdir(parents=True)
    (dead / "half").write_text("x")
    with usable_cache() as warning:
        assert warning is None
    assert not dead.exists()


def test_a_full_disk_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(self: Path, data: bytes) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(AssetError, match="cannot be written: No space left on device; make room"):
        write(cache_root() / "models", {"file": b"x"})
    assert list((cache_root() / "making").iterdir()) == []


def test_models_held_leave_half_of_the_files_a_process_may_open() -> None:
    source = "from sdgen.library import library; print(library._HELD)"
    limit = "import resource as r; r.setrlimit(r.RLIMIT_NOFILE, (300, 300)); "
    done = subprocess.run(
        [sys.executable, "-c", limit + source],
        capture_output=True,
        text=True,
        check=True,
    )
    assert int(done.stdout) == 150
