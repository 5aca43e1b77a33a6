"""Bytes of the files that a manifest names: bounded, whatever lies there."""

from __future__ import annotations

from pathlib import Path

from sdgen.errors import AssetError, InputError
from sdgen.files import read_plain

#: More than the largest texture takes (8192 x 8192 pixels) that nobody has compressed: 268 MB.
MAX_BYTES = 300_000_000


def file_bytes(path: Path, max_bytes: int = MAX_BYTES) -> bytes:
    """The bytes of a file; links are followed.

    Raises AssetError, located, for what is missing, unreadable, too large or no file.
    """
    try:
        return read_plain(path, str(path), max_bytes)
    except InputError as error:
        raise AssetError(error.problems) from None
