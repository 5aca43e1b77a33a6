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
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sdgen.locks import FileLock

PREFIX = "sdgen-scratch-"
_LOCK = "lock"
#: Seconds between two looks for what is left.
_LOOK_S = 0.05


@contextmanager
def scratch_folder(within: Path | None = None, of: str = "") -> Iterator[Path]:
    """A folder that is there inside ``with`` and gone after it, whatever happened.

    It lies in ``within``; None is the system's folder for temporary files. ``of`` names the
    owner, for :func:`clear_all_of`.
    """
    clear_dead(within)
    folder, lock = _make(within, of)
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        lock.release()


def _make(within: Path | None, of: str) -> tuple[Path, FileLock]:
    while True:
        folder = Path(tempfile.mkdtemp(prefix=f"{PREFIX}{of}", dir=within))
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


def clear_all_of(of: str, quiet_s: float, patience_s: float) -> None:
    """Take away what owners named ``of`` leave behind that were killed but may not be dead yet.

    Done when there has been none of theirs for ``quiet_s``, or after ``patience_s``.
    """
    end = time.monotonic() + patience_s
    since = time.monotonic()
    while time.monotonic() < end and time.monotonic() - since < quiet_s:
        clear_dead()
        if any(Path(tempfile.gettempdir()).glob(f"{PREFIX}{of}*")):
            since = time.monotonic()
        time.sleep(_LOOK_S)
