"""Checks the models of a library, in a few processes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import closing
from pathlib import Path

from sdgen.catalog.records import Catalog, Category
from sdgen.engines.in_order import in_order
from sdgen.errors import AssetError, SceneRejected
from sdgen.library import Library, load_library
from sdgen.library.select import select
from sdgen.physics.client import Client
from sdgen.rejection import causes_in_words
from sdgen.validate.models import Model, check_model

#: Models a worker checks at a time: seconds, so that the progress shown moves.
_CHUNK = 16


def check_assets(
    folders: Sequence[Path],
    catalog: Catalog,
    on_model: Callable[[int, int], None] | None = None,
    workers: int = 1,
    words: Sequence[str] = (),
) -> list[str]:
    """What is wrong with the models of ``folders`` (none: the shipped library), sorted by id.

    ``words`` are the ids and categories to check (none: all). Sizes are those of ``catalog``'s
    categories. ``on_model`` hears (done, total). Raises
    AssetError when a folder cannot be read at all.
    """
    library = load_library(folders)
    wanted = [
        asset_id
        for asset_id in (select(library, words) if words else library.assets)
        if not folders or library.folder_of(asset_id) in folders
    ]
    chunks = [wanted[k : k + _CHUNK] for k in range(0, len(wanted), _CHUNK)]
    categories = {c.name: c for c in catalog.categories}
    problems: list[str] = []
    done = 0
    work = (library.folders, categories, chunks)
    with closing(in_order(_Checker, work, len(chunks), workers)) as outcomes:
        for outcome in outcomes:
            chunk = chunks[outcome.job]
            if isinstance(outcome.error, SceneRejected):
                why = causes_in_words(outcome.error.causes)
                problems.append(f"{chunk[0]} to {chunk[-1]}: workers end at one of these ({why})")
            elif outcome.error is not None:
                raise outcome.error
            else:
                problems += outcome.result
            done += len(chunk)
            if on_model is not None:
                on_model(done, len(wanted))
    return problems


class _Checker:
    """Checks models, a chunk of them at a time."""

    def __init__(
        self,
        folders: tuple[Path, ...],
        categories: dict[str, Category],
        chunks: Sequence[Sequence[str]],
    ) -> None:
        self._library = Library(folders)  # whose files were read when the work was shared out
        self._categories = categories
        self._chunks = chunks

    def __call__(self, index: int) -> list[str]:
        return _check(self._library, self._categories, self._chunks[index])

    def close(self) -> None:
        """Nothing to let go of: every chunk has a simulator of its own."""


def _check(library: Library, categories: dict[str, Category], chunk: Sequence[str]) -> list[str]:
    out: list[str] = []
    with Client() as client:
        for asset_id in chunk:
            asset = library.assets[asset_id]
            try:
                out += check_model(Model(asset, library, categories.get(asset.category)), client)
            except AssetError as error:
                out += error.problems
    return out
