"""The folder of meshes and textures beside a file that names them: there whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from sdgen.dataset.disk import remove_tree, sync_folder
from sdgen.dataset.output_file import refuse_data_set, refuse_links
from sdgen.errors import SdgenError

#: What such a folder holds, and nothing else: only then another export may take its place.
_OURS = (".obj", ".png")


def folder_beside(file: Path) -> Path:
    """``home_assets`` beside ``home.xml``."""
    return file.with_name(f"{file.stem}_assets")


def check_beside(file: Path) -> None:
    """Raises SdgenError unless that folder may be written: nothing is there, or an earlier one."""
    folder = folder_beside(file)
    refuse_links(folder, "folder")
    refuse_data_set(folder)
    if not folder.exists():
        return
    if not folder.is_dir():
        raise SdgenError(f"{folder}: is in the way of the folder of {file.name}'s meshes")
    for path in folder.iterdir():
        if path.is_symlink() or not path.is_file() or path.suffix not in _OURS:
            text = f"{folder}: holds {path.name}, which no export wrote; choose another name"
            raise SdgenError(text)


@contextmanager
def written_beside(file: Path) -> Iterator[Path]:
    """A folder to fill, which takes its place when the block ends without error.

    Raises SdgenError where :func:`check_beside` does.
    """
    check_beside(file)
    folder = folder_beside(file)
    partial = folder.with_name(f".{folder.name}.partial")
    remove_tree(partial)
    partial.mkdir(parents=True)
    try:
        yield partial
        check_beside(file)
        remove_tree(folder)
        os.replace(partial, folder)
    finally:
        remove_tree(partial)
    sync_folder(folder.parent)
