"""Scratch folders: gone when their owner ends, by default in the system's temporary files.

Its owner holds a lock in it for as long as it lives, so a folder whose lock is free belongs to
nobody any more, however its owner ended; the next build takes such folders away. (A process
number would not do: it is used again, and means another process in another container.)
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path
from types import TracebackType

from sdgen.locks import FileLock

PREFIX = "sdgen-scratch-"
_LOCK = "lock"


class Scratch:
    """A folder that is there inside ``with`` and gone after it, whatever happened.

    It lies in ``within``; None is the system's folder for temporary files.
    """

    def __init__(self, within: Path | None = None) -> None:
        self._within = within

    def __enter__(self) -> Path:
        clear_dead(self._within)
        while True:
            folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=self._within))
            try:
                lock = FileLock.take(folder / _LOCK)
            except FileNotFoundError:
                continue
            # Another build may have taken the folder for a dead one before the lock was held.
            if lock is not None:
                self._folder, self._lock = folder, lock
                return folder

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        shutil.rmtree(self._folder, ignore_errors=True)
        self._lock.release()


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
            shutil.rmtree(folder, ignore_errors=True)
            lock.release()
