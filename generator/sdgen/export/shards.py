"""Which scenes go together: those of a split, their twins apart, so that counts stay true."""

from __future__ import annotations

from collections.abc import Iterator

from sdgen.dataset import Dataset, SceneItem

#: Bytes of pictures after which a new file is begun.
SHARD_BYTES = 500_000_000


def groups(data: Dataset) -> Iterator[tuple[str, str, Iterator[SceneItem]]]:
    """``(kind, split, scenes)`` with ``kind`` ``scene``, ``twin`` or ``toggle``; none empty.

    Scenes are opened one at a time, so that one alone is in memory. Of a data set that was opened
    for one split, that split alone.
    """
    splits = [data.split] if data.split is not None else list(data.info.splits)
    for kind in ("scene", "twin", "toggle"):
        for split in splits:
            entries = [e for e in data.entries if e.kind == kind and e.split == split]
            if entries:
                yield kind, split, (data.scene(entry.id) for entry in entries)


def scenes_in(data: Dataset) -> int:
    """How many scenes ``groups`` gives, twins too."""
    return sum(data.split in (None, entry.split) for entry in data.entries)
