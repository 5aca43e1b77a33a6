"""What became of every scene, for one or several detectors: the truth is read once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from sdgen.benchmark.outcome import Outcome, outcome
from sdgen.benchmark.predictions import read_predictions
from sdgen.benchmark.truth import Truth, Ways, truths, ways_of
from sdgen.dataset import Dataset
from sdgen.dataset.records import Predictions


@dataclass(frozen=True)
class Collected:
    """What became of the scenes of ``data``, by detector; ``ways`` is what train shows."""

    data: Dataset
    ways: Ways
    outcomes: Mapping[str, tuple[Outcome, ...]]


def opened(data: Dataset | str | Path) -> Dataset:
    """A data set, or the one in this folder. Raises InputError, also for a catalogue that is not
    the one of its labels."""
    if isinstance(data, str | Path):
        data = Dataset(data)
    _ = data.catalog
    return data


def predicted(data: Dataset, predictions: Predictions | str | Path) -> Predictions:
    """Predictions, or those in this file, for a data set. Raises InputError."""
    if isinstance(predictions, str | Path):
        return read_predictions(predictions, data)
    return predictions


def collect(data: Dataset, detectors: Mapping[str, Predictions]) -> Collected:
    """What became of every scene with each detector. Raises InputError for a broken data set."""
    known: list[Truth] = []
    outcomes: dict[str, list[Outcome]] = {name: [] for name in detectors}
    scenes = frozenset().union(*detectors.values())
    for truth in truths(data, scenes):
        for name, predictions in detectors.items():
            outcomes[name].append(outcome(truth, predictions))
        # The nodes are most of a scene, and rows have taken what they need of them.
        known.append(replace(truth, things={}, lookalikes={}, twin=None))
    ways = ways_of(data, known)
    return Collected(data, ways, {name: tuple(found) for name, found in outcomes.items()})
