"""Makes scenes again and compares: the promise that scene i follows from seed and i alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from sdgen.dataset import Dataset
from sdgen.dataset.disk import remove_tree
from sdgen.dataset.records import CONTENT_FILES, DatasetInfo, ManifestEntry
from sdgen.dataset.scene_folder import BUILD_FOLDER, FinishedScene, SceneWriter
from sdgen.dataset.text import read_record
from sdgen.dataset.versions import OF_PICTURES, package_versions
from sdgen.engines.worker import SceneWorker, WorkerSetup
from sdgen.errors import RendererError, SceneRejected
from sdgen.library import Library
from sdgen.library.cache import usable_cache
from sdgen.render import RENDERERS, Choice, choose_renderer
from sdgen.scratch import scratch_folder
from sdgen.validate.at_hand import other_models
from sdgen.validate.problems import Problem

#: Files of poses: compared where pictures cannot be.
_POSES = ("/view.json", "/panorama.json")


class Rebuilt(NamedTuple):
    """What making scenes again found, a line about what could not be compared, and how many
    scenes were made (or tried in vain), twins apart."""

    problems: list[Problem]
    note: str
    made: int


def rebuild(
    data: Dataset,
    library: Library,
    scenes: int,
    on_scene: Callable[[int, int], None] | None = None,
) -> Rebuilt:
    """Make ``scenes`` scenes and their twins again, spread over the data set, as a build does.

    Every file is compared byte for byte; pictures, and what is counted in them, when the renderer
    that drew them is at hand. ``library`` must be the one of the build, model by model, or none
    is made.
    """
    info = data.info
    problems = list(other_models(data, library, "rebuild"))
    if problems:
        return Rebuilt(problems, "", 0)
    problems = list(_versions(info))
    picked = spread(len(data), scenes)
    if not picked:
        return Rebuilt(problems, "", 0)
    choice, note = _renderer(info) if info.options.draws else (None, "")
    with usable_cache(), scratch_folder() as place:
        setup = WorkerSetup(
            catalog=data.catalog,
            library_folders=library.folders,
            library_sha256=library.sha256,
            options=info.options,
            writer=SceneWriter(place, info.options),
            choice=choice,
            one_thread=False,
        )
        with SceneWorker(setup) as worker:
            for done, k in enumerate(picked):
                if on_scene is not None:
                    on_scene(done, len(picked))
                problems += _scene(data, data[k].entry, worker, place, note == "")
    return Rebuilt(problems, note, len(picked))


def spread(total: int, wanted: int) -> list[int]:
    """So many of the numbers below ``total``, spread evenly; all where more are wanted."""
    wanted = min(wanted, total)
    return [k * total // wanted for k in range(wanted)]


def _versions(info: DatasetInfo) -> Iterator[Problem]:
    here = package_versions()
    for name, version in info.versions.items():
        if here.get(name) != version and name not in OF_PICTURES:
            text = f"{version} then, {here.get(name, 'none')} now: bytes may differ"
            yield Problem("rebuild", f"dataset.json: versions.{name}: {text}")


def _renderer(info: DatasetInfo) -> tuple[Choice | None, str]:
    """The renderer that drew the data set, or None and why its pictures cannot be compared."""
    here = package_versions()
    for name in OF_PICTURES:
        then = info.versions.get(name)
        if then != here.get(name):
            return None, f"pictures not compared: {name} {then} then, {here.get(name)} now"
    if len(info.renderers) > 1:
        return None, f"pictures not compared: drawn by {' and '.join(info.renderers)}"
    found = []
    for kind in RENDERERS:
        try:
            choice = choose_renderer(kind)
        except RendererError:
            continue
        if choice.renderer_string in info.renderers:
            return choice, ""
        found.append(choice.renderer_string)
    then = info.renderers[0] if info.renderers else "nobody knows what"
    return None, f"pictures not compared: drawn by {then}, here is {' and '.join(found) or 'none'}"


def _scene(
    data: Dataset, entry: ManifestEntry, worker: SceneWorker, place: Path, pictures: bool
) -> Iterator[Problem]:
    """One scene, and its twins where the data set has any."""
    try:
        worker(entry.index)
    except SceneRejected as error:
        yield Problem("rebuild", f"scenes/{entry.id}: {error}")
        return
    for stored in (e for e in data.entries if entry.id in (e.id, e.twin_of)):
        done = place / BUILD_FOLDER / "entries" / f"{stored.id}.json"
        if not done.is_file():
            yield Problem("rebuild", f"scenes/{stored.id}: made again, there is no such scene")
            continue
        made = read_record(FinishedScene, done, str(done)).entry
        for name in sorted(stored.files):
            compared = pictures or name in CONTENT_FILES or name.endswith(_POSES)
            if compared and made.files.get(name) != stored.files[name]:
                text = "made again, it is another file"
                yield Problem("rebuild", f"scenes/{stored.id}/{name}: {text}")
        if made.content_sha256 != stored.content_sha256:
            text = "content_sha256: made again, it is another scene"
            yield Problem("rebuild", f"scenes/{stored.id}: {text}")
    remove_tree(place / "scenes")
