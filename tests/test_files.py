"""Files are read up to a limit, and nothing that is none is waited for."""

import os
from pathlib import Path

import pytest
from sdgen.errors import InputError
from sdgen.files import lines_of, open_plain, read_plain


def test_up_to_the_limit_it_is_read(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"x" * 2000)
    assert read_plain(path, "a", 2000) == b"x" * 2000
    with pytest.raises(InputError, match=r"^a: is larger than 1 kB"):
        read_plain(path, "a", 1999)


def test_what_is_far_too_large_is_not_read_at_all(tmp_path: Path) -> None:
    with (tmp_path / "a").open("wb") as file:
        file.truncate(50 * 10**9)
    with pytest.raises(InputError, match=r"^a: is larger than"):
        read_plain(tmp_path / "a", "a", 10**12 // 100)


def test_what_tells_no_size_is_read_too() -> None:
    path = Path("/proc/self/limits")
    if not path.exists():
        pytest.skip("Linux only")
    assert b"Max open files" in read_plain(path, "limits", 10**6)
    with pytest.raises(InputError, match="is larger than"):
        read_plain(path, "limits", 100)


def test_links_are_followed_where_they_may_be(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"x")
    (tmp_path / "b").symlink_to(tmp_path / "a")
    assert read_plain(tmp_path / "b", "b", 9) == b"x"
    for reader in (
        lambda: read_plain(tmp_path / "b", "b", 9, links=False),
        lambda: list(lines_of(tmp_path / "b", "b", 9)),
    ):
        with pytest.raises(InputError, match=r"^b: is a symbolic link, not a file"):
            reader()


def test_lines_are_numbered_and_bounded_one_by_one(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes(b"one\n\nthree")
    assert list(lines_of(path, "a", 5)) == [(1, b"one\n"), (2, b"\n"), (3, b"three")]
    found = lines_of(path, "a", 4)
    assert [next(found), next(found)] == [(1, b"one\n"), (2, b"\n")]
    with pytest.raises(InputError, match=r"^a:3: is larger than"):
        next(found)


def test_an_error_of_who_reads_is_not_taken_for_one_of_the_file(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"x")
    with pytest.raises(OSError, match="full"), open_plain(tmp_path / "a", "a"):
        raise OSError(28, "full")


@pytest.mark.parametrize("name", ["fifo", "folder", "none", "a/b", "nul\0"])
def test_what_is_no_file_is_said_at_once(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / "fifo")
    (tmp_path / "folder").mkdir()
    (tmp_path / "a").write_bytes(b"")
    with pytest.raises(InputError, match=r"is a FIFO|is a folder|no such file"):
        open_plain(tmp_path / name, name)
