"""Checks the models of a library, in a few processes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from functools import partial
from multiprocessing import get_context
from pathlib import Path

from sdgen.catalog.records import Catalog, Category
from sdgen.errors import AssetError
from sdgen.library import Library, load_library
from sdgen.library.select import select
from sdgen.physics.client import Client
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
    with ExitStack() as stack:
        results: Iterator[list[str]]
        if workers > 1 and len(chunks) > 1:
            pool = stack.enter_context(
                ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
            )
            check = partial(_check_anew, tuple(folders), categories)
            results = iter(pool.map(check, chunks))
        else:
            results = (_check(library, categories, chunk) for chunk in chunks)
        for chunk, found in zip(chunks, results, strict=True):
            problems += found
            done += len(chunk)
            if on_model is not None:
                on_model(done, len(wanted))
    return problems


def _check_anew(
    folders: tuple[Path, ...], categories: dict[str, Category], chunk: list[str]
) -> list[str]:
    return _check(load_library(folders), categories, chunk)


def _check(library: Library, categories: dict[str, Category], chunk: list[str]) -> list[str]:
    out: list[str] = []
    with Client() as client:
        for asset_id in chunk:
            asset = library.assets[asset_id]
            try:
                out += check_model(Model(asset, library, categories.get(asset.category)), client)
            except AssetError as error:
                out += error.problems
    return out
