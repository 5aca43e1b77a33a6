"""Finished scenes on their way from one folder to another, checked against their digests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from sdgen.dataset.disk import remove_tree, sha256_hex
from sdgen.dataset.scene_folder import BUILD_FOLDER, FinishedScene, show
from sdgen.dataset.text import read_bytes, read_record
from sdgen.errors import InputError, naming


@dataclass(frozen=True)
class PackedScene:
    """A finished scene as bytes: its line and its files by name. Pickles."""

    done: FinishedScene
    files: dict[str, bytes]


def pack(root: Path, scene_id: str) -> PackedScene:
    """Take a finished scene out of the data set in the making at ``root``: nothing stays there."""
    line = root / BUILD_FOLDER / "entries" / f"{scene_id}.json"
    folder = root / "scenes" / scene_id
    done = read_record(FinishedScene, line, str(line))
    files = {name: (folder / name).read_bytes() for name in done.entry.files}
    remove_tree(folder)
    line.unlink()
    return PackedScene(done, files)


def unpack(root: Path, packed: PackedScene) -> None:
    """Put a packed scene into the data set in the making at ``root``, whole or not at all.

    Raises InputError when its bytes are not those of its line.
    """
    _put(root, packed.done, lambda name: packed.files.get(name), f"scene {packed.done.entry.id}")


def copy(source: Path, done: FinishedScene, root: Path) -> None:
    """Copy a scene of the data set at ``source`` into the one in the making at ``root``.

    Raises InputError, located, for files that are missing, changed, or no plain files.
    """
    folder = source / "scenes" / done.entry.id

    _put(root, done, lambda name: read_bytes(folder / name, f"{folder}/{name}"), str(folder))


def _put(root: Path, done: FinishedScene, read: Callable[[str], bytes | None], where: str) -> None:
    with _partial(root, done.entry.id) as partial:
        for name, digest in done.entry.files.items():
            data = read(name)
            if data is None:
                raise InputError([f"{where}/{name}: missing"])
            if sha256_hex(data) != digest:
                raise InputError([f"{where}/{name}: changed since it was written"])
            path = partial / name
            path.parent.mkdir(parents=True, exist_ok=True)
            with naming(path):
                path.write_bytes(data)
        show(root, partial, done)


@contextmanager
def _partial(root: Path, scene_id: str) -> Iterator[Path]:
    folder = root / BUILD_FOLDER / f"{scene_id}.partial"
    remove_tree(folder)
    folder.mkdir(parents=True)
    try:
        yield folder
    finally:
        remove_tree(folder)
