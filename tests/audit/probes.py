"""What gives labels away: boosted trees, tried on homes that they were not trained on.

An AUC is taken over pairs within a stratum, so that what is the same for both cannot tell:

- *all*: every pair;
- *same kind*: an anomaly and others of its category (a lookalike: of its class or its category);
- *visible*: of the same kind, and both visible, as every anomaly is by promise;
- *free*: these, in the same band of 0.3 m of height too, told without what the definitions are
  made of (height of classes by reach, distance to walls and doorways of tripping).

Standard errors are a bootstrap over homes. ``planted`` is the AUC of the same trees on the same
rows with one column more, the label with as much noise as signal: that a leak would be found.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.model_selection import GroupKFold
from threadpoolctl import threadpool_limits

from tests.audit.dataset import Floats, Scene
from tests.audit.features import (
    SHAPE,
    Rows,
    picture_rows,
    placement_rows,
    record_rows,
    scene_tables,
)

Bools = npt.NDArray[np.bool_]
Strings = npt.NDArray[np.str_]

FOLDS, BOOTSTRAPS = 5, 100
#: Fewer than this say nothing.
LEAST = 20
#: Trees learn nothing of whole homes from fewer than these.
HOMES_NEEDED = 100
#: What the numbers are asked to be as sure as.
WANTED_ERROR = 0.02


@dataclass(frozen=True)
class Result:
    """An AUC, how sure it is, on how many, and what a planted cue would have made of it."""

    name: str
    auc: float
    error: float
    positive: int
    negative: int
    planted: float

    def __str__(self) -> str:
        sure = "" if self.error <= WANTED_ERROR else f"  (wanted: {WANTED_ERROR})"
        return (
            f"{self.name:58} {self.auc:.3f} ± {self.error:.3f}  "
            f"{self.positive:5}:{self.negative:<6} planted {self.planted:.2f}{sure}"
        )


def binned(features: Floats) -> Floats:
    """Each column in at most 60 steps of equally many rows; unknown stays unknown."""
    steps = np.array(features, float)
    for column in steps.T:
        known = ~np.isnan(column)
        if known.any():
            borders = np.unique(np.quantile(column[known], np.linspace(0, 1, 60)))
            column[known] = np.searchsorted(borders, column[known])
        else:
            column[:] = 0
    return steps


def scores(
    features: Floats, positive: Bools, stratum: Strings, home: Strings
) -> tuple[Floats, Strings]:
    """How much each row looks like a positive one to trees trained on other homes.

    A model's level differs from fold to fold, so strata are told apart by fold, too: the second
    array names both.
    """
    weight = np.ones(len(positive))
    for name in np.unique(stratum):
        here = stratum == name
        yes, no = int((here & positive).sum()), int((here & ~positive).sum())
        if yes and no:
            weight[here & positive] = no / (yes + no)
            weight[here & ~positive] = yes / (yes + no)
        else:
            weight[here] = 0.0
    told = np.zeros(len(positive))
    pairs = stratum.astype("U80")
    folds = GroupKFold(min(FOLDS, len(np.unique(home)))).split(features, None, home)
    for number, (train, test) in enumerate(folds):
        pairs[test] = np.char.add(stratum[test], f" {number}")
        if len(np.unique(positive[train][weight[train] > 0])) < 2:
            continue
        trees = HistGradientBoostingClassifier(
            max_iter=60, max_depth=4, min_samples_leaf=10, max_bins=63, random_state=0
        )
        used = train[weight[train] > 0]
        with threadpool_limits(1):  # small data: threads would only wait for each other
            trees.fit(features[used], positive[used], weight[used])
            told[test] = trees.predict_proba(features[test])[:, 1]
    return told, pairs


def stratified_auc(told: Floats, positive: Bools, stratum: Strings, times: Floats) -> float:
    """The AUC over pairs of one stratum; ``times`` says how often each row counts."""
    total = weight = 0.0
    for name in np.unique(stratum):
        here = (stratum == name) & (times > 0)
        yes, no = here & positive, here & ~positive
        if not yes.any() or not no.any():
            continue
        order = np.argsort(told[here], kind="stable")
        value, up, down = (
            told[here][order],
            *((times * flag)[here][order] for flag in (positive, ~positive)),
        )
        # Equal scores count half: negatives below, and half of those level with it.
        _, first, same = np.unique(value, return_index=True, return_inverse=True)
        level = np.add.reduceat(down, first)
        below = np.cumsum(level) - level
        won = float((up * (below + level / 2)[same]).sum())
        n_up, n_down = float(up.sum()), float(down.sum())
        share = n_up * n_down / (n_up + n_down)
        total += share * won / (n_up * n_down)
        weight += share
    return total / weight if weight else float("nan")


def measure(
    name: str, features: Floats, positive: Bools, stratum: Strings, home: Strings
) -> Result | None:
    """The AUC with its error; nothing where no stratum has both."""
    telling = [n for n in np.unique(stratum) if len(np.unique(positive[stratum == n])) == 2]
    keep = np.isin(stratum, telling)
    features, positive, stratum, home = features[keep], positive[keep], stratum[keep], home[keep]
    if positive.sum() < LEAST or len(np.unique(home)) < 3:
        return None
    features = binned(features)
    told, pairs = scores(features, positive, stratum, home)
    auc = stratified_auc(told, positive, pairs, np.ones(len(told)))
    rng = np.random.default_rng(0)
    homes, index = np.unique(home, return_inverse=True)
    drawn = []
    for _ in range(BOOTSTRAPS):
        times = np.bincount(rng.integers(len(homes), size=len(homes)), minlength=len(homes))
        drawn.append(stratified_auc(told, positive, pairs, times[index].astype(float)))
    cue = positive + rng.normal(size=len(positive))
    planted, _ = scores(np.column_stack([features, binned(cue[:, None])]), positive, stratum, home)
    return Result(
        name,
        auc,
        float(np.nanstd(drawn)),
        int(positive.sum()),
        int((~positive).sum()),
        stratified_auc(planted, positive, pairs, np.ones(len(told))),
    )


def compared(rows: Rows, title: str, yes: str, no: set[str], kind: str) -> list[Result]:
    """One comparison at the three levels, and by class at the second."""
    label = rows.column("kind")
    seen = rows.column("seen").astype(bool)
    wanted = np.isin(label, [yes, *no])
    of_kind = rows.column(kind).astype(str)
    bands = np.array([f"{k} {b}" for k, b in zip(of_kind, rows.column("band"), strict=True)])
    everything = np.array(["all"] * len(label))
    if kind == "category":  # only categories that can be one
        wanted &= np.isin(of_kind, np.unique(of_kind[label == yes]))
    levels = [
        ("all", everything, wanted, rows.features),
        ("same kind", of_kind, wanted, rows.features),
        ("visible", of_kind, wanted & seen, rows.features),
        ("free", bands, wanted & seen, rows.free(kind)),
    ]
    results = []
    for level, stratum, rows_used, features in levels:
        pick = np.flatnonzero(rows_used)
        result = measure(
            f"{title}: {level}",
            features[pick],
            (label == yes)[pick],
            stratum[pick],
            rows.column("home").astype(str)[pick],
        )
        if result:
            results.append(result)
    return results


def by_class(rows: Rows, title: str) -> list[Result]:
    """Anomalies against lookalikes of each class, where the definition leaves it free."""
    label, hazard = rows.column("kind"), rows.column("hazard").astype(str)
    free = rows.free("hazard")
    results = []
    for name in sorted(set(hazard) - {""}):
        pick = np.flatnonzero(
            (hazard == name)
            & np.isin(label, ["anomaly", "lookalike"])
            & rows.column("seen").astype(bool)
        )
        result = measure(
            f"  {title}: {name}",
            free[pick],
            (label == "anomaly")[pick],
            rows.column("band").astype(str)[pick],
            rows.column("home").astype(str)[pick],
        )
        if result:
            results.append(result)
    return results


def all_probes(scenes: list[Scene]) -> list[Result]:
    """Every probe on a data set's scenes."""
    results = []
    pictures, places, records = picture_rows(scenes), placement_rows(scenes), record_rows(scenes)
    shapeless = pictures.without(SHAPE)
    titles = ((pictures, "picture"), (shapeless, "picture, not shape"), (places, "placement"))
    for rows, title in titles:
        against = f"{title}, anomalies v lookalikes"
        results += compared(rows, against, "anomaly", {"lookalike"}, "hazard")
        results += by_class(rows, against)
        against = f"{title}, anomalies v all of their categories"
        results += compared(rows, against, "anomaly", {"lookalike", "clutter"}, "category")
    results += compared(
        places, "placement, lookalikes v clutter", "lookalike", {"clutter"}, "category"
    )
    results += compared(
        records,
        "ids and digits, anomalies v others",
        "anomaly",
        {"lookalike", "clutter"},
        "category",
    )[:2]
    if len(scenes) < HOMES_NEEDED:
        return results
    tables, hazards, home = scene_tables(scenes)
    for name, features in tables.items():
        for what, positive in (("three hazards or more", hazards >= 3), ("none", hazards == 0)):
            stratum = np.array(["all"] * len(scenes))
            result = measure(f"scene, {name}: {what}", features, positive, stratum, home)
            if result:
                results.append(result)
    return results


def report(scenes: list[Scene]) -> str:
    """All probes as a table."""
    lines = [str(result) for result in all_probes(scenes)]
    return "\n".join([f"AUC ± standard error on {len(scenes)} scenes, by homes", *lines])
