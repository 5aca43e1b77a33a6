"""The draw: how many anomalies each scene has, and of which classes.

It comes first, knows neither home nor household, and survives every retry. ``balanced`` deals
from a seeded permutation over blocks of scenes: in each whole block every number of anomalies
and every class comes equally often. ``iid`` draws each scene alone, as the paper did.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sdgen.errors import UsageError
from sdgen.seeding import lane

#: Numbers of blocks start above those of scenes, so that no block shares a lane with a scene.
_BLOCK_LANE = 1 << 32


def check_range(low: int, high: int, classes: int) -> None:
    """UsageError when ``low``-``high`` anomalies cannot be drawn from so many classes."""
    if low > high:
        raise UsageError(f"--hazards {low}-{high}: the first number is larger than the second")
    if high > classes:
        raise UsageError(
            f"--hazards {low}-{high}: a scene shows each class once and {classes} are enabled; "
            f"ask for {min(low, classes)}-{classes} at most"
        )


def draw(
    seed: int, index: int, hazards: Sequence[str], low: int, high: int, mode: str
) -> tuple[str, ...]:
    """Hazard ids of scene ``index``, sorted. ``low``-``high`` anomalies, each class at most once.

    Raises UsageError when the range cannot be drawn from the classes.
    """
    names = sorted(hazards)
    check_range(low, high, len(names))
    if mode == "iid":
        rng = lane(seed, index, "draw")
        count = int(rng.integers(low, high + 1))
        chosen = rng.permutation(len(names))[:count]
        return tuple(sorted(names[k] for k in chosen.tolist()))
    size = block_size(len(names), low, high)
    block, offset = divmod(index, size)
    dealt = _deal(seed, block, size, len(names), low, high)
    return tuple(sorted(names[k] for k in dealt[offset]))


def block_size(classes: int, low: int, high: int) -> int:
    """Scenes after which counts and classes are exactly even."""
    return max(1, (high - low + 1) * classes)


def _deal(seed: int, block: int, size: int, classes: int, low: int, high: int) -> list[list[int]]:
    """Classes of every scene of a block: counts permuted, then classes by largest remainder."""
    rng = lane(seed, _BLOCK_LANE + block, "draw")
    values = [low + k % (high - low + 1) for k in range(size)]
    counts = [values[k] for k in rng.permutation(size).tolist()]
    left = np.full(classes, sum(counts) // max(classes, 1), dtype=np.int64)
    out: list[list[int]] = [[] for _ in range(size)]
    # The fullest scenes first: this greedy deal always comes out even (Gale-Ryser).
    for scene in sorted(range(size), key=lambda k: (-counts[k], k)):
        tie = rng.random(classes)
        order = np.lexsort((tie, -left))
        out[scene] = order[: counts[scene]].tolist()
        left[out[scene]] -= 1
    return out
