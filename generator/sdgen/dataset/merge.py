"""Joins pieces of one data set, built apart by ``--range``, to the bytes of one build."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from sdgen.dataset.origin import differences
from sdgen.dataset.reader import Dataset
from sdgen.dataset.records import DatasetInfo, ManifestEntry
from sdgen.dataset.scene_folder import FinishedScene
from sdgen.dataset.transfer import copy
from sdgen.dataset.writer import DatasetWriter
from sdgen.errors import InputError, UsageError
from sdgen.library.records import AssetInfo

#: Called with the scenes that are in place so far, and all there are.
OnScene = Callable[[int, int], None]


@dataclass(frozen=True)
class Merged:
    """What came of it: the data set's record, and the scenes (first, end) that no piece has."""

    info: DatasetInfo
    missing: tuple[tuple[int, int], ...]


def merge(pieces: Sequence[Path], out: Path, on_scene: OnScene | None = None) -> Merged:
    """Join finished data sets into ``out``; the same call goes on after an interruption.

    Pieces must be of one build but for ``--n``, of which the largest counts; a scene in two of
    them must have the same bytes in both. Raises InputError, located, for all that does not fit
    before anything is written, and when a file turns out to be changed; SdgenError when ``out``
    cannot be used.
    """
    _apart(pieces, out)
    data_sets: list[Dataset] = []
    problems: list[str] = []
    for piece in pieces:
        with _located(piece, problems):
            data = Dataset(piece)
            _ = data.catalog  # refused where it is not the one of the piece's labels
            data_sets.append(data)
    if problems:
        raise InputError(problems)
    scenes, assets = _joined(data_sets)
    largest = max(data_sets, key=lambda data: data.info.n).info
    with DatasetWriter.take(out, largest.build(), data_sets[0].catalog, assets) as writer:
        done = sum(name in writer.done for name in scenes)
        for name, (data, entry) in scenes.items():
            if name not in writer.done:
                copy(data.path, FinishedScene(entry=entry, assets=()), writer.root)
                done += 1
            if on_scene is not None:
                on_scene(done, len(scenes))
        for data in data_sets:
            writer.include(data.info, data.infos)
        info = writer.finish(words=largest.vocabularies)
    indices = {entry.index for _, entry in scenes.values()} | {int(key) for key in info.failed}
    return Merged(info, tuple(_gaps(indices, info.n)))


def _apart(pieces: Sequence[Path], out: Path) -> None:
    """UsageError unless all folders lie apart from each other."""
    target = out.resolve()
    seen: set[Path] = set()
    for piece in pieces:
        path = piece.resolve()
        if path in seen:
            raise UsageError(f"{piece} is named twice")
        seen.add(path)
        if path == target or path in target.parents or target in path.parents:
            raise UsageError(f"-o {out}: choose a folder apart from the piece {piece}")


@contextmanager
def _located(piece: Path, problems: list[str]) -> Iterator[None]:
    """Collect the problems of a piece, each with its folder."""
    try:
        yield
    except InputError as error:
        texts = error.problems
        problems += [t if t.startswith(str(piece)) else f"{piece}: {t}" for t in texts]


def _joined(
    data_sets: Sequence[Dataset],
) -> tuple[dict[str, tuple[Dataset, ManifestEntry]], dict[str, AssetInfo]]:
    """Every scene with the piece it comes from, and all assets. InputError for what differs."""
    first = data_sets[0]
    scenes: dict[str, tuple[Dataset, ManifestEntry]] = {}
    assets: dict[str, tuple[Dataset, AssetInfo]] = {}
    problems: list[str] = []
    for data in data_sets:
        others = differences(data.info.build(), first.info.build(), f"{first.path} has")
        if data.info.vocabularies != first.info.vocabularies:
            others.append("other vocabularies")
        if others:
            problems.append(f"{data.path}: of another build: {'; '.join(others)}")
            continue
        for entry in data.entries:
            owner, known = scenes.setdefault(entry.id, (data, entry))
            if known != entry:
                problems.append(
                    f"{data.path}: scene {entry.id} is not that of {owner.path}: "
                    f"{', '.join(_unlike(known, entry))}"
                )
        with _located(data.path, problems):
            for name, info in data.infos.items():
                source, other = assets.setdefault(name, (data, info))
                if other != info:
                    problems.append(f"{data.path}: model {name} is not that of {source.path}")
    if problems:
        raise InputError(problems)
    return scenes, {name: info for name, (_, info) in assets.items()}


def _unlike(one: ManifestEntry, two: ManifestEntry) -> list[str]:
    """Files, or else keys of the line, that differ."""
    names = sorted({*one.files, *two.files})
    files = [name for name in names if one.files.get(name) != two.files.get(name)]
    keys = [key for key in ManifestEntry.model_fields if getattr(one, key) != getattr(two, key)]
    return files[:3] or keys


def _gaps(present: Iterable[int], n: int) -> Iterator[tuple[int, int]]:
    """Runs (first, end) of the numbers below ``n`` that are not present."""
    before = 0
    for index in (*sorted(present), n):
        if index > before:
            yield before, index
        before = index + 1
