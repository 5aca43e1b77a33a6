"""``fetched.json``: what was fetched into a folder, from where, under which licence.

By it the next run knows what is there, and notices what is missing or damaged.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, ValidationError

from sdgen.dataset.disk import file_sha256
from sdgen.dataset.output_file import write_output
from sdgen.errors import AssetError, InputError
from sdgen.files import read_plain
from sdgen.importing.member_names import name_parts
from sdgen.importing.sources import Source
from sdgen.scene import Record

FILE = "fetched.json"
#: Room for the files of a hundred thousand models.
_MAX_BYTES = 500_000_000

Digest = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Count = Annotated[int, Field(ge=0)]


class FetchedFile(Record):
    """A file in the folder, as it was put there; ``path`` begins at the folder."""

    path: str
    bytes: Count
    sha256: Digest


class Download(Record):
    """What came over the line, as it came: an archive, or a file of its own."""

    address: str
    bytes: Count
    sha256: Digest
    validator: str = ""


class FetchedModel(Record):
    """A model: its licence, in its source's own words where it has any; ``mark`` is its version."""

    name: str
    licence: str
    mark: str = ""
    downloads: tuple[Download, ...]
    files: tuple[FetchedFile, ...]


class Fetched(Record):
    """The whole file."""

    format: Literal[1] = 1
    source: str
    homepage: str
    licence: str
    licence_url: str
    attribution: str
    models: tuple[FetchedModel, ...]


def read_fetched(folder: Path, source: Source) -> dict[str, FetchedModel]:
    """Models by name; none where nothing was fetched yet.

    Raises AssetError for a file that is none of ours, or of another source.
    """
    path = folder / FILE
    if not path.exists() and not path.is_symlink():
        return {}
    advice = "name another --out, or move it away"
    try:
        found = Fetched.model_validate_json(read_plain(path, str(path), _MAX_BYTES, links=False))
        for model in found.models:
            for file in model.files:
                name_parts(file.path)  # never outside the folder
    except (ValidationError, ValueError):
        raise AssetError([f"{path}: is not as 'assets fetch' writes it; {advice}"]) from None
    except InputError as error:
        raise AssetError(error.problems) from None
    if found.source != source.id:
        raise AssetError([f"{path}: lists models of {found.source[:80]!r}; {advice}"])
    return {model.name: model for model in found.models}


def write_fetched(folder: Path, source: Source, models: Mapping[str, FetchedModel]) -> None:
    """Write the file anew, models sorted by name."""
    whole = Fetched(
        source=source.id,
        homepage=source.homepage,
        licence=source.licence,
        licence_url=source.licence_url,
        attribution=source.attribution,
        models=tuple(model for _, model in sorted(models.items())),
    )
    write_output(folder / FILE, f"{whole.model_dump_json(indent=1)}\n".encode())


def whole(folder: Path, model: FetchedModel) -> bool:
    """Whether every file of the model is there, byte for byte."""
    for file in model.files:
        path = folder / file.path
        try:
            if path.is_symlink() or not path.is_file() or path.stat().st_size != file.bytes:
                return False
            if file_sha256(path) != file.sha256:
                return False
        except OSError:
            return False
    return True
