"""Sealed tests: a digest of scenes that nobody has seen, published before and proved after.

Whoever runs a leaderboard draws a secret seed, builds a test set from it and publishes its *seal*:
a commitment to the seed (Brassard, Chaum and Crépeau 1988: a hash of it with a nonce hides it and
binds to it), what the build was asked for, and a digest of every scene. Once all detectors are
handed in the secret is published; from it anybody builds the same test set, byte for byte.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import secrets
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, field_validator

from sdgen.dataset import Dataset
from sdgen.dataset.disk import sha256_hex
from sdgen.dataset.output_file import check_output
from sdgen.dataset.records import (
    CONTENT_FILES,
    SHA256,
    VISIBILITY_FILE,
    DatasetInfo,
    ManifestEntry,
)
from sdgen.dataset.scene_folder import content_sha256
from sdgen.dataset.text import compact, plain, read_bytes, read_record, record_bytes
from sdgen.errors import InputError, SdgenError
from sdgen.options import MAX_SEED, BuildOptions
from sdgen.scene import Record

FORMAT: Literal["sdgen seal 1"] = "sdgen seal 1"

#: Files beside the scenes that readers go by, and that are the same whatever drew the pictures.
TABLES = ("catalogue.json", "assets.jsonl")

#: A smaller seed could be found by building the first scene of each.
LEAST_SEED = 2**48

Digest = Annotated[str, Field(pattern=SHA256)]


class Secret(Record):
    """What is kept until the test is opened: the seed, and 32 random bytes that keep a hash of it
    from being guessed."""

    seed: int = Field(ge=LEAST_SEED, le=MAX_SEED)
    nonce: str = Field(pattern=r"^[0-9a-f]{64}$")

    @property
    def commitment(self) -> str:
        """The digest that is published of it."""
        return hashlib.sha256(f"{FORMAT}:{self.seed}:{self.nonce}".encode()).hexdigest()


class SealedScene(Record):
    """What a scene is bound to: the digest of its content, that of all of its files, and that of
    its line in the manifest, but for the digests of what depends on the renderer (``drawn``)."""

    id: str
    content_sha256: Digest
    files_sha256: Digest
    entry_sha256: Digest


class Seal(Record):
    """What is published of a test set that nobody is to see. ``options`` has 0 for the seed;
    ``record_sha256`` is the digest of ``dataset.json`` without seed, renderers and versions,
    ``tables`` has those of TABLES."""

    format: Literal["sdgen seal 1"] = FORMAT
    commitment: Digest
    options: BuildOptions
    versions: dict[str, str]
    renderers: tuple[str, ...]
    catalogue_sha256: Digest
    assets_sha256: Digest
    record_sha256: Digest
    tables: dict[str, Digest]
    scenes: tuple[SealedScene, ...] = Field(min_length=1)

    @field_validator("scenes")
    @classmethod
    def _once(cls, scenes: tuple[SealedScene, ...]) -> tuple[SealedScene, ...]:
        if len({scene.id for scene in scenes}) < len(scenes):
            raise ValueError("a scene appears twice")
        return scenes

    @field_validator("tables")
    @classmethod
    def _all(cls, tables: dict[str, Digest]) -> dict[str, Digest]:
        if set(tables) != set(TABLES):
            raise ValueError(f"not the digests of {' and '.join(TABLES)}")
        return tables

    @property
    def digest(self) -> str:
        """One line that stands for all of it."""
        return hashlib.sha256(compact(plain(self)).encode("utf-8")).hexdigest()


def new_secret() -> Secret:
    """A secret from the system's source of randomness."""
    return Secret(
        seed=LEAST_SEED + secrets.randbelow(MAX_SEED - LEAST_SEED), nonce=secrets.token_hex(32)
    )


