"""What a detector would mean to households most of which have no hazard.

A data set is full of hazards so that there is something to learn and to find. Homes are not. Here
its scenes are weighted: those with a hazard stand together for ``hazard_share`` of homes, those
without one (hazard-free scenes, and benign twins that a detector looked at) for the others.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from sdgen.benchmark.collect import Collected, collect, opened, predicted
from sdgen.benchmark.costs import Costs
from sdgen.benchmark.outcome import Outcome, wanted_notify
from sdgen.benchmark.scores import Floats, Score, resampled, spread_score
from sdgen.benchmark.truth import Wrong
from sdgen.dataset import Dataset
from sdgen.dataset.records import Predictions, Report
from sdgen.errors import UsageError
from sdgen.scene import Record
from sdgen.seeding import lane

#: Shares of the hazards that are to be found, for which false alarms are told.
RECALLS = (0.5, 0.8, 0.9, 0.95)
#: A look a second.
MOST_INSPECTIONS = 86_400
#: Points of an operating curve that are kept.
POINTS = 200


class NoHomes(UsageError):
    """There is no home with a hazard, or none without one, that a detector looked at."""


class OperatingPoint(Record):
    """A detector that says only what it is at least so sure of (``threshold``; None: nothing)."""

    threshold: float | None
    recall: float
    false_alarms_per_home_day: float
    unwanted_per_home_day: float
    precision: float | None
    cost_per_home_day: float


class BaseRates(Record):
    """A detector where ``hazard_share`` of homes have a hazard, and each is looked at
    ``inspections_a_day`` times. A home-day is one home on one day.

    ``recall``, ``precision``, ``false_alarms_per_home_day`` and ``unwanted_per_home_day`` are those
    of all that it said; ``at_recall`` are the fewest false alarms a home-day with which it finds
    so much (no mean: it never does); ``cost_per_home_day`` has ``detector``, ``best_threshold``
    (the cheapest one, chosen on these very scenes), ``never`` and ``oracle``.
    """

    hazard_share: float
    inspections_a_day: float
    homes_with_hazards: int
    clean_homes: int
    scored: bool
    recall: Score
    precision: Score
    false_alarms_per_home_day: Score
    unwanted_per_home_day: Score
    at_recall: dict[str, Score]
    cost_per_home_day: dict[str, Score]
    best_threshold: float | None
    curve: tuple[OperatingPoint, ...]
    costs: Costs


def base_rates(
    data: Dataset | str | Path,
    predictions: Predictions | str | Path,
    hazard_share: float = 0.05,
    inspections_a_day: float = 1.0,
    costs: Costs | None = None,
) -> BaseRates:
    """Predictions (or their file) at a base rate. Raises UsageError where the numbers make no
    sense, NoHomes where there is no home of one of the two kinds, InputError as ``evaluate``."""
    data = opened(data)
    found = collect(data, {"": predicted(data, predictions)})
    return rates_of(found, "", hazard_share, inspections_a_day, costs)


class _Said(NamedTuple):
    """One report: of which family of homes, whether of a clean one, how sure, whether it is of an
    anomaly, whether it is unwanted, and what it adds to the cost of having said nothing."""

    family: int
    clean: bool
    score: float
    hit: bool
    unwanted: bool
    cost: float


@dataclass(frozen=True)
class _Homes:
    """Sums by family, a scene and its twin: (families, 4): homes with hazards, clean homes,
    anomalous objects, cost of silence; and what was said."""

    sums: Floats
    said: tuple[_Said, ...]
    scored: bool


def rates_of(
    found: Collected,
    name: str,
    hazard_share: float = 0.05,
    inspections_a_day: float = 1.0,
    costs: Costs | None = None,
) -> BaseRates:
    """The base rates of one of several detectors; see ``base_rates``."""
    if not 0 < hazard_share < 1:
        raise UsageError(f"a share of homes lies between 0 and 1, not at {hazard_share:g}")
    if not 0 < inspections_a_day <= MOST_INSPECTIONS:
        raise UsageError(
            f"{inspections_a_day:g} inspections a day: more than 0, and {MOST_INSPECTIONS} at most"
        )
    costs = costs or Costs()
    homes = _homes(found.outcomes[name], costs)
    bad, clean = (int(value) for value in homes.sums[:, :2].sum(axis=0))
    if not bad or not clean:
        lacking = "with a hazard" if clean else "without a hazard"
        raise NoHomes(
            f"base rates need homes with and without hazards: none here is {lacking}"
            + (
                ""
                if clean
                else " (build with --twins, and say with detect --twins what is in them)"
            )
        )
    setting = _Setting(hazard_share, inspections_a_day, homes)
    return setting.rates(lane(found.data.info.seed, 0, "evaluate:homes"), costs)


def _homes(outcomes: Sequence[Outcome], costs: Costs) -> _Homes:
    sums = np.zeros((len(outcomes), 4))
    said: list[_Said] = []
    scored = False
    for k, one in enumerate(outcomes):
        twins = [one.twin] if one.twin is not None and one.twin.hazard_free else []
        for home in (one, *twins):
            clean = home.hazard_free
            sums[k, int(clean)] += 1
            for wrongs, report in _objects(home):
                wanted = wanted_notify(wrongs) if wrongs else None
                silence = costs.of(wanted, None)
                sums[k, 2] += bool(wrongs)
                sums[k, 3] += silence
                if report is None:
                    continue
                scored |= report.score is not None
                unwanted = wanted == "silent" and report.notify != "silent"
                cost = costs.of(wanted, report.notify) - silence
                sure = 1.0 if report.score is None else report.score
                said.append(_Said(k, clean, sure, bool(wrongs), unwanted, cost))
    return _Homes(sums, tuple(said), scored)


def _objects(home: Outcome) -> Iterator[tuple[list[Wrong], Report | None]]:
    """The objects of a home that are wrong or were reported: their anomalies, what was said."""
    rows: dict[int, tuple[list[Wrong], Report | None]] = {}
    for item in home.items:
        wrongs, _ = rows.setdefault(item.object_id, ([], item.said))
        if item.wrong is not None:
            wrongs.append(item.wrong)
    yield from rows.values()


#: Columns of what was said, after those of ``_Homes``: hits, false alarms where there is a hazard
#: and where there is none, unwanted, and the cost added there and there.
_SAID_COLUMNS = 6


class _Setting:
    """Homes at a base rate, with and without a threshold."""

    def __init__(self, share: float, days: float, homes: _Homes) -> None:
        self.share, self.days, self.homes = share, days, homes
        said = homes.said
        self.sure = np.array([one.score for one in said])
        self.family = np.array([one.family for one in said], dtype=np.int64)
        rows = [
            (
                one.hit,
                not one.hit and not one.clean,
                not one.hit and one.clean,
                one.unwanted,
                0.0 if one.clean else one.cost,
                one.cost if one.clean else 0.0,
            )
            for one in said
        ]
        self.columns = np.array(rows, dtype=np.float64).reshape(-1, _SAID_COLUMNS)

    def at(self, sums: Floats) -> dict[str, Floats]:
        """Recall and the rest, (n,), from sums (n, 4 + 6)."""
        bad, clean, objects, silence, hits, near, far, unwanted, cost, cost_clean = sums.T
        share, days = self.share, self.days
        with np.errstate(invalid="ignore", divide="ignore"):
            false = days * (share * near / bad + (1 - share) * far / clean)
            true = days * share * hits / bad
            return {
                "recall": hits / objects,
                "false": false,
                "unwanted": days * share * unwanted / bad,
                "precision": true / (true + false),
                "cost": days * (share * (silence + cost) / bad + (1 - share) * cost_clean / clean),
            }

    def by_threshold(self) -> tuple[Floats, dict[str, Floats]]:
        """Thresholds, the highest first, and what each gives; before them infinity: silence."""
        order = np.argsort(-self.sure, kind="stable")
        sure = self.sure[order]
        sums = np.vstack([np.zeros(_SAID_COLUMNS), np.cumsum(self.columns[order], axis=0)])
        ends = np.flatnonzero(np.append(np.diff(sure) != 0, True)) + 1 if sure.size else sure
        picked = np.concatenate([[0], ends]).astype(np.int64)
        every = np.broadcast_to(self.homes.sums.sum(axis=0), (len(picked), 4))
        cuts = np.append(np.inf, sure[picked[1:] - 1])
        return cuts, self.at(np.hstack([every, sums[picked]]))

    def by_family(self, cut: float) -> Floats:
        """Sums (families, 4 + 6) of what is said at a threshold."""
        kept = self.sure >= cut
        said = np.zeros((len(self.homes.sums), _SAID_COLUMNS))
        np.add.at(said, self.family[kept], self.columns[kept])
        return np.hstack([self.homes.sums, said])

    def rates(self, rng: np.random.Generator, costs: Costs) -> BaseRates:
        """All of it, with intervals."""
        cuts, told = self.by_threshold()
        last, best = len(cuts) - 1, int(np.argmin(told["cost"]))
        reached = {
            level: int(np.argmax(told["recall"] >= level))
            for level in RECALLS
            if told["recall"][-1] >= level
        }
        wanted = [last, best, 0, *reached.values()]
        stacked = np.hstack([self.by_family(cuts[k]) for k in wanted])
        width = 4 + _SAID_COLUMNS
        drawn = resampled(stacked, rng)
        draws = [self.at(drawn[:, k * width : (k + 1) * width]) for k in range(len(wanted))]
        bad, clean, objects, _ = self.homes.sums.sum(axis=0)
        homes = round(bad + clean)
        # One home of a kind is all there is of it, however often it is drawn.
        spread = bool((np.count_nonzero(self.homes.sums[:, :2], axis=0) > 1).all())

        def score(which: int, key: str, n: int = homes) -> Score:
            value = float(told[key][wanted[which]])
            mean = value if math.isfinite(value) else None
            if not spread:
                return Score(mean=mean, se=None, n=n)
            return spread_score(mean, n, draws[which][key])

        nothing = Score(mean=None, se=None, n=homes)
        places = {level: 3 + k for k, level in enumerate(reached)}
        return BaseRates(
            hazard_share=self.share,
            inspections_a_day=self.days,
            homes_with_hazards=round(bad),
            clean_homes=round(clean),
            scored=self.homes.scored,
            recall=score(0, "recall", round(objects)),
            precision=score(0, "precision", len(self.sure)),
            false_alarms_per_home_day=score(0, "false"),
            unwanted_per_home_day=score(0, "unwanted"),
            at_recall={
                f"{level:g}": score(places[level], "false") if level in places else nothing
                for level in RECALLS
            },
            cost_per_home_day={
                "detector": score(0, "cost"),
                "best_threshold": score(1, "cost"),
                "never": score(2, "cost"),
                # Who tells all as it is wanted, and nothing else, costs nothing by any table.
                "oracle": Score(mean=0.0, se=0.0, n=homes, low=0.0, high=0.0),
            },
            best_threshold=_number(cuts[best]),
            curve=tuple(_point(cuts[k], told, k) for k in _kept(last, {best, *reached.values()})),
            costs=costs,
        )


def _kept(last: int, always: set[int]) -> list[int]:
    """Places of the points that are kept, evenly by rank, and those that are named elsewhere."""
    even = np.linspace(0, last, min(last + 1, POINTS)).round().astype(int).tolist()
    return sorted({*even, *always})


def _point(cut: float, told: dict[str, Floats], k: int) -> OperatingPoint:
    return OperatingPoint(
        threshold=_number(cut),
        recall=float(told["recall"][k]),
        false_alarms_per_home_day=float(told["false"][k]),
        unwanted_per_home_day=float(told["unwanted"][k]),
        precision=_number(told["precision"][k]),
        cost_per_home_day=float(told["cost"][k]),
    )


def _number(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
