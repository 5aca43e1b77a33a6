"""Asset folders checked: their files are read once, whoever shares the work."""

from pathlib import Path

import pytest
from sdgen.cli.main import run
from sdgen.library import Library

from tests.fakes import write_library


def test_the_files_of_a_folder_are_all_read_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = write_library(tmp_path / "mine")
    read: list[Path] = []
    checked = Library.check_files

    def check_files(library: Library, of: Path) -> None:
        read.append(of)
        checked(library, of)

    monkeypatch.setattr(Library, "check_files", check_files)
    assert run(["assets", "validate", str(folder), "--only", "cube_01", "--workers", "1"]) == 1
    told = capsys.readouterr()
    assert "cube_01 (test): size: no catalogue gives a size for the category 'cube'" in told.out
    assert "1 models checked" in told.err
    assert read == [folder]


def test_a_broken_file_of_the_folder_is_told_before_models_are_checked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = write_library(tmp_path / "mine")
    (folder / "textures/surface_w.png").write_bytes(b"nothing")
    assert run(["assets", "validate", str(folder), "--only", "cube_01", "--workers", "1"]) == 1
    told = capsys.readouterr()
    assert "surface_w.png: texture is neither PNG nor JPEG" in told.err
    assert "checked" not in told.err
