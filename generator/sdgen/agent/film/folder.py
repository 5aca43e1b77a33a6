"""An episode as a folder of pictures, poses and a video, written and read.

``episode.json`` says who walked where and what came of it, ``trajectory.jsonl`` has a line a step,
``images/`` its pictures (depth and masks of 16 bits), ``video.gif`` or ``video.mp4`` shows it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sdgen.agent.film.records import (
    FilmRecord,
    StepRecord,
    Video,
    episode_record,
    picture_file,
    step_of,
    step_record,
)
from sdgen.agent.film.steps import Film, Picture
from sdgen.agent.film.video import check_fps, gif_bytes, write_mp4
from sdgen.dataset.disk import sync_file, write_synced
from sdgen.dataset.images import gray_bytes, gray_of, rgb_bytes, rgb_of
from sdgen.dataset.output_folder import check_output_folder, output_folder
from sdgen.dataset.text import line_bytes, read_bytes, read_lines, read_record, record_bytes
from sdgen.errors import InputError, SdgenError

EPISODE, TRAJECTORY = "episode.json", "trajectory.jsonl"


def write_folder(
    episode: Film, out: Path, video: Video = "gif", fps: int = 5, captions: bool = True
) -> None:
    """Write an episode into a new folder, whole or not at all: the same bytes for the same episode
    and versions of what packs pictures.

    Raises SdgenError for a place where no folder may be made, for an episode without steps, and
    for a video of an agent that sees no colours; ModuleNotFoundError for an MP4 without PyAV
    (pip install sdgen[video]).
    """
    check_output_folder(out)
    check_fps(fps)
    if not episode.steps:
        raise SdgenError(f"{out}: an episode without steps; there is nothing to write")
    if [step.index for step in episode.steps] != list(range(len(episode.steps))):
        raise ValueError("steps are numbered from 0 on")
    name = None if video == "none" else f"video.{video}"
    with output_folder(out) as folder:
        if video == "gif":
            write_synced(folder / "video.gif", gif_bytes(episode.steps, fps, captions))
        elif video == "mp4":
            write_mp4(episode.steps, folder / "video.mp4", fps, captions)
            sync_file(folder / "video.mp4")
        (folder / "images").mkdir()
        lines = []
        for step in episode.steps:
            lines.append(line_bytes(step_record(step)))
            for picture, values in step.pictures.items():
                data = rgb_bytes(values, "png") if picture == "rgb" else gray_bytes(values)
                (folder / picture_file(step.index, picture)).write_bytes(data)
        write_synced(folder / TRAJECTORY, b"".join(lines))
        write_synced(folder / EPISODE, record_bytes(episode_record(episode, name, fps)))


def read_folder(path: Path) -> Film:
    """An episode of its folder, pictures and all. Raises InputError for files that are missing,
    broken or of another episode."""
    about = read_record(FilmRecord, path / EPISODE, f"{path}/{EPISODE}")
    where = f"{path}/{TRAJECTORY}"
    lines = read_lines(StepRecord, path / TRAJECTORY, where)
    if [line.index for line in lines] != list(range(about.steps)):
        raise InputError([f"{where}: not the {about.steps} steps that {EPISODE} tells of"])
    steps = tuple(step_of(line, _pictures(path, line, where)) for line in lines)
    return Film(about.scene, about.household, about.options, steps, about.summary)


def _pictures(path: Path, line: StepRecord, where: str) -> dict[Picture, Any]:
    out: dict[Picture, Any] = {}
    size = (line.camera.width, line.camera.height)
    for picture, name in line.files.items():
        due = picture_file(line.index, picture)
        if name != due:
            raise InputError([f"{where}: step {line.index}: files: {picture}: is not {due}"])
        place = f"{path}/{name}"
        data = read_bytes(path / name, place)
        rgb = picture == "rgb"
        out[picture] = rgb_of(data, size, place) if rgb else gray_of(data, size, 16, place)
    return out
