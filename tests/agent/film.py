"""A short walk to store: a picture of stripes that move, every value different."""

from __future__ import annotations

from typing import Any

import numpy as np
from sdgen.agent.film.steps import Film, Step
from sdgen.agent.options import AgentOptions
from sdgen.cameras.lens import Gaze, Lens, camera_at

from tests import toy

_DONE = (
    ("start", {}),
    ("forward", {"forward_m": 0.25}),
    ("turn_left", {"turn_rad": -0.5}),
    ("look_up", {"look_rad": 0.25}),
    ("go_to", {"room": "kitchen"}),
    ("open", {"object_id": 305}),
)


def episode(
    steps: int = 8, width: int = 64, height: int = 48, scene: str = "000003", rgb: bool = True
) -> Film:
    """An episode that forgets nothing: refused, rewarded, done at the end."""
    lens = Lens(width=width, height=height)
    return Film(
        scene=scene,
        household=toy.household(),
        options=AgentOptions(camera=lens),
        steps=tuple(_step(k, steps, lens, rgb) for k in range(steps)),
        summary={"found": [600], "path_m": 1.5, "recall": {"sharp_object": 0.5}, "note": None},
    )


def _step(k: int, steps: int, lens: Lens, rgb: bool) -> Step:
    action, argument = _DONE[k % len(_DONE)] if k < steps - 1 else ("stop", {})
    gaze = Gaze(1.0 + 0.25 * k, 2.0 - 0.125 * k, -3.0 + 0.7 * k, 0.1 * k)
    rows, columns = np.mgrid[: lens.height, : lens.width]
    pictures: dict[str, Any] = {
        "depth_mm": (1000 * k + 7 * rows + columns).astype(np.uint16),
        "instance": (60_000 + (rows + k) % 5).astype(np.uint16),
    }
    if rgb:
        shades = [rows * 4 + 9 * k, columns * 3 + 5 * k, rows + columns + k]
        pictures["rgb"] = (np.stack(shades, axis=-1) // 2 % 256).astype(np.uint8)
    return Step(
        index=k,
        action=action,
        argument=dict(argument),
        gaze=gaze,
        room_id=100 + k % 2,
        camera=camera_at(gaze, 100 + k % 2, lens),
        refused="a chair is in the way" if k == 1 else None,
        reward=0.5 * k,
        done=k == steps - 1,
        steps=k,
        **pictures,
    )
