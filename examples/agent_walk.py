"""An agent that trains nothing: it looks into every room and reports by rules of thumb.

    python examples/agent_walk.py homes

It knows no ids beforehand: what is before it, it has from the masks of its own pictures, and of the
things there from a recogniser that names them (here the scene's own names; plug yours in).
"""

from __future__ import annotations

import sys

import numpy as np
from sdgen.agent.env import HomeEnv, action
from sdgen.agent.options import AgentOptions
from sdgen.cameras.lens import Lens

#: As many pixels of a thing as make it worth a word.
SEEN = 20


def suspected(name: str) -> str | None:
    """What would be wrong with a thing of this name, wherever it is; None: nothing."""
    if "puddle" in name:
        return "unsafe"
    if name in ("milk_carton", "raw_meat", "yogurt_cup", "cheese"):
        return "unsanitary"
    if name in ("knife", "scissors", "pizza_cutter", "screwdriver", "bleach_bottle", "pill_bottle"):
        return "unsafe for children"
    return None


def explore(env: HomeEnv, home: int) -> dict[str, object]:
    """One home: its scores."""
    _, told = env.reset(seed=0, options={"home": home})
    children = any(member["age"] < 8 for member in told["household"]["members"])
    names = {item.id: item.category for item in env.episode.stage.scene.objects}
    said: set[int] = set()
    over = False
    for room in told["rooms"]:
        for move in (action("go_to", room), action("scan"), action("look_down"), action("scan")):
            if over:
                break
            _, _, done, cut, info = env.step(move)
            over = done or cut
            for picture in info.get("scan", ()):
                ids, counts = np.unique(picture["instance"], return_counts=True)
                for key in ids[counts >= SEEN].tolist():
                    label = suspected(names.get(key, ""))
                    if label is None or key in said or over:
                        continue
                    notify = "now" if children or "children" not in label else "silent"
                    said.add(key)
                    _, _, done, cut, info = env.step(action("report", key, label, notify))
                    over = done or cut
        if not over:
            env.step(action("look_up"))
    if not over:
        info = env.step(action("stop"))[-1]
    return info["score"]


def main(dataset: str) -> None:
    """Explore every home of a data set."""
    camera = Lens(width=160, height=120)
    env = HomeEnv.of_dataset(dataset, AgentOptions(camera=camera, max_steps=600))
    for home in range(env.homes):
        score = explore(env, home)
        print(
            f"{score['scene']}: AS {score['AS']}, {score['false_alarms']:.0f} false alarms, "
            f"{score['path_m']:.1f} m, {score['coverage']:.0%} seen"
        )
    env.close()


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: agent_walk.py DATASET")
    main(sys.argv[1])
