"""Which scenes go together: those of a split, their twins apart, so that counts stay true."""

from __future__ import annotations

from collections.abc import Iterator

from sdgen.dataset import Dataset, ManifestEntry, SceneItem

#: Bytes of pictures after which a new file is begun.
SHARD_BYTES = 500_000_000


def groups(data: Dataset) -> Iterator[tuple[str, str, Iterator[SceneItem]]]:
    """``(kind, split, scenes)`` with ``kind`` ``scene``, ``twin`` or ``toggle``; none empty.

    The scenes that ``data`` shows, and their twins; opened one at a time, so that one alone is in
    memory.
    """
    wanted = _wanted(data)
    for kind in ("scene", "twin", "toggle"):
        for split in data.info.splits:
            entries = [entry for entry in wanted if entry.kind == kind and entry.split == split]
            if entries:
                yield kind, split, (data.scene(entry.id) for entry in entries)


def scenes_in(data: Dataset) -> int:
    """How many scenes ``groups`` gives, twins too."""
    return len(_wanted(data))


def _wanted(data: Dataset) -> list[ManifestEntry]:
    ids = {entry.twin_of or entry.id for entry in data.shown}
    return [entry for entry in data.entries if (entry.twin_of or entry.id) in ids]
