"""Models from their source into a folder, laid out as the source does; a second run goes on.

``FOLDER/<model>/`` holds an unpacked model, of ReplicaCAD the folder itself is the data set;
``FOLDER/fetched.json`` says what was fetched. A model appears whole or not at all; what has come
of one that broke off waits in ``FOLDER/.fetching``.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from sdgen.dataset.disk import file_sha256
from sdgen.dataset.output_file import refuse_data_set, refuse_links
from sdgen.errors import AssetError, SdgenError, UsageError, did_you_mean
from sdgen.importing.archives import unpack
from sdgen.importing.client import Client, NotThere
from sdgen.importing.download import Got, changed, download
from sdgen.importing.fetched import (
    Download,
    FetchedFile,
    FetchedModel,
    read_fetched,
    whole,
    write_fetched,
)
from sdgen.importing.listing import COMMON, RemoteFile, RemoteModel
from sdgen.importing.sources import Source
from sdgen.locks import FileLock
from sdgen.scratch import scratch_folder

#: What has come of files that are not whole yet.
PARTS = ".fetching"
#: Words of a licence that asks more than the one that was accepted.
_STRICTER = re.compile(r"non.?commercial|no.?deriv|share.?alike|all rights reserved", re.I)


class NoArchive(Exception):
    """A model that its source lists, and has at none of its addresses."""


@dataclass(frozen=True)
class FetchReport:
    """Names of models fetched now, of those that were there, of those that the source lists and
    has no archive of, and problems of the others."""

    fetched: tuple[str, ...]
    kept: tuple[str, ...]
    absent: tuple[str, ...]
    problems: tuple[str, ...]


def chosen(models: Mapping[str, RemoteModel], names: Sequence[str]) -> list[RemoteModel]:
    """The models of these names, each once, and what belongs to all of them (first).

    Raises UsageError with the nearest name for one that is not listed.
    """
    for name in names:
        if name not in models:
            raise UsageError(f"no model {name!r}{did_you_mean(name, list(models))}; see --list")
    return [models[name] for name in dict.fromkeys([*[COMMON] * (COMMON in models), *names])]


def fetch(
    source: Source,
    wanted: Sequence[RemoteModel],
    out: Path,
    client: Client,
    on_model: Callable[[int, int], None] | None = None,
) -> FetchReport:
    """Fetch models into the folder ``out``, made when missing; ``on_model(done, all)``.

    What is there as it was fetched, and is the source's newest, is left. A model that cannot be
    had is a problem in the report, and the rest is fetched. Raises AssetError for a folder that
    holds another source's models, SdgenError when another fetch is at work in it.
    """
    refuse_links(out, "folder")
    refuse_data_set(out / PARTS)
    records = read_fetched(out, source)
    fetched, kept, absent, problems = [], [], [], []
    with _parts_folder(out) as parts:
        for number, model in enumerate(wanted, start=1):
            try:
                if _as_it_should_be(model, records.get(model.name), out, client):
                    kept.append(model.name)
                else:
                    _Fetching(source, model, out, parts, client).run(records)
                    fetched.append(model.name)
            except NoArchive:
                absent.append(model.name)
            except AssetError as error:
                problems += [f"{model.name}: {problem}" for problem in error.problems]
            if on_model is not None:
                on_model(number, len(wanted))
    return FetchReport(tuple(fetched), tuple(kept), tuple(absent), tuple(problems))


def client_of(source: Source) -> Client:
    """Who asks the source. Raises SdgenError where no program may, and says what to do instead."""
    if source.by_hand:
        raise SdgenError(f"{source.id}: {source.by_hand} ({source.homepage})")
    return Client(source.base, source.redirects)


@contextmanager
def _parts_folder(out: Path) -> Iterator[Path]:
    new, parts = not out.exists(), out / PARTS
    parts.mkdir(parents=True, exist_ok=True)
    lock = FileLock.take(parts / "lock")
    if lock is None:
        raise SdgenError(f"{out}: another fetch is at work in it; wait for it, or choose another")
    try:
        yield parts
    finally:
        if not list(parts.glob("*.part")):
            shutil.rmtree(parts, ignore_errors=True)
        lock.release()
        if new:
            with contextlib.suppress(OSError):
                out.rmdir()  # where nothing came


def _as_it_should_be(
    model: RemoteModel, record: FetchedModel | None, out: Path, client: Client
) -> bool:
    """Whether nothing has to be fetched: all is there, and the source has nothing newer."""
    if record is None or not whole(out, record):
        return False
    if model.mark:
        return record.mark == model.mark
    had = {load.address: load for load in record.downloads}
    stated = [file.choices[0].digest for file in model.files]
    if all(stated):  # the list itself says what each file is
        return record.mark == _mark_of(model) and len(had) == len(model.files)
    for file in model.files:
        here = [choice for choice in file.choices if choice.address in had]
        if not here:
            return False
        load = had[here[0].address]
        if changed(client, here[0], load.validator, load.bytes):
            return False
    return True


def _mark_of(model: RemoteModel) -> str:
    """The version of a model: its source's word for it, or the digests of its files."""
    if model.mark or not all(file.choices[0].digest for file in model.files):
        return model.mark
    return " ".join((file.choices[0].digest or ("", ""))[1] for file in model.files)


