"""Makes scenes again and compares: the promise that scene i follows from seed and i alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from sdgen.dataset import Dataset
from sdgen.dataset.scene_folder import content_files, content_sha256
from sdgen.dataset.versions import OF_PICTURES, package_versions
from sdgen.errors import SceneRejected
from sdgen.library import Library
from sdgen.pipeline import make_scene
from sdgen.validate.problems import Problem


def rebuild(
    data: Dataset,
    library: Library,
    scenes: int,
    on_scene: Callable[[int, int], None] | None = None,
) -> list[Problem]:
    """Make ``scenes`` scenes again, spread over the data set, and compare their content digests.

    ``library`` must be the one of the build. The views are not drawn again.
    """
    return list(_rebuild(data, library, scenes, on_scene))


def _rebuild(
    data: Dataset,
    library: Library,
    scenes: int,
    on_scene: Callable[[int, int], None] | None,
) -> Iterator[Problem]:
    info = data.info
    if library.sha256 != info.assets_sha256:
        yield Problem("rebuild", "dataset.json: assets_sha256: other models than the ones at hand")
        return
    here = package_versions()
    for name, version in info.versions.items():
        if here.get(name) != version and name not in OF_PICTURES:
            text = f"{version} then, {here.get(name, 'none')} now: bytes may differ"
            yield Problem("rebuild", f"dataset.json: versions.{name}: {text}")
    total = len(data)
    picked = sorted({k * total // scenes for k in range(min(scenes, total))}) if scenes else []
    for done, k in enumerate(picked):
        if on_scene is not None:
            on_scene(done, len(picked))
        entry = data[k].entry
        where = f"scenes/{entry.id}"
        try:
            bundle = make_scene(entry.index, data.catalog, library, info.options)
        except SceneRejected as error:
            yield Problem("rebuild", f"{where}: {error}")
            continue
        files = content_files(bundle)
        for name, made in files.items():
            if made != (data.path / where / name).read_bytes():
                yield Problem("rebuild", f"{where}/{name}: made again, it is another file")
        if content_sha256(files) != entry.content_sha256:
            yield Problem("rebuild", f"{where}: content_sha256: made again, it is another scene")
