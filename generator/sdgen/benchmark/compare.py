"""Two detectors on the same scenes: what differs, how surely, scene by scene."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from sdgen.benchmark.collect import Collected, collect, opened, predicted
from sdgen.benchmark.outcome import SceneScores
from sdgen.benchmark.scores import means, scores_of
from sdgen.dataset import Dataset
from sdgen.dataset.records import Predictions
from sdgen.errors import UsageError
from sdgen.scene import Record
from sdgen.seeding import Rng, lane

#: Signs are drawn so often: p is at least 1 / (FLIPS + 1).
FLIPS = 10_000
#: Signs held at once.
_CELLS = 4_000_000

#: The scores that are compared, by scene.
COMPARED: Mapping[str, Callable[[SceneScores], float | None]] = {
    "AS": lambda s: s.as_,
    "CAS": lambda s: s.cas,
    "unwanted_per_scene": lambda s: s.unwanted,
    "false_alarms_per_scene": lambda s: s.false_alarms,
    "precision": lambda s: s.precision,
    "f1": lambda s: s.f1,
    "label_accuracy": lambda s: s.label_accuracy,
}


class Difference(Record):
    """The mean difference over the ``n`` scenes that have both scores, its standard error and 95 %
    interval, and how probable one as large would be, either way, were the detectors alike."""

    mean: float | None
    se: float | None
    n: int
    low: float | None = None
    high: float | None = None
    p: float | None = None


class Comparison(Record):
    """``detector`` minus ``baseline``, by score."""

    baseline: str
    detector: str
    differences: dict[str, Difference]


def compare(
    data: Dataset | str | Path, detectors: Mapping[str, Predictions | str | Path]
) -> tuple[Comparison, ...]:
    """Each further detector against the first, by name. Raises UsageError for fewer than two,
    InputError as ``evaluate``."""
    if len(detectors) < 2:
        raise UsageError("a comparison needs the predictions of two detectors, or of more")
    data = opened(data)
    return comparisons(collect(data, {k: predicted(data, p) for k, p in detectors.items()}))


def comparisons(found: Collected) -> tuple[Comparison, ...]:
    """Each further detector against the first; none where there is but one."""
    first, *others = found.outcomes
    seed = found.data.info.seed
    out = []
    for other in others:
        pairs = list(zip(found.outcomes[first], found.outcomes[other], strict=True))
        values: dict[str, list[float | None]] = {}
        for name, of in COMPARED.items():
            sides = [(of(one.scores), of(two.scores)) for one, two in pairs]
            values[name] = [b - a if a is not None and b is not None else None for a, b in sides]
        scores = scores_of(
            {name: means(some) for name, some in values.items()}, lane(seed, 0, "evaluate:scenes")
        )
        differences = {
            name: Difference(
                **scores[name].model_dump(),
                p=sign_flip_p(
                    [v for v in values[name] if v is not None], lane(seed, 0, "evaluate:signs")
                ),
            )
            for name in COMPARED
        }
        out.append(Comparison(baseline=first, detector=other, differences=differences))
    return tuple(out)


def sign_flip_p(differences: Sequence[float], rng: Rng) -> float | None:
    """Two-sided p of a paired permutation test: how often the sum of the differences is as far from
    zero when each keeps or turns its sign by a coin. Were the detectors alike, either sign would be
    as probable (Fisher 1935, section 21; the observed one counts as a draw, Phipson and Smyth
    2010). None without a difference to look at."""
    values = np.asarray(differences, dtype=np.float64)
    if values.size == 0:
        return None
    moved = values[values != 0]  # the others have no sign
    observed = abs(math.fsum(moved))
    # Sums are rounded: what is as far in truth must not fall short by the last bit.
    least = observed - 1e-9 * max(1.0, observed)
    at_once = max(1, min(FLIPS, _CELLS // max(moved.size, 1)))
    as_far = 0
    for start in range(0, FLIPS, at_once):
        signs = rng.integers(0, 2, size=(min(at_once, FLIPS - start), moved.size)) * 2.0 - 1.0
        as_far += int(np.count_nonzero(np.abs(signs @ moved) >= least))
    return (1 + as_far) / (1 + FLIPS)
