"""Films an episode while it goes on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sdgen.agent.episode import Episode, Result
from sdgen.agent.eyes import Look
from sdgen.agent.film.steps import Film, Step
from sdgen.cameras.lens import Gaze


class Recorder:
    """Keeps what an agent does and sees, from the ``start`` of its episode on.

    A scan is a step a heading; what gave no picture (a refusal, the end) keeps the one before.
    """

    def __init__(self, episode: Episode, look: Look) -> None:
        self._episode = episode
        self._steps: list[Step] = []
        self._add("start", {}, look, look.gaze)

    def add(self, result: Result) -> None:
        """What came of a move."""
        last = self._steps[-1]
        looks = result.looks or (None,)
        first = self._episode.steps - len(looks) + 1 if result.move == "scan" else 0
        for k, look in enumerate(looks):
            steps = first + k if result.move == "scan" else self._episode.steps
            end = k == len(looks) - 1
            told = (result.refused, result.reward) if end else (None, 0.0)
            gaze = self._episode.gaze if look is None else look.gaze
            over = self._episode.over and end
            self._add(result.move, result.argument, look, gaze, *told, over, steps, last)

    def _add(
        self,
        action: str,
        argument: Mapping[str, int | float | str],
        look: Look | None,
        gaze: Gaze,
        refused: str | None = None,
        reward: float = 0.0,
        done: bool = False,
        steps: int = 0,
        last: Step | None = None,
    ) -> None:
        sensors = self._episode.options.sensors
        pictures: dict[str, Any] = {}
        if look is not None:
            pictures = {"rgb": look.rgb, "depth_mm": look.depth_mm, "instance": look.instance}
            camera = look.camera
        else:
            assert last is not None  # the first step is a look
            pictures = {"rgb": last.rgb, "depth_mm": last.depth_mm, "instance": last.instance}
            camera = last.camera
        names = {"rgb": "rgb", "depth_mm": "depth", "instance": "instance"}
        kept = {key: value for key, value in pictures.items() if names[key] in sensors}
        self._steps.append(
            Step(
                index=len(self._steps),
                action=action,
                argument=dict(argument),
                gaze=gaze,
                room_id=camera.room_id,
                camera=camera,
                refused=refused,
                reward=reward,
                done=done,
                steps=steps,
                **kept,
            )
        )

    def film(self, summary: Mapping[str, Any] | None = None) -> Film:
        """All that was filmed so far."""
        stage = self._episode.stage
        options = self._episode.options
        return Film(stage.id, stage.household, options, tuple(self._steps), summary or {})
