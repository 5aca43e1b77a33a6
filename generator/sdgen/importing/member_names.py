"""Names that strangers choose: may a file of this name be written, and can it lie beside others?

A name stays inside the folder it is written into, means the same on every system, and is no other
name's twin where capitals do not count.
"""

from __future__ import annotations

import re
import unicodedata
from pathlib import PurePosixPath

#: What file systems hold: bytes of one part, of all of it, and parts of it.
PART_BYTES = 255
NAME_BYTES = 1024
DEPTH = 32
#: Characters shown of a name in a message: a stranger's name may be a book.
_LONGEST_SHOWN = 80
_DRIVE = re.compile(r"[A-Za-z]:")


def shown_name(name: str) -> str:
    """A name as a message may show it: without control characters, its beginning where long."""
    cut = f"{name[:_LONGEST_SHOWN]}..." if len(name) > _LONGEST_SHOWN else name
    return plain(cut) or "(no name)"


def plain(text: str) -> str:
    """A text that holds words of strangers, without control characters."""
    return "".join(
        char if char.isprintable() else char.encode("unicode_escape").decode() for char in text
    )


def name_parts(name: str) -> tuple[str, ...]:
    """Parts of a member's name; none for the folder itself (``./``).

    Raises ValueError, with what is wrong, unless a file of this name stays in its folder.
    """
    if not name:
        raise ValueError("has no name")
    if any("\ud800" <= char <= "\udfff" for char in name):
        raise ValueError("its name is no UTF-8")
    if any(unicodedata.category(char) == "Cc" for char in name):
        raise ValueError("its name has a control character")
    if "\\" in name:
        raise ValueError("its name has a backslash")
    if name.startswith("/"):
        raise ValueError("is an absolute path")
    parts = PurePosixPath(name).parts  # without empty parts, "." and a "/" at the end
    if ".." in parts:
        raise ValueError("climbs out of its folder ('..')")
    if any(_DRIVE.match(part) for part in parts):
        raise ValueError("names a drive")
    if len(parts) > DEPTH:
        raise ValueError(f"is more than {DEPTH} folders deep")
    if any(len(part.encode()) > PART_BYTES for part in parts):
        raise ValueError(f"has a name of more than {PART_BYTES} bytes")
    if len("/".join(parts).encode()) > NAME_BYTES:
        raise ValueError(f"has a path of more than {NAME_BYTES} bytes")
    return parts


class Together:
    """Names of one folder so far: each comes once, however its letters are written."""

    def __init__(self) -> None:
        # As file systems compare that fold capitals or accents -> as written, and if a folder.
        self._taken: dict[tuple[str, ...], tuple[tuple[str, ...], bool]] = {}

    def __len__(self) -> int:
        return len(self._taken)

    def add(self, parts: tuple[str, ...], folder: bool) -> None:
        """Note a name. Raises ValueError, with what is wrong, when it cannot lie with the rest."""
        key = tuple(_folded(part) for part in parts)
        for depth in range(1, len(parts)):
            self._add(key[:depth], parts[:depth], True)
        if parts:
            self._add(key, parts, folder)

    def _add(self, key: tuple[str, ...], parts: tuple[str, ...], folder: bool) -> None:
        if key not in self._taken:
            self._taken[key] = (parts, folder)
            return
        there, is_folder = self._taken[key]
        if there != parts:
            twin = shown_name("/".join(there))
            raise ValueError(f"differs from {twin!r} only in capitals or accents' form")
        if is_folder != folder:
            raise ValueError("is both a file and a folder")
        if not folder:
            raise ValueError("comes twice")


def _folded(part: str) -> str:
    return unicodedata.normalize("NFC", unicodedata.normalize("NFD", part).casefold())
