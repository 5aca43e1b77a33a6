"""Files named with -o: whole or not at all, and never in the place of what is no plain file."""

import os
import socket
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from sdgen.dataset.output_file import output_file, refuse_mixed, write_output
from sdgen.errors import SdgenError

from tests import toy


def _device(path: Path) -> None:
    os.mknod(path, 0o600 | stat.S_IFCHR, os.makedev(1, 3))


def _socket(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as bound:
        bound.bind(str(path))


def _link(path: Path) -> None:
    path.with_name("target").write_text("mine")
    path.symlink_to("target")


def _dangling(path: Path) -> None:
    path.symlink_to("nowhere")


#: What may stand at the place -> what the error calls it.
ODD: dict[str, Callable[[Path], None]] = {
    "a device": _device,
    "a FIFO": os.mkfifo,
    "a socket": _socket,
    "a folder": Path.mkdir,
    "a symbolic link": _link,
    "a symbolic link;": _dangling,
}


@pytest.mark.parametrize("words", ODD)
def test_only_a_plain_file_is_written_over(tmp_path: Path, words: str) -> None:
    if words == "a device" and os.geteuid() != 0:
        pytest.skip("devices are made by root")
    place = tmp_path / "o"
    ODD[words](place)
    before = (
        place.lstat().st_ino,
        stat.S_IFMT(place.lstat().st_mode),
        sorted(os.listdir(tmp_path)),
    )
    with pytest.raises(SdgenError, match=f"o: is {words}"):
        write_output(place, b"new")
    after = (place.lstat().st_ino, stat.S_IFMT(place.lstat().st_mode), sorted(os.listdir(tmp_path)))
    assert after == before
    assert not (tmp_path / "target").exists() or (tmp_path / "target").read_text() == "mine"


def test_what_appears_meanwhile_is_not_written_over(tmp_path: Path) -> None:
    def write() -> None:
        with output_file(tmp_path / "o"):
            os.mkfifo(tmp_path / "o")

    with pytest.raises(SdgenError, match="is a FIFO"):
        write()
    assert os.listdir(tmp_path) == ["o"]


def test_a_link_in_the_partial_files_place_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("mine")
    (tmp_path / ".o.partial").symlink_to("mine")
    write_output(tmp_path / "o", b"new")
    assert (tmp_path / "mine").read_text() == "mine"
    assert sorted(os.listdir(tmp_path)) == ["mine", "o"]


def test_whole_or_not_at_all(tmp_path: Path) -> None:
    place = tmp_path / "made" / "on the way" / "o"
    write_output(place, b"old")

    def fail() -> None:
        with output_file(place) as file:
            file.write(b"half")
            raise OSError("full")

    with pytest.raises(OSError, match="full"):
        fail()
    assert place.read_bytes() == b"old"
    write_output(place, b"new")
    assert place.read_bytes() == b"new"
    assert os.listdir(place.parent) == ["o"]


def test_an_output_is_no_input_and_no_part_of_another(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "in")
    refuse_mixed([tmp_path / "a", tmp_path / "b" / "c"], [tmp_path / "in", tmp_path / "b" / "d"])
    for outputs in (
        ["in"],
        ["link"],
        ["x/../in"],
        ["a", "a"],
        ["a", "a/b"],
        ["a/b/c", "a"],
        ["in/x"],
    ):
        with pytest.raises(SdgenError, match="choose another place"):
            refuse_mixed([tmp_path / name for name in outputs], [tmp_path / "in"])


def test_standard_output_is_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SdgenError, match="not to standard output"):
        write_output(Path("-"), b"new")
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(
    "name", ["manifest.jsonl", "README.md", "scenes", "scenes/000000/p.jsonl", ".build/p.jsonl"]
)
def test_data_sets_keep_what_is_theirs(tmp_path: Path, name: str) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    with pytest.raises(SdgenError, match=r"belongs to the data set|is a folder"):
        write_output(path / name, b"new")
    write_output(path / "predictions.jsonl", b"new")
    (tmp_path / "mine" / "scenes").mkdir(parents=True)
    write_output(tmp_path / "mine" / "scenes" / "p.jsonl", b"new")
