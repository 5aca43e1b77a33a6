"""The whole check, scene by scene."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.errors import InputError
from sdgen.scene import FORMAT_VERSION
from sdgen.validate.files import check_files, check_whole
from sdgen.validate.labels import check_labels, check_scene, check_zones
from sdgen.validate.problems import Problem
from sdgen.validate.report import check_report, check_start
from sdgen.validate.scenes import scene_by_scene
from sdgen.validate.twins import check_twin
from sdgen.validate.views import check_views

OnScene = Callable[[int, int], None]


def validate(
    path: str | Path,
    on_scene: OnScene | None = None,
    workers: int = 1,
) -> list[Problem]:
    """Everything found wrong with a data set, from its files alone; empty when it is sound.

    ``on_scene(done, total)`` is called after each scene; ``workers`` processes share them. Never
    raises for bad input.
    """
    try:
        data = Dataset(path, partial=True)
        problems = list(check_whole(data))
        catalog = data.catalog
        _ = data.infos
    except InputError as error:
        return [Problem("file", text) for text in error.problems]
    total = len(data.entries)
    args = (str(data.path), catalog)
    with closing(scene_by_scene(_Checker, args, data.entries, workers)) as found:
        for done, more in enumerate(found, start=1):
            problems += more
            if on_scene is not None:
                on_scene(done, total)
    return problems


def older(data: Dataset) -> bool:
    """True for a data set of a format version before ours: its files, records and digests are
    checked, nothing is derived from them anew."""
    return data.info.format_version != FORMAT_VERSION


def imported(data: Dataset) -> bool:
    """True for scenes made of others' graphs: things are where these have them, whether they could
    stand there or not, and a label that lies between two limits is left out."""
    return data.info.options.homes == "imported"


class _Checker:
    """Checks scenes by their place in the manifest."""

    def __init__(self, path: str, catalog: Catalog) -> None:
        self._data = Dataset(path, partial=True)
        self._catalog = catalog

    def __call__(self, index: int) -> list[Problem]:
        item = SceneItem(self._data.path, self._data.entries[index], checked=False)
        return _scene(self._data, item, self._catalog)

    def close(self) -> None:
        """Nothing to let go of."""


def _scene(data: Dataset, item: SceneItem, catalog: Catalog) -> list[Problem]:
    problems = list(check_files(data, item))
    try:
        found = list(check_scene(item, data.infos, catalog, data.info.format_version))
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
    if older(data):
        # Zones, relations and labels follow from rules that were others then.
        return
    yield check_zones(item, data.infos, catalog)
    if not imported(data):
        yield check_start(item)
        yield check_report(item)
    yield check_labels(data, item, data.infos, catalog)
    yield check_twin(data, item)
    yield check_views(data, item, data.infos)
