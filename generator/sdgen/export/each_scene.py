"""What all formats of models do: a file a scene, of the very models that the scene was built of."""

from __future__ import annotations

from collections.abc import Callable

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.errors import InputError
from sdgen.export.formats import OnScene
from sdgen.export.shards import groups, scenes_in
from sdgen.library import Library


def check_models(data: Dataset, library: Library) -> None:
    """Raises InputError for a library that is not the data set's."""
    if library.sha256 != data.info.assets_sha256:
        raise InputError(
            ["dataset.json: assets_sha256: other models than the ones at hand (--assets)"]
        )


def each_scene(
    data: Dataset, library: Library, on_scene: OnScene, write: Callable[[SceneItem], None]
) -> None:
    """Call ``write`` for every scene, twins too. Raises InputError for scenes whose files disagree,
    and for a library that is not the data set's."""
    check_models(data, library)
    total, done = scenes_in(data), 0
    for _, _, items in groups(data):
        for item in items:
            with derived_from(data, item):
                write(item)
            done += 1
            if on_scene is not None:
                on_scene(done, total)
