"""Opens a data set's own files: is it one, is it whole, may its names be followed?"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import islice
from pathlib import Path

from sdgen.dataset.older import info_as_now
from sdgen.dataset.records import SCENE_ID, DatasetInfo, ManifestEntry
from sdgen.dataset.scene_folder import BUILD_FOLDER, is_ours
from sdgen.dataset.text import read_lines, read_record
from sdgen.errors import InputError
from sdgen.scene import FORMAT_VERSION

#: Missing scenes named in one line.
_NAMED = 10
#: Characters shown of a file's name that is none of ours.
_LONGEST = 80


def open_info(path: Path) -> DatasetInfo:
    """``dataset.json`` of a finished data set this version can read. Raises InputError."""
    if not (path / "dataset.json").is_file():
        if not path.is_dir():
            problem = "no such folder"
        elif (path / BUILD_FOLDER).is_dir():
            problem = "unfinished; the same command ('sdgen build', 'sdgen merge') goes on"
        else:
            problem = "no data set (it has no dataset.json)"
        raise InputError([f"{path}: {problem}"])
    info = read_record(DatasetInfo, path / "dataset.json", "dataset.json", info_as_now)
    if info.format_version.split(".")[0] != FORMAT_VERSION.split(".")[0]:
        raise InputError(
            [
                f"dataset.json: format_version: {info.format_version!r} cannot be read by this "
                f"version of sdgen (it reads {FORMAT_VERSION})"
            ]
        )
    if (info.seed, info.n) != (info.options.seed, info.options.n):
        raise InputError(["dataset.json: seed and n are not those of its options"])
    return info


def refuse_incomplete(path: Path, info: DatasetInfo, entries: Sequence[ManifestEntry]) -> None:
    """Raises InputError when scenes are gone that the data set was finished with."""
    missing = {entry.id for entry in entries} - _folders(path)
    problems = [f"scenes/{name}: missing" for name in sorted(missing)]
    problems += unlisted(path, info, entries)
    if problems and (path / BUILD_FOLDER).is_dir():
        problems.append(f"{path}: a build has not finished; resume it with the same 'sdgen build'")
    if problems:
        raise InputError(problems)


def unlisted(path: Path, info: DatasetInfo, entries: Sequence[ManifestEntry]) -> list[str]:
    """That the manifest lists fewer or more scenes than ``dataset.json`` counts, and which."""
    kinds = [entry.kind for entry in entries]
    listed = (kinds.count("scene"), kinds.count("twin"), kinds.count("toggle"))
    counted = (info.counts.scenes, info.counts.twins, info.counts.toggles)
    if listed == counted:
        return []
    ids = {entry.id for entry in entries}
    # Their folders tell best; without them, whatever index of 0 to n - 1 is not accounted for.
    every: Iterable[str] = (f"{k:06d}" for k in range(info.n))
    neither = (name for name in every if name not in ids and name not in info.failed)
    gone = sorted(_folders(path) - ids) or list(islice(neither, _NAMED + 1))
    names = ", ".join(gone[:_NAMED]) + (", ..." if len(gone) > _NAMED else "")
    words = [f"{listed[0]} scenes and {listed[1]} twins", f"{counted[0]} and {counted[1]}"]
    if listed[2] or counted[2]:
        words = [
            f"{word}, {more[2]} toggles"
            for word, more in zip(words, (listed, counted), strict=True)
        ]
    return [
        f"manifest.jsonl: lists {words[0]}, dataset.json counts {words[1]}"
        + (f" (not listed: {names})" if gone else "")
    ]


def _folders(path: Path) -> set[str]:
    folder = path / "scenes"
    names = {found.name for found in folder.iterdir()} if folder.is_dir() else set()
    return {name for name in names if re.match(SCENE_ID, name)}


def read_manifest(path: Path) -> tuple[ManifestEntry, ...]:
    """The lines of ``manifest.jsonl``: each scene once, no file but those that sdgen writes (none
    that leads elsewhere, then, and none that a copy or an archive could trip over)."""
    entries = read_lines(ManifestEntry, path / "manifest.jsonl", "manifest.jsonl")
    problems = []
    seen: set[str] = set()
    for entry in entries:
        if entry.id in seen:
            problems.append(f"manifest.jsonl: scene {entry.id} appears twice")
        seen.add(entry.id)
        for name in entry.files:
            if not is_ours(name):
                text = f"{name[:_LONGEST]!r} is no file that sdgen writes"
                problems.append(f"manifest.jsonl: scene {entry.id}: files: {text}")
    if problems:
        raise InputError(problems)
    return entries
