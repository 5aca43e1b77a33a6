"""What an agent is: its camera, its steps, and how long it may take."""

from __future__ import annotations

import math
from typing import Literal

from pydantic import Field, model_validator

from sdgen.cameras.lens import Lens
from sdgen.scene import Record

#: What a camera of an agent shows it.
Sensor = Literal["rgb", "depth", "instance"]


class AgentOptions(Record):
    """How an agent looks and moves, and what an episode is.

    ``forward_m`` and ``turn_deg`` are those of a step, ``look_deg`` that of the camera's pitch, at
    most ``pitch_most_deg`` up or down; it begins with ``pitch_deg``. What is opened or shut must be
    within ``reach_m`` of where it stands. ``start``: at the scene's ``agent_start`` or at a random
    pose of its free space. An episode is cut off after ``max_steps``. ``whole_home`` draws all of
    the home for each picture; else only the rooms that can be seen from where the agent stands are
    drawn: the same masks and depth, in less time.
    """

    camera: Lens = Lens()
    sensors: tuple[Sensor, ...] = ("rgb", "depth", "instance")
    forward_m: float = Field(default=0.25, gt=0.0, le=2.0)
    turn_deg: float = Field(default=30.0, gt=0.0, le=180.0)
    look_deg: float = Field(default=30.0, gt=0.0, le=90.0)
    pitch_deg: float = Field(default=0.0, ge=-80.0, le=80.0)
    pitch_most_deg: float = Field(default=60.0, ge=0.0, le=85.0)
    reach_m: float = Field(default=1.0, gt=0.0, le=3.0)
    start: Literal["scene", "random"] = "scene"
    max_steps: int = Field(default=500, ge=1, le=1_000_000)
    whole_home: bool = False

    @model_validator(mode="after")
    def _within_neck(self) -> AgentOptions:
        if abs(self.pitch_deg) > self.pitch_most_deg:
            raise ValueError(f"pitch_deg is beyond the {self.pitch_most_deg:g} of pitch_most_deg")
        return self

    @property
    def turn_rad(self) -> float:
        """The turn of a step."""
        return math.radians(self.turn_deg)

    @property
    def headings(self) -> int:
        """Turns in a full circle, the last of them perhaps smaller."""
        return math.ceil(360.0 / self.turn_deg - 1e-9)
