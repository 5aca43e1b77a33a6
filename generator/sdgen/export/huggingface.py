"""A data set as a folder of Parquet files that ``datasets.load_dataset`` reads.

Three tables, ``views`` (a row a view, pictures as images), ``scenes`` (a row a scene) and
``anomalies``, each with the data set's splits; ``twin_views`` and ``twin_scenes`` of twins.
Pictures are the files' own bytes; depth and masks stay 16-bit. ``croissant.json`` describes the
same files.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.output_folder import output_folder
from sdgen.dataset.text import pretty
from sdgen.export.croissant import croissant
from sdgen.export.each_scene import check_models
from sdgen.export.formats import OnScene
from sdgen.export.home_glb import home_glb
from sdgen.export.huggingface_card import card
from sdgen.export.huggingface_features import anomaly_features, scene_features, view_features
from sdgen.export.rows import picture_files, row_of_scene, rows_of_anomalies, rows_of_views
from sdgen.export.shards import SHARD_BYTES, groups, scenes_in
from sdgen.library import Library

if TYPE_CHECKING:
    import datasets

#: Rows, and about how many bytes of them, that are compressed and read together: what is held in
#: memory.
ROWS, ROWS_BYTES = 100, 16_000_000
#: About what a value is in memory beside its text.
_VALUE_BYTES = 64


def export_huggingface(
    data: Dataset, output: Path, on_scene: OnScene = None, library: Library | None = None
) -> None:
    """Write Parquet files and their card into a new folder; the same bytes for the same data set
    and versions of pyarrow. With a ``library``, a scene's row has its GLB in a column ``mesh``.

    Raises SdgenError for a bad place, InputError for a file that is missing or changed, or scenes
    that other models were built of, ModuleNotFoundError without datasets
    (pip install sdgen[huggingface]).
    """
    if library is not None:
        check_models(data, library)
    columns = {
        "views": view_features(data.info.options.sensors),
        "scenes": scene_features(library is not None),
        "anomalies": anomaly_features(),
    }
    total, done = scenes_in(data), 0
    files: dict[str, dict[str, str]] = {}
    with output_folder(output) as folder:
        for kind, split, items in groups(data):
            prefix = "" if kind == "scene" else f"{kind}_"
            with ExitStack() as stack:
                views, scenes, anomalies = (
                    stack.enter_context(_Parquet(folder, f"{prefix}{name}", split, of))
                    for name, of in columns.items()
                )
                for item in items:
                    with derived_from(data, item):
                        for row in rows_of_views(item):
                            views.add(row | _pictures(item, row["view"]))
                        scenes.add(row_of_scene(item) | _mesh(item, library))
                        for row in rows_of_anomalies(item):
                            anomalies.add(row)
                    done += 1
                    if on_scene is not None:
                        on_scene(done, total)
            for table in (views, scenes, anomalies):
                if table.rows:
                    files.setdefault(table.name, {})[split] = f"{table.name}/{split}-*.parquet"
        described = croissant(data, {name: columns[name.rsplit("_", 1)[-1]] for name in files})
        (folder / "croissant.json").write_text(pretty(described) + "\n", encoding="utf-8")
        (folder / "README.md").write_text(card(data, files), encoding="utf-8")


def _pictures(item: SceneItem, view: int) -> dict[str, Any]:
    names = picture_files(item, view)
    return {column: _file(item.file(name)) for column, name in names.items()}


def _mesh(item: SceneItem, library: Library | None) -> dict[str, Any]:
    return {} if library is None else {"mesh": _file(home_glb(item.scene, library))}


def _file(content: bytes) -> dict[str, Any]:
    """A file as columns of images and meshes store it."""
    return {"bytes": content, "path": None}


class _Parquet:
    """The files of one split of one table: ``NAME/SPLIT-00000-of-00001.parquet`` and on."""

    def __init__(self, folder: Path, name: str, split: str, features: datasets.Features) -> None:
        self.name = name
        self.rows = 0
        self._folder = folder / name
        self._split = split
        self._schema = features.arrow_schema
        self._waiting: list[Mapping[str, Any]] = []
        self._writer: Any = None
        self._files: list[Path] = []
        self._bytes = 0
        self._held = 0

    def __enter__(self) -> _Parquet:
        return self

    def __exit__(self, kind: object, *error: object) -> None:
        if kind is None:
            self._flush()
        if self._writer is not None:
            self._writer.close()
        for number, path in enumerate(self._files):
            last = f"{self._split}-{number:05d}-of-{len(self._files):05d}.parquet"
            path.rename(path.with_name(last))

    def add(self, row: Mapping[str, Any]) -> None:
        """Add a row."""
        self.rows += 1
        self._waiting.append(row)
        weight = sum(_weight(value) for value in row.values())
        self._bytes += weight
        self._held += weight
        if len(self._waiting) >= ROWS or self._held >= ROWS_BYTES:
            self._flush()

    def _flush(self) -> None:
        if not self._waiting:
            return
        import pyarrow as pa
        from pyarrow.parquet import ParquetWriter

        if self._writer is None:
            self._folder.mkdir(exist_ok=True)
            path = self._folder / f"{self._split}-{len(self._files):05d}.parquet"
            self._files.append(path)
            # Pictures are compressed already.
            self._writer = ParquetWriter(path, self._schema, compression="zstd")
        self._writer.write_table(pa.Table.from_pylist(self._waiting, schema=self._schema))
        self._waiting, self._held = [], 0
        if self._bytes >= SHARD_BYTES:
            self._writer.close()
            self._writer, self._bytes = None, 0


def _weight(value: Any) -> int:
    """About how many bytes a value of a row takes: a scene's lists weigh more than its texts."""
    if isinstance(value, Mapping):
        return _VALUE_BYTES + sum(map(_weight, value.values()))
    if isinstance(value, list | tuple):
        return _VALUE_BYTES + sum(map(_weight, value))
    return _VALUE_BYTES + len(value) if isinstance(value, str | bytes) else _VALUE_BYTES
