"""The files that a scene names: as they are named, none beyond its folder."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sdgen.files import read_plain
from sdgen.importing.tree import inside, is_file, normal


@dataclass(frozen=True)
class SceneFiles:
    """Files below ``folder``. What a model names is looked for all around it; names in a scene's
    many folders are often the same (``model.obj``), so here nothing is found but by its path."""

    folder: Path

    def find(self, base: Path, reference: str) -> Path | None:
        """The file that ``reference`` means in the folder ``base``; None when there is none."""
        path = normal(base / reference.replace("\\", "/"))
        return path if reference and inside(self.folder, path) and is_file(path) else None

    def bytes_of(self, path: Path, max_bytes: int) -> bytes:
        """The bytes of a file. Raises InputError, located."""
        return read_plain(path, self.shown(path), max_bytes)

    def shown(self, path: Path) -> str:
        """A path as people know it."""
        return str(path)
