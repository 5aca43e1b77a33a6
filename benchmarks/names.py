"""What names alone tell: how well a classifier that knows only what an object is called, and what
it is on, tells anomalies from the rest, with the near misses and without them.

    python benchmarks/names.py DATASET

Each row is an object of a scene (twins left out). What it is called says how likely it is an
anomaly in other homes; the area under the ROC curve is of the homes held out, mean over folds with
its standard error. 0.5 is chance. "without": the near misses taken out of the negatives, and with
them what makes a milk carton in the fridge as common as one on the table.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
from collections.abc import Callable, Iterable
from pathlib import Path
from statistics import mean, stdev
from typing import NamedTuple

from sdgen import Dataset
from sdgen.seeding import unit_hash
from sklearn.metrics import roc_auc_score

FOLDS = 5
#: A name that was never seen says as much as so many objects of the base rate.
PRIOR = 2.0


class Row(NamedTuple):
    """An object: its home, what it is called, what it is on or in, and what it is."""

    home: str
    name: str
    target: str
    states: str
    anomaly: bool
    lookalike: bool


def rows_of(data: Dataset) -> list[Row]:
    """Every small thing of every scene, and whatever a hazard of the catalogue sets."""
    named = {
        category
        for hazard in data.catalog.hazards
        for recipe in hazard.anomalies
        for category in recipe.categories
    }
    out = []
    for item in data:
        names = {node.id: node.class_name for node in item.scene_graph.nodes}
        targets: dict[int, str] = {}
        for edge in item.scene_graph.edges:
            if edge.relation_type in ("ON", "INSIDE"):
                targets.setdefault(edge.from_id, f"{edge.relation_type} {names[edge.to_id]}")
        wrong = {one.object_id for one in item.anomalies.anomalies}
        near = {one.object_id for one in item.anomalies.lookalikes}
        out += [
            Row(
                item.entry.home,
                thing.category,
                targets.get(thing.id, ""),
                " ".join(thing.states),
                thing.id in wrong,
                thing.id in near,
            )
            for thing in item.scene.objects
            if not thing.fixed or thing.category in named
        ]
    return out


def auc(rows: Iterable[Row], key: Callable[[Row], str]) -> tuple[float, float]:
    """Mean area under the curve over folds of homes, and its standard error."""
    folds: list[list[Row]] = [[] for _ in range(FOLDS)]
    for row in rows:
        folds[int(unit_hash("fold", row.home) * FOLDS)].append(row)
    found = []
    for held in range(FOLDS):
        counts: defaultdict[str, list[int]] = defaultdict(lambda: [0, 0])
        for k, fold in enumerate(folds):
            for row in fold if k != held else ():
                counts[key(row)][row.anomaly] += 1
        total, positive = sum(map(sum, counts.values())), sum(c[1] for c in counts.values())
        base = positive / max(total, 1)
        truth = [row.anomaly for row in folds[held]]
        if len(set(truth)) == 2:
            scores = [
                (counts[key(row)][1] + PRIOR * base) / (sum(counts[key(row)]) + PRIOR)
                for row in folds[held]
            ]
            found.append(float(roc_auc_score(truth, scores)))
    return mean(found), (stdev(found) / len(found) ** 0.5 if len(found) > 1 else float("nan"))


KEYS: dict[str, Callable[[Row], str]] = {
    "name": lambda row: row.name,
    "name and target": lambda row: f"{row.name} {row.target}",
    "name, target and states": lambda row: f"{row.name} {row.target} {row.states}",
}


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("dataset", type=Path)
    rows = rows_of(Dataset(parser.parse_args().dataset))
    named = {row.name for row in rows if row.anomaly}
    sets = {
        "all things": rows,
        "all but near misses": [row for row in rows if not row.lookalike],
        "things of its categories": [row for row in rows if row.name in named],
        "anomalies and near misses": [row for row in rows if row.anomaly or row.lookalike],
    }
    print(f"{len(rows)} things, {sum(row.anomaly for row in rows)} anomalies")
    print(f"{'told from':28}" + "".join(f"{name:>26}" for name in KEYS))
    for title, among in sets.items():
        cells = (auc(among, key) for key in KEYS.values())
        print(f"{title:28}" + "".join(f"{f'{m:.3f} ± {se:.3f}':>26}" for m, se in cells))


if __name__ == "__main__":
    main()
