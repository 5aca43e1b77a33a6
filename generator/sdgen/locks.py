"""An advisory lock on a file: one process at a time, let go even when that process dies.

The operating system keeps it (flock), so nothing is left to clean up after a kill. The package
``filelock`` falls back to marker files where flock is missing, and those outlive their owner.
"""

from __future__ import annotations

import errno
import os
from pathlib import Path

try:
    import fcntl
except ImportError:  # pragma: no cover - Windows: data sets can be read there, locks are POSIX's
    fcntl = None  # type: ignore[assignment]

#: What flock says on disks that keep no locks: Lustre and NFS as some clusters mount them.
_NO_LOCKS = (errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP)


class FileLock:
    """A lock that is held; made by :meth:`take`.

    ``kept`` is False where the system or the disk keeps no locks: then anybody may take it, and
    having it proves nothing.
    """

    def __init__(self, handle: int, kept: bool = True) -> None:
        self._handle = handle
        self.kept = kept

    @classmethod
    def take(cls, path: Path) -> FileLock | None:
        """Lock this file, made when missing; None when another process holds it.

        Raises OSError when the file's folder is not there or may not be written.
        """
        while True:
            handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
            if fcntl is None:
                return cls(handle, kept=False)
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                if error.errno in _NO_LOCKS:
                    return cls(handle, kept=False)
                os.close(handle)
                return None
            # Whoever held it before may have removed the file meanwhile: then this lock is void.
            try:
                same = os.fstat(handle).st_ino == os.stat(path).st_ino
            except FileNotFoundError:
                same = False
            if same:
                return cls(handle)
            os.close(handle)

    def release(self) -> None:
        """Let others in; the file stays. A second call does nothing."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1
