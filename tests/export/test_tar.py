"""One tar file: the same bytes twice, only what the manifest lists, nothing dangerous."""

import os
import shutil
import tarfile
from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.errors import InputError, SdgenError, UsageError
from sdgen.export import export
from sdgen.export.tar import export_tar
from sdgen.validate import validate

from tests import toy

#: The archive is our own; the filter came with Python 3.11.4.
SAFE = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return toy.build(tmp_path / "d", toy.small(n=2))


@pytest.mark.parametrize("name", ["a.tar", "a.tar.gz"])
def test_same_data_set_same_bytes(path: Path, tmp_path: Path, name: str) -> None:
    one, two = tmp_path / "1" / name, tmp_path / "2" / f"other-{name}"
    export(Dataset(path), "tar", one)
    for file in path.rglob("*"):
        os.utime(file, (2e9, 2e9))
        file.chmod(0o700)
    copied = Path(shutil.copytree(path, tmp_path / "moved"))
    export(Dataset(copied), "tar", two)
    assert one.read_bytes() == two.read_bytes()


def test_unpacked_it_is_the_data_set_again(path: Path, tmp_path: Path) -> None:
    export_tar(Dataset(path), tmp_path / "a.tar")
    with tarfile.open(tmp_path / "a.tar") as archive:
        archive.extractall(tmp_path / "out", **SAFE)
    (root,) = (tmp_path / "out").iterdir()
    assert root.name == "sdgen-n2-s7"
    assert validate(root) == []


def test_members_are_sorted_plain_and_nobodys(path: Path, tmp_path: Path) -> None:
    (path / "secret.txt").write_text("not listed")
    export_tar(Dataset(path), tmp_path / "a.tar")
    with tarfile.open(tmp_path / "a.tar") as archive:
        members = archive.getmembers()
    names = [m.name for m in members]
    assert names == sorted(names, key=lambda n: ("/scenes/" in n, n))
    assert not any("secret" in name or name.startswith("/") or ".." in name for name in names)
    told = {(m.type, m.mode, m.mtime, m.uid, m.gid, m.uname, m.gname) for m in members}
    assert told == {(tarfile.REGTYPE, 0o644, 0, 0, 0, "", "")}


def _link_file(path: Path) -> None:
    target = path / "scenes/000001/graph.json"
    target.rename(path / "moved.json")
    target.symlink_to(path / "moved.json")


def _link_folder(path: Path) -> None:
    (path / "scenes/000001").rename(path / "moved")
    (path / "scenes/000001").symlink_to(path / "moved")


def _fifo(path: Path) -> None:
    (path / "scenes/000001/graph.json").unlink()
    os.mkfifo(path / "scenes/000001/graph.json")


def _changed(path: Path) -> None:
    (path / "scenes/000001/graph.json").write_text("{}")


def _gone(path: Path) -> None:
    (path / "catalogue.json").unlink()


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (_link_file, "graph.json: a symbolic link leads elsewhere"),
        (_link_folder, "000001/anomalies.json: a symbolic link leads elsewhere"),
        (_fifo, "graph.json: is a FIFO, not a file"),
        (_changed, "graph.json: changed since"),
        (_gone, "catalogue.json: no such file"),
    ],
)
def test_odd_files_are_refused_and_nothing_is_left(
    path: Path, tmp_path: Path, damage: object, words: str
) -> None:
    assert callable(damage)
    damage(path)
    with pytest.raises(InputError, match=words):
        export_tar(Dataset(path), tmp_path / "out" / "a.tar")
    assert list((tmp_path / "out").iterdir()) == []


def test_a_failed_export_keeps_the_older_file(path: Path, tmp_path: Path) -> None:
    (tmp_path / "a.tar").write_text("older")
    _gone(path)
    with pytest.raises(InputError):
        export_tar(Dataset(path), tmp_path / "a.tar")
    assert (tmp_path / "a.tar").read_text() == "older"


@pytest.mark.parametrize("name", ["a.zip", "a", "d/a.tar", "d/scenes/a.tar"])
def test_bad_places_are_refused(path: Path, tmp_path: Path, name: str) -> None:
    with pytest.raises(SdgenError):
        export_tar(Dataset(path), tmp_path / name)
    assert validate(path) == []


def test_an_unknown_format_names_the_known_ones(path: Path, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"no format 'zip' .*tar.*webdataset"):
        export(Dataset(path), "zip", tmp_path / "a.tar")
    with pytest.raises(UsageError, match=r"no format 'tra' .did you mean 'tar'"):
        export(Dataset(path), "tra", tmp_path / "a.tar")
