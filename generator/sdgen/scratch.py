"""Scratch folders: gone when their owner ends, by default in the system's temporary files.

Its owner holds a lock in it for as long as it lives, so a folder whose lock is free belongs to
nobody any more, however its owner ended; the next build takes such folders away. (A process
number would not do: it is used again, and means another process in another container.) Where no
locks are kept, nobody's folder is taken away but by its owner.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sdgen.locks import FileLock

PREFIX = "sdgen-scratch-"
_LOCK = "lock"


@contextmanager
def scratch_folder(within: Path | None = None) -> Iterator[Path]:
    """A folder that is there inside ``with`` and gone after it, whatever happened.

    It lies in ``within``; None is the system's folder for temporary files.
    """
    clear_dead(within)
    folder, lock = _make(within)
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        lock.release()


def _make(within: Path | None) -> tuple[Path, FileLock]:
    while True:
        folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=within))
        try:
            lock = FileLock.take(folder / _LOCK)
        except FileNotFoundError:
            continue
        # Another build may have taken the folder for a dead one before the lock was held.
        if lock is not None:
            return folder, lock


def clear_dead(within: Path | None = None) -> None:
    """Take away this user's scratch folders in ``within`` whose owners are gone."""
    for folder in (within or Path(tempfile.gettempdir())).glob(f"{PREFIX}*"):
        try:
            mine = not hasattr(os, "getuid") or folder.lstat().st_uid == os.getuid()
            if not mine or folder.is_symlink() or not folder.is_dir():
                continue
            lock = FileLock.take(folder / _LOCK)
        except OSError:
            continue
        if lock is not None:
            if lock.kept:
                shutil.rmtree(folder, ignore_errors=True)
            lock.release()
