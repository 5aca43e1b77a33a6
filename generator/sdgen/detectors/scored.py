"""What a trained detector makes of a scene before it decides: a score a thing."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import numpy.typing as npt

from sdgen.catalog.records import Label
from sdgen.dataset import Dataset, SceneItem

Array = npt.NDArray[np.generic]
Floats = npt.NDArray[np.float64]
#: Thresholds that are tried, at most.
_TRIED = 400


@dataclass(frozen=True)
class Scored:
    """A thing, how sure it is that something is wrong with it, and what that would be."""

    object_id: int
    score: float
    label: Label
    hazard: str


class Scorer(Protocol):
    """What was learned: it scores the things of a scene, and can be kept as arrays and words."""

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Scored, ...]: ...

    def arrays(self) -> dict[str, Array]:
        """All numbers, by name."""

    def words(self) -> dict[str, tuple[str, ...]]:
        """All words, by list."""


@dataclass(frozen=True)
class Hazards:
    """Names of hazards and their labels, in the order of a model's outputs."""

    names: tuple[str, ...]
    labels: tuple[Label, ...]

    def scored(self, ids: Sequence[int], scores: Floats, shares: Floats) -> tuple[Scored, ...]:
        """Of things with these ids and scores (n,): the label with most of the ``shares`` (n,
        hazards), and the hazard of that label with most."""
        out = []
        kinds = sorted(set(self.labels))
        member = np.array([[label == kind for kind in kinds] for label in self.labels])
        for object_id, score, share in zip(ids, scores, shares, strict=True):
            label = kinds[int(np.argmax(share @ member))]
            best = max(
                (k for k, one in enumerate(self.labels) if one == label),
                key=lambda k: (share[k], -k),
            )
            sure = float(min(max(score, 0.0), 1.0))
            out.append(Scored(int(object_id), sure, label, self.names[best]))
        return tuple(out)


def scene_f1(wrong: Collection[int], detected: Collection[int]) -> float | None:
    """F1 of a scene, as ``evaluate`` has it; None where there is nothing and nothing is said."""
    if not wrong and not detected:
        return None
    return 2 * len(set(wrong) & set(detected)) / (len(set(wrong)) + len(set(detected)))


def mean_f1(
    scored: Mapping[str, Sequence[Scored]],
    wrong: Mapping[str, Collection[int]],
    threshold: float,
) -> float:
    """The mean of the F1 of scenes, of what scores at least ``threshold``."""
    values = [
        scene_f1(wrong[scene], [one.object_id for one in found if one.score >= threshold])
        for scene, found in scored.items()
    ]
    kept = [value for value in values if value is not None]
    return sum(kept) / len(kept) if kept else 0.0


def best_threshold(
    scored: Mapping[str, Sequence[Scored]], wrong: Mapping[str, Collection[int]]
) -> float:
    """The threshold with the highest mean F1; of equal ones the middle, which bears most."""
    scores = np.unique([one.score for found in scored.values() for one in found])
    if not len(scores):
        return 0.5
    # Those of things that are wrong and quantiles of all: where F1 turns.
    hits = [one.score for s, found in scored.items() for one in found if one.object_id in wrong[s]]
    tried = np.unique([*_spread(np.array(hits)), *_spread(scores)])
    values = np.array([mean_f1(scored, wrong, float(t)) for t in tried])
    top = np.flatnonzero(values >= values.max() - 1e-12)
    chosen = float(tried[top[len(top) // 2]])
    # Between it and the next lower score: nothing hangs on the last digits of a score.
    lower = scores[scores < chosen]
    return (chosen + float(lower[-1])) / 2 if len(lower) else chosen


def _spread(values: npt.NDArray[np.float64]) -> Iterable[float]:
    """At most half of what is tried, evenly among them."""
    ordered = np.unique(values)
    step = max(1, 2 * len(ordered) // _TRIED)
    return [float(value) for value in ordered[::step]]