def secret_of(path: Path, make: bool = False) -> Secret:
    """The secret in a file; with ``make``, a new one where there is no such file, which only its
    owner may read. Raises InputError for a file that holds none."""
    if make and not path.exists():
        check_output(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        with os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as file:
            file.write(record_bytes(new_secret()))
    try:
        return read_record(Secret, path, str(path))
    except InputError as error:
        # Without what it holds: it may be nearly right, and errors end in logs.
        told = [re.split(r"[ (]got ", problem)[0].rstrip(" ,(") for problem in error.problems]
        raise InputError(told) from None


def without_seeds(error: SdgenError) -> SdgenError:
    """The error, with no number in its words that may be a secret seed."""
    told = SdgenError(re.sub(rf"\d{{{len(str(LEAST_SEED))},}}", "(secret)", str(error)))
    told.exit_code = error.exit_code
    return told


def seal(data: Dataset, secret: Secret) -> Seal:
    """The seal of a finished data set. Raises SdgenError when it was built with another seed, or
    holds a part of the scenes only."""
    if data.info.seed != secret.seed:
        raise SdgenError(f"{data.path}: was not built with the seed of this secret")
    if data.split is not None or data.info.failed:
        raise SdgenError(f"{data.path}: a seal is of a whole data set, with every scene made")
    return Seal(
        commitment=secret.commitment,
        options=data.info.options.model_copy(update={"seed": 0}),
        versions=data.info.versions,
        renderers=data.info.renderers,
        catalogue_sha256=data.info.catalogue_sha256,
        assets_sha256=data.info.assets_sha256,
        record_sha256=_record_digest(data.info),
        tables={name: _table_digest(data, name) for name in TABLES},
        scenes=tuple(
            SealedScene(
                id=entry.id,
                content_sha256=entry.content_sha256,
                files_sha256=_digest(entry.files),
                entry_sha256=_entry_digest(entry),
            )
            for entry in data.entries
        ),
    )


def _digest(value: dict[str, Any]) -> str:
    """Of plain values, in whatever order a mapping has its keys."""
    return sha256_hex(json.dumps(value, sort_keys=True).encode("utf-8"))


def drawn(name: str) -> bool:
    """Whether a file of a scene depends on the renderer: pictures, and what is counted in them."""
    return name == VISIBILITY_FILE or name.endswith((".png", ".jpg"))


def _entry_digest(entry: ManifestEntry) -> str:
    files = {name: "" if drawn(name) else digest for name, digest in entry.files.items()}
    return _digest({**plain(entry), "files": files})


def _record_digest(info: DatasetInfo) -> str:
    """Of all but the seed, and what another machine may have other: renderers, and versions, which
    scenes tell by their bytes."""
    options = info.options.model_copy(update={"seed": 0, "renderer": "auto"})
    other = {"seed": 0, "renderers": (), "versions": {}, "options": options}
    same = info.model_copy(update=other)
    return _digest(plain(same))


def _table_digest(data: Dataset, name: str) -> str:
    return sha256_hex(read_bytes(data.path / name, f"{data.path / name}"))


def read_seal(path: Path) -> Seal:
    """A seal from its file. Raises InputError."""
    return read_record(Seal, path, str(path))


def check_secret(sealed: Seal, secret: Secret) -> None:
    """Raises SdgenError unless this is the secret that was committed to."""
    if secret.commitment != sealed.commitment:
        raise SdgenError("this is not the secret that the seal commits to: another seed or nonce")


def opened(
    sealed: Seal,
    secret: Secret,
    data: Dataset,
    on_scene: Callable[[int, int], None] | None = None,
) -> Iterator[str]:
    """What of a data set is not what was sealed, byte by byte; nothing when all of it is.

    Every file is read and hashed. What is ``drawn`` is compared with the seal when the same
    renderer drew it: others round colours otherwise, which changes no label (``same_pictures``).
    Raises SdgenError for another secret.
    """
    check_secret(sealed, secret)
    if data.info.seed != secret.seed:
        yield "dataset.json: seed: not the one of the secret"
    if data.info.options.model_copy(update={"seed": 0}) != _as_asked(sealed, data):
        yield "dataset.json: options: not those of the seal"
    for name in ("catalogue_sha256", "assets_sha256"):
        if getattr(data.info, name) != getattr(sealed, name):
            yield f"dataset.json: {name}: not that of the seal"
    if _record_digest(data.info) != sealed.record_sha256:
        yield "dataset.json: not the one that was sealed (its splits, counts or words)"
    for name, digest in sealed.tables.items():
        if _table_digest(data, name) != digest:
            yield f"{name}: not the one that was sealed"
    yield from _strays(data)
    there = {entry.id: entry for entry in data.entries}
    known = {scene.id for scene in sealed.scenes}
    for name in sorted(there.keys() - known):
        if (data.path / "scenes" / name).exists():
            yield f"scenes/{name}: was not sealed"
        else:
            yield f"manifest.jsonl: {name}: was not sealed"
    order = [entry.id for entry in data.entries if entry.id in known]
    if order != [scene.id for scene in sealed.scenes if scene.id in there]:
        yield "manifest.jsonl: its scenes stand in another order"
    if data.info.renderers and not sealed.renderers:
        yield "the seal is of a data set without pictures"
    pictures = same_pictures(sealed, data)
    for done, scene in enumerate(sealed.scenes, start=1):
        entry = there.get(scene.id)
        if entry is None:
            yield f"scenes/{scene.id}: is missing"
        else:
            yield from _differs(scene, entry, data, pictures)
        if on_scene is not None:
            on_scene(done, len(sealed.scenes))


def _strays(data: Dataset) -> Iterator[str]:
    """What lies among the scenes and is in no manifest."""
    files = {entry.id: set(entry.files) for entry in data.entries}
    for folder in sorted((data.path / "scenes").iterdir()):
        if folder.name not in files:
            yield f"scenes/{folder.name}: was not sealed"
            continue
        for path in sorted(folder.rglob("*")):
            name = path.relative_to(folder).as_posix()
            if path.is_symlink() or (name not in files[folder.name] and not path.is_dir()):
                yield f"scenes/{folder.name}/{name}: was not sealed"


def _as_asked(sealed: Seal, data: Dataset) -> BuildOptions:
    """The sealed options, with the renderer that was at hand: it decides no content."""
    return sealed.options.model_copy(update={"renderer": data.info.options.renderer})


def same_pictures(sealed: Seal, data: Dataset) -> bool:
    """True when the same renderer drew both, so that pictures are the same, too."""
    return set(data.info.renderers) == set(sealed.renderers)


def _differs(
    scene: SealedScene, entry: ManifestEntry, data: Dataset, pictures: bool
) -> Iterator[str]:
    item, where = data.scene(entry.id), f"scenes/{entry.id}"
    content: dict[str, bytes] = {}
    for name in sorted(entry.files):
        try:
            read = item.file(name)  # refuses one that is not what the manifest says
        except InputError as error:
            yield from error.problems
            return
        if name in CONTENT_FILES:
            content[name] = read
    if content.keys() < set(CONTENT_FILES) or content_sha256(content) != scene.content_sha256:
        yield f"{where}: another scene than the one sealed"
    elif _entry_digest(entry) != scene.entry_sha256:
        yield f"manifest.jsonl: {entry.id}: not what was sealed (its split, what it holds)"
    elif pictures and _digest(entry.files) != scene.files_sha256:
        yield f"{where}: the scene that was sealed, with other views"
