"""Statistics of an episode as LeRobot keeps them: what learners normalise by.

After ``lerobot/datasets/compute_stats.py`` of LeRobot 0.4 (Apache 2.0), re-implemented.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]
#: Of one feature: ``min``, ``max``, ``mean``, ``std``, ``count`` and quantiles.
Stats = dict[str, Array]

_QUANTILES = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}
#: So many pictures of an episode at most are looked at, evenly spread.
_PICTURES = 100


def of_values(values: Array) -> Stats:
    """Of (N,) or (N, D) values: (1,) or (D,) of each."""
    rows = values.reshape(len(values), -1)
    exact = rows.astype(np.float64)
    stats: Stats = {
        "min": rows.min(axis=0),
        "max": rows.max(axis=0),
        "mean": exact.mean(axis=0),
        "std": exact.std(axis=0),
        "count": np.array([len(rows)]),
    }
    return stats | {name: np.quantile(exact, q, axis=0) for name, q in _QUANTILES.items()}


def of_pictures(pictures: Sequence[npt.NDArray[np.uint8]]) -> Stats:
    """Of (H, W, 3) pictures: (3, 1, 1) of each, colours from 0 to 1."""
    chosen = np.linspace(0, len(pictures) - 1, min(len(pictures), _PICTURES)).round().astype(int)
    counts = np.zeros((3, 256), dtype=np.int64)
    for k in chosen:
        for channel in range(3):
            counts[channel] += np.bincount(pictures[k][..., channel].ravel(), minlength=256)
    shades = np.arange(256) / 255
    total = counts.sum(axis=1)
    mean = counts @ shades / total
    below = counts.cumsum(axis=1)
    stats: Stats = {
        "min": shades[(counts > 0).argmax(axis=1)],
        "max": shades[255 - (counts[:, ::-1] > 0).argmax(axis=1)],
        "mean": mean,
        "std": np.sqrt(np.maximum(counts @ shades**2 / total - mean**2, 0)),
    }
    for name, q in _QUANTILES.items():
        stats[name] = shades[(below >= q * total[:, None]).argmax(axis=1)]
    return {name: value.reshape(3, 1, 1) for name, value in stats.items()} | {
        "count": np.array([len(chosen)])
    }


def together(episodes: Sequence[Mapping[str, Stats]]) -> dict[str, Stats]:
    """Of all episodes, from those of each; quantiles are the episodes' weighted mean."""
    return {name: _pooled([episode[name] for episode in episodes]) for name in episodes[0]}


def _pooled(each: Sequence[Stats]) -> Stats:
    counts = np.array([stats["count"][0] for stats in each])

    def mean(values: Sequence[Array]) -> Array:
        out: Array = np.average(np.stack(values), axis=0, weights=counts)
        return out

    middle = mean([stats["mean"] for stats in each])
    spread = mean([stats["std"] ** 2 + (stats["mean"] - middle) ** 2 for stats in each])
    pooled: Stats = {
        "min": np.min([stats["min"] for stats in each], axis=0),
        "max": np.max([stats["max"] for stats in each], axis=0),
        "mean": middle,
        "std": np.sqrt(spread),
        "count": np.array([counts.sum()]),
    }
    return pooled | {name: mean([stats[name] for stats in each]) for name in _QUANTILES}
