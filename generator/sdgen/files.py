"""Bytes of a plain file, whatever stands at its path: nothing hangs, nothing is read for ever."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from sdgen.errors import InputError

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFLNK: "a symbolic link",
    stat.S_IFIFO: "a FIFO",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}


#: Flags for opening; other systems lack some of them, and what they stand for.
_PLAIN = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_NONBLOCK", "O_CLOEXEC", "O_BINARY"))
_NO_LINKS = getattr(os, "O_NOFOLLOW", 0)


def open_plain(path: Path, shown: str, links: bool = True) -> BinaryIO:
    """A file opened for reading, whose first bytes tell what it is; close it.

    Raises InputError ``shown: problem`` for what is missing, unreadable or no file, and for a link
    where these are not followed. It is opened without waiting, or a FIFO that nobody writes to
    would hold us for ever.
    """
    if not links and path.is_symlink():
        raise InputError([f"{shown}: is a symbolic link, not a file"])
    with _located(shown):
        # Not through a link that somebody puts there meanwhile, either.
        handle = os.open(path, _PLAIN if links else _PLAIN | _NO_LINKS)
    mode = os.fstat(handle).st_mode
    if not stat.S_ISREG(mode):
        os.close(handle)
        raise InputError([f"{shown}: is {kind_of(mode)}, not a file"])
    return os.fdopen(handle, "rb")


def read_plain(path: Path, shown: str, max_bytes: int, links: bool = True) -> bytes:
    """The bytes of a file of at most ``max_bytes``.

    Raises InputError where ``open_plain`` does, and for what is too large.
    """
    with open_plain(path, shown, links) as stream, _located(shown):
        size = os.fstat(stream.fileno()).st_size
        if size > max_bytes:
            raise _too_large(shown, max_bytes)
        raw = stream.read(size + 1)  # as much room is made, so not the limit at once
        if len(raw) > size:  # it grows, or it is one of the system's that tell no size
            raw += stream.read(max_bytes - size)
    if len(raw) > max_bytes:
        raise _too_large(shown, max_bytes)
    return raw


def lines_of(path: Path, shown: str, max_bytes: int) -> Iterator[tuple[int, bytes]]:
    """Lines of a file that is no link, numbered from 1, each of at most ``max_bytes``.

    Raises InputError where ``read_plain`` does.
    """
    with open_plain(path, shown, links=False) as stream:
        number = 0
        while True:
            with _located(shown):
                line = stream.readline(max_bytes + 1)
            if not line:
                return
            number += 1
            if len(line) > max_bytes:
                raise _too_large(f"{shown}:{number}", max_bytes)
            yield number, line


def kind_of(mode: int) -> str:
    """What a file that is no plain file is, by its mode."""
    return _KINDS.get(stat.S_IFMT(mode), "something else")


def _too_large(shown: str, max_bytes: int) -> InputError:
    return InputError([f"{shown}: is larger than {max_bytes // 1000} kB"])


@contextmanager
def _located(shown: str) -> Iterator[None]:
    try:
        yield
    except (FileNotFoundError, NotADirectoryError):
        raise InputError([f"{shown}: no such file"]) from None
    except OSError as error:
        raise InputError([f"{shown}: cannot be read ({error.strerror})"]) from None
    except ValueError:  # a NUL in the name
        raise InputError([f"{shown!r}: no such file"]) from None
