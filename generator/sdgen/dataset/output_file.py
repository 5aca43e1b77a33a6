"""Files a user names with ``-o``: written whole or not at all, and only where a file may be.

A rename would put a plain file in the place of whatever is there, a device of the system too. So
only a plain file is written over; a link is refused as well, since what it points at was not named.
"""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import IO

from sdgen.dataset.disk import sync_folder
from sdgen.dataset.records import TOP_FILES
from sdgen.dataset.scene_folder import BUILD_FOLDER
from sdgen.errors import SdgenError, naming
from sdgen.files import kind_of

#: Files that show a folder to be a data set, finished or in the making.
_MARKS = ("dataset.json", f"{BUILD_FOLDER}/build.json")


def check_output(path: Path) -> None:
    """Raises SdgenError unless a file may be written there: nothing is there, or a plain file
    that is no part of a data set."""
    if path == Path("-"):
        raise SdgenError("'-': this is written to a file, not to standard output; name one")
    refuse_links(path, "file")
    with contextlib.suppress(FileNotFoundError):
        mode = path.lstat().st_mode
        if not stat.S_ISREG(mode):
            raise SdgenError(f"{path}: is {kind_of(mode)}; name a plain file or a new one")
    refuse_data_set(path)


def refuse_mixed(outputs: Iterable[Path], inputs: Iterable[Path] = ()) -> None:
    """Raises SdgenError where an output is also an input or lies within one, or two outputs are
    one, or one lies in another."""
    read = {path.resolve() for path in inputs}
    written: list[Path] = []
    for output in outputs:
        place = output.resolve()
        if not read.isdisjoint((place, *place.parents)):
            raise SdgenError(f"{output}: is read here, or within what is; choose another place")
        for other in written:
            if place == other or place in other.parents or other in place.parents:
                raise SdgenError(
                    f"{output}: is, or is within, another output; choose another place"
                )
        written.append(place)


def refuse_links(path: Path, what: str) -> None:
    """Raises SdgenError when ``path`` itself is a symbolic link."""
    if path.is_symlink():
        raise SdgenError(f"{path}: is a symbolic link; name the {what} it points at")


def refuse_data_set(path: Path) -> None:
    """Raises SdgenError for a place that belongs to a data set, whichever: one of its files, or
    anywhere among its scenes. Beside them (``DATASET/predictions.jsonl``) is fine."""
    target = path.resolve()
    for root in target.parents:
        first = target.relative_to(root).parts[0]
        own = first in ("scenes", BUILD_FOLDER) or (target.parent == root and first in TOP_FILES)
        if own and is_data_set(root):
            raise SdgenError(f"{path}: belongs to the data set {root}; choose another place")


def is_data_set(folder: Path) -> bool:
    """True for the folder of a data set, finished or in the making."""
    return any((folder / name).exists() for name in _MARKS)


@contextlib.contextmanager
def output_file(path: Path) -> Iterator[IO[bytes]]:
    """A file to write ``path`` through; it takes its place when the block ends without error.

    Folders on the way are made. Raises SdgenError where ``check_output`` does, OSError when the
    disk is full or the place cannot be written to; then nothing of it is left.
    """
    check_output(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.partial")
    with contextlib.suppress(FileNotFoundError):
        partial.unlink()  # of a run that was killed
    try:
        # "x": never through a link that somebody puts there meanwhile.
        with naming(path), partial.open("xb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        check_output(path)
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)
    sync_folder(path.parent)


def write_output(path: Path, data: bytes) -> None:
    """``output_file`` for bytes at hand."""
    with output_file(path) as file:
        file.write(data)
