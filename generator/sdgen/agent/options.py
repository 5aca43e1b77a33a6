"""What an agent is: its camera, its steps, and how long it may take."""

from __future__ import annotations

import math
from typing import Literal

from pydantic import Field

from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import Record

#: What a camera of an agent draws.
Sensor = Literal["rgb", "depth", "instance"]


class AgentCamera(Record):
    """The agent's camera: pixels, horizontal field of view, height of the lens above the floor, and
    the pitch it begins with (radians, up is positive)."""

    width: int = Field(default=128, ge=8, le=2048)
    height: int = Field(default=128, ge=8, le=2048)
    fov_x_deg: float = Field(default=90.0, ge=10.0, le=150.0)
    height_m: float = Field(default=EYE_HEIGHT_M, ge=0.1, le=2.2)
    pitch_deg: float = Field(default=0.0, ge=-80.0, le=80.0)

    @property
    def pitch_rad(self) -> float:
        """The pitch it begins with."""
        return math.radians(self.pitch_deg)


class AgentOptions(Record):
    """How an agent moves and what an episode is.

    ``forward_m`` and ``turn_deg`` are those of a step, ``look_deg`` that of the camera's pitch, at
    most ``pitch_most_deg`` up or down. ``start``: at the scene's ``agent_start`` or at a random
    pose of its free space. An episode is cut off after ``max_steps``.
    """

    camera: AgentCamera = AgentCamera()
    sensors: tuple[Sensor, ...] = ("rgb", "depth", "instance")
    forward_m: float = Field(default=0.25, gt=0.0, le=2.0)
    turn_deg: float = Field(default=30.0, gt=0.0, le=180.0)
    look_deg: float = Field(default=30.0, gt=0.0, le=90.0)
    pitch_most_deg: float = Field(default=60.0, ge=0.0, le=85.0)
    start: Literal["scene", "random"] = "scene"
    max_steps: int = Field(default=500, ge=1, le=1_000_000)
