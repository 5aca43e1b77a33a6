"""Folders a user names with ``-o``: there whole or not at all, and never in the place of others."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from sdgen.dataset.disk import remove_tree, sync_folder
from sdgen.dataset.output_file import refuse_data_set, refuse_links
from sdgen.errors import SdgenError, naming


def check_output_folder(path: Path) -> None:
    """Raises SdgenError unless a folder may be made there: nothing is there, or an empty folder,
    and the place is no part of a data set."""
    refuse_links(path, "folder")
    refuse_data_set(path)
    if path.exists():
        if not path.is_dir():
            raise SdgenError(f"{path}: is in the way; this writes a folder, name a new one")
        if any(path.iterdir()):
            raise SdgenError(f"{path}: is not empty; name a new folder, or remove it first")


@contextlib.contextmanager
def output_folder(path: Path) -> Iterator[Path]:
    """A folder to fill, which takes the place of ``path`` when the block ends without error.

    Folders on the way are made. Raises SdgenError where ``check_output_folder`` does, OSError when
    the disk is full or the place cannot be written to; then nothing of it is left.
    """
    check_output_folder(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.partial")
    remove_tree(partial)  # of a run that was killed
    try:
        with naming(path):
            partial.mkdir()
        yield partial
        check_output_folder(path)
        with naming(path):
            os.replace(partial, path)  # over an empty folder, too
    finally:
        remove_tree(partial)
    sync_folder(path.parent)
