"""A data set as one tar file: the same bytes for the same data set, safe to unpack.

Only files that the manifest lists go in, under one folder, sorted, owned by nobody, with time 0
and mode 0644. A link, device or unsafe name in the data set is an error.
"""

from __future__ import annotations

import contextlib
import gzip
import io
import os
import tarfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO

from sdgen.dataset import Dataset
from sdgen.dataset.output_file import output_file
from sdgen.dataset.records import TOP_FILES
from sdgen.errors import SdgenError
from sdgen.files import open_plain

ENDINGS = (".tar", ".tar.gz", ".tgz")


def export_tar(
    data: Dataset, output: Path, on_scene: Callable[[int, int], None] | None = None
) -> None:
    """Write ``output`` (``.tar``, or ``.tar.gz`` compressed); whole or not at all.

    Raises SdgenError for another ending, a place inside the data set or one that holds no plain
    file, InputError for a file of the data set that is missing, changed or no plain file, or a
    catalogue that is not the data set's.
    """
    if not output.name.endswith(ENDINGS):
        raise SdgenError(f"{output}: name it .tar, or .tar.gz to compress it")
    if data.path.resolve() in output.resolve().parents:
        raise SdgenError(f"{output}: lies inside the data set; choose another place")
    with output_file(output) as raw, _compressed(raw, output) as stream:
        _write(data, stream, on_scene)


@contextlib.contextmanager
def _compressed(raw: IO[bytes], output: Path) -> Iterator[IO[bytes]]:
    if output.name.endswith(".tar"):
        yield raw
        return
    # An empty name and time 0 keep gzip's header the same.
    with gzip.GzipFile(filename="", mode="wb", fileobj=raw, compresslevel=6, mtime=0) as stream:
        yield stream  # type: ignore[misc]


def _write(data: Dataset, stream: IO[bytes], on_scene: Callable[[int, int], None] | None) -> None:
    _ = data.catalog  # refused where it is not the one of the labels
    # "w|" writes front to back: nothing is kept in memory but one file. The manifest lists only
    # names of ours, which fit the 100 characters that USTAR has for one.
    root = f"sdgen-n{data.info.n}-s{data.info.seed}"
    with tarfile.open(fileobj=stream, mode="w|", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(TOP_FILES):
            # The manifest of many scenes is larger than any file that is read whole.
            with open_plain(data.path / name, name, links=False) as file:
                _add(archive, root, name, file, os.fstat(file.fileno()).st_size)
        for done, entry in enumerate(data.entries, start=1):
            item = data.scene(entry.id)
            for name in sorted(entry.files):
                content = item.file(name)
                _add(archive, root, item.where(name), io.BytesIO(content), len(content))
            if on_scene is not None:
                on_scene(done, len(data.entries))


def _add(archive: tarfile.TarFile, root: str, name: str, content: IO[bytes], size: int) -> None:
    member = tarfile.TarInfo(f"{root}/{name}")
    member.size = size
    member.mode = 0o644
    member.mtime = 0
    archive.addfile(member, content)
