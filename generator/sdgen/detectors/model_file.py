"""A trained detector in a folder: ``model.json``, ``model.npz``, a card; strangers' data.

Nothing in it is run: the arrays are numbers, read without pickle and checked one by one.
"""

from __future__ import annotations

import io
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined
from pydantic import AllowInfNan, Field

from sdgen.catalog.records import Label
from sdgen.dataset.disk import sha256_hex, write_synced
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.records import SHA256
from sdgen.dataset.text import read_record, record_bytes
from sdgen.detectors.scored import Array
from sdgen.errors import InputError
from sdgen.files import read_plain
from sdgen.scene import Record

FORMAT = "sdgen detector 1"
RECORD, ARRAYS, CARD = "model.json", "model.npz", "README.md"
#: Bytes of a file of arrays, packed and unpacked: ours have a few million.
_MOST_PACKED, _MOST_BYTES = 200_000_000, 600_000_000

Kind = Literal["prior", "objects", "description", "graph", "image", "cnn"]
Share = Annotated[float, Field(ge=0.0, le=1.0), AllowInfNan(False)]


class TrainedOn(Record):
    """The data set a detector learned from: its seed, digests and what was read of it."""

    dataset: str
    seed: int
    manifest_sha256: str = Field(pattern=SHA256)
    catalogue_sha256: str = Field(pattern=SHA256)
    train_scenes: int
    train_twins: int
    train_anomalies: int
    val_scenes: int


class ValScores(Record):
    """What a detector does on the scenes its threshold was chosen by; means of scenes, each over
    those that it is defined for."""

    split: Literal["val", "train"]
    f1: float | None
    precision: float | None
    recall: float | None
    false_alarms_per_scene: float


class Model(Record):
    """``model.json``."""

    format: Literal["sdgen detector 1"] = "sdgen detector 1"
    kind: Kind
    seed: int = Field(ge=0)
    graph_view: Literal["full", "neutral", "perceived"]
    hazards: tuple[str, ...] = Field(min_length=1)
    labels: tuple[Label, ...]
    words: dict[str, tuple[str, ...]]
    threshold: Share
    examples: int
    examples_wrong: int
    settings: dict[str, dict[str, float]]
    trained_on: TrainedOn
    val: ValScores
    versions: dict[str, str]
    arrays_sha256: str = Field(pattern=SHA256)


def array_bytes(arrays: Mapping[str, Array]) -> bytes:
    """Arrays as bytes, the same ones for the same arrays."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as packed:
        for name in sorted(arrays):
            one = io.BytesIO()
            np.lib.format.write_array(one, np.ascontiguousarray(arrays[name]), allow_pickle=False)
            # A date of its own: the clock is no part of a model.
            info = zipfile.ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(info, one.getvalue())
    return out.getvalue()


def arrays_from(data: bytes, where: str) -> dict[str, Array]:
    """The arrays of a file. InputError for one that is damaged, too large, or holds more than
    numbers."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as packed:
            infos = packed.infolist()
            if sum(info.file_size for info in infos) > _MOST_BYTES:
                raise ValueError(f"holds more than {_MOST_BYTES // 1_000_000} MB")
            return {
                info.filename.removesuffix(".npy"): _array(packed.read(info), info.filename)
                for info in infos
            }
    except (ValueError, zipfile.BadZipFile, zlib.error, EOFError, RuntimeError) as error:
        reason = " ".join(str(error).split())
        raise InputError([f"{where}: no arrays of a detector ({reason})"]) from None
    except (NotImplementedError, OSError, SyntaxError, MemoryError) as error:
        raise InputError([f"{where}: no arrays of a detector ({type(error).__name__})"]) from None


def _array(data: bytes, name: str) -> Array:
    """One array, of as many bytes as its head says: nothing larger is made room for."""
    stream = io.BytesIO(data)
    if np.lib.format.read_magic(stream) != (1, 0):
        raise ValueError(f"{name}: another version of numpy's format")
    shape, fortran, dtype = np.lib.format.read_array_header_1_0(stream)
    if dtype.kind not in "fi" or fortran:
        raise ValueError(f"{name}: holds {dtype}, no plain numbers")
    size = dtype.itemsize
    for extent in shape:
        size *= extent
    if len(data) - stream.tell() != size:
        raise ValueError(f"{name}: of another size than it says")
    return np.frombuffer(data, dtype=dtype, offset=stream.tell()).reshape(shape)


def write_model(folder: Path, model: Model, arrays: bytes, command: str) -> None:
    """Write a detector's folder, whole or not at all. SdgenError where something is there."""
    with output_folder(folder) as partial:
        write_synced(partial / RECORD, record_bytes(model))
        write_synced(partial / ARRAYS, arrays)
        write_synced(partial / CARD, card(model, len(arrays), command, folder).encode("utf-8"))


def read_model(folder: Path) -> tuple[Model, dict[str, Array]]:
    """A detector's folder. InputError for what is none, or changed since it was written."""
    if not (folder / RECORD).is_file():
        problem = f"no trained detector (it has no {RECORD}); make one: sdgen train"
        raise InputError([f"{folder}: {problem if folder.is_dir() else 'no such folder'}"])
    model = read_record(Model, folder / RECORD, str(folder / RECORD))
    where = str(folder / ARRAYS)
    if len(model.labels) != len(model.hazards):
        raise InputError([f"{folder / RECORD}: labels: not one a hazard"])
    data = read_plain(folder / ARRAYS, where, _MOST_PACKED, links=False)
    if sha256_hex(data) != model.arrays_sha256:
        raise InputError([f"{where}: changed since it was written; train it again"])
    return model, arrays_from(data, where)


def card(model: Model, size: int, command: str, folder: Path) -> str:
    """The text of a detector's card."""
    environment = Environment(
        loader=PackageLoader("sdgen.detectors", "templates"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # Markdown, not HTML
    )
    template = environment.get_template("model_card.md.j2")
    return template.render(model=model, size=size, command=command, name=folder.name)
