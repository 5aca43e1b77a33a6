"""A data set as WebDataset shards: a tar file of samples, a sample a view.

``views/train-000000.tar`` and on hold the views of a split, ``twin_views`` those of twins. Of a
sample ``000041-03`` the members are ``rgb.png`` (or ``rgb.jpg``), ``depth.png16``,
``instance.png16``, ``part.png`` and ``json`` (:func:`sdgen.export.rows.rows_of_views`). The name
``png16`` keeps 16-bit pictures from the decoders of WebDataset, which would make them 8 bits.
``scenes/train-000000.tar`` holds a sample a scene: ``000041`` with its JSON files as they are.
"""

from __future__ import annotations

import io
import tarfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from sdgen.dataset import Dataset
from sdgen.dataset.derived import derived_from
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.records import CONTENT_FILES, VISIBILITY_FILE
from sdgen.dataset.text import compact
from sdgen.errors import SdgenError
from sdgen.export.formats import OnScene
from sdgen.export.rows import picture_files, rows_of_views
from sdgen.export.shards import SHARD_BYTES, groups, scenes_in

#: Column of a picture -> how its member ends; of colours the file's own ending is kept.
ENDINGS = {"depth": "depth.png16", "instance": "instance.png16", "part": "part.png"}
#: Threads that read files ahead.
THREADS = 2
#: Files of a sample of a scene.
SCENE_FILES = (*CONTENT_FILES, VISIBILITY_FILE)


def export_webdataset(data: Dataset, output: Path, on_scene: OnScene = None) -> None:
    """Write shards into a new folder; the same bytes for the same data set.

    Raises SdgenError for a bad place or a data set without pictures, InputError for a file that is
    missing or changed.
    """
    if not data.info.options.sensors:
        raise SdgenError(f"{data.path}: has no pictures; WebDataset holds a sample a view")
    total, done = scenes_in(data), 0
    with output_folder(output) as folder, ThreadPoolExecutor(THREADS) as pool:
        for kind, split, scenes in groups(data):
            prefix = "" if kind == "scene" else f"{kind}_"
            with (
                _Shards(folder / f"{prefix}views", split) as of_views,
                _Shards(folder / f"{prefix}scenes", split) as of_scenes,
            ):
                for item in scenes:
                    # Files are read and digested while records are: both wait for no interpreter.
                    files = {name: pool.submit(item.file, name) for name in item.entry.files}
                    with derived_from(data, item):
                        rows = list(rows_of_views(item))
                    for row in rows:
                        members = {"json": compact(row).encode()}
                        for column, name in picture_files(item, row["view"]).items():
                            ending = ENDINGS.get(column) or name.rsplit("/", 1)[1]
                            members[ending] = files[name].result()
                        of_views.add(f"{item.id}-{row['view']:02d}", members)
                    of_scenes.add(item.id, {name: files[name].result() for name in SCENE_FILES})
                    done += 1
                    if on_scene is not None:
                        on_scene(done, total)


class _Shards:
    """Tar files of about ``SHARD_BYTES`` each, written front to back."""

    def __init__(self, folder: Path, name: str) -> None:
        self._folder = folder
        self._name = name
        self._number = -1
        self._bytes = SHARD_BYTES
        self._tar: tarfile.TarFile | None = None

    def __enter__(self) -> _Shards:
        return self

    def __exit__(self, *error: Any) -> None:
        if self._tar is not None:
            self._tar.close()

    def add(self, key: str, members: dict[str, bytes]) -> None:
        """Add a sample, to a new file where the last one is full."""
        if self._tar is None or self._bytes >= SHARD_BYTES:
            if self._tar is not None:
                self._tar.close()
            self._folder.mkdir(exist_ok=True)
            self._number += 1
            self._bytes = 0
            path = self._folder / f"{self._name}-{self._number:06d}.tar"
            self._tar = tarfile.open(path, "w", format=tarfile.USTAR_FORMAT)  # noqa: SIM115
        for ending, content in sorted(members.items()):
            member = tarfile.TarInfo(f"{key}.{ending}")
            member.size, member.mode, member.mtime = len(content), 0o644, 0
            self._tar.addfile(member, io.BytesIO(content))
            self._bytes += len(content)
