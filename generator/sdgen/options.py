"""What a build was asked for. Content options decide labels; render options only pictures."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sdgen.scene import Record

Sensor = Literal["rgb", "depth", "instance"]


class BuildOptions(Record):
    """Options of ``sdgen build`` that a data set remembers."""

    n: int = Field(default=10, ge=0)
    seed: int = Field(default=0, ge=0)
    homes: Literal["base", "procedural", "mixed"] = "mixed"
    hazards_min: int = Field(default=0, ge=0)
    hazards_max: int = Field(default=5, ge=0)
    draw: Literal["balanced", "iid"] = "balanced"
    extensions: tuple[str, ...] = ()
    views: int = Field(default=8, ge=0)
    width: int = Field(default=640, ge=16, le=4096)
    height: int = Field(default=480, ge=16, le=4096)
    sensors: tuple[Sensor, ...] = ("rgb", "depth", "instance")
    rgb: Literal["png", "jpg"] = "png"
    supersample: Literal[1, 2] = 1
    #: ``auto`` or a name in ``sdgen.render.RENDERERS``, which ``choose_renderer`` checks.
    renderer: str = "auto"
    eye_height_m: float = Field(default=1.2, gt=0.1, le=2.2)
    twins: bool = False
