"""Scratch folders: gone at the end, whatever the end was; nobody else's are touched."""

import errno
import os
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import pytest
from sdgen import locks
from sdgen.locks import FileLock
from sdgen.scratch import PREFIX, clear_all_of, clear_dead, scratch_folder


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    return tmp_path


def test_it_is_gone_after_an_error_too(place: Path) -> None:
    def interrupted() -> None:
        with scratch_folder() as folder:
            (folder / "deep" / "er").mkdir(parents=True)
            (folder / "deep" / "file").write_text("x")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert list(place.iterdir()) == []


def test_only_those_of_the_dead_are_cleared(place: Path) -> None:
    dead = place / f"{PREFIX}dead"
    dead.mkdir()
    (dead / "lock").touch()
    (dead / "rest").write_text("x")
    unlocked = place / f"{PREFIX}never-locked"
    unlocked.mkdir()
    (place / "sdgen-other").mkdir()
    elsewhere = place / "elsewhere"
    elsewhere.mkdir()
    (place / f"{PREFIX}link").symlink_to(elsewhere)
    with scratch_folder() as living:
        clear_dead()
        with scratch_folder():
            assert living.is_dir()
        assert {p.name for p in place.iterdir()} == {
            living.name,
            "sdgen-other",
            "elsewhere",
            f"{PREFIX}link",
        }


def test_another_user_s_folder_is_left_alone(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = place / f"{PREFIX}theirs"
    folder.mkdir()
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    clear_dead()
    assert folder.is_dir()


def test_a_folder_taken_for_dead_while_it_was_born_is_replaced(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    make = tempfile.mkdtemp
    born = []

    def stolen_once(prefix: str, dir: Path | None) -> str:
        path = make(prefix=prefix, dir=dir)
        born.append(path)
        if len(born) == 1:
            os.rmdir(path)
        return path

    monkeypatch.setattr("sdgen.scratch.tempfile.mkdtemp", stolen_once)
    with scratch_folder() as folder:
        assert str(folder) == born[1]


@pytest.mark.parametrize("why", [errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP])
def test_on_a_disk_without_locks_folders_come_and_only_their_owners_end_them(
    place: Path, monkeypatch: pytest.MonkeyPatch, why: int
) -> None:
    asked = []

    def refused(handle: int, how: int) -> None:
        asked.append(handle)
        assert len(asked) < 10, "folder after folder is made"
        raise OSError(why, os.strerror(why))

    monkeypatch.setattr(locks.fcntl, "flock", refused)
    with scratch_folder() as first, scratch_folder() as second:
        clear_dead()
        assert first.is_dir()
        assert second.is_dir()
    assert list(place.iterdir()) == []


def test_without_locks_no_living_folder_is_taken_for_dead(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(locks, "fcntl", None)
    with scratch_folder() as first, scratch_folder():
        assert first.is_dir()
    assert list(place.iterdir()) == []


def test_a_lock_is_held_by_one_until_it_is_let_go(tmp_path: Path) -> None:
    first = FileLock.take(tmp_path / "lock")
    assert first is not None
    assert FileLock.take(tmp_path / "lock") is None
    first.release()
    first.release()
    second = FileLock.take(tmp_path / "lock")
    assert second is not None
    second.release()


def test_those_of_a_killed_owner_go_when_it_is_dead(place: Path) -> None:
    code = (
        "import time; from sdgen.scratch import scratch_folder\n"
        "with scratch_folder(of='mine-'): print('ready', flush=True); time.sleep(60)"
    )
    env = {**os.environ, "TMPDIR": str(place)}
    with (
        subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, env=env) as owner,
        scratch_folder(of="other-") as other,
    ):
        assert owner.stdout is not None
        owner.stdout.readline()
        dying = threading.Timer(0.3, owner.kill)
        dying.start()
        clear_all_of("mine-", quiet_s=0.2, patience_s=20)
        assert [path.name for path in place.iterdir()] == [other.name]


def test_a_folder_held_on_does_not_keep_the_sweep_for_ever(place: Path) -> None:
    with scratch_folder(of="mine-") as held:
        clear_all_of("mine-", quiet_s=0.2, patience_s=0.3)
        assert held.is_dir()
