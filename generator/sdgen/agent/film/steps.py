"""What an agent did and saw, step by step."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from sdgen.agent.moves import MOVES
from sdgen.agent.options import AgentOptions
from sdgen.cameras.lens import Gaze
from sdgen.scene import Camera, Household

#: What a step can be, in the order of its numbers in data sets to learn from.
ACTIONS = ("start", *MOVES)

#: A picture of a step; what there is of it is what the agent's ``sensors`` ask for.
Picture = Literal["rgb", "depth", "instance"]
PICTURES: tuple[Picture, ...] = ("rgb", "depth", "instance")


@dataclass(frozen=True, eq=False)
class Step:
    """An action, and where the agent is and what it sees after it; the first step is ``start``.

    ``argument`` is what the action was given. Data sets to learn from look there for ``forward_m``,
    ``turn_rad`` and ``look_rad`` (else they take what really changed) and for ``object_id``.
    ``refused`` says why nothing happened, ``steps`` how many steps the agent has taken by then.
    ``rgb`` is (H, W, 3) uint8, ``depth_mm`` and ``instance`` are (H, W) uint16. Raises ValueError
    for pictures that are not the camera's.
    """

    index: int
    action: str
    argument: Mapping[str, int | float | str]
    gaze: Gaze
    room_id: int
    camera: Camera
    rgb: npt.NDArray[np.uint8] | None = None
    depth_mm: npt.NDArray[np.uint16] | None = None
    instance: npt.NDArray[np.uint16] | None = None
    refused: str | None = None
    reward: float = 0.0
    done: bool = False
    steps: int = 0

    def __post_init__(self) -> None:
        size = (self.camera.height, self.camera.width)
        for name, values in self.pictures.items():
            shape, kind = ((*size, 3), "uint8") if name == "rgb" else (size, "uint16")
            if values.shape != shape or values.dtype != kind:
                raise ValueError(
                    f"step {self.index}: {name} is {values.shape} of {values.dtype}, "
                    f"not {shape} of {kind}"
                )

    @property
    def pictures(self) -> dict[Picture, npt.NDArray[Any]]:
        """The pictures that there are."""
        all_of_them = zip(PICTURES, (self.rgb, self.depth_mm, self.instance), strict=True)
        return {name: values for name, values in all_of_them if values is not None}

    @property
    def caption(self) -> str:
        """``12 turn_left 30 deg``: steps taken and what was done, on one line."""
        words = [str(self.steps), self.action]
        words += [_shown(name, value) for name, value in self.argument.items()]
        return " ".join(words) + (f": {self.refused}" if self.refused else "")


@dataclass(frozen=True, eq=False)
class Film:
    """An agent's steps in one scene, from ``start`` on; ``summary`` is JSON: numbers, texts,
    lists and mappings of them."""

    scene: str
    household: Household
    options: AgentOptions
    steps: tuple[Step, ...]
    summary: Mapping[str, Any] = field(default_factory=dict)


def _shown(name: str, value: float | str) -> str:
    if name.endswith("_rad") and not isinstance(value, str):
        return f"{math.degrees(value):.0f} deg"
    return f"{value:.3g}" if isinstance(value, float) else str(value)
