"""Bytes of a plain file, whatever stands at its path: nothing hangs, nothing is read for ever."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from sdgen.errors import InputError

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a FIFO",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}


def read_plain(path: Path, shown: str, max_bytes: int) -> bytes:
    """The bytes of a file of at most ``max_bytes``; links are followed.

    Raises InputError ``shown: problem`` for what is missing, unreadable, too large or no file. It
    is opened without waiting, or a FIFO that nobody writes to would hold us for ever.
    """
    try:
        with open(path, "rb", opener=_without_waiting) as stream:
            mode = os.fstat(stream.fileno()).st_mode
            if not stat.S_ISREG(mode):
                raise InputError([f"{shown}: is {kind_of(mode)}, not a file"])
            raw = stream.read(max_bytes + 1)
    except (FileNotFoundError, NotADirectoryError):
        raise InputError([f"{shown}: no such file"]) from None
    except IsADirectoryError:
        raise InputError([f"{shown}: is a folder, not a file"]) from None
    except OSError as error:
        raise InputError([f"{shown}: cannot be read ({error.strerror})"]) from None
    except ValueError:  # a NUL in the name
        raise InputError([f"{shown!r}: no such file"]) from None
    if len(raw) > max_bytes:
        raise InputError([f"{shown}: is larger than {max_bytes // 1000} kB"])
    return raw


def kind_of(mode: int) -> str:
    """What a file that is no plain file is, by its mode."""
    return _KINDS.get(stat.S_IFMT(mode), "something else")


def _without_waiting(path: str, flags: int) -> int:
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))  # Windows has neither
