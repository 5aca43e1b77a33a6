"""The records of an episode's folder."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from sdgen.agent.film.steps import PICTURES, Film, Picture, Step
from sdgen.agent.options import AgentOptions
from sdgen.cameras.lens import Gaze
from sdgen.geometry import Vec3
from sdgen.scene import Camera, Household, Record

#: Of an episode's folder.
FILM_VERSION: Literal["1.0"] = "1.0"

Video = Literal["gif", "mp4", "none"]


class FilmRecord(Record):
    """``episode.json``: who walked where, how, and what came of it. ``video`` is its file."""

    format_version: Literal["1.0"] = FILM_VERSION
    scene: str
    household: Household
    options: AgentOptions
    steps: int = Field(ge=1)
    video: str | None
    fps: int
    summary: dict[str, Any]


class StepRecord(Record):
    """A line of ``trajectory.jsonl``: an action, where the agent is and looks after it, and how
    many ``steps`` it has taken by then.

    ``camera`` is a view like those of a data set, with ``K`` and ``world_from_camera``; ``files``
    are the pictures that there are.
    """

    index: int = Field(ge=0)
    action: str
    argument: dict[str, int | float | str]
    position_m: Vec3
    yaw_rad: float
    pitch_rad: float
    room_id: int
    camera: Camera
    refused: str | None
    reward: float
    done: bool
    steps: int
    files: dict[Picture, str]


def picture_file(index: int, picture: Picture) -> str:
    """Where a step's picture lies in the folder."""
    return f"images/{index:06d}-{picture}.png"


def episode_record(episode: Film, video: str | None, fps: int) -> FilmRecord:
    """An episode but for its steps."""
    return FilmRecord(
        scene=episode.scene,
        household=episode.household,
        options=episode.options,
        steps=len(episode.steps),
        video=video,
        fps=fps,
        summary=dict(episode.summary),
    )


def step_record(step: Step) -> StepRecord:
    """A step but for its pixels."""
    return StepRecord(
        index=step.index,
        action=step.action,
        argument=dict(step.argument),
        position_m=(step.gaze.x_m, step.gaze.y_m, 0.0),
        yaw_rad=step.gaze.yaw_rad,
        pitch_rad=step.gaze.pitch_rad,
        room_id=step.room_id,
        camera=step.camera,
        refused=step.refused,
        reward=step.reward,
        done=step.done,
        steps=step.steps,
        files={name: picture_file(step.index, name) for name in PICTURES if name in step.pictures},
    )


def step_of(line: StepRecord, pictures: dict[Picture, Any]) -> Step:
    """The step of a line and its pictures."""
    return Step(
        index=line.index,
        action=line.action,
        argument=line.argument,
        gaze=Gaze(*line.position_m[:2], line.yaw_rad, line.pitch_rad),
        room_id=line.room_id,
        camera=line.camera,
        rgb=pictures.get("rgb"),
        depth_mm=pictures.get("depth"),
        instance=pictures.get("instance"),
        refused=line.refused,
        reward=line.reward,
        done=line.done,
        steps=line.steps,
    )
