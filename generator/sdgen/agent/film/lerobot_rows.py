"""An episode as the frames of a LeRobot data set: what is seen, and what is done then."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

from sdgen.agent.film.steps import ACTIONS, Film, Step
from sdgen.errors import SdgenError

RGB = "observation.images.rgb"
STATE = ("x_m", "y_m", "yaw_rad", "pitch_rad")
#: ``action`` is a number of ``ACTIONS``, ``object_id`` is 0 where it is about none.
ACTION = ("forward_m", "turn_rad", "look_rad", "action", "object_id")

#: Feature -> its type and length, in the order of the columns.
FEATURES: dict[str, tuple[str, int, Sequence[str] | None]] = {
    "observation.state": ("float32", len(STATE), STATE),
    "action": ("float32", len(ACTION), ACTION),
    "next.reward": ("float32", 1, None),
    "next.done": ("bool", 1, None),
    "timestamp": ("float32", 1, None),
    "frame_index": ("int64", 1, None),
    "episode_index": ("int64", 1, None),
    "index": ("int64", 1, None),
    "task_index": ("int64", 1, None),
}


def columns(episode: Film, number: int, first: int, fps: int) -> dict[str, npt.NDArray[Any]]:
    """The columns of an episode, (N,) or (N, D): a frame for every step but the last, with what is
    done next and what comes of it. ``first`` is the data set's number of its first frame."""
    steps = episode.steps
    count = len(steps) - 1
    frames = np.arange(count)
    return {
        "observation.state": np.array([_state(step) for step in steps[:-1]], dtype=np.float32),
        "action": np.array([_action(*pair) for pair in pairwise(steps)], dtype=np.float32),
        "next.reward": np.array([step.reward for step in steps[1:]], dtype=np.float32),
        "next.done": np.array([step.done for step in steps[1:]], dtype=np.bool_),
        "timestamp": (frames / fps).astype(np.float32),
        "frame_index": frames,
        "episode_index": np.full(count, number),
        "index": first + frames,
        "task_index": np.zeros(count, dtype=np.int64),
    }


def _state(step: Step) -> list[float]:
    return [step.gaze.x_m, step.gaze.y_m, step.gaze.yaw_rad, step.gaze.pitch_rad]


def _action(before: Step, after: Step) -> list[float]:
    """What was asked for where the action says so, else what changed."""
    yaw = before.gaze.yaw_rad
    dx, dy = after.gaze.x_m - before.gaze.x_m, after.gaze.y_m - before.gaze.y_m
    moved = {
        "forward_m": dx * math.cos(yaw) + dy * math.sin(yaw),
        "turn_rad": math.remainder(after.gaze.yaw_rad - yaw, math.tau),
        "look_rad": after.gaze.pitch_rad - before.gaze.pitch_rad,
        "object_id": 0,
    }
    asked = {name: after.argument.get(name, value) for name, value in moved.items()}
    if after.action not in ACTIONS:
        raise SdgenError(f"{after.action!r}: no action; they are {', '.join(ACTIONS)}")
    asked["action"] = ACTIONS.index(after.action)
    return [float(asked[name]) for name in ACTION]
