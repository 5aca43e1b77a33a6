"""Archives that strangers send, unpacked: whole and inside their folder, or not at all.

zip, tar, and tar packed by gzip, bzip2 or xz, told by their content. Names, kinds and sizes are
checked before a byte is written; sizes are counted as they come, whatever headers say. Nothing
nested is opened: an importer whose source ships archives in an archive calls this again.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from sdgen.errors import AssetError, InputError, naming
from sdgen.files import open_plain
from sdgen.importing.archive_members import BadArchive, Member, archive_kind, members_of
from sdgen.importing.member_names import Together, name_parts, shown_name
from sdgen.scratch import scratch_folder


@dataclass(frozen=True)
class Limits:
    """How much an archive may hold.

    ``ratio`` is how often its own size it may unpack to, once that is more than ``ratio_from``
    bytes: models unpack to at most 8 times theirs, bombs to a thousand times.
    """

    members: int = 20_000
    member_bytes: int = 300_000_000
    total_bytes: int = 4_000_000_000
    ratio: int = 100
    ratio_from: int = 50_000_000


DEFAULT_LIMITS = Limits()


def is_archive(path: Path) -> bool:
    """True for a plain file that begins as an archive we read does (or as one packed file)."""
    try:
        with open_plain(path, str(path)) as file:
            return bool(archive_kind(file.read(512)))
    except (InputError, OSError):
        return False


def unpack(path: Path, into: Path, limits: Limits = DEFAULT_LIMITS, shown: str = "") -> Path:
    """Unpack the archive at ``path`` into the new (or empty) folder ``into``, and return it.

    ``shown`` is what problems call the archive (default: the path). Raises AssetError with all
    problems, each ``archive: member: problem``, when it is damaged, holds anything that is no
    plain file or folder of its own, or exceeds ``limits``; OSError when the disk is full. Then
    ``into`` is as it was.
    """
    name = shown or str(path)
    if into.is_symlink() or (into.exists() and not (into.is_dir() and not any(into.iterdir()))):
        raise AssetError([f"{into}: is there already; unpack into a new folder"])
    into.parent.mkdir(parents=True, exist_ok=True)
    with open_plain(path, name) as file, scratch_folder(into.parent) as scratch:
        staged = scratch / "unpacked"
        staged.mkdir()
        work = _Unpacking(staged, os.fstat(file.fileno()).st_size, limits)
        try:
            with naming(into):
                work.run(file)
        except BadArchive as error:
            work.problems.append(str(error))
        if work.problems:
            raise AssetError([f"{name}: {problem}" for problem in work.problems])
        os.replace(staged, into)
    return into


class _Unpacking:
    """One archive on its way into ``staged``. After the first problem no more is written, but
    names are read on, so that all problems are told at once."""

    def __init__(self, staged: Path, packed_bytes: int, limits: Limits) -> None:
        self.problems: list[str] = []
        self._staged = staged
        self._limits = limits
        self._spent = 0
        self._bomb_from = max(limits.ratio_from, limits.ratio * packed_bytes)

    def run(self, file: BinaryIO) -> None:
        """Raises BadArchive when the rest cannot be read."""
        kind = archive_kind(file.read(512))
        if not kind:
            raise BadArchive("is no zip and no tar archive")
        file.seek(0)
        self._all(members_of(file, kind, self._spend))

    def _all(self, members: Iterator[Member]) -> None:
        together = Together()
        files = 0
        for number, member in enumerate(members, start=1):
            if number > self._limits.members:
                raise BadArchive(f"holds more than {self._limits.members} members")
            if len(together) > 2 * self._limits.members:
                raise BadArchive(f"holds more than {self._limits.members} folders")
            try:
                if member.refused:
                    raise ValueError(member.refused)
                parts = name_parts(member.name)
                if not parts and not member.folder:
                    raise ValueError("has no name")
                together.add(parts, member.folder)
                if member.size > self._limits.member_bytes:
                    raise ValueError(f"is larger than {_megabytes(self._limits.member_bytes)}")
            except ValueError as error:
                self.problems.append(f"{shown_name(member.name)}: {error}")
                continue
            files += not member.folder
            if not self.problems:
                self._write(member, self._staged.joinpath(*parts))
        if not files and not self.problems:
            raise BadArchive("holds no file")

    def _write(self, member: Member, target: Path) -> None:
        if member.folder:
            target.mkdir(parents=True, exist_ok=True)
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        size = 0
        try:
            with target.open("xb") as out:  # never over anything, never through a link
                for piece in member.pieces():
                    size += len(piece)
                    if size > self._limits.member_bytes:
                        raise BadArchive(f"is larger than {_megabytes(self._limits.member_bytes)}")
                    out.write(piece)
        except BadArchive as error:
            raise BadArchive(f"{shown_name(member.name)}: {error}") from None

    def _spend(self, count: int) -> None:
        """Note bytes that came out of the archive."""
        self._spent += count
        if self._spent > self._limits.total_bytes:
            raise BadArchive(f"unpacks to more than {_megabytes(self._limits.total_bytes)}")
        if self._spent > self._bomb_from:
            raise BadArchive(f"unpacks to more than {self._limits.ratio} times its size: a bomb")


def _megabytes(count: int) -> str:
    return f"{count // 1_000_000} MB"
