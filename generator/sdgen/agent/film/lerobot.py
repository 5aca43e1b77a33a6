"""Episodes as a data set of LeRobot (format v3.0), for learning to act from what is seen.

Written with pyarrow and PyAV alone (pip install sdgen[lerobot]); neither LeRobot nor torch is
needed. A frame is what the agent saw and where it was, with what it did then, what that was worth
and whether it was the end. ``meta/sdgen.json`` keeps scenes, households, options and summaries.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Literal

from sdgen.agent.film import lerobot_stats
from sdgen.agent.film.frames import Pixels, seen
from sdgen.agent.film.lerobot_meta import (
    DATA_MB,
    DATA_PATH,
    VIDEO_MB,
    VIDEO_PATH,
    data_schema,
    info,
    place,
    write_meta,
)
from sdgen.agent.film.lerobot_rows import RGB, columns
from sdgen.agent.film.steps import ACTIONS, Film
from sdgen.agent.film.video import Mp4, check_fps
from sdgen.dataset.images import rgb_bytes
from sdgen.dataset.output_folder import check_output_folder, output_folder
from sdgen.dataset.text import plain, pretty
from sdgen.errors import SdgenError

#: Colours as videos (small, not quite exact) or as PNG within the tables (exact).
Pictures = Literal["video", "image"]
TASK = "Look around this home, then report what is dangerous in it to those who live there."
_MB = 1 << 20
#: Every other frame can be read alone: learners read them in any order.
_GAP = 2


def write_lerobot(
    episodes: Iterable[Film],
    out: Path,
    fps: int = 5,
    task: str = TASK,
    pictures: Pictures = "video",
) -> None:
    """Write episodes, one after the other, into a new folder, whole or not at all.

    Raises SdgenError for a place where no folder may be made, and for episodes without a step after
    the first, without colours or of other sizes than the first; ModuleNotFoundError without pyarrow
    or, for videos, PyAV.
    """
    check_output_folder(out)
    check_fps(fps)
    if pictures == "video":
        import av  # noqa: F401  # before anything is written
    rows: list[dict[str, Any]] = []
    about: list[dict[str, Any]] = []
    shape: tuple[int, ...] | None = None
    frames = 0
    with output_folder(out) as folder:
        with ExitStack() as stack:
            data = stack.enter_context(_Tables(folder, pictures == "image"))
            video = stack.enter_context(_Videos(folder, fps)) if pictures == "video" else None
            for number, episode in enumerate(episodes):
                colours = _colours(episode, shape, pictures)
                shape = colours[0].shape
                columns_of = columns(episode, number, frames, fps)
                stats = {RGB: lerobot_stats.of_pictures(colours)}
                stats |= {
                    name: lerobot_stats.of_values(values) for name, values in columns_of.items()
                }
                row: dict[str, Any] = {
                    "episode_index": number,
                    "tasks": [task],
                    "length": len(colours),
                    "dataset_from_index": frames,
                    "dataset_to_index": frames + len(colours),
                }
                row |= data.add(columns_of, colours)
                row |= video.add(colours) if video is not None else {}
                rows.append(row | {"stats": stats})
                about.append(_about(episode))
                frames += len(colours)
        if shape is None:
            raise SdgenError(f"{out}: no episode; there is nothing to write")
        codec = video.codec if video is not None else None
        write_meta(folder, info(len(rows), frames, fps, shape, codec), task, rows)
        told = pretty({"actions": list(ACTIONS), "episodes": about})
        (folder / "meta" / "sdgen.json").write_text(told + "\n", encoding="utf-8")


def _colours(episode: Film, shape: tuple[int, ...] | None, pictures: Pictures) -> list[Pixels]:
    """What is seen before each action."""
    if len(episode.steps) < 2:
        raise SdgenError(f"scene {episode.scene}: nothing was done; there is nothing to learn from")
    colours = seen(episode.steps)[:-1]
    high, wide, _ = size = colours[0].shape
    if shape is not None and size != shape:
        raise SdgenError(f"scene {episode.scene}: {wide}x{high} pixels, others have other sizes")
    if pictures == "video" and (high % 2 or wide % 2):
        raise SdgenError(f"{wide}x{high} pixels: a video needs even numbers (or store images)")
    return colours


def _about(episode: Film) -> dict[str, Any]:
    return {
        "scene": episode.scene,
        "household": plain(episode.household),
        "options": plain(episode.options),
        "summary": plain(episode.summary),
    }


class _Tables:
    """``data/``: the columns of episodes one below the other, a file of them after another."""

    def __init__(self, folder: Path, images: bool) -> None:
        self._folder = folder
        self._images = images
        self._schema = data_schema(images)
        self._number = -1
        self._path = folder
        self._writer: Any = None

    def __enter__(self) -> _Tables:
        return self

    def __exit__(self, *error: object) -> None:
        if self._writer is not None:
            self._writer.close()

    def add(self, of: dict[str, Any], colours: list[Pixels]) -> dict[str, int]:
        """Add an episode; where its rows are."""
        import pyarrow as pa
        import pyarrow.parquet as pq

        if self._writer is None or self._path.stat().st_size >= DATA_MB * _MB:
            if self._writer is not None:
                self._writer.close()
            self._number += 1
            self._path = self._folder / DATA_PATH.format(**place(self._number))
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._writer = pq.ParquetWriter(self._path, self._schema, compression="snappy")
        values = {name: list(column) for name, column in of.items()}
        if self._images:
            values[RGB] = [
                {"bytes": rgb_bytes(rgb, "png"), "path": f"frame-{k:06d}.png"}
                for k, rgb in enumerate(colours)
            ]
        self._writer.write_table(pa.Table.from_pydict(values, schema=self._schema))
        return {f"data/{name}": value for name, value in place(self._number).items()}


class _Videos:
    """``videos/``: episodes one after the other in a video, a video after another."""

    codec = "h264"

    def __init__(self, folder: Path, fps: int) -> None:
        self._folder = folder
        self._fps = fps
        self._number = -1
        self._video: Mp4 | None = None

    def __enter__(self) -> _Videos:
        return self

    def __exit__(self, kind: object, *error: object) -> None:
        if self._video is not None:
            self._video.close(whole=kind is None)

    def add(self, colours: list[Pixels]) -> dict[str, int | float]:
        """Add an episode; which video it is in, and from when to when."""
        if self._video is None or self._video.path.stat().st_size >= VIDEO_MB * _MB:
            if self._video is not None:
                self._video.close()
            self._number += 1
            path = self._folder / VIDEO_PATH.format(video_key=RGB, **place(self._number))
            path.parent.mkdir(parents=True, exist_ok=True)
            self._video = Mp4(path, self._fps, _GAP)
            self.codec = "h264" if self._video.codec == "libx264" else "mpeg4"
        start = self._video.frames
        for rgb in colours:
            self._video.add(rgb)
        span = {"from_timestamp": start / self._fps, "to_timestamp": self._video.frames / self._fps}
        return {f"videos/{RGB}/{name}": v for name, v in (place(self._number) | span).items()}