class _Fetching:
    """One model on its way."""

    def __init__(
        self, source: Source, model: RemoteModel, out: Path, parts: Path, client: Client
    ) -> None:
        self._source = source
        self._model = model
        self._out = out
        self._parts = parts
        self._client = client

    def run(self, records: dict[str, FetchedModel]) -> None:
        """Fetch it, note it in ``records`` and their file, and put it in its place."""
        model = self._model
        if _STRICTER.search(model.licence) and not self._source.non_commercial:
            raise AssetError(
                [f"its licence is {model.licence!r}, not the {self._source.licence} accepted"]
            )
        with scratch_folder(self._parts) as scratch:
            staged = scratch / "model"
            staged.mkdir()
            self._check_places(records.get(model.name))
            # All of them first: what has come whole is still there when a later one breaks off.
            come = [(file, self._download(file)) for file in model.files]
            for file, got in come:
                self._stage(file, got, staged)
            record = FetchedModel(
                name=model.name,
                licence=model.licence or self._source.licence,
                mark=_mark_of(model),
                downloads=tuple(_record_of(got) for _, got in come),
                files=tuple(_files_below(staged)),
            )
            # Noted first: a model that is noted and not there is fetched again, one that is there
            # and not noted would be somebody else's.
            records[model.name] = record
            write_fetched(self._out, self._source, records)
            self._place(staged, scratch / "old")

    def _stage(self, file: RemoteFile, got: Got, staged: Path) -> None:
        try:
            if file.path:
                target = staged / file.path
                target.parent.mkdir(parents=True, exist_ok=True)
                os.replace(got.path, target)
            else:
                opened = unpack(got.path, staged.with_name("archive"), shown=got.address)
                os.replace(_without_own_folder(opened, self._model.name), staged / self._model.name)
        finally:
            got.discard()

    def _download(self, file: RemoteFile) -> Got:
        problems: list[str] = []
        for choice in file.choices:
            try:
                return download(self._client, choice, self._parts)
            except NotThere as error:
                problems += error.problems
        raise AssetError(problems) if file.path else NoArchive

    def _check_places(self, before: FetchedModel | None) -> None:
        """Nothing that was not fetched is written over."""
        ours = {file.path for file in before.files} if before else set()
        for path in self._tops():
            place = self._out / path
            there = place.exists() or place.is_symlink()
            known = any(name == path or name.startswith(f"{path}/") for name in ours)
            if there and not known:
                raise AssetError([f"{place}: is there, and was not fetched; move it away"])

    def _tops(self) -> list[str]:
        """What is put in place as one: the model's folder, or each file of its own."""
        if any(file.path for file in self._model.files):
            return [file.path for file in self._model.files]
        return [self._model.name]

    def _place(self, staged: Path, old: Path) -> None:
        old.mkdir()
        for number, path in enumerate(self._tops()):
            place = self._out / path
            place.parent.mkdir(parents=True, exist_ok=True)
            if place.exists() or place.is_symlink():
                os.replace(place, old / str(number))
            os.replace(staged / path, place)


def _record_of(got: Got) -> Download:
    return Download(
        address=got.address, bytes=got.bytes, sha256=got.sha256, validator=got.validator
    )


def _without_own_folder(folder: Path, name: str) -> Path:
    """The folder of the model itself, where the archive has it within."""
    inner = list(folder.iterdir())
    if len(inner) == 1 and inner[0].is_dir() and inner[0].name == name:
        return inner[0]
    return folder


def _files_below(folder: Path) -> Iterator[FetchedFile]:
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            name = path.relative_to(folder).as_posix()
            yield FetchedFile(path=name, bytes=path.stat().st_size, sha256=file_sha256(path))
