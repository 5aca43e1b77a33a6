"""What a LeRobot data set says of itself: ``meta/`` and the types of its columns (v3.0)."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sdgen.agent.film.lerobot_rows import FEATURES, RGB
from sdgen.agent.film.lerobot_stats import Stats, together
from sdgen.dataset.text import pretty

VERSION = "v3.0"
#: Files of a chunk, and megabytes after which the next episode begins another file.
CHUNK, DATA_MB, VIDEO_MB = 1000, 100, 200

_FILE = "chunk-{chunk_index:03d}/file-{file_index:03d}"
DATA_PATH = f"data/{_FILE}.parquet"
VIDEO_PATH = f"videos/{{video_key}}/{_FILE}.mp4"
EPISODES_PATH = f"meta/episodes/{_FILE}.parquet"


def place(number: int) -> dict[str, int]:
    """The chunk and the file of the ``number``-th file, from 0."""
    return {"chunk_index": number // CHUNK, "file_index": number % CHUNK}


def info(
    episodes: int, frames: int, fps: int, shape: Sequence[int], codec: str | None
) -> dict[str, Any]:
    """``meta/info.json``; ``shape`` is (H, W, 3), ``codec`` that of the videos, None of images."""
    rgb: dict[str, Any] = {
        "dtype": "video" if codec else "image",
        "shape": list(shape),
        "names": ["height", "width", "channels"],
    }
    if codec:
        rgb["info"] = {
            "video.height": shape[0],
            "video.width": shape[1],
            "video.codec": codec,
            "video.pix_fmt": "yuv420p",
            "video.is_depth_map": False,
            "video.fps": fps,
            "video.channels": shape[2],
            "has_audio": False,
        }
    others = {
        name: {"dtype": dtype, "shape": [length], "names": list(names) if names else None}
        for name, (dtype, length, names) in FEATURES.items()
    }
    return {
        "codebase_version": VERSION,
        "robot_type": "sdgen",
        "total_episodes": episodes,
        "total_frames": frames,
        "total_tasks": 1,
        "chunks_size": CHUNK,
        "data_files_size_in_mb": DATA_MB,
        "video_files_size_in_mb": VIDEO_MB,
        "fps": fps,
        "splits": {"train": f"0:{episodes}"},
        "data_path": DATA_PATH,
        "video_path": VIDEO_PATH if codec else None,
        "features": {RGB: rgb} | others,
    }


def data_schema(images: bool) -> Any:
    """The Arrow schema of the frames, with the features that ``datasets`` reads there."""
    import pyarrow as pa

    types = {
        "float32": pa.float32(),
        "int64": pa.int64(),
        "bool": pa.bool_(),
    }
    fields, features = [], dict[str, Any]()
    if images:
        fields.append(pa.field(RGB, pa.struct({"bytes": pa.binary(), "path": pa.string()})))
        features[RGB] = {"_type": "Image"}
    for name, (dtype, length, _) in FEATURES.items():
        value = {"dtype": dtype, "_type": "Value"}
        one = length == 1
        fields.append(pa.field(name, types[dtype] if one else pa.list_(types[dtype], length)))
        features[name] = value if one else {"feature": value, "length": length, "_type": "Sequence"}
    told = json.dumps({"info": {"features": features}})
    return pa.schema(fields, metadata={"huggingface": told})


def write_meta(
    folder: Path, told: Mapping[str, Any], task: str, rows: Sequence[Mapping[str, Any]]
) -> None:
    """Write ``info.json``, ``stats.json``, ``tasks.parquet`` and the episodes; a row has its
    ``stats`` by feature and what else the table says of it."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    meta = folder / "meta"
    meta.mkdir(exist_ok=True)
    (meta / "info.json").write_text(pretty(told) + "\n", encoding="utf-8")
    stats = {name: _lists(of) for name, of in together([row["stats"] for row in rows]).items()}
    (meta / "stats.json").write_text(pretty(stats) + "\n", encoding="utf-8")
    pq.write_table(_tasks(task), meta / "tasks.parquet")
    path = folder / EPISODES_PATH.format(**place(0))
    path.parent.mkdir(parents=True)
    pq.write_table(pa.Table.from_pylist([_flat(row) for row in rows]), path)


def _flat(row: Mapping[str, Any]) -> dict[str, Any]:
    out = {name: value for name, value in row.items() if name != "stats"}
    for feature, stats in row["stats"].items():
        out |= {f"stats/{feature}/{name}": value for name, value in _lists(stats).items()}
    where = {f"meta/episodes/{name}": value for name, value in place(0).items()}
    return out | where


def _lists(stats: Stats) -> dict[str, Any]:
    return {name: value.tolist() for name, value in stats.items()}


def _tasks(task: str) -> Any:
    """A table as pandas stores it, with the tasks as its index: so the client looks them up."""
    import pyarrow as pa

    index = "__index_level_0__"

    def column(name: str | None, field: str, kind: str, of: str) -> dict[str, Any]:
        return {
            "name": name,
            "field_name": field,
            "pandas_type": kind,
            "numpy_type": of,
            "metadata": None,
        }

    told = {
        "index_columns": [index],
        "column_indexes": [],
        "columns": [
            column("task_index", "task_index", "int64", "int64"),
            column(None, index, "unicode", "object"),
        ],
        "creator": {"library": "pyarrow", "version": pa.__version__},
        "pandas_version": "2.0.0",
    }
    table = pa.table({"task_index": pa.array([0], pa.int64()), index: pa.array([task])})
    return table.replace_schema_metadata({"pandas": json.dumps(told)})
