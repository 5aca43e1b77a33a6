"""Writing so that a file or folder is there whole or not at all, and one build a folder."""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
from pathlib import Path

from sdgen.errors import SdgenError

try:
    import fcntl
except ImportError:  # pragma: no cover - Windows: data sets can be read there, locks are POSIX's
    fcntl = None  # type: ignore[assignment]


def sha256_hex(data: bytes) -> str:
    """Digest as 64 hex digits."""
    return hashlib.sha256(data).hexdigest()


def file_sha256(path: Path) -> str:
    """Digest of a file, read in pieces."""
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while piece := file.read(1 << 20):
            digest.update(piece)
    return digest.hexdigest()


def write_synced(path: Path, data: bytes) -> None:
    """Write a new file and make sure it has reached the disk."""
    with path.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def sync_file(path: Path) -> None:
    """Wait until a file's bytes are on the disk. OSError when they cannot be (a full disk)."""
    handle = os.open(path, os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def sync_folder(path: Path) -> None:
    """Make renames inside a folder durable (a no-op where the file system has no such thing)."""
    with contextlib.suppress(OSError):
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def replace_file(path: Path, data: bytes) -> None:
    """Write a file so that others see the old one or the new one, whole."""
    partial = path.with_name(f".{path.name}.partial")
    try:
        write_synced(partial, data)
        os.replace(partial, path)
    except OSError:
        partial.unlink(missing_ok=True)
        raise
    sync_folder(path.parent)


def remove_tree(path: Path) -> None:
    """Remove a folder and what is in it, or a file; nothing happens when it is not there."""
    if path.is_symlink() or path.is_file():
        path.unlink()
    elif path.exists():
        shutil.rmtree(path)


class FolderLock:
    """An advisory lock on a file: one process at a time, released even when the process dies."""

    def __init__(self, path: Path, what: str) -> None:
        self.path = path
        while True:
            self._handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
            if fcntl is None:
                return
            try:
                fcntl.flock(self._handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                os.close(self._handle)
                raise SdgenError(
                    f"{what}: another build is writing here; wait for it, or choose another --out"
                ) from None
            # Whoever held it before may have removed the file meanwhile: then this lock is void.
            try:
                same = os.fstat(self._handle).st_ino == os.stat(path).st_ino
            except FileNotFoundError:
                same = False
            if same:
                return
            os.close(self._handle)

    def release(self) -> None:
        """Let others in; the file stays. A second call does nothing."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1
