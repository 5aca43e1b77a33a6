"""The data set as a whole: which files there are, their digests, what the manifest adds up to."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from sdgen.cameras.turn import ROOM_TURN
from sdgen.dataset import Dataset
from sdgen.dataset.disk import file_sha256
from sdgen.dataset.item import SceneItem
from sdgen.dataset.opening import unlisted
from sdgen.dataset.records import (
    CONTENT_FILES,
    OBSERVABILITY_FILE,
    SCENE_ID,
    TOP_FILES,
    VISIBILITY_FILE,
    ManifestEntry,
    count,
)
from sdgen.dataset.scene_folder import (
    content_sha256,
    is_ours,
    panorama_files,
    panorama_folder,
    view_files,
    view_folder,
)
from sdgen.dataset.text import read_bytes
from sdgen.errors import InputError, did_you_mean
from sdgen.hazards.splits import split_of_home
from sdgen.scene import anomaly_id, toggle_id, twin_id
from sdgen.validate.problems import SHOWN, Problem, differences

SCENES = "scenes"


def check_whole(data: Dataset) -> Iterator[Problem]:
    """Top-level files against each other."""
    yield from _top(data)
    yield from _manifest(data)
    for text in unlisted(data.path, data.info, data.entries):
        yield Problem("count", text)
    stored, derived = data.info.counts, count(data.entries)
    for text in islice(differences(stored, derived, "counts"), SHOWN):
        yield Problem("count", f"dataset.json: {text}")
    for split, homes in data.info.splits.items():
        found = sorted({e.home for e in data.entries if e.split == split})
        if list(homes) != found:
            yield Problem("count", f"dataset.json: splits.{split}: homes are not the manifest's")
    for entry in data.entries:
        if entry.index >= data.info.n:
            text = f"manifest.jsonl: scene {entry.id}: n is only {data.info.n}"
            yield Problem("count", text)


def _top(data: Dataset) -> Iterator[Problem]:
    for name in TOP_FILES:
        if not (data.path / name).is_file():
            yield Problem("file", f"{name}: missing")
        elif name == "README.md":
            yield from _card(data)
    known = {entry.id for entry in data.entries}
    folder = data.path / SCENES
    for path in sorted(folder.iterdir()) if folder.is_dir() else ():
        # A user's own files (notes, what a file manager leaves) are none of ours to judge.
        if path.name not in known and re.match(SCENE_ID, path.name):
            yield Problem("file", f"{SCENES}/{path.name}: the manifest does not list it")
    try:
        catalog = data.catalog
        if data.catalogue_sha256 != data.info.catalogue_sha256:
            yield Problem(
                "hash", "catalogue.json: not the catalogue dataset.json has the digest of"
            )
        enabled = tuple(sorted(hazard.id for hazard in catalog.hazards))
        if enabled != data.info.hazards_enabled:
            yield Problem("count", "dataset.json: hazards_enabled: not the catalogue's hazards")
    except InputError as error:
        yield from (Problem("file", text) for text in error.problems)
    try:
        if list(data.infos) != sorted(data.infos):
            yield Problem("file", "assets.jsonl: not sorted by id")
    except InputError as error:
        yield from (Problem("file", text) for text in error.problems)


def _card(data: Dataset) -> Iterator[Problem]:
    try:
        if not read_bytes(data.path / "README.md", "README.md").strip():
            yield Problem("file", "README.md: empty")  # its words change with sdgen's version
    except InputError as error:
        yield from (Problem("file", text) for text in error.problems)


def _manifest(data: Dataset) -> Iterator[Problem]:
    by_id = {entry.id: entry for entry in data.entries}
    order = [(entry.index, entry.id) for entry in data.entries]
    if order != sorted(order):
        yield Problem("file", "manifest.jsonl: not sorted by scene")
    for entry in data.entries:
        where, name = f"manifest.jsonl: scene {entry.id}", f"{entry.index:06d}"
        if entry.id != name and not (entry.twin_of and entry.id.startswith(f"{name}-")):
            yield Problem("count", f"{where}: id and index disagree")
        drawn = re.fullmatch(r"procedural_(\d+)_\d{6}", entry.home)
        if drawn is not None and int(drawn[1]) != data.info.seed:
            text = (
                f"dataset.json: seed {data.info.seed}, scene {entry.id} was drawn with {drawn[1]}"
            )
            yield Problem("count", text)
        if entry.split != split_of_home(entry.home):
            right = split_of_home(entry.home)
            yield Problem("count", f"{where}: split {entry.split!r}, its home is {right!r}")
        if entry.twin_of is not None and entry.twin_of not in by_id:
            hint = did_you_mean(entry.twin_of, list(by_id))
            yield Problem("count", f"{where}: twin of no scene{hint}")
        elif entry.twin_of is not None:
            yield from _twin(entry, by_id[entry.twin_of], where)
        else:
            for missing in sorted(entry.twins_promised(data.info.options) - by_id.keys()):
                kind = "twin" if missing == twin_id(entry.id) else f"scene {missing}"
                yield Problem("count", f"{where}: has no {kind}, the options promise one")


def _twin(twin: ManifestEntry, scene: ManifestEntry, where: str) -> Iterator[Problem]:
    """A twin has the household, cameras and split of its scene, and nothing wrong with it; one
    with an anomaly undone has fewer of them."""
    if (twin.home, twin.split, twin.views) != (scene.home, scene.split, scene.views):
        yield Problem("count", f"{where}: home, split or views are not those of {scene.id}")
    if twin.kind == "twin" and twin.anomalies:
        yield Problem("count", f"{where}: a twin with {twin.anomalies} anomalies")
    promised = {toggle_id(scene.id, anomaly_id(k)) for k in range(scene.anomalies)}
    if twin.kind == "toggle" and (twin.id not in promised or twin.anomalies >= scene.anomalies):
        text = f"undoes none of the {scene.anomalies} anomalies of {scene.id}"
        yield Problem("count", f"{where}: {text}")
    cameras = (name for name in scene.files if name.endswith(("view.json", "panorama.json")))
    for name in ("household.json", *cameras):
        if twin.files.get(name) != scene.files.get(name):
            both = f"scenes/{scene.id}/{name} and scenes/{twin.id}/{name}"
            yield Problem("count", f"manifest.jsonl: {both} differ; a twin has its scene's")


def check_files(data: Dataset, item: SceneItem) -> Iterator[Problem]:
    """One scene's files: those promised, byte for byte those of the manifest, and no other that
    bears a name of ours: a reader would take it for data. Others are a user's own."""
    entry = item.entry
    if item.folder.is_symlink() or not item.folder.is_dir():
        yield Problem("file", f"{SCENES}/{entry.id}: missing")
        return
    promised = expected_files(data, entry)
    found = {
        p.relative_to(item.folder).as_posix() for p in item.folder.rglob("*") if not p.is_dir()
    }
    for name in sorted(filter(is_ours, found - set(entry.files))):
        yield Problem("file", f"{item.where(name)}: the manifest does not list it")
    for name in sorted(promised - set(entry.files)):
        yield Problem("file", f"{item.where(name)}: promised by the options, not in the manifest")
    for name in sorted(set(entry.files) - promised):
        yield Problem("file", f"{item.where(name)}: in the manifest, not promised by the options")
    for name in sorted(entry.files):
        path = item.folder / name
        if item.linked(name):
            yield Problem("file", f"{item.where(name)}: a symbolic link leads elsewhere")
        elif not path.is_file():
            yield Problem("file", f"{item.where(name)}: {_state(name in found)}")
        elif file_sha256(path) != entry.files[name]:
            yield Problem("hash", f"{item.where(name)}: changed since it was written")
    try:
        content = {name: read_bytes(item.folder / name, item.where(name)) for name in CONTENT_FILES}
    except InputError:
        return  # told above, or where its records are read
    if content_sha256(content) != entry.content_sha256:
        yield Problem("hash", f"manifest.jsonl: scene {entry.id}: content_sha256 is not its files'")


def _state(found: bool) -> str:
    return "not a plain file" if found else "missing"


def expected_files(data: Dataset, entry: ManifestEntry) -> set[str]:
    """Files a scene of this data set has, by its options."""
    names = {*CONTENT_FILES, VISIBILITY_FILE}
    if data.info.options.observability:
        names.add(OBSERVABILITY_FILE)
    for view in range(entry.views):
        names.update(f"{view_folder(view)}/{name}" for name in view_files(data.info.options))
    for turn in range(entry.views // ROOM_TURN):
        files = panorama_files(data.info.options)
        names.update(f"{panorama_folder(turn)}/{name}" for name in files)
    return names
