"""The whole check, scene by scene."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.errors import InputError
from sdgen.validate.files import check_files, check_whole
from sdgen.validate.labels import check_labels, check_scene, check_zones
from sdgen.validate.problems import Problem
from sdgen.validate.views import check_views

OnScene = Callable[[int, int], None]

#: With fewer scenes than this, starting processes takes longer than it saves.
WORTH_WORKERS = 8


def validate(
    path: str | Path,
    catalog_override: Catalog | None = None,
    on_scene: OnScene | None = None,
    workers: int = 1,
) -> list[Problem]:
    """Everything found wrong with a data set, from its files alone; empty when it is sound.

    ``catalog_override`` evaluates the predicates of another catalogue instead of the data set's
    own. ``on_scene(done, total)`` is called after each scene; ``workers`` processes share them.
    Never raises for bad input.
    """
    try:
        data = Dataset(path, partial=True)
        problems = list(check_whole(data))
        catalog = catalog_override or data.catalog
        _ = data.infos
    except InputError as error:
        return [Problem("file", text) for text in error.problems]
    total = len(data.entries)
    for done, found in enumerate(_scenes(data, catalog, min(workers, total)), start=1):
        problems += found
        if on_scene is not None:
            on_scene(done, total)
    return problems


def _scenes(data: Dataset, catalog: Catalog, workers: int) -> Iterator[list[Problem]]:
    """Problems of every scene, in the manifest's order."""
    if workers <= 1 or len(data.entries) < WORTH_WORKERS:
        yield from (_scene(data, SceneItem(data.path, entry), catalog) for entry in data.entries)
        return
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(workers, spawn, _start, (str(data.path), catalog)) as pool:
        yield from pool.map(_one, range(len(data.entries)), chunksize=4)


_SHARED: list[tuple[Dataset, Catalog]] = []


def _start(path: str, catalog: Catalog) -> None:
    _SHARED[:] = [(Dataset(path, partial=True), catalog)]


def _one(index: int) -> list[Problem]:
    data, catalog = _SHARED[0]
    return _scene(data, SceneItem(data.path, data.entries[index]), catalog)


def _scene(data: Dataset, item: SceneItem, catalog: Catalog) -> list[Problem]:
    problems = list(check_files(data, item))
    try:
        found = list(check_scene(item, data.infos, catalog))
        problems += found
        if found:
            return problems  # what would be derived from it would only repeat it
        with derived_from(data, item):
            for check in _deeper(data, item, catalog):
                problems += check
    except InputError as error:
        problems += [Problem("file", text) for text in error.problems]
    return problems


def _deeper(data: Dataset, item: SceneItem, catalog: Catalog) -> Iterator[Iterator[Problem]]:
    yield check_zones(item, data.infos, catalog)
    yield check_labels(data, item, data.infos, catalog)
    yield check_views(data, item, data.infos)
