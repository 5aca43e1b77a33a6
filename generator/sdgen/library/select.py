"""Picks models by the words a person types: ids and categories."""

from __future__ import annotations

from collections.abc import Sequence

from sdgen.errors import UsageError, did_you_mean
from sdgen.library.library import Library


def select(library: Library, words: Sequence[str]) -> list[str]:
    """Ids of the models that some word names, by id or category, in the order of the library.

    No word means all. Raises UsageError for a word that names nothing.
    """
    for word in words:
        if word not in library.assets and not library.by_category(word):
            choices = [*library.assets, *library.categories]
            raise UsageError(f"no asset or category {word!r}{did_you_mean(word, choices)}")
    wanted = frozenset(words)
    return [
        asset.id
        for asset in library.assets.values()
        if not words or asset.id in wanted or asset.category in wanted
    ]
