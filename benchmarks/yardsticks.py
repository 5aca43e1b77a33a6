"""Whether the yardsticks score what theory says, on a data set as large as one likes.

    python benchmarks/yardsticks.py DATASET [--json FILE]

``rules`` must find every anomaly, tell exactly what the household wants to hear and raise no false
alarm. ``never`` finds nothing. ``always`` finds all, alarms for every harmless object, and has a
CAS that follows from what is unwanted. ``chance`` finds half of the anomalies and alarms for half
of the rest, tells half of that, and guesses one label of three: each of its means is held against
its expectation, in standard errors. Ends with 1 when one of them is off.
"""

from __future__ import annotations

import json
import math
import sys
import time
from pathlib import Path

import numpy as np
from sdgen import Dataset
from sdgen.benchmark import detect, evaluate
from sdgen.detectors import things

#: Standard errors that a mean of chance may lie from its expectation: 1 of 15,000 lies further.
_FAR = 4.0


def main(path: Path, out: Path | None) -> int:
    """Measure, print and judge."""
    data = Dataset(path)
    facts = [_facts(item) for item in data]
    wrong, wanted, harmless = (np.array(column, dtype=float) for column in zip(*facts, strict=True))
    some, told = wrong > 0, wanted > 0
    unwanted = wrong - wanted
    cas = (wanted - unwanted)[told] / wanted[told]
    # Detector, score -> what it should be; chance finds half, and tells half of what it finds.
    expected = {
        ("rules", "AS"): 1.0,
        ("rules", "CAS"): 1.0,
        ("rules", "false_alarms_per_scene"): 0.0,
        ("rules", "unwanted_per_scene"): 0.0,
        ("rules", "label_accuracy"): 1.0,
        ("never", "AS"): 0.0,
        ("never", "CAS"): 0.0,
        ("never", "false_alarms_per_scene"): 0.0,
        ("always", "AS"): 1.0,
        ("always", "CAS"): float(cas.mean()),
        ("always", "false_alarms_per_scene"): float(harmless.mean()),
        ("always", "unwanted_per_scene"): float(unwanted.mean()),
        ("chance", "AS"): 0.5,
        ("chance", "CAS"): float(cas.mean()) / 4,
        ("chance", "false_alarms_per_scene"): float(harmless.mean()) / 2,
        ("chance", "unwanted_per_scene"): float(unwanted.mean()) / 4,
        ("chance", "label_accuracy"): 1 / 3,
    }
    print(f"{len(data)} scenes, {some.sum()} with anomalies, {told.sum()} with one to report")
    rows, bad = [], 0
    for name in ("rules", "never", "always", "chance"):
        began = time.monotonic()
        found = evaluate(data, detect(data, name))
        print(f"{name}: {time.monotonic() - began:.1f} s")
        for (who, score), right in expected.items():
            if who != name:
                continue
            mean, error = _value(found, score, harmless)
            off = abs(mean - right)
            fine = off <= _FAR * error if name == "chance" else off < 1e-9
            bad += not fine
            print(f"  {score:24} {mean:9.4f}  expected {right:9.4f}  {'' if fine else 'OFF'}")
            rows.append({"detector": name, "score": score, "mean": mean, "expected": right})
    if out is not None:
        out.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    return 1 if bad else 0


def _facts(item: object) -> tuple[int, int, int]:
    """Anomalies, those of them to be reported, and harmless things, as objects."""
    anomalies = item.anomalies.anomalies  # type: ignore[attr-defined]
    wrong = {a.object_id for a in anomalies}
    wanted = {a.object_id for a in anomalies if a.report}
    shown = {node.id for node in things(item.scene_graph)}  # type: ignore[attr-defined]
    return len(wrong), len(wanted), len(shown - wrong)


def _value(found: object, score: str, harmless: np.ndarray) -> tuple[float, float]:
    """A score's mean and its standard error; of false alarms that of coins, since how many things
    homes have varies far more."""
    value = getattr(found, score)
    if score == "false_alarms_per_scene":
        return value.mean, math.sqrt(harmless.sum() / 4) / len(harmless)
    return value.mean, value.se or 0.0


if __name__ == "__main__":
    words = sys.argv[1:]
    where = Path(words[words.index("--json") + 1]) if "--json" in words else None
    sys.exit(main(Path(words[0]), where))
