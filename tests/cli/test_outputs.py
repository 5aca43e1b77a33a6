"""-o of every command: what is no plain file stays what it is, - makes no file of that name."""

import json
import os
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from sdgen.cli.main import run

from tests import toy

Captured = pytest.CaptureFixture[str]

#: Commands that write one file, without -o and its value, and the ending they want.
WRITERS = {
    ".jsonl": ["detect", "SET", "--method", "never"],
    ".tar": ["export", "SET"],
    ".png": ["assets", "sheet", "mug_01", "--renderer", "cpu", "--size", "32"],
}


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=2))


def _args(ending: str, sound: Path, output: object) -> list[str]:
    words = [str(sound) if word == "SET" else word for word in WRITERS[ending]]
    return [*words, "-o", str(output)]


def _link(path: Path) -> None:
    path.with_name("target").write_text("mine")
    path.symlink_to("target")


def _null(path: Path) -> None:
    os.mknod(path, 0o600 | stat.S_IFCHR, os.makedev(1, 3))


@pytest.mark.parametrize("ending", WRITERS)
@pytest.mark.parametrize("make", [os.mkfifo, _link, _null])
def test_what_is_no_plain_file_is_refused(
    sound: Path, tmp_path: Path, capsys: Captured, ending: str, make: Callable[[Path], None]
) -> None:
    if make is _null and os.geteuid() != 0:
        pytest.skip("devices are made by root")
    place = tmp_path / f"o{ending}"
    make(place)
    kind = stat.S_IFMT(place.lstat().st_mode)
    assert run(_args(ending, sound, place)) == 1
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 1
    assert told[0].startswith(f"error: {place}: is a ")
    assert stat.S_IFMT(place.lstat().st_mode) == kind


@pytest.mark.parametrize("ending", WRITERS)
def test_a_folder_is_refused(sound: Path, tmp_path: Path, capsys: Captured, ending: str) -> None:
    (tmp_path / f"o{ending}").mkdir()
    assert run(_args(ending, sound, tmp_path / f"o{ending}")) in (1, 2)
    assert len(capsys.readouterr().err.splitlines()) == 1
    assert (tmp_path / f"o{ending}").is_dir()


def test_a_dash_is_standard_output_or_an_error_but_no_file(
    sound: Path, tmp_path: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(_args(".jsonl", sound, "-")) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [json.loads(line)["scene"] for line in lines] == ["000000", "000001"]
    assert run(_args(".tar", sound, "-")) == 1
    assert run(_args(".png", sound, "-")) == 2
    assert os.listdir(tmp_path) == []


def test_a_tar_needs_no_format(sound: Path, tmp_path: Path) -> None:
    assert run(["export", str(sound), "-o", str(tmp_path / "a.tar")]) == 0
    assert (tmp_path / "a.tar").is_file()


@pytest.mark.parametrize("place", ["scenes/000000/page", "scenes/page", ".build/page"])
def test_a_page_is_not_put_among_the_scenes(sound: Path, capsys: Captured, place: str) -> None:
    assert run(["view", str(sound), "-o", str(sound / place)]) == 1
    assert "belongs to the data set" in capsys.readouterr().err
    assert run(["validate", str(sound)]) == 0


def test_a_page_is_not_written_through_links(tmp_path: Path, capsys: Captured) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    (tmp_path / "mine").mkdir()
    (path / "view").symlink_to(tmp_path / "mine")
    assert run(["view", str(path)]) == 1
    assert "view: is a symbolic link" in capsys.readouterr().err
    (path / "view").unlink()
    assert run(["view", str(path)]) == 0
    for file in (path / "view" / "000000").iterdir():
        file.unlink()
    (path / "view" / "000000").rmdir()
    (path / "view" / "000000").symlink_to(tmp_path / "mine")
    assert run(["view", str(path)]) == 1
    assert "000000: is a symbolic link" in capsys.readouterr().err
    assert list((tmp_path / "mine").iterdir()) == []
