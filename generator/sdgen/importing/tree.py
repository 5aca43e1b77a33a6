"""The folder that an import reads from: what a model refers to is looked up in it, never beyond.

References of scans are often wrong: a texture lies in another folder than its material says, a
path is that of the maker's machine, an address names a package. What is found by its name alone,
near the model, is told.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote

from sdgen.errors import AssetError, InputError
from sdgen.files import read_plain

#: A text mesh of two million faces takes 200 MB; no wrapper or texture more.
MAX_BYTES = 400_000_000
#: Files below one model that are looked through for what it names.
_MOST_FILES = 5_000
_NETWORK = re.compile(r"^(https?|ftp|s3|gs)://", re.IGNORECASE)
_SCHEME = re.compile(r"^(model|package|file)://+", re.IGNORECASE)
_DRIVE = re.compile(r"^[A-Za-z]:")


#: How files begin in whose place a clone without Git LFS has pointers.
_LFS = b"version https://git-lfs.github.com/spec/"


@dataclass
class References:
    """How one model's references were followed.

    ``root`` bounds what may be read, ``folder`` is the model's own; ``notes`` are for people.
    """

    root: Path
    folder: Path
    notes: list[str] = field(default_factory=list)
    read: list[Path] = field(default_factory=list)

    def note(self, text: str) -> None:
        """Tell something once."""
        if text not in self.notes:
            self.notes.append(text)

    def bytes_of(self, path: Path, max_bytes: int = MAX_BYTES) -> bytes:
        """The bytes of a file inside the root. Raises AssetError, located, for any other."""
        if not inside(self.root, path):
            raise AssetError([f"{self.shown(path)}: lies outside {self.root.name}"])
        try:
            data = read_plain(path, self.shown(path), max_bytes)
        except InputError as error:
            raise AssetError(error.problems) from None
        if data.startswith(_LFS):
            why = "a pointer of Git LFS, not the file itself: run `git lfs pull` there"
            raise AssetError([f"{self.shown(path)}: {why}"])
        if path not in self.read:
            self.read.append(path)
        return data

    def shown(self, path: Path) -> str:
        """A path as people know it: from the root on."""
        try:
            return path.relative_to(self.root).as_posix()
        except ValueError:
            return str(path)

    def find(self, base: Path, reference: str) -> Path | None:
        """The file that ``reference``, written in a file of the folder ``base``, means; None when
        there is none inside the root. Says so when it is not where the reference says."""
        asked = unquote(reference.strip().strip("\"'")).replace("\\", "/")
        if not asked or "\0" in asked:
            return None
        if _NETWORK.match(asked):
            self.note(f"{asked}: lies on the network, which is not read")
            return None
        for path in self._named(base, asked):
            if is_file(path) and inside(self.root, path):
                return path
        found = self._by_name(asked)
        if found is not None:
            self.note(f"{asked}: taken from {found.relative_to(self.folder).as_posix()}")
        return found

    def _named(self, base: Path, asked: str) -> Iterator[Path]:
        """Where a reference may point at, the likeliest first."""
        scheme = _SCHEME.match(asked)
        bare = asked[scheme.end() :] if scheme else asked
        if _DRIVE.match(bare) or (bare.startswith("/") and not scheme):
            return
        if not scheme:
            yield normal(base / bare)
        steps = [step for step in bare.split("/") if step not in ("", ".")]
        # model://NAME/rest, package://NAME/rest: from the folder of that name, or the model's own.
        for at, step in enumerate(steps[:-1]):
            for ancestor in (self.folder, *self.folder.parents):
                if ancestor.name == step:
                    yield normal(ancestor.joinpath(*steps[at + 1 :]))
                if ancestor == self.root:
                    break
        if steps:
            yield normal(self.root.joinpath(*steps))
            yield normal(self.folder.joinpath(*steps[1:] or steps))

    def _by_name(self, asked: str) -> Path | None:
        """The one file of the model's folder with the reference's name, whatever its case."""
        name = asked.rsplit("/", 1)[-1].strip().casefold()
        hits = [path for path in files_below(self.folder) if path.name.casefold() == name]
        hits = [path for path in hits if inside(self.root, path)]
        return min(hits, key=lambda p: (len(p.parts), p.as_posix())) if hits else None


def normal(path: Path) -> Path:
    """The path without ``..``, links not followed."""
    return Path(os.path.normpath(path))


def inside(root: Path, path: Path) -> bool:
    """True for a path whose file, links followed, lies below ``root``."""
    try:
        return path.resolve().is_relative_to(root.resolve())
    except (OSError, RuntimeError, ValueError):
        return False


def is_file(path: Path) -> bool:
    """True when a file is there; False for names that no file can have, too."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def files_below(folder: Path) -> list[Path]:
    """Files below a folder, sorted; links to folders are not followed."""
    out: list[Path] = []
    for here, folders, names in os.walk(folder):
        folders.sort()
        out += [Path(here) / name for name in sorted(names)]
        if len(out) > _MOST_FILES:
            break
    return out[:_MOST_FILES]
