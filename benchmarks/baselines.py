"""The table of offline baselines: trained on train, threshold from val, scored on test.

    python benchmarks/baselines.py DATASET -o FOLDER [--kinds prior,graph,...] [--graph-view full]

Beside what is trained: rules, never, always and chance. Twins told apart: of anomalies whose object
is harmless in the twin, those that are reported in the scene and not in the twin. Recall of unseen:
of anomalies whose (hazard, category, states, relation, target's category) is not in train.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Mapping
from pathlib import Path

from sdgen.benchmark import DETECTORS, evaluate, write_predictions
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.detectors import Detector, looked_at
from sdgen.detectors.trained import load_trained
from sdgen.detectors.training import KINDS, Lessons, check_needs, train
from sdgen.scene import Anomaly

COLUMNS = ("AS", "CAS", "precision", "F1", "alarms", "near", "twins", "seen", "unseen", "seconds")


def main() -> None:
    """Train, detect, score, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("-o", "--out", type=Path, required=True)
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--simple", default=",".join(DETECTORS))
    parser.add_argument("--graph-view", default="full")
    parser.add_argument("--splits", default="val,test")
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    data = Dataset(args.dataset, graph_view=args.graph_view)
    kinds = tuple(kind for kind in KINDS if kind in args.kinds.split(","))
    check_needs(data, kinds)
    seen = {combination(item, a) for item in data.filter(split="train") for a in wrong(item)}
    lessons = Lessons(data, args.seed)
    found: dict[str, Detector] = {n: DETECTORS[n] for n in DETECTORS if n in args.simple.split(",")}
    took: dict[str, float] = {}
    for kind in kinds:
        if not (args.out / kind).exists():
            start = time.monotonic()
            model = train(lessons, kind, args.out / kind)
            took[kind] = time.monotonic() - start
            print(f"{kind}: {took[kind]:.0f} s, F1 on val {model.val.f1}", flush=True)
        found[kind] = load_trained(args.out / kind)
    rows: dict[str, dict[str, float | None]] = {}
    for split in args.splits.split(","):
        part = data.filter(split=split)
        for name, reports in detected(part, found).items():
            write_predictions(args.out / f"{name}-{split}.jsonl", reports)
            rows[f"{name} {split}"] = {**scores(part, reports, seen), "seconds": took.get(name)}
    (args.out / "scores.json").write_text(json.dumps(rows, indent=1))
    print("\n" + " ".join([f"{'':20}", *(f"{column:>9}" for column in COLUMNS)]))
    for name, values in rows.items():
        print(row(name, values))


def detected(
    data: Dataset, detectors: Mapping[str, Detector]
) -> dict[str, dict[str, tuple[Report, ...]]]:
    """What each says of every scene and twin; each scene is read once for all of them."""
    out: dict[str, dict[str, tuple[Report, ...]]] = {name: {} for name in detectors}
    for item in data:
        for one in looked_at(item, twins=True):
            for name, detector in detectors.items():
                out[name][one.id] = detector(data, one)
    return out


def row(name: str, values: Mapping[str, float | None]) -> str:
    """A line of the table."""
    cells = (values[column] for column in COLUMNS)
    return " ".join([f"{name:20}", *(f"{'-':>9}" if c is None else f"{c:9.3f}" for c in cells)])


def wrong(item: SceneItem) -> tuple[Anomaly, ...]:
    """The anomalies of a scene."""
    return item.anomalies.anomalies


def combination(item: SceneItem, anomaly: Anomaly) -> tuple[object, ...]:
    """In what way an anomaly is one."""
    categories = {thing.id: thing.category for thing in item.scene.objects}
    categories |= {structure.id: structure.category for structure in item.scene.home.structures}
    target = None if anomaly.target_id is None else categories.get(anomaly.target_id)
    return anomaly.hazard, anomaly.category, anomaly.states, anomaly.relation, target


def scores(
    data: Dataset, reports: Mapping[str, tuple[Report, ...]], seen: set[tuple[object, ...]]
) -> dict[str, float | None]:
    """The columns of a detector."""
    ids = {item.id for item in data}
    found = evaluate(data, {key: said for key, said in reports.items() if key in ids})
    near, apart = [], []
    recalled: dict[bool, list[bool]] = {True: [], False: []}
    for item in data:
        said = {report.object_id for report in reports[item.id]}
        near.append(sum(one.object_id in said for one in item.anomalies.lookalikes))
        for anomaly in wrong(item):
            recalled[combination(item, anomaly) in seen].append(anomaly.object_id in said)
        twin = item.twin
        if twin is None:
            continue
        there = {thing.id for thing in twin.scene.objects}
        still = {a.object_id for a in wrong(twin)}
        told = {report.object_id for report in reports[twin.id]}
        for k in sorted({a.object_id for a in wrong(item)} & there - still):
            apart.append(k in said and k not in told)
    return {
        "AS": found.AS.mean,
        "CAS": found.CAS.mean,
        "precision": found.precision.mean,
        "F1": found.f1.mean,
        "alarms": found.false_alarms_per_scene.mean,
        "near": mean(near),
        "twins": mean(apart),
        "seen": mean(recalled[True]),
        "unseen": mean(recalled[False]),
        "n_pairs": len(apart),
        "n_unseen": len(recalled[False]),
    }


def mean(values: list[bool] | list[int]) -> float | None:
    """The mean, None of nothing."""
    return sum(values) / len(values) if values else None


if __name__ == "__main__":
    main()
