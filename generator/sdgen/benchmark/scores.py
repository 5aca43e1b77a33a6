"""Means, standard errors, and intervals by resampling scenes.

A scene is what is drawn: its anomalies share a home, a household and its views, so they are not
independent. Intervals therefore come from drawing whole scenes with replacement (the cluster
bootstrap, Efron and Tibshirani 1993, chapters 8 and 13) and taking percentiles of what is scored.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.scene import Record
from sdgen.seeding import Rng

Floats = npt.NDArray[np.float64]

#: Draws of an interval. The 2.5 % point of 2,000 is known to about a tenth of its spread.
RESAMPLES = 2000
#: Percentiles of an interval of 95 %.
ENDS = (2.5, 97.5)
#: Numbers of draws times scenes that are held at once: 32 MB.
_CELLS = 4_000_000


class Score(Record):
    """A mean, its standard error, over how many values, and the ends of its 95 % interval.

    None where there are too few: of ``mean`` no value, of ``se`` fewer than two, of ``low`` and
    ``high`` values of fewer than two scenes.
    """

    mean: float | None
    se: float | None
    n: int
    low: float | None = None
    high: float | None = None


def score(values: Iterable[float | None]) -> Score:
    """Mean and standard error (sample deviation over root n) of the values that are defined."""
    kept = [value for value in values if value is not None]
    n = len(kept)
    if n == 0:
        return Score(mean=None, se=None, n=0)
    mean = math.fsum(kept) / n
    if n == 1:
        return Score(mean=mean, se=None, n=1)
    variance = math.fsum((value - mean) ** 2 for value in kept) / (n - 1)
    return Score(mean=mean, se=math.sqrt(variance / n), n=n)


@dataclass(frozen=True)
class Column:
    """A score that is a sum over scenes divided by another; ``above`` and ``below`` are (scenes,),
    ``score`` has no interval yet."""

    score: Score
    above: Floats
    below: Floats

    @property
    def spread(self) -> bool:
        """Whether more than one scene has a say."""
        return int(np.count_nonzero(self.below)) > 1


def means(values: Sequence[float | None]) -> Column:
    """The mean over those scenes for which a value is defined."""
    above = np.array([value if value is not None else 0.0 for value in values], dtype=np.float64)
    below = np.array([value is not None for value in values], dtype=np.float64)
    return Column(score(values), above, below)


def shares(scenes: int, found: Sequence[tuple[int, bool]]) -> Column:
    """The share of things that were found; of each its scene's number and whether it was. The
    standard error is that of independent things."""
    above, below = np.zeros(scenes), np.zeros(scenes)
    for scene, yes in found:
        above[scene] += yes
        below[scene] += 1
    return Column(score(float(yes) for _, yes in found), above, below)


def ratio(above: Sequence[float], below: Sequence[float]) -> Column:
    """A sum over scenes divided by another; ``n`` is the latter. The standard error is that of the
    linearised ratio, by scene (Cochran 1977, 6.4)."""
    top, bottom = np.asarray(above, dtype=np.float64), np.asarray(below, dtype=np.float64)
    total = math.fsum(bottom)
    if total <= 0:
        return Column(Score(mean=None, se=None, n=0), top, bottom)
    mean = math.fsum(top) / total
    scenes = int(np.count_nonzero(bottom))
    se = None
    if scenes > 1:
        rest = math.fsum((top - mean * bottom) ** 2)
        se = math.sqrt(scenes / (scenes - 1) * rest) / total
    return Column(Score(mean=mean, se=se, n=round(total)), top, bottom)


def resampled(columns: Floats, rng: Rng, draws: int = RESAMPLES) -> Floats:
    """Sums (draws, columns) over as many scenes as there are, drawn with replacement; ``columns``
    is (scenes, columns)."""
    return np.concatenate([counts @ columns for counts in _drawn(len(columns), rng, draws)])


def _drawn(scenes: int, rng: Rng, draws: int) -> Iterator[Floats]:
    """How often each scene was drawn, (some draws, scenes) at a time."""
    at_once = max(1, min(draws, _CELLS // max(scenes, 1)))
    for start in range(0, draws, at_once):
        some = min(at_once, draws - start)
        picked = rng.integers(0, max(scenes, 1), size=(some, scenes))
        counts = np.empty((some, scenes))
        for k in range(some):
            counts[k] = np.bincount(picked[k], minlength=scenes)
        yield counts


def interval(values: Floats) -> tuple[float | None, float | None]:
    """The ends of the middle 95 % of what was resampled; what is undefined is left out."""
    kept = values[np.isfinite(values)]
    if kept.size == 0:
        return None, None
    low, high = np.percentile(kept, ENDS)
    return float(low), float(high)


def scores_of(
    columns: Mapping[str, Column], rng: Rng, gaps: Mapping[str, tuple[str, str]] | None = None
) -> dict[str, Score]:
    """The scores of columns over the same scenes, with their intervals, from one set of draws.

    ``gaps`` are differences of two of them, first minus second; their standard error is the
    deviation of the draws.
    """
    names = list(columns)
    if not names:
        return {}
    above = np.stack([columns[name].above for name in names], axis=1)
    below = np.stack([columns[name].below for name in names], axis=1)
    sums = resampled(np.concatenate([above, below], axis=1), rng)
    with np.errstate(invalid="ignore", divide="ignore"):
        drawn = sums[:, : len(names)] / sums[:, len(names) :]
    place = {name: k for k, name in enumerate(names)}
    out: dict[str, Score] = {}
    for name, column in columns.items():
        ends = interval(drawn[:, place[name]]) if column.spread else (None, None)
        out[name] = column.score.model_copy(update={"low": ends[0], "high": ends[1]})
    for name, (one, other) in (gaps or {}).items():
        out[name] = _gap(
            columns[one], columns[other], drawn[:, place[one]] - drawn[:, place[other]]
        )
    return out


def _gap(one: Column, other: Column, drawn: Floats) -> Score:
    a, b = one.score.mean, other.score.mean
    n = one.score.n + other.score.n
    if a is None or b is None:
        return Score(mean=None, se=None, n=n)
    if not (one.spread and other.spread):
        return Score(mean=a - b, se=None, n=n)
    return spread_score(a - b, n, drawn)


def spread_score(mean: float | None, n: int, drawn: Floats) -> Score:
    """A number whose standard error and interval are the draws' alone."""
    kept = drawn[np.isfinite(drawn)]
    if mean is None or kept.size < 2:
        return Score(mean=mean, se=None, n=n)
    low, high = interval(kept)
    return Score(mean=mean, se=float(np.std(kept, ddof=1)), n=n, low=low, high=high)
