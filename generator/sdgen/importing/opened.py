"""A download opened: its folder and the archives in it, unpacked as long as they are needed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from sdgen.errors import AssetError
from sdgen.importing.archives import DEFAULT_LIMITS, is_archive, unpack
from sdgen.importing.tree import inside
from sdgen.scratch import scratch_folder


@dataclass(frozen=True)
class Refused:
    """A model that did not come in, and why."""

    name: str
    why: str


@contextmanager
def opened_source(path: Path) -> Iterator[tuple[list[Path], list[Refused]]]:
    """Folders of a download, and archives of it that are broken.

    Archives, also those that lie in the folder or the archive itself (Fuel packs each model), are
    unpacked for as long as they are needed, all within the limits of one. Raises AssetError.
    """
    with scratch_folder() as scratch:
        roots: list[Path] = []
        refused: list[Refused] = []
        left = DEFAULT_LIMITS.total_bytes
        if path.is_dir():
            roots.append(path.resolve())
        else:
            roots.append(unpack(path, scratch / _bare(path), shown=path.name).resolve())
            packed = DEFAULT_LIMITS.ratio * path.stat().st_size
            left = min(left, max(DEFAULT_LIMITS.ratio_from, packed)) - _size(roots[0])
        for number, entry in enumerate(sorted(roots[0].iterdir())):
            if not entry.is_file() or not is_archive(entry):
                continue
            if not inside(roots[0], entry):
                refused.append(Refused(entry.name, f"lies outside {path.name}"))
                continue
            try:
                place = scratch / f"{number}" / _bare(entry)
                limits = replace(DEFAULT_LIMITS, total_bytes=max(left, 0))
                roots.append(unpack(entry, place, limits, entry.name).resolve())
                left -= _size(roots[-1])
            except AssetError as error:
                refused.append(Refused(entry.name, "; ".join(error.problems[:3])))
        yield roots, refused


def _size(folder: Path) -> int:
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def _bare(path: Path) -> str:
    return path.name.split(".")[0] or "archive"
